"""The derivation on two pages: its formulas are the derivation's, its shot is what is simulated."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.scenes import COURT, HOOP
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY

import hoopgen
from hoopgen.codegen.derivation.summary import (
    FREE_THROW,
    RING_HEIGHT,
    arrival,
    decimal,
    free_throw,
    moved,
    worked_shot,
)
from tests.helpers import ROOT

TEXT = (ROOT / "generated" / "summary.md").read_text(encoding="utf-8")
WHOLE = (ROOT / "generated" / "derivation.md").read_text(encoding="utf-8")


def displayed(text: str) -> list[str]:
    return re.findall(r"^\$\$\n(.*?)\n\$\$$", text, re.DOTALL | re.MULTILINE)


def rows(heading: str) -> list[list[str]]:
    """Return the cells of the table whose first heading is this."""
    table = TEXT[TEXT.index(f"| {heading} |") :].partition("\n\n")[0]
    return [[cell.strip() for cell in row.split("|")[1:-1]] for row in table.splitlines()[2:]]


def numbers(cell: str) -> list[float]:
    return [float(value) for value in cell.strip("()").split(",")]


def simulated() -> hoopgen.Shots:
    release = {name: float(value) for name, value in FREE_THROW.items()}
    state = hoopgen.release(
        release["speed"],
        np.radians(release["elevation"]),
        backspin=2 * np.pi * release["backspin"],
        height=release["height"],
        distance=release["distance"],
    )
    return hoopgen.simulate(state, hoopgen.PAPER, record=True)


def test_every_formula_of_it_is_the_derivation_s() -> None:
    """But for the shot's numbers; longer blocks are cut, none is written anew."""
    lines = set(re.findall(r"^.*&=.*$", WHOLE, re.M))
    for block in displayed(TEXT[: TEXT.index("## One shot")]):
        for line in re.findall(r"^.*&=.*$", block, re.M):
            same = {
                line,
                f"{line} \\\\",
                line.replace("e\\, v_n\\,", r"e\, (\mathbf{v} \cdot \mathbf{n})\,"),
            }
            same |= {f"{each} \\\\" for each in same}
            assert same & lines, line
        if "aligned" not in block:
            for part in re.split(r", \\qquad |,$", block):
                assert part.strip(" .,") in WHOLE, part


def test_the_worked_shot_is_what_hoopgen_simulates() -> None:
    shots = simulated()
    events = rows("time (s)")
    assert len(events) == len(shots.events)
    names = [*hoopgen.SURFACES, str(hoopgen.Outcome(int(shots.outcome[0])).name).lower()]
    for cells, event in zip(events, shots.events, strict=True):
        assert cells[0] == f"{event['time']:.4f}"
        assert cells[1] == names[event["surface"]]
        place, before = event["before"][:3], event["before"][3:6]
        for cell, exact in ((cells[2], place), (cells[3], before)):
            assert np.abs(np.array(numbers(cell)) - exact).max() <= 0.50001e-4
        if cells[4] != "–":
            assert np.abs(np.array(numbers(cells[4])) - event["after"][3:6]).max() <= 0.50001e-4


def test_its_release_is_the_one_of_the_library() -> None:
    state = free_throw()
    exact = [float(state[s]) for s in state]
    release = {name: float(value) for name, value in FREE_THROW.items()}
    own = hoopgen.release(
        release["speed"],
        np.radians(release["elevation"]),
        backspin=2 * np.pi * release["backspin"],
        height=release["height"],
        distance=release["distance"],
    )
    assert np.abs(np.asarray(exact) - np.ravel(own)).max() < 1e-14
    assert float(RING_HEIGHT) == 3.048


def test_a_root_is_a_time_at_which_the_ball_touches() -> None:
    ring = HOOP.surfaces[0]
    usual = {p.symbol: sp.Rational(repr(p.default)) for p in HOOP.parameters}
    known = {**usual, **free_throw()}
    found = arrival(ring, HOOP.flight, known, leaving=False)
    there = moved(HOOP.flight, known, found.time)
    assert abs(float(sp.sympify(ring.distance.subs(there)).evalf(30))) < 1e-15
    rate = sum(ring.distance.diff(place) * v for place, v in zip(POSITION, VELOCITY, strict=True))
    assert float(rate.subs(there).evalf(30)) < 0


def test_what_cannot_be_shown_on_two_pages_is_refused() -> None:
    with pytest.raises(ValueError, match=r"scene court: expected .* got backboard, bridge without"):
        worked_shot(COURT)


def test_numbers_are_never_minus_zero() -> None:
    assert [decimal(sp.Float(x)) for x in (-1e-9, 0.0, -0.12345)] == ["0.0000", "0.0000", "-0.1235"]
