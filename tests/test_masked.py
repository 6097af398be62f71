"""Masked arrays: the fit to a map takes the mask as its own, everything else refuses, for arrays lose it silently."""

from __future__ import annotations

import functools

import numpy as np
import pytest

import lommel as lm
from lommel import imaging, microscopy
from lommel.measures.errors import mse
from lommel.recorded.counts import counts_of

PUPIL = lm.Pupil(lm.Wavefront(1.0))
PSF = lm.psf(PUPIL, 5, 0.5)
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
PAIR = np.ma.masked_array([0.3, 0.4], mask=[False, True])
SQUARE = np.ma.masked_array(np.full((24, 24), 0.5), mask=np.eye(24, dtype=bool))
PLAIN = np.full((24, 24), 0.5)
STACK = np.random.default_rng(0).poisson(120, (5, 24, 24)).astype(float)
HIDDEN = np.zeros(STACK.shape, dtype=bool)
HIDDEN[2, 10, 10] = True


class Container:
    """Data with a mask beside, as of astropy.nddata and photutils, which arrays made of it do not have."""

    def __init__(self, data: np.ndarray, mask: np.ndarray) -> None:
        self.data, self.mask, self.shape, self.dtype = data, mask, data.shape, data.dtype

    def __array__(self, dtype: object = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self.data, dtype=dtype)

    def __getitem__(self, at: object) -> np.ndarray:
        return self.data[at]


KINDS = [np.ma.masked_array, Container]


@pytest.fixture
def interferogram():
    y, x = np.mgrid[-1:1:65j, -1:1:65j]
    hole = x * x + y * y < 0.1
    return np.where(hole, 1e3, 0.3 * (2 * (x * x + y * y) - 1)), hole


def test_the_fit_to_a_map_takes_its_mask(interferogram):
    values, hole = interferogram
    masked = lm.fit_opd(np.ma.masked_array(values, mask=hole), unit="waves")
    told = lm.fit_opd(values, unit="waves", mask=~hole)
    assert masked.wavefront == told.wavefront
    assert masked.samples == told.samples
    assert masked.rms < 1e-3


def test_the_mask_of_a_map_and_the_mask_beside_it_both_count(interferogram):
    values, hole = interferogram
    upper = np.arange(65)[:, None] < 50
    both = lm.fit_opd(np.ma.masked_array(values, mask=hole), unit="waves", mask=np.broadcast_to(upper, hole.shape))
    told = lm.fit_opd(values, unit="waves", mask=~hole & upper)
    assert both.wavefront == told.wavefront
    with pytest.raises(TypeError, match="mask must not be masked"):
        lm.fit_opd(values, unit="waves", mask=np.ma.masked_array(~hole, mask=hole))


@pytest.mark.parametrize("kind", KINDS)
def test_masks_of_containers_count_one_by_one_and_in_lists(kind, interferogram):
    values, hole = interferogram
    told = lm.fit_opd(np.stack([values, values.T]), unit="waves", mask=np.stack([~hole, ~hole]))
    both = kind(values, hole), kind(values.T, hole)
    assert lm.fit_opd(list(both), unit="waves").wavefront == told.wavefront
    assert lm.fit_opd(both[0], unit="waves").wavefront == lm.fit_opd(values, unit="waves", mask=~hole).wavefront
    assert np.isnan(lm.OPDMap(both[0]).values[hole]).all()


def counted(images, mask=None):
    return counts_of("images", images, sides=(2, 3), shape="(n, height, width)", mask=mask)


@pytest.mark.parametrize("kind", KINDS)
def test_masks_of_containers_leave_pixels_out_of_images(kind):
    spoilt = np.where(HIDDEN, 6e4, STACK)
    told = counted(STACK, HIDDEN)
    for given in (kind(spoilt, HIDDEN), [kind(*each) for each in zip(spoilt, HIDDEN, strict=True)]):
        found = counted(given)
        np.testing.assert_array_equal(found.hidden, HIDDEN)
        np.testing.assert_array_equal(found.filled(), told.filled())
        assert type(found.values) is np.ndarray
    # Only one of several is masked; masks that are flags of bits; none at all.
    mixed = [STACK[0], STACK[1], kind(spoilt[2], HIDDEN[2]), STACK[3], STACK[4]]
    np.testing.assert_array_equal(counted(mixed).known, ~HIDDEN)
    flags = Container(spoilt, 16 * HIDDEN.astype(np.int16))
    np.testing.assert_array_equal(counted(flags).known, ~HIDDEN)
    assert counted(kind(STACK, np.zeros(STACK.shape, dtype=bool))).known.all()


def test_a_mask_that_is_none_or_a_method_is_no_mask():
    pandas = pytest.importorskip("pandas")
    np.testing.assert_array_equal(lm.Wavefront(pandas.Series([1.0, 2.0])).defocus, [1.0, 2.0])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("stack", microscopy.estimate_noise),
        ("images", lm.recorded.open_frames),
        ("image", lambda given: traced()(given, 2.0)),
        ("distance", lambda given: traced()(np.full(STACK.shape, 0.5), given)),
        ("values", lm.Mask),
    ],
)
def test_doors_that_cannot_leave_out_what_is_masked_refuse_it(name, call, kind):
    with pytest.raises(TypeError, match=rf"^{name} must not be masked; fill the masked values"):
        call(kind(STACK, HIDDEN))


def test_masks_that_are_known_plane_by_plane_are_refused_there():
    class Lazy(Container):  # as of dask
        def __getitem__(self, at: object) -> np.ndarray:
            return np.ma.masked_array(self.data[at], HIDDEN[at])

    lazy = Lazy(STACK, None)
    with pytest.raises(TypeError, match="images must not be masked"):
        lm.recorded.open_frames(lazy)[2]
    with pytest.raises(TypeError, match="stack must not be masked"):
        microscopy.estimate_noise(lazy)


@functools.cache
def traced() -> imaging.TracedBlur:
    return imaging.traced_blur(LENS, [1.0, 3.0], 2e-5)


def test_a_masked_array_that_masks_nothing_is_an_array():
    assert lm.Wavefront(np.ma.masked_array([1.0, 2.0])) == lm.Wavefront([1.0, 2.0])


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("defocus", lambda: lm.Wavefront(PAIR)),
        ("defocus", lambda: lm.Wavefront([PAIR, PAIR])),
        ("higher", lambda: lm.Wavefront(higher=[0.0, PAIR])),
        ("nonradial", lambda: lm.Wavefront(nonradial={(2, 2): PAIR})),
        ("W020", lambda: lm.Wavefront.from_seidel(PAIR)),
        ("rms", lambda: lm.Wavefront.balanced_spherical(PAIR)),
        ("rho", lambda: lm.Wavefront().phase(PAIR)),
        ("angle", lambda: lm.Wavefront().rotated(PAIR)),
        ("radius", lambda: lm.Wavefront().scaled(PAIR)),
        ("x", lambda: PUPIL.values(PAIR, 0.0)),
        ("radius", lambda: PUPIL.v(PAIR)),
        ("values", lambda: lm.Mask(SQUARE)),
        ("function", lambda: lm.Mask.sample(lambda x, y: SQUARE, 24)),
        ("object_distance", lambda: LENS.pupil(PAIR)),
        ("object_distance", lambda: LENS.defocus(PAIR)),
        ("radius", lambda: PSF.encircled_energy(PAIR)),
        ("half_width", lambda: PSF.ensquared_energy(PAIR)),
        ("radius", lambda: PSF.profile(PAIR)),
        ("fx", lambda: PSF.otf(PAIR)),
        ("fx", lambda: lm.mtf(PUPIL, PAIR)),
        ("fy", lambda: lm.otf(PUPIL, 0.1, PAIR)),
        ("v", lambda: lm.methods.NijboerZernike().field(PUPIL, PAIR)),
        ("values", lambda: mse(SQUARE, PLAIN)),
        ("reference", lambda: lm.peak_error(PLAIN, SQUARE)),
        ("x", lambda: lm.FieldMap.scattered(PAIR, PLAIN[0, :2], lm.Wavefront([1.0, 2.0]))),
        ("image", lambda: imaging.depth_of_field(SQUARE, PLAIN, LENS, 8e-6, encoding="linear")),
        ("depth", lambda: imaging.depth_of_field(PLAIN, 4 * SQUARE, LENS, 8e-6, encoding="linear")),
        ("image", lambda: imaging.depth_of_field(SQUARE, PLAIN, LENS, 8e-6, encoding="linear", tile=16)),
        ("depth", lambda: imaging.depth_of_field(PLAIN, 4 * SQUARE, LENS, 8e-6, encoding="linear", tile=16)),
        ("depth", lambda: imaging.DepthBlur(4 * SQUARE, LENS, 8e-6)),
        ("image", lambda: imaging.DepthBlur(4 * PLAIN, LENS, 8e-6).forward(SQUARE)),
    ],
)
def test_everything_else_refuses_what_is_masked_by_name(name, call):
    with pytest.raises(TypeError, match=rf"^{name}.* must not be masked; fill the masked values"):
        call()
