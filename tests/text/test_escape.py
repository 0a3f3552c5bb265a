"""Text from others, whatever is in it: on a terminal, in a picture, on a page."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner

import hoopgen
from hoopgen.cli import main
from hoopgen.text.escape import printable

NASTY = "\x00\x07\x1b[31m\r\x7f\x9b2J\u2028\u202egpj\u2066\ud800\ufffe\uffff"
SHOWN = r"\x00\x07\x1b[31m\x0d\x7f\x9b2J\u2028\u202egpj\u2066\ud800\ufffe\uffff"
PLAIN = "Où? 7 ft × 52°\tتوپ 🏀\N{ZERO WIDTH JOINER}\nC:\\x1b é\N{NO-BREAK SPACE}$5"


def test_what_acts_is_shown_and_what_is_text_stays() -> None:
    assert printable(NASTY) == SHOWN
    assert printable(PLAIN) == PLAIN
    assert printable(printable(NASTY)) == SHOWN


# On a terminal


@pytest.mark.parametrize(
    "arguments",
    [
        ["batch", "\x1b[31m.csv", "--out", "x.parquet"],
        ["map", "--over", "\x1b[31m=1:2:3"],
        ["estimate", "--preset", "\x1b[31m"],
        ["study", "\x1b[31m.toml"],
        ["\x1b[31m"],
        ["shot", "--\x1b[31m"],
    ],
)
def test_no_error_writes_an_escape(arguments: list[str]) -> None:
    result = CliRunner().invoke(main, arguments)
    assert result.exit_code == 2
    assert r"\x1b[31m" in result.stderr
    assert "\x1b" not in result.output


def test_nor_do_columns_and_names_of_files(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    table, folder = tmp_path / "throws.csv", tmp_path / "\x1b[31m"
    folder.mkdir()
    table.write_text("speed_\x1b[31m,elevation\n7,1\n", encoding="utf-8")
    result = CliRunner().invoke(main, ["batch", str(table), "--out", str(folder / "x.parquet")])
    assert result.exit_code == 2
    assert r"column speed_\x1b[31m" in result.stderr
    assert "\x1b" not in result.output
    table.write_text("speed,elevation_rad,height,distance\n7,1,2,4\n", encoding="utf-8")
    result = CliRunner().invoke(main, ["batch", str(table), "--out", str(folder / "x.parquet")])
    assert result.exit_code == 0
    assert r"\x1b[31m" in result.stdout
    assert "\x1b" not in result.output


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="names of files are any bytes on Linux")
def test_a_name_that_is_no_utf_8_is_named() -> None:
    command = [sys.executable, "-m", "hoopgen", "batch", b"\xff\xfe.csv", "--out", "x.parquet"]
    failed = subprocess.run(command, capture_output=True, check=False)
    assert failed.returncode == 2
    assert failed.stderr.count(b"\n") == 1
    assert b"Traceback" not in failed.stderr


# In pictures and on pages

TITLES = ["$5 and $10", "$", r"$\frac{1}$", "$x_{$", "a -- b --> <b>&amp;", NASTY]


def _trajectory(title: str, **options: Any) -> Any:
    from hoopgen.plots import plot_trajectory

    shots = _shots(1)
    return plot_trajectory(shots.trajectory(0), hoopgen.NBA, title=title, **options)


def _shots(count: int) -> hoopgen.Shots:
    states = hoopgen.release(
        np.linspace(7.0, 7.2, count), 0.9, backspin=6.0, height=2.1, distance=4.2
    )
    return hoopgen.simulate(states, hoopgen.NBA, record=True)


def _fan(title: str, **options: Any) -> Any:
    from hoopgen.plots import plot_fan

    return plot_fan(_shots(5), hoopgen.NBA, title=title, **options)


def _landings(title: str, **options: Any) -> Any:
    from hoopgen.plots import plot_landings

    numbers = np.linspace(-1.0, 1.0, 50)
    return plot_landings(numbers, numbers**2, hoopgen.NBA, title=title, **options)


def _map(title: str, **options: Any) -> Any:
    """Also with names that are not ours."""
    from hoopgen.plots import plot_map

    xr = pytest.importorskip("xarray")
    names = {"long_name": title, "units": title}
    over = {name: (name, np.linspace(0.0, 1.0, 3), names) for name in ("of mine", "speed")}
    dataset = xr.Dataset({"probability": (tuple(over), np.full((3, 3), 0.5))}, over)
    return plot_map(dataset, title=title, note=title, **options)


def _aim_points(title: str, **options: Any) -> Any:
    from hoopgen.plots import plot_aim_points

    xr = pytest.importorskip("xarray")
    columns = {
        "touch_y": [0.1],
        "touch_z": [0.4],
        "difference_low": [0.1],
        "difference_high": [0.2],
    }
    places = {"x": ("place", [2.0]), "y": ("place", [1.0])}
    dataset = xr.Dataset({name: ("place", column) for name, column in columns.items()}, places)
    return plot_aim_points(dataset, hoopgen.NBA, title=title, **options)


@pytest.mark.sampled(1)
@pytest.mark.filterwarnings("ignore:Glyph .* missing from")
@pytest.mark.parametrize("title", TITLES)
@pytest.mark.parametrize("draw", [_trajectory, _fan, _landings, _map, _aim_points])
def test_a_title_is_drawn_as_it_is_written(
    draw: Callable[[str], Any], title: str, tmp_path: Path
) -> None:
    pytest.importorskip("matplotlib")
    pytest.importorskip("scipy")
    from matplotlib.text import Text

    from hoopgen.plots import save

    figure = draw(title)
    texts = figure.findobj(Text)
    (heading,) = (text for text in texts if text.get_fontsize() == 10.0 and text.get_text())
    assert heading.get_text() == printable(title)
    assert not heading.get_parse_math()
    ElementTree.parse(save(figure, tmp_path / "picture.svg"))


@pytest.mark.sampled(1)
@pytest.mark.filterwarnings("ignore:Glyph .* missing from")
@pytest.mark.parametrize("title", TITLES)
@pytest.mark.parametrize("draw", [_trajectory, _fan, _landings, _map, _aim_points])
def test_so_it_is_on_axes_of_others(draw: Callable[..., Any], title: str, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    pytest.importorskip("scipy")
    from matplotlib.figure import Figure

    from hoopgen.plots import save

    figure = Figure()
    axes = figure.add_subplot()
    draw(title, ax=axes)
    first, *below = axes.get_title("left").split("\n")
    if draw is _trajectory:  # where the line below has formulas
        assert r"$\omega_y=6$" in " ".join(below)
        assert first.count("$") == first.count(r"\$")
        first = first.replace(r"\$", "$")
    assert first == printable(title)
    ElementTree.parse(save(figure, tmp_path / "picture.svg"))


@pytest.mark.parametrize("title", TITLES)
def test_a_title_is_on_the_page_as_it_is_written(title: str, tmp_path: Path) -> None:
    file, labels = tmp_path / "page.html", [title] * 2
    hoopgen.view(_shots(2), hoopgen.NBA, file, title=title, about=title, labels=labels)
    text = file.read_text(encoding="utf-8")
    head, _, _ = text.partition("<style>")
    assert printable(head) == head
    found = re.search(r'<script[^>]*type="application/json"[^>]*>(.*?)</script>', text, re.DOTALL)
    assert found is not None
    data = json.loads(found[1])
    said, shown = [data["title"], data["about"], data["shots"][0]["label"]], printable(title)
    assert said == [shown, f"{shown}; scene NBA", shown]
