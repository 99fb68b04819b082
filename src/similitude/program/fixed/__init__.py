"""A step program in integers: every variable in the format that its range asks for."""
