"""Special functions, each with its published source."""
