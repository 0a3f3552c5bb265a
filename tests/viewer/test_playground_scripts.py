"""The playground's scripts beside Python: the same bits, releases, shares, kinds and changes."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import studies as generated

import hoopgen
from hoopgen.hoop.kinds import kinds
from hoopgen.simulation.fingerprint import fingerprint, fixed_releases
from hoopgen.viewer.playground_page import CONFIDENCE
from tests.helpers import ROOT
from tests.helpers.effort import trials
from tests.helpers.playground import computed, spec

GOLDEN = json.loads((ROOT / "tests" / "golden_hashes.json").read_text(encoding="utf-8"))
LANES = [1, 4]
EPS = np.finfo(float).eps

HASH = """
(() => {
  const fixed = { ...spec.fixed, each: given };
  const steps = [...Fingerprint.steps(engine, fixed, spec.presets.paper, spec.layout)];
  return Fingerprint.sha256(steps.at(-1));
})()
"""

ENGINES = {"hoop": hoopgen.HOOP, "court": hoopgen.COURT}
SCENES = list(ENGINES)


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("lanes", LANES)
def test_some_fixed_shots_have_the_bits_of_python(lanes: int, scene: str) -> None:
    releases = fixed_releases(ENGINES[scene], 4000)
    assert computed(HASH, 500, lanes, scene) == fingerprint(ENGINES[scene], releases=releases)


@pytest.mark.slow
@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("lanes", LANES)
def test_the_fixed_shots_have_the_golden_hash(lanes: int, scene: str) -> None:
    fixed = spec()["scenes"][scene]["fixed"]
    assert fixed["sha256"] == GOLDEN[scene]
    assert computed(HASH, fixed["each"], lanes, scene) == GOLDEN[scene]


@pytest.mark.slow
def test_the_fixed_releases_are_those_of_python() -> None:
    found = computed("[...Fingerprint.releases({ ...spec.fixed, each: 50 })]")
    assert found == fixed_releases(hoopgen.HOOP, 400).ravel().tolist()


def random_releases(count: int) -> list[dict[str, float]]:
    random = np.random.default_rng(5)
    low = {"speed": 4.0, "elevation": 0.5, "azimuth": -0.1, "backspin": -20.0, "sidespin": -9.0}
    high = {"speed": 12.0, "elevation": 1.3, "azimuth": 0.1, "backspin": 40.0, "sidespin": 9.0}
    low |= {"height": 1.5, "distance": 1.0, "angle": -3.0}
    high |= {"height": 2.6, "distance": 8.0, "angle": 3.0}
    return [
        {name: float(random.uniform(low[name], high[name])) for name in low} for _ in range(count)
    ]


def test_releases_of_the_page_are_those_of_python_to_the_bit() -> None:
    """They are made by the same C."""
    releases = random_releases(trials(10_000)) + [random_releases(1)[0] | {"distance": -1.0}]
    columns = {name: [one[name] for one in releases] for name in releases[0]}
    script = """
    [...engine.releases(
      Release.checked(given, spec.from_zero), given.speed.length, spec.ring_height)]
    """
    found = np.array(computed(script, columns), float).reshape(-1, 9)  # null is NaN
    wanted = hoopgen.release(**{name: np.array(column) for name, column in columns.items()})
    assert np.isnan(wanted[-1, :2]).all()
    np.testing.assert_array_equal(found, wanted)


SHOTS = """
given.map((release) => {
  const { events, outcome, uncertain, time, state, kind, release: thrown, rolls } =
    study.shot({ release, parameters: spec.presets.nba });
  const ends = [outcome[0], uncertain[0], kind];
  return { events: events[0], ends, time: time[0], state: [...state], thrown, rolls };
})
"""


@pytest.mark.sampled(1)
@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("lanes", LANES)
def test_a_shot_of_the_page_is_that_of_python_to_the_bit(lanes: int, scene: str) -> None:
    engine = ENGINES[scene]
    parameters = engine.presets["nba"]
    releases = random_releases(trials(100))
    found = computed(SHOTS, releases, lanes, scene)
    thrown = np.array([one["thrown"] for one in found])
    columns = {name: np.array([one[name] for one in releases]) for name in releases[0]}
    wanted = hoopgen.release(**columns)
    assert (thrown == wanted).all()
    shots = engine.simulate(thrown, parameters, record=True)
    named = kinds(shots.outcome, shots.counts, shots.first)
    for row, one in enumerate(found):
        assert one["ends"] == [shots.outcome[row], shots.uncertain[row], named[row]]
        assert (one["time"], one["state"]) == (shots.time[row], shots.state[row].tolist())
        events = shots.trajectory(row).events
        assert len(one["events"]) == len(events)
        for got, event in zip(one["events"], events, strict=True):
            assert [got["time"], *got["before"], *got["after"], got["surface"], got["kind"]] == [
                *(event["time"], *event["before"], *event["after"]),
                *(event["surface"], event["kind"]),
            ]


@pytest.mark.slow
def test_a_roll_of_the_page_has_the_states_of_the_engine() -> None:
    """Its pieces are on the path that `Trajectory` has by the engines' series."""
    random = np.random.default_rng(8)
    base = {name: spec()["start"][name] for name in hoopgen_arguments()}
    many = [
        base | {"speed": float(v), "elevation": float(e), "azimuth": float(a)}
        for v, e, a in random.normal((7.25, 0.94, 0.03), (0.3, 0.05, 0.03), (3000, 3))
    ]
    columns = {name: np.array([one[name] for one in many]) for name in base}
    states = hoopgen.release(**columns)
    shots = hoopgen.simulate(states, hoopgen.NBA_COURT, scene=hoopgen.COURT, record=True)
    rows = np.flatnonzero(shots.rolls)[: trials(5)]
    found = computed(SHOTS, [many[row] for row in rows], scene="court")
    pieces = 0
    for row, one in zip(rows, found, strict=True):
        path = shots.trajectory(int(row))
        assert [roll["row"] for roll in one["rolls"]] == [begin for begin, _, _ in path.rolls]
        for roll, (_, begin, end) in zip(one["rolls"], path.rolls, strict=True):
            for time, *state in roll["pieces"]:
                assert begin < time < end
                shot = hoopgen.simulate(
                    states[row], hoopgen.NBA_COURT, scene=hoopgen.COURT, time_limit=time
                )
                assert state == shot.state[0].tolist()
                # Steps of the series err by 1e-12 m, which a roll on a wire multiplies.
                np.testing.assert_allclose(state, path.at(time), rtol=0, atol=1e-7)
                pieces += 1
    assert pieces > 10


def test_wilson_s_interval_is_that_of_python_to_the_bit() -> None:
    intervals = pytest.importorskip("hoopgen.study.statistics.intervals")
    random = np.random.default_rng(6)
    shots = np.concatenate([[0, 1, 1, 10_000, 10_000], random.integers(1, 20_000, 10_000)])
    made = np.concatenate([[0, 0, 1, 0, 10_000], random.integers(0, shots[5:] + 1)])
    script = "given[0].map((made, row) => wilson_interval(made, given[1][row], spec.z))"
    found = np.array(computed(script, [made.tolist(), shots.tolist()]))
    with np.errstate(invalid="ignore"):  # the first are no shots
        wanted = np.stack(generated.wilson_interval(made, shots, spec()["z"]), axis=-1)
    np.testing.assert_array_equal(found, wanted)
    assert found[0].tolist() == [0.0, 1.0]
    # Python's command has the quantile from another library.
    ends = np.stack(intervals.wilson_interval(made, shots, CONFIDENCE), axis=-1)
    np.testing.assert_allclose(found, ends, rtol=0, atol=8 * EPS)


def throws_of(scene: str, *, seed: int = 0, count: int) -> tuple[dict[str, Any], hoopgen.Scatter]:
    """Return the question about throws at the start of a page, and the player in Python.

    The release has all eight arguments, and speed, elevation and azimuth scatter independently.
    """
    start = spec()["start"]
    mean = {name: start[name] for name in hoopgen_arguments()}
    sd = {name: start[f"sd_{name}"] for name in spec()["scattered"]}
    assert list(sd) == ["speed", "elevation", "azimuth"]
    parameters = ENGINES[scene].presets["nba"]
    asked = {"release": mean, "deviations": sd, "parameters": dict(parameters)}
    return {**asked, "seed": seed, "count": count}, hoopgen.Scatter(mean, sd)


@pytest.mark.slow
@pytest.mark.parametrize(("scene", "lanes"), [("hoop", 1), ("hoop", 4), ("court", 1), ("court", 4)])
def test_releases_are_drawn_as_a_scatter_in_python_draws_them(scene: str, lanes: int) -> None:
    for seed, count in ((0, 1001), (7, 3), (2**53 - 1, 130)):
        asked, model = throws_of(scene, seed=seed, count=count)
        found = computed("[...study.drawn(given)]", asked, lanes, scene)
        wanted = model.draw(0, count, seed, ENGINES[scene].presets["nba"]).states
        np.testing.assert_array_equal(np.reshape(found, (count, 9)), wanted)


def test_what_does_not_scatter_draws_no_random_numbers() -> None:
    asked, model = throws_of("hoop", seed=3, count=40)
    asked["deviations"] = {"speed": 0.0, "elevation": 0.0, "azimuth": 0.02}
    wanted = hoopgen.Scatter(model.release, asked["deviations"]).draw(0, 40, 3).states
    assert computed("[...study.drawn(given)]", asked) == wanted.ravel().tolist()
    asked["deviations"] = {"speed": 0.0}
    wanted = np.broadcast_to(hoopgen.release(**model.release), (40, 9))
    assert computed("[...study.drawn(given)]", asked) == wanted.ravel().tolist()


SCATTER = """
(() => {
  const found = study.scatter(given);
  const { made, count, invalid, interval, tally, angle, landings, entries } = found;
  const missed = found.outcome.filter((end) => spec.outcomes[end] === "missed").length;
  const places = { landings: [...landings], entries: [...entries] };
  return { missed, made, count, invalid, interval, tally, angle, ...places };
})()
"""


@pytest.fixture(scope="module")
def scatter() -> Any:
    asked, _ = throws_of("hoop", count=spec()["throws"])
    return computed(SCATTER, asked)


@pytest.mark.slow
@pytest.mark.parametrize(("scene", "lanes"), [("hoop", 1), ("hoop", 4), ("court", 1), ("court", 4)])
def test_made_throws_are_as_many_as_those_of_an_estimate_in_python(scene: str, lanes: int) -> None:
    """Here the three deviations alone scatter; the share is that of valid throws."""
    pytest.importorskip("scipy")
    engine, throws = ENGINES[scene], 10_000
    for seed in (0, 12345):
        asked, model = throws_of(scene, seed=seed, count=throws)
        given = {"scene": engine, "shots": throws, "seed": seed}
        wanted = hoopgen.estimate(model, engine.presets["nba"], **given)
        found = computed(SCATTER, asked, lanes, scene)
        assert (found["made"], found["invalid"]) == (wanted.made, wanted.invalid)
        assert found["made"] / found["count"] == wanted.probability
        names = spec()["kinds"]["names"]
        by_kind = dict(zip(names, map(sum, found["tally"]), strict=True))
        made_by_kind = {name: made for name, (made, _) in zip(names, found["tally"], strict=True)}
        assert by_kind == {name: wanted.kinds.get(name, 0) for name in names}
        assert made_by_kind == {name: wanted.kinds_made.get(name, 0) for name in names}
        low, high = found["interval"]
        assert low < wanted.probability < high


def hoopgen_arguments() -> list[str]:
    from hoopgen.hoop.variables import ARGUMENTS

    return list(ARGUMENTS)


def test_misses_land_and_flights_enter_where_free_flight_leads(scatter: Any) -> None:
    landings = np.array(scatter["landings"], float).reshape(-1, 2)  # null is not a number
    entries = np.array(scatter["entries"], float).reshape(-1, 2)
    there = np.isfinite(landings[:, 0])
    assert there.sum() == scatter["missed"] > 1000
    start = spec()["start"]
    state = hoopgen.release(**{name: start[name] for name in hoopgen_arguments()})
    _, arrived = hoopgen.HOOP.fall(state, 0.0, hoopgen.NBA)
    spread = np.nanstd(entries, axis=0)
    assert (np.abs(np.nanmean(entries, axis=0) - arrived[:2]) < 0.2 * spread).all()
    angle = np.arctan2(-arrived[5], np.hypot(arrived[3], arrived[4]))
    assert abs(scatter["angle"][0] - angle) < 0.1 * scatter["angle"][1]


CHANGES = """
given.map(({ release, vary }) =>
  vary.map((name) => {
    const question = { release, parameters: spec.presets.nba, patience: Infinity };
    return [...study.change(name, question)].at(-1);
  }))
"""


def ends(release: dict[str, float], name: str, value: float | None = None) -> bool:
    """Return whether a shot is made, with another value of a variable if one is given."""
    parameters, own = dict(hoopgen.NBA), dict(release)
    if value is not None:
        (own if name in own else parameters)[name] = value
    return bool(hoopgen.simulate(hoopgen.release(**own), parameters).made[0])


LOOK = """
given.map(({ ends, patience }) => {
  let [tried, furthest] = [0, 0];
  const run = function* (values, late = () => false) {
    yield;
    if (late()) return null;
    tried += values.length;
    furthest = Math.max(furthest, ...values.map(Math.abs));
    return { made: values.map((x) => x < ends[0] || x > ends[1]), marks: values.map(() => "1") };
  };
  const ranges = { away: { x: 1 }, limits: {} };
  const late = () => tried > patience;
  const steps = Nearest.change("x", 0, false, run, ranges, { late });
  let last = steps.next();
  while (!last.done) last = steps.next();
  return [last.value, tried, furthest];
})
"""


@pytest.mark.slow
def test_a_change_is_looked_for_outwards_and_no_further_than_patience() -> None:
    """A result that is another below one value and above another one."""
    unlimited = 1e9
    asked = [[-0.3, 0.2], [-0.02, 0.5], [-2.0, 2.0], [-0.3, 2.0]]
    told = [{"ends": ends, "patience": unlimited} for ends in asked]
    right, left, none, alone = computed(LOOK, told)
    for (found, tried, furthest), edge in ((right, 0.2), (left, -0.02), (alone, -0.3)):
        # Down to neighbouring doubles, and not much further than the change.
        assert found["changed"] == np.nextafter(found["unchanged"], 2.0 * edge)
        assert edge in (found["changed"], found["unchanged"])
        assert furthest < 3.0 * abs(edge)  # a block of values further
        assert tried < 4500
        assert "within" not in found
    assert none[0] == {"name": "x", "value": 0}
    assert none[2] == 1.0
    ((late, _, furthest),) = computed(LOOK, [{"ends": [-0.3, 0.2], "patience": 1000}])
    assert set(late) == {"name", "value", "within"}
    assert 0.0 < late["within"] <= furthest < 0.2


@pytest.mark.slow
def test_the_nearest_change_is_that_of_counterfactual() -> None:
    pytest.importorskip("scipy")
    start = spec()["start"]
    base = {name: start[name] for name in hoopgen_arguments()}
    releases = [base, base | {"speed": 7.0}, base | {"elevation": 0.9, "azimuth": 0.0}]
    vary = spec()["scenes"]["hoop"]["vary"]
    found = computed(CHANGES, [{"release": one, "vary": vary} for one in releases])
    compared = 0
    for release, changes in zip(releases, found, strict=True):
        shots = hoopgen.simulate(hoopgen.release(**release), hoopgen.NBA)
        wanted = hoopgen.counterfactual(shots, vary=vary, prove=False)
        for got, change in zip(changes, wanted.changes, strict=True):
            assert ("changed" in got) == bool(np.isfinite(change.changed)), change
            if "changed" in got:
                compared += 1
                # At an edge where dozens of contacts follow each other doubles decide little, and
                # both have tried other values.
                # Straight shots change alike to both sides.
                sizes = (abs(got["changed"] - got["value"]), abs(change.changed - change.value))
                assert sizes[0] == pytest.approx(sizes[1], rel=1e-3), change
                assert ends(release, change.name, got["changed"]) != ends(release, change.name)
    assert compared > 10


@pytest.mark.slow
def test_the_nearest_change_of_the_real_ball_is_that_of_counterfactual() -> None:
    pytest.importorskip("scipy")
    release = {name: spec()["start"][name] for name in hoopgen_arguments()}
    vary = ["elevation", "ring_restitution"]
    (found,) = computed(CHANGES, [{"release": release, "vary": vary}], scene="court")
    state = hoopgen.release(**release)
    shots = hoopgen.simulate(state, hoopgen.NBA_COURT, scene=hoopgen.COURT)
    wanted = hoopgen.counterfactual(shots, vary=vary, prove=False)
    for got, change in zip(found, wanted.changes, strict=True):
        assert np.isfinite(change.changed)
        size = abs(change.changed - change.value)
        assert abs(got["changed"] - got["value"]) == pytest.approx(size, rel=1e-3), change


def test_the_map_has_python_s_outcomes() -> None:
    script = """
    (() => {
      const over = { window: [[6, 9], [0.7, 1.2]], size: [12, 9] };
      const { outcome, kinds } = study.map({ ...given, parameters: spec.presets.nba, ...over });
      return [[...outcome], [...kinds]];
    })()
    """
    start = spec()["start"]
    speed = 6 + 3 * (np.arange(12) + 0.5) / 12
    elevation = 0.7 + 0.5 * (np.arange(9) + 0.5) / 9
    base = {name: start[name] for name in hoopgen_arguments()}
    outcome, kind = computed(script, {"release": base})
    states = hoopgen.release(
        **{**base, "speed": speed[None, :], "elevation": elevation[:, None]}
    ).reshape(-1, 9)
    shots = hoopgen.simulate(states, hoopgen.NBA)
    assert outcome == shots.outcome.tolist()
    assert kind == kinds(shots.outcome, shots.counts, shots.first).tolist()
