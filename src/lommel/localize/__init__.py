"""Localisation of molecules in three dimensions: movies, detection, fits, tables of molecules."""

from lommel.localize.detection import Spots, find
from lommel.localize.movies import Movie, MovieError, open_movie

__all__ = ["Movie", "MovieError", "Spots", "find", "open_movie"]
