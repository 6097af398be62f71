"""Images by quadrature over transfer functions: within their bound of plain quadrature, chosen where cheap."""

from __future__ import annotations

import itertools
import math
from functools import lru_cache

import numpy as np
import pytest
from mpmath import mp
from scipy.special import j0

import lommel as lm
from lommel.blur import recorded
from lommel.blur.blurs import KOLMOGOROV
from lommel.blur.transfer_integral import TransferIntegral

BLURS = {
    "50": (lm.Seeing(0.02),),
    "12": (lm.Seeing(1.0 / 12.0),),
    "4": (lm.Seeing(0.25),),
    "1": (lm.Seeing(1.0),),
    "outer scale": (lm.Seeing(0.1, outer_scale=2.0),),
    "shaken": (lm.Seeing(0.2, outer_scale=40.0), lm.Jitter(1.5), lm.Jitter(0.4)),
    "jitter": (lm.Jitter(3.0),),
}
PUPILS = {
    "focus": lm.Pupil(),
    "defocus": lm.Pupil(lm.Wavefront(3.0, -1.0)),
    "annulus": lm.Pupil(lm.Wavefront(1.0), obscuration=0.3),
    "apodized": lm.Pupil(lm.Wavefront(0.5), apodization=1.2),
}


@lru_cache(maxsize=64)
def spectrum(name: str, blur: str) -> tuple[np.ndarray, np.ndarray]:
    """Return frequencies in cycles per lambda*N and weights of ``2 pi OTF T f df``, over the unaberrated peak."""
    pupil = PUPILS[name]
    x, w = np.polynomial.legendre.leggauss(40)
    eps = pupil.obscuration
    kinks = np.unique([0.0, 0.5 * (1.0 - eps), eps, 0.5 * (1.0 + eps), 1.0])
    edges = np.unique(np.concatenate([np.linspace(0.0, 1.0, 13) ** 3, kinks, 1.0 - 0.5 ** np.arange(2.0, 30.0)]))
    edges = np.cbrt(edges)
    u = np.concatenate([a + (b - a) * 0.5 * (x + 1.0) for a, b in itertools.pairwise(edges)])
    weight = np.concatenate([0.5 * (b - a) * w for a, b in itertools.pairwise(edges)])
    f = u**3
    weight = weight * 3.0 * u * u * 2.0 * math.pi * f * math.prod(one.transfer(f) for one in BLURS[blur])
    kept = np.abs(weight) > 1e-18
    weight[kept] *= np.real(lm.otf(pupil, f[kept], tol=1e-13))
    peak = math.pi / 4.0 * pupil.amplitude**2 / pupil.transmission
    return f[kept], weight[kept] / peak


def exact(name: str, blur: str, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    f, weight = spectrum(name, blur)
    return j0(2.0 * math.pi * np.multiply.outer(np.hypot(x, y), f)) @ weight


def image(name: str, blur: str, tol: float, **options) -> lm.PSF:
    options = {"shape": 9, "pixel": 1.3, "normalize": "strehl", "dtype": "float64"} | options
    answer = lm.psf(PUPILS[name], blur=BLURS[blur], tol=tol, **options)
    assert answer.error_bound <= tol
    return answer


@pytest.fixture
def only_quadrature(monkeypatch):
    """Take the quadrature whatever it costs, and no lattice in its place."""
    monkeypatch.setattr(recorded, "_lattice_seconds", lambda *_: math.inf)
    monkeypatch.setattr(recorded, "summed", None)


# Behind an obscuration weak seeing has no proven rule.
CASES = [(name, blur) for name in PUPILS for blur in BLURS if name != "annulus" or blur in ("50", "12")]


@pytest.mark.usefixtures("only_quadrature")
@pytest.mark.parametrize("tol", [10.0**-k for k in range(3, 11)])
@pytest.mark.parametrize(
    ("name", "blur"), [("focus", "50"), ("focus", "1"), ("annulus", "12"), ("defocus", "outer scale")]
)
def test_every_tolerance_is_kept(name, blur, tol):
    answer = image(name, blur, tol)
    off = np.abs(answer.values - exact(name, blur, answer.grid.x, answer.grid.y[:, None])).max() / answer.values.max()
    assert off <= answer.error_bound


@pytest.mark.usefixtures("only_quadrature")
@pytest.mark.parametrize("tol", [1e-4, 1e-8])
@pytest.mark.parametrize(("name", "blur"), CASES)
def test_every_pupil_and_blur_is_within_its_bound(name, blur, tol):
    answer = image(name, blur, tol, center=(3.3, 5.1))
    off = np.abs(answer.values - exact(name, blur, answer.grid.x, answer.grid.y[:, None])).max() / answer.values.max()
    assert off <= answer.error_bound


@pytest.mark.usefixtures("only_quadrature")
@pytest.mark.parametrize("normalize", ["strehl", "peak"])
@pytest.mark.parametrize(("name", "blur"), [("focus", "12"), ("defocus", "shaken"), ("annulus", "50")])
def test_pixels_average_and_may_lie_beside_the_axis(name, blur, normalize):
    x, w = np.polynomial.legendre.leggauss(12)
    for tol, center in itertools.product((1e-5, 1e-9), (None, (2.2, -7.0))):
        answer = image(name, blur, tol, shape=(5, 4), integrate=True, center=center, normalize=normalize)
        columns = np.add.outer(answer.grid.x, 0.65 * x)
        rows = np.add.outer(answer.grid.y, 0.65 * x)
        found = exact(name, blur, columns[None, :, None, :], rows[:, None, :, None])
        mean = np.einsum("yxab,a,b->yx", found, 0.5 * w, 0.5 * w)
        peak = float(exact(name, blur, np.zeros(1), np.zeros(1))[0]) if normalize == "strehl" else 1.0
        if normalize == "peak":
            mean /= mean.max()
        assert np.abs(answer.values - mean).max() <= answer.error_bound * peak


@pytest.mark.usefixtures("only_quadrature")
def test_a_star_of_eight_metres_is_that_of_mpmath():
    answer = image("focus", "50", 1e-9, shape=3, pixel=0.1 * math.pi / 648000.0 / (600e-9 / 8.0))
    mp.dps = 20
    a, r = mp.mpf(KOLMOGOROV) * mp.mpf(50) ** (mp.mpf(5) / 3), mp.mpf(answer.grid.x[2])

    def wave(u):
        f = u**3
        otf = 2 / mp.pi * (mp.acos(f) - f * mp.sqrt(1 - f * f))
        return 3 * u**5 * otf * mp.exp(-a * u**5) * mp.besselj(0, 2 * mp.pi * r * f)

    expected = float(8 * mp.quad(wave, mp.linspace(0, mp.cbrt(0.09), 5)))
    assert abs(answer.values[1, 2] - expected) <= answer.error_bound * answer.values.max()


@pytest.mark.usefixtures("only_quadrature")
def test_stacks_axes_and_white_light_are_sums_of_single_images():
    pupil = lm.Pupil(lm.Wavefront(np.array([0.0, 2.0, 5.0])), wavelength=600e-9, f_number=10.0, obscuration=0.2)
    air = lm.Seeing(0.02, focal_length=4.0, wavelength=500e-9, outer_scale=25.0)
    rows = np.array([4.0, 4.5, 6.0])
    white = lm.methods.Polychromatic([450e-9, 550e-9, 700e-9], [1.0, 2.0, 1.0])
    together = lm.psf(pupil, 9, 9e-6, blur=air, center=(rows, 4.0), dtype="float64", method=white)
    assert together.method == white
    for k, row in enumerate(rows):
        light = 0.0
        for part, share in zip(white.components(pupil[k]), white.weights, strict=True):
            one = lm.psf(part.pupil, 9, 9e-6, blur=air, center=(row, 4.0), dtype="float64", tol=1e-9)
            light = light + share * one.values
        assert np.abs(together.values[k] - light).max() <= 1.01 * together.error_bound * light.max()


def test_a_lattice_takes_over_where_it_is_cheaper_or_nothing_else_is_proven():
    def asked(pupil: lm.Pupil, blur: lm.Seeing | lm.Jitter, pixel: float | tuple[float, float] = 0.5) -> bool:
        seen = []
        original = recorded.summed
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(recorded, "summed", lambda *args: seen.append(1) or original(*args))
            lm.psf(pupil, 9, pixel, blur=blur, tol=1e-4)
        return not seen

    assert asked(lm.Pupil(), lm.Seeing(0.1))
    assert asked(lm.Pupil(lm.Wavefront(np.linspace(0.0, 5.0, 9))), lm.Seeing(0.1))
    assert not asked(lm.Pupil(lm.Wavefront(60.0)), lm.Jitter(0.2))
    assert not asked(lm.Pupil(obscuration=0.6), lm.Seeing(1.0))
    assert not asked(lm.Pupil(), lm.Motion(0.5))
    assert not asked(lm.Pupil(), lm.Seeing(1.0), (0.5, 0.6))


def test_an_accuracy_beyond_double_precision_is_refused():
    with pytest.raises(lm.ToleranceError, match="cannot be met"):
        TransferIntegral(1e-12, (lm.Seeing(0.1),)).profile(lm.Pupil(lm.Wavefront(30.0)), np.linspace(0.0, 9.0, 3))
