"""The notation: how arguments of kernels are written, and what they are."""

from __future__ import annotations

import re
from typing import NamedTuple

AXES = "xyz"


class Letter(NamedTuple):
    """How an argument is written, and what it is."""

    latex: str
    meaning: str


FLIGHTS = {
    "t": Letter("t", "time since the last contact"),
    "end": Letter(r"t_\mathrm{end}", "end of the window that is searched"),
    "horizon": Letter("T", "no event later than this is wanted"),
    "leaving": Letter(r"\ell", "1 if the flight starts on this very surface, else 0"),
    "extent": Letter(
        r"\lVert\mathbf{r}\rVert_1", "sum of the sizes of the coordinates at the start"
    ),
    "speed": Letter(r"\lVert\mathbf{v}\rVert_1", "sum of the sizes of the velocities at the start"),
    "gap": Letter(
        "F",
        "gap: how far the ball is from a contact, as the searched function says; in contact, "
        "as the distance does",
    ),
    "rate": Letter("F'", "rate of the gap"),
    "bend": Letter("F''", "bend of the gap"),
    "margin": Letter("m", "bound on the error of a gap"),
    "rate_margin": Letter("m'", "bound on the error of its rate"),
    "flat": Letter("m_F", "bound on the error of the gap itself"),
    "tilt": Letter(r"m_\ell", "bound on the error of the gap over t, on leaving"),
    "leaving_margin": Letter(r"m_\ell", "the same"),
    "ceiling": Letter("C", "bound on the size of $F''$"),
    "steady": Letter("K", "first constant of $F''$ in the search of a ring"),
    "swing": Letter("W", "second constant of $F''$ there"),
    "rho_start": Letter(r"\rho_0", "distance from the axis at the start"),
    "step": Letter(r"\Delta t", "step of a search, in which there is no root"),
    "next": Letter("t_+", "time after that step"),
    "root": Letter("t_N", "Newton's value of the root"),
    "clearance": Letter(r"\chi", "positive where a root is certain"),
    "clear": Letter(r"\chi_0", "positive where a surface is certainly missed"),
    "arrival": Letter("t_r", "root that a search has found, infinite if none"),
    "refined": Letter("t_R", "that root by one more step of Newton's method"),
    "candidate": Letter("t_p", "root that counts if it lies within the bounds"),
    "side": Letter(
        r"\vartheta", "1 outside the surface, -1 where its rest would be, beyond its bounds"
    ),
    "after": Letter("t_1", "time up to which a search has come"),
    "lasting": Letter(r"\tau", "time since a search in single precision began"),
    "apex": Letter("t_a", "time at which a plane's gap is extreme"),
    "height": Letter("F_a", "the gap then"),
    "share": Letter(
        r"\sigma", "error, relative to the size of the flight, that a search allows for"
    ),
    "pad": Letter("T_+", "how long the horizon is after the earliest arrival"),
    "lost": Letter(r"\varpi", "positive where the search's bounds do not hold"),
    **{
        f"middle_{axis}": Letter(
            rf"\bar{{r}}_{axis}", f"middle of the box that a flight is in, along {axis}"
        )
        for axis in AXES
    },
    **{
        f"reach_{axis}": Letter(rf"\varrho_{axis}", f"half the size of that box along {axis}")
        for axis in AXES
    },
    **{
        f"later_middle_{axis}": Letter(
            rf"\bar{{r}}'_{axis}", f"the same of the box of a flight's second half, along {axis}"
        )
        for axis in AXES
    },
    **{
        f"later_reach_{axis}": Letter(rf"\varrho'_{axis}", f"half its size along {axis}")
        for axis in AXES
    },
    **{
        f"least_{axis}": Letter(
            rf"\check{{c}}_{axis}",
            f"largest coordinate of a group's bodies against {axis}",
        )
        for axis in AXES
    },
    **{
        f"most_{axis}": Letter(
            rf"\hat{{c}}_{axis}", f"largest coordinate of a group's bodies along {axis}"
        )
        for axis in AXES
    },
    **{
        f"wide_{axis}": Letter(
            rf"\hat{{h}}_{axis}", f"half the size of a group's largest body along {axis}"
        )
        for axis in AXES
    },
    "measured": Letter(r"\Lambda", "sum of the sizes of the scene's lengths"),
    "lengths": Letter(r"\Lambda_s", "the same, of a shot that has begun"),
    "blur": Letter(r"\epsilon_0", "what a length at the start may be off by"),
}
"""Of one surface along one flight."""

LOOP = {
    "index": Letter("j", "index of the surface that is looked at"),
    "last": Letter(r"j_\ell", "index of the surface that was touched last, -1: none"),
    "time": Letter("t_j", "time of an arrival on a surface"),
    "when": Letter(r"t^\ast", "time of the earliest arrival so far"),
    "which": Letter(r"j^\ast", "its surface, -1: none"),
    "delay": Letter(r"\delta", "bound on how far a computed arrival is from the true one"),
    "late": Letter(r"\delta^\ast", "that of the earliest arrival"),
    "doubt": Letter(
        r"\theta",
        "earliest time of a decision that lies within its error; of a release, positive if it is",
    ),
    "excess": Letter(r"\xi", "by how much errors or numbers exceed what is allowed for"),
    "position_error": Letter(
        r"\varepsilon_r", "bound on the error of each coordinate at the start"
    ),
    "velocity_error": Letter(r"\varepsilon_v", "bound on the error of each velocity at the start"),
    "spin_error": Letter(r"\varepsilon_\omega", "bound on the error of each component of the spin"),
    "time_error": Letter(r"\varepsilon_c", "bound on the error of the time since the release"),
    "contacts": Letter("k", "how many contacts there were, this one too"),
    "most_contacts": Letter(r"k_{\max}", "how many a shot may have"),
    "count": Letter("k_b", "how many there were with a body"),
    "body": Letter(r"b^\ast", "body of the event, -1: none"),
    "first": Letter("b_1", "body that was touched first, -1: none"),
    "clock": Letter("t_c", "time since the release"),
    "clock_error": Letter(r"\varepsilon_t", "what the contacts' times are off by, summed"),
    "curving": Letter(r"\kappa", "curvature of the surface, if it is met twice running"),
    **{
        f"left_n{axis}": Letter(
            rf"n^0_{axis}", f"normal along {axis} where the flight began, if on the same surface"
        )
        for axis in AXES
    },
    "lifting": Letter(r"\varphi", "the share of the worst than which errors are no smaller"),
    "shift": Letter(r"\varsigma", "error of the position at a contact, at worst after one flight"),
    "turn": Letter(r"\nu", "error of the normal, at worst after one flight"),
    "reached": Letter(r"o^\ast", "the outcome of an event that ends the shot"),
    "time_limit": Letter(r"t_{\max}", "time since the release at which a shot ends"),
    "slack": Letter(r"\epsilon", "bound on the error of a length at a computed arrival"),
    "through": Letter(
        r"\phi", "1 for a ball down through the ring's disc, -1 for one that came up"
    ),
    "outcome": Letter(r"o", "how the shot ended, -1: it has not"),
    "uncertain": Letter(r"\upsilon", "1 if some decision of the shot lies within its error"),
    "claims": Letter(r"\gamma_e", "positive where the errors at the end are asked for"),
    "allowed": Letter(r"\alpha_p", "positive where the parameters are allowed"),
    "valid": Letter(r"\alpha_s", "positive where the ball overlaps no surface"),
    "permitted": Letter(r"\text{permitted}", "the parameters are allowed and in range"),
    "in_range": Letter(r"\text{in range}", "no number of the release is too large"),
    "arrives": Letter(r"\text{arrives}", "there is an arrival on the surface"),
    "unsure": Letter(r"\text{unsure}", "a decision about it lies within its error"),
    "hit": Letter(r"\text{hit}", "the search has come to a root"),
    "sure": Letter(r"\text{sure}", "and that root is certain"),
    "met": Letter(r"\text{met}", "it is a root at which the ball comes in"),
    "searching": Letter(r"\text{searching}", "there is a window to search"),
    "reachable": Letter(r"\text{reachable}", "the flight comes near the surface"),
    "since": Letter(r"t_0", "when a search in single precision began"),
    "sound": Letter(r"\text{sound}", "nothing of it over- or underflows"),
    "served": Letter(r"\text{served}", "a search in single precision began"),
    "parting": Letter("F'_0", "rate of the gap at the start of the flight"),
    "drift": Letter(r"\rho'_0", "rate of the distance from the axis at the start of the flight"),
    "grit": Letter(r"m_\Gamma", r"bound on the error of $\Gamma = (F_\ell/t - F'_0)/t$"),
    "jerk": Letter("J", "bound on the size of $F'''/6$"),
    "fits": Letter(r"\text{fits}", "sizes are such that single precision serves"),
    "sunk": Letter(r"\text{sunk}", "the ball is on the other side than the search took it to be"),
    "vague": Letter(r"\text{vague}", "it is to be looked at with smaller errors allowed"),
    "certain": Letter(r"\text{certain}", "what was found is certain"),
    "ends": Letter(r"\text{ends}", "the event is on a plane that ends a shot"),
    "edge": Letter(r"\text{edge}", "which end is reached lies within its error"),
    "touches": Letter(r"\text{touches}", "the event is a contact"),
    "mine": Letter(r"\text{mine}", "the event is on a surface of the kind that is looked at"),
}
"""Of the event loop; the last are truths."""

IN_CONTACT = {
    "held": Letter("j_h", "index of the surface that the ball stays on, -1: none"),
    "mode": Letter(r"\psi", "1, 2, 3: contact begins, goes on, ends; 0: the ball is in flight"),
    "assured": Letter(
        r"\alpha", "1 where all further bounces are on the surface touched last, else 0"
    ),
    "bent_x": Letter("b_x", "1 where the surface is curved across x, else 0"),
    "bent_y": Letter("b_y", "the same of y"),
    "bent_z": Letter("b_z", "the same of z"),
    "per_reach": Letter(
        r"\kappa_T",
        "one over the radius of the tube that the centre stays on, negative on its inside",
    ),
    "turn_rate": Letter("s", "spin about the normal, times the ball's radius"),
    "rolled_x": Letter(r"v^\circ_x", "velocity that a contact which grips would leave, along x"),
    "rolled_y": Letter(r"v^\circ_y", "along y"),
    "rolled_z": Letter(r"v^\circ_z", "along z"),
    "turning_x": Letter(r"\dot n_x", "rate at which the normal turns, along x"),
    "turning_y": Letter(r"\dot n_y", "along y"),
    "turning_z": Letter(r"\dot n_z", "along z"),
    "slip": Letter(r"\lvert\mathbf{u}\rvert", "speed of the contact point"),
    "bounce": Letter(r"v_\perp", "speed off the surface"),
    "nearest": Letter("d_1", "distance to what is next to the ball"),
    "wedge": Letter("d_2", "how far the ball gets from what it is pressed onto besides"),
    "spare": Letter(r"t_f", "how long a ball that leaves a surface certainly meets nothing else"),
    "swerve": Letter(r"\ddot d_r", "second derivative of the distance of a ball that rolls"),
    "facing": Letter("c_n", "cosine of the angle between the normals of two surfaces"),
    "press": Letter("N_r", "normal force on a ball that rolls on, per unit mass"),
    "weight": Letter("a_n", "free fall along the normal"),
    "drag": Letter("f", "friction of a ball that rolls, per unit mass; in a step its square"),
    "drag_rate": Letter(r"\dot f", "its rate"),
    "thrust_x": Letter("a_x", "acceleration of a ball that rolls on, along x"),
    "thrust_y": Letter("a_y", "along y"),
    "thrust_z": Letter("a_z", "along z"),
    "strain": Letter("E", r"by how much friction is too little for rolling, $f^2 - (\mu N)^2$"),
    "strain_rate": Letter(r"\dot E", "its rate"),
    "taut": Letter("E_0", "the same a step before; infinite: not known"),
    "taut_rate": Letter(r"\dot E_0", "its rate then"),
    "taut_clock": Letter("t_E", "when that was"),
    "grip_lost": Letter("t_g", "when friction first was too little, infinite: never"),
    "rolls": Letter("k_r", "how many times the ball began to roll"),
    "near": Letter(r"\epsilon_s", "half the width of what counts as on a seam"),
    "nearing": Letter(r"\dot d", "rate of the distance"),
    "dent": Letter(r"\kappa_d", "how fast the distance bends down at most, by the squared speed"),
    "lift": Letter(r"\ddot d", "second derivative of the distance along a flight"),
    "surge": Letter("d^{(3)}", "the third"),
    "snap": Letter("d^{(4)}", "the fourth"),
    "force": Letter("N", "normal force per unit mass"),
    "force_rate": Letter("N'", "its rate"),
    "force_bend": Letter("N_2", "bound on its second derivative within a step"),
    "brace": Letter(r"\eta_f", r"twice $\mathbf{f}\cdot\dot{\mathbf{n}}$: what ends with friction"),
    "stride": Letter(r"\Delta\tau", "step of a ball in contact"),
    "strongest": Letter(r"\hat a", "bound on its acceleration within the step"),
    "fastest": Letter("U", "bound on its speed within the step"),
    "missed": Letter(r"\epsilon_h", "what the series leaves out of its velocity in the step"),
    "apart": Letter(r"\zeta", "how many times its errors a neighbouring motion is away"),
    "settles": Letter(r"\text{settles}", "the ball stays on the surface"),
    "nearly": Letter(r"\text{nearly}", "its bounces are small enough for that"),
    "lodges": Letter(r"\text{lodges}", "it would, but is wedged between it and another"),
    "slides": Letter(r"\text{slides}", "its bounces end with slip left"),
    "parts": Letter(r"\text{parts}", "nothing presses it onto the surface that it hardly leaves"),
    "loses": Letter(r"\text{loses}", "friction is too little for the first time"),
    "kept": Letter(r"\text{kept}", "the ball is in contact"),
    "rolling": Letter(r"\text{rolling}", "the ball goes on in contact"),
    "began": Letter("t_b", "time since the release at which a turn in contact began"),
    "over": Letter(r"\text{over}", "the ball is not below the ring's disc"),
    "rests": Letter(r"\text{rests}", "nothing moves"),
    "circled": Letter(r"\iota", "1: since a turning point on a ring it certainly stays there"),
    "climb": Letter("A", "rate of the angle around the wire"),
    "leap": Letter(r"\Delta\tau'", "half a step; back from the end of the step: below 0"),
    "sway": Letter(r"\hat a_2", "bound on the acceleration in the ring's section within the step"),
    "berth": Letter("d_3", "distance to what is next to the ball, at any azimuth"),
    "circling": Letter(r"\text{circling}", "the ball goes on in contact with a ring"),
    "endless": Letter(r"\text{endless}", "it does so for ever"),
}
"""Of a ball that stays in contact; the last are truths."""

SERIES = {
    **{f"v{axis}": Letter(f"v_{axis}", f"velocity along {axis}") for axis in AXES},
    **{f"n{axis}": Letter(f"n_{axis}", f"normal along {axis}") for axis in AXES},
    **{
        f"t{axis}": Letter(f"p_{axis}", rf"$\mathbf{{n}} \times \dot{{\mathbf{{n}}}}$ along {axis}")
        for axis in AXES
    },
    "turn_rate": Letter("s", "spin about the normal, times the ball's radius"),
    "lift": Letter(r"\mathcal{L}", "acceleration along the normal but for what friction leaves"),
    "cosine": Letter(r"c_\alpha", "cosine of the angle around the wire, from outwards"),
    "sine": Letter(r"s_\alpha", "its sine"),
    "climb": Letter("A", "its rate"),
    "along": Letter("P", "speed along the ring"),
    "cos": Letter(r"c_\phi", "cosine of the azimuth"),
    "sin": Letter(r"s_\phi", "its sine"),
    "near": Letter("Q", r"$1/\rho$"),
    "omega": Letter(r"\Omega", "rate of the azimuth"),
    "around": Letter("X", r"$A \Omega$"),
    "tilted": Letter("Y", r"$P s_\alpha - \beta s c_\alpha$, $\beta$ being the share of rolling"),
}
"""Of the series of a ball that rolls: coefficients have their order as an exponent in brackets."""

STUDIES = {
    "slope": Letter(r"\gamma", "tangent of the angle of release above the horizontal"),
    "entry": Letter(
        r"\gamma^\downarrow", "tangent of the angle below the horizontal at the wanted point"
    ),
    "release_speed": Letter(r"\lvert\mathbf{v}\rvert", "speed at release"),
    "reach": Letter(r"\Delta r", "horizontal distance from the release to the wanted point"),
    "rise": Letter(r"\Delta z", "height of the wanted point above the release"),
    "level": Letter(r"\bar z", "height above the origin"),
    "half": Letter(r"\bar t", "half the width of an interval of time"),
    "place_x": Letter("x_p", "place on the floor plan, x"),
    "place_y": Letter("y_p", "place on the floor plan, y"),
    "restitution": Letter(r"\hat e", "restitution of the impact through the contact frame"),
}
"""Of what studies and readers ask."""

LAWS = {
    "low_speed_restitution": Letter("e_0", "restitution of a contact without speed"),
    "friction": Letter(r"\mu", "Coulomb's coefficient of friction"),
    "tangential": Letter("e_t", "tangential restitution"),
    "falling": Letter("v_0", "speed off the surface at which the restitution is half as large"),
    "normal_speed": Letter(r"\lvert v_n\rvert", "speed against the normal before a contact"),
    "friction_impulse": Letter(r"\lambda", "impulse of friction per unit mass"),
}
"""Of contact laws in general."""

RESULTS = {("meeting_plane", "nearest"): r"\check t"}
"""Letters of results, by kernel, whose name is that of something else elsewhere: a time here."""

ARGUMENTS: dict[str, Letter] = FLIGHTS | LOOP | IN_CONTACT | STUDIES
"""Every argument of a kernel that is neither a parameter nor of a kind of `_structured`."""


SERIES_TERM = re.compile(r"([a-z_]+)_(\d+)")
"""A coefficient of a series: its name, and its order."""

ROUNDOFF = r"\mathsf{u}"
"""The unit roundoff; an italic u, in bold, is the slip."""


def latex_name(name: str, words: frozenset[str] = frozenset()) -> str:
    r"""Return the LaTeX of a symbol's name, such as ``\omega_x`` of ``wx``.

    Parameters
    ----------
    name
        Of a symbol of derive/, or of a kernel's output.
    words
        Names that stand for something else here, and are written as words.
    """
    if name in ARGUMENTS and name not in words:
        return ARGUMENTS[name].latex
    if name in LAWS:
        return LAWS[name].latex
    return structured(name) or text(name)


def structured(name: str) -> str | None:
    """Return the LaTeX of what is told by its form: components, errors, windows, coefficients."""
    if name.endswith("_after"):
        stem = structured(name.removesuffix("_after"))
        return f"{stem}^+" if stem else None
    match = re.fullmatch(r"d([vwn]?[xyz])", name)
    if match:
        return rf"\delta_{{{structured(match[1])}}}"
    match = re.fullmatch(r"([vwn])([xyz]|[123]{1,2})", name)
    if match:
        return f"{match[1].replace('w', chr(92) + 'omega')}_{{{match[2]}}}"
    match = re.fullmatch(r"(low|high)(\d)", name)
    if match:
        return rf"\{'under' if match[1] == 'low' else 'over'}line t_{match[2]}"
    match = re.fullmatch(r"far_([vw]?[xyz])", name)
    if match:
        return rf"\tilde{{{structured(match[1])}}}"
    match = SERIES_TERM.fullmatch(name)
    if match and match[1] in SERIES:
        return f"{SERIES[match[1]].latex}^{{({match[2]})}}"
    match = re.fullmatch(r"([a-z])(\d+)", name)
    if match:
        return f"{match[1]}_{{{match[2]}}}"
    return name if len(name) == 1 else None


def text(name: str) -> str:
    """Return a name as words in a formula."""
    return rf"\text{{{' '.join(name.split('_')).strip()}}}"
