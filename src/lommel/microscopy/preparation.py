"""Preparation of a stack for its deconvolution: noise, voxels to leave out, direction of z, compared PSFs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import cast

import numpy as np
from numpy.typing import NDArray

from lommel.base.arrays import Values
from lommel.base.units import with_error
from lommel.fit.findings import Finding
from lommel.microscopy.depth_model import DepthModel, GivenPSF
from lommel.microscopy.held_out import MAX_VOXELS, SIDE, HeldOut, held_out_background
from lommel.microscopy.refinement import Progress, StackContext, estimate_z_direction
from lommel.recorded.camera_noise import (
    MAX_HOT_FRACTION,
    StackView,
    contradiction,
    hot_pixel_findings,
    hot_pixels,
    hot_voxels,
    measured_noise,
    sharpness,
)
from lommel.recorded.counts import Stack, full_value, plane_of
from lommel.recorded.noise import Noise

_DARK_FRACTION = 0.02  # fraction of voxels darker than the offset above which a note is added


@dataclass
class Remarks:
    """Notes on what was assumed and estimated, and findings of checks."""

    notes: list[str]
    findings: list[Finding] = field(default_factory=list)

    @property
    def doubts(self) -> tuple[str, ...]:
        """Codes of the findings of severity "doubt"."""
        return tuple(finding.code for finding in self.findings if finding.severity == "doubt")


def prepared(
    stack: Stack,
    model: DepthModel | GivenPSF,
    noise: Noise | None,
    remarks: Remarks,
    mask: NDArray[np.bool_] | None = None,
    *,
    saturation: float | None = None,
    threads: int = 0,
    complete: bool = True,
) -> tuple[StackContext, Remarks]:
    """Return a stack without saturated, masked or hot voxels, with its noise; and the remarks, which are added to.

    Stated noise is compared with a `complete` stack: missing chunks count as dark.
    """
    limit = _saturation_limit(stack, saturation, remarks.notes)
    if mask is not None:
        mask = np.broadcast_to(mask, stack.shape)
        masked = StackView(stack, limit, mask=mask)
        stack, limit = masked, masked.limit
        count = int(mask.sum())
        remarks.notes.append(f"{count} voxels ({100.0 * count / mask.size:.2g} %) are masked, and were left out.")
    if noise is None:
        noise, error = measured_noise(stack)
        gain = 1.0 if noise.white is None else float(noise.white)
        remarks.notes.append(
            f"The noise was estimated from the stack: {' +- '.join(with_error(gain, gain * error))} electrons per "
            f"count and an offset of {float(noise.offset):.4g} counts; a read noise of {float(noise.read):g} "
            "electrons was assumed."
        )
    else:
        noise.require_shape(stack.shape)
        if complete:
            _check_noise(stack, noise, remarks.notes)
    return _without_hot(StackContext(stack, model, noise, limit, threads), remarks), remarks


def _saturation_limit(stack: Stack, saturation: float | None, notes: list[str]) -> float:
    """Return the smallest value of saturated voxels, infinity if there are none."""
    planes = range(len(stack))
    if stack.dtype.kind not in "iu" and (
        nonfinite := sum(int((~np.isfinite(stack[plane])).sum()) for plane in planes)
    ):
        if nonfinite == math.prod(stack.shape):
            raise ValueError("stack must have voxels that are known, got only NaN and infinite values")
        notes.append(f"{nonfinite} voxels are NaN or infinite, and were left out.")
    limit, assumed = full_value(cast("Sequence[Values]", stack), saturation, name="voxels")
    count = sum(int((np.asarray(stack[plane]) >= limit).sum()) for plane in planes)
    if assumed:
        notes.append(f"{assumed[0].upper()}{assumed[1:]}. Record with less light or a shorter exposure.")
    elif count:
        bound = "the saturation that was stated" if saturation is not None else "the maximum of their type"
        share = 100.0 * count / math.prod(stack.shape)
        notes.append(f"{count} voxels ({share:.2g} %) have {bound}, {limit:g}, or more, and were left out.")
    return limit


def _check_noise(stack: Stack, noise: Noise, notes: list[str]) -> None:
    """Add a note if the stack contradicts the noise that the user stated."""
    # Three standard deviations of the read noise and of rounding to integers (about 0.3 counts).
    floor = noise.offset - 3.0 * np.hypot(noise.read / (1.0 if noise.white is None else noise.white), 0.3)
    dark_count, darkest_value = 0, math.inf
    for plane in range(len(stack)):
        values = plane_of(stack, plane)
        dark_count += int((values < floor).sum())
        if not np.isnan(values).all():
            darkest_value = min(darkest_value, float(np.nanpercentile(values, 1.0)))
    share = dark_count / math.prod(stack.shape)
    if share > _DARK_FRACTION:
        notes.append(
            f"{100.0 * share:.2g} % of the voxels are below the offset by more than the read noise explains, and "
            f"count as dark. Check the `offset` of the noise: the darkest voxels have {darkest_value:.4g} counts."
        )
    elif note := contradiction(stack, noise):
        notes.append(note)


def _without_hot(context: StackContext, remarks: Remarks) -> StackContext:
    """Leave out hot pixels and voxels."""
    stack, limit = context.stack, context.saturation
    sharpest = sharpness(context.model.point_image())
    pixels = hot_pixels(stack, context.camera, sharpest, limit)
    if found := hot_pixel_findings(pixels):
        remarks.findings += found
        stack = StackView(stack, limit, mask=pixels)
        limit = stack.limit
    hot = hot_voxels(stack, context.camera, sharpest, limit)
    fraction = len(hot) / math.prod(stack.shape)
    subject = f"{len(hot)} voxels ({100.0 * fraction:.2g} %) exceed their neighbours by more than the PSF allows"
    numbers = {"voxels": len(hot), "share": fraction}
    if fraction > MAX_HOT_FRACTION:
        text = f"{subject}, in single planes: they were not left out; check pixel, wavelength and NA"
        remarks.findings.append(Finding("hot_pixels", "doubt", text, numbers))
    elif fraction > 0.0:
        text = f"{subject}, in single planes: they were classified as cosmic rays or blinking pixels, and left out"
        remarks.findings.append(Finding("hot_pixels", "note", text, numbers))
        stack = StackView(stack, limit, voxels=hot)
        limit = stack.limit
    return context._replace(stack=stack, saturation=limit)


def oriented(
    context: StackContext, crop: tuple[slice, slice], direction: str, notes: list[str], report: Progress
) -> StackContext:
    """Reverse the planes where the first one is the farthest from the cover glass."""
    if isinstance(context.model, GivenPSF):
        return context
    if direction == "auto":
        direction, note = estimate_z_direction(context, crop, report)
        notes.append(note)
    if direction == "up":
        return context
    # Results are reversed again at the end.
    stack = StackView(context.stack, context.saturation, is_reversed=True)
    return context._replace(stack=stack, model=replace(context.model, is_reversed=True))


def compare_held_out(
    context: StackContext,
    margin: tuple[int, int],
    findings: list[Finding],
    report: Progress,
    *,
    flat: bool,
    pixel_doubt: str,
    steps: int | None = None,
) -> tuple[float | None, int, HeldOut | None]:
    """Compare PSFs by held-out photons, unless `steps` are those that an earlier time point took.

    Return the background level where a `flat` one is estimated from them, else None; the number of steps after which
    the result agrees best with them, 0 if it is not known; and the comparison. `pixel_doubt` is a sentence on the
    pixel.
    """
    model, estimate = context.model, flat and math.prod(context.stack.shape) <= MAX_VOXELS
    if steps is not None and not estimate:
        return None, steps, None
    if isinstance(model, GivenPSF):
        if not (estimate and model.is_contained):
            return None, 0, None
        return *held_out_background(context, model, margin), None
    # Estimate the background from the whole stack: a part also contains light blurred into it from outside.
    side = max(context.stack.shape[1:])
    comparison = HeldOut(context, report)
    if comparison.is_uniform:
        text = "a flat scene explains the brightest part of the stack: other PSFs were not compared"
        findings.append(Finding("untested", "note", text))
        return None, 0, comparison
    if steps is None and (finding := comparison.finding()):
        if finding.code == "psf_doubtful" and pixel_doubt:
            finding = replace(finding, text=f"{finding.text} ({pixel_doubt.removesuffix('.')})")
        findings.append(finding)
    if not estimate:
        return None, comparison.best.steps, comparison
    whole = comparison if side <= SIDE else HeldOut(context, report, side=side)
    return whole.level(), whole.best.steps, comparison
