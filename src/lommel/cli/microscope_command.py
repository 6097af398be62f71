"""What ``lommel info`` and ``lommel psf`` do with a file that describes a microscope."""

from __future__ import annotations

import dataclasses
import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from lommel.base import validation
from lommel.base.units import format_length
from lommel.cli.parts import Length, figure_format, of_picture, print_json, save_figure
from lommel.cli.progress import progress
from lommel.show.drawing import HOW, MEANING

if TYPE_CHECKING:
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.psf import PSF


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
    from lommel.lensfiles.microscope_files import describes_microscope, load_microscope, stage_step

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
    from lommel.cli.reports import describe_microscope

    facts = describe_microscope(microscope)
    if as_json:
        print_json(facts)
    else:
        print_microscope(facts)


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
    from lommel.cli.reports import describe_microscope, describe_stack
    from lommel.psf import psf as compute

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
    print_microscope(facts)
    print_stack(answer, facts["psf"])
    for path in (*written, *([figure] if figure else [])):
        how = f": {'sections xy, xz and yz, ' if stack else ''}the square root of the values"
        click.echo(f"wrote {path}{how if path in drawn else of_picture(answer, path)}")


def print_microscope(facts: dict[str, Any]) -> None:
    """Print what :func:`lommel.cli.reports.describe_microscope` says."""
    from lommel.cli.tables import console_of, list_of  # rich takes long to import

    nyquist = facts["nyquist"]
    lines = [
        ("objective", f"NA {facts['NA']:g}, {facts['magnification']:g}x, immersion {facts['immersion']:g}, "
         f"working distance {format_length(facts['working_distance'])}"),
        ("cover glass", _layer(facts["coverslip"]) or "none, it dips into the sample"),
        *[("film", _layer(film)) for film in facts["films"]],
        *([] if facts["design"] is None else [("designed for", _design(facts["design"]))]),
        ("sample", f"index {facts['sample']:g}, emitter {format_length(facts['depth'])} deep"),
        ("critical angle", _angle(facts)),
        ("wavelength", format_length(facts["wavelength"])),
        ("emitter", facts["emitter"]),
        ("planes", _planes(facts)),
        ("pixel", f"{format_length(facts['pixel'])}, {format_length(facts['pixel_in_sample'])} in the sample"),
        ("Nyquist", f"pixel {format_length(nyquist['pixel'])}, {format_length(nyquist['lateral'])} in the sample; "
         f"step of the stage {format_length(nyquist['axial'])}"),
    ]  # fmt: skip
    console = console_of()
    console.print(facts["name"], style="bold")
    console.print(list_of(lines))
    for name in facts["too_coarse"]:
        limit = nyquist["axial" if name == "step" else "pixel"]
        console.print(
            f"The {name}, {format_length(facts[name])}, is coarser than Nyquist's {format_length(limit)}: an image "
            "loses its finest detail. The PSF itself is exact."
        )
    if facts["focus"]:
        _print_foci(facts)


def _print_foci(facts: dict[str, Any]) -> None:
    """Print where emitters are in focus, by their depth."""
    from lommel.cli.tables import console_of, table_of  # rich takes long to import

    console = console_of()
    heads = (
        "depth um",
        "paraxial um",
        "best um",
        "depth / best",
        "axial nm",
        "lateral nm",
        "peak",
        "/ at 0",
        "light",
    )
    table = table_of(*heads, left=-1, title="Focus of an emitter that turns freely")
    for column in table.columns:
        column.overflow = "fold"  # digits are not to be left out
    for row in facts["focus"]:
        table.add_row(
            f"{1e6 * row['depth']:.4g}",
            *(f"{1e6 * row[name]:.3f}" for name in ("paraxial", "brightest")),
            "-" if row["ratio"] is None else f"{row['ratio']:.3f}",
            *(f"{1e9 * row[name]:.0f}" for name in ("axial_fwhm", "lateral_fwhm")),
            *(f"{row[name]:.3f}" for name in ("peak", "peak_of_surface", "collected")),
        )
    console.print()
    console.print(table)
    console.print(
        "paraxial, best (brightest): how far the stage has moved since the surface of the glass was in focus; axial, "
        "lateral: full widths at half; light: what is collected, over that far from the glass",
        style="dim",
    )
    for reason in facts["refused"]:
        console.print(f"left out: {reason}", style="dim")


def print_stack(answer: PSF, facts: dict[str, Any]) -> None:
    """Print what :func:`lommel.cli.reports.describe_stack` says."""
    from lommel.cli.tables import console_of, list_of, made_how  # rich takes long to import

    peaks, energies = facts["peak"], facts["energy"]
    lines = [
        ("method", repr(answer.method)),
        ("values", f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"),
        ("pixels", f"{format_length(facts['pixel_in_sample'])} in the sample, {HOW[facts['sampling']]}"),
    ]
    if facts["brightest"] is None:
        lines += [("largest value", f"{peaks:.4g}"), ("energy in the window", f"{energies:.2%}")]
    else:
        best = facts["brightest"]
        ends = (format_length(facts[name][best], like=1e-6) for name in ("z", "focus"))
        at = "plane {}, z = {}, stage at {}".format(best, *ends)
        lines += [
            ("largest value", f"{peaks[best]:.4g} in {at}"),
            ("energy in the window", f"{min(energies):.2%} to {max(energies):.2%}, by plane"),
        ]
    console = console_of()
    console.print()
    console.print(list_of([*lines, *made_how(facts)], title="PSF"))


def _layer(layer: dict[str, float] | None) -> str:
    return "" if layer is None else f"{format_length(layer['thickness'])} of index {layer['index']:g}"


def _design(design: dict[str, Any]) -> str:
    return f"immersion {design['immersion']:g}, cover glass {_layer(design['coverslip']) or 'none'}"


def _angle(facts: dict[str, Any]) -> str:
    rim = f"the rim of the pupil is at {math.degrees(facts['rim_angle']):.1f} deg in the immersion"
    if facts["critical_angle"] is None:
        return f"none, all light of the pupil goes through the sample; {rim}"
    return f"{math.degrees(facts['critical_angle']):.1f} deg; {rim}"


def _planes(facts: dict[str, Any]) -> str:
    if facts["step"] is None:
        return f"one, at {_ORIGINS[facts['origin']]}"
    return f"{facts['planes']}, {format_length(facts['step'])} apart, about {_ORIGINS[facts['origin']]}"


_ORIGINS = {
    "brightest": "the brightest focus of the emitter",
    "paraxial": "the paraxial focus of the emitter",
    "coverslip": "the surface of the cover glass",
}
