"""Counts: an array with noise, mask and saturation, read on demand."""

import gc
import weakref

import numpy as np
import pytest

import lommel as lm
from lommel.recorded.counts import OnDemand, counts_of

NOISE = lm.Noise(white=0.5, read=2.0, offset=100.0)
PLANES = np.random.default_rng(3).poisson(200.0, (5, 6, 7)).astype(np.uint16)
PLANES[1, 2:4, 3:5] = 4095


class Reader(OnDemand):
    """A stack that lists what is read of it."""

    shape, dtype, ndim = PLANES.shape, PLANES.dtype, 3

    def __init__(self):
        self.read = []

    def __getitem__(self, index):
        self.read.append(index)
        return PLANES[index]


def two_columns():
    mask = np.zeros(PLANES.shape[1:], bool)
    mask[:, 2:4] = True
    return mask


def test_counts_have_the_noise_masks_and_saturation_of_an_array():
    counts = lm.Counts.of(PLANES, noise=NOISE, mask=two_columns(), saturation=300)
    assert counts.noise is NOISE
    assert counts.saturation == 300.0
    assert counts.shape == PLANES.shape
    assert len(counts) == 5
    np.testing.assert_array_equal(counts.hidden, np.broadcast_to(two_columns(), PLANES.shape))
    np.testing.assert_array_equal(counts.full, (PLANES >= 300) & ~two_columns())
    np.testing.assert_array_equal(np.isnan(counts.marked()), ~counts.known)


def test_images_of_counts_have_the_saturation_of_all():
    counts = lm.Counts.of(PLANES, noise=NOISE)
    assert counts.saturation == 4095.0
    assert counts[0].saturation == 4095.0
    assert counts[0].assumed == counts.assumed != ""
    np.testing.assert_array_equal(counts[1:].full, PLANES[1:] == 4095)


def test_a_stack_that_is_read_on_demand_is_read_image_by_image():
    reader = Reader()
    counts = lm.Counts.of(reader, noise=NOISE, mask=two_columns(), saturation=4095)
    assert reader.read == []
    assert counts[1].full.sum() == 2
    np.testing.assert_array_equal(counts[1].hidden, two_columns())
    assert reader.read == [1, 1]


def test_a_stack_that_is_read_on_demand_has_the_counts_of_its_array():
    counts, array = lm.Counts.of(Reader(), noise=NOISE), lm.Counts.of(PLANES, noise=NOISE)
    assert (counts.saturation, counts.assumed) == (array.saturation, array.assumed)
    assert all(index in [(k,) for k in range(5)] for index in counts.values.read)  # never as a whole
    np.testing.assert_array_equal(counts.full, array.full)


def test_chunks_of_dask_are_not_computed_before_they_are_needed():
    dask = pytest.importorskip("dask.array")
    computed = []
    stack = dask.from_array(PLANES, chunks=(1, 6, 7)).map_blocks(lambda part: computed.append(1) or part, dtype="u2")
    computed.clear()
    counts = lm.Counts.of(stack, noise=NOISE, saturation=4095)
    assert not computed
    np.testing.assert_array_equal(counts[1].values, PLANES[1])
    assert len(computed) == 1


def test_images_leave_memory_with_their_counts():
    gc.disable()  # garbage of some bytes is collected rarely, whatever arrays it refers to
    try:
        counts = lm.Counts.of(PLANES, noise=NOISE)
        part = counts[1:3]
        assert part.saturation == counts.saturation == 4095
        gone = weakref.ref(counts), weakref.ref(part)
        del counts
        assert part.full.sum() == 4
        del part
        assert [each() for each in gone] == [None, None]
    finally:
        gc.enable()


def test_counts_carry_noise_mask_and_saturation_alone():
    counts = lm.Counts.of(PLANES, noise=NOISE)
    assert counts_of("images", counts, sides=(3,), shape="(n, height, width)") is counts
    for name, value in (("noise", NOISE), ("mask", two_columns()), ("saturation", 300)):
        with pytest.raises(TypeError, match=f"{name} must be omitted if images are Counts"):
            counts_of("images", counts, **{name: value}, sides=(3,), shape="(n, height, width)")
    with pytest.raises(ValueError, match=r"images must have the shape \(height, width\), got \(5, 6, 7\)"):
        counts_of("images", counts, sides=(2,), shape="(height, width)")


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({"array": PLANES, "noise": None}, TypeError, "noise must be a Noise, got None"),
        ({"array": lm.Counts.of(PLANES, noise=NOISE)}, TypeError, "array must be an array without noise, got Counts"),
        ({"array": [1.0, 2.0]}, ValueError, r"array must have the shape \(..., height, width\), got \(2,\)"),
        ({"array": "stack.tif"}, TypeError, "array must hold real numbers, got 'stack.tif'"),
        ({"mask": two_columns()[1:]}, ValueError, "mask must be True or False for each pixel of array"),
        ({"mask": two_columns().astype(int)}, ValueError, "mask must be True or False for each pixel of array"),
        ({"saturation": np.nan}, ValueError, "saturation must be"),
        (
            {"noise": lm.Noise(read=np.ones((2, 2)))},
            ValueError,
            r"read, of shape \(2, 2\), must have a value for each",
        ),
    ],
)
def test_arguments_of_counts_are_checked(given, error, message):
    with pytest.raises(error, match=message):
        lm.Counts.of(**{"array": PLANES, "noise": NOISE, **given})
