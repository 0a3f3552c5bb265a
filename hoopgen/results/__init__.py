"""Results of a simulation: `Shots`, `Trajectory`, and tables of them."""
