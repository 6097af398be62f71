"""What a stack says of its own recording: the direction of z, depth, index of the sample, spherical aberration."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from lommel.base.arrays import Values
from lommel.estimation.noise import Noise
from lommel.imaging.deconvolution import RichardsonLucy
from lommel.microscopy.deconvolution import Counted, Walk
from lommel.microscopy.depth_model import DepthModel

PARAMETERS = ("depth", "sample", "spherical")

_STEPS = 40  # of each trial: after fewer, sharper PSFs look better than they are
_SIDE = 48  # pixels of the part that is looked at
_NARROWEST, _WIDEST = 33, 49  # pixels of PSFs
_LEAST_PLANES = 8  # of the margin
_TOLERANCE = {"depth": 2e-8, "sample": 2e-4, "spherical": 1e-3}
_REACH = {"depth": 3e-6, "sample": 0.03, "spherical": 0.3}


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
        self._paces: list[float] | None = None

    @property
    def slack(self) -> float:
        """Three standard deviations of the discrepancy."""
        return self._counted.slack

    def discrepancy(self, model: DepthModel, *, turned: bool = False) -> float:
        """Return the discrepancy after some steps."""
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
        walk = Walk(blur, counted, self._paces)
        _, _, each = walk.solve(RichardsonLucy(steps=_STEPS, target=0.0), lambda *_: None)
        if self._paces is None:
            self._paces = walk.paces
        return counted.mean(each)


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


def refined(
    stack: Any,
    crop: tuple[slice, slice],
    model: DepthModel,
    camera: Noise,
    saturation: float,
    names: Sequence[str],
    threads: int,
    tell: Callable[[str], object],
) -> tuple[DepthModel, dict[str, float]]:
    """Return the model whose PSFs the stack follows best, and the values of its parameters."""
    from scipy.optimize import minimize, minimize_scalar

    trial = _Trial(stack, crop, camera, saturation, threads, between=True)
    start = {"depth": model.depth, "sample": model.objective.sample, "spherical": 0.0}
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
    for name, value in zip(names, best, strict=True):
        low, high = _limits(name, start[name])
        model = model.changed(name, min(max(value, low), high))
    return model, dict(zip(names, best, strict=True))


def _limits(name: str, start: float) -> tuple[float, float]:
    reach = _REACH[name]
    if name == "depth":
        return max(0.0, start - max(reach, 0.5 * start)), start + max(reach, 0.5 * start)
    if name == "sample":
        return max(1.0, start - reach), start + reach
    return -reach, reach
