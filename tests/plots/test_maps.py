"""Maps as they are drawn: on the court, with contours that keep within what is known, hatched."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from tests.helpers.commands import succeed

pytest.importorskip("matplotlib")
xr = pytest.importorskip("xarray")

from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402
from matplotlib.collections import QuadMesh  # noqa: E402
from matplotlib.contour import QuadContourSet  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.patches import PathPatch  # noqa: E402

from hoopgen.core.units import FOOT, use_units  # noqa: E402
from hoopgen.hoop.court_lines import court_of  # noqa: E402
from hoopgen.plots import COLUMN, PAGE, plot_map  # noqa: E402
from hoopgen.plots.contours import refine, smooth  # noqa: E402

EPS = np.finfo(float).eps


def places(
    first: str = "x", *, count: tuple[int, int] = (31, 41), parameters: Any = hoopgen.NBA
) -> Any:
    """A share that is (9 m - distance) / 10 m, none within 1 m of the ring's centre."""
    over = {"x": np.linspace(-1.0, 8.0, count[0]), "y": np.linspace(-6.0, 7.0, count[1])}
    over = {name: over[name] for name in (first, "y" if first == "x" else "x")}
    one, other = np.meshgrid(*over.values(), indexing="ij")
    away = np.hypot(one, other)
    share = np.where(away < 1.0, np.nan, np.clip(0.9 - away / 10.0, 0.0, 1.0))
    data = {
        name: (tuple(over), share + off)
        for name, off in (("probability", 0.0), ("low", -0.01), ("high", 0.01))
    }
    return xr.Dataset(data, over, {"parameters": json.dumps(dict(parameters))})


def single(count: int = 21) -> Any:
    """Kinds of single shots over places: a swish, or invalid near the basket."""
    data = places(count=(count, count))
    near = np.isnan(data["probability"].values)
    codes = {"outcome": np.where(near, 4, 0), "kind": np.where(near, 6, 0)}
    return xr.Dataset(
        {name: (("x", "y"), values) for name, values in codes.items()}, data.coords, data.attrs
    )


def only(figure: Figure, kind: type) -> Any:
    (found,) = figure.axes[0].findobj(lambda artist: type(artist) is kind)
    return found


def hatched(figure: Figure) -> Any:
    (found,) = figure.axes[0].findobj(lambda a: isinstance(a, PathPatch) and bool(a.get_hatch()))
    return found


def lines(figure: Figure) -> dict[str, Any]:
    """Lines of the court, x and y."""
    marked = {str(line.get_label()): line for line in figure.axes[0].lines}
    return {
        label.removeprefix("_court "): line.get_xydata()[:, ::-1] * (-1.0, 1.0)
        for label, line in marked.items()
        if label.startswith("_court ")
    }


def said(figure: Figure) -> str:
    return " ".join(text.get_text() for text in figure.texts)


# ------------------------------------------------------------------------------------ on the court


@pytest.mark.sampled(1)
@pytest.mark.parametrize("first", ["x", "y"])
@pytest.mark.parametrize("units", ["si", "us"])
def test_cells_are_where_the_places_are_on_the_court(first: str, units: Any) -> None:
    data = places(first)
    with use_units(units):
        figure = plot_map(data)
    axes = figure.axes[0]
    mesh = only(figure, QuadMesh)
    across, up = np.moveaxis(mesh.get_coordinates(), -1, 0)
    values = np.ma.filled(mesh.get_array(), np.nan)
    x, y = -(up[1:, 1:] + up[:-1, :-1]) / 2.0, (across[1:, 1:] + across[:-1, :-1]) / 2.0
    wanted = data["probability"].sel(
        x=xr.DataArray(x.ravel()), y=xr.DataArray(y.ravel()), method="nearest"
    )
    np.testing.assert_array_equal(values.ravel(), wanted.values)
    assert axes.get_aspect() == 1.0
    # The board is at the top: x, from the board into the court, leads down.
    (low, high) = axes.get_ylim()
    assert low < -8.0
    assert high > hoopgen.NBA["board_distance"] + 4 * FOOT
    size = FOOT if units == "us" else 1.0
    FigureCanvasAgg(figure).draw()
    label = {"si": "m", "us": "ft"}[units]
    assert (axes.get_xlabel(), axes.get_ylabel()) == (f"y ({label})", f"x ({label})")
    for at, text in zip(axes.get_yticks(), axes.get_yticklabels(), strict=True):
        written = float(text.get_text().replace("−", "-"))
        assert written == pytest.approx(-at / size, rel=1e-6, abs=1e-6)


def test_a_metre_is_as_long_up_as_across_on_the_page() -> None:
    for figure in (plot_map(places()), plot_map(single(), width=COLUMN)):
        FigureCanvasAgg(figure).draw()
        box, axes = figure.axes[0].get_window_extent(), figure.axes[0]
        (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
        assert box.width / (right - left) == pytest.approx(box.height / (high - low), rel=1e-9)
        assert figure.get_figwidth() <= PAGE


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("parameters", "wide"),
    [
        (hoopgen.NBA, 50 * FOOT),
        (hoopgen.NBA | {"restitution": 0.75}, 50 * FOOT),
        (hoopgen.PAPER, 50 * FOOT),
        (hoopgen.FIBA, 15.0),
        (hoopgen.FIBA | {"ball_radius": 0.12}, 15.0),
        (hoopgen.FIBA_COURT, 15.0),
    ],
)
def test_the_lines_are_those_of_the_preset(parameters: Any, wide: float) -> None:
    drawn = lines(plot_map(places(parameters=parameters)))
    assert np.ptp(drawn["sides"][:, 1]) == pytest.approx(wide, rel=8 * EPS, abs=0)
    front = -parameters["board_distance"]
    assert drawn["restricted"][0, 0] == pytest.approx(front, rel=8 * EPS, abs=0)


def test_another_court_can_be_asked_for() -> None:
    assert court_of(hoopgen.FIBA) == "FIBA"
    drawn = lines(plot_map(places(), court="FIBA"))
    assert drawn["restricted"][1:-1, 0].max() == pytest.approx(1.25, rel=1e-4, abs=0)
    with pytest.raises(ValueError, match="court: expected NBA or FIBA, got 'ABA'"):
        plot_map(places(), court="ABA")


@pytest.mark.parametrize("first", ["x", "y"])
def test_the_best_place_is_marked_and_said(first: str) -> None:
    figure = plot_map(places(first))
    (mark,) = (line for line in figure.axes[0].lines if line.get_label() == "_best")
    (across,), (up,) = mark.get_xdata(), mark.get_ydata()
    best = places(first)["probability"]
    at = best.isel(best.argmax(...))
    assert (across, up) == (at["y"].item(), -at["x"].item())
    title = figure.axes[0].get_title(loc="left")
    assert f"x {at['x'].item():.4g} m".replace("-", "−") in title
    assert f"y {at['y'].item():.4g} m".replace("-", "−") in title


def test_a_third_variable_gives_a_court_for_each_value() -> None:
    data = xr.concat([places(), places()], xr.Variable("backspin", [0.0, 6 * np.pi]))
    figure = plot_map(data.transpose("x", "y", "backspin"))
    courts = [axes for axes in figure.axes if axes.get_label() == "floor plan"]
    assert len(courts) == 2
    assert "backspin 3 Hz" in courts[1].get_title(loc="left")


def test_over_one_coordinate_of_the_place_the_other_is_named() -> None:
    assert "lace on the floor, y −6 m" in said(plot_map(places().isel(y=0)))


def test_places_without_a_hoop_are_a_plain_map() -> None:
    data = places()
    data.attrs.clear()
    figure = plot_map(data)
    assert not lines(figure)
    assert figure.axes[0].get_aspect() == "auto"


def test_a_map_of_the_command_line_is_on_the_court(tmp_path: Path) -> None:
    out = tmp_path / "court.svg"
    arguments = ["map", "--over", "x=0:6:4", "--over", "y=-3:3:5", "--height", "7ft", "--preset"]
    arguments += ["fiba", "--entry", "45deg", "--aim", "0", "--picture", str(out)]
    succeed(*arguments)
    assert out.stat().st_size < 300_000


@pytest.mark.parametrize("highest", [0, 1])
def test_lines_on_axes_with_one_scale_are_all_seen(highest: int) -> None:
    data = places().isel(y=20).drop_vars("y")
    low = data.map(lambda values: values / 5.0, keep_attrs=True)
    both = Figure().subplots(1, 2, sharey=True)
    for axes, one in zip(both, (data, low) if highest == 0 else (low, data), strict=True):
        plot_map(one, ax=axes)
    top = float(data["high"].where(data["probability"].notnull()).max())
    for axes in both:
        assert axes.get_ylim() == (0.0, pytest.approx(1.08 * top, rel=1e-12, abs=0))


# ---------------------------------------------------------------------------------- no such flight


@pytest.mark.parametrize("data", [places, single])
def test_cells_without_a_flight_are_hatched_and_no_others(data: Any) -> None:
    figure = plot_map(data())
    assert "Hatched: no such flight." in said(figure)
    shape = hatched(figure).get_path()
    mesh = only(figure, QuadMesh)
    across, up = np.moveaxis(mesh.get_coordinates(), -1, 0)
    middles = np.stack([(c[1:, 1:] + c[:-1, :-1]).ravel() / 2.0 for c in (across, up)], axis=1)
    empty = np.ma.getmaskarray(mesh.get_array()).ravel()
    np.testing.assert_array_equal(shape.contains_points(middles), empty)
    assert empty.any()
    assert not empty.all()


def test_a_map_that_is_whole_is_not_hatched() -> None:
    figure = plot_map(places().sel(x=slice(2.0, None)))
    assert "Hatched" not in said(figure)
    assert not figure.axes[0].findobj(lambda a: isinstance(a, PathPatch) and a.get_hatch())


def test_hatched_cells_are_not_in_the_key() -> None:
    (key,) = plot_map(single()).legends
    assert [text.get_text() for text in key.get_texts()] == ["made, swish"]


def test_outcomes_alone_are_drawn_with_their_names() -> None:
    data = single()
    with pytest.raises(ValueError, match=r"flag_meanings, as hoopgen\.map gives them; got none"):
        plot_map(data, of="outcome")
    names = " ".join(one.name.lower() for one in hoopgen.Outcome)
    data["outcome"].attrs["flag_meanings"] = names
    figure = plot_map(data, of="outcome")
    (key,) = figure.legends
    assert [text.get_text() for text in key.get_texts()] == ["made"]
    data["outcome"][0, 0] = 7
    with pytest.raises(ValueError, match="outcome: expected codes from 0 to 6"):
        plot_map(data, of="outcome")


def test_a_key_of_many_long_names_stays_on_the_page() -> None:
    data = single(4)
    ends = [f"through_the_long_wall_number_{number}" for number in range(8)]
    data["outcome"].attrs["flag_meanings"] = " ".join([*ends, "capped", "invalid"])
    data["outcome"][:] = np.arange(16).reshape(4, 4) % 8
    data = data.drop_vars("kind").assign_attrs(parameters="{}")
    for width in (COLUMN, PAGE):
        figure = plot_map(data, width=width)
        FigureCanvasAgg(figure).draw()
        (key,) = figure.legends
        box = key.get_window_extent()
        assert len(key.get_texts()) == 8
        assert box.x1 <= figure.bbox.x1
        assert box.y1 <= figure.axes[0].get_tightbbox().y0


# ---------------------------------------------------------------------------------------- contours


def noisy(count: int = 41, shots: int = 500) -> tuple[Any, Any]:
    """A hill as it is, and as so many shots a cell show it, with intervals of two deviations."""
    over = {"speed": np.linspace(7.0, 7.4, count), "elevation": np.linspace(0.8, 1.0, count)}
    one, other = np.meshgrid(*over.values(), indexing="ij")
    hill = 0.8 * np.exp(-(((one - 7.2) / 0.15) ** 2) - ((other - 0.9) / 0.08) ** 2)
    found = np.random.default_rng(3).binomial(shots, hill) / shots
    half = 2.0 * np.sqrt(hill * (1.0 - hill) / shots) + 0.002
    data = {"probability": found, "low": found - half, "high": found + half}
    return hill, xr.Dataset({n: (tuple(over), values) for n, values in data.items()}, over)


def contours(data: Any) -> list[Any]:
    axes = plot_map(data).axes[0]
    found = axes.findobj(lambda artist: type(artist) is QuadContourSet)
    return [line for drawn in found for line in split(drawn)]


def split(drawn: QuadContourSet) -> list[Any]:
    """Each line of a set of contours by itself, its points in order."""
    found = []
    for path in drawn.get_paths():
        if len(path.vertices):
            starts = np.flatnonzero(path.codes == path.MOVETO)
            found += np.split(path.vertices, starts[1:])
    return found


def turning(lines: list[Any], scale: Any) -> float:
    """Return how far lines turn to and fro, in turns; a smooth line turns little."""
    total = 0.0
    for line in lines:
        steps = np.diff(line / scale, axis=0)
        steps = steps[np.linalg.norm(steps, axis=1) > 1e-9]
        way = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
        total += float(np.abs(np.diff(way)).sum())
    return total / (2.0 * np.pi)


def test_contours_are_smooth() -> None:
    from matplotlib.axes import Axes

    _, data = noisy()
    scale = np.array([0.4, np.degrees(0.2)])
    drawn = contours(data)
    plain = Figure().subplots()
    assert isinstance(plain, Axes)
    at = data["speed"], np.degrees(data["elevation"])
    jagged = split(plain.contour(*at, data["probability"].T, np.arange(0.1, 0.8, 0.1)))
    # A closed line turns once; those through the cells turn to and fro at every one.
    assert turning(drawn, scale) < 0.35 * turning(jagged, scale)
    # Fine enough to be seen as a curve.
    for line in drawn:
        assert np.linalg.norm(np.diff(line / scale, axis=0), axis=1).max() < 0.02


def test_what_contours_go_through_is_within_the_intervals() -> None:
    _, data = noisy()
    share, low, high = (data[name].values for name in ("probability", "low", "high"))
    surface = smooth(share, low, high)
    assert np.all((low <= surface) & (surface <= high))
    assert (
        np.abs(np.diff(surface, 2, axis=0)).mean() < 0.5 * np.abs(np.diff(share, 2, axis=0)).mean()
    )


def test_it_is_nearer_to_the_truth_than_the_cells_are() -> None:
    hill, data = noisy()
    share, low, high = (data[name].values for name in ("probability", "low", "high"))
    surface = smooth(share, low, high)
    assert np.abs(surface - hill).mean() < 0.7 * np.abs(share - hill).mean()


def test_between_cells_it_keeps_within_what_both_allow() -> None:
    at = np.array([0.0, 1.0, 1.5, 4.0])
    values = np.array([[0.0, 1.0], [0.0, 0.5], [1.0, 0.5], [1.0, 0.0]])
    fine, surface, least, most = refine(at, values, values, values)
    assert np.all((least <= surface) & (surface <= most))
    assert fine[0] == 0.0
    assert fine[-1] == 4.0
    assert np.all(np.diff(fine) > 0.0)
    for place, row in zip(at, values, strict=True):
        np.testing.assert_array_equal(surface[fine == place], row[None])


def test_a_plane_stays_one() -> None:
    at = np.linspace(0.0, 2.0, 13) ** 2
    plane = (3.0 * at + 1.0)[:, None]
    fine, surface, *_ = refine(at, plane, plane, plane)
    np.testing.assert_allclose(surface[:, 0], 3.0 * fine + 1.0, rtol=1e-12, atol=0)


@pytest.mark.parametrize(("count", "there"), [(11, False), (12, True)])
def test_coarse_grids_have_no_contours(count: int, there: bool) -> None:
    assert bool(contours(noisy(count)[1])) == there


def test_no_contour_runs_through_cells_without_a_flight() -> None:
    for line in contours(places()):
        assert np.hypot(*line.T).min() > 0.9
