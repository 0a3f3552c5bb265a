"""Studies in one file: read, answered question by question, and kept in a folder."""

from .run import check_study, run_study

__all__ = ["check_study", "run_study"]
