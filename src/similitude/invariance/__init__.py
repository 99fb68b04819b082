"""Sensitivity invariances: one linear relation among logarithmic sensitivities for each dimension."""
