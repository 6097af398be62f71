"""Optional libraries: what is said where one is missing, and where one is there that cannot be loaded."""

from __future__ import annotations

import pytest

from lommel.base import optional


def test_a_library_that_is_there_and_cannot_be_loaded_is_not_called_missing(tmp_path, monkeypatch):
    (tmp_path / "loaded_by_halves.py").write_text("raise ImportError('m.so: failed to map segment')")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(
        ImportError, match=r"^plots need loaded_by_halves, which cannot be loaded: m\.so: failed to map"
    ):
        optional.library("loaded_by_halves", "plots need", "plot")
    with pytest.raises(
        ImportError, match=r'^plots need nowhere_at_all: pip install nowhere_at_all \(the extra "plot"'
    ):
        optional.library("nowhere_at_all", "plots need", "plot")
