"""The notation: the LaTeX of the names of arguments, results and series."""

from __future__ import annotations

import re

from .letters import FLIGHTS, IN_AIR, IN_CONTACT, LAWS, LOOP, SERIES, STUDIES, Entry
from .symbols import CHANGE

ARGUMENTS: dict[str, Entry] = FLIGHTS | LOOP | IN_CONTACT | IN_AIR | STUDIES
"""Every argument of a kernel but parameters and the names that `structured` reads."""


SERIES_TERM = re.compile(r"([a-z_]+)_(\d+)")
"""Pattern of a coefficient of a series: its name, and its order."""

ROUNDOFF = r"\mathsf{u}"
"""The unit roundoff; a bold italic u is the slip."""


def latex_name(name: str, words: frozenset[str] = frozenset()) -> str:
    r"""Return the LaTeX of a symbol's name, such as ``\omega_x`` of ``wx``.

    Parameters
    ----------
    name
        The name of a symbol of derive/, or of a kernel's output.
    words
        Names with another meaning here, which are written as words.
    """
    if name in ARGUMENTS and name not in words:
        return ARGUMENTS[name].latex
    if name in LAWS:
        return LAWS[name].latex
    return structured(name) or text(name)


def structured(name: str) -> str | None:
    """Return the LaTeX of a name that its form explains, None for any other."""
    if name.endswith("_after"):
        stem = structured(name.removesuffix("_after"))
        return f"{stem}^+" if stem else None
    match = re.fullmatch(r"d([vwn]?[xyz])", name)
    if match:
        return rf"\delta_{{{structured(match[1])}}}"
    match = re.fullmatch(r"([vwn])([xyz]|[123]{1,2})", name)
    if match:
        return f"{match[1].replace('w', chr(92) + 'omega')}_{{{match[2]}}}"
    match = re.fullmatch(r"(low|high)(\d)", name)
    if match:
        return rf"\{'under' if match[1] == 'low' else 'over'}line t_{match[2]}"
    match = re.fullmatch(r"far_([vw]?[xyz])", name)
    if match:
        return rf"\tilde{{{structured(match[1])}}}"
    if _is_series_term(name):
        series, _, order = name.rpartition("_")
        return f"{SERIES[series].latex}^{{({order})}}"
    if name.startswith("d") and (name[1:] in IN_AIR or _is_series_term(name[1:])):
        return rf"\delta_{{{latex_name(name[1:])}}}"
    match = re.fullmatch(r"([a-z])(\d+)", name)
    if match:
        return f"{match[1]}_{{{match[2]}}}"
    if name.startswith(CHANGE):
        return rf"\delta_{{{text(name.removeprefix(CHANGE))}}}"
    return name if len(name) == 1 else None


def _is_series_term(name: str) -> bool:
    match = SERIES_TERM.fullmatch(name)
    return match is not None and match[1] in SERIES


def text(name: str) -> str:
    """Return a name as words in a formula."""
    return rf"\text{{{' '.join(name.split('_')).strip()}}}"
