"""Spherical wavelets with exact distances: against a brute-force sum, and tending to Fresnel's approximation."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import lommel as lm
from lommel import Lens, Pupil, Wavefront
from lommel.methods import Hankel
from lommel.methods.paper import huygens
from lommel.paper import HuygensFresnel

WAVELENGTH = 550e-9


def _lens(f_number: float, *, obscuration: float = 0.0, aberrations: Wavefront | None = None) -> Lens:
    """Return a lens whose Fresnel number is the same at every f-number, so that only the angles change."""
    focal_length = 1e-3 * (f_number / 4) ** 2
    return Lens(
        focal_length=focal_length,
        f_number=f_number,
        sensor_distance=1.25 * focal_length,
        wavelength=WAVELENGTH,
        obscuration=obscuration,
        aberrations=aberrations,
    )


def _pupil(lens: Lens, defocus: float) -> Pupil:
    """Return the pupil for the object distance at which C_d is `defocus`."""
    vergence = 2 * WAVELENGTH * defocus / (math.pi * (lens.aperture_diameter / 2) ** 2)
    return lens.pupil(1 / (vergence + 1 / lens.focal_length - 1 / lens.sensor_distance))


def _difference(pupil: Pupil, pixel: float = 0.35) -> float:
    answer = lm.psf(pupil, 15, pixel * pupil.scale, method=HuygensFresnel(), normalize="strehl", dtype=np.float64)
    exact = lm.psf(pupil, 15, pixel * pupil.scale, method=Hankel(), normalize="strehl").values
    return float(np.abs(answer.values - exact).max() / exact.max())


def _brute_force(lens: Lens, distance: float, x: float, y: float) -> complex:
    """Add up the paths from the object through every point of the aperture to (x, y), in extended precision."""
    k, d = 2 * np.pi / np.longdouble(lens.wavelength), np.longdouble(lens.sensor_distance)
    radius = np.longdouble(lens.aperture_diameter) / 2
    nodes, weights = np.polynomial.legendre.leggauss(80)
    inner = lens.obscuration
    rho = inner + 0.5 * (1 - inner) * (1 + nodes)[:, None]
    angle = np.arange(200) * (2 * math.pi / 200)
    px, py = radius * rho * np.cos(angle), radius * rho * np.sin(angle)
    square = px**2 + py**2
    focus = 1 / (1 / np.longdouble(lens.focal_length) - 1 / d)
    path = np.sqrt((px - x) ** 2 + (py - y) ** 2 + d**2)
    phase = k * (path - np.sqrt(square + d**2))
    # The lens takes away the spherical wave from the point in focus; the object sends its own.
    phase = phase - k * (np.sqrt(focus**2 + square) - focus)
    if math.isfinite(distance):
        phase = phase + k * (np.sqrt(np.longdouble(distance) ** 2 + square) - np.longdouble(distance))
    phase = phase + lens.aberrations.spherical * rho**4
    wave = np.exp(1j * phase.astype(np.float64)) * (d / path).astype(np.float64) ** 2
    area = weights[:, None] * 0.5 * (1 - inner) * rho * (2 * math.pi / 200)
    return complex(np.sum(area * wave) / math.pi)


@pytest.mark.parametrize(("obscuration", "spherical"), [(0.0, 0.0), (0.4, 0.0), (0.0, 3.0), (0.33, -4.0)])
@pytest.mark.parametrize("distance", [0.004, 0.005, 0.0061, math.inf])
def test_it_is_the_sum_of_the_paths_through_the_aperture(
    distance: float, obscuration: float, spherical: float
) -> None:
    lens = _lens(4.0, obscuration=obscuration, aberrations=Wavefront(0.0, spherical))
    pupil = lens.pupil(distance)
    points = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, -2.3], [3.0, 4.0]]) * pupil.scale
    exact = [_brute_force(lens, distance, x, y) for x, y in points]
    field = HuygensFresnel().field(pupil, pupil.v(np.hypot(*points.T)))
    assert np.abs(field - exact).max() <= 1e-11


@pytest.mark.parametrize("defocus", [0.0, 5.0, -5.0])
@pytest.mark.parametrize(("obscuration", "spherical"), [(0.0, 0.0), (0.3, 4.0)])
def test_with_growing_f_number_it_tends_to_fresnel_as_the_square(
    defocus: float, obscuration: float, spherical: float
) -> None:
    differences = []
    for f_number in (4.0, 8.0, 16.0, 32.0):
        pupil = _pupil(_lens(f_number, obscuration=obscuration, aberrations=Wavefront(0.0, spherical)), defocus)
        assert float(pupil.wavefront.defocus) == pytest.approx(defocus, abs=1e-9)
        differences.append(_difference(pupil))
    ratios = np.divide(differences[:-1], differences[1:])
    assert np.all((ratios >= 3.9) & (ratios <= 4.1))
    assert 1e-3 < differences[0] < 0.03


@pytest.mark.parametrize("defocus", [0.0, 5.0, -4.0])
def test_one_sum_for_each_radius_is_one_sum_for_every_pixel(defocus: float) -> None:
    pupil = _pupil(_lens(8.0, obscuration=0.2, aberrations=Wavefront(0.0, 1.5)), defocus)
    images = [
        lm.psf(
            pupil,
            (6, 9),
            0.4 * pupil.scale,
            method=HuygensFresnel(symmetry=symmetry),
            normalize="strehl",
            dtype=np.float64,
            integrate=integrate,
        ).values
        for integrate in (False, True)
        for symmetry in (True, False)
    ]
    assert np.abs(images[0] - images[1]).max() <= 1e-11
    assert np.abs(images[2] - images[3]).max() <= 2e-6


@given(
    st.floats(2.0, 20.0),
    st.floats(-8.5, 12.0),  # an object at infinity has -8.9
    st.floats(-12.0, 12.0),
    st.sampled_from([0.0, 0.3, 0.8]),
    st.lists(st.floats(0, 40), min_size=1, max_size=4),
)
def test_more_nodes_change_nothing(
    f_number: float, defocus: float, spherical: float, obscuration: float, v: list[float]
) -> None:
    pupil = _pupil(_lens(f_number, obscuration=obscuration, aberrations=Wavefront(0.0, spherical)), defocus)
    assert pupil.geometry is not None
    radial, azimuthal = huygens._nodes(pupil, pupil.geometry, max(v))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(huygens, "_nodes", lambda *_: (2 * radial + 5, 2 * azimuthal + 6))
        more = HuygensFresnel().field(pupil, v)
    assert np.abs(HuygensFresnel().field(pupil, v) - more).max() <= 1e-10


def test_too_few_nodes_are_visible(monkeypatch: pytest.MonkeyPatch) -> None:
    pupil, v = _pupil(_lens(8.0), 5.0), np.array([0.0, 20.0])
    exact = HuygensFresnel().field(pupil, v)
    monkeypatch.setattr(huygens, "_nodes", lambda *_: (4, 8))
    assert np.abs(HuygensFresnel().field(pupil, v) - exact).max() > 1e-3
