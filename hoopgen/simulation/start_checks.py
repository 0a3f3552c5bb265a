"""Shots that leave a body which the ball does not touch: they are INVALID."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import Value
from hoopgen.core.start_contact import WAYS, around, start_contact
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.cuda import CudaEngine, to_host

from .backend_choice import Library, find_library

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]

_TIME_LIMIT = 2.0**-30
"""Time limit of shots of which the start alone is of interest, s."""


@dataclass(frozen=True)
class StartCheck:
    """Says which balls can start at which places, as the engines do.

    Attributes
    ----------
    scene
        The scene.
    inputs
        The kernels' inputs, in order, each a number or (n,).
    leaving
        The body that each shot leaves, -1 for none, (n,).
    library
        The C engine; None is NumPy.
    """

    scene: CompiledScene
    inputs: Sequence[Value]
    leaving: NDArray[np.int8]
    library: native.Library | None

    def is_invalid(self, rows: NDArray[np.int64], states: Floats, leaves: bool) -> Bools:
        """Return which of some shots are invalid in other states.

        Parameters
        ----------
        rows
            The shots, (k,).
        states
            Their states, (k, 9).
        leaves
            Whether each leaves its body, or none.
        """
        inputs = [p[rows] if isinstance(p, np.ndarray) else p for p in self.inputs]
        left = np.ascontiguousarray(self.leaving[rows]) if leaves else None
        out = self.scene.layout.allocate(len(rows), ("outcome",))
        if self.library is not None:
            stop = np.zeros(1, np.int32)
            self.library.run(states, inputs, left, 1, out, stop, time_limit=_TIME_LIMIT)
        else:
            given = (states, inputs, left, 1, out)
            with self.scene.exact_arithmetic():
                numpy_backend.run(self.scene.kernels, *given, time_limit=_TIME_LIMIT)
        return np.asarray(out.arrays["outcome"] == self.scene.outcomes["INVALID"])

    def start_contact(self, states: Floats) -> tuple[Bools, Bools]:
        """Return which balls are away from the body that they leave, and which are inside it.

        Parameters
        ----------
        states
            States at the start, (n, 9).
        """
        rows = np.flatnonzero(self.leaving >= 0)

        def overlap(some: NDArray[np.int64], moved: Floats) -> tuple[Bools, Bools]:
            overlaps = self.is_invalid(rows[some], moved, leaves=False)
            return overlaps, ~overlaps | self.is_invalid(rows[some], moved, leaves=True)

        found = np.zeros((2, len(states)), np.bool_)
        found[:, rows] = start_contact(states[rows], self._radius(len(states))[rows], overlap)
        return found[0], found[1]

    def touches_others(self, states: Floats) -> Bools:
        """Return which balls touch other bodies than the one that they leave, and are inside none.

        Parameters
        ----------
        states
            States at the start, (n, 9), of balls that are invalid there.
        """
        rows, radius = np.arange(len(states)), self._radius(len(states))
        free = [~self.is_invalid(rows, around(states, radius, way), True) for way in range(WAYS)]
        return np.asarray(np.any(free, axis=0))

    def _radius(self, shots: int) -> Floats:
        kernels = self.scene.kernels
        column = self.inputs[list(kernels.VARIABLES).index(kernels.BALL_RADIUS)]
        return np.broadcast_to(np.asarray(column, np.float64), shots)


def without_false_starts(
    scene: CompiledScene,
    states: Floats,
    inputs: Sequence[Value],
    leaving: NDArray[np.int8] | None,
    library: Library | None,
) -> Floats:
    """Return states in which balls that do not touch the body that they leave have no place.

    So they are INVALID in each engine.

    Parameters
    ----------
    scene
        The scene.
    states
        States at the start, (n, 9), which may be in the memory of a GPU.
    inputs, leaving
        As of `StartCheck`; None: no shot leaves a body.
    library
        The engine of the shots.
    """
    if leaving is None:
        return states
    if isinstance(library, CudaEngine):
        library = find_library("auto", scene, len(states), bounds=False)
        assert not isinstance(library, CudaEngine)
    there = to_host(states)
    away, inside = StartCheck(scene, inputs, leaving, library).start_contact(there)
    wrong = away | inside
    return np.where(wrong[:, None], np.nan, there) if wrong.any() else states
