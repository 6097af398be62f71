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

    def _repr_html_(self) -> str:
        return show.notebook.psf(self)
