"""The backends that compute a batch, NumPy, C and CUDA, and checks that their bits are the same."""
