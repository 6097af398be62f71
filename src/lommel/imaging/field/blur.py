"""Blur that varies over the field, and with depth: every point spreads the PSF of its own place and distance."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.options import shares
from lommel.field.maps import FieldMap, require_light
from lommel.field.psf_grid import sides
from lommel.imaging.blur import require_depth, require_lens
from lommel.imaging.field.bank import FieldBank, build_field_bank
from lommel.imaging.field.light import PointLight
from lommel.imaging.field.part import Part
from lommel.imaging.linear import LinearBlur
from lommel.imaging.settings import Settings, Spectrum, spectra
from lommel.optics.lens import Lens


class FieldKeywords(TypedDict, total=False):
    """What a blur over the field shares with other blur."""

    border: str
    energy: float
    largest: int | None
    dtype: DTypeLike
    threads: int | None


@shares(FieldKeywords, Settings)
class FieldBlur(LinearBlur):
    """What a lens makes of points that have a PSF each: ``out[q] = sum_p image[p] K_p(q - p)``.

    K_p is the PSF of the source point p, averaged over the pixels: that of its place in the field, and of its
    distance where a depth is given. It is cut to a window that holds `energy` of its light, of one size for all
    points, and divided by what the window holds. Between nodes over the field (and over defocus) it is interpolated
    by cubic splines; the nodes are chosen so that K_p errs by less than `tol`. With ``energy=1`` it is the whole PSF:
    beyond the windows, which then are as large as it takes, that is for each point its share of one far light.

    Parameters
    ----------
    field_map : FieldMap
        Its wavefronts over the field.
    shape : int or (int, int)
        Height and width of the image, pixels.
    pixel : float
        Pixel pitch, in the unit of the map (metres if it has a wavelength).
    depth : array_like, shape (height, width), optional
        Distance of each point from the lens, metres, positive; may be infinite. The defocus that `lens` has for it is
        added to the wavefront of the map.
    lens : Lens
        With `depth`, and only with it. Of the wavelength, f-number and aperture of the map, and without aberrations
        of its own.
    center : (float, float), optional
        Row and column of the optical axis, in pixels, 0 being the middle of the first; by default the middle of the
        image. It may lie outside of the image, which then is a crop.
    sensor : (float, float), optional
        Height and width of the part of the field that the image shows, in the unit of the map; by default
        ``shape * pixel``. With a larger one PSFs are drawn too large for their places, as for pictures of what a lens
        does over all of its field.
    channels : sequence, default (wavelength of the map,)
        For each channel a wavelength (metres), or its spectrum, pairs of wavelength and weight.
    tol : float, default 1e-3
        Bound on the sum of absolute differences between K_p and the exact window, which each have the sum 1; 1e-6
        to 1e-1. Checked half-way between nodes.
    {options}

    Attributes
    ----------
    banks : tuple of FieldBank
        One a channel.
    error : float
        Largest sum of absolute differences found between interpolated windows and exact ones, of any channel.
    lost : float
        Largest share of light beyond the windows that was found. Against the whole PSF a window differs by no more
        than ``error + 2 * lost``, by the sum of absolute differences.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if the image goes beyond the map; if the blur exceeds `largest`, or takes more
        than 2^27 values.

    Notes
    -----
    A source spreads its light by its own PSF (scatter), which is what lenses do; that each pixel of the image be a
    mean of others by its own PSF (gather) is the transpose. The light of each source is kept, wherever it is: where a
    lens is darker towards the corners, multiply the image by its relative illumination first.

    Beyond the edges, a copy of a point ("reflect", "extend") spreads the PSF of the point that it copies.

    Examples
    --------
    >>> field = lm.FieldMap.from_seidel(6e-3, W131=1.5, W222=1.0, wavelength=550e-9, f_number=4.0)
    >>> blur = lm.imaging.FieldBlur(field, (60, 80), 2e-6, center=(2000.0, -1500.0))
    >>> star = np.zeros((60, 80))
    >>> star[30, 40] = 1.0
    >>> blur.forward(star).shape
    (60, 80)
    """

    def __init__(
        self,
        field_map: FieldMap,
        shape: int | tuple[int, int],
        pixel: float,
        *,
        depth: ArrayLike | None = None,
        lens: Lens | None = None,
        center: tuple[float, float] | None = None,
        sensor: tuple[float, float] | None = None,
        channels: Sequence[Spectrum] | None = None,
        tol: float = 1e-3,
        **options: Unpack[FieldKeywords],
    ) -> None:
        validation.instance("field_map", field_map, FieldMap)
        light = field_map.pupil_without_wavefront
        metric = light.wavelength is not None
        self.field_map, self._shape = field_map, validation.image_shape(shape)
        self.pixel = validation.pixel(pixel, metric=metric)
        validation.pixel_on(self.pixel, light.scale, metric=metric)
        validation.real("tol", tol, least=1e-6, below=0.1 + 1e-12)
        whole = isinstance(options.get("energy"), int | float) and options["energy"] == 1.0
        settings = Settings.of(FieldBlur, {**options, "energy": 0.98} if whole else options, FieldKeywords)
        self.border, self.dtype = settings.border, np.dtype(settings.dtype)
        self.threads = settings.threads or os.cpu_count() or 1
        self.y, self.x = self._places(center, sensor)
        self.lens, self.defocus = self._focus(depth, lens)
        spans = [(float(along[0]), float(along[-1])) for along in (self.y, self.x)]
        spans.append((0.0, 0.0) if self.defocus is None else (float(self.defocus.min()), float(self.defocus.max())))
        if channels is not None and not metric:
            raise ValueError("channels need a map with a wavelength, to which theirs are related")
        colours = (None,) if channels is None else spectra("channels", channels)
        known: dict[Any, tuple[FieldBank, tuple[Part, ...]]] = {}
        for spectrum in colours:
            if spectrum not in known:
                bank = build_field_bank(
                    PointLight(
                        field_map,
                        None if self.lens is None else self.lens.phase,
                        spectrum,
                        self.pixel,
                        min(1e-6, max(1e-10, 1e-3 * tol)),
                        settings.threads,
                    ),
                    spans,
                    tol=tol,
                    energy=1.0 if whole else settings.energy,
                    largest=settings.largest or max(1, min(self.shape) // 2),
                    farthest=max(self.shape),
                    dtype=self.dtype,
                )
                known[spectrum] = bank, self._made(bank)
        self.banks = tuple(known[spectrum][0] for spectrum in colours)
        self._parts = tuple(known[spectrum][1] for spectrum in colours)

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width of the images."""
        return self._shape

    @property
    def channels(self) -> int:
        """How many channels an image has; one of a single channel may lack their axis."""
        return len(self.banks)

    @property
    def error(self) -> float:
        """Largest sum of absolute differences found between interpolated windows and exact ones."""
        return max(bank.error for bank in self.banks)

    @property
    def lost(self) -> float:
        """Largest share of light beyond the windows that was found."""
        return max(bank.lost for bank in self.banks)

    def window(self, row: int, column: int, channel: int = 0) -> NDArray[np.float64]:
        """Return what one point of the image spreads, the point in the middle.

        Parameters
        ----------
        row, column : int
            The point.
        channel : int, default 0

        Returns
        -------
        ndarray, shape (side, side)
            Of the sum 1.

        Raises
        ------
        TypeError, ValueError
            If there is no such point or channel.
        """
        height, width = self.shape
        row = validation.integer("row", row, least=0, most=height - 1)
        column = validation.integer("column", column, least=0, most=width - 1)
        bank = self.banks[validation.integer("channel", channel, least=0, most=self.channels - 1)]
        defocus = 0.0 if self.defocus is None else float(self.defocus[row, column])
        return bank.window(float(self.y[row]), float(self.x[column]), defocus)

    def forward(self, image: NDArray[Any]) -> NDArray[Any]:
        """Return the image that the lens makes of linear light, shape (height, width) or (height, width, channels).

        Parameters
        ----------
        image : ndarray of float
            Light; the last axis holds the channels if there are several.

        Returns
        -------
        ndarray
            Of the shape of `image`, and of the type of the sums.

        Raises
        ------
        TypeError, ValueError
            If `image` is not finite light of the shape of the operator.
        """

        def spread(channel: int, plane: NDArray[Any]) -> NDArray[Any]:
            first, *more = (part.spread(plane) for part in self._parts[channel])
            return sum(more, first)

        return self.by_channel(image, spread)

    def adjoint(self, image: NDArray[Any]) -> NDArray[Any]:
        """Return the transpose of :meth:`forward` applied to an image: ``<forward(a), b> = <a, adjoint(b)>``.

        Parameters
        ----------
        image : ndarray of float
            Of the shape that :meth:`forward` takes.

        Returns
        -------
        ndarray
            Of the shape of `image`.

        Raises
        ------
        TypeError, ValueError
            As :meth:`forward`.
        """

        def collect(channel: int, plane: NDArray[Any]) -> NDArray[Any]:
            first, *more = (part.collect(plane) for part in self._parts[channel])
            return sum(more, first)

        return self.by_channel(image, collect)

    def _places(self, center: tuple[float, float] | None, sensor: tuple[float, float] | None) -> tuple[Array, Array]:
        """Return y of the rows and x of the columns in the field."""
        unit = self.field_map.unit
        axis = [0.5 * (side - 1) for side in self.shape] if center is None else validation.position("center", center)
        pitch = [self.pixel] * 2
        if sensor is not None:
            pitch = [length / side for length, side in zip(sides(sensor, unit), self.shape, strict=True)]
        y, x = (
            np.asarray(step * (np.arange(n) - at), dtype=np.float64)
            for step, n, at in zip(pitch, self.shape, axis, strict=True)
        )
        try:
            self.field_map.pupil(x[[0, -1]], y[[0, -1], None])
        except ValueError as told:
            height, width = self.shape
            raise ValueError(
                f"{told}: as far goes the image, {height} x {width} pixels with y from {y[0]:.4g} to {y[-1]:.4g} and "
                f"x from {x[0]:.4g} to {x[-1]:.4g} {unit}; take a smaller shape, another center= (row and column of "
                "the axis), or a map of more of the field"
            ) from None
        return y, x

    def _focus(self, depth: ArrayLike | None, lens: Lens | None) -> tuple[Lens | None, Array | None]:
        """Return the lens and the defocus of each point."""
        if (depth is None) != (lens is None):
            missing = "lens" if lens is None else "depth"
            raise ValueError(f"{missing} is missing: they go together, for the lens has the defocus of each distance")
        if lens is None or depth is None:
            return None, None
        require_lens(lens, "field_map, shape, pixel, and depth= and lens=")
        distances = require_depth(depth)
        if distances.shape != self.shape:
            raise ValueError(f"depth must have the shape of the image, {self.shape}, got {distances.shape}")
        require_light(self.field_map.pupil_without_wavefront, lens)
        defocus = lens.defocus(distances)
        defocus.flags.writeable = False
        return lens, defocus

    def _made(self, bank: FieldBank) -> tuple[Part, ...]:
        """Return what a channel is made of: what windows hold, and what is beyond them."""
        down, across, focus = bank.axes
        near = Part(
            bank.coefficients,
            (down.weights(self.y), across.weights(self.x)),
            border=self.border,
            threads=self.threads,
            focus=focus,
            defocus=self.defocus,
        )
        if bank.far is None:
            return (near,)
        held = np.asarray(bank.coefficients, dtype=np.float64).sum(axis=(-2, -1))
        inside = [down.weights(self.y) @ plane @ across.weights(self.x).T for plane in np.moveaxis(held, 2, 0)]
        places = [(0, np.ones(()))] if self.defocus is None else focus.shares(self.defocus)
        beyond = 1.0 - sum(share * inside[place] for place, share in places)
        far = Part(
            bank.far.kernel.astype(self.dtype)[None, None, None],
            (np.ones((len(self.y), 1)), np.ones((len(self.x), 1))),
            border=self.border,
            threads=self.threads,
            share=np.asarray(beyond, dtype=self.dtype),
        )
        return near, far
