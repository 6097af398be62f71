"""The tables of microscopes: what :mod:`lommel.reports.microscope` says, for people."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from lommel.base.units import format_length
from lommel.cli.tables import console_of, list_of, made_how, table_of
from lommel.show.drawing import HOW, MEANING

if TYPE_CHECKING:
    from lommel.psf import PSF


def print_microscope(facts: dict[str, Any]) -> None:
    """Print what :func:`lommel.reports.microscope.describe_microscope` says."""
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
    """Print what :func:`lommel.reports.microscope.describe_stack` says."""
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
