"""Scalings that leave a model's equations true: found, counted, used to reduce, checked."""
