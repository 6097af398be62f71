"""Worlds that estimators meet, and what must come of each."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from typing import Any

import numpy as np
from scipy import ndimage

import lommel as lm
import searches
from tests.world import air, camera, scene, stage
from tests.world.camera import Camera
from tests.world.optics import Objective, Telescope, Transfer, Waves, as_waves, cells, disc, noll, zernike
from tests.world.verdicts import Scenario, Trial


def timed(function: Callable[..., Any], *arguments: Any, **options: Any) -> tuple[Any, float]:
    """Return what a function returns and the seconds of a processor."""
    begun = time.process_time()
    result = function(*arguments, **options)
    return result, time.process_time() - begun


def errors(result: Any) -> Mapping[Any, Any]:
    """Return the standard errors of the coefficients of a result."""
    return getattr(result, "errors", None) or result.errors


def excess(**numbers: Any) -> lm.Noise:
    """Return the noise of an electron-multiplying camera."""
    return lm.Noise(**numbers, excess=2.0)


# Fields of stars: f/8, 1.6 m, 12 stars of 25 x 25 pixels.
F8, FOCAL, PIXEL = Telescope(600e-9, 8.0, 0.3), 1.6, 4.5e-6
COMA = as_waves({4: 0.05 * 2 * np.pi, 6: 0.06 * 2 * np.pi, 8: 0.08 * 2 * np.pi})
STARS = Camera(gain=0.0, read=3.0)
Blur = tuple[tuple[Any, ...], ...]


def through(transfer: Transfer, blur: Blur, focal: float = FOCAL, pixel: float = PIXEL) -> Transfer:
    """Return a transfer function through air and tracking: arcseconds, and pixels of what is of the camera."""
    second = air.ARCSECOND * focal
    for kind, size, *more in blur:
        if kind == "tracking":
            down, across = transfer.frequency[:, None], transfer.frequency[None]
            factor = air.tracking(down, across, size * pixel, *more)
        else:
            made = {"kolmogorov": air.kolmogorov, "karman": air.von_karman, "moffat": air.moffat}
            made["gaussian"] = air.gaussian
            factor = made[kind](transfer.radius, size * (pixel if kind == "gaussian" else second), *more)
        transfer = transfer.times(factor)
    return transfer


@cache
def seen(blur: Blur, waves: Waves, telescope: Telescope) -> Transfer:
    """Return the transfer function of a telescope and the air above it."""
    if blur and blur[0][0] == "zone":
        return through(telescope.transfer(waves, screen=zones(telescope, blur[0][1], range(1, 12))), blur[1:])
    if blur and blur[0][0] == "screens":
        small = Telescope(telescope.wavelength, telescope.f_number, telescope.obscuration, side=64)
        ratio = FOCAL / 8.0 / (air.WIDTH * 600e-9 / (blur[0][1] * air.ARCSECOND))
        # Four hundred, turned and negated: the mean of fewer is a wavefront, and their tilts have a direction.
        phases = air.screens(64, ratio, 400, np.random.default_rng(16))
        phases = np.concatenate([sign * np.rot90(phases, turn, (1, 2)) for sign in (1, -1) for turn in (0, 1)])
        each = [small.transfer(waves, screen=screen) for screen in phases]
        return Transfer(np.mean([one.values for one in each], axis=0), each[0].frequency)
    return through(telescope.transfer(waves), blur)


@cache
def zones(telescope: Telescope, size: float, terms: Iterable[int], rings: float = 0.0) -> np.ndarray:
    """Return phases of a zone, or of so many rings to the edge, radians rms, without what terms of a fit take up."""
    share, rho, theta = telescope.aperture
    made = np.cos(2 * np.pi * rings * rho + 1.0) if rings else np.exp(-(((rho - 0.7) / 0.08) ** 2))
    every = np.stack([zernike(j, rho, theta) for j in terms], axis=-1)
    weight, flat = np.sqrt(share), every.reshape(-1, every.shape[-1])
    made -= every @ np.linalg.lstsq(weight.ravel()[:, None] * flat, (weight * made).ravel())[0]
    return np.asarray(made * size / np.sqrt((share * made**2).sum() / share.sum()))


@cache
def stars(blur: Blur, flux: float, waves: Waves, telescope: Telescope, slope: float) -> np.ndarray:
    """Return the mean electrons of 12 stars, on 50 electrons of sky that may slope along columns."""
    transfer, draw = seen(blur, waves, telescope), np.random.default_rng(8)
    sky = 50.0 + slope * (np.arange(25) - 12.0)
    return np.array([flux * transfer.image(25, PIXEL, *(12 + draw.uniform(-0.5, 0.5, 2))) + sky for _ in range(12)])


def field(
    seed: int, blur: Blur, flux: float, *, waves: Waves = COMA, terms: int = 5, slope: float = 0.0,
    messy: bool = False, trail: float = 0.0, stripes: float = 0.0, **telescope: float,
) -> Trial:  # fmt: skip
    """Fit a field of 12 stars, the same wavefront all over it, of a telescope that may be another than is stated."""
    mean = stars(blur, flux, waves, Telescope(600e-9, 8.0, 0.3, **telescope), slope)
    mean, recorder = camera.trailed(mean, trail), STARS.but(stripes=stripes)
    if messy:
        mean = mean.copy()
        for k, (row, column) in enumerate(((2, 3), (-3, 2))):  # doubles
            mean[k] += 0.4 * np.roll(mean[k] - 50.0, (row, column), (0, 1))
        recorder = recorder.but(rays=0.5)
    windows = recorder.record(mean, seed)
    if messy:
        windows[5, :, 9] = np.nan
    places = [(60 + 110 * (k // 4), 60 + 110 * (k % 4)) for k in range(12)]
    fit, seconds = timed(
        searches.fit_field, windows, places,
        lm.Pupil(obscuration=0.3, wavelength=600e-9, f_number=8.0), sensor=(400, 500), pixel=PIXEL,
        noise=lm.Noise(read=3.0), degree=0, terms=terms, blur=True, tol=1e-4, threads=1,
    )  # fmt: skip
    truth = {noll(j): size for j, size in waves}
    true = np.array([truth.get(name, 0.0) for name in fit.names])
    return Trial(fit, _nearest(*fit.at(0.0, 0.0), true, fit), seconds)


def _nearest(found: np.ndarray, error: np.ndarray, true: np.ndarray, fit: Any) -> np.ndarray:
    """Return errors over standard errors; of the field or its twin, where there is one. Further terms are 0."""
    true = np.pad(true, [(0, 0)] * (true.ndim - 1) + [(0, found.shape[-1] - true.shape[-1])])
    even = [name[1] % 2 == 0 for name in fit.names]
    signs = [np.where(even, sign, 1) for sign in ((1, -1) if fit.twin is not None else (1,))]
    return min(((sign * found - true) / error for sign in signs), key=lambda z: float((z**2).sum()))


def astrograph(seed: int, fwhm: float) -> Trial:
    """Fit 30 stars of an f/4 astrograph, whose wavefront is of degree 2 over the field."""
    places, mean, waves = _astrograph(fwhm, seed % 3)
    windows = Camera(0.8, 500.0, 2.0).record(mean, seed)
    fit, seconds = timed(
        searches.fit_field, windows, places, lm.Pupil(obscuration=0.35, wavelength=550e-9, f_number=4.0),
        sensor=(600, 600), pixel=3.76e-6, noise=lm.Noise(white=0.8, read=2.0, offset=500.0), degree=2, terms=8,
        blur=True, tol=1e-4, threads=1,
    )  # fmt: skip
    u = np.array([-0.7, 0.0, 0.7])
    v, u = (one.ravel() for one in np.meshgrid(u, u, indexing="ij"))
    found, error = fit.at(u * 300 * 3.76e-6, v * 300 * 3.76e-6)
    return Trial(fit, _nearest(found, error, waves(u, v), fit).ravel(), seconds)


def bent(seed: int, kind: str, size: float) -> Trial:
    """Fit 30 stars, of degree 1 over the field, where one term has a cubic part or a bump in a corner (radians)."""
    places, mean, waves = _bent(kind, size)
    fit, seconds = timed(
        searches.fit_field, STARS.record(mean, seed), places,
        lm.Pupil(obscuration=0.3, wavelength=600e-9, f_number=8.0), sensor=(600, 600), pixel=PIXEL,
        noise=lm.Noise(read=3.0), degree=1, terms=5, blur=True, tol=1e-4, threads=1,
    )  # fmt: skip
    u = np.array([-0.7, 0.0, 0.7])
    v, u = (one.ravel() for one in np.meshgrid(u, u, indexing="ij"))
    found, error = fit.at(u * 300 * PIXEL, v * 300 * PIXEL)
    return Trial(fit, _nearest(found, error, waves(u, v), fit).ravel(), seconds)


@cache
def _bent(kind: str, size: float) -> tuple[np.ndarray, np.ndarray, Callable[..., np.ndarray]]:
    draw = np.random.default_rng(50)

    def waves(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        bump = np.exp(-((u - 0.8) ** 2 + (v - 0.8) ** 2) / 0.3**2)
        added = {"cubic": u**3 - 0.6 * u, "bump": bump, "": 0 * u}[kind]
        return np.stack([0.3 + 0.1 * u, 0.1 * v, 0.4 + 0 * u, 0.3 * v, 0.3 * u + size * added], axis=-1)

    cells = np.stack(np.divmod(draw.permutation(36)[:30], 6), axis=1)
    places = np.rint(cells * 100 + 50 + draw.uniform(-30, 30, (30, 2))).astype(int)
    mean = []
    for row, column in places:
        one = waves(np.array((column - 299.5) / 300), np.array((row - 299.5) / 300))
        transfer = through(F8.transfer(tuple(zip(range(4, 9), one.tolist(), strict=True))), _k(1.0))
        flux = np.exp(draw.uniform(np.log(1e4), np.log(1e5)))
        mean.append(flux * transfer.image(25, PIXEL, *(12 + draw.uniform(-0.5, 0.5, 2))) + 50.0)
    return places, np.array(mean), waves


@cache
def _astrograph(fwhm: float, which: int) -> tuple[np.ndarray, np.ndarray, Callable[..., np.ndarray]]:
    draw, telescope = np.random.default_rng(40 + which), Telescope(550e-9, 4.0, 0.35)

    def waves(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        zero = 0 * u
        terms = (
            0.25 + 0.3 * (u * u + v * v) + 0.15 * u, 0.5 * u * v + 0.05, 0.25 * (u * u - v * v) - 0.1,
            0.35 * v + 0.025, 0.35 * u - 0.05, zero + 0.04, zero - 0.03, zero + 0.075,
        )  # fmt: skip
        return np.stack(terms, axis=-1)

    cells = np.stack(np.divmod(draw.permutation(36)[:30], 6), axis=1)
    places = np.rint(cells * 100 + 50 + draw.uniform(-30, 30, (30, 2))).astype(int)
    mean = []
    for row, column in places:
        one = waves(np.array((column - 299.5) / 300), np.array((row - 299.5) / 300))
        transfer = telescope.transfer(tuple(zip(range(4, 12), one.tolist(), strict=True)))
        transfer = through(transfer, (("kolmogorov", fwhm),), 1.0, 3.76e-6)
        flux = np.exp(draw.uniform(np.log(1e4), np.log(1e5)))
        mean.append(flux * transfer.image(25, 3.76e-6, *(12 + draw.uniform(-0.5, 0.5, 2))) + 100.0)
    return places, np.array(mean), waves


# One star, pixels of half a lambda N.
def star(
    seed: int, defocus: tuple[float, ...], *, fwhm: float = 0.0, missing: Waves = (), slope: float = 0.0,
    sigma: float = 0.0, longer: float = 1.0, trail: float = 0.0, ringed: float = 0.0, recorder: Camera = STARS,
    gain: float = 0.0, **another: float,
) -> Trial:  # fmt: skip
    """Retrieve six terms from images of a star at known defoci, each seed with another wavefront.

    With seeing that is estimated; and, not stated: further terms, a sky that slopes, blur, defoci that are longer,
    charge that arrives late, another telescope or gain. A pupil of f/8 is stated where the f-number differs.
    """
    draw, names = np.random.default_rng(seed), (4, 5, 6, 7, 8, 11)
    waves = tuple(zip(names, (draw.normal(size=6) * 0.25).tolist(), strict=True))
    telescope, mean = Telescope(**another), []
    screen = zones(telescope, ringed, (1, 2, 3, *names), 2.5) if ringed else 0.0
    for known in defocus:
        transfer = telescope.transfer((*waves, *missing), defocus=2 * known * longer, screen=screen)
        if fwhm:
            transfer = transfer.times(air.kolmogorov(transfer.radius, fwhm))
        transfer = transfer.times(air.gaussian(transfer.radius, sigma))
        sky = 10.0 + slope * np.arange(33.0)
        mean.append(3e4 * transfer.image(33, 0.5, *(16 + draw.uniform(-0.4, 0.4, 2))) + sky)
    noise = lm.Noise(read=3.0)
    if gain:  # electrons per count, half of one in truth
        recorder, noise = recorder.but(gain=0.5, offset=100.0), lm.Noise(white=gain, read=3.0, offset=100.0)
    images = recorder.record(camera.trailed(np.array(mean), trail), seed)
    pupil, unit = (lm.Pupil(wavelength=600e-9, f_number=8.0), 4.8e-6) if "f_number" in another else (lm.Pupil(), 1.0)
    found, seconds = timed(
        searches.retrieve, images, pupil, pixel=0.5 * unit, noise=noise, defocus=list(defocus),
        terms=[f"noll {j}" for j in names], integrate=True, tol=1e-4, threads=1, blur=bool(fwhm),
    )  # fmt: skip
    error = errors(found)
    z = [(found.coefficients[f"noll {j}"] - size) / error[f"noll {j}"] for j, size in waves]
    return Trial(found, np.array(z), seconds)


# Beads under oil on the glass: 15 planes of 25 x 25 pixels.
OIL, SAMPLE_PIXEL = Objective(), 6.5e-6 / 63
PLANES = stage.positions(15, 0.14e-6)
BENT = as_waves({5: -0.15, 6: 0.5, 7: -0.1, 8: 0.2, 11: -0.4, 13: 0.12, 16: 0.1, 18: -0.05})
SLIGHT = as_waves({6: 0.1, 8: 0.1, 11: 0.1})
SCMOS = Camera()
OBJECTIVE = lm.Objective(
    NA=1.4, magnification=63, immersion=1.518, sample=1.33, working_distance=0.19e-3,
    coverslip=lm.Layer(1.5255, 170e-6),
)  # fmt: skip


@cache
def bead_light(waves: Waves, diameter: float, objective: Objective, drift: float, beside: float) -> np.ndarray:
    """Return planes of a bead of unit light, and of another one `beside` it, 30 % as bright."""
    moved, made = stage.drift(15, row=drift, column=-drift / 2), []
    depth = diameter / 2
    first = objective.brightest(depth)
    for position, (down, across) in zip(PLANES, moved, strict=True):
        transfer = scene.ball(objective, diameter, depth, first + position, waves)
        image = transfer.image(25, SAMPLE_PIXEL, 12.23 + down, 11.71 + across)
        if beside:
            image = image + 0.3 * transfer.image(25, SAMPLE_PIXEL, 12.2 + 0.6 * beside, 11.7 + 0.8 * beside)
        made.append(image)
    return np.array(made)


def bead(
    seed: int, waves: Waves, *, terms: int = 17, diameter: float = 100e-9, stated: float = 100e-9,
    thicker: float = 0.0, drift: float = 0.0, beside: float = 0.0, turned: bool = False, axial: float = 1.0,
    recorder: Camera = SCMOS, noise: lm.Noise | None = None,
) -> Trial:  # fmt: skip
    """Fit a bead of 1e4 photons a plane on a background of 10."""
    mean = 1e4 * bead_light(waves, diameter, Objective(thicker=thicker, axial=axial), drift, beside) + 10.0
    stack = recorder.record(stage.backwards(mean) if turned else mean, seed)
    fit, seconds = timed(
        searches.fit_beads, stack, lm.Microscope(OBJECTIVE, 600e-9, 6.5e-6), z=PLANES, terms=terms, diameter=stated,
        noise=noise or lm.Noise(white=0.46, read=1.6, offset=100.0), threads=1,
    )  # fmt: skip
    truth: dict[Any, float] = {noll(j): size for j, size in waves}
    constants = {"sample": 1.33, "immersion": 1.518, "NA": 1.4, "pixel": 6.5e-6, "diameter": diameter}
    constants |= {"coverslip": 170e-6 + thicker}
    z, held, error = [], [], errors(fit)
    for name, value in fit.coefficients.items():
        if isinstance(name, tuple):
            z.append((value - truth.get(name, 0.0)) / error[name])
        elif name in constants and error[name] > 0:
            held.append((value - constants[name]) / error[name])
    return Trial(fit, np.array(z), seconds, np.array(held))


# Movies of 25 frames with 4 molecules each, 0.6 to 1.4 um deep in water.
ASTIGMATIC = ((6, 0.15 * 2 * np.pi),)


@cache
def table(sign: float, shift: float) -> lm.localize.Table:
    """Return images of a molecule by lommel, with a sign of astigmatism, focused `shift` deeper than in truth."""
    wave = lm.Wavefront.zernike({6: 0.15 * sign}, order="noll", unit="waves")
    pupil = OBJECTIVE.pupil(depth=1e-6 + shift, wavelength=600e-9, aberrations=wave)
    return lm.localize.Table(pupil, shape=15, pixel=6.5e-6, z=(0.4e-6 + shift, 1.6e-6 + shift), along="depth")


@cache
def movie_light(
    photons: float, dense: bool, waves: Waves, stage: float, spread: float = 0.0
) -> tuple[np.ndarray, np.ndarray]:
    """Return 25 frames of 64 x 64 without background, and frame, row, column, depth, photons of each molecule."""
    draw, focus = np.random.default_rng(33), OIL.brightest(1e-6) + stage
    bright = photons * np.exp(spread * np.random.default_rng(34).normal(size=(25, 4)))  # log-normal
    frames, rows = np.zeros((25, 64, 64)), []
    for frame in range(25):
        for k in range(4):
            place = draw.uniform(9, 54, 2) if dense else 16 + 32 * np.array(divmod(k, 2)) + draw.uniform(-3, 3, 2)
            depth = draw.uniform(0.6e-6, 1.4e-6)
            rows.append((frame, *place, depth, bright[frame, k]))
            first = np.rint(place).astype(int) - 9
            transfer = OIL.transfer(depth, focus, waves)
            image = transfer.image(19, SAMPLE_PIXEL, *(place - first))
            frames[frame, first[0] : first[0] + 19, first[1] : first[1] + 19] += bright[frame, k] * image
    return frames, np.array(rows)


def movie(
    seed: int, *, photons: float = 1500.0, dense: bool = False, slope: float = 0.0, sign: float = 1.0,
    shift: float = 0.0, stage: float = 0.0, waves: Waves = ASTIGMATIC, recorder: Camera = SCMOS,
    noise: lm.Noise | None = None, spread: float = 0.0,
) -> Trial:  # fmt: skip
    """Localise the molecules of a movie on 15 electrons, or a background that slopes along columns."""
    light, truth = movie_light(photons, dense, waves, stage, spread)
    frames = recorder.record(light + 15.0 + slope * (np.arange(64) - 31.5), seed)
    known = noise or lm.Noise(white=0.46, read=1.6, offset=100.0)
    images = table(sign, shift)
    found, seconds = timed(lm.localize.localize_movie, frames, images, noise=known)
    good = found.kept
    for name in ("reliable", "doubtful"):  # flags of single molecules
        flags = getattr(found, name, None)
        if isinstance(flags, np.ndarray):
            good = good & (flags if name == "reliable" else ~flags)
    rows = found.table[good]
    pulls, misses = [], []
    for one in rows:
        here = truth[truth[:, 0] == one["frame"]]
        apart = np.hypot((here[:, 2] + 0.5) * SAMPLE_PIXEL - one["x"], (here[:, 1] + 0.5) * SAMPLE_PIXEL - one["y"])
        if apart.size and apart.min() < 250e-9:
            _, row, column, depth, light_ = here[apart.argmin()]
            true = (column + 0.5) * SAMPLE_PIXEL, (row + 0.5) * SAMPLE_PIXEL, depth, light_
            names = "x", "y", "z", "photons"
            widths = [_width(one, name) for name in names]
            off = np.array([one[name] - value for name, value in zip(names, true, strict=True)])
            pulls.append(off / widths)
            misses.append((1e9 * off[0], 1e9 * widths[0]))
    z = np.array(pulls).reshape(-1, 4)
    if not misses:
        return Trial(found, z, seconds)
    bias = np.array(misses)
    extras = {"bias of x, nm": (bias[:, 0].mean(), float(np.hypot.reduce(bias[:, 1])) / len(bias))}
    return Trial(found, z, seconds, extras=extras | {"molecules": (float(len(z)), 0.0)})


def _width(row: Any, name: str) -> float:
    """Return the standard error in a row of a table."""
    names = row.dtype.names or ()
    return float(row[next(each for each in (f"{name}_error", f"{name}_error") if each in names)])


# Stacks of 20 x 40 x 40, 10 um deep in water under oil.
DEEP, STEP = 10e-6, 0.25e-6
GREEN = Objective(wavelength=520e-9)


@cache
def scanned_light(modality: lm.microscopy.Modality, which: int) -> tuple[np.ndarray, float]:
    """Return photons of a stack of beads, confocal or in a light sheet, and all that 39 planes collect."""
    points = scene.beads(6, 40, (DEEP - 1.5e-6, DEEP + 1.5e-6), np.random.default_rng(380 + which))
    scale, samples, pinhole = 1.0, 3, modality.pinhole * 0.61 * GREEN.wavelength / GREEN.NA
    planes = GREEN.brightest(DEEP) + stage.positions(39, STEP)
    if modality.kind == "light sheet":
        profile = scene.sheet(GREEN, modality.thickness)
        each = scene.lit(GREEN, modality.thickness, DEEP, planes).sum()
    else:
        profile = scene.confocal(GREEN, Objective(wavelength=modality.excitation), pinhole)
        scale, samples = 0.05 / SAMPLE_PIXEL**2, 1
        r = np.arange(0, 15e-6, 15e-9)
        each = (2 * np.pi * r * profile(r, DEEP, planes)).sum() * 15e-9
    light = scene.volume(GREEN, points, planes[9:29], 40, SAMPLE_PIXEL, profile=profile, samples=samples)
    return scale * light, scale * each * sum(point[3] for point in points)


def scanned(seed: int, stated: lm.microscopy.Modality) -> Trial:
    """Restore a stack of a confocal or light-sheet microscope."""
    light, total = scanned_light(stated, seed % 3)
    counts = SCMOS.record(light + 10.0, seed)
    objective = lm.Objective(
        NA=1.4, magnification=63, immersion=1.518, sample=1.33, working_distance=0.19e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
    )  # fmt: skip
    device = lm.Microscope(
        objective, 520e-9, 6.5e-6, depth=DEEP, planes=20, step=STEP, modality=stated, integrate=True
    )
    found, seconds = timed(
        lm.microscopy.deconvolve, counts, device, noise=lm.Noise(white=0.46, read=1.6, offset=100.0), direction="up"
    )
    ratio = float(np.sum(found.values, dtype=float)) * 0.46 / total
    near = abs(ratio - 1.0) < (0.05 if stated.kind == "light sheet" else 0.25)
    return Trial(found, np.zeros(0), seconds, extras={"light": (ratio, 0.0)}, wrong=not near)


@cache
def stack_light(kind: str, which: int) -> tuple[np.ndarray, float]:
    """Return photons of a stack, and those a plane of all that shines."""
    foci = GREEN.brightest(DEEP) + stage.positions(20, STEP)
    draw, depths = np.random.default_rng(380 + which), (DEEP - 1.5e-6, DEEP + 1.5e-6)
    points = scene.beads(6, 40, depths, draw) if kind == "beads" else scene.filaments(3, 40, depths, draw)
    return scene.volume(GREEN, points, foci, 40, SAMPLE_PIXEL), sum(point[3] for point in points)


def stack(
    seed: int, kind: str, *, index: float = 0.0, hot: float = 0.0, full: float = np.inf, wrong: bool = False
) -> Trial:
    """Restore a stack, with an index of the sample that is off by `index`."""
    light, total = stack_light(kind, seed % 3)
    warm = camera.hot((40, 40), hot, 41 + seed) if hot else None
    recorder = SCMOS.but(warm=warm)
    if np.isfinite(full):  # the scale is such that the brightest voxels are full
        light, total = light * full, total * full
    counts = recorder.record(light + 30.0, seed)
    objective = lm.Objective(
        NA=1.4, magnification=63, immersion=1.518, sample=1.33 + index, working_distance=0.19e-3,
        coverslip=lm.Layer(1.5255, 170e-6),
    )  # fmt: skip
    found, seconds = timed(
        lm.microscopy.deconvolve, counts, objective, depth=DEEP, wavelength=520e-9, pixel=6.5e-6, step=STEP,
        noise=lm.Noise(white=0.46, read=1.6, offset=100.0), direction="up",
    )  # fmt: skip
    ratio = float(np.sum(found.values, dtype=float)) * 0.46 / total / 39  # planes that a point sends light to
    off = wrong or not 0.8 < ratio < 1.25
    return Trial(found, np.zeros(0), seconds, extras={"light": (ratio, 0.0)}, wrong=off)


# Depth from two photographs: 50 mm f/1.8, foci 2.3 and 3.6 m, pixels of 50 um; geometric discs.
FINE_PIXEL, FOCI, DEPTHS = 50.2e-6, (2.3, 3.6), (2.5, 2.9, 3.3)


def _geometric(depth: float, focus: float) -> Callable[..., np.ndarray]:
    size = 50e-3 / 1.8 * 50e-3 * focus / (focus - 50e-3) * abs(1 / depth - 1 / focus) / FINE_PIXEL
    return lambda down, across: disc(size / 2, np.hypot(down, across))


@cache
def _diffracted(depth: float, focus: float, pixel: float) -> Callable[..., np.ndarray]:
    """Return the transfer function of a 35 mm lens at f/4, by wave optics."""
    radius, distance = 35e-3 / 8, 35e-3 * focus / (focus - 35e-3)
    edge = np.pi / 550e-9 * radius**2 * (1 / depth - 1 / focus)
    made = Telescope(550e-9, distance / (2 * radius)).transfer(defocus=edge)
    half = len(made.frequency) // 2
    frequency, values = made.frequency[:half] * pixel, made.values[0, :half].real
    return lambda down, across: np.interp(np.hypot(down, across), frequency, values, right=0.0)


@cache
def photographs(kind: str, size: float, which: int) -> tuple[list[np.ndarray], np.ndarray]:
    """Return the light on pixels of two photographs, white being 1, and the true depths."""
    layered = kind == "layers"
    shape = (192, 288) if layered else (96, 120)
    count = 3 if layered else 1
    pictures = [scene.texture(shape, size, 430 + 10 * which + k) for k in range(count)]
    depths = DEPTHS if layered else (float(kind.split()[1]),)
    edges = [(k + 1) * shape[1] // count for k in range(count)]
    column = np.arange(shape[1] * scene.FINE) // scene.FINE
    covers = [np.broadcast_to(column < edge, pictures[0].shape) for edge in edges]
    depth = np.broadcast_to(np.array(depths)[np.searchsorted(edges, np.arange(shape[1]), side="right")], shape)
    taken = []
    for focus in (1.35, 1.8) if kind.startswith("f/4") else FOCI:
        seen_as = [_diffracted(z, focus, 4e-6) if kind.startswith("f/4") else _geometric(z, focus) for z in depths]
        taken.append(scene.photograph(list(zip(pictures, covers, seen_as, strict=True))))
    return taken, depth


def pair(
    seed: int, kind: str, size: float = 0.6, *, f_number: float = 1.8, focal: float = 50e-3,
    foci: tuple[float, float] = FOCI, pixel: float = FINE_PIXEL, white: float = 5000.0,
    change: Callable[[np.ndarray], np.ndarray] | None = None, both: bool = False, wrong: bool = False,
) -> Trial:  # fmt: skip
    """Estimate depth, with a lens that may be stated wrongly, and photographs that are changed."""
    taken, depth = photographs(kind, size, seed % 2)
    wave = kind.startswith("f/4")
    if wave:
        f_number, focal, foci, pixel, between = 4.0, 35e-3, (1.35, 1.8), 4e-6, (1.2, 2.0)
    else:
        between = (1.8, 6.0)
    recorder = Camera(gain=0.0, read=3.0)
    images = [recorder.record(5000.0 * one, 2 * seed + k) / 5000.0 for k, one in enumerate(taken)]
    if change is not None:
        images = [change(one) if k or both else one for k, one in enumerate(images)]
    lens = lm.Lens(focal_length=focal, f_number=f_number, focus_distance=foci[0], wavelength=550e-9)
    found, seconds = timed(
        lm.imaging.depth_from_defocus, images, [lens.focused(focus) for focus in foci], pixel, encoding="linear",
        noise=lm.Noise(white=white, read=3.0), between=between,
    )  # fmt: skip
    begun = time.process_time()
    said = found if hasattr(found, "findings") else found.verdict
    seconds += time.process_time() - begun
    edge = np.hypot(*np.gradient(depth)) > 0
    far = ndimage.distance_transform_edt(np.pad(~edge, 1)[1:-1, 1:-1]) if edge.any() else np.full(depth.shape, 99.0)
    known = np.isfinite(found.depth) & (far > 16)
    known[:20] = known[-20:] = known[:, :20] = known[:, -20:] = False
    some = np.zeros_like(known)
    some[::8, ::16] = True
    error = getattr(found, "errors", None)
    error = found.errors if error is None else error
    z = ((found.depth - depth) / error)[known & some]
    off = np.median(np.abs(found.depth / depth - 1)[known]) if known.any() else np.nan
    return Trial(said, z, seconds, extras={"error of depth": (float(off), 0.0)}, wrong=wrong)


def live(seed: int, depth: float, *, f_number: float = 1.8, wrong: bool = False) -> Trial:
    """Estimate depth at video rate from two frames of electrons, in blocks of 4 pixels."""
    taken, _ = photographs(f"at {depth}", 0.6, seed % 2)
    frames = [STARS.record(5000.0 * one, 2 * seed + k) for k, one in enumerate(taken)]
    lens = lm.Lens(focal_length=50e-3, f_number=f_number, focus_distance=FOCI[0], wavelength=550e-9)
    found, lenses = lm.Noise(read=3.0), [lens.focused(focus) for focus in FOCI]
    engine = lm.imaging.LiveDepth(
        lenses, FINE_PIXEL, between=(1.8, 6.0), noise=found, shape=frames[0].shape, light=2500.0
    )
    seen_as, seconds = timed(engine, *frames)
    some = np.isfinite(seen_as.errors)
    some[:5] = some[-5:] = some[:, :5] = some[:, -5:] = False
    some &= (np.indices(some.shape) % 4 == 0).all(axis=0)
    return Trial(engine.verdict(), ((seen_as.depth - depth) / seen_as.errors)[some], seconds, wrong=wrong)


def restored(seed: int, *, f_number: float = 1.8, depth: float = 2.9, white: float = 5000.0) -> Trial:
    """Deblur a photograph of a texture at 2.9 m, focused at 2.3 m; wrong if it is worse than the photograph."""
    picture = scene.texture((96, 120), 0.6, 430 + seed % 2)
    light = scene.photograph([(picture, np.ones_like(picture), _geometric(2.9, FOCI[0]))])
    photo = STARS.record(5000.0 * light, seed) / 5000.0
    truth = picture.reshape(96, scene.FINE, 120, scene.FINE).mean((1, 3))
    lens = lm.Lens(focal_length=50e-3, f_number=f_number, focus_distance=FOCI[0], wavelength=550e-9)
    found, seconds = timed(
        lm.imaging.restore, photo, np.full(photo.shape, depth), lens, FINE_PIXEL, encoding="linear",
        noise=lm.Noise(white=white, read=3.0), saturation=np.inf,
    )  # fmt: skip
    after, before = (float(np.std((one - truth)[16:-16, 16:-16])) for one in (found.values, photo))
    return Trial(found, np.zeros(0), seconds, extras={"error / before": (after / before, 0.0)}, wrong=after > before)


# Slanted edges, seen through a disc of 3 pixels, up to 1e4 electrons.
def edge(seed: int, *, exposed: float = 1.0, bits: int = 16) -> Trial:
    """Measure the response of a disc and pixels at four frequencies from a picture of an edge."""
    fine, turned = 96 * scene.FINE, np.radians(5.0 + seed % 5)
    x = np.arange(fine) - (fine - 1) / 2
    across = x * np.cos(turned) + x[:, None] * np.sin(turned)
    picture = 0.1 + 0.8 * np.clip(across + 0.5, 0, 1)
    light = scene.photograph([(picture, np.ones_like(picture), lambda v, u: disc(1.5, np.hypot(v, u)))])[
        16:-16, 16:-16
    ]
    full = 2.0**bits - 1
    counts = Camera(gain=1e4 / full, offset=0.0, read=3.0, bits=bits).record(1e4 * exposed * light, seed)
    found, seconds = timed(lm.sfr, counts if bits == 16 else counts.astype(np.uint8), PIXEL)
    f = np.array([0.1, 0.2, 0.3, 0.4])
    true = disc(1.5, f) * np.sinc(f * np.cos(turned)) * np.sinc(f * np.sin(turned))
    z = (found(f / PIXEL) - true) / np.interp(f / PIXEL, found.frequencies, found.errors)
    return Trial(found, z, seconds)


def opd(seed: int, *, step: float = 0.0, island: float = 0.0, outliers: int = 0, radians: float = 30.0) -> Trial:
    """Fit a map of 80 x 80 pixels, each seed another wavefront: noise of 0.1 rad, a step of a wave, outliers."""
    draw, x = np.random.default_rng(seed), cells(80)
    rho, theta = np.hypot(x[:, None], x), np.arctan2(x[:, None], x[None])
    sizes = dict(zip(range(2, 23), draw.normal(size=21).tolist(), strict=True))
    values = sum(size * zernike(j, rho, theta) for j, size in sizes.items()) + draw.normal(size=rho.shape) * 0.1
    values = values + 2 * np.pi * ((x > step) if step else (np.hypot(x[:, None] - 0.3, x) < island))
    values[tuple(draw.integers(20, 60, (2, outliers)))] += radians
    found, seconds = timed(lm.fit_opd, values, unit="radians", radius=40.0, center=(39.5, 39.5))
    inside = rho <= 1
    terms = np.stack([zernike(j, rho[inside], theta[inside]) for j in range(1, 46)], axis=1)
    fitted = np.linalg.lstsq(terms, (values - found.residual)[inside])[0][1:22]
    errors_ = 0.1 * np.sqrt(np.diag(np.linalg.inv(terms.T @ terms)))[1:22]
    return Trial(found, (fitted - list(sizes.values())) / errors_, seconds)


def _k(fwhm: float) -> Blur:
    return (("kolmogorov", fwhm),)


GAUSS = (("gaussian", 0.4),)
OTHER = ("other_explanation",)
MISFIT = ("misfit", "missed_light")
BLUR = ("blur", "blur_shape", *OTHER)
TERM = ("missing_terms", "term", *OTHER)
PSF = ("psf_doubtful", "misfit")


def _with(waves: Waves, **more: float) -> Waves:
    return as_waves(dict(waves) | {int(name[1:]): size for name, size in more.items()})


def _fields() -> list[Scenario]:
    made = []
    add = partial(_add, made, "fit_field")
    for k, fwhm in enumerate((0.5, 1.0, 1.5, 2.0, 3.0)):
        # So few electrons through so much air tell a wavefront to 0.2 to 0.5 radians: images are not linear within.
        dim = ("RT", ("too_dim",)) if fwhm >= 2.0 else ()
        add(f"{1 + k}", f'Kolmogorov {fwhm:g}", 5e3 e', partial(field, blur=_k(fwhm), flux=5e3), *dim)
    for k, fwhm in enumerate((0.5, 1.0, 1.5, 2.0, 3.0)):
        add(f"{6 + k}", f'Kolmogorov {fwhm:g}", 5e4 e', partial(field, blur=_k(fwhm), flux=5e4))
    add("11", "Gaussian 0.6 px", partial(field, blur=(("gaussian", 0.6),), flux=2e4))
    add("12", 'Kolmogorov 1.5" and Gaussian 0.4 px', partial(field, blur=(*_k(1.5), *GAUSS), flux=5e4))
    karman = (("karman", 1.5, 20.0 / (air.WIDTH * 600e-9 / (1.5 * air.ARCSECOND))),)
    add("13a", 'von Karman 20 m, 1.5", 5e3 e', partial(field, blur=karman, flux=5e3))
    add("13b", 'von Karman 20 m, 1.5", 5e4 e', partial(field, blur=karman, flux=5e4))
    add("14", 'Moffat 3, 1.5"', partial(field, blur=(("moffat", 1.5, 3.0),), flux=5e4), "RT", BLUR)
    track = ("tracking", 0.7, 0.0), ("tracking", 1.5, 0.0)
    add("15a", 'tracking 0.7 px, Kolmogorov 1"', partial(field, blur=(*_k(1.0), track[0]), flux=5e4), "RT", OTHER)
    ellipse = ("ellipse", "elongated", *BLUR)
    add("15b", 'tracking 1.5 px, Kolmogorov 1"', partial(field, blur=(*_k(1.0), track[1]), flux=5e4), "RT", ellipse)
    add("16", '1600 phase screens, 1"', partial(field, blur=(("screens", 1.0),), flux=2e4), "RT", OTHER)
    add(
        "17",
        'f/4, 30 stars, degree 2, Kolmogorov 2"',
        partial(astrograph, fwhm=2.0),
        "RT",
        ("another_minimum", "too_dim"),
    )
    for name, j in (("18a", 15), ("18b", 22)):
        waves = _with(COMA, **{f"_{j}": 0.1})
        run = partial(field, blur=GAUSS, flux=5e4, waves=waves, terms=11)
        add(name, f"Noll {j} of 0.1 rad missing", run, "RT", TERM)
    add("19", "doubles, cosmic rays, NaN column", partial(field, blur=GAUSS, flux=2e4, messy=True), seconds=10)
    run = partial(field, blur=GAUSS, flux=5e4, vanes=0.08)
    add("20", "spider not in the pupil", run, "T", ("misfit", *OTHER))
    add("21", "sky gradient of 1 e a pixel", partial(field, blur=GAUSS, flux=2e4, slope=1.0))
    zone = partial(field, blur=(("zone", 0.05), *_k(1.0)), flux=5e4)
    add("21a", 'zone of a mirror, 0.05 rad, Kolmogorov 1"', zone, "RT", OTHER)
    for row, name, more in (
        ("21b", "obscuration off by 3 %", {"off": 0.03}), ("21c", "aperture squeezed by 2 %", {"squeezed": 0.02}),
        ("21d", "light that falls by a tenth from edge to edge", {"slanted": 0.026}),
        ("21e", "2 % of the charge late", {"trail": 0.02}),
    ):  # fmt: skip
        for fwhm in (1.0, 3.0):
            run = partial(field, blur=_k(fwhm), flux=5e4, **more)
            add(f"{row}{fwhm:.0f}", f'{name}, Kolmogorov {fwhm:g}"', run, "RT", OTHER)
    run = partial(field, blur=_k(1.0), flux=5e4, stripes=2.0)
    add("21j", 'pick-up of 2 e, Kolmogorov 1"', run, "RT", ("pattern", *OTHER))
    for row, kind, size in (("21f", "", 0.0), ("21g", "cubic", 0.1), ("21h", "bump", 0.2), ("21i", "bump", 0.1)):
        add(
            row,
            f"degree 1 of 30 stars, {size:g} rad of {kind or 'nothing'}",
            partial(bent, kind=kind, size=size),
            "RT",
            OTHER,
        )
    return made


def _retrievals() -> list[Scenario]:
    made: list[Scenario] = []
    add = partial(_add, made, "retrieve")
    add("22", "one focus", partial(star, defocus=(0.0,)), "T", ("sign_open",))
    add("23", "two foci", partial(star, defocus=(0.0, 3.0)))
    add("24", "two foci, seeing of a third of lambda N", partial(star, defocus=(0.0, 3.0), fwhm=0.32))
    told = {"Noll 22 of 0.08 rad missing": {"missing": as_waves({22: 0.08})}}
    told["Noll 12 of 0.06 rad missing"] = {"missing": as_waves({12: 0.06})}
    told["sky that slopes by 0.6 e a pixel"] = {"slope": 0.6}
    told["blur of 0.15 lambda N not stated"] = {"sigma": 0.15}
    told["defoci longer by 5 %"] = {"longer": 1.05}
    told["aperture squeezed by 2 %"] = {"squeezed": 0.02}
    told["light that falls by a tenth from edge to edge"] = {"slanted": 0.026}
    told["2 % of the charge late"] = {"trail": 0.02}
    told["rings of a mirror, 0.05 rad"] = {"ringed": 0.05}
    told["f-number 2 % larger"] = {"f_number": 1.02}
    for row, (name, more) in zip("bcdefghilm", told.items(), strict=True):
        add(f"24{row}", f"two foci, {name}", partial(star, defocus=(0.0, 3.0), **more), "RT", (*MISFIT, *OTHER))
    for row, name, more in (
        ("24j", "pick-up of 1.5 e", {"stripes": 1.5}),
        ("24k", "rows 1.5 e apart", {"rows": 1.5}),
    ):
        run = partial(star, defocus=(0.0, 3.0), recorder=STARS.but(**more))
        add(row, f"two foci, {name}", run, "RT", ("pattern", *OTHER))
    for row, gain in (("24n", 0.75), ("24o", 0.25)):
        run = partial(star, defocus=(0.0, 3.0), gain=gain)
        add(row, f"two foci, gain {2 * gain:g} of the true one", run, "T", ("gain", "excess_noise"))
    return made


def _beads() -> list[Scenario]:
    made: list[Scenario] = []
    add = partial(_add, made, "fit_beads")
    register = SCMOS.but(gain=10 / 300, read=0.2, register=300.0)
    add("25", "17 terms, all in the model", partial(bead, waves=BENT))
    add("26a", "Noll 22 missing", partial(bead, waves=_with(BENT, _22=0.08)), "RT", TERM)
    add("26b", "Noll 22 among 18 terms", partial(bead, waves=_with(BENT, _22=0.08), terms=18))
    rivals = ("coverslip", "immersion", "suspect", *OTHER)
    add("27", "cover glass 180 um, 170 stated", partial(bead, waves=SLIGHT, thicker=10e-6), "RT", rivals)
    run = partial(bead, waves=SLIGHT, axial=0.8)
    add("27b", "dye that radiates a fifth less along the axis", run, "RT", rivals)
    stated = excess(white=10 / 300, read=0.2, offset=100.0)
    add("28a", "EMCCD, stated", partial(bead, waves=SLIGHT, recorder=register, noise=stated))
    plain = lm.Noise(white=10 / 300, read=0.2, offset=100.0)
    run = partial(bead, waves=SLIGHT, recorder=register, noise=plain)
    add("28b", "EMCCD, not stated", run, "T", ("excess_noise",))
    double = lm.Noise(white=0.92, read=1.6, offset=100.0)
    add("28c", "gain twice the true one", partial(bead, waves=SLIGHT, noise=double), "T", ("gain", "excess_noise"))
    add("29a", "200 nm bead, stated 100", partial(bead, waves=SLIGHT, diameter=200e-9), "RT", ("diameter", *rivals))
    run = partial(bead, waves=BENT, turned=True)
    add("29b", "planes reversed", run, "T", ("reversed_z", "reversed_planes"))
    run = partial(bead, waves=SLIGHT, drift=0.04)
    add("30", "drift of 0.04 px a plane", run, "RT", ("drift", "moved", *OTHER))
    run = partial(bead, waves=SLIGHT, recorder=SCMOS.but(stripes=1.5))
    add("30b", "pick-up of 1.5 e", run, "RT", ("pattern", *OTHER))
    run = partial(bead, waves=SLIGHT, beside=12.0)
    add("31", "neighbour of 30 % at 12 px", run, "T", ("neighbour", *MISFIT, *OTHER))
    return made


def _movies() -> list[Scenario]:
    made: list[Scenario] = []
    add = partial(_add, made, "localize")
    bias = {"bias of x, nm": (-1.0, 1.0)}
    maps = camera.scientific((64, 64), 32)
    known = lm.Noise(white=maps.gain, read=np.hypot(maps.read, maps.gain / 12**0.5), offset=maps.offset)
    add("32", "flat 15 e, sCMOS maps", partial(movie, recorder=maps, noise=known), limits=bias)
    add("33", "5 to 25 e over 64 px", partial(movie, slope=20 / 64), limits=bias)
    register = SCMOS.but(gain=10 / 300, read=0.2, register=300.0)
    run = partial(movie, recorder=register, noise=excess(white=10 / 300, read=0.2, offset=100.0))
    add("34", "EMCCD, stated", run, limits=bias)
    add("35", "clipped emitters", partial(movie, photons=6e4, recorder=SCMOS.but(bits=12)), "RT", ("flat_top",))
    add("36", "0.09 molecules per square micrometre", partial(movie, dense=True), "RT")
    add("36b", "log-normal photons, 100 to 10 000", partial(movie, spread=0.9))
    add("36c", "the same, 0.09 per square micrometre", partial(movie, dense=True, spread=0.9), "RT")
    wrong = ("astigmatism_reversed", "opposite_astigmatism", "misfit", "psf_doubtful", *OTHER)
    add("37a", "astigmatism of the other sign", partial(movie, sign=-1.0), "T", wrong)
    add("37b", "depth off by 1 um", partial(movie, shift=1e-6), "T", wrong)
    for row, name, j, size in (("37d", "coma", 8, 0.3), ("37e", "coma", 8, 0.1), ("37f", "spherical", 11, 0.3)):
        run = partial(movie, waves=_with(ASTIGMATIC, **{f"_{j}": size}))
        add(row, f"{name} of {size:g} rad not in the table", run, "RT", OTHER)
    add("37g", "stage 50 nm from where it was stated", partial(movie, stage=50e-9), "N", ("untested",))
    add("37c", "the same, 60 e over 64 px", partial(movie, shift=1e-6, slope=0.94), "T", wrong)
    return made


def _stacks() -> list[Scenario]:
    made: list[Scenario] = []
    add = partial(_add, made, "deconvolve")
    light = {"light": (0.97, 1.03)}
    add("38a", "right index, beads", partial(stack, kind="beads"), limits=light)
    add("38b", "right index, filaments", partial(stack, kind="filaments"), limits=light)
    for row, off, share in (("39a", -0.015, 0.95), ("39b", 0.015, 0.95), ("40a", -0.01, 0.8), ("40b", 0.01, 0.8)):
        run = partial(stack, kind="beads", index=off, wrong=True)
        add(row, f"index off by {off:+g}", run, "T", PSF, share=share)
    add("41a", "0.11 % hot pixels", partial(stack, kind="beads", hot=0.0011), limits=light)
    add("41b", "1 % hot pixels", partial(stack, kind="beads", hot=0.01), limits=light)
    spot, sheet = (lm.microscopy.Modality(kind, 488e-9, thickness=2e-6) for kind in ("confocal", "light sheet"))
    add("53", "confocal, 1 Airy unit", partial(scanned, stated=spot), "RT", ("uneven_background", *PSF))
    add("54", "light sheet of 2 um", partial(scanned, stated=sheet), "RT", PSF)
    add("42", "full voxels of 16 bits", partial(stack, kind="beads", full=30.0), limits=light)
    return made


def _pairs() -> list[Scenario]:
    made: list[Scenario] = []
    add = partial(_add, made, "depth")
    for row, depth in (("43a", 2.4), ("43b", 2.5), ("43c", 3.3)):
        add(row, f"continuous texture at {depth} m, one photograph nearly sharp", partial(pair, kind=f"at {depth}"))
    add("43d", "three layers", partial(pair, kind="layers"))
    add("44", "foci exchanged", partial(pair, kind="layers", foci=(3.6, 2.3)), "N", ("untested",))
    lens = (
        ("45a", "f/2.8 for 1.8", {"f_number": 2.8}),
        ("45b", "f/2 for 1.8", {"f_number": 2.0}),
        ("45c", "45 mm for 50", {"focal": 45e-3}),
        ("45d", "pixel 40 um for 50", {"pixel": 40e-6}),
        ("45e", "3.6 m stated as 3", {"foci": (2.3, 3.0)}),
    )
    for row, name, stated in lens:
        add(row, name, partial(pair, kind="layers", wrong=True, **stated), "T", ("lens_scale",))
    shifted = partial(ndimage.shift, shift=(0, 1), order=1, mode="nearest")
    add("46a", "second photograph 1 px off", partial(pair, kind="layers", change=shifted), "T", ("misfit",))
    add("46b", "breathing of 0.7 %", partial(pair, kind="layers", change=_breathing), "T", ("misfit",))
    smooth, quiet = partial(ndimage.gaussian_filter, sigma=0.7), ("too_quiet", "denoised")
    add("47a", "denoised", partial(pair, kind="layers", change=smooth, both=True), "T", quiet)
    add("47b", "white four times too large", partial(pair, kind="layers", white=2e4), "T", ("misfit",))
    add("48", "f/4, scene finer than pixels, 1.4 m", partial(pair, kind="f/4 1.4", size=0.2))
    return made


def _others() -> list[Scenario]:
    made: list[Scenario] = []
    add = partial(_add, made, "fit_opd")
    add("49a", "map with noise of 0.1 rad", opd)
    add("49b", "a third of the map one wave higher", partial(opd, step=0.33), "T", OTHER)
    add("49c", "an island of the map one wave higher", partial(opd, island=0.3), "T", OTHER)
    add("49d", "nine pixels of 30 rad", partial(opd, outliers=9), "T", ("outliers",))
    add("49e", "four pixels of 1 rad", partial(opd, outliers=4, radians=1.0), "RT", ("outliers",))
    add = partial(_add, made, "sfr")
    add("50a", "edge, well exposed", edge)
    add("50b", "edge, bright side full, 8 bits", partial(edge, exposed=1.6, bits=8), "T", ("refused",))
    add = partial(_add, made, "restore")
    add("51a", "texture at 2.9 m", restored)
    add("51b", "f/2.8 for 1.8", partial(restored, f_number=2.8), "RT", ("misfit", "not_settled"))
    add("51c", "f/1.4 for 1.8", partial(restored, f_number=1.4), "T", ("blur_doubtful",))
    add("51d", "depth 2.6 m for 2.9", partial(restored, depth=2.6), "RT", ("misfit", "not_settled"))
    add("51e", "white four times too large", partial(restored, white=2e4), "T", ("misfit",))
    add = partial(_add, made, "LiveDepth")
    add("52a", "texture at 2.5 m", partial(live, depth=2.5))
    add("52b", "texture at 3.3 m", partial(live, depth=3.3))
    add("52c", "f/2.8 for 1.8", partial(live, depth=2.9, f_number=2.8, wrong=True), "T", ("lens_scale", "misfit"))
    return made


def _breathing(image: np.ndarray) -> np.ndarray:
    middle = (np.array(image.shape) - 1) / 2
    return ndimage.affine_transform(image, np.eye(2) / 1.007, middle - middle / 1.007, order=3, mode="nearest")


def _add(
    made: list[Scenario], estimator: str, row: str, name: str, run: Callable[..., Trial], must: str = "R",
    codes: tuple[str, ...] = (), **more: Any,
) -> None:  # fmt: skip
    made.append(Scenario(row, name, estimator, run, must, codes, **more))


SCENARIOS = (*_fields(), *_retrievals(), *_beads(), *_movies(), *_stacks(), *_pairs(), *_others())
