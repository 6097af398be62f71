"""The wavefront behind measured images of a star, fitted to their noise."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.estimation import scoring
from lommel.estimation.noise import Noise
from lommel.estimation.retrieval import Retrieval, answered
from lommel.estimation.star_images import SURE, StarImages, Unknowns
from lommel.methods.derivative_names import SHIFTS
from lommel.optics.pupil import Pupil, checked
from lommel.psf import Plan

_SPREAD = 1.5  # radians rms of random starts
_TOGETHER = 2  # random starts in one stack


def retrieve(
    images: ArrayLike | Sequence[ArrayLike],
    pupil: Pupil,
    *,
    pixel: float,
    noise: Noise,
    terms: int | Sequence[tuple[int, int] | str] = 15,
    defocus: ArrayLike = 0.0,
    also: str | Sequence[str] = ("center",),
    mask: ArrayLike | None = None,
    saturation: float | None = None,
    integrate: bool | None = None,
    tol: float = 1e-6,
    starts: int = 20,
    steps: int = 60,
    seed: int | np.random.Generator = 0,
    threads: int | None = None,
    progress: Callable[[float, float], object] | None = None,
) -> Retrieval:
    """Find the wavefront behind images of a star, or of any point of light, and how certain it is.

    Several images, taken with known defoci, share the wavefront. Each has a flux and a background of its own, which
    are solved for along with all else.

    Parameters
    ----------
    images : array_like, shape (height, width) or (n, height, width), or a sequence of (height, width)
        As the sensor recorded them, proportional to light but for the offset of `noise`. What is NaN or infinite, or
        masked in a masked array, is left out; so is, in images of integers, the largest value of their type.
    pupil : Pupil
        Aperture and scale, and the wavefront to start from, a single one. Round; with spider, vignetting or mask
        there are no derivatives.
    pixel : float
        Pixel pitch, in metres if the pupil has a wavelength, else in units of lambda*N.
    noise : Noise
        How values count electrons, and the noise of reading them.
    terms : int or sequence, default 15
        What the wavefront is solved in. A number: so many Zernike terms from defocus on, Noll's 4, 5, ..., 18. Else
        pairs (n, m) or names as "noll 11", "ansi 12", "fringe 9" (coefficients in radians rms), "defocus" (C_d),
        "spherical" (C_s), "rho^6", "rho^8" (radians, as of :class:`lommel.Wavefront`). May be empty. Terms of
        `pupil` that are not among them stay as they are.
    defocus : float or array_like, shape (n,), default 0
        C_d that each image is known to have on top of the wavefront, radians; positive where the sensor was moved
        towards the lens. See :attr:`lommel.Wavefront.defocus`.
    also : str or sequence of str, default ("center",)
        What else is solved for: "center", that is "row" and "column", of each image its own; "f_number",
        "obscuration", and "wavelength", at which path differences stay and phases change, of all images. Empty where
        the axis is known to be in the middle of pixel ``(height // 2, width // 2)``.
    mask : array_like of bool, shape (height, width) or (n, height, width), optional
        True where a pixel is to be left out.
    saturation : float, optional
        Values from here on, in the unit of the images, are left out.
    integrate : bool, optional
        As of :func:`lommel.psf`.
    tol : float, default 1e-6
        Of the PSFs. Relative to the peak: less than the noise of 1e10 electrons there.
    starts : int, default 20
        So often at most is begun anew at random, 1.5 radians rms from `pupil`, where no answer fits.
    steps : int, default 60
        At most so many from each start.
    seed : int or Generator, default 0
        Of the random starts.
    threads : int, optional
        As of :func:`lommel.psf`.
    progress : callable, optional
        Called as ``progress(share, chi2)`` before each step, with the share of all that may be taken, of which most
        answers need few; what it raises ends the work.

    Returns
    -------
    Retrieval
        The best that was found; `converged`, `reliable` and `message` say whether the images bear it out, and whether
        its standard errors hold.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, an image is constant, or too few pixels are left.

    Notes
    -----
    Fisher scoring, damped as Levenberg and Marquardt do, on the likelihood of ``y + read^2 ~ Poisson(mu + read^2)``
    (Snyder et al. 1993, doi:10.1364/JOSAA.10.001014), ``mu = flux h + background`` electrons. The first start is
    `pupil`, others follow until chi2 exceeds 1 by no more than three standard deviations. The best of all is believed
    where these are no more than six. Chi2 is Pearson's over its expectation; see :class:`lommel.Retrieval`.

    Standard errors are the Cramér-Rao bound at the answer. They hold where images are linear in the parameters as far
    as these are uncertain. Dim stars on a background are not, and other wavefronts may fit them at the same chi2: the
    verdict is then "converged, but the standard errors ... are not to be trusted". Tested with 900 random wavefronts,
    0.3 and 0.7 radians rms, 15 terms, in three images of 25 x 25 pixels at C_d -4, 0, 4 with 500 to 10^5 electrons
    each, backgrounds of 0, 5 and 20 a pixel, read noise 2: of 633 fits whose verdict is plain "converged", 4 have any
    parameter off by more than four standard errors, of the 185 in doubt 31. From 10^4 electrons on no fit is doubted.
    At 3 radians rms a plain "converged" can be another wavefront altogether.

    Images at one defocus do not change when the even part of the phase changes its sign, ``Phi(x) -> -Phi(-x)``.
    Several known defoci tell the two apart (Gonsalves 1982, doi:10.1117/12.7972989; Paxman et al. 1992,
    doi:10.1364/JOSAA.9.001072); without them the answer nearer to `pupil` is given, and where both are as near that
    whose first even term is positive.

    Examples
    --------
    >>> import lommel as lm
    >>> import numpy as np
    >>> noise = lm.Noise(read=2.0)
    >>> true = lm.Wavefront.zernike({5: 0.4, 8: -0.3}, order="noll")
    >>> defocused = lm.Pupil(true + lm.Wavefront(defocus=[-4.0, 0.0, 4.0]))
    >>> stars = noise.record(1e5 * lm.psf(defocused, shape=33, pixel=0.5).values + 5.0, seed=1)
    >>> found = lm.retrieve(stars, lm.Pupil(), pixel=0.5, noise=noise, defocus=[-4, 0, 4], terms=["noll 5", "noll 8"])
    >>> found.converged, abs(found.coefficients["noll 5"] - 0.4) < 0.01
    (True, True)
    """
    unknowns = Unknowns.of(terms, also)
    start = _single(checked(pupil), unknowns)
    validation.instance("noise", noise, Noise)
    values, valid = _images(images, mask, saturation)
    electrons = noise.electrons(values)
    read = noise.variance(np.zeros_like(values))
    known = _defocus(defocus, len(values))
    count = validation.integer("starts", starts, least=1, most=10_000)
    most = validation.integer("steps", steps, least=1, most=10_000)
    draw = np.random.default_rng(seed)
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, got {validation.shown(progress)}")
    plan = Plan(values.shape[1:], pixel, tol=tol, integrate=integrate, threads=threads)
    model = StarImages(electrons, read, valid, start, known, unknowns, plan, pixel)
    _enough(model, electrons, valid)
    first = _starts(model, electrons, valid)
    fits, tries, taken = None, 0, 0
    while tries < count:
        together = 1 if tries == 0 or unknowns.pupil else min(_TOGETHER, count - tries)
        x = _scattered(model, first, draw, together, tries)

        def told(step: int, chi2: float, before: int = tries, together: int = together) -> None:
            if progress is not None:
                progress((before + together * step / (most + 1)) / count, chi2)

        found = scoring.climb(model, model.with_light(x), most, told)
        tries, taken = tries + together, taken + int(found.steps.sum())
        chi2 = found.scores.chi2
        at = int(np.argmin(np.where(found.settled, chi2, 2.0 * chi2)))
        if fits is None or chi2[at] < fits.scores.chi2[0]:
            fits = found[[at]]
        if found.settled[at] and chi2[at] < model.limit(found.scores, SURE)[at]:
            break
    assert fits is not None
    return answered(model, fits, values, noise, (taken, tries))


def _single(pupil: Pupil, unknowns: Unknowns) -> Pupil:
    if pupil.shape != ():
        raise ValueError(f"pupil must be a single one, which all images share, got a stack of shape {pupil.shape}")
    if not pupil.circular:
        raise ValueError("pupil must be round, without spider, vignetting and mask: others have no derivatives")
    if pupil.wavelength is None and {"f_number", "wavelength"} & {*unknowns.pupil}:
        raise ValueError(f"also must be without {unknowns.pupil[0]} where pupil has no wavelength and f_number")
    return pupil


def _images(images: Any, mask: Any, saturation: float | None) -> tuple[Array, NDArray[np.bool_]]:
    """Return images (n, height, width), 0 where they are not valid, and where they are."""
    shapes = {np.shape(part) for part in images} if isinstance(images, list | tuple) else set()
    if len(shapes) > 1:
        raise ValueError(f"images must have one shape (height, width), got {', '.join(map(str, sorted(shapes)))}")
    if any(isinstance(part, np.ma.MaskedArray) for part in (images if shapes else ())):
        images = np.ma.stack([np.ma.asarray(part) for part in images])
    hidden = np.ma.getmaskarray(images) if isinstance(images, np.ma.MaskedArray) else np.zeros((), dtype=bool)
    raw = validation.number_array("images", np.ma.getdata(images) if hidden.shape else images)
    if raw.ndim == 2:
        raw = raw[None]
    if raw.ndim != 3 or raw.size == 0:
        raise ValueError(f"images must have one shape (height, width), one or several, got shape {raw.shape}")
    values = np.array(raw, dtype=np.float64)
    valid = np.isfinite(values) & ~hidden
    if raw.dtype.kind in "iu":
        valid &= raw < np.iinfo(raw.dtype).max
    if saturation is not None:
        valid &= values < validation.real("saturation", saturation)
    if mask is not None:
        out = validation.array("mask", mask)
        if out.dtype != bool or out.shape not in (raw.shape, raw.shape[1:]):
            raise ValueError(f"mask must be True or False for each pixel of images {raw.shape}, got {out.shape}")
        valid &= ~out
    values[~valid] = 0.0
    return values, valid


def _defocus(defocus: Any, count: int) -> Array:
    known = validation.real_array("defocus", defocus)
    if known.shape not in ((), (count,)):
        raise ValueError(f"defocus must be a number, or one for each of {count} images, got shape {known.shape}")
    return np.broadcast_to(known, (count,))


def _enough(model: StarImages, electrons: Array, valid: NDArray[np.bool_]) -> None:
    """Refuse images that are empty, constant or too small to fit."""
    for i, (image, good) in enumerate(zip(electrons, valid, strict=True)):
        if not good.any():
            raise ValueError(f"images[{i}] must have pixels that are neither masked, saturated nor NaN, got none")
        if image[good].min() == image[good].max():
            raise ValueError(f"images[{i}] must show a star, got the value {image[good][0]:g} e everywhere")
    if model.tested < 1:
        raise ValueError(
            f"images must have more pixels than there are unknowns, {model.size}, got {int(valid.sum())} valid ones"
        )


def _starts(model: StarImages, electrons: Array, valid: NDArray[np.bool_]) -> Array:
    """Return where to start from, (2, p): each image around its own centroid, or in the middle of the window."""
    x = np.zeros((2, model.size))
    x[:, model.waves] = model.start
    for column, name in enumerate(model.unknowns.pupil, model.optics.start):
        # An obscuration of 0 changes nothing to first order.
        x[:, column] = max(getattr(model.pupil, name), 0.1 if name == "obscuration" else 0.0)
    own = model.own_of(x)
    for i, (image, good) in enumerate(zip(electrons, valid, strict=True)):
        rim = np.concatenate([image[edge][good[edge]] for edge in (0, -1, (..., 0), (..., -1))])
        level = float(np.median(rim if rim.size else image[good]))
        noise = np.sqrt(max(level, 0.0) + model.read[i].mean())
        light = np.where(good & (image > level + 3.0 * noise), image - level, 0.0)
        total = light.sum()
        for j, place in enumerate(model.unknowns.places):
            axis = 1 if place == "row" else 0
            along = light.sum(axis=axis)
            middle = len(along) // 2
            if total > 0.0:
                own[0, j, i] = (along @ (np.arange(len(along)) - middle) / total) * model.tilt_of_pixel
    return x


def _scattered(model: StarImages, first: Array, draw: np.random.Generator, count: int, tries: int) -> Array:
    """Return so many starts: the first of all as given, others at random."""
    x = first[(tries + np.arange(count)) % len(first)].copy()
    k = len(model.unknowns.terms)
    if k and (tries or model.twins):
        scatter = draw.normal(size=(count, k))
        step = np.zeros_like(x)
        step[:, model.waves] = scatter
        x[:, model.waves] += scatter * ((_SPREAD if tries else 0.3 * _SPREAD) / model.rms(step))[:, None]
    # Light is centred where the mean slope of the phase is: each term R_n^1 moves it as far as a tilt.
    edge = model.base + (x[:, model.waves] @ model.directions)[:, None]
    own = model.own_of(x)
    for j, place in enumerate(model.unknowns.places):
        m = SHIFTS[place][1]
        columns = [c for c, term in enumerate(model.terms) if term[1] == m]
        centred = (np.arange(count) + tries) % len(first) == 0
        own[centred, j] -= edge[centred][:, :, columns].sum(axis=-1)
    return x
