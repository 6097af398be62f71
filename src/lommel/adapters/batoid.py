"""Pupils and fields of telescopes in batoid (https://github.com/jmeyers314/batoid).

Conversions:

- batoid's wavefronts are in waves, and positive if the path of a ray is *shorter* than that of the chief ray; the
  phase here is ``-2 pi`` times the wavefront. The reference sphere is the same, with radius ``optic.sphereRadius``.
- Pupil points are fractions of ``optic.pupilSize`` on the stop surface. batoid's y points up and is mirrored; see
  :mod:`lommel.adapters.ray_tracing`. If light arrives along -z, x is mirrored too, for a view from behind the sensor.
- Field angles (theta_x, theta_y) are in radians, positions and wavelengths in metres, as in lommel.
- The obscuration is ``optic.pupilObscuration``. Rays that batoid marks as vignetted are used like all others, so that
  vignetting at the edge of the field and spiders are ignored.

batoid is optional; it is imported only when a function of this module is called.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

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
    wavelength: float,
    band: tuple[float, float] | None = None,
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> Pupil:
    """Return the pupil of a telescope for one field direction.

    Parameters
    ----------
    optic : batoid.Optic
        Telescope.
    field : (float, float)
        Field angles theta_x and theta_y, radians.
    wavelength : float
        Wavelength, metres.
    band : (float, float), optional
        Shortest and longest wavelength, metres, of :func:`lommel.colour_psf` and
        :class:`lommel.methods.Polychromatic` with this pupil. The telescope is traced at 3 to 33 wavelengths, as many
        as `tol` requires: PSFs include axial and lateral colour, about the chief ray at `wavelength`, and
        spherochromatism. By default the pupil is known at `wavelength` only.
    circular : bool, default False
        True for a circular annulus with the geometric mean f-number. False for the pupil seen from the image, an
        elliptical annulus off the axis. At the edge of the field of SDSS, PSFs of circular annuli differ by 9 % of
        the peak from Huygens' sum over the traced rays. Phase retrieval and gradients in JAX or PyTorch support
        circular annuli only.
    degree : int, default 12
        Highest degree of the Zernike terms, 2 to 20.
    tol : float, default 0.01
        Largest accepted rms residual of the fit to the traced phase, radians.

    Returns
    -------
    Pupil
        Pupil with the obscuration of the telescope and the f-number for this direction. An elliptical pupil has the
        f-number of its major axis, the ellipse as `vignetting` and the obscuration as `stop`.

    Raises
    ------
    ImportError
        If batoid is not installed.
    TypeError, ValueError
        If an argument is out of range, if rays miss a surface, or if the fit residual for `degree` exceeds `tol`.
    """
    _, metres, obscuration = _tracer(optic, wavelength, 1.0)
    return ray_tracing.single_pupil(
        lambda wave: _tracer(optic, wave, 1.0)[0],
        field,
        metres,
        degree,
        tol,
        obscuration,
        circular=circular,
        band=band,
    )


def field_map(
    optic: object,
    radius: float,
    *,
    wavelength: float,
    heights: int | None = None,
    fields: Sequence[tuple[float, float]] | None = None,
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> FieldMap:
    """Return the field map of a telescope: wavefront and pupil as functions of the position on the sensor.

    Parameters
    ----------
    optic : batoid.Optic
        Telescope.
    radius : float
        Largest field angle, radians from the axis.
    heights : int, optional
        Number of directions traced, from the axis to `radius`; the telescope must be rotationally symmetric. By
        default 5 to 129, as many as are needed for pupils between them to agree with traced ones within `tol`.
    fields : sequence of (float, float), optional
        Directions to trace instead, as fractions of `radius`; required for a telescope without rotational symmetry,
        and requires ``circular=True``.
    circular : bool, default False
        True for circular annuli with the f-number on the axis, which blurs over the field require. At the edge of
        Rubin's field the PSFs of circular annuli differ by 2.4 % of the peak from Huygens' sum over the traced rays.
        False for elliptical annuli of :func:`pupil`, whose PSFs differ by 0.02 %; not supported with `fields`.
    wavelength, degree
        As for :func:`pupil`.
    tol : float, default 0.01
        Largest accepted rms residual, radians, of the fits to traced phases and, between the traced directions, of
        the interpolation.

    Returns
    -------
    FieldMap
        Map with the obscuration and the f-number on the axis. If pupils are elliptical, the f-number is that of the
        longest axis of all ellipses, and the ellipses are `vignetting` (:class:`~lommel.field.maps.Foreshortening`).

    Raises
    ------
    ImportError, TypeError, ValueError
        As for :func:`pupil`; also if pupils interpolated between `heights` or between `fields` differ from traced
        ones by more than `tol`, or if the telescope is not rotationally symmetric and no `fields` are given.
    """
    edge = validation.real("radius", radius, above=0.0)
    trace, metres, obscuration = _tracer(optic, wavelength, edge)
    return ray_tracing.field_map(trace, heights, fields, metres, degree, tol, obscuration, circular=circular)


def _tracer(optic: object, wavelength: float, edge: float) -> tuple[ray_tracing.Trace, float, float]:
    """Return the function that traces a direction (fractions of `edge`), the wavelength, and the obscuration."""
    batoid = library("batoid", "this needs", "")
    if not isinstance(optic, batoid.Optic):
        raise TypeError(f"optic must be a batoid Optic, got {validation.shown(optic)}")
    metres = validation.wavelength(wavelength)
    radius = optic.sphereRadius

    def trace(hx: float, hy: float, x: Array, y: Array) -> ray_tracing.TracedField:
        half = 0.5 * optic.pupilSize
        rays = batoid.RayVector.fromStop(
            half * np.append(x, 0.0),  # the last ray is the chief ray
            half * np.append(y, 0.0),
            optic=optic,
            wavelength=metres,
            theta_x=hx * edge,
            theta_y=hy * edge,
        )
        optic.trace(rays)
        image_point = np.array(rays.r[-1])
        missed = np.array(rays.r[:-1]) - image_point
        failed = np.array(rays.failed[:-1])
        # rays.v is the velocity, with modulus 1 / index, so that v / abs(v)^2 is the direction times the index.
        direction = rays.v / np.square(rays.v).sum(axis=1, keepdims=True)
        relative = direction[:-1] - direction[-1]
        # Intersect the rays with the reference sphere, as batoid.wavefront does.
        rays.toCoordSys(rays.coordSys.shiftLocal(image_point + np.array([0.0, 0.0, radius])))
        batoid.Sphere(-radius).intersect(rays)
        phase = 2.0 * math.pi / metres * (rays.t[:-1] - rays.t[-1])
        traced = ray_tracing.TracedField(
            x,
            y,
            np.where(failed, np.nan, phase),
            relative[:, 0],
            relative[:, 1],
            missed[:, 0],
            missed[:, 1],
            (float(image_point[0]), float(image_point[1])),
        )
        return traced.along_light(direction[-1, 2])

    return trace, metres, float(optic.pupilObscuration)
