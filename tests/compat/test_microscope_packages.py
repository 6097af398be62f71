"""Microscope PSFs with the signatures of other packages, beside quadrature, and beside these where they are there."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.compat import microscpsf, psfmodels, pyotf

# What the packages, and what these import, warn of is not ours.
pytestmark = pytest.mark.filterwarnings("ignore")


def gibson_lanni(radii, zv, pz, wvl, of):
    """The integral of Gibson and Lanni (1992), by Gauss-Legendre quadrature: (planes, radii), micrometres."""
    from scipy.special import j0

    most = min(1.0, of["ns"] / of["NA"])
    node, weight = np.polynomial.legendre.leggauss(600)
    # Nodes in the square root of the distance from the critical angle, where the phase has one.
    s = 0.5 * (node + 1.0)
    rho = most * (1.0 - s * s)
    weight = most * s * weight
    k, p = 2.0 * np.pi / wvl, of["NA"] * rho

    def path(n, t):
        return t * np.sqrt(n * n - p * p)

    layers = path(of["ns"], pz) - path(of["ni0"], of["ti0"])
    layers = layers + path(of["ng"], of["tg"]) - path(of["ng0"], of["tg0"])
    phase = k * (layers + path(of["ni"], of["ti0"] + np.asarray(zv)[:, None]))
    kernel = j0(k * of["NA"] * rho * np.asarray(radii)[:, None]) * rho * weight
    return np.abs(np.exp(1j * phase) @ kernel.T) ** 2


@pytest.mark.parametrize("changes", [{}, {"NA": 1.2, "tg": 176.0, "ni": 1.512}, {"NA": 0.9, "tg": 0.0, "tg0": 0.0}])
def test_profiles_of_microscpsf_are_the_integral_of_gibson_and_lanni(changes):
    of = microscpsf.m_params | changes
    radii, zv = np.linspace(0.0, 1.2, 7), np.array([-1.0, -0.3, 0.4])
    found = microscpsf.gLZRFocalScan(of, radii, zv, normalize=False, pz=0.8, wvl=0.55)
    right = gibson_lanni(radii, zv, 0.8, 0.55, of)
    np.testing.assert_allclose(found, right, rtol=0.0, atol=1e-8 * right.max())


@pytest.mark.parametrize("side", [8, 9])
def test_windows_of_microscpsf_hold_the_profile_about_their_middle(side):
    zv, along = np.array([-0.5, 0.0]), (np.arange(side) - 0.5 * (side - 1)) * 0.1
    found = microscpsf.gLXYZFocalScan(microscpsf.m_params, 0.1, side, zv, normalize=False, pz=0.3)
    right = gibson_lanni(np.hypot(along, along[:, None]).ravel(), zv, 0.3, 0.6, microscpsf.m_params)
    np.testing.assert_allclose(found.reshape(2, -1), right, rtol=0.0, atol=1e-8 * right.max())
    scan = microscpsf.gLXYZParticleScan(microscpsf.m_params, 0.1, side, [0.3, 0.6], normalize=False, zv=-0.5)
    np.testing.assert_allclose(scan[0], found[0], rtol=0.0, atol=1e-12)
    assert microscpsf.gLXYZFocalScan(microscpsf.m_params, 0.1, side, zv).max() <= 1.0


def test_the_scalar_model_of_psfmodels_is_the_same_integral_with_supercritical_light_added():
    # Below the index of the sample there is none.
    of = psfmodels.PARAMS | {"NA": 1.2, "ns": 1.33, "tg": 174.0}
    z = np.array([0.0, 1.0, 2.5])
    found = psfmodels.scalar_psf(z, 9, 0.08, 1.0, 0.5, {**of, "sf": 1})
    along = 0.08 * (np.arange(9) - 4)
    # Its z counts from the paraxial focus at the cover glass, less what the sample changes.
    clearance = of["ni"] * (of["tg0"] / of["ng0"] + of["ti0"] / of["ni0"] - of["tg"] / of["ng"]) - of["ti0"]
    stage = clearance - (1.0 * of["ni"] / of["ns"] + z - 1.0)
    right = gibson_lanni(np.hypot(along, along[:, None]).ravel(), stage, 1.0, 0.5, of).reshape(3, 9, 9)
    np.testing.assert_allclose(found, right / right.max(), rtol=0.0, atol=3e-6)


def test_psfmodels_of_many_samples_a_pixel_becomes_the_average_over_pixels():
    # 2 x 2 subpixels sampled at their centres, with the error of the midpoint rule quartered each time.
    whole = psfmodels.make_psf([0.4], 5, dxy=0.12, pz=0.4, normalize=False)
    errors = []
    for times in (4, 8):
        fine = psfmodels.make_psf(
            [0.4], 5 * times + 1, dxy=0.12 / times, pz=0.4, oversample_factor=1, normalize=False
        )
        samples = fine[0]
        mean = 0.25 * (samples[:-1, :-1] + samples[1:, :-1] + samples[:-1, 1:] + samples[1:, 1:])
        total = mean.reshape(5, times, 5, times).sum(axis=(1, 3))
        errors.append(np.abs(total - whole[0]).max() / whole.max())
    assert errors[1] < 0.3 * errors[0] < 0.01


def test_a_number_of_planes_is_centred_on_the_point():
    stack = psfmodels.make_psf(5, 7, dz=0.2, pz=1.0)
    named = psfmodels.make_psf([0.6, 0.8, 1.0, 1.2, 1.4], 7, pz=1.0)
    np.testing.assert_allclose(stack, named, rtol=0.0, atol=1e-12)
    np.testing.assert_array_equal(stack, psfmodels.vectorial_psf_centered(5, 0.2, pz=1.0, nx=7))
    flat = psfmodels.scalar_psf_centered(3, 0.2, pz=1.0, nx=7)
    np.testing.assert_array_equal(flat, psfmodels.make_psf(3, 7, dz=0.2, pz=1.0, model="scalar"))
    assert stack.shape == (5, 7, 7)
    assert stack.max() == 1.0
    assert psfmodels.make_psf(1, 4)[0].argmax() == 5  # pixel (1, 1) of an even window


def test_hanser_is_the_debye_integral_of_scalar_light():
    # One medium: int exp(i k n z cos) cos^(-1/2) J0(k NA rho r) rho drho, squared.
    from scipy.special import j0

    found = pyotf.HanserPSF(520.0, 0.85, 1.33, 100.0, 9, zrange=[-900.0, 0.0, 500.0]).PSFi
    node, weight = np.polynomial.legendre.leggauss(80)
    rho, weight = 0.5 * (node + 1.0), 0.5 * weight
    k, cosine = 2.0 * np.pi / 520.0, np.sqrt(1.0 - (0.85 * rho / 1.33) ** 2)
    along = 100.0 * (np.arange(9) - 4)
    kernel = j0(k * 0.85 * rho * np.hypot(along, along[:, None]).ravel()[:, None]) * rho * weight / np.sqrt(cosine)
    right = np.abs(np.exp(1j * k * 1.33 * cosine * np.array([[-900.0], [0.0], [500.0]])) @ kernel.T) ** 2
    np.testing.assert_allclose(found.reshape(3, -1) / found.max(), right / right.max(), rtol=0.0, atol=3e-6)


def test_hanser_transforms_and_vectorial_light():
    free = pyotf.HanserPSF(520.0, 0.9, 1.33, 80.0, 33, 250.0, 7, "total")
    assert free.PSFi.shape == (7, 33, 33)
    assert free.PSFi[4].max() == free.PSFi.max()  # (7 + 1) // 2 planes are before it
    middle = free.OTFi[3, 16, 16]
    np.testing.assert_allclose(middle, free.PSFi.sum(), rtol=1e-12)
    x, y = (pyotf.HanserPSF(520.0, 0.9, 1.33, 80.0, 33, 250.0, 7, name).PSFi for name in "xy")
    np.testing.assert_allclose(x, y.transpose(0, 2, 1), rtol=0.0, atol=1e-6 * x.max())
    assert np.abs(x - y).max() > 1e-3 * x.max()


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: psfmodels.make_psf(model="gaussian"), "model must be"),
        (lambda: psfmodels.make_psf(NA=1.6), "NA must be below the index of immersion"),
        (lambda: psfmodels.vectorial_psf(params={"Na": 1.4}), "params must be"),
        (lambda: psfmodels.vectorial_psf(params={"mode": 0}), "mode must be 1"),
        (lambda: psfmodels.make_psf(pz=-1.0), "pz must be"),
        (lambda: psfmodels.make_psf(0), "z must be"),
        (lambda: psfmodels.make_psf([np.nan]), "zv"),
        (lambda: microscpsf.gLXYZFocalScan({"na": 1.4}, 0.1, 5, [0.0]), "mp must be"),
        (lambda: microscpsf.gLXYZFocalScan({}, 0.1, 5, [0.0], zd=1e5), "zd must be the tube length 200000"),
        (lambda: microscpsf.gLZRFocalScan({}, [-1.0], [0.0]), "rv must be"),
        (lambda: pyotf.HanserPSF(520, 1.4, 1.33, 60, 9).PSFi, "NA must be below"),
        (lambda: pyotf.HanserPSF(520, 0.8, 1.33, 60, 9, vec_corr="xy"), "vec_corr must be"),
        (lambda: pyotf.HanserPSF(520, 0.8, 1.33, 60, 9, vec_corr="x", condition="none"), "condition must be"),
    ],
)
def test_bad_arguments_are_named(call, said):
    with pytest.raises(ValueError, match=said):
        call()


# Their own errors, as docs/microscopes-peers.md has them.
@pytest.mark.parametrize("options", [{}, {"NA": 1.2, "ns": 1.33, "pz": 2, "z": 11}, {"ni": 1.51, "tg": 180, "pz": 1}])
@pytest.mark.parametrize("model", ["vectorial", "scalar"])
def test_psfmodels_itself_is_near(options, model):
    peer = pytest.importorskip("psfmodels")
    call = {"z": 7, "nx": 21, "model": model, **options}
    np.testing.assert_allclose(psfmodels.make_psf(**call), peer.make_psf(**call), rtol=0.0, atol=5e-3)
    params = {"NA": 1.3, "ns": 1.4}
    ours, theirs = (of.vectorial_psf([0.0, 1.0], 11, 0.07, 0.5, 0.5, params) for of in (psfmodels, peer))
    np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=5e-3)


def test_microscpsf_itself_is_near():
    peer = pytest.importorskip("microscPSF.microscPSF")
    zv = np.linspace(-1.0, 1.0, 5)
    for name, places in (("gLXYZFocalScan", zv), ("gLXYZParticleScan", 1.0 + zv)):
        ours, theirs = (getattr(of, name)(peer.m_params, 0.05, 20, places) for of in (microscpsf, peer))
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=0.01)
    for name, places in (("gLZRFocalScan", zv), ("gLZRParticleScan", 1.0 + zv)):
        ours, theirs = (getattr(of, name)(peer.m_params, np.linspace(0, 1, 11), places) for of in (microscpsf, peer))
        np.testing.assert_allclose(ours, theirs, rtol=0.0, atol=0.01)


@pytest.mark.parametrize("light", ["none", "x", "y", "z", "total"])
def test_pyotf_itself_is_near(light):
    peer = pytest.importorskip("pyotf.otf")
    call = (520, 0.85, 1.33, 60, 128, 200, 5, light)
    ours, theirs = (of.HanserPSF(*call).PSFi for of in (pyotf, peer))
    np.testing.assert_allclose(ours / ours.max(), theirs / theirs.max(), rtol=0.0, atol=1e-2)


def test_the_objective_is_the_one_that_psf_takes():
    made = psfmodels.objective({"NA": 1.3})
    pupil = made.pupil(depth=0.5e-6, z=0.0, wavelength=600e-9, origin="paraxial")
    found = lm.psf(pupil, 9, 50e-9, dtype=np.float64).values
    stack = psfmodels.make_psf([0.5], 9, NA=1.3, pz=0.5, normalize=False)
    np.testing.assert_array_equal(stack[0], found)
