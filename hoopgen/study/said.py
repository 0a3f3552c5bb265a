"""Results of studies, as they are said: on a terminal, in a notebook, as a row of a table."""

from __future__ import annotations

import html
from typing import Any

from hoopgen.installed import need

from .named import in_units

__all__ = ["Said"]


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
