"""A shot whose sequence is known, to 70 digits, straight from the formulas of its scene.

The time of each event is a root of the distance, found by the secant method; the contact law is
evaluated as it stands. Derivatives are central differences of it, whose step is 1e-25. The numbers
are the midpoints of python-flint's balls, which take a tenth of the time of mpmath's numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
import sympy as sp
from flint import arb, ctx
from hoopgen.derive.contact.law import Law
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import Surface
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import NORMAL, POSITION, STATE, normal, spin, t, velocity
from numpy.typing import NDArray

_TURNS = 30
"""Most turns of the secant method; there are about seven."""

Vector = list[Any]


def middle(value: Any) -> arb:
    """Return the midpoint of a ball, or a whole number as one."""
    return arb(value).mid()


def _sides(left: Any, right: Any) -> tuple[arb, arb]:
    """Return two numbers that can be compared; that none is NaN is checked."""
    sides = middle(left), middle(right)
    if any(side.is_nan() for side in sides):
        raise ArithmeticError(f"{left} and {right} are compared")
    return sides


def _if_less(left: Any, right: Any, then: Any, other: Any) -> Any:
    low, high = _sides(left, right)
    return then if low < high else other


def _if_at_most(left: Any, right: Any, then: Any, other: Any) -> Any:
    low, high = _sides(left, right)
    return then if low <= high else other


_FUNCTIONS = {
    "IfLess": _if_less,
    "IfAtMost": _if_at_most,
    "inf": arb.pos_inf(),
    "mpf": arb,
    "sqrt": lambda value: arb(value).sqrt(),
}
"""Functions for the names that SymPy prints for mpmath."""


class PreciseScene:
    """The formulas of a scene as functions of numbers of many digits.

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
    step = 1e-25

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._functions: dict[tuple[str, object], Any] = {}

    @cached_property
    def names(self) -> list[str]:
        """The names of the scene's inputs."""
        return [symbol.name for symbol in self.scene.symbols]

    def _function(
        self,
        kind: str,
        of: object,
        symbols: Sequence[sp.Symbol],
        values: Callable[[], Iterable[sp.Expr]],
    ) -> Any:
        """Return the function of some formulas, which are derived once: laws take SymPy long."""
        if (kind, of) not in self._functions:
            plain = [release(sp.sympify(value)) for value in values()]
            arguments = [*symbols, *self.scene.symbols]
            modules = [_FUNCTIONS, "mpmath"]
            self._functions[kind, of] = sp.lambdify(arguments, plain, modules, cse=True)
        return self._functions[kind, of]

    def gap(self, surface: Surface, place: Vector, inputs: Vector) -> Any:
        """Return the distance of a ball at a place from a surface."""
        distance = self._function("gap", surface, POSITION, lambda: [surface.distance])
        return middle(distance(*place, *inputs)[0])

    def fly(self, duration: Any, now: Vector, inputs: Vector) -> list[Any]:
        """Return position and velocity after a flight of some duration."""
        return list(self._flight(duration, *now, *inputs))

    @cached_property
    def _flight(self) -> Any:
        def moved() -> list[sp.Expr]:
            return [c for part in self.scene.flight.at() for c in part]

        return self._function("flight", self.scene.name, (t, *STATE), moved)

    def _turned(self, surface: Surface) -> Any:
        return self._function("normal", surface, POSITION, lambda: surface.normal)

    def _act(self, law: Law) -> Any:
        def after() -> list[sp.Expr]:
            parts = law.after(normal, velocity, spin, self.scene.ball)
            return [c for part in parts for c in part]

        return self._function("law", law, (*STATE[3:], *NORMAL), after)

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
        clock, now, found = arb(0), list(state), []
        for surface, law, near in events:

            def distance(since: Any, now: Vector = now, surface: Surface = surface) -> Any:
                return self.gap(surface, self.fly(since, now, inputs)[:3], inputs)

            duration = self._root(distance, middle(near - clock))
            now = [*map(middle, self.fly(duration, now, inputs)), *now[6:]]
            clock = middle(clock + duration)
            before = list(now)
            if law is not None:
                towards = map(middle, self._turned(surface)(*now[:3], *inputs))
                now[3:] = map(middle, self._act(law)(*now[3:], *towards, *inputs))
            found.append([*before, *now, clock])
        return found

    def _root(self, distance: Callable[[arb], arb], near: arb) -> arb:
        """Return the root near a time; its error is about that of a number."""
        one, other = near, middle(near + 1e-9)
        gap, beyond = distance(one), distance(other)
        for _ in range(_TURNS):
            if gap == beyond:
                return other
            step = middle(beyond * (other - one) / (beyond - gap))
            one, gap, other = other, beyond, middle(other - step)
            # The next step is about the product of this one and the last.
            if abs(float(step)) < 10.0 ** (5 - self.digits):
                return other
            beyond = distance(other)
        raise ArithmeticError(f"no root near {near}: the last step is {step}")

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
        with ctx.workdps(self.digits):
            start = [arb(float(value)) for value in (*state, *inputs)]
            step, columns = arb(self.step), []
            for change in changes.values():
                ends = []
                for sign in (1, -1):
                    moved = [
                        middle(v + sign * step * c) for v, c in zip(start, change, strict=True)
                    ]
                    ends.append(self.states(moved[:9], moved[9:], events))
                columns.append(
                    [
                        [float((up - down) / (2 * step)) for up, down in zip(*pair, strict=True)]
                        for pair in zip(*ends, strict=True)
                    ]
                )
        return np.moveaxis(np.array(columns), 0, 2)
