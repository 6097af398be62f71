"""Localisation of the molecules of a movie: frames in blocks, spots, fits, positions in the sample."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import fields, replace
from functools import partial
from os import PathLike
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.detection.molecules import Spots, box_pixels, find, frame_counts
from lommel.localize.checks import TILTED, Checks
from lommel.localize.fitting import BACKGROUNDS, STATES, MoleculeErrors, Molecules, fit
from lommel.localize.localizations import Localizations, Recording, columns, joined
from lommel.localize.table import Table
from lommel.recorded.frames import BLOCK, Movie, open_movie
from lommel.recorded.noise import Noise

_HEIGHTS, _TURNS = 65, 100  # heights at which Gaussians are fitted, and iterations


def localize_movie(
    movie: Movie | str | PathLike[str] | ArrayLike,
    table: Table,
    *,
    noise: Noise | None = None,
    threshold: float = 6.0,
    width: float | None = None,
    saturation: float | None = None,
    starts: int = 4,
    flat: bool = False,
    background: str = "auto",
    mask: ArrayLike | None = None,
    block: int | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Localizations:
    """Find the molecules of a movie and estimate where they are.

    By :func:`lommel.localize.find` and :func:`lommel.localize.fit`, frames in blocks. Drift of the sample is not
    corrected, and molecules that shine in several frames are a row in each.

    Parameters
    ----------
    movie : Movie, path or array_like of shape (frames, rows, columns)
        Frames as the camera recorded them, in the unit of `noise`.
    table : Table
        Images of a molecule, with the pixels of the camera; its shape is that of the boxes.
    noise : Noise, optional
        Gain, offset and read noise of the camera, each a number or a map of the frame; by default frames are in
        electrons without read noise.
    threshold : float, default 6.0
        Least height of a spot in standard deviations of the background noise, at least 3.
    width : float, optional
        Standard deviation in pixels by which frames are smoothed to find spots; by default the median over z of that
        of the images in the table.
    saturation : float, optional
        As of :func:`lommel.localize.find`; pixels that are full do not count in fits.
    starts : int, default 4
        Number of starts of a fit where the first estimate is in doubt.
    flat : bool, default False
        For images that do not tell z, as without astigmatism: x and y alone are estimated for. A fit that ends at an
        end of the range of z has converged, and z is NaN.
    background : {"auto", "flat", "tilted"}, default "auto"
        Background of each box, as of :func:`lommel.localize.fit`. By default it is tilted from the block of frames on
        in which the slopes that flat ones leave, of up to a thousand molecules of a block, all together or in parts
        of the frame, are beyond five standard deviations.
    mask : array_like of bool, shape (rows, columns), optional
        True where a pixel is left out, as where the camera is hot.
    block : int, optional
        Frames in memory at once; by default as many as have four million pixels.
    threads : int, optional
        Maximum number of threads; by default the number of processors.
    progress : callable, optional
        Called with the number of frames done and their total after each block.

    Returns
    -------
    Localizations

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or frames are smaller than the boxes; MovieError if a file is no movie.
    OSError
        If a file cannot be read.

    Examples
    --------
    >>> camera = lm.Noise(white=0.46, read=1.6, offset=100)  # doctest: +SKIP
    >>> found = localize_movie("movie.tif", table, noise=camera)  # doctest: +SKIP
    >>> found.save("molecules.csv")  # doctest: +SKIP
    """
    blocks = localize_blocks(
        movie, table, noise=noise, threshold=threshold, width=width, saturation=saturation, starts=starts, flat=flat,
        background=background, mask=mask, block=block, threads=threads, progress=progress,
    )  # fmt: skip
    return joined(list(blocks))


def localize_blocks(
    movie: Movie | str | PathLike[str] | ArrayLike,
    table: Table,
    *,
    noise: Noise | None = None,
    threshold: float = 6.0,
    width: float | None = None,
    saturation: float | None = None,
    starts: int = 4,
    flat: bool = False,
    background: str = "auto",
    mask: ArrayLike | None = None,
    block: int | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Iterator[Localizations]:
    """Yield the localisations of a movie block by block, for movies whose molecules are more than memory holds.

    Parameters
    ----------
    movie, table, noise, threshold, width, saturation, starts, flat, background, mask, block, threads, progress
        As of :func:`lommel.localize.localize_movie`.

    Yields
    ------
    Localizations
        Of each block of frames, at least one, also without molecules; :func:`lommel.localize.writer` writes them.

    Raises
    ------
    TypeError, ValueError, OSError
        As of :func:`lommel.localize.localize_movie`.
    """
    validation.instance("table", table, Table)
    validation.function("progress", progress, required=False)
    validation.optional("noise", noise, Noise)
    camera = noise or Noise(read=0.0)
    kind = validation.choice("background", background, ("auto", *BACKGROUNDS))
    widths = gaussian_widths(table)
    if width is None:
        # The geometric mean of both widths, at the median height.
        width = float(np.clip(np.median(np.sqrt(widths[1] * widths[2])), 0.5, min(table.shape) / 4.0))
    search = partial(find, box=table.shape, noise=camera, threshold=threshold, width=width, threads=threads)
    with _opened(movie, block) as (shape, blocks, name):
        # From the sensor to the sample.
        pixel = table.pixel / table.pupil.magnification
        along = "none" if validation.truth("flat", flat) else table.along
        recording = Recording(*shape, pixel, table.shape, along, name)
        again = partial(fit, noise=camera, saturation=math.inf, starts=starts, threads=threads)
        checks, done = Checks(recording, table, again, kind), 0
        for frames in blocks:
            counts = frame_counts(frames, table.shape, saturation=saturation, mask=mask)
            if not done:
                checks.first(counts)
            if counts.assumed:
                saturation = counts.saturation  # of the frames that follow, too
            spots = search(counts, first=done)
            values = counts.marked()
            begun = "flat" if kind == "auto" else kind
            found = _recentred(values, spots, done, table, partial(again, table, background=begun))
            if checks.tilt(spots, found, fitted=begun == "tilted") > TILTED and kind == "auto":
                kind = "tilted"
                found = _recentred(values, spots, done, table, partial(again, table, background=kind))
            checks.compare(spots, "tilted" if kind == "tilted" else "flat")
            part = _localizations(spots, found, recording, widths, table)
            checks.count(part)
            yield replace(part, findings=checks.findings, summary=checks.summary)
            done += len(frames)
            if progress is not None:
                progress(done, shape[0])


_ROUNDS = 3  # largest number of times a box is moved


def _recentred(frames: Values, spots: Spots, first: int, table: Table, again: Callable[..., Molecules]) -> Molecules:
    """Return fits of boxes; off-centre molecules, as with coma, are fitted again in boxes around their estimates."""

    def boxes(of: NDArray[np.int64], at: NDArray[np.int64]) -> Values:
        return np.asarray(frames[of[:, None, None], *box_pixels(at, table.shape)])

    which, corners = spots.frame - first, spots.corners
    found = again(boxes(which, corners), corners=corners)
    most, middle = np.array(frames.shape[1:]) - table.shape, np.array(table.shape) // 2
    moved = np.arange(len(which))
    for _ in range(_ROUNDS):
        places = np.round(np.stack([found.row[moved], found.column[moved]], axis=1)).astype(np.int64) - middle
        places = np.clip(places, 0, most)
        other_place = (places != corners[moved]).any(axis=1)
        moved, places = moved[other_place], places[other_place]
        if not moved.size:
            break
        other = again(boxes(which[moved], places), corners=places)
        # A move that loses convergence is not kept.
        better = other.converged | ~found.converged[moved]
        moved, places = moved[better], places[better]
        found, corners[moved] = found.replaced(moved, other[better]), places
    return found


@contextmanager
def _opened(
    movie: Movie | str | PathLike[str] | ArrayLike, block: int | None
) -> Iterator[tuple[tuple[int, int, int], Iterator[Values], str]]:
    """Yield the shape of a movie, its blocks, and its name."""
    if isinstance(movie, str | PathLike):
        with open_movie(movie) as opened:
            yield opened.shape, opened.blocks(block), opened.path.name
    elif isinstance(movie, Movie):
        yield movie.shape, movie.blocks(block), Path(movie.path).name
    else:
        values, hidden = validation.parted("movie", movie)
        frames = values if hidden is None else np.ma.masked_array(values, mask=hidden)
        if frames.ndim != 3 or not frames.size:
            raise ValueError(f"movie must have the shape (frames, rows, columns), got {frames.shape}")
        count, rows, across = frames.shape
        each = max(1, BLOCK // (rows * across)) if block is None else block
        validation.integer("block", each, least=1, most=validation.MAX_VALUES)
        yield (count, rows, across), (frames[k : k + each] for k in range(0, count, each)), ""


def _localizations(
    spots: Spots, found: Molecules, recording: Recording, widths: tuple[Array, Array, Array], table: Table
) -> Localizations:
    rows, pixel = np.zeros(len(spots), columns()), recording.pixel
    rows["frame"], rows["score"] = spots.frame, spots.score
    for name in ("discrepancy", "log_likelihood", "state"):
        rows[name] = getattr(found, name)
    sides = {"row": "y", "column": "x"}
    for name in (each.name for each in fields(MoleculeErrors)):
        # Positions from the outer corner of the first pixel, whose middle is half a pixel from it.
        to, scale, shift = (sides[name], pixel, 0.5) if name in sides else (name, 1.0, 0.0)
        rows[to] = (getattr(found, name) + shift) * scale
        rows[f"{to}_error"] = getattr(found.errors, name) * scale
    heights, along_y, along_x = widths
    rows["sigma_y"], rows["sigma_x"] = (pixel * np.interp(found.z, heights, one) for one in (along_y, along_x))
    if recording.along == "none":
        # A flat fit at an end of z may be right in x and y; z is not reported.
        rows["state"][(found.state == STATES.index("border")) & np.isin(found.z, table.z)] = 0
        rows["z"] = rows["z_error"] = np.nan
    ends = int(np.isin(rows["z"][rows["state"] == STATES.index("border")], table.z).sum())
    left = spots.borders, spots.overlapping, spots.saturated, spots.left_out, ends
    return Localizations(rows, recording, len(spots), *left)


def gaussian_widths(table: Table) -> tuple[Array, Array, Array]:
    """Return heights z, and deviations along rows and columns of Gaussians fitted to the images there, pixels.

    Adaptive moments (G. M. Bernstein, M. Jarvis, doi:10.1086/338085): weighed by the Gaussian itself, the second
    moments of a Gaussian are half its own.
    """
    heights = np.linspace(*table.z, _HEIGHTS)
    row, column = (side // 2 for side in table.shape)
    images = np.asarray(table(row, column, heights), np.float64)
    sides = np.arange(table.shape[0]) - row, np.arange(table.shape[1]) - column
    variances = np.full((2, _HEIGHTS), 2.0)
    for _ in range(_TURNS):
        tall, wide = (np.exp(-0.5 * at**2 / one[:, None]) for at, one in zip(sides, variances, strict=True))
        pairs = (tall, wide), (tall * sides[0] ** 2, wide), (tall, wide * sides[1] ** 2)
        sums, *moments = (np.einsum("zyx,zy,zx->z", images, *pair) for pair in pairs)
        # Variances of Gaussians are twice the weighed second moments.
        variances = np.clip(2.0 * np.stack(moments) / sums, 0.1, max(table.shape) ** 2)
    return heights, *np.sqrt(variances)
