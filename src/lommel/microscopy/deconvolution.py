"""Deconvolution of a stack of planes that a microscope recorded."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.units import percent
from lommel.deconvolve.algorithms import ProgressCallback, Restoration, RichardsonLucy, TotalVariation, shown, silent
from lommel.deconvolve.iterations import Background, State, iteration_of
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.fit.findings import Finding, Findings
from lommel.measures.spot import stage
from lommel.microscopy.depth_model import narrowed, spline_degrees
from lommel.microscopy.held_out import MAX_VOXELS, Best, Halves, highest_level, stopping_rule
from lommel.microscopy.stack_blur import TiledBlur, kernel_of
from lommel.psf import PSF
from lommel.recorded.counts import LARGEST, Stack, counts_of, plane_of
from lommel.recorded.frames import Frames
from lommel.recorded.noise import Noise

FLAT = "flat"
_BACKGROUNDS = {FLAT: 1, "uneven": 3}  # points along each side of the field at which levels are estimated

_FLOOR_BLOCK = 8  # side, pixels, of the blocks whose means show the floor of the restored light
_FLOOR_REGIONS = 3  # regions along each side of the field, each with a floor of its own
_FLOOR_PERCENTILE = 10.0  # of the means of the blocks of a region, which is the floor
# Largest share of the floor in the light: below 0.02 in simulations with flat backgrounds, 0.18 with an uneven one.
_MAX_FLOOR = 0.05

# Least change of the light along the stack that is named: over that of the specimen, over that of all, and over its
# standard error; and the least number of planes.
_FADING, _FADING_OF_ALL, _FADING_SIGMAS, _FADING_PLANES = 0.1, 0.01, 3.0, 5
_FADING_LEFT_OUT = 0.02  # largest share of the light in pixels that are unknown in some planes

_LEAST_PLANES = 8  # smallest default margin, planes, unless half of the PSF has fewer
_RIM = 0.02  # fraction of the light of a PSF on the rim of its window above which the light cone counts as cut off


def deconvolve(
    stack: ArrayLike | Frames,
    psf: PSF,
    noise: Noise,
    *,
    method: RichardsonLucy | TotalVariation | None = None,
    background: float | str = "flat",
    margin: tuple[int, int] | None = None,
    saturation: float | None = None,
    diagnosis: bool = True,
    progress: ProgressCallback | None = None,
) -> Restoration:
    """Deconvolve a stack of planes recorded by a microscope, with its PSF and noise (3-D deconvolution).

    Parameters
    ----------
    stack : array_like, shape (planes, height, width), or Frames of one channel
        Recorded stack, in the unit of `noise`: integers or floats; NaN, infinite and masked values are ignored.
    psf : PSF
        PSF, as in :class:`lommel.microscopy.StackBlur`, with the step, pixels and direction of z of the recording.
        Its planes and window must contain the cone of light: beyond them the PSF is assumed to be dark. Values are
        divided by their sum, so that light is conserved.
    noise : Noise
        Noise of the values of `stack`; maps per pixel apply to each plane.
    method : RichardsonLucy or TotalVariation, optional
        By default ``lm.imaging.RichardsonLucy(target=1.0)``: a lower target, as for photographs, would amplify noise
        where the PSF is much wider than a voxel. ``lm.imaging.TotalVariation(target=1.0)`` preserves edges, with
        gradients in three dimensions, all per pixel.
    background : "flat", "uneven" or float, default "flat"
        Light per voxel that is not from the specimen, in the unit of `stack` without the offset of its noise; the
        restored values exclude it. A number is a known level, 0 for none. Otherwise the background is estimated with
        the specimen: "flat" is one level for the whole stack, "uneven" a level at each of 3 x 3 points of the field,
        with linear interpolation between them.
    margin : (int, int), optional
        Number of planes and pixels restored beyond each face of the recording, to account for light from outside. By
        default half of the planes and pixels of the PSF, and at most ``max(8, planes // 4)`` planes. Planes beyond
        the margin are assumed to equal the outermost plane; pixels beyond the margin are assumed to be dark.
    saturation : float, optional
        Smallest value, in the unit of `stack`, of saturated voxels, which are ignored. By default the largest value
        of the integer type, or of 8 to 16 bits if many voxels have it.
    diagnosis : bool, default True
        Whether to hold out some photons, as :func:`lommel.microscopy.restore` does, to estimate a flat background
        and, for a target of 1 or more, the number of steps. This takes about 80 more steps. It is omitted for more
        than 500 000 voxels, or more than 2 % of the light of the PSF on the rim of its window. Without held-out
        photons uniform light counts as specimen, except for the light of the darkest parts.
    progress : callable, optional
        Called at each step, as in :func:`lommel.imaging.restore_with`.

    Returns
    -------
    Restoration
        `values` and `light` are float32, of the shape and unit of the stack, without the offset of its noise.
        `by_channel` is the discrepancy of each plane, `background` the level that the values exclude. `stopped`
        states a misfit. A point that sends F photons into each plane has the value ``F * psf.values.sum()``, its
        light in the window of the PSF. If the window does not contain all light, this is less than F times the number
        of planes, the value that :func:`lommel.microscopy.restore` returns.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range; if all values of `stack` are unknown.

    Notes
    -----
    Steps are as in :class:`lommel.imaging.RichardsonLucy`, on all processors. In addition to the stack, they need
    memory for three float32 stacks with margin, approximately, and for one stack without. Total variation needs a
    fourth stack: its steps have a closed form for each voxel, and no step raises the objective (De Pierro 1995,
    doi:10.1109/42.370409). If voxels are small enough, and at most 2 % of the light of the PSF is on the rim of its
    window, voxels of the specimen are B-splines of degree 2 or 3 instead of points. Positive voxels then have the
    same image as a point anywhere between them (Magain et al. 1998, doi:10.1086/305187).
    """
    validation.optional("method", method, RichardsonLucy, TotalVariation)
    voxels = stack.only_channel("stack") if isinstance(stack, Frames) else stack
    counts = counts_of("stack", voxels, sides=(3,), shape="(planes, height, width)", saturation=saturation)
    recorded = counts.marked()
    validation.instance("psf", psf, PSF)
    validation.instance("noise", noise, Noise).require_shape(recorded.shape)
    default_margins = min(psf.shape[0] // 2, max(_LEAST_PLANES, recorded.shape[0] // 4)), max(psf.grid.shape) // 2
    planes, pixels = default_margins if margin is None else margins_of(margin)
    level = background_of(background)
    validation.truth("diagnosis", diagnosis)
    counted = PoissonLikelihood(recorded, noise)
    shape = recorded.shape[0], recorded.shape[1], recorded.shape[2]
    light, point = kernel_of(psf)
    # Points may lie between voxels: voxels are B-splines, as wide as the PSF allows. A PSF that is cut off at the rim
    # of its window has no such splines.
    rim = 1.0 - float(light[:, 1:-1, 1:-1].sum())
    is_contained = rim < _RIM
    kernel = narrowed(light, *spline_degrees(light)) if is_contained else light, point

    def blur_of() -> TiledBlur:
        return TiledBlur([kernel], shape, (planes, pixels))

    blur = blur_of()
    before = counted.mean(counted.discrepancies(blur, counted.scene(planes, pixels)))
    pupil: Any = psf.pupil
    # Pixel size in the sample divided by the step: the factor of differences along z in the total variation.
    aspect = float(psf.grid.side / pupil.magnification / np.diff(stage(psf))[0])
    algorithm = method or RichardsonLucy(target=1.0)
    held_out = 0
    # Photons are held out only of stacks that are small enough, and that a uniform scene does not fit.
    is_structured = counted.flat() > 1.0 + counted.slack
    is_testable = recorded.size <= MAX_VOXELS and is_structured
    if diagnosis and is_contained and is_testable and level == Background(None):
        level, held_out = _held_out(recorded, noise, blur_of)
    iteration = iteration_of(algorithm, blur, counted, background=level, aspect=aspect)
    iteration.enough = stopping_rule(algorithm, held_out, counted)
    with shown(progress) as report:
        steps, stopped, by_plane = iteration.solve(algorithm, report)
    values, discrepancy = iteration.inside(planes, pixels), counted.mean(by_plane)
    finding = counted.finding(stopped, steps, discrepancy)
    if finding is not None:
        stopped = f"misfit: {finding}"
    findings = [] if finding is None else [finding]
    floor = Floor()
    floor.add(values, slice(0, shape[1]), slice(0, shape[2]))
    if is_structured and (uneven := floor.finding(shape, background_of(background))):
        findings.append(uneven)
    plane_light = light.sum(axis=(1, 2))
    if is_structured and plane_light.min() > 0.9 * plane_light.max():
        findings += plane_light_findings(recorded, noise, float(np.mean(counted.background)))
    if not is_contained:
        text = (
            f"{percent(rim)} of the light of the PSF is on the rim of its window, which cuts off its light cone: "
            "light beyond it counts as background or as uniform specimen; use a wider window, or microscopy.restore"
        )
        findings.append(Finding("untested", "note", text, {"rim": rim, "most": _RIM}))
    unknown = 1.0 - float(counted.known.sum()) / recorded.size
    return Restoration(
        values, values, discrepancy, tuple(map(float, by_plane)), before, steps, stopped, iteration.strength, unknown,
        background=counted.background, findings=Findings(findings),
    )  # fmt: skip


def plane_light_findings(
    stack: Stack, noise: Noise, background: float, limit: float = np.inf, *, reverse: bool = False
) -> list[Finding]:
    """Return the finding if the light of the planes of a wide-field stack rises or falls along z, else nothing.

    Without absorption every plane of a wide-field stack has the same light (the missing cone of the transfer
    function), unless the specimen fades, or light crosses the edges of the frame. A restoration fits such a stack,
    too: light beyond the first or last plane makes up for the difference. Values of `limit` or more are unknown;
    planes are numbered from the other end if `reverse`.
    """
    # Only pixels that are known in every plane: what is left out of some would itself change the light of these.
    # Planes are read twice, one by one: a stack may be larger than the memory.
    number, known, light_of_pixels = len(stack), np.ones(stack.shape[1:], bool), np.zeros(stack.shape[1:])
    if number < _FADING_PLANES:
        return []
    for k in range(number):
        plane = plane_of(stack, k)
        valid = np.isfinite(plane) & (plane < limit)
        known &= valid
        light_of_pixels += np.where(valid, plane - noise.offset - background, 0.0)
    left_out = float(light_of_pixels[~known].sum() / max(light_of_pixels.sum(), 1e-300))
    if not known.any() or left_out > _FADING_LEFT_OUT:
        text = (
            "it was not tested whether the light of the planes falls or rises along the stack, since bright pixels "
            "are saturated or unknown in some of them"
        )
        return [Finding("plane_light", "note", text, {"left_out": left_out, "most": _FADING_LEFT_OUT})]
    light = np.array([(plane_of(stack, k) - noise.offset)[known].mean(dtype=np.float64) for k in range(number)])
    light -= background
    # A parabola has the light that leaves the frame far from focus; its slope in the middle is the change along z.
    z = np.linspace(-0.5, 0.5, number)
    terms = np.stack([np.ones(number), z, z**2 - (z**2).mean()])
    (mean, change, _), (misfit, *_), *_ = np.linalg.lstsq(terms.T, light, rcond=None)
    error = float(np.sqrt(misfit / (number - 3) / (z**2).sum()))
    total = mean + background
    if total <= 0.0 or abs(change) < max(_FADING * mean, _FADING_OF_ALL * total, _FADING_SIGMAS * error):
        return []
    share = float(-change if reverse else change) / total
    text = (
        f"the light of the planes {'falls' if share < 0.0 else 'rises'} by {percent(abs(share))} from the first to "
        "the last: light may cross the edges of the frame, or the specimen fade or the lamp change, of which the "
        "restored light would be wrong; which of them was not tested: record the first plane again after the stack, "
        "and compare"
    )
    return [Finding("plane_light", "note", text, {"change": share, "least": _FADING})]


class Floor:
    """The floor of the light of a specimen that was restored chunk by chunk: of its darkest blocks.

    A background that varies over the field, where a flat one is estimated, is restored in part as such a floor.
    """

    def __init__(self) -> None:
        self._means: list[tuple[Array, Array, Values]] = []  # rows, columns (block centres), and means of blocks
        self._light = self._voxels = 0.0

    def add(self, restored: Values, rows: slice, columns: slice) -> None:
        """Add a restored chunk (planes, height, width) at `rows` and `columns` of the field."""
        self._light += float(restored.sum(dtype=np.float64))
        self._voxels += restored.size
        edges = [np.linspace(0, side, max(side // _FLOOR_BLOCK, 1) + 1).astype(int) for side in restored.shape[1:]]
        sums = np.add.reduceat(np.add.reduceat(restored, edges[0][:-1], axis=1), edges[1][:-1], axis=2)
        down, across = (
            at.start + 0.5 * (edge[1:] + edge[:-1]) for at, edge in zip((rows, columns), edges, strict=True)
        )
        self._means.append((down, across, sums / np.outer(np.diff(edges[0]), np.diff(edges[1]))))

    def finding(self, shape: tuple[int, ...], background: Background) -> Finding | None:
        """Return the finding if an estimated `background` left a floor of more than _MAX_FLOOR of the light."""
        if background.level is not None or not self._light > 0.0 or (share := self._share(*shape[-2:])) <= _MAX_FLOOR:
            return None
        advice = 'background="uneven" estimates' if background.points == 1 else "a background in the offset removes"
        text = (
            f"{percent(share)} of the restored light is a floor between the structures, in part of the field: a "
            "specimen that fills it, light from outside of a small crop, or a background that is not flat, which "
            f"{advice}"
        )
        return Finding("uneven_background", "doubt", text, {"share": share, "most": _MAX_FLOOR})

    def _share(self, height: int, width: int) -> float:
        """Return the share of the light in the floor: the darkest blocks in each of 3 x 3 regions of the field."""
        floors = []
        for i in range(_FLOOR_REGIONS):
            for j in range(_FLOOR_REGIONS):
                values = [
                    means[:, _region(down, height, i)][:, :, _region(across, width, j)].ravel()
                    for down, across, means in self._means
                ]
                region = np.concatenate(values)
                if region.size:
                    floors.append(float(np.percentile(region, _FLOOR_PERCENTILE)))
        return float(np.mean(floors)) * self._voxels / self._light


def _region(centres: Array, side: int, number: int) -> NDArray[np.bool_]:
    """Return which block centres are in a region, one of _FLOOR_REGIONS equal parts of a side of the field."""
    return np.asarray(np.minimum((centres * _FLOOR_REGIONS / side).astype(int), _FLOOR_REGIONS - 1) == number)


def _held_out(recorded: Values, noise: Noise, blur: Callable[[], TiledBlur]) -> tuple[Background, int]:
    """Return the flat background and the number of steps, estimated from held-out photons."""
    halves = Halves(recorded, noise.poisson)

    def continue_iteration(background: Background, start: State, steps: int) -> Best:
        return halves.deconvolve_half(blur(), silent, background=background, start=start, steps=steps)

    joint = halves.deconvolve_half(blur(), silent)
    return Background(highest_level(joint, continue_iteration)), joint.steps


def margins_of(argument: tuple[int, int]) -> tuple[int, int]:
    """Return the planes and pixels of a margin; TypeError or ValueError if they are no such pair."""
    if not isinstance(argument, tuple | list) or len(argument) != 2:
        raise ValueError(f"margin must be (planes, pixels), got {validation.shown(argument)}")
    planes, pixels = (validation.integer("margin", side, least=0, most=validation.MAX_SIDE) for side in argument)
    return planes, pixels


def background_of(argument: float | str) -> Background:
    """Return the background: a known level, or the number of points at which it is estimated."""
    if isinstance(argument, str):
        if argument not in _BACKGROUNDS:
            raise ValueError(
                f'background must be "flat", "uneven", or the light of each voxel, 0 for none, got {argument!r}'
            )
        return Background(None, _BACKGROUNDS[argument])
    return Background(validation.real("background", argument, least=0.0, most=LARGEST))
