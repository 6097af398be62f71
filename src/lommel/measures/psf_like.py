"""Base classes of a PSF, a colour PSF and a PSF grid, for modules that do not compute PSFs (measures, files)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, Self, TypeGuard, TypeVar, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from lommel.base import validation
from lommel.base.arrays import Array, Index, Values
from lommel.methods.method import Method, RadialMethod
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.blur.blurs import Blur
    from lommel.methods.derivative_names import Name
    from lommel.optics.colour.spectrum import Channels


class Recorded:
    """Base class of PSFs with values on pixels in one array."""

    values: Values
    grid: Grid
    pupil: BasePupil
    normalize: str

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the values."""
        return self.values.shape

    @property
    def pixel(self) -> float | tuple[float, float]:
        """Pixel pitch, in :attr:`unit`: one number for square pixels, else (height, width)."""
        return self.grid.pixel

    @property
    def unit(self) -> str:
        """Unit of all lengths in the image: ``"m"`` or ``"lambda*N"``."""
        return self.pupil.unit

    @property
    def sampling(self) -> str:
        """``"center"`` for point samples at the pixel centres, ``"pixel"`` for averages over pixels."""
        return "pixel" if self.grid.integrate else "center"

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Values:
        """Return `values`."""
        return np.array(self.values, dtype=dtype, copy=copy)


class PSFLike(Recorded):
    """A point spread function, or a stack of point spread functions, and the method that computed it."""

    __dataclass_fields__: ClassVar[dict[str, Any]]
    method: Method
    error_bound: float | None
    scale: Array
    derivatives: dict[Name, Values]
    derivative_bounds: dict[Name, float]
    blur: tuple[Blur, ...]

    @property
    def sum_is_light(self) -> bool:
        """True if values over the whole plane sum to all light: pixel averages, or samples at most lambda*N apart."""
        # By Poisson's formula the sum of samples equals the sum of the Fourier transform at multiples of 1 / pixel.
        # The transform of an intensity is 0 from the frequency 1 / (lambda*N) on, so that only its value at frequency
        # 0, the light, contributes.
        return self.grid.integrate or max(self.grid.pitch) <= (1.0 + 1e-9) * self.pupil.scale

    def positions(self) -> tuple[Array, Array]:
        """Return x of the columns and y of the rows, relative to the axis, for each PSF of the flattened stack."""
        return self.grid.positions(self.pupil.shape)

    @property
    def radial_method(self) -> RadialMethod | None:
        """The method if its radial profile is the whole PSF (radial pupil and method, no blur), else None."""
        return None if self.blur else self.method.along_radius(self.pupil)

    def profile(self, radius: ArrayLike | None = None) -> tuple[Array, Array]:
        """Return radii (in :attr:`unit`) and the values at these radii, normalised like `values`.

        Parameters
        ----------
        radius : array_like, optional
            Radii at which the method computes point samples. By default the values are those of the pixels from the
            central one, ``(height // 2, width // 2)``, to the right edge of its row, and the radii are the distances
            of these pixels from the axis. If the axis differs within a stack, the radii have the shape of the values.

        Raises
        ------
        ValueError
            If radii are given for a PSF that is not radially symmetric or whose method computes values on a grid
            only.
        """
        if radius is None:
            middle = (self.shape[-2] // 2, self.shape[-1] // 2)
            radii = np.hypot(self.grid.y[..., middle[0], None], self.grid.x[..., middle[1] :])
            return radii, self.values[..., middle[0], middle[1] :].astype(np.float64)
        method = self.radial_method
        if method is None:
            reason = "a pupil that is not radial" if not self.pupil.radial else type(self.method).__name__
            reason = "a PSF with blur" if self.blur else reason
            raise ValueError(f"radius must be None for {reason}, whose values are on the grid only")
        radii = validation.real_array("radius", radius, least=0.0, unit=self.unit)
        largest = float(radii.max(initial=0.0))
        validation.reach(f"radius={largest:g}", float(self.pupil.v(largest)), self.pupil.scale, self.unit)
        # Methods expect distinct radii in ascending order.
        v, index = np.unique(self.pupil.v(radii).ravel(), return_inverse=True)
        intensity = method.profile(self.pupil, v).values[:, index].reshape(self.pupil.shape + radii.shape)
        return np.array(radii), self.scale.reshape(self.scale.shape + (1,) * radii.ndim) * intensity

    def __getitem__(self, index: Index) -> Self:
        """Return part of a stack, indexed like a NumPy array of shape ``pupil.shape``."""
        if self.pupil.shape == ():
            raise TypeError("a single PSF cannot be indexed; its pixels are in `values`")
        pupil = self.pupil[index]
        # Convert to indices into the flattened stack, which apply to all arrays.
        indices = np.arange(self.scale.size).reshape(self.scale.shape)[index]
        return replace(
            self,
            values=self.values.reshape(-1, *self.shape[-2:])[indices],
            grid=self.grid[index] if self.grid.stack else self.grid,
            pupil=pupil,
            scale=np.asarray(self.scale.reshape(-1)[indices]),
            derivatives={k: d.reshape(-1, *self.shape[-2:])[indices] for k, d in self.derivatives.items()},
        )


class ColourPSFLike(Recorded):
    """PSFs for the channels of a sensor, with values in one array, whose channel axis precedes rows and columns."""

    channels: Channels
    psfs: tuple[PSFLike, ...]

    @property
    def error_bound(self) -> float | None:
        """Largest error bound of the channels, each relative to the channel's peak; None if a channel has none."""
        bounds = [psf.error_bound for psf in self.psfs if psf.error_bound is not None]
        return max(bounds) if len(bounds) == len(self.psfs) else None


class PSFGridLike:
    """PSFs at a grid of positions on a sensor."""

    psf: PSFLike | ColourPSFLike
    x: Array
    y: Array
    sensor: tuple[float, float]
    depths: Array | None

    @property
    def values(self) -> Values:
        """Values, shape (rows, columns, height, width); axes of depths and channels, if any, precede the last two."""
        return self.psf.values

    @property
    def dims(self) -> tuple[str, ...]:
        """Names of the axes of the values."""
        depth = () if self.depths is None else ("depth",)
        channel = ("channel",) if isinstance(self.psf, ColourPSFLike) else ()
        return ("field_y", "field_x", *depth, *channel, "y", "x")

    @property
    def unit(self) -> str:
        """Unit of positions: ``"m"`` or ``"lambda*N"``."""
        return self.psf.unit


Measured = TypeVar("Measured")


@runtime_checkable
class Measurable(Protocol):
    """A PSF or several PSFs to which a measure can be applied."""

    def apply(self, measure: Callable[[PSFLike], Measured]) -> Measured:
        """Return the result of `measure` for each PSF."""


def is_psf(value: object) -> TypeGuard[PSFLike]:
    """Return True if an object is a PSF or a stack of PSFs, with pixels and a method."""
    return isinstance(getattr(value, "grid", None), Grid) and isinstance(getattr(value, "method", None), Method)


def checked(psf: object, name: str = "psf") -> PSFLike:
    """Return `psf` if it is a PSF or a stack of PSFs; TypeError otherwise."""
    if not is_psf(psf):
        raise TypeError(f"{name} must be a PSF, got {validation.shown(psf)}")
    return psf


def colours(psf: ColourPSFLike) -> Array:
    """Return red, green and blue divided by the largest value of each image, shape ``(..., height, width, 3)``."""
    names = psf.channels.names
    if len(names) not in (1, 3):
        raise ValueError(f"a picture needs one or three channels, got {len(names)}: {', '.join(names)}")
    # Colours must not be negative; values may be, within the error bound.
    rgb = np.maximum(np.moveaxis(psf.values, -3, -1).astype(np.float64), 0.0)
    peak = rgb.max(axis=(-3, -2, -1), keepdims=True)
    if not peak.min() > 0.0:
        raise ValueError("a picture needs a positive value; every value of this PSF is 0")
    return np.asarray(np.broadcast_to(rgb / peak, (*rgb.shape[:-1], 3)))
