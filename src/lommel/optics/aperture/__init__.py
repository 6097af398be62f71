"""Apertures: shapes, masks, amplitude, and quadrature over the clear part."""
