"""Detection of molecules, stars, beads, pinholes and crossings of a checkerboard in recorded images."""

from typing import TYPE_CHECKING

from lommel.base import imports

if not TYPE_CHECKING:
    __getattr__, __dir__ = imports.parts(__name__)
