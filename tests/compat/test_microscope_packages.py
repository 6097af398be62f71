"""Microscope PSFs with the signatures of other packages, beside quadrature, and beside these where they are there."""

from __future__ import annotations

import numpy as np
import pytest

import lommel as lm
from lommel.compat import psfmodels

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


def test_the_scalar_model_of_psfmodels_is_the_same_integral_with_supercritical_light_added():
    # Below the index of the sample there is none.
    of = psfmodels.PARAMS | {"NA": 1.2, "ns": 1.33, "tg": 174.0}
    z = np.array([0.0, 1.0, 2.5])
    found = psfmodels.make_psf(z, 9, dxy=0.08, pz=1.0, wvl=0.5, oversample_factor=1, model="scalar", **of)
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
    assert stack.shape == (5, 7, 7)
    assert stack.max() == 1.0
    assert psfmodels.make_psf(1, 4)[0].argmax() == 5  # pixel (1, 1) of an even window


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: psfmodels.make_psf(model="gaussian"), "model must be"),
        (lambda: psfmodels.make_psf(NA=1.6), "NA must be below the index of immersion"),
        (lambda: psfmodels.objective({"Na": 1.4}), "params must be"),
        (lambda: psfmodels.make_psf(pz=-1.0), "pz must be"),
        (lambda: psfmodels.make_psf(0), "z must be"),
        (lambda: psfmodels.make_psf([np.nan]), "z must be"),
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


def test_the_objective_is_the_one_that_psf_takes():
    made = psfmodels.objective({"NA": 1.3})
    pupil = made.pupil(depth=0.5e-6, z=0.0, wavelength=600e-9, origin="paraxial")
    found = lm.psf(pupil, 9, 50e-9, dtype=np.float64).values
    stack = psfmodels.make_psf([0.5], 9, NA=1.3, pz=0.5, normalize=False)
    np.testing.assert_array_equal(stack[0], found)
