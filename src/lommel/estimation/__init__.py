"""Estimation from images: Fisher information, Cramér-Rao bounds and phase retrieval."""
