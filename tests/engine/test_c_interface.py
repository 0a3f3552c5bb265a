"""The C interface, as its header describes it: each bad argument has a code, and nothing is run."""

from __future__ import annotations

import ctypes
import math
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.engine import native
from hoopgen.engine.c_build import FLAGS
from hoopgen.engine.native import Error
from hoopgen.engine.result_arrays import ResultArrays
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT
from tests.helpers.compiled import compiles, needs_compiler

SHOTS, MOST = 3, 40


@pytest.fixture(params=["hoop", "court"])
def engine(request: pytest.FixtureRequest) -> Engine:
    found = {"hoop": hoopgen.HOOP, "court": hoopgen.COURT}[request.param]
    if found.library is None:
        pytest.skip("the C engine was not built")
    return found


class Call:
    """A call of `share` with arguments that are right, until one is changed."""

    def __init__(self, engine: Engine) -> None:
        library, layout, kernels = engine.library, engine.layout, engine.kernels
        assert library is not None
        self.names = library._arrays
        self.simulate, self._results = library._simulate, library._results
        states = [0.1, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        self.states = np.tile(np.array(states), (SHOTS, 1))
        self.numbers = np.array(list(engine.table.inputs(dict(engine.table.defaults))))
        self.parameters = self.numbers.ctypes.data + 8 * np.arange(len(kernels.PARAMETERS))
        self.strides = np.zeros(len(kernels.PARAMETERS), np.int64)
        self.leaving = np.full(SHOTS, -1, np.int8)
        self.out = layout.allocate(SHOTS, (*layout.fields, *layout.bounds))
        self.out = self.out.joined(layout.allocate_events(SHOTS, MOST, errors=True))
        for array in self.out.arrays.values():
            array.view(np.uint8)[:] = 0xA5
        self.next = ctypes.c_size_t()
        self.given: dict[str, Any] = {
            "shots": SHOTS,
            "states": self.states.ctypes.data,
            "parameters": self.parameters.ctypes.data,
            "strides": self.strides.ctypes.data,
            "leaving": self.leaving.ctypes.data,
            "max_contacts": MOST,
            "time_limit": 5.0,
            "width": 0,
            "stop": None,
            "results": self.results(),
            "next": ctypes.byref(self.next),
            "parts": 1,
        }

    def results(self, *missing: str) -> Any:
        """Return the pointers to the results; the missing ones are NULL."""
        arrays = {k: array for k, array in self.out.arrays.items() if k not in missing}
        places = (arrays[k].ctypes.data if k in arrays else 0 for k in self.names)
        return self._results.pack(*places)

    def __call__(self, **changed: Any) -> int:
        return int(self.simulate(*(self.given | changed).values()))

    def written(self) -> list[str]:
        arrays = self.out.arrays.items()
        return [k for k, array in arrays if not (array.view(np.uint8) == 0xA5).all()]


@pytest.fixture
def call(engine: Engine) -> Call:
    return Call(engine)


def test_a_call_with_arguments_as_described_is_run(call: Call) -> None:
    assert call() in native.WIDTHS
    assert set(call.written()) == set(call.out.arrays)


BAD: list[tuple[dict[str, Any], Error]] = [
    ({"width": -1}, Error.WIDTH),
    ({"width": 2}, Error.WIDTH),
    ({"width": 32}, Error.WIDTH),
    ({"shots": ctypes.c_size_t(-1)}, Error.SHOTS),
    ({"shots": 1 << 60}, Error.SHOTS),
    ({"states": None}, Error.STATES),
    ({"parameters": None}, Error.PARAMETERS),
    ({"strides": None}, Error.STRIDES),
    ({"max_contacts": 0}, Error.MAX_CONTACTS),
    ({"max_contacts": -(2**31)}, Error.MAX_CONTACTS),
    ({"time_limit": math.nan}, Error.TIME_LIMIT),
    ({"time_limit": -1.0}, Error.TIME_LIMIT),
    ({"time_limit": 0.0}, Error.TIME_LIMIT),
    ({"results": None}, Error.RESULTS),
    ({"max_contacts": 2**31 - 1}, Error.EVENTS),
    ({"next": None}, Error.NEXT),
    ({"parts": 0}, Error.PARTS),
]
"""Arguments that are wrong, and the code of each."""


@pytest.mark.parametrize(("changed", "error"), BAD)
def test_a_bad_argument_has_its_own_code(call: Call, changed: dict[str, Any], error: Error) -> None:
    assert call(**changed) == error
    assert call.written() == []


def test_pointers_within_arguments_are_looked_at(call: Call) -> None:
    call.parameters[-1] = 0
    assert call() == Error.PARAMETERS
    call.parameters[-1] = call.parameters[0]
    for wrong in (-1, 2, 8):
        call.strides[-1] = wrong
        assert call() == Error.STRIDES
    call.strides[-1] = 0
    for wrong in (-128, -2, 3, 7, 127):
        call.leaving[-1] = wrong
        assert call() == Error.LEAVING, wrong
    assert call.written() == []


@pytest.mark.parametrize("missing", [*native.LOG[:2], native.LOG[:2]], ids=str)
def test_one_part_of_the_log_is_refused(call: Call, missing: str | tuple[str, ...]) -> None:
    named = [missing] if isinstance(missing, str) else missing
    assert call(results=call.results(*named)) == Error.EVENTS
    assert call.written() == []


def test_what_is_null_is_not_written(call: Call) -> None:
    for name in set(call.out.arrays) - set(native.LOG):
        call.next.value = 0
        call.out.arrays[name].view(np.uint8)[:] = 0xA5
        assert call(results=call.results(name)) in native.WIDTHS
        assert name not in call.written()
    call.next.value = 0
    assert call(results=call.results(*call.names)) in native.WIDTHS
    assert call.next.value == SHOTS


def test_without_shots_or_with_none_left_nothing_is_touched(call: Call) -> None:
    assert call(shots=0, states=None, results=call.results(*call.names)) in native.WIDTHS
    for begun in (SHOTS, SHOTS + 1, 2**64 - 1):
        call.next.value = begun
        assert call(results=call.results()) in native.WIDTHS
        assert call.next.value == begun
    assert call.written() == []


def test_codes_are_those_of_the_header(engine: Engine) -> None:
    name = engine.kernels.SCENE
    header = (ROOT / f"generated/c/{name}.h").read_text(encoding="utf-8")
    found = re.findall(rf"{name.upper()}_ERROR_(\w+) = (-\d+)", header)
    assert {key: int(code) for key, code in found} == {e.name: e.value for e in Error}


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"width": 3}, "width 3: this processor or build does not have it"),
        ({"max_contacts": 0}, "max_contacts: expected at least 1, got 0"),
        ({"time_limit": math.nan}, "time_limit: expected more than 0 s, got nan"),
        ({"leaving": np.full(SHOTS, 7, np.int8)}, "leaving: expected -1 or the index of a surface"),
        ({"share": native.Share(parts=0)}, "share: expected at least 1 part, got 0"),
        (
            {"out": ResultArrays(event_counts=np.zeros(SHOTS, np.int32))},
            "both `events` and `event_counts`",
        ),
    ],
)
def test_python_says_which_argument_is_wrong(
    engine: Engine, changed: dict[str, Any], said: str
) -> None:
    library = engine.library
    assert library is not None
    given: dict[str, Any] = {
        "states": np.zeros((SHOTS, 9)),
        "parameters": engine.table.inputs(dict(engine.table.defaults)),
        "leaving": None,
        "max_contacts": MOST,
        "out": engine.layout.allocate(SHOTS, engine.layout.fields),
        "stop": np.zeros(1, np.int32),
        "time_limit": 5.0,
    }
    with pytest.raises(ValueError, match=re.escape(said)):
        library.run(**given | changed)


SMALL = """
import ctypes, sys, threading
import numpy as np
import hoopgen
from hoopgen.engine import verification

name, stack = sys.argv[1], int(sys.argv[2])
if name == "balls":
    bodies = [
        hoopgen.scene.Sphere(f"ball_{k}", radius=0.1, centre=(0.5 * (k % 12), 0.5 * (k // 12), 0))
        for k in range(120)
    ]
    engine = hoopgen.compile(hoopgen.Scene(
        "balls", parameters=[hoopgen.scene.Parameter("ball", 0.1)], ball_radius="ball",
        gravity=9.81, restitution=0.7, bodies=bodies, ends={"down": hoopgen.scene.End(at=-2)},
    ))
else:
    engine = {"hoop": hoopgen.HOOP, "court": hoopgen.COURT}[name]
library, layout = engine.library, engine.layout
states = np.zeros((600, 9))
states[:, 0] = np.linspace(-0.4, 4.2, 600)
states[:, 2] = 0.4
given = states, engine.table.inputs(dict(engine.table.defaults)), None, 40
widths = verification.available_widths(library, engine.kernels)
found = []

def work():
    for width in widths:
        for fields in ((*layout.fields, *layout.bounds), layout.fields[:3]):
            out = layout.allocate(len(states), fields)
            library.run(*given, out, np.zeros(1, np.int32), width, time_limit=3.0)
            found.append(out.arrays["outcome"].tobytes())

work()
threading.stack_size(stack)
thread = threading.Thread(target=work)
thread.start()
thread.join()
assert len(found) == 4 * len(widths) and len(set(found)) == 1
print("as ever")
"""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["hoop", "court", pytest.param("balls", marks=pytest.mark.slow)])
def test_a_thread_with_little_stack_is_enough(name: str) -> None:
    """musl gives one 128 KB: the working lists are not on it, and frames are small."""
    if hoopgen.HOOP.library is None:
        pytest.skip("the C engine was not built")
    run = subprocess.run(
        [sys.executable, "-c", SMALL, name, str(1 << 17)],
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert (run.returncode, run.stdout) == (0, "as ever\n"), run.stderr


WITHOUT_MEMORY = r"""
#include "hoop.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void *refuse(size_t size)
{
    (void)size;
    return NULL;
}

int main(void)
{
    static const double usual[HOOP_PARAMETERS] = {%s};
    static const double state[HOOP_STATE] = {0.0, 0.0, 1.0};
    const double *parameters[HOOP_PARAMETERS];
    int64_t strides[HOOP_PARAMETERS] = {0};
    uint8_t outcome = 99;
    const hoop_results results = {.outcome = &outcome};
    for (int k = 0; k < HOOP_PARAMETERS; k++)
        parameters[k] = &usual[k];
    const int code = hoop_simulate(1, state, parameters, strides, NULL, 40, INFINITY, 0, NULL,
                                   &results);
    printf("%%d %%d\n", code, outcome);
    return 0;
}
"""


@needs_compiler
@pytest.mark.slow
def test_where_there_is_no_memory_a_call_says_so(tmp_path: Path) -> None:
    source, program = tmp_path / "without.c", tmp_path / "without"
    usual = ", ".join(repr(value) for value in hoopgen.PAPER.values())
    source.write_text(WITHOUT_MEMORY % usual, encoding="utf-8")
    scene = ROOT / "generated" / "c"
    engine = tmp_path / "engine.c"
    text = "#include <stdlib.h>\nvoid *refuse(size_t size);\n#define malloc refuse\n"
    engine.write_text(f'{text}#include "hoop.c"\n', encoding="utf-8")
    flags = (*FLAGS, "-O0", "-DHOOP_ONLY=1", "-Wall", "-Wextra", "-Werror", f"-I{scene}")
    compiles(*flags, source, engine, "-o", program, "-lm")
    run = subprocess.run([program], capture_output=True, text=True, check=False, timeout=60)
    assert (run.returncode, run.stdout) == (0, f"{Error.MEMORY.value} 99\n"), run.stderr
