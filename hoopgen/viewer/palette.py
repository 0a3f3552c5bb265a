"""The page's colours in its light and its dark style, as CSS variables."""

from __future__ import annotations

from collections.abc import Mapping

from hoopgen.core.colours import COLOURS

DARK_PAPER = "#15191D"
"""The paper of a dark page."""

_MIN_CONTRAST = 4.5
"""The least contrast of words with what is behind them, WCAG 2.2, 1.4.3."""


def palette(own: Mapping[str, str]) -> str:
    """Return the CSS variables of the light and the dark style: pictures' colours and others.

    By night each is lightened until it stands out from the paper as it does by day; hues stay.
    """
    day = {**COLOURS, **own}
    night = {name: lighten(colour) for name, colour in day.items()} | {"paper": DARK_PAPER}
    return f":root {_rule(day)}:root[data-theme=dark] {_rule(night)}"


def _rule(colours: Mapping[str, str]) -> str:
    names = "".join(f"  --{name}: {colour};\n" for name, colour in colours.items())
    return f"{{\n{names}}}\n"


def lighten(colour: str) -> str:
    """Return a colour, "#RRGGBB", lightened until it is legible on a dark page.

    It is legible, and stands out at least as it does by day: so what differs by day, differs.
    """
    wanted = max(_MIN_CONTRAST, contrast(colour, COLOURS["paper"]))
    parts = _parts(colour)
    mixes = (
        "#" + "".join(f"{round(part + share * (255 - part) / 100):02X}" for part in parts)
        for share in range(101)
    )
    return next((mix for mix in mixes if contrast(mix, DARK_PAPER) >= wanted), "#FFFFFF")


def contrast(one: str, other: str) -> float:
    """Return the contrast of two colours, 1 to 21, as WCAG 2.2 defines it.

    Parameters
    ----------
    one, other
        Colours, "#RRGGBB".
    """
    dark, light = sorted((_luminance(one), _luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def _luminance(colour: str) -> float:
    shares = [part / 255 for part in _parts(colour)]
    linear = [s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def _parts(colour: str) -> list[int]:
    return list(bytes.fromhex(colour.removeprefix("#")))
