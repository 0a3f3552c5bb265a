"""CUDA without a GPU: NVRTC's instructions round as IEEE 754 says, and the source has C's bits.

For the second claim the same source is compiled for this processor.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

import numpy as np
import pytest
from hoopgen.derive import scenes
from hoopgen.derive.model import build
from hoopgen.derive.scenes.scene import Scene
from numpy.typing import NDArray

import hoopgen
from benchmarks import own_scenes, workloads
from hoopgen import COURT, HOOP
from hoopgen.codegen import render
from hoopgen.codegen.cuda import CudaBackend
from hoopgen.codegen.cuda.loop import ShotLoop
from hoopgen.codegen.registry import BACKENDS, register
from hoopgen.codegen.rerolling import parameter_kernels
from hoopgen.codegen.statements import Assign, Call, For, If, Member, Name, Number, Statement
from hoopgen.codegen.variants import variants
from hoopgen.engine import verification
from hoopgen.engine.cuda import _INSTRUCTION, FLAGS, unexpected_instructions
from hoopgen.simulation.court import court_shots
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.fingerprint import fingerprint
from hoopgen.simulation.hoop import hoop_shots
from tests.helpers import ROOT
from tests.helpers.compiled import needs_compiler
from tests.helpers.court_shots import all_kinds
from tests.helpers.effort import trials
from tests.helpers.hoop_shots import families
from tests.helpers.host_cuda import HostCuPy, needs_cpp, on_host
from tests.helpers.nvrtc import compile_to_ptx, needs_nvrtc

States = NDArray[np.float64]

# One worker: each scene is compiled once.
pytestmark = pytest.mark.xdist_group("cuda")

SOURCE = """
extern "C" __global__ void kernel(double *r, const double *p, float *s, const float *q)
{{
    const double a = p[0], b = p[1], c = p[2];
    const float f = q[0], g = q[1];
    r[0] = {double}, s[0] = {single};
    (void)a, (void)b, (void)c, (void)f, (void)g;
}}
"""


def instructions(flags: tuple[str, ...], double: str = "a", single: str = "f") -> dict[str, int]:
    """Return the instructions that could round otherwise, of an expression of each precision."""
    return unexpected_instructions(
        compile_to_ptx(SOURCE.format(double=double, single=single), *flags)
    )


OWN_SCENES = [file for file in own_scenes.FILES if file != "funnel.toml"]
"""Examples whose statements are of all kinds; the funnel repeats them for many faces."""

SMALL_SCENES = ["netball.toml", "bowl.toml"]
"""Examples that NVRTC compiles soon, with rolls and without; operations of others are the same."""


@pytest.mark.sampled(1)
@needs_nvrtc
@pytest.mark.parametrize("flag", range(len(FLAGS)))
def test_without_any_of_the_flags_operations_would_round_otherwise(flag: int) -> None:
    double, single = "a * b + c", "sqrtf(f) / g * f + g"
    assert not instructions(FLAGS, double, single)
    other = ("--fmad=true", "--ftz=true", "--prec-div=false", "--prec-sqrt=false")[flag]
    assert instructions((*FLAGS[:flag], other, *FLAGS[flag + 1 :]), double, single)


@needs_nvrtc
def test_nvrtc_makes_a_minimum_of_a_choice_that_gives_another_zero() -> None:
    """PTX's minimum of -0.0 and 0.0 is -0.0, and `a < 0.0 ? a : 0.0` is 0.0; ours hide a value."""
    assert instructions(FLAGS, "a < 0.0 ? a : 0.0") == {"min.f64": 1}
    assert instructions(FLAGS, single="f < 0.0f ? f : 0.0f") == {"min.f32": 1}
    ours = HOOP.source("cuda")["hoop.cu"].partition("/* The parameters of a shot:")[0]
    own = "choose(a < 0.0, a, 0.0) + smaller(b, 0.0) + larger(0.0, c)"
    both = SOURCE.format(double=own, single="smaller(f, 0.0f) + larger(0.0f, g)")
    assert not unexpected_instructions(compile_to_ptx(ours + both, *FLAGS))


def test_an_instruction_that_could_round_otherwise_is_found_by_its_name() -> None:
    ptx = "\n".join(
        f"    {name} %fd1, %fd2, %fd3;"
        for name in (
            *("fma.rn.f64", "mul.f64", "add.ftz.f32", "sqrt.approx.f32", "div.full.f32"),
            *("max.f64", "add.rz.f64", "cvt.rn.ftz.f32.f64", "ex2.approx.ftz.f32", "fma.rn.f16"),
            *("add.rn.f64", "sqrt.rn.f32", "setp.lt.f64", "selp.f32", "ld.f64", "st.global.v2.f32"),
        )
    )
    assert (
        len(unexpected_instructions(ptx + "\n    @%p1 bra $L1;\n    add.s64 %rd1, %rd2, 1;")) == 10
    )


@pytest.mark.slow
@needs_nvrtc
@pytest.mark.parametrize("scene", [HOOP, pytest.param(COURT, marks=pytest.mark.slow)], ids=str)
def test_nvrtc_rounds_every_operation_of_a_scene(scene: Engine) -> None:
    ptx = compile_to_ptx(scene.source("cuda")[f"{scene.name}.cu"], *FLAGS)
    assert not unexpected_instructions(ptx)
    assert "ftz" not in ptx
    assert "approx" not in ptx
    assert "fma" not in ptx
    found = Counter(_INSTRUCTION.findall(ptx))
    for one in ("add", "sub", "mul", "div", "sqrt"):
        assert found[f"{one}.rn.f64"] > 10, one
        assert found[f"{one}.rn.f32"] > 10, one


@needs_nvrtc
@pytest.mark.slow
@pytest.mark.parametrize("file", SMALL_SCENES)
def test_nvrtc_rounds_every_operation_of_a_scene_of_ones_own(file: str) -> None:
    scene = hoopgen.compile(own_scenes.scene_of(file))
    ptx = compile_to_ptx(scene.source("cuda")[f"{scene.name}.cu"], *FLAGS)
    assert not unexpected_instructions(ptx)
    assert "sqrt.rn.f64" in ptx


@pytest.fixture(scope="module")
def device() -> HostCuPy:
    """Return the stand-in for a GPU; each scene is compiled once."""
    return HostCuPy()


def agree(scene: Engine, states: States, device: HostCuPy, **options: object) -> hoopgen.Shots:
    """Check that all results of shots, and their events, are the same bits as in C."""
    layout = scene.layout
    every = layout.fields + layout.bounds
    path = tuple(name for name in layout.fields if not layout.results[name].is_diagnostic)
    with on_host(scene, device):
        for fields in (every, path):
            own, c = (
                scene.simulate(states, fields=fields, backend=b, **options)  # type: ignore[arg-type]
                for b in ("cuda", "c")
            )
            for name in (*fields, *(["events"] if "record" in options else [])):
                left, right = getattr(own, name), getattr(c, name)
                assert left.dtype == right.dtype
                assert left.tobytes() == right.tobytes(), name
    return own


def hoop_families(count: int) -> Iterator[States]:
    """Yield shots of each kind."""
    yield from families(count, 5).values()


WORKLOADS: tuple[Callable[[int], States], ...] = (
    workloads.swish,
    workloads.free_throw,
    workloads.bouncing,
    workloads.swirl,
)


@pytest.mark.slow
@needs_cpp
@needs_compiler
def test_the_source_has_the_bits_of_c_on_a_few_thousand_shots(device: HostCuPy) -> None:
    for make in WORKLOADS:
        assert agree(HOOP, make(2000), device).contacts.dtype == np.int32
    shots = agree(HOOP, np.concatenate(list(hoop_families(100))), device, record=True)
    assert {0, 1, 2} <= set(shots.outcome)
    assert len(shots.events) > len(shots)


@pytest.mark.slow
@needs_cpp
@pytest.mark.parametrize("scene", ["hoop", pytest.param("court", marks=pytest.mark.slow)])
def test_the_source_has_the_bits_of_numpy_on_all_that_an_engine_is_checked_with(
    scene: str, device: HostCuPy
) -> None:
    """Extreme values, parameters of each shot, surfaces that are left, and time limits too."""
    engine, shots = {"hoop": (HOOP, hoop_shots), "court": (COURT, court_shots)}[scene]
    with on_host(engine, device):
        wanted = verification.expected(engine.kernels, shots())
        assert verification.differences(engine.cuda, engine.kernels, wanted) == ""
        assert fingerprint(engine, "cuda") == fingerprint(engine, "numpy")


@needs_cpp
@needs_compiler
@pytest.mark.slow
@pytest.mark.parametrize(("make", "power"), list(zip(WORKLOADS, (20, 20, 20, 18), strict=True)))
def test_the_source_has_the_bits_of_c_on_a_million_shots(
    make: Callable[[int], States], power: int, device: HostCuPy
) -> None:
    agree(HOOP, make(trials(1 << power)), device)


@needs_cpp
@needs_compiler
@pytest.mark.slow
def test_the_source_has_the_bits_of_c_on_all_kinds_of_shots(device: HostCuPy) -> None:
    for states in hoop_families(trials(20_000)):
        agree(HOOP, states, device)


@needs_cpp
@needs_compiler
@pytest.mark.slow
def test_the_court_with_rolls_has_the_bits_of_c(device: HostCuPy) -> None:
    states = all_kinds(trials(2000))
    soft = hoopgen.PAPER_COURT | {f"{body}_restitution": 0.3 for body in COURT.surfaces}
    for parameters in (hoopgen.PAPER_COURT, hoopgen.NBA_COURT, soft):
        shots = agree(COURT, states, device, parameters=parameters, record=True)
    assert shots.rolls.any()
    assert set(shots.events["kind"]) == {0, 1, 2, 3}


@needs_cpp
@needs_compiler
@pytest.mark.slow
@pytest.mark.parametrize("file", OWN_SCENES)
def test_scenes_of_ones_own_have_the_bits_of_c(file: str, device: HostCuPy) -> None:
    scene = hoopgen.compile(own_scenes.scene_of(file))
    states = own_scenes.FILES[file](trials(2000), 4)
    agree(scene, states, device, record=True)
    ranges = partial(np.random.default_rng(6).uniform, 0.98, 1.02, len(states))
    own = {name: value * ranges() for name, value in scene.parameters.items()}
    agree(scene, states, device, parameters=own, leaving=0)


def executed(
    statements: Sequence[Statement], bounds: bool, values: Mapping[str, float]
) -> Iterator[tuple[object, ...]]:
    """Yield what is done if BOUNDS is so, in order, with the numbers of some variables."""
    for statement in statements:
        match statement:
            case If(Name("BOUNDS"), body):
                yield from executed(body if bounds else (), bounds, values)
            case If(_, body) | For(_, _, body):
                yield (statement.test if isinstance(statement, If) else statement.end,)
                yield from executed(body, bounds, values)
                yield ("end",)
            case Call(name, arguments, _):
                named = [a.name if isinstance(a, Name) else "" for a in arguments]
                pairs = zip(arguments, named, strict=True)
                yield (name, *(Number(values[n]) if n in values else a for a, n in pairs))
            case Assign(Name(variable), Member(_, output)):
                yield ("=", variable, output)


@pytest.mark.parametrize(
    "scene", [scenes.HOOP, pytest.param(scenes.COURT, marks=pytest.mark.slow)], ids=lambda s: s.name
)
def test_the_switch_leaves_the_path_alone_and_all_of_the_loop_with_bounds(
    scene: Scene,
) -> None:
    loop = build(scene).loop
    plain, bounded = variants(loop)
    for stage, (nodes, _) in bounded.stages.items():
        own = plain.stages.get(stage, ((), set()))[0]
        both, path, all_of_it = (
            ShotLoop(loop.parameters, parameter_kernels(loop), loop.plain_values).body(*several)
            for several in ((nodes, own), (own,), (nodes,))
        )
        assert list(executed(both, False, loop.plain_values)) == list(executed(path, False, {}))
        steps = [list(executed(one, True, {})) for one in (both, all_of_it)]
        first, second = ([step for step in own if step[0] != "="] for own in steps)
        assert first == second
        # The outputs of a call are assigned in another order: no call reads them in between.
        assert sorted(steps[0], key=str) == sorted(steps[1], key=str)
        assigned = {step[1] for step in executed(both, False, {}) if step[0] == "="}
        assert not assigned & set(loop.plain_values)


@pytest.mark.slow
def test_a_target_of_ones_own_is_a_backend_that_is_registered() -> None:
    """The registry takes what implements `Backend`; it is printed as if it came with hoopgen."""
    register(CudaBackend("own", files={"cuda/scene.cu.j2": "own/{scene}.cu"}))
    try:
        printed = render.render_scene(scenes.HOOP, page=False, targets=["own"])
    finally:
        del BACKENDS["own"]
    committed = (ROOT / "generated/cuda/hoop.cu").read_text(encoding="utf-8")
    assert printed == {"own/hoop.cu": committed}
