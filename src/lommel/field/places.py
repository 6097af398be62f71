"""PSFs at places that see apertures of their own, as one stack."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from lommel.base.arrays import Array
from lommel.optics.field_pupil import FieldPupil
from lommel.optics.pupil import Pupil
from lommel.psf import PSF


def stacked(pupils: list[Pupil], shape: tuple[int, ...], compute: Callable[[Pupil], PSF]) -> PSF:
    """Return the PSFs of single pupils as a stack of a shape.

    Parameters
    ----------
    pupils : list of Pupil
    shape : tuple of int
    compute : callable
        From a pupil to its PSF, without derivatives.

    Returns
    -------
    PSF
        Of the method of the place that is narrowed most; its bound is the largest, None where one has none.
    """
    found = [compute(pupil) for pupil in pupils]
    first = found[0]
    if any(one.derivatives for one in found):
        raise ValueError("derivatives are those of one aperture: ask place by place where vignetting changes it")
    bounds = [one.error_bound for one in found]
    narrow = next((one for one in found if not one.pupil.circular), first)
    return replace(
        narrow,
        values=np.stack([one.values for one in found]).reshape(shape + first.values.shape),
        pupil=FieldPupil(tuple(pupils), shape),
        error_bound=None if None in bounds else max(bound for bound in bounds if bound is not None),
        scale=np.reshape([float(one.scale) for one in found], shape),
    )


def weighted(psf: PSF, light: Array) -> PSF:
    """Return a stack whose values are multiplied by the light of each place, and its scale with them."""
    factor = np.asarray(light)[..., None, None].astype(psf.values.dtype)
    slopes = {name: slope * factor for name, slope in psf.derivatives.items()}
    assert math.prod(light.shape) == math.prod(psf.pupil.shape)
    return replace(psf, values=psf.values * factor, scale=psf.scale * light, derivatives=slopes)
