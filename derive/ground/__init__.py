"""What everything stands on: symbols, kernels, choices, polynomials in time, rounding errors."""
