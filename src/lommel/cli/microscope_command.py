"""What ``lommel info`` and ``lommel psf`` do with a file that describes a microscope."""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from lommel.base import validation
from lommel.base.units import format_length
from lommel.cli.parts import Length, figure_format, of_picture, print_json, save_figure
from lommel.cli.progress import progress

if TYPE_CHECKING:
    from lommel.lensfiles.microscope import Microscope

DEPTH = click.option("--depth", type=Length(), help='Of the emitter from the cover glass: "2 um". Of microscopes.')

_OF_LENSES = {
    "object_distance": "--depth says where the emitter is",
    "field": "its PSF is that of the axis",
    "mtf": "that of a stack is PSF.mtf in Python",
    "colour": "its emitter has one wavelength; lommel.colour_psf takes its pupil",
}
_OF_MICROSCOPES = ("stack", "step", "depth")


def stack_options(command: Callable[..., None]) -> Callable[..., None]:
    """Add what ``lommel psf`` takes of microscopes."""
    parts = [
        click.option("--stack", type=click.IntRange(1, 4096), metavar="PLANES",
                     help="Planes of the stage, about the origin of the file. Of microscopes."),
        click.option("--step", type=Length(), help='From plane to plane: "100 nm". Of microscopes.'),
        DEPTH,
    ]  # fmt: skip
    for part in reversed(parts):
        command = part(command)
    return command


def microscope_of(lens: Path, **options: Any) -> Microscope | None:
    """Return what a file says of a microscope, but for what options say instead; None if it is about a lens.

    ValueError for options that are given and of the other kind.
    """
    from lommel.lensfiles.microscope import stage_step
    from lommel.lensfiles.microscope_files import describes_microscope, load_microscope

    given = {name: value for name, value in options.items() if value is not None}
    if not describes_microscope(lens):
        for name in _OF_MICROSCOPES:
            if name in given:
                raise ValueError(f"--{name} is for microscopes, files with a section [objective]; {lens} has none")
        return None
    for name, instead in _OF_LENSES.items():
        if name in given:
            raise ValueError(
                f"--{name.replace('_', '-')} is for lenses, and {lens} describes a microscope: {instead}"
            )
    found = load_microscope(lens)
    if "pixel" in given:
        validation.pixel(given["pixel"], metric=True)
    if "shape" in given:
        given["shape"] = validation.image_shape(given["shape"])
    if "stack" in given:
        given["planes"] = given.pop("stack")
    if "step" in given:
        stage_step(given["step"])
    if given.get("planes", found.planes) > 1 and not given.get("step", found.step):
        apart = format_length(found.objective.nyquist(wavelength=found.wavelength).axial, digits=3)
        raise ValueError(f"--stack needs --step, where the file has no stack; at most {apart} keeps all of an image")
    if "step" in given and given.get("planes", found.planes) == 1:
        raise ValueError("--step needs --stack, where the file has no stack")
    return dataclasses.replace(found, **given)


def info(microscope: Microscope, as_json: bool) -> None:
    """Print what is known about a microscope."""
    from lommel.cli import microscope_tables
    from lommel.reports.microscope import describe_microscope

    facts = describe_microscope(microscope)
    if as_json:
        print_json(facts)
    else:
        microscope_tables.print_microscope(facts)


def psf(
    microscope: Microscope,
    outputs: tuple[Path, ...],
    written: list[Path],
    figure: Path | None,
    as_json: bool,
    options: dict[str, Any],
) -> None:
    """Compute a stack, print what it is, and write it to files: pictures of a stack are sections.

    `written` are the outputs and what belongs to them.
    """
    from lommel.cli import microscope_tables
    from lommel.psf import psf as compute
    from lommel.reports.microscope import describe_microscope, describe_stack

    stack = microscope.planes > 1
    drawn = [path for path in outputs if stack and path.suffix.lower() == ".png"]
    drawn += [figure] if figure is not None else []
    for path in drawn:
        figure_format(path)
    window, count = microscope.window, f"{microscope.planes} x " if stack else ""
    with progress(f"{count}{window[0]} x {window[1]} pixels"):
        start = time.perf_counter()
        answer = compute(microscope.pupil(), window, microscope.pixel, integrate=microscope.integrate, **options)
        seconds = time.perf_counter() - start
        facts = describe_microscope(microscope, foci=False) | {"psf": describe_stack(answer, seconds)}
        for path in outputs:
            if path not in drawn:
                answer.save(path)
        if drawn:
            axes: Any = answer.plot()
            shown = axes[0] if stack else axes
            shown.figure.suptitle(microscope.name, fontsize=9)
            for path in drawn:
                save_figure(shown.figure, path)
    if as_json:
        print_json(facts | {"files": [str(path) for path in (*written, *([figure] if figure else []))]})
        return
    microscope_tables.print_microscope(facts)
    microscope_tables.print_stack(answer, facts["psf"])
    for path in (*written, *([figure] if figure else [])):
        how = f": {'sections xy, xz and yz, ' if stack else ''}the square root of the values"
        click.echo(f"wrote {path}{how if path in drawn else of_picture(answer, path)}")
