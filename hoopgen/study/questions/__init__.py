"""The questions of a study, from `estimate` and `map` to `coach` and `counterfactual`."""
