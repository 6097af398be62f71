"""Axial measures of microscope stacks: stage positions and the width along z."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lommel.base.arrays import Array, Numbers, numbers
from lommel.measures.continuous_image import ImageModel, cartesian_images
from lommel.measures.psf_like import PSFLike, checked
from lommel.measures.spot import brightest_place
from lommel.optics.layers.objective_pupil import ObjectivePupil


def stage(psf: PSFLike) -> Array:
    """Return the stage positions z of a stack of planes, increasing along its last axis, metres.

    Parameters
    ----------
    psf : PSF
        Of an :class:`lommel.Objective`, a stack over z.

    Returns
    -------
    ndarray, shape ``pupil.shape``

    Raises
    ------
    ValueError
        If `psf` is of a lens, a single plane, of several depths along that axis, or not in order of z.
    """
    pupil: Any = checked(psf).pupil
    if not isinstance(pupil, ObjectivePupil):
        raise ValueError("z is what an Objective's stage does; this is the PSF of a lens")
    if not pupil.shape or pupil.shape[-1] < 2:
        raise ValueError(f"z must be that of a stack of planes, got one of shape {pupil.shape}")
    if np.ptp(pupil.depth, axis=-1).any():
        raise ValueError("z must be all that planes along the last axis of the stack differ in, got several depths")
    if not (np.diff(pupil.focus, axis=-1) > 0.0).all() or not (np.diff(pupil.z, axis=-1) > 0.0).all():
        raise ValueError("z must rise along the last axis of the stack")
    return pupil.z


def axial_fwhm(psf: PSFLike, *, of: str = "image") -> Numbers:
    """Return the full width at half maximum along z.

    Parameters
    ----------
    psf : PSF
        A stack over z along its last axis, of at least 4 planes.
    of : {"image", "optics"}, default "image"
        "image": with the pixel, if values are pixel-integrated; "optics": without it.

    Returns
    -------
    float or ndarray, shape ``pupil.shape[:-1]``
        Metres of the stage: on the axis for radially symmetric PSFs, else at the brightest pixel of the stack. By
        cubic splines through the planes, to about 1 % for steps of at most half of ``axial`` of
        :meth:`lommel.Objective.nyquist`.

    Raises
    ------
    ValueError
        If `psf` is not such a stack, `of` is unknown, or the values do not fall to half of the maximum on both sides.
    """
    from scipy.interpolate import CubicSpline

    model, z = ImageModel.of(psf, of), stage(psf)
    if z.shape[-1] < 4:
        raise ValueError(f"the width along z takes at least 4 planes, got {z.shape[-1]}")
    lines = _lines(psf, model).reshape(-1, z.shape[-1])
    out = []
    for places, line in zip(z.reshape(lines.shape), lines, strict=True):
        spline = CubicSpline(places, line)
        turns = spline.derivative().roots(extrapolate=False)
        tops = np.append(turns[np.isfinite(turns)], places[line.argmax()])
        top = float(tops[np.argmax(spline(tops))])
        crossings = spline.solve(0.5 * float(spline(top)), extrapolate=False)
        below, above = crossings[crossings < top], crossings[crossings > top]
        if not (below.size and above.size):
            raise ValueError("the values do not fall to half of the largest on both sides within the stack")
        out.append(float(above.min() - below.max()))
    return numbers(out, z.shape[:-1])


def _lines(psf: PSFLike, model: ImageModel) -> Array:
    """Return the light along z, of the shape of the stack."""
    pupil = psf.pupil
    if model.radial_method is not None:
        found = model.radial_method.profile(pupil, np.zeros(1)).values
        return np.asarray(psf.scale * found.reshape(pupil.shape))
    planes = pupil.shape[-1]
    brightest = psf.values.reshape(-1, planes, math.prod(psf.grid.shape)).max(axis=2).argmax(axis=1)
    lines = []
    for k, stack in enumerate(np.ndindex(pupil.shape[:-1])):
        here = model._replace(pupil=pupil[stack]) if stack else model
        place = (0.0, 0.0)
        if psf.radial_method is None:
            place = brightest_place(here._replace(pupil=here.pupil[brightest[k]]))
        images = cartesian_images(here, float(np.abs(place).max()))
        lines.append([float(image.derivatives(*place)[0, 0]) for image in images])
    # A sheet of light, among others, is in what values are multiplied by.
    return np.asarray(psf.scale * np.array(lines).reshape(pupil.shape))
