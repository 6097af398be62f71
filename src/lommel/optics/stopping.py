"""What stopping a lens down changes in it beside the aperture itself."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from lommel.optics.apodization import Apodization


def narrowed(lens: Any, ratio: float) -> dict[str, Any]:
    """Return what of a lens is stated over the radius of an aperture that is narrower by a `ratio` of f-numbers.

    Parameters
    ----------
    lens : Lens
    ratio : float
        The new f-number over that of the lens.

    Returns
    -------
    dict
        By the names that the constructor has.

    Raises
    ------
    ValueError
        As :meth:`lommel.Lens.stopped`.
    """
    if lens.vignetting or lens.mask:
        raise ValueError(
            "f_number of a lens with vignetting or a mask cannot change, for these are stated over the radius of "
            "the aperture: make a lens with those of the other stop"
        )
    light, flat = lens.apodization, not lens.aberrations.edge.any()
    shaped = isinstance(light, Apodization) and not light.uniform
    for there, what in ((not flat, "aberrations are"), (shaped, "apodization is")):
        if there and ratio < 1.0 - 1e-9:
            raise ValueError(
                f"f_number must be at least that of the lens, f/{lens.f_number:g}, up to which its {what} known, "
                f"got f/{ratio * lens.f_number:g}"
            )
    if isinstance(light, Apodization):
        light = light.scaled(min(1.0, 1.0 / ratio)) if shaped else light
    elif isinstance(light, float):
        light = light / ratio**2
    return {
        "apodization": light,
        "obscuration": lens.obscuration * ratio,
        "aberrations": lens.aberrations if flat else lens.aberrations.scaled(min(1.0, 1.0 / ratio)),
        "spider": lens.spider and replace(lens.spider, width=lens.spider.width * ratio),
    }
