"""Results of studies: how each is shown on a terminal, in a notebook and as a row of a table."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Unpack

from hoopgen.core.extras import require
from hoopgen.core.plotting import plotting_module
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.results.drawing import EstimateOptions
from hoopgen.simulation.hoop import HOOP
from hoopgen.text.html import Printed

from .named_units import in_units

if TYPE_CHECKING:
    from pandas import DataFrame

    from hoopgen.results.drawing import Drawn


class Result(Printed):
    """A result that is shown as it is printed, and becomes a row of a table."""

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        raise NotImplementedError

    def to_pandas(self) -> DataFrame:
        """Return a pandas.DataFrame of one row: what `as_dict` gives, nested names joined by _.

        Units are in the columns' names.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        pd = require("pandas", "to_pandas")
        scene = getattr(self, "scene", None)
        scene = scene if isinstance(scene, CompiledScene) else HOOP
        frame: DataFrame = pd.json_normalize([in_units(self.as_dict(), scene)], sep="_")
        return frame


class SharesOfShots(Result):
    """A result that is made of shares of shots with their interval, and is drawn as bars."""

    low: Any
    high: Any

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return 0.5 * float(self.high - self.low)

    def plot(self, *, ax: Drawn | None = None, **options: Unpack[EstimateOptions]) -> Drawn:
        """Draw how shots end, with the intervals of the shares.

        Parameters
        ----------
        ax, **options
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
        drawn: Drawn = plotting_module().plot_estimate(self, ax=ax, **options)
        return drawn
