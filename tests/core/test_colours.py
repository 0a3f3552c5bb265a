"""Colours of shots stay apart for readers with any colour vision, as areas and as lines."""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import numpy as np
import pytest

from hoopgen.core.colours import BODY_COLOURS, COLOURS, OTHER_OUTCOME_COLOURS, outcome_colours
from hoopgen.viewer.palette import contrast
from tests.helpers import ROOT

# sRGB to CIE XYZ, D65 (IEC 61966-2-1).
_XYZ = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
)

# What dichromats see, in linear sRGB: Machado, Oliveira and Fernandes 2009, *A physiologically-
# based model for simulation of color vision deficiency*, IEEE TVCG 15(6), severity 1.0.
_SEEN = {
    "any": np.eye(3),
    "protanopia": np.array(
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ]
    ),
    "deuteranopia": np.array(
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ]
    ),
    "tritanopia": np.array(
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ]
    ),
    "grey": np.tile(_XYZ[1], (3, 1)),
}

_APART = 10.0
"""CIEDE2000: some ten times the least difference that is seen where areas touch."""

_LIGHTER = 2.9
"""L*, of neighbours among made and missed in grey: few enough tones that not more have room."""


def lab(colour: str, seen: str = "any") -> np.ndarray:
    """Return CIE L*a*b* of a colour as it is seen."""
    encoded = np.array([int(colour[at : at + 2], 16) for at in (1, 3, 5)]) / 255.0
    linear = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    light = _XYZ @ np.clip(_SEEN[seen] @ linear, 0.0, 1.0) / _XYZ.sum(axis=1)
    x, y, z = np.where(light > (6 / 29) ** 3, np.cbrt(light), light / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def ciede2000(one: Iterable[float], other: Iterable[float]) -> float:
    """Return the difference of two colours in L*a*b*: CIE 142-2001, as Sharma et al. write it."""
    (l_1, a_1, b_1), (l_2, a_2, b_2) = one, other
    mean = (np.hypot(a_1, b_1) + np.hypot(a_2, b_2)) / 2
    more = 1 + (1 - np.sqrt(mean**7 / (mean**7 + 25.0**7))) / 2
    c_1, c_2 = np.hypot(more * a_1, b_1), np.hypot(more * a_2, b_2)
    h_1, h_2 = (np.degrees(np.arctan2(b, more * a)) % 360 for a, b in ((a_1, b_1), (a_2, b_2)))
    turn = (h_2 - h_1 + 180) % 360 - 180 if c_1 * c_2 else 0.0
    hue = h_1 + turn / 2 if c_1 * c_2 else h_1 + h_2
    light, chroma = (l_1 + l_2) / 2, (c_1 + c_2) / 2
    wave = (
        1
        - 0.17 * np.cos(np.radians(hue - 30))
        + 0.24 * np.cos(np.radians(2 * hue))
        + 0.32 * np.cos(np.radians(3 * hue + 6))
        - 0.20 * np.cos(np.radians(4 * hue - 63))
    )
    lighter = (l_2 - l_1) / (1 + 0.015 * (light - 50) ** 2 / np.sqrt(20 + (light - 50) ** 2))
    fuller = (c_2 - c_1) / (1 + 0.045 * chroma)
    turned = 2 * np.sqrt(c_1 * c_2) * np.sin(np.radians(turn / 2)) / (1 + 0.015 * chroma * wave)
    blue = 60 * np.exp(-((((hue % 360) - 275) / 25) ** 2))
    mixed = -2 * np.sqrt(chroma**7 / (chroma**7 + 25.0**7)) * np.sin(np.radians(blue))
    return float(np.sqrt(lighter**2 + fuller**2 + turned**2 + mixed * fuller * turned))


def nearest(colours: Iterable[str], seen: str) -> tuple[float, str, str]:
    """Return how far apart the two colours are that are most alike, and which these are."""
    points = {colour: lab(colour, seen) for colour in colours}
    pairs = itertools.combinations(points, 2)
    return min((ciede2000(points[a], points[b]), a, b) for a, b in pairs)


def of_the_hoop() -> list[str]:
    """All that can stand beside one another in a picture of shots at a hoop, and paper."""
    pytest.importorskip("matplotlib")
    from hoopgen.plots.class_legend import CLASSES

    return [*(one.colour for one in CLASSES), COLOURS["paper"]]


def of_paths() -> list[str]:
    """All that paths at a hoop can be drawn in, and paper; an invalid shot has none."""
    pytest.importorskip("matplotlib")
    from hoopgen.plots.class_legend import CLASSES

    lines = [one.line for one in CLASSES if one.outcome != "invalid"]
    return [*lines, COLOURS["paper"]]


def of_scenes() -> list[str]:
    """The same of any other scene, of up to six ends."""
    names = [f"end {number}" for number in range(6)]
    return [
        *outcome_colours([*names, *map(str.upper, OTHER_OUTCOME_COLOURS)], len(names)).values(),
        COLOURS["paper"],
    ]


def of_bodies() -> list[str]:
    """The bodies of any other scene, with a board among them."""
    return [*BODY_COLOURS, COLOURS["backboard"], COLOURS["paper"]]


def test_white_numbers_are_legible_on_bodies() -> None:
    for colour in (*BODY_COLOURS, COLOURS["ring"], COLOURS["backboard"]):
        assert contrast(colour, COLOURS["paper"]) >= 3.0  # bold marks: WCAG 2.2, 1.4.11


@pytest.mark.parametrize("seen", ["any", "protanopia", "deuteranopia", "tritanopia"])
@pytest.mark.parametrize("colours", [of_the_hoop, of_paths, of_scenes, of_bodies])
def test_what_stands_beside_one_another_is_told_apart_with_any_colour_vision(
    colours: object, seen: str
) -> None:
    assert callable(colours)
    there = colours()
    assert len(set(there)) == len(there)
    assert nearest(there, seen)[0] > _APART, nearest(there, seen)


def test_made_and_missed_are_told_apart_in_grey() -> None:
    pytest.importorskip("matplotlib")
    from hoopgen.plots.style import MADE, MISSED

    others = [OTHER_OUTCOME_COLOURS["capped"], OTHER_OUTCOME_COLOURS["short"], COLOURS["paper"]]
    there = [lab(colour, "grey")[0] for colour in (*MADE.values(), *MISSED.values(), *others)]
    assert np.diff(np.sort(there)).min() > _LIGHTER
    made, missed = ([lab(one, "grey")[0] for one in kind.values()] for kind in (MADE, MISSED))
    assert np.diff(np.sort(made)).min() > 3 * _LIGHTER
    assert max(made) + 2 * _LIGHTER < min(missed), "a made shot is darker than any missed one"


def on_a_dark_page(colour: str) -> str:
    """Return a colour of a picture as the site shows it by night: see docs/_static/site.css."""
    # invert(1), then hue-rotate(180deg): the matrix of the Filter Effects module, 9.6.
    turn = np.array([[-0.574, 1.430, 0.144], [0.426, 0.430, 0.144], [0.426, 1.430, -0.856]])
    parts = 255 - np.array([int(colour[at : at + 2], 16) for at in (1, 3, 5)])
    return "#" + "".join(f"{round(part):02X}" for part in np.clip(turn @ parts, 0, 255))


@pytest.mark.parametrize("colours", [of_paths, of_scenes, of_bodies])
def test_lines_stand_out_from_paper_by_day_and_by_night(colours: object) -> None:
    assert callable(colours)
    drawn = set(colours()) - {COLOURS["paper"], OTHER_OUTCOME_COLOURS["invalid"]}
    named = ("path", "ring", "backboard", "bridge", "end", "release", "faint")
    edges = ("ball-edge", "plain-ball-edge")
    for colour in sorted(drawn | {COLOURS[name] for name in (*named, *edges)}):
        assert contrast(colour, COLOURS["paper"]) >= 3.0, colour
        assert contrast(on_a_dark_page(colour), "#131416") >= 3.0, colour
    assert on_a_dark_page(COLOURS["paper"]) == "#000000"
    style = (ROOT / "docs" / "_static" / "site.css").read_text(encoding="utf-8")
    assert style.count("filter: invert(1) hue-rotate(180deg);") == 2  # chosen, and as the system is


def test_lines_to_places_on_the_floor_stand_out_too() -> None:
    pytest.importorskip("matplotlib")
    from matplotlib import colormaps
    from matplotlib.colors import to_hex

    from hoopgen.plots.aim_points import _COLOUR_MAP, _COLOUR_MAP_END

    for share in np.linspace(0.0, _COLOUR_MAP_END, 30):
        colour = to_hex(colormaps[_COLOUR_MAP](share)).upper()
        assert contrast(colour, COLOURS["paper"]) >= 3.0
        assert contrast(on_a_dark_page(colour), "#131416") >= 3.0


def test_paths_of_made_shots_are_darker_than_those_of_missed_ones() -> None:
    pytest.importorskip("matplotlib")
    from hoopgen.plots.style import LINES

    made, missed = ([lab(one, "grey")[0] for one in of.values()] for of in LINES.values())
    assert max(made) + 2 * _LIGHTER < min(missed)


def test_an_outcome_has_one_colour_in_every_scene() -> None:
    pytest.importorskip("matplotlib")
    from hoopgen.plots.class_legend import CLASSES

    own = outcome_colours(["goal", *map(str.upper, OTHER_OUTCOME_COLOURS)], 1)
    for one in CLASSES:
        if not one.kind:
            assert own[one.outcome.upper()] == one.colour


def test_the_transform_to_lab_is_right() -> None:
    # sRGB's primaries in CIE L*a*b* under D65, as published (B. Lindbloom, to 0.1).
    for colour, wanted in (
        ("#FF0000", (53.2, 80.1, 67.2)),
        ("#00FF00", (87.7, -86.2, 83.2)),
        ("#0000FF", (32.3, 79.2, -107.9)),
        ("#FFFFFF", (100.0, 0.0, 0.0)),
    ):
        np.testing.assert_allclose(lab(colour), wanted, rtol=0, atol=0.1)


def test_the_difference_is_that_of_the_published_pairs() -> None:
    # Sharma, Wu and Dalal 2005, *The CIEDE2000 color-difference formula*, Table 1: pairs 1, 7, 9,
    # 14, 17 and 25, which reach every branch, to the four decimals printed.
    for one, other, wanted in (
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, 0.0, 0.0), (50.0, -1.0, 2.0), 2.3669),
        ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0009), 7.1792),
        ((50.0, -0.001, 2.49), (50.0, 0.0011, -2.49), 4.7461),
        ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
        ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
    ):
        assert ciede2000(one, other) == pytest.approx(wanted, rel=0, abs=5e-5)
