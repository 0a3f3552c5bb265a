"""A ball in contact, between two rows of the event log, as series from the engines' own kernels.

Each step has its Taylor coefficients. So the motion can be had at any time in it, and no step
depends on the times that are asked for.
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

__all__ = ["Roll"]

Floats = NDArray[np.float64]

_SHORTEST = 2.0**-30
"""Of a step, s: at a seam, which a ball may follow, a bound of what is left may be 0."""

_LONGER = 1.25
"""Steps than those of the engines: theirs are off by roundings, and a step of so much more by some
1e-12 m, which nobody sees. Where there are seams the bounds on what is left hold for theirs."""


def _divided(above: float, below: float) -> float:
    return above / below if below else float(np.divide(above, below))


def _root(of: float) -> float:
    return math.sqrt(of) if of >= 0.0 else math.nan


def _chosen(truth: Any, then: Any, other: Any, *_: Any) -> Any:
    return then if truth else other


def _on_doubles(operation: Callable[..., Any], inputs: int) -> Callable[..., Any]:
    """Return an operation of NumPy's on Python's doubles; room for the result is left alone."""
    if inputs == 1:
        return lambda value, *_: operation(value)
    return lambda one, other, *_: operation(one, other)


_OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "_add": _on_doubles(operator.add, 2),
    "_subtract": _on_doubles(operator.sub, 2),
    "_multiply": _on_doubles(operator.mul, 2),
    "_divide": _on_doubles(_divided, 2),
    "_sqrt": _on_doubles(_root, 1),
    "_absolute": _on_doubles(abs, 1),
    "_negative": _on_doubles(operator.neg, 1),
    "_logical_and": _on_doubles(lambda one, other: bool(one) and bool(other), 2),
    "_logical_or": _on_doubles(lambda one, other: bool(one) or bool(other), 2),
    "_logical_not": _on_doubles(operator.not_, 1),
    "_where": _chosen,
    "_select": _chosen,
    "_result": _chosen,
}


@cache
def _of_one_ball(kernels: ModuleType, name: str) -> Callable[..., tuple[Any, ...]]:
    """Return a kernel that takes Python's doubles: the same bits, in a tenth of NumPy's time."""
    kernel = getattr(kernels, name)
    names = vars(kernels) | dict(_OPERATIONS)
    return FunctionType(kernel.__code__, names, name, kernel.__defaults__)


class Roll:
    """A ball that rolls on a body without slip.

    Parameters
    ----------
    kernels
        The scene's generated NumPy module.
    body
        What the ball is in contact with.
    state
        Where contact begins, (9,).
    lasting
        How long contact lasts, s.
    parameters
        The scene's, by the names of its variables.
    """

    def __init__(
        self,
        kernels: ModuleType,
        body: str,
        state: Floats,
        lasting: float,
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
            f"{body}_tube",
            f"{series}_start",
            *(f"{series}_{k}" for k in range(order)),
            f"{series}_pace",
            *seams,
        ]
        back = [] if on_ring else [f"{body}_normal", f"{body}_off", "roll_placed"]
        self._moving = [f"{series}_moved", *back]
        self._needed = [name for name in kernels.ARGUMENTS[self._moving[0]] if name != "t"]
        with np.errstate(all="ignore"):  # what a kernel does not choose may be divided by 0
            starts, steps = self._follow(lasting)
        self._starts = np.array(starts)
        self._steps = dict(zip(self._needed, np.array(steps).T, strict=True))

    def at(self, times: Floats) -> Floats:
        """Return the states some times after contact began, (n, 9)."""
        step = np.searchsorted(self._starts, times, side="right") - 1
        at = {name: column[step] for name, column in self._steps.items()}
        at |= self._parameters | {"t": times - self._starts[step]}
        with np.errstate(all="ignore"):
            self._move(at)
        states = np.stack([at[name] for name in self._kernels.STATE], axis=-1)
        return np.where(times[:, np.newaxis] == 0.0, self._first, states)

    def _follow(self, lasting: float) -> tuple[list[float], list[list[float]]]:
        """Take steps until contact ends; return when each begins, and its series."""
        now: dict[str, Any] = dict(self._parameters)
        now |= dict(zip(self._kernels.STATE, self._first.tolist(), strict=True))
        clock, starts, steps = 0.0, [], []
        while True:
            self._expand(now)
            starts.append(clock)
            steps.append([now[name] for name in self._needed])
            stride = max(now["stride"] * (1.0 if self._seams else _LONGER), _SHORTEST)
            if not clock + stride < lasting:  # nor a stride that is not a number
                return starts, steps
            now["t"] = stride
            self._move(now, _of_one_ball)
            clock += stride

    def _expand(self, now: dict[str, Any]) -> None:
        """Add the series about a state, and how long it holds."""
        for name in self._about:
            self._take(name, now, _of_one_ball)

    def _move(self, now: dict[str, Any], kernel: Callable[..., Any] = getattr) -> None:
        """Go along the series, and back onto the body."""
        for name in self._moving:
            self._take(name, now, kernel)

    def _take(self, name: str, now: dict[str, Any], kernel: Callable[..., Any]) -> None:
        kernels = self._kernels
        values = kernel(kernels, name)(*[now[given] for given in kernels.ARGUMENTS[name]])
        now |= dict(zip(kernels.OUTPUTS[name], values, strict=True))
