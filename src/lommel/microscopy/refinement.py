"""What a stack shows of its recording: the direction of z, depth, index of the sample, spherical aberration."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.base.units import format_length
from lommel.deconvolve.algorithms import RichardsonLucy
from lommel.deconvolve.iterations import Background, Iteration, StepSettings
from lommel.deconvolve.linear import PlaneOperator
from lommel.deconvolve.poisson_counts import PoissonCounts
from lommel.microscopy.depth_model import DepthModel
from lommel.recorded.counts import Stack, plane_of
from lommel.recorded.noise import Noise

PARAMETERS = {"depth": "depth", "sample": "index of the sample", "spherical": "spherical aberration"}
"""What can be estimated from a stack, and its name."""

Tell = Callable[[float, str], object]
"""Called with the share of the work that is done, 0 to 1, and its name."""

_STEPS = 40  # steps of each trial of the search: after fewer, sharper PSFs look better than they are
_MORE = 100  # steps of trials around the answer: of dim points, 40 leave too much, and 160 follow the noise
_SIDES = 48, 64  # pixels: smallest and largest side of the part that is used
_NARROWEST, _WIDEST = 33, 49  # pixels: smallest and largest side of PSFs
_ROUGH = 40  # pixels a side of the part in which values are searched, with the narrowest PSFs
_LEAST_PLANES = 8  # least margin in planes
_FAR = 3  # depths of light far from its emitter, which changes slowly
_REACH = {"depth": 3e-6, "sample": 0.03, "spherical": 0.3}
_APART = 1 / 6  # of the reach: distance of values around the answer; twice that in the search
_ROUNDS = 3  # largest number of rounds, where the least value is not between the tried ones
# What is tried where a stack does not follow its PSF: first changes, which are doubled while that is better.
_OTHERS = {
    "sample": (6e-3, "index of the sample"),
    "NA": (0.02, "NA"),
    "depth": (6e-7, "depth"),
    "wavelength": (0.03, "wavelength"),
    "step": (0.03, "step of z"),
}
_DOUBLED = 5  # largest number of changes of one value
_USUAL = 2.6  # usual number of these
_SIGNIFICANT = 9.0  # of the deviance: three standard deviations, by which another PSF is better
_EXPLAINED = 0.03  # of the misfit left after these steps, that a better PSF explains at least
_AS_GOOD = 0.5  # of what the best PSF explains: others that explain as much are reported beside it


def select_crop(stack: Stack, side: int, saturation: float) -> tuple[slice, slice]:
    """Return rows and columns around the brightest detail, of a part as wide as PSFs of a `side`, within limits."""
    return brightest(stack, max(_SIDES[0], min(side, _SIDES[1])), saturation)


def brightest(stack: Stack, size: int, saturation: float) -> tuple[slice, slice]:
    """Return rows and columns of a part of this size around the brightest detail, as far as voxels are known."""
    from scipy.ndimage import uniform_filter

    planes, height, width = stack.shape
    whole = np.zeros((height, width))
    for plane in np.unique(np.linspace(0, planes - 1, min(planes, 16)).astype(int)):
        values = np.asarray(plane_of(stack, int(plane)), np.float64)
        known = np.isfinite(values) & (values < saturation)
        values = np.where(known, values, np.median(values[known]) if known.any() else 0.0)
        # A difference of two means: details of a few pixels, without the background.
        np.maximum(whole, uniform_filter(values, 3) - uniform_filter(values, 15), out=whole)
    # The root keeps one bright spot from outweighing many dim ones.
    bright = uniform_filter(np.maximum(whole, 0.0) ** 0.5, min(size, height, width))
    row, column = np.unravel_index(int(bright.argmax()), bright.shape)
    return _window_around(int(row), size, height), _window_around(int(column), size, width)


def _window_around(middle: int, size: int, side: int) -> slice:
    start = min(max(middle - size // 2, 0), max(side - size, 0))
    return slice(start, min(start + size, side))


def estimated_steps(direction: bool, names: int) -> tuple[float, float]:
    """Return the approximate numbers of steps for the direction of z, and for `names` values."""
    return 2.0 * _STEPS * direction, (_MORE + 0.5 * _STEPS) * _places(names) if names else 0.0


def _places(names: int) -> int:
    """Return the number of trials that determine a quadratic function."""
    # Its constant, n slopes, n curvatures and n (n - 1) / 2 mixed terms.
    return 1 + 2 * names + names * (names - 1) // 2


class StackContext(NamedTuple):
    """A stack with its model, camera and saturation."""

    stack: Stack
    model: DepthModel
    camera: Noise
    saturation: float
    threads: int


class Work:
    """Progress of several trials of about `steps` steps together."""

    def __init__(self, tell: Tell, steps: float) -> None:
        self._tell, self._steps, self._done = tell, steps, 0.0

    def __call__(self, words: str, steps: int) -> Callable[[int, float, float], None]:
        """Begin a trial, and return the function to call after each of its steps."""
        begun, self._done = self._done, self._done + steps

        def told(step: int, *_: float) -> None:
            share = (begun + step) / max(self._steps, self._done)
            self._tell(min(share, 1.0), words)

        told(0)
        return told


class TrialDeconvolution:
    """A part of a stack that is restored in a few steps, again and again, with other PSFs.

    Light is spread as B-splines, and a background is estimated: points between planes, and noise, would else be
    taken for longer PSFs.
    """

    def __init__(self, context: StackContext, crop: tuple[slice, slice], *, widest: int = _WIDEST) -> None:
        rows, columns = crop
        stack, camera = context.stack, context.camera
        self._values = np.stack([np.asarray(stack[plane, rows, columns]) for plane in range(stack.shape[0])])
        maps = {name: each if np.ndim(each) == 0 else each[rows, columns] for name, each in vars(camera).items()}
        self._camera = Noise(**maps)
        self._counted = PoissonCounts(self._values, self._camera, context.saturation)
        self._threads, self._widest = context.threads, widest
        self._degrees: tuple[int, int] | None = None  # those of the first model
        self._courses: dict[int, list[StepSettings]] = {}  # those of the first walk, of each number of steps

    @property
    def slack(self) -> float:
        """Three standard deviations of the discrepancy."""
        return self._counted.slack

    @property
    def known(self) -> int:
        """Number of voxels."""
        return int(self._counted.known.sum())

    def course(
        self, model: DepthModel, steps: int, told: Callable[[int, float, float], object], *, turned: bool = False
    ) -> list[float]:
        """Return the discrepancy after each step, as far extrapolated as those of the first model."""
        counted = self._counted
        if turned:
            counted = counted.reversed()
        blur = self.blur(model, len(self._values))
        walk = Iteration(blur, counted, self._courses.get(steps), background=Background(None))
        found: list[float] = []

        def each(step: int, discrepancy: float, left: float) -> None:
            found.append(discrepancy)
            told(step, discrepancy, left)

        walk.solve(RichardsonLucy(steps=steps, target=0.0), each)
        self._courses.setdefault(steps, walk.course)
        return found

    def blur(self, model: DepthModel, planes: int) -> PlaneOperator:
        """Return the blur of the part, with smaller PSFs, and the B-splines of the first model."""
        side = min(max(model.window[1], _NARROWEST), self._widest)
        deep = model.window[0]
        small = replace(model, window=(deep, side), planes=planes, degrees=self._degrees)
        # The same splines for all models: others would change the discrepancy by themselves.
        self._degrees = small.splines
        margin = min(deep // 2, max(_LEAST_PLANES, planes // 4)), side // 2
        psfs = small.psfs(margin[0])
        if psfs.radial is not None:
            far = np.linspace(0, len(psfs.nodes) - 1, min(_FAR, len(psfs.nodes))).astype(int)
            psfs = psfs._replace(nodes=psfs.nodes[far])
        shape = self._values.shape
        return small.blur((shape[0], shape[1], shape[2]), margin, psfs, threads=self._threads)


def estimate_z_direction(context: StackContext, crop: tuple[slice, slice], tell: Tell) -> tuple[str, str]:
    """Return "up" or "down", whichever the stack follows better, and a sentence on it."""
    trial, work = TrialDeconvolution(context, crop), Work(tell, 2.0 * _STEPS)
    up, down = (
        trial.course(context.model, _STEPS, work(f"direction of z, {words}", _STEPS), turned=turned)[-1]
        for turned, words in ((False, "planes as they are"), (True, "planes in reverse order"))
    )
    better, worse = min(up, down), max(up, down)
    figures = f"after {_STEPS} steps of a part of it the discrepancy is {better:.3g}, and {worse:.3g} with the planes"
    if worse - better < max(0.5 * trial.slack, 0.005 * better):
        return "up", (
            f"The direction of z cannot be told from the stack ({figures} the other way round): the first plane was "
            "taken to be the nearest to the cover glass."
        )
    if up < down:
        return "up", f"The planes run from the cover glass into the sample ({figures} the other way round)."
    return "down", (
        f"The planes run towards the cover glass ({figures} the other way round): the last one is the nearest to it."
    )


def rank_alternatives(context: StackContext, tell: Tell, *, turned: bool) -> list[str]:
    """Return in words which other PSFs the stack follows better, the best first, each with one other value.

    Points between voxels leave a misfit whatever the PSF; they hardly change which PSF is the best. Planes in the
    other order are tried if `turned` says so. Spherical aberration is like another index of the sample. Those that
    explain half of what the best one does are named, too: errors of an index, a depth or a step are much alike.
    """
    model, steps = context.model, _STEPS
    trial = TrialDeconvolution(context, brightest(context.stack, _ROUGH, context.saturation), widest=_NARROWEST)
    work = Work(tell, steps * (1.0 + turned + _USUAL * len(_OTHERS)))

    def cost(changed: DepthModel, words: str, *, turned: bool = False) -> float:
        found = trial.course(changed, steps, work(words, steps), turned=turned)
        # Single steps depend on how far they are extrapolated, which is the same for all PSFs.
        return float(np.mean(found[steps // 2 :]))

    given = cost(model, "the PSF as given")
    explained: dict[str, float] = {}
    if turned:
        words = "planes in reverse order"
        explained[words] = given - cost(model, words, turned=True)
    for name, (apart, words) in _OTHERS.items():

        def changed(value: float, name: str = name, words: str = words) -> float:
            try:
                other = model.changed(name, value)
            except ValueError:
                return math.inf
            return cost(other, f"another {words}: {_value_in_words(model, name, value)}")

        start = _start(model, name)
        value, found = _line_search(changed, start, apart, given)
        if value != start:
            change = "smaller" if value < start else "larger"
            explained[f"a {change} {words} (about {_value_in_words(model, name, value)})"] = given - found
    most = max(explained.values(), default=0.0)
    least = max(_SIGNIFICANT * given / trial.known, _EXPLAINED * (given - 1.0), _AS_GOOD * most)
    return sorted((each for each in explained if explained[each] > least), key=lambda each: -explained[each])


def _line_search(cost: Callable[[float], float], start: float, apart: float, given: float) -> tuple[float, float]:
    """Return the place of the least cost on a line and that cost, from that `given` at the start; costs are few.

    Changes are doubled while the cost falls. It is infinite where a value is out of range, which ends the line.
    """
    for way in (apart, -apart):
        places, costs = [start], [given]
        for doubled in range(_DOUBLED):
            place = start + 2**doubled * way
            if math.isinf(found := cost(place)):
                break
            places.append(place)
            costs.append(found)
            if found >= costs[-2]:
                break
        if len(costs) > 1 and costs[1] < given:
            at = int(np.argmin(costs))
            if at == len(costs) - 1:
                return places[at], costs[at]
            # The parabola through three of them.
            near = slice(at - 1, at + 2)
            bend, slope, height = np.polyfit(np.array(places[near]) - places[at], costs[near], 2)
            return float(places[at] - 0.5 * slope / bend), float(height - 0.25 * slope**2 / bend)
    return start, given


def _value_in_words(model: DepthModel, name: str, value: float) -> str:
    """Return the value of a parameter in words."""
    if name == "depth":
        return format_length(value, digits=3)
    if name in ("wavelength", "step"):
        return format_length(value * getattr(model, name), digits=3)
    return f"{value * (model.objective.NA if name == 'NA' else 1.0):.4g}"


def refined(
    context: StackContext, crop: tuple[slice, slice], names: Sequence[str], tell: Tell
) -> tuple[DepthModel, dict[str, float], dict[str, float]]:
    """Return the model whose PSFs the stack follows best, the values of its parameters, and their standard errors."""
    model = context.model
    start = np.array([_start(model, name) for name in names])
    apart = np.array([_REACH[name] * _APART for name in names])
    least, most = np.array([_limits(name, value) for name, value in zip(names, start, strict=True)]).T
    rough = TrialDeconvolution(context, brightest(context.stack, _ROUGH, context.saturation), widest=_NARROWEST)
    fine = TrialDeconvolution(context, crop)
    faster = rough.known / fine.known
    work = Work(tell, _places(len(names)) * (_STEPS * faster + _MORE))

    def course(trial: TrialDeconvolution, steps: int, much: float) -> Callable[[Array], list[float]]:
        def made(values: Array) -> list[float]:
            pairs = zip(names, values.tolist(), strict=True)
            words = ", ".join(f"{PARAMETERS[name]} {_value_in_words(model, name, value)}" for name, value in pairs)
            told = work(words, int(steps * much))
            return trial.course(_with(model, names, values), steps, lambda step, *rest: told(int(step * much), *rest))

        return made

    wide = 2.0 * apart
    found, _ = _minimum(course(rough, _STEPS, faster), start, wide, (least + wide, most - wide), rough.known)
    found, errors = _minimum(course(fine, _MORE, 1.0), found, apart, (least + apart, most - apart), fine.known)
    found = np.clip(found, least, most)
    values, own = (dict(zip(names, each.tolist(), strict=True)) for each in (found, errors))
    return _with(model, names, found), values, own


def _start(model: DepthModel, name: str) -> float:
    """Return the value from which another one is searched; 1 for those that are factors."""
    given = {"depth": model.depth, "sample": model.objective.sample, "spherical": 0.0}
    return given.get(name, 1.0)


def _with(model: DepthModel, names: Sequence[str], values: Sequence[float] | Array) -> DepthModel:
    """Return the model with other values of some parameters."""
    for name, value in zip(names, values, strict=True):
        model = model.changed(name, float(value))
    return model


def _minimum(
    course: Callable[[Array], list[float]], start: Array, apart: Array, limits: tuple[Array, Array], known: int
) -> tuple[Array, Array]:
    """Return where discrepancies of courses around a point are the least, and the standard error of that.

    The deviance, `known` times the discrepancy, rises by 1 at a standard error. That of photons is joined with the
    change since half of the steps: what more steps would change is unknown.
    """
    count, centre = len(start), np.clip(start, *limits)
    unit = np.eye(count)
    pairs = [(i, k) for i in range(count) for k in range(i)]
    # The points of a quadratic function: the centre, one step along each axis and back, and one along each pair.
    places = np.array([np.zeros(count), *unit, *-unit, *(unit[i] + unit[k] for i, k in pairs)])
    found, errors = centre, np.full(count, np.inf)
    for _ in range(_ROUNDS):
        courses = np.array([course(centre + place * apart) for place in places])
        fits = [_quadratic(values, pairs) for values in (courses[:, courses.shape[1] // 2], courses[:, -1])]
        bend, slope = fits[-1]
        early, late = (bool(np.linalg.eigvalsh(each)[0] > 0.0) for each, _ in fits)
        errors = np.full(count, np.inf)
        if not late:
            least = places[int(courses[:, -1].argmin())]
            found = centre + least * apart
            if not least.any():
                break
            centre = np.clip(found + least * apart, *limits)
            continue
        least = -np.linalg.solve(bend, slope)
        found = centre + least * apart
        if early:
            lowest = max(float(courses[0, -1] + 0.5 * slope @ least), 1.0)
            variance = 2.0 * lowest * np.diag(np.linalg.inv(bend)) / known
            errors = np.sqrt(variance + (least + np.linalg.solve(*fits[0])) ** 2) * apart
        # Beyond one and a half steps the quadratic function is an extrapolation.
        if np.abs(least).max() <= 1.5:
            break
        centre = np.clip(centre + np.clip(least, -3.0, 3.0) * apart, *limits)
    return found, errors


def _quadratic(values: Array, pairs: Sequence[tuple[int, int]]) -> tuple[Array, Array]:
    """Return second and first derivatives at a point, from values there and one unit away, and away along pairs."""
    count = (len(values) - 1 - len(pairs)) // 2
    up, down = values[1 : count + 1] - values[0], values[count + 1 : 2 * count + 1] - values[0]
    bend = np.diag(up + down)
    # f(x + y) - f(x) - f(y) + f(0) is the mixed derivative.
    for (i, k), value in zip(pairs, values[2 * count + 1 :] - values[0], strict=True):
        bend[i, k] = bend[k, i] = value - up[i] - up[k]
    return bend, (up - down) / 2.0


def _limits(name: str, start: float) -> tuple[float, float]:
    reach = _REACH[name]
    if name == "depth":
        return max(0.0, start - max(reach, 0.5 * start)), start + max(reach, 0.5 * start)
    if name == "sample":
        return max(1.0, start - reach), start + reach
    return -reach, reach
