"""Fits of stars, beads and fields with accuracies and extents of the search that are no options of theirs."""

from __future__ import annotations

from typing import Any

import lommel as lm
from lommel.detection import Targets
from lommel.estimation import EFFORT, Effort, beads
from lommel.estimation.beads import BeadFit, fit_stacks
from lommel.estimation.field_fit import FieldFit, fit_targets
from lommel.estimation.phase_retrieval import Retrieval, fit_stars


def effort_of(given: dict[str, Any], base: Effort = EFFORT) -> Effort:
    """Take integrate, tol, starts, steps and threads out of `given`."""
    return base._replace(**{name: given.pop(name) for name in Effort._fields if name in given})


def retrieve(images: Any, pupil: Any, *, pixel: float, noise: Any = None, **given: Any) -> Retrieval:
    """Retrieve as :func:`lommel.retrieve`."""
    effort, options = effort_of(given), lm.RetrieveOptions.of("retrieve", None, given)
    return fit_stars(images, pupil, pixel=pixel, noise=noise, options=options, effort=effort)


def fit_beads(stacks: Any, microscope: Any, *, z: Any, noise: Any = None, **given: Any) -> BeadFit:
    """Fit as :func:`lommel.fit_beads`."""
    effort, options = effort_of(given, beads.EFFORT), lm.BeadOptions.of("fit_beads", None, given)
    return fit_stacks(stacks, microscope, z=z, noise=noise, options=options, effort=effort)


def fit_field(
    windows: Any, places: Any, pupil: Any, *, sensor: Any, pixel: float, noise: Any = None, kind: Any = "star",
    **given: Any,
) -> FieldFit:  # fmt: skip
    """Fit windows around targets as :func:`lommel.fit_field`."""
    effort, options = effort_of(given), lm.FieldFitOptions.of("fit_field", None, given)
    targets = Targets(windows=windows, places=places, shape=sensor, noise=noise, kind=kind)
    return fit_targets(targets, pupil, pixel=pixel, options=options, effort=effort)
