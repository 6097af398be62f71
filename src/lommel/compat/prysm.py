"""Arrays of prysm: pupils and PSFs as prysm samples them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from lommel.base import optional, validation
from lommel.base.arrays import Array
from lommel.optics.pupil import Pupil
from lommel.psf import PSF


class PupilArrays(NamedTuple):
    """What ``prysm.propagation.Wavefront.from_amp_and_phase`` takes.

    Attributes
    ----------
    amplitude : ndarray, shape (samples, samples)
    phase : ndarray, shape (samples, samples)
        Optical path difference, nanometres.
    wavelength : float
        Micrometres.
    dx : float
        Millimetres between samples.
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
        With a wavelength; a circular or annular aperture.
    samples : int
        Across the diameter, even as prysm has it, sample ``samples // 2`` being on the axis.
    diameter : float
        Of the entrance or exit pupil, metres.

    Returns
    -------
    PupilArrays

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or `pupil` has no wavelength, is a stack, or has parts.
    """
    validation.instance("pupil", pupil, Pupil)
    n = validation.integer("samples", samples, least=2, most=10_000)
    width = validation.real("diameter", diameter, above=0.0)
    if pupil.shape != () or pupil.wavelength is None:
        raise ValueError("pupil must be a single one with a wavelength")
    if not pupil.circular:
        raise ValueError("pupil must have a circular or annular aperture: draw others by prysm.geometry")
    axis = (np.arange(n) - n // 2) * (2.0 / n)
    x, y = np.meshgrid(axis, axis)
    rho, theta = np.hypot(x, y), np.arctan2(y, x)
    inside = (rho <= 1.0) & (rho >= pupil.obscuration)
    # Zernike terms are not evaluated beyond the edge, where the amplitude is 0.
    within = np.minimum(rho, 1.0)
    amplitude = np.where(inside, pupil.illumination.value(within), 0.0)
    phase = np.where(inside, pupil.wavefront.phase(within, theta), 0.0)
    nanometres = phase * (1e9 * pupil.wavelength / (2.0 * np.pi))
    return PupilArrays(amplitude, nanometres, 1e6 * pupil.wavelength, 1e3 * width / n)


def rich_data(psf: PSF) -> Any:
    """Return ``prysm._richdata.RichData`` of a single PSF with pixels in metres: what prysm plots and measures.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    prysm._richdata.RichData
        Micrometres.

    Raises
    ------
    TypeError, ValueError
        If `psf` is a stack, or its pixels are not square or not in metres.
    ImportError
        If prysm is not installed.
    """
    made = optional.library("prysm._richdata", "rich_data needs", "").RichData
    validation.instance("psf", psf, PSF)
    wavelength, pixel = psf.pupil.wavelength, psf.pixel
    if psf.values.ndim != 2 or wavelength is None or isinstance(pixel, tuple):
        raise ValueError("psf must be a single one with square pixels in metres")
    return made(np.array(psf.values, dtype=np.float64), 1e6 * pixel, 1e6 * wavelength)
