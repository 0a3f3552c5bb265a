"""Pictures of studies: they show what the data say, can be read by all, and are small files."""

from __future__ import annotations

import itertools
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose

import hoopgen
from hoopgen import Outcome
from hoopgen.core.units import FOOT
from tests.helpers import ROOT

pytest.importorskip("matplotlib")
xr = pytest.importorskip("xarray")

from matplotlib.axes import Axes  # noqa: E402
from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402
from matplotlib.collections import (  # noqa: E402
    FillBetweenPolyCollection,
    LineCollection,
    PathCollection,
    PolyCollection,
    QuadMesh,
)
from matplotlib.colors import to_hex  # noqa: E402
from matplotlib.contour import QuadContourSet  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.patches import Circle, Rectangle  # noqa: E402
from matplotlib.text import Text  # noqa: E402

from hoopgen.hoop.court_lines import COURTS  # noqa: E402
from hoopgen.hoop.kinds import Kind, kinds  # noqa: E402
from hoopgen.hoop.places import on_board, say_on_board  # noqa: E402
from hoopgen.plots import (  # noqa: E402
    COLUMN,
    PAGE,
    plot_aim,
    plot_aim_points,
    plot_estimate,
    plot_fan,
    plot_landings,
    plot_map,
    save,
)
from hoopgen.plots.class_legend import CLASSES, classify  # noqa: E402
from hoopgen.plots.style import LINES, MADE, MISSED, OTHER_OUTCOME_COLOURS  # noqa: E402
from hoopgen.study.questions.aim_table import aim_table  # noqa: E402

FREE_THROW = {"height": 2.1336, "distance": 4.191, "backspin": 6.0 * np.pi}
SCENE = hoopgen.NBA
EPS = np.finfo(float).eps


# ------------------------------------------------------------------------------------ the data


def kind_map(*, columns: int = 90, backspins: int = 0) -> Any:
    """Outcomes and kinds over speed and elevation, as `hoopgen.map` gives them."""
    over = {
        "speed": np.linspace(6.6, 8.6, columns),
        "elevation": np.radians(np.linspace(38.0, 66.0, 50)),
    } | ({"backspin": 2.0 * np.pi * np.arange(backspins)} if backspins else {})
    fixed = {name: value for name, value in FREE_THROW.items() if name not in over}
    grid = hoopgen.Grid(over, fixed)
    released = grid.draw(0, grid.shots, parameters=SCENE)
    shots = hoopgen.simulate(released.states, released.parameters)
    kind = kinds(shots.outcome, shots.counts, shots.first)
    data = {
        "outcome": (tuple(over), shots.outcome.reshape(grid.shape)),
        "kind": (tuple(over), kind.reshape(grid.shape)),
    }
    return xr.Dataset(data, over | fixed)


def probability_map(*, backspins: int = 0) -> Any:
    """A smooth hill over speed and elevation, its top at 7.2 m/s and 52 degrees."""
    over = {
        "speed": np.linspace(7.0, 7.4, 21),
        "elevation": np.radians(np.linspace(46.0, 58.0, 25)),
    } | ({"backspin": 2.0 * np.pi * np.arange(backspins)} if backspins else {})
    speed, elevation, *spin = np.meshgrid(*over.values(), indexing="ij")
    height = 0.7 - (0.05 * spin[0] / (2.0 * np.pi) if spin else 0.0)
    hill = height * np.exp(
        -(((speed - 7.2) / 0.1) ** 2) - ((elevation - np.radians(52)) / 0.1) ** 2
    )
    data = {
        name: (tuple(over), hill + step)
        for name, step in (("probability", 0.0), ("low", -0.01), ("high", 0.01))
    }
    told = {"confidence": 0.95, "seed": "7", "sd": '{"speed": 0.07}'}
    data["shots"] = (tuple(over), np.full(hill.shape, 1000))
    return xr.Dataset(data, over | {"distance": 4.191}, told)


def shots_of(count: int, mean: Mapping[str, float] | None = None) -> hoopgen.Shots:
    states = hoopgen.Scatter(
        {**FREE_THROW, "speed": 7.17, "elevation": np.radians(52.0), **(mean or {})},
        {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1.0)},
    ).draw(0, count, parameters=SCENE)
    return hoopgen.simulate(states.states, SCENE, record=True)


def landings(count: int = 4000) -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(5)
    return random.normal(0.8, 1.0, count), random.normal(0.0, 1.2, count)


def aims() -> Any:
    """Three places with a bank shot, of each verdict one, and one without."""
    nan = np.nan
    columns = {
        "touch_y": [-0.4, 0.01, 0.3, nan],
        "touch_z": [0.6, 0.35, 0.4, nan],
        "difference_low": [0.02, -0.01, -0.09, -0.8],
        "difference_high": [0.05, 0.02, -0.04, -0.7],
    }
    places = {"x": [0.8, 4.2, 2.0, 6.0], "y": [-3.0, 0.0, 2.5, 0.0]}
    return xr.Dataset(
        {name: ("place", column) for name, column in columns.items()},
        {name: ("place", column) for name, column in places.items()},
    )


def court_map(*, backspins: int = 0, kind: bool = False) -> Any:
    """A share, or kinds, over places on the floor: none near the basket."""
    over = {"x": np.linspace(-1.0, 8.0, 19), "y": np.linspace(-7.0, 7.0, 29)} | (
        {"backspin": 2.0 * np.pi * np.arange(backspins)} if backspins else {}
    )
    x, y, *_ = np.meshgrid(*over.values(), indexing="ij")
    away = np.hypot(x, y)
    told = {"parameters": json.dumps(dict(SCENE)), "scene": "NBA", "seed": "7"}
    if kind:
        codes = {"outcome": np.where(away < 1.0, 4, 0), "kind": np.where(away < 1.0, 6, 0)}
        return xr.Dataset({n: (tuple(over), code) for n, code in codes.items()}, over, told)
    share = np.where(away < 1.0, np.nan, 0.9 - away / 15.0)
    columns = {"probability": share, "low": share - 0.01, "high": share + 0.01}
    return xr.Dataset({n: (tuple(over), column) for n, column in columns.items()}, over, told)


def aim_rows() -> dict[str, np.ndarray]:
    return aim_table(np.linspace(2.0, 7.0, 6), height=2.0, entry=np.radians(45.0))


def estimated() -> Any:
    model = hoopgen.Scatter(
        {**FREE_THROW, "speed": 7.17, "elevation": np.radians(52.0)}, {"speed": 0.1}
    )
    return hoopgen.estimate(model, SCENE, shots=300)


PICTURES: dict[str, Callable[[float], Figure]] = {
    "kinds": lambda width: plot_map(kind_map(), title="Kinds", width=width),
    "strip": lambda width: plot_map(kind_map().isel(elevation=25), width=width),
    "probability": lambda width: plot_map(probability_map(), title="Hill", width=width),
    "line": lambda width: plot_map(probability_map().isel(elevation=12), width=width),
    "panels": lambda width: plot_map(probability_map(backspins=5), width=width),
    "kind panels": lambda width: plot_map(kind_map(columns=20, backspins=4), width=width),
    "fan": lambda width: plot_fan(shots_of(400), SCENE, title="Fan", width=width),
    "landings": lambda width: plot_landings(*landings(), SCENE, place=(4.191, 0), width=width),
    "aim points": lambda width: plot_aim_points(aims(), SCENE, title="Bank", width=width),
    "court": lambda width: plot_map(court_map(), title="Court", width=width),
    "courts": lambda width: plot_map(court_map(backspins=3), width=width),
    "court of kinds": lambda width: plot_map(court_map(kind=True), width=width),
    "shares": lambda width: plot_estimate(estimated(), title="Shares", width=width),
    "aims": lambda width: plot_aim(aim_rows(), SCENE, title="Aims", width=width),
}


@pytest.fixture(scope="module", params=itertools.product(PICTURES, (COLUMN, PAGE)), ids=str)
def page(request: pytest.FixtureRequest) -> tuple[str, float, Figure]:
    name, width = request.param
    figure = PICTURES[name](width)
    FigureCanvasAgg(figure).draw()
    return name, width, figure


def axes_of(figure: Figure, label: str) -> Axes:
    (axes,) = (axes for axes in figure.axes if axes.get_label() == label)
    return axes


def one(axes: Axes, kind: type) -> Any:
    (artist,) = axes.findobj(lambda artist: type(artist) is kind)
    return artist


def key_of(figure: Figure) -> list[str]:
    (legend,) = figure.legends
    return [text.get_text() for text in legend.get_texts()]


def words(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.texts]


# ------------------------------------------------------------------------------------ every page


@pytest.mark.sampled(1)
def test_a_page_is_as_wide_as_asked_for(page: tuple[str, float, Figure]) -> None:
    name, width, figure = page
    across, up = figure.get_size_inches()
    # A picture to scale that would be too tall is narrower instead.
    assert across == width or (name in ("landings", "courts") and across < width)
    assert up <= 9.5


@pytest.mark.sampled(1)
def test_all_is_said_on_the_page_and_legibly(page: tuple[str, float, Figure]) -> None:
    _, _, figure = page
    width, height = figure.bbox.size
    for text in figure.findobj(Text):
        box = text.get_window_extent()
        if not text.get_text().strip() or not text.get_visible() or _hidden(text, figure):
            continue
        assert text.get_fontsize() >= 6.5
        # Half a point more than the page: an anti-aliased edge.
        assert box.x0 >= -0.5, text
        assert box.y0 >= -0.5, text
        assert box.x1 <= width + 0.5, text
        assert box.y1 <= height + 0.5, text


def _hidden(text: Text, figure: Figure) -> bool:
    """Tell labels of ticks that are not shown."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                if text in (tick.label1, tick.label2):
                    away = 1e-9 * (high - low)  # a tick on the edge, rounded
                    return not low - away <= tick.get_loc() <= high + away
    return False


@pytest.mark.sampled(3)
def test_texts_of_a_key_are_not_over_one_another(page: tuple[str, float, Figure]) -> None:
    _, _, figure = page
    for legend in figure.legends:
        boxes = [text.get_window_extent() for text in legend.get_texts()]
        assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))


@pytest.mark.sampled(1)
def test_titles_and_names_of_axes_are_not_over_one_another(
    page: tuple[str, float, Figure],
) -> None:
    _, _, figure = page
    texts = [*figure.texts]
    for axes in figure.axes:
        texts += [axes._left_title, axes.xaxis.label, axes.yaxis.label]
    boxes = [text.get_window_extent() for text in texts if text.get_text().strip()]
    assert not any(a.overlaps(b) for a, b in itertools.combinations(boxes, 2))


@pytest.mark.sampled(1)
def test_axes_are_named_with_units(page: tuple[str, float, Figure]) -> None:
    _, _, figure = page
    said = [axes.get_xlabel() for axes in figure.axes] + [axes.get_ylabel() for axes in figure.axes]
    assert any(said)
    assert all(re.search(r"\((m|m/s|°|%|Hz|% per m²)\)$", label) for label in said if label)


@pytest.mark.slow
def test_pictures_of_places_are_to_scale() -> None:
    for name in ("fan", "landings", "aim points", "court", "courts", "court of kinds"):
        for axes in PICTURES[name](PAGE).axes:
            if axes.get_label() in ("side view", "floor plan", "front view"):
                origin, across, up = axes.transData.transform([(0, 0), (1, 0), (0, 1)])
                # Pixels of a page a thousand wide, each the sum of a few rounded numbers.
                assert across[0] - origin[0] == pytest.approx(up[1] - origin[1], rel=1e-9, abs=0)


# ------------------------------------------------------------------------------------ kinds


def test_every_outcome_and_kind_together_has_one_class() -> None:
    for outcome, kind in itertools.product(("made", "missed"), Kind):
        possible = kind.name.lower() in {"made": MADE, "missed": MISSED}[outcome]
        if possible:
            place = int(classify(Outcome[outcome.upper()], kind))
            assert (CLASSES[place].outcome, CLASSES[place].kind) == (outcome, kind.name.lower())
        else:
            with pytest.raises(ValueError, match=f"{outcome.upper()} and {kind.name}"):
                classify(Outcome[outcome.upper()], kind)
    for outcome in OTHER_OUTCOME_COLOURS:
        for kind in Kind:
            assert CLASSES[int(classify(Outcome[outcome.upper()], kind))].outcome == outcome


@pytest.mark.parametrize(
    ("outcome", "kind", "named"), [(len(Outcome), 0, "outcome"), (0, 7, "kind")]
)
def test_a_code_that_is_none_is_refused(outcome: int, kind: int, named: str) -> None:
    with pytest.raises(ValueError, match=f"{named}: expected codes of 0 "):
        classify([outcome], [kind])


def test_a_cell_has_the_colour_of_its_kind() -> None:
    dataset = kind_map()
    mesh = one(plot_map(dataset).axes[0], QuadMesh)
    drawn = mesh.to_rgba(mesh.get_array())
    outcome, kind = dataset["outcome"].values.T, dataset["kind"].values.T
    assert drawn.shape[:2] == outcome.shape == (50, 90)
    for place in np.ndindex(outcome.shape):
        what, touched = Outcome(outcome[place]).name.lower(), Kind(kind[place]).name.lower()
        wanted = {"made": MADE, "missed": MISSED}.get(what, {}).get(
            touched
        ) or OTHER_OUTCOME_COLOURS[what]
        assert to_hex(drawn[place]).upper() == wanted


def test_a_cell_reaches_halfway_to_its_neighbours() -> None:
    dataset = kind_map()
    corners = one(plot_map(dataset).axes[0], QuadMesh).get_coordinates()
    speed, elevation = dataset["speed"].values, np.degrees(dataset["elevation"].values)
    # A sum and a half of it, each rounded.
    np.testing.assert_allclose(
        corners[0, 1:-1, 0], (speed[1:] + speed[:-1]) / 2, rtol=4 * EPS, atol=0
    )
    np.testing.assert_allclose(
        corners[1:-1, 0, 1], (elevation[1:] + elevation[:-1]) / 2, rtol=4 * EPS, atol=0
    )


def test_the_key_names_what_is_there_and_nothing_else() -> None:
    dataset = kind_map()
    figure = plot_map(dataset)
    places = np.unique(classify(dataset["outcome"], dataset["kind"]))
    (legend,) = figure.legends
    swatches = [to_hex(patch.get_facecolor()).upper() for patch in legend.get_patches()]
    assert swatches == [CLASSES[place].colour for place in places]
    assert key_of(figure) == [CLASSES[place].words for place in places]


# ------------------------------------------------------------------------------------ probabilities


def test_cells_hold_the_probabilities() -> None:
    dataset = probability_map()
    mesh = one(plot_map(dataset).axes[0], QuadMesh)
    np.testing.assert_array_equal(mesh.get_array(), dataset["probability"].values.T)
    assert mesh.norm.vmin == 0.0
    assert mesh.norm.vmax >= dataset["probability"].max()


def test_contours_are_at_round_levels_and_labelled() -> None:
    figure = plot_map(probability_map())
    contours = one(figure.axes[0], QuadContourSet)
    # Products of a step and a number.
    np.testing.assert_allclose(contours.levels, np.arange(0.1, 0.65, 0.1), rtol=4 * EPS, atol=0)
    assert set(words(figure.axes[0])) == {f"{level}%" for level in (10, 20, 30, 40, 50, 60)}
    bar = figure.axes[1]
    assert bar.get_ylabel() == "shots made (%)"
    FigureCanvasAgg(figure).draw()
    said = [label.get_text() for label in bar.get_yticklabels()]
    assert said == ["0", "10", "20", "30", "40", "50", "60", "70"]


def test_the_best_cell_is_marked_and_said() -> None:
    axes = plot_map(probability_map()).axes[0]
    (mark,) = (line for line in axes.lines if line.get_label() == "_best")
    # The values of linspace, and radians turned into degrees.
    assert mark.get_xdata()[0] == pytest.approx(7.2, rel=4 * EPS, abs=0)
    assert mark.get_ydata()[0] == pytest.approx(52.0, rel=4 * EPS, abs=0)
    assert axes.get_title(loc="left") == "○ best 70.0% (69.0% to 71.0%) at 7.2 m/s, 52°"


def test_where_nothing_is_made_nothing_is_best() -> None:
    dataset = probability_map()
    dataset["probability"][:] = 0.0
    for shown in (dataset, dataset.isel(elevation=3)):
        axes = plot_map(shown).axes[0]
        assert axes.get_title(loc="left") == ""
        assert not [line for line in axes.lines if line.get_label() == "_best"]


def test_cells_that_have_no_probability_stay_empty() -> None:
    dataset = probability_map()
    dataset["probability"][:5] = np.nan
    figure = plot_map(dataset)
    FigureCanvasAgg(figure).draw()
    mesh = one(figure.axes[0], QuadMesh)
    assert mesh.get_array().mask[:, :5].all()
    assert "70.0%" in figure.axes[0].get_title(loc="left")


def test_a_line_has_no_interval_where_there_is_no_flight() -> None:
    dataset = probability_map().isel(elevation=12).copy(deep=True)
    for name, nothing in (("probability", np.nan), ("low", 0.0), ("high", 1.0)):
        dataset[name][:5] = nothing
    band = one(plot_map(dataset).axes[0], FillBetweenPolyCollection)
    first = min(corner[0] for path in band.get_paths() for corner in path.vertices)
    assert first == dataset["speed"].values[5]


def test_a_line_has_its_interval() -> None:
    dataset = probability_map().isel(elevation=12)
    axes = plot_map(dataset).axes[0]
    line = next(line for line in axes.lines if line.get_label() == "estimate")
    np.testing.assert_array_equal(line.get_xdata(), dataset["speed"])
    np.testing.assert_array_equal(line.get_ydata(), dataset["probability"])
    band = one(axes, FillBetweenPolyCollection)
    corners = {tuple(corner) for corner in band.get_paths()[0].vertices}
    for bound in ("low", "high"):
        assert corners >= set(zip(dataset["speed"].values, dataset[bound].values, strict=True))
    assert [text.get_text() for text in axes.get_legend().get_texts()] == [
        "95% interval",
        "estimate",
    ]


def test_a_third_variable_gives_panels_of_one_scale() -> None:
    dataset = probability_map(backspins=5)
    figure = plot_map(dataset)
    *panels, _ = figure.axes
    titles = [axes.get_title(loc="left").splitlines()[0] for axes in panels]
    assert titles == [f"backspin {spin} Hz" for spin in range(5)]
    meshes = [one(axes, QuadMesh) for axes in panels]
    assert len({(mesh.norm.vmin, mesh.norm.vmax) for mesh in meshes}) == 1
    for spin, mesh in enumerate(meshes):
        np.testing.assert_array_equal(
            mesh.get_array(), dataset["probability"].isel(backspin=spin).values.T
        )


def test_what_is_the_same_in_all_cells_is_said() -> None:
    dataset = probability_map(backspins=3)
    said = [text.get_text() for text in plot_map(dataset.isel(backspin=2)).texts]
    assert " ".join(said) == (
        "Backspin 2 Hz, distance from the ring's centre 4.191 m. "
        "Standard deviations: release speed 0.07 m/s. 1,000 shots a cell, seed 7."
    )
    assert [text.get_text() for text in plot_map(dataset, note="mine").texts] == ["mine"]


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda data: data.drop_vars("probability"), "dataset: expected the variable probability"),
        (lambda data: data.isel(speed=0, elevation=0), "got none. Select"),
        (lambda data: data.expand_dims({"a": 2, "b": 3}), r"a \(2\), b \(3\), speed \(21\)"),
        (
            lambda data: data.expand_dims({"height": np.linspace(1.8, 2.4, 13)}, -1),
            r"up to 12 values; got speed \(21\), elevation \(25\), height \(13\)",
        ),
        (lambda data: data.isel(speed=[3, 1, 2]), "coordinate speed: expected numbers in order"),
        (
            lambda data: data.isel(speed=[0, 1]).assign_coords(speed=["slow", "fast"]),
            "coordinate speed: expected numbers in order",
        ),
    ],
)
def test_a_dataset_that_cannot_be_drawn_is_refused(
    spoil: Callable[[Any], Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        plot_map(spoil(probability_map()))


def test_what_is_not_there_cannot_be_shown() -> None:
    with pytest.raises(ValueError, match=r"of: expected kind or outcome .* got 'probability'$"):
        plot_map(kind_map(), of="probability")


def test_variables_of_no_release_are_named_as_the_dataset_names_them() -> None:
    dataset = probability_map().rename(speed="humidity")
    dataset["humidity"].attrs.update(units="g/m³", long_name="water in the air")
    assert plot_map(dataset).axes[0].get_xlabel() == "water in the air (g/m³)"


@pytest.mark.slow
def test_the_map_of_hoopgen_is_drawn() -> None:
    over = {"speed": [7.1, 7.2, 7.3], "elevation": np.radians([50.0, 52.0])}
    figure = plot_map(hoopgen.map(hoopgen.Scatter(FREE_THROW, {"speed": 0.07}), over, shots=50))
    assert one(figure.axes[0], QuadMesh).get_array().shape == (2, 3)
    assert plot_map(hoopgen.map(hoopgen.Scatter(FREE_THROW), over)).legends


# ------------------------------------------------------------------------------------ the fan


def test_a_fan_has_each_path_in_its_colour() -> None:
    shots = shots_of(60)
    kind = kinds(shots.outcome, shots.counts, shots.first)
    for axes in plot_fan(shots, SCENE, paths=40).axes[:2]:
        lines = one(axes, PathCollection)
        assert len(lines.get_paths()) == 40
        found = {
            tuple(np.round(path.vertices[-1], 9)): to_hex(colour).upper()
            for path, colour in zip(lines.get_paths(), lines.get_edgecolors(), strict=True)
        }
        for shot in range(40):
            end = shots.trajectory(shot).events[-1]["after"][[0, 2]]
            what, touched = Outcome(shots.outcome[shot]).name.lower(), Kind(kind[shot]).name.lower()
            wanted = LINES.get(what, {}).get(touched)
            assert found[tuple(np.round(end, 9))] == (wanted or OTHER_OUTCOME_COLOURS[what])


@pytest.mark.slow
def test_made_shots_are_drawn_over_missed_ones() -> None:
    lines = one(plot_fan(shots_of(100), SCENE).axes[0], PathCollection)
    made = [to_hex(colour).upper() in LINES["made"].values() for colour in lines.get_edgecolors()]
    assert made == sorted(made)
    assert set(made) == {False, True}


def test_a_path_is_the_parabolas_themselves() -> None:
    shots = shots_of(5)
    lines = one(plot_fan(shots, SCENE).axes[0], PathCollection)
    ends = {tuple(path.vertices[-1]): path for path in lines.get_paths()}
    for shot in range(5):
        trajectory = shots.trajectory(shot)
        path = ends[tuple(trajectory.events[-1]["after"][[0, 2]])]
        times = np.concatenate([[0.0], trajectory.events["time"]])
        corners = path.vertices[::2], path.vertices[1::2]
        assert len(corners[0]) == len(times)
        halfway = (corners[0][:-1] + 2.0 * corners[1] + corners[0][1:]) / 4.0
        there = trajectory.at((times[:-1] + times[1:]) / 2.0)[:, [0, 2]]
        # Some ten operations on numbers below 8: each rounds by no more than 4 eps.
        np.testing.assert_allclose(halfway, there, rtol=0, atol=64 * EPS)


def test_the_key_of_a_fan_has_the_shares_of_all_shots() -> None:
    shots = shots_of(500)
    figure = plot_fan(shots, SCENE, paths=10)
    kind = kinds(shots.outcome, shots.counts, shots.first)
    said = key_of(figure)
    for what, touched in set(zip(shots.outcome.tolist(), kind.tolist(), strict=True)):
        if what in (Outcome.MADE, Outcome.MISSED):
            share = np.mean((shots.outcome == what) & (kind == touched))
            assert f"{CLASSES[int(classify(what, touched))].words} {100 * share:.1f}%" in said
    made = np.mean(shots.outcome == Outcome.MADE)
    note = f"500 shots, {100 * made:.1f}% made; 10 are drawn. Scene: NBA."
    assert note in [text.get_text() for text in figure.texts]


def test_shares_of_a_fan_are_of_the_valid_shots() -> None:
    """Invalid shots, here from inside the ring's wire, have no path either."""
    states = np.array([shots_of(8).trajectory(shot).release for shot in range(8)])
    inside = np.zeros((2, 9))
    inside[:, 0] = hoopgen.NBA["ring_radius"]
    shots = hoopgen.simulate(np.vstack([inside, states]), SCENE, record=True)
    figure = plot_fan(shots, SCENE)
    made = np.mean(shots.outcome[2:] == Outcome.MADE)
    note = f"8 valid shots, {100 * made:.1f}% made, and 2 invalid; 8 are drawn."
    assert any(text.get_text().startswith(note) for text in figure.texts)
    said = key_of(figure)
    assert not any("invalid" in words for words in said)
    shares = [float(words.rpartition(" ")[2].rstrip("%")) for words in said if "%" in words]
    assert sum(shares) == pytest.approx(100, abs=0.3)


def test_a_fan_from_the_side_of_the_court_is_seen_across_its_line() -> None:
    shots = shots_of(20, {"angle": np.radians(60.0), "distance": 5.0})
    for axes in plot_fan(shots, SCENE).axes[:1]:
        starts = [path.vertices[0] for path in one(axes, PathCollection).get_paths()]
        # The sine and cosine of the place, and a projection.
        np.testing.assert_allclose(starts, [[5.0, 2.1336 - 3.048]] * 20, rtol=0, atol=64 * EPS)


def test_valid_shots_without_a_path_are_counted_and_not_drawn() -> None:
    states = hoopgen.release(
        [7.17, 3.0, np.nan, 7.2], np.radians(52.0), height=2.1336, distance=4.191
    )
    figure = plot_fan(hoopgen.simulate(states, SCENE, record=True), SCENE)
    assert len(one(figure.axes[0], PathCollection).get_paths()) == 2
    assert "short 33.3%" in key_of(figure)
    assert any("3 valid shots" in text.get_text() for text in figure.texts)


def test_parameters_may_differ_from_shot_to_shot() -> None:
    states = hoopgen.release([7.1, 7.2], np.radians(52.0), height=2.1336, distance=4.191)
    scene = SCENE | {"restitution": np.array([0.6, 0.8]), "ball_radius": np.array([0.12, 0.122])}
    plot_fan(hoopgen.simulate(states, scene, record=True), scene)


@pytest.mark.slow
def test_many_paths_have_a_panel_for_each_kind() -> None:
    shots = shots_of(200)
    figure = plot_fan(shots, SCENE)
    whole, *panels = figure.axes
    assert len(one(whole, PathCollection).get_paths()) == 120
    place = classify(shots.outcome, kinds(shots.outcome, shots.counts, shots.first))[:120]
    for axes, each in zip(panels, np.unique(place).tolist(), strict=True):
        lines, which = one(axes, PathCollection), CLASSES[each]
        assert {to_hex(colour).upper() for colour in lines.get_edgecolors()} == {which.line}
        count = np.count_nonzero(place == each)
        assert len(lines.get_paths()) == count
        assert axes.get_title(loc="left") == f"{which.words} ({count})"
        assert axes.get_xlim() == panels[0].get_xlim()
    assert "120 are drawn, by kind (how many of each)." in said(figure)
    assert len(plot_fan(shots, SCENE, paths=40).axes) == 2


@pytest.mark.slow
def test_a_fan_by_release_angle_has_each_path_in_its_panel() -> None:
    shots = shots_of(60)
    angles = [
        float(np.degrees(np.arctan2(v[5], np.hypot(v[3], v[4]))))
        for v in (shots.trajectory(shot).release for shot in range(60))
    ]
    _, *panels = plot_fan(shots, SCENE, by="elevation").axes
    assert len(panels) > 1
    for axes in panels:
        named = re.fullmatch(r"(\d+)° to (\d+)° \((\d+)\)", axes.get_title(loc="left"))
        assert named
        low, high, count = map(int, named.groups())
        assert count == sum(low <= angle < high for angle in angles)
        assert len(one(axes, PathCollection).get_paths()) == count


@pytest.mark.slow
def test_paths_are_parted_by_what_there_is_on_a_page_of_its_own() -> None:
    shots = shots_of(50)
    assert len(plot_fan(shots, SCENE, by="outcome").axes) == 1 + len(set(shots.outcome.tolist()))
    assert len(plot_fan(shots, SCENE, by="all").axes) == 2
    with pytest.raises(
        ValueError, match="by: expected auto, all, kind, outcome, elevation; got 's"
    ):
        plot_fan(shots, SCENE, by="speed")
    axes = Figure().subplots()
    with pytest.raises(ValueError, match="ax: by 'kind' there are several panels"):
        plot_fan(shots, SCENE, by="kind", ax=axes)
    assert plot_fan(shots, SCENE, ax=axes) is axes


def test_a_fan_of_nothing_is_refused() -> None:
    shots = shots_of(2)
    with pytest.raises(ValueError, match="paths: expected a whole number from 1, got 0"):
        plot_fan(shots, SCENE, paths=0)
    short = hoopgen.release([3.0], np.radians(52.0), height=2.1336, distance=4.191)
    with pytest.raises(ValueError, match="shots: expected one at least"):
        plot_fan(hoopgen.simulate(short, SCENE, record=True), SCENE)
    with pytest.raises(AttributeError, match="record=True"):
        plot_fan(hoopgen.simulate(short, SCENE), SCENE)


# ------------------------------------------------------------------------------------ landings


@pytest.mark.parametrize("place", [(1e9, 0.0), (4.2, -1e12)])
def test_landings_far_away_and_a_tiny_ball_make_no_endless_picture(
    place: tuple[float, float],
) -> None:
    scene = SCENE | {"ball_radius": 1e-12}
    axes = axes_of(
        plot_landings([0.5, 0.5, 0.5], [1.0, 1.0, 1.0], scene, place=place), "floor plan"
    )
    (cells,) = axes.collections
    assert len(cells.get_array()) <= 2 * 501**2


def test_densities_add_up_to_all_that_is_shown() -> None:
    x, y = landings()
    axes = axes_of(plot_landings(x, y, SCENE), "floor plan")
    cells = next(c for c in axes.collections if isinstance(c, PolyCollection))
    corners = cells.get_paths()[0].vertices[:-1]
    following = np.roll(corners, -1, axis=0)
    area = abs(np.sum(corners[:, 0] * following[:, 1] - corners[:, 1] * following[:, 0])) / 2.0
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    seen = (y >= left) & (y <= right) & (-x >= bottom) & (-x <= top)
    # Cells at the upper and right border reach a cell further than the picture.
    shown = float(cells.get_array().sum() * area)
    assert 100.0 * seen.mean() - 1e-9 <= shown <= 100.0
    assert shown > 99.0


def test_circles_hold_half_and_nine_tenths() -> None:
    x, y = landings()
    axes = axes_of(plot_landings(x, y, SCENE), "floor plan")
    radii = [patch.radius for patch in axes.patches if isinstance(patch, Circle)]
    held = [np.mean(np.hypot(x, y) <= radius) for radius in radii]
    # A quantile lies between two of the 4000 balls.
    assert held == pytest.approx([0.5, 0.9], rel=0, abs=1 / 4000)
    assert {f"50% within {radii[0]:.2f} m", f"90% within {radii[1]:.2f} m"} <= set(words(axes))


def test_the_floor_plan_is_seen_as_the_shooter_sees_it() -> None:
    figure = plot_landings([1.0], [0.5], SCENE, place=(4.191, 0.0))
    axes = axes_of(figure, "floor plan")
    (mark,) = (line for line in axes.lines if line.get_label() == "release")
    assert (mark.get_xdata()[0], mark.get_ydata()[0]) == (0.0, -4.191)
    FigureCanvasAgg(figure).draw()
    ticks = zip(axes.get_yticks(), axes.get_yticklabels(), strict=True)
    for at, label in ticks:
        assert float(label.get_text().replace("−", "-")) == pytest.approx(-at, rel=EPS, abs=0)


def court_lines(axes: Axes) -> dict[str, np.ndarray]:
    """The lines of the court on a floor plan, by name: x and y from the ring's centre."""
    marked = {str(line.get_label()): line for line in axes.lines}
    return {
        label.removeprefix("_court "): line.get_xydata()[:, ::-1] * (-1.0, 1.0)
        for label, line in marked.items()
        if label.startswith("_court ")
    }


@pytest.mark.parametrize("name", COURTS)
def test_the_lines_are_those_of_the_rule_books(name: str) -> None:
    lines = court_lines(axes_of(plot_landings([1.0], [0.5], SCENE, court=name), "floor plan"))
    front = -SCENE["board_distance"]

    def near(found: float, wanted: float) -> None:
        assert found == pytest.approx(wanted, rel=8 * EPS, abs=8 * EPS)

    def wide(line: str) -> float:
        return float(np.ptp(lines[line][:, 1]))

    def far(line: str) -> float:
        return float(lines[line][:, 0].max())

    # NBA, rule 1: the free-throw line is 15 ft from the board, the lane 16 ft wide; FIBA, articles
    # 2.4.3 to 2.4.7: the free-throw line is 5.8 m from the baseline, 1.2 m behind the board.
    nba = name == "NBA"
    near(far("lane") - front, 15 * FOOT if nba else 5.8 - 1.2)
    near(front - lines["lane"][:, 0].min(), 4 * FOOT if nba else 1.2)
    near(wide("lane"), 16 * FOOT if nba else 4.9)
    near(wide("circle"), 12 * FOOT if nba else 3.6)
    near(far("circle") - far("lane"), 6 * FOOT if nba else 1.8)
    near(far("three"), 23.75 * FOOT if nba else 6.75)
    near(wide("sides"), 50 * FOOT if nba else 15.0)
    near(wide("three"), wide("sides") - 2 * (3 * FOOT if nba else 0.9))
    near(float(np.ptp(lines["sides"][:, 0])), 47 * FOOT if nba else 14.0)
    # About the ring's centre, and straight up to the plane of the board.
    near(far("restricted"), 4 * FOOT if nba else 1.25)
    near(float(lines["restricted"][0, 0]), front)
    arc = np.hypot(*lines["restricted"][1:-1].T)
    assert_allclose(arc, far("restricted"), rtol=4 * EPS, atol=0)
    assert_allclose(np.hypot(*lines["three"][1:-1].T), far("three"), rtol=4 * EPS, atol=0)
    # The arc meets the straight lines in the corners, which begin at the baseline.
    near(float(lines["three"][1, 1]), float(lines["three"][0, 1]))
    assert {lines[n][:, 0].min() for n in ("lane", "three", "sides")} == {lines["sides"][1, 0]}
    assert ("inside" in lines) == nba


@pytest.mark.parametrize(("parameters", "wide"), [(hoopgen.NBA, 50 * FOOT), (hoopgen.FIBA, 15.0)])
def test_the_lines_are_by_default_those_of_the_preset(
    parameters: dict[str, float], wide: float
) -> None:
    drawn = plot_landings([1.0], [0.5], parameters), plot_aim_points(aims(), parameters)
    for figure in drawn:
        sides = court_lines(axes_of(figure, "floor plan"))["sides"]
        assert np.ptp(sides[:, 1]) == pytest.approx(wide, rel=8 * EPS, abs=0)


def said(figure: Figure) -> str:
    return " ".join(text.get_text() for text in figure.texts)


def test_landings_say_how_many_of_how_many_and_from_where() -> None:
    # Of a thousand the two furthest are out of the picture, which shows all but five.
    x = np.concatenate([np.zeros(998), [50.0, -50.0], [np.nan, np.nan, 1.0]])
    y = np.concatenate([np.zeros(1000), [0.0, np.nan, np.nan]])
    figure = plot_landings(x, y, SCENE, note="Seed: 3.")
    axes = axes_of(figure, "floor plan")
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    seen = np.sum((y >= left) & (y <= right) & (-x >= bottom) & (-x <= top))
    assert seen == 998
    assert said(figure) == (
        "998 of 1,003 misses land within the picture, 2 beyond it, 3 never reach the floor. "
        "Circles hold shares of those that land. Distances are from the point of the floor below "
        "the ring's centre. Scene: NBA. Seed: 3."
    )
    for label in (axes.get_xlabel(), axes.get_ylabel()):
        assert label.endswith("from the ring's centre (m)")


def test_landings_all_in_the_picture_say_nothing_of_others() -> None:
    figure = plot_landings([1.0, np.nan, 2.0], [0.5, 0.0, np.nan], SCENE)
    assert said(figure).startswith("1 of 3 misses lands within the picture, 2 never reach")
    figure = plot_landings([1.0], [0.5], SCENE)
    assert said(figure).startswith("1 of 1 miss lands within the picture. Circles")


@pytest.mark.parametrize(
    ("x", "options", "start"),
    [
        ([], {}, "No shot was missed. Scene: NBA."),
        ([], {"height": 2.5, "place": (4.191, 0.0)}, "No shot was missed. Scene: NBA."),
        ([np.nan], {}, "None of 1 miss reaches the floor. Scene: NBA."),
        (
            [np.nan, np.nan],
            {"height": 2.5, "place": (4.191, 0.0)},
            "None of 2 misses comes down at 2.5 m above the floor. Scene: NBA.",
        ),
    ],
)
def test_without_landings_the_picture_is_empty_and_says_why(
    x: list[float], options: dict[str, Any], start: str
) -> None:
    figure = plot_landings(x, x, SCENE, **options)
    assert said(figure) == start
    (axes,) = figure.axes  # without a bar of colours
    assert not axes.texts or axes.texts[0].get_text() == "release"
    given = Figure().add_subplot()
    plot_landings(x, x, SCENE, ax=given, **options)
    assert start.split(". ")[0] in given.get_title(loc="left").replace("\n", " ")


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        (([1.0], [1.0]), {"court": "ABA"}, "court: expected NBA or FIBA, got 'ABA'"),
        (([1.0, 2.0], [1.0]), {}, r"x, y: expected \(n,\) both, got \(2,\), \(1,\)"),
    ],
)
def test_landings_that_cannot_be_drawn_are_refused(
    arguments: Any, options: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        plot_landings(*arguments, SCENE, **options)


# ------------------------------------------------------------------------------------ aim points


@pytest.mark.slow
def test_aim_points_and_places_are_where_the_data_say() -> None:
    dataset = aims().isel(place=slice(3))
    figure = plot_aim_points(dataset, SCENE)
    wanted = {
        "front view": np.stack([dataset["touch_y"], dataset["touch_z"]], axis=1),
        "floor plan": np.stack([dataset["y"], -dataset["x"]], axis=1),
    }
    for label, points in wanted.items():
        marks = [c for c in axes_of(figure, label).collections if type(c) is PathCollection]
        assert [mark.get_label() for mark in marks] == [
            "bank better",
            "no difference shown",
            "direct better",
        ]
        for mark, point in zip(marks, points, strict=True):
            np.testing.assert_array_equal(mark.get_offsets(), [point])


def test_a_place_and_its_aim_point_have_one_colour() -> None:
    figure = plot_aim_points(aims(), SCENE)
    colours = []
    for label in ("front view", "floor plan"):
        marks = [c for c in axes_of(figure, label).collections if type(c) is PathCollection]
        filled = [mark.get_facecolor() for mark in marks[:2]]
        colours.append([tuple(colour[0]) for colour in (*filled, marks[2].get_edgecolor())])
    assert colours[0] == colours[1]
    assert len(set(colours[0])) == 3


def test_lines_lead_to_where_the_board_is_touched() -> None:
    figure = plot_aim_points(aims(), SCENE)
    lines = one(axes_of(figure, "floor plan"), LineCollection)
    board = SCENE["board_distance"]
    centre = board - SCENE["ball_radius"]
    assert [line.tolist() for line in lines.get_segments()] == [
        [[-3.0, -0.8], [-0.4, centre], [-0.4, board]],
        [[0.0, -4.2], [0.01, centre], [0.01, board]],
        [[2.5, -2.0], [0.3, centre], [0.3, board]],
    ]
    # Both panels have the point on the board at one y.
    marks = [c for c in axes_of(figure, "front view").collections if type(c) is PathCollection]
    touched = [float(np.asarray(mark.get_offsets())[0, 0]) for mark in marks]
    assert touched == [float(line[-1, 0]) for line in lines.get_segments()]


def test_the_floor_plan_of_a_place_in_front_has_the_whole_board() -> None:
    left, right = axes_of(plot_aim_points(aims().isel(place=[1]), SCENE), "floor plan").get_xlim()
    assert left < -SCENE["board_half_width"] < SCENE["board_half_width"] < right


@pytest.mark.slow
def test_an_aim_point_has_its_range() -> None:
    dataset = aims()
    ends = {
        "touch_y_low": [-0.5, -0.1, 0.2, np.nan],
        "touch_y_high": [-0.3, 0.1, 0.4, np.nan],
        "touch_z_low": [0.5, 0.3, 0.35, np.nan],
        "touch_z_high": [0.7, 0.4, 0.45, np.nan],
    }
    assert "A cross" not in said(plot_aim_points(dataset, SCENE))
    ranged = dataset.assign({name: ("place", column) for name, column in ends.items()})
    figure = plot_aim_points(ranged, SCENE)
    assert "A cross spans nine tenths of the made bank shots, each way." in said(figure)
    lines = one(axes_of(figure, "front view"), LineCollection)
    assert [line.tolist() for line in lines.get_segments()] == [
        [[-0.5, 0.6], [-0.3, 0.6]],
        [[-0.1, 0.35], [0.1, 0.35]],
        [[0.2, 0.4], [0.4, 0.4]],
        [[-0.4, 0.5], [-0.4, 0.7]],
        [[0.01, 0.3], [0.01, 0.4]],
        [[0.3, 0.35], [0.3, 0.45]],
    ]


def test_places_have_names_and_shots_aim_at_them() -> None:
    figure = plot_aim_points(aims(), SCENE)
    axes = axes_of(figure, "front view")
    names = {name.removesuffix(" of the square") for name in on_board(SCENE)}
    assert {text.get_text() for text in axes.texts} == names
    assert len(names) == 6
    square = axes.patches[-1]
    assert type(square) is Rectangle
    # Outside the line, which is drawn along its middle.
    top, line = SCENE["wire_radius"] + (18 - 2) * FOOT / 12, 2 * FOOT / 12
    assert on_board(SCENE)["top right corner of the square"] == pytest.approx((FOOT, top))
    assert square.get_y() + square.get_height() + line / 2 == pytest.approx(top)
    left, right = (say_on_board(y, z, SCENE) for y, z in ((-0.4, 0.6), (0.3, 0.4)))
    assert f"Bank shots aim from {left} to {right}." in said(figure)
    assert left == "19 cm above and 10 cm left of the top left corner of the square"
    dataset = aims().assign(aim=(("way", "place"), [[0.02, 0.07, 0.05, np.nan], [0.4] * 4]))
    dataset = dataset.assign_coords(way=["direct", "bank"])
    wanted = "Direct ones aim from 2 to 7 cm past the centre of the ring."
    assert wanted in said(plot_aim_points(dataset, SCENE))


def test_the_target_is_that_of_the_rule_book() -> None:
    axes = axes_of(plot_aim_points(aims(), SCENE), "front view")
    (target,) = (patch for patch in axes.patches if type(patch) is Rectangle)
    line, inch = 2.0 * FOOT / 12, FOOT / 12
    # The middle of a line 2 in wide; 24 in by 18 in outside.
    assert target.get_width() + line == pytest.approx(24 * inch, rel=8 * EPS, abs=0)
    assert target.get_height() + line == pytest.approx(18 * inch, rel=8 * EPS, abs=0)
    assert target.get_y() + line / 2 == pytest.approx(SCENE["wire_radius"], rel=0, abs=4 * EPS)
    assert target.get_x() + target.get_width() / 2 == pytest.approx(0.0, abs=4 * EPS)


@pytest.mark.parametrize(
    ("spoil", "options", "message"),
    [
        (lambda data: data.drop_vars(["touch_y", "x"]), {}, "dataset: .* x, touch_y missing"),
        (lambda data: data.isel(place=[3]), {}, "dataset: expected a bank shot from one place"),
        (lambda data: data, {"court": "ABA"}, "court: expected NBA or FIBA, got 'ABA'"),
    ],
)
def test_aims_that_cannot_be_drawn_are_refused(
    spoil: Callable[[Any], Any], options: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        plot_aim_points(spoil(aims()), SCENE, **options)


# ------------------------------------------------------------------------------------ files

_WRITE = """
import sys
sys.path.append(sys.argv[1])
from tests.plots.test_studies import PICTURES, save
for name, draw in PICTURES.items():
    for suffix in ("svg", "pdf", "png") if name in ("kinds", "fan") else ("svg",):
        save(draw(3.5), f"{sys.argv[2]}/{name}.{suffix}")
"""


@pytest.mark.slow
def test_two_processes_write_the_same_bytes(tmp_path: Path) -> None:
    folders = [tmp_path / seed for seed in ("1", "2")]
    for folder in folders:
        folder.mkdir()
        subprocess.run(
            [sys.executable, "-c", _WRITE, str(ROOT), str(folder)],
            env=os.environ | {"PYTHONHASHSEED": folder.name},
            check=True,
        )
    first, second = ({path.name: path.read_bytes() for path in f.iterdir()} for f in folders)
    assert len(first) == len(PICTURES) + 4
    assert first == second


@pytest.mark.sampled(1)
@pytest.mark.parametrize("name", PICTURES)
def test_only_cells_are_pixels_and_files_are_small(tmp_path: Path, name: str) -> None:
    path = save(PICTURES[name](PAGE), tmp_path / "picture.svg")
    images = path.read_text(encoding="utf-8").count("<image")
    cells = {"kinds": 1, "strip": 1, "probability": 2, "panels": 6, "kind panels": 4, "landings": 2}
    cells |= {"court": 2, "courts": 4, "court of kinds": 1}
    assert images == cells.get(name, 0)  # a bar of colours is one more
    assert path.stat().st_size < 300_000


@pytest.mark.slow
def test_a_map_of_many_cells_is_a_small_file(tmp_path: Path) -> None:
    over = {"speed": np.linspace(6.6, 9.6, 900), "elevation": np.radians(np.linspace(38, 75, 600))}
    path = save(plot_map(hoopgen.map(hoopgen.Scatter(FREE_THROW), over)), tmp_path / "map.svg")
    assert path.stat().st_size < 300_000


def test_the_pictures_of_the_documents_are_there_and_small() -> None:
    root = ROOT
    text = (root / "benchmarks" / "pictures.py").read_text(encoding="utf-8")
    names = re.findall(r'^    "([a-z0-9-]+)": [a-z0-9_]+,$', text, re.MULTILINE)
    assert {"free-throws", "figure-7"} <= set(names)
    for name in names:
        assert 0 < (root / "docs" / f"{name}.svg").stat().st_size < 300_000


@pytest.mark.slow
def test_drawing_needs_matplotlib_alone() -> None:
    script = (
        "import sys, hoopgen.plots\n"
        "sys.exit(any(m in sys.modules for m in ('scipy', 'xarray', 'pyarrow', 'pandas')))"
    )
    subprocess.run([sys.executable, "-c", script], check=True)
