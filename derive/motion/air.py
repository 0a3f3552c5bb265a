"""Flight through air: Taylor series of its pieces.

The forces on a ball of mass m, radius R and constant spin w are gravity less buoyancy, drag and the
Magnus force. Per unit mass, with the density ϱ of the air and the area A = π R² of the ball,

    v' = f(v) = g_e - k_d σ v + Ω × v,   σ = √(v·v + v_s²),
    k_d = ϱ A C_d / 2m,   Ω = ϱ A R C_m w / 2m,   g_e = g (1 - ϱ (4/3) π R³ / m).

The speed v_s makes the drag analytic where the ball is at rest. The coefficients of v and σ in time
follow from those before:

    q_k = Σ V_i·V_{k-i} (+ v_s² at k = 0),   σ_0 = √q_0,   σ_k = (q_k - Σ' σ_i σ_{k-i}) / 2σ_0,
    V_{k+1} = (-k_d Σ σ_i V_{k-i} + Ω × V_k + g_e [k = 0]) / (k+1),

where Σ' leaves out the first and the last term. Each order is a kernel of its own, since the
expression of one in terms of the state alone would be exponentially long.

The terms of high order are small, and so are their roundings: from the order `FIRST_SINGLE` on the
coefficients are computed in single precision.

A flight is a sequence of pieces, each with its own series. `air_piece` has their length, and the
proved bound on what they leave out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import sympy as sp

from ..symbolic.conditionals import Choose, Less, absolute, barrier
from ..symbolic.error_terms import dv, dw, dx
from ..symbolic.polynomials import Coefficients, derivative, horner, nested
from ..symbolic.rounding import Rounded, extent, position_error, velocity_error
from ..symbolic.symbols import POSITION, VELOCITY, t, velocity
from .air_forces import AirConstants
from .air_series import (
    AIRSPEEDS,
    BOUNDS,
    CARRIED_SHARE,
    DOUBLE_SERIES,
    ORDER,
    RATES,
    SHORT,
    SINGLE_SERIES,
    SKETCH_TERMS,
    TAIL,
    TUBE,
    VELOCITIES,
    Series,
    drag_rate,
    free_fall,
    growth,
    inverse_airspeed,
    latest_last,
    magnus_rate,
    piece,
    piece_acceleration,
    piece_jerk,
    piece_place_error,
    piece_speed,
    piece_speed_error,
    tail_lost,
    total,
    unproved,
)
from .flight import Flight, SurfaceForce


@dataclass(frozen=True)
class AirFlight(Flight):
    """The flight through air, in pieces that each have a series of their own.

    Attributes
    ----------
    constants
        The parameters of the air and the ball.
    """

    constants: AirConstants = field(kw_only=True)

    @property
    def source(self) -> str:
        """The series of a piece."""
        return "the piece's Taylor series"

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The coefficients of a piece, its length and bounds, and the rates of the forces."""
        series, rates = self.coefficients[: -len(RATES)], self.coefficients[-len(RATES) :]
        return (*series, inverse_airspeed, *BOUNDS, *rates, *SHORT.values(), tail_lost)

    @property
    def coefficients(self) -> tuple[sp.Symbol, ...]:
        """The coefficients of a piece's series, and the rates of the forces."""
        return (*(v for vector in VELOCITIES[1:] for v in vector), *AIRSPEEDS, *RATES)

    @property
    def velocities(self) -> tuple[sp.Matrix, ...]:
        """The coefficients of the velocity, by order."""
        return VELOCITIES

    @property
    def fall(self) -> sp.Matrix:
        """g_e, with zero along the axes without gravity."""
        axes = zip(self.acceleration, free_fall, strict=True)
        return sp.Matrix([0 if a == 0 else symbol for a, symbol in axes])

    @property
    def path(self) -> dict[sp.Symbol, Coefficients]:
        """The Taylor polynomials of position, of degree P + 1."""
        rows = ([v[axis] for v in self.velocities] for axis in range(3))
        return {
            place: [place, *(v / (k + 1) for k, v in enumerate(row))]
            for place, row in zip(POSITION, rows, strict=True)
        }

    @property
    def span(self) -> sp.Expr:
        """The length of the piece."""
        return piece

    @property
    def remainder(self) -> sp.Expr:
        """The error of the position that the piece adds."""
        return piece_place_error

    @property
    def surface_force(self) -> SurfaceForce:
        """Buoyancy, and the Magnus force of a spin that rolls; drag is along the surface.

        With R (w × n) = v the Magnus force k_m w × v is -k_m v²/R along the normal.
        """
        of = self.constants
        return SurfaceForce(of.buoyancy, barrier(of.lift_per_spin / of.ball_radius))

    def disturbance(self, speed: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on the air's force, buoyancy included, and on its change by the velocity.

        They are b g + L v and L = 2 k_d (v + v_s) + k_m v/R.
        """
        of = self.constants
        spun = barrier(absolute(of.lift_per_spin) * barrier(speed / of.ball_radius))
        slope = barrier(barrier(2 * drag_rate * barrier(speed + of.smoothing_speed)) + spun)
        return barrier(of.buoyancy * self.gravity + barrier(slope * speed)), slope

    def resistance(self, speed: sp.Expr) -> sp.Expr:
        """Return a bound on the drag per unit mass at speeds up to one, m/s²."""
        return barrier(drag_rate * barrier(speed * barrier(speed + self.constants.smoothing_speed)))

    def start(self, time: sp.Expr = t) -> sp.Matrix:
        """Return the position at the start of a piece, given position and velocity at its end.

        With x = x_0 + Σ V_k t^(k+1)/(k+1) and v = Σ V_k t^k, x_0 = x - v t + Σ k V_k t^(k+1)/(k+1).
        """
        found = []
        for axis, (place, v) in enumerate(zip(POSITION, VELOCITY, strict=True)):
            bends = [sp.Rational(k, k + 1) * VELOCITIES[k][axis] for k in range(1, ORDER + 1)]
            bent = barrier(time * barrier(horner(bends, time)))
            found.append(place - barrier(time * barrier(v - bent)))
        return sp.Matrix(found)

    def at(self, time: sp.Expr = t) -> tuple[sp.Matrix, sp.Matrix]:
        """Return position and velocity on the series, `time` after the state, in Horner form."""
        means = self.mean_velocity(time)
        places = [start + barrier(time * mean) for start, mean in zip(POSITION, means, strict=True)]
        rows = ([v[axis] for v in self.velocities] for axis in range(3))
        return sp.Matrix(places), sp.Matrix([horner(row, time) for row in rows])

    def mean_velocity(self, time: sp.Expr = t) -> list[sp.Expr]:
        """Return the displacement over the time.

        V_k t^k/(k + 1) is V_k times the products of t j/(j + 1), which all axes share.
        """
        shares = [barrier(time * sp.Rational(k, k + 1)) for k in range(1, len(self.velocities))]
        rows = ([v[axis] for v in self.velocities] for axis in range(3))
        names = (rf"\bar v_{axis}" for axis in "xyz")
        return [barrier(nested(row, shares), name) for row, name in zip(rows, names, strict=True)]

    def acceleration_at(self, time: sp.Expr = t, terms: int | None = None) -> list[sp.Expr]:
        """Return the acceleration on the series, or by its first terms.

        Parameters
        ----------
        time
            Time since the start of the piece.
        terms
            Number of terms from the lowest order on; None for all.
        """
        rows = (derivative([v[axis] for v in self.velocities])[:terms] for axis in range(3))
        names = (rf"\ddot {axis}_t" for axis in "xyz")
        return [barrier(horner(row, time), name) for row, name in zip(rows, names, strict=True)]

    def quantities(self) -> dict[str, sp.Expr]:
        """Return mean velocity, position, velocity and acceleration at time t, by their LaTeX."""
        means, rates = self.mean_velocity(), self.acceleration_at()
        around = ({str(e.name): e for e in one} for one in (means, rates))
        return next(around) | super().quantities() | next(around)

    @property
    def present_acceleration(self) -> tuple[sp.Expr, ...]:
        """The force per unit mass at the present velocity."""
        size = barrier(sp.sqrt(barrier(velocity.dot(velocity) + self.smoothing)))
        braking = barrier(drag_rate * size)
        turned = magnus_rate.cross(velocity)
        return tuple(
            barrier(barrier(barrier(turned[k]) - barrier(braking * velocity[k])) + self.fall[k])
            for k in range(3)
        )

    @property
    def smoothing(self) -> sp.Expr:
        """v_s², m²/s²."""
        return barrier(self.constants.smoothing_speed**2)

    def along(self) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """Return the changes of position and velocity at time t by errors at the start.

        The force's derivative is that at the end: to first order in its growth within a piece.
        """
        size = barrier(sp.sqrt(barrier(velocity.dot(velocity) + self.smoothing)))
        stretch = barrier(barrier(velocity.dot(sp.Matrix(dv))) / size)
        magnus, spun = magnus_rate.cross(sp.Matrix(dv)), sp.Matrix(dw).cross(velocity)
        places, moving = [], []
        for k in range(3):
            braked = barrier(drag_rate * barrier(size * dv[k] + velocity[k] * stretch))
            lifted = barrier(self.constants.lift_per_spin * barrier(spun[k]))
            change = barrier(t * barrier(barrier(barrier(magnus[k]) + lifted) - braked))
            places.append(barrier(dx[k] + t * barrier(dv[k] + change / 2)))
            moving.append(barrier(dv[k] + change))
        return places, moving

    def enclosure(
        self, latest: sp.Expr, of: Series = DOUBLE_SERIES, wider: sp.Expr = sp.Integer(0)
    ) -> list[tuple[sp.Expr, sp.Expr]]:
        """Return for each axis the centre and the half size of a box of the path, without errors.

        Up to a time T the parabola v t + V_1 t²/2 is within |V_1| T²/8 of its chord, and the path
        within j T³/6 of the parabola, with the bound j on the velocity's second derivative.

        Parameters
        ----------
        latest
            T.
        of
            The symbols of the coefficients.
        wider
            A length by which the box is wider.
        """
        half_time = barrier(latest / 2)
        square = barrier(half_time**2)
        cube = barrier(square * half_time)
        bent = barrier(
            wider + piece_jerk * cube * (sp.Rational(4, 3) * (1 + sp.Rational(1, 2**18)))
        )
        found = []
        for place, v, rate in zip(POSITION, *of.velocities[:2], strict=True):
            turn = barrier(rate * square)
            half = barrier(v * half_time + turn)
            found.append(
                (barrier(place + half), barrier(absolute(half) + absolute(turn) / 2 + bent))
            )
        return found

    def path_lengths(self) -> list[sp.Expr]:
        """Return a bound on the way along each axis in a flight of time t, given its end."""
        return [barrier(2 * absolute(v) * t + piece_acceleration * t**2) for v in velocity]

    def added_errors(self) -> tuple[sp.Expr, sp.Expr]:
        """Return a share of what the piece leaves out, infinite if that is not proved."""
        left_out = (piece_place_error, piece_speed_error)
        place, moving = (barrier(CARRIED_SHARE * error + unproved) for error in left_out)
        return place, moving

    def returning_error(self) -> sp.Expr:
        """Return a share of what the piece leaves out up to time t.

        The velocity's error grows at most as the time does, from zero.
        """
        share = barrier(CARRIED_SHARE * piece_speed_error)
        return barrier(barrier(share * barrier(t / piece)) * t)

    def size(self, latest: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on every coordinate and every velocity up to the time `latest`."""
        return barrier(extent + latest * piece_speed), piece_speed

    def rounding(self, latest: sp.Expr) -> tuple[Rounded, Rounded]:
        """Return error bounds of any coordinate and any velocity up to the time `latest`."""
        furthest, fastest = self.size(latest)
        moved = barrier(growth * velocity_error + piece_speed_error)
        shift = barrier(
            position_error + latest * barrier(growth * velocity_error) + piece_place_error
        )
        return Rounded(furthest, shift), Rounded(fastest, moved)

    def mean_rounding(self, latest: sp.Expr) -> Rounded:
        """Return the size and the error of a mean velocity: its coefficients are smaller."""
        del latest
        moved = barrier(growth * velocity_error + piece_speed_error)
        return Rounded(piece_speed, moved)

    def rates(self) -> dict[str, sp.Expr]:
        """Return k_d, Ω and g_e from parameters and spin."""
        of = self.constants
        lightened = barrier(1 - of.buoyancy)
        falls = zip(free_fall, self.acceleration, strict=True)
        return {
            drag_rate.name: of.drag,
            **{s.name: value for s, value in zip(magnus_rate, of.rotation, strict=True)},
            **{s.name: barrier(a * lightened) for s, a in falls if a != 0},
        }

    def order(self, k: int, of: Series = DOUBLE_SERIES) -> dict[str, sp.Expr]:
        """Return σ_k and V_{k+1} from the orders before; of σ_P no velocity follows.

        Parameters
        ----------
        k
            The order.
        of
            The symbols of the orders before, and of the rates.
        """
        if k == 0:
            square = total([barrier(of.velocities[0].dot(of.velocities[0]))])
            size = barrier(sp.sqrt(barrier(square + self.smoothing)))
        else:
            size = barrier(self._half_square(k, of) * of.inverse)
        outputs = {AIRSPEEDS[k].name: size}
        if k == 0:
            outputs[inverse_airspeed.name] = barrier(1 / size)
        if k < ORDER:
            found = self._next(k, [*of.airspeeds[:k], size], of)
            outputs |= dict(zip(map(str, VELOCITIES[k + 1]), found, strict=True))
        return outputs

    def tail(self) -> dict[str, sp.Expr]:
        """Return the coefficients in single precision, or zeros if one of them does not fit.

        An infinite coefficient makes all that follow infinite or no numbers.
        """
        last = (AIRSPEEDS[ORDER], *VELOCITIES[ORDER])
        fits = Less(barrier(sum(map(absolute, last))), sp.oo)
        kept = {symbol.name: Choose(fits, symbol, 0) for symbol in TAIL}
        return kept | {tail_lost.name: Choose(fits, 0, sp.oo)}

    @staticmethod
    def _half_square(k: int, of: Series) -> sp.Expr:
        """Return half of q_k less Σ' σ_i σ_{k-i}; of equal products it computes one."""
        dots = [barrier(of.velocities[i].dot(of.velocities[k - i])) for i in range((k + 1) // 2)]
        inner = [barrier(of.airspeeds[i] * of.airspeeds[k - i]) for i in range(1, (k + 1) // 2)]
        middle = of.velocities[k // 2], of.airspeeds[k // 2]
        if k % 2:
            square = latest_last(dots[1:], dots[0])
        else:
            square = latest_last([*dots[1:], barrier(middle[0].dot(middle[0])) / 2], dots[0])
            inner.append(barrier(middle[1] ** 2) / 2)
        return barrier(square - latest_last(inner[1:], inner[0])) if inner else square

    def _next(self, k: int, sizes: Sequence[sp.Expr], of: Series) -> list[sp.Expr]:
        """Return V_{k+1}."""
        turned = of.magnus_rate.cross(of.velocities[k])
        found = []
        for axis in range(3):
            terms = [barrier(sizes[i] * of.velocities[k - i][axis]) for i in range(k + 1)]
            braked = latest_last(terms[:k], terms[k])
            force = barrier(barrier(turned[axis]) - barrier(of.drag_rate * braked))
            if k == 0 and self.fall[axis] != 0:
                force = barrier(force + self.fall[axis])
            found.append(barrier(force / (k + 1)))
        return found

    def excess(self) -> sp.Expr:
        """Return by how much errors of the velocity exceed those for which growth is proved."""
        return barrier(barrier(growth * velocity_error + piece_speed_error) - TUBE) + unproved


@dataclass(frozen=True)
class AirSketch(AirFlight):
    """The flight through air by the first terms of a piece's series, in single precision."""

    @property
    def velocities(self) -> tuple[sp.Matrix, ...]:
        """The first coefficients of the velocity, by order."""
        return SINGLE_SERIES.velocities[:SKETCH_TERMS]
