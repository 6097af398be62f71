"""Averages over the area of pixels."""
