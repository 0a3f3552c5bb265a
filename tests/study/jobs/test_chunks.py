"""Long work in chunks: in order, kept and gone on with, whatever happens to process or disk."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pa = pytest.importorskip("pyarrow")

from hoopgen.core import lock  # noqa: E402
from hoopgen.study.jobs import chunk_store, chunks  # noqa: E402
from tests.helpers import ROOT, contents  # noqa: E402

CHUNKS = 7


@dataclass(frozen=True)
class Numbers:
    """A job that counts its work: chunk k has a row for each of its numbers, and their roots."""

    chunks: int | None = CHUNKS
    scale: float = 1.0
    computed: list[int] = field(default_factory=list)

    def compute(self, chunk: int) -> Any:
        self.computed.append(chunk)
        numbers = np.arange(100.0 * chunk, 100.0 * (chunk + 1))
        names = pa.array(["even", "odd"] * 50).dictionary_encode()
        return pa.table({"number": numbers, "root": self.scale * np.sqrt(numbers), "name": names})

    def identity(self) -> Mapping[str, Any]:
        return {"job": {"scale": self.scale, "rows": 100}}


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The files of a run that nothing disturbed."""
    folder = tmp_path_factory.mktemp("whole")
    list(chunks.run(Numbers(), folder, threads=2))
    return contents(folder)


def kept(folder: Path) -> list[int]:
    """Chunks in a folder."""
    return sorted(int(file.stem.partition("-")[2]) for file in folder.glob("chunk-*.arrow"))


# In order, lazily


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_chunks_come_in_order_whoever_computes_them(threads: int) -> None:
    job = Numbers()
    tables = list(chunks.run(job, threads=threads))
    assert tables == [job.compute(chunk) for chunk in range(CHUNKS)]


def test_only_a_few_chunks_are_computed_ahead() -> None:
    job = Numbers(chunks=300)
    threads = 2
    tables = chunks.run(job, threads=threads)
    for taken in range(1, 20):
        next(tables)
        assert max(job.computed) < taken - 1 + chunks.AHEAD * threads
    tables.close()
    assert max(job.computed) < taken - 1 + chunks.AHEAD * threads


def test_progress_counts_what_was_given() -> None:
    seen: list[tuple[int, int | None]] = []
    for done, _ in enumerate(
        chunks.run(Numbers(), progress=lambda done, total: seen.append((done, total)))
    ):
        assert seen[-1] == (done, CHUNKS)
    assert seen == [(done, CHUNKS) for done in range(CHUNKS + 1)]


@dataclass(frozen=True)
class Read(Numbers):
    """The same numbers, as something that is read."""

    read: list[int] = field(default_factory=list)

    def tasks(self) -> Iterator[chunks.Task]:
        for chunk in range(CHUNKS):
            self.read.append(chunk)
            yield lambda chunk=chunk: self.compute(chunk)  # type: ignore[misc]


def test_a_stream_is_read_wholly_and_computed_where_chunks_are_missing(tmp_path: Path) -> None:
    list(islice(chunks.run(Read(chunks=None), tmp_path, threads=1), 2))
    there = kept(tmp_path)
    job = Read(chunks=None)
    assert list(chunks.run(job, tmp_path, threads=2)) == list(chunks.run(Numbers()))
    assert job.read == list(range(CHUNKS))
    assert sorted(job.computed) == sorted({*range(CHUNKS)} - {*there})


def test_an_error_of_the_job_is_the_error_of_the_run(tmp_path: Path) -> None:
    class Fails(Numbers):
        def compute(self, chunk: int) -> Any:
            if chunk == 3:
                raise ArithmeticError("chunk 3")
            return super().compute(chunk)

    tables = chunks.run(Fails(), tmp_path, threads=1)
    assert list(islice(tables, 3)) == list(islice(chunks.run(Numbers()), 3))
    with pytest.raises(ArithmeticError, match="chunk 3"):
        next(tables)
    job = Numbers()
    list(chunks.run(job, tmp_path))
    assert not {0, 1, 2} & {*job.computed}


# On disk


def test_finished_chunks_are_read_and_not_computed(tmp_path: Path, whole: dict[str, bytes]) -> None:
    first = list(chunks.run(Numbers(), tmp_path))
    job = Numbers()
    assert list(chunks.run(job, tmp_path)) == first
    assert job.computed == []
    assert contents(tmp_path) == whole


def _flip(file: Path) -> None:
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


DAMAGE = {
    "a bit is wrong": _flip,
    "cut in half": lambda file: os.truncate(file, file.stat().st_size // 2),
    "empty": lambda file: os.truncate(file, 0),
    "longer": lambda file: file.write_bytes(file.read_bytes() + b"\0"),
    "another chunk": lambda file: file.write_bytes(
        file.with_name("chunk-000000005.arrow").read_bytes()
    ),
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_a_damaged_chunk_is_reported_and_it_alone_computed(
    damage: str, tmp_path: Path, whole: dict[str, bytes]
) -> None:
    list(chunks.run(Numbers(), tmp_path))
    DAMAGE[damage](tmp_path / "chunk-000000002.arrow")
    job, said = Numbers(), []
    assert list(chunks.run(job, tmp_path, report=said.append)) == list(chunks.run(Numbers()))
    assert job.computed == [2]
    assert len(said) == 1
    assert "chunk-000000002.arrow is damaged" in said[0]
    assert contents(tmp_path) == whole


def test_a_chunk_of_another_job_is_damage(tmp_path: Path, whole: dict[str, bytes]) -> None:
    list(chunks.run(Numbers(scale=2.0), tmp_path / "other"))
    list(chunks.run(Numbers(), tmp_path / "this"))
    (tmp_path / "other" / "chunk-000000002.arrow").replace(
        tmp_path / "this" / "chunk-000000002.arrow"
    )
    job = Numbers()
    list(chunks.run(job, tmp_path / "this", report=lambda line: None))
    assert job.computed == [2]
    assert contents(tmp_path / "this") == whole


def test_another_job_is_refused_and_told_what_differs(tmp_path: Path) -> None:
    list(chunks.run(Numbers(), tmp_path))
    before = contents(tmp_path)
    with pytest.raises(ValueError, match=r"another job: job\.scale is 1\.0 there and 2\.0 here\. "):
        next(chunks.run(Numbers(scale=2.0), tmp_path))
    assert contents(tmp_path) == before


@pytest.mark.parametrize("package", ["hoopgen", "numpy", "elementary functions"])
def test_chunks_of_other_versions_are_not_taken(package: str, tmp_path: Path) -> None:
    list(chunks.run(Numbers(), tmp_path))
    identity = tmp_path / "identity.json"
    others = json.loads(identity.read_bytes()) | {package: json.dumps("9.9")}
    identity.write_text(json.dumps(others), encoding="utf-8")
    with pytest.raises(ValueError, match=rf'another job: {package} is "9\.9" there and "[^"]*" h'):
        next(chunks.run(Numbers(), tmp_path))


NO_RECORDS = ["{", "[1]", "null", '"text"', "1e400", "[" * 100_000, "\0"]
"""Contents that a damaged file of names and values may have."""


@pytest.mark.parametrize("content", [*NO_RECORDS, '{"hoopgen": 5}', '{"a": ["b"]}'])
def test_an_identity_that_cannot_be_read_is_an_error(content: str, tmp_path: Path) -> None:
    list(chunks.run(Numbers(), tmp_path))
    (tmp_path / "identity.json").write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match=r"identity\.json cannot be read, so it does not say"):
        next(chunks.run(Numbers(), tmp_path))


def test_what_was_left_unfinished_is_removed(tmp_path: Path, whole: dict[str, bytes]) -> None:
    list(chunks.run(Numbers(), tmp_path))
    (tmp_path / ".hoopgen-0123.tmp").write_bytes(b"half")
    list(chunks.run(Numbers(), tmp_path))
    assert contents(tmp_path) == whole


def test_a_folder_is_removed_but_for_what_others_put_there(tmp_path: Path) -> None:
    with chunk_store.opened(tmp_path / "parts", Numbers().identity()) as folder:
        list(chunks.run(Numbers(), folder))
        (tmp_path / "parts" / "notes.txt").touch()
        folder.remove()
    assert {*contents(tmp_path / "parts")} == {"notes.txt", "hoopgen.json"}
    list(chunks.run(Numbers(), tmp_path / "parts"))  # the marker stayed, so it can be used again
    with chunk_store.opened(tmp_path / "more", {}) as folder:
        folder.remove()
    assert not (tmp_path / "more").exists()


# Two at once


def script(body: str, *arguments: str) -> list[str]:
    """Return a command that runs a text of Python with this module at hand."""
    head = f"import sys; sys.path.append({str(ROOT)!r})\n"
    head += "from tests.study.jobs.test_chunks import *\n"
    return [sys.executable, "-c", head + body, *arguments]


HOLD = """
with chunk_store.opened(sys.argv[1], Numbers().identity()):
    print("open", flush=True)
    sys.stdin.read()
"""


@pytest.mark.slow
def test_a_folder_is_for_one_process_until_it_ends_however_it_does(tmp_path: Path) -> None:
    with subprocess.Popen(
        script(HOLD, str(tmp_path)), stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as other:
        assert other.stdout is not None
        assert other.stdout.readline() == b"open\n"
        with pytest.raises(RuntimeError, match="another process is at work in this folder"):
            next(chunks.run(Numbers(), tmp_path))
        other.kill()
    assert len(list(chunks.run(Numbers(), tmp_path))) == CHUNKS


def test_nor_for_two_runs_of_one_process(tmp_path: Path) -> None:
    with (
        chunk_store.opened(tmp_path, {}),
        pytest.raises(RuntimeError, match="another process"),
        chunk_store.opened(tmp_path, {}),
    ):
        pass


def test_a_folder_that_is_removed_is_held_until_then(tmp_path: Path) -> None:
    with chunk_store.opened(tmp_path / "parts", {}) as folder:
        folder.remove()
        with (
            pytest.raises(RuntimeError, match="another process"),
            chunk_store.opened(folder.path, {}),
        ):
            pass
    assert not folder.path.exists()


@pytest.mark.skipif(sys.platform == "win32", reason="there a file that is open stays")
def test_a_lock_is_removed_while_it_is_held(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Let go of before, it may be another's by then."""
    refused, unlink = [], Path.unlink

    def tried(file: Path, missing_ok: bool = False) -> None:
        if file.name == lock.LOCK:
            with (
                pytest.raises(RuntimeError, match="another process"),
                chunk_store.opened(tmp_path, {}),
            ):
                pass
            refused.append(file)
        unlink(file, missing_ok)

    monkeypatch.setattr(Path, "unlink", tried)
    with chunk_store.opened(tmp_path, {}) as folder:
        folder.remove()
    assert refused == [tmp_path / lock.LOCK]


@pytest.mark.parametrize("again", [False, True])
@pytest.mark.parametrize("point", ["before it opens the lock", "before it takes the lock"])
def test_who_opens_a_folder_that_is_being_removed_holds_a_lock_that_others_see(
    point: str, again: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between two steps of one that opens, another removes the folder, a third makes it anew."""
    path = tmp_path / "parts"
    name = "_lock_file" if point == "before it opens the lock" else "_take"
    step = getattr(lock, name)
    with contextlib.ExitStack() as first, contextlib.ExitStack() as third:
        first.enter_context(chunk_store.opened(path, {})).remove()

        def meanwhile(given: Any) -> Any:
            monkeypatch.setattr(lock, name, step)
            first.close()
            if again:
                third.enter_context(chunk_store.opened(path, {}))
            return step(given)

        monkeypatch.setattr(lock, name, meanwhile)
        if again:
            with pytest.raises(RuntimeError, match="another process"), chunk_store.opened(path, {}):
                pass
            return
        with chunk_store.opened(path, {}):
            with pytest.raises(RuntimeError, match="another process"), chunk_store.opened(path, {}):
                pass
            assert {lock.LOCK, "hoopgen.json", "identity.json"} == {*contents(path)}


AT_ONCE = """
import time
path = Path(sys.argv[1])
end = time.monotonic() + 60
for turn in range(100):
    while True:
        assert time.monotonic() < end
        try:
            with chunk_store.opened(path, {}) as folder:
                os.close(os.open(f"{path}.held", os.O_CREAT | os.O_EXCL))
                os.unlink(f"{path}.held")
                folder.remove()
            break
        except RuntimeError:
            pass
"""


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    (tmp_path / "parts").touch()
    with pytest.raises(FileExistsError), chunk_store.opened(tmp_path / "parts", {}):
        pass


# What is no file, and no folder


def pipe(path: Path) -> None:
    os.mkfifo(path)


def folder(path: Path) -> None:
    path.mkdir()


def loop(path: Path) -> None:
    path.symlink_to(path.name)


@pytest.mark.skipif(sys.platform == "win32", reason="there are no pipes, and links need rights")
@pytest.mark.parametrize("what", [pipe, folder, loop])
@pytest.mark.parametrize("name", ["chunk-000000002.arrow", "identity.json", lock.LOCK])
def test_what_is_no_file_is_named_and_not_waited_for(
    name: str, what: Callable[[Path], None], tmp_path: Path, whole: dict[str, bytes]
) -> None:
    list(chunks.run(Numbers(), tmp_path))
    (tmp_path / name).unlink(missing_ok=True)
    what(tmp_path / name)
    with pytest.raises(FileExistsError, match="this is no file; move it away") as raised:
        list(chunks.run(Numbers(), tmp_path))
    assert raised.value.filename == str(tmp_path / name)
    left = {file.name: file.read_bytes() for file in tmp_path.iterdir() if file.is_file()}
    assert left == {file: content for file, content in whole.items() if file != name}


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_a_lock_that_leads_elsewhere_makes_nothing_there(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / lock.LOCK).symlink_to(tmp_path / "elsewhere")
    with pytest.raises(FileExistsError, match="this is no file; move it away"):
        next(chunks.run(Numbers(), tmp_path / "parts"))
    assert not (tmp_path / "elsewhere").exists()
    (tmp_path / "elsewhere").write_bytes(b"of somebody else")
    with pytest.raises(FileExistsError, match="this is no file; move it away"):
        next(chunks.run(Numbers(), tmp_path / "parts"))
    assert (tmp_path / "elsewhere").read_bytes() == b"of somebody else"


@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="there is no /proc")
def test_a_folder_that_cannot_be_made_or_written_is_named() -> None:
    path = "/proc/hoopgen"
    with pytest.raises(OSError, match="this folder cannot be made or written") as raised:
        next(chunks.run(Numbers(), path))
    assert raised.value.filename == path


def test_nor_one_in_a_file_or_in_the_place_of_a_link(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(NotADirectoryError):
        next(chunks.run(Numbers(), tmp_path / "file" / "parts"))
    (tmp_path / "link").symlink_to("nowhere")
    for name in ("file", "link"):
        with pytest.raises(FileExistsError, match="this is no folder"):
            next(chunks.run(Numbers(), tmp_path / name))


def test_a_folder_has_a_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ValueError, match="folder: expected a name, got ''"):
        next(chunks.run(Numbers(), ""))
    assert not [*tmp_path.iterdir()]


def test_a_file_system_without_locks_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fcntl = pytest.importorskip("fcntl")

    def refused(*_: Any) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    monkeypatch.setattr(fcntl, "flock", refused)
    with pytest.raises(OSError, match=r"this folder cannot be locked \(No locks") as raised:
        next(chunks.run(Numbers(), tmp_path))
    assert raised.value.filename == str(tmp_path)


def test_a_folder_without_a_chunk_is_not_left_behind(tmp_path: Path) -> None:
    class Fails(Numbers):
        def compute(self, chunk: int) -> Any:
            raise ArithmeticError

    with pytest.raises(ArithmeticError):
        next(chunks.run(Fails(), tmp_path / "parts"))
    assert not [*tmp_path.iterdir()]


@pytest.mark.slow
def test_many_that_make_and_remove_a_folder_are_never_in_it_at_once(tmp_path: Path) -> None:
    at_once = [
        subprocess.Popen(script(AT_ONCE, str(tmp_path / "parts")), stderr=subprocess.PIPE)
        for _ in range(3)
    ]
    assert [process.communicate()[1] for process in at_once] == [b""] * len(at_once)
    assert not [*tmp_path.iterdir()]


# Killed

KILLED = """
import contextlib, threading
folder, point, count = Path(sys.argv[1]), sys.argv[2], int(sys.argv[3])
lock = threading.Lock()

def pass_by():
    with lock:
        left[0] -= 1
        if left[0] == 0:
            os.kill(os.getpid(), signal.SIGKILL)

left, sync, written = [count], os.fsync, chunk_store.written

def fsync(descriptor):
    pass_by()
    sync(descriptor)

@contextlib.contextmanager
def half(path, temporary):
    with written(path, temporary) as file:
        class Half:
            def write(self, data):
                file.write(data[: len(data) // 2])
                file.flush()
                pass_by()
                file.write(data[len(data) // 2 :])
        yield Half()

if point == "sync":
    os.fsync = fsync
else:
    chunk_store.written = half
for table in chunks.run(Numbers(), folder, threads=2):
    pass
"""


@pytest.mark.parametrize(
    ("point", "count"),
    [
        ("sync", 1),  # of the identity, before it has its name
        ("sync", 2),  # and of the folder, after
        ("sync", 3),  # of a chunk
        ("sync", 8),
        ("sync", 2 * CHUNKS + 2),  # of the folder, with the last chunk
        ("write", 7),  # a file half written
        ("write", 2 * CHUNKS),
    ],
)
@pytest.mark.sampled(1)
def test_a_run_that_was_killed_goes_on_to_the_same_bytes(
    point: str, count: int, tmp_path: Path, whole: dict[str, bytes]
) -> None:
    killed = subprocess.run(script(KILLED, str(tmp_path), point, str(count)), check=False)
    assert killed.returncode == -signal.SIGKILL
    there = kept(tmp_path)
    for chunk in there:
        name = f"chunk-{chunk:09d}.arrow"
        assert (tmp_path / name).read_bytes() == whole[name]
    job = Numbers()
    assert list(chunks.run(job, tmp_path)) == list(chunks.run(Numbers()))
    assert sorted(job.computed) == sorted({*range(CHUNKS)} - {*there})
    assert contents(tmp_path) == whole


SLOW = """
import time
class Slow(Numbers):
    def compute(self, chunk):
        time.sleep(0.05)
        return super().compute(chunk)

job = Slow(chunks=None)
with chunk_store.opened(sys.argv[1], job.identity()) as folder:
    for table in chunks.run(job, folder, threads=2):
        print("chunk", flush=True)
"""


@pytest.mark.slow
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_a_run_that_was_stopped_from_outside_keeps_what_is_finished(
    how: signal.Signals, tmp_path: Path, whole: dict[str, bytes]
) -> None:
    with subprocess.Popen(
        script(SLOW, str(tmp_path)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as slow:
        assert slow.stdout is not None
        for _ in range(3):
            assert slow.stdout.readline() == "chunk\n"
        slow.send_signal(how)
        _, said = slow.communicate()
    assert slow.returncode == -how
    assert {0, 1, 2} <= {*kept(tmp_path)}
    if how == signal.SIGINT:
        assert not list(tmp_path.glob("*.tmp"))
        assert f"finished chunks are in {tmp_path}: the same call goes on from there" in said
    job = Numbers()
    list(chunks.run(job, tmp_path))
    assert not {0, 1, 2} & {*job.computed}
    assert whole.items() <= contents(tmp_path).items()


# A full disk


def test_a_full_disk_is_told_and_costs_what_was_not_finished(
    tmp_path: Path, whole: dict[str, bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    tables = chunks.run(Numbers(), tmp_path, threads=1)
    next(tables)
    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", full)
        with pytest.raises(OSError, match="No space left on device; finished chunks") as raised:
            list(tables)
    assert raised.value.errno == errno.ENOSPC
    assert Path(raised.value.filename).match("chunk-*.arrow")
    assert not list(tmp_path.glob("*.tmp"))
    assert 0 in kept(tmp_path)
    assert contents(tmp_path).items() <= whole.items()
    list(chunks.run(Numbers(), tmp_path))
    assert contents(tmp_path) == whole


LIMITED = """
import resource
tables = chunks.run(Numbers(), sys.argv[1], threads=1)
next(tables)
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, resource.RLIM_INFINITY))
list(tables)
"""


@pytest.mark.slow
def test_a_write_that_the_system_refuses_leaves_no_half_file(
    tmp_path: Path, whole: dict[str, bytes]
) -> None:
    limited = subprocess.run(
        script(LIMITED, str(tmp_path)), check=False, stderr=subprocess.PIPE, text=True
    )
    assert limited.returncode == 1
    assert "File too large; finished chunks are kept" in limited.stderr
    assert not list(tmp_path.glob("*.tmp"))
    assert contents(tmp_path).items() <= whole.items()
    assert len(list(chunks.run(Numbers(), tmp_path))) == CHUNKS


# Bad input


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"threads": 0}, "threads: expected a whole number from 1, or None, got 0"),
        ({"threads": 2, "scheduler": "tcp://127.0.0.1:1"}, "threads: with a scheduler"),
    ],
)
def test_bad_arguments_are_refused(options: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        next(chunks.run(Numbers(), **options))
