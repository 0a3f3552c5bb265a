"""Arrays of other libraries: the same memory, one line for a GPU, and results given back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.core.validation import as_doubles, check_states


def throws(count: int = 50) -> Any:
    random = np.random.default_rng(2)
    speed = random.normal(7.17, 0.1, count)
    return hoopgen.release(speed, 0.9, backspin=18, height=2.13, distance=4.19)


class Packed:
    """An array that has DLPack's interface alone, on a device of one's choice."""

    def __init__(self, array: Any, device: int = 1) -> None:
        self.array, self.device = array, device

    def __dlpack_device__(self) -> tuple[int, int]:
        return self.device, 0

    def __dlpack__(self, **options: Any) -> Any:
        return self.array.__dlpack__(**options)


class Interface:
    """An array that has NumPy's interface alone."""

    def __init__(self, array: Any) -> None:
        self.array = array
        self.__array_interface__ = array.__array_interface__


@pytest.mark.parametrize("kind", [Packed, Interface])
def test_memory_is_taken_and_not_copied(kind: Any) -> None:
    states = throws()
    assert np.shares_memory(check_states(kind(states)), states)
    wanted = hoopgen.simulate(states, {"gravity": np.full(50, 9.8)})
    found = hoopgen.simulate(kind(states), {"gravity": kind(np.full(50, 9.8))})
    assert np.shares_memory(found.releases, states)
    assert found.state.tobytes() == wanted.state.tobytes()


def test_what_is_not_in_rows_is_copied_once() -> None:
    states = np.asfortranarray(throws())
    found = hoopgen.simulate(Packed(states))
    assert found.state.tobytes() == hoopgen.simulate(states).state.tobytes()
    assert not np.shares_memory(found.releases, states)


@pytest.mark.parametrize("device", [2, 8, 10, 14])
def test_an_array_on_a_gpu_is_refused_in_one_line(device: int) -> None:
    states = throws()
    for given in ((Packed(states, device), None), (states, {"gravity": Packed(9.8, device)})):
        with pytest.raises(
            ValueError, match=r"on a GPU, which .* reads; or copy it first"
        ) as raised:
            hoopgen.simulate(*given)
        assert str(raised.value).startswith(("states: ", "parameters['gravity']: "))
        assert "\n" not in str(raised.value)
    with pytest.raises(ValueError, match=r"^leaving: .*on a GPU"):
        hoopgen.simulate(states, leaving=Packed(np.zeros(50, np.int8), device))


def test_pinned_memory_is_the_processors() -> None:
    states = throws()
    assert np.shares_memory(check_states(Packed(states, 3)), states)


def test_pytorch_gives_memory_and_takes_results() -> None:
    torch = pytest.importorskip("torch")
    states = torch.from_numpy(throws())
    assert np.shares_memory(check_states(states), states.numpy())
    found = hoopgen.simulate(states, {"gravity": torch.full((50,), 9.8, dtype=torch.float64)})
    wanted = hoopgen.simulate(states.numpy(), {"gravity": 9.8})
    assert found.time.tobytes() == wanted.time.tobytes()
    for name in ("outcome", "contacts", "counts", "first", "time", "state", "uncertain"):
        tensor = torch.from_dlpack(getattr(found, name))
        assert np.shares_memory(tensor.numpy(), getattr(found, name)), name
    assert np.array_equal(as_doubles("x", torch.ones(3, dtype=torch.float32)), np.ones(3))


def test_a_tensor_that_requires_its_gradient_says_what_to_call() -> None:
    torch = pytest.importorskip("torch")
    states = torch.from_numpy(throws()).requires_grad_()
    with pytest.raises(TypeError, match=r"^states: the array of torch cannot .*detach\(\)"):
        hoopgen.simulate(states)
    with pytest.raises(TypeError, match=r"^states: the array of torch cannot be read: "):
        hoopgen.simulate(torch.ones((3, 9), device="meta"))


def test_jax_gives_memory_and_takes_results() -> None:
    jax = pytest.importorskip("jax")
    before = jax.config.read("jax_enable_x64")
    jax.config.update("jax_enable_x64", True)
    try:
        states = jax.numpy.asarray(throws())
        assert np.shares_memory(check_states(states), np.asarray(states))
        found = hoopgen.simulate(states)
        assert found.time.tobytes() == hoopgen.simulate(np.asarray(states)).time.tobytes()
        taken = jax.numpy.from_dlpack(found.time)
        assert np.asarray(taken).tobytes() == found.time.tobytes()
        with pytest.raises(TypeError, match=r"^states: .*; what JAX traces, hoopgen\.jax"):
            jax.jit(lambda states: hoopgen.simulate(states).time)(states)
    finally:
        jax.config.update("jax_enable_x64", before)
