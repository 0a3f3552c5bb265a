"""Engines: `simulate`, `HOOP`, `COURT`, scenes by name, compiled scenes, the article's shots."""
