"""Localisation of molecules in three dimensions: movies, detection, tables of the PSF, fits by maximum likelihood."""

from lommel.detection.molecules import Spots, find
from lommel.localize.fitting import Molecules, fit
from lommel.localize.localizations import Localizations, MovieInfo, writer
from lommel.localize.movie_fits import LocalizeOptions, localize_blocks, localize_movie
from lommel.localize.table import Table
from lommel.optics.layers.objective import FocalSurface

__all__ = [
    "FocalSurface",
    "Localizations",
    "LocalizeOptions",
    "Molecules",
    "MovieInfo",
    "Spots",
    "Table",
    "find",
    "fit",
    "localize_blocks",
    "localize_movie",
    "writer",
]
