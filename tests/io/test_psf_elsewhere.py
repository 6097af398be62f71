"""PSFs as readers of other people find them: astropy, h5py, SciPy, plain structs, and programs in C++."""

from __future__ import annotations

import dataclasses
import json
import math
import shutil
import struct
import subprocess
import zipfile
from pathlib import Path

import h5py
import numpy as np
import pytest
from astropy import units
from astropy.io import fits
from astropy.wcs import WCS
from scipy.io.matlab import matfile_version

import lommel as lm
from lommel.base.atomic import sealed
from lommel.io import psf_files

TELESCOPE = lm.Lens(focal_length=57.6, f_number=24.0, wavelength=550e-9, obscuration=0.33)
WHITE = lm.methods.Polychromatic([450e-9, 550e-9, 650e-9], [1.0, 2.0, 1.0], lm.methods.NijboerZernike(tol=1e-4))
SINGLE = lm.psf(TELESCOPE.pupil(), (9, 8), 2.5e-6)
STACK = lm.psf(TELESCOPE.pupil([[1e5, math.inf], [2e5, 3e5], [4e5, 5e5]]), (9, 8), 2.5e-6, normalize="peak")
MOVED = lm.psf(TELESCOPE.pupil([2e5, 3e5]), (9, 8), 2.5e-6, method=WHITE, center=(3.25, 9.5))
PLAIN = lm.psf(lm.Pupil(lm.Wavefront(1.0, nonradial={(3, 1): 0.5})), 9, 0.5, dtype="float64")
EACH = {"single": SINGLE, "stack": STACK, "moved": MOVED, "plain": PLAIN}
each = pytest.mark.parametrize("psf", EACH.values(), ids=EACH)


@pytest.fixture(scope="module")
def microscope() -> lm.PSF:
    example = Path(__file__).parents[2] / "examples" / "objectives" / "zeiss-63x-1.4-oil.toml"
    stack = dataclasses.replace(lm.load_microscope(example), planes=5, step=1e-7).pupil()
    return lm.psf(stack, (5, 7), 6.5e-6)


@each
@pytest.mark.parametrize("suffix", [".fits", ".fit.gz"])
def test_astropy_reads_the_values_and_finds_no_fault(psf, suffix, tmp_path):
    psf.save(tmp_path / f"a{suffix}")
    with fits.open(tmp_path / f"a{suffix}", checksum=True) as file:  # which warns of one that is wrong
        file.verify("exception")
        np.testing.assert_array_equal(file[0].data, psf.values)
        assert file[0].data.dtype.newbyteorder("=") == psf.values.dtype
        said = json.dumps(sealed(psf_files.describe(psf), {"values": psf.values}))
        assert file["LOMMEL"].data.tobytes().decode() == said


def header(psf: lm.PSF, folder: Path) -> fits.Header:
    psf.save(folder / "a.fits")
    return fits.getheader(folder / "a.fits")


def test_a_fits_header_has_the_scale_on_the_sky_and_the_light_as_poppy_writes_them(tmp_path):
    cards = header(SINGLE, tmp_path)
    assert cards["PIXELSCL"] == pytest.approx(2.5e-6 / 57.6 * 206264.806, rel=1e-8)
    assert (cards["XPIXSZ"], cards["YPIXSZ"]) == (2.5, 2.5)
    assert (cards["WAVELEN"], cards["NWAVES"], cards["WAVE0"], cards["WGHT0"]) == (550e-9, 1, 550e-9, 1.0)
    assert units.Unit(cards["BUNIT"], format="fits") == 1 / units.pixel
    cards = header(MOVED, tmp_path)
    assert [cards[f"WAVE{k}"] for k in range(cards["NWAVES"])] == [450e-9, 550e-9, 650e-9]
    assert [cards[f"WGHT{k}"] for k in range(3)] == [0.25, 0.5, 0.25]
    assert cards["WAVELEN"] == pytest.approx(550e-9)
    assert header(STACK, tmp_path)["BUNIT"] == ""
    cards = header(PLAIN, tmp_path)
    assert cards["PIXELSZ"] == 0.5
    assert not {"PIXELSCL", "WAVELEN", "CUNIT1", "XPIXSZ"}.intersection(cards)


def test_the_coordinates_of_fits_are_metres_from_the_axis(tmp_path):
    for psf in (SINGLE, MOVED):
        there = WCS(header(psf, tmp_path)).sub([1, 2])
        x, y = there.pixel_to_world_values(np.arange(8), np.zeros(8))[0], psf.grid.y
        np.testing.assert_allclose(x, psf.grid.x, atol=1e-18)
        np.testing.assert_allclose(there.pixel_to_world_values(np.zeros(9), np.arange(9))[1], y, atol=1e-18)


def test_planes_of_a_microscope_have_their_places_in_every_file(microscope, tmp_path):
    cards = header(microscope, tmp_path)
    assert (cards["CTYPE3"], cards["CUNIT3"], cards["CRPIX3"]) == ("Z", "m", pytest.approx(3.0))
    assert cards["CDELT3"] == pytest.approx(1e-7)
    microscope.save(tmp_path / "a.h5")
    with h5py.File(tmp_path / "a.h5") as file:
        assert [dimension.label for dimension in file["values"].dims] == ["z", "y", "x"]
        for k, places in enumerate((microscope.z, microscope.grid.y, microscope.grid.x)):
            np.testing.assert_array_equal(file["values"].dims[k][0][...], places)
            assert file["values"].dims[k][0].attrs["units"] == b"m"


@each
def test_h5py_reads_hdf5(psf, tmp_path):
    psf.save(tmp_path / "a.hdf5")
    with h5py.File(tmp_path / "a.hdf5") as file:
        found, told = file["values"], dict(file["values"].attrs)
        np.testing.assert_array_equal(found[...], psf.values)
        assert found.dtype == psf.values.dtype
        assert (told["pixel"], told["unit"].decode(), told["normalize"].decode()) == (
            psf.pixel, psf.unit, psf.normalize,
        )  # fmt: skip
        assert told["error_bound"] == psf.error_bound
        if psf.unit == "m":
            waves = [450e-9, 550e-9, 650e-9] if psf is MOVED else [550e-9]
            np.testing.assert_array_equal(told["wavelength"], waves)
            assert told["weight"].sum() == 1.0
        assert json.loads(file["description"][()])["pixel"] == psf.pixel


def test_derivatives_go_into_hdf5(tmp_path):
    psf = lm.psf(PLAIN.pupil, 5, 0.5, derivatives=["defocus", (3, 1)])
    psf.save(tmp_path / "a.h5")
    with h5py.File(tmp_path / "a.h5") as file:
        np.testing.assert_array_equal(file["derivative (3, 1)"][...], psf.derivatives[3, 1])
    loaded = lm.PSF.load(tmp_path / "a.h5")
    assert loaded.derivative_bounds == psf.derivative_bounds
    np.testing.assert_array_equal(loaded.derivatives["defocus"], psf.derivatives["defocus"])
    for suffix in (".mat", ".fits"):
        with pytest.raises(ValueError, match=r"must end in \.npz, \.h5, \.hdf5 for a PSF with derivatives"):
            psf.save(tmp_path / f"a{suffix}")


@each
def test_a_mat_file_is_one_of_matlab_whose_first_axis_is_rows(psf, tmp_path):
    psf.save(tmp_path / "a.mat")
    assert matfile_version(str(tmp_path / "a.mat")) == (2, 0)  # 7.3, which SciPy knows and does not read
    head = (tmp_path / "a.mat").read_bytes()[:128]
    assert head.startswith(b"MATLAB 7.3 MAT-file")
    assert struct.unpack("<HH", head[124:]) == (0x0200, 0x4D49)
    with h5py.File(tmp_path / "a.mat") as file:
        assert file.userblock_size == 512
        for name, found in file.items():
            kind = {"f4": "single", "f8": "double", "u2": "char"}[found.dtype.str[1:]]
            assert found.attrs["MATLAB_class"].decode() == kind, name
        # MATLAB has the axes of HDF5 in the other order.
        seen = file["values"][...].transpose()
        assert seen.shape == psf.shape[-2:] + psf.shape[:-2]
        np.testing.assert_array_equal(np.moveaxis(seen, (0, 1), (-2, -1)), psf.values)
        assert file["pixel"][0, 0] == psf.pixel
        if psf.unit == "m":
            assert file["wavelength"].shape == file["weight"].shape == (3 if psf is MOVED else 1, 1)  # a row there
        text = "".join(map(chr, file["unit"][:, 0]))
        assert text == psf.unit


def test_the_same_psf_gives_the_same_bytes_at_any_time(tmp_path, monkeypatch):
    written = []
    for when in (1e9, 1.5e9):
        monkeypatch.setattr("time.time", lambda when=when: when)
        for suffix in (".npz", ".fits", ".fits.gz", ".h5", ".mat"):
            SINGLE.save(tmp_path / f"a{suffix}")
            written.append((tmp_path / f"a{suffix}").read_bytes())
    assert written[:5] == written[5:]


compiler = pytest.mark.skipif(shutil.which("c++") is None, reason="no compiler of C++")


@compiler
def test_a_program_in_cpp_reads_an_archive_as_cnpy_does(tmp_path):
    program = tmp_path / "read"
    made = ["c++", "-std=c++17", "-o", str(program), str(Path(__file__).with_name("read_npz.cpp")), "-lz"]
    if subprocess.run(made, capture_output=True, check=False).returncode:
        pytest.skip("no zlib for C++")
    wanted = STACK.values
    STACK.save(tmp_path / "a.npz")
    words = [str(program), str(tmp_path / "a.npz")]
    shape, *values = subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines()
    assert shape == str(wanted.shape)
    np.testing.assert_array_equal(np.reshape([float.fromhex(value) for value in values], wanted.shape), wanted)
    with zipfile.ZipFile(tmp_path / "a.npz") as archive:
        assert {member.compress_type for member in archive.infolist()} == {zipfile.ZIP_DEFLATED}
