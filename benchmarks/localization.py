"""Molecules in three dimensions: images from a table, and fits, beside the cubic splines of Picasso and the bound.

Images of molecules are made by lm.psf, not by the table. Picasso fits the same counts with a spline of the exact PSF
at the pixel pitch, by its own numba code on one thread; what of its `lib` opens windows or plays sounds is left out.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cache, partial
from importlib.util import find_spec
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

import lommel as lm
from benchmarks.report import Table
from benchmarks.timing import Contender, Measured, Race, Settings, race

Array = NDArray[np.float64]

TOL, SIDE, PIXEL = 1e-4, 15, 6.5e-6
RANGE, MOST = 0.7e-6, 0.6e-6  # of the table, and of molecules
PHOTONS, BACKGROUND = 1000.0, 5.0
_MARGIN, _STEP = 3, 50e-9  # of splines: pixels, and along z
_OBJECTIVE = lm.Objective(NA=1.4, magnification=63, immersion=1.518, sample=1.33)
_LIGHT: dict[str, Any] = {
    "wavelength": 600e-9,
    "aberrations": lm.Wavefront.zernike({6: 0.15}, order="noll", unit="waves"),
}


class Molecules(NamedTuple):
    """Places of molecules, and exact images of them."""

    row: Array
    column: Array
    z: Array
    images: Array


@cache
def table() -> lm.localize.Table:
    """Return the table of an oil immersion objective, 1 um deep in water, with 0.15 waves of astigmatism."""
    return lm.localize.Table(_OBJECTIVE.pupil(depth=1e-6, **_LIGHT), SIDE, PIXEL, z=(-RANGE, RANGE), tol=TOL)


@cache
def molecules(count: int) -> Molecules:
    """Return molecules within a pixel of the middle, 600 nm around focus."""
    random = np.random.default_rng(1)
    row, column = SIDE // 2 + random.uniform(-1.0, 1.0, (2, count))
    z = random.uniform(-MOST, MOST, count)
    parts = []
    for k in range(0, count, 50):
        part = slice(k, k + 50)
        pupil = _OBJECTIVE.pupil(depth=1e-6, z=z[part], **_LIGHT)
        made = lm.psf(pupil, SIDE, PIXEL, center=(row[part], column[part]), tol=1e-6, dtype=np.float64)
        parts.append(made.values)
    return Molecules(row, column, z, np.concatenate(parts))


def localization(settings: Settings) -> Table:
    """Images, fits and their errors."""
    found = Table(
        "localization",
        "Localisation of molecules",
        "NA 1.4, oil, 1 um deep in water, 600 nm, 0.15 waves of astigmatism, pixels of 6.5 um at 63x, 15², one "
        "thread. Images with slopes by row, column and z come from `localize.Table` (tol 1e-4), 1000 at once, beside "
        "`np.abs` of as many floats and beside `psf` with the same derivatives. Fits of 1000 photons on 5 a pixel "
        "include their starts; Picasso 0.11 fits the same images by cubic splines of the exact PSF, Poisson "
        "likelihood, from one start and from five.",
        {
            "what": "text",
            "over np.abs": "spread",
            "psf over it": "spread",
            "Picasso, 1 start, over it": "spread",
            "5 starts over it": "spread",
            "true error": "error",
        },
    )
    settings.tick("images")
    result = _images(settings.rounds)
    error = true_error()
    found.add("an image with three slopes", result.ratio(_TABLE, _ABS), result.ratio(_PSF, _TABLE), None, None, error)
    settings.tick("psf")
    result = _objectives(settings.rounds)
    for name in (_FOUR, _FEW, _MANY):
        times, here = result.ratio(name, _IMAGE).median, 1e6 * result.median(name)
        found.notes.append(f"`psf` of one molecule, tol 1e-4: {name} takes {times:.2g} images, {here:.0f} us here.")
    settings.tick("fits")
    result = _fits(settings.rounds)
    ratios = [result.ratio(name, _FIT) if name in result.seconds else None for name in (_ONE, _FIVE)]
    found.add("a fit", None, None, *ratios, None)
    found.notes.append(f"A fit takes {1e6 * result.median(_FIT) / _FITTED:.1f} us here.")
    for photons, background in ((500, 5), (1000, 5), (2000, 10), (5000, 10)):
        settings.tick(f"{photons} photons")
        at = precision(photons, background, 1000 if settings.quick else 4000)
        spread = f"{at.scatter.min():.2f} to {at.scatter.max():.2f} of the Cramér-Rao bound in row, column and z"
        bias = f"mean error {at.bias.max():.3f} of it at most, {100.0 * at.lost:.2g} % beyond six times the bound"
        found.notes.append(f"{photons} photons on {background} a pixel: rms error {spread}, {bias}.")
    settings.tick("strong aberrations")
    for photons, background in ((1000, 5), (5000, 10)):
        share = max(lost(seed, photons, background, 1000 if settings.quick else 4000) for seed in (1, 2, 3))
        told = f"{100.0 * share:.2g} % are beyond six times the bound, in the worst of three pupils"
        found.notes.append(f"Seven Zernike terms, 0.3 waves together, z within 850 nm, {photons} photons: {told}.")
    found.notes.append(f"Without noise z is off by {1e9 * systematic():.1g} nm rms at 5000 photons.")
    return found


class Precision(NamedTuple):
    """Errors over the Cramér-Rao bound in row, column and z, and the share of molecules beyond six times that."""

    scatter: Array
    bias: Array
    lost: float


def precision(photons: float, background: float, count: int) -> Precision:
    """Return how exactly so many molecules are found."""
    at = molecules(count)
    mean = photons * at.images + background
    fit = lm.localize.fit(table(), np.random.default_rng(2).poisson(mean))
    values, slopes = table()(at.row, at.column, at.z, derivatives=True)
    parts = [
        photons * slopes["row"],
        photons * slopes["column"],
        photons * 1e-6 * slopes["z"],
        values,
        np.ones(mean.shape),
    ]
    root = np.stack(parts, axis=1).reshape(count, 5, -1).astype(float)
    covariance = np.linalg.inv(np.einsum("nap,nbp->nab", root / mean.reshape(count, 1, -1), root))
    bound = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))[:, :3] * [1.0, 1.0, 1e-6]
    off = np.stack([fit.row - at.row, fit.column - at.column, fit.z - at.z], axis=1) / bound
    lost = (np.abs(off) > 6.0).any(axis=1)
    kept = off[~lost]
    return Precision(np.sqrt((kept**2).mean(axis=0)), np.abs(kept.mean(axis=0)), float(lost.mean()))


def _bound(made: lm.localize.Table, at: tuple[Array, Array, Array], photons: float, background: float) -> Array:
    """Return the Cramér-Rao bound on row, column and z of molecules, (n, 3)."""
    values, slopes = made(*at, derivatives=True)
    ones = np.ones(values.shape)
    parts = [photons * slopes["row"], photons * slopes["column"], photons * 1e-6 * slopes["z"], values, ones]
    root = np.stack(parts, axis=1).reshape(len(values), 5, -1).astype(float)
    mean = (photons * values + background).reshape(len(values), 1, -1)
    covariance = np.linalg.inv(np.einsum("nap,nbp->nab", root / mean, root))
    return np.asarray(np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))[:, :3] * [1.0, 1.0, 1e-6])


def systematic() -> float:
    """Return the rms error of z without noise, metres."""
    at = molecules(1000)
    return float(np.sqrt(((lm.localize.fit(table(), 5000.0 * at.images + 10.0).z - at.z) ** 2).mean()))


def true_error() -> float:
    """Return the largest error of 60 images over the peak of the dimmest plane."""
    random = np.random.default_rng(3)
    worst, made = 0.0, table()
    dimmest = float(made(SIDE // 2, SIDE // 2, np.linspace(-RANGE, RANGE, 57)).max(axis=(1, 2)).min())
    for _ in range(60):
        row, column, z = made.limits[0] + random.random(3) * (made.limits[1] - made.limits[0])
        pupil = _OBJECTIVE.pupil(depth=1e-6, z=z, **_LIGHT)
        exact = lm.psf(pupil, SIDE, PIXEL, center=(row, column), tol=1e-8, method=lm.methods.DebyeRings(1e-8)).values
        worst = max(worst, float(np.abs(made(row, column, z) - exact).max()) / dimmest)
    return worst


_TABLE, _ABS, _PSF, _FIT, _ONE, _FIVE = "table", "np.abs", "psf", "fit", "one start", "five starts"
_IMAGES, _FITTED = 1000, 1000


def _images(rounds: int) -> Race:
    random, made = np.random.default_rng(4), table()
    places = made.limits[0] + random.random((_IMAGES, 3)) * (made.limits[1] - made.limits[0])
    array = random.standard_normal((_IMAGES, 4, SIDE, SIDE)).astype(np.float32)
    out = np.empty_like(array)
    at = molecules(50)
    pupil = _OBJECTIVE.pupil(depth=1e-6, z=at.z[:20], **_LIGHT)
    names: Any = ("row", "column", "z")
    center = (at.row[:20], at.column[:20])

    def direct(_: Any) -> Any:
        return lm.psf(pupil, SIDE, PIXEL, center=center, tol=TOL, derivatives=names, threads=1).values

    # So many times the work that each does.
    result = race(
        [
            Contender(_TABLE, lambda _: made.core.images(places, 1)),
            Contender(_ABS, lambda _: np.abs(array, out=out)),
            Contender(_PSF, direct),
        ],
        rounds,
        keep=False,
    )
    result.seconds[_PSF] = result.seconds[_PSF] * (_IMAGES / 20)
    return result


_IMAGE, _FOUR = "image", "the image with slopes by z, row, column and astigmatism"
_FEW, _MANY = "the gradient by 21 Zernike terms", "the gradient by 231 Zernike terms"


def _objectives(rounds: int) -> Race:
    """Return what images, slopes and gradients by psf take."""
    random = np.random.default_rng(6)
    options: dict[str, Any] = {"method": lm.methods.ChordalDebye(TOL), "threads": 1}

    def fresh(count: int) -> list[Any]:
        return [_OBJECTIVE.pupil(depth=1e-6, z=random.uniform(-MOST, MOST), **_LIGHT) for _ in range(count)]

    def image(pupil: Any, names: Any = ()) -> Any:
        return lm.psf(pupil, SIDE, PIXEL, derivatives=names, **options)

    weights = random.standard_normal((SIDE, SIDE))

    def made(count: int) -> list[Any]:
        return [image(pupil) for pupil in fresh(count)]

    def gradient(psf: Any, names: Any) -> Any:
        return psf.pullback(weights, names)

    few, many = ([f"noll {j}" for j in range(2, 2 + count)] for count in (21, 231))
    slopes = partial(image, names=("z", "row", "column", (2, 2)))
    images = [Contender(name, way, fresh=fresh) for name, way in ((_IMAGE, image), (_FOUR, slopes))]
    gradients = [Contender(n, partial(gradient, names=of), fresh=made) for n, of in ((_FEW, few), (_MANY, many))]
    return race([*images, *gradients], rounds, keep=False)


def gradient_over_image(settings: Settings, *, terms: int) -> Measured:
    """Return how long the gradient of a weighted sum takes over the image."""
    return Measured(_objectives(settings.rounds).ratio(_FEW if terms == 21 else _MANY, _IMAGE), None, "one molecule")


def lost(seed: int, photons: float, background: float, count: int) -> float:
    """Return the share of molecules beyond six times the bound by a strongly aberrated objective."""
    random = np.random.default_rng(seed)
    terms = random.normal(size=7)
    terms *= 0.3 / np.sqrt((terms**2).sum())
    names = (5, 6, 7, 8, 11, 12, 22)
    wavefront = lm.Wavefront.zernike(dict(zip(names, terms, strict=True)), order="noll", unit="waves")
    light: dict[str, Any] = {"wavelength": 600e-9, "aberrations": wavefront}
    made = lm.localize.Table(_OBJECTIVE.pupil(depth=1e-6, **light), SIDE, PIXEL, z=(-0.95e-6, 0.95e-6), tol=TOL)
    row, column = SIDE // 2 + random.uniform(-1.0, 1.0, (2, count))
    z = random.uniform(-0.85e-6, 0.85e-6, count)
    images = np.asarray(made(row, column, z), dtype=np.float64)  # within the table's bound, far below the noise
    fit = lm.localize.fit(made, random.poisson(photons * images + background))
    off = np.stack([fit.row - row, fit.column - column, fit.z - z], axis=1)
    off /= _bound(made, (row, column, z), photons, background)
    return float((np.abs(off) > 6.0).any(axis=1).mean())


def image_over_abs(settings: Settings) -> Measured:
    """Return how long an image takes over np.abs of as many floats."""
    return Measured(_images(settings.rounds).ratio(_TABLE, _ABS), true_error(), f"proven {table().error_bound:.1e}")


def fit_over_splines(settings: Settings, *, starts: int) -> Measured:
    """Return how long a spline's fit takes over ours."""
    result, name = _fits(settings.rounds), _ONE if starts == 1 else _FIVE
    if name not in result.seconds:
        raise NotImplementedError("Picasso is not installed; make peers")
    return Measured(
        result.ratio(name, _FIT), None, f"{_FITTED / result.median(_FIT):,.0f} fits a second".replace(",", " ")
    )


def _fits(rounds: int) -> Race:
    at = molecules(_FITTED)
    counts = np.random.default_rng(5).poisson(PHOTONS * at.images + BACKGROUND)
    made = table()
    mine = Contender(_FIT, lambda _: lm.localize.fit(made, counts, threads=1))
    return race([mine, *_splines(counts.astype(float))], rounds, keep=False)


def _splines(counts: Array) -> list[Contender]:
    """Return Picasso's fits of the same images, from one start along z and from five."""
    if find_spec("picasso") is None:
        return []
    # Of this module two functions are used, and it asks for much that draws windows.
    plain = ModuleType("picasso.lib")
    plain.n_workers = lambda: 1  # type: ignore[attr-defined]
    plain.n_futures_done = lambda futures: sum(one.done() for one in futures)  # type: ignore[attr-defined]
    for name in ("FloatArray2D", "FloatArray3D"):
        setattr(plain, name, Any)
    sys.modules["picasso.lib"] = plain
    import picasso

    picasso.lib = plain
    from picasso.fitting import splinefit

    wide = SIDE + 2 * _MARGIN
    z = np.arange(-RANGE - 2 * _STEP, RANGE + 2.5 * _STEP, _STEP)
    template = lm.psf(_OBJECTIVE.pupil(depth=1e-6, z=z, **_LIGHT), wide, PIXEL, tol=1e-6, dtype=np.float64).values
    coefficients = _cubic(template)[None]
    n, start = len(counts), np.zeros((len(counts), 5), dtype=np.float32)
    start[:, 0] = counts.max(axis=(1, 2)) - counts.min(axis=(1, 2))
    start[:, 0] /= template.max()
    start[:, 1] = start[:, 2] = -_MARGIN
    start[:, 3], start[:, 4] = -(len(z) // 2), counts.min(axis=(1, 2))
    identity = np.tile([1.0, 0.0, 0.0, 1.0], (n, 1, 1))
    seeds = -np.linspace(3.0, len(z) - 4.0, 5)

    def call(_: Any, several: bool) -> Any:
        return splinefit.fit_spots(
            splinefit.KIND_3D,
            counts[:, None],
            coefficients,
            identity,
            np.zeros((n, 1, 2)),
            start,
            seeds,
            several,
            mle=True,
        )

    found = call(None, True)[0]
    at = molecules(len(counts))
    off = np.median(np.abs(found[:, 1] + _MARGIN - (at.column - SIDE // 2)))
    if not off < 0.2:
        raise AssertionError(f"splines must find the molecules, got a median error of {off:.2g} pixels")
    ways: list[tuple[str, Callable[[Any], Any]]] = [
        (_ONE, partial(call, several=False)),
        (_FIVE, partial(call, several=True)),
    ]
    return [Contender(name, way) for name, way in ways]


def _cubic(values: Array) -> NDArray[np.float64]:
    """Return natural cubic splines through values at whole numbers: (pieces along z, y, x, powers of z, y, x)."""
    made: NDArray[Any] = values
    for axis in range(3):
        spline = CubicSpline(np.arange(values.shape[axis]), made, axis=axis, bc_type="natural")
        # Powers rise, and come last; pieces stay where the values were.
        made = np.moveaxis(np.moveaxis(spline.c[::-1], 1, axis + 1), 0, -1)
    return np.ascontiguousarray(made)
