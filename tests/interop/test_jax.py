"""Shots as functions of JAX: the bits of `hoopgen.simulate`, and its derivatives."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import hoopgen
from hoopgen.cli import main
from hoopgen.core.variables import STATE
from hoopgen.scene import compilers
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT
from tests.helpers.compiled import needs_compiler
from tests.helpers.effort import trials

pytest.importorskip("jax", reason="the extra jax is missing")

import jax
import jax.numpy as jnp

from hoopgen.interop import jax as door
from hoopgen.interop import xla_handler

pytestmark = needs_compiler

EPS = float(np.finfo(np.float64).eps)
BACKENDS = ("c", "numpy")


@pytest.fixture(autouse=True)
def double_precision() -> Iterator[None]:
    before = jax.config.read("jax_enable_x64")
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@cache
def golf() -> Engine:
    """A scene whose kernels take inputs that are computed from its parameters."""
    return hoopgen.compile(hoopgen.load_scene(ROOT / "examples/scenes/golf.toml"))


def throws(count: int, seed: int = 3) -> Any:
    """Return free throws, most of which touch something, with some that cannot be simulated."""
    random = np.random.default_rng(seed)
    states = hoopgen.release(
        random.normal(7.17, 0.1, count),
        np.radians(random.normal(52, 2, count)),
        np.radians(random.normal(0, 1, count)),
        backspin=random.normal(18, 5, count),
        height=2.1336,
        distance=4.191,
    )
    states[::17, 3] = np.nan
    states[1::29] = 0.0
    states[1::29, 0] = 0.3  # inside the wire or the ball
    return states


def same_bits(shots: Any, found: Any) -> None:
    """Assert that all results have the same types, shapes and bits."""
    for name in shots.scene.layout.fields:
        one, other = getattr(shots, name), np.asarray(getattr(found, name))
        assert (one.dtype, one.shape) == (other.dtype, other.shape), name
        assert one.tobytes() == other.tobytes(), name


@pytest.mark.sampled(2)
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("scene", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_jax_gives_the_bits_of_simulate(scene: Engine, backend: Any) -> None:
    states = throws(trials(400))
    given = {"gravity": np.linspace(9.7, 9.9, len(states)), "ball_radius": 0.12}
    wanted = scene.simulate(states, given)
    simulate = jax.jit(
        lambda states, given: hoopgen.jax.simulate(states, given, scene=scene, backend=backend)
    )
    same_bits(wanted, simulate(states, given))
    same_bits(wanted, hoopgen.jax.simulate(states, given, scene=scene, backend=backend))


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_a_scene_with_inputs_computed_from_parameters_gives_the_same_bits(backend: Any) -> None:
    scene = golf()
    states = throws(60)
    names = list(scene.parameters)
    given = {names[0]: scene.parameters[names[0]] * np.linspace(0.99, 1.01, 60)}
    found = hoopgen.jax.simulate(states, given, scene=scene, backend=backend)
    same_bits(scene.simulate(states, given), found)
    alike = hoopgen.jax.simulate(states, scene=scene, backend=backend)
    same_bits(scene.simulate(states), alike)


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_of_xla_share_a_batch_and_change_no_bit(threads: int) -> None:
    states = throws(20_000)
    found = hoopgen.jax.simulate(states, backend="c", threads=threads)
    same_bits(hoopgen.simulate(states), found)


@pytest.mark.slow
@pytest.mark.parametrize("backend", BACKENDS)
def test_vmap_over_states_parameters_and_both_gives_the_same_bits(backend: Any) -> None:
    states, restitution = throws(30), np.linspace(0.6, 0.8, 4)

    def simulate(states: Any, restitution: Any) -> Any:
        given = {"restitution": restitution, "gravity": 9.8}
        return hoopgen.jax.simulate(states, given, backend=backend)

    every = jax.vmap(simulate, (None, 0))(states, restitution)  # (4, 30)
    single = jax.vmap(simulate, (0, None))(states, restitution[1])  # each state (9,)
    nested = jax.jit(jax.vmap(jax.vmap(simulate, (0, None)), (None, 0)))(states, restitution)
    own = jax.vmap(simulate)(states[:4], restitution)
    for row, value in enumerate(restitution):
        wanted = hoopgen.simulate(states, {"restitution": value, "gravity": 9.8})
        same_bits(wanted, jax.tree.map(lambda array, row=row: array[row], every))
        same_bits(wanted, jax.tree.map(lambda array, row=row: array[row], nested))
        assert own.state[row].tobytes() == wanted.state[row].tobytes()
        if row == 1:
            same_bits(wanted, single)


def test_results_have_the_leading_shape_of_the_states() -> None:
    states = throws(24).reshape(2, 3, 4, 9)
    found = hoopgen.jax.simulate(states, {"gravity": np.full((2, 3, 4), 9.81)})
    assert found.time.shape == (2, 3, 4)
    assert found.counts.shape == (2, 3, 4, 3)
    assert hoopgen.jax.simulate(states[0, 0, 0]).time.shape == ()
    assert hoopgen.jax.simulate(states[:0]).state.shape == (0, 3, 4, 9)
    flat = hoopgen.simulate(states.reshape(-1, 9), {"gravity": 9.81})
    assert np.asarray(found.state).tobytes() == flat.state.tobytes()


def test_limits_of_contacts_and_time_are_those_of_simulate() -> None:
    states = throws(200)
    given: dict[str, Any] = {"max_contacts": 2, "time_limit": 1.2}
    same_bits(hoopgen.simulate(states, **given), hoopgen.jax.simulate(states, **given))


def test_only_the_fields_asked_for_are_there() -> None:
    found = hoopgen.jax.simulate(throws(5), fields=("time", "outcome"))
    assert [leaf.shape for leaf in jax.tree.leaves(found)] == [(5,), (5,)]
    assert np.array_equal(found.made, found.outcome == hoopgen.Outcome.MADE)
    with pytest.raises(AttributeError, match="state: not among the results: outcome, time"):
        _ = found.state
    with pytest.raises(AttributeError, match="ShotArrays has no attribute 'tyme'"):
        _ = found.tyme


# -------------------------------------------------------------------------------- derivatives


def weights(count: int) -> Any:
    return np.random.default_rng(8).normal(size=(count, 9))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("backend", BACKENDS)
def test_jvp_is_hoopgens(backend: Any) -> None:
    states = throws(60)
    tangents = {"vx": weights(60)[:, 0], "restitution": 0.3}
    _, wanted = hoopgen.jvp(states, None, tangents)
    direction = np.zeros_like(states)
    direction[:, STATE.index("vx")] = tangents["vx"]

    def end(states: Any, restitution: Any) -> Any:
        shots = hoopgen.jax.simulate(states, {"restitution": restitution}, backend=backend)
        return shots.state, shots.time

    _, (state, time) = jax.jvp(end, (states, 0.7), (direction, 0.3))
    # The sums of ten products are taken in another order.
    np.testing.assert_allclose(state, wanted["state"], rtol=0, atol=scale(wanted["state"]))
    np.testing.assert_allclose(time, wanted["time"], rtol=0, atol=scale(wanted["time"]))
    assert np.isnan(time).sum() > 3


def scale(values: Any) -> float:
    return 64 * EPS * float(np.nanmax(np.abs(values)))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("backend", BACKENDS)
def test_grad_is_hoopgens_vjp(backend: Any) -> None:
    states = throws(60)
    cotangents = {"state": weights(60), "time": np.linspace(-1, 1, 60)}
    shots, wanted = hoopgen.vjp(states, None, cotangents)

    def loss(states: Any, given: Any) -> Any:
        found = hoopgen.jax.simulate(states, given, backend=backend, undefined="zero")
        rows = jnp.where(found.differentiable[:, None], found.state, 0.0)
        times = jnp.where(found.differentiable, found.time, 0.0)
        return (rows * cotangents["state"]).sum() + (times * cotangents["time"]).sum()

    usual = {name: jnp.asarray(value) for name, value in hoopgen.PAPER.items()}
    by_state, by_parameter = jax.jit(jax.grad(loss, (0, 1)))(states, usual)
    good = shots.differentiable
    columns = np.stack([wanted[name] for name in STATE], axis=1)
    np.testing.assert_allclose(by_state[good], columns[good], rtol=0, atol=scale(columns))
    assert not np.asarray(by_state)[~good].any()
    for name in usual:
        each = wanted[name][good]
        atol = 64 * EPS * float(np.abs(each).sum())
        np.testing.assert_allclose(by_parameter[name], each.sum(), rtol=0, atol=atol)


@pytest.mark.slow
def test_vmap_and_jacobians_of_single_shots_are_the_jacobian_of_simulate() -> None:
    states = throws(12)
    names = (*STATE, "restitution")
    wanted = hoopgen.simulate(states, derivatives=names).jacobian

    def end(state: Any, restitution: Any) -> Any:
        return hoopgen.jax.simulate(state, {"restitution": restitution}).state

    for jacobian in (jax.jacfwd, jax.jacrev):
        by = jax.vmap(jacobian(end, (0, 1)), (0, None))(states, 0.7)
        found = np.concatenate([by[0], by[1][..., None]], axis=-1)
        good = np.isfinite(wanted["state"]).all(axis=(1, 2))
        assert 3 < good.sum() < 12
        assert np.array_equal(found[good], wanted["state"][good])
        assert np.isnan(found[~good]).all()


@pytest.mark.slow
def test_derivatives_of_a_scene_of_ones_own_and_infinite_parameters() -> None:
    states = throws(40)
    scene = golf()
    name = next(iter(scene.parameters))
    value = scene.parameters[name]
    _, wanted = hoopgen.jvp(states, None, {name: 1.0}, scene=scene)
    found = jax.jacfwd(lambda x: hoopgen.jax.simulate(states, {name: x}, scene=scene).time)(value)
    np.testing.assert_array_equal(found, wanted["time"])

    def court(friction: Any) -> Any:
        given = {"ring_friction": friction}
        return hoopgen.jax.simulate(states, given, scene=hoopgen.COURT, undefined="zero").time

    assert not np.asarray(jax.jacfwd(court)(jnp.inf)).any()
    assert np.asarray(jax.jacfwd(court)(0.3)).any()


def test_what_has_no_derivatives_is_nan_or_zero_as_asked() -> None:
    states = throws(200)
    shots = hoopgen.simulate(states, derivatives=("vx",))

    def total(undefined: Any) -> Callable[[Any], Any]:
        return lambda states: hoopgen.jax.simulate(states, undefined=undefined).time.sum()

    by = {undefined: jax.grad(total(undefined))(states) for undefined in ("nan", "zero")}
    good = shots.differentiable
    assert np.isnan(by["nan"])[~good].all()
    assert np.array_equal(by["zero"], np.where(good[:, None], by["nan"], 0.0))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("scene", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_differentiable_is_that_of_simulate(scene: Engine) -> None:
    states = throws(trials(600))
    given = {} if scene is hoopgen.HOOP else hoopgen.NBA_COURT
    shots = scene.simulate(states, given, derivatives=("vx",))
    found = hoopgen.jax.simulate(states, dict(given), scene=scene)
    assert np.array_equal(found.differentiable, shots.differentiable)
    assert 0 < shots.differentiable.sum() < len(states)


@pytest.mark.slow
def test_counts_and_flags_have_no_derivative_and_second_derivatives_raise() -> None:
    states = throws(3)
    out = jax.jvp(
        lambda s: hoopgen.jax.simulate(s, fields=("counts",)).counts, (states,), (states,)
    )
    assert out[1].dtype == jax.dtypes.float0
    total = jax.grad(lambda s: hoopgen.jax.simulate(s).time.sum())
    for second in (jax.jacfwd, jax.jacrev):
        with pytest.raises(NotImplementedError, match="hoopgen has first derivatives only"):
            second(total)(states)
    last = jax.grad(lambda s, scale: (scale**2 * hoopgen.jax.simulate(s).time).sum(), argnums=1)
    np.testing.assert_allclose(
        jax.grad(last, argnums=1)(states, 3.0),
        2 * hoopgen.simulate(states).time.sum(),
        rtol=1e-15,
        atol=0,
    )


# ------------------------------------------------------------------------------ what is refused


def test_single_precision_is_refused() -> None:
    with jax.enable_x64(False), pytest.raises(ValueError, match="jax_enable_x64"):
        hoopgen.jax.simulate(throws(1))


@pytest.mark.parametrize(
    ("states", "options", "error", "said"),
    [
        (np.zeros((4, 8)), {}, ValueError, "states: expected shape (..., 9), got (4, 8)"),
        ("x", {}, TypeError, "states: expected numbers, got 'x'"),
        (np.zeros((4, 9), complex), {}, TypeError, "states: expected real numbers, got complex128"),
        (np.zeros((4, 9)), {"undefined": "one"}, ValueError, "undefined: expected 'nan' or 'zero'"),
        (np.zeros((4, 9)), {"backend": "gpu"}, ValueError, "backend: expected 'auto'"),
        (np.zeros((4, 9)), {"fields": "tyme"}, ValueError, "fields: unknown tyme"),
        (
            np.zeros((4, 9)),
            {"fields": "time_error"},
            ValueError,
            "fields: time_error cannot be had",
        ),
        (np.zeros((4, 9)), {"parameters": {"g": 9}}, ValueError, "parameters: unknown g"),
        (
            np.zeros((4, 9)),
            {"parameters": {"gravity": np.ones(3)}},
            ValueError,
            "parameters['gravity']: expected one number or the shape (4,) of the shots, got",
        ),
    ],
)
def test_bad_arguments_are_named(
    states: Any, options: Any, error: type[Exception], said: str
) -> None:
    with pytest.raises(error) as raised:
        hoopgen.jax.simulate(states, **options)
    assert str(raised.value).startswith(said)


def test_without_a_compiler_python_is_called_and_c_says_why(monkeypatch: Any) -> None:
    def missing(engine: Engine) -> str:
        raise RuntimeError("no C compiler was found; install one, or `pip install ziglang`")

    monkeypatch.setattr(door, "target_of", missing)
    door._simulator.cache_clear()
    states = throws(20)
    try:
        same_bits(hoopgen.simulate(states), hoopgen.jax.simulate(states))
        with pytest.raises(RuntimeError, match="'c' is not possible in JAX: no C compiler"):
            hoopgen.jax.simulate(states, backend="c")
    finally:
        door._simulator.cache_clear()


def test_only_the_cpu_calls_c_and_another_device_calls_python() -> None:
    states = jnp.asarray(throws(4))
    target = xla_handler.target_of(hoopgen.HOOP)
    simulate = jax.jit(lambda states: hoopgen.jax.simulate(states, fields=("time",)).time)
    on_cpu = simulate.lower(states).as_text()
    assert target in on_cpu
    assert "callback" not in on_cpu
    said = str(jax.make_jaxpr(simulate)(states))
    assert "platform_index" in said
    assert said.count("ffi_call[") == said.count("pure_callback[") == 1


@pytest.mark.slow
def test_a_large_batch_by_python_and_its_derivatives_do_not_wait_for_each_other() -> None:
    states = throws(50_000)
    by = jax.jit(jax.grad(lambda s: hoopgen.jax.simulate(s, backend="numpy").time.sum()))
    assert np.isfinite(by(states)).any()
    found = jax.jit(lambda s: hoopgen.jax.simulate(s, backend="numpy"))(states)
    same_bits(hoopgen.simulate(states), found)


def test_the_call_is_compiled_once_and_listed_among_what_is_compiled(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", str(tmp_path))
    runs: list[str] = []
    run = compilers.Compiler.run

    def counted(self: Any, folder: Path, file: str, options: Any = ()) -> tuple[str, bool]:
        runs.append(file)
        return run(self, folder, file, options)

    monkeypatch.setattr(compilers.Compiler, "run", counted)
    built = [xla_handler._compiled.__wrapped__() for _ in range(2)]
    assert built[0] == built[1]
    assert runs == ["xla_call.c"]
    shown = CliRunner().invoke(main, ["cache", "--show"])
    assert "(call of JAX)" in shown.output


def test_a_compiler_that_fails_is_named_in_one_line(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(compilers, "FLAGS", [*compilers.FLAGS, "-fno-such-flag-at-all"])
    with pytest.raises(RuntimeError, match="does not compile the call of XLA: ") as raised:
        xla_handler._compiled.__wrapped__()
    assert "\n" not in str(raised.value)
