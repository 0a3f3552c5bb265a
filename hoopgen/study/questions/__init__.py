"""The questions of a study: estimate, compare, solve, map, optimum, bank, aim, margins, batch."""
