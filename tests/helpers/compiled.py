"""Compiling C for tests: with the flags of setup.py, and kernels as functions of arrays."""

from __future__ import annotations

import ctypes
import importlib.util
import os
import shutil
import subprocess
import sysconfig
from collections.abc import Iterable, Sequence
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from hoopgen.derive.ir.kernel import Kernel, Kind
from hoopgen.derive.symbolic.conditionals import Boolean
from numpy.typing import NDArray

from hoopgen.codegen.identifiers import identifier
from hoopgen.engine.c_build import FLAGS
from hoopgen.engine.result_arrays import Layout, ResultArrays
from tests.helpers import ROOT

COMPILER = (os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc").split()
WARNINGS = ("-Wall", "-Wextra", "-Wconversion", "-Werror")
# Of -fsanitize=undefined GCC leaves out the conversion of a double that no integer holds.
SANITIZERS = (
    "-O1",
    "-g1",
    "-fsanitize=address,undefined,float-cast-overflow",
    "-fno-sanitize-recover=all",
)
TARGETS = {1: (), 4: (), 8: ("avx2",), 16: ("avx512f", "avx512dq", "avx512vl")}
"""Processor features that each number of lanes needs."""


def _processor() -> frozenset[str]:
    """Return what the processor says that it has; nothing where it is not an x86."""
    try:
        said = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return frozenset()
    flags = next((line for line in said.splitlines() if line.startswith("flags")), "")
    return frozenset(flags.split())


WIDTHS = tuple(width for width, needed in TARGETS.items() if _processor() >= set(needed))
"""Lanes that kernels can be compiled for here."""

needs_compiler = pytest.mark.skipif(
    os.name != "posix" or shutil.which(COMPILER[0]) is None, reason="no C compiler"
)

Floats = NDArray[np.float64]

_HEAD = """\
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#ifdef __x86_64__
#include <immintrin.h>
#endif
#define LANES_PASTE_(name, width) name##_w##width
#define LANES_PASTE(name, width) LANES_PASTE_(name, width)
#define LANES(name) LANES_PASTE(name, LANES_WIDTH)
#define LANES_INLINE static inline
#define LANES_VECTORS 2
"""

_FUNCTION = """
void run_{name}(size_t rows, const double *const *in, double *const *out)
{{
    (void)in;
    for (size_t row = 0; row < rows; row += LANES_WIDTH) {{
{columns}        const LANES({scene}_{name}_out) o = LANES({scene}_{name})({arguments});
{stores}
    }}
}}
"""

_LOAD = "lanes_load(in[{}] + row)"
_NARROW = f"lanes_narrow({_LOAD})"
_TRUTH = f"lanes_not(lanes_equal({_LOAD}, K(0.0)))"
_AS_DOUBLES: dict[Kind, str] = {
    "double": "o.{}",
    "single": "lanes_wide(o.{})",
    "truth": "lanes_select(o.{}, K(1.0), K(0.0))",
}
"""Code that stores an output of each kind."""


def compiles(*arguments: str | Path) -> None:
    """Run the compiler; fail with what it says, whatever locale a test before has left."""
    result = subprocess.run(
        [*COMPILER, *arguments],
        capture_output=True,
        encoding="utf-8",
        errors="replace",
        check=False,
        timeout=900,
    )
    assert result.returncode == 0, result.stderr


def shared_library(source: Path, *flags: str) -> Path:
    """Compile a C file to a shared library beside it."""
    library = source.with_suffix(".so")
    compiles(*FLAGS, *flags, "-shared", "-fPIC", source, "-o", library, "-lm")
    return library


def load_module(source: Path) -> ModuleType:
    """Import a generated module from where it is."""
    spec = importlib.util.spec_from_file_location(source.stem, source)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def lanes() -> str:
    """Return what kernels are written in."""
    return (ROOT / "generated/c/lanes.h").read_text(encoding="utf-8")


class CKernels:
    """The kernels of a generated header, as functions of arrays.

    Parameters
    ----------
    header
        The text of the header.
    kernels
        What is in it.
    scene
        What its names begin with.
    folder
        Where to compile.
    width
        Vector lanes.
    parameters
        The scene's parameters in its order, if kernels are given all of them as columns.
    """

    def __init__(
        self,
        header: str,
        kernels: Iterable[Kernel],
        scene: str,
        folder: Path,
        width: int = 1,
        parameters: Sequence[str] = (),
    ) -> None:
        self._header, self._parameters = header, parameters
        self._kernels = {kernel.name: kernel for kernel in kernels}
        self._width = width
        (folder / f"kernels_w{width}.h").write_text(header, encoding="utf-8")
        source = folder / f"kernels_w{width}.c"
        parts = [_HEAD, f"#define LANES_WIDTH {width}\n", lanes()]
        parts += ["typedef double LANES(column)[LANES_WIDTH];\n"]
        parts += [f'#include "kernels_w{width}.h"\n']
        parts += [self._function(kernel, scene) for kernel in self._kernels.values()]
        source.write_text("".join(parts), encoding="utf-8")
        # Vectors wider than the processor's go through memory: an ABI of this library's own.
        self._library = ctypes.CDLL(
            str(
                shared_library(source, "-O1", *(f"-m{one}" for one in TARGETS[width]), "-Wno-psabi")
            )
        )

    def _function(self, kernel: Kernel, scene: str) -> str:
        # A truth comes and goes as a number that is not zero where it holds.
        given = _NARROW if kernel.single else _LOAD
        names = list(map(identifier, kernel.arguments))
        numbers = {name: k for k, name in enumerate(self._parameters)}
        if f"LANES({scene}_{kernel.name})(const LANES(column) *p" not in self._header:
            numbers = {}
        arguments = [
            (_TRUTH if isinstance(a, Boolean) else given).format(i)
            for i, (a, name) in enumerate(zip(kernel.arguments, names, strict=True))
            if name not in numbers
        ]
        columns = [f"        LANES(column) p[{len(numbers)}];\n"] if numbers else []
        columns += [
            f"        memcpy(p[{numbers[name]}], in[{i}] + row, sizeof *p);\n"
            for i, name in enumerate(names)
            if name in numbers
        ]
        arguments = ["p", "0", *arguments] if numbers else arguments
        values = (
            _AS_DOUBLES[kind].format(name)
            for name, kind in zip(kernel.output_names, kernel.kinds, strict=True)
        )
        stores = (
            f"        lanes_store(out[{i}] + row, {value});" for i, value in enumerate(values)
        )
        return _FUNCTION.format(
            name=kernel.name,
            scene=scene,
            arguments=", ".join(arguments),
            columns="".join(columns),
            stores="\n".join(stores),
        )

    def __call__(self, name: str, columns: Sequence[Floats], rows: int) -> list[Floats]:
        """Evaluate a kernel for every row of its arguments' columns."""
        padded = -rows % self._width
        into = [np.concatenate([column, np.ones(padded)]) for column in columns]
        out = [np.empty(rows + padded) for _ in self._kernels[name].outputs]
        getattr(self._library, f"run_{name}")(
            ctypes.c_size_t(rows + padded), _pointers(into), _pointers(out)
        )
        return [column[:rows] for column in out]


def _pointers(columns: Sequence[Floats]) -> ctypes.Array[ctypes.c_void_p]:
    return (ctypes.c_void_p * len(columns))(*(column.ctypes.data for column in columns))


def same_bits(left: object, right: object) -> NDArray[np.bool_]:
    """Return where two arrays are the same double: a zero keeps its sign, a NaN is any NaN.

    IEEE 754 leaves the sign and payload of a NaN open, and compilers swap operands.
    """
    a, b = (np.asarray(side, dtype=np.float64) for side in (left, right))
    return np.asarray((a.view(np.int64) == b.view(np.int64)) | (np.isnan(a) & np.isnan(b)))


def all_results(module: ModuleType, shots: int, max_contacts: int) -> ResultArrays:
    """Return room for all results of a scene and for its event log."""
    layout = Layout(module)
    events = layout.allocate_events(shots, max_contacts)
    return layout.allocate(shots, layout.results).joined(events)


def sequences(out: ResultArrays) -> list[list[int]]:
    """Return the surfaces that each shot meets, in order."""
    log, used = out.arrays["events"]["surface"], out.arrays["event_counts"]
    return [row[:count].tolist() for row, count in zip(log, used, strict=True)]
