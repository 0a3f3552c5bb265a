"""`CompiledScene`: the kernels of a scene, its parameters and results, and its compiled C."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from enum import IntEnum
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.backend_names import RUNTIME_BACKENDS
from hoopgen.core.parameters import DerivedInputs, Parameters, Table, Value
from hoopgen.generated.numpy import hoop
from hoopgen.text.shorten import join_alternatives

from . import arithmetic, c_build, cuda, native, verification
from .flight_pieces import FlownPieces, apex_in_pieces, descend_in_pieces, fly_in_pieces
from .result_arrays import Layout
from .rolling import Roll, face_below

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene


class CompiledScene:
    """A scene with all that is generated for it; an `Engine` simulates it.

    Attributes
    ----------
    kernels
        Its generated NumPy module.
    layout
        Layout of the arrays of its results.
    max_contacts
        Number of contacts at which a shot ends as capped, by default.
    time_limit
        Time since the release at which a shot ends, by default, s.
    has_hoop
        Whether it has the bodies and outcomes of a hoop: then its shots are released, counted and
        measured as those at the article's hoop.
    table
        Its parameters, with their defaults and limits.
    presets
        Named values of its parameters for the command line and files; a scene of one's own has
        none.
    """

    def __init__(
        self,
        kernels: ModuleType,
        *,
        find: Callable[[], native.Library | native.Rejection],
        sources: Callable[[str], Mapping[str, str]],
        scene: Callable[[], Scene],
        max_contacts: int = 1000,
        time_limit: float = 60.0,
        rebuild: tuple[Callable[..., CompiledScene], tuple[Any, ...]] | None = None,
        written: DerivedInputs | None = None,
        has_hoop: bool = False,
        presets: Mapping[str, Parameters[float]] | None = None,
        trial: Callable[[], list[verification.Batch]] = list,
        without_bounds: Callable[[int], native.Library] | None = None,
    ) -> None:
        self.kernels = kernels
        self.layout = Layout(kernels)
        self.max_contacts, self.time_limit = max_contacts, time_limit
        self.has_hoop = has_hoop
        self.presets: Mapping[str, Parameters[float]] = {} if presets is None else presets
        self.table = Table.from_kernels(kernels, written)
        self._find, self._sources, self._scene, self._rebuild = find, sources, scene, rebuild
        self._trial, self._without_bounds = trial, without_bounds

    @cached_property
    def found(self) -> native.Library | native.Rejection:
        """Its C engine, or why there is none that can be trusted."""
        return self._find()

    @cached_property
    def cuda(self) -> cuda.CudaEngine:
        """Its CUDA engine, which has given NumPy's bits on this GPU.

        Raises
        ------
        ImportError
            If CuPy is missing: what brings it.
        RuntimeError
            If there is no GPU, or its results cannot be trusted.
        """
        return cuda.load_engine(self.source("cuda")[f"{self.name}.cu"], self.kernels, self._trial)

    @cached_property
    def scene(self) -> Scene:
        """The scene of derive/; needs SymPy."""
        return self._scene()

    @property
    def name(self) -> str:
        """Name of the scene."""
        return str(self.kernels.SCENE)

    @property
    def is_hoop(self) -> bool:
        """True for the article's scene, for which some questions have closed formulas."""
        return self.kernels is hoop

    @cached_property
    def identity(self) -> dict[str, str]:
        """Name and digest of the scene: the same in every process, another for any other scene."""
        written = self.table.written
        said = "".join(self.source("numpy").values()) if written is None else written.key
        return {"name": self.name, "sha256": hashlib.sha256(said.encode()).hexdigest()}

    @property
    def rolls(self) -> bool:
        """True if a ball rolls on when its bounces accumulate, perhaps for ever."""
        return self.layout.rows > 1

    @property
    def in_air(self) -> bool:
        """True if balls fly through air, along series in time and not along parabolas."""
        return bool(self.kernels.PIECES)

    @property
    def library(self) -> native.Library | None:
        """Its C engine; None if there is none that can be trusted."""
        return None if isinstance(self.found, native.Rejection) else self.found

    def library_without_bounds(self, shots: int) -> native.Library | None:
        """Return the C engine for shots without bounds on errors: of the same bits, maybe faster.

        Parameters
        ----------
        shots
            How many shots it is for.
        """
        if self.library is None or self._without_bounds is None:
            return self.library
        return self._without_bounds(shots)

    @property
    def backend(self) -> str:
        """The default backend, "c" or "numpy"."""
        return "numpy" if self.library is None else "c"

    def exact_arithmetic(self) -> AbstractContextManager[None]:
        """Return a context in which this thread computes doubles as IEEE 754 says.

        Where the thread does not, the C engine sets the default environment for that while.

        Raises
        ------
        RuntimeError
            If the thread does not, and there is no C engine.
        """
        if not arithmetic.is_exact() and self.library is not None:
            return self.library.default_environment()
        arithmetic.check_arithmetic()
        return nullcontext()

    @cached_property
    def infinite(self) -> frozenset[str]:
        """Names of the parameters that may be infinite, such as a friction."""
        return infinite_parameters(self.kernels).intersection(self.table.defaults)

    @property
    def parameters(self) -> Parameters[float]:
        """Default value of each parameter; SI units."""
        return Parameters(self.table.defaults)

    @property
    def surfaces(self) -> tuple[str, ...]:
        """Names of the bodies, in the order of the columns of ``Shots.counts``."""
        return tuple(self.kernels.BODIES)

    @property
    def outcomes(self) -> type[IntEnum]:
        """Outcomes of a shot, an enumeration."""
        outcomes: type[IntEnum] = self.kernels.Outcome
        return outcomes

    def source(self, target: str) -> dict[str, str]:
        """Return the generated files of a target, by their names: "c", "numpy" or "cuda".

        Raises
        ------
        ValueError
            If it is another target.
        """
        if target not in RUNTIME_BACKENDS:
            raise ValueError(
                f"target: expected {join_alternatives(map(repr, RUNTIME_BACKENDS))}, got {target!r}"
            )
        return {
            name.removeprefix(f"{target}/"): text
            for name, text in self._sources(target).items()
            if name.startswith(f"{target}/")
        }

    def fly(
        self, times: ArrayLike, states: NDArray[np.float64], parameters: Mapping[str, Value]
    ) -> NDArray[np.float64]:
        """Return the states after free flights.

        Parameters
        ----------
        times
            Durations of the flights, s; they broadcast with the states, (...).
        states
            States at the beginning, (..., 9).
        parameters
            Parameters of the scene by name, SI units.

        Returns
        -------
        ndarray
            States at the end, (..., 9).
        """
        own = self._inputs(parameters)
        if self.in_air:
            return fly_in_pieces(self.kernels, times, states, own)
        own |= dict(zip(self.kernels.STATE, np.moveaxis(states, -1, 0), strict=True))
        asked = self.kernels.ARGUMENTS["flight"][1:]
        moved = self.kernels.flight(times, *(own[name] for name in asked))
        return np.stack([*moved, *np.moveaxis(states[..., len(moved) :], -1, 0)], -1)

    def follow(
        self,
        times: NDArray[np.float64],
        states: NDArray[np.float64],
        parameters: Mapping[str, Value],
    ) -> NDArray[np.float64]:
        """Return the positions at many times of free flights, (n, m, 3).

        Parameters
        ----------
        times
            s since the beginnings, not negative, (n, m).
        states
            States at the beginnings, (n, 9).
        parameters
            Parameters of the scene by name, numbers or (n,), SI units.
        """
        if not self.in_air:
            own = {n: np.asarray(v)[..., None] if np.ndim(v) else v for n, v in parameters.items()}
            many = np.broadcast_to(states[:, None], (*times.shape, states.shape[-1]))
            return self.fly(times, many, own)[..., :3]
        latest = times.max(axis=1, initial=0.0)
        with np.errstate(all="ignore"):
            flown = FlownPieces(self.kernels, states, latest, self._inputs(parameters))
            flights = np.repeat(np.arange(len(states)), times.shape[1])
            there = flown.at(flights, times.ravel())
        found = np.stack([there[axis] for axis in "xyz"], axis=-1)
        return found.reshape(*times.shape, 3)

    def fall(
        self, states: NDArray[np.float64], level: ArrayLike, parameters: Mapping[str, Value]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return when balls in free flight come down to a height, and their states then.

        Parameters
        ----------
        states
            States of the balls, (..., 9).
        level
            Height z of their centres, m.
        parameters
            Of the scene.

        Returns
        -------
        tuple
            Times after the states, s, (...), NaN where a ball is below already; and states, (...,
            9).
        """
        own = self._inputs(parameters)
        if self.in_air:
            return descend_in_pieces(self.kernels, states, level, own)
        own |= dict(zip(self.kernels.STATE, np.moveaxis(states, -1, 0), strict=True))
        own["level"] = level
        with np.errstate(invalid="ignore"):
            given = (own[name] for name in self.kernels.ARGUMENTS["descent"])
            times, _ = self.kernels.descent(*given)
            times = np.where(np.asarray(times) >= 0.0, times, np.nan)
            return times, self.fly(times, states, parameters)

    def apex(
        self, states: NDArray[np.float64], parameters: Mapping[str, Value]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return when balls in free flight are highest, and their heights then.

        Parameters
        ----------
        states
            States of the balls, (..., 9).
        parameters
            Of the scene.

        Returns
        -------
        tuple
            Times after the states, s, (...), 0 for a ball that falls; heights z, m, (...).
        """
        own = self._inputs(parameters)
        if self.in_air:
            times, there = apex_in_pieces(self.kernels, states, own)
            return times, there[..., 2]
        own |= dict(zip(self.kernels.STATE, np.moveaxis(states, -1, 0), strict=True))
        time, height = self.kernels.apex(*(own[name] for name in self.kernels.ARGUMENTS["apex"]))
        return np.asarray(time), np.asarray(height)

    def roll(
        self,
        surface: int,
        state: NDArray[np.float64],
        duration: float,
        parameters: Mapping[str, Value],
    ) -> Roll:
        """Return the motion of a ball that rolls on a surface.

        Parameters
        ----------
        surface
            Number of the surface, as in `surfaces`.
        state
            State at the beginning of contact, (9,).
        duration
            Duration of contact, s.
        parameters
            Parameters of the scene by name, SI units.

        Returns
        -------
        Roll
            The motion, which can be evaluated at any time within the duration.
        """
        own = self._inputs(parameters)
        face = face_below(self.kernels, surface, state, own)
        return Roll(self.kernels, face, state, duration, own)

    def _inputs(self, parameters: Mapping[str, Value]) -> dict[str, Any]:
        """Return the inputs of the kernels by the names of their variables."""
        inputs = self.table.inputs(parameters)
        return dict(zip(self.kernels.VARIABLES.values(), inputs, strict=True))

    def __repr__(self) -> str:
        touched = ", ".join(self.surfaces)
        return f"{type(self).__name__}({self.name}: {touched}; {self.backend})"

    def __reduce__(self) -> tuple[Callable[..., CompiledScene], tuple[Any, ...]]:
        if self._rebuild is None:
            raise TypeError(f"the engine of the scene {self.name} cannot be sent to a process")
        return self._rebuild


def infinite_parameters(kernels: ModuleType) -> frozenset[str]:
    """Return the parameters of a generated module that may be infinite."""
    names = list(kernels.VARIABLES)
    tried = np.where(np.eye(len(names), dtype=np.bool_), math.inf, 1.0)
    given = {**dict(zip(kernels.VARIABLES.values(), tried, strict=True)), "allowed": 1.0}
    asked = (given[name] for name in kernels.ARGUMENTS["parameters_in_range"])
    (permitted,) = kernels.parameters_in_range(*asked)
    found = dict(zip(names, np.broadcast_to(permitted, len(names)), strict=True))
    return frozenset(name for name, infinite in found.items() if infinite)


def installed_library(
    kernels: ModuleType,
    shots: Callable[[], list[verification.Batch]],
    path: Path | None = None,
) -> native.Library | native.Rejection:
    """Return the C engine of a scene that comes with hoopgen, or why it cannot be trusted.

    Parameters
    ----------
    kernels
        Its generated NumPy module.
    shots
        Function that returns the shots with which C and NumPy are compared.
    path
        The shared library; by default the installed one.
    """
    installed = Path(native.__file__).with_name(f"_{kernels.SCENE}.so")
    folder = Path(str(kernels.__file__)).parents[1] / "c"
    return native.check_library(path or installed, kernels, folder, shots)


def generated_files(kernels: ModuleType) -> dict[str, str]:
    """Return the generated files of a scene that comes with hoopgen, by their paths."""
    root, scene = Path(str(kernels.__file__)).parents[1], kernels.SCENE
    files = [*c_build.source_files(root / "c", scene), root / "numpy" / f"{scene}.py"]
    files.append(root / "cuda" / f"{scene}.cu")
    return {f.relative_to(root).as_posix(): f.read_text(encoding="utf-8") for f in files}
