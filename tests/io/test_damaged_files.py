"""Files that are no PSF of this package, or no longer: a FileError that names the file, never a wrong PSF."""

from __future__ import annotations

import json
import sys

import h5py
import numpy as np
import pytest
import tifffile
from astropy.io import fits
from scipy.io import savemat

import lommel as lm
from lommel.io.psf_files import FileError

SUFFIXES = [".tif", ".npy", ".npz", ".fits", ".fits.gz", ".h5", ".mat"]
PSF = lm.psf(lm.Pupil(lm.Wavefront(1.0), wavelength=5e-7, f_number=2.0), 9, 5e-7)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_no_beginning_of_a_file_loads_as_anything_but_the_whole(suffix, tmp_path):
    file = tmp_path / f"a{suffix}"
    PSF.save(file)
    data, whole = file.read_bytes(), lm.PSF.load(file).values
    for length in [*range(0, len(data), max(7, len(data) // 150)), len(data) - 1]:
        file.write_bytes(data[:length])
        try:
            values = lm.PSF.load(file).values
        except FileError:
            continue
        np.testing.assert_array_equal(values, whole)


def foreign(suffix: str, path) -> None:
    grey = np.arange(12, dtype=np.uint16).reshape(3, 4)
    if suffix == ".tif":
        tifffile.imwrite(path, grey)
    elif suffix == ".npy":
        np.save(path, grey)
    elif suffix == ".npz":
        np.savez(path, values=grey)
    elif suffix == ".mat":
        savemat(path, {"values": grey})
    elif suffix == ".h5":
        with h5py.File(path, "w") as file:
            file["values"] = grey
    else:
        fits.PrimaryHDU(grey).writeto(path)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_an_image_of_another_program_is_no_psf(suffix, tmp_path):
    foreign(suffix, tmp_path / f"a{suffix}")
    with pytest.raises(FileError, match=rf"a{suffix} is not a PSF written by lommel: "):
        lm.PSF.load(tmp_path / f"a{suffix}")


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize(
    "data", [b"", b"\0" * 100, b"name = 'lens'\n", b"\x93NUMPY\x09\x00", b"PK\x03\x04", b"II*\0"]
)
def test_what_is_no_image_at_all_is_no_psf(suffix, data, tmp_path):
    (tmp_path / f"a{suffix}").write_bytes(data)
    with pytest.raises(FileError, match=rf"a{suffix} is not a PSF written by lommel: ."):
        lm.PSF.load(tmp_path / f"a{suffix}")


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_python_objects_are_never_unpickled(tmp_path):
    class Trap:
        def __reduce__(self):
            return sys.exit, (99,)

    np.save(tmp_path / "a.npy", np.array([Trap()], dtype=object), allow_pickle=True)
    np.savez(tmp_path / "a.npz", values=np.array([Trap()], dtype=object), description=np.array('{"shape": [1]}'))
    for name in ("a.npy", "a.npz"):
        with pytest.raises(FileError, match="pickle"):
            lm.PSF.load(tmp_path / name)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_missing_file_is_an_os_error_with_its_name(suffix, tmp_path):
    with pytest.raises(FileNotFoundError, match="nowhere"):
        lm.PSF.load(tmp_path / f"nowhere{suffix}")
    (tmp_path / f"folder{suffix}").mkdir()
    with pytest.raises(IsADirectoryError):
        lm.PSF.load(tmp_path / f"folder{suffix}")


@pytest.mark.parametrize(
    ("suffix", "library", "module", "extra"),
    [
        (".tif", "tifffile", "tifffile", "images"),
        (".fits", "astropy", "astropy", "fits"),
        (".mat", "h5py", "h5py", "hdf5"),
    ],
)
def test_a_missing_library_is_told_with_what_to_install(suffix, library, module, extra, tmp_path, monkeypatch):
    PSF.save(tmp_path / f"old{suffix}")
    monkeypatch.setitem(sys.modules, module, None)
    for call in (lambda: PSF.save(tmp_path / f"new{suffix}"), lambda: lm.PSF.load(tmp_path / f"old{suffix}")):
        with pytest.raises(ImportError, match=rf'needs {library}: pip install .*\(the extra "{extra}" of lommel'):
            call()
    assert [path.name for path in tmp_path.iterdir()] == [f"old{suffix}"]
    PSF.save(tmp_path / "a.npz")
    assert lm.PSF.load(tmp_path / "a.npz").shape == (9, 9)


def rewritten(path, **changes: object) -> None:
    """Write a .npz anew with other arrays, or another description."""
    with np.load(path) as archive:
        parts = dict(archive) | changes
    np.savez(path, **parts)


@pytest.mark.parametrize(
    "change",
    [
        lambda v: v * -5,
        lambda v: v.astype(np.float64),
        lambda v: np.where(v == v.max(), np.nan, v),
        lambda v: np.nextafter(v, np.float32(1)),
        lambda v: v[::-1, ::-1].T.copy() if v[0, 1] != v[1, 0] else v * 0,
    ],
)
def test_values_that_were_not_saved_are_refused(change, tmp_path):
    PSF.save(tmp_path / "a.npz")
    rewritten(tmp_path / "a.npz", values=change(PSF.values))
    with pytest.raises(FileError, match="its checksum does not match"):
        lm.PSF.load(tmp_path / "a.npz")


def test_a_description_without_a_checksum_or_changed_by_hand_is_refused(tmp_path):
    PSF.save(tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as archive:
        description = json.loads(archive["description"].tobytes())
    rewritten(tmp_path / "a.npz", description=np.array(json.dumps(description | {"error_bound": 1e-12})))
    with pytest.raises(FileError, match="its checksum does not match: it is damaged, or was changed"):
        lm.PSF.load(tmp_path / "a.npz")
    del description["checksum"]
    rewritten(tmp_path / "a.npz", description=np.array(json.dumps(description)))
    with pytest.raises(FileError, match="it has no checksum, so it may be incomplete; save it again"):
        lm.PSF.load(tmp_path / "a.npz")


def test_derivatives_that_were_not_saved_are_refused(tmp_path):
    psf = lm.psf(PSF.pupil, 5, 5e-7, derivatives=["defocus"], integrate=False)
    psf.save(tmp_path / "a.npz")
    np.testing.assert_array_equal(lm.PSF.load(tmp_path / "a.npz").derivatives["defocus"], psf.derivatives["defocus"])
    rewritten(tmp_path / "a.npz", **{"derivative defocus": -psf.derivatives["defocus"]})
    with pytest.raises(FileError, match="checksum"):
        lm.PSF.load(tmp_path / "a.npz")


@pytest.mark.parametrize("suffix", [".tif", ".npy", ".h5", ".mat"])
def test_any_bit_of_the_values_that_turns_is_noticed(suffix, tmp_path):
    file = tmp_path / f"a{suffix}"
    PSF.save(file)
    data = file.read_bytes()
    start = data.index(PSF.values.tobytes())
    for bit in range(0, 8 * PSF.values.nbytes, 29):
        damaged = bytearray(data)
        damaged[start + bit // 8] ^= 1 << bit % 8
        file.write_bytes(damaged)
        with pytest.raises(FileError, match="its checksum does not match"):
            lm.PSF.load(file)
