"""A stand-in for CuPy: the CUDA source compiled for this processor, and arrays as a GPU's.

A machine without a GPU runs the same source and the same driver with it. The source is compiled
behind a head that says what a thread and its number are; then one thread comes after another.
"""

from __future__ import annotations

import atexit
import ctypes
import os
import shutil
import subprocess
import sys
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import mkdtemp
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from hoopgen.engine import cuda
from hoopgen.engine.c_build import FLAGS
from hoopgen.engine.compiled_scene import CompiledScene

COMPILER = (os.environ.get("CXX") or "c++").split()
# All flags of C but those of the language and of speed: that everything is inlined takes long.
_FLAGS = [flag for flag in FLAGS if flag not in ("-O3", "-std=c11")]


def has_compiler() -> bool:
    """Return whether there is a C++ compiler."""
    return os.name == "posix" and shutil.which(COMPILER[0]) is not None


needs_cpp = pytest.mark.skipif(not has_compiler(), reason="no C++ compiler")

_HEAD = """\
#include <math.h>
#include <stddef.h>
#include <string.h>
#define __global__
#define __device__
#define __forceinline__ inline
struct place { unsigned x; };
static thread_local place blockIdx, blockDim, threadIdx;
static inline double __longlong_as_double(long long bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
"""

_LAUNCH = """
extern "C" void launch_{name}(
    unsigned blocks, unsigned threads, long long shots, long long first, const double *states,
    const double *const *values, const long long *strides, const signed char *leaving,
    int contacts, double time_limit, void *const *results)
{{
    blockDim.x = threads;
    for (blockIdx.x = 0; blockIdx.x < blocks; blockIdx.x++)
        for (threadIdx.x = 0; threadIdx.x < threads; threadIdx.x++)
            {name}(shots, first, states, values, strides, leaving, contacts, time_limit, results);
}}
"""


def compiled_for_host(source: str, scene: str, folder: Path, *flags: str) -> Path:
    """Compile the source of a scene for this processor, with both variants of its event loop."""
    names = [f"{scene}_{variant}" for variant in ("plain", "bounded")]
    own = f"#define VARIANT {flags[0][-1]}\n" if flags else ""
    names = [names[int(flags[0][-1])]] if flags else names
    path = folder / f"{scene}.cpp"
    text = [own, _HEAD, source, *(_LAUNCH.format(name=name) for name in names)]
    path.write_text("".join(text), encoding="utf-8")
    library = path.with_suffix(".so")
    level = "-O1" if scene in ("hoop", "court") else "-O0"  # these fly millions of shots
    asked = [*COMPILER, "-std=c++17", level, *_FLAGS, "-shared", "-fPIC", path, "-o", library]
    result = subprocess.run(asked, capture_output=True, text=True, check=False, timeout=900)
    assert result.returncode == 0, result.stderr
    return library


class OutOfMemoryError(MemoryError):
    """The stand-in has no more memory."""


class DeviceArray:
    """An array that NumPy does not take for one of its own, as one of CuPy."""

    def __init__(self, host: np.ndarray[Any, Any]) -> None:
        self._host = host
        self.shape, self.dtype, self.ndim = host.shape, host.dtype, host.ndim
        self.nbytes, self.itemsize = host.nbytes, host.itemsize
        self.data = SimpleNamespace(ptr=host.ctypes.data)
        self.device = SimpleNamespace(id=0)
        self.__cuda_array_interface__ = host.__array_interface__

    def __dlpack_device__(self) -> tuple[int, int]:
        return 2, 0

    def __len__(self) -> int:
        return len(self._host)

    def __getitem__(self, key: Any) -> DeviceArray:
        return DeviceArray(self._host[key])

    def __eq__(self, other: object) -> Any:
        return DeviceArray(self._host == other)

    __hash__ = None  # type: ignore[assignment]

    def __array__(self, *_: Any, **__: Any) -> Any:
        raise TypeError("Implicit conversion to a NumPy array is not allowed.")

    def get(self, out: Any = None) -> Any:
        """Return a copy of NumPy's."""
        if out is None:
            return self._host.copy()
        assert out.flags.c_contiguous
        out[...] = self._host
        return out


class HostCuPy:
    """The part of CuPy that the driver uses.

    Parameters
    ----------
    memory
        Bytes that arrays may take.
    instructions
        What stands for the program in PTX.
    """

    ndarray = DeviceArray

    def __init__(self, memory: int = 1 << 40, instructions: str = "") -> None:
        self.memory, self.used, self.launches = memory, 0, list[int]()
        self.flags = list[tuple[str, ...]]()
        self.devices = 1
        self.engines: dict[str, cuda.CudaEngine] = {}
        self._instructions, self._folder = instructions, Path(mkdtemp(prefix="host_cuda"))
        atexit.register(shutil.rmtree, self._folder, ignore_errors=True)
        self.cuda = SimpleNamespace(
            runtime=SimpleNamespace(
                getDeviceCount=lambda: self.devices,
                getDevice=lambda: 0,
                memGetInfo=lambda: (self.memory - self.used, self.memory),
            ),
            Device=lambda: SimpleNamespace(compute_capability="80"),
            nvrtc=SimpleNamespace(
                NVRTCError=subprocess.SubprocessError,
                createProgram=lambda source, name, headers, included: [source, name, b""],
                compileProgram=self._compile,
                getPTX=lambda program: self._instructions.encode(),
                getCUBIN=lambda program: program[2],
                getProgramLog=lambda program: "",
                destroyProgram=lambda program: None,
            ),
            function=SimpleNamespace(Module=lambda: _Module(self)),
            get_current_stream=lambda: SimpleNamespace(synchronize=lambda: None),
        )

    def _compile(self, program: list[Any], flags: tuple[str, ...]) -> None:
        self.flags.append(flags)
        scene = program[1].removesuffix(".cu")
        (variant,) = (flag for flag in flags if flag.startswith("-DVARIANT="))
        folder = Path(mkdtemp(dir=self._folder))  # a library of a known path is not loaded again
        program[2] = bytes(compiled_for_host(program[0], scene, folder, variant))

    def _new(self, host: np.ndarray[Any, Any]) -> DeviceArray:
        if self.used + host.nbytes > self.memory:
            raise OutOfMemoryError(f"Out of memory allocating {host.nbytes:,} bytes\nand more")
        self.used += host.nbytes
        weakref.finalize(host, self._free, host.nbytes)
        return DeviceArray(host)

    def _free(self, size: int) -> None:
        self.used -= size

    def asarray(self, array: Any) -> DeviceArray:
        """Return an array of the device; one that is there as it is."""
        return array if isinstance(array, DeviceArray) else self._new(np.array(array, order="C"))

    ascontiguousarray = asarray

    def asnumpy(self, array: DeviceArray) -> Any:
        """Return a copy of NumPy's."""
        return array.get()

    def empty(self, shape: Any, dtype: Any) -> DeviceArray:
        """Return an uninitialised array."""
        assert np.dtype(dtype).names is None, "CuPy has no arrays of structures"
        return self._new(np.empty(shape, dtype))

    def get_default_memory_pool(self) -> Any:
        """Return what has memory that is free for the next array."""
        return SimpleNamespace(free_bytes=lambda: 0)


class _Module:
    def __init__(self, device: HostCuPy) -> None:
        self._device = device

    def load(self, binary: bytes) -> None:
        """Load what was compiled."""
        self._library = ctypes.CDLL(binary.decode())

    def get_function(self, name: str) -> Any:
        """Return a function that is launched with a grid, a block and arguments."""
        function = getattr(self._library, f"launch_{name}")

        def launch(grid: tuple[int], block: tuple[int], given: tuple[Any, ...]) -> None:
            self._device.launches.append(int(given[0]))
            function(ctypes.c_uint(*grid), ctypes.c_uint(*block), *map(_argument, given))

        return launch


def _argument(value: Any) -> Any:
    """Return an argument as ctypes has it: a pointer, or a number of its own size."""
    if isinstance(value, DeviceArray):
        return ctypes.c_void_p(value.data.ptr)
    return np.ctypeslib.as_ctypes_type(value.dtype)(value.item())


@contextmanager
def on_host(scene: CompiledScene, device: HostCuPy | None = None) -> Iterator[HostCuPy]:
    """Have backend "cuda" of a scene run on this processor meanwhile; yield the stand-in."""
    device = device or HostCuPy()
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "cupy", device)
        if scene.name not in device.engines:
            source = scene.source("cuda")[f"{scene.name}.cu"]
            device.engines[scene.name] = cuda.CudaEngine(source, scene.kernels)
        patch.setitem(scene.__dict__, "cuda", device.engines[scene.name])
        yield device
