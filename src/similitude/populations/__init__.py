"""Populations of similar systems: tables, their distribution in log groups, relations and priors."""
