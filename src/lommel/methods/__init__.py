"""The ways to evaluate the diffraction integral, one file each."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from lommel.methods.registry import *  # noqa: F403


def __getattr__(name: str) -> Any:
    # What imports all methods, where most programs take one or two; while it does so, names are those of files.
    registry = import_module("lommel.methods.registry")
    if name not in ("__all__", *getattr(registry, "__all__", ())):
        raise AttributeError(f"module 'lommel.methods' has no attribute {name!r}")
    return getattr(registry, name)
