"""
Side on a billiard ball
=======================

The angle at which a billiard ball leaves the cushion, over its spin about the vertical ("side", or
"English"), for three angles at which it arrives. At 0° it goes straight to and from the cushion. As
long as friction can stop the slip, spin turns the ball; more spin makes no difference. The
restitution of 0.98 and the friction of 0.14 are those of Mathavan, Jackson and Parkin (*A
theoretical analysis of billiard ball dynamics under cushion impacts*, Proceedings of the
Institution of Mechanical Engineers C 224, 1863, 2010). Their cushion also pushes the ball onto the
table; this one does not.
"""

import numpy as np
from matplotlib.figure import Figure

import hoopgen
from hoopgen.plots import style
from hoopgen.scene import Plane, Scene

radius, restitution, friction, inertia = 0.0286, 0.98, 0.14, 2 / 5
table = Scene(
    "cushion",
    bodies=[Plane("cushion", axis="-x", restitution=restitution, friction=friction)],
    ball_radius=radius,
    gravity=0,  # along the table nothing pulls
    inertia=inertia,
)

spins = np.linspace(-80, 80, 321)
with style():
    picture = Figure(figsize=(7.1, 3), layout="constrained")
    axes = picture.subplots()
    for arrival in (0, 20, 40):
        along, towards = np.sin(np.radians(arrival)), np.cos(np.radians(arrival))  # m/s
        states = np.zeros((len(spins), 9))
        states[:, 0], states[:, 3], states[:, 4] = -0.2, towards, along
        states[:, 8] = spins
        shots = hoopgen.simulate(states, scene=table, time_limit=1, record=True)
        after = shots.events["after"][shots.events["kind"] == hoopgen.Event.IMPACT]
        leaves = np.degrees(np.arctan2(after[:, 4], -after[:, 3]))
        axes.plot(spins, leaves, label=f"arrives at {arrival}°")

        # Friction changes the velocity along the cushion by what stops the slip, or what it can.
        slip = along + radius * spins
        change = np.clip(
            -slip / (1 + 1 / inertia),
            -friction * (1 + restitution) * towards,
            friction * (1 + restitution) * towards,
        )
        assert np.abs(after[:, 4] - (along + change)).max() < 1e-15
    axes.set(xlabel="spin (rad/s)", ylabel="leaves at (°)")
    axes.legend()
picture
