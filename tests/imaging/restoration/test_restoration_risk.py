"""No restoration is farther from the scene than the photograph, whatever the method."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest

from lommel import Noise
from lommel.imaging import Blend, OnePass, RichardsonLucy, TotalVariation, restore
from scenes import POINTS, ThinLens, averaged, lommel_lens, plane, texture

SIDE, READ = 96, 3.0
LENS = ThinLens(35e-3, 2.8, 1.35, 540e-9, 4e-6)
METHODS = [RichardsonLucy(), TotalVariation(steps=60), OnePass(), Blend()]


@pytest.fixture(autouse=True)
def _any_loss(monkeypatch):
    """Filters of any blur, also of one that is too wide for them."""
    monkeypatch.setattr("lommel.imaging.one_pass._MAX_LOSS", np.inf)


def distance_of(pixels: float) -> float:
    """The distance, nearer than the focus, of a blur of this radius."""
    radius = 0.5 * LENS.focal_length / LENS.f_number
    sensor = LENS.focal_length / (1.0 - LENS.focal_length / LENS.focus)
    return 1.0 / (1.0 / LENS.focus + pixels * LENS.pixel / (radius * sensor))


@lru_cache(maxsize=64)
def seen(kind: str, blur: float, light: float) -> tuple[np.ndarray, np.ndarray]:
    """The electrons of a photograph, and those of the scene averaged by the pixels."""
    scene = np.ones((SIDE * POINTS, SIDE * POINTS)) if kind == "flat" else texture(kind, SIDE, 3)
    counts = plane(scene, [LENS], distance_of(blur), light)[0]
    draw = np.random.default_rng(5)
    return draw.poisson(counts) + draw.normal(0.0, READ, counts.shape), light * averaged(scene)


def loss(photo: np.ndarray, truth: np.ndarray, light: float, stated: float, method, gain: float = 1.0):
    """Return by how many decibels a result is farther from the scene than the photograph, and the result."""
    white = 3.0 * light
    depth = np.full((SIDE, SIDE), distance_of(stated))
    found = restore(
        photo / white, depth, lommel_lens(LENS), LENS.pixel, encoding="linear",
        noise=Noise(white=gain * white, read=gain * READ), method=method,
    )  # fmt: skip
    inner = np.s_[12:-12, 12:-12]
    known = ~np.isnan(photo[inner])
    errors = [np.square(image[inner] - truth[inner])[known].mean() for image in (white * found.light, photo)]
    return 10.0 * np.log10(errors[0] / errors[1]), found


@pytest.mark.parametrize("method", METHODS, ids=lambda each: type(each).__name__)
@pytest.mark.parametrize("light", [50.0, 500.0, 50_000.0])
@pytest.mark.parametrize("blur", [0.0, 0.4, 1.2, 3.0])
def test_stated_blur_makes_no_photograph_worse(method, light, blur):
    for kind in ("leaves", "text", "flat"):
        assert loss(*seen(kind, blur, light), light, blur, method)[0] < 0.21, kind


@pytest.mark.parametrize("method", METHODS, ids=lambda each: type(each).__name__)
@pytest.mark.parametrize(("blur", "stated"), [(0.0, 2.0), (0.5, 3.0), (2.0, 5.0)])
def test_blur_that_is_not_there_is_left_alone(method, blur, stated):
    for kind in ("leaves", "text"):
        worse, found = loss(*seen(kind, blur, 5000.0), 5000.0, stated, method)
        assert worse < 0.05, kind
        assert found.photograph == 1.0
        assert found.stopped.startswith("misfit")
        assert found.discrepancy == pytest.approx(found.before, rel=1e-6)


@pytest.mark.parametrize("method", METHODS, ids=lambda each: type(each).__name__)
def test_blur_without_noise_is_kept_as_it_is_undone(method):
    worse, found = loss(*seen("leaves", 1.2, 5000.0), 5000.0, 1.2, method)
    assert worse < -2.0
    assert found.photograph < 0.05


@pytest.mark.parametrize("method", [*METHODS[:2], Blend()], ids=lambda each: type(each).__name__)
def test_unknown_pixels_are_filled_whatever_is_kept_of_the_photograph(method):
    photo, truth = seen("leaves", 0.4, 500.0)
    photo = photo.copy()
    photo[40:48, 40:48] = np.nan
    worse, found = loss(photo, truth, 500.0, 0.4, method)
    assert worse < 0.2
    assert np.isfinite(found.light).all()
    assert found.light[40:48, 40:48].mean() == pytest.approx(truth.mean() / 1500.0, rel=0.3)


@pytest.mark.parametrize("method", [RichardsonLucy(), Blend()], ids=lambda each: type(each).__name__)
@pytest.mark.parametrize("gain", [0.5, 2.0])
def test_noise_that_is_stated_wrongly_does_no_harm(method, gain):
    for blur in (0.4, 2.0):
        assert loss(*seen("leaves", blur, 500.0), 500.0, blur, method, gain)[0] < 0.2
