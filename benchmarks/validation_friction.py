"""The literature's free throw and bank shot on the whole hoop, by friction and by restitutions."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import hoopgen
from benchmarks.free_throw import LINE, SEVENTY
from benchmarks.report import table
from hoopgen import COURT, NBA, NBA_COURT, PAPER_COURT, Scatter
from hoopgen.core.units import DEGREE
from hoopgen.study.jobs.objective import By, Player, paired
from hoopgen.study.questions.optimum import optimum
from hoopgen.study.questions.optimum_result import Optimum
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.text.numbers import format_percent

Parameters = Mapping[str, Any]
Paired = tuple[float, float, float]

SHOTS = 20_000
"""Thrown with the best releases, which are searched with two fifths as many."""

GRIP = PAPER_COURT | {name: value for name, value in NBA.items() if name in PAPER_COURT}


def _friction(value: float) -> dict[str, float]:
    return {f"{body}_friction": value for body in COURT.surfaces}


SETTINGS: Mapping[str, tuple[Any, Parameters]] = {
    "`HOOP`, `NBA`, e = 0.7": (None, NBA | {"restitution": 0.7}),
    "`COURT`, the same law": (COURT, GRIP),
    "`NBA_COURT`": (COURT, NBA_COURT),
    "its friction 0.3": (COURT, NBA_COURT | _friction(0.3)),
    "its friction 0.8": (COURT, NBA_COURT | _friction(0.8)),
    "its friction infinite": (COURT, NBA_COURT | _friction(math.inf)),
    "its rim 0.5": (COURT, NBA_COURT | {"ring_restitution": 0.5, "bridge_restitution": 0.5}),
    "its rim 0.8": (COURT, NBA_COURT | {"ring_restitution": 0.8, "bridge_restitution": 0.8}),
    "its board 0.7": (COURT, NBA_COURT | {"backboard_restitution": 0.7}),
}
"""Scenes and parameters; all but the first two are of `NBA_COURT`, with one thing changed."""


@dataclass(frozen=True)
class Setting:
    """The results for a shooter in one setting.

    The release angle of the best direct free throw, and how often it is made, with the ends of the
    interval; by how much backspin helps, each with its own best release; by how much the best free
    throw off the board is better; and the shares of the best direct throws that roll and that are
    given up with slip left.
    """

    elevation: float
    direct: Paired
    by_spin: Paired
    by_bank: Paired
    rolled: float
    slip_left: float


def found_in(scene: Any, parameters: Parameters, shots: int) -> Setting:
    """Search one setting."""
    best = partial(_best, scene=scene, parameters=parameters, shots=max(100, 2 * shots // 5))
    direct, plain, bank = (
        best("direct", LINE["backspin"]),
        best("direct", 0.0),
        best("bank", LINE["backspin"]),
    )
    estimated: Any = hoopgen.estimate(
        Scatter(direct.release, SEVENTY), parameters, scene=scene, shots=shots, seed=1
    )
    again = partial(_again, scene=scene, parameters=parameters, shots=shots)
    thrown = again(direct, "direct")
    made, valid = int(thrown.made.sum()), int(thrown.valid.sum())
    low, high = wilson_interval(made, valid, 0.95)
    return Setting(
        direct.release["elevation"],
        (made / valid, float(low), float(high)),
        paired(thrown, again(plain, "direct"), 0.95),
        paired(again(bank, "bank"), thrown, 0.95),
        estimated.rolled / shots,
        estimated.slip_left / shots,
    )


def _best(by: By, spin: float, scene: Any, parameters: Parameters, shots: int) -> Optimum:
    release = LINE | {"backspin": spin}
    over = ("elevation", "aim")
    model = Scatter(release, SEVENTY)
    return optimum(model, over, parameters, scene=scene, by=by, shots=shots, margins=())


def _again(best: Optimum, by: By, scene: Any, parameters: Parameters, shots: int) -> Any:
    """Throw a best release with the random numbers of seed 1."""
    more = {} if scene is None else {"scene": scene}
    player = Player(Scatter({}, SEVENTY), parameters, by, **more)
    return player.scored(best.arguments, shots, seed=1)


def section(shots: int = SHOTS) -> list[str]:
    """Return the section of the page."""
    found = {name: found_in(*setting, shots) for name, setting in SETTINGS.items()}
    return [
        "## Friction and restitutions: do they explain the differences?",
        "",
        "The table shows the free throw of the literature, for the same player with the same "
        f"errors. Each setting has its own search with {max(100, 2 * shots // 5):,} shots; "
        f"{shots:,} other shots estimate the result. Some parameters of `NBA_COURT` are assumed "
        "because no good measurements exist, so each row changes one of them. *Backspin* is the "
        "gain of 3 Hz over none, each with its own best release. *Bank − direct* is the best "
        "bank shot from the free-throw line minus the best direct shot, in points. *Capped* are "
        "shots whose bounces end with slip left; they do not count as made. The intervals are "
        "those of the simulation; in addition, the search may miss its best by about one point.",
        "",
        *table(
            ["", "direct", "release angle", "backspin", "bank − direct", "roll", "capped"],
            [[name, *_cells(one)] for name, one in found.items()],
        ),
        "The gain from backspin depends on friction and on the rim. With a friction of 0.3, or "
        "a rim of 0.8, it is three to four points smaller than otherwise; above a friction of "
        "0.5 these numbers show no effect. The disadvantage of the bank shot depends on "
        "friction, and most of all on the rim and the board. A rim that absorbs more energy "
        "improves direct shots. The best release angles differ by no more than the uncertainty "
        "of the search. In none of these settings is the bank shot from the line better than "
        "the direct shot. The restitutions and the friction of the literature are not known to "
        "us, so we cannot tell how much of its numbers they explain.",
        "",
    ]


def _cells(one: Setting) -> list[str]:
    chance, low, high = one.direct
    return [
        f"{format_percent(chance)} ({100 * low:.1f}–{100 * high:.1f})",
        f"{one.elevation / DEGREE:.1f}°",
        _points(one.by_spin),
        _points(one.by_bank),
        format_percent(one.rolled, 2),
        format_percent(one.slip_left, 2),
    ]


def _points(of: Paired) -> str:
    value, low, high = (100 * end for end in of)
    return f"{value:+.1f} ({low:+.1f} to {high:+.1f})".replace("-", "−")
