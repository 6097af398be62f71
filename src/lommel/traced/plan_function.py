"""A PSF as a function of coefficients within a framework: :class:`Twin`, which :meth:`lommel.Plan.traced` makes."""

from __future__ import annotations

import math
from functools import cache
from typing import Any, NamedTuple, Self

import numpy as np

from lommel.core.answers import ToleranceError
from lommel.traced import certificate
from lommel.traced.chordal import Chordal
from lommel.traced.images import Pixels
from lommel.traced.namespaces import Namespace
from lommel.traced.radial import Radial

_OF_NUMPY = (np.ndarray, np.generic)


class Distances(NamedTuple):
    """What C_d is made of: ``waves (vergence + 1 / distance)``; metres."""

    vergence: float
    waves: float


class Static(NamedTuple):
    """All of a twin that is no array: it can be hashed, and so be part of what a compiled program depends on.

    Attributes
    ----------
    namespace : Namespace
    terms : tuple
        Names of the columns of coefficients.
    kept : tuple of int
        Which of them the field depends on.
    reach : tuple of (float, float)
        Least and largest coefficient of the stack that the twin was made for.
    lights : tuple of (float, Radial or Chordal)
        For each wavelength its weight and its field.
    pixels : Pixels
    scale : float or None
        What intensities are multiplied by; None divides by the largest value.
    tol : float
    precision, dtype : str
    distances : Distances or None
    """

    namespace: Namespace
    terms: tuple[Any, ...]
    kept: tuple[int, ...]
    reach: tuple[tuple[float, float], ...]
    lights: tuple[tuple[float, Radial | Chordal], ...]
    pixels: Pixels
    scale: float | None
    tol: float
    precision: str
    dtype: str
    distances: Distances | None


class Twin:
    """PSFs as a pure function of coefficients: ``images = f(c)``.

    Made by :meth:`lommel.Plan.traced`. It can be transformed by ``jit``, ``vmap`` and ``grad`` (of any order), can be
    an argument of what is, for in JAX it is a pytree, and can be pickled. Called with concrete coefficients it checks
    them; being traced it cannot, and makes images NaN where no tolerance is proven, which leaves all others and their
    gradients as they are.

    Parameters
    ----------
    static : Static
        All that is no array.
    tables : tuple of dict of array
        Of each wavelength, by name.

    Attributes
    ----------
    terms : tuple
        What the columns of coefficients are, in radians: "defocus" (C_d), "spherical" (C_s), "rho^6", ... where the
        wavefront was given so, else Zernike terms (n, m) at the edge.
    shape : (int, int)
        Of images.
    tol : float
        What bounds are held against.
    precision : str
        "float64" or "float32": of what is inside.
    dtype : str
        Of images.
    """

    def __init__(self, static: Static, tables: tuple[dict[str, Any], ...]) -> None:
        self._static, self._tables = static, tables

    terms = property(lambda self: self._static.terms)
    shape = property(lambda self: self._static.pixels[:2])
    tol = property(lambda self: self._static.tol)
    precision = property(lambda self: self._static.precision)
    dtype = property(lambda self: self._static.dtype)

    def __call__(self, c: Any, *, check: bool = True) -> Any:
        """Return images.

        Parameters
        ----------
        c : array, shape (..., k)
            Radians, a column for each of ``terms``; on the device of the twin.
        check : bool, default True
            False: do not look at the bounds, which waits for a device; where they exceed the tolerance, images are
            NaN.

        Returns
        -------
        array, shape (..., height, width)

        Raises
        ------
        TypeError, ValueError
            If coefficients are of another framework, device or number.
        ToleranceError
            If the error of an image is not proven to be at most `tol` of its largest value; not while tracing.
        """
        images, bound = self._answer(c)
        if check:
            self._require(c, bound)
        return images

    def certified(self, c: Any, *, check: bool = True) -> tuple[Any, Any]:
        """Return images, and for each the proven bound on its largest error over its largest value.

        Parameters
        ----------
        c, check
            As above.

        Returns
        -------
        images : array, shape (..., height, width)
            NaN where the bound is not at most `tol`.
        bound : array, shape (...)
            Infinite where there is none. No gradient passes through it.

        Raises
        ------
        TypeError, ValueError, ToleranceError
            As above.
        """
        images, bound = self._answer(c)
        if check:
            self._require(c, bound)
        return images, bound

    def error(self, c: Any) -> Any:
        """Return the bounds alone, shape (...), and raise nothing where they are large; of coefficients `c`."""
        return self._answer(c)[1]

    def defocus(self, distance: Any) -> Any:
        """Return C_d in radians of objects, as :meth:`lommel.Lens.defocus`; differentiable.

        Parameters
        ----------
        distance : array
            Metres from the lens, may be infinite.

        Returns
        -------
        array
            Of the same shape. It is the column "defocus", or what to add to the term (2, 0).

        Raises
        ------
        ValueError
            If the pupils are not those of a paraxial lens.
        """
        there = self._static.distances
        if there is None:
            raise ValueError("distances need a plan traced with pupils of a paraxial lens, from Lens.pupil(...)")
        return there.waves * (there.vergence + 1.0 / self._array(distance))

    def _array(self, values: Any) -> Any:
        """Return values as a floating array of the framework, on the device that they are on."""
        ns, like = self._static.namespace, self._tables[0]["size"]
        xp = ns.xp
        if not hasattr(values, "dtype") or (isinstance(values, _OF_NUMPY) and ns.name != "numpy"):
            device = getattr(like, "device", None)
            kind = None if ns.has_double(device) else like.dtype
            values = ns.put(np.asarray(values, dtype=np.float64), device, kind)
        if ns.name not in ("jax", "numpy") and not isinstance(values, type(like)):
            raise TypeError(f"coefficients must be of {ns.name}, as the plan was traced with, got {type(values)}")
        if ns.name not in ("jax", "numpy") and values.device != like.device:
            raise ValueError(f"coefficients must be on the device of the twin, {like.device}, got {values.device}")
        return values if xp.isdtype(values.dtype, "real floating") else xp.astype(values, like.dtype)

    def _answer(self, c: Any) -> tuple[Any, Any]:
        """Return images and bounds; in JAX compiled, even where nobody asked for it: step by step takes seconds."""
        if self._static.namespace.name == "jax":
            return _compiled()(self, self._array(c))  # type: ignore[no-any-return]
        return self._made(c)

    def _made(self, c: Any) -> tuple[Any, Any]:
        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        kind = str(self._tables[0]["size"].dtype).rpartition(".")[2]
        if kind != static.precision or (kind == "float64" and not ns.has_double(None)):
            raise TypeError(
                f"the twin must be used in {static.precision}, as it was made; trace the plan anew instead of "
                "turning its tables or the framework to another precision"
            )
        c = self._array(c)
        if len(c.shape) == 0 or c.shape[-1] != len(static.terms):
            raise ValueError(
                f"coefficients must have a column for each of {static.terms}, got the shape {tuple(c.shape)}"
            )
        stack = tuple(c.shape[:-1])
        flat = xp.reshape(c, (math.prod(stack), len(static.terms)))
        if len(static.kept) < len(static.terms):
            flat = xp.stack([flat[..., j] for j in static.kept], axis=-1)
        values, bound = self.evaluated(flat)
        zero = xp.zeros_like(bound)
        # What is added has no part in gradients.
        poison = xp.where(bound <= static.tol, zero, xp.full_like(bound, float("nan")))
        values = xp.astype(ns.plus(values, xp.reshape(poison, (-1, 1))), getattr(xp, static.dtype), copy=False)
        images = static.pixels.unfold(ns, self._tables[0], values)
        return xp.reshape(images, stack + static.pixels[:2]), xp.reshape(bound, stack)

    def evaluated(self, c: Any) -> tuple[Any, Any]:
        """Return what there is of each pixel, and the bounds, of checked coefficients `c` of the terms kept."""
        static = self._static
        ns = static.namespace
        values, error, unit = self._intensities(c)
        still = ns.stop(values)
        stored = 8.0 * unit + (2.0**-24 if static.dtype == "float32" and unit < 1e-10 else 0.0)
        bound = certificate.over_peak(ns, still, ns.stop(error), stored, divided=static.scale is None)
        if static.scale is None:
            return values / ns.xp.max(values, axis=-1, keepdims=True), bound
        return ns.times(values, static.scale), bound

    def _intensities(self, c: Any) -> tuple[Any, Any, float]:
        """Return what there is of each pixel, a bound on the error of it, and the unit roundoff."""
        static = self._static
        ns, values, error, unit = static.namespace, None, None, 0.0
        for (weight, light), tables in zip(static.lights, self._tables, strict=True):
            intensity, of_field = light.intensity(ns, tables, c)
            unit = light.error.unit
            slack = weight * certificate.of_intensity(ns, ns.stop(intensity), of_field, unit)
            part = intensity if weight == 1.0 else weight * intensity
            values, error = (part, slack) if values is None else (values + part, error + slack)
        values, error = static.pixels.means(ns, self._tables[0], values, error, unit)
        return values, error, unit

    def _require(self, c: Any, bound: Any) -> None:
        """Raise ToleranceError where a bound exceeds the tolerance, if it can be known now."""
        static = self._static
        if not static.namespace.concrete(bound):
            return
        found = static.namespace.to_numpy(bound)
        if not np.any(bad := ~(found <= static.tol)):
            return
        index = tuple(int(k) for k in np.argwhere(bad)[0])
        here = np.asarray(static.namespace.to_numpy(self._array(c)))[index]
        parts = zip(static.terms, here.tolist(), static.reach, strict=True)
        listed = ", ".join(f"{term} = {value:.5g} (traced for {a:.5g} to {b:.5g})" for term, value, (a, b) in parts)
        raise ToleranceError(
            f"tol={static.tol:g} is not proven for the coefficients at {index}, {listed}: the error is bounded by "
            f"{found[index]:.3g} of the largest value; trace the plan with pupils of a larger reach, or ask for less"
        )

    def with_tables(self, tables: tuple[dict[str, Any], ...]) -> Self:
        """Return the same twin with its `tables` replaced, as those that were moved to another device."""
        return type(self)(self._static, tables)

    @property
    def tables(self) -> tuple[dict[str, Any], ...]:
        """The arrays, of each wavelength by name."""
        return self._tables

    def __repr__(self) -> str:
        static = self._static
        return (
            f"<Twin of {static.pixels.height} x {static.pixels.width} pixels in {static.namespace.name}: "
            f"{', '.join(map(str, static.terms))}; {static.precision} inside, {static.dtype}, tol={static.tol:g}>"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        ns = self._static.namespace
        return unpickled, (self._static, tuple({k: ns.to_numpy(v) for k, v in one.items()} for one in self._tables))


def unpickled(static: Static, tables: tuple[dict[str, Any], ...]) -> Twin:
    """Return a twin from its static part and tables of NumPy, on the default device of its framework."""
    return placed(static, tables, None)


def placed(static: Static, tables: tuple[dict[str, Any], ...], device: Any) -> Twin:
    """Return a twin whose tables are put on a device, in its precision."""
    ns = static.namespace
    kind = getattr(ns.xp, static.precision)

    def put(values: Any) -> Any:
        return ns.put(values, device, kind if values.dtype.kind == "f" else None)

    made = Twin(static, tuple({name: put(values) for name, values in one.items()} for one in tables))
    if ns.name == "jax":
        _register()
    return made


@cache
def _compiled() -> Any:
    import jax

    return jax.jit(Twin._made)


def _register() -> None:
    """Tell JAX, once, that a twin is a tree of its tables."""
    import jax

    if getattr(Twin, "_is_tree", False):
        return
    Twin._is_tree = True  # type: ignore[attr-defined]

    def leaves(twin: Twin) -> tuple[tuple[Any, ...], Any]:
        return (twin._tables,), twin._static

    def twin_of(static: Static, parts: tuple[Any, ...]) -> Twin:
        return Twin(static, *parts)

    jax.tree_util.register_pytree_node(Twin, leaves, twin_of)
