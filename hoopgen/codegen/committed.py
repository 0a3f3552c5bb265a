"""The folder generated/ of a checkout: `generate` writes it, `check` compares it."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Sequence
from pathlib import Path

from hoopgen.core.owned_folders import MARKER, find_store, marker_text, open_store
from hoopgen.derive.scenes import SCENES
from hoopgen.engine.web_assembly import MODULES

from .render import render_elementary, render_scene, render_studies

KEPT = ("__init__.py", "numpy/__init__.py")
"""Files of generated/ that are not generated."""

PURPOSE = "generated code"
"""The content of the marker file of generated/."""


def render_all() -> dict[str, str]:
    """Return the text of every file of generated/, the marker too, by its path below it."""
    files = render_elementary() | render_studies()
    for scene in SCENES:
        files |= render_scene(scene)
    return files | {MARKER: marker_text(PURPOSE, files)}


def generate(
    root: Path, before_writing: Callable[[Sequence[str]], None] = lambda _: None
) -> list[Path]:
    """Write generated/ below `root` and return the files that changed.

    Parameters
    ----------
    root
        A source checkout. Files of generated/ that its marker names and that are no longer
        generated are removed; others that are not generated stay.
    before_writing
        Called before anything is written with the files that will be, by their paths below
        generated/.

    Raises
    ------
    ValueError
        If generated/ has files and no marker, so that it is not hoopgen's.
    FileExistsError
        If a file that hoopgen did not generate has the name of one that is generated.
    OSError
        If a file cannot be read, written or removed.
    """
    folder = root / "generated"
    find_store(folder, PURPOSE)  # before the work
    files = render_all()
    marker = files.pop(MARKER)
    new = [name for name, text in files.items() if not _is(folder / name, text)]
    before_writing(new)
    store = open_store(folder, PURPOSE)
    store.remove_temporaries()
    changed = [] if _is(folder / MARKER, marker) else [folder / MARKER]
    # What is as it is generated may have come with a merge of another branch.
    store.adopt(files.keys() - set(new))
    store.claim(*new)
    for name in new:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        store.write(name, files[name])
    changed += [folder / name for name in (*new, *store.keep_only(files))]
    return changed


def _is(file: Path, text: str) -> bool:
    """Return whether a file has that text, with line ends of any system."""
    return file.is_file() and file.read_bytes().replace(b"\r\n", b"\n") == text.encode()


def check(root: Path) -> list[str]:
    """Return the differences of generated/ below `root` from a new generation.

    Each entry is a missing file, an extra file, or a unified difference; there is none if all is
    as it should be.
    """
    folder = root / "generated"
    files = render_all()
    differences = [f"extra file: generated/{name}" for name in _extra(folder, files)]
    for name, text in files.items():
        path = folder / name
        if not path.exists():
            differences.append(f"missing file: generated/{name}")
            continue
        found = path.read_text(encoding="utf-8", errors="replace")
        if found != text:
            lines = difflib.unified_diff(
                found.splitlines(),
                text.splitlines(),
                f"generated/{name} (as it is)",
                f"generated/{name} (as derived)",
                lineterm="",
                n=1,
            )
            differences.append("\n".join(lines))
    return differences


def _extra(folder: Path, files: dict[str, str]) -> list[str]:
    present = (p for p in folder.rglob("*") if p.is_file() and "__pycache__" not in p.parts)
    names = sorted(p.relative_to(folder).as_posix() for p in present)
    others = {*KEPT, *(f"wasm/{name}" for name in MODULES)}  # the latter have a check of their own
    return [name for name in names if name not in files and name not in others]
