"""Dimensional analysis proper: dimension matrices, Pi groups and the choice of a base, exactly."""
