"""The roundings of a contact with friction are within the counts of the lemma.

**Counts.** Let the normal n be a unit vector, |v| and |w| sums of sizes, and T = |v| + R_B |w|; to
first order in u, and Euclid's norms of errors of vectors:

- a = v·n has three products and two sums: 3 u |v|. So v - a n is off by 3 u |v|, the product u |a|
  and the difference u |v - a n|: 5 u |v|.
- A component of w × n has two products and a difference: 2 u times sizes whose norm is at most |w|,
  as |w_x| (0, |n_z|, |n_y|) and the other two such vectors are no longer than |w_x|, ... With the
  product by R_B, 3 u R_B |w|; with the difference, at most u T, the slip is off by 6 u T.
- |u|² has two roundings of each square and sum, three in all, and |u| half of these and its own:
  with those of the slip at most 6 u T + 5/2 u |u|, less than 9 u T.
- e has three roundings of V/v0, the sum and the quotient, and 1 + e at most four; G has four. With
  two products S has six, and σ times those of V, 3 u |v|.
- The share S/|u| has a quotient, those of S and of the root, and of the slip 6 u T/|u|. The impulse
  has the product and those of the slip again: 6 + 1 + 5/2 + 1 roundings of S <= G |u|, 12 u G T of
  the slip, and 3 u σ |v|: less than 23 u G T + 3 u σ |v|. Where it grips there are 4 + 1 + 6.
- The velocity has 5 of v - a n, one of the difference, which counts for G T as well, 3 of a and 5
  of a e n, e <= 1, and one of the last sum: at most 15 u |v| and 2 u G T beside the impulse's own.
- The spin's factor -1/(κ R_B) has three roundings with the product by the share, n × u three, and
  the product one: 30 u G T + 3 u σ |v|, over κ R_B, with the sum's, which are u |w| besides.
- The margin has six roundings of S, 3 u σ |v|, 4 + 1 of G |u|, 17/2 u G T, and the difference: at
  most 15 u G T and 11 u μ (1 + e0) |v|.

That is less than what MOTION_ROUNDINGS, SPIN_ROUNDINGS, SHARE_ROUNDINGS, SLOPE_ROUNDINGS and half
of MARGIN_ROUNDING say. Errors that are reached are about a fifth of it: a sum's do not all agree.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.errors import friction
from hoopgen.derive.symbolic.rounding import ROUNDING_SLACK
from hoopgen.derive.symbolic.symbols import UNIT_ROUNDOFF
from numpy.typing import NDArray

from hoopgen import PAPER
from tests.helpers import exact_contacts as exact
from tests.helpers.derived import DerivedKernels
from tests.helpers.effort import trials
from tests.helpers.exact_contacts import EXACT
from tests.helpers.exact_friction import Contact
from tests.helpers.scenes.slipping import SLIPPING

flint = pytest.importorskip("flint")

Floats = NDArray[np.float64]
U, SLACK = float(UNIT_ROUNDOFF), float(ROUNDING_SLACK)
ROWS = 100_000
RADIUS = PAPER["ball_radius"]
MOTION = ("vx", "vy", "vz", "wx", "wy", "wz")
NORMAL = ("nx", "ny", "nz")
DIRECTION = ("slip_x", "slip_y", "slip_z")


@cache
def kernels() -> DerivedKernels:
    """Return the kernels of a scene with friction."""
    return DerivedKernels.from_scene(SLIPPING)


def called(name: str, columns: dict[str, Any]) -> dict[str, Floats]:
    """Return what a kernel computes in doubles."""
    module = kernels()
    found = getattr(module, name)(*(columns[one] for one in module.ARGUMENTS[name]))
    rows = len(columns["vx"])
    values = (np.broadcast_to(np.asarray(one, float), rows) for one in found)
    return dict(zip(module.OUTPUTS[name], values, strict=True))


def laws(random: np.random.Generator, rows: int) -> dict[str, Floats]:
    """Return random parameters of laws, among them a mu of zero, of infinity and large ones."""
    usual = 10 ** random.uniform(np.log10(0.05), np.log10(2), rows)
    large = 10 ** random.uniform(2, 9, rows)
    kind = random.random(rows)
    mu = np.select(
        [kind < 0.03, kind < 0.06, kind < 0.3], [0 * usual, usual + np.inf, large], usual
    )
    return {
        "restitution": random.choice([0.0, 0.5, 0.7, 1.0], rows),
        "friction": mu,
        "tangential": np.where(
            random.random(rows) < 0.1, random.choice([-1.0, 1.0], rows), random.uniform(-1, 1, rows)
        ),
        "falling": random.choice([0.3, 2.0, 40.0, np.inf], rows),
        "inertia": random.choice([1 / 64, 0.4, 2 / 3, 1.0], rows)
        * (1 - random.uniform(0, 0.02, rows)),
        "ball_radius": np.full(rows, RADIUS),
    }


def units(random: np.random.Generator, rows: int) -> Floats:
    """Return random unit vectors, (3, n)."""
    found = random.normal(size=(3, rows))
    return np.asarray(found / np.sqrt((found * found).sum(axis=0)))


def contacts() -> dict[str, Floats]:
    """Return random contacts: slips close to the switch, tiny ones, and tiny speeds towards it.

    With a large mu the speed towards the surface is so small that friction still decides.
    """
    random, rows = np.random.default_rng(3), trials(ROWS)
    law, n = laws(random, rows), units(random, rows)
    nearing = 1 / np.maximum(law["friction"] / 2, 1) + 1e-9
    nearing = nearing * 10 ** random.uniform(-2, 1, rows)
    tiny = random.random(rows) < 0.1
    nearing = np.where(tiny, 10 ** random.uniform(-14, -6, rows), nearing)
    e = law["restitution"] / (1 + nearing / law["falling"])
    mu = np.where(np.isfinite(law["friction"]), law["friction"], 0.5)
    grip = law["inertia"] * (1 + law["tangential"]) / (1 + law["inertia"])
    switch = mu * (1 + e) * nearing / np.maximum(grip, 1e-3)
    close = 1 + random.choice([-1, 1], rows) * 10 ** random.uniform(-15, -1, rows)
    speed = np.select(
        [(kind := random.random(rows)) < 0.3, kind < 0.4, kind < 0.5],
        [switch * close, 10 ** random.uniform(-15, -7, rows), 0 * switch],
        switch * 10 ** random.uniform(-2, 2, rows),
    )
    speed = np.minimum(speed, 30.0)
    way = np.cross(n, units(random, rows), axis=0)
    way = way / np.sqrt((way * way).sum(axis=0))
    glide = np.cross(n, units(random, rows), axis=0) * random.choice([0.0, 1.0, 10.0], rows)
    v = glide - nearing * n
    w = np.cross(n, glide - speed * way, axis=0) / RADIUS
    w = w + n * random.choice([0.0, 10.0, 200.0], rows)
    found = dict(zip((*MOTION, *NORMAL), (*v, *w, *n), strict=True))
    return found | {f"p_{name}": value for name, value in law.items()}


@dataclass(frozen=True)
class Roundings:
    """Errors of the kernels, and what they are counted in.

    Attributes
    ----------
    velocity, spin
        Errors of the impact.
    share, margin, speed, direction
        Errors of the slip; the share's and the direction's are times the speed.
    motion, whole
        The sums |v|, and T.
    grip, slope, steepest, turning
        G, σ, μ (1 + e0) and 1/(κ R_B).
    spinning
        The sums |w|.
    computed, exact
        The computed margin, and the exact contacts.
    slip
        All that the kernel computes.
    """

    velocity: Floats
    spin: Floats
    share: Floats
    margin: Floats
    speed: Floats
    direction: Floats
    motion: Floats
    whole: Floats
    grip: Floats
    slope: Floats
    steepest: Floats
    turning: Floats
    spinning: Floats
    exact: Contact
    slip: dict[str, Floats]

    @property
    def pushed(self) -> Floats:
        """F without u: the roundings of the impulse."""
        return (
            friction.SHARE_ROUNDINGS * self.grip * self.whole
            + friction.SLOPE_ROUNDINGS * self.slope * self.motion
        )

    @property
    def decided(self) -> NDArray[np.bool_]:
        """True where the margin is more than its roundings."""
        blurred = float(friction.MARGIN_ROUNDING) * self.margin_unit
        return np.asarray(np.abs(self.slip["slip_margin"]) > blurred)

    @property
    def margin_unit(self) -> Floats:
        """The unit of the roundings of the margin, G T + μ (1 + e0) |v|."""
        return np.asarray(self.grip * self.whole + self.steepest * self.motion)


def norm(vectors: Any) -> Floats:
    """Return Euclid's norms."""
    return exact.size(np.array(vectors, object))


@cache
def rounded() -> Roundings:
    """Return the errors of the kernels of random contacts."""
    return roundings_of(contacts())


def roundings_of(given: dict[str, Floats]) -> Roundings:
    """Return the errors of the kernels of given contacts."""
    after, slip = called("impact", given), called("impact_slip", given)
    law = {name.removeprefix("p_"): value for name, value in given.items() if name[:2] == "p_"}
    with flint.ctx.workprec(exact.BITS):
        n, v, w = (EXACT([given[a + p] for p in "xyz"]) for a in "nvw")
        true = Contact(n, v, w, law)
        moved, turned = true.after()
        still = np.array(true.speed == 0, bool)
        unit = true.slip / np.where(still, 1 + 0 * true.speed, true.speed)
        off_v = norm(moved - EXACT([after[k] for k in MOTION[:3]]))
        off_w = norm(turned - EXACT([after[k] for k in MOTION[3:]]))
        share = np.abs(np.array((EXACT(slip["slip_share"]) - true.share) * true.speed, float))
        margin = np.abs(np.array(EXACT(slip["slip_margin"]) - true.margin, float))
        speed = np.abs(np.array(EXACT(slip["slip_speed"]) - true.speed, float))
        way = norm(unit - EXACT([slip[k] for k in DIRECTION])) * np.array(true.speed, float)
        grip = np.array(true.grip, float)
    motion, spinning = (sum(np.abs(given[a + p]) for p in "xyz") for a in "vw")
    steepest = np.where(np.isinf(law["friction"]), 0, law["friction"]) * (1 + law["restitution"])
    slope = np.where(slip["slip_margin"] < 0, steepest, 0)
    turning = 1 / (law["inertia"] * RADIUS)
    whole = motion + RADIUS * spinning
    sizes = (motion, whole, grip, slope, steepest, turning, spinning)
    return Roundings(off_v, off_w, share, margin, speed, way, *sizes, true, slip)


# ------------------------------------------------------------------------------------------ tests


def within(errors: Floats, bounds: Floats, least: float) -> None:
    """Demand that decided contacts have errors within bounds, and some more than a share of them.

    Parameters
    ----------
    errors
        The errors.
    bounds
        The bounds over u.
    least
        The share.
    """
    decided = rounded().decided
    errors, bounds = errors[decided], U * bounds[decided]
    assert np.all(errors <= SLACK * bounds)
    assert np.any(errors > least * bounds)


def test_contacts_are_close_to_the_switch_and_far_from_it() -> None:
    found = rounded()
    assert np.mean(found.decided) > 0.8
    assert np.mean(~found.decided) > 0.03
    assert np.mean(found.exact.slips) > 0.2
    assert np.mean(found.exact.decided) > 0.03


def test_the_impact_s_roundings_are_within_their_counts() -> None:
    found = rounded()
    motion = friction.MOTION_ROUNDINGS * found.whole + found.pushed
    within(found.velocity, motion, 0.12)
    spin = friction.SPIN_ROUNDINGS * found.spinning + found.turning * found.pushed
    within(found.spin, spin, 0.15)


def test_the_slip_s_roundings_are_within_their_counts() -> None:
    """The share's are those of the impulse; the slip's are 8 of T, and 11 with those of its size.

    Where a slip is not small beside T, its direction has single precision.
    """
    found = rounded()
    within(found.share, found.pushed, 0.1)
    within(found.speed, 11 * found.whole, 0.15)
    within(found.direction, 11 * found.whole, 0.15)
    large = friction.LARGEST_CHANGE * float(friction.LEAST_SLIP) * found.whole
    known = found.decided & (found.slip["slip_speed"] > large)
    assert np.all(found.direction[known] < 2.0**-30 * found.slip["slip_speed"][known])


def test_the_margin_s_roundings_are_half_of_those_that_count() -> None:
    found, count = rounded(), float(friction.MARGIN_ROUNDING) / 2 / U
    share = found.margin[found.margin_unit > 0] / found.margin_unit[found.margin_unit > 0] / U
    assert 0.1 * count < share.max() <= count


def test_a_contact_whose_margin_is_more_than_its_roundings_is_decided_as_the_exact_one() -> None:
    found = rounded()
    grips = found.slip["slip_margin"] >= 0
    assert np.array_equal(grips[found.decided], ~found.exact.slips[found.decided])
    assert np.any(grips != ~found.exact.slips)


def count_reached(count: str, found: Roundings) -> Floats:
    """Return how many roundings contacts have in which the terms of other counts are small.

    Parameters
    ----------
    count
        The name of the constant.
    found
        The errors.
    """
    gripped, slid = found.grip * found.whole, found.slope * found.motion
    spin = found.spin / found.turning
    turned = found.spinning / found.turning
    errors, unit, others = {
        "MOTION_ROUNDINGS": (found.velocity, found.whole, gripped + slid),
        "SPIN_ROUNDINGS": (spin, turned, gripped + slid),
        "SHARE_ROUNDINGS": (spin, gripped, 0.1 * turned + slid),
        "SLOPE_ROUNDINGS": (spin, slid, gripped + turned),
    }[count]
    told = found.decided & (others < 0.03 * unit)
    return np.asarray(np.where(told, errors / np.where(told, unit, 1) / U, 0))


@pytest.mark.parametrize("count", ["MOTION_ROUNDINGS", "SPIN_ROUNDINGS", "SLOPE_ROUNDINGS"])
def test_a_count_is_at_most_ten_times_what_is_reached(count: str) -> None:
    assert getattr(friction, count) < 10 * count_reached(count, rounded()).max()


def test_the_count_of_the_share_is_at_most_ten_times_what_is_reached() -> None:
    """Its errors are sums of many; those with the largest are varied, again and again."""
    random, given, found = np.random.default_rng(5), contacts(), rounded()
    for _ in range(10):
        reached = count_reached("SHARE_ROUNDINGS", found)
        best = np.argsort(-reached)[:100]
        given = {name: np.repeat(value[best], 15) for name, value in given.items()}
        for name in (*MOTION, *NORMAL, "p_inertia", "p_tangential"):
            used = random.random(len(given[name])) < 0.3
            used[::15] = False
            given[name] = given[name] * (1 - used * 10 ** random.uniform(-16, -1.5, len(used)))
        long = np.sqrt(sum(given[k] ** 2 for k in NORMAL))
        given |= {k: np.where(np.abs(long - 1) < 2 * U, given[k], given[k] / long) for k in NORMAL}
        found = roundings_of(given)
    reached = count_reached("SHARE_ROUNDINGS", found).max()
    assert reached <= friction.SHARE_ROUNDINGS < 10 * reached
