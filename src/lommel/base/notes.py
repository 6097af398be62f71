"""Notes on input that is allowed but unlikely to be meant, as warnings that name the line of the caller."""

from __future__ import annotations

import sys
import warnings


def tell(note: str) -> None:
    """Give a UserWarning at the line outside of this package that led here."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("lommel."):
        level, frame = level + 1, frame.f_back
    warnings.warn(note, stacklevel=level)
