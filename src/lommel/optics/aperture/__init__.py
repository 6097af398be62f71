"""Apertures: shapes, masks, amplitude, those of telescopes, and quadrature over the clear part."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if not TYPE_CHECKING:
    __getattr__, __dir__ = lazy.parts(__name__)
