"""Reproduce figures and numbers of the paper on which this package is based, cited in `docs/paper.md`.

The paper's closed form (CFIS) is :class:`lommel.paper.ClosedForm`. Its variant "printed" is Eq. (12) as printed;
the variant "corrected" has the missing factor sqrt(2 / pi). Equation numbers are those in the paper.
C_d (defocus) and C_s (spherical aberration) are phase coefficients at the pupil edge in radians. The optical
coordinate at the distance r from the axis is v = pi r / (lambda N). MSE is the mean squared error.
"""

from __future__ import annotations

import json
import math
import textwrap
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, TypeVar

import numpy as np
import scipy
from numpy.typing import NDArray

from lommel import methods, paper
from lommel.base import atomic
from lommel.base.arrays import Json, Values
from lommel.base.units import percent
from lommel.measures.errors import mse, peak_error
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import psf
from lommel.special.bessel import j0_asymptotic, j0_series, tangent_line
from lommel.special.piecewise import SPLITS, PiecewiseQuadratic, fit_quadratics

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure
    from matplotlib.image import AxesImage

Arrays: TypeAlias = dict[str, Values]
Facts: TypeAlias = Json

_Result = TypeVar("_Result")

VARIANTS = ("printed", "corrected")
# All errors are differences from the results of this method, whose error bound is proven.
REFERENCE = methods.NijboerZernike(tol=1e-9)


@dataclass(frozen=True)
class Setting:
    """Parameters of one PSF of the paper."""

    shape: int = 512  # side of the image, pixels
    # v at the edge; not stated in the paper, but 145 reproduces the ring radii in its Fig. 4 and its first MSE.
    window: float = 145.0
    defocus: float = 10.0  # C_d, radians
    tangent: float = 100.0  # tangent-line centre (TLC), alpha of Eq. (9)
    terms: int | None = 30  # N of Eq. (14); None for the exact error function

    @property
    def pixel(self) -> float:
        """Pixel pitch in units of lambda*N."""
        return self.window / (math.pi * (self.shape // 2))

    @property
    def v(self) -> NDArray[np.float64]:
        """Optical coordinate v of the pixels from the centre of the image to its right edge."""
        return np.arange(self.shape - self.shape // 2, dtype=np.float64) * (self.window / (self.shape // 2))

    def closed_form(self, variant: str) -> paper.ClosedForm:
        """Return the paper's closed form with these parameters."""
        erf = paper.FresnelErf() if self.terms is None else paper.AbramowitzErf(self.terms)
        return paper.ClosedForm(tangent=self.tangent, erf=erf, variant=variant)

    def fft(self) -> paper.Fraunhofer:
        """Return the FFT method of the paper's comparison: a transform of the image's size, without zero padding."""
        # With a pupil radius of R samples, a transform of n samples has the pixel pitch 2 pi R / n in v. Its n / 2
        # pixels from the centre to the edge span pi R, which must equal the window; `samples` is 2 R.
        return paper.Fraunhofer(samples=math.floor(2.0 * self.window / math.pi), padding=1.0)

    def image(self, method: methods.Method) -> NDArray[np.float64]:
        """Return the intensity at the pixels, relative to the peak of the aperture without aberration."""
        pupil = Pupil(Wavefront(self.defocus))
        return np.asarray(
            psf(pupil, self.shape, self.pixel, method=method, normalize="strehl", dtype="float64").values
        )

    def images(self) -> dict[str, NDArray[np.float64]]:
        """Return the images "exact", "fft", "printed" and "corrected", each divided by the peak of "exact"."""
        methods = {"exact": REFERENCE, "fft": self.fft()} | {name: self.closed_form(name) for name in VARIANTS}
        images = {name: self.image(method) for name, method in methods.items()}
        peak = images["exact"].max()
        return {name: image / peak for name, image in images.items()}

    def facts(self) -> Facts:
        """Return the parameters in plain types."""
        return asdict(self)


@dataclass(frozen=True, eq=False)
class FigureData:
    """The data of a figure."""

    title: str
    arrays: Arrays  # all data, including images
    columns: Arrays  # one-dimensional data of equal length, for a spreadsheet
    facts: Facts = field(default_factory=dict)  # settings and errors, in plain types


def middle_row(image: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the pixels of an image from its centre to its right edge."""
    return image[image.shape[0] // 2, image.shape[1] // 2 :]


def measures(images: Mapping[str, NDArray[np.float64]]) -> dict[str, Facts]:
    """Return errors of :meth:`Setting.images` against "exact"; for both variants also the MSE against "fft"."""
    exact = images["exact"]
    errors: dict[str, Facts] = {
        name: {"mse": mse(image, exact), "peak_error": peak_error(image, exact)}
        for name, image in images.items()
        if name != "exact"
    }
    for name in VARIANTS:
        errors[name]["mse_against_fft"] = mse(images[name], images["fft"])
        errors[name]["peak_error_of_slice"] = float(np.abs(middle_row(images[name]) - middle_row(exact)).max())
    return errors


_V_AXIS = "v = πr/(λN)"
_COLORS = {"exact": "black", "fft": "tab:green", "printed": "tab:red", "corrected": "tab:blue"}
_LABELS = {
    "exact": "exact (NijboerZernike)",
    "fft": "FFT, as large as the image",
    "printed": "CFIS, Eq. (12) as printed",
    "corrected": "CFIS, with √(2/π) restored",
}


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure of `width` by `height` inches."""
    from matplotlib.figure import Figure as NewFigure

    return NewFigure(figsize=(width, height), layout="constrained")


def panels(figure: Figure, count: int, **properties: object) -> NDArray[np.object_]:
    """Add `count` axes in a row, each with grid lines and the same properties, and return them."""
    row: NDArray[np.object_] = figure.subplots(1, count, squeeze=False)[0]
    for axes in row:
        axes.set(**properties)
        axes.grid(alpha=0.3)
    return row


def _intensity_norm(top: float) -> Normalize:
    """Return a square-root colour scale from 0 to `top`, on which faint rings remain visible beside the peak."""
    from matplotlib.colors import PowerNorm

    return PowerNorm(0.5, 0.0, top)


def _picture(axes: Axes, values: NDArray[np.float64], window: float, norm: Normalize, title: str) -> AxesImage:
    """Draw an image with axes in v, which is 0 at the middle pixel and `window` at the edge."""
    side = values.shape[0]
    step = window / (side // 2)
    low, high = -(side // 2 + 0.5) * step, (side - side // 2 - 0.5) * step
    is_signed = norm.vmin is not None and norm.vmin < 0
    image = axes.imshow(
        values,
        extent=(low, high, high, low),
        norm=norm,
        cmap="RdBu_r" if is_signed else "magma",
        interpolation="nearest" if side < 256 else "antialiased",
    )
    axes.set_title(title, fontsize=9)
    axes.tick_params(labelsize=7)
    axes.locator_params(nbins=5)
    return image


_PITCH = 145.0 / 256.0  # pixel pitch in v, as in the other figures
_DEFOCUS = 10.0  # C_d, radians
_MIN_TOTAL_SECONDS = 0.1  # a run is repeated until all runs together take this long

_STYLES = {
    "Huygens, every pixel": ("tab:brown", "v"),
    "Huygens, every radius": ("tab:orange", "^"),
    "FFT of the pupil": ("tab:green", "s"),
    "Hankel": ("tab:purple", "D"),
    "CFIS, Eq. (14), N = 30": ("tab:red", "o"),
    "CFIS, Fresnel integrals": ("tab:blue", "o"),
    "NijboerZernike": ("black", "*"),
}


def methods_cost(sizes: Sequence[int] = (32, 64, 128, 256, 512, 1024), budget: float = 1.5) -> FigureData:
    """Time every method on images of n x n pixels, on one thread.

    Parameters
    ----------
    sizes : sequence of int
        Values of n, increasing. The pixel pitch is fixed, so that the window grows with n; C_d = 10.
    budget : float
        Maximum estimated time of one image, in seconds. A method whose estimate exceeds it is not timed at larger n.

    Returns
    -------
    FigureData
        For each method and n, the time divided by the time of one complex FFT of n x n, and the largest error of the
        image divided by the exact peak; NaN if the method was not timed at this n.
    """
    ratios, errors = np.full((2, len(_STYLES), len(sizes)), np.nan)
    fft_seconds = np.empty(len(sizes))
    last_seconds = dict.fromkeys(_STYLES, 0.0)
    for k, n in enumerate(sizes):
        random_image = np.random.default_rng(n).normal(size=(n, n)) + 0j
        fft_seconds[k] = _time(partial(scipy.fft.fft2, random_image))[1]
        for i, (name, (method, pupil)) in enumerate(_methods(n).items()):
            # If n doubles, there are 4 times as many pixels; "every pixel" also has 4 times as many sources.
            growth = 16.0 if name == "Huygens, every pixel" else 4.0
            if growth * last_seconds[name] > budget:
                last_seconds[name] = math.inf
                continue
            pixel = _PITCH / math.pi * pupil.scale
            compute = partial(psf, pupil, n, pixel, method=method, normalize="strehl", dtype="float64", threads=1)
            image, last_seconds[name] = _time(compute)
            ratios[i, k] = last_seconds[name] / fft_seconds[k]
            exact = psf(Pupil(Wavefront(_DEFOCUS)), n, _PITCH / math.pi, method=REFERENCE, normalize="strehl")
            errors[i, k] = peak_error(image, exact)
    side = np.asarray(sizes)
    columns = {"n": side, "FFT (s)": fft_seconds}
    columns |= {f"{name}: time / FFT": values for name, values in zip(_STYLES, ratios, strict=True)}
    columns |= {f"{name}: peak error": values for name, values in zip(_STYLES, errors, strict=True)}
    names = np.array(list(_STYLES))
    arrays = {"n": side, "fft_seconds": fft_seconds, "methods": names, "ratio": ratios, "peak_error": errors}
    facts = {"pitch": _PITCH, "defocus": _DEFOCUS, "threads": 1, "unit": "one complex FFT of n x n, measured here"}
    return FigureData("Methods and cost against n", arrays, columns, facts)


def _methods(n: int) -> dict[str, tuple[methods.Method, Pupil]]:
    """Return each method with its pupil; HuygensFresnel needs the pupil of a lens, since it sums over distances."""
    pupil = Pupil(Wavefront(_DEFOCUS))
    # The paper's aperture radius is R_max = 0.0015 m. The lens is focused at infinity, and the object distance is
    # chosen so that the defocus is _DEFOCUS.
    wavelength, radius = 550e-9, 1.5e-3
    lens = Lens(focal_length=30e-3, aperture_diameter=2 * radius, focus_distance=math.inf, wavelength=wavelength)
    defocused = lens.pupil(math.pi * radius**2 / (2.0 * _DEFOCUS * wavelength))
    blur, window = float(pupil.v(pupil.geometric_radius())), (n / 2 + 0.5) * _PITCH
    # Use so many samples that the blur disc of the next period of the discrete transform is outside the window.
    min_samples = max(8, math.ceil((blur + window) / math.pi) + 1)
    return {
        "Huygens, every pixel": (paper.HuygensFresnel(symmetry=False), defocused),
        "Huygens, every radius": (paper.HuygensFresnel(), defocused),
        "FFT of the pupil": (paper.Fraunhofer(samples=min_samples, padding=1.0), pupil),
        "Hankel": (methods.Hankel(), pupil),
        "CFIS, Eq. (14), N = 30": (paper.ClosedForm(erf=paper.AbramowitzErf(30), variant="printed"), pupil),
        "CFIS, Fresnel integrals": (paper.ClosedForm(erf=paper.FresnelErf()), pupil),
        "NijboerZernike": (methods.NijboerZernike(), pupil),
    }


def _time(function: Callable[[], _Result]) -> tuple[_Result, float]:
    """Call `function` 2 to 8 times, since the first call fills caches; return the result and shortest time (s)."""
    seconds = list[float]()
    while True:
        start = time.perf_counter()
        result = function()
        seconds.append(time.perf_counter() - start)
        if len(seconds) == 8 or (len(seconds) > 1 and sum(seconds) > _MIN_TOTAL_SECONDS):
            return result, min(seconds)


def draw_methods_cost(data: FigureData) -> Figure:
    """Draw the time against n, and for each method the error against the time at its largest timed n <= 512."""
    figure = new_figure(10.5, 4.4)
    left, right = panels(figure, 2, xlabel="time / one complex FFT of n × n")
    n, names = data.arrays["n"], [str(name) for name in data.arrays["methods"]]
    for name, ratio, error in zip(names, data.arrays["ratio"], data.arrays["peak_error"], strict=True):
        color, marker = _STYLES[name]
        left.loglog(n, ratio, marker=marker, color=color, label=name)
        timed_sizes = np.flatnonzero(np.isfinite(ratio) & (n <= 512))
        if timed_sizes.size:
            k = timed_sizes[-1]
            right.loglog(ratio[k], max(float(error[k]), 1e-17), marker=marker, color=color, markersize=9)
            if n[k] != 512:
                right.annotate(
                    f"n = {n[k]}", (ratio[k], error[k]), textcoords="offset points", xytext=(7, 5), fontsize=7
                )
    left.axhline(1.0, color="grey", linewidth=0.8, linestyle="--")
    left.set_xticks(n, [str(k) for k in n])
    left.minorticks_off()
    left.set(xlabel="n (pixels along a side)", ylabel="time / one complex FFT of n × n")
    left.legend(fontsize=7)
    left.set_title("Cost of an image of n × n pixels", fontsize=10)
    right.set_ylabel("largest difference from the exact PSF / peak")
    note = "Huygens differs by the error\nof the Fresnel approximation"
    right.annotate(note, (0.97, 0.5), xycoords="axes fraction", ha="right", fontsize=7, color="tab:brown")
    right.set_title("Error against cost, n = 512 unless labelled", fontsize=10)
    right.margins(0.15, 0.1)
    return figure


_BESSEL = {
    "series": ("Eq. (6), three terms", "tab:orange", "--"),
    "asymptotic": ("Eq. (7)", "tab:green", "--"),
    "piecewise": ("Eq. (8)", "tab:purple", "-"),
    "printed": ("Eq. (12) as printed, TLC = 100", "tab:red", "-"),
    "corrected": ("Eq. (12) with √(2/π), TLC = 100", "tab:blue", "-"),
}


def bessel_forms(samples: int = 2001, max_a: float = 200.0, tangent: float = 100.0) -> FigureData:
    """Evaluate J0 and its approximations at arguments a from 0.05 to `max_a`, evenly spaced in log a.

    The columns "printed" and "corrected" are the approximation of J0 in Eq. (12): three terms of Eq. (6) if a <= 1,
    and Eq. (7) with Eq. (9) in place of the square root if a > 1. Only "corrected" has the factor sqrt(2 / pi).
    """
    a = np.geomspace(0.05, max_a, samples)
    slope, level = tangent_line(tangent)
    series, asymptotic = j0_series(a, 3), j0_asymptotic(a)
    large_form = (slope * a + level + 1.0 / a) * np.cos(a - 0.25 * math.pi)
    is_small = a <= 1.0
    columns = {
        "a": a,
        "J0": np.asarray(scipy.special.j0(a)),
        "series": series,
        "asymptotic": asymptotic,
        "piecewise": np.where(is_small, series, asymptotic),
        "printed": np.where(is_small, series, large_form),
        "corrected": np.where(is_small, series, math.sqrt(2.0 / math.pi) * large_form),
    }
    columns |= {f"error of {name}": columns[name] - columns["J0"] for name in _BESSEL}
    facts = {
        "tangent": tangent,
        "transition": 1.0,
        "largest_errors": {name: float(np.abs(columns[f"error of {name}"]).max()) for name in _BESSEL},
    }
    return FigureData("Comparison of various forms of J0(a)", dict(columns), columns, facts)


def draw_bessel_forms(data: FigureData) -> Figure:
    """Draw J0 and its approximations up to a = 15, and the errors of the approximations over the whole range of a."""
    figure = new_figure(10.5, 4.2)
    left, right = panels(figure, 2, xlabel="a = 2πkR")
    c = data.columns
    left.plot(c["a"], c["J0"], color="black", linewidth=3.0, alpha=0.35, label="J0(a)")
    for name, (label, color, line) in _BESSEL.items():
        left.plot(c["a"], c[name], line, color=color, linewidth=1.2, label=label)
        right.loglog(c["a"], np.maximum(np.abs(c[f"error of {name}"]), 1e-17), line, color=color, linewidth=1.0)
    left.set(xlim=(0.0, 15.0), ylim=(-0.75, 1.25), ylabel="J0(a) and its approximations")
    left.legend(fontsize=7)
    right.set(xlim=(float(c["a"][0]), float(c["a"][-1])), ylim=(1e-7, 3.0), ylabel="absolute error")
    for axes in (left, right):
        axes.axvline(1.0, color="grey", linewidth=0.8, linestyle=":")
    left.set_title("J0 and its approximations; dotted: a = 1", fontsize=10)
    right.set_title("errors of the approximations", fontsize=10)
    return figure


def compare_with_fft(setting: Setting = Setting()) -> FigureData:
    """Compute a PSF by the FFT, both variants of the closed form and the exact method, divided by the exact peak."""
    images = setting.images()
    facts = setting.facts() | measures(images)
    facts["fft"]["method"] = repr(setting.fft())
    columns = {"v": setting.v} | {name: middle_row(image) for name, image in images.items()}
    arrays = {name: image.astype(np.float32) for name, image in images.items()} | {"v": setting.v}
    return FigureData("PSF comparison between FFT and CFIS", arrays, columns, facts)


def draw_comparison(data: FigureData) -> Figure:
    """Draw the four images on one colour scale and, below, slices from the centre and the errors of the slices."""
    figure = new_figure(11.0, 7.0)
    facts = data.facts
    figure.suptitle(
        f"C_d = {facts['defocus']:g}, TLC = {facts['tangent']:g}, N = {facts['terms']}; 1 is the exact peak",
        fontsize=10,
    )
    halves = figure.subfigures(2, 1, squeeze=False, height_ratios=(1.0, 1.15))[:, 0]
    pictures = halves[0].subplots(1, 4, squeeze=False, sharey=True)[0]
    norm = _intensity_norm(max(float(data.arrays[name].max()) for name in _LABELS))
    for axes, (name, label) in zip(pictures, _LABELS.items(), strict=True):
        title = label if name == "exact" else f"{label}\nMSE {facts[name]['mse']:.3g}"
        image = _picture(axes, data.arrays[name], facts["window"], norm, title)
        axes.set_xlabel("v along x", fontsize=8)
    pictures[0].set_ylabel("v along y", fontsize=8)
    halves[0].colorbar(image, ax=pictures, shrink=0.8, label="intensity / peak")
    slices, errors = panels(halves[1], 2, xlabel=_V_AXIS, xlim=(0.0, float(data.columns["v"][-1])))
    c = data.columns
    for name, label in _LABELS.items():
        slices.plot(c["v"], c[name], color=_COLORS[name], linewidth=2.5 if name == "exact" else 1.2, label=label)
        if name != "exact":
            errors.plot(c["v"], c[name] - c["exact"], color=_COLORS[name], linewidth=1.2, label=label)
    slices.set_ylabel("intensity / peak")
    slices.legend(fontsize=7)
    errors.set_ylabel("error / peak, along the slice")
    return figure


class Variation(NamedTuple):
    """A parameter that a figure varies: its label, its values, and other parameters that differ from the defaults."""

    label: str
    values: tuple[float, ...]
    fixed: dict[str, float] = {}  # noqa: RUF012 (never changed)


VARIED = {
    "terms": Variation("N", (10, 20, 30, 40)),
    "defocus": Variation("C_d", (5.0, 10.0, 20.0, 30.0)),
    # The paper does not state C_d and the window of Fig. 7; these values reproduce its errors best (tangent_search).
    "tangent": Variation("TLC", (100.0, 150.0, 200.0, 250.0), {"defocus": 22.0, "window": 185.0}),
}


def vary(parameter: str, setting: Setting = Setting(), values: Sequence[float] = ()) -> FigureData:
    """Compute both variants of the closed form, the FFT and the exact PSF for each value of one parameter."""
    label, default_values, other_parameters = VARIED[parameter]
    values, setting = values or default_values, replace(setting, **other_parameters)  # type: ignore[arg-type]
    arrays: Arrays = {"v": setting.v, parameter: np.asarray(values)}
    columns = {"v": setting.v}
    measured: list[Facts] = []
    for value in values:
        images = Setting(**setting.facts() | {parameter: value}).images()
        for name, image in images.items():
            arrays[f"{name}_{value:g}"] = image.astype(np.float32)
            columns[f"{name}, {label} = {value:g}"] = middle_row(image)
        measured.append({parameter: value} | measures(images))
    facts = setting.facts() | {"varies": parameter, "panels": measured}
    return FigureData(f"CFIS for varying {label}", arrays, columns, facts)


def draw_varied(data: FigureData, *, errors: bool = False) -> Figure:
    """Draw the images of both variants, or with `errors` the errors of these images, on one colour scale."""
    from matplotlib.colors import SymLogNorm

    varied, cases = data.facts["varies"], data.facts["panels"]

    def image(name: str, case: Facts) -> Values:
        return data.arrays[f"{name}_{case[varied]:g}"]

    images = {v: [image(v, case) - (image("exact", case) if errors else 0.0) for case in cases] for v in VARIANTS}
    top = max(float(np.abs(values).max()) for row in images.values() for values in row)
    norm: Normalize = _intensity_norm(top)
    if errors:  # linear up to 0.01 of the peak, logarithmic above
        norm = SymLogNorm(0.01, vmin=-top, vmax=top, base=10)
    figure = new_figure(2.35 * len(cases) + 1.3, 2.5 * len(VARIANTS) + 0.6)
    constants = ", ".join(f"{item.label} = {data.facts[key]:g}" for key, item in VARIED.items() if key != varied)
    figure.suptitle(f"{'CFIS minus exact PSF' if errors else 'CFIS'}, {constants}; {_V_AXIS}", fontsize=10)
    grid = figure.subplots(len(VARIANTS), len(cases), squeeze=False, sharex=True, sharey=True)
    for variant, axes_row in zip(VARIANTS, grid, strict=True):
        for axes, values, case in zip(axes_row, images[variant], cases, strict=True):
            title = f"{VARIED[varied].label} = {case[varied]:g}"
            if errors:
                title += f": MSE {case[variant]['mse']:.3g}\nlargest {case[variant]['peak_error']:.2f}"
            picture = _picture(axes, values, data.facts["window"], norm, title)
        axes_row[0].set_ylabel(f"{variant}\nv along y", fontsize=8)
    for axes in grid[-1]:
        axes.set_xlabel(f"{_V_AXIS} along x" if len(cases) < 3 else "v along x", fontsize=8)
    label = f"{'error' if errors else 'intensity'} / exact peak"
    bar = figure.colorbar(picture, ax=grid, shrink=0.8, label=label)
    if errors:
        magnitudes = [m for m in (0.01, 0.03, 0.1, 0.3, 1.0, 3.0) if m <= top]
        ticks = [*(-m for m in reversed(magnitudes)), 0.0, *magnitudes]
        bar.set_ticks(ticks, labels=[f"{m:g}".replace("-", "−") for m in ticks])
    bar.ax.tick_params(labelsize=7)
    return figure


SPHERICAL = 10.0  # C_s, radians
PIECES = 5  # number of quadratics of Eq. (17)
_SPLIT_COLORS = {"linear": "tab:red", "sqrt": "tab:orange", "log": "tab:green", "optimal": "tab:blue"}


def fit_quartic(variant: str, spherical: float, pieces: int = PIECES, split: str = "") -> PiecewiseQuadratic:
    """Return the least-squares fit of Eq. (17); "corrected" also fits the constants gamma_i that the paper omits."""
    is_corrected = variant == "corrected"
    split = split or ("optimal" if is_corrected else "linear")
    return fit_quadratics((0.0, spherical), pieces, split=split, fit="least-squares", piston=is_corrected)


def quartic_phase(samples: int = 1000, max_pieces: int = 12, spherical: float = SPHERICAL) -> FigureData:
    """Fit exp(i C_s rho^4) by exponentials of quadratics in rho, one for each of several intervals (pieces).

    The fits that are drawn have :data:`PIECES` intervals. The MSE is computed for 1 to `max_pieces` intervals, for
    each method of :data:`SPLITS` to split 0 <= rho <= 1, with and without constants gamma_i.
    """
    rho = (np.arange(samples) + 0.5) / samples
    phase = spherical * rho**4
    fits = {kind: fit_quartic(kind, spherical) for kind in VARIANTS}
    columns: Arrays = {"rho": rho, "phase": phase}
    for name, fit in fits.items():
        columns[f"{name} fit"] = fit.phase(rho)
        columns[f"{name} error"] = np.abs(np.exp(1j * fit.phase(rho)) - np.exp(1j * phase))
    counts = np.arange(1, max_pieces + 1)
    mse = {
        (split, kind): np.array([fit_quartic(kind, spherical, int(n), split).mse((0.0, spherical)) for n in counts])
        for split in SPLITS
        for kind in VARIANTS
    }
    arrays = dict(columns) | {"pieces": counts}
    arrays |= {f"mse_{split}_{kind}": values for (split, kind), values in mse.items()}
    for name, fit in fits.items():
        arrays |= {f"{name}_{part}": getattr(fit, part) for part in ("edges", "alpha", "beta", "gamma")}
    facts = {
        "defocus": 0.0,
        "spherical": spherical,
        "pieces": PIECES,
        "printed": {"split": "linear", "constant": False, "mse": fits["printed"].mse((0.0, spherical))},
        "corrected": {"split": "optimal", "constant": True, "mse": fits["corrected"].mse((0.0, spherical))},
    }
    return FigureData("Piecewise quadratic phase", arrays, columns, facts)


def draw_quartic_phase(data: FigureData) -> Figure:
    """Draw the phase with the fitted quadratics, the errors of both fits, and the MSE against the count of pieces."""
    figure = new_figure(13.0, 4.2)
    left, middle, right = panels(figure, 3, xlabel="ρ = R / R_max")
    a, facts = data.arrays, data.facts
    left.plot(a["rho"], a["phase"], color="black", linewidth=4.0, alpha=0.3, label=f"{facts['spherical']:g} ρ⁴")
    edges = a["printed_edges"]
    for i in range(facts["pieces"]):
        is_inside = (a["rho"] >= edges[i]) & (a["rho"] < edges[i + 1])
        # Subtract a multiple of 2 pi, which does not change exp(i phase), to draw the piece close to the phase.
        cycles = np.round(np.mean(a["printed fit"][is_inside] - a["phase"][is_inside]) / (2.0 * np.pi))
        left.plot(a["rho"][is_inside], a["printed fit"][is_inside] - 2.0 * np.pi * cycles, linewidth=1.6,
                  label=f"{a['printed_alpha'][i]:.2f} ρ² {a['printed_beta'][i]:+.2f} ρ")  # fmt: skip
    left.set_ylabel("phase (rad), pieces modulo 2π")
    left.legend(fontsize=7, title="as printed, linear split", title_fontsize=7)
    for name, color in (("printed", "tab:red"), ("corrected", "tab:blue")):
        split = "linear split, no constant" if name == "printed" else "optimal split, constants γ"
        middle.semilogy(a["rho"], np.maximum(a[f"{name} error"], 1e-6), color=color, linewidth=1.2,
                        label=f"{name}: {split}\nMSE {facts[name]['mse']:.3g}")  # fmt: skip
    middle.set(ylabel="|exp(i fit) − exp(i phase)|", ylim=(1e-5, 1.0))
    middle.legend(fontsize=7)
    for split in SPLITS:
        for kind, line in (("printed", "--"), ("corrected", "-")):
            right.semilogy(a["pieces"], a[f"mse_{split}_{kind}"], line, marker=".", color=_SPLIT_COLORS[split],
                           label=f"{split}{', no constant' if kind == 'printed' else ''}")  # fmt: skip
    right.axhline(1.37e-4, color="grey", linewidth=0.9, linestyle=":")
    right.annotate("paper: 0.000137 with 5", (8.0, 1.6e-4), fontsize=7, color="grey")
    right.set(xlabel="pieces", ylabel="MSE of the pupil function")
    right.legend(fontsize=7, ncols=2)
    figure.suptitle(f"exp(i C_s ρ⁴) by quadratics on segments (Eq. 17), C_s = {facts['spherical']:g}", fontsize=10)
    return figure


Errors = tuple[NDArray[np.float64], NDArray[np.float64]]

FIRST = Setting()
# Setting with the closest errors to the two errors of the paper's tangent-line comparison; see `tangent_search`.
SECOND = replace(FIRST, **VARIED["tangent"].fixed)  # type: ignore[arg-type]

# Values that are searched for parameters that the paper does not state (window in v, C_d, C_s), and the paper's TLCs.
WINDOWS = np.arange(100.0, 301.0, 1.0)
DEFOCI = np.arange(11.0, 41.0, 1.0)
TANGENTS = (100.0, 200.0)
SPHERICALS = np.arange(1.0, 20.05, 0.1)

# Errors that the paper states: MSE and peak error of Fig. 3, MSE for each of TANGENTS, and MSE of Eq. (17).
PAPER_MSE, PAPER_PEAK = 0.0009, 0.368
PAPER_TANGENT = (0.0196, 0.00199)
PAPER_PIECES = 0.000137


def rows(first: Setting = FIRST, second: Setting = SECOND) -> list[Facts]:
    """Return the rows of the table: a number of the paper, the computed numbers, the settings, and a search result.

    The search varies parameters that the paper does not state, and returns the number closest to the paper's number.
    """
    return [*_first_rows(first), *_tangent_rows(second), _pieces_row()]


def _first_rows(setting: Setting) -> list[Facts]:
    images = setting.images()
    errors_of = measures(images)
    text = f"{_text(setting)}; window (not in the paper) v <= {setting.window:g}"
    errors = {variant: squared_errors(replace(setting, window=float(WINDOWS[-1])), variant) for variant in VARIANTS}
    means = {variant: [mean_over_window(errors[variant], float(w)) for w in WINDOWS] for variant in VARIANTS}
    slices = {v: [_slice_error(replace(setting, window=float(w)), v) for w in WINDOWS] for v in VARIANTS}
    search = f"window v from {WINDOWS[0]:g} to {WINDOWS[-1]:g}"
    near_count = sum(abs(error / PAPER_PEAK - 1.0) < 0.01 for error in slices["printed"])
    return [
        {
            "quantity": "MSE at C_d = 10, TLC = 100, N = 30",
            "paper": PAPER_MSE,
            **{variant: errors_of[variant]["mse"] for variant in VARIANTS},
            "against_fft": errors_of["printed"]["mse_against_fft"],
            "settings": text,
            "searched": search,
            "closest": {v: _closest("window", WINDOWS, means[v], PAPER_MSE) for v in VARIANTS},
            "remark": f"Reproduced by Eq. (12) as printed, {_deviation(errors_of['printed']['mse'], PAPER_MSE)}.",
        },
        {
            "quantity": "peak error of the slice",
            "paper": PAPER_PEAK,
            **{variant: own_peak_error(images[variant], images["exact"]) for variant in VARIANTS},
            "against_fft": own_peak_error(images["printed"], images["fft"]),
            "settings": f"{text}; each PSF divided by its own peak. Divided by the exact peak, the errors are "
            + ", ".join(f"{errors_of[variant]['peak_error_of_slice']:.3f} ({variant})" for variant in VARIANTS),
            "searched": search,
            "closest": {v: _closest("window", WINDOWS, slices[v], PAPER_PEAK) for v in VARIANTS},
            "remark": "Not reproduced at the window of the first number. The printed form oscillates near the "
            "axis (v = 1 to 3), so that the error depends on the positions of the pixels. It is within 1 % of the "
            f"paper's number at {near_count} of the {len(WINDOWS)} windows tried, and does not determine the window.",
        },
    ]


def _tangent_rows(setting: Setting) -> list[Facts]:
    errors = {tangent: measures(replace(setting, tangent=tangent).images()) for tangent in TANGENTS}
    search = f"C_d from {DEFOCI[0]:g} to {DEFOCI[-1]:g}, window v from {WINDOWS[0]:g} to {WINDOWS[-1]:g}"
    closest = {variant: tangent_search(variant, setting.terms) for variant in VARIANTS}
    deviations = [_deviation(a, b) for a, b in zip(closest["printed"]["values"], PAPER_TANGENT, strict=True)]
    remark = (
        "No C_d and window of the searched range reproduces both numbers within 10 %. At the closest pair, the "
        f"MSE of the printed form is {deviations[0]} for TLC = {TANGENTS[0]:g} and {deviations[1]} for TLC = "
        f"{TANGENTS[1]:g}. The large decrease of the error from TLC = {TANGENTS[0]:g} to {TANGENTS[1]:g} is "
        "reproduced. With the restored factor the error increases instead, unless the window is so large that the "
        "rings of Eq. (14) dominate the error, as at the closest pair of that variant."
    )
    return [
        {
            "quantity": f"MSE of strong defocus at TLC = {tangent:g}",
            "paper": paper,
            **{variant: errors[tangent][variant]["mse"] for variant in VARIANTS},
            "against_fft": errors[tangent]["printed"]["mse_against_fft"],
            "settings": f"{_text(replace(setting, tangent=tangent))}; C_d and window (v <= {setting.window:g}) are "
            "not in the paper",
            "searched": search,
            "closest": {v: {"value": closest[v]["values"][k], "at": closest[v]["at"]} for v in VARIANTS},
            "remark": remark,
        }
        for k, (tangent, paper) in enumerate(zip(TANGENTS, PAPER_TANGENT, strict=True))
    ]


def _pieces_row() -> Facts:
    def fit_mse(variant: str, c: float) -> float:
        return fit_quartic(variant, c).mse((0.0, c))

    return {
        "quantity": "MSE of 5 quadratic exponentials",
        "paper": PAPER_PIECES,
        **{variant: fit_mse(variant, SPHERICAL) for variant in VARIANTS},
        "against_fft": None,
        "settings": f"C_s = {SPHERICAL:g} (not in the paper), C_d = 0; printed: linear split, no constant; "
        "corrected: optimal split, constants gamma_i",
        "searched": f"C_s from {SPHERICALS[0]:g} to {SPHERICALS[-1]:g}",
        "closest": {
            v: _closest("spherical", SPHERICALS, [fit_mse(v, float(c)) for c in SPHERICALS], PAPER_PIECES)
            for v in VARIANTS
        },
        "remark": "Reproduced with the linear split and the best alpha_i and beta_i, without constants. Defocus adds "
        "C_d to every alpha_i and leaves the MSE unchanged, if the constant phase -C_d of Eq. (16) is omitted.",
    }


def squared_errors(setting: Setting, variant: str, step: float = 0.15) -> Errors:
    """Return v up to the corner of the window, and ((I - I_exact) / max I_exact)^2 of the closed form at these v."""
    v = np.arange(0.5, math.sqrt(2.0) * setting.window / step + 1.0) * step
    exact, image = _intensities(setting, variant, v)
    return v, ((image - exact) / exact.max()) ** 2


def mean_over_window(errors: Errors, window: float) -> float:
    """Return the mean over a square of half side `window` of a radial function, given at evenly spaced v."""
    v, values = errors
    # Fraction of the circle of radius v that is outside the square, at most 1.
    outside_fraction = np.arccos(np.minimum(1.0, window / v)) * (4.0 / math.pi)
    weight = v * np.maximum(0.0, 1.0 - outside_fraction)
    return float(weight @ values / weight.sum())


def tangent_search(variant: str, terms: int | None = 30) -> Facts:
    """Return C_d and window with the closest errors to the two errors of the paper's tangent-line comparison.

    Closest means the smallest sum of abs(log(computed / paper)) for the two errors.
    """
    results = []
    for defocus in DEFOCI:
        errors = [
            squared_errors(
                Setting(window=float(WINDOWS[-1]), defocus=float(defocus), tangent=t, terms=terms), variant, 0.4
            )
            for t in TANGENTS
        ]
        for window in WINDOWS[::5]:
            values = [mean_over_window(error, float(window)) for error in errors]
            distance = sum(abs(math.log(a / b)) for a, b in zip(values, PAPER_TANGENT, strict=True))
            parameters = {"defocus": float(defocus), "window": float(window)}
            results.append((distance, {"values": values, "at": parameters}))
    return min(results, key=lambda pair: pair[0])[1]


def own_peak_error(image: NDArray[np.float64], exact: NDArray[np.float64]) -> float:
    """Return the largest difference between the middle rows of two images, each divided by its own peak."""
    return float(np.abs(middle_row(image) / image.max() - middle_row(exact) / exact.max()).max())


def _slice_error(setting: Setting, variant: str) -> float:
    """Return :func:`own_peak_error` of a setting; only the middle rows are computed."""
    exact, image = _intensities(setting, variant, setting.v)
    return float(np.abs(image / image.max() - exact / exact.max()).max())


def _intensities(setting: Setting, variant: str, v: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Return the exact intensity and the intensity of the closed form at the coordinates v."""
    pupil = Pupil(Wavefront(setting.defocus))
    return [np.abs(method.field(pupil, v)) ** 2 for method in (REFERENCE, setting.closed_form(variant))]


def _closest(name: str, parameters: NDArray[np.float64], values: Sequence[float], target: float) -> Facts:
    """Return the value with the least abs(log(value / target)), and the parameter `name` that yields it."""
    value, x = min(zip(values, parameters.tolist(), strict=True), key=lambda pair: abs(math.log(pair[0] / target)))
    return {"value": value, "at": {name: x}}


def _deviation(value: float, target: float) -> str:
    return f"{percent(abs(value / target - 1.0))} too {'large' if value > target else 'small'}"


def _text(setting: Setting) -> str:
    size = f"{setting.shape} x {setting.shape}"
    return f"{size}, C_d = {setting.defocus:g}, TLC = {setting.tangent:g}, N = {setting.terms}"


def markdown(table: list[Facts]) -> str:
    """Return the table as Markdown."""
    lines = [
        "| quantity | paper | as printed | corrected | printed, against the FFT |",
        "|---|---:|---:|---:|---:|",
    ]
    for row in table:
        cells = [row["quantity"], *(number(row[key]) for key in ("paper", *VARIANTS, "against_fft"))]
        lines.append("| " + " | ".join(cells) + " |")
    lines += ["", "Closest to the paper over the parameters that it does not state:", ""]
    lines += ["| quantity | as printed | corrected |", "|---|---|---|"]
    for row in table:
        cells = [row["quantity"], *(closest_text(row["closest"][variant]) for variant in VARIANTS)]
        lines.append("| " + " | ".join(cells) + " |")
    lines.append("")
    # Consecutive rows with the same search and remark share one item.
    for (searched, remark), rows in groupby(table, key=itemgetter("searched", "remark")):
        settings = " ".join(f"**{row['quantity']}.** Settings: {row['settings']}." for row in rows)
        lines += textwrap.wrap(f"- {settings} Searched: {searched}. {remark}", 118, subsequent_indent="  ")
    return "\n".join(lines) + "\n"


def number(value: float | None) -> str:
    """Return a number with three digits, "-" for None."""
    return "-" if value is None else f"{value:.3g}"


def closest_text(closest: Facts) -> str:
    """Return a text with the closest value and the parameters that yield it."""
    names = {"window": "v <=", "defocus": "C_d =", "spherical": "C_s ="}
    return f"{number(closest['value'])} at " + ", ".join(f"{names[key]} {x:g}" for key, x in closest["at"].items())


@dataclass(frozen=True)
class _FigurePlan:
    """Caption of a figure, and the functions that compute its data and draw it."""

    caption: str
    compute: Callable[[], FigureData]
    draw: Callable[[FigureData], Figure]


_draw_errors = partial(draw_varied, errors=True)
FIGURES = {
    "1": _FigurePlan("Methods and cost against n", methods_cost, draw_methods_cost),
    "2": _FigurePlan("Comparison of various forms of J0(a)", bessel_forms, draw_bessel_forms),
    "3": _FigurePlan("PSF comparison between FFT and CFIS", compare_with_fft, draw_comparison),
    "4": _FigurePlan("CFIS PSF for varying N", partial(vary, "terms"), draw_varied),
    "5": _FigurePlan("Error of the CFIS PSF for varying N", partial(vary, "terms"), _draw_errors),
    "6": _FigurePlan("Error of the CFIS PSF for varying defocus", partial(vary, "defocus"), _draw_errors),
    "7": _FigurePlan(
        "Error of the CFIS PSF for varying tangent-line centres (TLC)", partial(vary, "tangent"), _draw_errors
    ),
    "eq17": _FigurePlan("The piecewise quadratic phase of Eq. (17)", quartic_phase, draw_quartic_phase),
}
"""Figures by their numbers in the paper; "eq17" illustrates Eq. (17)."""

TABLE = ("table.md", "table.json")


def names(figure: str) -> tuple[str, str, str]:
    """Return the file names of a figure: picture, arrays, columns."""
    return f"figure-{figure}.png", f"figure-{figure}.npz", f"figure-{figure}.csv"


def reproduce(
    folder: Path, chosen: Iterable[str] | None = None, on_start: Callable[[str], object] = str, *, dpi: float = 130.0
) -> Facts:
    """Write the `chosen` figures, or all figures and the table; return file names, facts of figures and the table.

    `on_start` is called with a description before each computation.
    """
    figures = list(FIGURES) if chosen is None else list(dict.fromkeys(chosen))
    for figure in figures:
        if figure not in FIGURES:
            raise ValueError(f"there is no figure {figure}; choose from {', '.join(FIGURES)}")
    folder.mkdir(parents=True, exist_ok=True)
    files: list[str] = []

    def write(name: str, data: bytes) -> None:
        atomic.write(folder / name, data)
        files.append(str(folder / name))

    facts = {}
    for figure in figures:
        on_start(f"figure {figure}: {FIGURES[figure].caption}")
        data = FIGURES[figure].compute()
        # All three files are encoded before the first file is written.
        contents = (picture(FIGURES[figure].draw(data), dpi), archive(data), spreadsheet(data))
        for name, content in zip(names(figure), contents, strict=True):
            write(name, content)
        facts[figure] = {"caption": FIGURES[figure].caption} | data.facts
    table = None
    if chosen is None:
        on_start("the numbers")
        table = rows()
        write(TABLE[0], markdown(table).encode())
        write(TABLE[1], (json.dumps({"rows": table}, indent=2, allow_nan=False) + "\n").encode())
    return {"files": files, "figures": facts, "table": table}


def picture(figure: Figure, dpi: float) -> bytes:
    """Return a figure as PNG bytes."""
    return atomic.contents(figure.savefig, format="png", dpi=dpi)


def archive(data: FigureData) -> bytes:
    """Return the arrays as .npz bytes, with title and facts as JSON in the array "description"."""
    description = json.dumps({"title": data.title} | data.facts, allow_nan=False)
    return atomic.contents(np.savez_compressed, description=np.array(description), **data.arrays)


def spreadsheet(data: FigureData) -> bytes:
    """Return the columns as .csv bytes, with their names in the first line; NaN is an empty cell."""
    lines = [",".join(f'"{name}"' if "," in name else name for name in data.columns)]
    lines += [
        ",".join("" if np.isnan(value) else f"{value:.9g}" for value in row)
        for row in zip(*data.columns.values(), strict=True)
    ]
    return ("\n".join(lines) + "\n").encode()
