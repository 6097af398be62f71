"""Accuracy of PSF packages, each asked what its own tests and examples ask; ``--write`` writes docs/accuracy.md.

The truth is quadrature over the aperture (or, of measures, a closed form or a fine quadrature), which uses nothing of
lommel and no FFT. Each package is run as its documentation says, and at a setting of an expert where there is one.
"""

from __future__ import annotations

import argparse
import math
import time
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import lommel as lm

PAGE = Path(__file__).resolve().parent.parent / "docs" / "accuracy.md"
Array = NDArray[Any]
Ours = tuple[Array, float]


class Case(NamedTuple):
    """A question: the answer of a package, that of lommel with its bound, and the truth, at the same places.

    `measure`: the answers are numbers, whose error is relative to them; else images of any unit.
    """

    asked: str
    theirs: Callable[[], Array]
    ours: Callable[[], Ours]
    truth: Array
    cause: str = ""
    measure: bool = False


# The truth


def nodes(obscuration: float = 0.0, radial: int = 160, around: int = 320) -> tuple[Array, Array, Array]:
    """Return points x, y and weights over the aperture, which sum to 1: Gauss-Legendre by trapezoids."""
    g, w = np.polynomial.legendre.leggauss(radial)
    t = 0.5 * (1.0 + obscuration**2 + (1.0 - obscuration**2) * g)  # of rho^2
    angle = 2.0 * np.pi * (np.arange(around) + 0.5) / around
    rho = np.sqrt(t)[:, None]
    weight = np.repeat(0.5 * w / around, around)
    return (rho * np.cos(angle)).ravel(), (rho * np.sin(angle)).ravel(), weight


def image(
    phase: Callable[[Array, Array], Array] | None, across: Array, obscuration: float = 0.0, *, weight: Any = None
) -> Array:
    """Return I at places `across`, along rows and columns, in units of lambda*N, over that of no aberration."""
    x, y, w = nodes(obscuration)
    field = w * np.exp(1j * phase(x, y)) if phase else w.astype(complex)
    if weight is not None:
        field = field * weight(np.hypot(x, y))
    down, right = (np.exp(-1j * np.pi * at[:, None] * across) for at in (y, x))
    return np.asarray(np.abs(down.T @ (field[:, None] * right)) ** 2)


def noll(waves: dict[int, float]) -> Callable[[Array, Array], Array]:
    """Return the phase of Zernike terms in Noll's order, waves rms, written out here."""

    def phase(x: Array, y: Array) -> Array:
        rho, theta = np.hypot(x, y), np.arctan2(y, x)
        total = np.zeros_like(rho)
        for j, size in waves.items():
            n = next(k for k in range(30) if (k + 1) * (k + 2) // 2 >= j)
            rest = j - n * (n + 1) // 2 - 1
            m = 2 * ((rest + 1) // 2) if n % 2 == 0 else 2 * (rest // 2) + 1
            radial = sum(
                (-1) ** s
                * math.factorial(n - s)
                / (math.factorial(s) * math.factorial((n + m) // 2 - s) * math.factorial((n - m) // 2 - s))
                * rho ** (n - 2 * s)
                for s in range((n - m) // 2 + 1)
            )
            turn = math.sqrt(2.0) * (np.sin(m * theta) if j % 2 else np.cos(m * theta)) if m else 1.0
            total += size * math.sqrt(n + 1.0) * radial * turn
        return 2.0 * np.pi * total

    return phase


def airy_fwhm() -> float:
    """Return the full width at half maximum of Airy's disc, lambda*N."""
    from scipy.optimize import brentq
    from scipy.special import j1

    return float(2.0 * brentq(lambda v: (2.0 * j1(v) / v) ** 2 - 0.5, 1.0, 2.5) / np.pi)


def airy_energy(radius: float) -> float:
    """Return the share of the light of Airy's disc within a radius, lambda*N: Rayleigh (1881)."""
    from scipy.special import j0, j1

    v = np.pi * radius
    return float(1.0 - j0(v) ** 2 - j1(v) ** 2)


def places(side: int, pitch: float, *, between: bool = False) -> Array:
    """Return the places of pixels, lambda*N, the axis in the middle of pixel side // 2 or between two."""
    return (np.arange(side) - (0.5 * (side - 1) if between else side // 2)) * pitch


# lommel


def lommel(
    waves: dict[int, float], side: int, pitch: float, obscuration: float = 0.0, *, between: bool = False
) -> Any:
    """Return a call for the image of Zernike terms in Noll's order, waves rms."""
    wavefront = lm.Wavefront.zernike({j: 2.0 * np.pi * w for j, w in waves.items()}, order="noll") if waves else None
    pupil = lm.Pupil(wavefront or lm.Wavefront(), obscuration=obscuration)
    middle = 0.5 * (side - 1) if between else side // 2

    def call() -> Ours:
        made = lm.psf(pupil, side, pitch, center=(middle, middle), threads=1)
        return made.values, float(np.max(made.error_bound))

    return call


# Packages


def galsim() -> Iterator[Case]:
    """GalSim: an FFT of the sampled pupil; Airy by its formula."""
    import galsim as g

    terms = {
        "defocus": {4: 0.25},
        "astig1": {5: 0.25},
        "astig2": {6: 0.25},
        "coma1": {7: 0.25},
        "coma2": {8: 0.25},
        "trefoil1": {9: 0.25},
        "trefoil2": {10: 0.25},
        "spher": {11: 0.25},
    }
    across = places(64, 0.25, between=True)

    def drawn(waves: dict[int, float], **options: float) -> Array:
        aberrations = np.zeros(12)
        for j, size in waves.items():
            aberrations[j] = size
        made = g.OpticalPSF(lam_over_diam=1.0, aberrations=aberrations, **options)
        return np.asarray(made.drawImage(nx=64, ny=64, scale=0.25, method="no_pixel").array, dtype=float)

    for name, waves in terms.items():
        yield Case(
            f"OpticalPSF({name}=0.25), 64², as it is by default",
            lambda waves=waves: drawn(waves),
            lommel(waves, 64, 0.25, between=True),
            image(noll(waves), across),
            "sampling and folding of the pupil: oversampling and pad_factor",
        )
    yield Case(
        "OpticalPSF(coma1=0.25), oversampling=4, pad_factor=4",
        lambda: drawn({7: 0.25}, oversampling=4.0, pad_factor=4.0),
        lommel({7: 0.25}, 64, 0.25, between=True),
        image(noll({7: 0.25}), across),
        "staircase of the rim",
    )
    for obscuration in (0.0, 0.3):
        made = g.Airy(lam_over_diam=1.0, obscuration=obscuration)
        yield Case(
            f"Airy(obscuration={obscuration:g}).xValue, 33²",
            lambda made=made: np.array([[made.xValue(x, y) for x in places(33, 0.2)] for y in places(33, 0.2)]),
            lommel({}, 33, 0.2, obscuration),
            image(None, places(33, 0.2), obscuration),
            "a formula",
        )


def poppy() -> Iterator[Case]:
    """poppy: a matrix Fourier transform of the sampled pupil."""
    import astropy.units as u
    import poppy as p

    scale = 206264.80624709636 * 1e-6 / 1.0  # arcseconds in lambda/D of 1 um and 1 m

    def psf(*elements: Any, side: int = 128, pitch: float = 0.25, npix: int = 1024) -> Array:
        system = p.OpticalSystem(npix=npix, oversample=1, pupil_diameter=1.0 * u.m)
        for element in elements:
            system.add_pupil(element)
        system.add_detector(pixelscale=pitch * scale, fov_pixels=side)
        return np.asarray(system.calc_psf(wavelength=1e-6)[0].data, dtype=float)

    disc = p.CircularAperture(radius=0.5)
    between = {"between": True}
    yield Case(
        "CircularAperture, 128², 1024 samples",
        lambda: psf(disc),
        lommel({}, 128, 0.25, **between),
        image(None, places(128, 0.25, **between)),
        "grey pixels of the rim",
    )
    yield Case(
        "SecondaryObscuration of 0.4, 128²",
        lambda: psf(disc, p.SecondaryObscuration(secondary_radius=0.2, n_supports=0)),
        lommel({}, 128, 0.25, 0.4, **between),
        image(None, places(128, 0.25, **between), 0.4),
        "staircase of two rims",
    )
    waves = {4: 0.05, 5: 0.04, 7: 0.03, 9: -0.03, 11: 0.05}
    coefficients = [0.0] * 11
    for j, size in waves.items():
        coefficients[j - 1] = size * 1e-6
    yield Case(
        "ZernikeWFE of five terms, 128²",
        lambda: psf(disc, p.ZernikeWFE(radius=0.5, coefficients=coefficients)),
        lommel(waves, 128, 0.25, **between),
        image(noll(waves), places(128, 0.25, **between)),
        "staircase of the rim",
    )
    for number in (1, 2):
        yield Case(
            f"ThinLens({number} waves), 128²",
            lambda number=number: psf(disc, p.ThinLens(nwaves=number, reference_wavelength=1e-6, radius=0.5)),
            lommel({4: number / (2.0 * math.sqrt(3.0))}, 128, 0.25, **between),
            image(noll({4: number / (2.0 * math.sqrt(3.0))}), places(128, 0.25, **between)),
            "staircase of the rim",
        )

    def file(pitch: float, side: int) -> Any:
        system = p.OpticalSystem(npix=1024, oversample=1, pupil_diameter=1.0 * u.m)
        system.add_pupil(disc)
        system.add_detector(pixelscale=pitch * scale, fov_pixels=side)
        return system.calc_psf(wavelength=1e-6)

    pupil = lm.Pupil()
    for pitch in (0.05, 0.25):
        yield Case(
            f"measure_fwhm of an Airy disc, pixels of {pitch:g} lambda/D",
            lambda pitch=pitch: np.array([p.measure_fwhm(file(pitch, 256)) / scale]),
            lambda: (np.array([lm.psf(pupil, 33, 0.1, threads=1).fwhm()]), math.nan),
            np.array([airy_fwhm()]),
            "the width of a Gaussian that is fitted to the core",
            measure=True,
        )
    radii = np.array([0.6, 1.2, 2.4])
    yield Case(
        "measure_ee at 0.6, 1.2, 2.4 lambda/D, 256² of 0.1",
        lambda: p.measure_ee(file(0.1, 256), normalize="None")(radii * scale),
        lambda: (lm.psf(pupil, 33, 0.1, threads=1).encircled_energy(radii), math.nan),
        np.array([airy_energy(r) for r in radii]),
        "rings of pixels, and the window",
        measure=True,
    )


def hcipy() -> Iterator[Case]:
    """HCIPy: its Fraunhofer propagator."""
    import hcipy as h

    def psf(samples: int, times: int, waves: dict[int, float], obscuration: float = 0.0) -> Array:
        grid, focal = h.make_pupil_grid(samples, 1.0), h.make_focal_grid(q=4, num_airy=16)
        shape = (
            h.make_obstructed_circular_aperture(1.0, obscuration) if obscuration else h.make_circular_aperture(1.0)
        )
        aperture = shape(grid) if times == 1 else h.evaluate_supersampled(shape, grid, times)
        phase = sum((2.0 * np.pi * w * h.zernike_noll(j, 1.0, grid) for j, w in waves.items()), 0.0 * aperture)
        wave = h.Wavefront(aperture * np.exp(1j * phase))
        return np.asarray(h.FraunhoferPropagator(grid, focal)(wave).intensity.shaped, dtype=float)

    across = places(128, 0.25)
    five = {4: 0.05, 5: 0.04, 7: 0.03, 9: -0.03, 11: 0.05}
    for samples, times in ((512, 1), (512, 8)):
        yield Case(
            f"circular aperture, {samples} samples"
            + (f", supersampled {times} times" if times > 1 else "")
            + ", 128²",
            lambda samples=samples, times=times: psf(samples, times, {}),
            lommel({}, 128, 0.25),
            image(None, across),
            "the rim",
        )
    for times in (1, 8):
        yield Case(
            "obstructed by 0.3, five zernike_noll, 256 samples"
            + (f", supersampled {times} times" if times > 1 else ""),
            lambda times=times: psf(256, times, five, 0.3),
            lommel(five, 128, 0.25, 0.3),
            image(noll(five), across, 0.3),
            "zernike_noll is zero beyond the rim by default (radial_cutoff), also where a grey pixel has light",
        )


def prysm() -> Iterator[Case]:
    """prysm: FFT and matrix Fourier transform of the sampled pupil."""
    from prysm.coordinates import cart_to_polar, make_xy_grid
    from prysm.geometry import circle
    from prysm.polynomials import noll_to_nm, zernike_nm
    from prysm.propagation import Wavefront
    from prysm.psf import fwhm

    five = {4: 0.05, 5: 0.04, 7: 0.03, 11: 0.05}

    def wave(samples: int, waves: dict[int, float]) -> Any:
        x, y = make_xy_grid(samples, diameter=2.0)
        rho, theta = cart_to_polar(x, y)
        opd = sum((1e3 * w * zernike_nm(*noll_to_nm(j), rho, theta, norm=True) for j, w in waves.items()), 0.0 * rho)
        return Wavefront.from_amp_and_phase(circle(1.0, rho), opd, 1.0, 2.0 / samples)

    def by_matrix(samples: int, waves: dict[int, float]) -> Array:
        return np.asarray(wave(samples, waves).focus_fixed_sampling(2.0, 0.25, 128).intensity.data, dtype=float)

    def by_fft(samples: int) -> Array:
        whole = wave(samples, {}).focus(2.0, Q=4).intensity.data
        first = (whole.shape[0] - 128) // 2
        return np.asarray(whole[first : first + 128, first : first + 128], dtype=float)

    across = places(128, 0.25)
    yield Case(
        "focus, Q=4, circle of 256 samples, 128²",
        lambda: by_fft(256),
        lommel({}, 128, 0.25),
        image(None, across),
        "staircase of the rim",
    )
    for samples in (256, 1024):
        yield Case(
            f"focus_fixed_sampling, four Zernike terms, {samples} samples, 128²",
            lambda samples=samples: by_matrix(samples, five),
            lommel(five, 128, 0.25),
            image(noll(five), across),
            "staircase of the rim",
        )
    pupil = lm.Pupil()

    def width() -> Array:
        data = wave(512, {}).focus_fixed_sampling(2.0, 0.05, 128)
        return np.array([fwhm(data.intensity.data, 0.05)])

    yield Case(
        "psf.fwhm of an Airy disc, 128² of 0.05 lambda*N",
        width,
        lambda: (np.array([lm.psf(pupil, 33, 0.1, threads=1).fwhm()]), math.nan),
        np.array([airy_fwhm()]),
        "radii of whole samples, and the sign of what is between them",
        measure=True,
    )


def dlux() -> Iterator[Case]:
    """dLux: a matrix Fourier transform in JAX."""
    import dLux
    import dLux.utils as du

    waves = {4: 0.05, 5: 0.04, 7: 0.03, 11: 0.05}

    def psf(samples: int) -> Array:
        coords = du.pixel_coords(samples, 1.0)
        disc = du.circle(coords, 0.5)
        basis = np.stack([np.asarray(du.zernike(j, coords, 1.0)) for j in waves])
        opd = np.tensordot(1e-6 * np.array([*waves.values()]), basis, 1)
        made = dLux.Wavefront(npixels=samples, diameter=1.0, wavelength=1e-6)
        made = (made * disc).normalise().add_opd(opd).propagate(128, 0.25e-6)
        return np.asarray(made.psf, dtype=float)

    for samples in (256, 1024):
        yield Case(
            f"four Zernike terms, {samples} samples, float32, 128²",
            lambda samples=samples: psf(samples),
            lommel(waves, 128, 0.25, between=True),
            image(noll(waves), places(128, 0.25, between=True)),
            "staircase of the rim",
        )


def aotools() -> Iterator[Case]:
    """aotools: FFT of Zernike terms on a grid."""
    import aotools as a

    def psf(samples: int) -> Array:
        disc = a.circle(samples / 2, samples)
        phase = 2.0 * np.pi * 0.07 * a.zernike_noll(11, samples)
        wide = np.zeros((4 * samples, 4 * samples), dtype=complex)
        wide[:samples, :samples] = disc * np.exp(1j * phase)
        whole = np.abs(np.fft.fftshift(np.fft.fft2(wide))) ** 2
        first = 2 * samples - 64
        return whole[first : first + 128, first : first + 128]

    for samples in (128, 512):
        yield Case(
            f"zernike_noll(11), 0.07 waves, circle, FFT padded 4 times, {samples} samples, 128²",
            lambda samples=samples: psf(samples),
            lommel({11: 0.07}, 128, 0.25),
            image(noll({11: 0.07}), places(128, 0.25)),
            "staircase of the rim",
        )


def photutils() -> Iterator[Case]:
    """photutils: Airy's disc by its formula, and interpolation of an effective PSF."""
    from photutils.psf import AiryDiskPSF, ImagePSF

    from lommel.compat import photutils as compat

    y, x = np.mgrid[:33, :33]
    # Its radius is that of the first zero, 1.2196698912665045 lambda*N.
    zero, pitch = 1.2196698912665045, 0.25
    yield Case(
        "AiryDiskPSF, 33²",
        lambda: AiryDiskPSF(flux=1, x_0=16, y_0=16, radius=zero / pitch)(x, y),
        lommel({}, 33, pitch),
        image(None, places(33, pitch)),
        "a formula",
    )
    pupil = lm.Pupil(obscuration=0.3)
    sub = 0.25 * np.polynomial.legendre.leggauss(12)[0] * 2.0  # of a pixel of 1 lambda*N, halves below
    weight = 0.5 * np.polynomial.legendre.leggauss(12)[1]
    centre = np.arange(33) - 16.37
    fine = (centre[:, None] + sub).ravel()
    averages = image(None, fine, 0.3).reshape(33, 12, 33, 12)
    truth = np.einsum("aibj,i,j->ab", averages, weight, weight)
    model = ImagePSF(compat.effective_psf(pupil, 33, 1.0, oversampling=4), oversampling=4)

    def ours() -> Ours:
        made = lm.psf(pupil, 33, 1.0, center=(16.37, 16.37), integrate=True, threads=1)
        return made.values, float(made.error_bound)

    yield Case(
        "ImagePSF of an exact effective PSF, oversampling 4, pixels of 1 lambda*N, between samples",
        lambda: model.evaluate(x, y, 1.0, 16.37, 16.37),
        ours,
        truth,
        "splines between samples",
    )


def solvephase() -> Iterator[Case]:
    """solvephase: the forward model of its phase retrieval."""
    import solvephase as s

    waves = {4: 0.05, 5: 0.04, 7: 0.03, 11: 0.05}
    for samples, times, precision in ((512, 4, "single"), (1024, 8, "double")):
        pupil = s.Pupil.circular(samples, supersample=times)
        forward = s.FocalPlaneModel(pupil, 1e-6, 128, sampling=4.0, offset=-0.5, precision=precision)
        y, x = (2.0 * part for part in pupil.coordinates())
        phase = noll(waves)(np.asarray(x), np.asarray(y)).astype(np.float32 if precision == "single" else np.float64)
        yield Case(
            f"FocalPlaneModel, four Zernike terms, {samples} samples, edge supersampled {times} times, {precision} "
            "precision, 128²",
            lambda forward=forward, phase=phase: np.asarray(forward.forward(phase).images[0], dtype=float),
            lommel(waves, 128, 0.25),
            image(noll(waves), places(128, 0.25)),
            "grey pixels of the rim",
        )


def optiland() -> Iterator[Case]:
    """optiland: Huygens' sum over rays of a Cooke triplet; the truth is the mean over 51 000 rays of the pupil."""
    from optiland.psf import HuygensPSF
    from optiland.samples.objectives import CookeTriplet
    from optiland.wavefront import Wavefront

    from lommel.adapters import optiland as adapter

    lens = CookeTriplet()
    rays = Wavefront(lens, [(0, 0)], [0.55], num_rays=256, distribution="uniform").get_data((0, 0), 0.55)
    truth = np.array([abs(np.mean(np.exp(2j * np.pi * np.asarray(rays.opd)))) ** 2])
    for side, why in (
        (32, "an even image has no pixel on the axis: take an odd one"),
        (33, "64 rays across the pupil"),
    ):
        yield Case(
            f"HuygensPSF(CookeTriplet, on axis, 64 rays, image_size={side}).strehl_ratio()",
            lambda side=side: np.array([HuygensPSF(lens, (0, 0), 0.55, num_rays=64, image_size=side).strehl_ratio()]),
            lambda: (np.array([lm.strehl(adapter.pupil(lens, (0, 0), wavelength=550e-9))]), math.nan),
            truth,
            why,
            measure=True,
        )


def microscopes() -> Iterator[tuple[str, Case]]:
    """Microscope packages, with the truth of a plain quadrature of Debye's or Gibson and Lanni's integral."""
    from scipy.special import j0

    node, w = np.polynomial.legendre.leggauss(900)
    s = 0.5 * (node + 1.0)

    def profile(radii: Array, stage: Array, depth: float, wave: float, of: dict[str, float], apodized: bool) -> Array:
        most = min(1.0, of["ns"] / of["NA"])
        rho = most * (1.0 - s * s)
        weight = most * s * w * rho
        k, p = 2.0 * np.pi / wave, of["NA"] * rho
        if apodized:
            weight = weight / np.sqrt(np.sqrt(1.0 - (p / of["ni"]) ** 2))
        root = {name: np.sqrt(of[name] ** 2 - p * p) for name in ("ns", "ni")}
        phase = k * (depth * root["ns"] - stage[:, None] * root["ni"])
        kernel = j0(k * of["NA"] * np.outer(radii, rho)) * weight
        return np.asarray(np.abs(np.exp(1j * phase) @ kernel.T) ** 2)

    def about(side: int, pitch: float, *, between: bool = False) -> Array:
        along = (np.arange(side) - (0.5 * (side - 1) if between else side // 2)) * pitch
        return np.hypot(along, along[:, None]).ravel()

    def has(name: str) -> bool:
        from importlib.util import find_spec

        return find_spec(name) is not None

    oil = {"NA": 1.2, "ns": 1.33, "ni": 1.515}
    z = np.linspace(-1.0, 1.0, 5)
    objective = lm.Objective(
        NA=1.2, immersion=1.515, working_distance=150e-6, coverslip=lm.Layer(1.515, 170e-6), sample=1.33
    )

    def gibson(side: int, pitch: float, origin: str, offset: Array, *, between: bool = False) -> Callable[[], Ours]:
        def call() -> Ours:
            light = lm.Scalar(supercritical=False)
            pupil = objective.pupil(depth=2e-6, z=1e-6 * offset, wavelength=610e-9, origin=origin, emitter=light)
            middle = 0.5 * (side - 1) if between else side // 2
            made = lm.psf(pupil, side, 1e-6 * pitch, integrate=False, center=(middle, middle), threads=1)
            return made.values, float(np.max(made.error_bound))

        return call

    if has("psfmodels"):
        import psfmodels as peer

        stage = 2.0 * 1.515 / 1.33 + z  # of paraxial focus, moved by z
        truth = profile(about(21, 0.05), stage, 2.0, 0.61, oil, apodized=False).reshape(5, 21, 21)
        params = {"NA": 1.2, "ns": 1.33, "ni": 1.515, "ni0": 1.515, "ng": 1.515, "ng0": 1.515}
        for times in (1, 3):
            yield (
                "psfmodels",
                Case(
                    "scalar_psf, NA 1.2, oil, 2 um deep in water, 5 x 21², "
                    + ("sf=1" if times == 1 else "sf=3 on pixels of a third, their centres"),
                    lambda times=times: (
                        peer.scalar_psf(z + 2.0, 21, 0.05, 2.0, 0.61, {**params, "sf": 1})
                        if times == 1
                        else peer.scalar_psf(z + 2.0, 63, 0.05 / 3.0, 2.0, 0.61, {**params, "sf": 1})[:, 1::3, 1::3]
                    ),
                    gibson(21, 0.05, "paraxial", z),
                    truth,
                    "linear interpolation of the radial profile",
                ),
            )
    if has("microscPSF"):
        from microscPSF import microscPSF

        stage = 2.0 * 1.515 / 1.33 + z
        of = microscPSF.m_params | {"NA": 1.2, "ns": 1.33, "M": 1e4}
        truth = profile(about(21, 0.05), stage, 2.0, 0.61, oil, apodized=False).reshape(5, 21, 21)
        yield (
            "MicroscPSF-Py",
            Case(
                "gLXYZFocalScan, NA 1.2, oil, 2 um deep in water, 5 x 21²",
                lambda: microscPSF.gLXYZFocalScan(of, 0.05, 21, -stage, pz=2.0, wvl=0.61),
                gibson(21, 0.05, "paraxial", z),
                truth,
                "linear interpolation of the radial profile",
            ),
        )
        radii = np.linspace(0.0, 1.5, 31)
        exact = profile(radii, stage, 2.0, 0.61, oil, apodized=False)

        def ours() -> Ours:
            light = lm.Scalar(supercritical=False)
            pupil = objective.pupil(depth=2e-6, z=1e-6 * stage, wavelength=610e-9, origin="coverslip", emitter=light)
            made = lm.psf(pupil, (1, 61), objective.magnification * 0.05e-6, tol=1e-10, integrate=False, dtype=float)
            return made.values[:, 0, 30:], float(np.max(made.error_bound))

        yield (
            "MicroscPSF-Py",
            Case(
                "gLZRFocalScan, NA 1.2, profiles alone",
                lambda: microscPSF.gLZRFocalScan(of, radii, -stage, pz=2.0, wvl=0.61),
                ours,
                exact,
                "a series of 100 Bessel functions, fitted",
            ),
        )
    if has("pyotf"):
        from pyotf.otf import HanserPSF

        one = {"NA": 0.85, "ns": 1.33, "ni": 1.33}
        planes = np.array([-0.4, 0.0, 0.2])
        truth = profile(about(33, 0.06), planes, 0.0, 0.52, one, apodized=True).reshape(3, 33, 33)
        water = lm.Objective(NA=0.85, immersion=1.33)

        def hanser(size: int) -> Array:
            whole = HanserPSF(0.52, 0.85, 1.33, 0.06, size, zrange=planes).PSFi
            first = size // 2 - 16
            return np.asarray(whole[:, first : first + 33, first : first + 33])

        def debye() -> Ours:
            light = lm.Scalar("aplanatic")
            pupil = water.pupil(depth=0.0, z=1e-6 * planes, wavelength=520e-9, origin="paraxial", emitter=light)
            made = lm.psf(pupil, 33, 0.06e-6, integrate=False, threads=1)
            return made.values, float(np.max(made.error_bound))

        for size in (64, 128, 256, 512):
            yield (
                "pyotf",
                Case(
                    f"HanserPSF, NA 0.85 in water, size {size}, the middle 33²",
                    lambda size=size: hanser(size),
                    debye,
                    truth,
                    "staircase of the pupil, periodic images",
                ),
            )
    if has("psf_generator"):
        from psf_generator import ScalarCartesianPropagator, ScalarSphericalPropagator

        one = {"NA": 1.3, "ns": 1.515, "ni": 1.515}
        side, pitch = 41, 0.05
        truth = profile(about(side, pitch), np.array([0.0]), 0.0, 0.61, one, apodized=False).reshape(1, side, side)
        lens = lm.Objective(NA=1.3, immersion=1.515)

        def scalar() -> Ours:
            pupil = lens.pupil(depth=0.0, z=0.0, wavelength=610e-9, origin="paraxial", emitter="scalar")
            made = lm.psf(pupil, side, 1e-6 * pitch, integrate=False, threads=1)
            return made.values[None], float(np.max(made.error_bound))

        grid = {"n_pix_psf": side, "pix_size": 1e3 * pitch * (side - 1) / side, "wavelength": 610, "n_defocus": 1}
        grid |= {"na": 1.3, "n_i": 1.515, "n_i0": 1.515}
        # Both with uniform light in the pupil.
        radial = partial(ScalarSphericalPropagator, cos_factor=True, **grid)
        cartesian = partial(ScalarCartesianPropagator, sz_correction=False, **grid)
        for name, kind, pixels in (
            ("ScalarSphericalPropagator, 129 angles", radial, 129),
            ("ScalarCartesianPropagator, 129 samples", cartesian, 129),
            ("ScalarCartesianPropagator, 513 samples", cartesian, 513),
        ):
            yield (
                "psf-generator",
                Case(
                    f"{name}, NA 1.3, one medium, 41² in focus",
                    lambda kind=kind, pixels=pixels: (
                        np.abs(
                            kind(n_pix_pupil=pixels)
                            .compute_focus_field()
                            .detach()
                            .cpu()
                            .numpy()
                            .reshape(1, side, side)
                        )
                        ** 2
                    ),
                    scalar,
                    truth,
                    "single precision; the Cartesian pupil has a staircase",
                ),
            )


PACKAGES: dict[str, Callable[[], Iterator[Case]]] = {
    "GalSim": galsim,
    "poppy": poppy,
    "hcipy": hcipy,
    "prysm": prysm,
    "dLux": dlux,
    "aotools": aotools,
    "photutils": photutils,
    "solvephase": solvephase,
    "optiland": optiland,
}


def error_of(found: Array, case: Case) -> float:
    """Return the largest error over the peak, the unit of an image being the one that fits best."""
    found, truth = np.asarray(found, dtype=float), case.truth
    if case.measure:
        return float(np.abs(found / truth - 1.0).max())
    # Rows and columns, and their directions, are as the package has them.
    turned = [found] if found.ndim != 2 or found.shape[0] != found.shape[1] else _turned(found)
    errors = []
    for one in turned:
        scale = (one * truth).sum() / (one * one).sum()
        errors.append(np.abs(scale * one - truth).max() / truth.max())
    return float(min(errors))


def _turned(found: Array) -> list[Array]:
    return [np.rot90(part, k) for k in range(4) for part in (found, found.T)]


def seconds(call: Callable[[], object]) -> float:
    """Return the least processor time of some calls."""
    call()
    taken = []
    stop = time.process_time() + 0.5
    while not taken or (len(taken) < 20 and time.process_time() < stop):
        start, count = time.process_time(), 0
        while count == 0 or time.process_time() - start < 2e-3:
            call()
            count += 1
        taken.append((time.process_time() - start) / count)
    return min(taken)


def rows() -> Iterator[tuple[str, str, Case]]:
    """Yield package, version and case of all packages that are installed."""
    for name, cases in PACKAGES.items():
        try:
            number = version(name)
        except PackageNotFoundError:
            continue
        for case in cases():
            yield name, number, case
    for name, case in microscopes():
        yield name, version(name), case


def main() -> None:
    """Print the table, or write the page."""
    parser = argparse.ArgumentParser(prog="benchmarks/accuracy.py", description=__doc__)
    parser.add_argument("--write", action="store_true", help=f"write docs/{PAGE.name}")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    lines = []
    for name, number, case in rows():
        theirs = error_of(case.theirs(), case)
        values, bound = case.ours()
        ours = error_of(values, case)
        ratio = seconds(case.theirs) / seconds(case.ours)
        said = "–" if math.isnan(bound) else f"{bound:.1e}"
        longer = f"{ratio:.0f}" if ratio >= 10.0 else f"{ratio:.2g}"
        figures = f"{theirs:.1e} | {ours:.1e} | {said} | {longer}"
        lines.append(f"| {name} {number.partition('+')[0]} | {case.asked} | {figures} | {case.cause} |")
        print(lines[-1], flush=True)
    if options.write:
        PAGE.write_text(TEXT + "\n".join(lines) + "\n", encoding="utf-8")


TEXT = """# Accuracy of PSF packages

<!-- index: ! GalSim, ! HCIPy, ! dLux, ! aotools, ! solvephase -->

How wrong is a PSF? Each package is asked what its own tests and examples ask, at its default settings and, where
there is one, at a setting of an expert. The error is the largest difference from direct quadrature over the aperture,
relative to the peak. The quadrature uses no FFT and no code of lommel. The unit of an image is the one that fits
best, and its rows and columns may be mirrored. Pixels of GalSim and poppy are of 0.25 lambda/D where a row names
none. Errors of measured numbers (widths, energies, Strehl ratios) are relative to them. The last but one column is
processor time of the package over that of lommel for the same values, on one core, to a factor of about 1.5.

An error is not a fault: most packages state the sampling as an option, and 1e-3 of the peak is below the noise of
many images. The last column has the cause. The benchmark also holds the truth:

```sh
make peers GROUP=accuracy  # installs the packages, one of which brings PyTorch
PYTHONPATH=.tools/peers .venv/bin/python -m benchmarks.accuracy --write
```

| package | question | its error | lommel's error | lommel's bound | time | cause |
|---|---|---:|---:|---:|---:|---|
"""


if __name__ == "__main__":
    main()
