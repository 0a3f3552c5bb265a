"""The CUDA engine through CuPy: each thread of a GPU takes one shot from its release to its end.

NVRTC compiles the generated source on the machine that runs it, with flags that round every
operation as IEEE 754 says. The engine looks at the instructions that NVRTC made before it loads
them, and simulates some hundred shots, which must have NumPy's bits, before it serves.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core import extras

from . import verification
from .result_arrays import LOG, ResultArrays, need_bounds

FLAGS = ("--fmad=false", "--ftz=false", "--prec-div=true", "--prec-sqrt=true")
"""Flags of NVRTC: no fused multiply-add, subnormals as they are, correctly rounded division and
square root. CuPy's own compiler of kernels, `cupy.RawModule`, always adds ``-ftz=true``, which
would change single precision; so NVRTC is called here."""

THREADS = 128
"""Threads of a block."""

MEMORY_SHARE = 0.5
"""Share of the GPU's free memory that the shots of one launch may take. The rest is for what the
driver reserves for each thread that runs, and for the caller."""

MAX_LAUNCH = 1 << 20
"""Most shots of one launch, if their arrays are copied: a run can be interrupted in between."""

OTHERWISE = "use 'c' or 'numpy'"

_EXACT = re.compile(
    r"""(?:add|sub|mul|div|sqrt|rcp)\.rn\.f(?:32|64)       # correctly rounded
    | (?:abs|neg)\.f(?:32|64)                              # exact
    | setp\.\w+\.f(?:32|64) | setp\.\w+\.(?:and|or|xor)\.f(?:32|64) | selp\.f(?:32|64)
    | cvt\.rn\.f32\.f64 | cvt\.f64\.f32                     # single precision
    | cvt\.rn\.f64\.[su]\d+ | cvt\.rzi\.[su]\d+\.f64        # whole numbers
    | (?:mov|(?:ld|st)(?:\.(?:param|global|local|const|shared|nc|v2|v4))*)\.f(?:32|64)""",
    re.VERBOSE,
)
"""Instructions on floating-point numbers that give the bits of IEEE 754, in PTX."""

_INSTRUCTION = re.compile(r"^\s*(?:@!?%\w+\s+)?([a-z][\w.]*\.(?:f16|bf16|f32|f64)[\w.]*)\s", re.M)


def unexpected_instructions(ptx: str) -> dict[str, int]:
    """Return the floating-point instructions of a program that could round otherwise.

    Parameters
    ----------
    ptx
        The program, in PTX.

    Returns
    -------
    dict
        By instruction, how often there is one that is not an IEEE operation with the usual
        rounding, an exact one, a comparison, a choice or a copy: a fused multiply-add, an
        approximation, one that takes subnormals for zero, and a minimum or maximum, which
        takes -0.0 for less than 0.0.
    """
    found = Counter(_INSTRUCTION.findall(ptx))
    return {name: n for name, n in sorted(found.items()) if not _EXACT.fullmatch(name)}


def is_device_array(value: Any) -> bool:
    """Return whether an array is in the memory of a GPU: of CuPy, PyTorch, JAX or the like."""
    if isinstance(value, np.ndarray | float | int | list | tuple) or value is None:
        return False
    if hasattr(value, "__cuda_array_interface__"):
        return True
    place = getattr(value, "__dlpack_device__", None)
    return place is not None and int(place()[0]) in _CUDA_DEVICES


_CUDA_DEVICES = (2, 13)
"""DLPack's numbers for the memory of a GPU, and for memory that a GPU manages."""


def to_host(value: Any) -> Any:
    """Return an array that may be in the memory of a GPU as one of NumPy; others as they are."""
    return load_cupy().asnumpy(_as_cupy(value)) if is_device_array(value) else value


def _as_cupy(value: Any) -> Any:
    """Return an array in the memory of a GPU as CuPy's, without a copy."""
    cupy = load_cupy()
    if hasattr(value, "__cuda_array_interface__"):
        return cupy.asarray(value)
    return cupy.from_dlpack(value)


def load_cupy() -> Any:
    """Return CuPy.

    Raises
    ------
    ImportError
        If it is missing: what brings it.
    """
    return extras.require("cupy", "backend: 'cuda'")


def _first_line(error: BaseException) -> str:
    return (str(error).strip().splitlines() or [type(error).__name__])[0]


class CudaEngine:
    """A scene, compiled for the GPU that is CuPy's current device.

    Parameters
    ----------
    source
        The generated source of the scene.
    kernels
        The generated NumPy module of the scene.

    Raises
    ------
    ImportError
        If CuPy is missing: what brings it.
    RuntimeError
        If there is no GPU.
    """

    def __init__(self, source: str, kernels: ModuleType) -> None:
        self._cupy = load_cupy()
        self._source, self._kernels = source, kernels
        self._names = (*(result.name for result in kernels.RESULTS), *LOG)
        self._functions: dict[tuple[int, bool], Any] = {}
        try:
            if self._cupy.cuda.runtime.getDeviceCount() < 1:
                raise RuntimeError("none is there")
        except RuntimeError as error:
            why = _first_line(error)
            raise RuntimeError(f"backend: 'cuda' finds no GPU ({why}); {OTHERWISE}") from None

    def states(self, states: Any) -> Any:
        """Return releases that are in the memory of the GPU as CuPy's float64 (n, 9), C order.

        Raises
        ------
        TypeError, ValueError
            If they are not float64 of shape (n, 9) or (9,).
        """
        array, width = _as_cupy(states), len(self._kernels.STATE)
        if array.dtype != np.float64:
            raise TypeError(f"states: expected float64 on the GPU, got {array.dtype}")
        if array.ndim == 1:
            array = array[None]
        if array.ndim != 2 or array.shape[1] != width:
            raise ValueError(
                f"states: expected shape (n, {width}) or ({width},), got {tuple(array.shape)}; "
                f"a row is {' '.join(self._kernels.STATE)}"
            )
        here = int(self._cupy.cuda.runtime.getDevice())
        if array.device.id != here:
            raise ValueError(
                f"states: expected in the memory of the current GPU, {here}, and not of "
                f"{array.device.id}; `with cupy.cuda.Device({array.device.id}):` makes it current"
            )
        return self._cupy.ascontiguousarray(array)

    def empty(self, shape: tuple[int, ...], dtype: Any) -> Any:
        """Return an uninitialised array in the memory of the GPU.

        Parameters
        ----------
        shape, dtype
            Its shape and type.

        Raises
        ------
        MemoryError
            If it does not fit.
        """
        try:
            return self._cupy.empty(shape, dtype)
        except MemoryError as error:
            why = f"the GPU has no memory for the results ({_first_line(error)})"
            raise MemoryError(f"backend: {why}; give fewer shots, or fields") from None

    def run(
        self,
        states: Any,
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        max_contacts: int,
        out: ResultArrays,
        stop: NDArray[np.int32],
        width: int = 0,
        time_limit: float = math.inf,
    ) -> None:
        """Simulate shots and write what `out` has room for; arguments as of `native.Library.run`.

        States and results are each in the memory of the GPU, where they stay, or of this machine;
        then blocks of shots are copied, so that any number fits.

        Parameters
        ----------
        width
            0, or 1: a thread has one shot.

        Raises
        ------
        ValueError
            If it is another width.
        MemoryError
            If the GPU has no memory for a shot.
        RuntimeError
            If NVRTC does not compile the scene, or the GPU fails.
        """
        if width not in (0, 1):
            raise ValueError(f"width {width}: a thread of a GPU has one shot")
        shots, start = len(states), 0
        if not shots:
            return
        device = int(self._cupy.cuda.runtime.getDevice())
        function = self._function(device, need_bounds(self._kernels, out.arrays))
        many = self._shots_at_once(states, parameters, leaving, out)
        while start < shots and not stop[0]:
            rows = slice(start, min(start + many, shots))
            given = (states[rows], parameters, leaving, max_contacts, time_limit)
            try:
                self._launch(function, rows, *given, out.rows(rows.start, rows.stop))
            except MemoryError as error:
                if many == 1:
                    why = f"the GPU has no memory for a shot ({_first_line(error)})"
                    raise MemoryError(f"backend: {why}; {OTHERWISE}") from None
                many = max(1, many // 2)
                continue
            except RuntimeError as error:
                raise RuntimeError(f"backend: the GPU fails ({_first_line(error)})") from None
            start = rows.stop

    def _shots_at_once(
        self,
        states: Any,
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        out: ResultArrays,
    ) -> int:
        """Return the number of shots of a launch: all if no array needs a copy, else what fits."""
        copied = [states, *parameters, leaving, *out.arrays.values()]
        each = sum(array.nbytes // len(array) for array in copied if isinstance(array, np.ndarray))
        if not each:
            return len(states)
        free, _ = self._cupy.cuda.runtime.memGetInfo()
        free += self._cupy.get_default_memory_pool().free_bytes()
        return min(MAX_LAUNCH, max(1, int(MEMORY_SHARE * free) // each))

    def _launch(
        self,
        function: Any,
        rows: slice,
        states: Any,
        parameters: Sequence[NDArray[np.float64] | float],
        leaving: NDArray[np.int8] | None,
        max_contacts: int,
        time_limit: float,
        out: ResultArrays,
    ) -> None:
        """Simulate the shots of some rows, of which `states` and `out` are parts."""
        cupy, shots = self._cupy, len(states)
        own = [None if isinstance(p, float) else self._copied(p[rows]) for p in parameters]
        numbers = cupy.asarray(
            np.array([p if isinstance(p, float) else 0.0 for p in parameters], np.float64)
        )
        places = [
            numbers.data.ptr + numbers.itemsize * k if array is None else array.data.ptr
            for k, array in enumerate(own)
        ]
        strides = [int(array is not None) for array in own]
        left = np.uint64(0) if leaving is None else self._copied(leaving[rows])
        # Bytes, since CuPy has no arrays of structures.
        copies = {
            name: cupy.empty(array.nbytes, np.uint8)
            for name, array in out.arrays.items()
            if isinstance(array, np.ndarray)
        }
        arrays: Mapping[str, Any] = {**out.arrays, **copies}
        results = [arrays[name].data.ptr if name in arrays else 0 for name in self._names]
        function(
            (-(-shots // THREADS),),
            (THREADS,),
            (
                *(np.int64(shots), np.int64(rows.start), self._copied(states)),
                *(cupy.asarray(np.array(each, np.int64)) for each in (places, strides)),
                *(left, np.int32(max_contacts), np.float64(time_limit)),
                cupy.asarray(np.array(results, np.int64)),
            ),
        )
        cupy.cuda.get_current_stream().synchronize()
        for name, array in copies.items():
            array.get(out=out.arrays[name].reshape(-1).view(np.uint8))

    def _copied(self, array: Any) -> Any:
        """Return an array in the memory of the GPU, copied if it is not there."""
        if not isinstance(array, np.ndarray):
            return array
        return self._cupy.asarray(np.ascontiguousarray(array))

    def _function(self, device: int, bounds: bool) -> Any:
        """Return the function of a variant of the event loop, compiled for a GPU."""
        key = device, bounds
        if key not in self._functions:
            self._functions[key] = self._compiled(bounds)
        return self._functions[key]

    def _compiled(self, bounds: bool) -> Any:
        """Return the function of a variant of the event loop, compiled for the current GPU.

        Raises
        ------
        RuntimeError
            If NVRTC is missing or fails, or made instructions that could round otherwise.
        """
        cuda, scene = self._cupy.cuda, self._kernels.SCENE
        flags = (*FLAGS, f"-DVARIANT={int(bounds)}", f"-arch=sm_{cuda.Device().compute_capability}")
        try:
            # NVRTC leaves the locale "C" to the thread that called it: files opened after it would
            # be read as ASCII. So it is called in a thread of its own.
            with ThreadPoolExecutor(max_workers=1) as thread:
                ptx, binary = thread.submit(self._translate, flags).result()
        except (RuntimeError, OSError) as error:
            why = f"NVRTC does not compile the scene {scene} ({_first_line(error)})"
            raise RuntimeError(f"backend: {why}; {OTHERWISE}") from None
        text = ptx if isinstance(ptx, str) else ptx.decode()
        if found := unexpected_instructions(text):
            named = ", ".join(f"{count} {name}" for name, count in found.items())
            raise RuntimeError(
                f"backend: NVRTC made instructions of the scene {scene} that may not give NumPy's "
                f"bits ({named}); {OTHERWISE}, and report it, with the scene"
            )
        module = cuda.function.Module()
        module.load(binary)
        return module.get_function(f"{scene}_{'bounded' if bounds else 'plain'}")

    def _translate(self, flags: Sequence[str]) -> tuple[str | bytes, bytes]:
        """Translate the source with NVRTC; return it as text, in PTX, and as a GPU's binary.

        Raises
        ------
        RuntimeError
            If the source is not compiled: what NVRTC says of it.
        """
        nvrtc = self._cupy.cuda.nvrtc
        program = nvrtc.createProgram(self._source, f"{self._kernels.SCENE}.cu", (), ())
        try:
            nvrtc.compileProgram(program, flags)
            return nvrtc.getPTX(program), nvrtc.getCUBIN(program)
        except nvrtc.NVRTCError as error:
            said = nvrtc.getProgramLog(program).strip() or _first_line(error)
            raise RuntimeError(said) from None
        finally:
            nvrtc.destroyProgram(program)


def load_engine(
    source: str, kernels: ModuleType, shots: Callable[[], Sequence[verification.Batch]]
) -> CudaEngine:
    """Return the CUDA engine of a scene, which has given NumPy's bits on this GPU.

    Parameters
    ----------
    source, kernels
        As for `CudaEngine`.
    shots
        Function that returns the shots with which it is compared with NumPy.

    Raises
    ------
    ImportError
        If CuPy is missing: what brings it.
    RuntimeError
        If there is no GPU, the scene cannot be compiled, or its results are not NumPy's.
    """
    engine = CudaEngine(source, kernels)
    if found := verification.differences(engine, kernels, verification.expected(kernels, shots())):
        raise RuntimeError(
            f"backend: 'cuda' does not give NumPy's results on this GPU ({found}); {OTHERWISE}, "
            "and report it, with the name of the GPU"
        )
    return engine
