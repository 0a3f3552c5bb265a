"""The premises that the page of a scene states, with the kernels that rest on each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from hoopgen.derive.events.air import AirBoxRootFinder, AirRootFinder
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.events.end_plane import EndPlaneSearch
from hoopgen.derive.events.ring.air import AirRingRootFinder
from hoopgen.derive.events.ring.polar import PolarRootFinder
from hoopgen.derive.events.root_search import RootSearch
from hoopgen.derive.kernels.surface import SurfaceKernels
from hoopgen.derive.model import Model

from .premises import PREMISES, Premise

FINDERS = (
    (AirRingRootFinder, "air_ring"),
    (AirBoxRootFinder, "air_box"),
    (AirRootFinder, "air"),
    (PolarRootFinder, "ring"),
    (BoxRootFinder, "box"),
)
"""Kinds of searches, by their root finders; the first that fits counts."""


def kind_of(made: SurfaceKernels) -> str:
    """Return the kind of search that a surface has.

    It is plane, end, ring, box or general, and along a piece of a flight air_ring, air_box or air.
    """
    search = made.search
    if isinstance(search, EndPlaneSearch):
        return "end"
    if not isinstance(search, RootSearch):
        return "plane"
    kinds = (kind for finder, kind in FINDERS if isinstance(search.root_finder, finder))
    return next(kinds, "general")


def parts(model: Model) -> Iterator[tuple[str, str]]:
    """Yield every kernel's name, with its kind and part."""
    for name in model.common:
        yield name, f"common.{name}"
    for kernels in model.laws.values():
        for part, kernel in kernels.items():
            yield kernel.name, f"law.{part}"
    for made in (*model.surfaces, *model.end_planes):
        for part, kernel in made.kernels.items():
            yield kernel.name, f"{kind_of(made)}.{part}"
    for kernel in model.study:
        yield kernel.name, f"study.{kernel.name}"


def _premise_of(part: str, premises: Mapping[str, Premise]) -> str:
    """Return the key of the premise that a kernel rests on."""
    _, _, own = part.partition(".")
    for wanted in (part, f"*.{own}"):
        for key, premise in premises.items():
            if wanted in premise.kernels:
                return key
    for key, premise in premises.items():
        for name in premise.kernels:
            kind, _, start = name.partition(".")
            own_kind = kind in ("*", part.partition(".")[0])
            if own_kind and start.endswith("*") and own.startswith(start[:-1]):
                return key
    raise ValueError(f"premises.py names no premise for the kernel {part}")


def stated(model: Model) -> dict[str, tuple[str, ...]]:
    """Return the premises of a scene's page, and the names of the kernels that rest on each."""
    found: dict[str, list[str]] = {}
    keys = dict(parts(model))
    scene = model.scene
    premises = {
        key: one
        for key, one in PREMISES.items()
        if scene.proves_bounces or one.proved in (None, scene.proves_errors)
    }
    for kernel in model.kernels:
        found.setdefault(_premise_of(keys[kernel.name], premises), []).append(kernel.name)
    shown = {
        key
        for key, premise in premises.items()
        if key in found or (not premise.kernels and premise.beside in ("", *found))
    }
    return {key: tuple(found.get(key, ())) for key in PREMISES if key in shown}
