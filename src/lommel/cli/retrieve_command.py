"""The command that fits a wavefront to images of a star: ``lommel retrieve``."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from lommel.cli.parts import (
    FILE,
    Length,
    figure_format,
    instrument_of,
    one_line_errors,
    print_json,
    save_figure,
)
from lommel.cli.progress import progress

if TYPE_CHECKING:
    from lommel.estimation.phase_retrieval import Retrieval

_UNITS = ("radians", "waves", "nm", "um")


class _SeveralNumbers(click.Command):
    """A command whose option ``--defocus`` takes all numbers that follow it."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Join the numbers to one word."""
        joined: list[str] = []
        for word, before in zip(args, ["", *args], strict=False):
            if before == "--defocus" and joined[-1] == before:
                joined[-1] = f"--defocus={word}"
            elif joined and joined[-1].startswith("--defocus=") and _is_number(word):
                joined[-1] += f" {word}"
            else:
                joined.append(word)
        return super().parse_args(ctx, joined)


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


@click.command(cls=_SeveralNumbers)
@click.argument("images", type=FILE, nargs=-1, required=True)
@click.argument("lens", type=FILE)
@click.option(
    "--defocus",
    default="0",
    metavar="NUMBERS",
    help="C_d that each image has on top of the wavefront, radians: -4 0 4; positive where the sensor was "
    "moved towards the lens.",
)
@click.option(
    "--terms",
    default="15",
    show_default=True,
    help='A number of Zernike terms from defocus on (Noll\'s 4, 5, ...), or names: "defocus, spherical", '
    '"noll 5, noll 6".',
)
@click.option(
    "--also",
    default="center",
    show_default=True,
    help='What else is solved for: "center, f_number, wavelength, obscuration", or none.',
)
@click.option("--white", type=float, help="Electrons at the value 1 of an image: of counts, electrons per count.")
@click.option("--read", type=float, required=True, help="Noise of reading a pixel, rms electrons.")
@click.option("--offset", type=float, default=0.0, show_default=True, help="Value of a pixel that counted none.")
@click.option("--saturation", type=float, help="Values from here on are left out; of integers the largest is always.")
@click.option("--pixel", type=Length(), help='Pixel pitch, instead of the lens file\'s: "3.45 um".')
@click.option("--object-distance", type=Length(), help='Instead of the file\'s: "1.5 m", "inf".')
@click.option("--starts", type=int, default=20, show_default=True, help="So often is begun anew where nothing fits.")
@click.option("--seed", type=click.IntRange(0), default=0, show_default=True, help="Of these.")
@click.option("--unit", type=click.Choice(_UNITS), default="radians", show_default=True, help="Of what is printed.")
@click.option("-o", "--output", type=FILE, help="The wavefront, in Noll's terms: .json, .toml or .csv.")
@click.option("--plot", "figure", type=FILE,
              help="Square roots of images and model, the residual, the terms: .png, .pdf, .svg.")  # fmt: skip
@click.option("--json", "as_json", is_flag=True, help="Print what was found as JSON.")
@one_line_errors
def retrieve(
    images: tuple[Path, ...],
    lens: Path,
    defocus: str,
    terms: str,
    also: str,
    white: float | None,
    read: float,
    offset: float,
    saturation: float | None,
    starts: int,
    seed: int,
    unit: str,
    output: Path | None,
    figure: Path | None,
    as_json: bool,
    **changes: Any,
) -> None:
    """Fit a wavefront to images of a star, or of any point of light.

    IMAGES are TIFF (each page is an image), NPY, FITS or PNG, of one size, with values proportional to light but for
    the offset: no JPEG, no sRGB. LENS is a lens file: aperture, wavelength, f-number and pixel pitch; its wavefront
    is where the fit starts. Several images need the defocus of each.

    Terms are Noll's, rms. chi2 is about 1 where pupil, pixel and noise are right.

    \b
    Examples:
      lommel retrieve star-*.tif lens.toml --defocus -4 0 4 --read 2 -o wave.json --plot fit.png
      lommel retrieve spot.tif lens.toml --terms "defocus, spherical" --also "center, f_number" --read 2
    """  # noqa: D301 (\b is meant)
    from lommel.estimation.noise import Noise
    from lommel.estimation.phase_retrieval import retrieve as fit
    from lommel.io import zernike_tables
    from lommel.io.photos import read_images

    if output is not None:
        zernike_tables.suffix(output, "--output")
    if figure is not None:
        figure_format(figure)
    instrument = instrument_of(lens, **changes)
    noise = Noise(white=white, read=read, offset=offset)
    with progress("reading") as started:
        stars = read_images(_files(images))
        started("fitting")
        found = fit(
            stars,
            instrument.pupil(),
            pixel=instrument.side,
            noise=noise,
            terms=_terms(terms),
            also=_names(also),
            defocus=_numbers(defocus),
            saturation=saturation,
            integrate=instrument.integrate,
            starts=starts,
            seed=seed,
            progress=lambda share, chi2: started(
                f"start {int(starts * share) + 1} of at most {starts}, chi2 {chi2:.3g}", share
            ),
        )
    if output is not None:
        found.save(output)
    if figure is not None:
        save_figure(found.plot(), figure)
    written = [path for path in (output, figure) if path is not None]
    if as_json:
        print_json(_facts(found) | {"files": [str(path) for path in written]})
        return
    from lommel.cli import tables

    tables.print_retrieval(found, unit)
    for path in written:
        click.echo(f"wrote {path}{': images and model as their square roots' if path == figure else ''}")


def _files(paths: tuple[Path, ...]) -> list[Path]:
    """Return the files, those of patterns that no shell has replaced in the order of their names."""
    found: list[Path] = []
    for path in paths:
        if path.exists() or not set("*?[") & set(path.name):
            found.append(path)
        elif several := sorted(path.parent.glob(path.name)):
            found += several
        else:
            raise FileNotFoundError(errno.ENOENT, "No file is called so", str(path))
    return found


def _numbers(text: str) -> Any:
    words = text.replace(",", " ").split()
    if not words or not all(map(_is_number, words)):
        raise ValueError(f"defocus must be numbers, one for each image, got {text!r}")
    return float(words[0]) if len(words) == 1 else [float(word) for word in words]


def _terms(text: str) -> Any:
    return int(text) if text.strip().isdecimal() else _names(text)


def _names(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    return [] if names in (["none"], [""]) else names


def _facts(found: Retrieval) -> dict[str, Any]:
    """Return what JSON can hold; null is infinite."""

    def plain(value: Any) -> Any:
        if np.ndim(value):
            return [plain(part) for part in np.asarray(value)]
        return float(value) if np.isfinite(value) else None

    def named(values: dict[Any, Any]) -> dict[str, Any]:
        return {name if isinstance(name, str) else ",".join(map(str, name)): plain(v) for name, v in values.items()}

    return {
        "converged": found.converged,
        "reliable": found.reliable,
        "message": found.message,
        "chi2": found.chi2,
        "coefficients": named(found.coefficients),
        "deviation": named(found.deviation),
        "covariance": plain(found.covariance),
        "flux": plain(found.flux),
        "background": plain(found.background),
        "center": plain(found.center),
        "steps": found.steps,
        "starts": found.starts,
    }
