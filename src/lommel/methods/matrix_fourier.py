"""Matrix (semi-analytical) Fourier transform of any pupil onto any pixels, by two matrix products."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.core.answers import Declined, Intensities
from lommel.core.engine import gauss_error
from lommel.methods.method import Method
from lommel.optics.aperture.mask import cell_centers
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special.legendre import gauss_legendre

MAX_SAMPLES = 8192  # largest number of samples across the aperture
_MAX_FIELD = 2**27  # largest number of complex values of a field (2 GiB)


@dataclass(frozen=True)
class MatrixFourier(Method[Pupil]):
    r"""Discrete Fourier transform of the sampled pupil onto the pixels, by two matrix products.

    Supports every pupil, if no light is aliased into the window. The transform is exact; the error comes from
    sampling the edge of the aperture (first order in the spacing if binary, second if grey), and grows with the
    aberration. There is no error bound. With 256 samples and aberrations of a few radians the error is typically 1e-3
    of the peak with a binary edge, 2e-4 with a grey edge.

    Parameters
    ----------
    samples : int, default 256
        Number of samples across the diameter of the aperture, 8 to 8192; their square cells span the diameter
        exactly. If `samples` equals the side of the mask of a pupil, the samples of the mask are used unchanged.
    edge : {"grey", "binary"}, default "grey"
        "grey": a sample is weighted by the clear fraction of its cell. "binary": it is 1 if its centre is clear, else
        0.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    Notes
    -----
    ``U = (4 / (pi n^2)) E_y P E_x`` with ``E = exp(-i v x)`` and n samples across. With `integrate`, I is averaged
    over Gauss-Legendre points within each pixel, with an error of 1e-8 of the peak of the unaberrated aperture.

    References
    ----------
    R. Soummer, L. Pueyo, A. Sivaramakrishnan and R. J. Vanderbei, "Fast computation of Lyot-style coronagraph
    propagation", Opt. Express 15, 15935 (2007), doi:10.1364/OE.15.015935.
    """

    apodized = nonradial = any_aperture = True
    samples: int = 256
    edge: str = "grey"

    def __post_init__(self) -> None:
        object.__setattr__(self, "samples", validation.integer("samples", self.samples, least=8, most=MAX_SAMPLES))
        validation.choice("edge", self.edge, ("grey", "binary"))

    def period(self, pupil: Pupil) -> float:
        """Return the period of the image in units of lambda*N, which is `samples` for any `pupil`."""
        return float(self.samples)

    def intensity(self, pupil: Pupil, grid: Grid, threads: int) -> Intensities:
        """Return I at pixel centres, or averaged over pixels, shape ``(n, height, width)``.

        Raises
        ------
        ValueError
            If light would be aliased into the window, or if the field needs more than 2^27 values.
        """
        require_samples(self, self.samples, pupil, grid)
        step = grid.step(pupil)
        offset, weight = gauss_pixel(step, 1e-8) if grid.integrate else (np.zeros(1), np.ones(1))
        if grid.height * grid.width * offset.size**2 > _MAX_FIELD:
            raise Declined(
                f"averages over pixels of v = {step:.3g} need {offset.size} x {offset.size} points per pixel; for "
                f"{grid.height} x {grid.width} pixels this exceeds the limit of {_MAX_FIELD}; use a smaller window"
            )
        x = cell_centers(self.samples)
        # Two matrices (Soummer et al.): exp(-i v y) for rows of pixels (and their nodes), exp(-i v x) for columns.
        to_rows, to_columns = (
            np.exp(-1j * np.multiply.outer((step / grid.side * part[:, None] + offset).ravel(), x))
            for part in (grid.y, grid.x)
        )
        stack = np.empty((math.prod(pupil.shape), *grid.shape))
        for image, pupil_function in zip(
            stack, pupil_functions(pupil, x, 1.0 / self.samples, self.edge), strict=True
        ):
            field = to_rows @ pupil_function @ to_columns.T
            # A cell has the area (2 / n)^2, and the aperture the area pi: U = (4 / (pi n^2)) times the sum.
            samples = (4.0 / (math.pi * self.samples**2)) ** 2 * (field.real**2 + field.imag**2)
            pixels: Array = samples.reshape(grid.height, offset.size, grid.width, offset.size)
            image[:] = np.einsum("yaxb,a,b->yx", pixels, weight, weight, optimize=True)
        return Intensities(stack, None)


def samples_needed(pupil: Pupil, grid: Grid) -> tuple[int, str]:
    """Return the smallest number of samples without aliased light in the window, and a text with the reason."""
    # Images of n samples repeat at ``pi n`` in v: the blur of the neighbouring image must not reach the window.
    step = grid.step(pupil)
    blur = float(pupil.v(pupil.geometric_radius()).max())
    # Averages extend to the outer edges of pixels.
    window = max(float(np.abs(part).max()) for part in (grid.x, grid.y)) * step / grid.side + 0.5 * step
    reason = f"the geometric blur (v = {blur:.4g}) and the window (v = {window:.4g})"
    return math.ceil((blur + window) / math.pi), reason


def require_samples(method: Method, samples: int, pupil: Pupil, grid: Grid) -> None:
    """Raise ValueError if light would be aliased into the window, or if each image has an axis of its own."""
    grid.require_one_axis()
    count, reason = samples_needed(pupil, grid)
    if count > samples:
        requirement = (
            f"at least samples={count}" if count <= MAX_SAMPLES else f"{count:.3g} samples, over {MAX_SAMPLES}"
        )
        raise Declined(f"{type(method).__name__}(samples={samples}) would alias: {reason} need {requirement}")


def pupil_functions(pupil: Pupil, x: Array, half_side: float, edge: str) -> Iterator[NDArray[np.complex128]]:
    """Yield the field in cells of side ``2 half_side`` centred at ``(x, x)``, for each pupil of the stack."""
    rho, theta = np.hypot(x[:, None], x), np.arctan2(x[:, None], x)
    amplitude = transmission(pupil, x, half_side, edge)
    if not pupil.illumination.uniform:
        square, is_clear = x * x, np.abs(amplitude) > 0.0
        amplitude[is_clear] *= pupil.illumination.at((square[:, None] + square)[is_clear])
    wavefronts = pupil.wavefront.flattened()
    segment_phase = pupil.opening.phase(x[None, :], x[:, None]) if pupil.segmented else 0.0
    for i in range(wavefronts.shape[0]):
        yield amplitude * np.exp(1j * (wavefronts[i].phase(rho, theta) + segment_phase))


def transmission(pupil: Pupil, x: Array, half_side: float, edge: str) -> Values:
    """Return the amplitude, without apodization, of square cells of side ``2 half_side`` centred at ``(x, x)``.

    A "binary" edge has the transmission 0 or 1 at the centre of the cell, a "grey" edge the clear fraction of the
    cell (:meth:`lommel.optics.aperture.opening.Opening.coverage`); a mask multiplies this transmission by the mask
    value at the centre.
    """
    columns, rows = x[None, :], x[:, None]
    if edge == "grey":
        clear_fraction = pupil.opening.coverage(columns, rows, half_side)
    else:
        clear_fraction = (pupil.opening.margin(columns, rows) >= 0.0).astype(np.float64)
    return clear_fraction if pupil.mask is None else clear_fraction * pupil.mask.at(columns, rows)


def gauss_pixel(width: float, error: float) -> tuple[Array, Array]:
    """Return offsets in v and weights that average I within `error` over a pixel of `width` in v along an axis.

    The error is relative to ``sup abs(U)^2`` and holds for any pupil: U is of exponential type 1 along either axis.
    """
    x, w = gauss_legendre(pixel_nodes(width, error), -0.5, 0.5)
    return width * x, w


def pixel_error(width: float, nodes: int) -> float:
    """Bound the error of the mean of I over a pixel of `width` in v along an axis, divided by sup abs(U)^2."""
    # gauss_error() bounds the error of both axes relative to half the range of I. The bound for one axis, relative to
    # the whole range, is a quarter of it.
    return 0.25 * gauss_error(width, nodes)


def pixel_nodes(width: float, error: float) -> int:
    """Return the smallest number of nodes along an axis for which :func:`pixel_error` is at most `error`."""
    nodes = 1
    while pixel_error(width, nodes) > error:
        nodes += 1
    return nodes
