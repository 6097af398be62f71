"""Reports on lenses, microscopes and their PSFs: facts (plain data for JSON), and tables with the same content."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from rich.text import Text

from lommel.base.arrays import plain
from lommel.base.units import format_length, per_mm, percent
from lommel.channel_psf import ColourPSF
from lommel.field.psf_grid import PSFGrid
from lommel.lensfiles.instrument import Instrument, wide_enough
from lommel.lensfiles.microscope_files import Microscope
from lommel.measures.psf_like import PSFLike, checked
from lommel.methods import ERFS, METHODS
from lommel.optics.colour.spectrum import Channels
from lommel.optics.pupil import checked as lens_pupil
from lommel.psf import PSF
from lommel.report import Facts, Parts, Report, Wrapped
from lommel.report.image_quality import image_quality, microscope_quality, place_quality, sensor_mtf, setup
from lommel.report.table import described, records_of
from lommel.show.drawing import MEANING, SAMPLING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from lommel.report.image_quality import Place

_MEANINGS = {**MEANING, **SAMPLING, **{kind.__name__: name for name, kind in (METHODS | ERFS).items()}}
_FIRST = ("strehl", "fwhm_with_pixel", "diameter_80_with_pixel", "mtf_at_nyquist_with_pixel", "in_focus", "rms_waves")


def summarize_lens(instrument: Instrument) -> Report:
    """Return a one-line report on a lens, its object and its sensor, without measures of image quality."""
    facts = setup(instrument) | {"camera": plain(instrument.camera)}
    lens = instrument.lens
    focus, target = (format_length(d, digits=6) for d in (lens.focus_distance, instrument.object_distance))
    line = (
        f"f = {format_length(lens.focal_length)}, f/{lens.f_number:.3g}, {format_length(lens.wavelength)}; "
        f"focus {focus}, object {target}; `lommel info` has its image quality"
    )
    return Report(facts, [Text(instrument.name, "bold"), Wrapped(line)])


def describe_lens(instrument: Instrument) -> Report:
    """Return the report of a lens and its object; the facts are those of `image_quality` and the camera."""
    facts, place = image_quality(instrument) | {"camera": plain(instrument.camera)}, describe_place(instrument)
    shown = [Text(instrument.name, "bold"), *place.parts, *described(facts, _MEANINGS, _FIRST)]
    return Report(facts | place.facts, shown)


def describe_place(instrument: Instrument) -> Report:
    """Return the report of the place on the sensor to which results refer; empty if the lens has no [field]."""
    if instrument.aberrations_of_field is None:
        return Report({}, [])
    facts = place_quality(instrument)
    at_place, between = facts["strehl_at_peak"], facts["strehl_over_field"]
    text = instrument.place_in_words[0].upper() + instrument.place_in_words[1:]
    text += "" if at_place is None else f", Strehl ratio at the peak {at_place:.3g}"
    if between is not None:
        low, high = between
        text += f"; {low:.3g} to {high:.3g} over the field to {format_length(facts['to'])} from the axis"
    return Report({"place": facts}, [Wrapped(f"{text}. --at X Y states another place.")])


def describe_microscope(microscope: Microscope, *, foci: bool = True) -> Report:
    """Return the report of a microscope, and with `foci` the focus of a freely rotating dipole at several depths."""
    facts = microscope_quality(microscope, foci=foci)
    nyquist = facts["nyquist"]
    warnings = [
        Wrapped(
            f"The {name}, {format_length(facts[name])}, is coarser than Nyquist sampling, "
            f"{format_length(nyquist['axial' if name == 'step' else 'pixel'])}: images lose their finest detail. "
            "The error bound of the PSF holds all the same."
        )
        for name in facts["too_coarse"]
    ]
    notes = [Wrapped(_FOCUS, "dim")] if facts["focus"] else []
    return Report(facts, [Text(facts["name"], "bold"), *described(facts), *notes, *warnings])


_FOCUS = (
    "focus: of a freely rotating dipole. paraxial, brightest: stage travel to that focus, from the paraxial focus on "
    "the cover glass; ratio: depth / brightest; FWHM: of the optics, without pixel, along the stage and in the "
    "sample; peak: intensity at the best focus relative to scalar theory without surfaces; collected: light relative "
    "to an emitter far from the glass, above 1 where supercritical light is collected"
)


def describe_psf(answer: PSF, seconds: float) -> Report:
    """Return the report of a PSF.

    If the window holds less than 95 % of the light, "wide_enough" is the side, in pixels, of a window for about 98 %.
    """
    energy, side = float(answer.energy), wide_enough(lens_pupil(answer.pupil), min(answer.grid.pitch))
    is_wide_enough = energy >= 0.95 or min(answer.shape) >= side
    facts = how_made(answer, seconds) | {"wide_enough": None if is_wide_enough else side, "energy": energy}
    notes = []
    if facts["sum"] is not None:
        notes.append(
            f"The sum of the values, {facts['sum']:.4g}, is not the light in the window, because point samples are "
            "more than lambda*N apart; with integrate = true in the lens file values are pixel-integrated."
        )
    if not is_wide_enough:
        notes.append(f"The window holds {percent(energy)} of the light; --shape {side} would hold about 98 %.")
    return Report({"psf": facts}, ["", *described(facts, _MEANINGS), *map(Wrapped, notes)])


def describe_field(instrument: Instrument, grid: PSFGrid, seconds: float) -> Report:
    """Return the report of PSFs over the field, with one entry for each PSF of the grid."""
    answer: Any = checked(grid.psf)
    sensor, energy = list(grid.sensor), np.asarray(answer.energy)
    facts: Facts = {"name": instrument.name, "source": instrument.source, "sensor": sensor}
    facts |= {"x": grid.x.tolist(), "y": grid.y.tolist(), "energy": energy.tolist()} | how_made(answer, seconds)
    parts: Parts = [Text(instrument.name, "bold"), *described(facts, _MEANINGS)]
    if energy.min() < 0.95:
        text = f"One window holds only {percent(energy.min())} of the light; a larger --shape holds more."
        parts.append(Wrapped(text))
    return Report(facts, parts)


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
    common = how_made(answer[0], seconds)
    facts = {
        "name": instrument.name,
        "source": instrument.source,
        **{name: common[name] for name in ("sampling", "pixel", "dtype", "normalize", "seconds")},
        "shape": list(answer.shape),
        "error_bound": answer.error_bound,
        "of_spectra": answer.channels.error,
        "channels": channels,
    }
    return Report(facts, [Text(instrument.name, "bold"), *described(facts, _MEANINGS)])


def describe_mtf(instrument: Instrument, places: Sequence[Place], channels: Channels | None = None) -> Report:
    """Return the report of the MTF, pixel included, at the Nyquist frequency and at half the Nyquist frequency.

    There is one row for each combination of `places` in the field and `channels` (without channels, the wavelength of
    the file), with values along x and y, and over the field those of radial (sagittal) and tangential lines.
    """
    facts = sensor_mtf(instrument, places, channels)
    notes = []
    if max(facts["frequency"]) > (cutoff := max(pupil.cutoff for _, _, pupil in places)):
        wavelength = format_length(instrument.lens.wavelength)
        channel_note = "" if channels is None else ", higher at shorter wavelengths"
        notes.append(f"0: the lens passes nothing above its cutoff, {per_mm(cutoff)} at {wavelength}{channel_note}")
    names = {"nyquist": "at Nyquist x, y", "half_nyquist": "at half x, y"}  # not lengths or frequencies
    rows = [{names.get(key, key): value for key, value in row.items()} for row in facts["rows"]]
    table = records_of("MTF, pixel included (sagittal, tangential: at Nyquist, at half)", rows)
    return Report({"mtf": facts}, ["", table, *described({"nyquist": facts["frequency"]}), *map(Wrapped, notes)])


def how_made(answer: PSFLike, seconds: float) -> Facts:
    """Return facts on the values of a PSF and on their computation; a stack has one peak for each PSF.

    "sum" is None unless the values are normalised to energy and their sum differs from the light in the window; for a
    stack it is a list with one sum for each PSF.
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
    energy, brightest = np.asarray(answer.energy), None
    facts = how_made(answer, seconds)
    if pupil.shape:
        brightest = int(np.argmax(facts["peak"]))
    facts |= {
        "pixel_in_sample": answer.pixel / pupil.magnification,
        "z": pupil.z.tolist(),
        "focus": pupil.focus.tolist(),
        "energy": energy.tolist(),
        "brightest": brightest,
    }
    return Report({"psf": facts}, ["", *described(facts, _MEANINGS)])
