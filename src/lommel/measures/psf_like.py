"""Protocols of a PSF, of PSFs in colour channels and of a PSF grid, for measures, files and plots."""

# ruff: noqa: D102 (the classes that have these attributes say what they are)
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Self, TypeGuard, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Index, Values
from lommel.methods.method import Method, RadialMethod
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.blur.blurs import Blur
    from lommel.methods.derivative_names import Name
    from lommel.optics.colour.spectrum import Channels


class _Common(Protocol):
    # Properties rather than variables: the attributes of a PSF cannot be set.
    @property
    def values(self) -> Values: ...
    @property
    def grid(self) -> Grid: ...
    @property
    def pupil(self) -> BasePupil: ...
    @property
    def normalize(self) -> str: ...
    @property
    def error_bound(self) -> float | None: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def pixel(self) -> float | tuple[float, float]: ...
    @property
    def unit(self) -> str: ...


class PSFLike(_Common, Protocol):
    """A point spread function, or a stack of them, and how it was computed."""

    __dataclass_fields__: ClassVar[dict[str, Any]]

    @property
    def method(self) -> Method: ...
    @property
    def scale(self) -> Array: ...
    @property
    def derivatives(self) -> dict[Name, Values]: ...
    @property
    def derivative_bounds(self) -> dict[Name, float]: ...
    @property
    def blur(self) -> tuple[Blur, ...]: ...
    @property
    def sampling(self) -> str: ...
    @property
    def undersampled(self) -> bool: ...
    @property
    def radial_method(self) -> RadialMethod | None: ...
    def positions(self) -> tuple[Array, Array]: ...
    def profile(self, radius: ArrayLike | None = None) -> tuple[Array, Array]: ...
    def __getitem__(self, index: Index) -> Self: ...


@runtime_checkable
class ColourPSFLike(_Common, Protocol):
    """A PSF for each channel of a sensor, and their values in one array, channels before rows."""

    @property
    def channels(self) -> Channels: ...
    @property
    def psfs(self) -> tuple[PSFLike, ...]: ...


class PSFGridLike(Protocol):
    """PSFs over a sensor, each with its place."""

    @property
    def psf(self) -> PSFLike | ColourPSFLike: ...
    @property
    def x(self) -> Array: ...
    @property
    def y(self) -> Array: ...
    @property
    def sensor(self) -> tuple[float, float]: ...
    @property
    def depths(self) -> Array | None: ...
    @property
    def values(self) -> Values: ...
    @property
    def dims(self) -> tuple[str, ...]: ...
    @property
    def unit(self) -> str: ...


@runtime_checkable
class Measurable(Protocol):
    """A PSF, or several, whose every PSF a function measures."""

    def measured(self, measure: Callable[[Any], Any]) -> Any:
        """Return the `measure` of each PSF."""


def is_psf(thing: object) -> TypeGuard[PSFLike]:
    """Return whether a thing is a PSF, or a stack of them, with its pixels and its method."""
    return isinstance(getattr(thing, "grid", None), Grid) and isinstance(getattr(thing, "method", None), Method)


def checked(psf: object, name: str = "psf") -> PSFLike:
    """Return `psf` if it is one; TypeError otherwise."""
    if not is_psf(psf):
        raise TypeError(f"{name} must be a PSF, got {validation.shown(psf)}")
    return psf


def colours(psf: ColourPSFLike) -> Array:
    """Return red, green and blue over their largest value in each image, shape ``(..., height, width, 3)``."""
    names = psf.channels.names
    if len(names) not in (1, 3):
        raise ValueError(f"a picture takes three channels, or one, got {len(names)}: {', '.join(names)}")
    light = np.maximum(np.moveaxis(psf.values, -3, -1).astype(np.float64), 0.0)
    top = light.max(axis=(-3, -2, -1), keepdims=True)
    if not top.min() > 0.0:
        raise ValueError("a picture needs a positive value; every value of this PSF is 0")
    return np.asarray(np.broadcast_to(light / top, (*light.shape[:-1], 3)))
