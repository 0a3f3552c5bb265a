"""Promises of the tests whether a piece in air comes to a body: none that does is passed over."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events import air_near
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.kernels.arguments import argument_order
from hoopgen.derive.motion.air_series import DOUBLE_SERIES
from hoopgen.derive.scenes.air import AIR
from hoopgen.derive.surfaces import Plane, Sphere, Surface

from hoopgen.codegen.program import Program, lower
from tests.derive.motion.test_air import DEFAULTS, Values, begin, path_of, run
from tests.helpers.effort import trials

SHARE = 2.0**-25
"""Errors that a search allows for, relative to the size of a piece."""

RING, BACKBOARD, BRIDGE = AIR.surfaces
(END,) = AIR.end_planes

REACH = DEFAULTS["ball_radius"] + DEFAULTS["wire_radius"]

_LEVEL = DEFAULTS["gravity"] ** 2 - 96.1
"""Place of the plane that is a difference, m; another parameter has the other number."""


GRAVITY, OTHER = (
    next(s for s in AIR.symbols if str(s) == name) for name in ("gravity", "restitution")
)
"""Parameters; no flight depends on the second, which is here the size of a body."""


def _sphere() -> Sphere:
    """Return a sphere with its top at the origin; its two numbers are rounded differently."""
    return Sphere("globe", (0, 0, -(OTHER - GRAVITY) * (OTHER + GRAVITY)), OTHER**2 - GRAVITY**2)


def _floor() -> Plane:
    """Return a plane whose distance from the origin is a difference of large numbers."""
    return Plane("floor", (0, 0, 1), GRAVITY**2 - OTHER, GRAVITY)


@cache
def programs() -> dict[str, Program]:
    """Return the tests of all bodies, of a large sphere and of a plane."""
    every: dict[str, tuple[Surface, sp.Basic]] = {
        "ring": (RING, air_near.near_box(RING, AIR.flight)),
        "globe": (_sphere(), air_near.near_box(_sphere(), AIR.flight)),
        **{
            s.name: (s, air_near.near_plane(s, AIR.flight))
            for s in (BACKBOARD, BRIDGE, END, _floor())
        },
    }
    order = argument_order(AIR)
    return {
        name: lower(
            kernel(name, {"open": near}, order, name, name, air_near.in_single(surface)),
            AIR.symbols,
        )
        for name, (surface, near) in every.items()
    }


def opens(name: str, known: Values, latest: float) -> bool:
    return bool(run(programs()[name], known | {"horizon": latest})["open"])


@cache
def _edges() -> dict[str, tuple[int, float, float, str]]:
    """Return by case an axis, the place of an edge on it, the side that is far, and the body."""
    board, wide = DEFAULTS["board_distance"], DEFAULTS["board_half_width"]
    face = DEFAULTS["ball_radius"] - board
    return {
        "the ring's outer edge": (0, DEFAULTS["ring_radius"] + REACH, 1.0, "ring"),
        "the ring's top": (2, REACH, 1.0, "ring"),
        "the end's plane": (2, -DEFAULTS["end_depth"], -1.0, END.name),
        "the board's face": (0, face, -1.0, "backboard"),
        "the board's side": (1, wide, 1.0, "backboard"),
        "the board's lower edge": (2, DEFAULTS["board_bottom"], -1.0, "backboard"),
        "the bridge's front": (0, 0.0, 1.0, "bridge"),
        "the bridge's side": (1, DEFAULTS["bridge_half_width"], 1.0, "bridge"),
        "the top of a large sphere": (2, 0.0, 1.0, "globe"),
        "a plane whose place is a small difference": (2, _LEVEL, 1.0, "floor"),
    }


def _beside(case: str, off: float, random: np.random.Generator) -> Values:
    """Return a piece of a ball that is `off` from an edge, towards the far side.

    Along the other axes it is at the body, and it moves so that only the place decides.
    """
    axis, edge, side, name = _edges()[case]
    middle = {
        "ring": (0.0, 0.0, 0.0),
        "globe": (0.0, 0.0, -1.0),
        END.name: (0.0, 0.0, -DEFAULTS["end_depth"]),
        "backboard": (DEFAULTS["ball_radius"] - DEFAULTS["board_distance"], 0.0, 0.3),
        "floor": (0.0, 0.0, 0.0),
        "bridge": (-0.2, 0.0, REACH),
    }[name]
    state = np.concatenate([middle, [-1.0, 0.2, -1.0], np.zeros(3)])
    state[3:6] *= random.uniform(0.5, 2.0)
    state[axis] = edge + side * off
    size = random.uniform(90.0, 100.0) if name == "globe" else 96.1
    return begin(state) | {"restitution": size}


@pytest.mark.slow
@pytest.mark.parametrize("case", _edges())
def test_a_ball_at_the_edge_of_a_body_is_near_within_all_errors_and_not_far_beyond(
    case: str,
) -> None:
    random = np.random.default_rng(12)
    *_, name = _edges()[case]
    passed = 0
    for _ in range(trials(50, at_least=30)):
        latest = 2.0 ** random.uniform(-40.0, -30.0)  # a path that is hardly longer than a point
        off = random.uniform(0.0, 2.0) * 2.0**-25
        known = _beside(case, 0.0, random)
        known = _beside(case, -off * known["piece_extent"], random)
        passed += not opens(name, known, latest)
        moved = _beside(case, SHARE * known["piece_extent"], random)
        passed += not opens(name, moved, latest)
        far = _beside(case, 2.0**-12 * (known["restitution"] ** 2 + known["piece_extent"]), random)
        assert not opens(name, far, latest)
    assert passed == 0


@pytest.mark.slow
def test_a_piece_whose_path_comes_into_the_ring_s_box_is_near_and_most_others_are_not() -> None:
    random = np.random.default_rng(13)
    outside, cleared = 0, 0
    wide = DEFAULTS["ring_radius"] + REACH
    for _ in range(trials(120, at_least=60)):
        place = random.normal(size=3) * [0.6, 0.6, 0.4]
        velocity = random.normal(size=3) * [4.0, 4.0, 4.0]
        known = begin(np.concatenate([place, velocity, random.normal(size=3) * 10.0]))
        latest = known["piece"] * random.uniform(0.1, 1.0)
        near = opens("ring", known, latest)
        path = path_of(known, latest, 65)
        inside = (np.abs(path) <= [wide, wide, REACH]).all(axis=1)
        assert near or not inside.any()
        outside += not inside.any()
        cleared += not near
    assert cleared >= 0.8 * outside > 20


def test_what_overflows_single_precision_or_is_no_number_is_near() -> None:
    random = np.random.default_rng(14)
    far = _beside("the ring's top", 100.0, random)
    assert not opens("ring", far, 2.0**-30)
    for name in ("piece_jerk", "piece_extent", "short_vz", "short_vz_1"):
        for value in (np.inf, np.nan):
            assert opens("ring", far | {name: value, "x": 0.0, "y": 0.0}, 2.0**-10)


def test_numbers_of_a_body_that_are_quotients_are_tested_in_double_precision() -> None:
    symbol = AIR.symbols[0]
    assert all(map(air_near.in_single, (*AIR.surfaces, END, _sphere(), _floor())))
    assert not air_near.in_single(Sphere("one", (0, 0, 0), 1 / (symbol - 1)))
    assert not air_near.in_single(Sphere("one", (sp.sqrt(symbol), 0, 0), symbol))
    assert not air_near.in_single(Sphere("one", (sum(symbol**k for k in range(20)), 0, 0), symbol))
    tested = air_near.near_box(Sphere("one", (0, 0, 0), 1 / symbol), AIR.flight)
    used = tested.free_symbols & set(DOUBLE_SERIES.velocities[0])
    assert used
