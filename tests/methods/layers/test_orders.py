"""Light as orders of the azimuth: against plane waves, and what its products and its pixels are off by at most."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import jv

import lommel as lm
from lommel.methods.layers.scanning import Orders, Table, light
from lommel.optics.layers.emitter import Absorbed
from objectives import TIRF
from plane_waves import intensity

V = np.array([0.0, 1.3, 4.9])
PHI = np.array([0.0, 0.4, 2.0, -2.5])


def at(orders: Orders, phi=PHI):
    """The sum, shape (n, azimuths, radii)."""
    most = orders.values.shape[1] // 2
    turns = np.exp(1j * np.multiply.outer(phi, np.arange(-most, most + 1)))
    total = np.einsum("am,nmr->nar", turns, orders.values)
    assert np.abs(total.imag).max() <= 1e-14
    return total.real


@pytest.mark.parametrize("tol", [1e-4, 1e-9])
@pytest.mark.parametrize(
    "emitter",
    [
        lm.Dipole(0.0, 0.0, wobble=1.0),
        lm.Dipole(0.7, 0.4),
        lm.Beam((0.3, 0.8 - 0.2j)),
        Absorbed("x", lm.Dipole(0.7, 0.4)),
        Absorbed((1.0, 0.4j), lm.Dipole(2.2, -1.4, wobble=0.3)),
        Absorbed("radial", lm.Dipole(0.9, 1.4)),
        Absorbed("azimuthal", lm.Dipole(0.9, 1.4)),
        lm.Beam("vortex"),
        Absorbed("vortex", lm.Dipole(0.9, 1.4)),
    ],
    ids=repr,
)
def test_light_is_the_sum_of_its_plane_waves(emitter, tol):
    pupil = replace(TIRF.pupil(depth=0.2e-6, z=[-0.4e-6, 0.2e-6], wavelength=520e-9), emitter=emitter)
    made = light(pupil, V, tol, tol)
    r = V * pupil.scale / np.pi
    x, y = (np.multiply.outer(part, r).ravel() for part in (np.cos(PHI), np.sin(PHI)))
    exact = (intensity(TIRF, pupil, x, y, 50, 80) / pupil.power[:, None]).reshape(2, PHI.size, V.size)
    assert np.all(np.abs(at(made) - exact).max(axis=(1, 2)) <= made.error + 1e-13)
    assert np.all(made.error <= 1.01 * tol * made.largest)
    assert np.all(exact.max(axis=(1, 2)) <= made.largest + made.error)


def test_a_beam_is_absorbed_on_average_by_all_dipoles():
    pupil = TIRF.pupil(depth=0.2e-6, z=[0.2e-6], wavelength=520e-9, emitter=lm.Beam("x"))
    known, total = light(pupil, V, 1e-10, 1e-10), 0.0
    for polar, azimuth in ((0.0, 0.0), (np.pi / 2, 0.0), (np.pi / 2, np.pi / 2)):
        one = replace(pupil, emitter=Absorbed("x", lm.Dipole(polar, azimuth)))
        total = total + at(light(one, V, 1e-10, 1e-10)) * one.power
    assert total / 3.0 == pytest.approx(at(known) * pupil.power, abs=1e-9)


@pytest.mark.parametrize("error", [1e-3, 1e-6, 1e-10])
@pytest.mark.parametrize("faster", [1.0, 2.1])
def test_pixels_are_between_even_radii_within_their_bound(error, faster):
    # Between 0 and 1, with frequencies up to those of the bound, and of the parity of each order.
    y, x = np.mgrid[-6:7, -3:12] * 0.731
    radius, phi = np.hypot(x, y).ravel(), np.arctan2(y, x).ravel()
    shares = (0.2, 0.15 - 0.1j, 0.1j)

    def known(v):
        upper = np.array([share * jv(m, 2.0 * faster * v) for m, share in enumerate(shares)])
        upper[0] += 0.5
        return np.concatenate([upper[:0:-1].conj(), upper])[None]

    table = Table.for_pixels(radius, error, faster)
    given = Orders(known(table.radii), np.zeros(1))
    found, added = table.interpolate(given, radius, np.exp(1j * phi)), table.error(given)
    exact = np.einsum("mp,mp->p", known(radius)[0], np.exp(1j * np.multiply.outer(np.arange(-2, 3), phi))).real
    assert np.abs(found - exact).max() <= error + added[0]
    assert np.abs(found - exact).max() >= 1e-3 * error or error < 1e-8
    assert added[0] <= 1e-13


def test_images_of_more_orders_than_the_engine_has_are_those_of_the_reference():
    pupil = replace(TIRF.pupil(depth=0.2e-6, wavelength=520e-9), emitter=Absorbed("x", lm.Dipole(0.7, 0.4)))
    y, x = np.mgrid[-2:3, -2:3] * 6.5e-6
    exact = (intensity(TIRF, pupil, x.ravel(), y.ravel(), 50, 80) / pupil.power[:, None]).reshape(5, 5)
    made = lm.psf(pupil, 5, 6.5e-6, integrate=False)
    assert made.values / made.scale == pytest.approx(exact, abs=1e-6 * exact.max())
