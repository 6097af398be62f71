"""The wavelengths that an image is the sum of."""

from __future__ import annotations

from lommel.methods.method import Method
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.pupil import Pupil


def colours(method: Method | None, pupil: Pupil) -> list[tuple[float, float, Pupil]]:
    """Return each wavelength of `method`, its share of the light, and the pupil there; one if it has no spectrum."""
    if not isinstance(method, Polychromatic):
        return [(1.0 if pupil.wavelength is None else pupil.wavelength, 1.0, pupil)]
    return [(w, share, part) for w, (share, _, part) in zip(method.wavelengths, method.parts(pupil), strict=True)]
