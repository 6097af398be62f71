"""`make_psf` of psfmodels: scalar and vectorial PSFs of Gibson and Lanni, with lengths in micrometres."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics.layers.emitter import Scalar
from lommel.optics.layers.objective import Objective
from lommel.optics.layers.stratified import Design, Layer
from lommel.psf import psf

# Default parameters of psfmodels 0.3: numerical aperture, refractive indices (ng, ni, ns), and lengths in
# micrometres.
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
    """Return the PSF of a microscope, like ``psfmodels.make_psf``.

    Parameters
    ----------
    z : int or array_like, default 51
        Number of planes, with step `dz` and centred on `pz`, or positions of the planes in micrometres. A position is
        the depth below the cover glass to which the paraxial focus is moved. In the plane at `pz` the point is in
        paraxial focus.
    nx : int, default 51
        Width and height in pixels; the point is in pixel ``(nx - 1) // 2``.
    dxy, dz : float, default 0.05
        Pixel pitch in the sample and step of `z`, micrometres.
    pz : float, default 0
        Depth of the point below the cover glass, micrometres.
    NA, wvl : float
        Numerical aperture and wavelength (micrometres).
    ns, ni, ng, tg : float
        Refractive indices of sample, immersion and cover glass, and thickness of the cover glass (micrometres).
    ni0, ng0, tg0, ti0 : float
        Design values of `ni`, `ng` and `tg`, and design working distance (micrometres).
    oversample_factor : int, default 3
        1 for point samples at pixel centres; any larger number for values that are exactly pixel-integrated.
    normalize : bool, default True
        Divide by the largest value of the stack. Otherwise values are fractions of the collected light; in psfmodels
        they have another unit.
    model : {"vectorial", "scalar"}, default "vectorial"
        Vectorial model of a freely rotating dipole, or scalar model.

    Returns
    -------
    ndarray, shape (planes, nx, nx)
        float64. The error of a value is at most 1e-6 of the largest value in its plane.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    Results of psfmodels differ by the error of psfmodels: up to 1e-2 of the peak from interpolation between radii,
    and up to 6e-3 of the peak from nine samples per pixel (oversample_factor=3).

    References
    ----------
    S. F. Gibson and F. Lanni, J. Opt. Soc. Am. A 9, 154 (1992), doi:10.1364/JOSAA.9.000154.
    F. Aguet et al., Opt. Express 17, 6829 (2009), doi:10.1364/OE.17.006829.
    """
    params = {"NA": NA, "ng0": ng0, "ng": ng, "ni0": ni0, "ni": ni, "ns": ns, "ti0": ti0, "tg": tg, "tg0": tg0}
    samples = validation.integer("oversample_factor", oversample_factor, least=1, most=1000)
    side = validation.integer("nx", nx, least=1, most=10_000)
    depth = validation.real("pz", pz, least=0.0)
    if isinstance(z, int):
        count, step = validation.integer("z", z, least=1, most=100_000), validation.real("dz", dz, above=0.0)
        half_range = 0.5 * (count - 1) * step
        planes = np.linspace(depth - half_range, depth + half_range, count)
    else:
        planes = np.atleast_1d(validation.real_array("z", z))
    is_scalar = validation.choice("model", model, _MODELS) == "scalar"
    # psfmodels: z = 0 is paraxial focus on the cover glass; Objective.pupil: z = 0 is paraxial focus on the point.
    pupil = objective(params).pupil(
        depth=1e-6 * depth,
        z=1e-6 * (planes - depth),
        wavelength=1e-6 * validation.real("wvl", wvl, above=0.0),
        origin="paraxial",
        emitter=Scalar() if is_scalar else "isotropic",
    )
    pitch = 1e-6 * validation.real("dxy", dxy, above=0.0)
    middle = (side - 1) // 2
    values = psf(pupil, side, pitch, integrate=samples > 1, center=(middle, middle), dtype=np.float64).values
    return np.asarray(values / values.max() if validation.truth("normalize", normalize) else values)


def objective(params: Mapping[str, float]) -> Objective:
    """Return the objective that a dictionary of psfmodels describes.

    Parameters
    ----------
    params : mapping
        Any of "NA", "ng0", "ng", "ni0", "ni", "ns", "ti0", "tg" and "tg0"; lengths in micrometres. Missing parameters
        have the defaults of psfmodels.

    Returns
    -------
    Objective
        Objective of magnification 1, so that pixel pitches are lengths in the sample.

    Raises
    ------
    TypeError, ValueError
        If a name is unknown, or if a value is out of range.
    """
    for name in params:
        validation.choice("params", name, tuple(PARAMS))
    p = PARAMS | dict(params)
    coverslip, design_coverslip = (
        Layer(p[index], 1e-6 * p[thickness]) if p[thickness] else None
        for index, thickness in (("ng", "tg"), ("ng0", "tg0"))
    )
    return Objective(
        NA=p["NA"],
        immersion=p["ni"],
        sample=p["ns"],
        working_distance=1e-6 * p["ti0"],
        coverslip=coverslip,
        design=Design(p["ni0"], design_coverslip),
    )
