"""The methods of `Shots` that hand its results to other libraries: pandas, Arrow, xarray."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING

from . import frames

if TYPE_CHECKING:
    from pandas import DataFrame
    from pyarrow import Table as ArrowTable
    from xarray import Dataset


class Exports(ABC):
    """Results of a batch that other libraries read."""

    @abstractmethod
    def to_numpy(self) -> frames.Shots:
        """Return the results as NumPy arrays."""

    def to_pandas(self) -> DataFrame:
        """Return the results as a pandas.DataFrame, a row a shot, units in the columns' names.

        Fields with several numbers a shot are as many columns: ``ring_contacts``, ..., ``x``, ...

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        return frames.shots_frame(self.to_numpy())

    def to_arrow(self) -> ArrowTable:
        """Return the results as a pyarrow.Table, which Polars and DuckDB take too.

        Its columns are those of `to_pandas`, after the shot. Arrays of one number a shot are not
        copied.

        Raises
        ------
        ImportError
            If pyarrow is missing: what brings it.
        """
        return frames.shots_table(self.to_numpy())

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """Return `to_arrow` as a stream of Arrow's C interface, which libraries of tables read.

        Parameters
        ----------
        requested_schema
            The types that the reader prefers, a capsule; None for those that there are.

        Raises
        ------
        ImportError
            If pyarrow is missing: what brings it.
        """
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def events_to_pandas(self) -> DataFrame:
        """Return the event log as a pandas.DataFrame, a row each event, units in columns' names.

        Its index is the shot, from 0, and the event's number among those of the shot, from 1; the
        columns are those of `Trajectory.to_pandas`. The shots are simulated with ``record=True``.

        Raises
        ------
        AttributeError
            If they were not.
        ImportError
            If pandas is missing: what brings it.
        """
        return frames.events_frame(self.to_numpy())

    def events_to_arrow(self) -> ArrowTable:
        """Return the event log as a pyarrow.Table, which Polars takes too; as `events_to_pandas`.

        Shot and event are columns.

        Raises
        ------
        AttributeError
            If the shots were not simulated with ``record=True``.
        ImportError
            If pyarrow is missing: what brings it.
        """
        return frames.events_table(self.to_numpy())

    def to_xarray(self) -> Dataset:
        """Return the results as an xarray.Dataset over ``shot``, with what the codes mean.

        Parameters of the scene are coordinates where they differ from shot to shot, else in its
        ``attrs``. With ``derivatives=`` it has ``state_derivative`` and ``time_derivative`` over
        ``variable``, whose units are in ``variable_unit``; with ``record=True``, too, the
        derivatives of `event_jacobian` over ``event``.

        Raises
        ------
        ImportError
            If xarray is missing: what brings it.
        """
        return frames.shots_dataset(self.to_numpy())

    def _repr_html_(self) -> str:
        return frames.shots_html(self.to_numpy())
