"""Fig. 1: cost of an image of n x n pixels by each method."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from lommel.measures.errors import peak_error
from lommel.methods import ClosedForm, Fraunhofer, Hankel, HuygensFresnel, Method, NijboerZernike
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.paper.figures import new_figure, panels
from lommel.paper.setting import REFERENCE, FigureData
from lommel.psf import psf
from lommel.special.erf import AbramowitzErf, FresnelErf

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PITCH = 145.0 / 256.0  # of the pixels in v, as in the other figures
DEFOCUS = 10.0
_LONG_ENOUGH = 0.1  # seconds: shorter runs are repeated, and the best is taken

_STYLES = {
    "Huygens, every pixel": ("tab:brown", "v"),
    "Huygens, every radius": ("tab:orange", "^"),
    "FFT of the pupil": ("tab:green", "s"),
    "Hankel": ("tab:purple", "D"),
    "CFIS, Eq. (14), N = 30": ("tab:red", "o"),
    "CFIS, Fresnel integrals": ("tab:blue", "o"),
    "NijboerZernike": ("black", "*"),
}


def compute(sizes: Sequence[int] = (32, 64, 128, 256, 512, 1024), budget: float = 1.5) -> FigureData:
    """Time every method on images of n x n pixels, on one thread.

    Parameters
    ----------
    sizes : sequence of int
        The n, rising. Pixels keep their pitch, so that the window grows with n; C_d = 10.
    budget : float
        Seconds: a method whose next n would take longer is left out from there on.

    Returns
    -------
    FigureData
        NaN where nothing was measured. Times are ratios to one complex FFT of n x n; errors, relative to the peak,
        are those of the same image against the exact one.
    """
    from scipy.fft import fft2

    ratios, errors = np.full((2, len(_STYLES), len(sizes)), np.nan)
    unit = np.empty(len(sizes))
    last = dict.fromkeys(_STYLES, 0.0)
    for k, n in enumerate(sizes):
        plain = np.random.default_rng(n).normal(size=(n, n)) + 0j
        unit[k] = _seconds(partial(fft2, plain))[1]
        for i, (name, (method, pupil)) in enumerate(_methods(n).items()):
            # Four times the pixels; where each asks the whole aperture, four times the sources too.
            growth = 16.0 if name == "Huygens, every pixel" else 4.0
            if growth * last[name] > budget:
                last[name] = math.inf
                continue
            pixel = PITCH / math.pi * pupil.scale
            work = partial(psf, pupil, n, pixel, method=method, normalize="strehl", dtype="float64", threads=1)
            answer, last[name] = _seconds(work)
            ratios[i, k] = last[name] / unit[k]
            truth = psf(Pupil(Wavefront(DEFOCUS)), n, PITCH / math.pi, method=REFERENCE, normalize="strehl")
            errors[i, k] = peak_error(answer, truth)
    side = np.asarray(sizes)
    columns = {"n": side, "FFT (s)": unit}
    columns |= {f"{name}: time / FFT": values for name, values in zip(_STYLES, ratios, strict=True)}
    columns |= {f"{name}: peak error": values for name, values in zip(_STYLES, errors, strict=True)}
    names = np.array(list(_STYLES))
    arrays = {"n": side, "fft_seconds": unit, "methods": names, "ratio": ratios, "peak_error": errors}
    facts = {"pitch": PITCH, "defocus": DEFOCUS, "threads": 1, "unit": "one complex FFT of n x n, measured here"}
    return FigureData("Methods and cost against n", arrays, columns, facts)


def _methods(n: int) -> dict[str, tuple[Method, Pupil]]:
    """Return each method with a pupil that it supports; Huygens needs the distances of a lens."""
    pupil = Pupil(Wavefront(DEFOCUS))
    # R_max = 0.0015 m as in the paper, focused at infinity; the object's distance makes the defocus.
    wavelength, radius = 550e-9, 1.5e-3
    lens = Lens(focal_length=30e-3, aperture_diameter=2 * radius, focus_distance=math.inf, wavelength=wavelength)
    near = lens.pupil(math.pi * radius**2 / (2.0 * DEFOCUS * wavelength))
    blur, window = float(pupil.v(pupil.geometric_radius())), (n / 2 + 0.5) * PITCH
    fewest = max(8, math.ceil((blur + window) / math.pi) + 1)
    return {
        "Huygens, every pixel": (HuygensFresnel(symmetry=False), near),
        "Huygens, every radius": (HuygensFresnel(), near),
        "FFT of the pupil": (Fraunhofer(samples=fewest, padding=1.0), pupil),
        "Hankel": (Hankel(), pupil),
        "CFIS, Eq. (14), N = 30": (ClosedForm(erf=AbramowitzErf(30), variant="printed"), pupil),
        "CFIS, Fresnel integrals": (ClosedForm(erf=FresnelErf()), pupil),
        "NijboerZernike": (NijboerZernike(), pupil),
    }


def _seconds(work: Callable[[], Any]) -> tuple[Any, float]:
    """Return an answer and the seconds of the best of several runs, the first of which fills the caches."""
    answer, passed = None, list[float]()
    while len(passed) < 2 or (len(passed) < 8 and sum(passed) <= _LONG_ENOUGH):
        start = time.perf_counter()
        answer = work()
        passed.append(time.perf_counter() - start)
    return answer, min(passed)


def draw(data: FigureData) -> Figure:
    """Draw cost against n, and error against cost at the largest n of each method."""
    figure = new_figure(10.5, 4.4)
    left, right = panels(figure, 2, xlabel="time / one complex FFT of n × n")
    n, names = data.arrays["n"], [str(name) for name in data.arrays["methods"]]
    for name, ratio, error in zip(names, data.arrays["ratio"], data.arrays["peak_error"], strict=True):
        color, marker = _STYLES[name]
        left.loglog(n, ratio, marker=marker, color=color, label=name)
        known = np.flatnonzero(np.isfinite(ratio) & (n <= 512))
        if known.size:
            k = known[-1]
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
    note = "Huygens differs by what the\nFresnel approximation leaves out"
    right.annotate(note, (0.97, 0.5), xycoords="axes fraction", ha="right", fontsize=7, color="tab:brown")
    right.set_title("Error against cost, n = 512 where nothing else is said", fontsize=10)
    right.margins(0.15, 0.1)
    return figure
