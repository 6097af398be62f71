"""The registry of formats: what it finds, what it refuses, and what other packages add to it."""

from __future__ import annotations

import importlib.metadata
import json
import sys
import types

import numpy as np
import pytest
from PIL import Image

import lommel as lm
from lommel.base.atomic import sealed
from lommel.io import registry
from lommel.io.registry import Format

PSF = lm.psf(lm.Pupil(lm.Wavefront(3.0)), 9, 0.5)


def write(psf, description):
    text = json.dumps(sealed(description, {"values": psf.values}))
    return json.dumps([text, psf.values.ravel().tolist()]).encode()


def read(data):
    text, values = json.loads(data)
    said = json.loads(text)
    return {"values": np.array(values, said["dtype"]).reshape(said["shape"])}, text


def read_raw(data):
    return np.frombuffer(data[3:], np.uint8).reshape(2, -1), Image.Exif(), None


@pytest.fixture
def other(monkeypatch):
    """A package of somebody else, with formats; and the names of those that were loaded."""
    loaded = []
    module = types.ModuleType("somebody")
    module.JSON = Format("psf", (".list",), write, read)
    module.NEEDY = Format("psf", (".needy",), write, library="no_such_library")
    module.CLASH = Format("psf", (".tif",), write)
    module.RAW = Format("photo", (".raw",), read=read_raw, starts=(b"RAW",))
    module.TEXT = "no format"

    class Entry(importlib.metadata.EntryPoint):
        def load(self):
            loaded.append(self.name)
            return super().load()

    found: list[importlib.metadata.EntryPoint] = []

    def entry_points(*, group):
        assert group == "lommel.formats"
        return found

    def bring(*names):
        found.extend(Entry(name, f"somebody:{name}", "lommel.formats") for name in names)
        return loaded

    monkeypatch.setitem(sys.modules, "somebody", module)
    monkeypatch.setattr(importlib.metadata, "entry_points", entry_points)
    monkeypatch.setattr(registry, "_FORMATS", registry._FORMATS.copy())
    registry._load_others.cache_clear()
    yield bring
    registry._load_others.cache_clear()


def test_a_format_of_another_package_is_loaded_when_its_suffix_is_met_and_not_before(other, tmp_path):
    loaded = other("JSON")
    PSF.save(tmp_path / "a.npz")
    assert loaded == []
    PSF.save(tmp_path / "a.list")
    assert loaded == ["JSON"]
    again = lm.PSF.load(tmp_path / "a.list")
    np.testing.assert_array_equal(again.values, PSF.values)
    assert (again.pupil, again.method, again.grid) == (PSF.pupil, PSF.method, PSF.grid)
    assert loaded == ["JSON"]
    with pytest.raises(ValueError, match=r"\.mat, \.list for a PSF, got '\.xyz' in '.*a\.xyz'"):
        PSF.save(tmp_path / "a.xyz")


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("CLASH", r"suffixes must be new for a PSF, got \.tif"),
        ("TEXT", "format must be a Format, got 'no format'"),
        ("MISSING", "no attribute 'MISSING'"),
    ],
)
def test_a_format_of_another_package_that_cannot_be_is_left_out_with_a_warning(other, tmp_path, name, why):
    other(name, "JSON")
    with pytest.warns(RuntimeWarning, match=rf"the format {name} \(somebody:{name}\) is ignored: .*{why}"):
        PSF.save(tmp_path / "a.list")
    assert lm.PSF.load(tmp_path / "a.list").shape == (9, 9)


def test_the_library_of_a_format_is_asked_for_before_anything_is_written(other, tmp_path):
    other("NEEDY")
    with pytest.raises(ImportError, match=r"the format NEEDY needs no_such_library: pip install no_such_library$"):
        PSF.save(tmp_path / "a.needy")
    assert not list(tmp_path.iterdir())
    with pytest.raises(ValueError, match=r"path must end in \.tif, .* for a PSF, got '\.needy'"):
        lm.PSF.load(tmp_path / "a.needy")  # which it does not read


def test_a_photograph_of_another_package_is_told_by_how_it_starts(other, tmp_path):
    loaded = other("RAW")
    (tmp_path / "photo").write_bytes(b"RAW" + bytes(range(6)))
    Image.fromarray(np.zeros((2, 3), np.uint8)).save(tmp_path / "a.png")
    assert lm.imaging.read_photo(tmp_path / "a.png").values.shape == (2, 3)
    assert loaded == []
    assert lm.imaging.read_photo(tmp_path / "photo").values.tolist() == [[0, 1, 2], [3, 4, 5]]
    assert loaded == ["RAW"]
    (tmp_path / "photo").write_bytes(b"WAR")
    with pytest.raises(lm.imaging.PhotoError, match="photo is not a PNG, JPEG, TIFF, EXR, BMP, HEIC or RAW"):
        lm.imaging.read_photo(tmp_path / "photo")
    with pytest.raises(ValueError, match=r"\.tif, \.tiff, \.exr for a photograph, got '\.raw'"):
        lm.imaging.write_photo(tmp_path / "a.raw", np.zeros((2, 3)))  # which it does not write


def test_a_kind_of_files_that_there_is_not_is_refused():
    kinds = "'psf', 'colours', 'field', 'photo', 'depth map', 'images', 'zernike', 'opd', 'molecules', "
    kinds += "'video'"
    with pytest.raises(ValueError, match=f"kind must be one of {kinds}, got"):
        Format("film", (".mov",))
