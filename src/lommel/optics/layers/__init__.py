"""Microscope objectives: plane layers, emitters, integrals over angles."""
