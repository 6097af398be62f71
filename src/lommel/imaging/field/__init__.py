"""Blur that varies over the field."""
