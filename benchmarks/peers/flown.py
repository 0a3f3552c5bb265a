"""Results of peers."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Flown:
    """n shots flown: outcome and contacts as hoopgen counts them, time at the end plane or at the
    last contact (s), and the surfaces touched, shape (n, max_contacts), filled up with -1; without
    the record, shape (n, 0)."""

    outcome: NDArray[np.uint8]
    contacts: NDArray[np.int32]
    time: NDArray[np.float64]
    surfaces: NDArray[np.int8]


class Fly(Protocol):
    """Flies states, shape (n, 9), in a scene."""

    def __call__(
        self,
        states: NDArray[np.float64],
        parameters: Mapping[str, float],
        max_contacts: int = 40,
        record: bool = False,
    ) -> Flown: ...


@dataclass(frozen=True)
class Peer:
    """A way to fly shots: a key for files, a label for readers, what it does in one line, and the
    package it flies with, if that may be missing."""

    key: str
    label: str
    what: str
    fly: Fly
    package: str = ""
