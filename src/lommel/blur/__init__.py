"""Blur besides diffraction: seeing, jitter, motion, charge diffusion, and the shape of pixels."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if not TYPE_CHECKING:
    __getattr__, __dir__ = lazy.parts(__name__)
