"""The framework that arrays belong to, and the few things that frameworks do each in a way of their own."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.optional import library

_EXTRAS = ("jax", "torch", "cupy")
_NEEDED = ("matmul", "take", "where", "isfinite", "concat", "flip")


@dataclass(frozen=True)
class Namespace:
    """A framework with the functions of the Python array API standard.

    Attributes
    ----------
    name : str
        "numpy", "jax", "torch", "cupy", or of another module.
    xp : module
        The functions themselves, looked up once.
    """

    name: str
    xp: Any = field(compare=False, repr=False)

    @classmethod
    def of(cls, given: Any) -> Namespace:
        """Return that of a module, or of its name; None is NumPy.

        Raises
        ------
        TypeError
            If it is neither, or has not the functions of the standard.
        ImportError
            If what is named is not installed; the message says how to get it.
        """
        module = "numpy" if given is None else given
        name = module if isinstance(module, str) else str(getattr(module, "__name__", ""))
        name = name.removeprefix("array_api_compat.")
        top = name.partition(".")[0]
        if top in _EXTRAS:
            library(top, f"a twin in {top} needs", top)
            home = "jax.numpy" if top == "jax" else f"array_api_compat.{top}"
            return cls(top, library(home, f"a twin in {top} needs", top))
        try:
            found = import_module(name) if isinstance(module, str) else module
        except (ImportError, ValueError):
            found = None
        if found is None or not all(hasattr(found, each) for each in _NEEDED):
            raise TypeError(
                "xp must be a module of the array API such as numpy, jax.numpy, torch or cupy, or its name, got "
                f"{validation.shown(given)}"
            )
        return cls(name, found)

    def __reduce__(self) -> tuple[Any, ...]:
        return Namespace.of, (self.name,)

    def put(self, values: Any, device: Any, dtype: Any = None) -> Any:
        """Return an array of the framework made of one of NumPy, on a device, and at once even while it traces."""
        if self.name == "torch":
            values = np.array(values)  # it warns of arrays that are not to be written to
        if self.name != "jax":
            return self.xp.asarray(values, dtype=dtype, device=device)
        import jax

        with jax.ensure_compile_time_eval():
            return self.xp.asarray(values, dtype=dtype, device=device)

    def has_double(self, device: Any) -> bool:
        """Whether arrays there may be float64: JAX has them if it was told so, some devices have none."""
        try:
            return bool(self.put(np.zeros(1), device).dtype == self.xp.float64)
        except (TypeError, ValueError, RuntimeError):  # torch on a device without them
            return False

    def matmul(self, a: Any, b: Any) -> Any:
        """Return a matrix product in the full precision of its type."""
        if self.name == "jax":
            return self.xp.matmul(a, b, precision="highest")
        return self.xp.matmul(a, b)

    def coarseness(self, unit: float) -> float:
        """Return what products round operands to where a user allowed it for float32, told by its `unit`."""
        if unit < 1e-10:
            return 0.0
        if self.name == "torch":
            import torch

            return {"highest": 0.0, "high": 2.0**-11}.get(torch.get_float32_matmul_precision(), 2.0**-8)
        if self.name == "cupy":
            return 2.0**-11 if os.environ.get("CUPY_TF32", "0") != "0" else 0.0
        return 0.0

    def apart(self, function: Any, *given: Any) -> Any:
        """Return what a function makes, which in JAX XLA for processors is not to join with what is around it.

        There it would compute what is used in several places in each of them, and turn axes value by value.
        """
        if self.name != "jax":
            return function(*given)
        import jax
        from jax.experimental.xla_metadata import set_xla_metadata

        def alone(*given: Any) -> Any:
            with set_xla_metadata(inlineable="false"):  # type: ignore[no-untyped-call]
                return jax.jit(function)(*given)

        return jax.lax.platform_dependent(*given, cpu=alone, default=function)

    def flip(self, x: Any, axis: int) -> Any:
        """Return an array with one axis reversed, in JAX by no function that :meth:`apart` would keep apart."""
        if self.name == "jax":
            import jax

            return jax.lax.rev(x, (axis,))
        return self.xp.flip(x, axis=axis)

    def turned(self, x: Any) -> Any:
        """Return an array of three axes with these in the opposite order."""
        if self.name == "jax":
            return self.apart(_turned, x)
        return self.xp.permute_dims(x, (2, 1, 0))

    def stop(self, x: Any) -> Any:
        """Return `x`, through which no gradient passes."""
        if self.name == "jax":
            import jax

            return jax.lax.stop_gradient(x)
        return x.detach() if self.name == "torch" else x

    def concrete(self, x: Any) -> bool:
        """Whether `x` has values now, rather than when what is being traced is run."""
        if self.name == "jax":
            import jax

            return not isinstance(x, jax.core.Tracer)
        if self.name == "torch":
            import torch

            if torch.compiler.is_compiling():
                return False
            try:
                self.to_numpy(x)
            except RuntimeError:  # within torch.func
                return False
        return True

    def values_now(self, x: Any) -> Any:
        """Return the values of `x` as an array of NumPy if they are known, on a processor, and nobody follows them.

        That is a transform, a program that is being made, or a derivative forwards; None then.
        """
        if self.name == "numpy":
            return x
        if self.name != "torch" or x.device.type != "cpu":
            return None
        import torch
        from torch.utils._python_dispatch import _get_current_dispatch_mode

        if torch.compiler.is_compiling() or torch.jit.is_tracing() or _get_current_dispatch_mode() is not None:
            return None
        if torch.autograd.forward_ad.unpack_dual(x).tangent is not None:
            return None
        try:
            return x.detach().numpy()
        except (RuntimeError, TypeError):  # within torch.func; of a type that NumPy has not
            return None

    def times(self, x: Any, factor: Any) -> Any:
        """Return a product, where that is possible in the memory of `x`, which is nobody else's."""
        if self._alone(x):
            x *= factor
            return x
        return x * factor

    def plus(self, x: Any, added: Any) -> Any:
        """Return a sum, where that is possible in the memory of `x`, which is nobody else's."""
        if self._alone(x):
            x += added
            return x
        return x + added

    def _alone(self, x: Any) -> bool:
        return self.name == "torch" and not x.requires_grad and self.values_now(x) is not None

    def to_numpy(self, x: Any) -> Any:
        """Return values as an array of NumPy."""
        if self.name == "cupy":
            return x.get()
        if self.name == "torch":
            return x.detach().cpu().numpy()
        if hasattr(x, "to_device") and self.name == "array_api_strict":
            x = x.to_device(self.xp.Device("CPU_DEVICE"))
        return np.asarray(x)


def _turned(x: Any) -> Any:
    return x.transpose((2, 1, 0))
