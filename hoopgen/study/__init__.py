"""Studies: from a player's scatter to probabilities, maps and tables. Needs the extra "study"."""
