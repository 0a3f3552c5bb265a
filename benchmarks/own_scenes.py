"""`python -m benchmarks.own_scenes`: shots in the example scenes held against the judge's proofs.

Writes exactness-scenes.md. Exit status 1 if a shot that the engine did not flag is not as the judge
proves it to be.
"""

import argparse
import runpy
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.decisions import HEAD, Decisions
from benchmarks.machine import facts
from benchmarks.report import table
from hoopgen.core.files import write
from hoopgen.judge.certificate import Certificate
from hoopgen.scene import Scene, load_scene

SCENES = Path(__file__).resolve().parents[1] / "examples" / "scenes"
MAX_CONTACTS = 12
"""Limit of contacts: of balls that bounce ever lower most are flagged by then."""
SHOTS = 2_000
SEED = 12

Floats = NDArray[np.float64]


def states(
    count: int, seed: int, low: tuple[float, ...], high: tuple[float, ...], speed: float
) -> Floats:
    """Return balls within a box, with velocities of that size and spins."""
    rng = np.random.default_rng(seed)
    place = rng.uniform(low, high, (count, 3))
    return np.hstack([place, rng.normal(0, speed, (count, 3)), rng.normal(0, 10, (count, 3))])


def thrown(count: int, seed: int) -> Floats:
    """Return netballs from a few metres away, at the ring, its rim and its post."""
    rng = np.random.default_rng(seed)
    made = np.zeros((count, 9))
    made[:, :3] = rng.uniform([1.5, -2, -1.5], [4, 2, -0.5], (count, 3))
    goal = rng.normal([-0.1, 0, 0], [0.25, 0.15, 0.1], (count, 3))
    low = rng.random(count) < 0.3
    goal[low] = rng.normal([-0.39, 0, -0.3], [0.03, 0.1, 0.2], (count, 3))[low]
    time = rng.uniform(0.9, 1.3, (count, 1)) - 0.5 * low[:, None]
    made[:, 3:6] = (goal - made[:, :3]) / time
    made[:, 5] += 9.81 / 2 * time[:, 0]
    made[:, 6:] = rng.normal(0, 10, (count, 3))
    return made


def putted(count: int, seed: int) -> Floats:
    """Return golf balls that come down near the hole."""
    made = states(count, seed, (-0.08, -0.08, 0.03), (0.06, 0.08, 0.4), 0.1)
    made[:, 3] += np.random.default_rng(seed).uniform(0, 0.8, count)
    return made


def inside(count: int, seed: int) -> Floats:
    """Return balls that are let go in the bowl."""
    return states(count, seed, (-0.5, -0.5, -0.5), (0.5, 0.5, 0.5), 1.5)


def dropped(count: int, seed: int) -> Floats:
    """Return balls that fall onto the bumpers."""
    return states(count, seed, (-0.3, -0.3, 0.8), (0.3, 0.3, 1.2), 0.7)


def poured(count: int, seed: int) -> Floats:
    """Return balls that fly into the funnel, or over its rim."""
    return states(count, seed, (-0.25, -0.25, 0.3), (0.25, 0.25, 0.5), 0.5)


TARGETS = (
    *((-0.25, 0.4), (0.19, 0.3), (0.25, 0.7), (0.0, 1.0), (0.19, 0.5), (0.2, 0.95), (0.0, 0.5)),
    *((-0.1, 0.8), (0.03, 0.72), (-0.13, 0.6), (-0.1, 0.25), (0.06, 0.25)),
)
"""Places on the pinball table: walls, the end of the rail, the arch, the table, bumpers, posts."""


def knocked(count: int, seed: int) -> Floats:
    """Return balls that fly low over the pinball table, at its walls, bumpers and posts."""
    rng = np.random.default_rng(seed)
    made = states(count, seed, (-0.2, 0.3, 0.0), (0.15, 0.9, 0.0), 0.0)
    in_lane = rng.random(count) < 0.1
    made[in_lane, :2] = rng.uniform((0.21, 0.15), (0.23, 0.45), (int(in_lane.sum()), 2))
    which = np.where(in_lane, 1, rng.integers(len(TARGETS), size=count))
    goal = np.asarray(TARGETS)[which] + rng.normal(0, 0.008, (count, 2))
    time = rng.uniform(0.04, 0.08, count)
    made[:, 3:5] = (goal - made[:, :2]) / time[:, None]
    high, slope = rng.uniform(0.016, 0.03, count), 0.12
    made[:, 2] = slope * made[:, 1] + high
    made[:, 5] = slope * made[:, 4] + np.where(which == 6, -high / time, 9.81 * time)
    return made


FILES: Mapping[str, Callable[[int, int], Floats]] = MappingProxyType(
    {
        "netball.toml": thrown,
        "golf.toml": putted,
        "bowl.toml": inside,
        "bumpers.py": dropped,
        "funnel.toml": poured,
        "pinball.toml": knocked,
    }
)
"""The examples, and shots for each."""


def scene_of(file: str) -> Scene:
    """Return an example; one in Python is run, as it is ours."""
    path = SCENES / file
    if path.suffix == ".toml":
        return load_scene(path)
    made: Scene = runpy.run_path(str(path))["SCENE"]
    return made


def judged(file: str, shots: int) -> Decisions:
    """Fly and judge an example."""
    engine = hoopgen.compile(scene_of(file))
    released = FILES[file](shots, SEED)
    flown = engine.simulate(released, max_contacts=MAX_CONTACTS, record=True)
    proved: Certificate = engine.certify(released, max_contacts=MAX_CONTACTS)
    flagged = flown.uncertain.copy()
    flown.uncertain[:] = False  # which would count as right
    same = proved.agrees(flown)
    flown.uncertain[:] = flagged
    result = Decisions(engine.name)
    result.add(flown, proved, same)
    return result


def as_markdown(rows: Sequence[Decisions], seconds: float) -> str:
    """Return the report."""
    cells = [row.cells(row.shots, "**") for row in rows]
    for own, row in zip(cells, rows, strict=True):
        own.insert(3, f"{row.capped:,}")
    lines = [
        "# Exactness of the example scenes",
        "",
        f"`make exactness` simulates {rows[0].shots:,} shots in each scene of `examples/scenes`, "
        f"with at most {MAX_CONTACTS} contacts each, and compares them with `hoopgen.certify`. "
        "[Exactness](exactness.md) explains the columns; here *flagged* is a share of all "
        "shots. A ball that bounces ever lower, as on the green, is capped; a shot with a roll, as "
        "on the pinball table, is undecidable.",
        "",
        *table(["scene", "shots", "contacts", "capped", *HEAD[3:]], cells),
        *(f"{what}: {value}  " for what, value in facts().items() if "peers" not in what),
        f"took: {seconds:.0f} s",
    ]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Judge the examples and write the report."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.own_scenes",
        description="Shots in the example scenes held against proofs in ball arithmetic.",
    )
    parser.add_argument("--shots", type=int, default=SHOTS, help="in each scene, default 2,000")
    parser.add_argument("--out", type=Path, default=Path("docs"), help="folder, default docs")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)  # before the work, should it fail
    started, rows = time.perf_counter(), []
    for file in FILES:
        rows.append(judged(file, arguments.shots))
        print(f"{rows[-1].label}: {rows[-1].shots} shots, {rows[-1].wrong} wrong")
    page = as_markdown(rows, time.perf_counter() - started)
    write(arguments.out / "exactness-scenes.md", page)
    sys.exit(any(row.wrong or row.unseen for row in rows))


if __name__ == "__main__":
    main()
