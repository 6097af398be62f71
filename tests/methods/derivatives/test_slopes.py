"""Derivatives of images, by every name and of every pupil that has them, against differences of PSFs."""

from __future__ import annotations

import os
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

import lommel as lm
from changes import FINE, changed, differences
from lommel.core.answers import ToleranceError
from lommel.methods import ChordalGauss, Polychromatic
from lommel.optics.grid import Grid

SEEDS = 40 if os.environ.get("HYPOTHESIS_PROFILE") == "thorough" else 4
TERMS = ((1, 1), (1, -1), (2, 0), (2, 2), (2, -2), (3, 1), (3, -3), (4, 0), (4, -2), (5, 1), (6, 0), (7, 3))
INDEXED = ("noll 8", "noll 11", "ansi 7", "fringe 9", "fringe 5")
POWERS = ("defocus", "spherical", "rho^6", "rho^8")
METRIC = ("wavelength", "f_number")
DISTANCES = ("object_distance", "focus_distance")


def drawn(rng: np.random.Generator) -> tuple[lm.Pupil, lm.Lens | None, dict, list]:
    """Return a pupil, the lens that it is of or None, what is asked about it, and names that it has."""
    shape = () if rng.random() < 0.7 else (2,)
    names = [*TERMS, *INDEXED, *POWERS, "row", "column"]
    amplitude = [0.0, float(rng.uniform(0.0, 1.5)), lm.Apodization([1.0, -1.6, 0.37])][rng.integers(3)]
    obscuration = float(rng.choice([0.0, rng.uniform(0.1, 0.7)]))
    nonradial = {t: rng.normal(0.0, 0.6, shape) for t in TERMS if t[1] and rng.random() < 0.25}
    wavefront = lm.Wavefront(
        rng.uniform(-4, 4, shape), rng.uniform(-2, 2, shape), (rng.uniform(-0.5, 0.5, shape),), nonradial
    )
    if rng.random() < 0.5:
        wavefront = lm.Wavefront(rng.uniform(-4, 4, shape), rng.uniform(-2, 2, shape))
    method, lens, more = None, None, {}
    kind = rng.integers(3)
    if kind == 0:
        pupil = lm.Pupil(wavefront, obscuration=obscuration, apodization=amplitude)
    elif kind == 1:
        more = {"wavelength": 5.5e-7, "f_number": float(rng.uniform(1.5, 6.0))}
        pupil = lm.Pupil(wavefront, obscuration=obscuration, apodization=amplitude, **more)
    else:
        lens = lm.Lens(
            focal_length=50e-3,
            f_number=2.8,
            focus_distance=2.0,
            wavelength=5.5e-7,
            aberrations=wavefront if rng.random() < 0.5 else lm.Wavefront(),
            obscuration=obscuration,
            apodization=amplitude,
        )
        pupil = lens.pupil(rng.uniform(1.8, 2.2, lens.aberrations.shape))
        names += DISTANCES * 3
    if kind:
        names += METRIC * 4
        if rng.random() < 0.2:
            method = Polychromatic([4.8e-7, 5.5e-7, 6.3e-7], rng.uniform(0.2, 1.0, 3))
    if obscuration:
        names += ["obscuration"] * 3
    if method is None and rng.random() < 0.3:
        method = ChordalGauss()
    center = tuple(rng.uniform(2.0, 6.0, 2)) if rng.random() < 0.7 else (rng.uniform(2.0, 6.0, pupil.shape or 1), 4.0)
    if pupil.shape == () and np.ndim(center[0]):
        center = (float(center[0][0]), 4.0)
    asked = {
        "shape": 9,
        "pixel": float(rng.uniform(0.2, 0.8)) * pupil.scale,
        "center": center,
        "integrate": bool(rng.random() < 0.4),
        "normalize": str(rng.choice(["energy", "strehl"])),
        "method": method,
    }
    return pupil, lens, asked, names


def step(name: object, pupil: lm.Pupil, lens: lm.Lens | None, grid: Grid) -> float:
    """Return a change that is small for the image: of some hundredths of a radian."""
    reach = grid._farthest * grid.step(pupil) + float(np.abs(pupil.wavefront.edge).sum()) / max(1, len(pupil.shape))
    if name in ("row", "column"):
        return 0.02 / grid.step(pupil)
    if name in METRIC:
        return 0.02 / (2.0 + reach) * getattr(pupil, name)
    if name == "obscuration":
        return min(0.02 / (1.0 + reach), 0.2 * pupil.obscuration)
    if name in DISTANCES:
        radius = 0.5 * lens.aperture_diameter
        return 0.02 / (np.pi * radius**2 / (2.0 * lens.wavelength * 1.8**2) + reach)
    return 0.02


def by_differences(
    pupil: lm.Pupil, name: object, lens: lm.Lens | None, asked: dict, h: float, peak: float
) -> tuple[np.ndarray, float]:
    """Return the derivative, and how far it may be off, of images as exact as can be proven: in the dark less so."""

    def values(fine: float, by: float) -> np.ndarray:
        return changed(pupil, name, by, lens, asked, fine).values

    try:
        return differences(partial(values, FINE), h, peak)
    except ToleranceError:
        return differences(partial(values, 10.0 * FINE), h, peak, 10.0 * FINE)


@pytest.mark.parametrize("seed", range(SEEDS))
def test_derivatives_are_those_of_differences_within_their_bounds(seed):
    rng = np.random.default_rng(seed)
    for _ in range(50):
        pupil, lens, asked, names = drawn(rng)
        picked = [names[i] for i in rng.choice(len(names), 3, replace=False)]
        tol = float(rng.choice([1e-6, 1e-6, 1e-8]))
        if isinstance(asked["method"], Polychromatic):
            asked["method"] = Polychromatic(asked["method"].wavelengths, asked["method"].weights, tol=tol)
        answer = lm.psf(pupil, tol=tol, dtype=np.float64, derivatives=picked, **asked)
        peaks = answer.values.reshape(-1, 81).max(axis=1)
        name = picked[0]
        h = step(name, pupil, lens, answer.grid)
        slope, off = by_differences(pupil, name, lens, asked, h, float(peaks.max()))
        error = np.abs(answer.derivatives[name] - slope).reshape(-1, 81).max(axis=1)
        told = f"{name} of {pupil} asked {asked} at {tol}"
        # How many hundredths of a radian, somewhere in the pupil, one of what it is by makes.
        unit = max(1.0, 0.02 / h)
        assert (error <= answer.derivative_bounds[name] * peaks + off).all(), told
        assert (error <= tol * unit * peaks + off).all(), told
        assert off <= 1e-7 * unit * peaks.max(), told


def test_stored_in_single_precision_derivatives_stay_within_their_bounds():
    lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=5.5e-7, obscuration=0.3)
    for aberrations in (lm.Wavefront(0.0, 0.7), lm.Wavefront(0.0, 0.7, nonradial={(3, 1): 1.0})):
        pupil = replace(lens, aberrations=aberrations).pupil(1.98)
        for names in ((*POWERS, "row"), ("row", *METRIC, *DISTANCES, "obscuration", (3, 1), "defocus")):
            for integrate in (False, True):
                asked = {"derivatives": names, "integrate": integrate, "center": (4.2, 3.3)}
                single = lm.psf(pupil, 9, 1.4e-6, **asked)
                double = lm.psf(pupil, 9, 1.4e-6, dtype=np.float64, tol=1e-10, **asked)
                for name in names:
                    assert single.derivatives[name].dtype == np.float32
                    off = np.abs(single.derivatives[name] - double.derivatives[name]).max() / double.values.max()
                    least = 2.0**-28 * np.abs(double.derivatives[name]).max() / double.values.max()
                    assert least <= off <= single.derivative_bounds[name]
                    assert double.derivative_bounds[name] <= 2e-3 * single.derivative_bounds[name]


def test_what_a_wavefront_leaves_out_counts():
    lens = {"wavelength": 5.5e-7, "f_number": 2.8, "obscuration": 0.3}
    rest = 1e-8
    known = lm.Wavefront(2.0, 0.5, nonradial={(3, 1): 1.0})
    left = lm.Wavefront.zernike({(4, 0): 1.0}, normalization="edge") * rest
    meant = lm.Pupil(known + left, **lens)
    told = lm.Pupil(known + lm.Wavefront(error=rest), **lens)
    names = ("defocus", (3, 1), "row", "wavelength", "f_number", "obscuration")
    for integrate in (False, True):
        asked = {"derivatives": names, "integrate": integrate, "tol": 1e-11, "dtype": np.float64}
        exact = lm.psf(meant, 9, 1e-6, **asked)
        answer = lm.psf(told, 9, 1e-6, **asked | {"tol": 1e-6, "method": ChordalGauss()})
        plain = lm.psf(lm.Pupil(known, **lens), 9, 1e-6, **asked)
        for name in names:
            off = np.abs(plain.derivatives[name] - exact.derivatives[name]).max() / exact.values.max()
            assert off > 10.0 * plain.derivative_bounds[name]
            assert off <= answer.derivative_bounds[name]
        # What is left out changes with the wavelength too, half as much as a term with a radian may be off by.
        known_bounds = lm.psf(lm.Pupil(known, **lens), 9, 1e-6, **asked | {"tol": 1e-6, "method": ChordalGauss()})
        more = {name: answer.derivative_bounds[name] - known_bounds.derivative_bounds[name] for name in names}
        phases = more["wavelength"] * lens["wavelength"] - more["f_number"] * lens["f_number"]
        assert phases == pytest.approx((np.abs(known.edge).sum() + 0.5) * more["defocus"], rel=1e-3)
