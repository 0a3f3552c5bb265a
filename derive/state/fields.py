"""The fields of a shot, which it keeps from event to event, and the results made of them.

A `ResultField` is the one record of a result. The generated NumPy module of a scene carries it as
data, and engines, `Shots`, tables, tallies, certificates, the command line and the pages read it
there.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import inf

import sympy as sp

from ..errors import contact_frames, provisional, tighter_bounds
from ..symbolic.error_terms import ERRORS
from ..symbolic.symbols import STATE

IN_FLIGHT = -1
"""Outcome of a shot that has not ended."""

NONE = -1
"""Index that stands for no surface or body."""


@dataclass(frozen=True)
class Field:
    """A number that a shot keeps from event to event.

    Attributes
    ----------
    name
        Its variable.
    start
        Its value at the release; None if the caller gives it.
    summary
        Its meaning.
    is_diagnostic
        True if the field never influences the trajectory. A loop without error bounds leaves it
        out, as if it stayed at its start.
    is_tightening
        True if only a shot whose bounds are tightened needs the field.
    """

    name: str
    start: float | None
    summary: str
    is_diagnostic: bool = False
    is_tightening: bool = False


NO_ROLLING = "no ball rolls"
"""Why a scene in which no ball rolls lacks the results of rolling."""

NO_ROLLING_IN_AIR = "no ball rolls in air"
"""Why a scene without air, or in which no ball rolls, lacks what is said of rolling in air."""


ALL_ALIKE = "the bounds of all shots are proved, or those of all are estimated"
"""Why a scene does not say of which shots the bounds are estimated."""


@dataclass(frozen=True)
class ResultField:
    """A result of a batch, one row for each shot: all that is known of it.

    Attributes
    ----------
    name
        Its name.
    dtype
        Its type, in NumPy's notation.
    columns
        The fields that it is made of; several fields make it an array of rows.
    summary
        Its meaning.
    row
        True if it is an array of rows even with one column.
    is_empty_if_invalid
        True if it is NaN for an invalid shot.
    is_diagnostic
        True if it needs diagnostic fields.
    is_on_request
        True if it is computed only when it is requested by name.
    is_counted
        True if it counts contacts by body where they happen, a column each; then no field holds
        them.
    switch
        The number of the caller that is 1 if any result with this switch is requested, and 2 if
        the event log has those with this switch, too, a row each; empty: none.
    absence
        Why some scenes lack it; empty: every scene has it.
    labels
        The names of its columns in tables; empty: its own name.
    units
        The SI unit of each column; empty: plain numbers.
    dimension, coordinates, unit_coordinate
        Of an array of rows in a dataset: the name of the second dimension, its values, and the name
        of a coordinate with the units of its values, empty for none.
    flags, first_flag
        The meanings of its values, from the lowest value on; empty: its values are numbers. Values
        below zero stand for nothing.
    is_at_end
        True if it describes the end of a shot: tables of studies have it as ``end_`` and its
        labels, empty for a shot that no end has stopped.
    tally, tally_summary
        The name and the meaning of the number of shots in which it is not zero, which studies
        count; empty: they do not.
    proved
        Its value in every shot that is proved to its end, which has bounced all the way; None: it
        has no such value.
    is_judged
        True if the judge computes it, under its name in `Certificate`. With neither this nor
        `proved` a shot that is settled keeps the engine's value, which is not proved and may be
        that of another course.
    """

    name: str
    dtype: str
    columns: tuple[str, ...]
    summary: str
    row: bool = False
    is_empty_if_invalid: bool = False
    is_diagnostic: bool = False
    is_on_request: bool = False
    is_counted: bool = False
    switch: str = ""
    absence: str = ""
    labels: tuple[str, ...] = ()
    units: tuple[str, ...] = ()
    dimension: str = ""
    coordinates: tuple[str, ...] = ()
    unit_coordinate: str = ""
    flags: tuple[str, ...] = ()
    first_flag: int = 0
    is_at_end: bool = False
    tally: str = ""
    tally_summary: str = ""
    proved: float | None = None
    is_judged: bool = False


EVENTS = {
    "impact": "The ball meets a body.",
    "roll": "Its bounces have accumulated: it stays in contact with the body.",
    "leave": "That contact ends.",
    "end": "The shot ends.",
}
"""The kinds of a row of the event log, with their meanings."""

REPORTED_ERRORS = ("position_claim", "velocity_claim", "spin_claim", "time_claim")
"""Bounds on the errors of a shot that has ended."""


_WATCHED = (
    (
        "last_grip_deficit",
        inf,
        "by how much friction is too little, F² - mu² N², a step ago; inf: not known",
    ),
    ("last_grip_deficit_rate", 0.0, "its rate then"),
    ("last_grip_clock", 0.0, "when that was"),
)


def fields(
    bodies: Sequence[str],
    rolls: bool = False,
    passage: bool = False,
    is_counted: bool = False,
    measured: bool = False,
    remembered: bool = False,
    proved: bool = False,
    provisional_bounds: bool = False,
) -> tuple[Field, ...]:
    """Return the fields of a shot.

    Parameters
    ----------
    bodies
        The bodies' names.
    rolls
        True if a ball can stay in contact with a surface.
    passage
        True if the scene has a ring that a ball can fall through.
    is_counted
        True if contacts are counted where they happen: then there is no field for each body.
    measured
        True if the sum of the scene's lengths is computed once for a shot.
    remembered
        True if a flight may begin on a plane besides the surface that was touched last.
    proved
        True if errors have proved bounds.
    provisional_bounds
        True if they have until a ball rolls.
    """
    rolling = (
        Field("held", NONE, "surface that it stays in contact with, -1: none"),
        Field("mode", 0.0, "0: in flight; 1 to 5: begins, goes on, ends, ends at an edge, starts"),
        Field("circled", 0.0, "1: it rolls on a ring, and does not leave since a turning point"),
        Field("assured", 0.0, "1: its bounces on the surface it touched last end there", True),
        Field("rolls", 0.0, "how many times it began to roll"),
        Field("slip_left", 0.0, "1: its bounces ended with slip left, which friction cannot stop"),
        Field("grip_lost", inf, "when friction first was too little for it to roll", True),
        *(Field(name, start, summary, True) for name, start, summary in _WATCHED),
    )
    state = (Field(s.name, None, "of the state") for s in STATE)
    carried = contact_frames.CARRIED if proved else ERRORS
    if provisional_bounds:
        carried = (*carried, *provisional.CARRIED)
    errors = (Field(s.name, 0.0, _carried(s), True) for s in carried)
    more = tighter_bounds.TIGHTENING if proved else ()
    tightening = (Field(s.name, 0.0, "to tighten bounds on errors", True, True) for s in more)
    counts = (Field(f"count_{k}", 0.0, f"contacts with {name}") for k, name in enumerate(bodies))
    claims = (
        Field(name, 0.0, "bound on the error at the last event", True) for name in REPORTED_ERRORS
    )
    through = Field("through", 0.0, "1: it has fallen through the ring, -1: it came up through it")
    lengths = Field("lengths", 0.0, "sum of the sizes of the scene's lengths", True)
    return (
        *state,
        *errors,
        *tightening,
        *([lengths] if measured else []),
        Field("clock", 0.0, "time of the last event, s since the release"),
        Field("clock_error", 0.0, "what the contacts' times were off by, summed", True),
        Field("last", None, "surface that was touched last, -1: none"),
        *(
            [Field("second", NONE, "plane that the flight began on besides, -1: none")]
            if remembered
            else []
        ),
        Field("first", NONE, "body that was touched first, -1: none"),
        Field("contacts", 0.0, "how many contacts there were"),
        *(() if is_counted else counts),
        *(rolling if rolls else ()),
        *([through] if passage else []),
        Field("uncertain", 0.0, "1: a decision lies within its rounding-error bound", True),
        *claims,
        Field("outcome", IN_FLIGHT, "how it ended, -1: in flight"),
    )


def _carried(symbol: sp.Symbol) -> str:
    """Return the meaning of a carried number."""
    if symbol in ERRORS:
        return f"carried error of {symbol.name[1:]}"
    if symbol == provisional.estimated:
        return "1: bounds on its errors are estimated from here on"
    if symbol == provisional.clock_bound:
        return "bound on what the contacts' times were off by, summed"
    if symbol in contact_frames.NORMS:
        return f"bound on the error of the {symbol.name.split('_')[0]}"
    if symbol in contact_frames.BOUNDS:
        return "bound on an error in the frame of the last contact"
    return "of the frame of the last contact"


_ROLLING = (
    ResultField(
        "rolls",
        "int32",
        ("rolls",),
        "how many times it began to roll",
        absence=NO_ROLLING,
        tally="rolled",
        tally_summary="shots that rolled",
        proved=0.0,
    ),
    ResultField(
        "airless_rolls",
        "bool",
        ("rolls",),
        "it rolled, without the air's force along the surface",
        absence=NO_ROLLING_IN_AIR,
        tally="rolled_airless",
        tally_summary="shots that rolled without the air's force along the surface",
        proved=0.0,
    ),
    ResultField(
        "slip_left",
        "bool",
        ("slip_left",),
        "its bounces ended with slip left, and so it is capped",
        absence=NO_ROLLING,
        tally="slip_left",
        tally_summary="capped shots whose bounces ended with slip left",
        proved=0.0,
    ),
    ResultField(
        "grip_lost",
        "float64",
        ("grip_lost",),
        "s, when friction first was too little for the ball to roll as it did; infinite: never",
        is_empty_if_invalid=True,
        is_diagnostic=True,
        is_on_request=True,
        absence=NO_ROLLING,
        units=("s",),
        proved=inf,
    ),
)

_ESTIMATED = ResultField(
    "estimated",
    "bool",
    ("estimated",),
    "its flag and the bounds on its errors are estimated, not proved",
    is_diagnostic=True,
    absence=ALL_ALIKE,
    proved=0.0,
)

_STATE_UNITS = ("m", "m", "m", "m/s", "m/s", "m/s", "rad/s", "rad/s", "rad/s")
_PARTS = ("position", "velocity", "spin")


def results(
    bodies: Sequence[str], outcomes: Iterable[str], is_counted: bool = False
) -> tuple[ResultField, ...]:
    """Return the results of shots, in the order of the targets' structs.

    Those that the scene lacks are among them; `absence` says why a scene may lack a result.

    Parameters
    ----------
    bodies
        The bodies' names.
    outcomes
        The outcomes' names, in order.
    is_counted
        True if contacts are counted where they happen.
    """
    state = tuple(symbol.name for symbol in STATE)
    return (
        ResultField(
            "outcome", "uint8", ("outcome",), "how it ended", flags=tuple(outcomes), is_judged=True
        ),
        ResultField("contacts", "int32", ("contacts",), "contacts before the end", is_judged=True),
        ResultField(
            "counts",
            "int32",
            tuple(f"count_{k}" for k in range(len(bodies))),
            "contacts with each body",
            row=True,
            is_counted=is_counted,
            is_judged=True,
            labels=tuple(f"{name}_contacts" for name in bodies),
            dimension="surface",
            coordinates=tuple(bodies),
        ),
        ResultField(
            "first",
            "int8" if len(bodies) <= 2**7 else "int16",
            ("first",),
            "first body touched, -1: none",
            flags=("none", *bodies),
            first_flag=NONE,
            is_judged=True,
        ),
        ResultField(
            "time",
            "float64",
            ("clock",),
            "s, at the end; capped or short: at the last contact",
            is_empty_if_invalid=True,
            units=("s",),
            is_at_end=True,
            is_judged=True,
        ),
        ResultField(
            "state",
            "float64",
            state,
            "then",
            row=True,
            is_empty_if_invalid=True,
            labels=state,
            units=_STATE_UNITS,
            dimension="component",
            coordinates=state,
            unit_coordinate="unit",
            is_at_end=True,
            is_judged=True,
        ),
        *_ROLLING,
        ResultField(
            "time_error",
            "float64",
            REPORTED_ERRORS[3:],
            "bound on the error of time",
            is_empty_if_invalid=True,
            is_diagnostic=True,
            is_on_request=True,
            switch="claims",
            units=("s",),
            is_judged=True,
        ),
        ResultField(
            "state_error",
            "float64",
            REPORTED_ERRORS[:3],
            "bounds on the errors of each component of position, velocity and spin",
            row=True,
            is_empty_if_invalid=True,
            is_diagnostic=True,
            is_on_request=True,
            switch="claims",
            labels=tuple(f"{part}_error" for part in _PARTS),
            units=_STATE_UNITS[::3],
            dimension="part",
            coordinates=_PARTS,
            is_judged=True,
        ),
        ResultField(
            "uncertain",
            "bool",
            ("uncertain",),
            "a decision lies within its rounding-error bound",
            is_diagnostic=True,
            is_judged=True,
        ),
        _ESTIMATED,
    )
