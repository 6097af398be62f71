"""Least-squares fits of wavefronts to maps of optical path difference (OPD).

The inverse, sampling a wavefront as an OPD map, is :func:`opd_map`.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, Values, numbers
from lommel.base.quantities import is_angle, stated_unit
from lommel.base.units import percent
from lommel.fit.findings import Finding, Findings, Judged
from lommel.optics.wavefront import opd_residual
from lommel.optics.wavefront.pupil_circle import Circle, Outline, blank_area, conversion, outline, stated_circle
from lommel.optics.wavefront.wavefront import MAX_HIGHER, Wavefront, radians_per
from lommel.special import zernike

MAX_RADIAL = 2 * (2 + MAX_HIGHER)
"""Highest degree n of a fit."""

MAX_GROWTH = 1e4
"""Largest accepted amplification of measurement errors in coefficients or, for ill-conditioned fits, in the phase."""

MAX_ROUNDING = 1e7
"""Largest condition number at which the terms are still orthogonalised on the samples."""

# Absolute values below this fraction of the largest one count as 0: changes of unit can leave rounding errors.
_RESIDUE = 1e-9
# Count, for each value, the pixels with an equal neighbour. A value is taken as a marker of missing pixels if its
# count is at least this number, this fraction of the pupil's pixels, and this multiple of every other count.
_MIN_BLANK_PIXELS, _MIN_BLANK_FRACTION, _MIN_BLANK_RATIO = 8, 0.002, 8
# A stated centre is in doubt if the samples fill a circle of the same radius, within this fraction, whose centre is
# apart by more pixels than the second number.
_SAME_RADIUS, _LEAST_SHIFT = 0.05, 0.25
# Areas without samples are named from this fraction of the pupil on, and a doubt if the MTF changes by the second
# number, or the Strehl ratio by the third, relative to it or to the number after that.
_NAMED_AREA, _DOUBTFUL_MTF, _LEAST_STREHL, _LOW_STREHL = 0.01, 0.05, 0.01, 0.1
_HOLE_MTF = 1.6  # largest change of the MTF by a hole in the middle, divided by its area; 1 at most for edges
_BLOCK = 16384  # samples processed together; bounds the memory of fits to large maps


@dataclass(frozen=True, eq=False, repr=False)
class OPDMap:
    """Measured map of optical path differences (OPD), or a stack of maps, for :func:`lommel.fit_opd`.

    ``2.0 * opd`` converts the height error of a mirror to the path difference in reflection, and ``-opd`` reverses
    the sign convention.

    Parameters
    ----------
    values : array_like, shape (..., height, width)
        Optical path difference in metres; x increases with the columns and y with the rows. NaN marks pixels without
        a measurement; masked values become NaN.
    spacing : float, optional
        Pixel spacing in the pupil, metres.
    wavelength : float, optional
        Wavelength of the measurement, metres.

    Attributes
    ----------
    mask : ndarray of bool, of the shape of the values
        True where there is a measurement.

    Raises
    ------
    TypeError, ValueError
        If the values are not real, have fewer than two axes, include an infinity or are all NaN, or if the spacing or
        the wavelength is out of range.

    Examples
    --------
    >>> import lommel as lm
    >>> opd = OPDMap(550e-9 * lm.opd_map(lm.Wavefront(1.0), 24, unit="waves"), wavelength=550e-9)
    >>> round(float(lm.fit_opd(opd).wavefront.defocus), 6)
    1.0
    """

    values: Array
    spacing: float | None = None
    wavelength: float | None = None

    def __post_init__(self) -> None:
        data, masked = validation.parted("values", self.values, "metres")
        values = _real_maps("values", data)
        if masked is not None:
            values[masked] = np.nan
        if np.isinf(values).any() or np.isnan(values).all():
            raise ValueError(
                "values must be finite, or NaN at pixels without a measurement, and not NaN at every pixel"
            )
        values.flags.writeable = False
        vars(self).update(values=values)
        if self.spacing is not None:
            vars(self).update(spacing=validation.real("spacing", self.spacing, above=0.0, unit="metres"))
        if self.wavelength is not None:
            vars(self).update(wavelength=validation.wavelength(self.wavelength))

    @property
    def mask(self) -> NDArray[np.bool_]:
        """True where there is a measurement."""
        return ~np.isnan(self.values)

    def __mul__(self, factor: float) -> Self:
        """Return the map times a number."""
        return replace(self, values=self.values * validation.real("factor", factor))

    __rmul__ = __mul__

    def __neg__(self) -> Self:
        """Return the map with reversed sign."""
        return -1.0 * self

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Values:
        """Return a copy of `values`, or `values` themselves if `copy` allows."""
        return np.array(self.values, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        pairs = [(name, getattr(self, name)) for name in ("spacing", "wavelength")]
        lengths = [f"{name} {metres:g} m" for name, metres in pairs if metres is not None]
        size = "x".join(map(str, self.values.shape))
        return f"<OPDMap {', '.join([size, f'{percent(self.mask.mean(), 1)} measured', *lengths])}>"


@dataclass(frozen=True, eq=False, repr=False)
class WavefrontFit(Judged):
    """A wavefront fitted to measurements, and its residual.

    The findings have the codes "other_explanation" (jumps of waves in the map, as of errors of phase unwrapping),
    "outliers" (pixels far from their neighbours; a doubt if they move coefficients by a standard error or more),
    "estimated" (the circle of the pupil is that of the samples), "left_out" (areas of the circle have no samples, as
    of an obscuration or vignetting; a doubt if this changes the Strehl ratio by 1 % or the MTF by 0.05),
    "undetermined" (the samples do not tell the circle, and another one would move coefficients by a standard error or
    more), "contradiction" (the stated centre is not that of the samples) and "misfit" (terms of higher degree are
    missing, or the residual has other structure than white noise; a doubt if they change a Strehl ratio by 1 %).

    Attributes
    ----------
    wavefront : Wavefront
        Fitted wavefront, without piston; a stack if several maps were fitted.
    coefficients, errors : dict of (int, int) to float or ndarray
        Coefficients of the terms (n, m) over the disc, rms-normalized, in `unit`, and their standard errors: from the
        residual and, if the samples tell the circle of the pupil, from its error. Correlated noise of neighbours
        counts by its power in the terms of the next higher degrees, extrapolated to those of the fit: right within
        40 % for noise that is correlated over a few pixels. Errors of tilt and defocus are up to 3 times too small
        for spectra as steep as that of turbulence.
    covariance : ndarray, shape ``wavefront.shape + (k, k)``
        Covariance of `coefficients`, in the same order, in `unit` squared.
    piston : ndarray, shape ``wavefront.shape``
        Fitted coefficient of the constant Zernike term over the disc, in `unit`. Measurement = piston + wavefront +
        residual. Over an annulus the piston differs from the mean of the map.
    rms, peak_to_valley : ndarray, shape ``wavefront.shape``
        Rms and peak-to-valley of the residual.
    residual : ndarray
        Measurement minus fit, shaped like the measurement; NaN at pixels that the fit did not use.
    samples : ndarray of int, shape ``wavefront.shape``
        Number of samples that the fit used.
    condition : float
        Condition number of the fit, the largest amplification of measurement errors in a coefficient: near 1 for a
        full pupil. For a stack it is the largest one of the maps. Above 1e4 only the phase is determined, not single
        coefficients.
    unit : str
        Unit of `coefficients`, `errors`, `piston`, `rms`, `peak_to_valley` and `residual`.
    findings : Findings
        Findings on the residual, from which `status`, `converged` and `reliable` follow.
    message : str
        The verdict in words, with the rms of the residual (the largest of a stack).
    """

    wavefront: Wavefront
    coefficients: dict[tuple[int, int], Numbers]
    errors: dict[tuple[int, int], Numbers]
    covariance: Array
    piston: Array
    rms: Array
    peak_to_valley: Array
    residual: Array
    samples: NDArray[np.int64]
    condition: float
    unit: str
    findings: Findings

    @property
    def message(self) -> str:
        """The verdict in words, with the rms of the residual (the largest of a stack)."""
        return self._message(f"the residual is {np.max(self.rms):.3g} {self.unit} rms")

    def __repr__(self) -> str:
        return f"<WavefrontFit: {self.message}>"


def fit_opd(
    opd: ArrayLike | OPDMap,
    *,
    unit: str | None = None,
    wavelength: float | None = None,
    mask: ArrayLike | None = None,
    degree: int = 8,
    center: tuple[float, float] | None = None,
    radius: float | None = None,
    obscuration: float = 0.0,
) -> WavefrontFit:
    """Fit Zernike terms to a measured map of optical path differences, or to a stack of maps.

    Parameters
    ----------
    opd : array_like, shape (..., height, width), or OPDMap
        Measured map; x increases with the columns and y with the rows. NaN marks missing pixels, unless a `mask` or a
        masked array is given. :func:`lommel.load_opd` reads an OPDMap from a file.
    unit : str
        Unit of `opd`: "radians", "waves", "metres" or another length, which needs `wavelength`. Omit it for an
        OPDMap, which is in metres, or an array with a unit, whose fit is then in metres or radians. A longer optical
        path must be positive, as in the phase: otherwise pass ``-opd``.
    wavelength : float, optional
        Wavelength, metres. Default: the wavelength of the OPDMap, if it has one.
    mask : array_like of bool, shape (height, width) or the shape of `opd`, optional
        True at valid pixels, False at an obscuration or a vane. Masked values of a masked array are always ignored.
        Without a `mask` the function rejects a map with one value, such as 0, over a whole area, since many files
        mark missing pixels in this way.
    degree : int, default 8
        Highest n of the fitted Zernike terms, 1 to 20; the number of terms is (degree + 1) (degree + 2) / 2.
    center : (float, float), optional
        Row and column of the pupil's centre; (0, 0) is the centre of the first pixel. Default: the centre of the
        circle that the samples fill, such as ``n / 2`` in grids of Zemax; if their outline is no circle, the centre
        of the map.
    radius : float, optional
        Radius of the pupil in pixels. Default: that of the circle that the samples fill: ``n / 2`` for pixels that
        fill the map, ``(n - 1) / 2`` for ``np.linspace(-1, 1, n)``, ``n / 2 - 1`` in grids of Zemax; if their outline
        is no circle, half the smaller side of the map. If the samples are far from filling the map, the function
        raises an error that states the circle around them.
    obscuration : float, default 0
        Radius of the central obscuration divided by the radius of the pupil, 0 to below 1. The fit omits pixels whose
        centre lies within the obscuration and uses annular Zernike terms (:meth:`lommel.Wavefront.zernike`), which
        stay well conditioned to high degrees.

    Returns
    -------
    WavefrontFit
        Least-squares fit to the pixels whose centre lies in the pupil. The wavefront has Zernike terms over the disc,
        also with an obscuration.

    Raises
    ------
    TypeError, ValueError
        If the map is empty or not finite inside the mask; if the samples are too few or do not determine the terms
        over the whole pupil; if, without a `mask`, a whole area of the map has one value; or if, without
        a `radius`, the circle around the samples is smaller than the pupil by more than a pixel and 2 %.
    """
    if isinstance(opd, OPDMap):
        if unit not in (None, "metres"):
            raise ValueError(f"unit must be left out for an OPDMap, which is in metres, got {validation.shown(unit)}")
        unit, wavelength = "metres", opd.wavelength if wavelength is None else wavelength
        # NaN is "not measured" in an OPDMap.
        opd = np.ma.masked_invalid(opd.values)
    elif unit is None and (stated := stated_unit(opd)) is None:
        raise TypeError("unit must be given, 'radians', 'waves' or 'metres', unless opd is an OPDMap or has a unit")
    elif unit is None:
        unit = "radians" if is_angle(stated) else "metres"
    scale = radians_per(unit, wavelength)
    highest = validation.integer("degree", degree, least=1, most=MAX_RADIAL)
    eps = validation.real("obscuration", obscuration, least=0.0, below=1.0)
    # Outside the mask values may be arbitrary, even NaN.
    maps, valid = _maps(opd, mask, unit)
    height, width = maps.shape[-2:]
    pupil, free = stated_circle((height, width), center, radius)
    filled = np.asarray(valid.any(axis=tuple(range(valid.ndim - 2))))
    if radius is None and filled.any():
        _require_filled(filled)
    stated, around = pupil, outline(filled, pupil, free) if free.any() else None
    if around is not None:
        pupil = around.circle
    x, y = pupil.coordinates((height, width))
    # A pixel belongs to the pupil if its centre lies in the pupil.
    square = x * x + y * y
    clear = (square <= 1.0) & (square >= eps * eps)
    in_pupil = valid & clear
    wrong = np.argwhere(in_pupil & ~np.isfinite(maps))
    if len(wrong):
        listed = ", ".join(str(tuple(place.tolist())) for place in wrong[:3]) + (", ..." if len(wrong) > 3 else "")
        raise ValueError(f"opd must be finite inside the mask, got NaN or infinity at {len(wrong)} pixels: {listed}")
    if not in_pupil.any(axis=(-2, -1)).all():
        argument = "opd" if mask is None else "mask"
        raise ValueError(f"{argument} must leave samples inside the pupil of every map, got none")
    if mask is None:
        _require_measured(maps.reshape(-1, height, width), in_pupil.reshape(-1, height, width))
    terms = [(n, m) for n in range(highest + 1) for m in range(-n, n + 1, 2)]
    flat_maps = maps.reshape(-1, height, width)
    coefficients = np.empty((len(flat_maps), len(terms)))
    residual = np.full(flat_maps.shape, np.nan)
    covariance = np.empty((len(flat_maps), len(terms), len(terms)))
    missing: list[opd_residual.Missing | None] = [None] * len(flat_maps)
    condition, areas = 1.0, list[tuple[float, Finding]]()
    # Maps with the same valid pixels share their normal equations.
    groups: dict[bytes, list[int]] = {}
    for i, pattern in enumerate(in_pupil.reshape(flat_maps.shape)):
        groups.setdefault(np.packbits(pattern).tobytes(), []).append(i)
    for members in groups.values():
        pixels = in_pupil.reshape(flat_maps.shape)[members[0]]
        rho, theta = np.hypot(x[pixels], y[pixels]), np.arctan2(y[pixels], x[pixels])
        group_fit = _least_squares(rho, theta, flat_maps[members][:, pixels], terms, eps, _test_points(x, y, clear))
        coefficients[members], group_residuals, group_condition = group_fit
        places = np.array(np.nonzero(pixels), dtype=np.int64)
        noise = opd_residual.modes(group_residuals, places, x[pixels], y[pixels], highest, MAX_RADIAL)
        for member, map_residual, map_noise in zip(members, group_residuals, noise, strict=True):
            residual[member][pixels] = map_residual
            covariance[member], missing[member] = map_noise
        condition = max(condition, group_condition)
        areas += _area_findings(x, y, clear, pixels, terms, scale * coefficients[members])
    floor = _RESIDUE * float(np.abs(maps[in_pupil]).max())
    if around is not None:
        # The circle's errors are those of all maps alike.
        for shift in np.diag(around.errors)[around.errors > 0.0]:
            other = Circle(*(np.array(pupil) + shift).tolist())
            moved = coefficients @ (conversion(terms, pupil, other) - np.eye(len(terms))).T
            covariance += moved[:, :, None] * moved[:, None, :]
    errors = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    wave = 2.0 * math.pi / scale
    findings = [
        *_circle_findings(filled, stated, free, around, terms, coefficients, np.fmax(errors, floor), unit),
        *(finding for _, finding in sorted(areas, key=lambda one: one[0])[-1:]),
        *opd_residual.jumps(flat_maps, np.isfinite(residual), wave),
    ]
    if Findings(findings).converged:  # a fit to jumps leaves their outlines
        findings += opd_residual.outliers(residual, wave)
    if Findings(findings).converged:
        findings += opd_residual.misfits(missing, residual, floor, unit, wave)
    return _fit_result(terms, coefficients, covariance, residual, condition, maps.shape[:-2], unit, scale, findings)


def _circle_findings(
    filled: NDArray[np.bool_],
    stated: Circle,
    free: NDArray[np.bool_],
    around: Outline | None,
    terms: list[tuple[int, int]],
    coefficients: Array,
    errors: Array,
    unit: str,
) -> Iterator[Finding]:
    """Yield the finding on the circle of the pupil, with what another one would change in coefficients (maps, terms).

    `around` is the circle of the samples, if it was taken, with `free` values that were not stated.
    """
    used = stated if around is None else around.circle

    def change(other: Circle) -> tuple[str, dict[str, float], bool]:
        moved = np.abs(coefficients @ (conversion(terms, used, other) - np.eye(len(terms))).T)[:, 1:]
        worst, place = divmod(int(np.argmax(moved)), moved.shape[1])
        n, m = terms[place + 1]
        largest = float(moved[worst, place])
        words = f"change terms by up to {largest:.2g} {unit} ({n}, {m})"
        return words, {"moved": largest, "n": n, "m": m}, bool((moved > errors[:, 1:]).any())

    def beyond(circle: Circle) -> bool:
        x, y = circle.coordinates((filled.shape[0], filled.shape[1]))
        return bool((np.hypot(x, y)[filled] > 1.0 + 1e-9).any())

    if around is not None and used != stated:
        words, numbers, _ = change(stated)
        error = f" (+- {around.errors.max():.2g})" if around.errors.any() else ""
        text = f"the pupil was taken to be the circle of the samples, {used}{error} pixels; {stated} would {words}"
        yield Finding("estimated", "note", text, {**used._asdict(), "error": float(around.errors.max()), **numbers})
    elif around is None and free.any():
        other = stated._replace(radius=stated.radius - 0.5)
        if not free[2]:
            other = stated._replace(row=stated.row + 0.5, column=stated.column + 0.5)
        words, numbers, matters = change(other)
        # A circle is excluded by samples beyond it, if they are not beyond the other one, too.
        if matters and (beyond(stated) or not beyond(other)):
            text = f"the outline of the samples does not determine the circle of the pupil: {stated} pixels was "
            text += f"assumed, and {other} would {words}: state {'radius' if free[2] else 'center'}"
            yield Finding("undetermined", "doubt", text, numbers)
    if not free[0] and (found := outline(filled, stated, np.ones(3, dtype=np.bool_))) is not None:
        apart = math.dist(found.circle[:2], stated[:2])
        alike = abs(found.circle.radius - used.radius) < _SAME_RADIUS * used.radius
        if alike and apart > _LEAST_SHIFT + 5.0 * float(found.errors.max()):
            words, numbers, _ = change(found.circle)
            text = f"the samples fill the circle of {found.circle} pixels, whose centre is {apart:.2g} pixels from "
            text += f"the stated center=({stated.row:.5g}, {stated.column:.5g}), and which would {words}"
            yield Finding("contradiction", "doubt", text, {**found.circle._asdict(), **numbers})


def _area_findings(
    x: Array,
    y: Array,
    clear: NDArray[np.bool_],
    samples: NDArray[np.bool_],
    terms: list[tuple[int, int]],
    radians: Array,
) -> Iterator[tuple[float, Finding]]:
    """Yield the finding on areas of the clear pupil without samples, for coefficients (maps, terms), and its size."""
    share = blank_area(clear, samples)
    if share < _NAMED_AREA:
        return
    rho, theta, seen = np.hypot(x, y), np.arctan2(y, x)[clear], samples[clear]
    sums = np.zeros((2, len(radians)), dtype=np.complex128)
    for block, basis in _basis(rho[clear], theta, terms, None):
        field = np.exp(1j * (radians @ basis))
        sums += [field.sum(axis=1), field @ seen[block]]
    whole, part = np.abs(sums / [[seen.size], [seen.sum()]]) ** 2
    changes = np.abs(part - whole) / np.maximum(np.maximum(part, whole), _LOW_STREHL)
    worst = int(np.argmax(changes))
    change, strehl = float(changes[worst]), float(part[worst] / max(whole[worst], 1e-12)) - 1.0
    hole = float(rho[samples].min())
    is_hole = hole**2 > 0.5 * share
    mtf = (_HOLE_MTF if is_hole else 1.0) * share
    text = f"{percent(share, 1)} of the pupil has no samples: over the samples the Strehl ratio is "
    text += f"{percent(abs(strehl), 1)} {'lower' if strehl < 0.0 else 'higher'} than over the whole pupil, and the "
    text += f"MTF differs by up to about {mtf:.2g}: "
    text += f"pass obscuration={hole:.2g}" if is_hole else "give the Pupil this aperture (vignetting=, stop=, mask=)"
    numbers = {"area": share, "strehl": strehl, "mtf": mtf} | ({"obscuration": hole} if is_hole else {})
    doubt = mtf > _DOUBTFUL_MTF or change > _LEAST_STREHL
    yield max(change, mtf), Finding("left_out", "doubt" if doubt else "note", text, numbers)


def opd_map(
    wavefront: Wavefront,
    shape: int | tuple[int, int],
    *,
    unit: str = "radians",
    wavelength: float | None = None,
    center: tuple[float, float] | None = None,
    radius: float | None = None,
) -> Array:
    """Sample a wavefront at the pixels of an OPD map with the axes of :func:`fit_opd`.

    Parameters
    ----------
    wavefront : Wavefront
    shape : int or (int, int)
        Height and width in pixels.
    unit, wavelength, center, radius
        As in :func:`fit_opd`; the unit is radians by default.

    Returns
    -------
    ndarray, shape ``wavefront.shape + (height, width)``
        Map in `unit`, without piston; NaN at pixels whose centre lies outside the pupil.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range.
    """
    validation.instance("wavefront", wavefront, Wavefront)
    scale = radians_per(unit, wavelength)
    size = validation.image_shape(shape)
    x, y = stated_circle(size, center, radius)[0].coordinates(size)
    rho = np.hypot(x, y)
    in_pupil = rho <= 1.0
    values = np.full((*wavefront.shape, *size), np.nan)
    values[..., in_pupil] = wavefront.phase(rho[in_pupil], np.arctan2(y, x)[in_pupil]) / scale
    return values


def _least_squares(
    rho: Array,
    theta: Array,
    values: Array,
    terms: list[tuple[int, int]],
    obscuration: float,
    test_points: tuple[Array, Array],
) -> tuple[Array, Array, float]:
    """Return rms-normalized coefficients (maps, terms), residuals (maps, samples) and the condition number.

    `test_points` holds rho and theta of the points at which the samples must determine the phase.
    """
    # Up to a condition number of MAX_GROWTH, normal equations with one refinement are exact to rounding. Above it,
    # the terms are first made orthonormal on the samples (by a Cholesky factor). This requires that the samples
    # determine the phase at `test_points`.
    over_disc = _over_disc(terms, obscuration)
    if rho.size < len(terms):
        raise ValueError(f"{len(terms)} terms need at least as many samples, got {rho.size}; lower degree")
    weight = 1.0 / rho.size
    # The Gram matrix of orthonormal terms over a full pupil is near the unit matrix.
    gram = np.zeros((len(terms), len(terms)))
    for _, basis in _basis(rho, theta, terms, over_disc):
        gram += (basis * weight) @ basis.T
    eigenvalues = np.linalg.eigvalsh(gram)
    # The condition number of the terms is the square root of the condition number of the Gram matrix.
    low, high = float(eigenvalues[0]), float(eigenvalues[-1])
    condition = math.sqrt(high / low) if low > 0.0 else math.inf
    if not condition <= MAX_GROWTH:
        hint = "" if obscuration else ", or state the obscuration of an annular pupil"
        undetermined = ValueError(
            f"the {rho.size} samples do not determine {len(terms)} terms over the pupil (condition {condition:.2g}); "
            f"lower degree{hint}"
        )
        if not condition <= MAX_ROUNDING:
            raise undetermined
        norm_before = _largest_norm(test_points, terms, over_disc)
        orthonormal = np.linalg.inv(np.linalg.cholesky(gram)).T
        over_disc = orthonormal if over_disc is None else over_disc @ orthonormal
        # At points at which the orthonormal terms have a large norm, the samples do not determine the phase.
        if not 0.0 < _largest_norm(test_points, terms, over_disc) <= MAX_GROWTH * norm_before:
            raise undetermined
        gram = np.zeros_like(gram)
        for _, basis in _basis(rho, theta, terms, over_disc):
            gram += (basis * weight) @ basis.T
    coefficients, residual = np.zeros((len(values), len(terms))), values.copy()
    # The second pass fits the residual of the first, which removes most of its rounding error.
    for _ in range(2):
        moments = np.zeros_like(coefficients)
        for block, basis in _basis(rho, theta, terms, over_disc):
            moments += (residual[:, block] * weight) @ basis.T
        coefficients += np.linalg.solve(gram, moments.T).T
        for block, basis in _basis(rho, theta, terms, over_disc):
            residual[:, block] = values[:, block] - coefficients @ basis
    return coefficients if over_disc is None else coefficients @ over_disc.T, residual, condition


def _test_points(x: Array, y: Array, inside: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return rho and theta midway between four neighbouring pixels that are all `inside`, at most about 128^2."""
    step = max(1, int(math.sqrt(x.size) / 128))
    four = (inside[1:, 1:] & inside[:-1, 1:] & inside[1:, :-1] & inside[:-1, :-1])[::step, ::step]
    x_mid = 0.5 * (x[1:, 1:] + x[:-1, :-1])[::step, ::step][four]
    y_mid = 0.5 * (y[1:, 1:] + y[:-1, :-1])[::step, ::step][four]
    return np.hypot(x_mid, y_mid), np.arctan2(y_mid, x_mid)


def _largest_norm(test_points: tuple[Array, Array], terms: list[tuple[int, int]], over_disc: Array | None) -> float:
    """Return the largest ``sqrt(sum of term^2)`` among the test points; 0 without test points."""
    squares = [(basis**2).sum(axis=0).max() for _, basis in _basis(*test_points, terms, over_disc)]
    return math.sqrt(max(squares, default=0.0))


def _over_disc(terms: list[tuple[int, int]], obscuration: float) -> Array | None:
    """Return the matrix that converts annular coefficients to coefficients over the disc; None for a full disc."""
    if obscuration == 0.0:
        return None
    matrix = np.zeros((len(terms), len(terms)))
    for m in {m for _, m in terms}:
        same_order = [i for i, (_, k) in enumerate(terms) if k == m]  # n increases
        matrix[np.ix_(same_order, same_order)] = zernike.annular(m, terms[same_order[-1]][0], obscuration)
    return matrix


def _basis(
    rho: Array, theta: Array, terms: list[tuple[int, int]], over_disc: Array | None
) -> Iterator[tuple[slice, Array]]:
    """Yield slices of the samples, each with the rms-normalized terms at these samples, shape (terms, samples)."""
    for start in range(0, rho.size, _BLOCK):
        block = slice(start, start + _BLOCK)
        basis = zernike.normalized(terms, rho[block], theta[block])
        yield block, basis if over_disc is None else over_disc.T @ basis


def _fit_result(
    terms: list[tuple[int, int]],
    coefficients: Array,
    covariance: Array,
    residual: Array,
    condition: float,
    stack: tuple[int, ...],
    unit: str,
    scale: float,
    findings: list[Finding],
) -> WavefrontFit:
    """Return the fit from coefficients, covariance and residuals of maps (axis 0; NaN: unused)."""
    flat_residual = residual.reshape(len(residual), -1)
    count = np.isfinite(flat_residual).sum(axis=1)
    # The constant is among the terms, so that the mean of the residual is 0.
    rms = np.sqrt(np.nanmean(flat_residual**2, axis=1))
    radians = {t: scale * c.reshape(stack) for t, c in zip(terms, coefficients.T, strict=True)}
    errors = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    return WavefrontFit(
        wavefront=Wavefront.zernike(radians),
        coefficients={t: numbers(c, stack) for t, c in zip(terms[1:], coefficients.T[1:], strict=True)},
        errors={t: numbers(e, stack) for t, e in zip(terms[1:], errors.T[1:], strict=True)},
        covariance=covariance[:, 1:, 1:].reshape(*stack, len(terms) - 1, len(terms) - 1),
        piston=coefficients[:, terms.index((0, 0))].reshape(stack),
        rms=rms.reshape(stack),
        peak_to_valley=(np.nanmax(flat_residual, axis=1) - np.nanmin(flat_residual, axis=1)).reshape(stack),
        residual=residual.reshape(*stack, *residual.shape[1:]),
        samples=count.reshape(stack),
        condition=condition,
        unit=unit,
        findings=Findings(findings),
    )


def _maps(opd: ArrayLike, mask: ArrayLike | None, unit: str) -> tuple[Array, NDArray[np.bool_]]:
    """Return maps and their valid pixels.

    They are True in `mask` (if any) and not hidden in a masked array; without either, they are not NaN.
    """
    data, masked = validation.parted("opd", opd, unit)
    maps = _real_maps("opd", data)
    if mask is None:
        return maps, ~np.isnan(maps) if masked is None else ~masked
    flags = validation.array("mask", mask)
    if flags.dtype != np.bool_:
        raise TypeError(f"mask must hold booleans, got an array of {flags.dtype}")
    if flags.shape not in (maps.shape[-2:], maps.shape):
        raise ValueError(f"mask must have the shape {maps.shape[-2:]} or that of opd, got {flags.shape}")
    return maps, np.broadcast_to(flags, maps.shape) & (True if masked is None else ~masked)


def _require_filled(valid: NDArray[np.bool_]) -> None:
    """Raise ValueError if all samples lie in a circle clearly smaller than the circle inscribed in the map."""
    places = np.argwhere(valid)
    middle = 0.5 * (places.min(axis=0) + places.max(axis=0))
    radius, pupil = float(np.hypot(*(places - middle).T).max()), 0.5 * min(valid.shape)
    if radius + 1.0 < 0.98 * pupil:
        raise ValueError(
            f"opd must have samples up to the edge of the pupil, by default half the smaller side, {pupil:g} pixels, "
            f"but all samples lie in a circle of radius={radius:.1f} about center=({middle[0]:.1f}, "
            f"{middle[1]:.1f}): pass these values if the circle is the pupil, else the pupil's radius and center"
        )


def _require_measured(maps: Array, pupils: NDArray[np.bool_]) -> None:
    """Raise ValueError if one value fills an area of a map, probably a file's marker for missing pixels."""
    # Neighbouring pixels are rarely equal in real measurements. In quantised maps they are equal about equally
    # often at each level. A single value that has far more equal neighbours than any other is therefore a marker.
    for raw_map, in_pupil in zip(maps, pupils, strict=True):
        residue = _RESIDUE * float(np.abs(raw_map[in_pupil]).max(initial=0.0))
        opd = np.where(np.abs(raw_map) <= residue, 0.0, raw_map)
        equal_pixels = np.zeros_like(in_pupil)
        for pixels, neighbors in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
            pairs = (opd[pixels] == opd[neighbors]) & in_pupil[pixels] & in_pupil[neighbors]
            equal_pixels[pixels] |= pairs
            equal_pixels[neighbors] |= pairs
        values, counts = np.unique(opd[equal_pixels], return_counts=True)
        if not values.size:
            continue
        k, total = int(counts.argmax()), int(in_pupil.sum())
        largest_other = int(np.delete(counts, k).max(initial=0))
        least = max(_MIN_BLANK_PIXELS, _MIN_BLANK_FRACTION * total, _MIN_BLANK_RATIO * largest_other)
        if least <= counts[k] and np.ptp(opd[in_pupil]) > 0.0:
            exact = 2 * np.count_nonzero(equal_pixels & (raw_map == 0.0)) > counts[k]
            condition = "opd != 0" if exact else f"abs(opd) > {residue:.1g}"
            example = f"such as {condition}, or " if values[k] == 0.0 else ""
            raise ValueError(
                f"opd is {values[k]:g} at {counts[k]} neighbouring pixels of the pupil "
                f"({percent(counts[k] / total, 1)}), as in files that mark missing pixels: pass mask=, True at "
                f"measured pixels ({example}True everywhere if these are measured), or obscuration= if these pixels "
                "are the middle of an annular pupil"
            )


def _real_maps(name: str, value: ArrayLike) -> Array:
    """Return a float64 array (..., height, width), NaN allowed; TypeError or ValueError for other values."""
    data = validation.array(name, value)
    if data.dtype.kind not in "iuf":
        raise TypeError(f"{name} must hold real numbers, got an array of {data.dtype}")
    if data.ndim < 2 or data.size == 0:
        raise ValueError(f"{name} must have the shape (..., height, width) and not be empty, got {data.shape}")
    return data.astype(np.float64)
