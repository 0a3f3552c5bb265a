"""Places on the board and the ring have names, from their sizes alone."""

from __future__ import annotations

import numpy as np
import pytest

import hoopgen
from hoopgen.core.units import INCH, use_units
from hoopgen.hoop.places import on_board, on_ring, say_on_board, say_on_ring

BOARD = on_board(hoopgen.NBA)
CORNER = BOARD["top right corner of the square"]


@pytest.mark.parametrize("name", BOARD)
def test_a_place_is_said_by_its_own_name(name: str) -> None:
    assert say_on_board(*BOARD[name], hoopgen.NBA) == f"the {name}"
    assert say_on_board(BOARD[name][0] + 0.004, BOARD[name][1], hoopgen.NBA) == f"the {name}"


def test_beside_a_place_it_is_said_how_far_and_where() -> None:
    y, z = CORNER
    there = "top right corner of the square"
    assert say_on_board(y, z + 0.05, hoopgen.NBA) == f"5 cm above the {there}"
    assert say_on_board(y - 0.03, z - 0.05, hoopgen.NBA) == (
        f"5 cm below and 3 cm left of the {there}"
    )
    with use_units("us"):
        assert say_on_board(y + 2 * INCH, z, hoopgen.NBA) == f"2 in right of the {there}"


def test_left_and_right_are_the_shooters_and_mirror_one_another() -> None:
    for y in np.linspace(0.01, 0.9, 9):
        right, left = (say_on_board(side * y, 0.5, hoopgen.NBA) for side in (1, -1))
        swapped = right.replace("left", "L").replace("right", "left").replace("L", "right")
        assert left == swapped


def test_an_aim_is_said_from_the_rim_or_the_centre() -> None:
    radius = hoopgen.NBA["ring_radius"]
    assert on_ring(hoopgen.NBA)["front of the rim"] == -radius
    assert say_on_ring(0.0, hoopgen.NBA) == "the centre of the ring"
    assert say_on_ring(-radius, hoopgen.NBA) == "the front of the rim"
    assert say_on_ring(radius - 0.03, hoopgen.NBA) == "3 cm short of the back of the rim"
    assert say_on_ring(0.05, hoopgen.NBA) == "5 cm past the centre of the ring"
