"""PSFs as profiles of GalSim."""

from __future__ import annotations

from typing import Any

import numpy as np

from lommel.base import optional, validation
from lommel.psf import PSF

_ARCSEC = 180.0 * 3600.0 / np.pi


def interpolated_image(psf: PSF, *, focal_length: float, **options: Any) -> Any:
    """Return a single PSF as ``galsim.InterpolatedImage``; its flux is the sum of the values.

    Parameters
    ----------
    psf : PSF
        PSF with an odd number of square pixels in metres along x and y. If it is point-sampled (``integrate=False``),
        GalSim averages it over the pixels of an image. If it is pixel-integrated, draw with ``method="no_pixel"`` and
        pixels of the same size.
    focal_length : float
        Focal length of the telescope, metres; a pixel is ``pixel / focal_length`` radians on the sky.
    options
        Options of ``galsim.InterpolatedImage``, such as `x_interpolant`.

    Returns
    -------
    galsim.InterpolatedImage
        Profile in arcseconds; x along columns, y along rows.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if `psf` is a stack, has an even size, or has pixels that are not square or
        not in metres.
    ImportError
        If GalSim is not installed.
    """
    package = optional.library("galsim", "interpolated_image needs", "")
    validation.instance("psf", psf, PSF)
    length = validation.real("focal_length", focal_length, above=0.0)
    if psf.values.ndim != 2 or psf.values.shape[0] % 2 == 0 or psf.values.shape[1] % 2 == 0:
        raise ValueError(f"psf must be a single PSF with odd sides, got shape {psf.values.shape}")
    if psf.unit != "m":
        raise ValueError("psf must have pixels in metres; define its pupil with a wavelength and an f-number")
    steps = {*np.atleast_1d(np.asarray(psf.pixel, dtype=float)).tolist()}
    if len(steps) > 1:
        raise ValueError(f"psf must have square pixels, got {psf.pixel}")
    image = package.Image(np.array(psf.values, dtype=np.float64), scale=steps.pop() / length * _ARCSEC)
    return package.InterpolatedImage(image, **{"flux": float(image.array.sum()), **options})
