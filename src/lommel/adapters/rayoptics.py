"""Pupils and fields of lenses in ray-optics (https://github.com/mjhoptics/ray-optics).

Conversions:

- ``wave_abr_full_calc`` returns a length in the units of the lens, positive if the path of a ray is *shorter* than
  that of the chief ray; the phase is ``-2 pi opd / lambda``. (``calc_psf`` of ray-optics has the opposite sign, which
  rotates its PSF by 180 degrees.)
- Pupil points are fractions of the entrance pupil without vignetting. The y of ray-optics points upwards and is
  mirrored; see :mod:`lommel.adapters.ray_tracing`. Positions are intersections of chief rays with the image surface,
  shifted by the focus shift of the lens, in metres.
- Wavelengths are in nanometres in ray-optics, in metres here.
- The amplitude is assumed uniform.

ray-optics is optional; it is imported only when a function of this module is called. It must have version 0.9.10 or
newer, needs Python 3.12, and downloads a database of glasses at the first import. Without a network, set the
environment variable ``refractiveindexinfodb`` to a folder with this database.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from importlib import metadata

import numpy as np

from lommel.adapters import ray_tracing
from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.optional import library
from lommel.field.maps import FieldMap
from lommel.optics.pupil import Pupil

_MIN_VERSION = (0, 9, 10)


def pupil(
    model: object,
    field: tuple[float, float] = (0.0, 0.0),
    *,
    wavelength: float | None = None,
    apertures: bool = True,
    band: tuple[float, float] | None = None,
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> Pupil:
    """Return the pupil of a lens at one point of its field.

    Parameters
    ----------
    model : rayoptics.optical.opticalmodel.OpticalModel
        Lens, after ``update_model()``.
    field : (float, float)
        Fractions of the maximum field along x and y.
    wavelength : float, optional
        Wavelength, metres; by default the central wavelength of the lens.
    apertures : bool, default True
        True to raise an error if a ray misses the clear aperture of a surface. False to ignore clear apertures, for
        example if they have not been set yet.
    band : (float, float), optional
        Shortest and longest wavelength, metres, of :func:`lommel.colour_psf` and
        :class:`lommel.methods.Polychromatic` with this pupil. The lens is traced at 3 to 33 wavelengths, as many as
        `tol` requires: PSFs include axial and lateral colour, about the chief ray at `wavelength`, and
        spherochromatism. By default the pupil is known at `wavelength` only.
    circular : bool, default False
        True for a circle with the geometric mean f-number. False for the pupil seen from the image, off
        the axis an ellipse. Phase retrieval and gradients in JAX or PyTorch support circles only.
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
        If ray-optics is not installed.
    TypeError, ValueError
        If an argument is out of range, if rays are blocked, or if the residual of the fit of this `degree` exceeds
        `tol`.
    """
    _, metres = _tracer(model, wavelength, apertures)
    return ray_tracing.single_pupil(
        lambda wave: _tracer(model, wave, apertures)[0], field, metres, degree, tol, circular=circular, band=band
    )


def field_map(
    model: object,
    *,
    heights: int | None = None,
    fields: Sequence[tuple[float, float]] | None = None,
    wavelength: float | None = None,
    apertures: bool = True,
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> FieldMap:
    """Return the field map of a lens: wavefront and pupil as functions of the position on the sensor.

    Parameters
    ----------
    model : rayoptics.optical.opticalmodel.OpticalModel
        Lens, after ``update_model()``.
    heights : int, optional
        Number of field points traced, from the axis to the edge; the lens must be rotationally symmetric. By default
        5 to 129, as many as are needed for pupils between them to agree with traced ones within `tol`.
    fields : sequence of (float, float), optional
        Points to trace instead, as fractions of the largest field; required for a lens without rotational symmetry,
        and requires ``circular=True``.
    circular : bool, default False
        True for circles with the f-number on the axis, which blurs over the field require; errors of their PSFs can
        be tens of percent of the peak near the edge of the field. False for the ellipses of :func:`pupil`; not
        supported with `fields`.
    wavelength, apertures, degree
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
        ones by more than `tol`, or if the lens is not rotationally symmetric and no `fields` are given.
    """
    trace, metres = _tracer(model, wavelength, apertures)
    return ray_tracing.field_map(trace, heights, fields, metres, degree, tol, circular=circular)


def _require_version(installed: str) -> None:
    """Raise ImportError for versions whose optical path differences have a wrong sign for fields along x."""
    if tuple(int(part) for part in re.findall(r"\d+", installed)[:3]) < _MIN_VERSION:
        raise ImportError(
            f"this needs ray-optics {'.'.join(map(str, _MIN_VERSION))} or newer, which needs Python 3.12, got "
            f"{installed}, whose optical path differences are wrong for fields along x"
        )


def _tracer(model: object, wavelength: float | None, apertures: bool) -> tuple[ray_tracing.Trace, float]:
    """Return the function that traces a field point, and the wavelength in metres."""
    library("rayoptics.optical.opticalmodel", "this needs", "")
    _require_version(metadata.version("rayoptics"))
    from rayoptics.optical.opticalmodel import OpticalModel
    from rayoptics.raytr import trace as rays
    from rayoptics.raytr.opticalspec import Field
    from rayoptics.raytr.waveabr import wave_abr_full_calc

    if not isinstance(model, OpticalModel):
        raise TypeError(f"model must be a ray-optics OpticalModel, got {validation.shown(model)}")
    validation.truth("apertures", apertures)
    spec = model["optical_spec"]
    nanometres = spec["wvls"].central_wvl if wavelength is None else 1e9 * validation.wavelength(wavelength)
    first = model["analysis_results"]["parax_data"].fod
    unit = model.nm_to_sys_units(1e9)  # one metre in the units of the lens
    shift = spec["focus"].focus_shift

    def trace(hx: float, hy: float, x: Array, y: Array) -> ray_tracing.TracedField:
        field = Field(fov=spec["fov"])
        field.xf, field.yf = hx, hy
        sphere, chief = rays.setup_pupil_coords(model, field, nanometres, shift)
        field.chief_ray, field.ref_sphere = chief, sphere
        phase, relative, missed = np.full(x.size, np.nan), np.zeros((x.size, 2)), np.zeros((x.size, 2))
        chief_direction = chief[0][0][-1][1]
        for k, point in enumerate(np.stack([x, y], axis=1)):
            ray, _ = rays.trace_safe(
                model, point, field, nanometres, None, None, apply_vignetting=False, check_apertures=apertures
            )
            if ray is None:
                continue
            opd = wave_abr_full_calc(first, field, nanometres, shift, ray, chief, sphere)
            phase[k] = -2.0 * math.pi * opd / (unit * 1e-9 * nanometres)
            # Offset of the ray from the centre of the reference sphere, which is the image point.
            offset, direction = ray[0][-1][0] - sphere[0], ray[0][-1][1]
            along = offset @ direction
            # The intersection of the ray with the reference sphere is the solution of a quadratic equation.
            length = along + math.sqrt(along**2 + sphere[2] ** 2 - offset @ offset)
            to_image = (length * direction - offset) / abs(sphere[2])
            relative[k] = abs(first.n_img) * (to_image - chief_direction)[:2]
            # Intersection of the ray with the image plane, relative to the chief ray.
            missed[k] = (offset - offset[2] / direction[2] * direction)[:2] / unit
        image_point = np.asarray(sphere[0], dtype=np.float64) / unit
        position = float(image_point[0]), float(image_point[1])
        traced = ray_tracing.TracedField(
            x, y, phase, relative[:, 0], relative[:, 1], missed[:, 0], missed[:, 1], position
        )
        return traced.along_light(chief_direction[2])

    return trace, 1e-9 * float(nanometres)
