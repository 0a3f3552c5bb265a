"""Units: what is read, in which unit a bare number is, and what is refused."""

from __future__ import annotations

import math

import pytest

from hoopgen.core.units import (
    FOOT,
    UNITS,
    Kind,
    column_name,
    display_unit,
    file_unit,
    parse_quantity,
    unit_symbol,
    use_units,
)


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


@pytest.mark.parametrize(
    ("text", "kind", "same"),
    [
        ("7 feet", "length", "7ft"),
        ("1 foot", "length", "1ft"),
        ("6 Feet 8 INCHES", "length", "6ft8in"),
        ("1 inch", "length", "1in"),
        ("6\u20328\u2033", "length", "6ft8in"),
        ("4.2 metres", "length", "4.2m"),
        ("4.2 meters", "length", "4.2m"),
        ("5 Centimeters", "length", "5cm"),
        ("25 kph", "speed", "25km/h"),
        ("25 KM/H", "speed", "25km/h"),
        ("25 km / h", "speed", "25km/h"),
        ("25 kilometres per hour", "speed", "25km/h"),
        ("700cm/s", "speed", "700 cm/s"),
        ("7 metres per second", "speed", "7m/s"),
        ("23 feet/second", "speed", "23ft/s"),
        ("16 MPH", "speed", "16mph"),
        ("16 miles per hour", "speed", "16mph"),
        ("52 degrees", "angle", "52deg"),
        ("1 Degree", "angle", "1deg"),
        ("0.9 radians", "angle", "0.9rad"),
        ("3 hertz", "spin", "3Hz"),
        ("3 HZ", "spin", "3Hz"),
        ("3 revolutions per second", "spin", "3rev/s"),
        ("3 turns/s", "spin", "3rev/s"),
        ("180 revolutions per minute", "spin", "180rpm"),
        ("180 RPM", "spin", "180rpm"),
        ("90\u00b0/s", "spin", "90deg/s"),
        ("90 degrees per second", "spin", "90deg/s"),
        ("19 radians per second", "spin", "19rad/s"),
        ("9.8 m/s\u00b2", "acceleration", "9.8m/s2"),
        ("9.8 metres per s^2", "acceleration", "9.8m/s2"),
    ],
)
def test_units_are_spelled_in_full_and_in_any_case(text: str, kind: Kind, same: str) -> None:
    assert parse_quantity(text, kind) == parse_quantity(same, kind)


@pytest.mark.parametrize(
    ("text", "kind", "said"),
    [
        ("52", "angle", "'52' has no unit: write 52deg or 52rad"),
        (" -0.9 ", "angle", "' -0.9 ' has no unit: write -0.9deg or -0.9rad"),
        ("3", "spin", "'3' has no unit: write 3Hz, 3rpm, 3rad/s or 3deg/s"),
    ],
)
def test_a_bare_angle_or_spin_is_refused_with_what_it_may_mean(
    text: str, kind: Kind, said: str
) -> None:
    with pytest.raises(ValueError, match=f"^{said}$"):
        parse_quantity(text, kind)


@pytest.mark.parametrize("text", ["0", "-0", "0.0"])
@pytest.mark.parametrize("kind", list(UNITS))
def test_nothing_needs_no_unit(kind: Kind, text: str) -> None:
    assert parse_quantity(text, kind) == 0.0


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("595 g", "mass", 0.595),
        ("0.624kg", "mass", 0.624),
        ("1.2 kg/m3", "density", 1.2),
        ("1.2 kg/m\u00b3", "density", 1.2),
        ("1.2 kg per m^3", "density", 1.2),
        ("0.624", "mass", 0.624),
        ("22oz", "mass", 0.62368950875),  # 16 oz are a pound, 0.45359237 kg by definition
        ("22 Ounces", "mass", 0.62368950875),
        ("1.375 lb", "mass", 0.62368950875),
        ("2 pounds", "mass", 0.90718474),
        ("0.075lb/ft3", "density", 0.075 * 0.45359237 / 0.028316846592),
        ("0.075 pounds per ft^3", "density", 0.075 * 0.45359237 / 0.028316846592),
        ("0.075 lb/ft\u00b3", "density", 0.075 * 0.45359237 / 0.028316846592),
    ],
)
def test_masses_and_densities_have_units(text: str, kind: Kind, value: float) -> None:
    assert parse_quantity(text, kind) == pytest.approx(value, rel=1e-15, abs=0)


def test_text_is_shown_in_other_units_as_long_as_is_asked() -> None:
    assert display_unit("length").symbol == "m"
    with use_units("us"):
        symbols = {kind: display_unit(kind).symbol for kind in UNITS}
        with use_units("si"):
            assert display_unit("speed").symbol == "m/s"
        assert display_unit("short").symbol == "in"
    assert symbols == {
        "length": "ft",
        "speed": "mph",
        "angle": "\u00b0",
        "spin": "Hz",
        "acceleration": "ft/s\u00b2",
        "mass": "oz",
        "density": "lb/ft\u00b3",
        "number": "",
    }
    assert display_unit("speed").symbol == "m/s"
    with (
        pytest.raises(ValueError, match="system: expected si or us, got 'metric'"),
        use_units("metric"),
    ):  # type: ignore[arg-type]
        pass


@pytest.mark.parametrize(
    ("name", "unit", "column"),
    [
        ("speed", "m/s", "speed_m_s"),
        ("gravity", "m/s\u00b2", "gravity_m_s2"),
        ("wy", "rad/s", "wy_rad_s"),
        ("backspin", "Hz", "backspin_hz"),
        ("air_density", "lb/ft\u00b3", "air_density_lb_ft3"),
        ("restitution", "", "restitution"),
        ("probability", "1", "probability"),
    ],
)
def test_columns_have_their_units_in_their_names(name: str, unit: str, column: str) -> None:
    assert column_name(name, unit) == column


@pytest.mark.parametrize("kind", [one for one in UNITS if one not in ("angle", "spin", "number")])
def test_us_units_are_no_si_units_in_text_or_files(kind: Kind) -> None:
    si = next(iter(UNITS[kind]))
    with use_units("us"):
        shown = display_unit(kind)
    unit, size = file_unit(si, "us")
    assert (size, size) == (shown.size, UNITS[kind][unit])
    assert unit == shown.symbol.replace("\u00b2", "2").replace("\u00b3", "3") != si
    assert unit_symbol(shown.size, kind) == unit


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
        ("7ft", "speed", "m/s, cm/s, ft/s, km/h, mph"),
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
