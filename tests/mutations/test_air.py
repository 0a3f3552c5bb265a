"""Deliberate faults in the pieces of flights through air: each trips a test by name."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from hoopgen.derive import model
from hoopgen.derive.events.air import AirRootFinder
from hoopgen.derive.motion import air

from tests.derive.motion import test_air
from tests.helpers.mutants import Patch, in_text

pytestmark = [pytest.mark.xdist_group("air_mutations")]


def _of_bound() -> None:
    with pytest.MonkeyPatch.context() as patch:
        test_air.test_the_bound_holds_where_far_more_is_left_out_than_roundings(patch)


FAULTS: dict[str, tuple[Patch, Callable[[], None]]] = {
    "the velocity that a piece leaves out is integrated twice too often": (
        in_text(air, "_integrals", "truncated / order +", "truncated / order**3 +"),
        _of_bound,
    ),
    "the box of a path has no size where it is held against a plane": (
        in_text(AirRootFinder, "_least_gap", "barrier(reach) * (1 + BUDGET)", "0"),
        test_air.test_a_piece_that_stays_on_one_side_of_the_end_s_plane_is_clear_of_it_and_no_other_is,
    ),
}
"""Faults by name, each with the test that must notice it."""


@pytest.fixture(autouse=True)
def _derived_anew() -> Iterator[None]:
    """Derive the kernels with the fault, and after it without."""
    for cached in (test_air.programs, test_air.program_of):
        cached.cache_clear()
    yield
    for cached in (test_air.programs, test_air.program_of):
        cached.cache_clear()


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_trips_its_check(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    fault, check = FAULTS[name]
    monkeypatch.setattr(
        model, "check", lambda _: None
    )  # what it refuses is to be noticed elsewhere
    fault(monkeypatch)
    with pytest.raises(AssertionError):
        check()
