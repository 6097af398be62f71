"""The settings of the paper's figures, and the images that they compare."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lommel.measures.errors import mse, peak_error
from lommel.methods import ClosedForm, Fraunhofer, Method, NijboerZernike
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf
from lommel.special.erf import AbramowitzErf, Erf, FresnelErf

VARIANTS = ("printed", "corrected")
REFERENCE = NijboerZernike(tol=1e-9)
"""What every error is taken from; its bound is proven, and `Hankel` agrees with it."""


@dataclass(frozen=True)
class Setting:
    """One PSF of the paper.

    Parameters
    ----------
    shape : int
        Side of the square image in pixels; 512 in the paper.
    window : float
        v at the edge of the image, on the axis, where ``v = pi r / (lambda N) = 2 pi k R_max``. The paper leaves it
        out; at 145 its rings (Fig. 4) lie where they do in the paper, and its first MSE comes out.
    defocus : float
        C_d in radians.
    tangent : float
        Tangent-line centre alpha of Eq. (9), "TLC".
    terms : int or None
        N of Eq. (14); None for the exact error function.
    """

    shape: int = 512
    window: float = 145.0
    defocus: float = 10.0
    tangent: float = 100.0
    terms: int | None = 30

    @property
    def pixel(self) -> float:
        """Pixel pitch in units of lambda*N."""
        return self.window / (math.pi * (self.shape // 2))

    @property
    def v(self) -> NDArray[np.float64]:
        """Optical coordinate along the slice from the centre to the right."""
        return np.arange(self.shape - self.shape // 2, dtype=np.float64) * (self.window / (self.shape // 2))

    @property
    def erf(self) -> Erf:
        """The error function that `terms` stands for."""
        return FresnelErf() if self.terms is None else AbramowitzErf(self.terms)

    def closed_form(self, variant: str) -> ClosedForm:
        """Return the paper's method with these parameters."""
        return ClosedForm(tangent=self.tangent, erf=self.erf, variant=variant)

    def fft(self) -> Fraunhofer:
        """Return the FFT that the paper compares with: one transform as large as the image, without more padding.

        The pupil is sampled with a radius of ``window / pi`` samples, 46 at the window of 145: a transform of n
        samples reaches n/2 pixels of ``2 pi R / n`` in v, R being that radius.
        """
        return Fraunhofer(samples=math.floor(2.0 * self.window / math.pi), padding=1.0)

    def image(self, method: Method) -> NDArray[np.float64]:
        """Return the intensity on the pixels, 1 being the peak of the unaberrated aperture."""
        pupil = Pupil(Wavefront(self.defocus))
        return np.asarray(
            psf(pupil, self.shape, self.pixel, method=method, normalize="strehl", dtype="float64").values
        )

    def images(self) -> dict[str, NDArray[np.float64]]:
        """Return the exact image, the FFT's and those of both variants by their names, over the exact peak."""
        methods = {"exact": REFERENCE, "fft": self.fft()} | {name: self.closed_form(name) for name in VARIANTS}
        images = {name: self.image(method) for name, method in methods.items()}
        peak = images["exact"].max()
        return {name: image / peak for name, image in images.items()}

    def facts(self) -> dict[str, Any]:
        """Return the settings in plain types."""
        return asdict(self)


@dataclass(frozen=True, eq=False)
class FigureData:
    """What a figure shows.

    Attributes
    ----------
    title : str
    arrays : dict of str to ndarray
        All there is, images included.
    columns : dict of str to ndarray
        One-dimensional data of one length, for a spreadsheet.
    facts : dict
        Settings and measures, in plain types.
    """

    title: str
    arrays: dict[str, NDArray[Any]]
    columns: dict[str, NDArray[Any]]
    facts: dict[str, Any] = field(default_factory=dict)


def middle_row(image: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the slice from the centre to the right."""
    return image[image.shape[0] // 2, image.shape[1] // 2 :]


def measures(images: Mapping[str, NDArray[np.float64]]) -> dict[str, dict[str, Any]]:
    """Return MSE and peak error of each of :meth:`Setting.images`, and what the variants are beside the FFT."""
    truth = images["exact"]
    found: dict[str, dict[str, Any]] = {
        name: {"mse": mse(image, truth), "peak_error": peak_error(image, truth)}
        for name, image in images.items()
        if name != "exact"
    }
    for name in VARIANTS:
        found[name]["mse_against_fft"] = mse(images[name], images["fft"])
        found[name]["peak_error_of_slice"] = float(np.abs(middle_row(images[name]) - middle_row(truth)).max())
    return found
