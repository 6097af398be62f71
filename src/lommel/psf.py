"""The one front door, :func:`psf`, and its answer, :class:`PSF`."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel import validation
from lommel.grid import Grid
from lommel.methods.method import Method, RadialMethod
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.pupil import Pupil

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Numbers = np.float64 | NDArray[np.float64]

_DEFAULT = NijboerZernike()


def psf(
    pupil: Pupil,
    shape: int | tuple[int, int],
    pixel: float,
    *,
    method: Method = _DEFAULT,
    normalize: str = "energy",
    dtype: DTypeLike | None = None,
) -> PSF:
    """Compute the point spread function of a pupil.

    Parameters
    ----------
    pupil : Pupil
        A stack of pupils gives a stack of images.
    shape : int or (int, int)
        Side of a square, or height and width, in pixels. The centre is the middle of pixel
        ``(height // 2, width // 2)``.
    pixel : float
        Pixel pitch, in metres if the pupil has a wavelength, else in units of lambda*N.
    method : Method, default NijboerZernike(tol=1e-6)
        How to evaluate the diffraction integral. Values sample the pixel centres
        (`Geometric`, which has no point values, averages over pixels).
    normalize : {"energy", "strehl", "peak"}, default "energy"
        "energy": a value is the fraction of all light per pixel, so an infinite window of pixels no larger than
        lambda*N sums to 1. "strehl": 1 is the peak of the same aperture without aberration. "peak": the largest
        value in the window is 1.
    dtype : float32 or float64, optional
        Of the values. By default float32 where the tolerance of the method is 1e-6 or more, else float64.

    Returns
    -------
    PSF
        With ``values`` of shape ``pupil.shape + (height, width)``.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, if the method does not support the pupil, if the answer would exceed
        2^31 values, or if float32 is asked for with a tolerance that it cannot hold (below 2.4e-7).
    ToleranceError
        If the method cannot meet its tolerance.

    Examples
    --------
    >>> import lommel as lm
    >>> answer = lm.psf(lm.Pupil(lm.Wavefront(defocus=10.0, spherical=3.0)), shape=512, pixel=0.25)
    >>> answer.values.shape
    (512, 512)
    """
    if not isinstance(method, Method):
        raise TypeError(f"method must be a Method such as NijboerZernike(tol=1e-6), got {method!r}")
    method.require(pupil)
    grid = Grid(shape, validation.pixel(pixel, metric=pupil.wavelength is not None))
    validation.choice("normalize", normalize, ("energy", "strehl", "peak"))
    kind = _output_type(dtype, method.tol)
    count = math.prod(pupil.shape) * grid.height * grid.width
    if count > validation.MAX_VALUES:
        raise ValueError(
            f"shape {grid.shape} for {math.prod(pupil.shape)} pupils makes {count} values, "
            f"more than the limit of {validation.MAX_VALUES}"
        )
    intensity, error = method.intensity(pupil, grid)
    if normalize == "peak":
        peak = intensity.reshape(intensity.shape[0], -1).max(axis=1)
        if not np.all(peak > 0):
            raise ValueError('normalize="peak" is impossible: no light falls into the window')
        scale = 1.0 / peak
    else:
        factor = grid.step(pupil) ** 2 / (4.0 * math.pi * pupil.area) if normalize == "energy" else pupil.area**-2
        scale = np.full(intensity.shape[0], factor)
    values = grid.paint(intensity, scale, kind).reshape(pupil.shape + grid.shape)
    bound = None if error is None else float(error.max()) + (2.0**-24 if kind == np.float32 else 2.0**-53)
    return PSF(
        values=values,
        pixel=grid.pixel,
        pupil=pupil,
        method=method,
        normalize=normalize,
        error_bound=bound,
        scale=scale.reshape(pupil.shape),
    )


def _output_type(dtype: DTypeLike | None, tol: float) -> np.dtype[Any]:
    if dtype is None:
        return np.dtype(np.float32 if tol >= 1e-6 else np.float64)
    try:
        kind = np.dtype(dtype)
    except TypeError:
        raise TypeError(f"dtype must be float32 or float64, got {dtype!r}") from None
    if kind not in (np.dtype(np.float32), np.dtype(np.float64)):
        raise TypeError(f"dtype must be float32 or float64, got {dtype!r}")
    if kind == np.float32 and tol < 2.0**-22:
        raise ValueError(f"dtype float32 cannot hold tol={tol:g}; use float64, or a tolerance of at least 2.4e-7")
    return kind


@dataclass(frozen=True, eq=False)
class PSF:
    """A computed point spread function, or a stack of them, and how it was made.

    Attributes
    ----------
    values : ndarray, shape ``pupil.shape + (height, width)``
        float32 or float64; at pixel centres, or pixel averages where ``method.sampling`` is ``"pixel"``.
    pixel : float
        Pixel pitch, in :attr:`unit`.
    pupil : Pupil
    method : Method
    normalize : str
        "energy", "strehl" or "peak".
    error_bound : float or None
        Bound on the largest error over the peak, the largest of the stack; None where the method has none. The
        truncation, quadrature and interpolation in it are proven, the rounding is estimated.
    scale : ndarray, shape ``pupil.shape``
        What the intensity (1 for the unobscured, unaberrated peak) was multiplied by.
    """

    values: NDArray[Any]
    pixel: float
    pupil: Pupil
    method: Method
    normalize: str
    error_bound: float | None
    scale: NDArray[np.float64] = field(repr=False)

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the values."""
        return self.values.shape

    @property
    def grid(self) -> Grid:
        """The pixels."""
        return Grid(self.values.shape[-2:], self.pixel)

    @property
    def unit(self) -> str:
        """Unit of `pixel` and of every radius: ``"m"`` or ``"lambda*N"``."""
        return self.pupil.unit

    @property
    def energy(self) -> Numbers:
        """Fraction of all light that falls inside the window, to the edges of its outer pixels."""
        from lommel import metrics

        return metrics.window_energy(self)

    @property
    def strehl(self) -> Numbers:
        """Intensity on the axis over that of the same aperture without aberration."""
        from lommel import metrics

        return metrics.strehl(self)

    def encircled_energy(self, radius: ArrayLike) -> Numbers:
        """Return the fraction of all light within `radius` (in :attr:`unit`) of the centre.

        Exact to the tolerance of the method where it is radial, whatever the pixels; summed over the pixels, and
        limited to the window, for `Fraunhofer` and `Geometric`. Shape ``pupil.shape + radius.shape``.
        """
        from lommel import metrics

        return metrics.encircled_energy(self, radius)

    def profile(self, radius: ArrayLike | None = None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return radii (in :attr:`unit`) and the values there, normalised like `values`.

        Parameters
        ----------
        radius : array_like, optional
            Any radii, evaluated anew by the method; by default the pixel centres to the right of the centre.

        Raises
        ------
        ValueError
            If radii are asked of a method that knows its values on the grid only.
        """
        if radius is None:
            columns = np.arange(self.shape[-1] - self.shape[-1] // 2, dtype=np.float64)
            row = self.values[..., self.shape[-2] // 2, self.shape[-1] // 2 :]
            return columns * self.pixel, row.astype(np.float64)
        if not isinstance(self.method, RadialMethod):
            raise ValueError(
                f"radius must be None for {type(self.method).__name__}, whose values are on the grid only"
            )
        at = validation.real_array("radius", radius, least=0.0)
        field = self.method.field(self.pupil, self.pupil.v(at))
        scale = self.scale.reshape(self.scale.shape + (1,) * at.ndim)
        return np.array(at), scale * (field.real**2 + field.imag**2)

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes:
        """Draw the values on matplotlib axes and return these; see :func:`lommel.plot.plot`."""
        from lommel import plot

        return plot.plot(self, ax, stretch=stretch)

    def save(self, path: str | PathLike[str]) -> None:
        """Write ``.tif`` (OME), ``.npy``, ``.npz`` or ``.png``; see :func:`lommel.files.save`."""
        from lommel import files

        files.save(self, path)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> PSF:
        """Read a file that :meth:`save` wrote."""
        from lommel import files

        return files.load(path)

    def __getitem__(self, index: Any) -> PSF:
        """Return part of a stack, as NumPy indexes arrays of the shape of its pupils."""
        pupil = self.pupil[index]
        which = np.arange(self.scale.size).reshape(self.scale.shape)[index]
        return replace(
            self,
            values=self.values.reshape(-1, *self.shape[-2:])[which],
            pupil=pupil,
            scale=np.asarray(self.scale.reshape(-1)[which]),
        )

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Return `values`."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        bound = "none" if self.error_bound is None else f"{self.error_bound:.2g}"
        return (
            f"<PSF {'x'.join(map(str, self.shape))} {self.values.dtype}, pixel {self.pixel:g} {self.unit}, "
            f"{type(self.method).__name__}, normalize {self.normalize!r}, error bound {bound}>"
        )
