"""Pictures: to scale, labelled, with nothing on top of anything, and the same bytes every time."""

from __future__ import annotations

import itertools
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.simulation.article import ArticleResult, run
from hoopgen.simulation.hoop import HOOP

matplotlib = pytest.importorskip("matplotlib")

from matplotlib.axes import Axes  # noqa: E402
from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.patches import Circle  # noqa: E402
from matplotlib.text import Text  # noqa: E402

from hoopgen.plots import COLOURS, plot_trajectory, save, style  # noqa: E402
from hoopgen.plots.contact_marks import Mark, collect_marks, draw_mark_legend  # noqa: E402
from hoopgen.plots.fan_paths import gather_fan  # noqa: E402
from hoopgen.plots.label_placement import Box, place_labels  # noqa: E402
from hoopgen.plots.occlusion import is_hidden  # noqa: E402
from hoopgen.plots.scenery import scenery_of  # noqa: E402
from hoopgen.plots.style import wrap  # noqa: E402
from hoopgen.plots.trajectory import build_drawing, flat_limits  # noqa: E402
from hoopgen.plots.views import SIDE, TOP, oblique  # noqa: E402

RESULTS = {result.case.slug: result for result in run()}
OUT_OF_PLANE = ["6a", "6b-wz0", "6b-wz2"]


def draw(result: ArticleResult) -> Figure:
    return plot_trajectory(
        result.trajectory, result.parameters, outcome=result.outcome, title=result.case.title
    )


@pytest.fixture(scope="module", params=list(RESULTS))
def picture(request: pytest.FixtureRequest) -> tuple[ArticleResult, Figure]:
    result = RESULTS[request.param]
    figure = draw(result)
    FigureCanvasAgg(figure).draw()
    return result, figure


def views(figure: Figure) -> dict[str, Axes]:
    return {str(axes.get_label()): axes for axes in figure.axes if axes.get_label() != "key"}


def badges(axes: Axes) -> Iterator[Text]:
    return (text for text in axes.texts if text.get_bbox_patch() is not None)


@pytest.mark.sampled(1)
def test_the_views_are_side_and_top_and_out_of_plane_3d(
    picture: tuple[ArticleResult, Figure],
) -> None:
    result, figure = picture
    wanted = ["side view", "top view"] + ["3D view"] * (result.case.slug in OUT_OF_PLANE)
    assert list(views(figure)) == wanted


@pytest.mark.sampled(1)
def test_axes_are_named_with_their_unit(picture: tuple[ArticleResult, Figure]) -> None:
    _, figure = picture
    flat = views(figure)
    assert flat["side view"].get_xlabel() == flat["top view"].get_xlabel() == "x (m)"
    assert flat["side view"].get_ylabel() == "z (m)"
    assert flat["top view"].get_ylabel() == "y (m)"
    if "3D view" in flat:
        written = {text.get_text() for text in flat["3D view"].texts}
        assert {"x (m)", "y (m)", "z (m)"} <= written


@pytest.mark.sampled(1)
def test_a_metre_is_as_long_across_as_up(picture: tuple[ArticleResult, Figure]) -> None:
    _, figure = picture
    for axes in views(figure).values():
        assert axes.get_aspect() == 1.0
        origin, across, up = axes.transData.transform([(0, 0), (1, 0), (0, 1)])
        # Pixels of a page a thousand wide, each the sum of a few rounded numbers.
        assert across[0] - origin[0] == pytest.approx(up[1] - origin[1], rel=1e-9, abs=0)


@pytest.mark.slow
def test_the_ball_is_drawn_to_scale_at_release_and_events(
    picture: tuple[ArticleResult, Figure],
) -> None:
    result, figure = picture
    for axes in views(figure).values():
        balls = [patch for patch in axes.patches if isinstance(patch, Circle)]
        assert {ball.radius for ball in balls} == {result.parameters["ball_radius"]}
    side = views(figure)["side view"]
    centres = [ball.center for ball in side.patches if isinstance(ball, Circle)]
    places = [result.case.state[[0, 2]], *result.events["before"][[0, -1]][:, [0, 2]]]
    if result.outcome == hoopgen.Outcome.CAPPED:
        places.pop()  # the last of a swirl shares a ball with those just before
    for place in places:
        assert any(np.array_equal(place, centre) for centre in centres)


@pytest.mark.slow
def test_every_contact_is_numbered_once(picture: tuple[ArticleResult, Figure]) -> None:
    result, figure = picture
    for axes in views(figure).values():
        numbers: list[int] = []
        for badge in badges(axes):
            first, _, last = badge.get_text().partition("\N{EN DASH}")
            if first.isdigit():
                numbers.extend(range(int(first), int(last or first) + 1))
        assert numbers == list(range(1, len(result.sequence) + 1))


@pytest.mark.sampled(7)
def test_no_text_lies_on_another_or_off_the_page(picture: tuple[ArticleResult, Figure]) -> None:
    _, figure = picture
    canvas = figure.canvas
    assert isinstance(canvas, FigureCanvasAgg)
    renderer = canvas.get_renderer()
    texts = [*figure.texts]
    for axes in figure.axes:
        texts += [*axes.texts, axes.title]
        if axes.axison:
            texts += [axes.xaxis.label, axes.yaxis.label]
            texts += [*_shown_ticks(axes)]
    shown = [text for text in texts if text.get_text()]
    extents = [text.get_window_extent(renderer) for text in shown]
    for text, extent in zip(shown, extents, strict=True):
        inside = figure.bbox.x0 <= extent.x0 and extent.x1 <= figure.bbox.x1
        assert inside, text.get_text()
        assert figure.bbox.y0 <= extent.y0, text.get_text()
        assert extent.y1 <= figure.bbox.y1, text.get_text()
    for (one, box), (other, its_box) in itertools.combinations(zip(shown, extents, strict=True), 2):
        assert not box.overlaps(its_box), (one.get_text(), other.get_text())


def _shown_ticks(axes: Axes) -> Iterator[Text]:
    for axis, (low, high) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        for tick in axis.get_major_ticks():
            if low <= tick.get_loc() <= high:
                yield tick.label1


def test_surfaces_differ_in_grey_too() -> None:
    weights = np.array([0.2126, 0.7152, 0.0722])
    greys = {name: float(weights @ to_rgb(COLOURS[name])) for name in ("ring", "backboard")}
    assert abs(greys["ring"] - greys["backboard"]) > 0.2


@pytest.mark.sampled(1)
@pytest.mark.parametrize("slug", ["5d", "6b-wz2"])
@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_a_picture_is_written_in_every_format(tmp_path: Path, slug: str, suffix: str) -> None:
    path = save(draw(RESULTS[slug]), tmp_path / f"picture.{suffix}")
    start = {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}[suffix]
    assert path.read_bytes().startswith(start)


_WRITE = """
import sys
from hoopgen.simulation.article import CASES, run
from hoopgen.plots import plot_trajectory, save
result, = run([case for case in CASES if case.slug == "6b-wz2"])
save(plot_trajectory(result.trajectory, result.parameters), sys.argv[1])
"""


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["svg", "png", "pdf"])
def test_two_processes_write_the_same_bytes(tmp_path: Path, suffix: str) -> None:
    """This one, which has drawn before, and a new one, whose sets have another order."""
    here, there = (tmp_path / f"{name}.{suffix}" for name in ("here", "there"))
    result = RESULTS["6b-wz2"]
    save(plot_trajectory(result.trajectory, result.parameters), here)
    subprocess.run(
        [sys.executable, "-c", _WRITE, str(there)],
        env=os.environ | {"PYTHONHASHSEED": "2", "SOURCE_DATE_EPOCH": ""},
        check=True,
    )
    assert here.read_bytes() == there.read_bytes()


def test_an_svg_tells_no_date(tmp_path: Path) -> None:
    text = save(draw(RESULTS["5a"]), tmp_path / "a.svg").read_text(encoding="utf-8")
    assert "<dc:date>" not in text


def test_coordinates_of_an_svg_have_the_digits_that_are_seen(tmp_path: Path) -> None:
    text = save(draw(RESULTS["5a"]), tmp_path / "a.svg").read_text(encoding="utf-8")
    numbers = [
        number
        for path in re.findall(r' d="([^"]*)"', text)
        for number in re.findall(r"-?\d+\.?\d*(?:e\S+)?", path)
    ]
    assert len(numbers) > 1_000
    assert not [number for number in numbers if "e" in number or number == "-0"]
    assert max(len(number.partition(".")[2]) for number in numbers) == 3


@pytest.mark.slow
def test_an_unknown_format_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"\.png, \.svg, \.pdf"):
        save(draw(RESULTS["5a"]), tmp_path / "picture.bmp")


@pytest.mark.slow
def test_drawing_leaves_matplotlib_as_it_was() -> None:
    before = dict(matplotlib.rcParams)
    with style():
        draw(RESULTS["6a"])
    assert dict(matplotlib.rcParams) == before


@pytest.mark.slow
def test_drawing_does_not_start_pyplot() -> None:
    script = "import sys, hoopgen.plots; sys.exit('matplotlib.pyplot' in sys.modules)"
    subprocess.run([sys.executable, "-c", script], check=True)


@pytest.mark.sampled(1)
@pytest.mark.parametrize(
    ("azimuth", "angle", "distance", "speed"),
    [(2.0, 0.0, 4.19, 7.3), (-1.0, 80.0, 6.7, 8.9), (3.0, -45.0, 3.2, 7.2), (0.0, 0.0, 4.19, 3.0)],
)
def test_any_shot_can_be_drawn(azimuth: float, angle: float, distance: float, speed: float) -> None:
    state = hoopgen.release(
        speed=speed,
        elevation=np.radians(51.0),
        azimuth=np.radians(azimuth),
        backspin=18.0,
        sidespin=1.0,
        height=2.1,
        distance=distance,
        angle=np.radians(angle),
    )
    shots = hoopgen.simulate(np.reshape(state, (1, 9)), record=True)
    outcome = hoopgen.Outcome(int(shots.outcome[0]))
    figure = plot_trajectory(shots.trajectory(0), hoopgen.PAPER, outcome=outcome)
    FigureCanvasAgg(figure).draw()
    width, height = figure.get_size_inches()
    assert width <= 7.1
    assert height <= 11.0


@pytest.mark.slow
@pytest.mark.parametrize("gravity", [1e-3, 1e-6, 1e-9])
def test_a_flight_of_any_length_is_a_drawing_of_the_same_size(gravity: float) -> None:
    state = hoopgen.release(7.17, 0.89, 0.02, height=2.1336, distance=4.191)
    scene = hoopgen.PAPER | {"gravity": gravity}
    flight = hoopgen.simulate(state, scene, record=True).trajectory(0)
    figure = plot_trajectory(flight, scene)
    FigureCanvasAgg(figure).draw()
    for axes in views(figure).values():
        assert sum(len(line.get_xdata()) for line in axes.lines) < 2_000
    # A chord is off by no more than this part of the flight's height.
    assert 1 / (len(build_drawing(flight, scene, None).path) - 1) ** 2 < 1e-5
    said = " ".join(text.get_text() for text in figure.texts)  # in lines as long as there is room
    dots = re.search(r"Dots on the path every (\S+) s\.", said)
    assert dots
    assert 40 <= flight.duration / float(dots[1]) <= 100


def test_the_board_hides_what_is_behind_it_in_space() -> None:
    x = -hoopgen.PAPER["board_distance"]
    points = np.array([[x - 0.1, 0.0, 0.4], [x + 0.1, 0.0, 0.4], [x - 0.1, 0.0, 2.0]])
    there = scenery_of(HOOP, hoopgen.PAPER, points)
    for view, found in ((oblique(0.6, 0.4), [True, False, False]), (SIDE, [False] * 3)):
        axes = Figure().add_subplot()
        seen = there.look(view)
        there.draw(axes, seen, 1.0)
        assert is_hidden(axes.patches, seen, points).tolist() == found


def test_each_axis_of_a_narrow_room_has_a_number() -> None:
    state = hoopgen.release(
        9.2, np.radians(48.0), 0.02, height=2.134, distance=6.7, angle=np.pi / 2
    )
    figure = hoopgen.simulate(state, record=True).trajectory(0).plot(three_d=True)
    (space,) = (axes for axes in figure.axes if axes.get_label() == "3D view")
    said = [text.get_text() for text in space.texts]
    assert {"x (m)", "y (m)", "z (m)"} <= set(said)
    assert said.count("0") == 3


@pytest.mark.slow
def test_a_shot_of_any_number_of_contacts_is_one_too() -> None:
    contacts = 50_000
    state = hoopgen.release(0.0, 0.0, height=4.0, distance=0.3, angle=np.pi)
    scene = hoopgen.PAPER | {"restitution": 1.0}
    shots = hoopgen.simulate(state, scene, max_contacts=contacts, record=True)
    assert shots.contacts.tolist() == [contacts]  # it bounces on the bridge for ever
    drawing = build_drawing(shots.trajectory(0), scene, hoopgen.Outcome.CAPPED)
    assert len(drawing.path) <= 20_001
    assert len(drawing.dots) <= 10_000
    assert drawing.marks[1].text.startswith("bridge ")
    assert drawing.marks[1].label == f"1\N{EN DASH}{contacts}"


def test_a_wide_badge_of_the_key_is_not_over_what_it_says() -> None:
    labels = ("1", "9-40", "rolls", "leaves", "release")
    marks = tuple(Mark(label, "ring", "ring 1.817 s", np.zeros(3)) for label in labels)
    figure = Figure(figsize=(7.1, 1.0))
    draw_mark_legend(figure, marks, 0.5, 0.1)
    FigureCanvasAgg(figure).draw()
    (axes,) = figure.axes
    boxes = [
        (patch if (patch := text.get_bbox_patch()) is not None else text).get_window_extent()
        for text in axes.texts
    ]
    assert len(boxes) == 2 * len(labels)
    assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))
    assert min(box.x0 for box in boxes) >= 0.5 * figure.dpi


@pytest.mark.parametrize("width", np.arange(1.5, 4.0, 0.1).tolist())
def test_a_number_stays_with_its_unit(width: float) -> None:
    said = (
        r"Released at 5.77 m/s, 57.7° up, $\omega_y=2$ rad/s; 2.438 m from the centre, 8 ft high."
    )
    lines = wrap(said, width, 7.5)
    assert " ".join(lines) == said
    for pair in ("5.77 m/s", "$ rad/s", "2.438 m", "8 ft"):
        assert any(pair in line for line in lines)


def test_contacts_without_room_for_a_badge_are_counted() -> None:
    release = np.zeros(3)
    events = np.zeros(500, HOOP.layout.event)
    events["time"] = np.arange(500) / 100
    events["surface"] = np.arange(500) % 2
    marks = collect_marks(release, events, 0.12, hoopgen.Outcome.CAPPED)
    contacts = [mark for mark in marks if mark.kind in hoopgen.SURFACES]
    assert [mark.label for mark in contacts] == [str(number) for number in range(1, 61)]
    assert [mark.text for mark in marks[-2:]] == [
        "and 440 contacts more",
        "capped after 500 contacts",
    ]


def test_an_ordinary_flight_has_160_points_a_second() -> None:
    for result in RESULTS.values():
        times = np.unique(np.append(result.trajectory.events["time"], 0.0))
        wanted = sum(max(2, int(160 * lasts)) for lasts in np.diff(times).tolist())
        assert len(build_drawing(result.trajectory, result.parameters, None).path) == wanted + 1


@pytest.mark.parametrize(("angle", "distance"), [(np.pi / 2, 6.7), (0.0, 0.01)])
def test_flat_views_of_a_shot_along_the_board_or_straight_up_have_room(
    angle: float, distance: float
) -> None:
    state = hoopgen.release(9.2, 1.5, height=2.1, distance=distance, angle=angle)
    drawing = build_drawing(hoopgen.simulate(state, record=True).trajectory(0), hoopgen.PAPER, None)
    longest = np.ptp(drawing.path, axis=0).max()
    sides = [flat_limits(drawing, view) for view in (SIDE, TOP)]
    assert sides[0][:2] == sides[1][:2]
    left, right = sides[0][:2]
    assert right - left == pytest.approx(longest / 2, rel=1e-12)
    assert left < drawing.path[:, 0].min() < drawing.path[:, 0].max() < right


def test_a_3d_view_can_be_asked_for() -> None:
    result = RESULTS["7"]
    figure = plot_trajectory(result.trajectory, result.parameters, three_d=True)
    assert list(views(figure)) == ["side view", "top view", "3D view"]


def test_views_are_right_handed_projections() -> None:
    np.testing.assert_array_equal(SIDE.towards, [0, -1, 0])
    np.testing.assert_array_equal(TOP.towards, [0, 0, 1])
    view = oblique(np.radians(36.0), np.radians(25.0))
    basis = np.array([view.right, view.up, view.towards])
    # Products of sines and cosines, each rounded a few times.
    np.testing.assert_allclose(basis @ basis.T, np.eye(3), rtol=0, atol=4 * np.finfo(float).eps)


def test_labels_keep_clear_of_obstacles_each_other_and_the_edge() -> None:
    box = Box((0.0, 0.0), 0.1, 0.2, 0.1)
    wall = np.array([(x, 0.17) for x in np.linspace(-1, 1, 200)])
    first, second = place_labels([box, box], wall, (-1.0, 0.2, -1.0, 1.0))
    for x, y in (first, second):
        assert abs(y - 0.17) > 0.05
        assert x <= 0.2 - 0.1
    assert abs(first[0] - second[0]) > 0.2 or abs(first[1] - second[1]) > 0.1


def test_ticks_of_a_flight_of_any_length_have_room() -> None:
    from hoopgen.plots.panels import _TICK_ROOM, _step

    for span in 10.0 ** np.arange(-1, 300, 7):
        scale = 5.0 / span  # inches for a metre
        assert _TICK_ROOM <= _step(span, scale) * scale < 5.0 * _TICK_ROOM or span < 1.0


@pytest.mark.sampled(2)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -5.0])
@pytest.mark.parametrize("scene", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_a_parameter_of_an_invalid_shot_changes_no_picture(scene: Any, bad: float) -> None:
    states = hoopgen.release([7.1, 7.2, 7.3], 0.9, height=2.1, distance=4.19)
    radii = np.array([0.235, bad, 0.237])
    shots = hoopgen.simulate(states, {"ring_radius": radii}, scene=scene, record=True)
    assert (shots.outcome == scene.outcomes["INVALID"]).tolist() == [False, True, False]
    fan = gather_fan(shots, shots.parameters, range(3))
    good = np.array([True, False, True])
    others = hoopgen.simulate(states[good], {"ring_radius": radii[good]}, scene=scene, record=True)
    expected = gather_fan(others, others.parameters, range(2))
    assert fan.hoop == expected.hoop
    np.testing.assert_array_equal(fan.scenery.corners(), expected.scenery.corners())
    assert np.isfinite(shots.plot().get_size_inches()).all()
