"""Frameworks that traced plans are tested in, on devices that a processor can emulate and on a graphics processor."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from ctypes import CDLL
from importlib import import_module
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np
import pytest


@contextmanager
def hasty_programs() -> Iterator[None]:
    """Have JAX compile without most optimisations, which takes half as long: for programs that run once.

    Programs compiled before serve on. Bounds are tested with programs as users have them.
    """
    jax = import_module("jax")
    jax.config.update("jax_disable_most_optimizations", True)
    try:
        yield
    finally:
        jax.config.update("jax_disable_most_optimizations", False)


class Framework(NamedTuple):
    """One to test, by the module that a user names."""

    module: str
    device: str | None = None
    double: bool = True

    @contextmanager
    def used(self) -> Iterator[Any]:
        """Yield the module, as users find it who asked for float64 or did not."""
        xp = import_module(self.module)
        with import_module("jax").enable_x64(self.double) if self.module == "jax.numpy" else nullcontext():
            yield xp

    def place(self, xp: Any) -> Any:
        """Return the device as the framework calls it."""
        return xp.Device(self.device) if self.module == "array_api_strict" and self.device else self.device

    def array(self, xp: Any, values: Any) -> Any:
        """Return an array there."""
        if self.module == "cupy":  # whose asarray takes no device
            return xp.asarray(np.array(values, dtype=np.float64))
        return xp.asarray(np.array(values, dtype=np.float64), device=self.place(xp))

    def to_numpy(self, values: Any) -> np.ndarray:
        """Return the values as float64."""
        if self.module == "array_api_strict":
            values = values.to_device(import_module(self.module).Device("CPU_DEVICE"))
        elif self.module == "torch":
            values = values.detach().cpu().numpy()
        elif self.module == "cupy":
            values = values.get()
        return np.asarray(values, dtype=np.float64)


ALL = [
    Framework("numpy"),
    Framework("array_api_strict"),
    Framework("array_api_strict", "device1"),
    Framework("jax.numpy"),
    Framework("jax.numpy", double=False),
    Framework("torch"),
    Framework("torch", "cuda"),
    Framework("cupy"),
]


def _missing(one: Framework) -> str | None:
    """Return what a framework lacks here."""
    if not find_spec(one.module.partition(".")[0]):
        return f"{one.module} is not installed"
    if one.device == "cuda" or one.module == "cupy":
        try:
            CDLL("libcuda.so.1")
        except OSError:
            return "there is no graphics processor with its driver"
    return None


THERE = [
    pytest.param(
        one,
        id="-".join(filter(None, [one.module, one.device, "" if one.double else "float32"])),
        marks=[pytest.mark.skip(why)] if (why := _missing(one)) else [],
    )
    for one in ALL
]
