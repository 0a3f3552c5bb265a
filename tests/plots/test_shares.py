"""Pictures of estimates and of tables of aims, and the commands that draw a player's shots."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from tests.helpers import ROOT
from tests.helpers.commands import run, succeed

pytest.importorskip("matplotlib")
pytest.importorskip("pyarrow")

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import FillBetweenPolyCollection
from matplotlib.figure import Figure

from hoopgen.core.units import use_units
from hoopgen.plots import COLUMN, PAGE, plot_aim, plot_estimate, plot_landings
from hoopgen.study.questions.aim_table import aim_table
from hoopgen.study.statistics.intervals import wilson_interval

RELEASE = {
    "speed": 7.17,
    "elevation": np.radians(52.0),
    "height": 2.1336,
    "distance": 4.191,
    "backspin": 6.0 * np.pi,
}
SD = {"speed": 0.15, "elevation": np.radians(1.3), "azimuth": np.radians(2.0)}


def player(**changes: float) -> hoopgen.Scatter:
    return hoopgen.Scatter({**RELEASE, **changes}, SD)


@pytest.fixture(scope="module")
def found() -> Any:
    return hoopgen.estimate(player(), hoopgen.NBA, shots=3000)


def bars(axes: Axes) -> dict[str, list[float]]:
    """Widths of the parts of each bar, by name, from the left; they follow one another."""
    FigureCanvasAgg(axes.figure).draw()  # type: ignore[arg-type]
    names = [label.get_text() for label in axes.get_yticklabels()]
    parts: dict[str, list[float]] = {name: [] for name in names}
    for patch in axes.patches:
        name = names[round(patch.get_y() + patch.get_height() / 2.0)]
        assert patch.get_x() == pytest.approx(sum(parts[name]), rel=1e-12, abs=1e-15)
        parts[name].append(patch.get_width())
    return parts


def same(one: Any, other: Any) -> bool:
    """Return whether two pictures have the same pixels."""
    drawn = []
    for figure in (one, other):
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        drawn.append(np.asarray(canvas.buffer_rgba()))
    return np.array_equal(*drawn)


@pytest.mark.slow
def test_each_result_made_of_shares_draws_itself(found: Any) -> None:
    compared = hoopgen.compare(player(), player(speed=7.2), shots=500)
    solved = hoopgen.solve(player(), 0.5, shots=500)
    for result in (found, compared, solved):
        assert same(result.plot(title="A title"), plot_estimate(result, title="A title"))
    axes = Figure().add_subplot()
    assert found.plot(ax=axes) is axes


@pytest.mark.slow
def test_answers_are_drawn_as_the_reference_says() -> None:
    aimed = hoopgen.aim(elevation=np.radians(52.0), height=2.1336, distance=4.191)
    paths = hoopgen.simulate(hoopgen.release(**aimed.arguments), record=True).plot()
    assert isinstance(paths, Figure)
    others = {name: value for name, value in RELEASE.items() if name != "speed"}
    best = hoopgen.optimum(hoopgen.Scatter(others, SD), {"speed": (7.0, 7.3)}, shots=300)
    assert isinstance(best.plot(), Figure)


def whiskers(axes: Axes) -> dict[str, tuple[float, float]]:
    names = [label.get_text() for label in axes.get_yticklabels()]
    lines = [line for line in axes.lines if line.get_linestyle() == "-" and line.get_lw() == 1.2]
    return {names[int(line.get_ydata()[0])]: tuple(line.get_xdata()) for line in lines}


# ------------------------------------------------------------------------------------- an estimate


def test_outcomes_have_their_shares_and_intervals(found: Any) -> None:
    axes = plot_estimate(found).axes[0]
    parts = bars(axes)
    assert list(parts) == ["made", "missed"] + ["capped"] * bool(found.capped)
    assert sum(parts["made"]) == pytest.approx(found.probability, rel=1e-12, abs=0)
    made = [n / 3000 for n in found.kinds_made.values() if n]
    assert parts["made"] == pytest.approx(made, rel=1e-12, abs=0)
    assert parts["missed"] == [found.missed / 3000]
    ends = whiskers(axes)
    assert ends["made"] == (found.low, found.high)
    assert ends["missed"] == tuple(map(float, wilson_interval(found.missed, 3000, 0.95)))


def test_kinds_are_split_into_made_and_not(found: Any) -> None:
    figure = plot_estimate(found)
    parts = bars(figure.axes[1])
    there = {name: count for name, count in found.kinds.items() if count}
    assert list(parts) == [name.replace("_", ", ") for name in there]
    for name, count in there.items():
        made = found.kinds_made[name]
        wanted = [made / 3000, (count - made) / 3000]
        assert parts[name.replace("_", ", ")] == pytest.approx(wanted, rel=1e-12, abs=1e-15)
    said = [text.get_text() for text in figure.axes[1].texts]
    for name, count in there.items():
        assert f"{100 * count / 3000:.1f}%" in said or count < 2
        assert f"{100 * found.kinds_made[name] / count:.1f}% of it made" in said
    # Both are on one scale, that of a share.
    assert figure.axes[0].get_xlim() == figure.axes[1].get_xlim()


def test_what_it_rests_on_is_said(found: Any) -> None:
    said = " ".join(text.get_text() for text in plot_estimate(found, title="Free throws").texts)
    assert said.startswith("Free throws 3,000 shots; lines are 95% intervals. Scene: NBA.")
    assert "Scatter: speed 0.15 m/s" in said
    assert "Seed: 0." in said


@pytest.mark.sampled(1)
@pytest.mark.parametrize("width", [COLUMN, PAGE])
def test_nothing_is_off_the_page_or_on_another(found: Any, width: float) -> None:
    figure = plot_estimate(found, width=width)
    assert figure.get_figwidth() == width
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    page = figure.bbox
    boxes = [
        text.get_window_extent() for axes in figure.axes for text in axes.texts if text.get_text()
    ]
    boxes += [axes.get_window_extent() for axes in figure.axes]
    for number, box in enumerate(boxes):
        assert page.x0 <= box.x0 <= box.x1 <= page.x1
        assert page.y0 <= box.y0 <= box.y1 <= page.y1
        assert not any(box.overlaps(other) for other in boxes[number + 1 :])


def test_an_invalid_shot_is_no_trial() -> None:
    broad = hoopgen.Scatter(RELEASE | {"distance": 0.3, "height": 3.1}, {"height": 0.2})
    found = hoopgen.estimate(broad, hoopgen.NBA, shots=500)
    assert 0 < found.invalid < 500
    figure = plot_estimate(found)
    parts = bars(figure.axes[0])
    assert sum(map(sum, parts.values())) == pytest.approx(1.0, rel=1e-12, abs=0)
    said = " ".join(text.get_text() for text in figure.texts)
    assert f"500 shots, of them {found.invalid} invalid, which are no trials;" in said


def test_a_comparison_has_both_and_the_difference() -> None:
    found = hoopgen.compare(
        (player(), hoopgen.NBA), (player(backspin=0.0), hoopgen.NBA), shots=2000
    )
    above, below = plot_estimate(found).axes
    parts = {name: sum(widths) for name, widths in bars(above).items()}
    assert parts == pytest.approx(
        {"first": found.first.probability, "second": found.second.probability}, rel=1e-12, abs=0
    )
    assert bars(below) == {"difference": [found.difference]}
    assert whiskers(below) == {"difference": (found.low, found.high)}
    low, high = below.get_xlim()
    assert low == -high
    words = [text.get_text() for text in below.texts]
    assert words[0].startswith("−")
    assert not any("-" in word for word in words)
    said = " ".join(text.get_text() for text in plot_estimate(found).texts)
    assert "backspin 3 Hz" in said
    assert "second speed 7.17 m/s, elevation 52°, backspin 0 Hz" in said


def test_it_can_be_drawn_on_axes(found: Any) -> None:
    axes = Figure().subplots()
    assert plot_estimate(found, ax=axes, title="Mine") is axes
    assert list(bars(axes))[:2] == ["made", "missed"]
    with pytest.raises(TypeError, match="found: expected what estimate or compare return, got str"):
        plot_estimate("70%")  # type: ignore[call-overload]


# --------------------------------------------------------------------------------- a table of aims


@pytest.mark.slow
def test_bands_are_how_far_each_may_be_off() -> None:
    table = aim_table([5.0, 3.0, 4.0], height=2.0, entry=np.radians(45.0))
    figure = plot_aim(table, hoopgen.PAPER)
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert labels == [
        *("release speed (m/s)", "release angle (°)", "entry angle (°)"),
        *("speed off by (m/s)", "angle off by (°)", "direction off by (°)"),
    ]
    order = [1, 2, 0]
    for axes, name, size in zip(
        figure.axes[:2], ("speed", "elevation"), (1, np.pi / 180), strict=True
    ):
        (line,) = axes.lines
        assert line.get_xdata().tolist() == [3.0, 4.0, 5.0]
        np.testing.assert_allclose(line.get_ydata(), table[name][order] / size, rtol=1e-12, atol=0)
    for axes, name in zip(figure.axes[3:], ("speed", "elevation", "azimuth"), strict=True):
        aimed = table.get(name, np.zeros(3))
        size = 1.0 if name == "speed" else np.pi / 180
        low, high, _ = axes.lines
        for line, end in ((low, "low"), (high, "high")):
            wanted = (table[f"{end}_{name}"] - aimed)[order] / size
            np.testing.assert_allclose(line.get_ydata(), wanted, rtol=1e-9, atol=1e-12)
        assert any(isinstance(one, FillBetweenPolyCollection) for one in axes.collections)


def test_it_is_in_feet_where_those_are_shown() -> None:
    table = aim_table([3.0, 4.0], height=2.0)
    with use_units("us"):
        figure = plot_aim(table, hoopgen.PAPER, width=COLUMN)
    assert {axes.get_xlabel() for axes in figure.axes} == {"", "distance (ft)"}
    assert figure.axes[0].get_ylabel() == "release speed (mph)"
    axes = Figure().subplots()
    assert plot_aim(table, hoopgen.PAPER, ax=axes) is axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("distance (m)", "speed off by (m/s)")


def test_a_table_without_a_release_is_refused() -> None:
    table = aim_table([3.0, 4.0], height=2.0, speed=1.0)
    with pytest.raises(ValueError, match="table: expected a release from one distance at least"):
        plot_aim(table, hoopgen.PAPER)
    with pytest.raises(ValueError, match="expected that of aim_table; entry_angle missing"):
        plot_aim({n: c for n, c in table.items() if n != "entry_angle"}, hoopgen.PAPER)


# -------------------------------------------------------------------------------- the command line

WHERE = ["--height", "7ft", "--distance", "13.75ft"]
SHOTS = [*WHERE, "--speed", "7.17", "--elevation", "52deg", "--scatter", "speed=0.1"]
GOLF = ROOT / "examples" / "scenes" / "golf.toml"
PUTT = ["--scene", str(GOLF), "--position=-30cm,0,3cm", "--velocity", "1.2,0,0"]
COMMANDS = {
    "estimate": ["estimate", *SHOTS, "--shots", "200"],
    "estimate --versus": ["estimate", *SHOTS, "--versus", "backspin=3Hz", "--shots", "200"],
    "estimate --solve": ["estimate", *SHOTS, "--solve", "50%", "--shots", "2000"],
    "fan": ["fan", *SHOTS, "--shots", "50", "--paths", "9"],
    "landings": ["landings", *SHOTS, "--shots", "300"],
    "landings, rebounds": ["landings", *SHOTS, "--shots", "300", "--catching-height", "9ft"],
    "optimum": [
        *["optimum", *WHERE, "--over", "elevation=50deg:54deg", "--over", "aim=0:5cm"],
        *["--scatter", "speed=0.05", "--shots", "300"],
    ],
    "aim": ["aim", *WHERE],
    "aim, a table": ["aim", "--height", "7ft", "--distance", "3m,4m"],
}


@pytest.mark.sampled(1)
@pytest.mark.parametrize("command", COMMANDS)
def test_a_picture_is_drawn_and_what_is_said_stays(command: str, tmp_path: Path) -> None:
    out = tmp_path / "picture.svg"
    drawn = succeed(*COMMANDS[command], "--picture", str(out))
    assert out.read_text(encoding="utf-8").startswith("<?xml")
    assert drawn.stdout == run(*COMMANDS[command]).stdout


@pytest.mark.parametrize("command", COMMANDS)
def test_a_picture_nobody_writes_is_refused_before_the_work(command: str, tmp_path: Path) -> None:
    for name in ("picture.txt", "picture.gif"):  # a film is of one shot
        result = run(*COMMANDS[command], "--picture", str(tmp_path / name))
        assert result.exit_code == 2
        assert f"'{name}' ends in none of .png, .svg, .pdf" in result.stderr
        assert result.stdout == ""


def test_a_fan_says_how_its_shots_end() -> None:
    said = run("fan", *SHOTS, "--shots", "400", "--preset", "nba").stdout
    found = hoopgen.estimate(
        hoopgen.Scatter({**RELEASE, "backspin": 0.0}, {"speed": 0.1}),
        hoopgen.NBA,
        shots=400,
    )
    assert said.startswith(f"shots    400: {100 * found.probability:.1f}% made, ")
    assert "\nscene    NBA\nrelease  speed 7.17 m/s, elevation 52°, height" in said


def test_landings_say_how_far_misses_come_down() -> None:
    said = run("landings", *SHOTS, "--shots", "2000").stdout
    states = hoopgen.Scatter({**RELEASE, "backspin": 0.0}, {"speed": 0.1}).draw(0, 2000).states
    shots = hoopgen.simulate(states)
    floor = hoopgen.measure(states, shots, names=["floor_x", "floor_y"])
    away = np.hypot(floor["floor_x"], floor["floor_y"])[shots.outcome == hoopgen.Outcome.MISSED]
    match = re.search(
        r"^land     half of ([\d,]+) missed shots within ([\d.]+) m of the point below the ring's "
        r"centre, 90% within ([\d.]+) m$",
        said,
        re.MULTILINE,
    )
    assert match is not None
    assert int(match[1].replace(",", "")) == np.isfinite(away).sum()
    for share, text in ((0.5, match[2]), (0.9, match[3])):
        assert float(text) == pytest.approx(np.nanquantile(away, share), abs=6e-4, rel=0)


@pytest.mark.slow
def test_rebounds_are_said_as_an_estimate_says_them(tmp_path: Path) -> None:
    out = tmp_path / "rebounds.svg"
    caught = [*SHOTS, "--shots", "2000", "--catching-height", "9ft", "--units", "us"]
    said = run("landings", *caught, "--picture", str(out)).stdout
    names = ("rebound_distance", "rebound_time", "rebound_angle")
    measured = [part for name in names for part in ("--measure", name)]
    found = run("estimate", *caught, *measured).stdout
    words = found[found.index("\nmeasure") : found.index("\nscene")]
    assert words.rstrip().endswith("rebounds are caught at 9 ft above the floor")
    assert words in said
    assert "land  " not in said
    drawn = out.read_text(encoding="utf-8")
    assert "come down there (% per ft" in drawn


def test_rebounds_at_no_height_are_refused_before_the_work() -> None:
    result = run("landings", *SHOTS, "--shots", "1e9", "--catching-height", "0m")
    assert result.exit_code == 2
    assert "--catching-height: expected m above the floor, more than 0" in result.stderr


@pytest.mark.parametrize("caught", [(), ("--catching-height", "2.5m")])
def test_landings_without_a_miss_say_so_and_are_an_empty_picture(
    caught: tuple[str, ...], tmp_path: Path
) -> None:
    sure = ["landings", *WHERE, "--aim", "0", "--elevation", "55deg", "--shots", "5", *caught]
    result = succeed(*sure, "--picture", str(tmp_path / "none.svg"))
    words = "no rebounds" if caught else "land     no shot was missed"
    assert f"\n{words}\n" in result.stdout
    assert (tmp_path / "none.svg").stat().st_size > 5_000


@pytest.mark.parametrize("own", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_a_fan_in_json_is_what_is_said_of_it(own: bool) -> None:
    asked = ["fan", *(PUTT if own else SHOTS), "--shots", "200", "--seed", "3"]
    asked += ["--scatter", "vy=0.05"] if own else []
    told, said = json.loads(run(*asked, "--json").stdout), run(*asked).stdout
    estimate = json.loads(run("estimate", *asked[1:], "--json").stdout)
    for name in ("shots", "seed", "uncertain", "uncertain_capped", "setting", "scene"):
        assert told[name] == estimate[name]
    counts = estimate["counts"] if own else {n: estimate[n] for n in told["counts"]}
    assert told["counts"] == counts
    assert sum(counts.values()) == 200
    for name, count in counts.items():
        assert (f"{count / 2:.1f}% {name}" in said) == bool(count)


def test_landings_in_json_are_what_is_said_of_them() -> None:
    asked = ["landings", *SHOTS, "--shots", "2000"]
    told, said = json.loads(run(*asked, "--json").stdout), run(*asked).stdout
    found = told["landings"]
    assert found["unit"] == "m"
    half, most = (found["quantiles"][share]["value"] for share in ("0.5", "0.9"))
    words = f"half of {found['shots']:,} missed shots within {half:.4g} m"
    assert words in said
    assert f"90% within {most:.4g} m" in said
    assert told["counts"]["missed"] >= found["shots"] > 0
    sure = ["landings", *WHERE, "--aim", "0", "--elevation", "55deg", "--shots", "5", "--json"]
    assert json.loads(run(*sure).stdout)["landings"] == {"unit": "m", "shots": 0, "quantiles": {}}


def test_rebounds_in_json_are_those_of_an_estimate() -> None:
    caught = [*SHOTS, "--shots", "2000", "--catching-height", "9ft", "--json"]
    measured = ["rebound_distance", "rebound_time", "rebound_angle"]
    asked = [part for name in measured for part in ("--measure", name)]
    wanted = json.loads(run("estimate", *caught, *asked).stdout)["measured"]
    told = json.loads(run("landings", *caught).stdout)
    assert told["measured"] == wanted
    assert list(wanted) == measured
    assert "landings" not in told


@pytest.mark.slow
def test_landings_are_a_hoops_and_paths_any_scenes(tmp_path: Path) -> None:
    result = run("landings", *PUTT, "--scatter", "vx=0.1")
    assert result.exit_code == 2
    assert "its question is a hoop's, and the scene golf has none" in result.stderr
    out = tmp_path / "putts.svg"
    result = succeed("fan", *PUTT, "--scatter", "vy=0.05", "--shots", "20", "--picture", str(out))
    assert result.stdout.startswith("shots    20: 100.0% holed")
    assert out.exists()


def test_a_picture_of_misses_says_the_scene_that_they_were_thrown_in(tmp_path: Path) -> None:
    out = tmp_path / "misses.svg"
    told = ["landings", *SHOTS, "--shots", "300", "--scene", "court", "--preset", "fiba"]
    assert "\nscene    court, FIBA\n" in run(*told, "--picture", str(out)).stdout
    floor = plot_landings([1.0], [0.5], hoopgen.FIBA_COURT, scene=hoopgen.COURT)
    assert "Scene: court, FIBA." in " ".join(text.get_text() for text in floor.texts)


def test_measured_releases_are_a_fan_too(tmp_path: Path) -> None:
    table = tmp_path / "releases.csv"
    table.write_text("speed_m_s,elevation_deg\n7.1,52\n7.2,51\n7.15,52.5\n")
    result = succeed("fan", "--from", str(table), *WHERE, "--preset", "nba", "--shots", "30")
    assert "measured: " in result.stdout


# A table of 12 releases, from two players: they scatter less than 200 shots of them would say.
MEASURED = np.random.default_rng(8).normal((7.17, 52.0), (0.12, 1.5), (12, 2))


@pytest.fixture
def measured(tmp_path: Path) -> Path:
    table = tmp_path / "releases.csv"
    lines = [f"{'AB'[row % 2]},{v},{angle}" for row, (v, angle) in enumerate(MEASURED.tolist())]
    table.write_text("\n".join(["player,speed_m_s,elevation_deg", *lines]) + "\n")
    return table


def wilson(made: int, shots: int) -> str:
    """Return Wilson's interval as it is printed."""
    z = 1.959963984540054
    middle, half = (made + z * z / 2) / (shots + z * z), z / (shots + z * z)
    half *= np.sqrt(made * (shots - made) / shots + z * z / 4)
    return f"{100 * (middle - half):.1f}% to {100 * (middle + half):.1f}%"


@pytest.mark.parametrize("command", ["fan", "landings"])
def test_samples_of_shots_say_the_intervals_of_their_shares(command: str, tmp_path: Path) -> None:
    asked = [command, *SHOTS, "--shots", "400"]
    out = tmp_path / "picture.svg"
    said, record = run(*asked).stdout, json.loads(run(*asked, "--json").stdout)
    made, missed = (record["counts"][name] for name in ("made", "missed"))
    ends = f"made {wilson(made, 400)}, missed {wilson(missed, 400)}"
    assert f"\ninterval {ends} (Wilson's 95% intervals)\n" in said
    assert "\nsample" not in said
    assert "sample" not in record
    low, high = (f"{100 * record[end]['made']:.1f}%" for end in ("low", "high"))
    assert wilson(made, 400) == f"{low} to {high}"
    assert record["shares"]["made"] == made / 400
    assert record["confidence"] == 0.95
    assert f"95% intervals: {ends}. Release:" in note_of(*asked, "--picture", str(out))


def note_of(*words: str) -> str:
    """Return what the note of a picture says that a command draws."""
    with pytest.MonkeyPatch.context() as patch:
        drawn: list[Any] = []
        patch.setattr(hoopgen.plots, "save", lambda figure, _: drawn.append(figure))
        succeed(*words)
    return " ".join(text.get_text() for text in drawn[0].texts).replace("\N{NO-BREAK SPACE}", " ")


@pytest.mark.parametrize("command", ["fan", "landings"])
@pytest.mark.parametrize("grouped", [(), ("--group", "player")])
def test_samples_of_measured_releases_say_how_many_there_are(
    command: str, grouped: tuple[str, ...], measured: Path, tmp_path: Path
) -> None:
    """The interval of the sample is that of 12 throws, however many shots are drawn of them."""
    asked = [command, "--from", str(measured), *WHERE, "--shots", "2000", *grouped]
    said, record = run(*asked).stdout, json.loads(run(*asked, "--json").stdout)
    release = hoopgen.release(
        MEASURED[:, 0], np.radians(MEASURED[:, 1]), height=2.1336, distance=4.191
    )
    made = int(hoopgen.simulate(release).made.sum())
    assert 0 < made < 12
    sample, words = record["sample"]["made"], "12 measured releases"
    assert (sample["value"], sample["rows"]) == (made / 12, 12)
    ends = f"{100 * sample['low']:.1f}% to {100 * sample['high']:.1f}%"
    if grouped:
        words = f"{words} in 2 groups"
        assert sample["groups"] == 2
    else:
        assert ends == wilson(made, 12)
    assert "Wilson's 95% intervals of the simulation alone" in said
    assert f"\nsample   made {ends}, missed " in said
    assert f"(95% intervals of the sample, {words})\n" in said
    note = note_of(*asked, "--picture", str(tmp_path / "picture.svg"))
    assert f"of the sample, {words}: made {ends}" in note


def test_a_fan_of_a_fitted_player_says_the_interval_of_the_sample(measured: Path) -> None:
    """The interval is that of `estimate` for as many shots."""
    asked = ["--from", str(measured), *WHERE, "--shots", "500", "--fitted", "--json"]
    found = json.loads(run("fan", *asked).stdout)["sample"]
    assert found == {"made": json.loads(run("estimate", *asked).stdout)["sample"]}


def test_distances_of_landings_have_intervals(measured: Path, tmp_path: Path) -> None:
    """Intervals of the shots are by their ranks, those of the sample by the ranks of its misses."""
    asked = ["landings", *SHOTS, "--shots", "2000"]
    found = json.loads(run(*asked, "--json").stdout)["landings"]
    states = hoopgen.Scatter({**RELEASE, "backspin": 0.0}, {"speed": 0.1}).draw(0, 2000).states
    shots = hoopgen.simulate(states)
    floor = hoopgen.measure(states, shots, names=["floor_x", "floor_y"])
    away = np.sort(np.hypot(*floor.values())[shots.outcome == hoopgen.Outcome.MISSED])
    for share, level in (("0.5", 0.5), ("0.9", 0.9)):
        half = 1.96 * np.sqrt(level * (1 - level) * len(away))
        for end, rank in (("low", level * len(away) - half), ("high", level * len(away) + half)):
            near = away[int(rank) - 3], away[int(rank) + 3]
            assert near[0] <= found["quantiles"][share][end] <= near[1]
    said = run(*asked).stdout
    low, high = (found["quantiles"]["0.5"][end] for end in ("low", "high"))
    words = f"95% intervals of these distances: 50% within {low:#.4g} to {high:#.4g} m, 90% within"
    assert words in said
    asked = ["landings", "--from", str(measured), *WHERE, "--shots", "2000"]
    found = json.loads(run(*asked, "--json").stdout)["landings"]
    release = hoopgen.release(
        MEASURED[:, 0], np.radians(MEASURED[:, 1]), height=2.1336, distance=4.191
    )
    shots = hoopgen.simulate(release)
    floor = hoopgen.measure(release, shots, names=["floor_x", "floor_y"])
    away = np.hypot(*floor.values())[shots.outcome == hoopgen.Outcome.MISSED]
    ends = found["sample"]["0.5"].values()
    assert all(end in ("inf", "-inf") or np.abs(away - end).min() < 1e-12 for end in ends)
    assert "of the sample: 50% within" in run(*asked).stdout
    note = note_of(*asked, "--picture", str(tmp_path / "picture.svg"))
    assert re.search(r"(\d m|or more)\. 95% intervals of the simulation alone: made", note)


def test_without_a_valid_shot_there_is_no_interval(tmp_path: Path) -> None:
    """No speed brings a ball that is thrown downwards to the ring."""
    asked = ["landings", *WHERE, "--aim", "0", "--elevation=-20deg", "--scatter", "elevation=1deg"]
    asked += ["--shots", "5"]
    said = run(*asked).stdout
    assert said.startswith("shots    5: 5 invalid\nland  ")
    assert "interval" not in said
    note = note_of(*asked, "--picture", str(tmp_path / "picture.svg"))
    assert "5 of 5 shots invalid. Release:" in note
