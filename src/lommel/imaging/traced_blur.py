"""Depth-dependent blur as a differentiable function of images, depth and the lens, in JAX, PyTorch and NumPy."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.optional import library
from lommel.imaging import traced_windows
from lommel.imaging.blur import require_lens
from lommel.imaging.sensor_light import SensorLight
from lommel.imaging.settings import BORDERS, Spectrum, spectra
from lommel.imaging.traced_windows import (
    AberratedWindows,
    DefocusLayer,
    Term,
    chebyshev,
    chebyshev_nodes,
    defocus_layers,
)
from lommel.methods.pixel_rule import cells_alike, cells_of_quarter
from lommel.optics.colour.spectrum import Channels
from lommel.optics.lens import Lens, require_round
from lommel.traced.namespaces import ArrayFunctions, Namespace, Operand, Tables, Tensor

_SCALES = (4, 6, 8, 12, 16, 24, 32)  # tried numbers of sizes of windows
_SCREENS = 16  # largest number of layers of occlusion
_TRACE = 1e-6  # coverage added to denominators, so that they are never 0
# Relative; rounding of C_d in float32 must not put the ends of the stated range outside it.
_SLACK = 1e-5
_WIDTH = 36.0  # width of layers, radians of C_d
_BLOCK = 2**14  # points whose polynomials are computed together
_TOGETHER = 2**25  # values of windows computed together
_CACHED = 2**19  # values convolved together where each operation is a pass over memory
_OF_NUMPY = (np.ndarray, np.generic)
_OPTICS = ("focus_distance", "f_number", "defocus", "zernike")


class Optics(NamedTuple):
    """Numbers of a paraxial lens, metres and radians: as stated, and the ranges that can be learned."""

    focal_length: float
    sensor_distance: float
    f_number: float
    waves: float  # C_d = waves (vergence + 1 / distance)
    focus: tuple[float, float] | None
    stops: tuple[float, float] | None
    defocus: float
    zernike: tuple[tuple[Term, float], ...]

    def at(self, focus_distance: Operand, f_number: Operand) -> tuple[Operand, Operand, Operand]:
        """Return the vergence, the waves, and the size of PSFs over that of the stated lens (None: the same)."""
        inverse = 1.0 / self.sensor_distance
        vergence: Operand = inverse - 1.0 / self.focal_length
        scale: Operand = None
        if focus_distance is not None:
            # Focused at a distance, the lens has the vergence -1 / distance: C_d is 0 there.
            vergence = -1.0 / focus_distance
            # Sensor distance over that of the stated lens: PSFs grow with lambda times the working f-number.
            scale = inverse / (1.0 / self.focal_length + vergence)
        if f_number is None:
            return vergence, self.waves, scale
        ratio = f_number / self.f_number
        # Defocus goes with the square of the aperture's radius at a given distance.
        return vergence, self.waves / ratio**2, ratio if scale is None else ratio * scale


class Blur(NamedTuple):
    """The part of a blur that holds no arrays.

    Attributes
    ----------
    namespace : Namespace
    optics : Optics
    border : str
    channels : int
    half : int
        Half width of windows, pixels.
    edges : tuple of float
        C_d at which layers begin, and the last ends.
    ranks, degrees : tuple of int
        Windows of each layer, and the Chebyshev polynomials that their weights are made of.
    scales : tuple of float
        Least and largest logarithm of the size of PSFs over that of the lens as given.
    screens : tuple of float
        C_d of the layers of occlusion, from the front.
    aberrated : AberratedWindows or None
    error : float
    precision : str
    """

    namespace: Namespace
    optics: Optics
    border: str
    channels: int
    half: int
    edges: tuple[float, ...]
    ranks: tuple[int, ...]
    degrees: tuple[int, ...]
    scales: tuple[float, float]
    screens: tuple[float, ...]
    aberrated: AberratedWindows | None
    error: float
    precision: str


class TracedBlur:
    """Depth-dependent blur as a differentiable function, linear in the image: ``out = blur(image, distance)``.

    ``out[q] = sum_p image[p] K(q - p; C_d(distance[p]))``. Made by :func:`lommel.imaging.traced_blur`. It works with
    ``jit``, ``vmap``, ``scan`` and ``grad``, can be an argument of such functions (a pytree in JAX), and can be
    pickled. The derivative with respect to the image is the adjoint.

    Parameters
    ----------
    static : Blur
        All but the arrays.
    tables : dict of array
        By name.

    Attributes
    ----------
    rank : int
        Number of convolutions of each channel.
    half : int
        Half width of the windows, pixels.
    error : float
        Largest error found of a window, each of sum 1, relative to its peak.
    """

    def __init__(self, static: Blur, tables: Tables) -> None:
        self._static, self.tables = static, tables

    rank = property(lambda self: sum(self._static.ranks))
    half = property(lambda self: self._static.half)
    error = property(lambda self: self._static.error)

    def defocus(self, distance: Operand, *, focus_distance: Operand = None, f_number: Operand = None) -> Operand:
        """Return C_d in radians of objects at a `distance` (metres), differentiable.

        Parameters
        ----------
        distance : array
            Metres from the lens, may be infinite.
        focus_distance, f_number : array, shape (), optional
            Of the lens, metres and a number; by default as given.

        Returns
        -------
        array
            Of the shape of `distance`.
        """
        for name, value in (("distance", distance), ("focus_distance", focus_distance), ("f_number", f_number)):
            if value is not None and not hasattr(value, "dtype"):
                _numbers(name, value)
        vergence, waves, _ = self._static.optics.at(focus_distance, f_number)
        return waves * (vergence + 1.0 / distance)

    def __call__(
        self,
        image: Operand,
        distance: Operand,
        *,
        focus_distance: Operand = None,
        f_number: Operand = None,
        defocus: Operand = None,
        zernike: Operand = None,
        occlusion: bool = False,
        check: bool = True,
    ) -> Any:
        """Return the blurred image.

        Parameters
        ----------
        image : array, shape (..., channels, height, width) or (..., height, width)
            Linear light. The axis of channels may be missing if there is one: `image` then has as many axes as
            `distance`.
        distance : float or array, shape (..., height, width)
            Metres from the lens; may be infinite. A single number, or an array of the shape (..., 1, 1), is the
            distance of all points of an image.
        focus_distance, f_number : array, shape () or (n,), optional
            Of the lens, within the ranges that the blur was made for; by default as given. The sensor moves with the
            focus, and the size of the diffraction pattern with both. Of the shape (n,), the first of a batch of
            images, each has its own lens.
        defocus : array, optional
            C_d that is added, radians; broadcasts with `distance`.
        zernike : array, shape (k,) or (n, k), or (rows, columns, k) or (n, rows, columns, k), optional
            Zernike coefficients that are added to the wavefront, radians at the edge of the pupil and the wavelength
            of the lens, in the order of the terms that the blur was made with; with n as above. Of rows and columns,
            they are those of a lens over its field, at nodes that are spaced equally from the first pixel to the last
            one: PSFs are interpolated linearly between the nodes, each of which takes the time of a blur.
        occlusion : bool, default False
            Whether near objects occlude far ones, in at most 16 layers: the difference between layers that are
            composited, as by :class:`lommel.imaging.Occlusion` but for hidden points, and layers that are added, is
            added to the blur. All parts are differentiable almost everywhere. About five times the time.
        check : bool, default True
            Whether to check values, which waits for a device; not while tracing.

        Returns
        -------
        array
            Of the shape of `image`. NaN where a value is out of range and was not checked.

        Raises
        ------
        TypeError, ValueError
            If an array is of another type or shape than above, if it holds NaN, or is out of range.
        """
        static = self._static
        xp = static.namespace.xp
        image, distance = self._array("image", image), self._array("distance", distance)
        shape = tuple(image.shape)
        if not distance.shape:
            distance = xp.reshape(distance, (1,) * max(2, len(shape) - 1))
        if len(shape) == len(distance.shape):
            image = xp.expand_dims(image, axis=-3) if len(shape) >= 2 else image
        if tuple(distance.shape[-2:]) == (1, 1) and len(shape) >= 2:
            distance = xp.broadcast_to(distance, (*distance.shape[:-2], *shape[-2:]))
        self._require_shapes(shape, tuple(image.shape), tuple(distance.shape))
        given = dict(zip(_OPTICS, (focus_distance, f_number, defocus, zernike), strict=True))
        lens = {name: None if value is None else self._array(name, value) for name, value in given.items()}
        self._require_optics(lens, tuple(image.shape))
        if occlusion and lens["zernike"] is not None and len(lens["zernike"].shape) > 2:
            raise ValueError(
                "occlusion needs the same aberrations all over the field: zernike of the shape (k,) or (n, k)"
            )
        if check:
            self._require_values(image, distance, lens)
        if static.namespace.name == "jax":  # operation by operation takes seconds
            return xp.reshape(_of_jax()(self, image, distance, lens, bool(occlusion)), shape)
        return xp.reshape(self._by_lens(image, distance, lens, occlusion=occlusion), shape)

    def _by_lens(self, image: Operand, distance: Operand, lens: Mapping[str, Operand], *, occlusion: bool) -> Tensor:
        """Return the blurred images, each of a batch with its own lens where there are several."""
        along = {"image", "distance", *_several(lens)}
        if len(along) == 2:
            return self._over_field(image, distance, lens, occlusion=occlusion)
        given: dict[str, Operand] = {"image": image, "distance": distance, **lens}
        if lens["defocus"] is not None and len(lens["defocus"].shape) == len(distance.shape):
            along.add("defocus")
        # Operands with one element along the batch are shared, not mapped.
        axes = {name: 0 if name in along and given[name].shape[0] > 1 else None for name in given}
        # What there is one of is that of all.
        given |= {name: given[name][0, ...] for name in along if axes[name] is None}

        def one(of: Mapping[str, Operand]) -> Tensor:
            optics = {name: of[name] for name in _OPTICS}
            return self._over_field(of["image"], of["distance"], optics, occlusion=occlusion)

        xp, count = self._static.namespace.xp, image.shape[0]
        if self._static.namespace.name == "jax" and count > 1:
            import jax

            mapped: Tensor = jax.vmap(one, in_axes=(axes,))(given)
            return mapped
        parts = [{n: value if axes[n] is None else value[k, ...] for n, value in given.items()} for k in range(count)]
        made: Tensor = xp.stack([one(part) for part in parts], axis=0)
        return made

    def _over_field(
        self, image: Operand, distance: Operand, lens: Mapping[str, Operand], *, occlusion: bool
    ) -> Tensor:
        """Return the blurred image; PSFs between nodes over the field are weighted sums of those of the nodes."""
        static = self._static
        xp, nodes = static.namespace.xp, lens["zernike"]
        if nodes is None or len(nodes.shape) < 3:
            return self._blurred(image, distance, lens, occlusion=occlusion)
        count, across = math.prod(nodes.shape[:2]), nodes.shape[1]
        down, along = (self._hats(image, axis, nodes.shape[axis]) for axis in (0, 1))
        nodes = xp.reshape(nodes, (count, nodes.shape[-1]))

        def one(row: Operand, column: Operand, coefficients: Operand) -> Tensor:
            share = xp.expand_dims(row, axis=-1) * column
            # Linear weights commute with the blur: each node's PSF blurs the image times the node's weight.
            return self._blurred(image * share, distance, dict(lens) | {"zernike": coefficients}, occlusion=False)

        if static.namespace.name == "jax":
            import jax

            given = xp.repeat(down, across, axis=0), xp.tile(along, (count // across, 1)), nodes
            start = xp.zeros(image.shape, dtype=image.dtype)
            # A scan holds the images of one node at a time.
            total: Tensor = jax.lax.scan(lambda before, of: (before + one(*of), None), start, given)[0]
            return total
        made: Operand = 0.0
        for k in range(count):
            made = made + one(down[k // across, ...], along[k % across, ...], nodes[k, ...])
        whole: Tensor = made
        return whole

    def _hats(self, image: Operand, axis: int, count: int) -> Tensor:
        """Return the weights of nodes along an axis of the image, shape (count, points): linear between them."""
        xp, side = self._static.namespace.xp, image.shape[axis - 2]
        where = {} if self._static.namespace.name in ("jax", "numpy") else {"device": image.device}
        at = xp.astype(xp.arange(side, **where), image.dtype) * ((count - 1) / max(1, side - 1))
        node = xp.reshape(xp.astype(xp.arange(count, **where), image.dtype), (-1, 1))
        hats: Tensor = xp.clip(1.0 - xp.abs(at - node), 0.0, 1.0)
        return hats

    def _blurred(self, image: Operand, distance: Operand, lens: Mapping[str, Operand], *, occlusion: bool) -> Tensor:
        """Return the blurred image (..., channels, height, width) from checked arrays."""
        static = self._static
        xp, shape = static.namespace.xp, tuple(image.shape)
        c, scale = self._focus(distance, lens)
        # NaN is added, lest it have a part in gradients.
        low, high = static.edges[0], static.edges[-1]
        slack = _SLACK * (high - low)
        bad = (c < low - slack) | (c > high + slack) | xp.isnan(c)
        image = image + xp.expand_dims(xp.where(bad, float("nan"), xp.zeros_like(c)), axis=-3)
        rows, columns = (self._padding(c, axis) for axis in (-2, -1))
        c = xp.take(xp.take(c, rows[0], axis=-2), columns[0], axis=-1)
        image = xp.take(xp.take(image, rows[0], axis=-2), columns[0], axis=-1)
        if static.border == "zero":
            image = image * xp.expand_dims(rows[1], axis=-1) * columns[1]
        size = tuple(_fast(side) for side in c.shape[-2:])
        kernels = self._kernels(size, scale, lens["zernike"])
        made = self._cropped(self._mixed(image, c, size, kernels), shape, size)
        return made + self._occlusion(image, c, size, kernels, shape) if occlusion else made

    def _focus(self, distance: Operand, lens: Mapping[str, Operand]) -> tuple[Operand, Operand]:
        """Return C_d, and the size of PSFs over that of the stated lens (None: the same)."""
        vergence, waves, scale = self._static.optics.at(lens["focus_distance"], lens["f_number"])
        c = waves * (vergence + 1.0 / distance)
        return (c if lens["defocus"] is None else c + lens["defocus"]), scale

    def torch_module(self, **learned: Operand) -> Any:
        """Return a ``torch.nn.Module`` with the tables as buffers, whose ``forward`` takes what the blur takes.

        It can be pickled, moved between devices and compiled.

        Parameters
        ----------
        **learned : float or sequence, optional
            Initial values of `focus_distance`, `f_number`, `defocus` or `zernike`, which become parameters of that
            name; arguments of `forward` replace them.

        Raises
        ------
        TypeError
            If the blur was made for another framework, or cannot take such an argument.
        """
        if self._static.namespace.name != "torch":
            raise TypeError(f"a torch module needs a blur made for torch, got one for {self._static.namespace.name}")
        if unknown := set(learned) - set(_OPTICS):
            raise TypeError(f"learned parameters are {', '.join(_OPTICS)}, got {', '.join(sorted(unknown))}")
        return _module(self, {name: np.asarray(value, dtype=np.float64) for name, value in learned.items()})

    def _array(self, name: str, values: Operand) -> Operand:
        """Return values as an array of the framework, of the type of the tables."""
        static, like = self._static, self.tables["middles"]
        ns, xp = static.namespace, static.namespace.xp
        if ns.name == "numpy" or isinstance(values, _OF_NUMPY):
            validation.refuse_masked(name, values)
        if not hasattr(values, "dtype") or (isinstance(values, _OF_NUMPY) and ns.name != "numpy"):
            values = ns.put(_numbers(name, values), getattr(like, "device", None) if ns.name != "jax" else None)
            if name in _OPTICS or (name == "distance" and not values.shape):
                return xp.astype(values, like.dtype)
        if not hasattr(values, "shape") or not xp.isdtype(values.dtype, "real floating"):
            hint = "; scale it to linear light first" if name == "image" else ""
            raise TypeError(f"{name} must hold real floats, got {getattr(values, 'dtype', type(values))}{hint}")
        return xp.astype(values, like.dtype, copy=False)

    def _require_shapes(self, given: tuple[int, ...], image: tuple[int, ...], distance: tuple[int, ...]) -> None:
        """Raise ValueError unless shapes are those of images with channels, and of their depth."""
        channels = self._static.channels
        good = len(distance) >= 2 and len(image) == len(distance) + 1 and image[-2:] == distance[-2:]
        if good and image[-3] == channels and 0 not in image:
            lead = zip(image[:-3], distance[:-2], strict=True)
            if all(there in (1, here) for here, there in lead):
                return
        wanted = (
            "(..., height, width) or (..., 1, height, width)"
            if channels == 1
            else f"(..., {channels}, height, width)"
        )
        raise ValueError(
            f"image must have the shape {wanted} and distance (..., height, width) of the same sides, got {given} "
            f"and {distance}"
        )

    def _require_optics(self, lens: Mapping[str, Operand], image: tuple[int, ...]) -> None:
        """Raise ValueError for a part of the lens that the blur was not made for."""
        optics = self._static.optics
        ranges = {
            "focus_distance": ("focus_distances", optics.focus is not None),
            "f_number": ("f_numbers", optics.stops is not None),
            "defocus": ("defocus", optics.defocus > 0.0),
            "zernike": ("zernike", bool(optics.zernike)),
        }
        for name, (option, there) in ranges.items():
            if lens[name] is not None and not there:
                raise ValueError(f"{name} is fixed in this blur; give its range, {option}=, to traced_blur")
        count, batch = len(optics.zernike), image[:-3][:1]
        for name, shape in (("focus_distance", ()), ("f_number", ()), ("zernike", (count,))):
            found = shape if lens[name] is None else tuple(lens[name].shape)
            over_field = (*found[-3:-1], *shape) if name == "zernike" and len(found) > 2 and 0 not in found else shape
            if found not in (shape, (*batch, *shape), over_field, (*batch, *over_field)):
                each = f" or, one for each image, {(*batch, *shape)}" if batch else ""
                nodes = f" or, over the field, (rows, columns, {count})" if name == "zernike" else ""
                raise ValueError(f"{name} must have the shape {shape}{each}{nodes}, got {found}")
        if lens["zernike"] is not None and self._static.namespace.concrete(lens["zernike"]):
            largest = np.abs(self._static.namespace.to_numpy(lens["zernike"])).reshape(-1, count).max(axis=0)
            for value, (term, most) in zip(largest, optics.zernike, strict=True):
                if not value <= most * (1.0 + _SLACK):
                    raise ValueError(f"zernike of the term {term} must be at most {most:g} rad, got {value:.4g}")

    def _require_values(self, image: Operand, distance: Operand, lens: Mapping[str, Operand]) -> None:
        """Raise ValueError if values that are known now are NaN or out of range."""
        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        if _several(lens):
            ones = (1,) * (len(distance.shape) - 1)
            shapes = {n: (-1, *ones) for n in ("focus_distance", "f_number") if lens[n] is not None and lens[n].shape}
            lens = dict(lens) | {name: xp.reshape(lens[name], shape) for name, shape in shapes.items()}
        c, scale = self._focus(distance, lens)
        if not ns.concrete(image) or not ns.concrete(c):
            return
        if not bool(xp.all(xp.isfinite(image))):
            raise ValueError("image must be finite, got NaN or infinity")
        low, high = static.edges[0], static.edges[-1]
        slack = _SLACK * (high - low)
        least, most = (float(ns.to_numpy(ns.stop(end(c)))) for end in (xp.min, xp.max))
        if not (low - slack <= least and most <= high + slack):
            metres = ns.to_numpy(ns.stop(distance))
            if unknown := int(np.isnan(metres).sum()):
                raise ValueError(f"distance must not be NaN, got NaN at {unknown} of {metres.size} points")
            optics = static.optics
            near, far = (
                1.0 / max(c / optics.waves - 1.0 / optics.sensor_distance + 1.0 / optics.focal_length, 1e-12)
                for c in (high, low)
            )
            raise ValueError(
                f"distance must be within the range that the blur was made for, C_d from {low:.4g} to {high:.4g} rad "
                f"({near:.4g} to {far:.4g} m with the lens as given), got C_d from {least:.4g} to {most:.4g} rad "
                f"({metres.min():.4g} to {metres.max():.4g} m)"
            )
        if scale is not None and ns.concrete(scale):
            size = np.log(ns.to_numpy(ns.stop(scale)).astype(np.float64))
            if not (static.scales[0] - _SLACK <= size.min() and size.max() <= static.scales[1] + _SLACK):
                made = {"focus_distance": static.optics.focus, "f_number": static.optics.stops}
                given = {n: ns.to_numpy(ns.stop(lens[n])) for n in made if lens[n] is not None}
                told = (f"{n} within {made[n]}, got {v.min():.6g} to {v.max():.6g}" for n, v in given.items())
                raise ValueError(f"the blur was made for {' and '.join(told)}; clamp what is learned to its range")

    def _padding(self, c: Operand, axis: int) -> tuple[Tensor, Tensor]:
        """Return source indices for positions up to a window beyond the image, and 1 inside the image, else 0."""
        static = self._static
        xp, count, half = static.namespace.xp, c.shape[axis], static.half
        where = {} if static.namespace.name in ("jax", "numpy") else {"device": c.device}
        at = xp.arange(-half, count + half, **where)
        inside = xp.astype((at >= 0) & (at < count), c.dtype)
        if static.border != "reflect":
            return xp.clip(at, 0, count - 1), inside
        # Mirrored at the edges, with the edge pixel repeated: period 2 count.
        turned = at % (2 * count)
        return xp.where(turned < count, turned, 2 * count - 1 - turned), inside

    def _weights(self, c: Operand) -> list[Tensor]:
        """Return the weights of the windows of each layer, shape (rank, points), for C_d (points,)."""
        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        if ns.name != "jax" and c.shape[0] > 2 * _BLOCK:  # polynomials of a block stay in the cache
            blocks = [self._weights(part) for part in _pieces(ns, c, _BLOCK)]
            return [xp.concat(list(parts), axis=1) for parts in zip(*blocks, strict=True)]
        layer: Operand = None
        middle, reach = self.tables["middles"][0], self.tables["reaches"][0]
        if len(static.ranks) > 1:
            # The layer is an index, without derivative.
            layer = xp.searchsorted(self.tables["edges"], ns.stop(c))
            middle, reach = (xp.take(self.tables[name], layer, axis=0) for name in ("middles", "reaches"))
        x = xp.clip((c - middle) / reach, -1.0, 1.0)
        polynomials = _polynomials(ns, x, max(static.degrees))
        made = []
        for k, degrees in enumerate(static.degrees):
            weights = ns.matmul(self.tables[f"weights_{k}"], polynomials[:degrees, ...])
            # Each point takes the weights of its own layer alone.
            made.append(weights if layer is None else xp.where(layer == k, weights, xp.zeros_like(weights)))
        return made

    def _kernels(self, size: tuple[int, ...], scale: Operand, coefficients: Operand) -> list[Tensor]:
        """Return the spectra of the windows of each layer, shape (rank, channels, rows, columns)."""
        static = self._static
        ns, xp, tables = static.namespace, static.namespace.xp, self.tables
        ends = np.cumsum(static.ranks).tolist()
        parts = [slice(end - rank, end) for end, rank in zip(ends, static.ranks, strict=True)]
        if coefficients is not None:
            assert static.aberrated is not None
            one = xp.ones_like(tables["nodes"][0]) if scale is None else scale
            made = []
            for part in parts:
                whole = static.aberrated(ns, tables, tables["nodes"][part], coefficients, one)
                made.append(xp.fft.rfftn(_centred(xp, whole, static.half, size), axes=(-2, -1)))
            return made
        if scale is None:
            windows = xp.sum(tables["windows"] * tables["as given"], axis=0)
        else:
            low, high = static.scales
            # Position from -1 to 1 among the known sizes, on a logarithmic scale.
            x = xp.clip((xp.log(scale) - 0.5 * (low + high)) * (2.0 / (high - low)), -1.0, 1.0)
            basis = _polynomials(ns, xp.reshape(x, (1,)), tables["transform"].shape[0])
            shares = ns.matmul(xp.permute_dims(basis, (1, 0)), tables["transform"])
            windows = xp.sum(tables["windows"] * xp.reshape(shares, (-1, 1, 1, 1)), axis=0)
        # Windows are symmetric: a quarter and cosines give the whole spectrum, which is real.
        down, across = (_cosines(ns, side, tables, every) for side, every in zip(size, (True, False), strict=True))
        made = []
        for part in parts:
            octants = windows[part, ...]
            quarter = xp.reshape(
                xp.take(octants, tables["cell"], axis=-1), (*octants.shape[:2], *(2 * (static.half + 1,)))
            )
            made.append(ns.matmul(ns.matmul(down, quarter), xp.permute_dims(across, (1, 0))))
        return made

    def _mixed(self, image: Operand, c: Operand, size: tuple[int, ...], kernels: list[Tensor]) -> Tensor:
        """Return the spectrum of the blurred image (..., channels, rows, columns)."""
        ns, xp, shape = self._static.namespace, self._static.namespace.xp, tuple(c.shape)
        total: Operand = 0.0
        lead = (1,) * (len(image.shape) - 3)
        several = max(1, _CACHED // math.prod(image.shape))
        for weights, kernel in zip(self._weights(xp.reshape(c, (-1,))), kernels, strict=True):
            weights = xp.reshape(weights, (-1, *shape[:-2], 1, *shape[-2:]))
            kernel = xp.reshape(kernel, (kernel.shape[0], *lead, *kernel.shape[1:]))
            each = weights.shape[0] if ns.name == "jax" else several
            pieces = (_pieces(ns, part, each) for part in (weights, kernel))
            for part, spectrum in zip(*pieces, strict=True):
                found = xp.fft.rfftn(part * image, s=size, axes=(-2, -1)) * spectrum
                total = total + (xp.sum(found, axis=0) if found.shape[0] > 1 else found[0, ...])
        spectrum_of_image: Tensor = total
        return spectrum_of_image

    def _cropped(self, spectrum: Operand, shape: tuple[int, ...], size: tuple[int, ...]) -> Tensor:
        """Return the image of a spectrum without what is beyond its edges."""
        half, (height, width) = self._static.half, shape[-2:]
        whole = self._static.namespace.xp.fft.irfftn(spectrum, s=size, axes=(-2, -1))
        made: Tensor = whole[..., half : half + height, half : half + width]
        return made if len(made.shape) == len(shape) else self._static.namespace.xp.reshape(made, shape)

    def _occlusion(
        self, image: Operand, c: Operand, size: tuple[int, ...], kernels: list[Tensor], shape: tuple[int, ...]
    ) -> Operand:
        """Return the change of the image by occlusion."""
        # Layers from the front to the back, each blurred by one PSF.
        static = self._static
        xp, screens = static.namespace.xp, static.screens
        cover = xp.ones_like(image)
        covered: Operand = 0.0
        out: Operand = 0.0
        plain: Operand = 0.0
        for k, here in enumerate(screens):
            # Each point is in two layers, in shares that change linearly with C_d.
            share: Operand = 1.0
            if k > 0:
                share = xp.clip((screens[k - 1] - c) / (screens[k - 1] - here), 0.0, 1.0)
            if k + 1 < len(screens):
                share = share * xp.clip((c - screens[k + 1]) / (here - screens[k + 1]), 0.0, 1.0)
            share = xp.expand_dims(share * xp.ones_like(c), axis=-3)
            kernel: Operand = 0.0
            for layer, spectrum in enumerate(kernels):
                mixture = self.tables[f"screens_{layer}"][k, ...]
                kernel = kernel + xp.sum(spectrum * xp.reshape(mixture, (-1, 1, 1, 1)), axis=0)
            light, part = (
                self._cropped(xp.fft.rfftn(share * each, s=size, axes=(-2, -1)) * kernel, shape, size)
                for each in (image, cover)
            )
            part = xp.clip(part, 0.0, 1.0)
            # Light of a layer is let through where nearer ones leave room: coverage adds up to at most 1.
            seen = part if k == 0 else xp.minimum(part, 1.0 - covered)
            out, plain = out + light * (seen / (part + _TRACE)), plain + light
            covered = covered + seen
        # Divided by the coverage, so that a surface hidden nowhere keeps its brightness.
        return out / (covered + _TRACE) - plain

    def __repr__(self) -> str:
        static = self._static
        optics = [
            name
            for name, there in zip(
                _OPTICS,
                (static.optics.focus, static.optics.stops, static.optics.defocus, static.optics.zernike),
                strict=True,
            )
            if there
        ]
        also = f"; {', '.join(optics)} can be learned" if optics else ""
        return (
            f"<TracedBlur in {static.namespace.name}: {static.channels} channel(s), {self.rank} windows of "
            f"{2 * static.half + 1} x {2 * static.half + 1} in {len(static.ranks)} layer(s){also}>"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        ns = self._static.namespace
        return _placed, (self._static, {name: ns.to_numpy(table) for name, table in self.tables.items()})


def _several(lens: Mapping[str, Operand]) -> list[str]:
    """Return the operands of the lens that differ between the images of a batch."""
    several = {"focus_distance": (1,), "f_number": (1,), "zernike": (2, 4)}
    return [name for name, axes in several.items() if lens[name] is not None and len(lens[name].shape) in axes]


def _pieces(ns: Namespace, x: Operand, size: int) -> list[Operand]:
    """Return pieces of `size` along the first axis."""
    if ns.name == "torch":  # derivatives of slices would each be as large as the whole
        return list(x.split(size, dim=0))
    count = x.shape[0]
    return [x[k : min(k + size, count), ...] for k in range(0, count, size)]


def _polynomials(ns: Namespace, x: Operand, count: int) -> Operand:
    """Return the Chebyshev polynomials of degrees below `count` at x (n,), shape (count, n)."""
    # T_(m+j) = 2 T_m T_j - T_(m-j)
    # Each turn of the loop doubles the number of polynomials.
    xp = ns.xp
    made: Operand = xp.stack([xp.ones_like(x), x], axis=0)
    while made.shape[0] < count:
        m = made.shape[0] - 1
        more = 2.0 * made[m : m + 1, ...] * made[1:, ...] - xp.flip(made[:m, ...], axis=0)
        made = xp.concat([made, more], axis=0)
    return made[:count, ...]


def _fast(side: int) -> int:
    """Return the least number at or above `side` without prime factors above 5, for fast Fourier transforms."""
    while True:
        rest = side
        for prime in (2, 3, 5):
            while rest % prime == 0:
                rest //= prime
        if rest == 1:
            return side
        side += 1


def _cosines(ns: Namespace, side: int, tables: Tables, every: bool) -> Operand:
    """Return the cosine transform of half a symmetric row, to all frequencies or to those of real rows."""
    xp, at = ns.xp, tables["at"]
    where = {} if ns.name in ("jax", "numpy") else {"device": at.device}  # type: ignore[attr-defined]
    frequency = xp.arange(side if every else side // 2 + 1, **where)
    # Whole turns are removed in integers: exact for large products, which float32 would round.
    turns = (xp.reshape(frequency, (-1, 1)) * at) % side  # type: ignore[operator]
    return xp.cos(xp.astype(turns, tables["once"].dtype) * (math.tau / side)) * tables["once"]


def _centred(xp: ArrayFunctions, windows: Operand, half: int, size: tuple[int, ...]) -> Operand:
    """Return windows (..., side, side) in arrays of `size`, their centre at the first element."""
    for axis, length in ((-2, size[0]), (-1, size[1])):
        first = (Ellipsis, slice(half, None), slice(None)) if axis == -2 else (Ellipsis, slice(half, None))
        last = (Ellipsis, slice(0, half), slice(None)) if axis == -2 else (Ellipsis, slice(0, half))
        shape = list(windows.shape)
        shape[axis] = length - (2 * half + 1)
        where = (
            {} if not hasattr(windows, "device") or "jax" in type(windows).__module__ else {"device": windows.device}
        )
        zeros = xp.zeros(tuple(shape), dtype=windows.dtype, **where)
        windows = xp.concat([windows[first], zeros, windows[last]], axis=axis)
    return windows


def traced_blur(
    lens: Lens,
    distances: ArrayLike,
    pixel: float,
    xp: object = None,
    *,
    wavelengths: Channels | Sequence[Spectrum] | None = None,
    focus_distances: tuple[float, float] | None = None,
    f_numbers: tuple[float, float] | None = None,
    defocus: float = 0.0,
    zernike: Mapping[Term, float] | None = None,
    border: str = "reflect",
    device: object = None,
    precision: str = "float32",
    tol: float = 1e-4,
    energy: float = 0.98,
    largest: int = 256,
) -> TracedBlur:
    r"""Return the blur of a lens as a differentiable function of an image, its depth and the lens.

    The range of C_d is divided into layers. Within one, all pixel-integrated PSFs are sums of few, with polynomials
    of C_d as weights; so the blur is a few convolutions for each layer. All defocus has one size of window, and is
    divided by the light within it, so that derivatives by depth are those of the image. See docs/certificate.md.

    Parameters
    ----------
    lens : Lens
        Paraxial, with a round aperture and radially symmetric aberrations.
    distances : array_like
        Metres; the valid range is from the least to the largest.
    pixel : float
        Pixel pitch, metres.
    xp, device
        As of :meth:`lommel.Plan.traced`.
    wavelengths : Channels or sequence, optional
        :class:`lommel.Channels`, or a wavelength (metres) or pairs of wavelength and weight for each channel, such as
        ``lommel.imaging.RED_GREEN_BLUE``. By default one channel, at the wavelength of the lens.
    focus_distances, f_numbers : (float, float), optional
        Ranges of `focus_distance` (metres) and `f_number` that the blur then takes as arguments. The f-number needs a
        lens without aberrations, obscuration and apodization.
    defocus : float, default 0
        Largest magnitude of the argument `defocus`, radians.
    zernike : mapping of (n, m) to float, optional
        Zernike terms whose coefficients are then an argument, each with its largest magnitude: radians at the edge of
        the pupil and the wavelength of the lens. Windows are computed in the framework at each call with them.
    border : {"reflect", "extend", "zero"}, default "reflect"
        Continuation of image and depth beyond the edges: mirrored, the last pixels repeated, or dark.
    precision : {"float32", "float64"}, default "float32"
        Of the tables, and what is computed.
    tol : float, default 1e-4
        Tolerance of each pixel of a PSF, relative to its peak, at any defocus of the range.
    energy : float, default 0.98
        Share of the light that every window holds at least, before it is divided by that.
    largest : int, default 256
        Pixels from the middle of a window to its edge, at most.

    Returns
    -------
    TracedBlur

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or the blur exceeds `largest`.

    References
    ----------
    H. Cheng, Z. Gimbutas, P. G. Martinsson, V. Rokhlin, "On the compression of low rank matrices", SIAM J. Sci.
    Comput. 26, 1389 (2005), doi:10.1137/030602678.
    """
    require_lens(lens, "lens, distances, pixel")
    require_round("lens", lens)
    if lens.model != "paraxial":
        raise ValueError(f'lens must be paraxial, with model="paraxial", got {lens.model!r}')
    pitch = validation.pixel(pixel, metric=True)
    share = validation.real("energy", energy, above=0.0, below=1.0)
    allowed = validation.real("tol", tol, least=1e-9, below=1e-1)
    ns = _namespace(xp, device, precision)
    validation.choice("border", border, BORDERS)
    colours = spectra("wavelengths", [lens.wavelength] if wavelengths is None else wavelengths)
    optics = _optics(lens, focus_distances, f_numbers, defocus, zernike)
    low, high, scales = _ranges(lens, optics, distances)
    # At the largest scale the PSF spans most pixels: its window holds all others.
    lights = [SensorLight.of(lens, colour, pitch) for colour in colours]
    widest = [replace(light, pixel=pitch / math.exp(scales[1])) for light in lights]
    most = validation.integer("largest", largest, least=1, most=4096)
    half = max(light.enough((low, high), share, most)[0] for light in widest)
    exact = _Exact(lights, half)
    sizes = chebyshev_nodes(3)[0] if scales[1] > scales[0] else np.zeros(1)
    sizes = 0.5 * (scales[0] + scales[1]) + 0.5 * (scales[1] - scales[0]) * sizes
    step = math.pi * pitch / (lens.wavelength * lens.working_f_number)
    aberrated: AberratedWindows | None = None
    of_zernike: dict[str, Operand] = {}
    if optics.zernike:
        window = half, step / math.exp(scales[0])
        aberrated, of_zernike = traced_windows.make(lens, dict(optics.zernike), (low, high), colours, window, allowed)
        of_zernike["lattice"] = of_zernike["lattice"] * math.exp(scales[0])
    numpy, draw = Namespace.of(None), np.random.default_rng(0)

    def with_terms(c: Array, coefficients: Array) -> Array:
        assert aberrated is not None
        # A size of 1: windows of the stated lens.
        made = numpy.to_numpy(aberrated(numpy, of_zernike, c, coefficients, np.float64(1.0)))
        return np.reshape(made, (len(c), len(colours), -1))

    limits = np.array([most for _, most in optics.zernike])
    # Corners of the range of coefficients, and points inside it, stand for all of it.
    members = [limits * draw.choice([-1.0, 1.0], limits.size) * share for share in (1.0, 0.6)] if limits.size else []

    def windows(c: Array) -> Array:
        together = np.concatenate([exact(c, float(size)) for size in sizes], axis=1)
        return _joined(together, [with_terms(c, each) for each in members])

    values = exact.cells * len(colours) * len(sizes)
    rate = lens.wavelength / min(wavelength for colour in colours for wavelength, _ in colour)
    layers = defocus_layers(windows, low, high, allowed, _WIDTH, rate, max(1, _TOGETHER // values))
    nodes = np.concatenate([layer.nodes for layer in layers])
    known = np.concatenate([layer.windows[:, : len(colours), : exact.cells] for layer in layers])
    table, transform = _sizes(exact, nodes, known, scales, allowed)
    # The marginal ray moves by 4 lambda N / pi a radian, step / 4 radians a pixel: about a pixel a screen.
    screens = np.linspace(high, low, int(np.clip(math.ceil((high - low) * 4.0 / step), 2, _SCREENS)))
    tables: dict[str, Values] = {
        "windows": table,
        "transform": transform,
        "as given": _as_given(scales, transform).reshape(-1, 1, 1, 1),
        "nodes": nodes,
        "at": np.arange(half + 1, dtype=np.int32),
        "once": np.where(np.arange(half + 1) == 0, 1.0, 2.0),
        "cell": cells_of_quarter(half).astype(np.int32).ravel(),
        **_layer_tables(layers, screens),
        **of_zernike,
    }
    edges = (layers[0].low, *(layer.high for layer in layers))
    ranks, degrees = (tuple(layer.weights.shape[axis] for layer in layers) for axis in (0, 1))
    static = Blur(
        namespace=ns, optics=optics, border=border, channels=len(colours), half=half, edges=edges, ranks=ranks,
        degrees=degrees, scales=scales, screens=tuple(screens.tolist()), aberrated=aberrated, error=0.0,
        precision=precision,
    )  # fmt: skip
    static = static._replace(
        error=_found_error(TracedBlur(static._replace(namespace=numpy), dict(tables)), exact, draw)
    )
    return _placed(static, tables, device)


def _namespace(xp: object, device: object, precision: str) -> Namespace:
    """Return the namespace of a framework; ValueError if it lacks the precision."""
    ns = Namespace.of(xp)
    validation.choice("precision", precision, ("float32", "float64"))
    if precision == "float64" and not ns.has_double(device):
        raise ValueError(f'precision must be "float32" here: {ns.name} has no float64, or it is switched off')
    return ns


def _joined(windows: Array, others: list[Array]) -> Array:
    """Return windows (n, parts, cells) and others of more cells side by side, padded with zeros."""
    if not others:
        return windows
    more = np.concatenate(others, axis=1)
    padded = np.zeros((*windows.shape[:2], more.shape[2]))
    padded[..., : windows.shape[2]] = windows
    return np.concatenate([padded, more], axis=1)


def _layer_tables(layers: Sequence[DefocusLayer], screens: Array) -> dict[str, Values]:
    """Return the tables of layers by name, with the weights of their windows at the C_d of occlusion layers."""
    tables: dict[str, Values] = {
        "edges": np.array([layer.high for layer in layers[:-1]]),
        "middles": np.array([0.5 * (layer.low + layer.high) for layer in layers]),
        "reaches": np.array([0.5 * (layer.high - layer.low) for layer in layers]),
    }
    for k, layer in enumerate(layers):
        inside = (screens >= layer.low) & ((screens < layer.high) | (k + 1 == len(layers)))
        x = (2.0 * screens - layer.low - layer.high) / (layer.high - layer.low)
        tables[f"weights_{k}"] = layer.weights
        tables[f"screens_{k}"] = inside[:, None] * (chebyshev(x, layer.weights.shape[1]) @ layer.weights.T)
    return tables


class _Exact:
    """Exact windows, of sum 1, of each channel."""

    def __init__(self, lights: list[SensorLight], half: int) -> None:
        self._lights, self._half, self._alike = lights, half, cells_alike(half)
        self.cells = self._alike.size

    def __call__(self, c: Array, size: float) -> Array:
        """Return windows (n, channels, cells) at C_d, for the logarithm of the size of PSFs over the stated lens."""
        made = []
        for light in self._lights:
            # A PSF larger by exp(size) on the pixel is the stated one on a smaller pixel.
            scaled = light if size == 0.0 else replace(light, pixel=light.pixel / math.exp(size))
            shares = scaled.shares(scaled.defocused(c), self._half)
            made.append(shares / (shares @ self._alike)[:, None])
        return np.stack(made, axis=1)


def _optics(
    lens: Lens,
    focus: tuple[float, float] | None,
    stops: tuple[float, float] | None,
    defocus: float,
    terms: Mapping[Term, float] | None,
) -> Optics:
    """Return the checked optics of a lens; TypeError or ValueError."""
    # C_d = pi a^2 / (2 lambda) times the error of vergence, a the radius of the aperture.
    waves = math.pi / (2.0 * lens.wavelength) * (0.5 * lens.aperture_diameter) ** 2
    if focus is not None:
        focus = _pair("focus_distances", focus, lens.focal_length)
    if stops is not None:
        stops = _pair("f_numbers", stops, 0.0)
        if not lens.aberrations.flat or lens.obscuration or not lens.illumination.uniform:
            raise ValueError("f_numbers need a lens without aberrations, obscuration and apodization")
    found: list[tuple[Term, float]] = []
    if not isinstance(terms, Mapping | None):
        raise TypeError(f"zernike must map terms (n, m) to their largest coefficients, got {validation.shown(terms)}")
    for term, most in (terms or {}).items():
        try:
            n, m = int(term[0]), int(term[1])
        except (TypeError, ValueError, IndexError):
            raise TypeError(f"a Zernike term must be a pair (n, m), got {validation.shown(term)}") from None
        if not (0 < n <= 20 and abs(m) <= n and (n - m) % 2 == 0):
            raise ValueError(f"a Zernike term must have 0 < n <= 20, |m| <= n and n - m even, got {(n, m)}")
        found.append(((n, m), validation.real(f"zernike of {(n, m)}", most, above=0.0, most=100.0)))
    # A wavefront that depends on the wavelength by itself scales otherwise than the learned terms.
    if found and lens.colour is not None:
        raise ValueError("zernike needs a lens without colour")
    most = validation.real("defocus", defocus, least=0.0)
    return Optics(lens.focal_length, lens.sensor_distance, lens.f_number, waves, focus, stops, most, tuple(found))


def _numbers(name: str, values: object) -> Values:
    """Return values that are no array of a framework as a NumPy array; TypeError or ValueError."""
    made = np.asarray(values)
    if made.dtype.kind not in "fiu":
        raise TypeError(f"{name} must hold real floats, got {validation.shown(values)}")
    if name in ("focus_distance", "f_number") and not (made > 0.0).all():
        raise ValueError(f"{name} must be above 0, got {validation.shown(values)}")
    return made


def _pair(name: str, values: ArrayLike, least: float) -> tuple[float, float]:
    found = np.sort(validation.real_array(name, values).ravel())
    if found.size != 2 or not least < found[0] < found[1]:
        raise ValueError(f"{name} must be two different numbers above {least:g}, got {validation.shown(values)}")
    return float(found[0]), float(found[1])


def _ranges(lens: Lens, optics: Optics, distances: ArrayLike) -> tuple[float, float, tuple[float, float]]:
    """Return the least and largest C_d, and logarithms of the size of PSFs over the stated lens."""
    lens.defocus(distances)  # checks them
    given = np.asarray(distances, dtype=np.float64)
    c, sizes = [], [0.0]
    for focus in optics.focus or (None,):
        for stop in optics.stops or (None,):
            vergence, waves, scale = optics.at(focus, stop)
            c += [waves * (vergence + 1.0 / given.min()), waves * (vergence + 1.0 / given.max())]
            sizes.append(0.0 if scale is None else math.log(scale))
    c += [float(value) for value in lens.defocus([given.min(), given.max()])]
    low, high = min(c) - optics.defocus, max(c) + optics.defocus
    # A range of no width would divide by 0.
    low, high = (low, high) if high - low > 0.2 else (low - 0.1, high + 0.1)
    return low, high, (min(sizes), max(sizes))


def _sizes(exact: _Exact, nodes: Array, known: Array, scales: tuple[float, float], tol: float) -> tuple[Array, Array]:
    """Return windows of several sizes, and the matrix from these to Chebyshev coefficients; or ValueError.

    `known` are the windows of the lens as given.
    """
    low, high = scales
    if high == low:
        return known[None], np.ones((1, 1))
    # The ends of the range, where PSFs are largest, and focus, where they are sharpest.
    some = np.unique([nodes.min(), nodes.max(), nodes[np.abs(nodes).argmin()]])
    for count in _SCALES:
        x, transform = chebyshev_nodes(count)
        at = 0.5 * (low + high) + 0.5 * (high - low) * x
        known = np.stack([exact(some, float(size)) for size in at])
        # Half-way between neighbouring nodes, where interpolation errs most.
        between = np.array([-0.97, 0.5 * (x[0] + x[1]), 0.5 * (x[count // 2] + x[count // 2 - 1])])
        truth = np.stack([exact(some, 0.5 * (low + high) + 0.5 * (high - low) * float(b)) for b in between])
        made = np.tensordot(chebyshev(between, count) @ transform, known, 1)
        if (np.abs(made - truth).max(axis=-1) / truth.max(axis=-1)).max() <= 0.3 * tol:
            return np.stack([exact(nodes, float(size)) for size in at]), transform
    raise ValueError(
        f"focus_distances and f_numbers change the size of PSFs by a factor of {math.exp(high - low):.4g}, which "
        f"takes more than {_SCALES[-1]} sets of windows; ask for smaller ranges, or for a larger tol"
    )


def _as_given(scales: tuple[float, float], transform: Array) -> Array:
    """Return the weights of the windows of known sizes for the lens as given, whose size is 0."""
    low, high = scales
    x = 0.0 if high == low else -(low + high) / (high - low)
    return np.asarray((chebyshev(np.array([x]), len(transform)) @ transform)[0])


def _found_error(blur: TracedBlur, exact: _Exact, draw: np.random.Generator) -> float:
    """Return the largest error of windows between known ones, over their peaks, at 12 random C_d."""
    edges, tables = np.array(blur._static.edges), blur.tables
    c = np.sort(draw.uniform(edges[0], edges[-1], 12))
    windows = np.asarray(tables["windows"] * tables["as given"]).sum(axis=0)
    weights = np.concatenate([np.asarray(part) for part in blur._weights(c)])
    truth = exact(c, 0.0)
    off = np.tensordot(weights.T, windows, 1) - truth
    return float((np.abs(off).max(axis=-1) / truth.max(axis=-1)).max())


def _placed(static: Blur, tables: Mapping[str, Values], device: object = None) -> TracedBlur:
    """Return a blur with its NumPy tables on a device, in its precision."""
    ns = static.namespace
    kind = getattr(ns.xp, static.precision)
    if ns.name == "jax":
        _of_jax()
    return TracedBlur(
        static,
        {name: ns.put(table, device, kind if table.dtype.kind == "f" else None) for name, table in tables.items()},
    )


@cache
def _of_jax() -> Any:
    """Register the class with JAX as a tree of its tables; return the compiled blur."""
    import jax

    jax.tree_util.register_pytree_node(
        TracedBlur,
        lambda blur: ((blur.tables,), blur._static),
        lambda static, parts: TracedBlur(static, *parts),
    )

    def made(blur: TracedBlur, image: Tensor, distance: Tensor, lens: dict[str, Tensor], occlusion: bool) -> Tensor:
        return blur._by_lens(image, distance, lens, occlusion=occlusion)

    return jax.jit(made, static_argnums=4)


@cache
def _module_class() -> Any:
    torch = library("torch", "modules need", "torch")

    class BlurModule(torch.nn.Module):  # type: ignore[misc,name-defined]
        """A blur as a layer."""

        def __init__(self, blur: TracedBlur, learned: dict[str, Array]) -> None:
            super().__init__()
            self._static = blur._static
            self._names = tuple(blur.tables)
            for k, name in enumerate(self._names):
                self.register_buffer(f"table_{k}", blur.tables[name], persistent=False)
            like: Any = blur.tables["middles"]
            for name, value in learned.items():
                start = torch.as_tensor(value, dtype=like.dtype, device=like.device)
                self.register_parameter(name, torch.nn.Parameter(start))

        def blur(self) -> TracedBlur:
            """Return the function with the tables in their present place."""
            return TracedBlur(self._static, {name: getattr(self, f"table_{k}") for k, name in enumerate(self._names)})

        def forward(self, image: Operand, distance: Operand, **options: Operand) -> Operand:
            for name, value in self.named_parameters():
                options.setdefault(name, value)
            return self.blur()(image, distance, **options)

        def __reduce__(self) -> tuple[Any, ...]:
            learned = {name: value.detach().cpu().numpy() for name, value in self.named_parameters()}
            return _module, (self.blur(), learned)

    return BlurModule


def _module(blur: TracedBlur, learned: dict[str, Array]) -> Any:
    """Return a blur as a PyTorch module whose parameters start at the `learned` values."""
    return _module_class()(blur, learned)
