"""The shots whose flags and error bounds are proved, and not estimated."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import Value
from hoopgen.core.variables import STATE
from hoopgen.engine.compiled_scene import CompiledScene


@dataclass(frozen=True)
class ProofPremises:
    """The premises of a batch's bounds that its releases and parameters do not contain.

    Attributes
    ----------
    leaving
        The body that each ball leaves at the start, -1 for none, (n,); None: all are in flight.
    settled
        The shots whose results are those of the judge.
    """

    leaving: NDArray[np.int8] | None
    settled: NDArray[np.int64]

    def proved(
        self,
        scene: CompiledScene,
        field: Callable[[str], NDArray[Any]],
        states: NDArray[np.float64],
        parameters: Mapping[str, Value],
    ) -> NDArray[np.bool_]:
        """Return which shots fulfil the premises of the theorem, or are proved by the judge, (n,).

        Parameters
        ----------
        scene
            The scene.
        field
            A function from the name of a result to its array, (n,): `contacts` is asked for, and
            `estimated` where the bounds of some shots are.
        states
            The releases, (n, 9).
        parameters
            The parameters by name, a number or (n,) each.
        """
        found = np.zeros(len(states), np.bool_)
        kernels = scene.kernels
        if hasattr(kernels, "premises"):
            given = dict(zip(STATE, states.T, strict=True))
            given |= zip(kernels.VARIABLES.values(), scene.table.inputs(parameters), strict=True)
            given["contacts"] = field("contacts").astype(np.float64)
            with np.errstate(all="ignore"):
                arguments = (given[name] for name in kernels.ARGUMENTS["premises"])
                (found[:],) = kernels.premises(*arguments)
            if self.leaving is not None:
                found &= self.leaving < 0
            if "estimated" in scene.layout.results:
                found &= ~field("estimated")
        found[self.settled] = True
        return found
