"""What the command line's tables show, as plain data."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

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


def describe_lens(instrument: Instrument) -> dict[str, Any]:
    """Return what there is to say about a lens and its object without computing an image.

    Lengths in metres (None for infinity), phases in radians, energies as fractions of all light, frequencies in
    cycles per metre along x. Each encircled energy stands beside that of the same aperture in focus and without
    aberration; see :func:`lommel.measures.energy.encircled`, which refuses wide circles where the pupil is not
    radially symmetric: these are None. "encircled_energy_error" bounds the error of all, None where the method has no
    bound or the pupil is radial, whose energies are within 1e-6. The "fwhm" is the mean of those along x and y.
    "mtf_at_nyquist" is that of the lens, "mtf_at_nyquist_with_pixel" that of the lens and of pixels that average;
    they and "mtf50" are None for an aperture that is not round. "field" is None, or what the wavefront is at some
    places between the axis and the corner of the sensor; all else is then that of the axis. "other_model" is what
    :func:`other_model` says. What cannot be computed is None, too, for the reasons in "refused".
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
    sensor: dict[str, Any] = {"pixel": instrument.pixel, "fill": instrument.fill}
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


def _field(instrument: Instrument) -> dict[str, Any]:
    """Return what there is to say of the field, from the axis to a corner of the sensor."""
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


def _terms(terms: dict[tuple[int, int], Any]) -> list[dict[str, Any]]:
    return [
        {"n": n, "m": m, "name": zernike.name(n, m), "waves_rms": float(c)}
        for (n, m), c in sorted(terms.items(), key=_noll)
    ]


def other_model(instrument: Instrument) -> dict[str, Any]:
    """Return what the other model of the lens would change: what paraxial costs, or aplanatic gains.

    "model" and "corrected_for" of it (for the focus where the lens magnifies, as of an objective: its sensor is in
    place and its object is not), its "geometric_radius" in metres, and "peak_error", the largest difference of the
    two PSFs in the window over the peak of the aplanatic one. Or None, and the "reason".
    """
    lens = instrument.lens
    model = "aplanatic" if lens.model == "paraxial" else "paraxial"
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


def describe_psf(answer: PSF, seconds: float) -> dict[str, Any]:
    """Return what there is to say about a computed PSF.

    "sum" is that of all values where these are fractions of the light and sample pixels too wide for it to be the
    light in the window, else None. "wide_enough" is the side of a window that holds some 98 % of the light, where
    this one does not hold 95 % and is smaller, else None.
    """
    energy, side = float(answer.energy), wide_enough(lens_pupil(answer.pupil), min(answer.grid.pitch))
    return how_made(answer, seconds) | {
        "wide_enough": side if energy < 0.95 and min(answer.shape) < side else None,
        "energy": energy,
    }


def describe_field(instrument: Instrument, grid: PSFGrid, seconds: float) -> dict[str, Any]:
    """Return what there is to say about PSFs over the field: lengths in metres, one entry for each of the grid."""
    place = {"sensor": list(grid.sensor), "x": grid.x.tolist(), "y": grid.y.tolist()}
    answer: Any = checked(grid.psf)
    energy = {"energy": np.asarray(answer.energy).tolist()}
    return {"name": instrument.name, "source": instrument.source} | place | energy | how_made(answer, seconds)


def describe_mtf(
    instrument: Instrument, grid: PSFGridLike | None = None, channels: Channels | None = None
) -> dict[str, Any]:
    """Return the MTF at the Nyquist frequency of the pixels and at half of it, of the lens and of averaging pixels.

    "frequency" is Nyquist's along x and y, cycles per metre. "rows" has, for each place of a `grid` (or that of the
    file, whose "x" and "y" are None) and each of the `channels` (or the wavelength of the file, whose "channel" is
    None), "nyquist" and "half_nyquist", both along x and y. From the wavefront, to 1e-6.

    ValueError for an aperture with a mask.
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
    sensor: dict[str, Any] = {"pixel": instrument.pixel, "fill": instrument.fill, "tol": 1e-6}
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


def how_made(answer: PSFLike, seconds: float) -> dict[str, Any]:
    """Return what there is to say about values and how they were made, sums and peaks for each of a stack."""
    # Fractions of the light that sample too far apart are none.
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
) -> tuple[list[dict[str, Any]], dict[str, PSF]]:
    """Compute one lens by several methods and judge each by the `reference` for its pupil.

    Returns
    -------
    rows : list of dict
        For each method: name, options, seconds, mse and peak_error (:mod:`lommel.measures.errors`), error_bound,
        sampling, and reason, which is None or says why the method does not apply.
    answers : dict of str to PSF
        Those that could be computed on the pixels of the instrument, in float64, by the method's name; the reference
        first, by its `reference_name`. Wavelets are summed at the centres of pixels only, since averages of
        `HuygensFresnel` would take minutes, and judged by samples of the reference: they are not among these.
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
        row: dict[str, Any] = {"method": name, "options": method.to_dict(), "reason": None}
        row |= dict.fromkeys(("seconds", "mse", "peak_error", "error_bound", "sampling"))
        rows.append(row)
        if method == judge:
            row |= {"seconds": seconds, "mse": 0.0, "peak_error": 0.0}
            row |= {"error_bound": truth.error_bound, "sampling": truth.sampling}
            continue
        if isinstance(method, HuygensFresnel) and instrument.lens.model == "paraxial" and _magnifies(instrument.lens):
            row["reason"] = (
                'needs model = "aplanatic" here: it takes a paraxial lens for a flat one, as no objective is'
            )
            continue
        started(name)
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
    """Return the second of two runs and its seconds: the first loads libraries and fills caches.

    Of what takes longer than a second there is no second.
    """
    for _ in range(2):
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
"""Told beside the depth of the file, metres."""


def describe_microscope(microscope: Microscope, *, foci: bool = True) -> dict[str, Any]:
    """Return what there is to say about a microscope without computing an image.

    Lengths in metres, angles in radians; x and y in the sample but for "pixel", which is on the camera, z of the
    stage. "focus" has a row for each depth: "paraxial" and "brightest" are how far the objective has been driven
    towards the sample since the surface of the cover glass was in focus, "ratio" the depth over the brightest (None
    at depth 0), "peak" the intensity there and "peak_of_surface" the same over that at depth 0, "collected" the
    light that the objective takes in over that of an emitter far from the glass. All of an emitter that turns
    freely, whatever the file has; without `foci`, which take longer than a stack, it is empty. "nyquist" has the
    coarsest steps that keep all of an image, and "too_coarse" the names of those that are exceeded, "pixel" or
    "step". Depths that cannot be reached are left out, for the reasons in "refused".
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
    """Return the foci of several depths, and why others have none."""
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


def describe_stack(answer: PSF, seconds: float) -> dict[str, Any]:
    """Return what there is to say about a computed stack of planes, or about one plane.

    "z", "focus", "peak" and "energy" have a number for each plane, metres of the stage and shares of the light;
    "brightest" is the index of the plane with the largest value, None for a single plane.
    """
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
    """Return what sends light, or is focused into the sample."""
    emitter = microscope.emitter
    if isinstance(emitter, Dipole):
        if emitter.wobble == 1.0:
            return "turns freely"
        place = (
            f"{math.degrees(emitter.polar):.4g} deg from the axis, azimuth {math.degrees(emitter.azimuth):.4g} deg"
        )
        return f"dipole, {place}" + (f", wobble {emitter.wobble:.4g}" if emitter.wobble else "")
    if isinstance(emitter, Scalar):
        return "scalar, as of Gibson and Lanni"
    return f"a beam focused into the sample, {emitter.polarization} polarisation"


def _layer(layer: Layer | None) -> dict[str, float] | None:
    return None if layer is None else {"index": layer.index, "thickness": layer.thickness}
