"""
Coordinates and angles
======================

The axes and the arguments of `hoopgen.release`, drawn for one shot.
"""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle

import hoopgen
from hoopgen.plots import COLOURS, style

BLUE, GREEN, RED, INK, GREY = "#0055AA", COLOURS["bridge"], COLOURS["ring"], "#222222", "#777777"

hoop = hoopgen.PAPER
RING = 3.048  # m above the floor
place = {"height": 2.1, "distance": 3.6, "angle": np.radians(35)}
elevation, azimuth = np.radians(52), np.radians(8)
speed = float(hoopgen.aim(**place, elevation=elevation).speed)
released = hoopgen.release(speed, elevation, azimuth, backspin=6 * np.pi, **place)
x, y, z, vx, vy, vz = released[:6]


def arrow(axes, start, end, colour=INK, heads="-|>"):
    """Draw an arrow from start to end."""
    look = {"arrowstyle": heads, "color": colour, "lw": 1.1, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", xy=end, xytext=start, arrowprops=look)


def add_ball(axes, centre):
    """Draw the ball."""
    axes.add_patch(Circle(centre, hoop["ball_radius"], fc=COLOURS["ball"], ec="none", zorder=3))


def angle(axes, corner, size, start, end, name, colour):
    """Mark an angle from one direction to another, rad, and write its name beside it."""
    axes.add_patch(
        Arc(corner, 2 * size, 2 * size, theta1=np.degrees(start), theta2=np.degrees(end), ec=colour)
    )
    middle = (start + end) / 2
    at = corner[0] + 1.12 * size * np.cos(middle), corner[1] + 1.12 * size * np.sin(middle)
    axes.text(*at, name, color=colour, va="center", ha="left" if np.cos(middle) > 0 else "right")


# %%
# From the side
# -------------
#
# This view of the shot from the side shows the height of the release and the angle of the velocity.
# The height of a release is measured from the floor, z from the ring.


def from_the_side(axes):
    """Draw the flight in its own plane, the ring's centre at 0."""
    across = place["distance"]
    t = np.linspace(0, 2 * speed * np.sin(elevation) / hoop["gravity"], 200)
    along = across - speed * np.cos(elevation) * t
    above = place["height"] + speed * np.sin(elevation) * t - hoop["gravity"] / 2 * t**2
    seen = above > RING - 0.02
    seen[: np.argmax(above)] = True
    axes.plot(along[seen], above[seen], color=COLOURS["ball"], lw=1.2)
    axes.axhline(0, color=INK, lw=1)
    axes.plot([-hoop["ring_radius"], hoop["ring_radius"]], [RING, RING], color=RED, lw=3)
    board = RING + hoop["board_bottom"], RING + hoop["board_top"]
    axes.plot([-hoop["board_distance"]] * 2, board, color=INK, lw=2)
    axes.text(-0.3, RING - 0.12, "ring", color=RED, va="top")
    axes.text(-hoop["board_distance"], board[1] + 0.05, "backboard", ha="center")
    add_ball(axes, (across, place["height"]))
    turn = {"arrowstyle": "-|>", "color": GREY, "connectionstyle": "arc3,rad=-0.9"}
    ends = [(across + dx, place["height"] + 0.08) for dx in (-0.2, 0.2)]
    axes.annotate("", xy=ends[1], xytext=ends[0], arrowprops=turn)
    axes.text(across + 0.27, place["height"] + 0.2, "backspin", color=GREY)

    start = (across, place["height"])
    axes.plot([across, across - 0.9], [place["height"]] * 2, color=GREY, lw=0.6, ls="--")
    tip = (across - 0.9 * np.cos(elevation), place["height"] + 0.9 * np.sin(elevation))
    arrow(axes, start, tip, BLUE)
    axes.text(tip[0] + 0.1, tip[1] + 0.05, "speed", color=BLUE)
    angle(axes, start, 0.5, np.pi - elevation, np.pi, "elevation", BLUE)
    arrow(axes, (across + 0.35, 0), (across + 0.35, place["height"]), GREEN, "<|-|>")
    axes.text(across + 0.42, place["height"] / 2, "height", color=GREEN)
    arrow(axes, (0, 0.35), (across, 0.35), GREEN, "<|-|>")
    axes.text(across / 2, 0.42, "distance", color=GREEN, ha="center")
    axes.plot([0, 0], [0, RING], color=GREY, lw=0.6, ls="--")
    axes.text(0.08, 1.5, "3.048 m", color=GREY)

    entry = hoopgen.aim(**place, elevation=elevation).entry_angle
    angle(axes, (0, RING), 0.62, 0, entry, "entry angle", BLUE)
    axes.plot([0, 0.9], [RING, RING], color=GREY, lw=0.6, ls="--")
    arrow(axes, (0, RING), (0, RING + 0.75))
    axes.text(-0.04, RING + 0.8, "z", ha="center")
    axes.text(2.0, 4.35, "from the side", ha="center", fontweight="bold")
    axes.set(xlim=(-0.9, 4.6), ylim=(-0.15, 4.5), aspect="equal")
    axes.axis("off")


# %%
# From above
# ----------
#
# This view shows the place of the shooter and the direction of the shot. ``azimuth`` 0 points to
# the centre of the ring.


def from_above(axes):
    """Draw the floor plan."""
    half = hoop["board_half_width"]
    axes.plot([-hoop["board_distance"]] * 2, [-half, half], color=INK, lw=2)
    axes.text(-hoop["board_distance"], -half - 0.08, "backboard", ha="center", va="top")
    axes.add_patch(Circle((0, 0), hoop["ring_radius"], fc="none", ec=RED, lw=2))
    axes.text(0.1, -0.28, "ring", color=RED, va="top")
    add_ball(axes, (x, y))
    arrow(axes, (0, 0), (1.5, 0))
    axes.text(1.55, 0, "x", va="center")
    arrow(axes, (0, 0), (0, 1.5))
    axes.text(0, 1.55, "y", ha="center")
    axes.plot([0, x], [0, y], color=GREEN, lw=1)
    axes.text(0.5 * x - 0.15, 0.5 * y + 0.15, "distance", color=GREEN, ha="right")
    angle(axes, (0, 0), 0.9, 0, place["angle"], "angle", GREEN)
    towards = np.hypot(vx, vy)
    tip = (x + 1.6 * vx / towards, y + 1.6 * vy / towards)
    arrow(axes, (x, y), tip, BLUE)
    heading = np.arctan2(-y, -x) % (2 * np.pi)
    angle(axes, (x, y), 1.25, heading, heading + azimuth, "", BLUE)
    axes.text(tip[0] + 0.1, tip[1] - 0.25, "azimuth,\nto the left: positive", color=BLUE, va="top")
    axes.text(1.5, 2.75, "from above", ha="center", fontweight="bold")
    axes.set(xlim=(-0.9, 3.8), ylim=(-1.3, 2.9), aspect="equal")
    axes.axis("off")


# %%
# Backspin moves the top of the ball towards the shooter; its axis is horizontal and across the
# flight. The axis of sidespin is vertical.

with style():
    picture = Figure(figsize=(8.6, 3.9), layout="constrained")
    side, above = picture.subplots(1, 2, width_ratios=(5.3, 4.6))
    from_the_side(side)
    from_above(above)
picture
