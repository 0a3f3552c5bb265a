"""The page: it stands alone, says what the engine says, and draws it in a real browser."""

from __future__ import annotations

import base64
import hashlib
import io
import itertools
import json
import os
import re
import select
import shutil
import signal
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.simulation.article import CASES
from hoopgen.study.measures.measures import MEASURES
from hoopgen.viewer import page, view
from tests.helpers.commands import RELEASE, run, succeed

FOLDER = Path(hoopgen.__file__).parent / "viewer"
STATES = {case.slug: case.state for case in CASES}
NASTY = '</script><script>document.title = "broken"</script><!--<script><img src=x>&amp;{{data}}'


def simulate(states: Any, parameters: Mapping[str, Any] = hoopgen.PAPER) -> hoopgen.Shots:
    return hoopgen.simulate(states, parameters, record=True)


def free_throws(shots: int) -> np.ndarray[Any, Any]:
    random = np.random.default_rng(2024)
    return hoopgen.release(
        speed=random.normal(7.17, 0.07, shots),
        elevation=np.radians(random.normal(52, 1.3, shots)),
        azimuth=np.radians(random.normal(0, 1, shots)),
        backspin=6 * np.pi,
        height=2.1336,
        distance=4.191,
    )


SAMPLE = free_throws(60)

pytestmark = pytest.mark.xdist_group("view")  # one browser


# The file


def data_of(text: str) -> dict[str, Any]:
    (found,) = re.findall(r'<script type="application/json" id="data">(.*?)</script>', text, re.S)
    loaded = json.loads(found)
    assert isinstance(loaded, dict)
    return loaded


def test_the_page_loads_nothing() -> None:
    text = page(simulate(SAMPLE), hoopgen.PAPER)
    # Names of XML namespaces are no places that anything is fetched from.
    names = {"http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg"}
    assert set(re.findall(r"\b(?:https?|wss?)://[^\s\"'`)]*", text)) <= names
    markup = re.sub(r"(<(script|style)[^>]*>).*?(</\2>)", r"\1\3", text, flags=re.S)
    assert re.findall(r"(?:src|href|action)=\"?[^\s\"]*", markup) == ['href="data:,']
    assert "default-src 'none'" in markup


@pytest.mark.slow
def test_the_same_shots_give_the_same_bytes(tmp_path: Path) -> None:
    script = (
        "import hoopgen, sys; from hoopgen.simulation.article import CASES; "
        "from hoopgen.viewer import view; "
        "view(hoopgen.simulate(CASES[0].state, record=True), hoopgen.PAPER, sys.argv[1])"
    )
    pages = set()
    for seed in ("1", "2"):
        path = tmp_path / f"{seed}.html"
        subprocess.run(
            [sys.executable, "-c", script, path],
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=True,
        )
        pages.add(path.read_bytes())
    assert len(pages) == 1


def test_words_are_text_whatever_is_in_them() -> None:
    shots = simulate(SAMPLE[:2])
    plain = page(shots, hoopgen.PAPER, title="plain", about="plain", labels=["plain"] * 2)
    nasty = page(shots, hoopgen.PAPER, title=NASTY, about=NASTY, labels=[NASTY] * 2)
    for tag in ("<script", "</script", "<!--", "<img"):
        assert nasty.count(tag) == plain.count(tag)
    data = data_of(nasty)
    assert [data["title"], data["shots"][0]["label"]] == [NASTY] * 2
    assert data["about"] == f"{NASTY}; scene PAPER (the article's)"


def test_a_shot_is_pieces_of_parabolas_not_frames() -> None:
    shots = simulate(SAMPLE)
    data = data_of(page(shots, hoopgen.PAPER))
    for row, shot in enumerate(data["shots"]):
        trajectory = shots.trajectory(row)
        events = trajectory.events
        assert len(shot["flights"]) == len(events) + 1
        assert shot["flights"][0] == [0.0, *trajectory.release]
        for flight, event in zip(shot["flights"][1:], events, strict=True):
            assert flight == [event["time"], *event["after"]]


def test_the_ball_touches_where_the_surface_is() -> None:
    states = np.array([*STATES.values()])
    data = data_of(page(simulate(states), hoopgen.PAPER))
    touched = Counter()
    scene = hoopgen.PAPER
    for shot in data["shots"]:
        for event in shot["events"]:
            x, y, z = event["at"]
            touched[event["surface"]] += 1
            away = {
                "ring": np.hypot(np.hypot(x, y) - scene["ring_radius"], z) - scene["wire_radius"],
                "backboard": x + scene["board_distance"],
                "bridge": z - scene["wire_radius"],
                "end": z + scene["end_depth"],
            }
            # Positions of metres, a dozen operations.
            assert abs(away[event["surface"]]) < 100 * np.finfo(float).eps
    assert set(touched) == {"ring", "backboard", "bridge", "end"}


def test_invalid_shots_are_left_out() -> None:
    states = SAMPLE[:3].copy()
    states[1, 0] = np.nan
    data = data_of(page(simulate(states), hoopgen.PAPER, labels=["a", "b", "c"]))
    assert [shot["label"] for shot in data["shots"]] == ["a", "c"]
    assert data["title"] == "2 shots"


def test_parameters_by_shot_go_with_the_shot() -> None:
    scene = hoopgen.PAPER | {"gravity": np.array([9.81, 9.7])}
    data = data_of(page(simulate(SAMPLE[:2], scene), scene))
    assert "gravity" not in data["parameters"]
    assert [shot["parameters"] for shot in data["shots"]] == [{"gravity": 9.81}, {"gravity": 9.7}]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"path": "shot.txt"}, r"'shot\.txt' ends in none of \.html, \.htm"),
        ({"labels": ["one"]}, "labels: expected 2"),
        ({"labels": "ab"}, "labels: expected 2"),
        ({"parameters": {"weight": 1.0}}, "parameters: unknown weight"),
        (
            {"shots": simulate(np.full((2, 9), np.nan))},
            "shots: expected 1 to 2000 valid ones, got 0",
        ),
        ({"shots": simulate(np.tile(SAMPLE[0], (2001, 1)))}, "got 2001"),
    ],
)
def test_what_is_wrong_is_said(tmp_path: Path, change: dict[str, Any], said: str) -> None:
    arguments = {"shots": simulate(SAMPLE[:2]), "parameters": hoopgen.PAPER, "path": "shots.html"}
    arguments |= change
    with pytest.raises(ValueError, match=said):
        view(**{**arguments, "path": tmp_path / arguments["path"]})
    assert not list(tmp_path.iterdir())


def test_without_the_event_log_it_says_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(AttributeError, match="record=True"):
        view(hoopgen.simulate(SAMPLE[0]), hoopgen.PAPER, tmp_path / "shot.html")


def test_surfaces_have_the_colours_of_the_pictures(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    from hoopgen.plots import COLOURS

    written = view(hoopgen.simulate(SAMPLE[0], record=True), hoopgen.PAPER, tmp_path / "shot.html")
    style = Path(written).read_text("utf-8").partition("<style>")[2].partition("</style>")[0]
    by_day = "".join(re.findall(r":root \{.*?\}", style, re.S))
    given = re.findall(r"--([a-z-]+): (#[0-9A-F]{6});", by_day)
    assert len(given) == len(dict(given)), "no colour is given twice"
    assert {name: dict(given)[name] for name in COLOURS} == dict(COLOURS)
    own = (FOLDER / "page.css").read_text("utf-8").upper()
    assert [colour for colour in COLOURS.values() if colour in own] == [], "they have names there"


def test_three_is_the_release_that_its_notes_name_and_small() -> None:
    notes = (FOLDER / "three" / "README.md").read_text("utf-8")
    script = (FOLDER / "three" / "three.js").read_text("utf-8")
    (release,) = set(re.findall(r"three@0\.(\d+)\.0", notes))
    assert f'"{release}"' in script
    assert len(script) < 700_000
    # As its licence wants, that goes where the script goes.
    text = page(simulate(SAMPLE[0]), hoopgen.PAPER)
    assert script in text
    assert (FOLDER / "three" / "LICENSE").read_text("utf-8") in text


# In a browser


class Browser:
    """A headless Chromium, spoken to in its debugging protocol through two pipes."""

    FLAGS = (
        "--headless=new",
        "--no-sandbox",  # it does not run as root; the pages are ours
        "--disable-dev-shm-usage",
        "--use-gl=angle",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        "--remote-debugging-pipe",  # commands on 3, answers on 4
    )
    PATIENCE = 120
    """Seconds without an answer after which something hangs."""

    def __init__(self, command: str, folder: Path) -> None:
        commands, self._commands = os.pipe()
        self._answers, answers = os.pipe()
        self.process = subprocess.Popen(
            [command, *self.FLAGS, f"--user-data-dir={folder / 'profile'}", "about:blank"],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            pass_fds=(3, 4),
            preexec_fn=lambda: (os.dup2(commands, 3), os.dup2(answers, 4)),
            start_new_session=True,
        )
        os.close(commands)
        os.close(answers)
        self.folder = folder
        self.events: list[dict[str, Any]] = []
        self._read = b""
        self._calls = 0

    def call(self, method: str, session: str | None = None, **parameters: Any) -> dict[str, Any]:
        self._calls += 1
        order = {"id": self._calls, "method": method, "params": parameters}
        order |= {"sessionId": session} if session else {}
        os.write(self._commands, json.dumps(order).encode() + b"\0")
        while (answer := self._receive()).get("id") != self._calls:
            self.events.append(answer)
        assert "error" not in answer, (method, answer)
        return dict(answer["result"])

    def wait(self, method: str, session: str) -> None:
        wanted = {"method": method, "sessionId": session}
        while not any(wanted.items() <= event.items() for event in self.events):
            self.events.append(self._receive())

    def _receive(self) -> dict[str, Any]:
        while b"\0" not in self._read:
            ready, _, _ = select.select([self._answers], [], [], self.PATIENCE)
            block = os.read(self._answers, 1 << 20) if ready else b""
            assert block, "the browser does not answer"
            self._read += block
        message, _, self._read = self._read.partition(b"\0")
        return dict(json.loads(message))

    def close(self) -> None:
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        os.close(self._commands)
        os.close(self._answers)

    def open(self, text: str, at: str = "", size: tuple[int, int] = (1000, 640)) -> Tab:
        """Open a page and wait until it is drawn; `at` goes at the end of its address."""
        path = self.folder / "page.html"
        path.write_text(text, "utf-8", newline="\n")
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        tab = Tab(self, target, attached["sessionId"])
        for domain in ("Page", "Runtime", "Log"):
            tab.call(f"{domain}.enable")
        width, height = size
        look = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        tab.call("Emulation.setDeviceMetricsOverride", **look)
        tab.call("Page.navigate", url=path.as_uri() + at)
        self.wait("Page.loadEventFired", tab.session)
        tab.settle()
        return tab


@dataclass(frozen=True)
class Tab:
    """A page that is open."""

    browser: Browser
    target: str
    session: str

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        return self.browser.call(method, self.session, **parameters)

    def run(self, script: str) -> Any:
        """Run a script, and return its value, or that of its promise."""
        # As text, so that doubles are written by JavaScript itself, which reads back to the bit.
        whole = f"(async () => JSON.stringify(await ({script})) ?? 'null')()"
        answer = self.call("Runtime.evaluate", expression=whole, awaitPromise=True)
        assert "exceptionDetails" not in answer, answer
        return json.loads(answer["result"]["value"])

    def settle(self) -> None:
        """Wait until two more frames are drawn."""
        self.run("new Promise((go) => requestAnimationFrame(() => requestAnimationFrame(go)))")

    def until(self, holds: str) -> None:
        look = f"const look = () => (({holds}) ? go() : setTimeout(look, 20)); look();"
        self.run(f"new Promise((go) => {{ {look} }})")

    def press(self, key: str, text: str = "") -> None:
        given = {"key": key, "text": text} if text else {"key": key}
        self.call("Input.dispatchKeyEvent", type="keyDown", **given)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def drag(self, *path: tuple[float, float]) -> None:
        """Press the mouse at the first place, release it at the last."""
        kinds = ["mousePressed", *["mouseMoved"] * (len(path) - 1), "mouseReleased"]
        for kind, (x, y) in zip(kinds, [*path, path[-1]], strict=True):
            held = {"x": x, "y": y, "button": "left", "clickCount": 1}
            self.call("Input.dispatchMouseEvent", type=kind, **held)
        self.settle()

    def click(self, selector: str) -> None:
        self.run(f"document.querySelector({json.dumps(selector)}).click()")
        self.settle()

    def text(self, selector: str) -> str:
        return str(self.run(f"document.querySelector({json.dumps(selector)}).textContent"))

    @property
    def data(self) -> dict[str, str]:
        return dict(self.run("({...document.body.dataset})"))

    @property
    def time(self) -> float:
        return float(self.data["time"])

    @property
    def badges(self) -> str:
        return str(self.run("document.getElementById('badges').innerHTML"))

    @property
    def console(self) -> list[Any]:
        """All that was said on the console, exceptions and refusals of the policy among it."""
        said = ("Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded")
        events = [event for event in self.browser.events if event.get("sessionId") == self.session]
        return [event["params"] for event in events if event["method"] in said]

    def pixels(self) -> np.ndarray[Any, Any]:
        """Return what is seen of the picture, the buttons above aside: (h, w, 3), 0 to 255."""
        image = pytest.importorskip("matplotlib.image")
        taken = base64.b64decode(self.call("Page.captureScreenshot")["data"])
        box = self.run("document.getElementById('stage').getBoundingClientRect()")
        high, wide = int(box["height"]), int(box["width"])
        seen = np.rint(255 * image.imread(io.BytesIO(taken))[60:high, :wide, :3])
        return np.asarray(seen, dtype=np.int64)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    names = ("chromium", "chromium-browser", "google-chrome")
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        missing = f"none of {', '.join(names)} is on PATH"
        if os.environ.get("CI"):
            pytest.fail(missing)
        pytest.skip(missing)
    running = Browser(found, tmp_path_factory.mktemp("browser"))
    yield running
    running.close()


@pytest.fixture
def show(browser: Browser) -> Iterator[Callable[..., Tab]]:
    """Open pages, which must say nothing on the console."""
    tabs: list[Tab] = []

    def opened(*arguments: Any, **options: Any) -> Tab:
        tabs.append(browser.open(*arguments, **options))
        return tabs[-1]

    yield opened
    for tab in tabs:
        assert tab.console == []
        browser.call("Target.closeTarget", targetId=tab.target)


def drawn(pixels: np.ndarray[Any, Any]) -> bool:
    """Whether there is the path, in its own colour, and bodies with light and shade."""
    path = np.all(pixels == [0x00, 0x72, 0xB2], axis=2).sum()
    colours = len(np.unique(pixels.reshape(-1, 3), axis=0))
    return bool(path > 200 and colours > 500)


SIZES = [(1280, 800), (390, 844)]


@pytest.mark.parametrize("size", SIZES, ids=["desk", "phone"])
@pytest.mark.parametrize("slug", ["5d", "6b-wz2", "7"])
def test_the_browser_shows_the_shot(
    show: Callable[..., Tab], slug: str, size: tuple[int, int]
) -> None:
    shots = simulate(STATES[slug])
    tab = show(page(shots, hoopgen.PAPER, title=NASTY), size=size)
    assert tab.text("h1") == tab.run("document.title") == NASTY
    outcome = hoopgen.Outcome(shots.outcome[0]).name
    assert tab.data["outcome"] == outcome.lower()
    assert tab.text("#outcome").startswith(outcome.capitalize())
    listed = "[...document.querySelectorAll('#events button')].map((row) => ({...row.dataset}))"
    surfaces = (*hoopgen.SURFACES, "end")
    assert [(row["surface"], float(row["time"])) for row in tab.run(listed)] == [
        (surfaces[event["surface"]], event["time"]) for event in shots.trajectory(0).events
    ]
    assert drawn(tab.pixels())


@pytest.mark.parametrize("size", SIZES, ids=["desk", "phone"])
def test_in_no_view_anything_lies_on_anything(
    show: Callable[..., Tab], size: tuple[int, int]
) -> None:
    tab = show(
        page(simulate([STATES["5d"], STATES["6b-wz2"], STATES["7"]]), hoopgen.PAPER), size=size
    )
    width, height = (
        tab.run(f"document.getElementById('stage').client{side}") for side in ("Width", "Height")
    )
    for shot, look in itertools.product(range(3), ["3d", "side", "top", "shooter", "hoop"]):
        tab.run(f"(location.hash = '#shot={shot}&view={look}')")
        tab.settle()
        found = tab.run(
            "[...document.querySelectorAll('.badge rect, #views')]"
            ".map((part) => part.getBoundingClientRect())"
        )
        assert len(found) > (2 if look == "hoop" else 3)
        for one, other in itertools.combinations(found, 2):
            apart = [
                one[low] >= other[high] or other[low] >= one[high]
                for low, high in (("left", "right"), ("top", "bottom"))
            ]
            assert any(apart), (look, one, other)
        for box in found:
            assert 0 <= box["left"] < box["right"] <= width
            assert 0 <= box["top"] < box["bottom"] <= height
    # Nor is the page wider than the screen.
    assert tab.run("document.documentElement.scrollWidth") <= size[0]


def test_positions_are_those_of_the_trajectory(show: Callable[..., Tab]) -> None:
    states = np.array([*STATES.values(), *SAMPLE[:20]])
    scene = hoopgen.PAPER | {"gravity": np.linspace(9.7, 9.9, len(states))}
    shots = simulate(states, scene)
    tab = show(page(shots, scene))
    random = np.random.default_rng(5)
    for row in range(len(states)):
        trajectory = shots.trajectory(row)
        events = trajectory.events["time"]
        between = random.uniform(0, trajectory.duration, 20)
        times = [0.0, *events, *np.nextafter(events, 0), *between]
        found = tab.run(f"{json.dumps(times)}.map((time) => hoopgen.stateAt({row}, time))")
        # Doubles, and the same operations in the same order: ==.
        assert np.array_equal(found, trajectory.at(times))


def test_it_plays_pauses_and_jumps(show: Callable[..., Tab]) -> None:
    shots = simulate(STATES["7"])
    tab = show(page(shots, hoopgen.PAPER))
    assert tab.time == 0.0
    tab.press(" ", " ")
    assert tab.run("document.getElementById('play').ariaLabel") == "Pause"
    tab.until("Number(document.body.dataset.time) > 0")
    tab.press(" ", " ")
    assert tab.run("document.getElementById('play').ariaLabel") == "Play"
    tab.click("#events li:nth-child(2) button")
    assert tab.time == shots.events["time"][1]
    assert tab.run("document.querySelector('[aria-current]').dataset.surface") == "backboard"
    tab.click("#speeds button:last-child")
    tab.click("#play")
    tab.until("document.getElementById('play').ariaLabel === 'Play'")
    (shot,) = data_of(page(shots, hoopgen.PAPER))["shots"]
    assert tab.time == shot["floor_time"] > shots.time[0]


def test_the_ball_moves_with_time(show: Callable[..., Tab]) -> None:
    tab = show(page(simulate(STATES["7"]), hoopgen.PAPER), at="#time=0.4")
    before = tab.pixels()
    tab.run("(location.hash = '#time=0.6')")
    tab.until("document.body.dataset.time === '0.6'")
    tab.settle()
    moved = np.any(before != tab.pixels(), axis=2).mean()
    # Two discs of the ball's size: some, and not all.
    assert 0.0005 < moved < 0.05


def test_the_picture_turns_by_mouse_and_by_keys(show: Callable[..., Tab]) -> None:
    tab = show(page(simulate(STATES["7"]), hoopgen.PAPER))
    seen = [tab.badges]
    tab.drag((300, 400), (340, 400), (380, 420))
    seen.append(tab.badges)
    tab.run("document.getElementById('picture').focus()")
    for key in ("ArrowLeft", "ArrowUp", "+"):
        tab.press(key)
        tab.settle()
        seen.append(tab.badges)
    tab.click("#views button")
    assert len(set(seen)) == len(seen)
    assert tab.badges == seen[0]


def test_a_sample_is_sifted_by_outcome_and_kind(show: Callable[..., Tab]) -> None:
    shots = simulate(SAMPLE)
    made = np.flatnonzero(shots.outcome == hoopgen.Outcome.MADE)
    clean = np.flatnonzero(shots.contacts[made] == 0)
    tab = show(page(shots, hoopgen.PAPER))
    options = "[...document.querySelectorAll('#shot option')].map((option) => Number(option.value))"
    assert tab.run(options) == [*range(len(SAMPLE))]
    assert drawn(tab.pixels())
    tab.click("#filters input[value=missed]")
    assert tab.run(options) == made.tolist()
    assert tab.data["outcome"] == "made"
    for box in ("rim", "rim_board"):
        tab.click(f"#filters input[value={box}]")
    assert tab.run(options) == made[clean].tolist()
    tab.click("#next")
    tab.click("#next")
    assert int(tab.data["shot"]) == made[clean][2]
    tab.click("#filters input[value=made]")
    assert tab.run(options) == []


def test_a_click_on_a_path_chooses_its_shot(show: Callable[..., Tab]) -> None:
    # Far apart: from the front, and from either side.
    angles = np.radians([0, 60, -60])
    states = hoopgen.release(7.2, np.radians(52), height=2.1, distance=4.2, angle=angles)
    tab = show(page(simulate(states), hoopgen.PAPER))
    for shot in (2, 1, 0):
        tab.run(f"(location.hash = '#shot={shot}')")
        tab.until(f"document.body.dataset.shot === '{shot}'")
        tab.settle()
        end = "document.querySelector('#badges .release circle').getBoundingClientRect()"
        place = tab.run(end)
        other = (shot + 1) % 3
        tab.run(f"(location.hash = '#shot={other}')")
        tab.until(f"document.body.dataset.shot === '{other}'")
        tab.drag((place["x"] + 4, place["y"] + 4))
        assert int(tab.data["shot"]) == shot


def test_a_shot_without_an_event_falls_to_the_floor(show: Callable[..., Tab]) -> None:
    short = simulate([3.0, 0, -1, 0, 0, -1, 0, 0, 0])
    assert short.outcome[0] == hoopgen.Outcome.SHORT
    tab = show(page(short, hoopgen.PAPER))
    assert tab.data["outcome"] == "short"
    assert not tab.run("document.getElementById('play').disabled")
    assert float(tab.run("document.getElementById('slider').max")) > 0.0


def test_nothing_foreign_runs_in_the_page(browser: Browser) -> None:
    text = page(simulate(STATES["7"]), hoopgen.PAPER)
    foreign = "<script>document.body.dataset.foreign = 1</script><img src=https://example.org/>"
    tab = browser.open(text.replace("</body>", f"{foreign}</body>"))
    assert "foreign" not in tab.data
    assert len(tab.console) == 2
    assert "Content Security Policy" in str(tab.console)


def test_without_webgl_the_words_stay(browser: Browser) -> None:
    blind = "HTMLCanvasElement.prototype.getContext = () => null;"
    digest = base64.b64encode(hashlib.sha256(blind.encode()).digest()).decode()
    text = page(simulate(STATES["7"]), hoopgen.PAPER)
    text = text.replace("script-src ", f"script-src 'sha256-{digest}' ", 1)
    tab = browser.open(text.replace("<body>", f"<body><script>{blind}</script>", 1))
    assert "WebGL" in tab.text("#sorry")
    assert not tab.run("document.getElementById('sorry').hidden")
    assert tab.run("document.querySelectorAll('#events button').length") == 3


# A sample of a table


@pytest.fixture(scope="module")
def table(tmp_path_factory: pytest.TempPathFactory) -> Path:
    pytest.importorskip("pyarrow")
    pytest.importorskip("scipy")
    path = tmp_path_factory.mktemp("table") / "releases.csv"
    speeds = np.random.default_rng(1).normal(16, 0.2, 100)
    lines = [f"{k},{speed},52,7" for k, speed in enumerate(speeds)]
    path.write_text("\n".join(["player,speed_mph,elevation_deg,height_ft", *lines, ""]))
    return path


def test_a_sample_does_not_hang_on_how_the_table_is_read(table: Path) -> None:
    from hoopgen.viewer import row_sample as module

    def taken(count: int, **options: int) -> module.Sample:
        return module.sample(table, count, 7, release={"distance": 4.191}, **options)

    whole, every = taken(20), taken(1000)
    assert (whole.total, len(whole.rows), len(set(whole.rows))) == (100, 20, 20)
    assert np.array_equal(whole.rows, np.sort(whole.rows))
    assert np.array_equal(every.rows, np.arange(100))
    assert np.array_equal(whole.releases.states, every.releases.states[whole.rows])
    in_parts = taken(20, rows_at_once=9)
    assert np.array_equal(in_parts.rows, whole.rows)
    assert np.array_equal(in_parts.releases.states, whole.releases.states)


@pytest.mark.slow
def test_every_row_is_as_likely(table: Path) -> None:
    from hoopgen.viewer.row_sample import sample

    chosen = [sample(table, 10, seed, release={"distance": 4}).rows for seed in range(200)]
    often = np.bincount(np.concatenate(chosen), minlength=100)
    # Binomial, 200 tries of 0.1: 20 ± 4.2, within five of these.
    assert np.all(np.abs(often - 20) < 5 * np.sqrt(200 * 0.1 * 0.9))


def test_a_sample_is_random_among_shots_that_the_same_seed_drew(tmp_path: Path) -> None:
    from hoopgen.viewer.row_sample import sample

    measured = {"speed": np.linspace(6.0, 8.0, 5000), "elevation": 0.9, "height": 2, "distance": 4}
    drawn = hoopgen.Resample(measured).draw(0, 20_000, seed=0).columns["speed"]
    file = tmp_path / "drawn.csv"
    rows = "\n".join(f"{speed},0.9,2,4" for speed in drawn)
    file.write_text(f"speed,elevation_rad,height,distance\n{rows}\n", encoding="utf-8")
    chosen = drawn[sample(file, 200, seed=0).rows]
    # Uniform over 2 m/s: a mean of 200 has a standard deviation of 0.041 m/s; within five of these.
    assert abs(chosen.mean() - 7.0) < 5 * 2 / np.sqrt(12 * 200)


def test_the_command_shows_a_sample_of_a_table(table: Path, tmp_path: Path) -> None:
    out = tmp_path / "shots.html"
    options = ["--sample", "5", "--seed", "3", "--release", "distance=13.75ft", "--preset", "nba"]
    result = succeed("view", str(table), "--out", str(out), *options)
    data = data_of(out.read_text("utf-8"))
    assert data["about"] == "5 of 100 rows of releases.csv, chosen at random (seed 3); scene NBA"
    assert data["about"] in result.stdout
    assert data["title"] == "5 shots"
    assert all(re.fullmatch(r"Row \d+", shot["label"]) for shot in data["shots"])
    assert data["parameters"]["ring_radius"] == hoopgen.NBA["ring_radius"]
    row = int(data["shots"][0]["label"].split()[1])
    speed = float(table.read_text(encoding="utf-8").splitlines()[row].split(",")[1]) * 0.44704
    # The release's sine and cosine come between.
    assert np.linalg.norm(data["shots"][0]["flights"][0][4:7]) == pytest.approx(speed, rel=1e-14)


NAMED = """player,game,speed,elevation_deg,height,distance
Ann,0022400001,7.1,52,2.1,4.2
Bea,0022400002,7.2,52,2.1,4.2
Ann,0022400003,7.3,52,2.1,4.2
,0022400004,7.0,52,2.1,4.2
  </script><b>,0022400005,7.2,51,2.1,4.2
"""


def labels_of(file: Path, out: Path, *options: str) -> list[str]:
    succeed("view", str(file), "--out", str(out), *options)
    return [shot["label"] for shot in data_of(out.read_text("utf-8"))["shots"]]


def test_a_column_names_the_shots_and_no_two_alike(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    pytest.importorskip("scipy")
    file, out = tmp_path / "named.csv", tmp_path / "shots.html"
    file.write_text(NAMED, encoding="utf-8")
    wanted = ["Ann, row 1", "Bea", "Ann, row 3", "Row 4", "</script><b>"]
    assert labels_of(file, out, "--label", "player") == wanted
    games = [f"00224{number:05}" for number in range(1, 6)]
    assert labels_of(file, out, "--label", "game") == games
    speeds = ["7.1", "7.2, row 2", "7.3", "7.0", "7.2, row 5"]
    assert labels_of(file, out, "--label", "speed") == speeds
    assert labels_of(file, out) == [f"Row {row}" for row in range(1, 6)]
    shown = hoopgen.view(file, labels="player")
    assert [shot["label"] for shot in data_of(shown.text)["shots"]] == wanted
    with pytest.raises(ValueError, match=r"labels: of a file, expected a column's name, got \['a'"):
        hoopgen.view(file, labels=["a"] * 5)
    result = run("view", str(file), "--out", str(out), "--label", "shooter")
    assert (result.exit_code, result.stdout) == (2, "")
    said = "has no column 'shooter'. The columns are player, game, speed, elevation_deg"
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_name_stays_with_its_shot_however_the_table_is_read(table: Path) -> None:
    """The column player of that table is the row, from 0."""
    from hoopgen.viewer import row_sample as module

    chosen = module.sample(
        table, 20, 7, release={"distance": 4.191}, label="player", rows_at_once=9
    )
    assert chosen.labels == [str(row) for row in chosen.rows]


def test_results_keep_the_column_that_names_them(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    pytest.importorskip("scipy")
    file, out = tmp_path / "named.csv", tmp_path / "results.parquet"
    file.write_text(NAMED + f"{'long ' * 30},6,7.1,52,2.1,4.2\n", encoding="utf-8")
    hoopgen.batch(file, out)
    labels = labels_of(out, tmp_path / "shots.html", "--label", "player")
    assert labels[:4] == ["Ann, row 1", "Bea", "Ann, row 3", "Row 4"]
    assert labels[-1].endswith("...")
    assert len(labels[-1]) == 40
    kinds = labels_of(out, tmp_path / "shots.html", "--label", "outcome")
    assert all(re.fullmatch(r"(made|missed)(, row \d)?", kind) for kind in kinds)


def test_results_of_a_batch_are_shown_as_its_releases_are(table: Path, tmp_path: Path) -> None:
    results = tmp_path / "results.parquet"
    here = ["--release", "distance=13.75ft"]
    measures = [word for name in MEASURES for word in ("--measure", name)]
    succeed("batch", str(table), "--out", str(results), *here, *measures)
    pages = []
    for source in (table, results):
        out = tmp_path / f"{source.stem}.html"
        succeed("view", str(source), "--out", str(out), *here)
        pages.append(data_of(out.read_text("utf-8")) | {"about": ""})
    assert pages[0] == pages[1]


def test_the_shot_command_writes_a_page(tmp_path: Path) -> None:
    out = tmp_path / "shot.html"
    succeed("shot", *RELEASE, "--view", str(out))
    data = data_of(out.read_text("utf-8"))
    assert data["title"] in ("Made", "Missed")
    assert data["about"] == "Scene PAPER (the article's)"
    assert len(data["shots"]) == 1


def test_the_commands_say_what_is_wrong(table: Path, tmp_path: Path) -> None:
    out = str(tmp_path / "shots.txt")
    given = ["view", str(table), "--out", out, "--release", "distance=4"]
    result = run(*given)
    assert (result.exit_code, result.stdout) == (2, "")
    assert ".html" in result.stderr
    assert result.stderr.count("\n") == 1


@pytest.mark.sampled(2)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -5.0])
@pytest.mark.parametrize("scene", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_a_parameter_of_an_invalid_shot_changes_no_page(scene: Any, bad: float) -> None:
    states, radii = free_throws(3), np.array([0.235, bad, 0.237])
    good = [0, 2]
    shots = hoopgen.simulate(states, {"ring_radius": radii}, scene=scene, record=True)
    others = hoopgen.simulate(states[good], {"ring_radius": radii[good]}, scene=scene, record=True)
    assert np.sum(shots.outcome == scene.outcomes["INVALID"]) == 1
    # What it says of the scene names all values that were given.
    drawn, expected = (
        re.sub(r'"about":"[^"]*"', "", page(of, of.parameters, labels=names))
        for of, names in ((shots, ["a", "b", "c"]), (others, ["a", "c"]))
    )
    assert drawn == expected
