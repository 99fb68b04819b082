"""The exported estimator: a folder of C for a firmware, with its self-test and its measured cost."""
