"""The excess noise of electron multiplication, in what is recorded and in every function that takes a noise.

With an excess F^2, counts over F^2 are Poisson's: a function must return what it returns for the noise without excess
of the same images, and F^2 times the light.
"""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from dataclasses import replace

import numpy as np
import pytest

import lommel as lm
import simulated_movies as simulated
from lommel.recorded.camera_noise import contradiction
from objectives import OIL_60X

EXCESS = 2.0
EM = lm.Noise(white=0.02, read=0.1, offset=200.0, excess=EXCESS)
SAME = lm.Noise(white=0.01, read=0.05, offset=200.0)
PHOTOS = {EM: lm.Noise(white=5e3, read=3.0, excess=EXCESS), SAME: lm.Noise(white=2.5e3, read=1.5)}  # white at 1
PUPIL = lm.Pupil(wavefront=lm.Wavefront.zernike({5: 0.4}, order="noll"))
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)


@pytest.mark.parametrize("excess", [1.2, 2.0, 3.0])
@pytest.mark.parametrize("mean", [0.3, 20.0])
def test_the_register_has_the_mean_and_the_variance_that_are_stated(excess, mean):
    noise = lm.Noise(white=0.1, read=0.5, offset=10.0, excess=excess)
    seen = noise.electrons(noise.record(np.full(100_000, mean), seed=1))
    variance = float(noise.variance(mean))
    assert variance == pytest.approx(excess * mean + 0.25, rel=1e-12)
    assert seen.mean() == pytest.approx(mean, abs=5.0 * (variance / seen.size) ** 0.5)
    assert seen.var() == pytest.approx(variance, rel=0.04)
    plain = noise.poisson
    assert plain.excess == 1.0
    assert plain.electrons(noise.image(mean)) == pytest.approx(mean / excess, rel=1e-9)
    assert plain.variance(mean / excess) == pytest.approx(variance / excess**2, rel=1e-12)


@pytest.mark.parametrize("excess", [0.5, 101.0, np.nan, [2.0, 2.0]])
def test_an_excess_is_a_number_from_1_to_100(excess):
    with pytest.raises((TypeError, ValueError), match="excess"):
        lm.Noise(read=1.0, excess=excess)


def star(seed=1, flux=2e4, side=25):
    return EM.record(flux * lm.psf(PUPIL, side, 0.5).values + 5.0, seed)


def retrieve(noise):
    found = lm.retrieve(star(), lm.Pupil(), pixel=0.5, noise=noise, terms=2)
    light = [found.flux, found.background, found.errors["flux"], found.errors["background"]]
    return [found.coefficients[2, -2], found.errors[2, -2], found.chi2, found.model], light


def beads(noise):
    z = np.arange(-2, 3) * 250e-9
    images = lm.psf(OIL_60X.pupil(depth=50e-9, z=z, wavelength=520e-9), 11, 6e-6, tol=1e-4).values
    microscope = lm.Microscope(OIL_60X, 520e-9, 6e-6)
    found = lm.fit_beads(EM.record(2e4 * images + 5.0, 1), microscope, z=z, noise=noise, terms=2, priors={})
    one = found.beads[0]
    light = [one.flux, one.background, one.flux_errors, one.background_errors]
    light += [one.errors["flux"], one.errors["background"]]
    return [*found.coefficients.values(), one.z, one.errors["row"], found.chi2, one.model, one.residual], light


def field(noise):
    places = [(60, 60), (60, 200), (200, 60), (200, 200)]
    windows = [star(seed) for seed in range(4)]
    targets = lm.detection.Targets(windows=windows, places=places, shape=(260, 260), noise=noise)
    found = lm.fit_field(targets, lm.Pupil(), pixel=0.5, terms=2, degree=0, defocus=0.0, blur=0.0)
    stars = found.stars
    return [found.coefficients, found.covariance, found.chi2], [
        stars.flux,
        stars.background,
        found.model,
        found.images,
    ]


def spots(noise):
    sky = np.full((64, 64), 5.0)
    sky[30:33, 40:43] += 300.0
    found = lm.detection.find_spots(EM.record(sky, 1), noise=noise, window=15)
    assert len(found) == 1
    return [found.places, found.centers, found.score], [found.flux]


def crossings(noise):
    y, x = np.mgrid[:80, :80] - 40.25
    board = np.where((x > 0) == (y > 0), 300.0, 30.0)
    found = lm.detection.find_crossings(EM.record(board, 1), noise=noise)
    assert len(found) == 1
    return [found.centers], [found.contrast]


def fisher(noise):
    light = {"photons": 1e3, "background": 5.0} if noise is EM else {"photons": 500.0, "background": 2.5}
    names = ["row", "photons", "background"]
    errors = lm.fisher(lm.Pupil(), 15, 0.5, of=names, noise=noise, **light).errors
    return [errors["row"]], [errors["photons"], errors["background"]]


def precision(noise):
    pair = [LENS.focused(1.5), LENS.focused(1.8)]
    return [lm.depth_precision(pair, 1.6, 8e-6, noise=replace(noise, white=1e3 if noise is EM else 500.0))], []


def foci(noise):
    light = replace(noise, white=1e3 if noise is EM else 500.0)
    return [lm.best_depth_foci(LENS, 1.5, 8e-6, noise=light)[1].focus_distance], []


def scene(seed=0):
    return 0.4 + 0.3 * np.sign(np.random.default_rng(seed).standard_normal((64, 96)))


def depths(noise):
    lenses, options = [LENS.focused(1.5), LENS.focused(1.8)], {"encoding": "linear"}
    pair = [
        lm.imaging.depth_of_field(scene(), np.full((64, 96), 1.6), lens, 8e-6, energy=0.9, **options).values
        for lens in lenses
    ]
    pair = [PHOTOS[EM].record(5e3 * one, k) for k, one in enumerate(pair)]
    options |= {"noise": PHOTOS[noise], "between": (1.3, 2.0)}
    found = lm.imaging.depth_from_defocus(pair, lenses, 8e-6, **options)
    return [found.depth, found.errors, found.misfit, found.sharp], []


def calibrated(noise):
    lenses, view = [LENS.focused(1.5), LENS.focused(1.8)], np.random.default_rng(2).random((192, 192))
    pair = [
        lm.imaging.depth_of_field(view, np.full(view.shape, 1.6), lens, 8e-6, energy=0.9, encoding="linear").values
        for lens in lenses
    ]
    pair = [PHOTOS[EM].record(5e3 * one, k) for k, one in enumerate(pair)]
    found = lm.imaging.calibrate_focus([pair], [1.6], lenses, 8e-6, encoding="linear", noise=PHOTOS[noise])
    return [found.focus_shifts, found.focus_error, found.planes[0].found, found.planes[0].misfit], []


def restored(noise):
    blur = lm.imaging.DepthBlur(np.full((32, 40), 2.1), LENS, 8e-6)
    photo = PHOTOS[EM].record(5e3 * blur.forward(scene()[:32, :40]), 0)
    found = lm.imaging.restore(
        photo, None, blur, encoding="linear", noise=PHOTOS[noise], method=lm.imaging.RichardsonLucy(steps=3)
    )
    return [found.values, found.discrepancy, found.before], []


def photograph(noise):
    photo = np.minimum(PHOTOS[EM].record(5e3 * scene()[:32, :40], 0), 1.0)
    way = lm.imaging.RichardsonLucy(steps=2)
    found = lm.imaging.restore(
        photo, np.full((32, 40), 2.1), LENS, 8e-6, encoding="linear", noise=PHOTOS[noise], method=way, energy=0.9
    )
    return [found.discrepancy, found.before, *restored(noise)[0]], []


def stack():
    z = np.arange(-2, 3) * 0.3e-6
    return lm.psf(OIL_60X.pupil(depth=1e-6, z=z, wavelength=520e-9), 9, 6e-6, tol=1e-3)


def deconvolved(noise):
    seen = EM.record(np.full((5, 16, 16), 50.0), 0)
    seen[2, 8, 8] += 5e4
    found = lm.microscopy.deconvolve(seen, stack(), noise=noise, method=lm.imaging.RichardsonLucy(steps=2))
    (channel,) = found.channels
    return [found.values, channel.discrepancy, channel.before, channel.background], []


def deep(noise):
    seen = EM.record(np.full((5, 20, 20), 50.0), 0)
    found = lm.microscopy.deconvolve(
        seen, OIL_60X, pixel=6e-6, step=0.3e-6, wavelength=520e-9, noise=noise, direction="up", depth=1e-6,
        method=lm.imaging.RichardsonLucy(steps=2, target=0.0),
    )  # fmt: skip
    return [found.values, found.channels[0].discrepancy, [len(note) for note in found.notes]], []


def frames():
    made = np.full((3, 64, 64), 4.0)
    made[:, 20:35, 25:40] += 1500.0 * lm.psf(simulated.pupil(), 15, simulated.PIXEL, tol=1e-4).values
    return EM.record(made, 3)


def table():
    return lm.localize.Table(simulated.pupil(), shape=15, pixel=simulated.PIXEL, z=(-0.5e-6, 0.5e-6), tol=1e-3)


def found_spots(noise):
    found = lm.localize.find(frames(), noise=noise)
    assert len(found) == 3
    return [found.row, found.score], []


def molecules(noise):
    found = lm.localize.fit(table(), frames()[:, 20:35, 25:40], noise=noise)
    light = [found.photons, found.background, found.errors.photons, found.errors.background]
    return [found.row, found.z, found.errors.z, found.discrepancy, found.log_likelihood], light


def movie(noise):
    rows = lm.localize.localize_movie(frames(), table(), noise=noise).table
    light = [rows[name] for name in ("photons", "background", "photons_error", "background_error")]
    return [rows["x"], rows["z"], rows["x_error"], rows["discrepancy"]], light


def blocks(noise):
    parts = list(lm.localize.localize_blocks(frames(), table(), noise=noise))
    return [part.table["x"] for part in parts], [part.table["photons"] for part in parts]


def traced(noise):
    image = EM.image(np.full((4, 4), 30.0))
    return [lm.imaging.traced_noise(image, noise, np.ones((4, 4)))], []


HONOURED = {
    "lommel.retrieve": retrieve, "lommel.fit_beads": beads, "lommel.detection.Targets": field,
    "lommel.detection.find_spots": spots, "lommel.detection.find_crossings": crossings, "lommel.fisher": fisher,
    "lommel.depth_precision": precision, "lommel.best_depth_foci": foci, "lommel.imaging.depth_from_defocus": depths,
    "lommel.imaging.calibrate_focus": calibrated,
    "lommel.imaging.restore": photograph,
    "lommel.microscopy.deconvolve": lambda noise: (deconvolved(noise)[0] + deep(noise)[0], []),
    "lommel.localize.find": found_spots, "lommel.localize.fit": molecules, "lommel.localize.localize_movie": movie,
    "lommel.localize.localize_blocks": blocks, "lommel.imaging.traced_noise": traced,
}  # fmt: skip
REFUSED = ("lommel.imaging.LiveDepth", "lommel.imaging.LiveSharpen")
# Results, options, what only records, and images with their noise.
OTHERS = {
    "lommel.microscopy.RestoredChannel",
    "lommel.imaging.DatasetOptions",
    "lommel.imaging.render_dataset",
    "lommel.Counts",
    "lommel.recorded.Counts",
    "lommel.detection.PointSources",
    "lommel.detection.Crossings",
}


def takers() -> set[str]:
    """Return the public functions and classes with an argument `noise`."""
    packages = [lm.__name__, *(f"lommel.{each.name}" for each in pkgutil.iter_modules(lm.__path__) if each.ispkg)]
    found = set()
    for name in packages:
        if name in ("lommel.napari_plugin", "lommel.cli", "lommel.adapters"):
            continue
        module = importlib.import_module(name)
        for public in getattr(module, "__all__", ()):
            made = getattr(module, public)
            kind = getattr(made, "__module__", "")
            if callable(made) and not (isinstance(made, type) and issubclass(made, Exception)) and kind != "typing":
                found |= {f"{name}.{public}"} if "noise" in inspect.signature(made).parameters else set()
    return found


def test_every_function_that_takes_noise_is_checked_here():
    assert takers() == {*HONOURED, *REFUSED, *OTHERS}


@pytest.mark.parametrize("name", HONOURED)
def test_light_is_multiplied_and_all_else_is_that_of_noise_without_excess(name):
    (own, light), (same, plain) = HONOURED[name](EM), HONOURED[name](SAME)
    for one, other in zip(own, same, strict=True):
        np.testing.assert_allclose(one, other, rtol=2e-4, atol=1e-6)
    for one, other in zip(light, plain, strict=True):
        np.testing.assert_allclose(one, EXCESS * np.asarray(other), rtol=2e-4, atol=1e-6)


@pytest.mark.parametrize("name", REFUSED)
def test_live_frames_refuse_an_excess(name):
    lenses = [LENS.focused(1.5), LENS.focused(1.8)] if name.endswith("Depth") else LENS
    with pytest.raises(ValueError, match="noise must have no excess for live frames, got excess=2"):
        getattr(lm.imaging, name.rpartition(".")[2])(lenses, 8e-6, between=(1.3, 2.0), noise=EM, shape=(64, 64))


def test_the_gain_of_a_stack_is_found_beside_a_stated_excess():
    y, x = np.mgrid[:64, :64] - 32.0
    light = 5.0 + 200.0 * np.exp(-(x**2 + y**2) / 400.0)
    seen = EM.record(np.broadcast_to(light, (12, 64, 64)), 0)
    found = lm.microscopy.estimate_noise(seen, read=0.1, excess=EXCESS)
    assert found.white == pytest.approx(EM.white, rel=0.1)
    assert found.offset == pytest.approx(200.0, abs=30.0)
    assert (found.read, found.excess) == (0.1, EXCESS)
    assert contradiction(seen, EM) is None
    assert "2" in contradiction(seen, lm.Noise(white=0.02, read=0.1, offset=200.0))
