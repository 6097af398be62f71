"""Stores of strangers: refused by what stands in them before it costs anything, in little time and memory."""

from __future__ import annotations

import json
import os
import resource
import shutil
import time
from pathlib import Path

import numpy as np
import pytest

import lommel as lm
from lommel.io import zarr_folders
from lommel.io.psf_files import FileError
from lommel.io.zarr_folders import Layout

PUPILS = lm.Pupil(lm.Wavefront(np.linspace(0.0, 1.0, 6), nonradial={(3, 1): 0.2}))


@pytest.fixture
def little():
    """At most 256 MB more than there is, and few seconds."""
    before = resource.getrlimit(resource.RLIMIT_AS)
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + 2**28, before[1]))
    began = time.process_time()
    yield
    resource.setrlimit(resource.RLIMIT_AS, before)
    assert time.process_time() - began < 2.0


@pytest.fixture(scope="module")
def good(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("good") / "a.zarr"
    lm.psf_to(path, PUPILS, 5, 0.5, chunk=2)
    return path


def copied(good: Path, folder: Path) -> Path:
    shutil.copytree(good, folder / "a.zarr")
    return folder / "a.zarr"


@pytest.mark.parametrize("make", [os.mkfifo, lambda path: path.symlink_to("/dev/zero")], ids=["pipe", "device"])
@pytest.mark.parametrize("file", ["zarr.json", "z/c.0", "values/c.0.0.0", "chunks/checksum/c.0"])
@pytest.mark.parametrize("call", ["open", "psf_to"])
def test_what_is_no_file_is_not_read(make, file, call, good, tmp_path, little):
    path = copied(good, tmp_path)
    file = file.replace("z/", "axis_0/")
    (path / file).unlink()
    make(path / file)
    with pytest.raises((FileError, OSError), match="regular file"):
        lm.open_stack(path)[:] if call == "open" else lm.psf_to(path, PUPILS, 5, 0.5, chunk=2)[:]


def test_an_array_that_is_stored_another_way_is_refused(tmp_path):
    array = zarr_folders.ZarrArray(tmp_path / "a.zarr" / "values", Layout((4, 6), (2, 3), "<f8", ("y", "x")))
    values = np.arange(24.0).reshape(4, 6)
    zarr_folders.write_group(tmp_path / "a.zarr", {})
    array.create(values=values)
    np.testing.assert_array_equal(zarr_folders.ZarrArray.open(array.folder).read(), values)
    meta = array.folder / "zarr.json"
    known = json.loads(meta.read_text())
    for change in (
        {"codecs": [{"name": "bytes", "configuration": {"endian": "big"}}]},
        {"codecs": [*known["codecs"], {"name": "gzip", "configuration": {"level": 5}}]},
        {"data_type": "complex128"},
        {"shape": [4, -6]},
        {"shape": [4, 6, 1]},
        {"shape": [True, 6]},
        {"chunk_grid": {"name": "rectangular", "configuration": {"chunk_shape": [2, 3]}}},
        {"chunk_key_encoding": {"name": "v2"}},
        {"chunk_key_encoding": {"name": "default", "configuration": {"separator": "/../"}}},
    ):
        meta.write_text(json.dumps(known | change))
        with pytest.raises(ValueError, match="its array values has an unsupported layout; read it by zarr"):
            zarr_folders.ZarrArray.open(array.folder)
    meta.write_text(json.dumps(known | {"shape": [2**20, 2**20]}))
    with pytest.raises(ValueError, match="1048576 x 1048576 values; the limit is 2147483648"):
        zarr_folders.ZarrArray.open(array.folder).read()


@pytest.mark.parametrize("separator", [".", "/"])
@pytest.mark.parametrize("dtype", ["<f4", "<f8", "|u1", "<i8"])
def test_zarr_reads_what_is_written_plainly_and_it_what_zarr_writes(separator, dtype, tmp_path):
    zarr = pytest.importorskip("zarr")
    values = np.arange(35).reshape(5, 7).astype(dtype)
    zarr_folders.write_group(tmp_path / "a.zarr", {"said": 1})
    layout = Layout((5, 7), (2, 3), dtype, ("y", "x"))
    array = zarr_folders.ZarrArray(tmp_path / "a.zarr" / "group" / "values", layout, separator)
    if separator == ".":
        array.create(values=values, fill=-1 if dtype[1] == "i" else 0, attributes={"units": "m"})
        found = zarr.open_group(tmp_path / "a.zarr", mode="r")["group/values"]
        np.testing.assert_array_equal(found[...], values)
        assert (found.dtype, found.chunks, found.attrs["units"]) == (values.dtype, (2, 3), "m")
        assert found.metadata.dimension_names == ("y", "x")
    encoding = {"name": "default", "separator": separator}
    made = zarr.create_group(tmp_path / "b.zarr", zarr_format=3).create_array(
        "values", data=values, chunks=(2, 3), compressors=None, chunk_key_encoding=encoding
    )
    opened = zarr_folders.ZarrArray.open(tmp_path / "b.zarr" / "values")
    np.testing.assert_array_equal(opened.read(), made[...])
    assert (opened.layout.shape, opened.layout.chunks, opened.separator) == ((5, 7), (2, 3), separator)
