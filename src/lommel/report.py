"""What the command line's tables show, as plain data."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from lommel import metrics, quality, spot, transfer
from lommel.lensfile import Instrument
from lommel.methods import Hankel, Method, NijboerZernike
from lommel.psf import PSF, psf
from lommel.units import format_length


def describe_lens(instrument: Instrument) -> dict[str, Any]:
    """Return what there is to say about a lens and its object without computing an image.

    Lengths in metres (None for infinity), phases in radians, energies as fractions of all light, frequencies in
    cycles per metre along x. Each encircled energy stands beside that of the same aperture in focus and without
    aberration. "mtf_at_nyquist" is that of the lens, "mtf_at_nyquist_with_pixel" that of the lens and of pixels that
    average; "fwhm" is None for a pupil that is not radial.
    """
    lens, pupil = instrument.lens, instrument.pupil()
    radii = dict(instrument.radii)
    airy, blur = pupil.airy_radius, float(pupil.geometric_radius())
    radii.setdefault("Airy radius", airy)
    if blur > 0:
        radii.setdefault("geometric blur radius", blur)
    way = NijboerZernike()
    at = list(radii.values())
    seen, ideal = (np.atleast_1d(metrics.radial_energy(way, p, at)) for p in (pupil, pupil.unaberrated()))
    return {
        "name": instrument.name,
        "source": instrument.source,
        "focal_length": lens.focal_length,
        "aperture_diameter": lens.aperture_diameter,
        "f_number": lens.f_number,
        "working_f_number": lens.working_f_number,
        "obscuration": lens.obscuration,
        "wavelength": lens.wavelength,
        "focus_distance": _finite(lens.focus_distance),
        "sensor_distance": lens.sensor_distance,
        "object_distance": _finite(instrument.object_distance),
        "pixel": instrument.pixel,
        "defocus": float(pupil.wavefront.defocus),
        "spherical": float(pupil.wavefront.spherical),
        "higher": [float(c) for c in pupil.wavefront.higher],
        "waves": {name: float(value) for name, value in pupil.wavefront.waves.items()},
        "airy_radius": airy,
        "geometric_radius": blur,
        "strehl": float(quality.strehl(pupil)),
        "marechal": float(quality.marechal(pupil)),
        "rms_waves": float(quality.rms(pupil, unit="waves")),
        "fwhm": float(spot.radial_fwhm(way, pupil)) if pupil.radial else None,
        "cutoff": pupil.cutoff,
        "mtf50": float(transfer.mtf_frequency(pupil)),
        "nyquist": 0.5 / instrument.pixel,
        "mtf_at_nyquist": float(transfer.mtf(pupil, 0.5 / instrument.pixel)),
        "mtf_at_nyquist_with_pixel": float(transfer.mtf(pupil, 0.5 / instrument.pixel, pixel=instrument.pixel)),
        "encircled_energy": [
            {"within": name, "radius": radius, "fraction": float(a), "unaberrated": float(b)}
            for (name, radius), a, b in zip(radii.items(), seen, ideal, strict=True)
        ],
    }


def describe_psf(answer: PSF, seconds: float) -> dict[str, Any]:
    """Return what there is to say about a computed PSF."""
    return {
        "method": answer.method.to_dict(),
        "sampling": answer.sampling,
        "shape": list(answer.shape),
        "pixel": answer.pixel,
        "dtype": str(answer.values.dtype),
        "normalize": answer.normalize,
        "peak": float(answer.values.max()),
        "energy": float(answer.energy),
        "error_bound": answer.error_bound,
        "seconds": seconds,
    }


def compare(
    instrument: Instrument, methods: Iterable[Method], started: Callable[[str], object] = str
) -> tuple[list[dict[str, Any]], dict[str, PSF]]:
    """Compute one lens by several methods and judge each by `Hankel`.

    Returns
    -------
    rows : list of dict
        For each method: name, options, seconds, mse and peak_error (Eq. of :mod:`lommel.metrics`), error_bound,
        and reason, which is None or says why the method does not apply.
    answers : dict of str to PSF
        Those that could be computed, in float64, by the method's name; "Hankel" first.
    """
    pupil = instrument.pupil()

    def answer(method: Method) -> PSF:
        return psf(pupil, instrument.shape, instrument.pixel, method=method, dtype="float64")

    started("Hankel")
    reference, seconds = timed(lambda: answer(Hankel()))
    answers = {"Hankel": reference}
    rows = []
    for method in methods:
        name = type(method).__name__
        row: dict[str, Any] = {"method": name, "options": method.to_dict(), "reason": None}
        row |= dict.fromkeys(("seconds", "mse", "peak_error", "error_bound"))
        rows.append(row)
        if isinstance(method, Hankel):
            row |= {"seconds": seconds, "mse": 0.0, "peak_error": 0.0, "error_bound": reference.error_bound}
            continue
        started(name)
        try:
            found, row["seconds"] = timed(lambda method=method: answer(method))  # type: ignore[misc]
        except (ValueError, ArithmeticError) as error:
            row["reason"] = str(error)
            continue
        answers[name] = found
        row["mse"] = metrics.mse(found, reference)
        row["peak_error"] = metrics.peak_error(found, reference)
        row["error_bound"] = found.error_bound
    return rows, answers


def timed(work: Callable[[], PSF]) -> tuple[PSF, float]:
    """Return the second of two runs and its seconds: the first loads libraries and fills caches."""
    work()
    start = time.perf_counter()
    answer = work()
    return answer, time.perf_counter() - start


def _finite(value: float) -> float | None:
    return None if math.isinf(value) else value


def length_or_infinity(metres: float | None) -> str:
    """Return a length for a table; None stands for infinity."""
    return "infinity" if metres is None else format_length(metres)
