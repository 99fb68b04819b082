"""What a log is like before anything is estimated from it; `inspection` is the file to begin with."""
