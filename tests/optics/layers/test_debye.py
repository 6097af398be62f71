"""Integrals over the angles: against mpmath, against finer rules, and by what must hold of light."""

from __future__ import annotations

import math
import pickle

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import j1, jv

from lommel.optics.layers import debye
from lommel.optics.layers.stratified import Layers
from lommel.special.legendre import gauss_legendre

VECTOR = debye.Model()
OIL = Layers(1.4, 1.515, 1.5255, 1.33, (), (), 610e-9)
TIRF = Layers(1.49, 1.518, 1.5255, 1.33, (), (), 670e-9)
WATER = Layers(1.2, 1.333, 1.5255, 1.36, (), (), 525e-9)
COATED = Layers(1.3, 1.515, 1.5255, 1.33, ((2.0, 30e-9), (1.2, 80e-9)), ((1.515, 2e-6), (1.52, -2e-6)), 488e-9)
DRY = Layers(0.95, 1.0, 1.5255, 1.33, (), (), 525e-9)


def exact(of: Layers, part: str, depth: float, focus: float, v: float) -> complex:
    """One integral to 20 digits and more, from the formulas as they are written, over rho."""
    k = 2 * mp.pi / mp.mpf(of.wavelength)

    def cosine(index, rho):
        square = 1 - (mp.mpf(of.NA) * rho / mp.mpf(index)) ** 2
        return mp.sqrt(square) if square >= 0 else 1j * mp.sqrt(-square)

    def matrix_t(rho, sort):
        """E in the sample over E in the glass, by 2 x 2 matrices of the films."""
        first, last = (
            n * cosine(n, rho) if sort == "s" else cosine(n, rho) / n for n in map(mp.mpf, (of.glass, of.sample))
        )
        m = mp.matrix([[1, 0], [0, 1]])
        for index, thickness in of.films:
            n, c = mp.mpf(index), cosine(index, rho)
            beta, q = k * n * mp.mpf(thickness) * c, (n * c if sort == "s" else c / n)
            m *= mp.matrix([[mp.cos(beta), -1j * mp.sin(beta) / q], [-1j * q * mp.sin(beta), mp.cos(beta)]])
        t = 2 * first / ((m[0, 0] + m[0, 1] * last) * first + m[1, 0] + m[1, 1] * last)
        return t if sort == "s" else t * mp.mpf(of.glass) / mp.mpf(of.sample)

    def integrand(rho):
        n_i, n_g, n_s = map(mp.mpf, (of.immersion, of.glass, of.sample))
        c_i, c_g, c_s = (cosine(n, rho) for n in (of.immersion, of.glass, of.sample))
        t_s = 2 * n_i * c_i / (n_i * c_i + n_g * c_g) * matrix_t(rho, "s")
        t_p = 2 * n_i * c_i / (n_g * c_i + n_i * c_g) * matrix_t(rho, "p")
        sine = mp.mpf(of.NA) * rho / n_s
        amplitude, order = {
            "K0": (t_s + t_p * c_s, 0),
            "K1": (t_p * sine, 1),
            "K2": (t_s - t_p * c_s, 2),
            "along r": (2 * t_p * c_s, 1),
            "along z": (2j * t_p * sine, 0),
            "around": (2 * t_s, 1),
        }[part]
        psi = depth * n_s * c_s - focus * n_i * c_i + sum(mp.mpf(t) * n * cosine(n, rho) for n, t in of.paths)
        return amplitude / mp.sqrt(c_i) * mp.exp(1j * k * psi) * mp.besselj(order, v * rho) * rho

    cut = min(1.0, of.sample / of.NA)
    with mp.workdps(30):
        return complex(mp.quad(integrand, [0, mp.mpf(of.sample) / mp.mpf(of.NA), 1] if cut < 1 else [0, 1]))


@pytest.mark.parametrize(
    ("of", "part", "depth", "focus", "v"),
    [
        (OIL, "K0", 2e-6, 2.6e-6, 3.0),
        (TIRF, "K1", 0.1e-6, 0.2e-6, 7.0),
        (TIRF, "K2", 1e-6, 0.9e-6, 12.0),
        (WATER, "K1", 3e-6, 2.0e-6, 5.0),
        (COATED, "K0", 0.3e-6, 0.5e-6, 2.0),
        (COATED, "K2", 0.3e-6, 0.5e-6, 2.0),
        (TIRF, "along r", 0.1e-6, 0.2e-6, 4.0),
        (TIRF, "along z", 0.1e-6, 0.2e-6, 0.0),
        (DRY, "along z", 1e-6, 0.5e-6, 3.0),
        (COATED, "around", 0.3e-6, 0.5e-6, 2.0),
    ],
)
def test_integrals_are_those_of_the_formulas_at_thirty_digits(of, part, depth, focus, v):
    planes = np.array([depth]), np.array([focus])
    kind, place = {
        "along r": ("radial", 1),
        "along z": ("radial", 0),
        "around": ("azimuthal", 1),
    }.get(part, ("vectorial", int(part[-1]) if part[0] == "K" else 0))
    model = debye.Model(kind)
    rule = debye.rule(of, model, *planes, v, 1e-13)
    found = debye.fields(rule, model, *planes, np.array([v]))[place][0, 0]
    assert abs(found - exact(of, part, depth, focus, v)) <= min(rule.error, 1e-12)


def random_system(rng: np.random.Generator) -> tuple[Layers, np.ndarray, np.ndarray]:
    """Layers, and planes around the focus of an emitter, of any microscope."""
    sample = rng.uniform(1.0, 1.52)
    immersion, glass = rng.choice([1.0, 1.333, 1.405, 1.518]), rng.choice([1.458, 1.5255])
    aperture = rng.uniform(0.1, 0.985) * min(immersion, glass)
    films = tuple((rng.uniform(1.0, 2.3), rng.uniform(0.0, 3e-7)) for _ in range(rng.choice([0, 0, 1, 2])))
    paths = ((glass, rng.uniform(-20e-6, 20e-6)), (immersion, rng.uniform(-20e-6, 20e-6)))
    layers = Layers(aperture, immersion, glass, sample, films, paths, rng.uniform(350e-9, 800e-9))
    depth = np.full(3, rng.choice([0.0, 10.0 ** rng.uniform(-7, -4)]))
    return layers, depth, depth * immersion / sample + rng.uniform(-15e-6, 15e-6, 3)


@pytest.mark.parametrize("seed", range(40))
def test_no_integral_of_a_random_microscope_errs_by_more_than_its_bound(seed):
    rng = np.random.default_rng(seed)
    of, depth, focus = random_system(rng)
    v = rng.uniform(0.0, 60.0, 7)
    tol = 10.0 ** rng.uniform(-10, -3)
    kind = ("scalar", "vectorial", "radial", "vectorial", "azimuthal")[seed % 5]
    model = debye.Model(kind, bool(seed % 2), bool(seed % 7))
    rule = debye.rule(of, model, depth, focus, float(v.max()), tol)
    found = debye.fields(rule, model, depth, focus, v)
    nearly = by_halves(of, model, depth, focus, v)
    worst = max(float(np.abs(a - b).max()) for a, b in zip(found, nearly, strict=True))
    assert worst <= rule.error <= tol + 1e-9


def by_halves(of, model, depth, focus, v):
    """The same integrals by rules over pieces of the pupil, with as many angles as settle them."""
    before = None
    for n in (256, 512, 1024, 2048):
        total = [np.zeros((depth.size, v.size), complex) for _ in model.orders]
        for piece in debye.pieces(of, model):
            for low, high in (
                (piece.low, 0.5 * (piece.low + piece.high)),
                (0.5 * (piece.low + piece.high), piece.high),
            ):
                x, w = gauss_legendre(n, low, high)
                at = debye.Points(piece, x)
                fixed, by_depth, by_focus = at.rates
                wave = np.exp(1j * (fixed + np.outer(depth, by_depth) + np.outer(focus, by_focus))) * w
                rho = np.sqrt(at.square) / of.NA
                for order, part, sum_ in zip(model.orders, piece.parts(at, model), total, strict=True):
                    sum_ += (wave * part) @ jv(order, np.outer(rho, v))
        if before is not None and max(np.abs(a - b).max() for a, b in zip(total, before, strict=True)) < 1e-12:
            return total
        before = total
    raise AssertionError("not settled")


@pytest.mark.parametrize("v", [0.0, 20.0])
@pytest.mark.parametrize(
    ("of", "model"),
    [
        *((of, VECTOR) for of in (OIL, TIRF, WATER, COATED, DRY)),
        (DRY, debye.Model("scalar")),
        (TIRF, debye.Model("radial")),
        (DRY, debye.Model("azimuthal")),
    ],
)
def test_the_growth_is_above_every_sample_on_its_ellipse_and_not_far_above(of, model, v):
    depth, focus = np.array([1e-6]), np.array([2e-6])
    # A Bessel function is far below its bound.
    above = {"scalar": 0.3, "azimuthal": math.inf}.get(model.kind, 0.8) if v == 0.0 else 4.0
    theta = np.linspace(0.0, 2 * np.pi, 3001)
    for piece in debye.pieces(of, model):
        growth = piece.growth(model, depth, focus, v)
        fit = np.flatnonzero(np.isfinite(growth))
        assert fit.size >= 5
        for row in fit[:: max(1, fit.size // 5)]:
            half = 0.5 * (piece.high - piece.low)
            x = piece.low + half * (1 + np.cos(theta + 1j * debye.ETA[row]))
            at = debye.Points(piece, x)
            fixed, by_depth, by_focus = at.rates
            rho = np.sqrt(at.square) / of.NA
            wave = np.exp(1j * (fixed + depth * by_depth + focus * by_focus))
            pairs = zip(model.orders, piece.parts(at, model), strict=True)
            parts = [0.0, *(np.abs(wave * part * jv(m, v * rho)).max() for m, part in pairs)]
            largest = math.log(max(*parts, 1e-300))  # J1 is 0 on the axis
            assert largest <= growth[row] <= largest + above


@pytest.mark.parametrize(("of", "model"), [(OIL, VECTOR), (DRY, VECTOR), (TIRF, debye.Model("azimuthal"))])
def test_the_discs_cover_each_ellipse(of, model):
    for piece in debye.pieces(of, model):
        discs = piece.covered().x
        half = 0.5 * (piece.high - piece.low)
        # The ends and the middles of the arcs, and near them.
        arc = 2 * np.pi * (np.arange(1024) + 0.5) / 1024
        for offset in np.array([-1.0, -0.999, -0.5, 0.0, 0.7, 1.0]) * np.pi / 1024:
            x = piece.low + half * (1 + np.cos(arc + offset + 1j * debye.ETA[:, None]))
            assert (np.abs(x - discs.centre) <= discs.radius).all()
            height = np.abs(np.sqrt(piece.square(x)).imag) / of.NA
            assert (height <= piece.covered().height * (1 + 1e-12) + 1e-15).all()


def test_the_discs_that_are_kept_take_little_memory():
    (piece,) = [piece for piece in debye.pieces(COATED, VECTOR) if not piece.above]
    covered, bound = debye.enclosed(piece, VECTOR, None)
    assert len(pickle.dumps(covered)) < 25 * bound.nbytes


def test_an_ellipse_round_the_branch_point_of_another_cosine_is_none():
    of = Layers(1.2, 1.5, 1.5, 1.3, (), (), 500e-9)
    (piece,) = debye.pieces(of, VECTOR)
    # c of the immersion vanishes at (NA rho)^2 = 1.5^2, hence at the c_s^2 = 1 - (1.5 / 1.3)^2 of the sample.
    branch = 1 - 1j * math.sqrt((1.5 / 1.3) ** 2 - 1)
    scaled = (branch - piece.low) / (0.5 * (piece.high - piece.low)) - 1
    largest = math.log(max(abs(scaled + s * np.sqrt(scaled**2 - 1)) for s in (1, -1)))
    growth = piece.growth(VECTOR, np.zeros(1), np.zeros(1), 0.0)
    assert np.isinf(growth[largest < debye.ETA]).all()
    assert np.isfinite(growth[0.5 * largest > debye.ETA]).all()


@pytest.mark.parametrize("of", [TIRF, DRY, *(Layers(NA, 1.518, 1.518, 1.0, (), (), 500e-9) for NA in (0.5, 1.3))])
def test_ellipses_of_what_is_odd_do_not_hold_the_centre_but_round_the_centre(of):
    model = debye.Model("azimuthal")
    centre, *others = debye.pieces(of, model)
    assert isinstance(centre, debye.Centre)
    assert centre.low == 0.0
    ends = [centre.high] + [math.sqrt(piece.square(piece.high)) / of.NA for piece in others]
    starts = [math.sqrt(piece.square(piece.low)) / of.NA for piece in others]
    assert [*starts, 1.0] == pytest.approx(ends)
    for piece in others:
        # rho = 0 is where c is 1: x = 0, or kappa = i.
        scaled = ((1j if piece.above else 0.0) - piece.low) / (0.5 * (piece.high - piece.low)) - 1.0 + 0.0j
        largest = math.log(max(abs(scaled + s * np.sqrt(scaled**2 - 1.0)) for s in (1, -1)))
        growth = piece.growth(model, np.zeros(1), np.zeros(1), 0.0)
        assert np.isinf(growth[largest < debye.ETA]).all()
        assert np.isfinite(growth[0.8 * largest > debye.ETA]).any()


def test_an_ellipse_round_a_zero_of_a_denominator_is_none(monkeypatch):
    # Of 400 random films none has one: those of guided waves lie beyond the branch points.
    piece = debye.Piece(COATED, 0.0, 0.1)
    assert np.isfinite(piece.growth(VECTOR, np.zeros(1), np.zeros(1), 0.0)).any()
    monkeypatch.setattr(debye, "windings", lambda values: np.ones(values.centre.shape[:-1], int))
    piece = debye.Piece(COATED, 0.0, 0.11)
    assert np.isinf(piece.growth(VECTOR, np.zeros(1), np.zeros(1), 0.0)).all()
    with pytest.raises(ValueError, match=r"films must be thinner, or NA must be farther below"):
        piece.nodes(piece.growth(VECTOR, np.zeros(1), np.zeros(1), 0.0), 1e-6)


def light_of_plane(of: Layers, depth: float, focus: float, end: float) -> float:
    """All light of a plane over 4 pi / (k NA)^2, by windows with a smooth edge at V.

    What they leave out is a series in odd powers of 1/V: the light of the rim's diffraction falls like v^-3, and what
    oscillates averages out.
    """
    x, w = gauss_legendre(int(4 * end), 0.0, end)
    planes = np.array([depth]), np.array([focus])
    rule = debye.rule(of, VECTOR, *planes, end, 1e-12)
    first, second, third = (np.abs(part[0]) ** 2 for part in debye.fields(rule, VECTOR, *planes, x))
    light = w * x * (first + 2 * second + third) / 2
    sizes = end * 0.8 ** np.arange(7)
    totals = []
    for size in sizes:
        s = np.clip(x / size, 1e-300, 1 - 1e-16)
        a, b = np.exp(-1 / s), np.exp(-1 / (1 - s))
        totals.append(float(light @ np.where(x < size, b / (a + b), 0.0)))
    table = sizes[:, None] ** -np.array([0.0, 1.0, 3.0, 5.0, 7.0, 9.0, 11.0])
    return float(np.linalg.solve(table, np.array(totals))[0])


TURNING = np.array([1.0, 2.0, 1.0])


def collected(of, depth):
    """The light of an emitter that turns freely."""
    return debye.power(of, depth)[0] @ TURNING


@pytest.mark.parametrize("focus", [-0.2e-6, 0.4e-6, 1.0e-6])
def test_every_plane_has_all_the_light_that_is_collected(focus):
    of = Layers(0.9, 1.333, 1.5255, 1.36, (), (), 525e-9)
    assert light_of_plane(of, 0.4e-6, focus, 400.0) == pytest.approx(collected(of, np.array([0.4e-6]))[0], rel=1e-9)


def test_light_beyond_the_critical_angle_is_in_the_image():
    # The singularity at the critical angle makes other powers of 1/V than those that are told apart.
    expected = collected(TIRF, np.array([0.1e-6]))[0]
    assert light_of_plane(TIRF, 0.1e-6, 0.2e-6, 400.0) == pytest.approx(expected, rel=1e-3)


def test_light_beyond_the_critical_angle_is_collected_near_the_glass_only():
    near, far = collected(TIRF, np.array([0.0, 0.5e-6, 20e-6])), debye.power(TIRF, np.zeros(0))[1] @ TURNING
    assert near == pytest.approx([3.01, 1.68, 1.59], abs=0.005)
    assert near[2] > far > 0.995 * near[2]
    assert collected(WATER, np.array([0.0, 1e-4])) == pytest.approx(
        [debye.power(WATER, np.zeros(0))[1] @ TURNING] * 2
    )


@pytest.mark.parametrize("index", [1.0, 1.33, 1.518])
def test_one_medium_is_richards_and_wolfs(index):
    aperture, wave, z = 0.9 * index, 500e-9, 0.7e-6
    k, alpha = 2 * math.pi * index / wave, math.asin(0.9)
    of = Layers(aperture, index, index, index, (), (), wave)
    v = np.array([0.0, 2.0, 6.0])
    planes = np.array([z]), np.array([0.0])
    rule = debye.rule(of, VECTOR, *planes, 6.0, 1e-12)
    found = debye.fields(rule, VECTOR, *planes, v)

    def integral(function, m, at):
        r = at / (k * 0.9)

        def integrand(theta, part):
            value = math.sqrt(math.cos(theta)) * math.sin(theta) * function(theta) * jv(m, k * r * math.sin(theta))
            return value * (math.cos, math.sin)[part](k * z * math.cos(theta))

        real, imaginary = (quad(integrand, 0, alpha, args=(part,), epsabs=1e-12)[0] for part in (0, 1))
        return (real + 1j * imaginary) / 0.81  # d theta -> rho d rho

    forms = (lambda t: 1 + math.cos(t), math.sin, lambda t: 1 - math.cos(t))
    for m, (form, field) in enumerate(zip(forms, found, strict=True)):
        assert field[0] == pytest.approx([integral(form, m, at) for at in v], abs=1e-10)


def test_a_small_aperture_has_airys_pattern_and_no_other_polarisation():
    of = Layers(1e-2, 1.0, 1.0, 1.0, (), (), 500e-9)
    v = np.array([1e-9, 1.0, 3.0, 8.0])
    planes = np.zeros(1), np.zeros(1)
    K0, K1, K2 = debye.fields(debye.rule(of, VECTOR, *planes, 8.0, 1e-13), VECTOR, *planes, v)
    assert K0[0] == pytest.approx(2 * j1(v) / v, abs=1e-4)
    assert K0[0, 0] == pytest.approx(1.0, abs=1e-4)
    assert np.abs(K1).max() < 1e-2
    assert np.abs(K2).max() < 1e-4
    scalar = debye.Model(kind="scalar", aplanatic=False)
    (U,) = debye.fields(debye.rule(of, scalar, *planes, 8.0, 1e-13), scalar, *planes, v)
    assert U[0] == pytest.approx(2 * j1(v) / v, abs=1e-12)
