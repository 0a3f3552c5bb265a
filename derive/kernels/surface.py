"""The kernels of surfaces; surfaces that differ by their parameters alone share them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence, Set
from dataclasses import dataclass, field

import sympy as sp

from ..errors import propagation, surface_frames
from ..events import bounding_boxes, event_polynomials, grouping, search_for
from ..events.search import Formula, Search
from ..ir.kernel import Kernel, kernel
from ..motion.parabola import Parabola
from ..rolling import endless, surface_kernels
from ..scenes import validity
from ..scenes.scene import Scene
from ..state import shared_kernels
from ..surfaces import Surface
from ..symbolic.isomorphism import Isomorphism, Symbols
from ..symbolic.symbols import NORMAL
from .arguments import components, unchecked_argument_order
from .variation import contact_variation

_REACH = "Whether a flight may reach the box of a surface at all."

_APPROACH = "Whether a flight that comes near a surface may come to it."
_DISJOINT = "disjoint boxes"


@dataclass(frozen=True)
class SurfaceKernels:
    """A surface, its search, and its kernels by part.

    Attributes
    ----------
    surface
        The surface.
    search
        The search for arrivals; isomorphic surfaces share it.
    kernels
        The kernels by part; isomorphic surfaces share those of the first.
    parameters
        Its own symbol for each symbol of the first isomorphic surface, where they differ.
    """

    surface: Surface
    search: Search
    kernels: dict[str, Kernel] = field(repr=False)
    parameters: Symbols = field(default_factory=dict)

    @property
    def has_edges(self) -> bool:
        """True if a ball may roll over an edge of the surface."""
        return any(part.startswith("rim") for part in self.kernels)


_ESTIMATED = {"curvature", "carry_normal", "carry_root", "root_delay"}
"""Kernels of errors that are estimated, which a scene with proved bounds has not."""


def all_surface_kernels(
    scene: Scene, likes: Sequence[Isomorphism], order: tuple[sp.Symbol, ...]
) -> tuple[SurfaceKernels, ...]:
    """Return the kernels of each surface, given the surface that each is isomorphic to.

    Parameters
    ----------
    scene
        The scene, with the faces of its bodies in order.
    likes
        For each surface the first one of the same form, and the symbols that take the place of its
        own.
    order
        The symbols in the order of arguments.

    Returns
    -------
    tuple
        One entry for each surface; isomorphic surfaces share their kernels.
    """
    found: list[SurfaceKernels] = []
    counts = Counter(like.first for like in likes)
    differing: dict[int, set[sp.Symbol]] = {}
    for index, like in enumerate(likes):
        if like.first < index:
            differing.setdefault(like.first, set()).update(like.symbols)
    for index, (surface, like) in enumerate(zip(scene.surfaces, likes, strict=True)):
        if like.first < index:
            first = found[like.first]
            found.append(SurfaceKernels(surface, first.search, first.kernels, like.symbols))
        else:
            own = differing.get(index)
            found.append(one_surface_kernels(surface, scene, order, own, counts[index]))
    return tuple(found)


def one_surface_kernels(
    surface: Surface,
    scene: Scene,
    order: tuple[sp.Symbol, ...],
    differing: Set[sp.Symbol] | None = None,
    count: int = 1,
) -> SurfaceKernels:
    """Return the kernels of a surface or of an end plane.

    Parameters
    ----------
    surface
        The surface.
    scene
        The scene that it belongs to.
    order
        The calling order of arguments.
    differing
        The parameters in which isomorphic surfaces differ; None if there are no others.
    count
        How many isomorphic surfaces there are.
    """
    search = search_for(surface, scene.flight)
    formulas = _geometry(surface, scene) | search.formulas
    if scene.proves_errors:
        formulas = {part: own for part, own in formulas.items() if part not in _ESTIMATED}
    if differing is not None:
        parameters = [symbol for symbol in scene.symbols if symbol in differing]
        formulas["taken"] = (
            shared_kernels.parameter_outputs(parameters),
            "The parameters in which one surface differs from another of its kind.",
            "data",
        )
        if not search.closed and (reach := bounding_boxes.may_reach(surface)):
            formulas["near"] = (reach, _REACH, _DISJOINT)
            if count >= grouping.MIN_GROUPED_BODIES:
                formulas |= _groups(surface)
    elif search.reach_test:
        formulas["near"] = (search.reach_test, _REACH, _DISJOINT)
        if search.approach_test:
            formulas["approaches"] = (search.approach_test, _APPROACH, "a separating direction")
    carried = {"carry_root", "carry_normal"} if scene.single_errors else set()
    single = search.single | carried | {"tangents"}
    kernels = {
        part: kernel(f"{surface.name}_{part}", outputs, order, summary, equation, part in single)
        for part, (outputs, summary, equation) in formulas.items()
    }
    if differing is not None:
        kernels["start"] = kernel(
            f"{surface.name}_start",
            validity.surface_start(surface, scene),
            unchecked_argument_order(scene),
            "1 if the ball overlaps no surface up to this one; 1 if that is undecided.",
            "Table 2",
        )
    if scene.rolls:
        kernels |= surface_kernels.contact_phase_kernels(
            surface,
            scene.flight,
            scene.ball_radius,
            scene.has_edges,
            scene.rolls_obliquely,
            scene.rolls_about_axes,
        )
        kernels |= endless.ring_kernels(surface, scene.flight, scene.ball)
        kernels |= endless.azimuth_free_kernels(surface)
    return SurfaceKernels(surface, search, kernels | search.decisions)


def _geometry(surface: Surface, scene: Scene) -> dict[str, Formula]:
    """Return the formulas of a surface that do not depend on how it is searched."""
    formulas: dict[str, Formula] = {}
    if surface.polynomial and scene.flight.exact:
        formulas |= {
            "coefficients": (
                _numbered("c", event_polynomials.event_coefficients(surface, scene.flight)),
                "Coefficients in time of the constraint polynomial, constant first.",
                "Eq. 3 in Table 2",
            ),
            "deflated": (
                _numbered("c", event_polynomials.deflated_coefficients(surface, scene.flight)),
                "Coefficients of the constraint polynomial over t, after a contact at t = 0.",
                "Eq. 3 in Table 2, the exact root divided out",
            ),
        }
    formulas |= {
        "normal": (
            components(NORMAL, surface.normal),
            "Outward unit normal n3 at a contact.",
            "Table 2",
        ),
        "curvature": (
            {"curvature": propagation.curving_along(surface, scene.flight)},
            "Bound on the rate at which the normal turns along the contact surface.",
            "Table 2",
        ),
    }
    if isinstance(scene.flight, Parabola) and (scene.proves_errors or scene.proves_bounces):
        formulas["tangents"] = (
            surface_frames.tangents(surface, scene.flight),
            "Tangent and curvatures at a contact, and bounds on the roundings there.",
            "Table 2, running error analysis",
        )
    formulas["vary"] = contact_variation(surface, scene)
    if surface.bounds:
        formulas["bounds"] = (
            _numbered("g", list(surface.bounds)),
            "The g of Eq. 2: a contact counts if none is positive.",
            "Eq. 2, Table 2",
        )
    return formulas


def _numbered(prefix: str, values: list[sp.Expr]) -> dict[str, sp.Expr]:
    return {f"{prefix}{k}": value for k, value in enumerate(values)}


def _groups(surface: Surface) -> dict[str, Formula]:
    """Return the formulas of the boxes of groups of isomorphic surfaces."""
    return {
        "box": (
            bounding_boxes.body_box(surface),
            "Box of a surface; that of a group has the largest of each number.",
            _DISJOINT,
        ),
        "near_any": (
            bounding_boxes.may_reach_group(surface),
            "Whether a flight may reach the box of a group of surfaces at all.",
            _DISJOINT,
        ),
    }
