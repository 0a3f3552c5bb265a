"""Boxes that a flight cannot come near: told by what is round about them, and asked no further."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import court

import hoopgen
from hoopgen import COURT, PAPER_COURT
from tests.helpers.effort import occurrences, trials

SIZES = {f"p_{name}": value for name, value in PAPER_COURT.items()}

Corners = tuple[list[float], list[float]]


def plates() -> dict[str, Corners]:
    """Return the corners of board and bridge."""
    size = PAPER_COURT
    front, wide, narrow = (
        -size["board_distance"],
        size["board_half_width"],
        size["bridge_half_width"],
    )
    top = size["wire_radius"]
    return {
        "backboard": (
            [front - size["board_thickness"], -wide, size["board_bottom"]],
            [front, wide, size["board_top"]],
        ),
        "bridge": (
            [front, -narrow, top - size["bridge_depth"]],
            [-size["ring_radius"], narrow, top],
        ),
    }


def called(name: str, known: dict[str, Any]) -> dict[str, Any]:
    """Return the outputs of a kernel by name."""
    found = getattr(court, name)(*(known[argument] for argument in court.ARGUMENTS[name]))
    return dict(zip(court.OUTPUTS[name], found, strict=True))


def flight(rng: np.random.Generator, low: list[float], high: list[float]) -> dict[str, Any]:
    """Return a flight that begins about a corner of a plate, and what bounds its errors."""
    place = np.where(rng.integers(0, 2, 3), low, high) + rng.normal(0, 0.15, 3)
    velocity = rng.normal(0, 1, 3) * 10 ** rng.uniform(-3, 0.5)
    errors = 10 ** rng.uniform(-16, -4, 2) * rng.integers(0, 2, 2)
    return SIZES | {
        **dict(zip("xyz", place, strict=True)),
        **dict(zip(("vx", "vy", "vz"), velocity, strict=True)),
        "horizon": 10 ** rng.uniform(-4, -0.5),
        "extent": np.abs(place).sum(),
        "speed": np.abs(velocity).sum(),
        "position_error": errors[0],
        "velocity_error": errors[1],
        "pad": 1e-3,
        "earliest_delay": 0.0,
    }


def nearest(known: dict[str, Any], low: list[float], high: list[float]) -> Fraction:
    """Return the least squared distance from a plate that the true ball may have, exactly."""
    exact = {name: Fraction(float(value)) for name, value in known.items() if np.isfinite(value)}
    squares = []
    for k in range(33):
        time = exact["horizon"] * k / 32
        off = exact["position_error"] + exact["velocity_error"] * time
        square = Fraction(0)
        for axis, least, most in zip("xyz", low, high, strict=True):
            there = exact[axis] + exact[f"v{axis}"] * time
            there -= exact["p_gravity"] * time**2 / 2 if axis == "z" else 0
            away = max(Fraction(least) - there, there - Fraction(most), Fraction(0))
            square += max(away - off, Fraction(0)) ** 2
        squares.append(square)
    return min(squares)


@pytest.mark.sampled(1)
@pytest.mark.parametrize("plate", ["backboard", "bridge"])
def test_a_plate_that_is_called_far_is_not_within_reach(plate: str) -> None:
    """Flights are exact; some are far around an edge alone, or over it alone."""
    low, high = plates()[plate]
    rng = np.random.default_rng(7)
    radius = Fraction(PAPER_COURT["ball_radius"])
    far = around = 0
    for _ in range(trials(600)):
        known = flight(rng, low, high)
        known |= called("half_flight_boxes", known)
        if called(f"{plate}_near", known)["near"]:
            continue
        far += 1
        assert nearest(known, low, high) > radius**2
        times = np.linspace(0, known["horizon"], 33)[:, None]
        path = [known[a] for a in "xyz"] + np.array([known[f"v{a}"] for a in "xyz"]) * times
        path[:, 2] -= known["p_gravity"] * times[:, 0] ** 2 / 2
        between = np.maximum(np.subtract(low, path.max(axis=0)), path.min(axis=0) - high)
        around += bool(np.all(between < float(radius)))
    assert occurrences(100) < far < trials(600) - occurrences(100)
    # Of a plate only the planes of its faces count.
    assert around > occurrences(10) or plate == "backboard"


def test_where_an_arrival_may_be_late_every_plate_is_near() -> None:
    known = flight(np.random.default_rng(1), *plates()["bridge"]) | {
        "pad": 0.0,
        "earliest_delay": 1e-9,
    }
    known |= called("half_flight_boxes", known)
    assert called("bridge_near", known)["near"]
    assert called("backboard_near", known)["near"]


def counted(patch: pytest.MonkeyPatch, name: str) -> list[int]:
    """Return a list that grows by one with each evaluation of a kernel in NumPy."""
    kernel, calls = getattr(court, name), []

    def wrapped(*given: Any) -> Any:
        calls.append(1)
        return kernel(*given)

    patch.setattr(court, name, wrapped)
    patch.setattr(court, "ALONE", 0)  # few shots go through functions of their own
    return calls


def in_the_groove(speed: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return a ball that leaves the board at a speed, a tenth of a microsecond above the ring."""
    size = PAPER_COURT
    x, y = size["ball_radius"] - size["board_distance"], 0.22
    reach = size["ball_radius"] + size["wire_radius"]
    z = np.sqrt(reach**2 - (np.hypot(x, y) - size["ring_radius"]) ** 2) + 3e-8
    return np.array([x, y, z, speed, 0, -0.3, 0, 0, 0])


def test_a_search_that_cannot_step_allows_for_smaller_errors(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A ball that hardly leaves the board: with errors of a usual size it may still be on it."""
    calls = counted(monkeypatch, "backboard_advance")
    speeds = (3e-9, 1e-9, 3e-10)
    for speed in speeds:
        shot = hoopgen.simulate(
            in_the_groove(speed),
            PAPER_COURT,
            scene=COURT,
            leaving=COURT.surfaces.index("backboard"),
            backend="numpy",
            max_contacts=1,
        )
        assert shot.first[0] == COURT.surfaces.index("ring")
    assert len(speeds) < len(calls) < 10 * len(speeds)


def test_plates_that_a_flight_misses_are_not_searched(monkeypatch: pytest.MonkeyPatch) -> None:
    """A ball that drops through the ring from the front."""
    calls = [counted(monkeypatch, f"{plate}_prepare") for plate in plates()]
    made = hoopgen.simulate(
        [0.1, 0, 0.5, -0.1, 0, 0, 0, 0, 0], PAPER_COURT, scene=COURT, backend="numpy"
    )
    assert made.made[0]
    assert calls == [[], []]
