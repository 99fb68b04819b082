"""Estimators as step programs, each derived from a Model, its groups and its reduction."""
