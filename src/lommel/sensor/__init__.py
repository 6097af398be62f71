"""What a sensor and the air do to an image: seeing, motion, charge that spreads, pixels of any sides."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if not TYPE_CHECKING:
    __getattr__, __dir__ = lazy.parts(__name__)
