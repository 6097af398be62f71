"""Blur besides diffraction: seeing, jitter, motion, charge diffusion, and the shape of pixels."""

from typing import TYPE_CHECKING

from lommel.base import imports

if not TYPE_CHECKING:
    __getattr__, __dir__ = imports.parts(__name__)
