"""Coupled differences: the same shots with a parameter of the scene above and below its value.

The outcome of a shot has no derivative by a parameter but on the boundary of the made shots, so
the share of made shots is differenced: (made above - made below) / 2h, over the same random numbers
(Glasserman, 2004, *Monte Carlo Methods in Financial Engineering*, 7.1). Shots that end alike with
both values cancel. The bias is of the order of h squared, and a difference over 2h estimates it.

The rate at which the boundary itself moves would have no step. `Shots.change_distance` gives it
where a single decision changes. In `HOOP`, on 100 lines along the speed for the player of the
README, 92% of the boundary by weight had no decision that could be told apart: most of these shots
stay on the rim for more than twenty contacts (docs/howto/gradients.md).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from hoopgen.results.shots import Shots

STEP = 2.0**-7
"""Step h as a share of the value; of 0 the step itself. Noise falls with its square root."""

TIMES = (1, 2)
"""Steps of the differences, in units of h."""

PAIRS = 4
"""Numbers of each difference: pairs of valid shots made with both values, with the larger value
alone, with the smaller one alone, and with neither."""

COUNTS = PAIRS * len(TIMES)
"""Numbers of each parameter."""


def step_of(value: float) -> float:
    """Return the step h of a parameter by its value."""
    return STEP * abs(value) or STEP


def difference_counts(
    simulated: Callable[[float], Shots], value: float, made: int, invalid: int
) -> NDArray[np.int64]:
    """Return the numbers of some shots by one parameter, (`COUNTS`,).

    Parameters
    ----------
    simulated
        Returns the shots with another value of the parameter, always with the same random numbers.
    value
        Of the parameter.
    made, invalid
        Outcomes that count, and that do not.
    """
    step, counts = step_of(value), []
    for times in TIMES:
        above, below = (simulated(value + sign * times * step).outcome for sign in (1, -1))
        valid = (above != invalid) & (below != invalid)
        one, other = (above == made)[valid], (below == made)[valid]
        made_with = (one & other, one & ~other, other & ~one, ~(one | other))
        counts += [np.count_nonzero(pairs) for pairs in made_with]
    return np.array(counts, np.int64)
