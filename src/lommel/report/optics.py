"""Reports on lenses, microscopes and their PSFs: facts (plain data for JSON), and tables with the same content."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.text import Text

from lommel.base.arrays import plain
from lommel.base.units import format_length, known, number, per_mm, percent, pitch_in_words, strehl_ratio
from lommel.channel_psf import ColourPSF
from lommel.field.psf_grid import PSFGrid
from lommel.lensfiles.instrument import Instrument, wide_enough
from lommel.lensfiles.microscope_files import Microscope
from lommel.measures.psf_like import PSFLike, checked
from lommel.optics.colour.spectrum import Channels
from lommel.optics.pupil import checked as lens_pupil
from lommel.psf import PSF
from lommel.report import Facts, Parts, Report, Wrapped, finite, list_of, paragraphs, refusal_lines, table_of
from lommel.report.image_quality import IN_FOCUS, ImageQuality, microscope_quality, sensor_mtf
from lommel.show.drawing import MEANING, SAMPLING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import RenderableType
    from rich.table import Table

    from lommel.optics.lens import Lens
    from lommel.report.image_quality import Place

# If (diameter of 80 % of the light) / FWHM exceeds this value, the image is a narrow central peak within a wide blur,
# and the report labels the FWHM as the width of the peak.
_NARROW_PEAK = 4.0


def summarize_lens(instrument: Instrument) -> Report:
    """Return a one-line report on a lens, its object and its sensor, without measures of image quality."""
    facts = ImageQuality(instrument).setup() | {"camera": plain(instrument.camera)}
    focus_distance, object_distance = distinct(facts["focus_distance"], facts["object_distance"])
    lens = instrument.lens
    line = (
        f"f = {format_length(lens.focal_length)}, f/{lens.f_number:.3g}, {format_length(lens.wavelength)}; "
        f"focus {focus_distance}, object {object_distance}; `lommel info` has its image quality"
    )
    return Report(facts, [Text(instrument.name, "bold"), Wrapped(line)])


def describe_lens(instrument: Instrument) -> Report:
    """Return the report of a lens and its object; the facts are `ImageQuality.to_dict()` and the camera."""
    facts = ImageQuality(instrument).to_dict() | {"camera": plain(instrument.camera)}
    heading = Text(instrument.name, "bold"), _setup(facts)
    return Report(facts, [*heading, *_image_parts(facts, instrument.pitch), *_wavefront_parts(facts)])


def _setup(facts: Facts) -> Table:
    """Return the table of lens, object and sensor."""
    focus_distance, object_distance = distinct(facts["focus_distance"], facts["object_distance"])
    obscuration = f", obscuration {facts['obscuration']:.3g}" if facts["obscuration"] else ""
    pixel, depth_of_field = pitch_in_words(facts["pixel"]), facts["in_focus"]
    hyperfocal = facts["hyperfocal_distance"]
    if facts["arcsec_per_pixel"]:
        pixel += f", {number(facts['arcsec_per_pixel'])} arcsec"
    if facts["pixel_in_object"]:
        pixel += f", {format_length(facts['pixel_in_object'])} in the sample"
    if depth_of_field is not None:
        ends = " to ".join(distinct(depth_of_field["near"], depth_of_field["far"]))
        depth_of_field = f"{ends} ({_largest_blur(facts)})"
    lens = f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
    rows = [
        ("lens", f"{lens} (working f/{facts['working_f_number']:.4g}){obscuration}"),
        *_aperture(facts),
        ("wavelength", format_length(facts["wavelength"])),
        ("focus distance", focus_distance),
        ("object distance", object_distance),
        ("depth of field", depth_of_field),
        ("hyperfocal distance", hyperfocal and f"{format_length(hyperfocal)} ({_largest_blur(facts)})"),
        ("pixel", pixel),
        ("camera", camera_in_words(facts)),
    ]
    return list_of(rows)


def _largest_blur(facts: Facts) -> str:
    """Return the largest circle of confusion that counts as in focus, as a text."""
    return f"blur of {IN_FOCUS:g} pixels, {format_length(IN_FOCUS * float(np.max(facts['pixel'])))}"


def _image_parts(facts: Facts, pitch: tuple[float, float]) -> Parts:
    """Return the tables on the image of a point; `pitch` is the pixel pitch along y and x, metres."""
    on_axis, at_peak, bound = facts["strehl"], facts["strehl_at_peak"], facts["encircled_energy_error"]
    strehl = strehl_ratio(on_axis)
    if at_peak is not None and on_axis is not None and at_peak > 1.005 * on_axis:
        strehl += f" on the axis, {strehl_ratio(at_peak)} at the brightest point"
    lines = [
        ("Strehl ratio", strehl),
        ("Marechal's estimate", strehl_ratio(facts["marechal"]) if (facts["marechal"] or 0.0) >= 0.3 else None),
        *_mtf_rows(facts),
        ("focus tolerance", _focus_tolerance(facts)),
    ]
    energies = [
        (row["within"], format_length(row["radius"]), percent(row["fraction"], 1), percent(row["unaberrated"], 1))
        for row in facts["encircled_energy"]
    ]
    names, title = ("within", "radius", "this lens", "unaberrated"), "Encircled energy about the axis, optics alone"
    parts: Parts = ["", list_of(lines, title="Image of a point"), "", _diameters(facts, pitch[1])]
    parts += ["", table_of(names, energies, title=title)]
    if bound is not None:
        parts.append(Text(f"error of these fractions at most {bound:.1g}", "dim"))
    elif any(facts["aperture"].values()):
        parts.append(Text("no proven error bound for this aperture", "dim"))
    return parts if facts["field"] is None else [*parts, *_field_parts(facts["field"])]


def _focus_tolerance(facts: Facts) -> str | None:
    """Return the focus tolerance as a text, None if it could not be computed."""
    if facts["focus_tolerance"] is None:
        return None
    towards, away = (f"{end / 1e-6:+.3g} um" for end in facts["focus_tolerance"])
    half = per_mm(0.5 * min(facts["nyquist"], facts["nyquist_y"]))
    return f"sensor {towards} to {away} for an MTF of 0.3 at {half}, with the pixel"


def _mtf_rows(facts: Facts) -> list[tuple[str, str | None]]:
    """Return the rows of the MTF, separately for x and y if they differ."""

    def axis_rows(suffix: str) -> list[tuple[str, str | None]]:
        names = ("mtf_at_nyquist_with_pixel", "mtf_at_nyquist", "mtf50", "nyquist")
        with_pixel, optics_alone, frequency50, nyquist = (facts[name + suffix] for name in names)
        mtf = None
        if optics_alone is not None and nyquist < facts["cutoff"]:
            mtf = f"{with_pixel:.4f} with the pixel, {optics_alone:.4f} without, at {per_mm(nyquist)}"
        mtf50 = frequency50 and f"{per_mm(frequency50)}, optics alone (cutoff {per_mm(facts['cutoff'])})"
        return [("MTF at Nyquist", mtf), ("MTF50", mtf50)]

    x, y = axis_rows(""), axis_rows("_y")
    pairs = zip(x, y, strict=True)
    if x == y:
        return x
    return [(f"{name}, {axis}", text) for pair in pairs for axis, (name, text) in zip("xy", pair, strict=True)]


def _diameters(facts: Facts, pixel: float) -> RenderableType:
    """Return the table of blur diameters in micrometres and in pixels of the pitch `pixel`, metres.

    Telescopes also have diameters in arcseconds, and microscopes in nanometres in the sample.
    """
    fwhm, diameter_80, ring = facts["fwhm"], facts["diameter_80"], facts["dark_ring_radius"]
    unlike_airy = ring != facts["airy_radius"]  # the aperture is not a uniform full disc
    narrow_peak = fwhm is not None and diameter_80 is not None and diameter_80 > _NARROW_PEAK * fwhm
    label_80, rays = "80 % of the light", 2.0 * facts["geometric_radius"]
    if any(term["m"] for term in facts["zernike"]):
        label_80 += ", about the centroid"
    rows = [
        ("FWHM" + (" of the central peak" if narrow_peak else ""), fwhm),
        ("FWHM with the pixel", facts["fwhm_with_pixel"]),
        (label_80, diameter_80),
        (f"{label_80}{',' if 'about' in label_80 else ''} with the pixel", facts["diameter_80_with_pixel"]),
        ("circle of confusion (defocus alone)", facts["circle_of_confusion"] or None),
        ("geometric blur (all rays)", None if math.isclose(rays, facts["circle_of_confusion"]) else rays),
        (f"ideal {'clear aperture' if unlike_airy else 'lens'}: Airy disc", 2.0 * facts["airy_radius"]),
        ("ideal obscured aperture: first dark ring", 2.0 * ring if unlike_airy and ring else None),
    ]
    units = {"um": 1e-6, "pixels": pixel}
    if facts["arcsec_per_pixel"]:
        units["arcsec"] = pixel / facts["arcsec_per_pixel"]
    if facts["pixel_in_object"]:
        units["nm in the sample"] = 1e-9 * pixel / facts["pixel_in_object"]
    cells = [(name, *(number(value / unit) for unit in units.values())) for name, value in rows if value is not None]
    return table_of(("diameter", *units), cells)


def _wavefront_parts(facts: Facts) -> Parts:
    """Return the tables of the wavefront and of the model."""
    rms, untilted, best = facts["rms_waves"], facts["rms_waves_without_tilt"], facts["balancing_W020"]
    area = "over the clear aperture" if facts["clear_area"] < 1.0 - 1e-9 else "over the pupil"
    without_tilt = ""
    if untilted is not None and rms - untilted > 5e-5 * rms:
        without_tilt = f" ({number(untilted)} without tilt)"
    higher_terms, of_distances, note = facts["higher"], facts["defocus_of_distances"], ""
    if not math.isclose(of_distances, facts["defocus"], rel_tol=1e-6, abs_tol=1e-9):
        note = f"; by distances alone {of_distances:.4g} rad (W020 = {of_distances / math.pi:.4g})"
    terms = [f"{name} = {value:.4g}" for name, value in facts["waves"].items()]
    if len(terms) > 4:
        terms[2:] = [f"... ({len(terms)} terms; see --json)"]
    lines = [
        ("rms wavefront error", None if rms is None else f"{number(rms)} waves {area}{without_tilt}"),
        ("defocus C_d", f"{facts['defocus']:.4g} rad{note}"),
        ("spherical C_s", f"{facts['spherical']:.4g} rad"),
        *[(f"rho^{6 + 2 * k}", f"{c:.4g} rad") for k, c in enumerate(higher_terms if len(higher_terms) < 4 else [])],
        ("in waves at the edge", ", ".join(terms)),
        (
            "least rms would be at",
            None if best is None else f"W020 = {best:.4g}, which balances the other terms",
        ),
    ]
    zernike = [zernike_table(facts)] if any(term["m"] for term in facts["zernike"]) else []
    models = [
        ("model", _model(facts)),
        ("amplitude", None if facts["apodization"] == 0.0 else _amplitude(facts)),
        ("lambda*N", format_length(facts["wavelength"] * facts["working_f_number"])),
        ("other model", None if _identical(facts["other_model"]) else model_in_words(facts["other_model"])),
    ]
    model = [list_of(models, title="Model"), *refusal_lines(facts)]
    return ["", *paragraphs([list_of(lines, title="Wavefront")], zernike, model)]


def distinct(*distances: float | None) -> list[str]:
    """Return lengths as texts with enough digits that different lengths have different texts; None means infinity."""
    for digits in range(4, 13):
        texts = [format_length(math.inf if d is None else d, digits=digits) for d in distances]
        if len(set(texts)) == len(set(distances)):
            break
    return texts


def _amplitude(facts: Facts) -> str:
    """Return the amplitude across the pupil in words."""
    kind = facts["apodization"]
    name = "cos(theta)^(-1/2)" if kind == "aplanatic" else "exponential of a polynomial in rho^2"
    if isinstance(kind, float):
        name = f"Gaussian, exp(-{kind:.4g} rho^2)"
    return f"{name}: {facts['rim_amplitude']:.4g} at the edge of the pupil"


def _model(facts: Facts) -> str:
    return f"aplanatic, corrected for the {facts['corrected_for']}" if facts["model"] == "aplanatic" else "paraxial"


def model_in_words(comparison: Facts) -> str:
    """Return a text on the other model of the lens (paraxial or aplanatic) and the difference of the two PSFs."""
    if comparison["reason"] is not None:
        return f"{comparison['model']}: {comparison['reason']}"
    if _identical(comparison):
        return f"{_model(comparison)}: identical"
    model, difference = _model(comparison).replace(", corrected", ""), comparison["peak_error"]
    return f"{model}: PSF differs by {difference:.2g} of the peak"


def _identical(comparison: Facts) -> bool:
    """Return True if the PSFs of both models differ by less than their tolerance, 1e-6 of the peak."""
    return comparison["reason"] is None and bool(comparison["peak_error"] < 1e-6)


def _aperture(facts: Facts) -> list[tuple[str, str]]:
    """Return rows on spider, vignetting, mask, stop and clear area of the aperture; no rows for a full disc."""
    spider, vignetting, mask, stop = (facts["aperture"][name] for name in ("spider", "vignetting", "mask", "stop"))
    rows = []
    if stop is not None:
        kinds = [f"{count} {kind[:-1] if count == 1 else kind}" for kind, count in stop["parts"].items() if count]
        phases = f", pistons {number(stop['piston_rms_waves'])} waves rms" if stop["piston_rms_waves"] else ""
        rows += [("segments", f"{stop['segments']}{phases}")] if stop["segments"] else []
        rows += [("aperture", f"within the rim, made of {', '.join(kinds)}")] if kinds else []
    if spider is not None:
        angles = ", ".join(f"{math.degrees(angle):.4g}" for angle in spider["angles"])
        width = format_length(spider["width"] * 0.5 * facts["aperture_diameter"])
        rows.append(("vanes", f"{width} wide, at {angles} degrees from x towards y"))
    if vignetting is not None and vignetting["name"] == "Ellipse":
        angle = math.degrees(vignetting["angle"])
        rows.append(("ellipse", f"{vignetting['a']:.4g} x {vignetting['b']:.4g} radii, at {angle:.4g} degrees"))
    elif vignetting is not None:
        x, y = vignetting["shift"]
        rows.append(("cat's eye", f"a circle of {vignetting['radius']:.4g} radii around ({x:.4g}, {y:.4g})"))
    if mask is not None:
        rows.append(("mask", f"{mask['side']} x {mask['side']} samples"))
    return [*rows, ("clear area", f"{percent(facts['clear_area'], 2)} of the full aperture")] if rows else []


def _field_parts(field: Facts) -> Parts:
    """Return the table of image quality at several image heights."""
    seidel = ", ".join(f"{name} = {waves:.4g}" for name, waves in field["seidel"].items())
    if seidel:
        seidel = f": {seidel} waves at an image height of {format_length(field['reach'])}"
    rows = []
    for place in field["places"]:
        largest_terms = sorted(place["zernike"], key=lambda term: -abs(term["waves_rms"]))[:2]
        terms = ", ".join(f"{term['name']} {term['waves_rms']:+.2g}" for term in largest_terms if term["waves_rms"])
        quality = (known(place[name], ".4g") for name in ("strehl_at_peak", "rms_waves_without_tilt"))
        rows.append((format_length(place["distance"], like=field["reach"]), *quality, terms))
    names = ("image height", "Strehl ratio", "rms (waves)", "largest Zernike terms (waves rms)")
    note = (
        "along a diagonal of the sensor, without tilt, which only shifts the image; all other values are on the axis"
    )
    return ["", table_of(names, rows, left_column=3, title=f"Field{seidel}"), Wrapped(note, "dim")]


def zernike_table(facts: Facts) -> Table:
    """Return the table of the Zernike coefficients, waves rms at the wavelength of the lens."""
    rows = [(t["name"], f"({t['n']}, {t['m']})", f"{t['waves_rms']:+.4g}") for t in facts["zernike"]]
    return table_of(("Zernike term", "(n, m)", f"waves rms at {format_length(facts['wavelength'])}, full disc"), rows)


def describe_microscope(microscope: Microscope, *, foci: bool = True) -> Report:
    """Return the report of a microscope, and with `foci` the focus of a freely rotating dipole at several depths."""
    facts = microscope_quality(microscope, foci=foci)
    tables: Parts = ["", zernike_table(facts)] if facts["zernike"] else []
    return Report(facts, [*_microscope_parts(facts), *tables, *(_focus_parts(facts) if facts["focus"] else ())])


def _microscope_parts(facts: Facts) -> Parts:
    """Return the table of a microscope, and a warning if the pixel or the step is coarser than Nyquist sampling."""
    nyquist, design = facts["nyquist"], facts["design"]
    if design is not None:
        design = f"immersion {design['immersion']:g}, cover glass {_layer_in_words(design['coverslip']) or 'none'}"
    rim = f"pupil edge at {math.degrees(facts['rim_angle']):.1f} deg in the immersion"
    critical = "none, all light of the pupil passes through the sample"
    if facts["critical_angle"] is not None:
        critical = f"{math.degrees(facts['critical_angle']):.1f} deg"
    planes_text = (
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
        ("planes", f"{planes_text} {_ORIGINS[facts['origin']]}"),
        ("pixel", f"{format_length(facts['pixel'])}, {format_length(facts['pixel_in_sample'])} in the sample"),
        ("camera", camera_in_words(facts)),
        ("Nyquist sampling", f"pixel of at most {format_length(nyquist['pixel'])}, "
         f"{format_length(nyquist['lateral'])} in the sample"),
        ("", f"planes at most {format_length(nyquist['axial'])} apart"),
    ]  # fmt: skip
    warnings = [
        Text(
            f"The {name}, {format_length(facts[name])}, is coarser than Nyquist sampling, "
            f"{format_length(nyquist['axial' if name == 'step' else 'pixel'])}: images lose their finest detail. "
            "The PSF itself is not affected."
        )
        for name in facts["too_coarse"]
    ]
    return [Text(facts["name"], "bold"), list_of(lines), *warnings]


_ORIGINS = {
    "brightest": "the brightest focus",
    "paraxial": "the paraxial focus",
    "coverslip": "the surface of the cover glass",
}


def _layer_in_words(layer: dict[str, float] | None) -> str:
    """Return thickness and index of a layer as a text, "" for None."""
    return "" if layer is None else f"{format_length(layer['thickness'])} of index {layer['index']:g}"


def _focus_parts(facts: Facts) -> Parts:
    """Return the table of the focus of emitters at several depths."""
    names = ["depth\num", "paraxial\num", "best\num", "depth /\nbest", "axial\nFWHM nm", "lateral\nFWHM nm"]
    rows = [
        (
            f"{1e6 * row['depth']:.4g}",
            *(f"{1e6 * row[name]:.3f}" for name in ("paraxial", "brightest")),
            known(row["ratio"], ".3f"),
            *(f"{1e9 * row[name]:.0f}" for name in ("axial_fwhm", "lateral_fwhm")),
            *(known(row[name], ".3f") for name in ("peak", "peak_of_surface", "collected")),
        )
        for row in facts["focus"]
    ]
    names += ["peak", "peak /\nat 0 um", "collected\nlight"]
    table = table_of(
        names,
        rows,
        left_column=-1,
        title="Focus of a freely rotating dipole" + ", with the aberrations" * bool(facts["zernike"]),
    )
    for column in table.columns:
        column.overflow = "fold"  # other settings cut off digits
    note = (
        "paraxial, best: stage travel to the paraxial and to the brightest focus, from the paraxial focus on the "
        "cover glass; FWHM: of the optics, without pixel, along the stage and in the sample; peak: intensity at the "
        "best focus relative to an ideal lens of scalar theory; collected light: relative to an emitter far from the "
        "glass, above 1 where supercritical light is collected"
    )
    return ["", table, Wrapped(note, "dim"), *refusal_lines(facts)]


def camera_in_words(facts: Facts) -> str | None:
    """Return the name and the noise parameters of the camera as a text, None without a camera."""
    if (camera := facts["camera"]) is None:
        return None
    units = {"read": "read noise {:g} electrons", "full_well": "full well {:g}", "gain": "{:g} electrons per count"}
    texts = [text.format(camera[name]) for name, text in units.items() if camera[name]]
    texts += [f"excess noise {camera['excess']:g}"] if camera["excess"] > 1.0 else []
    return ", ".join([camera["name"], *texts])


def lens_facts(lenses: list[Lens]) -> tuple[Facts, str]:
    """Return focus distances and f-numbers of several frames as facts and as a text."""
    facts = {
        "focus_distances": [finite(lens.focus_distance) for lens in lenses],
        "f_numbers": [lens.f_number for lens in lenses],
        "focal_length": lenses[0].focal_length,
    }
    frames = (f"{format_length(lens.focus_distance)} at f/{lens.f_number:.3g}" for lens in lenses)
    return facts, f"focus {', '.join(frames)}"


def describe_psf(answer: PSF, seconds: float) -> Report:
    """Return the report of a PSF.

    If the window holds less than 95 % of the light, "wide_enough" is the side, in pixels, of a window for about 98 %.
    """
    energy, side = float(answer.energy), wide_enough(lens_pupil(answer.pupil), min(answer.grid.pitch))
    is_wide_enough = energy >= 0.95 or min(answer.shape) >= side
    facts = how_made(answer, seconds) | {"wide_enough": None if is_wide_enough else side, "energy": energy}
    # Print only the significant digits of the peak, according to its error bound.
    digits = min(4, max(1, math.floor(-math.log10(answer.error_bound)))) if answer.error_bound else 4
    pixels = f"{SAMPLING[answer.sampling]}, {facts['pixel_over_lambda_N']:.3g} lambda*N wide"
    parts = _psf_parts(answer, facts, pixels, f"{facts['peak']:.{digits}g}", percent(energy, 2))
    notes = []
    if facts["sum"] is not None:
        notes.append(
            f"The sum of the values, {facts['sum']:.4g}, is not the light in the window, because point samples are "
            "more than lambda*N apart; with integrate = true in the lens file values are pixel-integrated."
        )
    if not is_wide_enough:
        notes.append(f"The window holds {percent(energy)} of the light; --shape {side} would hold about 98 %.")
    return Report({"psf": facts}, [*parts, *map(Wrapped, notes)])


def _psf_parts(answer: PSF, facts: Facts, pixels: str, peak: str, energy: str) -> Parts:
    """Return the table of a PSF or of a stack of PSFs."""
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
    # "sum" is None if the sum of the values is the light in the window: see `how_made`.
    (rows, columns, height, width), sums = facts["shape"], facts["sum"]
    ends = "" if sums is None else f"{np.min(sums):.4g} to {np.max(sums):.4g}"
    lines = [
        ("sensor", f"{format_length(sensor[0])} x {format_length(sensor[1])} (height x width)"),
        ("method", repr(answer.method)),
        ("values", f"{rows} x {columns} PSFs of {height} x {width} {facts['dtype']}, {MEANING[answer.normalize]}"),
        ("pixel", f"{pitch_in_words(answer.pixel)}, {SAMPLING[answer.sampling]}"),
        ("sums of the values", f"{ends}: point samples this far apart miss some of the light" if ends else None),
        ("energy in the window", f"{percent(energy.min(), 2)} to {percent(energy.max(), 2)}"),
        *_error_and_time(facts),
    ]
    parts: Parts = [Text(instrument.name, "bold"), list_of(lines)]
    if energy.min() < 0.95:
        parts.append(
            Text(f"One window holds only {percent(energy.min())} of the light; a larger --shape holds more.")
        )
    column_names, row_names = (
        [format_length(position, like=max(sensor)) for position in facts[axis]] for axis in ("x", "y")
    )
    peaks = [(y, *(f"{value:.4g}" for value in row)) for y, row in zip(row_names, facts["peak"], strict=True)]
    title = "Largest value at y (down) and x (across)"
    table = table_of(("", *column_names), peaks, left_column=-1, no_wrap=True, title=title)
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
    spectra = f"error at most {facts['of_spectra']:.2g} of the unaberrated peak" if facts["of_spectra"] else None
    bound_row, time_row = _error_and_time(facts, " of a channel")
    lines = [
        ("values", _values(facts)),
        ("pixel", f"{format_length(facts['pixel'])}, {SAMPLING[facts['sampling']]}"),
        bound_row,
        ("spectral sampling", spectra),
        time_row,
    ]
    rows = []
    for channel in channels:
        waves = channel["wavelengths"]
        range_text = " to ".join(dict.fromkeys(format_length(end) for end in (min(waves), max(waves))))
        range_text = range_text if len(waves) == 1 else f"{len(waves)} from {range_text}"
        light, peak, energy = f"{channel['light']:.3g}", f"{channel['peak']:.4g}", percent(channel["energy"], 2)
        rows.append((channel["name"], range_text, light, peak, energy))
    table = table_of(("channel", "wavelengths", "light", "largest value", "sum of values"), rows)
    return Report(facts, [Text(instrument.name, "bold"), list_of(lines), "", table])


def _values(facts: Facts) -> str:
    """Return shape, type and normalisation of the values as a text."""
    return f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"


def _error_and_time(facts: Facts, channel: str = "") -> list[tuple[str, str]]:
    """Return the rows of the error bound, relative to the peak, and of the time; `channel` is added after "peak"."""
    bound = "none proven"
    if facts["error_bound"] is not None:
        bound = f"each value within {facts['error_bound']:.2g} of the peak{channel}"
    return [("error bound", bound), ("time", f"{1e3 * facts['seconds']:.1f} ms, the first call")]


def describe_mtf(instrument: Instrument, places: Sequence[Place], channels: Channels | None = None) -> Report:
    """Return the report of the MTF, pixel included, at the Nyquist frequency and at half the Nyquist frequency.

    There is one row for each combination of `places` in the field and `channels` (without channels, the wavelength of
    the file). Directions are sagittal and tangential, or x and y if the file has no field aberrations.
    """
    facts = sensor_mtf(instrument, places, channels)
    over_field = places[0][0] is not None
    heads = [
        name for name, is_shown in (("position x, y", over_field), ("channel", channels is not None)) if is_shown
    ]
    cells, frequencies = [], facts["frequency"]
    for row in facts["rows"]:
        place = ", ".join(format_length(row[axis] or 0.0, like=1e-3) for axis in ("x", "y"))
        labels = [place if head != "channel" else row["channel"] for head in heads]
        pairs = [row["nyquist"], row["half_nyquist"]]  # along x and y
        if "sagittal" in row:
            pairs = list(zip(row["sagittal"], row["tangential"], strict=True))
        # The MTF is exactly 0 from the cutoff of the lens on.
        cells.append([*labels, *(f"{value:.4f}" if value else "0" for pair in pairs for value in pair)])
    first, second = ("S", "T") if over_field else ("x", "y")
    names = (*heads, f"{first}, Nyquist", f"{second}, Nyquist", f"{first}, half", f"{second}, half")
    table = table_of(names, cells, left_column=0 if heads else -1, title="MTF, pixel included")
    x, y = map(per_mm, frequencies)
    nyquist = x if x == y else f"{x} along x and {y} along y"
    lines = "S sagittal: radial lines; T tangential: tangential lines" if over_field else "x: vertical lines"
    notes = [f"Nyquist frequency: {nyquist}; {lines}"]
    if max(frequencies) > (cutoff := max(pupil.cutoff for _, _, pupil in places)):
        wavelength = format_length(instrument.lens.wavelength)
        channel_note = "" if channels is None else ", higher at shorter wavelengths"
        notes.append(f"0: the lens passes nothing above its cutoff, {per_mm(cutoff)} at {wavelength}{channel_note}")
    return Report({"mtf": facts}, ["", table, *(Text(note, "dim") for note in notes)])


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
    peak, energies = f"{np.max(facts['peak']):.4g}", percent(energy.min(), 2)
    if pupil.shape:
        brightest = int(np.argmax(facts["peak"]))
        ends = (format_length(float(positions[brightest]), like=1e-6) for positions in (pupil.z, pupil.focus))
        peak += " in plane {}, z = {}, stage at {}".format(brightest, *ends)
        energies += f" to {percent(energy.max(), 2)}, by plane"
    facts |= {
        "pixel_in_sample": answer.pixel / pupil.magnification,
        "z": pupil.z.tolist(),
        "focus": pupil.focus.tolist(),
        "energy": energy.tolist(),
        "brightest": brightest,
    }
    pixels = f"{format_length(facts['pixel_in_sample'])} in the sample, {SAMPLING[answer.sampling]}"
    return Report({"psf": facts}, _psf_parts(answer, facts, pixels, peak, energies))
