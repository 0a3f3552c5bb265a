"""Studies of scenes of one's own: shares of ends over states and parameters, resumed and told."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.simulation.engine import Engine
from tests.helpers.commands import failure, output

pytest.importorskip("sympy")
pq = pytest.importorskip("pyarrow.parquet")
pytest.importorskip("xarray")
pytest.importorskip("pydantic")

from hoopgen import Resample, Scatter  # noqa: E402
from hoopgen.scene.lookup import variables_of  # noqa: E402
from hoopgen.study.statistics.intervals import wilson_interval  # noqa: E402
from hoopgen.studyfile import run_study  # noqa: E402
from hoopgen.studyfile.reading import StudyError  # noqa: E402

# One worker: what is compiled once serves them all.
pytestmark = pytest.mark.xdist_group("scene_studies")

LEDGE = """\
name = "ledge"
ball_radius = 0.05
gravity = "g"
restitution = "bounce"

[parameters]
reach = 1.0
bounce = { default = 0.6, unit = "1" }
g = { default = 9.81, unit = "m/s²" }

[bodies.floor]
kind = "plane"
within = ["x - reach"]

[ends.near]
at = -1
within = ["x - 1.3"]

[ends.beyond]
at = -1
"""
"""A floor that ends, and how far from it a ball falls."""

PLACE = {"x": 0.5, "y": 0.0, "z": 0.3, "vy": 0.0, "vz": 0.0}
STATE = {**PLACE, "vx": 1.0}
SD = {"vx": 0.2, "bounce": 0.05}
MODEL = Scatter(STATE, SD)
SHOTS = 600


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("scene") / "ledge.toml"
    path.write_text(LEDGE, encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def scene(file: Path) -> Engine:
    return hoopgen.compile(hoopgen.load_scene(file))


@pytest.fixture(scope="module")
def other(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    """The same numbers by another formula."""
    path = tmp_path_factory.mktemp("other") / "ledge.toml"
    path.write_text(
        LEDGE.replace('within = ["x - 1.3"]', 'within = ["x - 1.3*reach"]'), encoding="utf-8"
    )
    return hoopgen.compile(hoopgen.load_scene(path))


@pytest.mark.slow
def test_the_scatter_is_found_with_which_a_share_ends_somewhere(scene: Engine, file: Path) -> None:
    wanted = hoopgen.solve(MODEL, 0.3, scene=scene, by="beyond", shots=SHOTS)
    assert wanted.low < wanted.factor < wanted.high
    assert wanted.by == "beyond"
    assert abs(wanted.estimate.share_of("beyond") - 0.3) < 5 * np.sqrt(0.21 / SHOTS)
    given = ["--scene", file, "--position", "0.5,0,0.3", "--velocity", "1,0,0", "--shots", SHOTS]
    given += ["--scatter", "vx=0.2", "--scatter", "bounce=0.05"]
    text = output("estimate", *given, "--solve", "30%", "--by", "beyond")
    assert text.splitlines()[0] == f"factor   {wanted.line} (95% interval)"
    assert "is reached by no factor" in failure(
        "estimate", *given, "--solve", "99.9%", "--by", "beyond"
    )


@pytest.mark.slow
def test_an_estimate_has_the_share_of_each_end_with_its_interval(scene: Engine) -> None:
    found = hoopgen.estimate(MODEL, scene=scene, shots=SHOTS, seed=3)
    drawn = MODEL.draw(0, SHOTS, 3, scene.parameters)
    shots = scene.simulate(drawn.states, drawn.parameters)
    assert list(found.shares)[:2] == ["near", "beyond"]
    for name, code in (("near", 0), ("beyond", 1)):
        count = int((shots.outcome == code).sum())
        assert 0 < count < SHOTS
        assert found.counts[name] == count
        assert found.shares[name] == count / SHOTS
        assert (found.low[name], found.high[name]) == wilson_interval(count, SHOTS, 0.95)
    assert sum(found.counts.values()) == SHOTS
    assert "near" in str(found)
    assert "scene    ledge" in str(found)
    assert json.loads(json.dumps(found.as_dict()))["scene"] == "ledge"


@pytest.mark.slow
def test_the_precision_is_that_of_the_widest_interval(scene: Engine) -> None:
    found = hoopgen.estimate(MODEL, scene=scene, precision=0.01)
    assert found.half_width <= 0.01
    assert max(found.high[n] - found.low[n] for n in found.shares) == 2 * found.half_width


@pytest.mark.slow
def test_an_invalid_shot_is_no_trial(scene: Engine) -> None:
    found = hoopgen.estimate(Scatter({**STATE, "z": 0.06}, {"z": 0.05}), scene=scene, shots=SHOTS)
    assert 0 < found.counts["invalid"] < SHOTS
    assert "invalid" not in found.shares
    assert sum(found.shares.values()) == pytest.approx(1.0, abs=1e-12)


def test_what_a_parameter_draws_hangs_on_its_name_alone() -> None:
    alone = Scatter(STATE, {"bounce": 0.1}).noise(0, 50, 7)["bounce"]
    beside = Scatter(STATE, {"vx": 0.3, "bounce": 0.1, "reach": 1.0}).noise(0, 50, 7)
    assert np.array_equal(alone, beside["bounce"])
    assert len({tuple(column) for column in beside.values()}) == 3


@pytest.mark.slow
def test_a_resumed_estimate_is_the_same_and_an_altered_scene_is_refused(
    scene: Engine, other: Engine, tmp_path: Path
) -> None:
    options: dict[str, Any] = {"shots": SHOTS, "folder": tmp_path / "kept"}
    first = hoopgen.estimate(MODEL, scene=scene, **options)
    assert hoopgen.estimate(MODEL, scene=scene, **options) == first
    assert other.parameters == scene.parameters
    with pytest.raises(ValueError, match="holds") as refused:
        hoopgen.estimate(MODEL, scene=other, **options)
    assert "scene" in str(refused.value)


@pytest.mark.slow
def test_a_map_over_a_parameter_and_a_component_is_the_estimate_of_each_cell(
    scene: Engine,
) -> None:
    over = {"reach": [0.9, 1.1], "vx": [0.8, 1.0, 1.3]}
    dataset = hoopgen.map(Scatter(PLACE, SD), over, scene=scene, shots=SHOTS)
    assert dataset["share"].dims == ("reach", "vx", "ending")
    for reach in over["reach"]:
        for vx in over["vx"]:
            cell = dataset.sel(reach=reach, vx=vx)
            model = Scatter({**PLACE, "vx": vx, "reach": reach}, SD)
            found = hoopgen.estimate(model, scene=scene, shots=SHOTS)
            for name, share in found.shares.items():
                end = cell.sel(ending=name)
                assert end["share"] == share
                assert (end["low"], end["high"]) == (found.low[name], found.high[name])
    assert dataset["reach"].attrs["units"] == "m"
    assert dataset.attrs["scene_sha256"] == scene.identity["sha256"]


@pytest.mark.slow
def test_a_picture_of_a_map_names_the_components_of_a_state(scene: Engine) -> None:
    """In such a scene x is not a place on a court, and deviations have their units."""
    plots = pytest.importorskip("hoopgen.plots")
    there = {name: value for name, value in STATE.items() if name != "x"}
    dataset = hoopgen.map(Scatter(there, {"vx": 0.1}), {"x": [0.0, 0.1]}, scene=scene, shots=20)
    figure = plots.plot_map(dataset)
    said = " ".join(text.get_text() for text in figure.texts).replace("\n", " ")
    assert "Standard deviations: vx 0.1 m/s." in said
    assert "Scene: ledge. y 0 m" in said
    assert "place on the floor" not in said.lower()
    assert figure.axes[0].get_xlabel() == "x (m)"


def test_a_map_of_single_shots_has_their_outcomes(scene: Engine) -> None:
    vx = np.linspace(0.5, 2.0, 7)
    dataset = hoopgen.map(Scatter(PLACE), {"vx": vx}, scene=scene)
    states = np.zeros((7, 9))
    states[:, [0, 2]], states[:, 3] = (0.5, 0.3), vx
    assert np.array_equal(dataset["outcome"], scene.simulate(states).outcome)
    assert dataset["outcome"].attrs["flag_meanings"].split()[:2] == ["near", "beyond"]
    assert "kind" not in dataset


def test_a_map_is_drawn_for_one_of_its_ends(scene: Engine) -> None:
    plots = pytest.importorskip("hoopgen.plots")
    dataset = hoopgen.map(
        Scatter(PLACE, SD), {"vx": [0.8, 1.2], "reach": [0.9, 1.1]}, scene=scene, shots=50
    )
    texts = [axes.get_ylabel() for axes in plots.plot_map(dataset, of="beyond").axes]
    assert "shots beyond (%)" in texts
    with pytest.raises(ValueError, match="of: expected near or beyond"):
        plots.plot_map(dataset, of="made")


def test_a_map_of_single_shots_is_drawn_in_the_colours_of_its_ends(scene: Engine) -> None:
    plots = pytest.importorskip("hoopgen.plots")
    from matplotlib.collections import QuadMesh
    from matplotlib.colors import to_hex

    from hoopgen.core.colours import outcome_colours

    over = {"vx": [0.5, 1.0, 2.0], "z": [0.02, 0.3]}  # the ball has a radius of 0.05 m
    place = {name: value for name, value in PLACE.items() if name != "z"}
    dataset = hoopgen.map(Scatter(place), over, scene=scene)
    colour = outcome_colours(scene.outcomes.__members__, 2)
    wanted = [[scene.outcomes(code).name for code in row] for row in dataset["outcome"].values]
    assert {name for row in wanted for name in row} == {"NEAR", "BEYOND", "CAPPED", "INVALID"}
    figure = plots.plot_map(dataset)
    (mesh,) = figure.axes[0].findobj(lambda artist: type(artist) is QuadMesh)
    drawn, hidden = mesh.to_rgba(mesh.get_array()), np.ma.getmaskarray(mesh.get_array())
    for (up, across), nowhere in np.ndenumerate(hidden):
        name = wanted[across][up]
        assert nowhere == (name == "INVALID")
        if not nowhere:
            assert to_hex(drawn[up, across]) == colour[name].lower()
    (key,) = figure.legends
    shown = {
        text.get_text(): to_hex(patch.get_facecolor())
        for text, patch in zip(key.get_texts(), key.get_patches(), strict=True)
    }
    assert shown == {name: colour[name.upper()].lower() for name in ("near", "beyond", "capped")}
    # Over one variable, and on axes that there are, the same.
    axes = plots.plot_map(dataset.isel(z=1), ax=plots.plot_map(dataset.isel(z=1)).axes[0])
    assert {text.get_text() for text in axes.get_legend().get_texts()} == set(shown)
    with pytest.raises(ValueError, match="of: expected outcome for this dataset, got 'near'"):
        plots.plot_map(dataset, of="near")


def test_compare_counts_pairs_by_an_end(scene: Engine) -> None:
    found = hoopgen.compare(
        (MODEL, None), (MODEL, {"reach": 1.2}), scene=scene, by="beyond", shots=SHOTS
    )
    first, second = (
        hoopgen.estimate(MODEL, {"reach": reach}, scene=scene, shots=SHOTS) for reach in (1.0, 1.2)
    )
    assert found.difference == pytest.approx(
        second.shares["beyond"] - first.shares["beyond"], abs=1e-12
    )
    assert f"{found.both:,} both beyond" in str(found)
    with pytest.raises(ValueError, match="by: expected near or beyond, got 'made'"):
        hoopgen.compare(MODEL, MODEL, scene=scene, by="made", shots=10)


def test_the_optimum_comes_to_the_end_asked_for(scene: Engine) -> None:
    best = hoopgen.optimum(
        Scatter(PLACE, {"vx": 0.1}), {"vx": (0.3, 3.0)}, scene=scene, by="beyond", shots=400
    )
    assert best.probability > 0.95
    again = hoopgen.estimate(
        Scatter(best.release, {"vx": 0.1}), scene=scene, shots=best.shots, seed=best.seed + 1
    )
    assert again.shares["beyond"] == best.probability
    assert "beyond" in str(best)
    with pytest.raises(ValueError, match="there are no usual bounds"):
        hoopgen.optimum(Scatter(PLACE, {"vx": 0.1}), ["vx"], scene=scene)


def test_measured_states_are_drawn_and_moved(scene: Engine) -> None:
    drawn = MODEL.draw(0, 40, 1, scene.parameters)
    names = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
    measured = Resample(dict(zip(names, drawn.states.T, strict=True)))
    found = hoopgen.map(measured, {"vx": [measured.centre["vx"]]}, scene=scene, shots=SHOTS)
    plain = hoopgen.estimate(measured, scene=scene, shots=SHOTS)
    assert found["share"].sel(ending="near").item() == plain.shares["near"]


def test_releases_at_a_hoop_are_refused_where_there_is_none(scene: Engine) -> None:
    model = Scatter({"speed": 7.0, "elevation": 0.9, "height": 2.1, "distance": 4.2}, {"speed": 1})
    for asked in (hoopgen.estimate, lambda *a, **k: hoopgen.map(*a, {"reach": [1]}, **k)):
        with pytest.raises(ValueError, match=r"the scene ledge has no hoop .* give states, x y z"):
            asked(model, scene=scene)


@pytest.mark.parametrize("name", ["bank_or_direct", "best_shots", "margins"])
def test_what_only_a_hoop_has_says_so_in_a_line(name: str, scene: Engine) -> None:
    given: dict[str, dict[str, Any]] = {
        "bank_or_direct": {"model": Scatter({}), "places": [[4.2, 0.0]]},
        "margins": {"model": Scatter({})},
    }
    with pytest.raises(ValueError, match=f"{name}: its question is a hoop's") as refused:
        getattr(hoopgen, name)(**given.get(name, {}), scene=scene)
    assert "ledge" in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_parameter_called_like_a_component_is_refused() -> None:
    """The scene's constructor refuses it, or the first study if derivation's own pieces make it."""
    with pytest.raises(ValueError, match="vx names a component of a shot's state"):
        hoopgen.Scene(
            "odd",
            parameters=[hoopgen.scene.Parameter("vx", 1.0)],
            ball_radius=0.1,
            gravity=9.8,
            restitution=0.5,
            bodies=[hoopgen.scene.Plane("floor", at="vx")],
        )
    made = SimpleNamespace(inputs=[SimpleNamespace(own=True, name="vx", unit="m", infinite=False)])
    with pytest.raises(ValueError, match="its parameter vx is named like a component"):
        variables_of(made)


# ------------------------------------------------------------------------------------------- tables


def table(folder: Path) -> Path:
    file = folder / "states.csv"
    with file.open("w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(["who", "x", "y", "z_cm", "vx", "vy", "vz", "reach_cm"])
        writer.writerows(["a", 0.5, 0, 30, vx, 0, 0, 100] for vx in (0.5, 1.0, 2.0))
        writer.writerow(["in the floor", 0.5, 0, 1, 1, 0, 0, 100])
        writer.writerow(["no number", 0.5, 0, 30, "", 0, 0, 100])
        writer.writerow(["not allowed", 0.5, 0, 30, 1, 0, 0, -100])
    return file


@pytest.mark.slow
def test_a_table_of_states_is_flown_and_read_again(
    scene: Engine, other: Engine, tmp_path: Path
) -> None:
    out = tmp_path / "out.parquet"
    found = hoopgen.batch(table(tmp_path), out, scene=scene, parameters={"bounce": 0.5})
    assert sum(found.values()) == 6
    assert found["invalid"] == 3
    assert [reason for _, reason in found.invalid] == [
        "inside the floor",
        "no value in vx",
        "parameter not allowed: reach -1; reach has to be above 0",
    ]
    rows = pq.read_table(out)
    states = np.zeros((3, 9))
    states[:, [0, 2]], states[:, 3] = (0.5, 0.3), (0.5, 1.0, 2.0)
    shots = scene.simulate(states, {"bounce": 0.5})
    said = [scene.outcomes(code).name.lower() for code in shots.outcome]
    assert rows["outcome"].to_pylist()[:3] == said
    assert rows["floor_contacts"].to_pylist()[:3] == shots.counts[:, 0].tolist()
    assert "kind" not in rows.column_names
    again = hoopgen.batch(out, scene=scene, prefix="again_")
    assert dict(again) == dict(found)
    assert str(again.to_arrow()["again_end_x_m"]) == str(rows["end_x_m"])
    assert dict(hoopgen.batch(out, prefix="again_")) == dict(found)  # the file has its text
    for wrong, expected in (
        (hoopgen.COURT, f"ledge, the scene of the shots in {out}; got court; give that scene"),
        (other, f"the ledge of the shots in {out}; got another scene of that name; give that"),
    ):
        with pytest.raises(ValueError, match=re.escape(f"scene: expected {expected}")):
            hoopgen.batch(out, scene=wrong, prefix="again_")
    with pytest.raises(ValueError, match="measures: its question is a hoop's"):
        hoopgen.batch(out, scene=scene, prefix="again_", measures=["depth"])


def test_results_of_the_hoop_are_not_flown_elsewhere(scene: Engine, tmp_path: Path) -> None:
    source = tmp_path / "hoop.csv"
    source.write_text("x,y,z,vx,vy,vz\n4.2,0,-0.6,-4.5,0,5.6\n")
    hoopgen.batch(source, tmp_path / "hoop.parquet")
    with pytest.raises(ValueError, match=r"expected hoop, the scene of the shots in .*; got ledge"):
        hoopgen.batch(tmp_path / "hoop.parquet", scene=scene, prefix="again_")


@pytest.mark.slow
def test_an_interrupted_table_is_not_gone_on_with_in_another_scene(
    scene: Engine, other: Engine, tmp_path: Path
) -> None:
    source, out = table(tmp_path), tmp_path / "out.parquet"

    def stop(done: int, _: int | None) -> None:
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        hoopgen.batch(source, out, scene=scene, rows=1, threads=1, progress=stop)
    with pytest.raises(ValueError, match=r"scene\.sha256"):
        hoopgen.batch(source, out, scene=other, rows=1)
    hoopgen.batch(source, out, scene=scene, rows=1)
    assert pq.read_table(out).num_rows == 6


def test_a_table_without_states_says_what_is_needed(scene: Engine, tmp_path: Path) -> None:
    source = tmp_path / "hoop.csv"
    source.write_text("speed,elevation_deg,height,distance\n7,52,2.1,4.2\n")
    with pytest.raises(ValueError, match="in the scene ledge rows are states, x y z vx vy vz"):
        hoopgen.batch(source, scene=scene)


# ---------------------------------------------------------------------------------- command line

AIMED = ("--distance", "4m", "--height", "2m")
RELEASED = ("--position=50cm,0,30cm", "--velocity=1,0,0")


@pytest.mark.slow
def test_the_command_line_runs_studies_of_a_scene(file: Path, tmp_path: Path) -> None:
    given = ("--scene", file, *RELEASED)
    sd = ("--scatter", "vx=0.2", "--scatter", "bounce=0.05")
    said = json.loads(output("estimate", *given, *sd, "--shots", SHOTS, "--json"))
    found = hoopgen.estimate(MODEL, scene=hoopgen.load_scene(file), shots=SHOTS)
    assert said["counts"] == found.counts
    assert said["scene"] == "ledge"
    text = output("estimate", *given, *sd, "--shots", 99, "--versus", "reach=1.2", "--by", "beyond")
    assert "both beyond" in text
    out = tmp_path / "map.csv"
    text = output("map", *given, *sd, "--over", "reach=90cm,1.1", "--shots", 50, "--out", out)
    assert text.startswith("map    2 reach, 50 shots each\nends   ")
    columns = list(csv.DictReader(out.read_text().splitlines()))
    assert {row["reach_m"] for row in columns} == {"0.9", "1.1"}
    assert all(float(row["share_near"]) <= 1 for row in columns)
    picture = tmp_path / "map.svg"
    single = output("map", *given, "--over", "vx=0.5:2:4", "--picture", picture)
    assert single.startswith("map    4 vx, one shot each")
    assert picture.stat().st_size > 0
    text = output(
        "optimum", *given, "--over", "vx=0.3:3", "--scatter", "vx=0.1", "--shots", 200, "--by",
        "beyond",
    )  # fmt: skip
    assert "% beyond (" in text
    results = tmp_path / "out.parquet"
    text = output(
        "batch", table(tmp_path), "--scene", file, "--out", results, "--set", "bounce=0.5"
    )
    assert "scene: ledge, reach by row, bounce 0.5" in text
    page = ("--out", tmp_path / "p.html")
    whole = output("view", results, "--scene", file, *page)
    assert "all 6 rows" in whole
    said = failure("view", results, "--scene", "hoop", *page)
    assert "--scene: expected ledge, the scene of the shots in" in said
    drawn = output("estimate", "--from", results, "--scene", file, "--shots", 50)
    assert "measured" in drawn
    # The file has the text of the scene.
    assert output("view", results, *page) == whole
    assert output("estimate", "--from", results, "--shots", 50) == drawn
    again = tmp_path / "again.csv"
    assert "scene: ledge, reach by row, bounce 0.5" in output("batch", results, "--out", again)
    assert output("view", again, *page) == whole.replace(results.name, again.name)
    assert "scene ledge" in hoopgen.view(again).about
    assert (
        hoopgen.batch(results, parameters={"bounce": 0.5}).scene
        == "ledge, reach by row, bounce 0.5"
    )


@pytest.mark.slow
def test_the_text_of_a_scene_in_results_is_read_as_a_scene_file_is(
    file: Path, scene: Engine, tmp_path: Path
) -> None:
    results, page = tmp_path / "out.parquet", ("--out", tmp_path / "p.html")
    output("batch", table(tmp_path), "--scene", file, "--out", results)
    rows = pq.read_table(results)
    metadata = dict(rows.schema.metadata)
    about = json.loads(metadata[b"hoopgen"])
    assert about["scene_text"] == file.read_text(encoding="utf-8")

    def refusal(text: str | None) -> str:
        """Return why results are refused whose scene has another text, or none."""
        there = {name: value for name, value in about.items() if name != "scene_text"}
        there |= {} if text is None else {"scene_text": text}
        changed = metadata | {b"hoopgen": json.dumps(there).encode()}
        pq.write_table(rows.replace_schema_metadata(changed), results)
        return failure("view", results, *page)

    assert "which has not its text; got hoop; give that scene" in refusal(None)
    assert "cannot be read: this is not TOML" in refusal("import os")
    evil = about["scene_text"].replace("x - reach", "__import__('os')")
    assert "body floor: within" in refusal(evil)
    other = refusal(about["scene_text"].replace("- 1.3", "- 1.4"))
    assert "got another scene of that name" in other
    large = about["scene_text"] + "#" * 1_000_000
    assert "--limit file_size=" in refusal(large)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("aim", *AIMED, "--scene", "FILE"), "--distance is of a shot at a hoop; with --scene"),
        (("paper", "--scene", "FILE"), "hoopgen paper: its question is a hoop's"),
        (("estimate", *RELEASED), "--position is of a shot in a --scene"),
        (("estimate", "--scene", "x.txt"), "hoop, court, air, court-air, or a scene file, .toml"),
        (("estimate", "--scene", "none.toml"), "does not exist"),
        (("estimate", "--scene", "FILE", "--speed", "7"), "--speed is of a shot at a hoop"),
        (("estimate", "--scene", "FILE", *RELEASED, "--preset", "nba"), "--preset nba is not one"),
        (("estimate", "--scene", "FILE", *RELEASED, "--scatter", "speed=1"), "'speed' is none"),
        (("map", "--scene", "FILE", *RELEASED, "--over", "aim=0:1:3"), "'aim' is none of x, y, z"),
        (
            ("optimum", "--scene", "FILE", *RELEASED, "--over", "vx=1:2", "--scatter", "vy=1",
             "--by", "bank"),
            "by: expected near or beyond, got 'bank'",
        ),
        (("estimate", "--scene", "FILE", "--position", "0,0,1", "--scatter", "vx=1"), "missing --"),
    ],
)  # fmt: skip
def test_what_is_wrong_on_the_command_line_is_said(
    arguments: tuple[str, ...], said: str, file: Path
) -> None:
    assert said in failure(*(file if word == "FILE" else word for word in arguments))


def test_the_hoop_has_a_name_too() -> None:
    shot = ("--speed", 7.17, "--elevation", "51deg", "--distance", "13.75ft", "--height", "7ft")
    assert output("shot", "--scene", "hoop", *shot) == output("shot", *shot)


# ------------------------------------------------------------------------------------ study files

STUDY = """\
scene = "ledge.toml"

[study]
name = "A ledge"
seed = 4
formats = ["svg"]

[release]
x = 0.5
y = 0
z = "30 cm"
vx = 1
vy = 0
vz = 0

[scatter]
vx = "0.2 m/s"
bounce = 0.05

[[question]]
name = "ends"
kind = "estimate"
shots = 500

[[question]]
name = "map"
kind = "map"
over.reach = [0.9, "110 cm"]
shots = 50

[[question]]
name = "longer"
kind = "compare"
versus.scene.reach = 1.2
by = "beyond"
shots = 200
"""


def study(folder: Path, text: str = STUDY, scene: str | None = LEDGE) -> Path:
    if scene is not None:
        (folder / "ledge.toml").write_text(scene, encoding="utf-8")
    path = folder / "study.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_study_of_a_scene_is_run_and_refused_once_the_scene_changed(
    scene: Engine, tmp_path: Path
) -> None:
    answers = run_study(study(tmp_path))
    found = hoopgen.estimate(MODEL, scene=scene, shots=500, seed=4)
    assert answers["ends"].numbers["counts"] == found.counts
    assert 0 < found.shares["beyond"] < 1
    assert "% near (" in answers["ends"].line
    assert run_study(study(tmp_path)) == answers
    kept = tmp_path / "study-results" / "scene.toml"
    assert kept.read_text(encoding="utf-8") == LEDGE
    altered = LEDGE.replace('["x - 1.3"]', '["x - 1.3*reach"]')
    with pytest.raises(ValueError, match="holds another study") as refused:
        run_study(study(tmp_path, scene=altered))
    assert "scene.sha256" in str(refused.value)
    assert kept.read_text(encoding="utf-8") == LEDGE


def test_a_table_of_the_scene_sets_its_parameters(tmp_path: Path) -> None:
    text = STUDY.replace('scene = "ledge.toml"', '[scene]\nfile = "ledge.toml"\nreach = "120 cm"')
    (question, *_) = hoopgen.studyfile.check_study(study(tmp_path, text))
    assert question.setting.parameters["reach"] == 1.2
    assert question.scene == "ledge, reach 1.2"


HOSTILE = [
    ('__import__("os").system("touch hit")', "unknown name"),
    ("x.__class__", "not allowed"),
    ("x**9**9**9", "x**9**9**9"),
    ("(" * 200 + "x" + ")" * 200, "at most 300 characters"),
]


@pytest.mark.parametrize(("formula", "said"), HOSTILE)
def test_nothing_in_a_scene_file_of_a_study_is_run(
    formula: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    scene = LEDGE.replace('"x - reach"', json.dumps(formula))
    with pytest.raises(StudyError) as refused:
        run_study(study(tmp_path, scene=scene))
    (complaint,) = refused.value.complaints
    assert complaint.startswith(f"{tmp_path / 'study.toml'}:1: scene: ")
    assert said in complaint
    assert {path.name for path in tmp_path.iterdir()} == {"ledge.toml", "study.toml"}


@pytest.mark.parametrize(
    ("given", "scene", "said"),
    [
        ('"none.toml"', None, "there is no file"),
        (
            '"ledge.py"',
            LEDGE,
            "air, court-air, or a scene file, .toml; got 'ledge.py'",
        ),
        ('"/dev/zero"', LEDGE, "expected hoop, court, air, court-air, or a scene file, .toml"),
        ('"."', LEDGE, "expected hoop, court, air, court-air, or a scene file"),
        ('"ledge.toml"', "[[[", "this is not TOML"),
        ('"ledge.toml"', "\x00", "this is not TOML"),
        ('"ledge.toml"', 'name = "no bodies"', "scene"),
        ("3", LEDGE, "expected a table"),
    ],
)
def test_what_is_no_scene_is_a_complaint_with_its_line(
    given: str, scene: str | None, said: str, tmp_path: Path
) -> None:
    text = STUDY.replace('scene = "ledge.toml"', f"scene = {given}")
    with pytest.raises(StudyError) as refused:
        run_study(study(tmp_path, text, scene))
    first = refused.value.complaints[0]
    assert first.startswith(f"{tmp_path / 'study.toml'}:1: scene")
    assert said in first


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('kind = "estimate"\nshots = 500', 'kind = "aim"\ndistance = 4', "aim: its question is"),
        ("shots = 500", 'scene = "ledge.toml"', "named above the questions"),
        ("vx = 1\n", "speed = 1\n", "release.speed: unknown key"),
        ("bounce = 0.05", "restitution = 0.05", "scatter.restitution: unknown key"),
        ("over.reach", "over.aim", "over.aim: unknown key"),
        ('by = "beyond"', 'by = "made"', "by: expected near or beyond"),
        ("shots = 500", 'figures = ["landings"]', "landings: its question is a hoop's"),
    ],
)
def test_what_a_study_of_a_scene_cannot_ask_is_said(
    old: str, new: str, said: str, tmp_path: Path
) -> None:
    with pytest.raises(StudyError) as refused:
        run_study(study(tmp_path, STUDY.replace(old, new)))
    assert said in "\n".join(refused.value.complaints)
