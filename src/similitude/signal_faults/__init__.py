"""Faults that a signal's own shape gives away: overflow, a dead band, and a time in minutes."""
