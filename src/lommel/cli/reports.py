"""Reports on lenses, microscopes and PSFs: plain data for JSON, and the same in tables."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.text import Text

from lommel.base.units import format_length, known, number, per_mm, pitch_in_words
from lommel.channel_psf import ColourPSF
from lommel.cli.instruments import camera_in_words
from lommel.cli.lens_report import zernike_table
from lommel.cli.output import Facts, Report, Wrapped, list_of, refused, table_of
from lommel.field.psf_grid import PSFGrid
from lommel.lensfiles.image_quality import sensor_mtf
from lommel.lensfiles.instrument import Instrument, wide_enough
from lommel.lensfiles.microscope_files import Microscope
from lommel.lensfiles.microscope_quality import microscope_quality
from lommel.measures.psf_like import PSFGridLike, PSFLike, checked
from lommel.optics.colour.spectrum import Channels
from lommel.optics.pupil import checked as lens_pupil
from lommel.psf import PSF
from lommel.show.drawing import HOW, MEANING

if TYPE_CHECKING:
    from rich.console import RenderableType


def describe_psf(answer: PSF, seconds: float) -> Report:
    """Return the report of a PSF; "wide_enough" is a window for 98 % of the light if this has under 95 %."""
    energy, side = float(answer.energy), wide_enough(lens_pupil(answer.pupil), min(answer.grid.pitch))
    enough = energy >= 0.95 or min(answer.shape) >= side
    facts = how_made(answer, seconds) | {"wide_enough": None if enough else side, "energy": energy}
    # As many digits of the peak as its error bound leaves.
    digits = min(4, max(1, math.floor(-math.log10(answer.error_bound)))) if answer.error_bound else 4
    pixels = f"{HOW[answer.sampling]}, {facts['pixel_over_lambda_N']:.3g} lambda*N wide"
    parts = _psf_parts(answer, facts, pixels, f"{facts['peak']:.{digits}g}", f"{energy:.2%}")
    if facts["sum"] is not None:
        text = (
            f"The values sum to {facts['sum']:.4g}, not to the light in the window: point samples more than lambda*N "
            "apart do not. Use --integrate for pixel-integrated values."
        )
        parts.append(Wrapped(text))
    if not enough:
        text = f"The window holds {energy:.0%} of the light; --shape {side} would hold about 98 %."
        parts.append(Wrapped(text))
    return Report({"psf": facts}, parts)


def _psf_parts(answer: PSF, facts: Facts, pixels: str, peak: str, energy: str) -> list[RenderableType]:
    """Return the table of a PSF or a stack."""
    lines = [
        ("method", repr(answer.method)),
        ("values", _values(facts)),
        ("pixels", pixels),
        ("largest value", peak),
        ("energy in the window", energy),
        *_error_and_time(facts),
    ]
    return ["", list_of(lines, title="PSF")]


def describe_field(instrument: Instrument, grid: PSFGrid, seconds: float) -> Report:
    """Return the report of PSFs over the field, with one entry for each PSF of the grid."""
    answer: Any = checked(grid.psf)
    sensor, energy = list(grid.sensor), np.asarray(answer.energy)
    facts: Facts = {"name": instrument.name, "source": instrument.source, "sensor": sensor}
    facts |= {"x": grid.x.tolist(), "y": grid.y.tolist(), "energy": energy.tolist()} | how_made(answer, seconds)
    rows, columns, height, width = facts["shape"]
    sums = None
    if facts["sum"] is not None:
        ends = np.min(facts["sum"]), np.max(facts["sum"])
        sums = "{:.4g} to {:.4g}: point samples this far apart miss some of the light".format(*ends)
    lines = [
        ("sensor", f"{format_length(sensor[0])} x {format_length(sensor[1])} (height x width)"),
        ("method", repr(answer.method)),
        ("values", f"{rows} x {columns} PSFs of {height} x {width} {facts['dtype']}, {MEANING[answer.normalize]}"),
        ("pixel", f"{pitch_in_words(answer.pixel)}, {HOW[answer.sampling]}"),
        ("sums of the values", sums),
        ("energy in the window", f"{energy.min():.2%} to {energy.max():.2%}"),
        *_error_and_time(facts),
    ]
    parts: list[RenderableType] = [Text(instrument.name, "bold"), list_of(lines)]
    if energy.min() < 0.95:
        parts.append(Text(f"One window holds only {energy.min():.0%} of the light; a larger --shape holds more."))
    across, down = ([format_length(at, like=max(sensor)) for at in facts[axis]] for axis in ("x", "y"))
    peaks = [(y, *(f"{value:.4g}" for value in row)) for y, row in zip(down, facts["peak"], strict=True)]
    title = "Largest value at y (down) and x (across)"
    table = table_of(("", *across), peaks, left=-1, no_wrap=True, title=title)
    table.columns[0].style = "cyan"
    return Report(facts, [*parts, "", table])


def describe_colour(instrument: Instrument, answer: ColourPSF, seconds: float) -> Report:
    """Return the report of PSFs in colour channels, with the peak and the energy of each channel."""
    held = answer.normalize == "energy"
    each: list[Facts] = [
        {
            "name": name,
            "wavelengths": [w for w, _ in pairs],
            "weights": [share for _, share in pairs],
            "light": light,
            "peak": float(one.values.max()),
            "energy": float(one.values.sum(axis=(-2, -1), dtype=float).mean()) if held else None,
        }
        for (name, pairs), light, one in zip(answer.channels, answer.channels.light, answer, strict=True)
    ]
    made = how_made(answer[0], seconds)
    facts = {
        "name": instrument.name,
        "source": instrument.source,
        **{name: made[name] for name in ("sampling", "pixel", "dtype", "normalize", "seconds")},
        "shape": list(answer.shape),
        "error_bound": answer.error_bound,
        "of_spectra": answer.channels.error,
        "channels": each,
    }
    spectra = f"error at most {facts['of_spectra']:.2g} of the unaberrated peak" if facts["of_spectra"] else None
    bound, spent = _error_and_time(facts, " of a channel")
    lines = [
        ("values", _values(facts)),
        ("pixel", f"{format_length(facts['pixel'])}, {HOW[facts['sampling']]}"),
        bound,
        ("spectral sampling", spectra),
        spent,
    ]
    rows = []
    for one in each:
        waves = one["wavelengths"]
        ends = " to ".join(dict.fromkeys(format_length(end) for end in (min(waves), max(waves))))
        ends = ends if len(waves) == 1 else f"{len(waves)} from {ends}"
        rows.append((one["name"], ends, f"{one['light']:.3g}", f"{one['peak']:.4g}", known(one["energy"], ".2%")))
    table = table_of(("channel", "wavelengths", "light", "largest value", "sum of values"), rows)
    return Report(facts, [Text(instrument.name, "bold"), list_of(lines), "", table])


def _values(facts: Facts) -> str:
    return f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"


def _error_and_time(facts: Facts, channel: str = "") -> list[tuple[str, str]]:
    """Return rows for the error bound and the time."""
    bound = "none proven"
    if facts["error_bound"] is not None:
        bound = f"each value within {facts['error_bound']:.2g} of the peak{channel}"
    return [("error bound", bound), ("time", f"{1e3 * facts['seconds']:.1f} ms")]


def describe_mtf(instrument: Instrument, grid: PSFGridLike | None = None, channels: Channels | None = None) -> Report:
    """Return the report of the MTF, pixel included, at the Nyquist frequency and at half of it, along x and y.

    One row for each place of a `grid` and each of the `channels`, or for the axis and the wavelength of the file.
    """
    facts = sensor_mtf(instrument, grid, channels)
    heads = [name for name, of in (("position x, y", grid), ("channel", channels)) if of is not None]
    cells = []
    for row in facts["rows"]:
        place = ", ".join(format_length(row[axis] or 0.0, like=1e-3) for axis in ("x", "y"))
        first = [place if head != "channel" else row["channel"] for head in heads]
        cells.append([*first, *(f"{value:.4f}" for value in (*row["nyquist"], *row["half_nyquist"]))])
    names = (*heads, "x, Nyquist", "y, Nyquist", "x, half", "y, half")
    table = table_of(names, cells, left=0 if heads else -1, title="MTF, pixel included")
    across, down = map(per_mm, facts["frequency"])
    along = across if across == down else f"{across} along x and {down} along y"
    return Report({"mtf": facts}, ["", table, Text(f"Nyquist frequency: {along}; x: vertical lines", "dim")])


def how_made(answer: PSFLike, seconds: float) -> Facts:
    """Return the description of the values and how they were computed, sums and peaks for each PSF of a stack."""
    stray = answer.normalize == "energy" and not answer.sum_is_light
    return {
        "method": answer.method.to_dict(),
        "sampling": answer.sampling,
        "pixel_over_lambda_N": max(answer.grid.pitch) / answer.pupil.scale,
        "sum": answer.values.sum(axis=(-2, -1), dtype=float).tolist() if stray else None,
        "shape": list(answer.shape),
        "pixel": answer.pixel,
        "dtype": str(answer.values.dtype),
        "normalize": answer.normalize,
        "peak": answer.values.max(axis=(-2, -1)).tolist(),
        "error_bound": answer.error_bound,
        "seconds": seconds,
    }


def describe_microscope(microscope: Microscope, *, foci: bool = True) -> Report:
    """Return the report of a microscope; with `foci`, a row for each depth of a freely rotating dipole."""
    facts = microscope_quality(microscope, foci=foci)
    tables: list[RenderableType] = ["", zernike_table(facts)] if facts["zernike"] else []
    return Report(facts, [*_microscope_parts(facts), *tables, *(_focus_parts(facts) if facts["focus"] else ())])


def _microscope_parts(facts: Facts) -> list[RenderableType]:
    """Return the table of a microscope, and what it samples too coarsely."""
    nyquist, design = facts["nyquist"], facts["design"]
    if design is not None:
        design = f"immersion {design['immersion']:g}, cover glass {_layer_in_words(design['coverslip']) or 'none'}"
    rim = f"pupil edge at {math.degrees(facts['rim_angle']):.1f} deg in the immersion"
    critical = "none, all light of the pupil passes through the sample"
    if facts["critical_angle"] is not None:
        critical = f"{math.degrees(facts['critical_angle']):.1f} deg"
    several = (
        "one, at" if facts["step"] is None else f"{facts['planes']}, {format_length(facts['step'])} apart, centred on"
    )
    lines = [
        ("objective", f"NA {facts['NA']:g}, {facts['magnification']:g}x, immersion {facts['immersion']:g}, "
         f"working distance {format_length(facts['working_distance'])}"),
        ("amplitude", f"{facts['rim_amplitude']:.4g} at the edge of the pupil, by apodization"
         if facts["apodization"] else None),
        ("cover glass", _layer_in_words(facts["coverslip"]) or "none (dipping objective)"),
        *[("film", _layer_in_words(film)) for film in facts["films"]],
        ("designed for", design),
        ("sample", f"index {facts['sample']:g}, emitter at a depth of {format_length(facts['depth'])}"),
        ("critical angle", f"{critical}; {rim}"),
        ("wavelength", format_length(facts["wavelength"])),
        ("emitter", facts["emitter"]),
        ("rms wavefront error", f"{number(facts['rms_waves'])} waves over the pupil" if facts["zernike"] else None),
        ("planes", f"{several} {_ORIGINS[facts['origin']]}"),
        ("pixel", f"{format_length(facts['pixel'])}, {format_length(facts['pixel_in_sample'])} in the sample"),
        ("camera", camera_in_words(facts)),
        ("Nyquist sampling", f"pixel {format_length(nyquist['pixel'])}, "
         f"{format_length(nyquist['lateral'])} in the sample; stage step {format_length(nyquist['axial'])}"),
    ]  # fmt: skip
    coarse = [
        Text(
            f"The {name}, {format_length(facts[name])}, is coarser than Nyquist sampling, "
            f"{format_length(nyquist['axial' if name == 'step' else 'pixel'])}: images lose their finest detail. "
            "The PSF itself is not affected."
        )
        for name in facts["too_coarse"]
    ]
    return [Text(facts["name"], "bold"), list_of(lines), *coarse]


_ORIGINS = {
    "brightest": "the brightest focus",
    "paraxial": "the paraxial focus",
    "coverslip": "the surface of the cover glass",
}


def _layer_in_words(layer: dict[str, float] | None) -> str:
    return "" if layer is None else f"{format_length(layer['thickness'])} of index {layer['index']:g}"


def _focus_parts(facts: Facts) -> list[RenderableType]:
    """Return the table of the focus of emitters at several depths."""
    lengths = ("depth um", "paraxial um", "best um", "depth / best", "axial nm", "lateral nm")
    rows = [
        (
            f"{1e6 * row['depth']:.4g}",
            *(f"{1e6 * row[name]:.3f}" for name in ("paraxial", "brightest")),
            known(row["ratio"], ".3f"),
            *(f"{1e9 * row[name]:.0f}" for name in ("axial_fwhm", "lateral_fwhm")),
            *(f"{row[name]:.3f}" for name in ("peak", "peak_of_surface", "collected")),
        )
        for row in facts["focus"]
    ]
    table = table_of((*lengths, "peak", "/ at 0", "light"), rows, left=-1, title="Focus of a freely rotating dipole")
    for column in table.columns:
        column.overflow = "fold"  # or digits would be cut off
    note = (
        "paraxial, best (brightest): stage travel from the focus on the surface of the cover glass; axial, lateral: "
        "full width at half maximum of the optics alone, without the pixel; light: "
        "collected light relative to an emitter far from the glass"
    )
    return ["", table, Wrapped(note, "dim"), *refused(facts)]


def describe_stack(answer: PSF, seconds: float) -> Report:
    """Return the report of a stack of planes, or of one plane, whose "brightest" is None."""
    pupil: Any = answer.pupil
    energy, best = np.asarray(answer.energy), None
    facts = how_made(answer, seconds)
    peak, held = f"{np.max(facts['peak']):.4g}", f"{energy.min():.2%}"
    if pupil.shape:
        best = int(np.argmax(facts["peak"]))
        ends = (format_length(float(at[best]), like=1e-6) for at in (pupil.z, pupil.focus))
        peak += " in plane {}, z = {}, stage at {}".format(best, *ends)
        held += f" to {energy.max():.2%}, by plane"
    facts |= {
        "pixel_in_sample": answer.pixel / pupil.magnification,
        "z": pupil.z.tolist(),
        "focus": pupil.focus.tolist(),
        "energy": energy.tolist(),
        "brightest": best,
    }
    pixels = f"{format_length(facts['pixel_in_sample'])} in the sample, {HOW[answer.sampling]}"
    return Report({"psf": facts}, _psf_parts(answer, facts, pixels, peak, held))
