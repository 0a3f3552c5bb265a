"""Releases: where the ball starts, where it is sent and how it turns."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import hoopgen
from hoopgen.engine.elementary import sine_cosine
from hoopgen.hoop.variables import ARGUMENTS
from tests.helpers.effort import trials

EPS = float(np.finfo(np.float64).eps)
SHOT = {"speed": 7.2, "elevation": 0.9, "height": 2.1, "distance": 4.2}
ANGLES = st.floats(-2 * math.pi, 2 * math.pi)
SPEEDS = st.floats(1e-3, 50.0)
SETTINGS = settings(max_examples=trials(50), deadline=None, derandomize=True)


def parts(state: NDArray[np.float64]) -> tuple[NDArray[np.float64], ...]:
    return state[..., :3], state[..., 3:6], state[..., 6:]


def about_z(angle: float) -> NDArray[np.float64]:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def test_straight_in_front_the_ball_goes_along_minus_x() -> None:
    state = hoopgen.release(**SHOT)
    assert state.shape == (9,)
    assert state.dtype == np.float64
    level, up = 7.2 * math.cos(0.9), 7.2 * math.sin(0.9)
    # Products of two rounded numbers; height is a difference.
    np.testing.assert_allclose(
        state, [4.2, 0, 2.1 - 3.048, -level, 0, up, 0, 0, 0], rtol=2 * EPS, atol=0
    )


def test_heights_are_above_the_floor_and_the_ring_is_at_10_feet() -> None:
    at_ring = hoopgen.release(**SHOT | {"height": 10 * 0.3048})
    assert abs(at_ring[2]) <= 2 * EPS


def test_backspin_of_a_shot_along_minus_x_is_positive_wy() -> None:
    spin = hoopgen.release(**SHOT, backspin=19.0)[6:]
    assert spin.tolist() == [0.0, 19.0, 0.0]
    assert hoopgen.release(**SHOT, backspin=-19.0)[7] == -19.0


def test_backspin_moves_the_top_of_the_ball_towards_the_shooter() -> None:
    _, velocity, spin = parts(hoopgen.release(**SHOT, backspin=19.0, azimuth=0.1, angle=0.7))
    top = np.cross(spin, [0, 0, 0.12])
    assert np.dot(top[:2], velocity[:2]) < 0
    assert abs(top[2]) <= EPS


def test_sidespin_is_about_the_vertical() -> None:
    assert hoopgen.release(**SHOT, sidespin=3.0)[6:].tolist() == [0.0, 0.0, 3.0]


@pytest.mark.parametrize(("azimuth", "side"), [(0.05, 1), (-0.05, -1), (1.5, 1)])
@pytest.mark.parametrize("angle", [0.0, 0.6, -1.3, 3.0])
def test_positive_azimuth_is_to_the_shooters_left(azimuth: float, side: int, angle: float) -> None:
    position, velocity, _ = parts(hoopgen.release(**SHOT, azimuth=azimuth, angle=angle))
    to_ring = np.array([-position[0], -position[1], 0.0])
    left = np.cross([0.0, 0.0, 1.0], to_ring)  # of one who faces the ring
    assert np.sign(np.dot(left, velocity)) == side


def test_in_front_of_the_ring_left_of_the_shooter_is_minus_y() -> None:
    assert hoopgen.release(**SHOT, azimuth=0.05)[4] < 0


def test_angle_goes_counter_clockwise_from_straight_in_front() -> None:
    for angle, place in ((0.0, (4.2, 0)), (math.pi / 2, (0, 4.2)), (-math.pi / 2, (0, -4.2))):
        state = hoopgen.release(**SHOT, angle=angle)
        np.testing.assert_allclose(state[:2], place, rtol=0, atol=4.2 * EPS)


@SETTINGS
@given(ANGLES, ANGLES, st.floats(-50, 50), st.floats(-50, 50))
def test_another_angle_turns_the_whole_picture_about_the_vertical(
    angle: float, azimuth: float, backspin: float, sidespin: float
) -> None:
    spins = {"azimuth": azimuth, "backspin": backspin, "sidespin": sidespin}
    turned = hoopgen.release(**SHOT, angle=angle, **spins)
    straight = hoopgen.release(**SHOT, **spins)
    # Cosines of sums against sums of products: errors of the angles, and a few roundings.
    for got, wanted in zip(parts(turned), parts(straight), strict=True):
        limit = (8 + abs(angle) + abs(azimuth)) * EPS * np.linalg.norm(wanted)
        assert np.all(np.abs(got - about_z(angle) @ wanted) <= limit)


@SETTINGS
@given(SPEEDS, st.floats(-math.pi / 2, math.pi / 2), ANGLES, ANGLES)
def test_speed_and_elevation_are_those_asked_for(
    speed: float, elevation: float, azimuth: float, angle: float
) -> None:
    shot = SHOT | {"speed": speed, "elevation": elevation}
    position, velocity, _ = parts(hoopgen.release(**shot, azimuth=azimuth, angle=angle))
    assert abs(np.linalg.norm(velocity) - speed) <= 4 * EPS * speed
    # Both sines are within one unit in the last place, and both products are rounded.
    rising = speed * np.sin(elevation)
    assert abs(velocity[2] - rising) <= 3 * EPS * abs(rising)
    assert abs(np.hypot(*position[:2]) - 4.2) <= 4 * EPS * 4.2


@SETTINGS
@given(SPEEDS, st.floats(0.1, 1.5), st.floats(-0.5, 0.5), ANGLES)
def test_azimuth_0_aims_at_the_axis_and_others_miss_it_by_their_sine(
    speed: float, elevation: float, azimuth: float, angle: float
) -> None:
    shot = SHOT | {"speed": speed, "elevation": elevation}
    x, y, _, vx, vy, *_ = hoopgen.release(**shot, azimuth=azimuth, angle=angle)
    passes = (x * vy - y * vx) / np.hypot(vx, vy)
    # The moment of the velocity about the axis; the turn to the left is clockwise about it.
    assert abs(abs(passes) - 4.2 * abs(math.sin(azimuth))) <= (8 + 2 * abs(angle)) * EPS * 4.2


def test_arguments_broadcast_to_their_common_shape() -> None:
    speeds = np.linspace(6, 8, 5)[:, None, None]
    elevations = np.linspace(0.7, 1.0, 4)[:, None]
    angles = np.array([0.0, 0.5, 1.0])
    states = hoopgen.release(speeds, elevations, height=2.1, distance=4.2, angle=angles)
    assert states.shape == (5, 4, 3, 9)
    for i, j, k in np.ndindex(5, 4, 3):
        one = hoopgen.release(
            speeds[i, 0, 0], elevations[j, 0], height=2.1, distance=4.2, angle=angles[k]
        )
        np.testing.assert_array_equal(states[i, j, k], one)


def test_lists_integers_and_empty_arrays_are_fine() -> None:
    states = hoopgen.release([7, 8], 1, height=2, distance=4, angle=0)
    np.testing.assert_array_equal(states[0], hoopgen.release(7.0, 1.0, height=2.0, distance=4.0))
    assert hoopgen.release([], 0.9, height=2.1, distance=4.2).shape == (0, 9)


def test_no_negative_zeros_are_printed() -> None:
    assert not np.any(np.signbit(hoopgen.release(**SHOT)) & (hoopgen.release(**SHOT) == 0))


def test_the_result_is_new_and_writable() -> None:
    speed = np.array([7.0, 7.1])
    states = hoopgen.release(speed, 0.9, height=2.1, distance=4.2)
    states[:] = 0.0
    assert speed.tolist() == [7.0, 7.1]


def test_a_release_flies_as_it_is() -> None:
    states = hoopgen.release([7.1, 7.2], 0.9, height=2.1, distance=4.2)
    assert len(hoopgen.simulate(states)) == 2
    assert len(hoopgen.simulate(states[0])) == 1


@pytest.mark.parametrize("name", ["speed", "elevation", "azimuth", "backspin", "height", "angle"])
@pytest.mark.parametrize("value", ["fast", object(), [1.0, "a"]])
def test_what_is_no_number_is_an_error_that_names_the_argument(name: str, value: object) -> None:
    with pytest.raises(TypeError, match=f"^{name}: expected numbers, got"):
        hoopgen.release(**SHOT | {name: value})


def test_a_complex_number_is_a_type_error() -> None:
    with pytest.raises(TypeError, match=r"^speed: expected numbers"):
        hoopgen.release(**SHOT | {"speed": np.array(7 + 1j)})


def test_shapes_that_do_not_broadcast_are_an_error_that_lists_them() -> None:
    with pytest.raises(ValueError, match=r"^release: the shapes do not broadcast") as error:
        hoopgen.release([7.0, 7.1], [0.8, 0.9, 1.0], height=2.1, distance=[4.2] * 2)
    for part in ("speed (2,)", "elevation (3,)", "distance (2,)"):
        assert part in str(error.value)
    assert "height" not in str(error.value)


@pytest.mark.parametrize("missing", ["speed", "elevation", "height", "distance"])
def test_what_has_no_usual_value_must_be_given(missing: str) -> None:
    given = {name: value for name, value in SHOT.items() if name != missing}
    with pytest.raises(TypeError, match=missing):
        hoopgen.release(**given)


def test_the_generated_formula_has_the_bits_of_the_one_written_out() -> None:
    """Sums and products in the order of `hoopgen.release`, here in NumPy by hand."""
    random, n = np.random.default_rng(11), trials(20_000)
    speed, distance = random.uniform(0, 15, n), random.uniform(0, 12, n)
    elevation, azimuth, angle = random.uniform(-6, 6, (3, n))
    backspin, sidespin = random.normal(0, 30, (2, n))
    height = random.uniform(0, 4, n)
    (left, front), (aside, before) = sine_cosine(angle), sine_cosine(azimuth + angle)
    rise, flat = sine_cosine(elevation)
    level = speed * flat
    expected = [distance * front, distance * left, height - 3.048]
    expected += [level * -before, level * -aside, speed * rise]
    expected += [backspin * -aside, backspin * before, sidespin]
    found = hoopgen.release(
        *(speed, elevation, azimuth, backspin, sidespin),
        height=height,
        distance=distance,
        angle=angle,
    )
    assert (found == np.stack(expected, axis=-1)).all()


@pytest.mark.parametrize(
    "name",
    ["speed", "elevation", "azimuth", "backspin", "sidespin", "height", "distance", "angle"],
)
def test_the_jacobian_is_what_differences_of_releases_approach(name: str) -> None:
    given = SHOT | {"azimuth": 0.2, "angle": -0.7, "backspin": 19.0, "sidespin": 3.0}
    _, jacobian = hoopgen.release(**given, jacobian=True)
    step = 1e-5
    ends = [hoopgen.release(**given | {name: given[name] + way * step}) for way in (1, -1)]
    column = jacobian["state"][:, list(ARGUMENTS).index(name)]
    # Third derivatives are at most 20, and a difference loses 2 roundings of numbers up to 20.
    error = 20 * step**2 + 40 * EPS / step
    np.testing.assert_allclose(column, (ends[0] - ends[1]) / (2 * step), rtol=0, atol=error)
