"""The rule of the disc that has the moments of an aperture, and sums with it."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import lommel as lm
from lommel.core import engine
from lommel.core.answers import Wanted
from lommel.core.engine import Window
from lommel.methods import nonuniform_fft
from lommel.methods.nijboer_zernike import disk_stack
from lommel.optics.grid import Grid
from lommel.special import zernike

TERMS = tuple(zernike.term(4 + k, "noll") for k in range(15))
FRONT = lm.Wavefront.zernike(dict(zip(TERMS, np.random.default_rng(0).normal(scale=0.2, size=15), strict=True)))
SEGMENTS = lm.Segments.hexagonal(rings=2, gap=0.01)
APERTURES = {
    "vanes": {"obscuration": 0.02, "spider": lm.Spider.equal(4, 0.03, 0.2)},
    "segments": {"stop": SEGMENTS.phased(np.linspace(-1.0, 1.0, 18), 0.7, np.linspace(-2.0, 3.0, 18))},
    "Gaussian": {"vignetting": lm.CatEye((0.3, 0.2)), "apodization": 1.0},
}


@pytest.mark.parametrize("degree", [0, 5, 61])
def test_polynomials_have_the_moments_of_which_they_are_made(degree):
    """Values of an expansion at the nodes of a rule of twice the degree have its coefficients as moments."""
    rng, disc = np.random.default_rng(degree), nonuniform_fft.nodes(degree + 2)
    k, m = np.mgrid[: degree + 1, : degree + 1]
    given = np.where(k + m <= degree, rng.normal(size=k.shape) + 1j * rng.normal(size=k.shape), 0.0)
    values = engine.moment_values(np.pad(given, (0, 3)), degree, disc.y, disc.t)
    weights = (math.pi * disc.weight * values).ravel()
    counts, t = np.full(disc.y.size, disc.t.size), np.tile(disc.t, disc.y.size)
    np.testing.assert_allclose(engine.moments(degree, disc.y, counts, t, weights), given, atol=1e-12 * (degree + 1))
    with pytest.raises(ValueError, match="counts must sum"):
        engine.moments(degree, disc.y, counts - 1, t, weights)
    # Of the whole degree in x alone, a term is a Legendre polynomial.
    top = engine.moment_values(np.where((k == degree) & (m == 0), 1.0 + 0j, 0.0), degree, disc.y, disc.t)
    legendre = np.polynomial.legendre.Legendre.basis(degree)(disc.t)
    np.testing.assert_allclose(top / top[degree // 2, 0], np.outer((1.0 - disc.y**2) ** (0.5 * degree), legendre) / (
        (1.0 - disc.y[degree // 2] ** 2) ** (0.5 * degree) * legendre[0]), atol=1e-11)  # fmt: skip


def test_rows_of_neighbouring_regions_are_apart():
    """Also where y falls by exactly 1 from the last row of a region to the first one of the next."""
    nodes = [np.array([[0.1, 0.2], [y, y], [0.3, 0.4]]) for y in (0.5, -0.5)]
    rules = [SimpleNamespace(nodes=each, lost=0.0) for each in nodes]
    opening = SimpleNamespace(phases=np.zeros((2, 3)), rows=lambda *_: rules)
    found, _ = nonuniform_fft._moments.__wrapped__(opening, 4, 32, -8)
    t = np.array([0.1, 0.2]) / math.sqrt(0.75)
    each = [engine.moments(4, np.array([y]), np.array([2]), t, np.array([0.3, 0.4 + 0.0j])) for y in (0.5, -0.5)]
    np.testing.assert_allclose(found, each[0] + each[1], atol=1e-15)


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
    monkeypatch.setattr(nonuniform_fft, "averaged_apertures", lambda *_: None)  # averages are filtered samples
    made = []
    whole = nonuniform_fft._moment_images
    monkeypatch.setattr(nonuniform_fft, "_moment_images", lambda *of, **how: made.append(how) or whole(*of, **how))

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


def by_triangles(pupil, places, names=()):
    """Return U and the fields of terms at places (y, x) in v by Gauss rules on triangles, (1 + k, n, places)."""
    t, w = np.polynomial.legendre.leggauss(12)
    u, v = 0.5 * (t + 1.0)[:, None], 0.5 * (t + 1.0)
    fields = np.zeros((1 + len(names), *pupil.shape, len(places)), dtype=complex)
    for shape, (piston, tip, tilt) in zip(pupil.stop.shapes, pupil.opening.phases, strict=True):
        corners = np.array(shape.corners)
        middle = corners.mean(axis=0)
        for a, b in zip(corners - middle, np.roll(corners, -1, axis=0) - middle, strict=True):
            x, y = (m + (u * (p + (q - p) * v)).ravel() for m, p, q in zip(middle, a, b, strict=True))
            weight = (0.25 * np.outer(w, w) * abs(a[0] * b[1] - a[1] * b[0]) * u).ravel() / math.pi
            rho, theta = np.hypot(x, y), np.arctan2(y, x)
            phase = np.exp(1j * (pupil.wavefront.phase(rho, theta) + piston + tip * x + tilt * y))
            wave = np.exp(-1j * (np.outer(x, places[:, 1]) + np.outer(y, places[:, 0])))
            for field, (n, m) in zip(fields, ((0, 0), *names), strict=True):
                field += (phase * weight * zernike.polynomial(n, m, rho, theta)) @ wave
    return fields


@pytest.mark.parametrize(("count", "dtype", "tol", "names"), [
    (1, np.float64, 1e-9, ()), (3, np.float64, 1e-10, ((3, 1), (2, -2))), (19, np.float32, 1e-4, ()),
    (2, np.float32, 1e-3, ()), (5, np.float32, 1e-4, ((4, 0),)),
])  # fmt: skip
def test_segmented_mirrors_are_within_their_bound(monkeypatch, count, dtype, tol, names):
    monkeypatch.setattr(nonuniform_fft, "moment_rule_is_faster", lambda *_: True)
    rng, made, whole = np.random.default_rng(count), [], nonuniform_fft._moment_images
    monkeypatch.setattr(nonuniform_fft, "_moment_images", lambda *of, **how: made.append(how) or whole(*of, **how))
    segments = lm.Segments.hexagonal(rings=1, gap=0.02, angle=0.1)
    stop = segments.phased(*rng.normal(size=(3, 6)) * [[1.5], [0.8], [0.8]])
    front = lm.Wavefront.zernike({term: rng.normal(scale=0.3, size=count) for term in TERMS[:5]})
    pupil, shape, center = lm.Pupil(front, stop=stop), (17, 12), (7.3, 6.0)
    asked = {"center": center, "tol": tol, "dtype": dtype, "integrate": False, "normalize": "strehl"}
    found = lm.psf(pupil, shape, 0.6, derivatives=names, **asked)
    assert [how["single_precision"] for how in made] == [dtype == np.float32]
    brightest = found.values.reshape(count, -1).argmax(axis=1)
    pixels = np.stack(np.unravel_index([*brightest, *rng.integers(0, 204, 3)], shape), axis=1)
    field, *by = by_triangles(pupil, 0.6 * math.pi * (pixels - center), names)
    scale, at = np.reshape(found.scale, (-1, 1)), (..., pixels[:, 0], pixels[:, 1])
    peak = found.values.max(axis=(1, 2))
    off = np.abs(found.values[at] - scale * np.abs(field) ** 2).max(axis=1)
    assert (off <= found.error_bound * peak).all()
    assert np.max(found.error_bound) <= tol
    for name, derivative in zip(names, by, strict=True):
        exact = -2.0 * scale * np.imag(np.conj(field) * derivative)
        found_at = found.derivatives[name][at]
        assert (np.abs(found_at - exact).max(axis=1) <= found.derivative_bounds[name] * peak).all()
        assert np.abs(exact).max() > 0.01 * peak.max()


def test_tables_are_those_of_the_weights():
    """Twice the weights give four times the intensities, of each pupil; weights must be of a quadrant."""
    rng, wanted = np.random.default_rng(2), Wanted(threads=1, terms=((2, 0),))
    pupil, window = lm.Pupil(lm.Wavefront([0.5, 1.0, 3.0])), Window((3, 5), (1.0, 2.2), 0.7)
    stack, weights = disk_stack(pupil), rng.normal(size=(6, 6, 8))
    once, by_once = engine.aperture_images(stack, window, weights, wanted)
    for factor in (2.0, 1.0):
        found, by_found = engine.aperture_images(stack, window, factor * weights, wanted)
        np.testing.assert_allclose(found, factor**2 * once, rtol=1e-12)
        np.testing.assert_allclose(by_found, factor**2 * by_once, rtol=1e-10, atol=1e-12 * by_once.max())
    assert np.ptp(once, axis=0).min() > 0.0
    with pytest.raises(ValueError, match="weights of a quadrant"):
        engine.aperture_images(stack, window, weights[:, :, :4], wanted)


@pytest.mark.parametrize(
    ("stop", "count", "names", "side", "expected"),
    [
        (lm.Polygon.regular(6, radius=0.98), 5, (), 65, True),
        (lm.Polygon.regular(6, radius=0.98), 1, (), 129, False),  # few nodes, many pixels: Fourier transforms
        (lm.telescopes.hst(), 9, ((2, 0), (3, 1), (4, 0)), 33, True),
        (lm.telescopes.hst(), 1, (), 33, True),
        (lm.telescopes.hst(), 1, ((3, 1), (14, 0)), 33, True),
    ],
)
def test_moments_are_chosen_where_they_are_cheaper(monkeypatch, stop, count, names, side, expected):
    made = []
    whole = nonuniform_fft._moment_images
    monkeypatch.setattr(nonuniform_fft, "_moment_images", lambda *of, **how: made.append(how) or whole(*of, **how))
    lm.psf(lm.Pupil(lm.Wavefront(defocus=np.linspace(0.0, 1.0, count)), stop=stop), side, 0.5, derivatives=names)
    assert bool(made) == expected


def test_the_growth_of_a_stack_lowers_the_degree_where_that_pays(monkeypatch):
    rng = np.random.default_rng(5)
    terms = [(2, 0), (2, 2), (3, 1), (3, -3), (4, 0)]
    wavefront = lm.Wavefront.zernike({t: rng.normal(0, 0.4, 8) for t in terms}, normalization="rms")
    pupil = lm.Pupil(wavefront, stop=SEGMENTS.phased(0.5))
    sizes = [(n, w) for (n, _), w in wavefront.each_amplitude().items()]
    apart = nonuniform_fft.degree_needed(sizes, math.hypot(26.0, 20.0), pupil.illumination, 1e-7)
    given = (pupil, (26.0, 20.0), 1e-7, (33, 33), nonuniform_fft._growth_of(disk_stack(pupil), 1))
    found, _, _ = nonuniform_fft.degrees_and_error(*given)
    assert found < apart - 12
    # A rule of that degree is as good as it says: against one of the other degree.
    grid, values = Grid((9, 11), 1.5), []
    for degree in (found, apart):
        rule = nonuniform_fft.moment_rule(pupil.opening, degree, degree + 32, 1e-7)
        wanted = Wanted(dtype=np.float64, threads=1)
        values.append(nonuniform_fft._moment_images(rule, pupil, grid, wanted, single_precision=False)[0])
    assert np.abs(values[0] - values[1]).max() <= 1e-6
    monkeypatch.setattr(nonuniform_fft, "_SAMPLES_SHARE", 0.0)
    assert nonuniform_fft.degrees_and_error(*given)[0] == apart
