"""Any scene is drawn from its own data: its bodies in pictures and on pages, and its ends."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.helpers import ROOT
from tests.helpers.commands import run, succeed

pytest.importorskip("matplotlib")

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch

import hoopgen
from benchmarks import pictures
from hoopgen.core.colours import body_colours
from hoopgen.plots import plot_fan, scenery
from hoopgen.plots.contact_marks import Mark
from hoopgen.plots.fan_paths import _view_of, gather_fan
from hoopgen.plots.occlusion import is_hidden
from hoopgen.plots.outlines import flat_chains
from hoopgen.plots.panels import Drawing, Room, draw_view
from hoopgen.plots.scenery import scenery_of
from hoopgen.plots.shot_text import describe_shot
from hoopgen.plots.trajectory import _draw
from hoopgen.plots.views import SIDE, TOP, Panel, oblique
from hoopgen.scene import (
    Box,
    Cone,
    Cylinder,
    End,
    Parameter,
    Plane,
    Scene,
    Sphere,
    Surface,
    Torus,
    load_scene,
)
from hoopgen.scene.geometry import SceneGeometry
from hoopgen.scene.mesh_lines import chains, loops
from hoopgen.scene.meshes import clip
from hoopgen.scene.upright import upright_along
from hoopgen.simulation.engine import Engine
from hoopgen.viewer import page
from tests.scene.test_example_scenes import numpy_engine
from tests.viewer.test_page import Tab, browser, data_of, drawn, show  # noqa: F401

pytestmark = pytest.mark.xdist_group("view")  # one browser

EXAMPLES = ROOT / "examples" / "scenes"
Points = NDArray[np.float64]
ROOM = np.full(3, -0.5), np.full(3, 0.5)
ALL_AXES = ("x", "y", "z")
BALL = 0.05

KINDS = [
    Sphere("ball", radius=0.2, centre=(0.1, 0, 0)),
    Sphere("bowl", radius=0.3, inside=True, within=["z"]),
    Box("crate", size=(0.1, 0.2, 0.3)),
    Box("crate_turned", size=(0.1, 0.2, 0.3), orientation=(1, 2, 3, 4)),
    Surface("ramp", condition="z - x**2 - y/4"),
    *(Torus(f"ring_{a}", radius=0.3, wire=0.02, axis=a) for a in ALL_AXES),
    Torus("ring_leaning", radius=0.3, wire=0.02, axis=(1, -2, 2)),
    *(Cylinder(f"post_{a}", radius=0.1, axis=a, span=(-0.2, 0.3)) for a in ALL_AXES),
    *(Cylinder(f"pipe_{a}", radius=0.3, axis=a, inside=True) for a in ALL_AXES),
    *(Plane(f"wall_{a}", axis=a, within=["0.04 - x**2 - y**2 - z**2"]) for a in ALL_AXES),
    *(Plane(f"lid_{a}", axis=f"-{a}", at=0.1) for a in ALL_AXES),
]


def seen(*bodies: Any, ends: dict[str, End] | None = None) -> SceneGeometry:
    scene = Scene(
        "zoo", bodies=bodies, ball_radius=BALL, gravity=9.81, restitution=0.5, ends=ends or {}
    )
    return SceneGeometry(
        scene, dict(zip((i.name for i in scene.inputs), scene.values(), strict=True))
    )


def area(corners: Points) -> float:
    a, b, c = np.moveaxis(corners[..., :3], 1, 0)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


# Bodies as triangles


@pytest.mark.parametrize("body", KINDS, ids=lambda body: body.name)
def test_every_triangle_faces_the_ball_that_touches_it(body: Any) -> None:
    (one,) = seen(body).bodies(ROOM)
    corners = one.mesh.corners
    a, b, c = np.moveaxis(corners[..., :3], 1, 0)
    towards = (corners[..., 3:] - corners[..., :3]).mean(axis=1)
    assert len(corners)
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), towards) > -1e-15).all()
    ways = corners[..., 3:] - corners[..., :3]
    assert np.allclose(np.linalg.norm(ways, axis=-1), BALL, rtol=0.02, atol=0.0)


def test_a_leaning_ring_is_drawn_about_its_axis() -> None:
    """Each corner is at the wire's radius from the circle, and the box about it is no larger."""
    made = seen(Torus("ring", radius=0.25, wire=0.02, centre=(0.1, 0, 0), axis=(1, -2, 2)))
    (one,) = made.bodies(ROOM)
    unit, off = np.array([1, -2, 2]) / 3, one.mesh.corners[..., :3] - [0.1, 0, 0]
    height = off @ unit
    rho = np.sqrt(np.sum(off**2, axis=-1) - height**2)
    assert np.hypot(rho - 0.25, height) == pytest.approx(0.02, rel=1e-12)
    assert abs(height).max() == pytest.approx(0.02, rel=1e-12)
    low, high = map(np.array, made._extent(made.scene.read.bodies[0], ROOM))
    assert (off.min(axis=(0, 1)) + [0.1, 0, 0] >= low - 1e-12).all()
    assert high - low == pytest.approx(0.5 * np.sqrt(1 - unit**2) + 0.04, rel=1e-12)
    (edge,) = seen(Torus("edge", radius=0.25, axis=(1, -2, 2))).bodies(ROOM)
    assert np.linalg.norm(edge.lines, axis=-1) == pytest.approx(0.25, rel=1e-12)
    assert edge.lines @ unit == pytest.approx(0.0, abs=1e-12)


def test_a_turned_box_is_drawn_turned_within_its_extent() -> None:
    """By 30 degrees about z: its corners are those of a rectangle that leans."""
    turn = {"axis": "z", "angle": "30deg"}
    made = seen(Box("crate", size=(0.4, 0.2, 0.1), centre=(0.1, 0, 0.05), orientation=turn))
    (one,) = made.bodies(ROOM)
    corners = one.mesh.corners[..., :3]
    assert area(one.mesh.corners) == pytest.approx(2 * (0.08 + 0.04 + 0.02), rel=1e-12)
    long, wide = np.array([0.75**0.5, 0.5, 0.0]), np.array([-0.5, 0.75**0.5, 0.0])
    off = corners - [0.1, 0, 0.05]
    assert abs(off @ long) == pytest.approx(0.2, rel=1e-12)
    assert abs(off @ wide) == pytest.approx(0.1, rel=1e-12)
    low, high = made._extent(made.scene.read.bodies[0], ROOM)
    assert low == pytest.approx(corners.min(axis=(0, 1)), abs=1e-15)
    assert high == pytest.approx(corners.max(axis=(0, 1)), abs=1e-15)


def test_a_plane_with_a_round_hole_has_that_hole() -> None:
    (green,) = seen(Plane("green", within=["0.01 - x**2 - y**2"])).bodies(ROOM)
    assert area(green.mesh.corners) == pytest.approx(1.0 - 0.01 * np.pi, rel=1e-4)
    assert np.hypot(*green.mesh.rims[..., :2].T) == pytest.approx(0.1, rel=1e-3)
    (rim,) = chains(green.mesh.rims)
    assert (rim[0] == rim[-1]).all()


def test_bounds_cut_a_sphere_and_a_span_a_cylinder() -> None:
    cap, post = seen(
        Sphere("cap", radius=0.2, within=["0.1 - z"]), Cylinder("post", radius=0.1, span=(-0.2, 0))
    ).bodies(ROOM)
    assert cap.mesh.corners[..., 2].min() == pytest.approx(0.1, abs=1e-3)
    assert area(cap.mesh.corners) == pytest.approx(2 * np.pi * 0.2 * 0.1, rel=0.01)
    assert np.ptp(post.mesh.corners[..., 2]) == pytest.approx(0.2, abs=1e-12)
    side, ends = 2 * np.pi * 0.1 * 0.2, 2 * np.pi * 0.1**2
    assert area(post.mesh.corners) == pytest.approx(side + ends, rel=0.01)


def test_a_surface_of_ones_own_lies_a_ball_below_its_condition() -> None:
    (ramp,) = seen(Surface("ramp", condition="z - x**2 - y/4")).bodies(ROOM)
    x, y, z = np.moveaxis(ramp.mesh.corners[..., 3:], -1, 0)
    step = 1.1 / 40
    assert np.abs(z - x**2 - y / 4).max() < step**2  # half the second derivative, at most
    assert area(ramp.mesh.corners) > 0.8


def test_a_body_far_away_and_one_without_end_leave_the_room_small() -> None:
    there = seen(
        Sphere("earth", radius=6.4e6, centre=(0, 0, -6.4e6)),
        Cylinder("post", radius=0.1),
        Plane("wall", axis="x", at=-0.6),
    )
    low, high = there.room(np.full(3, -0.5), np.full(3, 0.5))
    assert (high - low < 4.0).all()
    assert low[0] <= -0.6


@pytest.mark.parametrize("way", [(k, sign) for k in range(3) for sign in (1, -1)])
def test_gravity_is_turned_down(way: tuple[int, int]) -> None:
    turn, names = upright_along(*way)
    gravity = np.zeros(3)
    gravity[way[0]] = way[1]
    assert (turn @ gravity).tolist() == [0, 0, -1]
    assert np.linalg.det(turn) == 1.0
    assert sorted(name[-1] for name in names) == ["x", "y", "z"]
    for row, name in zip(turn, names, strict=True):
        assert row["xyz".index(name[-1])] == (-1 if len(name) > 1 else 1)


def test_a_corner_exactly_on_a_cut_leaves_no_line_behind() -> None:
    square = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]]], float)
    left, _, _ = clip(square, (square[..., 0] + square[..., 1] - 1.0))
    assert len(left) == 1
    (line,) = loops(left)
    assert len(line) == 4


def test_a_corner_all_but_on_a_cut_costs_no_outline() -> None:
    """The first triangle keeps its side to the corner, whatever is left of the second."""
    square = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]]], float)
    for off in (0.0, 1e-20, 1e-17):
        # Below 0 at all corners but (0, 1), where it is 0 or as good as that.
        values = np.where(square[..., 1] > square[..., 0], off, -1.0)
        left, _, _ = clip(square, values)
        (line,) = loops(left)
        assert sorted(map(tuple, line[:-1, :2].tolist())) == [(0, 0), (0, 1), (1, 0), (1, 1)]


@pytest.mark.sampled(19)
@pytest.mark.parametrize("view", [(0.0, -1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)])
@pytest.mark.parametrize("body", KINDS, ids=lambda body: body.name)
def test_what_is_seen_of_a_body_has_closed_outlines(body: Any, view: Any) -> None:
    (one,) = seen(body).bodies(ROOM)
    corners = one.mesh.corners
    facing = clip(corners, -((corners[..., 3:] - corners[..., :3]) @ np.array(view)))[0]
    for line in loops(facing[..., :3]):
        assert (line[0] == line[-1]).all()


def test_families_share_a_colour_and_a_ring_has_the_hoops() -> None:
    own = body_colours(["ring", "wall_a", "wall_b", "bumper_1", "bumper_2", "bar", "long_bar"])
    assert own["wall_a"] == own["wall_b"] != own["bumper_1"] == own["bumper_2"]
    assert own["ring"] == "#D55E00"
    assert list(own.values()).count("#D55E00") == 1
    assert own["bar"] != own["long_bar"]


# Pictures


def painted(axes: Axes) -> float:
    """Return the area of all patches, m²: tones lie beside one another."""
    total = 0.0
    for patch in axes.patches:
        assert isinstance(patch, PathPatch)
        for polygon in patch.get_path().to_polygons():
            x, y = polygon.T
            total += float(np.dot(x[:-1], y[1:]) - np.dot(x[1:], y[:-1])) / 2.0
    return abs(total)


@pytest.mark.parametrize("view", [SIDE, TOP, oblique(0.6, 0.4)], ids=lambda view: view.name)
@pytest.mark.parametrize("inside", [False, True])
def test_a_sphere_covers_its_disc_in_every_view(view: Any, inside: bool) -> None:
    scene = Scene(
        "one",
        bodies=[Sphere("ball", radius=0.3, inside=inside)],
        ball_radius=BALL,
        gravity=9.81,
        restitution=0.5,
    )
    there = scenery_of(stand_in(scene), {}, np.array([[-0.3, -0.3, -0.3], [0.3, 0.3, 0.3]]))
    axes = Figure().add_subplot()
    there.draw(axes, there.look(view), 1.0)
    assert painted(axes) == pytest.approx(np.pi * 0.09, rel=0.01)


@pytest.mark.parametrize("view", [SIDE, TOP, oblique(0.6, 0.4)], ids=lambda view: view.name)
@pytest.mark.parametrize("inside", [False, True])
@pytest.mark.parametrize("dpi", [72, 100])
def test_a_cone_has_no_seams(
    view: Any, inside: bool, dpi: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scenery, "mix_with_white", lambda *_: (0.0, 0.0, 0.0))
    axis, start = ("z", 0.2) if inside else ("-z", 0.0)  # open towards the eye above
    body = Cone("cone", half_angle="40deg", axis=axis, span=(start, 0.6), inside=inside)
    scene = Scene("one", bodies=[body], ball_radius=0.02, gravity=9.81, restitution=0.5)
    there = scenery_of(stand_in(scene), {}, np.array([[0, 0, 1.0], [0.1, 0.1, -0.1]]))
    figure = Figure(figsize=(4, 4), dpi=dpi)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=(-1.2, 1.2), ylim=(-1.2, 1.2))
    axes.set_axis_off()
    there.draw(axes, there.look(view), 4 / 2.4)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    black = np.array(canvas.buffer_rgba())[..., 0] < 8
    seams = np.zeros_like(black)
    for way in ((0, 3), (3, 0), (3, 3), (3, -3)):  # between two that are black
        across = np.roll(black, way, (0, 1)) & np.roll(black, (-way[0], -way[1]), (0, 1))
        seams |= ~black & across
    assert black.sum() > 1_000
    assert seams.sum() < 0.005 * black.sum()  # a hollow corner has some


@pytest.mark.parametrize("start", range(7))
def test_a_circle_from_the_side_is_a_line_of_its_width(start: int) -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, 65) + 0.1 * start
    circle = np.stack([np.cos(turn), np.sin(turn), np.zeros_like(turn)], axis=-1)
    segments = np.stack([circle[:-1], circle[1:]], axis=1)
    (side,), (top,) = flat_chains(SIDE, segments), flat_chains(TOP, segments)
    ends = [np.cos(turn).min(), np.cos(turn).max()]
    np.testing.assert_allclose([side[:, 0].min(), side[:, 0].max()], ends, rtol=0, atol=1e-5)
    assert len(side) < 10
    assert 30 < len(top) <= 65


def test_a_cylinder_from_its_end_is_a_circle_in_one_piece() -> None:
    scene = Scene(
        "one",
        bodies=[Cylinder("bar", axis="y", radius=0.3)],
        ball_radius=BALL,
        gravity=9.81,
        restitution=0.5,
    )
    there = scenery_of(stand_in(scene), {}, np.array([[-0.3, -0.3, -0.3], [0.3, 0.3, 0.3]]))
    axes = Figure().add_subplot()
    there.draw(axes, there.look(SIDE), 1.0)
    (circle,) = (path.vertices for lines in axes.collections for path in lines.get_paths())
    np.testing.assert_allclose(np.linalg.norm(circle, axis=1), 0.3, rtol=0.01, atol=0)
    np.testing.assert_array_equal(circle[0], circle[-1])


def past_a_sphere(y: float, marks: int = 2) -> Drawing:
    """Return a straight path past a sphere of radius 0.3, on the far side of it at positive y."""
    bodies = [Sphere("stone", radius=0.3)]
    scene = Scene("one", bodies=bodies, ball_radius=BALL, gravity=9.81, restitution=0.5)
    path = np.linspace([-1.0, y, 0.0], [1.0, y, 0.0], 81)
    there = scenery_of(stand_in(scene), {}, path)
    said = [Mark(f"{k}", "body", f"stone {k}", path[40], "#333333") for k in range(marks)]
    room = Room((-1.0, -1.0, -0.5), (1.0, 1.0, 0.5))
    return Drawing(path, path[1::4], path[[40]], tuple(said), there, room, (SIDE, TOP))


@pytest.mark.parametrize("behind", [True, False])
def test_a_sphere_hides_the_path_behind_it(behind: bool) -> None:
    drawing = past_a_sphere(0.6 if behind else -0.6)
    axes = Figure().add_subplot()
    draw_view(axes, Panel(SIDE, (-1.2, 1.2, -0.6, 0.6), 2.0, 0.0, 0.0), drawing)
    alone = [line for line in axes.lines if line.get_linestyle() == "None"]
    dots = np.concatenate([line.get_xdata() for line in alone])
    assert (np.abs(dots).min() >= 0.29) == behind
    assert len(dots) == len(drawing.beats) - 6 if behind else len(drawing.beats) + 1
    dashed = [line for line in axes.lines if line.get_linestyle() == "--"]
    leads = [line for line in dashed if line.get_marker() == "o"]
    assert len(leads) == (len(drawing.marks) if behind else 0)
    (*_, covered) = [line.get_xdata() for line in dashed if line not in leads] or [[]]
    np.testing.assert_allclose([*covered][:1] + [*covered][-1:], [-0.3, 0.3][: 2 * behind], 0, 0.03)


@pytest.mark.parametrize(("high", "name"), [(0.02, "top view"), (0.3, "side view")])
def test_many_level_paths_are_seen_from_above(high: float, name: str) -> None:
    there = past_a_sphere(0.6).scenery
    points = np.random.default_rng(1).uniform(0.0, 1.0, (100, 3)) * (2.0, 1.0, high)
    assert _view_of(there, points).name == name


@pytest.mark.parametrize(
    ("wide", "hops", "name"),
    [(1.0, 0.01, "top view"), (1.0, 0.3, "side view"), (0.1, 0.01, "side view")],
)
def test_paths_on_a_table_that_leans_are_seen_from_above(
    wide: float, hops: float, name: str
) -> None:
    there = past_a_sphere(0.6).scenery
    points = np.random.default_rng(1).uniform(0.0, 1.0, (100, 3)) * (wide, 2.0, hops)
    points[:, 2] += 0.125 * points[:, 1]
    assert _view_of(there, points).name == name


def test_long_numbers_and_their_name_are_on_the_page() -> None:
    states = hoopgen.release([7.05, 7.2], np.radians(51), height=2.1336, distance=4.191)
    shots = hoopgen.simulate(states, scene=hoopgen.COURT, record=True)
    figure = plot_fan(shots, hoopgen.PAPER_COURT)
    renderer = FigureCanvasAgg(figure).get_renderer()
    (axes,) = figure.axes
    labels = axes.yaxis.get_tightbbox(renderer)
    assert axes.get_ylabel() == "z (m)"
    assert labels is not None
    assert labels.x0 >= 0.0


def test_a_ring_hides_what_is_below_its_wire_and_not_what_is_in_its_hole() -> None:
    ring = Torus("ring", radius=0.3, wire=0.05)
    scene = Scene("one", bodies=[ring], ball_radius=BALL, gravity=9.81, restitution=0.5)
    there = scenery_of(stand_in(scene), {}, np.array([[-0.3, -0.3, -0.3], [0.3, 0.3, 0.3]]))
    axes, view = Figure().add_subplot(), there.look(TOP)
    there.draw(axes, view, 1.0)
    x, z = np.meshgrid([0.0, 0.1, 0.3, 0.5], [-0.3, 0.3])
    points = np.stack([x, 0.01 * np.ones_like(x), z], axis=-1).reshape(-1, 3)
    found = is_hidden(axes.patches, view, points).reshape(2, 4)
    assert found.tolist() == [[False, False, True, False], [False] * 4]


def test_a_long_key_is_below_all_views() -> None:
    path = np.linspace([-1.0, -1.0, -0.5], [1.0, 1.0, 0.5], 81)  # flat views narrower than the page
    drawing = replace(past_a_sphere(0.6, marks=40), path=path)
    figure = _draw(drawing, True, "", ["Released."])
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    boxes = {
        axes.get_label(): [text.get_window_extent(canvas.get_renderer()) for text in axes.texts]
        for axes in figure.axes
    }
    assert max(box.y1 for box in boxes["key"]) < min(box.y0 for box in boxes["3D view"])


def test_without_a_title_there_is_no_room_for_one() -> None:
    drawing = past_a_sphere(0.6)
    tall, low = (_draw(drawing, False, title, ["Released."]) for title in ("Title", ""))
    lines = [figure.texts[-1] for figure in (tall, low)]
    assert [line.get_text() for line in lines] == ["Released."] * 2
    away = [
        (1.0 - line.get_position()[1]) * figure.get_size_inches()[1]
        for line, figure in zip(lines, (tall, low), strict=True)
    ]
    assert away[0] - away[1] == pytest.approx(0.24)
    assert tall.get_size_inches()[1] - low.get_size_inches()[1] == pytest.approx(0.24)


class _Kernels:
    ENDS = ()


class _StandIn:
    """The part of an engine that a picture needs; it needs no derivation."""

    is_hoop = has_hoop = False
    kernels = _Kernels

    def __init__(self, scene: Scene | None) -> None:
        self.table = type("Table", (), {"written": scene})
        self.name = "one" if scene is None else scene.name


def stand_in(scene: Scene | None) -> Any:
    return _StandIn(scene)


def test_a_scene_written_for_derivation_is_refused_in_a_line() -> None:
    with pytest.raises(ValueError, match=r"scene: one is written for derivation; drawn are the ho"):
        SceneGeometry.from_engine(stand_in(None), {})


@pytest.fixture(scope="module")
def netball(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return numpy_engine(load_scene(EXAMPLES / "netball.toml"), tmp_path_factory.mktemp("netball"))


@pytest.fixture(scope="module")
def tilted(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """Free fall along x."""
    scene = Scene(
        "tilted",
        parameters=[Parameter("size", 0.1)],
        bodies=[Plane("floor", axis="-x", at=-1), Sphere("stone", radius="size", centre=(1, 0, 0))],
        ball_radius="size / 2",
        gravity=9.81,
        restitution=0.5,
        down="x",
        ends={"gone_by": End("y", at=-1)},
    )
    return numpy_engine(scene, tmp_path_factory.mktemp("tilted"))


SHOT = [1.6, 0.258, -0.35, -2.317, -0.301, 4.649, 0.0, -12.0, 0.0]  # cap, ring, goal
FALL = [-0.2, 0.0, 0.0, 0.0, -0.6, 0.0, 0.0, 0.0, 0.0]


@pytest.mark.slow
def test_a_shot_is_drawn_with_its_bodies_and_named_contacts(netball: Engine) -> None:
    shots = netball.simulate(SHOT, record=True)
    figure = shots.trajectory(0).plot(title="Netball")
    said = {text.get_text() for axes in figure.axes for text in axes.texts}
    assert {"cap 0.830 s", "ring 1.506 s", "1.614 s, goal"} <= said
    assert {axes.get_label() for axes in figure.axes} >= {"side view", "top view", "3D view"}
    own = body_colours(netball.surfaces)
    side = next(axes for axes in figure.axes if axes.get_label() == "side view")
    marked = {to_hex(text.get_bbox_patch().get_facecolor()).upper() for text in side.texts}  # type: ignore[union-attr]
    assert {own["ring"], own["cap"]} <= marked
    assert any("Scene: netball" in text.get_text() for text in figure.texts)
    # The ring's bounding box in the top view is the ring's, to the width of its wire.
    top = next(axes for axes in figure.axes if axes.get_label() == "top view")
    boxes = [p.get_path().get_extents() for p in top.patches if isinstance(p, PathPatch)]
    assert max(box.x1 for box in boxes) == pytest.approx(0.1975 + 0.0075, abs=1e-3)


@pytest.mark.slow
def test_the_board_of_the_whole_hoop_is_pale_and_its_badge_dark() -> None:
    state = hoopgen.release(8.3, np.radians(50), height=2.1336, distance=4.191)
    shots = hoopgen.simulate(state, scene=hoopgen.COURT, record=True)
    assert hoopgen.COURT.surfaces[shots.first[0]] == "backboard"
    figure = shots.trajectory(0).plot(three_d=True)
    space = next(axes for axes in figure.axes if axes.get_label() == "3D view")
    patches = [patch for patch in space.patches if isinstance(patch, PathPatch)]
    board = max(patches, key=lambda patch: np.prod(patch.get_path().get_extents().size))
    red, green, blue, _ = board.get_facecolor()
    assert min(red, green, blue) > 0.6
    badges = [text.get_bbox_patch() for text in space.texts if text.get_text() == "1"]
    (dark,) = (to_hex(badge.get_facecolor()) for badge in badges if badge is not None)
    assert dark == body_colours(["backboard"])["backboard"]


@pytest.mark.slow
def test_another_parameter_is_drawn_and_said(netball: Engine) -> None:
    shots = netball.simulate(SHOT, {"ring_radius": 0.3}, record=True)
    figure = shots.trajectory(0).plot()
    assert any("netball, ring_radius 0.3." in text.get_text() for text in figure.texts)
    top = next(axes for axes in figure.axes if axes.get_label() == "top view")
    boxes = [p.get_path().get_extents() for p in top.patches if isinstance(p, PathPatch)]
    assert max(box.x1 for box in boxes) == pytest.approx(0.3075, abs=1e-3)


@pytest.mark.slow
def test_many_paths_are_drawn_by_how_they_end(netball: Engine) -> None:
    states = np.array(SHOT) + np.linspace(0.0, 0.3, 20)[:, None] * (np.arange(9) == 3)
    shots = netball.simulate(states, record=True)
    figure = shots.plot(title="Twenty")
    (legend,) = figure.legends
    words = [text.get_text() for text in legend.get_texts()]
    assert [word.split()[0] for word in words] == ["goal", "out", "where"]
    axes = Figure().add_subplot()
    assert shots.plot(ax=axes) is axes


@pytest.mark.slow
def test_a_fan_is_not_much_higher_than_its_paths(netball: Engine) -> None:
    shots = netball.simulate([SHOT], record=True)
    fan = gather_fan(shots, shots.parameters, range(1))
    flight = shots.trajectory(0)
    highest = flight.at(np.linspace(0.0, flight.duration, 1_000))[:, 2].max()
    assert highest < fan.limits()[3] < highest + 0.3


@pytest.mark.slow
def test_on_axes_a_shot_has_a_key_in_the_colours_of_the_bodies(netball: Engine) -> None:
    axes = Figure().add_subplot()
    netball.simulate(SHOT, record=True).trajectory(0).plot(ax=axes)
    key = axes.get_legend()
    assert key is not None
    own = body_colours(netball.surfaces)
    inks = {
        text.get_text().split()[1]: to_hex(line.get_color()).upper()
        for text, line in zip(key.get_texts(), key.get_lines(), strict=True)
    }
    assert (inks["cap"], inks["ring"]) == (own["cap"], own["ring"])
    assert "\N{MINUS SIGN}0.350) m" in axes.get_title(loc="left")


@pytest.mark.slow
def test_a_crowd_of_paths_has_a_panel_for_each_end(netball: Engine) -> None:
    states = np.array(SHOT) + np.linspace(0.0, 0.3, 60)[:, None] * (np.arange(9) == 3)
    shots = netball.simulate(states, record=True)
    goals = int(np.sum(shots.outcome == shots.scene.outcomes["GOAL"]))
    figure = shots.plot()
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles == [f"goal ({goals})", f"out ({60 - goals})"]
    assert "60 are drawn, by outcome" in figure.texts[0].get_text()
    assert len(shots.plot(by="all").axes) == 1
    with pytest.raises(ValueError, match="by: expected auto, all, outcome; got 'kind'"):
        shots.plot(by="kind")


@pytest.mark.slow
def test_the_axes_of_a_turned_scene_are_named(tilted: Engine) -> None:
    shots = tilted.simulate(FALL, record=True, max_contacts=3)
    figure = shots.trajectory(0).plot()
    labels = {axes.get_xlabel() + "|" + axes.get_ylabel() for axes in figure.axes}
    assert {"y (m)|\N{MINUS SIGN}x (m)", "y (m)|\N{MINUS SIGN}z (m)"} <= labels
    assert isinstance(shots.plot(), Figure)


# Pages


def test_a_page_has_the_bodies_and_where_they_are_touched(netball: Engine) -> None:
    shots = netball.simulate(SHOT, record=True)
    data = data_of(page(shots, shots.parameters))
    (shot,) = data["shots"]
    assert data["surfaces"] == list(netball.surfaces)
    assert [event["surface"] for event in shot["events"]] == ["body-2", "body-0", "end"]
    assert shot["outcome"] == "goal"
    assert data["outcomes"][:2] == ["goal", "out"]
    cap, ring = (np.array(event["at"]) for event in shot["events"][:2])
    middle = np.array([-(0.1975 + 0.15 + 0.04), 0, -0.0075])
    assert np.linalg.norm(cap - middle) == pytest.approx(0.04, abs=1e-9)
    assert np.hypot(np.hypot(*ring[:2]) - 0.1975, ring[2]) == pytest.approx(0.0075, abs=1e-9)
    scenery = data["scenery"]
    assert [len(body["points"]) > 50 for body in scenery["bodies"]] == [True] * 3
    assert all(max(body["triangles"]) < len(body["points"]) for body in scenery["bodies"])
    assert page(shots, shots.parameters) == page(shots, shots.parameters)


@pytest.mark.slow
def test_a_page_of_a_turned_scene_falls_down(tilted: Engine) -> None:
    shots = tilted.simulate(FALL, {"size": 0.2}, record=True, max_contacts=3)
    data = data_of(page(shots, shots.parameters))
    (shot,) = data["shots"]
    assert shot["parameters"] == {"ball_radius": 0.1, "gravity": 9.81}
    assert data["scenery"]["axes"] == ["y", "\N{MINUS SIGN}z", "\N{MINUS SIGN}x"]
    start, after = (np.array(flight) for flight in shot["flights"][:2])
    t = after[0]
    assert start[1:4].tolist() == [0.0, 0.0, 0.2]
    assert start[3] + start[6] * t - 9.81 / 2 * t**2 == pytest.approx(after[3], abs=1e-12)


@pytest.mark.parametrize("which", ["netball", "tilted"])
def test_the_browser_draws_any_scene(
    show: Callable[..., Tab],  # noqa: F811
    netball: Engine,
    tilted: Engine,
    which: str,
) -> None:
    engine, state = (netball, SHOT) if which == "netball" else (tilted, FALL)
    shots = engine.simulate([state, state], record=True, max_contacts=3)
    tab = show(page(shots, shots.parameters, title="Any"), size=(1280, 800))
    pixels = tab.pixels()
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 500
    words = tab.text("#events")
    first = engine.surfaces[int(shots.trajectory(0).events["surface"][0])]
    assert first in words
    assert tab.text("#views") == "3DSideTop"
    if which == "netball":
        assert "Goal" in tab.text("#outcome")
        assert "ring’s centre" not in tab.text("#panel")


def test_docs_show_a_picture_of_each_example() -> None:
    shown = (ROOT / "docs" / "your-own-scene.md").read_text(encoding="utf-8")
    names = {file.stem for file in EXAMPLES.iterdir() if file.suffix in (".toml", ".py")}
    assert set(re.findall(r"\]\(scene-(\w+)\.svg\)", shown)) == names == set(pictures.OWN)
    assert all((ROOT / "docs" / f"scene-{name}.svg").is_file() for name in names)


# The command line


HOLE = """\
name = "hole"
ball_radius = 0.1
gravity = 9.81
restitution = "bounce"
parameters.bounce = { default = 0.5, unit = "1" }
bodies.floor = { kind = "plane" }
ends.edge = { axis = "-x", at = -1 }
"""
GIVEN = ("--position", "0,0,1", "--velocity", "1,0,0")


@pytest.fixture(scope="module")
def hole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("hole") / "hole.toml"
    file.write_text(HOLE, encoding="utf-8")
    return file


@pytest.mark.slow
def test_a_shot_of_a_scene_on_the_command_line(hole: Path, tmp_path: Path) -> None:
    picture, seen = tmp_path / "shot.svg", tmp_path / "shot.html"
    told = ("--picture", picture, "--view", seen, "--json")
    result = succeed("shot", "--scene", hole, *GIVEN, "--spin", "0,1Hz,0", *told)
    record = json.loads(result.stdout)
    assert record["outcome"] == "edge"
    assert set(record["counts"]) == {"floor"}
    assert record["release"][7] == pytest.approx(2 * np.pi)
    assert record["scene"] == "hole"
    assert picture.exists()
    assert seen.exists()
    changed = run("shot", "--scene", hole, *GIVEN, "--set", "bounce=0.75")
    assert "hole, bounce 0.75" in changed.output


@pytest.mark.slow
def test_a_shot_of_a_scene_is_proved_on_the_command_line(hole: Path) -> None:
    pytest.importorskip("flint")
    result = succeed("certify", "--scene", hole, *GIVEN, "--max-contacts", 2)
    assert re.search(r"outcome +capped", result.output)
    assert "floor" in result.output


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--speed", "3"), "--speed is of a shot at a hoop; with --scene give --position and"),
        ((), "missing --position and --velocity"),
        ((*GIVEN, "--preset", "nba"), "--preset nba is not one of the scene hole: it has none"),
        ((*GIVEN, "--set", "spring=2"), "'spring' is none of bounce"),
        ((*GIVEN, "--set", "bounce=x"), "bounce: 'x' is not a number"),
        (
            ("--position", "0,0,0.05", "--velocity", "1,0,0"),
            "this shot is invalid: inside ",
        ),
        (("--position", "1,2", "--velocity", "1,0,0"), "expected three with commas between"),
    ],
)
def test_what_is_no_shot_of_a_scene_is_refused_in_a_line(
    hole: Path, words: tuple[str, ...], said: str
) -> None:
    result = run("shot", "--scene", hole, *words)
    assert result.exit_code == 2
    assert said in result.output
    assert len(result.output.strip().splitlines()) == 1


def test_a_position_without_a_scene_is_refused() -> None:
    result = run("shot", *GIVEN)
    assert result.exit_code == 2
    assert "--position is of a shot in a --scene; give that, too" in result.output


# Studies


STUDIES: dict[str, dict[str, Any]] = {
    "margins": {"model": None},
    "bank_or_direct": {"model": None, "places": []},
}


@pytest.mark.parametrize("name", STUDIES)
def test_a_hoops_study_refuses_another_scene_in_a_line(name: str, netball: Engine) -> None:
    pytest.importorskip("xarray")
    with pytest.raises(ValueError, match=rf"^{name}: its question is a hoop's, and the scene net"):
        getattr(hoopgen, name)(**STUDIES[name], scene=netball)


def test_a_hoops_measures_refuse_another_scenes_shots(netball: Engine) -> None:
    with pytest.raises(ValueError, match=r"^measure: its question is a hoop's"):
        hoopgen.measure(SHOT, netball.simulate(SHOT))


def test_a_ball_that_meets_a_body_at_once_is_described_as_it_was_released() -> None:
    shots = hoopgen.simulate([4.191, 0, -0.6, -4.4, 0, 5.31, 0, 18.85, 0], record=True)
    flight = shots.trajectory(0)
    first = flight.events[:1].copy()
    first["time"], first["after"] = 0.0, flight.release / 2
    met = replace(flight, events=np.concatenate([first, flight.events]))
    assert met.at(0.0)[3] == flight.release[3] / 2
    assert describe_shot(met, hoopgen.PAPER) == describe_shot(flight, hoopgen.PAPER)
