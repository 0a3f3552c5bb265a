"""Motion in contact with a ring: a ball that rolls on it, in the ring's own coordinates.

With the angle a around the wire, from outwards, by its cosine C and sine S, its rate A, the speed P
along the ring, the azimuth by c and d, s = R_B (w·n), q = 1/rho and Omega = P q, rolling
(`rolling.py`) on a tube about a horizontal circle is, with beta the share that rolling takes,

    R A' = -Omega (P S - beta s C) - (1 - beta) g C,   P' = A (R Omega S - beta s),
    s' = R_H A Omega,   C' = -S A,   S' = C A,   c' = -d Omega,   d' = c Omega,
    N = g S - R A² - P Omega C:

nine products of series for a term, with T = P S - beta s C from a rate of its own:

    T' = Omega A (R + (1 - beta) R_H C),   N' = A ((3 - 2 beta) g C + 3 R_H Omega² S).

The azimuth turns by the integral of Omega. That is less than half of what Newton's and Euler's
equations take, and there is no way off the surface. So terms are cheap, and there are more of them:
steps are long.

That is Routh's problem. By the angle, dP/da = (R S/rho) P - beta s and ds/da = (R_H/rho) P, without
time: so P and s are functions of a, and with the energy A² is. Between two turning points, where
A = 0, a ball goes to and fro for ever, whatever the azimuth, unless something there ends it.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold, largest, size, smallest
from ..ground.polynomials import horner
from ..ground.symbols import POSITION, SPIN, VELOCITY, position, spin, t, velocity
from .rolling import SHARE, per_reach, product, term

ORDER = 12
"""Terms of the series: four times three, for the root that the step takes."""

MISSED = sp.Rational(1, 2**41)
"""What the last term of a step may be, of the speed: some 2^-44 of it are then left out."""

COORDINATES = ("cosine", "sine", "climb", "along", "turn_rate", "cos", "sin")
"""C, S, A, P, s, c, d."""
MOVING = COORDINATES[:5]
"""Those that are series; the azimuth follows from Omega."""


def _row(name: str, order: int) -> list[sp.Symbol]:
    return [term(name, k) for k in range(order + 1)]


@dataclass(frozen=True)
class Circling:
    """A ball of a radius on a ring about z: R_H, R, and gravity."""

    ring_radius: sp.Expr
    reach: sp.Expr
    ball_radius: sp.Expr
    gravity: sp.Expr

    def start(self) -> dict[str, sp.Expr]:
        """Return the constant terms, of a ball at its place on the ring or near it."""
        (x, y, z), (vx, vy, vz), (wx, wy, wz) = position, velocity, spin
        rho = hold(sp.sqrt(hold(x**2 + y**2)))
        per = hold(1 / rho)
        cos, sin = hold(x * per), hold(y * per)
        off = hold(rho - self.ring_radius)
        near = hold(1 / sp.sqrt(hold(off**2 + z**2)))
        cosine, sine = hold(off * near), hold(z * near)
        outwards = hold(vx * cos + vy * sin)
        turned = hold(wx * cos + wy * sin)
        values = (
            cosine,
            sine,
            hold(cosine * vz - sine * outwards) * per_reach,
            vy * cos - vx * sin,
            self.ball_radius * hold(cosine * turned + sine * wz),
            cos,
            sin,
        )
        first = {f"{name}_0": value for name, value in zip(COORDINATES, values, strict=True)}
        along, s = hold(values[3]), hold(values[4])
        return first | {
            "tilted_0": along * sine - SHARE * hold(s * cosine),
            "near_0": 1 / hold(self.ring_radius + self.reach * cosine),
        }

    def following(self, k: int) -> dict[str, sp.Expr]:
        """Return the terms of the next order, given those up to this one."""
        cosine, sine, climb, along, s = (_row(name, k) for name in MOVING)
        tilted, near = _row("tilted", k), term("near", 0)
        # P = rho Omega; rho changes as R cos a does.
        omega = _row("omega", k)[:-1]
        grown = self.reach * product(cosine[1:], omega) if k else 0
        omega.append(hold(near * hold(along[k] - grown)))
        around = [*_row("around", k)[:-1], product(omega, climb)]
        pull = hold((1 - SHARE) * self.gravity * cosine[k] + product(omega, tilted))
        wide = hold((1 - SHARE) * self.ring_radius)
        rates = {
            "cosine": -product(climb, sine),
            "sine": product(climb, cosine),
            "climb": -pull * per_reach,
            "along": hold(self.reach * product(around, sine) - SHARE * product(climb, s)),
            "turn_rate": self.ring_radius * around[-1],
            "tilted": hold(self.reach * around[-1] + wide * product(around, cosine)),
        }
        scale = sp.Rational(1, k + 1)
        outputs = {f"omega_{k}": omega[-1], f"around_{k}": around[-1]}
        return outputs | {f"{name}_{k + 1}": rate * scale for name, rate in rates.items()}

    def moved(self) -> dict[str, sp.Expr]:
        """Return the state at the time t after the series' start: on the ring, rolling."""
        values = [hold(horner(_row(name, ORDER), t)) for name in MOVING]
        cosine, sine, climb, along, s = values
        per = hold(1 / sp.sqrt(hold(cosine**2 + sine**2)))
        cosine, sine = hold(cosine * per), hold(sine * per)
        cos, sin = self._turned()
        rho = hold(self.ring_radius + self.reach * cosine)
        over = hold(self.reach * climb)
        outwards = hold(-over * sine)
        turned = hold(s * cosine - along * sine)
        smaller = hold(1 / self.ball_radius)
        there = (
            (rho * cos, rho * sin, self.reach * sine),
            (outwards * cos - along * sin, outwards * sin + along * cos, over * cosine),
            (
                smaller * hold(turned * cos + over * sin),
                smaller * hold(turned * sin - over * cos),
                smaller * hold(along * cosine + s * sine),
            ),
        )
        outputs = {
            symbol.name: value
            for symbols, vector in zip((POSITION, VELOCITY, SPIN), there, strict=True)
            for symbol, value in zip(symbols, vector, strict=True)
        }
        return outputs | {"climb": climb}

    def _turned(self) -> tuple[sp.Expr, sp.Expr]:
        """Return cosine and sine of the azimuth, by those of what it turns by: at most 2/7.

        What their series leave out is less than a tenth of a rounding.
        """
        cos, sin = term("cos", 0), term("sin", 0)
        turns = [c / (k + 1) for k, c in enumerate(_row("omega", ORDER - 1))]
        by = hold(t * hold(horner(turns, t)))
        squared = hold(by**2)
        even, odd = (
            hold(
                horner(
                    [sp.Rational((-1) ** k, sp.factorial(2 * k + n)) for k in range(7 - n)], squared
                )
            )
            for n in (0, 1)
        )
        over = hold(by * odd)
        return hold(cos * even - sin * over), hold(sin * even + cos * over)

    def pace(self) -> dict[str, sp.Expr]:
        """Return a step after which the series is nearly as good as rounded, and bounds in it.

        The first term that is left out is about the last times the step over the time in which the
        motion changes: an eighth of it, at most. Where the last happens to be small, the one before
        it counts. The azimuth turns by a quarter at most, and a little.
        """
        strength = self.gravity
        sizes = {
            k: hold(
                self.reach * size(term("climb", k))
                + hold(size(term("along", k)) + size(term("turn_rate", k)))
            )
            for k in (0, ORDER - 1, ORDER)
        }
        turned = 4 * size(term("omega", 0))
        ways = hold(
            hold(size(term("cosine", ORDER)) + size(term("sine", ORDER)))
            + MISSED * hold(hold(hold(turned**2) * turned) ** 2) ** 2
        )
        rate = hold(sizes[0] * per_reach + sp.sqrt(hold(strength * per_reach)))
        scale = hold(sizes[0] + strength * sp.Rational(1, 2**6))
        last = hold(largest(hold(sizes[ORDER] + rate * sizes[ORDER - 1] / 4), hold(scale * ways)))
        step = hold(smallest(sp.Rational(1, 2**4), _twelfth_root(MISSED * scale / last)))
        (climb, rises), (along, quickens), (omega, turns) = (
            self._largest(name, order, step)
            for name, order in (("climb", ORDER), ("along", ORDER), ("omega", ORDER - 1))
        )
        turned = hold(climb**2)
        fastest = hold(self.reach * climb + along)
        swaying = hold(self.reach * hold(turned + rises))
        return {
            "stride": step,
            "missed": hold(MISSED / 8 * scale),
            # The sizes of its rates around the wire and along the ring, not what gravity may do: a
            # ball near the top hardly speeds up, nor gets far from the bridge's edge beside it.
            "strongest": swaying + hold(quickens + fastest * omega),
            "fastest": fastest,
            "sway": swaying,
            **self.pressed(),
            "force_bend": self.bent(step, climb, rises, omega, turns),
            "brace": hold(2 * SHARE * strength * hold(term("cosine", 0) * term("climb", 0))),
        } | self._quickened()

    def _largest(self, name: str, order: int, step: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return the largest size of a series within a step, and that of its rate."""
        sizes = [hold(size(part)) for part in _row(name, order)]
        rates = [k * own for k, own in enumerate(sizes)][1:]
        return hold(horner(sizes, step)), hold(horner(rates, step))

    def pressed(self) -> dict[str, sp.Expr]:
        """Return N at the start, and its rate."""
        cosine, sine, climb, along, omega = (
            term(name, 0) for name in ("cosine", "sine", "climb", "along", "omega")
        )
        falls, turns = self._weights(omega)
        return {
            "force": self.gravity * sine - self.reach * climb**2 - hold(along * omega) * cosine,
            "force_rate": climb * hold(falls * cosine + turns * sine),
        }

    def _weights(self, omega: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return what C and S count in N'/A."""
        return hold((3 - 2 * SHARE) * self.gravity), hold(3 * self.ring_radius * hold(omega**2))

    def bent(
        self, step: sp.Expr, climb: sp.Expr, rises: sp.Expr, omega: sp.Expr, turns: sp.Expr
    ) -> sp.Expr:
        """Return the largest size of N'', by those of A, Omega and their rates within the step."""
        falls, swirls = self._weights(omega)
        moved = hold(step * climb)
        cosine, sine = (hold(size(term(name, 0)) + moved) for name in ("cosine", "sine"))
        slowly = hold(rises * hold(falls * cosine + swirls * sine))
        quickly = hold(climb * hold(falls * sine + swirls * cosine))
        return slowly + climb * hold(
            quickly + 6 * self.ring_radius * hold(hold(omega * turns) * sine)
        )

    def pulled(self) -> dict[str, sp.Expr]:
        """Return F² at the start, and its rate.

        F = beta (-a_t + s n × n') with n' = A e_a + Omega C e_phi: along e_a it is
        beta C (g + s Omega), along e_phi it is -beta s A.
        """
        cosine, climb, s, omega = (
            (term(name, 0), term(name, 1)) for name in ("cosine", "climb", "turn_rate", "omega")
        )
        weight = hold(self.gravity + s[0] * omega[0])
        weighing = hold(s[1] * omega[0] + s[0] * omega[1])
        over = hold(SHARE * hold(cosine[0] * weight))
        rising = hold(SHARE * hold(cosine[1] * weight + cosine[0] * weighing))
        side = hold(SHARE * hold(s[0] * climb[0]))
        turning = hold(SHARE * hold(s[1] * climb[0] + s[0] * climb[1]))
        return {
            "drag": over**2 + side**2,
            "drag_rate": 2 * hold(over * rising + side * turning),
        }

    def _quickened(self) -> dict[str, sp.Expr]:
        """Return the rate of the velocity at the start, vx_1 and so on."""
        cosine, sine, climb, along, _, cos, sin = (term(name, 0) for name in COORDINATES)
        over, back = self.reach * term("climb", 1), hold(self.reach * hold(climb**2))
        omega = term("omega", 0)
        outwards = hold(-over * sine - back * cosine - along * omega)
        sideways = hold(term("along", 1) - hold(self.reach * hold(climb * sine)) * omega)
        return {
            "vx_1": outwards * cos - sideways * sin,
            "vy_1": outwards * sin + sideways * cos,
            "vz_1": over * cosine - back * sine,
        }


def _twelfth_root(ratio: sp.Expr) -> sp.Expr:
    """Return a twelfth root to a few hundredths: two square roots, and Halley's cube root."""
    quarter = hold(sp.sqrt(hold(sp.sqrt(hold(ratio)))))
    fourth = hold(sp.sqrt(hold(sp.sqrt(quarter))))
    # Three quarters of it to the power 5/16: right where the step is some hundredths of a second.
    root = hold(sp.Rational(3, 4) * fourth * sp.sqrt(hold(sp.sqrt(fourth))))
    cubed = hold(root**3)
    return root * hold(hold(cubed + 2 * quarter) / hold(2 * cubed + quarter))
