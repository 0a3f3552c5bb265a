"""The premises of a page with their kernels, and what it links on another page instead.

The page of a scene of hoopgen's own does not repeat a premise that the first scene's page has,
nor a kernel below it that has the same formulas there: it links them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from .explain import Formulas
from .premises import DEFINITION, PREMISES

REFERENCE_FILE = "derivation.md"
"""The page of the first scene, which repeats nothing of another."""

FAMILY = re.compile(r"(?:roll|(?:vary_)?air_order|\w+_round)_(\d+)")
"""Pattern of the kernels of a series' orders; each is like the one before, with longer sums."""


def anchor(heading: str) -> str:
    """Return the fragment of a link to a heading."""
    return re.sub(r"[^\w\- ]", "", heading).lower().replace(" ", "-")


@dataclass(frozen=True)
class KernelEntry:
    """A kernel's formulas, summary and source."""

    name: str
    formulas: Formulas
    summary: str
    equation: str

    def says_as(self, other: KernelEntry) -> bool:
        """Return whether another kernel has the same formulas, made of the same objects."""
        own, others = (
            (k.formulas.lines, k.formulas.where, k.summary, k.equation) for k in (self, other)
        )
        return own == others


@dataclass(frozen=True)
class PremiseEntry:
    """A premise, and the kernels that rest on it.

    Attributes
    ----------
    label
        Its kind and its number among the premises of the page.
    title
        Its subject.
    file
        The page that states it; "" for this one.
    kernels
        The names of kernels whose formulas stand below it.
    linked
        The names of kernels whose formulas stand below it on the page that states it.
    omitted
        The names of further kernels of a family, of which the page shows the first two.
    """

    label: str
    title: str
    file: str
    kernels: tuple[str, ...]
    linked: tuple[str, ...]
    omitted: tuple[str, ...]

    @property
    def heading(self) -> str:
        """The heading."""
        return f"{self.label}: {self.title}"

    @property
    def target(self) -> str:
        """The target of a link to the heading."""
        return f"{self.file}#{anchor(self.heading)}"

    @property
    def links(self) -> dict[str, str]:
        """Each kernel's name, linked to its formulas if a page has them."""
        found = {name: f"[`{name}`](#{name})" for name in self.kernels}
        found |= {name: f"[`{name}`]({self.file}#{name})" for name in self.linked}
        return found | {name: f"`{name}`" for name in self.omitted}


def premise_entries(
    stated: Mapping[str, tuple[str, ...]],
    kernels: Mapping[str, KernelEntry],
    reference: Mapping[str, PremiseEntry],
    known: Mapping[str, KernelEntry],
) -> dict[str, PremiseEntry]:
    """Return the premises of a page; lemmas and choices are numbered together.

    Parameters
    ----------
    stated
        The names of the kernels that rest on each premise.
    kernels
        The texts of these kernels.
    reference, known
        The premises and the kernels of the page to link instead of repeating it, if there is one.
        The numbers of further premises follow those of its own.
    """
    texts: dict[str, PremiseEntry] = {}
    count = sum(text.label != DEFINITION for text in reference.values())
    for key, names in stated.items():
        premise, there = PREMISES[key], reference.get(key)
        label = there.label if there else premise.kind
        if label == premise.kind != DEFINITION:
            count += 1
            label = f"{label} {count}"
        linked = tuple(
            name
            for name in names
            if there and name in there.kernels and kernels[name].says_as(known[name])
        )
        orders = {name: FAMILY.fullmatch(name) for name in names}
        omitted = tuple(name for name, order in orders.items() if order and int(order[1]) > 1)
        own = tuple(name for name in names if name not in (*linked, *omitted))
        file = REFERENCE_FILE if there else ""
        texts[key] = PremiseEntry(label, premise.title, file, own, linked, omitted)
    return texts
