"""Scenes in one plane, such as a pinball table, and of many bodies of one kind, are seen whole."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers import ROOT

pytest.importorskip("matplotlib")

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Circle

import hoopgen
from hoopgen.core.colours import COLOURS
from hoopgen.plots import save_film
from hoopgen.plots.animation import Film
from hoopgen.plots.label_placement import Box as Label
from hoopgen.plots.label_placement import place_labels
from hoopgen.plots.scenery import scenery_of
from hoopgen.plots.views import FRONT, SIDE, TOP
from hoopgen.scene import Cylinder, End, Plane, Scene, Sphere, Surface
from hoopgen.simulation.engine import Engine
from hoopgen.viewer import page
from tests.scene.test_example_scenes import EXAMPLE, numpy_engine
from tests.viewer.test_page import data_of

pytestmark = pytest.mark.xdist_group("pinball")  # each scene is derived once

PLACES = [(-0.12, 0.55), (0.12, 0.55), (0.0, 0.7), (0.02, 0.35), (-0.18, 0.3)]
BUMPER, BALL = 0.035, 0.013


def pinball(axis: str) -> Scene:
    """Return a table in the plane across an axis, x or y: walls, and bumpers from their end."""
    along = {"x": "y", "y": "x"}[axis]
    places = [(u, 0, z) if axis == "y" else (0, u, z) for u, z in PLACES]
    return Scene(
        f"pinball_{axis}",
        ball_radius=BALL,
        gravity=1.1,
        restitution=0.9,
        bodies=[
            Plane("wall_left", axis=along, at=-0.25),
            Plane("wall_right", axis=f"-{along}", at=-0.25),
            Plane("top", axis="-z", at=-0.9),
            *(
                Cylinder(f"bumper_{k}", radius=BUMPER, centre=centre, axis=axis)
                for k, centre in enumerate(places, start=1)
            ),
        ],
        ends={"drain": End(at=0)},
    )


def start(axis: str, count: int = 1) -> Any:
    u = {"x": 1, "y": 0}[axis]
    states = np.zeros((count, 9))
    states[:, u], states[:, 2] = 0.03, 0.62
    states[:, 3 + u], states[:, 5] = -1.1 + np.linspace(0.0, 0.2, count), 0.9
    return states


@pytest.fixture(scope="module", params=["x", pytest.param("y", marks=pytest.mark.slow)])
def table(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    folder = tmp_path_factory.mktemp("pinball")
    return numpy_engine(pinball(request.param), folder)


def axis_of(table: Engine) -> str:
    return table.name[-1]


def colour_at(figure: Figure, axes: Any, place: tuple[float, float]) -> tuple[int, ...]:
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())
    x, y = axes.transData.transform(place)
    return tuple(int(part) for part in pixels[pixels.shape[0] - 1 - int(y), int(x), :3])


@pytest.mark.slow
def test_a_plane_scene_is_drawn_in_its_plane_and_its_bumpers_are_no_holes(table: Engine) -> None:
    shots = table.simulate(start(axis_of(table)), record=True)
    figure = shots.trajectory(0).plot()
    (side, key) = figure.axes
    assert key.get_label() == "key"
    across = {"x": "y", "y": "x"}[axis_of(table)]
    assert (side.get_xlabel(), side.get_ylabel()) == (f"{across} (m)", "z (m)")
    for place in PLACES:
        assert max(colour_at(figure, side, place)) < 200, "a bumper is filled"
    assert colour_at(figure, side, (0.0, 0.45)) == (255, 255, 255)
    # A wall is a line from one end of the picture to the other.
    walls = [line for lines in side.collections for line in lines.get_segments()]
    assert any(np.allclose(line[:, 0], -0.25) and np.ptp(line[:, 1]) > 0.9 for line in walls)


@pytest.mark.slow
def test_many_paths_are_drawn_in_that_plane_too(table: Engine) -> None:
    shots = table.simulate(start(axis_of(table), 5), record=True)
    (side, *_) = shots.plot().axes
    assert side.get_xlabel() == f"{ {'x': 'y', 'y': 'x'}[axis_of(table)] } (m)"


@pytest.mark.slow
def test_the_page_looks_at_that_plane_first(table: Engine) -> None:
    shots = table.simulate(start(axis_of(table)), record=True)
    scenery = data_of(page(shots, shots.parameters))["scenery"]
    assert scenery["views"] == ["Side", "3D", "Top"]
    assert scenery["side"] == {"x": [1, 0, 0], "y": [0, -1, 0]}[axis_of(table)]
    for wall in scenery["bodies"][:3]:
        assert wall["flat"]
        assert wall["rims"], "seen from its side a plane is its border"


def test_a_film_of_it_shows_that_plane_alone(table: Engine) -> None:
    path = table.simulate(start(axis_of(table)), record=True).trajectory(0)
    film = Film(path, path.parameters)
    assert sum(axes.get_label() != "key" for axes in film.figure.axes) == 1


@pytest.mark.sampled(1)
@pytest.mark.parametrize(
    ("bodies", "path", "views"),
    [
        ([Cylinder("post", radius=0.1, axis="z")], [[1, 0, 0], [0.5, 0.5, 0]], [TOP]),
        ([Cylinder("post", radius=0.1, axis="z")], [[1, 0, 0], [0.5, 0.5, 1]], [TOP, SIDE]),
        ([Sphere("globe", radius=0.1)], [[0, 1, 0], [0, 0.5, 1]], [FRONT, TOP]),
        ([Sphere("globe", radius=0.1)], [[1, 0, 0], [0.5, 0, 1]], [SIDE, TOP]),
        ([Sphere("globe", radius=0.1)], [[0, 2, 0], [1, 0, 0.5]], [FRONT, TOP]),
    ],
)
def test_views_show_the_plane_of_the_path(
    bodies: list[Any], path: list[list[float]], views: list[Any], tmp_path: Path
) -> None:
    engine = Bare("own", bodies)
    points = np.array(path, dtype=float)
    scenery = scenery_of(engine.engine(tmp_path), {}, points)
    assert [view.right for view in scenery.views(points)] == [view.right for view in views]
    assert [view.up for view in scenery.views(points)] == [view.up for view in views]


class Bare:
    """A scene of some bodies."""

    def __init__(self, name: str, bodies: list[Any]) -> None:
        self.scene = Scene(
            name, bodies=bodies, ball_radius=0.05, gravity=9.81, restitution=0.5, ends={}
        )

    def engine(self, folder: Path) -> Engine:
        return numpy_engine(self.scene, folder)


@pytest.mark.sampled(1)
@pytest.mark.parametrize(
    "body",
    [
        Cylinder("pipe", radius=0.3, axis="y", inside=True),
        Cylinder("post", radius=0.3, axis="y"),
        Cylinder("short", radius=0.3, axis="y", span=(-0.1, 0.1)),
        Cylinder("half", radius=0.3, axis="y", within=["z"]),
        Surface("gutter", condition="z - x**2"),
        Plane("floor"),
    ],
    ids=lambda body: str(body.name),
)
def test_whatever_is_touched_is_seen_edge_on(body: Any, tmp_path: Path) -> None:
    engine = Bare("own", [body]).engine(tmp_path)
    path = np.array([[-0.2, 0.0, 0.04], [0.0, 0.0, 0.0], [0.2, 0.0, 0.2]])
    scenery = scenery_of(engine, {}, path)
    axes = Figure().add_subplot()
    scenery.draw(axes, scenery.look(SIDE), 1.0)
    assert axes.collections or axes.patches


def test_the_ball_of_a_scene_without_a_hoop_is_plain(table: Engine) -> None:
    shots = table.simulate(start(axis_of(table)), record=True)
    side = shots.trajectory(0).plot().axes[0]
    balls = [patch for patch in side.patches if isinstance(patch, Circle)]
    inks = {to_hex(ball.get_facecolor()).upper() for ball in balls if ball.get_fill()}
    assert inks == {COLOURS["plain-ball"]}
    assert data_of(page(shots, shots.parameters))["scenery"]["plain"] is True
    court = hoopgen.simulate(
        [4.19, 0, -0.61, -4.5, 0, 5.577, 0, 19, 0], scene=hoopgen.COURT, record=True
    )
    assert data_of(page(court, court.parameters))["scenery"]["plain"] is False


# ------------------------------------------------------------------------------------------ labels


def test_no_label_covers_another_one() -> None:
    label = Label((0.0, 0.0), 0.1, 0.5, 0.2)
    places = place_labels([label] * 40, np.zeros((0, 2)), (-9.0, 9.0, -9.0, 9.0))
    for (x, y), (u, v) in itertools.combinations(places, 2):
        assert abs(x - u) > label.width or abs(y - v) > label.height


def test_entries_of_the_key_are_beside_one_another() -> None:
    names = [f"a_rather_long_name_of_a_bumper_{k}" for k in range(4)]
    from hoopgen.plots.contact_marks import Mark, draw_mark_legend

    here = np.zeros(3)
    marks = tuple(Mark(f"{k}", "body", name, here, "#333333") for k, name in enumerate(names))
    figure = Figure(figsize=(7.1, 3.0))
    drawn = draw_mark_legend(figure, marks, 0.6, 0.1)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    boxes = [artists[-1].get_window_extent(canvas.get_renderer()) for _, artists in drawn]
    assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))


@pytest.mark.slow
def test_the_dashed_line_where_shots_end_is_in_the_key(table: Engine) -> None:
    shots = table.simulate(start(axis_of(table)), record=True)
    for figure in (
        shots.trajectory(0).plot(),
        hoopgen.simulate(hoopgen.release(7.1, 0.9, height=2.0, distance=4.2), record=True)
        .trajectory(0)
        .plot(),
    ):
        (key,) = [axes for axes in figure.axes if axes.get_label() == "key"]
        said = {text.get_text() for text in key.texts}
        assert said & {"where shots end", "end plane"}
        assert any(line.is_dashed() for line in key.lines)
    (legend,) = shots.plot().legends
    assert "where shots end" in {text.get_text() for text in legend.get_texts()}


@pytest.mark.slow
def test_a_film_says_how_a_shot_ends_at_its_end(tmp_path: Path) -> None:
    path = hoopgen.simulate(
        hoopgen.release(
            7.166, np.radians(51.101), backspin=6 * np.pi, height=2.4384, distance=4.191
        ),
        record=True,
    ).trajectory(0)
    for title, said in (("", "Missed"), ("A shot", "A shot: missed")):
        film = Film(path, path.parameters, path.outcome, title)

        def words(film: Film = film) -> set[str]:
            texts = [*film.figure.texts, *(t for axes in film.figure.axes for t in axes.texts)]
            return {text.get_text() for text in texts if text.get_visible()}

        for time in (0.0, 0.99 * path.duration):
            film.show(time)
            assert "missed" not in " ".join(words()).lower()
        assert any("ring" in word for word in words())
        film.show(0.0)
        assert not any("ring 0" in word for word in words())
        film.show(path.duration)
        assert said in words()
        assert any(word.endswith("s, missed") for word in words())
    assert save_film(path, path.parameters, tmp_path / "a.gif", outcome=path.outcome).exists()


# ------------------------------------------------------------------- many bodies of one kind


@pytest.fixture(scope="module")
def twelve(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Return a scene of twelve spheres and twelve cylinders, of two kinds."""
    spheres = [Sphere(f"ball_{k}", radius=0.1, centre=(0.3 * k, 0, 0)) for k in range(12)]
    bars = [Cylinder(f"bar_{k}", radius=0.1, centre=(0.3 * k, 0, -1), axis="y") for k in range(12)]
    scene = Scene(
        "twelve",
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.5,
        bodies=[*spheres, *bars],
        ends={"out": End(at=-2)},
    )
    return numpy_engine(scene, tmp_path_factory.mktemp("twelve"))


@pytest.mark.slow
def test_each_of_twelve_bumpers_is_touched_where_it_is(twelve: Engine) -> None:
    states = np.zeros((12, 9))
    states[:, 0], states[:, 1], states[:, 2] = 0.3 * np.arange(12) + 0.001, 0.06, 0.5
    shots = twelve.simulate(states, record=True, max_contacts=3)
    data = data_of(page(shots, shots.parameters))
    for k, shot in enumerate(data["shots"]):
        first = shot["events"][0]
        assert first["surface"] == f"body-{k}"
        away = np.linalg.norm(np.subtract(first["at"], (0.3 * k, 0, 0)))
        assert away == pytest.approx(0.1, rel=0, abs=1e-12)
    assert isinstance(shots.plot(), Figure)
    assert isinstance(shots.trajectory(7).plot(), Figure)
    assert "ball_11" in twelve.table.written.explain()  # type: ignore[union-attr]


@pytest.mark.slow
def test_a_ball_rolls_on_whichever_body_of_a_kind(tmp_path: Path) -> None:
    scene = Scene(
        "rolls",
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.0,
        rolls=True,
        bodies=[Sphere(f"ball_{k}", radius=0.5, centre=(2 * k, 0, 0)) for k in range(4)],
        ends={"out": End(at=-1)},
    )
    engine = numpy_engine(scene, tmp_path)
    states = np.zeros((4, 9))
    states[:, 0], states[:, 2] = 2.0 * np.arange(4) + 0.01, 0.6
    shots = engine.simulate(states, record=True)
    first = shots.trajectory(0)
    times = np.linspace(0.0, first.duration, 50)
    for k in range(4):
        path = shots.trajectory(k)
        assert {"ROLL", "LEAVE"} <= {hoopgen.Event(int(kind)).name for kind in path.events["kind"]}
        moved = path.at(times)[:, :3] - (2.0 * k, 0.0, 0.0)
        # Sums of coordinates up to 8 m, some tens of operations.
        np.testing.assert_allclose(moved, first.at(times)[:, :3], rtol=0, atol=1e-11)
        on = (times > path.events["time"][1]) & (times < path.events["time"][2])
        away = np.linalg.norm(moved[on], axis=1)
        np.testing.assert_allclose(away, 0.55, rtol=0, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["netball", "bowl", "golf", "bumpers", "funnel", "pinball"])
def test_every_example_is_viewed_plotted_and_explained(name: str, tmp_path: Path) -> None:
    example = EXAMPLE[name]
    engine = numpy_engine(example.scene, tmp_path)
    shots = engine.simulate(example.shots(20, 3), record=True, max_contacts=20)
    seen = hoopgen.view(shots, path=tmp_path / "seen.html")
    assert data_of(seen.text)["shots"]
    assert isinstance(shots.plot(), Figure)
    valid = np.flatnonzero(shots.outcome != engine.outcomes["INVALID"])
    assert isinstance(shots.trajectory(int(valid[0])).plot(), Figure)
    assert name in example.scene.explain()


def test_all_examples_are_there() -> None:
    files = {file.stem for file in (ROOT / "examples" / "scenes").iterdir() if file.is_file()}
    assert files == {"netball", "bowl", "golf", "bumpers", "funnel", "pinball"}
