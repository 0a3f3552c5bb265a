"""Engines: the driver of the NumPy target, and of C through `native`."""
