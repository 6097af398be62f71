"""What is said of a stack of planes: the numbers are those of the PSF."""

from __future__ import annotations

import json

import numpy as np
import pytest

import lommel as lm
from lommel.cli.reports import describe_stack
from lommel.lensfiles.microscope_files import Microscope
from objectives import MATCHED


def microscope(**planes) -> Microscope:
    return Microscope("oil", "", MATCHED, 610e-9, 5e-6, 6.5e-6, lm.Scalar(), shape=(5, 6), **planes)


def test_a_stack_is_described_plane_by_plane():
    taken = microscope(planes=3, step=0.3e-6)
    answer = lm.psf(taken.pupil(), taken.window, taken.pixel)
    found = describe_stack(answer, 0.5).facts["psf"]
    np.testing.assert_allclose(found["z"], [-0.3e-6, 0.0, 0.3e-6])
    np.testing.assert_array_equal(found["focus"], answer.pupil.focus)
    assert found["brightest"] == int(answer.values.max(axis=(1, 2)).argmax())
    assert found["energy"] == pytest.approx(answer.energy)
    assert found["shape"] == [3, 5, 6]
    assert json.loads(json.dumps(found, allow_nan=False)) == found


def test_one_plane_has_numbers_and_no_brightest():
    taken = microscope()
    found = describe_stack(lm.psf(taken.pupil(), taken.window, taken.pixel), 0.5).facts["psf"]
    assert (found["z"], found["brightest"]) == (0.0, None)
    assert found["energy"] == pytest.approx(float(lm.psf(taken.pupil(), taken.window, taken.pixel).energy))
