"""Results of studies, as they are said: on a terminal, in a notebook, as a row of a table."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

from hoopgen.installed import need
from hoopgen.results import pictures

from .named import in_units

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Said", "SharesOfShots"]


class Said:
    """A result that is shown and represented as it is printed, and becomes a row of a table."""

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        raise NotImplementedError

    def to_pandas(self) -> Any:
        """Return a pandas.DataFrame of one row: what `as_dict` gives, nested names joined by _.

        Units are in the columns' names.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        return need("pandas", "to_pandas").json_normalize([in_units(self.as_dict())], sep="_")

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>"


class SharesOfShots(Said):
    """A result that is made of shares of shots, and is drawn as bars."""

    def plot(self, **options: Any) -> Figure | Axes:
        """Draw how shots end, with the intervals of the shares.

        Parameters
        ----------
        **options
            As for `hoopgen.plots.plot_estimate`.

        Returns
        -------
        Figure or Axes
            As of `hoopgen.plots.plot_estimate`.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        """
        drawn: Figure | Axes = pictures().plot_estimate(self, **options)
        return drawn
