"""The command line as a whole: what is missing, groups of options, files, completion."""

from __future__ import annotations

import os
import shlex
from pathlib import Path

import click
import pytest
from click.shell_completion import ShellComplete

from tests.helpers import ROOT
from tests.helpers.commands import failure, run, succeed

pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

import hoopgen
from hoopgen.cli import _COMMANDS, main
from hoopgen.cli.command import GROUPS, MAX_UNGROUPED
from hoopgen.hoop.variables import VARIABLES
from hoopgen.study.measures.measures import MEASURES
from hoopgen.study.questions.settings import MEASURED

SCENES = ROOT / "examples" / "scenes"
PLACE = ["--height", "7ft", "--distance", "13.75ft"]
RELEASE = [*PLACE, "--speed", "7.17", "--elevation", "52deg"]


ALL = (
    "--speed (or --aim), --elevation (or --entry), --height and "
    "--distance (or --place, or --x and --y)"
)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("shot", "missing --speed, --elevation, --height and --distance"),
        ("shot --speed 7 --height 2", "missing --elevation and --distance"),
        ("shot --scene court", "missing --speed, --elevation, --height and --distance"),
        (f"shot --scene {SCENES}/golf.toml", "missing --position and --velocity"),
        ("certify", "missing FILE, or --speed, --elevation, --height and --distance"),
        ("certify --speed 7", "missing --elevation, --height and --distance"),
        ("estimate", f"missing {ALL}"),
        ("estimate --aim 0", "missing --elevation (or --entry), --height and --distance (or"),
        ("estimate --entry 45deg --x 3 --y 0", "missing --height"),
        (f"estimate --scene {SCENES}/golf.toml", "missing --position and --velocity"),
        ("fan", f"missing {ALL}"),
        ("landings", f"missing {ALL}"),
        ("map", f"missing --over, {ALL}"),
        ("map --over elevation=45deg:60deg:3 --height 7ft", "missing --speed (or --aim) and --dis"),
        ("optimum", f"missing --over, {ALL}"),
        ("optimum --over elevation --over aim", "missing --height and --distance (or --place, or"),
        ("bank", "missing --height and --distance (or --place, or --x and --y)"),
        ("bank --places distance=2,3 --places angle=0deg", "missing --height"),
        ("aim", "missing --height and --distance (or --place)"),
        ("batch", "missing --out and FILE"),
        ("view", "missing --out and FILE"),
        ("study", "missing FILE"),
        ("compile", "missing SCENE"),
    ],
)
def test_all_that_is_missing_is_said_at_once(words: str, said: str) -> None:
    assert failure(*shlex.split(words)).startswith(f"hoopgen: error: {said}")


def test_measured_releases_say_what_options_do_not(tmp_path: Path) -> None:
    """Whatever the file has not is said once it is read."""
    file = tmp_path / "releases.csv"
    file.write_text("speed,elevation_deg\n7.1,52\n7.2,51\n", encoding="utf-8")
    assert "missing" not in run("estimate", "--from", str(file), *PLACE, "--shots", "10").stderr


@pytest.mark.parametrize("name", _COMMANDS)
def test_a_long_help_has_its_options_in_groups(name: str) -> None:
    """Every option under a heading, in the order of the headings."""
    command = main.commands[name]
    text = run(name, "--help").output
    shown = [p for p in command.params if isinstance(p, click.Option) and not p.hidden]
    titles = [heading for one in GROUPS for heading in (one, *["The table"] * (one == MEASURED))]
    headings = [title for title in titles if f"\n{title}:\n" in text]
    if len(shown) + 1 <= MAX_UNGROUPED:
        assert not headings
        assert "\nOptions:\n" in text
        return
    assert len(headings) >= 4
    assert "\nOptions:\n" not in text
    assert [text.index(f"\n{one}:\n") for one in headings] == sorted(
        text.index(f"\n{one}:\n") for one in headings
    )
    for option in shown:
        assert f"\n  {max(option.opts, key=len)}" in text or f", {option.opts[-1]}" in text


# --------------------------------------------------------------------------- files in and files out


STUDY = """
[study]
name = "x"
[release]
speed = 7.17
elevation = "52deg"
height = "7ft"
distance = "13.75ft"
[[question]]
kind = "estimate"
name = "a"
shots = 100
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with files to be read in it."""
    monkeypatch.chdir(tmp_path)
    Path("study.html").write_text(STUDY, encoding="utf-8")
    Path("releases.csv").write_text(
        "speed,elevation_deg,height,distance\n7.1,52,2.1,4.2\n", encoding="utf-8"
    )
    Path("scene.toml").write_bytes((SCENES / "golf.toml").read_bytes())
    Path("link.html").symlink_to("study.html")
    os.link("releases.csv", "other.csv")
    return tmp_path


SHOT = "shot --speed 7.17 --elevation 52deg --height 7ft --distance 13.75ft"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("study study.html --report study.html", "'--report': study.html: FILE reads it, too"),
        ("study study.html --report ./study.html", "'--report': study.html: FILE reads it, too"),
        ("study link.html --report study.html", "'--report': study.html: FILE reads it, too"),
        ("batch releases.csv --out releases.csv", "'--out': releases.csv: FILE reads it, too"),
        ("batch releases.csv --out other.csv", "'--out': other.csv: FILE reads it, too"),
        ("batch releases.csv --scene scene.toml --out scene.toml", "--scene reads it, too"),
        (
            "map --over speed=7:8:2 --from releases.csv --out releases.csv",
            "'--out': releases.csv: --from reads it, too; give another file",
        ),
        (
            "aim --distance 3m,4m --height 2m --csv a.svg --picture a.svg",
            "'--picture': a.svg: --csv writes it, too; give another file",
        ),
    ],
)
def test_no_file_that_is_read_is_written(folder: Path, words: str, said: str) -> None:
    """And none twice; refused before any work, with all files as they were."""
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert said in failure(*shlex.split(words))
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before


def test_a_report_is_not_written_over_the_study_in_python_either(folder: Path) -> None:
    with pytest.raises(ValueError, match=r"^report: study\.html is a file that the study reads"):
        hoopgen.run_study("study.html", report="study.html")


# ----------------------------------------------------------------------------------------- stumbles


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (f"{SHOT} --speed -7", "'--speed': expected 0 m/s or more, got '-7'"),
        (f"{SHOT} --distance -3ft", "'--distance': expected 0 m or more, got '-3ft'"),
        (f"{SHOT} --backspin 180rad/s", "'--backspin': expected a spin from -100rad/s to 100"),
        ("batch releases.csv --out b.csv --release speed=-7", "'--release': speed: expected 0"),
        ("estimate --scatter elevation=-1deg", "'--scatter': elevation: expected a standard devia"),
        ("map --over speed=-7:7:3", "'--over': speed: expected 0 m/s or more, got '-7'"),
        ("estimate --solve 1", "'--solve': '1' is no share above 0% and below 100%: expected one"),
        ("estimate --solve 100", "'--solve': '100' is no share"),
        ("estimate --solve 0", "'--solve': '0' is no share"),
        ("estimate --precision 70", "'--precision': '70' is no share above 0% and below 100%"),
        (f"estimate{SHOT[4:]} --by banana", "--by: expected made or missed, got 'banana'"),
        (f"estimate{SHOT[4:]} --by missed", "--by is of --versus and --solve"),
        (f"{SHOT} --distance 420m", "'--distance': implausible: expected 0 to 40 m, got '420m'"),
        (f"{SHOT} --speed 717", "'--speed': implausible: expected 0 to 40 m/s, got '717'"),
        (f"{SHOT} --height 72ft", "'--height': implausible: expected 0 to 5 m, got '72ft'"),
        (f"{SHOT} --elevation 520deg", "implausible: expected -90 to 90\N{DEGREE SIGN}, got"),
        (f"estimate{SHOT[4:]} --height 72ft", "'--height': implausible: expected 0 to 5 m"),
        (f"estimate{SHOT[4:]} --versus backspin=31Hz", "backspin: expected a spin from -100rad/s"),
        ("aim --height 7ft --distance 1m:80m:1m", "'--distance': implausible: expected 0 to 40"),
        ("batch releases.csv --out b.csv --release height=72ft", "height: implausible: expected"),
    ],
)
def test_what_is_surely_wrong_is_refused_by_the_name_of_its_option(
    folder: Path, words: str, said: str
) -> None:
    assert said in failure(*shlex.split(words))


@pytest.mark.parametrize("share", ["70%", "0.7", "70", "70.0"])
def test_a_share_may_be_written_in_percent_without_its_sign(share: str) -> None:
    option = next(one for one in main.commands["estimate"].params if "--solve" in one.opts)
    assert option.type.convert(share, option, None) == pytest.approx(0.7, abs=1e-15)


def test_a_precision_may_be_written_in_percent() -> None:
    option = next(one for one in main.commands["estimate"].params if "--precision" in one.opts)
    assert option.type.convert("0.5%", option, None) == 0.005


def test_solve_without_a_scatter_shows_a_whole_command() -> None:
    said = failure("estimate", *RELEASE, "--solve", "70%", "--shots", "2000")
    assert said.startswith(
        "hoopgen: error: --solve multiplies the scatter, and here nothing scatters: give --sc"
    )
    shown = said.partition("For example: ")[2].partition(" (see")[0]
    words = shlex.split(shown)
    assert words[:2] == ["hoopgen", "estimate"]
    again = succeed(*words[1:])
    assert "times the scatter" in again.stdout


@pytest.mark.parametrize("command", ["estimate", "fan"])
def test_why_shots_are_invalid_is_said(command: str) -> None:
    release = ["--aim", "0", "--elevation", "52deg", "--height", "7ft", "--distance", "0"]
    result = run(command, *release, "--shots", "100")
    assert result.stderr == (
        "hoopgen: 100 of 100 shots invalid: no speed brings the ball down through the point aimed "
        "at\n"
    )
    assert run(command, *RELEASE, "--shots", "100").stderr == ""


@pytest.mark.parametrize("command", ["estimate", "fan"])
def test_a_measured_speed_that_is_missing_is_not_one_that_was_aimed(
    command: str, tmp_path: Path
) -> None:
    table = tmp_path / "releases.csv"
    table.write_text("speed,elevation_deg,height,distance\n7.1,52,2.1,4.2\n,52,2.1,4.2\n")
    said = run(command, "--from", str(table), "--preset", "paper", "--shots", "100").stderr
    assert said.endswith(" of 100 shots invalid: no value in speed\n")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["estimate", *RELEASE, "--measure", "deep"], "--measure: unknown deep"),
        (["estimate", *RELEASE, "--scatter", "aim=1cm"], "--scatter: unknown aim"),
        (["estimate", *RELEASE, "--aim", "5cm"], "--aim takes the place of --speed; got both"),
        (["bank", "--height", "7ft", "--x", "2m"], "--places: expected distance and angle, or"),
        (["aim", *PLACE, "--speed", "3"], "--speed: the point of the ring's plane needs at least"),
        (["aim", *PLACE, "--set", "gravity=0"], "--set gravity: expected above 0"),
        (["map", *RELEASE, "--over", "speed=7:8:2"], "--speed and --over speed: leave one out"),
    ],
)
def test_an_error_of_the_library_names_the_option(
    folder: Path, words: list[str], said: str
) -> None:
    assert failure(*words).startswith(f"hoopgen: error: {said}")


# --------------------------------------------------------------------------------------- completion


def completed(words: str) -> list[str]:
    """Return the completions of the last word."""
    *before, last = words.split(" ")
    complete = ShellComplete(main, {}, "hoopgen", "_HOOPGEN_COMPLETE")
    return [item.value for item in complete.get_completions(before, last)]


def test_a_shell_completes_names_of_variables_measures_presets_and_scenes(
    folder: Path,
) -> None:
    assert completed("map --over elev") == ["elevation="]
    assert completed("optimum --over ") == [f"{name}=" for name in VARIABLES]
    assert completed("estimate --scatter back") == ["backspin="]
    assert completed("shot --set ring") == ["ring_radius="]
    assert "speed=" not in completed("shot --set ")
    assert completed("estimate --measure ") == list(MEASURES)
    assert completed("batch --measure apex") == ["apex"]
    assert completed("shot --preset ") == ["paper", "nba", "fiba"]
    (folder / "deep").mkdir()
    (folder / "deep" / "own.toml").write_bytes(b"")
    assert completed("shot --scene ") == [
        "hoop",
        "court",
        "air",
        "court-air",
        "deep/",
        "scene.toml",
    ]
    assert completed("shot --scene deep/") == ["deep/own.toml"]
    assert completed("shot --scene nowhere/x") == []
    assert completed("estimate --scene scene.toml --scatter v") == ["vx=", "vy=", "vz="]
    assert "hole_radius=" in completed("estimate --scene scene.toml --set ")


def test_a_preset_that_a_scene_lacks_is_refused_with_those_that_it_has(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    golf = str(SCENES / "golf.toml")
    state = ["--position", "0,0,1", "--velocity", "0,0,0"]
    said = failure("shot", *state, "--scene", golf, "--preset", "nba")
    assert "--preset nba is not one of the scene golf: it has none; leave it out" in said
    fewer = {name: value for name, value in hoopgen.COURT.presets.items() if name != "fiba"}
    monkeypatch.setattr(hoopgen.COURT, "presets", fewer)
    said = failure("shot", *RELEASE, "--scene", "court", "--preset", "fiba")
    assert "--preset fiba is not one of the scene court: expected paper, nba" in said
