"""What a method computed for a pupil, and how: all that measures, files and pictures take."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.methods.method import Method, RadialMethod
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid

if TYPE_CHECKING:
    from lommel.blur.blurs import Blur


class Measurable:
    """A PSF, or several: what functions of a PSF can be asked of."""

    def measured(self, measure: Callable[[Any], Any]) -> Any:
        """Return what a function `measure` of a PSF is here."""
        raise NotImplementedError


@dataclass(frozen=True, eq=False)
class Answer:
    """The data of a :class:`lommel.PSF`, whose attributes these are."""

    values: NDArray[Any]
    grid: Grid
    pupil: BasePupil
    method: Method
    normalize: str
    error_bound: float | None
    scale: Array = field(repr=False)
    derivatives: dict[str | tuple[int, int], NDArray[Any]] = field(default_factory=dict, repr=False)
    derivative_bounds: dict[str | tuple[int, int], float] = field(default_factory=dict, repr=False)
    blur: tuple[Blur, ...] = ()

    def __post_init__(self) -> None:
        for name, kind in (("grid", Grid), ("pupil", BasePupil), ("method", Method)):
            validation.instance(name, getattr(self, name), kind)
        if self.grid.stack not in ((), self.pupil.shape):
            raise ValueError(
                f"grid must have one center, or one for each pupil of a stack of shape {self.pupil.shape}, "
                f"got {self.grid.stack}"
            )
        wanted = self.pupil.shape + self.grid.shape
        if not isinstance(self.values, np.ndarray) or self.values.dtype not in (np.float32, np.float64):
            raise TypeError(f"values must be an array of float32 or float64, got {validation.shown(self.values)}")
        if self.values.shape != wanted:
            raise ValueError(f"values must have the shape {wanted}, got {self.values.shape}")

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the values."""
        return self.values.shape

    @property
    def pixel(self) -> float | tuple[float, float]:
        """Pixel pitch, in :attr:`unit`; height and width where these differ."""
        return self.grid.pixel

    @property
    def sampling(self) -> str:
        """``"center"`` where values sample the pixel centres, ``"pixel"`` where they average over pixels."""
        return "pixel" if self.grid.integrate else "center"

    @property
    def undersampled(self) -> bool:
        """Whether values sample pixels wider than lambda*N/2, so that they do not sum to the light of the window."""
        return not self.grid.integrate and max(self.grid.pitch) > 0.5 * (1.0 + 1e-9) * self.pupil.scale

    @property
    def unit(self) -> str:
        """Unit of `pixel` and of every radius: ``"m"`` or ``"lambda*N"``."""
        return self.pupil.unit

    def positions(self) -> tuple[Array, Array]:
        """Return where columns and rows are, x and y from the axis, of each of the flattened stack."""
        return self.grid.positions(self.pupil.shape)

    @property
    def radial_method(self) -> RadialMethod | None:
        """The method where a profile describes the whole PSF (pupil and method are radial, no blur), else None."""
        return None if self.blur else self.method.along_radius(self.pupil)

    def profile(self, radius: ArrayLike | None = None) -> tuple[Array, Array]:
        """Return radii (in :attr:`unit`) and the values there, normalised like `values`.

        Parameters
        ----------
        radius : array_like, optional
            Any radii, evaluated anew by the method as point samples; by default the pixels from the middle one,
            ``(height // 2, width // 2)``, to the right; then radii are of the shape of the values where each pupil
            has its own axis.

        Raises
        ------
        ValueError
            If radii are asked of a method that knows its values on the grid only.
        """
        if radius is None:
            middle = (self.shape[-2] // 2, self.shape[-1] // 2)
            radii = np.hypot(self.grid.y[..., middle[0], None], self.grid.x[..., middle[1] :])
            return radii, self.values[..., middle[0], middle[1] :].astype(np.float64)
        method = self.radial_method
        if method is None:
            what = "a pupil that is not radial" if not self.pupil.radial else type(self.method).__name__
            what = "light that is spread by blur" if self.blur else what
            raise ValueError(f"radius must be None for {what}, whose values are on the grid only")
        at = validation.real_array("radius", radius, least=0.0)
        far = float(at.max(initial=0.0))
        validation.reach(f"radius={far:g}", float(self.pupil.v(far)), self.pupil.scale, self.unit)
        v, where = np.unique(self.pupil.v(at).ravel(), return_inverse=True)
        intensity = method.profile(self.pupil, v).values[:, where].reshape(self.pupil.shape + at.shape)
        return np.array(at), self.scale.reshape(self.scale.shape + (1,) * at.ndim) * intensity

    def __len__(self) -> int:
        """Return how many PSFs, or stacks of them, the first axis of a stack holds."""
        if self.pupil.shape == ():
            raise TypeError("a single PSF has no length; its pixels are in `values`")
        return self.pupil.shape[0]

    def __bool__(self) -> bool:
        """Return True, whether it has a length or not."""
        return True

    def __getitem__(self, index: Any) -> Self:
        """Return part of a stack, as NumPy indexes arrays of the shape of its pupils."""
        if self.pupil.shape == ():
            raise TypeError("a single PSF cannot be indexed; its pixels are in `values`")
        pupil = self.pupil[index]
        which = np.arange(self.scale.size).reshape(self.scale.shape)[index]
        return replace(
            self,
            values=self.values.reshape(-1, *self.shape[-2:])[which],
            grid=self.grid[index] if self.grid.stack else self.grid,
            pupil=pupil,
            scale=np.asarray(self.scale.reshape(-1)[which]),
            derivatives={k: d.reshape(-1, *self.shape[-2:])[which] for k, d in self.derivatives.items()},
        )

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return `values`."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        bound = "none" if self.error_bound is None else f"{self.error_bound:.2g}"
        how = "averaged over pixels" if self.grid.integrate else "sampled at pixel centres"
        how += "".join(f", {type(blur).__name__}" for blur in self.blur)
        if self.undersampled:
            sums = self.values.sum(axis=(-2, -1), dtype=np.float64)
            how += f", which sum to {' to '.join(f'{s:.3g}' for s in sorted({float(sums.min()), float(sums.max())}))}"
        return (
            f"<{type(self).__name__} {'x'.join(map(str, self.shape))} {self.values.dtype}, "
            f"pixel {self.grid.named} {self.unit}, {how}, {type(self.method).__name__}, "
            f"normalize {self.normalize!r}, error bound {bound}>"
        )


def checked(answer: Any, name: str = "answer") -> Answer:
    """Return `answer` if it is one; TypeError otherwise, with the name that it has outside."""
    if not isinstance(answer, Answer):
        raise TypeError(f"{name} must be a PSF, got {validation.shown(answer)}")
    return answer
