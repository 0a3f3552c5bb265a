"""Elementary functions in IEEE operations alone, for what draws a release and aims it.

The functions of a C library or of NumPy differ in their last bits from processor to processor and
from version to version. These have only `+ - * / sqrt`, comparisons and selections, so that a seed
gives the same releases, and the same shots, wherever hoopgen runs.
"""

from __future__ import annotations

from .angles import arc_tangent, hypotenuse, sine_cosine, tangent
from .normal import normal_quantile, normal_quantile_parts

__all__ = ["KERNELS", "PARTS"]

KERNELS = (sine_cosine(), tangent(), arc_tangent(), hypotenuse(), normal_quantile())
"""The elementary functions, each a kernel of no scene."""

PARTS = normal_quantile_parts()
"""Parts of the last one, for targets that compute each for those numbers alone that need it."""
