"""The letters of the notation: the LaTeX and the meaning of the arguments of kernels."""

from __future__ import annotations

from typing import NamedTuple

AXES = "xyz"


class Entry(NamedTuple):
    """LaTeX and meaning of an argument."""

    latex: str
    meaning: str


def _vector(name: str, latex: str, meaning: str) -> dict[str, Entry]:
    """Return the entries of a vector's components by name; `@` stands for x, y and z."""
    texts = ([text.replace("@", axis) for text in (name, latex, meaning)] for axis in AXES)
    return {key: Entry(*own) for key, *own in texts}


FLIGHTS = {
    "t": Entry("t", "time since the last contact"),
    "end": Entry(r"t_\mathrm{end}", "end of the window that is searched"),
    "horizon": Entry("T", "time after which no event is wanted"),
    "leaving": Entry(r"\ell", "1 if the flight starts on this very surface, else 0"),
    "extent": Entry(r"\lVert\mathbf{r}\rVert_1", "sum of the absolute coordinates at the start"),
    "speed": Entry(r"\lVert\mathbf{v}\rVert_1", "sum of the absolute velocities at the start"),
    "gap": Entry(
        "F",
        "gap: the searched function, zero at a contact; in contact, the distance",
    ),
    "rate": Entry("F'", "rate of the gap"),
    "bend": Entry("F''", "second derivative of the gap"),
    "margin": Entry("m", "bound on the error of a gap"),
    "rate_margin": Entry("m'", "bound on the error of its rate"),
    "flat": Entry("m_F", "bound on the error of the gap itself"),
    "tilt": Entry(r"m_\ell", "bound on the error of the gap over t, after a contact"),
    "leaving_margin": Entry(r"m_\ell", "bound on the error of the gap over t, after a contact"),
    "ceiling": Entry("C", "bound on the size of $F''$"),
    "energy2": Entry("K", "first constant of $F''$ in the search of a ring"),
    "moment2": Entry("W", "second constant of $F''$ in the search of a ring"),
    "rho_start": Entry(r"\rho_0", "distance from the axis at the start"),
    "step": Entry(r"\Delta t", "step of a search, which contains no root"),
    "next": Entry("t_+", "time after the step"),
    "root": Entry("t_N", "Newton's value of the root"),
    "clearance": Entry(r"\chi", "positive if a root is certain"),
    "clear": Entry(r"\chi_0", "positive if a surface is certainly missed"),
    "unproved": Entry(r"\text{unproved}", "a cheaper test does not show it"),
    "arrival": Entry("t_r", "root that a search has found; infinite: none"),
    "refined": Entry("t_R", "root after one more step of Newton's method"),
    "candidate": Entry("t_p", "root that counts if it is within the bounds"),
    "gap_at_start": Entry(
        "F_s", "gap at the start of a flight that arrives at once, else infinite"
    ),
    "side_rate": Entry(
        r"\dot F_0", "rate of a plane's gap at the start; infinite: it decides nothing"
    ),
    "side_gap": Entry("F_0", "gap of a plane at the start of a flight"),
    "side_margin": Entry("m_0", "twice the error of that gap"),
    "side": Entry(
        r"\vartheta", "1 outside the surface, -1 inside its continuation beyond the bounds"
    ),
    "after": Entry("t_1", "time that a search has reached"),
    "lasting": Entry(r"\tau", "time since the begin of a search in single precision"),
    "apex": Entry("t_a", "time at which a plane's gap is extreme"),
    "height": Entry("F_a", "gap of a plane at its apex"),
    "share": Entry(r"\sigma", "error budget of a search, relative to the size of the flight"),
    "pad": Entry("T_+", "time from the earliest arrival to the horizon"),
    "budget_exceeded": Entry(r"\varpi", "positive if the search's bounds do not hold"),
    **_vector("middle_@", r"\bar{r}_@", "centre of a flight's box along @"),
    **_vector("reach_@", r"\varrho_@", "half size of a flight's box along @"),
    **_vector(
        "later_middle_@", r"\bar{r}'_@", "centre of the box of a flight's second half along @"
    ),
    **_vector(
        "later_reach_@", r"\varrho'_@", "half size of the box of a flight's second half along @"
    ),
    **_vector("least_@", r"\check{c}_@", "largest negated coordinate of a group's bodies along @"),
    **_vector("most_@", r"\hat{c}_@", "largest coordinate of a group's bodies along @"),
    **_vector("wide_@", r"\hat{h}_@", "largest half size of a group's bodies along @"),
    "measured": Entry(r"\Lambda", "sum of the sizes of the scene's lengths"),
    "lengths": Entry(r"\Lambda_s", "sum of the sizes of the scene's lengths, as a field of a shot"),
    "blur": Entry(r"\epsilon_0", "bound on the rounding of a length at the start"),
}
"""Arguments of one surface along one flight."""

LOOP = {
    "index": Entry("j", "index of the surface that is searched"),
    "left_middle": Entry(r"\bar\jmath_\ell", "middle of the indices of the left body's surfaces"),
    "left_reach": Entry(r"J_\ell", "half the number of the left body's surfaces"),
    "last": Entry(r"j_\ell", "index of the surface touched last, -1: none"),
    "time": Entry("t_j", "time of an arrival on a surface"),
    "when": Entry(r"t^\ast", "time of the earliest arrival so far"),
    "which": Entry(r"j^\ast", "surface of the earliest arrival so far, -1: none"),
    "delay": Entry(r"\delta", "bound on how far a computed arrival is from the true one"),
    "earliest_delay": Entry(r"\delta^\ast", "bound on the delay of the earliest arrival so far"),
    "undecided_time": Entry(
        r"\theta",
        "earliest undecided time; at a release, positive if the start is undecided",
    ),
    "excess": Entry(r"\xi", "by how much errors or sizes exceed their limit"),
    "position_error": Entry(r"\varepsilon_r", "bound on the error of each coordinate at the start"),
    "velocity_error": Entry(r"\varepsilon_v", "bound on the error of each velocity at the start"),
    "spin_error": Entry(r"\varepsilon_\omega", "bound on the error of each component of the spin"),
    "time_error": Entry(r"\varepsilon_c", "bound on the error of the time since the release"),
    "contacts": Entry("k", "number of contacts, including this one"),
    "most_contacts": Entry(r"k_{\max}", "largest number of contacts"),
    "count": Entry("k_b", "number of contacts with a body"),
    "body": Entry(r"b^\ast", "body of the event, -1: none"),
    "second": Entry(r"j_2", "index of a plane that the flight began on besides, -1: none"),
    "rested_on": Entry(r"j_r", "plane that a ball in contact was on, -1: it flew, -2: another"),
    "first": Entry("b_1", "body touched first, -1: none"),
    "clock": Entry("t_c", "time since the release"),
    "clock_error": Entry(r"\varepsilon_t", "sum of the errors of the contacts' times"),
    "curving": Entry(r"\kappa_s", "curvature of the surface, if the ball meets it twice in a row"),
    **_vector(
        "left_n@", "n^0_@", "normal along @ at the start of the flight, if on the same surface"
    ),
    "place_n": Entry("B_n", "bound on the error of the place along the normal"),
    "place_s": Entry("B_s", "bound on the error of the place along the second axis of the frame"),
    "place_e": Entry("B_e", "bound on the error of the place along the horizontal axis"),
    "pace_n": Entry("Y_n", "bound on the error of the velocity along the normal, in the frame"),
    "pace_s": Entry("Y_s", "bound on the error of the velocity along the second axis"),
    "pace_e": Entry("Y_e", "bound on the error of the velocity along the horizontal axis"),
    "turn_n": Entry("B_w", "bound on the error of the spin along the normal, in the frame"),
    "turn_z": Entry("B_z", "bound on what of the spin's error rolling does not give"),
    **{f"origin_{c}": Entry(f"O_{c}", "bound at an earlier contact") for c in "seuvwt"},
    **{f"recent_{c}": Entry(f"C_{c}", "bound on what has come to it since") for c in "seuvwt"},
    **{
        f"product_{i}{j}": Entry(f"M_{{{i}{j}}}", "of the product of derivatives since then")
        for i in range(1, 7)
        for j in range(1, 7)
    },
    "continued": Entry(r"\mu_M", "1: the product goes on, 0: it begins anew"),
    "tightening": Entry(r"\tau_B", "1: bounds on errors are tightened, 0: they are not"),
    "carries": Entry(r"\text{carries}", "bounds are carried over a contact as they are"),
    "tightens": Entry(r"\text{tightens}", "bounds are carried over a contact and tightened"),
    "loose": Entry(r"\text{loose}", "tighter bounds may make the shot certain"),
    "position_bound": Entry(r"\mathcal{P}", "bound on the norm of the error of the place"),
    "velocity_bound": Entry(r"\mathcal{E}", "bound on the norm of the error of the velocity"),
    "spin_bound": Entry(r"\mathcal{W}", "bound on the norm of the error of the spin"),
    "tangent_x": Entry(r"\bar e_x", "the frame's horizontal axis, along x"),
    "tangent_y": Entry(r"\bar e_y", "the frame's horizontal axis, along y"),
    "left_ex": Entry(r"\bar e^0_x", "the horizontal axis of the last contact's frame, along x"),
    "left_ey": Entry(r"\bar e^0_y", "the horizontal axis of the last contact's frame, along y"),
    "bend_s": Entry(r"\kappa_1", "curvature of the surface across the horizontal axis"),
    "bend_e": Entry(r"\kappa_2", "one over the distance from the ring's axis; 0 on a plane"),
    "left_bend_s": Entry(r"\kappa^0_1", "the same at the last contact"),
    "left_bend_e": Entry(r"\kappa^0_2", "the same at the last contact"),
    "sharpest_bend": Entry("K_c", "bound on the curvature of the surface"),
    "root_offset": Entry("A_F", "bound on how far the root is off the surface"),
    "unbounded": Entry(r"\text{unbounded}", "a bound on an error is not finite"),
    "root_level": Entry(r"A_L", "bound on how far the flight is off the surface at the root"),
    "normal_rounding": Entry(r"\nu_n", "bound on the rounding of the normal"),
    "normal_velocity": Entry("V_n", "velocity along the normal before the impact"),
    "slip_share": Entry(r"\lambda_u", "share of the slip that friction takes"),
    "slip_margin": Entry(r"m_\mu", "by how much the contact grips; negative: it slips"),
    "slip_speed": Entry("u", "size of the slip"),
    "slip_x": Entry(r"\hat u_x", "direction of the slip, along x"),
    "slip_y": Entry(r"\hat u_y", "direction of the slip, along y"),
    "slip_z": Entry(r"\hat u_z", "direction of the slip, along z"),
    "back": Entry(r"\beta", "1 if the flight began on the surface that it meets, else 0"),
    "contact_delay": Entry("dt", "variation of the time of a contact"),
    "lifting": Entry(r"\varphi", "share of the worst case that errors do not fall below"),
    "root_delay": Entry("t_F", "delay of a contact that the roundings of its condition cause"),
    "shift": Entry(
        r"\varsigma", "largest error of the position at a contact that one flight can cause"
    ),
    "turn": Entry(r"\nu", "largest error of the normal that one flight can cause"),
    "reached": Entry(r"o^\ast", "outcome of an event that ends the shot"),
    "time_limit": Entry(r"t_{\max}", "time since the release at which a shot ends"),
    "slack": Entry(r"\epsilon", "bound on the error of a length at a computed arrival"),
    "through": Entry(
        r"\phi", "1: the ball fell through the ring's disc; -1: it came up through it"
    ),
    "outcome": Entry(r"o", "outcome of the shot, -1: in flight"),
    "uncertain": Entry(r"\upsilon", "1 if some decision of the shot is undecided"),
    "claims": Entry(r"\gamma_e", "1 if error bounds are wanted at the end, 2 at every event"),
    "allowed": Entry(r"\alpha_p", "positive if the parameters are allowed"),
    "valid": Entry(r"\alpha_s", "positive if the ball overlaps no surface"),
    "permitted": Entry(r"\text{permitted}", "the parameters are allowed and in range"),
    "in_range": Entry(r"\text{in range}", "no number of the release is too large"),
    "arrives": Entry(r"\text{arrives}", "there is an arrival on the surface"),
    "undecided": Entry(r"\text{undecided}", "a decision about the arrival is undecided"),
    "hit": Entry(r"\text{hit}", "the search has reached a root"),
    "sure": Entry(r"\text{sure}", "the root that the search has reached is certain"),
    "met": Entry(r"\text{met}", "the ball comes in at the root"),
    "searching": Entry(r"\text{searching}", "there is a window to search"),
    "reachable": Entry(r"\text{reachable}", "the flight may reach the surface"),
    "first_near": Entry(r"\text{near}_1", "the first half of the flight may come near the surface"),
    "later_near": Entry(
        r"\text{near}_2", "the second half of the flight may come near the surface"
    ),
    "since": Entry(r"t_0", "begin of a search in single precision"),
    "representable": Entry(
        r"\text{representable}", "nothing in single precision over- or underflows"
    ),
    "single_precision": Entry(
        r"\text{single precision}", "a search in single precision took place"
    ),
    "start_rate": Entry("F'_0", "rate of the gap at the start of the flight"),
    "rho_rate": Entry(r"\rho'_0", "rate of the distance from the axis at the start of the flight"),
    "quotient_margin": Entry(r"m_\Gamma", r"bound on the error of $\Gamma = (F_\ell/t - F'_0)/t$"),
    "jerk": Entry("J", "bound on the size of $F'''/6$"),
    "fits": Entry(r"\text{fits}", "the sizes allow single precision"),
    "penetrates": Entry(
        r"\text{penetrates}", "the ball is on the other side of the surface than assumed"
    ),
    "needs_refinement": Entry(
        r"\text{needs refinement}", "the search needs a smaller error budget"
    ),
    "certain": Entry(r"\text{certain}", "the arrival that was found is certain"),
    "ends": Entry(r"\text{ends}", "the event is on a plane that ends a shot"),
    "edge": Entry(r"\text{edge}", "the choice of the end is undecided"),
    "touches": Entry(r"\text{touches}", "the event is a contact"),
    "of_this_kind": Entry(r"\text{of this kind}", "the event is on a surface of this kind"),
}
"""Arguments of the event loop; the last are truth values."""

IN_CONTACT = {
    "held": Entry("j_h", "index of the surface that holds the ball, -1: none"),
    "mode": Entry(r"\psi", "1, 2, 3: contact begins, goes on, ends; 0: the ball is in flight"),
    "assured": Entry(r"\alpha", "1 if all further bounces are on the surface touched last, else 0"),
    **_vector("bent_@", "b_@", "1 if the surface is curved across @, else 0"),
    **{
        f"across_{i}{j}": Entry(
            rf"P_{{{i}{j}}}",
            f"{i}{j} of the projection onto the directions across which the surface is curved",
        )
        for i in AXES
        for j in AXES
    },
    "per_reach": Entry(
        r"\kappa_T",
        "inverse radius of the tube that the centre stays on, negative on its inside",
    ),
    **_vector("axis_@", "u_@", "unit vector of the axis of revolution, along @"),
    **_vector("outward_@", "e_@", "unit vector away from that axis, along @"),
    **_vector("far_outward_@", r"\tilde e_@", "$e_@$ of the neighbouring motion"),
    "per_tube": Entry(r"\varkappa_m", "curvature of the section through the axis"),
    "azimuth_factor": Entry("c_m", r"factor of the rate of the azimuth in that of the normal"),
    "per_width": Entry(r"\varkappa_\rho", "inverse distance of the ball from the axis"),
    "far_per_width": Entry(r"\tilde\varkappa_\rho", "the same of the neighbouring motion"),
    "turn_rate": Entry("s", "spin about the normal, times the ball's radius"),
    **_vector("rolled_@", r"v^\circ_@", "velocity along @ after a contact that grips"),
    **_vector("turning_@", r"\dot n_@", "rate of the normal along @"),
    "slip": Entry(r"\lvert\mathbf{u}\rvert", "speed of the contact point"),
    "bounce": Entry(r"v_\perp", "speed of the ball off the surface"),
    "nearest": Entry("d_1", "distance from the nearest other surface"),
    "second_contact_gap": Entry(
        "d_2", "largest distance from a second surface that presses on the ball"
    ),
    "free_time": Entry(
        r"t_f", "time for which a ball that leaves a surface certainly meets no other"
    ),
    "rolling_gap_acceleration": Entry(
        r"\ddot d_r", "second derivative of the distance of a rolling ball"
    ),
    "normal_cosine": Entry("c_n", "cosine of the angle between the normals of two surfaces"),
    "press": Entry("N_r", "normal force on a rolling ball, per unit mass"),
    "weight": Entry("a_n", "acceleration of free fall along the normal"),
    "rolling_friction": Entry(
        "f", "friction on a rolling ball, per unit mass; within a step its square"
    ),
    "rolling_friction_rate": Entry(r"\dot f", "rate of the squared friction"),
    **_vector("rolling_acceleration_@", "a_@", "acceleration of a rolling ball along @"),
    "grip_deficit": Entry("E", r"excess of friction over its limit, $f^2 - (\mu N)^2$"),
    "grip_deficit_rate": Entry(r"\dot E", "rate of the excess"),
    "last_grip_deficit": Entry("E_0", "excess one step before; infinite: unknown"),
    "last_grip_deficit_rate": Entry(r"\dot E_0", "rate of the excess one step before"),
    "last_grip_clock": Entry("t_E", "time of the step before"),
    "grip_lost": Entry("t_g", "time at which friction first exceeded its limit, infinite: never"),
    "rolls": Entry("k_r", "number of times that the ball began to roll"),
    "near": Entry(r"\epsilon_s", "half the width of a seam"),
    "nearing": Entry(r"\dot d", "rate of the distance from a surface"),
    "gap_curvature": Entry(r"\kappa_d", "bound on the downward curvature of the distance"),
    "gap_convexity": Entry(r"\kappa_u", "bound on the upward curvature of the distance"),
    "bound_distance": Entry(r"\ell_g", "distance of the ball within a bound, negative past it"),
    "bound_rate": Entry(r"\dot\ell_g", "rate of that distance"),
    "bound_curvature": Entry(r"\kappa_g", "how fast the gradient of that distance may change"),
    "crease": Entry(r"\ell_s", "distance from the nearest seam of a box beside the ball"),
    "outside_time": Entry(r"t_o", "time for which the ball certainly stays outside a bound"),
    "outside_distance": Entry(r"\ell_o", "distance from the bounds of a surface"),
    "edge_distance": Entry(r"\ell_1", "distance from the nearest edge of the surface below"),
    "edge_delay": Entry(r"\delta_g", "error of the time at which the ball reaches an edge"),
    "successor": Entry("j_e", "surface that takes the ball over at an edge"),
    "bound_shift": Entry(r"\delta\ell_g", "what the carried errors add to that distance"),
    "edge_shift": Entry("s_g", "what they add to the time at which the ball reaches an edge"),
    "entry_shift": Entry("s_e", "what they add to the time at which it comes over a bound"),
    **_vector("before_@", "a^-_@", "acceleration along @ before an edge"),
    **_vector("after_@", "a^+_@", "acceleration along @ after an edge"),
    "entry_delay": Entry(r"\delta_e", "error of the time at which the ball comes over a bound"),
    "enters": Entry(r"\text{enters}", "the ball comes in over a bound"),
    "lingers": Entry(r"\text{lingers}", "the ball moves along a bound"),
    "rebound": Entry(r"e_\infty", "restitution of the surface for bounces without speed"),
    "on_bound": Entry(r"\text{on bound}", "a bound lies within its error"),
    "near_edge": Entry(r"\text{near edge}", "the ball is near an edge of the surface below"),
    "over_edge": Entry(r"\text{over edge}", "the ball is past an edge of the surface below"),
    "falls_off": Entry(r"\text{falls off}", "the ball flies off an edge"),
    "lift": Entry(r"\ddot d", "second derivative of the distance along a flight"),
    "gap_jerk": Entry("d^{(3)}", "third derivative of the distance along a flight"),
    "gap_snap": Entry("d^{(4)}", "fourth derivative of the distance along a flight"),
    "force": Entry("N", "normal force per unit mass"),
    "force_rate": Entry("N'", "rate of the normal force"),
    "force_bend": Entry("N_2", "bound on the second derivative of the normal force within a step"),
    "friction_force_rate": Entry(
        r"\eta_f", r"twice $\mathbf{f}\cdot\dot{\mathbf{n}}$, which ends with friction"
    ),
    "stride": Entry(r"\Delta\tau", "length of a step in contact"),
    "strongest": Entry(r"\hat a", "bound on the acceleration within the step"),
    "fastest": Entry("U", "bound on the speed within the step"),
    "missed": Entry(r"\epsilon_h", "truncation error of the velocity in the step"),
    "neighbour_scale": Entry(r"\zeta", "scale from the errors to the neighbouring motion"),
    "settles": Entry(r"\text{settles}", "the ball stays on the surface"),
    "nearly": Entry(r"\text{nearly}", "the bounce may be the last"),
    "lodges": Entry(r"\text{lodges}", "the ball is wedged between two surfaces"),
    "slides": Entry(r"\text{slides}", "the bounces end with slip left"),
    "unpressed": Entry(r"\text{unpressed}", "no force presses the ball onto the surface"),
    "loses": Entry(r"\text{loses}", "friction exceeds its limit for the first time"),
    "in_contact": Entry(r"\text{in contact}", "the ball is in contact"),
    "moves": Entry(r"\text{moves}", "the ball flies to an event"),
    "rolling": Entry(r"\text{rolling}", "the ball goes on in contact"),
    "began": Entry("t_b", "begin of a turn in contact, time since the release"),
    "over": Entry(r"\text{over}", "the ball is not below the ring's disc"),
    "rests": Entry(r"\text{rests}", "the ball is at rest"),
    "circled": Entry(r"\iota", "1: the ball certainly stays on the ring since a turning point"),
    "climb": Entry("A", "rate of the angle around the wire"),
    "half_step": Entry(r"\Delta\tau'", "half a step, negative from its end"),
    "section_acceleration": Entry(
        r"\hat a_2", "bound on the acceleration in the ring's section within the step"
    ),
    "azimuth_clearance": Entry("d_3", "distance from the nearest other surface at any azimuth"),
    "circling": Entry(r"\text{circling}", "the ball goes on in contact with a ring"),
    "endless": Entry(r"\text{endless}", "the ball rolls on the ring for ever"),
}
"""Arguments of the contact phase; the last are truth values."""

IN_AIR = {
    "drag_rate": Entry("k_d", "drag per unit mass over the square of the speed"),
    **_vector(
        "magnus_rate_@", r"\Omega_@", "Magnus force per unit mass and speed: its vector along @"
    ),
    **_vector("free_fall_@", "a^e_@", "acceleration of gravity less buoyancy along @"),
    **_vector("short_v@", r"\acute v_@", "$v_@$ in single precision"),
    "short_drag_rate": Entry(r"\acute k_d", "$k_d$ in single precision"),
    **_vector("short_magnus_rate_@", r"\acute \Omega_@", r"$\Omega_@$ in single precision"),
    "tail_lost": Entry(
        r"\epsilon_{24}", "infinite if a coefficient does not fit into single precision, else 0"
    ),
    "piece": Entry("h_p", "length of a piece"),
    "growth": Entry("G_p", "bound on the growth of an error of the velocity within a piece"),
    "piece_place_error": Entry("E_r", "what a piece adds to the error of the position"),
    "piece_speed_error": Entry("E_v", "what a piece adds to the error of the velocity"),
    "unproved": Entry(r"\epsilon_\infty", "infinite if no bound is proved for a piece, else 0"),
    "piece_speed": Entry(r"\hat v_p", "bound on the speed within a piece"),
    "piece_acceleration": Entry(r"\hat a_p", "bound on the acceleration within a piece"),
    "piece_jerk": Entry("J_p", "bound on the second derivative of the velocity's series"),
    "piece_rest": Entry(
        r"\epsilon_p", "bound on what a sketch of a piece leaves out of the velocity"
    ),
    "piece_extent": Entry("W_p", "bound on the sum of the coordinates' sizes within a piece"),
    "inverse_airspeed": Entry(r"\breve s", r"one over the initial speed $\breve v$"),
    "short_inverse_airspeed": Entry(r"\acute s", r"$\breve s$ in single precision"),
    "sketch_size": Entry("W_s", "no less than any length of a search along a sketch"),
    "sketching": Entry(r"\text{sketching}", "the search along a sketch goes on"),
    "misses": Entry(r"\text{misses}", "the sketch shows that there is no contact"),
    "landed": Entry("k_s", "1 if the sketch shows that one root follows, else 0"),
    "lands": Entry(r"\bar k_s", "the same in double precision"),
    "onset": Entry("t_s", "time up to which the sketch shows that there is no contact"),
    "open": Entry(r"\text{open}", "the flight may come near the surface"),
    "unsettled": Entry(r"\text{unsettled}", "the sketch leaves something to search"),
    "bend_rate": Entry("J_F", "bound on the size of the third derivative of a gap within a piece"),
    "end_height": Entry(r"z_\eta", "z at the end of the piece, or at the event in it"),
    "half_bend": Entry(r"\beta_z", "half the second derivative of a parabola through both ends"),
    "apex_time": Entry(r"t_\wedge", "time at which z is largest within the piece"),
    "apex_height": Entry(r"z_\wedge", "z then"),
    "apex_climb": Entry(r"\dot z_\wedge", "rate of z then"),
    "rise_time": Entry(r"t_\uparrow", "time at which the ball passes the ring's plane upwards"),
    "fall_time": Entry(r"t_\downarrow", "time at which it passes the ring's plane downwards"),
    "rise_height": Entry(r"z_\uparrow", "what is left of z at the passing upwards"),
    "fall_height": Entry(r"z_\downarrow", "what is left of z at the passing downwards"),
    "rise_away": Entry(r"\rho_\uparrow^2", "squared distance from the axis then"),
    "fall_away": Entry(r"\rho_\downarrow^2", "squared distance from the axis at the passing down"),
    "goes_on": Entry(r"\text{goes on}", "the event is the end of a piece, and the flight goes on"),
    "sunk": Entry(r"\text{sunk}", "the ball can never meet anything again"),
}
"""Arguments of a flight through air, in pieces; the last are truth values."""

SERIES = {
    **_vector("v@", "v_@", "velocity along @"),
    **_vector("n@", "n_@", "normal along @"),
    **_vector("t@", "p_@", r"$\mathbf{n} \times \dot{\mathbf{n}}$ along @"),
    **_vector("e@", "e_@", "unit vector away from the axis, along @"),
    **_vector("c@", "q_@", r"$\mathbf{u} \times \mathbf{e}$ along @"),
    "azimuth_rate": Entry(r"\Omega_u", "rate of the azimuth about the axis"),
    "width": Entry(r"\rho", "distance from the axis"),
    "turn_rate": Entry("s", "spin about the normal, times the ball's radius"),
    "lift": Entry(r"\mathcal{L}", "acceleration along the normal without the part of friction"),
    "cosine": Entry(r"c_\alpha", "cosine of the angle around the wire, from outwards"),
    "sine": Entry(r"s_\alpha", "sine of the angle around the wire"),
    "climb": Entry("A", "rate of the angle around the wire"),
    "along": Entry("P", "speed along the ring"),
    "cos": Entry(r"c_\phi", "cosine of the azimuth"),
    "sin": Entry(r"s_\phi", "sine of the azimuth"),
    "near": Entry("Q", r"$1/\rho$"),
    "omega": Entry(r"\Omega", "rate of the azimuth"),
    "around": Entry("X", r"$A \Omega$"),
    "tilted": Entry("Y", r"$P s_\alpha - \beta s c_\alpha$, with the friction share $\beta$"),
    "airspeed": Entry(
        r"\breve v", r"$\sqrt{\mathbf{v} \cdot \mathbf{v} + v_s^2}$, as drag takes it"
    ),
    **_vector("short_v@", r"\acute v_@", "$v_@$ in single precision"),
    "short_airspeed": Entry(r"\acute v", r"$\breve v$ in single precision"),
}
"""Series of a rolling ball, and of a flight through air; a coefficient has its order as a
superscript in brackets."""

STUDIES = {
    "slope": Entry(r"\gamma", "tangent of the angle of release above the horizontal"),
    "entry": Entry(
        r"\gamma^\downarrow", "tangent of the angle below the horizontal at the wanted point"
    ),
    "release_speed": Entry(r"\lvert\mathbf{v}\rvert", "speed at release"),
    "reach": Entry(r"\Delta r", "horizontal distance from the release to the wanted point"),
    "rise": Entry(r"\Delta z", "height of the wanted point above the release"),
    "level": Entry(r"\bar z", "height above the origin"),
    "half": Entry(r"\bar t", "half the width of an interval of time"),
    "place_x": Entry("x_p", "place on the floor plan, x"),
    "place_y": Entry("y_p", "place on the floor plan, y"),
    "restitution": Entry(r"\hat e", "restitution of the impact through the contact frame"),
}
"""Arguments of studies, and of formulas for readers."""

LAWS = {
    "low_speed_restitution": Entry("e_0", "restitution of a contact without speed"),
    "friction": Entry(r"\mu", "Coulomb's coefficient of friction"),
    "tangential": Entry("e_t", "tangential restitution"),
    "falling": Entry("v_0", "speed off the surface at which the restitution is half as large"),
    "normal_speed": Entry(r"\lvert v_n\rvert", "speed against the normal before a contact"),
    "friction_impulse": Entry(r"\lambda", "impulse of friction per unit mass"),
}
"""Constants and quantities of contact laws in general."""

RESULTS = {("plane_root", "nearest"): r"\check t"}
"""LaTeX of results, by kernel, whose name has another meaning elsewhere."""
