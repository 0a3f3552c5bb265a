"""The literature's free throw, and a shooter who makes about 70% of them."""

from hoopgen.core.units import DEGREE, FOOT, TURN

LINE = {"distance": 13.75 * FOOT, "height": 7 * FOOT, "backspin": 3 * TURN}
"""The place of the release, and the spin."""

RELEASE = {"speed": 7.17, "elevation": 52 * DEGREE}
"""The release at which the scatter is centred."""

SEVENTY = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": 1.0 * DEGREE}
"""The scatter of a shooter who makes about 70% of free throws."""
