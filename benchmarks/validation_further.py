"""Further results of the literature, each with what agrees, what does not, and why: a section."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.stats import ks_2samp

import hoopgen
from benchmarks.free_throw import LINE, SEVENTY
from benchmarks.report import table
from benchmarks.validation_contacts import PICTURE, Contacts, first_contacts
from benchmarks.validation_results import THEIR_AIM, THEIR_GAP
from hoopgen import NBA, PAPER, Scatter
from hoopgen.core.units import DEGREE, FOOT, INCH
from hoopgen.study.questions.bank import bank_or_direct
from hoopgen.text.numbers import format_percent

Floats = NDArray[np.float64]

HEADING = "## Further results"

NOAH_ENTRY, NOAH_DEPTH, HOOP = 45 * DEGREE, 11 * INCH, 18 * INCH
"""Noah Basketball: the entry angle, the depth past the front of the rim, the hoop's diameter."""

PLAYERS, THROWS = 72, 21_964
"""Players and throws in McGrath's data."""

TRACKED, EACH = 20, 120
"""Players, and throws of each, in the data of Maymin, Maymin and Shen, who have 2,400 in all."""

FACTORS = {
    "speed": "speed",
    "azimuth": "left-right",
    "elevation": "angle",
    "backspin": "backspin",
    "height": "height",
}
"""Names of the factors that they compare between makes and misses, by variable."""

_SD = (0.05, 0.13)
"""m/s: standard deviations of the speed among the players of Slegers, Lee and Wong."""

SOURCES = (
    "Noah Basketball, The art and science of 45/11, https://noahbasketball.com/blog/"
    "the-art-and-science-of-45/11; The three measurements of the Noah Shooting System (2017).",
    "North Carolina State University (2011), Take your best shot, "
    "https://news.ncsu.edu/2011/03/take-your-best-shot/; Inside Science (2011), Dissecting the "
    "bank shot, http://www.insidescience.org/content/dissecting-bank-shot/1089.",
    "H. Okubo and M. Hubbard (2010), Basketball free-throw rebound motions, *Procedia Engineering* "
    "(text at sportdocbox.com/Pro_Basketball/69132651).",
    "J. McGrath and others (2025), Commanding the foul shot: a new ensemble of free throw metrics, "
    "arXiv:2512.08824 (the abstract).",
    "A. Maymin, P. Maymin and E. Shen (2011), The five factors of optimal free throw shooting, "
    "SSRN 1947166 (the abstract).",
    "M. Antali and others (2021), *Nonlinear Dynamics*, doi:10.1007/s11071-021-06507-y (the "
    "introduction).",
)


@dataclass(frozen=True)
class Further:
    """Numbers of hoopgen for the rows of the section."""

    best: Any
    noah: Any
    theirs: Any
    ends: Mapping[str, float]
    leads: Sequence[tuple[float, float, float, float, float]]
    contacts: Contacts
    command: tuple[float, float, float]
    factors: Mapping[str, NDArray[np.bool_]]
    rolls: tuple[float, float, float]


def further(shots: int) -> Further:
    """Compute them."""
    best = hoopgen.optimum(
        Scatter(LINE, SEVENTY), ("elevation", "aim"), PAPER, shots=shots, margins=()
    )
    aim = NOAH_DEPTH - 0.5 * HOOP
    noah = hoopgen.estimate(
        Scatter({**LINE, "entry": NOAH_ENTRY, "aim": aim}, SEVENTY), PAPER, shots=shots
    )
    theirs = hoopgen.estimate(
        Scatter({**LINE, "elevation": 52 * DEGREE, "aim": THEIR_AIM}, SEVENTY), PAPER, shots=shots
    )
    state = hoopgen.release(**best.arguments)[None]
    flown = hoopgen.simulate(state, PAPER)
    measured = hoopgen.measure(state, flown, PAPER, ("entry_angle", "depth"))
    ends = {name: float(one[0]) for name, one in measured.items()}
    return Further(
        best,
        noah,
        theirs,
        ends,
        _leads(shots // 5),
        first_contacts(),
        _command(),
        differing_factors(),
        _steady_rolls(),
    )


def _leads(shots: int) -> list[tuple[float, float, float, float, float]]:
    """Return distance (ft), angle (degrees) and bank less direct with its interval."""
    places = [(feet, angle) for angle in (0.0, 45.0) for feet in (9.0, 12.0, 15.0, 18.0)]
    spots = [(d * FOOT * math.cos(a * DEGREE), d * FOOT * math.sin(a * DEGREE)) for d, a in places]
    model = Scatter({name: LINE[name] for name in ("height", "backspin")}, SEVENTY)
    found = bank_or_direct(model, spots, PAPER, shots=shots)
    ends = [found[f"difference{end}"].values.tolist() for end in ("", "_low", "_high")]
    return [(*place, *row) for place, row in zip(places, zip(*ends, strict=True), strict=True)]


def roll(a: Any, rate: Any, speed: Any, spin: Any) -> tuple[Any, Any, Any, Any]:
    """Return the rates of angle, its rate, speed and spin of a ball that rolls on the ring."""
    g, ring = PAPER["gravity"], NBA["ring_radius"]
    radius = NBA["ball_radius"] + NBA["wire_radius"]
    turn = speed / (ring + radius * np.cos(a))
    push = -speed * turn * np.sin(a) + (0.4 * spin * turn - 0.6 * g) * np.cos(a)
    return rate, push / radius, rate * (radius * turn * np.sin(a) - 0.4 * spin), ring * rate * turn


def _command(seed: int = 1) -> tuple[float, float, float]:
    """Return correlations of one half of the throws of players with the share of the other half.

    Correlations with the share made in the second half: of the share made in the first half; of
    the root mean square distance from the best point at the ring in the first half, with the sign
    changed; and of that in an eighth of the throws.
    """
    random = np.random.default_rng(seed)
    each = THROWS // PLAYERS
    release = {**LINE, "elevation": 54 * DEGREE, "aim": 0.04}
    early, late, spread, few = [], [], [], []
    for player in range(PLAYERS):
        wide = {**SEVENTY, "speed": random.uniform(*_SD)}
        drawn = Scatter(release, wide).draw(0, each, player, PAPER)
        shots = hoopgen.simulate(drawn.states, PAPER)
        at = hoopgen.measure(drawn.states, shots, PAPER, ("depth", "left_right"))
        off = np.hypot(at["depth"] - 0.04, at["left_right"])
        made, half = np.asarray(shots.made), each // 2
        early.append(made[:half].mean())
        late.append(made[half:].mean())
        spread.append(np.sqrt(np.mean(off[:half] ** 2)))
        few.append(np.sqrt(np.mean(off[: half // 4] ** 2)))
    pairs = ((early, late), (spread, late), (few, late))
    first, second, third = (float(np.corrcoef(*pair)[0, 1]) for pair in pairs)
    return first, -second, -third


def differing_factors(seed: int = 1) -> dict[str, NDArray[np.bool_]]:
    """Return for which players each factor differs between makes and misses, (players,).

    The players differ in their spreads, each of which is between half and one and a half times
    the usual one. Factors are compared by the test of Kolmogorov and Smirnov at 5%.
    """
    random = np.random.default_rng(seed)
    release = {**LINE, "elevation": 54 * DEGREE, "aim": 0.04}
    usual = {**SEVENTY, "backspin": 0.3 * 2 * math.pi, "height": 0.02}
    found: dict[str, list[bool]] = {name: [] for name in FACTORS}
    for player in range(TRACKED):
        sd = {name: one * random.uniform(0.5, 1.5) for name, one in usual.items()}
        drawn = Scatter(release, sd).draw(0, EACH, 100 * seed + player, PAPER)
        made = np.asarray(hoopgen.simulate(drawn.states, PAPER).made)
        for name, differs in found.items():
            column = np.asarray(drawn.columns[name])
            differs.append(bool(ks_2samp(column[made], column[~made]).pvalue < 0.05))
    return {name: np.array(differs) for name, differs in found.items()}


def _steady_rolls() -> tuple[float, float, float]:
    """Return the angles between which steady rolls without spin along the normal are stable, rad.

    And the speed of one at 135 degrees, m/s. Of a ball that rolls round the ring at the angle a
    about the wire with the speed P, a' = 0 if P² = -(3/5) g rho cot(a). Near it P follows
    dP/da = (R sin(a)/rho) P - (2/5) s, s follows ds/da = (R_H/rho) P, as the spin is conserved
    along the wire; it is stable if the acceleration of a falls with a, and in contact if N > 0.
    """
    g, ring = PAPER["gravity"], NBA["ring_radius"]
    radius = NBA["ball_radius"] + NBA["wire_radius"]

    a = np.radians(np.linspace(90.5, 179.5, 8901))
    away = ring + radius * np.cos(a)
    speed = np.sqrt(-0.6 * g * away / np.tan(a))
    step = 1e-5
    more = speed + step * (radius * np.sin(a) / away) * speed
    less = speed - step * (radius * np.sin(a) / away) * speed
    spin = step * (ring / away) * speed
    still = np.zeros_like(a)
    above, below = roll(a + step, still, more, spin)[1], roll(a - step, still, less, -spin)[1]
    holds = g * np.sin(a) - speed * speed / away * np.cos(a) > 0.0
    stable = a[(above < below) & holds]
    at = float(np.sqrt(0.6 * g * (ring - radius * math.sqrt(0.5))))
    return float(stable.min()), float(stable.max()), at


def section(found: Further) -> list[str]:
    """Return the lines of the section."""
    depth = found.ends["depth"]
    gap = THEIR_AIM + THEIR_GAP - depth
    straight = [one for one in found.leads if one[1] == 0.0]
    aside = [one for one in found.leads if one[1] == 45.0]
    first, spread, few = found.command
    low, high, speed = found.rolls
    contacts = found.contacts
    touched = ", ".join(f"{name} {format_percent(one)}" for name, one in contacts.shares().items())
    near, far = contacts.ends()
    factors = np.sum(list(found.factors.values()), axis=0)
    none, some = int(np.sum(factors == 0)), int(np.sum((factors == 1) | (factors == 2)))
    each = ", ".join(f"{FACTORS[name]} {one.sum()}" for name, one in found.factors.items())
    rows = [
        [
            "Noah's 45/11",
            "entry 45°, 11 in past the front of the rim, by experience with tracked shots",
            f"best: entry {found.ends['entry_angle'] / DEGREE:.1f}°, "
            f"{(depth + 0.5 * HOOP) / INCH:.1f} in, {_share(found.best)}; "
            f"with 45/11 {_share(found.noah)}",
            "Agrees: with 45/11 as many go in as with our best, within the errors of both. The "
            "optimum is flat, by degrees and by inches, so this is no sharp test.",
        ],
        [
            "Tran and Silverberg's 5 cm",
            "5 cm between ball and back rim, 52°",
            f"best: {100 * gap:.1f} cm; with theirs {_share(found.theirs)}",
            "Both aim past the centre; within the range that is as good (first section).",
        ],
        [
            "Silverberg's figure 8",
            "the map of where which shot is better; we could not see it. Their university's "
            "account: the bank shot can be better by 20% at many angles up to about 12 ft and "
            "is better from the wings; straight-on shots from farther than 12 ft are not as well "
            "suited to it. No place is further than 15 ft",
            f"straight in front {_leads_in_words(straight)}; at 45° {_leads_in_words(aside)}",
            f"Agrees where theirs goes: in front the direct shot is better at {_better(straight)}, "
            f"at 45° at {_better(aside)}. The size does not: the player's errors to the side, the "
            "friction and the restitutions decide it (sections above), and theirs are not known.",
        ],
        [
            "Okubo and Hubbard's first contacts",
            "a map of regions, with bridge and board among them, over speeds from 7 m/s and angles "
            "from 45° to 65°; the text that we could read has lost the digits of the largest speed "
            "(8 or more), the spin, the release point and the limits of the regions",
            f"shares of the box up to 8 m/s, `NBA_COURT`, our free throw: {touched}; "
            f"{format_percent(float(contacts.made.mean()))} go in, rebounds come down at "
            f"{near:.1f} to {far:.1f} m (picture below)",
            "Board and bridge occur, as in theirs, and the bridge is a narrow band between the "
            "back of the ring and the board. The areas are not compared, as theirs cannot be had.",
        ],
        [
            "McGrath's command",
            f"of {THROWS:,} throws of {PLAYERS} players early command predicts later success "
            "better than early success; the abstract gives no coefficient",
            f"as many simulated throws, halves: correlation with the later share {spread:.2f} of "
            f"the spread at the ring, {first:.2f} of the share made ({few:.2f} of the spread of "
            "an eighth of the throws)",
            "Agrees. A distance says more than a yes or no; players differ only in the spread of "
            "the speed here, so real coefficients are lower.",
        ],
        [
            "Maymin, Maymin and Shen's five factors",
            f"of {TRACKED * EACH:,} throws of {TRACKED} players in NBA games usually one or two "
            "of speed, angle, left-right, backspin and height are most responsible for a player's "
            "misses, and they differ between players; the abstract gives no sizes",
            "as many simulated throws of players whose spreads are 0.5 to 1.5 times those of "
            "ours, 0.3 Hz and 2 cm. Between makes and misses one or two factors differ for "
            f"{some} players, none for {none}, more for {TRACKED - some - none}: {each}",
            "Agrees: throws of one player are too few to show more than the largest factors. "
            "Five tests at 5% find one difference by chance for every fourth player. The spreads "
            "are assumed, so which factor it is proves nothing.",
        ],
        [
            "Antali's rolling on the rim",
            "steady motions are a family of two parameters, found by Liu and others, and their "
            "stability was investigated; the introduction gives no numbers",
            f"without spin along the normal, stable and in contact from {low / DEGREE:.1f}° to "
            f"{high / DEGREE:.1f}° about the wire (90° is on top); {speed:.3f} m/s at 135°",
            "Agrees that they exist: they are the reason for ENDLESS. A yielding rim and rolling "
            "resistance, which we leave out, end them.",
        ],
    ]
    return [
        HEADING,
        "",
        "Each row has what agrees, what does not, and why. The player and the scene are those of "
        "the first section unless the row says otherwise. Where only an abstract, an introduction "
        "or a damaged text could be read, the row says so, and no number is taken from elsewhere.",
        "",
        *(
            line.replace("---:", "---")
            for line in table(["", "theirs", "hoopgen", "agreement, and why"], rows)
        ),
        *PICTURE,
    ]


def _better(rows: Sequence[tuple[float, float, float, float, float]]) -> str:
    """Return from how far the direct shot is better."""
    return " and ".join(f"{row[0]:g} ft" for row in rows if row[4] < 0.0) or "no distance"


def _share(found: Any) -> str:
    return f"{format_percent(found.probability)} ({100 * found.low:.1f}–{100 * found.high:.1f})"


def _leads_in_words(rows: Sequence[tuple[float, float, float, float, float]]) -> str:
    parts = [
        f"{100 * lead:+.1f} ± {50 * (high - low):.1f} at {feet:g} ft"
        for feet, _, lead, low, high in rows
    ]
    return ("bank less direct " + ", ".join(parts)).replace("-", "−")
