"""The PSF class of pyotf: PSF of a microscope objective in a homogeneous medium."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import fft

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.layers.emitter import Dipole, Scalar
from lommel.optics.layers.objective import Objective
from lommel.psf import psf

_DIPOLES = {"x": Dipole(0.5 * np.pi, 0.0), "y": Dipole(0.5 * np.pi, 0.5 * np.pi), "z": Dipole(0.0, 0.0)}


class HanserPSF:
    """PSF of an objective in a homogeneous medium, like ``pyotf.otf.HanserPSF``; all lengths are in the unit of `wl`.

    Parameters
    ----------
    wl : float
        Wavelength.
    na, ni : float
        Numerical aperture and refractive index.
    res : float
        Pixel pitch in the sample.
    size : int
        Width and height in pixels; the point is in pixel ``size // 2``.
    zres : float, optional
        Step between planes; by default `res`.
    zsize : int, optional
        Number of planes; the point is in plane ``(zsize + 1) // 2``. By default `size`.
    vec_corr : {"none", "x", "y", "z", "total"}, default "none"
        "none": scalar model. "x", "y", "z": dipole along this axis. "total": freely rotating dipole.
    condition : {"sine", "none"}, default "sine"
        Amplitude over the pupil: "sine" for the sine condition, "none" for a uniform amplitude (scalar model only).
    zrange : array_like, shape (planes,), optional
        Positions of the planes, which replace `zres` and `zsize`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Values are point samples at pixel centres. Unlike values from a discrete Fourier transform, they have no aliased
    periodic images and no errors from a pupil sampled on a grid.
    """

    def __init__(
        self,
        wl: float,
        na: float,
        ni: float,
        res: float,
        size: int,
        zres: float | None = None,
        zsize: int | None = None,
        vec_corr: str = "none",
        condition: str = "sine",
        *,
        zrange: ArrayLike | None = None,
    ) -> None:
        self.wl = validation.real("wl", wl, above=0.0)
        self.na, self.ni = validation.real("na", na, above=0.0), validation.real("ni", ni, above=0.0)
        self.res = validation.real("res", res, above=0.0)
        self.size = validation.integer("size", size, least=1, most=10_000)
        self.vec_corr = validation.choice("vec_corr", vec_corr, ("none", *_DIPOLES, "total"))
        self.condition = validation.choice("condition", condition, ("sine", "none"))
        if self.condition == "none" and self.vec_corr != "none":
            raise ValueError(
                'condition must be "sine" for the vectorial model, got "none"; use vec_corr="none" with it'
            )
        if zrange is None:
            planes = validation.integer("zsize", size if zsize is None else zsize, least=1, most=100_000)
            step = validation.real("zres", res if zres is None else zres, above=0.0)
            zrange = (np.arange(planes) - (planes + 1) // 2) * step
        self.zrange = np.atleast_1d(validation.real_array("zrange", zrange))

    @cached_property
    def PSFi(self) -> Array:
        """Intensity, (planes, size, size), float64: fraction of light per pixel; error at most 1e-6 of the peak."""
        scalar = Scalar("aplanatic" if self.condition == "sine" else "uniform")
        emitters: dict[str, str | Dipole | Scalar] = {"none": scalar, "total": "isotropic", **_DIPOLES}
        pupil = Objective(NA=self.na, immersion=self.ni).pupil(
            depth=0.0,
            z=1e-9 * self.zrange,
            wavelength=1e-9 * self.wl,
            origin="paraxial",
            emitter=emitters[self.vec_corr],
        )
        return np.asarray(psf(pupil, self.size, 1e-9 * self.res, integrate=False, dtype=np.float64).values)

    @cached_property
    def OTFi(self) -> NDArray[np.complex128]:
        """Discrete Fourier transform of `PSFi`, zero frequency in the middle; omits light outside the window."""
        return np.asarray(fft.fftshift(fft.fftn(fft.ifftshift(self.PSFi))))
