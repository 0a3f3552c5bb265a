"""The page's scripts without a browser: flights, balls that roll and turn, stops of a shot."""

from __future__ import annotations

import itertools
import json
import os
import shutil
import subprocess
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen import COURT, PAPER_COURT, Event
from hoopgen.core import units
from hoopgen.engine.rolling import Roll
from hoopgen.viewer import page
from tests.helpers.reaching import soft_throws
from tests.viewer.test_page import FOLDER, data_of

SOFT = PAPER_COURT | {"ring_restitution": 0.3}
SLOW = PAPER_COURT | {f"{name}_restitution": 0.2 for name in COURT.surfaces} | {"ball_radius": 0.03}
CREEPING = [-0.308, 0.0, 0.1, 0.0, 0.002, 0.0, 0.0, 0.0, 0.0]
"""Onto the bridge: it rolls to its edge in more than a minute."""

pytestmark = pytest.mark.xdist_group("court")


RUN = """
const whole = new Function(require("fs").readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(whole()));
"""


def told(script: str, given: Any = None) -> Any:
    """Return what a script, an expression, is with the page's scripts and `given`."""
    node = shutil.which("node")
    if node is None:
        if os.environ.get("CI"):
            pytest.fail("node is not on PATH")
        pytest.skip("needs node")
    flight = FOLDER.parent.parent / "generated" / "js" / "hoop.js"
    if not flight.is_file():
        pytest.skip("needs the sources")
    own = (
        FOLDER / name
        for name in ("three/three.js", "flight.js", "scene.js", "stops.js", "badges.js", "words.js")
    )
    files = [file.read_text(encoding="utf-8") for file in (flight, *own)]
    whole = "\n".join(
        [*files, f"const given = {json.dumps(given)};", f"return ({script.strip()});"]
    )
    done = subprocess.run([node, "-e", RUN], input=whole, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def shown(shots: hoopgen.Shots) -> list[dict[str, Any]]:
    """Return the shots as the page's scripts have them."""
    data = data_of(page(shots, shots.parameters))
    return [
        {
            **shot,
            "parameters": {**data["parameters"], **shot["parameters"]},
            "duration": shot["flights"][-1][0],
        }
        for shot in data["shots"]
    ]


# Flights

POINTS = """
[1, 3.9, 1e4, 1e13, 1e200].map((lasts) => {
  const gravity = 10 / lasts;
  const flights = [[0, 4, 0, 0, -4, 0, 5, 0, 0, 0], [lasts, 4 - 4 * lasts, 0, 0, 0, 0, 0, 0, 0, 0]];
  const shot = { flights, rolls: [], parameters: { gravity }, duration: lasts };
  const beat = Scene.beatOf([shot]);
  return [Flight.pathOf(shot).length, beat, lasts / beat];
})
"""


def test_a_flight_of_any_length_has_few_points_and_dots() -> None:
    found = told(POINTS)
    assert [points for points, _, _ in found] == [51, 196, 201, 201, 201]  # 50 a second, up to 200
    assert [beat for _, beat, _ in found[:3]] == [0.1, 0.1, 100.0]
    assert all(dots <= 101 for _, _, dots in found)


# Balls that roll


@pytest.fixture(scope="module")
def rolling() -> hoopgen.Shots:
    """Free throws that roll on the ring and leave it."""
    states = soft_throws()
    shots = hoopgen.simulate(states, SOFT, scene=COURT, record=True)
    left = np.unique(shots.events["shot"][shots.events["kind"] == Event.LEAVE])
    assert len(left) > 5
    return hoopgen.simulate(states[left], SOFT, scene=COURT, record=True)


def within(shots: hoopgen.Shots, each: int) -> list[list[float]]:
    """Return times in contact of every shot, none of them on a row of the page."""
    random = np.random.default_rng(7)
    return [
        [t for _, a, b in shots.trajectory(row).rolls for t in random.uniform(a, b, each).tolist()]
        for row in range(len(shots))
    ]


@pytest.mark.slow
def test_between_the_page_s_rows_a_roll_is_as_near_as_it_says(rolling: hoopgen.Shots) -> None:
    times = within(rolling, 100)
    script = "given.times.map((own, k) => own.map((time) => Flight.stateAt(given.shots[k], time)))"
    found = told(script, {"shots": shown(rolling), "times": times})
    for row, own in enumerate(times):
        off = np.abs(np.array(found[row]) - rolling.trajectory(row).at(own))
        assert off[:, :3].max() < 1e-6  # m, as scenery.ROLL_PIECE_DURATION says
        assert off[:, 3:6].max() < 0.0005  # m/s, half of the last digit that is shown
        assert off[:, 6:].max() < 2 * np.pi * 0.01  # rad/s, a last digit: 0.01 Hz


@pytest.mark.slow
def test_a_path_is_where_the_ball_rolls(rolling: hoopgen.Shots) -> None:
    for row, points in enumerate(told("given.map((shot) => Flight.pathOf(shot))", shown(rolling))):
        path = rolling.trajectory(row)
        ((_, start, stop), *_) = path.rolls
        fine = path.at(np.linspace(start, stop, 200))[:, :3]
        one, other = np.array(points[:-1]), np.array(points[1:])
        # From each place to the nearest stretch of the path: a chord's sagitta, h²/8 times
        # some 40 m/s², is less than half a millimetre.
        along = other - one
        square = np.maximum((along**2).sum(axis=1), 1e-300)
        share = np.clip(((fine[:, None] - one) * along).sum(axis=2) / square, 0, 1)
        away = np.linalg.norm(fine[:, None] - one - share[..., None] * along, axis=2)
        assert away.min(axis=1).max() < 5e-4


def turned(path: hoopgen.Trajectory, start: float, stop: float, steps: int) -> Any:
    """Return by how much a ball turns between two times, a matrix: midpoints of fine steps."""
    step = (stop - start) / steps
    whole = np.eye(3)
    for x, y, z in path.at(start + step * (np.arange(steps) + 0.5))[:, 6:]:
        rate = np.sqrt(x * x + y * y + z * z)
        axis = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) / rate
        angle = rate * step
        whole = (np.eye(3) + np.sin(angle) * axis + (1 - np.cos(angle)) * axis @ axis) @ whole
    return whole


TURNS = """
given.shots.map((shot, row) => {
  const starts = Scene.orientations(shot);
  const at = (time) => {
    const k = Flight.indexAt(shot.flights, time);
    return Scene.turn(starts[k], shot, k, time - shot.flights[k][0]);
  };
  return given.times[row].map((time) => {
    const { elements: e } = new THREE.Matrix4().makeRotationFromQuaternion(at(time));
    return [[e[0], e[4], e[8]], [e[1], e[5], e[9]], [e[2], e[6], e[10]]];
  });
})
"""


@pytest.mark.slow
def test_the_ball_turns_as_it_rolls(rolling: hoopgen.Shots) -> None:
    times = []
    for row in range(len(rolling)):
        ((_, start, stop), *_) = rolling.trajectory(row).rolls
        times.append([start, start + 0.3 * (stop - start), np.nextafter(stop, 0.0)])
    found = told(TURNS, {"shots": shown(rolling), "times": times})
    most = 0.0
    for row, (start, *later) in enumerate(times):
        begun, *then = np.array(found[row])
        for time, there in zip(later, then, strict=True):
            wanted = turned(rolling.trajectory(row), start, time, 400)
            apart = there @ begun.T @ wanted.T
            assert np.arccos(np.clip((np.trace(apart) - 1) / 2, -1, 1)) < np.radians(0.2)
            most = max(most, np.arccos(np.clip((np.trace(wanted) - 1) / 2, -1, 1)))
    assert most > 1.0  # rad: one that did not turn would be seen


def test_a_roll_that_is_over_at_once_is_a_number() -> None:
    place = [0.1, 0.2, 0.3, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    flights = [[0.0, *place], [1.0, *place], [1.0, *place], [1.5, *place]]
    shot = {"flights": flights, "rolls": [[1, 2]], "duration": 1.5, "parameters": {"gravity": 9.8}}
    turns, spin, there = told(
        "[Scene.orientations(given).map((q) => [q.x, q.y, q.z, q.w]),"
        " Flight.spinOver(given, 1, 0), Flight.stateAt(given, 1)]",
        shot,
    )
    assert None not in np.ravel(turns)  # what is not a number is null in JSON
    assert spin == place[6:]
    assert there == place


def test_a_ball_that_rolls_for_ever_is_followed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    followed = []
    follow = Roll._follow

    def counted(roll: Roll, lasting: float) -> Any:
        followed.append(lasting)
        return follow(roll, lasting)

    monkeypatch.setattr(Roll, "_follow", counted)
    shots = hoopgen.simulate([CREEPING], SLOW, scene=COURT, record=True)
    assert shots.outcome[0] == COURT.outcomes.ENDLESS
    (shot,) = shown(shots)
    assert len(followed) == 1
    assert followed[0] > 59.0
    assert shot["duration"] == 60.0
    # And the room that is drawn holds all of it.
    (low, high) = data_of(page(shots, SLOW))["scenery"]["room"]
    places = np.array(shot["flights"])[:, 1:4]
    assert (places >= low).all()
    assert (places <= high).all()


def test_after_its_end_a_ball_falls_to_the_floor_and_stays() -> None:
    shots = hoopgen.simulate(
        hoopgen.release(7.17, 0.89, height=2.13, distance=4.19), hoopgen.PAPER, record=True
    )
    (shot,) = shown(shots)
    times = [shot["duration"], shot["floor_time"], 9.0]
    end, down, later = told("given[1].map((time) => Flight.stateAt(given[0], time))", [shot, times])
    assert end == shots.state[0].tolist()
    assert later == down
    floor = hoopgen.PAPER["ball_radius"] - 3.048
    assert down[2] == pytest.approx(floor, rel=0, abs=1e-14 * 10)  # m, some operations
    fallen = hoopgen.HOOP.fly(shot["floor_time"] - shot["duration"], shots.state[0], hoopgen.PAPER)
    assert down == fallen.tolist()
    points = told("Flight.fallOf(given)", shot)
    assert (points[0], points[-1]) == (end[:3], down[:3])
    assert all(low[2] < high[2] for high, low in itertools.pairwise(points))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("outcome", ["MADE", "MISSED", "SHORT", "CAPPED"])
def test_who_falls_on_after_the_end(outcome: str) -> None:
    state = {
        "MADE": hoopgen.release(7.17, 0.9, height=2.13, distance=4.19),
        "MISSED": hoopgen.release(6.5, 0.9, height=2.13, distance=4.19),
        "SHORT": [3.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
        "CAPPED": hoopgen.release(
            7.166, np.radians(51.101), backspin=6 * np.pi, height=2.4384, distance=4.191
        ),
    }[outcome]
    most = {"max_contacts": 1} if outcome == "CAPPED" else {}
    shots = hoopgen.simulate(state, record=True, **most)
    assert shots.outcome[0] == hoopgen.Outcome[outcome]
    (shot,) = shown(shots)
    assert ("floor_time" in shot) == (outcome != "CAPPED")
    if outcome != "CAPPED":
        assert told("Flight.stateAt(given, 99)[2]", shot) == pytest.approx(
            hoopgen.PAPER["ball_radius"] - 3.048, rel=0, abs=1e-13
        )


@pytest.mark.slow
def test_stops_are_the_release_and_every_row_also_those_at_one_time() -> None:
    shot = {"events": [{"time": time} for time in (0.5, 0.9, 0.9, 1.2)]}
    at = "[0, 0.4, 0.5, 0.9, 1, 1.2].map((time) => Stops.at(given, time))"
    assert told(at, shot) == [0, 0, 1, 3, 3, 4]
    walk = """((way, from) => {
      const seen = [from];
      for (;;) {
        const stop = seen.at(-1);
        const next = Stops.beside(given, stop, Stops.times(given)[stop], way);
        if (next === null) return seen;
        seen.push(next);
      }
    })"""
    assert told(f"{walk}(1, 0)", shot) == [0, 1, 2, 3, 4]
    assert told(f"{walk}(-1, 4)", shot) == [4, 3, 2, 1, 0]
    # From between two: back to the one before, on to the one after.
    assert told("[-1, 1].map((way) => Stops.beside(given, 1, 0.7, way))", shot) == [1, 2]
    assert (
        told("[-1, 1].map((way) => Stops.beside(given, 0, 0, way))", {"events": []}) == [None] * 2
    )


# Words

SAID = """
(() => {
  const [page, shot] = given;
  const words = Words.of(page);
  const { gridSaid, now, outcome, release } = words;
  const said = () => [release(shot), now(shot, 0.5), outcome(shot), gridSaid()];
  const first = said();
  words.convert();
  return [first, words.other(), said()];
})()
"""


@pytest.mark.sampled(1)
@pytest.mark.parametrize("system", ["si", "us"])
def test_lengths_and_speeds_are_said_in_either_system(system: units.System) -> None:
    state = hoopgen.release(
        7.166, np.radians(51.101), backspin=6 * np.pi, height=2.4384, distance=4.191
    )
    shots = hoopgen.simulate(state, record=True)
    with units.use_units(system):
        data = data_of(page(shots, shots.parameters))
    (shot,) = shown(shots)
    assert data["system"] == system
    first, other, second = told(SAID, [data, shot])
    said = {system: first, **{one: second for one in ("si", "us") if one != system}}
    assert other == {"si": "Show m", "us": "Show ft"}[system]
    release, now, outcome, grid = said["si"]
    assert dict(release) == {
        "Speed": "7.166 m/s",
        "Elevation": "51.1°",
        "Height, distance": "2.438, 4.191 m",
        "Backspin": "3.00 Hz",
    }
    assert (outcome, grid) == ("0.417 m from the ring’s centre after 1.550 s", "1 m")
    assert dict(now)["x, y, z"] == "1.941, 0.000, 0.953 m"
    release, now, outcome, grid = said["us"]
    assert dict(release)["Speed"] == "16.03 mph"
    assert dict(release)["Height, distance"] == "8.00, 13.75 ft"
    assert (outcome, grid) == ("1.37 ft from the ring’s centre after 1.550 s", "3 ft")
    assert dict(now)["x, y, z"] == "6.37, 0.00, 3.13 ft"


GRID = """
((page, steps) => steps.map((step) => {
  const words = Words.of({ ...page, scenery: { step } });
  const said = [words.gridSaid(), words.grid()];
  words.convert();
  return [...said, words.gridSaid(), words.grid()];
}))(...given)
"""


def test_the_grid_is_a_round_number_in_either_system() -> None:
    """The grid that is said is the one that is drawn."""
    shots = hoopgen.simulate(hoopgen.release(7.2, 0.9, height=2.1, distance=4.2), record=True)
    steps = [0.01, 0.1, 1.0, 10.0]
    found = told(GRID, [data_of(page(shots, shots.parameters)), steps])
    us = {"0.4 in": 0.4 * units.INCH, "4 in": 4 * units.INCH}
    us |= {"3 ft": 3 * units.FOOT, "30 ft": 30 * units.FOOT}
    for step, (metres, si, said, size), (text, wanted) in zip(
        steps, found, us.items(), strict=True
    ):
        assert (metres, si) == (f"{step:g} m", step)
        assert (said, size) == (text, pytest.approx(wanted, rel=1e-15))


# Badges

CROWD = """
(() => {
  const made = [];
  const element = (name) => ({
    name, attributes: {}, parts: [], parentElement: { clientWidth: 1200, clientHeight: 800 },
    setAttribute(key, value) { this.attributes[key] = value; },
    append(...parts) { this.parts.push(...parts); },
    replaceChildren(...parts) { made.push(...parts); },
  });
  globalThis.document = { createElementNS: (_, name) => element(name) };
  const marks = Array.from({ length: 45 }, (_, k) => ({ label: `${k}`, surface: "ring", at: [k] }));
  const place = ([k]) => [600 + k / 10, 400];
  Badges.draw(element("svg"), marks, place, [], (part) => part);
  const rects = made.flatMap((part) => part.parts.filter((one) => one.name === "rect"));
  return rects.map(({ attributes: { x, y, width, height } }) => [x, y, width, height]);
})()
"""


def test_no_badge_of_the_page_covers_another_one() -> None:
    boxes = told(CROWD)
    assert len(boxes) == 45
    for (x, y, wide, high), (u, v, width, height) in itertools.combinations(boxes, 2):
        assert x + wide <= u or u + width <= x or y + high <= v or v + height <= y
