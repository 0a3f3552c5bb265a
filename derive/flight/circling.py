"""Motion in contact with a ring: a ball that rolls on it, in the ring's own coordinates.

With the angle a around the wire, from outwards, by its cosine C and sine S, its rate A, the speed P
along the ring, the azimuth by c and d, s = R_B (w·n), q = 1/rho and Omega = P q, rolling
(`rolling.py`) on a tube about a horizontal circle is, with beta the share that rolling takes,

    R A' = -Omega (P S - beta s C) - (1 - beta) g C,   P' = A (R Omega S - beta s),
    s' = R_H A Omega,   C' = -S A,   S' = C A,   c' = -d Omega,   d' = c Omega,
    N = g S - R A² - P Omega C:

fifteen products of series for a term, half of what Newton's and Euler's equations take, and no way
off the surface. So terms are cheap, and there are more of them: steps are long.

That is Routh's problem. By the angle, dP/da = (R S/rho) P - beta s and ds/da = (R_H/rho) P, without
time: so P and s are functions of a, and with the energy A² is. Between two turning points, where
A = 0, a ball goes to and fro for ever, whatever the azimuth, unless something there ends it.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold, largest, size, smallest
from ..ground.polynomials import horner
from ..ground.symbols import POSITION, SPIN, UNIT_ROUNDOFF, VELOCITY, position, spin, t, velocity
from .rolling import SHARE, product, term

ORDER = 12
"""Terms of the series: four times three, for the root that the step takes."""

COORDINATES = ("cosine", "sine", "climb", "along", "turn_rate", "cos", "sin")
"""C, S, A, P, s, c, d."""


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
            hold(cosine * vz - sine * outwards) / self.reach,
            vy * cos - vx * sin,
            self.ball_radius * hold(cosine * turned + sine * wz),
            cos,
            sin,
        )
        first = {f"{name}_0": value for name, value in zip(COORDINATES, values, strict=True)}
        return first | {"near_0": 1 / hold(self.ring_radius + self.reach * cosine)}

    def following(self, k: int) -> dict[str, sp.Expr]:
        """Return the terms of the next order, given those up to this one, and that of N."""
        cosine, sine, climb, along, s, cos, sin = (_row(name, k) for name in COORDINATES)
        outputs: dict[str, sp.Expr] = {}
        near = _row("near", k)
        if k:
            # 1/rho by rho · 1/rho = 1; rho changes as R cos a does.
            near[k] = hold(-self.reach * near[0] * product(cosine[1:], near[:k]))
            outputs[f"near_{k}"] = near[k]
        omega = [*_row("omega", k)[:-1], product(along, near)]
        around = [*_row("around", k)[:-1], product(omega, climb)]
        tilted = [
            *_row("tilted", k)[:-1],
            hold(product(along, sine) - SHARE * product(s, cosine)),
        ]
        pressed = [*_row("pressed", k)[:-1], product(along, cosine)]
        outputs |= {
            f"omega_{k}": omega[-1],
            f"around_{k}": around[-1],
            f"tilted_{k}": tilted[-1],
            f"pressed_{k}": pressed[-1],
            f"force_{k}": self.gravity * sine[k]
            - self.reach * product(climb, climb)
            - product(omega, pressed),
        }
        pull = hold((1 - SHARE) * self.gravity * cosine[k] + product(omega, tilted))
        rates = {
            "cosine": -product(climb, sine),
            "sine": product(climb, cosine),
            "climb": -pull / self.reach,
            "along": hold(self.reach * product(around, sine) - SHARE * product(climb, s)),
            "turn_rate": self.ring_radius * around[-1],
            "cos": -product(omega, sin),
            "sin": product(omega, cos),
        }
        scale = sp.Rational(1, k + 1)
        return outputs | {f"{name}_{k + 1}": rate * scale for name, rate in rates.items()}

    def moved(self) -> dict[str, sp.Expr]:
        """Return the state at the time t after the series' start: on the ring, rolling."""
        values = [hold(horner(_row(name, ORDER), t)) for name in COORDINATES]
        cosine, sine, climb, along, s, cos, sin = values
        per, here = (
            hold(1 / sp.sqrt(hold(one**2 + other**2)))
            for one, other in ((cosine, sine), (cos, sin))
        )
        cosine, sine, cos, sin = (
            hold(cosine * per),
            hold(sine * per),
            hold(cos * here),
            hold(sin * here),
        )
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

    def pace(self) -> dict[str, sp.Expr]:
        """Return a step after which the series is as good as rounded, and bounds in it.

        The first term that is left out is about the last times the step over the time in which the
        motion changes: with the last at sixteen u of the speed it is about u. Where the last
        happens to be small, the one before it counts.
        """
        strength = self.gravity
        sizes = [
            hold(
                self.reach * size(term("climb", k))
                + hold(size(term("along", k)) + size(term("turn_rate", k)))
            )
            for k in range(ORDER + 1)
        ]
        ways = hold(sp.Add(*(size(term(name, ORDER)) for name in ("cosine", "sine", "cos", "sin"))))
        rate = hold(sizes[0] / self.reach + sp.sqrt(hold(strength / self.reach)))
        scale = hold(sizes[0] + strength * sp.Rational(1, 2**6))
        last = hold(largest(hold(sizes[ORDER] + rate * sizes[ORDER - 1] / 4), hold(scale * ways)))
        step = hold(
            smallest(sp.Rational(1, 2**4), _twelfth_root(2**4 * UNIT_ROUNDOFF * scale / last))
        )
        climb, along = (
            hold(horner([hold(size(part)) for part in _row(name, ORDER)], step))
            for name in ("climb", "along")
        )
        omega = hold(along * hold(1 / hold(self.ring_radius - self.reach)))
        rises, quickens = (
            hold(horner([k * hold(size(term(name, k))) for k in range(1, ORDER + 1)], step))
            for name in ("climb", "along")
        )
        turned = hold(climb**2)
        fastest = hold(self.reach * climb + along)
        bends = [k * (k - 1) * hold(size(term("force", k))) for k in range(2, ORDER)]
        return {
            "stride": step,
            # The sizes of its rates around the wire and along the ring, not what gravity may do: a
            # ball near the top hardly speeds up, nor gets far from the bridge's edge beside it.
            "strongest": hold(self.reach * hold(turned + rises) + hold(quickens + fastest * omega)),
            "fastest": fastest,
            "sway": self.reach * hold(turned + rises),
            "force": term("force", 0),
            "force_rate": term("force", 1),
            "force_bend": horner(bends, step),
            "brace": hold(2 * SHARE * strength * hold(term("cosine", 0) * term("climb", 0))),
        } | self._quickened()

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
    """Return a twelfth root to a few hundredths: two square roots, and Newton's cube root."""
    quarter = hold(sp.sqrt(hold(sp.sqrt(hold(ratio)))))
    fourth = hold(sp.sqrt(hold(sp.sqrt(quarter))))
    root = hold(fourth * sp.sqrt(hold(sp.sqrt(fourth))))
    for _ in range(2):
        root = hold(sp.Rational(2, 3) * root + quarter / hold(3 * hold(root**2)))
    return root
