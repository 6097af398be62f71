"""What files cost to read, measured: hostile ones of every kind, and that all are opened where that is limited."""

from __future__ import annotations

import ast
import json
import subprocess
import sys

import pytest

import hostile_files
import organisation

COMPRESSED = (".png", ".jpg", ".tif", ".npz", ".fits.gz", ".datx")
FILES = hostile_files.files()


@pytest.fixture(scope="module")
def costs() -> dict[str, tuple[int, float, int, str]]:
    """Bytes of each file, work and bytes of memory that it takes, and what is told of it."""
    command = [sys.executable, "-W", "error", hostile_files.__file__]
    result = subprocess.run(command, capture_output=True, text=True, timeout=900, check=False)
    assert result.returncode == 0, result.stderr
    return {name: tuple(rest) for name, *rest in map(json.loads, result.stdout.splitlines())}


@pytest.mark.parametrize("name", FILES)
def test_a_hostile_file_costs_little_and_is_told_in_short(name, costs):
    size, work, memory, told = costs[name]
    times = 100 if FILES[name][0] in COMPRESSED and "pages" not in name else 10
    assert memory <= max(hostile_files.ENOUGH, times * size) + 2**24, told  # and what libraries take the first time
    assert work <= max(5e7, 20 * size), told  # about a second, which would count what else the machine does
    assert not told.startswith("ESCAPED")
    assert len(told) < 2200


# Files are opened and parsed in base/reading.py, and besides only so:
ARGUED = {
    ("__init__.py", "open"): "the package's own list of names",
    ("page/server.py", "read_text"): "the package's own live page",
    ("page/server.py", "read_bytes"): "the package's own live page",
    ("cli/main.py", "read_text"): "the package's own commands",
    ("cli/lens_commands.py", "read_bytes"): "the package's own examples",
    ("cli/lens_commands.py", "loads"): "the package's own notebooks",
    ("cli/messages.py", "open"): "the null device, to write to",
    ("cli/lens_commands.py", "open"): "a browser",
    ("base/atomic.py", "open"): "to write, and a store to lock it",
    ("base/atomic.py", "loads"): "of what was just written as JSON",
    ("io/fits_images.py", "open"): "of what reading has looked at: bytes in memory, no longer than their headers say",
    ("io/fits_images.py", "GzipFile"): "no farther than the headers say",
    ("io/psf_formats.py", "fromstring"): "of a text whose elements were counted",
    ("io/psf_formats.py", "File"): "to write, in memory",
    ("io/psf_formats.py", "ZipFile"): "to write, in memory",
    ("io/field_files.py", "open"): "an array of a folder whose files were looked at",
    ("imaging/datasets.py", "open_group"): "to write, in memory",
    ("imaging/datasets.py", "open"): "to write, and pictures that it wrote itself",
    ("io/photos.py", "File"): "its header alone first, whose size is looked at",
    ("recorded/frames.py", "open"): "a folder whose descriptions were parsed by reading",
    ("microscopy/store.py", "open"): "a folder that it wrote itself",
    ("io/videos.py", "open"): "frame by frame, and to write",
    ("localize/localizations.py", "File"): "to write, in memory",
    ("stacks.py", "open"): "a store, by its own reader",
    ("optics/aperture/mask.py", "decompressobj"): "piece by piece, up to the side of the mask",
}
# What opens or parses a file, whatever it is called on.
OPENING = {
    *("open", "fdopen", "read_text", "read_bytes", "fromfile", "memmap", "mmap", "loadtxt", "genfromtxt", "loadmat"),
    *("loads", "TiffFile", "imread", "ZipFile", "GzipFile", "decompressobj", "PngImageFile", "JpegImageFile"),
    *("File", "open_group", "open_array", "fromstring", "XML", "iterparse"),
}
# Of what else has such names, only these modules do.
OF_MODULES = {"load", "parse", "decompress"}
MODULES = {"json", "np", "numpy", "pickle", "tomllib", "marshal", "yaml", "ET", "zlib", "gzip", "bz2", "lzma"}


def opened(tree: ast.AST) -> set[str]:
    """Return the names of the calls in a module that open or parse files."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module in ("json", "tomllib", "pickle", "gzip", "zipfile"):
            found |= {name.name for name in node.names if name.name in ("load", "loads", "ZipFile", "open")}
        if not isinstance(node, ast.Call):
            continue
        called = node.func
        name = getattr(called, "attr", getattr(called, "id", ""))
        owner = getattr(getattr(called, "value", None), "id", "")
        if name in OPENING or (name in OF_MODULES and owner in MODULES):
            found.add(name)
    return found


def test_files_are_opened_where_their_cost_is_limited():
    trees = {f"{name}.py": tree for name, tree in organisation.modules().items() if name != "base/reading"}
    assert {(name, call) for name, tree in trees.items() for call in opened(tree)} == ARGUED.keys()
