"""`python -m benchmarks.pictures`: the pictures of the README and of docs/.

Most show one free throw, of a shooter whose scatter is that of a 70% one (Slegers 2021), and bank
shots from the places around; the others the article's Fig. 7 and a shot in each scene of
examples/scenes. Random numbers have seed 0: the same pictures every time.
"""

import argparse
import runpy
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Patch

import hoopgen
from benchmarks.free_throw import LINE, RELEASE, SEVENTY
from hoopgen.plots import (
    plot_aim_points,
    plot_fan,
    plot_landings,
    plot_map,
    plot_trajectory,
    save,
    style,
)
from hoopgen.plots.class_legend import CLASSES, draw_names, names_height
from hoopgen.plots.fan import draw_fan
from hoopgen.plots.fan_paths import gather_fan
from hoopgen.plots.map_cells import read_cells
from hoopgen.plots.maps import draw_classes
from hoopgen.plots.page import add_axes, add_view, new_page
from hoopgen.plots.views import Panel
from hoopgen.simulation.article import run
from hoopgen.study.questions.bank import bank_or_direct

SCENE = hoopgen.NBA | {"restitution": 0.75}

WORDS: Mapping[str, Any] = {"va": "center", "fontsize": 7.0, "color": "#666666"}


def free_throws() -> Figure:
    """Paths at one release angle and rising speed, beside what becomes of those at every angle."""
    angle, apart = 52.0, 0.02
    over = {"speed": np.arange(6.8, 8.3, apart)}
    grid = hoopgen.Grid(over, LINE | {"elevation": np.radians(angle)})
    released = grid.draw(0, grid.shots, parameters=SCENE)
    shots = hoopgen.simulate(released.states, released.parameters, record=True)
    fan = gather_fan(shots, SCENE, range(grid.shots))
    cells = read_cells(
        hoopgen.map(
            hoopgen.Scatter(LINE),
            {
                "speed": np.linspace(6.75, 8.55, 721),
                "elevation": np.radians(np.arange(40, 66, 0.05)),
            },
            SCENE,
        )
    )
    key = [CLASSES[place] for place in np.unique(cells.values)]
    # Inches, but for the limits of the view.
    width, left, across, below, gap, edge = 8.6, 0.55, 4.5, 0.48, 0.55, 0.1
    limits = (-0.5, 4.3, -0.98, 1.42)
    panel = Panel(fan.view, limits, across / (limits[1] - limits[0]), left, 0.0)
    with style():
        foot = names_height([one.words for one in key], width)
        figure = new_page(width, below + panel.height + 0.28, foot=foot)
        panel = Panel(fan.view, limits, panel.scale, left, foot + below)
        paths = add_view(figure, panel)
        draw_fan(paths, panel, fan)
        paths.set_title(f"Free throws at {angle:g}°, {apart:g} m/s apart", loc="left", fontsize=8.5)
        paths.text(0.75, 1.3, "over the board", ha="center", **WORDS)
        paths.text(2.3, 0.34, "too short", ha="center", **WORDS)
        start = left + across + gap
        chart = add_axes(
            figure, start, panel.bottom, width - start - edge, panel.height, "outcomes"
        )
        draw_classes(chart, cells)
        chart.axhline(angle, color="#222222", lw=0.7, ls=(0, (4, 3)))
        chart.text(8.52, angle + 0.25, "paths on the left", ha="right", fontsize=6.5)
        chart.set(xlabel=cells.axes[0].quantity.label, ylabel=cells.axes[1].quantity.label)
        chart.set_title("What becomes of them, and at other angles", loc="left", fontsize=8.5)
        chart.text(8.32, 57.0, "over\nthe\nboard", ha="center", **WORDS)
        chart.text(6.95, 62.5, "too\nshort", ha="center", **WORDS)
        swatches = [Patch(fc=one.colour, ec=one.line, lw=1.5, label=one.words) for one in key]
        draw_names(figure, swatches, width)
    return figure


def outcome_map() -> Figure:
    """Every free throw within wide limits."""
    over = {"speed": np.linspace(6.6, 9.6, 901), "elevation": np.radians(np.arange(38, 75, 0.06))}
    return plot_map(hoopgen.map(hoopgen.Scatter(LINE), over, SCENE))


def probability_map() -> Figure:
    """Draw the probability of a made shot by the release aimed at."""
    over = {
        "speed": np.linspace(6.95, 7.75, 65),
        "elevation": np.radians(np.linspace(44.0, 64.0, 61)),
    }
    return plot_map(hoopgen.map(hoopgen.Scatter(LINE, SEVENTY), over, SCENE, shots=5_000))


def _released(shots: int, *, record: bool = False) -> tuple[np.ndarray, hoopgen.Shots]:
    model = hoopgen.Scatter(LINE | RELEASE, SEVENTY)
    states = model.draw(0, shots, parameters=SCENE).states
    return states, hoopgen.simulate(states, SCENE, record=record)


def fan() -> Figure:
    """Draw the paths of the shooter's shots."""
    _, shots = _released(20_000, record=True)
    return plot_fan(shots, SCENE, paths=110)  # of which the file stays small


def landings() -> Figure:
    """Draw the landings of the shooter's misses."""
    states, shots = _released(300_000)
    floor = hoopgen.measure(states, shots, SCENE, ["floor_x", "floor_y"])
    missed = shots.outcome == hoopgen.Outcome.MISSED
    x, y = (floor[name][missed] for name in ("floor_x", "floor_y"))
    return plot_landings(x, y, SCENE, place=(LINE["distance"], 0.0))


def aim_points() -> Figure:
    """Draw the aim points of the best bank shots, from places on four arcs around the ring."""
    distance, angle = np.meshgrid([2.0, 3.0, 4.2, 5.5], np.radians(np.arange(-75.0, 76.0, 15.0)))
    places = np.stack([distance * np.cos(angle), distance * np.sin(angle)], axis=-1)
    release = {name: LINE[name] for name in ("height", "backspin")}
    player = hoopgen.Scatter(release, SEVENTY)
    dataset = bank_or_direct(player, places.reshape(-1, 2), SCENE, shots=5_000)
    return plot_aim_points(dataset, SCENE)


def best_shots() -> Figure:
    """Draw the best shot from each place of the half court, in the scene of a real ball."""
    found = hoopgen.best_shots(None, hoopgen.NBA_COURT, scene=hoopgen.COURT, shots=1_000)
    return hoopgen.plots.plot_best_shots(found)


# Shots in the scenes of examples/scenes: x y z, vx vy vz, wx wy wz, and contacts at most.
OWN: Mapping[str, tuple[tuple[float, ...], int | None]] = {
    "netball": ((1.6, 0.258, -0.35, -2.317, -0.301, 4.649, 0.0, -12.0, 0.0), None),
    "bowl": ((-0.6, 0.1, 0.35, 1.2, 0.9, 0.5, 0.0, 0.0, 0.0), 7),
    "bumpers": ((0.03, 0.044, 0.6, 1.259, -0.651, 0.248, 0.0, 0.0, 0.0), None),
    "funnel": ((-0.21, -0.038, 0.413, 0.718, -0.072, 0.201, 0.0, 0.0, 0.0), None),
    "pinball": ((0.214, 0.1, 0.025651, 0.0, 1.9, 0.228, -141.75, 0.0, 0.0), None),
    "golf": ((-0.4, 0.028, 0.0214, 1.1, 0.0, 0.0, 0.0, 52.0, 0.0), None),
}


def own(name: str) -> Figure:
    """One shot in a scene of one's own."""
    folder = Path(__file__).resolve().parents[1] / "examples" / "scenes"
    if name == "bumpers":
        scene = runpy.run_path(str(folder / f"{name}.py"))["SCENE"]
    else:
        scene = hoopgen.load_scene(folder / f"{name}.toml")
    state, most = OWN[name]
    shots = hoopgen.simulate(state, scene=scene, max_contacts=most, record=True)
    trajectory = shots.trajectory(0)
    return plot_trajectory(
        trajectory,
        trajectory.parameters,
        outcome=trajectory.outcome,
        title=name.capitalize(),
        three_d=True,
    )


def figure_7() -> Figure:
    """Draw the article's missed free throw."""
    (result,) = (one for one in run() if one.case.figure == "7")
    return plot_trajectory(
        result.trajectory,
        result.parameters,
        outcome=result.outcome,
        title=f"Fig. {result.case.figure}. {result.case.title}",
    )


def roll() -> Figure:
    """Draw a free throw at a dead rim, which rolls along the ring and over it."""
    parameters = hoopgen.PAPER_COURT | {"ring_restitution": 0.3}
    release = {**LINE, **RELEASE, "speed": 7.29, "azimuth": np.radians(0.9)}
    shots = hoopgen.simulate(
        hoopgen.release(**release), parameters, scene=hoopgen.COURT, record=True
    )
    trajectory = shots.trajectory(0)
    return plot_trajectory(
        trajectory, trajectory.parameters, outcome=trajectory.outcome, three_d=False
    )


PICTURES: Mapping[str, Callable[[], Figure]] = {
    **{f"scene-{name}": partial(own, name) for name in OWN},
    "court-roll": roll,
    "figure-7": figure_7,
    "free-throws": free_throws,
    "outcome-map": outcome_map,
    "probability-map": probability_map,
    "fan": fan,
    "landings": landings,
    "aim-points": aim_points,
    "best-shots": best_shots,
}


def main() -> None:
    """Write the pictures asked for, all by default."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pictures", description=__doc__)
    parser.add_argument("names", nargs="*", help=f"of {', '.join(PICTURES)}; default all")
    parser.add_argument("--out", type=Path, default=Path("docs"), help="folder, default docs")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.names if name not in PICTURES]
    if unknown:
        parser.error(f"no picture is named {', '.join(unknown)}; one of {', '.join(PICTURES)}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name in arguments.names or PICTURES:
        print(save(PICTURES[name](), arguments.out / f"{name}.svg"))


if __name__ == "__main__":
    main()
