"""The command ``lommel retrieve``: phase retrieval, the wavefront from star images."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import TYPE_CHECKING

import click

from lommel.base.units import with_error
from lommel.blur.blurs import Blur
from lommel.cli.fit_field_command import blur_in_words
from lommel.cli.instruments import DEFOCUS_UNIT, IMAGES, LENS, SeveralNumbers, StarCamera, defocus_coefficients
from lommel.cli.options import JSON, OUTPUT, Group, command, documented, option, plot_option
from lommel.cli.output import progress, save_figure, written
from lommel.estimation.phase_retrieval import retrieve as fit
from lommel.estimation.star_images import label
from lommel.io import zernike_tables
from lommel.recorded.frames import part_of, read_images
from lommel.report import Parts, Report, Wrapped, paragraphs, table_of
from lommel.special import zernike

if TYPE_CHECKING:
    from lommel.estimation.phase_retrieval import Retrieval

_UNITS = ("radians", "waves", "nm", "um")


class Search(Group, heading="Search"):
    """Restarts of the search."""

    starts: int = documented(fit, "starts", type=int, help="Maximum number of random restarts.")
    seed: int = option(type=click.IntRange(0), default=0, help="Seed of the random restarts.")


@command(JSON, kind=SeveralNumbers)
def retrieve(
    images: tuple[Path, ...] = IMAGES,
    lens: Path = LENS,
    defocus: str | None = option(metavar="NUMBERS",
        help="Known defocus of each image, such as -4 0 4, or one for all; of a single image 0 by default. Positive "
        "where the sensor was moved towards the lens. By default coefficients C_d in radians: the phase is "
        "2 C_d rho^2, rho = 1 at the edge of the pupil, so that one wave of defocus is C_d = pi."),
    defocus_unit: str = DEFOCUS_UNIT,
    terms: str = option(default="15",
        help='Number of Zernike terms from defocus on (Noll 4, 5, ...), or names: "defocus, spherical", '
        '"noll 5, noll 6", or as printed, "coma x, coma y".'),
    also: str = option(default="center",
        help='Nuisance parameters to estimate jointly: "center, f_number, wavelength, obscuration", or none.'),
    blur: bool = option(is_flag=True,
        help="Estimate blur by seeing and a Gaussian (jitter, charge diffusion) in each image, for telescopes on "
        "the ground."),
    output: Path | None = option("-o", "--output", type=OUTPUT,
        help="Wavefront as Zernike coefficients in Noll's order: .json, .toml or .csv."),
    figure: Path | None = plot_option("Figure of images, model, residuals and terms"),
    unit: str = option(type=click.Choice(_UNITS), default="radians",
        help="Unit of the printed coefficients. Defocus is C_d in radians, W020 in other units."),
    camera: StarCamera = StarCamera(),
    search: Search = Search(),
) -> Report:  # fmt: skip
    """Estimate a wavefront from star images (phase retrieval).

    IMAGES, of a star or another point source, are TIFF (one image per page), OME-Zarr, NPY, FITS (file.fits[SCI]
    selects one of several images) or 16-bit PNG files of one size, linear in light (no JPEG, no sRGB). LENS is a lens
    file with aperture, wavelength, f-number and pixel pitch; its wavefront is the starting point. Several images need
    the --defocus of each (phase diversity). One image leaves the common sign of the even terms (total defocus,
    astigmatism, spherical) undetermined: the solution nearer to the starting point is returned, or the solution whose
    first even term is positive if both are equally near.

    Coefficients are of Zernike terms in Noll's order, normalised to unit rms, and printed with standard errors. The
    reduced chi-squared (chi2) is about 1 where pupil, pixel pitch and noise are right. A misfit is stated in the last
    line and by "converged" and "reliable" of --json, and the exit code is 3.

    Examples
    --------
      lommel retrieve star-*.tif phone.toml --defocus -4 0 4 --read 2 -o wave.json --plot fit.png
      lommel retrieve star-1.tif star-2.tif phone.toml --defocus 0 4 --terms "defocus, spherical" --read 2
    """
    if output is not None:
        zernike_tables.find(output, "--output")
    instrument = camera.instrument_of_file(lens)
    with progress("reading") as status:
        read = read_images(_files(images))
        stars = read[...]
        noise, saturation, header = camera.resolve(read.metadata, instrument.camera)
        if defocus is None and len(stars) > 1:
            raise ValueError(f"--defocus must be given for {len(stars)} images: one number for each, such as -4 0 4")
        status("fitting")
        result = fit(
            stars,
            instrument.pupil(),
            pixel=instrument.side,
            noise=noise,
            mask=camera.mask(stars),
            saturation=saturation,
            terms=int(terms) if terms.strip().isdecimal() else _terms(terms),
            also=_names(also),
            blur=blur,
            defocus=defocus_coefficients(defocus or "0", defocus_unit, instrument),
            integrate=instrument.integrate,
            starts=search.starts,
            seed=search.seed,
            progress=lambda share, chi2: status(
                f"start {int(search.starts * share) + 1} of at most {search.starts}, chi2 {chi2:.3g}", share
            ),
        )
    notes = [*read.notes, *header]
    names = list(read.names)
    if output is not None:
        result.save(output)
    if figure is not None:
        save_figure(result.plot(unit=unit, names=names), figure)
    files = written([output, figure], lambda path: ": square roots of images and model" if path == figure else "")
    parts = [*_parts(result, unit, names, instrument.side), *map(Wrapped, notes)]
    return Report({"images": names} | result.to_dict() | {"notes": notes}, parts, result.converged) + files


def _parts(result: Retrieval, unit: str, files: list[str], pitch: float) -> Parts:
    """Return the tables of a retrieved wavefront in a unit, with standard errors, and the verdict."""
    unit_symbol = {"radians": "rad"}.get(unit, unit)
    values, errors = result.in_unit(unit)
    seidel: dict[object, str] = (
        {} if unit == "radians" else {"defocus": "defocus W020", "spherical": "spherical W040"}
    )
    rows = [(seidel.get(name, label(name)), *with_error(value, errors[name])) for name, value in values.items()]
    constants = {name: value for name, value in result.coefficients.items() if name not in values}
    rows += [
        (f"{n} {result.units[n]}".rstrip(), *with_error(value, result.errors[n])) for n, value in constants.items()
    ]
    row, column = result.center.T
    quantities = {"row": row, "column": column, "flux": result.flux, "background": result.background}
    columns = {name: value for name, value in quantities.items() if name in result.errors}

    def cell(name: str, k: int) -> str:
        return "+-".join(with_error(float(columns[name][k]), float(result.errors[name][k])))

    images = [[file, *(cell(name, k) for name in columns)] for k, file in enumerate(files)]
    texts = (_blur_text(*pair, pitch) for pair in zip(result.blurs, result.blur_errors, strict=True))
    closing_lines = [f"blur: {'; '.join(texts)}"] if any(result.blurs) else []
    return paragraphs(
        [table_of(("term", unit_symbol, "std. error"), rows)],
        [table_of(["image", *columns], images)],
        map(Wrapped, [*closing_lines, result.message]),
    )


def _blur_text(blurs: tuple[Blur, ...], errors: tuple[float, ...], pitch: float) -> str:
    """Return the blurs of an image and their standard errors as a text, Gaussians in pixels; `pitch` is in metres."""
    pairs = zip(blurs, errors, strict=True)
    texts = (blur_in_words(blur, error, pitch, getattr(blur, "focal_length", None)) for blur, error in pairs)
    return " and ".join(texts) or "nothing"


def _files(paths: tuple[Path, ...]) -> list[Path]:
    """Return the files; patterns that the shell has not expanded are expanded in the order of names."""
    files: list[Path] = []
    for path in paths:
        if path.exists() or part_of(path)[1] is not None or not set("*?[") & set(path.name):
            files.append(path)
        elif matches := sorted(path.parent.glob(path.name)):
            files += matches
        else:
            raise FileNotFoundError(errno.ENOENT, "No file matches", str(path))
    return files


def _names(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    return [] if names in (["none"], [""]) else names


def _terms(text: str) -> list[str]:
    """Return names of terms for :func:`lommel.retrieve`, also from names as printed in tables."""
    noll_names = {zernike.name(*zernike.term(j, "noll")): f"noll {j}" for j in range(_LAST_NAMED, 4, -1)}
    names = []
    for name in _names(text):
        order, _, remainder = name.partition(" ")
        index, _, printed = remainder.partition(" ")
        # The table prints "noll 8 coma x"; the user may also write "coma x" alone.
        if order in zernike.ORDERS and printed:
            name = f"{order} {index}"
        names.append(noll_names.get(name, name) if name not in ("defocus", "spherical") else name)
    return names


_LAST_NAMED = 66  # Noll index of the last term with a name of its own
