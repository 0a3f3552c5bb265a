"""The motion of a ball that rolls on a ring, as a power series in the ring's coordinates.

With the angle a around the wire, from outwards, by its cosine C and sine S, its rate A, the speed P
along the ring, the azimuth by c and d, s = R_B (w·n), q = 1/rho and Omega = P q, rolling
(`rolling_series.py`) on a tube about a horizontal circle is, with beta = kappa/(1 + kappa),

    R A' = -Omega (P S - beta s C) - (1 - beta) g C,   P' = A (R Omega S - beta s),
    s' = R_H A Omega,   C' = -S A,   S' = C A,   c' = -d Omega,   d' = c Omega,
    N = g S - R A² - P Omega C:

nine products of series for a term, with T = P S - beta s C from a rate of its own:

    T' = Omega A (R + (1 - beta) R_H C),   N' = A ((3 - 2 beta) g C + 3 R_H Omega² S).

The azimuth turns by the integral of Omega. Newton's and Euler's equations need more than twice as
many products, and their solution drifts off the surface. Terms are cheap here, so the order is high
and steps are long.

This is Routh's problem. By the angle, dP/da = (R S/rho) P - beta s and ds/da = (R_H/rho) P, without
time. So P and s are functions of a, and by the energy so is A². Between two turning points, where
A = 0, the motion is periodic, whatever the azimuth, unless something there ends it.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..contact.ball import Ball
from ..symbolic.conditionals import absolute, barrier, maximum, minimum
from ..symbolic.polynomials import horner
from ..symbolic.symbols import POSITION, SPIN, VELOCITY, position, spin, t, velocity
from .flight import NO_FORCE, SurfaceForce
from .rolling_series import per_reach, product, term

ORDER = 12
"""Order of the series: four times three, for the root that the step takes."""

LAST_TERM_TOLERANCE = sp.Rational(1, 2**41)
"""Largest last term of a step, relative to the speed; the truncation error is then about 2^-44."""

COORDINATES = ("cosine", "sine", "climb", "along", "turn_rate", "cos", "sin")
"""C, S, A, P, s, c, d."""
MOVING = COORDINATES[:5]
"""The coordinates that are series; the azimuth follows from Omega."""


def _row(name: str, order: int) -> list[sp.Symbol]:
    return [term(name, k) for k in range(order + 1)]


@dataclass(frozen=True)
class RingRolling:
    """A ball that rolls on a ring about z.

    Attributes
    ----------
    ring_radius
        R_H.
    reach
        R, the radii of ball and wire together.
    ball
        The ball.
    gravity
        g.
    besides
        What presses the ball on besides its weight.
    """

    ring_radius: sp.Expr
    reach: sp.Expr
    ball: Ball
    gravity: sp.Expr
    besides: SurfaceForce = NO_FORCE

    def start(self) -> dict[str, sp.Expr]:
        """Return the constant terms, for a ball at its place on the ring or near it."""
        (x, y, z), (vx, vy, vz), (wx, wy, wz) = position, velocity, spin
        rho = barrier(sp.sqrt(barrier(x**2 + y**2)))
        per = barrier(1 / rho)
        cos, sin = barrier(x * per), barrier(y * per)
        off = barrier(rho - self.ring_radius)
        near = barrier(1 / sp.sqrt(barrier(off**2 + z**2)))
        cosine, sine = barrier(off * near), barrier(z * near)
        outwards = barrier(vx * cos + vy * sin)
        turned = barrier(wx * cos + wy * sin)
        values = (
            cosine,
            sine,
            barrier(cosine * vz - sine * outwards) * per_reach,
            vy * cos - vx * sin,
            self.ball.radius * barrier(cosine * turned + sine * wz),
            cos,
            sin,
        )
        first = {f"{name}_0": value for name, value in zip(COORDINATES, values, strict=True)}
        along, s = barrier(values[3]), barrier(values[4])
        return first | {
            "tilted_0": along * sine - self.ball.friction_share * barrier(s * cosine),
            "near_0": 1 / barrier(self.ring_radius + self.reach * cosine),
        }

    def next_terms(self, k: int) -> dict[str, sp.Expr]:
        """Return the coefficients of the next order, given those up to this one."""
        cosine, sine, climb, along, s = (_row(name, k) for name in MOVING)
        tilted, near = _row("tilted", k), term("near", 0)
        # P = rho Omega; rho changes as R cos a does.
        omega = _row("omega", k)[:-1]
        grown = self.reach * product(cosine[1:], omega) if k else 0
        omega.append(barrier(near * barrier(along[k] - grown)))
        around = [*_row("around", k)[:-1], product(omega, climb)]
        pull = barrier(self.ball.moving_share * self.gravity * cosine[k] + product(omega, tilted))
        wide = barrier(self.ball.moving_share * self.ring_radius)
        rates = {
            "cosine": -product(climb, sine),
            "sine": product(climb, cosine),
            "climb": -pull * per_reach,
            "along": barrier(
                self.reach * product(around, sine) - self.ball.friction_share * product(climb, s)
            ),
            "turn_rate": self.ring_radius * around[-1],
            "tilted": barrier(self.reach * around[-1] + wide * product(around, cosine)),
        }
        scale = sp.Rational(1, k + 1)
        outputs = {f"omega_{k}": omega[-1], f"around_{k}": around[-1]}
        return outputs | {f"{name}_{k + 1}": rate * scale for name, rate in rates.items()}

    def moved(self) -> dict[str, sp.Expr]:
        """Return the state at time t after the start of the step: on the ring, rolling."""
        values = [barrier(horner(_row(name, ORDER), t)) for name in MOVING]
        cosine, sine, climb, along, s = values
        per = barrier(1 / sp.sqrt(barrier(cosine**2 + sine**2)))
        cosine, sine = barrier(cosine * per), barrier(sine * per)
        cos, sin = self._turned()
        rho = barrier(self.ring_radius + self.reach * cosine)
        over = barrier(self.reach * climb)
        outwards = barrier(-over * sine)
        turned = barrier(s * cosine - along * sine)
        smaller = barrier(1 / self.ball.radius)
        there = (
            (rho * cos, rho * sin, self.reach * sine),
            (outwards * cos - along * sin, outwards * sin + along * cos, over * cosine),
            (
                smaller * barrier(turned * cos + over * sin),
                smaller * barrier(turned * sin - over * cos),
                smaller * barrier(along * cosine + s * sine),
            ),
        )
        outputs = {
            symbol.name: value
            for symbols, vector in zip((POSITION, VELOCITY, SPIN), there, strict=True)
            for symbol, value in zip(symbols, vector, strict=True)
        }
        return outputs | {"climb": climb}

    def _turned(self) -> tuple[sp.Expr, sp.Expr]:
        """Return cosine and sine of the azimuth, from those of its change: at most 2/7.

        The truncation error of their series is less than a tenth of a rounding.
        """
        cos, sin = term("cos", 0), term("sin", 0)
        turns = [c / (k + 1) for k, c in enumerate(_row("omega", ORDER - 1))]
        by = barrier(t * barrier(horner(turns, t)))
        squared = barrier(by**2)
        even, odd = (
            barrier(
                horner(
                    [sp.Rational((-1) ** k, sp.factorial(2 * k + n)) for k in range(7 - n)], squared
                )
            )
            for n in (0, 1)
        )
        over = barrier(by * odd)
        return barrier(cos * even - sin * over), barrier(sin * even + cos * over)

    def step(self) -> dict[str, sp.Expr]:
        """Return a step in which the series is nearly as good as rounded, and bounds in it.

        The first term that is left out is about the last one times the step over the time in which
        the motion changes: at most an eighth. If the last term happens to be small, the one before
        it counts. The azimuth turns by little more than a quarter.
        """
        strength, share = self.gravity, self.ball.friction_share
        sizes = {
            k: barrier(
                self.reach * absolute(term("climb", k))
                + barrier(absolute(term("along", k)) + absolute(term("turn_rate", k)))
            )
            for k in (0, ORDER - 1, ORDER)
        }
        turned = 4 * absolute(term("omega", 0))
        ways = barrier(
            barrier(absolute(term("cosine", ORDER)) + absolute(term("sine", ORDER)))
            + LAST_TERM_TOLERANCE * barrier(barrier(barrier(turned**2) * turned) ** 2) ** 2
        )
        rate = barrier(sizes[0] * per_reach + sp.sqrt(barrier(strength * per_reach)))
        scale = barrier(sizes[0] + strength * sp.Rational(1, 2**6))
        last = barrier(
            maximum(barrier(sizes[ORDER] + rate * sizes[ORDER - 1] / 4), barrier(scale * ways))
        )
        step = barrier(
            minimum(sp.Rational(1, 2**4), _twelfth_root(LAST_TERM_TOLERANCE * scale / last))
        )
        (climb, rises), (along, quickens), (omega, turns) = (
            self._largest(name, order, step)
            for name, order in (("climb", ORDER), ("along", ORDER), ("omega", ORDER - 1))
        )
        turned = barrier(climb**2)
        fastest = barrier(self.reach * climb + along)
        swaying = barrier(self.reach * barrier(turned + rises))
        return {
            "stride": step,
            "missed": barrier(LAST_TERM_TOLERANCE / 8 * scale),
            # The bound uses the rates around the wire and along the ring, not gravity: a ball near
            # the top hardly speeds up, and stays near the bridge's edge.
            "strongest": swaying + barrier(quickens + fastest * omega),
            "fastest": fastest,
            "section_acceleration": swaying,
            **self.pressed(),
            "force_bend": self.max_force_bend(step, climb, rises, omega, turns)
            + self._max_bend_besides(step, climb, rises, along, quickens),
            "friction_force_rate": barrier(
                2 * share * strength * barrier(term("cosine", 0) * term("climb", 0))
            ),
        } | self._quickened()

    def _largest(self, name: str, order: int, step: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on a series and on its rate within a step."""
        sizes = [barrier(absolute(part)) for part in _row(name, order)]
        rates = [k * own for k, own in enumerate(sizes)][1:]
        return barrier(horner(sizes, step)), barrier(horner(rates, step))

    def pressed(self) -> dict[str, sp.Expr]:
        """Return N at the start, and its rate."""
        cosine, sine, climb, along, omega = (
            term(name, 0) for name in ("cosine", "sine", "climb", "along", "omega")
        )
        falls, turns = self._weights(omega)
        squared = barrier(barrier(self.reach * climb) ** 2 + along**2)
        quickens = 2 * barrier(
            barrier(self.reach**2) * barrier(climb * term("climb", 1)) + along * term("along", 1)
        )
        pressed = self.besides.at(barrier(-self.gravity * sine), squared)
        changed = self.besides.at(barrier(-self.gravity * barrier(climb * cosine)), quickens)
        return {
            "force": self.gravity * sine
            - self.reach * climb**2
            - barrier(along * omega) * cosine
            + pressed,
            "force_rate": climb * barrier(falls * cosine + turns * sine) + changed,
        }

    def _weights(self, omega: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return the factors of C and S in N'/A."""
        return barrier((3 - 2 * self.ball.friction_share) * self.gravity), barrier(
            3 * self.ring_radius * barrier(omega**2)
        )

    def max_force_bend(
        self, step: sp.Expr, climb: sp.Expr, rises: sp.Expr, omega: sp.Expr, turns: sp.Expr
    ) -> sp.Expr:
        """Return the largest size of N'', by those of A, Omega and their rates within the step.

        Parameters
        ----------
        step
            The length of the step, s.
        climb
            The largest size of A within the step, 1/s.
        rises
            The largest size of A', 1/s².
        omega
            The largest size of Omega, 1/s.
        turns
            The largest size of Omega', 1/s².

        Returns
        -------
        Expr
            m/s⁴.
        """
        falls, swirls = self._weights(omega)
        moved = barrier(step * climb)
        cosine, sine = (barrier(absolute(term(name, 0)) + moved) for name in ("cosine", "sine"))
        slowly = barrier(rises * barrier(falls * cosine + swirls * sine))
        quickly = barrier(climb * barrier(falls * sine + swirls * cosine))
        return slowly + climb * barrier(
            quickly + 6 * self.ring_radius * barrier(barrier(omega * turns) * sine)
        )

    def _max_bend_besides(
        self, step: sp.Expr, climb: sp.Expr, rises: sp.Expr, along: sp.Expr, quickens: sp.Expr
    ) -> sp.Expr:
        """Return the largest second derivative of what presses besides the weight, in a step.

        That of S is at most A² + |A'|, that of v² at most 2 R² (A'² + A A'') + 2 (P'² + P P'').
        """
        if self.besides == NO_FORCE:
            return sp.Integer(0)
        bends, turns = (self._largest_bend(name, step) for name in ("climb", "along"))
        swings = barrier(barrier(self.reach**2) * barrier(rises**2 + climb * bends))
        squared = barrier(2 * barrier(swings + barrier(quickens**2 + along * turns)))
        fall = barrier(self.gravity * barrier(climb**2 + rises))
        return barrier(self.besides.buoyancy * fall) + barrier(self.besides.lift_size * squared)

    def _largest_bend(self, name: str, step: sp.Expr) -> sp.Expr:
        """Return a bound on the second derivative of a series within a step."""
        sizes = [barrier(absolute(part)) for part in _row(name, ORDER)]
        return barrier(horner([k * (k - 1) * own for k, own in enumerate(sizes)][2:], step))

    def pulled(self) -> dict[str, sp.Expr]:
        """Return F² at the start, and its rate.

        F = beta (-a_t + s n × n') with n' = A e_a + Omega C e_phi: along e_a it is
        beta C (g + s Omega), along e_phi it is -beta s A.
        """
        cosine, climb, s, omega = (
            (term(name, 0), term(name, 1)) for name in ("cosine", "climb", "turn_rate", "omega")
        )
        share = self.ball.friction_share
        weight = barrier(self.gravity + s[0] * omega[0])
        weighing = barrier(s[1] * omega[0] + s[0] * omega[1])
        over = barrier(share * barrier(cosine[0] * weight))
        rising = barrier(share * barrier(cosine[1] * weight + cosine[0] * weighing))
        side = barrier(share * barrier(s[0] * climb[0]))
        turning = barrier(share * barrier(s[1] * climb[0] + s[0] * climb[1]))
        return {
            "rolling_friction": over**2 + side**2,
            "rolling_friction_rate": 2 * barrier(over * rising + side * turning),
        }

    def _quickened(self) -> dict[str, sp.Expr]:
        """Return the rate of the velocity at the start, vx_1 and so on."""
        cosine, sine, climb, along, _, cos, sin = (term(name, 0) for name in COORDINATES)
        over, back = self.reach * term("climb", 1), barrier(self.reach * barrier(climb**2))
        omega = term("omega", 0)
        outwards = barrier(-over * sine - back * cosine - along * omega)
        sideways = barrier(term("along", 1) - barrier(self.reach * barrier(climb * sine)) * omega)
        return {
            "vx_1": outwards * cos - sideways * sin,
            "vy_1": outwards * sin + sideways * cos,
            "vz_1": over * cosine - back * sine,
        }


def _twelfth_root(ratio: sp.Expr) -> sp.Expr:
    """Return a twelfth root to a few hundredths: two square roots, and Halley's cube root."""
    quarter = barrier(sp.sqrt(barrier(sp.sqrt(barrier(ratio)))))
    fourth = barrier(sp.sqrt(barrier(sp.sqrt(quarter))))
    # Three quarters of the power 5/16 fits best where the step is some hundredths of a second.
    root = barrier(sp.Rational(3, 4) * fourth * sp.sqrt(barrier(sp.sqrt(fourth))))
    cubed = barrier(root**3)
    return root * barrier(barrier(cubed + 2 * quarter) / barrier(2 * cubed + quarter))
