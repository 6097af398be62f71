"""Registry of all methods, by class name and by the names of the command line."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from lommel.core.answers import ToleranceError
from lommel.methods.chordal_gauss import ChordalGauss
from lommel.methods.hankel import Hankel
from lommel.methods.layers.chordal_debye import ChordalDebye
from lommel.methods.layers.debye_rings import DebyeRings
from lommel.methods.layers.debye_wolf import DebyeWolf
from lommel.methods.layers.scanning import Bead, Confocal, Sted, TwoPhoton
from lommel.methods.layers.stratified import Stratified
from lommel.methods.matrix_fourier import MatrixFourier
from lommel.methods.method import FieldMethod, Method, RadialMethod
from lommel.methods.nijboer_zernike import NijboerZernike
from lommel.methods.nonuniform_fft import NonuniformFFT
from lommel.methods.paper.closed_form import ClosedForm, TunedClosedForm
from lommel.methods.paper.fraunhofer import Fraunhofer
from lommel.methods.paper.geometric import Geometric
from lommel.methods.paper.huygens import HuygensFresnel
from lommel.methods.paper.lommel_series import LommelSeries
from lommel.methods.polychromatic import Polychromatic
from lommel.special.erf import AbramowitzErf, FresnelErf, TableErf


def _by_command_name(*kinds: type[Method]) -> dict[str, type[Method]]:
    """Return methods by their names in the command line, such as nijboer-zernike for NijboerZernike."""
    return {re.sub("(?<=[a-z])(?=[A-Z])", "-", kind.__name__).lower(): kind for kind in kinds}


METHODS = _by_command_name(
    NijboerZernike,
    Hankel,
    LommelSeries,
    HuygensFresnel,
    Fraunhofer,
    MatrixFourier,
    NonuniformFFT,
    ClosedForm,
    TunedClosedForm,
    Geometric,
    ChordalGauss,
)
"""Methods for the pupils of lenses, by the names in the command line."""

LAYERED = _by_command_name(Stratified, ChordalDebye, DebyeRings, DebyeWolf)
"""Methods for the pupils of objectives, by the names in the command line."""

_SUMS = _by_command_name(Polychromatic, Bead, Confocal, TwoPhoton, Sted)  # methods that combine other images

ERFS: dict[str, type[AbramowitzErf | TableErf | FresnelErf]] = {
    "abramowitz": AbramowitzErf,
    "table": TableErf,
    "fresnel": FresnelErf,
}
"""Error functions of `ClosedForm`, by the names in the command line."""


def method_from_dict(description: Mapping[str, object]) -> Method:
    """Rebuild a method from a `description` by :meth:`~lommel.methods.Method.to_dict`.

    Parameters
    ----------
    description : dict

    Returns
    -------
    Method

    Raises
    ------
    ValueError
        If the name is unknown, or is not the name of a method.
    """
    kinds = [*METHODS.values(), *LAYERED.values(), *_SUMS.values(), *ERFS.values()]
    constructors: dict[object, Callable[..., object]] = {kind.__name__: kind for kind in kinds}

    def build(part: Mapping[str, object]) -> object:
        nested = {key: build(value) for key, value in part.items() if isinstance(value, dict) and "name" in value}
        options = {**part, **nested}
        name = options.pop("name")
        if name not in constructors:
            raise ValueError(f"unknown method {name!r}; known are {', '.join(sorted(map(str, constructors)))}")
        # JSON has no tuples, but options must be tuples, which are hashable.
        return constructors[name](**{k: tuple(v) if isinstance(v, list) else v for k, v in options.items()})

    method = build(description)
    if not isinstance(method, Method):
        raise ValueError(f"{description['name']!r} is not a method")
    return method


__all__ = [
    "ERFS",
    "LAYERED",
    "METHODS",
    "Bead",
    "ChordalDebye",
    "ChordalGauss",
    "Confocal",
    "DebyeRings",
    "DebyeWolf",
    "FieldMethod",
    "Hankel",
    "MatrixFourier",
    "Method",
    "NijboerZernike",
    "NonuniformFFT",
    "Polychromatic",
    "RadialMethod",
    "Sted",
    "Stratified",
    "ToleranceError",
    "TwoPhoton",
    "method_from_dict",
]
