"""Lenses and tables of coefficients, from files that people write."""
