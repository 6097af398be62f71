"""Files that are no PSF of this package, or no longer: a FileError that names the file, never a wrong PSF."""

from __future__ import annotations

import json
import sys

import numpy as np
import pytest
import tifffile
from PIL import Image

import lommel as lm
from lommel.files import FileError

SUFFIXES = [".tif", ".npy", ".npz", ".png"]
PSF = lm.psf(lm.Pupil(lm.Wavefront(1.0), wavelength=5e-7, f_number=2.0), 9, 5e-7)


def test_a_file_error_is_a_value_error():
    assert issubclass(FileError, ValueError)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_no_beginning_of_a_file_loads_as_anything_but_the_whole(suffix, tmp_path):
    file = tmp_path / f"a{suffix}"
    PSF.save(file)
    data, whole = file.read_bytes(), lm.PSF.load(file).values
    for length in [*range(0, len(data), 7), len(data) - 1]:
        file.write_bytes(data[:length])
        try:
            values = lm.PSF.load(file).values
        except FileError:
            continue
        # The last bytes of a picture hold nothing.
        np.testing.assert_array_equal(values, whole)


def foreign(suffix: str, path) -> None:
    grey = np.arange(12, dtype=np.uint16).reshape(3, 4)
    if suffix == ".tif":
        tifffile.imwrite(path, grey)
    elif suffix == ".npy":
        np.save(path, grey)
    elif suffix == ".npz":
        np.savez(path, values=grey)
    else:
        Image.fromarray(grey).save(path)


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


def test_an_ome_file_of_another_program_is_no_psf(tmp_path):
    metadata = {"axes": "YX", "Description": "mitochondria"}
    tifffile.imwrite(tmp_path / "a.tif", np.ones((4, 4), np.float32), ome=True, metadata=metadata)
    with pytest.raises(FileError, match=r"a\.tif is not a PSF written by lommel"):
        lm.PSF.load(tmp_path / "a.tif")


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_python_objects_are_never_unpickled(tmp_path):
    class Trap:
        def __reduce__(self):
            return sys.exit, (99,)

    np.save(tmp_path / "a.npy", np.array([Trap()], dtype=object), allow_pickle=True)
    np.savez(tmp_path / "a.npz", values=np.array([Trap()], dtype=object), description=np.array("{}"))
    for name in ("a.npy", "a.npz"):
        with pytest.raises(FileError, match="pickle"):
            lm.PSF.load(tmp_path / name)


def pupil(**changes: object) -> dict[str, object]:
    return PSF.pupil.to_dict() | changes


@pytest.mark.parametrize(
    "changes",
    [
        {"pixel": None},
        {"pixel": "wide"},
        {"pixel": -1.0},
        {"normalize": "area"},
        {"shape": [81]},
        {"shape": [9, 8]},
        {"dtype": "int8"},
        {"dtype": "object"},
        {"scale": [1.0, 2.0, 3.0]},
        {"scale": "x"},
        {"error_bound": "small"},
        {"method": {"name": "Guess"}},
        {"method": {"name": "FresnelErf"}},
        {"method": {"name": "NijboerZernike", "tol": 5}},
        {"method": None},
        {"pupil": {}},
        {"pupil": pupil(wavelength=550)},
        {"pupil": pupil(obscuration=2)},
        {"pupil": pupil(wavefront={"defocus": [1.0, 2.0], "spherical": 0.0, "higher": []})},
        {"pupil": pupil(geometry={"object_distance": ["far"]})},
    ],
    ids=str,
)
def test_a_description_that_cannot_be_true_is_refused(changes, tmp_path):
    PSF.save(tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as archive:
        values, description = archive["values"], json.loads(str(archive["description"]))
    np.savez(tmp_path / "a.npz", values=values, description=np.array(json.dumps(description | changes)))
    with pytest.raises(FileError, match=r"a\.npz is not a PSF written by lommel: "):
        lm.PSF.load(tmp_path / "a.npz")


@pytest.mark.parametrize("key", ["pupil", "method", "normalize", "pixel", "error_bound", "scale", "shape", "dtype"])
def test_a_description_that_lacks_something_is_refused_with_its_name(key, tmp_path):
    PSF.save(tmp_path / "a.npz")
    with np.load(tmp_path / "a.npz") as archive:
        values, description = archive["values"], json.loads(str(archive["description"]))
    del description[key]
    np.savez(tmp_path / "a.npz", values=values, description=np.array(json.dumps(description)))
    with pytest.raises(FileError, match=key):
        lm.PSF.load(tmp_path / "a.npz")


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_missing_file_is_an_os_error_with_its_name(suffix, tmp_path):
    with pytest.raises(FileNotFoundError, match="nowhere"):
        lm.PSF.load(tmp_path / f"nowhere{suffix}")
    (tmp_path / f"folder{suffix}").mkdir()
    with pytest.raises(IsADirectoryError):
        lm.PSF.load(tmp_path / f"folder{suffix}")


@pytest.mark.parametrize(
    ("suffix", "library", "module"), [(".tif", "tifffile", "tifffile"), (".png", "PIL", "PIL.Image")]
)
def test_a_missing_library_is_told_with_what_to_install(suffix, library, module, tmp_path, monkeypatch):
    PSF.save(tmp_path / f"old{suffix}")
    monkeypatch.setitem(sys.modules, module, None)
    for call in (lambda: PSF.save(tmp_path / f"new{suffix}"), lambda: lm.PSF.load(tmp_path / f"old{suffix}")):
        with pytest.raises(ImportError, match=rf'needs {library}: install "lommel\[images\]"'):
            call()
    assert [path.name for path in tmp_path.iterdir()] == [f"old{suffix}"]
    PSF.save(tmp_path / "a.npz")
    assert lm.PSF.load(tmp_path / "a.npz").shape == (9, 9)


def test_a_picture_loads_however_large_it_is(tmp_path, monkeypatch):
    monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 16)
    PSF.save(tmp_path / "a.png")
    assert lm.PSF.load(tmp_path / "a.png").shape == (9, 9)
