"""Deconvolutions with settings that are otherwise chosen, and microscopes of other modalities."""

from __future__ import annotations

from typing import Any

import lommel as lm
from lommel.microscopy.deconvolution import DeconvolveOptions, Tuning, run
from lommel.optics.layers.emitter import emitter_of


def deconvolved(stack: Any, microscope: Any, *, noise: Any = None, **given: Any) -> Any:
    """Return the result of a deconvolution with some options, settings (`Tuning`), a mask and a saturation."""
    known = {name: given.pop(name) for name in ("mask", "saturation") if name in given}
    tuning = Tuning(**{name: given.pop(name) for name in Tuning._fields if name in given})
    return run(stack, microscope, noise, DeconvolveOptions(**given), tuning, **known)


def scanning(objective: lm.Objective, kind: Any, **modality: Any) -> lm.Microscope:
    """Return a microscope of another modality."""
    made = lm.microscopy.Modality(kind, **modality)
    return lm.Microscope(objective, 520e-9, 6e-6, depth=0.0, emitter=emitter_of("isotropic"), modality=made)
