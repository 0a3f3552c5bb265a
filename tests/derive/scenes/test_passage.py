"""Passages through the ring: decided from the ball's flights, or undecided.

The truth is from the same flights in more digits.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx
from hoopgen.derive.scenes import COURT, HOOP
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.passage import FALLEN, NEITHER, RISEN, passage_kernels
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY
from hoopgen.generated.numpy import court as kernels
from hoopgen.generated.numpy import hoop
from mpmath import mp, mpf
from numpy.typing import NDArray

from hoopgen.judge import passage
from tests.helpers.effort import exceptions, trials

Floats = NDArray[np.float64]

RADIUS, GRAVITY = 0.235, 9.81


def called(name: str, **given: Any) -> tuple[Any, ...]:
    """Call a kernel of the court with what it takes of what is given."""
    found = getattr(kernels, name)(*(given[each] for each in kernels.ARGUMENTS[name]))
    return found if isinstance(found, tuple) else (found,)


def of_kernels(states: Floats, times: Floats, before: Floats, errors: Floats) -> tuple[Any, Any]:
    """Return `through` after flights, and whether that is undecided."""
    given: dict[str, Any] = dict(zip(("x", "y", "z", "vx", "vy", "vz"), states.T, strict=True))
    given |= {"t": times, "through": before, "p_ring_radius": RADIUS, "p_gravity": GRAVITY}
    given |= {"extent": np.abs(states[:, :3]).sum(axis=1)}
    given |= {"speed": np.abs(states[:, 3:]).sum(axis=1)}
    given |= {"position_error": errors, "velocity_error": errors}
    with np.errstate(all="ignore"):
        (through,), (unsure,) = called("passing", **given), called("passing_undecided", **given)
    return through, unsure


def truth(state: Any, time: float, before: int) -> int:
    """Return the same from the roots of z in 50 digits, in order."""
    with mp.workdps(50):
        x, y, z, vx, vy, vz = (mpf(float(c)) for c in state[:6])
        g, end, through = mpf(GRAVITY), mpf(float(time)), before
        squared = vz**2 + 2 * g * z
        if squared <= 0:
            return through
        for side in (-1, 1):
            when = (vz + side * mp.sqrt(squared)) / g
            # On the plane is above it: passed downwards at once, upwards only from below.
            counts = (0 < when <= end) if side < 0 else (0 <= when < end)
            if not counts or mp.hypot(x + vx * when, y + vy * when) >= RADIUS:
                continue
            if side < 0:
                through = NEITHER if through == FALLEN else RISEN
            elif through == NEITHER:
                through = FALLEN
        return through


def flights(count: int, seed: int) -> tuple[Floats, Floats, Floats]:
    """Return flights about the disc, clear of its edge; half begin, turn or end close to it."""
    rng = np.random.Generator(np.random.PCG64(seed))
    states = np.concatenate(
        [rng.uniform(-0.5, 0.5, (count, 3)), rng.normal(0, 2, (count, 3))], axis=1
    )
    times, before = rng.uniform(0, 1, count), rng.integers(-1, 2, count).astype(float)
    tiny = 10.0 ** rng.uniform(-18, -6, count) * rng.choice([-1, 0, 1], count)
    which = rng.integers(0, 6, count)
    z, vz = states[:, 2], states[:, 5]
    fallen = vz * times - GRAVITY * times**2 / 2
    z[:] = np.select([which == 0, which == 1], [tiny, tiny - fallen], default=z)
    z[:] = np.where(which == 2, tiny - vz**2 / (2 * GRAVITY), z)
    return states, times, before


def test_the_kernel_finds_what_more_digits_find_or_is_undecided() -> None:
    states, times, before = flights(trials(6000, at_least=2000), seed=1)
    through, unsure = of_kernels(states, times, before, np.zeros(len(states)))
    wanted = [truth(s, t, int(b)) for s, t, b in zip(states, times, before, strict=True)]
    wrong = through != np.array(wanted)
    assert not (wrong & ~unsure).any()
    assert wrong.any()  # else nothing was close enough
    assert unsure.mean() < 0.1
    assert set(zip(before.tolist(), wanted, strict=True)) >= {(0, 1), (0, -1), (1, 0), (-1, -1)}


@pytest.mark.sampled(1)
@pytest.mark.parametrize("error", [1e-13, 1e-9, 1e-6])
def test_what_errors_of_a_state_turn_is_undecided(error: float) -> None:
    states, times, before = flights(trials(4000, at_least=2000), seed=2)
    rng = np.random.Generator(np.random.PCG64(3))
    through, unsure = of_kernels(states, times, before, np.full(len(states), error))
    turned = np.zeros(len(states), np.bool_)
    for _ in range(3):
        moved = states + error * rng.uniform(-1, 1, states.shape)
        others = [truth(s, t, int(b)) for s, t, b in zip(moved, times, before, strict=True)]
        turned |= through != np.array(others)
    assert not (turned & ~unsure).any()
    assert turned.any()
    assert unsure.mean() < 0.2


def test_the_judge_finds_what_more_digits_find() -> None:
    states, times, before = flights(trials(1500), seed=4)
    sizes = [arb(RADIUS), arb(0.02), arb(GRAVITY)]
    known = 0
    with ctx.workprec(256):
        for state, time, own in zip(states, times, before, strict=True):
            start, t = [arb(float(c)) for c in state], arb(float(time))
            fall = arb(GRAVITY) * t
            end = [start[k] + start[3 + k] * t for k in range(3)] + start[3:]
            end[2], end[5] = end[2] - fall * t / 2, end[5] - fall
            found = passage.after(int(own), sizes, start, end, t)
            assert found in (None, truth(state, time, int(own)))
            known += found is not None
    assert len(states) - known < exceptions(10 / 1500, len(states))


def test_on_the_wires_outside_the_side_of_the_plane_is_of_no_matter() -> None:
    """A ball that touches there, above or below by less than is known, can fall in all the same."""
    with ctx.workprec(128):
        sizes = [arb(RADIUS), arb(0.02), arb(GRAVITY)]
        time = arb(0.45)
        start = [arb(0.366), arb(0), arb(0, 1e-20), arb(-0.8), arb(0), arb(2.15)]
        end = [start[0] + start[3] * time, arb(0), start[5] * time - sizes[2] * time**2 / 2]
        assert end[2] < 0
        assert passage.after(NEITHER, sizes, start, end, time) == FALLEN
        inside = [arb(0.1), *start[1:]]
        assert passage.after(NEITHER, sizes, inside, end, time) is None


@pytest.mark.parametrize(
    ("place", "last", "through"),
    [
        ((0.0, 0.0, -0.01), -1, NEITHER),  # a release has passed nothing
        ((0.0, 0.0, -0.01), 0, FALLEN),
        ((0.0, 0.0, 0.01), 0, NEITHER),
        ((0.4, 0.0, -0.01), 0, NEITHER),
        ((0.0, 0.0, -0.03), 0, NEITHER),  # below the end plane
    ],
)
def test_what_a_ball_starts_as(place: Any, last: int, through: int) -> None:
    given = dict(zip("xyz", map(np.float64, place), strict=True))
    given |= {"last": last, "outcome": -1.0, "uncertain": 0.0}
    found = called("passing_start", **given, p_ring_radius=RADIUS, p_end_depth=0.024)
    assert tuple(map(float, found)) == (through, 0.0)
    sizes = [arb(RADIUS), arb(0.024), arb(GRAVITY)]
    assert passage.at_start(sizes, [arb(c) for c in place], last) == through


def test_a_scene_without_a_passage_pays_nothing_for_it() -> None:
    assert not any("passing" in name or name == "through" for name in dir(hoop))
    assert "through" not in {field.name for field in hoop.FIELDS}
    assert "through" in {field.name for field in kernels.FIELDS}


def test_what_cannot_be_passed_is_refused() -> None:
    with pytest.raises(ValueError, match=r"end 'made': passed needs a passage of the scene"):
        replace(COURT, passage=None)
    bare = End("made", replace(COURT.ends[0].plane, limits=()), passed=True)
    with pytest.raises(ValueError, match=r"end 'made': passed needs bounds"):
        replace(COURT, ends=(bare, COURT.ends[1]))
    sideways = replace(HOOP, gravity_axis=(1, 0, 0)).flight
    assert COURT.passage is not None
    order = (*POSITION, *VELOCITY, *COURT.symbols)
    with pytest.raises(ValueError, match=r"free fall is down, along -z"):
        passage_kernels(COURT.passage, sideways, order)


def test_the_apex_on_the_plane_is_between_one_rounding_and_the_next() -> None:
    """D = vz² + 2 g z is zero exactly: the next double of z on either side decides."""
    vz, z = 4.0, -0.5  # with g = 16
    exact = Fraction(vz) ** 2 + 32 * Fraction(z)
    assert exact == 0
    rows = np.array([[0, 0, float(np.nextafter(z, to)), 0, 0, vz] for to in (-1, 0)])
    given: dict[str, Any] = dict(zip(("x", "y", "z", "vx", "vy", "vz"), rows.T, strict=True))
    given |= {"t": 0.5, "through": 0.0, "p_ring_radius": RADIUS, "p_gravity": 16.0}
    (through,) = called("passing", **given)
    assert through.tolist() == [NEITHER, RISEN]
