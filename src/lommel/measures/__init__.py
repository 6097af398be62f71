"""Measures of wavefronts and of PSFs: energy, widths, transfer functions, errors."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.measures import energy as energy
    from lommel.measures import spot as spot
    from lommel.measures import transfer as transfer
else:
    __getattr__, __dir__ = imports.parts(__name__)
