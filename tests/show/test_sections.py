"""Sections through a z stack of a microscope: what is drawn where, in which lengths."""

from __future__ import annotations

import dataclasses

import matplotlib.pyplot as plt
import numpy as np
import pytest

import lommel as lm
from lommel.optics.grid import Grid
from lommel.show.plot import is_z_stack
from objectives import WATER_60X

OBJECTIVE = WATER_60X
RISING = np.arange(-3, 4) * 0.2e-6


def stack(z=RISING, shape=(8, 9), pixel=6e-6, depth=2e-6, emitter="scalar", **options) -> lm.PSF:
    pupil = OBJECTIVE.pupil(depth=depth, z=z, wavelength=520e-9, emitter=emitter)
    return lm.psf(pupil, shape, pixel, **options)


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def drawn(axes) -> np.ndarray:
    (mesh,) = axes.collections
    return mesh.get_array().reshape(mesh.get_coordinates().shape[0] - 1, -1)


@pytest.mark.parametrize("z", [RISING, RISING[::-1]], ids=["rising", "falling"])
def test_a_z_stack_is_plotted_as_sections_through_its_brightest_voxel(z):
    psf = stack(z, center=(2, 5))
    xy, xz, yz = psf.plot()
    low_to_high = psf.values[np.argsort(z)]
    np.testing.assert_array_equal(drawn(xy), low_to_high[3])
    np.testing.assert_array_equal(drawn(xz), low_to_high[:, 2])
    np.testing.assert_array_equal(drawn(yz), low_to_high[:, :, 5].T)
    assert [axes.get_title()[:2] for axes in (xy, xz, yz)] == ["xy", "xz", "yz"]


def test_lengths_are_those_in_the_sample_and_of_the_stage():
    xy, xz, yz = stack().plot()
    np.testing.assert_allclose(xy.get_xlim(), (-0.45, 0.45), atol=1e-12)
    np.testing.assert_allclose(xy.get_ylim(), (0.35, -0.45), atol=1e-12)  # rows from the top
    np.testing.assert_allclose(xz.get_ylim(), (-0.7, 0.7), atol=1e-12)
    np.testing.assert_allclose(yz.get_xlim(), (-0.7, 0.7), atol=1e-12)
    assert xz.get_ylabel() == "z of the stage (µm)"
    assert [each.get_aspect() for each in (xy, xz, yz)] == pytest.approx([1.0, 1.0, 1.0])


def test_planes_that_are_not_evenly_spaced_are_drawn_where_they_are():
    (mesh,) = stack(np.array([0.0, 0.2e-6, 0.8e-6])).plot()[1].collections
    np.testing.assert_allclose(mesh.get_coordinates()[:, 0, 1], (-0.1, 0.1, 0.5, 1.1), atol=1e-12)
    assert "3 planes, not evenly spaced" in plt.gcf().get_suptitle()


@pytest.mark.parametrize(
    "psf",
    [
        lambda: lm.psf(lm.Pupil(lm.Wavefront(np.linspace(0, 3, 4))), 5, 0.5),
        lambda: stack(0.0),
        lambda: stack(np.zeros(3)),
        lambda: stack(np.array([0.0, 1e-7, 0.0])),
        lambda: stack(np.array([[0.0, 1e-7]])),
        lambda: stack(0.0, depth=np.array([1e-6, 2e-6])),
        lambda: dataclasses.replace(stack(), grid=Grid((8, 9), 6e-6, center=(np.arange(7.0), 4.0), integrate=True)),
    ],
)
def test_other_stacks_are_no_z_stacks(psf):
    assert not is_z_stack(psf())


def test_dark_surroundings_of_a_stack_are_cut_off_and_the_title_says_so():
    psf = stack(shape=(49, 61))
    xy, xz, yz = psf.plot()
    said = "dark surroundings are cropped"
    assert said in plt.gcf().get_suptitle()
    assert xy.get_xlim() == xz.get_xlim()
    assert xy.get_ylim()[::-1] == pytest.approx(yz.get_ylim()[::-1])
    (left, right), dark = xy.get_xlim(), 0.05**2 * psf.values.max()
    x = psf.grid.x * 1e6 / 60
    outside = (x < left) | (x > right)
    assert outside.any()
    assert psf.values[:, 24][:, outside].max() < dark < psf.values[:, 24][:, ~outside].max()
    stack().plot()
    assert said not in plt.gcf().get_suptitle()
