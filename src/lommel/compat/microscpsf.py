"""The functions of MicroscPSF-Py: the scalar PSF of Gibson and Lanni, with lengths in micrometres."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.compat import psfmodels

# Default microscope of MicroscPSF-Py 0.2. Its magnification "M" and tube length "zd0" do not affect the results here.
m_params = psfmodels.PARAMS | {"M": 100.0, "ns": 1.33, "zd0": 200.0e3}


def gLXYZFocalScan(
    mp: Mapping[str, float],
    dxy: float,
    xy_size: int,
    zv: ArrayLike,
    normalize: bool = True,
    pz: float = 0.0,
    wvl: float = 0.6,
    zd: float | None = None,
) -> Array:
    """Return a stack of images through focus, like ``microscPSF.gLXYZFocalScan``.

    Parameters
    ----------
    mp : mapping
        Microscope parameters, with names and units of ``m_params``. "M" and "zd0" do not affect the result, since the
        sine condition is assumed exactly.
    dxy : float
        Pixel pitch in the sample, micrometres; values are point samples at pixel centres.
    xy_size : int
        Width and height in pixels; the point is in the middle of the array, between pixels if the size is even.
    zv : array_like, shape (planes,)
        Stage positions relative to the design position, micrometres; negative if the cover glass is closer to the
        objective.
    normalize : bool, default True
        Divide by the largest value of the stack, which is searched between pixel centres too.
    pz : float, default 0
        Depth of the point below the cover glass, micrometres.
    wvl : float, default 0.6
        Wavelength, micrometres.
    zd : float, optional
        Distance of the camera, micrometres; only the tube length "zd0" of the microscope is supported.

    Returns
    -------
    ndarray, shape (planes, xy_size, xy_size)
        float64; the error of a value is at most 1e-9 of the largest value.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    References
    ----------
    S. F. Gibson and F. Lanni, J. Opt. Soc. Am. A 9, 154 (1992), doi:10.1364/JOSAA.9.000154.
    """
    return _compute_images(_checked_camera(mp, zd), dxy, xy_size, zv, pz, wvl, normalize)


def gLXYZParticleScan(
    mp: Mapping[str, float],
    dxy: float,
    xy_size: int,
    pz: ArrayLike,
    normalize: bool = True,
    wvl: float = 0.6,
    zd: float | None = None,
    zv: float = 0.0,
) -> Array:
    """Return images of points at depths `pz` for one stage position `zv`, shape (depths, xy_size, xy_size).

    Other parameters are as for :func:`gLXYZFocalScan`.
    """
    return _compute_images(_checked_camera(mp, zd), dxy, xy_size, zv, pz, wvl, normalize)


def gLZRFocalScan(
    mp: Mapping[str, float],
    rv: ArrayLike,
    zv: ArrayLike,
    normalize: bool = True,
    pz: float = 0.0,
    wvl: float = 0.6,
    zd: float | None = None,
) -> Array:
    """Return the radial profile of each plane at radii `rv` (micrometres), shape (planes, radii).

    Other parameters are as for :func:`gLXYZFocalScan`.
    """
    return _compute_profiles(_checked_camera(mp, zd), rv, zv, pz, wvl, normalize)


def gLZRParticleScan(
    mp: Mapping[str, float],
    rv: ArrayLike,
    pz: ArrayLike,
    normalize: bool = True,
    wvl: float = 0.6,
    zd: float | None = None,
    zv: float = 0.0,
) -> Array:
    """Return radial profiles of points at depths `pz`, at radii `rv` (micrometres), shape (depths, radii).

    Other parameters are as for :func:`gLXYZFocalScan`.
    """
    return _compute_profiles(_checked_camera(mp, zd), rv, zv, pz, wvl, normalize)


def _checked_camera(mp: Mapping[str, float], zd: float | None) -> Mapping[str, float]:
    """Return the microscope parameters; ValueError if the camera is not at its design position."""
    tube_length = mp.get("zd0", m_params["zd0"])
    if zd is not None and zd != tube_length:
        raise ValueError(f"zd must be the tube length {tube_length:g} or None, got {zd:g}; move the stage zv instead")
    return mp


def _relevant_params(mp: Mapping[str, float]) -> dict[str, float]:
    """Return the parameters that affect the result, completed by defaults; ValueError for an unknown name."""
    for name in mp:
        validation.choice("mp", name, tuple(m_params))
    return {name: value for name, value in (m_params | dict(mp)).items() if name in psfmodels.PARAMS}


def _stage_positions(params: Mapping[str, float], zv: ArrayLike) -> Array:
    """Return stage positions (metres, positive towards the sample) relative to paraxial focus on the cover glass."""
    ni, ti0 = params["ni"], params["ti0"]
    clearance = ni * (params["tg0"] / params["ng0"] + ti0 / params["ni0"] - params["tg"] / params["ng"])
    return np.asarray(1e-6 * (clearance - ti0 - np.atleast_1d(validation.real_array("zv", zv))))


def _compute_images(
    mp: Mapping[str, float], dxy: float, xy_size: int, zv: ArrayLike, pz: ArrayLike, wvl: float, normalize: bool
) -> Array:
    """Return images of shape (n, xy_size, xy_size), from radial profiles at the distinct radii of the pixels."""
    side = validation.integer("xy_size", xy_size, least=1, most=10_000)
    # Coordinates in half pixels are integers, for even and odd sides.
    half_pixels = 2 * np.arange(side) - (side - 1)
    squares, inverse = np.unique(half_pixels**2 + half_pixels[:, None] ** 2, return_inverse=True)
    pitch = validation.real("dxy", dxy, above=0.0)
    # The second array adds radii at steps of half a pixel, at which the largest value is searched as well.
    radii = np.concatenate([0.5 * pitch * np.sqrt(squares), 0.5 * pitch * np.arange(1.5 * side + 2)])
    profiles = _compute_profiles(mp, radii, zv, pz, wvl, normalize)
    return profiles[:, : squares.size][:, inverse.reshape(side, side)]


def _compute_profiles(
    mp: Mapping[str, float], rv: ArrayLike, zv: ArrayLike, pz: ArrayLike, wvl: float, normalize: bool
) -> Array:
    """Return radial profiles of shape (n, radii), one for each depth or stage position."""
    params = _relevant_params(mp)
    depth = np.atleast_1d(validation.real_array("pz", pz, least=0.0))
    radii = 1e-6 * np.atleast_1d(validation.real_array("rv", rv, least=0.0))
    result = psfmodels.objective(params).scalar(
        radii,
        depth=1e-6 * depth,
        focus=_stage_positions(params, zv),
        wavelength=1e-6 * validation.real("wvl", wvl, above=0.0),
        supercritical=False,
    )
    # MicroscPSF-Py squares an integral over rho drho, which is at most 1/2; the intensity here is at most 1.
    values = 0.25 * result.intensity
    return np.asarray(values / values.max() if validation.truth("normalize", normalize) else values)
