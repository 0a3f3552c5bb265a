"""Coupled differences: the same shots with a parameter of the scene at values around its own.

The outcome of a shot has no derivative by a parameter but on the boundary of the made shots, so
the share of made shots is differenced: (made above - made below) / 2h, over the same random numbers
(Glasserman, 2004, *Monte Carlo Methods in Financial Engineering*, 7.1). Shots that end alike with
all values cancel. At a limit of the parameter the difference is one-sided and of the same order,
(4 made at h - made at 2h - 3 made) / 2h. The bias is of the order of h squared, and a difference
with twice the step estimates it.

The rate at which the boundary itself moves would have no step. `Shots.change_distance` gives it
where a single decision changes. In `HOOP`, on 100 lines along the speed for the player of the
README, 92% of the boundary by weight had no decision that could be told apart: most of these shots
stay on the rim for more than twenty contacts (docs/howto/gradients.md).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.results.shots import Shots
from hoopgen.study.statistics.tally import check_scene

STEP = 2.0**-7
"""Step h as a share of the value; of 0 the step itself. Noise falls with its square root."""

CENTRAL = (-2, -1, 1, 2)
"""Values of a central difference, in steps from the parameter's own."""

ONE_SIDED = (0, 1, 2, 4)
"""Values of a one-sided difference, in steps from the parameter's own."""

COUNTS = 2 ** len(CENTRAL)
"""Numbers of each parameter: valid shots by the values with which they are made."""

_SMALLEST = 0.2
"""Smallest step of a central difference, in h. Of shots that change at a constant rate along the
parameter, the variance is proportional to 1/2h for a central difference and to 5/2h for a one-sided
one: a central one with a fifth of the step is as good as a one-sided one."""


@dataclass(frozen=True)
class Differences:
    """Values of a parameter from which the derivative by it is differenced.

    Attributes
    ----------
    value
        Of the parameter.
    step
        The step h; below zero for a one-sided difference towards smaller values.
    places
        `CENTRAL` or `ONE_SIDED`.
    """

    value: float
    step: float
    places: tuple[int, ...] = CENTRAL

    @property
    def values(self) -> tuple[float, ...]:
        """The values of the parameter that are simulated, in the order of `places`."""
        return tuple(self.value + place * self.step for place in self.places)

    def identity(self) -> list[float]:
        """Return all that the counts depend on, in types that JSON knows."""
        return [self.step, *self.places]


def differences_of(
    value: float, limits: tuple[float, float], allowed: Callable[[float], bool]
) -> Differences | None:
    """Return differences by a parameter with values that are allowed; None if there are none.

    They are a central difference, near a limit with a smaller step; one-sided where that step would
    be below a fifth of the usual one.

    Parameters
    ----------
    value
        Of the parameter.
    limits
        The least and the largest allowed value as far as they are known, else infinite.
    allowed
        Returns whether a value is allowed.
    """
    step, (low, high) = STEP * abs(value) or STEP, limits
    inner = min(step, (value - low) / 2.0, (high - value) / 2.0)
    central = [Differences(value, inner)] if inner >= _SMALLEST * step else []
    one_sided = (Differences(value, own, ONE_SIDED) for own in (step, -step))
    for found in chain(central, one_sided):
        if all(low <= each <= high and allowed(each) for each in found.values):
            return found
    return None


def differences_in(name: str, parameters: Mapping[str, float], scene: CompiledScene) -> Differences:
    """Return the differences by a parameter of a scene, within its limits.

    Parameters
    ----------
    name
        The name of the parameter.
    parameters
        All of the scene.
    scene
        The scene.

    Raises
    ------
    ValueError
        If no values around its own are allowed.
    """

    def allowed(value: float) -> bool:
        try:
            check_scene({**parameters, name: value}, scene)
        except ValueError:
            return False
        return True

    value = parameters[name]
    found = differences_of(value, scene.table.limits.get(name, (-np.inf, np.inf)), allowed)
    if found is None:
        raise ValueError(
            f"gradient: {name} is {value:g}, and the values around it that a difference takes "
            "are not allowed"
        )
    return found


def difference_counts(
    simulated: Callable[[float], Shots], differences: Differences, made: int, invalid: int
) -> NDArray[np.int64]:
    """Return the numbers of some shots by one parameter, (`COUNTS`,).

    Bit k of an index says whether these shots are made with value k.

    Parameters
    ----------
    simulated
        Returns the shots with another value of the parameter, always with the same random numbers.
    differences
        The values.
    made, invalid
        Outcomes that count, and that do not.
    """
    outcomes = np.stack([simulated(value).outcome for value in differences.values])
    valid = outcomes[:, (outcomes != invalid).all(axis=0)]
    bits = 1 << np.arange(len(valid))
    return np.bincount(bits @ (valid == made), minlength=COUNTS)
