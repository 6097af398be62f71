r"""Images through a lattice: samples of a stack by any method, spread, and read by pixels; with what each is off by.

The intensity has no frequencies beyond ``abs(w) = 2``, and ``int abs(OTF) dw`` is at most the peak without
aberration, so that a response that is off by e there makes errors of at most e times that peak (as in
methods/averaging.py). What samples err by counts as often as the moduli of all weights together.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from lommel.base.arrays import Array
from lommel.core.answers import Images, ToleranceError
from lommel.methods.choice import candidates, first_proven
from lommel.methods.method import Method, widened
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.grid import Grid
from lommel.optics.spectrum import Component
from lommel.sensor.blurs import Blur
from lommel.sensor.halo import Gate
from lommel.sensor.readout import Readout, ends, readout
from lommel.sensor.spread import Short, Spread, halo_of, spread

STEP = 0.8
"""v from sample to sample."""
_MOST = 6144  # samples a side
_AT_ONCE = 2**24


class Asked(NamedTuple):
    """What is asked of the samples.

    Attributes
    ----------
    method : Method or None
        The one that was named.
    threads : int
    tol : float
        Of samples over their peak.
    error : float
        That responses may be off by.
    margin : float
        How far a lattice reaches beyond what is read where there is a halo, in v.
    """

    method: Method | None
    threads: int
    tol: float
    error: float
    margin: float


class Made(NamedTuple):
    """Images of the flattened stack, with parts of the bounds on their errors, or None.

    Attributes
    ----------
    values : ndarray, shape (n, height, width)
    given : ndarray, shape (n,), or None
        What samples are off by.
    response : ndarray, shape (n,)
        What responses are off by, and rounding.
    missing : ndarray, shape (n,)
        What a halo would bring from beyond the lattice.
    method : Method
    """

    values: Array
    given: Array | None
    response: Array
    missing: Array
    method: Method


def summed(asked: Asked, pupil: Any, grid: Grid, several: tuple[Blur, ...]) -> Made:
    """Return the sum over the wavelengths of a spectrum: turbulence spreads each by another width."""
    method = asked.method
    if not isinstance(method, Polychromatic):
        return _of_stack(asked, Component(1.0, 1.0, pupil), grid, several)
    parts = method.components(pupil)
    made = [_of_stack(asked._replace(method=method.method), part, grid, several) for part in parts]
    weights = [part.weight for part in parts]

    def total(name: str) -> Any:
        found = [getattr(one, name) for one in made]
        if any(one is None for one in found):
            return None
        return np.sum([weight * one for weight, one in zip(weights, found, strict=True)], axis=0)

    return Made(total("values"), total("given"), total("response"), total("missing"), method)


def _of_stack(asked: Asked, part: Component, grid: Grid, several: tuple[Blur, ...]) -> Made:
    """Return images of a stack in one wavelength, those around one axis at once."""
    pupil = part.pupil
    if grid.stack:
        each = [
            _of_stack(asked, part._replace(pupil=pupil[index]), grid[index], several)
            for index in np.ndindex(grid.stack)
        ]
        return _joined(each)
    gate, to_v = Gate.of(STEP, asked.error), math.pi / pupil.scale
    rows, columns = (
        readout(to_v * places, to_v * active, gate)
        for places, active in zip((grid.y, grid.x), grid.active, strict=True)
    )
    short, halo = Short.of(several, pupil.scale), halo_of(several, pupil.scale, pupil.wavelength, gate)
    box, kernel = _lattice(asked, short, halo, rows, columns)
    blocks = _blocks(pupil, math.prod(box[1]))
    return _joined([_of_block(asked, block, gate, box, kernel, (rows, columns)) for block in blocks])


def _joined(parts: list[Made]) -> Made:
    """Return images of parts of a stack, one after the other."""
    given = [one.given for one in parts if one.given is not None]
    return Made(
        np.concatenate([one.values for one in parts]),
        np.concatenate(given) if len(given) == len(parts) else None,
        np.concatenate([one.response for one in parts]),
        np.concatenate([one.missing for one in parts]),
        parts[0].method,
    )


Box = tuple[tuple[int, int], tuple[int, int]]
"""Where a lattice begins, in steps from the axis, and how many samples it has: rows and columns."""


def _lattice(asked: Asked, short: Short, halo: Any, rows: Readout, columns: Readout) -> tuple[Box, Spread | None]:
    """Return the samples that are needed, and what spreads them."""
    gate, plain = halo.gate, short.nothing and not halo.several
    begins, counts, least = [], [], []
    across, down = short.reach(gate.error)
    beyond = 0.0 if short.nothing else ends(gate)[0]
    for side, reach in ((rows, down), (columns, across)):
        room = 0 if plain else math.ceil((reach + beyond) / gate.h)
        first, last = side.first - room, side.first + side.samples - 1 + room
        more = math.ceil(asked.margin / gate.h) if halo.several else 0
        low, high = (min(first, 0) - more, max(last, 0) + more) if halo.several else (first, last)
        far = max(-low, high)
        # About its middle a lattice costs a quarter.
        if 2 * far + 1 <= 1.2 * (high - low + 1):
            low, high = -far, far
        begins.append(low)
        counts.append(high - low + 1)
        # A halo reaches from any sample to any that is read, and from none around the other way.
        least.append(2 * max(last - low, high - first) + 2 if halo.several else counts[-1])
    if max(counts) > _MOST:
        raise ToleranceError(
            f"this image takes a lattice of {max(counts)} samples a side, more than {_MOST}, to be known to the "
            "tolerance: ask for a larger tol, or for a smaller window"
        )
    box = (begins[0], begins[1]), (counts[0], counts[1])
    return box, None if plain else spread(short, halo, (least[0], least[1]), asked.margin)


def _blocks(pupil: Any, samples: int) -> list[Any]:
    """Return parts of a flattened stack that are sampled at once."""
    count, size = math.prod(pupil.shape), max(1, _AT_ONCE // samples)
    if count <= size:
        return [pupil]
    starts = range(0, count, size)
    return [pupil[np.unravel_index(np.arange(s, min(s + size, count)), pupil.shape)] for s in starts]


def _of_block(
    asked: Asked, pupil: Any, gate: Gate, box: Box, kernel: Spread | None, pixels: tuple[Readout, Readout]
) -> Made:
    """Return images of a few pupils, from one lattice."""
    (rows, columns), ceiling, (first, counts) = pixels, pupil.amplitude**2, box
    fine = Grid(counts, gate.h * pupil.scale / math.pi, center=(-first[0], -first[1]))
    method, samples, off = _sampled(asked, pupil, fine)
    gain, missing = rows.gain * columns.gain, np.zeros(len(samples))
    response = np.full(len(samples), 1.0001 * (rows.error + columns.error + rows.error * columns.error) * ceiling)
    if kernel is not None:
        light = 4.0 * math.pi * pupil.transmission
        seen = gate.h**2 * samples.sum(axis=(1, 2))
        unsure = 0.0 if off is None else gate.h**2 * samples[0].size * off
        missing = gain * kernel.missing * np.clip(light - seen + unsure, 0.0, light)
        spreading = ceiling * (1.0001 * kernel.error + kernel.blind) + light * kernel.off + kernel.rounding(samples)
        response += gain * spreading
        gain *= kernel.gain
        samples = kernel.on(samples, asked.threads)
    top, left = rows.first - first[0], columns.first - first[1]
    part = samples[:, top : top + rows.samples, left : left + columns.samples]
    values = np.stack([(columns.matrix @ (rows.matrix @ one).T).T for one in part])
    return Made(values, None if off is None else gain * off, response, missing, method)


def _sampled(asked: Asked, pupil: Any, fine: Grid) -> tuple[Method, Array, Array | None]:
    """Return the method, samples of a stack on a lattice, and bounds on what each is off by."""
    if asked.method is not None:
        ways: tuple[Method, ...] = (asked.method.tightened(max(asked.tol, asked.method.least_tol)),)
        if asked.tol > asked.method.tol:
            ways = (asked.method,)
    else:
        least = 1e-11 if not pupil.circular else Method.least_tol
        ways = candidates(pupil, fine, min(max(asked.tol, least), 0.05))
    ways[0].require(pupil)
    fine.require_reach(pupil)

    def ask(way: Method) -> Images:
        made = way.intensity(pupil, fine, asked.threads)
        scales = np.ones(len(made.values))
        values = np.empty((len(scales), *fine.shape))
        fine.paint(made.values, scales, values)
        peak = made.values.reshape(len(scales), -1).max(axis=1) if made.peak is None else made.peak
        return widened(Images(values, scales, made.error, None, peak), pupil, way, normalized=False)

    way, made = first_proven(ways, ask)
    assert made.peak is not None
    return way, made.values, None if made.error is None else made.error * made.peak
