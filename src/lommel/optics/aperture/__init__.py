"""Obstructions, the shape of the opening, and the amplitude across it."""
