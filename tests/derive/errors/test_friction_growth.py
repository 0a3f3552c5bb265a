"""The lemma "growth of errors" through contacts with friction: errors at limits are within bounds.

Flights, errors and checks are those of `test_contact_frames.py`, with another law. Balls leave
contacts with any spin: errors of it have parts y_z, and at the next contact they slip or grip.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.errors import contact_frames as frames
from hoopgen.derive.errors import friction
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.kernels.arguments import argument_order
from numpy.typing import NDArray

from benchmarks.workloads import WORKLOADS
from hoopgen import PAPER
from hoopgen.codegen.identifiers import identifier
from tests.derive.errors.test_contact_frames import (
    NAMES,
    NONE,
    SIX,
    STATE,
    Columns,
    Contacts,
    NoSlipLaw,
    U,
    arguments,
    at_limits,
    check,
    departures,
    followed,
    met,
    recent_shares,
)
from tests.derive.errors.test_contact_frames import called as computed
from tests.derive.errors.test_friction_order import Law, Motion
from tests.helpers import exact_contacts as exact
from tests.helpers.derived import DerivedKernels, evaluation
from tests.helpers.effort import trials
from tests.helpers.exact_contacts import EXACT, Exact, Floats
from tests.helpers.exact_friction import Contact
from tests.helpers.scenes.slipping import SLIPPING

flint = pytest.importorskip("flint")

R_B = PAPER["ball_radius"]
OWN = ("friction", "tangential", "falling", "inertia")
USUAL = {f"p_{p.name}": float(p.default) for p in SLIPPING.parameters}

kernels: Any = None
"""The kernels of the scene; None: as they are."""


@cache
def usual_kernels() -> DerivedKernels:
    """Return the kernels of a scene with friction."""
    return DerivedKernels.from_scene(SLIPPING)


class FrictionLaw(NoSlipLaw):
    """Coulomb friction with the defaults of the scene, or with other parameters for each ball.

    Parameters
    ----------
    varied
        Whether each ball has its own.
    given
        Parameters of all balls.
    """

    def __init__(self, varied: bool = False, **given: float) -> None:
        self.varied = varied
        self.given = {f"p_{name}": value for name, value in given.items()}

    @property
    def kernels(self) -> Any:
        """The kernels of the scene."""
        return kernels or usual_kernels()

    def parameters(self, random: np.random.Generator, rows: int) -> Columns:
        """Return the parameters of the scene."""
        if not self.varied:
            return USUAL | self.given
        values = (
            10 ** random.uniform(np.log10(0.05), np.log10(2), rows),
            random.uniform(-0.5, 0.9, rows),
            random.choice([1.0, 40.0, np.inf], rows),
            random.choice([1 / 64, 0.4, 2 / 3, 1.0], rows),
        )
        own = {f"p_{name}": value for name, value in zip(OWN, values, strict=True)}
        return USUAL | own | {"p_restitution": random.choice([0.0, 0.5, 0.7, 1.0], rows)}

    def departing_spin(self, normal: Floats, velocity: Floats, spin: Floats) -> Floats:
        """Return any spin: after a slip it may be so."""
        return spin

    def slip(self, columns: Columns) -> Columns:
        """Return what is computed of the slip before a contact."""
        return computed(self.kernels, "impact_slip", columns)

    def impact(self, columns: Columns) -> Columns:
        """Return the computed motion after contacts; the rounded one if roundings are added."""
        if "off_vx" not in columns:
            return computed(self.kernels, "impact", columns)
        with flint.ctx.workprec(exact.BITS):
            n, v, w = (EXACT([columns[a + k] for k in "xyz"]) for a in "nvw")
            moved, turned = Contact(n, v, w, named(columns)).after()
            return dict(zip(STATE[3:], np.array([*moved, *turned], float), strict=True))

    def exact_impact(self, n: Exact, v: Exact, w: Exact, start: Columns) -> tuple[Exact, Exact]:
        """Return the exact motion after contacts."""
        return Contact(n, v, w, named(start)).after()

    def added_roundings(self, at: Columns) -> tuple[Floats, Floats]:
        """Return the most roundings, but for two of the numbers themselves."""
        v, w = (np.array([at[k] for k in names]) for names in (STATE[3:6], STATE[6:]))
        speed, spinning = np.abs(v).sum(axis=0), np.abs(w).sum(axis=0)
        whole, inertia = speed + R_B * spinning, at["p_inertia"]
        grip = inertia * (1 + at["p_tangential"]) / (1 + inertia)
        steepest = np.where(np.isinf(at["p_friction"]), 0, at["p_friction"])
        slope = np.where(at["slip_margin"] < 0, steepest * (1 + at["p_restitution"]), 0)
        shared = (friction.SHARE_ROUNDINGS - 2) * grip * whole
        pushed = shared + friction.SLOPE_ROUNDINGS * slope * speed
        moved = (friction.MOTION_ROUNDINGS - 2) * whole + pushed
        spun = (friction.SPIN_ROUNDINGS - 2) * spinning + pushed / (inertia * R_B)
        return U * moved, U * spun

    def effects(self, n: Floats, nudge: Floats, at: Columns) -> tuple[Floats, Floats]:
        """Return what roundings of normals make of velocity and spin, to first order."""
        v, w = (np.array([at[k] for k in names]) for names in (STATE[3:6], STATE[6:]))
        given = named(at)
        given["friction"] = np.minimum(given["friction"], 1e6)  # if infinite, as large a number
        law = Law(*(np.asarray(given[name]) for name in ("restitution", *OWN)))
        _, moved, turned = Motion(n, v, w).change(law, Motion(nudge, 0 * v, 0 * w))
        return moved, turned


def named(columns: Columns) -> dict[str, Any]:
    """Return the parameters of columns by name."""
    return {name.removeprefix("p_"): value for name, value in columns.items() if name[:2] == "p_"}


def slips_of(contacts: Contacts) -> NDArray[np.bool_]:
    """Return which contacts slip."""
    return np.asarray(contacts.at["slip_margin"] < 0)


USUAL_LAW, MANY_LAWS = FrictionLaw(), FrictionLaw(varied=True)


def of_contacts(contacts: Contacts, rows: NDArray[np.bool_]) -> dict[str, float]:
    """Return the largest share of each bound that the errors of some contacts reach."""
    return {name: float(share[rows].max()) for name, share in contacts.shares().items()}


def check_both(contacts: Contacts, least: dict[str, float], usual: float) -> None:
    """Demand that errors are within bounds, and near them whether contacts slip or grip.

    Parameters
    ----------
    contacts
        The contacts.
    least
        The shares of bounds that must be exceeded, where they are not the usual one.
    usual
        The usual one.
    """
    check(contacts)
    slips = slips_of(contacts)
    assert np.mean(slips) > 0.2
    assert np.mean(~slips) > 0.2
    for rows in (slips, ~slips):
        found = of_contacts(contacts, rows)
        assert all(found[name] > least.get(name, usual) for name in found), found


@pytest.mark.sampled(4)
@pytest.mark.parametrize("law", [USUAL_LAW, MANY_LAWS], ids=["usual", "many"])
@pytest.mark.parametrize("bounds", ["none", "one", "many", "one large"])
def test_errors_at_their_limits_stay_within_the_bounds(bounds: str, law: FrictionLaw) -> None:
    """Nearly all of each bound is reached, whether contacts slip or grip.

    Without errors before the contact, the norms of errors of velocity and spin are less: roundings
    along three axes are seldom at their limits at once. The delay has room of 1/11 for a slower
    contact.
    """
    own = departures(1, bounds, law=law)
    contacts = met(own, *at_limits(own, 2))
    assert len(contacts.own.t) > 0.9 * len(own.t)
    assert np.mean(contacts.own.back) > 0.2
    assert np.mean(contacts.own.last != NONE) > 0.5
    rounded = {"velocity_bound": 0.3, "spin_bound": 0.15, "delay": 0.8}
    usual = {"delay": 0.8, "spin_bound": 0.9}
    check_both(contacts, *((rounded, 0.85) if bounds == "none" else (usual, 0.95)))


@pytest.mark.parametrize("law", [USUAL_LAW, MANY_LAWS], ids=["usual", "many"])
def test_large_errors_of_the_spin_alone_stay_within_the_bounds(law: FrictionLaw) -> None:
    """Slips change by up to a fifth there, and for some errors no lemma holds."""
    own = departures(1, "spin", count=4000, law=law)
    own = own.of(np.flatnonzero(own.last != NONE))
    contacts = met(own, *at_limits(own, 2))
    assert 0.7 < len(contacts.own.t) / len(own.t) < 0.97
    least = {"pace_n": -1.0, "delay": 0.8, "position_bound": 0.8, "spin_bound": 0.6}
    check_both(contacts, least, 0.95)
    change = R_B * contacts.own.start["turn_z"] / contacts.at["slip_speed"]
    assert np.mean(change[slips_of(contacts)] > 0.02) > 0.1


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("bounds", ["none", "one", "many", "one large", "spin"])
def test_no_errors_of_many_flights_exceed_the_bounds(bounds: str, seed: int) -> None:
    for law in (USUAL_LAW, MANY_LAWS):
        own = departures(100 + seed, bounds, count=8000, law=law)
        check(met(own, *at_limits(own, seed)))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("law", [USUAL_LAW, MANY_LAWS], ids=["usual", "many"])
@pytest.mark.parametrize("bounds", ["none", "one", "many"])
def test_errors_since_an_earlier_contact_stay_within_the_tighter_bounds(
    bounds: str, law: FrictionLaw
) -> None:
    own = departures(11, bounds, through=True, law=law)
    own = own.of(np.flatnonzero(own.last != NONE))
    contacts = met(own, *at_limits(own, 12), "tighten_impact")
    assert len(contacts.own.t) > 0.9 * len(own.t)
    largest, recent = check(contacts), recent_shares(contacts).max(axis=1)
    assert np.all(recent <= 1), recent
    least = 0.6 if bounds == "none" else 0.95
    assert np.all(recent > least), recent
    assert all(largest[name] > least for name in NAMES[SIX]), largest


# ------------------------------------------------------------------------------ since the release

LAWS = {
    "usual": USUAL_LAW,
    "smooth": FrictionLaw(friction=0.1, tangential=-0.3, falling=5.0, inertia=0.4),
    "rough": FrictionLaw(friction=1.5, tangential=0.8, inertia=1.0),
    "without friction": FrictionLaw(friction=0.0),
    "without slip": FrictionLaw(friction=np.inf, tangential=0.0, falling=np.inf),
}
"""Laws for whole shots."""


@pytest.mark.sampled(6)
@pytest.mark.parametrize("workload", [1, 2, 3])
@pytest.mark.parametrize("law", LAWS.values(), ids=list(LAWS))
def test_errors_since_the_release_are_within_the_bounds(law: FrictionLaw, workload: int) -> None:
    """Workloads 1 to 3 are free throws, shots that bounce often, and shots that swirl."""
    states = WORKLOADS[workload].make(trials(300, at_least=50))
    usual, tighter = (
        followed(states, 12, kernel, law) for kernel in ("carry_impact", "tighten_impact")
    )
    assert len(usual) > 2
    for contacts in (usual, tighter):
        largest = [max(check(one).values()) for one in contacts]
        assert max(largest) > 0.1
    ratios = [
        np.median(np.asarray(one.bounds["position_bound"] / other.bounds["position_bound"]))
        for one, other in zip(tighter, usual, strict=True)
    ]
    assert all(ratio < 1 + 2.0**-8 for ratio in ratios), ratios
    if law is USUAL_LAW:
        slips = np.concatenate([slips_of(one) for one in usual])
        assert 0.1 < np.mean(slips) < 0.9
        assert min(ratios) < 0.9, ratios


# ------------------------------------------------------------------------ where nothing is proved


def bounds_with(contacts: Contacts, **changed: Any) -> NDArray[np.bool_]:
    """Return which contacts have finite bounds, if arguments of the kernel are changed."""
    module = contacts.own.law.kernels
    columns = contacts.own.start | contacts.at | {"t": contacts.own.t}
    columns |= {"back": contacts.own.back * 1.0} | changed
    with np.errstate(all="ignore"):
        found = computed(module, "carry_impact", columns)
    names = [*NAMES, "position_bound", "velocity_bound", "spin_bound", "delay"]
    finite = np.isfinite([np.asarray(found[name], float) for name in names])
    assert np.array_equal(finite.any(axis=0), finite.all(axis=0))
    return np.asarray(finite.all(axis=0))


def test_where_the_contact_is_not_decided_or_hardly_slips_bounds_are_infinite() -> None:
    """Rounding alone is enough for that, and a mu of zero or infinity decides nothing."""
    own = departures(8, "none", law=MANY_LAWS)
    contacts = met(own, *at_limits(own, 8))
    slips, margin = slips_of(contacts), contacts.at["slip_margin"]
    assert np.all(bounds_with(contacts, slip_margin=margin))
    close = np.where(slips, -1, 1) * 2.0**-53
    assert not np.any(bounds_with(contacts, slip_margin=close))
    sizes = np.sum([np.abs(contacts.at[k]) for k in STATE[3:6]], axis=0)
    hardly = bounds_with(contacts, slip_speed=2.0**-20 * sizes)
    assert np.array_equal(hardly, ~slips)
    for friction_alone in (0.0, np.inf):
        law = FrictionLaw(friction=friction_alone)
        own = departures(8, "one", law=law)
        assert len(met(own, *at_limits(own, 8)).own.t) > 0.98 * len(own.t)


# ------------------------------------------------------------------------------------ T's roundings


def rest_terms(grows: frames.Growth, impact: friction.FrictionImpact) -> list[sp.Expr]:
    """Return the terms beside |T| B of y_n, y_s, y_e, y_w and y_z."""
    arrival = frames.Arrival(SLIPPING.flight, SLIPPING.ball, grows.here, grows.gap)
    rest = impact.rest(arrival)
    return [*rest.extras[2:], rest.unrolled]


def test_roundings_of_t_are_within_what_the_bounds_count_for_them() -> None:
    """In single precision and in double, with the slip that is given to both in double."""
    impact = friction.FrictionImpact(SLIPPING.ball, SLIPPING.laws[0])
    grows = frames.growth(SLIPPING.flight, impact)
    elements = {
        f"row_{row}_{column}": value
        for column, values in enumerate(grows.columns)
        for row, value in enumerate(values)
    }
    terms = {f"with_{k}": one for k, one in enumerate(rest_terms(grows, impact))}
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(friction.FrictionImpact.rest.__globals__, "T_ROUNDING", sp.Integer(0))
        terms |= {f"without_{k}": one for k, one in enumerate(rest_terms(grows, impact))}
    own = departures(15, "one", law=MANY_LAWS, count=4000)
    own = own.of(np.flatnonzero(own.last != NONE))
    contacts = met(own, *at_limits(own, 16))
    t = contacts.own.t
    columns = arguments(MANY_LAWS.kernels, contacts.own, contacts.at, t, contacts.at)
    order, found = argument_order(SLIPPING), {}
    for single in (True, False):
        outputs = elements if single else elements | terms
        one = kernel("roundings", outputs, order, "Elements of T.", "the lemma", single)
        values = evaluation(one, SLIPPING.symbols)(*(columns[identifier(s)] for s in one.arguments))
        values = (np.broadcast_to(np.asarray(value, float), len(t)) for value in values)
        found[single] = dict(zip(outputs, values, strict=True))
    bounds = [np.asarray(columns[s.name], float) for s in frames.EACH]
    reached = []
    for row in range(2, len(grows.columns[0])):
        names = [f"row_{row}_{column}" for column in range(len(bounds))]
        parts = zip(names, bounds, strict=True)
        off = sum(np.abs(found[True][name] - found[False][name]) * b for name, b in parts)
        part = min(row - 2, 4)
        counted = found[False][f"with_{part}"] - found[False][f"without_{part}"]
        assert np.all(off <= counted), row
        reached.append(np.max(off / counted))
    assert max(reached) > 1 / 50
