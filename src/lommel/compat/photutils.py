"""Effective PSFs for photutils: oversampled and pixel-integrated PSFs, at one field position or on a grid."""

from __future__ import annotations

from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from lommel.base import atomic, optional, validation
from lommel.base.arrays import Array, Values
from lommel.field.maps import FieldMap
from lommel.io import fits_images
from lommel.optics.pupil import Pupil
from lommel.psf import psf

_STDPSF_OVERSAMPLING = 4  # readers of STDPSF files assume this oversampling
_Grid = tuple[Values, Array, Array]


def effective_psf(pupil: Pupil, shape: int, pixel: float, *, oversampling: int = 4, **options: Any) -> Values:
    """Return effective PSFs (ePSFs): pixel-integrated values at steps of ``pixel / oversampling``.

    The star is in the middle of the array.

    Parameters
    ----------
    pupil : Pupil
        A single pupil or a stack.
    shape : int
        Width and height in pixels; odd.
    pixel : float
        Pixel pitch in metres, or in units of lambda*N if the pupil has no wavelength.
    oversampling : int, default 4
        Number of values per pixel along x, and also along y.
    options
        Options of :func:`lommel.psf`: `tol`, `blur` (seeing), `fill`, `threads`.

    Returns
    -------
    ndarray, shape pupil.shape + (n, n), ``n = oversampling * (shape - 1) + 1``
        The sum of the values of an ePSF is ``oversampling**2`` times the light in the window. The error bound is the
        bound of :func:`lommel.psf`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.

    References
    ----------
    J. Anderson and I. R. King, PASP 112, 1360 (2000), doi:10.1086/316632.
    """
    side = validation.integer("shape", shape, least=3, most=10_000)
    factor = validation.integer("oversampling", oversampling, least=1, most=32)
    if side % 2 == 0:
        raise ValueError(f"shape must be odd, so that the star is in the middle of a pixel, got {side}")
    for name in ("center", "integrate"):
        if name in options:
            raise ValueError(
                f"{name} must be left out: effective PSFs are pixel-integrated and centred on the middle pixel"
            )
    # Compute a PSF for each of factor^2 subpixel shifts of the axis. Interleaved, they are the oversampled values.
    row, column = side // 2 - np.mgrid[:factor, :factor] / factor
    stack = pupil[..., None, None] if pupil.shape else pupil
    shifted = psf(stack, side, pixel, center=(row, column), integrate=True, **options).values
    axes = shifted.ndim
    order = (*range(axes - 4), axes - 2, axes - 4, axes - 1, axes - 3)
    interleaved = shifted.transpose(order).reshape(*pupil.shape, side * factor, side * factor)
    n = factor * (side - 1) + 1
    return np.ascontiguousarray(interleaved[..., :n, :n])


def image_psf(pupil: Pupil, shape: int, pixel: float, *, oversampling: int = 4, **options: Any) -> Any:
    """Return ``photutils.psf.ImagePSF`` of a single pupil.

    Parameters
    ----------
    pupil : Pupil
    shape, pixel, oversampling, options
        As for :func:`effective_psf`.

    Returns
    -------
    photutils.psf.ImagePSF
        Model with flux 1 and the star at (0, 0).

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if `pupil` is a stack.
    ImportError
        If photutils is not installed.
    """
    model = optional.library("photutils.psf", "image_psf needs", "").ImagePSF
    if pupil.shape != ():
        raise ValueError(f"pupil must be a single pupil, got a stack of shape {pupil.shape}")
    return model(effective_psf(pupil, shape, pixel, oversampling=oversampling, **options), oversampling=oversampling)


def gridded_psf_model(
    field: FieldMap,
    rows: int,
    columns: int,
    *,
    sensor: tuple[float, float],
    shape: int,
    pixel: float,
    oversampling: int = 4,
    **options: Any,
) -> Any:
    """Return ``photutils.psf.GriddedPSFModel`` of a lens whose PSF varies over the field.

    Parameters
    ----------
    field : FieldMap
    rows, columns : int
        Number of rows and columns of the grid of PSFs, at least 2; the outermost PSFs are at the edges of the sensor.
    sensor : (float, float)
        Height and width of the sensor, centred on the axis, in the unit of `field`.
    shape, pixel, oversampling, options
        As for :func:`effective_psf`.

    Returns
    -------
    photutils.psf.GriddedPSFModel
        Positions are in pixels, from the centre of the first pixel.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or if the sensor extends beyond `field`.
    ImportError
        If photutils is not installed.
    """
    model = optional.library("photutils.psf", "gridded_psf_model needs", "").GriddedPSFModel
    table = optional.library("astropy.nddata", "gridded_psf_model needs", "fits").NDData
    values, x, y = _grid(field, rows, columns, sensor, shape, pixel, oversampling, options)
    positions = [(column, row) for row in y for column in x]
    meta = {"grid_xypos": positions, "oversampling": oversampling}
    return model(table(values.reshape(len(positions), *values.shape[2:]), meta=meta))


def save_stdpsf(
    path: str | PathLike[str],
    field: FieldMap,
    rows: int,
    columns: int,
    *,
    sensor: tuple[float, float],
    shape: int,
    pixel: float,
    **options: Any,
) -> None:
    """Write effective PSFs on a grid as a FITS file in the STDPSF format, which photutils reads.

    Parameters
    ----------
    path : path
        FITS file, with an oversampling of 4. Positions in it are rounded to whole pixels, which are numbered from 1.
    field, rows, columns, sensor, shape, pixel, options
        As for :func:`gridded_psf_model`.

    Raises
    ------
    TypeError, ValueError
        As for :func:`gridded_psf_model`, and if the grid has more than 99 rows or columns.
    ImportError
        If astropy is not installed.
    OSError
        If the file cannot be written.
    """
    for name, count in (("rows", rows), ("columns", columns)):
        validation.integer(name, count, least=2, most=99)
    values, x, y = _grid(field, rows, columns, sensor, shape, pixel, _STDPSF_OVERSAMPLING, options)
    header: dict[str, int] = {"NXPSFS": columns, "NYPSFS": rows}
    header |= {f"IPSFX{k:02d}": round(column) + 1 for k, column in enumerate(x, 1)}
    header |= {f"JPSFY{k:02d}": round(row) + 1 for k, row in enumerate(y, 1)}
    data = values.reshape(-1, *values.shape[2:])
    atomic.write(Path(path), fits_images.write([(data, header)]))


def _grid(
    field: FieldMap,
    rows: int,
    columns: int,
    sensor: tuple[float, float],
    shape: int,
    pixel: float,
    oversampling: int,
    options: dict[str, Any],
) -> _Grid:
    """Return effective PSFs, shape (rows, columns, n, n), and their x and y in pixels from the first pixel."""
    validation.instance("field", field, FieldMap)
    pitch = validation.real("pixel", pixel, above=0.0)
    positions = []
    for name, count, length in (("columns", columns, sensor[1]), ("rows", rows, sensor[0])):
        validation.integer(name, count, least=2, most=1000)
        side = round(validation.real("sensor", length, above=0.0) / pitch)
        # Positions are rounded to whole pixels, from the first pixel of the sensor to its last.
        positions.append(np.round(np.linspace(0.0, side - 1.0, count)))
    x, y = positions
    middle = [0.5 * (round(length / pitch) - 1) for length in (sensor[1], sensor[0])]
    pupils = field.pupil((x - middle[0]) * pitch, ((y - middle[1]) * pitch)[:, None])
    return effective_psf(pupils, shape, pixel, oversampling=oversampling, **options), x, y
