"""Results carry their scene, are flown in it, and whatever is shown says it."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner, Result

import hoopgen
from hoopgen.cli import main

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")
pytest.importorskip("xarray")

from hoopgen.hoop.presets import NAMES, PRESETS  # noqa: E402
from hoopgen.report.provenance import describe_dataset, describe_hoop, describe_scatter  # noqa: E402
from hoopgen.study.named_units import parameters_named  # noqa: E402
from hoopgen.viewer.row_sample import sample  # noqa: E402

SCENE = hoopgen.NBA | {"restitution": 0.75}
SAID = "NBA, restitution 0.75"
IN_SCENE = ("--preset", "nba", "--set", "restitution=0.75")
PLACE = ("--height", "7ft", "--distance", "13.75ft")
SCATTER = ("--scatter", "speed=0.07", "--scatter", "elevation=1.3deg")
SHOT = ("--aim", "5cm", "--elevation", "52deg", "--backspin", "3Hz", *PLACE)
ERRORS = {"speed": 0.07, "elevation": 0.0227, "azimuth": 0.0175}
FREE_THROW = {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi}
ROWS = 300


def run(*arguments: object) -> Result:
    result = CliRunner().invoke(main, [str(word) for word in arguments])
    assert result.exit_code == 0, result.output
    return result


def failure(*arguments: object) -> str:
    result = CliRunner().invoke(main, [str(word) for word in arguments])
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1
    return result.stderr


def read(file: Path) -> Any:
    return pq.ParquetFile(file).read()


@pytest.fixture
def releases(tmp_path: Path) -> Path:
    """Releases, without the place; many of them go in by a hair, in one hoop and not in another."""
    random = np.random.default_rng(3)
    file = tmp_path / "releases.csv"
    lines = [
        f"{speed},{elevation}"
        for speed, elevation in zip(
            random.normal(7.17, 0.1, ROWS), random.normal(0.9, 0.03, ROWS), strict=True
        )
    ]
    file.write_text("\n".join(["speed,elevation_rad", *lines, ""]), encoding="utf-8")
    return file


@pytest.fixture
def results(releases: Path, tmp_path: Path) -> Path:
    """Return the file of their results in a scene of their own."""
    out = tmp_path / "results.parquet"
    place = ("--release", "height=7ft", "--release", "distance=13.75ft", "--max-contacts", "7")
    text = run("batch", releases, "--out", out, *place, *IN_SCENE).stdout
    assert text.endswith(f"\nscene: {SAID}\n")
    return out


def in_arrow(results: Path) -> Path:
    file = results.with_suffix(".feather")
    table = read(results)
    with pa.ipc.new_file(file, table.schema) as out:
        out.write_table(table)
    return file


def data_of(page: Path) -> Any:
    found = re.search(r'id="data">(.*?)</script>', page.read_text("utf-8"))
    assert found
    return json.loads(found[1])


# In words


@pytest.mark.parametrize(
    ("parameters", "said"),
    [
        (hoopgen.PAPER, "PAPER (the article's)"),
        (dict(hoopgen.FIBA), "FIBA"),
        (SCENE, SAID),
        ({"restitution": 0.7, "ring_radius": hoopgen.FIBA["ring_radius"]}, "FIBA"),
        (hoopgen.NBA | {"gravity": 9.810000001}, "NBA, gravity 9.810000001 m/s²"),
        (
            hoopgen.FIBA | {"ball_radius": np.array([0.12, 0.11])},
            "FIBA, ball radius 0.11 to 0.12 m",
        ),
        (hoopgen.NBA | {"restitution": np.full(3, 0.7)}, "NBA"),
        (
            hoopgen.PAPER | {"restitution": 0.8, "gravity": 1.62},
            "PAPER (the article's), restitution 0.8, gravity 1.62 m/s²",
        ),
    ],
)
def test_a_scene_is_its_nearest_preset_and_what_differs(parameters: Any, said: str) -> None:
    assert sorted(describe_hoop(parameters).split(", ")) == sorted(said.split(", "))
    assert describe_hoop(parameters).startswith(said.split(",")[0])


def test_a_scene_says_what_is_each_row_s_own() -> None:
    assert describe_hoop(SCENE, ["restitution", "speed"]) == "NBA, restitution by row"
    assert describe_hoop(SCENE, NAMES) == "each row's own"


def test_presets_differ_so_that_each_is_the_nearest_to_itself() -> None:
    for name, preset in PRESETS.items():
        assert describe_hoop(preset).startswith(name.upper())


def test_scatter_says_correlations_of_what_scatters() -> None:
    pairs = [(("speed", "elevation"), -0.3), (("speed", "backspin"), 0.5)]
    said = describe_scatter({"speed": 0.07, "elevation": np.radians(1.3), "backspin": 0.0}, pairs)
    assert said == "speed 0.07 m/s, elevation 1.3°; correlation of speed and elevation −0.3"


# Files


@pytest.mark.parametrize("form", [lambda file: file, in_arrow], ids=["parquet", "arrow"])
def test_results_are_viewed_in_their_own_hoop(form: Any, results: Path, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    result = run("view", form(results), "--out", page, "--sample", ROWS)
    assert result.stderr == ""
    assert f"; scene {SAID}" in result.stdout
    data = data_of(page)
    assert data["parameters"] == dict(SCENE)
    assert data["about"].endswith(f"; scene {SAID}")
    shown = {shot["label"]: shot["outcome"] for shot in data["shots"]}
    wanted = read(results)["outcome"].to_pylist()
    assert shown == {f"Row {row}": outcome for row, outcome in enumerate(wanted, 1)}


def test_the_article_s_hoop_would_contradict_them(results: Path, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    run("view", results, "--out", page, "--sample", ROWS, "--preset", "paper", "--override")
    data = data_of(page)
    assert data["parameters"] == dict(hoopgen.PAPER)
    there = read(results)["outcome"].to_pylist()
    assert [shot["outcome"] for shot in data["shots"]] != there


def test_a_file_is_viewed_in_python(results: Path, tmp_path: Path) -> None:
    page = hoopgen.view(results, path=tmp_path / "page.html")
    assert page.about == f"50 of {ROWS} rows of results.parquet, chosen at random (seed 0); " + (
        f"scene {SAID}"
    )
    assert data_of(tmp_path / "page.html")["parameters"] == dict(SCENE)
    with pytest.raises(ValueError, match="got PAPER"):
        hoopgen.view(str(results), hoopgen.PAPER)
    with pytest.raises(ValueError, match="about: of a file it is which rows"):
        hoopgen.view(results, about="mine")


def test_results_are_flown_again_as_they_were(results: Path, tmp_path: Path) -> None:
    out = tmp_path / "again.parquet"
    result = run("batch", results, "--out", out, "--prefix", "again_")
    assert result.stderr == ""
    table = read(out)
    for name in ("outcome", "contacts", "end_x_m"):
        one, other = (table[prefix + name].to_pandas() for prefix in ("", "again_"))
        assert one.equals(other)
    ours, theirs = (json.loads(read(file).schema.metadata[b"hoopgen"]) for file in (results, out))
    assert theirs.pop("results") == [
        *(names := ours.pop("results")),
        *(f"again_{name}" for name in names),
    ]
    assert ours == theirs
    assert ours["scene"] == SAID
    assert ours["preset"] == "nba"
    assert ours["parameters"] == dict(SCENE)
    assert ours["max_contacts"] == 7
    assert ours["version"] == hoopgen.__version__


def test_an_estimate_draws_from_results_in_their_scene(results: Path) -> None:
    options = ("--shots", "500", "--json")
    result = run("estimate", "--from", results, *options)
    assert "assumed; --preset" not in result.stderr
    assert "\nread: speed as speed in m/s, elevation_rad as elevation in rad\n" in result.stderr
    found = json.loads(result.stdout)
    assert found["scene"] == SAID
    assert parameters_named(found["setting"]["parameters"]) == dict(SCENE)
    drawn = sample(results, ROWS).releases
    wanted = hoopgen.simulate(drawn.states, SCENE, max_contacts=7).made.mean()
    assert abs(found["probability"] - wanted) < 5 * 0.5 / np.sqrt(500)
    changed = json.loads(run("estimate", "--from", results, *options, *IN_SCENE).stdout)
    assert changed == found  # the options say the same


MEASURED = {
    "map": ("map", "--over", "distance=4m,4.2m", "--shots", "100"),
    "optimum": ("optimum", "--over", "elevation=50deg:55deg", "--shots", "200"),
}


@pytest.mark.slow
@pytest.mark.parametrize("command", MEASURED)
def test_a_map_and_a_search_draw_from_results_in_their_scene(command: str, results: Path) -> None:
    result = run(*MEASURED[command], "--from", results)
    assert result.stderr == ""
    assert f"\nscene    {SAID}\nrelease  measured: " in result.stdout
    assert result.stdout == run(*MEASURED[command], "--from", results, *IN_SCENE).stdout
    assert "got FIBA" in failure(*MEASURED[command], "--from", results, "--preset", "fiba")
    changed = run(*MEASURED[command], "--from", results, "--preset", "fiba", "--override").stdout
    assert "\nscene    FIBA\n" in changed
    assert "there is no file" in failure(*MEASURED[command], "--override")


def test_a_map_of_results_has_their_contacts(results: Path, tmp_path: Path) -> None:
    file = tmp_path / "map.csv"
    run(*MEASURED["map"], "--from", results, "--out", file)
    with file.open(encoding="utf-8", newline="") as rows:
        assert {row["max_contacts"] for row in csv.DictReader(rows)} == {"7"}


def test_measured_scenes_are_said_to_be() -> None:
    columns = {**FREE_THROW, "aim": 0.05, "elevation": [0.9, 0.91], "restitution": [0.6, 0.7]}
    player = hoopgen.Resample(columns)
    mapped = hoopgen.map(player, {"distance": [4.0, 4.2]}, hoopgen.NBA, shots=50)
    assert mapped.attrs["scene"] == "NBA, restitution by row"
    assert describe_dataset(mapped)["scene"] == "NBA, restitution by row"
    assert describe_dataset(mapped)["release"].startswith(
        "measured: height, distance, backspin, aim"
    )
    both = hoopgen.bank_or_direct(player, [[2.0, 2.0]], hoopgen.NBA, over=["azimuth"], shots=50)
    assert describe_dataset(both)["scene"] == "NBA, restitution by row"


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--preset", "nba"), f"parameters (--preset, --set): expected {SAID}, got NBA;"),
        (("--set", "restitution=0.8"), f"expected {SAID}, got NBA, restitution 0.8;"),
        (("--max-contacts", "40"), "max_contacts: expected 7, got 40;"),
        (("--release", "height=8ft"), "height: expected 2.1336, got 2.4384;"),
        (("--release", "speed=7"), "speed: expected that of each row, got 7.0;"),
    ],
)
def test_options_that_contradict_results_are_refused(
    options: tuple[str, ...], said: str, results: Path, tmp_path: Path
) -> None:
    page = tmp_path / "page.html"
    text = failure("view", results, "--out", page, *options)
    assert f"{results}: its shots have other values than are given: " in text
    assert said in text
    assert "--override" in text
    assert not page.exists()
    run("view", results, "--out", page, *options, "--override")
    again = failure("batch", results, "--out", tmp_path / "o.parquet", "--prefix", "a", *options)
    assert said in again
    if options[0] != "--release":
        assert said in failure("estimate", "--from", results, *options)


def test_without_a_file_there_is_nothing_to_override() -> None:
    assert "there is no file" in failure("estimate", *SHOT, *SCATTER, "--override")


def test_a_setting_alone_changes_the_file_s_scene(results: Path, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    run("view", results, "--out", page, "--set", "gravity=9.8", "--override")
    assert data_of(page)["parameters"] == dict(SCENE | {"gravity": 9.8})


def test_options_that_say_what_the_file_says_are_none(results: Path, tmp_path: Path) -> None:
    same = ("--release", "height=7ft", "--max-contacts", "7", *IN_SCENE)
    assert SAID in run("view", results, "--out", tmp_path / "page.html", *same).stdout


def test_a_batch_in_python_refuses_and_overrides(results: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.parquet"
    with pytest.raises(ValueError, match="got FIBA"):
        hoopgen.batch(results, out, parameters=hoopgen.FIBA, prefix="a_")
    done = hoopgen.batch(results, out, parameters=hoopgen.FIBA, prefix="a_", override=True)
    assert done.scene == "FIBA"
    assert "FIBA" in done._repr_html_()


def test_a_file_without_a_scene_is_flown_in_one_that_is_said(
    releases: Path, tmp_path: Path
) -> None:
    place = ("--release", "height=7ft", "--release", "distance=13.75ft")
    page = tmp_path / "page.html"
    line = "hoopgen: releases.csv names no scene: PAPER (the article's) is assumed; --preset "
    said = run("view", releases, "--out", page, *place).stderr
    assert said == f"{line}names another\n"
    assert run("batch", releases, "--out", tmp_path / "o.parquet", *place).stderr == said
    assert run("estimate", "--from", releases, *PLACE, "--shots", "100").stderr == said
    set_one = run("view", releases, "--out", page, *place, "--set", "restitution=0.75").stderr
    assert "PAPER (the article's), restitution 0.75 is assumed" in set_one
    for preset in PRESETS:
        assert run("view", releases, "--out", page, *place, "--preset", preset).stderr == ""


def test_own_columns_remain_own_in_results(tmp_path: Path) -> None:
    source, out = tmp_path / "t.parquet", tmp_path / "o.parquet"
    place = {"height": [2.1], "distance": [4.2]}
    table = {"speed": [7.0], "elevation_rad": [0.9], **place, "aim": [9.0]}
    pq.write_table(pa.table(table), source)
    hoopgen.batch(source, out, own=["aim"])
    wanted = hoopgen.release(7.0, 0.9, height=2.1, distance=4.2)
    assert sample(out, 1).releases.states.tolist() == [wanted.tolist()]


@pytest.mark.parametrize("text", [b"{", b"[]", b'{"parameters": {}}', b"\xff"])
def test_a_scene_that_cannot_be_understood_is_told(
    text: bytes, results: Path, tmp_path: Path
) -> None:
    table = read(results)
    file = tmp_path / "bad.parquet"
    pq.write_table(table.replace_schema_metadata({b"hoopgen": text}), file)
    assert "cannot be understood" in failure("view", file, "--out", tmp_path / "page.html")


@pytest.mark.slow
@pytest.mark.parametrize("command", ["map", "aim"])
def test_csv_has_its_scene_in_columns(command: str, tmp_path: Path) -> None:
    file, out = tmp_path / "table.csv", tmp_path / "out.parquet"
    if command == "map":
        over = ("--over", "elevation=45deg:60deg:6", "--over", "speed=6.8:7.6:9")
        run("map", *over, *PLACE, *IN_SCENE, "--out", file)
    else:
        run("aim", "--distance", "3m:5m:1m", "--height", "7ft", *IN_SCENE, "--csv", file)
    result = run("batch", file, "--out", out, "--prefix", "flown_")
    assert result.stderr == ""
    assert result.stdout.endswith("\nscene: each row's own\n")
    table = read(out)
    if command == "map":
        assert table["flown_outcome"].to_pylist() == table["outcome"].to_pylist()
    drawn = sample(file, 1).releases.parameters
    assert {name: value.tolist() for name, value in drawn.items()} == {
        name: [value] for name, value in SCENE.items()
    }
    assert "columns of " in failure("batch", file, "--out", out, "--preset", "nba")
    assert "--own gravity" in failure("batch", file, "--out", out, "--set", "gravity=9.8")


def test_csv_of_a_map_says_scatter_and_seed(tmp_path: Path) -> None:
    file = tmp_path / "map.csv"
    options = ("--correlation", "speed,elevation=-0.3", "--shots", "20", "--seed", "5")
    over = ("--over", "aim=0,5cm", "--elevation", "52deg")
    run("map", *over, *PLACE, *SCATTER, *options, *IN_SCENE, "--out", file)
    with file.open(encoding="utf-8", newline="") as rows:
        (first, _) = csv.DictReader(rows)
    assert float(first["sd_speed"]) == 0.07
    assert float(first["correlation_speed_elevation"]) == -0.3
    assert first["seed"] == "5"
    assert first["source"] == f"hoopgen {hoopgen.__version__}"


# What is printed


FEW = ("--shots", "200")
PRINTED = {
    "shot": ("shot", "--speed", "7.17", "--elevation", "52deg", *PLACE),
    "certify": ("certify", "--speed", "7.17", "--elevation", "52deg", *PLACE),
    "estimate": ("estimate", *SHOT, *SCATTER, *FEW),
    "compare": ("estimate", *SHOT, *SCATTER, *FEW, "--versus", "backspin=0Hz"),
    "solve": ("estimate", *SHOT, *SCATTER, *FEW, "--solve", "60%"),
    "outcomes": ("map", "--over", "elevation=45deg:60deg:3", "--aim", "5cm", *PLACE),
    "map": ("map", "--over", "elevation=45deg:60deg:3", "--aim", "5cm", *PLACE, *SCATTER, *FEW),
    "optimum": ("optimum", "--over", "elevation", "--aim", "5cm", *PLACE, *SCATTER, *FEW),
    "aim": ("aim", "--distance", "4m", "--height", "7ft"),
    "bank": ("bank", *PLACE, *SCATTER, *FEW),
    "banks": ("bank", "--places", "distance=3m,4m", "--height", "7ft", *SCATTER, *FEW),
    "aims": ("aim", "--distance", "4m,5m", "--height", "7ft"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", PRINTED)
def test_what_is_printed_says_its_scene(name: str) -> None:
    arguments = PRINTED[name]
    if name == "certify":
        pytest.importorskip("flint")
    lines = run(*arguments, *IN_SCENE).stdout.splitlines()
    assert [line.split(None, 1)[1] for line in lines if line.startswith("scene ")] == [SAID]
    plain = run(*arguments).stdout
    assert "PAPER (the article's)" in plain
    if "--scatter" in arguments and name != "solve":  # which says the scaled one
        assert "speed 0.07 m/s, elevation 1.3°" in plain
        assert any(line.split() == ["seed", "0"] for line in plain.splitlines())
    if arguments[0] in ("shot", "certify", "estimate", "optimum"):
        record = json.loads(run(*arguments, *IN_SCENE, "--json").stdout)
        within = {"compare": "first", "solve": "estimate"}.get(name)
        assert (record[within] if within else record)["scene"] == SAID


def test_a_comparison_says_what_is_not_the_same() -> None:
    lines = run(*PRINTED["compare"], "--versus", "restitution=0.6", *IN_SCENE).stdout.splitlines()
    at = lines.index(f"scene       first: {SAID}")
    assert lines[at + 1] == "            second: NBA, restitution 0.6"
    assert lines[at + 2].startswith("release     first: ")
    assert sum(line.startswith("scatter ") for line in lines) == 1


def test_the_article_s_shots_say_their_scene() -> None:
    assert "\nScene: PAPER (the article's); releases: Table 3\n" in run("paper").stdout


def test_results_in_python_say_their_scene() -> None:
    scatter = hoopgen.Scatter({**FREE_THROW, "aim": 0.05, "elevation": 0.9}, ERRORS)
    assert f"scene    {SAID}" in str(hoopgen.estimate(scatter, SCENE, shots=200))
    drawn = scatter.draw(0, 20, 0, SCENE)
    shots = hoopgen.simulate(drawn.states, drawn.parameters)
    assert repr(shots).endswith(f"; {SAID})")
    assert SAID in shots._repr_html_()
    assert shots.to_xarray().attrs["scene"] == SAID
    still = hoopgen.Scatter({**FREE_THROW, "elevation": 0.9})
    mapped = hoopgen.map(still, {"aim": [0.0, 0.05]}, SCENE)
    assert mapped.attrs["scene"] == SAID
    margins = hoopgen.margins(scatter, SCENE, names=["speed"], shots=100)
    assert str(margins["speed"]).endswith(f"; {SAID}")


def test_measured_parameters_are_each_row_s_own() -> None:
    columns = {**FREE_THROW, "aim": 0.05, "elevation": [0.9, 0.91], "restitution": [0.6, 0.7]}
    text = str(hoopgen.estimate(hoopgen.Resample(columns), hoopgen.NBA, shots=50))
    assert "scene    NBA, restitution by row\n" in text
    assert "release  measured: height, distance, backspin, aim, elevation, restitution (" in text


# Pictures


def words(figure: Any) -> str:
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    return " ".join([*(text.get_text() for text in figure.texts), *titles]).replace("\n", " ")


def thrown(azimuth: float = 0.0, angle: float = 0.0) -> hoopgen.Shots:
    speed = np.linspace(7.0, 7.3, 20)
    states = hoopgen.release(speed, 0.9, azimuth, height=2.1336, distance=4.191, angle=angle)
    return hoopgen.simulate(states, SCENE, record=True)


@pytest.mark.slow
def test_pictures_of_shots_say_their_scene() -> None:
    plots = pytest.importorskip("hoopgen.plots")
    pyplot = pytest.importorskip("matplotlib.pyplot")
    shots = thrown()
    assert f"Scene: {SAID}." in words(shots.plot(note="Seed: 3."))
    assert "Seed: 3." in words(shots.plot(note="Seed: 3."))
    floor = plots.plot_landings([1.0, 2.0], [0.5, 0.1], SCENE, note="Seed: 3.")
    assert f" Scene: {SAID}. Seed: 3." in words(floor)
    assert f"Scene: {SAID}." in words(shots.trajectory(0).plot())
    figure, axes = pyplot.subplots(layout="constrained")
    try:
        shots.trajectory(0).plot(ax=axes)
        assert f"Scene: {SAID}." in words(figure)
    finally:
        pyplot.close(figure)


@pytest.mark.sampled(1)
@pytest.mark.parametrize("angle", [0.0, 1.0, -2.0])
@pytest.mark.parametrize(
    ("azimuth", "said"),
    [(0.03, " up and 1.7° to the left"), (-0.03, " up and 1.7° to the right"), (0.0, " up, ")],
)
def test_a_picture_of_a_shot_says_its_azimuth(azimuth: float, said: str, angle: float) -> None:
    pytest.importorskip("matplotlib")
    text = words(thrown(azimuth, angle).trajectory(0).plot())
    assert said in text
    assert "; 4.191 m from the ring's centre, 2.134 m high." in text


def test_maps_say_scene_and_correlations() -> None:
    plots = pytest.importorskip("hoopgen.plots")
    release = {**FREE_THROW, "elevation": 0.9, "restitution": 0.75}
    over, correlation = {"aim": [0.0, 0.05, 0.1]}, {("speed", "elevation"): -0.3}
    player = hoopgen.Scatter(release, ERRORS, correlation)
    dataset = hoopgen.map(player, over, hoopgen.NBA, shots=50, seed=9)
    text = words(plots.plot_map(dataset))
    assert text.count("estitution") == 1
    for said in (f"Scene: {SAID}.", "correlation of speed and elevation −0.3", "seed 9."):
        assert said in text
    assert "Scene: NBA." in words(
        plots.plot_map(
            hoopgen.map(
                hoopgen.Scatter({**FREE_THROW, "aim": 0, "elevation": 0.9}),
                {"restitution": [0.6, 0.7]},
                hoopgen.NBA,
            )
        )
    )


@pytest.mark.slow
def test_bank_shots_say_what_they_rest_on() -> None:
    plots = pytest.importorskip("hoopgen.plots")
    release = {"height": 2.1336, "backspin": 6 * np.pi}
    player = hoopgen.Scatter(release, ERRORS, {("speed", "elevation"): -0.3})
    dataset = hoopgen.bank_or_direct(player, [[2.0, 2.0]], SCENE, shots=100, seed=4)
    assert dataset.attrs["scene"] == SAID
    text = words(plots.plot_aim_points(dataset, SCENE))
    for said in (f"Scene: {SAID}.", "height 2.1336 m", "correlation of speed", "Seed: 4."):
        assert said in text


# Studies


STUDY = """
[study]
name = "One"

[releases]
file = "results.parquet"
{scene}
[[question]]
kind = "estimate"
name = "made"
shots = 100
figures = []

[[question]]
kind = "batch"
name = "again"
file = "results.parquet"
prefix = "again_"
"""


@pytest.mark.parametrize(
    ("scene", "said"),
    [("", SAID), ('[scene]\npreset = "fiba"\n', "FIBA"), ("[scene]\nrestitution = 0.7\n", "NBA")],
)
def test_a_study_of_results_is_in_their_scene_or_its_own(
    scene: str, said: str, results: Path
) -> None:
    pytest.importorskip("pydantic")
    file = results.with_name("study.toml")
    file.write_text(STUDY.format(scene=scene), encoding="utf-8")
    answers = hoopgen.run_study(file)
    assert answers["made"].numbers["scene"] == said
    folder = results.with_name("study-results")
    assert (folder / "report.md").read_text("utf-8").count(f"\nScene: {said}.\n") == 2
    table = read(folder / "again" / "results.parquet")
    assert json.loads(table.schema.metadata[b"hoopgen"])["scene"] == said
    if not scene:
        assert table["again_outcome"].to_pylist() == table["outcome"].to_pylist()


def test_a_page_on_the_command_line_begins_in_the_units_asked_for(
    results: Path, tmp_path: Path
) -> None:
    for system in ("si", "us"):
        out = tmp_path / f"{system}.html"
        run("view", results, "--out", out, "--sample", 5, "--units", system)
        assert f'"system":"{system}"' in out.read_text("utf-8")
