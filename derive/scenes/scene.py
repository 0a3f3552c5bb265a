"""A scene: parameters and an ordered list of surfaces. Scenes are data; the rest is general."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import sympy as sp

from ..contact.law import Law
from ..flight.parabola import Parabola
from ..ground.choice import release
from ..ground.symbols import ParameterSymbol
from ..surfaces import Body, Gate, Surface
from . import names
from .ends import End, check_passed, check_reached, gates, outcomes
from .passage import Passage

AXES = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
"""Where free fall can go."""


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
        What it is, in a few words.
    default
        A usual value, in that unit.
    sign
        Which values are allowed: "positive", "nonnegative" or "any".
    upper
        The largest value allowed, if there is one.
    latex
        How formulas write it; "": its name in words.
    lower
        The smallest value allowed, if it is not what the sign says.
    infinite
        Whether it may be infinite, with the sign that it may have.
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
        """Its public name."""
        return str(self.symbol.name)

    @property
    def least(self) -> float:
        """What it is never below."""
        if self.lower is not None:
            return self.lower
        return -math.inf if self.sign == "any" else 0.0


@dataclass(frozen=True)
class Scene:
    """A ball among surfaces.

    Attributes
    ----------
    name
        Names the generated files.
    parameters
        In calling order.
    bodies
        What the ball can touch, in the order of the results' columns.
    ends
        What ends a shot, in the order of the outcomes; there may be none, and then a time does.
    ball_radius, gravity
        The parameters that flight and contact use.
    requirements
        Expressions of the parameters that must be positive.
    axes, remarks
        For readers, in plain sentences: where origin and axes lie, and what else there is to say.
    gravity_axis
        The way free fall goes: along one axis, by default down.
    rolls
        Whether a ball whose bounces accumulate rolls on; no surface then has bounds.
    passage
        The ring that a ball must have fallen through for the ends that say so.
    """

    name: str
    parameters: tuple[Parameter, ...]
    bodies: tuple[Body, ...]
    ends: tuple[End, ...]
    ball_radius: sp.Symbol
    gravity: sp.Symbol
    requirements: tuple[sp.Expr, ...] = field(default=())
    axes: str = ""
    remarks: str = ""
    gravity_axis: tuple[int, int, int] = (0, 0, -1)
    rolls: bool = False
    passage: Passage | None = None

    def __post_init__(self) -> None:
        names.check(
            self.name,
            [(parameter.name, parameter.latex) for parameter in self.parameters],
            [body.name for body in self.bodies],
            [surface.name for surface in (*self.surfaces, *self.gates)],
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
        bounded = [surface.name for surface in self.surfaces if surface.bounds]
        if self.rolls and bounded:
            raise ValueError(
                f"scene {self.name}: rolls: expected surfaces without bounds, got "
                f"{', '.join(bounded)} with some"
            )

    @property
    def flight(self) -> Parabola:
        """How the ball moves between contacts."""
        ax, ay, az = (component * self.gravity for component in self.gravity_axis)
        return Parabola((ax, ay, az))

    @property
    def surfaces(self) -> tuple[Surface, ...]:
        """The faces of all bodies, in order."""
        return tuple(face for body in self.bodies for face in body.faces)

    @property
    def faces(self) -> tuple[int, ...]:
        """The body that each surface belongs to."""
        return tuple(k for k, body in enumerate(self.bodies) for _ in body.faces)

    @property
    def gates(self) -> tuple[Gate, ...]:
        """The planes whose crossing ends a shot."""
        return gates(self.ends)

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
        """What roundings of positions are measured by besides them: parameters, and numbers."""
        lengths = (p for p in self.parameters if p.unit == "m" and not p.infinite)
        given: tuple[sp.Expr, ...] = tuple(p.symbol for p in lengths)
        said = (e for s in self.surfaces for e in (s.distance, *s.bounds, *s.inside))
        sums = {part for e in said for part in release(e).atoms(sp.Add)}
        numbers = {abs(n) for part in sums for n in part.args if n.is_Rational}
        return (*given, sp.Add(*numbers)) if numbers else given


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
    """Return a parameter with a symbol of its name, assumed to be of the sign allowed."""
    assumption = {"positive": "positive", "nonnegative": "nonnegative", "any": "real"}[sign]
    symbol = ParameterSymbol(name, **{assumption: True})
    return Parameter(symbol, unit, summary, default, sign, upper, latex, lower, infinite)
