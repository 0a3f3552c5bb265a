"""A shot whose sequence is known, to 70 digits, straight from the formulas of its scene.

The time of each event is a root of the distance, found by Newton's method; the contact law is
evaluated as it stands. Derivatives are central differences of it, whose step is 1e-25.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from hoopgen.derive.contact.law import Law
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import Surface
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import NORMAL, POSITION, STATE, normal, spin, t, velocity
from numpy.typing import NDArray

_CHOICES = {
    "IfLess": lambda left, right, then, other: then if left < right else other,
    "IfAtMost": lambda left, right, then, other: then if left <= right else other,
}

Vector = list[Any]


class PreciseScene:
    """The formulas of a scene as functions of numbers of mpmath.

    Parameters
    ----------
    scene
        The scene of the derivation.

    Attributes
    ----------
    digits
        Digits of the numbers.
    step
        Step of the differences.
    """

    digits = 70
    step = mpmath.mpf(10) ** -25

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._functions: dict[tuple[str, object], Any] = {}

    @cached_property
    def names(self) -> list[str]:
        """The names of the scene's inputs."""
        return [symbol.name for symbol in self.scene.symbols]

    def _function(self, kind: str, of: object, symbols: Sequence[sp.Symbol], values: Any) -> Any:
        if (kind, of) not in self._functions:
            plain = [release(sp.sympify(value)) for value in values]
            arguments = [*symbols, *self.scene.symbols]
            modules = [_CHOICES, "mpmath"]
            self._functions[kind, of] = sp.lambdify(arguments, plain, modules, cse=True)
        return self._functions[kind, of]

    def gap(self, surface: Surface, place: Vector, inputs: Vector) -> Any:
        """Return the distance of a ball at a place from a surface."""
        return self._function("gap", surface, POSITION, [surface.distance])(*place, *inputs)[0]

    def fly(self, duration: Any, now: Vector, inputs: Vector) -> list[Any]:
        """Return position and velocity after a flight of some duration."""
        return list(self._flight(duration, *now, *inputs))

    @cached_property
    def _flight(self) -> Any:
        moved = [c for part in self.scene.flight.at() for c in part]
        return self._function("flight", self.scene.name, (t, *STATE), moved)

    def states(
        self, state: Vector, inputs: Vector, events: Sequence[tuple[Surface, Law | None, float]]
    ) -> list[Vector]:
        """Return of each event the states before and after it, nine numbers each, and the time.

        Parameters
        ----------
        state
            The release, nine numbers.
        inputs
            The scene's inputs, in order.
        events
            Of each event its surface, the contact law (None: the end), and a time near it.
        """
        clock, now, found = mpmath.mpf(0), list(state), []
        for surface, law, near in events:

            def distance(since: Any, now: Vector = now, surface: Surface = surface) -> Any:
                return self.gap(surface, self.fly(since, now, inputs)[:3], inputs)

            duration = mpmath.findroot(distance, (near - clock, near - clock + mpmath.mpf("1e-9")))
            now = [*self.fly(duration, now, inputs), *now[6:]]
            clock += duration
            before = list(now)
            if law is not None:
                turned = self._function("normal", surface, POSITION, surface.normal)
                after = law.after(normal, velocity, spin, self.scene.ball)
                act = self._function(
                    "law", law, (*STATE[3:], *NORMAL), [c for part in after for c in part]
                )
                now[3:] = act(*now[3:], *turned(*now[:3], *inputs), *inputs)
            found.append([*before, *now, clock])
        return found

    def derivatives(
        self,
        state: NDArray[np.float64],
        inputs: Sequence[float],
        events: Sequence[tuple[Surface, Law | None, float]],
        changes: Mapping[str, Sequence[float]],
    ) -> NDArray[np.float64]:
        """Return of each event the derivatives of states before and after, and of time, (19, k).

        Parameters
        ----------
        state, inputs, events
            The shot, as of `states`.
        changes
            By variable the derivatives of the nine numbers of the release and of the inputs.
        """
        with mpmath.workdps(self.digits):
            start = [mpmath.mpf(float(value)) for value in (*state, *inputs)]
            columns = []
            for change in changes.values():
                ends = []
                for sign in (1, -1):
                    moved = [v + sign * self.step * c for v, c in zip(start, change, strict=True)]
                    ends.append(self.states(moved[:9], moved[9:], events))
                columns.append(
                    [
                        [
                            float((up - down) / (2 * self.step))
                            for up, down in zip(*pair, strict=True)
                        ]
                        for pair in zip(*ends, strict=True)
                    ]
                )
        return np.moveaxis(np.array(columns), 0, 2)
