"""Reproduction of the figures and numbers of the paper that this package started from."""
