"""Cases: how an attack is described, run for a while, and what is kept of its findings."""

import shutil
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np


@dataclass(frozen=True)
class Result:
    """The result of one case.

    `wrong` says what did not hold, nothing if all did; `command` what was run, for a reader.
    `unforeseen` counts errors that no check foresaw and that were said in one line nevertheless.
    """

    wrong: str = ""
    command: str = ""
    tries: int = 1
    unforeseen: int = 0


Attempt = Callable[[np.random.Generator, Path], Result]
"""Makes one case out of random numbers, in an empty folder."""


@dataclass(frozen=True)
class Attack:
    """An attack: its name on the command line, what it is, and what prepares it in a folder.

    `unit` is what is counted, and `tried` says in a sentence or two what is done.
    """

    key: str
    title: str
    unit: str
    tried: str
    prepare: Callable[[Path], Attempt]


@dataclass(frozen=True)
class Finding:
    """A case that did not hold, and where its files are."""

    case: int
    wrong: str
    command: str
    kept: Path


@dataclass
class Tally:
    """The result of an attack."""

    attack: Attack
    seed: int
    tries: int = 0
    unforeseen: int = 0
    seconds: float = 0.0
    findings: list[Finding] = field(default_factory=list)

    def again(self, finding: Finding) -> str:
        """Return the command that reproduces a finding."""
        chosen = f"--only {self.attack.key} --seed {self.seed} --case {finding.case}"
        return f'make attack ARGS="{chosen}"'


def random_of(seed: int, key: str, case: int) -> np.random.Generator:
    """Return the random numbers of a case."""
    return np.random.Generator(
        np.random.Philox(np.random.SeedSequence([seed, case, *key.encode()]))
    )


def attacked(
    attack: Attack,
    attempt: Attempt,
    seed: int,
    cases: Iterable[int],
    keep: Path,
    *,
    seconds: float = float("inf"),
    report: Callable[[str], None] = print,
) -> Tally:
    """Make cases, at least one, until the time is up; keep the files of those that do not hold."""
    tally, start = Tally(attack, seed), time.monotonic()
    for case in cases:
        with tempfile.TemporaryDirectory(prefix="attack-", ignore_cleanup_errors=True) as name:
            folder = Path(name)
            result = attempt(random_of(seed, attack.key, case), folder)
            tally.tries += result.tries
            tally.unforeseen += result.unforeseen
            if result.wrong:
                kept = _kept(folder, keep / f"{attack.key}-{seed}-{case}", result)
                found = Finding(case, result.wrong, result.command, kept)
                tally.findings.append(found)
                report(
                    f"  {found.wrong}\n    {found.command}\n    {tally.again(found)}\n    {kept}"
                )
        tally.seconds = time.monotonic() - start
        if tally.seconds >= seconds:
            break
    return tally


def _kept(folder: Path, to: Path, result: Result) -> Path:
    shutil.rmtree(to, ignore_errors=True)
    shutil.copytree(folder, to, symlinks=True)
    text = f"{result.wrong}\n{result.command}\n"
    (to / "finding.txt").write_text(text, encoding="utf-8", errors="backslashreplace")
    return to
