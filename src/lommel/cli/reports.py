"""Reports on lenses, microscopes and PSFs: plain data for JSON, and the same in tables."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from rich.text import Text

from lommel.base.units import format_length
from lommel.channel_psf import ColourPSF
from lommel.cli.options import Pitch
from lommel.cli.output import Facts, Report, list_of, table_of
from lommel.core.answers import ToleranceError
from lommel.field.psf_grid import PSFGrid
from lommel.lensfiles.instrument import Instrument, wide_enough
from lommel.lensfiles.microscope_files import Microscope
from lommel.measures import aperture_means, errors, spot, transfer
from lommel.measures.energy import MAX_RADIUS, encircled, optics
from lommel.measures.psf_like import PSFGridLike, PSFLike, checked
from lommel.methods import HuygensFresnel, Method, Polychromatic
from lommel.methods.choice import of_profiles, reference
from lommel.optics.aperture.apodization import Apodization
from lommel.optics.colour.spectrum import Channels
from lommel.optics.layers.emitter import Dipole, Scalar
from lommel.optics.layers.stratified import Layer
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.pupil import checked as lens_pupil
from lommel.psf import PSF, psf
from lommel.show.drawing import HOW, MEANING
from lommel.special import zernike

if TYPE_CHECKING:
    from rich.console import RenderableType

_OF_LENS = ("focal_length", "aperture_diameter", "f_number", "working_f_number", "obscuration", "wavelength",
            "model", "corrected_for")  # fmt: skip
_OF_OBJECTIVE = ("NA", "magnification", "working_distance", "immersion")


def describe_lens(instrument: Instrument) -> Report:
    """Return the report of a lens and its object; facts are None for infinity and for what cannot be computed.

    Lengths in metres, phases in radians, frequencies in cycles per metre along x; "refused" has the reasons.
    """
    lens, pupil = instrument.lens, instrument.pupil()
    radii = dict(instrument.radii)
    airy, blur = pupil.airy_radius, float(pupil.geometric_radius())
    radii.setdefault("Airy radius", airy)
    if blur > 0:
        radii.setdefault("geometric blur radius", blur)
    refused: dict[str, None] = {}
    at = list(radii.values())

    def known(work: Callable[[], Any]) -> Any:
        try:
            return work()
        except (ValueError, ArithmeticError) as reason:
            refused[str(reason)] = None
            return None

    def of_circle(work: Callable[[], Any]) -> Any:
        return known(work) if pupil.circular else None

    nothing: list[None] = [None] * len(at)
    seen, error = known(lambda: _energies(pupil, at)) or (nothing, None)
    ideal, other_error = known(lambda: _energies(pupil.unaberrated(), at)) or (nothing, None)
    # Along columns, whose pitch is the width of a pixel.
    nyquist = 0.5 / instrument.pitch[1]
    sensor: Facts = {"pixel": instrument.pixel, "fill": instrument.fill}
    facts = {
        "name": instrument.name,
        "source": instrument.source,
        **{name: getattr(lens, name) for name in _OF_LENS},
        "apodization": light.to_dict() if isinstance(light := lens.apodization, Apodization) else light,
        "rim_amplitude": float(np.divide(*lens.illumination.value([1.0, 0.0]))),
        "other_model": other_model(instrument),
        "focus_distance": _finite(lens.focus_distance),
        "sensor_distance": lens.sensor_distance,
        "object_distance": _finite(instrument.object_distance),
        "pixel": instrument.pixel,
        "defocus": float(pupil.wavefront.defocus),
        "spherical": float(pupil.wavefront.spherical),
        "higher": [float(c) for c in pupil.wavefront.higher],
        "waves": {name: float(value) for name, value in pupil.wavefront.waves.items()},
        "zernike": _terms(pupil.wavefront.to_zernike(unit="waves")),
        "airy_radius": airy,
        "geometric_radius": blur,
        "strehl": known(lambda: float(aperture_means.strehl(pupil))),
        "marechal": float(aperture_means.marechal(pupil)),
        "rms_waves": float(aperture_means.rms(pupil, unit="waves")),
        "fwhm": known(
            lambda: float(spot.radial_fwhm(of_profiles(), pupil) if pupil.radial else spot.width(optics(pupil)))
        ),
        "cutoff": pupil.cutoff,
        "mtf50": of_circle(lambda: float(transfer.mtf_frequency(pupil))),
        "nyquist": nyquist,
        "mtf_at_nyquist": of_circle(lambda: float(transfer.mtf(pupil, nyquist))),
        "mtf_at_nyquist_with_pixel": of_circle(lambda: float(transfer.mtf(pupil, nyquist, **sensor))),
        "aperture": {
            "spider": None if lens.spider is None else lens.spider.to_dict(),
            "vignetting": None if lens.vignetting is None else lens.vignetting.to_dict(),
            "mask": None if lens.mask is None else {"side": lens.mask.side},
        },
        "clear_area": pupil.area,
        "field": None if instrument.aberrations_of_field is None else _field(instrument),
        "encircled_energy": [
            {"within": name, "radius": radius, "fraction": a, "unaberrated": b}
            for (name, radius), a, b in zip(radii.items(), seen, ideal, strict=True)
        ],
        "encircled_energy_error": max((e for e in (error, other_error) if e is not None), default=None),
        "refused": list(refused),
    }
    return Report(facts, _lens_parts(facts))


def _lens_parts(facts: Facts) -> list[RenderableType]:
    """Return the tables of a lens."""
    focused, seen = _distinct(facts["focus_distance"], facts["object_distance"])
    obscured = f", obscuration {facts['obscuration']:.3g}" if facts["obscuration"] else ""
    nyquist, with_pixel = facts["mtf_at_nyquist"], facts["mtf_at_nyquist_with_pixel"]
    lines = [
        ("lens", f"f = {format_length(facts['focal_length'])}, f/{facts['f_number']:.3g}{obscured}"),
        *_aperture(facts),
        ("focus distance", focused),
        ("object distance", seen),
        ("wavelength", format_length(facts["wavelength"])),
        ("lambda*N", f"{format_length(facts['wavelength'] * facts['working_f_number'])}"
         f" (working f/{facts['working_f_number']:.4g})"),
        ("pixel", pitch_in_words(facts["pixel"])),
        ("model", _model(facts)),
        ("amplitude", None if facts["apodization"] == 0.0 else _amplitude(facts)),
        ("other model", None if _identical(facts["other_model"]) else model_in_words(facts["other_model"])),
        ("defocus C_d", f"{facts['defocus']:.4g} rad"),
        ("spherical C_s", f"{facts['spherical']:.4g} rad"),
        *[(f"rho^{6 + 2 * k}", f"{c:.4g} rad") for k, c in enumerate(facts["higher"])],
        ("in waves", ", ".join(f"{name} = {value:.4g}" for name, value in facts["waves"].items())),
        ("Airy radius", format_length(facts["airy_radius"])),
        ("geometric blur radius", format_length(facts["geometric_radius"])),
        ("rms wavefront error", f"{facts['rms_waves']:.4g} waves"),
        ("Strehl ratio (on axis)", _known(facts["strehl"], ".4g")),
        ("Marechal's estimate", f"{facts['marechal']:.4g}"
         + (" (valid above 0.3)" if facts["marechal"] < 0.3 else "")),
        ("FWHM", "-" if facts["fwhm"] is None else format_length(facts["fwhm"])),
        ("MTF50", None if facts["mtf50"] is None else
         f"{_per_mm(facts['mtf50'])} (cutoff {_per_mm(facts['cutoff'])})"),
        ("MTF at Nyquist", None if with_pixel is None else
         f"{nyquist:.4g} at {_per_mm(facts['nyquist'])}, pixel included {with_pixel:.4g}"),
    ]  # fmt: skip
    parts: list[RenderableType] = [Text(facts["name"], "bold"), list_of(lines)]
    if any(term["m"] for term in facts["zernike"]):
        rows = [(t["name"], f"({t['n']}, {t['m']})", f"{t['waves_rms']:+.4g}") for t in facts["zernike"]]
        parts += ["", table_of(("name", "(n, m)", "waves rms"), rows, title="Zernike terms")]
    if facts["field"] is not None:
        parts += _field_parts(facts["field"])
    energies = [
        (
            row["within"],
            format_length(row["radius"]),
            *(_known(row[name], ".1%") for name in ("fraction", "unaberrated")),
        )
        for row in facts["encircled_energy"]
    ]
    names = ("within", "radius", "this lens", "unaberrated")
    parts += ["", table_of(names, energies, title="Encircled energy")]
    if facts["encircled_energy_error"] is not None:
        parts.append(Text(f"error bound {facts['encircled_energy_error']:.1g}", "dim"))
    elif any(facts["aperture"].values()):
        parts.append(Text("no error bound", "dim"))
    return [*parts, *_refused(facts)]


def _known(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def _refused(facts: Facts) -> list[Text]:
    return [Text(f"not computed: {reason}", "dim") for reason in facts["refused"]]


def _distinct(*distances: float | None) -> list[str]:
    """Return lengths with enough digits for different ones to look different."""
    for digits in range(4, 13):
        texts = ["infinity" if d is None else format_length(d, digits=digits) for d in distances]
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
    return (
        f"{_model(other)}: differs by {other['peak_error']:.2g} of the peak, geometric blur radius "
        f"{format_length(other['geometric_radius'])}"
    )


def _identical(other: Facts) -> bool:
    """Return whether the other model makes the same PSF within the tolerance of both, 1e-6."""
    return other["reason"] is None and bool(other["peak_error"] < 1e-6)


def _aperture(facts: Facts) -> list[tuple[str, str]]:
    """Return rows for the spider, the vignetting and the mask, if there are any."""
    spider, edge, mask = (facts["aperture"][name] for name in ("spider", "vignetting", "mask"))
    rows = []
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


def _per_mm(frequency: float) -> str:
    return f"{1e-3 * frequency:.4g} cycles/mm"


def pitch_in_words(pixel: Pitch) -> str:
    """Return the pixel pitch with its unit, or height x width."""
    return " x ".join(format_length(side) for side in ([pixel] if isinstance(pixel, float) else pixel))


def _field(instrument: Instrument) -> Facts:
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
                "strehl": float(aperture_means.strehl(pupil)),
                "rms_waves": float(aperture_means.rms(pupil, unit="waves")),
                "zernike": _terms({term: c for term, c in terms.items() if term[0] > 1}),
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
        largest = sorted(place["zernike"], key=lambda term: -abs(term["waves_rms"]))[:3]
        terms = ", ".join(f"{term['name']} {term['waves_rms']:+.2g}" for term in largest if term["waves_rms"])
        distance = format_length(place["distance"], like=field["reach"])
        rows.append((distance, f"{place['strehl']:.4g}", f"{place['rms_waves']:.4g}", terms))
    names = ("image height", "Strehl ratio", "rms (waves)", "largest Zernike terms (waves rms)")
    note = Text("along a diagonal of the sensor; all other values are on the axis", "dim")
    return ["", table_of(names, rows, left=3, title=f"Field{seidel}"), note]


def _terms(terms: dict[tuple[int, int], Any]) -> list[Facts]:
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
    side = "focus" if model == "aplanatic" and _magnifies(lens) else lens.corrected_for
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


def _magnifies(lens: Lens) -> bool:
    return 0.0 < lens.focus_distance < lens.sensor_distance


def _energies(pupil: Pupil, radii: list[float]) -> tuple[list[float | None], float | None]:
    """Return encircled energies, None for circles that are too wide, and the bound on their error."""
    most = math.inf if pupil.radial else MAX_RADIUS * pupil.scale
    found = encircled(pupil, [r for r in radii if r <= most])
    within = iter(found.fraction.tolist())
    return [next(within) if r <= most else None for r in radii], found.error


def describe_psf(answer: PSF, seconds: float) -> Report:
    """Return the report of a PSF; "wide_enough" is a window for 98 % of the light if this has under 95 %."""
    energy, side = float(answer.energy), wide_enough(lens_pupil(answer.pupil), min(answer.grid.pitch))
    enough = energy >= 0.95 or min(answer.shape) >= side
    facts = how_made(answer, seconds) | {"wide_enough": None if enough else side, "energy": energy}
    lines = [
        ("method", repr(answer.method)),
        ("values", _values(facts)),
        ("pixels", f"{HOW[answer.sampling]}, {facts['pixel_over_lambda_N']:.3g} lambda*N wide"),
        ("largest value", f"{facts['peak']:.4g}"),
        ("energy in the window", f"{energy:.2%}"),
        *_error_and_time(facts),
    ]
    parts: list[RenderableType] = ["", list_of(lines, title="PSF")]
    if facts["sum"] is not None:
        text = (
            f"The values sum to {facts['sum']:.4g}, not to the light in the window: point samples this far apart "
            "miss some of it. Use --integrate for pixel-integrated values."
        )
        parts.append(Text(text))
    if not enough:
        text = f"The window holds {energy:.0%} of the light; --shape {side} would hold about 98 %."
        parts.append(Text(text))
    return Report({"psf": facts}, parts)


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
        rows.append((one["name"], ends, f"{one['light']:.3g}", f"{one['peak']:.4g}", _known(one["energy"], ".2%")))
    table = table_of(("channel", "wavelengths", "light", "largest value", "sum of values"), rows)
    return Report(facts, [Text(instrument.name, "bold"), list_of(lines), "", table])


def _values(facts: Facts) -> str:
    return f"{' x '.join(map(str, facts['shape']))} {facts['dtype']}, {MEANING[facts['normalize']]}"


def _error_and_time(facts: Facts, channel: str = "") -> list[tuple[str, str]]:
    """Return rows for the error bound and the time."""
    bound = "none" if facts["error_bound"] is None else f"{facts['error_bound']:.2g} of the peak{channel}"
    return [("error bound", bound), ("time", f"{1e3 * facts['seconds']:.1f} ms")]


def describe_mtf(instrument: Instrument, grid: PSFGridLike | None = None, channels: Channels | None = None) -> Report:
    """Return the report of the MTF, pixel included, at the Nyquist frequency and at half of it, along x and y.

    One row for each place of a `grid` and each of the `channels`, or for the axis and the wavelength of the file.
    """
    nyquist = tuple(0.5 / side for side in instrument.pitch[::-1])
    fx, fy = np.array([nyquist[0], 0.0]), np.array([0.0, nyquist[1]])
    at = {"nyquist": 1.0, "half_nyquist": 0.5}
    places: list[tuple[float | None, float | None, Pupil]] = [(None, None, instrument.pupil())]
    if grid is not None:
        field = instrument.field()
        places = [(x, y, field.pupil(x, y)) for y in grid.y.tolist() for x in grid.x.tolist()]
    lights: list[tuple[str | None, Polychromatic | None]] = [(None, None)]
    if channels is not None:
        lights = [(name, Polychromatic([w for w, _ in pairs], [s for _, s in pairs])) for name, pairs in channels]
    sensor: Facts = {"pixel": instrument.pixel, "fill": instrument.fill, "tol": 1e-6}
    rows = [
        {"x": x, "y": y, "channel": name}
        | {
            part: transfer.mtf(pupil, share * fx, share * fy, spectrum=light, **sensor).tolist()
            for part, share in at.items()
        }
        for x, y, pupil in places
        for name, light in lights
    ]
    heads = [*(("position x, y",) if grid is not None else ()), *(("channel",) if channels else ())]
    cells = []
    for row in rows:
        where = [", ".join(format_length(row[axis], like=1e-3) for axis in ("x", "y"))] if grid is not None else []
        where += [row["channel"]] if channels else []
        cells.append([*where, *(f"{value:.4f}" for part in at for value in row[part])])
    names = (*heads, "x, Nyquist", "y, Nyquist", "x, half", "y, half")
    table = table_of(names, cells, left=0 if heads else -1, title="MTF, pixel included")
    across, down = (_per_mm(frequency) for frequency in nyquist)
    along = across if across == down else f"{across} along x and {down} along y"
    note = Text(f"Nyquist frequency: {along}; x: vertical lines", "dim")
    return Report({"mtf": {"frequency": list(nyquist), "rows": rows}}, ["", table, note])


def how_made(answer: PSFLike, seconds: float) -> Facts:
    """Return the description of the values and how they were computed, sums and peaks for each PSF of a stack."""
    # Samples too far apart do not sum to the light in the window.
    stray = answer.normalize == "energy" and answer.undersampled
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


def compare(
    instrument: Instrument, methods: Iterable[Method], started: Callable[[str], object] = str
) -> tuple[list[Facts], dict[str, PSF]]:
    """Return the errors and times of several methods against the `reference`, and the PSFs of those that apply.

    The PSF of the reference comes first. Those on other samples than it has are left out.
    """
    pupil = instrument.pupil()
    judge = reference(pupil)

    def answer(method: Method, integrate: bool | None) -> PSF:
        window, pixel = instrument.window, instrument.pixel
        fill = 1.0 if integrate is False else instrument.fill
        return psf(pupil, window, pixel, method=method, dtype="float64", integrate=integrate, fill=fill)

    started(reference_name(pupil))
    truth, seconds = timed(partial(answer, judge, instrument.integrate))
    answers = {reference_name(pupil): truth}
    rows = []
    for method in methods:
        name = type(method).__name__
        row: Facts = {"method": name, "options": method.to_dict(), "reason": None}
        row |= dict.fromkeys(("seconds", "mse", "peak_error", "error_bound", "sampling"))
        rows.append(row)
        if isinstance(method, HuygensFresnel) and instrument.lens.model == "paraxial" and _magnifies(instrument.lens):
            row["reason"] = 'needs model = "aplanatic": its paraxial model is a flat lens, unlike any objective'
            continue
        if method != judge:
            started(name)
        # Its sums over the area of every pixel would take minutes.
        integrate = False if isinstance(method, HuygensFresnel) else instrument.integrate
        try:
            own = (truth, seconds) if method == judge else timed(partial(answer, method, integrate))
        except (ValueError, ArithmeticError, ImportError) as error:
            row["reason"] = str(error)
            continue
        found, row["seconds"] = own
        row["sampling"], row["error_bound"] = found.sampling, found.error_bound
        against = truth
        if found.sampling == truth.sampling:
            answers[name] = found
        elif found.sampling == "center":
            against = answer(judge, False)
        row["mse"], row["peak_error"] = errors.mse(found, against), errors.peak_error(found, against)
    return rows, answers


def reference_name(pupil: Pupil) -> str:
    """Return "Hankel", or the name and tolerance of another reference."""
    judge = reference(pupil)
    return type(judge).__name__ if pupil.radial else repr(judge)


def timed(work: Callable[[], PSF]) -> tuple[PSF, float]:
    """Return the PSF and the seconds of the second of two runs, or of a first that takes more than a second."""
    for _ in range(2):  # the first one loads libraries and fills caches
        start = time.perf_counter()
        answer = work()
        seconds = time.perf_counter() - start
        if seconds > 1.0:
            break
    return answer, seconds


def _finite(value: float) -> float | None:
    return None if math.isinf(value) else value


DEPTHS = (0.0, 1e-6, 5e-6, 20e-6, 50e-6)
"""Depths that are listed besides that of the file, metres."""


def describe_microscope(microscope: Microscope, *, foci: bool = True) -> Report:
    """Return the report of a microscope; with `foci`, a row for each depth of a freely rotating dipole.

    Lengths in metres: x and y in the sample, z of the stage, "pixel" on the camera. Angles in radians.
    """
    objective, wavelength = microscope.objective, microscope.wavelength
    nyquist, glass = objective.nyquist(wavelength=wavelength), objective.coverslip
    rows, refused = _foci(microscope) if foci else ([], [])
    step = abs(microscope.step) if microscope.planes > 1 else None
    coarse = {"pixel": microscope.pixel > nyquist.pixel, "step": step is not None and step > nyquist.axial}
    design = objective.design
    as_designed = design.immersion == objective.immersion and design.coverslip == glass
    facts = {
        "name": microscope.name,
        "source": microscope.source,
        **{name: getattr(objective, name) for name in _OF_OBJECTIVE},
        "coverslip": _layer(glass),
        "films": [_layer(film) for film in objective.films],
        "design": None if as_designed else {"immersion": design.immersion, "coverslip": _layer(design.coverslip)},
        "sample": objective.sample,
        "critical_angle": objective.critical_angle,
        "rim_angle": math.asin(objective.NA / objective.immersion),
        "wavelength": wavelength,
        "emitter": emitter_in_words(microscope),
        "depth": microscope.depth,
        "planes": microscope.planes,
        "step": step,
        "origin": microscope.origin,
        "pixel": microscope.pixel,
        "pixel_in_sample": microscope.pixel / objective.magnification,
        "nyquist": {"lateral": nyquist.lateral, "axial": nyquist.axial, "pixel": nyquist.pixel},
        "too_coarse": [name for name, exceeds in coarse.items() if exceeds],
        "focus": rows,
        "refused": refused,
    }
    return Report(facts, [*_microscope_parts(facts), *(_focus_parts(facts) if rows else ())])


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
        ("cover glass", _layer_in_words(facts["coverslip"]) or "none (dipping objective)"),
        *[("film", _layer_in_words(film)) for film in facts["films"]],
        ("designed for", design),
        ("sample", f"index {facts['sample']:g}, emitter at a depth of {format_length(facts['depth'])}"),
        ("critical angle", f"{critical}; {rim}"),
        ("wavelength", format_length(facts["wavelength"])),
        ("emitter", facts["emitter"]),
        ("planes", f"{several} {_ORIGINS[facts['origin']]}"),
        ("pixel", f"{format_length(facts['pixel'])}, {format_length(facts['pixel_in_sample'])} in the sample"),
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
    "brightest": "the brightest focus of the emitter",
    "paraxial": "the paraxial focus of the emitter",
    "coverslip": "the surface of the cover glass",
}


def _layer_in_words(layer: dict[str, float] | None) -> str:
    return "" if layer is None else f"{format_length(layer['thickness'])} of index {layer['index']:g}"


def _foci(microscope: Microscope) -> tuple[list[dict[str, float | None]], list[str]]:
    """Return the foci at several depths, and the reasons why other depths have none."""
    objective, wavelength = microscope.objective, microscope.wavelength
    rows: list[dict[str, float | None]] = []
    refused: dict[str, None] = {}
    surface = float(objective.focus(0.0, wavelength=wavelength).peak)
    for depth in sorted({*DEPTHS, microscope.depth}):
        try:
            found = objective.focus(depth, wavelength=wavelength)
        except ValueError as reason:
            refused[f"{1e6 * depth:.4g} um deep: {reason}"] = None
            continue
        row: dict[str, float | None] = {"depth": depth, "ratio": float(found.ratio) if depth > 0.0 else None}
        names = ("paraxial", "brightest", "axial_fwhm", "lateral_fwhm", "peak")
        row |= {name: float(getattr(found, name)) for name in names}
        row["peak_of_surface"] = float(found.peak) / surface
        row["collected"] = float(objective.collected(depth, wavelength=wavelength))
        rows.append(row)
    return rows, list(refused)


def _focus_parts(facts: Facts) -> list[RenderableType]:
    """Return the table of the focus of emitters at several depths."""
    lengths = ("depth um", "paraxial um", "best um", "depth / best", "axial nm", "lateral nm")
    rows = [
        (
            f"{1e6 * row['depth']:.4g}",
            *(f"{1e6 * row[name]:.3f}" for name in ("paraxial", "brightest")),
            _known(row["ratio"], ".3f"),
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
        "full width at half maximum; light: collected light relative to an emitter far from the glass"
    )
    return ["", table, Text(note, "dim"), *_refused(facts)]


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
    lines = [
        ("method", repr(answer.method)),
        ("values", _values(facts)),
        ("pixels", f"{format_length(facts['pixel_in_sample'])} in the sample, {HOW[answer.sampling]}"),
        ("largest value", peak),
        ("energy in the window", held),
        *_error_and_time(facts),
    ]
    return Report({"psf": facts}, ["", list_of(lines, title="PSF")])


def emitter_in_words(microscope: Microscope) -> str:
    """Return a description of the emitter or of the excitation beam."""
    emitter = microscope.emitter
    if isinstance(emitter, Dipole):
        if emitter.wobble == 1.0:
            return "freely rotating dipole"
        place = (
            f"{math.degrees(emitter.polar):.4g} deg from the axis, azimuth {math.degrees(emitter.azimuth):.4g} deg"
        )
        return f"dipole, {place}" + (f", wobble {emitter.wobble:.4g}" if emitter.wobble else "")
    if isinstance(emitter, Scalar):
        return "scalar (Gibson-Lanni)"
    return f"beam focused into the sample, {emitter.polarization} polarization"


def _layer(layer: Layer | None) -> dict[str, float] | None:
    return None if layer is None else {"index": layer.index, "thickness": layer.thickness}
