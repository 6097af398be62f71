"""Images as a camera recorded them: files of every kind, known and saturated pixels, noise."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.recorded.frames import *  # noqa: F403
else:
    __getattr__, __dir__ = imports.parts(__name__, exports="frames")
