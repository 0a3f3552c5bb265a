"""Release models: the distributions and samples that the shots of a study are drawn from."""
