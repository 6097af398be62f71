"""PSFs at changed arguments, and derivatives by differences of them: nothing of how these are computed is in it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

import lommel as lm
from lommel.special import zernike

POWERS = {"defocus": (1.0,), "spherical": (0.0, 1.0), "rho^6": (0.0, 0.0, 1.0), "rho^8": (0.0, 0.0, 0.0, 1.0)}
FINE = 2e-11  # tolerance of what is differenced


def changed(
    pupil: lm.Pupil, name: Any, h: float, lens: lm.Lens | None, asked: dict[str, Any], fine: float = FINE
) -> lm.PSF:
    """Return the PSF with what `name` is about larger by h, to `fine`."""
    asked = {"dtype": np.float64, **asked}
    white = asked.get("method")
    if isinstance(white, lm.methods.Polychromatic):
        waves = np.array(white.wavelengths)
        if name == "wavelength":
            waves = waves * (1.0 + h / pupil.wavelength)
        asked["method"] = lm.methods.Polychromatic(waves, white.weights, tol=fine)
    else:
        asked.pop("method", None)
    if name in ("row", "column"):
        row, column = asked["center"]
        asked["center"] = (np.add(row, h), column) if name == "row" else (row, np.add(column, h))
    elif name == "wavelength":
        longer = pupil.wavelength + h
        pupil = replace(pupil, wavelength=longer, wavefront=pupil.wavefront * (pupil.wavelength / longer))
    elif name in ("f_number", "obscuration"):
        pupil = replace(pupil, **{name: getattr(pupil, name) + h})
    elif name == "object_distance":
        pupil = lens.pupil(np.array(pupil.geometry.object_distance).reshape(pupil.shape) + h)
    elif name == "focus_distance":
        at = np.array(pupil.geometry.object_distance).reshape(pupil.shape)
        pupil = lens.focused(lens.focus_distance + h).pupil(at)
    else:
        pupil = replace(pupil, wavefront=pupil.wavefront + h * one(name))
    return lm.psf(pupil, tol=fine, **asked)


def one(name: Any) -> lm.Wavefront:
    """Return the wavefront of a radian of what a name is about."""
    if name in POWERS:
        defocus, spherical, *higher = (*POWERS[name], 0.0)
        return lm.Wavefront(defocus, spherical, tuple(higher))
    order, index = ("nm", name) if isinstance(name, tuple) else (name.split()[0], int(name.split()[1]))
    return lm.Wavefront.zernike({zernike.term(index, order): 1.0}, normalization="edge")


def differences(
    at: Callable[[float], np.ndarray], h: float, peak: float, fine: float = FINE
) -> tuple[np.ndarray, float]:
    """Return the derivative at 0 by differences of eighth order, and how far these may be off.

    What is cut off is less than the step from the sixth order to the eighth; values off by e (`fine`) of the peak add
    ``2 (4/5 + 1/5 + 4/105 + 1/280) e / h``.
    """
    odd = [at(k * h) - at(-k * h) for k in range(1, 5)]
    eighth = (4 / 5 * odd[0] - odd[1] / 5 + 4 / 105 * odd[2] - odd[3] / 280) / h
    sixth = (3 / 4 * odd[0] - 3 / 20 * odd[1] + odd[2] / 60) / h
    return eighth, float(np.abs(eighth - sixth).max() + 2.09 * fine * peak / h)
