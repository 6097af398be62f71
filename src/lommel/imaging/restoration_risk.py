r"""Safeguards of restorations: what to leave as noise, and how much of the photograph to keep.

A result x of a photograph y is compared with y, which is at hand without any method. It is not taken where

- the blur of x differs from y by more than the noise, and by more than a small part of what the blur of y does;
- x differs from y by much more than the blur of y does. Sharpening and blurring by the right PSF change an image by
  similar amounts; a PSF that is too wide makes artefacts that are far larger.

After few steps, or where y itself explains what was recorded, the share of y with which x comes nearest to the scene
is predicted. With d = x - y, the noise n and the blur A, the squared error of ``y + a d`` less that of y has the
expectation ``a^2 |d|^2 + 2 a E[d.n] - 2 a d.(1 - A) scene``. By Stein's lemma E[d.n] follows from the derivatives of
x by y (Stein 1981, doi:10.1214/aos/1176345632), here along one random direction (Ramani et al. 2008,
doi:10.1109/TIP.2008.2001404); x stands for the scene in the last term, which is small where blur is.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Values
from lommel.imaging.deconvolution import MISFIT, STEPS, Method, Observed, RichardsonLucy, Solution, TotalVariation
from lommel.imaging.one_pass import wiener_target

_MISFIT = 0.08  # of the photograph's own discrepancy beyond 1, which that of a result may have
_CHANGE = 4.5  # mean change of a pixel over that by the blur; up to 3.3 in photographs whose blur is as stated
_LEAST_CHANGE = 0.8  # of the noise, which any method takes away
_FEW = 5  # steps: results of so few may be smoother than the photograph is blurred
_TURN = 0.1  # of the noise, by which a photograph is changed to see what a result follows


def noise_aware(method: Method, observed: Observed) -> Method:
    """Return a method that leaves what the photograph shows to be noise, where that is more than its target."""
    if not isinstance(method, RichardsonLucy | TotalVariation) or not 0.0 < method.target < 1.0:
        return method
    if isinstance(method, TotalVariation) and method.strength is not None:
        return method
    shown = wiener_target(observed)
    return method if shown is None or shown[0] <= method.target else replace(method, target=shown[0])


def judged(observed: Observed, found: Solution) -> tuple[float, str]:
    """Return the share of the photograph, 0 to 1, that a result needs to be no worse, and why the method stopped."""
    after, before = (observed.mean(observed.discrepancies_of(each)) for each in (found.light, observed.image))
    # Steps of a given number need not have come to an end.
    ended = found.stopped != STEPS or not isinstance(found.alike, RichardsonLucy)
    misfit = ended and after - 1.0 - observed.slack > max(_MISFIT * (before - 1.0), 0.0)
    if misfit or _is_overdone(observed, found.light):
        return 1.0, MISFIT
    slight = before <= 1.0 or found.steps <= _FEW
    return _nearest_share(observed, found) if slight and found.steps else 0.0, found.stopped


def mixed(observed: Observed, light: Values, share: float) -> Values:
    """Return light with a share of the photograph, where that is known."""
    if share == 0.0:
        return light
    return np.asarray(light + light.dtype.type(share) * np.where(observed.weight > 0.0, observed.image - light, 0.0))


def _is_overdone(observed: Observed, light: Values) -> bool:
    """Return whether light differs from the photograph by more than any blur like the stated one would explain."""
    known, photo = _counted(observed), observed.image
    noise = np.sqrt(observed.counts[known] / (observed.weight[known] * observed.white))
    by_blur = np.abs(observed.model(photo) - observed.counts)[known].mean(dtype=np.float64)
    least = _LEAST_CHANGE * noise.mean(dtype=np.float64)
    return bool(np.abs(light - photo)[known].mean(dtype=np.float64) > _CHANGE * max(by_blur, least))


def _counted(observed: Observed) -> NDArray[np.bool_]:
    """Return the pixels that are known and not full."""
    known = observed.weight > 0.0
    return known if observed.full is None else known & ~observed.full


def _nearest_share(observed: Observed, found: Solution) -> float:
    """Return the share of the photograph with which a result is predicted to come nearest to the scene."""
    known = _counted(observed)
    shown = wiener_target(observed)
    noise = min(shown[1], 1.0) if shown is not None else 1.0
    sigma = np.sqrt(noise * observed.counts / (np.where(known, observed.weight, 1.0) * observed.white))
    signs = np.random.default_rng(0).choice(np.array([-1.0, 1.0]), size=sigma.shape)
    moved = _TURN * sigma * signs * known
    other = found.alike.solve(
        replace(observed, counts=(observed.counts + moved).astype(sigma.dtype)), lambda *_: None
    )
    along = (sigma * signs * (other.light - found.light - moved))[known].sum(dtype=np.float64) / _TURN
    change = (found.light - observed.counts + observed.added)[known].astype(np.float64)
    sharpened = (found.light - (observed.model(found.light) - observed.added))[known]
    size = max(float(change @ change), 1e-300)
    return min(max(1.0 - (float(change @ sharpened) - float(along)) / size, 0.0), 1.0)
