"""Statistics of shots: tallies, confidence intervals, distributions."""
