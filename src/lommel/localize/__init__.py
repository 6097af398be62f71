"""Localisation of molecules in three dimensions: movies, detection, fits, tables of molecules."""

from lommel.localize.detection import Spots, find
from lommel.localize.localizations import Localizations, writer
from lommel.localize.molecule_files import Recording
from lommel.localize.movies import Movie, MovieError, open_movie

__all__ = ["Localizations", "Movie", "MovieError", "Recording", "Spots", "find", "open_movie", "writer"]
