"""Stacks through the layers of a microscope, by an engine that interpolates what it has proven."""

from __future__ import annotations

from dataclasses import dataclass

from lommel.methods.debye_wolf import DebyeWolf


@dataclass(frozen=True)
class Stratified(DebyeWolf):
    """What computes the pupils of :meth:`lommel.Objective.pupil` where no method is named.

    Parameters
    ----------
    tol : float, default 1e-6
        Tolerance over the peak of each plane.

    Raises
    ------
    TypeError, ValueError
        If `tol` is out of range.
    """
