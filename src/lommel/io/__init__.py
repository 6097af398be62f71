"""Files: PSFs, PSF grids, photographs, depth maps, frames and video, in registered formats."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.io.videos import *  # noqa: F403
else:
    __getattr__, __dir__ = imports.parts(__name__, exports="videos")
