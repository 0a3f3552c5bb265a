"""The playground in a real browser: its bits, its link, its controls, and that it loads nothing."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.engine import web_assembly
from hoopgen.engine.draws import ARGUMENTS
from hoopgen.viewer.playground_page import playground
from tests.helpers.commands import failure, succeed
from tests.viewer.test_page import Browser, Tab
from tests.viewer.test_playground_scripts import GOLDEN

pytestmark = pytest.mark.xdist_group("view")  # one browser

READY = """
document.body.dataset.answered && document.body.dataset.answered === document.body.dataset.asked
"""


@pytest.fixture(scope="module")
def text() -> str:
    return playground().text


def page_spec_of(text: str) -> dict[str, Any]:
    """Return what the scripts of a page know of hoopgen."""
    (spec,) = re.findall(r'<script type="application/json" id="spec">(.*?)</script>', text, re.S)
    return dict(json.loads(spec))


def answered(tab: Tab) -> Tab:
    """Wait until all is computed of the shot as it is."""
    tab.until(READY)
    return tab


# The file


@pytest.mark.slow
def test_the_command_writes_the_page_and_nothing_else(tmp_path: Path, text: str) -> None:
    out = tmp_path / "page.html"
    assert "runs in this page" in succeed("playground", "--out", out).stdout
    assert out.read_text("utf-8") == text
    assert list(tmp_path.iterdir()) == [out]
    assert "ends in none of .html, .htm" in failure("playground", "--out", tmp_path / "page.txt")


@pytest.mark.slow
def test_the_page_is_small_and_names_no_place_in_a_network(text: str) -> None:
    assert len(text.encode()) < 1_650_000
    names = {"http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg"}
    assert set(re.findall(r"\b(?:https?|wss?)://[^\s\"'`)]*", text)) <= names
    (policy,) = re.findall(r'Content-Security-Policy" content="(.*?)"', text)
    allowed = dict(rule.split(" ", 1) for rule in policy.split("; "))
    assert (allowed["default-src"], allowed["worker-src"]) == ("'none'", "blob:")
    assert "connect-src" not in allowed
    script = set(allowed["script-src"].split())
    assert {one for one in script if not one.startswith("'sha256-")} == {"'wasm-unsafe-eval'"}


def test_the_page_has_python_s_digests(text: str) -> None:
    for name, scene in page_spec_of(text)["scenes"].items():
        assert scene["fixed"]["sha256"] == GOLDEN[name]


# In a browser


def with_one_build(text: str, build: str) -> str:
    """Return the page without the other module of a module's scene."""
    scene, _ = web_assembly.MODULES[build]
    (other,) = (
        name for name, (own, _) in web_assembly.MODULES.items() if own == scene and name != build
    )
    only = re.sub(rf'\{{"name":"{re.escape(other)}","lanes":\d\}},?', "", text)
    assert len(only) < len(text)
    return only.replace("},]", "}]")


@pytest.mark.slow
@pytest.mark.parametrize("build", web_assembly.MODULES)
def test_every_build_has_the_golden_hash_in_a_browser(
    show: Callable[..., Tab], text: str, build: str
) -> None:
    """Results are the bits of `hoopgen hash`, computed by that build alone."""
    scene, _ = web_assembly.MODULES[build]
    tab = show(with_one_build(text, build), at=f"#scene={scene}")
    tab.until("document.getElementById('verdict').textContent")
    assert tab.text("#hash-command") == f"hoopgen hash {scene}"
    assert tab.text("#hash") == GOLDEN[scene]
    assert tab.text("#verdict").startswith("✓")


DRAWN = """
(async () => {
  const page = JSON.parse(document.getElementById("spec").textContent);
  const spec = Study.specOf(page, "%s");
  const modules = {};
  for (const { name } of spec.modules) {
    modules[name] = await Engine.bytesOf(document.getElementById(name).textContent);
  }
  const study = await Study.start(spec, modules);
  const release = Object.fromEntries(spec.layout.arguments.map((name) => [name, page.start[name]]));
  const deviations = { speed: 0.07, elevation: 0.02, azimuth: 0.01 };
  return [study.engine.name, [...study.drawn({ release, deviations, seed: 5, count: 700 })]];
})()
"""


@pytest.mark.slow
@pytest.mark.parametrize("build", web_assembly.MODULES)
def test_every_build_draws_the_releases_of_python_in_a_browser(
    show: Callable[..., Tab], text: str, build: str
) -> None:
    """They are those of a `Scatter` to the bit, and as many go in as in an `estimate`."""
    pytest.importorskip("scipy")
    scene, _ = web_assembly.MODULES[build]
    link = f"#scene={scene}&sd_speed=0.07&sd_elevation=0.02&sd_azimuth=0.01&seed=5"
    tab = answered(show(with_one_build(text, build), at=link))
    name, found = tab.run(DRAWN % scene)
    assert name == build
    start = page_spec_of(text)["start"]
    engine = {"hoop": hoopgen.HOOP, "court": hoopgen.COURT}[scene]
    sd = {"speed": 0.07, "elevation": 0.02, "azimuth": 0.01}
    model = hoopgen.Scatter({name: start[name] for name in ARGUMENTS}, sd)
    np.testing.assert_array_equal(np.reshape(found, (700, 9)), model.draw(0, 700, 5).states)
    parameters = engine.presets["nba"]
    wanted = hoopgen.estimate(model, parameters, scene=engine, shots=10_000, seed=5)
    assert f"{wanted.made:,} of {wanted.shots - wanted.invalid:,}" in tab.text("#share")


@pytest.mark.slow
def test_nothing_is_requested_from_a_network(browser: Browser, text: str) -> None:
    tab = browser.open("<title>empty</title>")
    tab.call("Network.enable")
    path = browser.folder / "page.html"
    path.write_text(text, "utf-8", newline="\n")
    tab.call("Page.navigate", url=path.as_uri())
    tab.until("document.body && document.body.dataset.answered")
    asked = [
        event["params"]["request"]["url"]
        for event in browser.events
        if event["method"] == "Network.requestWillBeSent" and event["sessionId"] == tab.session
    ]
    assert asked
    assert all(re.match(r"file:///.*/page\.html$|data:|blob:", url) for url in asked)


@pytest.mark.slow
def test_a_link_reproduces_the_shot_to_the_bit(show: Callable[..., Tab], text: str) -> None:
    tab = answered(show(text))
    script = "Object.assign(document.getElementById('set-{}'), {{ value: '{}' }}).onchange()"
    for name, value in (("speed", 7.31), ("angle", 20), ("sd_speed", 0.1), ("restitution", 0.66)):
        tab.run(f"({script.format(name, value)}, 0)")
    tab.run("(document.getElementById('preset').value = 'fiba', 0)")
    tab.run("(document.getElementById('preset').dispatchEvent(new Event('change')), 0)")
    answered(tab)
    link, latest = tab.run("location.hash"), tab.run("hoopgen.latest()")
    share = tab.text("#share")
    assert "preset=fiba" in link
    assert link == tab.run("hoopgen.link()")
    other = answered(show(text, at=link))
    assert other.run("hoopgen.latest()") == latest
    assert other.text("#share") == share
    # Python has the same shot, of the state that the page gives to copy.
    program = other.run("hoopgen.python()")
    names: dict[str, Any] = {}
    exec(program, names)
    events = names["shots"].trajectory(0).events
    assert [event["time"] for event in latest["events"][0]] == events["time"].tolist()
    assert names["shots"].outcome[0] == latest["outcome"]["0"]


ROLLING = (
    "#scene=court&speed=7.294540799323649&elevation=1.0177597678068222&azimuth=0.031374844508483296"
)
"""A ball that rolls on the ring for 1.3 s, and into it."""


@pytest.mark.slow
def test_the_real_ball_is_that_of_python_with_its_rolls(
    show: Callable[..., Tab], text: str
) -> None:
    tab = answered(show(text, at=ROLLING))
    names: dict[str, Any] = {}
    exec(tab.run("hoopgen.python()"), names)
    shots = names["shots"]
    path = shots.trajectory(0)
    found = tab.run("hoopgen.latest().events[0]")
    assert [event["time"] for event in found] == path.events["time"].tolist()
    assert [event["kind"] for event in found] == path.events["kind"].tolist()
    assert tab.data["outcome"] == shots.scene.outcomes(int(shots.outcome[0])).name.lower()
    listed = tab.run("[...document.querySelectorAll('#events button')].map((one) => one.innerText)")
    assert len(listed) == len(found)
    rolls = [row for row, one in enumerate(listed) if one.startswith("rolls")]
    assert rolls == [row for row, _, _ in path.rolls] != []
    # The ball is drawn on the roll that Python has.
    for _, begin, end in path.rolls:
        for share in (0.1, 0.5, 0.93):
            time = begin + share * (end - begin)
            seen = tab.run(f"hoopgen.stateAt(0, {time!r}).slice(0, 3)")
            # A cubic over the 11 ms of a piece errs by 1e-8 m where the ball goes round in 0.3 s.
            np.testing.assert_allclose(seen, path.at(time)[:3], rtol=0, atol=1e-6)


@pytest.mark.slow
def test_a_link_carries_the_scene_and_old_links_have_none(
    show: Callable[..., Tab], text: str
) -> None:
    tab = answered(show(text, at="#speed=7.31&preset=fiba&restitution=0.66"))
    chosen = "[document.getElementById('scene').value, document.getElementById('preset').value]"
    assert tab.run(chosen) == ["hoop", "fiba"]
    assert "scene=hoop" in tab.run("hoopgen.link()")
    choose = """
    (() => {{
      const select = document.getElementById('{}');
      select.value = '{}';
      select.dispatchEvent(new Event('change'));
    }})()
    """
    tab.run(choose.format("scene", "court"))
    tab.until("location.hash.includes('scene=court')")
    answered(tab)
    assert tab.run("document.getElementById('set-speed').value") == "7.31"
    assert tab.run("document.getElementById('set-ring_friction').value") == "0.7"
    assert tab.run("document.getElementById('set-restitution')") is None
    tab.run(choose.format("preset", "paper"))
    field = "document.getElementById('set-bridge_friction')"
    tab.run(f"(Object.assign({field}, {{ value: '0.4' }}).onchange(), 0)")
    answered(tab)
    link, latest = tab.run("location.hash"), tab.run("hoopgen.latest()")
    assert "ring_friction=Infinity" in link
    assert tab.run("document.getElementById('set-ring_friction').value") == ""
    other = answered(show(text, at=link))
    assert other.run(chosen) == ["court", "paper"]
    assert other.run("hoopgen.latest()") == latest
    assert other.text("#share") == tab.text("#share")
    assert '| {"bridge_friction": 0.4}, scene=hoopgen.COURT' in other.run("hoopgen.python()")


@pytest.mark.slow
@pytest.mark.parametrize("seed", ["0.5", "-1", "1e99"])
def test_a_link_with_nonsense_is_the_shot_of_the_start(
    show: Callable[..., Tab], text: str, seed: str
) -> None:
    nonsense = "#speed=fast&preset=__proto__&scene=constructor&elevation=&x=<b>&height=Infinity"
    tab = answered(show(text, at=f"{nonsense}&seed={seed}"))
    assert "(seed 0)" in tab.text("#throws-note")
    assert tab.data["outcome"] == "missed"
    assert tab.run("document.getElementById('set-speed').value") == "7.25"


@pytest.mark.slow
def test_a_field_and_a_slider_change_the_shot(show: Callable[..., Tab], text: str) -> None:
    tab = answered(show(text))
    assert tab.text("#change-title") == "What would have made it"
    tab.click("#changes li[data-name=elevation] button")
    answered(tab)
    assert tab.data["outcome"] == "made"
    assert tab.text("#change-title") == "What would have missed it"
    assert tab.text("#banner").startswith("Made")
    tab.run(
        "(Object.assign(document.querySelector('#set-speed').parentElement"
        ".querySelector('[type=range]'), { value: 6.5 }).oninput(), 0)"
    )
    answered(tab)
    assert tab.data["outcome"] == "missed"
    assert tab.run("document.getElementById('set-speed').value") == "6.5"


@pytest.mark.slow
def test_no_program_of_the_picture_is_compiled_again(show: Callable[..., Tab], text: str) -> None:
    """Compiling one keeps the page from answering, on some machines for half a second."""
    tab = answered(show(text, at="#scene=court"))
    count = """
    (() => {
      const { linkProgram, drawArrays } = WebGL2RenderingContext.prototype;
      window.calls = { linked: 0, drawn: 0 };
      Object.assign(WebGL2RenderingContext.prototype, {
        linkProgram(...given) { calls.linked++; return linkProgram.apply(this, given); },
        drawArrays(...given) { calls.drawn++; return drawArrays.apply(this, given); },
      });
      return 0;
    })()
    """
    tab.run(count)
    for speed in (7.1, 7.31, 6.9, 7.42):
        field = "document.getElementById('set-speed')"
        tab.run(f"(Object.assign({field}, {{ value: {speed} }}).onchange(), 0)")
        tab.settle()
    answered(tab)
    assert tab.run("calls.drawn") > 0
    assert tab.run("calls.linked") == 0


@pytest.mark.slow
def test_units_change_with_the_page(show: Callable[..., Tab], text: str) -> None:
    tab = answered(show(text))
    tab.click("#units")
    assert float(tab.run("document.getElementById('set-distance').value")) == 13.75
    assert float(tab.run("document.getElementById('set-height').value")) == 7.0
    units = tab.run(
        "[...document.querySelectorAll('#of-release .unit')].map((one) => one.textContent)"
    )
    assert units == ["mph", "°", "°", "ft", "rpm", "rpm"]
    tab.until("document.getElementById('landings-note').textContent.includes(' ft ')")


@pytest.mark.slow
def test_the_shooter_is_moved_by_keys_and_by_the_mouse(show: Callable[..., Tab], text: str) -> None:
    tab = answered(show(text, size=(1440, 900)))
    tab.run("(document.getElementById('plan').focus(), 0)")
    tab.press("ArrowRight")
    place = "[hoopgen.latest().release[0], hoopgen.latest().release[1]]"
    x, y = tab.run(place)
    assert (round(x, 3), round(y, 3)) == (4.191, 0.1)
    box = tab.run("document.getElementById('plan').getBoundingClientRect()")
    middle = (box["left"] + box["width"] / 2, box["top"] + box["height"] / 2)
    tab.drag(middle, (middle[0] + 30, middle[1]))
    x, y = tab.run(place)
    assert 1.0 < y < 7.0
    aim = tab.run("hoopgen.latest().release")
    # The aim stays 1.5 degrees to the left of the ring's centre.
    heading = np.arctan2(-aim[4], -aim[3]) - np.arctan2(aim[1], aim[0])
    assert np.degrees(heading) == pytest.approx(1.5, rel=0, abs=1e-9)


@pytest.mark.slow
def test_an_invalid_shot_is_said_and_the_next_one_is_drawn(
    show: Callable[..., Tab], text: str
) -> None:
    """Here the ball starts inside the ring."""
    inside = "#distance=0.24&height=3.048"
    tab = show(text, at=inside)
    tab.until("!document.getElementById('fault').hidden")
    tab.run("(document.getElementById('set-distance').value = 4, 0)")
    tab.run("(document.getElementById('set-distance').onchange(), 0)")
    tab.until("document.getElementById('fault').hidden")


@pytest.mark.slow
@pytest.mark.parametrize("scene", ["hoop", "court"])
@pytest.mark.parametrize("size", [(390, 844), (820, 1100), (1440, 900)])
def test_nothing_is_wider_than_the_page_and_all_is_labelled(
    show: Callable[..., Tab], text: str, size: tuple[int, int], scene: str
) -> None:
    tab = answered(show(text, at=f"#scene={scene}", size=size))
    assert tab.run("document.documentElement.scrollWidth") <= size[0]
    bare = tab.run(
        "[...document.querySelectorAll('input, select, button, canvas, svg[tabindex]')]"
        ".filter((one) =>"
        " !(one.labels?.length || one.getAttribute('aria-label') || one.textContent.trim()))"
        ".map((one) => one.outerHTML)"
    )
    assert bare == []
    twice = tab.run(
        "(() => { const ids = [...document.querySelectorAll('[id]')].map((one) => one.id);"
        " return ids.length - new Set(ids).size; })()"
    )
    assert twice == 0


@pytest.mark.slow
def test_the_newest_change_is_answered_and_others_are_dropped(
    show: Callable[..., Tab], text: str
) -> None:
    tab = answered(show(text))
    tab.run(
        "(() => { const field = document.getElementById('set-speed');"
        " for (let k = 0; k < 40; k++) { field.value = 7 + k / 100; field.onchange(); }"
        " return 0; })()"
    )
    answered(tab)
    assert tab.run("document.getElementById('set-speed').value") == "7.39"
    wanted = tab.text("#share")
    again = answered(show(text, at=tab.run("location.hash")))
    assert again.text("#share") == wanted


def test_the_start_is_a_miss_after_nine_contacts() -> None:
    from hoopgen.viewer.playground_page import _PRESET, _START

    shots = hoopgen.simulate(hoopgen.release(**_START), hoopgen.NBA)
    assert _PRESET == "nba"
    assert (shots.made[0], shots.contacts[0]) == (False, 9)
