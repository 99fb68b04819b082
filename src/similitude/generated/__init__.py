"""Generated step programs of the shipped estimators: C and scalar twin; see generate.py."""
