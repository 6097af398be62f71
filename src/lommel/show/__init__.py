"""Plots by matplotlib, and tables for notebooks."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.show import curves as curves
    from lommel.show import estimates as estimates
    from lommel.show import notebook as notebook
    from lommel.show.plot import *  # noqa: F403
else:
    __getattr__, __dir__ = imports.parts(__name__, exports="plot")
