"""The intermediate representation: kernels, and the event loop as a tree of nodes."""
