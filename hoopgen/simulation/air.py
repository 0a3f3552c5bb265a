"""The article's hoop in air, `AIR`, which is derived and compiled when it is first asked for."""

from .derived_hoop import derived_hoop

AIR = derived_hoop("AIR")
"""The article's hoop, and a ball that flies through air: drag, buoyancy and the Magnus force of its
spin. It is kept as a scene of one's own is: compiled once in half a minute, then found."""
