"""The search in single precision against the flight itself, at fifty digits where it is near."""

from __future__ import annotations

import numpy as np
import pytest
from hoopgen.derive.events.ring.single import MAX_STEPS
from hoopgen.generated.numpy import hoop

from tests.derive.test_evaluation import PARAMETERS, Path, digits
from tests.helpers.effort import trials
from tests.helpers.past_ring import KINDS, begun, complaints, first_roots, known, leap

SEEDS = range(1, 1 + trials(2))


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_no_step_passes_the_first_root_and_what_is_certain_is_one(seed: int) -> None:
    """Flights are known to within all the errors that the search allows for.

    Hits, grazes to 1e-12 m, vertical and rising flights, bounces off the rim as slow as 1e-8 m/s.
    """
    assert complaints(hoop, MAX_STEPS, seed) == []


@pytest.mark.slow
def test_it_serves_and_is_certain_of_most() -> None:
    """A search that never moves, or is never certain, would pass no root either."""
    shots, roots = known(SEEDS[0], 4000)
    found, way = leap(hoop, shots | begun(hoop, shots), MAX_STEPS)
    served, met = found["single_precision"] > 0, np.isfinite(roots)
    assert np.mean(served) > 0.95
    assert np.mean(found["certain"][served & met] > 0) > 0.8
    assert np.mean(np.isinf(found["t"][served & ~met])) > 0.8
    assert sum(np.isfinite(turn[served]).mean() for turn in way) < 5


def test_the_roots_that_it_is_held_against_are_the_first() -> None:
    """On the axis of a ball that falls onto the wire they are known in closed form."""
    given = PARAMETERS | dict.fromkeys(("x", "y", "z", "vx", "vy", "vz", "leaving"), 0.0)
    given |= {"x": given["ring_radius"], "z": 1.0}
    columns = {name: np.full(KINDS, float(value)) for name, value in given.items()}
    columns["z"] += np.arange(KINDS) / 4
    roots = first_roots(columns)
    with digits(40):
        for row in range(KINDS):
            path = Path({name: float(column[row]) for name, column in columns.items()})
            falls = path["z"] - path.reach
            assert abs(roots[row] - (2 * falls / path["gravity"]) ** 0.5) < 1e-9
