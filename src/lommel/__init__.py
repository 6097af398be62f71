"""Point spread functions of defocused and aberrated lenses, exact to a tolerance you name, without an FFT."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

# Imported at once, because the function must win over the module of the same name.
from lommel.psf import PSF, Plan, psf

if TYPE_CHECKING:
    from lommel import imaging as imaging
    from lommel.aperture import CatEye, Ellipse, Mask, Spider
    from lommel.apodization import Apodization
    from lommel.fieldmap import FieldMap, PSFGrid
    from lommel.fitting import WavefrontFit, fit_opd, fit_radial, opd_map
    from lommel.grid import Grid
    from lommel.instrument import Instrument
    from lommel.lens import Lens
    from lommel.lensfile import load_instrument
    from lommel.measures.aperture_means import centroid, marechal, rms, spot_radius, strehl
    from lommel.measures.errors import mse, peak_error
    from lommel.measures.focus import best_focus
    from lommel.measures.transfer import mtf, mtf_frequency, otf, ptf
    from lommel.methods import (
        ChordalGauss,
        ClosedForm,
        Fraunhofer,
        Geometric,
        Hankel,
        HuygensFresnel,
        LommelSeries,
        MatrixFourier,
        Method,
        NijboerZernike,
        NonuniformFFT,
        Polychromatic,
        ToleranceError,
        TunedClosedForm,
    )
    from lommel.pupil import Pupil
    from lommel.special.erf import AbramowitzErf, FresnelErf, TableErf
    from lommel.wavefront import Wavefront
    from lommel.zernikefile import ZernikeTable, load_zernike, save_zernike

_HOME = {
    "FieldMap": "fieldmap",
    "PSFGrid": "fieldmap",
    "Apodization": "apodization",
    "CatEye": "aperture",
    "Ellipse": "aperture",
    "Mask": "aperture",
    "Spider": "aperture",
    "Grid": "grid",
    "Lens": "lens",
    "Instrument": "instrument",
    "load_instrument": "lensfile",
    "best_focus": "measures.focus",
    "mse": "measures.errors",
    "centroid": "measures.aperture_means",
    "marechal": "measures.aperture_means",
    "rms": "measures.aperture_means",
    "spot_radius": "measures.aperture_means",
    "strehl": "measures.aperture_means",
    "mtf": "measures.transfer",
    "mtf_frequency": "measures.transfer",
    "otf": "measures.transfer",
    "ptf": "measures.transfer",
    "peak_error": "measures.errors",
    "AbramowitzErf": "special.erf",
    "FresnelErf": "special.erf",
    "TableErf": "special.erf",
    "ChordalGauss": "methods.chordal_gauss",
    "ClosedForm": "methods.closed_form",
    "Fraunhofer": "methods.fraunhofer",
    "Geometric": "methods.geometric",
    "Hankel": "methods.hankel",
    "HuygensFresnel": "methods.huygens",
    "LommelSeries": "methods.lommel_series",
    "MatrixFourier": "methods.matrix_fourier",
    "Method": "methods.method",
    "ToleranceError": "core.answers",
    "TunedClosedForm": "methods.tuned_closed_form",
    "Polychromatic": "methods.polychromatic",
    "NijboerZernike": "methods.nijboer_zernike",
    "NonuniformFFT": "methods.nonuniform_fft",
    "Pupil": "pupil",
    "Wavefront": "wavefront",
    "WavefrontFit": "fitting",
    "fit_opd": "fitting",
    "fit_radial": "fitting",
    "opd_map": "fitting",
    "ZernikeTable": "zernikefile",
    "load_zernike": "zernikefile",
    "save_zernike": "zernikefile",
}

# Whose modules are given in full in the reference, such as lommel.show.plot.field.
_ROOMS = (
    "adapters",
    "base",
    "encircled",
    "fieldtable",
    "imaging",
    "io",
    "lensfile",
    "measures",
    "methods",
    "report",
    "show",
    "special",
    "zernikefile",
)

__all__ = [
    "PSF",
    "AbramowitzErf",
    "Apodization",
    "CatEye",
    "ChordalGauss",
    "ClosedForm",
    "Ellipse",
    "FieldMap",
    "Fraunhofer",
    "FresnelErf",
    "Geometric",
    "Grid",
    "Hankel",
    "HuygensFresnel",
    "Instrument",
    "Lens",
    "LommelSeries",
    "Mask",
    "MatrixFourier",
    "Method",
    "NijboerZernike",
    "NonuniformFFT",
    "PSFGrid",
    "Plan",
    "Polychromatic",
    "Pupil",
    "Spider",
    "TableErf",
    "ToleranceError",
    "TunedClosedForm",
    "Wavefront",
    "WavefrontFit",
    "ZernikeTable",
    "best_focus",
    "centroid",
    "fit_opd",
    "fit_radial",
    "load_instrument",
    "load_zernike",
    "marechal",
    "mse",
    "mtf",
    "mtf_frequency",
    "opd_map",
    "otf",
    "peak_error",
    "psf",
    "ptf",
    "rms",
    "save_zernike",
    "spot_radius",
    "strehl",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from lommel.base.version import version

        return version()
    if name in _ROOMS:
        return import_module(f"lommel.{name}")
    if name not in _HOME:
        raise AttributeError(f"module 'lommel' has no attribute {name!r}")
    value = getattr(import_module(f"lommel.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*__all__, *_ROOMS, "__version__", *(name for name in globals() if name.startswith("__"))})
