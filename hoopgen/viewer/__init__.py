"""An interactive page of shots in space: one HTML file that needs nothing else.

Drawn with three.js (MIT), which lies beside in ``three/`` and goes into every page.
"""

from hoopgen.viewer.page import page
from hoopgen.viewer.shown import Page
from hoopgen.viewer.viewing import view

__all__ = ["Page", "page", "view"]
