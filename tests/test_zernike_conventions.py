"""The conventions of terms that depend on the direction, one test each: signs, axes, orders, normalisations."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel.special import zernike

TESTS = Path(__file__).resolve().parent
PAGE = TESTS.parent / "docs" / "conventions.md"
FFT = lm.paper.Fraunhofer(samples=128, edge="grey")
SIDE, PIXEL = 41, 0.5
MIDDLE = SIDE // 2
ANY_TERM = pytest.mark.parametrize("term", [(n, m) for n in range(1, 9) for m in range(-n, n + 1, 2)], ids=str)


def image(wavefront: lm.Wavefront) -> np.ndarray:
    return lm.psf(lm.Pupil(wavefront), SIDE, PIXEL, method=FFT, normalize="strehl", dtype="float64").values


def brightest(wavefront: lm.Wavefront) -> tuple[int, int]:
    """Row and column of the brightest pixel, from the middle."""
    row, column = np.unravel_index(image(wavefront).argmax(), (SIDE, SIDE))
    return int(row) - MIDDLE, int(column) - MIDDLE


def centroid(wavefront: lm.Wavefront) -> tuple[float, float]:
    """Row and column of the centroid of the light in the window, from the middle."""
    values, place = image(wavefront), np.arange(SIDE) - MIDDLE
    return float(values.sum(axis=1) @ place / values.sum()), float(values.sum(axis=0) @ place / values.sum())


def disk_rule(nodes: int = 60) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Radii, angles and weights that average over the unit disk."""
    t, w = np.polynomial.legendre.leggauss(nodes)
    rho, w = np.sqrt(0.5 + 0.5 * t), 0.5 * w
    theta = 2 * math.pi * np.arange(2 * nodes) / (2 * nodes)
    r, angle = (part.ravel() for part in np.meshgrid(rho, theta, indexing="ij"))
    return r, angle, np.repeat(w / theta.size, theta.size)


def test_the_image_is_the_transform_with_exp_minus_i_v_rho():
    wavefront = lm.Wavefront(0.7, 0.4, nonradial={(1, 1): 1.0, (3, -1): 0.8, (2, 2): -0.6, (3, 3): 0.5})
    rho, theta, weights = disk_rule()
    x, y, v = rho * np.cos(theta), rho * np.sin(theta), math.pi * PIXEL * (np.arange(SIDE) - MIDDLE)
    light = weights * np.exp(1j * wavefront.phase(rho, theta))
    field = np.exp(-1j * np.outer(v, y)) * light @ np.exp(-1j * np.outer(x, v))
    direct = np.abs(field) ** 2
    assert np.abs(image(wavefront) - direct).max() < 3e-3 * direct.max()


def test_a_positive_tilt_in_x_moves_the_image_to_higher_columns():
    assert brightest(lm.Wavefront(nonradial={(1, 1): 4 * PIXEL * math.pi})) == (0, 4)
    assert brightest(lm.Wavefront(nonradial={(1, 1): -4 * PIXEL * math.pi})) == (0, -4)


def test_a_positive_tilt_in_y_moves_the_image_to_higher_rows():
    assert brightest(lm.Wavefront(nonradial={(1, -1): 4 * PIXEL * math.pi})) == (4, 0)


def test_a_wave_of_tilt_at_the_edge_moves_the_image_by_two_lambda_N():
    assert brightest(lm.Wavefront.from_seidel(W311=1.0)) == (0, round(2 / PIXEL))
    one_wave_at_the_edge = lm.Wavefront.zernike({2: 1.0}, order="noll", unit="waves", normalization="edge")
    assert brightest(one_wave_at_the_edge) == (0, round(2 / PIXEL))


def test_the_tail_of_positive_coma_points_to_rising_x():
    for coma in (lm.Wavefront.from_seidel(W131=1.5), lm.Wavefront.zernike({8: 0.2}, order="noll", unit="waves")):
        values = image(coma)
        head = values.sum(axis=0).argmax()
        assert values[:, head + 4 :].sum() > 3 * values[:, : head - 3].sum()
        np.testing.assert_allclose(values, values[::-1], atol=1e-9)


def test_the_tail_of_positive_coma_in_y_points_to_rising_rows():
    for coma in (
        lm.Wavefront.from_seidel(W131=1.5, field=(0.0, 1.0)),
        lm.Wavefront.zernike({7: 0.2}, order="noll", unit="waves"),
    ):
        values = image(coma)
        head = values.sum(axis=1).argmax()
        assert values[head + 4 :].sum() > 3 * values[: head - 3].sum()


def test_seidel_coma_points_its_tail_where_the_field_points():
    row, column = centroid(lm.Wavefront.from_seidel(W131=1.0, field=(0.6, -0.8)))
    assert column > 0 > row
    assert row / column == pytest.approx(-0.8 / 0.6, rel=0.02)


def test_positive_astigmatism_at_0_adds_to_positive_defocus_in_x_and_takes_it_away_in_y():
    values = image(lm.Wavefront(3.0, nonradial={(2, 2): 6.0}))
    place = (np.arange(SIDE) - MIDDLE) ** 2
    assert values.sum(axis=0) @ place > 4 * values.sum(axis=1) @ place


def test_positive_astigmatism_at_45_does_so_along_the_diagonal_of_rising_x_and_y():
    values = image(lm.Wavefront(3.0, nonradial={(2, -2): 6.0}))
    rows, columns = np.indices(values.shape) - MIDDLE
    assert (values * (rows + columns) ** 2).sum() > 4 * (values * (rows - columns) ** 2).sum()


def test_a_little_positive_trefoil_x_brightens_the_first_ring_towards_rising_x():
    trefoil = lm.Wavefront(nonradial={(3, 3): 0.5})
    values = image(trefoil)
    ring = round(5.1 / math.pi / PIXEL)  # columns to the first bright ring, v = 5.1
    assert values[MIDDLE, MIDDLE + ring] > 1.5 * values[MIDDLE, MIDDLE - ring]
    np.testing.assert_allclose(values, values[::-1], atol=1e-9)
    np.testing.assert_allclose(values, image(trefoil.rotated(2 * math.pi / 3)), atol=1e-3)


def test_a_rotated_wavefront_turns_the_image_from_x_to_y_which_is_clockwise():
    wavefront = lm.Wavefront(1.0, nonradial={(1, 1): 3.0, (3, -1): 1.0, (2, 2): 0.5})
    np.testing.assert_allclose(image(wavefront.rotated(math.pi / 2)), np.rot90(image(wavefront), -1), atol=1e-9)
    assert brightest(lm.Wavefront(nonradial={(1, 1): 4 * PIXEL * math.pi}).rotated(math.pi / 2)) == (4, 0)


def test_a_wavefront_flipped_in_x_mirrors_the_columns_of_the_image_and_in_y_the_rows():
    wavefront = lm.Wavefront(1.0, nonradial={(1, 1): 3.0, (3, -1): 1.0, (2, -2): 0.5, (3, 3): 0.4})
    np.testing.assert_allclose(image(wavefront.flipped("x")), image(wavefront)[:, ::-1], atol=1e-9)
    np.testing.assert_allclose(image(wavefront.flipped("y")), image(wavefront)[::-1], atol=1e-9)


def test_the_opposite_sign_of_the_phase_turns_the_image_by_half_a_turn():
    wavefront = lm.Wavefront(1.0, 0.5, nonradial={(1, 1): 2.0, (3, -1): 1.0, (2, 2): 0.5})
    np.testing.assert_allclose(image(-wavefront), image(wavefront)[::-1, ::-1], atol=1e-9)
    even = lm.Wavefront(1.0, nonradial={(2, 2): 0.5, (4, -2): 1.0})
    np.testing.assert_allclose(image(-even), image(even), atol=1e-9)


def test_an_angle_counted_from_y_towards_x_exchanges_the_axes():
    wavefront = lm.Wavefront(1.0, nonradial={(1, 1): 2.0, (3, -1): 1.0, (2, 2): 0.7, (4, -2): 0.5})
    exchanged = wavefront.flipped("y").rotated(math.pi / 2)
    rho, theta = np.linspace(0, 1, 9), np.linspace(-3, 3, 9)
    np.testing.assert_allclose(exchanged.phase(rho, theta), wavefront.phase(rho, math.pi / 2 - theta), atol=1e-12)


def test_noll_4_is_defocus():
    wavefront = lm.Wavefront.zernike({4: 0.1}, order="noll", unit="waves")
    assert wavefront.radial
    assert float(wavefront.defocus) == pytest.approx(math.sqrt(3) * 2 * math.pi * 0.1)
    assert float(wavefront.waves["W020"]) == pytest.approx(2 * math.sqrt(3) * 0.1)
    assert float(wavefront.spherical) == 0.0


def test_noll_11_ansi_12_and_fringe_9_are_spherical_aberration():
    for order, index in {"noll": 11, "ansi": 12, "fringe": 9}.items():
        wavefront = lm.Wavefront.zernike({index: 1.0}, order=order, unit="waves", normalization="edge")
        assert float(wavefront.waves["W040"]) == pytest.approx(6.0)
        assert float(wavefront.waves["W020"]) == pytest.approx(-6.0)


def test_even_noll_indices_are_cosines_and_odd_ones_sines():
    for j in range(2, 200):
        n, m = zernike.term(j, "noll")
        assert m == 0 or (m > 0) == (j % 2 == 0), (j, n, m)


def test_ansi_counts_n_times_n_plus_2_plus_m_halved():
    assert all(
        zernike.index_of(n, m, "ansi") == (n * (n + 2) + m) / 2 for n in range(20) for m in range(-n, n + 1, 2)
    )


@ANY_TERM
def test_one_wave_rms_of_any_term_is_2_pi_radians_rms(term):
    rho, theta, weights = disk_rule()
    phase = lm.Wavefront.zernike({term: 1.0}, unit="waves").phase(rho, theta)
    mean = weights @ phase
    assert math.sqrt(weights @ (phase - mean) ** 2) == pytest.approx(2 * math.pi)


@ANY_TERM
def test_the_edge_and_rms_normalizations_differ_by_the_root_of_n_plus_1_times_2(term):
    n, m = term
    edge, rms = (lm.Wavefront.zernike({term: 1.0}, normalization=kind).edge_terms()[term] for kind in ("edge", "rms"))
    assert float(rms / edge) == pytest.approx(math.sqrt((n + 1) * (1 if m == 0 else 2)))


@given(st.lists(st.floats(-2, 2), min_size=6, max_size=6))
def test_seidel_terms_are_the_zernike_terms_that_the_page_says(waves):
    w020, w040, w131, w222, w220, w311 = waves
    seidel = lm.Wavefront.from_seidel(w020, w040, W131=w131, W222=w222, W220=w220, W311=w311)
    found = seidel.to_zernike(unit="waves", normalization="edge")
    expected = {
        (1, 1): w311 + 2 * w131 / 3,
        (2, 0): (w020 + w220 + w040) / 2 + w222 / 4,
        (2, 2): w222 / 2,
        (3, 1): w131 / 3,
        (4, 0): w040 / 6,
    }
    for term in expected.keys() | found.keys():
        assert float(found.get(term, 0.0)) == pytest.approx(expected.get(term, 0.0), abs=1e-12)


def test_the_table_of_the_page_is_true():
    rows = re.findall(
        r"^\| \((\d+), (-?\d+)\) \| (\d+) \| (\d+) \| (\d+) \| ([\w ]+) \| \$(.*)\$ \| \$\\sqrt\{(\d+)\}\$ \|$",
        PAGE.read_text(encoding="utf-8"),
        flags=re.MULTILINE,
    )
    assert len(rows) == 15
    rho, theta = np.linspace(0.1, 1.0, 7), np.linspace(-3.0, 3.0, 7)
    for row in rows:
        n, m = int(row[0]), int(row[1])
        assert [zernike.index_of(n, m, order) for order in ("noll", "ansi", "fringe")] == [int(j) for j in row[2:5]]
        assert zernike.name(n, m) == row[5]
        assert zernike.rms_factor(n, m) == pytest.approx(math.sqrt(int(row[7])))
        text = re.sub(r"\\(cos|sin) (\d?)\\theta", r"*np.\1(\2*theta)", row[6]).replace("(*theta)", "(theta)")
        text = re.sub(r"(\d)\s*\\rho", r"\1*rho", text).replace("\\rho", "rho").replace("^", "**").replace(" ", "")
        value = eval(text.lstrip("*"), {"np": np, "rho": rho, "theta": theta})
        np.testing.assert_allclose(
            np.broadcast_to(value, rho.shape), zernike.polynomial(n, m, rho, theta), atol=1e-14
        )


def test_every_test_that_the_page_names_is_there():
    named = set(re.findall(r"`(test_\w+)`", PAGE.read_text(encoding="utf-8")))
    files = ("test_conventions.py", "test_zernike_conventions.py", "optics/wavefront/test_wavefront.py")
    files = (*files, "measures/test_aperture_means.py")
    there = re.findall(r"def (test_\w+)", "".join((TESTS / name).read_text(encoding="utf-8") for name in files))
    assert len(named) > 40
    assert named <= set(there)
