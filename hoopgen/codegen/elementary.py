"""The elementary functions of no scene, for arrays in C and in NumPy."""

from __future__ import annotations

from dataclasses import dataclass, replace

from hoopgen.derive.elementary import KERNELS, PARTS
from hoopgen.derive.scenes import SCENES
from hoopgen.derive.studies import DRAWING
from hoopgen.derive.studies.noise import RANDOM_BITS
from hoopgen.derive.studies.release import ARGUMENTS
from hoopgen.derive.symbolic.symbols import STATE

from .backend import KernelView
from .c.spelling import SCALARS
from .formatter import Formatter
from .numpy.formatter import ROWS_FORMATTER
from .numpy.spelling import NUMPY
from .program import derivation_hash, lower
from .stamp import shared_stamp_of
from .straight_line import PrintedBody, print_body, straight_line

FILES = {
    "numpy/elementary.py.j2": "numpy/elementary.py",
    "c/elementary_functions.h.j2": "c/elementary_functions.h",
    "c/philox.h.j2": "c/philox.h",
    "c/drawing.h.j2": "c/drawing.h",
    "c/elementary.c.j2": "c/elementary.c",
}
"""By template, the file that it makes below generated/."""

# The compiler makes vectors of a conjunction without a branch.
_WITHOUT_BRANCHES = {"both": "({0} & {1})", "either": "({0} | {1})"}
_C = replace(SCALARS, operations={**SCALARS.operations, **_WITHOUT_BRANCHES})
_C_FORMATTER = Formatter(_C, _C, "const {type} {name} = {value};")


@dataclass(frozen=True)
class ElementaryFunction(KernelView):
    """A view of an elementary function for templates."""

    @property
    def body(self) -> PrintedBody:
        """Its statements and results in C, for one number of each argument."""
        return print_body(straight_line(self.program, _C), _C_FORMATTER)

    @property
    def numpy(self) -> PrintedBody:
        """Its statements and results in NumPy."""
        return print_body(straight_line(self.program, NUMPY), ROWS_FORMATTER)


def elementary_context(template: str) -> dict[str, object]:
    """Return the variables of a template of the elementary functions."""
    lowered = [lower(kernel) for kernel in KERNELS]
    parts, drawing = (
        {kernel.name: ElementaryFunction(lower(kernel)) for kernel in own}
        for own in (PARTS, DRAWING)
    )
    return {
        "kernels": [ElementaryFunction(program) for program in lowered],
        "parts": parts,
        "drawing": drawing,
        "random_bits": RANDOM_BITS,
        "release_arguments": [symbol.name for symbol in ARGUMENTS],
        "state": [symbol.name for symbol in STATE],
        "derivation": derivation_hash(lowered),
        "stamp": shared_stamp_of(template, SCENES[0]),
    }
