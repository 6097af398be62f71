"""The best focus, against defocus that is known and the balance of Zernike."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel import LommelSeries, NijboerZernike, Pupil, Wavefront
from lommel.measures.energy import radial_energy


@pytest.mark.parametrize("obscuration", [0.0, 0.5])
@pytest.mark.parametrize("radius", [0.5, 1.2, 3.0])
@pytest.mark.parametrize("defocus", [0.0, 0.3, -4.0, 31.7])
def test_the_best_focus_of_a_defocused_lens_takes_the_defocus_away(
    defocus: float, radius: float, obscuration: float
) -> None:
    found = lm.best_focus(Pupil(Wavefront(defocus), obscuration=obscuration), radius)
    assert found == pytest.approx(-defocus, abs=2e-6)


@pytest.mark.parametrize("rms", [0.3, -0.3])
def test_the_best_focus_of_little_spherical_aberration_balances_it(rms: float) -> None:
    """For small aberrations and a small spot, least variance is most light: the Zernike balance."""
    balanced = Wavefront.balanced_spherical(rms)
    found = lm.best_focus(Pupil(Wavefront(0.0, balanced.spherical)), 0.05, method=NijboerZernike(1e-10))
    assert found == pytest.approx(float(balanced.defocus), rel=0.01)


def test_no_other_focus_puts_more_light_into_the_circle() -> None:
    pupil, radius = Pupil(Wavefront(4.0, 25.0), obscuration=0.2), 1.5
    found = lm.best_focus(pupil, radius)
    best = float(radial_energy(NijboerZernike(), Pupil(Wavefront(4.0 + found, 25.0), obscuration=0.2), radius))
    others = Pupil(Wavefront(4.0 + np.linspace(-45, 20, 400), 25.0), obscuration=0.2)
    assert np.all(radial_energy(NijboerZernike(), others, radius) <= best + 1e-6)


def test_the_best_focus_is_found_with_the_method_that_is_given() -> None:
    pupil = Pupil(Wavefront(5.0))
    assert lm.best_focus(pupil, 1.0, method=LommelSeries()) == pytest.approx(-5.0, abs=2e-6)
    with pytest.raises(ValueError, match="LommelSeries supports defocus only"):
        lm.best_focus(Pupil(Wavefront(0.0, 1.0)), 1.0, method=LommelSeries())
    with pytest.raises(ValueError, match="a single one, got a stack of shape"):
        lm.best_focus(Pupil(Wavefront([1.0, 2.0])), 1.0)
    with pytest.raises(ValueError, match="radius must be > 0"):
        lm.best_focus(pupil, 0.0)


def test_other_apertures_have_no_best_focus_in_a_circle():
    with pytest.raises(ValueError, match="pupil must be radially symmetric for its best focus"):
        lm.best_focus(lm.Pupil(stop=lm.Polygon.regular(6, 1.0)), 1.0)
