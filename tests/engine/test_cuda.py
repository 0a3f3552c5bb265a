"""The driver of CUDA, with a stand-in for CuPy and a GPU: where arrays are, blocks, and errors."""

from __future__ import annotations

import locale
import sys
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import hoopgen
from benchmarks.workloads import bouncing, free_throw
from hoopgen import HOOP
from hoopgen.cli import main
from hoopgen.core.extras import MissingExtra
from hoopgen.engine import cuda
from hoopgen.simulation.hoop import hoop_shots
from tests.helpers.host_cuda import DeviceArray, HostCuPy, needs_cpp, on_host
from tests.helpers.nvrtc import compile_to_ptx_here, needs_nvrtc

# One worker: the hoop is compiled once.
pytestmark = [pytest.mark.xdist_group("cuda"), needs_cpp]

SHOTS = 3000


@pytest.fixture(scope="module")
def device() -> HostCuPy:
    """Return the stand-in for a GPU."""
    return HostCuPy()


@pytest.fixture
def small(device: HostCuPy) -> Any:
    """Yield the stand-in with some kilobytes of memory; compiled scenes are shared."""
    device.launches.clear()
    device.memory = device.used + 400_000
    yield device
    device.memory = 1 << 40


def same(left: hoopgen.Shots, right: hoopgen.Shots) -> bool:
    """Return whether all results have the same bits."""
    assert left._fields.keys() == right._fields.keys()
    return all(left._fields[n].tobytes() == right._fields[n].tobytes() for n in right._fields)


@pytest.mark.slow
def test_a_batch_beyond_the_memory_goes_in_blocks(small: HostCuPy) -> None:
    states = free_throw(SHOTS)
    own = {"gravity": np.linspace(9.7, 9.9, SHOTS), "restitution": 0.6}
    left = np.arange(SHOTS) % 4 - 1
    options: dict[str, Any] = {"parameters": own, "leaving": left, "time_limit": 2.0}
    with on_host(HOOP, small):
        found = HOOP.simulate(states, backend="cuda", **options)
    assert sum(small.launches) == SHOTS
    assert len(small.launches) > 2
    assert same(found, HOOP.simulate(states, backend="numpy", **options))


@pytest.mark.slow
def test_a_log_beyond_the_memory_goes_in_blocks(small: HostCuPy) -> None:
    states = bouncing(200)
    with on_host(HOOP, small):
        found = HOOP.simulate(states, backend="cuda", record=True, max_contacts=200)
    assert len(small.launches) > 2
    assert same(found, HOOP.simulate(states, backend="numpy", record=True, max_contacts=200))
    path = found.trajectory(150)
    assert path.duration == found.time[150] or np.isnan(found.time[150])


@pytest.mark.slow
def test_a_block_that_does_not_fit_after_all_is_halved(
    small: HostCuPy, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cuda, "MEMORY_SHARE", 8.0)
    states = free_throw(SHOTS)
    with on_host(HOOP, small):
        found = HOOP.simulate(states, backend="cuda")
    assert same(found, HOOP.simulate(states, backend="numpy"))


@pytest.mark.slow
def test_without_memory_for_a_shot_the_error_is_one_line(device: HostCuPy) -> None:
    device.memory = device.used + 100
    try:
        with on_host(HOOP, device), pytest.raises(MemoryError) as caught:
            HOOP.simulate(free_throw(3), backend="cuda")
    finally:
        device.memory = 1 << 40
    (line,) = str(caught.value).splitlines()
    assert line.startswith("backend: the GPU has no memory for a shot (Out of memory allocating")
    assert line.endswith("use 'c' or 'numpy'")


def test_states_on_the_gpu_have_results_there(device: HostCuPy) -> None:
    states = free_throw(SHOTS)
    own = {"gravity": np.linspace(9.7, 9.9, SHOTS)}
    there = device.asarray(states)
    device.launches.clear()
    with on_host(HOOP, device):
        held = HOOP.simulate(
            there, {"gravity": device.asarray(own["gravity"])}, backend="cuda", fields="all"
        )
    here = HOOP.simulate(states, own, backend="numpy")
    assert device.launches == [SHOTS]
    assert all(isinstance(array, DeviceArray) for array in held._fields.values())
    assert isinstance(held.made, DeviceArray)
    assert held.made.get().tobytes() == here.made.tobytes()
    assert held.releases.data.ptr == there.data.ptr  # not copied
    assert repr(held).startswith("Shots(3,000 shots in the memory of a GPU: outcome, ")
    assert same(held.to_numpy(), here)
    assert held.to_numpy().releases.tobytes() == states.tobytes()
    assert here.to_numpy() is here
    assert held.to_pandas().equals(here.to_pandas())


@pytest.mark.slow
def test_one_shot_on_the_gpu_is_a_row(device: HostCuPy) -> None:
    with on_host(HOOP, device):
        found = HOOP.simulate(device.asarray(free_throw(1)[0]), backend="cuda", fields="state")
    assert found.state.shape == (1, 9)


@pytest.mark.parametrize(
    ("states", "options", "error", "message"),
    [
        (free_throw(4), {"backend": "c"}, ValueError, r"states: expected .* on a GPU, which simu"),
        (free_throw(4), {"backend": "auto"}, ValueError, r"backend='cuda'\) reads; or copy it"),
        (free_throw(4), {"record": True}, ValueError, "record: expected with states of NumPy"),
        (free_throw(4), {"settle": True}, ValueError, "settle: expected with states of NumPy"),
        (free_throw(4), {"derivatives": ("vx",)}, ValueError, "derivatives: expected with states"),
        (free_throw(4)[:, :8], {}, ValueError, r"states: expected shape \(n, 9\) or \(9,\), got"),
        (free_throw(4).astype("f4"), {}, TypeError, "expected float64 on the GPU, got float32"),
    ],
)
def test_what_states_on_the_gpu_cannot_have_is_refused(
    states: Any, options: Any, error: type[Exception], message: str, device: HostCuPy
) -> None:
    with on_host(HOOP, device), pytest.raises(error, match=message):
        HOOP.simulate(device.asarray(states), **{"backend": "cuda", **options})


def test_states_of_another_gpu_are_refused(device: HostCuPy) -> None:
    states = device.asarray(free_throw(4))
    states.device = SimpleNamespace(id=1)
    with on_host(HOOP, device), pytest.raises(ValueError, match="current GPU, 0, and not of 1"):
        HOOP.simulate(states, backend="cuda")


def test_no_shots_launch_nothing(device: HostCuPy) -> None:
    device.launches.clear()
    with on_host(HOOP, device):
        assert len(HOOP.simulate(np.empty((0, 9)), backend="cuda")) == 0
    assert not device.launches


def test_without_cupy_the_error_says_what_brings_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cupy", None)
    with pytest.raises(MissingExtra, match=r"backend: 'cuda' needs cupy: pip install .*cuda"):
        HOOP.simulate(free_throw(3), backend="cuda")
    place = ("--speed", "7", "--elevation", "52deg", "--height", "2", "--distance", "4")
    said = CliRunner().invoke(main, ["shot", *place, "--backend", "cuda"])
    assert said.exit_code
    assert "needs cupy" in said.output + str(said.exception)


def test_without_a_gpu_the_error_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    device = HostCuPy()
    device.devices = 0
    monkeypatch.setitem(sys.modules, "cupy", device)
    with pytest.raises(
        RuntimeError, match=r"^backend: 'cuda' finds no GPU \(none is there\); use 'c' or 'numpy'$"
    ):
        HOOP.simulate(free_throw(3), backend="cuda")


@pytest.mark.slow
def test_instructions_that_could_round_otherwise_are_not_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    device = HostCuPy(instructions="\n    fma.rn.f64 %fd1, %fd2, %fd3, %fd4;\n")
    monkeypatch.setitem(sys.modules, "cupy", device)
    with pytest.raises(RuntimeError, match=r"may not give NumPy's bits \(1 fma.rn.f64\); use"):
        HOOP.simulate(free_throw(3), backend="cuda")
    assert device.flags[0] == (*cuda.FLAGS, "-DVARIANT=1", "-arch=sm_80")
    assert not device.launches


def test_a_source_that_nvrtc_refuses_is_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    device = HostCuPy()

    def refused(program: Any, flags: Any) -> None:
        raise device.cuda.nvrtc.NVRTCError("NVRTC_ERROR_COMPILATION (6)")

    device.cuda.nvrtc.compileProgram = refused
    device.cuda.nvrtc.getProgramLog = lambda program: "hoop.cu(1): error: no such thing\n  line\n"
    monkeypatch.setitem(sys.modules, "cupy", device)
    with pytest.raises(
        RuntimeError, match=r"compile the scene hoop \(hoop.cu\(1\): error: no such thing\); use"
    ):
        HOOP.simulate(free_throw(3), backend="cuda")


@needs_nvrtc
def test_the_locale_that_nvrtc_leaves_is_not_the_callers(monkeypatch: pytest.MonkeyPatch) -> None:
    device, before = HostCuPy(), locale.getencoding()
    inside: list[str] = []

    def refused(program: Any, flags: Any) -> None:
        compile_to_ptx_here("__global__ void kernel(double *x) { *x = 1.0; }")
        inside.append(locale.getencoding())
        raise device.cuda.nvrtc.NVRTCError("NVRTC_ERROR_COMPILATION (6)")

    device.cuda.nvrtc.compileProgram = refused
    monkeypatch.setitem(sys.modules, "cupy", device)
    with pytest.raises(RuntimeError, match="NVRTC does not compile the scene hoop"):
        HOOP.simulate(free_throw(3), backend="cuda")
    assert inside == ["ANSI_X3.4-1968"], "NVRTC changes nothing any more"
    assert locale.getencoding() == before


@pytest.mark.slow
def test_an_engine_with_other_bits_does_not_serve(
    device: HostCuPy, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A coefficient of restitution that is off by one unit in the last place is noticed."""
    monkeypatch.setitem(sys.modules, "cupy", device)
    source = HOOP.source("cuda")["hoop.cu"]
    fault = "p_restitution = parameter(_given, 8) * 1.0000000000000002;"
    wrong = source.replace("p_restitution = parameter(_given, 8);", fault)
    assert wrong.count(fault) == 1
    with pytest.raises(RuntimeError, match=r"NumPy's results on this GPU \(width 1: .*state"):
        cuda.load_engine(wrong, HOOP.kernels, hoop_shots)


def _has_gpu() -> bool:
    try:
        import cupy
    except ImportError:
        return False
    try:
        return bool(cupy.cuda.runtime.getDeviceCount())
    except RuntimeError:
        return False


@pytest.mark.skipif(not _has_gpu(), reason="no GPU with CuPy")
def test_a_gpu_has_the_bits_of_numpy() -> None:
    cupy = cuda.load_cupy()
    states = np.concatenate([free_throw(SHOTS), bouncing(SHOTS)])
    here = HOOP.simulate(states, backend="numpy", record=True)
    assert same(HOOP.simulate(states, backend="cuda", record=True), here)
    there = HOOP.simulate(cupy.asarray(states), backend="cuda").to_numpy()
    assert same(there, HOOP.simulate(states, backend="numpy"))
