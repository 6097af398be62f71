"""Depth-dependent blur as a differentiable function of images, depth and the lens, in JAX, PyTorch and NumPy."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.optional import library
from lommel.imaging import traced_windows
from lommel.imaging.blur import require_lens
from lommel.imaging.sensor_light import SensorLight
from lommel.imaging.settings import Spectrum, spectra
from lommel.imaging.traced_windows import (
    AberratedWindows,
    DefocusLayer,
    Term,
    defocus_layers,
)
from lommel.methods.pixel_rule import cells_alike, cells_of_quarter
from lommel.optics.colour.spectrum import Channels
from lommel.optics.lens import Lens, require_round
from lommel.special.chebyshev import chebyshev, chebyshev_nodes
from lommel.traced.namespaces import Namespace, Operand, Tables, Tensor

_WINDOW_SETS = (4, 6, 8, 12, 16, 24, 32)  # numbers of PSF sizes, in the order tried; each size has a set of windows
_TOL = 1e-4  # tolerance of each pixel of a PSF / the peak of the PSF
_ENERGY = 0.98  # smallest fraction of the light of a PSF inside its window
_MAX_HALF = 256  # largest half width of windows, pixels
_MAX_SCREENS = 16  # largest number of occlusion layers
_MIN_COVERAGE = 1e-6  # coverage added to denominators to avoid division by 0
_SLACK = 1e-5  # margin of a valid range / its width, for rounding to float32
_LAYER_WIDTH = 36.0  # width of a defocus layer: C_d in radians at the shortest wavelength
_BLOCK_POINTS = 2**14  # largest number of points whose polynomials are computed together
_MAX_VALUES = 2**25  # largest number of window pixels computed together
_CACHED_VALUES = 2**19  # largest number of image pixels convolved together outside JAX; they fit into the CPU cache
_NUMPY_TYPES = (np.ndarray, np.generic)
_OPTICS = ("focus_distance", "f_number", "defocus", "zernike")


class Optics(NamedTuple):
    """Parameters of the given paraxial lens (m, rad), and the valid ranges of its learnable parameters."""

    focal_length: float
    sensor_distance: float
    f_number: float
    rad_per_dioptre: float  # C_d = rad_per_dioptre (vergence + 1 / distance), with a vergence in 1/m
    focus: tuple[float, float] | None  # valid range of the focus distance (m); None if it is fixed
    stops: tuple[float, float] | None  # valid range of the f-number; None if it is fixed
    defocus: float  # largest magnitude of additional C_d (rad)
    zernike: tuple[tuple[Term, float], ...]  # terms, each with the largest magnitude of its coefficient (rad)

    def at(self, focus_distance: Operand, f_number: Operand) -> tuple[Operand, Operand, Operand]:
        """Return the vergence (1/m), `rad_per_dioptre`, and the ratio to PSF sizes of the given lens (None: 1)."""
        inverse = 1.0 / self.sensor_distance
        vergence: Operand = inverse - 1.0 / self.focal_length
        size_ratio: Operand = None
        if focus_distance is not None:
            # C_d is 0 at the focus distance if the vergence is -1 / focus_distance.
            vergence = -1.0 / focus_distance
            # PSF size is proportional to the working f-number, and therefore to the sensor distance.
            size_ratio = inverse / (1.0 / self.focal_length + vergence)
        if f_number is None:
            return vergence, self.rad_per_dioptre, size_ratio
        ratio = f_number / self.f_number
        # C_d is proportional to the square of the aperture radius, and therefore to 1 / f_number^2.
        return vergence, self.rad_per_dioptre / ratio**2, ratio if size_ratio is None else ratio * size_ratio


class Blur(NamedTuple):
    """Settings of a blur: everything except its arrays.

    Attributes
    ----------
    namespace : Namespace
    optics : Optics
    channels : int
    half : int
        Half width of windows, pixels.
    edges : tuple of float
        C_d (rad) at the boundaries of the defocus layers.
    ranks, degrees : tuple of int
        For each layer, the number of windows, and the number of Chebyshev polynomials in the weights of windows.
    log_ratios : tuple of float
        Smallest and largest value of log((PSF size) / (PSF size of the given lens)).
    screens : tuple of float
        C_d (rad) of the occlusion layers, nearest first.
    aberrated : AberratedWindows or None
        Computation of windows for Zernike coefficients; None if there are no terms.
    error : float
        Largest measured error of windows relative to their peaks; see :class:`TracedBlur`.
    precision : str
        Data type of the computation.
    """

    namespace: Namespace
    optics: Optics
    channels: int
    half: int
    edges: tuple[float, ...]
    ranks: tuple[int, ...]
    degrees: tuple[int, ...]
    log_ratios: tuple[float, float]
    screens: tuple[float, ...]
    aberrated: AberratedWindows | None
    error: float
    precision: str


class TracedBlur:
    """Depth-dependent blur as a differentiable function, linear in the image: ``out = blur(image, distance)``.

    ``out[q] = sum_p image[p] K(q - p; C_d(distance[p]))``. Returned by :func:`lommel.imaging.traced_blur`. Works with
    ``jit``, ``vmap``, ``scan`` and ``grad``, can be an argument of such functions (a pytree in JAX), and can be
    pickled. The derivative with respect to the image is the adjoint.

    Parameters
    ----------
    static : Blur
        Settings.
    tables : dict of array
        Arrays by name.

    Attributes
    ----------
    rank : int
        Number of convolutions of each channel.
    half : int
        Half width of the windows, pixels.
    error : float
        Largest error of windows (sum 1) relative to their peaks, measured at 12 random values of C_d.
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
            Distance from the lens in metres; may be infinite.
        focus_distance, f_number : array, shape (), optional
            Focus distance (m) and f-number; by default those of the given lens.

        Returns
        -------
        array
            C_d (rad), in the shape of `distance`.
        """
        for name, value in (("distance", distance), ("focus_distance", focus_distance), ("f_number", f_number)):
            if value is not None and not hasattr(value, "dtype"):
                _real_values(name, value)
        vergence, rad_per_dioptre, _ = self._static.optics.at(focus_distance, f_number)
        return rad_per_dioptre * (vergence + 1.0 / distance)

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
            Linear light. For one channel the axis of channels may be omitted: `image` and `distance` then have equal
            numbers of axes.
        distance : float or array, shape (..., height, width)
            Distance from the lens in metres; may be infinite. A number, or an array of the shape (..., 1, 1), applies
            to all points of an image.
        focus_distance, f_number : array, shape () or (n,), optional
            Focus distance (m) and f-number, within the ranges given to ``traced_blur``; by default those of the
            given lens. The sensor is moved to the focus, and PSFs scale with the sensor distance and the f-number.
            With the shape (n,), where n is the batch size (first axis of `image`), each image has its own lens.
        defocus : array, optional
            Additional C_d, radians; broadcasts with `distance`.
        zernike : array, shape (k,) or (n, k), or (rows, columns, k) or (n, rows, columns, k), optional
            Zernike coefficients added to the wavefront, radians at the edge of the pupil and the wavelength of the
            lens, in the order of the terms given to ``traced_blur``; n is the batch size. With axes of rows and
            columns, aberrations vary over the field: coefficients are given at nodes with equal spacing from the
            first pixel to the last. PSFs are interpolated linearly between nodes; each node takes as long as a blur.
        occlusion : bool, default False
            Whether near objects occlude far ones, in at most 16 layers. Layers are composited as by
            :class:`lommel.imaging.Occlusion`, except for hidden points; the blur is corrected by the difference
            between composited and added layers. The result is differentiable almost everywhere. Occlusion takes about
            five times as long.
        check : bool, default True
            Whether to check values; the check waits for the device. Values are never checked during tracing.

        Returns
        -------
        array
            Blurred image in the shape of `image`. NaN where an unchecked value is out of range.

        Raises
        ------
        TypeError, ValueError
            If an array has an invalid type or shape, contains NaN, or is out of range.
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
        operands = dict(zip(_OPTICS, (focus_distance, f_number, defocus, zernike), strict=True))
        lens = {name: None if value is None else self._array(name, value) for name, value in operands.items()}
        self._require_optics(lens, tuple(image.shape))
        if occlusion and lens["zernike"] is not None and len(lens["zernike"].shape) > 2:
            raise ValueError(
                "occlusion needs constant aberrations over the field; pass zernike in the shape (k,) or (n, k)"
            )
        if check:
            self._require_values(image, distance, lens)
        if static.namespace.name == "jax":  # without compilation a call takes seconds
            return xp.reshape(_jitted_blur()(self, image, distance, lens, bool(occlusion)), shape)
        return xp.reshape(self._by_lens(image, distance, lens, occlusion=occlusion), shape)

    def _by_lens(self, image: Operand, distance: Operand, lens: Mapping[str, Operand], *, occlusion: bool) -> Tensor:
        """Return the blurred images; the images of a batch may have different lenses."""
        batched = {"image", "distance", *_batched_operands(lens)}
        if len(batched) == 2:
            return self._over_field(image, distance, lens, occlusion=occlusion)
        values: dict[str, Operand] = {"image": image, "distance": distance, **lens}
        if lens["defocus"] is not None and len(lens["defocus"].shape) == len(distance.shape):
            batched.add("defocus")
        # Operands with batch length 1 apply to all images, and are not mapped over the batch.
        axes = {name: 0 if name in batched and values[name].shape[0] > 1 else None for name in values}
        values |= {name: values[name][0, ...] for name in batched if axes[name] is None}

        def blur_image(values: Mapping[str, Operand]) -> Tensor:
            optics = {name: values[name] for name in _OPTICS}
            return self._over_field(values["image"], values["distance"], optics, occlusion=occlusion)

        xp, count = self._static.namespace.xp, image.shape[0]
        if self._static.namespace.name == "jax" and count > 1:
            import jax

            mapped: Tensor = jax.vmap(blur_image, in_axes=(axes,))(values)
            return mapped
        parts = [{n: x if axes[n] is None else x[k, ...] for n, x in values.items()} for k in range(count)]
        images: Tensor = xp.stack([blur_image(part) for part in parts], axis=0)
        return images

    def _over_field(
        self, image: Operand, distance: Operand, lens: Mapping[str, Operand], *, occlusion: bool
    ) -> Tensor:
        """Return the blurred image, with PSFs interpolated linearly between the nodes of the field."""
        static = self._static
        xp, nodes = static.namespace.xp, lens["zernike"]
        if nodes is None or len(nodes.shape) < 3:
            return self._blurred(image, distance, lens, occlusion=occlusion)
        count, columns = math.prod(nodes.shape[:2]), nodes.shape[1]
        down, across = (self._node_weights(image, axis, nodes.shape[axis]) for axis in (0, 1))
        nodes = xp.reshape(nodes, (count, nodes.shape[-1]))

        def blur_node(row: Operand, column: Operand, coefficients: Operand) -> Tensor:
            weight = xp.expand_dims(row, axis=-1) * column
            # The PSF of a point is a weighted sum over nodes: each node blurs the image times its weights.
            return self._blurred(image * weight, distance, dict(lens) | {"zernike": coefficients}, occlusion=False)

        if static.namespace.name == "jax":
            import jax

            weights_and_nodes = xp.repeat(down, columns, axis=0), xp.tile(across, (count // columns, 1)), nodes
            start = xp.zeros(image.shape, dtype=image.dtype)
            # A scan stores the intermediate images of one node only.
            total: Tensor = jax.lax.scan(lambda x, node: (x + blur_node(*node), None), start, weights_and_nodes)[0]
            return total
        partial_sum: Operand = 0.0
        for k in range(count):
            partial_sum = partial_sum + blur_node(down[k // columns, ...], across[k % columns, ...], nodes[k, ...])
        blurred: Tensor = partial_sum
        return blurred

    def _node_weights(self, image: Operand, axis: int, count: int) -> Tensor:
        """Return linear interpolation weights of `count` nodes along an axis of the image, shape (count, points)."""
        xp, side = self._static.namespace.xp, image.shape[axis - 2]
        placement = self._static.namespace.beside(image)
        position = xp.astype(xp.arange(side, **placement), image.dtype) * ((count - 1) / max(1, side - 1))
        node = xp.reshape(xp.astype(xp.arange(count, **placement), image.dtype), (-1, 1))
        hats: Tensor = xp.clip(1.0 - xp.abs(position - node), 0.0, 1.0)
        return hats

    def _blurred(self, image: Operand, distance: Operand, lens: Mapping[str, Operand], *, occlusion: bool) -> Tensor:
        """Return the blurred image (..., channels, height, width) from arrays of checked shape."""
        static = self._static
        xp, shape = static.namespace.xp, tuple(image.shape)
        c, size_ratio = self._focus(distance, lens)
        # NaN is added, not selected by `where`: gradients of other pixels then remain finite.
        low, high = static.edges[0], static.edges[-1]
        slack = _SLACK * (high - low)
        invalid = (c < low - slack) | (c > high + slack) | xp.isnan(c)
        image = image + xp.expand_dims(xp.where(invalid, float("nan"), xp.zeros_like(c)), axis=-3)
        rows, columns = (self._padding(c, axis) for axis in (-2, -1))
        c = xp.take(xp.take(c, rows, axis=-2), columns, axis=-1)
        image = xp.take(xp.take(image, rows, axis=-2), columns, axis=-1)
        fft_shape = tuple(scipy.fft.next_fast_len(side, real=True) for side in c.shape[-2:])
        kernels = self._kernels(fft_shape, size_ratio, lens["zernike"])
        blurred = self._cropped(self._spectrum(image, c, fft_shape, kernels), shape, fft_shape)
        return blurred + self._occlusion(image, c, fft_shape, kernels, shape) if occlusion else blurred

    def _focus(self, distance: Operand, lens: Mapping[str, Operand]) -> tuple[Operand, Operand]:
        """Return C_d (rad), and the ratio of PSF sizes to those of the given lens (None: 1)."""
        vergence, rad_per_dioptre, size_ratio = self._static.optics.at(lens["focus_distance"], lens["f_number"])
        c = rad_per_dioptre * (vergence + 1.0 / distance)
        return (c if lens["defocus"] is None else c + lens["defocus"]), size_ratio

    def torch_module(self, **learned: Operand) -> Any:
        """Return a ``torch.nn.Module`` with the tables as buffers; ``forward`` has the arguments of the blur.

        It can be pickled, moved between devices and compiled.

        Parameters
        ----------
        **learned : float or sequence, optional
            Initial values of `focus_distance`, `f_number`, `defocus` or `zernike`, which become parameters of the
            module. Arguments of `forward` with the same name replace them.

        Raises
        ------
        TypeError
            If the blur was created for another framework, or another parameter is named.
        """
        if self._static.namespace.name != "torch":
            raise TypeError(f"a torch module needs a blur with xp=torch, got one for {self._static.namespace.name}")
        if unknown := set(learned) - set(_OPTICS):
            raise TypeError(f"learned parameters are {', '.join(_OPTICS)}, got {', '.join(sorted(unknown))}")
        return _module(self, {name: np.asarray(value, dtype=np.float64) for name, value in learned.items()})

    def _array(self, name: str, values: Operand) -> Operand:
        """Return values as an array of the framework, with the data type of the tables."""
        static, table = self._static, self.tables["middles"]
        ns, xp = static.namespace, static.namespace.xp
        if ns.name == "numpy" or isinstance(values, _NUMPY_TYPES):
            validation.refuse_masked(name, values)
        if not hasattr(values, "dtype") or (isinstance(values, _NUMPY_TYPES) and ns.name != "numpy"):
            values = ns.put(_real_values(name, values), getattr(table, "device", None) if ns.name != "jax" else None)
            if name in _OPTICS or (name == "distance" and not values.shape):
                return xp.astype(values, table.dtype)
        if not hasattr(values, "shape") or not xp.isdtype(values.dtype, "real floating"):
            hint = "; scale it to linear light first" if name == "image" else ""
            raise TypeError(f"{name} must hold real floats, got {getattr(values, 'dtype', type(values))}{hint}")
        return xp.astype(values, table.dtype, copy=False)

    def _require_shapes(self, original: tuple[int, ...], image: tuple[int, ...], distance: tuple[int, ...]) -> None:
        """Raise ValueError unless image and depth have matching shapes and the image has all channels.

        `original` is the shape of the image as the caller passed it; `image` includes an axis of channels.
        """
        channels = self._static.channels
        matching = len(distance) >= 2 and len(image) == len(distance) + 1 and image[-2:] == distance[-2:]
        if matching and image[-3] == channels and 0 not in image:
            batch_axes = zip(image[:-3], distance[:-2], strict=True)
            if all(depths in (1, images) for images, depths in batch_axes):
                return
        expected = (
            "(..., height, width) or (..., 1, height, width)"
            if channels == 1
            else f"(..., {channels}, height, width)"
        )
        raise ValueError(
            f"image must have the shape {expected} and distance (..., height, width) with equal sides, got "
            f"{original} and {distance}"
        )

    def _require_optics(self, lens: Mapping[str, Operand], image: tuple[int, ...]) -> None:
        """Raise ValueError if a lens parameter is fixed in this blur, has a wrong shape, or is out of range."""
        optics = self._static.optics
        ranges = {
            "focus_distance": ("focus_distances", optics.focus is not None),
            "f_number": ("f_numbers", optics.stops is not None),
            "defocus": ("defocus", optics.defocus > 0.0),
            "zernike": ("zernike", bool(optics.zernike)),
        }
        for name, (option, learnable) in ranges.items():
            if lens[name] is not None and not learnable:
                raise ValueError(f"{name} is fixed in this blur; pass its range as {option}= to traced_blur")
        count, batch = len(optics.zernike), image[:-3][:1]
        for name, shape in (("focus_distance", ()), ("f_number", ()), ("zernike", (count,))):
            given = shape if lens[name] is None else tuple(lens[name].shape)
            over_field = (*given[-3:-1], *shape) if name == "zernike" and len(given) > 2 and 0 not in given else shape
            if given not in (shape, (*batch, *shape), over_field, (*batch, *over_field)):
                per_image = f" or, one for each image, {(*batch, *shape)}" if batch else ""
                nodes = f" or, over the field, (rows, columns, {count})" if name == "zernike" else ""
                raise ValueError(f"{name} must have the shape {shape}{per_image}{nodes}, got {given}")
        if lens["zernike"] is not None and self._static.namespace.concrete(lens["zernike"]):
            largest = np.abs(self._static.namespace.to_numpy(lens["zernike"])).reshape(-1, count).max(axis=0)
            for value, (term, limit) in zip(largest, optics.zernike, strict=True):
                if not value <= limit * (1.0 + _SLACK):
                    raise ValueError(f"zernike of the term {term} must be at most {limit:g} rad, got {value:.4g}")

    def _require_values(self, image: Operand, distance: Operand, lens: Mapping[str, Operand]) -> None:
        """Raise ValueError if concrete values are NaN or out of range; traced values are not checked."""
        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        if _batched_operands(lens):
            ones = (1,) * (len(distance.shape) - 1)
            shapes = {n: (-1, *ones) for n in ("focus_distance", "f_number") if lens[n] is not None and lens[n].shape}
            lens = dict(lens) | {name: xp.reshape(lens[name], shape) for name, shape in shapes.items()}
        c, size_ratio = self._focus(distance, lens)
        if not ns.concrete(image) or not ns.concrete(c):
            return
        if not bool(xp.all(xp.isfinite(image))):
            raise ValueError("image must be finite, got NaN or infinity")
        low, high = static.edges[0], static.edges[-1]
        slack = _SLACK * (high - low)
        least, most = (float(ns.to_numpy(ns.stop(end(c)))) for end in (xp.min, xp.max))
        if not (low - slack <= least and most <= high + slack):
            metres = ns.to_numpy(ns.stop(distance))
            if nan_count := int(np.isnan(metres).sum()):
                raise ValueError(f"distance must not be NaN, got NaN at {nan_count} of {metres.size} points")
            optics = static.optics
            vergence = 1.0 / optics.sensor_distance - 1.0 / optics.focal_length
            min_m, max_m = (1.0 / max(end / optics.rad_per_dioptre - vergence, 1e-12) for end in (high, low))
            raise ValueError(
                f"distance must be within the range given to traced_blur, C_d from {low:.4g} to {high:.4g} rad "
                f"({min_m:.4g} to {max_m:.4g} m with the given lens), got C_d from {least:.4g} to {most:.4g} rad "
                f"({metres.min():.4g} to {metres.max():.4g} m)"
            )
        if size_ratio is not None and ns.concrete(size_ratio):
            logs = np.log(ns.to_numpy(ns.stop(size_ratio)).astype(np.float64))
            if not (static.log_ratios[0] - _SLACK <= logs.min() and logs.max() <= static.log_ratios[1] + _SLACK):
                valid = {"focus_distance": static.optics.focus, "f_number": static.optics.stops}
                values = {n: ns.to_numpy(ns.stop(lens[n])) for n in valid if lens[n] is not None}
                listed = (f"{n} within {valid[n]}, got {v.min():.6g} to {v.max():.6g}" for n, v in values.items())
                raise ValueError(f"the blur is valid for {' and '.join(listed)}; clamp parameters to these ranges")

    def _padding(self, c: Operand, axis: int) -> Tensor:
        """Return source indices of an axis mirrored at the edges, by half a window on both sides."""
        xp, count, half = self._static.namespace.xp, c.shape[axis], self._static.half
        # The edge pixel is repeated: the period is 2 count.
        reflected = xp.arange(-half, count + half, **self._static.namespace.beside(c)) % (2 * count)
        indices: Tensor = xp.where(reflected < count, reflected, 2 * count - 1 - reflected)
        return indices

    def _weights(self, c: Operand) -> list[Tensor]:
        """Return the weights of the windows of each layer, shape (rank, points), for C_d (points,)."""
        static = self._static
        ns, xp = static.namespace, static.namespace.xp
        if ns.name != "jax" and c.shape[0] > 2 * _BLOCK_POINTS:  # the polynomials of a block fit into the CPU cache
            blocks = [self._weights(part) for part in _pieces(ns, c, _BLOCK_POINTS)]
            return [xp.concat(list(parts), axis=1) for parts in zip(*blocks, strict=True)]
        layer: Operand = None
        middle, reach = self.tables["middles"][0], self.tables["reaches"][0]
        if len(static.ranks) > 1:
            # The index of the layer is constant within a layer: its derivative is 0.
            layer = xp.searchsorted(self.tables["edges"], ns.stop(c))
            middle, reach = (xp.take(self.tables[name], layer, axis=0) for name in ("middles", "reaches"))
        x = xp.clip((c - middle) / reach, -1.0, 1.0)
        polynomials = _polynomials(ns, x, max(static.degrees))
        by_layer = []
        for k, degrees in enumerate(static.degrees):
            weights = ns.matmul(self.tables[f"weights_{k}"], polynomials[:degrees, ...])
            # Points outside layer k have weight 0.
            by_layer.append(weights if layer is None else xp.where(layer == k, weights, xp.zeros_like(weights)))
        return by_layer

    def _kernels(self, fft_shape: tuple[int, ...], size_ratio: Operand, coefficients: Operand) -> list[Tensor]:
        """Return the spectra of the windows of each layer, shape (rank, channels, rows, columns)."""
        static = self._static
        ns, xp, tables = static.namespace, static.namespace.xp, self.tables
        ends = np.cumsum(static.ranks).tolist()
        parts = [slice(end - rank, end) for end, rank in zip(ends, static.ranks, strict=True)]
        if coefficients is not None:
            assert static.aberrated is not None
            ratio = xp.ones_like(tables["nodes"][0]) if size_ratio is None else size_ratio
            kernels = []
            for part in parts:
                windows = static.aberrated(ns, tables, tables["nodes"][part], coefficients, ratio)
                kernels.append(xp.fft.rfftn(_with_centre_first(ns, windows, static.half, fft_shape), axes=(-2, -1)))
            return kernels
        if size_ratio is None:
            windows = xp.sum(tables["windows"] * tables["given lens"], axis=0)
        else:
            low, high = static.log_ratios
            # Position from -1 to 1 in the range of PSF sizes, on a logarithmic scale.
            x = xp.clip((xp.log(size_ratio) - 0.5 * (low + high)) * (2.0 / (high - low)), -1.0, 1.0)
            basis = _polynomials(ns, xp.reshape(x, (1,)), tables["transform"].shape[0])
            weights = ns.matmul(xp.permute_dims(basis, (1, 0)), tables["transform"])
            windows = xp.sum(tables["windows"] * xp.reshape(weights, (-1, 1, 1, 1)), axis=0)
        # Windows are symmetric: their spectra are real cosine transforms of one quadrant.
        down, across = (_cosines(ns, n, tables, every) for n, every in zip(fft_shape, (True, False), strict=True))
        kernels = []
        for part in parts:
            octants = windows[part, ...]
            quarter = xp.reshape(
                xp.take(octants, tables["cell"], axis=-1), (*octants.shape[:2], *(2 * (static.half + 1,)))
            )
            kernels.append(ns.matmul(ns.matmul(down, quarter), xp.permute_dims(across, (1, 0))))
        return kernels

    def _spectrum(self, image: Operand, c: Operand, fft_shape: tuple[int, ...], kernels: list[Tensor]) -> Tensor:
        """Return the spectrum of the blurred image (..., channels, rows, columns)."""
        ns, xp, shape = self._static.namespace, self._static.namespace.xp, tuple(c.shape)
        total: Operand = 0.0
        batch_axes = (1,) * (len(image.shape) - 3)
        batch = max(1, _CACHED_VALUES // math.prod(image.shape))
        for weights, kernel in zip(self._weights(xp.reshape(c, (-1,))), kernels, strict=True):
            weights = xp.reshape(weights, (-1, *shape[:-2], 1, *shape[-2:]))
            kernel = xp.reshape(kernel, (kernel.shape[0], *batch_axes, *kernel.shape[1:]))
            piece_length = weights.shape[0] if ns.name == "jax" else batch
            pieces = (_pieces(ns, part, piece_length) for part in (weights, kernel))
            for part, spectrum in zip(*pieces, strict=True):
                products = xp.fft.rfftn(part * image, s=fft_shape, axes=(-2, -1)) * spectrum
                total = total + (xp.sum(products, axis=0) if products.shape[0] > 1 else products[0, ...])
        spectrum_of_image: Tensor = total
        return spectrum_of_image

    def _cropped(self, spectrum: Operand, shape: tuple[int, ...], fft_shape: tuple[int, ...]) -> Tensor:
        """Return the image of a spectrum, cropped to `shape`."""
        half, (height, width) = self._static.half, shape[-2:]
        padded = self._static.namespace.xp.fft.irfftn(spectrum, s=fft_shape, axes=(-2, -1))
        image: Tensor = padded[..., half : half + height, half : half + width]
        return image if len(image.shape) == len(shape) else self._static.namespace.xp.reshape(image, shape)

    def _occlusion(
        self, image: Operand, c: Operand, fft_shape: tuple[int, ...], kernels: list[Tensor], shape: tuple[int, ...]
    ) -> Operand:
        """Return (composited layers) - (sum of layers); each layer is blurred by one PSF."""
        static = self._static
        xp, screens = static.namespace.xp, static.screens
        opaque = xp.ones_like(image)
        covered: Operand = 0.0
        composited: Operand = 0.0
        summed: Operand = 0.0
        for k, middle in enumerate(screens):
            # Each point belongs to two adjacent layers, with weights linear in C_d; the nearest layer is first.
            weight: Operand = 1.0
            if k > 0:
                weight = xp.clip((screens[k - 1] - c) / (screens[k - 1] - middle), 0.0, 1.0)
            if k + 1 < len(screens):
                weight = weight * xp.clip((c - screens[k + 1]) / (middle - screens[k + 1]), 0.0, 1.0)
            weight = xp.expand_dims(weight * xp.ones_like(c), axis=-3)
            kernel: Operand = 0.0
            for layer, spectrum in enumerate(kernels):
                mixture = self.tables[f"screens_{layer}"][k, ...]
                kernel = kernel + xp.sum(spectrum * xp.reshape(mixture, (-1, 1, 1, 1)), axis=0)
            light, coverage = (
                self._cropped(xp.fft.rfftn(weight * source, s=fft_shape, axes=(-2, -1)) * kernel, shape, fft_shape)
                for source in (image, opaque)
            )
            coverage = xp.clip(coverage, 0.0, 1.0)
            # Nearer layers occlude: the visible coverages of all layers add up to at most 1.
            visible_coverage = coverage if k == 0 else xp.minimum(coverage, 1.0 - covered)
            composited, summed = composited + light * (visible_coverage / (coverage + _MIN_COVERAGE)), summed + light
            covered = covered + visible_coverage
        # Division by the total coverage preserves the brightness of surfaces that are not occluded.
        return composited / (covered + _MIN_COVERAGE) - summed

    def __repr__(self) -> str:
        static = self._static
        return (
            f"<TracedBlur in {static.namespace.name}: {static.channels} channel(s), {self.rank} windows of "
            f"{2 * static.half + 1} x {2 * static.half + 1} in {len(static.ranks)} layer(s)>"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        ns = self._static.namespace
        return _blur_on_device, (self._static, {name: ns.to_numpy(table) for name, table in self.tables.items()})


def _batched_operands(lens: Mapping[str, Operand]) -> list[str]:
    """Return the names of the lens parameters that have separate values for each image of a batch."""
    batched_axes = {"focus_distance": (1,), "f_number": (1,), "zernike": (2, 4)}
    return [name for name, axes in batched_axes.items() if lens[name] is not None and len(lens[name].shape) in axes]


def _pieces(ns: Namespace, x: Operand, length: int) -> list[Operand]:
    """Return parts of `x` of at most `length` along the first axis."""
    if ns.name == "torch":  # each derivative of a slice would be as large as x
        return list(x.split(length, dim=0))
    count = x.shape[0]
    return [x[k : min(k + length, count), ...] for k in range(0, count, length)]


def _polynomials(ns: Namespace, x: Operand, count: int) -> Operand:
    """Return the Chebyshev polynomials of degrees below `count` at x (n,), shape (count, n)."""
    # T_(m+j) = 2 T_m T_j - T_(m-j): each iteration appends m polynomials to m + 1 polynomials.
    xp = ns.xp
    polynomials: Operand = xp.stack([xp.ones_like(x), x], axis=0)
    while polynomials.shape[0] < count:
        m = polynomials.shape[0] - 1
        higher = 2.0 * polynomials[m : m + 1, ...] * polynomials[1:, ...] - xp.flip(polynomials[:m, ...], axis=0)
        polynomials = xp.concat([polynomials, higher], axis=0)
    return polynomials[:count, ...]


def _cosines(ns: Namespace, side: int, tables: Tables, every: bool) -> Operand:
    """Return the matrix from half a symmetric row to its spectrum, at `every` frequency or at those of rfft only."""
    xp, at = ns.xp, tables["at"]
    frequency = xp.arange(side if every else side // 2 + 1, **ns.beside(at))
    # Integer arithmetic reduces the phase by whole turns without the rounding of float32.
    phase = (xp.reshape(frequency, (-1, 1)) * at) % side  # type: ignore[operator]
    return xp.cos(xp.astype(phase, tables["once"].dtype) * (math.tau / side)) * tables["once"]


def _with_centre_first(ns: Namespace, windows: Operand, half: int, fft_shape: tuple[int, ...]) -> Operand:
    """Return windows (..., side, side) padded to `fft_shape`, with the centre moved to the first element."""
    xp = ns.xp
    for axis, length in ((-2, fft_shape[0]), (-1, fft_shape[1])):
        rest = (slice(None),) * (-axis - 1)
        shape = list(windows.shape)
        shape[axis] = length - (2 * half + 1)
        zeros = xp.zeros(tuple(shape), dtype=windows.dtype, **ns.beside(windows))
        right, left = (windows[(..., part, *rest)] for part in (slice(half, None), slice(0, half)))
        windows = xp.concat([right, zeros, left], axis=axis)
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
    device: object = None,
    precision: str = "float32",
) -> TracedBlur:
    r"""Return the blur of a lens as a differentiable function of an image, its depth and the lens.

    The range of C_d is divided into layers. Within a layer, each pixel-integrated PSF is a weighted sum of a few PSFs
    (windows), with polynomials of C_d as weights; the blur is then a few convolutions per layer. All windows have
    equal sides, hold at least 98 % of the light of their PSF, and are divided by their sums: truncation does not
    contribute to derivatives by depth. The tolerance of each pixel of a PSF is 1e-4 of its peak, at any defocus in
    the valid range. See docs/certificate.md.

    Parameters
    ----------
    lens : Lens
        Paraxial lens with a circular or annular aperture and radially symmetric aberrations.
    distances : array_like
        Object distances, metres; the smallest and the largest define the valid range.
    pixel : float
        Pixel pitch, metres.
    xp, device
        See :meth:`lommel.Plan.traced`.
    wavelengths : Channels or sequence, optional
        :class:`lommel.Channels`, or for each channel a wavelength (metres) or a sequence of (wavelength, weight), for
        example ``lommel.imaging.RED_GREEN_BLUE``. By default one channel, at the wavelength of the lens.
    focus_distances, f_numbers : (float, float), optional
        Valid ranges of the arguments `focus_distance` (metres) and `f_number` of the blur; without a range the
        argument is fixed. `f_numbers` needs a lens without aberrations, obscuration and apodization.
    defocus : float, default 0
        Largest magnitude of the argument `defocus` of the blur, radians.
    zernike : mapping of (n, m) to float, optional
        Terms of the argument `zernike` of the blur, each with the largest magnitude of its coefficient: radians at
        the edge of the pupil and the wavelength of the lens. Each call with `zernike` recomputes the windows.
    precision : {"float32", "float64"}, default "float32"
        Precision of the tables and of the computation.

    Returns
    -------
    TracedBlur

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, or windows would be wider than 513 pixels.

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
    ns = _namespace(xp, device, precision)
    colours = spectra("wavelengths", [lens.wavelength] if wavelengths is None else wavelengths)
    optics = _optics(lens, focus_distances, f_numbers, defocus, zernike)
    low, high, log_ratios = _ranges(lens, optics, distances)
    # The largest PSF determines the half width of all windows.
    lights = [SensorLight.of(lens, colour, pitch) for colour in colours]
    widest = [replace(light, pixel=pitch / math.exp(log_ratios[1])) for light in lights]
    half = max(light.sufficient_half((low, high), _ENERGY, _MAX_HALF)[0] for light in widest)
    exact = _ExactWindows(lights, half)
    logs = chebyshev_nodes(3)[0] if log_ratios[1] > log_ratios[0] else np.zeros(1)
    logs = 0.5 * (log_ratios[0] + log_ratios[1]) + 0.5 * (log_ratios[1] - log_ratios[0]) * logs
    step = math.pi * pitch / (lens.wavelength * lens.working_f_number)
    aberrated: AberratedWindows | None = None
    zernike_tables: dict[str, Operand] = {}
    if optics.zernike:
        window = half, step / math.exp(log_ratios[0])
        aberrated, zernike_tables = traced_windows.build_windows(
            lens, dict(optics.zernike), (low, high), colours, window, _TOL
        )
        zernike_tables["lattice"] = zernike_tables["lattice"] * math.exp(log_ratios[0])
    numpy, draw = Namespace.of(None), np.random.default_rng(0)

    def aberrated_windows(c: Array, coefficients: Array) -> Array:
        assert aberrated is not None
        size_ratio = np.float64(1.0)
        exact_windows = numpy.to_numpy(aberrated(numpy, zernike_tables, c, coefficients, size_ratio))
        return np.reshape(exact_windows, (len(c), len(colours), -1))

    limits = np.array([limit for _, limit in optics.zernike])
    # Layers are fitted for two random sets of coefficients: a corner of their range, and 0.6 of another corner.
    samples = [limits * draw.choice([-1.0, 1.0], limits.size) * part for part in (1.0, 0.6)] if limits.size else []

    def all_windows(c: Array) -> Array:
        unaberrated = np.concatenate([exact(c, float(log)) for log in logs], axis=1)
        return _side_by_side(unaberrated, [aberrated_windows(c, sample) for sample in samples])

    values = exact.cells * len(colours) * len(logs)
    rate = lens.wavelength / min(wavelength for colour in colours for wavelength, _ in colour)
    layers = defocus_layers(all_windows, low, high, _TOL, _LAYER_WIDTH, rate, max(1, _MAX_VALUES // values))
    nodes = np.concatenate([layer.nodes for layer in layers])
    given_windows = np.concatenate([layer.windows[:, : len(colours), : exact.cells] for layer in layers])
    windows_by_size, transform = _windows_by_size(exact, nodes, given_windows, log_ratios, _TOL)
    # Position of the given lens, whose log_ratio is 0, in the range of PSF sizes.
    at_given_lens = np.array([-sum(log_ratios) / max(log_ratios[1] - log_ratios[0], 1e-300)])
    # Per radian of C_d the marginal ray moves by 4 in the optical coordinate v; a pixel is `step` wide in v.
    screens = np.linspace(high, low, int(np.clip(math.ceil((high - low) * 4.0 / step), 2, _MAX_SCREENS)))
    tables: dict[str, Values] = {
        "windows": windows_by_size,
        "transform": transform,
        "given lens": (chebyshev(at_given_lens, len(transform)) @ transform).reshape(-1, 1, 1, 1),
        "nodes": nodes,
        "at": np.arange(half + 1, dtype=np.int32),
        "once": np.where(np.arange(half + 1) == 0, 1.0, 2.0),
        "cell": cells_of_quarter(half).astype(np.int32).ravel(),
        **_layer_tables(layers, screens),
        **zernike_tables,
    }
    edges = (layers[0].low, *(layer.high for layer in layers))
    ranks, degrees = (tuple(layer.weights.shape[axis] for layer in layers) for axis in (0, 1))
    static = Blur(
        namespace=ns, optics=optics, channels=len(colours), half=half, edges=edges, ranks=ranks,
        degrees=degrees, log_ratios=log_ratios, screens=tuple(screens.tolist()), aberrated=aberrated, error=0.0,
        precision=precision,
    )  # fmt: skip
    static = static._replace(
        error=_measured_error(TracedBlur(static._replace(namespace=numpy), dict(tables)), exact, draw)
    )
    return _blur_on_device(static, tables, device)


def _namespace(xp: object, device: object, precision: str) -> Namespace:
    """Return the namespace of a framework; ValueError if the framework lacks the precision."""
    ns = Namespace.of(xp)
    validation.choice("precision", precision, ("float32", "float64"))
    if precision == "float64" and not ns.has_double(device):
        raise ValueError(f'precision must be "float32" here: float64 is not available or not enabled in {ns.name}')
    return ns


def _side_by_side(windows: Array, others: list[Array]) -> Array:
    """Concatenate windows (n, parts, cells) and `others` along axis 1, with `windows` padded by zeros."""
    if not others:
        return windows
    combined = np.concatenate(others, axis=1)
    padded = np.zeros((*windows.shape[:2], combined.shape[2]))
    padded[..., : windows.shape[2]] = windows
    return np.concatenate([padded, combined], axis=1)


def _layer_tables(layers: Sequence[DefocusLayer], screens: Array) -> dict[str, Values]:
    """Return the tables of defocus layers by name, with the weights of windows at the C_d of occlusion layers."""
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


class _ExactWindows:
    """Windows of each channel computed without interpolation, of sum 1."""

    def __init__(self, lights: list[SensorLight], half: int) -> None:
        self._lights, self._half, self._multiplicity = lights, half, cells_alike(half)
        self.cells = self._multiplicity.size

    def __call__(self, c: Array, log_ratio: float) -> Array:
        """Return windows (n, channels, cells) at C_d `c`, for PSFs enlarged by exp(log_ratio)."""
        by_channel = []
        for light in self._lights:
            # Enlarging the PSF is equivalent to reducing the pixel pitch.
            scaled = light if log_ratio == 0.0 else replace(light, pixel=light.pixel / math.exp(log_ratio))
            light_in_cells = scaled.shares(scaled.defocused(c), self._half)
            by_channel.append(light_in_cells / (light_in_cells @ self._multiplicity)[:, None])
        return np.stack(by_channel, axis=1)


def _optics(
    lens: Lens,
    focus: tuple[float, float] | None,
    stops: tuple[float, float] | None,
    defocus: float,
    terms: Mapping[Term, float] | None,
) -> Optics:
    """Return the optics of a lens; TypeError or ValueError for invalid arguments."""
    # C_d = pi a^2 / (2 lambda) times the vergence error (1/m), a being the aperture radius.
    rad_per_dioptre = math.pi / (2.0 * lens.wavelength) * (0.5 * lens.aperture_diameter) ** 2
    if focus is not None:
        focus = _pair("focus_distances", focus, lens.focal_length)
    if stops is not None:
        stops = _pair("f_numbers", stops, 0.0)
        if not lens.aberrations.flat or lens.obscuration or not lens.illumination.uniform:
            raise ValueError("f_numbers need a lens without aberrations, obscuration and apodization")
    limits: list[tuple[Term, float]] = []
    if not isinstance(terms, Mapping | None):
        raise TypeError(f"zernike must map terms (n, m) to maximum coefficients, got {validation.shown(terms)}")
    for term, limit in (terms or {}).items():
        try:
            n, m = int(term[0]), int(term[1])
        except (TypeError, ValueError, IndexError):
            raise TypeError(f"a Zernike term must be a pair (n, m), got {validation.shown(term)}") from None
        if not (0 < n <= 20 and abs(m) <= n and (n - m) % 2 == 0):
            raise ValueError(f"a Zernike term must have 0 < n <= 20, |m| <= n and n - m even, got {(n, m)}")
        limits.append(((n, m), validation.real(f"zernike of {(n, m)}", limit, above=0.0, most=100.0)))
    # Chromatic aberrations do not scale as 1 / wavelength, unlike the `zernike` terms.
    if limits and lens.colour is not None:
        raise ValueError("zernike needs a lens without chromatic aberration; leave out `colour` of the lens")
    limit = validation.real("defocus", defocus, least=0.0)
    ranges = focus, stops, limit, tuple(limits)
    return Optics(lens.focal_length, lens.sensor_distance, lens.f_number, rad_per_dioptre, *ranges)


def _real_values(name: str, values: object) -> Values:
    """Return numbers or nested sequences as a NumPy array; TypeError unless real, ValueError unless in range."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} must hold real numbers, got {validation.shown(values)}")
    if name in ("focus_distance", "f_number") and not (array > 0.0).all():
        raise ValueError(f"{name} must be above 0, got {validation.shown(values)}")
    return array


def _pair(name: str, values: ArrayLike, least: float) -> tuple[float, float]:
    ends = np.sort(validation.real_array(name, values).ravel())
    if ends.size != 2 or not least < ends[0] < ends[1]:
        raise ValueError(f"{name} must be two different numbers above {least:g}, got {validation.shown(values)}")
    return float(ends[0]), float(ends[1])


def _ranges(lens: Lens, optics: Optics, distances: ArrayLike) -> tuple[float, float, tuple[float, float]]:
    """Return the limits of C_d (rad), and the range of log((PSF size) / (PSF size of the given lens))."""
    lens.defocus(distances)  # raises if distances are invalid
    metres = np.asarray(distances, dtype=np.float64)
    c, logs = [], [0.0]
    for focus in optics.focus or (None,):
        for stop in optics.stops or (None,):
            vergence, rad_per_dioptre, size_ratio = optics.at(focus, stop)
            c += [rad_per_dioptre * (vergence + 1.0 / distance) for distance in (metres.min(), metres.max())]
            logs.append(0.0 if size_ratio is None else math.log(size_ratio))
    c += [float(value) for value in lens.defocus([metres.min(), metres.max()])]
    low, high = min(c) - optics.defocus, max(c) + optics.defocus
    # A narrow range is widened to avoid division by a number near 0.
    low, high = (low, high) if high - low > 0.2 else (low - 0.1, high + 0.1)
    return low, high, (min(logs), max(logs))


def _windows_by_size(
    exact: _ExactWindows, nodes: Array, given_windows: Array, log_ratios: tuple[float, float], tol: float
) -> tuple[Array, Array]:
    """Return windows at several PSF sizes, and the matrix from windows to Chebyshev coefficients.

    Raise ValueError if the largest number of PSF sizes is not enough for `tol`.
    """
    low, high = log_ratios
    if high == low:
        return given_windows[None], np.ones((1, 1))
    # Interpolation is tested at both ends of the defocus range, where PSFs are largest, and at the sharpest node.
    test_nodes = np.unique([nodes.min(), nodes.max(), nodes[np.abs(nodes).argmin()]])
    for count in _WINDOW_SETS:
        x, transform = chebyshev_nodes(count)
        logs = 0.5 * (low + high) + 0.5 * (high - low) * x
        at_nodes = np.stack([exact(test_nodes, float(log)) for log in logs])
        # Half-way between adjacent nodes, where interpolation errors are largest.
        between = np.array([-0.97, 0.5 * (x[0] + x[1]), 0.5 * (x[count // 2] + x[count // 2 - 1])])
        computed = np.stack([exact(test_nodes, 0.5 * (low + high) + 0.5 * (high - low) * float(b)) for b in between])
        interpolated = np.tensordot(chebyshev(between, count) @ transform, at_nodes, 1)
        if (np.abs(interpolated - computed).max(axis=-1) / computed.max(axis=-1)).max() <= 0.3 * tol:
            return np.stack([exact(nodes, float(log)) for log in logs]), transform
    raise ValueError(
        f"focus_distances and f_numbers change the size of PSFs by a factor of {math.exp(high - low):.4g}, which "
        f"needs more than {_WINDOW_SETS[-1]} sets of windows; choose narrower ranges, or a larger tol"
    )


def _measured_error(blur: TracedBlur, exact: _ExactWindows, draw: np.random.Generator) -> float:
    """Return the largest error of interpolated windows at 12 random C_d, relative to their peaks."""
    edges, tables = np.array(blur._static.edges), blur.tables
    c = np.sort(draw.uniform(edges[0], edges[-1], 12))
    windows = np.asarray(tables["windows"] * tables["given lens"]).sum(axis=0)
    weights = np.concatenate([np.asarray(part) for part in blur._weights(c)])
    exact_windows = exact(c, 0.0)
    error = np.tensordot(weights.T, windows, 1) - exact_windows
    return float((np.abs(error).max(axis=-1) / exact_windows.max(axis=-1)).max())


def _blur_on_device(static: Blur, tables: Mapping[str, Values], device: object = None) -> TracedBlur:
    """Return a blur with its tables moved from NumPy to a device, in the precision of the blur."""
    ns = static.namespace
    dtype = getattr(ns.xp, static.precision)
    if ns.name == "jax":
        _jitted_blur()
    return TracedBlur(
        static,
        {name: ns.put(table, device, dtype if table.dtype.kind == "f" else None) for name, table in tables.items()},
    )


@cache
def _jitted_blur() -> Any:
    """Register TracedBlur as a pytree with JAX, and return the compiled blur."""
    import jax

    jax.tree_util.register_pytree_node(
        TracedBlur,
        lambda blur: ((blur.tables,), blur._static),
        lambda static, parts: TracedBlur(static, *parts),
    )

    def call(blur: TracedBlur, image: Tensor, distance: Tensor, lens: dict[str, Tensor], occlusion: bool) -> Tensor:
        return blur._by_lens(image, distance, lens, occlusion=occlusion)

    return jax.jit(call, static_argnums=4)


@cache
def _module_class() -> Any:
    torch = library("torch", "modules need", "torch")

    class BlurModule(torch.nn.Module):  # type: ignore[misc,name-defined]
        """Blur as a PyTorch module."""

        def __init__(self, blur: TracedBlur, learned: dict[str, Array]) -> None:
            super().__init__()
            self._static = blur._static
            self._names = tuple(blur.tables)
            for k, name in enumerate(self._names):
                self.register_buffer(f"table_{k}", blur.tables[name], persistent=False)
            table: Any = blur.tables["middles"]
            for name, value in learned.items():
                start = torch.as_tensor(value, dtype=table.dtype, device=table.device)
                self.register_parameter(name, torch.nn.Parameter(start))

        def blur(self) -> TracedBlur:
            """Return the blur with the tables on their current device."""
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
    """Return a blur as a PyTorch module whose parameters have the initial values `learned`."""
    return _module_class()(blur, learned)
