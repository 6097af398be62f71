"""Functions with the signatures of other packages, computed by lommel: change the import, keep the call."""

from typing import TYPE_CHECKING

from lommel.base import imports

if TYPE_CHECKING:
    from lommel.compat import galsim as galsim
    from lommel.compat import photutils as photutils
    from lommel.compat import psfmodels as psfmodels
else:
    __getattr__, __dir__ = imports.parts(__name__)
