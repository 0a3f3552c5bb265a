"""Random numbers by counter, variables, and the models that release shots."""

from __future__ import annotations

import itertools
import math
import pickle
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import Grid, Resample, Scatter
from hoopgen.core.variables import STATE, Releases
from hoopgen.engine.elementary import normal_quantile
from hoopgen.hoop.variables import VARIABLES, resolve_variables
from hoopgen.study.models import random as random_module
from hoopgen.study.models.release_model import ReleaseModel

EPS = float(np.finfo(np.float64).eps)
DEGREE = math.pi / 180
RING = 3.048

FREE_THROW = {"speed": 7.17, "elevation": 52 * DEGREE, "height": 2.13, "distance": 4.19}
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": DEGREE, "restitution": 0.01}
CORRELATION = {("speed", "elevation"): -0.6, ("restitution", "speed"): 0.3}
PLAYER = Scatter(FREE_THROW, SD, CORRELATION)

MEASURED = Resample(
    {
        "speed": [7.1, 7.2, 7.3],
        "elevation": [0.9, 0.92, 0.88],
        "backspin": 19.0,
        "height": 2.1,
        "distance": [4.1, 4.2, 4.3],
        "restitution": [0.7, 0.6, 0.65],
    }
)
LATTICE = Grid(
    {"speed": [7.0, 7.1, 7.2], "restitution": [0.6, 0.7], "angle": [0.0, 0.5, 1.0, 1.5]},
    {"elevation": 0.9, "height": 2.1, "distance": 4.2},
)
MODELS = {"scatter": PLAYER, "resample": MEASURED, "grid": LATTICE}


def same(a: Releases, b: Releases) -> bool:
    """Compare every bit of shots."""
    n = len(a)

    def bits(releases: Releases) -> list[bytes]:
        arrays = [*releases.parameters.values(), *releases.columns.values()]
        full = [np.broadcast_to(np.asarray(array, float), (n,)) for array in arrays]
        return [array.tobytes() for array in (releases.states, *full)]

    names = [(*releases.parameters, *releases.columns) for releases in (a, b)]
    return len(b) == n and names[0] == names[1] and bits(a) == bits(b)


def rows(releases: Releases, some: slice) -> Releases:
    """Give some of the shots."""
    return Releases(
        releases.states[some],
        {n: v[some] if np.ndim(v) else v for n, v in releases.parameters.items()},
        {n: v[some] for n, v in releases.columns.items()},
    )


# Random numbers


def philox(counter: int, key: int) -> list[int]:
    """Philox4x64-10 as Salmon et al. 2011 define it."""
    whole = 2**64
    c = [counter >> 64 * place & whole - 1 for place in range(4)]
    k = [key & whole - 1, key >> 64]
    for _ in range(10):
        high_0, low_0 = divmod(0xD2E7470EE14C6C93 * c[0], whole)
        high_1, low_1 = divmod(0xCA5A826395121157 * c[2], whole)
        c = [high_1 ^ c[1] ^ k[0], low_1, high_0 ^ c[3] ^ k[1], low_0]
        k = [(k[0] + 0x9E3779B97F4A7C15) % whole, (k[1] + 0xBB67AE8584CAA73B) % whole]
    return c


def test_the_philox_of_these_tests_gives_the_known_answers_of_random123() -> None:
    ones = 2**256 - 1
    assert philox(0, 0) == [
        0x16554D9ECA36314C,
        0xDB20FE9D672D0FDC,
        0xD7E772CEE186176B,
        0x7E68B68AEC7BA23B,
    ]
    assert philox(ones, ones >> 128) == [
        0x87B092C3013FE90B,
        0x438C3C67BE8D0224,
        0x9CC7D7C69CD777B6,
        0xA09CAEBF594F0BA0,
    ]


@pytest.mark.parametrize("seed", [0, 7, 2**64 - 1])
@pytest.mark.parametrize("stream", [0, 3, 2**64 - 1])
@pytest.mark.parametrize("shot", [0, 1, 6, 4_000_000_003])
def test_shot_i_has_word_i_of_philox_keyed_by_seed_and_stream(
    seed: int, stream: int, shot: int
) -> None:
    # NumPy counts before it draws: its first block is that of counter 1.
    word = philox(shot // 4 + 1, (stream << 64) + seed)[shot % 4]
    assert random_module.uniforms(seed, stream, shot, shot + 1).tolist() == [
        ((word >> 12) + 0.5) * 2.0**-52
    ]


@pytest.mark.parametrize("draw", [random_module.uniforms, random_module.normals])
@pytest.mark.parametrize("start", [0, 2**40 + 1])
def test_numbers_are_the_same_bits_however_they_are_cut(draw: Any, start: int) -> None:
    whole = draw(5, 2, start, start + 41)
    for size in (1, 2, 3, 4, 7, 16, 40):
        edges = [*range(start, start + 41, size), start + 41]
        parts = [draw(5, 2, low, high) for low, high in itertools.pairwise(edges)]
        assert np.concatenate(parts).tobytes() == whole.tobytes()
    assert draw(5, 2, start, start).shape == (0,)


def test_extreme_words_are_neither_0_nor_1_and_have_finite_normals(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Extreme:
        def __init__(self, **_: Any) -> None:
            pass

        def random_raw(self, _: int) -> NDArray[np.uint64]:
            return np.array([0, 2**64 - 1], np.uint64)

    monkeypatch.setattr(np.random, "Philox", Extreme)
    numbers = random_module.uniforms(0, 0, 0, 2)
    assert numbers.tolist() == [2.0**-53, 1 - 2.0**-53]
    low, high = normal_quantile(numbers)
    assert -9 < low < -8
    assert 8 < high < 9


def test_normals_have_the_moments_of_the_normal_distribution() -> None:
    n = 1 << 18
    z = random_module.normals(11, 4, 0, n)
    # Standard errors of the first four moments; five of them, at a fixed seed.
    for power, moment, variance in ((1, 0, 1), (2, 1, 2), (3, 0, 15), (4, 3, 96)):
        assert abs(np.mean(z**power) - moment) < 5 * math.sqrt(variance / n)


def test_seeds_and_streams_have_nothing_to_do_with_each_other() -> None:
    n = 1 << 16
    keys = [(0, 0), (0, 1), (1, 0), (1, 1), (2**63, 0)]
    z = np.stack([random_module.normals(seed, stream, 0, n) for seed, stream in keys])
    off_diagonal = np.corrcoef(z)[~np.eye(len(keys), dtype=bool)]
    assert np.abs(off_diagonal).max() < 5 / math.sqrt(n)


@pytest.mark.parametrize("seed", [-1, 2**64, 1.0, "1", None])
def test_a_seed_is_a_whole_number_of_64_bits(seed: Any) -> None:
    with pytest.raises(ValueError, match="seed: expected a whole number from 0 to 2"):
        PLAYER.draw(0, 1, seed)


# Variables


def test_arguments_of_release_are_passed_on() -> None:
    values = FREE_THROW | {"azimuth": 0.1, "backspin": 19.0, "sidespin": 2.0, "angle": 0.7}
    made = resolve_variables(values)
    assert made.states.tobytes() == hoopgen.release(**values).tobytes()
    assert {name: column.tolist() for name, column in made.columns.items()} == {
        name: [value] for name, value in values.items()
    }
    assert made.parameters == dict(hoopgen.PAPER)


def test_parameters_take_the_place_of_the_scene_s() -> None:
    values = FREE_THROW | {"restitution": [0.6, 0.7], "gravity": 9.8}
    made = resolve_variables(values, hoopgen.NBA)
    assert len(made) == 2
    assert made.parameters["restitution"].tolist() == [0.6, 0.7]
    assert made.parameters["gravity"] == 9.8
    assert made.parameters["ring_radius"] == hoopgen.NBA["ring_radius"]
    assert hoopgen.simulate(made.states, made.parameters).outcome.shape == (2,)


@pytest.mark.parametrize("angle", [0.0, 0.6, -2.0, 3.1])
def test_x_and_y_stand_for_distance_and_angle(angle: float) -> None:
    place = {"x": 4.19 * math.cos(angle), "y": 4.19 * math.sin(angle)}
    rest = {name: FREE_THROW[name] for name in ("speed", "elevation", "height")}
    made = resolve_variables(rest | place)
    polar = resolve_variables(FREE_THROW | {"angle": angle})
    # Two roundings of the place, and one of each function.
    np.testing.assert_allclose(made.states, polar.states, rtol=0, atol=16 * EPS)


def fallen(made: Releases) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return states and coordinates along the line of aim, where they come down through z = 0."""
    x, y, z, vx, vy, vz, *_ = made.states.T
    g = np.asarray(made.parameters["gravity"], dtype=float)
    t = (vz + np.sqrt(vz * vz + 2 * g * z)) / g
    distance = np.hypot(x, y)
    past = -((x + vx * t) * x + (y + vy * t) * y) / distance
    return past, np.arctan2(-(vz - g * t), np.hypot(vx, vy))


@pytest.mark.parametrize("height", [1.5, 2.13, 3.048, 3.4])
@pytest.mark.parametrize("gravity", [9.81, 3.7])
def test_aim_is_where_the_ball_comes_down_past_the_centre(height: float, gravity: float) -> None:
    aim = np.array([-0.1, 0.0, 0.05, 0.3])
    made = resolve_variables(
        {"aim": aim, "elevation": 0.9, "height": height, "distance": 4.19, "angle": 0.8},
        hoopgen.PAPER | {"gravity": gravity},
    )
    past, _ = fallen(made)
    # A few roundings of lengths of about 4 m.
    np.testing.assert_allclose(past, aim, rtol=0, atol=64 * EPS)


@pytest.mark.parametrize("aim", [None, 0.05])
def test_entry_is_the_angle_at_which_it_comes_down(aim: float | None) -> None:
    entry = np.array([0.5, 0.7, 0.9])
    values: dict[str, Any] = {"entry": entry, "height": 2.13, "x": 1.0, "y": -3.0}
    past, down = fallen(resolve_variables(values | ({} if aim is None else {"aim": aim})))
    np.testing.assert_allclose(past, aim or 0.0, rtol=0, atol=64 * EPS)
    np.testing.assert_allclose(down, entry, rtol=32 * EPS, atol=0)


@pytest.mark.parametrize(
    "values",
    [
        {"aim": 0.0, "elevation": 0.1},  # the point is above the line of release
        {"aim": 0.0, "elevation": 0.25},  # it is passed on the way up
        {"aim": 0.0, "elevation": -0.9},
        {"aim": 0.0, "elevation": 2.2},  # away from it
        {"aim": 0.0, "elevation": -2.2},
        {"aim": -5.0, "elevation": 0.9},  # it is behind
        {"entry": -0.1},
    ],
)
def test_what_no_speed_can_do_is_invalid_and_disturbs_no_other(values: Mapping[str, float]) -> None:
    columns = {name: np.array([value, 0.9]) for name, value in values.items() if name != "aim"}
    aim = {"aim": np.array([values["aim"], 0.0])} if "aim" in values else {}
    made = resolve_variables({**columns, **aim, "height": 2.13, "distance": 4.19})
    assert np.isnan(made.columns["speed"][0])
    outcome = hoopgen.simulate(made.states).outcome
    assert (outcome == hoopgen.Outcome.INVALID).tolist() == [True, False]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"pace": 1.0}, "variables: unknown pace. One of speed, elevation"),
        ({"height": None}, "variables: missing height"),
        ({"speed": None}, "variables: expected speed and elevation, or aim in place of speed"),
        ({"elevation": None}, "or entry in place of both; got speed, height, distance"),
        ({"aim": 0.0}, "aim takes the place of speed; got both"),
        ({"entry": 0.8}, "entry takes the place of speed and elevation; got both"),
        ({"entry": 0.8, "speed": None}, "entry takes the place of elevation; got both"),
        ({"x": 1.0, "y": 1.0}, "x takes the place of distance; got both"),
        ({"x": 1.0, "distance": None}, "x and y are given together"),
        ({"speed": [1.0, 2.0], "height": [1.0, 2.0, 3.0]}, r"got shapes speed \(2,\), height"),
        ({"speed": [[1.0]]}, r"expected one number or one a shot each, got shapes speed \(1, 1\)"),
    ],
)
def test_what_is_wrong_with_variables_is_said(change: Mapping[str, Any], message: str) -> None:
    values = {name: v for name, v in (FREE_THROW | change).items() if v is not None}
    with pytest.raises(ValueError, match=message):
        resolve_variables(values)


def test_a_value_that_is_no_number_is_a_type_error_that_names_it() -> None:
    with pytest.raises(TypeError, match="speed: expected numbers, got 'fast'"):
        resolve_variables(FREE_THROW | {"speed": "fast"})  # type: ignore[dict-item]


def test_every_variable_has_a_label_and_a_unit() -> None:
    assert set(hoopgen.PAPER) < set(VARIABLES)
    assert {VARIABLES[name].unit for name in ("speed", "entry", "x", "backspin", "gravity")} == {
        "m/s",
        "rad",
        "m",
        "rad/s",
        "m/s2",
    }
    assert VARIABLES["restitution"].unit == ""
    assert all(name == variable.name and variable.label for name, variable in VARIABLES.items())


# All models


@pytest.mark.parametrize("name", MODELS)
def test_a_shot_is_the_same_bits_whatever_is_drawn_with_it(name: str) -> None:
    model, n = MODELS[name], 24
    whole = model.draw(0, n, seed=3)
    assert len(whole) == n
    for size in (1, 2, 3, 5, 8, 23):
        for low in range(0, n, size):
            part = model.draw(low, min(low + size, n), seed=3)
            assert same(part, rows(whole, slice(low, low + size)))


@pytest.mark.parametrize("name", MODELS)
def test_models_are_pickled_and_say_what_tells_them_from_others(name: str) -> None:
    model = MODELS[name]
    assert isinstance(model, ReleaseModel)
    copy = pickle.loads(pickle.dumps(model))
    assert same(copy.draw(2, 9, 1), model.draw(2, 9, 1))
    assert copy.identity() == model.identity()
    others = [m.identity() for other, m in MODELS.items() if other != name]
    assert model.identity() not in others


def test_identities_see_every_difference() -> None:
    alike = [
        PLAYER,
        Scatter(FREE_THROW | {"speed": 7.18}, SD, CORRELATION),
        Scatter(FREE_THROW, SD | {"speed": 0.08}, CORRELATION),
        Scatter(FREE_THROW, SD),
        MEASURED,
        Resample(dict(MEASURED.columns) | {"speed": [7.1, 7.3, 7.2]}),
        Resample(dict(MEASURED.columns) | {"backspin": 18.0}),
        LATTICE,
        Grid(LATTICE.axes, dict(LATTICE.fixed) | {"height": 2.2}),
        Grid(dict(reversed(LATTICE.axes.items())), LATTICE.fixed),
    ]
    texts = [repr(model.identity()) for model in alike]
    assert len(set(texts)) == len(texts)


@pytest.mark.parametrize("name", MODELS)
def test_parameters_that_a_model_does_not_name_are_the_scene_s(name: str) -> None:
    made = MODELS[name].draw(0, 2, 0, hoopgen.FIBA)
    assert made.parameters["board_half_width"] == 0.9
    assert set(made.parameters) == set(hoopgen.PAPER)
    assert np.shape(made.parameters["restitution"]) == (2,)


# Scatter


def test_scatter_has_the_means_deviations_and_correlations_asked_for() -> None:
    n = 1 << 18
    made = PLAYER.draw(0, n, seed=1)
    columns = {**made.columns, "restitution": np.asarray(made.parameters["restitution"])}
    means = {**FREE_THROW, "azimuth": 0.0, "restitution": hoopgen.PAPER["restitution"]}
    z = {name: (columns[name] - means[name]) / sd for name, sd in SD.items()}
    for score in z.values():
        assert abs(score.mean()) < 5 / math.sqrt(n)
        assert abs(score.std() - 1) < 5 / math.sqrt(2 * n)
    given = {frozenset(pair): value for pair, value in CORRELATION.items()}
    for a, b in itertools.combinations(SD, 2):
        wanted = given.get(frozenset((a, b)), 0.0)
        # Standard error of a correlation: (1 - r²)/√n.
        found = np.corrcoef(z[a], z[b])[0, 1]
        assert abs(found - wanted) < 5 * (1 - wanted**2) / math.sqrt(n)


def test_what_does_not_scatter_is_the_mean() -> None:
    made = PLAYER.draw(0, 5)
    for name in ("height", "distance", "backspin", "sidespin", "angle"):
        assert set(made.columns[name]) == {FREE_THROW.get(name, 0.0)}
    still = Scatter(FREE_THROW, {"speed": 0.0}).draw(0, 5)
    assert len(np.unique(still.states, axis=0)) == 1
    assert still.states.shape == (5, 9)
    assert Scatter(FREE_THROW).noise(0, 5) == {}


def test_noise_is_about_the_speed_and_the_angle_that_aim_and_entry_stand_for() -> None:
    place = {"height": 2.13, "distance": 4.19}
    plain = resolve_variables({"entry": 0.8, "aim": 0.05, **place})
    resolved = Scatter({n: float(c[0]) for n, c in plain.columns.items()}, SD)
    assert same(Scatter({"entry": 0.8, "aim": 0.05, **place}, SD).draw(0, 9), resolved.draw(0, 9))


def test_parameters_scatter_about_the_mean_s_or_the_scene_s_value() -> None:
    sd = {"restitution": 0.02}
    noise = Scatter(FREE_THROW, sd).noise(0, 7)["restitution"]
    for mean, scene, middle in (({}, 0.65, 0.65), ({"restitution": 0.8}, 0.65, 0.8)):
        parameters = hoopgen.PAPER | {"restitution": scene}
        made = Scatter(FREE_THROW | mean, sd).draw(0, 7, 0, parameters)
        assert made.parameters["restitution"].tolist() == (middle + noise).tolist()


def test_settings_share_their_random_numbers() -> None:
    """Whatever else scatters, however much, and whatever the mean."""
    quarter = 0.25  # of a radian: divides without rounding
    alone = Scatter(FREE_THROW, {"azimuth": quarter}).noise(0, 9, 4)["azimuth"] / quarter
    more = Scatter({"entry": 0.8, "height": 2, "distance": 5}, SD).noise(0, 9, 4)["azimuth"]
    assert more.tolist() == (SD["azimuth"] * alone).tolist()
    other = Scatter(FREE_THROW, {"azimuth": quarter}).noise(0, 9, 5)["azimuth"] / quarter
    assert not np.any(alone == other)


def test_correlated_noise_keeps_the_numbers_of_the_first_name_in_order() -> None:
    plain, mixed = Scatter(FREE_THROW, SD).noise(0, 9), PLAYER.noise(0, 9)
    assert mixed["speed"].tolist() == plain["speed"].tolist()
    assert mixed["azimuth"].tolist() == plain["azimuth"].tolist()
    np.testing.assert_allclose(
        mixed["elevation"] / SD["elevation"],
        -0.6 * plain["speed"] / SD["speed"] + 0.8 * plain["elevation"] / SD["elevation"],
        rtol=0,
        atol=16 * EPS,
    )


@pytest.mark.parametrize(
    ("mean", "sd", "correlation", "message"),
    [
        ({"sped": 7}, {}, {}, r"release: unknown sped; is speed meant\? One of speed"),
        ({"speed": [7, 8]}, {}, {}, r"release\['speed'\]: expected one number, got \[7, 8\]"),
        ({}, {"aim": 0.1}, {}, "sd: unknown aim. One of speed"),
        ({}, {"speed": -0.1}, {}, r"sd\['speed'\]: expected a number from 0, got -0.1"),
        ({}, {"speed": math.nan}, {}, r"sd\['speed'\]: expected a number from 0, got nan"),
        ({}, {"speed": math.inf}, {}, r"sd\['speed'\]: expected a number from 0, got inf"),
        ({}, {"speed": [0.1]}, {}, r"sd\['speed'\]: expected a number from 0"),
        ({}, SD, {("speed", "speed"): 0.5}, "is no pair of speed, elevation"),
        ({}, SD, {("speed", "height"): 0.5}, r"\('speed', 'height'\) is no pair of speed"),
        ({}, {}, {("speed", "height"): 0.5}, "is no pair of none"),
        ({}, SD, {("speed", "azimuth"): 1.0}, "speed and azimuth: expected a number within -1"),
        ({}, SD, {("speed", "azimuth"): math.nan}, "expected a number within -1 and 1, got nan"),
        (
            {},
            SD,
            {("speed", "azimuth"): 0.5, ("azimuth", "speed"): 0.5},
            "correlation: speed and azimuth are given twice",
        ),
        (
            {},
            SD,
            {
                ("speed", "azimuth"): 0.9,
                ("speed", "elevation"): 0.9,
                ("azimuth", "elevation"): -0.9,
            },
            "correlation: no distribution has all of these",
        ),
    ],
)
def test_what_is_wrong_with_a_scatter_is_said(
    mean: Any, sd: Any, correlation: Any, message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        Scatter(mean, sd, correlation)


def test_correlations_of_what_is_still_do_not_matter() -> None:
    sd = SD | {"azimuth": 0.0}
    still = Scatter(FREE_THROW, sd, {("speed", "azimuth"): 0.9}).noise(0, 4)
    assert "azimuth" not in still
    assert still["speed"].tolist() == PLAYER.noise(0, 4)["speed"].tolist()


# Resample


def test_rows_are_drawn_equally_often_and_keep_together() -> None:
    n = 30_000
    made = MEASURED.draw(0, n, seed=2)
    names = ("speed", "elevation", "distance", "backspin")
    drawn = np.stack([*(made.columns[name] for name in names), made.parameters["restitution"]], -1)
    found, counts = np.unique(drawn, axis=0, return_counts=True)
    assert found.tolist() == [
        [7.1, 0.9, 4.1, 19.0, 0.7],
        [7.2, 0.92, 4.2, 19.0, 0.6],
        [7.3, 0.88, 4.3, 19.0, 0.65],
    ]
    # Five standard errors of a count: √(n p (1 - p)).
    assert np.abs(counts - n / 3).max() < 5 * math.sqrt(n * 2 / 9)


@pytest.mark.parametrize("number", [1, 2, 3, 5, 7, 64, 1000, 3 * 2**20 + 1])
def test_the_greatest_number_draws_the_last_row(
    number: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A product that were rounded up to the number of rows would be out of range."""
    extremes = np.array([2.0**-53, 1 - 2.0**-53])
    monkeypatch.setattr("hoopgen.study.models.resample.uniforms", lambda *_: extremes)
    speeds = np.arange(number) * 2.0**-17
    model = Resample({"speed": speeds, "elevation": 0.9, "height": 2, "distance": 4})
    assert model.rows == number
    assert model.draw(0, 2).columns["speed"].tolist() == [0, speeds[-1]]


def test_rows_are_drawn_as_if_each_were_a_release() -> None:
    made = MEASURED.draw(0, 12, 5)
    row = np.searchsorted([7.1, 7.2, 7.3], made.columns["speed"])
    for shot, place in enumerate(row):
        one = {n: np.broadcast_to(c, 3)[place] for n, c in MEASURED.columns.items()}
        assert made.states[shot].tobytes() == resolve_variables(one).states[0].tobytes()


def test_measured_states_are_passed_on_and_unmeasured_spin_is_none() -> None:
    random = np.random.default_rng(0)
    columns: dict[str, Any] = {name: random.normal(size=4) for name in STATE[:6]}
    made = Resample(columns | {"wy": 19.0, "ball_radius": [0.119, 0.12, 0.121, 0.122]}).draw(0, 50)
    assert made.columns == {}
    row = np.searchsorted([0.119, 0.12, 0.121, 0.122], made.parameters["ball_radius"])
    assert set(row) == {0, 1, 2, 3}
    for place, name in enumerate(STATE[:6]):
        assert made.states[:, place].tolist() == columns[name][row].tolist()
    assert np.unique(made.states[:, 6:], axis=0).tolist() == [[0.0, 19.0, 0.0]]


def test_later_changes_of_the_caller_s_columns_change_no_shot() -> None:
    speeds = [7.1, 7.2, 7.3]
    model = Resample({"speed": speeds, "elevation": 0.9, "height": 2.1, "distance": 4.2})
    before = model.draw(0, 9)
    speeds[0] = 99.0
    assert same(before, model.draw(0, 9))


@pytest.mark.parametrize(
    ("columns", "message"),
    [
        ({}, "columns: expected columns of one length and at least one row"),
        (FREE_THROW, "columns of one length and at least one row"),
        ({"speed": []}, r"at least one row, got shapes speed \(0,\)"),
        ({"speed": [1, 2], "height": [1, 2, 3]}, r"got shapes speed \(2,\), height \(3,\)"),
        ({"velocity": [1, 2]}, "columns: unknown velocity"),
        ({"vx": [1, 2], "x": 3}, "columns: a state needs y, z, vy, vz too"),
    ],
)
def test_what_is_wrong_with_columns_is_said(columns: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Resample(columns)


def test_of_states_the_scene_says_which_parameters_there_are() -> None:
    state = {name: [1.0, 2.0] for name in STATE}
    with pytest.raises(ValueError, match=r"columns: unknown speed\. One of x, y, z"):
        Resample({**state, "speed": 3}).draw(0, 1)
    with pytest.raises(ValueError, match=r"release: unknown speed\. One of x, y, z"):
        Scatter({**dict.fromkeys(STATE, 1.0), "speed": 3}, {"vx": 0.1}).draw(0, 1)
    drawn = Resample({**state, "lively": [0.5, 0.6]}).draw(0, 9, parameters={"lively": 0.9})
    assert set(drawn.parameters["lively"]) == {0.5, 0.6}


# Grid


def test_a_grid_has_every_combination_the_last_axis_fastest() -> None:
    assert LATTICE.shape == (3, 2, 4)
    assert LATTICE.shots == 24
    made = LATTICE.draw(0, 24)
    columns = made.columns["speed"], made.parameters["restitution"], made.columns["angle"]
    assert list(zip(*(c.tolist() for c in columns), strict=True)) == list(
        itertools.product(*LATTICE.axes.values())
    )
    assert set(made.columns["distance"]) == {4.2}


def test_a_grid_without_axes_is_one_shot() -> None:
    assert Grid({}, FREE_THROW).draw(0, 1).states.tolist() == [
        hoopgen.release(**FREE_THROW).tolist()
    ]


def test_a_grid_of_parameters_alone_and_one_of_states() -> None:
    made = Grid({"restitution": [0.6, 0.7, 0.8]}, FREE_THROW).draw(0, 3)
    assert made.states.shape == (3, 9)
    states = Grid({"vz": [3.0, 4.0]}, {name: 1.0 for name in STATE[:6] if name != "vz"})
    assert states.draw(0, 2).states[:, 5].tolist() == [3.0, 4.0]


@pytest.mark.parametrize(("start", "stop"), [(-1, 2), (0, 25), (5, 4)])
def test_beyond_a_grid_there_is_nothing(start: int, stop: int) -> None:
    with pytest.raises(IndexError, match=f"grid: shots {start} to {stop} of 24"):
        LATTICE.draw(start, stop)


@pytest.mark.parametrize(
    ("axes", "fixed", "message"),
    [
        ({"speed": [7]}, FREE_THROW, "fixed: speed already among the axes"),
        ({"speed": 7}, {}, r"axes\['speed'\]: expected a list of numbers, got 7"),
        ({"speed": []}, {}, r"axes\['speed'\]: expected a list of numbers, got \[\]"),
        ({"speed": [7]}, {}, "variables: missing height, distance"),
        ({"tempo": [7]}, FREE_THROW, "variables: unknown tempo"),
    ],
)
def test_what_is_wrong_with_a_grid_is_said(axes: Any, fixed: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Grid(axes, fixed)


def test_degrees_in_place_of_radians_are_refused() -> None:
    with pytest.raises(
        ValueError, match=r"release: elevation is in radians, .* more than a turn: 52"
    ):
        Scatter({"speed": 7.0, "elevation": 52.0, "height": 2.0, "distance": 4.0})
