"""Validation, units, encodings, and safe reading and writing of files."""

from typing import TYPE_CHECKING

from lommel.base import imports

if not TYPE_CHECKING:
    __getattr__, __dir__ = imports.parts(__name__)
