"""Traced plans: PSFs as differentiable functions of wavefront coefficients, for JAX, PyTorch and the array API."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.core.answers import ToleranceError
from lommel.methods.derivative_names import Name
from lommel.methods.method import Method
from lommel.methods.pixel_rule import averaging_error, cells_of_quarter, pixel_rule
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.colour.spectrum import Component
from lommel.optics.grid import Grid
from lommel.optics.pupil import Pupil
from lommel.special.legendre import gauss_legendre
from lommel.traced import certificate, chordal
from lommel.traced.chordal import UNIT, Chordal, Radial
from lommel.traced.namespaces import Namespace, Operand, Tables, Tensor

_NUMPY_TYPES = (np.ndarray, np.generic)
_ERROR_REDUCTION = 0.1  # smallest factor from the allowed quadrature error of a trial to that of the next trial
_MIN_ERROR = 2.0**-52  # smallest allowed quadrature error of a trial; rounding errors are larger
# Trials choose the numbers of nodes. They test only some pupils, because each evaluation checks its own error bound.
# Numbers of tested pupils: members of the stack, pupils between them, and members with random signs of the terms.
_TESTED_MEMBERS, _TESTED_BETWEEN, _TESTED_SIGNS = 128, 48, 128
_BLOCK_VALUES = 2**21  # largest number of values in memory during trials
_RULE_ERROR = 1e-11  # assumed error of PixelRule / largest intensity: ten times the largest measured error
_MAX_SAMPLES = 24  # largest number of samples along a side of a pixel
_X64 = '; call jax.config.update("jax_enable_x64", True) first, or choose a tolerance that float32 can prove'


class Pixels(NamedTuple):
    """Conversion of intensity samples to images: pixel averages, and mirroring of quadrants.

    Attributes
    ----------
    height, width : int
        Sides of the image, pixels.
    mirrored : bool
        Whether values are computed for one quadrant of the image and mirrored.
    growth : float
        Largest factor by which averaging multiplies errors of samples; 0 for point samples.
    added : float
        Error of averaging: relative to the largest intensity if `samples` is 0, otherwise absolute.
    samples : int
        Number of samples along a side of each pixel if samples form a lattice (for pupils that are not radial, and
        for off-axis pixel averages); 0 if samples are at distinct radii.
    """

    height: int
    width: int
    mirrored: bool
    growth: float
    added: float
    samples: int = 0

    def means(
        self, ns: Namespace, tables: Tables, values: Tensor, error: Tensor, unit: float
    ) -> tuple[Tensor, Tensor]:
        """Return averages of intensities over pixels (or unchanged point samples), and bounds on their errors."""
        xp = ns.xp
        if self.samples > 1:
            if "index" in tables:
                values = xp.take(values, tables["index"], axis=-1)
            shape = (self.width, self.samples, self.height, self.samples, values.shape[0])
            values = xp.sum(xp.reshape(xp.permute_dims(values, (1, 0)), shape) * tables["weights"], axis=(1, 3))
            # Rounding of a sum of samples^2 products: two roundings per product.
            error = error + self.added + 2.0 * self.samples**2 * unit * xp.max(ns.stop(values), axis=(0, 1))
            return xp.permute_dims(xp.reshape(values, (-1, values.shape[-1])), (1, 0)), error
        if self.growth:
            peak = xp.max(ns.stop(values), axis=-1)
            rounding = (values.shape[-1] + 2) * unit + 2.0 * ns.coarseness(unit)
            # A weighted sum multiplies errors by at most the sum of its absolute weights, `growth`.
            return ns.matmul(values, tables["matrix"]), self.growth * (error + rounding * peak) + self.added * peak
        return values, error

    def unfold(self, ns: Namespace, tables: Tables, values: Tensor) -> Tensor:
        """Return images (n, height, width) from values at distinct radii, in octant cells, or in pixels by column."""
        xp = ns.xp
        if self.samples:
            by_column = xp.reshape(xp.permute_dims(values, (1, 0)), (self.width, self.height, values.shape[0]))
            return ns.transposed(by_column)
        values = xp.take(values, tables["index"], axis=-1)
        if not self.mirrored:
            return xp.reshape(values, (values.shape[0], self.height, self.width))
        half_height, half_width = self.height // 2, self.width // 2
        quarter = xp.reshape(values, (values.shape[0], half_height + 1, half_width + 1))
        # The central row and column are not repeated; for even sides the first row and column have no mirror image.
        right_half = quarter[..., : half_width + 1 - (self.width + 1) % 2]
        full_rows = xp.concat([xp.flip(quarter[..., 1:], axis=-1), right_half], axis=-1) if half_width else right_half
        bottom = full_rows[..., : half_height + 1 - (self.height + 1) % 2, :]
        return xp.concat([xp.flip(full_rows[..., 1:, :], axis=-2), bottom], axis=-2) if half_height else bottom


class Distances(NamedTuple):
    """Coefficients of ``C_d = rad_per_dioptre (vergence + 1 / distance)``, with the distance in metres."""

    vergence: float  # 1/m
    rad_per_dioptre: float  # rad m


class Static(NamedTuple):
    """Settings of a traced plan without arrays: hashable, as JAX requires of static data.

    Attributes
    ----------
    namespace : Namespace
        Array namespace of the plan.
    terms : tuple
        Names of the columns of coefficients.
    columns : tuple of int
        Indices of the columns of coefficients on which the field depends.
    ranges : tuple of (float, float)
        Smallest and largest coefficient of each column in the stack of pupils.
    lights : tuple of (float, Radial or Chordal)
        Weight and field of each wavelength.
    pixels : Pixels
    scale : float or None
        Factor that multiplies intensities; None for division by the largest value of each image.
    tol : float
        Largest allowed error, relative to the largest value of an image.
    precision, dtype : str
        Data types of the computation and of the images.
    distances : Distances or None
        Conversion of object distances to C_d; None unless the pupils are those of a paraxial lens.
    """

    namespace: Namespace
    terms: tuple[Name, ...]
    columns: tuple[int, ...]
    ranges: tuple[tuple[float, float], ...]
    lights: tuple[tuple[float, Radial | Chordal], ...]
    pixels: Pixels
    scale: float | None
    tol: float
    precision: str
    dtype: str
    distances: Distances | None


class TracedPSF:
    """PSFs as a differentiable function of wavefront coefficients: ``images = f(c)``.

    The result of :meth:`lommel.Plan.traced`. It works with ``jit``, ``vmap`` and ``grad`` (of any order), can be an
    argument of transformed functions (a pytree in JAX), and can be pickled. If the tolerance is not proven, concrete
    coefficients raise an error; during tracing, the image is NaN, and other images and gradients are not affected.

    Parameters
    ----------
    static : Static
        Settings.
    tables : tuple of dict of array
        Precomputed arrays of each wavelength, by name.

    Attributes
    ----------
    terms : tuple
        Names of the columns of coefficients (radians at the pupil edge): "defocus" (C_d), "spherical" (C_s), "rho^6",
        ... if the wavefront was defined by these powers, else Zernike terms (n, m).
    shape : (int, int)
        Height and width of images.
    tol : float
        Largest allowed error, relative to the largest value of an image.
    precision : str
        Precision of the computation, "float64" or "float32".
    dtype : str
        Data type of images.
    tables : tuple of dict of array
    """

    def __init__(self, static: Static, tables: tuple[Tables, ...]) -> None:
        self._static, self.tables = static, tables

    terms = property(lambda self: self._static.terms)
    shape = property(lambda self: self._static.pixels[:2])
    tol = property(lambda self: self._static.tol)
    precision = property(lambda self: self._static.precision)
    dtype = property(lambda self: self._static.dtype)

    def __call__(self, c: Operand, *, check: bool = True) -> Operand:
        """Return images for coefficients `c`.

        Parameters
        ----------
        c : array, shape (..., k)
            Coefficients in radians, one column for each entry of ``terms``; on the device of the tables.
        check : bool, default True
            Raise ToleranceError if an error bound exceeds the tolerance, which requires waiting for the device. If
            False, images whose bound exceeds the tolerance are NaN.

        Returns
        -------
        array, shape (..., height, width)

        Raises
        ------
        TypeError, ValueError
            If coefficients have another framework, device or number of columns.
        ToleranceError
            If the error of an image is not proven to be at most `tol` times its largest value; not raised in a trace.
        """
        return self.certified(c, check=check)[0]

    def certified(self, c: Operand, *, check: bool = True) -> tuple[Operand, Operand]:
        """Return images, and for each image a proven bound on the largest error, relative to the largest value.

        Parameters
        ----------
        c, check
            See :meth:`__call__`.

        Returns
        -------
        images : array, shape (..., height, width)
            NaN where the bound exceeds `tol`.
        bound : array, shape (...)
            Error bound of each image, inf if no bound is known. The gradient of the bound is zero.

        Raises
        ------
        TypeError, ValueError, ToleranceError
            See :meth:`__call__`.
        """
        images, bound = self._evaluate(c)
        if check:
            self._require_tolerance(c, bound)
        return images, bound

    def error(self, c: Operand) -> Operand:
        """Return the error bounds for coefficients `c`, shape (...), without comparing them with the tolerance."""
        return self._evaluate(c)[1]

    def defocus(self, distance: Operand) -> Operand:
        """Return C_d in radians of objects at a `distance`, differentiable; see :meth:`lommel.Lens.defocus`.

        Parameters
        ----------
        distance : array
            Distance from the lens in metres; may be infinite.

        Returns
        -------
        array
            C_d in the shape of `distance`: value of the column "defocus", or summand of the Zernike term (2, 0).

        Raises
        ------
        ValueError
            If the plan was not traced with pupils of a paraxial lens.
        """
        conversion = self._static.distances
        if conversion is None:
            raise ValueError("defocus needs a plan traced with pupils of a paraxial lens, from Lens.pupil(...)")
        return conversion.rad_per_dioptre * (conversion.vergence + 1.0 / self._array(distance))

    def _array(self, values: Operand) -> Tensor:
        """Return values as a floating-point array of the framework; arrays of the framework stay on their device."""
        ns, table = self._static.namespace, cast("Operand", self.tables[0]["size"])
        xp = ns.xp
        if not hasattr(values, "dtype") or (isinstance(values, _NUMPY_TYPES) and ns.name != "numpy"):
            device = getattr(table, "device", None)
            kind = None if ns.has_double(device) else table.dtype
            values = ns.put(np.asarray(values, dtype=np.float64), device, kind)
        if ns.name not in ("jax", "numpy") and not isinstance(values, type(table)):
            raise TypeError(f"coefficients must be arrays of {ns.name}, like the traced plan, got {type(values)}")
        if ns.name not in ("jax", "numpy") and values.device != table.device:
            raise ValueError(f"coefficients must be on the device of the tables, {table.device}, got {values.device}")
        return values if xp.isdtype(values.dtype, "real floating") else xp.astype(values, table.dtype)

    def _evaluate(self, c: Operand) -> tuple[Tensor, Tensor]:
        """Return images and bounds; compiled in JAX, because separate operations would take seconds."""
        if self._static.namespace.name == "jax":
            return _jitted_evaluation()(self, self._array(c))
        return self._evaluate_uncompiled(c)

    def _evaluate_uncompiled(self, c: Operand) -> tuple[Tensor, Tensor]:
        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        kind = str(self.tables[0]["size"].dtype).rpartition(".")[2]
        if kind != static.precision or (kind == "float64" and not ns.has_double(None)):
            raise TypeError(
                f"a traced plan must be used in its precision, {static.precision}; trace a new plan instead of "
                "converting the tables, or changing the precision of the framework"
            )
        c = self._array(c)
        if len(c.shape) == 0 or c.shape[-1] != len(static.terms):
            raise ValueError(
                f"coefficients must have one column for each of {static.terms}, got the shape {tuple(c.shape)}"
            )
        stack = tuple(c.shape[:-1])
        rows = xp.reshape(c, (math.prod(stack), len(static.terms)))
        if len(static.columns) < len(static.terms):
            rows = xp.stack([rows[..., j] for j in static.columns], axis=-1)
        values, bound = self.evaluated(rows)
        zero = xp.zeros_like(bound)
        # NaN is added, not selected by `where`, such that gradients of other images remain finite.
        zero_or_nan = xp.reshape(xp.where(bound <= static.tol, zero, xp.full_like(bound, float("nan"))), (-1, 1))
        if ns.in_place(values):
            values += zero_or_nan
        else:
            values = values + zero_or_nan
        values = xp.astype(values, getattr(xp, static.dtype), copy=False)
        images = static.pixels.unfold(ns, self.tables[0], values)
        return xp.reshape(images, stack + static.pixels[:2]), xp.reshape(bound, stack)

    def evaluated(self, c: Operand) -> tuple[Tensor, Tensor]:
        """Return pixel values and error bounds for validated coefficients `c`, with the static `columns` only."""
        static = self._static
        ns = static.namespace
        unit, parts = UNIT[static.precision], []
        for (weight, field), tables in zip(static.lights, self.tables, strict=True):
            intensity, field_error = field.intensity(ns, tables, c)
            # Wavelengths are incoherent: intensities are added, and so are their error bounds.
            intensity_error = weight * certificate.of_intensity(ns, ns.stop(intensity), field_error, unit)
            parts.append((intensity if weight == 1.0 else weight * intensity, intensity_error))
        values, error = parts[0]
        for intensity, intensity_error in parts[1:]:
            values, error = values + intensity, error + intensity_error
        values, error = static.pixels.means(ns, self.tables[0], values, error, unit)
        fixed_values = ns.stop(values)
        # Relative rounding error of squares, sums and scaling, and of the conversion of float64 to float32.
        rounding = 8.0 * unit + (2.0**-24 if static.dtype == "float32" and unit < 1e-10 else 0.0)
        bound = certificate.over_peak(ns, fixed_values, ns.stop(error), rounding, divided=static.scale is None)
        if static.scale is None:
            return values / ns.xp.max(values, axis=-1, keepdims=True), bound
        if ns.in_place(values):
            values *= static.scale
            return values, bound
        return values * static.scale, bound

    def _require_tolerance(self, c: Operand, bound: Tensor) -> None:
        """Raise ToleranceError if a concrete bound exceeds the tolerance; traced bounds are not checked."""
        static = self._static
        if not static.namespace.concrete(bound):
            return
        bounds = static.namespace.to_numpy(bound)
        if not np.any(unproven := ~(bounds <= static.tol)):
            return
        index = tuple(int(k) for k in np.argwhere(unproven)[0])
        row = np.asarray(static.namespace.to_numpy(self._array(c)))[index]
        parts = zip(static.terms, row.tolist(), static.ranges, strict=True)
        listed = ", ".join(f"{term} = {value:.5g} (traced for {a:.5g} to {b:.5g})" for term, value, (a, b) in parts)
        raise ToleranceError(
            f"tol={static.tol:g} is not proven for the coefficients at {index}, {listed}: the error is bounded by "
            f"{bounds[index]:.3g} of the largest value; trace the plan for a larger range, or choose a larger tol"
        )

    def __repr__(self) -> str:
        static = self._static
        return (
            f"<TracedPSF of {static.pixels.height} x {static.pixels.width} pixels in {static.namespace.name}: "
            f"{', '.join(map(str, static.terms))}; {static.precision} inside, {static.dtype}, tol={static.tol:g}>"
        )

    def __reduce__(self) -> tuple[object, ...]:
        ns = self._static.namespace
        tables = tuple({name: ns.to_numpy(table) for name, table in arrays.items()} for arrays in self.tables)
        return move_to_device, (self._static, tables)


def move_to_device(static: Static, tables: tuple[Tables, ...], device: object = None) -> TracedPSF:
    """Return a traced plan with its tables moved from NumPy to a device, in the precision of the plan."""
    ns = static.namespace
    kind = getattr(ns.xp, static.precision)

    def moved(values: Operand) -> Tensor:
        return ns.put(values, device, kind if values.dtype.kind == "f" else None)

    if ns.name == "jax":
        _jitted_evaluation()
    return TracedPSF(static, tuple({name: moved(values) for name, values in arrays.items()} for arrays in tables))


@cache
def _jitted_evaluation() -> Callable[..., tuple[Tensor, Tensor]]:
    """Register TracedPSF as a pytree with JAX, and return the compiled evaluation."""
    import jax

    jax.tree_util.register_pytree_node(
        TracedPSF,
        lambda traced: ((traced.tables,), traced._static),
        lambda static, parts: TracedPSF(static, *parts),
    )
    return jax.jit(TracedPSF._evaluate_uncompiled)


def traced(
    pupil: Pupil,
    grid: Grid,
    method: Method | None,
    values: tuple[float, str, str],
    target: tuple[object, object, str],
) -> TracedPSF:
    """Return a traced plan; `values` are (tol, normalize, dtype), `target` is (framework, device, precision)."""
    tol, normalize, dtype = values
    ns, device = Namespace.of(target[0]), target[1]
    precision = _precision(ns, device, target[2], dtype)
    if not pupil.circular:
        raise ValueError("traced plans need a pupil with a round aperture, without spider, vignetting, mask or stop")
    if normalize == "emitted":
        raise ValueError('normalize must be "energy", "strehl" or "peak" for a traced plan, got "emitted"')
    components = _spectral_components(pupil, method)
    validation.pixel_on(grid.side, pupil.scale, metric=pupil.wavelength is not None)
    grid.require_reach(pupil)
    terms, c = chordal.columns(pupil)
    columns = tuple(j for j, t in enumerate(terms) if not pupil.radial or isinstance(t, str) or t[1] == 0)
    ranges = tuple(zip(c.min(axis=0).tolist(), c.max(axis=0).tolist(), strict=True))
    scale = {
        "energy": grid.step(pupil) ** 2 / (4.0 * math.pi * pupil.transmission),
        "strehl": 1.0 / (pupil.amplitude**2 * sum(part.weight for part in components)),
    }.get(normalize)
    # The peak of a defocused radial pupil is about proportional to 1 / phase: its allowed error is smaller.
    largest_phase = float(np.abs(c).sum(axis=1).max())
    error = tol * pupil.amplitude * (0.04 / (2.0 * largest_phase + 1.0) if pupil.radial else 0.35)
    distances, goal = _defocus_by_distance(pupil), (0.6 if pupil.radial else 0.8) * tol
    while True:
        parts, image, tables = _fields(pupil, grid, components, error, precision)
        static = Static(ns, terms, columns, ranges, parts, image, scale, tol, precision, dtype, distances)
        # Add nodes until all bounds, for members of the stack and other pupils of the valid range, are below `tol`.
        member_bound, largest_bound = _largest_bounds(static, tables, c)
        if largest_bound <= goal or error <= _MIN_ERROR:
            break
        reduction = _ERROR_REDUCTION if pupil.radial else max(_ERROR_REDUCTION, 0.9 * goal / largest_bound)
        error = max(_MIN_ERROR, reduction * error)
    if not member_bound <= tol:
        raise ToleranceError(
            f"tol={tol:g} cannot be proven in {precision} for the stack that the plan was traced with: the bound is "
            f"{member_bound:.2g} of the largest value{_X64 if ns.name == 'jax' and precision == 'float32' else ''}"
        )
    return move_to_device(static, tables, device)


def _precision(ns: Namespace, device: object, precision: str, dtype: str) -> str:
    """Return the precision of the computation, "float64" or "float32"; ValueError if unavailable on the device."""
    has_double = ns.has_double(device)
    if precision == "float64" and not has_double:
        raise ValueError(
            f'precision must be "float32" or "auto" on this device: {ns.name} has no float64'
            + (_X64 if ns.name == "jax" else "")
        )
    if precision == "auto":
        precision = "float64" if has_double else "float32"
    if precision == "float32" and dtype == "float64":
        raise ValueError(
            'dtype must be float32 where precision is "float32", got float64'
            + (_X64 if ns.name == "jax" else "; or choose a tolerance of 1e-6 or more")
        )
    return precision


def _defocus_by_distance(pupil: Pupil) -> Distances | None:
    """Return the conversion of object distances to C_d (Eq. 3 of the paper); None unless the lens is paraxial."""
    lens = pupil.geometry
    if lens is None or lens.model != "paraxial" or pupil.wavelength is None:
        return None
    # C_d is pi a^2 / (2 lambda) times the vergence error (1/m), where a is the aperture radius.
    return Distances(-lens.in_focus, math.pi / (2.0 * pupil.wavelength) * lens.aperture_radius**2)


def _spectral_components(pupil: Pupil, method: Method | None) -> list[Component]:
    if isinstance(method, Polychromatic):
        method.require(pupil)
        components, method = method.components(pupil), method.method
    else:
        components = [Component(1.0, 1.0, pupil)]
    if method is not None and not (method.keeps_tol and method.sampling == "center" and not method.any_aperture):
        raise ValueError(
            "method must be None, NijboerZernike, ChordalGauss or a Polychromatic of these for a traced plan, got "
            f"{type(method).__name__}"
        )
    return components


def _fields(
    pupil: Pupil, grid: Grid, components: list[Component], error: float, precision: str
) -> tuple[tuple[tuple[float, Radial | Chordal], ...], Pixels, tuple[Tables, ...]]:
    """Return the weight and field of each wavelength, the pixels, and the tables of each wavelength."""
    step, stretch = grid.step(pupil), max(part.stretch for part in components)
    fields: list[tuple[float, Radial | Chordal]] = []
    tables: list[Tables] = []
    # Images of radial pupils are sampled at distinct radii, which are fewer than the points of a lattice.
    if pupil.radial:
        image, v, common_tables = at_radii(grid, step, stretch, error * pupil.amplitude)
        for part in components:
            field, table = chordal.make_radial(pupil, part.stretch, part.stretch * v, error, precision)
            fields.append((part.weight, field))
            tables.append({**table})
    else:
        image, lattice, common_tables = on_lattice(grid, step, stretch, error * pupil.amplitude)
        for part in components:
            window = (part.stretch * lattice[0], part.stretch * lattice[1])
            chords, arrays = chordal.make_chordal(pupil, grid, part.stretch, window, error, precision)
            fields.append((part.weight, chords))
            tables.append(arrays)
    tables[0].update(common_tables)
    return tuple(fields), image, tuple(tables)


def _largest_bounds(static: Static, tables: tuple[Tables, ...], c: Array) -> tuple[float, float]:
    """Return the largest bound for tested members of the stack, and for these and others of the valid range."""
    numpy = Namespace.of(None)
    plan = TracedPSF(static._replace(namespace=numpy), tables)
    boxed = isinstance(static.lights[0][1], Radial)
    points = max(table.shape[-1] for table in tables[0].values())
    rows = max(1, _BLOCK_VALUES // points)

    def largest(coefficients: Array) -> float:
        parts = (coefficients[k : k + rows, static.columns] for k in range(0, len(coefficients), rows))
        return float(np.max([np.max(numpy.to_numpy(plan.evaluated(part)[1])) for part in parts]))

    # Test the pupils with the largest phases, which have the largest bounds, and regularly spaced others.
    order = np.argsort(-np.abs(c).sum(axis=1), kind="stable")
    indices = np.concatenate([order[:_TESTED_MEMBERS], order[_TESTED_MEMBERS :: max(1, len(c) // _TESTED_MEMBERS)]])
    member_bound = largest(c[indices])
    return member_bound, max(member_bound, largest(_pupils_between(c, boxed=boxed)))


def _pupils_between(c: Array, *, boxed: bool) -> Array:
    """Return random coefficients of the valid range: between members, also of other signs, or between extremes.

    If `boxed`, each coefficient is between its extremes in the stack. Otherwise signs of members change, and with
    them the largest value of an image.
    """
    # The seed is fixed, such that plans are reproducible.
    draw = np.random.default_rng(0)
    if not boxed:
        first, second = c[draw.integers(len(c), size=(2, _TESTED_BETWEEN // 2))]
        weight = draw.random((len(first), 1))
        members = c[draw.integers(len(c), size=_TESTED_SIGNS)]
        signed = draw.choice([-1.0, 1.0], members.shape) * members
        return np.concatenate([weight * first + (1.0 - weight) * second, signed])
    low, high = c.min(axis=0), c.max(axis=0)
    fractions = draw.random((_TESTED_BETWEEN, c.shape[1]))
    # Half of the pupils are at corners of the box, where bounds are largest.
    fractions[: _TESTED_BETWEEN // 2] = np.round(fractions[: _TESTED_BETWEEN // 2])
    return np.asarray(low + fractions * (high - low))


def at_radii(grid: Grid, step: float, stretch: float, allowed: float) -> tuple[Pixels, Array, dict[str, Values]]:
    """Return (1) the Pixels for a radial pupil, (2) the radii in v of the samples, and (3) tables.

    `step` is the pixel pitch in v, ``stretch * step`` at the shortest wavelength; `allowed` is the error of averages.
    """
    height, width = grid.shape
    if grid.integrate and not grid.centered:
        pixels, (rows, cols), tables = on_lattice(grid, step, stretch, allowed)
        radii, index = np.unique(np.hypot(cols[:, None], rows), return_inverse=True)
        return pixels, radii, tables | {"index": _flat_indices(index)}
    if grid.integrate:
        half_side = max(1, height // 2, width // 2)
        rule = pixel_rule(half_side, step * stretch)
        # A window that is not square requires only some cells of the octant.
        cells, index = np.unique(
            cells_of_quarter(half_side)[: height // 2 + 1, : width // 2 + 1].ravel(), return_inverse=True
        )
        matrix = np.ascontiguousarray(rule.matrix[:, cells])
        pixels = Pixels(height, width, True, float(np.abs(matrix).sum(axis=0).max()), _RULE_ERROR)
        return pixels, step * rule.radii, {"matrix": matrix, "index": _flat_indices(index)}
    middle = grid.axis
    row_offsets, column_offsets = np.arange(height) - middle[0], np.arange(width) - middle[1]
    if grid.centered:
        # A centred window is symmetric: one quadrant contains all distinct radii.
        row_offsets, column_offsets = row_offsets[height // 2 :: -1], column_offsets[width // 2 :: -1]
    # For a centred window the squares are exact in floating point: equal radii have equal squares.
    squares, index = np.unique(row_offsets[:, None] ** 2 + column_offsets**2, return_inverse=True)
    return Pixels(height, width, grid.centered, 0.0, 0.0), step * np.sqrt(squares), {"index": _flat_indices(index)}


def _flat_indices(index: Values) -> NDArray[np.int32]:
    return index.ravel().astype(np.int32)


def on_lattice(
    grid: Grid, step: float, stretch: float, allowed: float
) -> tuple[Pixels, tuple[Array, Array], dict[str, Values]]:
    """Return (1) the Pixels for any pupil, (2) rows and columns of samples in v, and (3) tables; see `at_radii`."""
    grid.require_one_axis()
    rows, cols = step / grid.side * grid.y, step / grid.side * grid.x
    if not grid.integrate:
        return Pixels(grid.height, grid.width, False, 0.0, 0.0, 1), (rows, cols), {}
    for count in range(2, _MAX_SAMPLES + 1):
        if (error := averaging_error(stretch * step, count)) <= allowed:
            break
    else:
        raise ValueError(
            f"pixel is too large to be averaged by {_MAX_SAMPLES} x {_MAX_SAMPLES} samples, got "
            f"{stretch * step / math.pi:.4g} lambda*N at the shortest wavelength; use smaller pixels"
        )
    nodes, weights = gauss_legendre(count, -0.5 * step, 0.5 * step)
    products = (weights[:, None, None, None] * weights[:, None]) / step**2
    lattice = (rows[:, None] + nodes).ravel(), (cols[:, None] + nodes).ravel()
    return Pixels(grid.height, grid.width, False, 1.0, error, count), lattice, {"weights": products}
