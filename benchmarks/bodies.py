"""The cost of bodies: scenes of 3 to 80 near or far ones, their sources and their C.

Spheres stand in a square, all of other sizes, and balls are dropped among them. Where most are far
they stand in a second square, a hundred metres off. A mixed scene has forty bodies of four kinds.
"""

import json
import os
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from time import process_time

import numpy as np

import hoopgen
from benchmarks.contenders import RESULTS
from benchmarks.machine import facts
from benchmarks.report import table
from benchmarks.timing import Spread
from benchmarks.workloads import States, free_throw
from hoopgen.scene import Box, Cylinder, End, Plane, Scene, Sphere, compilers
from hoopgen.scene.pieces import Body
from hoopgen.simulation.printed_scenes import generate_scene
from hoopgen.simulation.without_bounds import SHOTS_WORTH_A_LOOP

FAR = 100.0
"""Metres from the bodies that balls are dropped among to those that are far."""

NEAR, FAR_AWAY = 3, (37, 77)
"""Bodies that balls are dropped among, and how many more are far."""

MATTERS = ("processor", "cores used", "system", "hoopgen")
"""Facts of the machine that the page gives."""


@dataclass(frozen=True)
class Cost:
    """The cost of a scene; `ratio` is that of a shot to one of the hoop's free throws."""

    name: str
    bodies: int
    far: int
    derived: float
    """Seconds."""
    compiled: float
    """Seconds, for one width; 0: it comes compiled."""
    size: float
    """Size of the printed C, kB."""
    contacts: float
    shot: float
    """Seconds."""
    ratio: Spread


def _place(k: int, far: bool) -> tuple[float, float, float]:
    """Return the place of a body: in a row of a square, no two rows alike."""
    row, column = divmod(k, 7)
    return 0.8 * row + 0.013 * column + FAR * far, 0.8 * column + 0.017 * row, 0.3 + 0.011 * k


def _scene(name: str, bodies: Sequence[Body]) -> Scene:
    return Scene(
        name,
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.8,
        bodies=bodies,
        ends={"down": End(at=-1)},
    )


def spheres(count: int, far: int = 0) -> Scene:
    """Return a scene of spheres, the last of them far."""
    made = [
        Sphere(f"pin_{k}", radius=0.1 + 0.001 * k, centre=_place(k, k >= count - far))
        for k in range(count)
    ]
    return _scene(f"pins_{count}_{far}", made)


def mixed() -> Scene:
    """Return a scene of ten spheres, bars, boxes and shelves each."""
    made: list[Body] = []
    for k in range(40):
        (x, y, z), size = _place(k, far=False), 0.1 + 0.001 * k
        made.append(
            (
                Sphere(f"pin_{k}", radius=size, centre=(x, y, z)),
                Cylinder(
                    f"bar_{k}", radius=size / 2, centre=(x, 0, z), axis="y", span=(y, y + 0.3)
                ),
                Box(f"box_{k}", size=(size, 2 * size, size), centre=(x, y, z)),
                Plane(f"shelf_{k}", at=z, within=_square(x, y, size)),
            )[k % 4]
        )
    return _scene("mixed_40", made)


def _square(x: float, y: float, half: float) -> list[str]:
    sides = (("x", x), ("y", y))
    return [f"{way}({axis} - {at}) - {half}" for axis, at in sides for way in ("", "-")]


def dropped(count: int, bodies: int) -> States:
    """Return balls dropped among so many bodies."""
    rng = np.random.default_rng(bodies)
    rows, columns = -(-bodies // 7), min(bodies, 7)
    states = np.zeros((count, 9))
    states[:, :3] = rng.uniform((-0.4, -0.4, 1.1), (0.8 * rows, 0.8 * columns, 2.0), (count, 3))
    states[:, 3:6] = rng.normal(0, 1, (count, 3))
    states[:, 6:] = rng.normal(0, 5, (count, 3))
    return states


def _busy(call: Callable[[], object]) -> float:
    """Return the processor's time of a call and of what it runs, whatever else keeps it busy."""
    before = os.times()
    call()
    after = os.times()
    return sum(after[:4]) - sum(before[:4])


def _spent(call: Callable[[], object]) -> float:
    """Return the same in finer steps, without what it runs."""
    start = process_time()
    call()
    return process_time() - start


def making_costs(scene: Scene) -> tuple[float, float, float]:
    """Return seconds to derive and to compile a scene, and the kB of its C.

    Raises
    ------
    RuntimeError
        If there is no C compiler, or it fails.
    """
    files: dict[str, str] = {}
    derived = _busy(lambda: files.update(generate_scene(scene).files))
    files = {name[2:]: text for name, text in files.items() if name.startswith("c/")}
    size = sum(map(len, files.values())) / 1000
    compiler = compilers.compiler()
    if compiler is None:
        raise RuntimeError("bodies: expected a C compiler, found none")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file, text in files.items():
            (folder / file).write_text(text, encoding="utf-8")
        options = compilers.processor_lanes().options(scene.name)
        options.append(compilers.loop_option(scene.name, bounds=True))
        said: list[str] = []
        compiled = _busy(lambda: said.append(compiler.run(folder, f"{scene.name}.c", options)[0]))
    if any(said):
        raise RuntimeError(f"bodies: {compiler.name} does not compile {scene.name}: {said[0]}")
    return derived, compiled, size


def costs(shots: int, rounds: int) -> list[Cost]:
    """Return the costs of scenes, first the hoop; each round times every scene once."""
    far = [0, 0, 0, *FAR_AWAY, 0]
    away = [spheres(NEAR + count, count) for count in FAR_AWAY]
    scenes = [spheres(NEAR), spheres(10), spheres(40), *away, mixed()]
    made = [(0.0, 0.0, 0.0), *map(making_costs, scenes)]
    engines = [hoopgen.compile(None), *map(hoopgen.compile, scenes)]
    near = [len(s.bodies) - f for s, f in zip(scenes, far, strict=True)]
    states = [free_throw(shots), *(dropped(shots, count) for count in near)]
    for engine in engines:
        engine.library_without_bounds(SHOTS_WORTH_A_LOOP)  # which is made before anything is timed
    calls = [
        partial(e.simulate, s, backend="c", threads=1, fields=RESULTS)
        for e, s in zip(engines, states, strict=True)
    ]
    contacts = [float(call().contacts.mean()) for call in calls]
    turns = np.array([[_spent(call) / shots for call in calls] for _ in range(rounds)])
    found = []
    for k, engine in enumerate(engines):
        found.append(
            Cost(
                engine.name,
                len(engine.surfaces),
                ([0] + far)[k],
                *made[k],
                contacts[k],
                float(np.median(turns[:, k])),
                Spread.of(turns[:, k] / turns[:, 0]),
            )
        )
    return found


def as_json(found: Sequence[Cost]) -> str:
    """Every number."""
    return json.dumps([asdict(cost) for cost in found], indent=1) + "\n"


def _more(found: Sequence[Cost]) -> list[str]:
    """Describe the cost that a far body adds to a shot, among few and among many."""
    alone = next(c for c in found if c.bodies == NEAR and not c.far and c.compiled)
    each = [
        f"{1000 * (cost.ratio.median - alone.ratio.median) / cost.far:.1f} of {cost.far}"
        for cost in found
        if cost.far
    ]
    return [
        "Each far body adds to the time of a shot, in thousandths of a free throw on the hoop:",
        f"{', '.join(each)}.",
    ]


def as_markdown(found: Sequence[Cost]) -> str:
    """Return the page on the cost of bodies."""
    hoop = found[0]
    rows = []
    for cost in found:
        flights = cost.contacts + 1
        each = cost.ratio.median / flights * (hoop.contacts + 1)
        rows.append(
            [
                cost.name,
                f"{cost.bodies} ({cost.far})",
                f"{cost.contacts:.2f}",
                f"{cost.ratio.median:.2f} ({cost.ratio.lower:.2f}–{cost.ratio.upper:.2f})",
                f"{each:.2f}",
                f"{each / (cost.bodies + 1) * (hoop.bodies + 1):.2f}",
                f"{cost.derived:.1f} s" if cost.compiled else "",
                f"{cost.compiled:.1f} s" if cost.compiled else "",
                f"{cost.size:.0f} KB" if cost.compiled else "",
            ]
        )
    head = [
        "scene",
        "bodies (far)",
        "contacts",
        "a shot",
        "a flight",
        "a flight and surface",
        "derived",
        "compiled",
        "C",
    ]
    machine = {name: value for name, value in facts().items() if name in MATTERS}
    return "\n".join(
        [
            "# Bodies",
            "",
            "`python -m benchmarks --only bodies` writes this page; `bodies.json` contains the "
            "numbers.",
            "",
            *table(["", ""], [[name, f"`{value}`"] for name, value in machine.items()]),
            "",
            "The times are those of the C engine on one thread, with the fields outcome, "
            "contacts and time, as multiples of the time of a free throw on the hoop: median "
            "and quartiles of rounds in which each scene is timed once. A shot has one more "
            "flight than contacts. The hoop has four surfaces including the end. Bodies that "
            "differ only in their sizes share kernels, because sizes are data. The size of the "
            "C code is that of all vector widths and both loops; the compile time is that of one "
            "width and the loop with bounds on errors, as in `hoopgen.compile`. All times are "
            "processor times.",
            "",
            *table(head, rows),
            "",
            *_more(found),
            "",
        ]
    )
