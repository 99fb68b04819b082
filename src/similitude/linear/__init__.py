"""Linear models: matrices, transfer functions, and the way to and from python-control."""
