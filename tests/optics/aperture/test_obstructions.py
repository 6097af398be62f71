"""Spiders, vignetting, masks, and the pupils that have them."""

from __future__ import annotations

import copy
import json
import math
import pickle
import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel import CatEye, Ellipse, Mask, Pupil, Spider, Wavefront
from lommel.methods import choice

GRID = np.meshgrid(np.linspace(-1.1, 1.1, 45), np.linspace(-1.1, 1.1, 47))
MASK = Mask.sample(lambda x, y: np.clip(0.2 + x * x + 0.5 * y, 0, 1), side=12)
SHAPES = {
    "spider": {"spider": Spider.equal(3, 0.1, 0.2)},
    "ellipse": {"vignetting": Ellipse(0.9, 0.5, 0.3)},
    "cat-eye": {"vignetting": CatEye((0.5, -0.2), 0.8)},
    "mask": {"mask": MASK},
    "all": {"spider": Spider(0.05, [1.0]), "vignetting": CatEye((0.1, 0.3)), "mask": MASK, "obscuration": 0.2},
}
SHAPED = pytest.mark.parametrize("shape", SHAPES.values(), ids=list(SHAPES))


def test_a_vane_runs_from_the_axis_in_its_direction_only():
    pupil = Pupil(spider=Spider(0.2, [math.pi / 2]))
    x, y = np.array([0.0, 0.0, 0.09, 0.11, 0.5]), np.array([0.5, -0.5, 0.5, 0.5, 0.0])
    assert pupil.values(x, y)[0].tolist() == [0, 1, 0, 1, 1]


def test_equal_vanes_are_at_equal_angles():
    assert Spider.equal(3, 0.1, 0.5).angles == pytest.approx([0.5, 0.5 + 2 * math.pi / 3, 0.5 + 4 * math.pi / 3])


def test_the_angle_of_an_ellipse_runs_from_columns_to_rows():
    pupil = Pupil(vignetting=Ellipse(0.9, 0.3, math.pi / 4))
    assert pupil.values([0.6, 0.6], [0.6, -0.6])[0].tolist() == [1, 0]


def test_a_cat_eye_is_clear_where_both_circles_are():
    x, y = GRID
    clear = Pupil(vignetting=CatEye((0.5, -0.2), 0.8)).values(x, y)[0] != 0
    assert np.array_equal(clear, (np.hypot(x, y) <= 1) & (np.hypot(x - 0.5, y + 0.2) <= 0.8))


def test_the_rows_of_a_mask_rise_with_y_and_its_columns_with_x():
    mask = Mask([[0.1, 0.2], [0.3, 0.4]])
    pupil = Pupil(mask=mask)
    assert pupil.values([-0.5, 0.5, -0.5, 0.5], [-0.5, -0.5, 0.5, 0.5])[0].real.tolist() == [0.1, 0.2, 0.3, 0.4]
    assert mask.at(np.array([-1.0, 1.0, 1.001]), np.array([-1.0, 1.0, 0.0])).tolist() == [0.1, 0.4, 0.0]
    assert np.array_equal(Mask.sample(lambda x, y: 0.25 + 0.1 * (x > 0) + 0.2 * (y > 0), 2).values.round(3),
                          [[0.25, 0.35], [0.45, 0.55]])  # fmt: skip


def test_a_mask_keeps_values_of_its_own():
    values = np.ones((3, 3))
    mask = Mask(values)
    values[:] = 0.0
    assert mask.values.min() == 1.0
    with pytest.raises(ValueError, match="read-only"):
        mask.values[0, 0] = 0.5


@SHAPED
def test_the_pupil_function_is_the_product_of_all_that_is_in_the_way(shape):
    x, y = GRID
    wavefront = Wavefront(2.0, nonradial={(3, 1): 1.0})
    pupil = Pupil(wavefront, apodization=0.7, **shape)
    expected = Pupil(wavefront, apodization=0.7, obscuration=pupil.obscuration).values(x, y)
    for name, part in shape.items():
        if name == "mask":
            expected = expected * part.at(x, y)
        elif name != "obscuration":
            expected = expected * (part.margin(x, y) >= 0)
    assert pupil.values(x, y) == pytest.approx(expected, abs=1e-15)


@SHAPED
@pytest.mark.parametrize("g", [0.0, 1.3])
def test_area_amplitude_and_transmission_are_integrals_of_the_pupil_function(shape, g):
    # The mask has 12 x 12 cells: the fine lattice has its cells in them.
    n = 600
    at = lm.optics.aperture.mask.cell_centers(n)
    amplitude = np.abs(Pupil(Wavefront(2.0), apodization=g, **shape).values(at[None, :], at[:, None])[0])
    bare = np.abs(Pupil(**shape).values(at[None, :], at[:, None])[0])
    pupil = Pupil(Wavefront(2.0), apodization=g, **shape)
    cell = 4 / (math.pi * n * n)
    # A mask takes the apodization at the middle of its cells.
    abs_ = 4e-3 if "mask" in shape and g else 3e-4
    assert pupil.area == pytest.approx(bare.sum() * cell, abs=3e-4)
    assert pupil.amplitude == pytest.approx(amplitude.sum() * cell, abs=abs_)
    assert pupil.transmission == pytest.approx((amplitude**2).sum() * cell, abs=abs_)


@SHAPED
def test_a_shaped_pupil_survives_json_pickling_copies_and_indexing(shape):
    pupil = Pupil(Wavefront([1.0, 2.0]), wavelength=5e-7, f_number=8.0, **shape)
    assert Pupil.from_dict(json.loads(json.dumps(pupil.to_dict(), allow_nan=False))) == pupil
    assert pickle.loads(pickle.dumps(pupil)) == copy.deepcopy(pupil) == pupil
    assert hash(copy.deepcopy(pupil).opening) == hash(pupil.opening)
    assert pupil != Pupil(pupil.wavefront, wavelength=5e-7, f_number=8.0)
    assert pupil[1] == Pupil(Wavefront(2.0), wavelength=5e-7, f_number=8.0, **shape)
    ideal = pupil.unaberrated()
    assert (ideal.spider, ideal.vignetting, ideal.mask) == (pupil.spider, pupil.vignetting, pupil.mask)
    assert ideal.wavefront == Wavefront()


@SHAPED
@pytest.mark.parametrize("suffix", [".tif", ".npy", ".npz", ".png"])
def test_files_keep_the_aperture(shape, suffix, tmp_path):
    answer = lm.psf(Pupil(Wavefront(1.0), **shape), 9, 0.5)
    answer.save(tmp_path / f"a{suffix}")
    loaded = lm.PSF.load(tmp_path / f"a{suffix}")
    assert (loaded.pupil, loaded.method) == (answer.pupil, lm.NonuniformFFT())
    assert np.abs(loaded.values - answer.values).max() <= 2e-5 * answer.values.max()


@SHAPED
def test_without_a_method_the_non_uniform_fft_is_taken_and_named(shape):
    plan = lm.Plan(9, 0.5)
    assert plan(Pupil(**shape)).method == lm.NonuniformFFT()
    assert plan(Pupil(obscuration=0.3)).method == lm.NijboerZernike()
    assert plan(Pupil(**shape)).values.dtype == np.float32


def test_without_finufft_it_is_said_what_to_do(monkeypatch):
    monkeypatch.setattr(choice, "_missing", lambda name: True)
    monkeypatch.setitem(__import__("sys").modules, "finufft", None)
    held = Pupil(spider=Spider(0.1, [0.0]))
    with pytest.raises(ValueError, match="pip install finufft, or pass method=MatrixFourier"):
        lm.psf(held, 9, 0.5)
    with pytest.raises(ImportError, match="NonuniformFFT needs finufft: pip install finufft"):
        lm.psf(held, 9, 0.5, method=lm.NonuniformFFT())
    assert lm.psf(held, 9, 0.5, method=lm.MatrixFourier(64)).values.shape == (9, 9)
    assert lm.psf(Pupil(), 9, 0.5).method == lm.NijboerZernike()


def test_compare_goes_on_without_finufft(monkeypatch, lenses):
    from lommel.cli import reports

    monkeypatch.setitem(__import__("sys").modules, "finufft", None)
    instrument = lm.load_instrument(lenses["phone"])
    rows, answers = reports.compare(instrument, [lm.NonuniformFFT(), lm.MatrixFourier()])
    assert rows[0]["reason"].startswith("NonuniformFFT needs finufft: pip install finufft")
    assert rows[1]["reason"] is None
    assert set(answers) == {"Hankel", "MatrixFourier"}


def test_rays_that_are_stopped_do_not_widen_the_blur():
    # |grad Phi| = 4 C_d rho; the ellipse reaches 0.8 at most, the cat's eye 0.3.
    for vignetting, farthest in ((Ellipse(0.8, 0.4, 0.3), 0.8), (CatEye((0.1, 0.0), 0.2), 0.3)):
        pupil = Pupil(Wavefront(10.0), vignetting=vignetting)
        assert pupil.geometric_radius() == pytest.approx(40.0 * farthest / math.pi, rel=2e-3)
    mask = Mask.sample(lambda x, y: np.hypot(x, y) < 0.5, 200)
    assert Pupil(Wavefront(10.0), mask=mask).geometric_radius() == pytest.approx(20.0 / math.pi, rel=0.03)
    one = np.zeros((64, 64))
    one[33, 36] = 1.0
    expected = 40.0 * math.hypot(9, 3) / 64 / math.pi
    assert Pupil(Wavefront(10.0), mask=Mask(one)).geometric_radius() == pytest.approx(expected, rel=0.12)


@given(st.floats(1e-6, 1.99), st.lists(st.floats(-10, 10), min_size=1, max_size=5))
def test_a_spider_that_leaves_light_makes_a_pupil_and_any_other_is_refused(width, angles):
    spider = Spider(width, angles)
    points = np.random.default_rng(1).uniform(-1, 1, (2, 4000))
    if (np.minimum(spider.margin(*points), 1 - np.hypot(*points)) > 0).any():
        assert 0 < Pupil(spider=spider).area < 1


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (lambda: Spider(0.0, [0.0]), ValueError, "width must be > 0 and < 2, got 0"),
        (lambda: Spider(2.0, [0.0]), ValueError, "width must be > 0 and < 2, got 2"),
        (lambda: Spider("thin", [0.0]), TypeError, "width must be a real number, got 'thin'"),
        (lambda: Spider(0.1, []), ValueError, r"angles must be a sequence .* got \[\]"),
        (lambda: Spider(0.1, 0.5), ValueError, "angles must be a sequence of 1 to 64 numbers, got 0.5"),
        (lambda: Spider(0.1, [0.0] * 65), ValueError, r"angles must be .* shape \(65,\)"),
        (lambda: Spider(0.1, [math.nan]), ValueError, "angles must be finite, got nan"),
        (lambda: Spider(0.1, "up"), TypeError, "angles must hold real numbers, got 'up'"),
        (lambda: Spider.equal(0, 0.1), ValueError, "count must be from 1 to 64, got 0"),
        (lambda: Spider.equal(3, 0.1, math.inf), ValueError, "first must be finite, got inf"),
        (lambda: Ellipse(1.1, 0.5), ValueError, "a must be > 0 and <= 1 radii of the aperture, got 1.1"),
        (lambda: Ellipse(1.0, 0.0), ValueError, "b must be > 0 and <= 1 radii of the aperture, got 0"),
        (lambda: Ellipse(1.0, 0.5, None), TypeError, "angle must be a real number, got None"),
        (lambda: CatEye((1.5, 1.5)), ValueError, r"shift must be shorter than 1 \+ radius = 2, .* got \(1.5, 1.5\)"),
        (lambda: CatEye(0.5), TypeError, r"shift must be a pair \(x, y\), got 0.5"),
        (lambda: CatEye((0.5, math.nan)), ValueError, r"shift\[1\] must be finite, got nan"),
        (lambda: CatEye((0.5, 0.0), 0.0), ValueError, "radius must be > 0"),
        (lambda: Mask(np.zeros((4, 4))), ValueError, "values must not be 0 throughout"),
        (lambda: Mask([[0.0, math.nan], [1.0, 1.0]]), ValueError, "values must be finite and >= 0, got nan"),
        (lambda: Mask([[0.0, 1.01], [1.0, 1.0]]), ValueError, "values must be from 0 to 1, got 1.01"),
        (lambda: Mask([[0.0, -0.1], [1.0, 1.0]]), ValueError, "values must be finite and >= 0, got -0.1"),
        (lambda: Mask(np.ones((3, 4))), ValueError, r"values must be a square array .* got shape \(3, 4\)"),
        (lambda: Mask(np.ones(9)), ValueError, r"values must be a square array .* got shape \(9,\)"),
        (lambda: Mask([["a", "b"], ["c", "d"]]), TypeError, "values must hold real numbers"),
        (lambda: Mask(np.ones((2, 2), complex)), TypeError, "values must hold real numbers"),
        (lambda: Mask.sample(3, 8), TypeError, "function must be callable, got 3"),
        (lambda: Mask.sample(lambda x, y: x, 1), ValueError, "side must be from 2 to 8192, got 1"),
        (lambda: Pupil(spider=0.1), TypeError, "spider must be of the type Spider, or None, got 0.1"),
        (lambda: Pupil(vignetting=Spider(0.1, [1])), TypeError, "vignetting must be of the type Ellipse or"),
        (lambda: Pupil(mask=np.ones((4, 4))), TypeError, "mask must be of the type Mask, or None, got array"),
        (lambda: Pupil(spider=Spider.equal(2, 1.999), obscuration=0.1, vignetting=Ellipse(0.5, 0.5)), ValueError,
         "spider, vignetting must leave part of the aperture clear, got spider=.* obscuration=0.1"),
        (lambda: Pupil(obscuration=0.5, vignetting=CatEye((0.0, 0.1), 0.3)), ValueError,
         "vignetting must leave part of the aperture clear"),
        (lambda: Pupil(obscuration=0.5, mask=Mask.sample(lambda x, y: np.hypot(x, y) < 0.4, 32)), ValueError,
         "mask must leave part of the aperture clear, got mask=Mask"),
    ],
)  # fmt: skip
def test_what_is_no_aperture_is_refused_with_the_argument_and_what_is_allowed(make, error, message):
    with pytest.raises(error, match=message):
        make()


@pytest.mark.parametrize("change", [{"name": "Square"}, {"name": None}, {"b": 2.0}, {"c": 1.0}])
def test_a_damaged_description_is_refused(change):
    description = Pupil(vignetting=Ellipse(0.5, 0.5)).to_dict()
    description["vignetting"] |= change
    with pytest.raises((ValueError, TypeError), match=re.escape("vignetting") + "|b must be|'c'"):
        Pupil.from_dict(description)
