"""Starts beside all surfaces, of which nothing more is asked."""

from __future__ import annotations

from dataclasses import replace
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import pytest
from hoopgen.derive.scenes import HOOP, validity
from hoopgen.generated.numpy import court, hoop

from hoopgen import PAPER, PAPER_COURT
from hoopgen.scene import Parameter, Plane, Scene
from tests.helpers.effort import trials

ROWS = trials(100_000)
TOUCHING = 2_000


def evaluate(module: ModuleType, kernel: str, given: dict[str, Any]) -> tuple[Any, ...]:
    """Return what a kernel makes of what is given, by the names of its arguments."""
    arguments = module.ARGUMENTS[kernel]
    found: tuple[Any, ...] = getattr(module, kernel)(*(given[name] for name in arguments))
    return found


def asked(module: ModuleType, given: dict[str, Any]) -> tuple[Any, Any, Any]:
    """Return where a start is near, and what `valid` says of it."""
    near, valid, uncertain = evaluate(module, "aside", given)
    assert (valid, uncertain) == (1.0, 0.0)
    whether, unsure = evaluate(module, "valid", given)
    return near, whether, unsure


def starts(sizes: dict[str, float], seed: int) -> dict[str, Any]:
    """Return starts all around the hoop, and within some roundings of where `near` changes."""
    rng = np.random.default_rng(seed)
    reach = sizes["ball_radius"] + sizes["wire_radius"]
    edges = [
        sizes["ring_radius"] + reach,
        sizes["ball_radius"] - sizes["board_distance"],
        -sizes["board_distance"] - sizes["ball_radius"],
        -sizes["ring_radius"] - reach,
        0.0,
    ]
    x = rng.uniform(-1.5, 1.5, ROWS)
    steps = rng.integers(-200, 200, ROWS) * 2.0**-53
    x[::2] = rng.choice(edges, ROWS)[::2] + steps[::2]
    y, z = rng.uniform(-1, 1, (2, ROWS))
    y[::3], z[::3] = steps[::3], steps[1::3].repeat(2)[: len(z[::3])]
    return {"x": x, "y": y, "z": z, "last": np.full(ROWS, -1.0)}


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(("module", "usual"), [(hoop, PAPER), (court, PAPER_COURT)])
def test_who_is_beside_all_surfaces_is_outside_and_that_is_sure(
    module: ModuleType, usual: Any, seed: int
) -> None:
    sizes = {name: float(value) for name, value in usual.items()}
    given = starts(sizes, seed) | {f"p_{name}": value for name, value in sizes.items()}
    near, valid, uncertain = asked(module, given)
    assert np.all(valid[~near] == 1.0)
    assert np.all(uncertain[~near] == 0.0)
    assert near.any()
    assert not near.all()
    assert np.any(valid[near] == 0.0)


def on_the_ring(sizes: dict[str, float]) -> dict[str, Any]:
    """Return starts within a few roundings of touching the ring, in front."""
    rng = np.random.default_rng(5)
    azimuth, climb = rng.uniform(-1.2, 1.2, TOUCHING), rng.uniform(0, 2 * np.pi, TOUCHING)
    reach = sizes["ball_radius"] + sizes["wire_radius"]
    across = sizes["ring_radius"] + reach * np.cos(climb)
    place = np.array([across * np.cos(azimuth), across * np.sin(azimuth), reach * np.sin(climb)])
    return dict(zip("xyz", place + rng.integers(-2, 3, place.shape) * 2.0**-54, strict=True))


def test_a_start_at_the_ring_is_undecided_or_what_more_digits_say() -> None:
    sizes = {name: float(value) for name, value in PAPER_COURT.items()}
    given = on_the_ring(sizes) | {"last": np.full(TOUCHING, -1.0)}
    given |= {f"p_{name}": value for name, value in sizes.items()}
    valid, uncertain = evaluate(court, "valid", given)
    with mpmath.workdps(50):
        outside = []
        for x, y, z in zip(given["x"], given["y"], given["z"], strict=True):
            across = mpmath.hypot(mpmath.mpf(x), mpmath.mpf(y)) - mpmath.mpf(sizes["ring_radius"])
            reach = mpmath.mpf(sizes["ball_radius"]) + mpmath.mpf(sizes["wire_radius"])
            outside.append(mpmath.hypot(across, mpmath.mpf(z)) >= reach)
    computed = np.broadcast_to(valid, TOUCHING) == 1.0
    assert np.all((computed == outside) | (np.broadcast_to(uncertain, TOUCHING) > 0.0))
    assert np.any(computed != outside)  # else the starts are too far from the ring


def test_what_is_no_number_is_near() -> None:
    given = {f"p_{name}": float(value) for name, value in PAPER.items()}
    for bad in (np.nan, np.inf, -np.inf):
        for name in "xyz":
            where = {"x": 4.0, "y": 0.0, "z": 0.0, "last": -1.0} | {name: bad}
            near, *_ = asked(hoop, given | where)
            assert near


def test_it_is_asked_along_an_axis_on_which_each_surface_has_an_end() -> None:
    floor, wall = Plane("floor", at=-1), Plane("wall", axis="x", at=-1)
    sizes = [Parameter("ball", 0.1), Parameter("g", 9.8), Parameter("e", 0.5)]
    one = Scene(
        "room",
        parameters=sizes,
        bodies=[floor],
        ends={},
        ball_radius="ball",
        gravity="g",
        restitution="e",
    )
    assert set(validity.near_surface(HOOP)) == {"close", "valid", "undecided_time"}
    assert set(validity.near_surface(one.derive())) == {"close", "valid", "undecided_time"}
    assert not validity.near_surface(replace(one, bodies=[floor, wall]).derive())
