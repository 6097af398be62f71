"""Every method by its name."""

from __future__ import annotations

from typing import Any

from lommel.core.answers import ToleranceError
from lommel.methods.chordal_gauss import ChordalGauss
from lommel.methods.hankel import Hankel
from lommel.methods.layers.bead import Bead
from lommel.methods.layers.debye_rings import DebyeRings
from lommel.methods.layers.debye_wolf import DebyeWolf
from lommel.methods.layers.depletion import Sted
from lommel.methods.layers.scanning import Confocal, TwoPhoton
from lommel.methods.layers.stratified import Stratified
from lommel.methods.matrix_fourier import MatrixFourier
from lommel.methods.method import FieldMethod, Method, RadialMethod
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.nonuniform_fft import NonuniformFFT
from lommel.methods.paper.closed_form import ClosedForm
from lommel.methods.paper.fraunhofer import Fraunhofer
from lommel.methods.paper.geometric import Geometric
from lommel.methods.paper.huygens import HuygensFresnel
from lommel.methods.paper.lommel_series import LommelSeries
from lommel.methods.paper.tuned_closed_form import TunedClosedForm
from lommel.methods.polychromatic import Polychromatic
from lommel.special.erf import AbramowitzErf, FresnelErf, TableErf

METHODS: dict[str, type[Method]] = {
    "nijboer-zernike": NijboerZernike,
    "hankel": Hankel,
    "lommel-series": LommelSeries,
    "huygens-fresnel": HuygensFresnel,
    "fraunhofer": Fraunhofer,
    "matrix-fourier": MatrixFourier,
    "nonuniform-fft": NonuniformFFT,
    "closed-form": ClosedForm,
    "tuned-closed-form": TunedClosedForm,
    "geometric": Geometric,
    "chordal-gauss": ChordalGauss,
}
"""Every method for the pupils of lenses, by the name the command line uses."""

LAYERED: dict[str, type[Method]] = {"stratified": Stratified, "debye-rings": DebyeRings, "debye-wolf": DebyeWolf}
"""Those for the pupils of objectives."""

_MADE: tuple[type[Method], ...] = (Polychromatic, Bead, Confocal, TwoPhoton, Sted)
"""Those that are made of the answers of others."""

ERFS: dict[str, type[Any]] = {"abramowitz": AbramowitzErf, "table": TableErf, "fresnel": FresnelErf}
"""The error functions of `ClosedForm` by the name the command line uses."""


def method_from_dict(description: dict[str, Any]) -> Method:
    """Rebuild a method from :meth:`Method.to_dict`.

    Parameters
    ----------
    description : dict

    Returns
    -------
    Method

    Raises
    ------
    ValueError
        If its name is unknown, or that of something else.
    """
    kinds: list[type[Any]] = [*METHODS.values(), *LAYERED.values(), *_MADE, *ERFS.values()]
    known = {kind.__name__: kind for kind in kinds}

    def build(part: dict[str, Any]) -> Any:
        nested = {key: build(value) for key, value in part.items() if isinstance(value, dict) and "name" in value}
        options = part | nested
        name = options.pop("name")
        if name not in known:
            raise ValueError(f"unknown method {name!r}; known are {', '.join(sorted(known))}")
        return known[name](**{k: tuple(v) if isinstance(v, list) else v for k, v in options.items()})

    method = build(description)
    if not isinstance(method, Method):
        raise ValueError(f"{description['name']!r} is not a method")
    return method


__all__ = [
    "ERFS",
    "LAYERED",
    "METHODS",
    "Bead",
    "ChordalGauss",
    "ClosedForm",
    "Confocal",
    "DebyeRings",
    "DebyeWolf",
    "FieldMethod",
    "Fraunhofer",
    "Geometric",
    "Hankel",
    "HuygensFresnel",
    "LommelSeries",
    "MatrixFourier",
    "Method",
    "NijboerZernike",
    "NonuniformFFT",
    "Polychromatic",
    "RadialMethod",
    "Sted",
    "Stratified",
    "ToleranceError",
    "TunedClosedForm",
    "TwoPhoton",
    "method_from_dict",
]
