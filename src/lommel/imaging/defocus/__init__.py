"""Depth from photographs of different focus."""
