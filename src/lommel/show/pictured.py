"""What a PSF can be drawn as: its methods, each of which imports what draws it when it is called."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from lommel import show
from lommel.base import validation
from lommel.measures.answer import Answer

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Pictured(Answer):
    """An answer that draws itself."""

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Any:
        """Draw the values on matplotlib axes and return these, an array of them for a stack; sections of a z stack.

        See :func:`lommel.show.plot.plot`.
        """
        validation.axes("ax", ax)
        return show.plot.plot(self, ax, stretch=stretch)

    def plot_mtf(self, ax: Axes | None = None) -> Any:
        """Draw the modulation transfer function along x and y, beside that of the aperture without aberration.

        See :func:`lommel.show.curves.mtf`.
        """
        return show.curves.mtf(self, ax)

    def plot_encircled_energy(self, ax: Axes | None = None, *, radius: float | None = None) -> Any:
        """Draw the light within circles up to a `radius`; see :func:`lommel.show.curves.encircled_energy`."""
        return show.curves.encircled_energy(self, ax, radius=radius)

    def plot_spots(self, ax: Axes | None = None, *, rings: int = 12, stretch: str = "sqrt") -> Any:
        """Draw where rays meet the sensor over the values; see :func:`lommel.show.rays.spots`."""
        return show.rays.spots(self, ax, rings=rings, stretch=stretch)

    def _repr_html_(self) -> str:
        return show.notebook.psf(self)
