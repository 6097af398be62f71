"""The report of ``lommel info`` on a lens: sharpness, wavefront, model, and what its field of science measures by."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rich.text import Text

from lommel.base.plain import plain
from lommel.base.units import format_length, known, number, per_mm, pitch_in_words, strehl_ratio
from lommel.cli.instruments import camera_in_words
from lommel.cli.output import Facts, Report, Wrapped, list_of, paragraphs, refused, table_of
from lommel.lensfiles.image_quality import IN_FOCUS, ImageQuality

if TYPE_CHECKING:
    from rich.console import RenderableType
    from rich.table import Table

    from lommel.lensfiles.instrument import Instrument

# An image whose circle of 80 % of the light is so many times its FWHM has a bright centre within a wide blur.
_SPIKE = 4.0


def summarize_lens(instrument: Instrument) -> Report:
    """Return the description of a lens, its object and its sensor, without measures of its images, in one line."""
    facts = ImageQuality(instrument).setup() | {"camera": plain(instrument.camera)}
    focused, seen = distinct(facts["focus_distance"], facts["object_distance"])
    lens = instrument.lens
    line = (
        f"f = {format_length(lens.focal_length)}, f/{lens.f_number:.3g}, {format_length(lens.wavelength)}; "
        f"focus {focused}, object {seen}; `lommel info` has its image quality"
    )
    return Report(facts, [Text(instrument.name, "bold"), Wrapped(line)])


def describe_lens(instrument: Instrument) -> Report:
    """Return the report of a lens and its object; the facts are those of :class:`lommel.ImageQuality`."""
    facts = ImageQuality(instrument).to_dict() | {"camera": plain(instrument.camera)}
    first = Text(instrument.name, "bold"), _setup(facts)
    return Report(facts, [*first, *_image_parts(facts, instrument.pitch), *_wavefront_parts(facts)])


def _setup(facts: Facts) -> Table:
    """Return the table of lens, object and sensor."""
    focused, seen = distinct(facts["focus_distance"], facts["object_distance"])
    obscured = f", obscuration {facts['obscuration']:.3g}" if facts["obscuration"] else ""
    pixel, sharp, hyperfocal = pitch_in_words(facts["pixel"]), facts["in_focus"], facts["hyperfocal_distance"]
    if facts["arcsec_per_pixel"]:
        pixel += f", {number(facts['arcsec_per_pixel'])} arcsec"
    if facts["pixel_in_object"]:
        pixel += f", {format_length(facts['pixel_in_object'])} in the sample"
    if sharp is not None:
        ends = " to ".join(distinct(sharp["near"], sharp["far"]))
        sharp = f"{ends} (circle of confusion up to {IN_FOCUS:g} pixels)"
    lens = f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
    rows = [
        ("lens", f"{lens} (working f/{facts['working_f_number']:.4g}){obscured}"),
        *_aperture(facts),
        ("wavelength", format_length(facts["wavelength"])),
        ("focus distance", focused),
        ("object distance", seen),
        ("depth of field", sharp),
        ("hyperfocal distance", hyperfocal and f"{format_length(hyperfocal)} (same circle)"),
        ("pixel", pixel),
        ("camera", camera_in_words(facts)),
    ]
    return list_of(rows)


def _image_parts(facts: Facts, pitch: tuple[float, float]) -> list[RenderableType]:
    """Return the tables of the image of a point."""
    on_axis, top, bound = facts["strehl"], facts["strehl_at_peak"], facts["encircled_energy_error"]
    strehl = strehl_ratio(on_axis)
    if top is not None and on_axis is not None and top > 1.005 * on_axis:
        strehl += f" on the axis, {strehl_ratio(top)} at the brightest point"
    lines = [
        ("Strehl ratio", strehl),
        ("Marechal's estimate", strehl_ratio(facts["marechal"]) if (facts["marechal"] or 0.0) >= 0.3 else None),
        *_mtf_rows(facts),
    ]
    energies = [
        (row["within"], format_length(row["radius"]), known(row["fraction"], ".1%"), known(row["unaberrated"], ".1%"))
        for row in facts["encircled_energy"]
    ]
    names, title = ("within", "radius", "this lens", "unaberrated"), "Encircled energy about the axis, optics alone"
    parts: list[RenderableType] = ["", list_of(lines, title="Image of a point"), "", _diameters(facts, pitch[1])]
    parts += ["", table_of(names, energies, title=title)]
    if bound is not None:
        parts.append(Text(f"error of these fractions at most {bound:.1g}", "dim"))
    elif any(facts["aperture"].values()):
        parts.append(Text("no proven error bound for this aperture", "dim"))
    return parts if facts["field"] is None else [*parts, *_field_parts(facts["field"])]


def _mtf_rows(facts: Facts) -> list[tuple[str, str | None]]:
    """Return the rows of the MTF, for x and y where these differ."""

    def along(end: str) -> list[tuple[str, str | None]]:
        kinds = ("mtf_at_nyquist_with_pixel", "mtf_at_nyquist", "mtf50", "nyquist")
        with_pixel, alone, half, nyquist = (facts[kind + end] for kind in kinds)
        mtf = None
        if alone is not None and nyquist < facts["cutoff"]:
            mtf = f"{with_pixel:.4f} with the pixel, {alone:.4f} without, at {per_mm(nyquist)}"
        mtf50 = half and f"{per_mm(half)}, optics alone (cutoff {per_mm(facts['cutoff'])})"
        return [("MTF at Nyquist", mtf), ("MTF50", mtf50)]

    x, y = along(""), along("_y")
    pairs = zip(x, y, strict=True)
    return (
        x
        if x == y
        else [(f"{name}, {axis}", text) for pair in pairs for axis, (name, text) in zip("xy", pair, strict=True)]
    )


def _diameters(facts: Facts, pixel: float) -> RenderableType:
    """Return the table of the diameters of the blur, in the units of the field of the lens."""
    fwhm, circle, ring = facts["fwhm"], facts["diameter_80"], facts["dark_ring_radius"]
    cut = ring != facts["airy_radius"]
    centre = fwhm is not None and circle is not None and circle > _SPIKE * fwhm
    whole, rays = "80 % of the light", 2.0 * facts["geometric_radius"]
    if any(term["m"] for term in facts["zernike"]):
        whole += ", about the centroid"
    rows = [
        ("FWHM" + (" of the central peak" if centre else ""), fwhm),
        ("FWHM with the pixel", facts["fwhm_with_pixel"]),
        (whole, circle),
        (f"{whole}{',' if 'about' in whole else ''} with the pixel", facts["diameter_80_with_pixel"]),
        ("Airy disc" + (" of a clear aperture" if cut else " (first dark ring)"), 2.0 * facts["airy_radius"]),
        ("first dark ring without aberrations", 2.0 * ring if cut and ring else None),
        ("circle of confusion (defocus alone)", facts["circle_of_confusion"] or None),
        ("all rays, with the aberrations", None if math.isclose(rays, facts["circle_of_confusion"]) else rays),
    ]
    units = {"um": 1e-6, "pixels": pixel}
    if facts["arcsec_per_pixel"]:
        units["arcsec"] = pixel / facts["arcsec_per_pixel"]
    if facts["pixel_in_object"]:
        units["nm in the sample"] = 1e-9 * pixel / facts["pixel_in_object"]
    cells = [(name, *(number(value / unit) for unit in units.values())) for name, value in rows if value is not None]
    return table_of(("diameter", *units), cells)


def _wavefront_parts(facts: Facts) -> list[RenderableType]:
    """Return the tables of the wavefront and of the model."""
    rms, level, best = facts["rms_waves"], facts["rms_waves_without_tilt"], facts["balancing_W020"]
    where = "over the clear aperture" if facts["clear_area"] < 1.0 - 1e-9 else "over the pupil"
    tilted = f" ({number(level)} without tilt)" if level is not None and rms - level > 5e-5 * rms else ""
    higher, distances, shares = facts["higher"], facts["defocus_of_distances"], ""
    if not math.isclose(distances, facts["defocus"], rel_tol=1e-6, abs_tol=1e-9):
        shares = f"; by distances alone {distances:.4g} rad (W020 = {distances / math.pi:.4g})"
    listed = [f"{name} = {value:.4g}" for name, value in facts["waves"].items()]
    if len(listed) > 4:
        listed[2:] = [f"... ({len(listed)} terms; see --json)"]
    lines = [
        ("rms wavefront error", None if rms is None else f"{number(rms)} waves {where}{tilted}"),
        ("defocus C_d", f"{facts['defocus']:.4g} rad{shares}"),
        ("spherical C_s", f"{facts['spherical']:.4g} rad"),
        *[(f"rho^{6 + 2 * k}", f"{c:.4g} rad") for k, c in enumerate(higher if len(higher) < 4 else [])],
        ("in waves at the edge", ", ".join(listed)),
        ("least rms would be at", None if best is None else f"W020 = {best:.4g}, which balances the other terms"),
    ]
    tables = [list_of(lines, title="Wavefront")]
    if any(term["m"] for term in facts["zernike"]):
        tables.append(zernike_table(facts))
    models = [
        ("model", _model(facts)),
        ("amplitude", None if facts["apodization"] == 0.0 else _amplitude(facts)),
        ("lambda*N", format_length(facts["wavelength"] * facts["working_f_number"])),
        ("other model", None if _identical(facts["other_model"]) else model_in_words(facts["other_model"])),
    ]
    return ["", *paragraphs(*([table] for table in tables), [list_of(models, title="Model"), *refused(facts)])]


def distinct(*distances: float | None) -> list[str]:
    """Return lengths with enough digits for different ones to look different."""
    for digits in range(4, 13):
        texts = [format_length(math.inf if d is None else d, digits=digits) for d in distances]
        if len(set(texts)) == len(set(distances)):
            break
    return texts


def _amplitude(facts: Facts) -> str:
    kind = facts["apodization"]
    name = "cos(theta)^(-1/2)" if kind == "aplanatic" else "exponential of a polynomial in rho^2"
    if isinstance(kind, float):
        name = f"Gaussian, exp(-{kind:.4g} rho^2)"
    return f"{name}: {facts['rim_amplitude']:.4g} at the edge of the pupil"


def _model(facts: Facts) -> str:
    return f"aplanatic, corrected for the {facts['corrected_for']}" if facts["model"] == "aplanatic" else "paraxial"


def model_in_words(other: Facts) -> str:
    """Return the difference of the paraxial and the aplanatic model in one line."""
    if other["reason"] is not None:
        return f"{other['model']}: {other['reason']}"
    if _identical(other):
        return f"{_model(other)}: identical"
    model = _model(other).replace(", corrected", "")
    return f"{model}: PSF differs by {other['peak_error']:.2g} of the peak"


def _identical(other: Facts) -> bool:
    """Return whether the other model makes the same PSF within the tolerance of both, 1e-6."""
    return other["reason"] is None and bool(other["peak_error"] < 1e-6)


def _aperture(facts: Facts) -> list[tuple[str, str]]:
    """Return rows for the spider, the vignetting, the mask and the stop, if there are any."""
    spider, edge, mask, stop = (facts["aperture"][name] for name in ("spider", "vignetting", "mask", "stop"))
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
    if edge is not None and edge["name"] == "Ellipse":
        angle = math.degrees(edge["angle"])
        rows.append(("ellipse", f"{edge['a']:.4g} x {edge['b']:.4g} radii, at {angle:.4g} degrees"))
    elif edge is not None:
        x, y = edge["shift"]
        rows.append(("cat's eye", f"a circle of {edge['radius']:.4g} radii around ({x:.4g}, {y:.4g})"))
    if mask is not None:
        rows.append(("mask", f"{mask['side']} x {mask['side']} samples"))
    return [*rows, ("clear area", f"{facts['clear_area']:.2%} of the full aperture")] if rows else []


def _field_parts(field: Facts) -> list[RenderableType]:
    """Return the table of the field."""
    seidel = ", ".join(f"{name} = {waves:.4g}" for name, waves in field["seidel"].items())
    if seidel:
        seidel = f": {seidel} waves at an image height of {format_length(field['reach'])}"
    rows = []
    for place in field["places"]:
        largest = sorted(place["zernike"], key=lambda term: -abs(term["waves_rms"]))[:2]
        terms = ", ".join(f"{term['name']} {term['waves_rms']:+.2g}" for term in largest if term["waves_rms"])
        quality = (known(place[name], ".4g") for name in ("strehl_at_peak", "rms_waves_without_tilt"))
        rows.append((format_length(place["distance"], like=field["reach"]), *quality, terms))
    names = ("image height", "Strehl ratio", "rms (waves)", "largest Zernike terms (waves rms)")
    note = (
        "along a diagonal of the sensor, without tilt, which only shifts the image; all other values are on the axis"
    )
    return ["", table_of(names, rows, left=3, title=f"Field{seidel}"), Wrapped(note, "dim")]


def zernike_table(facts: Facts) -> Table:
    """Return the table of the Zernike terms at a wavelength."""
    rows = [(t["name"], f"({t['n']}, {t['m']})", f"{t['waves_rms']:+.4g}") for t in facts["zernike"]]
    return table_of(("Zernike term", "(n, m)", f"waves rms at {format_length(facts['wavelength'])}, full disc"), rows)
