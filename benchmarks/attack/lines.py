"""Absurd command lines: values that nobody means, for every option of every command."""

import signal
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import click
import numpy as np
import pyarrow.csv

from hoopgen.cli import main
from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.variables import VARIABLES

from .cases import Attack, Attempt, Result
from .files import STUDY, table
from .processes import SECONDS, Entry, hoopgen, run, said, wrong

SHOT = {"--speed": "7.17", "--elevation": "51deg", "--height": "7ft", "--distance": "13.75ft"}
PLAYER = {**SHOT, "--scatter": "speed=0.07", "--shots": "200"}
SOUGHT = {name: value for name, value in PLAYER.items() if name != "--elevation"}

MAP = {**PLAYER, "--over": "backspin=0:3Hz:2"}
BATCH = {"file": "releases.csv", "--out": "results.parquet"}

USUAL: tuple[tuple[str, Mapping[str, str]], ...] = (
    ("shot", SHOT),
    ("shot", {**SHOT, "--picture": "shot.svg"}),
    ("shot", {**SHOT, "--view": "shot.html"}),
    ("estimate", PLAYER),
    ("estimate", {**PLAYER, "--folder": "kept", "--precision": "0.1"}),
    ("map", MAP),
    ("map", {**MAP, "--picture": "map.svg", "--out": "map.nc"}),
    ("optimum", {**SOUGHT, "--over": "elevation=50deg:52deg"}),
    ("aim", {"--distance": "13.75ft", "--height": "7ft"}),
    ("aim", {"--distance": "4m:5m:0.5m", "--height": "7ft", "--csv": "aim.csv"}),
    ("batch", BATCH),
    ("batch", {**BATCH, "--measure": "depth"}),
    ("study", {"file": "study.toml"}),
    ("study", {"file": "study.toml", "--check": ""}),
    ("view", {"file": "releases.csv", "--out": "page.html", "--sample": "3"}),
    ("certify", SHOT),
    ("paper", {"--format": "svg"}),
)
"""Small work for each command. Those that are not here write or measure the sources."""

ALTERNATIVE_TO = {"--aim": "--speed", "--entry": "--elevation"}
"""Options that take the place of usual ones."""

AT_LENGTH = {"--shots", "--precision", "--over", "--max-contacts", "--max-bits", "--distance"}
"""Options by which one may ask for more work than anyone waits for; that must heed Ctrl-C."""

CHANGES = {"--set", "--scatter", "--release", "--versus"}
"""Options by which one changes anything."""

OFTEN = 3
"""Factor by which these two are absurd more often than others."""

FLAGS = {
    option.opts[0]
    for command in main.commands.values()
    for option in command.params
    if getattr(option, "is_flag", False)
}

PATIENCE = 8.0
"""Seconds until then."""

NUMBERS = (
    *("0", "-0", "-1", "1", "0.5", "2", "90", "-90", "180", "360", "1e3", "1e6", "1e-3", "-1e-3"),
    *("1e-12", "1e-300", "5e-324", "-5e-324", "1e12", "-1e12", "1e150", "-1e150", "1e300"),
    *("1.7976931348623157e308", "-1.7e308", "0.1e-400"),
)

WHOLE = (
    *("0", "-1", "1", "2", "3", "127", "128", "255", "256", "65536", "2147483646", "2147483647"),
    *("2147483648", "-2147483649", "4294967296", "9007199254740993", "9223372036854775807"),
    *("9223372036854775808", "18446744073709551616", "1" + 100 * "0"),
)

NO_NUMBERS = (
    *("nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e309", "-1e309", "1e5000", "9" * 400),
    *("9" * 5000, "0x10", "1_000", "10**9", "1e", "--1", "1,5", "٣", "²", "½", "∞", "1\u00a0000"),
    *("1e+-5", "1 parsec", "1 m", "1 deg", "1 rpm", "1'", "1°"),
)

TEXTS = (
    *(
        "",
        " ",
        "\t",
        "\n",
        "\r\n",
        "\x01",
        "\x1b[31m",
        "\x7f",
        "\x85",
        "é",
        "e\u0301",
        "日本",
        "💥",
    ),
    *("\u202e", "\u2028", "\ufeff", "\udcff", "$x", "$\\frac{", "{x}", "%s", "%n", "\\", "'", '"'),
    *("<script>", "]]>", "&amp;", "=1+1", "--", "-", "@file", "None", "true", "[1]", "lock", "con"),
    *("../x", "no/such/folder", "/proc/x", ".", "x" * 300, "x" * 5000, "é" * 60_000),
)

SUFFIXES = ("", ".svg", ".png", ".pdf", ".html", ".csv", ".nc", ".parquet", ".arrow", ".toml")


def _one(random: np.random.Generator, choices: tuple[str, ...]) -> str:
    return choices[random.integers(len(choices))]


def _number(random: np.random.Generator, whole: bool = False) -> str:
    if random.integers(6) == 0:
        return _one(random, NO_NUMBERS)
    return _one(random, WHOLE if whole else NUMBERS)


def _name(random: np.random.Generator, names: Iterable[str]) -> str:
    return _one(random, TEXTS) if random.integers(12) == 0 else _one(random, tuple(names))


def _values(random: np.random.Generator, form: str) -> str:
    """Return a number, or several if the option takes them."""
    if form.endswith((":COUNT", ":STEP")) and random.integers(2):
        whole = form.endswith("COUNT")
        return f"{_number(random)}:{_number(random)}:{_number(random, whole)}"
    if form.endswith("LOW:HIGH"):
        return f"{_number(random)}:{_number(random)}"
    if form.endswith(":COUNT"):
        return ",".join(_number(random) for _ in range(random.integers(1, 4)))
    return _number(random, form == "COUNT" or "INTEGER" in form)


def absurd(random: np.random.Generator, option: click.Parameter) -> str:
    """Return a value for an option, mostly of its form."""
    if random.integers(8) == 0:
        return _one(random, TEXTS + NO_NUMBERS)
    form = option.make_metavar(click.Context(main)) if option.param_type_name == "option" else ""
    names = PAPER if option.name == "settings" else VARIABLES
    if isinstance(option.type, click.Choice):
        return _one(random, tuple(option.type.choices))
    if isinstance(option.type, click.Path):
        return _one(random, TEXTS) + _one(random, SUFFIXES)
    if form.startswith("NAME,NAME="):
        return f"{_name(random, names)},{_name(random, names)}={_number(random)}"
    if form.startswith("NAME="):
        return f"{_name(random, names)}={_values(random, form)}"
    if form in ("NAME", "COLUMN", "TEXT", "ADDRESS"):
        return _one(random, TEXTS)
    return _values(random, form)


def line(random: np.random.Generator) -> list[str]:
    """Return a command with one or two absurd arguments; the others are small and usual."""
    name, usual = USUAL[random.integers(len(USUAL))]
    given = dict(usual)
    options = [p for p in main.commands[name].params if p.name not in ("help", "reference")]
    weights = np.array(
        [OFTEN if _typed(option) in AT_LENGTH | CHANGES else 1 for option in options]
    )
    chosen = random.choice(len(options), random.integers(1, 3), p=weights / weights.sum())
    words: list[str] = []
    for option in (options[k] for k in chosen.tolist()):
        typed = _typed(option)
        if not getattr(option, "multiple", False):
            given.pop(typed, None)
        given.pop(ALTERNATIVE_TO.get(typed, ""), None)
        words += _words(typed, "" if getattr(option, "is_flag", False) else absurd(random, option))
    for typed, value in given.items():
        words += _words(typed, value)
    return [name, *words]


def _typed(option: click.Parameter) -> str:
    """Return the option as it is typed, or the name of an argument."""
    return option.opts[0]


def _words(typed: str, value: str) -> list[str]:
    if not typed.startswith("-"):
        return [value]
    return [typed] if typed in FLAGS else [typed, value]


def study(random: np.random.Generator) -> str:
    """Return a study file in which one value is absurd."""
    lines = STUDY.splitlines()
    line = random.choice([k for k, line in enumerate(lines) if " = " in line])
    key, _, _ = lines[line].partition(" = ")
    value = _one(random, NUMBERS + WHOLE + NO_NUMBERS + TEXTS)
    forms = (
        "{}",
        '"{}"',
        '["{}"]',
        "{{ from = {}, to = 1, count = {} }}",
        "{{ {} = 1 }}",
        "[{}, []]",
    )
    lines[line] = f"{key} = {_one(random, forms).format(value, value)}"
    return "\n".join(lines)


@dataclass(frozen=True)
class _Lines:
    files: Mapping[str, bytes]
    entry: Entry

    def attempt(self, random: np.random.Generator, folder: Path) -> Result:
        """Run one command line, in a folder with the usual files."""
        (folder / "work").mkdir()
        for name, content in self.files.items():
            (folder / "work" / name).write_bytes(content)
        words = line(random)
        asked = bool(AT_LENGTH & {*words})
        if words[0] == "study" and random.integers(4):
            content = study(random).encode(errors="surrogateescape")
            (folder / "work" / "study.toml").write_bytes(content)
            asked = True
        seconds, last = (PATIENCE, signal.SIGINT) if asked else (SECONDS, signal.SIGKILL)
        ended = run(words, folder, entry=self.entry, seconds=seconds, last=last)
        return Result(
            wrong(ended, may_take_long=asked), said(words), unforeseen=int(ended.unforeseen)
        )


def prepare(folder: Path, *, entry: Entry = hoopgen) -> Attempt:
    """Write the usual files."""
    releases = table().select(["speed_mph", "elevation_deg", "player"])
    height = [["7"] * len(releases), ["13.75"] * len(releases)]
    for name, column in zip(("height_ft", "distance_ft"), height, strict=True):
        releases = releases.append_column(name, [column])
    pyarrow.csv.write_csv(releases, folder / "releases.csv")
    files = {"releases.csv": (folder / "releases.csv").read_bytes(), "study.toml": STUDY.encode()}
    return _Lines(files, entry).attempt


ATTACK = Attack(
    "lines",
    "absurd command lines",
    "lines",
    "One or two options with absurd values, for each command except those that write the "
    "sources, and study files with one such value: huge, tiny, negative, NaN, infinite, empty, "
    "60,000 letters, control characters, other scripts, halves of surrogates, impossible paths. "
    "The command must end with exit status 0, 1, 2 or 70, one line for an error, no traceback, "
    "at most 4 GB of address space and 20 s. A command that needs more work must end at Ctrl-C.",
    prepare,
)
