"""From a model to a step program, its C source and the compiled library."""
