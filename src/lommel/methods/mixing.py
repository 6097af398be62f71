"""Sums over wavelengths, several at once: each wavelength is computed once for all of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Intensities, ToleranceError, not_met
from lommel.optics.spectrum import Component


class Contract(NamedTuple):
    """What is promised of every sum.

    Attributes
    ----------
    tol : float
        Bound on the error over the peak of each sum, or over its largest value.
    named : float
        The tolerance that was asked for, which messages tell.
    least : float
        The least that parts can be asked for.
    kept : bool
        Whether the tolerance is one, of parts that have a bound.
    window : bool
        Whether errors relate to the largest value in the window.
    """

    tol: float
    named: float
    least: float
    kept: bool
    window: bool = False


def mixed(
    parts: Sequence[Component], shares: Array, ask: Callable[[Component, float], Intensities], contract: Contract
) -> list[Intensities]:
    """Return sums of what is asked for each wavelength, every one to its tolerance.

    Parameters
    ----------
    parts : sequence of Component
        Their own shares do not count.
    shares : ndarray, shape (sums, parts)
        Of the light of each sum, >= 0.
    ask : callable
        From a part and a tolerance over its own peak to its intensities, all of one shape.
    contract : Contract

    Returns
    -------
    list of Intensities

    Raises
    ------
    ToleranceError
        If the tolerance cannot be met.
    """
    weights, asked = shares * np.array([part.stretch**2 for part in parts]), contract.tol
    while True:
        try:
            made = _sums(parts, weights, ask, asked, window=contract.window)
        except ToleranceError as fault:
            raise ToleranceError(
                f"tol={contract.named:g} cannot be met by a sum over wavelengths each of which must be exact to "
                f"{asked:.2g} of its peak: {fault}"
            ) from None
        errors = [float(each.error.max()) for each in made if each.error is not None]
        if not errors or not contract.kept or (worst := max(errors)) <= contract.tol:
            return made
        # Each part is within the tolerance of its own peak; that of the sum may be lower than theirs together.
        if asked <= contract.least:
            raise not_met(contract.named, worst, "the largest value in the window" if contract.window else "the peak")
        asked = max(contract.least, asked * max(1e-3, min(0.5, 0.5 * contract.tol / worst)))


def _sums(
    parts: Sequence[Component],
    weights: Array,
    ask: Callable[[Component, float], Intensities],
    asked: float,
    *,
    window: bool,
) -> list[Intensities]:
    """Return weighted sums of intensities, and their errors over what their peaks are at least.

    Or, with `window`, over what their largest values in the window are at least. One part is kept at a time.
    """
    sums: list[Array | None] = [None] * len(weights)
    tops, errors, bounded = [], [], [True] * len(weights)
    for k, part in enumerate(parts):
        made = ask(part, asked)
        tops.append(made.values.reshape(len(made.values), -1).max(axis=1) if made.peak is None else made.peak)
        errors.append(np.zeros(len(made.values)) if made.error is None else made.error)
        for c in np.flatnonzero(weights[:, k]):
            bounded[c] &= made.error is not None
            term, before = weights[c, k] * made.values, sums[c]
            sums[c] = term if before is None else np.add(before, term, out=before)
    found = []
    for row, values, known in zip(weights, sums, bounded, strict=True):
        assert values is not None  # each has a share of some light
        highest = values.reshape(len(values), -1).max(axis=1)
        if not known:
            found.append(Intensities(values, None, highest))
            continue
        used = np.flatnonzero(row)
        off = (len(used) + 8) * 2.0**-53 * highest  # what weights, products and the sum are rounded by
        off = off + sum(row[k] * errors[k] * tops[k] for k in used)
        # Nothing is negative, so the sum is at least as bright as any part of it.
        peak = highest if window else np.maximum(highest, np.max([row[k] * tops[k] for k in used], axis=0))
        least = peak - off
        relative = np.divide(off, least, out=np.full(off.shape, np.inf), where=least > 0)
        found.append(Intensities(values, relative, least))
    return found
