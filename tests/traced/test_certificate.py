"""Means of the integrand on curves off the disk: bounded by samples, and not by much more than they are."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import lommel as lm
from lommel.special import zernike
from lommel.special.legendre import gauss_legendre
from lommel.traced import certificate
from lommel.traced.namespaces import Namespace

TERMS = ((2, 0), (4, 0), (1, -1), (3, 1), (3, -3), (4, 2), (5, 1))
V = 0.5 * math.pi * (np.arange(33) - 16.0)


def true_mean(name, c, b, chords, window):
    """Return the logarithm of the mean, the largest of the corners, by sums that are exact to many digits."""
    around = np.linspace(0.0, 2 * math.pi, 300, endpoint=False)
    if name == "chords":
        eta, w = gauss_legendre(60, -1.0, 1.0)
        x, y = np.cos(around + 1j * b)[:, None] + 0 * eta, np.sin(around + 1j * b)[:, None] * eta
        share = (np.sin(around) ** 2 + math.sinh(b) ** 2)[:, None] * w / (300 * math.cosh(2 * b))
    else:
        phi = np.arange(1, chords + 1) * (math.pi / (chords + 1))
        x, y = np.cos(phi)[:, None] + 0 * around, np.sin(phi)[:, None] * np.cos(around + 1j * b)
        share = (2 * np.sin(phi) ** 2 / (chords + 1))[:, None] / 300 + 0 * around
    phase = np.tensordot(c, certificate.polynomials(TERMS, x, y), 1)
    down, across = window
    corners = [(u, w) for u in (down[0], down[-1]) for w in (across[0], across[-1])]
    return max(math.log(np.sum(share * np.exp(-(phase - w * x - u * y).imag))) for u, w in corners)


@pytest.mark.parametrize("name", ["chords", "nodes"])
@pytest.mark.parametrize("b", [0.1, 0.3, 0.5])
def test_the_mean_on_a_curve_is_below_its_bound_and_not_far_below(name, b):
    draw = np.random.default_rng(1)
    for chords, window in ((8, (V, V)), (31, (V[10:20], V[:9]))):
        mean, tables = certificate.mean_on_curve(TERMS, 1.0, window, name, b, chords)
        for size in (0.0, 0.3, 1.0):
            c = size * draw.normal(size=len(TERMS))
            found = float(mean.logarithm(Namespace.of(None), tables, name, c[None])[0])
            exact = true_mean(name, c, b, chords, window)
            assert exact <= found + 1e-9
            assert found <= 1.2 * exact + 0.5


@pytest.mark.parametrize("error", [1.4e-4, 1e-4, 1e-5])
def test_the_chords_and_nodes_suffice_for_all_signs_of_the_members_and_not_by_far(error):
    terms, c = ((2, 0), (3, 1), (3, 3), (4, 4)), np.array([[2.2, 2.6, 2.2, 1.2], [-1.2, 0.1, -2.3, 1.1]])
    window = (V[12:21], V[10:21])
    disks = [(1.0, np.zeros((2, len(certificate.CURVES)))), (0.7, np.zeros((2, len(certificate.CURVES))))]
    chords, nodes, mean, tables = certificate.fewest((terms, 1.0, window), c, disks, error, 2.0**-53)
    assert chords % 2 == nodes % 2 == 0
    signs = np.array(list(itertools.product([1.0, -1.0], repeat=4)))
    smaller = np.random.default_rng(0).uniform(-1.0, 1.0, (200, 4))
    rows = np.concatenate([factors * member for member in c for factors in (signs, smaller)])
    numpy = Namespace.of(None)
    errors = sum(np.exp(mean.logarithm(numpy, tables, name, rows)) for name in ("chords", "nodes"))
    assert 0.05 * error < errors.max() <= error


@pytest.mark.parametrize(
    ("members", "obscuration", "window", "tol"),
    [
        ({(2, 0): 2.17, (4, 0): 0.609, (5, -1): 4.17, (7, -5): 1.24, (7, -3): 1.79}, 0.73, (10, 0.58), 1e-3),
        ({(2, 0): 1.2, (2, 2): 1.9, (3, -3): 0.8, (4, 4): 1.5, (6, -2): 1.1, (6, 6): 0.4}, 0.0, (17, 0.5), 1e-3),
        ({(2, 2): 1.5, (3, 1): 1.9, (3, -1): 1.0, (4, 2): 0.6, (5, 5): 1.9}, 0.3, (9, 0.7), 1e-7),
        ({(2, 0): 1.0, (13, 1): 0.5, (13, -5): 0.5}, 0.0, (9, 0.5), 1e-5),
    ],
)
def test_a_traced_plan_answers_all_signs_of_a_member(members, obscuration, window, tol):
    pupil = lm.Pupil(lm.Wavefront.zernike(members, normalization="edge"), obscuration=obscuration)
    f = lm.Plan(*window, tol=tol, integrate=False, normalize="strehl").traced(pupil, np)
    signs = np.array(list(itertools.product([1.0, -1.0], repeat=len(members))))
    edge = pupil.wavefront.edge.reshape(-1)
    full = np.zeros((len(signs), len(edge)))
    full[:, edge != 0.0] = signs
    assert np.all(f.error(full * edge) <= tol)


def test_the_terms_of_complex_points_are_those_of_real_ones():
    x, y = np.random.default_rng(0).uniform(-0.7, 0.7, (2, 30))
    terms = tuple((n, m) for n in range(9) for m in range(-n, n + 1, 2))
    exact = [zernike.polynomial(n, m, np.hypot(x, y), np.arctan2(y, x)) for n, m in terms]
    assert np.abs(certificate.polynomials(terms, x, y) - exact).max() < 1e-13


@pytest.mark.parametrize(("tol", "low"), [(1e-3, 0.0), (1e-6, 0.0), (1e-9, 0.0), (1e-6, 0.5)])
def test_images_of_pupils_far_beyond_the_stack_are_within_their_bounds(tol, low):
    draw = np.random.default_rng(3)

    def pupils(edge):
        wavefront = lm.Wavefront.zernike(dict(zip(TERMS, edge.T, strict=True)), normalization="edge")
        return lm.Pupil(wavefront, obscuration=low)

    small = pupils(0.2 * draw.normal(size=(5, len(TERMS))))
    f = lm.Plan(9, 0.5, tol=tol, dtype=np.float64, normalize="strehl").traced(small)
    large = pupils(draw.uniform(0.1, 1.2, (60, 1)) * draw.normal(size=(60, len(TERMS))))
    values, bound = f.evaluated(large.wavefront.edge)
    exact = lm.psf(large, 9, 0.5, tol=1e-11, dtype=np.float64, normalize="strehl").values
    exact = exact.transpose(0, 2, 1).reshape(60, -1)
    error = np.abs(values - exact).max(axis=1) / exact.max(axis=1)
    known = np.isfinite(bound)
    assert known.sum() > 20
    assert np.all(error[known] <= bound[known] + 1e-11)
    assert bound.max() > 10 * tol


@pytest.mark.parametrize("name", ["chords", "nodes"])
@pytest.mark.parametrize("b", [0.1, 0.5])
def test_the_size_of_terms_on_a_curve_bounds_their_imaginary_parts_and_is_reached(name, b):
    _, tables = certificate.mean_on_curve(TERMS, 2.0, (V, V), name, b, 31)
    largest = np.abs(tables[f"{name} 0 samples"]).max(axis=0)
    ratio = tables[f"{name} 0 size"][0] / largest
    assert np.all(ratio >= 1.0 - 1e-12)
    assert ratio.min() <= 1.01
    assert ratio.max() <= 6.0
