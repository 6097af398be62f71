"""Derivatives of images."""
