"""The six methods of the paper that this package started from."""
