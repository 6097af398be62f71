"""Trial deconvolutions of a part of a stack, and the direction of z: that of the lower discrepancy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple, cast

import numpy as np
import scipy

from lommel.deconvolve.algorithms import RichardsonLucy
from lommel.deconvolve.iterations import Background, Iteration, StepSettings
from lommel.deconvolve.likelihood import PoissonLikelihood
from lommel.deconvolve.linear import PlaneOperator
from lommel.microscopy.depth_model import DepthModel, GivenPSF
from lommel.recorded.counts import Stack, plane_of
from lommel.recorded.noise import Noise

Progress = Callable[[float, str], object]
"""Callback for the progress: fraction of the work that is done, 0 to 1, and its description."""

_STEPS = 40  # steps of trials: with fewer, PSFs that are too sharp have the lowest discrepancy
DIRECTION_STEPS = 2.0 * _STEPS
"""Number of steps that determine the direction of z, for the progress."""

_SIDES = 48, 64  # pixels: smallest and largest side of the part of the stack that is used
NARROWEST = 25
"""Smallest side of PSFs of trials, pixels."""
_WIDEST = 49  # largest side, pixels
_MIN_MARGIN = 4  # planes
_SMALL = 1 << 17  # voxels of a part for which one thread is used
_FOCI = 5  # depths at which the best focus of trial PSFs is computed
_DEPTHS = 3  # number of depths of PSFs, between which they are interpolated


def select_crop(stack: Stack, side: int, saturation: float) -> tuple[slice, slice]:
    """Return rows and columns of a part around the brightest detail; its side is `side` pixels, within limits."""
    return brightest(stack, max(_SIDES[0], min(side, _SIDES[1])), saturation)


def brightest(stack: Stack, size: int, saturation: float) -> tuple[slice, slice]:
    """Return rows and columns of a part of `size` pixels (side) around the brightest detail of the stack."""
    planes, height, width = stack.shape
    uniform_filter = scipy.ndimage.uniform_filter
    detail = np.zeros((height, width))  # maximum over planes
    for plane in np.unique(np.linspace(0, planes - 1, min(planes, 16)).astype(int)):
        values = np.asarray(plane_of(stack, int(plane)), np.float64)
        valid = np.isfinite(values) & (values < saturation)
        values = np.where(valid, values, np.median(values[valid]) if valid.any() else 0.0)
        # The difference of two local means keeps details of a few pixels, and removes the background.
        np.maximum(detail, uniform_filter(values, 3) - uniform_filter(values, 15), out=detail)
    # The root keeps a single bright spot from outweighing many dim spots.
    detail_sum = uniform_filter(np.maximum(detail, 0.0) ** 0.5, min(size, height, width))
    row, column = np.unravel_index(int(detail_sum.argmax()), detail_sum.shape)
    return _window_around(int(row), size, height), _window_around(int(column), size, width)


def _window_around(middle: int, size: int, side: int) -> slice:
    """Return the slice of `size` pixels around a middle, moved to lie within `side` pixels."""
    start = min(max(middle - size // 2, 0), max(side - size, 0))
    return slice(start, min(start + size, side))


class StackContext(NamedTuple):
    """A stack with its model, camera and saturation."""

    stack: Stack
    model: DepthModel | GivenPSF
    camera: Noise
    saturation: float
    threads: int


class Work:
    """Progress of several trials with a total of about `steps` steps."""

    def __init__(self, progress: Progress, steps: float) -> None:
        self._progress, self._steps, self._done = progress, steps, 0.0

    def __call__(self, label: str, steps: int) -> Callable[[int, float, float], None]:
        """Begin a trial of about `steps` steps, and return the function to be called after each step."""
        steps_before, self._done = self._done, self._done + steps

        def report(step: int, *_: float) -> None:
            fraction = (steps_before + step) / max(self._steps, self._done)
            self._progress(min(fraction, 1.0), label)

        report(0)
        return report


class TrialDeconvolution:
    """Deconvolution of a part of a stack in a few steps, repeated with different PSFs.

    Voxels of the specimen are B-splines, and a background is estimated. Otherwise points between planes, and noise,
    would favour PSFs that are too long.
    """

    def __init__(self, context: StackContext, crop: tuple[slice, slice], *, widest: int = _WIDEST) -> None:
        rows, columns = crop
        stack, camera = context.stack, context.camera
        self._values = np.stack([np.asarray(stack[plane, rows, columns]) for plane in range(stack.shape[0])])
        maps = {name: value if np.ndim(value) == 0 else value[rows, columns] for name, value in vars(camera).items()}
        self._camera = Noise(**maps)
        self._counted = PoissonLikelihood(self._values, self._camera, context.saturation)
        # Starting threads would take as long as the work on a small part.
        self._threads = 1 if self._values.size < _SMALL else context.threads
        self._widest = widest
        self._degrees: tuple[int, int] | None = None  # degrees of the B-splines of the first model
        self._courses: dict[int, list[StepSettings]] = {}  # settings of the first trial with each number of steps

    @property
    def slack(self) -> float:
        """Three standard deviations of the discrepancy."""
        return self._counted.slack

    @property
    def known(self) -> int:
        """Number of voxels that are not ignored."""
        return int(self._counted.known.sum())

    def discrepancies(
        self, model: DepthModel, steps: int, report: Callable[[int, float, float], object], *, reverse: bool = False
    ) -> list[float]:
        """Return the discrepancy after each step with the PSFs of a model; `reverse`: with the planes reversed.

        All trials use the extrapolation factors of the first trial, so that differences are due to the PSFs alone.
        """
        counted = self._counted
        if reverse:
            counted, model = counted.reversed(), replace(model, is_reversed=not model.is_reversed)
        blur = self.blur(model, len(self._values))
        iteration = Iteration(blur, counted, self._courses.get(steps), background=Background(None))
        discrepancies: list[float] = []

        def record(step: int, discrepancy: float, remaining: float) -> None:
            discrepancies.append(discrepancy)
            report(step, discrepancy, remaining)

        iteration.solve(RichardsonLucy(steps=steps, target=0.0), record)
        self._courses.setdefault(steps, iteration.course)
        return discrepancies

    def blur(self, model: DepthModel, planes: int) -> PlaneOperator:
        """Return the blur of the part by narrower PSFs of a model, with the B-splines of the first model."""
        side = min(max(model.window[1], NARROWEST), self._widest)
        window_planes = model.window[0]
        narrow_model = replace(model, window=(window_planes, side), planes=planes, degrees=self._degrees, foci=_FOCI)
        # All models have the same splines, since other splines would change the discrepancy.
        self._degrees = narrow_model.splines
        margin = min(window_planes // 2, max(_MIN_MARGIN, planes // 8)), side // 2
        psfs = narrow_model.psfs(margin[0], _DEPTHS)
        shape = self._values.shape
        return narrow_model.blur((shape[0], shape[1], shape[2]), margin, psfs, threads=self._threads)


def estimate_z_direction(context: StackContext, crop: tuple[slice, slice], progress: Progress) -> tuple[str, str]:
    """Return "up" or "down", the direction with the lower discrepancy, and a sentence on the result."""
    trial, track = TrialDeconvolution(context, crop), Work(progress, 2.0 * _STEPS)
    model = cast("DepthModel", context.model)
    up_discrepancy, down_discrepancy = (
        trial.discrepancies(model, _STEPS, track(f"direction of z, {label}", _STEPS), reverse=reverse)[-1]
        for reverse, label in ((False, "planes in the order of the file"), (True, "planes in reverse order"))
    )
    lower, higher = min(up_discrepancy, down_discrepancy), max(up_discrepancy, down_discrepancy)
    comparison = (
        f"after {_STEPS} steps a part of the stack has the discrepancy {lower:.3g}, and {higher:.3g} for the "
        "opposite direction"
    )
    if higher - lower < max(0.5 * trial.slack, 0.005 * lower):
        return "up", (
            f"The direction of z cannot be determined from the stack ({comparison}): the first "
            "plane was assumed to be the nearest to the cover glass."
        )
    if up_discrepancy < down_discrepancy:
        return "up", f"The planes run from the cover glass into the sample ({comparison})."
    return "down", (f"The planes run towards the cover glass ({comparison}): the last plane is the nearest to it.")
