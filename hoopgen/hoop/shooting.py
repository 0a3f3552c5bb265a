"""Shooting problems: releases whose flight ends at a point, by Newton's method.

Of an elevation, the speed, the azimuth and the time of flight solve the three equations "the ball
is at the point then". The derivative by the time is the velocity, those by the release are
differences; the parabola is the first guess. An entry angle, a speed, or the least speed, is one
equation more, in the elevation, which the secant method solves. Each row is iterated until its own
residual is small, so that it depends on no other row.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine.draws import release_states
from hoopgen.engine.elementary import arc_tangent, hypotenuse, sine_cosine
from hoopgen.generated.numpy import hoop

from .flights import Flights
from .parabolas import Arc, Floats, Values, parabola_through
from .releases import RING_HEIGHT

MAX_LANDING_ERROR = 1e-10
"""m: a flight that comes down further from its point is none that was found."""

_LANDING_GOAL = 1e-13
"""m: a step of Newton's method from a landing error as small as that changes roundings alone."""

_MAX_STEPS = 25
"""Steps of Newton's method, and of the secant method: far more than a row takes that has a
release."""

_DIFFERENCE = 1e-6
"""Step of the differences by speed (m/s) and angles (rad): their errors, relative to the derivative
about 1e-6, slow Newton's method down by one step at most."""

_WIDE_DIFFERENCE = 1e-4
"""Step of the central differences by the elevation at the least speed, rad. Their error moves that
elevation by about 1e-9 rad, and the least speed by 1e-17 of it."""

_MAX_SPEED, _MAX_TIME = 1e3, 60.0
"""m/s and s: faster and longer flights are not looked for."""

_EASED = (0.25, 0.5, 0.75, 1.0)
"""Parts of the air's density, and of the velocity of the place, in which rows are solved one after
the other that are not found at once."""


@dataclass(frozen=True)
class ShootingProblem:
    """Points to be hit: each is the origin, and the release is in front of it, on +x."""

    point: Floats  # (n, 2): reach and rise, m
    spin: Floats  # (n, 2): backspin and sidespin, rad/s
    moving: Floats  # (n, 2): towards the point and to the left, m/s
    flights: Flights

    def at(self, rows: NDArray[np.intp]) -> ShootingProblem:
        """Return the problems of some rows."""
        point, spin, moving = (one[rows] for one in (self.point, self.spin, self.moving))
        return ShootingProblem(point, spin, moving, self.flights.at(rows))

    def eased(self, part: float) -> ShootingProblem:
        """Return the problems in a part of the air, moving at a part of the velocity."""
        return replace(self, moving=part * self.moving, flights=self.flights.eased(part))

    def ends(self, release: Values) -> Floats:
        """Return the states at the end of the flights of releases, (..., n) each; (..., n, 9)."""
        arguments = {
            **{name: release[name] for name in ("speed", "elevation", "azimuth")},
            "backspin": self.spin[:, 0],
            "sidespin": self.spin[:, 1],
            "angle": np.zeros(()),
            "height": RING_HEIGHT - self.point[:, 1],
            "distance": self.point[:, 0],
        }
        shape = np.broadcast_shapes(*(value.shape for value in arguments.values()))
        states = release_states(arguments, shape, RING_HEIGHT)
        states[..., 3:5] -= self.moving  # from a place on +x, ahead is -x and the left is -y
        return self.flights.fly(np.broadcast_to(release["time"], shape), states)

    def solved(self, wanted: Mapping[str, Floats], arc: Arc) -> Values:
        """Return the releases, (n,) each; NaN where there is none.

        Parameters
        ----------
        wanted, arc
            As for `parabola_through`, (n,) each.
        """
        found, good = self._solved(wanted, arc)
        for name in found:
            found[name] = np.where(good, found[name], np.nan)
        return found

    def _solved(self, wanted: Mapping[str, Floats], arc: Arc) -> tuple[Values, NDArray[np.bool_]]:
        if "elevation" in wanted:
            held = wanted["elevation"]
            possible = sine_cosine(held)[1] > 0.0
            return self._checked(self._newton(self._guess(held)), possible)
        if "entry" in wanted:
            angle, _ = self._parabola(wanted)
            possible = sine_cosine(wanted["entry"])[1] > 0.0

            def flatter(one: _Rows, ends: Floats) -> Floats:
                return _entry_angle(ends) - wanted["entry"][one.rows]

            found, settled = self._secant(angle, flatter, 1e-12)
            return self._checked(found, possible & settled)
        slow, least = self._parabola({})
        slowest, settled = self._secant(slow, _Rows.slope, 1e-9)
        if "speed" not in wanted:
            return self._checked(slowest, settled)
        # As much faster than the slowest as a parabola would have to be: about as much steeper.
        eased = {"speed": wanted["speed"] * least / slowest["speed"]}
        angle, _ = self._parabola(eased, arc)
        angle = angle + slowest["elevation"] - slow

        def faster(one: _Rows, ends: Floats) -> Floats:
            return np.asarray(one.release["speed"] - wanted["speed"][one.rows])

        outwards = 0.01 if arc == "high" else -0.01
        found, right = self._secant(angle, faster, 1e-12, outwards)
        found["speed"] = wanted["speed"]
        steeper = found["elevation"] >= slowest["elevation"]
        right &= steeper if arc == "high" else ~steeper
        return self._checked(found, settled & right & (wanted["speed"] >= slowest["speed"]))

    def _parabola(self, wanted: Mapping[str, Floats], arc: Arc = "high") -> tuple[Floats, Floats]:
        """Return elevation and speed of parabolas from a place at rest."""
        reach, rise = self.point.T
        gravity = self.flights.gravity
        found, _ = parabola_through(wanted, reach, rise, gravity, arc)
        return found["elevation"], found["speed"]

    def _guess(self, elevation: Floats) -> Values:
        """Return the releases of parabolas that have about such elevations."""
        reach, rise = self.point.T
        # The flattest that comes down: level at the point, or straight to one that lies below.
        (level,) = hoop.slope_of_entry(0.0, reach, rise)
        flattest = arc_tangent(np.maximum(level, rise / reach)) + 0.02
        steep = np.maximum(elevation, flattest)
        gravity = self.flights.gravity
        found, _ = parabola_through({"elevation": steep}, reach, rise, gravity)
        across, up = found["speed"] * sine_cosine(steep)[1], found["speed"] * sine_cosine(steep)[0]
        ahead, aside = across - self.moving[:, 0], -self.moving[:, 1]
        level_speed = hypotenuse(aside, ahead)
        return {
            "speed": hypotenuse(up, level_speed),
            "elevation": elevation,
            "azimuth": arc_tangent(aside, ahead),
            "time": found["time"],
        }

    def _checked(
        self, found: Values, possible: NDArray[np.bool_]
    ) -> tuple[Values, NDArray[np.bool_]]:
        """Return the releases with entry angles, and which come down through the point."""
        end = self.ends(found)
        found["entry_angle"] = _entry_angle(end)
        near = np.sqrt(np.sum(end[:, :3] ** 2, axis=1)) <= MAX_LANDING_ERROR
        good = near & (end[:, 5] < 0.0) & (found["speed"] > 0.0) & (self.point[:, 0] > 0.0)
        good &= possible & (sine_cosine(found["elevation"])[1] > 0.0)
        return found, good

    def _newton(self, start: Values) -> Values:
        """Return the releases that end at the point, with the elevation of guesses (n,) each.

        Rows that are not found at once are solved in less air, and at a lower velocity of the
        place, and from there in more of it.
        """
        found, good = _iterated(self, start)
        rows = np.flatnonzero(~good & (self.point[:, 0] > 0.0))
        if len(rows):
            part = self.at(rows)
            some = part._still(start["elevation"][rows])
            for share in _EASED:
                some, _ = _iterated(part.eased(share), some)
            for name, value in some.items():
                found[name][rows] = value
        return found

    def _still(self, elevation: Floats) -> Values:
        """Return the releases of parabolas from a place at rest."""
        return replace(self, moving=np.zeros_like(self.moving))._guess(elevation)

    def _secant(
        self,
        elevation: Floats,
        condition: Callable[[_Rows, Floats], Floats],
        goal: float,
        step: float = 0.01,
    ) -> tuple[Values, NDArray[np.bool_]]:
        """Return the releases through the point of elevations that satisfy a condition.

        Parameters
        ----------
        elevation
            First guesses, rad, (n,).
        condition
            Function of rows, and the states at their ends, that is to be 0.
        goal
            The last step, rad.
        step
            The first step, rad.

        Returns
        -------
        tuple
            The releases, and which of them came so near.
        """
        rows = np.arange(len(elevation))
        found = self._newton(self._guess(elevation))
        value = condition(_Rows(self, found, rows), self.ends(found))
        steps = np.full(len(rows), step)
        for _ in range(_MAX_STEPS):
            rows = rows[np.isfinite(value[rows]) & (np.abs(steps[rows]) > goal)]
            if not len(rows):
                break
            part = self.at(rows)
            angle = found["elevation"][rows] + steps[rows]
            start = {name: one[rows] for name, one in found.items()}
            tried = part._newton({**start, "elevation": angle})
            new = condition(_Rows(part, tried, rows), part.ends(tried))
            slope = (new - value[rows]) / steps[rows]
            for name, one in tried.items():
                found[name][rows] = one
            value[rows] = new
            change = np.where(slope != 0.0, -new / np.where(slope != 0.0, slope, 1.0), 0.0)
            limit = np.minimum(0.1, 0.5 * (np.pi / 2 - np.abs(angle)))
            steps[rows] = np.clip(change, -limit, limit)
        return found, np.isfinite(value) & (np.abs(steps) <= goal)


@dataclass(frozen=True)
class _Rows:
    """Releases of some rows of a problem."""

    problem: ShootingProblem  # of these rows
    release: Values
    rows: NDArray[np.intp]

    def slope(self, ends: Floats) -> Floats:
        """Return the derivative of the speed through the point by the elevation, m/s/rad."""
        names = ("speed", "azimuth", "elevation")
        by = {n: self._central(n, _WIDE_DIFFERENCE) for n in names}
        normal = np.cross(by["azimuth"], ends[:, 3:6])
        return -_dot(by["elevation"], normal) / _dot(by["speed"], normal)

    def _central(self, name: str, step: float) -> Floats:
        """Return the derivative of the ends' places by an argument, (n, 3)."""
        there = {n: np.stack([value, value]) for n, value in self.release.items()}
        there[name] = there[name] + np.array([[step], [-step]])
        after, before = self.problem.ends(there)[..., :3]
        return np.asarray((after - before) / (there[name][0] - there[name][1])[:, None])


def _iterated(problem: ShootingProblem, start: Values) -> tuple[Values, NDArray[np.bool_]]:
    """Return the releases of Newton's method from guesses, and which end at the point."""
    found = {name: np.array(value, np.float64) for name, value in start.items()}
    good = np.zeros(len(problem.point), np.bool_)
    best = np.full(len(good), np.inf)
    rows = np.arange(len(good))
    for _ in range(_MAX_STEPS):
        part = problem.at(rows)
        own = {name: value[rows] for name, value in found.items()}
        moved = {name: np.stack([value] * 3) for name, value in own.items()}
        moved["speed"][1] += _DIFFERENCE
        moved["azimuth"][2] += _DIFFERENCE
        end, *others = part.ends(moved)
        miss = np.sqrt(_dot(end[:, :3], end[:, :3]))
        good[rows] = miss <= MAX_LANDING_ERROR
        # One more step after the goal is not missed by much: then only roundings change.
        going = np.isfinite(miss) & (miss > _LANDING_GOAL) & ~(good[rows] & (miss >= best[rows]))
        going &= (own["speed"] <= _MAX_SPEED) & (own["time"] <= _MAX_TIME)
        best[rows] = miss
        if not going.any():
            break
        by_speed, by_azimuth = (
            (other[:, :3] - end[:, :3]) / (moved[n][k] - own[n])[:, None]
            for k, (other, n) in enumerate(zip(others, ("speed", "azimuth"), strict=True), 1)
        )
        change = _cramer(by_speed, by_azimuth, end[:, 3:6], -end[:, :3])
        limits = (0.5 * own["speed"], 0.5, 0.5 * own["time"])
        ratio = np.max([np.abs(c) / limit for c, limit in zip(change, limits, strict=True)], axis=0)
        scale = 1.0 / np.maximum(1.0, ratio)
        for name, one in zip(("speed", "azimuth", "time"), change, strict=True):
            found[name][rows[going]] += (scale * one)[going]
        rows = rows[going]
    return found, good


def _cramer(a: Floats, b: Floats, c: Floats, right: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the solutions, (n,) each, of three equations with the columns a, b, c, (n, 3)."""
    across = np.cross(b, c)
    volume = _dot(a, across)
    return (
        _dot(right, across) / volume,
        _dot(right, np.cross(c, a)) / volume,
        _dot(right, np.cross(a, b)) / volume,
    )


def _dot(a: Floats, b: Floats) -> Floats:
    """Return the products of vectors (n, 3), summed in a fixed order."""
    return np.asarray(a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1] + a[:, 2] * b[:, 2])


def _entry_angle(states: Floats) -> Floats:
    """Return the angles of velocities below the horizontal, rad."""
    return arc_tangent(-states[..., 5], hypotenuse(states[..., 4], states[..., 3]))
