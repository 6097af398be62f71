"""The settings of the paper's figures and their images."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lommel.measures.errors import mse, peak_error
from lommel.methods import ClosedForm, Fraunhofer, Method, NijboerZernike
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf
from lommel.special.erf import AbramowitzErf, FresnelErf

Arrays: TypeAlias = dict[str, NDArray[Any]]
Facts: TypeAlias = dict[str, Any]

VARIANTS = ("printed", "corrected")
# The reference of every error, with a proven bound; `Hankel` agrees with it.
REFERENCE = NijboerZernike(tol=1e-9)


@dataclass(frozen=True)
class Setting:
    """One PSF of the paper."""

    shape: int = 512  # side of the image, pixels
    # v = pi r / (lambda N) at the edge of the image. The paper does not state it; at 145 the rings of Fig. 4 lie
    # where they do in the paper, and its first MSE comes out.
    window: float = 145.0
    defocus: float = 10.0  # C_d, radians
    tangent: float = 100.0  # tangent-line centre alpha of Eq. (9), "TLC"
    terms: int | None = 30  # N of Eq. (14); None for the exact error function

    @property
    def pixel(self) -> float:
        """Pixel pitch in units of lambda*N."""
        return self.window / (math.pi * (self.shape // 2))

    @property
    def v(self) -> NDArray[np.float64]:
        """Optical coordinate along the slice from the centre to the right."""
        return np.arange(self.shape - self.shape // 2, dtype=np.float64) * (self.window / (self.shape // 2))

    def closed_form(self, variant: str) -> ClosedForm:
        """Return the paper's method with these parameters."""
        erf = FresnelErf() if self.terms is None else AbramowitzErf(self.terms)
        return ClosedForm(tangent=self.tangent, erf=erf, variant=variant)

    def fft(self) -> Fraunhofer:
        """Return the FFT that the paper compares with: one transform as large as the image, without more padding."""
        # The pupil has a radius R of window / pi samples: n samples reach n/2 pixels of 2 pi R / n in v.
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

    def facts(self) -> Facts:
        """Return the settings in plain types."""
        return asdict(self)


@dataclass(frozen=True, eq=False)
class FigureData:
    """The data of a figure."""

    title: str
    arrays: Arrays  # all data, images included
    columns: Arrays  # one-dimensional data of one length, for a spreadsheet
    facts: Facts = field(default_factory=dict)  # settings and errors, in plain types


def middle_row(image: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the slice from the centre to the right."""
    return image[image.shape[0] // 2, image.shape[1] // 2 :]


def measures(images: Mapping[str, NDArray[np.float64]]) -> dict[str, Facts]:
    """Return MSE and peak error of each of :meth:`Setting.images`, and of the variants against the FFT."""
    truth = images["exact"]
    found: dict[str, Facts] = {
        name: {"mse": mse(image, truth), "peak_error": peak_error(image, truth)}
        for name, image in images.items()
        if name != "exact"
    }
    for name in VARIANTS:
        found[name]["mse_against_fft"] = mse(images[name], images["fft"])
        found[name]["peak_error_of_slice"] = float(np.abs(middle_row(images[name]) - middle_row(truth)).max())
    return found
