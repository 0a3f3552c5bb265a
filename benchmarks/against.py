"""`make bench ARGS="--base <git ref>"`: the working tree beside the engine of another commit.

Equality: every field and the event log, shot by shot, in NumPy and in C of every width. Speed: turn
about, the ratio taken round by round, of clock and of processor time.
"""

import tempfile
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from benchmarks.base import CannotBuild, Process, built, commit
from benchmarks.contenders import CORES, RESULTS
from benchmarks.families import FAMILIES, Family
from benchmarks.report import number, short, table
from benchmarks.timing import TURN, Spread
from benchmarks.workloads import WORKLOADS
from hoopgen.engine.native import WIDTHS

Array = NDArray[Any]

PATH = ("outcome", "contacts", "counts", "first", "time", "state")
BOUNDS = ("uncertain", "time_error", "state_error")
"""Fields for which an engine bounds errors; without them it runs its plain loop."""

LOGGED = 1 << 14
"""Shots whose event log is compared at a time: 200 bytes a row, up to 41 rows a shot."""

FLOWN_IN_NUMPY = 1 << 16
"""Shots of a turn of NumPy, or half as many and so on: a turn is to take `LONGEST` at the most."""

LONGEST = 1.0
"""Seconds."""

EXAMPLES = 3


@dataclass(frozen=True)
class Wanted:
    """The extent of a comparison.
    with the log in NumPy, which then works a thousand at a time, slowly; rounds of each speed."""

    equality: bool = True
    speed: bool = True
    keys: Sequence[str] = tuple(family.key for family in FAMILIES)
    backends: Sequence[str] = ("numpy", "c")
    shots: int = 1 << 20
    logged: int = 1 << 15
    rounds: int = 15


@dataclass(frozen=True)
class Pair:
    """The two contenders."""

    base: Process
    tree: Process

    def ask(self, do: str, **request: Any) -> tuple[Any, Any]:
        """Ask both, who work at the same time. What is a mapping is by side, "base" and "tree"."""
        for side, process in (("base", self.base), ("tree", self.tree)):
            own = {k: v[side] if isinstance(v, dict) else v for k, v in request.items()}
            process.send(do, **own)
        return self.base.receive(), self.tree.receive()


# --------------------------------------------------------------------------------------- equality


def differing(base: Array, tree: Array) -> NDArray[np.intp]:
    """Return the rows that are not equal, NaN being equal to NaN."""
    if base.dtype.names:
        columns = [differing(base[name], tree[name]) for name in base.dtype.names]
        return np.unique(np.concatenate(columns))
    same = base == tree
    if np.issubdtype(base.dtype, np.floating):
        same |= np.isnan(base) & np.isnan(tree)
    return np.flatnonzero(~same.reshape(len(base), -1).all(axis=1))


def _other_bits(base: Array, tree: Array) -> bool:
    return base.dtype == tree.dtype and base.tobytes() != tree.tobytes()


def _shots(name: str, base: Array, tree: Array) -> NDArray[np.intp]:
    """Return the shots of which a field, or the log's rows, are not equal."""
    if name != "events":
        return differing(base, tree)
    missing = set(base.dtype.names or ()) - set(tree.dtype.names or ())
    if missing:
        raise RuntimeError(f"events: the working tree has no column {', '.join(sorted(missing))}")
    if np.array_equal(base["shot"], tree["shot"]):
        return np.unique(base["shot"][differing(base, tree)])
    most = 1 + int(max(log["shot"].max(initial=-1) for log in (base, tree)))
    return np.flatnonzero(
        np.bincount(base["shot"], minlength=most) != np.bincount(tree["shot"], minlength=most)
    )


@dataclass
class Verdict:
    """The comparison of one engine on a family: the number of shots, and where the two differ."""

    flown: int = 0
    logged: int = 0
    other_bits: bool = False

    def __post_init__(self) -> None:
        self.wrong: set[int] = set()
        self.examples: list[str] = []

    def __str__(self) -> str:
        if self.wrong:
            return f"**{len(self.wrong):,} differ**"
        return f"== {self.flown:,}, log {self.logged:,}" + (" (other bits)" * self.other_bits)


class Equality:
    """Compares what two contenders write into two folders."""

    def __init__(self, pair: Pair, folder: Path, logged: int = Wanted.logged) -> None:
        self._pair = pair
        self._logged = logged
        self._file = folder / "shots.npz"
        self._out = {side: folder / side for side in ("base", "tree")}
        for out in self._out.values():
            out.mkdir()

    def of(self, family: Family, shots: int, engines: Iterable[str]) -> dict[str, Verdict]:
        """Fly a family on every engine: bounded and plain at once, and its log part by part."""
        states, parameters = family.make(shots)
        np.savez(self._file, states=states, **parameters)
        self._pair.ask("load", file=str(self._file))
        verdicts = {}
        for engine in engines:
            verdict = verdicts[engine] = Verdict(shots)
            self._compare(verdict, engine, (0, shots), PATH + BOUNDS, False)
            self._compare(verdict, engine, (0, shots), PATH, False)
            verdict.logged = min(shots, self._logged) if engine == "numpy" else shots
            for low in range(0, verdict.logged, LOGGED):
                rows = (low, min(low + LOGGED, verdict.logged))
                self._compare(verdict, engine, rows, PATH + BOUNDS, True)
                if low == 0:
                    self._compare(verdict, engine, rows, PATH, True)
        return verdicts

    def _compare(
        self,
        verdict: Verdict,
        engine: str,
        rows: tuple[int, int],
        fields: Sequence[str],
        record: bool,
    ) -> None:
        request = {"engine": engine, "threads": 1, "rows": rows, "fields": fields, "record": record}
        names, _ = self._pair.ask("fly", out={k: str(v) for k, v in self._out.items()}, **request)
        for name in names:
            base, tree = (np.load(self._out[side] / f"{name}.npy") for side in self._out)
            wrong = _shots(name, base, tree)
            verdict.wrong.update((rows[0] + wrong).tolist())
            verdict.other_bits |= not len(wrong) and _other_bits(base, tree)
            if len(wrong) and len(verdict.examples) < EXAMPLES:
                at = int(wrong[0])
                before, after = (
                    array[array["shot"] == at] if name == "events" else array[at]
                    for array in (base, tree)
                )
                with np.printoptions(floatmode="unique"):
                    verdict.examples.append(
                        f"{engine}, {name}{'' if set(BOUNDS) & set(fields) else ', plain'}: "
                        f"{len(wrong):,} shots, the first is {rows[0] + at}\n"
                        f"    base {before}\n    tree {after}"
                    )


def equality(pair: Pair, wanted: Wanted, engines: Sequence[str]) -> bool:
    """Compare every family; print a row for each, then where they differ."""
    print("\n".join(table(["equal", *engines], [])[:-1]), flush=True)
    examples = []
    parent = "/dev/shm" if Path("/dev/shm").is_dir() else None  # some 100 MB at a time
    with tempfile.TemporaryDirectory(dir=parent) as folder:
        compare = Equality(pair, Path(folder), wanted.logged)
        for family in (family for family in FAMILIES if family.key in wanted.keys):
            verdicts = compare.of(family, min(wanted.shots, _size(family)), engines)
            cells = map(str, verdicts.values())
            print(f"| {family.key} {family.label} | {' | '.join(cells)} |", flush=True)
            found = (text for verdict in verdicts.values() for text in verdict.examples)
            examples += [f"{family.key}: {text}" for text in found]
    print("", *examples, sep="\n")
    return not examples


def _size(family: Family) -> int:
    sizes = {workload.key: workload.size for workload in WORKLOADS}
    return sizes.get(family.key, 1 << 20)


# ------------------------------------------------------------------------------------------ speed


@dataclass(frozen=True)
class Ratios:
    """Base over tree, round by round: above 1 the working tree is the faster."""

    wall: Spread
    cpu: Spread
    rate: float
    """Shots a second of the base, the median."""


def turn_about(pair: Pair, shots: int, rounds: int, **request: Any) -> Ratios:
    """Time both in turn, each first in every other round."""
    request["repeats"] = 1
    while True:
        request["rows"] = (0, shots)
        warm = max(side.ask("time", **request)["wall"] for side in (pair.base, pair.tree) * 2)
        if request["engine"] != "numpy" or warm <= LONGEST or shots < 2:
            break
        shots //= 2
    request["repeats"] = max(1, round(TURN / warm))
    taken: dict[str, list[Mapping[str, float]]] = {"base": [], "tree": []}
    for turn in range(rounds):
        order = [("base", pair.base), ("tree", pair.tree)]
        for name, side in order[:: -1 if turn % 2 else 1]:
            taken[name].append(side.ask("time", **request))
    both = list(zip(taken["base"], taken["tree"], strict=True))
    wall, cpu = (Spread.of(base[k] / tree[k] for base, tree in both) for k in ("wall", "cpu"))
    return Ratios(wall, cpu, shots / Spread.of(base["wall"] for base, _ in both).median)


def _ratio(spread: Spread) -> str:
    return f"{spread.median:.3f} ({spread.lower:.3f}–{spread.upper:.3f})"


def speed(pair: Pair, wanted: Wanted, engines: Collection[str]) -> None:
    """Time every workload on C and NumPy, one thread and all, three fields and all of them."""
    head = ["times as fast as the base", "threads", "fields", "processor", "clock", "base shots/s"]
    print("\n".join(table(head, [])[:-1]), flush=True)
    medians: dict[str, list[float]] = {}
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder, "shots.npz"))
        for workload in (workload for workload in WORKLOADS if workload.key in wanted.keys):
            shots = min(wanted.shots, workload.size)
            (family,) = (family for family in FAMILIES if family.key == workload.key)
            states, parameters = family.make(shots)
            np.savez(file, states=states, **parameters)
            pair.ask("load", file=file)
            for engine in (engine for engine in ("c", "numpy") if engine in engines):
                flown = min(shots, FLOWN_IN_NUMPY) if engine == "numpy" else shots
                for threads in sorted({1, CORES}):
                    for label, fields in (("three", RESULTS), ("all", "all")):
                        ratios = turn_about(
                            pair,
                            flown,
                            wanted.rounds,
                            engine=engine,
                            threads=threads,
                            fields=fields,
                        )
                        medians.setdefault(engine, []).append(ratios.cpu.median)
                        cells = (_ratio(ratios.cpu), _ratio(ratios.wall), short(ratios.rate))
                        row = (f"{workload.key} {engine}", str(threads), label, *cells)
                        print(f"| {' | '.join(row)} |", flush=True)
    print()
    for engine, values in medians.items():
        low, middle, high = (number(f(values)) for f in (min, np.median, max))
        print(f"{engine}: {middle} times as fast by processor time, from {low} to {high}")


# ------------------------------------------------------------------------------------------- both


@dataclass(frozen=True)
class Engines:
    """The engines of the base that can be compared.

    Attributes
    ----------
    both
        Those that the working tree has, too.
    given_up
        Widths that it no longer says it has: not compared, and no fault.
    lost
        What it should have.
    """

    both: tuple[str, ...]
    given_up: tuple[str, ...]
    lost: tuple[str, ...]

    @classmethod
    def of(cls, base: Sequence[str], tree: Sequence[str], widths: Collection[int]) -> Self:
        """Return the engines that both have, by the widths of the working tree."""
        kept = {f"c {width}" for width in widths} | {"c", "numpy"}
        gone = [engine for engine in base if engine not in tree]
        return cls(
            tuple(engine for engine in base if engine in tree),
            tuple(engine for engine in gone if engine not in kept),
            tuple(engine for engine in gone if engine in kept),
        )


def against(ref: str, wanted: Wanted) -> bool:
    """Return whether the working tree gives what the commit gave, where that was asked for."""
    base = commit(ref)
    with (
        built(base) as (home, said),
        Process("base", home) as before,
        Process("tree", None) as after,
    ):
        print(f"base: {ref}, {base[:12]}, {said}", flush=True)
        return compare(Pair(before, after), wanted)


def compare(pair: Pair, wanted: Wanted) -> bool:
    """Return whether both contenders give the same, where that was asked for."""
    before, after = (
        [engine for engine in there if engine.split()[0] in wanted.backends]
        for there in pair.ask("engines")
    )
    engines = Engines.of(before, after, WIDTHS)
    fresh = [engine for engine in after if engine not in before]
    parts = {
        "engines": engines.both,
        "given up, not compared": engines.given_up,
        "new, not compared": fresh,
        "LOST": engines.lost,
    }
    said = (f"{what}: {', '.join(which)}" for what, which in parts.items() if which)
    print("; ".join(said), end="\n\n")
    if not engines.both:
        raise CannotBuild("the two have no engine in common")
    same = not engines.lost
    if wanted.equality:
        same &= equality(pair, wanted, engines.both)
        print("equal" if same else "NOT equal, or lost", end="\n\n", flush=True)
    if wanted.speed:
        speed(pair, wanted, engines.both)
    return same
