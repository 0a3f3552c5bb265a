"""Errors of commands name options as they are typed, and values as they were given."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

import pytest

from tests.helpers import ROOT
from tests.helpers.commands import failure

pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

import hoopgen
from hoopgen.cli.spelling import spell_options

GOLF = ROOT / "examples" / "scenes" / "golf.toml"
PLACE = "--height 7ft --distance 13.75ft"
SHOT = f"--speed 7 --elevation 52deg {PLACE}"
SCATTER = "--scatter speed=0.07 --scatter azimuth=1deg"
AIMED = f"--aim 5cm --elevation 52deg {PLACE} {SCATTER}"
DEGREES = "\N{DEGREE SIGN}, got"
SEEN = "speed,elevation_deg,height,distance,made\n" + "7.1,52,2.1,4.2,1\n" * 12

PYTHON = ("np.", " rad", "radians", "(low, high)", "override=", "1.047", "sd,", "hoopgen.")
"""Parts of errors that only Python's users can act on."""


@pytest.fixture
def seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with a table of few releases, in which the commands run."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "seen.csv").write_text(SEEN, encoding="utf-8")
    (tmp_path / "few.csv").write_text("\n".join(SEEN.splitlines()[:3]), encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            f"shot --speed 7 --elevation 520deg {PLACE}",
            f"'--elevation': implausible: expected -90 to 90{DEGREES} '520deg'",
        ),
        (
            f"shot {SHOT} --azimuth 400deg",
            f"'--azimuth': implausible: expected -180 to 180{DEGREES} '400deg'",
        ),
        (f"shot {SHOT} --backspin 3000rpm", "15.9Hz or 955rpm; got '3000rpm'"),
        ("shot --distance 400ft", "implausible: expected 0 to 40 m, got '400ft'"),
        (
            f"map {AIMED} --over elevation=45deg:500deg:3",
            f"elevation: implausible: expected -90 to 90{DEGREES} '500deg'",
        ),
        (
            f"estimate {SHOT} --scatter elevation=40deg",
            "'--scatter': elevation: expected a standard deviation below 28.6deg, got '40deg'",
        ),
        (
            f"optimum --over elevation=60deg:45deg --speed 7 {PLACE} {SCATTER}",
            "'--over': elevation: expected low:high, low below high; got '60deg:45deg'",
        ),
        (
            f"optimum --over height --speed 7 --elevation 52deg --distance 13ft {SCATTER}",
            "--over height: expected NAME=LOW:HIGH; there are no usual bounds",
        ),
        (
            f"optimum --over elevation --aim 0 {PLACE}",
            "error: --scatter: expected a deviation above 0;",
        ),
        (f"estimate {SHOT} --scatter speed=0 --solve 70%", "multiply; give --scatter\n"),
        ("best --step 1cm", "'--step': expected a length from 0.5 m to 3 m; got '1cm'"),
        (f"counterfactual {SHOT} --steady=-1", "expected a number of at least 0; got '-1'"),
        (f"aim {PLACE} --entry 95deg", f"implausible: expected 0 to 90{DEGREES} '95deg'"),
        ("aim --height 7ft --distance 400ft", "implausible: expected 0 to 40 m, got '400ft'"),
        (
            f"aim {PLACE} --entry 45deg --speed 7",
            "error: expected --entry, --elevation or --speed, or none of them; got --entry and "
            "--speed\n",
        ),
        (f"aim {PLACE} --target 0,0,0 --depth 2in", "error: expected --depth or --target; got"),
        (f"estimate {AIMED} --speed 7", "error: --aim takes the place of --speed; got both\n"),
        (f"estimate {AIMED} --x 3", "error: --x takes the place of --distance; got both\n"),
        (f"estimate {AIMED} --place elbow", "error: --place says where; leave out --distance\n"),
        (
            "batch seen.csv --out o.csv --place elbow --release distance=3",
            "error: --place says where; leave out --release distance\n",
        ),
        (f"best --scene {GOLF}", "error: --scene: its question is a hoop's, and the scene golf"),
        (f"coach --scene {GOLF}", "error: --scene: its question is a hoop's, and the scene golf"),
        ("estimate --from few.csv --fitted", "error: --fitted: few.csv: expected at least"),
        ("coach --from few.csv", "error: --from: few.csv: expected at least"),
        (
            "estimate --from seen.csv --fitted --instrument entry=2deg",
            "error: --instrument: entry is no column of the table; expected one of speed",
        ),
        (
            "coach --from seen.csv --instrument entry=2deg",
            "error: --instrument: entry is no column of the table; expected one of speed",
        ),
        ("estimate --from seen.csv --gradient speed", "error: --gradient: the share made of meas"),
        ("calibrate seen.csv --vary restitution", "error: --instrument: expected standard errors"),
        ("calibrate seen.csv --vary restitution", ", such as speed=3cm/s\n"),
        (
            "calibrate seen.csv --vary gravity --instrument speed=3cm/s",
            "error: --vary: gravity has no usual bounds; give NAME=LOW:HIGH\n",
        ),
        (
            "calibrate seen.csv --vary restitution=0.2:2 --instrument speed=3cm/s",
            "restitution: expected low below high within its limits, got 0.2:2.0\n",
        ),
    ],
)
def test_an_error_is_in_the_words_of_the_command(seen: Path, words: str, said: str) -> None:
    text = failure(*shlex.split(words))
    assert said in text
    assert not [one for one in PYTHON if one in text.replace("(see hoopgen", "")]


def test_calibrate_offers_parameters_of_the_scene_alone(seen: Path) -> None:
    said = failure("calibrate", "seen.csv", "--vary", "colour")
    assert "'colour' is none of ball_radius, " in said
    assert "speed" not in said
    assert "'speed' is none of ball_radius" in failure(
        "calibrate", "seen.csv", "--vary", "speed=1:2"
    )


@pytest.mark.parametrize(
    ("missing", "words", "said"),
    [
        ("cupy", f"estimate {AIMED} --backend cuda", "--backend: 'cuda' needs cupy: pip"),
        (
            "distributed",
            f"estimate {AIMED} --scheduler tcp://127.0.0.1:1",
            "--scheduler: a Dask scheduler needs distributed: pip",
        ),
        ("openpyxl", "coach --from a.xlsx", "a table in .xlsx needs openpyxl: pip"),
    ],
)
def test_a_missing_package_is_that_of_an_option(
    seen: Path, monkeypatch: pytest.MonkeyPatch, missing: str, words: str, said: str
) -> None:
    (seen / "a.xlsx").write_bytes(b"PK")
    monkeypatch.setitem(sys.modules, missing, None)
    assert f"hoopgen: error: {said} install" in failure(*shlex.split(words))


def test_a_function_that_lacks_a_package_is_the_command() -> None:
    text = "hoopgen.coach needs pyarrow: pip install x"
    assert spell_options(text, {}, "hoopgen coach") == "hoopgen coach needs pyarrow: pip install x"


OVERRIDE = (
    "f.csv: got x; leave these out, or override what the file says (override=True, --override)"
)


def test_only_options_that_a_command_has_are_recommended() -> None:
    options = {"override": "--override", "own": "--own"}
    assert spell_options(OVERRIDE, options, "").endswith("what the file says (--override)")
    assert spell_options(OVERRIDE, {}, "").endswith("; leave these out")
    text = "columns a and b both say x; keep one, or list the other in own"
    assert spell_options(text, options, "") == text.replace("in own", "with --own")
    assert spell_options(text, {}, "") == text
    text = "if it is a column of your own, list it in own (--own 'my x')"
    assert spell_options(text, options, "").endswith("of your own, give --own 'my x'")
    assert spell_options(text, {}, "").endswith("of your own, list it in own")
    missing = "f.csv: variables: missing height, distance. The columns are height_cm"
    assert spell_options(missing, {"height": "--height"}, "") == missing.replace("variables: ", "")
    assert spell_options(missing, {}, "") == missing


def test_a_file_that_is_called_like_an_argument_is_no_option(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def unreadable(**_: object) -> None:
        raise OSError(13, "Permission denied", "preset")

    monkeypatch.setattr(hoopgen, "release", unreadable)
    assert failure(*shlex.split(f"shot {SHOT}")) == "hoopgen: error: preset: Permission denied\n"
