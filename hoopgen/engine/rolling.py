"""Motion of a ball in contact between two rows of the event log, by the engines' series.

Each step has its Taylor coefficients. They give the motion at any time of the step, and no step
depends on the times that are evaluated.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable, Mapping
from functools import cache
from types import FunctionType, ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_MIN_STEP = 2.0**-30
"""Shortest step, s: at a seam, which a ball may follow, the bound on the remainder may be 0."""

_STEP_FACTOR = 1.25
"""Length of a step relative to the engines' steps. Those err by roundings alone; a step so much
longer errs by about 1e-12 m. At seams the engines' length is used, since the bounds on the
remainder hold for it."""


def _divide(above: float, below: float) -> float:
    return above / below if below else float(np.divide(above, below))


def _square_root(of: float) -> float:
    return math.sqrt(of) if of >= 0.0 else math.nan


def _choose(truth: Any, then: Any, other: Any, *_: Any) -> Any:
    return then if truth else other


def _on_doubles(operation: Callable[..., Any], inputs: int) -> Callable[..., Any]:
    """Return an operation of NumPy on Python's doubles; it ignores the `out` array."""
    if inputs == 1:
        return lambda value, *_: operation(value)
    return lambda one, other, *_: operation(one, other)


_OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "_add": _on_doubles(operator.add, 2),
    "_subtract": _on_doubles(operator.sub, 2),
    "_multiply": _on_doubles(operator.mul, 2),
    "_divide": _on_doubles(_divide, 2),
    "_sqrt": _on_doubles(_square_root, 1),
    "_absolute": _on_doubles(abs, 1),
    "_negative": _on_doubles(operator.neg, 1),
    "_logical_and": _on_doubles(lambda one, other: bool(one) and bool(other), 2),
    "_logical_or": _on_doubles(lambda one, other: bool(one) or bool(other), 2),
    "_logical_not": _on_doubles(operator.not_, 1),
    "_where": _choose,
    "_select": _choose,
    "_result": _choose,
}


@cache
def _scalar_kernel(kernels: ModuleType, name: str) -> Callable[..., tuple[Any, ...]]:
    """Return a kernel on Python's doubles: the same bits in a tenth of NumPy's time."""
    kernel = getattr(kernels, name)
    names = vars(kernels) | dict(_OPERATIONS)
    return FunctionType(kernel.__code__, names, name, kernel.__defaults__)


def face_below(
    kernels: ModuleType, body: int, state: Floats, parameters: Mapping[str, float]
) -> str:
    """Return the name of the face of a body that a ball rolls on, or that it rolls onto.

    Parameters
    ----------
    kernels
        The scene's generated NumPy module.
    body
        Number of the body.
    state
        State of the ball, (9,).
    parameters
        Parameters of the scene, by the names of the kernels' variables.
    """
    faces: tuple[str, ...] = kernels.FACES[body]
    if len(faces) == 1:
        return str(kernels.BODIES[body])
    known = {**parameters, **dict(zip(kernels.STATE, state.tolist(), strict=True))}

    def off(face: str) -> float:
        """Return the distance from a face, plus that from its bounds in a moment."""
        names = [name for name in kernels.ARGUMENTS if name.startswith(f"{face}_rim")]
        found: dict[str, dict[str, float]] = {}
        for name in (f"{face}_distance", *names):
            values = getattr(kernels, name)(*(known[given] for given in kernels.ARGUMENTS[name]))
            found[name] = dict(zip(kernels.OUTPUTS[name], map(float, values), strict=True))
        within = (found[name] for name in names)
        past = (-rim["bound_distance"] - rim["bound_rate"] * _MIN_STEP for rim in within)
        return abs(found[f"{face}_distance"]["gap"]) + max(0.0, *past)

    return min((face for face in faces if f"{face}_distance" in kernels.ARGUMENTS), key=off)


class Roll:
    """A ball that rolls on a body without slip.

    Parameters
    ----------
    kernels
        The scene's generated NumPy module.
    body
        Name of the face that the ball rolls on; that of a body with one face is the body's.
    state
        State at the begin of contact, (9,).
    duration
        Duration of contact, s.
    parameters
        Parameters of the scene, by the names of the kernels' variables.
    """

    def __init__(
        self,
        kernels: ModuleType,
        body: str,
        state: Floats,
        duration: float,
        parameters: Mapping[str, float],
    ) -> None:
        self._kernels, self._first = kernels, state
        self._parameters = {name: float(value) for name, value in parameters.items()}
        self._seams = [name for name in kernels.ARGUMENTS if name.startswith(f"{body}_seam")]
        # A ring has coordinates of its own, and a state made of them lies on it.
        on_ring = f"{body}_round_start" in kernels.ARGUMENTS
        series = f"{body}_round" if on_ring else "roll"
        order = sum(re.fullmatch(rf"{series}_\d+", name) is not None for name in kernels.ARGUMENTS)
        seams = (name for seam in self._seams for name in (seam, "beside_seam"))
        self._about = [
            *([] if on_ring else [f"{body}_normal"]),
            f"{body}_rolling_surface",
            f"{series}_start",
            *(f"{series}_{k}" for k in range(order)),
            f"{series}_step",
            *seams,
        ]
        back = [] if on_ring else [f"{body}_normal", f"{body}_distance", "roll_placed"]
        self._moving = [f"{series}_moved", *back]
        self._needed = [name for name in kernels.ARGUMENTS[self._moving[0]] if name != "t"]
        with np.errstate(all="ignore"):  # what a kernel does not choose may be divided by 0
            starts, steps = self._follow(duration)
        self._starts = np.array(starts)
        self._steps = dict(zip(self._needed, np.array(steps).T, strict=True))

    def at(self, times: Floats) -> Floats:
        """Return the states at times since the begin of contact, (n, 9)."""
        step = np.searchsorted(self._starts, times, side="right") - 1
        at = {name: column[step] for name, column in self._steps.items()}
        at |= self._parameters | {"t": times - self._starts[step]}
        with np.errstate(all="ignore"):
            self._move(at)
        states = np.stack([at[name] for name in self._kernels.STATE], axis=-1)
        return np.where(times[:, np.newaxis] == 0.0, self._first, states)

    def _follow(self, duration: float) -> tuple[list[float], list[list[float]]]:
        """Compute the steps until contact ends; return their begins and series."""
        now: dict[str, Any] = dict(self._parameters)
        now |= dict(zip(self._kernels.STATE, self._first.tolist(), strict=True))
        clock, starts, steps = 0.0, [], []
        while True:
            self._expand(now)
            starts.append(clock)
            steps.append([now[name] for name in self._needed])
            stride = max(now["stride"] * (1.0 if self._seams else _STEP_FACTOR), _MIN_STEP)
            if not clock + stride < duration:  # nor a stride that is not a number
                return starts, steps
            now["t"] = stride
            self._move(now, _scalar_kernel)
            clock += stride

    def _expand(self, now: dict[str, Any]) -> None:
        """Add the series about a state, with its duration."""
        for name in self._about:
            self._take(name, now, _scalar_kernel)

    def _move(self, now: dict[str, Any], kernel: Callable[..., Any] = getattr) -> None:
        """Follow the series, and project back onto the body."""
        for name in self._moving:
            self._take(name, now, kernel)

    def _take(self, name: str, now: dict[str, Any], kernel: Callable[..., Any]) -> None:
        kernels = self._kernels
        values = kernel(kernels, name)(*[now[given] for given in kernels.ARGUMENTS[name]])
        now |= dict(zip(kernels.OUTPUTS[name], values, strict=True))
