"""Point spread functions of defocused and aberrated lenses, exact to a tolerance you name, without an FFT."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

# Imported at once, because the function must win over the module of the same name.
from lommel.psf import PSF, Plan, psf

if TYPE_CHECKING:
    from lommel.quality import centroid, marechal, rms, spot_radius, strehl
    from lommel.grid import Grid
    from lommel.lens import Lens
    from lommel.lensfile import Instrument, load_instrument
    from lommel.methods import (
        ClosedForm,
        Fraunhofer,
        Geometric,
        Hankel,
        HuygensFresnel,
        LommelSeries,
        Method,
        NijboerZernike,
        Polychromatic,
        ToleranceError,
        TunedClosedForm,
    )
    from lommel.metrics import best_focus, mse, peak_error
    from lommel.pupil import Pupil
    from lommel.special.erf import AbramowitzErf, FresnelErf, TableErf
    from lommel.transfer import mtf, mtf_frequency, otf, ptf
    from lommel.wavefront import Wavefront

_HOME = {
    "Grid": "grid",
    "Lens": "lens",
    "Instrument": "lensfile",
    "load_instrument": "lensfile",
    "best_focus": "metrics",
    "mse": "metrics",
    "centroid": "quality",
    "marechal": "quality",
    "rms": "quality",
    "spot_radius": "quality",
    "strehl": "quality",
    "mtf": "transfer",
    "mtf_frequency": "transfer",
    "otf": "transfer",
    "ptf": "transfer",
    "peak_error": "metrics",
    "AbramowitzErf": "special.erf",
    "FresnelErf": "special.erf",
    "TableErf": "special.erf",
    "ClosedForm": "methods.closed_form",
    "Fraunhofer": "methods.fraunhofer",
    "Geometric": "methods.geometric",
    "Hankel": "methods.hankel",
    "HuygensFresnel": "methods.huygens",
    "LommelSeries": "methods.lommel_series",
    "Method": "methods.method",
    "ToleranceError": "methods.method",
    "TunedClosedForm": "methods.tuned_closed_form",
    "Polychromatic": "methods.polychromatic",
    "NijboerZernike": "methods.nijboer_zernike",
    "Pupil": "pupil",
    "Wavefront": "wavefront",
}

__all__ = [
    "PSF",
    "AbramowitzErf",
    "ClosedForm",
    "Fraunhofer",
    "FresnelErf",
    "Geometric",
    "Grid",
    "Hankel",
    "HuygensFresnel",
    "Instrument",
    "Lens",
    "LommelSeries",
    "Method",
    "NijboerZernike",
    "Plan",
    "Polychromatic",
    "Pupil",
    "TableErf",
    "ToleranceError",
    "TunedClosedForm",
    "Wavefront",
    "best_focus",
    "centroid",
    "load_instrument",
    "marechal",
    "mse",
    "mtf",
    "mtf_frequency",
    "otf",
    "peak_error",
    "psf",
    "ptf",
    "rms",
    "spot_radius",
    "strehl",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("lommel")
    if name not in _HOME:
        raise AttributeError(f"module 'lommel' has no attribute {name!r}")
    value = getattr(import_module(f"lommel.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, "__version__"})
