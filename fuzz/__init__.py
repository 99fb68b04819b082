"""Coverage-guided fuzzing of everything that reads from outside; `make fuzz` runs it."""
