"""The peers of the benchmarks fly the article's model and agree with the judge."""

import re
import shutil
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from tests.helpers import ROOT

pytest.importorskip("scipy")
pytest.importorskip("matplotlib")

from matplotlib.text import Text

import hoopgen
from benchmarks import peers, picture, workloads
from benchmarks.contenders import contenders
from benchmarks.errors import Verdict, judge
from benchmarks.operations import operations
from benchmarks.peers import model, native
from benchmarks.run import Settings
from benchmarks.timing import Rates, Spread, rounds
from hoopgen import PAPER, Outcome
from hoopgen.engine.c_build import FLAGS

pytestmark = pytest.mark.skipif(
    shutil.which(native.COMPILER[0]) is None, reason="the peers in C need a compiler"
)

RING, BACKBOARD, BRIDGE = range(3)
BY_KEY = {peer.key: peer for peer in peers.PEERS}
EXPECTED = {
    "5a": ([], Outcome.MADE),
    "5b": ([RING, RING], Outcome.MADE),
    "5c": ([BACKBOARD], Outcome.MADE),
    "5d": ([RING, BACKBOARD, BRIDGE], Outcome.MADE),
    "6a": ([BACKBOARD], Outcome.MADE),
    "7": ([RING, BACKBOARD], Outcome.MISSED),
}


@pytest.mark.parametrize("case", EXPECTED)
@pytest.mark.parametrize("peer", peers.PEERS, ids=lambda peer: peer.key)
def test_peers_give_the_sequences_of_table_3(peer: peers.Peer, case: str) -> None:
    flown = peer.fly(workloads.TABLE_3[case], PAPER, record=True)
    surfaces, outcome = EXPECTED[case]
    assert flown.surfaces[0, : len(surfaces) + 1].tolist() == [*surfaces, -1]
    assert flown.outcome[0] == outcome
    assert flown.contacts[0] == len(surfaces)


@pytest.mark.parametrize("peer", peers.PEERS, ids=lambda peer: peer.key)
def test_peers_swirl_on_the_ring(peer: peers.Peer) -> None:
    flown = peer.fly(workloads.TABLE_3["6b"], PAPER, record=True)
    assert flown.contacts[0] > 5
    assert set(flown.surfaces[0]) == {RING, -1}


def test_a_rebound_solves_equations_11_to_17() -> None:
    before = np.array([0.3, 0.1, 0.08, 0.7, -1.1, -2.0, 3.0, -5.0, 7.0])
    after = model.rebound(PAPER, RING, before)
    n3 = np.array(model.outward_normal(PAPER, RING, before[:3].tolist()))
    n1 = np.array([1.0, 0.0, 0.0]) - n3[0] * n3
    n1 /= np.linalg.norm(n1)
    frame = np.array([n1, np.cross(n3, n1), n3])
    v, w = frame @ before[3:6], frame @ before[6:]
    v_after, w_after = frame @ after[3:6], frame @ after[6:]
    radius = PAPER["ball_radius"]
    residuals = [
        v_after[0] - radius * w_after[1],
        v_after[1] + radius * w_after[0],
        v_after[1] - v[1] - 2 / 3 * radius * (w_after[0] - w[0]),
        v[0] - v_after[0] - 2 / 3 * radius * (w_after[1] - w[1]),
        v_after[2] + PAPER["restitution"] * v[2],
        w_after[2] - w[2],
    ]
    # Some tens of operations on numbers below 10.
    np.testing.assert_allclose(residuals, 0, rtol=0, atol=100 * np.finfo(float).eps)


@pytest.mark.parametrize("workload", workloads.WORKLOADS, ids=lambda workload: workload.key)
def test_a_workload_begins_with_every_smaller_one(workload: workloads.Workload) -> None:
    assert (workload.make(100)[:10] == workload.make(10)).all()
    assert workload.make(3).shape == (3, 9)


@cache
def judged(workload: workloads.Workload, count: int) -> Verdict:
    """Return the judge's verdict, once for all peers."""
    return judge(workload.make(count))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("workload", workloads.WORKLOADS, ids=lambda workload: workload.key)
@pytest.mark.parametrize("peer", peers.PEERS, ids=lambda peer: peer.key)
def test_peers_agree_with_the_judge(peer: peers.Peer, workload: workloads.Workload) -> None:
    count = 10 if peer.key == "solve_ivp_events" else 40
    states = workload.make(count)
    verdict = judged(workload, count)
    right, known = verdict.right, verdict.known
    flown = peer.fly(states, PAPER, record=True)
    # Long swirls amplify each method's error; the others must agree shot by shot.
    steady = known & (right.contacts < 15)
    assert (flown.surfaces[steady] == right.surfaces[steady]).all()
    assert (flown.outcome[steady] == right.outcome[steady]).all()
    # The article's method is late by 1e-10 s a contact, and ring contacts amplify tenfold and more.
    np.testing.assert_allclose(flown.time[steady], right.time[steady], rtol=0, atol=1e-4)


@pytest.mark.parametrize("peer", peers.PEERS, ids=lambda peer: peer.key)
def test_a_ball_that_cannot_reach_the_end_plane_is_short(peer: peers.Peer) -> None:
    falling = np.array([2.0, 0, -1.0, -1.0, 0, -1.0, 0, 0, 0])
    rising_too_little = np.array([2.0, 0, -1.0, -1.0, 0, 1.0, 0, 0, 0])
    flown = peer.fly(np.array([falling, rising_too_little]), PAPER)
    assert (flown.outcome == Outcome.SHORT).all()
    assert (flown.time == 0).all()


@pytest.mark.parametrize("key", [key for key in BY_KEY if key != "solve_ivp_events"])
def test_a_shot_is_capped_at_max_contacts(key: str) -> None:
    states = workloads.TABLE_3["6b"]
    flown = BY_KEY[key].fly(states, PAPER, max_contacts=4, record=True)
    assert flown.outcome[0] == Outcome.CAPPED
    assert flown.contacts[0] == 4
    assert flown.surfaces.shape == (1, 4)


def test_shots_side_by_side_do_not_disturb_each_other() -> None:
    pytest.importorskip("heyoka")  # its wheels are for Linux alone
    fly = BY_KEY["heyoka_events"].fly
    states = np.concatenate([w.make(7) for w in workloads.WORKLOADS])
    together = fly(states, PAPER, record=True)
    for shot, state in enumerate(states):
        alone = fly(state, PAPER, record=True)
        assert (alone.surfaces[0] == together.surfaces[shot]).all()
        assert alone.outcome[0] == together.outcome[shot]
        assert alone.time[0] == together.time[shot]


def test_a_peer_whose_package_is_missing_is_left_out_and_said() -> None:
    present, lines = peers.taking_part(peers.EVERYBODY, find=lambda package: None)
    assert {peer.key for peer in peers.EVERYBODY} - {peer.key for peer in present} == {
        "heyoka_events"
    }
    assert lines == ("Taylor series, heyoka.py: left out, heyoka is not installed here",)
    assert peers.taking_part(peers.EVERYBODY, find=str) == (peers.EVERYBODY, ())


def test_the_scene_in_c_has_every_parameter() -> None:
    assert sorted(native.SCENE) == sorted(PAPER)


def test_outcomes_in_c_are_hoopgens() -> None:
    assert [Outcome.MADE, Outcome.MISSED, Outcome.CAPPED, Outcome.SHORT] == [0, 1, 2, 3]
    assert hoopgen.SURFACES == ("ring", "backboard", "bridge")


def test_the_peers_are_compiled_as_hoopgen_is() -> None:
    assert tuple(FLAGS) == native.OUR_FLAGS
    assert native.FLAGS[: len(FLAGS)] == native.OUR_FLAGS


def test_rounds_time_every_contender_every_time() -> None:
    field = [one for one in contenders() if one.key in ("c_one", "march_bisect")]
    rates = rounds(field, workloads.WORKLOADS[1], size=256, count=2, budget=1e-3)
    assert {key: len(of.rates) for key, of in rates.items()} == {"c_one": 2, "march_bisect": 2}
    assert Settings().rounds >= 7


def test_ratios_are_taken_round_by_round() -> None:
    assert Rates(1, (2.0, 8.0, 6.0)).over(Rates(1, (1.0, 2.0, 6.0))) == Spread(2.0, 1.5, 3.0)


@pytest.mark.slow
def test_operations_grow_with_the_contacts() -> None:
    swish, swirl = (operations(w.make(50)) for w in workloads.WORKLOADS[::3])
    assert swish is not None
    assert swirl is not None
    assert 50 < swish.operations < swirl.operations / 10
    assert 0 < swish.divisions + swish.roots < swish.operations
    assert swish.evaluations == 0  # no shot comes near the ring
    assert 20 < swirl.evaluations < swirl.operations / 50
    assert 0.2 < swirl.busy <= 1


def test_the_picture_says_powers_and_names_in_plain_letters_apart() -> None:
    figure = picture.draw(picture.read((ROOT / "docs" / "benchmarks.json").read_text("utf-8")))
    figure.canvas.draw()
    for axes in figure.axes:
        ticks = [tick for tick in axes.get_xticklabels() if tick.get_text()]
        assert {"10²", "10⁶"} <= {tick.get_text() for tick in ticks}
        ends = [(box.x0, box.x1) for box in (tick.get_window_extent() for tick in ticks)]
        assert all(stop < start for (_, stop), (start, _) in pairwise(sorted(ends)))
    svg = (ROOT / "docs" / "benchmarks.svg").read_text("utf-8")
    said = {text.get_text() for text in figure.findobj(Text)}
    for text in (*said, *re.findall(r"<!-- (.*?) -->", svg)):
        assert not {"$", "`", "\\"} & {*text}
