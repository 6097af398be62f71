"""Pixel integration: averages over the area of pixels."""
