"""Pupils and field maps of lenses in ray tracing packages, which are imported on first use."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if TYPE_CHECKING:
    from lommel.adapters import optiland as optiland
    from lommel.adapters import rayoptics as rayoptics
else:
    __getattr__, __dir__ = lazy.parts(__name__)
