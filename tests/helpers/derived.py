"""Kernels and engines of a scene that is derived anew, such as one with a fault in its derivation.

A kernel is lowered when it is first wanted, and then evaluated operation by operation: that takes
a hundredth of the time in which all kernels of a scene are printed.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.model import Model, build
from hoopgen.derive.scenes.scene import Scene as Derived
from hoopgen.derive.symbolic.conditionals import IfLess, release
from hoopgen.derive.symbolic.symbols import STATE

from hoopgen.codegen import render
from hoopgen.codegen.identifiers import identifier
from hoopgen.codegen.program import Program, lower
from hoopgen.engine.native import Rejection
from hoopgen.scene import Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.compiled import load_module

OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "div": np.divide,
    "neg": np.negative,
    "sqrt": np.sqrt,
    "abs": np.absolute,
    "max": lambda a, b: np.where(a < b, b, a),
    "min": lambda a, b: np.where(a < b, a, b),
    "less": np.less,
    "at_most": np.less_equal,
    "equal": np.equal,
    "both": np.logical_and,
    "either": np.logical_or,
    "not": np.logical_not,
    "nowhere": lambda: np.False_,
    "select": np.where,
}


def decided(expression: sp.Expr, holds: bool) -> sp.Expr:
    """Return a formula where the conditions of all its choices hold, or do not."""
    chosen = release(expression)
    return chosen.replace(IfLess, lambda left, right, then, other: then if holds else other)


class GenerationError(Exception):
    """A kernel cannot be lowered: that is no check's finding."""


class DerivedKernels:
    """The kernels of a model, as a generated module of NumPy has them.

    Parameters
    ----------
    model
        The scene, derived.
    """

    def __init__(self, model: Model) -> None:
        self._kernels = {kernel.name: kernel for kernel in model.kernels}
        self._symbols = model.scene.symbols
        self._functions: dict[str, Callable[..., Any]] = {}
        self.STATE = tuple(symbol.name for symbol in STATE)
        self.PARAMETERS = {p.name: (p.default, p.unit, p.summary) for p in model.scene.parameters}
        self.VARIABLES = {p.name: identifier(p.symbol) for p in model.scene.parameters}
        self.OUTPUTS = {name: kernel.output_names for name, kernel in self._kernels.items()}
        self.ARGUMENTS = {
            name: tuple(identifier(symbol) for symbol in kernel.arguments)
            for name, kernel in self._kernels.items()
        }

    @classmethod
    def from_scene(cls, scene: Derived) -> DerivedKernels:
        """Return the kernels of a scene."""
        return cls(build(scene))

    def __getattr__(self, name: str) -> Callable[..., Any]:
        if name.startswith("_") or name not in self._kernels:
            raise AttributeError(name)
        if name not in self._functions:
            self._functions[name] = evaluation(self._kernels[name], self._symbols)
        return self._functions[name]


def evaluation(kernel: Kernel, symbols: tuple[Any, ...]) -> Callable[..., tuple[Any, ...]]:
    """Return the function from a kernel's arguments to its outputs.

    Raises
    ------
    GenerationError
        If the kernel cannot be lowered.
    """
    try:
        program: Program = lower(kernel, symbols)
    except Exception as reason:
        raise GenerationError(f"kernel {kernel.name}: {reason}") from reason
    names = [identifier(symbol) for symbol in kernel.arguments]
    number: Any = np.float32 if program.single else np.float64

    def evaluate(*given: Any) -> tuple[Any, ...]:
        values = dict(zip(names, given, strict=True))
        done: list[Any] = []
        with np.errstate(all="ignore"):
            for operation in program.operations:
                if operation.name == "argument":
                    done.append(np.asarray(values[operation.symbol], number)[()])
                elif operation.name == "truth":
                    done.append(np.asarray(values[operation.symbol], bool)[()])
                elif operation.name == "constant":
                    done.append(number(operation.value))
                else:
                    operands = (done[operand] for operand in operation.operands)
                    done.append(OPERATIONS[operation.name](*operands))
        return tuple(done[output] for output in program.outputs)

    return evaluate


def engine_of(scene: Scene | Derived, folder: Path) -> Engine:
    """Return what simulates a scene on NumPy, derived and printed now."""
    written = scene if isinstance(scene, Scene) else None
    derived = scene.derive() if isinstance(scene, Scene) else scene
    files = render.render_scene(derived, page=False, targets=("numpy",))
    path = folder / f"{derived.name}.py"
    path.write_text(files[f"numpy/{derived.name}.py"], encoding="utf-8")
    return Engine(
        load_module(path),
        find=lambda: Rejection("is not wanted here", ""),
        sources=lambda target: {},
        scene=lambda: derived,
        written=written,
    )
