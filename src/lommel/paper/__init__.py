"""The paper this package began with: its methods and error functions, and (`figures`) its figures and numbers."""

from lommel.methods.paper.closed_form import ClosedForm, TunedClosedForm
from lommel.methods.paper.fraunhofer import Fraunhofer
from lommel.methods.paper.geometric import Geometric
from lommel.methods.paper.huygens import HuygensFresnel
from lommel.methods.paper.lommel_series import LommelSeries
from lommel.special.erf import AbramowitzErf, FresnelErf, TableErf

__all__ = [
    "AbramowitzErf",
    "ClosedForm",
    "Fraunhofer",
    "FresnelErf",
    "Geometric",
    "HuygensFresnel",
    "LommelSeries",
    "TableErf",
    "TunedClosedForm",
]
