"""One rule of units wherever text is typed; outputs that are inputs again; text in other units."""

from __future__ import annotations

import csv
import json
import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click
import numpy as np
import pytest

from tests.helpers import ROOT
from tests.helpers.commands import output, run

for _library in ("pyarrow", "scipy", "xarray", "pydantic", "matplotlib"):
    pytest.importorskip(_library)

import pyarrow as pa  # noqa: E402
import pyarrow.parquet as pq  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen import plots  # noqa: E402
from hoopgen.cli import main  # noqa: E402
from hoopgen.core.unit_table import OUNCE  # noqa: E402
from hoopgen.core.units import DISPLAY_UNITS, FOOT, display_unit, use_units  # noqa: E402
from hoopgen.core.variables import STATE  # noqa: E402
from hoopgen.hoop.variables import VARIABLES  # noqa: E402
from hoopgen.report.provenance import describe_scene  # noqa: E402
from hoopgen.report.quantities import format_variable, quantity  # noqa: E402
from hoopgen.study.named_units import in_units, named, parameters_named  # noqa: E402
from hoopgen.study.questions.aim_table import aim_table  # noqa: E402
from hoopgen.study.questions.bank import bank_or_direct  # noqa: E402
from hoopgen.study.tables.columns import NAMED, columns_of, variable_of  # noqa: E402
from hoopgen.studyfile import check_study  # noqa: E402
from hoopgen.studyfile.reading import StudyError  # noqa: E402

README = ROOT / "README.md"
DEGREE = np.pi / 180
INCH = 0.0254
MPH = 1609.344 / 3600

PLACE = {"height": 7 * FOOT, "distance": 13.75 * FOOT}
SHOT = ["--speed", "7.17", "--elevation", "52deg", "--height", "7ft", "--distance", "13.75ft"]
PLAYER = [*SHOT, "--scatter", "speed=0.07", "--scatter", "elevation=1.3deg", "--shots", "500"]


# What is typed


STUDY = (
    "[study]\nname = 'x'\n[release]\nspeed = 7.17\nheight = 2.1\ndistance = '13.75'\n{line}\n"
    "[[question]]\nname = 'a'\nkind = 'estimate'\n"
)


@pytest.mark.parametrize(
    ("name", "number", "units"),
    [("elevation", "52", ("deg", "rad")), ("backspin", "3", ("Hz", "rpm", "rad/s", "deg/s"))],
)
def test_a_bare_angle_or_spin_is_asked_about_in_all_three_places(
    name: str, number: str, units: tuple[str, ...], tmp_path: Path
) -> None:
    result = run("shot", *SHOT, f"--{name}", number)
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert f"'--{name}': '{number}' has no unit: write" in result.stderr
    file = tmp_path / "study.toml"
    file.write_text(STUDY.format(line=f"{name} = {number}"))
    with pytest.raises(StudyError, match=rf"release\.{name}: .*has no unit: write") as refused:
        check_study(file)
    with pytest.raises(ValueError, match=rf"column {name} has no unit: name it") as unnamed:
        columns_of([name, "speed", "height", "distance"])
    for unit in units:
        assert f"{number}{unit}" in result.stderr
        assert f'"{number} {unit}"' in str(refused.value)
        assert f"{name}_{unit.lower().replace('/', '_')}" in str(unnamed.value)


def test_a_bare_length_or_speed_is_si_in_all_three_places(tmp_path: Path) -> None:
    told = json.loads(output("shot", *SHOT, "--height", "2.1", "--speed", "7", "--json"))
    assert told["release"][2] == 2.1 - 3.048
    file = tmp_path / "study.toml"
    file.write_text(STUDY.format(line="elevation = '52deg'"))
    (asked,) = check_study(file)
    assert asked.setting.release["distance"] == 13.75
    assert asked.setting.release["height"] == 2.1
    assert variable_of("height") == ("height", 1.0)


def test_every_option_with_an_angle_in_it_asks() -> None:
    for arguments, said in [
        (["estimate", *PLAYER, "--scatter", "azimuth=1"], "write 1deg or 1rad"),
        (["estimate", *PLAYER, "--versus", "elevation=50"], "write 50deg or 50rad"),
        (["map", *SHOT[4:], "--over", "elevation=45:60:4"], "write 45deg or 45rad"),
        (["map", *SHOT[4:], "--over", "elevation=45deg,60"], "write 60deg or 60rad"),
        (["optimum", *SHOT[4:], "--over", "elevation=45deg:60"], "write 60deg or 60rad"),
        (["aim", *SHOT[4:], "--entry", "45"], "write 45deg or 45rad"),
        (["batch", str(README), "--out", "x.parquet", "--release", "backspin=3"], "3Hz, 3rpm"),
        (["certify", *SHOT, "--angle", "30"], "write 30deg or 30rad"),
    ]:
        result = run(*arguments)
        assert result.exit_code == 2, arguments
        assert said in result.stderr


def _commands() -> dict[str, click.Command]:
    context = click.Context(main)
    found = {name: main.get_command(context, name) for name in main.list_commands(context)}
    return {name: command for name, command in found.items() if command is not None}


def _examples() -> list[str]:
    texts = [command.epilog or "" for command in [main, *_commands().values()]]
    texts += [README.read_text("utf-8")]
    lines = [line for text in texts for line in text.replace("\\\n", " ").splitlines()]
    starts = (re.match(r"(?:\$ | {2,4})hoopgen (\w+ .*)", line) for line in lines)
    found = [start[1].partition(">")[0] for start in starts if start]
    elsewhere = ("--help", "--reference", "--root")  # print and exit, or look at another folder
    return [line for line in found if not any(word in line for word in elsewhere)]


@pytest.mark.parametrize("line", _examples())
def test_options_of_every_example_are_understood(
    line: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    name, *arguments = shlex.split(line)
    for word in arguments:
        if re.fullmatch(r"[\w/-]+\.\w+", word):
            assert "/" not in word or (README.parent / word).exists()
            (tmp_path / word).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / word).touch()
            scene = README.parent / "examples" / "scenes" / word
            if scene.exists():  # a scene is read with the option that names it
                (tmp_path / word).write_bytes(scene.read_bytes())
    command = _commands()[name]
    with command.make_context(name, arguments):
        pass


def test_examples_are_found() -> None:
    names = {line.split()[0] for line in _examples()}
    assert {"shot", "estimate", "map", "optimum", "aim", "batch", "view", "study"} <= names


# Degrees where radians are wanted

FREE = {"speed": 7.17, **PLACE}
SD = {"speed": 0.07}
DEGREES: dict[str, Callable[[], Any]] = {
    "release": lambda: hoopgen.release(7.17, 52, **PLACE),
    "release of many": lambda: hoopgen.release(7.17, [51, 52, 0.9], **PLACE),
    "release, azimuth": lambda: hoopgen.release(7.17, 0.9, -10, **PLACE),
    "release, angle": lambda: hoopgen.release(7.17, 0.9, angle=45, **PLACE),
    "release of a scatter": lambda: hoopgen.Scatter({**FREE, "elevation": 52}, SD),
    "sd": lambda: hoopgen.Scatter({**FREE, "elevation": 0.9}, {"elevation": 13.0}),
    "columns": lambda: hoopgen.Resample({**FREE, "elevation": [52.0, 51.0]}),
    "axes": lambda: hoopgen.Grid({"elevation": [45.0, 60.0]}, FREE),
    "fixed": lambda: hoopgen.Grid({"speed": [7.0]}, {**PLACE, "elevation": 52.0}),
    "over of a map": lambda: hoopgen.map(hoopgen.Scatter(FREE), {"elevation": [45, 60]}),
    "over of an optimum": lambda: hoopgen.optimum(
        hoopgen.Scatter(FREE, SD), {"elevation": (45, 60)}
    ),
    "aim": lambda: hoopgen.aim(entry=45, **PLACE),
    "release of a batch": lambda: hoopgen.batch("x.csv", "x.parquet", release={"elevation": 52}),
}


@pytest.mark.parametrize("what", DEGREES)
def test_angles_over_a_turn_are_refused_with_a_hint(what: str) -> None:
    with pytest.raises(ValueError, match=r"is in radians.*np\.radians\(\.\.\.\)") as refused:
        DEGREES[what]()
    argument = re.split(r",? of |, ", what)[0]
    assert str(refused.value).startswith(f"{argument}: ")


def test_one_wild_angle_or_spin_refuses_no_other() -> None:
    states = hoopgen.release(7.17, [0.9, 999.0, np.nan, 0.8], **PLACE)
    assert np.isfinite(states[[0, 1, 3]]).all()
    spun = hoopgen.release(7.17, 0.9, backspin=[20.0, 999.0, 100.0], sidespin=-90.0, **PLACE)
    assert spun[:, 7].tolist() == [20.0, 999.0, 100.0]


SPUN = {**FREE, "elevation": 0.9}
NO_RADIANS: dict[str, Callable[[], Any]] = {
    "release": lambda: hoopgen.release(7.17, 0.9, backspin=180, **PLACE),
    "release, many": lambda: hoopgen.release(7.17, 0.9, sidespin=[-180, 120, 10], **PLACE),
    "release of a scatter": lambda: hoopgen.Scatter({**SPUN, "backspin": 180}, SD),
    "sd": lambda: hoopgen.Scatter(SPUN, {"backspin": 120.0}),
    "columns": lambda: hoopgen.Resample({**SPUN, "backspin": [180.0, 170.0]}),
    "axes": lambda: hoopgen.Grid({"backspin": [120.0, 180.0]}, SPUN),
    "over": lambda: hoopgen.map(hoopgen.Scatter(SPUN), {"backspin": [120, 180]}),
    "release of a batch": lambda: hoopgen.batch("x.csv", "x.parquet", release={"backspin": 180}),
    "aim": lambda: aim_table([4.2], height=2.1, backspin=180),
}


@pytest.mark.parametrize("what", NO_RADIANS)
def test_spins_of_rpm_or_degrees_are_refused_with_a_hint(what: str) -> None:
    with pytest.raises(ValueError, match=r"is in rad/s, and these are more than 100, 16 turns"):
        NO_RADIANS[what]()


def test_a_negative_speed_is_refused_and_one_of_many_is_invalid() -> None:
    """A bad row among measured ones stops no other, as with a negative distance."""
    with pytest.raises(ValueError, match=r"^speed: expected 0 m/s or more, got -7\.0"):
        hoopgen.release(-7.0, 0.9, **PLACE)
    with pytest.raises(ValueError, match=r"^distance: expected 0 m or more, got -1\.0"):
        hoopgen.release(7.0, 0.9, height=2.1, distance=-1.0)
    with pytest.raises(ValueError, match=r"^speed: expected 0 m/s or more"):
        hoopgen.batch("x.csv", "x.parquet", release={"speed": -7})
    states = hoopgen.release([7.17, -7.17, 0.0], 0.9, **PLACE)
    assert np.isfinite(states).all(axis=1).tolist() == [True, False, True]
    shots = hoopgen.simulate(states)
    assert [shots.scene.outcomes(code).name for code in shots.outcome][1] == "INVALID"


# Outputs are inputs


@pytest.mark.parametrize("name", [*VARIABLES, *STATE])
def test_what_is_written_is_read_as_it_was(name: str) -> None:
    assert variable_of(named(name)) == (name, 1.0)


def test_keys_say_the_units_of_the_numbers_below() -> None:
    record = {
        "release": {"elevation": 0.9, "restitution": 0.7},
        "flat": {"aim": (0.0, 0.1)},
        "margins": {"speed": {"name": "speed", "value": 7.0, "low": 6.9}},
        "time": None,
        "events": [{"time": 1.0}],
        "made": 3,
    }
    assert in_units(record) == {
        "release": {"elevation_rad": 0.9, "restitution": 0.7},
        "flat": {"aim_m": [0.0, 0.1]},
        "margins": {"speed": {"name": "speed", "value": 7.0, "low": 6.9, "unit": "m/s"}},
        "time_s": None,
        "events": [{"time_s": 1.0}],
        "made": 3,
    }
    assert parameters_named(in_units(dict(hoopgen.NBA))) == dict(hoopgen.NBA)


@pytest.mark.slow
def test_keys_say_the_units_of_a_scenes_own_parameters() -> None:
    values = dict(hoopgen.NBA_COURT)
    record = in_units({"parameters": values}, hoopgen.COURT)["parameters"]
    assert {"board_thickness_m", "bridge_depth_m", "restitution_speed_m_s"} < record.keys()
    assert parameters_named(record, hoopgen.COURT) == values
    words = [
        "--over",
        "elevation",
        "--speed",
        "7.2",
        "--height",
        "7ft",
        "--distance",
        "13.75ft",
        "--scatter",
    ]
    words += ["speed=0.07", "--scene", "court", "--preset", "nba", "--shots", "50", "--json"]
    found = json.loads(output("optimum", *words))
    assert found["parameters"].keys() == record.keys()


def test_a_map_is_a_table_of_releases(tmp_path: Path) -> None:
    cells, results = tmp_path / "map.csv", tmp_path / "results.parquet"
    over = ["--over", "elevation=48deg:56deg:4", "--over", "speed=7.0,7.2"]
    output("map", *over, *SHOT[4:], "--backspin", "3Hz", "--out", str(cells))
    with cells.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    output("batch", str(cells), "--out", str(results), "--prefix", "again_", "--measure", "depth")
    table = pq.read_table(results)
    # The columns hold every bit of the releases, so that each shot is the same.
    assert table["again_outcome"].to_pylist() == [row["outcome"] for row in rows]
    assert table["again_depth_m"].type == pa.float64()
    assert json.loads(table.schema.metadata[b"hoopgen"])[NAMED] is True


def test_results_of_an_older_version_are_viewed_as_they_were(tmp_path: Path) -> None:
    file, page = tmp_path / "results.parquet", tmp_path / "page.html"
    columns = {"speed": [7.2], "elevation": [0.9], "height": [2.1], "distance": [4.2]}
    said = {"version": "0.0", "parameters": dict(hoopgen.NBA), "release": {}, "max_contacts": 40}
    about = {"hoopgen": json.dumps(said)}
    pq.write_table(pa.table(columns).replace_schema_metadata(about), file)
    output("view", str(file), "--out", str(page))
    pq.write_table(pa.table(columns), file)
    assert "column elevation has no unit" in run("view", str(file), "--out", str(page)).stderr


@pytest.mark.parametrize("old", [False, True])
def test_a_shot_in_json_is_certified(old: bool, tmp_path: Path) -> None:
    pytest.importorskip("flint")
    file = tmp_path / "shot.json"
    told = json.loads(output("shot", *SHOT, "--set", "restitution=0.6", "--json"))
    if old:
        told["parameters"] = parameters_named(told["parameters"])
    file.write_text(json.dumps(told))
    proof = json.loads(output("certify", str(file), "--json"))
    assert proof["outcome"] == told["outcome"]
    assert [event["surface"] for event in proof["events"]] == [
        event["surface"] for event in told["events"]
    ]
    assert {"time_s", "before", "after"} <= {*proof["events"][0]}


# Other units


def numbers(text: str) -> list[float]:
    return [float(word) for word in re.findall(r"-?\d+\.\d+", text)]


def test_a_shot_is_told_in_feet_and_mph() -> None:
    si, us = (output("shot", *SHOT, "--units", units) for units in ("si", "US"))
    assert si == output("shot", *SHOT)
    assert "position (ft)" in us
    assert "before (mph)" in us
    assert "m/s" not in us
    release = [numbers(line) for text in (si, us) for line in text.splitlines() if "rele" in line]
    (_, x, y, z, *metric), (_, a, b, c, *speeds) = release
    np.testing.assert_allclose([a, b, c], np.array([x, y, z]) / FOOT, rtol=0, atol=4e-4)
    np.testing.assert_allclose(speeds, np.array(metric) / MPH, rtol=0, atol=4e-4)
    assert "ft from the centre of the ring" in us


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("arguments", "there"),
    [
        (["aim", *SHOT[4:], "--depth", "2in"], ["mph at ", "2.00 in past its centre"]),
        (
            ["aim", "--distance", "10ft:14ft:2ft", "--height", "7ft"],
            ["dist. (ft)", "(mph)", "12.00"],
        ),
        (
            ["optimum", *PLAYER, "--over", "aim=-1in:4in", "--elevation", "52deg"],
            [" mph at 52.0°", " in past the centre", "7.00 ft", "13.75 ft", " mph*"],
        ),
        (["estimate", *PLAYER, "--versus", "height=8ft"], ["height 8.00 ft"]),
        (["estimate", *PLAYER, "--versus", "ball_radius=4.7in"], ["ball_radius 4.70 in"]),
        (
            ["map", *PLAYER, "--over", "aim=1in:2in:2", "--over", "height=7ft,7.5ft"],
            [" in, height 7."],
        ),
    ],
)
def test_every_command_speaks_feet_inches_and_mph(arguments: list[str], there: list[str]) -> None:
    if "--over" in arguments:  # speed and elevation, or height, are searched or mapped over
        speed, height = arguments.index("--speed"), arguments.index("--height")
        del arguments[speed : speed + 2]
        if "height=7ft,7.5ft" in arguments:
            del arguments[height - 2 : height]
    text = output(*arguments, "--units", "us")
    for words in there:
        assert words in text
    assert not re.search(r"\d (m|cm|m/s)\b", text)


def test_values_are_said_in_the_units_shown() -> None:
    with use_units("us"):
        assert format_variable("distance", 13.75 * FOOT) == "13.75 ft"
        assert format_variable("aim", 2 * INCH) == "2.00 in"
        assert format_variable("ring_radius", 9 * INCH) == "9.00 in"
        assert format_variable("speed", 16 * MPH) == "16.00 mph"
        assert format_variable("elevation", 52 * DEGREE) == "52.0°"
        assert format_variable("backspin", 6 * np.pi) == "3.00 Hz"
        assert quantity("gravity").label == "gravity (ft/s²)"
        assert format_variable("ball_mass", 22 * OUNCE) == "22.00 oz"
        assert format_variable("air_density", 1.2) == "0.0749 lb/ft³"
        assert quantity("aim").label == "aim past the ring's centre (in)"
    assert format_variable("aim", 0.05) == "5.0 cm"
    assert format_variable("ball_mass", 0.624) == "0.624 kg"


def test_the_scene_is_described_in_the_units_shown() -> None:
    pytest.importorskip("sympy")  # of the scene in air
    own = {"ball_mass": 20 * OUNCE, "gravity": 9.8, "restitution": 0.6}
    parameters = hoopgen.PAPER_AIR | own
    assert describe_scene(hoopgen.AIR, parameters) == (
        "air, PAPER, restitution 0.6, gravity 9.8 m/s², ball_mass 0.56699 kg"
    )
    with use_units("us"):
        assert describe_scene(hoopgen.AIR, parameters | {"ring_radius": [9 * INCH, 10 * INCH]}) == (
            "air, PAPER, ring_radius 9 to 10 in, restitution 0.6, gravity 32.1522 ft/s², "
            "ball_mass 20 oz"
        )


def _fan() -> Any:
    shots = hoopgen.simulate(STATES, record=True)
    return plots.plot_fan(shots, hoopgen.PAPER)


STATES = hoopgen.release(np.linspace(7.0, 7.4, 5), 0.9, 0.02, 18.0, **PLACE)


def _bank() -> Any:
    release = {"height": 2.1, "backspin": 18.0}
    dataset = bank_or_direct(hoopgen.Scatter(release, {"speed": 0.07}), [[2.0, 2.0]], shots=200)
    return plots.plot_aim_points(dataset, hoopgen.PAPER)


PICTURES: dict[str, Callable[[], Any]] = {
    "trajectory": lambda: hoopgen.simulate(STATES, record=True).trajectory(0).plot(),
    "fan": _fan,
    "landings": lambda: plots.plot_landings(
        np.linspace(-1, 3, 50), np.linspace(-2, 2, 50), hoopgen.PAPER
    ),
    "aim_points": _bank,
    "map": lambda: plots.plot_map(
        hoopgen.map(
            hoopgen.Scatter({"aim": 0, "entry": 0.7}),
            {"height": [2.0, 2.1, 2.2], "distance": [4.0, 4.2]},
        )
    ),
}


@pytest.mark.sampled(1)
@pytest.mark.parametrize("name", PICTURES)
def test_axes_of_pictures_are_in_feet(name: str) -> None:
    with use_units("us"):
        figure = PICTURES[name]()
    figure.canvas.draw()  # what is drawn later is drawn as it was meant
    texts = [text.get_text() for text in figure.findobj(lambda one: hasattr(one, "get_text"))]
    said = " ".join(texts)
    assert "(ft)" in said
    assert not re.search(r"\(m\)|m/s|m²|\d m\b", said)
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis) if axes.axison else ():
            if "(ft)" in axis.get_label_text() and name != "map":
                ticks = np.abs(axis.get_majorticklocs()) / FOOT
                shown = [
                    text.get_text().replace("\N{MINUS SIGN}", "-") for text in axis.get_ticklabels()
                ]
                np.testing.assert_allclose(np.abs([float(one) for one in shown]), ticks, atol=1e-6)
                # Round numbers of feet.
                np.testing.assert_allclose(ticks * 4, np.round(ticks * 4), rtol=0, atol=1e-9)


@pytest.mark.slow
def test_a_trajectory_says_its_release_in_mph_and_turns() -> None:
    path = hoopgen.simulate(
        hoopgen.release(16 * MPH, 0.9, backspin=6 * np.pi, **PLACE), record=True
    ).trajectory(0)
    for system, said, away in (("us", "16.00 mph", "13.75 ft"), ("si", "7.15 m/s", "4.191 m")):
        with use_units(system):
            texts = " ".join(" ".join(text.get_text() for text in path.plot().texts).split())
        assert f"Released at {said}" in texts
        assert f"{away} from the ring's centre" in texts
        assert (r"$\omega_y/2\pi=3$ Hz" in texts) == (system == "us")


@pytest.mark.parametrize(
    "refused",
    [
        pytest.param(["--speed", "7"], id="incomplete"),
        pytest.param(["--speed", "seven"], id="not-a-speed"),
    ],
)
def test_a_refused_command_leaves_the_units_as_they_were(refused: list[str]) -> None:
    with pytest.raises(click.UsageError) as error:
        main(["shot", "--units", "us", *refused], standalone_mode=False)
    assert error.value.ctx is not None  # It is held here, so that nothing else has ended it.
    assert display_unit("length") == DISPLAY_UNITS["si"]["length"]
