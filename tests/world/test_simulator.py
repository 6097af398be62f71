"""The simulated world is right, by closed forms alone, and shares nothing with the package that it judges."""

from __future__ import annotations

import ast
from pathlib import Path

import numpy as np
import pytest
from scipy.special import j0, j1

from tests.world import air, camera, optics, scene, stage

HERE = Path(__file__).parent
SIMULATOR = ("optics", "air", "scene", "camera", "stage")


@pytest.mark.parametrize("name", SIMULATOR)
def test_the_simulator_imports_nothing_of_lommel_nor_of_its_tests(name):
    tree = ast.parse((HERE / f"{name}.py").read_text(encoding="utf-8"))
    imported = [
        alias.name if isinstance(node, ast.Import) else node.module
        for node in ast.walk(tree)
        if isinstance(node, ast.Import | ast.ImportFrom)
        for alias in node.names
    ]
    own = {f"tests.world.{other}" for other in SIMULATOR}
    assert all(one in own or one.split(".")[0] not in ("lommel", "tests") for one in imported)
    assert all("." not in one or one in own or one.startswith(("scipy", "collections")) for one in imported)


def points(transfer, y, x):
    """Light per area at points: that of pixels which are points."""
    step = transfer.frequency[1]
    down, across = (np.exp(-2j * np.pi * np.outer(at, transfer.frequency)) * step for at in (y, x))
    return (down @ transfer.values @ across.T).real


@pytest.mark.parametrize("obscuration", [0.0, 0.35])
def test_a_telescope_s_image_is_that_of_airy(obscuration):
    r = np.linspace(0, 12, 97)
    v = np.pi * np.maximum(r, 1e-9)
    amplitude = 2 * (j1(v) - obscuration * j1(obscuration * v)) / v
    exact = np.pi / 4 * amplitude**2 / (1 - obscuration**2)
    found = points(optics.Telescope(obscuration=obscuration).transfer(), r, np.zeros(1))[:, 0]
    assert np.abs(found - exact).max() < 1e-4 * exact[0]


def test_vanes_take_light_and_coherent_amplitude():
    plain, crossed = optics.Telescope(obscuration=0.3), optics.Telescope(obscuration=0.3, vanes=0.05)
    open_area = np.pi * (1 - 0.09)
    # Four strips from the obscuration to the rim; the ends are arcs.
    vanes = 4 * 0.05 * 0.7
    on_axis = [points(one.transfer(), np.zeros(1), np.zeros(1))[0, 0] for one in (plain, crossed)]
    assert on_axis[1] / on_axis[0] == pytest.approx(1 - vanes / open_area, abs=1e-3)


def test_defocus_on_the_axis_is_a_squared_sinc():
    telescope, peak = optics.Telescope(side=192), np.pi / 4
    for defocus in (1.0, 3.0, 2 * np.pi):
        found = points(telescope.transfer(defocus=defocus), np.zeros(1), np.zeros(1))[0, 0]
        assert found == pytest.approx(peak * np.sinc(defocus / 2 / np.pi) ** 2, abs=1e-4 * peak)


def test_zernike_terms_are_orthonormal_and_their_light_is_all_there():
    weight, rho, theta = optics.aperture(256)
    terms = np.array([optics.zernike(j, rho, theta) for j in range(2, 23)])
    products = np.einsum("ayx,byx,yx->ab", terms, terms, weight) / weight.sum()
    assert np.abs(products - np.eye(21)).max() < 2e-3
    plain, bent = optics.Telescope().transfer(), optics.Telescope().transfer(((4, 0.5), (8, 0.4)))
    # Parseval over a period, but for the light of the grey rim, which is farther away.
    assert bent.image(128, 1.0, 63.5, 63.5).sum() == pytest.approx(plain.values[0, 0].real, rel=1e-9)
    assert plain.values[0, 0].real == pytest.approx(1.0, abs=1e-2)
    near = np.hypot(*np.mgrid[-80:81, -80:81]) * 0.1 < 7.74
    v = np.pi * 7.74
    assert plain.image(161, 0.1, 80, 80)[near].sum() == pytest.approx(1 - j0(v) ** 2 - j1(v) ** 2, abs=1e-3)


def test_a_zernike_tilt_moves_the_image():
    size, telescope = 0.8, optics.Telescope()
    still = telescope.transfer().image(41, 0.5, 20, 20)
    # 2 a rho cos(theta) is a shift by 2 a / pi of lambda N, against the sign of its transform.
    moved = telescope.transfer(((2, size),)).image(41, 0.5, 20, 20 - 2 * size / np.pi / 0.5)
    back = telescope.transfer(((2, size),)).image(41, 0.5, 20, 20 + 2 * size / np.pi / 0.5)
    assert min(np.abs(one - still).max() for one in (moved, back)) < 1e-4 * still.max()


def test_dipoles_at_one_index_have_the_light_on_the_axis_of_a_closed_form():
    alike = optics.Objective(NA=1.2, immersion=1.5, glass=1.5, sample=1.5, side=192)
    cos = np.sqrt(1 - (1.2 / 1.5) ** 2)
    # Dipoles along and across the axis; the integral of the light over the cap is that of Parseval.
    across = (1.5 / 1.2) ** 2 * (2 / 3 * (1 - cos**1.5) + 2 / 5 * (1 - cos**2.5))
    cap = (1.5 / 1.2) ** 2 * (2 * (1 - cos) + 2 / 3 * (1 - cos**3) + 2 * ((1 - cos) - (1 - cos**3) / 3))
    scale = alike.wavenumber * alike.NA
    exact = across**2 / (2 * np.pi / scale**2 * cap)
    assert alike.profile(np.zeros(1), 0.0, [0.0])[0, 0] == pytest.approx(exact, rel=1e-9)
    assert points(alike.transfer(0.0, 0.0), np.zeros(1), np.zeros(1))[0, 0] == pytest.approx(exact, rel=1e-4)


def test_a_dipole_through_a_small_aperture_is_that_of_airy():
    small = optics.Objective(NA=0.05, immersion=1.0, glass=1.0, sample=1.0)
    r = np.linspace(0, 20e-6, 50)
    v = np.maximum(small.wavenumber * 0.05 * r, 1e-9)
    exact = (small.wavenumber * 0.05) ** 2 / (4 * np.pi) * (2 * j1(v) / v) ** 2
    assert np.abs(small.profile(r, 0.0, [0.0])[0] - exact).max() < 2e-3 * exact[0]


def test_both_ways_to_a_dipole_under_layers_agree_and_all_light_is_there():
    oil = optics.Objective(side=160)
    r = np.linspace(0, 1.2e-6, 25)
    for depth, focus in ((0.3e-6, 0.2e-6), (1e-6, 1.5e-6)):
        rings = oil.profile(r, depth, [focus])[0]
        grid = points(oil.transfer(depth, focus), r, np.zeros(1))[:, 0]
        assert np.abs(grid / grid[0] - rings / rings[0]).max() < 3e-4
        assert grid[0] == pytest.approx(rings[0], rel=2e-3)
    wide = oil.transfer(0.3e-6, 0.2e-6).image(255, 0.1e-6, 127, 127)
    assert wide.sum() == pytest.approx(1.0, abs=4e-3)


def test_refraction_passes_the_light_that_fresnel_s_equations_pass():
    oil = optics.Objective()
    s, p, c_oil, c_water = (one[0] for one in oil.amplitudes(np.zeros(1), 0.0))
    t = 2 * 1.33 / (1.33 + 1.5255) * 2 * 1.5255 / (1.5255 + 1.518)
    assert (s, p, c_oil, c_water) == pytest.approx((t, t, 1.0, 1.0))


def test_a_ball_is_as_wide_as_its_second_moment():
    small = optics.Objective(NA=0.3, immersion=1.0, glass=1.0, sample=1.0)
    diameter = 1e-6
    ratio = scene.ball(small, diameter, 0.0, 0.0).values / small.transfer(0.0, 0.0).values
    f = small.transfer(0.0, 0.0).frequency[1]
    # A projected ball: 1 - (2 pi f)^2 R^2 / 10.
    assert 1 - ratio[0, 1].real == pytest.approx((2 * np.pi * f * diameter / 2) ** 2 / 10, rel=0.05)


def test_the_air_has_the_limits_of_its_families():
    f = np.linspace(1e-3, 1.5, 60)
    assert np.abs(air.von_karman(f, 1.0, 1e7) - air.kolmogorov(f, 1.0)).max() < 2e-2
    assert (air.von_karman(f, 1.0, 60.0) > air.kolmogorov(f, 1.0)).all()
    r = np.arange(0, 60, 0.002)
    for transfer, half in ((air.kolmogorov(f, 2.0), 1.0), (air.moffat(f, 2.0, 3.0), 1.0)):
        light = [np.trapezoid(transfer * j0(2 * np.pi * f * at) * f, f) for at in (0.0, half)]
        assert light[1] / light[0] == pytest.approx(0.5, abs=6e-3)
    profile = (1 + (r / 2) ** 2) ** -3.0
    exact = [np.trapezoid(profile * r * j0(2 * np.pi * at * r), r) for at in (0.0, 0.1, 0.3)]
    fwhm = 4 * np.sqrt(2 ** (1 / 3) - 1)
    assert air.moffat(np.array([0.1, 0.3]), fwhm, 3.0) == pytest.approx(np.array(exact[1:]) / exact[0], abs=1e-4)
    assert air.tracking(np.zeros(1), np.array([0.5]), 2.0, 0.0)[0] == pytest.approx(0.0)


def test_phase_screens_have_kolmogorov_s_structure_function():
    made = air.screens(32, 3.0, 200, np.random.default_rng(1))
    for apart in (4, 10, 20):
        found = ((made[:, apart:] - made[:, :-apart]) ** 2).mean()
        assert found == pytest.approx(6.88 * (3.0 * apart / 32) ** (5 / 3), rel=0.1)


def test_a_camera_counts_as_its_noise_says():
    flat = np.full((200, 200), 50.0)
    counts = camera.Camera().record(flat, 1).astype(float)
    electrons = (counts - 100) * 0.46
    assert electrons.mean() == pytest.approx(50, abs=0.2)
    assert electrons.var() == pytest.approx(50 + 1.6**2 + 0.46**2 / 12, rel=0.03)
    doubled = camera.Camera(gain=0.01, register=300.0, read=0.2).record(flat, 2) * 0.01
    assert doubled.var() == pytest.approx(100, rel=0.04)
    full = camera.Camera(gain=0.0, read=0.0, full=60.0, bloom=0.5)
    spilled = np.zeros((9, 9))
    spilled[4, 4] = 1000.0
    image = full.record(spilled, 3)
    assert image.max() == 60
    assert image[3, 4] == 60
    assert image[4, 3] == 0
    bent = camera.Camera(gain=0.0, read=0.0, full=1e4, bend=0.1).record(np.full((50, 50), 5000.0), 4)
    assert bent.mean() == pytest.approx(4750, rel=1e-2)
    rows = camera.Camera(gain=0.0, read=0.0, rows=5.0).record(np.zeros((500, 4)), 5)
    assert np.ptp(rows, axis=1).max() == 0
    assert rows[:, 0].std() == pytest.approx(5.0, rel=0.1)
    rays = camera.Camera(gain=0.0, read=0.0, rays=20.0).record(np.zeros((3, 64, 64)), 6)
    assert 0 < (rays > 0).mean() < 0.05
    warm = camera.hot((100, 100), 0.01, 7)
    assert (warm > 0).mean() == pytest.approx(0.01, abs=0.003)
    dead = camera.Camera(gain=0.0, read=0.0, dead=warm > 0).record(np.full((100, 100), 1e3), 8)
    assert ((dead == 0) == (warm > 0)).all()
    assert camera.scientific((20, 30), 9).record(np.zeros((2, 20, 30)), 1).shape == (2, 20, 30)


def test_a_stage_drifts_walks_and_turns():
    assert stage.positions(5, 2.0).tolist() == [-4, -2, 0, 2, 4]
    assert stage.positions(500, 0.0, jitter=3.0).std() == pytest.approx(3.0, rel=0.1)
    assert stage.drift(3, row=0.5, column=-1.0).tolist() == [[-0.5, 1.0], [0, 0], [0.5, -1.0]]
    assert np.diff(stage.drift(400, walk=2.0), axis=0).std() == pytest.approx(2.0, rel=0.1)
    assert stage.backwards(np.arange(3)).tolist() == [2, 1, 0]


def test_a_volume_is_the_sum_of_its_points_each_from_its_own_depth():
    oil = optics.Objective(wavelength=520e-9)
    focus = oil.brightest(5e-6)
    foci = focus + np.array([-0.5e-6, 0.0, 0.5e-6])
    made = scene.volume(oil, [(10.0, 9.0, 5e-6, 100.0)], foci, 21, 0.1e-6)
    assert made[1].argmax() == 10 * 21 + 9
    assert made[1].max() > made[[0, 2]].max()
    assert 50 < made[1].sum() < 100


def test_layers_hide_each_other_and_blur_keeps_light():
    shape = (16, 24)
    near, far = scene.texture(shape, 0.7, 1), scene.texture(shape, 0.7, 2)
    cover = np.zeros(near.shape, dtype=bool)
    cover[:, : near.shape[1] // 2] = True

    def sharp(down, across):
        return np.ones(np.broadcast(down, across).shape)

    def soft(down, across):
        return optics.disc(1.5, np.hypot(down, across))

    whole = np.ones_like(cover)
    seen = scene.photograph([(near, cover, sharp), (far, whole, sharp)])
    alone = [scene.photograph([(one, whole, sharp)]) for one in (near, far)]
    assert np.abs(seen[:, :12] - alone[0][:, :12]).max() < 1e-12
    assert np.abs(seen[:, 12:] - alone[1][:, 12:]).max() < 1e-12
    blurred = scene.photograph([(near, whole, soft)])
    assert blurred.mean() == pytest.approx(alone[0].mean())
    assert blurred.std() < 0.8 * alone[0].std()
