"""The page of `benchmarks.validation`: its words, its tables, its picture."""

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from benchmarks.free_throw import LINE, SEVENTY
from benchmarks.report import table
from benchmarks.validation_further import SOURCES as FURTHER_SOURCES
from benchmarks.validation_results import (
    ANGLES,
    STRAIGHTER,
    THEIR_AIM,
    THEIR_AXIS,
    Banks,
    Check,
    Curve,
    Floats,
    Results,
    Smallest,
    restitution_of_axis,
    rounded,
)
from hoopgen import PAPER
from hoopgen.core.units import DEGREE, FOOT, INCH, TURN
from hoopgen.plots.style import COLOURS, PAGE, style
from hoopgen.study.questions.optimum_result import Optimum
from hoopgen.text.numbers import format_percent

SOURCES = (
    "P. J. Brancazio (1981), Physics of basketball, *American Journal of Physics* 49, 356–365.",
    "C. M. Tran and L. M. Silverberg (2008), Optimal release conditions for the free throw in "
    "men's basketball, *Journal of Sports Sciences* 26, 1147–1155.",
    "L. M. Silverberg, C. M. Tran and T. M. Adams (2011), Optimal targets for the bank shot in "
    "men's basketball, *Journal of Quantitative Analysis in Sports* 7 (1), article 3, "
    "doi:10.2202/1559-0410.1299.",
    "L. M. Silverberg (2013), The anatomy of the bank shot in men's basketball, *Journal of "
    "Quantitative Analysis in Sports* 9 (1), 77–85, doi:10.1515/jqas-2012-0050.",
    "N. Slegers, D. Lee and G. Wong (2021), The relationship of intra-individual release "
    "variability with distance and shooting performance in basketball, *Journal of Sports Science "
    "and Medicine* 20, 508–515, doi:10.52082/jssm.2021.508.",
    "R. G. Newcombe (1998), Improved confidence intervals for the difference between binomial "
    "proportions based on paired data, *Statistics in Medicine* 17, 2635–2650.",
)


# --------------------------------------------------------------------------------- in words


def share(value: float, low: float, high: float) -> str:
    """Format a probability with its interval."""
    return f"{format_percent(value)} ({100 * low:.1f}–{100 * high:.1f})"


def points(value: float, low: float, high: float) -> str:
    """Format a difference of probabilities with its interval."""
    return f"{100 * value:+.1f} ({100 * low:+.1f} to {100 * high:+.1f})".replace("-", "−")


def angles(best: Optimum) -> str:
    """Format the best angle, and the range of those as good."""
    low, high = best.flat["elevation"]
    return f"{best.release['elevation'] / DEGREE:.1f}° ({low / DEGREE:.1f}–{high / DEGREE:.1f})"


def aims(best: Optimum) -> str:
    """Format the best aim, and the range of those as good."""
    low, high = (100 * end for end in best.flat["aim"])
    return f"{100 * best.release['aim']:.1f} cm ({low:.1f} to {high:.1f})".replace("-", "−")


def chance(best: Optimum) -> str:
    """Format its probability."""
    return share(best.probability, best.low, best.high)


# --------------------------------------------------------------------------------- sections


def page(results: Results, coverage: Sequence[str], more: Sequence[str]) -> str:
    """Return the whole page, with the lines on coverage and on further results."""
    lines = [
        *_head(results),
        *closed_forms(results.checks, results.entries),
        *_line(results),
        *_bank(results),
        *_scatter(results),
        *results.court,
        *more,
        *coverage,
        *_left_out(),
        "## Sources",
        "",
        *(f"- {source}" for source in (*SOURCES, *FURTHER_SOURCES)),
    ]
    return "\n".join(lines) + "\n"


def _head(results: Results) -> list[str]:
    sd = SEVENTY
    return [
        "# Validation",
        "",
        "This page compares results of hoopgen with those of the literature. `make validate` "
        "computes every number of hoopgen on this page anew; on one machine it gives the same "
        "bytes each time.",
        "",
        f"By default the scene is the preset `PAPER` (restitution {PAPER['restitution']:.2f}), "
        f"and the player releases the ball {LINE['height'] / FOOT:g} ft above the floor with "
        f"{LINE['backspin'] / TURN:g} Hz of backspin. A free throw is "
        f"{LINE['distance'] / FOOT:g} ft from the ring's centre. The player's errors are normal "
        f"and independent, with standard deviations (SD) of {sd['speed']:.2f} m/s in speed, "
        f"{sd['elevation'] / DEGREE:.1f}° in release angle and {sd['azimuth'] / DEGREE:.1f}° to "
        "the side.",
        "",
        "The best release is the result of `hoopgen.optimum` with the random numbers of seed 0. "
        "Its probability is estimated again with those of seed 1, because the estimate of the "
        f"search itself would be too high. Parentheses contain 95% intervals ({results.shots:,} "
        "shots, Wilson; differences over the same random numbers, Newcombe), and after angles "
        "and aims the range in which the probability stays within one point of the best. A shot "
        f"that is capped after 40 contacts does not count as made ({results.line.theirs.capped} "
        f"of the {results.line.theirs.shots:,} shots below at 52° and {100 * THEIR_AIM:.1f} cm).",
        "",
    ]


def closed_forms(checks: Sequence[Check], entries: Sequence[Smallest]) -> list[str]:
    steeper = [(one.wire - one.edge) / DEGREE for one in entries]
    return [
        "## Closed forms",
        "",
        "The slowest free throw through the centre of the ring has, for the distance L and the "
        "rise h, the angle 45° + atan(h/L)/2 and speed² = g (h + sqrt(h² + L²)), and it "
        "satisfies tan(entry) = tan(release) − 2h/L (Brancazio 1981). The place of a minimum is "
        "accurate to the square root of the unit roundoff, its value to the unit roundoff.",
        "",
        *table(
            ["", "hoopgen", "closed form", "difference"],
            [
                [
                    check.what,
                    *(
                        # z: no minus sign for what is rounded to zero
                        f"{value:z.9f} {check.unit}".replace(" °", "°").replace("-", "−")
                        for value in (check.ours, check.closed)
                    ),
                    f"{check.ours - check.closed:.1e}".replace("-", "−"),
                ]
                for check in checks
            ],
        ),
        "The smallest entry angle is usually given as asin(ball Ø / ring Ø), with the inner "
        "diameter of the ring: about 32°. This formula describes a ball between two sharp "
        "edges. The rim is a round wire, and the ball must also clear its lower and its upper "
        "side. The angle is then asin((ball radius + wire radius) / radius of the wire's centre "
        f"circle), which is steeper by {min(steeper):.1f}° to {max(steeper):.1f}°. The engine "
        "finds this angle by bisection on swishes in straight flight. A free throw falls while "
        "it passes the ring, so it is less steep than its entry angle at the front and steeper "
        "at the back. The last column gives the smallest entry angle of a swish that comes down "
        "anywhere within the ring.",
        "",
        *table(
            ["", "sharp edge", "round wire", "engine, straight", "engine, free throw"],
            [
                [
                    f"`{one.name}`",
                    *(
                        f"{angle / DEGREE:.{digits}f}°"
                        for angle, digits in (
                            (one.edge, 3),
                            (one.wire, 6),
                            (one.straight, 6),
                            (one.thrown, 3),
                        )
                    ),
                ]
                for one in entries
            ],
        ),
    ]


def _line(results: Results) -> list[str]:
    line, best = results.line, results.line.best
    most = max(line.by_spin)
    cost = best.lead(line.centred)
    gain = line.by_spin[most].lead(best)
    loss = best.lead(line.by_spin[0])
    theirs = line.theirs
    high, low = line.by_height[max(line.by_height)], line.by_height[min(line.by_height)]
    return [
        "## The free throw: Tran and Silverberg 2008",
        "",
        *table(
            ["", "theirs", "hoopgen"],
            [
                ["release angle", "52°", angles(best)],
                [
                    "aim past the centre",
                    f"{100 * THEIR_AIM:.1f} cm: 5 cm are left between ball and back rim",
                    aims(best),
                ],
                ["aiming at the centre costs", "about 3 points", points(*cost)],
                [
                    "backspin",
                    "about 3 Hz",
                    f"3 Hz over none {points(*loss)}; {most} Hz over 3 Hz {points(*gain)}",
                ],
                [
                    "release height",
                    "as high as the player is steady",
                    f"{max(line.by_height):g} ft over {min(line.by_height):g} ft "
                    f"{points(*high.lead(low))}",
                ],
                [
                    f"their release, 52° and {100 * THEIR_AIM:.1f} cm",
                    "70%, assumed in 2011",
                    share(theirs.probability, theirs.low, theirs.high),
                ],
                ["our best release", "", chance(best)],
            ],
        ),
        *table(
            ["backspin", "release angle", "aim past the centre", "success"],
            [[f"{spin} Hz", angles(o), aims(o), chance(o)] for spin, o in line.by_spin.items()],
        ),
        *table(
            ["release height", "release angle", "aim past the centre", "success"],
            [[f"{h:g} ft", angles(o), aims(o), chance(o)] for h, o in line.by_height.items()],
        ),
        "Backspin reduces the speed with which the ball leaves rim and board. The restitution "
        "of their model is not known to us. The difference between the largest and the smallest "
        f"success is {_spread(line.by_spin)} points in the table of backspins and "
        f"{_spread(line.by_height)} points in the table of heights. In the following table of "
        f"restitutions it is {_spread(line.direct)} points for direct shots and "
        f"{_spread(line.bank)} points for bank shots. The last two columns give the best bank "
        "shot from the free-throw line and its difference from the direct shot in points.",
        "",
        *table(
            [
                "restitution",
                "direct: release angle",
                "aim",
                "success",
                "bank shot",
                "bank − direct",
            ],
            [
                [
                    *(f"{e:.1f}", angles(o), aims(o), chance(o), chance(line.bank[e])),
                    points(*line.bank[e].lead(o)),
                ]
                for e, o in line.direct.items()
            ],
        ),
        "![Success against backspin, and against the scatter of the speed](validation-throws.svg)",
        "",
    ]


def _spread(found: Mapping[float, Optimum] | Mapping[int, Optimum]) -> str:
    chances = [best.probability for best in found.values()]
    return f"{100 * (max(chances) - min(chances)):.1f}"


def _bank(results: Results) -> list[str]:
    found, livelier, straighter = results.banks, results.livelier, results.straighter
    data = found.places
    better = int((data.difference_low > 0).sum())
    worse = int((data.difference_high < 0).sum())
    return [
        "## Bank shots: Silverberg, Tran and Adams 2011, Silverberg 2013",
        "",
        "The table compares, for each place, the best direct shot with the best bank shot, each "
        f"over release angle, speed and direction ({results.bank_shots:,} shots per place). It "
        "gives the bank shot minus the direct shot in points. The angle 0° is straight in front "
        "of the board, 90° along the baseline. Each interval, and each verdict counted below, "
        "has its own confidence of 95%. The place with the largest lead of the bank shot was "
        "selected with these random numbers, so its lead is estimated with others (seed 2).",
        "",
        *_grid(found),
        *table(
            ["", "theirs", "hoopgen"],
            [
                [
                    "where the bank is better",
                    "intermediate ranges, towards the sides",
                    f"at {better} of {data.sizes['place']} places (worse at {worse}), each at 95%",
                ],
                [
                    "largest lead of the bank shot",
                    "20 points",
                    ", at ".join(_most(found)),
                ],
                ["aim points", "on a V", _v(found)],
                [
                    "common axis behind the board",
                    f"{THEIR_AXIS / INCH:.3f} in",
                    f"{_behind(found)} in, missed by {found.releases.spread * 1000:.0f} mm (rms)",
                ],
            ],
        ),
        "![Best bank shots: where the ball touches the board, and from where](validation-bank.svg)",
        "",
        "The axis is the point of the floor plan where the directions of all best bank releases "
        "cross, by least squares. It has a physical reason. The board keeps 3/5 of the ball's "
        "velocity along the board, if the ball does not spin about the vertical, and the "
        "restitution e of the velocity towards it (Eqs. 11-17). The releases that bring the "
        "ball to the centre of the ring therefore all point at an axis 0.6 (a − R)/e − R behind "
        "the board, where a is the distance of the ring's centre from the board and R the "
        f"radius of the ball. This is {found.closed / INCH:.2f} in for restitution "
        f"{found.restitution:.2f}. Their axis corresponds to a restitution of "
        f"{restitution_of_axis(THEIR_AXIS):.3f}. With this restitution and the "
        f"{livelier.places.sizes['place']} outermost places, our axis is {_behind(livelier)} in "
        f"behind the board, and the bank shot is better by at most {_most(livelier)[0]} points. "
        "The formula describes balls that come to the centre of the ring; the best shots come "
        f"down {100 * found.past:.0f} cm from it on average. Lines to the points that the ball "
        "touches, instead of lines along its flight, cross "
        f"{(-PAPER['board_distance'] - found.touches.x) / INCH:.1f} in behind the board and miss "
        f"this point by {found.touches.spread * 1000:.0f} mm.",
        "",
        "The advantage of the bank shot depends on the kind of a player's errors. Of their "
        "players we know the 70% of free throws, but not the standard deviations. A bank shot "
        "forgives errors of speed and angle more than a direct shot, and errors to the side "
        "about as much (Silverberg 2013). A player who is straighter and has a less steady "
        f"speed, with SDs of {STRAIGHTER['speed']:.2f} m/s, "
        f"{STRAIGHTER['elevation'] / DEGREE:.1f}° and {STRAIGHTER['azimuth'] / DEGREE:.1f}° to "
        f"the side, makes {chance(results.line.straighter)} of the best free throws. From the "
        f"outermost places this player gains at most {_most(straighter)[0]} points.",
        "",
    ]


def _grid(found: Banks) -> list[str]:
    data = found.places
    rows = []
    difference = data.difference.values.reshape(-1, len(ANGLES))
    low = data.difference_low.values.reshape(-1, len(ANGLES))
    high = data.difference_high.values.reshape(-1, len(ANGLES))
    away = np.hypot(data.x, data.y).values.reshape(-1, len(ANGLES))[:, 0]
    for distance, *row in zip(away, difference, low, high, strict=True):
        cells = [
            f"{100 * value:+.1f} ± {50 * (most - least):.1f}".replace("-", "−")
            for value, least, most in zip(*row, strict=True)
        ]
        rows.append([f"{distance / FOOT:.0f} ft", *cells])
    return table(["", *(f"{angle}°" for angle in ANGLES)], rows)


def _most(found: Banks) -> tuple[str, str]:
    """Return the greatest lead of the bank, and its place."""
    data = found.places.isel(place=found.most)
    away, angle = math.hypot(data.x, data.y) / FOOT, math.atan2(data.y, data.x) / DEGREE
    return points(*found.lead), f"{away:.0f} ft and {angle:.0f}°"


def _v(found: Banks) -> str:
    return (
        f"the nearest V: {100 * found.foot:.0f} cm above the ring at the middle, rising "
        f"{100 * found.slope:.0f} cm in 100; missed by {1000 * found.off:.0f} mm (rms)"
    )


def _behind(found: Banks) -> str:
    return f"{(-PAPER['board_distance'] - found.releases.x) / INCH:.2f}"


def _scatter(results: Results) -> list[str]:
    speed, angle = results.by_speed, results.by_angle
    sure, unsure = (100 * speed.probability[end] for end in (0, -1))
    fine, coarse = (100 * angle.probability[end] for end in (0, -1))
    return [
        "## Scatter: Slegers, Lee and Wong 2021",
        "",
        "Among twelve players the SD of the release speed was between 0.05 and 0.13 m/s, and "
        "that of the release angle 1.3° ± 0.26° in free throws. The number of made shots "
        "correlated with the SD of the speed (r = −0.88) and not with that of the angle. The "
        "tables simulate one release, our best free throw rounded as in the table above "
        f"({_rounded(results)}), with one standard deviation varied over the range of the "
        "players:",
        "",
        *table(["SD of the speed", "success"], _rows(speed, lambda sd: f"{sd:.2f} m/s")),
        *table(["SD of the angle", "success"], _rows(angle, lambda sd: f"{sd / DEGREE:.2f}°")),
        *table(
            ["", "theirs", "hoopgen"],
            [
                [
                    "success, from the steadiest speed to the least steady",
                    "r = −0.88",
                    f"from {sure:.0f} to {unsure:.0f}%",
                ],
                [
                    "success, from the steadiest angle to the least steady",
                    "unrelated",
                    f"from {fine:.0f} to {coarse:.0f}%",
                ],
                [
                    "a shooter with 0.07 m/s, 1.3° and 1.0° to the side",
                    "makes about 70%",
                    chance(results.line.best),
                ],
            ],
        ),
    ]


def _rounded(results: Results) -> str:
    best = rounded(results.line.best)
    return f"{best['elevation'] / DEGREE:.1f}°, {100 * best['aim']:.1f} cm".replace("-", "−")


def _rows(curve: Curve, said: Callable[[float], str]) -> list[list[str]]:
    columns = (curve.sd, curve.probability, curve.low, curve.high)
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return [[said(sd), share(*rest)] for sd, *rest in rows]


def _left_out() -> list[str]:
    return [
        "## Where the model differs from the court",
        "",
        "This section describes `HOOP`, the article's scene, which most of this page uses:",
        "",
        "- **One restitution** for all bodies and all speeds. In reality the rim and the board "
        "have different restitutions, which also differ from hoop to hoop; the tables above "
        "show the effect.",
        "- **Perfect grip.** A ball that slips changes its spin and its tangential velocity "
        "less, so backspin has less effect.",
        "- **No air**, hence no drag and no lift from spin. Slegers, Lee and Wong include drag "
        "in the paths that they fit.",
        "- **No net, no edges of the board, and a rim that does not yield.** A rim that yields "
        "absorbs energy from the ball, as a lower restitution does.",
        "- **Normal, independent errors.** The errors of a player need be neither. "
        "`hoopgen.Scatter` accepts correlations, and `hoopgen.Resample` measured releases.",
        "",
    ]


# ---------------------------------------------------------------------------------- picture


def throw_picture(results: Results) -> Figure:
    """Success against backspin, and against the scatter of the speed."""
    spins = results.line.by_spin
    chances = np.array([[o.probability, o.low, o.high] for o in spins.values()]).T
    with style():
        figure = Figure(figsize=(PAGE, 2.5), layout="constrained")
        left, right = figure.subplots(1, 2, sharey=True)
        _points(left, np.array(list(spins), dtype=np.float64), *chances)
        left.set_xlabel("backspin (Hz)")
        left.set_ylabel("success (%)")
        speed = results.by_speed
        _points(right, speed.sd, speed.probability, speed.low, speed.high)
        right.set_xlabel("standard deviation of the release speed (m/s)")
    return figure


def _points(axes: Axes, x: Floats, value: Floats, low: Floats, high: Floats) -> None:
    colour = COLOURS["path"]
    axes.errorbar(
        x,
        100 * value,
        yerr=100 * np.stack([value - low, high - value]),
        fmt="o-",
        color=colour,
        markersize=3.5,
        linewidth=0.8,
        capsize=2.5,
        elinewidth=0.8,
    )
    axes.grid(color="#DDDDDD", linewidth=0.5)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
