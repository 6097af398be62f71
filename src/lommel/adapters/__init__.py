"""Conversion of lenses of ray tracing packages, and of PSFs for DeepInverse; the packages are imported on use."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.adapters import batoid as batoid
    from lommel.adapters import deepinv as deepinv
    from lommel.adapters import optiland as optiland
    from lommel.adapters import rayoptics as rayoptics
else:
    __getattr__, __dir__ = imports.parts(__name__)
