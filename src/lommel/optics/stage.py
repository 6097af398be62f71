"""The layers of a microscope as its stage moves: how far it may go, and what light passes through then."""

from __future__ import annotations

from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.optics import foci
from lommel.optics.layer import DEPTH_MOST, Design, Layer, depths, heights
from lommel.optics.stratified import Layers


class Stage:
    """What :class:`lommel.Objective` knows of its layers: these are its attributes."""

    NA: float
    immersion: float
    working_distance: float | None
    coverslip: Layer | None
    sample: float
    films: tuple[Layer, ...]
    design: Design

    @property
    def _clearance(self) -> float:
        """How much immersion there is with the surface of the cover glass in focus, metres."""
        if self.working_distance is None:  # and no other layer that it depends on
            return DEPTH_MOST
        length = self.working_distance / self.design.immersion
        for glass, sign in ((self.design.coverslip, 1.0), (self.coverslip, -1.0)):
            length += sign * glass.thickness / glass.index if glass else 0.0
        return self.immersion * length

    def _layers(self, wavelength: Any) -> Layers:
        """Return the layers in light of a wavelength, checked."""
        metres = validation.wavelength(wavelength)
        used, meant = Design(self.immersion, self.coverslip), self.design
        paths = []
        for side, sign in ((used, 1.0), (meant, -1.0)) if used != meant else ():
            room = self._clearance if side is used else self.working_distance
            assert room is not None  # as there is with a design
            paths.append((side.immersion, sign * room))
            if side.coverslip:
                paths.append((side.coverslip.index, sign * side.coverslip.thickness))
        glass = self.coverslip.index if self.coverslip else self.immersion
        films = tuple((film.index, film.thickness) for film in self.films)
        return Layers(self.NA, self.immersion, glass, self.sample, films, tuple(paths), metres)

    def _paraxial(self, depth: Array) -> Array:
        """Return the paraxial focus of emitters, metres of the stage."""
        films = sum(film.thickness / film.index for film in self.films)
        return np.asarray(self.immersion * (depth / self.sample + films))

    def _planes(self, depth: Any, focus: Any) -> tuple[Array, Array, tuple[int, ...]]:
        """Return depths and positions of the stage as flat arrays, with their shape, checked."""
        f = validation.real_array("focus", focus)
        d, f = validation.broadcast("depth and focus", depths(depth), f)
        name = "focus, or where depth and z lead,"
        if f.size and f.max() > self._clearance:
            known = self.working_distance is not None
            where = ", where the objective touches the cover glass," if known else " without a working_distance,"
            raise ValueError(f"{name} must be at most {self._clearance:.4g} metres{where} got {f.max():g}")
        if f.size and f.min() < -DEPTH_MOST:
            raise ValueError(f"{name} is in metres and must be at least {-DEPTH_MOST:g}, got {f.min():g}")
        return d.ravel(), f.ravel(), d.shape

    def _require_clearance(self) -> None:
        """Raise ValueError where the cover glass would be in the objective."""
        if not self._clearance > 0.0:
            raise ValueError(
                f"working_distance must leave room for the cover glass, got {self.working_distance:g}: with this "
                f"glass, thicker than the design's, the objective would be {-self._clearance:.3g} m inside it"
            )

    def _start(self, origin: str, layers: Layers, depth: Array) -> Array:
        """Return where the stage is at z = 0, for each depth."""
        if origin == "coverslip":
            return np.zeros(())
        if origin == "paraxial":
            return self._paraxial(depth)
        each, place = np.unique(depth, return_inverse=True)
        best = np.array([foci.brightest(layers, float(one)).brightest for one in each])
        return np.asarray(best[place].reshape(depth.shape))

    def _rates(self, rho: Any, wavelength: Any) -> tuple[Any, Any, Any]:
        layers = self._layers(wavelength)
        return layers.rates(layers.cosine(heights(rho)))
