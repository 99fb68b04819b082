"""A whole model looked over at once: what `similitude analyze` prints."""
