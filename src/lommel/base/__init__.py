"""Validation, units, encodings, and safe reading and writing of files."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if not TYPE_CHECKING:
    __getattr__, __dir__ = lazy.parts(__name__)
