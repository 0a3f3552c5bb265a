"""Observed ends of measured shots, and the simulated shots that end in the same way.

A shot is made or not. A table may also say the impacts before the end, the body that was touched
first, and of a miss where it came down. Places of rebounds are told apart by direction, in the six
`SECTORS` around the ring as the shooter sees them, and by distance from the ring's centre.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import inf
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import check_names
from hoopgen.engine.elementary import hypotenuse
from hoopgen.simulation.simulate import simulate
from hoopgen.study.measures.measure_context import Block
from hoopgen.study.measures.rebounds import SECTORS, direction_from, rebound, sector
from hoopgen.study.models.random import POSTERIOR, normals
from hoopgen.text.shorten import brief, join_names

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

OUTCOMES = ("made", "contacts", "first", "rebound_x", "rebound_y")
"""Names of what a table may say of the end of a shot."""

_CONTACTS = 3
"""So many contacts, and more, are told apart no further."""

_EDGES = (1.0, 2.0)
"""Distances of rebounds from the ring's centre, m, between which they are told apart no further."""

_NONE, _UNKNOWN = -1, -2

_STREAM = POSTERIOR + 3_000


@dataclass(frozen=True)
class Outcomes:
    """The observed ends of shots.

    Attributes
    ----------
    made
        (n,).
    contacts
        (n,), NaN where they were not counted; None without any.
    first
        Number of the body touched first, (n,): -1 none, -2 not known; None without any.
    rebounds
        x and y of misses where they came down to the catching height, (n, 2), m; NaN where that is
        not known. None without any.
    errors
        Errors of the measurement of rebounds for each draw, (n, draws, 2), m.
    catching_height
        m above the floor.
    """

    made: Flags
    contacts: Floats | None
    first: NDArray[np.int8] | None
    rebounds: Floats | None
    errors: Floats
    catching_height: float

    @classmethod
    def read(
        cls,
        given: Mapping[str, ArrayLike | None],
        rows: int,
        surfaces: tuple[str, ...],
        draws: int,
        error: Any,
        catching_height: float,
        seed: int,
    ) -> Outcomes:
        """Return the observed ends from columns, each (n,) with the names of `OUTCOMES`.

        Parameters
        ----------
        rows
            Number of shots n.
        surfaces
            Names of the bodies; "none" is a shot that touched nothing.
        draws
            Number of simulated shots of each.
        error
            Standard error of a coordinate of the place of a rebound, m.
        catching_height
            Of the rebounds, m.
        seed
            Of the errors of rebounds.

        Raises
        ------
        ValueError
            If a column is not as described.
        """
        check_names("outcomes", given, OUTCOMES)
        columns = {name: np.asarray(one) for name, one in given.items() if one is not None}
        if "made" not in columns:
            raise ValueError("made: whether each shot was made is neither a column nor given")
        made = columns["made"]
        if made.shape != (rows,) or not np.isin(made, (0, 1)).all():
            raise ValueError(f"made: expected true or false for each of {rows} shots")
        for name, one in columns.items():
            if one.shape != made.shape:
                raise ValueError(f"{name}: expected a value for each of {rows} shots")
        contacts = None if "contacts" not in columns else _counts(columns["contacts"])
        first = None if "first" not in columns else _bodies(columns["first"], surfaces)
        axes = [name for name in OUTCOMES if name.startswith("rebound") and name in columns]
        if len(axes) == 1:
            raise ValueError(f"{axes[0]}: a rebound has a place; give rebound_x and rebound_y")
        places, noise = None, np.zeros((rows, 1, 2))
        if axes:
            both = [as_doubles(name, columns[name]) for name in axes]
            places = np.where(made[:, None].astype(bool), np.nan, np.stack(both, axis=1))
            sd = as_doubles("rebound_error", error)
            if sd.ndim or not 0.0 <= float(sd) < inf:
                raise ValueError(f"rebound_error: expected a number from 0, got {brief(error)}")
            size = (rows, draws, 2)
            noise = float(sd) * normals(seed, _STREAM, 0, rows * draws * 2).reshape(size)
        return cls(made.astype(bool), contacts, first, places, noise, catching_height)

    def __len__(self) -> int:
        return len(self.made)

    def __getitem__(self, rows: Any) -> Outcomes:
        """Return those of some shots."""
        named = {"contacts": self.contacts, "first": self.first, "rebounds": self.rebounds}
        parts: dict[str, Any] = {n: None if one is None else one[rows] for n, one in named.items()}
        return replace(self, made=self.made[rows], errors=self.errors[rows], **parts)

    @property
    def used(self) -> tuple[str, ...]:
        """Return the names of what was seen."""
        found = {"contacts": self.contacts, "first": self.first, "rebound": self.rebounds}
        return ("made", *(name for name, one in found.items() if one is not None))

    def cells(self, bodies: int) -> int:
        """Return the number of ends that are told apart, with so many bodies."""
        each = {
            "made": 2,
            "contacts": _CONTACTS + 1,
            "first": bodies + 1,
            "rebound": len(SECTORS) * (len(_EDGES) + 1),
        }
        return int(np.prod([each[name] for name in self.used]))

    def hits(self, states: Floats, parameters: Mapping[str, Any], engine: Any) -> tuple[Flags, Any]:
        """Return which simulated shots end as was seen, and which are valid, (n, draws).

        Parameters
        ----------
        states
            (n, draws, 9).
        parameters
            Of the scene, one number each or one for each shot (n,).
        """
        n, draws = states.shape[:2]
        own: dict[str, Any] = {
            name: np.repeat(np.asarray(one), draws) if np.ndim(one) else float(one)
            for name, one in parameters.items()
        }
        flat = states.reshape(-1, 9)
        fields = ["outcome"]
        fields += ["contacts"] if self.contacts is not None or self.rebounds is not None else []
        fields += ["first"] if self.first is not None else []
        fields += ["time", "state"] if self.rebounds is not None else []
        shots = simulate(flat, own, scene=engine, fields=tuple(fields))
        same = np.asarray(shots.made).reshape(n, draws) == self.made[:, None]
        if self.contacts is not None:
            seen = np.minimum(self.contacts, _CONTACTS)[:, None]
            found = np.minimum(shots.contacts.reshape(n, draws), _CONTACTS)
            same &= np.isnan(seen) | (found == seen)
        if self.first is not None:
            body = self.first[:, None]
            same &= (body == _UNKNOWN) | (shots.first.reshape(n, draws) == body)
        if self.rebounds is not None:
            results = {name: getattr(shots, name) for name in fields}
            block = Block(flat, results, own, engine, self.catching_height)
            caught = rebound(block)
            axes = np.stack([caught["rebound_x"], caught["rebound_y"]], axis=-1)
            start = states[:, :, :2].mean(axis=1)
            seen = _cell(self.rebounds, start)[:, None]
            places = axes.reshape(n, draws, 2) + self.errors
            same &= (seen == _NONE) | (_cell(places, start[:, None]) == seen)
        valid = (shots.outcome != engine.outcomes["INVALID"]).reshape(n, draws)
        return same & valid, valid


def _counts(given: NDArray[Any]) -> Floats:
    counts = as_doubles("contacts", given)
    if np.any((counts < 0.0) | (counts % 1.0 > 0.0)):
        raise ValueError(f"contacts: expected whole numbers from 0, got {brief(given)}")
    return counts


def _bodies(given: NDArray[Any], surfaces: tuple[str, ...]) -> NDArray[np.int8]:
    """Return the numbers of bodies by their names."""
    numbers = {name: k for k, name in enumerate(surfaces)} | {"none": _NONE, "": _UNKNOWN}
    found = ["" if one is None or one != one else str(one).strip().lower() for one in given]
    strange = [one for one in dict.fromkeys(found) if one not in numbers]
    if strange:
        raise ValueError(
            f"first: expected {join_names(surfaces)}, none or nothing, got {brief(strange[0])}"
        )
    return np.array([numbers[one] for one in found], np.int8)


def _cell(places: Floats, seen_from: Floats) -> NDArray[np.int64]:
    """Return in which direction and distance places lie, by number; -1 where there is none."""
    x, y = places[..., 0], places[..., 1]
    from_x, from_y = (np.broadcast_to(seen_from[..., k], x.shape) for k in range(2))
    which = sector(direction_from(x, y, from_x, from_y)).astype(np.int64)
    away = np.digitize(np.nan_to_num(hypotenuse(y, x)), _EDGES)
    return np.asarray(np.where(which < 0, _NONE, which * (len(_EDGES) + 1) + away))
