"""The kernels of a scene, gathered from the mathematics: of the scene, its laws, its surfaces."""
