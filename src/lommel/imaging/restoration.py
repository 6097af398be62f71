"""Deblurring: estimate the sharp scene from a photograph with known depth map, lens and noise.

Two checks compare a result x with the photograph y. Let A be the blur operator. x is rejected, and y returned, if

- A x differs from y by more than the noise, and by more than a small fraction of the difference of A y from y; or
- x differs from y by much more than A y does, and the likelihood of A is not that of a right one. Sharpening and
  blurring by the right PSF change most images by similar amounts, but fine patterns near a zero of the transfer
  function by different ones; a PSF that is too wide causes far larger artefacts.

After few steps, or if A y agrees with y within the noise, the result is ``y + a (x - y)``; 1 - a is the share of the
photograph. Let d be x - y and n the noise. (Squared error of the result) - (squared error of y) has the expectation
``a^2 d.d + 2 a E[d.n] - 2 a d.(1 - A) scene``, which a minimises. By Stein's lemma E[d.n] follows from the
derivatives of x with respect to y (Stein 1981, doi:10.1214/aos/1176345632), here along one random direction (Ramani
et al. 2008, doi:10.1109/TIP.2008.2001404). In the last term, which is small for a weak blur, x replaces the scene.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.encoding import Encoding, to_light, warn_if_bright
from lommel.base.options import HIDDEN, In, listed
from lommel.base.units import format_length
from lommel.deconvolve.algorithms import (
    MISFIT,
    STEPS,
    UNDETERMINED,
    ProgressCallback,
    Restoration,
    RichardsonLucy,
    TotalVariation,
    silent,
)
from lommel.deconvolve.iterations import Solution, iterated
from lommel.deconvolve.likelihood import PhotographLikelihood
from lommel.deconvolve.linear import LinearBlur
from lommel.fit.findings import Finding, Findings, untested_finding
from lommel.imaging.blended import Blend, UniformBlur, uniform_over_field
from lommel.imaging.blur import DepthBlur, require_lens, warn_of_depths
from lommel.imaging.blur_verdict import BlurEstimate, BlurVerdict, is_sharpened
from lommel.imaging.field_blur import FieldBlur
from lommel.imaging.measured_blur import MeasuredBlur
from lommel.imaging.motion import Motion
from lommel.imaging.occlusion import Occlusion
from lommel.imaging.one_pass import OnePass, wiener_target
from lommel.imaging.photograph import (
    Pixels,
    encode_light,
    require_image,
    require_scene,
)
from lommel.imaging.settings import WindowOptions, channel_spectra, spectra
from lommel.imaging.uniform_scene import MeasuredScene, SceneEstimate, UniformScene, estimate_scene
from lommel.measures.measured_psf import MeasuredPSF
from lommel.optics.lens import Lens
from lommel.recorded.counts import full_value
from lommel.recorded.noise import Noise

_MAX_MISFIT = 0.08  # largest accepted (discrepancy - 1) of a result / (discrepancy - 1) of the photograph
# Largest accepted mean of abs(x - y) / mean of abs(A y - y), for the result x, the photograph y and a blur A that is
# not the likeliest. In tests with the stated blur it was at most 3.3, and up to 9.5 for text and fabric.
_MAX_CHANGE_RATIO = 4.5
# A photograph that is deblurred as far as its noise allows does not test these.
_UNTESTED = "a blur that is stated too wide", "noise that is stated too low"
_UNTESTED_BESIDES = ("noise up to 30 % too low",)  # where blurs were compared: half the variance
_UNTESTED_WEAK = ("a weak blur stated too wide (less than 2.5 pixels)",)
# Largest discrepancies of a result of a blur that was tested, and of others: ringing in dark areas beside bright ones
# makes 25 and more.
_MAX_DISCREPANCY, _MAX_RINGING = 1.75, 6.0
# Local chi-squared by which a blend must fit less well than Richardson-Lucy to be replaced by it, smallest rms width
# (pixels) of the areas that are compared, and smallest fraction of such areas for which this takes the time.
_EXPECTED, _WORSE, _LEAST_AREA, _LEAST_RINGING = 0.4, 1.2, 3.0, 0.01
_MIN_CHANGE = 0.8  # (change of a pixel by denoising alone, without deblurring) / noise
_MOST_PHOTOGRAPH = 0.9  # largest share of the photograph in a result, by a likelier blur, that is not given up
_SHARPENED_NOISE = 2.0  # least variance of the noise of a sharpened photograph / the stated one
_FEW_STEPS = 5  # largest number of steps after which a result may be smoother than the photograph
_DIFFERENCE_STEP = 0.1  # change of the photograph / noise, for the difference quotient of a result
_DIFFRACTED = 0.06  # rms fraction by which diffraction makes the disc of an unknown lens smaller
_WHOLE = 0.995  # share of the photograph in a result that is it
_WAVELENGTH = 550e-9  # of grey light where no lens is stated, metres


Method = RichardsonLucy | TotalVariation | OnePass | Blend


def noise_aware(
    method: RichardsonLucy | TotalVariation, observed: PhotographLikelihood
) -> RichardsonLucy | TotalVariation:
    """Return the method with the target raised, if necessary, to the discrepancy of the Wiener filter."""
    if not 0.0 < method.target < 1.0 or (isinstance(method, TotalVariation) and method.strength is not None):
        return method
    expected = wiener_target(observed)
    return method if expected is None or expected[0] <= method.target else replace(method, target=expected[0])


def check_result(
    observed: PhotographLikelihood, result: Solution, method: Method, *, likely: bool = False
) -> tuple[float, str]:
    """Return the share of the photograph to blend into a result (1 if rejected), and the stopping reason.

    A blur that is `likely` may change the photograph by any amount.
    """
    before, after = observed.before, result.least_discrepancy
    if after is None:
        after = observed.mean(observed.discrepancies_of(result.light))
    # Richardson-Lucy that stopped at its maximum number of steps may not fit yet.
    converged = result.stopped != STEPS or not isinstance(method, RichardsonLucy)
    misfit = converged and after - 1.0 - observed.slack > max(_MAX_MISFIT * (before - 1.0), 0.0)
    if misfit or (not likely and _is_overdone(observed, result.light)):
        return 1.0, MISFIT
    small_change = before <= 1.0 or result.steps <= _FEW_STEPS
    return _best_share(observed, result) if small_change and result.steps else 0.0, result.stopped


def blend(observed: PhotographLikelihood, light: Values, share: float) -> Values:
    """Return ``(1 - share) * light + share * photograph``, and `light` at unknown pixels of the photograph."""
    if share == 0.0:
        return light
    return np.asarray(light + light.dtype.type(share) * np.where(observed.weight > 0.0, observed.image - light, 0.0))


def _is_overdone(observed: PhotographLikelihood, light: Values) -> bool:
    """Return True if light differs from the photograph by more than the stated blur can explain."""
    tested, photo = observed.tested, observed.image
    change = np.abs(light - photo)[tested].mean(dtype=np.float64)
    # Standard deviation of the shot noise in units of light.
    noise = np.sqrt(observed.counts[tested] / (observed.weight[tested] * observed.white))
    if change <= _MAX_CHANGE_RATIO * _MIN_CHANGE * noise.mean(dtype=np.float64):
        return False
    by_blur = np.abs(observed.model(photo) - observed.counts)[tested].mean(dtype=np.float64)
    return bool(change > _MAX_CHANGE_RATIO * by_blur)


def _best_share(observed: PhotographLikelihood, result: Solution) -> float:
    """Return the share of the photograph with the smallest expected squared error of the blend.

    In comments x is the result, y the photograph, n its noise, A the blur, 1 - a the share, and E[] an expectation.
    """
    tested = observed.tested
    covariance = _noise_product(observed, result) if result.noise_product is None else result.noise_product
    d = (result.light - observed.counts + observed.added)[tested].astype(np.float64)
    # (1 - A) x replaces (1 - A) scene, because the scene is unknown.
    sharpened = (result.light - (observed.model(result.light) - observed.added))[tested]
    # The limit avoids 0 / 0 if the result equals the photograph.
    square = max(float(np.vdot(d, d)), 1e-300)
    # a^2 d.d + 2 a E[d.n] - 2 a d.(1 - A) x is smallest at a = (d.(1 - A) x - E[d.n]) / d.d.
    return min(max(1.0 - (float(np.vdot(d, sharpened)) - float(covariance)) / square, 0.0), 1.0)


def _noise_product(observed: PhotographLikelihood, result: Solution) -> float:
    """Return E[d.n] for the difference d between result and photograph."""
    certain = observed.certain
    expected = wiener_target(observed)
    noise = min(expected[1], 1.0) if expected is not None else 1.0
    sigma = np.sqrt(noise * observed.counts / (np.where(certain, observed.weight, 1.0) * observed.white))
    signs = np.random.default_rng(0).choice(np.array([-1.0, 1.0]), size=sigma.shape)
    step = _DIFFERENCE_STEP * sigma * signs * certain
    # Stein's lemma: E[x.n] is the sum of sigma^2 dx/dy, the mean of b.(dx/dy b) over random b = +-sigma.
    perturbed = result.alike(observed.replaced(observed.light + step))
    # The change of y is subtracted from the change of x.
    product = (sigma * signs * (perturbed - result.light - step))[certain].sum(dtype=np.float64)
    return float(product) / _DIFFERENCE_STEP


def _checked_method(name: str, method: object) -> Method:
    if not isinstance(method, Method):
        hint = "; add parentheses to the class name" if isinstance(method, type) else ""
        raise TypeError(
            f"{name} must be RichardsonLucy(...), TotalVariation(...), OnePass() or Blend(), got "
            f"{validation.shown(method)}{hint}"
        )
    return method


@dataclass(frozen=True, kw_only=True)
class RestoreOptions(WindowOptions):
    """Options of the restoration of photographs.

    Parameters
    ----------
    method : Blend, RichardsonLucy, TotalVariation or OnePass, optional
        By default ``Blend()`` where the whole scene has one distance (its blur varies by at most 0.1 pixel), in areas
        where it rings ``RichardsonLucy()``, which is the default for other scenes.
    accept : bool, default False
        Restore by the blur that agrees better with the photograph, where the stated blur of one distance is doubtful,
        or by motion that the photograph shows.
    saturation : float, optional
        Level at which pixels saturate, as a fraction of white in linear light, such as 0.95; saturated pixels are
        lower limits of the light. By default 1, for a blur operator infinity; the largest integer is always
        saturated. Use infinity for floats that are valid beyond white.
    """

    method: Annotated[Method | None, _checked_method, HIDDEN] = None
    accept: bool = False
    saturation: Annotated[float | None, In(above=0.0, infinite=True)] = None


@listed(RestoreOptions)
def restore(
    photo: ArrayLike,
    depth: ArrayLike | Literal["unknown"] | None,
    lens: Lens | LinearBlur | MeasuredPSF | Sequence[MeasuredPSF] | None = None,
    pixel: float | None = None,
    *,
    encoding: Encoding,
    noise: Noise,
    progress: Callable[..., object] | None = None,
    options: RestoreOptions | None = None,
    **given: Any,
) -> Restoration:
    """Deblur a photograph with a known depth map and lens, or a known blur operator, as far as its noise allows.

    Invert :func:`lommel.imaging.depth_of_field`, with the operator of that function (occlusion included) and its
    exact transpose.

    Parameters
    ----------
    photo : array_like, shape (height, width) or (height, width, channels)
        Unsigned integers (white is their largest value) or floats (white is 1), neither sharpened nor denoised. NaN
        and masked elements of a masked array mark unknown pixels.
    depth : float, array_like of shape (height, width), "unknown" or None
        Distance of the scene, or of each point, from the lens along the axis, metres; may be infinite. "unknown"
        estimates it from the photograph: one distance, or those of blocks of 256 pixels if they differ; without
        `lens`, the diameter of a disc. None for a blur operator or a PSF.
    lens : Lens, LinearBlur or MeasuredPSF, optional
        A lens with radially symmetric aberrations; a blur operator, such as :class:`lommel.imaging.FieldBlur` or a
        subclass of your own, whose matrix must not have negative elements; or the PSF of :meth:`lommel.PSF.measured`
        from the image of a point, or a sequence of one for each channel.
    pixel : float, optional
        Pixel pitch, metres. Not for a blur operator; by default that of a measured PSF.
    encoding : {"srgb", "linear"} or float
        Encoding of `photo` and of the result; a number states ``light = value ** number``.
    noise : Noise
        Noise of linear values with white at 1, for any type of `photo`: ``white=`` is in electrons at white.
    progress : callable, optional
        Called as ``progress(step, discrepancy, seconds_left)`` at each step; an exception that it raises ends the
        restoration.
    options : RestoreOptions, optional
        Options as an object, which keywords change.
    {options}

    Returns
    -------
    Restoration

    Raises
    ------
    TypeError, ValueError
        If an argument is unknown or out of range, if shapes do not match, if a depth is unknown (NaN), if the lens is
        not radially symmetric, if a window is wider than the shorter side of the photograph, or if no pixel is known.

    Examples
    --------
    >>> lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> depth = np.full((40, 60), 2.3)
    >>> scene = np.full((40, 60), 30000, np.uint16)
    >>> scene[10:30, 20:40] = 50000
    >>> photo = lm.imaging.depth_of_field(scene, depth, lens, 8e-6, encoding="srgb").values
    >>> noise = lm.Noise(white=5000, read=3.0)
    >>> sharp = lm.imaging.restore(photo, depth, lens, 8e-6, encoding="srgb", noise=noise)
    >>> sharp.values.dtype, sharp.discrepancy < sharp.before
    (dtype('uint16'), True)
    """
    o = RestoreOptions.of("restore", options, given)
    validation.instance("noise", noise, Noise)
    validation.function("progress", progress, required=False)
    image, mask = validation.parted("photo", photo, "counts")
    method, estimate = o.method, None
    uniform: UniformScene | MeasuredScene | None = None
    psfs = [lens] if isinstance(lens, MeasuredPSF) else lens
    if isinstance(psfs, list | tuple) and psfs and all(isinstance(psf, MeasuredPSF) for psf in psfs):
        require_image("photo", image.shape)
        given_blur: LinearBlur | None = MeasuredBlur.of(image.shape, psfs, pixel)
        usual, pixel = o.saturation, None
    else:
        given_blur = lens if isinstance(lens, LinearBlur) else None
        usual = math.inf if o.saturation is None else o.saturation
    if given_blur is not None:
        if depth is not None or pixel is not None:
            raise ValueError("depth and pixel are for a Lens, got a PSF or blur operator, which has its own")
        limit = full_light(image, encoding, usual)
        light, blur = recorded(image, encoding, limit, mask), given_blur
        blur.require(light, "photo", missing=True)
        method = method or (Blend() if uniform_over_field(blur) else None)
        uniform = MeasuredScene(blur) if isinstance(blur, MeasuredBlur) else None
    else:
        limit = full_light(image, encoding, o.saturation)
        light = recorded(image, encoding, limit, mask)
        if isinstance(depth, str) and depth != "unknown":
            raise ValueError(f'depth must hold metres or be "unknown", got {depth!r}')
        if lens is None and isinstance(depth, str):
            if pixel is not None:
                raise ValueError("pixel is that of a Lens, which is missing")
            of_channels = spectra("channels", channel_spectra(image.shape, _WAVELENGTH))
            blur, estimate = estimate_scene(light, None, of_channels, noise, limit)
            method = method or Blend()
        else:
            lens = require_lens(lens, "photo, depth, lens, pixel")
            if depth is None or pixel is None:
                raise ValueError("depth and pixel must be given with a Lens, both in metres, got None")
            channels = channel_spectra(image.shape, lens.wavelength)
            of_channels = spectra("channels", channels)
            if isinstance(depth, str):
                blur, estimate = estimate_scene(light, (lens, pixel), of_channels, noise, limit)
                method = method or Blend()
            else:
                distances = validation.array("depth", depth, "metres")
                if distances.ndim == 0:
                    distances = np.broadcast_to(distances, image.shape[:2])
                require_scene("photo", image.shape, distances.shape)
                scene = UniformScene.of(distances, lens, pixel, of_channels)
                if isinstance(scene, UniformScene):
                    uniform = scene
                elif isinstance(method, Blend):
                    raise ValueError(
                        "method=Blend() needs one distance of the whole scene, got a depth map in which the diameter "
                        f"of the blur varies by {scene:.3g} pixels; use RichardsonLucy()"
                    )
                if isinstance(scene, UniformScene) and (method is None or isinstance(method, Blend)):
                    warn_of_depths(lens, scene.pixel, distances)
                    blur, method = scene.blur, Blend()
                else:
                    blur = Occlusion(DepthBlur(distances, lens, pixel, channels=channels, energy=o.energy))
        if estimate is not None and estimate.motion is not None and o.accept:
            blur, method = estimate.motion.blur(blur.shape, blur.channels), o.method or RichardsonLucy()
    observed = PhotographLikelihood(blur, light, noise, limit)
    before = observed.before
    method, verdict = method or RichardsonLucy(), None
    result, share, stopped = _solved(observed, method, progress or silent)
    if uniform is not None and stopped == MISFIT:
        verdict = uniform.verdict(observed, result.light)
        if verdict.as_stated:
            share, stopped = check_result(observed, result, method, likely=True)
    if o.method is None and isinstance(method, Blend):
        result, share, stopped = _without_ringing(observed, (result, share, stopped), progress or silent)
    if estimate is not None:
        if not (estimate.known or (o.accept and estimate.motion)):
            share, stopped = 1.0, UNDETERMINED
    elif uniform is not None:
        verdict = verdict or uniform.verdict(observed, result.light)
    if (
        uniform is not None
        and verdict is not None
        and (verdict.doubtful or verdict.noisier or is_sharpened(verdict.sharpening))
    ):
        more = 1.0 if verdict.doubtful else max(verdict.noise, _SHARPENED_NOISE)
        noisier = replace(noise, white=observed.white / more, read=noise.read / math.sqrt(more))
        likelier = PhotographLikelihood(uniform.preferred(verdict), light, noisier, limit)
        # A blend takes textures as equal in all directions, which those behind motion, and its zeros, are not.
        other = _solved(likelier, RichardsonLucy() if verdict.motion else Blend(), progress or silent)
        if o.accept and verdict.doubtful:
            observed = likelier
            result, share, stopped = (
                other if verdict.motion else _without_ringing(observed, other, progress or silent)
            )
        else:
            share = max(share, _milder(observed, result.light, blend(likelier, other[0].light, other[1])))
            images = blend(observed, result.light, share), observed.image
            fits = [likelier.mean(likelier.discrepancies_of(image)) for image in images]
            if share > _MOST_PHOTOGRAPH or fits[0] > fits[1] or verdict.implausible:
                share, stopped = 1.0, MISFIT
    if verdict is not None and verdict.weak:
        fit = observed.mean(observed.discrepancies_of(result.light)) - observed.slack
        most = _MAX_RINGING if verdict.soft_edges else _MAX_DISCREPANCY
        misfit = fit > most and not (verdict.doubtful or verdict.noisier)
        if verdict.ringing or verdict.flat or misfit:
            share, stopped = 1.0, MISFIT
    restored = blend(observed, result.light, share)
    after = observed.discrepancies_of(restored)
    discrepancy = observed.mean(after)
    values, clipped = encode_light(restored, encoding, image.dtype)
    findings = _findings(stopped, share, discrepancy, 1.0 + observed.slack, verdict)
    if estimate is not None:
        findings = _estimate_findings(estimate, lens is None, findings, o.accept, share)
    if isinstance(blur, MeasuredBlur):
        findings = [*blur.findings, *findings]
    return Restoration(
        values, restored, discrepancy, tuple(map(float, after)), before, result.steps,
        stopped, result.strength, 1.0 - float(observed.known.sum()) / light.size, clipped, photograph=share,
        distances=estimate.distances if estimate and estimate.known else (),
        distance_errors=estimate.errors if estimate and estimate.known else (),
        blocks=estimate.blocks if estimate else (),
        findings=Findings(
            [
                *findings, *_blur_findings(verdict, o.accept, share),
                *_sharpened(estimate.blur if estimate else verdict),
            ]
        ),
    )  # fmt: skip


def _solved(observed: PhotographLikelihood, method: Method, report: ProgressCallback) -> tuple[Solution, float, str]:
    """Return the result of a method, the share of the photograph to blend into it, and the stopping reason."""
    if isinstance(method, OnePass | Blend):
        result = method.solve(observed, report)
    else:  # which stops at the discrepancy that the noise makes likely
        result = iterated(noise_aware(method, observed), observed, report)
    return result, *check_result(observed, result, method)


def _without_ringing(
    observed: PhotographLikelihood, blended: tuple[Solution, float, str], report: ProgressCallback
) -> tuple[Solution, float, str]:
    """Return the result of a blend, with that of Richardson-Lucy in areas where the blend fits less well.

    A blend takes noise as equal in all pixels, and rings in dark areas beside bright ones.
    """
    result, share, stopped = blended
    if isinstance(observed.blur, FieldBlur):
        fails = stopped == MISFIT or observed.mean(observed.discrepancies_of(result.light)) > _MAX_RINGING
        return _solved(observed, RichardsonLucy(), report) if fails else blended  # a PSF that varies within a tile
    if stopped == MISFIT:
        return blended
    rms = max(observed.blur.radius, _LEAST_AREA) if isinstance(observed.blur, UniformBlur) else _LEAST_AREA
    gain = observed.certain * observed.weight * observed.white

    def areas(deviations: Values) -> Values:
        planes = (deviations * gain).reshape(*observed.blur.shape, -1).mean(axis=2)
        return np.asarray(scipy.ndimage.gaussian_filter(planes, rms))

    model = observed.model(result.light)
    squares = np.square(model - observed.counts)
    if np.clip((areas(squares / model) - 1.0 - _EXPECTED) / _WORSE, 0.0, 1.0).mean() < _LEAST_RINGING:
        return blended
    other, _, reason = _solved(observed, RichardsonLucy(), report)
    if reason == MISFIT:
        return blended
    model = observed.model(other.light)
    worse = areas((squares - np.square(model - observed.counts)) / model)
    mixed = np.clip((worse - _EXPECTED) / _WORSE, 0.0, 1.0).reshape(
        *observed.blur.shape, *[1] * (result.light.ndim - 2)
    )
    light = np.asarray(result.light + mixed * (other.light - result.light), result.light.dtype)
    return result._replace(light=light), share, stopped


def _milder(observed: PhotographLikelihood, light: Values, likelier: Values) -> float:
    """Return the share of the photograph that brings a result as near as possible to that of a likelier blur."""
    change, other = ((image - observed.image)[observed.certain].astype(np.float64) for image in (light, likelier))
    return float(np.clip(1.0 - change @ other / max(float(change @ change), 1e-300), 0.0, 1.0))


def recorded(photo: Pixels, encoding: Encoding, limit: float, mask: NDArray[np.bool_] | None = None) -> Array:
    """Return the light of a photograph, NaN at unknown pixels; ValueError if all pixels are unknown or saturated."""
    require_image("photo", photo.shape)
    unknown = np.isnan(photo) if photo.dtype.kind == "f" else np.zeros(photo.shape, dtype=bool)
    if mask is not None:
        unknown |= mask
    light = to_light("photo", np.where(unknown, np.asarray(0, photo.dtype), photo), encoding, np.float64)
    if limit < math.inf:  # saturation=inf states that light beyond white is expected
        warn_if_bright(light)
    light[unknown] = np.nan
    if not np.any(light < limit):
        raise ValueError(
            f"photo must have pixels that are neither masked, NaN nor saturated, got none below {limit:g}; if pixels "
            "saturate at another value (white is 1), set saturation="
        )
    return light


def full_light(photo: Pixels, encoding: Encoding, saturation: float | None) -> float:
    """Return the light at and above which pixels of a photograph are saturated."""
    if saturation is not None:
        # The stated value may be rounded down in the type of the photograph.
        return (
            min(saturation, 1.0) if photo.dtype.kind == "u" else min(saturation, float(photo.dtype.type(saturation)))
        )
    if photo.dtype.kind != "u":
        return 1.0
    full, _ = full_value([photo], None)
    return float(to_light("photo", np.full((1, 3), full, dtype=photo.dtype), encoding, np.float64).min())


def _findings(
    stopped: str, share: float, discrepancy: float, limit: float, verdict: BlurVerdict | None
) -> list[Finding]:
    """Return the findings on a restored photograph; `limit`: the largest discrepancy that noise explains."""
    numbers = {"discrepancy": discrepancy}
    if stopped == MISFIT:
        text = "depth, lens or noise do not fit the photograph" + ", which is returned unchanged" * (share == 1.0)
        return [Finding("misfit", "error", text, numbers)]
    if stopped == STEPS:
        text = f"the maximum number of steps was reached at a discrepancy of {discrepancy:.3g}: more steps fit better"
        return [Finding("not_settled", "error" if discrepancy > limit else "doubt", text, numbers)]
    untested: tuple[str, ...] = _UNTESTED
    if verdict is not None:
        untested = (_UNTESTED_WEAK if verdict.weak else ()) + _UNTESTED_BESIDES
    findings = [untested_finding(untested, {})]
    untested_fit = verdict is None or verdict.doubtful or verdict.noisier or verdict.soft_edges
    if discrepancy > (_MAX_RINGING if untested_fit else limit - 1.0 + _MAX_DISCREPANCY):
        text = (
            f"the result fits less well than noise allows (discrepancy {discrepancy:.3g}): blur or noise are not as "
            "stated, or dark areas ring, which those of method=RichardsonLucy() do not"
        )
        findings = [Finding("misfit", "doubt", text, numbers), *findings]
    return findings


def _estimate_findings(
    estimate: SceneEstimate, alone: bool, findings: list[Finding], accepted: bool, share: float
) -> list[Finding]:
    """Return the findings of a photograph of unknown distance, or `alone`, given those of its restoration."""
    blur, numbers = estimate.blur, dict[str, Any](blur=estimate.blur.diameter)
    if estimate.motion is not None:
        return [*(findings if accepted else []), _motion_finding(estimate.motion, accepted, share)]
    if not estimate.known:
        hint = "state lens and distance, or a measured PSF, if it is not sharp" if alone else "state the distance"
        text = (
            "the photograph does not determine its blur, and is returned unchanged: it is sharp, a soft scene, "
            f"blurred by motion, or too noisy; {hint}"
        )
        return [Finding("undetermined", "error", text, numbers)]
    if alone:
        error = blur.diameter * math.hypot(blur.error, _DIFFRACTED)
        text = f"blur estimated without a lens: a disc of diameter {blur.diameter:.3g} +- {error:.2g} pixels"
        return [*findings, Finding("blur_shape", "note", text, numbers | {"error": error})]
    sides = " or ".join(
        f"{format_length(d)} +- {format_length(e, like=d)}"
        for d, e in zip(estimate.distances, estimate.errors, strict=True)
    )
    text = f"distance estimated: {sides} by the noise, for the stated lens, a blur of {blur.diameter:.3g} pixels"
    if estimate.blocks:
        blurs = [block["blur_pixels"] for block in estimate.blocks if block["distances"]]
        text = (
            f"depth varies: distances estimated in {len(blurs)} of {len(estimate.blocks)} blocks, blurs of "
            f"{min(blurs):.3g} to {max(blurs):.3g} pixels; the other blocks are only denoised"
        )
    numbers |= {"distances": estimate.distances, "errors": estimate.errors}
    return [*findings, Finding("distance_estimated", "note", text, numbers)]


def _mixed(share: float) -> str:
    """Return what becomes of a result that is in doubt, in words."""
    return f"{100.0 * share:.0f} % of it are mixed in" if share < _WHOLE else "it is returned"


def _motion_finding(motion: Motion, accepted: bool, share: float) -> Finding:
    """Return the finding on a photograph that was moved during the exposure."""
    numbers = {"motion": motion.length, "angle": math.degrees(motion.angle), "gain": motion.over_blurs}
    gain = f"(log-likelihood {motion.over_blurs:.2g} higher)"
    if accepted:
        return Finding("estimated", "note", f"restored by {motion.words} {gain}", numbers)
    text = (
        f"the photograph agrees better with {motion.words}, than with defocus {gain}, so {_mixed(share)}: "
        "accept=True restores by that motion"
    )
    return Finding("blur_doubtful", "doubt", text, numbers)


def _sharpened(compared: BlurEstimate | BlurVerdict | None) -> list[Finding]:
    """Return the finding on a photograph that was sharpened."""
    if compared is None or not is_sharpened(compared.sharpening):
        return []
    text = (
        "the photograph was sharpened, or its noise is stated too low: detail and noise are stronger than this blur "
        f"allows (log-likelihood {compared.sharpening:.2g} higher with an unsharp mask). Restore it as recorded (raw)"
    )
    return [Finding("sharpened", "doubt", text, {"gain": compared.sharpening})]


def _blur_findings(verdict: BlurVerdict | None, accepted: bool, share: float) -> list[Finding]:
    """Return the findings of the comparison of blurs; `share` is that of the photograph in the result."""
    if verdict is None:
        return []
    numbers = {"factor": verdict.factor, "waves": verdict.waves, "gain": verdict.gain}
    better = f"{verdict.factor:g} times the stated diameter{verdict.bound}"
    if verdict.waves:
        better = f"{verdict.waves:+g} waves of spherical aberration"
    gain = f"(log-likelihood {verdict.gain:.2g} higher)"
    if verdict.motion is not None:
        return [_motion_finding(verdict.motion, accepted, share)]
    if verdict.doubtful and accepted:
        return [Finding("estimated", "note", f"restored by a blur of {better} {gain}", numbers)]
    if verdict.doubtful:
        sharp = bool(verdict.bound) and verdict.factor < 1.0
        text = (
            f"the photograph agrees better with a blur of {better} {gain}, so {_mixed(share)}: check distance, "
            f"f-number and focus; {'it may be sharp' if sharp else 'accept=True restores by that blur'}"
        )
        return [Finding("blur_doubtful", "doubt", text, numbers)]
    if verdict.ringing:
        text = (
            "edges are sharper than behind the stated blur, or ring in its restoration: the photograph is sharper "
            "than stated, was sharpened or moved; check distance, f-number and focus"
        )
        numbers |= {"edges": verdict.edges, "profiles": verdict.profiles}
        return [Finding("blur_doubtful", "doubt", text, numbers)]
    if verdict.flat:
        text = (
            "the stated blur has no zeros, and behind it the scene has more fine detail than most scenes (power "
            f"f^-{verdict.slope:g}): the photograph may be sharper than stated; check distance, f-number and focus"
        )
        return [Finding("blur_doubtful", "doubt", text, numbers | {"slope": verdict.slope})]
    if verdict.noisier:
        text = (
            f"the photograph is noisier than stated, {verdict.noise:g} times the variance, so "
            f"{'it is restored mildly' if share < _WHOLE else _mixed(share)}: check white, the electrons "
            "of white, and the read noise, and whether it was sharpened"
        )
        numbers |= {"noise": verdict.noise, "noise_gain": verdict.noise_gain}
        return [Finding("misfit", "doubt", text, numbers)]
    if verdict.softer:
        text = (
            f"the photograph is softer than stated, as by a blur of {better} {gain}, or the scene is soft; it is "
            "restored by the stated blur, also with accept=True"
        )
        return [Finding("blur_compared", "note", text, numbers)]
    text = "other blurs were compared: none of them agrees better"
    if verdict.sharper:
        text = (
            f"the texture agrees better with a blur of {better} {gain}, as a steeper one may; edges are as soft as "
            "stated"
        )
    return [Finding("blur_compared", "note", text, numbers)]
