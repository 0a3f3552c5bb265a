"""Notebooks: pictures are shown once, pages in place, results as tables and text."""

from __future__ import annotations

import base64
import copy
import html
import os
import pickle
import re
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen

pytest.importorskip("matplotlib")
pytest.importorskip("xarray")
pytest.importorskip("pyarrow")

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from hoopgen import plots
from hoopgen.simulation.article import CASES
from hoopgen.viewer import page, view

pytestmark = pytest.mark.xdist_group("notebook")  # the notebook is run once

DEGREE = np.pi / 180
PLACE = {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi}
MEAN = {**PLACE, "speed": 7.17, "elevation": 52 * DEGREE}
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": DEGREE}
PLAYER = hoopgen.Scatter(MEAN, SD)


@pytest.fixture(scope="module")
def shots() -> hoopgen.Shots:
    return hoopgen.simulate(PLAYER.draw(0, 60).states, record=True)


# ------------------------------------------------------------------------------------ a notebook

CELLS = {
    "shots": """
        import numpy as np, hoopgen
        player = hoopgen.Scatter(
            {"speed": 7.17, "elevation": 0.9, "height": 2.1336, "distance": 4.191}, {"speed": 0.07}
        )
        shots = hoopgen.simulate(player.draw(0, 60).states, record=True)
        shots""",
    "completion": """
        from IPython.core.completer import provisionalcompleter
        get_ipython().Completer.use_jedi = False  # which gives up where it is slow
        with provisionalcompleter():
            found = get_ipython().Completer.completions("shots.", 6)
            shown = ["shots."[: one.start] + one.text for one in found]
        print(*shown)""",
    "picture": "hoopgen.plots.plot_fan(shots, hoopgen.PAPER)",
    "trajectory": "shots.trajectory(0)",
    "page": "hoopgen.view(shots)",
    "estimate": "hoopgen.estimate(player, shots=1000)",
    "map": """
        over = {"speed": np.linspace(6.8, 7.4, 12)}
        place = {"elevation": 0.9, "height": 2.1336, "distance": 4.191}
        dataset = hoopgen.map(hoopgen.Scatter(place, {"speed": 0.05}), over, shots=100)
        dataset""",
    "inline": """
        import matplotlib.pyplot as plt
        hoopgen.plots.plot_map(dataset)""",
    "axes": """
        fig, ax = plt.subplots()
        hoopgen.plots.plot_map(dataset, ax=ax)""",
}


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[Any]]:
    """Return what the cells show, by name."""
    nbclient, nbformat = pytest.importorskip("nbclient"), pytest.importorskip("nbformat")
    pytest.importorskip("ipykernel")
    cells = [nbformat.v4.new_code_cell(re.sub(r"^ {8}", "", c, flags=re.M)) for c in CELLS.values()]
    notebook = nbformat.v4.new_notebook(cells=cells)
    folder = tmp_path_factory.mktemp("notebook")
    with pytest.MonkeyPatch.context() as patch:
        for name in ("IPYTHONDIR", "JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR", "MPLCONFIGDIR"):
            patch.setenv(name, str(folder / name))
        patch.delenv("MPLBACKEND", raising=False)
        resources = {"metadata": {"path": str(folder)}}
        client = nbclient.NotebookClient(notebook, timeout=60, resources=resources)
        client.execute()
    return {name: cell.outputs for name, cell in zip(CELLS, notebook.cells, strict=True)}


def pictures(shown: list[Any]) -> list[bytes]:
    return [
        base64.b64decode(output.data["image/png"])
        for output in shown
        if "image/png" in output.get("data", {})
    ]


def size_of(png: bytes) -> tuple[int, int]:
    assert png.startswith(b"\x89PNG")
    return struct.unpack(">II", png[16:24])


@pytest.mark.slow
def test_a_picture_is_shown_before_pyplot_is_imported(outputs: dict[str, list[Any]]) -> None:
    (shown,) = outputs["picture"]
    width, height = size_of(*pictures([shown]))
    told = shown.metadata["image/png"]
    assert (told["width"], told["height"]) == (710, round(height / 2))
    assert width == 1420


@pytest.mark.slow
@pytest.mark.parametrize("cell", ["inline", "axes"])
def test_with_pyplot_a_picture_is_shown_once(outputs: dict[str, list[Any]], cell: str) -> None:
    assert len(pictures(outputs[cell])) == 1


@pytest.mark.slow
def test_results_are_tables_and_text(outputs: dict[str, list[Any]]) -> None:
    for cell, said in (
        ("shots", "<table>.*<td>made</td>"),
        ("trajectory", "<table>.*<td>release</td>"),
        ("estimate", "<pre>made .*Wilson"),
        ("map", "xarray"),
    ):
        (shown,) = outputs[cell]
        assert re.search(said, shown.data["text/html"], re.S)


@pytest.mark.slow
def test_a_page_is_shown_in_place(outputs: dict[str, list[Any]]) -> None:
    (shown,) = outputs["page"]
    assert shown.data["text/html"].startswith("<iframe srcdoc=")


@pytest.mark.slow
def test_the_tab_key_completes_results(outputs: dict[str, list[Any]]) -> None:
    (shown,) = outputs["completion"]
    names = {"outcome", "made", "contacts", "counts", "first", "time", "state", "uncertain"}
    names |= {"events", "trajectory", "plot"}
    assert {f"shots.{name}" for name in names} <= set(shown.text.split())


# ------------------------------------------------------------------------------------------ pages


@pytest.mark.parametrize("title", ['"><script>alert(1)</script>', "plain"])
def test_a_page_in_a_notebook_is_text_of_one_attribute(shots: hoopgen.Shots, title: str) -> None:
    shown = view(shots, title=title)._repr_html_()
    found = re.fullmatch(r'<iframe srcdoc="([^"<>]*)" [^<>]*></iframe>', shown)
    assert found is not None
    assert html.unescape(found[1]) == page(shots, hoopgen.PAPER, title=title)
    assert 'sandbox="allow-scripts"' in shown


def test_a_page_stands_for_its_file(shots: hoopgen.Shots, tmp_path: Path) -> None:
    path = tmp_path / "shots.html"
    written = view(shots, hoopgen.PAPER, path)
    assert written.path == path
    assert os.fspath(written) == str(written) == str(path)
    assert Path(written).read_text("utf-8") == written.read_text("utf-8") == written.text
    assert written.name == "shots.html"
    assert "read_text" in dir(written)
    assert copy.copy(written) == pickle.loads(pickle.dumps(written)) == written


def test_a_page_without_a_file_says_so(shots: hoopgen.Shots) -> None:
    shown = view(shots)
    assert shown.path is None
    for name in ("exists", "stem", "x"):
        assert not hasattr(shown, name)  # as of any object, and no other error
    with pytest.raises(AttributeError, match="without a file: give view a path"):
        _ = shown.stem
    with pytest.raises(ValueError, match="no file: give view a path"):
        os.fspath(shown)
    with pytest.raises(AttributeError):
        _ = shown._nothing


def test_a_page_has_the_scene_of_its_shots() -> None:
    shots = hoopgen.simulate(PLAYER.draw(0, 3).states, hoopgen.NBA, record=True)
    assert view(shots).text == page(shots, hoopgen.NBA)


# ---------------------------------------------------------------------------------------- results


@pytest.fixture(scope="module")
def best() -> Any:
    over = {"speed": (7.0, 7.3), "elevation": (50 * DEGREE, 54 * DEGREE)}
    return hoopgen.optimum(hoopgen.Scatter(PLACE, SD), over, shots=2000, margins=["speed"])


def test_an_estimate_is_a_row(shots: hoopgen.Shots) -> None:
    pytest.importorskip("pandas")
    found = hoopgen.estimate(PLAYER, shots=2000)
    frame = found.to_pandas()
    assert len(frame) == 1
    assert frame.probability[0] == found.probability
    assert frame.kinds_made_swish[0] == found.kinds_made["swish"]
    assert frame.setting_sd_speed_m_s[0] == SD["speed"]
    assert found._repr_html_() == f"<pre>{html.escape(str(found))}</pre>"


def test_a_comparison_is_a_row() -> None:
    pytest.importorskip("pandas")
    found = hoopgen.compare(PLAYER, (PLAYER, hoopgen.NBA), shots=2000)
    frame = found.to_pandas()
    assert frame.first_probability[0] == found.first.probability
    assert frame.pairs[0] == found.pairs
    assert found._repr_html_() == f"<pre>{html.escape(str(found))}</pre>"


@pytest.mark.slow
def test_an_optimum_is_a_row_and_shows_its_shots(best: Any) -> None:
    pytest.importorskip("pandas")
    frame = best.to_pandas()
    assert frame.release_speed_m_s[0] == best.release["speed"]
    assert frame.margins_speed_low[0] == best.margins["speed"].low
    assert best._repr_html_() == f"<pre>{html.escape(str(best))}</pre>"
    assert best.margins["speed"].to_pandas().high[0] == best.margins["speed"].high
    # As many are drawn as were thrown, so the picture's share is the optimum's.
    said = [text.get_text() for text in best.plot(paths=5).texts]
    drawn = f"2,000 shots, {100 * best.probability:.1f}% made; 5 are drawn. Scene: PAPER"
    assert any(text.startswith(drawn) for text in said)
    assert f"Seed: {best.seed + 1}." in " ".join(said)


def test_aims_are_a_table() -> None:
    pytest.importorskip("pandas")
    found = hoopgen.aim(height=2.1, distance=np.linspace(2.0, 9.0, 20), entry=45 * DEGREE)
    frame = found.to_pandas()
    np.testing.assert_array_equal(frame.speed_m_s, found.speed)
    np.testing.assert_array_equal(frame.elevation_rad, found.elevation)
    text = found._repr_html_()
    assert text.count("<tr>") == 12
    assert "<th>entry_angle (°)</th>" in text
    assert "<td>45.0000</td>" in text
    assert hoopgen.aim(height=2.1, distance=4.0)._repr_html_().count("<tr>") == 2


def test_a_batch_is_its_counts_and_its_file(tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    source, out = tmp_path / "in.csv", tmp_path / "<b>out.parquet"
    source.write_text("speed,elevation_rad,height,distance\n7.2,0.9,2.1,4.2\n8,0.9,2.1,4.2\n")
    found = hoopgen.batch(source, out)
    assert sum(found.values()) == 2
    assert found == dict(found)
    assert found.path == out
    assert list(found.to_pandas().outcome) == ["made", "missed"]
    assert "<b>" not in found._repr_html_()
    assert pickle.loads(pickle.dumps(found)).path == out


# ------------------------------------------------------------------------------------------- axes


def kinds() -> Any:
    over = {
        "speed": np.linspace(6.8, 7.8, 12),
        "elevation": np.linspace(0.8, 1.0, 9),
        "backspin": [0.0, 6.0],
    }
    return hoopgen.map(hoopgen.Scatter({"height": 2.1336, "distance": 4.191}), over)


def shares() -> Any:
    over = {"speed": np.linspace(7.0, 7.4, 8), "elevation": np.linspace(0.85, 0.95, 7)}
    return hoopgen.map(hoopgen.Scatter(PLACE, SD), over, shots=200)


def board() -> Any:
    from hoopgen.study.questions.bank import bank_or_direct

    return bank_or_direct(hoopgen.Scatter(PLACE, SD), [[2.0, 2.0]], shots=500)


DRAWN = {
    "fan": lambda shots, **options: shots.plot(**options),
    "trajectory": lambda shots, **options: shots.trajectory(0).plot(**options),
    "landings": lambda shots, **options: plots.plot_landings(
        [1.0, 2.0], [0.5, 1.0], hoopgen.PAPER, place=(4.191, 0.0), **options
    ),
    "kinds": lambda shots, **options: plots.plot_map(kinds().isel(backspin=0), **options),
    "strip": lambda shots, **options: plots.plot_map(
        kinds().isel(backspin=0, elevation=4), **options
    ),
    "shares": lambda shots, **options: plots.plot_map(shares(), **options),
    "line": lambda shots, **options: plots.plot_map(shares().isel(elevation=3), **options),
    "aim points": lambda shots, **options: plots.plot_aim_points(board(), hoopgen.PAPER, **options),
}

KEYED = {"fan", "trajectory", "kinds", "strip", "line", "aim points"}
BARRED = {"landings", "shares"}


@pytest.mark.sampled(1)
@pytest.mark.parametrize("name", DRAWN)
def test_a_picture_is_drawn_on_axes_that_there_are(name: str, shots: hoopgen.Shots) -> None:
    figure = Figure(figsize=(8, 3), layout="constrained")
    left, right = figure.subplots(1, 2)
    assert DRAWN[name](shots, ax=left, title="costs $5, or $6") is left
    FigureCanvasAgg(figure).draw()
    # No formula: written as it is where none are read, escaped where some are ours.
    formulas = left._left_title.get_parse_math()
    assert left.get_title(loc="left").startswith(r"costs \$5" if formulas else "costs $5, or $6\n")
    assert left.collections or left.lines
    assert not right.has_data()
    assert len(figure.axes) == 2 + (name in BARRED)
    key = left.get_legend()
    assert (key is not None) == (name in KEYED)
    # Nothing lies on the neighbour or off the page.
    assert left.get_tightbbox().x1 <= right.get_tightbbox().x0
    assert left.get_tightbbox().x0 >= 0
    if key is not None and name != "line":
        assert key.get_window_extent().x0 >= left.get_window_extent().x1


@pytest.mark.sampled(1)
@pytest.mark.parametrize("name", DRAWN)
def test_on_a_page_of_its_own_a_picture_shows_itself(name: str, shots: hoopgen.Shots) -> None:
    png, told = DRAWN[name](shots)._repr_png_()
    width, height = size_of(png)
    assert abs(width - 2 * told["width"]) <= 2
    assert abs(height - 2 * told["height"]) <= 2


def test_views_on_axes_are_to_scale(shots: hoopgen.Shots) -> None:
    for name in ("fan", "trajectory", "landings"):
        axes = Figure().subplots()
        DRAWN[name](shots, ax=axes)
        assert axes.get_aspect() == 1.0


def test_maps_on_axes_say_their_note_if_it_is_given() -> None:
    for note, said in ((None, False), ("200 shots a cell", True)):
        axes = Figure().subplots()
        plots.plot_map(shares(), ax=axes, note=note)
        assert ("200 shots" in axes.get_title(loc="left")) == said
        assert "best" in axes.get_title(loc="left")


def test_what_does_not_fit_on_axes_is_refused(shots: hoopgen.Shots) -> None:
    axes = Figure().subplots()
    with pytest.raises(ValueError, match=r"^ax: .*backspin, there is a panel .* 2 values; select"):
        plots.plot_map(kinds(), ax=axes)
    with pytest.raises(ValueError, match=r"^three_d: on ax there is the side view alone"):
        shots.trajectory(0).plot(ax=axes, three_d=True)
    with pytest.raises(TypeError, match=r"^ax: expected one matplotlib Axes, got ndarray"):
        shots.plot(ax=Figure().subplots(1, 2))


def test_a_trajectory_is_drawn_with_its_scene_and_outcome() -> None:
    states = [case.state for case in CASES]
    trajectory = hoopgen.simulate(states, hoopgen.NBA, record=True).trajectory(-1)
    drawn = [t.get_text() for axes in trajectory.plot().axes for t in axes.texts]
    assert any("missed" in text for text in drawn)
    assert trajectory.parameters == dict(hoopgen.NBA)


def test_without_the_event_log_there_is_nothing_to_draw() -> None:
    with pytest.raises(AttributeError, match="record=True"):
        hoopgen.simulate(PLAYER.draw(0, 2).states).plot()
