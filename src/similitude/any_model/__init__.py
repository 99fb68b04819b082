"""Estimators made to measure for any model: fewest unknowns, choice of estimator, its numbers, its run."""
