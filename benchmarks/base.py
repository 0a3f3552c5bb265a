"""The engine of another commit: built by its own setup.py, and flown in a process of its own.

What was built stays in .bench/<commit>/, so that a second run starts at once; `make clean`
removes it.
"""

import io
import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Self

import hoopgen

ROOT = Path(__file__).resolve().parents[1]
TREE = Path(hoopgen.__file__).parent
KEPT = ROOT / ".bench"
LIBRARIES = ("_*.so", "_*.pyd")
"""Names of C libraries, at older commits with an interpreter's tag before the ending."""
C_SOURCES = ("setup.py", "generated/c")
"""Sources of the C library."""


class CannotBuild(Exception):
    """A commit that is not there, or does not build."""


def _run(*command: str | Path, cwd: Path = ROOT) -> bytes:
    try:
        done = subprocess.run(command, cwd=cwd, capture_output=True, check=False)
    except OSError as error:
        raise CannotBuild(f"{command[0]}: {error}") from error
    if done.returncode:
        said = (done.stderr or done.stdout).decode(errors="replace")
        raise CannotBuild(f"{' '.join(map(str, command))}:\n{said}")
    return done.stdout


def commit(ref: str) -> str:
    """Return the commit of a git ref, in full."""
    found = _run("git", "rev-parse", "--verify", "--end-of-options", f"{ref}^{{commit}}")
    return found.decode().strip()


def _checkout(of: str, into: Path) -> None:
    with zipfile.ZipFile(io.BytesIO(_run("git", "archive", "--format=zip", of))) as files:
        files.extractall(into)


def _libraries(package: Path) -> list[Path]:
    return sorted(path.relative_to(package) for name in LIBRARIES for path in package.rglob(name))


def shares(of: str) -> bool:
    """Return whether the working tree's C library, if there is one, is that of a commit too."""
    # Files that git does not know would be compiled as well.
    status = _run("git", "status", "--porcelain", "--", *C_SOURCES)
    same = status == b"" and _run("git", "diff", "--name-only", of, "--", *C_SOURCES) == b""
    return same and bool(_libraries(TREE))


def _build(of: str, source: Path, package: Path) -> str:
    """Build a checked-out commit; return where its C library is from."""
    home = str(package.parent)
    setup = (sys.executable, "setup.py", "--quiet")
    libraries = _libraries(TREE)
    if shares(of):
        _run(*setup, "build_py", "--build-lib", home, cwd=source)
        for library in libraries:
            (package / library).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(TREE / library, package / library)
        return "the working tree's C library, whose sources are the same"
    _run(*setup, "build", "--build-lib", home, cwd=source)
    if libraries and not _libraries(package):
        raise CannotBuild(f"setup.py of {source.name} built no C library, the working tree has one")
    return "its own C library" if _libraries(package) else "no C library"


@contextmanager
def built(of: str) -> Iterator[tuple[Path, str]]:
    """Yield the folder from which to import hoopgen as of a commit, and a word on its library."""
    kept = KEPT / of / sysconfig.get_config_var("SOABI")
    if kept.exists():
        yield kept, "kept from an earlier run"
        return
    KEPT.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(dir=KEPT) as folder:
        source, home = Path(folder, of[:12]), Path(folder, "home")
        _checkout(of, source)
        said = _build(of, source, home / "hoopgen")
        # A library of the working tree may be older than its sources: good for now, not for later.
        if said == "its own C library":
            kept.parent.mkdir(exist_ok=True)
            home.replace(kept)
            home = kept
        yield home, said


class Process:
    """A `benchmarks/worker.py`.

    Parameters
    ----------
    name
        For errors.
    home
        The folder to import hoopgen from; None for the one that is installed.
    """

    def __init__(self, name: str, home: Path | None) -> None:
        self.name = name
        # -P: the modules beside the worker are not its own.
        command = [sys.executable, "-P", str(Path(__file__).with_name("worker.py"))]
        self._process = subprocess.Popen(
            [*command, *([str(home)] if home else [])],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            cwd=tempfile.gettempdir(),
            env={k: v for k, v in os.environ.items() if k != "PYTHONPATH"},
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.kill()
        self._process.communicate()

    def send(self, do: str, **request: Any) -> None:
        """Ask for something; `receive` waits for the answer."""
        assert self._process.stdin is not None
        print(json.dumps({"do": do, **request}), file=self._process.stdin, flush=True)

    def receive(self) -> Any:
        """Return the answer to what was sent last."""
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError(f"{self.name}: its process ended, {self._process.wait()}")
        answer = json.loads(line)
        if "error" in answer:
            raise RuntimeError(f"{self.name}: {answer['error']}")
        return answer["answer"]

    def ask(self, do: str, **request: Any) -> Any:
        """Ask for something and return the answer."""
        self.send(do, **request)
        return self.receive()
