"""PSFs of confocal, two-photon and light-sheet microscopes, and images of beads."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.core.answers import ToleranceError
from lommel.methods.layers.scanning import Bead, Confocal, Sted, TwoPhoton, crest
from lommel.methods.method import Method, storing
from lommel.methods.question import output_type
from lommel.optics.layers.objective import from_focal_plane
from lommel.optics.layers.objective_pupil import ObjectivePupil
from lommel.psf import PSF, psf

_MAX_DISTANCE = 5.0  # distance from a sheet, in thicknesses, where its intensity is 1e-30 of the maximum
_SCANNED: dict[str, Any] = {"normalize": "strehl", "integrate": False}  # PSFs of scanned beams
_CLOSE = 1e-12  # metres: largest difference between planes of two wavelengths that count as equal


def confocal(
    excitation: ObjectivePupil,
    emission: ObjectivePupil,
    shape: int | tuple[int, int],
    pixel: float,
    *,
    pinhole: float = 1.0,
    tol: float = 1e-6,
) -> PSF:
    """Return the PSF of a confocal microscope: the excitation spot times the image seen through the pinhole.

    A scanned beam is point-sampled. Values are the intensity of the excitation, relative to the focus of a uniform
    scalar aperture that sends as much light through the same plane of the sample, times the fraction of the collected
    light that passes the pinhole. Planes of one depth are on one scale; to compare depths at constant laser power,
    multiply by ``excitation.collected``. See :class:`lommel.methods.Confocal` for the formula, and for
    ``lm.psf(emission, shape, pixel, method=...)`` with other scales.

    Parameters
    ----------
    excitation, emission : ObjectivePupil
        Excitation, whose emitter is a :class:`lommel.Beam`, and emission, in the same planes. Both may have
        aberrations; aberrations of the excitation must be equal in all planes. A :class:`lommel.Dipole` absorbs the
        component of the field along its axis; a wobbling dipole reorients between absorption and emission. The foci
        of two wavelengths differ: ``z=emission.focus, origin="coverslip"`` puts the excitation in the planes of
        emission.
    shape : int or (int, int)
    pixel : float
        Shape and pixel pitch as in :func:`lommel.psf`: metres on the camera, the pitch in the sample times the
        magnification.
    pinhole : float, default 1
        Diameter of the pinhole in Airy units, ``1.22 lambda / NA`` of the emission.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Returns
    -------
    PSF
        `pupil` is the emission. `energy` and `encircled_energy` refer to a thin uniform layer in each
        plane, and show the optical sectioning.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the planes differ.
    ToleranceError
        If the tolerance cannot be met.

    Examples
    --------
    >>> water = lm.Objective(
    ...     NA=1.2,
    ...     magnification=60,
    ...     immersion=1.333,
    ...     working_distance=0.28e-3,
    ...     coverslip=lm.Layer(1.5255, 170e-6),
    ...     sample=1.36,
    ... )
    >>> emission = water.pupil(depth=20e-6, wavelength=525e-9)
    >>> laser = {"wavelength": 488e-9, "emitter": lm.Beam("circular")}
    >>> excitation = water.pupil(depth=20e-6, z=emission.focus, origin="coverslip", **laser)
    >>> spot = lm.microscopy.confocal(excitation, emission, 33, 3e-6)
    >>> print(f"{1e9 * spot.fwhm() / 60:.1f} nm")
    219.5 nm
    """
    _same_planes("excitation", excitation, emission)
    return psf(emission, shape, pixel, method=Confocal(excitation, pinhole, tol), **_SCANNED)


def two_photon(
    excitation: ObjectivePupil,
    shape: int | tuple[int, int],
    pixel: float,
    *,
    tol: float = 1e-6,
) -> PSF:
    """Return the PSF of a two-photon microscope: the square of the excitation intensity.

    Parameters
    ----------
    excitation : ObjectivePupil
        Excitation, whose emitter is a :class:`lommel.Beam`.
    shape, pixel, tol
        As in :func:`lommel.microscopy.confocal`; the value 1 is the squared intensity in the focus of a uniform
        scalar aperture that sends as much light through the same plane of the sample. To compare depths at constant
        laser power, multiply by ``excitation.collected**2``.

    Returns
    -------
    PSF
        `pupil` is the excitation; `energy` refers to a thin uniform layer in each plane.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    ToleranceError
        If the tolerance cannot be met.
    """
    validation.instance("excitation", excitation, ObjectivePupil)
    return psf(excitation, shape, pixel, method=TwoPhoton(tol), **_SCANNED)


def bead(
    pupil: ObjectivePupil,
    diameter: float,
    shape: int | tuple[int, int],
    pixel: float,
    *,
    integrate: bool = True,
    tol: float = 1e-6,
) -> PSF:
    """Return the image of a bead uniformly filled with emitters, as recorded to measure a PSF.

    Parameters
    ----------
    pupil : ObjectivePupil
        Pupil of an emitter at the centre of the bead.
    diameter : float
        Diameter of the bead in the sample, metres.
    shape, pixel, integrate
        As in :func:`lommel.psf`.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Returns
    -------
    PSF

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the bead reaches into the glass.
    ToleranceError
        If the tolerance cannot be met.

    See Also
    --------
    lommel.methods.Bead : the method, and its proven error bound
    """
    validation.instance("pupil", pupil, ObjectivePupil)
    return psf(pupil, shape, pixel, method=Bead(diameter, tol), integrate=integrate)


def light_sheet(
    emission: ObjectivePupil,
    thickness: float,
    shape: int | tuple[int, int],
    pixel: float,
    *,
    offset: ArrayLike | None = None,
    tol: float = 1e-6,
) -> PSF:
    """Return the PSF of a light-sheet microscope: emission PSF times sheet intensity.

    Parameters
    ----------
    emission : ObjectivePupil
        Emission, of any emitter.
    thickness : float
        Full width at half maximum of the sheet, whose profile is Gaussian; metres in the sample.
    shape, pixel
        As in :func:`lommel.psf`; pixel-integrated.
    offset : array_like, optional
        Distance of the emitter from the centre of the sheet in each plane, metres in the sample; broadcasts with the
        stack. By default the distance from the plane in focus, for a sheet that stays in it.
    tol : float, default 1e-6
        Tolerance relative to the peak of each plane.

    Returns
    -------
    PSF
        Its `energy` is relative to an emitter at the centre of the sheet.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    ToleranceError
        If the tolerance cannot be met.
    """
    pupil = validation.instance("emission", emission, ObjectivePupil)
    width = validation.real("thickness", thickness, above=0.0, unit="metres")
    distance = from_focal_plane(pupil) if offset is None else offset
    distance = validation.real_array("offset", distance, unit="metres")
    distance = validation.broadcast("offset and the stack", distance, pupil.z)[0]
    if distance.shape != pupil.shape:
        raise ValueError(f"offset must broadcast to the stack of shape {pupil.shape}, got shape {distance.shape}")
    if (farthest := float(np.abs(distance).max(initial=0.0))) > _MAX_DISTANCE * width:
        raise ValueError(
            "offset, by default the distance from the plane in focus, must be within "
            f"{_MAX_DISTANCE:g} times the thickness (dark beyond it), got {farthest:g} m"
        )
    # A Gaussian of full width `width` at half maximum: exp(-4 ln 2 x^2).
    sheet = np.exp(-4.0 * math.log(2.0) * (distance / width) ** 2)
    dtype = output_type(None, validation.real("tol", tol, least=Method.least_tol, below=1e-1))
    # The products are rounded once more when they are stored.
    rounding = storing(dtype)
    # Subtract 1.1 times this error from the tolerance.
    base = psf(pupil, shape, pixel, tol=tol - 1.1 * rounding, dtype=np.float64)
    values = (base.values * sheet[..., None, None]).astype(dtype)
    if base.error_bound is None:
        raise ToleranceError(f"tol={tol:g} cannot be met: {type(base.method).__name__} has no bound")
    return replace(base, values=values, scale=base.scale * sheet, error_bound=base.error_bound + 1.01 * rounding)


def _same_planes(name: str, beam: ObjectivePupil, emission: ObjectivePupil) -> None:
    """Raise TypeError or ValueError unless both are pupils in the same planes."""
    validation.instance(name, beam, ObjectivePupil)
    validation.instance("emission", emission, ObjectivePupil)
    if beam.shape != emission.shape:
        raise ValueError(f"{name} must have the planes of the emission, of shape {emission.shape}, got {beam.shape}")
    for attribute in ("depth", "focus"):
        difference = float(np.abs(getattr(beam, attribute) - getattr(emission, attribute)).max(initial=0.0))
        if difference > _CLOSE:
            raise ValueError(
                f"{name} must have the planes of the emission, got a {attribute} up to {difference:.3g} metres off; "
                'objective.pupil(depth=..., z=emission.focus, origin="coverslip", ...) computes the same planes'
            )


def sted(
    excitation: ObjectivePupil,
    depletion: ObjectivePupil,
    emission: ObjectivePupil,
    shape: int | tuple[int, int],
    pixel: float,
    *,
    saturation: float,
    pinhole: float = 1.0,
    tol: float = 1e-6,
) -> PSF:
    """Return the PSF of a STED microscope: confocal, with depletion by a doughnut around the axis.

    Parameters
    ----------
    excitation, emission : ObjectivePupil
        As in :func:`lommel.microscopy.confocal`; emitters are freely rotating dipoles.
    depletion : ObjectivePupil
        Depletion beam, a pupil with the emitter ``lm.Beam("vortex")``, in the same planes; its aberrations, if any,
        are the same in all planes.
    shape, pixel
        As in :func:`lommel.microscopy.confocal`, point-sampled.
    saturation : float
        Maximum intensity of the doughnut relative to the intensity that depletes half of the fluorescence, 0 to a few
        hundreds. The maximum is computed for a doughnut without aberrations behind the same interfaces, so that
        depletion decreases where the layers blur the doughnut.
    pinhole, tol : float
        As in :func:`lommel.microscopy.confocal`.

    Returns
    -------
    PSF
        As in :func:`lommel.microscopy.confocal`; for one depth, planes and saturations are on one scale.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if the planes differ, if the depletion is not a rotationally symmetric beam,
        or if emitters are fixed dipoles.
    ToleranceError
        If the tolerance cannot be met.

    See Also
    --------
    lommel.methods.Sted : the model, and its proven error bound

    Examples
    --------
    >>> water = lm.Objective(
    ...     NA=1.2,
    ...     magnification=60,
    ...     immersion=1.333,
    ...     working_distance=0.28e-3,
    ...     coverslip=lm.Layer(1.5255, 170e-6),
    ...     sample=1.333,
    ... )
    >>> emission = water.pupil(depth=5e-6, wavelength=680e-9)
    >>> planes = {"depth": 5e-6, "z": emission.focus, "origin": "coverslip"}
    >>> excitation = water.pupil(**planes, wavelength=640e-9, emitter=lm.Beam("circular"))
    >>> doughnut = water.pupil(**planes, wavelength=775e-9, emitter=lm.Beam("vortex"))
    >>> spot = lm.microscopy.sted(excitation, doughnut, emission, 33, 1e-6, saturation=20.0)
    >>> print(f"{1e9 * spot.fwhm() / 60:.1f} nm")
    72.2 nm
    """
    _same_planes("excitation", excitation, emission)
    _same_planes("depletion", depletion, emission)
    factor = validation.real("saturation", saturation, least=0.0)
    unaberrated = replace(depletion, aberrations=None)
    # The saturation is relative to the intensity at the crest of the doughnut: divide by this intensity.
    highest = crest(unaberrated) if unaberrated.radial else 1.0  # the method rejects a beam that is not a doughnut
    method = Sted(excitation, pinhole, tol, depletion=depletion, saturation=factor / highest)
    return psf(emission, shape, pixel, method=method, **_SCANNED)
