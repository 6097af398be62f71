"""The report of ``lommel info`` on a lens: sharpness, wavefront, model, and what its field of science measures by."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.text import Text

from lommel.base.units import format_length
from lommel.cli.instruments import camera_facts, camera_in_words
from lommel.cli.output import (
    Facts,
    Report,
    Wrapped,
    known,
    list_of,
    number,
    per_mm,
    pitch_in_words,
    refused,
    strehl_ratio,
    table_of,
)
from lommel.core.answers import ToleranceError
from lommel.lensfiles.instrument import Instrument
from lommel.measures import aperture_means, errors, spot, transfer
from lommel.measures.energy import MAX_RADIUS, encircled, optics
from lommel.methods.choice import of_profiles
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.aperture.shapes import CatEye, Disc, Ellipse, Polygon, Segments, Shape
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf
from lommel.special import zernike

if TYPE_CHECKING:
    from rich.console import RenderableType
    from rich.table import Table

_OF_LENS = ("focal_length", "aperture_diameter", "f_number", "working_f_number", "obscuration", "wavelength",
            "model", "corrected_for")  # fmt: skip

IN_FOCUS = 2.0
"""Largest circle of confusion of what counts as in focus, in pixels."""

_ARCSEC = math.pi / 648000.0
_SHARE = 0.8
# Pixels change diameters of more pixels than this by less than their last digit, at the cost of seconds.
_WIDE = 60.0
# An image whose circle of 80 % of the light is so many times its FWHM has a bright centre within a wide blur.
_SPIKE = 4.0
# Mirrors of more segments have an MTF50 that takes longer than all the rest.
_MANY = 24


def introduce_lens(instrument: Instrument) -> Report:
    """Return the description of a lens, its object and its sensor, without measures of its images."""
    lens = instrument.lens
    focal, height, width = lens.focal_length, *instrument.pitch
    telescope = math.isinf(lens.focus_distance) and math.isinf(instrument.object_distance)
    near, far, hyperfocal = _depth_of_field(instrument)
    sharp = {"near": near, "far": _finite(far), "blur": IN_FOCUS * max(height, width)}
    facts = {
        "name": instrument.name,
        "source": instrument.source,
        **{name: getattr(lens, name) for name in _OF_LENS},
        "apodization": light.to_dict() if isinstance(light := lens.apodization, Apodization) else light,
        "focus_distance": _finite(lens.focus_distance),
        "sensor_distance": lens.sensor_distance,
        "object_distance": _finite(instrument.object_distance),
        "pixel": instrument.pixel,
        "camera": camera_facts(instrument.camera),
        "arcsec_per_pixel": width / focal / _ARCSEC if telescope else None,
        "pixel_in_object": width * lens.focus_distance / lens.sensor_distance if magnifies(lens) else None,
        "in_focus": None if near is None else sharp,
        "hyperfocal_distance": hyperfocal,
        "aperture": {
            "spider": None if lens.spider is None else lens.spider.to_dict(),
            "vignetting": None if lens.vignetting is None else lens.vignetting.to_dict(),
            "mask": None if lens.mask is None else {"side": lens.mask.side},
            "stop": None if lens.stop is None else _stop(lens.stop),
        },
        "clear_area": instrument.pupil().area,
    }
    return Report(facts, [Text(instrument.name, "bold"), list_of(_setup(facts))])


def summarize_lens(instrument: Instrument) -> Report:
    """Return the same with one line for people."""
    setup = introduce_lens(instrument)
    focused, seen = distinct(setup.facts["focus_distance"], setup.facts["object_distance"])
    lens = instrument.lens
    line = (
        f"f = {format_length(lens.focal_length)}, f/{lens.f_number:.3g}, {format_length(lens.wavelength)}; "
        f"focus {focused}, object {seen}; `lommel info` has its image quality"
    )
    return Report(setup.facts, [setup.parts[0], Wrapped(line)])


def _depth_of_field(instrument: Instrument) -> tuple[float | None, float, float | None]:
    """Return the nearest and the farthest distance in focus and the hyperfocal distance; None for other fields.

    Geometric, of a lens without aberration: ``blur = D d abs(1/s - 1/s0)`` at the distance s, D being the aperture
    diameter, d the distance of the sensor and s0 the distance in focus.
    """
    lens, blur = instrument.lens, IN_FOCUS * max(instrument.pitch)
    diameter = lens.aperture_diameter
    # Of telescopes and microscopes nobody asks.
    if lens.focus_distance < 0.0 or magnifies(lens) or lens.obscuration or lens.focal_length > 1.0:
        return None, math.nan, None
    reach = blur / (diameter * lens.sensor_distance)
    near, far = 1.0 / lens.focus_distance + reach, 1.0 / lens.focus_distance - reach
    return 1.0 / near, 1.0 / far if far > 0.0 else math.inf, lens.focal_length * (1.0 + diameter / blur)


def _setup(facts: Facts) -> list[tuple[str, str | None]]:
    """Return the rows of lens, object and sensor."""
    focused, seen = distinct(facts["focus_distance"], facts["object_distance"])
    obscured = f", obscuration {facts['obscuration']:.3g}" if facts["obscuration"] else ""
    pixel, sharp = pitch_in_words(facts["pixel"]), facts["in_focus"]
    if facts["arcsec_per_pixel"]:
        pixel += f", {number(facts['arcsec_per_pixel'])} arcsec"
    if facts["pixel_in_object"]:
        pixel += f", {format_length(facts['pixel_in_object'])} in the sample"
    if sharp is not None:
        near, far = distinct(sharp["near"], sharp["far"])
        sharp = f"{near} to {far} (circle of confusion up to {IN_FOCUS:g} pixels)"
    hyperfocal = facts["hyperfocal_distance"]
    return [
        ("lens", f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}"
         f" (working f/{facts['working_f_number']:.4g}){obscured}"),
        *_aperture(facts),
        ("wavelength", format_length(facts["wavelength"])),
        ("focus distance", focused),
        ("object distance", seen),
        ("depth of field", sharp),
        ("hyperfocal distance", None if hyperfocal is None else f"{format_length(hyperfocal)} (same circle)"),
        ("pixel", pixel),
        ("camera", camera_in_words(facts)),
    ]  # fmt: skip


def describe_lens(instrument: Instrument) -> Report:
    """Return the report of a lens and its object; facts are None for infinity and for what cannot be computed.

    Lengths in metres, phases in radians, frequencies in cycles per metre, along x unless a name ends in "_y";
    "refused" has the reasons.
    """
    lens, pupil, setup = instrument.lens, instrument.pupil(), introduce_lens(instrument)
    radii = dict(instrument.radii)
    airy, blur = pupil.airy_radius, float(pupil.geometric_radius())
    radii.setdefault("Airy radius", airy)
    if blur > 0:
        radii.setdefault("radius of all rays", blur)
    reasons: dict[str, None] = {}
    at = list(radii.values())

    def tried(work: Callable[[], Any]) -> Any:
        try:
            return work()
        except (ValueError, ArithmeticError) as reason:
            reasons[str(reason)] = None
            return None

    nothing: list[None] = [None] * len(at)
    seen, error = tried(lambda: _energies(pupil, at)) or (nothing, None)
    ideal, other_error = tried(lambda: _energies(pupil.unaberrated(), at)) or (nothing, None)
    sensor: Facts = {"pixel": instrument.pixel, "fill": instrument.fill}
    plain = lens if lens.aberrations.flat else replace(lens, aberrations=Wavefront())
    across, down = (
        {
            f"mtf50{end}": tried(partial(_mtf50, pupil, angle)),
            f"nyquist{end}": nyquist,
            f"mtf_at_nyquist{end}": tried(partial(_mtf, pupil, nyquist, angle)),
            f"mtf_at_nyquist_with_pixel{end}": tried(partial(_mtf, pupil, nyquist, angle, **sensor)),
        }
        for end, angle, nyquist in (
            ("", 0.0, 0.5 / instrument.pitch[1]),
            ("_y", 0.5 * math.pi, 0.5 / instrument.pitch[0]),
        )
    )
    facts = setup.facts | {
        "rim_amplitude": float(np.divide(*lens.illumination.value([1.0, 0.0]))),
        "other_model": other_model(instrument),
        "defocus": float(pupil.wavefront.defocus),
        "defocus_of_distances": float(lens.defocus(instrument.object_distance)),
        "spherical": float(pupil.wavefront.spherical),
        "higher": [float(c) for c in pupil.wavefront.higher],
        "waves": {name: float(value) for name, value in pupil.wavefront.waves.items()},
        "balancing_W020": tried(lambda: _balancing(pupil)),
        "zernike": listed_terms(pupil.wavefront.to_zernike(unit="waves")),
        "airy_radius": airy,
        "dark_ring_radius": _dark_ring(pupil),
        "geometric_radius": blur,
        "circle_of_confusion": 2.0 * float(plain.pupil(instrument.object_distance).geometric_radius()),
        "strehl": tried(partial(_strehl, pupil)),
        "strehl_at_peak": tried(partial(_brightest, pupil)),
        "marechal": tried(lambda: float(aperture_means.marechal(pupil))),
        "rms_waves": tried(partial(_rms, pupil)),
        "rms_waves_without_tilt": tried(partial(_rms_without_tilt, pupil)),
        **_widths(instrument, pupil, tried),
        "cutoff": pupil.cutoff,
        **across,
        **down,
        "field": None if instrument.aberrations_of_field is None else _field(instrument, tried),
        "encircled_energy": [
            {"within": name, "radius": radius, "fraction": a, "unaberrated": b}
            for (name, radius), a, b in zip(radii.items(), seen, ideal, strict=True)
        ],
        "encircled_energy_error": max((e for e in (error, other_error) if e is not None), default=None),
        "refused": list(reasons),
    }
    return Report(facts, [*setup.parts, *_image_parts(facts, instrument.pitch), *_wavefront_parts(facts)])


def _mtf(pupil: Pupil, frequency: float, angle: float, **sensor: Any) -> float:
    """Return the MTF at a frequency in a direction, from x towards y."""
    return float(transfer.mtf(pupil, frequency * math.cos(angle), frequency * math.sin(angle), **sensor))


def _mtf50(pupil: Pupil, angle: float) -> float:
    segments = len(pupil.opening.regions)
    if segments > _MANY:
        raise ValueError(f"MTF50, which takes minutes for {segments} segments: lommel.mtf_frequency(pupil) has it")
    return float(transfer.mtf_frequency(pupil, angle=angle))


def _across(rho: Any, theta: Any) -> Any:
    return rho * np.cos(theta)


def _down(rho: Any, theta: Any) -> Any:
    return rho * np.sin(theta)


def _tilted(pupil: Pupil, x: float, y: float) -> Pupil:
    """Return a pupil with another tilt, radians at the edge of the pupil along x and y."""
    # A Zernike tilt is normalised to an rms of 1 over the disc: 2 at its edge.
    tilt = Wavefront.zernike({(1, 1): 0.5 * x, (1, -1): 0.5 * y})
    return replace(pupil, wavefront=pupil.wavefront + tilt, geometry=None)


def _level(pupil: Pupil) -> Pupil:
    """Return a pupil less the tilt without which the rms is least: its image is that of `pupil`, elsewhere."""
    return _tilted(pupil, *-aperture_means.least_squares(pupil, [_across, _down]))


def _strehl(pupil: Pupil) -> float:
    return float(aperture_means.strehl(pupil))


def _rms(pupil: Pupil) -> float:
    """Return the rms wavefront error in waves."""
    return float(aperture_means.rms(pupil, unit="waves"))


def _rms_without_tilt(pupil: Pupil) -> float:
    return _rms(_level(pupil))


def _balancing(pupil: Pupil) -> float | None:
    """Return the W020 (waves) that leaves the least rms beside the other terms; None where there are none."""
    if not (pupil.wavefront.spherical or any(pupil.wavefront.higher)):
        return None
    excess = aperture_means.least_squares(pupil, [lambda rho, _: rho**2, _across, _down])[0]
    return float(pupil.wavefront.waves["W020"] - excess / (2.0 * math.pi))


def _brightest(pupil: Pupil) -> float:
    """Return the Strehl ratio at the brightest point of the image."""
    if not pupil.radial:
        # Where the image is brightest is the axis of a wavefront with another tilt.
        x, y = spot.brightest_place(optics(pupil))
        return float(aperture_means.strehl(_tilted(pupil, -math.pi * x, -math.pi * y)))
    method, far = of_profiles(), float(pupil.v(pupil.geometric_radius())) + 4.0
    v = np.linspace(0.0, far, 64 + math.ceil(10.0 * far))
    best = v[np.argmax(method.profile(pupil, v).values[0])]
    near = np.abs(best + np.linspace(-v[1], v[1], 101))
    top = method.profile(pupil, np.append(0.0, near)).values.max()
    return float(top / method.unaberrated_peak(pupil))


def _widths(instrument: Instrument, pupil: Pupil, tried: Callable[[Callable[[], Any]], Any]) -> Facts:
    """Return FWHM and diameter of 80 % of the light, of the optics alone and, where that differs, with the pixel."""
    # One pixel, integrated: measures are of the continuous image.
    image: PSF | None = tried(lambda: psf(pupil, 1, instrument.pixel, integrate=True, fill=instrument.fill))
    if image is None:
        return {f"{name}{end}": None for name in ("fwhm", "diameter_80") for end in ("", "_with_pixel")}
    measures: dict[str, Callable[[str], float]] = {
        "fwhm": lambda of: float(spot.fwhm(image, of=of)),
        "diameter_80": lambda of: float(spot.energy_diameter(image, _SHARE, about="centroid", of=of)),
    }
    found: Facts = {name: tried(partial(measure, "optics")) for name, measure in measures.items()}
    for name, value in list(found.items()):
        wide = found["diameter_80"] or math.inf
        found[f"{name}_with_pixel"] = None
        if value is None or wide > _WIDE * min(instrument.pitch):
            continue
        found[f"{name}_with_pixel"] = tried(partial(measures[name], "image"))
    return found


def _image_parts(facts: Facts, pitch: tuple[float, float]) -> list[RenderableType]:
    """Return the tables of the image of a point."""
    on_axis, top = facts["strehl"], facts["strehl_at_peak"]
    strehl = strehl_ratio(on_axis)
    if top is not None and on_axis is not None and top > 1.005 * on_axis:
        strehl += f" on the axis, {strehl_ratio(top)} at the brightest point"
    lines = [
        ("Strehl ratio", strehl),
        ("Marechal's estimate", strehl_ratio(facts["marechal"]) if (facts["marechal"] or 0.0) >= 0.3 else None),
        *_mtf_rows(facts),
    ]  # fmt: skip
    energies = [
        (
            row["within"],
            format_length(row["radius"]),
            *(known(row[name], ".1%") for name in ("fraction", "unaberrated")),
        )
        for row in facts["encircled_energy"]
    ]
    names = ("within", "radius", "this lens", "unaberrated")
    parts: list[RenderableType] = ["", list_of(lines, title="Image of a point"), "", _diameters(facts, pitch[1])]
    parts += ["", table_of(names, energies, title="Encircled energy about the axis, optics alone")]
    if facts["encircled_energy_error"] is not None:
        parts.append(Text(f"error of these fractions at most {facts['encircled_energy_error']:.1g}", "dim"))
    elif any(facts["aperture"].values()):
        parts.append(Text("no proven error bound for this aperture", "dim"))
    if facts["field"] is not None:
        parts += _field_parts(facts["field"])
    return parts


def _mtf_rows(facts: Facts) -> list[tuple[str, str | None]]:
    """Return the rows of the MTF, for x and y where these differ."""
    kinds = ("mtf_at_nyquist_with_pixel", "mtf_at_nyquist", "mtf50")
    rows: dict[str, list[tuple[str, str | None]]] = {}
    for end in ("", "_y"):
        with_pixel, alone, half = (facts[kind + end] for kind in kinds)
        nyquist = facts[f"nyquist{end}"]
        resolved = alone is not None and nyquist < facts["cutoff"]
        rows[end] = [
            ("MTF at Nyquist", f"{with_pixel:.4f} with the pixel, {alone:.4f} without, at {per_mm(nyquist)}"
             if resolved else None),
            ("MTF50", f"{per_mm(half)}, optics alone (cutoff {per_mm(facts['cutoff'])})" if half else None),
        ]  # fmt: skip
    if rows[""] == rows["_y"]:
        return rows[""]
    pairs = zip(*rows.values(), strict=True)
    return [(f"{name}, {axis}", text) for pair in pairs for axis, (name, text) in zip("xy", pair, strict=True)]


def _dark_ring(pupil: Pupil) -> float | None:
    """Return the radius of the first dark ring without aberrations; None where the aperture is no annulus.

    The field of an annulus is the difference of those of two discs: ``J1(v) = eps J1(eps v)``.
    """
    from scipy.optimize import brentq
    from scipy.special import j1, jn_zeros

    shapes = (pupil.spider, pupil.vignetting, pupil.stop, pupil.mask)
    if not pupil.illumination.uniform or any(shape is not None for shape in shapes):
        return None
    last, inner = float(jn_zeros(1, 1)[0]), pupil.obscuration
    ring = float(brentq(lambda v: j1(v) - inner * j1(inner * v), 0.5, last)) if inner else last
    return pupil.airy_radius * ring / last


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
    rms, level = facts["rms_waves"], facts["rms_waves_without_tilt"]
    where = "over the clear aperture" if facts["clear_area"] < 1.0 - 1e-9 else "over the pupil"
    tilted = f" ({number(level)} without tilt)" if level is not None and rms - level > 5e-5 * rms else ""
    best, higher, distances = facts["balancing_W020"], facts["higher"], facts["defocus_of_distances"]
    shares = ""
    if not math.isclose(distances, facts["defocus"], rel_tol=1e-6, abs_tol=1e-9):
        shares = f"; by distances alone {distances:.4g} rad (W020 = {distances / math.pi:.4g})"
    listed = [f"{name} = {value:.4g}" for name, value in facts["waves"].items()]
    rest = f", ... ({len(listed)} terms; see --json)" if len(listed) > 4 else ""
    lines = [
        ("rms wavefront error", None if rms is None else f"{number(rms)} waves {where}{tilted}"),
        ("defocus C_d", f"{facts['defocus']:.4g} rad{shares}"),
        ("spherical C_s", f"{facts['spherical']:.4g} rad"),
        *[(f"rho^{6 + 2 * k}", f"{c:.4g} rad") for k, c in enumerate(higher if len(higher) < 4 else [])],
        ("in waves at the edge", ", ".join(listed[: 2 if rest else 4]) + rest),
        ("least rms would be at", None if best is None else f"W020 = {best:.4g}, which balances the other terms"),
    ]
    parts: list[RenderableType] = ["", list_of(lines, title="Wavefront")]
    if any(term["m"] for term in facts["zernike"]):
        parts += ["", zernike_table(facts)]
    unit = facts["wavelength"] * facts["working_f_number"]
    models = [
        ("model", _model(facts)),
        ("amplitude", None if facts["apodization"] == 0.0 else _amplitude(facts)),
        ("lambda*N", format_length(unit)),
        ("other model", None if _identical(facts["other_model"]) else model_in_words(facts["other_model"])),
    ]
    return [*parts, "", list_of(models, title="Model"), *refused(facts)]


def _finite(value: float) -> float | None:
    return None if math.isinf(value) else value


def distinct(*distances: float | None) -> list[str]:
    """Return lengths with enough digits for different ones to look different."""
    for digits in range(4, 13):
        texts = [format_length(math.inf if d is None else d, digits=digits) for d in distances]
        if len(set(texts)) == len(set(distances)):
            break
    return texts


def _amplitude(facts: Facts) -> str:
    kind = facts["apodization"]
    if isinstance(kind, float):
        name = f"Gaussian, exp(-{kind:.4g} rho^2)"
    else:
        name = "cos(theta)^(-1/2)" if kind == "aplanatic" else "exponential of a polynomial in rho^2"
    return f"{name}: {facts['rim_amplitude']:.4g} at the edge of the pupil"


def _model(facts: Facts) -> str:
    side = f", corrected for the {facts['corrected_for']}" if facts["model"] == "aplanatic" else ""
    return f"{facts['model']}{side}"


def model_in_words(other: Facts) -> str:
    """Return the difference of the paraxial and the aplanatic model in one line."""
    if other["reason"] is not None:
        return f"{other['model']}: {other['reason']}"
    if _identical(other):
        return f"{_model(other)}: identical"
    side = f" for the {other['corrected_for']}" if other["model"] == "aplanatic" else ""
    return f"{other['model']}{side}: PSF differs by {other['peak_error']:.2g} of the peak"


def _identical(other: Facts) -> bool:
    """Return whether the other model makes the same PSF within the tolerance of both, 1e-6."""
    return other["reason"] is None and bool(other["peak_error"] < 1e-6)


def _aperture(facts: Facts) -> list[tuple[str, str]]:
    """Return rows for the spider, the vignetting, the mask and the stop, if there are any."""
    spider, edge, mask, stop = (facts["aperture"][name] for name in ("spider", "vignetting", "mask", "stop"))
    rows = []
    if stop is not None:
        kinds = [f"{count} {kind[:-1] if count == 1 else kind}" for kind, count in stop["parts"].items() if count]
        if segments := stop["segments"]:
            phases = f", pistons {number(stop['piston_rms_waves'])} waves rms" if stop["piston_rms_waves"] else ""
            rows.append(("segments", f"{segments}{phases}"))
        if kinds:
            rows.append(("aperture", f"within the rim, made of {', '.join(kinds)}"))
    if spider is not None:
        angles = ", ".join(f"{math.degrees(angle):.4g}" for angle in spider["angles"])
        width = format_length(spider["width"] * 0.5 * facts["aperture_diameter"])
        rows.append(("vanes", f"{width} wide, at {angles} degrees from x towards y"))
    if edge is not None and edge["name"] == "Ellipse":
        rows.append(
            ("ellipse", f"{edge['a']:.4g} x {edge['b']:.4g} radii, at {math.degrees(edge['angle']):.4g} degrees")
        )
    elif edge is not None:
        x, y = edge["shift"]
        rows.append(("cat's eye", f"a circle of {edge['radius']:.4g} radii around ({x:.4g}, {y:.4g})"))
    if mask is not None:
        rows.append(("mask", f"{mask['side']} x {mask['side']} samples"))
    return [*rows, ("clear area", f"{facts['clear_area']:.2%} of the full aperture")] if rows else []


def _stop(stop: Shape | Segments) -> Facts:
    """Return of what a stop is made, and the spread of the phases of its segments."""
    shapes = stop.shapes if isinstance(stop, Segments) else (stop,)
    parts = [part for one in shapes for part in one.parts if part != Disc()]  # but the rim itself
    kinds = {"discs": (Disc, CatEye), "ellipses": (Ellipse,), "polygons": (Polygon,)}
    return {
        "segments": len(stop.shapes) if isinstance(stop, Segments) else 0,
        "piston_rms_waves": float(np.std(stop.piston)) / (2.0 * math.pi) if isinstance(stop, Segments) else 0.0,
        "parts": {name: sum(isinstance(part, kind) for part in parts) for name, kind in kinds.items()},
    }


def _field(instrument: Instrument, tried: Callable[[Callable[[], Any]], Any]) -> Facts:
    """Return the description of the field, from the axis to a corner of the sensor."""
    assert instrument.sensor is not None  # as long as there is a map
    field, (height, width) = instrument.field(), instrument.sensor
    places = []
    for part in (0.0, 0.5, 0.7, 1.0):
        x, y = 0.5 * part * width, 0.5 * part * height
        try:
            pupil = field.pupil(x, y)
        except ValueError:  # beyond the map
            continue
        terms = pupil.wavefront.to_zernike(unit="waves")
        places.append(
            {
                "part": part,
                "distance": math.hypot(x, y),
                "strehl": tried(partial(_strehl, pupil)),
                "rms_waves": tried(partial(_rms, pupil)),
                "strehl_at_peak": tried(partial(_brightest, pupil)),
                "rms_waves_without_tilt": tried(partial(_rms_without_tilt, pupil)),
                "zernike": listed_terms({term: c for term, c in terms.items() if term[0] > 1}),
            }
        )
    seidel = {name: waves for name, waves in field.seidel.items() if waves}
    return {"sensor": [height, width], "reach": field.reach, "seidel": seidel, "places": places}


def _field_parts(field: Facts) -> list[RenderableType]:
    """Return the table of the field."""
    seidel = ", ".join(f"{name} = {waves:.4g}" for name, waves in field["seidel"].items())
    if seidel:
        seidel = f": {seidel} waves at an image height of {format_length(field['reach'])}"
    rows = []
    for place in field["places"]:
        largest = sorted(place["zernike"], key=lambda term: -abs(term["waves_rms"]))[:2]
        terms = ", ".join(f"{term['name']} {term['waves_rms']:+.2g}" for term in largest if term["waves_rms"])
        distance = format_length(place["distance"], like=field["reach"])
        rows.append(
            (distance, *(known(place[name], ".4g") for name in ("strehl_at_peak", "rms_waves_without_tilt")), terms)
        )
    names = ("image height", "Strehl ratio", "rms (waves)", "largest Zernike terms (waves rms)")
    text = (
        "along a diagonal of the sensor, without tilt, which only shifts the image; all other values are on the axis"
    )
    note = Wrapped(text, "dim")
    return ["", table_of(names, rows, left=3, title=f"Field{seidel}"), note]


def zernike_table(facts: Facts) -> Table:
    """Return the table of the Zernike terms at a wavelength."""
    rows = [(t["name"], f"({t['n']}, {t['m']})", f"{t['waves_rms']:+.4g}") for t in facts["zernike"]]
    return table_of(("Zernike term", "(n, m)", f"waves rms at {format_length(facts['wavelength'])}, full disc"), rows)


def listed_terms(terms: dict[tuple[int, int], Any]) -> list[Facts]:
    """Return Zernike terms in waves rms, in Noll's order."""
    return [
        {"n": n, "m": m, "name": zernike.name(n, m), "waves_rms": float(c)}
        for (n, m), c in sorted(terms.items(), key=lambda item: int(zernike.index_of(item[0][0], item[0][1], "noll")))
    ]


def other_model(instrument: Instrument) -> Facts:
    """Return how the PSF changes with the other model of the lens, paraxial or aplanatic; or the "reason" why not.

    "peak_error" is the largest difference of the two PSFs in the window over the peak of the aplanatic one.
    """
    lens = instrument.lens
    model = "aplanatic" if lens.model == "paraxial" else "paraxial"
    # Where the lens magnifies, as an objective does, the sensor is in its design position and the object is not.
    side = "focus" if model == "aplanatic" and magnifies(lens) else lens.corrected_for
    found = {"model": model, "corrected_for": side, "geometric_radius": None, "peak_error": None, "reason": None}
    try:
        # The amplitude stays, also where it is made of angles that a paraxial lens does not have.
        changed = replace(lens, model=model, corrected_for=side, apodization=lens.illumination)
        other = changed.pupil(instrument.object_distance)
        pupils = {lens.model: instrument.pupil(), model: other}
        seen = {
            name: psf(p, instrument.window, instrument.pixel, dtype="float64", **instrument.sensor_options)
            for name, p in pupils.items()
        }
    except ToleranceError:
        return found | {"reason": "cannot be computed to the tolerance"}
    except (ValueError, ArithmeticError, ImportError) as error:
        return found | {"reason": str(error)}
    blur, difference = other.geometric_radius(), errors.peak_error(seen["paraxial"], seen["aplanatic"])
    return found | {"geometric_radius": float(blur), "peak_error": difference}


def magnifies(lens: Lens) -> bool:
    """Return whether the image of the object in focus is larger than it, as that of a microscope objective is."""
    return 0.0 < lens.focus_distance < lens.sensor_distance


def _energies(pupil: Pupil, radii: list[float]) -> tuple[list[float | None], float | None]:
    """Return encircled energies, None for circles that are too wide, and the bound on their error."""
    most = math.inf if pupil.radial else MAX_RADIUS * pupil.scale
    found = encircled(pupil, [r for r in radii if r <= most])
    within = iter(found.fraction.tolist())
    return [next(within) if r <= most else None for r in radii], found.error
