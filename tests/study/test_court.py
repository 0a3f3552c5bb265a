"""The whole hoop wherever a scene is named: commands, studies, their files; and infinities."""

from __future__ import annotations

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import hoopgen
from hoopgen import COURT, HOOP, NBA_COURT, PAPER_COURT
from hoopgen.core.parameters import AIR_DEFAULTS
from hoopgen.core.units import parse_quantity
from hoopgen.report.quantities import for_json
from hoopgen.scene.lookup import HOOP_VARIABLES, variables_of
from hoopgen.simulation.lookup import scene_from
from tests.helpers.commands import failure, output

pytest.importorskip("pyarrow")
xr = pytest.importorskip("xarray")
pytest.importorskip("pydantic")

from hoopgen import Scatter  # noqa: E402
from hoopgen.plots.class_legend import CLASSES, classify  # noqa: E402
from hoopgen.report.provenance import describe_dataset  # noqa: E402
from hoopgen.study.measures.measures import MEASURES, measure, measures_of  # noqa: E402
from hoopgen.studyfile import run_study  # noqa: E402
from hoopgen.studyfile.reading import StudyError  # noqa: E402

# One worker: its C is compared with NumPy once.
pytestmark = pytest.mark.xdist_group("court")

PLACE = {"elevation": 0.89, "height": 2.13, "distance": 4.19}
AT = {**PLACE, "speed": 7.17}
SD = {"speed": 0.1}
MODEL = Scatter(AT, SD)
THROWN = ("--elevation", "51deg", "--height", "7ft", "--distance", "13.75ft", "--scene", "court")
SHOT = (*THROWN, "--speed", "7.17")
SHOTS = 400
INF = math.inf


# -- By name


def test_it_is_named_like_the_hoop_with_presets_of_the_same_names() -> None:
    assert scene_from("court") is COURT
    assert COURT.presets["nba"] is NBA_COURT
    assert list(COURT.presets) == list(HOOP.presets)


@pytest.mark.slow
def test_the_hoop_alone_never_loads_it() -> None:
    code = """
import sys
from click.testing import CliRunner
from hoopgen import Scatter, estimate
from hoopgen.cli import main
model = Scatter({"speed": 7.17, "elevation": 0.89, "height": 2.13, "distance": 4.19}, {"speed": 1})
estimate(model, shots=10)
words = "--speed 7.17 --elevation 51deg --height 7ft --distance 13.75ft --scene hoop".split()
for command in (["shot"], ["estimate", "--shots", "10", "--scatter", "speed=0.1"]):
    result = CliRunner().invoke(main, [*command, *words, "--preset", "nba"])
    assert result.exit_code == 0, result.output
print(*(name for name in sys.modules if name.endswith(".court")), sep=",")
"""
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert said.stdout.strip() in ("", "hoopgen.plots.floor_plan")


def test_variables_of_both_hoops_are_known_before_a_scene_is() -> None:
    assert "ring_friction" in HOOP_VARIABLES
    assert set(HOOP_VARIABLES) == {
        *variables_of(HOOP),
        *variables_of(COURT),
        *AIR_DEFAULTS,
    }
    Scatter(AT, {"ring_restitution": 0.01})
    with pytest.raises(ValueError, match="sd: unknown ring_frictions; is ring_friction meant"):
        Scatter(AT, {"ring_frictions": 0.01})


# -- Commands


def test_a_shot_takes_its_preset_and_says_it() -> None:
    said = json.loads(output("shot", *SHOT, "--preset", "nba", "--json"))
    assert said["scene"] == "court, NBA"
    assert said["parameters"]["backboard_restitution"] == NBA_COURT["backboard_restitution"]


def test_an_infinite_parameter_goes_out_as_text_and_comes_back(tmp_path: Path) -> None:
    text = output("shot", *SHOT, "--preset", "nba", "--set", "ring_friction=inf", "--json")
    said = json.loads(text, parse_constant=lambda word: pytest.fail(word))
    assert said["parameters"]["ring_friction"] == "inf"
    assert said["scene"] == "court, NBA, ring_friction inf"
    file = tmp_path / "shot.json"
    file.write_text(text, encoding="utf-8")
    pytest.importorskip("flint")
    proof = output("certify", file, "--scene", "court")
    assert "scene      court, NBA, ring_friction inf" in proof


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("gravity=inf", "gravity: 'inf' is not a finite number"),
        ("ring_friction=-inf", "ring_friction: '-inf' is not a finite number, or plus infinity"),
        ("ring_friction=nan", "ring_friction: 'nan' is not a number"),
        ("ring_friction=-1", "ring_friction -1.0 not allowed"),
        ("restitution_speed=0", "restitution_speed 0.0 not allowed"),
        ("tangential_restitution=2", "expected -1 to 1, got 2.0"),
        ("restitution=0.7", "'restitution' is none of"),
    ],
)
def test_what_is_not_allowed_is_one_line(setting: str, said: str) -> None:
    scatter = ("--scatter", "speed=0.1", "--shots", "10")
    assert said in failure("estimate", *SHOT, *scatter, "--set", setting)


def test_studies_refuse_what_may_not_be_infinite() -> None:
    with pytest.raises(ValueError, match=r"parameters: .*: gravity inf is not finite"):
        hoopgen.estimate(MODEL, {"gravity": INF}, scene=COURT, shots=10)
    with pytest.raises(ValueError, match=r"parameters: .*: gravity inf is not finite"):
        hoopgen.estimate(MODEL, {"gravity": INF}, shots=10)


def test_the_article_s_questions_say_so_in_a_line() -> None:
    assert "its question is a hoop's, the article's" in failure("paper", "--scene", "court")


def test_a_release_is_aimed_at_the_whole_hoop_and_its_margins_end_where_it_says() -> None:
    found = hoopgen.aim(height=2.1, distance=4.2, entry=0.8, scene=COURT)
    vacuum = hoopgen.aim(height=2.1, distance=4.2, entry=0.8)
    assert (found.speed, found.elevation) == (vacuum.speed, vacuum.elevation)
    centre = {name: float(value) for name, value in found.arguments.items()}
    margin = hoopgen.margins(Scatter(centre), scene=COURT, names=["speed"])["speed"]
    ends = np.array([margin.low, margin.high])
    around = np.concatenate([ends, ends + [-1e-6, 1e-6]])
    states = hoopgen.release(**(centre | {"speed": around}))
    made = hoopgen.simulate(states, scene=COURT).made
    assert made.tolist() == [True, True, False, False]
    words = ("--distance", "4.2m", "--height", "2.1m", "--entry", "0.8rad", "--scene", "court")
    said = output("aim", *words)
    assert f"{found.speed:.3f} m/s" in said
    assert "scene   court, PAPER" in said


@pytest.mark.slow
def test_bank_shots_on_the_whole_hoop_have_the_shares_of_estimates() -> None:
    places = [[1.5, 2.6]]
    parameters = NBA_COURT | {"backboard_restitution": 0.75}
    release = {"height": 2.13, "backspin": 18.0}
    model = Scatter(release, SD)
    found = hoopgen.bank_or_direct(model, places, parameters, scene=COURT, shots=1_000)
    assert found.attrs["scene"] == "court, NBA, backboard_restitution 0.75"
    for way in ("direct", "bank"):
        best = found.sel(way=way).isel(place=0)
        one = {name: best[name].item() for name in ("speed", "elevation", "azimuth")}
        one |= {name: best[name].item() for name in ("distance", "angle")}
        drawn = Scatter({**release, **one}, SD).draw(0, 20_000, 7, parameters)
        shots = hoopgen.simulate(drawn.states, drawn.parameters, scene=COURT)
        banked = shots.first == COURT.surfaces.index("backboard")
        share = np.mean(shots.made & (banked == (way == "bank")))
        assert abs(share - best["probability"].item()) < 5 * 0.016
    hoopgen.plots.plot_aim_points(found, parameters)


# -- Studies


def test_an_estimate_counts_every_outcome() -> None:
    many = 4000
    rest = {f"{body}_restitution": 0.2 for body in COURT.surfaces}
    soft = PAPER_COURT | rest
    found = hoopgen.estimate(MODEL, soft, scene=COURT, shots=many)
    drawn = MODEL.draw(0, many, 0, soft)
    shots = hoopgen.simulate(drawn.states, drawn.parameters, scene=COURT)
    for outcome in COURT.outcomes:
        count = int((shots.outcome == outcome).sum())
        assert getattr(found, outcome.name.lower()) == count
        assert f"{count:,} {outcome.name.lower()}" in str(found)
    assert found.lodged > 0
    assert found.as_dict()["lodged"] == found.lodged
    assert "scene    court, PAPER" in str(found)


def test_the_hoop_s_estimate_says_nothing_of_balls_at_rest() -> None:
    found = hoopgen.estimate(MODEL, shots=10)
    assert (found.lodged, found.endless) == (0, 0)
    assert "lodged" not in str(found)


def test_a_comparison_says_what_an_infinite_friction_does() -> None:
    scatter = ("--scatter", "speed=0.1", "--shots", SHOTS, "--versus", "ring_friction=inf")
    said = output("estimate", *SHOT, "--preset", "nba", *scatter)
    assert "second: court, NBA, ring_friction inf" in said


def test_a_map_of_it_says_who_scatters() -> None:
    over = {"elevation": [0.9, 0.95]}
    release = {"aim": 0.05, "height": 2.1336, "distance": 4.191}
    player = Scatter(release, {"speed": 0.07})
    mapped = hoopgen.map(player, over, scene=COURT, shots=20)
    assert describe_dataset(mapped)["scatter"] == "speed 0.07 m/s"
    assert "scatter" not in describe_dataset(hoopgen.map(Scatter(release), over, scene=COURT))


def test_a_map_over_an_infinite_friction_is_the_shots_themselves(tmp_path: Path) -> None:
    grid = ("--over", "ring_friction=0.2,inf", "--over", "speed=7.1:7.2:3")
    for name in ("m.csv", "m.nc"):
        output("map", *THROWN, *grid, "--preset", "nba", "--out", tmp_path / name)
    with (tmp_path / "m.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["ring_friction"] for row in rows] == ["0.2"] * 3 + ["inf"] * 3
    with xr.open_dataset(tmp_path / "m.nc") as there:
        assert there["ring_friction"].values.tolist() == [0.2, INF]
        assert there.attrs["scene"] == "court, NBA"
        assert json.loads(there.attrs["parameters"])["backboard_friction"] == 0.5
        outcome = there["outcome"].values.ravel()
    spots = [(mu, v) for mu in (0.2, INF) for v in there["speed"].values.tolist()]
    for (mu, v), code in zip(spots, outcome, strict=True):
        state = hoopgen.release(v, math.radians(51), height=7 * 0.3048, distance=13.75 * 0.3048)
        shot = hoopgen.simulate(state, NBA_COURT | {"ring_friction": mu}, scene=COURT)
        assert shot.outcome[0] == code


@pytest.mark.slow
def test_an_optimum_and_its_rival_are_of_the_same_scene() -> None:
    over = ("--over", "speed=7.1:7.2", "--scatter", "speed=0.1", "--shots", 200)
    text = output("optimum", *THROWN, "--preset", "nba", *over, "--json")
    said = json.loads(text)
    assert said["scene"] == "court, NBA"
    assert said["parameters"]["restitution_speed_m_s"] == 40.0
    rival = json.loads(output("optimum", *THROWN, *over, "--versus", "direct", "--json"))["versus"]
    assert rival["scene"] == "court, PAPER"
    assert rival["parameters"]["restitution_speed_m_s"] == "inf"


def test_measures_are_those_of_its_own_flights() -> None:
    states = MODEL.draw(0, 50, 0, PAPER_COURT).states
    shots = hoopgen.simulate(states, NBA_COURT, scene=COURT)
    found = measure(states, shots, NBA_COURT)
    assert set(found) == set(MEASURES) - {"clearance"} == set(measures_of(COURT))
    free = (shots.contacts == 0) & (shots.outcome == COURT.outcomes.MADE)
    assert free.any()
    np.testing.assert_array_equal(found["end_x"][free], shots.state[free, 0])
    with pytest.raises(ValueError, match="names: unknown clearance"):
        measure(states, shots, NBA_COURT, ["clearance"])


def test_every_outcome_has_a_colour_with_every_kind_that_it_can_have() -> None:
    for outcome in (COURT.outcomes.LODGED, COURT.outcomes.ENDLESS):
        places = classify([outcome] * 7, range(7))
        assert {CLASSES[place].outcome for place in places.tolist()} == {outcome.name.lower()}


# -- Tables

TABLE = """\
speed,elevation_deg,height,distance,ring_friction
7.17,51,2.13,4.19,inf
7.1,51,2.13,4.19,0.5
7.1,51,2.13,4.19,-1
7.1,inf,2.13,4.19,1
"""


@pytest.mark.parametrize("name", ["out.csv", "out.parquet"])
def test_a_table_may_have_an_infinite_friction_and_results_are_read_again(
    tmp_path: Path, name: str
) -> None:
    (tmp_path / "in.csv").write_text(TABLE, encoding="utf-8")
    out = tmp_path / name
    said = output("batch", tmp_path / "in.csv", "--scene", "court", "--out", out)
    assert "4 shots: 1 made, 1 missed, 0 capped, 0 short, 2 invalid, 0 lodged, 0 endless" in said
    assert "row 3: parameter not allowed: ring_friction -1" in said
    assert "row 4: not finite: elevation_deg" in said
    again = output("estimate", "--from", out, "--scene", "court", "--shots", 100, "--json")
    found = json.loads(again)
    assert found["made"] > 0
    assert found["setting"]["parameters"]["restitution_speed_m_s"] == "inf"


def test_a_column_that_may_not_be_infinite_makes_invalid_rows_alone(tmp_path: Path) -> None:
    states = np.array([*hoopgen.release(7.17, 0.89, height=2.13, distance=4.19).ravel()])
    rows = "\n".join(",".join(map(str, (*states[:6], g))) for g in (9.81, INF))
    (tmp_path / "in.csv").write_text(f"x,y,z,vx,vy,vz,gravity\n{rows}\n", encoding="utf-8")
    said = output("batch", tmp_path / "in.csv", "--scene", "court", "--out", tmp_path / "out.csv")
    assert "row 2: not finite: gravity" in said
    assert "1 invalid" in said


@pytest.mark.slow
def test_a_page_and_a_picture_show_it_with_infinite_parameters(tmp_path: Path) -> None:
    page, picture = tmp_path / "shot.html", tmp_path / "shot.svg"
    output("shot", *SHOT, "--set", "ring_friction=inf", "--view", page, "--picture", picture)
    assert page.stat().st_size > 0  # its data are JSON: an infinite number would be refused
    assert picture.stat().st_size > 0


# -- Study files

STUDY = """\
scene = "court"

[study]
name = "Whole"

[release]
speed = 7.17
elevation = "51 deg"
height = "7 ft"
distance = "13.75 ft"

[scatter]
speed = 0.1
"""

QUESTIONS = """
[[question]]
kind = "estimate"
name = "slips"
shots = 300
scene = { preset = "nba" }

[[question]]
kind = "compare"
name = "grips"
shots = 300
scene = { preset = "nba" }
versus.scene = { ring_friction = inf, restitution_speed = "inf" }

[[question]]
kind = "map"
name = "frictions"
shots = 50
over.ring_friction = [0.2, inf]

[[question]]
kind = "bank"
name = "board"
over = ["aim", "azimuth"]
places = { distance = 3, angle = "60 deg" }
scene = { preset = "nba" }
shots = 100
figures = ["aim_points"]
"""


@pytest.mark.slow
def test_a_study_of_it_is_answered_and_gone_on_from(tmp_path: Path) -> None:
    file, out = tmp_path / "whole.toml", tmp_path / "out"
    file.write_text(STUDY + QUESTIONS, encoding="utf-8")
    answers = run_study(file, out)
    setting = answers["grips"].numbers["second"]["setting"]
    assert setting["parameters"]["ring_friction"] == "inf"
    assert setting["parameters"]["backboard_friction"] == 0.5
    with xr.open_dataset(out / "board" / "bank.nc", engine="scipy") as there:
        assert there.attrs["scene"] == "court, NBA"
    assert (out / "board" / "aim_points.svg").exists()
    assert {name: one.line for name, one in run_study(file, out).items()} == {
        name: one.line for name, one in answers.items()
    }
    report = (out / "report.md").read_text(encoding="utf-8")
    assert "over.ring_friction = [0.2, inf]" in report
    assert "Infinity" not in report


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ("scene = { gravity = inf }", "scene.gravity: expected an acceleration such as"),
        ("scene = { ring_restitution = 1.5 }", "expected a number from 0 to 1; got 1.5"),
        ('scene = { ring_friction = "-inf" }', "expected a number, or inf; "),
        ('scene = { preset = "ncaa" }', 'expected "paper", "nba" or "fiba"'),
        ("release = { speed = inf }", "release.speed: expected a speed such as"),
    ],
)
def test_a_study_says_the_line_of_what_is_not_allowed(tmp_path: Path, more: str, said: str) -> None:
    file = tmp_path / "whole.toml"
    asked = f'\n[[question]]\nkind = "estimate"\nname = "one"\n{more}\n'
    file.write_text(STUDY + asked, encoding="utf-8")
    with pytest.raises(StudyError) as refused:
        run_study(file, tmp_path / "out")
    assert len(refused.value.complaints) == 1
    assert said in str(refused.value)
    assert f"whole.toml:{len((STUDY + asked).splitlines())}:" in str(refused.value)


def test_a_study_aims_at_the_whole_hoop(tmp_path: Path) -> None:
    file = tmp_path / "whole.toml"
    asked = '\n[[question]]\nkind = "aim"\nname = "one"\ndistance = 4.2\n'
    file.write_text(STUDY + asked, encoding="utf-8")
    run_study(file, tmp_path / "out")
    (line,) = csv.DictReader((tmp_path / "out" / "one" / "table.csv").read_text().splitlines())
    found = hoopgen.aim(height=7 * 0.3048, distance=4.2, scene=COURT)
    np.testing.assert_allclose(float(line["speed_m_s"]), found.speed, rtol=1e-9)


# -- Infinite numbers


def test_json_has_an_infinite_number_as_text() -> None:
    given = {"a": [INF, -INF, math.nan, 1.5], "b": (INF,)}
    assert for_json(given) == {"a": ["inf", "-inf", None, 1.5], "b": ["inf"]}
    assert float(for_json(INF)) == INF


def test_a_quantity_is_infinite_only_where_it_may_be() -> None:
    for text in ("inf", "+inf", " INF ", "infinity"):
        assert parse_quantity(text, "number", infinite=True) == INF
    for text, may in (("inf", False), ("-inf", True), ("infm/s", True), ("nan", True)):
        with pytest.raises(ValueError, match="is not a"):
            parse_quantity(text, "speed", infinite=may)


def test_engines_know_which_of_their_parameters_may_be_infinite() -> None:
    assert COURT.infinite == {"restitution_speed", *(f"{name}_friction" for name in COURT.surfaces)}
    assert HOOP.infinite == frozenset()
    infinite = {name for name, one in variables_of(COURT).items() if one.infinite}
    assert infinite == COURT.infinite
