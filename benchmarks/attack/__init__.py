"""Attacks on hoopgen for a chosen time: `python -m benchmarks.attack`.

Each attack is a file: it prepares, and then makes one try after the other, each from random numbers
that hang on the seed, the attack and the number of the case alone. POSIX only.
"""
