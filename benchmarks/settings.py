"""How thorough a run is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Settings:
    """Handed to every section.

    Attributes
    ----------
    quick : bool
        Fewer cases, sizes and rounds.
    tick : callable
        Told what is being measured now.
    """

    quick: bool
    tick: Callable[[str], None]

    @property
    def rounds(self) -> int:
        """Turns of each contender."""
        return 5 if self.quick else 15
