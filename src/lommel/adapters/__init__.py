"""Pupils and fields of lenses that other packages trace rays through; each is imported when it is asked for."""

from typing import TYPE_CHECKING

from lommel.base import lazy

if TYPE_CHECKING:
    from lommel.adapters import optiland as optiland
    from lommel.adapters import rayoptics as rayoptics
else:
    __getattr__, __dir__ = lazy.parts(__name__)
