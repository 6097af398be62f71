"""Pupils and PSFs as arrays in the sampling and units of prysm."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from lommel.base import optional, validation
from lommel.base.arrays import Array
from lommel.optics.pupil import Pupil
from lommel.psf import PSF


class PupilArrays(NamedTuple):
    """Arguments of ``prysm.propagation.Wavefront.from_amp_and_phase``.

    Attributes
    ----------
    amplitude : ndarray, shape (samples, samples)
        Amplitude of the pupil.
    phase : ndarray, shape (samples, samples)
        Optical path difference, nanometres.
    wavelength : float
        Wavelength, micrometres.
    dx : float
        Distance between samples, millimetres.
    """

    amplitude: Array
    phase: Array
    wavelength: float
    dx: float


def pupil_arrays(pupil: Pupil, samples: int, *, diameter: float) -> PupilArrays:
    """Return the amplitude and the optical path difference of a single pupil on the grid of prysm.

    Parameters
    ----------
    pupil : Pupil
        Pupil with a wavelength and a circular or annular aperture.
    samples : int
        Number of samples across the diameter, usually even in prysm; sample ``samples // 2`` is on the axis.
    diameter : float
        Diameter of the entrance or exit pupil, metres.

    Returns
    -------
    PupilArrays

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if `pupil` is a stack, has no wavelength, or has an aperture that is
        neither circular nor annular.
    """
    validation.instance("pupil", pupil, Pupil)
    n = validation.integer("samples", samples, least=2, most=10_000)
    width = validation.real("diameter", diameter, above=0.0)
    if pupil.shape != () or pupil.wavelength is None:
        raise ValueError("pupil must be a single pupil with a wavelength; index a stack, or pass wavelength to Pupil")
    if not pupil.circular:
        raise ValueError("pupil must have a circular or annular aperture; draw other apertures by prysm.geometry")
    axis = (np.arange(n) - n // 2) * (2.0 / n)
    x, y = np.meshgrid(axis, axis)
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    is_clear = (rho <= 1.0) & (rho >= pupil.obscuration)
    # Outside the pupil, where the amplitude is 0, use the edge, since Zernike terms are defined for rho <= 1.
    clipped = np.minimum(rho, 1.0)
    amplitude = np.where(is_clear, pupil.illumination.value(clipped), 0.0)
    phase = np.where(is_clear, pupil.wavefront.phase(clipped, theta), 0.0)
    opd = phase * (1e9 * pupil.wavelength / (2.0 * np.pi))
    return PupilArrays(amplitude, opd, 1e6 * pupil.wavelength, 1e3 * width / n)


def rich_data(psf: PSF) -> Any:
    """Return a PSF as ``prysm._richdata.RichData``, which prysm can plot and measure.

    Parameters
    ----------
    psf : PSF
        A single PSF with square pixels in metres.

    Returns
    -------
    prysm._richdata.RichData
        Data with lengths in micrometres.

    Raises
    ------
    TypeError, ValueError
        If `psf` is a stack, or its pixels are not square or not in metres.
    ImportError
        If prysm is not installed.
    """
    rich_data_class = optional.library("prysm._richdata", "rich_data needs", "").RichData
    validation.instance("psf", psf, PSF)
    wavelength, pixel = psf.pupil.wavelength, psf.pixel
    if psf.values.ndim != 2 or wavelength is None or isinstance(pixel, tuple):
        raise ValueError("psf must be a single PSF with square pixels in metres; index a stack to select one")
    return rich_data_class(np.array(psf.values, dtype=np.float64), 1e6 * pixel, 1e6 * wavelength)
