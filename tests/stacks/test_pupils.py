"""Stacks of pupils as arrays: taken apart and put together, they are the same bit by bit."""

from __future__ import annotations

import json

import numpy as np
import pytest

import lommel as lm
from lommel.stacks import join_pupils, split_pupils
from objectives import OIL

LENS = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
FIELD = lm.FieldMap.from_seidel(20e-3, W131=2.0, W222=1.0, W220=0.3, wavelength=550e-9, f_number=2.8)
COMA = lm.Wavefront(nonradial={(3, 1): np.array([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])})
STACKS = {
    "one": LENS.pupil(1.5),
    "distances": LENS.pupil(np.array([1.0, 2.0, 3.7, np.inf])),
    "field": FIELD.pupil(np.array([0.0, 3e-3, 1e-2]), np.array([[0.0], [7e-3]])),
    "terms": lm.Pupil(lm.Wavefront.zernike({4: [0.1, 0.2], 8: [0.0, 0.3]}, order="noll"), obscuration=0.3),
    "higher": lm.Pupil(lm.Wavefront([1.0, 2.0], 0.3, higher=(0.1, [0.2, 0.3]), error=1e-9)),
    "vanes": lm.Pupil(lm.Wavefront([[1.0, 2.0]]), spider=lm.Spider(0.02, [0.0, 1.0]), apodization=0.5),
    "planes": OIL.pupil(depth=np.array([[1e-6], [2e-6]]), z=np.array([0.0, 2e-7, 4e-7]), wavelength=525e-9),
    "measured": OIL.pupil(depth=1e-6, z=[0.0, 1e-7], wavelength=525e-9, aberrations=lm.Wavefront(0.5)),
    "measured each": OIL.pupil(depth=[[1e-6], [2e-6]], z=np.zeros(3), wavelength=525e-9, aberrations=COMA),
}


@pytest.mark.parametrize("name", STACKS)
def test_what_is_taken_apart_comes_back_bit_by_bit_and_so_does_part_of_it(name):
    pupil = STACKS[name]
    shared, arrays = split_pupils(pupil)
    shared = json.loads(json.dumps(shared, allow_nan=False))
    assert all(at.shape[: len(pupil.shape)] == pupil.shape for at in arrays.values())
    back = join_pupils(shared, arrays)
    assert back == pupil
    assert type(back) is type(pupil)
    front, known = (getattr(one, "wavefront", None) or getattr(one, "aberrations", None) for one in (back, pupil))
    assert front is known is None or front.edge.tobytes() == known.edge.tobytes()
    if pupil.shape:
        index = (-1,) * len(pupil.shape)
        assert join_pupils(shared, {part: at[index] for part, at in arrays.items()}) == pupil[index]


def test_what_stacks_share_does_not_depend_on_how_many_there_are():
    said, _ = split_pupils(STACKS["distances"])
    more, _ = split_pupils(LENS.pupil(np.linspace(0.7, 5.0, 999)))
    assert said == more
