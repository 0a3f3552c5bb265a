"""A shot along one of its variables: where its result changes first."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.variables import STATE, check_names
from hoopgen.hoop.arguments import arguments_of
from hoopgen.hoop.releases import states_of
from hoopgen.hoop.search_range import search_range
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.simulate import simulate

Floats = NDArray[np.float64]

TRIALS = 2_000
"""Values of the first look to each side of the shot, closer together near it."""

_ROUNDS = 4
_SPLIT = 8
_MAX_SPLIT = 2_000
"""Rounds in which gaps between neighbouring values with different contacts are split, the parts of
a gap, and the most gaps of a round: those nearest to the shot."""

_SECTIONS = 64
"""Parts into which a gap across which the result changes is divided, again and again."""

_RESULTS = ["outcome", "contacts", "counts", "first", "uncertain"]


def variables_of_shot(vary: Iterable[str] | None, scene: Engine) -> tuple[str, ...]:
    """Return the names of variables along which a shot may be changed, checked.

    Parameters
    ----------
    vary
        Names: arguments of `hoopgen.release` where there is a hoop, elsewhere components of the
        state; and parameters of the scene. None: speed, elevation and azimuth, or the velocity.
    scene
        The scene.

    Raises
    ------
    TypeError
        If they are one text.
    ValueError
        If one is unknown, or there is none.
    """
    release = tuple(ARGUMENTS) if scene.has_hoop else STATE
    if vary is None:
        return ("speed", "elevation", "azimuth") if scene.has_hoop else STATE[3:6]
    names = check_names("vary", vary, (*release, *scene.parameters))
    if not names:
        raise ValueError("vary: expected at least one name")
    return tuple(dict.fromkeys(names))


@dataclass(frozen=True)
class OneShot:
    """One shot, and what becomes of it if one of its variables is another.

    Attributes
    ----------
    scene
        The scene.
    state
        The release, (9,).
    parameters
        Of the scene, one number each.
    end
        The end that counts, its number.
    max_contacts
        As for `hoopgen.simulate`.
    """

    scene: Engine
    state: Floats
    parameters: Mapping[str, float]
    end: int
    max_contacts: int | None = None

    def value(self, name: str) -> float:
        """Return the value of a variable of this shot, SI."""
        if name in self.parameters:
            return float(self.parameters[name])
        if not self.scene.has_hoop:
            return float(self.state[STATE.index(name)])
        return float(arguments_of(self.state)[name])

    def search_range(self, name: str) -> tuple[float, float]:
        """Return the range of a variable in which changes are looked for."""
        scale = 0.0
        if name in STATE and not self.scene.has_hoop:
            part = STATE.index(name) // 3 * 3
            scale = float(np.linalg.norm(self.state[part : part + 3])) or 1.0
        value = self.value(name)
        if name in self.parameters and not value:  # then its size is that of what is allowed
            limits = self.scene.table.limits.get(name, (0.0, 1.0))
            scale = (
                max((abs(limit) for limit in limits if math.isfinite(limit)), default=0.0) or 1.0
            )
            low, high = search_range(name, value, scale)
            return max(low, limits[0]), min(high, limits[1])
        return search_range(name, value, scale)

    def with_values(self, name: str, values: Floats) -> tuple[Floats, dict[str, float | Floats]]:
        """Return states (n, 9) and parameters with other values of a variable, (n,).

        Parameters
        ----------
        name
            The name of a variable of the release, or of a parameter of the scene.
        values
            Its values, (n,), SI and rad.
        """
        states = np.tile(self.state, (len(values), 1))
        parameters: dict[str, float | Floats] = dict(self.parameters)
        if name in self.parameters:
            parameters[name] = values
        elif not self.scene.has_hoop:
            states[:, STATE.index(name)] = values
        else:
            own = {argument: np.asarray(v) for argument, v in arguments_of(self.state).items()}
            states = states_of(own | {name: values})
            states[:, 6:8] += self._spin_along(own["azimuth"] + own["angle"], states)
            states[values == float(own[name])] = self.state
        return states, parameters

    def _spin_along(self, heading: Floats, states: Floats) -> Floats:
        """Return the part of the spin about the flight's direction on the floor plan, turned."""
        along = self.state[6] * np.cos(heading) + self.state[7] * np.sin(heading)
        level = np.hypot(states[:, 3], states[:, 4])
        with np.errstate(invalid="ignore"):
            unit = np.where(level[:, None] > 0.0, -states[:, 3:5] / level[:, None], 0.0)
        return np.asarray(along * unit)

    def results(self, name: str, values: Floats) -> tuple[NDArray[np.bool_], NDArray[np.int64]]:
        """Return, for values of a variable, which succeed, and the contacts of each.

        Parameters
        ----------
        name, values
            As for `OneShot.with_values`.

        Returns
        -------
        tuple
            Whether the outcome is the end that counts, (n,); and the outcome, the number of
            contacts, the first body and the contacts by body, (n, 3 + k): -1 in all columns where
            the shot is invalid or a decision of it uncertain.
        """
        states, parameters = self.with_values(name, values)
        shots = simulate(
            states,
            parameters,
            scene=self.scene,
            max_contacts=self.max_contacts,
            fields=_RESULTS,
        )
        columns = (shots.outcome, shots.contacts, shots.first, *shots.counts.T)
        found = np.stack([column.astype(np.int64) for column in columns], axis=1)
        found[shots.uncertain | (shots.outcome == self.scene.outcomes["INVALID"])] = -1
        return np.asarray(shots.outcome == self.end), found

    def proved(self, name: str, values: Floats) -> NDArray[np.int64]:
        """Return the outcomes that the judge proves for values of a variable, -1 where none.

        Parameters
        ----------
        name, values
            As for `OneShot.with_values`.

        Raises
        ------
        ImportError
            If SymPy or python-flint is missing.
        """
        from hoopgen.judge import UNDECIDED, certify

        states, parameters = self.with_values(name, values)
        proof = certify(
            states, parameters, scene=self.scene, max_contacts=self.max_contacts, processes=1
        )
        return np.where(proof.outcome == UNDECIDED, -1, proof.outcome.astype(np.int64))

    def nearest_change(
        self, name: str, succeeds: bool, side: int, steady: float
    ) -> tuple[float, float] | None:
        """Return the nearest change of the result on one side, as far as values were tried.

        Parameters
        ----------
        name
            The variable.
        succeeds
            Whether the shot itself succeeds.
        side
            1 for larger values, -1 for smaller ones.
        steady
            How much further the values that were tried have the other result, as a share of the
            change.

        Returns
        -------
        tuple or None
            The last value with the result of the shot, and the first with the other one, next to
            each other as far as doubles decide; None if there are none in the range.
        """
        value = self.value(name)
        low, high = self.search_range(name)
        reach = (high if side > 0 else low) - value
        if not reach or not math.isfinite(reach):
            return None
        near = np.geomspace(1e-9, 1.0, TRIALS // 4)
        away = np.union1d(near, np.linspace(0.0, 1.0, TRIALS * 3 // 4))
        values = self._refine(name, value + reach * away)
        tried, changed = self._decided(name, succeeds, values)
        for start, stop in _runs(changed):
            if abs(tried[stop - 1] - tried[start]) >= steady * abs(tried[start] - value):
                return self._narrow(name, succeeds, (float(tried[start - 1]), float(tried[start])))
        return None

    def _narrow(self, name: str, succeeds: bool, gap: tuple[float, float]) -> tuple[float, float]:
        """Return the last change of the result within a gap, between values next to each other."""
        while True:
            values, changed = self._decided(name, succeeds, np.linspace(*gap, _SECTIONS + 1))
            last = np.flatnonzero(~changed)[-1]
            if last + 1 == len(values):  # the end of the gap is uncertain beside its neighbours
                return gap
            closer = float(values[last]), float(values[last + 1])
            if abs(closer[1] - closer[0]) >= abs(gap[1] - gap[0]):
                return gap
            gap = closer

    def _refine(self, name: str, values: Floats) -> Floats:
        """Return more values, between those whose contacts differ; in order from the shot."""
        for _ in range(_ROUNDS):
            _, found = self.results(name, values)
            differ = np.flatnonzero((found[1:] != found[:-1]).any(axis=1))[:_MAX_SPLIT]
            step = values[differ + 1] - values[differ]
            parts = np.arange(1, _SPLIT)[:, None] / _SPLIT
            between = (values[differ] + step * parts).ravel()
            ordered = np.unique(np.concatenate([values, between]))
            values = ordered if values[-1] >= values[0] else ordered[::-1]
        return values

    def _decided(
        self, name: str, succeeds: bool, values: Floats
    ) -> tuple[Floats, NDArray[np.bool_]]:
        """Return the values whose results are certain, and whether each is another.

        The first value, that of the shot itself or one beside a change, has the shot's result.
        """
        made, found = self.results(name, values)
        certain = found[:, 0] >= 0
        certain[0] = True
        changed = made != succeeds
        changed[0] = False
        return values[certain], changed[certain]


def _runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return start and end of each run of true values."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))
