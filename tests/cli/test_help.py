"""Helps and answers in the words and units of a user."""

from __future__ import annotations

import re
from pathlib import Path

import click
import pytest

pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

from hoopgen.cli import _COMMANDS, main
from hoopgen.cli.types import Parsed
from tests.helpers.commands import RELEASE, failure, output

PLACE = ["--height", "7ft", "--distance", "13.75ft", "--backspin", "3Hz"]
SCATTER = ["--scatter", "speed=0.07", "--scatter", "elevation=1.3deg"]
_QUANTITY = r"(LENGTH|SPEED|ANGLE|SPIN) \["
AIMED = [*PLACE, *SCATTER, "--aim", "5cm", "--elevation", "52deg"]


@pytest.mark.parametrize("name", ["fit", "batch", "view", "calibrate", "coach", "best"])
def test_a_command_without_scatter_has_no_heading_of_scatter(name: str) -> None:
    text = output(name, "--help")
    assert "scatter, or measured" not in text
    assert "\nThe table:\n" in text
    assert "\nIts scatter, or measured releases:\n" in output("estimate", "--help")


@pytest.mark.parametrize("name", _COMMANDS)
def test_a_default_has_its_unit_and_nothing_is_in_empty_brackets(name: str) -> None:
    assert "[]" not in output(name, "--help")
    for one in main.commands[name].params:
        shows = isinstance(one, click.Option) and one.show_default and one.default
        if shows and isinstance(one.type, Parsed) and re.match(_QUANTITY, one.type.name):
            assert isinstance(one.default, str)
            assert re.fullmatch(r"[\d.]+m", one.default)


def test_arguments_have_the_names_that_the_help_uses() -> None:
    assert " compile [OPTIONS] SCENE\n" in output("compile", "--help")
    assert " hash [OPTIONS] [SCENES]...\n" in output("hash", "--help")
    assert "Invalid value for 'SCENE': expected hoop" in failure("compile", "golf")
    assert "Invalid value for 'SCENES': File 'no.toml'" in failure("hash", "no.toml")


def test_places_of_coach_have_sides() -> None:
    assert "Put left or right" in " ".join(output("coach", "--help").split())


def test_the_ring_is_in_the_units_that_are_shown() -> None:
    words = ["optimum", "--over", "elevation", "--over", "aim", *PLACE, *SCATTER, "--shots", "200"]
    words += ["--by", "direct"]
    (line,) = re.findall(r"flight .*", output(*words))
    assert re.search(r"centre: [\d.]+ cm from the front of the ring$", line)
    (line,) = re.findall(r"flight .*", output(*words, "--units", "us"))
    assert re.search(r"centre: [\d.]+ in from the front of the ring$", line)


def test_a_gradient_says_of_what_and_confidence_may_be_in_percent() -> None:
    words = ["estimate", *AIMED, "--shots", "500", "--gradient", "sd.speed", "--confidence"]
    text = output(*words, "0.9")
    assert re.search(r"^gradient by +share made +90% interval", text, re.MULTILINE)
    assert text == output(*words, "90") == output(*words, "90%")
    assert "expected one such as" in failure(*words, "100")


def test_coach_is_in_one_system_of_units(tmp_path: Path) -> None:
    table = tmp_path / "shots.csv"
    rows = [f"{7.1 + 0.004 * k},{51 + 0.37 * k % 3},{k % 5 - 2}" for k in range(30)]
    table.write_text("\n".join(["speed_m_s,elevation_deg,azimuth_deg", *rows]), encoding="utf-8")
    words = ["coach", "--from", table, "--release", "height=7ft", "--place", "elbow"]
    words += ["--shots", "200"]
    us, si = (output(*words, *more).partition("read:")[0] for more in ([], ["--units", "si"]))
    assert " mph" in us
    assert " in " in us
    assert "m/s" not in us
    assert " cm" not in us
    assert " m/s" in si
    assert " cm" in si
    assert "mph" not in si
    assert " Hz" in si
    assert output(*words) == output(*words, "--units", "us")


def test_the_page_of_coach_is_in_the_units_that_are_asked(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    page = tmp_path / "a.html"
    output("coach", "--shots", "200", "--units", "si", "--out", page)
    text = page.read_text(encoding="utf-8")
    assert " m/s</td>" in text
    assert "mph" not in text


def test_calibrate_has_units(tmp_path: Path) -> None:
    table = tmp_path / "seen.csv"
    rows = [f"{7.1 + 0.01 * k},52,{k % 2}" for k in range(12)]
    table.write_text("\n".join(["speed_m_s,elevation_deg,made", *rows]), encoding="utf-8")
    text = table.read_text(encoding="utf-8").replace("\n", ",2.1336,4.191\n")
    table.write_text(f"{text},2.1336,4.191\n".replace("made,2.1336,4.191", "made,height,distance"))
    words = ["calibrate", table, "--vary", "board_distance=0.3:0.5", "--draws", "2"]
    words += ["--instrument", "speed=3cm/s"]
    assert "board_distance (m)" in output(*words)
    assert "board_distance (in)" in output(*words, "--units", "us")


def test_certify_has_units() -> None:
    pytest.importorskip("flint")
    words = ["certify", *RELEASE, "--set", "board_distance=0.4m", "--units"]
    si, us = (output(*words, system).splitlines() for system in ("si", "us"))
    assert si[:-1] == us[:-1]
    assert "0.4 m" in si[-1]
    assert "15.7" in us[-1]
