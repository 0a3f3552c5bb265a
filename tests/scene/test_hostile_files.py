"""Scene and study files that are too large, no files, or full of names that are taken."""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from hoopgen.derive.model import build
from hoopgen.derive.scenes import names as derived_names
from hoopgen.derive.scenes.ends import OTHER_OUTCOMES

import hoopgen
from hoopgen.cli import main
from hoopgen.scene import (
    Box,
    Cylinder,
    End,
    Limits,
    Parameter,
    Plane,
    Scene,
    SceneError,
    Sphere,
    Surface,
    Torus,
    load_scene,
)
from hoopgen.scene import names as scene_names
from hoopgen.scene.limits import NAMES

HEAD = 'name = "own"\nball_radius = 0.1\ngravity = 9.81\nrestitution = 0.7\n'
FLOOR = '[bodies.floor]\nkind = "plane"\n'
DOWN = "[ends.down]\nat = -1\n"


def parameters(count: int) -> str:
    return f"{HEAD}[parameters]\n" + "".join(f"p{k} = 1.0\n" for k in range(count)) + FLOOR + DOWN


def bounds(count: int) -> str:
    within = ", ".join(f'"x - {k}.5"' for k in range(count))
    return f"{HEAD}{FLOOR}within = [{within}]\n{DOWN}"


def bodies(count: int) -> str:
    each = (f'[bodies.floor{k}]\nkind = "plane"\nat = {-k}\n' for k in range(count))
    return HEAD + "".join(each) + DOWN


def ends(count: int) -> str:
    return HEAD + FLOOR + "".join(f"[ends.down{k}]\nat = {-k}\n" for k in range(count))


def sizes(count: int) -> str:
    """Return few bodies with few bounds, of which each has many coefficients."""
    each = (
        f'[bodies.floor{k}]\nkind = "plane"\nat = {-k}\nwithin = ["(x+{k}.3*y+{k}.7*z+{k}.1)**5"]\n'
        for k in range(count)
    )
    return HEAD + "".join(each) + DOWN


def formula(text: str) -> str:
    return f'{HEAD}{FLOOR}at = "{text}"\n{DOWN}'


def condition(text: str) -> str:
    return f'{HEAD}[bodies.floor]\nkind = "surface"\ncondition = "{text}"\n{DOWN}'


def profile(count: int) -> str:
    points = ", ".join(f"[1, {k}]" for k in range(count))
    return f'{HEAD}[bodies.tube]\nkind = "revolution"\nprofile = [{points}]\n{DOWN}'


LARGE = {
    "parameters": (parameters(20_000), "parameters: expected at most 200 parameters, got 20,000"),
    "bounds": (bounds(2_000), "within: expected at most 100 formulas in `within`, of all bodies"),
    "bodies": (bodies(5_000), "bodies: expected at most 200 bodies, got 5,000"),
    "ends": (ends(500), "ends: expected at most 50 ends, got 500"),
    "sizes": (sizes(90), "expected at most 2,000 parameters and sizes computed from them, got"),
    "profile_points": (
        profile(2_000),
        "profile: expected at most 50 points of a profile, got 2,000",
    ),
    "formula_length": (formula("1" + "+1" * 400), "at: expected at most 300 characters, got 801"),
    "formula_depth": (formula("-" * 40 + "1"), "at most 30 operations within one another, got"),
    "formula_degree": (condition("x**9999999 - z"), "at most 8 factors in a product, powers mul"),
    "polynomial_terms": (
        condition("(x + y + z + 2)**4 * (x + y + z + 3)**4"),
        "as a polynomial: expected at most 200 terms, multiplied out, got 1,225",
    ),
    "file_size": (HEAD + "#" * 1_000_000, "expected at most 1,000,000 bytes, got 1,000,0"),
}
"""Scene files and their error texts, by the limit that each exceeds."""


def test_every_limit_is_tried() -> None:
    assert set(LARGE) == set(NAMES)


@pytest.fixture(params=LARGE)
def large(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[str, Path, str]:
    """A limit, a file that passes it, and what is said."""
    text, said = LARGE[request.param]
    path = tmp_path / "large.toml"
    path.write_text(text, encoding="utf-8")
    return request.param, path, said


@pytest.mark.sampled(10)
def test_a_scene_that_is_too_large_is_refused(large: tuple[str, Path, str]) -> None:
    """The error has the limit, the given size, and how the limit is raised."""
    limit, path, said = large
    with pytest.raises(SceneError) as refusal:
        load_scene(path)
    assert str(refusal.value).startswith(f"{path}: ")
    assert said in str(refusal.value)
    assert f"limits={{'{limit}': ...}}, or --limit {limit}=..." in str(refusal.value)


@pytest.mark.sampled(9)
def test_the_command_line_says_the_same(large: tuple[str, Path, str]) -> None:
    limit, path, said = large
    result = CliRunner().invoke(main, ["compile", str(path)])
    assert result.exit_code == 2
    assert said in result.stderr
    assert f"--limit {limit}=" in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_limit_can_be_raised_and_lowered(tmp_path: Path) -> None:
    """The reader of the file gives the limits as an argument, as `Limits` or as a mapping."""
    path = tmp_path / "own.toml"
    path.write_text(bounds(101), encoding="utf-8")
    for limits in ({"bounds": 101}, Limits(bounds=101)):
        made = load_scene(path, limits=limits)
        assert len(made.read.bodies[0].bounds) == 101
        assert pickle.loads(pickle.dumps(made)) == made
    with pytest.raises(SceneError, match="at most 100 formulas"):
        load_scene(path)
    path.write_text(formula("1" + "+1" * 400), encoding="utf-8")
    more = {"formula_length": 1000, "formula_depth": 500}
    assert load_scene(path, limits=more).read.bodies[0]["at"].names
    with pytest.raises(SceneError, match="at most 1 bodies, got 2"):
        Scene(
            "own",
            bodies=[Plane("a"), Plane("b", at=-1)],
            ball_radius=0.1,
            gravity=9.81,
            restitution=0.5,
            limits={"bodies": 1},
        )
    deep = {"formula_length": 100_000, "formula_depth": 100_000}
    path.write_text(formula("-" * 20_000 + "1"), encoding="utf-8")
    with pytest.raises(SceneError, match=r"is not a formula|nested too deep"):
        load_scene(path, limits=deep)


def test_no_file_raises_its_own_limits(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(f"limits = {{ parameters = 500 }}\n{parameters(300)}", encoding="utf-8")
    with pytest.raises(SceneError, match=r"unknown table \[limits\]\. There are name, parameters"):
        load_scene(path)


@pytest.mark.parametrize(("size", "hint"), [("30cm", " (lengths in m)"), ("45°", "")])
def test_a_size_with_a_unit_is_refused_with_its_place(size: str, hint: str, tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(formula(size), encoding="utf-8")
    with pytest.raises(SceneError) as refusal:
        load_scene(path)
    said = f"expected a number without a unit{hint}, or a formula; got {size!r}"
    assert said in str(refusal.value)
    assert "floor" in str(refusal.value)
    assert "at" in str(refusal.value)


@pytest.mark.parametrize(
    ("limits", "kind", "said"),
    [
        ({"parameter": 3}, ValueError, "limits: unknown parameter. There are file_size, param"),
        ({"bodies": 0}, ValueError, "limits.bodies: expected a whole number from 1, got 0"),
        ({"bodies": 2.5}, ValueError, "limits.bodies: expected a whole number from 1, got 2.5"),
        (3, TypeError, "limits: expected Limits or a mapping, got 3"),
    ],
)
def test_limits_that_are_none_are_refused(
    limits: Any, kind: type[Exception], said: str, tmp_path: Path
) -> None:
    path = tmp_path / "own.toml"
    path.write_text(bodies(1), encoding="utf-8")
    with pytest.raises(kind, match=said):
        load_scene(path, limits=limits)


def test_bodies_without_end_are_refused() -> None:
    def without_end() -> Iterator[Plane]:
        while True:
            yield Plane("floor")

    with pytest.raises(SceneError, match="at most 200 bodies, got 201 or more"):
        Scene("own", bodies=without_end(), ball_radius=0.1, gravity=9.81)  # type: ignore[arg-type]


# ------------------------------------------------------------------------------------------- files


@pytest.fixture(params=["pipe", "device", "folder", "socket"])
def no_file(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Path, str]:
    """Return something that is not a file but named like a scene, and its kind."""
    path = tmp_path / "own.toml"
    if request.param == "pipe":
        os.mkfifo(path)
    elif request.param == "device":
        path.symlink_to("/dev/zero")
    elif request.param == "folder":
        path.mkdir()
    else:
        import socket

        there = socket.socket(socket.AF_UNIX)
        try:
            there.bind(str(path))
        except OSError:
            pytest.skip("the name of the temporary folder is too long for a socket")
        there.close()
    return path, request.param


needs_pipes = pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="has no pipes with a name")


@pytest.mark.sampled(1)
@needs_pipes
@pytest.mark.parametrize(
    "code",
    [
        "hoopgen.load_scene(sys.argv[1])",
        "hoopgen.run_study(sys.argv[1])",
        "from hoopgen.studyfile import check_study; check_study(sys.argv[1])",
    ],
)
def test_what_is_no_file_is_refused_and_not_waited_for(
    code: str, no_file: tuple[Path, str]
) -> None:
    path, kind = no_file
    ran = subprocess.run(
        [sys.executable, "-c", f"import sys, hoopgen; {code}", path],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert f"expected a regular file, found a {kind}: '{path}'" in ran.stderr


@pytest.mark.slow
@needs_pipes
@pytest.mark.parametrize(
    "words", [["compile"], ["study"], ["study", "--check"], ["shot", "--scene"]]
)
def test_no_command_waits_for_a_pipe(words: list[str], tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    os.mkfifo(path)
    ran = subprocess.run(
        [sys.executable, "-m", "hoopgen", *words, path],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert ran.returncode == 2
    assert f"{path}: expected a regular file, found a pipe\n" in ran.stderr


@pytest.mark.slow
@needs_pipes
def test_a_study_does_not_wait_for_the_pipe_that_is_its_scene(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "own.toml")
    file = tmp_path / "study.toml"
    file.write_text('scene = "own.toml"\n[study]\nname = "a"\n', encoding="utf-8")
    ran = subprocess.run(
        [sys.executable, "-m", "hoopgen", "study", file],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert ran.returncode == 2
    assert f"scene: there is no file {tmp_path / 'own.toml'}" in ran.stderr


def test_a_study_file_that_is_too_large_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "study.toml"
    file.write_bytes(b"#" * 3_000_000)
    result = CliRunner().invoke(main, ["study", str(file)])
    assert result.exit_code == 2
    assert f"{file}: expected at most 1,000,000 bytes, got 3,000,000" in result.stderr


# ------------------------------------------------------------------------------------------- names


def own(name: str = "own", **given: Any) -> Scene:
    usual: dict[str, Any] = {
        "ball_radius": 0.1,
        "gravity": 9.81,
        "restitution": 0.7,
        "bodies": [Plane("floor")],
        "ends": {"down": End(at=-2)},
    }
    return Scene(name, **(usual | given))


def named(kind: str, names: Sequence[str]) -> Scene:
    """Return a scene in which things of a kind have these names."""
    if kind == "":
        return own(*names)
    if kind == "parameter":
        return own(parameters=[Parameter(name, 1.0) for name in names])
    if kind == "body":
        return own(bodies=[Plane(name, at=-k) for k, name in enumerate(names)])
    return own(ends={name: End(at=-2 - k) for k, name in enumerate(names)})


KINDS = ("", "parameter", "body", "end")


@pytest.mark.parametrize("kind", KINDS)
def test_a_name_that_is_taken_is_refused_when_the_scene_is_made(kind: str) -> None:
    """The error says what has the name."""
    for name, why in scene_names.RESERVED[kind].items():
        with pytest.raises(SceneError) as refusal:
            named(kind, [name])
        assert f"name: {name} {why}; expected another name" in str(refusal.value)


@pytest.mark.parametrize("kind", KINDS)
def test_a_name_has_a_hundred_letters_at_most(kind: str) -> None:
    """So that files can be called like it."""
    named(kind, ["a" * 100])
    with pytest.raises(SceneError, match="name: expected at most 100 letters, got 260"):
        named(kind, ["a" * 260])


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            {"bodies": [Plane("a_end")], "ends": {"a": End()}},
            "body a_end: name: a_end is what the plane of the end a would be called",
        ),
        (
            {"bodies": [Plane("a"), Plane("carry_a", at=-1)]},
            "body carry_a: name: carry_a is what formulas of the body a would be called",
        ),
        (
            {"bodies": [Plane("a"), Plane("a_carry", at=-1)]},
            "body a_carry: name: a_carry is what formulas of the body a would be called",
        ),
        (
            {"parameters": [Parameter("floor_contacts", 1)]},
            "parameter floor_contacts: name: floor_contacts is what the column of contacts with",
        ),
        (
            {"parameters": [Parameter("a", 1), Parameter("a_m", 1)]},
            "parameter a_m: name: a_m is what the column of a in m would be called",
        ),
    ],
)
def test_names_that_are_made_of_one_another_are_refused(given: dict[str, Any], said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        own(**given)
    assert said in str(refusal.value)


def kernels(**given: Any) -> set[str]:
    return {kernel.name for kernel in build(own(**given).derive()).kernels}


LAWS: tuple[dict[str, float], ...] = (
    {},
    {"friction": 0.3, "tangential": 0.1, "restitution_speed": 3.0},
)


@pytest.mark.slow
def test_all_names_that_derivation_has_taken_are_refused() -> None:
    """A body's formulas begin with its name; none of the event loop's is called like that."""
    shapes = [
        Plane("qqa", within=["x"]),
        Sphere("qqb", radius=1, centre=(5, 0, 0), restitution=0.5),
        Cylinder("qqc", radius=0.1, centre=(9, 0, 0)),
        Torus("qqd", radius=1, wire=0.01, centre=(20, 0, 0)),
        Box("qqe", size=(1, 1, 1), centre=(30, 0, 0)),
        Surface("qqf", condition="x**2 + y**4 - z - 90"),
        Sphere("qqg", radius=100, inside=True, within=["z - 50"]),
    ]
    refused = [shape for shape in shapes if isinstance(shape, Surface)]
    unbounded = [shape for shape in shapes if not shape.within or isinstance(shape, Plane)]
    rolling = [shape for shape in unbounded if shape not in refused]
    closing = {"qqz": End(at=-3), "qqy": End(axis="x", at=-50, within=["y"])}
    found: set[str] = set()
    for law in LAWS:
        found |= kernels(bodies=shapes, ends=closing, **law)
        found |= kernels(bodies=rolling, ends={}, rolls=True, **law)
    begun = {name for name in found if name.startswith("qq")}
    after = {name[3:] for name in begun}
    loop = {name for name in found if "qq" not in name}
    assert len(after) > 30
    assert len(loop) > 80
    assert loop >= {"own_margin", "error_bounds"}
    taken = {name.removesuffix(end) for name in loop for end in after if name.endswith(end)}
    assert taken - {""} <= set(scene_names.RESERVED["body"])
    # One body's formulas are those of another only as `check_apart` has it.
    both = {one.removesuffix(end) for one in after for end in after if one.endswith(end)} - {""}
    assert both <= {"_carry", "_end"}
    before = {name[: name.index("qq")] for name in found if "qq" in name}
    assert before == {"", "carry_", "vary_"}


def test_all_names_that_results_have_taken_are_refused() -> None:
    """A parameter of each shot's own stands beside them: the results stay."""
    pytest.importorskip("xarray")
    shots = hoopgen.simulate(
        np.zeros((2, 9)), scene=hoopgen.COURT, fields="all", backend="numpy", record=True,
        derivatives=("vx",),
    )  # fmt: skip
    dataset = shots.to_xarray()
    assert {"after_derivative", "variable_unit", "event_surface"} <= set(dataset.variables)
    names = {*map(str, dataset.data_vars), *map(str, dataset.dims), *map(str, dataset.coords)}
    own_names = set(hoopgen.COURT.parameters)
    assert names - own_names <= set(scene_names.RESERVED["parameter"])
    assert set(OTHER_OUTCOMES) <= set(scene_names.RESERVED["end"])
    assert set(derived_names.RESERVED_NAMES) == set(scene_names.RESERVED[""])
    assert derived_names.END in scene_names.RESERVED["body"]


def test_a_word_of_any_language_is_a_name() -> None:
    """Formulas may have such names, too."""
    words = ["lambda", "if", "class", "int", "while", "null", "new"]
    scene = own(
        parameters=[Parameter(word, 1.0 + k) for k, word in enumerate(words)],
        bodies=[Plane(word, at=f"-2*{word} + lambda") for word in words],
        ends={word: End(at=f"-30 - {word}") for word in words},
    )
    values = dict(zip((one.name for one in scene.inputs), scene.values({"if": 5.0}), strict=True))
    assert values["if_at"] == -2 * 5.0 + 1.0
    assert values["lambda_at"] == -1.0
    assert len(scene.derive().bodies) == len(words)
