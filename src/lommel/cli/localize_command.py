"""The command ``lommel localize``: molecules of a movie in three dimensions, in a table."""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, ClassVar, Literal

import numpy as np
from rich.text import Text

from lommel.base.executors import connected
from lommel.base.options import In, Options, Shown, filled
from lommel.cli.command import CLIENT, OUTPUT, PLOT, command
from lommel.cli.instruments import CameraMaps, require_microscope, require_order
from lommel.cli.messages import finding_lines
from lommel.cli.output import progress, require_folder, save_figure, written
from lommel.io import registry
from lommel.localize import Localizations, LocalizeOptions, Table, writer
from lommel.localize.localizations import MEDIANS, joined
from lommel.localize.movie_fits import movie_blocks
from lommel.recorded.frames import open_frames
from lommel.recorded.headers import SIZES, without_missing
from lommel.report import Facts, Parts, Report, Wrapped
from lommel.report.table import described

_Z_RANGES = {"z": (-0.7e-6, 0.7e-6), "depth": (0.0, 1e-6)}
_SIDE = 15  # rows and columns of the boxes that are fitted


@dataclass(frozen=True, kw_only=True)
class MoleculeImages(Options):
    """Options for the images of molecules.

    Parameters
    ----------
    z
        Range of z; by default -0.7um 0.7um, or with --along depth 0um 1um.
    along
        z: the stage moves; depth: z is the depth of a molecule below the cover glass.
    depth
        Depth of the molecules below the cover glass, such as 2um; by default from the file.
    reach
        Largest distance of a molecule from the middle of its box along rows and columns, pixels.
    """

    heading: ClassVar[str] = "Molecules"

    z: Annotated[tuple[float, float] | None, Shown(length="um", metavar="FROM TO")] = None
    along: Literal["z", "depth"] = "z"
    depth: Annotated[float | None, Shown(length="um")] = None
    reach: Annotated[float, In(above=0.0)] = 3.0


@command
@filled(formats=registry.suffixes("molecules", described=True))
def localize(
    movie: Path,
    lens: Path,
    /,
    *,
    outputs: Annotated[tuple[Path, ...], OUTPUT],
    figure: Annotated[Path | None, PLOT] = None,
    client: Annotated[str | None, CLIENT] = None,
    camera: CameraMaps = CameraMaps(),
    molecules: MoleculeImages = MoleculeImages(),
    options: LocalizeOptions = LocalizeOptions(),
) -> Report:
    """Localise the molecules of a movie in three dimensions.

    MOVIE is a TIFF, OME-TIFF, OME-Zarr, FITS or NPY file of any length, as the camera recorded it. LENS is the file
    of an objective with a section [aberrations.zernike], such as astigmatism: it describes the images of molecules at
    the depth of the file (or --depth), from which positions are fitted by maximum likelihood.

    x and y are in the sample, from the outer corner of the first pixel along columns and rows. z is the position of
    the stage at which a molecule at this depth would have the same image, positive as objective and sample approach:
    molecules deeper in the sample have a smaller z. With --along depth, z is the depth of the molecule below the
    cover glass, for a stage that rests at the origin of the file. Fits that end at the range of z (--z) or beyond
    --reach, or do not converge, are counted, not written. Drift is not corrected, and a molecule seen in several
    frames has a row for each. The exit code is 3 if a check finds an error: no molecule, images that disagree with
    PSF and noise, the opposite sign of the astigmatism.

    Parameters
    ----------
    outputs
        Table of molecules: {formats}; may be repeated.
    figure
        Picture of the molecules, coloured by z: .png, .pdf or .svg.
    client
        Scheduler of a dask cluster that reads and fits the frames, such as tcp://host:8786; its workers must reach
        MOVIE under this path. After an interruption, the same command resumes.
    mask
        Image that is not 0 at pixels to ignore.
    flat
        Estimate only x and y, for images that do not determine z, as without astigmatism.
    background
        Background of each box: the same in all pixels, or with slopes; auto decides from the data.

    Examples
    --------
      lommel localize movie.tif zeiss-63x-astigmatic.toml --read 1.6 --offset 100 -o found.csv --plot found.png
      lommel localize movie.tif zeiss-63x-astigmatic.toml --read 1.6 --offset dark.tif --z -0.5um 0.5um -o a.hdf5
    """
    for path in outputs:
        registry.find("molecules", path, "--output")
        require_folder(path)
    require_order("MOVIE LENS, the movie first", movie, lens)
    z, along = molecules.z or _Z_RANGES[molecules.along], molecules.along
    microscope = require_microscope("localize", lens, camera=camera.camera, pixel=camera.pixel, depth=molecules.depth)
    start = time.perf_counter()
    with (
        progress("table of images", elsewhere=client is not None) as report_progress,
        open_frames(movie) as movie_file,
        connected(client) as cluster,
    ):
        frames = movie_file.as_stack()
        noise, saturation, header = camera.resolve(frames.metadata, microscope.camera)
        header = [*without_missing(frames.notes, frames.metadata), *header]
        optics = {key: value for key, value in frames.metadata.items() if key in (*SIZES, "missing")}
        mask = camera.mask_of(np.broadcast_to(False, (1, *frames.shape[1:])))
        pupil, pixel = dataclasses.replace(microscope, planes=1).pupil(), microscope.pixel
        table = Table(pupil, _SIDE, pixel, z=z, along=along, reach=molecules.reach)
        told = dataclasses.replace(
            options,
            surface=microscope.focal_surface,
            progress=lambda count, total: report_progress(f"frame {count} of {total}", count / total),
            client=cluster,
            keep=outputs[0] if cluster else None,
        )
        sized = dataclasses.replace(frames, metadata=optics)
        blocks = movie_blocks(sized, table, noise, told, mask=mask, saturation=saturation)
        with writer(*outputs) as write:
            molecules_found = joined(_written(blocks, write, whole=figure is not None))
    save_figure(molecules_found.plot, figure)
    recorded, _ = camera.recorded(lens, microscope.camera, noise)
    facts: Facts = {"movie": str(movie), "name": microscope.name, "source": microscope.source}
    facts |= {"aberrations": microscope.aberrations is not None, "noise": recorded} | molecules_found.to_dict()
    facts |= {"z": [float(f"{end:.12g}") for end in table.z], "table_error_bound": table.error_bound}
    facts |= {"seconds": time.perf_counter() - start, "notes": header}
    places = [place for path in outputs for place in registry.find("molecules", path).places(path)]
    parts_shown: Parts = [Text(facts["name"], "bold"), *described(facts), *finding_lines(facts)]
    drift = Wrapped("Drift is not corrected.", "dim")
    return Report(facts, [*parts_shown, drift], molecules_found.converged) + written([*places, figure])


def _written(
    blocks: Iterable[Localizations], write: Callable[[Localizations], None], *, whole: bool
) -> Iterator[Localizations]:
    """Write localisations, and yield them, unless `whole` with only the columns that the report needs."""
    kinds = np.dtype([("state", np.int32), *((name, np.float32) for name in MEDIANS)])
    for part in blocks:
        write(part)
        yield part if whole else dataclasses.replace(part, table=part.table[["state", *MEDIANS]].astype(kinds))
