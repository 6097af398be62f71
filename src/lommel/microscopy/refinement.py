"""What a stack says of its own recording: the direction of z, depth, index of the sample, spherical aberration."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from lommel.base.arrays import Array, Values
from lommel.estimation.noise import Noise
from lommel.imaging.deconvolution import RichardsonLucy
from lommel.microscopy.deconvolution import Counted, Walk
from lommel.microscopy.depth_model import DepthModel

PARAMETERS = ("depth", "sample", "spherical")

_STEPS = 40  # of each trial of the search: after fewer, sharper PSFs look better than they are
_MORE = 160  # of those around the value that was found: of dim points, 40 leave too much unexplained
_SIDE = 48  # pixels of the part that is looked at
_NARROWEST, _WIDEST = 33, 49  # pixels of PSFs
_LEAST_PLANES = 8  # of the margin
_TOLERANCE = {"depth": 1e-7, "sample": 1e-3, "spherical": 5e-3}  # of the search
_REACH = {"depth": 3e-6, "sample": 0.03, "spherical": 0.3}
# What is tried where a stack does not follow its PSF: twice what would matter.
_OTHERS = {
    "sample": (6e-3, "index of the sample"),
    "depth": (6e-7, "depth"),
    "wavelength": (0.04, "wavelength (or pixel, or NA)"),
    "step": (0.04, "step of z"),
}
_SIGNIFICANT = 9.0  # of the deviance, by which another PSF is better: three standard deviations
_EXPLAINED = 0.03  # of the misfit, by another PSF that is better
_APART = 1 / 6  # of these, between values around that which was found
_ROUNDS = 3  # of these, where the least value is not between them


def crop_of(stack: Any, side: int) -> tuple[slice, slice]:
    """Return rows and columns around the brightest detail."""
    from scipy.ndimage import uniform_filter

    planes, height, width = stack.shape
    size = max(_SIDE, min(side, 64))
    whole = np.zeros((height, width))
    for plane in np.unique(np.linspace(0, planes - 1, min(planes, 16)).astype(int)):
        values = np.nan_to_num(np.asarray(stack[int(plane)], np.float64))
        np.maximum(whole, uniform_filter(values, 3) - uniform_filter(values, 15), out=whole)
    bright = uniform_filter(np.maximum(whole, 0.0) ** 0.5, min(size, height, width))
    row, column = np.unravel_index(int(bright.argmax()), bright.shape)
    return _placed(int(row), size, height), _placed(int(column), size, width)


def _placed(middle: int, size: int, side: int) -> slice:
    start = min(max(middle - size // 2, 0), max(side - size, 0))
    return slice(start, min(start + size, side))


class _Trial:
    """A part of a stack that is restored in a few steps, again and again, with other PSFs.

    With `between` light may also come from planes in the middle between two, which were not recorded: points there
    would else be taken for longer PSFs.
    """

    def __init__(
        self,
        stack: Any,
        crop: tuple[slice, slice],
        camera: Noise,
        saturation: float,
        threads: int,
        *,
        between: bool = False,
    ) -> None:
        rows, columns = crop
        self._values = np.stack([np.asarray(stack[plane, rows, columns]) for plane in range(stack.shape[0])])
        self._times = 2 if between else 1
        if between:
            # The middle plane stays the middle one.
            planes = 2 * len(self._values) - len(self._values) % 2
            known, self._values = self._values, np.full((planes, *self._values.shape[1:]), np.nan, np.float32)
            self._values[::2] = known
        maps = {name: each if np.ndim(each) == 0 else each[rows, columns] for name, each in vars(camera).items()}
        self._counted = Counted(self._values, Noise(**maps), saturation)
        self._counted.most_weight /= self._times  # steps as long as if all planes were known
        self._threads = threads
        self._paces: dict[int, list[float]] = {}  # those of the first walk, of each number of steps

    @property
    def slack(self) -> float:
        """Three standard deviations of the discrepancy."""
        return self._counted.slack

    @property
    def known(self) -> int:
        """Number of voxels."""
        return int(self._counted.known.sum())

    def discrepancy(self, model: DepthModel, *, turned: bool = False) -> float:
        """Return the discrepancy after some steps."""
        return self.course(model, turned=turned)[-1]

    def course(self, model: DepthModel, steps: int = 0, *, turned: bool = False) -> list[float]:
        """Return the discrepancy after each step, as far extrapolated as those of the first model."""
        count = steps or _STEPS
        planes = len(self._values)
        side = min(max(model.window[1], _NARROWEST), _WIDEST)
        deep = self._times * (model.window[0] - 1) + 1
        small = replace(model, window=(deep, side), planes=planes, step=model.step / self._times)
        margin = min(deep // 2, max(self._times * _LEAST_PLANES, planes // 4)), side // 2
        counted = self._counted
        if turned:
            counted = _Flipped.of(counted, self._values[::-1])
        shape = self._values.shape
        blur = small.blur((shape[0], shape[1], shape[2]), margin, threads=self._threads)
        walk = Walk(blur, counted, self._paces.get(count))
        found: list[float] = []
        walk.solve(RichardsonLucy(steps=count, target=0.0), lambda _, discrepancy, __: found.append(discrepancy))
        self._paces.setdefault(count, walk.paces)
        return found


class _Flipped:
    """Counts of a stack whose planes are in the other order."""

    @staticmethod
    def of(counted: Counted, values: Values) -> Counted:
        """Return them."""
        made = object.__new__(Counted)
        vars(made).update(vars(counted))
        made.known = counted.known[::-1]
        made._recorded = values
        return made


def direction_of(
    stack: Any, crop: tuple[slice, slice], model: DepthModel, camera: Noise, saturation: float, threads: int
) -> tuple[str, str]:
    """Return "up" or "down", whichever the stack follows better, and what to say of it."""
    trial = _Trial(stack, crop, camera, saturation, threads)
    up, down = (trial.discrepancy(model, turned=turned) for turned in (False, True))
    better, worse = min(up, down), max(up, down)
    figures = f"discrepancy {up:.3g} against {down:.3g}"
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


def better(
    stack: Any,
    crop: tuple[slice, slice],
    model: DepthModel,
    camera: Noise,
    saturation: float,
    threads: int,
    tell: Callable[[str], object],
    *,
    turned: bool,
) -> str | None:
    """Return in words which other PSFs the stack follows better, or None if the given ones are the best of these.

    Points between voxels leave a misfit whatever the PSF; they hardly change which PSF is the best. Planes in the
    other order are tried if `turned` says so. Spherical aberration is like another index of the sample.
    """
    trial = _Trial(stack, crop, camera, saturation, threads, between=True)
    given = trial.discrepancy(model)
    most = given - max(_SIGNIFICANT * given / trial.known, _EXPLAINED * (given - 1.0))
    tried: dict[str, float] = {}
    if turned:
        tell("reversed planes")
        tried["planes in reverse order"] = trial.discrepancy(model, turned=True)
    for name, (apart, words) in _OTHERS.items():
        start = _start(model, name)
        for value, change in ((start - apart, "smaller"), (start + apart, "larger")):
            if (name == "depth" and value < 0.0) or (name == "sample" and value < 1.0):
                continue
            tell(f"another {words}")
            tried[f"a {change} {words}"] = trial.discrepancy(model.changed(name, value))
    best = min(tried, key=lambda words: tried[words])
    return best if tried[best] < most else None


def refined(
    stack: Any,
    crop: tuple[slice, slice],
    model: DepthModel,
    camera: Noise,
    saturation: float,
    names: Sequence[str],
    threads: int,
    tell: Callable[[str], object],
) -> tuple[DepthModel, dict[str, float], dict[str, float]]:
    """Return the model whose PSFs the stack follows best, the values of its parameters, and their standard errors."""
    from scipy.optimize import minimize, minimize_scalar

    trial = _Trial(stack, crop, camera, saturation, threads, between=True)
    start = {name: _start(model, name) for name in names}
    count = 0

    def cost(values: Sequence[float]) -> float:
        nonlocal count
        count += 1
        changed, extra = model, 0.0
        for name, value in zip(names, values, strict=True):
            low, high = _limits(name, start[name])
            inside = min(max(value, low), high)
            extra += abs(value - inside) / _REACH[name]
            changed = changed.changed(name, inside)
        found = trial.discrepancy(changed) * (1.0 + extra)
        said = ", ".join(f"{name} {value:.4g}" for name, value in zip(names, values, strict=True))
        tell(f"trial {count}: {said}")
        return found

    if len(names) == 1:
        limits = _limits(names[0], start[names[0]])
        found = minimize_scalar(
            lambda x: cost([float(x)]), bounds=limits, method="bounded", options={"xatol": _TOLERANCE[names[0]]}
        )
        best = [float(found.x)]
    else:
        first = np.array([start[name] for name in names])
        simplex = [first]
        for k, name in enumerate(names):
            simplex.append(first + 0.5 * _REACH[name] * np.eye(len(names))[k])
        # In units of the tolerances, which are alike then.
        scale = np.array([_TOLERANCE[name] for name in names])
        answer = minimize(
            lambda x: cost(list(x * scale)),
            first / scale,
            method="Nelder-Mead",
            options={"xatol": 2.0, "fatol": 1e-6, "initial_simplex": np.array(simplex) / scale, "maxfev": 120},
        )
        best = [float(x) for x in answer.x * scale]
    apart = np.array([_REACH[name] * _APART for name in names])
    least, most = np.array([_limits(name, start[name]) for name in names]).T

    def course(values: Array) -> list[float]:
        tell("near " + ", ".join(f"{name} {value:.4g}" for name, value in zip(names, values, strict=True)))
        return trial.course(_with(model, names, values), _MORE)

    found_at, errors = _minimum(course, np.array(best), apart, (least + apart, most - apart), trial.known)
    found_at = np.clip(found_at, least, most)
    values, deviations = (dict(zip(names, each.tolist(), strict=True)) for each in (found_at, errors))
    return _with(model, names, found_at), values, deviations


def _start(model: DepthModel, name: str) -> float:
    """Return a value from which to look for another; 1 of those that are scaled."""
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
    places = np.array([np.zeros(count), *unit, *-unit, *(unit[i] + unit[k] for i, k in pairs)])
    for _ in range(_ROUNDS):
        courses = np.array([course(centre + place * apart) for place in places])
        minima = []
        for values in (courses[:, courses.shape[1] // 2], courses[:, -1]):
            up, down = values[1 : count + 1] - values[0], values[count + 1 : 2 * count + 1] - values[0]
            slope, bend = (up - down) / 2.0, np.diag(up + down)
            for (i, k), value in zip(pairs, values[2 * count + 1 :] - values[0], strict=True):
                bend[i, k] = bend[k, i] = value - up[i] - up[k]
            if np.linalg.eigvalsh(bend)[0] <= 0.0:
                return centre, np.full(count, np.inf)
            minima.append(-np.linalg.solve(bend, slope))
        earlier, least = minima
        lowest = max(float(courses[0, -1] + 0.5 * slope @ least), 1.0)
        variance = 2.0 * lowest * np.diag(np.linalg.inv(bend)) / known
        found = centre + least * apart
        if np.abs(least).max() <= 1.5:
            break
        centre = np.clip(centre + np.clip(least, -3.0, 3.0) * apart, *limits)
    return found, np.sqrt(variance + (least - earlier) ** 2) * apart


def _limits(name: str, start: float) -> tuple[float, float]:
    reach = _REACH[name]
    if name == "depth":
        return max(0.0, start - max(reach, 0.5 * start)), start + max(reach, 0.5 * start)
    if name == "sample":
        return max(1.0, start - reach), start + reach
    return -reach, reach
