"""Pictures of pupils and rays."""

from __future__ import annotations

import math

import numpy as np
import pytest

import lommel as lm
from lommel.show import plot
from lommel.show.pupils import pupil_maps
from objectives import OIL

WAVEFRONT = lm.Wavefront(2.0, nonradial={(3, 1): 1.5})
METRIC = {"wavelength": 500e-9, "f_number": 4.0}


def drawn(axes) -> np.ndarray:
    (image,) = axes.get_images()
    return np.ma.filled(image.get_array().astype(float), np.nan)


def raster(values) -> tuple[np.ndarray, np.ndarray]:
    at = (np.arange(values.shape[0]) + 0.5) * (2.0 / values.shape[0]) - 1.0
    return np.meshgrid(at, at)


@pytest.mark.parametrize(
    ("unit", "radians"), [("waves", 2.0 * math.pi), ("radians", 1.0), ("nm", 2.0 * math.pi / 500.0)]
)
def test_the_phase_is_that_of_the_wavefront_less_its_mean_in_the_unit(unit, radians):
    axes = lm.Pupil(WAVEFRONT, obscuration=0.4, **METRIC).plot(unit=unit)
    values = drawn(axes)
    x, y = raster(values)
    rho = np.hypot(x, y)
    clear = (rho <= 1.0) & (rho >= 0.4)
    np.testing.assert_array_equal(np.isfinite(values), clear)
    truth = WAVEFRONT.phase(rho[clear], np.arctan2(y, x)[clear])
    np.testing.assert_allclose(radians * values[clear], truth - truth.mean(), atol=1e-10)
    (image,) = axes.get_images()
    assert image.get_extent() == [-1, 1, 1, -1]  # y rises downwards
    assert image.norm.vmin == -image.norm.vmax == -np.nanmax(np.abs(values))
    assert axes.figure.axes[1].get_ylabel() == f"phase minus its mean ({unit})"
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (pupil radii)", "y (pupil radii)")
    spread = np.nanmax(values) - np.nanmin(values)
    rms = lm.rms(lm.Pupil(WAVEFRONT, obscuration=0.4)) / radians
    assert axes.get_title() == f"rms {rms:.3g} {unit}, peak to valley {spread:.3g} {unit}"
    axes.figure.canvas.draw()


def test_a_wavefront_is_drawn_over_the_full_disc_and_its_stack_on_one_scale():
    values = drawn(WAVEFRONT.plot(unit="radians"))
    x, y = raster(values)
    np.testing.assert_array_equal(np.isfinite(values), np.hypot(x, y) <= 1.0)
    stack = lm.Wavefront(np.array([[0.0, 1.0], [2.0, 3.0]]), spherical=1.0)
    axes = stack.plot()
    assert axes.shape == (2, 2)
    assert [each.get_title() for each in axes.flat] == [f"W020 {k / math.pi:.3g} waves" for k in range(4)]
    tops = {each.get_images()[0].norm.vmax for each in axes.flat}
    assert tops == {max(np.nanmax(np.abs(drawn(each))) for each in axes.flat)}
    np.testing.assert_allclose(
        drawn(axes[1, 1]), pupil_maps(lm.Pupil(stack[1, 1])).phase[0] / (2 * math.pi), atol=1e-12
    )


def test_the_amplitude_is_that_of_apodization_and_mask_and_nothing_where_light_is_blocked():
    rows, columns = np.mgrid[:8, :8]
    mask = lm.Mask(0.25 + 0.5 * ((rows + columns) % 2))
    pupil = lm.Pupil(apodization=0.5, mask=mask, spider=lm.Spider.equal(3, width=0.1), obscuration=0.2)
    axes = pupil.plot(what="amplitude")
    values = drawn(axes)
    x, y = raster(values)
    truth = np.abs(pupil.values(x, y))[0]
    np.testing.assert_allclose(np.nan_to_num(values), truth, atol=1e-12)
    np.testing.assert_array_equal(np.isnan(values), truth == 0.0)
    assert axes.get_images()[0].get_clim() == (0.0, 1.0)
    assert (
        axes.get_title()
        == f"amplitude (1 = clear); transmits {100 * pupil.transmission:.3g} % of the light of a clear disc"
    )


def test_the_phase_through_layers_changes_with_the_focus_as_the_immersion_says():
    z = np.array([-1e-6, 0.0, 1e-6])
    pupil = OIL.pupil(depth=0.0, z=z, wavelength=520e-9)
    axes = pupil.plot(unit="radians")
    assert [each.get_title() for each in axes] == ["z −1 µm", "z 0 µm", "z 1 µm"]
    up, flat, down = (drawn(each) for each in axes)
    np.testing.assert_allclose(up - flat, flat - down, atol=1e-9, equal_nan=True)
    x, y = raster(flat)
    axial = np.sqrt(1.518**2 - np.minimum(1.4 * np.hypot(x, y), 1.4) ** 2) * 2.0 * math.pi / 520e-9 * 1e-6
    moved = np.abs(down - flat)
    clear = np.isfinite(flat)
    np.testing.assert_allclose(moved[clear], np.abs(axial - axial[clear].mean())[clear], atol=1e-9)


def test_light_beyond_the_critical_angle_fades_with_the_depth_and_a_circle_says_where():
    pupil = OIL.pupil(depth=[0.0, 1e-6], z=0.0, wavelength=520e-9)
    near, far = pupil.plot(what="amplitude")
    assert [each.get_title() for each in (near, far)] == ["depth 0 µm", "depth 1 µm"]
    x, y = raster(drawn(near))
    below, beyond = np.hypot(x, y) < 0.94, (np.hypot(x, y) > 0.96) & (np.hypot(x, y) < 1.0)
    np.testing.assert_allclose(drawn(near)[below], drawn(far)[below])
    fades = np.exp(-np.sqrt(np.maximum((1.4 * np.hypot(x, y)) ** 2 - 1.33**2, 0.0)) * 2.0 * math.pi / 0.52)
    np.testing.assert_allclose((np.nan_to_num(drawn(far)) / drawn(near))[beyond], fades[beyond], atol=1e-9)
    (circle,) = near.get_lines()
    np.testing.assert_allclose(np.hypot(*circle.get_data()), 1.33 / 1.4)


def test_the_measured_wavefront_of_an_objective_is_added():
    plain = OIL.pupil(depth=0.0, z=0.0, wavelength=520e-9)
    coma = lm.Wavefront.zernike({(3, 1): 0.3})
    with_it = OIL.pupil(depth=0.0, z=0.0, wavelength=520e-9, aberrations=coma)
    added = pupil_maps(with_it).phase[0] - pupil_maps(plain).phase[0]
    x, y = raster(added)
    clear = np.isfinite(added)
    truth = coma.phase(np.hypot(x, y)[clear], np.arctan2(y, x)[clear])
    np.testing.assert_allclose(added[clear], truth - truth.mean(), atol=1e-9)


def test_marginal_rays_and_those_of_the_edge_of_an_obscuration_are_among_them():
    pupil = lm.Pupil(lm.Wavefront.from_seidel(W020=-1.0, W040=2.0), obscuration=0.35)
    radius = np.hypot(*plot.ray_positions(pupil, 7).T)
    for rho in (0.35, 1.0):  # 2 dW/drho, lambda*N
        assert np.abs(radius - abs(2 * (-2.0 * rho + 8.0 * rho**3))).min() == pytest.approx(0, abs=1e-9)
    far = lm.Pupil(lm.Wavefront.from_seidel(W040=2.0))
    assert np.hypot(*plot.ray_positions(far).T).max() == pytest.approx(16.0)


def test_a_tilt_moves_all_of_them_to_higher_columns_in_metres():
    tilt = lm.Wavefront(nonradial={(1, 1): 2.0})
    at = plot.ray_positions(lm.Pupil(tilt, **METRIC), 3)
    np.testing.assert_allclose(at, np.broadcast_to([2.0 / math.pi * 2e-6, 0.0], at.shape), atol=1e-15)


@pytest.mark.parametrize("options", [{}, {"obscuration": 0.4}, {"vignetting": lm.Ellipse(0.8, 0.6)}], ids=str)
def test_their_rms_radius_is_that_of_all_rays(options):
    pupil = lm.Pupil(lm.Wavefront(1.0, 0.5, nonradial={(3, 1): 1.0, (2, 2): -0.7}), **options)
    at = plot.ray_positions(pupil, 60)
    away = at - at.mean(axis=0)
    assert math.sqrt((away**2).sum(axis=1).mean()) == pytest.approx(float(lm.spot_radius(pupil)), rel=0.02)
    np.testing.assert_allclose(at.mean(axis=0), lm.centroid(pupil), atol=0.02)


def test_rays_that_are_stopped_do_not_count():
    flat = lm.Wavefront(1.0)
    whole = len(plot.ray_positions(lm.Pupil(flat), 10))
    assert len(plot.ray_positions(lm.Pupil(flat, obscuration=0.5), 10)) < 0.85 * whole
    half = lm.Mask(np.repeat([[1.0, 0.0]], 2, axis=0))
    at = plot.ray_positions(lm.Pupil(flat, mask=half), 10)
    assert 0.45 * whole < len(at) < 0.55 * whole
    assert at[:, 0].max() <= 1e-6
