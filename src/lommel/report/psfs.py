"""Reports on PSFs: of a point, a stack, a field, colour channels; and the MTF."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.text import Text

from lommel.base.units import format_length, per_mm, percent, pitch_in_words
from lommel.channel_psf import ColourPSF
from lommel.field.psf_grid import PSFGrid
from lommel.lensfiles.instrument import Instrument, wide_enough
from lommel.measures.psf_like import PSFLike, checked
from lommel.optics.colour.spectrum import Channels
from lommel.optics.pupil import checked as lens_pupil
from lommel.psf import PSF
from lommel.report.image_quality import sensor_mtf
from lommel.report.tables import Facts, Parts, Report, Wrapped, list_of, table_of
from lommel.show.drawing import HOW, MEANING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from lommel.report.image_quality import Place


def describe_psf(answer: PSF, seconds: float) -> Report:
    """Return the report of a PSF; if it has below 95 % of the light, "wide_enough" is the side for about 98 %."""
    energy, side = float(answer.energy), wide_enough(lens_pupil(answer.pupil), min(answer.grid.pitch))
    enough = energy >= 0.95 or min(answer.shape) >= side
    facts = how_made(answer, seconds) | {"wide_enough": None if enough else side, "energy": energy}
    # As many digits of the peak as its error bound allows.
    digits = min(4, max(1, math.floor(-math.log10(answer.error_bound)))) if answer.error_bound else 4
    pixels = f"{HOW[answer.sampling]}, {facts['pixel_over_lambda_N']:.3g} lambda*N wide"
    parts = _psf_parts(answer, facts, pixels, f"{facts['peak']:.{digits}g}", percent(energy, 2))
    notes = []
    if facts["sum"] is not None:
        notes.append(
            f"The values sum to {facts['sum']:.4g}, not to the light in the window: point samples more than lambda*N "
            "apart do not. Use --integrate for pixel-integrated values."
        )
    if not enough:
        notes.append(f"The window holds {percent(energy)} of the light; --shape {side} would hold about 98 %.")
    return Report({"psf": facts}, [*parts, *map(Wrapped, notes)])


def _psf_parts(answer: PSF, facts: Facts, pixels: str, peak: str, energy: str) -> Parts:
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
    # "sum" is given only if the values do not sum to the light: see `how_made`.
    (rows, columns, height, width), sums = facts["shape"], facts["sum"]
    ends = "" if sums is None else f"{np.min(sums):.4g} to {np.max(sums):.4g}"
    lines = [
        ("sensor", f"{format_length(sensor[0])} x {format_length(sensor[1])} (height x width)"),
        ("method", repr(answer.method)),
        ("values", f"{rows} x {columns} PSFs of {height} x {width} {facts['dtype']}, {MEANING[answer.normalize]}"),
        ("pixel", f"{pitch_in_words(answer.pixel)}, {HOW[answer.sampling]}"),
        ("sums of the values", f"{ends}: point samples this far apart miss some of the light" if ends else None),
        ("energy in the window", f"{percent(energy.min(), 2)} to {percent(energy.max(), 2)}"),
        *_error_and_time(facts),
    ]
    parts: Parts = [Text(instrument.name, "bold"), list_of(lines)]
    if energy.min() < 0.95:
        parts.append(
            Text(f"One window holds only {percent(energy.min())} of the light; a larger --shape holds more.")
        )
    across, down = ([format_length(at, like=max(sensor)) for at in facts[axis]] for axis in ("x", "y"))
    peaks = [(y, *(f"{value:.4g}" for value in row)) for y, row in zip(down, facts["peak"], strict=True)]
    title = "Largest value at y (down) and x (across)"
    table = table_of(("", *across), peaks, left=-1, no_wrap=True, title=title)
    table.columns[0].style = "cyan"
    return Report(facts, [*parts, "", table])


def describe_colour(instrument: Instrument, answer: ColourPSF, seconds: float) -> Report:
    """Return the report of PSFs in colour channels, with the peak and the energy of each channel."""
    by_energy = answer.normalize == "energy"  # values sum to the light in the window
    channels: list[Facts] = [
        {
            "name": name,
            "wavelengths": [wavelength for wavelength, _ in spectrum],
            "weights": [weight for _, weight in spectrum],
            "light": light,
            "peak": float(psf.values.max()),
            "energy": float(psf.values.sum(axis=(-2, -1), dtype=float).mean()) if by_energy else None,
        }
        for (name, spectrum), light, psf in zip(answer.channels, answer.channels.light, answer, strict=True)
    ]
    made = how_made(answer[0], seconds)
    facts = {
        "name": instrument.name,
        "source": instrument.source,
        **{name: made[name] for name in ("sampling", "pixel", "dtype", "normalize", "seconds")},
        "shape": list(answer.shape),
        "error_bound": answer.error_bound,
        "of_spectra": answer.channels.error,
        "channels": channels,
    }
    spectra = f"error at most {facts['of_spectra']:.2g} of the unaberrated peak" if facts["of_spectra"] else None
    bound_row, time_row = _error_and_time(facts, " of a channel")
    lines = [
        ("values", _values(facts)),
        ("pixel", f"{format_length(facts['pixel'])}, {HOW[facts['sampling']]}"),
        bound_row,
        ("spectral sampling", spectra),
        time_row,
    ]
    rows = []
    for channel in channels:
        waves = channel["wavelengths"]
        ends = " to ".join(dict.fromkeys(format_length(end) for end in (min(waves), max(waves))))
        ends = ends if len(waves) == 1 else f"{len(waves)} from {ends}"
        light, peak, energy = f"{channel['light']:.3g}", f"{channel['peak']:.4g}", percent(channel["energy"], 2)
        rows.append((channel["name"], ends, light, peak, energy))
    table = table_of(("channel", "wavelengths", "light", "largest value", "sum of values"), rows)
    return Report(facts, [Text(instrument.name, "bold"), list_of(lines), "", table])


def _values(facts: Facts) -> str:
    """Return shape, type and normalisation of the values in words."""
    return f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"


def _error_and_time(facts: Facts, channel: str = "") -> list[tuple[str, str]]:
    """Return the row of the error bound, for the peak of a PSF or of a `channel`, and that of the time."""
    bound = "none proven"
    if facts["error_bound"] is not None:
        bound = f"each value within {facts['error_bound']:.2g} of the peak{channel}"
    return [("error bound", bound), ("time", f"{1e3 * facts['seconds']:.1f} ms, the first call")]


def describe_mtf(instrument: Instrument, places: Sequence[Place], channels: Channels | None = None) -> Report:
    """Return the report of the MTF, pixel included, at the Nyquist frequency and at half of it.

    There is one row for each of the `places` in the field and of the `channels`, or for the wavelength of the file
    without channels. Directions are sagittal and tangential, or x and y if the only place is the axis.
    """
    facts = sensor_mtf(instrument, places, channels)
    over_field = places[0][0] is not None
    heads = [name for name, there in (("position x, y", over_field), ("channel", channels is not None)) if there]
    cells, frequencies = [], facts["frequency"]
    for row in facts["rows"]:
        place = ", ".join(format_length(row[axis] or 0.0, like=1e-3) for axis in ("x", "y"))
        first = [place if head != "channel" else row["channel"] for head in heads]
        pairs = [row["nyquist"], row["half_nyquist"]]  # along x and y
        if "sagittal" in row:
            pairs = list(zip(row["sagittal"], row["tangential"], strict=True))
        # The MTF is exactly 0 from the cutoff of the lens on.
        cells.append([*first, *(f"{value:.4f}" if value else "0" for pair in pairs for value in pair)])
    one, other = ("S", "T") if over_field else ("x", "y")
    names = (*heads, f"{one}, Nyquist", f"{other}, Nyquist", f"{one}, half", f"{other}, half")
    table = table_of(names, cells, left=0 if heads else -1, title="MTF, pixel included")
    across, down = map(per_mm, frequencies)
    along = across if across == down else f"{across} along x and {down} along y"
    lines = "S sagittal: radial lines; T: tangential ones" if over_field else "x: vertical lines"
    notes = [f"Nyquist frequency: {along}; {lines}"]
    if max(frequencies) > (cutoff := max(pupil.cutoff for _, _, pupil in places)):
        light = format_length(instrument.lens.wavelength)
        others = "" if channels is None else ", higher at shorter wavelengths"
        notes.append(f"0: the lens passes nothing above its cutoff, {per_mm(cutoff)} at {light}{others}")
    return Report({"mtf": facts}, ["", table, *(Text(note, "dim") for note in notes)])


def how_made(answer: PSFLike, seconds: float) -> Facts:
    """Return the facts on the values of a PSF and their computation; sums and peaks are for each PSF of a stack.

    "sum" is None unless the values, although normalised to energy, do not sum to the light in the window.
    """
    undersampled = answer.normalize == "energy" and not answer.sum_is_light
    return {
        "method": answer.method.to_dict(),
        "sampling": answer.sampling,
        "pixel_over_lambda_N": max(answer.grid.pitch) / answer.pupil.scale,
        "sum": answer.values.sum(axis=(-2, -1), dtype=float).tolist() if undersampled else None,
        "shape": list(answer.shape),
        "pixel": answer.pixel,
        "dtype": str(answer.values.dtype),
        "normalize": answer.normalize,
        "peak": answer.values.max(axis=(-2, -1)).tolist(),
        "error_bound": answer.error_bound,
        "seconds": seconds,
    }


def describe_stack(answer: PSF, seconds: float) -> Report:
    """Return the report of a stack of planes, or of a single plane; "brightest" is the brightest plane of a stack."""
    pupil: Any = answer.pupil
    energy, best = np.asarray(answer.energy), None
    facts = how_made(answer, seconds)
    peak, energies = f"{np.max(facts['peak']):.4g}", percent(energy.min(), 2)
    if pupil.shape:
        best = int(np.argmax(facts["peak"]))
        ends = (format_length(float(at[best]), like=1e-6) for at in (pupil.z, pupil.focus))
        peak += " in plane {}, z = {}, stage at {}".format(best, *ends)
        energies += f" to {percent(energy.max(), 2)}, by plane"
    facts |= {
        "pixel_in_sample": answer.pixel / pupil.magnification,
        "z": pupil.z.tolist(),
        "focus": pupil.focus.tolist(),
        "energy": energy.tolist(),
        "brightest": best,
    }
    pixels = f"{format_length(facts['pixel_in_sample'])} in the sample, {HOW[answer.sampling]}"
    return Report({"psf": facts}, _psf_parts(answer, facts, pixels, peak, energies))
