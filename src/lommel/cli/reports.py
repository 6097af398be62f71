"""Descriptions of lenses, microscopes and PSFs as plain data, for tables and JSON."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from lommel.channel_psf import ColourPSF
from lommel.cli.options import Facts
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
from lommel.special import zernike

_OF_LENS = ("focal_length", "aperture_diameter", "f_number", "working_f_number", "obscuration", "wavelength")


def describe_lens(instrument: Instrument) -> Facts:
    """Return the description of a lens and its object; None for infinity and for what cannot be computed.

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

    nothing: list[None] = [None] * len(at)
    seen, error = known(lambda: _energies(pupil, at)) or (nothing, None)
    ideal, other_error = known(lambda: _energies(pupil.unaberrated(), at)) or (nothing, None)
    # Along columns, whose pitch is the width of a pixel.
    nyquist, round_ = 0.5 / instrument.pitch[1], pupil.circular
    sensor: Facts = {"pixel": instrument.pixel, "fill": instrument.fill}
    return {
        "name": instrument.name,
        "source": instrument.source,
        **{name: getattr(lens, name) for name in _OF_LENS},
        "model": lens.model,
        "corrected_for": lens.corrected_for,
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
        "mtf50": known(lambda: float(transfer.mtf_frequency(pupil))) if round_ else None,
        "nyquist": nyquist,
        "mtf_at_nyquist": known(lambda: float(transfer.mtf(pupil, nyquist))) if round_ else None,
        "mtf_at_nyquist_with_pixel": (
            known(lambda: float(transfer.mtf(pupil, nyquist, **sensor))) if round_ else None
        ),
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


def _terms(terms: dict[tuple[int, int], Any]) -> list[Facts]:
    return [
        {"n": n, "m": m, "name": zernike.name(n, m), "waves_rms": float(c)}
        for (n, m), c in sorted(terms.items(), key=_noll)
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


def describe_psf(answer: PSF, seconds: float) -> Facts:
    """Return the description of a PSF; "wide_enough" is a window for 98 % of the light if this has under 95 %."""
    energy, side = float(answer.energy), wide_enough(lens_pupil(answer.pupil), min(answer.grid.pitch))
    return how_made(answer, seconds) | {
        "wide_enough": side if energy < 0.95 and min(answer.shape) < side else None,
        "energy": energy,
    }


def describe_field(instrument: Instrument, grid: PSFGrid, seconds: float) -> Facts:
    """Return the description of PSFs over the field, with one entry for each PSF of the grid."""
    place = {"sensor": list(grid.sensor), "x": grid.x.tolist(), "y": grid.y.tolist()}
    answer: Any = checked(grid.psf)
    energy = {"energy": np.asarray(answer.energy).tolist()}
    return {"name": instrument.name, "source": instrument.source} | place | energy | how_made(answer, seconds)


def describe_colour(instrument: Instrument, answer: ColourPSF, seconds: float) -> Facts:
    """Return the description of PSFs in colour channels, with the peak and the energy of each channel."""
    each = [
        {
            "name": name,
            "wavelengths": [w for w, _ in pairs],
            "weights": [share for _, share in pairs],
            "light": light,
            "peak": float(one.values.max()),
            "energy": float(one.values.sum(axis=(-2, -1), dtype=float).mean())
            if answer.normalize == "energy"
            else None,
        }
        for (name, pairs), light, one in zip(answer.channels, answer.channels.light, answer, strict=True)
    ]
    made = how_made(answer[0], seconds)
    return {
        "name": instrument.name,
        "source": instrument.source,
        **{name: made[name] for name in ("sampling", "pixel", "dtype", "normalize", "seconds")},
        "shape": list(answer.shape),
        "error_bound": answer.error_bound,
        "of_spectra": answer.channels.error,
        "channels": each,
    }


def describe_mtf(instrument: Instrument, grid: PSFGridLike | None = None, channels: Channels | None = None) -> Facts:
    """Return the MTF, pixel included, at the Nyquist frequency and at half of it, along x and y.

    One row for each place of a `grid` and each of the `channels`, or for the axis and the wavelength of the file.
    """
    nyquist = tuple(0.5 / side for side in instrument.pitch[::-1])
    fx, fy = np.array([nyquist[0], 0.0]), np.array([0.0, nyquist[1]])
    at = {"nyquist": 1.0, "half_nyquist": 0.5}
    places: list[tuple[float | None, float | None, Pupil]] = [(None, None, instrument.pupil())]
    if grid is not None:
        field = instrument.field()
        places = [(x, y, field.pupil(x, y)) for y in grid.y.tolist() for x in grid.x.tolist()]
    lights: list[tuple[str | None, Polychromatic | None]] = [] if channels else [(None, None)]
    for name, pairs in channels or ():
        lights.append((name, Polychromatic([w for w, _ in pairs], [share for _, share in pairs])))
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
    return {"frequency": list(nyquist), "rows": rows}


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
        if method == judge:
            row |= {"seconds": seconds, "mse": 0.0, "peak_error": 0.0}
            row |= {"error_bound": truth.error_bound, "sampling": truth.sampling}
            continue
        if isinstance(method, HuygensFresnel) and instrument.lens.model == "paraxial" and _magnifies(instrument.lens):
            row["reason"] = 'needs model = "aplanatic": its paraxial model is a flat lens, unlike any objective'
            continue
        started(name)
        # Its sums over the area of every pixel would take minutes.
        integrate = False if isinstance(method, HuygensFresnel) else instrument.integrate
        try:
            found, row["seconds"] = timed(partial(answer, method, integrate))
        except (ValueError, ArithmeticError, ImportError) as error:
            row["reason"] = str(error)
            continue
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


def _noll(item: tuple[tuple[int, int], Any]) -> int:
    return int(zernike.index_of(*item[0], "noll"))


def _finite(value: float) -> float | None:
    return None if math.isinf(value) else value


DEPTHS = (0.0, 1e-6, 5e-6, 20e-6, 50e-6)
"""Depths that are listed besides that of the file, metres."""


def describe_microscope(microscope: Microscope, *, foci: bool = True) -> Facts:
    """Return the description of a microscope; with `foci`, a row for each depth of a freely rotating dipole.

    Lengths in metres: x and y in the sample, z of the stage, "pixel" on the camera. Angles in radians.
    """
    objective, wavelength = microscope.objective, microscope.wavelength
    nyquist, glass = objective.nyquist(wavelength=wavelength), objective.coverslip
    rows, refused = _foci(microscope) if foci else ([], [])
    step = abs(microscope.step) if microscope.planes > 1 else None
    coarse = {"pixel": microscope.pixel > nyquist.pixel, "step": step is not None and step > nyquist.axial}
    design = objective.design
    as_designed = design.immersion == objective.immersion and design.coverslip == glass
    return {
        "name": microscope.name,
        "source": microscope.source,
        "NA": objective.NA,
        "magnification": objective.magnification,
        "working_distance": objective.working_distance,
        "immersion": objective.immersion,
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


def describe_stack(answer: PSF, seconds: float) -> Facts:
    """Return the description of a stack of planes, or of one plane, whose "brightest" is None."""
    pupil: Any = answer.pupil
    peaks = answer.values.max(axis=(-2, -1))
    return how_made(answer, seconds) | {
        "pixel_in_sample": answer.pixel / pupil.magnification,
        "z": pupil.z.tolist(),
        "focus": pupil.focus.tolist(),
        "energy": np.asarray(answer.energy).tolist(),
        "brightest": int(peaks.argmax()) if pupil.shape else None,
    }


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
