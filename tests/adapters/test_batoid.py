"""Telescopes of batoid: rays, wavefronts and fields agree with the pupils made of them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import lommel as lm
from lommel.adapters import batoid as adapter
from lommel.adapters import ray_tracing

WAVELENGTH = 620e-9
FIELD = 0.003, 0.002  # radians


@pytest.fixture(scope="module", params=["SDSS.yaml", "DECam.yaml"])
def telescope(request) -> Any:
    """Two mirrors, and one: light arrives along -z and along +z."""
    return pytest.importorskip("batoid").Optic.fromYaml(request.param)


@pytest.fixture(scope="module")
def pupil(telescope) -> lm.Pupil:
    return adapter.pupil(telescope, FIELD, wavelength=WAVELENGTH)


def side(telescope: Any) -> float:
    """Return the sign of the direction in which light arrives."""
    batoid = pytest.importorskip("batoid")
    ray = batoid.RayVector.fromStop(0.0, 0.0, optic=telescope, wavelength=WAVELENGTH, theta_x=0.0, theta_y=0.0)
    return math.copysign(1.0, telescope.trace(ray).vz[0])


def test_the_phase_is_minus_their_wavefront_seen_from_behind_the_sensor(telescope):
    pupil = adapter.pupil(telescope, FIELD, wavelength=WAVELENGTH, circular=True)
    theirs = pytest.importorskip("batoid").wavefront(telescope, *FIELD, WAVELENGTH, nx=33).array
    x, y = np.meshgrid(np.linspace(-1.0, 1.0, 33), np.linspace(-1.0, 1.0, 33))
    seen = ~theirs.mask & (np.hypot(x, y) < 1.0)
    ours = pupil.wavefront.phase(np.hypot(x, y), np.arctan2(-y, side(telescope) * x))
    rest = (ours + 2.0 * math.pi * theirs.data)[seen]
    assert np.std(rest) < 1e-6
    assert np.std(ours[seen]) > 1.0


def test_rays_meet_the_sensor_at_the_gradient_of_the_phase(telescope, pupil):
    angle = np.linspace(0.0, 6.0, 12)
    x, y = 0.8 * np.cos(angle), 0.8 * np.sin(angle)
    half = 0.5 * telescope.pupilSize
    rays = pytest.importorskip("batoid").RayVector.fromStop(
        half * np.append(x, 0.0), half * np.append(y, 0.0), optic=telescope, wavelength=WAVELENGTH,
        theta_x=FIELD[0], theta_y=FIELD[1],
    )  # fmt: skip
    telescope.trace(rays)
    across, up = side(telescope) * (rays.x[:-1] - rays.x[-1]), rays.y[:-1] - rays.y[-1]
    x, y = side(telescope) * x, -y  # rows are downwards
    h = 1e-5

    def phase(dx: float, dy: float) -> np.ndarray:
        return pupil.wavefront.phase(np.hypot(x + dx, y + dy), np.arctan2(y + dy, x + dx))

    scale = pupil.scale / math.pi / (2.0 * h)
    size = np.hypot(across, up).max()
    np.testing.assert_allclose(scale * (phase(h, 0) - phase(-h, 0)), across, atol=0.03 * size)
    np.testing.assert_allclose(scale * (phase(0, h) - phase(0, -h)), -up, atol=0.03 * size)


def huygens(telescope: Any, field: tuple[float, float], places: np.ndarray) -> np.ndarray:
    """Return the intensity at places about the chief ray, rows downwards, as a sum of a plane wave for each ray.

    Rays are at 32 Gauss-Legendre nodes of the squared radius by 90 angles of the annulus, of equal flux.
    """
    least = telescope.pupilObscuration**2
    node, weight = np.polynomial.legendre.leggauss(32)
    radius = np.sqrt(0.5 * (1.0 + least + (1.0 - least) * node))
    angle = 2.0 * math.pi * (np.arange(90) + 0.5) / 90
    x, y = (0.5 * telescope.pupilSize * np.outer(radius, of(angle)).ravel() for of in (np.cos, np.sin))
    rays = pytest.importorskip("batoid").RayVector.fromStop(
        np.append(x, 0.0), np.append(y, 0.0), optic=telescope, wavelength=WAVELENGTH,
        theta_x=field[0], theta_y=field[1],
    )  # fmt: skip
    telescope.trace(rays)
    direction = rays.v[:-1] / np.linalg.norm(rays.v[:-1], axis=1, keepdims=True)
    path = rays.t[:-1] - rays.t[-1] - (direction * (rays.r[:-1] - rays.r[-1])).sum(axis=1)
    k = 2.0 * math.pi / WAVELENGTH
    across = np.exp(1j * k * np.outer(direction[:, 0], side(telescope) * places))
    down = np.exp(1j * k * np.outer(direction[:, 1], -places))
    wave = np.repeat(weight, 90) * np.exp(1j * k * path)
    return np.abs(down.T @ (wave[:, None] * across)) ** 2


def test_the_psf_is_the_sum_of_huygens_over_the_rays(telescope):
    places = 4e-7 * 6.0 * (np.arange(15) - 7)

    def error(pupil: lm.Pupil) -> float:
        found = lm.psf(pupil, 15, 4e-7 * 6.0, integrate=False).values.astype(float)
        return np.abs(found * (found * truth).sum() / (found * found).sum() - truth).max() / truth.max()

    for field, within, of_circles in (((0.0, 0.0), 1e-4, 0.0), ((0.008, 0.014), 1e-3, 1e-2)):
        truth = huygens(telescope, field, places)
        seen, circle = (
            adapter.pupil(telescope, field, wavelength=WAVELENGTH, degree=16, circular=each) for each in (False, True)
        )
        assert error(seen) < within
        assert error(circle) >= of_circles
        assert seen.circular == (field == (0.0, 0.0))


def test_obscuration_wavelength_and_f_number_are_those_of_the_telescope(telescope, pupil):
    axis = adapter.pupil(telescope, wavelength=WAVELENGTH)
    assert axis.obscuration == telescope.pupilObscuration
    # Off the axis it is an ellipse, too, of the same share.
    assert 1.0 - pupil.transmission / pupil.vignetting.b == pytest.approx(axis.obscuration**2, abs=1e-9)
    assert pupil.wavelength == WAVELENGTH
    published = {2.5: 5.0, 3.942: 2.9}[telescope.pupilSize]  # SDSS f/5, DECam f/2.9 at the corrected focus
    assert pupil.f_number == pytest.approx(published, rel=0.03)
    assert lm.psf(pupil, 33, 2e-6).error_bound < 1e-6


def test_the_map_is_that_of_single_directions(telescope):
    field = adapter.field_map(telescope, 0.004, wavelength=WAVELENGTH, circular=True)
    batoid = pytest.importorskip("batoid")
    theta = 0.003, -0.002
    ray = batoid.RayVector.fromStop(
        0.0, 0.0, optic=telescope, wavelength=WAVELENGTH, theta_x=theta[0], theta_y=theta[1]
    )
    telescope.trace(ray)
    found = field.pupil(side(telescope) * float(ray.x[0]), -float(ray.y[0]))
    rest = found.wavefront - adapter.pupil(telescope, theta, wavelength=WAVELENGTH).wavefront
    size = max(abs(float(c)) for c in found.wavefront.edge_terms().values())
    assert all(abs(float(c)) < 0.02 * size for c in rest.edge_terms().values())
    assert found.obscuration == telescope.pupilObscuration


def test_a_map_of_ellipses_has_those_of_single_directions(telescope):
    field = adapter.field_map(telescope, 0.012, wavelength=WAVELENGTH)
    ray = pytest.importorskip("batoid").RayVector.fromStop(
        0.0, 0.0, optic=telescope, wavelength=WAVELENGTH, theta_x=0.0, theta_y=0.012
    )
    telescope.trace(ray)
    found = field.pupil(side(telescope) * float(ray.x[0]), -float(ray.y[0]))
    alone = adapter.pupil(telescope, (0.0, 0.012), wavelength=WAVELENGTH)
    # In radii of different f-numbers.
    ours, theirs = (
        sorted(each / of.f_number for each in (of.vignetting.a, of.vignetting.b)) for of in (found, alone)
    )
    np.testing.assert_allclose(ours, theirs, rtol=1e-6)
    values = [lm.psf(each, 15, 2e-6).values for each in (found, alone)]
    np.testing.assert_allclose(values[0], values[1], atol=1e-4 * values[1].max())


def test_phases_that_are_tilted_against_the_rays_are_refused(telescope, monkeypatch):
    exact = ray_tracing.TracedField
    monkeypatch.setattr(ray_tracing, "TracedField", lambda x, y, phase, *rest: exact(x, y, phase + 9.0 * y, *rest))
    with pytest.raises(ValueError, match=r"phases that agree with its rays; .* differ by a tilt of 9"):
        adapter.pupil(telescope, FIELD, wavelength=WAVELENGTH)
    with pytest.raises(ValueError, match="phases that agree with its rays"):
        adapter.field_map(telescope, 0.012, wavelength=WAVELENGTH, heights=2)


def test_what_is_no_telescope_or_no_direction_is_refused(telescope):
    with pytest.raises(TypeError, match="optic must be a batoid Optic, got 5"):
        adapter.pupil(5, wavelength=WAVELENGTH)
    with pytest.raises(ValueError, match="radius must be"):
        adapter.field_map(telescope, 0.0, wavelength=WAVELENGTH)
    with pytest.raises(ValueError, match=r"wavelength is in metres"):
        adapter.pupil(telescope, wavelength=620)
    with pytest.raises(ValueError, match="degree must be higher"):
        adapter.pupil(telescope, FIELD, wavelength=WAVELENGTH, degree=2)
