"""Estimation from images: Fisher information, Cramér-Rao bounds and phase retrieval."""

from __future__ import annotations

from typing import NamedTuple


class Effort(NamedTuple):
    """Accuracy and extent of a search, which are no options of its function.

    Attributes
    ----------
    integrate : bool or None
        Pixel-integrated (True) or point-sampled (False) images; None for the default of :func:`lommel.psf`:
        integrated for pixels in metres, sampled for pixels in units of lambda*N.
    tol : float
        Tolerance of the PSFs relative to the peak; the default is below the photon noise of 1e10 electrons.
    starts, steps : int
        Maximum numbers of starts, and of steps from each start.
    threads : int or None
        Maximum number of threads; None for the number of processors.
    """

    integrate: bool | None = None
    tol: float = 1e-6
    starts: int = 20
    steps: int = 60
    threads: int | None = None


EFFORT = Effort()
