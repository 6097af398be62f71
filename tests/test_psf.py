"""The front door and its answer."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.special import j1

import lommel as lm
from lommel.methods import METHODS, ChordalGauss, Hankel, NijboerZernike, NonuniformFFT, RadialMethod
from lommel.paper import TunedClosedForm

METHOD = pytest.mark.parametrize("method", [kind() for kind in METHODS.values()], ids=list(METHODS))
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=500e-9)
STACK = LENS.focused(20.0).pupil([[15.0, 20.0, 25.0], [30.0, 90.0, math.inf]])

coefficients = st.floats(-30, 30)
pupils = st.builds(
    lm.Pupil,
    st.builds(lm.Wavefront, coefficients, coefficients, st.lists(st.floats(-5, 5), max_size=2)),
    obscuration=st.floats(0, 0.9),
)
shapes = st.tuples(st.integers(1, 24), st.integers(1, 24))
fine_pixels = st.floats(0.05, 1.0)


@given(pupils, shapes, fine_pixels)
@example(lm.Pupil(obscuration=5e-324), (1, 2), 0.25)
def test_an_image_is_symmetric_and_not_negative_and_holds_at_most_all_light(pupil, shape, pixel):
    image = lm.psf(pupil, shape, pixel, dtype="float64")
    row, column = shape[0] // 2, shape[1] // 2
    values = image.values
    assert values.shape == shape
    assert values.min() >= 0.0
    # Samples a Nyquist interval or less apart sum to the integral, so no aliasing adds to the light.
    assert values.sum() <= 1.0 + values.size * image.error_bound * values.max()
    # The centre of an even side has one pixel more on its left.
    inner = values[1 - shape[0] % 2 :, 1 - shape[1] % 2 :]
    np.testing.assert_array_equal(inner, inner[::-1])
    np.testing.assert_array_equal(inner, inner[:, ::-1])
    turned = lm.psf(pupil, shape[::-1], pixel, dtype="float64").values
    np.testing.assert_allclose(values.T, turned, rtol=0, atol=2 * image.error_bound * values.max())
    assert values[row, column] == pytest.approx(image.strehl * image.scale * pupil.area**2)


@pytest.mark.parametrize("pixel", [0.63, 0.9, (1.0, 0.3), 1.25, (0.3, 1.3)])
def test_samples_up_to_the_wavelength_times_the_f_number_apart_sum_to_the_light(pixel):
    pupil = lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 1.0}))
    sampled, averaged = (
        lm.psf(pupil, 401, pixel, integrate=integrate, tol=1e-8, dtype=np.str_("float64"))
        for integrate in (False, True)
    )
    assert averaged.sum_is_light
    assert sampled.sum_is_light == (np.max(pixel) <= 1.0)
    assert ("which sum to" in repr(sampled)) == (not sampled.sum_is_light)
    stray = abs(sampled.values.sum() - averaged.values.sum())
    assert stray < 1e-4 if sampled.sum_is_light else stray > 3e-3


@METHOD
def test_a_stack_holds_what_its_pupils_give_one_by_one(method):
    images = lm.psf(STACK, (5, 6), 1e-6, method=method, dtype="float64")
    assert images.shape == (2, 3, 5, 6)
    for index in np.ndindex(STACK.shape):
        single = lm.psf(STACK[index], (5, 6), 1e-6, method=method, dtype="float64")
        within = 1e-12 if single.error_bound is None else images.error_bound + single.error_bound
        np.testing.assert_allclose(images.values[index], single.values, rtol=0, atol=within * single.values.max())
        assert images.energy[index] == pytest.approx(single.energy, rel=1e-5)
        assert images.strehl[index] == pytest.approx(single.strehl, rel=1e-5)


@pytest.fixture(scope="module")
def images():
    return lm.psf(STACK, 5, 1e-6, normalize="peak")


@pytest.fixture(scope="module")
def encircled(images):
    return images.encircled_energy(2e-6)


@pytest.mark.parametrize(
    "index",
    [0, -1, (1, 2), slice(1, None), (..., 0), [1, 0], np.array([True, False]), None, (0, slice(0, 2))],
    ids=repr,
)
def test_a_stack_is_indexed_as_numpy_does(index, images, encircled):
    part = images[index]
    which = np.arange(6).reshape(2, 3)[index]
    np.testing.assert_array_equal(part.values, images.values.reshape(6, 5, 5)[which])
    np.testing.assert_array_equal(part.profile()[1], images.profile()[1].reshape(6, 3)[which])
    assert part.pupil == STACK[index]
    np.testing.assert_allclose(part.strehl, images.strehl[index])
    np.testing.assert_allclose(part.energy, images.energy[index], rtol=1e-5)
    np.testing.assert_allclose(part.encircled_energy(2e-6), encircled[index], rtol=1e-5)


def test_a_stack_is_as_long_as_its_first_axis_and_a_single_image_has_no_length():
    stack = lm.psf(lm.Pupil(lm.Wavefront(np.zeros((2, 3)))), 3, 0.5)
    assert (len(stack), len(stack[0])) == (2, 3)
    with pytest.raises(TypeError, match="a single PSF has no length"):
        len(stack[0, 0])
    with pytest.raises(TypeError, match="single"):
        stack[0, 0][0]
    assert stack[0, 0]


@METHOD
def test_a_bound_on_the_error_is_claimed_by_the_certified_methods_only(method):
    bound = lm.psf(LENS.pupil(1.9), 5, 1e-6, method=method).error_bound
    if isinstance(method, NijboerZernike | Hankel | TunedClosedForm | ChordalGauss | NonuniformFFT):
        assert 0 < bound <= max(method.tol, 1e-11) + 2**-24
    else:
        assert bound is None


@pytest.mark.parametrize("dtype", ["float32", "float64"])
@pytest.mark.parametrize("tol", [1e-2, 1e-4, 1e-6])
def test_the_error_bound_holds_and_is_within_the_tolerance(tol, dtype):
    pupil = lm.Pupil(lm.Wavefront(defocus=20.0, spherical=-7.0), obscuration=0.3)
    image = lm.psf(pupil, 32, 0.5, method=NijboerZernike(tol=tol), dtype=dtype)
    truth = lm.psf(pupil, 32, 0.5, method="hankel")
    assert lm.peak_error(image, truth) <= image.error_bound + truth.error_bound
    assert image.error_bound <= tol + 2**-24


def test_the_profile_is_the_row_to_the_right_of_the_centre_unless_radii_are_given():
    image = lm.psf(lm.Pupil(lm.Wavefront(defocus=5.0)), (8, 9), 0.5)
    radius, values = image.profile()
    assert radius.tolist() == [0.0, 0.5, 1.0, 1.5, 2.0]
    np.testing.assert_array_equal(values, image.values[4, 4:])
    np.testing.assert_allclose(image.profile(radius)[1], values, rtol=0, atol=2e-6 * values.max())


def test_a_profile_at_any_radii_is_normalised_like_the_values():
    images = lm.psf(lm.Pupil(lm.Wavefront(defocus=[[0.0], [2.0]])), 5, 0.5, normalize="strehl")
    radius, values = images.profile([[0.0, 0.1, 0.2], [0.3, 50.0, 0.0]])
    assert radius.shape == (2, 3)
    assert values.shape == (2, 1, 2, 3)
    airy = 2 * j1(math.pi * 0.3) / (math.pi * 0.3)
    assert values[0, 0, 1, 0] == pytest.approx(airy**2, rel=1e-5)
    assert values[1, 0, 0, 0] == values[1, 0, 1, 2] == pytest.approx((math.sin(2) / 2) ** 2, rel=1e-5)


@METHOD
def test_the_values_between_the_pixels_are_known_to_radial_methods_only(method):
    sampled = None if method.sampling == "pixel" else False
    image = lm.psf(LENS.pupil(2.0), 5, 1e-6, method=method, integrate=sampled)
    if isinstance(method, RadialMethod):
        assert image.profile(0.0)[1] == pytest.approx(image.values[2, 2], rel=1e-5)
    else:
        with pytest.raises(ValueError, match=f"radius must be None for {type(method).__name__}"):
            image.profile(0.0)


def test_numpy_sees_the_values_without_a_copy_unless_one_is_needed():
    image = lm.psf(lm.Pupil(), 4, 0.5)
    assert np.shares_memory(np.asarray(image), image.values)
    assert np.shares_memory(np.array(image, copy=False), image.values)
    assert not np.shares_memory(np.array(image), image.values)
    assert np.asarray(image, dtype=np.float64).dtype == np.float64
    with pytest.raises(ValueError, match="copy"):
        np.array(image, dtype=np.float64, copy=False)
    assert np.max(image) == image.values.max()


def test_a_plan_that_another_thread_uses_meanwhile_computes_each_pupil_by_its_own_light():
    clear, ring = lm.Pupil(), lm.Pupil(obscuration=0.5)

    class Shared(lm.Plan):
        kept = None

        @property
        def _prepared(self):
            return self.kept

        @_prepared.setter
        def _prepared(self, prepared):
            self.kept = prepared
            if prepared is not None and prepared.light[0] == clear.aperture:
                self.prepared(ring)  # as another thread does, right after this one

    plan = Shared(9, 0.5)
    assert plan.prepared(clear).light[0] == clear.aperture
    assert plan(clear).values == pytest.approx(lm.psf(clear, 9, 0.5).values, abs=1e-6)
