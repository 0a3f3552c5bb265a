"""`python -m benchmarks.attack`: every attack in turn; exit status 1 if anything did not hold."""

import argparse
import itertools
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from . import compilers, files, kills, lines, rows
from .cases import Attack, Tally, attacked
from .report import page, summary

ATTACKS = (files.ATTACK, rows.ATTACK, kills.ATTACK, compilers.ATTACK, lines.ATTACK)


def _run(attacks: Sequence[Attack], arguments: argparse.Namespace) -> list[Tally]:
    """Run each attack for the same time, without its preparation and the end of its last case."""
    tallies: list[Tally] = []
    for attack in attacks:
        with tempfile.TemporaryDirectory(prefix="attack-", ignore_cleanup_errors=True) as name:
            print(f"{attack.title} ...", flush=True)
            attempt = attack.prepare(Path(name))
            tally = attacked(
                attack,
                attempt,
                arguments.seed,
                itertools.count() if arguments.case is None else [arguments.case],
                arguments.keep,
                seconds=60 * arguments.minutes / len(attacks),
            )
        tallies.append(tally)
    return tallies


def main() -> None:
    """Read the command line, attack, and say what it came to."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.attack", description="What should not be able to break hoopgen."
    )
    parser.add_argument("--minutes", type=float, default=5.0, help="in all, default 5")
    parser.add_argument("--seed", type=int, default=1, help="of the random numbers, default 1")
    keys = [attack.key for attack in ATTACKS]
    parser.add_argument("--only", nargs="+", choices=keys, default=keys, metavar="ATTACK")
    parser.add_argument("--case", type=int, help="this one, of the one attack that --only names")
    parser.add_argument(
        "--keep", type=Path, default=Path("attack-findings"), help="folder of what did not hold"
    )
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the page")
    arguments = parser.parse_args()
    if arguments.case is not None and len(arguments.only) != 1:
        parser.error("--case: name one attack with --only")
    attacks = [attack for attack in ATTACKS if attack.key in arguments.only]
    tallies = _run(attacks, arguments)
    print("\n".join(["", *summary(tallies)]))
    if arguments.write:
        arguments.write.write_text(page(tallies, arguments.minutes), encoding="utf-8")
    sys.exit(any(tally.findings for tally in tallies))


if __name__ == "__main__":
    main()
