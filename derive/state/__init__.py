"""The fields of a shot, the results made of them, and kernels that isomorphic surfaces share."""
