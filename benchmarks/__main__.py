"""`python -m benchmarks`: everything side by side; a table, the numbers and a picture.

With `--only grazes` what everybody makes of shots that graze, and no speed; with `--only bodies`
what many bodies cost; with `--only gradients` derivatives through contacts; with `--only air`
flights in air. With `--base REF` instead the working tree beside another commit: the same results,
and how fast.
"""

import argparse
import json
import signal
import sys
from pathlib import Path

from benchmarks import bodies, grazes, grazes_page
from benchmarks.against import Wanted, against
from benchmarks.base import CannotBuild
from benchmarks.families import FAMILIES
from benchmarks.picture import draw
from benchmarks.report import as_json, as_markdown
from benchmarks.run import QUICK, Settings, run
from hoopgen.core.files import write
from hoopgen.plots.style import save

GRAZES = "grazes"
BODIES = "bodies"
GRADIENTS = "gradients"
AIR = "air"
ALONE = (GRAZES, BODIES, GRADIENTS, AIR)
PARTS = ("equality", "speed")


def main() -> None:
    """Measure, then write benchmarks.md, benchmarks.json, benchmarks.svg and those of grazes."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks",
        description="hoopgen beside the other ways to fly the same shots, in under ten minutes.",
    )
    parser.add_argument("--quick", action="store_true", help="about a minute, rougher")
    parser.add_argument("--out", type=Path, default=Path("docs"), help="folder, default docs")
    parser.add_argument(
        "--only",
        choices=(*ALONE, *PARTS),
        help=f"default all; {' and '.join(PARTS)} are those of --base",
    )
    _add_base(parser)
    arguments = parser.parse_args()
    if arguments.only in PARTS and not arguments.base:
        parser.error(f"--only {arguments.only} is a part of the comparison that --base REF makes")
    if arguments.only in ALONE and arguments.base:
        parser.error(f"--base compares {' and '.join(PARTS)}, got --only {arguments.only}")
    if arguments.base:
        sys.exit(_beside(arguments))
    arguments.out.mkdir(parents=True, exist_ok=True)
    if arguments.only == GRADIENTS:
        _gradients(arguments)
        return
    if arguments.only == AIR:
        _air(arguments)
        return
    if arguments.only is None:
        results = run(QUICK if arguments.quick else Settings())
        write(arguments.out / "benchmarks.json", as_json(results))
        write(arguments.out / "benchmarks.md", as_markdown(results))
        save(draw(results.rates), arguments.out / "benchmarks.svg")
        print(as_markdown(results))
    if arguments.only != GRAZES:
        found = bodies.costs(*((10_000, 3) if arguments.quick else (100_000, 9)))
        write(arguments.out / "bodies.json", bodies.as_json(found))
        write(arguments.out / "bodies.md", bodies.as_markdown(found))
        print(bodies.as_markdown(found))
    if arguments.only == BODIES:
        return
    tallies = grazes.tallies(100 if arguments.quick else 1000)
    write(arguments.out / "grazes.json", grazes_page.as_json(tallies))
    write(arguments.out / "grazes.md", grazes_page.as_markdown(tallies))
    print(grazes_page.as_markdown(tallies))


def _gradients(arguments: argparse.Namespace) -> None:
    """Write gradients.md, gradients.json and gradients.svg."""
    # Its truth needs the sources of the derivation, which no other part does.
    from benchmarks.gradients import page
    from benchmarks.gradients.run import run as run_gradients

    results = run_gradients(arguments.quick)
    write(arguments.out / "gradients.json", json.dumps(results, indent=1) + "\n")
    write(arguments.out / "gradients.md", page.as_markdown(results))
    save(page.draw(results), arguments.out / "gradients.svg")
    print(page.as_markdown(results))


def _air(arguments: argparse.Namespace) -> None:
    """Write benchmarks_air.md and benchmarks_air.json."""
    # Its scene is derived and compiled, which takes half a minute if it is not there.
    from benchmarks import air, air_page

    results = air.run(arguments.quick)
    write(arguments.out / "benchmarks_air.json", air.as_json(results))
    write(arguments.out / "benchmarks_air.md", air_page.as_markdown(results))
    print(air_page.as_markdown(results))


def _add_base(parser: argparse.ArgumentParser) -> None:
    default = Wanted()
    base = parser.add_argument_group("another commit of hoopgen instead")
    base.add_argument("--base", metavar="REF", help="git ref of the commit to compare with")
    base.add_argument("--backend", choices=default.backends, help="default both, C in every width")
    base.add_argument("--shots", type=_count, default=default.shots, help="at most, of each kind")
    base.add_argument(
        "--logged",
        type=_count,
        default=default.logged,
        help="how many of them NumPy flies with the event log, which is slow; C all",
    )
    base.add_argument("--rounds", type=_count, default=default.rounds, help="of each speed")
    base.add_argument(
        "--workloads",
        type=_keys,
        default=default.keys,
        metavar="W1,W4,rim",
        help=f"default all: {', '.join(default.keys)}",
    )


def _count(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"expected a whole number, 1 or more, got {text!r}")
    return int(text)


def _keys(text: str) -> tuple[str, ...]:
    known = [family.key for family in FAMILIES]
    keys = tuple(text.split(","))
    if not set(keys) <= set(known):
        raise argparse.ArgumentTypeError(f"expected some of {','.join(known)}, got {text!r}")
    return keys


def _beside(arguments: argparse.Namespace) -> int | str:
    """Return the exit status, 1 if the two are not equal."""
    wanted = Wanted(
        equality=arguments.only != "speed",
        speed=arguments.only != "equality",
        keys=arguments.workloads,
        backends=(arguments.backend,) if arguments.backend else Wanted.backends,
        shots=arguments.shots,
        logged=arguments.logged,
        rounds=arguments.rounds,
    )
    # Ended from outside, too, it leaves no files behind.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    try:
        return int(not against(arguments.base, wanted))
    except CannotBuild as error:
        return f"--base: {error}"


if __name__ == "__main__":
    main()
