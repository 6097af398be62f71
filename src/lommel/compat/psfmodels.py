"""The functions of psfmodels: microscope PSFs of Gibson and Lanni, scalar and vectorial, in micrometres."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.layers.emitter import Scalar
from lommel.optics.layers.objective import Objective
from lommel.optics.layers.stratified import Design, Layer
from lommel.psf import psf

# Of psfmodels 0.3: micrometres, NA and indices.
PARAMS = {
    "NA": 1.4,
    "ng0": 1.515,
    "ng": 1.515,
    "ni0": 1.515,
    "ni": 1.515,
    "ns": 1.47,
    "ti0": 150.0,
    "tg": 170.0,
    "tg0": 170.0,
}
_MODELS = ("vectorial", "scalar")


def make_psf(
    z: int | ArrayLike = 51,
    nx: int = 51,
    *,
    dxy: float = 0.05,
    dz: float = 0.05,
    pz: float = 0.0,
    NA: float = 1.4,
    wvl: float = 0.6,
    ns: float = 1.47,
    ni: float = 1.515,
    ni0: float = 1.515,
    tg: float = 170.0,
    tg0: float = 170.0,
    ng: float = 1.515,
    ng0: float = 1.515,
    ti0: float = 150.0,
    oversample_factor: int = 3,
    normalize: bool = True,
    model: str = "vectorial",
) -> Array:
    """Return the PSF of a microscope, as ``psfmodels.make_psf`` does.

    Parameters
    ----------
    z : int or array_like, default 51
        Number of planes, `dz` apart around `pz`, or their positions: the paraxial focus of a point at the cover glass
        moved by so many micrometres into the sample. The plane at `pz` has the paraxial focus of the point.
    nx : int, default 51
        Width and height, with the point in pixel ``(nx - 1) // 2``.
    dxy, dz : float, default 0.05
        Pixel in the sample and step of `z`, micrometres.
    pz : float, default 0
        Depth of the point below the cover glass, micrometres.
    NA, wvl, ns, ni, ni0, tg, tg0, ng, ng0, ti0 : float
        Numerical aperture, wavelength, refractive indices of sample, immersion and cover glass, its thickness, the
        working distance, micrometres; with 0 as designed.
    oversample_factor : int, default 3
        1 for values at the centres of pixels. From 2 on pixel-integrated: the limit of many samples a pixel.
    normalize : bool, default True
        Divide by the largest value of the stack. Otherwise values are fractions of the light collected; those of
        psfmodels have another unit.
    model : {"vectorial", "scalar"}, default "vectorial"
        A freely rotating dipole, or the scalar model.

    Returns
    -------
    ndarray, shape (planes, nx, nx)
        float64. The error of each value is at most 1e-6 of the largest in its plane.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    What differs from psfmodels is its error: up to 1e-2 of the peak between the radii that it interpolates, and 6e-3
    by nine samples a pixel.

    References
    ----------
    S. F. Gibson and F. Lanni, J. Opt. Soc. Am. A 9, 154 (1992), doi:10.1364/JOSAA.9.000154.
    F. Aguet et al., Opt. Express 17, 6829 (2009), doi:10.1364/OE.17.006829.
    """
    planes = _centered(z, dz, pz) if isinstance(z, int) else z
    params = {"NA": NA, "ng0": ng0, "ng": ng, "ni0": ni0, "ni": ni, "ns": ns, "ti0": ti0, "tg": tg, "tg0": tg0}
    return _stack(planes, nx, dxy, pz, wvl, params | {"sf": oversample_factor}, normalize, model)


def vectorial_psf(
    zv: ArrayLike = 0.0,
    nx: int = 31,
    dxy: float = 0.05,
    pz: float = 0.0,
    wvl: float = 0.6,
    params: Mapping[str, float] | None = None,
    normalize: bool = True,
) -> Array:
    """Return the vectorial PSF at planes `zv`; :func:`make_psf` has the arguments, the others being `params`."""
    return _stack(zv, nx, dxy, pz, wvl, params, normalize, "vectorial")


def scalar_psf(
    zv: ArrayLike = 0.0,
    nx: int = 31,
    dxy: float = 0.05,
    pz: float = 0.0,
    wvl: float = 0.6,
    params: Mapping[str, float] | None = None,
    normalize: bool = True,
) -> Array:
    """Return the scalar PSF at planes `zv`; :func:`make_psf` has the arguments, the others being `params`."""
    return _stack(zv, nx, dxy, pz, wvl, params, normalize, "scalar")


def vectorial_psf_centered(nz: int, dz: float = 0.05, pz: float = 0.0, **options: Any) -> Array:
    """Return the vectorial PSF at `nz` planes, `dz` micrometres apart, around `pz`; see :func:`vectorial_psf`."""
    return vectorial_psf(_centered(nz, dz, pz), pz=pz, **options)


def scalar_psf_centered(nz: int, dz: float = 0.05, pz: float = 0.0, **options: Any) -> Array:
    """Return the scalar PSF at `nz` planes, `dz` micrometres apart, around `pz`; see :func:`scalar_psf`."""
    return scalar_psf(_centered(nz, dz, pz), pz=pz, **options)


def objective(params: Mapping[str, float]) -> Objective:
    """Return the objective that a dictionary of psfmodels describes.

    Parameters
    ----------
    params : mapping
        Any of "NA", "ng0", "ng", "ni0", "ni", "ns", "ti0", "tg" and "tg0"; lengths in micrometres. What is missing is
        as of psfmodels.

    Returns
    -------
    Objective
        Of magnification 1: pixels are those in the sample.

    Raises
    ------
    TypeError, ValueError
        If a name is unknown or a value out of range.
    """
    for name in params:
        validation.choice("params", name, tuple(PARAMS))
    of = PARAMS | dict(params)
    glasses = [
        Layer(of[index], 1e-6 * of[thickness]) if of[thickness] else None
        for index, thickness in (("ng", "tg"), ("ng0", "tg0"))
    ]
    return Objective(
        NA=of["NA"],
        immersion=of["ni"],
        sample=of["ns"],
        working_distance=1e-6 * of["ti0"],
        coverslip=glasses[0],
        design=Design(of["ni0"], glasses[1]),
    )


def _centered(count: int, step: float, middle: float) -> Array:
    half = 0.5 * (validation.integer("z", count, least=1, most=100_000) - 1) * validation.real("dz", step, above=0.0)
    return np.linspace(middle - half, middle + half, count)


def _stack(
    zv: ArrayLike,
    nx: int,
    dxy: float,
    pz: float,
    wvl: float,
    params: Mapping[str, float] | None,
    normalize: bool,
    model: str,
) -> Array:
    given = dict(params or {})
    samples = validation.integer("oversample_factor", given.pop("sf", 3), least=1, most=1000)
    if given.pop("mode", 1) != 1:
        raise ValueError("mode must be 1: oversampled PSFs are those of a smaller dxy with sf=1, got another")
    side = validation.integer("nx", nx, least=1, most=10_000)
    depth = validation.real("pz", pz, least=0.0)
    planes = np.atleast_1d(validation.real_array("zv", zv))
    scalar = validation.choice("model", model, _MODELS) == "scalar"
    # z counts from the paraxial focus of the point, theirs from that of a point at the cover glass.
    pupil = objective(given).pupil(
        depth=1e-6 * depth,
        z=1e-6 * (planes - depth),
        wavelength=1e-6 * validation.real("wvl", wvl, above=0.0),
        origin="paraxial",
        emitter=Scalar() if scalar else "isotropic",
    )
    pitch = 1e-6 * validation.real("dxy", dxy, above=0.0)
    middle = (side - 1) // 2
    made = psf(pupil, side, pitch, integrate=samples > 1, center=(middle, middle), dtype=np.float64).values
    return np.asarray(made / made.max() if validation.truth("normalize", normalize) else made)
