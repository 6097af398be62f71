"""Image quality of a lens or a microscope: Strehl ratio, widths, MTF, depth of field and encircled energy."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from lommel.base.arrays import Json, Numbers, plain
from lommel.base.units import ARCSEC
from lommel.core.answers import ToleranceError
from lommel.measures import aperture_means, errors, spot, transfer
from lommel.measures.energy import MAX_RADIUS, encircled
from lommel.measures.image_quality import balancing_defocus, dark_ring_radius, rms_without_tilt, strehl_at_peak
from lommel.methods import Method, Polychromatic
from lommel.methods.choice import first_within_tolerance, references
from lommel.methods.paper.huygens import HuygensFresnel
from lommel.optics.aperture.apodization import illumination
from lommel.optics.aperture.shapes import Segments
from lommel.optics.layers.objective import aberration, layers_of, media_strehl
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf
from lommel.show.drawing import of_emitter
from lommel.special import zernike

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Instrument
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.optics.colour.spectrum import Channels
    from lommel.optics.lens import Lens
    from lommel.optics.pupil import Pupil

    # x and y on the sensor, metres, or None if the file has no field aberrations; and the pupil at this position.
    Place = tuple[float | None, float | None, Pupil]

Value = TypeVar("Value")

IN_FOCUS = 2.0
"""Largest diameter, in pixels, of the circle of confusion of objects that count as in focus."""

_LENS_ATTRIBUTES = ("focal_length", "aperture_diameter", "f_number", "working_f_number", "obscuration", "wavelength",
            "model")  # fmt: skip
# Diameter, in pixels, above which pixel integration changes a width by less than the last printed digit.
_MAX_WIDTH = 60.0
# Largest number of mirror segments for which MTF50 and focus tolerance are computed; more segments take minutes.
_MAX_SEGMENTS = 24


def setup(instrument: Instrument) -> Json:
    """Return the parameters of lens, object and sensor as plain data, without measures of image quality.

    "in_focus" has the nearest and the farthest object distance with a circle of confusion of at most 2 pixels. The
    diameter of the circle of confusion of a lens without aberrations is ``D d abs(1/s - 1/s0)`` for an object at the
    distance s, where D is the aperture diameter, d the sensor distance and s0 the focus distance.
    "hyperfocal_distance" is the smallest focus distance whose depth of field extends to infinity. Both are None for
    telescopes and microscopes.
    """
    lens, width, blur = instrument.lens, instrument.pitch[1], IN_FOCUS * max(instrument.pitch)
    is_telescope = math.isinf(lens.focus_distance) and math.isinf(instrument.object_distance)
    in_focus = hyperfocal_distance = None
    if not (lens.focus_distance < 0.0 or magnifies(lens) or lens.obscuration or lens.focal_length > 1.0):
        # Largest difference of 1/s and 1/s0.
        middle, difference = 1.0 / lens.focus_distance, blur / (lens.aperture_diameter * lens.sensor_distance)
        far = 1.0 / (middle - difference) if middle > difference else math.inf
        in_focus = {"near": 1.0 / (middle + difference), "far": far, "blur": blur}
        hyperfocal_distance = lens.focal_length * (1.0 + lens.aperture_diameter / blur)
    result = {
        "name": instrument.name,
        "source": instrument.source,
        **{name: getattr(lens, name) for name in _LENS_ATTRIBUTES},
        **({"corrected_for": lens.corrected_for} if lens.model == "aplanatic" else {}),
        "apodization": lens.apodization,
        "focus_distance": lens.focus_distance,
        "sensor_distance": lens.sensor_distance,
        "object_distance": instrument.object_distance,
        "pixel": instrument.pixel,
        "arcsec_per_pixel": width / lens.focal_length / ARCSEC if is_telescope else None,
        "pixel_in_object": width * lens.focus_distance / lens.sensor_distance if magnifies(lens) else None,
        "in_focus": in_focus,
        "hyperfocal_distance": hyperfocal_distance,
        "aperture": {
            "spider": lens.spider,
            "vignetting": lens.vignetting,
            "mask": None if lens.mask is None else {"side": lens.mask.side},
            "stop": None if lens.stop is None else type(lens.stop).__name__,
            "segments": len(lens.stop.shapes) if isinstance(lens.stop, Segments) else None,
        },
        "clear_area": instrument.pupil().area,
    }
    return dict(plain(result))


class _Attempts:
    """Calls of measures, and the `reasons` of those that failed, whose results are None."""

    def __init__(self) -> None:
        self.reasons: dict[str, None] = {}

    def __call__(self, measure: Callable[..., Value], *arguments: Any, **options: Any) -> Value | None:
        try:
            return measure(*arguments, **options)
        except (ValueError, ArithmeticError) as reason:
            self.reasons[str(reason)] = None
            return None


def image_quality(instrument: Instrument) -> Json:
    """Return all measures of a lens at its sensor, as ``lommel info`` prints them, as plain data.

    Lengths are in metres, phases in radians, frequencies in cycles per metre. Names of measures along y end in "_y";
    names of measures along x have no ending. Infinite values and failed computations are None; "refused" lists the
    reasons of failed computations.

    Parameters
    ----------
    instrument : Instrument
        Lens, object and sensor, for example from :func:`lommel.load_instrument`.

    Returns
    -------
    dict
        Plain data for JSON.

    Examples
    --------
    >>> import lommel as lm
    >>> from lommel.report.image_quality import image_quality
    >>> lens = lm.Lens(focal_length=20e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> quality = image_quality(lm.Instrument("lens", "", lens, 2.0, 2e-6, None, {}))
    >>> round(quality["in_focus"]["near"], 3), round(quality["in_focus"]["far"], 3)
    (1.853, 2.172)
    >>> round(quality["mtf50"] / 1e3)  # cycles per millimetre
    182
    """
    lens, pupil, pitch, attempt = instrument.lens, instrument.pupil(), instrument.pitch, _Attempts()
    sensor: Any = {"pixel": instrument.pixel, "fill": instrument.fill}
    light_within_radii = _encircled(instrument, attempt)

    def measured(pupil: Pupil, *names: str) -> Json:
        return dict(plain({name: attempt(_MEASURES[name], pupil) for name in names}))

    transfers: Json = {}
    for end, angle, side in (("", 0.0, pitch[1]), ("_y", 0.5 * math.pi, pitch[0])):
        nyquist = 0.5 / side
        at = nyquist * math.cos(angle), nyquist * math.sin(angle)
        transfers |= {
            f"mtf50{end}": attempt(mtf50, pupil, angle),
            f"nyquist{end}": nyquist,
            f"mtf_at_nyquist{end}": attempt(transfer.mtf, pupil, *at),
            f"mtf_at_nyquist_with_pixel{end}": attempt(transfer.mtf, pupil, *at, **sensor),
        }
    focused = lens if lens.aberrations.flat else replace(lens, aberrations=Wavefront())
    result = setup(instrument) | {
        "rim_amplitude": float(np.divide(*lens.illumination.value([1.0, 0.0]))),
        "other_model": other_model(instrument),
        "defocus": float(pupil.wavefront.defocus),
        "defocus_of_distances": float(lens.defocus(instrument.object_distance)),
        "spherical": float(pupil.wavefront.spherical),
        "higher": [float(c) for c in pupil.wavefront.higher],
        "waves": {name: float(value) for name, value in pupil.wavefront.waves.items()},
        "zernike": listed_terms(pupil.wavefront.to_zernike(unit="waves")),
        "airy_radius": pupil.airy_radius,
        "dark_ring_radius": dark_ring_radius(pupil),
        "geometric_radius": float(pupil.geometric_radius()),
        # Of the geometric blur due to defocus alone.
        "circle_of_confusion": 2.0 * float(focused.pupil(instrument.object_distance).geometric_radius()),
        "balancing_W020": attempt(balancing_defocus, pupil),
        **measured(pupil, "strehl", "strehl_at_peak", "marechal", "rms_waves", "rms_waves_without_tilt"),
        **_widths(instrument, attempt),
        "cutoff": pupil.cutoff,
        **plain(transfers),
        "focus_tolerance": attempt(_focus_tolerance, instrument),
        "field": None if instrument.aberrations_of_field is None else _field(instrument, measured),
        **light_within_radii,
    }
    return result | {"refused": list(attempt.reasons)}


_MEASURES: dict[str, Callable[[Pupil], Any]] = {
    "strehl": aperture_means.strehl,
    "strehl_at_peak": strehl_at_peak,
    "marechal": aperture_means.marechal,
    "rms_waves": partial(aperture_means.rms, unit="waves"),
    "rms_waves_without_tilt": rms_without_tilt,
}


def mtf50(pupil: Pupil, angle: float) -> float:
    """Return the frequency at which the MTF of the optics alone falls to 50 %; ValueError if that takes minutes."""
    segments = len(pupil.opening.regions)
    if segments > _MAX_SEGMENTS:
        raise ValueError(f"MTF50, which takes minutes for {segments} segments: use lommel.mtf_frequency(pupil)")
    return float(transfer.mtf_frequency(pupil, angle=angle))


def _focus_tolerance(instrument: Instrument, least: float = 0.3) -> tuple[float, float]:
    """Return the sensor displacements at which the MTF at half the Nyquist frequency falls to `least`."""
    pupil, frequency = instrument.pupil(), 0.25 / max(instrument.pitch)
    if isinstance(pupil.stop, Segments) and len(pupil.stop.shapes) > _MAX_SEGMENTS:
        raise ValueError(
            f"focus tolerance takes minutes for more than {_MAX_SEGMENTS} segments: use lommel.focus_tolerance"
        )
    sensor: Any = {"pixel": instrument.pixel, "fill": instrument.fill}
    mtf = float(np.min(transfer.mtf(pupil, [frequency, 0.0], [0.0, frequency], **sensor)))
    if mtf < least:
        raise ValueError(
            f"the focus tolerance needs an MTF of {least:g} or more at half the Nyquist frequency, got {mtf:.3g}"
        )
    return transfer.displacements(pupil, frequency, least, sensor)


def _widths(instrument: Instrument, attempt: _Attempts) -> Json:
    """Return FWHM and diameter of 80 % of the light, without the pixel and with it (None for a wide blur).

    The circle is about the axis, as that of encircled energies, and of pupils that are not symmetric also about the
    centroid.
    """
    # In a window of one pixel: the measures refer to the continuous image.
    pupil = instrument.pupil()
    image = attempt(psf, pupil, 1, instrument.pixel, integrate=True, fill=instrument.fill)
    measures: dict[str, Callable[..., Numbers]] = {
        "fwhm": spot.fwhm,
        "diameter_80": partial(spot.energy_diameter, fraction=0.8),
    }
    if not pupil.radial:
        measures["diameter_80_about_centroid"] = partial(spot.energy_diameter, fraction=0.8, about="centroid")
    result: Json = {
        name: None if image is None else attempt(measure, image, of="optics") for name, measure in measures.items()
    }
    diameter = result.get("diameter_80_about_centroid", result["diameter_80"])  # without the shift of a tilt
    is_wide = (diameter or math.inf) > _MAX_WIDTH * min(instrument.pitch)
    for name, measure in measures.items():
        omitted = result[name] is None or is_wide
        result[f"{name}_with_pixel"] = None if omitted else attempt(measure, image, of="image")
    return dict(plain(result))


def _field(instrument: Instrument, measured: Callable[..., Json]) -> Json:
    """Return the field aberrations as plain data, with positions from the axis to a corner of the sensor."""
    field, places = instrument.field(), []
    for part, distance, pupil in _along_diagonal(instrument):
        terms = pupil.wavefront.to_zernike(unit="waves")
        listed = listed_terms({term: c for term, c in terms.items() if term[0] > 1})
        quality = measured(pupil, "strehl", "rms_waves", "strehl_at_peak", "rms_waves_without_tilt")
        places.append({"part": part, "distance": distance, "zernike": listed} | quality)
    seidel = {name: waves for name, waves in field.seidel.items() if waves}
    return {"sensor": plain(instrument.sensor), "reach": field.reach, "seidel": seidel, "places": places}


def _along_diagonal(instrument: Instrument) -> Iterator[tuple[float, float, Pupil]]:
    """Yield the part of the half diagonal, the distance and the pupil of positions from the axis to a corner.

    Where the map ends before the corner its farthest position, if it is on the diagonal, stands for the corner.
    """
    assert instrument.sensor is not None  # instruments with field aberrations have a sensor size
    field, (height, width) = instrument.field(), instrument.sensor
    half = 0.5 * math.hypot(height, width)
    for part in (0.0, 0.5, 0.7, min(1.0, field.reach / half)):
        try:
            yield part, part * half, field.pupil(0.5 * part * width, 0.5 * part * height)
        except ValueError:  # the position is outside the field map
            continue


def place_quality(instrument: Instrument) -> Json:
    """Return the place of an instrument with aberrations over the field, and its range of Strehl ratios, as data.

    "strehl_at_peak" has the Strehl ratio at the place, "strehl_over_field" the least and the largest one from the
    axis to the corner, at most "to" from the axis; all at the brightest point of the image, which a tilt shifts.
    """
    attempt = _Attempts()
    ratios = {distance: attempt(strehl_at_peak, pupil) for _, distance, pupil in _along_diagonal(instrument)}
    known = {distance: ratio for distance, ratio in ratios.items() if ratio is not None}
    at_place = attempt(strehl_at_peak, instrument.pupil())
    between = [min(known.values()), max(known.values())] if known else None
    return dict(
        plain(
            {
                "at": instrument.place,
                "strehl_at_peak": at_place,
                "strehl_over_field": between,
                "to": max(known, default=None),
            }
        )
    )


def _encircled(instrument: Instrument, attempt: _Attempts) -> Json:
    """Return the fractions of the light within radii about the axis, also without aberrations, and their error.

    The radii are those of the file, the Airy radius and the geometric blur. A fraction is None if the radius is above
    250 lambda*N and the pupil not radially symmetric.
    """
    pupil = instrument.pupil()
    radii, blur = dict(instrument.radii), float(pupil.geometric_radius())
    radii.setdefault("Airy radius", pupil.airy_radius)
    if blur > 0:
        radii.setdefault("edge of the geometric blur", blur)
    rows: list[Json] = [{"within": name, "radius": radius} for name, radius in radii.items()]
    bounds = []
    for key, kind in (("fraction", pupil), ("unaberrated", pupil.unaberrated())):
        max_radius = math.inf if kind.radial else MAX_RADIUS * kind.scale
        found = attempt(encircled, kind, [r for r in radii.values() if r <= max_radius])
        fractions = iter([] if found is None else found.fraction.tolist())
        for row in rows:
            row[key] = next(fractions, None) if row["radius"] <= max_radius else None
        bounds += [] if found is None or found.error is None else [found.error]
    return {"encircled_energy": rows, "encircled_energy_error": max(bounds, default=None)}


def magnifies(lens: Lens) -> bool:
    """Return True if the image of an object in focus is larger than the object, as with a microscope objective."""
    return 0.0 < lens.focus_distance < lens.sensor_distance


def other_model(instrument: Instrument) -> Json:
    """Compare the PSFs of the lens by its own and the other model (paraxial, aplanatic); return plain data.

    "peak_error" is the largest difference of the two PSFs in the window divided by the peak of the aplanatic PSF. If
    the comparison fails, "peak_error" is None, and "reason" states why.
    """
    lens = instrument.lens
    model = "aplanatic" if lens.model == "paraxial" else "paraxial"
    # In a magnifying lens, such as an objective, the sensor is at its design position, but the object need not be.
    side = "focus" if model == "aplanatic" and magnifies(lens) else lens.corrected_for
    result = {"model": model, "corrected_for": side, "geometric_radius": None, "peak_error": None, "reason": None}
    try:
        # Keep the amplitude also where it is a function of ray angles, which a paraxial lens lacks.
        changed = replace(lens, model=model, corrected_for=side, apodization=lens.illumination)
        other = replace(instrument, lens=changed).pupil()
        pupils = {lens.model: instrument.pupil(), model: other}
        psfs = {
            name: psf(p, instrument.window, instrument.pixel, dtype="float64", **instrument.sensor_options)
            for name, p in pupils.items()
        }
    except ToleranceError:
        return result | {"reason": "cannot be computed to the tolerance"}
    except (ValueError, ArithmeticError, ImportError) as error:
        return result | {"reason": str(error).removeprefix(f"model {model!r} is ")}
    blur, difference = other.geometric_radius(), errors.peak_error(psfs["paraxial"], psfs["aplanatic"])
    return result | {"geometric_radius": float(blur), "peak_error": difference}


def sensor_mtf(instrument: Instrument, places: Sequence[Place], channels: Channels | None = None) -> Json:
    """Return the MTF, pixel included, at the Nyquist frequency and at half the Nyquist frequency as plain data.

    "frequency" has the Nyquist frequencies along x and y, cycles per metre. "rows" has one row for each combination
    of `places` and `channels` (without channels, the wavelength of the file), with the MTF along x and y. Rows of
    places off the axis also have the "sagittal" MTF (frequency perpendicular to the radius) and the "tangential" MTF,
    at the smaller Nyquist frequency and at half this frequency.
    """
    nyquist = [0.5 / side for side in instrument.pitch[::-1]]
    spectra: list[tuple[str | None, Polychromatic | None]] = [(None, None)]
    if channels is not None:
        spectra = [(name, Polychromatic([w for w, _ in pairs], [s for _, s in pairs])) for name, pairs in channels]
    sensor: Any = {"pixel": instrument.pixel, "fill": instrument.fill, "tol": 1e-6}
    rows = []
    for x, y, pupil in places:
        directions = {"nyquist": np.diag(nyquist)}  # frequency along x, along y
        if x is not None and y is not None and (x or y):
            radial = np.array([x, y]) / math.hypot(x, y)
            directions["radial"] = min(nyquist) * np.array([[-radial[1], radial[0]], radial])
        for name, light in spectra:
            result = {
                key: [
                    transfer.mtf(pupil, *(factor * f.T), spectrum=light, **sensor).tolist() for factor in (1.0, 0.5)
                ]
                for key, f in directions.items()
            }
            row: Json = {"x": x, "y": y, "channel": name}
            row |= dict(zip(("nyquist", "half_nyquist"), result["nyquist"], strict=True))
            if "radial" in result:
                row["sagittal"], row["tangential"] = map(list, zip(*result["radial"], strict=True))
            rows.append(row)
    return {"frequency": nyquist, "rows": rows}


def listed_terms(terms: Mapping[tuple[int, int], Numbers]) -> list[Json]:
    """Return Zernike coefficients (waves rms) as plain data, sorted by Noll index."""
    return [
        {"n": n, "m": m, "name": zernike.name(n, m), "waves_rms": float(c)}
        for (n, m), c in sorted(terms.items(), key=lambda item: int(zernike.index_of(item[0][0], item[0][1], "noll")))
    ]


DEPTHS = (0.0, 1e-6, 5e-6, 20e-6, 50e-6)
"""Depths at which foci are reported in addition to the depth of the file, metres."""

_OBJECTIVE_ATTRIBUTES = ("NA", "magnification", "working_distance", "immersion")
_MAX_FOCUSED_RMS = 0.5  # largest wavefront error, waves rms, whose focus is searched within 4 axial widths
_FOCUS_ATTRIBUTES = ("paraxial", "brightest", "ratio", "axial_fwhm", "lateral_fwhm", "peak")


def microscope_quality(microscope: Microscope, *, foci: bool = True) -> Json:
    """Return the parameters of a microscope as plain data, and with `foci` the focus of dipoles at several depths.

    Lengths are in metres: x and y in the sample, z of the stage, "pixel" on the camera. Angles are in radians. The
    list "focus" has one row for each depth of a freely rotating dipole, and "refused" the reasons why depths are
    missing. With terms, or media unlike the design, "rms_waves_with_media" is of the whole wavefront at the depth of
    the file in the best focus, and "strehl" the peak over that of the same pupil with a flat phase.
    """
    objective, wavelength = microscope.objective, microscope.wavelength
    light, nyquist = illumination(objective.apodization), objective.nyquist(wavelength=wavelength)
    step = abs(microscope.step) if microscope.planes > 1 else None
    design, measured = objective.design, microscope.aberrations
    terms = [] if measured is None else listed_terms(measured.to_zernike(unit="waves"))
    as_designed = design.immersion == objective.immersion and design.coverslip == objective.coverslip
    is_coarse = {"pixel": microscope.pixel > nyquist.pixel, "step": step is not None and step > nyquist.axial}
    rows, refused = _foci(microscope) if foci else ([], [])
    whole: Json = {"strehl": None, "rms_waves_with_media": None}
    if terms or not as_designed:
        layers, depth = layers_of(objective, wavelength), microscope.depth
        radians = {(term["n"], term["m"]): 2.0 * math.pi * term["waves_rms"] for term in terms}
        whole["rms_waves_with_media"] = float(np.linalg.norm(aberration(layers, depth, radians))) / (2.0 * math.pi)
        if peaks := [row["peak"] for row in rows if row["depth"] == depth]:
            unaberrated = float(objective.focus(depth, wavelength=wavelength).peak)
            whole["strehl"] = media_strehl(layers, depth) * float(peaks[0] or 0.0) / unaberrated
    return {
        "name": microscope.name,
        "source": microscope.source,
        **{name: getattr(objective, name) for name in _OBJECTIVE_ATTRIBUTES},
        "apodization": list(light.powers),
        "rim_amplitude": float(light.value(1.0)),
        "coverslip": plain(objective.coverslip),
        "films": plain(objective.films),
        "design": None if as_designed else plain(design),
        "sample": objective.sample,
        "critical_angle": objective.critical_angle,
        "rim_angle": math.asin(objective.NA / objective.immersion),
        "wavelength": wavelength,
        "emitter": of_emitter(microscope.emitter),
        "rms_waves": math.hypot(*(term["waves_rms"] for term in terms)),
        **whole,
        "zernike": terms,
        "depth": microscope.depth,
        "planes": microscope.planes,
        "step": step,
        "origin": microscope.origin,
        "pixel": microscope.pixel,
        "camera": plain(microscope.camera),
        "pixel_in_sample": microscope.pixel / objective.magnification,
        "nyquist": plain(nyquist),
        "too_coarse": [name for name, coarse in is_coarse.items() if coarse],
        "focus": rows,
        "refused": refused,
    }


def _foci(microscope: Microscope) -> tuple[list[dict[str, float | None]], list[str]]:
    """Return one row of data for the focus at each depth, and the reasons why depths are missing."""
    objective, wavelength = microscope.objective, microscope.wavelength
    rows: list[dict[str, float | None]] = []
    reasons: dict[str, None] = {}
    surface_peak = None  # the first depth is 0
    for depth in sorted({*DEPTHS, microscope.depth}):
        try:
            focus = focus_at(microscope, depth)
        except ValueError as reason:
            reasons[f"{1e6 * depth:.4g} um deep: {reason}"] = None
            continue
        row: dict[str, float | None] = {"depth": depth, **focus}
        if depth == 0.0:
            row["ratio"], surface_peak = None, focus["peak"]
        row["peak_of_surface"] = surface_peak and focus["peak"] / surface_peak
        row["collected"] = float(objective.collected(depth, wavelength=wavelength))
        rows.append(row)
    return rows, list(reasons)


def focus_at(microscope: Microscope, depth: float) -> dict[str, float]:
    """Return the attributes of the focus at a depth, with the aberrations; ValueError without a single focus."""
    objective, wavelength = microscope.objective, microscope.wavelength
    result = objective.focus(depth, wavelength=wavelength)
    focus = {name: float(getattr(result, name)) for name in _FOCUS_ATTRIBUTES}
    if microscope.aberrations is None:
        return focus
    if (waves := float(aperture_means.rms(microscope.aberrations, unit="waves"))) > _MAX_FOCUSED_RMS:
        raise ValueError(f"aberrations of {waves:.2g} waves rms, above {_MAX_FOCUSED_RMS:g}, have no single focus")
    # Aberrations shift the focus: the brightest voxel of a stack of 8 axial widths, in steps of 1 / 20.
    z = np.linspace(-4.0, 4.0, 161) * focus["axial_fwhm"]
    pixel = 0.25 * objective.nyquist(wavelength=wavelength).pixel
    stacks = [
        psf(
            objective.pupil(depth=depth, z=z, wavelength=wavelength, origin="brightest", aberrations=aberrations),
            33, pixel, integrate=False,
        )
        for aberrations in (None, microscope.aberrations)
    ]  # fmt: skip
    ideal, aberrated = (stack.values.astype(np.float64) for stack in stacks)
    plane, row, column = np.unravel_index(int(aberrated.argmax()), aberrated.shape)
    sides = aberrated[plane, row], aberrated[plane, :, column]
    return focus | {
        "brightest": focus["brightest"] + float(z[plane]),
        "axial_fwhm": spot.profile_width(aberrated[:, row, column]) * float(z[1] - z[0]),
        "lateral_fwhm": 0.5 * sum(spot.profile_width(side) for side in sides) * pixel / objective.magnification,
        "peak": focus["peak"] * float(aberrated.max() / ideal.max()),
    }


def compare_methods(
    instrument: Instrument, methods: Iterable[Method], on_start: Callable[[str], object] = str
) -> tuple[list[Json], dict[str, PSF]]:
    """Return errors and times of several methods, one row each, and the PSFs of the methods that apply.

    Errors are relative to :func:`lommel.methods.choice.references`, whose PSF is first, under the name of its class
    or its ``repr``. PSFs whose :attr:`lommel.PSF.sampling` differs from the reference are omitted. `on_start` is
    called with the name of each method before it runs.
    """
    pupil = instrument.pupil()

    def compute(method: Method, integrate: bool | None) -> PSF:
        window, pixel = instrument.window, instrument.pixel
        fill = 1.0 if integrate is False else instrument.fill
        return psf(pupil, window, pixel, method=method, dtype="float64", integrate=integrate, fill=fill)

    def run_timed(method: Method, integrate: bool | None) -> tuple[PSF, float]:
        """Return the PSF and the time (s) of the second run, or of the first run if it takes more than a second."""
        for _ in range(2):  # the first run loads libraries and fills caches
            start = time.perf_counter()
            result = compute(method, integrate)
            seconds = time.perf_counter() - start
            if seconds > 1.0:
                break
        return result, seconds

    def name_of(method: Method) -> str:
        return type(method).__name__ if pupil.radial else repr(method)

    def as_reference(method: Method) -> tuple[PSF, float]:
        on_start(name_of(method))
        return run_timed(method, instrument.integrate)

    exact_method, (exact, seconds) = first_within_tolerance(references(pupil), as_reference)
    answers, rows = {name_of(exact_method): exact}, []
    for method in methods:
        name = type(method).__name__
        row: Json = {"method": name, "options": method.to_dict(), "reason": None}
        row |= dict.fromkeys(("seconds", "mse", "peak_error", "error_bound", "sampling"))
        rows.append(row)
        if isinstance(method, HuygensFresnel) and instrument.lens.model == "paraxial" and magnifies(instrument.lens):
            row["reason"] = 'needs model = "aplanatic": its paraxial model is a flat lens, unlike an objective'
            continue
        if method != exact_method:
            on_start(name)
        # Pixel integration by Huygens-Fresnel sums would take minutes.
        integrate = False if isinstance(method, HuygensFresnel) else instrument.integrate
        try:
            result, row["seconds"] = (exact, seconds) if method == exact_method else run_timed(method, integrate)
        except (ValueError, ArithmeticError, ImportError) as error:
            row["reason"] = str(error)
            continue
        row["sampling"], row["error_bound"] = result.sampling, result.error_bound
        target = exact
        if result.sampling == exact.sampling:
            answers[name] = result
        elif result.sampling == "center":
            target = compute(exact_method, False)
        row["mse"], row["peak_error"] = errors.mse(result, target), errors.peak_error(result, target)
    return rows, answers
