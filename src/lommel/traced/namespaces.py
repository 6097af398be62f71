"""Array namespaces (NumPy, JAX, PyTorch, CuPy) and the operations that differ between them."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from importlib import import_module
from typing import Any, NamedTuple, Protocol, TypeAlias, TypeVar, cast

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Values
from lommel.base.optional import library

_EXTRAS = ("jax", "torch", "cupy")
_REQUIRED = ("matmul", "take", "where", "isfinite", "concat", "flip")  # functions that identify an array API
_Result = TypeVar("_Result")
# An array of one namespace, or a number; a Protocol cannot describe the overloaded operators of NumPy.
Operand: TypeAlias = Any


class Tensor(Protocol):
    """An array of any namespace of the array API standard."""

    @property
    def shape(self) -> tuple[int, ...]:
        """Length of each axis."""

    @property
    def dtype(self) -> object:
        """Type of the elements."""

    def __add__(self, other: Operand, /) -> Tensor: ...
    def __radd__(self, other: Operand, /) -> Tensor: ...
    def __sub__(self, other: Operand, /) -> Tensor: ...
    def __rsub__(self, other: Operand, /) -> Tensor: ...
    def __mul__(self, other: Operand, /) -> Tensor: ...
    def __rmul__(self, other: Operand, /) -> Tensor: ...
    def __truediv__(self, other: Operand, /) -> Tensor: ...
    def __rtruediv__(self, other: Operand, /) -> Tensor: ...
    def __lt__(self, other: Operand, /) -> Tensor: ...
    def __le__(self, other: Operand, /) -> Tensor: ...
    def __gt__(self, other: Operand, /) -> Tensor: ...
    def __ge__(self, other: Operand, /) -> Tensor: ...
    def __neg__(self) -> Tensor: ...
    def __getitem__(self, index: Operand, /) -> Tensor: ...


Tables = dict[str, Tensor]  # name -> array: precomputed arrays of a plan, for one wavelength


class ArrayFunctions(Protocol):
    """Functions of a namespace of the array API standard."""

    @property
    def fft(self) -> ArrayFunctions:
        """Functions for Fourier transforms."""

    def __getattr__(self, name: str, /) -> Callable[..., Tensor]: ...


@dataclass(frozen=True)
class Namespace:
    """A namespace `xp` of the array API standard; `name` is "numpy", "jax", "torch", "cupy" or another module."""

    name: str
    xp: ArrayFunctions = field(compare=False, repr=False)

    @classmethod
    def of(cls, value: object) -> Namespace:
        """Return the namespace of a module or module name, NumPy for None; TypeError if functions are missing."""
        module = "numpy" if value is None else value
        name = module if isinstance(module, str) else str(getattr(module, "__name__", ""))
        name = name.removeprefix("array_api_compat.")
        top = name.partition(".")[0]
        if top in _EXTRAS:
            library(top, f"arrays of {top} need", top)
            home = "jax.numpy" if top == "jax" else f"array_api_compat.{top}"
            return cls(top, library(home, f"arrays of {top} need", top))
        try:
            namespace = import_module(name) if isinstance(module, str) else module
        except (ImportError, ValueError):
            namespace = None
        if namespace is None or not all(hasattr(namespace, function) for function in _REQUIRED):
            raise TypeError(
                "xp must be a module of the array API such as numpy, jax.numpy, torch or cupy, or its name, got "
                f"{validation.shown(value)}"
            )
        return cls(name, cast("ArrayFunctions", namespace))

    def __reduce__(self) -> tuple[Callable[[str], Namespace], tuple[str]]:
        return Namespace.of, (self.name,)

    def put(self, values: Values, device: object, dtype: object = None) -> Tensor:
        """Return a NumPy array as an array of the namespace on a device; in a JAX trace it is a constant."""
        if self.name == "torch":
            values = np.array(values)  # a copy: PyTorch warns about read-only arrays
        if self.name != "jax":
            return self.xp.asarray(values, dtype=dtype, device=device)
        import jax

        # Tables that are created while JAX traces a function become constants, not operations of the program.
        with jax.ensure_compile_time_eval():
            return self.xp.asarray(values, dtype=dtype, device=device)

    def beside(self, x: Operand) -> dict[str, object]:
        """Return the options that place a new array on the device of `x`; JAX and NumPy need none."""
        return {} if self.name in ("jax", "numpy") else {"device": x.device}

    def has_double(self, device: object) -> bool:
        """Return whether float64 is available on a device; in JAX, float64 must be enabled by an option."""
        try:
            return bool(self.put(np.zeros(1), device).dtype == self.xp.float64)
        except (TypeError, ValueError, RuntimeError):  # raised by PyTorch on a device without float64
            return False

    def matmul(self, a: Tensor, b: Tensor) -> Tensor:
        """Return a matrix product in the full precision of the data type."""
        if self.name == "jax":
            # By default JAX multiplies matrices in bfloat16 or TF32 on accelerators.
            return self.xp.matmul(a, b, precision="highest")
        return self.xp.matmul(a, b)

    def coarseness(self, unit: float) -> float:
        """Return the roundoff of operands in matrix products; 0 if it is `unit`, the roundoff of the data type."""
        if unit < 1e-10:
            return 0.0
        if self.name == "torch":
            import torch

            # TF32 has 11 significant bits, bfloat16 has 8.
            return {"highest": 0.0, "high": 2.0**-11}.get(torch.get_float32_matmul_precision(), 2.0**-8)
        if self.name == "cupy":
            return 2.0**-11 if os.environ.get("CUPY_TF32", "0") != "0" else 0.0
        return 0.0

    def call_unfused(self, function: Callable[..., _Result], *arrays: Tensor) -> _Result:
        """Call a function; in JAX on CPUs, its operations are not fused with operations outside the function."""
        # Fusion by XLA on CPUs would compute a value again for each use, and permute axes element by element.
        if self.name != "jax":
            return function(*arrays)
        import jax
        from jax.experimental.xla_metadata import set_xla_metadata

        def call_separately(*arrays: Tensor) -> _Result:
            with set_xla_metadata(inlineable="false"):  # type: ignore[no-untyped-call]
                return jax.jit(function)(*arrays)  # type: ignore[no-any-return]

        return jax.lax.platform_dependent(  # type: ignore[no-any-return]
            *arrays, cpu=call_separately, default=function
        )

    def flip(self, x: Operand, axis: int) -> Tensor:
        """Return an array with one axis reversed, in JAX by an operation that can be fused in `call_unfused`."""
        if self.name == "jax":
            import jax

            return jax.lax.rev(x, (axis,))
        return self.xp.flip(x, axis=axis)

    def transposed(self, x: Tensor) -> Tensor:
        """Return an array of three axes with the order of the axes reversed."""
        return self.call_unfused(partial(self.xp.permute_dims, axes=(2, 1, 0)), x)

    def stop(self, x: Operand) -> Tensor:
        """Return `x` as a constant, whose gradient is zero."""
        if self.name == "jax":
            import jax

            return jax.lax.stop_gradient(x)  # type: ignore[no-any-return]
        return x.detach() if self.name == "torch" else x  # type: ignore[no-any-return]

    def concrete(self, x: Tensor) -> bool:
        """Return whether `x` has concrete values; False for an array in a traced program."""
        if self.name == "jax":
            import jax

            return not isinstance(x, jax.core.Tracer)
        if self.name == "torch":
            import torch

            if torch.compiler.is_compiling():
                return False
            try:
                self.to_numpy(x)
            except RuntimeError:  # inside a torch.func transform
                return False
        return True

    def values_now(self, x: Operand) -> Values | None:
        """Return the values of `x` as a NumPy array if it is on a CPU; None under transforms and tracing."""
        if self.name == "numpy":
            return np.asarray(x)
        if self.name != "torch" or x.device.type != "cpu":
            return None
        import torch
        from torch.utils._python_dispatch import _get_current_dispatch_mode

        if torch.compiler.is_compiling() or torch.jit.is_tracing() or _get_current_dispatch_mode() is not None:
            return None
        if torch.autograd.forward_ad.unpack_dual(x).tangent is not None:
            return None
        try:
            return np.asarray(x.detach().numpy())
        except (RuntimeError, TypeError):  # inside a torch.func transform; or a data type that NumPy lacks
            return None

    def in_place(self, x: Operand) -> bool:
        """Return whether a temporary array `x` may be overwritten in place, which saves time in PyTorch."""
        return self.name == "torch" and not x.requires_grad and self.values_now(x) is not None

    def to_numpy(self, x: Operand) -> Values:
        """Return an array as a NumPy array."""
        if self.name == "cupy":
            x = x.get()
        if self.name == "torch":
            x = x.detach().cpu().numpy()
        if hasattr(x, "to_device") and self.name == "array_api_strict":
            x = x.to_device(self.xp.Device("CPU_DEVICE"))
        return np.asarray(x)


class Placement(NamedTuple):
    """A namespace and a device on which arrays lie."""

    namespace: Namespace
    device: Any

    @classmethod
    def of(cls, array: Any) -> Placement | None:
        """Return where an array of CuPy, PyTorch or array_api_strict lies; None for arrays of other packages."""
        top = type(array).__module__.partition(".")[0]
        return cls(Namespace.of(top), array.device) if top in ("cupy", "torch", "array_api_strict") else None

    def put(self, values: Values) -> Operand:
        """Return a NumPy array there, floats in single precision."""
        xp: Any = self.namespace.xp
        kinds = {"f": xp.float32, "c": xp.complex64, "i": xp.int64}
        return self.namespace.put(values, self.device, kinds[np.asarray(values).dtype.kind])

    def to_numpy(self, array: Operand) -> Values:
        """Return an array there as an array of NumPy."""
        return self.namespace.to_numpy(array)
