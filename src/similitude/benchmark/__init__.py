"""The public benchmark: every estimator over the same drives, whose truth is known."""
