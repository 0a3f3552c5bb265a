"""A scene that is ready to be simulated, whichever it is; and one that comes so: the hoop."""

from __future__ import annotations

import hashlib
import importlib.machinery
import math
from collections.abc import Callable, Mapping
from enum import IntEnum
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.generated.numpy import hoop

from .engine import native, trust
from .engine.contact import Roll
from .engine.raw import Layout
from .parameters import Parameters, Table, Written

if TYPE_CHECKING:
    from .derive.scenes.scene import Scene

__all__ = ["HOOP", "Engine", "hoop_library", "hoop_shots", "installed_library", "printed"]


class Engine:
    """A scene, compiled: `hoopgen.compile` returns one, and `hoopgen.HOOP` is the article's.

    Attributes
    ----------
    kernels
        Its generated NumPy module.
    layout
        Of the arrays of its results.
    max_contacts
        With which a shot ends as capped, where nothing else is asked for.
    time_limit
        At which it ends, likewise, s.
    has_hoop
        Whether shots are thrown at a hoop in it, with the hoop's bodies and outcomes: then they are
        released, counted and measured as those at the article's.
    """

    def __init__(
        self,
        kernels: ModuleType,
        *,
        find: Callable[[], native.Library | native.Refused],
        sources: Callable[[], Mapping[str, str]],
        scene: Callable[[], Scene],
        max_contacts: int = 1000,
        time_limit: float = 60.0,
        again: tuple[Callable[..., Engine], tuple[Any, ...]] | None = None,
        written: Written | None = None,
        has_hoop: bool = False,
    ) -> None:
        self.kernels = kernels
        self.layout = Layout(kernels)
        self.max_contacts, self.time_limit = max_contacts, time_limit
        self.has_hoop = has_hoop
        self.table = Table.of(kernels, written)
        self._find, self._sources, self._scene, self._again = find, sources, scene, again

    @cached_property
    def found(self) -> native.Library | native.Refused:
        """Its compiled C, or why there is none that can be trusted."""
        return self._find()

    @cached_property
    def scene(self) -> Scene:
        """What it is derived from; needs SymPy."""
        return self._scene()

    @property
    def name(self) -> str:
        """Of the scene."""
        return str(self.kernels.SCENE)

    @property
    def is_hoop(self) -> bool:
        """Whether it is the article's scene, of which some things are known that no other has."""
        return self.kernels is hoop

    @cached_property
    def identity(self) -> dict[str, str]:
        """What tells it from other scenes, whatever they are called; the same in any process."""
        written = self.table.written
        said = "".join(self.source("numpy").values()) if written is None else written.key
        return {"name": self.name, "sha256": hashlib.sha256(said.encode()).hexdigest()}

    @property
    def rolls(self) -> bool:
        """Whether a ball whose bounces accumulate rolls on; it may do so for ever."""
        return self.layout.rows > 1

    @property
    def library(self) -> native.Library | None:
        """Its compiled C, None where there is none that can be trusted."""
        return None if isinstance(self.found, native.Refused) else self.found

    @property
    def backend(self) -> str:
        """What simulates where nothing else is asked for, "c" or "numpy"."""
        return "numpy" if self.library is None else "c"

    @cached_property
    def infinite(self) -> frozenset[str]:
        """The parameters that may be infinite, a friction for one."""
        kernels, names = self.kernels, list(self.kernels.VARIABLES)
        tried = np.where(np.eye(len(names), dtype=np.bool_), math.inf, 1.0)
        given = {**dict(zip(kernels.VARIABLES.values(), tried, strict=True)), "allowed": 1.0}
        asked = (given[name] for name in kernels.ARGUMENTS["parameters_in_range"])
        (permitted,) = kernels.parameters_in_range(*asked)
        found = dict(zip(names, np.broadcast_to(permitted, len(names)), strict=True))
        return frozenset(name for name in self.table.defaults if found.get(name))

    @property
    def parameters(self) -> Parameters:
        """The usual value of each parameter; SI units."""
        return Parameters(self.table.defaults)

    @property
    def surfaces(self) -> tuple[str, ...]:
        """What can be touched, in the order of the columns of ``Shots.counts``."""
        return tuple(self.kernels.BODIES)

    @property
    def outcomes(self) -> type[IntEnum]:
        """How a shot can end."""
        outcomes: type[IntEnum] = self.kernels.Outcome
        return outcomes

    def simulate(
        self, states: ArrayLike, parameters: Mapping[str, Any] | None = None, **options: Any
    ) -> Any:
        """Simulate shots in this scene; all else as for `hoopgen.simulate`."""
        from . import simulation  # which stands on this file

        return simulation.simulate(states, parameters, scene=self, **options)

    def certify(
        self, states: ArrayLike, parameters: Mapping[str, Any] | None = None, **options: Any
    ) -> Any:
        """Prove what shots do in this scene; all else as for `hoopgen.certify`."""
        from . import judge  # which stands on this file, and on SymPy

        return judge.certify(states, parameters, scene=self, **options)

    def source(self, target: str) -> dict[str, str]:
        """Return the generated files of a target, "c" or "numpy": their names, and their texts.

        Raises
        ------
        ValueError
            If it is another target.
        """
        if target not in ("c", "numpy"):
            raise ValueError(f"target: expected 'c' or 'numpy', got {target!r}")
        return {
            name.removeprefix(f"{target}/"): text
            for name, text in self._sources().items()
            if name.startswith(f"{target}/")
        }

    def fly(
        self, times: Any, states: NDArray[np.float64], parameters: Mapping[str, Any]
    ) -> NDArray[np.float64]:
        """Return states (..., 9) some times after others, with nothing touched in between."""
        own = self._inputs(parameters)
        own |= dict(zip(self.kernels.STATE, np.moveaxis(states, -1, 0), strict=True))
        asked = self.kernels.ARGUMENTS["flight"][1:]
        moved = self.kernels.flight(times, *(own[name] for name in asked))
        return np.stack([*moved, *np.moveaxis(states[..., len(moved) :], -1, 0)], -1)

    def fall(
        self, states: NDArray[np.float64], level: Any, parameters: Mapping[str, Any]
    ) -> tuple[Any, NDArray[np.float64]]:
        """Return when balls come down to a height with nothing touched before, and where they are.

        Parameters
        ----------
        states
            Of the balls, (..., 9).
        level
            The height of their centres, z, m.
        parameters
            Of the scene.

        Returns
        -------
        tuple
            s after the states, (...), NaN where a ball is below already; and states, (..., 9).
        """
        own = self._inputs(parameters)
        own |= dict(zip(self.kernels.STATE, np.moveaxis(states, -1, 0), strict=True))
        own["level"] = level
        with np.errstate(invalid="ignore"):
            given = (own[name] for name in self.kernels.ARGUMENTS["descent"])
            times, _ = self.kernels.descent(*given)
            times = np.where(np.asarray(times) >= 0.0, times, np.nan)
            return times, self.fly(times, states, parameters)

    def roll(
        self,
        surface: int,
        state: NDArray[np.float64],
        lasting: float,
        parameters: Mapping[str, Any],
    ) -> Roll:
        """Return the motion of a ball in contact with a surface, so long from a state (9,) on."""
        own = self._inputs(parameters)
        return Roll(self.kernels, self.surfaces[surface], state, lasting, own)

    def _inputs(self, parameters: Mapping[str, Any]) -> dict[str, Any]:
        """Return the scene's numbers by the names that kernels have for them."""
        inputs = self.table.inputs(parameters)
        return dict(zip(self.kernels.VARIABLES.values(), inputs, strict=True))

    def __repr__(self) -> str:
        touched = ", ".join(self.surfaces)
        return f"Engine({self.name}: {touched}; {self.backend})"

    def __reduce__(self) -> tuple[Callable[..., Engine], tuple[Any, ...]]:
        if self._again is None:
            raise TypeError(f"the engine of the scene {self.name} cannot be sent to a process")
        return self._again


EACH = 32
"""Shots of a kind."""

# A release, and how far its shots lie apart, by kind: x y z, vx vy vz, wx wy wz.
_KINDS = (
    # a free throw, through the ring, onto it and short of it
    ((4.19, 0, -0.61, -4.5, 0, 5.577, 0, 19, 0), (0, 0, 0, 0.3, 0.1, 0.3, 2, 8, 2)),
    # a bank shot, 45 degrees from the side
    ((2.1, 2.1, -0.85, -3.2, -2.4, 5.6, 3, 4, 0), (0, 0, 0, 0.5, 0.5, 0.4, 9, 9, 9)),
    # a swirl
    ((0.2286, -0.945, -0.61, -0.838, 2.134, 3.856, 0, 0, 1), (0, 0, 0, 4e-3, 9e-3, 1e-2, 0, 0, 2)),
    # dropped onto the ring
    ((0, 0, 1.1, 0, 0, 0, 0, 0, 0), (0.7, 0.7, 1.8, 0.6, 0.6, 0.6, 40, 40, 40)),
    # dropped onto the bridge
    ((-0.247, 0, 0.36, 0, 0, 0, 0, 0, 0), (0.03, 0.16, 0.46, 0.6, 0.6, 2, 9, 9, 9)),
    # over the board from behind
    ((-1.2, 0, 0.1, 2.2, 0, 4, 0, 0, 0), (1.4, 1, 1.8, 3.4, 0.6, 3, 0, 0, 0)),
    # a side of the backboard
    ((1, 0.9, 0.2, -2.5, 0, 3, 0, 0, 0), (0, 0.2, 0.8, 1, 0.2, 2, 30, 30, 30)),
    # from anywhere
    ((0.7, 0, 0.2, 0, 0, 2, 0, 0, 0), (4, 3, 2.5, 9, 9, 9, 60, 60, 60)),
)


def hoop_releases() -> NDArray[np.float64]:
    """Return releases that meet all that a hoop has, (n, 9)."""
    apart = trust.spread(EACH, len(hoop.STATE))
    kinds = [np.asarray(centre) + np.asarray(width) * apart for centre, width in _KINDS]
    return np.concatenate(kinds)


def hoop_shots() -> list[trust.Batch]:
    """Return the shots with which the hoop's C is compared."""
    return trust.batches(hoop, hoop_releases())


def hoop_library(path: Path | None = None) -> native.Library | native.Refused:
    """Return the hoop's C engine, or why it cannot be trusted.

    Parameters
    ----------
    path
        The shared library; by default the one that is installed.

    Raises
    ------
    RuntimeError
        If this thread does not compute doubles as IEEE 754 says, so that nothing can be compared.
    """
    return installed_library(hoop, hoop_shots(), path)


def installed_library(
    kernels: ModuleType, shots: list[trust.Batch], path: Path | None = None
) -> native.Library | native.Refused:
    """Return the C engine of a scene that came with hoopgen; all else as of `hoop_library`.

    Parameters
    ----------
    kernels
        Its generated NumPy module.
    shots
        With which the two are compared.
    """
    suffix = importlib.machinery.EXTENSION_SUFFIXES[0]
    installed = Path(native.__file__).with_name(f"_{kernels.SCENE}{suffix}")
    folder = Path(str(kernels.__file__)).parents[1] / "c"
    return native.checked(path or installed, kernels, folder, shots)


def printed(kernels: ModuleType) -> dict[str, str]:
    """Return the generated files of a scene that came with hoopgen."""
    root, scene = Path(str(kernels.__file__)).parents[1], kernels.SCENE
    files = (*sorted((root / "c").glob(f"{scene}*.[ch]")), root / "numpy" / f"{scene}.py")
    return {f.relative_to(root).as_posix(): f.read_text(encoding="utf-8") for f in files}


def _hoop_scene() -> Scene:
    from .derive.scenes import HOOP as SCENE

    return SCENE


def _hoop() -> Engine:
    return HOOP


HOOP = Engine(
    hoop,
    find=hoop_library,
    sources=lambda: printed(hoop),
    scene=_hoop_scene,
    max_contacts=40,
    time_limit=math.inf,
    again=(_hoop, ()),
    has_hoop=True,
)
"""The article's scene."""
