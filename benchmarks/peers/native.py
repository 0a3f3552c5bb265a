"""The peers in C: compiled at first use into a cache folder, called through ctypes."""

import ctypes
import hashlib
import os
import shlex
import subprocess
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.peers.flown import Flown
from hoopgen.engine.c_build import FLAGS as OUR

OUR_FLAGS = tuple(OUR)
"""Compiler flags of hoopgen's own library (setup.py)."""

FLAGS = (*OUR_FLAGS, "-march=native", "-mprefer-vector-width=512")
"""The machine's own vectors double the speed of the march, and slow none of the others."""

COMPILER = shlex.split(os.environ.get("CC", "gcc"))
FOLDER = Path(__file__).parent

SCENE = (
    "ball_radius",
    "ring_radius",
    "wire_radius",
    "board_distance",
    "board_half_width",
    "board_bottom",
    "board_top",
    "bridge_half_width",
    "restitution",
    "gravity",
    "end_depth",
)
"""The fields of `Scene` in model.h, in their order."""


def compiler_version() -> str:
    """First line of the compiler's own account of itself."""
    command = [*COMPILER, "--version"]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return output.splitlines()[0]


def _native_options() -> str:
    """Return the meaning of -march=native here, since several machines may share a cache."""
    command = [*COMPILER, "-march=native", "-Q", "--help=target"]
    return subprocess.run(command, check=False, capture_output=True, text=True).stdout


@cache
def library(name: str, flags: tuple[str, ...] = FLAGS) -> ctypes.CDLL:
    """Compile `name`.c with `flags` and load it."""
    sources = [FOLDER / f"{name}.c", *sorted(FOLDER.glob("*.h"))]
    digest = hashlib.sha256()
    for part in (compiler_version(), _native_options(), *flags):
        digest.update(part.encode())
    for source in sources:
        digest.update(source.read_bytes())
    home = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "hoopgen-benchmarks"
    target = home / f"{name}-{digest.hexdigest()[:16]}.so"
    if not target.exists():
        home.mkdir(parents=True, exist_ok=True)
        # Written beside and moved: two processes may build at once.
        beside = target.with_suffix(f".{os.getpid()}")
        command = [*COMPILER, *flags, "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC"]
        subprocess.run([*command, "-o", str(beside), str(sources[0]), "-lm"], check=True)
        beside.replace(target)
    return ctypes.CDLL(str(target))


def _fly(
    name: str,
    options: tuple[float, ...],
    states: NDArray[np.float64],
    parameters: Mapping[str, float],
    max_contacts: int,
    record: bool,
) -> Flown:
    states = np.ascontiguousarray(np.atleast_2d(states), dtype=np.float64)
    n = len(states)
    scene = np.array([parameters[field] for field in SCENE])
    settings = np.array(options)
    flown = Flown(
        np.empty(n, np.uint8),
        np.empty(n, np.int32),
        np.empty(n),
        np.full((n, max_contacts if record else 0), -1, np.int8),
    )
    pointer = ctypes.c_void_p
    library(name).simulate(
        pointer(states.ctypes.data),
        ctypes.c_int64(n),
        pointer(scene.ctypes.data),
        pointer(settings.ctypes.data),
        ctypes.c_int(max_contacts),
        pointer(flown.outcome.ctypes.data),
        pointer(flown.contacts.ctypes.data),
        pointer(flown.time.ctypes.data),
        pointer(flown.surfaces.ctypes.data if record else None),
    )
    return flown


def march_bisect(
    states: NDArray[np.float64],
    parameters: Mapping[str, float],
    max_contacts: int = 40,
    record: bool = False,
    longest: float = 1e-3,
    eps: float = 1e-10,
) -> Flown:
    """Fly by the article's method (section 2.1): march by `longest`, bisect to `eps` (s)."""
    return _fly("march_bisect", (longest, eps), states, parameters, max_contacts, record)


def fixed_step(
    states: NDArray[np.float64],
    parameters: Mapping[str, float],
    max_contacts: int = 40,
    record: bool = False,
    step: float = 1e-4,
) -> Flown:
    """Fly by time stepping with a fixed `step` (s)."""
    return _fly("fixed_step", (step,), states, parameters, max_contacts, record)


def adaptive_step(
    states: NDArray[np.float64],
    parameters: Mapping[str, float],
    max_contacts: int = 40,
    record: bool = False,
    shortest: float = 1e-4,
) -> Flown:
    """Fly by time stepping whose step follows the distance to the nearest surface, `shortest` or
    more (s)."""
    return _fly("adaptive_step", (shortest,), states, parameters, max_contacts, record)
