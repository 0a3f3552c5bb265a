"""A word for what the C library is built from: the build gives it, and a load compares.

Standard library alone, and nothing of hoopgen: setup.py runs this file by its path.
"""

from __future__ import annotations

from pathlib import Path

__all__ = ["word"]


def word(folder: Path) -> str:
    """Return a word for the names and bytes of the C files in a folder, "" if there are none.

    It is a C identifier: the compiler gets it as the value of a macro, whatever the shell.
    """
    import hashlib  # loads OpenSSL, which importing hoopgen need not

    digest = hashlib.sha256()
    files = sorted(folder.glob("*.[ch]"))
    for file in files:
        text = file.read_bytes()
        digest.update(f"{file.name} {len(text)}\n".encode() + text)
    return f"s{digest.hexdigest()}" if files else ""
