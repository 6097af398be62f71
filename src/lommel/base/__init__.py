"""Validation, units, encodings, and files read and written with care."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if not TYPE_CHECKING:
    __getattr__, __dir__ = lazy.parts(__name__)
