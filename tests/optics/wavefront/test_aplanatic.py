"""Lenses that obey the sine condition: the path differences, their expansion, and Debye's integral as a reference."""

from __future__ import annotations

import math
from pathlib import Path

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import chebyshev, legendre
from scipy.fft import dct
from scipy.special import jv

import lommel as lm
from lommel.methods import ChordalGauss, NijboerZernike, Polychromatic
from lommel.optics.wavefront.wavefront import expansion, path
from lommel.paper import HuygensFresnel
from lommel.special import zernike

COMMON = {"focal_length": 50e-3, "focus_distance": 2.0, "wavelength": 550e-9}
OBJECTIVE = {"focal_length": 10e-3, "aperture_diameter": 15.75e-3, "focus_distance": 10.5e-3, "wavelength": 515e-9}
CORRECTED = ("object", "focus")


def aplanatic(f_number: float, corrected_for: str = "object", **changes: object) -> lm.Lens:
    return lm.Lens(**{"f_number": f_number, "model": "aplanatic", "corrected_for": corrected_for} | COMMON | changes)


def by_distances(lens: lm.Lens, s: float, rho: float) -> mpmath.mpf:
    """Phase at rho by the distances from a point of the reference sphere to the two points on the axis, 40 digits."""
    with mpmath.workdps(40):
        f, d, s = mpmath.mpf(lens.focal_length), mpmath.mpf(lens.sensor_distance), mpmath.mpf(s)
        image = 1 / (1 / f - 1 / s)
        # Centres of the sphere and of the wave, light going to rising z; the vertex of the pupil is at 0.
        centre, other = (d, image) if lens.corrected_for == "object" else (-1 / (1 / f - 1 / d), -s)
        h = rho * mpmath.mpf(lens.aperture_diameter) / 2
        z = centre - mpmath.sign(centre) * mpmath.sqrt(centre**2 - h**2)
        farther = mpmath.hypot(h, z - other) - abs(other)
        # The phase rises along the way of the light: towards a point in front, away from one behind.
        return 2 * mpmath.pi / mpmath.mpf(lens.wavelength) * (-farther if other > 0 else farther)


@pytest.mark.parametrize("corrected_for", CORRECTED)
@pytest.mark.parametrize("distance", [0.3, 1.5, 1.99, 2.0, 2.5, 100.0])
@pytest.mark.parametrize("f_number", [1.2, 2.8, 8.0])
def test_the_phase_is_the_path_difference_between_the_spheres(corrected_for, distance, f_number):
    lens = aplanatic(f_number, corrected_for)
    phase = lens.phase(lens.defocus(distance))
    rho = np.linspace(0.0, 1.0, 9)
    exact = [float(by_distances(lens, distance, float(r))) for r in rho]
    # C_d itself is rounded in the differences of vergences.
    rounding = 1e-15 * 2 * math.pi / 550e-9 * (0.5 * lens.aperture_diameter) ** 2 / lens.focal_length
    assert np.abs(phase.phase(rho) - exact).max() <= phase.error + rounding
    assert phase.error < 1e-10 * max(1.0, abs(exact[-1]))


@given(
    radius=st.floats(1e-3, 2e-2), sine=st.floats(-0.9, 0.9), waves=st.floats(-300.0, 300.0), share=st.floats(0.0, 1.0)
)
def test_what_the_terms_leave_out_is_bounded(radius, sine, waves, share):
    """At every aperture, up to a constant: the bound is kept, and it is no more than some times the error."""
    sphere, vergence = sine / radius, np.array([waves, share * waves]) * 2 * 550e-9 / radius**2
    terms, error = expansion(radius, sphere, vergence, 550e-9)
    t = np.linspace(0.0, 1.0, 257)
    exact = 2 * math.pi / 550e-9 * path(t, radius, sphere, vergence)
    left = zernike.legendre_sum(terms, 2.0 * t - 1.0) - exact
    spread = 0.5 * np.ptp(left, axis=1).max()
    assert spread <= error
    assert error <= 20.0 * spread + 1e-12 * (1.0 + np.abs(exact).max())


@pytest.mark.parametrize(("sine", "waves", "least"), [(0.9999, 3.0, 2.0**-47), (0.5, 300.0, 1e-6), (0.3, 20.0, 1e-4)])
def test_the_bound_is_of_the_terms_left_out_of_the_series_itself_and_of_roundings(sine, waves, least, monkeypatch):
    monkeypatch.setattr("lommel.optics.wavefront.wavefront._ROUNDING", least)
    radius, k = 5e-3, 2.0 * math.pi / 550e-9
    sphere, vergence = sine / radius, np.array([waves, -0.3 * waves]) * 2 * 550e-9 / radius**2
    terms, error = expansion(radius, sphere, vergence, 550e-9)
    degree, x = terms.shape[1], np.cos((np.arange(81) + 0.5) * (math.pi / 81))  # of the Chebyshev series of degree 80
    series = dct(k * path(0.5 + 0.5 * x, radius, sphere, vergence)) / (81.0 * (1 + (np.arange(81) == 0)))
    kept = np.array([legendre.poly2leg(chebyshev.cheb2poly(row[: degree + 1])) for row in series])
    np.testing.assert_allclose(terms, kept[:, 1:], atol=1e-6 * np.abs(series).max())
    total, tails = np.abs(series).sum(axis=1).max(), np.abs(series[:, degree:])
    t = 1.0 / max(sine**2, np.abs(2.0 * radius**2 * (sphere + vergence) * vergence).max())
    ellipse = (math.sqrt(t) + math.sqrt(t - 1.0)) ** 2
    beyond = 8.0 * k * radius**2 * t * np.abs(vergence).max() / (ellipse**80 * (ellipse - 1.0))
    tail = tails[:, 1:].sum(axis=1).max()
    assert error == pytest.approx(tail + beyond + least * (total + np.abs(kept).sum(axis=1).max()), rel=1e-8)
    # The fewest terms, thirty at most, whose tail is one of roundings.
    assert degree == 30 or tail <= 4.0 * least * total < tails.sum(axis=1).max()
    assert expansion(radius, sphere, 0.0 * vergence, 550e-9)[1] == 0.0


@pytest.mark.parametrize("corrected_for", CORRECTED)
@pytest.mark.parametrize("f_number", [1.2, 1.8, 2.8, 8.0])
@pytest.mark.parametrize("aberrations", [lm.Wavefront(), lm.Wavefront(1.0, -3.0)])
def test_debyes_integral_by_a_plain_sum_of_plane_waves_agrees(corrected_for, f_number, aberrations):
    lens = aplanatic(f_number, corrected_for, aberrations=aberrations, obscuration=0.2)
    for distance in (1.5, 1.95, 2.0):
        pupil = lens.pupil(distance)
        common = {"normalize": "strehl", "dtype": np.float64}
        series = lm.psf(pupil, 11, 3.1 * pupil.scale, integrate=False, method=NijboerZernike(1e-7), **common)
        plain = lm.psf(pupil, 11, 3.1 * pupil.scale, integrate=False, method="huygens-fresnel", **common)
        assert np.abs(series.values - plain.values).max() <= 1e-9 * series.values.max()
    every = lm.psf(pupil, 5, 1e-6, integrate=False, method=HuygensFresnel(symmetry=False), **common)
    assert np.abs(every.values - lm.psf(pupil, 5, 1e-6, integrate=False, **common).values).max() <= 1e-6


def debye(lens: lm.Lens, distance: float, r: np.ndarray) -> np.ndarray:
    """Return U at r metres from the axis by nodes in the angle: the amplitude cos^(1/2) over the solid angle."""
    d, radius, k = lens.sensor_distance, 0.5 * lens.aperture_diameter, 2 * math.pi / lens.wavelength
    sphere = radius * (1.0 / lens.focus_distance if lens.corrected_for == "focus" else 1.0 / d)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    first, last = (math.asin(rho * sphere) for rho in (lens.obscuration, 1.0))
    theta = first + (last - first) * 0.5 * (nodes + 1.0)
    solid = 0.5 * (last - first) * weights * np.sin(theta)
    rho = np.sin(theta) / sphere
    phase = np.array([float(by_distances(lens, distance, one)) for one in rho])
    field = jv(0, np.outer(k * radius / d * r, rho)) @ (solid * np.sqrt(np.cos(theta)) * np.exp(1j * phase))
    return field / (solid @ np.sqrt(np.cos(theta)))


@pytest.mark.parametrize("corrected_for", CORRECTED)
@pytest.mark.parametrize("f_number", [1.2, 2.0, 8.0])
@pytest.mark.parametrize("distance", [1.5, 1.95, 2.0])
def test_an_evenly_lit_entrance_pupil_is_brighter_at_the_rim(f_number, distance, corrected_for):
    """By Debye's plane waves one by one, and by the integral over the angle that Richards and Wolf begin from."""
    lens = aplanatic(f_number, corrected_for, apodization="aplanatic", obscuration=0.2)
    pupil = lens.pupil(distance)
    ask = {"normalize": "strehl", "dtype": np.float64, "integrate": False}
    places = (1, 11), 3.1 * pupil.scale
    series, chords, plain = (
        lm.psf(pupil, *places, method=method, **ask)
        for method in (NijboerZernike(1e-7), ChordalGauss(1e-7), HuygensFresnel())
    )
    exact = np.abs(debye(lens, distance, places[1] * np.abs(np.arange(11) - 5))) ** 2
    for answer in (series, chords, plain):
        assert np.abs(answer.values[0] - exact).max() <= 1e-7 * exact.max()


def test_the_amplitude_is_that_of_the_angle_whose_sine_the_model_states():
    rho = np.linspace(0.0, 1.0, 9)
    for corrected_for in CORRECTED:
        lens = lm.Lens(**OBJECTIVE, model="aplanatic", corrected_for=corrected_for, apodization="aplanatic")
        distance = lens.focus_distance if corrected_for == "focus" else lens.sensor_distance
        cosine = np.sqrt(1.0 - (rho * 0.5 * lens.aperture_diameter / distance) ** 2)
        expected = (cosine / cosine[-1]) ** -0.5
        assert lens.pupil().illumination.value(rho) == pytest.approx(expected, rel=1e-8)
    # Another focus, another stop: other angles, and other amplitudes.
    lens = aplanatic(1.4, apodization="aplanatic")
    for other in (lens.focused(0.2), lens.stopped(2.8), lens.stopped(1.2)):
        sine = 0.5 * other.aperture_diameter / other.sensor_distance
        assert other.illumination == lm.Apodization.cosine(sine, -0.5) != lens.illumination


def test_only_an_aplanatic_lens_has_its_amplitude():
    with pytest.raises(ValueError, match="apodization 'aplanatic' needs model='aplanatic': a paraxial lens has"):
        lm.Lens(f_number=2.0, **COMMON, apodization="aplanatic")
    with pytest.raises(ValueError, match="apodization must be a number, an Apodization or 'aplanatic', got 'sine'"):
        aplanatic(2.0, apodization="sine")


@pytest.mark.parametrize("f_number", [1.2, 2.0])
def test_spherical_waves_from_the_reference_sphere_agree_near_the_axis(f_number):
    """What Debye's integral leaves out of Kirchhoff's falls with the square of the distance from the axis."""
    lens = aplanatic(f_number)
    pupil = lens.pupil(1.9)
    d, radius, k = lens.sensor_distance, 0.5 * lens.aperture_diameter, 2 * math.pi / lens.wavelength
    nodes, weights = np.polynomial.legendre.leggauss(160)
    t = 0.5 + 0.5 * nodes[:, None]
    angle = np.arange(240) * (2 * math.pi / 240)
    sine = np.sqrt(t) * radius / d
    x, y, z = sine * d * np.cos(angle), sine * d * np.sin(angle), d - d * np.sqrt(1 - sine**2)
    phase = np.vectorize(lambda rho: float(by_distances(lens, 1.9, rho)))(np.sqrt(t))
    for r in np.array([0.0, 1.0, 4.0]) * 1e-6:
        way = np.sqrt((x - r) ** 2 + y**2 + (z - d) ** 2) - d - r**2 / (2 * d)
        field = (0.5 * weights[:, None] / 240 * np.exp(1j * (phase + k * way))).sum()
        debye = HuygensFresnel().field(pupil, pupil.v([r]))[0]
        assert abs(field - debye) <= 0.5 * k * r**2 * (radius / d) ** 2 / d + 1e-8


@pytest.mark.parametrize("corrected_for", CORRECTED)
def test_with_growing_f_number_it_tends_to_paraxial_as_the_square(corrected_for):
    differences = []
    for f_number in (8.0, 16.0, 32.0):
        pupils = []
        for model in ("paraxial", "aplanatic"):
            # The Fresnel number stays the same, so that only the angles change.
            f = 50e-3 * (f_number / 8.0) ** 2
            distances = {"focal_length": f, "sensor_distance": 1.2 * f, "focus_distance": None}
            lens = aplanatic(f_number, corrected_for, model=model, **distances)
            radius = 0.5 * lens.aperture_diameter
            vergence = 2 * lens.wavelength * 5.0 / (math.pi * radius**2)
            pupils.append(lens.pupil(1.0 / (vergence + 1.0 / lens.focus_distance)))
        v = np.linspace(0.0, 20.0, 41)
        one, two = (np.abs(NijboerZernike(1e-11).field(pupil, v)) ** 2 for pupil in pupils)
        differences.append(np.abs(one - two).max())
    assert np.divide(differences[:-1], differences[1:]) == pytest.approx(4.0, abs=0.3)


@pytest.mark.parametrize(
    ("f_number", "distance", "widths"),
    [
        (1.8, 1.5, (221.2, 221.2, 228.9, 242.9)),
        (1.8, 1.9, (35.8, 35.8, 36.9, 39.1)),
        (2.8, 1.5, (142.0, 142.0, 143.9, 147.6)),
        (5.6, 1.5, (74.9, 74.9, 75.1, 75.6)),
    ],
)
def test_between_paraxial_and_a_flat_lens_lies_the_sine_condition(f_number, distance, widths):
    """The table of the page on how to choose: micrometres that hold 90 % of the light."""
    lenses = [lm.Lens(f_number=f_number, **COMMON), aplanatic(f_number, "focus"), aplanatic(f_number)]
    for lens, width in zip(lenses, widths, strict=False):
        answer = lm.psf(lens.pupil(distance), 3, 1e-6, integrate=False, dtype=np.float64)
        assert answer.energy_diameter(0.9) * 1e6 == pytest.approx(width, abs=0.051)
    flat = lm.psf(lenses[0].pupil(distance), 1, 1e-6, integrate=False, method="huygens-fresnel", dtype=np.float64)
    assert flat.encircled_energy(0.5e-6 * widths[3]) == pytest.approx(0.9, abs=2e-3)
    page = (Path(__file__).parents[3] / "docs" / "choose.md").read_text(encoding="utf-8")
    assert f"| f/{f_number}, object at {distance} m | {' | '.join(map(str, widths))} |" in page


def test_rays_from_the_rim_meet_the_sensor_farther_out_by_one_over_the_cosine():
    paraxial = lm.Lens(f_number=1.8, **COMMON)
    cosine = math.sqrt(1.0 - (0.5 * paraxial.aperture_diameter / paraxial.sensor_distance) ** 2)
    rays = [lens.pupil(1.999999).geometric_radius() for lens in (paraxial, aplanatic(1.8))]
    assert rays[1] / rays[0] == pytest.approx(1.0 / cosine, rel=1e-5)


def test_an_objective_out_of_focus_has_k_dz_one_minus_cosine():
    """To first order in the displacement of the object, at a numerical aperture of 0.75."""
    lens = lm.Lens(**OBJECTIVE, model="aplanatic", corrected_for="focus")
    rho, dz = np.linspace(0.0, 1.0, 21), 1e-9
    phase = lens.phase(lens.defocus(10.5e-3 - dz))
    cosine = np.sqrt(1.0 - (0.75 * rho) ** 2)
    exact = 2 * math.pi / 515e-9 * dz * (1.0 - cosine)
    assert phase.phase(rho) == pytest.approx(exact, abs=1e-6 * exact.max())


def test_bounds_of_derivatives_and_spectra_count_it_too():
    pupil = lm.Pupil(lm.Wavefront(3.0, error=1e-8), wavelength=550e-9, f_number=4.0)
    plain = lm.Pupil(lm.Wavefront(3.0), wavelength=550e-9, f_number=4.0)
    asked = {"dtype": np.float64, "integrate": False}
    one, two = (lm.psf(p, 9, 1e-6, derivatives=["spherical"], **asked) for p in (pupil, plain))
    peak = one.values.max() / float(one.scale)
    more = one.derivative_bounds["spherical"] - two.derivative_bounds["spherical"]
    assert more == pytest.approx(4e-8 / peak, rel=1e-6)
    # Half the wavelength: the phase, its error and the field are twice as large.
    violet = Polychromatic([275e-9], [1.0])
    one, two = (lm.psf(p, 9, 1e-6, method=violet, **asked) for p in (pupil, plain))
    peak = one.values.max() / float(one.scale)
    assert one.error_bound - two.error_bound == pytest.approx(2.0 * 4e-8 / math.sqrt(peak), rel=1e-3)


def test_every_map_of_a_wavefront_carries_its_error():
    wave = lm.Wavefront([1.0, 2.0], nonradial={(3, 1): 1.0}, error=0.5)
    made = [
        wave[0],
        wave.flattened(),
        wave.rotated(0.3),
        wave.flipped("x"),
        wave.scaled(0.5),
        -wave,
        wave + lm.Wavefront(),
    ]
    assert [w.error for w in made] == [0.5] * len(made)
    assert (wave + 2.0 * wave).error == (wave - 2.0 * wave).error == 1.5
    assert lm.Wavefront.from_dict(wave.to_dict()) == wave != lm.Wavefront([1.0, 2.0], nonradial={(3, 1): 1.0})
    assert "error=0.5" in repr(wave)
    assert "error" not in lm.Wavefront(1.0).to_dict()


def test_an_angle_whose_sine_is_above_1_is_refused():
    with pytest.raises(ValueError, match=r"the sine of the angle of the marginal ray would be 1\.389"):
        aplanatic(0.6, focus_distance=None, sensor_distance=30e-3)


def test_an_object_on_the_lens_is_refused():
    with pytest.raises(ValueError, match="the object is so close that the phase has no expansion"):
        aplanatic(1.2, "focus").pupil(5e-3)
