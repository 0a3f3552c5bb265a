"""`python -m benchmarks`: everything side by side; a table, the numbers and a picture."""

import argparse
from pathlib import Path

from benchmarks.picture import draw
from benchmarks.report import as_json, as_markdown
from benchmarks.run import QUICK, Settings, run
from hoopgen.outputs import write
from hoopgen.plots.style import save


def main() -> None:
    """Measure, then write benchmarks.md, benchmarks.json and benchmarks.svg."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks",
        description="hoopgen beside the other ways to fly the same shots, in under ten minutes.",
    )
    parser.add_argument("--quick", action="store_true", help="about a minute, rougher")
    parser.add_argument("--out", type=Path, default=Path("docs"), help="folder, default docs")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    results = run(QUICK if arguments.quick else Settings())
    write(arguments.out / "benchmarks.json", as_json(results))
    write(arguments.out / "benchmarks.md", as_markdown(results))
    save(draw(results), arguments.out / "benchmarks.svg")
    print(as_markdown(results))


if __name__ == "__main__":
    main()
