"""Strehl ratio, diameter of encircled energy, and full widths at half maximum in x, y and z."""

from __future__ import annotations

import math

import numpy as np
import scipy

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
    is_lens_in_seeing,
    is_radial_lens,
    point_images,
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

# Step of radial tables in the optical unit v of the shortest wavelength; v = pi at the radius lambda*N.
_STEP = 0.15
_MAX_RADII = 2**16  # largest number of radii in a table of encircled energy
# Half-width of the sampled square, lambda*N, above which the search for the half maximum does not enlarge it.
_MAX_HALF_WIDTH = 250.0
# Largest diameter of encircled energy, lambda*N: by quadrature over the OTF, and from samples of the image.
_MAX_DIAMETER, _MAX_SAMPLED_DIAMETER = 6000.0, 1400.0


def axis_strehl(psf: PSFLike) -> Numbers:
    """Return the Strehl ratio, the intensity on the axis relative to the same aperture without aberrations.

    For defocus alone it is ``(sin(C_d) / C_d)^2``. Blur is included. A radially symmetric PSF is computed by its
    method, any other PSF from the wavefront (:func:`lommel.strehl`). For `Geometric`, a method without diffraction,
    the function uses the value of the pixel on the axis. :func:`lommel.measures.spot.peak_strehl` uses the brightest
    pixel instead.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Strehl ratio.

    Raises
    ------
    ValueError
        If the axis is outside the window of a PSF by `Geometric`.
    """
    checked(psf)
    method, pupil = psf.method, psf.pupil
    radial = psf.radial_method
    if psf.blur:
        from lommel.blur.recorded import recorded_images

        # psf.method may have a far smaller tolerance than the user requested; the default tolerance suffices here.
        requested, tol = (method, method.tol) if isinstance(method, Polychromatic) else (None, Method.tol)
        images = recorded_images(requested, tol, pupil, Grid(1, pupil.scale), psf.blur, Wanted(1.0))[1]
        center = images.values[:, 0, 0].reshape(pupil.shape)
    elif radial is not None:
        # The error of a profile is relative to its largest value, so that the radii must include the peak, which
        # lies between the axis and the outermost geometric ray (plus 4 in v).
        v = np.array([0.0, *np.linspace(0.0, float(pupil.v(pupil.geometric_radius()).max()) + 4.0, 64)[1:]])
        center = radial.profile(pupil, v).values[:, 0].reshape(pupil.shape)
    elif method.sampling == "center":
        parts = method.components(pupil)
        total = sum(part.weight * np.asarray(aperture_means.strehl(part.pupil)) for part in parts)
        return numbers(total / sum(part.weight for part in parts), pupil.shape)
    else:
        row, column = (round(c) for c in psf.grid.axis)
        if not (0 <= row < psf.grid.height and 0 <= column < psf.grid.width):
            raise ValueError(
                f"the axis must lie in the window for a Strehl ratio by {type(method).__name__}, got the axis at "
                f"{psf.grid.center}"
            )
        center = psf.values[..., row, column] / psf.scale
    return numbers(center / method.unaberrated_peak(pupil), pupil.shape)


def peak_strehl(psf: PSFLike) -> Numbers:
    """Return the largest value in the window relative to the peak of the same aperture without aberrations.

    In contrast to :func:`lommel.measures.spot.axis_strehl` the brightest pixel may lie anywhere in the window. Pixels
    centred beside the peak lower the ratio by less than ``(pi pixel / (4 lambda N))^2`` in focus.

    Parameters
    ----------
    psf : PSF

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Strehl ratio.
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
        Direction of the width, or "mean" for the mean of the widths along x and y.
    of : {"image", "optics"}, default "image"
        "image": optics, blur and, if values are pixel-integrated, the pixel; "optics": optics and blur only.

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Width in metres or units of lambda*N: the extent along x or y of the region brighter than half of the maximum,
        including dark rings inside this region. For a defocused lens the width is about that of the blur, or of the
        central spike if the spike is more than twice as bright as the blur. The width is independent of pixel pitch
        and window. Its error is mostly less than 1e-5 of the width for a tolerance of 1e-6 (at each end, the error of
        the image divided by the slope at half maximum).

    Raises
    ------
    ValueError
        If `along` or `of` is unknown, or if the full width exceeds about 500 lambda*N.
    """
    validation.choice("along", along, ("mean", "x", "y"))
    model = ImageModel.of(psf, of)
    if model.radial_method is not None:
        return radial_fwhm(model.radial_method, psf.pupil)
    return numbers([width(model, along) for model in model.single_models], psf.pupil.shape)


def width(model: ImageModel, along: str = "mean") -> float:
    """Return the full width at half maximum of a single image; see :func:`lommel.measures.spot.fwhm`."""
    reach = model.extent
    while True:
        image, values, points, step = _sampled_image(model, reach)
        level = 0.5 * _maximum(image, values, points, step)[0]
        is_bright = values >= level
        if not (is_bright[[0, -1]].any() or is_bright[:, [0, -1]].any()):
            break
        # Enlarge the square until the region above half maximum lies inside.
        if reach > _MAX_HALF_WIDTH:
            raise ValueError(
                f"the image must fall to half of its maximum within {reach:.4g} lambda*N of the axis to have a FWHM"
            )
        reach *= 1.6
    widths = []
    for transposed in {"x": (False,), "y": (True,), "mean": (False, True)}[along]:
        high, low = (_end(image, values, points, level, sign, transposed=transposed) for sign in (1.0, -1.0))
        widths.append(high - low)
    return model.pupil.scale * sum(widths) / len(widths)


def brightest_position(model: ImageModel) -> tuple[float, float]:
    """Return the position (x, y) of the maximum of a single image, lambda*N; one of several equal maxima."""
    return _maximum(*_sampled_image(model, model.extent))[1]


def _sampled_image(model: ImageModel, reach: float) -> tuple[PointImage, Array, Array, float]:
    """Return a single image, samples on a square lattice of half-side `reach`, their x (or y), and the step."""
    (image,) = point_images(model, reach)
    # With eight samples per period of the highest frequency the maximum is at most a sixth larger than a sample.
    step = 0.125 / image.band
    points = step * np.arange(-math.floor(reach / step), math.floor(reach / step) + 1.0)
    return image, image.on(points, points), points, step


def _maximum(image: PointImage, values: Array, points: Array, step: float) -> tuple[float, tuple[float, float]]:
    """Return the maximum of the light per area and its position, by Newton's method from the brightest samples."""
    inner = values[1:-1, 1:-1]
    tops = np.ones(inner.shape, dtype=bool)
    for i, j in ((0, 1), (1, 0), (1, 2), (2, 1)):
        tops &= inner >= values[i : i + inner.shape[0], j : j + inner.shape[1]]
    # A local maximum is at most a sixth larger than its sample. Near samples below 0.85 of the largest sample it is
    # therefore smaller than the largest sample.
    rows, columns = np.nonzero(tops & (inner > 0.85 * values.max()))
    order = np.argsort(inner[rows, columns])[::-1][:6]
    row, column = np.unravel_index(int(values.argmax()), values.shape)
    peak, position = float(values.max()), (float(points[column]), float(points[row]))
    for x, y in zip(points[columns[order] + 1], points[rows[order] + 1], strict=True):
        for _ in range(8):
            (_, d_x, d_xx), (d_y, d_xy, _), (d_yy, _, _) = image.derivatives(x, y)
            curvature = np.array([[d_xx, d_xy], [d_xy, d_yy]])
            # Along a ridge the curvature is 0: the pseudo-inverse makes no step in this direction.
            shift = np.clip(-np.linalg.pinv(curvature, rcond=1e-6) @ [d_x, d_y], -step, step)
            x, y = x + shift[0], y + shift[1]
            if np.abs(shift).max() < 1e-7 * step:
                break
        if (top := float(image.derivatives(x, y)[0, 0])) > peak:
            peak, position = top, (float(x), float(y))
    return peak, position


def _end(image: PointImage, values: Array, points: Array, level: float, sign: float, *, transposed: bool) -> float:
    """Return the largest (`sign` 1) or smallest (-1) x, or y if `transposed`, with `level` as the light per area."""
    lines = (values.T if transposed else values)[:, :: int(sign)]
    x_points = points[:: int(sign)]
    last = lines.shape[1] - 1 - np.argmax((lines >= level)[:, ::-1], axis=1)
    rows = np.flatnonzero((lines >= level).any(axis=1))
    inner, outer = lines[rows, last[rows]], lines[rows, last[rows] + 1]
    # Interpolate the last crossing of `level` in each line linearly; Newton's method starts from the farthest
    # crossing.
    crossings = x_points[last[rows]] + (x_points[1] - x_points[0]) * (inner - level) / (inner - outer)
    farthest = int(np.argmax(sign * crossings))
    x, y = float(crossings[farthest]), float(points[rows[farthest]])
    step, middle = abs(float(x_points[1] - x_points[0])), y

    # Alternate Newton steps: along y to the maximum of the light, along x to the value `level`.
    for _ in range(20):
        derivatives = image.derivatives(y, x).T if transposed else image.derivatives(x, y)
        (value, slope_x, _), (slope_y, _, _), (curvature_y, _, _) = derivatives
        dy = 0.0
        if curvature_y < 0.0:
            dy = float(np.clip(y - slope_y / curvature_y, middle - step, middle + step)) - y
        y += dy
        dx = float(np.clip((level - value) / slope_x, -step, step)) if slope_x else 0.0
        x += dx
        if max(abs(dx), abs(dy)) < 1e-10 * step:
            break
    return x


def radial_fwhm(method: RadialMethod, pupil: BasePupil) -> Numbers:
    """Return the full width at half maximum of a radial pupil from its interpolated profile."""
    # The profile I(v) of one wavelength is of exponential type 2. Polynomials of degree 11 through samples at steps
    # of 0.15 in v differ from I(v) by less than 2e-11 of the peak of the aperture without aberrations.
    require_radial(method, pupil)
    reach = float(pupil.v(pupil.geometric_radius()).max()) + 12.0
    step = _STEP / method.stretch(pupil)
    # Interpolation uses twelve samples, six of them beyond the last crossing.
    points = step * np.arange(math.ceil(reach / step) + HALF, dtype=np.float64)
    table = method.profile(pupil, points).values
    widths = np.empty(len(table))
    fractions = np.linspace(0.0, 1.0, 65)
    for i, values in enumerate(table):
        line = _EvenInterpolation(values)
        top = int(values.argmax())
        # Scan both steps beside the largest sample, then 1/32 of a step around the best point. This suffices, because
        # an error of the position of a maximum hardly changes its value.
        scan = np.concatenate([max(top - 1, 0) + fractions, top + fractions])
        position = float(scan[np.argmax(line(scan))])
        peak = float(line(np.clip(position + (fractions - 0.5) / 32.0, 0.0, None)).max())
        last = int(np.flatnonzero(values > 0.5 * peak)[-1])
        if last > values.size - HALF - 1:
            raise ValueError(f"the image must fall to half of its maximum within v = {reach:.3g} of the axis")
        widths[i] = 2.0 * step * line.falls_to(0.5 * peak, last, last + 1)
    return numbers(widths * (pupil.scale / math.pi), pupil.shape)


def energy_diameter(psf: PSFLike, fraction: float, *, about: str = "axis", of: str = "image") -> Numbers:
    """Return the diameter of the circle that contains a fraction of all light: 0.5 for D50, 0.8 for D80.

    Parameters
    ----------
    psf : PSF
    fraction : float
        Fraction of all light, above 0 and below 1.
    about : {"axis", "centroid"}, default "axis"
    of : {"image", "optics"}, default "image"
        As in :func:`lommel.measures.energy.encircled_energy`.

    Returns
    -------
    float or ndarray, shape ``pupil.shape``
        Diameter D in metres or units of lambda*N. Its error is that of the encircled energy E divided by dE / dD.

    Raises
    ------
    ValueError
        If an argument is out of range, or if the diameter exceeds about 6000 lambda*N (1400 lambda*N for a pupil that
        is not radially symmetric).
    """
    target = validation.real("fraction", fraction, above=0.0, below=1.0)
    model, pupil = ImageModel.of(psf, of), psf.pupil
    centers = energy_centers(psf, about) / pupil.scale
    if model.radial_method is not None:
        return radial_diameter(model.radial_method, pupil, target)
    diameters = []
    for single, (x, y) in zip(model.single_models, centers, strict=True):
        # A circle must lie within one period of a periodic image.
        max_radius = 0.5 * single.method.period(single.pupil) - math.hypot(x, y)
        reach = min(single.extent, max(max_radius, 0.0))
        while True:
            (image,) = energy_images(single, reach + math.hypot(x, y), "fraction")

            def excess(radius: float, image: Image = image, center: tuple[float, float] = (x, y)) -> float:
                return float(image.circles(np.array([radius]), center)[0]) - target

            if excess(reach) >= 0.0:
                break
            # The next diameter is at most 4 * reach.
            limit = _MAX_DIAMETER if is_radial_lens(single) or is_lens_in_seeing(single) else _MAX_SAMPLED_DIAMETER
            if reach >= max_radius or 4.0 * reach > limit:
                raise ValueError(
                    f"fraction must be reached within a diameter of {2.0 * reach:.4g} lambda*N, got {target:g}; "
                    "use a smaller fraction"
                )
            reach = min(2.0 * reach, max_radius)
        diameters.append(2.0 * scipy.optimize.brentq(excess, 0.0, reach, xtol=1e-10))
    return numbers(diameters, pupil.shape) * pupil.scale


def radial_diameter(method: RadialMethod, pupil: BasePupil, fraction: float) -> Numbers:
    """Return the diameter for a radially symmetric pupil; see :func:`lommel.measures.spot.energy_diameter`."""
    target = validation.real("fraction", fraction, above=0.0, below=1.0)
    require_radial(method, pupil)
    unit = pupil.scale / math.pi
    step = _STEP / method.stretch(pupil)
    count = 64 + math.ceil(float(pupil.v(pupil.geometric_radius()).max()) / step)
    while True:
        table = np.asarray(radial_energy(method, pupil, step * unit * np.arange(count))).reshape(-1, count)
        if np.all(table[:, -HALF - 1] >= target):
            break
        if count >= _MAX_RADII:
            raise ValueError(
                f"fraction must be reached within a diameter of {2 * step * count / math.pi:.4g} lambda*N, "
                f"got {target:g}; use a smaller fraction"
            )
        count = min(4 * count, _MAX_RADII)
    diameters = np.empty(len(table))
    for i, values in enumerate(table):
        crossing = int(np.argmax(values >= target))
        diameters[i] = 2.0 * step * _EvenInterpolation(-values).falls_to(-target, crossing - 1, crossing)
    return numbers(diameters * unit, pupil.shape)


class _EvenInterpolation:
    """Interpolation of an even function from its values at 0, 1, 2, ..., by polynomials through twelve values."""

    def __init__(self, values: Array) -> None:
        self.values = np.concatenate([values[HALF:0:-1], values])

    def __call__(self, points: Array) -> Array:
        """Interpolate at points from 0 up to the sixth value from the end."""
        start, weights = between(points)
        samples = self.values[start[:, None] + np.arange(HALF, 3 * HALF)]
        return np.asarray((samples * weights).sum(axis=1))

    def falls_to(self, level: float, low: float, high: float) -> float:
        """Return the point between `low` and `high` at which the function falls to `level`."""
        return float(scipy.optimize.brentq(lambda x: float(self(np.array([x]))[0]) - level, low, high, xtol=1e-15))


def stage(psf: PSFLike) -> Array:
    """Return the stage positions z of a focal stack, which increase along its last axis, metres.

    Parameters
    ----------
    psf : PSF
        PSF of an :class:`lommel.Objective`, a stack over z along its last axis.

    Returns
    -------
    ndarray, shape ``pupil.shape``
        Stage positions, metres.

    Raises
    ------
    ValueError
        If `psf` is the PSF of a lens or of a single plane, or if z does not increase or the depth of the emitter
        changes along the last axis.
    """
    pupil = checked(psf).pupil
    if not isinstance(pupil, ObjectivePupil):
        raise ValueError("psf must be the PSF of an Objective, whose stage has positions z, got the PSF of a lens")
    if not pupil.shape or pupil.shape[-1] < 2:
        raise ValueError(f"psf must be a stack of at least two planes z, got one of shape {pupil.shape}")
    if np.ptp(pupil.depth, axis=-1).any():
        raise ValueError("depth must be constant along the last axis of the stack, got several depths")
    if not (np.diff(pupil.focus, axis=-1) > 0.0).all() or not (np.diff(pupil.z, axis=-1) > 0.0).all():
        raise ValueError("z must increase along the last axis of the stack: sort the planes by z")
    return pupil.z


def axial_fwhm(psf: PSFLike, *, of: str = "image") -> Numbers:
    """Return the full width at half maximum along z.

    Parameters
    ----------
    psf : PSF
        PSF of an :class:`lommel.Objective`, a stack of at least 4 planes z along its last axis.
    of : {"image", "optics"}, default "image"
        "image": with the pixel, if values are pixel-integrated; "optics": without the pixel.

    Returns
    -------
    float or ndarray, shape ``pupil.shape[:-1]``
        Width in metres of stage travel, along the axis for a radially symmetric PSF, else through the brightest point
        of the stack. Cubic splines interpolate between the planes. The error is about 1 % if the step of z is at most
        half of ``axial`` in :meth:`lommel.Objective.nyquist`.

    Raises
    ------
    ValueError
        If `psf` is not a stack as described, if `of` is unknown, or if the light does not fall to half of its maximum
        on both sides within the stack.
    """
    model, z = ImageModel.of(psf, of), stage(psf)
    if z.shape[-1] < 4:
        raise ValueError(f"the width along z needs at least 4 planes, got {z.shape[-1]}")
    lines = _axial_lines(psf, model).reshape(-1, z.shape[-1])
    widths = []
    for points, line in zip(z.reshape(lines.shape), lines, strict=True):
        spline = scipy.interpolate.CubicSpline(points, line)
        extrema = spline.derivative().roots(extrapolate=False)
        tops = np.append(extrema[np.isfinite(extrema)], points[line.argmax()])
        top = float(tops[np.argmax(spline(tops))])
        crossings = spline.solve(0.5 * float(spline(top)), extrapolate=False)
        lower, upper = crossings[crossings < top], crossings[crossings > top]
        if not (lower.size and upper.size):
            raise ValueError("the stack must extend in z until the light falls to half of its maximum on both sides")
        widths.append(float(upper.min() - lower.max()))
    return numbers(widths, z.shape[:-1])


def profile_width(profile: Array) -> float:
    """Return the full width at half maximum of a profile about its maximum, in steps between its samples."""
    roots = scipy.interpolate.CubicSpline(np.arange(profile.size), profile - 0.5 * profile.max()).roots(
        extrapolate=False
    )
    before, after = roots[roots < profile.argmax()], roots[roots > profile.argmax()]
    if not before.size or not after.size:
        raise ValueError("the focus is too wide to have a width at half maximum")
    return float(after[0] - before[-1])


def _axial_lines(psf: PSFLike, model: ImageModel) -> Array:
    """Return the light in each plane on the axis, or on a parallel line through the brightest point, as a stack."""
    pupil = psf.pupil
    if model.radial_method is not None:
        on_axis = model.radial_method.profile(pupil, np.zeros(1)).values
        return np.asarray(psf.scale * on_axis.reshape(pupil.shape))
    planes = pupil.shape[-1]
    # The line runs through the maximum of the brightest plane, which aberrations may move off the axis.
    brightest = psf.values.reshape(-1, planes, math.prod(psf.grid.shape)).max(axis=2).argmax(axis=1)
    lines = []
    for k, stack in enumerate(np.ndindex(pupil.shape[:-1])):
        planes_model = model._replace(pupil=pupil[stack]) if stack else model
        position = (0.0, 0.0)
        if psf.radial_method is None:
            position = brightest_position(planes_model._replace(pupil=planes_model.pupil[brightest[k]]))
        images = cartesian_images(planes_model, float(np.abs(position).max()))
        lines.append([float(image.derivatives(*position)[0, 0]) for image in images])
    # `scale` includes the excitation of each plane, for example by a light sheet.
    return np.asarray(psf.scale * np.array(lines).reshape(pupil.shape))
