"""Arrivals on planes with a normal in any direction: roots, their delays and vague accelerations.

The kernels' values are compared with the exact root of the plane and the path that the doubles
describe, to 60 digits.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from hoopgen.codegen import render
from hoopgen.scene import End, Plane, Scene
from tests.helpers.compiled import load_module
from tests.helpers.derived import DerivedKernels
from tests.helpers.effort import trials

Floats = NDArray[np.float64]
mpmath.mp.dps = 60


def scene(name: str, **given: Any) -> Scene:
    """Return a scene with one plane whose normal is no axis."""
    return Scene(
        name,
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.5,
        bodies=[Plane("ramp", normal=(0.3, 0.1, 1), point=(0, 0, 0.2))],
        ends={"out": End(at=-9)},
        **given,
    )


@pytest.fixture(scope="module", params=["upright", "leaning"])
def module(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """Return the kernels of a scene with gravity along an axis, or not."""
    given = {} if request.param == "upright" else {"down": (0.2, -0.4, -1.0)}
    made, path = scene(request.param, **given), tmp_path_factory.mktemp("ramp") / "ramp.py"
    text = render.render_scene(made.derive(), page=False, targets=["numpy"])
    path.write_text(text[f"numpy/{request.param}.py"], encoding="utf-8")
    return load_module(path)


def called(kernel: Callable[..., Any], values: Mapping[str, Any]) -> tuple[Any, ...]:
    """Return the outputs of a kernel, given the values by the names of its arguments."""
    names = [name for name in inspect.signature(kernel).parameters if name != "_room"]
    return tuple(kernel(*(values[name] for name in names)))


def unit(rng: np.random.Generator, count: int) -> Floats:
    drawn = rng.normal(size=(count, 3))
    return np.asarray(drawn / np.linalg.norm(drawn, axis=1)[:, None])


def drawn_flights(rng: np.random.Generator, count: int) -> dict[str, Floats]:
    """Return flights towards planes: places of all sizes, planes near and far from the origin."""
    direction = unit(rng, count)
    size = 10.0 ** rng.uniform(-2, 2, count)
    place = rng.normal(size=(count, 3)) * size[:, None]
    gap = 10.0 ** rng.uniform(-6, 0, count)
    radius = np.full(count, 0.05)
    at = (direction * place).sum(1) - gap - radius
    velocity = rng.normal(size=(count, 3)) * 10.0 ** rng.uniform(-2, 1, (count, 1))
    down = unit(rng, count) * 9.81
    values = {"p_ball_radius": radius, "p_ramp_at": at, "leaving": np.zeros(count)}
    values |= {"p_gravity": np.full(count, 9.81)}
    for k, axis in enumerate("xyz"):
        values[axis], values[f"v{axis}"] = place[:, k], velocity[:, k]
        values[f"p_ramp_direction_{axis}"] = direction[:, k]
        values[f"p_gravity_{axis}"] = down[:, k]
    return values


def exact_coefficients(values: Mapping[str, Floats], k: int, leaning: bool) -> tuple[Any, Any, Any]:
    """Return c, b and a of the plane's gap, to 60 digits."""
    own = {name: mpmath.mpf(float(value[k])) for name, value in values.items()}
    pull = [own[f"p_gravity_{axis}"] for axis in "xyz"] if leaning else [0, 0, -own["p_gravity"]]
    normal = [own[f"p_ramp_direction_{axis}"] for axis in "xyz"]
    start = sum(n * own[axis] for n, axis in zip(normal, "xyz", strict=True))
    c = mpmath.mpf(0) if own["leaving"] else start - own["p_ramp_at"] - own["p_ball_radius"]
    b = sum(n * own[f"v{axis}"] for n, axis in zip(normal, "xyz", strict=True))
    return c, b, sum(n * g for n, g in zip(normal, pull, strict=True)) / 2


def exact_arrival(c: Any, b: Any, a: Any) -> Any:
    """Return the only time at which c + b t + a t² falls through zero; None: there is none."""
    discriminant = b**2 - 4 * a * c
    if discriminant <= 0:
        return None
    root = mpmath.sqrt(discriminant)
    time = 2 * c / (root - b) if b < 0 else -(b + root) / (2 * a)
    return time if time >= 0 else None


@pytest.mark.sampled(1)
@pytest.mark.parametrize("returns", [False, True])
def test_the_delay_bounds_the_error_of_the_root(module: ModuleType, returns: bool) -> None:
    """The computed time is within the delay of the exact root, which is no wild bound."""
    rng = np.random.default_rng(41 + returns)
    leaning = "p_gravity_x" in inspect.signature(module.ramp_arrival).parameters
    count = trials(2000, at_least=300)
    values = drawn_flights(rng, count)
    values["leaving"][:] = float(returns)
    with np.errstate(all="ignore"):
        time, rate, bend, *_ = called(module.ramp_arrival, values)
    shares = []
    for k in np.flatnonzero((rate < 0) & (time > 0) & (time < 1e3)):
        found = exact_arrival(*exact_coefficients(values, int(k), leaning))
        pull = [values[f"p_gravity_{axis}"][k] for axis in "xyz"] if leaning else [0, 0, -9.81]
        there = {name: np.float64(value[k]) for name, value in values.items()}
        for axis, g in zip("xyz", pull, strict=True):
            there[axis] += time[k] * (there[f"v{axis}"] + g * time[k] / 2)
            there[f"v{axis}"] += g * time[k]
        there |= {"t": time[k], "curving": np.float64(0 if returns else np.inf)}
        (delay,) = called(module.ramp_root_delay, there)
        if 100 * delay * abs(bend[k]) > -rate[k]:  # near an apex, which is no certain crossing
            continue
        assert found is not None, k
        shares.append(float(abs(found - mpmath.mpf(float(time[k]))) / mpmath.mpf(float(delay))))
    assert len(shares) > count / 5
    assert max(shares) < 1
    assert max(shares) > 0.02


def along_gravity() -> DerivedKernels:
    """Return the kernels of a scene whose gravity has a direction."""
    return DerivedKernels.from_scene(scene("along", down=(0.2, -0.4, -1.0)).derive())


def evaluated(kernels: DerivedKernels, name: str, values: Mapping[str, Any]) -> tuple[Any, ...]:
    """Return the outputs of one of these kernels, given values by its arguments' names."""
    return tuple(getattr(kernels, name)(*(values[given] for given in kernels.ARGUMENTS[name])))


def off_planes(
    rng: np.random.Generator, count: int, lean: Floats, off: Floats
) -> dict[str, Floats]:
    """Return flights from planes along gravity but for the lean, at speeds off them, m/s."""
    values = drawn_flights(rng, count)
    down = np.stack([values[f"p_gravity_{axis}"] for axis in "xyz"], 1)
    across = np.cross(down, unit(rng, count))
    across /= np.linalg.norm(across, axis=1)[:, None]
    across -= lean[:, None] * down / np.linalg.norm(down, axis=1)[:, None]
    for k, axis in enumerate("xyz"):
        values[f"p_ramp_direction_{axis}"] = across[:, k]
        values[f"v{axis}"] = off * across[:, k]
    values["leaving"][:] = 1.0
    return values


def test_a_plane_along_gravity_is_met_no_sooner_than_is_said() -> None:
    """A ball that moves off a plane along gravity returns at once if roundings decide the sign."""
    rng, count = np.random.default_rng(7), trials(4000, at_least=500)
    values = off_planes(rng, count, np.zeros(count), 10.0 ** rng.uniform(-18, -12, count))
    kernels = along_gravity()
    time, rate, bend, apex, height = evaluated(kernels, "ramp_arrival", values)
    vague, early = 0, 0
    for k in range(count):
        found = exact_arrival(*exact_coefficients(values, k, True))
        met = rate[k] < 0 and 0 <= time[k] < np.inf
        if bend[k] == 0 and height[k] == 0 and apex[k] >= 0:
            vague += 1
            if found is not None:
                early += 1
                assert mpmath.mpf(float(apex[k])) <= found, k
        elif found is not None and found < 1e6:
            assert met or apex[k] >= 0, k
    assert min(vague, early) > count / 20


def test_an_arrival_that_is_said_is_late_by_a_small_share_of_its_time() -> None:
    """Planes are along gravity but for some roundings: the share is three in 256 at most."""
    rng, count = np.random.default_rng(7), trials(4000, at_least=1000)
    lean = 10.0 ** rng.uniform(-15, -12, count)
    values = off_planes(rng, count, lean, 10.0 ** rng.uniform(-16, 0, count))
    kernels = along_gravity()
    time, rate, bend, *_ = evaluated(kernels, "ramp_arrival", values)
    met = (rate < 0) & (time > 0)
    there = values | {"t": time, "curving": np.zeros(count)}
    for axis in "xyz":
        pull = values[f"p_gravity_{axis}"]
        there[axis] = values[axis] + time * (values[f"v{axis}"] + pull * time / 2)
        there[f"v{axis}"] = values[f"v{axis}"] + pull * time
    (delay,) = evaluated(kernels, "ramp_root_delay", there)
    share = delay[met] * np.abs(bend[met]) / -rate[met]
    assert len(share) > count / 4
    assert 1 / 256 < share.max() < 1 / 64
