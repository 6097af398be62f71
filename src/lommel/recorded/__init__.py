"""Images as a camera recorded them: files of every kind, known and saturated pixels, noise."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if TYPE_CHECKING:
    from lommel.recorded.frames import *  # noqa: F403
else:
    __getattr__, __dir__ = lazy.parts(__name__, exports="frames")
