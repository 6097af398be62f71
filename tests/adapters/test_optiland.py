"""A Cooke triplet of optiland: rays, focus and PSF agree with the pupils made of it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import lommel as lm
from lommel.adapters import optiland as adapter

# What optiland and what it imports warn of is not ours.
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(scope="module")
def triplet() -> Any:
    """f/5, 20 degrees of field, millimetres."""
    return pytest.importorskip("optiland.samples.objectives").CookeTriplet()


def slope(pupil: lm.Pupil, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where rays through the pupil meet the sensor: the gradient of the phase, metres."""
    h = 1e-5

    def phase(dx: float, dy: float) -> np.ndarray:
        return pupil.wavefront.phase(np.hypot(x + dx, y + dy), np.arctan2(y + dy, x + dx))

    scale = pupil.scale / math.pi / (2.0 * h)
    return scale * (phase(h, 0) - phase(-h, 0)), scale * (phase(0, h) - phase(0, -h))


@pytest.mark.parametrize(("field", "within"), [((0.0, 0.0), 0.003), ((0.0, 0.7), 0.06), ((0.4, 0.5), 0.06)])
def test_rays_meet_the_sensor_at_the_gradient_of_the_phase(triplet, field, within):
    angle = np.linspace(0.0, 6.0, 12)
    for radius in (0.3, 0.9):
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        traced = [triplet.trace_generic(*field, Px=a, Py=b, wavelength=0.55) for a, b in zip(x, y, strict=True)]
        chief = triplet.trace_generic(*field, Px=0.0, Py=0.0, wavelength=0.55)
        across = 1e-3 * np.array([float(ray.x[0] - chief.x[0]) for ray in traced])
        up = 1e-3 * np.array([float(ray.y[0] - chief.y[0]) for ray in traced])
        found = slope(adapter.pupil(triplet, field, wavelength=550e-9), x, -y)
        size = np.hypot(across, up).max()
        # Off the axis the two directions have f-numbers of their own, 3 % either way of the mean.
        np.testing.assert_allclose(found[0], across, atol=within * size)
        np.testing.assert_allclose(found[1], -up, atol=within * size)


def test_a_sensor_nearer_to_the_lens_has_a_higher_defocus(triplet):
    before = adapter.pupil(triplet)
    nearer = type(triplet)()
    gap = float(nearer.surfaces.get_thickness(nearer.surfaces.num_surfaces - 2)[0])
    nearer.set_thickness(gap - 0.05, nearer.surfaces.num_surfaces - 2)
    after = adapter.pupil(nearer)
    by_hand = math.pi * 50e-6 / (8 * 550e-9 * 4.98**2)
    balanced = float(after.wavefront.edge_terms()[2, 0] - before.wavefront.edge_terms()[2, 0])
    # The Zernike term is C_d; the sphere's own rho^4 is 1 % of it at f/5.
    assert balanced == pytest.approx(by_hand, rel=0.02)


@pytest.mark.parametrize("field", [(0.0, 0.0), (0.0, 0.7), (0.3, 0.6), (0.0, 1.0)])
def test_the_psf_is_theirs_with_y_upwards(triplet, field):
    psf = pytest.importorskip("optiland.psf").FFTPSF(triplet, field, "primary", num_rays=128, grid_size=1024)
    theirs = np.asarray(psf.psf)[480:545, 480:545][::-1] / 100.0
    pupil = adapter.pupil(triplet, field)
    # Samples of theirs are lambda N (rays - 1) / grid apart.
    ours = lm.psf(
        pupil, 65, pupil.scale * 127 / 1024, method=lm.Fraunhofer(samples=512, edge="grey"), normalize="strehl"
    )
    # They count 128 samples across the pupil, an edge of one of them: 2 %.
    assert np.abs(ours.values - theirs).max() < 0.02 * theirs.max()
    assert np.abs(ours.values[::-1] - theirs).max() > 0.1 * theirs.max() or field == (0.0, 0.0)
    assert psf.strehl_ratio() == pytest.approx(float(ours.values.max()), rel=0.02)


def test_the_map_is_exact_where_it_was_traced_and_close_in_between(triplet):
    field = adapter.field_map(triplet, heights=9)
    assert field.pupil_without_wavefront.f_number == pytest.approx(4.98, abs=0.005)
    assert field.pupil_without_wavefront.wavelength == pytest.approx(550e-9)
    for hx, hy, within in [(0.0, 0.5, 1e-6), (0.0, 1.0, 1e-6), (0.0, 0.7, 0.02), (0.3, 0.4, 0.02), (-0.5, 0.1, 0.02)]:
        chief = triplet.trace_generic(hx, hy, Px=0.0, Py=0.0, wavelength=0.55)
        found = field.pupil(1e-3 * float(chief.x[0]), -1e-3 * float(chief.y[0])).wavefront
        rest = found - adapter.pupil(triplet, (hx, hy)).wavefront
        for term, c in rest.edge_terms().items():
            assert abs(float(c)) < within, (hx, hy, term)


def test_fields_that_are_named_are_traced_instead(triplet):
    points = [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)]
    field = adapter.field_map(triplet, fields=points)
    chief = triplet.trace_generic(0.5, 0.5, Px=0.0, Py=0.0, wavelength=0.55)
    found = field.pupil(1e-3 * float(chief.x[0]), -1e-3 * float(chief.y[0])).wavefront
    rest = found - adapter.pupil(triplet, (0.5, 0.5)).wavefront
    assert all(abs(float(c)) < 1e-8 for c in rest.edge_terms().values())


def test_what_is_no_lens_or_no_wavelength_is_refused(triplet):
    with pytest.raises(TypeError, match="optic must be an optiland Optic, got 5"):
        adapter.pupil(5)
    with pytest.raises(ValueError, match=r"wavelength is in metres .* for 550 nm give 550e-9"):
        adapter.pupil(triplet, wavelength=550)
    with pytest.raises(ValueError, match="degree must be higher: Zernike terms up to 2 leave"):
        adapter.pupil(triplet, degree=2)


def test_vignetting_is_refused(triplet):
    lens = type(triplet)()
    lens.fields.fields[-1].vy = 0.2
    with pytest.raises(ValueError, match=r"the field \(0, 1\) has vignetting factors"):
        adapter.pupil(lens, (0.0, 1.0))


def test_without_optiland_the_package_to_install_is_named(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "optiland.optic", None)
    with pytest.raises(ImportError, match="pip install optiland"):
        adapter.pupil(None)
