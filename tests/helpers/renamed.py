"""The operations of a scene's kernels, where SymPy sees other names than ours: run as a program.

    python -m tests.helpers.renamed names tests.helpers.scenes.rings:RINGS

SymPy sorts terms and factors by names, and so do some of its functions. Here it sees every symbol
under a name whose place in the alphabet is turned about, and held quantities by another function.
"""

from __future__ import annotations

import hashlib
import importlib
import json
import string
import sys
from types import FrameType
from typing import TYPE_CHECKING

import sympy as sp

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene

LETTERS = string.ascii_lowercase + string.digits + "_"
TURNED = str.maketrans(LETTERS, LETTERS[::-1])

Digests = dict[str, list[str]]


def _sympy_asks(frame: FrameType) -> bool:
    asking: FrameType | None = frame
    while asking is not None and asking.f_code.co_name == "__format__":
        asking = asking.f_back
    return asking is not None and asking.f_globals["__name__"].startswith("sympy")


def turn_names() -> None:
    """Show SymPy other names than everybody else; to be called before a symbol is made."""
    slot, text = sp.Symbol.__dict__["name"], sp.Symbol.__str__

    def name(self: sp.Symbol) -> str:
        own = str(slot.__get__(self))
        return f"s{own.translate(TURNED)}" if _sympy_asks(sys._getframe(1)) else own

    def written(self: sp.Symbol) -> str:
        return str(text(self) if _sympy_asks(sys._getframe(1)) else slot.__get__(self))

    sp.Symbol.name = property(name, slot.__set__)
    sp.Symbol.__str__ = written
    held = importlib.import_module("hoopgen.derive.symbolic.conditionals").Barrier
    held.__name__ = held.__name__[::-1]


def operations(scene: Scene) -> Digests:
    """Return a digest of all that is done for each output, by kernel."""
    model = importlib.import_module("hoopgen.derive.model").build(scene)
    lower = importlib.import_module("hoopgen.codegen.program").lower
    found: Digests = {}
    for kernel in model.kernels:
        program = lower(kernel, scene.symbols)
        digests: list[str] = []
        for done in program.operations:
            parts = (done.name, done.symbol, done.value.hex(), *(digests[k] for k in done.operands))
            digests.append(hashlib.sha256(" ".join(parts).encode()).hexdigest())
        found[kernel.name] = [digests[k] for k in program.outputs]
    return found


if __name__ == "__main__":
    if sys.argv[1] == "names":
        turn_names()
    module, _, scene_name = sys.argv[2].partition(":")
    json.dump(operations(getattr(importlib.import_module(module), scene_name)), sys.stdout)
