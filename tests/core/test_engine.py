"""What any engine keeps: results by name, None and exceptions in place of numbers that stand for them."""

from __future__ import annotations

import ast

import numpy as np
import pytest

import organisation
from lommel.core import engine
from lommel.core.answers import ToleranceError, Wanted

RADIAL = engine.RadialStack(np.array([[6.0, -1.0], [0.5, 2.0]]), 0.3, np.array([0.0, 0.4]))
DISK = engine.DiskStack(np.array([[2, 0], [4, 0]], dtype=np.int32), *RADIAL)
WINDOW = engine.Window((9, 11), (4.0, 5.0), 0.8)
EMPTY = np.empty((2, 9, 11))

SAMPLES = {
    "radial": lambda tol, wanted: engine.radial_images(RADIAL, WINDOW, tol, wanted),
    "series": lambda tol, wanted: engine.series_images(DISK, WINDOW, tol, wanted),
    "chordal": lambda tol, wanted: engine.chordal_images(DISK, WINDOW, tol, wanted),
}


@pytest.fixture(params=SAMPLES)
def images(request):
    return SAMPLES[request.param]


def test_all_engines_give_the_same_samples_of_radial_pupils(images):
    v = np.sqrt(((np.indices(WINDOW.shape) - np.array(WINDOW.center)[:, None, None]) ** 2).sum(axis=0)) * WINDOW.step
    at, where = np.unique(v, return_inverse=True)
    exact = engine.radial_profiles(RADIAL, at, 1e-11)
    made = images(1e-8, Wanted())
    error = np.abs(made.values - exact.values[:, where.reshape(v.shape)]).max(axis=(1, 2))
    assert np.all(error <= made.error * made.values.max(axis=(1, 2)) + 1e-10)
    assert np.all(made.error <= 1e-8)
    assert np.all(made.scale == 1.0)
    assert made.peak == pytest.approx(made.values.max(axis=(1, 2)), rel=1e-6)


def test_without_a_scale_each_image_is_divided_by_its_largest_value(images):
    divided, plain = images(1e-8, Wanted(None)), images(1e-8, Wanted())
    tops = plain.values.max(axis=(1, 2))
    assert divided.scale == pytest.approx(1.0 / tops, rel=1e-7)
    assert divided.values.max(axis=(1, 2)) == pytest.approx(1.0, rel=1e-12)
    assert np.all(divided.error <= 1e-8)


def test_a_tolerance_that_cannot_be_met_is_an_exception(images):
    with pytest.raises(ToleranceError, match=r"tol=1e-17 cannot be met in double precision: the proven error bound"):
        images(1e-17, Wanted())


def test_profiles_and_gradients_beyond_double_precision_are_exceptions_as_well():
    for compute in (
        lambda: engine.radial_profiles(RADIAL, np.array([0.0, 1.0]), 1e-17),
        lambda: engine.chordal_gradient(DISK, WINDOW, 1e-17, np.ones((2, *WINDOW.shape)), ((2, 0),), 1),
        lambda: engine.radial_plan(RADIAL, (2,), WINDOW, 1e-17, Wanted(), integrate=False)(RADIAL.terms, EMPTY),
        lambda: engine.chordal_plan(*DISK[2:], WINDOW, 1e-17, Wanted(), if_cheaper=False)(*DISK[:2], EMPTY),
    ):
        with pytest.raises(ToleranceError, match=r"tol=1e-17 cannot be met") as told:
            compute()
        assert 1e-17 < told.value.bound < 1e-9


@pytest.mark.parametrize("scale", [None, 2.0])
def test_plans_have_the_scale_of_each_image_and_the_largest_bound(scale):
    """And averages over pixels of any engine are those of another."""
    for images, plan, terms in (
        (engine.radial_images(RADIAL, WINDOW, 1e-8, Wanted(scale)),
         engine.radial_plan(RADIAL, (2,), WINDOW, 1e-8, Wanted(scale), integrate=False), (RADIAL.terms,)),
        (engine.chordal_images(DISK, WINDOW, 1e-8, Wanted(scale)),
         engine.chordal_plan(*DISK[2:], WINDOW, 1e-8, Wanted(scale), if_cheaper=False), DISK[:2]),
    ):  # fmt: skip
        scales, bound = plan(*terms, values := np.zeros_like(EMPTY))
        assert (scales, values) == (pytest.approx(images.scale), pytest.approx(images.values, abs=1e-12))
        assert bound == pytest.approx(images.error.max(), rel=1e-3)
        assert images.error.min() < 0.999 * bound
    exact = engine.radial_images(RADIAL, WINDOW, 1e-9, Wanted(), integrate=True).values
    made = engine.disk_averages(DISK, WINDOW, 1e-6, Wanted(), if_cheaper=False)
    assert np.abs(made.values - exact).max(axis=(1, 2)) == pytest.approx(0.0, abs=2e-6)
    wide = WINDOW._replace(step=12.0)
    far, there = (
        engine.far_averages(DISK, wide, 1e6, 1e-2, 1),
        engine.disk_averages(DISK, wide, 1e-6, Wanted(), if_cheaper=False),
    )
    assert np.count_nonzero(far.values) > 9
    assert np.abs(far.values - there.values)[far.values != 0.0].max() <= far.error.max() + 1e-6 < 1e-3


def test_derivatives_come_by_the_power_of_each_and_none_where_none_was_asked_for():
    found = engine.radial_images(RADIAL, WINDOW, 1e-8, Wanted(powers=(1, 2)))
    assert found.slopes is not None
    assert found.slopes.values.shape == (2, 2, *WINDOW.shape)
    assert found.slopes.error.shape == (2, 2)
    assert engine.radial_images(RADIAL, WINDOW, 1e-8, Wanted()).slopes is None
    assert engine.radial_images(RADIAL, WINDOW, 1e-8, Wanted(), integrate=True).slopes is None


def test_nothing_else_imports_the_compiled_core():
    importers = set()
    for name, tree in organisation.modules().items():
        for node in ast.walk(tree):
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import | ast.ImportFrom) else []
            module = node.module or "" if isinstance(node, ast.ImportFrom) else ""
            if "_core" in names or any(part.endswith("._core") for part in (*names, module)):
                importers.add(name)
    assert importers == {"core/engine"}


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize(("height", "width"), [(1, 1), (3, 5), (32, 32), (25, 41), (47, 46)])
def test_the_likelihood_of_stars_is_that_of_its_definition(height, width, kind):
    draw, sets, count, k = np.random.default_rng(height), 2, 3, 5
    images = [draw.normal(size=(sets * count, height, width)).astype(kind) for _ in range(1 + k)]
    light = np.stack([draw.uniform(50.0, 90.0, (sets, count)), draw.uniform(0.0, 9.0, (sets, count))], axis=1)
    shape = count, height * width
    counted, recorded = draw.poisson(20.0, shape).astype(float), draw.uniform(0.0, 4.0, shape)
    read, valid = np.maximum(recorded, 0.05), (draw.random(shape) < 0.8).astype(float)
    star = np.stack([counted, recorded, read, valid])
    numbers, products = engine.star_likelihood(images, light, star, 1)
    psf, *slopes = (image.reshape(sets, *shape).astype(float) for image in images)
    mean = light[:, 0, :, None] * psf + light[:, 1, :, None]
    assert (mean < 0.0).any() or height == 1
    variance = np.maximum(mean + read, 0.25 * read)
    root, exact = np.sqrt(valid / variance), np.maximum(mean, 0.0) + recorded
    rows = np.stack([*slopes, psf, np.ones_like(psf), counted - mean], axis=2) * root[:, :, None]
    np.testing.assert_allclose(products, rows @ rows.swapaxes(-1, -2), rtol=1e-12, atol=1e-9)
    expected = [
        valid * (variance - (counted + read) * np.log(variance)),
        root**2 * exact,
        root**4 * (np.maximum(mean, 0.0) + 2.0 * exact**2),
    ]
    np.testing.assert_allclose(numbers, [part.sum(axis=-1) for part in expected], rtol=1e-11, atol=1e-9)
    for made, threaded in zip((numbers, products), engine.star_likelihood(images, light, star, 0), strict=True):
        np.testing.assert_array_equal(made, threaded)
