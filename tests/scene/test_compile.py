"""Scenes of one's own, compiled: the same bits, kept on disk, and nothing trusted by its name."""

from __future__ import annotations

import errno
import functools
import io
import os
import pickle
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.cli import main
from hoopgen.codegen import render
from hoopgen.core.owned_folders import MARKER, find_store
from hoopgen.engine import native
from hoopgen.scene import End, Parameter, Plane, Scene, Sphere, cache, compilers
from hoopgen.simulation import backend_choice, without_bounds
from hoopgen.simulation import compile as compiling
from hoopgen.simulation.engine import Engine
from hoopgen.text.shorten import brief
from tests.helpers import ROOT
from tests.helpers.compiled import needs_compiler
from tests.helpers.environment import FLAGS, MODES, control, in_a_thread, linux_on_x86, set_control
from tests.helpers.own_scenes import compiling_as_for_users
from tests.helpers.scenes.table import TABLE

# One worker: what is compiled once serves them all.
pytestmark = [pytest.mark.xdist_group("compile"), needs_compiler]

DOME = Scene(
    "dome",
    parameters=[
        Parameter("ball", 0.05),
        Parameter("reach", 1.0),
        Parameter("bounce", 0.8, "1", upper=1.0),
        Parameter("g", 9.81, "m/s²"),
    ],
    ball_radius="ball",
    gravity="g",
    restitution="bounce",
    bodies=[
        Plane("floor", within=["x - reach", "-x - reach"]),
        Sphere("dome", radius="reach/4", centre=(0.2, 0, 0), restitution="bounce/2"),
    ],
    ends={"cup": End(at=-1, within=["x**2 + y**2 - reach**2 - 1"]), "out": End(at=-1)},
)
PLANK = replace(DOME, name="plank", bodies=DOME.bodies[:1])
"""The least that there is to compile."""

FILE = """\
name = "post"
ball_radius = 0.05
gravity = 9.81
restitution = 0.5

[bodies.post]
kind = "cylinder"
radius = 0.1

[ends.down]
at = -1.0
"""

posix = pytest.mark.skipif(os.name != "posix", reason="signals, modes and scripts are POSIX's")


def drops(count: int, seed: int = 1) -> NDArray[np.float64]:
    """Return balls let go over the floor, some beside it."""
    rng = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, :3] = rng.uniform((-1.1, -0.5, 0.4), (1.1, 0.5, 1.5), (count, 3))
    states[:, 3:6] = rng.normal(0, 1, (count, 3))
    states[:, 6:] = rng.normal(0, 20, (count, 3))
    return states


@pytest.fixture(scope="module", autouse=True)
def printed_once() -> Iterator[None]:
    """Print each scene once."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(render, "render_scene", functools.cache(render.render_scene))
        yield


def forget() -> None:
    """Make the next call that of a new process."""
    compiling._KEY_BY_IDENTITY.clear()
    compiling._ENGINES.clear()
    cache.process_store.cache_clear()
    cache._warn_once.cache_clear()
    backend_choice._warn_once.cache_clear()


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder of caches of one's own, in a place with spaces."""
    folder = tmp_path / "a place, with späces"
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder))
    forget()
    yield folder / "hoopgen" / "scenes"
    forget()


@pytest.fixture(scope="module")
def dome(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        return hoopgen.compile(DOME)


class Wrapped:
    """A compiler that notes its calls, and does what a file beside it says."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder = folder
        script = folder / "cc of one's own"
        script.write_text(
            "#!/bin/sh\n"
            f'here="{folder}"\n'
            'case "$*" in *--version*) echo 1.0; exit 0;; esac\n'
            'echo run >> "$here/runs"\n'
            'if [ -e "$here/before" ]; then . "$here/before"; fi\n'
            f'exec {shutil.which("gcc") or shutil.which("cc")} "$@"\n'
        )
        script.chmod(0o700)
        monkeypatch.setenv("CC", f"'{script}'" if "'" not in str(script) else f'"{script}"')

    @property
    def runs(self) -> int:
        """Number of calls to compile."""
        file = self.folder / "runs"
        return len(file.read_text().splitlines()) if file.exists() else 0

    def first(self, commands: str) -> None:
        """Let it do something before it compiles; "" for nothing."""
        file = self.folder / "before"
        file.write_text(commands) if commands else file.unlink()


@pytest.fixture
def wrapped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Wrapped:
    return Wrapped(tmp_path, monkeypatch)


def entry_of(home: Path) -> Path:
    (key,) = cache.Cache(home).keys()
    return home / key


PROCESS = """
import sys
sys.path.insert(0, {tests!r})
from tests.helpers.own_scenes import compile_soonest
import hoopgen, test_scene_of_processes as own
compile_soonest()
engine = hoopgen.compile(own.DOME)
print(engine.backend, engine.simulate(own.STATES).state.tobytes().hex(), "sympy" in sys.modules)
"""


def process(folder: Path, *before: str, **options: Any) -> subprocess.Popen[str]:
    """Start a process, by a command `before`, that compiles the scene and says how shots ended."""
    (folder / "test_scene_of_processes.py").write_text(
        "import numpy as np\n"
        "from hoopgen.scene import End, Parameter, Plane, Scene\n"
        "DOME = Scene('plank', parameters=[Parameter('ball', 0.05)], ball_radius='ball',\n"
        "    gravity=9.81, restitution=0.5, bodies=[Plane('floor', within=['x - 1'])],\n"
        "    ends={'out': End(at=-1)})\n"
        "STATES = np.linspace([-1, 0, 0.5, 1, 0, 0, 0, 9, 0], [1, 0, 1, 2, 0, 0, 0, 0, 0], 50)\n"
    )
    return subprocess.Popen(
        [*before, sys.executable, "-c", PROCESS.format(tests=str(folder))],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **options,
    )


def said(started: subprocess.Popen[str]) -> list[str]:
    out, err = started.communicate(timeout=300)
    assert started.returncode == 0, err
    return out.split()


# -------------------------------------------------------------------------------- what it simulates


def assert_c_gives_numpys_bits(engine: Engine) -> None:
    """Check all results of balls that are let go, some of which are invalid."""
    states = drops(2000)
    states[::50, 4] = np.nan
    own = {"bounce": np.linspace(0.5, 0.9, 2000)}
    given: Any = {"record": True, "max_contacts": 50, "fields": tuple(engine.layout.results)}
    c = engine.simulate(states, own, backend="c", **given)
    numpy = engine.simulate(states, own, backend="numpy", **given)
    for name in (*engine.layout.results, "events"):
        assert getattr(c, name).tobytes() == getattr(numpy, name).tobytes(), name
    ends = {engine.outcomes(code).name for code in np.unique(c.outcome)}
    assert {"CUP", "OUT", "INVALID"} <= ends


@pytest.mark.slow
def test_c_gives_numpys_bits(dome: Engine) -> None:
    assert_c_gives_numpys_bits(dome)


@pytest.mark.slow
def test_an_engine_says_what_it_has(dome: Engine) -> None:
    assert dict(dome.parameters) == {"ball": 0.05, "reach": 1.0, "bounce": 0.8, "g": 9.81}
    assert dome.surfaces == ("floor", "dome")
    assert [outcome.name for outcome in dome.outcomes][:2] == ["CUP", "OUT"]
    assert dome.backend == "c"
    assert set(dome.source("numpy")) == {"dome.py"}
    assert "dome_simulate(" in dome.source("c")["dome.h"]
    assert hoopgen.HOOP.source("numpy")["hoop.py"].startswith('"""NumPy kernels of the scene hoop')
    with pytest.raises(ValueError, match="target: expected 'c', 'numpy' or 'cuda', got 'js'"):
        dome.source("js")
    assert hoopgen.compile(dome) is dome
    assert hoopgen.compile(DOME) is dome
    assert hoopgen.compile(None) is hoopgen.compile(hoopgen.HOOP.scene) is hoopgen.HOOP


def test_what_is_no_scene_is_refused() -> None:
    with pytest.raises(
        TypeError, match=r"^scene: expected None, a scene, or what hoopgen\.compile"
    ):
        hoopgen.simulate(drops(1), scene="netball")


@pytest.mark.slow
def test_parameters_left_out_are_usual_and_sizes_follow_them(dome: Engine) -> None:
    states = drops(200)
    some = dome.simulate(states, {"reach": 0.6})
    whole = dome.simulate(states, dome.parameters | {"reach": np.full(200, 0.6)})
    assert some.state.tobytes() == whole.state.tobytes()
    assert list(some.parameters) == ["ball", "reach", "bounce", "g"]
    assert not np.array_equal(some.state, dome.simulate(states).state)
    wrong = r"parameters: unknown restitution\. The names are ball, reach, bounce, g$"
    with pytest.raises(ValueError, match=wrong):
        dome.simulate(states, {"restitution": 0.6})
    with pytest.raises(ValueError, match=r"parameters\['bounce'\]: expected 0 to 1, got 1.5"):
        hoopgen.certify(states, {"bounce": 1.5}, scene=DOME)


@pytest.mark.slow
def test_shots_are_those_of_their_scene(dome: Engine) -> None:
    shots = dome.simulate(drops(300), record=True)
    assert shots.surfaces == ("floor", "dome")
    assert shots.counts.shape == (300, 2)
    assert repr(shots).endswith("; dome)")
    assert not hasattr(shots, "made")
    path = shots.trajectory(int(np.argmax(shots.counts[:, 1])))
    assert "dome" in repr(path)
    times = path.events["time"][:9]
    np.testing.assert_array_equal(path.at(times), path.events["after"][:9])
    again = pickle.loads(pickle.dumps(shots))
    assert again.scene.name == "dome"
    assert again.events.tobytes() == shots.events.tobytes()


@pytest.mark.slow
def test_the_log_grows_for_shots_with_many_contacts(dome: Engine) -> None:
    """They end elsewhere than with few, and are logged as they were flown."""
    still = np.tile([-0.7, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], (3, 1))
    states = np.concatenate([still[:1], drops(50), still[1:]])
    given: Any = {"time_limit": 1e9, "threads": 2}
    assert dome.simulate(still, {"bounce": 0.99}, **given).contacts.max() == dome.max_contacts
    given["max_contacts"] = 400
    plain = dome.simulate(states, {"bounce": 0.99}, **given)
    assert plain.contacts.max() == 400
    for backend in ("c", "numpy"):
        shots = dome.simulate(states, {"bounce": 0.99}, record=True, backend=backend, **given)
        for name in dome.layout.fields:
            assert getattr(shots, name).tobytes() == getattr(plain, name).tobytes(), name
        assert np.all(np.diff(shots.events["shot"]) >= 0)
        for shot in range(len(states)):
            log = shots.events[shots.events["shot"] == shot]
            assert np.sum(log["surface"] < 2) == shots.contacts[shot]
            assert np.all(np.diff(log["time"]) > 0)
    only = dome.simulate(states, {"bounce": 0.99}, record=True, fields="time", **given)
    assert only.events.tobytes() == shots.events.tobytes()


@pytest.mark.slow
def test_the_judge_agrees_or_the_shot_is_marked(dome: Engine) -> None:
    states = drops(60)
    shots = dome.simulate(states, record=True, max_contacts=15)
    for proof in (
        hoopgen.certify(states, scene=DOME, max_contacts=15),
        dome.certify(states, max_contacts=15),
    ):
        assert proof.agrees(shots).all()
        assert proof.decided.sum() > 50
    sure = int(np.flatnonzero(~shots.uncertain & (shots.contacts > 0))[0])
    shots.outcome[sure] += 1
    assert list(np.flatnonzero(~proof.agrees(shots))) == [sure]
    shots.outcome[sure] -= 1
    shots.events["surface"][np.flatnonzero(shots.events["shot"] == sure)[0]] ^= 1
    assert list(np.flatnonzero(~proof.agrees(shots))) == [sure]
    shots.uncertain[sure] = True
    assert proof.agrees(shots).all()
    with pytest.raises(ValueError, match="shots: expected 60, as many as were proved; got 2"):
        proof.agrees(dome.simulate(states[:2], record=True))
    with pytest.raises(AttributeError, match="record=True"):
        proof.agrees(dome.simulate(states))


@pytest.mark.slow
def test_a_scene_of_derive_is_one_too(home: Path) -> None:
    shots = hoopgen.simulate(drops(50), {"bounce": 0.5}, scene=TABLE)
    assert shots.surfaces == ("top", "dome")
    assert shots.scene.backend == "c"
    assert (
        hoopgen.certify(drops(3), {"bounce": 0.5}, scene=TABLE)
        .agrees(hoopgen.simulate(drops(3), {"bounce": 0.5}, scene=TABLE, record=True))
        .all()
    )


# ------------------------------------------------------------------------------------- what is kept


class Terminal(io.StringIO):
    """A stream that says that it is a terminal."""

    def isatty(self) -> bool:
        return True


@pytest.mark.slow
def test_a_terminal_is_told_that_a_scene_is_compiled(
    home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", terminal := Terminal())
    hoopgen.compile(PLANK)
    told = "hoopgen: the scene plank is derived and compiled, which takes up to a minute once\n"
    assert terminal.getvalue() == told
    forget()
    hoopgen.compile(PLANK)
    assert terminal.getvalue() == told, "it is found compiled"
    monkeypatch.setattr(sys, "stderr", file := io.StringIO())
    hoopgen.compile(replace(PLANK, name="other_plank"))
    assert file.getvalue() == ""


@posix
@pytest.mark.slow
def test_another_process_finds_it_and_derives_nothing(
    home: Path, wrapped: Wrapped, tmp_path: Path
) -> None:
    first = said(process(tmp_path))
    assert first[0] == "c"
    assert first[2] == "True"
    assert said(process(tmp_path)) == [*first[:2], "False"]
    assert wrapped.runs == 1
    for folder in (home, home.parent):
        assert stat.S_IMODE(folder.stat().st_mode) == 0o700


@posix
@pytest.mark.slow
def test_of_two_processes_at_once_one_compiles(
    home: Path, wrapped: Wrapped, tmp_path: Path
) -> None:
    both = [process(tmp_path) for _ in range(2)]
    one, other = map(said, both)
    assert one[:2] == other[:2]
    assert wrapped.runs == 1
    assert not list(home.glob(".build-*"))


@pytest.mark.slow
@linux_on_x86
def test_a_thread_that_computes_otherwise_compiles_and_simulates_the_same(
    dome: Engine, home: Path
) -> None:
    """The sources, the inputs that follow from parameters, and the shots have the same bits."""
    if hoopgen.HOOP.library is None:
        pytest.skip("the C engine was not built")
    states, own = drops(200), {"bounce": np.linspace(0.5, 0.9, 200), "reach": 1.1}

    def results(engine: Engine, backend: Any) -> list[bytes]:
        shots = engine.simulate(states, own, record=True, backend=backend)
        return [getattr(shots, name).tobytes() for name in (*engine.layout.fields, "events")]

    def work() -> tuple[Engine, int, list[list[bytes]]]:
        set_control(MODES["all at once"])
        made = hoopgen.compile(DOME)
        found = [results(made, backend) for backend in ("c", "numpy")]
        return made, control() & ~FLAGS, found

    usual = results(dome, "numpy")
    made, after, found = in_a_thread(work)
    assert after & MODES["all at once"] == MODES["all at once"]
    assert made.source("c") == dome.source("c")
    assert found == [usual, usual]


@pytest.mark.slow
def test_threads_get_one_engine(home: Path) -> None:
    found: list[Engine] = []
    threads = [threading.Thread(target=lambda: found.append(hoopgen.compile(PLANK))) for _ in "123"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found[0] is found[1] is found[2]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_forked_process_simulates_and_waits_for_no_lock_of_its_parent(dome: Engine) -> None:
    states = drops(100)
    wanted = dome.simulate(states, threads=1).state.tobytes()
    held, done = threading.Event(), threading.Event()

    def hold() -> None:
        with cache._THREADS:
            held.set()
            done.wait()

    thread = threading.Thread(target=hold)
    thread.start()
    held.wait()
    try:
        child = os.fork()
        if child == 0:
            same = dome.simulate(states, threads=1).state.tobytes() == wanted
            os._exit(0 if same and cache._THREADS.acquire(blocking=False) else 1)
        assert os.waitpid(child, 0)[1] == 0
    finally:
        done.set()
        thread.join()


@pytest.mark.parametrize("name", [compilers.library_name(), cache.MODULE, cache.SOURCES])
@pytest.mark.slow
def test_a_file_that_was_tampered_with_is_not_loaded(
    home: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    wanted = hoopgen.compile(PLANK).simulate(drops(20)).state.tobytes()
    file = entry_of(home) / name
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.unlink()  # the one in use stays as it is
    file.write_bytes(content)
    forget()
    engine = hoopgen.compile(PLANK)
    (line,) = capsys.readouterr().err.splitlines()
    assert line == f"hoopgen: {file.parent} {DAMAGED}"
    assert engine.backend == "c"
    assert engine.simulate(drops(20)).state.tobytes() == wanted
    assert file.read_bytes() != content


@pytest.mark.slow
def test_what_is_loaded_is_what_was_checked(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """And not what the file holds by then."""
    wanted = hoopgen.compile(PLANK).simulate(drops(20)).state.tobytes()
    file = entry_of(home) / compilers.library_name()
    forget()
    load = compiling.load

    def meanwhile(content: bytes, *rest: Any) -> Any:
        file.unlink()
        file.write_bytes(b"not a library")
        return load(content, *rest)

    monkeypatch.setattr(compiling, "load", meanwhile)
    engine = hoopgen.compile(PLANK)
    assert file.read_bytes() == b"not a library"
    assert engine.backend == "c"
    assert engine.simulate(drops(20)).state.tobytes() == wanted


@pytest.mark.parametrize("memory", [True, False])
@pytest.mark.slow
def test_each_library_is_its_own_whatever_descriptor_it_had(
    dome: Engine, home: Path, memory: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The C library takes a path that it knows for the library that it knows."""
    if not memory:
        monkeypatch.delattr(os, "memfd_create", raising=False)
    engines = [hoopgen.compile(replace(PLANK, name=f"plank_{name}")) for name in ("a", "b", "c")]
    assert [engine.backend for engine in engines] == 3 * ["c"]
    for engine in engines:
        c, numpy = (engine.simulate(drops(20), backend=each) for each in ("c", "numpy"))
        assert c.state.tobytes() == numpy.state.tobytes()


KEY = "5eed" * 16
DAMAGED = "does not hold what was built; it is not used, and built anew."


def keep(there: cache.Cache) -> cache.Entry:
    """Keep a small scene."""
    record = {"key": KEY, "scene": "a", "compiler": "cc", "width": 1, "refused": None}
    return there.built(KEY, lambda _: cache.Entry(record, {cache.MODULE: b"it"}))


@pytest.mark.parametrize(
    "record", [b"", b"{", b"[]", b"\xff", b'{"files": 3}', b'{"files": {"gone": ""}}', b"[" * 9999]
)
def test_a_record_that_says_something_else_is_none(
    tmp_path: Path, record: bytes, capsys: pytest.CaptureFixture[str]
) -> None:
    there = cache.Cache(tmp_path)
    cache._warn_once.cache_clear()
    for _ in range(2):
        entry = keep(there)
        assert there.entry(KEY) == entry
        (tmp_path / KEY / cache.RECORD).write_bytes(record)
        assert there.entry(KEY) is None
    assert list(there.entries()) == []
    assert capsys.readouterr().err == f"hoopgen: {tmp_path / KEY} {DAMAGED}\n"


@pytest.mark.slow
@pytest.mark.parametrize("name", [cache.RECORD, cache.MODULE])
def test_every_bit_of_what_is_kept_is_looked_at(tmp_path: Path, name: str) -> None:
    there = cache.Cache(tmp_path)
    entry = keep(there)
    file = tmp_path / KEY / name
    content = file.read_bytes()
    for place in range(8 * len(content)):
        flipped = bytearray(content)
        flipped[place // 8] ^= 1 << place % 8
        file.write_bytes(flipped)
        assert there.entry(KEY) is None, place
    for cut in range(len(content)):
        file.write_bytes(content[:cut])
        assert there.entry(KEY) is None, cut
    assert keep(there) == there.entry(KEY) == entry
    assert file.read_bytes() == content


def test_a_scene_under_the_key_of_another_is_not_used(tmp_path: Path) -> None:
    there = cache.Cache(tmp_path)
    keep(there)
    other = KEY[::-1]
    (tmp_path / KEY).rename(tmp_path / other)
    assert there.entry(other) is None


@posix
@pytest.mark.parametrize("name", [cache.RECORD, cache.MODULE])
def test_what_is_no_file_is_not_waited_for(tmp_path: Path, name: str) -> None:
    there = cache.Cache(tmp_path)
    keep(there)
    (tmp_path / KEY / name).unlink()
    os.mkfifo(tmp_path / KEY / name)
    assert there.entry(KEY) is None
    assert keep(there) == there.entry(KEY)


@pytest.mark.slow
def test_after_every_flipped_bit_of_a_record_the_scene_is_compiled(
    home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """One bit in each byte is flipped; the slow compiler is left out."""
    monkeypatch.setenv("CC", "/nowhere/cc")
    made = hoopgen.compile(PLANK)
    states, name = drops(5), made.name
    file = entry_of(home) / cache.RECORD
    content = file.read_bytes()
    for place in range(0, len(content), 5):
        flipped = bytearray(content)
        flipped[place] ^= 1 << place % 8
        file.write_bytes(flipped)
        forget()
        capsys.readouterr()
        engine = hoopgen.compile(PLANK)
        assert capsys.readouterr().err == f"hoopgen: {file.parent} {DAMAGED}\n"
        assert (engine.name, engine.found) == (name, made.found)
        assert file.read_bytes() == content
    assert engine.simulate(states, max_contacts=5).state.shape == (5, 9)


@posix
def test_an_interrupt_ends_the_compiler(tmp_path: Path) -> None:
    """NumPy computes meanwhile, so that the interrupt comes while nobody waits for the compiler."""
    os.mkfifo(tmp_path / "begun")
    script = 'echo $$ > "$TMPDIR/begun"; exec sleep 600'
    compiler = compilers.Compiler(("sh", "-c", script), Path("/bin/sh"))
    begun = []

    def interrupted() -> None:
        with compiler.running(tmp_path, "plank.c"):
            begun.append(int((tmp_path / "begun").read_text()))
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    with pytest.raises(ProcessLookupError):
        os.kill(begun[0], 0)


@posix
@pytest.mark.slow
def test_a_killed_build_is_in_nobodys_way(home: Path, wrapped: Wrapped, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "wait")
    os.mkfifo(tmp_path / "begun")
    wrapped.first('echo > "$here/begun"; cat "$here/wait"; exit 1')
    started = process(tmp_path)
    (tmp_path / "begun").read_text()  # the compiler runs now
    started.send_signal(signal.SIGKILL)
    started.communicate()
    (left,) = home.glob(".build-*")
    wrapped.first("")
    assert said(process(tmp_path))[0] == "c"
    assert not left.exists()
    (tmp_path / "wait").write_text("")  # its compiler ends, and harms nothing
    assert said(process(tmp_path))[0] == "c"
    assert wrapped.runs == 2


@pytest.mark.slow
def test_where_nothing_can_be_written_a_process_compiles_for_itself(
    home: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    home.parent.parent.mkdir(parents=True)
    home.parent.write_text("in the way")
    engines = [hoopgen.compile(PLANK), hoopgen.compile(DOME)]
    assert [engine.backend for engine in engines] == ["c", "c"]
    assert hoopgen.compile(replace(PLANK)) is engines[0]
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"hoopgen: {home.parent}: ")
    assert line.endswith("; scenes are compiled for this process alone.")
    assert home.parent.read_text() == "in the way"


@posix
@pytest.mark.slow
def test_a_folder_that_cannot_be_written_serves_with_what_it_has(
    home: Path, wrapped: Wrapped, tmp_path: Path
) -> None:
    plain = ("setpriv", "--bounding-set=-all", "--inh-caps=-all") if os.getuid() == 0 else ()
    if plain and shutil.which(plain[0]) is None:
        pytest.skip("an administrator can write everywhere")
    first = said(process(tmp_path))
    assert (first[0], wrapped.runs) == ("c", 1)
    for folder in (home, *home.iterdir()):
        folder.chmod(0o500 if folder.is_dir() else 0o400)
    started = process(tmp_path, *plain)
    out, err = started.communicate(timeout=300)
    assert (out.split(), err, wrapped.runs) == ([*first[:2], "False"], "", 1)
    (entry_of(home) / cache.RECORD).chmod(0o600)
    (entry_of(home) / cache.RECORD).write_bytes(b"")  # so that a scene is to be built
    started = process(tmp_path, *plain)
    out, err = started.communicate(timeout=300)
    assert (out.split(), wrapped.runs) == (first, 2)
    assert err.splitlines()[-1] == (
        f"hoopgen: {home}: Permission denied; scenes are compiled for this process alone."
    )


# ---------------------------------------------------------------------------------- other people


@pytest.mark.slow
def test_c_as_wide_as_the_processor_gives_numpys_bits(home: Path) -> None:
    """Compiled as for a user, who has no test's compiler, flags and lanes."""
    with compiling_as_for_users():
        assert compilers.processor_lanes().width > 1
        assert "-O1" in compilers.FLAGS
        assert_c_gives_numpys_bits(hoopgen.compile(PLANK))


@posix
def test_a_folder_that_others_can_look_into_is_not_used(home: Path) -> None:
    home.mkdir(parents=True)
    home.chmod(0o755)
    assert cache.user_store() == f"{home} is open to others; its mode should be 700"
    home.chmod(0o700)
    assert cache.user_store() == cache.Cache(home)
    home.chmod(0o777)
    assert cache.user_store() == f"{home}: {OTHERS}"


OTHERS = "other users can write this folder; take that right from them (chmod go-w)"


@posix
@pytest.mark.parametrize("mode", [0o777, 0o707, 0o770])
@pytest.mark.parametrize("above", [1, 2, 3])
@pytest.mark.slow
def test_nor_is_one_below_a_folder_that_others_can_write(
    home: Path, above: int, mode: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """They could put their own `scenes` in its place, and with it a library."""
    wanted = hoopgen.compile(PLANK).simulate(drops(20)).state.tobytes()
    place = home.parents[above - 1]
    place.chmod(mode)
    assert cache.user_store() == f"{place}: {OTHERS}"
    stranger = entry_of(home) / compilers.library_name()
    stranger.unlink()
    stranger.write_bytes(b"a stranger's library")
    forget()
    capsys.readouterr()
    engine = hoopgen.compile(PLANK)
    (line,) = capsys.readouterr().err.splitlines()
    assert line == f"hoopgen: {place}: {OTHERS}; scenes are compiled for this process alone."
    assert engine.backend == "c"
    assert engine.simulate(drops(20)).state.tobytes() == wanted
    assert stranger.read_bytes() == b"a stranger's library"
    place.chmod(0o700)


@posix
def test_a_sticky_folder_above_is_fine(home: Path) -> None:
    """Others can write to such a folder, for example /tmp, but not move our files."""
    home.mkdir(parents=True, mode=0o700)
    home.chmod(0o700)
    home.parents[1].chmod(0o1777)
    assert cache.user_store() == cache.Cache(home)
    home.parent.chmod(0o1777)
    assert cache.user_store() == cache.Cache(home)
    home.chmod(0o1777)
    assert isinstance(cache.user_store(), str)


@posix
def test_a_link_stands_for_where_it_leads(home: Path, tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir(mode=0o700)
    home.parents[1].symlink_to(tmp_path / "elsewhere")
    assert cache.user_store() == cache.Cache(tmp_path / "elsewhere" / "hoopgen" / "scenes")
    (tmp_path / "elsewhere").chmod(0o777)
    assert cache.user_store() == f"{tmp_path / 'elsewhere'}: {OTHERS}"


@pytest.mark.skipif(os.name != "posix" or os.getuid() != 0, reason="gives a folder away")
@pytest.mark.parametrize("above", [0, 1, 2])
def test_a_folder_of_another_user_is_not_used(home: Path, above: int) -> None:
    home.mkdir(parents=True, mode=0o700)
    place = (home, *home.parents)[above]
    os.chown(place, 12345, 12345)
    assert cache.user_store() == f"{place}: this folder is another user's"


@pytest.mark.slow
@posix
def test_where_no_folder_is_private_numpy_serves(
    home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    home.parents[1].mkdir(parents=True)
    home.parents[1].chmod(0o777)
    (tmp_path / "temporary").mkdir()
    (tmp_path / "temporary").chmod(0o777)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    engine = hoopgen.compile(PLANK)
    assert engine.backend == "numpy"
    assert isinstance(engine.found, native.Rejection)
    assert engine.found.reason == (
        f"of the scene plank was not compiled: {tmp_path / 'temporary'}: {OTHERS}"
    )
    assert not list((tmp_path / "temporary").iterdir())


@pytest.mark.slow
def test_a_cache_that_has_no_marker_is_known_by_its_names(home: Path) -> None:
    """Caches of hoopgen 0.2.0 have no marker, and some markers are damaged."""
    hoopgen.compile(PLANK)
    for content in (None, b"{"):
        (home / MARKER).unlink()
        if content is not None:
            (home / MARKER).write_bytes(content)
        assert cache.user_store() == cache.Cache(home)
        assert find_store(home, "compiled scenes") is not None
    (home / MARKER).unlink()
    (home / "notes").mkdir()
    why = cache.user_store()
    assert isinstance(why, str)
    assert why.startswith(f"{home} holds files that hoopgen did not make: ")


@pytest.mark.parametrize("there", [False, True])
def test_the_command_says_of_a_folder_that_cannot_be_written_that_it_is_empty(
    there: bool, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(path: Path, *_: Any) -> Any:
        raise OSError(errno.EROFS, "Read-only file system", str(path))

    if there:
        home.mkdir(parents=True, mode=0o700)
    monkeypatch.setattr(cache, "open_store" if there else "private_folder", refuse)
    from click.testing import CliRunner

    result = CliRunner().invoke(main, ["cache"])
    assert result.exit_code == 0
    assert result.stdout == f"no scene is kept; {home}: Read-only file system\n"
    home.mkdir(parents=True, exist_ok=True)
    (home / "notes").write_text("somebody's", encoding="utf-8")
    monkeypatch.setattr(cache, "private_folder", refuse)
    assert CliRunner().invoke(main, ["cache"]).exit_code == 2


# ----------------------------------------------------------------------------------- the compiler


@pytest.mark.parametrize("command", ["gcc 'x", 'gcc "', "gcc \\"])
def test_a_compiler_that_is_no_command_is_named_with_its_variable(
    command: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CC", command)
    with pytest.raises(ValueError, match=r"^the environment variable CC is ") as refusal:
        compilers.compiler()
    assert brief(command) in str(refusal.value)
    assert "such as CC=gcc, or no CC" in str(refusal.value)


@pytest.mark.slow
def test_without_a_compiler_numpy_serves(
    home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CC", "/nowhere/cc")
    engine = hoopgen.compile(PLANK)
    assert engine.backend == "numpy"
    states = drops(50)
    numpy = [engine.simulate(states, max_contacts=20).state.tobytes() for _ in range(2)]
    (line,) = capsys.readouterr().err.splitlines()
    assert line == (
        "hoopgen: the C engine of the scene plank was not compiled: no C compiler was found, as "
        "the environment variable CC is '/nowhere/cc'; install one, or `pip install ziglang`. "
        "NumPy serves, slower."
    )
    with pytest.raises(
        RuntimeError, match="backend: 'c' of the scene plank was not compiled: no C"
    ):
        engine.simulate(drops(1), backend="c")
    monkeypatch.delenv("CC")
    forget()
    engine = hoopgen.compile(PLANK)
    assert engine.backend == "c"
    assert numpy == 2 * [engine.simulate(states, max_contacts=20).state.tobytes()]


@posix
@pytest.mark.slow
def test_a_compiler_that_fails_says_so_once_and_is_not_asked_again(
    home: Path, wrapped: Wrapped, capsys: pytest.CaptureFixture[str]
) -> None:
    wrapped.first("echo 'plank.c:1: no, thanks' >&2; exit 1")
    for turn in range(3):
        engine = hoopgen.compile(PLANK)
        assert engine.backend == "numpy"
        assert ("no, thanks" in capsys.readouterr().err) == (turn == 0)
        assert isinstance(engine.found, native.Rejection)
        assert "could not be compiled by cc of one's own" in engine.found.reason
        forget()
    assert wrapped.runs == 1
    wrapped.first("")
    cache.clear_store(cache.Cache(home))
    assert hoopgen.compile(PLANK).backend == "c"


@pytest.mark.slow
@posix
@pytest.mark.parametrize(
    "commands", ["kill -9 $$", "echo 'cc1: fatal error: No space left on device' >&2; exit 1"]
)
def test_a_compiler_that_was_stopped_is_asked_again(
    home: Path, wrapped: Wrapped, commands: str
) -> None:
    wrapped.first(commands)
    assert hoopgen.compile(PLANK).backend == "numpy"
    forget()
    wrapped.first("")
    assert hoopgen.compile(PLANK).backend == "c"
    assert wrapped.runs == 2


# ---------------------------------------------------------------------- without bounds on errors

PATH = ("outcome", "contacts", "time", "state")
"""Results that need no bounds on errors."""


def fly_without_bounds(engine: Engine, shots: int) -> native.Library | None:
    """Simulate shots without bounds; check their bits, and return the library that the next get."""
    plain, whole = engine.simulate(drops(shots), fields=PATH), engine.simulate(drops(shots))
    for name in PATH:
        assert getattr(plain, name).tobytes() == getattr(whole, name).tobytes(), name
    return engine.library_without_bounds(0)


@posix
@pytest.mark.slow
def test_many_shots_without_bounds_have_a_loop_of_their_own(
    home: Path, wrapped: Wrapped, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(without_bounds, "SHOTS_WORTH_A_LOOP", 250)
    engine = hoopgen.compile(PLANK)
    assert fly_without_bounds(engine, 200) is engine.library
    assert wrapped.runs == 1
    faster = fly_without_bounds(engine, 200)
    assert isinstance(faster, native.Library)
    assert faster is not engine.library
    assert wrapped.runs == 2
    forget()
    engine = hoopgen.compile(PLANK)
    assert fly_without_bounds(engine, 1) is not engine.library, "it is found"
    assert wrapped.runs == 2
    with pytest.raises(ValueError, match="refuses its arguments, with code -11"):
        run_on(faster, engine, ("uncertain",))
    run_on(faster, engine, PATH)


def run_on(library: native.Library, engine: Engine, fields: tuple[str, ...]) -> None:
    """Simulate a ball on a library."""
    parameters = engine.table.inputs(dict(engine.parameters))
    out, stop = engine.layout.allocate(1, fields), np.zeros(1, np.int32)
    library.run(drops(1), parameters, None, 10, out, stop)


@posix
@pytest.mark.slow
@pytest.mark.parametrize("passing", [True, False])
def test_where_the_loop_without_bounds_cannot_be_made_the_other_one_serves(
    home: Path,
    wrapped: Wrapped,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    passing: bool,
) -> None:
    monkeypatch.setattr(without_bounds, "SHOTS_WORTH_A_LOOP", 10)
    engine = hoopgen.compile(PLANK)
    wrapped.first(f"echo 'plank.c:1: no, {'Killed' if passing else 'thanks'}' >&2; exit 1")
    for turn in range(3):
        assert fly_without_bounds(engine, 20) is engine.library
        said = capsys.readouterr().err
        assert ("plank.c:1: no" in said) == (turn == 0)
        assert said.endswith("Calls without them stay slower.\n") == (turn == 0)
    assert wrapped.runs == 2
    forget()
    engine = hoopgen.compile(PLANK)
    assert fly_without_bounds(engine, 20) is engine.library
    assert wrapped.runs == 2 + passing, "what may pass is tried again by another process"


@posix
@pytest.mark.slow
@pytest.mark.parametrize("gone", ["CC", "file"])
@pytest.mark.parametrize("flown", [False, True])
def test_where_the_compiler_goes_after_the_first_library_that_library_serves_every_call(
    home: Path,
    wrapped: Wrapped,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    gone: str,
    flown: bool,
) -> None:
    """Another ``CC`` takes it away, or the disk loses it, before the first call or after it."""
    monkeypatch.setattr(without_bounds, "SHOTS_WORTH_A_LOOP", 250)
    engine = hoopgen.compile(PLANK)
    if flown:
        assert fly_without_bounds(engine, 200) is engine.library
    assert capsys.readouterr().err == ""
    if gone == "CC":
        monkeypatch.setenv("CC", "/nowhere/cc")
    else:
        next(wrapped.folder.glob("cc*")).unlink()
    said = []
    for _ in range(3):
        assert fly_without_bounds(engine, 300) is engine.library
        said += capsys.readouterr().err.splitlines()
    assert wrapped.runs == 1
    *words, line = said
    assert line.startswith("hoopgen: the loop without bounds on errors of the scene plank ")
    assert line.endswith(" Calls without them stay slower.")
    if gone == "CC":
        assert "as the environment variable CC is '/nowhere/cc'" in line
        assert not words
    else:
        assert words[0] == "hoopgen: cc of one's own does not compile the scene plank:"
        assert "No such file or directory" in words[1]


@posix
@pytest.mark.slow
def test_a_loop_without_bounds_with_other_bits_is_not_trusted(
    home: Path,
    wrapped: Wrapped,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(without_bounds, "SHOTS_WORTH_A_LOOP", 10)
    engine = hoopgen.compile(PLANK)
    wrapped.first("sed -i '/FIX(/s/K(1\\.0)/K(1.0000000000000002)/' plank_loop.h")
    assert fly_without_bounds(engine, 20) is engine.library
    (line,) = capsys.readouterr().err.splitlines()
    assert (
        "the loop without bounds on errors of the scene plank does not give NumPy's results" in line
    )


@posix
@pytest.mark.slow
def test_a_library_with_other_bits_is_not_trusted(home: Path, wrapped: Wrapped) -> None:
    wrapped.first("sed -i '/FIX(/s/K(1\\.0)/K(1.0000000000000002)/' plank_loop.h")
    engine = hoopgen.compile(PLANK)
    assert isinstance(engine.found, native.Rejection)
    assert "does not give NumPy's results (width 1: " in engine.found.reason
    assert not (entry_of(home) / compilers.library_name()).exists()


@posix
@pytest.mark.slow
def test_what_matters_is_in_the_key(
    home: Path, wrapped: Wrapped, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another compiler, flag, scene or number of lanes is compiled; the same one is not."""
    runs = []

    def compiled(scene: Scene = PLANK) -> None:
        forget()
        assert hoopgen.compile(scene).backend == "c"
        runs.append(wrapped.runs)

    compiled()
    compiled()
    script = next(wrapped.folder.glob("cc*"))
    script.write_text(script.read_text().replace("echo 1.0", "echo 1.1"))
    compiled()
    monkeypatch.setattr(compilers, "FLAGS", [*compilers.FLAGS, "-O2"])
    compiled()
    monkeypatch.setattr(compilers, "processor_lanes", lambda: compilers.Lanes(4, 2))
    compiled()
    other = replace(PLANK, bodies=[Plane("floor", within=["x - reach"])])
    compiled(other)
    compiled()
    assert runs == [1, 1, 2, 3, 4, 5, 5]


# --------------------------------------------------------------------------------- command line


@pytest.mark.slow
def test_the_commands(home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from click.testing import CliRunner

    file = tmp_path / "post.toml"
    file.write_text(FILE)
    result = CliRunner().invoke(main, ["compile", str(file)])
    assert result.exit_code == 0, result.output
    assert "surfaces    post\n" in result.stdout
    assert "backend     c, the same bits as numpy\n" in result.stdout
    result = CliRunner().invoke(main, ["cache"])
    assert [line.split()[0] for line in result.stdout.splitlines()[1:]] == [
        "scene",
        "-----",
        "post",
    ]
    result = CliRunner().invoke(main, ["cache", "--clear"])
    assert result.stdout == f"removed 1 scene from {home}\n"
    assert list(home.iterdir()) == [home / MARKER]
    assert "no scene is kept" in CliRunner().invoke(main, ["cache", "--show"]).stdout
    monkeypatch.setenv("CC", "/nowhere/cc")
    forget()
    result = CliRunner().invoke(main, ["compile", str(file)])
    assert result.exit_code == 1
    assert "backend     numpy: the C engine of the scene post was not compiled" in result.stdout
    file.write_text(FILE.replace("post", "_post"))
    result = CliRunner().invoke(main, ["compile", str(file)])
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
