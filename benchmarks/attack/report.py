"""Reports of attacks: a table for the terminal, and a page."""

from collections.abc import Sequence
from itertools import groupby

from benchmarks.machine import facts
from benchmarks.report import table

from .cases import Finding, Tally

NOT_TRIED = """\
- **Windows** and macOS: the attacks need POSIX. Locks have their own code on Windows
  (`msvcrt.locking`), which no run has tested.
- **Network disks** (NFS, SMB, cluster file systems): locks and renames were tested on a local disk.
- **Loss of power**. hoopgen writes every file beside its place, syncs it, moves it, and syncs the
  folder. SIGKILL tests the order of these steps, not the disk.
- **Other machines**: 32-bit, big-endian, and any processor or libc except the one below.
- **Full or failing disks, and memory that runs out** while others use it. The tests have a full
  disk and a limit on the size of files; the attacks have a limit on the address space.
- **A Dask cluster** under attack: `tests/study/jobs/test_cluster.py` occasionally kills a worker.
- **Files that change while they are read**, and inputs of more than a few kilobytes.
- **A human attacker**: changed bytes are random, and nobody has built a file to deceive a
  checksum or a parser. A damaged cell in a table without checksums is another number, which no
  check can detect."""


def summary(tallies: Sequence[Tally]) -> list[str]:
    """Return a table of the attacks and their results."""
    head = ["attack", "tries", "held", "said in one line, unforeseen", "findings", "seconds"]
    rows = [
        [
            tally.attack.title,
            f"{tally.tries:,} {tally.attack.unit}",
            f"{tally.tries - len(tally.findings):,}",
            str(tally.unforeseen),
            str(len(tally.findings)),
            f"{tally.seconds:.0f}",
        ]
        for tally in tallies
    ]
    return table(head, rows)


def _kind(finding: Finding) -> str:
    """Return the first words of a finding without numbers, which findings of one cause share."""
    words = finding.wrong.split()[:8]
    return " ".join(word for word in words if not any(letter.isdigit() for letter in word))


def _plain(text: str) -> str:
    return text.replace("`", "'").replace("|", "\\|")


def _findings(tally: Tally) -> list[str]:
    rows = []
    for _, group in groupby(sorted(tally.findings, key=_kind), key=_kind):
        alike = list(group)
        first = alike[0]
        rows.append(
            [f"`{_plain(first.wrong)}`", str(len(alike)), f"`{_plain(tally.again(first))}`"]
        )
    return table(["what", "times", "one of them anew"], rows)


def page(tallies: Sequence[Tally], minutes: float) -> str:
    """Return the page."""
    seed = tallies[0].seed
    lines = [
        "# Reliability",
        "",
        f"`make attack` tries to break hoopgen, here for {minutes:g} minutes with the seed "
        f"{seed}. Continuous integration runs it for one minute at each change. `make attack "
        f'ARGS="--minutes {minutes:g} --seed {seed} --write docs/reliability.md"` writes this '
        "page. Each case depends only on the seed and on its number and can be reproduced. The "
        "number of cases depends on the machine.",
        "",
        *summary(tallies),
        "*Said in one line, unforeseen* counts errors that no check foresaw, with exit status "
        "70. They count as held, and each shows a missing check.",
        "",
        "## What is tried",
        "",
        *(f"- **{tally.attack.title}**. {tally.attack.tried}" for tally in tallies),
        "",
        "## What did not hold",
        "",
    ]
    for tally in tallies:
        if tally.findings:
            lines += [f"{tally.attack.title}:", "", *_findings(tally)]
    if not any(tally.findings for tally in tallies):
        lines += ["Nothing, in this run.", ""]
    lines += [
        "## What was not tried",
        "",
        NOT_TRIED,
        "",
        *(f"{what}: {value}  " for what, value in facts().items() if "peers" not in what),
    ]
    return "\n".join(lines).rstrip() + "\n"
