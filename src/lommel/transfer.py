r"""Optical transfer functions: from the wavefront, and from the values of a PSF.

The OTF is the Fourier transform of the PSF over all the light,
``OTF(f) = int I(r) exp(-2 pi i f.r) dr / int I dr``, which is the autocorrelation of the pupil function P. With f in
units of the cutoff ``1 / (lambda N)`` and pupil coordinates over the radius of the aperture,

    OTF(f) = int P(rho - f) conj(P(rho + f)) d^2 rho / int abs(P)^2 d^2 rho ,

over what two shifted apertures share. In coordinates (u, y) along and across f, ``y = sin(theta)`` makes the ends of
the lens-shaped overlap of two discs, ``u = +-(cos(theta) - f)``, entire functions of theta, so Gauss-Legendre nodes
in theta and u converge spectrally. An obscured aperture is cut where its arcs meet, with ``y = eps sin(theta)``
beside the obscuration.

References
----------
H. H. Hopkins, "The frequency response of a defocused optical system", Proc. R. Soc. A 231, 91 (1955),
doi:10.1098/rspa.1955.0158. E. L. O'Neill, "Transfer function for an annular aperture", J. Opt. Soc. Am. 46, 285
(1956), doi:10.1364/JOSA.46.000285.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel import validation
from lommel.core.answers import ToleranceError
from lommel.methods.polychromatic import Polychromatic
from lommel.metrics import colours, energy_per_pixel
from lommel.psf import PSF, Numbers
from lommel.pupil import Pupil, checked
from lommel.special.legendre import gauss_legendre

Complexes = np.complex128 | NDArray[np.complex128]

_CHUNK = 2**20
"""Pupil values held at once."""
_MAX_NODES = 4096


def otf(
    pupil: Pupil,
    fx: ArrayLike,
    fy: ArrayLike = 0.0,
    *,
    pixel: float | None = None,
    spectrum: Polychromatic | None = None,
    tol: float = 1e-10,
) -> Complexes:
    """Return the optical transfer function of a pupil, from its wavefront.

    Parameters
    ----------
    pupil : Pupil
    fx, fy : array_like
        Spatial frequencies along columns and rows: cycles per metre if the pupil has a wavelength, else cycles per
        lambda*N. They broadcast: ``fx[None, :], fy[:, None]`` is a grid.
    pixel : float, optional
        Pixel pitch: multiplies by ``sinc(fx pixel) sinc(fy pixel)``, the transfer function of pixels that average.
    spectrum : Polychromatic, optional
        The sum over a spectrum, phases being path differences, as in the images of that method.
    tol : float, default 1e-10
        Absolute tolerance, 1e-13 to 0.1: nodes are added until two quadratures differ by no more.

    Returns
    -------
    complex or complex ndarray, shape ``pupil.shape + s``
        With s what fx and fy broadcast to. 1 at frequency 0, and 0 from :attr:`lommel.Pupil.cutoff` on. A shift of
        the image by (a, b) multiplies by ``exp(-2 pi i (fx a + fy b))``.

    Raises
    ------
    TypeError, ValueError
        If an argument is no finite real number or out of range, the frequencies do not broadcast, or the pupil has a
        spider, vignetting or a mask: for such, see :func:`lommel.transfer.image_otf`.
    ToleranceError
        If `tol` takes more than 4096 nodes along a line.

    Examples
    --------
    >>> import lommel as lm
    >>> round(float(abs(lm.otf(lm.Pupil(), 0.5))), 6)
    0.391002
    """
    _round(pupil)
    across, down = _frequencies(fx, fy)
    goal = validation.real("tol", tol, least=1e-13, below=0.1 + 1e-9)
    if pixel is None:
        blur = np.ones(across.shape)
    else:
        pitch = validation.pixel(pixel, metric=pupil.wavelength is not None)
        blur = np.sinc(across * pitch) * np.sinc(down * pitch)
    total = np.zeros((math.prod(pupil.shape), across.size), dtype=np.complex128)
    if spectrum is not None and not isinstance(spectrum, Polychromatic):
        raise TypeError(f"spectrum must be a Polychromatic, got {validation.shown(spectrum)}")
    for _, weight, part in colours(spectrum, pupil):
        f = np.stack([across.ravel(), down.ravel()], axis=-1) * part.scale
        total += weight * _autocorrelation(part, f, goal)
    result: Complexes = (total.reshape(pupil.shape + across.shape) * blur)[()]
    return result


def mtf(
    pupil: Pupil,
    fx: ArrayLike,
    fy: ArrayLike = 0.0,
    *,
    pixel: float | None = None,
    spectrum: Polychromatic | None = None,
    tol: float = 1e-10,
) -> Numbers:
    """Return the modulation transfer function ``abs(OTF)``; see :func:`lommel.otf`.

    Examples
    --------
    >>> import lommel as lm
    >>> camera = lm.Pupil(lm.Wavefront(1.5), wavelength=550e-9, f_number=2.8)
    >>> at_nyquist = lm.mtf(camera, 1 / (2 * 3.45e-6), pixel=3.45e-6)
    """
    result: Numbers = np.abs(otf(pupil, fx, fy, pixel=pixel, spectrum=spectrum, tol=tol))
    return result


def ptf(
    pupil: Pupil,
    fx: ArrayLike,
    fy: ArrayLike = 0.0,
    *,
    spectrum: Polychromatic | None = None,
    tol: float = 1e-10,
) -> Numbers:
    """Return the phase transfer function, the argument of the OTF in radians, above -pi and up to pi.

    The error is `tol` over the MTF. Where the MTF is `tol` or less there is no phase to speak of, and 0 is returned.
    See :func:`lommel.otf`.
    """
    value = otf(pupil, fx, fy, spectrum=spectrum, tol=tol)
    result: Numbers = np.where(np.abs(value) > tol, np.angle(value), 0.0)[()]
    return result


def mtf_frequency(pupil: Pupil, level: float = 0.5, *, angle: float = 0.0, pixel: float | None = None) -> Numbers:
    """Return the lowest frequency at which the MTF has fallen to `level`: MTF50 and its like.

    Parameters
    ----------
    level : float, default 0.5
        Above 0 and below 1.
    angle : float, default 0
        Direction of the frequency in radians, from the columns (x) to the rows (y).
    pixel : float, optional
        As of :func:`lommel.otf`.

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Cycles per metre or per lambda*N. The first crossing is bracketed by steps of 1/128 of the cutoff or, behind
        a large blur, of a quarter of an oscillation or less, and found in the bracket to 1e-10 of the cutoff.
    """
    from scipy.optimize import brentq

    _round(pupil)
    wanted = validation.real("level", level, above=0.0, below=1.0)
    turn = validation.real("angle", angle)
    cos, sin = math.cos(turn), math.sin(turn)
    cutoff = pupil.cutoff
    # An image of radius r makes the OTF oscillate like J1(2 pi r f).
    blur = float(pupil.v(pupil.geometric_radius()).max())
    steps = math.ceil(max(128.0, 2.0 * blur))
    first = np.zeros(math.prod(pupil.shape), dtype=np.int64)
    for start in range(1, steps + 1, 32):
        k = np.arange(start, min(start + 32, steps + 1))
        f = k * (cutoff / steps)
        below = np.asarray(mtf(pupil, f * cos, f * sin, pixel=pixel, tol=1e-8)).reshape(-1, k.size) <= wanted
        first = np.where((first == 0) & below.any(axis=1), k[below.argmax(axis=1)], first)
        if first.all():
            break
    flat = replace(pupil, wavefront=pupil.wavefront.flattened(), geometry=None)
    out = np.empty(first.size)
    for i, k_high in enumerate(first):

        def above(f: float, one: Pupil = flat[i]) -> float:
            return float(mtf(one, f * cos, f * sin, pixel=pixel)) - wanted

        low, high = (float(k) * (cutoff / steps) for k in (k_high - 1, k_high))
        # The scan is less exact than the search: a bracket's end may have crossed by rounding.
        ends = above(low), above(high)
        if ends[0] <= 0.0 or ends[1] >= 0.0:
            out[i] = low if ends[0] <= 0.0 else high
        else:
            out[i] = brentq(above, low, high, xtol=1e-10 * cutoff)
    result: Numbers = out.reshape(pupil.shape)[()]
    return result


def image_otf(answer: PSF, fx: ArrayLike, fy: ArrayLike = 0.0) -> Complexes:
    """Return the optical transfer function of the values in the window, by direct summation.

    Parameters
    ----------
    answer : PSF
    fx, fy : array_like
        As of :func:`lommel.otf`, at most the Nyquist frequency ``1 / (2 pixel)``.

    Returns
    -------
    complex or complex ndarray, shape ``answer.pupil.shape + s``
        ``sum values exp(-2 pi i (fx x + fy y))`` as a fraction of all light, x and y from the axis. At frequency 0
        it is the light in the window, and nowhere does it differ from :func:`lommel.otf` by more than the light
        outside, but for the error of the values, and aliases where pixels that sample are larger than lambda*N / 2.
        Values that average over pixels carry the sinc of the pixel.

    Raises
    ------
    TypeError, ValueError
        If the frequencies are not finite, do not broadcast, or exceed that of Nyquist.
    """
    validation.instance("answer", answer, PSF)
    across, down = _frequencies(fx, fy)
    limit = 0.5 / answer.pixel
    for name, part in (("fx", across), ("fy", down)):
        if part.size and np.abs(part).max() > limit * (1.0 + 1e-12):
            raise ValueError(
                f"{name} must be at most the Nyquist frequency 1 / (2 pixel) = {limit:.6g} of the samples, "
                f"got {np.abs(part).max():.6g}"
            )
    x, y = answer.grid.x, answer.grid.y
    columns = np.exp(-2j * math.pi * np.outer(x, across.ravel()))
    rows = np.exp(-2j * math.pi * np.outer(y, down.ravel()))
    found = np.einsum("...yf,yf->...f", energy_per_pixel(answer) @ columns, rows)
    result: Complexes = found.reshape(answer.pupil.shape + across.shape)[()]
    return result


def image_spectrum(answer: PSF) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.complex128]]:
    """Return the frequencies of the window and its transfer function there, by FFT.

    See :func:`lommel.transfer.image_otf`.

    Returns
    -------
    fx, fy : ndarray, shapes (width,) and (height,)
        Rising, in steps of 1 / (width pixel) and 1 / (height pixel); 0 at ``width // 2`` and ``height // 2``.
    values : complex ndarray, shape ``answer.values.shape``
    """
    validation.instance("answer", answer, PSF)
    from scipy import fft

    grid = answer.grid
    fx = fft.fftshift(fft.fftfreq(grid.width, grid.pixel))
    fy = fft.fftshift(fft.fftfreq(grid.height, grid.pixel))
    plain = fft.fftshift(fft.fft2(energy_per_pixel(answer)), axes=(-2, -1))
    # The transform counts from the first pixel, positions from the axis.
    shift = np.exp(-2j * math.pi * (fy[:, None] * grid.y[0] + fx * grid.x[0]))
    return fx, fy, np.asarray(plain * shift)


def _round(pupil: Pupil) -> None:
    # The lines of the overlap end at circles; what ends within would be found by ever more nodes only.
    if not checked(pupil).circular:
        raise ValueError(
            "pupil must be a disc or an annulus for its transfer function, got one with a spider, vignetting or a "
            "mask; take that of its image, psf.mtf(fx, fy) or psf.otf(fx, fy)"
        )


def _frequencies(fx: ArrayLike, fy: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    across, down = validation.real_array("fx", fx), validation.real_array("fy", fy)
    try:
        both = np.broadcast_arrays(across, down)
    except ValueError:
        raise ValueError(f"fx and fy must broadcast, got shapes {across.shape} and {down.shape}") from None
    return both[0], both[1]


def _autocorrelation(pupil: Pupil, f: NDArray[np.float64], tol: float) -> NDArray[np.complex128]:
    """Return the OTF at frequencies f over the cutoff, shape (points, 2), for the flattened stack."""
    if pupil.radial:
        # It depends on the length of f only.
        canonical = np.stack([np.hypot(f[:, 0], f[:, 1]), np.zeros(len(f))], axis=-1)
        mirrored = np.zeros(len(f), dtype=bool)
    else:
        # OTF(-f) is the conjugate of OTF(f).
        mirrored = (f[:, 1] < 0) | ((f[:, 1] == 0) & (f[:, 0] < 0))
        canonical = np.where(mirrored[:, None], -f, f)
    points, where = np.unique(canonical, axis=0, return_inverse=True)
    where = where.reshape(-1)
    shift = np.hypot(points[:, 0], points[:, 1])
    values = np.zeros((math.prod(pupil.shape), len(points)), dtype=np.complex128)
    # Nearer to 0 than this nothing changes, and quotients overflow.
    values[:, shift <= 1e-100] = 1.0
    within = np.flatnonzero((shift > 1e-100) & (shift < 1))
    blur = float(pupil.v(pupil.geometric_radius()).max())
    # Alike frequencies take alike many nodes.
    for group in (
        np.array_split(within[np.argsort(shift[within])], math.ceil(len(within) / 32)) if len(within) else []
    ):
        values[:, group] = _refined(pupil, points[group], shift[group], blur, tol)
    values = values[:, where]
    return np.where(mirrored, values.conj(), values)


def _refined(
    pupil: Pupil, f: NDArray[np.float64], shift: NDArray[np.float64], blur: float, tol: float
) -> NDArray[np.complex128]:
    """Return the OTF at few frequencies with as many nodes as it takes."""
    # Half of the phase that a line of the overlap sees, about; too few nodes are found out by those that follow.
    swing = 2.0 * blur * (1.0 - float(shift.min())) * min(1.0, 2.0 * float(shift.max()))
    nodes = 16 + math.ceil(0.25 * swing + 0.25 * pupil.illumination.slope)
    before: NDArray[np.complex128] | None = None
    while nodes <= _MAX_NODES:
        value = _overlap_integral(pupil, f, shift, nodes)
        if before is not None and np.abs(value - before).max() <= tol + 1e-15 * blur:
            return value
        before, nodes = value, math.ceil(1.4 * nodes)
    raise ToleranceError(f"the OTF to tol={tol:g} takes more than {_MAX_NODES} nodes along a line")


def _overlap_integral(
    pupil: Pupil, f: NDArray[np.float64], shift: NDArray[np.float64], nodes: int
) -> NDArray[np.complex128]:
    """Return the autocorrelation at f by `nodes` Gauss nodes along and across each part of the overlap."""
    x, w = gauss_legendre(nodes)
    which, y, low, width, weight = _lines(shift, pupil.obscuration, x, w)
    if not pupil.radial:
        which, low, width, weight = (np.tile(part, 2) for part in (which, low, width, 0.5 * weight))
        y = np.concatenate([y, -y])
    out = np.zeros((math.prod(pupil.shape), len(f)), dtype=np.complex128)
    many = max(1, _CHUNK // (len(out) * nodes))
    for start in range(0, y.size, many):
        part = slice(start, start + many)
        at = which[part]
        along = low[part, None] + width[part, None] * x
        cos, sin = (f[at].T / shift[at])[:, :, None]
        px = along * cos - y[part, None] * sin
        py = along * sin + y[part, None] * cos
        fx, fy = f[at].T[:, :, None]
        if pupil.radial:
            product = _radial_product(pupil, (px - fx) ** 2 + (py - fy) ** 2, (px + fx) ** 2 + (py + fy) ** 2)
        else:
            product = pupil.values(px - fx, py - fy) * pupil.values(px + fx, py + fy).conj()
        np.add.at(out.T, at, ((product @ w) * (width[part] * weight[part])).T)
    return out / (math.pi * pupil.transmission)


def _radial_product(pupil: Pupil, s: NDArray[np.float64], t: NDArray[np.float64]) -> NDArray[Any]:
    """Return the real part of ``P(s) conj(P(t))``, s and t being rho^2; the imaginary one is odd in u."""
    product = np.cos(pupil.radial_phase(s) - pupil.radial_phase(t))
    if not pupil.illumination.uniform:
        product *= pupil.illumination.at(s) * pupil.illumination.at(t)
    return np.asarray(product)


def _lines(
    shift: NDArray[np.float64], eps: float, x: NDArray[np.float64], w: NDArray[np.float64]
) -> tuple[NDArray[Any], ...]:
    """Return the lines of constant y > 0 that cover the overlaps: frequency, y, begin in u, length, weight in y.

    Each overlap is symmetric in y, and its upper half covered with twice the weight. Within a panel its ends are
    analytic functions of the angle.
    """
    end = 2.0 * np.arcsin(np.sqrt(0.5 * (1.0 - shift)))  # arccos(shift), exact near 1
    top = np.sqrt((1.0 - shift) * (1.0 + shift))
    found = [_panel(np.arcsin(np.minimum(eps, top)), end, 1.0, shift, eps, x, w)]
    if eps > 0:
        # Where the rim of one aperture meets the obscuration of the other, and both obscurations one another.
        meets = shift - (1.0 - eps**2) / (4.0 * shift)
        last = np.arcsin(np.minimum(1.0, top / eps))
        rim = np.arccos(np.minimum(1.0, np.abs(meets) / eps))
        both = np.arccos(np.minimum(1.0, shift / eps))
        edges = np.sort(np.minimum([np.zeros_like(last), rim, both, last], last), axis=0)
        found += [_panel(a, b, eps, shift, eps, x, w) for a, b in pairwise(edges)]
    which, y, low, width, weight = (np.concatenate(part) for part in zip(*found, strict=True))
    kept = width * weight > 0
    which, y, low, width, weight = (part[kept] for part in (which, y, low, width, weight))
    return which, y, low, width, 2.0 * weight


def _panel(
    first: NDArray[np.float64],
    last: NDArray[np.float64],
    radius: float,
    shift: NDArray[np.float64],
    eps: float,
    x: NDArray[np.float64],
    w: NDArray[np.float64],
) -> tuple[NDArray[Any], ...]:
    """Return the lines with ``y = radius sin(theta)``, theta from `first` to `last`, one of each a frequency."""
    theta = first[:, None] + (last - first)[:, None] * x
    y = radius * np.sin(theta)
    weight = (last - first)[:, None] * w * radius * np.cos(theta)
    f = shift[:, None]
    rim = np.sqrt((1.0 - y) * (1.0 + y))
    if radius == 1.0:  # beside the obscurations
        pieces = [(f - rim, rim - f)]
    else:
        hole = eps * np.cos(theta)
        right = [(f - rim, f - hole), (f + hole, f + rim)]
        left = [(-f - rim, -f - hole), (-f + hole, -f + rim)]
        pieces = [(np.maximum(a, c), np.minimum(b, d)) for a, b in right for c, d in left]
    which = np.broadcast_to(np.arange(shift.size)[:, None], y.shape).ravel()
    lines = (which, y.ravel(), weight.ravel())
    parts = [(*lines[:2], low.ravel(), np.maximum(high - low, 0.0).ravel(), lines[2]) for low, high in pieces]
    return tuple(np.concatenate(part) for part in zip(*parts, strict=True))
