"""The aperture of a map: every position has it whole, PSFs are those of pupils built by hand, and files keep it."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

import lommel as lm

SCALE = {"wavelength": 550e-9, "f_number": 2.8}
SEIDEL = {"W131": 0.6, "W222": -0.4, "W040": 0.3}
EDGE = 20e-3
KNOWN = np.linspace(0.0, EDGE, 4)
MASK = lm.Mask(np.hypot(*np.mgrid[-1:1:48j, -0.9:1:48j]) < 0.8)
APERTURES = {
    "vanes": {"spider": lm.Spider.equal(3, width=0.15), "obscuration": 0.2},
    "cat's eye": {"vignetting": lm.CatEye((0.4, 0.1))},
    "mask": {"mask": MASK},
    "gaussian": {"apodization": 1.0},
    "ringed": {"apodization": lm.Apodization([1.0, -1.6, 0.37])},
    "all": {
        "obscuration": 0.3,
        "spider": lm.Spider(0.1, (0.3, 2.0)),
        "vignetting": lm.Ellipse(0.9, 0.8, 0.2),
        "mask": MASK,
        "apodization": 0.5,
    },
}


def maps(**aperture):
    """The same lens of third order, made in each of the four ways."""
    seidel = lm.FieldMap.from_seidel(EDGE, **SEIDEL, **aperture)
    across, down = np.meshgrid(np.linspace(-14e-3, 14e-3, 4), np.linspace(-14e-3, 14e-3, 4))
    on_grid = seidel.pupil(across, down).wavefront
    return {
        "seidel": seidel,
        "radial": lm.FieldMap.radial(KNOWN, seidel.pupil(KNOWN, 0.0).wavefront, **aperture),
        "grid": lm.FieldMap.on_grid(across[0], down[:, 0], on_grid, **aperture),
        "scattered": lm.FieldMap.scattered(across.ravel(), down.ravel(), on_grid.flattened(), **aperture),
    }


@pytest.mark.parametrize("aperture", APERTURES.values(), ids=APERTURES)
@pytest.mark.parametrize("integrate", [True, False])
def test_psfs_over_the_field_are_those_of_pupils_built_by_hand(aperture, integrate):
    given = lm.Pupil(**aperture, **SCALE)
    field = lm.FieldMap.from_seidel(EDGE, **SEIDEL, aperture=given)
    grid = field.grid(2, 3, sensor=(16e-3, 24e-3), shape=(11, 12), pixel=1e-6, integrate=integrate, dtype=np.float64)
    for i, j in [(0, 0), (0, 1), (1, 2)]:
        at = (grid.x[j] / EDGE, grid.y[i] / EDGE)
        by_hand = lm.Pupil(lm.Wavefront.from_seidel(**SEIDEL, field=at), **aperture, **SCALE)
        expected = lm.psf(by_hand, (11, 12), 1e-6, integrate=integrate, dtype=np.float64).values
        assert np.abs(grid[i, j].values - expected).max() <= 2e-6 * expected.max()
        bare = lm.psf(replace(by_hand, **_without(aperture)), (11, 12), 1e-6, integrate=integrate).values
        assert np.abs(bare - expected).max() > 1e-3 * expected.max()


def _without(aperture):
    defaults = {field.name: field.default for field in fields(lm.Pupil)}
    return {name: defaults[name] for name in aperture}


@pytest.mark.parametrize("way", maps())
def test_every_way_to_make_a_map_gives_each_position_the_whole_aperture(way):
    given = lm.Pupil(**APERTURES["all"], **SCALE)
    found = maps(aperture=given)[way].pupil([1e-3, 2e-3], -3e-3)
    assert replace(found, wavefront=lm.Wavefront()) == given
    assert found.shape == (2,)


@pytest.mark.parametrize("way", maps())
def test_shorthands_say_the_same_and_complete_an_aperture_without_scale(way):
    short = maps(**SCALE, obscuration=0.2)[way].pupil_without_wavefront
    assert short == lm.Pupil(**SCALE, obscuration=0.2)
    vanes = lm.Pupil(spider=lm.Spider.equal(3, 0.1), obscuration=0.2)
    made = maps(aperture=vanes, **SCALE, obscuration=0.2)[way].pupil_without_wavefront
    assert made == replace(vanes, **SCALE)


def test_the_pupil_of_a_lens_is_an_aperture_without_the_distances_of_the_axis():
    lens = lm.Lens(focal_length=50e-3, focus_distance=2.0, wavelength=550e-9, f_number=2.0,
                   spider=lm.Spider.equal(4, 0.1), apodization="aplanatic", model="aplanatic")  # fmt: skip
    field = lm.FieldMap.from_seidel(EDGE, W131=1.0, aperture=lens.pupil(1.9).unaberrated())
    found = field.pupil(0.0, 5e-3)
    assert (found.geometry, found.spider, found.apodization) == (None, lens.spider, lens.illumination)
    assert (found.f_number, found.wavelength) == (lens.working_f_number, 550e-9)


@pytest.mark.parametrize("way", maps())
@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ({"aperture": lm.Pupil(lm.Wavefront(1.0))}, ValueError, "aperture must have a flat wavefront"),
        ({"aperture": lm.Pupil(**SCALE), "f_number": 2.0}, ValueError, "f_number must be that of the aperture, 2.8"),
        ({"aperture": lm.Pupil(obscuration=0.2), "obscuration": 0.0}, ValueError, "obscuration must be that of"),
    ],
)  # fmt: skip
def test_what_contradicts_an_aperture_or_is_none_is_refused(way, given, error, message):
    make = {"seidel": lm.FieldMap.from_seidel, "radial": lm.FieldMap.radial, "grid": lm.FieldMap.on_grid,
            "scattered": lm.FieldMap.scattered}[way]  # fmt: skip
    known = lm.Wavefront([0.0, 1.0])
    arguments = {"seidel": (1.0,), "radial": ([0, 1], known),
                 "grid": ([0, 1], [0, 1], lm.Wavefront([[0.0, 1.0], [2.0, 3.0]])),
                 "scattered": ([0, 1, 0], [0, 0, 1], lm.Wavefront([0.0, 1.0, 2.0]))}  # fmt: skip
    with pytest.raises(error, match=message):
        make(*arguments[way], **given)


@pytest.mark.parametrize("suffix", [".tif", ".zarr", ".npz"])
@pytest.mark.parametrize("unit", ["m", "lambda*N"])
def test_files_keep_the_aperture(tmp_path, suffix, unit):
    pytest.importorskip("zarr")
    scale, length = (SCALE, 1e-6) if unit == "m" else ({}, 0.5)
    field = lm.FieldMap.from_seidel(20 * length, **SEIDEL, aperture=lm.Pupil(**APERTURES["all"], **scale))
    grid = field.grid(2, 2, sensor=(8 * length, 8 * length), shape=9, pixel=length)
    grid.save(tmp_path / f"a{suffix}")
    loaded = lm.PSFGrid.load(tmp_path / f"a{suffix}")
    assert loaded.psf.pupil == grid.psf.pupil
    assert loaded.psf.pupil.mask == MASK
    assert np.array_equal(loaded.values, grid.values)
    again = lm.psf(loaded[1, 0].pupil, 9, length)
    np.testing.assert_allclose(again.values, loaded[1, 0].values, atol=1e-6 * grid.values.max())
