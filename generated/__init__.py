"""What runs: the committed output of `hoopgen generate`."""
