"""The command line: what it prints, what it writes, how it fails."""

from __future__ import annotations

import dataclasses
import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import hoopgen
import hoopgen.simulation.article
from hoopgen.cli import main
from hoopgen.core.units import FOOT
from hoopgen.study.named_units import in_units
from hoopgen.text.tables import NO_BREAK, table
from tests.helpers.commands import RELEASE, failure, run, succeed

SHOT = ["shot", *RELEASE]
FIGURE_7 = [
    *["shot", "--speed", "7.166", "--elevation", "51.101deg", "--distance", "13.75ft"],
    *["--height", "8ft", "--backspin", "3Hz"],
]
COMMANDS = [
    *("paper", "shot", "estimate", "map", "fan", "landings", "optimum", "aim", "bank", "batch"),
    *(
        "study",
        "view",
        "playground",
        "certify",
        "compile",
        "cache",
        "hash",
        "generate",
        "check",
        "bench",
    ),
]


def record(*arguments: str) -> dict[str, object]:
    result = succeed(*arguments, "--json")
    loaded = json.loads(result.stdout)
    assert isinstance(loaded, dict)
    return loaded


# Help


def test_alone_it_gives_the_tour() -> None:
    result = succeed()
    assert result.stdout == run("--help").stdout
    for command in COMMANDS:
        assert f"\n  {command} " in result.stdout


@pytest.mark.parametrize("command", COMMANDS)
def test_help_teaches_by_two_to_four_examples(command: str) -> None:
    result = succeed(command, "--help")
    examples = [line for line in result.stdout.splitlines() if line.startswith("    hoopgen ")]
    assert 2 <= len(examples) <= 4
    assert [line.split()[1] for line in examples].count(command) >= 2


@pytest.mark.slow
def test_every_example_of_shot_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    text = run("shot", "--help").stdout.replace("\\\n", " ")
    examples = [line.split()[1:] for line in text.splitlines() if line.startswith("    hoopgen ")]
    for example in examples:
        succeed(*example)
    assert (tmp_path / "shot.svg").exists()


def test_help_says_which_numbers_need_a_unit() -> None:
    text = run("shot", "--help").stdout
    assert "--elevation ANGLE [deg|rad]" in text
    assert "--backspin SPIN [Hz|rpm]" in text
    assert "--speed SPEED [m/s]" in text
    assert "an angle or a spin other than 0 needs its unit" in text


@pytest.mark.slow
def test_help_imports_nothing_heavy() -> None:
    script = (
        "import sys\n"
        "from hoopgen.cli import main\n"
        "main(['--help'], standalone_mode=False)\n"
        "heavy = {'matplotlib', 'sympy', 'jinja2', 'scipy', 'pyarrow', 'xarray', 'pydantic',\n"
        "         'pandas'} & set(sys.modules)\n"
        "sys.exit(', '.join(heavy) or 0)\n"
    )
    subprocess.run([sys.executable, "-c", script], check=True, stdout=subprocess.DEVNULL)


@pytest.mark.parametrize("command", ["certify", "aim", "estimate"])
def test_a_variable_is_the_same_option_everywhere(command: str) -> None:
    def told(name: str) -> dict[str, str]:
        """Options and their metavars, without those that a command means otherwise."""
        found = re.findall(r"^  --(\w+) (\S+ \[\S+\]) ", run(name, "--help").stdout, re.MULTILINE)
        return {option: metavar for option, metavar in found if option != "distance"}

    shot, other = told("shot"), told(command)
    shared = set(shot) & set(other)
    assert {"speed", "elevation", "height", "backspin", "sidespin", "angle"} <= shared
    assert {name: other[name] for name in shared} == {name: shot[name] for name in shared}


# paper


def test_paper_tells_every_case_and_agrees() -> None:
    result = succeed("paper")
    for case in hoopgen.simulation.article.CASES:
        assert any(line.startswith(f"{case.name}  ") for line in result.stdout.splitlines())
    assert "the spin is unclear" in result.stdout
    assert "backboard 0.427, end 0.696" in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 100


def test_paper_lists_every_event() -> None:
    result = succeed("paper", "--events")
    events = sum(len(shot.events) for shot in hoopgen.simulation.article.run())
    rows = [line for line in result.stdout.splitlines() if " ring " in line or " end " in line]
    assert len(rows) >= events - 12  # those on backboard and bridge aside
    assert "Fig. 6b, wz = 2 rad/s: Improper layup" in result.stdout


def test_paper_fails_when_a_case_does_not_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    first, *others = hoopgen.simulation.article.run()
    shown = dataclasses.replace(first.case.shown, sequence=("bridge",))
    wrong = dataclasses.replace(first, case=dataclasses.replace(first.case, shown=shown))
    monkeypatch.setattr(hoopgen.simulation.article, "run", lambda **_: (wrong, *others))
    result = run("paper")
    assert result.exit_code == 1
    assert "NO: another" in result.stdout
    assert result.stderr == "\nNot as in the article: 5a\n"


@pytest.mark.slow
def test_paper_draws_every_figure(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    folder = tmp_path / "new" / "figures"
    result = succeed("paper", "--out", str(folder), "--format", "svg")
    names = {path.name for path in folder.iterdir()}
    pictures = {f"figure-{case.slug}.svg" for case in hoopgen.simulation.article.CASES}
    assert names == {*pictures, "table.txt"}
    assert f"table.txt, and 8 pictures are in {folder}" in result.stdout


@pytest.mark.slow
def test_paper_writes_the_table_that_it_prints(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    result = run("paper", "--out", str(tmp_path), "--format", "svg", "--events")
    written = (tmp_path / "table.txt").read_text("utf-8")
    assert written == run("paper", "--events").stdout
    assert result.stdout.startswith(written)


def test_paper_refuses_an_unknown_format(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    assert "'bmp' is none of" in failure("paper", "--out", str(tmp_path), "--format", "png,bmp")


def test_paper_refuses_a_file_as_folder(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_text("")
    assert "is a file" in failure("paper", "--out", str(path))


# shot


def test_shot_is_the_engine_s_shot() -> None:
    state = hoopgen.release(
        speed=7.17, elevation=math.radians(51), height=7 * FOOT, distance=13.75 * FOOT
    )
    shots = hoopgen.simulate(np.reshape(state, (1, 9)), record=True)
    told = record(*SHOT)
    assert told["outcome"] == hoopgen.Outcome(int(shots.outcome[0])).name.lower()
    assert told["release"] == np.reshape(state, 9).tolist()
    assert told["state"] == shots.state[0].tolist()
    assert told["time_s"] == shots.time[0]
    assert told["contacts"] == shots.contacts[0]
    assert told["counts"] == dict(zip(hoopgen.SURFACES, shots.counts[0].tolist(), strict=True))
    events = told["events"]
    assert isinstance(events, list)
    assert [event["time_s"] for event in events] == shots.events["time"].tolist()
    assert [event["after"] for event in events] == shots.events["after"].tolist()
    assert events[-1]["surface"] == "end"


def test_shot_prints_events_outcome_and_counts() -> None:
    result = succeed(*FIGURE_7)
    lines = result.stdout.splitlines()
    groups = [" ".join(part.split()) for part in lines[0].split("-----") if part.strip()]
    assert groups == ["position (m)", "before (m/s)", "after (m/s)"]
    surfaces = [line.split()[1 + (line.split()[0].isdigit())] for line in lines[3:7]]
    assert surfaces[0] == "release"
    assert surfaces[-1] == "end"
    assert any(line.startswith("outcome    missed, ") for line in lines)
    assert any(line.startswith("contacts   2 (ring ") for line in lines)


@pytest.mark.parametrize(
    "option",
    [
        ["--elevation", "51deg"],
        ["--elevation", "51 Degrees"],
        ["--speed", "7.17 m/s"],
        ["--height", "84in"],
        ["--distance", "13ft 9in"],
        ["--azimuth", "-0"],
        ["--set", "restitution=0.70"],
        ["--preset", "PAPER"],
    ],
)
def test_units_do_not_change_the_shot(option: list[str]) -> None:
    same, base = record(*SHOT, *option), record(*SHOT)
    assert same["outcome"] == base["outcome"]
    # Another unit rounds the release once more; a contact multiplies that a few times over.
    np.testing.assert_allclose(same["state"], base["state"], rtol=0, atol=1e-12)


def test_spin_and_azimuth_reach_the_release() -> None:
    told = record(*SHOT, "--backspin", "180rpm", "--sidespin", "-2rad/s", "--azimuth", "-2deg")
    state = hoopgen.release(
        speed=7.17,
        elevation=math.radians(51),
        azimuth=math.radians(-2),
        backspin=180 * (2 * math.pi / 60),
        sidespin=-2.0,
        height=7 * FOOT,
        distance=13.75 * FOOT,
    )
    assert told["release"] == np.reshape(state, 9).tolist()


def test_presets_and_settings_reach_the_scene() -> None:
    told = record(*SHOT, "--preset", "nba", "--set", "restitution=0.75", "--set", "gravity=32ft/s2")
    wanted = hoopgen.NBA | {"restitution": 0.75, "gravity": 32 * FOOT}
    assert told["parameters"] == in_units(dict(wanted))
    assert told["parameters"]["gravity_m_s2"] == 32 * FOOT
    assert told["components"] == ["x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s"] + [
        f"w{axis}_rad_s" for axis in "xyz"
    ]


def test_a_capped_shot_is_told() -> None:
    told = succeed(*FIGURE_7, "--max-contacts", "1")
    assert "outcome    capped: 1 contact, and" in told.stdout


def test_a_shot_whose_bounces_end_gets_a_hint_of_the_scene_in_which_it_rolls() -> None:
    onto_the_bridge = ["--speed", "0.001", "--elevation=-89deg", "--distance", "0.25"]
    place = ["--angle", "180deg", "--height", "3.2"]
    told = succeed("shot", *onto_the_bridge, *place)
    assert "hint       the bounces become ever smaller; with --scene court the ball" in told.stdout
    rolls = succeed("shot", *onto_the_bridge, *place, "--scene", "court")
    assert "rolls      on the bridge from" in rolls.stdout
    assert "hint" not in rolls.stdout
    assert "hint" not in succeed(*FIGURE_7, "--max-contacts", "1").stdout


def test_a_short_shot_is_told_and_is_no_error() -> None:
    arguments = ["shot", "--speed", "3", "--elevation", "40deg", "--distance", "4", "--height", "2"]
    assert "short: the ball never comes down" in run(*arguments).stdout
    assert record(*arguments)["first"] is None


@pytest.mark.sampled(1)
@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_shot_draws_its_picture(tmp_path: Path, suffix: str) -> None:
    pytest.importorskip("matplotlib")
    path = tmp_path / f"shot.{suffix}"
    succeed(*SHOT, "--azimuth", "1deg", "--picture", str(path))
    assert path.stat().st_size > 10_000


# Errors


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["sho"], "No such command 'sho'"),
        (["shot"], "missing --speed, --elevation, --height and --distance"),
        ([*SHOT, "--speed", "7ft"], "'ft' is not a unit of speed; use m/s, cm/s"),
        ([*SHOT, "--elevation", "steep"], "'steep' is not a number with a unit of angle"),
        ([*SHOT, "--elevation", "52"], "'--elevation': '52' has no unit: write 52deg or 52rad"),
        ([*SHOT, "--azimuth", "-1"], "'-1' has no unit: write -1deg or -1rad"),
        ([*SHOT, "--backspin", "3"], "'3' has no unit: write 3Hz, 3rpm, 3rad/s or 3deg/s"),
        ([*SHOT, "--speed", "nan"], "'nan' is not a number"),
        ([*SHOT, "--speed", "7,2"], "decimals stand after a point"),
        ([*SHOT, "--set", "restituton=0.7"], "; is restitution meant?"),
        ([*SHOT, "--set", "bounce=0.7"], "'bounce' is none of ball_radius"),
        ([*SHOT, "--set", "restitution"], "'restitution' is not name=value"),
        ([*SHOT, "--set", "restitution=0.7m"], "a plain number is wanted"),
        ([*SHOT, "--set", "restitution=2"], "restitution"),
        ([*SHOT, "--set", "ring_radius=0.1", "--backend", "numpy"], "too big for the ring"),
        ([*SHOT, "--preset", "ncaa"], "'ncaa' is not one of"),
        ([*SHOT, "--max-contacts", "-1"], "'-1' is not a whole number from 1"),
        ([*SHOT, "--picture", "shot.bmp"], ".png, .svg, .pdf"),
        ([*SHOT, "--backend", "gpu"], "'gpu' is not one of"),
        (["check", "--root", "nowhere"], "'nowhere' does not exist"),
        (["cache", "--show", "--clear"], "--show and --clear exclude each other; leave one out"),
        (["compile", "hoop", "--zip", "hoop-c.tar"], "'hoop-c.tar' ends in none of .zip"),
    ],
)
def test_every_error_is_one_line(arguments: list[str], said: str) -> None:
    assert said in failure(*arguments)


def test_a_picture_that_cannot_be_written_is_one_line(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    path = tmp_path / "none" / "shot.png"
    assert "No such file or directory" in failure(*SHOT, "--picture", str(path))


@pytest.mark.sampled(1)
@pytest.mark.parametrize(
    ("missing", "arguments", "extra"),
    [
        ("matplotlib", [*SHOT, "--picture", "shot.png"], "plot"),
        ("matplotlib", ["paper", "--out", "figures"], "plot"),
        ("sympy", ["check"], "generate"),
        ("jinja2", ["generate"], "generate"),
    ],
)
def test_what_is_not_installed_is_named_with_its_extra(
    missing: str, arguments: list[str], extra: str, tmp_path: Path
) -> None:
    script = (
        "import sys\n"
        f"sys.modules[{missing!r}] = None\n"
        "from hoopgen.cli import main\n"
        "main(sys.argv[1:])\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, *arguments],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        check=False,
    )
    assert done.returncode == 2, done.stderr
    said = rf"hoopgen: error: (a picture|\S+) needs {missing}: pip install (-e )?'.+\[{extra}\]'\n"
    assert re.fullmatch(said, done.stderr), done.stderr


# What nobody foresaw


@pytest.mark.parametrize(
    "error",
    [
        TypeError("unhashable type: 'list'"),
        KeyError("gravity"),
        ZeroDivisionError("division by zero"),
        MemoryError("Unable to allocate 7.28 TiB\nfor an array"),
        RecursionError("maximum recursion depth exceeded"),
        OverflowError(34, "Numerical result out of range"),
    ],
)
def test_what_nobody_foresaw_is_one_line_too(
    error: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(**_: object) -> None:
        raise error

    monkeypatch.setattr(hoopgen, "release", broken)
    monkeypatch.delenv("HOOPGEN_TRACEBACK", raising=False)
    result = run(*SHOT)
    assert result.exit_code == 70
    assert result.stdout == ""
    line = f"hoopgen: error: hoopgen shot: {type(error).__name__}: {' '.join(str(error).split())}"
    assert result.stderr.startswith(f"{line} (this was not foreseen; HOOPGEN_TRACEBACK=1 ")
    assert result.stderr.count("\n") == 1
    monkeypatch.setenv("HOOPGEN_TRACEBACK", "1")
    told = run(*SHOT)
    assert told.exit_code == 70
    assert told.stderr.startswith("Traceback (most recent call last)")
    assert "in broken" in told.stderr
    assert told.stderr.endswith(result.stderr)


def test_a_program_that_calls_the_command_gets_the_error_itself(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def broken(**_: object) -> None:
        raise KeyError("gravity")

    monkeypatch.setattr(hoopgen, "release", broken)
    with pytest.raises(KeyError):
        main(SHOT, standalone_mode=False)


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="pipes as of POSIX")
def test_a_reader_who_has_enough_is_no_error() -> None:
    command = [sys.executable, "-m", "hoopgen", "paper", "--events"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        process.stdout.close()
        assert process.stderr is not None
        assert process.stderr.read() == b""
    assert process.returncode == 1


def test_ctrl_c_is_one_word(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(**_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(hoopgen, "release", interrupted)
    result = run(*SHOT)
    assert result.exit_code == 130
    assert result.stderr == "\nhoopgen: error: interrupted\n"


# generate, check, bench


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    """Return a folder that looks like a source checkout."""
    for name in ("derive", "templates"):
        (tmp_path / name).mkdir()
    return tmp_path


def test_generate_lists_what_it_wrote(monkeypatch: pytest.MonkeyPatch, sources: Path) -> None:
    codegen = pytest.importorskip("hoopgen.codegen")
    monkeypatch.setattr(codegen, "generate", lambda root, _: [root / "generated" / "c" / "hoop.c"])
    result = run("generate", "--root", str(sources))
    assert result.stdout == f"{Path('generated', 'c', 'hoop.c')}\n"
    monkeypatch.setattr(codegen, "generate", lambda root, _: [])
    assert "up to date" in run("generate", "--root", str(sources)).stdout


def test_check_fails_with_the_differences(monkeypatch: pytest.MonkeyPatch, sources: Path) -> None:
    codegen = pytest.importorskip("hoopgen.codegen")
    monkeypatch.setattr(codegen, "check", lambda root: ["generated/c/hoop.c is stale"])
    result = run("check", "--root", str(sources))
    assert result.exit_code == 1
    assert result.stdout == "generated/c/hoop.c is stale\n"
    monkeypatch.setattr(codegen, "check", lambda root: [])
    assert run("check", "--root", str(sources)).exit_code == 0


@pytest.mark.parametrize("command", ["generate", "check"])
def test_a_folder_without_sources_is_no_checkout(command: str, tmp_path: Path) -> None:
    (tmp_path / "derive").mkdir()
    said = failure(command, "--root", tmp_path)
    assert f"'--root': {tmp_path} is no source checkout: it has no templates/" in said
    assert [path.name for path in tmp_path.iterdir()] == ["derive"]


def test_bench_hands_on_arguments_and_status(monkeypatch: pytest.MonkeyPatch) -> None:
    called: list[list[str]] = []

    def fake(command: list[str], **_: object) -> subprocess.CompletedProcess[str]:
        called.append(command)
        return subprocess.CompletedProcess(command, 3)

    monkeypatch.setattr("hoopgen.cli.develop.subprocess.run", fake)
    result = run("bench", "--quick", "--out", "docs")
    assert result.exit_code == 3
    assert called == [[sys.executable, "-m", "benchmarks", "--quick", "--out", "docs"]]


# A real process


@pytest.mark.slow
def test_a_real_process_prints_a_shot() -> None:
    done = subprocess.run(
        [sys.executable, "-c", "from hoopgen.cli import main; main()", *SHOT, "--backend", "numpy"],
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0
    assert done.stderr == ""
    assert done.stdout == run(*SHOT).stdout


@pytest.mark.slow
def test_the_package_can_be_run() -> None:
    command = [sys.executable, "-m", "hoopgen"]
    done = subprocess.run(
        [*command, *SHOT, "--backend", "numpy"],
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, run(*SHOT).stdout, "")
    failed = subprocess.run([*command, "--tour"], capture_output=True, text=True, check=False)
    assert failed.returncode == 2
    assert failed.stderr == "hoopgen: error: No such option '--tour'. (see hoopgen --help)\n"


@pytest.mark.slow
def test_a_real_process_fails_without_a_traceback() -> None:
    done = subprocess.run(
        [sys.executable, "-c", "from hoopgen.cli import main; main()", *SHOT, "--speed", "x"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr == (
        "hoopgen: error: Invalid value for '--speed': 'x' is not a number with a unit of speed "
        "(m/s, cm/s, ft/s, km/h, mph) (see hoopgen shot --help)\n"
    )


# Tables


def test_a_table_is_aligned_and_breaks_cells_between_words() -> None:
    text = table(
        ["name", "number"],
        [[f"a b{NO_BREAK}c", "1"], ["d", "-22.5"]],
        right=[1],
        wrap={0: 3},
        groups=[(0, 1, "both")],
    )
    assert text.splitlines() == [
        "--- both ---",
        "name  number",
        "----  ------",
        "a          1",
        "b c",
        "d      -22.5",
    ]


@pytest.mark.parametrize(
    "arguments",
    [
        [*SHOT, "--picture", ""],
        ["paper", "--out", ""],
        ["estimate", "--folder", ""],
        ["map", "--out", ""],
        ["batch", "", "--out", "x.parquet"],
        ["study", "", "--check"],
        ["study", str(Path(__file__)), "--out", ""],
    ],
)
def test_a_path_has_a_name(
    arguments: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert "expected a name, got ''" in failure(*arguments)
    assert not [*tmp_path.iterdir()]


@pytest.mark.slow
def test_counts_are_named_after_bodies_also_one_named_like_a_length(tmp_path: Path) -> None:
    file = tmp_path / "lawn.toml"
    file.write_text(
        'name = "lawn"\nball_radius = "ball"\ngravity = 9.81\nrestitution = 0.5\n'
        "[parameters]\nball = 0.05\ngreen = 1.0\n"
        '[bodies.green]\nkind = "sphere"\nradius = "green"\n[ends.out]\nat = -2.0\n'
    )
    place = ("--scene", str(file), "--position", "0.1,0,1.5", "--velocity", "0,0,0")
    shown = json.loads(succeed("shot", *place, "--json").stdout)
    assert shown["counts"] == {"green": shown["contacts"]}
    assert shown["parameters"]["green_m"] == 1.0
