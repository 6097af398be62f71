"""Stacks of pupils as arrays for files: varying parameters as arrays, shared ones once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.optics.base_pupil import BasePupil, Geometry
from lommel.optics.layers.objective_pupil import PLANES, ObjectivePupil
from lommel.optics.pupil import Pupil, checked
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.special import zernike

_LENS, _OBJECTIVE = "Pupil", "ObjectivePupil"


def apart(pupil: BasePupil) -> tuple[Json, dict[str, Array]]:
    """Return what the pupils of a stack share, for JSON, and arrays of what differs, the axes of the stack first."""
    first = pupil[(0,) * len(pupil.shape)] if pupil.shape else pupil
    shared = first.to_dict()
    if isinstance(pupil, ObjectivePupil):
        arrays = {name: np.asarray(getattr(pupil, name)) for name in PLANES}
        for name in PLANES:
            del shared[name]
        measured = pupil.aberrations
        if measured is not None and measured.shape:
            shared["aberrations"] = _terms(measured, arrays)
        return {"kind": _OBJECTIVE} | shared, arrays
    lens, arrays = checked(pupil), {}
    shared["wavefront"] = _terms(lens.wavefront, arrays)
    if lens.geometry is not None:
        arrays["object_distance"] = lens.geometry.distances.reshape(lens.shape)
        shared["geometry"]["object_distance"] = []
    return {"kind": _LENS} | shared, arrays


def together(shared: Json, arrays: Mapping[str, Array]) -> BasePupil:
    """Return the stack of :func:`apart`, or of parts of its arrays, bit by bit; TypeError, ValueError or KeyError."""
    plain = dict(shared)
    if validation.choice("kind", plain.pop("kind"), (_LENS, _OBJECTIVE)) == _OBJECTIVE:
        planes = {name: arrays[name] for name in PLANES}
        if "edge" not in arrays:
            return ObjectivePupil.from_dict(plain | planes)
        bare = ObjectivePupil.from_dict(plain | planes | {"aberrations": None})
        return replace(bare, aberrations=_wavefront(plain["aberrations"], arrays))
    geometry = plain.pop("geometry")
    if geometry is not None:
        geometry = Geometry.from_dict(geometry | {"object_distance": arrays["object_distance"].ravel().tolist()})
    bare_lens = Pupil.from_dict(plain | {"wavefront": {}, "geometry": None})
    return bare_lens.carrying(_wavefront(plain["wavefront"], arrays), geometry)


def _terms(wavefront: Wavefront, arrays: dict[str, Array]) -> Json:
    """Move the coefficients into the arrays, and return their terms and error."""
    arrays["edge"] = wavefront.edge
    if wavefront._powers is not None:
        arrays["powers"] = wavefront._powers
    return {"terms": [list(term) for term in wavefront.terms], "error": wavefront.error}


def _wavefront(said: Json, arrays: Mapping[str, Array]) -> Wavefront:
    terms = tuple(zernike.check_term(n, m) for n, m in said["terms"])
    edge = validation.real_array("edge", arrays["edge"]).copy()
    if edge.ndim == 0 or edge.shape[-1] != len(terms):
        raise ValueError(f"edge must have {len(terms)} coefficients each, got shape {edge.shape}")
    powers = validation.real_array("powers", arrays["powers"]).copy() if "powers" in arrays else None
    return Wavefront.trusted(terms, edge, validation.real("error", said["error"], least=0.0), powers)
