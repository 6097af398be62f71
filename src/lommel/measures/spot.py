"""Peaks, Strehl ratio, diameters of encircled energy, and widths, in the image and along z."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array, Numbers, numbers
from lommel.core.answers import Wanted
from lommel.measures import aperture_means
from lommel.measures.continuous_image import (
    CartesianImage,
    Image,
    ImageModel,
    PolarImage,
    cartesian_images,
    energy_images,
    in_seeing,
    point_images,
    polar,
)
from lommel.measures.energy import energy_centers, radial_energy, require_radial
from lommel.measures.psf_like import PSFLike, checked
from lommel.methods.layers.samples import HALF, between
from lommel.methods.method import Method, RadialMethod
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.base_pupil import BasePupil
from lommel.optics.grid import Grid
from lommel.optics.layers.objective_pupil import ObjectivePupil

PointImage = CartesianImage | PolarImage

_STEP = 0.15  # spacing of tables in v, over the stretch of the method
_MAX_RADII = 2**16
# Half of the largest full width at half maximum of an image that is not radially symmetric, in lambda*N.
_MAX_WIDTH = 250.0
_MAX_DIAMETER = 6000.0
_MAX_SAMPLED = 1400.0


def peak_position(psf: PSFLike) -> Array:
    """Return the position (x, y) of the largest value, from the axis.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    ndarray, shape ``pupil.shape + (2,)``
        Metres or units of lambda*N. Each coordinate is that of a parabola through the brightest pixel and its
        neighbours, unless the pixel is at the edge of the window; the error is well below a tenth of a pixel for
        pixels of at most half a lambda*N. Of several equally bright pixels, as on a ring, the first in reading order
        counts.
    """
    checked(psf)
    height, width = psf.grid.pitch
    out = [
        (x[column] + width * _vertex(across, column), y[row] + height * _vertex(down, row))
        for x, y, (row, column, across, down) in zip(*psf.positions(), _brightest(psf), strict=True)
    ]
    return np.array(out).reshape(*psf.pupil.shape, 2)


def _brightest(psf: PSFLike) -> Iterator[tuple[int, int, Array, Array]]:
    """Yield row and column of the brightest pixel of each image, and the values along both lines through it."""
    for image in np.asarray(psf.values, dtype=np.float64).reshape(-1, *psf.grid.shape):
        row, column = divmod(int(image.argmax()), psf.grid.width)
        yield row, column, image[row], image[:, column]


def _vertex(line: Array, at: int) -> float:
    """Return the offset from `at` of the vertex of the parabola through three values, at most half a step."""
    if not 0 < at < line.size - 1:
        return 0.0
    before, here, after = line[at - 1 : at + 2]
    # Equal values, as on a saturated peak, have no curvature: the pixel itself counts.
    curvature = 2.0 * here - before - after
    return 0.0 if curvature <= 0.0 else float(np.clip(0.5 * (after - before) / curvature, -0.5, 0.5))


def axis_strehl(psf: PSFLike) -> Numbers:
    """Return the Strehl ratio: intensity on the axis relative to the same aperture without aberration.

    For defocus alone this is ``(sin(C_d) / C_d)^2``. It is computed by the method if that and the pupil are radial,
    else from the wavefront (:func:`lommel.strehl`), and includes blur; for `Geometric`, without diffraction, it is
    that of the pixel on the axis. :func:`lommel.measures.spot.peak_strehl` takes the brightest point instead.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    float or ndarray, shape ``pupil.shape``

    Raises
    ------
    ValueError
        If the axis is outside of the window of a method that has values on the grid only.
    """
    checked(psf)
    method, pupil = psf.method, psf.pupil
    radial = psf.radial_method
    if psf.blur:
        from lommel.blur.recorded import recorded_images

        # The method of the PSF may have been tightened far beyond its tolerance; the named one suffices.
        named, tol = (method, method.tol) if isinstance(method, Polychromatic) else (None, Method.tol)
        made = recorded_images(named, tol, pupil, Grid(1, pupil.scale), psf.blur, Wanted(1.0))[1]
        center = made.values[:, 0, 0].reshape(pupil.shape)
    elif radial is not None:
        # Errors of a profile are relative to its peak, which lies beside the axis for aberrated pupils.
        # From the axis to the last geometric ray and 4 more in v, as the peak is searched elsewhere.
        v = np.array([0.0, *np.linspace(0.0, float(pupil.v(pupil.geometric_radius()).max()) + 4.0, 64)[1:]])
        center = radial.profile(pupil, v).values[:, 0].reshape(pupil.shape)
    elif method.sampling == "center":
        parts = method.components(pupil)
        total = sum(part.weight * np.asarray(aperture_means.strehl(part.pupil)) for part in parts)
        return numbers(total / sum(part.weight for part in parts), pupil.shape)
    else:
        row, column = (round(c) for c in psf.grid.axis)
        if not (0 <= row < psf.grid.height and 0 <= column < psf.grid.width):
            raise ValueError(f"the axis at {psf.grid.center} is outside the window of {type(method).__name__}")
        center = psf.values[..., row, column] / psf.scale
    return numbers(center / method.unaberrated_peak(pupil), pupil.shape)


def peak_strehl(psf: PSFLike) -> Numbers:
    """Return the largest value in the window relative to the peak of the same aperture without aberration.

    The Strehl ratio of the brightest pixel, wherever it is, rather than of the axis
    (:func:`lommel.measures.spot.axis_strehl`). Sampling beside the peak lowers it by less than
    ``(pi pixel / (4 lambda N))^2`` in focus.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
    """
    checked(psf)
    top = psf.values.max(axis=(-2, -1)) / psf.scale
    return numbers(top / psf.method.unaberrated_peak(psf.pupil), psf.pupil.shape)


def fwhm(psf: PSFLike, along: str = "mean", *, of: str = "image") -> Numbers:
    """Return the full width at half maximum (FWHM).

    Parameters
    ----------
    psf : PSF
    along : {"mean", "x", "y"}, default "mean"
        Along columns, rows, or the mean of both.
    of : {"image", "optics"}, default "image"
        "image": optics, blur and, if values are pixel-integrated, the pixel; "optics": the same without the pixel.

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Metres or units of lambda*N: the extent along x or y of the region brighter than half of the maximum,
        including dark rings inside it. For a defocused lens it is about the width of the blur, or of the central
        spike if that is more than twice as bright. Independent of pixel pitch and window. Its error is that of the
        image divided by the slope at half maximum, at both ends: for a tolerance of 1e-6 mostly less than 1e-5 of the
        width.

    Raises
    ------
    ValueError
        If `along` or `of` is unknown, or the image does not fall to half of its maximum within 500 lambda*N.
    """
    validation.choice("along", along, ("mean", "x", "y"))
    model = ImageModel.of(psf, of)
    if model.radial_method is not None:
        return radial_fwhm(model.radial_method, psf.pupil)
    return numbers([width(model, along) for model in model.singles], psf.pupil.shape)


def width(model: ImageModel, along: str = "mean") -> float:
    """Return the full width at half of the maximum of a single image; see :func:`lommel.measures.spot.fwhm`."""
    reach = model.extent
    while True:
        image, values, places, step = _scanned(model, reach)
        half = 0.5 * _maximum(image, values, places, step)[0]
        bright = values >= half
        if not (bright[[0, -1]].any() or bright[:, [0, -1]].any()):
            break
        # Widened by 1.6 until all of the bright region lies inside.
        if reach > _MAX_WIDTH:
            raise ValueError(f"the image does not fall to half of the largest within {2.0 * reach:.4g} lambda*N")
        reach *= 1.6
    found = []
    for turned in {"x": (False,), "y": (True,), "mean": (False, True)}[along]:
        high, low = (_end(image, values, places, half, sign, turned=turned) for sign in (1.0, -1.0))
        found.append(high - low)
    return model.pupil.scale * sum(found) / len(found)


def brightest_place(model: ImageModel) -> tuple[float, float]:
    """Return the brightest place (x, y) of a single image in lambda*N, one of several equal ones."""
    return _maximum(*_scanned(model, model.extent))[1]


def _scanned(model: ImageModel, reach: float) -> tuple[PointImage, Array, Array, float]:
    """Return a single image, its samples up to `reach`, their places along either axis, and the step."""
    (image,) = point_images(model, reach)
    # Eight samples to a period of the highest frequency, so that a maximum between them is at most a sixth larger.
    step = 0.125 / image.band
    places = step * np.arange(-math.floor(reach / step), math.floor(reach / step) + 1.0)
    return image, image.on(places, places), places, step


def _maximum(image: PointImage, values: Array, places: Array, step: float) -> tuple[float, tuple[float, float]]:
    """Return the largest light per area and its place, by Newton's method from the brightest samples."""
    # Local maxima; the highest few may be the largest between samples.
    inner = values[1:-1, 1:-1]
    tops = np.ones(inner.shape, dtype=bool)
    for i, j in ((0, 1), (1, 0), (1, 2), (2, 1)):
        tops &= inner >= values[i : i + inner.shape[0], j : j + inner.shape[1]]
    # Between samples an image is larger by a sixth at most.
    rows, columns = np.nonzero(tops & (inner > 0.85 * values.max()))
    order = np.argsort(inner[rows, columns])[::-1][:6]
    row, column = np.unravel_index(int(values.argmax()), values.shape)
    best, place = float(values.max()), (float(places[column]), float(places[row]))
    for x, y in zip(places[columns[order] + 1], places[rows[order] + 1], strict=True):
        for _ in range(8):
            (_, right, twice_right), (down, cross, _), (twice_down, _, _) = image.derivatives(x, y)
            curvature = np.array([[twice_right, cross], [cross, twice_down]])
            # On a ridge the curvature along it vanishes: the pseudo-inverse does not move that way.
            away = np.clip(-np.linalg.pinv(curvature, rcond=1e-6) @ [right, down], -step, step)
            x, y = x + away[0], y + away[1]
            if np.abs(away).max() < 1e-7 * step:
                break
        if (top := float(image.derivatives(x, y)[0, 0])) > best:
            best, place = top, (float(x), float(y))
    return best, place


def _end(image: PointImage, values: Array, places: Array, half: float, sign: float, *, turned: bool) -> float:
    """Return how far light of at least `half` extends along x (y if `turned`) in the direction of `sign`."""
    lines = (values.T if turned else values)[:, :: int(sign)]
    at = places[:: int(sign)]
    last = lines.shape[1] - 1 - np.argmax((lines >= half)[:, ::-1], axis=1)
    rows = np.flatnonzero((lines >= half).any(axis=1))
    here, beyond = lines[rows, last[rows]], lines[rows, last[rows] + 1]
    # Linear interpolation of the last crossing in each line; the farthest line starts Newton's method.
    crossings = at[last[rows]] + (at[1] - at[0]) * (here - half) / (here - beyond)
    first = int(np.argmax(sign * crossings))
    x, y = float(crossings[first]), float(places[rows[first]])
    step, middle = abs(float(at[1] - at[0])), y

    # Newton in both coordinates: to half of the maximum along, to the brightest place across.
    for _ in range(20):
        found = image.derivatives(y, x).T if turned else image.derivatives(x, y)
        (light, slope, _), (sideways, _, _), (bend, _, _) = found
        aside = float(np.clip(y - sideways / bend, middle - step, middle + step)) - y if bend < 0.0 else 0.0
        y += aside
        along = float(np.clip((half - light) / slope, -step, step)) if slope else 0.0
        x += along
        if max(abs(along), abs(aside)) < 1e-10 * step:
            break
    return x


def radial_fwhm(method: RadialMethod, pupil: BasePupil) -> Numbers:
    """Return the full width at half maximum of a radial pupil from its interpolated profile."""
    # Polynomials of degree 11 through steps of 0.15 in v: I is of exponential type 2 at one wavelength, so this adds
    # less than 2e-11 of the peak of the aperture without aberration.
    require_radial(method, pupil)
    far = float(pupil.v(pupil.geometric_radius()).max()) + 12.0
    step = _STEP / method.stretch(pupil)
    # Interpolation takes twelve places, six of them beyond the last crossing.
    places = step * np.arange(math.ceil(far / step) + HALF, dtype=np.float64)
    table = method.profile(pupil, places).values
    out = np.empty(len(table))
    fine = np.linspace(0.0, 1.0, 65)
    for i, values in enumerate(table):
        line = _Even(values)
        top = int(values.argmax())
        near = np.concatenate([max(top - 1, 0) + fine, top + fine])
        # Two refinements: the position of a flat maximum is uncertain, its value is not.
        # The search interval is the two steps around the largest sample.
        best = float(near[np.argmax(line(near))])
        peak = float(line(np.clip(best + (fine - 0.5) / 32.0, 0.0, None)).max())
        last = int(np.flatnonzero(values > 0.5 * peak)[-1])
        if last > values.size - HALF - 1:
            raise ValueError(f"the intensity does not fall to half of the largest within v = {far:.3g}")
        out[i] = 2.0 * step * line.falls_to(0.5 * peak, last, last + 1)
    return numbers(out * (pupil.scale / math.pi), pupil.shape)


def energy_diameter(psf: PSFLike, fraction: float, *, about: str = "axis", of: str = "image") -> Numbers:
    """Return the diameter of the circle that holds `fraction` of all light: 0.5 for D50, 0.8 for D80.

    Parameters
    ----------
    psf : PSF
    fraction : float
        Above 0 and below 1.
    about : {"axis", "centroid"}, default "axis"
    of : {"image", "optics"}, default "image"
        As of :func:`lommel.measures.energy.encircled_energy`.

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Metres or units of lambda*N. Its error is that of the encircled energy divided by its slope.

    Raises
    ------
    ValueError
        If `fraction`, `about` or `of` is out of range, or the circle would be wider than about 6000 lambda*N, for a
        pupil that is not radially symmetric than some 1400 lambda*N.
    """
    from scipy.optimize import brentq

    wanted = validation.real("fraction", fraction, above=0.0, below=1.0)
    model, pupil = ImageModel.of(psf, of), psf.pupil
    centers = energy_centers(psf, about) / pupil.scale
    if model.radial_method is not None:
        return radial_diameter(model.radial_method, pupil, wanted)
    out = []
    for one, (x, y) in zip(model.singles, centers, strict=True):
        # Circles must stay within one period of an image of samples.
        within = 0.5 * one.method.period(one.pupil) - math.hypot(x, y)
        reach = min(one.extent, max(within, 0.0))
        while True:
            (image,) = energy_images(one, reach + math.hypot(x, y), "fraction")

            def lacks(radius: float, image: Image = image, center: tuple[float, float] = (x, y)) -> float:
                return float(image.circles(np.array([radius]), center)[0]) - wanted

            if lacks(reach) >= 0.0:
                break
            # Four times the current reach bounds the next diameter.
            if reach >= within or 4.0 * reach > (_MAX_DIAMETER if polar(one) or in_seeing(one) else _MAX_SAMPLED):
                raise ValueError(
                    f"fraction must be held by a circle of at most {2.0 * reach:.4g} lambda*N, got {wanted:g}"
                )
            reach = min(2.0 * reach, within)
        out.append(2.0 * brentq(lacks, 0.0, reach, xtol=1e-10))
    return numbers(out, pupil.shape) * pupil.scale


def radial_diameter(method: RadialMethod, pupil: BasePupil, fraction: float) -> Numbers:
    """Return the diameter that holds `fraction` of the light; see :func:`lommel.measures.spot.energy_diameter`."""
    wanted = validation.real("fraction", fraction, above=0.0, below=1.0)
    require_radial(method, pupil)
    unit = pupil.scale / math.pi
    step = _STEP / method.stretch(pupil)
    count = 64 + math.ceil(float(pupil.v(pupil.geometric_radius()).max()) / step)
    while True:
        table = np.asarray(radial_energy(method, pupil, step * unit * np.arange(count))).reshape(-1, count)
        if np.all(table[:, -HALF - 1] >= wanted):
            break
        if count >= _MAX_RADII:
            raise ValueError(
                f"fraction must be held by a circle of at most {2 * step * count / math.pi:.4g} lambda*N, "
                f"got {wanted:g}"
            )
        count = min(4 * count, _MAX_RADII)
    out = np.empty(len(table))
    for i, values in enumerate(table):
        cross = int(np.argmax(values >= wanted))
        out[i] = 2.0 * step * _Even(-values).falls_to(-wanted, cross - 1, cross)
    return numbers(out * unit, pupil.shape)


class _Even:
    """Even function known at 0, 1, 2, ...; between them the polynomial through the twelve nearest values."""

    def __init__(self, values: Array) -> None:
        self.values = np.concatenate([values[HALF:0:-1], values])

    def __call__(self, at: Array) -> Array:
        """Return the values at places >= 0, up to the sixth last known one."""
        first, weights = between(at)
        known = self.values[first[:, None] + np.arange(HALF, 3 * HALF)]
        return np.asarray((known * weights).sum(axis=1))

    def falls_to(self, level: float, low: float, high: float) -> float:
        """Return the place between `low` and `high` at which the values fall to `level`."""
        from scipy.optimize import brentq

        return float(brentq(lambda at: float(self(np.array([at]))[0]) - level, low, high, xtol=1e-15))


def stage(psf: PSFLike) -> Array:
    """Return the stage positions z of a stack of planes, increasing along its last axis, metres.

    Parameters
    ----------
    psf : PSF
        Of an :class:`lommel.Objective`, a stack over z.

    Returns
    -------
    ndarray, shape ``pupil.shape``

    Raises
    ------
    ValueError
        If `psf` is of a lens, a single plane, of several depths along that axis, or not in order of z.
    """
    pupil = checked(psf).pupil
    if not isinstance(pupil, ObjectivePupil):
        raise ValueError("z is what an Objective's stage does; this is the PSF of a lens")
    if not pupil.shape or pupil.shape[-1] < 2:
        raise ValueError(f"z must be that of a stack of planes, got one of shape {pupil.shape}")
    if np.ptp(pupil.depth, axis=-1).any():
        raise ValueError("z must be all that planes along the last axis of the stack differ in, got several depths")
    if not (np.diff(pupil.focus, axis=-1) > 0.0).all() or not (np.diff(pupil.z, axis=-1) > 0.0).all():
        raise ValueError("z must rise along the last axis of the stack")
    return pupil.z


def axial_fwhm(psf: PSFLike, *, of: str = "image") -> Numbers:
    """Return the full width at half maximum along z.

    Parameters
    ----------
    psf : PSF
        A stack over z along its last axis, of at least 4 planes.
    of : {"image", "optics"}, default "image"
        "image": with the pixel, if values are pixel-integrated; "optics": without it.

    Returns
    -------
    float or ndarray, shape ``pupil.shape[:-1]``
        Metres of the stage: on the axis for radially symmetric PSFs, else at the brightest pixel of the stack. By
        cubic splines through the planes, to about 1 % for steps of at most half of ``axial`` of
        :meth:`lommel.Objective.nyquist`.

    Raises
    ------
    ValueError
        If `psf` is not such a stack, `of` is unknown, or the values do not fall to half of the maximum on both sides.
    """
    from scipy.interpolate import CubicSpline

    model, z = ImageModel.of(psf, of), stage(psf)
    if z.shape[-1] < 4:
        raise ValueError(f"the width along z takes at least 4 planes, got {z.shape[-1]}")
    lines = _lines(psf, model).reshape(-1, z.shape[-1])
    out = []
    for places, line in zip(z.reshape(lines.shape), lines, strict=True):
        spline = CubicSpline(places, line)
        turns = spline.derivative().roots(extrapolate=False)
        tops = np.append(turns[np.isfinite(turns)], places[line.argmax()])
        top = float(tops[np.argmax(spline(tops))])
        crossings = spline.solve(0.5 * float(spline(top)), extrapolate=False)
        below, above = crossings[crossings < top], crossings[crossings > top]
        if not (below.size and above.size):
            raise ValueError("the values do not fall to half of the largest on both sides within the stack")
        out.append(float(above.min() - below.max()))
    return numbers(out, z.shape[:-1])


def _lines(psf: PSFLike, model: ImageModel) -> Array:
    """Return the light along z for each plane, in the shape of the stack."""
    pupil = psf.pupil
    if model.radial_method is not None:
        found = model.radial_method.profile(pupil, np.zeros(1)).values
        return np.asarray(psf.scale * found.reshape(pupil.shape))
    planes = pupil.shape[-1]
    # A line through the brightest pixel of the whole stack: off axis where aberrations move the light.
    brightest = psf.values.reshape(-1, planes, math.prod(psf.grid.shape)).max(axis=2).argmax(axis=1)
    lines = []
    for k, stack in enumerate(np.ndindex(pupil.shape[:-1])):
        here = model._replace(pupil=pupil[stack]) if stack else model
        place = (0.0, 0.0)
        if psf.radial_method is None:
            place = brightest_place(here._replace(pupil=here.pupil[brightest[k]]))
        images = cartesian_images(here, float(np.abs(place).max()))
        lines.append([float(image.derivatives(*place)[0, 0]) for image in images])
    # `scale` includes the excitation of each plane, such as that of a light sheet.
    return np.asarray(psf.scale * np.array(lines).reshape(pupil.shape))
