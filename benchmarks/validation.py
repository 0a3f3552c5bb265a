"""`python -m benchmarks.validation`: results beside those of the literature.

Writes validation.md and its pictures. Every number of ours in it is of the run; the same machine
gives the same bytes.
"""

import argparse
from pathlib import Path

from benchmarks import validation_air, validation_contacts, validation_further
from benchmarks.report import section_of, with_section
from benchmarks.validation_coverage import HEADING, counts, section
from benchmarks.validation_page import page, throw_picture
from benchmarks.validation_results import DISTANCES, everything
from benchmarks.validation_rolling import picture
from hoopgen import PAPER
from hoopgen.core.files import write
from hoopgen.plots import save
from hoopgen.plots.aim_points import plot_aim_points


def main() -> None:
    """Compute everything and write the page."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.validation",
        description="Results beside those of the literature.",
    )
    parser.add_argument("--quick", action="store_true", help="few shots and places, for a look")
    parser.add_argument("--out", type=Path, default=Path("docs"), help="folder, default docs")
    parser.add_argument(
        "--only",
        choices=["coverage", "literature", "further", "air"],
        help="the section on coverage, on further results or on air alone, or all but that on "
        "coverage; the rest stays as it is",
    )
    parser.add_argument(
        "--part", type=float, default=1.0, help="of the repetitions of coverage, default 1"
    )
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)  # before the work, should it fail
    file = arguments.out / "validation.md"
    shots = 1_000 if arguments.quick else 20_000
    if arguments.only == "further":
        write(file, with_section(file.read_text("utf-8"), _further(shots, arguments.out)))
        return
    in_air = 1_000 if arguments.quick else 10_000
    if arguments.only == "air":
        lines = validation_air.section(validation_air.flights(in_air), in_air)
        write(file, with_section(file.read_text("utf-8"), lines))
        return
    if arguments.only == "literature":
        coverage = section_of(file.read_text("utf-8"), HEADING)
    else:
        found = counts(0.05 if arguments.quick else arguments.part)
        coverage = section(found)
    if arguments.only == "coverage":
        write(file, with_section(file.read_text("utf-8"), coverage))
        return
    if arguments.quick:
        results = everything(2_000, 1_000, DISTANCES[-2:])
    else:
        results = everything(50_000, 20_000, DISTANCES)
    save(throw_picture(results), arguments.out / "validation-throws.svg")
    save(plot_aim_points(results.banks.places, PAPER), arguments.out / "validation-bank.svg")
    save(picture(results.bounces), arguments.out / "validation-bounces.svg")
    more = [
        *_further(shots, arguments.out),
        "",
        *validation_air.section(validation_air.flights(in_air), in_air),
    ]
    write(file, page(results, coverage, more))


def _further(shots: int, out: Path) -> list[str]:
    """Return the section on further results, and draw its picture."""
    found = validation_further.further(shots)
    save(validation_contacts.picture(found.contacts), out / "validation-contacts.svg")
    return validation_further.section(found)


if __name__ == "__main__":
    main()
