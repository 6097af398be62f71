"""Maps of the field: what they make of wavefronts over the sensor, and what they refuse."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.field.maps import Foreshortening

FFT = lm.paper.Fraunhofer(samples=64, edge="grey")
METRIC = {"wavelength": 550e-9, "f_number": 2.8, "obscuration": 0.2}
SEIDEL = {"W020": 0.3, "W040": 0.4, "W131": 1.5, "W222": -0.8, "W220": 0.6, "W311": 0.7}
EDGE = 20e-3


@pytest.fixture(scope="module")
def seidel() -> lm.FieldMap:
    return lm.FieldMap.from_seidel(EDGE, **SEIDEL, **METRIC)


def test_the_psf_at_an_azimuth_of_90_degrees_is_the_one_along_x_turned_from_columns_to_rows(seidel):
    right = seidel.psf(15e-3, 0.0, 31, 1e-6, method=FFT).values
    below = seidel.psf(0.0, 15e-3, 31, 1e-6, method=FFT).values
    np.testing.assert_allclose(below, right.T, atol=1e-6 * right.max())
    assert np.abs(right - right.T).max() > 0.1 * right.max()


def test_the_tail_of_positive_coma_points_away_from_the_axis():
    field = lm.FieldMap.from_seidel(10.0, W131=1.0)
    psf = field.psf(0.0, -8.0, 41, 0.5, method=FFT)  # above the axis
    rows = psf.values.sum(axis=1)
    centroid = rows @ np.arange(41) / rows.sum()
    assert centroid < np.argmax(rows) - 0.5


def test_positions_make_stacks_of_pupils_with_the_scale_of_the_map(seidel):
    pupil = seidel.pupil(np.zeros(3), np.zeros((2, 1)))
    assert pupil.shape == (2, 3)
    assert (pupil.wavelength, pupil.f_number, pupil.obscuration) == (550e-9, 2.8, 0.2)
    assert seidel.pupil(0.0, 0.0).shape == ()
    assert (seidel.unit, lm.FieldMap.from_seidel(1.0).unit) == ("m", "lambda*N")


def test_stars_between_the_pixels_have_an_axis_each(seidel):
    x, y, tol = np.array([0.0, 9e-3, -14e-3]), np.array([[1e-3], [-7e-3]]), 1e-6
    rows, columns = 10.0 + np.array([[0.25], [-0.5]]), 10.0 + np.array([0.125, -0.375, 0.5])
    stack = seidel.psf(x, y, 21, 1e-6, center=(rows, columns), tol=tol)
    for i, j in np.ndindex(2, 3):
        center = float(rows[i, 0]), float(columns[j])
        alone = seidel.psf(x[j], y[i, 0], 21, 1e-6, center=center, tol=1e-9).values
        assert np.abs(stack.values[i, j] - alone).max() <= 1.1 * tol * alone.max()


def test_what_is_added_to_a_map_is_added_everywhere(seidel):
    more = seidel + lm.Wavefront(2.0, nonradial={(2, 2): 1.0}) + lm.Wavefront(1.0)
    found = (more.pupil([0.0, 1e-2], 0.0).wavefront - seidel.pupil([0.0, 1e-2], 0.0).wavefront).nonradial
    np.testing.assert_allclose(more.pupil(0.0, 0.0).wavefront.defocus, math.pi * 0.3 + 3.0)
    np.testing.assert_allclose(found[2, 2], 1.0)
    with pytest.raises(ValueError, match=r"a single wavefront .* stack of shape \(2,\)"):
        seidel + lm.Wavefront([1.0, 2.0])
    with pytest.raises(TypeError):
        seidel + 1.0


MAP, ROUND = lm.FieldMap, lm.FieldMap.from_seidel(3.0, W131=1.0)


def some(shape: tuple[int, ...]) -> lm.Wavefront:
    """Wavefronts that depend on the direction everywhere."""
    return lm.Wavefront(nonradial={(3, 1): np.ones(shape)})


@pytest.mark.parametrize(
    ("make", "error", "what"),
    [
        (lambda: MAP.on_grid([0, 1, 2], [0, 1], some((3, 2))), ValueError, "wavefront must have the shape"),
        (lambda: MAP.scattered([0, 1, 0], [2, 1, 2], some((3,))), ValueError, r"all be different, got \(0, 2\)"),
        (lambda: MAP.radial([0.1, 1], some((2,))), ValueError, "must begin with 0, the axis, got 0.1"),
        (lambda: MAP.radial([0, 2, 1], some((3,))), ValueError, "height must rise, got 2 followed by 1"),
        (lambda: MAP.radial([0, 1], some((2,))), ValueError, "must be radially symmetric"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused_by_name(make, error, what):
    with pytest.raises(error, match=what):
        make()


OPTICS = {"wavelength": 550e-9, "f_number": 2.8}
LENS = """
[lens]
focal_length = "35 mm"
f_number = 2.8
focus_distance = "inf"
wavelength = "550 nm"
[sensor]
pixel = "3 um"
[field]
sensor = ["10 mm", "16 mm"]
file = "field.csv"
"""


def _stack(shape):
    rng = np.random.default_rng(3)
    return lm.Wavefront.zernike({j: rng.normal(size=shape) for j in (2, 4, 6, 8, 11)}, order="noll")


SAVED = {
    "seidel": lm.FieldMap.from_seidel(12e-3, W040=-0.7, W131=1.5, W222=-0.8, W220=0.4, W311=-3.0, **OPTICS),
    "radial": lm.FieldMap.radial(
        np.array([0.0, 4e-3, 9e-3, 12e-3]),
        lm.Wavefront.zernike(
            {(3, -1): [0.0, -0.3, 0.5, 0.8], (4, 0): [-0.2, -0.1, 0.3, 0.2], (2, 2): [0, 0.1, 0.3, 0]}
        ),
        azimuth=-0.5 * np.pi,
        **OPTICS,
    ),
    "grid": lm.FieldMap.on_grid(np.linspace(-9e-3, 8e-3, 5), np.linspace(-6e-3, 5e-3, 4), _stack((4, 5)), **OPTICS),
    "scattered": lm.FieldMap.scattered(
        *np.random.default_rng(4).uniform(-11e-3, 11e-3, (2, 30)), _stack(30), **OPTICS
    ),
}


@pytest.mark.parametrize("kind", SAVED)
def test_a_saved_map_is_that_of_a_lens_file(tmp_path, kind):
    field = SAVED[kind] + lm.Wavefront(defocus=0.3)  # as of an object at another distance
    field.save(tmp_path / "field.csv")
    (tmp_path / "lens.toml").write_text('name = "a"\nsource = "b"\n' + LENS)
    again = lm.load_instrument(tmp_path / "lens.toml").field()
    x, y = np.array([[0.0, 1.1e-3, -3.4e-3, 4.1e-3], [0.0, -2.3e-3, 3.7e-3, 1.9e-3]])
    expected = field.pupil(x, y).wavefront.edge_terms()
    loaded = again.pupil(x, y).wavefront.edge_terms()
    assert sum(np.abs(c).max() > 0.01 for c in expected.values()) >= 4
    for term in expected | loaded:
        np.testing.assert_allclose(loaded.get(term, 0.0), expected.get(term, 0.0), atol=1e-7)
    assert again.pupil_without_wavefront.f_number == pytest.approx(2.8)
    text = (tmp_path / "field.csv").read_text()
    assert text.startswith("# wavelength 550 nm, working f-number 2.8\n")


def test_maps_that_a_table_cannot_hold_are_not_saved(tmp_path):
    field = SAVED["seidel"]
    ellipses = field.seen_through(Foreshortening([0.0, 12e-3], [1.0, 0.8], [1.0, 0.9]))
    path = tmp_path / "field.csv"
    with pytest.raises(ValueError, match="make the map with circular=True"):
        ellipses.save(path)
    with pytest.raises(ValueError, match=r"without this symmetry was added: .* state it in \[aberrations\]"):
        (field + lm.Wavefront.zernike({7: 0.2}, order="noll")).save(path)
    with pytest.raises(ValueError, match="positions in metres: make the map with a wavelength and an f_number"):
        lm.FieldMap.from_seidel(10.0, W131=1.0).save(path)
    with pytest.raises(ValueError, match=r"path must end in \.csv, got 'field\.toml'"):
        field.save("field.toml")
    assert not path.exists()
