"""The aperture, the wavefront across it, and the scale of the image."""

from __future__ import annotations

import copy
import json
import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import jn_zeros

import lommel as lm

wavefronts = st.builds(lm.Wavefront, st.floats(-50, 50), st.floats(-50, 50), st.lists(st.floats(-9, 9), max_size=2))
pupils = st.builds(lm.Pupil, wavefronts, obscuration=st.floats(0, 0.99))
METRIC = {"wavelength": 500e-9, "f_number": 4.0}


@pytest.mark.parametrize("options", [{}, METRIC], ids=["lambda*N", "metres"])
def test_the_airy_radius_is_that_of_the_first_dark_ring(options):
    pupil = lm.Pupil(**options)
    _, values = lm.psf(pupil, 1, 0.1 * pupil.scale, normalize="strehl").profile(
        pupil.airy_radius * np.array([0.0, 0.98, 1.0, 1.02])
    )
    assert values[0] == pytest.approx(1.0)
    assert values[2] < 1e-12 < min(values[1], values[3])
    assert pupil.airy_radius == pytest.approx(jn_zeros(1, 1)[0] / math.pi * pupil.scale)


@given(defocus=st.floats(-100, 100), eps=st.floats(0, 0.99))
def test_the_geometric_radius_of_defocus_is_four_C_d_over_pi(defocus, eps):
    pupil = lm.Pupil(lm.Wavefront(defocus), obscuration=eps)
    assert pupil.geometric_radius() == pytest.approx(4 * abs(defocus) / math.pi)


def test_the_geometric_radius_is_that_of_the_steepest_ray_wherever_it_crosses_the_pupil():
    # dPhi/drho = 4 (C_d rho + C_s rho^3): with C_d = -3, C_s = 4 it is -4 at rho = 1/2 and 4 at rho = 1;
    # with C_d = -4, C_s = 4 it is 0 at the rim and steepest at rho = 1/sqrt(3), unless that is obscured.
    wavefront = lm.Wavefront(defocus=-3.0, spherical=4.0)
    assert lm.Pupil(wavefront).geometric_radius() == pytest.approx(4 / math.pi, rel=1e-6)
    inward = lm.Wavefront(defocus=-4.0, spherical=4.0)
    assert lm.Pupil(inward).geometric_radius() == pytest.approx(16 * 2 / (3 * math.sqrt(3)) / math.pi, rel=1e-6)
    rim = 16 * 0.95 * (1 - 0.95**2) / math.pi
    assert lm.Pupil(inward, obscuration=0.95).geometric_radius() == pytest.approx(rim)


def test_the_geometric_radius_is_in_the_unit_of_the_sensor_and_one_for_each_pupil_of_a_stack():
    stack = lm.Pupil(lm.Wavefront(defocus=[[1.0], [2.0]], spherical=[0.0, 0.0, 0.0]), **METRIC)
    assert stack.geometric_radius().shape == (2, 3)
    assert stack.geometric_radius()[1, 0] == pytest.approx(8 / math.pi * 2e-6)


@given(pupils)
def test_pupils_that_say_the_same_are_equal(pupil):
    assert pupil == copy.deepcopy(pupil)
    assert pupil != lm.Pupil(pupil.wavefront + lm.Wavefront(1.0), obscuration=pupil.obscuration)
    assert pupil != lm.Pupil(pupil.wavefront, obscuration=pupil.obscuration, **METRIC)


@pytest.mark.parametrize("index", [0, -1, slice(1, None), (..., 1), [1, 0], (1, 2), None], ids=repr)
def test_a_stack_of_pupils_is_indexed_as_numpy_does_with_its_object_distances(camera, index):
    distances = np.array([[0.5, 1.0, 2.0], [3.0, 4.0, math.inf]])
    stack = camera.pupil(distances)
    assert stack[index] == camera.pupil(distances[index])


@pytest.mark.parametrize("distance", [1.5, math.inf, [0.5, math.inf]])
def test_a_pupil_survives_json_and_pickling(camera, distance):
    pupil = camera.pupil(distance)
    text = json.dumps(pupil.to_dict(), allow_nan=False)
    assert lm.Pupil.from_dict(json.loads(text)) == pupil
    assert pickle.loads(pickle.dumps(pupil)) == pupil
