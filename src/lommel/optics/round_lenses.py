"""Lenses whose PSFs are radially symmetric, as depth from defocus takes them."""

from __future__ import annotations

from collections.abc import Sequence

from lommel.base import validation
from lommel.optics.lens import Lens
from lommel.special import zernike


def require_round(name: str, lens: Lens) -> None:
    """Raise ValueError unless a lens, called `name`, has one set of radially symmetric PSFs."""
    if lens.aberrations.shape != ():
        raise ValueError(f"{name} must have one set of aberrations, got a stack of shape {lens.aberrations.shape}")
    if not lens.aberrations.radial:
        terms = lens.aberrations.to_zernike()
        kinds = list(dict.fromkeys(zernike.name(n, m) for (n, m), c in terms.items() if m and c))
        others = f" and {len(kinds) - 4} more" if len(kinds) > 4 else ""
        raise ValueError(
            f"{name} must have radially symmetric aberrations, got {', '.join(kinds[:4])}{others}: leave these terms "
            "out of the lens (its section [aberrations]), or blur by lommel.imaging.FieldBlur, which takes any PSF"
        )
    if lens.spider or lens.vignetting or lens.mask or lens.stop:
        raise ValueError(
            f"{name} must have a round aperture, without spider, vignetting, mask and stop: leave these out, or blur "
            "by lommel.imaging.FieldBlur, which takes any aperture"
        )


def pixel_of(lenses: Sequence[Lens], pixel: float) -> float:
    """Return a pixel pitch in metres; TypeError or ValueError unless the PSFs of all lenses are circular."""
    if not isinstance(lenses, Sequence) or not lenses or not all(isinstance(lens, Lens) for lens in lenses):
        raise TypeError(f"lenses must be a sequence of Lens, one for each photograph, got {validation.shown(lenses)}")
    pitch = validation.pixel(pixel, metric=True)
    for k, lens in enumerate(lenses):
        require_round(f"lenses[{k}]", lens)
        validation.pixel_on(pitch, lens.wavelength * lens.working_f_number, metric=True)
    return pitch
