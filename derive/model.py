"""The model of a scene: all its kernels and its event loop."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field

import sympy as sp

from .contact.law import Law
from .events import grouping
from .events.plane import asks_side
from .events.plane_filter import reachable
from .events.plane_start import plane_start
from .ir.kernel import Kernel
from .kernels.arguments import argument_order
from .kernels.law import law_kernels
from .kernels.scene import flight_boxes, scene_kernels
from .kernels.surface import SurfaceKernels, all_surface_kernels, one_surface_kernels
from .loop import predicates
from .loop.event_loop import event_loop
from .loop.loop import Loop
from .motion.parabola import Parabola
from .rolling import contact_phase, endless, friction_limit, second_surface
from .rolling.symbols import EventCodes
from .scenes.check import check
from .scenes.names import check_kernels
from .scenes.passage import passage_kernels
from .scenes.scene import Scene
from .state import shared_kernels
from .state.fields import (
    ALL_ALIKE,
    NO_ROLLING,
    NO_ROLLING_IN_AIR,
    ResultField,
    fields,
    results,
)
from .state.shared_kernels import LoopSurface
from .studies import study_kernels
from .surfaces import Plane, Surface
from .surfaces.directions import along
from .symbolic.conditionals import release
from .symbolic.isomorphism import Isomorphism, Symbols, isomorphisms
from .symbolic.symbols import variable


@dataclass(frozen=True)
class Model:
    """A scene, all its kernels, and its event loop.

    Attributes
    ----------
    scene
        The scene.
    common
        The kernels that belong to no law and no surface, by name.
    laws
        The kernels of each law, by part.
    surfaces, end_planes
        The kernels of each surface, and of each plane that ends a shot.
    study
        The kernels that studies use; the event loop evaluates none of them.
    loop
        The event loop.
    results, absent_results
        The results of a shot, and those of other scenes that this one lacks.
    law_parameters
        For each law its own symbol for each symbol of the law whose kernels it shares.
    """

    scene: Scene
    common: dict[str, Kernel] = field(repr=False)
    laws: dict[Law, dict[str, Kernel]] = field(repr=False)
    surfaces: tuple[SurfaceKernels, ...] = field(repr=False)
    end_planes: tuple[SurfaceKernels, ...] = field(repr=False)
    study: tuple[Kernel, ...] = field(repr=False)
    loop: Loop
    results: tuple[ResultField, ...]
    absent_results: tuple[ResultField, ...] = ()
    law_parameters: Mapping[Law, Symbols] = field(default_factory=dict, repr=False)

    @property
    def kernels(self) -> tuple[Kernel, ...]:
        """All kernels, in order, each once."""
        of_laws = (k for kernels in self.laws.values() for k in kernels.values())
        of_surfaces = (k for s in (*self.surfaces, *self.end_planes) for k in s.kernels.values())
        distinct = {id(k): k for k in (*of_laws, *of_surfaces)}
        return (*self.common.values(), *distinct.values(), *self.study)

    @property
    def kinds(self) -> tuple[tuple[Surface, ...], ...]:
        """The surfaces by kind: those that share kernels, which are named after the first."""
        found: dict[int, list[Surface]] = {}
        for of_surface in self.surfaces:
            found.setdefault(id(of_surface.search), []).append(of_surface.surface)
        return tuple(tuple(alike) for alike in found.values())


def build(scene: Scene) -> Model:
    """Return all kernels of a scene, and its event loop.

    Raises
    ------
    ValueError
        If a formula of the scene is not what the scene declares, or two kernels have one name.
    """
    check(scene)
    order = argument_order(scene)
    shared = {scene.gravity, scene.ball_radius, scene.inertia}
    likes = isomorphisms(scene.surfaces, shared)
    law_likes = isomorphisms(scene.laws, shared)
    counts = Counter(like.first for like in likes)
    tabled = {index for index, like in enumerate(likes) if counts[like.first] > 1}
    laws = law_kernels(scene, law_likes, order)
    surfaces = all_surface_kernels(scene, likes, order)
    end_planes = tuple(one_surface_kernels(plane, scene, order) for plane in scene.end_planes)
    common = scene_kernels(scene, order, tabled)
    if scene.passage is not None:
        common |= passage_kernels(scene.passage, scene.flight, order)
    optional = _optional_kernels(scene, order, surfaces, tabled)
    contacts, ends = _loop_surfaces(scene, laws, law_likes, surfaces, end_planes)
    names = [body.name for body in scene.bodies]
    counted = bool(tabled) and not scene.rolls
    loop = event_loop(
        common | optional,
        contacts,
        ends,
        fields(
            names,
            scene.rolls,
            scene.passage is not None,
            counted,
            bool(tabled),
            any(s.search.remembered for s in surfaces),
            scene.proves_errors,
            scene.proves_bounces,
        ),
        [variable(symbol) for symbol in scene.symbols],
        scene.open_ended,
    )
    called = loop.called | {call.kernel.name for call in loop.shortcuts}
    common |= {name: kernel for name, kernel in optional.items() if name in called}
    lacking = {NO_ROLLING} if not scene.rolls else set()
    if not scene.rolls or scene.air is None:
        lacking.add(NO_ROLLING_IN_AIR)
    if not scene.proves_bounces:
        lacking.add(ALL_ALIKE)
    every = results(names, scene.outcomes, counted)
    model = Model(
        scene,
        common,
        laws,
        surfaces,
        end_planes,
        tuple(study_kernels(scene, order)),
        loop,
        tuple(result for result in every if result.absence not in lacking),
        tuple(result for result in every if result.absence in lacking),
        {law: like.symbols for law, like in zip(scene.laws, law_likes, strict=True)},
    )
    check_kernels(scene.name, (kernel.name for kernel in model.kernels))
    return model


def _optional_kernels(
    scene: Scene,
    order: tuple[sp.Symbol, ...],
    surfaces: Sequence[SurfaceKernels],
    tabled: Set[int],
) -> dict[str, Kernel]:
    """Return the kernels of which a scene has those that its event loop evaluates."""
    end_planes = len(scene.end_planes)
    kernels = (
        flight_boxes(scene, order)
        | shared_kernels.KERNELS
        | predicates.kernels(
            scene.faces, scene.outcomes, end_planes, scene.single_errors, scene.open_ended
        )
    )
    if scene.rolls:
        codes = EventCodes(len(scene.surfaces) + end_planes, len(scene.bodies))
        contact = (scene.flight, scene.ball, scene.faces, codes, scene.outcomes)
        friction = friction_limit.kernels(scene.flight.acceleration, scene.ball)
        kernels |= endless.kernels(codes) | contact_phase.kernels(
            *contact,
            holders=[k for k, s in enumerate(surfaces) if "rolling_surface" in s.kernels],
            edges=scene.has_edges,
            bounded=scene.bounds_jumps,
            oblique=scene.rolls_obliquely,
            revolved=scene.rolls_about_axes,
            tori=[k for k, s in enumerate(surfaces) if "width" in s.kernels and not s.has_edges],
        )
        kernels |= {kernel.name: kernel for kernel in friction}
        if any(s.search.remembered for s in surfaces):
            kernels |= second_surface.kernels(
                [k for k, s in enumerate(surfaces) if s.search.remembered]
            )
    filters = [s.search.apart for k, s in enumerate(surfaces) if k not in tabled]
    if any(filters):
        kernels["reachable"] = reachable([conditions for conditions in filters if conditions])
    flight = scene.flight
    if isinstance(flight, Parabola) and flight.upright:
        faces = [s for k, s in enumerate(scene.surfaces) if k not in tabled]
        across = [face for face in (*faces, *scene.end_planes) if isinstance(face, Plane)]
        planes = [
            plane
            for plane in across
            if asks_side(plane, flight) and along(plane.direction, flight.acceleration).is_negative
        ]
        if planes:
            kernels["plane_start"] = plane_start(planes, flight)
    return kernels


def _loop_surfaces(
    scene: Scene,
    laws: Mapping[Law, dict[str, Kernel]],
    law_likes: Sequence[Isomorphism],
    surfaces: Sequence[SurfaceKernels],
    end_planes: Sequence[SurfaceKernels],
) -> tuple[list[LoopSurface], list[LoopSurface]]:
    """Return the surfaces and the end planes as the event loop sees them."""
    usual = {p.symbol: sp.Rational(p.default) for p in scene.parameters if not p.infinite}
    contacts = []
    for index, (body, own) in enumerate(zip(scene.faces, surfaces, strict=True)):
        law = scene.bodies[body].law
        contacts.append(
            LoopSurface(
                index,
                body,
                own.kernels,
                own.search,
                laws[law],
                _variables(own.parameters),
                _variables(law_likes[scene.laws.index(law)].symbols),
                _usual_box(own.surface, usual) if "box" in own.kernels else (),
                own.surface.enclosed and own.surface.steepness == 1,
            )
        )
    ends = [
        LoopSurface(len(contacts) + k, len(scene.bodies), own.kernels, own.search, {})
        for k, own in enumerate(end_planes)
    ]
    return contacts, ends


def _variables(symbols: Symbols) -> dict[str, str]:
    return {variable(one): variable(other) for one, other in symbols.items()}


def _usual_box(surface: Surface, usual: Mapping[sp.Symbol, sp.Expr]) -> grouping.Box:
    """Return the box of a surface at the default parameters, along each axis that bounds it."""
    found = []
    for centre, half in zip(surface.reference_point, surface.half_sizes, strict=True):
        if half is not None:
            middle, reach = (float(release(sp.sympify(e)).xreplace(usual)) for e in (centre, half))
            found.append((middle - reach, middle + reach))
    return found
