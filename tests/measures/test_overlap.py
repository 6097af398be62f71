"""The autocorrelation of the pupil: for defocus alone, lines are integrated in closed form."""

import numpy as np
import pytest

import lommel as lm
from lommel.measures import overlap

F = np.stack([np.linspace(0.003, 0.99, 40), np.zeros(40)], axis=-1)


@pytest.mark.parametrize("obscuration", [0.0, 0.35])
def test_the_closed_form_for_defocus_is_the_quadrature_of_the_phase(obscuration):
    defocus = np.array([0.3, 12.0, 70.0])
    alone = lm.Pupil(lm.Wavefront(defocus=defocus), obscuration=obscuration)
    # A spherical aberration of 1e-14 rad takes the general way and changes nothing else.
    general = lm.Pupil(lm.Wavefront(defocus=defocus, spherical=1e-14), obscuration=obscuration)
    found, expected = (overlap.autocorrelation(pupil, F, 1e-11) for pupil in (alone, general))
    np.testing.assert_allclose(found, expected, rtol=0, atol=2e-11)
    assert np.ptp(found.real) > 0.1


def test_defocus_alone_takes_no_quadrature_along_lines(monkeypatch):
    pupil = lm.Pupil(lm.Wavefront(defocus=180.0))
    monkeypatch.setattr(overlap, "_radial_product", None)
    assert overlap.autocorrelation(pupil, F, 1e-11).shape == (1, 40)
