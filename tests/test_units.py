"""Units: what is read, in which unit a bare number is, and what is refused."""

from __future__ import annotations

import math

import pytest

from hoopgen.units import FOOT, UNITS, Kind, parse_quantity


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("2.5", "length", 2.5),
        ("13.75ft", "length", 13.75 * FOOT),
        ("13.75 ft", "length", 13.75 * FOOT),
        ("  7ft ", "length", 7 * FOOT),
        ("30in", "length", 30 * 0.0254),
        ("250cm", "length", 2.5),
        ("12.7mm", "length", 0.0127),
        ("-4m", "length", -4.0),
        ("+.5m", "length", 0.5),
        ("1e-3 m", "length", 0.001),
        ("7.17", "speed", 7.17),
        ("7.17m/s", "speed", 7.17),
        ("23.5ft/s", "speed", 23.5 * FOOT),
        ("36km/h", "speed", 10.0),
        ("16mph", "speed", 16 * 0.44704),
        ("51deg", "angle", math.radians(51)),
        ("51°", "angle", math.radians(51)),
        ("0.89rad", "angle", 0.89),
        ("3Hz", "spin", 6 * math.pi),
        ("3 rev/s", "spin", 6 * math.pi),
        ("-2rad/s", "spin", -2.0),
        ("360deg/s", "spin", 2 * math.pi),
        ("9.81", "acceleration", 9.81),
        ("9.81m/s2", "acceleration", 9.81),
        ("32.174ft/s^2", "acceleration", 32.174 * FOOT),
        ("0.75", "number", 0.75),
    ],
)
def test_a_quantity_is_its_number_times_its_unit(text: str, kind: Kind, value: float) -> None:
    assert parse_quantity(text, kind) == value


def test_180_rpm_is_3_hertz() -> None:
    # One rounding in 2 pi / 60 and one in the product.
    assert parse_quantity("180rpm", "spin") == pytest.approx(6 * math.pi, rel=2**-52, abs=0)


@pytest.mark.parametrize(
    ("text", "inches"),
    [("6ft8in", 80), ("6ft 2in", 74), ("6'2\"", 74), ("-1ft 6in", -18), ("6ft2.5in", 74.5)],
)
def test_lengths_may_have_parts_and_the_sign_holds_for_all(text: str, inches: float) -> None:
    # Two products and a sum, each rounded once.
    assert parse_quantity(text, "length") == pytest.approx(inches * 0.0254, rel=2**-51, abs=0)


def test_a_bare_number_is_si_unless_another_unit_is_asked_for() -> None:
    assert parse_quantity("0.5", "angle") == 0.5
    assert parse_quantity("51", "angle", bare="deg") == math.radians(51)
    assert parse_quantity("0.5rad", "angle", bare="deg") == 0.5


@pytest.mark.parametrize("kind", list(UNITS))
def test_the_first_unit_of_every_kind_is_the_si_one(kind: Kind) -> None:
    assert next(iter(UNITS[kind].values())) == 1.0


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("", "length"),
        (" ", "length"),
        ("ft", "length"),
        ("-", "length"),
        ("nan", "speed"),
        ("inf", "speed"),
        ("1__0", "number"),
        ("1,5m", "length"),
        ("2-1ft", "length"),
        ("--1", "length"),
        ("1.2.3", "number"),
        ("0x10", "number"),
        ("1+1", "number"),
        ("6 8", "length"),
        ("6ft 8", "length"),
        ("1deg 30deg", "angle"),
        ("__import__('os')", "number"),
        ("٣m", "length"),
    ],
)
def test_what_is_no_quantity_is_refused(text: str, kind: Kind) -> None:
    with pytest.raises(ValueError, match=r"is not a|has the unit"):
        parse_quantity(text, kind)


@pytest.mark.parametrize(
    ("text", "kind", "wanted"),
    [
        ("7ft", "speed", "m/s, ft/s, km/h, mph"),
        ("51ft", "angle", "rad, deg"),
        ("3Hz", "angle", "rad, deg"),
        ("5furlongs", "length", "m, cm, mm, ft, in"),
        ("0.75m", "number", "a plain number"),
    ],
)
def test_a_wrong_unit_is_named_with_the_right_ones(text: str, kind: Kind, wanted: str) -> None:
    with pytest.raises(ValueError, match=wanted) as refused:
        parse_quantity(text, kind)
    assert repr(text) in str(refused.value)


def test_a_number_too_large_for_a_double_is_refused() -> None:
    with pytest.raises(ValueError, match="too large"):
        parse_quantity("1e999 m", "length")
