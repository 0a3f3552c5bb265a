"""Presets of the hoop: those of the article and of the rule books."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from hoopgen.core.argument_types import check_mapping
from hoopgen.core.parameters import Parameters, Table
from hoopgen.generated.numpy import hoop

NAMES = tuple(hoop.PARAMETERS)
"""Names of the parameters of the article's hoop."""

HOOP_TABLE = Table.from_kernels(hoop)


def _preset(
    ball_radius: float,
    ring_radius: float,
    wire_radius: float,
    board_distance: float,
    board: tuple[float, float],
) -> Parameters[float]:
    """Return a preset; the board's lower edge is 0.15 m below the ring's top edge."""
    width, height = board
    bottom = wire_radius - 0.15
    return PAPER | {
        "ball_radius": ball_radius,
        "ring_radius": ring_radius,
        "wire_radius": wire_radius,
        "board_distance": board_distance,
        "board_half_width": width / 2,
        "board_bottom": bottom,
        "board_top": bottom + height,
        "end_depth": 0.2 * ball_radius,
    }


PAPER = Parameters(HOOP_TABLE.defaults)
"""The article's sizes: within the tolerances of the rule books. They give every sequence of
contacts in the article's Table 3."""

NBA = _preset(
    0.1213,  # 30 in round
    0.2286 + 0.0079375,  # 18 in across inside, 5/8 in wire
    0.0079375,
    0.2286 + 0.1524,  # 9 in + 6 in
    (1.8288, 1.0668),
)
"""NBA rule book."""

FIBA = _preset(
    0.1213,
    0.2270 + 0.0090,  # 450-459 mm across inside, 16-20 mm wire
    0.0090,
    0.2270 + 0.151,
    (1.80, 1.05),
)
"""FIBA equipment rules; each size is the middle of its tolerance."""

PRESETS: Mapping[str, Parameters[float]] = MappingProxyType(
    {"paper": PAPER, "nba": NBA, "fiba": FIBA}
)
"""Presets of the hoop by the names that they have on the command line and in files."""


def nearest_preset(
    parameters: Mapping[str, Any], presets: Mapping[str, Mapping[str, Any]] = PRESETS
) -> tuple[str, dict[str, Any]]:
    """Return the preset that differs in the fewest parameters, and those that differ from it.

    Parameters
    ----------
    parameters
        Parameters of the scene, one number each or (n,). Those left out are not compared.
    presets
        The presets to choose from, by name.

    Returns
    -------
    tuple
        A key of `presets`, the first one of several; and the names and values that differ.
    """
    check_mapping("parameters", parameters)

    def apart(preset: Mapping[str, Any]) -> dict[str, Any]:
        return {
            name: value
            for name, value in parameters.items()
            if name in preset and not np.all(np.asarray(value) == preset[name])
        }

    differences = {name: apart(preset) for name, preset in presets.items()}
    nearest = min(differences, key=lambda name: len(differences[name]))
    return nearest, differences[nearest]
