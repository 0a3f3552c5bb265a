"""Benchmarks: hoopgen beside the other ways to fly the same shots (`python -m benchmarks`)."""
