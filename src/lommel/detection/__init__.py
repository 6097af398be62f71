"""Detection of molecules, stars, beads, pinholes and crossings of a checkerboard in recorded images."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.detection.targets import *  # noqa: F403
else:
    __getattr__, __dir__ = imports.parts(__name__, exports="targets")
