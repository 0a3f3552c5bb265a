"""The kernels of a scene that belong to no surface: flight, contact frame, errors, validity."""

from __future__ import annotations

from collections.abc import Set

import sympy as sp

from ..contact.frame import contact_frame
from ..contact.no_slip import impact_through_frame
from ..errors import contact_frames, propagation, provisional
from ..events import bounding_boxes, event_polynomials
from ..events.air import over_budget
from ..events.predicates import excess
from ..ir.kernel import Kernel, decision, kernel
from ..motion.air import AirFlight
from ..motion.air_piece import piece
from ..motion.air_series import FIRST_SINGLE, ORDER, SHORT, SINGLE_SERIES
from ..scenes import premises, sinking, validity
from ..scenes.scene import Scene
from ..symbolic import error_terms
from ..symbolic.conditionals import AtMost, barrier, maximum
from ..symbolic.number_range import MAX_FLIGHT, MAX_SPEED
from ..symbolic.symbols import POSITION, SPIN, VELOCITY, normal, spin, velocity
from .arguments import FRAME, RESTITUTION, components, unchecked_argument_order
from .variation import piece_variations, scene_variations

MOTION = (*VELOCITY, *SPIN)


def scene_kernels(
    scene: Scene, order: tuple[sp.Symbol, ...], tabled: Set[int]
) -> dict[str, Kernel]:
    """Return the kernels of a scene that belong to no surface, by name.

    Parameters
    ----------
    scene
        The scene.
    order
        The calling order of arguments.
    tabled
        Indices of the surfaces that share their kernels with others.
    """
    kernels = (
        *_motion(scene, order),
        *_arrivals(scene, order, tabled),
        *_pieces(scene, order),
        *_errors(scene, order),
        *_validity(scene, tabled),
        *scene_variations(scene, order),
        *piece_variations(scene, order),
    )
    return {kernel.name: kernel for kernel in kernels}


def flight_boxes(scene: Scene, order: tuple[sp.Symbol, ...]) -> dict[str, Kernel]:
    """Return the kernels of the boxes that a flight is in.

    Parameters
    ----------
    scene
        The scene, whose flight is a parabola or a series in air.
    order
        The symbols in the order of arguments.

    Returns
    -------
    dict
        The kernels by name; a box is a centre and half sizes, m.
    """
    if isinstance(scene.flight, AirFlight):
        return {
            "swept": kernel(
                "swept",
                bounding_boxes.piece_box(scene.flight),
                order,
                "Box that the ball is in until the horizon: its centre and its half sizes.",
                "the straight way from the start, and what the piece is off it",
            )
        }
    return {
        "swept": kernel(
            "swept",
            bounding_boxes.flight_box(scene.parabola),
            order,
            "Box that the ball is in until the horizon: its centre and its half sizes.",
            "Eq. 3, its ends and its apex",
        ),
        "half_flight_boxes": kernel(
            "half_flight_boxes",
            bounding_boxes.half_flight_boxes(scene.parabola),
            order,
            "Boxes of the first and the second half of the flight until the horizon.",
            "Eq. 3, the chords of both and what it is off them",
        ),
    }


def _motion(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the flight, the contact frame, and the article's impact through it."""
    through = impact_through_frame(FRAME, velocity, spin, scene.ball, RESTITUTION)
    return (
        kernel(
            "flight",
            components((*POSITION, *VELOCITY), *scene.flight.at()),
            order,
            "Position and velocity at time t of a flight.",
            scene.flight.source,
        ),
        kernel(
            "contact_frame",
            {symbol.name: e for symbol, e in zip(FRAME, contact_frame(), strict=True)},
            order,
            "Contact frame R = [n1 n2 n3] of a unit normal.",
            "Eqs. 7-10, Eq. 7 with the smallest component",
        ),
        kernel(
            "impact_through_frame",
            components(MOTION, *through),
            order,
            "Velocity and spin after an impact, through the contact frame.",
            "Eqs. 11-17 by the closed-form inverse",
        ),
    )


def _arrivals(scene: Scene, order: tuple[sp.Symbol, ...], tabled: Set[int]) -> tuple[Kernel, ...]:
    """Return the kernels that the searches of all surfaces share."""
    # Of many bodies the sum of the lengths is computed once for a shot.
    lengths = (validity.lengths,) if tabled else scene.lengths
    return (
        kernel(
            "crossing",
            event_polynomials.crossing(),
            order,
            "Clearance, positive if a crossing is certain, and a bound on its delay.",
            "Taylor's theorem with the margins of the gap and its rate",
        ),
        kernel(
            "allowance",
            event_polynomials.error_budget(scene.flight),
            order,
            "Errors of the state that a search allows for, and by how much the errors exceed them.",
            "a share of the size of the flight",
        ),
        kernel(
            "horizon",
            event_polynomials.padded_horizon(scene.flight),
            order,
            "Time after which no event is wanted, and how long that is after t.",
            "the earliest arrival, with room for its delay",
        ),
        kernel(
            "scale",
            {
                "extent": sp.Add(*map(sp.Abs, POSITION)),
                "speed": sp.Add(*map(sp.Abs, VELOCITY)),
                "excess": _flight_size(scene) - MAX_FLIGHT,
            },
            order,
            "Sums of the sizes of position and velocity, and the excess of the flight's size.",
            "the measure of rounding errors",
        ),
        kernel(
            "displacement",
            {"margin": event_polynomials.displacement(scene.flight, lengths)},
            order,
            "Bound on the error of a length at a computed arrival.",
            "running error analysis",
        ),
    )


def _pieces(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the kernels of a flight's pieces, if the flight has pieces."""
    flight = scene.flight
    if not isinstance(flight, AirFlight):
        return ()
    source = "Taylor series of gravity, buoyancy, drag and Magnus force"
    rates = kernel(
        "air_rates",
        flight.rates(),
        order,
        "Rates of drag and Magnus force, and gravity less buoyancy.",
        "equations of motion",
    )
    orders = [
        kernel(
            f"air_order_{k}",
            flight.order(k, SINGLE_SERIES) if k >= FIRST_SINGLE else flight.order(k),
            order,
            f"Coefficients of order {k} of the speed through the air, and the next of the velocity."
            if k < ORDER
            else f"Coefficient of order {k} of the speed through the air.",
            source,
            k >= FIRST_SINGLE,
        )
        for k in range(ORDER + 1)
    ]
    short = {symbol.name: given for given, symbol in SHORT.items()}
    return (
        rates,
        *orders[:FIRST_SINGLE],
        kernel("air_short", short, order, "The same in single precision.", source, single=True),
        *orders[FIRST_SINGLE:],
        kernel(
            "air_tail",
            flight.tail(),
            order,
            "The coefficients in single precision, zero where they do not fit into it.",
            source,
            single=True,
        ),
        kernel(
            "piece",
            piece(flight),
            order,
            "Length of a piece, what it adds to errors, and bounds on its motion.",
            f"{source}, Gronwall's lemma",
            single=True,
        ),
        kernel(
            "piece_excess",
            {
                "excess": maximum(
                    excess,
                    flight.excess(),
                    over_budget(flight),
                    sinking.excess(scene),
                )
            },
            (excess, sinking.spin_error, *order),
            "The excess of the flight's size, or that of errors over those that are bounded.",
            "the bounds' premises",
        ),
        kernel(
            "piece_end",
            sinking.piece_end(scene),
            order,
            "The end of a piece as an arrival, now if the ball can never meet anything again.",
            "the sign of the vertical acceleration",
        ),
        kernel(
            "carry_piece",
            propagation.errors_at_piece_end(flight),
            order,
            "Errors of position and velocity at the end of a piece, from those at its start.",
            "first-order derivative of the equations of motion, with roundings",
            scene.single_errors,
        ),
    )


def _flight_size(scene: Scene) -> sp.Expr:
    """Return the largest of the sizes of a flight: coordinates, speed and v²/g.

    Where gravity may be zero, the time limit bounds what v²/g does not (`MAX_SPEED`).
    """
    place, fastest = (barrier(sum(map(sp.Abs, of))) for of in (POSITION, VELOCITY))
    if not scene.flight.falls:
        return maximum(place, fastest * (MAX_FLIGHT / MAX_SPEED))
    return maximum(place, fastest, barrier(fastest**2 * barrier(1 / scene.flight.strength)))


def _errors(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the kernels of error propagation through a flight, and of the bounds from errors."""
    if scene.proves_errors:
        return _proved_errors(scene, order)
    single = scene.single_errors
    of_decisions, reported = propagation.scaled_errors, propagation.scaled_errors
    if scene.proves_bounces:
        of_decisions = reported = provisional.error_bounds
    return (
        *(_proved_bounces(scene, order) if scene.proves_bounces else ()),
        kernel(
            "carry_flight",
            propagation.errors_at_contact(scene.flight, scene.rolls),
            order,
            "Errors of the state at the end of a flight to a surface, from those at its start.",
            f"derivative of {scene.flight.source} and of the contact time, with roundings",
            single,
        ),
        kernel(
            "carry_time",
            propagation.errors_at_time(scene.flight),
            order,
            "Errors of the state at the time limit, from those at the start of the flight.",
            f"derivative of {scene.flight.source}, with roundings",
            single,
        ),
        kernel(
            "error_bounds",
            of_decisions(error_terms.DECISION_FACTOR),
            order,
            "Bounds on the errors of state and time that decisions allow for.",
            "the carried errors times a factor",
            single,
        ),
        kernel(
            "claimed_errors",
            reported(propagation.REPORTED_FACTOR),
            order,
            "Bounds on the errors of state and time that are reported.",
            "the carried errors times a larger factor",
            single,
        ),
    )


def _proved_bounces(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the kernels of proved bounds on the errors of balls that have not rolled."""
    flight = scene.parabola
    return (
        _normal_velocity(order),
        kernel(
            "bound_end",
            contact_frames.errors_at_end(flight),
            order,
            "Bounds on the errors where a flight crosses the end plane.",
            f"{flight.source}, with roundings",
            True,
        ),
        kernel(
            "bound_time",
            provisional.bounds_at_time(flight),
            order,
            "Bounds on the errors at the time limit.",
            f"{flight.source}, with roundings",
            True,
        ),
        kernel(
            "estimated_after_contact",
            provisional.estimated_after_contact(scene.ball, scene.flight.strength),
            order,
            "Whether the bounds of a shot are estimated from a contact on.",
            "comparison",
        ),
        *provisional.KERNELS.values(),
        *_premises(scene, order),
    )


def _normal_velocity(order: tuple[sp.Symbol, ...]) -> Kernel:
    return kernel(
        "normal_velocity",
        {contact_frames.normal_velocity.name: barrier(velocity.dot(normal))},
        order,
        "Velocity along the normal before the impact.",
        "Table 2",
    )


def _premises(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the kernel of the premises of proved bounds, if a scene has some."""
    presupposed = premises.premises(scene)
    if presupposed is None:
        return ()
    return (
        kernel(
            "premises",
            presupposed,
            order,
            "Whether a shot released in flight fulfils the premises of the proved bounds.",
            "conservation of energy",
        ),
    )


def _proved_errors(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the kernels of proved bounds on errors; those at a contact are of its law."""
    flight, bounds = scene.parabola, contact_frames.error_bounds()
    return (
        _normal_velocity(order),
        kernel(
            "carry_end",
            contact_frames.errors_at_end(flight),
            order,
            "Bounds on the errors where a flight crosses the end plane.",
            f"{flight.source}, with roundings",
            True,
        ),
        kernel(
            "unbounded",
            contact_frames.unbounded(),
            order,
            "Whether a bound on an error is not finite.",
            "comparison",
            True,
        ),
        kernel(
            "carry_time",
            contact_frames.errors_at_time(flight),
            order,
            "Bounds on the errors at the time limit.",
            f"{flight.source}, with roundings",
            True,
        ),
        *(
            kernel(name, bounds, order, summary, "the carried bounds", True)
            for name, summary in (
                ("error_bounds", "Bounds on the errors of state and time that decisions use."),
                ("claimed_errors", "Bounds on the errors of state and time that are reported."),
            )
        ),
        *_premises(scene, order),
    )


def _validity(scene: Scene, tabled: Set[int]) -> tuple[Kernel, ...]:
    """Return the kernels that validate parameters and start, whatever the numbers are."""
    order = unchecked_argument_order(scene)
    near = {} if tabled else validity.near_surface(scene)
    near_kernel = kernel(
        "aside",
        near,
        order,
        "Whether the ball starts near a surface; otherwise its start is valid and decided.",
        "Table 2",
    )
    size = kernel(
        "measure",
        validity.scene_size(scene),
        order,
        "Sum of the sizes of the scene's lengths.",
        "the measure of roundings",
    )
    size_of_shot = decision(
        "begun_with", {"lengths": validity.measured}, "The scene's lengths, as a field of the shot."
    )
    left = validity.left_surface(scene)
    left_surface = kernel(
        "left_surface",
        left,
        order,
        "The surface that a ball leaves at its start, by its body.",
        "the surface that the ball touches",
    )
    on_body = decision(
        "starts_on_body",
        {
            "on_body": AtMost(0, validity.last),
            str(validity.left_middle): -1,
            str(validity.left_reach): sp.Rational(1, 2),
        },
        "Whether the ball leaves a body at its start; start values: it leaves none.",
    )
    return (
        kernel(
            "allowed",
            validity.allowed(scene),
            order,
            "1 if finite parameters are allowed.",
            "the scene's requirements",
        ),
        kernel(
            "parameters_in_range",
            validity.parameters_in_range(scene),
            (*order, validity.permission),
            "Whether the parameters are allowed, and no arithmetic with them over- or underflows.",
            "the range of numbers",
        ),
        kernel(
            "valid",
            validity.valid(scene, tabled),
            order,
            "1 if the ball overlaps no surface; 1 if that is undecided.",
            "Table 2",
        ),
        *([near_kernel] if near else []),
        *([on_body, left_surface] if left else []),
        *([size, size_of_shot] if tabled else []),
    )
