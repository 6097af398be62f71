"""Pupils and fields of lenses in optiland (https://github.com/HarrisonKramer/optiland).

Conversions:

- ``Wavefront.data.opd`` is in waves and positive where a ray's path is *shorter* than the chief ray's; the phase is
  ``-2 pi opd``. Their FFT PSF takes the same sign.
- Points of the pupil are fractions (Px, Py) of the entrance pupil, y upwards, which is mirrored; see
  :mod:`lommel.adapters.ray_tracing`. Positions are those of the chief ray on the image surface, in metres.
- Wavelengths are micrometres there, metres here.
- The amplitude is taken as uniform: optiland's absorption is not carried over, and coatings by
  :func:`polarized_pupils` only.

optiland is optional, and none of it is imported before a function is called.
"""

from __future__ import annotations

import copy
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
    circular: bool = False,
    degree: int = 12,
    tol: float = 0.01,
) -> Pupil:
    """Return the pupil of a lens at one point of its field.

    Parameters
    ----------
    optic : optiland.optic.Optic
    field : (float, float)
        Hx and Hy, fractions of the largest field.
    wavelength : float, optional
        Metres; by default the primary one of the lens.
    circular : bool, default False
        Whether the pupil is a circle of the geometric mean f-number, as in :func:`field_map` and in optiland's FFT
        PSF. By default it is what the image sees, off the axis an ellipse. Of six lenses, PSFs are then within 1.5 %
        of Huygens' sum over the traced rays, those of circles up to 32 % off (:doc:`/optiland-checked`). Phase
        retrieval and gradients by frameworks take circles only.
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
        If optiland is not installed.
    TypeError, ValueError
        If an argument is out of range, if rays are blocked or fields are vignetted, or if `degree` does not reach
        `tol`.
    """
    trace, metres = _tracer(optic, wavelength)
    return ray_tracing.single_pupil(trace, field, metres, degree, tol, circular=circular)


def polarized_pupils(
    optic: object,
    field: tuple[float, float] = (0.0, 0.0),
    *,
    polarization: str | tuple[complex, complex] = "unpolarized",
    wavelength: float | None = None,
    side: int = 256,
    degree: int = 12,
    tol: float = 0.01,
) -> list[Pupil]:
    """Return a pupil of each component of the electric field in the image: the Jones pupil of a traced lens.

    The sum of the PSFs, each by the light of its pupil, is the vectorial PSF at this point of the field. optiland
    traces the polarisation: the rotation of the field at each surface and, of surfaces with a coating
    (``coating="Fresnel"`` for bare glass), the transmission of both polarisations.

    Parameters
    ----------
    optic : optiland.optic.Optic
        Left as it is; its own state of polarisation is not used.
    field : (float, float)
        Hx and Hy, fractions of the largest field.
    polarization : "unpolarized" or (complex, complex), default "unpolarized"
        Of the light from the object; a Jones vector is along x and along y upwards, of any length.
    wavelength : float, optional
        Metres; by default the primary one of the lens.
    side : int, default 256
        Samples along each side of the masks. With 128, the PSF of a round pupil is within 5e-5 of the peak of the
        integral, with 256 within 1e-5.
    degree : int, default 12
        Highest degree of the Zernike terms of the phase and of the amplitudes, 2 to 20.
    tol : float, default 0.01
        Largest accepted rms residual of the fit to the traced phase, radians, and largest residual of the fits to
        the electric field, over its largest component.

    Returns
    -------
    list of Pupil
        Of the components along x, y and z, of unpolarised light for each of two states; without those
        that are dark. Their wavefront and ellipse are that of :func:`pupil`, their amplitudes masks. Amplitudes are
        those of the field times ``cos(angle)**-0.5`` of the angle to the normal of the image, as in the integral of
        Richards and Wolf, and in proportion to each other.

    Raises
    ------
    ImportError
        If optiland is not installed.
    TypeError, ValueError
        As of :func:`pupil`.

    Notes
    -----
    Transmission is optiland's product of Jones matrices, without the change of the width of ray tubes where light is
    refracted at an angle.

    References
    ----------
    B. Richards, E. Wolf, "Electromagnetic diffraction in optical systems, II", Proc. R. Soc. A 253, 358 (1959),
    doi:10.1098/rspa.1959.0200.

    Examples
    --------
    ::

        pupils = lm.adapters.optiland.polarized_pupils(CookeTriplet(), (0.0, 0.7), polarization=(1.0, 0.0))
        light = sum(pupil.transmission for pupil in pupils)
        values = sum(pupil.transmission / light * lm.psf(pupil, 65, 1e-6).values for pupil in pupils)
    """
    _require(optic)
    from optiland.rays.polarization_state import PolarizationState

    count = validation.integer("side", side, least=16, most=2048)
    state = PolarizationState()
    if not isinstance(polarization, str):
        jones = validation.array("polarization", polarization)
        if jones.shape != (2,) or jones.dtype.kind not in "iufc" or not 0.0 < np.abs(jones).max() < math.inf:
            raise ValueError(
                f'polarization must be "unpolarized" or a Jones vector (a, b), got {validation.shown(polarization)}'
            )
        (ex, ey), (phase_x, phase_y) = np.abs(jones), np.angle(jones)
        state = PolarizationState(True, float(ex), float(ey), float(phase_x), float(phase_y))
    else:
        validation.choice("polarization", polarization, ("unpolarized",))
    own = copy.deepcopy(optic)
    own.updater.set_polarization(state)  # type: ignore[attr-defined]
    trace, metres = _tracer(own, wavelength)
    return ray_tracing.polarized_pupils(trace, field, metres, degree, tol, count)


def field_map(
    optic: object,
    *,
    heights: int = 9,
    fields: Sequence[tuple[float, float]] | None = None,
    distortion: bool = False,
    wavelength: float | None = None,
    circular: bool = True,
    degree: int = 12,
    tol: float = 0.01,
) -> FieldMap:
    """Return the map of a lens over its field.

    Parameters
    ----------
    optic : optiland.optic.Optic
    heights : int, default 9
        Number of field points traced, from the axis to the edge; the lens must be rotationally symmetric.
    fields : sequence of (float, float), optional
        Points (Hx, Hy) to trace instead, as fractions of the largest field, for a lens without that symmetry.
    distortion : bool, default False
        Whether positions are those without distortion, f tan(theta) or a constant magnification, and tilts move the
        light to where the chief rays meet the sensor, as :func:`lommel.imaging.field_photograph` needs it. Otherwise
        positions are those of the chief rays, and the map has no distortion. The ideal scale is that of the primary
        wavelength, so that maps of several wavelengths differ by the lateral colour of the lens.
    circular : bool, default True
        Whether all pupils are circles of the f-number on the axis, which blurs over the field require. At the edge of
        the fields of four lenses, PSFs are then 3 to 61 % of the peak off Huygens' sum over the traced rays. False
        gives each position the ellipse that the image sees, as :func:`pupil` does: up to 1.5 % off. Not with
        `fields`.
    wavelength, degree, tol
        As of :func:`pupil`.

    Returns
    -------
    FieldMap
        With the f-number on the axis; of ellipses, that of the longest of their axes, and ellipses as `vignetting`
        (:class:`lommel.Foreshortening`).

    Raises
    ------
    ImportError, TypeError, ValueError
        As of :func:`pupil`; also if the lens lacks the symmetry and no `fields` are given, if these are given with
        `distortion`, or if the fields of the lens are real image heights, of which it is not known.
    """
    trace, metres = _tracer(optic, wavelength)
    ideal = _ideal(optic) if validation.truth("distortion", distortion) else None
    return ray_tracing.field_map(trace, heights, fields, metres, degree, tol, ideal=ideal, circular=circular)


_PARAXIAL = 1e-3  # of the largest field: distortion is 1e-6 of that at the edge there


def _ideal(optic: Any) -> Callable[[float], float]:
    """Return the function from a fraction of the largest field to the ideal position (metres, upwards)."""
    kind = type(optic.fields.field_definition).__name__
    if kind not in ("AngleField", "ObjectHeightField", "ParaxialImageHeightField"):
        raise ValueError(f"distortion must be False for fields of the type {kind}, which say nothing of the object")
    edge = math.radians(float(optic.fields.max_field))

    def height(h: float) -> float:
        return math.tan(h * edge) if kind == "AngleField" else h

    low, near = (
        1e-3 * float(optic.trace_generic(0.0, h, 0.0, 0.0, optic.primary_wavelength).y[0]) for h in (0.0, _PARAXIAL)
    )
    return lambda h: (near - low) * height(h) / height(_PARAXIAL)


def _require(optic: object) -> Any:
    """Return a lens of optiland; TypeError if it is not one."""
    library("optiland.optic", "this needs", "")
    from optiland.optic import Optic

    if not isinstance(optic, Optic):
        raise TypeError(f"optic must be an optiland Optic, got {validation.shown(optic)}")
    return optic


def _tracer(optic: object, wavelength: float | None) -> tuple[ray_tracing.Trace, float]:
    """Return the tracer of a field, and the wavelength in metres."""
    lens = _require(optic)
    from optiland.wavefront import Wavefront

    micrometres = lens.primary_wavelength if wavelength is None else 1e6 * validation.wavelength(wavelength)
    index = float(np.ravel(lens.surfaces.n(micrometres))[-1])

    def trace(hx: float, hy: float, x: Array, y: Array) -> ray_tracing.TracedField:
        if any(abs(float(part)) > 0.0 for part in lens.fields.get_vig_factor(hx, hy)):
            raise ValueError(f"the field ({hx:g}, {hy:g}) has vignetting factors, which are not supported")
        points = SimpleNamespace(x=x, y=y)
        made = Wavefront(lens, [(hx, hy)], [micrometres], distribution=points).get_data((hx, hy), micrometres)
        opd, light = (np.array(part, dtype=np.float64) for part in (made.opd, made.intensity))
        chief = lens.trace_generic(hx, hy, 0.0, 0.0, micrometres)
        place = np.stack([np.asarray(part, dtype=np.float64) for part in (made.pupil_x, made.pupil_y, made.pupil_z)])
        towards = np.reshape(np.array(made.reference_center, dtype=np.float64), (3, 1)) - place
        towards /= np.linalg.norm(towards, axis=0)
        exits = getattr(made, "E_exits", None)
        electric = None
        if exits is not None:
            parts = np.concatenate([np.asarray(part, dtype=np.complex128) for part in exits], axis=1)
            electric = parts / np.sqrt(np.abs(towards[2]))[:, None]
        rays = lens.trace_generic(hx, hy, x, y, micrometres)
        traced = ray_tracing.TracedField(
            x,
            y,
            # Rays that are blocked come with the path 0 and no light.
            np.where(light > 0.0, -2.0 * math.pi * opd, np.nan),
            index * (towards[0] - float(chief.L[0])),
            index * (towards[1] - float(chief.M[0])),
            1e-3 * (np.array(rays.x, dtype=np.float64) - float(chief.x[0])),
            1e-3 * (np.array(rays.y, dtype=np.float64) - float(chief.y[0])),
            (1e-3 * float(chief.x[0]), 1e-3 * float(chief.y[0])),
            electric,
        )

        if not ray_tracing.tilt_off_rays(traced, 1e-6 * micrometres):
            return traced
        # Paths begin in a plane across the axis; for angles alone optiland takes that from a tilted wave.
        return replace(traced, phase=traced.phase + _launched(lens, (hx, hy), x, y, micrometres))

    return trace, 1e-6 * float(micrometres)


def _launched(lens: Any, field: tuple[float, float], x: Array, y: Array, micrometres: float) -> Array:
    """Return the phase of a wave from infinity where its rays begin, less the chief ray's; 0 for near objects."""
    if not lens.object_surface.is_infinite:
        return np.zeros(x.size)
    # The chief ray is the last.
    rays = lens.ray_tracer.ray_generator.generate_rays(*field, np.append(x, 0.0), np.append(y, 0.0), micrometres)
    place, direction = (
        np.stack([np.asarray(getattr(rays, name), dtype=np.float64) for name in names]) for names in ("xyz", "LMN")
    )
    # The path from the wave's plane through the chief ray's start: the projection on the direction.
    path: Array = np.sum(direction[:, :-1] * (place[:, :-1] - place[:, -1:]), axis=0)
    index = float(np.ravel(lens.surfaces.n(micrometres))[0])
    return 2.0 * math.pi / (1e-3 * micrometres) * index * path
