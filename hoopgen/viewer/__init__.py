"""An interactive page of shots in space: one HTML file that needs nothing else.

Drawn with three.js (MIT), which lies beside in ``three/`` and goes into every page.
"""

from hoopgen.viewer.page import page, view
from hoopgen.viewer.shown import Page

__all__ = ["Page", "page", "view"]
