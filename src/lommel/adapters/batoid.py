"""Pupils and fields of telescopes in batoid (https://github.com/jmeyers314/batoid).

Conversions:

- batoid's wavefronts are in waves and positive where a ray's path is *shorter* than the chief ray's; the phase is
  ``-2 pi`` times that. The reference sphere is theirs, of radius ``optic.sphereRadius``.
- Points of the pupil are fractions of ``optic.pupilSize`` on the stop surface, y upwards, which is mirrored; see
  :mod:`lommel.adapters.ray_tracing`. Where light arrives along -z, x is mirrored, too: seen from behind the sensor.
- Directions are radians (theta_x, theta_y), positions and wavelengths metres, as here.
- The obscuration is ``optic.pupilObscuration``. Rays that batoid marks as vignetted are traced through the full
  aperture: vignetting at the edge of the field and spiders are not carried over.

batoid is optional, and none of it is imported before a function is called.
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
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> Pupil:
    """Return the pupil of a telescope in one direction.

    Parameters
    ----------
    optic : batoid.Optic
    field : (float, float)
        Field angles theta_x and theta_y, radians.
    wavelength : float
        Metres.
    circular : bool, default False
        Whether the pupil is an annulus of the geometric mean f-number, as in :func:`field_map`; by default it is what
        the image sees, off the axis an elliptical one. At the edge of the field of SDSS, annuli are 9 % of the peak
        off Huygens' sum over the traced rays. Phase retrieval and gradients by frameworks take annuli only.
    degree : int, default 12
        Highest degree of the Zernike terms, 2 to 20.
    tol : float, default 0.01
        Largest accepted rms residual of the fit to the traced phase, radians.

    Returns
    -------
    Pupil
        With the obscuration of the telescope and the f-number in this direction; of an ellipse, that of its major
        axis, the ellipse as `vignetting` and the obscuration as `stop`.

    Raises
    ------
    ImportError
        If batoid is not installed.
    TypeError, ValueError
        If an argument is out of range, if rays miss a surface, or if `degree` does not reach `tol`.
    """
    trace, metres, obscuration = _tracer(optic, wavelength, 1.0)
    return ray_tracing.single_pupil(trace, field, metres, degree, tol, obscuration, circular=circular)


def field_map(
    optic: object,
    radius: float,
    *,
    wavelength: float,
    heights: int = 9,
    fields: Sequence[tuple[float, float]] | None = None,
    circular: bool = True,
    degree: int = 12,
    tol: float = 0.01,
) -> FieldMap:
    """Return the map of a telescope over its field.

    Parameters
    ----------
    optic : batoid.Optic
    radius : float
        Edge of the field, radians from the axis.
    heights : int, default 9
        Number of directions traced, from the axis to the edge; the telescope must be rotationally symmetric.
    fields : sequence of (float, float), optional
        Directions to trace instead, as fractions of `radius`, for a telescope without that symmetry.
    circular : bool, default True
        Whether all pupils are annuli of the f-number on the axis, which blurs over the field require. At the edge of
        Rubin's field, PSFs are then 2.4 % of the peak off Huygens' sum over the traced rays. False gives each
        direction the elliptical annulus that the image sees, as :func:`pupil` does: 0.02 % off. Not with `fields`.
    wavelength, degree, tol
        As of :func:`pupil`.

    Returns
    -------
    FieldMap
        With the obscuration, and the f-number on the axis; of ellipses, that of the longest of their axes, and
        ellipses as `vignetting` (:class:`lommel.Foreshortening`).

    Raises
    ------
    ImportError, TypeError, ValueError
        As of :func:`pupil`; also if the telescope lacks the symmetry and no `fields` are given.
    """
    edge = validation.real("radius", radius, above=0.0)
    trace, metres, obscuration = _tracer(optic, wavelength, edge)
    return ray_tracing.field_map(trace, heights, fields, metres, degree, tol, obscuration, circular=circular)


def _tracer(optic: object, wavelength: float, edge: float) -> tuple[ray_tracing.Trace, float, float]:
    """Return the tracer of a direction, given as fractions of `edge`; the wavelength; and the obscuration."""
    batoid = library("batoid", "this needs", "")
    if not isinstance(optic, batoid.Optic):
        raise TypeError(f"optic must be a batoid Optic, got {validation.shown(optic)}")
    metres = validation.wavelength(wavelength)
    radius = optic.sphereRadius

    def trace(hx: float, hy: float, x: Array, y: Array) -> ray_tracing.TracedField:
        half = 0.5 * optic.pupilSize
        rays = batoid.RayVector.fromStop(
            half * np.append(x, 0.0),  # the last is the chief ray
            half * np.append(y, 0.0),
            optic=optic,
            wavelength=metres,
            theta_x=hx * edge,
            theta_y=hy * edge,
        )
        optic.trace(rays)
        place = np.array(rays.r[-1])
        missed = np.array(rays.r[:-1]) - place
        failed = np.array(rays.failed[:-1])
        # |v| is the speed, 1 over the index.
        direction = rays.v / np.square(rays.v).sum(axis=1, keepdims=True)
        towards = direction[:-1] - direction[-1]
        # Light along -z is seen mirrored from behind the sensor.
        side = math.copysign(1.0, direction[-1, 2])
        # As batoid.wavefront has it.
        rays.toCoordSys(rays.coordSys.shiftLocal(place + np.array([0.0, 0.0, radius])))
        batoid.Sphere(-radius).intersect(rays)
        phase = 2.0 * math.pi / metres * (rays.t[:-1] - rays.t[-1])
        return ray_tracing.TracedField(
            side * x,
            y,
            np.where(failed, np.nan, phase),
            side * towards[:, 0],
            towards[:, 1],
            side * missed[:, 0],
            missed[:, 1],
            (side * float(place[0]), float(place[1])),
        )

    return trace, metres, float(optic.pupilObscuration)
