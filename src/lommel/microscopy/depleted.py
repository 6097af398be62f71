"""PSFs of STED microscopes: a spot that a doughnut makes sharper than light can be focused."""

from __future__ import annotations

from lommel.base import validation
from lommel.methods.depletion import Sted, crest
from lommel.microscopy.made import _pupil, _same_planes
from lommel.optics.objective_pupil import ObjectivePupil
from lommel.psf import PSF, psf


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
    """Compute the PSF of a STED microscope: of a confocal one whose light a doughnut depletes around the axis.

    Parameters
    ----------
    excitation, emission : ObjectivePupil
        As of :func:`lommel.microscopy.confocal`; emitters turn freely.
    depletion : ObjectivePupil
        ``lm.Beam("vortex")`` of its wavelength, in the same planes.
    shape, pixel
        As of :func:`lommel.microscopy.confocal`, whose pixels sample their centres.
    saturation : float
        The intensity on the crest of the doughnut over that which leaves half of the light, 0 to some hundreds. The
        crest is that of a doughnut without aberrations behind the same interfaces: plane waves keep what these
        transmit, and the phase that they gain in the layers is left out. So depletion fades, as it does, where layers
        blur it.
    pinhole, tol : float
        As of :func:`lommel.microscopy.confocal`.

    Returns
    -------
    PSF
        As of :func:`lommel.microscopy.confocal`: planes of one depth compare, and so do saturations.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if the planes differ, if there are aberrations, if the depletion depends on
        the direction, or emitters do not turn freely.
    ToleranceError
        If the tolerance cannot be met.

    See Also
    --------
    lommel.methods.Sted : the model, and with what proven error

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
    lit, depleting, seen = (
        _pupil(name, given)
        for name, given in (("excitation", excitation), ("depletion", depletion), ("emission", emission))
    )
    _same_planes("excitation", lit, seen)
    _same_planes("depletion", depleting, seen)
    factor = validation.real("saturation", saturation, least=0.0)
    highest = crest(depleting) if depleting.radial else 1.0  # what is no doughnut the method refuses
    way = Sted(lit, pinhole, tol, depletion=depleting, saturation=factor / highest)
    return psf(seen, shape, pixel, method=way, normalize="strehl", integrate=False)
