"""The registry of formats: what it finds and what it refuses."""

from __future__ import annotations

import json

import numpy as np
import pytest

import lommel as lm
from lommel.base.atomic import sealed
from lommel.io import psf_files, registry
from lommel.io.registry import Format

PSF = lm.psf(lm.Pupil(lm.Wavefront(3.0)), 9, 0.5)
assert psf_files  # which registers the formats of PSFs, before a test replaces the list


def write(psf, description):
    text = json.dumps(sealed(description, {"values": psf.values}))
    return json.dumps([text, psf.values.ravel().tolist()]).encode()


def read(data):
    text, values = json.loads(data)
    said = json.loads(text)
    return {"values": np.array(values, said["dtype"]).reshape(said["shape"])}, text


def test_a_format_that_is_registered_is_written_and_read(tmp_path, monkeypatch):
    monkeypatch.setattr(registry, "_FORMATS", registry._FORMATS.copy())
    registry.register(Format("psf", (".list",), write, read))
    PSF.save(tmp_path / "a.list")
    again = lm.PSF.load(tmp_path / "a.list")
    np.testing.assert_array_equal(again.values, PSF.values)
    assert (again.pupil, again.method, again.grid) == (PSF.pupil, PSF.method, PSF.grid)
    with pytest.raises(ValueError, match=r"path must end in .*, \.list for a PSF, got '\.xyz' in '.*a\.xyz'"):
        PSF.save(tmp_path / "a.xyz")


def test_the_library_of_a_format_is_asked_for_before_anything_is_written(tmp_path, monkeypatch):
    monkeypatch.setattr(registry, "_FORMATS", registry._FORMATS.copy())
    registry.register(Format("psf", (".needy",), write, library="no_such_library"))
    with pytest.raises(ImportError, match=r"the format NEEDY needs no_such_library: pip install no_such_library$"):
        PSF.save(tmp_path / "a.needy")
    assert not list(tmp_path.iterdir())
