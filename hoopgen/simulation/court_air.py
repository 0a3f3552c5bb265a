"""The hoop of a gym in air, `COURT_AIR`, which is derived and compiled at its first use."""

from .derived_hoop import derived_hoop

COURT_AIR = derived_hoop("COURT_AIR")
"""The hoop as it stands in a gym, and a ball that flies through air. Rolls take no force of the air
along the surface: `Shots.airless_rolls` marks their shots. It is compiled once, then found."""
