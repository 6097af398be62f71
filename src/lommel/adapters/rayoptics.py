"""Pupils and fields of lenses in ray-optics (https://github.com/mjhoptics/ray-optics).

Conversions:

- ``wave_abr_full_calc`` returns a length in the units of the lens, positive where a ray's path is *shorter* than the
  chief ray's; the phase is ``-2 pi opd / lambda``. (ray-optics' own ``calc_psf`` takes the other sign, which turns
  its PSF by half a turn.)
- Points of the pupil are fractions of the entrance pupil without vignetting, y upwards, which is mirrored; see
  :mod:`lommel.adapters.ray_tracing`. Positions are those of the chief ray on the image surface, at the focus shift of
  the lens, in metres.
- Wavelengths are nanometres there, metres here.
- The amplitude is taken as uniform.

ray-optics is optional, and none of it is imported before a function is called. It takes 0.9.10 or newer, which needs
Python 3.12 and downloads a database of glasses when first imported; without a network the environment variable
``refractiveindexinfodb`` names a folder that has it.
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

_LEAST = (0, 9, 10)


def pupil(
    model: object,
    field: tuple[float, float] = (0.0, 0.0),
    *,
    wavelength: float | None = None,
    apertures: bool = True,
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> Pupil:
    """Return the pupil of a lens at one point of its field.

    Parameters
    ----------
    model : rayoptics.optical.opticalmodel.OpticalModel
        Up to date (``update_model()``).
    field : (float, float)
        Fractions of the maximum field along x and y.
    wavelength : float, optional
        Metres; by default the central one of the lens.
    apertures : bool, default True
        Whether a ray that misses the clear aperture of a surface is blocked, which is an error. False lets the whole
        entrance pupil pass, as where apertures have not been set yet.
    circular : bool, default False
        Whether the pupil is a circle of the geometric mean f-number, as in :func:`field_map`; by default it is what
        the image sees, off the axis an ellipse. Phase retrieval and gradients by frameworks take circles only.
    degree : int, default 12
        Highest degree of the Zernike terms, 2 to 20.
    tol : float, default 0.01
        Largest accepted rms residual of the fit to the traced phase, radians.

    Returns
    -------
    Pupil
        With the f-number at this point; of an ellipse, that of its major axis, and the ellipse as `vignetting`.

    Raises
    ------
    ImportError
        If ray-optics is not installed.
    TypeError, ValueError
        If an argument is out of range, if rays are blocked, or if `degree` does not reach `tol`.
    """
    trace, metres = _tracer(model, wavelength, apertures)
    return ray_tracing.single_pupil(trace, field, metres, degree, tol, circular=circular)


def field_map(
    model: object,
    *,
    heights: int = 9,
    fields: Sequence[tuple[float, float]] | None = None,
    wavelength: float | None = None,
    apertures: bool = True,
    circular: bool = True,
    degree: int = 12,
    tol: float = 0.01,
) -> FieldMap:
    """Return the map of a lens over its field.

    Parameters
    ----------
    model : rayoptics.optical.opticalmodel.OpticalModel
        Up to date (``update_model()``).
    heights : int, default 9
        Number of field points traced, from the axis to the edge; the lens must be rotationally symmetric.
    fields : sequence of (float, float), optional
        Points to trace instead, as fractions of the largest field, for a lens without that symmetry.
    circular : bool, default True
        Whether all pupils are circles of the f-number on the axis, which blurs over the field require; their PSFs
        can be wrong by tens of percent of the peak towards the edge of the field. False gives each position the
        ellipse that the image sees, as :func:`pupil` does. Not with `fields`.
    wavelength, apertures, degree, tol
        As of :func:`pupil`.

    Returns
    -------
    FieldMap
        With the f-number on the axis; of ellipses, that of the longest of their axes, and ellipses as `vignetting`
        (:class:`lommel.Foreshortening`).

    Raises
    ------
    ImportError, TypeError, ValueError
        As of :func:`pupil`; also if the lens lacks the symmetry and no `fields` are given.
    """
    trace, metres = _tracer(model, wavelength, apertures)
    return ray_tracing.field_map(trace, heights, fields, metres, degree, tol, circular=circular)


def _require_version(found: str) -> None:
    """Raise ImportError for versions whose optical path differences have a wrong sign in fields along x."""
    if tuple(int(part) for part in re.findall(r"\d+", found)[:3]) < _LEAST:
        raise ImportError(
            f"this needs ray-optics {'.'.join(map(str, _LEAST))} or newer, which takes Python 3.12, got {found}: "
            "before that optical path differences of fields along x are wrong"
        )


def _tracer(model: object, wavelength: float | None, apertures: bool) -> tuple[ray_tracing.Trace, float]:
    """Return the tracer of a field, and the wavelength in metres."""
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
        phase, towards, missed = np.full(x.size, np.nan), np.zeros((x.size, 2)), np.zeros((x.size, 2))
        chief_direction = chief[0][0][-1][1]
        for k, point in enumerate(np.stack([x, y], axis=1)):
            found, _ = rays.trace_safe(
                model, point, field, nanometres, None, None, apply_vignetting=False, check_apertures=apertures
            )
            if found is None:
                continue
            opd = wave_abr_full_calc(first, field, nanometres, shift, found, chief, sphere)
            phase[k] = -2.0 * math.pi * opd / (unit * 1e-9 * nanometres)
            # From the point of the reference sphere that the ray comes from.
            past, direction = found[0][-1][0] - sphere[0], found[0][-1][1]
            along = past @ direction
            # The intersection of the ray with the reference sphere, from a quadratic equation.
            length = along + math.sqrt(along**2 + sphere[2] ** 2 - past @ past)
            straight = (length * direction - past) / abs(sphere[2])
            towards[k] = abs(first.n_img) * (straight - chief_direction)[:2]
            # The ray's point in the plane of the image, relative to the chief ray's.
            missed[k] = (past - past[2] / direction[2] * direction)[:2] / unit
        place = np.asarray(sphere[0], dtype=np.float64) / unit
        position = float(place[0]), float(place[1])
        return ray_tracing.TracedField(
            x, y, phase, towards[:, 0], towards[:, 1], missed[:, 0], missed[:, 1], position
        )

    return trace, 1e-9 * float(nanometres)
