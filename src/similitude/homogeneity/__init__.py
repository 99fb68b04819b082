"""Whether an expression is homogeneous in its units, found by walking it with exact dimensions."""
