"""Contacts with a box: their frames, how exact their roots are, and the growth of errors there.

`test_contact_frames.py` does the same at the ring and planes of the article's hoop.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.errors.contact_frames import BOUNDS, NORMS
from hoopgen.derive.errors.surface_frames import SEAM_ROUNDING, SEAM_SHARE
from hoopgen.derive.symbolic.error_terms import left_normal
from hoopgen.derive.symbolic.symbols import UNIT_ROUNDOFF
from numpy.typing import NDArray

from tests.helpers import exact_contacts as exact
from tests.helpers.derived import DerivedKernels
from tests.helpers.effort import trials
from tests.helpers.exact_box import ExactBox
from tests.helpers.exact_contacts import EXACT, MIDDLE, Exact, Floats, cross
from tests.helpers.scenes.block import BLOCK

flint = pytest.importorskip("flint")

SIZES = {p.name: p.default for p in BLOCK.parameters}
LOW, HIGH = (np.array([SIZES[f"{side}_{a}"] for a in "xyz"]) for side in ("from", "to"))
R_B, G, U = SIZES["ball_radius"], SIZES["gravity"], float(UNIT_ROUNDOFF)
STATE = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
NORMAL = ("nx", "ny", "nz")
NAMES = tuple(s.name for s in BOUNDS)
SIX = slice(1, 7)
Columns = dict[str, Any]

with flint.ctx.workprec(exact.BITS):
    BOX = ExactBox(LOW, HIGH)
    NUMBERS = np.vectorize(
        lambda one: one if isinstance(one, flint.arb) else flint.arb(float(one)), otypes=[object]
    )


@cache
def block() -> DerivedKernels:
    """Return the kernels of the scene with a block."""
    return DerivedKernels.from_scene(BLOCK)


def called(name: str, columns: Columns) -> Columns:
    """Return what a kernel computes."""
    kernels = block()
    given = {**columns, **{kernels.VARIABLES[n]: v for n, v in SIZES.items()}}
    found = getattr(kernels, name)(*(given[n] for n in kernels.ARGUMENTS[name]))
    return dict(zip(kernels.OUTPUTS[name], found, strict=True))


def taken(columns: Columns, rows: NDArray[Any]) -> Columns:
    """Return some rows of columns."""
    return {k: v[rows] if np.ndim(v) else v for k, v in columns.items()}


def upwards(values: Any) -> Floats:
    """Return the least single-precision numbers that are no smaller."""
    single = np.asarray(values, np.float32)
    return np.where(single < values, np.nextafter(single, np.float32(np.inf)), single)


def norms(vectors: Any) -> Floats:
    """Return Euclid's norms, (n,)."""
    return np.sqrt(np.sum(np.asarray(vectors, float) ** 2, axis=0))


def places(random: np.random.Generator, count: int, seams: float = 1e-3) -> tuple[Floats, Floats]:
    """Return random places at contacts, (3, n), and on which side each coordinate is.

    Parameters
    ----------
    random
        The generator.
    count
        How many there are.
    seams
        How far they are from seams.
    """
    side = random.choice([-1, 0, 1], (3, count))
    side[2, ~side.any(axis=0)] = 1
    faces = np.sum(side != 0, axis=0) == 1
    inner = LOW[:, None] + seams + (HIGH - LOW - 2 * seams)[:, None] * random.random((3, count))
    point = np.select([side < 0, side > 0], [LOW[:, None], HIGH[:, None]], inner)
    away = side * 10 ** random.uniform(-2.3, 0, (3, count))
    return np.asarray(point + away * R_B / norms(away)), np.where(faces, 1, side)


# --------------------------------------------------------------------------------------- geometry


def tangents(place: Floats, more: Columns | None = None) -> Columns:
    """Return the numbers of contacts at places, in double precision where they are made for it."""
    columns: Columns = dict(zip(STATE, (*place, *np.full((6, place.shape[1]), -0.5)), strict=True))
    columns |= {"t": 0.1, "place_n": 0.0, "back": 0.0, "normal_velocity": -0.5} | (more or {})
    columns |= called("block_normal", columns)
    return columns | called("block_tangents", columns)


def test_tangents_and_bends_are_those_of_face_edge_and_corner() -> None:
    """K is no less than either bend, nor than that of edges and corners."""
    place, _ = places(np.random.default_rng(1), trials(4000))
    found = tangents(place)
    with flint.ctx.workprec(exact.BITS):
        frame = BOX.frame(EXACT(place))
    bends = np.array([frame.bend_s, frame.bend_e], float)
    assert np.all(np.abs([found["bend_s"], found["bend_e"]] - bends) <= 1e-6 * bends)
    off = np.array([found["tangent_x"], found["tangent_y"]]) - np.array(frame.e[:2], float)
    assert np.abs(off).max() < 1e-6
    sharp = np.asarray(found["sharpest_bend"], float)
    assert np.all(sharp >= np.max([*bends, np.full(len(sharp), 1 / R_B)], axis=0) * (1 - 1e-6))
    for kind in ((0, 0), (1, 0), (0, 1), (1, 1)):
        assert np.count_nonzero(np.all(kind == (bends > 0).T, axis=1)) > len(sharp) / 50


def test_a_ball_that_moves_on_the_surface_has_a_frame_that_turns_as_the_bends_have_it() -> None:
    """To second order of the way; K bounds the turn and its own, |Ω q| <= K |q|."""
    random = np.random.default_rng(2)
    place, _ = places(random, trials(2000, at_least=400))
    sharp = np.asarray(tangents(place)["sharpest_bend"], float)
    with flint.ctx.workprec(exact.BITS):
        x = BOX.on_surface(EXACT(place))
        frame, (along, around) = BOX.frame(x), EXACT(random.normal(0, 1e-15, (2, len(sharp))))
        step = frame.s * along + frame.e * around
        moved = BOX.frame(BOX.on_surface(x + step))
        turn = frame.turning(along, around)
        way = norms(step)
        for axis, then in ((frame.n, moved.n), (frame.s, moved.s), (frame.e, moved.e)):
            left = norms(then - axis - cross(turn, axis))
            assert np.all(left <= 4 * (sharp * way) ** 2)
        assert np.all(norms(turn) <= (1 + 2.0**-20) * sharp * way)
        assert np.max(norms(turn) / (sharp * way)) > 0.99


def test_no_seam_is_within_the_share_of_the_curvature_that_errors_may_make() -> None:
    """Contacts so close to a seam that single precision does not tell have no finite bounds."""
    random = np.random.default_rng(3)
    place, _ = places(random, trials(4000))
    axis, rows = random.integers(0, 3, place.shape[1]), np.arange(place.shape[1])
    corners = np.where(random.random(len(rows)) < 0.5, LOW[axis], HIGH[axis])
    near = random.choice([-1, 1], len(rows)) * 10 ** random.uniform(-12, -2, len(rows))
    place[axis, rows] = corners + near
    with flint.ctx.workprec(exact.BITS):
        x = EXACT(place)
        outside = np.array(BOX.away(x), float) > R_B / 4
        place, x = place[:, outside], x[:, outside]
        apart = BOX.to_seam(x)
    sharp = np.asarray(tangents(place)["sharpest_bend"], float)
    assert np.all(sharp * apart >= 1 / SEAM_SHARE)
    blurred = float(SEAM_ROUNDING) * (np.abs(LOW) + np.abs(HIGH)).sum()
    assert np.all(np.isinf(sharp[apart < blurred / 2]))
    assert np.all(np.isfinite(sharp[apart > 2 * blurred]))
    assert 0.2 < np.mean(np.isinf(sharp)) < 0.8
    # In single precision itself a distance is off by less than that.
    sides = np.array([*LOW, *HIGH])[:, None]
    own = np.abs(np.concatenate([place, place]) - sides)
    short = np.abs(np.concatenate([place, place]).astype(np.float32) - sides.astype(np.float32))
    assert np.max(np.abs(own - short) - 2.0**-22 * own) < blurred / 4


def test_the_rounding_of_the_normal_is_within_its_bound() -> None:
    place, _ = places(np.random.default_rng(4), trials(8000))
    place *= 1 + 2.0**-40
    found = tangents(place)
    with flint.ctx.workprec(exact.BITS):
        off = norms(BOX.frame(EXACT(place)).n - EXACT([found[k] for k in NORMAL]))
    share = off / np.asarray(found["normal_rounding"], float)
    assert 0.1 < share.max() <= 1, share.max()


# -------------------------------------------------------------------------------------- departures


@dataclass
class Flights:
    """Flights to the block, with bounds on their errors.

    Attributes
    ----------
    start
        The computed states, with the frames and the bounds there.
    t
        About the times of the flights.
    exact
        Exact places, velocities and spins at the start.
    back
        Which flights begin on the block.
    """

    start: Columns
    t: Floats
    exact: tuple[Exact, Exact, Exact]
    back: NDArray[np.bool_]

    def of(self, rows: NDArray[Any]) -> Flights:
        """Return some of them."""
        x, v, w = (part[:, rows] for part in self.exact)
        return Flights(taken(self.start, rows), self.t[rows], (x, v, w), self.back[rows])


def flights(seed: int, bounds: str, count: int = 2500) -> Flights:
    """Return flights to the block, two in three from it, with errors at their limits.

    Parameters
    ----------
    seed
        The seed.
    bounds
        "many", "one" or "none" of them are not zero, or "one large".
    count
        About how many flights there are at effort 1.
    """
    random, rows = np.random.default_rng(seed), trials(count, at_least=700)
    tried = 12 * rows
    (to, _), (begin, _) = places(random, tried), places(random, tried)
    back = random.random(tried) < 0.67
    free = to + random.normal(0, 1, (3, tried)) * 10 ** random.uniform(-1, 0.7, tried)
    short = random.random(tried) < 0.5
    hop = to + random.normal(0, 1, (3, tried)) * 10 ** random.uniform(-3, -1, tried)
    with flint.ctx.workprec(exact.BITS):
        off = hop - np.clip(hop, LOW[:, None], HIGH[:, None])
        kept = norms(off) > R_B / 4
        hop = np.where(kept, np.array(BOX.on_surface(EXACT(np.where(kept, hop, to))), float), begin)
    begin = np.where(back, np.where(short & kept, hop, begin), free)
    t = 10 ** np.where(short, random.uniform(-2.5, -0.5, tried), random.uniform(-1, 0.1, tried))
    mean, fall = (to - begin) / t, np.array([[0.0], [0.0], [G / 2]]) * t
    with flint.ctx.workprec(exact.BITS):
        apart = np.minimum(BOX.to_seam(EXACT(to)), BOX.to_seam(EXACT(begin)))
        apart *= np.array(BOX.away(EXACT(begin)), float) > R_B / 2
        leaves, comes = (
            np.sum(np.array(BOX.frame(EXACT(place)).n, float) * moving, axis=0)
            for place, moving in ((begin, mean + fall), (to, mean - fall))
        )
    slowest = 0.2 if bounds == "one large" else 0.02
    good = (~back | (leaves > 0)) & (comes < -slowest) & (norms(mean) + G * t < 12) & (apart > 1e-4)
    rows_kept = np.flatnonzero(good)[:rows]
    assert len(rows_kept) > 0.5 * rows
    return _with_errors(
        random,
        bounds,
        begin[:, rows_kept],
        (mean + fall)[:, rows_kept],
        t[rows_kept],
        back[rows_kept],
    )


def _with_errors(
    random: np.random.Generator,
    bounds: str,
    begin: Floats,
    velocity: Floats,
    t: Floats,
    back: NDArray[np.bool_],
) -> Flights:
    """Return flights whose errors are at the limits of random bounds; a release has none."""
    rows = len(t)
    least, most = (-6, -4) if bounds == "one large" else (-13, -7)
    amounts = 10 ** random.uniform(least, most, (len(NAMES), rows))
    if bounds == "one large":
        amounts[0] *= 1e-4
    if bounds == "many":
        amounts *= random.random((len(NAMES), rows)) < 0.7
    elif bounds.startswith("one"):
        amounts *= np.arange(len(NAMES))[:, None] == random.integers(0, len(NAMES), rows)
    amounts *= 0 if bounds == "none" else back
    amounts = upwards(amounts).astype(float)
    signs = random.choice([-1.0, 1.0], (9, rows))
    turning = random.normal(0, 20, (3, rows)) * random.choice([1.0, 0.01], rows)
    with flint.ctx.workprec(exact.BITS):
        q = NUMBERS((signs * amounts[[*range(len(NAMES)), -1]]).astype(object))
        away = np.array(BOX.frame(EXACT(begin)).n, float)
        across = turning - away * np.sum(turning * away, axis=0)
        rolling = np.cross(away, velocity, axis=0) / R_B
        turning = np.where(back, turning - across + rolling, turning)
        begin = np.where(back, begin - signs[0] * amounts[0] * away, begin)
        # The exact ball is on the block, and the computed one may be off it.
        for _ in range(3):
            x, v, w = (EXACT(part) for part in (begin, velocity, turning))
            frame = BOX.frame(x)
            off = BOX.distance(x + exact.errors_of(frame, q, v, w)[0])
            begin = np.where(back, np.array(x - frame.n * off, float), begin)
        x = EXACT(begin)
        frame = BOX.frame(x)
        for _ in range(6):
            off = BOX.distance(x + exact.errors_of(frame, q, v, w)[0])
            q[0] = MIDDLE(np.where(back, q[0] - off, q[0]))
        errors = exact.errors_of(frame, q, v, w)
        amounts[0] = upwards(np.abs(np.array(q[0], float)) * (1 + 2.0**-50))
        sizes = [upwards(exact.size(error) * (1 + 2.0**-40)) for error in errors]
        true = (x + errors[0], v + errors[1], w + errors[2])
    start: Columns = dict(zip(STATE, (*begin, *velocity, *turning), strict=True))
    start["clock"] = np.zeros(rows)
    start |= dict(zip(NAMES, amounts, strict=True))
    start |= {s.name: value for s, value in zip(NORMS, sizes, strict=True)}
    frames = tangents(np.asarray(begin))
    names = [*map(str, left_normal), "left_ex", "left_ey", "left_bend_s", "left_bend_e"]
    found = [frames[n] for n in (*NORMAL, "tangent_x", "tangent_y", "bend_s", "bend_e")]
    start |= {n: np.where(back, f, 0) for n, f in zip(names, found, strict=True)}
    return Flights(start, t, true, back)


# ------------------------------------------------------------------------------------------- roots


def before_contact(own: Flights, at: Columns, t: Floats) -> Columns:
    """Return all arguments of the kernels of bounds at states before contacts."""
    columns = own.start | {k: np.asarray(at[k]) for k in STATE if k in at}
    columns |= {"t": t, "back": own.back * 1.0} | called("block_normal", columns)
    columns |= {k: at[k] for k in NORMAL if k in at}
    columns |= called("normal_velocity", columns)
    return columns | called("block_tangents", columns)


def level_of(own: Flights) -> Exact:
    """Return how far the computed starts of returns are from the surface; zero for others."""
    x = EXACT([own.start[k] for k in STATE[:3]])
    return np.where(own.back, BOX.distance(x), 0 * x[0])


def exact_roots(own: Flights) -> Exact:
    """Return the times at which the exact flights of computed starts are at their levels."""
    with flint.ctx.workprec(exact.BITS):
        x, v = (EXACT([own.start[k] for k in names]) for names in (STATE[:3], STATE[3:6]))
        return BOX.arrival(x, v, EXACT(own.t), level_of(own))


@pytest.mark.parametrize("leaving", [0.0, 1.0])
def test_at_a_computed_root_the_exact_flight_is_as_far_off_the_block_as_its_bound(
    leaving: float,
) -> None:
    """Newton's method ends as the engine has it; a return is found with F, or with F/t."""
    own = flights(11, "none", 4000)
    own = own.of(np.flatnonzero(own.back) if leaving else np.arange(len(own.t)))
    t, begun = np.array(exact_roots(own), float), own.start
    t = t * (1 + np.random.default_rng(12).normal(0, 1e-7, len(t)))
    for _ in range(3):
        t = called("block_refine", begun | {"t": t, "leaving": leaving})["time"]
    at = before_contact(own, called("flight", begun | {"t": t}), t)
    with flint.ctx.workprec(exact.BITS):
        x, v = (EXACT([begun[k] for k in names]) for names in (STATE[:3], STATE[3:6]))
        there, _ = exact.flown(x, v, EXACT(t))
        off, level = BOX.distance(there), level_of(own)
        beyond = np.abs(np.array(off, float))
        from_level = np.abs(np.array(off - level, float))
    assert np.all(beyond <= at["root_level"])
    assert np.all(from_level <= at["root_offset"])
    edges = np.sum(np.abs(np.array([at[k] for k in NORMAL])) > 0, axis=0)
    for kind in (1, 2, 3):
        share = np.max((from_level / at["root_offset"])[edges == kind])
        assert share > (5e-4 if leaving else 0.2), (kind, share)


def counted(own: Flights, at: Columns, t: Floats) -> tuple[Floats, Floats]:
    """Return how far a root is off the level of its start, and off the surface, as counted."""
    moving = np.array([at[k] for k in STATE[3:6]])
    pull = np.array([0.0, 0.0, G])[:, None]
    mean, place = moving + pull * t / 2, np.array([at[k] for k in STATE[:3]])
    rounded = U * (np.abs(place) + 2 * np.abs(mean) * t + pull * t**2 / 2)
    with flint.ctx.workprec(exact.BITS):
        rounded += 2 * U * np.abs(np.array(BOX.excess(EXACT(place)), float))
    path = np.abs(moving).sum(axis=0) * t + G * t**2
    normal = np.array([at[k] for k in NORMAL])
    steep = at["normal_velocity"] ** 2 / (moving**2).sum(axis=0)
    once = np.sum(np.abs(normal) * rounded, axis=0) + 8 * U * R_B
    again = rounded.sum(axis=0) * path / R_B + 12 * U * path
    once, again = (
        noise + np.maximum(9 / 8 * noise, 16 * U * R_B * steep) + U * abs(at["normal_velocity"]) * t
        for noise in (once, again)
    )
    level = own.start["place_n"]
    return (
        np.where(own.back, np.maximum(again, once + level), once),
        np.where(own.back, np.maximum(level + again, once), once),
    )


def test_bounds_at_a_root_are_no_smaller_than_the_counts_of_their_lemma() -> None:
    """Nor larger, but for single precision; so is that of the normal."""
    own = flights(13, "one")
    t = np.array(exact_roots(own), float)
    at = before_contact(own, called("flight", own.start | {"t": t}), t)
    with flint.ctx.workprec(exact.BITS):
        beyond = np.abs(np.array(BOX.excess(EXACT([at[k] for k in STATE[:3]])), float)).sum(axis=0)
    names = ("root_offset", "root_level", "normal_rounding")
    for name, least in zip(names, (*counted(own, at, t), U * (2 * beyond / R_B + 8)), strict=True):
        ratio = np.asarray(at[name], float) / least
        assert np.all(np.abs(ratio - 1) < 1e-4), (name, ratio.min(), ratio.max())


# ------------------------------------------------------------------------------------------ growth


def at_limits(own: Flights, seed: int) -> tuple[Columns, Floats]:
    """Return contacts with roundings of flight, root and normal as large as they may be."""
    random = np.random.default_rng(seed)
    root = exact_roots(own)
    t, start = np.array(root, float), own.start
    rough = before_contact(own, called("flight", start | {"t": t}), t)
    from_level = np.maximum(0, rough["root_level"] - start["place_n"])
    offset = np.asarray(np.where(own.back, from_level, rough["root_offset"]), float)
    late = offset / np.abs(rough["normal_velocity"])
    late = random.choice([-1, 1], len(t)) * np.maximum(0, late * (1 - 2.0**-20) - U * t)
    with flint.ctx.workprec(exact.BITS):
        t = np.array(root + EXACT(late), float)
        x, v = (EXACT([start[k] for k in names]) for names in (STATE[:3], STATE[3:6]))
        place, moving = exact.flown(x, v, EXACT(t))
        mean = np.array((place - x) / EXACT(t), float)
        fall = np.array([[0.0], [0.0], [G]]) * t
        limits = U * np.array([*(2 * abs(mean) * t + fall * t / 2), *fall]) * (1 - 2.0**-20)
        signs = random.choice([-1.0, 1.0], limits.shape)
        ends = np.array(np.array([*place, *moving], object) + EXACT(signs * limits), float)
    at = dict(zip(STATE, (*ends, *(start[k] for k in STATE[6:])), strict=True))
    at = before_contact(own, at, t)
    # What is zero is so as computed, too.
    nudge = random.normal(size=(3, len(t))) * (np.array([at[k] for k in NORMAL]) != 0)
    nudge *= np.maximum(0, np.asarray(at["normal_rounding"], float) - 2 * U) / norms(nudge)
    with flint.ctx.workprec(exact.BITS):
        n = np.array(BOX.frame(EXACT([at[k] for k in STATE[:3]])).n + EXACT(nudge), float)
    return before_contact(own, at | dict(zip(NORMAL, n, strict=True)), t), t


@dataclass
class Contacts:
    """Contacts whose bounds are finite.

    Attributes
    ----------
    share
        Which share of the flights has them.
    back
        Which of them are returns.
    kinds
        1 on a face, 2 at an edge, 3 at a corner.
    bounds, sizes
        The bounds after the contacts, and the sizes of the errors, by name.
    """

    share: float
    back: NDArray[np.bool_]
    kinds: NDArray[np.int_]
    bounds: Columns
    sizes: dict[str, Floats]

    def check(self) -> dict[str, float]:
        """Demand that errors are within their bounds; return the largest share of each bound."""
        largest = {n: float(np.max(s / self.bounds[n])) for n, s in self.sizes.items()}
        assert max(largest.values()) <= 1, largest
        return largest


def met(own: Flights, at: Columns, t: Floats) -> Contacts:
    """Return contacts of computed balls, and those of exact balls at their own times."""
    with np.errstate(invalid="ignore"):
        bounds = called("carry_impact", at)
    rows, count = np.flatnonzero(np.isfinite(bounds["place_n"])), len(t)
    own, at, t, bounds = own.of(rows), taken(at, rows), t[rows], taken(bounds, rows)
    state = {k: at[k] for k in STATE} | called("impact", at)
    with flint.ctx.workprec(exact.BITS):
        x, v, w = own.exact
        time = BOX.arrival(x, v, EXACT(t))
        there, moving = exact.flown(x, v, time)
        moving, turning = exact.after_impact(BOX.frame(there).n, moving, w)
        place, pace, spins = EXACT([state[k] for k in STATE]).reshape(3, 3, -1)
        errors = there - place, moving - pace, turning - spins
        found = np.abs(
            np.array(exact.coordinates_of(BOX.frame(place), *errors, pace, spins), float)
        )
        late = np.abs(np.array(time - EXACT(t), float))
        sizes = dict(zip(NAMES, (*found[:7], np.maximum(*found[7:])), strict=True))
        sizes |= {s.name: exact.size(one) for s, one in zip(NORMS, errors, strict=True)}
    sizes |= {"delay": late}
    kinds = np.sum(np.array([at[k] for k in NORMAL]) != 0, axis=0)
    bounds = {name: np.asarray(bounds[name], float) for name in sizes}
    return Contacts(len(rows) / count, own.back, kinds, bounds, sizes)


@pytest.mark.parametrize("bounds", ["none", "one", "many", "one large"])
def test_errors_at_their_limits_stay_within_the_bounds(bounds: str) -> None:
    """From faces, edges and corners to others, along the block and from afar."""
    own = flights(21, bounds)
    contacts = met(own, *at_limits(own, 22))
    assert contacts.share > 0.3
    assert np.mean(contacts.back) > 0.3
    assert all(np.mean(contacts.kinds == kind) > 1 / 30 for kind in (1, 2, 3))
    largest = contacts.check()
    least = dict.fromkeys(largest, 0.35 if bounds == "none" else 0.9)
    least |= {"turn_z": 0.05, "delay": 0.4}
    least |= {"velocity_bound": 0.2, "spin_bound": 0.1} if bounds == "none" else {}
    assert all(largest[n] > least[n] for n in largest), largest


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("bounds", ["none", "one", "many", "one large"])
def test_no_errors_of_many_flights_exceed_the_bounds(bounds: str, seed: int) -> None:
    own = flights(100 + seed, bounds, 8000)
    met(own, *at_limits(own, seed)).check()


def test_errors_that_may_reach_over_a_seam_have_no_finite_bounds() -> None:
    """The same flights with errors that are larger than what is left to a seam."""
    own = flights(31, "none")
    at, t = at_limits(own, 32)
    with flint.ctx.workprec(exact.BITS):
        apart = BOX.to_seam(EXACT([at[k] for k in STATE[:3]]))
    start = own.start | {"position_bound": upwards(0.6 * apart)}
    wide = before_contact(Flights(start, own.t, own.exact, own.back), at, t)
    with np.errstate(invalid="ignore"):
        bounds = called("carry_impact", wide)
    assert not np.any(np.isfinite(bounds["place_n"]))
    start |= {"position_bound": upwards(1e-3 * apart)}
    narrow = before_contact(Flights(start, own.t, own.exact, own.back), at, t)
    with np.errstate(invalid="ignore"):
        bounds = called("carry_impact", narrow)
    assert np.mean(np.isfinite(bounds["place_n"])) > 0.3
