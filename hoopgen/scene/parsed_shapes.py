"""Bodies and ends of a scene as formulas, as they are read of what its author wrote."""

from __future__ import annotations

from dataclasses import dataclass, field

from .bounds import Terms
from .contact_laws import Contact
from .formulas import Formula
from .profile import Profile


@dataclass(frozen=True)
class Shape:
    """A body or an end as formulas: each is zero, a whole number or the name of an input.

    Attributes
    ----------
    name, kind
        Its own, and that of its class in small letters.
    sizes
        By argument.
    axis
        Coordinate and direction of its axis.
    inside
        Whether it is touched from inside.
    law
        Of its contacts; None of an end.
    bounds
        Where it is there, asked of the ball's centre; of a torus, a box, a cone and a surface of
        revolution asked of the point of contact.
    condition
        Of a surface of one's own.
    """

    name: str
    kind: str
    sizes: tuple[tuple[str, Formula], ...]
    axis: tuple[int, int] = (2, 1)
    inside: bool = False
    law: Contact | None = None
    bounds: tuple[Terms, ...] = ()
    condition: Terms = ()

    def __getitem__(self, argument: str) -> Formula:
        return dict(self.sizes)[argument]


@dataclass(frozen=True)
class RevolvedShape(Shape):
    """A surface of revolution.

    Attributes
    ----------
    profile
        The line that is turned about the axis.
    """

    profile: Profile = field(kw_only=True)
