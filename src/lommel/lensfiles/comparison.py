"""Methods compared for the PSF of a lens: their errors against a reference, and their times."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from lommel.lensfiles.image_quality import magnifies
from lommel.measures import errors
from lommel.methods import HuygensFresnel, Method
from lommel.methods.choice import reference
from lommel.psf import PSF, psf

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Instrument


def compare_methods(
    instrument: Instrument, methods: Iterable[Method], started: Callable[[str], object] = str
) -> tuple[list[dict[str, Any]], dict[str, PSF]]:
    """Return the errors and times of several methods against the `reference`, and the PSFs of those that apply.

    The PSF of the reference comes first, called "Hankel" or by name and tolerance. Those on other samples than it has
    are left out.
    """
    pupil = instrument.pupil()
    judge = reference(pupil)
    judge_name = type(judge).__name__ if pupil.radial else repr(judge)

    def answer(method: Method, integrate: bool | None) -> PSF:
        window, pixel = instrument.window, instrument.pixel
        fill = 1.0 if integrate is False else instrument.fill
        return psf(pupil, window, pixel, method=method, dtype="float64", integrate=integrate, fill=fill)

    def timed(method: Method, integrate: bool | None) -> tuple[PSF, float]:
        """Return the PSF and the seconds of the second of two runs, or of a first that takes more than a second."""
        for _ in range(2):  # the first one loads libraries and fills caches
            start = time.perf_counter()
            found = answer(method, integrate)
            seconds = time.perf_counter() - start
            if seconds > 1.0:
                break
        return found, seconds

    started(judge_name)
    truth, seconds = timed(judge, instrument.integrate)
    answers, rows = {judge_name: truth}, []
    for method in methods:
        name = type(method).__name__
        row: dict[str, Any] = {"method": name, "options": method.to_dict(), "reason": None}
        row |= dict.fromkeys(("seconds", "mse", "peak_error", "error_bound", "sampling"))
        rows.append(row)
        if isinstance(method, HuygensFresnel) and instrument.lens.model == "paraxial" and magnifies(instrument.lens):
            row["reason"] = 'needs model = "aplanatic": its paraxial model is a flat lens, unlike any objective'
            continue
        if method != judge:
            started(name)
        # Its sums over the area of every pixel would take minutes.
        integrate = False if isinstance(method, HuygensFresnel) else instrument.integrate
        try:
            found, row["seconds"] = (truth, seconds) if method == judge else timed(method, integrate)
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
