"""What attacks came to: a table for the terminal, and a page."""

from collections.abc import Sequence
from itertools import groupby

from benchmarks.machine import facts
from benchmarks.report import table

from .cases import Finding, Tally

NOT_TRIED = """\
- **Windows** and macOS: the attacks need POSIX. Locks have code of their own on Windows
  (`msvcrt.locking`), which nothing here has run.
- **Network disks** (NFS, SMB, cluster file systems): locks and renames are those of a local disk.
- **Loss of power**. Every file that is kept is written beside, synced, and moved, and its folder
  synced; SIGKILL tries the order of these steps, not whether a disk obeys.
- **Other machines**: 32-bit, big-endian, and any processor or libc but the one below.
- **Full or failing disks, and memory that runs out** while others use it. Tests have a full disk
  and a limit on the size of files; the attacks have a limit on the address space.
- **A Dask cluster** under attack: `tests/test_cluster.py` kills a worker
  now and then, no more.
- **Files that change while they are read**, and inputs that are larger than a few kilobytes.
- **Somebody who means it**: flips are random; nobody has built a file to fool a checksum or a
  parser. A damaged cell in a table without checksums is another number, which nobody can see."""


def summary(tallies: Sequence[Tally]) -> list[str]:
    """The table: attacks, and what they came to."""
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
    """What findings of one cause share: their first words, without numbers."""
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
    """The page."""
    seed = tallies[0].seed
    lines = [
        "# Reliability",
        "",
        f"`make attack` tries to break hoopgen, here for {minutes:g} minutes with the seed {seed}; "
        "continuous integration does so for one minute at each change. "
        'This page is made by `make attack ARGS="--minutes '
        f'{minutes:g} --seed {seed} --write docs/reliability.md"`. Cases hang on the seed and on '
        "their number alone, so each can be made anew; how many there are hangs on the machine.",
        "",
        *summary(tallies),
        "*Said in one line, unforeseen*: errors that no check foresaw, with exit status 70; they "
        "count as held, and each is a check that is missing.",
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
