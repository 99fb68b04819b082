"""A Model rewritten without dimensions: as a Model again, with the way there and back and its proof."""
