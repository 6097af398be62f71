"""Special functions, quadrature and interpolation."""

from typing import TYPE_CHECKING

from lommel.base import imports

if not TYPE_CHECKING:
    __getattr__, __dir__ = imports.parts(__name__)
