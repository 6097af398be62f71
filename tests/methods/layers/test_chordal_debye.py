"""Small windows of a microscope with a measured wavefront: sums of plane waves, and each term of the bound."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel import _core
from lommel.core.engine import SeriesSizes, chordal_field_errors
from lommel.methods import ChordalDebye, DebyeRings, Stratified
from lommel.methods.layers import chordal_debye
from lommel.optics.grid import Grid
from lommel.optics.layers import debye, projection
from lommel.optics.layers.debye import Model
from lommel.special import zernike
from objectives import EMITTERS as ALL
from objectives import FIVE, OIL
from objectives import WATER_40X as WATER
from plane_waves import PIXEL, worst

WAVE = 520e-9
CUT = lm.Scalar(supercritical=False)
EMITTERS = [*ALL, CUT]


@pytest.mark.parametrize("emitter", [e for e in EMITTERS if e != CUT], ids=repr)
def test_the_light_is_the_sum_of_its_plane_waves(emitter):
    given = {"depth": [0.05e-6, 0.3e-6], "z": [-0.3e-6, 0.2e-6], "emitter": emitter}
    pupil = OIL.pupil(**given, wavelength=WAVE, aberrations=FIVE)
    made = lm.psf(pupil, 7, PIXEL, method=ChordalDebye(1e-9), integrate=False, dtype=np.float64)
    assert worst(OIL, pupil, made, 7) <= 1e-10
    assert made.error_bound <= 1e-9


@pytest.mark.parametrize("seed", range(30))
def test_no_error_is_above_its_bound_nor_that_above_the_tolerance(seed):
    rng = np.random.default_rng(seed)
    terms = {(n, m): 0.3 * rng.normal() for n in range(1, 8) for m in range(-n, n + 1, 2) if rng.random() < 0.3}
    objective = (OIL, WATER)[seed % 2]
    emitter = EMITTERS[seed % len(EMITTERS)]
    tol = 10.0 ** rng.uniform(-10, -2)
    given = {"depth": 10.0 ** rng.uniform(-8, -5), "z": rng.uniform(-1e-6, 1e-6, 2), "emitter": emitter}
    pupil = objective.pupil(**given, wavelength=WAVE, aberrations=lm.Wavefront.zernike(terms))
    center = tuple(rng.uniform(-1.0, 5.0, 2))
    asked = {"center": center, "integrate": False, "dtype": np.float64}
    made = lm.psf(pupil, 5, PIXEL, method=ChordalDebye(tol), **asked)
    exact = lm.psf(pupil, 5, PIXEL, method=DebyeRings(1e-10), **asked)
    error = np.abs(made.values - exact.values).max(axis=(1, 2)) / exact.values.max(axis=(1, 2))
    assert error.max() <= made.error_bound + 2e-10
    assert made.error_bound <= tol


@pytest.mark.parametrize("level", ["portable", "avx2", "avx512"])
def test_all_instructions_and_axes_give_the_same(level):
    aberrations = lm.Wavefront.zernike({5: [0.1, 0.2, 0.0], 8: [0.0, 0.1, 0.05]}, order="noll", unit="waves")
    pupil = OIL.pupil(depth=1e-6, z=np.linspace(-0.5e-6, 0.5e-6, 3), wavelength=WAVE, aberrations=aberrations)
    center = np.array([3.0, 3.4, 2.2]), np.array([3.0, 3.1, 4.0])
    _core.limit_instructions(level)
    try:
        made = lm.psf(pupil, (7, 8), PIXEL, method=ChordalDebye(1e-9), center=center, dtype=np.float64, threads=2)
    finally:
        _core.limit_instructions("avx512")
    exact = lm.psf(pupil, (7, 8), PIXEL, method=DebyeRings(1e-9), center=center, dtype=np.float64)
    assert lm.peak_error(made, exact) <= 2e-9


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("emitter", EMITTERS, ids=repr)
def test_without_aberrations_it_agrees_with_sums_over_rings(emitter, integrate):
    pupil = OIL.pupil(depth=[0.0, 0.1e-6, 3e-6], z=[-0.3e-6, 0.0, 0.5e-6], emitter=emitter, wavelength=WAVE)
    made, exact = (
        lm.psf(pupil, 9, PIXEL, method=method, integrate=integrate, dtype=np.float64)
        for method in (ChordalDebye(1e-9), Stratified(1e-11))
    )
    assert lm.peak_error(made, exact) <= 1e-11
    assert made.error_bound <= 1e-9


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("emitter", [e for e in EMITTERS if e != lm.Beam("vortex")], ids=repr)
def test_without_aberrations_derivatives_agree_with_those_over_rings(emitter, integrate):
    pupil = OIL.pupil(depth=[0.1e-6, 3e-6], z=[-0.3e-6, 0.5e-6], emitter=emitter, wavelength=WAVE)
    names = ("z", "depth", "row", "column")
    asked = {"integrate": integrate, "dtype": np.float64, "derivatives": names}
    made, exact = (lm.psf(pupil, 9, PIXEL, method=way(1e-9), **asked) for way in (ChordalDebye, Stratified))
    for name in names:
        off = np.abs(made.derivatives[name] - exact.derivatives[name]).max()
        assert off <= (made.derivative_bounds[name] + exact.derivative_bounds[name]) * exact.values.max()
        assert off <= 1e-8 * np.abs(exact.derivatives[name]).max()


def test_the_doughnut_has_derivatives_by_chords():
    pupil = OIL.pupil(depth=0.5e-6, z=0.2e-6, emitter=lm.Beam("vortex"), wavelength=WAVE)
    with pytest.raises(ValueError, match="use method=ChordalDebye"):
        lm.psf(pupil, 9, PIXEL, derivatives=("z",))
    for aberrations in (None, FIVE):
        up, middle, down = (
            OIL.pupil(depth=0.5e-6, z=z, emitter=lm.Beam("vortex"), wavelength=WAVE, aberrations=aberrations)
            for z in (0.201e-6, 0.2e-6, 0.199e-6)
        )
        exact = (lm.psf(up, 9, PIXEL, tol=1e-10).values - lm.psf(down, 9, PIXEL, tol=1e-10).values) / 2e-9
        found = lm.psf(middle, 9, PIXEL, derivatives=("z",), method=ChordalDebye(1e-9)).derivatives["z"]
        assert np.abs(found - exact).max() <= 1e-5 * np.abs(exact).max()


def test_peak_of_one_and_float32_keep_their_bounds():
    pupil = OIL.pupil(depth=1e-6, z=0.2e-6, wavelength=WAVE, aberrations=FIVE)
    made = lm.psf(pupil, 9, PIXEL, method=ChordalDebye(1e-6), normalize="peak", dtype=np.float32)
    exact = lm.psf(pupil, 9, PIXEL, method=DebyeRings(1e-9), normalize="peak", dtype=np.float64)
    assert made.values.max() == 1.0
    assert np.abs(made.values - exact.values).max() <= made.error_bound <= 1e-6


def test_few_samples_are_taken_by_chords_and_many_by_circles():
    pupil = OIL.pupil(depth=1e-6, z=0.2e-6, wavelength=WAVE, aberrations=FIVE)
    assert lm.psf(pupil, 15, PIXEL).method == ChordalDebye(1e-6)
    assert isinstance(lm.psf(pupil, 255, PIXEL).method, DebyeRings)
    assert isinstance(lm.psf(pupil, 9, PIXEL, center=(200.0, 200.0)).method, DebyeRings)
    stack = OIL.pupil(depth=1e-6, z=np.linspace(-1e-7, 1e-7, 40), wavelength=WAVE, aberrations=FIVE)
    assert isinstance(lm.psf(stack, 25, PIXEL).method, DebyeRings)
    with pytest.raises(ValueError, match="smaller window"):
        lm.psf(pupil, 301, PIXEL, method="chordal-debye")
    plain = OIL.pupil(depth=1e-6, z=0.2e-6, wavelength=WAVE)
    assert lm.psf(plain, 15, PIXEL, derivatives=("z",)).method == Stratified(1e-6)
    assert lm.psf(plain, 15, PIXEL, derivatives=("z", (2, 2))).method == ChordalDebye(1e-6)
    # Circles are shared by planes around one axis.
    many = OIL.pupil(depth=1e-6, z=np.linspace(-1e-7, 1e-7, 31), wavelength=WAVE, aberrations=FIVE)
    asked = {"tol": 1e-3, "center": (np.linspace(6.5, 7.5, 31), 7.0)}
    assert isinstance(lm.psf(many, 15, 6.5e-6, **asked).method, ChordalDebye)
    assert isinstance(lm.psf(many, 15, 6.5e-6, tol=1e-3).method, DebyeRings)
    # Circles of light that depends on the azimuth are made anew for each plane.
    fixed = OIL.pupil(depth=1e-6, z=np.linspace(-1e-7, 1e-7, 9), emitter=lm.Dipole(0.7, 0.4), wavelength=WAVE)
    assert lm.psf(fixed[:8], 15, PIXEL, derivatives=("z",)).method == ChordalDebye(1e-6)
    assert lm.psf(fixed[:8], 15, PIXEL).method == Stratified(1e-6)
    assert lm.psf(fixed, 15, PIXEL, derivatives=("z",)).method == Stratified(1e-6)
    assert lm.psf(fixed[0], 65, PIXEL, derivatives=("z",)).method == ChordalDebye(1e-6)  # which Stratified declines


def fine(function):
    """The integral of a function of complex x and y over the unit disc, over pi, by polar coordinates."""
    x, w = np.polynomial.legendre.leggauss(80)
    rho, theta = 0.5 * (1.0 + x)[:, None], 2.0 * np.pi * np.arange(128) / 128
    return (w[:, None] * rho * function(rho, theta)).sum() / 128


@pytest.mark.parametrize("few", ["chords", "nodes"])
@pytest.mark.parametrize("count", [4, 6, 8, 10, 14])
@pytest.mark.parametrize(("n", "q"), [(0, 0), (4, 0), (6, 2)])
def test_sums_of_each_term_are_within_the_bound_of_chords_and_nodes(few, count, n, q):
    rule = chordal_debye.Rule(count, 40, n) if few == "chords" else chordal_debye.Rule(40, count, n)
    wavefront, found = lm.Wavefront.zernike({(2, 2): 1.0}), []
    for v in (1.0, 3.0, 8.0):
        size = chordal_debye.growth(wavefront.flattened(), np.array([-v, -v]), np.array([v, v]))
        at = chordal_debye.quadrant(rule.chords, rule.nodes)

        def integrand(rho, theta, v=v):
            phase = wavefront.phase(rho, theta) - v * rho * (np.cos(theta) + np.sin(theta))
            return zernike.radial(n, q, rho) * np.exp(1j * (phase + q * theta))

        images = [at.theta, np.pi - at.theta, -at.theta, np.pi + at.theta]
        error = abs(sum((at.weight * integrand(at.rho, theta)).sum() for theta in images) - fine(integrand))
        each = chordal_debye.curves(size, rule)
        sizes = SeriesSizes(np.exp(n * chordal_debye._B)[None, None, None], np.zeros((1, 1, 1)))
        none, one = np.zeros(1), np.ones((1, 1))
        curves = each[0][None], each[1][None]
        bound = chordal_field_errors(sizes, np.zeros(1, np.int32), curves, none, none, one, 0.0).item()
        assert error <= bound + 1e-14
        found.append(error / bound if error > 1e-13 else 0.0)
    assert max(found) > 1e-5 or count > 10  # far from the bound, were it a wrong one


def test_errors_of_fields_become_those_of_intensities_and_slopes(monkeypatch):
    """One field E and its derivative F, of which each is off by d: 2 abs(E) d + d^2, and 2 (abs(E) + abs(F)) d."""
    pupil = OIL.pupil(depth=1e-6, z=0.2e-6, wavelength=WAVE, emitter=lm.Scalar("aplanatic"), aberrations=FIVE)
    grid, d = Grid(7, PIXEL), 1e-3
    chordal_debye._case.cache_clear()
    monkeypatch.setattr(chordal_debye, "truncation_error", lambda *_: 0.0)
    monkeypatch.setattr(chordal_debye, "chordal_field_errors", lambda *_: np.full((3, 1, 1), d))
    by = chordal_debye.By((1,), ((2, 2),))
    values, error, largest = chordal_debye.intensities(pupil, grid, 1e-9, 1, by)
    _, _, of_sums = chordal_debye.sums(pupil, grid, 1e-9, np.ones((1, 7, 7)), 1, by)
    chordal_debye._case.cache_clear()
    power = float(pupil.power[0])
    assert largest[:, 0] == pytest.approx(np.abs(values).max(axis=(1, 2, 3)), rel=1e-15)
    largest = np.sqrt(values[0].max() * power)
    for each in (error[0], of_sums):
        assert each * power == pytest.approx(d * (2.0 * largest + d), rel=1e-6)
    for slope in (1, 2):
        of_slope = np.abs(values[slope]).max() * power / (2.0 * largest)  # at most the largest F
        assert error[slope] * power >= 2.0 * d * (largest + of_slope + d) * (1.0 - 1e-6)


@pytest.mark.parametrize("kind", ["vectorial", "scalar", "radial", "vortex"])
def test_coefficients_are_the_integrals_over_the_pupil(kind):
    emitter = {"vectorial": "isotropic", "scalar": lm.Scalar("aplanatic")}.get(kind, lm.Beam("vortex"))
    emitter = lm.Beam("radial") if kind == "radial" else emitter
    pupil = OIL.pupil(depth=[0.2e-6, 4e-6], z=[0.4e-6, -0.8e-6], wavelength=WAVE, emitter=emitter, aberrations=FIVE)
    degree = 30
    made = projection.amplitudes(pupil, degree, 1e-9)
    model = pupil.light.model
    assert model == Model(kind, aplanatic=True)
    exact = debye.rule(pupil.layers, model, pupil.depth, pupil.focus, 120.0, 1e-13)
    waves = exact.waves(pupil.depth, pupil.focus)
    ends = np.cumsum([projection.degrees(order, degree).size for order in model.orders])
    found = np.split(made.coefficients[0], ends[:-1], axis=-1)
    for q, part, each in zip(model.orders, exact.parts, found, strict=True):
        n = projection.degrees(q, degree)
        radial = np.stack([zernike.radial(int(k), q, exact.rho) for k in n])
        assert np.allclose(each, (n + 1.0) * ((waves * part) @ radial.T), rtol=0.0, atol=1e-9)
        held = (np.abs(each) ** 2 / (n + 1.0)).sum(axis=1)
        assert np.sqrt(held.max()) <= projection.norm(pupil.layers, model)
    assert made.error <= 2e-9


@pytest.mark.parametrize("integrate", [False, True])
@pytest.mark.parametrize("emitter", ["isotropic", lm.Dipole(0.7, 0.4), lm.Scalar("aplanatic")], ids=repr)
def test_derivatives_are_limits_of_differences(emitter, integrate):
    terms = [lm.Wavefront.zernike({term: 1.0}) for term in ((2, 2), (3, -1))]
    units = [wavefront * (1.0 / float(max(abs(c) for c in wavefront.edge_terms().values()))) for wavefront in terms]

    def psf(depth=1e-6, z=0.3e-6, astigmatism=0.0, coma=0.0, **more):
        aberrations = FIVE + units[0] * astigmatism + units[1] * coma
        given = {"wavelength": WAVE, "emitter": emitter, "origin": "coverslip", "aberrations": aberrations}
        asked = {"integrate": integrate, "dtype": np.float64} | more
        return lm.psf(OIL.pupil(depth=[depth], z=z, **given), 7, PIXEL, **asked)

    names = ("z", "depth", "row", "column", (2, 2), (3, -1))
    made = psf(derivatives=names, tol=1e-7)
    assert isinstance(made.method, ChordalDebye)
    steps = {"z": ("z", 0.3e-6, 1e-9), "depth": ("depth", 1e-6, 1e-9)}
    steps |= {(2, 2): ("astigmatism", 0.0, 1e-3), (3, -1): ("coma", 0.0, 1e-3)}
    for name, (argument, at, h) in steps.items():

        def slope(step, argument=argument, at=at):
            ends = (psf(**{argument: at + s}, tol=1e-9).values for s in (step, -step))
            return (next(ends) - next(ends)) / (2.0 * step)

        exact = (4.0 * slope(0.5 * h) - slope(h)) / 3.0
        found = made.derivatives[name]
        assert np.abs(found - exact).max() <= 2e-7 * np.abs(exact).max()
        assert (
            np.abs(found - exact).max() <= made.derivative_bounds[name] * made.values.max() + 1e-9 * abs(exact).max()
        )
    other = psf(derivatives=("row", "column"), method=DebyeRings(1e-8))
    for name in ("row", "column"):
        off = np.abs(made.derivatives[name] - other.derivatives[name]).max()
        assert off <= (made.derivative_bounds[name] + other.derivative_bounds[name]) * made.values.max()


def test_derivatives_by_terms_of_axes_and_wavefronts_of_their_own():
    aberrations = lm.Wavefront.zernike({5: [0.1, 0.2], 8: [0.0, 0.1]}, order="noll", unit="waves")
    pupil = OIL.pupil(depth=1e-6, z=[0.2e-6, -0.3e-6], wavelength=WAVE, aberrations=aberrations)
    center = np.array([3.0, 3.4]), np.array([3.0, 2.1])
    asked = {"derivatives": ("noll 8", "z"), "dtype": np.float64}
    together = lm.psf(pupil, 7, PIXEL, center=center, **asked)
    for k in range(2):
        alone = lm.psf(pupil[k], 7, PIXEL, center=(center[0][k], center[1][k]), **asked)
        for name in ("noll 8", "z"):
            one, other = together.derivatives[name][k], alone.derivatives[name]
            assert np.abs(one - other).max() <= 1e-6 * np.abs(other).max()


@pytest.mark.parametrize("aberrations", [FIVE, None], ids=["measured", "none"])
@pytest.mark.parametrize("apart", [0.4, 6.0])
def test_axes_of_their_own_are_tilts_around_those_near_by(aberrations, apart):
    rng = np.random.default_rng(3)
    z, center = rng.uniform(-0.3e-6, 0.3e-6, 7), tuple(4.0 + apart * rng.uniform(-1.0, 1.0, (2, 7)))
    pupil = OIL.pupil(depth=1e-6, z=z, wavelength=WAVE, aberrations=aberrations)
    asked = {"dtype": np.float64, "method": ChordalDebye(1e-8), "derivatives": ("z", "row", "column", (2, 2))}
    weights = rng.normal(size=(7, 9, 9))
    together = lm.psf(pupil, 9, PIXEL, center=center, **asked)
    gradient = together.pullback(weights, ("z", "row", (2, 2)))
    cells = list(chordal_debye.axis_groups(pupil, together.grid))
    assert (len(cells) > 1) == (apart > 1.0)
    assert sorted(np.concatenate([these for these, _, _ in cells])) == list(range(7))
    for k in range(7):
        alone = lm.psf(pupil[k], 9, PIXEL, center=(center[0][k], center[1][k]), **asked)
        peak = alone.values.max()
        assert np.abs(together.values[k] - alone.values).max() <= 2e-8 * peak
        for name in asked["derivatives"]:
            off = np.abs(together.derivatives[name][k] - alone.derivatives[name]).max()
            assert off <= (together.derivative_bounds[name] + alone.derivative_bounds[name]) * together.values.max()
            assert off <= 1e-6 * np.abs(alone.derivatives[name]).max()
            if name in gradient:
                exact = (weights[k] * alone.derivatives[name]).sum()
                assert abs(gradient[name][k] - exact) <= 1e-6 * np.abs(weights[k] * alone.derivatives[name]).sum()


@pytest.mark.parametrize("waves", np.linspace(0.08, 0.4, 9))
def test_strong_aberrations_are_computed_or_declined(waves):
    aberrations = lm.Wavefront.zernike({(8, 8): waves, (5, 1): waves}, unit="waves")
    pupil = OIL.pupil(depth=1e-6, z=0.2e-6, wavelength=WAVE, aberrations=aberrations)
    made = lm.psf(pupil, 5, PIXEL, tol=1e-3, integrate=False)
    assert made.error_bound <= 1e-3
    assert np.isfinite(1e6 * chordal_debye._powers(0, chordal_debye._MOST_DEGREE).sum(axis=0)).all()
