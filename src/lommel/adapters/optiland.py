"""Pupils and fields of lenses in optiland (https://github.com/HarrisonKramer/optiland).

Conversions:

- ``Wavefront.data.opd`` is in waves, and positive if the path of a ray is *shorter* than that of the chief ray; the
  phase is ``-2 pi opd``. optiland's FFT PSF has the same sign.
- Pupil points are fractions (Px, Py) of the entrance pupil. optiland's y points upwards and is mirrored; see
  :mod:`lommel.adapters.ray_tracing`. Positions are intersections of chief rays with the image surface, in metres.
- Wavelengths are in micrometres in optiland, in metres here.
- The amplitude is assumed uniform: optiland's absorption and coatings are ignored.

optiland is optional; it is imported only when a function of this module is called.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np

from lommel.adapters import ray_tracing
from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.optional import library
from lommel.field.maps import FieldMap
from lommel.optics.pupil import Pupil


def pupil(
    optic: object,
    field: tuple[float, float] = (0.0, 0.0),
    *,
    wavelength: float | None = None,
    band: tuple[float, float] | None = None,
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> Pupil:
    """Return the pupil of a lens at one point of its field.

    Parameters
    ----------
    optic : optiland.optic.Optic
        Lens.
    field : (float, float)
        Hx and Hy, fractions of the largest field.
    wavelength : float, optional
        Wavelength, metres; by default the primary wavelength of the lens.
    band : (float, float), optional
        Shortest and longest wavelength, metres, of :func:`lommel.colour_psf` and
        :class:`lommel.methods.Polychromatic` with this pupil. The lens is traced at 3 to 33 wavelengths, as many as
        `tol` requires: PSFs include axial and lateral colour, about the chief ray at `wavelength`, and
        spherochromatism. By default the pupil is known at `wavelength` only.
    circular : bool, default False
        True for a circle with the geometric mean f-number, as in optiland's FFT PSF. False for the pupil seen from
        the image, which is an ellipse off the axis. For six lenses, PSFs of ellipses differ by up to 1.5 % of the
        peak from Huygens' sum over the traced rays, PSFs of circles by up to 32 % (:doc:`/optiland-checked`). Phase
        retrieval and gradients in JAX or PyTorch support circles only.
    degree : int, default 12
        Highest degree of the Zernike terms, 2 to 20.
    tol : float, default 0.01
        Largest accepted rms residual of the fit to the traced phase, radians.

    Returns
    -------
    Pupil
        Pupil with the f-number at this point. An elliptical pupil has the f-number of its major axis, and the ellipse
        as `vignetting`.

    Raises
    ------
    ImportError
        If optiland is not installed.
    TypeError, ValueError
        If an argument is out of range, if rays are blocked, if the field has vignetting factors, or if the residual
        of the fit of this `degree` exceeds `tol`.
    """
    _, metres = _tracer(optic, wavelength)
    return ray_tracing.single_pupil(
        lambda wave: _tracer(optic, wave)[0], field, metres, degree, tol, circular=circular, band=band
    )


def field_map(
    optic: object,
    *,
    heights: int | None = None,
    fields: Sequence[tuple[float, float]] | None = None,
    distortion: bool = False,
    wavelength: float | None = None,
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> FieldMap:
    """Return the field map of a lens: wavefront and pupil as functions of the position on the sensor.

    Parameters
    ----------
    optic : optiland.optic.Optic
        Lens.
    heights : int, optional
        Number of field points traced, from the axis to the edge; the lens must be rotationally symmetric. By default
        5 to 129, as many as are needed for pupils between them to agree with traced ones within `tol`.
    fields : sequence of (float, float), optional
        Points (Hx, Hy) to trace instead, as fractions of the largest field; required without rotational symmetry,
        and requires ``circular=True``.
    distortion : bool, default False
        False for positions at which the chief rays meet the sensor. True for ideal positions, f tan(theta) or a
        constant magnification; tilts of the wavefronts then shift the light to the actual positions, as
        :func:`lommel.imaging.field_photograph` requires. The ideal scale is that of the primary wavelength, so that
        maps for different wavelengths include the lateral colour of the lens.
    circular : bool, default False
        True for circles with the f-number on the axis, which blurs over the field require. At the edges of the fields
        of four lenses, their PSFs differ by 3 to 61 % of the peak from Huygens' sum over the traced rays. False for
        the ellipses of :func:`pupil`, whose PSFs differ by up to 1.5 %; not supported with `fields`.
    wavelength, degree
        As for :func:`pupil`.
    tol : float, default 0.01
        Largest accepted rms residual, radians, of the fits to traced phases and, between the traced field points, of
        the interpolation.

    Returns
    -------
    FieldMap
        Map with the f-number on the axis. If pupils are elliptical, the f-number is that of the longest axis of all
        ellipses, and the ellipses are `vignetting` (:class:`~lommel.field.maps.Foreshortening`).

    Raises
    ------
    ImportError, TypeError, ValueError
        As for :func:`pupil`; also if pupils interpolated between `heights` or between `fields` differ from traced
        ones by more than `tol`, without `fields` if the lens is not rotationally symmetric, if `fields` are given
        with `distortion`, or if `distortion` is requested for fields defined by real image heights.
    """
    trace, metres = _tracer(optic, wavelength)
    ideal = _ideal_height(optic) if validation.truth("distortion", distortion) else None
    return ray_tracing.field_map(trace, heights, fields, metres, degree, tol, ideal=ideal, circular=circular)


_PARAXIAL = 1e-3  # fraction of the largest field; distortion there is about 1e-6 of the distortion at the edge


def _ideal_height(optic: Any) -> Callable[[float], float]:
    """Return a function: image height without distortion (metres, upwards) at a fraction of the largest field."""
    kind = type(optic.fields.field_definition).__name__
    if kind not in ("AngleField", "ObjectHeightField", "ParaxialImageHeightField"):
        raise ValueError(
            f"distortion must be False for fields of the type {kind}, which do not define object positions"
        )
    edge = math.radians(float(optic.fields.max_field))

    def height(h: float) -> float:
        return math.tan(h * edge) if kind == "AngleField" else h

    axis, near = (
        1e-3 * float(optic.trace_generic(0.0, h, 0.0, 0.0, optic.primary_wavelength).y[0]) for h in (0.0, _PARAXIAL)
    )
    return lambda h: (near - axis) * height(h) / height(_PARAXIAL)


def _tracer(optic: object, wavelength: float | None) -> tuple[ray_tracing.Trace, float]:
    """Return the function that traces a field point, and the wavelength in metres."""
    library("optiland.optic", "this needs", "")
    from optiland.optic import Optic
    from optiland.wavefront import Wavefront

    if not isinstance(optic, Optic):
        raise TypeError(f"optic must be an optiland Optic, got {validation.shown(optic)}")
    lens: Any = optic
    micrometres = lens.primary_wavelength if wavelength is None else 1e6 * validation.wavelength(wavelength)
    index = float(np.ravel(lens.surfaces.n(micrometres))[-1])

    def trace(hx: float, hy: float, x: Array, y: Array) -> ray_tracing.TracedField:
        if any(abs(float(part)) > 0.0 for part in lens.fields.get_vig_factor(hx, hy)):
            raise ValueError(f"the field ({hx:g}, {hy:g}) has vignetting factors, which are not supported")
        points = SimpleNamespace(x=x, y=y)
        data = Wavefront(lens, [(hx, hy)], [micrometres], distribution=points).get_data((hx, hy), micrometres)
        opd, light = (np.array(part, dtype=np.float64) for part in (data.opd, data.intensity))
        chief = lens.trace_generic(hx, hy, 0.0, 0.0, micrometres)
        on_sphere = np.stack([np.asarray(part, np.float64) for part in (data.pupil_x, data.pupil_y, data.pupil_z)])
        to_image = np.reshape(np.array(data.reference_center, dtype=np.float64), (3, 1)) - on_sphere
        to_image /= np.linalg.norm(to_image, axis=0)
        rays = lens.trace_generic(hx, hy, x, y, micrometres)
        traced = ray_tracing.TracedField(
            x,
            y,
            # optiland sets the path and the intensity of blocked rays to 0.
            np.where(light > 0.0, -2.0 * math.pi * opd, np.nan),
            index * (to_image[0] - float(chief.L[0])),
            index * (to_image[1] - float(chief.M[0])),
            1e-3 * (np.array(rays.x, dtype=np.float64) - float(chief.x[0])),
            1e-3 * (np.array(rays.y, dtype=np.float64) - float(chief.y[0])),
            (1e-3 * float(chief.x[0]), 1e-3 * float(chief.y[0])),
        )
        traced = traced.along_light(float(chief.N[0]))
        if not ray_tracing.tilt_off_rays(traced, 1e-6 * micrometres):
            return traced
        # Path lengths begin in a plane perpendicular to the axis. For an oblique wave from infinity, optiland adds
        # the path from the wavefront to this plane only if fields are angles; for other fields it is added here.
        return replace(traced, phase=traced.phase + _phase_at_start(lens, (hx, hy), x, y, micrometres))

    return trace, 1e-6 * float(micrometres)


def _phase_at_start(lens: Any, field: tuple[float, float], x: Array, y: Array, micrometres: float) -> Array:
    """Return phases at the starts of rays from infinity, minus that of the chief ray; 0 for a finite distance."""
    if not lens.object_surface.is_infinite:
        return np.zeros(x.size)
    # The last ray is the chief ray.
    rays = lens.ray_tracer.ray_generator.generate_rays(*field, np.append(x, 0.0), np.append(y, 0.0), micrometres)
    start, direction = (
        np.stack([np.asarray(getattr(rays, name), dtype=np.float64) for name in names]) for names in ("xyz", "LMN")
    )
    # Distance of the starting points from the wavefront through the starting point of the chief ray.
    path: Array = np.sum(direction[:, :-1] * (start[:, :-1] - start[:, -1:]), axis=0)
    index = float(np.ravel(lens.surfaces.n(micrometres))[0])
    return 2.0 * math.pi / (1e-3 * micrometres) * index * path
