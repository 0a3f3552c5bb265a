"""The error in a scene, which says where in the scene it is."""

from __future__ import annotations

from hoopgen.text.shorten import brief, join_names


class SceneError(ValueError):
    """An error in a scene; it names the scene, the body and the argument."""


def wrong(scene: str, owner: str, argument: str, said: object) -> SceneError:
    """Return the error about an argument of a scene.

    Parameters
    ----------
    scene
        The scene's name, empty if it has none yet.
    owner, argument, said
        As for `Inputs.wrong`.
    """
    where = ": ".join(filter(None, (scene and f"scene {brief(scene)}", owner, argument)))
    return SceneError(f"{where}: {said}" if where else str(said))


def unknown(names: list[str], there: tuple[str, ...]) -> str:
    """Describe which names are unknown, and which are known.

    Parameters
    ----------
    names
        The unknown names.
    there
        The known names.
    """
    return f"unknown {join_names(names)}. The names are {join_names(there)}"
