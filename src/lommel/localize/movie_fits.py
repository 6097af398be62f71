"""Localisation of the molecules of a movie, block by block: find spots, fit boxes, convert to sample positions.

A box is a small window of a frame, around a spot of light.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, nullcontext
from dataclasses import dataclass, fields, replace
from os import PathLike
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.options import HIDDEN, Options, listed
from lommel.detection.molecules import Spots
from lommel.fit.findings import in_words
from lommel.localize.block_fits import BlockFits, MovieBlocks, State, kept_results
from lommel.localize.checks import TILTED, Checks
from lommel.localize.fitting import STATES, MoleculeErrors, Molecules
from lommel.localize.localizations import Localizations, MovieInfo, columns, joined
from lommel.localize.table import Table
from lommel.optics.layers.objective import FocalSurface
from lommel.recorded.counts import Counts, is_on_demand
from lommel.recorded.frames import Frames, frames_of
from lommel.recorded.headers import (
    Metadata,
    metadata_of,
    microscope_findings,
    missing_findings,
    told_early,
    with_header,
    without_missing,
)
from lommel.recorded.noise import Noise

_HEIGHTS, _ITERATIONS = 65, 100  # fit of Gaussians: number of heights z, and number of iterations


@dataclass(frozen=True, kw_only=True)
class LocalizeOptions(Options):
    """Options of the localisation of a movie.

    Parameters
    ----------
    flat : bool, default False
        Estimate x and y only, for PSFs from which z cannot be determined, for example without astigmatism. A fit that
        reaches an end of the range of z then counts as converged, and z is NaN.
    background : {"auto", "flat", "tilted"}, default "auto"
        Background of each box, see :func:`lommel.localize.fit`. "auto" starts with a flat background. It changes to a
        tilted background if the mean slope of the residuals exceeds five standard deviations, and the block is fitted
        again. The mean is over up to a thousand molecules of a block, in the whole frame or in a part of it.
    surface : FocalSurface, optional
        Focal surface over the frame, ``microscope.focal_surface``, subtracted from z; by default z counts from it.
    progress : callable, optional
        Function that is called after each block, with the number of processed frames and the total number. With
        `keep`, frames whose results were kept count from the first call on.
    client : distributed.Client or concurrent.futures.Executor, optional
        Executor that reads and fits the blocks; by default this process. Its workers must reach the files of the
        movie under the same paths. The results are the same bit by bit.
    keep : path, optional
        Output beside which the results of blocks are kept, in the hidden folder ``.NAME.unfinished``, until the call
        ends. After an error or a killed process, the same call continues with them.
    """

    heading: ClassVar[str] = "Fits"

    flat: bool = False
    background: Literal["auto", "flat", "tilted"] = "auto"
    surface: Annotated[FocalSurface | None, HIDDEN] = None
    progress: Annotated[Callable[[int, int], object] | None, HIDDEN] = None
    client: Annotated[Any, HIDDEN] = None
    keep: Annotated[Path | None, validation.path, HIDDEN] = None


@listed(LocalizeOptions)
def localize_movie(
    movie: Frames | str | PathLike[str] | ArrayLike | Counts,
    table: Table,
    *,
    noise: Noise | None = None,
    options: LocalizeOptions | None = None,
    **given: Any,
) -> Localizations:
    """Find the molecules of a movie and estimate their positions.

    Blocks of frames are searched by :func:`lommel.localize.find`, smoothed with the median over z of the width of the
    images in the table, and fitted by :func:`lommel.localize.fit`. Drift of the sample is not corrected. A molecule
    that emits in several frames has one row for each frame.

    Parameters
    ----------
    movie : Frames, path, Counts or array_like of shape (frames, rows, columns)
        Recorded frames, in the unit of `noise`. Saturated pixels are ignored in fits: by default those with the
        largest value of the integer type or, if many pixels have the largest value of 8 to 16 bits, with this value.
        :meth:`lommel.Counts.of` states them, and a mask of pixels to ignore, such as hot pixels.
    table : Table
        Table of the images of a molecule, for the pixel pitch of the camera. Boxes have the shape of these images.
    noise : Noise, optional
        Gain, offset and read noise of the camera, each a number or a map of the frame; by default frames are in
        electrons without read noise. Counts have their own.
    options : LocalizeOptions, optional
        Options as an object, changed by the following ones.
    {options}

    Returns
    -------
    Localizations

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or frames are smaller than the boxes. A file that is not a movie raises
        RecordingError, which is a ValueError.
    OSError
        If a file cannot be read.
    RuntimeError
        If the client cancels blocks, as when the scheduler of its cluster ends. The same call continues with `keep`.

    Examples
    --------
    >>> camera = lm.Noise(white=0.46, read=1.6, offset=100)  # doctest: +SKIP
    >>> found = localize_movie("movie.tif", table, noise=camera)  # doctest: +SKIP
    >>> found.save("molecules.csv")  # doctest: +SKIP

    Without the hot pixels of the camera, and without z, which the images do not determine:

    >>> counts = lm.Counts.of(frames, noise=camera, mask=hot)  # doctest: +SKIP
    >>> found = localize_movie(counts, table, flat=True, background="flat")  # doctest: +SKIP
    """
    return joined(localize_blocks(movie, table, noise=noise, options=options, **given))


@listed(LocalizeOptions)
def localize_blocks(
    movie: Frames | str | PathLike[str] | ArrayLike | Counts,
    table: Table,
    *,
    noise: Noise | None = None,
    options: LocalizeOptions | None = None,
    **given: Any,
) -> Iterator[Localizations]:
    """Yield the localisations of a movie block by block, for movies with more molecules than fit in memory.

    Parameters
    ----------
    movie, table, noise
        See :func:`lommel.localize.localize_movie`.
    options : LocalizeOptions, optional
        Options as an object, changed by the following ones.
    {options}

    Yields
    ------
    Localizations
        The localisations of a block of frames, of about four million pixels; the table of a block without molecules
        is empty. They can be written to files by :func:`lommel.localize.writer`.

    Raises
    ------
    TypeError, ValueError, OSError
        See :func:`lommel.localize.localize_movie`.
    """
    o = LocalizeOptions.of("localize_blocks", options, given)
    mask, saturation = None, None
    if isinstance(movie, Counts):
        if noise is not None:
            raise TypeError("noise must be omitted if movie are Counts, which have their own")
        noise, mask, saturation = movie.noise, movie.mask, movie.stated
    return movie_blocks(movie, table, noise, o, mask=mask, saturation=saturation)


def movie_blocks(
    movie: Frames | str | PathLike[str] | ArrayLike | Counts,
    table: Table,
    noise: Noise | None,
    options: LocalizeOptions,
    *,
    mask: Any = None,
    saturation: float | None = None,
    block: int | None = None,
) -> Iterator[Localizations]:
    """Yield the localisations of a movie by blocks of `block` frames."""
    validation.instance("table", table, Table)
    validation.optional("noise", noise, Noise)
    validation.optional("surface", surface := options.surface, FocalSurface)
    background, widths = options.background, gaussian_widths(table)
    # Median over z of the geometric mean of the widths along y and x.
    width = float(np.clip(np.median(np.sqrt(widths[1] * widths[2])), 0.5, min(table.shape) / 4.0))
    with _open_images(movie) as (shape, images, name, header):
        camera, saturation = with_header(noise, saturation, header, read=0.0)
        layers, times = table.pupil.layers, table.pupil.magnification
        facts = {"NA": layers.NA, "immersion": layers.immersion, "emission": layers.wavelength}
        found, remarks = microscope_findings(header, table.pixel, magnification=times, modality="widefield", **facts)
        of_recording = [finding for finding in told_early(found) if finding.severity == "doubt"]
        of_recording += missing_findings(header, camera, "molecules there were not found")
        for remark in (*in_words(found, "note"), *remarks):
            validation.tell(remark)
        if surface is not None and (surface.frame != tuple(shape[1:]) or table.along == "depth"):
            got = f"its frame is {surface.frame}, got frames of {tuple(shape[1:])} and z along {table.along}"
            raise ValueError(f"surface must be that of the frames of the movie, along z of the stage: {got}")
        pixel = table.pixel / table.pupil.magnification  # in the sample
        along = "none" if options.flat else table.along
        recording = MovieInfo(*shape, pixel, table.shape, along, name)
        fits = BlockFits(table, camera, width, None if options.client is None else 1)
        checks = Checks(recording, table, fits.fit_boxes, background, surface, of_recording)
        state = State(saturation, "flat" if background == "auto" else background)
        count, is_tested = 0, False
        with kept_results(options.keep, images, block, fits, mask) as unfinished:
            blocks = MovieBlocks(images, mask, block, fits, state, options.client, unfinished)
            if (before := blocks.kept) and options.progress is not None:
                options.progress(before, shape[0])
            while count < shape[0]:
                with closing(blocks.fitted(count)) as results:
                    for fitted in results:
                        if not state.is_of(fitted):
                            break  # it was fitted before a block that changed the state
                        spots, molecules = fitted.spots, fitted.molecules
                        if not is_tested:
                            is_tested = True
                            if fitted.first is not None:
                                checks.first(fitted.first)
                            tilt = checks.tilt(spots, molecules, fitted=background == "tilted")
                            if tilt > TILTED and background == "auto":
                                background = state.background = "tilted"
                                break  # it is fitted again
                        checks.compare(spots, state.background)
                        localizations = _localizations(spots, molecules, recording, widths, table)
                        if surface is not None:
                            localizations.table["z"] -= surface.z(molecules.row, molecules.column)
                        checks.count(localizations, spots.isolated, fitted.frames)
                        yield replace(localizations, findings=checks.findings, summary=checks.summary)
                        count, is_tested = count + fitted.frames, False
                        if fitted.is_assumed:
                            state.saturation = fitted.saturation  # for all following blocks
                        if options.progress is not None:
                            options.progress(max(count, before), shape[0])


@contextmanager
def _open_images(
    movie: Frames | str | PathLike[str] | ArrayLike | Counts,
) -> Iterator[tuple[tuple[int, int, int], Any, str, Metadata]]:
    """Yield the shape of a movie, its images, its file name ("" for an array), and its metadata."""
    if isinstance(movie, str | PathLike | Frames):
        with nullcontext(movie) if isinstance(movie, Frames) else frames_of("movie", movie) as frames:
            stack = frames.as_stack()
            count, rows, columns = stack.shape
            for note in () if frames is movie else without_missing(stack.notes, stack.metadata):
                validation.tell(f"movie: {note}")
            yield (count, rows, columns), stack, "" if stack.path is None else stack.path.name, stack.metadata
        return
    if isinstance(movie, Counts):
        values, header = movie.values, movie.metadata  # perhaps read on demand
    else:
        header = metadata_of("movie", movie)
        values = movie
        if not is_on_demand(movie):
            values, mask = validation.parted("movie", movie, "counts")
            values = values if mask is None else np.ma.masked_array(values, mask)
    if len(values.shape) != 3 or 0 in values.shape:
        raise ValueError(f"movie must have the shape (frames, rows, columns), got {values.shape}")
    count, rows, columns = values.shape
    yield (count, rows, columns), values, "", header


def _localizations(
    spots: Spots, molecules: Molecules, recording: MovieInfo, widths: tuple[Array, Array, Array], table: Table
) -> Localizations:
    """Return the localisations, in metres in the sample; `widths` is the result of `gaussian_widths`."""
    rows, pixel = np.zeros(len(spots), columns()), recording.pixel
    rows["frame"], rows["score"] = spots.frame, spots.score
    for name in ("discrepancy", "log_likelihood", "state"):
        rows[name] = getattr(molecules, name)
    sides = {"row": "y", "column": "x"}
    for name in (field.name for field in fields(MoleculeErrors)):
        # Positions are from the outer corner of the first pixel, half a pixel from its middle.
        column, scale, shift = (sides[name], pixel, 0.5) if name in sides else (name, 1.0, 0.0)
        rows[column] = (getattr(molecules, name) + shift) * scale
        rows[f"{column}_error"] = getattr(molecules.errors, name) * scale
    heights, width_y, width_x = widths
    rows["sigma_y"], rows["sigma_x"] = (
        pixel * np.interp(molecules.z, heights, width) for width in (width_y, width_x)
    )
    if recording.along == "none":
        # A fit that reaches an end of the range of z may be right in x and y: it counts as converged, without z.
        rows["state"][(molecules.state == STATES.index("border")) & np.isin(molecules.z, table.z)] = 0
        rows["z"] = rows["z_error"] = np.nan
    at_ends_of_z = int(np.isin(rows["z"][rows["state"] == STATES.index("border")], table.z).sum())
    not_fitted = spots.borders, spots.overlapping, spots.saturated, spots.left_out
    return Localizations(rows, recording, len(spots), *not_fitted, at_ends_of_z)


def gaussian_widths(table: Table) -> tuple[Array, Array, Array]:
    """Return heights z (m), and standard deviations (pixels) along y and x of Gaussians fitted to the images.

    The fit uses adaptive moments (G. M. Bernstein, M. Jarvis, doi:10.1086/338085): the second moments of the image
    multiplied by the Gaussian are half of the variances of the Gaussian.
    """
    heights = np.linspace(*table.z, _HEIGHTS)
    row, column = (side // 2 for side in table.shape)
    images = np.asarray(table(row, column, heights), np.float64)
    y, x = np.arange(table.shape[0]) - row, np.arange(table.shape[1]) - column
    variances = np.full((2, _HEIGHTS), 2.0)
    for _ in range(_ITERATIONS):
        weight_y, weight_x = (
            np.exp(-0.5 * axis**2 / variance[:, None]) for axis, variance in zip((y, x), variances, strict=True)
        )
        factors = (weight_y, weight_x), (weight_y * y**2, weight_x), (weight_y, weight_x * x**2)
        sums, *moments = (np.einsum("zyx,zy,zx->z", images, *pair) for pair in factors)
        variances = np.clip(2.0 * np.stack(moments) / sums, 0.1, max(table.shape) ** 2)
    return heights, *np.sqrt(variances)
