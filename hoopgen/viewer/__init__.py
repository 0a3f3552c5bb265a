"""An interactive page of shots in space: one HTML file that needs nothing else.

Drawn with three.js (MIT), which lies beside in ``three/`` and goes into every page.
"""

from .page import page
from .page_file import Page
from .view_shots import view

__all__ = ["Page", "page", "view"]
