"""The event loop, once for each target: NumPy here, C in generated/c/ behind `native`."""
