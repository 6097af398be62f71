"""Methods of evaluating the diffraction integral, one module each."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.methods.registry import *  # noqa: F403
else:
    # The registry imports all methods; most programs use one or two.
    __getattr__, __dir__ = imports.parts(__name__, exports="registry")
