"""Estimation from images: Fisher information, Cramér-Rao bounds and phase retrieval."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar, TypedDict

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation


class FitKeywords(TypedDict, total=False):
    """Options of every fit."""

    mask: ArrayLike | None
    saturation: float | None
    threads: int | None
    progress: Callable[[float, float], object] | None


class StarKeywords(FitKeywords, total=False):
    """Options of fits to images of stars."""

    integrate: bool | None
    tol: float
    seed: int | np.random.Generator


class RetrievalKeywords(StarKeywords, total=False):
    """Options of phase retrieval."""

    starts: int
    steps: int


@dataclass(frozen=True)
class FitOptions:
    """Options of a fit, validated as far as they do not depend on the images.

    Parameters
    ----------
    mask : array_like of bool, optional
        True for pixels to be left out; of the shape of all images, of one stack or of one image.
    saturation : float, optional
        Pixels of this value or more, in the unit of the images, are left out.
    integrate : bool, optional
        Pixel-integrated (True) or point-sampled (False) images. The default is that of :func:`lommel.psf`: integrated
        for pixels in metres, sampled for pixels in units of lambda*N.
    tol : float, default 1e-6
        Tolerance of the PSFs relative to the peak; the default is below the photon noise of 1e10 electrons.
    starts : int, default 20
        Maximum number of starts: `pupil`, then random restarts 1.5 radians rms from it until a fit is accepted.
    steps : int, default 60
        Maximum number of steps from each start.
    seed : int or Generator, default 0
        Seed or generator of random starts.
    threads : int, optional
        Maximum number of threads; by default the number of processors.
    progress : callable, optional
        Called as ``progress(fraction, chi2)`` before each step; `fraction` is the part done of the longest possible
        search. An exception raised by this function stops the search.
    """

    mask: ArrayLike | None = None
    saturation: float | None = None
    integrate: bool | None = None
    tol: float = 1e-6
    starts: int = 20
    steps: int = 60
    seed: int | np.random.Generator = 0
    threads: int | None = None
    progress: Callable[[float, float], object] | None = None

    max_starts: ClassVar[int] = 10_000

    def __post_init__(self) -> None:
        validation.function("progress", self.progress, required=False)
        limits = {"starts": self.max_starts, "steps": 10_000} | ({} if self.threads is None else {"threads": 1024})
        # Frozen: the attributes are set past __setattr__.
        vars(self).update({n: validation.integer(n, getattr(self, n), least=1, most=m) for n, m in limits.items()})
