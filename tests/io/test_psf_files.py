"""PSFs in files: what is written, what other programs read, and what comes back."""

from __future__ import annotations

import json
import math
from functools import cache

import numpy as np
import pytest
import tifffile
from PIL import Image

import lommel as lm
from lommel.base.atomic import sealed
from lommel.io import psf_files
from lommel.methods import Hankel, Method, NijboerZernike, Polychromatic
from lommel.paper import AbramowitzErf, ClosedForm, Fraunhofer, Geometric, HuygensFresnel, LommelSeries, TableErf

EXACT = [
    ".tif",
    ".tiff",
    ".npy",
    ".npz",
    ".fits",
    ".fit",
    ".fits.gz",
    ".fit.gz",
    ".h5",
    ".hdf5",
    ".mat",
]
LENS = lm.Lens(
    focal_length=57.6, f_number=24.0, wavelength=550e-9, obscuration=0.33, aberrations=lm.Wavefront(3.0, 1.0, [0.5])
)
DISTANCES = np.array([[1e5, math.inf], [2e5, 3e5], [4e5, 5e5]])


@pytest.fixture
def single() -> lm.PSF:
    return lm.psf(LENS.pupil(), (9, 8), 2.5e-6)


@pytest.fixture
def stack() -> lm.PSF:
    return lm.psf(LENS.pupil(DISTANCES), (9, 8), 2.5e-6, method=NijboerZernike(tol=1e-9), normalize="peak")


@pytest.fixture
def moved() -> lm.PSF:
    method = Polychromatic([450e-9, 550e-9, 650e-9], [1.0, 2.0, 1.0], NijboerZernike(tol=1e-4))
    return lm.psf(LENS.pupil([2e5, 3e5]), (9, 8), 2.5e-6, method=method, center=(3.25, 9.5), integrate=True)


def same(one: lm.PSF, two: lm.PSF) -> None:
    """Everything but the values, and their error bound."""
    assert (one.grid, one.unit, one.normalize, one.shape) == (two.grid, two.unit, two.normalize, two.shape)
    assert one.sampling == two.sampling
    assert one.values.dtype == two.values.dtype
    assert one.method == two.method
    assert one.pupil == two.pupil
    np.testing.assert_array_equal(one.scale, two.scale)


@pytest.mark.parametrize("which", ["single", "stack", "moved"])
@pytest.mark.parametrize("suffix", EXACT)
def test_what_is_saved_loads_as_it_was(suffix, which, tmp_path, request):
    psf = request.getfixturevalue(which)
    psf.save(tmp_path / f"a{suffix}")
    loaded = lm.PSF.load(tmp_path / f"a{suffix}")
    same(loaded, psf)
    np.testing.assert_array_equal(loaded.values, psf.values)
    assert loaded.error_bound == psf.error_bound


@cache
def computed(method: Method) -> tuple[lm.PSF, float | None]:
    """Return the PSF of a camera by a method, and its light within a circle where the method has diffraction."""
    camera = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    psf = lm.psf(camera.pupil(1.99), 8, 1e-6, method=method)
    return psf, None if isinstance(method, Geometric) else psf.encircled_energy(2e-6)


@pytest.mark.parametrize(
    "method",
    [
        Hankel(tol=1e-10),
        Fraunhofer(samples=64, padding=2.0, edge="grey"),
        Geometric(rings=3),
        HuygensFresnel(symmetry=False),
        HuygensFresnel(),
        ClosedForm(erf=AbramowitzErf(7)),
        ClosedForm(erf=TableErf(64), variant="printed"),
        LommelSeries(),
    ],
    ids=lambda method: type(method).__name__,
)
@pytest.mark.parametrize("suffix", EXACT)
def test_a_loaded_psf_knows_its_method_with_every_option_and_can_go_on(suffix, method, tmp_path):
    psf, energy = computed(method)
    psf.save(tmp_path / f"a{suffix}")
    loaded = lm.PSF.load(tmp_path / f"a{suffix}")
    same(loaded, psf)
    if suffix == ".npz" and energy is not None:  # it takes longer than the rest of all files
        assert loaded.encircled_energy(2e-6) == pytest.approx(energy, rel=1e-4)
    assert loaded.energy == pytest.approx(psf.energy, rel=1e-4)
    assert loaded.strehl == pytest.approx(psf.strehl, abs=1e-4)
    np.testing.assert_allclose(loaded.profile()[1], psf.profile()[1], rtol=0, atol=1.6e-5 * psf.values.max())


def test_a_loaded_stack_can_be_indexed_and_evaluated_between_the_pixels(stack, tmp_path):
    stack.save(tmp_path / "a.npz")
    loaded = lm.PSF.load(tmp_path / "a.npz")
    np.testing.assert_array_equal(loaded.profile([0.0, 1e-6])[1], stack.profile([0.0, 1e-6])[1])
    assert loaded[1, 0].pupil == LENS.pupil(2e5)


@pytest.mark.parametrize("which", ["single", "stack"])
def test_other_programs_read_the_values(which, tmp_path, request):
    psf = request.getfixturevalue(which)
    for name in ("a.tif", "a.npy", "a.npz"):
        psf.save(tmp_path / name)
    np.testing.assert_array_equal(np.load(tmp_path / "a.npy"), psf.values)
    with np.load(tmp_path / "a.npz") as archive:
        np.testing.assert_array_equal(archive["values"], psf.values)
        assert archive["description"].dtype == np.uint8  # which readers in other languages know
        assert json.loads(archive["description"].tobytes()) == sealed(psf_files.describe(psf), {"values": psf.values})
    pages = tifffile.imread(tmp_path / "a.tif")
    np.testing.assert_array_equal(pages, psf.values if which == "single" else psf.values.reshape(6, 9, 8))


def test_the_picture_is_sixteen_bit_grey_with_the_square_root_of_the_values(single, tmp_path):
    single.save(tmp_path / "a.png")
    with Image.open(tmp_path / "a.png") as picture:
        assert picture.size == (57 * 8, 57 * 9)  # 57 being the least that makes nine 512 or more
        assert picture.mode.startswith("I;16")
        assert picture.text["Software"] == f"lommel {lm.__version__}"
        grey = np.asarray(picture)
    levels = np.kron(single.values / single.values.max(), np.ones((57, 57)))
    np.testing.assert_allclose(grey, 65535 * np.sqrt(levels), atol=0.51)


@pytest.mark.parametrize(
    ("options", "pixel", "size", "unit"),
    [
        ({"wavelength": 550e-9, "f_number": 4.0}, 3.45e-6, 3.45, "µm"),
        ({}, 0.25, 0.25, "reference frame"),
    ],
    ids=["metres", "lambda*N"],
)
def test_the_ome_metadata_have_the_physical_size_of_a_pixel(options, pixel, size, unit, tmp_path):
    lm.psf(lm.Pupil(lm.Wavefront([1.0, 2.0, 3.0]), **options), (4, 5), pixel).save(tmp_path / "a.tif")
    with tifffile.TiffFile(tmp_path / "a.tif") as file:
        assert file.is_ome
        assert file.series[0].axes == "ZYX"
        pixels = tifffile.xml2dict(file.ome_metadata)["OME"]["Image"]["Pixels"]
    assert (pixels["SizeX"], pixels["SizeY"], pixels["SizeZ"], pixels["Type"]) == (5, 4, 3, "float")
    for axis in "XY":
        assert pixels[f"PhysicalSize{axis}"] == pytest.approx(size)
        assert pixels[f"PhysicalSize{axis}Unit"] == unit


def test_the_description_says_how_the_values_were_made(stack):
    text = json.dumps(psf_files.describe(stack), allow_nan=False)
    said = json.loads(text)
    assert said["software"] == f"lommel {lm.__version__}"
    assert said["method"] == {"name": "NijboerZernike", "tol": 1e-9}
    assert said["pupil"]["wavefront"]["spherical"] == 1.0
    assert said["pupil"]["wavefront"]["higher"] == [0.5]
    assert said["pupil"]["obscuration"] == 0.33
    assert said["pupil"]["wavelength"] == 550e-9
    assert said["pupil"]["f_number"] == pytest.approx(24.0)
    assert said["pupil"]["geometry"]["object_distance"][:2] == [1e5, None]
    assert (said["normalize"], said["sampling"], said["pixel"], said["unit"]) == ("peak", "pixel", 2.5e-6, "m")
    assert said["error_bound"] == stack.error_bound
    assert (said["shape"], said["dtype"]) == ([3, 2, 9, 8], "float64")


@pytest.mark.parametrize("name", ["a.jpg", "a", "a.tif.gz", "a.gz", ".png"])
def test_an_unknown_suffix_is_refused_with_the_known_ones(name, single, tmp_path):
    for call in (single.save, lm.PSF.load):  # pictures are not read
        with pytest.raises(ValueError, match=r"path must end in \.tif, \.tiff, \.npy, \.npz") as caught:
            call(tmp_path / name)
        assert f"got {(tmp_path / name).suffix!r} in '{tmp_path / name}'" in str(caught.value)
    assert not list(tmp_path.iterdir())


def test_a_stack_is_no_picture(stack, tmp_path):
    with pytest.raises(ValueError, match=r"holds a single PSF, got a stack of shape \(3, 2, 9, 8\)"):
        stack.save(tmp_path / "a.png")
    assert not list(tmp_path.iterdir())
