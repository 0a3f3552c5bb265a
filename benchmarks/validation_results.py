"""Results of `benchmarks.validation`, which the literature has, too."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

import hoopgen
from benchmarks import validation_court, validation_friction, validation_rolling
from benchmarks.free_throw import LINE, SEVENTY
from benchmarks.rolling import Bounce
from hoopgen import FIBA, NBA, PAPER, Outcome, Scatter
from hoopgen.core.units import DEGREE, FOOT, INCH, TURN
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.hoop.variables import ARGUMENTS, resolve_variables
from hoopgen.study.jobs.objective import By, Player, paired
from hoopgen.study.questions.bank import Crossing, bank_or_direct, crossing
from hoopgen.study.questions.estimate_result import Estimate
from hoopgen.study.questions.optimum import optimum
from hoopgen.study.questions.optimum_result import Optimum
from hoopgen.study.statistics.intervals import wilson_interval

Floats = NDArray[np.float64]
Parameters = Mapping[str, Any]

STRAIGHTER = SEVENTY | {"speed": 0.09, "azimuth": 0.5 * DEGREE}
"""Spread of a player who makes as many, less steady in speed, and straighter."""

BACKSPINS = (0, 1, 2, 3, 4, 5)
HEIGHTS = (6.0, 6.5, 7.0, 7.5, 8.0)
RESTITUTIONS = (0.5, 0.6, 0.7, 0.8)
DISTANCES = (6, 8, 10, 12, 14)
ANGLES = (0, 15, 30, 45, 60, 75)
SPEED_SDS = (0.05, 0.06, 0.07, 0.08, 0.09, 0.10, 0.11, 0.12, 0.13)
ANGLE_SDS = (1.04, 1.3, 1.56)

THEIR_GAP = 0.05
"""m between the ball and the back of the ring in Tran and Silverberg's best free throw."""

THEIR_AIM = PAPER["ring_radius"] - PAPER["wire_radius"] - PAPER["ball_radius"] - THEIR_GAP
"""m past the centre of the ring: where that is in `PAPER`."""

THEIR_AXIS = 3.326 * INCH
"""Behind the board: Silverberg, Tran and Adams."""


# ------------------------------------------------------------------------------ closed forms


@dataclass(frozen=True)
class Check:
    """A number of ours and the same in closed form."""

    what: str
    ours: float
    closed: float
    unit: str


def closed_forms() -> list[Check]:
    """Return the slowest free throw, by a search and by formula."""
    length, rise, gravity = LINE["distance"], RING_HEIGHT - LINE["height"], PAPER["gravity"]
    angle = math.pi / 4 + math.atan(rise / length) / 2
    speed = math.sqrt(gravity * (rise + math.hypot(length, rise)))
    entry = math.atan(math.tan(angle) - 2 * rise / length)

    def through_the_centre(elevation: float) -> float:
        shot = resolve_variables(LINE | {"aim": 0.0, "elevation": elevation})
        return float(shot.columns["speed"][0])

    # A minimum is found to the root of eps.
    least = minimize_scalar(
        through_the_centre, bounds=(0.7, 1.1), method="bounded", options={"xatol": 1e-9}
    )
    shot = resolve_variables(LINE | {"elevation": angle, "speed": speed})
    flown = hoopgen.simulate(shot.states)
    measured = hoopgen.measure(shot.states, flown, PAPER, ("entry_angle", "depth"))
    return [
        Check("release angle of least speed", least.x / DEGREE, angle / DEGREE, "°"),
        Check("least speed", least.fun, speed, "m/s"),
        Check("its entry angle", measured["entry_angle"].item() / DEGREE, entry / DEGREE, "°"),
        Check("how far from the centre it comes down", measured["depth"].item(), 0.0, "m"),
    ]


@dataclass(frozen=True)
class Smallest:
    """Smallest entry angles of a swish, rad: in closed form and as the engine finds them."""

    name: str
    edge: float
    wire: float
    straight: float
    thrown: float


def smallest_entries() -> list[Smallest]:
    """Return the smallest entry angles of each preset, by four definitions."""
    return [
        Smallest(
            name,
            math.asin(p["ball_radius"] / (p["ring_radius"] - p["wire_radius"])),
            math.asin((p["ball_radius"] + p["wire_radius"]) / p["ring_radius"]),
            smallest(partial(_straight, parameters=p)),
            smallest(partial(_thrown, parameters=p)),
        )
        for name, p in (("PAPER", PAPER), ("NBA", NBA), ("FIBA", FIBA))
    ]


def smallest(swishes: Callable[[float], bool]) -> float:
    """Return the entry angle from which on it swishes, by bisection to a billionth."""
    low, high = 25 * DEGREE, 45 * DEGREE
    while high - low > 1e-9:
        middle = (low + high) / 2
        low, high = (low, middle) if swishes(middle) else (middle, high)
    return high


def _swish(states: Floats, parameters: Parameters) -> bool:
    shots = hoopgen.simulate(states, parameters, fields=("outcome", "contacts"))
    return bool(np.any((shots.outcome == Outcome.MADE) & (shots.contacts == 0)))


def _straight(entry: float, parameters: Parameters) -> bool:
    """Return whether a flight almost without gravity goes through the centre untouched."""
    speed, away = 10.0, 2.0
    towards = np.array([-math.cos(entry), 0.0, -math.sin(entry)])
    state = np.concatenate([-away * towards, speed * towards, np.zeros(3)])
    # It falls by 2e-11 m on the way.
    return _swish(state, {**parameters, "gravity": 1e-9})


def _thrown(entry: float, parameters: Parameters) -> bool:
    """Return whether a free throw with this entry angle can swish."""
    aims = np.linspace(-0.03, 0.03, 601)
    shots = resolve_variables({**LINE, "entry": np.full(len(aims), entry), "aim": aims}, parameters)
    return _swish(shots.states, parameters)


# ------------------------------------------------------------------------------- free throws


@dataclass(frozen=True)
class FreeThrows:
    """Best releases from the line: by backspin (Hz), height (ft), restitution; and two recipes."""

    by_spin: Mapping[int, Optimum]
    by_height: Mapping[float, Optimum]
    direct: Mapping[float, Optimum]
    bank: Mapping[float, Optimum]
    centred: Optimum
    straighter: Optimum
    theirs: Estimate

    @property
    def best(self) -> Optimum:
        """Return the best release with the backspin and the height of the literature."""
        return self.by_spin[3]


def free_throws(shots: int) -> FreeThrows:
    """Search for them."""

    def best(
        over: Sequence[str] = ("elevation", "aim"),
        by: By = "any",
        sd: Mapping[str, float] = SEVENTY,
        **change: float,
    ) -> Optimum:
        scene = PAPER | {"restitution": change.pop("restitution", PAPER["restitution"])}
        return optimum(Scatter(LINE | change, sd), over, scene, by=by, shots=shots, margins=())

    return FreeThrows(
        {spin: best(backspin=spin * TURN) for spin in BACKSPINS},
        {height: best(height=height * FOOT) for height in HEIGHTS},
        {e: best(restitution=e, by="direct") for e in RESTITUTIONS},
        {e: best(restitution=e, by="bank") for e in RESTITUTIONS},
        best(("elevation",), aim=0.0),
        best(sd=STRAIGHTER),
        recipe(shots),
    )


# -------------------------------------------------------------------------------- bank shots


@dataclass(frozen=True)
class Banks:
    """Places with their best bank shots, and where the lines to what is aimed at cross.

    `releases` are the vertical planes of the releases, `touches` the lines to where the ball
    touches the board; `closed` is the distance behind the board by formula, and `past` how far
    from the middle of the ring the balls come down on average. `slope` and `foot` are those of the
    V on which they touch, `off` its root mean square distance from them, m. `most` is the index of
    the place where the bank leads most, and `lead` by how much, with its interval, when that place
    is thrown again with other random numbers than those it was chosen by.
    """

    places: xr.Dataset
    restitution: float
    releases: Crossing
    touches: Crossing
    closed: float
    past: float
    slope: float
    foot: float
    off: float
    most: int
    lead: tuple[float, float, float]


def banks(
    distances: Sequence[float],
    shots: int,
    restitution: float = PAPER["restitution"],
    sd: Mapping[str, float] = SEVENTY,
) -> Banks:
    """Compare from places all round one half of the court; the other half is its mirror image."""
    away, angle = np.meshgrid(np.array(distances) * FOOT, np.array(ANGLES) * DEGREE, indexing="ij")
    spots = np.stack([away * np.cos(angle), away * np.sin(angle)], axis=-1).reshape(-1, 2)
    release = {name: LINE[name] for name in ("height", "backspin")}
    scene = PAPER | {"restitution": restitution}
    found = bank_or_direct(Scatter(release, sd), spots, scene, shots=shots)
    # From straight in front the line is the court's middle, and says nothing about the axis.
    aside = found.isel(place=np.flatnonzero(spots[:, 1] > 0.1))
    starts = np.stack([aside.x, aside.y], axis=1)

    def cross(name: str) -> Crossing:
        front = np.full(len(starts), -scene["board_distance"])
        return crossing(starts, np.stack([front, aside[name]], axis=1))

    most = int(np.argmax(found.difference.values))
    y, z = found.touch_y.values, found.touch_z.values
    slope, foot = np.polyfit(np.abs(y), z, 1)
    off = math.sqrt(np.mean((z - foot - slope * np.abs(y)) ** 2))
    return Banks(
        places=found,
        restitution=restitution,
        releases=cross("sight_y"),
        touches=cross("touch_y"),
        closed=axis_behind(restitution),
        past=_past(found.sel(way="bank"), scene),
        slope=float(slope),
        foot=float(foot),
        off=off,
        most=most,
        lead=_thrown_again(found.isel(place=most), sd, scene, shots),
    )


def _thrown_again(
    place: xr.Dataset, sd: Mapping[str, float], scene: Parameters, shots: int
) -> tuple[float, float, float]:
    """Bank less direct from a place with new random numbers: seed 2."""
    ways: tuple[By, By] = ("bank", "direct")
    bank, direct = (
        Player(Scatter({}, sd), scene, way).scored(
            {name: float(place.sel(way=way)[name]) for name in ARGUMENTS}, shots, seed=2
        )
        for way in ways
    )
    return paired(bank, direct, 0.95)


def _past(best: xr.Dataset, scene: Parameters) -> float:
    """Return the mean distance from the ring's centre of shots without scatter, m."""
    states = hoopgen.release(**{name: best[name].values for name in ARGUMENTS})
    shots = hoopgen.simulate(states, scene)
    found = hoopgen.measure(states, shots, scene, ("depth", "left_right"))
    return float(np.mean(np.hypot(found["depth"], found["left_right"])))


def axis_behind(restitution: float) -> float:
    """Return the distance of the axis behind the board, m, for balls to the centre of the ring.

    Without spin about the vertical the board leaves 3/5 of the velocity along it (Eqs. 11-17) and
    the restitution's share of that towards it; so the straight line of the release, gone on with,
    meets the court's middle that much behind the plane of the touching ball's centre.
    """
    centre = PAPER["board_distance"] - PAPER["ball_radius"]
    return float(0.6 / restitution * centre - PAPER["ball_radius"])


def restitution_of_axis(behind: float) -> float:
    """Return the restitution with which the axis is so far behind the board."""
    radius = PAPER["ball_radius"]
    return float(0.6 * (PAPER["board_distance"] - radius) / (behind + radius))


# ----------------------------------------------------------------------------------- scatter


@dataclass(frozen=True)
class Curve:
    """Success of one release against a standard deviation, with intervals."""

    sd: Floats
    probability: Floats
    low: Floats
    high: Floats


def success(release: Mapping[str, float], name: str, sds: Sequence[float], shots: int) -> Curve:
    """Vary one deviation of the shooter's scatter, all else the same."""
    thrown = [
        Player(Scatter({}, SEVENTY | {name: sd})).sampled(release, shots, seed=1) for sd in sds
    ]
    pairs = [(one.made, one.valid) for one in thrown]
    made, valid = (np.concatenate(counts) for counts in zip(*pairs, strict=True))
    return Curve(np.array(sds), made / valid, *wilson_interval(made, valid, 0.95))


def rounded(best: Optimum) -> dict[str, float]:
    """Return the best free throw, rounded to a tenth of a degree and of a centimetre."""
    angle, aim = best.release["elevation"] / DEGREE, best.release["aim"]
    return free_throw(round(angle, 1), round(100 * aim, 1))


def free_throw(angle: float, aim: float) -> dict[str, float]:
    """Return a free throw, by its angle in degrees and its aim in cm."""
    return {**LINE, "elevation": angle * DEGREE, "aim": aim / 100}


def recipe(shots: int) -> Estimate:
    """Return the estimate of their best free throw: 52°, and their gap at the back of the ring."""
    release = free_throw(52, 100 * THEIR_AIM)
    return hoopgen.estimate(Scatter(release, SEVENTY), shots=shots, seed=1)


# -------------------------------------------------------------------------------- everything


@dataclass(frozen=True)
class Results:
    """All that the page says."""

    checks: Sequence[Check]
    entries: Sequence[Smallest]
    line: FreeThrows
    banks: Banks
    livelier: Banks
    straighter: Banks
    by_speed: Curve
    by_angle: Curve
    shots: int
    bank_shots: int
    court: Sequence[str]
    """Lines of the sections on the whole hoop, on friction, and on rolling."""
    bounces: dict[float, list[Bounce]]


def everything(shots: int, bank_shots: int, distances: Sequence[float]) -> Results:
    """Compute it, saying what comes next."""
    print("closed forms")
    checks, entries = closed_forms(), smallest_entries()
    print("free throws")
    line = free_throws(shots)
    print("bank shots")
    places = banks(distances, bank_shots)
    livelier = banks(distances[-2:], bank_shots, restitution_of_axis(THEIR_AXIS))
    straighter = banks(distances[-2:], bank_shots, sd=STRAIGHTER)
    print("scatter")
    release = rounded(line.best)
    print("the whole hoop")
    court = validation_court.section(shots)
    print("friction and restitutions")
    friction = validation_friction.section(bank_shots)
    print("rolling")
    bounces = validation_rolling.sequences()
    rolling = validation_rolling.section(bounces, 4 * shots)
    return Results(
        checks,
        entries,
        line,
        places,
        livelier,
        straighter,
        success(release, "speed", SPEED_SDS, shots),
        success(release, "elevation", [sd * DEGREE for sd in ANGLE_SDS], shots),
        shots,
        bank_shots,
        [*court, *friction, *rolling],
        bounces,
    )
