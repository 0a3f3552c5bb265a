"""The notation of a scene's symbols: parameters by their LaTeX, or by a letter of their own."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.symbolic.letters import AXES
from hoopgen.derive.symbolic.notation import ARGUMENTS, latex_name, text
from hoopgen.derive.symbolic.symbols import CHANGE, ParameterSymbol

QUANTITIES = {
    "radius": "R",
    "wire": "R",
    "depth": "d",
    "thickness": "d",
    "height": "h",
    "width": "b",
    "length": "l",
    "distance": "a",
    "speed": "v",
    "restitution": "e",
    "friction": r"\mu",
    "tangential": "e",
    "at": "a",
}
"""Letters of parameters, by a word of their names."""

ENDS = {
    **{f"centre_{axis}": axis for axis in AXES},
    **{f"from_{axis}": rf"\underline{{{axis}}}" for axis in AXES},
    **{f"to_{axis}": rf"\overline{{{axis}}}" for axis in AXES},
    "span_from": r"\underline{l}",
    "span_to": r"\overline{l}",
    "restitution_speed": "v",
}
"""Letters of parameters, by the ends of their names."""


def _subscripted(letter: str, words: list[str]) -> str:
    return rf"{letter}_{{\mathrm{{" + r"\,".join(words) + "}}" if words else letter


def _parameter_letter(name: str, usual: str = "") -> str:
    r"""Return a letter for a parameter without LaTeX, with other words as a subscript."""
    for end, letter in ENDS.items():
        if name.endswith(f"_{end}"):
            return _subscripted(letter, name.removesuffix(f"_{end}").split("_"))
    words = [word for word in name.split("_") if word]
    for word in (words[-1], words[0]):
        if word in QUANTITIES:
            return _subscripted(QUANTITIES[word], [w for w in words if w != word])
    return _subscripted(usual or "a", words)


def _roles(scene: Scene) -> dict[str, str]:
    """Return the letter for the use of a parameter in the scene, by the parameter's name."""
    roles: dict[str, str] = {}
    for law in scene.laws:
        for attribute, letter in CONSTANTS.items():
            size = getattr(law, attribute, None)
            if isinstance(size, ParameterSymbol):
                roles.setdefault(size.name, letter)
    return roles


CONSTANTS = {"restitution": "e", "friction": r"\mu", "tangential": "e", "falling": "v"}
"""Letters of the constants of laws, by attribute."""


def parameter_letters(scene: Scene) -> dict[str, str]:
    """Return the LaTeX of each parameter of a scene: its own, else a letter that is free."""
    ours = {letter.latex for letter in ARGUMENTS.values()}
    given = {p.name: p.latex for p in scene.parameters if p.latex and p.latex not in ours}
    found, taken, roles = dict(given), set(given.values()), _roles(scene)
    own = {
        size.name: letter
        for size, letter in (
            (scene.ball_radius, "R_B"),
            (scene.gravity, "g"),
            (scene.inertia, r"\kappa"),
        )
        if isinstance(size, ParameterSymbol)
    }
    for p in scene.parameters:
        if p.name in found:
            continue
        usual = roles.get(p.name, "c" if p.unit == "1" else "a")
        whole = _subscripted(usual, p.name.split("_"))
        choices = [_parameter_letter(p.name, usual), whole]
        if p.name in own:
            choices.insert(0, own[p.name])
        letter = next((c for c in choices if c not in taken), rf"{{{whole}}}'")
        found[p.name] = letter
        taken.add(letter)
    return found


class SceneNotation:
    """The LaTeX of the symbols of a scene.

    Parameters
    ----------
    scene
        The scene; None: parameters are written as words.
    """

    def __init__(self, scene: Scene | None = None) -> None:
        self._parameters: Mapping[str, str] = {} if scene is None else parameter_letters(scene)

    def __call__(self, symbol: sp.Symbol) -> str:
        """Return the LaTeX of a symbol."""
        name = str(symbol.name)
        if isinstance(symbol, ParameterSymbol):
            return self._parameters.get(name) or text(name)
        parameter = name.removeprefix(CHANGE)
        if parameter != name and parameter in self._parameters:
            return rf"\delta_{{{self._parameters[parameter]}}}"
        return latex_name(name)
