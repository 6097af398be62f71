"""Plain quadrature, the reference of all else: its tolerance, its stacks and its limits."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from scipy import special

from lommel import Hankel, Pupil, Wavefront
from lommel.methods import hankel
from lommel.special.legendre import gauss_legendre

V = np.array([0.0, 1e-3, 0.7, 3.0, 10.0, 41.7, 160.0])


@pytest.mark.parametrize("obscuration", [0.0, 0.4, 0.97])
@pytest.mark.parametrize(("defocus", "spherical", "higher"), [(0, 0, ()), (-9, 12, ()), (3, 1, (-5, 2, 1, -1))])
def test_it_is_the_diffraction_integral(
    defocus: float, spherical: float, higher: tuple[float, ...], obscuration: float
) -> None:
    """Against adaptive quadrature over rho, where Hankel uses nodes in rho^2."""
    pupil = Pupil(Wavefront(defocus, spherical, higher), obscuration=obscuration)
    powers = [2 * defocus, spherical, *higher]

    def integral(v: float) -> complex:
        def integrand(rho: mp.mpf) -> mp.mpc:
            phase = sum(c * rho ** (2 * k + 2) for k, c in enumerate(powers))
            return 2 * rho * mp.expj(phase) * mp.j0(v * rho)

        panels = 2 + int((v + 40) * (1 - obscuration) / 12)
        return complex(mp.quad(integrand, mp.linspace(obscuration, 1, panels + 1)))

    at = V[:5]
    assert Hankel().field(pupil, at) == pytest.approx(np.array([integral(v) for v in at]), abs=2e-15, rel=0)


@pytest.mark.parametrize("obscuration", [0.0, 0.33, 0.9])
@pytest.mark.parametrize("wavefront", [Wavefront(), Wavefront(200.0), Wavefront(-150, 170), Wavefront(5, -20, [30])])
def test_the_error_falls_with_the_tolerance_and_stays_below_it(wavefront: Wavefront, obscuration: float) -> None:
    pupil = Pupil(wavefront, obscuration=obscuration)
    exact = Hankel(tol=1e-15).field(pupil, V)
    for tol in 10.0 ** -np.arange(2.25, 14.1, 0.5):
        values, bound = Hankel(tol=tol).evaluate(pupil, V)
        assert bound is not None
        assert np.abs(values[0] - exact).max() <= bound[0]
        # What is left is the estimate of the rounding.
        assert bound[0] <= tol * pupil.area + 1e-15 * (np.abs(pupil.coefficients()).sum() + 20)


@pytest.mark.parametrize("block", [1, 1000, 4096])
def test_the_size_of_the_blocks_does_not_matter(block: int, monkeypatch: pytest.MonkeyPatch) -> None:
    pupil, v = Pupil(Wavefront(30.0, -7.0)), np.linspace(0.0, 90.0, 301)
    whole = Hankel().field(pupil, v)
    monkeypatch.setattr(hankel, "_BLOCK", block)
    assert np.abs(Hankel().field(pupil, v) - whole).max() <= 1e-15


def test_its_intensity_error_bound_is_relative_to_the_largest_value() -> None:
    pupil = Pupil(Wavefront(20.0))
    intensity, bound = Hankel(tol=1e-5).profile(pupil, V)[:2]
    exact = Hankel().profile(pupil, V).values
    assert bound is not None
    assert np.abs(intensity - exact).max() <= bound[0] * exact.max()
    assert bound[0] <= 2.1e-5 / math.sqrt(exact.max())


def test_as_few_nodes_as_it_takes_reach_the_answer_at_great_phases() -> None:
    """At 5000 rad, a rule with three times the nodes finds the same."""
    pupil, v = Pupil(Wavefront(5000.0)), np.array([0.0, 10.0, 1000.0])
    t, w = gauss_legendre(12_000)
    direct = [np.sum(w * np.exp(1e4j * t) * special.j0(at * np.sqrt(t))) for at in v]
    assert np.abs(Hankel().field(pupil, v) - direct).max() <= 1e-13
