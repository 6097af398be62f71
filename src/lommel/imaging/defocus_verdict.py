"""Tests of frames that differ in focus against their lenses: registration, noise, and the scale of the blur.

Each frame has one blur radius at a point, but the point has only one distance. The difference between the radii of
two frames is therefore redundant: focus distances, f-number, focal length and pixel pitch predict it. The scale is
(true difference) / (predicted difference), one unknown for the whole image. Lenses with other apertures change the
prediction: the scale is estimated by a search for the apertures with the smallest misfit, which is (difference of the
frames) / (difference expected of noise). The difference is computed by the residual filters of
:mod:`lommel.imaging.focal_tables`, without polynomials. A tile is a square of the frames; a cell is a square of
blocks, independent of other cells.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, partial
from typing import NamedTuple, Self

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel.base.arrays import Array, Values
from lommel.base.units import format_length, percent
from lommel.estimation.depth_precision import WINDOW
from lommel.fit.findings import Finding, Findings, FitReport, Severity, untested_finding
from lommel.imaging.focal_engine import BLOCK, UNMEASURED, FocalEngine, Registration
from lommel.imaging.focal_tables import residual_filters
from lommel.imaging.frame_phases import frame_magnifications, frame_shift
from lommel.imaging.pair_noise import MOSTLY_ROUNDING, EstimatedNoise, is_compressed
from lommel.io.depth_maps import fill_missing

# Misfit below which noise is overstated, above which agreement is doubtful, and above which the images disagree.
_MIN_MISFIT, _DOUBTFUL_MISFIT, _WRONG_MISFIT = 0.7, 1.2, 1.8
# Variance of the difference of the images, relative to the noise of their finest details, above which it is in doubt
# and above which it is not noise: up to 3 in right pairs, as smoothed by 0.8 pixels, 13 or more in pairs shifted by a
# pixel. JPEG removes finest details: up to 25 in right pairs of quality 75, 15 to 88 in those shifted by a pixel.
_DOUBTFUL_EXCESS, _WRONG_EXCESS, _WRONG_EXCESS_OF_JPEG = 5.0, 10.0, 30.0
_TOLD_ROUNDING = 0.01  # fraction of the variance that is of rounding, from which it is told
_EXPLAINED = 0.5  # largest (misfit - 1) of frames resampled by a magnification / as stated, that it explains
_EXCHANGED_RATIO = 1.15  # misfit / that of exchanged lenses, from which these are named if they agree
_MAX_PREDICTED = 0.5  # largest misfit due to slopes and edges of depth, as predicted, in blocks that are judged
_BLUR_SHARE = 0.75  # share of (blur radius)^2 that slopes count like window^2, measured in rendered ramps
_MIN_JUDGED = 0.15  # fraction of judged blocks below which registration and noise are not judged
_DOUBTFUL_DEVIATION, _WRONG_DEVIATION = 1.5, 2.5  # limits of abs(scale - 1) / standard error
_MAX_SCALE_ERROR = 0.1  # largest standard error of a reported scale, unless the scale is wrong
_MIN_SCALE_ERROR = 0.02  # systematic standard error of a scale, measured in rendered scenes with much texture
# Systematic error of the difference between two mean misfits: a constant, and a multiple of abs(misfit - 1).
_MISFIT_ERROR, _MISFIT_ERROR_RATIO = 0.0005, 0.1
_SLOPE_ERROR_RATIO = 1.0  # systematic error of d misfit / d log(scale), as a multiple of abs(misfit - 1)
_EDGE_RATIO = 1.15  # misfit of a cell / lower quartile of all cells, above which the cell is ignored
_LOG_STEP, _MAX_STEP, _COARSE_STEP = 0.04, 16, 2  # search of log(scale): step, steps on each side of 0, coarse step
_EXCESS, _EXCESS_RATIO = 0.02, 0.5  # largest (misfit - smallest misfit) of refined minima: terms as above
_MAX_MISFIT_RATIO = 2.5  # misfit / smallest misfit above which larger scales are not tried
_TILE_SIDE, _MAX_TILES = 256, 4  # side of a tile in pixels, number of tiles
_MARGIN = 8  # pixels: least distance of a used block from unknown pixels, in addition to the blur radius
_CELL = 8  # number of blocks along a side of a cell
_REACH = 3.0  # steps between candidates: extension of the depths of a tile for the judged misfit
_MIN_COUNT, _COUNT_PER_PIXEL = 48, 8.0  # frequencies along an axis: at least, and per pixel of the largest blur
_CHUNK = 32  # number of candidates computed together
_MIN_CELLS = 8  # least number of cells from which a scale is estimated
MIN_BLOCKS = 16
"""Least number of blocks with a depth: fewer are false ones of noise, and no depth is known."""

# Errors that these images, or any images, cannot reveal.
_UNTESTED = (
    "which image is focused nearer (without spherical aberration exchanged images agree as well, and with it where "
    "noise hides its effect)",
    "a shift of all foci or of one focus",
    "motion blur or other additional blur of one image",
    "chromatic differences of focus",
    "aberrations that the lenses do not state, such as spherical aberration, which may look like another f-number",
    "additional light in one image, such as glare, or vignetting",
)
# Frames of one focus: median deviation from the vergence of equal blur / standard error, systematic error of this
# vergence / distance of the foci (0.004 or less in rendered frames of one focus), and share within three errors.
_MAX_ALIKE, _ALIKE_ERROR, _ALIKE_SHARE = 0.5, 0.01, 0.9
_NEWTON_STEPS = 5  # number of Newton steps to the minimum of an energy


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class DefocusVerdict(FitReport):
    """Test of frames that differ in focus against their stated lenses and noise.

    The findings have the codes "no_depth", "misfit", "too_quiet", "left_out", "estimated_noise", "exchanged",
    "lens_scale", "undetermined", "one_focus", "stated" (what errors of the lens change) and "untested" (errors that
    these frames, or any frames, cannot reveal: all are in its `numbers`).

    Attributes
    ----------
    findings : Findings
        Properties that disagree, are in doubt, or are not tested.
    summary : str
        Properties that agree.
    misfit : float
        Median, over judged pixels of the brightest channel, of (difference of the frames) / (difference expected of
        noise): 1 if registration and noise are as stated; NaN if no depth is known.
    scale : float
        (Difference between the blurs of the frames) / (difference that the lenses predict), 1.1 for example if all
        apertures are 10 % larger than stated; NaN if not tested.
    scale_error : float
        Standard error of the scale, 0.02 or more; inf if the scale is not tested.
    others : tuple of float
        Other scales that fit equally well. If one of several scales agrees with the lenses, `scale` is NaN, and
        `others` holds all scales.
    changes : (float, float)
        Median change of depth, metres, if all foci increase by 0.01 dioptre (second number), and median absolute
        change if all f-numbers change by 1 % (first number); NaN if no depth is known.
    judged : float
        Fraction of the examined pixels whose misfit is judged. Others are near edges or steep slopes of depth: a
        window has one depth in the model.
    lens_error : dict of str to (float, float)
        Distance and standard error of depth there, metres, "nearest" and "farthest" (5 and 95 % of known depths), due
        to the errors of the lens that are stated, or to 3 % of the f-number and 2 % of each focus distance if none is
        stated. All points at one distance share it, and standard errors of depth include it only if it is stated;
        empty if no depth is known.
    """

    misfit: float
    scale: float
    scale_error: float
    others: tuple[float, ...] = ()
    changes: tuple[float, float] = (math.nan, math.nan)
    judged: float = 1.0
    lens_error: Mapping[str, Sequence[float]] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        misfit: float,
        scale: float = math.nan,
        scale_error: float = math.inf,
        others: tuple[float, ...] = (),
        changes: tuple[float, float] = (math.nan, math.nan),
        *,
        judged: float = 1.0,
        stated: float | None = None,
        lens_error: Mapping[str, Sequence[float]] | None = None,
        included: bool = True,
        noise: EstimatedNoise | None = None,
        excess: float = 1.0,
        exchanged: bool = False,
        compressed: bool = False,
        shift: Sequence[float] = (),
        magnifications: Sequence[tuple[float, float]] = (),
        undone: float = math.nan,
        likely: Sequence[tuple[float, float]] = (),
        one: str = "",
    ) -> Self:
        """Return the verdict for a misfit and a scale.

        Parameters
        ----------
        misfit, scale, scale_error, others, changes, judged, lens_error
            See the attributes.
        stated : float, optional
            Standard error of the scale that follows from the stated errors of the lenses; None if none is stated.
        included : bool
            Whether standard errors of depth include those stated of the lenses.
        noise
            Noise estimated from these frames, which `misfit` therefore cannot test; None for a stated noise.
        excess
            Variance of the estimated noise relative to that of the finest details.
        exchanged
            Whether the frames agree with their lenses exchanged.
        compressed
            Whether the frames are compressed, so that the scale is not tested.
        shift
            Pixels, down and right, by which a frame is shifted; empty if none was found.
        magnifications
            Those of the frames as recorded, relative to the first, and their standard errors; empty if as stated.
        undone
            Misfit of the frames resampled by these; NaN if not computed.
        likely
            The same, which blurred edges of depth may explain, too.
        one
            What two frames may share, "focus" or "aperture", as every known depth is at equal blur; else empty.

        Returns
        -------
        DefocusVerdict
        """
        findings, agreements, untested = list[Finding](), list[str](), [*_UNTESTED]
        unmeasured, stated = stated is None, stated or 0.0

        def add(code: str, severity: Severity, text: str, numbers: Mapping[str, object] | None = None) -> None:
            findings.append(Finding(code, severity, text, numbers or {}))

        numbers = {"misfit": misfit, "least": _MIN_MISFIT, "limit": _DOUBTFUL_MISFIT, "judged": judged}
        where = f" at the {percent(judged)} of pixels away from edges and slopes of depth" if judged < 0.995 else ""
        value = f"misfit {misfit:.3g}{where}"
        if math.isnan(misfit):
            add(
                "no_depth",
                "error",
                "no depth is known, or of few blocks: no texture (or a faint one in JPEG), every depth out of range, "
                "or blocks left out as stated beside",
            )
        elif len(magnifications) and (noise is not None or misfit > _DOUBTFUL_MISFIT):
            findings.extend([noise_finding(noise)] if noise else [])
            times = ", ".join(f"{scale:.4f} +- {error:.4f}" for scale, error in magnifications[1:])
            less = (
                "" if math.isnan(undone) else f", which explains the misfit ({misfit:.3g}; {undone:.3g} without it)"
            )
            text = (
                f"the images are magnified {times} times the first, not as stated (focus breathing){less}: state "
                "this magnification, or align them (lommel align)"
            )
            relative, of_relative = map(tuple, zip(*magnifications, strict=True))
            facts = {"magnifications": relative, "errors": of_relative, "misfit": misfit}
            add("misfit", "error", text, facts | ({} if math.isnan(undone) else {"undone": undone}))
        elif noise is not None:
            findings.append(noise_finding(noise))
            wrong = _WRONG_EXCESS_OF_JPEG if compressed else _WRONG_EXCESS
            total = excess * misfit
            if len(shift):
                text = "a frame is shifted by {:.1f} pixels down and {:.1f} right: register the images".format(*shift)
                add("misfit", "error", text, {"excess": total, "shift": tuple(shift)})
            elif total > (wrong if compressed else _DOUBTFUL_EXCESS):
                size = "which lommel calibrate names with its size"
                if len(likely):
                    times = ", ".join(f"{scale:.3f}" for scale, _ in likely[1:])
                    size = f"by about {times} times the first, or edges of depth seem so: try --magnification {times}"
                text = (
                    f"the images differ by {total:.2g} times the noise of their finest details: frames are shifted "
                    f"or magnified (focus breathing, {size}), something moved, the lens or its foci are wrong, or "
                    "they were denoised; noise and errors of depth are estimated from this difference"
                )
                magnified: dict[str, object] = (
                    {"magnifications": tuple(scale for scale, _ in likely)} if len(likely) else {}
                )
                add("misfit", "error" if total > wrong else "doubt", text, {"excess": total, **magnified})
            untested.insert(0, "registration and noise (the noise is estimated from the images)")
        elif judged < _MIN_JUDGED:
            text = (
                f"registration and noise cannot be judged: {percent(1.0 - judged)} of the pixels are near edges or "
                "slopes of depth; to test them, photograph a flat surface parallel to the sensor"
            )
            add("left_out", "doubt", text, numbers)
        elif misfit > _WRONG_MISFIT:
            text = (
                f"the images differ by more than noise ({value}): something moved, they are not registered or not "
                "encoded as stated, noise is understated, or the lens or its foci are wrong"
            )
            add("misfit", "error", text, numbers)
        elif misfit > _DOUBTFUL_MISFIT:
            text = f"registration, noise or lenses are in doubt ({value}; 1 if only noise is left)"
            add("misfit", "doubt", text, numbers)
        elif misfit < _MIN_MISFIT:
            text = f"the images differ by less than noise ({value}): they were denoised, or noise is overstated"
            add("too_quiet", "error", text, numbers)
        else:
            agreements.append(f"registration and noise agree ({value}; 1 if only noise is left)")
        if exchanged:
            text = "in the other order the images agree: exchange them, or the foci stated"
            add("exchanged", "error", text)
        deviation = min(abs(s - 1.0) / math.hypot(scale_error, stated) for s in (scale, *others))
        ratio = f"{scale:.2f} +- {scale_error:.2f}"
        numbers = {"scale": scale, "error": scale_error}
        if math.isnan(scale) or (bool(others) and deviation <= _WRONG_DEVIATION):
            if not math.isnan(scale):
                scale, scale_error, others = math.nan, math.inf, (scale, *others)
            scales = ", ".join(f"{s:.2f}" for s in others)
            hint = f" ({scales} times the stated blur difference fit equally well)" if others else ""
            if compressed:
                hint = " (JPEG removes faint details, which looks like blur: use raw images or PNG to test it)"
            untested.insert(0, "the size of blur" + hint)
        elif deviation > _WRONG_DEVIATION:
            text = (
                f"blurs differ by {ratio} times the stated difference: f-number, focal length, pixel pitch or a "
                "focus distance is wrong, or an aberration is not stated, which cannot be told apart; state the "
                "errors of rounded ones (f_number_error, focus_error)"
            )
            add("lens_scale", "error", text, numbers)
        elif deviation > _DOUBTFUL_DEVIATION:
            text = f"the size of blur is in doubt: blurs differ by {ratio} times the stated difference"
            add("lens_scale", "doubt", text, numbers)
        else:
            errors = " within their stated errors" if stated > scale_error else ""
            unseen = percent(_DOUBTFUL_DEVIATION * math.hypot(scale_error, stated))
            agreements.append(
                f"blurs differ as the lenses state{errors} ({ratio} times that; f-numbers off by {unseen} would "
                "agree too)"
            )
        worst = {finding.severity for finding in findings}
        if not agreements and worst <= {"note"}:
            text = "depth is as right as the lens: calibrate it by planes at known distances (lommel calibrate)"
            if not unmeasured:
                text = "depth is as right as the lens with its stated errors; state the noise to test registration"
            if compressed:
                text = (
                    "the images are JPEG, which hides errors of noise, registration and lens; quality 75 or more "
                    "moves depth by up to 1.1 of its standard error, of faint texture by up to 2.6, and denoising in "
                    "a camera by more: use raw images or PNG"
                )
            add("undetermined", "doubt", text)
        if one:
            text = (
                f"every known depth is where both frames are blurred alike, as with two frames of one {one}: check "
                f"that the {one} changed"
            )
            add("one_focus", "doubt", text)
        details, parts = dict[str, object](), list[str]()
        if all(map(math.isfinite, changes)):
            details |= {"by_f_number": changes[0], "by_foci": changes[1]}
            stop, foci = (format_length(abs(change), digits=2) for change in changes)
            part = f"1 % of the f-number changes the median depth by {stop}, "
            parts.append(f"{part}0.01 dioptre of all focus distances by {foci}")
        if lens_error:
            details |= {"lens_error": lens_error}
            f_number, focus = map(percent, UNMEASURED)
            part = f"noise alone: a lens that was not measured (f-number within {f_number}, foci within {focus}) adds"
            if not unmeasured:
                part = "noise and of the lens as stated," if included else "noise alone: the lens as stated adds"
            sizes = [f"{format_length(error, digits=2)} at {at:.3g} m" for at, error in lens_error.values()]
            parts += [f"standard errors are of {part} {' and '.join(sizes)}, which all points at one distance share"]
        if parts:
            add("stated", "note", "; ".join(parts), details)
        findings.append(untested_finding(untested, {}))
        nothing = f"{'compressed (JPEG); ' if compressed else ''}neither noise nor lens could be tested"
        if not worst <= {"note"}:
            nothing = "what was tested disagrees" if "error" in worst else "what was tested is in doubt"
        return cls(
            findings=Findings(findings),
            summary="; ".join(agreements) or nothing,
            misfit=misfit,
            scale=scale,
            scale_error=scale_error,
            others=others,
            changes=changes,
            judged=judged,
            lens_error=lens_error or {},
        )

    @property
    def agrees(self) -> bool:
        """True if every tested property agrees, without doubt."""
        return self.reliable


def noise_finding(found: EstimatedNoise) -> Finding:
    """Return the note on a noise that is estimated.

    Where light varies little, photon and read noise cannot be told apart: their sum is given at the mean light,
    unless this is NaN.
    """
    noise, rounding, light = found
    more = f", and rounding ({percent(rounding)} of the variance)" if rounding > _TOLD_ROUNDING else ""
    white = f"white {'at least ' if rounding > MOSTLY_ROUNDING else ''}{noise.white:.4g}"
    numbers, total = noise.to_dict() | ({"rounding": rounding} if rounding else {}), ""
    if not math.isnan(light):
        electrons = float(np.mean(noise.white or 1.0))
        rms = math.sqrt(light * electrons + float(np.mean(np.square(noise.read)))) / electrons
        numbers |= {"light": light, "rms": rms}
        total = f", which are {rms:.2g} of white rms at the mean light, {light:.2g}, and are less certain each alone"
    text = (
        f"noise estimated from the images: {white}, read noise {noise.read:.3g} electrons{total}{more}; registration "
        "and noise are not tested"
    )
    return Finding("estimated_noise", "note", text, numbers)


def judge_frames(
    engine: FocalEngine,
    images: Values,
    valid: NDArray[np.bool_],
    errors: Values,
    misfit: Values,
    vergence: Array,
    lens_errors: tuple[float | None, float | None] = (None, None),
    noise: EstimatedNoise | None = None,
    *,
    excess: float = 1.0,
    included: bool = True,
) -> DefocusVerdict:
    """Return the verdict on images (channels, frames, height, width), in electrons at the exposure of frame 0.

    The other arrays are maps of shape (height, width): `valid` is True for known pixels, `vergence` is 1 / distance
    and `errors` are its standard errors in 1 / m, inf if depth is unknown. `lens_errors`
    are those stated of f-number and foci, `included` in standard errors or not, and `noise` is the noise estimated
    from the images, if none was stated, with `excess` times the variance of the finest details.
    """
    known = np.isfinite(errors)
    brightest = int(np.argmax(images[:, 0].mean(axis=(1, 2))))
    if known.sum() < MIN_BLOCKS * BLOCK**2:
        return DefocusVerdict.of(math.nan)
    known_vergence = vergence[known].astype(np.float64)
    # Depth is 1 / v at the vergence v: d(1 / v) = -dv / v^2.
    by_f_number, *by_foci = -engine.lens_derivatives(known_vergence) / known_vergence**2
    # A wrong f-number moves near and far depths in opposite directions: a median with signs may vanish.
    changes = 0.01 * float(np.median(np.abs(by_f_number))), 0.01 * float(np.median(np.sum(by_foci, axis=0)))
    # Inverse variances of depth.
    weight = np.where(known, 1.0 / np.maximum(errors, 1e-6) ** 2, 0.0)
    frames = partial(_tiles, images[brightest], valid, weight, engine)
    tiles = list(frames(1))
    median, judged = _judged_misfit(engine, brightest, tiles, vergence) or (float(np.median(misfit[known])), 1.0)
    ends = np.percentile(known_vergence, [95.0, 5.0])
    sizes = np.stack([1.0 / ends, engine.lens_errors(ends, *lens_errors) / ends**2], axis=1)
    lens_error = dict(zip(("nearest", "farthest"), sizes.tolist(), strict=True))
    in_doubt = excess * median > _DOUBTFUL_EXCESS if noise else median > _DOUBTFUL_MISFIT
    certain, undone = frame_magnifications(images[brightest], valid, engine.task.blur), math.nan
    likely = frame_magnifications(images[brightest], valid, 0.0) if in_doubt and not certain else ()
    # Wide blur may displace windows by more than noise does: only the misfit shows that a magnification is the cause.
    if noise is None and len(likely) == 2:
        resampled = _resampled(engine, images[brightest], valid, likely[1][0])
        undone, _ = _judged_misfit(engine, brightest, list(_tiles(*resampled, weight, engine, 1)), vergence) or (
            math.inf,
            0.0,
        )
        certain = likely if undone - 1.0 < _EXPLAINED * (median - 1.0) else ()
    certain, likely = (
        # Of frames as recorded, before they were resampled.
        np.multiply(found, np.reshape(engine.task.scales or 1.0, (-1, 1))).tolist() if found else []
        for found in (certain, likely)
    )
    stated = None if lens_errors == (None, None) else engine.scale_error(*lens_errors)
    make_verdict = partial(
        DefocusVerdict.of,
        median,
        changes=changes,
        judged=judged,
        stated=stated,
        lens_error=lens_error,
        included=included,
        noise=noise,
        excess=excess,
        shift=frame_shift(images[brightest], valid, engine.task.blur) if noise else (),
        magnifications=certain,
        undone=undone,
        likely=likely,
        exchanged=noise is None and median > _DOUBTFUL_MISFIT and _exchanged_agree(engine, brightest, tiles),
        one=_shared(engine, known_vergence, errors[known]),
    )
    if any(map(is_compressed, images[brightest])):
        return make_verdict(compressed=True)
    minima = _scale_minima(engine, brightest, next(frames(engine.binning), None), tiles, median if noise else 1.0)
    if not minima:
        return make_verdict()
    best, *others = minima
    if best.error >= max(_MAX_SCALE_ERROR, abs(best.scale - 1.0) / _WRONG_DEVIATION):
        return make_verdict()
    return make_verdict(best.scale, best.error, tuple(minimum.scale for minimum in others))


def _resampled(
    engine: FocalEngine, frames: Values, valid: NDArray[np.bool_], scale: float
) -> tuple[Values, NDArray[np.bool_]]:
    """Return two frames, the second resampled by a magnification, and the pixels that are known in both."""
    task = engine.task
    registered = Registration(scale, task.lenses, valid.shape, task.threads)
    seen = np.array(registered(list(frames), math.inf, valid.view(np.uint8)))
    known = np.isfinite(seen).all(axis=0) & valid
    return np.stack([fill_missing(frame, "nearest") for frame in seen]), known


def _shared(engine: FocalEngine, vergence: Array, errors: Values) -> str:
    """Return what two frames may share, "focus" or "aperture", as all depths are at equal blur; else ""."""
    lenses = engine.task.lenses
    if len(lenses) != 2:
        return ""
    # Blur radii are abs(slope (vergence - focus)), and equal between the foci.
    slopes = [
        lens.aperture_diameter * lens.sensor_distance / scale
        for lens, scale in zip(lenses, engine.task.scales or (1.0, 1.0), strict=True)
    ]
    foci = [1.0 / lens.focus_distance for lens in lenses]
    deviations = vergence - np.average(foci, weights=slopes)
    limits = errors + _ALIKE_ERROR * abs(foci[1] - foci[0])
    if (
        abs(np.median(deviations)) > _MAX_ALIKE * np.median(limits)
        or np.mean(np.abs(deviations) < 3.0 * limits) < _ALIKE_SHARE
    ):
        return ""
    return "aperture" if foci[0] == foci[1] else "focus"


def _exchanged_agree(engine: FocalEngine, channel: int, tiles: list[_Tile]) -> bool:
    """Return whether two frames agree with their lenses exchanged, and less as stated."""
    if not tiles or len(engine.task.lenses) != 2:
        return False
    given, other = (
        _median(np.stack([filters(tile) for tile in tiles]))
        for filters in (_Filters(engine, channel, 1.0, exchanged=exchanged) for exchanged in (False, True))
    )
    return other < min(_DOUBTFUL_MISFIT, given / _EXCHANGED_RATIO)


class _Minimum(NamedTuple):
    """A local minimum of the misfit as a function of the scale."""

    scale: float
    error: float  # standard error of the scale
    misfit: float
    step: int  # log(scale) / _LOG_STEP, rounded
    below: float  # misfit at this step minus the minimum


def _judged_misfit(
    engine: FocalEngine, channel: int, tiles: list[_Tile], vergence: Array
) -> tuple[float, float] | None:
    """Return the median misfit of blocks in which depth varies little, and their fraction; None for few blocks."""
    variation = _depth_variation(engine, vergence)
    block, misfits, predictions = BLOCK, list[Array](), list[Array]()
    for tile in tiles:
        misfit, curvature = _Filters(engine, channel, 1.0, vergence[tile.inside]).minimum(tile)
        parts = len(misfit), block, len(misfit), block
        prediction = curvature * variation[tile.inside].reshape(parts).mean(axis=(1, 3))
        examined = np.isfinite(misfit)
        misfits.append(misfit[examined])
        # Without a valley of the energy, the effect of slopes is not known.
        predictions.append(np.where(curvature > 0.0, prediction, math.inf)[examined])
    misfit, prediction = np.concatenate([*misfits, []]), np.concatenate([*predictions, []])
    if len(misfit) < MIN_BLOCKS:
        return None
    judged = prediction < _MAX_PREDICTED
    share = float(judged.mean())
    used = judged if share >= _MIN_JUDGED else np.isfinite(misfit)
    return float(np.median((misfit - np.where(judged, prediction, 0.0))[used])), share


def _smoothed(values: Array, known: NDArray[np.bool_], sigma: float) -> Array:
    """Return the mean of the known values in a Gaussian window around each pixel."""
    smooth = scipy.ndimage.gaussian_filter
    sums = smooth(np.where(known, values, 0.0), sigma)
    return np.asarray(sums / np.maximum(smooth(known.astype(values.dtype), sigma), 1e-6))


def squared_slopes(depth: Array, width: float) -> Array:
    """Return the squares of the slopes of a map, per pixel^2, smoothed by windows of an rms width."""
    down, across = np.gradient(_smoothed(depth, np.isfinite(depth), width))
    return np.asarray(down**2 + across**2)


def _depth_variation(engine: FocalEngine, vergence: Array) -> Array:
    """Return the variance of depth, in candidates^2, within the window and the blur of each pixel."""
    known, width = np.isfinite(vergence), WINDOW
    # Slopes around a pixel count as well: at creases and in the middle of an edge its own slope may vanish.
    squares = _smoothed(squared_slopes(vergence / engine.channels[0].step, width), known, 2.0 * width)
    # Radii of the geometric blur, in pixels: (aperture radius) (vergence - focus vergence) (sensor distance) / pitch.
    radii = [
        0.5 * lens.aperture_diameter * lens.sensor_distance / engine.task.pixel
        * (np.where(known, vergence, 0.0) - 1.0 / lens.focus_distance)
        for lens in engine.task.lenses
    ]  # fmt: skip
    return np.asarray(squares * (width**2 + _BLUR_SHARE * np.square(radii).mean(axis=0)))


def _scale_minima(
    engine: FocalEngine, brightest: int, rough: _Tile | None, tiles: list[_Tile], level: float
) -> list[_Minimum]:
    """Return the scales that fit equally well in the brightest channel, beginning with the best one.

    They are found in the binned tile `rough`. Aliases due to binning shift them by up to 8 %, and raise the misfit:
    they are refined in `tiles`, which are not binned. `level` is the misfit of right lenses: 1, or as measured if the
    noise is estimated.
    """
    if rough is None or len(_cells(np.stack([tile.variance for tile in tiles])[None])[1]) < _MIN_CELLS:
        return []
    rough, *tiles = (tile._replace(variance=level * tile.variance) for tile in (rough, *tiles))

    def filters(k: int, *, binned: bool) -> _Filters:
        return _Filters(engine, brightest, math.exp(_LOG_STEP * k), binned=binned)

    @cache
    def misfits(k: int) -> Array:
        filters_of_k = filters(k, binned=False)
        return np.stack([filters_of_k(tile) for tile in tiles])

    # The misfit may have several minima: other scales can fit with other signs of defocus, or with other depths.
    found: dict[int, float] = {}
    for way in (1, -1):
        for k in range(0, way * (_MAX_STEP + 1), way * _COARSE_STEP):
            if k not in found:
                found[k] = _median(filters(k, binned=True)(rough))
            # Once the misfit is this large, it increases with the distance from the stated scale.
            if found[k] > _MAX_MISFIT_RATIO * min(found.values()):
                break
    medians = [found.get(k, math.inf) for k in range(-_MAX_STEP, _MAX_STEP + 1, _COARSE_STEP)]
    limit = min(medians) + _EXCESS + _EXCESS_RATIO * abs(min(medians) - 1.0)
    minima = list[_Minimum]()
    for index in range(1, len(medians) - 1):
        median = medians[index]
        if median <= min(medians[index - 1], medians[index + 1], limit):
            minimum = _refine_minimum(misfits, _COARSE_STEP * index - _MAX_STEP)
            # A texture of one period has no valley of the energy at some scales, and misfits below 0 there.
            if (
                minimum is not None
                and minimum.misfit > 0.0
                and all(abs(minimum.scale - other.scale) > _LOG_STEP for other in minima)
            ):
                minima.append(minimum)
    minima.sort(key=lambda minimum: minimum.misfit)
    return [minimum for minimum in minima if minimum is minima[0] or _fits_equally(minimum, minima[0], misfits)]


def _fits_equally(minimum: _Minimum, best: _Minimum, misfits: Callable[[int], Array]) -> bool:
    """Return True if the misfits of two scales are equal within noise and model error."""
    cells, shares = _cells(np.stack([misfits(minimum.step), misfits(best.step)]))
    if len(shares) < _MIN_CELLS:
        return True
    weights = _weights(cells, shares)
    # Differences between the minima: the misfits at the nearest steps are corrected by `below`.
    differences = cells[0] - cells[1] - minimum.below + best.below
    mean = float(differences @ weights)
    error = float(np.sqrt((weights**2) @ (differences - mean) ** 2))
    return mean <= max(_WRONG_DEVIATION * error, _MISFIT_ERROR + _MISFIT_ERROR_RATIO * abs(best.misfit - 1.0))


def _refine_minimum(misfits: Callable[[int], Array], k: int) -> _Minimum | None:
    """Return the local minimum of the misfit near step `k`; None if there is no minimum."""
    visited = set[int]()
    offsets = np.arange(-2, 3)
    powers = np.vander(offsets, 4, increasing=True)
    while abs(k) < _MAX_STEP and k not in visited:
        visited.add(k)
        cells, shares = _cells(np.stack([misfits(k - 2), misfits(k), misfits(k + 2)]))
        if len(shares) < _MIN_CELLS:
            break
        before, middle, after = cells @ _weights(cells, shares)
        if not middle <= min(before, after):
            k += 2 if after < before else -2
            continue
        # A cubic is fitted to each cell. The mean cubic determines the minimum, the scatter of the slopes its error.
        cells, shares = _cells(np.stack([misfits(k + step) for step in offsets.tolist()]))
        weights = _weights(cells, shares)
        cubics = np.linalg.lstsq(powers, cells, rcond=None)[0]
        start, slope, bend, skew = (cubics @ weights).tolist()
        # At the minimum slope + 2 bend x + 3 skew x^2 = 0. The root with positive curvature, in a form without
        # cancellation, is x = -slope / (bend + sqrt(root)), root = bend^2 - 3 slope skew; the curvature is
        # 2 sqrt(root).
        root = bend**2 - 3.0 * slope * skew
        if not (bend > 0.0 and root > 0.0):
            break
        minimum = -slope / (bend + math.sqrt(root))
        if not abs(minimum) <= 2.0:
            break
        curvature = 2.0 * math.sqrt(root)
        min_misfit = float(np.array([minimum**n for n in range(4)]) @ cubics @ weights)
        # The standard error of the position of the minimum is (standard error of the slope) / curvature.
        cell_slopes = weights * (cubics[1] + minimum * (2.0 * cubics[2] + 3.0 * minimum * cubics[3]))
        systematic = _LOG_STEP * _SLOPE_ERROR_RATIO * abs(min_misfit - 1.0)
        scale = math.exp(_LOG_STEP * (k + minimum))
        scatter = math.hypot(float(np.sqrt((cell_slopes**2).sum())), systematic)
        # d(scale) = scale d(log scale).
        # Scales whose misfits differ by less than their systematic error are not told apart.
        alike = math.sqrt(2.0 * (_MISFIT_ERROR + _MISFIT_ERROR_RATIO * abs(min_misfit - 1.0)) / curvature)
        error = scale * math.hypot(_LOG_STEP * scatter / curvature, _LOG_STEP * alike, _MIN_SCALE_ERROR)
        return _Minimum(scale, error, min_misfit, k, start - min_misfit)
    return None


def _weights(cells: Array, shares: Array) -> Array:
    """Return the weights of cells: 0 for cells with a depth edge, where the misfit is large at every depth."""
    min_misfits = np.maximum(cells.min(axis=0), 1.0)
    weights = np.where(min_misfits <= _EDGE_RATIO * np.quantile(min_misfits, 0.25), shares / min_misfits**2, 0.0)
    return np.asarray(weights / weights.sum())


def _median(misfits: Array) -> float:
    """Return the median of the finite misfits; infinity if at most 2 % are finite."""
    known = np.isfinite(misfits)
    return float(np.median(misfits[known])) if known.mean() > 0.02 else math.inf


def _cells(misfits: Array) -> tuple[Array, Array]:
    """Return the mean misfit of each cell at each scale, (scales, cells), and the fraction of used blocks."""
    in_use = np.isfinite(misfits).all(axis=0)
    scales, tiles, blocks = misfits.shape[:3]
    parts = tiles, blocks // _CELL, _CELL, blocks // _CELL, _CELL
    counts = in_use.reshape(parts).sum(axis=(2, 4)).ravel()
    sums = np.where(in_use, misfits, 0.0).reshape(scales, *parts).sum(axis=(3, 5)).reshape(scales, -1)
    valid_cells = counts >= 0.25 * _CELL**2
    return sums[:, valid_cells] / counts[valid_cells], counts[valid_cells] / _CELL**2


class _Tile(NamedTuple):
    """A square of the frames: cosine transforms, and the noise variance of each block (NaN for unused blocks)."""

    inside: tuple[slice, slice]  # rows and columns of the frames
    spectra: Array  # (frames, side, side), for binned pixels
    variance: Array  # (blocks, blocks)


def _tiles(
    images: Values, valid: NDArray[np.bool_], weight: Array, engine: FocalEngine, binning: int
) -> Iterator[_Tile]:
    """Yield the tiles with the smallest standard errors of depth."""
    block = BLOCK
    side = min(_TILE_SIDE, *(length // (_CELL * block) * (_CELL * block) for length in valid.shape))
    blocks, reach = side // block, 2 * (math.ceil(engine.task.blur) + _MARGIN) + 1
    corners = [range(0, length - side + 1, side) if side else () for length in valid.shape]
    squares = [(slice(top, top + side), slice(left, left + side)) for top in corners[0] for left in corners[1]]
    squares.sort(key=lambda inside: -float(weight[inside].sum()))
    for inside in squares[:_MAX_TILES]:
        unusable = np.pad(~valid[inside], 1, constant_values=True)
        affected = scipy.ndimage.maximum_filter(unusable, reach, mode="nearest")
        usable = ~affected[1:-1, 1:-1] & (weight[inside] > 0.0)
        used_blocks = usable.reshape(blocks, block, blocks, block).mean(axis=(1, 3)) > 0.5
        if used_blocks.any():
            shape = len(images), side // binning, binning, side // binning, binning
            planes = images[(slice(None), *inside)].reshape(shape).sum(axis=(2, 4), dtype=np.float64)
            light = planes.mean(axis=0).reshape(blocks, block // binning, blocks, -1).mean(axis=(1, 3))
            variance = np.maximum(engine.window_means(light), 0.0) + (engine.light.read * binning) ** 2
            spectra = scipy.fft.dctn(planes, axes=(1, 2), norm="ortho")
            yield _Tile(inside, spectra, np.where(used_blocks, variance, np.nan))


class _Filters:
    """Residual filters for apertures whose diameters are multiplied by `scale`.

    Aberrations keep their waves at the edge: where they are stated, they are those of the aperture that is stated.

    With `vergence`, the map of one tile, the filters are exact, for the depths of this tile and one use: at half
    steps, of pixels without binning. A quartic through energies at whole steps, aliases due to binning, and
    interpolation between few frequencies raise the misfit of exact lenses by up to 0.9.
    """

    def __init__(
        self,
        engine: FocalEngine,
        channel: int,
        scale: float,
        vergence: Array | None = None,
        *,
        binned: bool = False,
        exchanged: bool = False,
    ) -> None:
        task, count, self._steps, self._binning = engine.task, _MIN_COUNT, 1, engine.binning if binned else 1
        lenses = [replace(lens, aperture_diameter=scale * lens.aperture_diameter) for lens in task.lenses]
        lenses = lenses[::-1] if exchanged else lenses
        places, chunk = task.vergence, len(task.vergence)
        if vergence is not None:
            start, step = float(places[0]), float(places[1] - places[0])
            ends = (np.nanpercentile(vergence, [1.0, 99.0]) - start) / step + [-_REACH, _REACH]
            first, last = np.clip(np.rint(2.0 * ends), 0, 2 * len(places) - 2).astype(int).tolist()
            places, chunk, self._steps = start + 0.5 * step * np.arange(first, last + 1), _CHUNK, 2
        if not binned:
            # Transfer functions oscillate with a period of 1 / (2 blur) in cycles per pixel.
            count = min(max(_MIN_COUNT, math.ceil(_COUNT_PER_PIXEL * task.blur)), _TILE_SIDE)

        def filters() -> Iterator[Array]:
            for k in range(0, len(places), chunk):
                part = task._replace(vergence=places[k : k + chunk])
                model = part.model(engine.light, channel, self._binning, lenses, count=count)
                yield from residual_filters(model)[..., model.band.places()]

        self._engine, self._white = engine, engine.light.relative_variances()
        self._filters = filters() if self._steps > 1 else tuple(filters())

    def __call__(self, tile: _Tile) -> Array:
        """Return the misfit of each block; NaN for unused blocks, and where the minimum is at an end of the range."""
        return self.minimum(tile)[0]

    def minimum(self, tile: _Tile) -> tuple[Array, Array]:
        """Return the misfit of each block, and half its second derivative by the index of the candidate."""
        blocks, side = len(tile.variance), tile.spectra.shape[1]
        all_energies, all_noise = list[Array](), list[float]()
        for pairs in self._filters:
            # A tile has other frequencies than the filters, which are therefore interpolated linearly.
            count = pairs.shape[-1]
            positions = np.clip(np.arange(side) * (count / side) - 0.5, 0.0, count - 1.0)
            interpolation = np.maximum(0.0, 1.0 - np.abs(positions[:, None] - np.arange(count)))
            filters = interpolation @ pairs @ interpolation.T
            residuals = scipy.fft.idctn((filters * tile.spectra).sum(axis=1), axes=(1, 2), norm="ortho")
            energy = (residuals**2).sum(axis=0).reshape(blocks, side // blocks, blocks, -1).mean(axis=(1, 3))
            all_noise.append(float((filters**2).mean(axis=(2, 3)).sum(axis=0) @ self._white))
            # The energy expected of noise is the mean square of the filters times the variance of each frame.
            all_energies.append(self._engine.window_means(energy) / tile.variance - all_noise[-1])
        energies, noise = np.stack(all_energies), np.array(all_noise)
        # If the lowest energy is at an end of the range, the minimum may lie outside the range.
        lowest = np.argmin(np.nan_to_num(energies, nan=math.inf), axis=0)
        inner = np.clip(lowest, 2, len(energies) - 3)
        neighbours = np.stack([np.take_along_axis(energies, inner[None] + k, axis=0)[0] for k in range(-2, 3)])
        energy, curvature = _minimise_quartic(neighbours)
        misfit = 1.0 + (energy + self._engine.mean_excess(self._binning)) / noise[inner]
        return np.where(lowest == inner, misfit, np.nan), self._steps**2 * curvature / noise[inner]


def _minimise_quartic(energies: Array) -> tuple[Array, Array]:
    """Return the minimum of the quartic through five energies, at most one candidate from the third, and a[2]."""
    # Filters are nearly quadratic in the vergence over five candidates; energies, their squares, are quartic.
    a = np.tensordot(np.linalg.inv(np.vander(np.arange(-2.0, 3.0), increasing=True)), energies, axes=1)
    position = np.zeros(energies.shape[1:])
    for _ in range(_NEWTON_STEPS):
        slope = a[1] + position * (2.0 * a[2] + position * (3.0 * a[3] + position * 4.0 * a[4]))
        bend = 2.0 * a[2] + position * (6.0 * a[3] + position * 12.0 * a[4])
        # The clip keeps Newton steps within the interpolation.
        position = np.clip(position - slope / np.maximum(bend, 1e-30), -1.0, 1.0)
    return a[0] + position * (a[1] + position * (a[2] + position * (a[3] + position * a[4]))), a[2]
