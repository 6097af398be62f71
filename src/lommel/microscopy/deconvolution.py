"""Deconvolution of a stack of planes that a microscope recorded."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Values
from lommel.base.units import percent
from lommel.deconvolve.algorithms import ProgressCallback, Restoration, RichardsonLucy, TotalVariation, shown, silent
from lommel.deconvolve.iterations import Background, State, iteration_of
from lommel.deconvolve.poisson_counts import PoissonCounts
from lommel.fit.findings import Finding, Findings
from lommel.measures.spot import stage
from lommel.microscopy.depth_model import narrowed, spline_degrees
from lommel.microscopy.held_out import WHOLE, Best, Halves, enough, highest_level
from lommel.microscopy.stack_blur import TiledBlur, kernel_of
from lommel.psf import PSF
from lommel.recorded.counts import Counts
from lommel.recorded.noise import Noise
from lommel.recorded.recordings import Recording

FLAT = "flat"
_BACKGROUNDS = {FLAT: 1, "uneven": 3}  # points along each side whose levels are estimated

_LEAST_PLANES = 8  # least margin in planes, where the PSF has that many
_RIM = 0.02  # of the light, on the outermost pixels of the PSF's window: with more, the cone is cut off


def deconvolve(
    stack: ArrayLike | Recording,
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
    stack : array_like, shape (planes, height, width), or Recording of one channel
        Recorded stack, in the unit of `noise`: integers or floats; NaN, infinite and masked values are left out.
    psf : PSF
        As of :class:`lommel.microscopy.StackBlur`, with the step, pixels and direction of z of the recording. Its
        planes and window must hold the cone of light: beyond them it is taken to be dark. Values are divided by their
        sum, so that light is conserved.
    noise : Noise
        Noise of the values of `stack`; maps per pixel apply to each plane.
    method : RichardsonLucy or TotalVariation, optional
        By default ``lm.imaging.RichardsonLucy(target=1.0)``: a lower target, as for photographs, would amplify noise
        where the PSF is much wider than a voxel. ``lm.imaging.TotalVariation(target=1.0)`` preserves edges, with
        gradients in three dimensions, those along z per pixel, too.
    background : "flat", "uneven" or float, default "flat"
        Light of each voxel that is not of the specimen, in the unit of `stack` without the offset of its noise. It is
        estimated with the specimen: one level for the whole stack, or, of "uneven", one at each of 3 x 3 points of
        the field, with linear interpolation. Or a known level, 0 for none. It is no part of the values.
    margin : (int, int), optional
        Number of planes and pixels restored beyond each face of the recording, to account for light from outside; by
        default half of those of the PSF, and at most a quarter as many planes as the stack has, or 8. Planes farther
        away are taken to be like the outermost one, pixels to be dark.
    saturation : float, optional
        Values from here on, in the unit of `stack`, are saturated and left out. By default the largest value of
        integers, and where many voxels are full, that of 8 to 16 bits.
    diagnosis : bool, default True
        Whether some photons are held out, as :func:`lommel.microscopy.restore` does, to find a flat background, and
        when to stop where the target is 1 or more: of stacks of up to 500 000 voxels, in some 80 more steps. Without,
        of larger stacks, and where more than 2 % of the light of the PSF is on the rim of its window, all light that
        has no detail counts as specimen but for that of the darkest parts.
    progress : callable, optional
        As of :func:`lommel.imaging.restore_with`.

    Returns
    -------
    Restoration
        Its `values` are float32, of the shape and unit of the stack, without the offset of its noise, like its
        `light`; `by_channel` is the discrepancy of each plane, `background` the level that is no part of the values.
        `stopped` states a misfit. A point that sends F photons into each plane has ``F * psf.values.sum()``, those in
        the window of the PSF. Where that does not hold all light it is less than F times the planes, which
        :func:`lommel.microscopy.restore` finds.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range; if `stack` has no value that is known.

    Notes
    -----
    The steps of :class:`lommel.imaging.RichardsonLucy`, on as many threads as there are processors. Memory besides
    the stack: about three times that of the stack with its margin in float32, and once its own. With total variation
    it is once more: steps are in closed form for each voxel, and none raises the objective (De Pierro 1995,
    doi:10.1109/42.370409). Where planes and pixels are narrow enough for it, and no more than 2 % of the light of the
    PSF is on the rim of its window, the light of a point is spread over the nearest voxels as a B-spline of degree 2
    or 3, as wherever it lies between them its image is then one of positive voxels (Magain et al. 1998,
    doi:10.1086/305187).
    """
    validation.optional("method", method, RichardsonLucy, TotalVariation)
    given = stack.only("stack") if isinstance(stack, Recording) else stack
    counts = Counts.of("stack", given, sides=(3,), shape="(planes, height, width)", saturation=saturation)
    recorded = counts.marked()
    validation.instance("psf", psf, PSF)
    validation.instance("noise", noise, Noise).require_shape(recorded.shape)
    usual = min(psf.shape[0] // 2, max(_LEAST_PLANES, recorded.shape[0] // 4)), max(psf.grid.shape) // 2
    asked = usual if margin is None else margin
    if not isinstance(asked, tuple | list) or len(asked) != 2:
        raise ValueError(f"margin must be (planes, pixels), got {validation.shown(margin)}")
    level = background_of(background)
    planes, pixels = (validation.integer("margin", side, least=0, most=validation.MAX_SIDE) for side in asked)
    validation.truth("diagnosis", diagnosis)
    counted = PoissonCounts(recorded, noise)
    shape = recorded.shape[0], recorded.shape[1], recorded.shape[2]
    light, point = kernel_of(psf)
    # Points are anywhere between voxels: the light of each is a B-spline, as wide as the PSF lets it be. One that
    # ends at the rim of its window, as no light does, has no such splines there.
    rim = 1.0 - float(light[:, 1:-1, 1:-1].sum())
    whole = rim < _RIM
    kernel = narrowed(light, *spline_degrees(light)) if whole else light, point

    def blur_of() -> TiledBlur:
        return TiledBlur([kernel], shape, (planes, pixels))

    blur = blur_of()
    before = counted.mean(counted.discrepancies(blur, counted.scene(planes, pixels)))
    pupil: Any = psf.pupil
    # Planes over pixels in the sample: the total variation takes differences along z in proportion.
    aspect = float(psf.grid.side / pupil.magnification / np.diff(stage(psf))[0])
    way = method or RichardsonLucy(target=1.0)
    held_out = 0
    # Photons are held out of stacks that fit in memory, and only where a flat scene does not explain them.
    sparse = recorded.size <= WHOLE and counted.flat() > 1.0 + counted.slack
    if diagnosis and whole and sparse and level == Background(None):
        level, held_out = _held_out(recorded, noise, blur_of)
    walk = iteration_of(way, blur, counted, background=level, aspect=aspect)
    walk.enough = enough(way, held_out, counted)
    with shown(progress) as tell:
        steps, stopped, each = walk.solve(way, tell)
    values, found = walk.inside(planes, pixels), counted.mean(each)
    finding = counted.finding(stopped, steps, found)
    if finding is not None:
        stopped = f"misfit: {finding}"
    findings = [] if finding is None else [finding]
    if not whole:
        text = (
            f"{percent(rim)} of the light of the PSF is on the rim of its window, which cuts off its cone: what "
            "is beyond counts as background or as a floor of light; take a wider window, or microscopy.restore"
        )
        findings.append(Finding("untested", "note", text, {"rim": rim, "most": _RIM}))
    unknown = 1.0 - float(counted.known.sum()) / recorded.size
    return Restoration(
        values, values, found, tuple(map(float, each)), before, steps, stopped, walk.strength, unknown,
        background=counted.background, findings=Findings(findings),
    )  # fmt: skip


def _held_out(recorded: Values, noise: Noise, blur: Callable[[], TiledBlur]) -> tuple[Background, int]:
    """Return the flat background that held-out photons agree with, and the number of steps."""
    halves = Halves(recorded, noise.poisson)

    def walked(background: Background, start: State, steps: int) -> Best:
        return halves.walked(blur(), silent, background=background, start=start, steps=steps)

    free = halves.walked(blur(), silent)
    return Background(highest_level(free, walked)), free.steps


def background_of(given: float | str) -> Background:
    """Return a known background, or the number of points at which one is to be estimated."""
    if isinstance(given, str):
        if given not in _BACKGROUNDS:
            raise ValueError(
                f'background must be "flat", "uneven", or the light of each voxel, 0 for none, got {given!r}'
            )
        return Background(None, _BACKGROUNDS[given])
    return Background(validation.real("background", given, least=0.0))
