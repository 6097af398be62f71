"""Deconvolution on Poisson counts: linear operators by planes, likelihood, steps, stopping rules, and the result."""
