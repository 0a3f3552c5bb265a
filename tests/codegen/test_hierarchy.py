"""Bodies in groups: those left out with their group would have been left out one by one."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events import grouping
from hoopgen.derive.events.grouping import MAX_GROUP_SIZE, MIN_GROUPED_BODIES, group_bodies
from hoopgen.derive.ir.event_tree import (
    BoundingVolumes,
    Call,
    ForEach,
    Group,
    If,
    While,
    check,
    live_before,
    reads,
)
from hoopgen.derive.ir.kernel import decision
from hoopgen.derive.state.fields import results
from hoopgen.derive.symbolic.conditionals import Less, all_of
from numpy.typing import NDArray

from hoopgen.codegen.c.compaction import CompactedLoop
from hoopgen.codegen.c.hierarchy import GroupContext, depths
from hoopgen.codegen.program import lower
from hoopgen.codegen.render import render_scene
from hoopgen.core.validation import check_leaving
from tests.codegen.test_shared_kernels import MIXED, assert_same, pins, sources, thrown
from tests.helpers.effort import trials
from tests.scene.test_example_scenes import numpy_engine

pytestmark = pytest.mark.xdist_group("kinds")

Kernels = dict[str, Any]


def cubes(places: NDArray[np.float64]) -> list[list[tuple[float, float]]]:
    return [[(float(c) - 0.1, float(c) + 0.1) for c in place] for place in places]


def scattered(count: int, seed: int = 1) -> NDArray[np.float64]:
    return np.random.default_rng(seed).uniform(-3, 3, (count, 3))


@pytest.mark.parametrize("count", [1, MAX_GROUP_SIZE, MAX_GROUP_SIZE + 1, 77, 400])
def test_every_body_is_in_one_group_and_groups_within_groups(count: int) -> None:
    order, members = group_bodies(cubes(scattered(count)))
    assert sorted(order) == list(range(count))
    row = 0
    for k, (group, depth) in enumerate(zip(members, depths(members), strict=True)):
        inner = members[k + 1 : group.after]
        if not inner:
            assert 0 < group.past - group.first <= MAX_GROUP_SIZE
            assert group.first == row
            row = group.past
        assert all(group.first <= other.first < other.past <= group.past for other in inner)
        assert sum(d == depth + 1 for d in depths(members)[k + 1 : group.after]) <= MAX_GROUP_SIZE
    assert row == count


def test_what_stands_apart_is_in_groups_of_its_own() -> None:
    near, far = scattered(3), scattered(77, 2) + (100, 0, 0)
    order, members = group_bodies(cubes(np.concatenate([near, far])))
    for group in members:
        own = order[group.first : group.past]
        assert len({k < len(near) for k in own}) == 1


def asked(count: int) -> int:
    """Return how many groups a flight asks that is far from all bodies but three."""
    near, far = scattered(3), scattered(count, 2) * 3 + (100, 0, 0)
    order, members = group_bodies(cubes(np.concatenate([near, far])))
    k = many = 0
    while k < len(members):
        many += 1
        met = any(j < len(near) for j in order[members[k].first : members[k].past])
        k = k + 1 if met else members[k].after
    return many


@pytest.mark.slow
def test_far_bodies_cost_less_than_in_proportion() -> None:
    """Not one look at each: no more for eight times as many."""
    assert [asked(count) for count in (37, 77, 157, 317)] <= [MAX_GROUP_SIZE] * 4
    assert asked(5000) <= MAX_GROUP_SIZE


@cache
def kernels_of(name: str) -> Kernels:
    place: Kernels = {}
    if name == "mixed":
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(grouping, "MIN_GROUPED_BODIES", 2)
            text = render_scene(MIXED.derive(), page=False, targets=["numpy"])["numpy/mixed.py"]
    else:
        text = sources(MIN_GROUPED_BODIES)["numpy/pins.py"]
    exec(text, place)
    return place


def called(place: Kernels, name: str, known: dict[str, Any]) -> dict[str, Any]:
    kernel: Callable[..., tuple[Any, ...]] = place[name]
    with np.errstate(all="ignore"):
        found = kernel(*(known[argument] for argument in place["ARGUMENTS"][name]))
    return dict(zip(place["OUTPUTS"][name], found, strict=True))


@pytest.mark.slow
def test_a_group_that_is_called_far_has_no_body_that_is_called_near() -> None:
    """This holds in floating point, for bodies and flights of all sizes, above all at the edge."""
    place = kernels_of("pins")
    rng = np.random.default_rng(5)
    count, skipped = trials(400_000), 0
    for bodies in (2, 5):
        scale = 10 ** rng.uniform(-3, 3, count)
        sizes = {
            f"p_pin0_{part}": scale * rng.normal(0, 1, (bodies, count))
            for part in ("radius", "centre_x", "centre_y", "centre_z")
        }
        sizes["p_pin0_radius"] = np.abs(sizes["p_pin0_radius"]) / 8
        known: dict[str, Any] = {
            "p_scale": 1.0,
            "p_ball_radius": 10 ** rng.uniform(-3, 0, count),
            **{f"middle_{axis}": scale * rng.normal(0, 3, count) for axis in "xyz"},
            **{f"reach_{axis}": scale * np.abs(rng.normal(0, 1, count)) for axis in "xyz"},
        }
        of = [{name: column[k] for name, column in sizes.items()} for k in range(bodies)]
        boxes = [called(place, "pin0_box", known | own) for own in of]
        box = {name: np.max([b[name] for b in boxes], axis=0) for name in boxes[0]}
        # On one axis, the flight ends where the group begins, but for a rounding or two.
        edge = -box["least_x"] - (box["wide_x"] + known["reach_x"])
        half = rng.random(count) < 0.5
        steps = edge * (1 + rng.integers(-2, 3, count) * 2.0**-53)
        known["middle_x"] = np.where(half, steps, known["middle_x"])
        far = ~called(place, "pin0_near_any", known | box)["near"]
        near = [called(place, "pin0_near", known | own)["near"] for own in of]
        assert not (far & np.any(near, axis=0)).any()
        skipped += int(far[half].sum())
    assert 0.1 < skipped / count < 0.95


BODIES = {"b": "sphere", "d": "cylinder", "f": "box", "j": "torus"}


@pytest.mark.slow
@pytest.mark.parametrize("body", BODIES, ids=BODIES.values())
def test_a_ball_out_of_a_groups_box_is_in_none_of_its_bodies(body: str) -> None:
    """Nor is that undecided: what is asked of a body there changes nothing."""
    place = kernels_of("mixed")
    rng = np.random.default_rng(6)
    count = trials(200_000)
    defaults = {place["VARIABLES"][n]: value for n, (value, *_) in place["PARAMETERS"].items()}
    known: dict[str, Any] = defaults | {
        "last": -1.0,
        "index": 0.0,
        "valid": 1.0,
        "undecided_time": 0.0,
    }
    box = called(place, f"{body}_box", known)
    known |= dict(zip("xyz", rng.normal(0, 1, (3, count)), strict=True))
    # Next to the box, too.
    least = box.get("least_x", None)
    if least is not None:
        known["x"] = np.where(
            rng.random(count) < 0.5,
            -least - box["wide_x"] - 10 ** rng.uniform(-16, -12, count),
            known["x"],
        )
        known["y"] = np.where(rng.random(count) < 0.5, box.get("most_y", 0.0), known["y"])
    known |= called(place, "measure", known)
    found = called(place, "valid", known)
    known |= {name: found[name] for name in ("blur", "leeway")}
    known |= {f"middle_{a}": known[a] for a in "xyz"} | {
        f"reach_{a}": found["leeway"] for a in "xyz"
    }
    out = ~called(place, f"{body}_near_any", known | box)["near"]
    started = called(place, f"{body}_start", known)
    assert (started["valid"][out] == 1).all()
    assert (started["undecided_time"][out] == 0).all()
    assert 0.3 < out.mean() < 1
    assert (started["valid"] < 1).any() or body == "j"


@pytest.mark.slow
def test_groups_change_no_bit(tmp_path: Path) -> None:
    """Without a look at the groups every result is the same."""
    engine = numpy_engine(pins(MIN_GROUPED_BODIES), tmp_path)
    states = thrown(600)
    states[:, 0] += np.random.default_rng(2).uniform(0, 9, len(states))
    # Some alone: in a batch of many some shot comes near every group.
    batches = [states, *(states[k : k + 1] for k in range(0, 600, 60))]
    fly = engine.simulate
    seen: list[int] = []
    near = engine.kernels._near

    def counted(table: Any, *rest: Any) -> Any:
        found = near(table, *rest)
        seen.append(len(table) - len(found))
        return found

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(engine.kernels, "_near", counted)
        group_bodies = [fly(s, {}, max_contacts=6, backend="numpy", record=True) for s in batches]
        patch.setattr(engine.kernels, "_near", lambda table, *rest: table)
        one_by_one = [fly(s, {}, max_contacts=6, backend="numpy", record=True) for s in batches]
    assert max(seen) > MIN_GROUPED_BODIES / 2
    for pair in zip(group_bodies, one_by_one, strict=True):
        assert_same(*pair)


def test_what_a_group_asks_is_read() -> None:
    own, total, here, widest = sp.symbols("own total here widest", real=True)
    adding = Call(decision("adding", {"total": total + own}, ""))
    box = Call(decision("box", {"widest": own}, ""))
    near = Call(decision("near", {"near": Less(here, widest)}, ""))
    each = ForEach(
        ("own",), (("a",), ("b",)), (adding,), BoundingVolumes(box, near, (Group(0, 2, 1),))
    )
    assert each.groups is not None
    assert each.groups.test_reads == {"here"}
    assert reads([each]) == live_before([each], []) == {"a", "b", "total", "here"}
    with pytest.raises(ValueError, match="unknown: here"):
        check([each], ["a", "b", "total"])


@pytest.mark.slow
def test_conditions_lie_in_each_other_as_deep_as_they_may() -> None:
    """There are as many conditions as a scene of hundreds of bodies has parameters."""
    x = sp.symbols("x", real=True)
    deep = decision("deep", {"all": all_of(*(Less(x, k) for k in range(5000)))}, "")
    program = lower(deep)
    assert program.cost == {"less": 5000, "both": 4999}
    few = lower(decision("few", {"all": all_of(*(Less(x, k) for k in range(3)))}, ""))
    names = [operation.name for operation in few.operations]
    assert names == ["argument", *["constant", "less"] * 2, "both", "constant", "less", "both"]


def test_bodies_have_numbers_that_results_can_hold() -> None:
    many = {
        len(names): results(names, ())
        for names in ([f"b{k}" for k in range(n)] for n in (128, 129))
    }
    assert {n: r[3].dtype for n, r in many.items()} == {128: "int8", 129: "int16"}
    names = [f"b{k}" for k in range(300)]
    assert check_leaving(127, 2, names) is not None
    with pytest.raises(ValueError, match="leaving: expected -1 to 127 of 300 surfaces, got 128"):
        check_leaving(128, 2, names)


def test_a_table_with_a_worklist_is_refused_within_another_worklist() -> None:
    """The list around it has no columns for the parameters of its rows."""
    own, total = sp.symbols("own total", real=True)
    adding = Call(decision("adding", {"total": total + own, "again": Less(total, own)}, ""))
    each = ForEach(("own",), (("p_a",), ("p_b",)), (While("again", 3, (adding,)),))
    loop = CompactedLoop(
        prefix="own", costs={"adding": 1}, max_inline_cost=0, parameters=("p_a", "p_b")
    )
    around = GroupContext("", {"total": "double", "again": "truth", "asked": "truth"})
    assert loop.passes([each], around, {"total"})
    with pytest.raises(AssertionError, match=r"within the worklist 'asked_'.*rows \(own\)"):
        loop.passes([If("asked", (each,))], around, {"total"})
