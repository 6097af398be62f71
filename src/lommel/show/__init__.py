"""Plots by matplotlib, and tables for notebooks."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.show import curves as curves
    from lommel.show import estimates as estimates
    from lommel.show import notebook as notebook
    from lommel.show import plot as plot
    from lommel.show.names import difference as difference
    from lommel.show.names import encircled_energy as encircled_energy
    from lommel.show.names import focus_curves as focus_curves
    from lommel.show.names import mtf as mtf
    from lommel.show.names import spots as spots
    from lommel.show.names import through_focus as through_focus
else:
    __getattr__, __dir__ = imports.parts(__name__, "names")
