"""Long computations: chunks, the executors that compute them, and the store that keeps them."""
