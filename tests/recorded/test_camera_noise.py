"""The noise of a camera from a stack: how many voxels are looked at."""

import numpy as np

import lommel as lm
from lommel.recorded import camera_noise


def test_of_a_large_stack_fewer_points_do(monkeypatch):
    rng = np.random.default_rng(3)
    light = 50.0 + 950.0 * rng.random((8, 1, 1)) * np.linspace(0.1, 1.0, 90) * np.ones((90, 1))
    stack = lm.Noise(white=0.5, read=1.6, offset=100.0).record(light, seed=4)
    whole, error = camera_noise.measured_noise(stack)
    monkeypatch.setattr(camera_noise, "_POINTS", 9000)
    fewer, larger = camera_noise.measured_noise(stack)
    assert 1.5 * error < larger < 4.0 * error
    assert abs(float(fewer.white) - float(whole.white)) < 3.0 * larger * float(whole.white)
