"""Special functions, each with its published source."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if not TYPE_CHECKING:
    __getattr__, __dir__ = lazy.parts(__name__)
