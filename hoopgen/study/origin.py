"""What a file of results says of its shots: the scene that they were flown in, and all shared.

It lies in the metadata of the Arrow schema, under "hoopgen", of Parquet and Arrow files. In CSV the
scene is columns, one of each parameter, as where it differs from row to row.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

from hoopgen.hoop.presets import NAMES, PAPER, nearest_preset
from hoopgen.hoop.variables import VARIABLES, change_variables
from hoopgen.inputs import MAX_CONTACTS, check_contacts
from hoopgen.installed import version
from hoopgen.told import say_scene
from hoopgen.variables import check_names

from .columns import NAMED, variable_of
from .tables import Source
from .tallies import check_scene

__all__ = ["Origin", "names_scene", "origin_of", "settle"]

_KEY = b"hoopgen"


@dataclass(frozen=True)
class Origin:
    """What all shots of a table share; SI.

    Attributes
    ----------
    parameters
        Of the scene, where no column says otherwise.
    release
        Variables of the release, in place of columns.
    max_contacts
        Contacts after which a shot ends as capped.
    own
        Columns that are not read, though they are named like variables.
    """

    parameters: Mapping[str, float]
    release: Mapping[str, float]
    max_contacts: int
    own: tuple[str, ...] = ()

    @property
    def scene(self) -> str:
        """In words: the preset, and what differs from it."""
        return say_scene(self.parameters)

    def metadata(self, scene: str) -> dict[bytes, bytes]:
        """Return what a schema says of it, with the scene in words."""
        preset, _ = nearest_preset(self.parameters)
        said = {"version": version(), "preset": preset, "scene": scene, NAMED: True}
        return {_KEY: json.dumps({**said, **asdict(self)}).encode()}


def origin_of(table: Source) -> Origin | None:
    """Return what a file of results says of its shots; None if it says nothing.

    Raises
    ------
    ValueError
        If it cannot be understood, or the file is not of its format.
    OSError
        If it cannot be read.
    """
    schema = table.schema()
    text = (schema.metadata or {}).get(_KEY)
    if text is None:
        return None
    try:
        said = json.loads(text)
        release = {name: float(value) for name, value in said["release"].items()}
        check_names("release", release, VARIABLES)
        return Origin(
            check_scene(said["parameters"]),
            release,
            check_contacts(said["max_contacts"]),
            tuple(name for name in said.get("own", ()) if name in schema.names),
        )
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise ValueError(
            f"{table}: its metadata hoopgen, which says the scene of the shots, cannot be "
            f"understood ({error}); remove it from the file, and name the scene"
        ) from None


def names_scene(table: Source, own: Iterable[str] = ()) -> bool:
    """Return whether a file says its scene: all of it in columns, or in its metadata."""
    left = set(own)
    said = {variable_of(name)[0] for name in table.schema().names if name not in left}
    return said.issuperset(NAMES) or origin_of(table) is not None


def settle(
    table: Source,
    parameters: Mapping[str, Any] | None = None,
    release: Mapping[str, float] | None = None,
    max_contacts: int | None = None,
    own: Iterable[str] = (),
    *,
    override: bool = False,
) -> Origin:
    """Return how the shots of a table are flown: as it says, and where it says nothing as asked.

    Parameters
    ----------
    parameters, max_contacts
        Asked for; None for what the file says, and `PAPER` and 40 where it says nothing.
    release, own
        Asked for besides what the file says.
    override
        Whether what is asked for may contradict the file.

    Raises
    ------
    ValueError
        If it does, and may not; or what the file says cannot be understood.
    """
    asked, own = dict(release or {}), tuple(own)
    said = origin_of(table)
    if said is None:
        scene = dict(PAPER if parameters is None else parameters)
        contacts = MAX_CONTACTS if max_contacts is None else max_contacts
        return Origin(scene, asked, check_contacts(contacts), own)
    wanted = Origin(
        said.parameters if parameters is None else dict(parameters),
        change_variables(said.release, asked),
        said.max_contacts if max_contacts is None else check_contacts(max_contacts),
        (*said.own, *(name for name in own if name not in said.own)),
    )
    if not override and replace(wanted, own=said.own) != said:
        raise ValueError(
            f"{table}: its shots were flown otherwise than is asked now: "
            f"{'; '.join(_differences(said, wanted))}. Leave that out, or override what the file "
            "says (override=True, --override)"
        )
    return wanted


def _differences(said: Origin, wanted: Origin) -> list[str]:
    found = []
    if wanted.parameters != said.parameters:
        found.append(f"in the scene {said.scene}, not {wanted.scene}")
    for name, value in wanted.release.items():
        if said.release.get(name) != value:
            there = said.release.get(name, "that of each row")
            found.append(f"with the {name} {there}, not {value}")
    if wanted.max_contacts != said.max_contacts:
        found.append(f"to {said.max_contacts} contacts, not {wanted.max_contacts}")
    return found
