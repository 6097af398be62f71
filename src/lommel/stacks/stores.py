"""The kinds of stores, by the suffix of their paths."""

from __future__ import annotations

from pathlib import Path

from lommel.base import validation
from lommel.stacks.hdf5_store import Hdf5Store
from lommel.stacks.store import Store
from lommel.stacks.zarr_store import ZarrStore

KINDS: dict[str, type[Store]] = {".zarr": ZarrStore, ".h5": Hdf5Store, ".hdf5": Hdf5Store}


def kind(path: Path) -> type[Store]:
    """Return what stores of a path are; ValueError if its suffix is unknown."""
    if path.suffix.lower() not in KINDS:
        raise ValueError(f"store must end in {', '.join(KINDS)}, got {validation.shown(str(path))}")
    return KINDS[path.suffix.lower()]
