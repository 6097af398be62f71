"""The functions of MicroscPSF-Py: the scalar PSF of Gibson and Lanni, in micrometres."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.compat import psfmodels

# Of MicroscPSF-Py 0.2: magnification and tube length change nothing here.
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
    """Return a stack through focus, as ``microscPSF.gLXYZFocalScan`` does.

    Parameters
    ----------
    mp : mapping
        Microscope, as ``m_params`` of this module. "M" and "zd0" change nothing: the sine condition holds exactly.
    dxy : float
        Pixel in the sample, micrometres; values are samples at the centres of pixels.
    xy_size : int
        Width and height, with the point in the middle of the array, between pixels where it is even.
    zv : array_like, shape (planes,)
        Distance of the stage from its design position, micrometres; negative where the cover glass is nearer to the
        objective.
    normalize : bool, default True
        Divide by the largest value that the stack has at any distance from the axis.
    pz : float, default 0
        Depth of the point below the cover glass, micrometres.
    wvl : float, default 0.6
        Micrometres.
    zd : float, optional
        Distance of the camera, micrometres: that of the microscope, "zd0".

    Returns
    -------
    ndarray, shape (planes, xy_size, xy_size)
        float64, within 1e-9 of the largest value.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    References
    ----------
    S. F. Gibson and F. Lanni, J. Opt. Soc. Am. A 9, 154 (1992), doi:10.1364/JOSAA.9.000154.
    """
    return _window(_at_rest(mp, zd), dxy, xy_size, zv, pz, wvl, normalize)


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
    """Return a stack of points at depths `pz`, (depths, xy_size, xy_size), the stage at rest at `zv`.

    Otherwise as :func:`gLXYZFocalScan`.
    """
    return _window(_at_rest(mp, zd), dxy, xy_size, zv, pz, wvl, normalize)


def gLZRFocalScan(
    mp: Mapping[str, float],
    rv: ArrayLike,
    zv: ArrayLike,
    normalize: bool = True,
    pz: float = 0.0,
    wvl: float = 0.6,
    zd: float | None = None,
) -> Array:
    """Return the radial profile at radii `rv`, micrometres, of each plane, (planes, radii).

    Otherwise as :func:`gLXYZFocalScan`.
    """
    return _profile(_at_rest(mp, zd), rv, zv, pz, wvl, normalize)


def gLZRParticleScan(
    mp: Mapping[str, float],
    rv: ArrayLike,
    pz: ArrayLike,
    normalize: bool = True,
    wvl: float = 0.6,
    zd: float | None = None,
    zv: float = 0.0,
) -> Array:
    """Return the radial profile at radii `rv`, micrometres, of points at depths `pz`, (depths, radii).

    Otherwise as :func:`gLXYZFocalScan`.
    """
    return _profile(_at_rest(mp, zd), rv, zv, pz, wvl, normalize)


def _at_rest(mp: Mapping[str, float], zd: float | None) -> Mapping[str, float]:
    """Return the microscope; ValueError if the camera is not at its design position."""
    designed = mp.get("zd0", m_params["zd0"])
    if zd is not None and zd != designed:
        raise ValueError(f"zd must be the tube length {designed:g} or None, got {zd:g}: move the stage, zv, instead")
    return mp


def _params(mp: Mapping[str, float]) -> dict[str, float]:
    """Return the parameters that matter here; ValueError for an unknown name."""
    for name in mp:
        validation.choice("mp", name, tuple(m_params))
    return {name: value for name, value in (m_params | dict(mp)).items() if name in psfmodels.PARAMS}


def _focus(of: Mapping[str, float], zv: ArrayLike) -> Array:
    """Return the stage in metres from paraxial focus on the cover glass, towards the sample."""
    clearance = of["ni"] * (of["tg0"] / of["ng0"] + of["ti0"] / of["ni0"] - of["tg"] / of["ng"])
    return np.asarray(1e-6 * (clearance - of["ti0"] - np.atleast_1d(validation.real_array("zv", zv))))


def _window(
    mp: Mapping[str, float], dxy: float, xy_size: int, zv: ArrayLike, pz: ArrayLike, wvl: float, normalize: bool
) -> Array:
    side = validation.integer("xy_size", xy_size, least=1, most=10_000)
    # Twice the distances: whole numbers, also for windows of even sides.
    along = 2 * np.arange(side) - (side - 1)
    squares, place = np.unique(along**2 + along[:, None] ** 2, return_inverse=True)
    pitch = validation.real("dxy", dxy, above=0.0)
    # Beside those of pixels the radii that the largest value is looked for at.
    radii = np.concatenate([0.5 * pitch * np.sqrt(squares), 0.5 * pitch * np.arange(1.5 * side + 2)])
    made = _profile(mp, radii, zv, pz, wvl, normalize)
    return made[:, : squares.size][:, place.reshape(side, side)]


def _profile(
    mp: Mapping[str, float], rv: ArrayLike, zv: ArrayLike, pz: ArrayLike, wvl: float, normalize: bool
) -> Array:
    of = _params(mp)
    depth = np.atleast_1d(validation.real_array("pz", pz, least=0.0))
    radii = 1e-6 * np.atleast_1d(validation.real_array("rv", rv, least=0.0))
    found = psfmodels.objective(of).scalar(
        radii,
        depth=1e-6 * depth,
        focus=_focus(of, zv),
        wavelength=1e-6 * validation.real("wvl", wvl, above=0.0),
        supercritical=False,
    )
    # Theirs is the square of an integral over rho drho, whose largest value is 1/2.
    values = 0.25 * found.intensity
    return np.asarray(values / values.max() if validation.truth("normalize", normalize) else values)
