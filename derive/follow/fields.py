"""What a shot has: the fields that it takes from event to event, and the results made of them.

Every target's variables, structs, arrays and documentation of results come from these tables.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf

from ..errors.tangent import ERRORS
from ..ground.symbols import STATE

IN_FLIGHT = -1
"""The outcome of a shot that has not ended."""

NONE = -1
"""The index of no surface."""


@dataclass(frozen=True)
class Field:
    """A number that a shot takes from event to event.

    Attributes
    ----------
    name
        Its variable.
    start
        Its value at the release; None where the caller gives it.
    bounds
        Whether it only bounds errors, or is only told: then the path does not depend on it, and a
        loop from which no bounds are wanted goes without it, as if it stayed at its start.
    """

    name: str
    start: float | None
    summary: str
    bounds: bool = False


@dataclass(frozen=True)
class Result:
    """A result of a batch, one row for each shot.

    Attributes
    ----------
    dtype
        Its type, as NumPy writes it.
    columns
        The fields that it is made of; more than one make it an array of rows.
    blank
        Whether it is not a number where the shot is invalid.
    bounds
        Whether it needs the fields that bound errors, or are only told.
    asked
        Whether it is had by name only.
    tallied
        Whether it counts contacts by body, a column each, where they happen: of the fields that it
        would be made of there is none.
    """

    name: str
    dtype: str
    columns: tuple[str, ...]
    summary: str
    blank: bool = False
    bounds: bool = False
    asked: bool = False
    row: bool = False
    tallied: bool = False


EVENTS = {
    "impact": "The ball meets a body.",
    "roll": "Its bounces have accumulated: it stays in contact with the body.",
    "leave": "That contact ends.",
    "end": "The shot ends.",
}
"""What a row of the event log is, and what that says."""

CLAIMS = ("position_claim", "velocity_claim", "spin_claim", "time_claim")
"""Bounds on the errors of a shot that has ended."""


_WATCHED = (
    ("taut", inf, "by how much friction is too little, F² - mu² N², a step ago; inf: not known"),
    ("taut_rate", 0.0, "its rate then"),
    ("taut_clock", 0.0, "when that was"),
)


def fields(
    bodies: Sequence[str],
    rolls: bool = False,
    passage: bool = False,
    tallied: bool = False,
    measured: bool = False,
) -> tuple[Field, ...]:
    """Return the fields of a shot among bodies, which it may stay on, or pass a ring's disc.

    Of many bodies contacts are tallied where they happen: no shot then has a number for each. Their
    sizes are measured once: then it has the sum.
    """
    kept = (
        Field("held", NONE, "surface that it stays in contact with, -1: none"),
        Field("mode", 0.0, "0: in flight; 1, 2, 3: contact begins, goes on, ends"),
        Field("circled", 0.0, "1: it rolls on a ring, and does not leave since a turning point"),
        Field("assured", 0.0, "1: its bounces on the surface it touched last end there", True),
        Field("rolls", 0.0, "how many times it began to roll"),
        Field("slip_left", 0.0, "1: its bounces ended with slip left, which friction cannot stop"),
        Field("grip_lost", inf, "when friction first was too little for it to roll", True),
        *(Field(name, start, summary, True) for name, start, summary in _WATCHED),
    )
    state = (Field(s.name, None, "of the state") for s in STATE)
    errors = (Field(s.name, 0.0, f"carried error of {s.name[1:]}", True) for s in ERRORS)
    counts = (Field(f"count_{k}", 0.0, f"contacts with {name}") for k, name in enumerate(bodies))
    claims = (Field(name, 0.0, "bound on the error at the end", True) for name in CLAIMS)
    through = Field("through", 0.0, "1: it has fallen through the ring, -1: it came up through it")
    lengths = Field("lengths", 0.0, "sum of the sizes of the scene's lengths", True)
    return (
        *state,
        *errors,
        *([lengths] if measured else []),
        Field("clock", 0.0, "time of the last event, s since the release"),
        Field("clock_error", 0.0, "what the contacts' times were off by, summed", True),
        Field("last", None, "surface that was touched last, -1: none"),
        Field("first", NONE, "body that was touched first, -1: none"),
        Field("contacts", 0.0, "how many contacts there were"),
        *(() if tallied else counts),
        *(kept if rolls else ()),
        *([through] if passage else []),
        Field("uncertain", 0.0, "1: a decision lies within its rounding-error bound", True),
        *claims,
        Field("outcome", IN_FLIGHT, "how it ended, -1: in flight"),
    )


_ROLLING = (
    Result("rolls", "int32", ("rolls",), "how many times it began to roll"),
    Result(
        "slip_left",
        "bool",
        ("slip_left",),
        "its bounces ended with slip left, and so it is capped",
    ),
    Result(
        "grip_lost",
        "float64",
        ("grip_lost",),
        "s, when friction first was too little for the ball to roll as it did; infinite: never",
        blank=True,
        bounds=True,
        asked=True,
    ),
)


def results(
    bodies: Sequence[str], rolls: bool = False, tallied: bool = False
) -> tuple[Result, ...]:
    """Return the results of shots among bodies, in the order of the targets' structs."""
    counts = tuple(f"count_{k}" for k in range(len(bodies)))
    state = tuple(symbol.name for symbol in STATE)
    return (
        Result("outcome", "uint8", ("outcome",), "how it ended"),
        Result("contacts", "int32", ("contacts",), "contacts before the end"),
        Result("counts", "int32", counts, "contacts with each body", row=True, tallied=tallied),
        Result(
            "first",
            "int8" if len(bodies) <= 2**7 else "int16",
            ("first",),
            "first body touched, -1: none",
        ),
        Result(
            "time",
            "float64",
            ("clock",),
            "s, at the end; capped or short: at the last contact",
            blank=True,
        ),
        Result("state", "float64", state, "then", blank=True, row=True),
        *(_ROLLING if rolls else ()),
        Result(
            "time_error",
            "float64",
            CLAIMS[3:],
            "bound on the error of time",
            blank=True,
            bounds=True,
            asked=True,
        ),
        Result(
            "state_error",
            "float64",
            CLAIMS[:3],
            "bounds on the errors of each component of position, velocity and spin",
            blank=True,
            bounds=True,
            asked=True,
            row=True,
        ),
        Result(
            "uncertain",
            "bool",
            ("uncertain",),
            "a decision lies within its rounding-error bound",
            bounds=True,
        ),
    )
