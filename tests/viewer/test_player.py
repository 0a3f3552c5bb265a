"""Pages under a reader's hands: all balls at once, contact by contact, by night, the ghost."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen import COURT, NBA, PAPER_COURT
from hoopgen.core.colours import BODY_COLOURS, COLOURS, face_colours, outcome_colours
from hoopgen.core.units import FOOT
from hoopgen.hoop.court_lines import COURTS, lines_of
from hoopgen.viewer import page
from hoopgen.viewer.palette import DARK_PAPER, contrast, lighten
from tests.helpers import ROOT
from tests.viewer.test_page import (
    SAMPLE,
    SIZES,
    STATES,
    Tab,
    data_of,
    drawn,
    simulate,
)

pytestmark = pytest.mark.xdist_group("view")  # one browser

Show = Callable[..., Tab]
SOFT = PAPER_COURT | {f"{name}_restitution": 0.0 for name in COURT.surfaces}
PHONE = SIZES[1]


def pressed(tab: Tab, name: str) -> str:
    return str(tab.run(f"document.getElementById('{name}').ariaPressed"))


def stop(tab: Tab) -> str:
    return tab.text("#stop")


def shift(tab: Tab, key: str) -> None:
    for kind in ("keyDown", "keyUp"):
        tab.call("Input.dispatchKeyEvent", type=kind, key=key, modifiers=8)


def at(tab: Tab, time: float) -> None:
    tab.run(f"(location.hash = '#time={time}')")
    tab.until(f"document.body.dataset.time === '{time}'")


# Units


def test_the_reader_changes_units(show: Show) -> None:
    shots = simulate(STATES["7"])
    tab = show(page(shots, hoopgen.PAPER))
    assert tab.text("#units") == "Show ft"
    assert "m/s" in tab.text("#release")
    tab.click("#units")
    assert tab.text("#units") == "Show m"
    for part in ("#release", "#now"):
        assert "mph" in tab.text(part)
        assert "ft" in tab.text(part)
    assert "grid is 3 ft; the ring hangs at 10 ft" in tab.text("#scale")
    tab.click("#units")
    assert "grid is 1 m; the ring hangs at 3.048 m" in tab.text("#scale")


# All balls


def balls(tab: Tab) -> dict[int, list[float]]:
    return {int(k): place for k, *place in tab.run("hoopgen.balls()")}


def test_all_balls_are_released_together_and_fall_to_the_floor(show: Show) -> None:
    shots = simulate(SAMPLE[:12])
    text = page(shots, hoopgen.PAPER)
    tab = show(text)
    assert [*balls(tab)] == [0]
    tab.click("#together")
    assert pressed(tab, "together") == "true"
    tab.until("Number(document.body.dataset.time) > 0")  # it plays
    tab.press(" ", " ")
    fallen = [shot["floor_time"] for shot in data_of(text)["shots"]]
    last = max(fallen)
    assert tab.run("Number(document.getElementById('slider').max)") == last
    for time in (0.25, 0.9, float(shots.time.min()) + 0.01, last):
        at(tab, time)
        found = balls(tab)
        assert [*found] == [*range(12)]
        for row, place in found.items():
            path = shots.trajectory(row)
            if time <= path.duration:
                assert place == path.at(time)[:3].tolist()
            else:
                since = min(time, fallen[row]) - path.duration
                assert (
                    place == hoopgen.HOOP.fly(since, shots.state[row], hoopgen.PAPER)[:3].tolist()
                )
            if time == last:
                floor = hoopgen.PAPER["ball_radius"] - 3.048
                assert place[2] == pytest.approx(floor, rel=0, abs=1e-12)
    # What is said is of the chosen shot, which ended before.
    assert tab.text("#when") == f"At {fallen[0]:.3f} s"
    assert tab.text("#stop") == "After the end: falls to the floor, not simulated"


def test_what_is_sifted_out_is_not_played(show: Show) -> None:
    shots = simulate(SAMPLE[:12])
    made = np.flatnonzero(shots.outcome == hoopgen.Outcome.MADE)
    assert 1 < len(made) < 12
    text = page(shots, hoopgen.PAPER)
    tab = show(text)
    tab.click("#together")
    tab.click("#filters input[value=missed]")
    assert [*balls(tab)] == made.tolist()
    fallen = [shot["floor_time"] for shot in data_of(text)["shots"]]
    last = max(fallen[row] for row in made)
    assert tab.run("Number(document.getElementById('slider').max)") == last
    tab.click("#filters input[value=made]")
    assert balls(tab) == {}


def test_another_shot_is_chosen_at_the_same_time_of_all(show: Show) -> None:
    tab = show(page(simulate(SAMPLE[:3]), hoopgen.PAPER))
    tab.click("#together")
    tab.press(" ", " ")
    at(tab, 0.5)
    tab.click("#next")
    assert (tab.data["shot"], tab.time) == ("1", 0.5)
    tab.click("#together")
    assert [*balls(tab)] == [1]
    assert tab.time == 0.5


def test_one_shot_alone_has_none_to_be_played_with(show: Show) -> None:
    tab = show(page(simulate(STATES["7"]), hoopgen.PAPER))
    assert tab.run("document.getElementById('together').hidden")


# Contact by contact


def test_it_goes_from_contact_to_contact_and_names_them(show: Show) -> None:
    shots = simulate(STATES["7"])
    tab = show(page(shots, hoopgen.PAPER))
    first, second, last = shots.events["time"]
    told = [
        ("Release, 0.000 s", 0.0),
        (f"Contact 1 of 2: ring, {first:.3f} s", first),
        (f"Contact 2 of 2: backboard, {second:.3f} s", second),
        (f"End plane, {last:.3f} s", last),
    ]
    assert (stop(tab), tab.time) == told[0]
    names = [tab.run(f"document.getElementById('{way}').ariaLabel") for way in ("back", "on")]
    assert names == ["Previous contact", "Next contact"]
    for wanted in [*told[1:], told[-1]]:  # and no further
        tab.click("#on")
        assert (stop(tab), tab.time) == wanted
        assert tab.run("document.querySelectorAll('[aria-current]').length") == 1
    for wanted in [*told[-2::-1], told[0]]:
        tab.click("#back")
        assert (stop(tab), tab.time) == wanted
    # By keys, wherever the focus is, and from between two contacts.
    for focus in ("picture", "slider", "play"):
        at(tab, 0.5)
        tab.run(f"document.getElementById('{focus}').focus()")
        shift(tab, "ArrowRight")
        assert (stop(tab), tab.time) == told[1]
        at(tab, (first + second) / 2)
        assert stop(tab) == told[1][0]
        shift(tab, "ArrowLeft")
        assert (stop(tab), tab.time) == told[1]


def test_a_contact_and_the_roll_at_the_same_time_are_both_named(show: Show) -> None:
    state = [0.2, 0.13, 0.3, 0, 0, 0, 0, 0, 0]
    shots = hoopgen.simulate(state, SOFT, scene=COURT, record=True)
    times = shots.events["time"]
    assert times[0] == times[1]
    tab = show(page(shots, SOFT))
    said = [stop(tab)]
    for row in range(4):
        tab.click("#on")
        said.append(stop(tab))
        current = "document.querySelector('[aria-current]').parentElement"
        listed = f"[...document.querySelectorAll('#events li')].indexOf({current})"
        assert tab.run(listed) == row
    assert said == [
        "Release, 0.000 s",
        f"Contact 1 of 1: ring, {times[0]:.3f} s",
        f"Rolls on the ring, {times[1]:.3f} s",
        f"Leaves the ring, {times[2]:.3f} s",
        f"End, {times[3]:.3f} s",
    ]


def test_a_roll_in_air_is_said_to_be_without_it(show: Show) -> None:
    """The sentence is that of shots that roll, in a scene in air, and of no others."""
    pytest.importorskip("sympy")  # which derives the hoop of a gym in air
    states = [[0.2, 0.13, 0.3, 0, 0, 0, 0, 0, 0], [0, 0, 0.3, 0, 0, 0, 0, 0, 0]]
    said = "While the ball rolls, no air acts along the surface."
    for scene, rolled in ((COURT, False), (hoopgen.COURT_AIR, True)):
        shots = hoopgen.simulate(states, SOFT, scene=scene, record=True)
        assert shots.rolls.tolist() == [1, 0]
        tab = show(page(shots, SOFT))
        assert (said in tab.text("#outcome")) == rolled
        tab.run("document.getElementById('shot').value = 1")
        tab.run("document.getElementById('shot').dispatchEvent(new Event('change'))")
        assert "made" in tab.text("#outcome").lower()
        assert said not in tab.text("#outcome")


# By night


def test_by_night_colours_are_legible_and_stay_apart() -> None:
    every = {
        *COLOURS.values(),
        *BODY_COLOURS,
        *outcome_colours(COURT.outcomes.__members__, 2).values(),
    }
    every |= {*face_colours(COURT.surfaces).values()}
    every -= {COLOURS["paper"]}
    night = {colour: lighten(colour) for colour in every}
    assert len({*night.values()}) == len(every)
    for day, dark in night.items():
        assert contrast(dark, DARK_PAPER) >= 4.5
        # As strong as by day, as far as there is light.
        wanted = min(contrast(day, "#FFFFFF"), contrast("#FFFFFF", DARK_PAPER))
        assert contrast(dark, DARK_PAPER) >= wanted
    assert contrast("#000000", "#FFFFFF") == pytest.approx(21, rel=1e-15)
    assert contrast("#777777", "#FFFFFF") == pytest.approx(4.48, abs=0.005)  # as WCAG has it


STYLE = "getComputedStyle(document.documentElement).getPropertyValue('--{}')"


@pytest.mark.parametrize("scene", [hoopgen.HOOP, COURT], ids=["hoop", "court"])
def test_outcomes_and_bodies_have_the_colours_of_pictures(show: Show, scene: Any) -> None:
    shots = hoopgen.simulate(STATES["7"], scene=scene, record=True)
    tab = show(page(shots, shots.parameters), size=PHONE)
    day = {
        f"ink-{k}": one
        for k, one in enumerate(outcome_colours(scene.outcomes.__members__, 2).values())
    }
    if scene is COURT:  # a pale board with a dark badge
        drawn = face_colours(scene.surfaces)
        assert drawn["backboard"] != COLOURS["backboard"]
        day |= {f"face-{k}": drawn[name] for k, name in enumerate(scene.surfaces)}
        day |= {f"body-{scene.surfaces.index('backboard')}": COLOURS["backboard"]}
    for look in (str, lighten):
        assert {name: tab.run(STYLE.format(name)) for name in day} == {
            name: look(colour) for name, colour in day.items()
        }
        tab.click("#theme")


def test_the_board_of_the_whole_hoop_is_neither_black_by_day_nor_white_by_night(show: Show) -> None:
    shots = hoopgen.simulate(STATES["7"], scene=COURT, record=True)
    tab = show(page(shots, shots.parameters))
    assert np.all(tab.pixels() < 0x50, axis=2).mean() < 0.005  # nothing large is nearly black
    tab.click("#theme")
    assert np.all(tab.pixels() > 0xB0, axis=2).mean() < 0.005  # nor nearly white


WORDS = """
(() => {
  const walk = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
  const found = [];
  while (walk.nextNode()) {
    const { parentElement: own, textContent } = walk.currentNode;
    if (!textContent.trim() || !own.checkVisibility() || own.closest("svg, .tag")) continue;
    let behind = own;
    while (behind && getComputedStyle(behind).backgroundColor === "rgba(0, 0, 0, 0)")
      behind = behind.parentElement;
    const paper = getComputedStyle(behind ?? document.body).backgroundColor;
    found.push([textContent.trim(), getComputedStyle(own).color, paper]);
  }
  return found;
})()
"""


def as_hex(colour: str) -> str:
    return "#" + "".join(f"{int(part):02X}" for part in re.findall(r"\d+", colour)[:3])


def system(tab: Tab, scheme: str) -> None:
    wanted = [{"name": "prefers-color-scheme", "value": scheme}]
    tab.call("Emulation.setEmulatedMedia", features=wanted)
    tab.settle()


def test_every_word_is_legible_by_day_and_by_night(show: Show) -> None:
    tab = show(page(simulate(SAMPLE[:12]), hoopgen.PAPER), at="#time=0.5")
    for scheme in ("light", "dark"):
        system(tab, scheme)
        words = tab.run(WORDS)
        assert len(words) > 40
        faint = [word for word in words if contrast(as_hex(word[1]), as_hex(word[2])) < 4.5]
        assert faint == [], scheme


def night(tab: Tab) -> bool:
    """Whether the picture is dark, and its path in the path's colour then."""
    pixels = tab.pixels()
    ink = lighten(COLOURS["path"])
    parts = [int(ink[k : k + 2], 16) for k in (1, 3, 5)]
    dark = bool(np.median(pixels) < 64)
    assert dark or np.median(pixels) > 192
    assert drawn(pixels) is not dark
    assert bool(np.all(pixels == parts, axis=2).sum() > 200) is dark
    assert pressed(tab, "theme") == str(dark).lower()
    return dark


def test_it_is_as_the_system_is_until_the_reader_says(show: Show) -> None:
    tab = show(page(simulate(STATES["7"]), hoopgen.PAPER), size=PHONE)
    assert not night(tab)
    system(tab, "dark")
    assert night(tab)
    tab.click("#theme")
    assert not night(tab)
    tab.click("#theme")
    system(tab, "light")
    assert night(tab)


def test_paper_is_white(show: Show) -> None:
    tab = show(page(simulate(STATES["7"]), hoopgen.PAPER), size=PHONE)
    tab.click("#theme")
    ink = "getComputedStyle(document.documentElement).getPropertyValue('--paper')"
    tab.run(f"addEventListener('beforeprint', () => (document.body.dataset.printed = {ink}))")
    tab.call("Page.printToPDF")
    assert tab.data["printed"] == COLOURS["paper"]
    assert night(tab)  # again


# What is not simulated


def test_the_net_and_the_lines_are_said_not_to_be_simulated(show: Show) -> None:
    tab = show(page(simulate(STATES["7"]), hoopgen.PAPER), size=PHONE)
    told = " ".join(tab.text("#ghost").split())
    assert told == "Net and court lines: drawn for orientation, not simulated"
    assert tab.run("document.getElementById('ghost').checkVisibility()")
    seen = tab.pixels()
    tab.click("#ghost input")
    bare = tab.pixels()
    assert 0.001 < np.any(seen != bare, axis=2).mean() < 0.1
    tab.click("#theme")
    tab.click("#theme")
    assert (tab.pixels() == bare).all()  # still not there
    tab.click("#ghost input")
    assert (tab.pixels() == seen).all()


def test_a_scene_without_a_hoop_has_no_ghost(show: Show) -> None:
    bowl = hoopgen.compile(hoopgen.load_scene(ROOT / "examples" / "scenes" / "bowl.toml"))
    shots = bowl.simulate([0.1, 0.05, 0, 0, 0, 0, 0, 0, 0], record=True, max_contacts=3)
    text = page(shots, shots.parameters)
    assert data_of(text)["ghost"] is None
    tab = show(text)
    assert tab.run("document.getElementById('ghost').hidden")


@pytest.mark.parametrize("scene", [hoopgen.HOOP, COURT], ids=["hoop", "court"])
def test_lines_and_net_are_where_the_rule_books_have_them(scene: Any) -> None:
    shots = hoopgen.simulate(STATES["7"], scene=scene, record=True)
    ghost = data_of(page(shots, shots.parameters))["ghost"]
    assert ghost["court"] == "NBA"
    lines = np.concatenate(ghost["lines"])
    # To the division line and to the sidelines, 94 ft by 50 ft.
    assert np.ptp(lines[:, :2], axis=0) == pytest.approx([47 * FOOT, 50 * FOOT], abs=1e-3)
    assert (lines[:, 2] == -3.048).all()
    # The free-throw line, 15 ft from the board, and the furthest of the arc.
    lane = np.array(ghost["lines"][2])
    assert lane[:, 0].max() == pytest.approx(4.572 - hoopgen.PAPER["board_distance"], abs=5e-4)
    assert np.array(ghost["lines"][4])[:, 0].max() == pytest.approx(7.239, abs=5e-4)
    for cord in map(np.array, ghost["net"]):
        wide = np.hypot(cord[:, 0], cord[:, 1])
        assert wide[0] == pytest.approx(hoopgen.PAPER["ring_radius"], abs=1e-3)
        assert (np.diff(wide) < 0).all()
        assert cord[0, 2] == pytest.approx(-hoopgen.PAPER["wire_radius"], abs=1e-3)
        assert -0.46 < cord[-1, 2] < -0.40  # a net is 0.40 to 0.45 m long


def test_a_fiba_hoop_stands_on_fiba_s_court() -> None:
    fiba = hoopgen.FIBA | {"gravity": np.array([9.8, 9.81])}
    shots = simulate(SAMPLE[:2], fiba)
    assert data_of(page(shots, fiba))["ghost"]["court"] == "FIBA"
    three = lines_of(COURTS["FIBA"], fiba["board_distance"])["three"]
    # Its straight parts, 0.9 m from the sidelines, meet the arc.
    assert np.hypot(*three[1:-1].T) == pytest.approx(6.75, rel=1e-12)
    assert np.abs(three[[0, 1, -2, -1], 1]) == pytest.approx(7.5 - 0.9, rel=1e-12)


# On any screen


@pytest.mark.parametrize("size", SIZES, ids=["desk", "phone"])
def test_what_plays_has_room(show: Show, size: tuple[int, int]) -> None:
    tab = show(page(simulate(SAMPLE[:3], NBA), NBA), size=size)
    found = tab.run(
        "[...document.querySelectorAll('#player button, #track, #clock, #stop')]"
        ".map((part) => part.getBoundingClientRect())"
    )
    for box in found:
        assert 0 <= box["left"] < box["right"] <= size[0]
    for one, other in itertools.combinations(found, 2):
        apart = [
            one[low] + 1.5 >= other[high] or other[low] + 1.5 >= one[high]  # they share an edge
            for low, high in (("left", "right"), ("top", "bottom"))
        ]
        assert any(apart), (one, other)
