"""The rule of the disc that has the moments of an aperture, and sums with it."""

import math

import numpy as np
import pytest

import lommel as lm
from lommel.methods import nonuniform_fft
from lommel.special import zernike

TERMS = tuple(zernike.term(4 + k, "noll") for k in range(15))
FRONT = lm.Wavefront.zernike(dict(zip(TERMS, np.random.default_rng(0).normal(scale=0.2, size=15), strict=True)))
SEGMENTS = lm.Segments.hexagonal(rings=2, gap=0.01)
APERTURES = {
    "vanes": {"obscuration": 0.02, "spider": lm.Spider.equal(4, 0.03, 0.2)},
    "segments": {"stop": SEGMENTS.phased(np.linspace(-1.0, 1.0, 18), 0.7, np.linspace(-2.0, 3.0, 18))},
    "Gaussian": {"vignetting": lm.CatEye((0.3, 0.2)), "apodization": 1.0},
}


@pytest.mark.parametrize("aperture", ["vanes", "segments"])
def test_moments_are_those_of_the_aperture(aperture):
    opening = lm.Pupil(**APERTURES[aperture]).opening
    rule = nonuniform_fft.moment_rule(opening, 20, 60, 1e-12)
    at = nonuniform_fft.nodes(rule.rows)
    rho, theta = np.hypot(at.x, at.y[:, None]), np.arctan2(at.y[:, None], at.x)
    for n, m in ((0, 0), (1, -1), (7, 3), (20, -14), (20, 0), (19, 19)):
        expected = 0.0
        for region, phase in zip(opening.rows(96, 1e-13), opening.phases, strict=True):
            x, y, weight = region.nodes
            wave = np.exp(1j * (phase[0] + phase[1] * x + phase[2] * y))
            expected += (weight * wave * zernike.polynomial(n, m, np.hypot(x, y), np.arctan2(y, x))).sum()
        found = (rule.weight * zernike.polynomial(n, m, rho, theta)).sum()
        assert found == pytest.approx(expected, abs=1e-12)
    assert rule.total <= math.sqrt(float(lm.Pupil(**APERTURES[aperture]).area)) + 1e-9


@pytest.mark.parametrize(("shape", "center"), [((17, 24), (3.3, 12.0)), ((21, 21), (10.0, 10.0))])
@pytest.mark.parametrize("aperture", APERTURES)
@pytest.mark.parametrize("integrate", [False, True])
def test_sums_are_those_of_fourier_transforms(monkeypatch, aperture, shape, center, integrate):
    pupil = lm.Pupil(FRONT + lm.Wavefront(defocus=[-4.0, 0.0, 4.0]), **APERTURES[aperture])
    names = (*TERMS, (1, 1), (1, -1))
    made = []
    whole = nonuniform_fft.field_sums
    monkeypatch.setattr(nonuniform_fft, "field_sums", lambda *args: made.append(1) or whole(*args))

    def images(tol):
        asked = {"center": center, "integrate": integrate, "dtype": "float64", "tol": tol}
        return lm.psf(pupil, shape, 0.5, derivatives=names, **asked)

    found = images(1e-6)
    assert made
    monkeypatch.setattr(nonuniform_fft, "moment_rule_is_faster", lambda *args: False)
    before = len(made)
    expected = images(1e-9)
    assert len(made) == before
    peak = expected.values.max(axis=(1, 2))
    assert (np.abs(found.values - expected.values).max(axis=(1, 2)) <= (found.error_bound + 1e-9) * 2.0 * peak).all()
    for name in names:
        off = np.abs(found.derivatives[name] - expected.derivatives[name]).max(axis=(1, 2)) / peak
        assert (off <= found.derivative_bounds[name] + expected.derivative_bounds[name]).all()
        assert np.max(found.derivative_bounds[name]) < 1e-4


@pytest.mark.parametrize(
    ("stop", "count", "names", "side", "expected"),
    [
        (lm.Polygon.regular(6, radius=0.98), 27, (), 65, False),  # few nodes: Fourier transforms
        (lm.telescopes.hst(), 9, ((2, 0), (3, 1), (4, 0)), 33, True),
        (lm.telescopes.hst(), 1, (), 33, False),
        (lm.telescopes.hst(), 1, ((3, 1), (14, 0)), 33, False),
    ],
)
def test_moments_are_chosen_where_they_are_cheaper(monkeypatch, stop, count, names, side, expected):
    made = []
    whole = nonuniform_fft.field_sums
    monkeypatch.setattr(nonuniform_fft, "field_sums", lambda *args: made.append(1) or whole(*args))
    lm.psf(lm.Pupil(lm.Wavefront(defocus=np.linspace(0.0, 1.0, count)), stop=stop), side, 0.5, derivatives=names)
    assert bool(made) == expected
