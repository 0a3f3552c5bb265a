"""First-order distances of shots from their decisions: how far the next change of sequence is.

A decision is a sign: of the smallest distance between the ball and a body, of a bound, or of the
margin between grip and slip. With the value m of that margin and its gradient g by the variables
the nearest place at which m vanishes is, to first order, |m| / sqrt(g' C g) standard deviations
away, C being the covariance of the variables. At a smallest distance the time does not matter, so
the gradient there is that at a fixed time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import Value
from hoopgen.core.variables import STATE
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.flight_pieces import FlownPieces

from .surface_changes import NORMAL, ROUNDING, VELOCITY, unit_normal, without_rounding
from .variations import SHOTS_AT_ONCE, VARIATION, VariedPath

Floats = NDArray[np.float64]
Rows = NDArray[np.intp]

LOOKS = 64
"""Times of a flight at which the distance of a body is computed. Between two of them a smallest
distance is found by bisection, where its rate is negative at the first and not at the second."""

SHOTS_WITH_PIECES_AT_ONCE = 1 << 10
"""Shots that are followed together where flights have pieces: all of those are kept."""

SHORTEST_STAY = 1e-6
"""First look into the continuation of a flight through the body that it touches, as a share of the
duration of the shot; the others are further on, at equal ratios, up to that duration."""

HALVINGS = 60
"""Bisections, after which a time of a smallest distance is as good as a double is."""


def decision_names(scene: CompiledScene) -> tuple[str, ...]:
    """Return the names of the decisions: the columns of `change_distance`.

    Of each body ``body_touch``, ``body_miss`` and, where it may slip, ``body_slip``; then
    ``end_edge`` and ``end_miss``.
    """
    kernels, names = scene.kernels, []
    for body in kernels.BODIES:
        law, _ = kernels.VARIED_LAWS[body]
        slips = "grip_margin" in kernels.OUTPUTS[law]
        names += [f"{body}_touch", f"{body}_miss", *([f"{body}_slip"] if slips else [])]
    return (*names, "end_edge", "end_miss")


def change_distance(
    scene: CompiledScene,
    names: Sequence[str],
    parameters: Mapping[str, Value],
    releases: Floats,
    events: NDArray[np.void],
    differentiable: NDArray[np.bool_],
    spread: Floats,
) -> Floats:
    """Return the first-order distance of each shot from each of its decisions, (n, decisions).

    Parameters
    ----------
    scene
        The scene.
    names
        Variables of the derivatives, k of them.
    parameters
        Parameters of the scene, one number each or (n,).
    releases
        The states at the release, (n, 9).
    events
        The event log.
    differentiable
        The shots that have derivatives, (n,); the others get NaN.
    spread
        (1 or n, k, j): the changes of the variables by j independent ones of unit size.

    Returns
    -------
    ndarray
        (n, `decision_names`): of a decision that a shot takes several times the smallest distance;
        infinite where it takes none.
    """
    columns = decision_names(scene)
    shots = len(releases)
    size = SHOTS_WITH_PIECES_AT_ONCE if scene.kernels.PIECES else SHOTS_AT_ONCE
    found = np.full((shots, len(columns)), np.nan)
    first = np.searchsorted(events["shot"], np.arange(shots))
    last = np.searchsorted(events["shot"], np.arange(shots), "right") - 1
    with np.errstate(all="ignore"):  # what has no normal or no root is no number, and left out
        for start in range(0, shots, size):
            rows = start + np.flatnonzero(differentiable[start : start + size])
            if not len(rows):
                continue
            own = {n: v if isinstance(v, float) else v[rows] for n, v in parameters.items()}
            path = VariedPath(scene, names, own, releases[rows])
            margins = _Margins(
                path,
                scene,
                dict(zip(columns, range(len(columns)), strict=True)),
                np.broadcast_to(spread, (shots, *spread.shape[1:]))[rows],
                events["time"][last[rows]],
                np.full((len(rows), len(columns)), np.inf),
            )
            path.follow(events, first[rows], margins)
            found[rows] = margins.distance
    return found


@dataclass
class _Margins:
    """The distances from the decisions of some shots, gathered along their paths.

    Attributes
    ----------
    path
        Their variations.
    scene
        The scene.
    columns
        The column of each decision.
    spread
        (m, k, j), as for `change_distance`.
    lasting
        The durations of the shots, s, (m,).
    distance
        The smallest distances so far, (m, decisions).
    _pieces
        Where a flight has pieces: the shots in flight, in order, and their flights.
    """

    path: VariedPath
    scene: CompiledScene
    columns: Mapping[str, int]
    spread: Floats
    lasting: Floats
    distance: Floats
    _pieces: tuple[Rows, FlownPieces] | None = field(default=None, init=False)

    def flight(self, rows: Rows, events: NDArray[np.void], duration: Floats, start: Floats) -> None:
        """Record the clearance of flights from bodies, and the depth of flights that touch."""
        kernels = self.scene.kernels
        looks = np.linspace(0.0, 1.0, LOOKS) * duration[:, np.newaxis]
        further = np.geomspace(SHORTEST_STAY, 1.0, LOOKS) * self.lasting[rows, np.newaxis]
        beyond = np.concatenate([duration[:, np.newaxis], duration[:, np.newaxis] + further], 1)
        if kernels.PIECES:
            given = self.path.given(rows, varied=False)
            self._pieces = rows, FlownPieces(kernels, self.path.start[rows], beyond[:, -1], given)
        seen = self._given(np.repeat(rows, LOOKS), looks.ravel())
        for body, name in enumerate(kernels.BODIES):
            touched = np.flatnonzero(events["surface"] == body)
            for face in kernels.FACES[body]:
                self._near(face, f"{name}_miss", rows, start, looks, seen)
                if len(touched):
                    own = (rows[touched], start[..., touched], beyond[touched])
                    self._deep(face, f"{name}_touch", *own, events[touched])
        for plane in kernels.END_PLANES:
            self._near(plane, "end_miss", rows, start, looks, seen, bounded=False)

    def event(
        self,
        face: str,
        rows: Rows,
        events: NDArray[np.void],
        found: Mapping[str, Any],
        arrival: Floats,
    ) -> None:
        """Record an event's distance from the edges of its surface, from slip, and from a tie."""
        kernels = self.scene.kernels
        ended = face in kernels.END_PLANES
        surface = int(events["surface"][0])
        own = "end" if ended else kernels.BODIES[surface]
        for margin, change in _bounds(found):
            self._note("end_edge" if ended else f"{own}_touch", rows, margin, change)
        if f"{own}_slip" in self.columns:
            margin, change = found["grip_margin"], found["grip_margin_change"]
            self._note(f"{own}_slip", rows, margin, change)
        for body, faces in zip(
            (*kernels.BODIES, "end"), (*kernels.FACES, kernels.END_PLANES), strict=True
        ):
            if body == own:
                continue
            for other in faces:
                given = dict(found) | dict.fromkeys(NORMAL, 0.0)
                given |= unit_normal(self.path, other, given)
                varied = self.path.call(f"{other}_vary", given)
                varied["gap_change"] = without_rounding(
                    varied["gap_change"], given, [*arrival[:3]], found["contact_delay"]
                )
                approach = sum(given[n] * given[v] for n, v in zip(NORMAL, VELOCITY, strict=True))
                nears = (np.asarray(varied["gap"]) > 0.0) & (approach < 0.0)
                self._miss(f"{body}_miss", rows, varied, nears, bounded=body != "end")

    def _note(self, column: str, rows: Rows, margin: Any, change: Any) -> None:
        """Note the distance from a decision: its margin, (j,), and the change of that, (k, j)."""
        self._store(column, rows, self._distance(rows, margin, change))

    def _store(self, column: str, rows: Rows, distance: Floats) -> None:
        """Keep the smallest distances from a decision."""
        distance = np.where(np.isnan(distance), np.inf, distance)
        np.minimum.at(self.distance[:, self.columns[column]], rows, distance)

    def _distance(self, rows: Rows, margin: Any, change: Any) -> Floats:
        """Return the first-order distance from a zero of a margin."""
        variables = self.spread.shape[1]
        gradient = np.broadcast_to(change, (variables, len(rows)))
        moved = np.einsum("kj,jki->ji", gradient, self.spread[rows])
        size = np.einsum("kj,jki->ji", np.abs(gradient), np.abs(self.spread[rows]))
        moved = np.where(np.abs(moved) <= ROUNDING * size, 0.0, moved)
        return np.asarray(np.abs(margin) / np.sqrt((moved**2).sum(axis=1)))

    def _violated(self, rows: Rows, varied: Mapping[str, Any]) -> Floats:
        """Return the distance at which all bounds hold: that of the furthest; 0 if they do."""
        furthest = np.zeros(len(rows))
        for margin, change in _bounds(varied):
            outside = np.broadcast_to(margin > 0.0, furthest.shape)
            distance = np.where(outside, self._distance(rows, margin, change), 0.0)
            furthest = np.fmax(furthest, distance)
        return furthest

    def _miss(
        self, column: str, rows: Rows, varied: Mapping[str, Any], which: Any, bounded: bool = True
    ) -> None:
        """Note near misses: where a bound is violated too, both must change."""
        distance = self._distance(rows, varied["gap"], varied["gap_change"])
        if bounded:
            distance = np.maximum(distance, self._violated(rows, varied))
        self._store(column, rows, np.where(which, distance, np.inf))

    def _near(
        self,
        face: str,
        column: str,
        rows: Rows,
        start: Floats,
        looks: Floats,
        seen: Mapping[str, Any],
        bounded: bool = True,
    ) -> None:
        """Note the smallest distances from a face during flights, given what is seen of them."""
        gap, rate = self._seen(face, seen, looks.shape)
        flight, look = np.nonzero((rate[:, :-1] < 0.0) & (rate[:, 1:] >= 0.0))
        low, high = looks[flight, look], looks[flight, look + 1]
        self._at_least(face, column, rows[flight], start[..., flight], low, high, bounded)
        crossed = (gap[:, :-1] > 0.0) & (gap[:, 1:] < 0.0)
        flight, look = np.nonzero(crossed)
        if bounded and len(flight):
            low, high = looks[flight, look], looks[flight, look + 1]
            self._passed(face, column, rows[flight], start[..., flight], low, high)

    def _passed(
        self, face: str, column: str, rows: Rows, start: Floats, low: Floats, high: Floats
    ) -> None:
        """Note crossings of a face out of its bounds."""
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            outside = self._looks(face, rows, middle[:, np.newaxis])[0][:, 0] > 0.0
            low, high = np.where(outside, middle, low), np.where(outside, high, middle)
        varied = self._varied(face, rows, start, low)
        violated = self._violated(rows, varied)
        self._store(column, rows, np.where(violated > 0.0, violated, np.inf))

    def _deep(
        self,
        face: str,
        column: str,
        rows: Rows,
        start: Floats,
        beyond: Floats,
        events: NDArray[np.void],
    ) -> None:
        """Record the depth of flights that end at a face, if continued through it."""
        gap, rate = self._looks(face, rows, beyond)
        nearest = np.abs(gap[:, 0])
        for other in self.scene.kernels.FACES[int(events["surface"][0])]:
            if other != face:
                away = np.abs(self._looks(other, rows, beyond[:, :1])[0][:, 0])
                nearest = np.where(away < nearest, np.nan, nearest)  # another face is touched
        # In the core of a body there is no normal, so no rate: then there is no such depth.
        look = np.argmin(rate[:, 1:] < 0.0, axis=1)
        flights = np.arange(len(rows))
        rises = (rate[flights, look] < 0.0) & (rate[flights, look + 1] >= 0.0)
        which = np.flatnonzero(rises & np.isfinite(nearest))
        low, high = beyond[which, look[which]], beyond[which, look[which] + 1]
        self._at_least(face, column, rows[which], start[..., which], low, high, inside=True)

    def _at_least(
        self,
        face: str,
        column: str,
        rows: Rows,
        start: Floats,
        low: Floats,
        high: Floats,
        bounded: bool = True,
        inside: bool = False,
    ) -> None:
        """Note the smallest distances from a face, between two times each."""
        if not len(rows):
            return
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            falls = self._looks(face, rows, middle[:, np.newaxis])[1][:, 0] < 0.0
            low, high = np.where(falls, middle, low), np.where(falls, high, middle)
        rises = self._looks(face, rows, high[:, np.newaxis])[1][:, 0] >= 0.0  # not into the core
        rows, start, low = rows[rises], start[..., rises], low[rises]
        varied = self._varied(face, rows, start, low)
        if inside:
            self._note(column, rows, varied["gap"], varied["gap_change"])
        else:
            self._miss(column, rows, varied, np.asarray(varied["gap"]) > 0.0, bounded)

    def _varied(self, face: str, rows: Rows, start: Floats, times: Floats) -> dict[str, Any]:
        """Return the values of a face's kernel at some times of flights, with variations."""
        given = self.path.given(rows) | dict(zip(VARIATION, start, strict=True)) | {"t": times}
        given |= self.path.fly(rows, times, given)
        given |= self._given(rows, times, varied=given)
        given |= unit_normal(self.path, face, given)
        found = self.path.call(f"{face}_vary", given)
        moved = [given[name] for name in VARIATION[:3]]
        return found | {"gap_change": without_rounding(found["gap_change"], given, moved)}

    def _looks(self, face: str, rows: Rows, times: Floats) -> tuple[Floats, Floats]:
        """Return the distances from a face at times of flights, and their rates, (j, times)."""
        given = self._given(np.repeat(rows, times.shape[1]), times.ravel())
        return self._seen(face, given, times.shape)

    def _seen(
        self, face: str, given: Mapping[str, Any], shape: tuple[int, ...]
    ) -> tuple[Floats, Floats]:
        """Return distances from a face and their rates, given the arguments of kernels.

        In the core of a body, where there is no normal, the rate is NaN.
        """
        gap = self.path.call(f"{face}_vary", dict(given))["gap"]
        turned = unit_normal(self.path, face, given)
        rate = sum(turned[n] * given[v] for n, v in zip(NORMAL, VELOCITY, strict=True))
        gap, rate = (np.broadcast_to(found, int(np.prod(shape))) for found in (gap, rate))
        return gap.reshape(shape), rate.reshape(shape)

    def _given(
        self, rows: Rows, times: Floats, varied: Mapping[str, Any] | None = None
    ) -> dict[str, Any]:
        """Return parameters and the states at some times of flights; by default no variations."""
        given = self.path.given(rows, varied=varied is not None)
        given |= dict(zip(STATE, self.path.start[rows].T, strict=True)) | {"t": times}
        if self._pieces is not None:
            shots, flown = self._pieces
            given |= flown.at(np.searchsorted(shots, rows), times)
        else:
            given |= self.path.call("flight", given)
        given |= self.path.forces(given) | dict.fromkeys(NORMAL, 0.0)
        return given if varied is None else given | {n: varied[n] for n in VARIATION}


def _bounds(found: Mapping[str, Any]) -> list[tuple[Any, Any]]:
    """Return the bounds that a kernel returned, and their changes."""
    pairs, k = [], 0
    while f"g{k}" in found:
        pairs.append((found[f"g{k}"], found[f"g{k}_change"]))
        k += 1
    return pairs
