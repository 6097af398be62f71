"""Point spread functions of defocused and aberrated lenses, exact to a tolerance you name, without an FFT."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

# Imported at once, because the function must win over the module of the same name.
from lommel.psf import PSF, Plan, psf

if TYPE_CHECKING:
    from lommel import imaging as imaging
    from lommel.field.maps import FieldMap
    from lommel.field.psf_grid import PSFGrid
    from lommel.lensfiles.instrument import Instrument
    from lommel.lensfiles.lens_files import load_instrument
    from lommel.lensfiles.zernike_files import load_zernike, save_zernike
    from lommel.lensfiles.zernike_tables import ZernikeTable
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
    from lommel.optics.aperture import CatEye, Ellipse, Mask, Spider
    from lommel.optics.apodization import Apodization
    from lommel.optics.fitting import WavefrontFit, fit_opd, fit_radial, opd_map
    from lommel.optics.grid import Grid
    from lommel.optics.lens import Lens
    from lommel.optics.pupil import Pupil
    from lommel.optics.wavefront import Wavefront
    from lommel.special.erf import AbramowitzErf, FresnelErf, TableErf

_HOME = {
    "FieldMap": "field.maps",
    "PSFGrid": "field.psf_grid",
    "Apodization": "optics.apodization",
    "CatEye": "optics.aperture",
    "Ellipse": "optics.aperture",
    "Mask": "optics.aperture",
    "Spider": "optics.aperture",
    "Grid": "optics.grid",
    "Lens": "optics.lens",
    "Instrument": "lensfiles.instrument",
    "load_instrument": "lensfiles.lens_files",
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
    "Pupil": "optics.pupil",
    "Wavefront": "optics.wavefront",
    "WavefrontFit": "optics.fitting",
    "fit_opd": "optics.fitting",
    "fit_radial": "optics.fitting",
    "opd_map": "optics.fitting",
    "ZernikeTable": "lensfiles.zernike_tables",
    "load_zernike": "lensfiles.zernike_files",
    "save_zernike": "lensfiles.zernike_files",
}

# Whose modules are given in full in the reference, such as lommel.show.plot.field.
_ROOMS = (
    "adapters",
    "base",
    "field",
    "imaging",
    "io",
    "lensfiles",
    "measures",
    "methods",
    "optics",
    "reports",
    "show",
    "special",
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
