"""Images of a search from samples of the pupil: near to those that are certified, for any aperture.

And derivatives by uneven light of a pupil, against differences of images by plain sums over many points.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import lommel as lm
from lommel.estimation import sampled_pupil
from lommel.estimation.field_stars import FieldStars
from lommel.estimation.sampled_pupil import (
    ASPECT,
    FOLDS,
    OBSCURATION,
    OVAL,
    SHIFT,
    SLANT,
    PupilChanges,
    SampledPupil,
    changes_of,
)
from lommel.estimation.star_images import Unknowns
from lommel.methods import NonuniformFFT
from lommel.optics.grid import Grid
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import Plan

TERMS = ((1, -1), (1, 1), (2, -2), (2, 0), (2, 2), (3, -1), (4, 0))
EDGE = np.array([[0.5, 0.3, 0.8, 0.4, 0.9, 0.5, 1.1], [-0.3, 0.2, -0.9, 0.1, -0.6, -0.5, 0.7]])
APERTURES = {
    "vanes": lm.Pupil(obscuration=0.35, spider=lm.Spider(0.03, (0.3, 1.9, 3.4))),
    "apodized": lm.Pupil(apodization=0.5, spider=lm.Spider(0.1, (0.3, 1.9))),
    "segments": lm.Pupil(
        stop=lm.Segments([lm.Polygon.strip((-0.9, y), (0.9, y), 0.7) for y in (-0.4, 0.4)], tip=[0.6, -0.4])
    ),
    "vignetted": lm.Pupil(vignetting=lm.CatEye((0.4, 0.0)), wavelength=500e-9, f_number=4.0),
}
SIDE, PITCH = 25, 0.45
AT = 1.05 * ((np.arange(1000) + 0.5) / 500 - 1)
X, Y = np.meshgrid(AT, AT)
RHO, THETA = np.hypot(X, Y), np.arctan2(Y, X)
COMA = 0.8 * (3 * RHO**3 - 2 * RHO) * np.cos(THETA) + 0.4 * RHO**2 * np.cos(2 * THETA)


@pytest.mark.parametrize("name", APERTURES)
def test_images_and_slopes_are_near_to_certified_ones(name):
    pupil = APERTURES[name]
    grid = Grid((41, 38), 0.45 * pupil.scale)
    images = SampledPupil(pupil, grid, TERMS).images(EDGE, range(1, 6))
    at = pupil.carrying(Wavefront.zernike(dict(zip(TERMS, EDGE.T, strict=True)), normalization="edge"), None)
    true = lm.psf(at, grid.shape, grid.pixel, tol=1e-5, normalize="energy", integrate=False, derivatives=TERMS[1:6])
    peak = true.values.max()
    assert np.abs(images[0] - true.values).max() < 5e-4 * peak
    for slope, term in zip(images[1:], TERMS[1:6], strict=True):
        assert np.abs(slope - true.derivatives[term]).max() < 1e-3 * peak


@pytest.mark.parametrize("small", [40, 1000])  # by Fourier transforms, and by matrices
def test_images_and_slopes_are_those_of_plane_waves_summed_over_a_fine_pupil(small, monkeypatch):
    monkeypatch.setattr(sampled_pupil, "SMALL", small)
    side, pitch, inside, term = 61, 0.7, 0.35, (2, 2)
    pupil = lm.Pupil(obscuration=inside)
    made = SampledPupil(pupil, Grid(side, pitch, integrate=False), (term, (2, 0))).images(np.array([[0.7, 0.9]]), [0])
    at = (np.arange(1500) + 0.5) / 750 - 1.0
    rho, theta = np.hypot(at, at[:, None]), np.arctan2(at[:, None], at)
    astigmatism = rho**2 * np.cos(2 * theta)
    clear = (rho < 1) & (rho > inside)
    field_of = clear * np.exp(1j * (0.7 * astigmatism + 0.9 * (2 * rho**2 - 1)))
    rows, columns = np.array([30, 33, 47]), np.array([2, 30, 41])
    down, across = (np.exp(-1j * np.pi * pitch * np.multiply.outer(k - side // 2, at)) for k in (rows, columns))
    cell = (2 / at.size) ** 2
    field, moved = (cell * (down @ part @ across.T) for part in (field_of, 1j * astigmatism * field_of))
    # Shares of the light: |U|^2 over the area of a sample, by Parseval over that of the pupil.
    scale = (pitch / 2) ** 2 / (np.pi * (1 - inside**2))
    expected = scale * np.abs(field) ** 2, scale * 2 * (field.conj() * moved).real
    for one, true, most in zip(made, expected, (np.abs(each).max() for each in made), strict=True):
        np.testing.assert_allclose(one[0][np.ix_(rows, columns)], true, atol=1e-3 * most)


def test_slopes_alone_are_the_same():
    sampled = SampledPupil(APERTURES["vanes"], Grid(21, 0.45), TERMS)
    whole, alone = sampled.images(EDGE, [3]), sampled.images(EDGE, [3], values=False)
    assert len(alone) == 1
    np.testing.assert_array_equal(whole[1], alone[0])


CELL = (AT[1] - AT[0]) ** 2
HEXAGON = lm.Polygon.regular(6, 1.0)
# Open parts of the square beside the disc and the obscuration: everything; without vanes; a hexagon of phases.
PARTS = {
    "none": np.ones_like(X, dtype=complex),
    "vanes": np.prod(
        [
            (X * np.cos(a) + Y * np.sin(a) < 0) | (np.abs(Y * np.cos(a) - X * np.sin(a)) > 0.05)
            for a in (0.3, 1.9, 3.4)
        ],
        axis=0,
    ).astype(complex),
    "hexagon": np.prod(
        [np.abs(X * np.cos(a) + Y * np.sin(a)) < 0.75**0.5 for a in np.pi / 6 + np.pi / 3 * np.arange(3)], axis=0
    )
    * np.exp(0.5j * X + 0.3j),
}
SHAPES = {
    "none": {},
    "vanes": {"spider": lm.Spider(0.1, (0.3, 1.9, 3.4))},
    "hexagon": {"stop": lm.Segments([HEXAGON], piston=[0.3], tip=[0.5])},
}


def image(clear, inside, defocus, taller=0.0, off=(0.0, 0.0)):
    """Return the image of an aperture; `clear` is an amplitude, and the open area that of the annulus."""
    places = np.pi * PITCH * (np.arange(SIDE) - SIDE // 2)
    down, across = (np.exp(-1j * np.multiply.outer(places * scale, AT)) for scale in (1 - taller, 1 + taller))
    blocked = np.hypot(Y - off[0], X - off[1]) < inside
    field = down @ (clear * ~blocked * np.exp(1j * (defocus * (2 * RHO**2 - 1) + COMA))) @ across.T
    return np.abs(field * CELL * PITCH / 2) ** 2


def area(part, inside):
    return CELL * (np.abs(part) * ((RHO < 1) & (inside <= RHO))).sum()


def changed(part, name, way, inside, defocus):
    """Return the derivative of an image by a change along rows, or along columns; by cosine, or by sine."""
    size = {SHIFT: 0.02, OVAL: 0.01}.get(name, 0.01)
    turn = (np.cos, np.sin)[way]
    made = []
    for step in (size, -size):
        clear, options = RHO < 1, {}
        if name == SLANT:
            clear = clear * np.exp(-step * (Y, X)[way])
        elif name in FOLDS:
            n = 2 + FOLDS.index(name)
            clear = clear * (1 + step * RHO**n * turn(n * THETA))
        elif name == SHIFT:
            options = {"off": ((step, 0.0), (0.0, step))[way]}
        elif name == OBSCURATION:
            made.append(image(part * clear, inside + step, defocus))
            continue
        elif name == OVAL:
            clear = 1 + step * turn(2 * THETA) > RHO
        else:
            options = {"taller": step}
        made.append(image(part * clear, inside, defocus, **options))
    # The light is that of `inside` in both, as the flux of a star is estimated.
    return (made[0] - made[1]) / (2 * size * area(part, inside))


@pytest.mark.parametrize(
    ("shape", "inside", "defocus"),
    [("none", 0.0, 0.6), ("none", 0.3, 0.6), ("none", 0.3, 8.0), ("vanes", 0.3, 0.6), ("hexagon", 0.3, 0.6)],
)
def test_derivatives_are_differences_of_images(shape, inside, defocus):
    wavefront = lm.Wavefront.zernike({(2, 0): defocus, (3, 1): 0.8, (2, 2): 0.4}, normalization="edge")
    pupil, part = lm.Pupil(wavefront, obscuration=inside, **SHAPES[shape]), PARTS[shape]
    terms = sorted(wavefront.edge_terms())
    edge = np.array([[wavefront.edge_terms()[term] for term in terms]])
    derivatives = PupilChanges(pupil, Grid((SIDE, SIDE), PITCH, integrate=False), terms, edge)
    changes = changes_of(pupil)
    assert changes == {
        SLANT: 2,
        **dict.fromkeys(FOLDS, 2),
        **({SHIFT: 2, OBSCURATION: 1} if inside else {}),
        **({OVAL: 2} if shape != "hexagon" else {}),
        ASPECT: 1,
    }
    values = np.asarray(lm.psf(pupil, SIDE, PITCH, integrate=False).values)
    plain = image(part * (RHO < 1), inside, defocus) / area(part, inside)
    assert np.abs(plain - values).max() < 4e-3 * values.max()
    expected = [(name, way) for name, count in changes.items() for way in range(count)]
    for found, (name, way) in zip(derivatives.images(), expected, strict=True):
        true = changed(part, name, way, inside, defocus)
        assert np.abs(found[0] - true).max() < 0.1 * np.abs(true).max(), (name, way)
    if inside:  # the light of images is 1 for every obscuration
        near, far = (
            image(part * (RHO < 1), inside + step, defocus) / area(part, inside + step) for step in (-0.01, 0.01)
        )
        slope = (far - near) / 0.02
        assert np.abs(derivatives.by_obscuration()[0] - slope).max() < 0.1 * np.abs(slope).max()


def test_pupils_with_masks_have_no_such_changes():
    assert changes_of(lm.Pupil(mask=lm.Mask(np.ones((64, 64))))) == {}


def test_searches_behind_vanes_of_an_annulus_have_images_with_bounds():
    pupil = lm.Pupil(obscuration=0.3, spider=lm.Spider.equal(4, 0.04, 0.4))
    plan, unknowns = Plan((17, 17), 0.5, tol=1e-6), Unknowns(3, "center")
    electrons = 1e9 * lm.psf(pupil, 17, 0.5).values[None, None]
    arrays = electrons, np.ones_like(electrons), np.ones(electrons.shape, dtype=bool)
    stars = FieldStars(*arrays, pupil, np.zeros(1), unknowns, 0.5, plan, blur=())
    waves, widths, nuisance = np.full((1, 3), 0.2), np.zeros((1, 1, 0)), np.zeros((1, 4, 1))
    found = stars.images(np.zeros(1, dtype=np.intp), waves, widths, nuisance, fast=True)
    turned = dataclasses.replace(pupil, wavefront=lm.Wavefront.zernike({4: 0.2, 5: 0.2, 6: 0.2}, order="noll"))
    names = list(unknowns.edge)
    exact = lm.psf(turned, 17, 0.5, derivatives=names, method=NonuniformFFT(1e-9), dtype="f8")
    for image, other in zip(found, (exact.values, *(exact.derivatives[name] for name in names)), strict=False):
        # Sampled pupils are off by 1e-3.
        np.testing.assert_allclose(image[0], other, rtol=0.0, atol=3e-5 * float(exact.values.max()))
