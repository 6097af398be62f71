"""Notes: warnings at the line of the caller, however deep in the package they arise."""

from __future__ import annotations

import warnings

import numpy as np

import lommel as lm


def test_a_note_names_the_line_of_the_caller():
    lens = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    plan = lm.imaging.depth_of_field
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        plan(np.full((20, 30), 0.5), np.full((20, 30), 2500.0), lens, 20e-6, encoding="linear")
        lm.imaging.DepthBlur(np.full((20, 30), 2500.0), lens, 20e-6)
    assert [each.filename for each in told] == 2 * [__file__]
    assert told[1].lineno == told[0].lineno + 1
