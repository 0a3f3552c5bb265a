"""Batches of shots, replayed on every engine: outcomes, bits, physics, event log."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from decimal import Decimal
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import hoopgen
from hoopgen import PAPER, Outcome
from hoopgen.engine import numpy_backend, numpy_flights
from hoopgen.engine.result_arrays import ResultArrays
from hoopgen.simulation import run as run_module
from tests.helpers.effort import occurrences, trials
from tests.helpers.engines import Simulate
from tests.helpers.hoop_shots import Batch
from tests.helpers.march import Flown

EPS = float(np.finfo(np.float64).eps)
RING, BACKBOARD, BRIDGE, END = range(4)
FIELDS = ("outcome", "contacts", "counts", "first", "time", "state", "uncertain")
BOUNDS = ("time_error", "state_error")
REACH = PAPER["ball_radius"] + PAPER["wire_radius"]
SWIRL = [0.2286, -0.94488, -0.6096, -0.8382, 2.1336, 3.85572, 0.0, 0.0, 0.0]  # Table 3, case 6b


def shot(**columns: float) -> list[float]:
    """Give a state by the columns that are not zero."""
    return [columns.get(name, 0.0) for name in ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")]


def everything(simulate: Simulate, batch: Batch, **options: Any) -> dict[str, NDArray[Any]]:
    """Give every result, the bounds and the event log too."""
    shots = simulate(batch.states, batch.parameters, fields=FIELDS + BOUNDS, record=True, **options)
    return {name: getattr(shots, name) for name in (*FIELDS, *BOUNDS, "events")}


def assert_same_bits(got: Mapping[str, NDArray[Any]], wanted: Mapping[str, NDArray[Any]]) -> None:
    assert got.keys() == wanted.keys()
    for name, array in wanted.items():
        # NaN, and the sign of zero, included.
        if got[name].tobytes() != array.tobytes():
            np.testing.assert_array_equal(got[name], array, err_msg=name)
            raise AssertionError(f"{name}: equal, but for the bits of a NaN or a zero")


def of_shots(results: Mapping[str, NDArray[Any]], rows: Any) -> dict[str, NDArray[Any]]:
    """Give the results of some of the shots; the event log without its shot numbers."""
    events = results["events"]
    order = np.arange(len(results["outcome"]))[rows]
    low, high = (np.searchsorted(events["shot"], order, side) for side in ("left", "right"))
    log = np.concatenate([np.arange(a, b) for a, b in zip(low, high, strict=True)])
    picked = {n: a[order] for n, a in results.items() if n != "events"}
    return picked | {
        f"events, {name}": np.ascontiguousarray(events[name][log])
        for name in ("surface", "time", "before", "after")
    }


# --------------------------------------------------------------------------------------- outcomes


def test_a_swish_is_made_and_touches_nothing(simulate: Simulate, fly: Callable[..., Flown]) -> None:
    release = hoopgen.release(7.166, math.radians(51.1), height=2.4384, distance=4.191, angle=0.3)
    # Straight through the centre of the end plane: vx so that x = 0 there.
    fall = (release[5] + math.sqrt(release[5] ** 2 + 2 * 9.81 * (release[2] + 0.024256))) / 9.81
    release[3:5] = -release[:2] / fall
    shots = simulate(release, record=True)
    assert shots.outcome[0] == Outcome.MADE
    assert shots.contacts[0] == 0
    assert shots.counts[0].tolist() == [0, 0, 0]
    assert shots.first[0] == -1
    assert not shots.uncertain[0]
    assert shots.events["surface"].tolist() == [END]
    # A square root, a sum and a quotient: no more than 4 roundings.
    assert abs(Decimal(float(shots.time[0])) - fly(release).time) <= 4 * EPS * shots.time[0]


def test_a_ball_that_falls_beside_the_ring_is_missed(simulate: Simulate) -> None:
    shots = simulate(shot(x=1.0, z=1.0))
    assert shots.outcome[0] == Outcome.MISSED
    assert shots.contacts[0] == 0
    assert shots.state[0, 0] == 1.0


@pytest.mark.parametrize("off_axis", [0.0, 5e-324, 1e-300, 1e-160, 1e-20, 1e-9, 0.09])
@pytest.mark.parametrize("rise", [0.0, 3.0])
def test_a_vertical_drop_through_the_hole_is_made(
    simulate: Simulate, fly: Callable[..., Flown], off_axis: float, rise: float
) -> None:
    release = shot(x=off_axis, y=-off_axis / 2, z=0.5, vz=rise)
    shots = simulate(release)
    assert shots.outcome[0] == Outcome.MADE
    assert shots.contacts[0] == 0
    assert not shots.uncertain[0]
    assert shots.state[0, :2].tolist() == release[:2]
    true = fly(release)
    assert abs(Decimal(float(shots.time[0])) - true.time) <= 4 * EPS * shots.time[0]


@pytest.mark.parametrize("spin", [0.0, 50.0])
def test_a_vertical_drop_on_the_top_of_the_wire_stays_above_it(
    simulate: Simulate, spin: float
) -> None:
    # The normal is vertical, so only spin across it can move the ball sideways.
    release = shot(y=PAPER["ring_radius"], z=0.6, wz=spin)
    shots = simulate(release, record=True)
    assert shots.outcome[0] == Outcome.CAPPED
    assert shots.counts[0].tolist() == [40, 0, 0]
    assert np.all(shots.events["after"][:, 1] == PAPER["ring_radius"])
    # The normal is vertical but for a rounding of its length in each contact.
    np.testing.assert_allclose(shots.events["after"][:, 8], spin, rtol=4 * 40 * EPS, atol=0)


@pytest.mark.parametrize(
    ("release", "touched"),
    [
        (shot(x=1.0, z=-0.5), []),  # below and falling
        (shot(x=1.0, z=-0.5, vz=3.0), []),  # rises, but not as high as the end plane
        (shot(x=-0.8, z=-0.3, vx=1.0, vz=-0.1), []),  # behind the board
        (shot(x=0.0, z=-0.5, vz=1.0), []),  # into the hole from below, and back
        (shot(x=PAPER["ring_radius"], z=-0.5, vz=5.0), [RING]),  # against the wire from below
        (shot(x=0.5, z=-0.139, vx=-300.0, vz=0.1), [BACKBOARD]),  # below the ring, onto the board
    ],
)
def test_a_ball_that_never_comes_down_through_the_end_plane_is_short(
    simulate: Simulate, release: list[float], touched: list[int]
) -> None:
    shots = simulate(release, record=True)
    assert shots.outcome[0] == Outcome.SHORT
    assert shots.events["surface"].tolist() == touched
    assert shots.contacts[0] == len(touched)
    assert shots.first[0] == (touched[0] if touched else -1)
    last = shots.events[-1] if touched else {"time": 0.0, "after": np.array(release)}
    assert shots.time[0] == last["time"]
    np.testing.assert_array_equal(shots.state[0], last["after"])


def test_a_short_shot_that_is_clear_of_everything_is_not_uncertain(simulate: Simulate) -> None:
    shots = simulate([shot(x=1.0, z=-0.5), shot(x=1.0, z=-0.5, vz=3.0)])
    assert shots.outcome.tolist() == [Outcome.SHORT] * 2
    assert shots.uncertain.tolist() == [False] * 2


def test_a_ball_above_the_end_plane_is_never_short(simulate: Simulate, mixed: Batch) -> None:
    # It comes down through it, whatever it does before: gravity sees to that.
    some = mixed.take(slice(None, None, 5))
    for restitution in (0.0, 0.3, 1.0):
        shots = simulate(some.states, dict(some.parameters) | {"restitution": restitution})
        above = shots.state[:, 2] > -some.parameters["end_depth"]
        assert not np.any(above & (shots.outcome == Outcome.SHORT))


@pytest.mark.parametrize("most", [1, 2, 3, 5, 8])
def test_a_shot_is_capped_at_max_contacts_on_the_path_it_takes_anyway(
    simulate: Simulate, most: int
) -> None:
    whole = simulate(SWIRL, record=True)
    capped = simulate(SWIRL, max_contacts=most, record=True)
    assert capped.outcome[0] == Outcome.CAPPED
    assert capped.contacts[0] == most
    np.testing.assert_array_equal(capped.events, whole.events[:most])
    assert capped.time[0] == whole.events["time"][most - 1]
    np.testing.assert_array_equal(capped.state[0], whole.events["after"][most - 1])


def test_max_contacts_that_are_not_reached_change_nothing(simulate: Simulate) -> None:
    whole = simulate(SWIRL, record=True)
    assert whole.outcome[0] != Outcome.CAPPED
    more = simulate(SWIRL, max_contacts=int(whole.contacts[0]) + 1, record=True)
    np.testing.assert_array_equal(more.events, whole.events)
    assert more.outcome[0] == whole.outcome[0]


@pytest.mark.parametrize("restitution", [0.0, 0.3, 0.7, 1.0])
def test_the_normal_speed_is_turned_and_scaled_by_the_restitution(
    simulate: Simulate, mixed: Batch, restitution: float
) -> None:
    shots = simulate(
        mixed.states[::5], PAPER | {"restitution": restitution}, max_contacts=3, record=True
    )
    log = contacts_of(shots.events)
    normal = normals(log, PAPER)
    before, after = (np.sum(normal * log[w][:, 3:6], axis=1) for w in ("before", "after"))
    assert np.all(np.abs(after + restitution * before) <= roundings(log))


def test_with_restitution_1_a_drop_on_the_bridge_comes_back_to_its_height(
    simulate: Simulate,
) -> None:
    release = shot(x=-0.25, z=0.5)
    shots = simulate(release, PAPER | {"restitution": 1.0}, max_contacts=10, record=True)
    assert shots.counts[0].tolist() == [0, 0, 10]
    heights = REACH + shots.events["after"][:, 5] ** 2 / (2 * PAPER["gravity"])
    # Six roundings a hop.
    np.testing.assert_allclose(heights, 0.5, rtol=6 * 10 * EPS, atol=0)


@pytest.mark.parametrize("push", [{}, {"vx": 0.5}, {"vy": -0.3}, {"wz": 9.0}])
def test_a_ball_that_lies_or_rolls_on_the_bridge_is_capped_at_once(
    simulate: Simulate, push: dict[str, float]
) -> None:
    radius = PAPER["ball_radius"]
    rolling = {"wy": push.get("vx", 0.0) / radius, "wx": -push.get("vy", 0.0) / radius}
    release = shot(x=-0.25, z=REACH, **push, **rolling)
    shots = simulate(release, record=True)
    assert shots.outcome[0] == Outcome.CAPPED
    assert shots.counts[0].tolist() == [0, 0, 40]
    assert shots.time[0] == 0.0
    assert shots.state[0, :3].tolist() == release[:3]
    # It rolls already, so every contact changes its motion by no more than 4 roundings.
    np.testing.assert_allclose(shots.state[0, 3:], release[3:], rtol=4 * 40 * EPS, atol=0)


def test_without_restitution_a_drop_on_the_bridge_stays_where_it_lands(simulate: Simulate) -> None:
    shots = simulate(shot(x=-0.25, z=0.5), PAPER | {"restitution": 0.0}, record=True)
    assert shots.outcome[0] == Outcome.CAPPED
    assert shots.counts[0].tolist() == [0, 0, 40]
    assert np.unique(shots.events["time"]).size == 1
    assert shots.state[0, 2] == REACH
    assert shots.state[0, 5] == 0.0


def test_hops_on_the_bridge_shrink_by_the_restitution(simulate: Simulate) -> None:
    release = shot(x=-0.25, z=0.5)
    shots = simulate(release, record=True)
    assert shots.counts[0].tolist() == [0, 0, 40]
    hops = np.diff(shots.events["time"])
    fall = math.sqrt(2 * (0.5 - REACH) / PAPER["gravity"])
    # The clock is rounded to an eps of itself, a hop to a few of its own.
    clock = shots.events["time"][1:]
    wanted = 2 * fall * PAPER["restitution"] ** np.arange(1, 40)
    assert np.all(np.abs(hops - wanted) <= 2 * EPS * clock + 40 * 4 * EPS * wanted)


# ---------------------------------------------------------------- where surfaces are, and are not


def test_a_ball_that_rises_through_the_bridge_s_height_meets_it_on_the_way_down(
    simulate: Simulate, fly: Callable[..., Flown]
) -> None:
    release = shot(x=-0.375, y=0.02, z=-0.5, vz=4.5)
    shots = simulate(release, max_contacts=1, record=True)
    assert shots.events["surface"].tolist() == [BRIDGE]
    event = shots.events[0]
    assert event["before"][5] < 0.0 < event["after"][5]
    assert event["time"] > 4.5 / PAPER["gravity"]  # later than the top
    true = fly(release, max_contacts=1)
    assert true.events[0][0] == "bridge"
    assert abs(Decimal(float(event["time"])) - true.time) <= 4 * EPS * event["time"]


@pytest.mark.parametrize("speed", [0.5, 3.0])
def test_a_ball_from_behind_the_board_passes_freely(simulate: Simulate, speed: float) -> None:
    release = shot(x=-1.0, y=0.5, z=0.2, vx=speed, vz=3.0)
    shots = simulate(release, record=True)
    assert shots.events["surface"].tolist() == [END]
    assert shots.outcome[0] == Outcome.MISSED
    assert shots.state[0, 3] == speed


@pytest.mark.parametrize(
    ("y", "z", "meets"),
    [
        (0.9144, 0.5, True),  # on the edge still counts (Eq. 2 is <=)
        (math.nextafter(0.9144, 1.0), 0.5, False),
        (-0.9144, 0.5, True),
        (math.nextafter(-0.9144, -1.0), 0.5, False),
        (0.95, 0.5, False),
        (0.9, 1.1, False),
    ],
)
def test_the_backboard_ends_at_its_edges(
    simulate: Simulate, y: float, z: float, meets: bool
) -> None:
    # So fast that gravity moves the ball by less than it takes to matter.
    shots = simulate(shot(x=1.0, y=y, z=z, vx=-1000.0))
    assert shots.counts[0].tolist() == [0, int(meets), 0]
    assert shots.uncertain[0] == (abs(abs(y) - 0.9144) < 1e-9)


@pytest.mark.parametrize(
    ("x", "y", "meets"),
    [
        (-0.25, 0.0762, True),
        (-0.25, math.nextafter(0.0762, 1.0), False),
        (-0.25, -0.0762, True),
        (-0.381, 0.0, True),  # under the board, which has only a front
        (math.nextafter(-0.381, -1.0), 0.0, False),
        (-0.235, 0.0, True),  # on the circle where bridge and ring join, the bridge
    ],
)
def test_the_bridge_ends_at_its_edges(simulate: Simulate, x: float, y: float, meets: bool) -> None:
    shots = simulate(shot(x=x, y=y, z=1.0), max_contacts=1)
    assert shots.counts[0, BRIDGE] == int(meets)
    assert shots.uncertain[0]  # an edge is nearer than rounding can tell


def test_in_front_of_the_ring_there_is_no_bridge(simulate: Simulate) -> None:
    shots = simulate(shot(x=0.30, z=0.2), max_contacts=1)
    assert shots.counts[0].tolist() == [1, 0, 0]


# ------------------------------------------------------------------------------------------- bits


@pytest.fixture(scope="session")
def by_numpy(mixed: Batch) -> dict[str, NDArray[Any]]:
    return everything(lambda *a, **k: hoopgen.simulate(*a, backend="numpy", **k), mixed)


def test_every_engine_gives_the_same_bits(
    simulate: Simulate, mixed: Batch, by_numpy: dict[str, NDArray[Any]]
) -> None:
    assert len(mixed) >= occurrences(20_000)
    assert_same_bits(everything(simulate, mixed), by_numpy)


def test_the_mixed_shots_show_every_outcome_and_every_surface(
    by_numpy: dict[str, NDArray[Any]],
) -> None:
    assert np.all(np.bincount(by_numpy["outcome"], minlength=5) > occurrences(50))
    assert np.all(by_numpy["counts"].sum(axis=0) > occurrences(1000))
    assert set(by_numpy["first"]) == {-1, RING, BACKBOARD, BRIDGE}
    assert 0 < by_numpy["uncertain"].sum() < len(by_numpy["uncertain"])


@pytest.mark.sampled(12)
@pytest.mark.parametrize("threads", [2, None])
def test_threads_do_not_change_a_bit(
    simulate: Simulate,
    mixed: Batch,
    threads: int | None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    some = mixed.take(slice(None, None, 30))
    wanted = everything(simulate, some, threads=1)
    monkeypatch.setattr(run_module, "LOG_ROWS_AT_ONCE", 97 * 41)
    monkeypatch.setattr(run_module, "MAX_CONTACTS_WITHOUT_THREADS", 97 * 40)
    monkeypatch.setattr(run_module, "MIN_SHOTS_PER_THREAD", 97)
    assert_same_bits(everything(simulate, some, threads=threads), wanted)
    unrecorded = simulate(some.states, some.parameters, threads=threads)
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(unrecorded, name), wanted[name])


@pytest.mark.slow
def test_parts_in_numpy_leave_their_last_shots_to_each_other(
    mixed: Batch, monkeypatch: pytest.MonkeyPatch
) -> None:
    some, taken = mixed.take(slice(None, None, 7)), dict[numpy_flights.Flights, list[int]]()
    last_of_part = len(some) // 10
    wanted = hoopgen.simulate(some.states, some.parameters, backend="numpy", threads=1)
    monkeypatch.setattr(
        run_module, "MAX_CONTACTS_WITHOUT_THREADS", len(some) * 1000
    )  # one part after the other
    monkeypatch.setattr(run_module, "MIN_SHOTS_PER_THREAD", len(some) // 3)
    monkeypatch.setattr(numpy_backend, "MIN_SHOTS_PER_THREAD", last_of_part)
    advance = numpy_flights.Flights.advance

    def counted(flights: numpy_flights.Flights, out: ResultArrays) -> None:
        taken.setdefault(flights, []).append(len(flights.row))
        advance(flights, out)

    monkeypatch.setattr(numpy_flights.Flights, "advance", counted)
    got = hoopgen.simulate(some.states, some.parameters, backend="numpy", threads=3)
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(got, name), getattr(wanted, name))
    *others, last = list(taken.values())[:3]  # further ones tighten bounds
    assert len(others) == 2
    assert min(map(min, others)) > last_of_part
    assert max(map(len, others)) < len(last)
    assert min(last) <= last_of_part


@pytest.mark.sampled(13)
@pytest.mark.parametrize("size", [1, 7])
def test_chunks_and_blocks_do_not_change_a_bit(
    simulate: Simulate, mixed: Batch, size: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    some = mixed.take(slice(None, None, 500))
    wanted = everything(simulate, some)
    monkeypatch.setattr(numpy_backend, "BLOCK_SIZE", size + 1)
    monkeypatch.setattr(run_module, "LOG_ROWS_AT_ONCE", 3 * size * 41)
    assert_same_bits(everything(simulate, some), wanted)


def test_the_order_of_the_rows_does_not_change_a_bit(simulate: Simulate, mixed: Batch) -> None:
    some = mixed.take(slice(None, None, 14))
    order = np.random.default_rng(3).permutation(len(some))
    wanted = of_shots(everything(simulate, some), order)
    got = of_shots(everything(simulate, some.take(order)), slice(None))
    assert_same_bits(got, wanted)


def test_a_row_with_its_own_parameters_is_the_shot_alone(simulate: Simulate, mixed: Batch) -> None:
    # 0-dimensional parameters here, one per shot there.
    rows = np.flatnonzero(mixed.parameters["gravity"] != PAPER["gravity"])[::70]
    together = everything(simulate, mixed.take(rows))
    for k, row in enumerate(rows):
        alone = {n: float(np.broadcast_to(v, len(mixed))[row]) for n, v in mixed.parameters.items()}
        got = everything(simulate, Batch(mixed.states[[row]], alone))
        assert_same_bits(of_shots(got, [0]), of_shots(together, [k]))


def test_the_mirror_image_of_a_shot_is_its_image_bit_for_bit(
    simulate: Simulate, mixed: Batch
) -> None:
    # Spin is an axial vector: of it, the component across the mirror stays.
    sign = np.array([1, -1, 1, 1, -1, 1, -1, 1, -1])
    some = mixed.take(slice(None, None, 7))
    got = everything(simulate, Batch(some.states * sign, some.parameters))
    wanted = everything(simulate, some)
    for name in ("outcome", "contacts", "counts", "first", "time"):
        np.testing.assert_array_equal(got[name], wanted[name], err_msg=name)
    np.testing.assert_array_equal(got["state"], wanted["state"] * sign)
    for name in ("shot", "surface", "time"):
        np.testing.assert_array_equal(got["events"][name], wanted["events"][name])
    for name in ("before", "after"):
        np.testing.assert_array_equal(got["events"][name], wanted["events"][name] * sign)


def test_the_same_call_twice_gives_the_same_bits_and_leaves_its_input_alone(
    simulate: Simulate, mixed: Batch
) -> None:
    some = mixed.take(slice(None, None, 20))
    states = some.states.copy()
    once, again = everything(simulate, some), everything(simulate, some)
    assert_same_bits(again, once)
    np.testing.assert_array_equal(some.states, states)


def test_arrays_that_must_not_be_written_are_read(simulate: Simulate, mixed: Batch) -> None:
    some = mixed.take(slice(None, None, 500))
    states = some.states.copy()
    gravity = np.linspace(9.0, 10.0, len(states))
    wanted = simulate(states, {"gravity": gravity})
    states.flags.writeable = gravity.flags.writeable = False
    got = simulate(states, {"gravity": gravity})
    assert got.state.tobytes() == wanted.state.tobytes()
    one, _ = np.broadcast_arrays(states[0], np.zeros((1, 9)))  # its buffer must not be written
    assert simulate(one, {"gravity": gravity[0]}).time[0] == wanted.time[0]


def test_parameters_that_changed_since_the_last_call_are_read_anew(simulate: Simulate) -> None:
    drop, parameters = np.array([0.0, 0.0, 1.0, *np.zeros(6)]), {"gravity": 9.81}
    before = simulate(drop, parameters).time
    parameters["gravity"] = 1.62
    drop[2] = 2.0
    after = simulate(drop, parameters).time
    assert after.tobytes() == simulate(drop.copy(), {"gravity": 1.62}).time.tobytes()
    assert after > before


def test_a_shot_goes_on_from_any_of_its_contacts_to_the_same_end(
    simulate: Simulate, mixed: Batch
) -> None:
    # The search does not depend on the errors that a shot has gathered, so neither do the bits.
    whole = simulate(mixed.states[::20], PAPER, record=True)
    log = contacts_of(whole.events)
    number = np.arange(len(log)) - np.searchsorted(log["shot"], log["shot"]) + 1
    # A ball that came through the board from behind may touch the ring inside it: no start.
    in_front = log["after"][:, 0] >= PAPER["ball_radius"] - PAPER["board_distance"]
    usable = in_front & (whole.contacts[log["shot"]] < 40)
    log, number = log[usable], number[usable]
    rest = simulate(log["after"], PAPER, leaving=log["surface"], record=True)
    np.testing.assert_array_equal(rest.outcome, whole.outcome[log["shot"]])
    np.testing.assert_array_equal(rest.state, whole.state[log["shot"]])
    np.testing.assert_array_equal(rest.contacts, whole.contacts[log["shot"]] - number)
    # Times are sums from the start, so they are rounded otherwise: half an eps for each contact.
    there = whole.time[log["shot"]]
    assert np.all(np.abs(log["time"] + rest.time - there) <= 41 * EPS * there)


# -------------------------------------------------------------------------------------- the truth


@pytest.mark.slow
@pytest.mark.parametrize("scene", ["PAPER", "NBA, livelier"])
def test_what_is_not_uncertain_is_what_truly_happens_within_the_shot_s_own_bounds(
    scene: str,
    fly: Callable[..., Flown],
    families: Callable[[int, int], dict[str, NDArray[np.float64]]],
) -> None:
    parameters = PAPER if scene == "PAPER" else hoopgen.NBA | {"restitution": 0.9}
    names = (*hoopgen.SURFACES, "end")
    decided = 0
    beyond = []
    for kind, states in families(trials(25, at_least=8), 7).items():
        shots = hoopgen.simulate(
            states, parameters, max_contacts=12, fields=FIELDS + BOUNDS, record=True
        )
        for row in np.flatnonzero(~shots.uncertain & (shots.outcome != Outcome.INVALID)):
            true = fly(states[row], parameters, max_contacts=12)
            events = shots.events[shots.events["shot"] == row]
            sequence = [names[surface] for surface in events["surface"]]
            assert sequence == [surface for surface, _ in true.events], (kind, states[row])
            assert Outcome(shots.outcome[row]).name == true.outcome, (kind, states[row])
            errors = [abs(Decimal(float(shots.time[row])) - true.time)]
            for k in (0, 3, 6):
                pairs = zip(shots.state[row, k : k + 3], true.state[k : k + 3], strict=True)
                errors.append(max(abs(Decimal(float(a)) - b) for a, b in pairs))
            bounds = [shots.time_error[row], *shots.state_error[row]]
            if any(error > bound for error, bound in zip(errors, bounds, strict=True)):
                beyond.append((kind, states[row].tolist(), [float(e) for e in errors], bounds))
            decided += 1
    assert decided > occurrences(100)
    assert beyond == []


# ----------------------------------------------------------------------------- physics of the log


@pytest.fixture(scope="session")
def recorded(simulate: Simulate, mixed: Batch) -> hoopgen.Shots:
    """A third of the mixed shots on one hoop, with the event log."""
    return simulate(mixed.states[::3], PAPER, record=True)


def contacts_of(events: NDArray[Any]) -> NDArray[Any]:
    return events[events["surface"] != END]


def normals(events: NDArray[Any], parameters: Mapping[str, Any]) -> NDArray[np.float64]:
    """Give Table 2's normals at the contacts."""
    x, y, z = events["after"][:, :3].T
    rho = np.hypot(x, y)
    out = 1 - parameters["ring_radius"] / rho
    reach = parameters["ball_radius"] + parameters["wire_radius"]
    ring = np.stack([x * out, y * out, z], axis=1) / reach
    fixed = np.array([[0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 0, 1]], dtype=float)
    surface = events["surface"]
    return np.where((surface == RING)[:, None], ring, fixed[surface])


def sizes(log: NDArray[Any]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Give the speed that rounding is measured by, spin included, and the size of the position."""
    before = log["before"]
    spin = PAPER["ball_radius"] * np.linalg.norm(before[:, 6:], axis=1)
    return np.linalg.norm(before[:, 3:6], axis=1) + spin, np.linalg.norm(before[:, :3], axis=1)


def off_ring(log: NDArray[Any]) -> NDArray[np.float64]:
    """Give how far the contacts with the ring are from it, m; 0 for other surfaces."""
    x, y, z = log["after"][:, :3].T
    away = np.hypot(np.hypot(x, y) - PAPER["ring_radius"], z) - REACH
    return np.where(log["surface"] == RING, np.abs(away), 0.0)


def roundings(log: NDArray[Any]) -> NDArray[np.float64]:
    """Give how far a sum over a contact, of velocities, may be from zero.

    Some ten roundings of each side; and the computed normal is longer or shorter than 1 by how far
    the place is off the ring, over R, which enters the impact to second order on each side.
    """
    speed, _ = sizes(log)
    return speed * (32 * EPS + 4 * off_ring(log) / REACH)


def test_a_contact_does_not_move_the_ball(recorded: hoopgen.Shots) -> None:
    log = contacts_of(recorded.events)
    moved = log["after"][:, :3] - log["before"][:, :3]
    assert np.all(moved[log["surface"] == RING] == 0.0)
    # A plane takes the ball onto itself, along its normal: by the roundings of the flight to it.
    across = {BACKBOARD: [1, 2], BRIDGE: [0, 1]}
    for surface, kept in across.items():
        assert np.all(moved[log["surface"] == surface][:, kept] == 0.0)
    speed, size = sizes(log)
    assert np.all(np.abs(moved).max(axis=1) <= 8 * EPS * (1 + size + speed * log["time"]))


def test_contacts_lie_on_their_surfaces(recorded: hoopgen.Shots) -> None:
    log = contacts_of(recorded.events)
    x, _, z = log["after"][:, :3].T
    on_board, on_bridge = (log["surface"] == s for s in (BACKBOARD, BRIDGE))
    assert np.all(x[on_board] == PAPER["ball_radius"] - PAPER["board_distance"])
    assert np.all(z[on_bridge] == REACH)
    # Four roundings of the way there; over a swirl they add up, no contact takes the ball back.
    speed, size = sizes(log)
    number = np.arange(len(log)) - np.searchsorted(log["shot"], log["shot"]) + 1
    assert np.all(off_ring(log) <= 4 * EPS * number * (1 + size + speed))


def test_the_end_lies_on_the_end_plane_and_is_crossed_downwards(recorded: hoopgen.Shots) -> None:
    ends = recorded.events[recorded.events["surface"] == END]
    np.testing.assert_array_equal(ends["before"], ends["after"])
    assert np.all(ends["after"][:, 5] < 0.0)
    speed, size = sizes(ends)
    away = np.abs(ends["after"][:, 2] + PAPER["end_depth"])
    assert np.all(away <= 8 * EPS * (1 + size + speed * ends["time"]))
    made = np.hypot(*ends["after"][:, :2].T) <= PAPER["ring_radius"]
    np.testing.assert_array_equal(
        recorded.outcome[ends["shot"]], np.where(made, Outcome.MADE, Outcome.MISSED)
    )


def test_the_ball_arrives_from_outside_and_leaves_outwards(recorded: hoopgen.Shots) -> None:
    log = contacts_of(recorded.events)
    log = log[~recorded.uncertain[log["shot"]]]
    normal = normals(log, PAPER)
    before, after = (np.sum(normal * log[w][:, 3:6], axis=1) for w in ("before", "after"))
    assert np.all(before < 0.0)
    assert np.all(after > 0.0)


def test_energy_never_rises_at_a_contact(recorded: hoopgen.Shots) -> None:
    # Per mass: v²/2 + R² w²/3 for a thin shell; the place, and so the height, stays.
    log = contacts_of(recorded.events)

    def energy(states: NDArray[np.float64]) -> NDArray[np.float64]:
        spin = PAPER["ball_radius"] * states[:, 6:]
        return np.sum(states[:, 3:6] ** 2, axis=1) / 2 + np.sum(spin**2, axis=1) / 3

    # Components are rounded about eight times, their squares twice that.
    before = energy(log["before"])
    assert np.all(energy(log["after"]) <= before * (1 + 32 * EPS))


def test_the_angular_momentum_about_the_point_of_contact_is_kept(recorded: hoopgen.Shots) -> None:
    # The impulse acts there. Per mass: R n × v + (2/3) R² w.
    log = contacts_of(recorded.events)
    normal, radius = normals(log, PAPER), PAPER["ball_radius"]

    def momentum(states: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.cross(normal, states[:, 3:6]) + 2 / 3 * radius * states[:, 6:]

    change = np.abs(momentum(log["after"]) - momentum(log["before"])).max(axis=1)
    assert np.all(change <= roundings(log))


def test_the_ball_leaves_a_contact_rolling(recorded: hoopgen.Shots) -> None:
    log = contacts_of(recorded.events)
    normal, after = normals(log, PAPER), log["after"]
    slip = after[:, 3:6] - PAPER["ball_radius"] * np.cross(after[:, 6:], normal)
    slip -= np.sum(slip * normal, axis=1)[:, None] * normal
    assert np.all(np.abs(slip).max(axis=1) <= roundings(log))


def test_between_events_the_ball_flies_by_equation_3(recorded: hoopgen.Shots, mixed: Batch) -> None:
    log = recorded.events
    opens = np.r_[True, np.diff(log["shot"]) > 0]
    previous = np.roll(log["after"], 1, axis=0)
    start = np.where(opens[:, None], mixed.states[::3][log["shot"]], previous)
    t = log["time"] - np.where(opens, 0.0, np.roll(log["time"], 1))
    assert np.all(t >= 0.0)
    wanted = start.copy()
    wanted[:, :3] += start[:, 3:6] * t[:, None]
    wanted[:, 2] -= PAPER["gravity"] * t**2 / 2
    wanted[:, 5] -= PAPER["gravity"] * t
    # t is a difference of clocks, each rounded to half an eps of itself; then a few roundings.
    late = EPS * log["time"]
    speed = np.linalg.norm(start[:, 3:6], axis=1) + PAPER["gravity"] * t
    size = np.linalg.norm(start[:, :3], axis=1) + speed * t
    error = np.abs(log["before"] - wanted)
    assert np.all(error[:, :3].max(axis=1) <= speed * late + 4 * EPS * size)
    assert np.all(error[:, 5] <= PAPER["gravity"] * late + 4 * EPS * speed)
    np.testing.assert_array_equal(log["before"][:, [3, 4, 6, 7, 8]], start[:, [3, 4, 6, 7, 8]])


# ---------------------------------------------------------------------- the log and the summaries


def test_the_log_is_in_order_of_shot_then_time(recorded: hoopgen.Shots) -> None:
    log = recorded.events
    step = np.diff(log["shot"])
    assert np.all(step >= 0)
    assert np.all(np.diff(log["time"])[step == 0] >= 0.0)
    # Nothing comes after the end.
    assert np.all(step[log["surface"][:-1] == END] > 0)


def test_results_agree_with_the_log(recorded: hoopgen.Shots, mixed: Batch) -> None:
    log, shots = recorded.events, len(recorded)
    touched = contacts_of(log)
    counts = np.zeros((shots, 3), int)
    np.add.at(counts, (touched["shot"], touched["surface"]), 1)
    np.testing.assert_array_equal(recorded.counts, counts)
    np.testing.assert_array_equal(recorded.contacts, counts.sum(axis=1))

    first = np.full(shots, -1)
    who, row = np.unique(touched["shot"], return_index=True)
    first[who] = touched["surface"][row]
    np.testing.assert_array_equal(recorded.first, first)

    valid = recorded.outcome != Outcome.INVALID
    time, state = np.zeros(shots), mixed.states[::3].copy()
    time[log["shot"]] = log["time"]  # the last one written is the last one of the shot
    state[log["shot"]] = log["after"]
    np.testing.assert_array_equal(recorded.time[valid], time[valid])
    np.testing.assert_array_equal(recorded.state[valid], state[valid])

    ended = np.zeros(shots, bool)
    ended[log["shot"][log["surface"] == END]] = True
    over = np.isin(recorded.outcome, [Outcome.MADE, Outcome.MISSED])
    np.testing.assert_array_equal(over, ended)
    np.testing.assert_array_equal(recorded.outcome == Outcome.CAPPED, recorded.contacts == 40)
    assert not np.any(np.isin(np.flatnonzero(~valid), log["shot"]))


def test_recording_does_not_change_the_results(
    simulate: Simulate, recorded: hoopgen.Shots, mixed: Batch
) -> None:
    plain = simulate(mixed.states[::3], PAPER)
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(plain, name), getattr(recorded, name))


@pytest.mark.sampled(29)
@pytest.mark.parametrize("name", FIELDS + BOUNDS)
def test_a_field_alone_is_the_field_among_all(simulate: Simulate, mixed: Batch, name: str) -> None:
    some = mixed.take(slice(None, None, 50))
    alone = simulate(some.states, some.parameters, fields=[name])
    wanted = everything(simulate, some)[name]
    np.testing.assert_array_equal(getattr(alone, name), wanted)
    for other in {*FIELDS, *BOUNDS} - {name}:
        with pytest.raises(AttributeError, match=f"^{other}: not among the fields asked for"):
            getattr(alone, other)


def test_dtypes_and_shapes_are_those_documented(simulate: Simulate) -> None:
    shots = simulate([SWIRL, SWIRL], fields=FIELDS + BOUNDS, record=True)
    kinds = {name: (getattr(shots, name).dtype.name, getattr(shots, name).shape) for name in FIELDS}
    assert kinds == {
        "outcome": ("uint8", (2,)),
        "contacts": ("int32", (2,)),
        "counts": ("int32", (2, 3)),
        "first": ("int8", (2,)),
        "time": ("float64", (2,)),
        "state": ("float64", (2, 9)),
        "uncertain": ("bool", (2,)),
    }
    assert shots.time_error.shape == (2,)
    assert shots.state_error.shape == (2, 3)
    names = ("shot", "surface", "time", "before", "after", "kind")
    assert shots.events.dtype.names == (*names, *BOUNDS)
    assert simulate(SWIRL, record=True).events.dtype.names == names


# --------------------------------------------------------------------------------- whatever comes

LARGEST = 2.0**30  # of a release, and of a length
ANY = st.floats(-LARGEST, LARGEST)
SMALL = st.floats(-4.0, 4.0)
ODD = st.sampled_from(
    [0.0, -0.0, 5e-324, -5e-324, 1e-310, 1e-150, 1e5, -1e5, LARGEST, -LARGEST, 1.7e308]
    + [REACH, -REACH, PAPER["ring_radius"], -PAPER["end_depth"], -0.25972, 0.0762]
)
STATES = st.lists(
    st.lists(ANY | SMALL | ODD, min_size=9, max_size=9)
    | st.lists(SMALL | ODD, min_size=9, max_size=9),
    min_size=1,
    max_size=9,
)
POSITIVE = st.floats(1e-9, 1e9) | st.floats(0.01, 0.5) | st.sampled_from([1e-150, 1e150])
PARAMETERS = st.fixed_dictionaries(
    {},
    optional={name: POSITIVE for name in PAPER if name != "restitution"}
    | {"restitution": st.floats(0.0, 1.0), "board_bottom": SMALL, "board_top": ANY},
)


@pytest.mark.sampled(4)
@settings(max_examples=trials(25), deadline=None, derandomize=True)
@given(states=STATES, parameters=PARAMETERS, most=st.integers(1, 8))
def test_any_finite_shot_ends_and_is_the_same_on_every_engine(
    simulate: Simulate, states: list[list[float]], parameters: dict[str, float], most: int
) -> None:
    batch = Batch(np.array(states), PAPER | parameters)
    got = everything(simulate, batch, max_contacts=most)
    by_numpy = lambda *a, **k: hoopgen.simulate(*a, backend="numpy", **k)  # noqa: E731
    assert_same_bits(got, everything(by_numpy, batch, max_contacts=most))
    assert np.all(got["contacts"] <= most)
    assert np.all(np.isin(got["outcome"], list(Outcome)))


@pytest.mark.parametrize(
    "release",
    [
        shot(z=1.0, vz=1e155),  # goes up, and comes down again after 2e154 s
        shot(z=1.0, vz=1e307),
        shot(x=5.0, z=1.0, vz=-1e200),
        shot(z=1e308),
        shot(x=5.0, z=1.0, vx=1e308),
    ],
)
def test_a_speed_or_height_whose_square_overflows_makes_a_shot_invalid(
    simulate: Simulate, release: list[float]
) -> None:
    assert simulate(release).outcome[0] == Outcome.INVALID
    (reason,) = hoopgen.why_invalid(release)
    assert reason.startswith("out of range: ")


@settings(max_examples=trials(25), deadline=None, derandomize=True)
@given(states=STATES)
def test_what_overflows_is_never_passed_off_as_certain(
    simulate: Simulate, states: list[list[float]]
) -> None:
    shots = simulate(np.array(states), max_contacts=8)
    broken = ~np.isfinite(shots.state).all(axis=1) | ~np.isfinite(shots.time)
    assert np.all(shots.uncertain[broken & (shots.outcome != Outcome.INVALID)])
