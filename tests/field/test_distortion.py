"""Displacements of light by the tilts of a map, and their inverse."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm

SCALE = {"wavelength": 500e-9, "f_number": 4.0}
BARREL = lm.FieldMap.from_seidel(20e-3, W311=-400.0, W131=2.0, **SCALE)  # 8 % of the field height
COLOUR = lm.Colour([450e-9, 500e-9, 650e-9], lateral=[6e-6, 0.0, -4e-6], heights=20e-3)
LENS = lm.Lens(focal_length=50e-3, f_number=4.0, focus_distance=np.inf, wavelength=500e-9, colour=COLOUR)
COLOURED = lm.FieldMap.from_seidel(20e-3, W311=-50.0, aperture=LENS.pupil(np.inf).unaberrated())


def tilted(x: np.ndarray, y: np.ndarray) -> lm.Wavefront:
    """Return wavefronts whose tilts are polynomials of the position, in millimetres."""
    u, v = 1e3 * x, 1e3 * y
    terms = {2: 8.0 * u - 0.5 * u * v, 3: -6.0 * v + 0.3 * u * u, 7: 0.2 * v}
    return lm.Wavefront.zernike(terms, order="noll", unit="waves")


def maps() -> dict[str, lm.FieldMap]:
    """Return a map of each kind."""
    x, y = 1e-3 * np.linspace(-3.0, 4.0, 8), 1e-3 * np.linspace(-5.0, 2.0, 7)
    a, b = (part.ravel() for part in np.meshgrid(x, y))
    heights = np.linspace(0.0, 5e-3, 6)
    radial = lm.Wavefront.zernike({2: 4e10 * heights**3, 4: 1e5 * heights**2}, order="noll", unit="waves")
    return {
        "grid": lm.FieldMap.on_grid(x, y, tilted(*np.meshgrid(x, y)), **SCALE),
        "scattered": lm.FieldMap.scattered(a, b, tilted(a, b), **SCALE),
        "radial": lm.FieldMap.radial(heights, radial, **SCALE),
        "Seidel": lm.FieldMap.from_seidel(5e-3, W311=70.0, W131=3.0, W222=1.0, **SCALE),
    }


@pytest.mark.parametrize(("name", "field"), maps().items())
def test_undistorted_is_the_inverse_of_the_displacement(name, field):
    x, y = 1e-3 * np.random.default_rng(0).uniform(-1.8, 1.8, (2, 5, 9))
    dx, dy = field.displacement(x, y)
    assert np.hypot(dx, dy).max() > 2e-6, name
    across, down = field.undistorted(x + dx, y + dy)
    np.testing.assert_allclose([across, down], [x, y], atol=5e-12)


def test_the_psf_without_its_tilt_is_the_psf_moved():
    """At the edge of the map, by 2 N lambda (W311 + 2/3 W131), which is five pixels here."""
    field = lm.FieldMap.from_seidel(20e-3, W311=0.75, W131=0.75, W222=0.4, **SCALE)
    dx, dy = field.displacement(20e-3, 0.0)
    np.testing.assert_allclose([dx, dy], [5e-6, 0.0], atol=1e-15)
    options = {"tol": 1e-9, "dtype": np.float64}
    moved = field.psf(20e-3, 0.0, 31, 1e-6, **options).values
    straight = lm.psf(field.untilted(20e-3 + 5e-6, 0.0), 21, 1e-6, **options).values
    np.testing.assert_allclose(straight, moved[5:26, 10:31], atol=3e-9 * moved.max())


def test_lateral_colour_adds_to_distortion_and_a_spectrum_moves_by_its_mean():
    x, y = 6e-3, -8e-3
    green = np.array(COLOURED.displacement(x, y))
    np.testing.assert_allclose(green, -0.2e-3 * 0.5**3 * np.array([0.6, -0.8]), atol=1e-12)
    for wavelength, lateral in ((450e-9, 3e-6), (650e-9, -2e-6)):
        moved = np.array(COLOURED.displacement(x, y, wavelength)) - green
        np.testing.assert_allclose(moved, lateral * np.array([0.6, -0.8]), atol=1e-12)
    mean = np.array(COLOURED.displacement(x, y, [(450e-9, 1.0), (650e-9, 3.0)])) - green
    np.testing.assert_allclose(mean, -0.75e-6 * np.array([0.6, -0.8]), atol=1e-12)


def test_light_from_beyond_the_map_and_bad_wavelengths_are_refused():
    with pytest.raises(ValueError, match="must come from within the map, which reaches"):
        BARREL.undistorted(19e-3, 0.0)
    folded = lm.FieldMap.from_seidel(20e-3, W311=-3000.0, **SCALE)
    with pytest.raises(ValueError, match="must not fold"):
        folded.undistorted([0.0, 15e-3], 0.0)
    with pytest.raises(ValueError, match=r"pairs \(wavelength, weight\)"):
        BARREL.displacement(0.0, 0.0, [500e-9, 600e-9])
    with pytest.raises(ValueError, match="known from 450 to 650 nm"):
        COLOURED.displacement(0.0, 0.0, 700e-9)


def test_aberrations_are_those_of_the_position_without_distortion():
    """Coma is proportional to the height there, which is 8 % more than that of the image."""
    dx, _ = BARREL.displacement(20e-3, 0.0)
    seen = BARREL.untilted(20e-3 + float(dx), 0.0).wavefront.edge_terms()
    there = BARREL.pupil(20e-3, 0.0).wavefront.edge_terms()
    assert abs(dx) > 1.5e-3
    np.testing.assert_allclose(float(seen[3, 1]), float(there[3, 1]), rtol=1e-8)
    np.testing.assert_allclose(float(seen[1, 1]), 0.0, atol=1e-6)
