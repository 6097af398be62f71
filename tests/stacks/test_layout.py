"""How stacks are cut: by their shape alone, and into runs of the flattened stack."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from lommel.io.zarr_folders import Layout
from lommel.stacks import chunk_shape

SHAPES = st.lists(st.integers(1, 9), min_size=1, max_size=4).map(tuple)


@given(SHAPES, st.integers(1, 300))
def test_chunks_cover_the_stack_once_in_order_and_none_is_too_large(shape, most):
    chunks = chunk_shape(shape, most)
    assert math.prod(chunks) <= most
    layout = Layout(shape, chunks, "<f8", ())
    members = np.arange(math.prod(shape)).reshape(shape)
    parts = [members[layout.within(index)] for index in np.ndindex(*layout.grid)]
    np.testing.assert_array_equal(np.concatenate([part.ravel() for part in parts]), members.ravel())
    for index, part in zip(np.ndindex(*layout.grid), parts, strict=True):
        assert part.shape == layout.part(index)
        assert layout.first(index) == part.flat[0]


@given(SHAPES, st.integers(1, 300))
def test_chunks_are_as_large_as_they_may_be_but_for_an_even_cut(shape, most):
    chunks = chunk_shape(shape, most)
    axis = next((k for k, c in enumerate(chunks) if c > 1), len(shape) - 1)
    # One part less along that axis would be too much.
    fewer = -(-shape[axis] // chunks[axis]) - 1
    if fewer:
        larger = -(-shape[axis] // fewer) * math.prod(chunks[axis + 1 :])
        assert larger > most


def test_what_a_chunk_leaves_out_of_its_index_is_whole():
    layout = Layout((5, 33, 32), (2, 33, 32), "<f4", ("z", "y", "x"))
    assert layout.within((2,)) == (slice(4, 5), slice(0, 33), slice(0, 32))
    assert layout.first((2,)) == 4 * 33 * 32
    assert layout.nbytes == 4 * 5 * 33 * 32
