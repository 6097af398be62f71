"""Estimation from images: scoring, score tests, goodness of fit, and the findings that make a verdict."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if TYPE_CHECKING:
    from lommel.fit.findings import *  # noqa: F403
else:
    __getattr__, __dir__ = lazy.parts(__name__, exports="findings")
