"""A scene: parameters, bodies and ends. Scenes are data; the other modules are general."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import sympy as sp

from ..contact.ball import THIN_SHELL, Ball
from ..contact.friction import CoulombFriction
from ..contact.law import Law
from ..contact.no_slip import NoSlip
from ..motion.air import AirFlight
from ..motion.air_forces import AirConstants
from ..motion.flight import Acceleration, Flight
from ..motion.parabola import Parabola
from ..surfaces import (
    Body,
    Box,
    Cone,
    EndPlane,
    InclinedPlane,
    ObliqueBox,
    Plane,
    Ring,
    Surface,
)
from ..surfaces.plane import Flat
from ..surfaces.two_sided import Round
from ..symbolic.conditionals import release
from ..symbolic.rounding import is_input
from ..symbolic.symbols import ParameterSymbol
from . import names
from .ends import End, check_passed, check_reached, end_planes, outcomes
from .passage import Passage

AXES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
"""The directions of gravity that are allowed."""


@dataclass(frozen=True)
class Parameter:
    """A physical parameter of a scene.

    Attributes
    ----------
    symbol
        Its symbol.
    unit
        Its unit, as text.
    summary
        Its meaning, in a few words.
    default
        A usual value, in that unit.
    sign
        The allowed sign: "positive", "nonnegative" or "any".
    upper
        The largest allowed value, if there is one.
    latex
        Its LaTeX; "": its name in words.
    lower
        The smallest allowed value, if the sign does not determine it.
    infinite
        True if it may be infinite, with the allowed sign.
    """

    symbol: sp.Symbol
    unit: str
    summary: str
    default: float
    sign: str = "positive"
    upper: float | None = None
    latex: str = ""
    lower: float | None = None
    infinite: bool = False

    @property
    def name(self) -> str:
        """The public name."""
        return str(self.symbol.name)

    @property
    def least(self) -> float:
        """The lower limit of its values."""
        if self.lower is not None:
            return self.lower
        return -math.inf if self.sign == "any" else 0.0


@dataclass(frozen=True)
class Scene:
    """A ball among surfaces.

    Attributes
    ----------
    name
        The name of the generated files.
    parameters
        In calling order.
    bodies
        The bodies that the ball can touch, in the order of the results' columns.
    ends
        The ends of a shot, in the order of the outcomes; without any, a time limit ends it.
    ball_radius, gravity
        The parameters that flight and contact use.
    inertia
        kappa = I / (m R_B²) of the ball: a parameter, or a number; by default a thin shell's.
    requirements
        Expressions of the parameters that must be positive.
    axes, remarks
        For readers, in plain sentences: the origin and the axes, and any other remarks.
    gravity_axis
        The direction of gravity, along one axis; by default down.
    acceleration
        The acceleration of free fall where it may be zero or is not along that axis; None: gravity
        along it.
    rolls
        True if a ball whose bounces accumulate rolls on; then only planes, spheres,
        cylinders and cones have bounds.
    air
        The parameters of the air that the ball flies through; None: there is none.
    passage
        The ring that a ball must have fallen through for the ends that require it.
    """

    name: str
    parameters: tuple[Parameter, ...]
    bodies: tuple[Body, ...]
    ends: tuple[End, ...]
    ball_radius: sp.Symbol
    gravity: sp.Expr
    inertia: sp.Expr = THIN_SHELL
    requirements: tuple[sp.Expr, ...] = field(default=())
    axes: str = ""
    remarks: str = ""
    gravity_axis: tuple[int, int, int] = (0, 0, -1)
    acceleration: Acceleration | None = None
    rolls: bool = False
    air: AirConstants | None = None
    passage: Passage | None = None

    def __post_init__(self) -> None:
        names.check(
            self.name,
            [(parameter.name, parameter.latex) for parameter in self.parameters],
            [body.name for body in self.bodies],
            [surface.name for surface in (*self.surfaces, *self.end_planes)],
            [end.name for end in self.ends],
            [law.name for law in self.laws],
        )
        check_reached(self.name, self.ends)
        check_passed(self.name, self.ends, self.passage is not None)
        if self.gravity_axis not in AXES:
            raise ValueError(
                f"scene {self.name}: gravity_axis: expected one of "
                f"{', '.join(map(str, AXES))}, got {self.gravity_axis!r}"
            )
        if self.rolls and self.flight.along_axis and not self.flight.falls:
            raise ValueError(
                f"scene {self.name}: rolls: expected gravity that cannot be zero, got "
                f"{self.flight.acceleration}"
            )
        unbounded = [s.name for s in self.surfaces if self.rolls and s.max_concavity is sp.oo]
        if unbounded:
            raise ValueError(
                f"scene {self.name}: rolls: expected no implicit surface, whose bends have no "
                f"bound, got {', '.join(unbounded)}"
            )
        bounded = [
            surface.name
            for surface in self.surfaces
            if surface.bounds
            and surface.contact_path is None
            and (surface.contact_bounds or not isinstance(surface, Flat | Round | Cone))
        ]
        if self.rolls and bounded:
            raise ValueError(
                f"scene {self.name}: rolls: expected no bounds but those of planes, spheres, "
                f"cylinders, cones and boxes, got {', '.join(bounded)} with some"
            )

    @property
    def single_errors(self) -> bool:
        """True if errors are carried in single precision.

        A contact can be certain although v·n is so small a share of the speed that it cancels there
        where the condition bends as little along the flight: on a surface that may be flat, without
        gravity or along it. If the normal of a plane is an axis, v·n is no sum. A surface of some
        size bends by v² over that size.
        """
        flat = any(
            not isinstance(s, Plane) and all(half is None for half in s.half_sizes)
            for s in self.surfaces
        )
        return not self.rolls and not flat

    @property
    def proves_errors(self) -> bool:
        """True if errors have proved bounds: no ball rolls, and surfaces and laws have lemmas."""
        return not self.rolls and self._has_lemmas

    @property
    def proves_bounces(self) -> bool:
        """True if errors have proved bounds until a ball rolls, beside those that are estimated.

        Where balls roll, it is not decided on which side of a plane every flight begins if that
        plane belongs to a body. So no body may be a plane.
        """
        planes = any(isinstance(surface, Plane) for surface in self.surfaces)
        return self.rolls and self._has_lemmas and not planes

    @property
    def _has_lemmas(self) -> bool:
        """True if flights, surfaces and laws have the lemmas of proved bounds."""
        return (
            isinstance(self.flight, Parabola)
            and self.flight.upright
            and all(map(proves_contacts, (*self.surfaces, *self.end_planes)))
            and all(isinstance(law, NoSlip | CoulombFriction) for law in self.laws)
        )

    @property
    def has_edges(self) -> bool:
        """True if a surface has bounds, over which a rolling ball comes to an edge."""
        return any(surface.bounds for surface in self.surfaces)

    @property
    def bounds_jumps(self) -> bool:
        """True if the errors of the jump to the end of bounces follow from the last bounce."""
        inclined = any(isinstance(surface, InclinedPlane) for surface in self.surfaces)
        return self.flight.exact and (self.has_edges or inclined)

    @property
    def rolls_obliquely(self) -> bool:
        """True if a ball may roll on a tube that lies along no axis."""
        tubes = (surface.rolling_surface for surface in self.surfaces)
        return self.rolls and any(tube and tube.across is not None for tube in tubes)

    @property
    def rolls_about_axes(self) -> bool:
        """True if a ball may roll on a cone or a torus, but in coordinates of a ring."""
        found = (surface.surface_below(self.flight.upright) for surface in self.surfaces)
        return self.rolls and any(one and one.revolved is not None for one in found)

    def allows_rolling(self, surface: Surface) -> bool:
        """Return True if a ball can stay in contact with a surface; else it bounces on.

        Parameters
        ----------
        surface
            A surface of the scene.
        """
        return self.rolls and surface.surface_below(self.flight.upright) is not None

    @property
    def ball(self) -> Ball:
        """The ball."""
        return Ball(self.ball_radius, self.inertia)

    @property
    def free_fall(self) -> Acceleration:
        """The acceleration of free fall."""
        if self.acceleration is not None:
            return self.acceleration
        ax, ay, az = (component * self.gravity for component in self.gravity_axis)
        return ax, ay, az

    @property
    def flight(self) -> Flight:
        """The motion of the ball between contacts."""
        if self.air is not None:
            return AirFlight(self.free_fall, constants=self.air, departs=self.rolls)
        return self.parabola

    @property
    def parabola(self) -> Parabola:
        """The same where there is no air.

        Raises
        ------
        TypeError
            If there is air.
        """
        if self.air is not None:
            raise TypeError(f"scene {self.name}: in air no flight is a parabola")
        return Parabola(self.free_fall, departs=self.rolls)

    @property
    def open_ended(self) -> bool:
        """True if the time limit ends every shot, also one that meets nothing any more.

        Without gravity a ball may fly on for ever, and no bound on its path is known without one.
        """
        return not self.ends or not self.flight.falls

    @property
    def surfaces(self) -> tuple[Surface, ...]:
        """The faces of all bodies, in order."""
        return tuple(face for body in self.bodies for face in body.faces)

    @property
    def faces(self) -> tuple[int, ...]:
        """The body that each surface belongs to."""
        return tuple(k for k, body in enumerate(self.bodies) for _ in body.faces)

    @property
    def end_planes(self) -> tuple[EndPlane, ...]:
        """The planes whose crossing ends a shot."""
        return end_planes(self.ends)

    @property
    def outcomes(self) -> dict[str, int]:
        """The number of each outcome by name: the ends in order, then the others."""
        return outcomes(self.ends)

    @property
    def laws(self) -> tuple[Law, ...]:
        """The bodies' laws, each once."""
        return tuple(dict.fromkeys(body.law for body in self.bodies))

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The parameters' symbols, in order."""
        return tuple(parameter.symbol for parameter in self.parameters)

    @property
    def lengths(self) -> tuple[sp.Expr, ...]:
        """The measure of roundings of positions: parameters, and numbers in formulas."""
        lengths = (p for p in self.parameters if p.unit == "m" and not p.infinite)
        given: tuple[sp.Expr, ...] = tuple(p.symbol for p in lengths)
        formulas = {e for s in self.surfaces for e in (s.distance, *s.bounds, *s.inside)}
        # Those of points of contact are too large to be written out, with nothing held.
        cuts = {cut for s in self.surfaces for cut in s.cuts}
        written = (*cuts, *map(release, formulas - cuts))
        sums = {part for e in written for part in e.atoms(sp.Add)}
        numbers = {abs(n) for part in sums for n in part.args if n.is_Rational}
        return (*given, sp.Add(*numbers)) if numbers else given


def proves_contacts(surface: Surface) -> bool:
    """Return whether the errors of contacts with a surface have proved bounds.

    Parameters
    ----------
    surface
        The surface.
    """
    if isinstance(surface, Box):
        plain = not isinstance(surface, ObliqueBox) and not surface.bounds
        return plain and all(map(_known_sides, surface.low, surface.high))
    if isinstance(surface, Plane):
        # The lemmas of arrivals say nothing of planes that gravity, along -z, pulls off.
        return surface.direction[2] >= 0
    return isinstance(surface, Ring)


def _known_sides(low: sp.Expr, high: sp.Expr) -> bool:
    """Return whether two faces of a box are as the lemmas have them.

    Both are inputs of the scene; or one is, and the width, whose sum is the other.
    """
    given = [is_input(low), is_input(high)]
    return all(given) or (any(given) and is_input(sp.expand(release(high) - release(low))))


def parameter(
    name: str,
    unit: str,
    summary: str,
    default: float,
    sign: str = "positive",
    upper: float | None = None,
    latex: str = "",
    lower: float | None = None,
    infinite: bool = False,
) -> Parameter:
    """Return a parameter with a symbol of its name, assumed to be of the allowed sign.

    Parameters
    ----------
    name
        The name of the parameter and of its symbol.
    unit
        Its SI unit, such as "m" or "1".
    summary
        Its meaning in words.
    default
        Its value if none is given.
    sign
        "positive", "nonnegative" or "any".
    upper, lower
        The largest and the smallest value; None for no limit but that of the sign.
    latex
        Its letter on the pages of the derivation; empty for its name.
    infinite
        True if it may be infinite.
    """
    assumption = {"positive": "positive", "nonnegative": "nonnegative", "any": "real"}[sign]
    symbol = ParameterSymbol(name, **{assumption: True})
    return Parameter(symbol, unit, summary, default, sign, upper, latex, lower, infinite)
