"""The measured derivatives as a page and as a picture."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullLocator

import hoopgen
from benchmarks.gradients.ball import LOSSLESS, SPRING_BALL, floor
from benchmarks.gradients.peers import EVERYBODY
from benchmarks.gradients.steps import height_after_steps, slopes_of_steps
from benchmarks.machine import facts
from benchmarks.report import power, table
from hoopgen.plots.style import style

LABELS = {
    "hoopgen": "hoopgen",
    "differences": "central differences of hoopgen, best step",
    "diffrax": "diffrax, told the sequence of contacts",
}


def _microseconds(seconds: float) -> str:
    return f"{seconds * 1e6:,.1f}" if seconds < 1e-4 else f"{seconds * 1e6:,.0f}"


def _ball(found: Mapping[str, Any]) -> list[str]:
    labels = {"hoopgen": "hoopgen, a shot of 10,000"} | {peer.key: peer.label for peer in EVERYBODY}
    unit = found["cost"]["hoopgen"]
    rows = [["*truth, closed form*", *(f"*{one:+.4f}*" for one in found["truth"]), "", "", ""]]
    for key, slopes in found["slopes"].items():
        pairs = zip(slopes, found["truth"], strict=True)
        worst = max(abs(one - right) for one, right in pairs)
        cost = found["cost"][key]
        own = [f"{one:+.4f}" for one in slopes]
        rows.append([labels[key], *own, f"{worst:.0e}", _microseconds(cost), f"{cost / unit:,.0f}"])
    one = found["cost"]["hoopgen_one"]
    blank = [""] * (len(found["truth"]) + 1)
    rows.append(["hoopgen, a call for one shot", *blank, _microseconds(one), f"{one / unit:,.0f}"])
    head = ["", *(f"{time} s" for time in found["times"]), "largest error", "µs", "ratio"]
    return table(head, rows)


def _spring(found: Mapping[str, Any]) -> list[str]:
    labels = {"hoopgen": "hoopgen"} | {peer.key: peer.label for peer in EVERYBODY}
    rows = [["*truth, closed form*", *(f"*{one:+.4f}*" for one in found["truth"])]]
    rows += [
        [labels[key], *(f"{one:+.4f}" for one in slopes)] for key, slopes in found["slopes"].items()
    ]
    lines = table(["", *(f"{time} s" for time in found["times"])], rows)
    if found["extremes"] is None:
        return lines
    lowest, highest = found["extremes"]
    radius, height = SPRING_BALL.radius, SPRING_BALL.radius + SPRING_BALL.height
    return [
        *lines,
        "",
        "The spring of that model is so soft that the ball sinks "
        f"{100 * (radius - lowest):.1f} cm into the floor, more than its radius, which takes about "
        f"0.1 s; it rises to {highest:.3f} m, {1000 * (highest - height):.1f} mm higher than it "
        "was dropped. The truth is that of a floor that takes no energy in no time.",
    ]


def _throws(found: Mapping[str, Any]) -> list[str]:
    head = ["", *(f"{count}" for count in found["contacts"])]
    rows = [
        [f"error, {LABELS[key]}", *(f"{one:.0e}" for one in errors)]
        for key, errors in found["errors"].items()
    ]
    labels = LABELS | {
        "hoopgen": "hoopgen, a shot of 10,000",
        "hoopgen_one": "hoopgen, a call for one",
    }
    rows += [
        [f"µs, {labels[key]}", *map(_microseconds, cost)]
        for key, cost in found["cost"].items()
        if cost
    ]
    return table(head, rows)


def _tasks(found: Mapping[str, Any]) -> list[str]:
    (z, v), right = found["task_1"]
    rows = [["task 1, truth", f"{right[0]:+.6f}", f"{right[1]:+.6f}", "", ""]]
    for label, divided in (("steps", False), ("steps, divided at the impact", True)):
        by_z, by_v = slopes_of_steps(divided)
        rows.append([f"task 1, {label}", f"{by_z:+.6f}", f"{by_v:+.6f}", "", ""])
    rows.append(["task 1, hoopgen", f"{z:+.6f}", f"{v:+.6f}", "", ""])
    for label, row in (("truth", found["task_2"][1]), ("hoopgen", found["task_2"][0])):
        x, z, vx, vz = (f"{one:+.6f}" for one in row)
        rows.append([f"task 2, {label}", z, vz, x, vx])
    return table(["", "by z", "by vz", "by x", "by vx"], rows)


def as_markdown(results: Mapping[str, Any]) -> str:
    """Return the page."""
    limits = [f"- {peer.label}: {peer.limits}" for peer in EVERYBODY]
    limits.append(
        "- hoopgen: forward derivatives alone, of its own contact law; none through a roll, and "
        "none for a shot of which a decision is uncertain."
    )
    lines = [
        "# Gradients beside other programs",
        "",
        '`make bench ARGS="--only gradients"` writes this page; `gradients.json` has every number. '
        "[Gradients through bounces](howto/gradients.md) says how to ask hoopgen for derivatives. "
        "The peers are in the extra `peers`; one that is not installed is left out"
        + (f" ({'; '.join(results['absent'])})." if results["absent"] else "; all were there."),
        "",
        "Times are CPU times, the least of some rounds in which all take turns, without what is "
        "compiled before. They are provisional: the machine may have been shared "
        f"(load {results['load']:.1f} on {os.cpu_count()} processors). Compare the ratios.",
        "",
        "## The bouncing ball",
        "",
        "A ball is dropped from rest, 1 m above a floor; restitution 0.8, gravity 9.81 m/s². The "
        "table has the derivative of its height at a time by the height of the release (m/m), "
        f"and the time of one derivative at {results['ball']['times'][-1]} s; the ratio is to a "
        "shot in a batch of hoopgen.",
        "",
        *_ball(results["ball"]),
        "",
        "diffrax with a root finder for the event is right, and so is heyoka.py once its user "
        "writes the jump of the variations; without these nothing warns. For a single ball both "
        "take less time than a call of hoopgen, which has the overhead of a batch. Batches of the "
        "others were not measured.",
        "",
        "MuJoCo and MJX simulate another contact: a spring and a damper, here with a stiffness of "
        "10,000 1/s² and the damping that gives the first bounce the restitution 0.8. A contact "
        "takes about 0.03 s, so that the ball is elsewhere at these times, too. MJX agrees with "
        "MuJoCo: both differentiate the program of time steps, in which the step of a contact "
        "does not move; [Brax](https://github.com/google/brax/issues/73) had it too, in 2021. "
        "Differences over 0.03 m see past the steps; they are the slopes of the "
        "soft contact, another model than that of the truth.",
        "",
        "What each cannot do, or needs:",
        "",
        *limits,
        "",
        "## The ball of a MuJoCo issue",
        "",
        "[Issue 1668](https://github.com/google-deepmind/mujoco/issues/1668) of MuJoCo asks for a "
        "bouncing ball in MJX: radius 0.12 m, dropped from rest with its centre 1 m above the "
        "floor, which is a spring of 1,000 1/s² without a damper, in steps of 2 ms. Here it falls "
        "without air. The table has the same derivative, at times between the first contact of a "
        "ball that keeps its speed and the second.",
        "",
        *_spring(results["spring"]),
        "",
        "## Free throws",
        "",
        "Free throws in `HOOP`, by the number of contacts. The error is the largest one among the "
        "derivatives of the state at the end by `vx` and `vz`, divided by the largest derivative, "
        f"of at most {results['throws']['each']} shots each. The truth comes from differences of "
        "the exact path to 70 digits. For the differences in doubles the best of nine steps was "
        "chosen with the truth at hand.",
        "",
        *_throws(results["throws"]),
        "",
        "For one shot diffrax and a call of hoopgen take about as long; diffrax was told the "
        "surfaces, and batches of it were not measured. heyoka.py would need the jump at the ring "
        "by hand. MuJoCo, MJX and the tape over time steps are not shown: the table above has what "
        "they give for a flat floor, and MuJoCo has no torus.",
        "",
        "## Tasks 1 and 2 of diff_sim_grads",
        "",
        "[diff_sim_grads](https://github.com/DesmondZhong/diff_sim_grads) (arXiv 2207.05060) asks "
        "differentiable simulators for derivatives whose truth is known. In task 1 a ball without "
        "gravity meets a floor that takes no speed, and the height after 1 s is wanted: a ball "
        "released higher ends lower. In task 2 a ball meets a floor and a wall, and the squared "
        "distance to a target after 0.6 s is wanted.",
        "",
        *_tasks(results["tasks"]),
        "",
        "The steps are those of an impulse at the step at which the ball would enter the floor, "
        "480 in 1 s, and the derivative is the exact one of that program. It has the wrong sign "
        "for the height: the step of the contact does not move with the release. As a function of "
        "the release the height is a saw whose teeth rise while the whole falls. A step that is "
        "divided at the time of impact cures it.",
        "",
        "![Task 1: height at the end against the height of the release, by time steps and by "
        "hoopgen. Free throws: error of derivatives against the number of contacts.]"
        "(gradients.svg)",
        "",
        *(f"{name}: {value}  " for name, value in facts().items() if name in _MATTERS),
        *(f"{name}: {value}  " for name, value in results["versions"].items()),
    ]
    return "\n".join(lines).rstrip() + "\n"


_MATTERS = ("processor", "system", "python", "hoopgen", "numpy")


def draw(results: Mapping[str, Any]) -> Figure:
    """Return the picture: the saw of task 1, and errors of free throws."""
    with style():
        figure = Figure(figsize=(9.0, 3.4), layout="constrained")
        left, right = figure.subplots(1, 2)
        heights = np.linspace(0.985, 1.015, 601)
        stepped = [height_after_steps(z + 0j, -2.0 + 0j, impact_time=False).real for z in heights]
        states = np.tile([-1.0, 0, 1, 2, -1, -2, 0, 0, 0], (len(heights), 1))
        states[:, 2] = heights
        exact = hoopgen.simulate(states, scene=floor(1.0, LOSSLESS)).state[:, 2]
        left.plot(heights, stepped, color="#E69F00", lw=1.2, label="480 time steps")
        left.plot(heights, exact, color="#0072B2", lw=1.5, label="hoopgen, and the truth")
        left.set_xlabel("height of the release (m)")
        left.set_ylabel("height after 1 s (m)")
        left.set_title("Task 1: a ball without gravity", fontsize=9)
        left.legend(fontsize=8)
        found = results["throws"]
        colours = {"hoopgen": "#0072B2", "differences": "#999999", "diffrax": "#D55E00"}
        for key, errors in found["errors"].items():
            right.plot(
                found["contacts"], errors, "o-", color=colours[key], lw=1.2, label=LABELS[key]
            )
        right.set_yscale("log")
        right.set_ylim(1e-16, 1e-1)
        right.yaxis.set_major_locator(LogLocator(numticks=9))
        right.yaxis.set_major_formatter(lambda value, _: power(value))
        right.yaxis.set_minor_locator(NullLocator())
        right.set_xticks(found["contacts"])
        right.set_xlabel("contacts of the free throw")
        right.set_ylabel("error / largest derivative")
        right.set_title("Free throws in HOOP", fontsize=9)
        right.legend(fontsize=8)
    return figure
