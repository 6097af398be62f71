"""Blur that varies with depth, as a linear operator: every point spreads the PSF of its own distance."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.arrays import Array
from lommel.base.options import shares
from lommel.base.threads import side_by_side
from lommel.core import engine
from lommel.imaging.bank import Bank, build_bank
from lommel.imaging.beyond_windows import Beyond
from lommel.imaging.borders import folded, gathered
from lommel.imaging.linear import LinearBlur
from lommel.imaging.sensor_light import SensorLight
from lommel.imaging.settings import BlurKeywords, Settings, Spectrum, spectra
from lommel.optics.lens import Lens

_BAND = 2**17  # points that are spread in one go where somebody watches


class Points(NamedTuple):
    """Points of one channel that spread light.

    Attributes
    ----------
    positions : ndarray, shape (height, width)
        Where each is in the bank, below 0 for those that spread nothing.
    layers : ndarray, shape (height, width), optional
        Number of the layer that each is in, from the front; of the type of the sums.
    """

    positions: NDArray[np.float64]
    layers: NDArray[Any] | None = None


@shares(BlurKeywords, Settings)
class DepthBlur(LinearBlur):
    r"""What a lens makes of a scene, for one focus: ``out[q] = sum_p image[p] K(q - p; C_d(depth[p]))``.

    K is the PSF averaged over the pixels, at the defocus of each source point, cut to a window that holds `energy` of
    its light and divided by what the window holds, so that light is conserved; or, with ``energy=1``, the whole of
    it, a window and a smooth remainder without end. Between the windows of a bank it is interpolated by cubics.
    Points do not hide one another: for that see :func:`lommel.imaging.depth_of_field`.

    Parameters
    ----------
    depth : array_like, shape (height, width)
        Distance of each point from the lens, metres, positive; may be infinite.
    lens : Lens
        Its aberrations must be radially symmetric.
    pixel : float
        Pixel pitch, metres.
    channels : sequence, default (lens.wavelength,)
        For each channel a wavelength (metres), or its spectrum, pairs of wavelength and weight.
    {options}

    Attributes
    ----------
    banks : tuple of Bank
        One a channel.
    spectra : tuple
        Of each channel pairs of a wavelength (metres) and a weight.
    lost : float
        Largest share of light beyond the windows, of any point and channel; 0 for the whole PSF.
    error : float
        Largest error of interpolated windows over their peak that was found. For the whole PSF the sum over pixels of
        the most that K is off there, at the distances of the scene: no pixel is off by more than this times the
        brightest point. A warning says where that is more than twice `tol`.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if the blur exceeds `largest`.
    """

    watch: Callable[[int], object] | None = None
    """Called with a number of points each time that so many have been spread, if it is set; see `_bands`."""

    # Where the points are in the banks, of the defocus and for the banks that come first.
    _placed: tuple[NDArray[np.float64], tuple[Bank, ...], tuple[NDArray[np.float64], ...]] | None = None

    def __init__(
        self,
        depth: ArrayLike,
        lens: Lens,
        pixel: float,
        *,
        channels: Sequence[Spectrum] | None = None,
        **options: Unpack[BlurKeywords],
    ) -> None:
        require_lens(lens, "depth, lens, pixel")
        if not lens.aberrations.radial or lens.aberrations.shape != ():
            raise ValueError("lens must have radially symmetric aberrations, and one set of them")
        if lens.spider or lens.vignetting or lens.mask:
            raise ValueError(
                "lens must have a round aperture for photographs, without spider, vignetting and mask: leave these "
                "out, or ask lommel.psf for the image of single points"
            )
        self.lens = lens
        self.pixel = validation.pixel(pixel, metric=True)
        validation.pixel_on(self.pixel, lens.wavelength * lens.working_f_number, metric=True)
        settings = Settings.of(DepthBlur, options, BlurKeywords)
        self.border, self.energy = settings.border, settings.energy
        self.dtype, self.threads = np.dtype(settings.dtype), settings.threads or 0
        self.place(depth)
        reach = (float(self.defocus.min()), float(self.defocus.max()))
        self.spectra = spectra("channels", [lens.wavelength] if channels is None else channels)

        def bank(spectrum: tuple[tuple[float, float], ...]) -> Bank:
            return build_bank(
                SensorLight.of(lens, spectrum, self.pixel, self.threads),
                reach,
                tol=settings.tol,
                energy=settings.energy,
                largest=settings.largest or max(1, min(self.shape) // 2),
                dtype=self.dtype,
            )

        distinct = tuple(dict.fromkeys(self.spectra))
        known = dict(zip(distinct, side_by_side(bank, distinct, self.threads), strict=True))
        self.banks = tuple(known[spectrum] for spectrum in self.spectra)
        self.beyond = Beyond(self.banks, settings.tol) if settings.energy == 1.0 else None
        if self.beyond is not None and (error := self.error) > 2.0 * settings.tol:
            rounding = "for dtype=float64, " if 2.0 * self.beyond.rounding(self.dtype) > error else ""
            warnings.warn(
                f"with energy=1 a pixel may be off by {error:.2g} of the brightest point, more than "
                f"tol={settings.tol:g}; ask {rounding}for a tol of that size, or for energy=0.9999, whose windows "
                "err by less than tol",
                stacklevel=3,
            )

    def place(self, depth: ArrayLike) -> None:
        """Put the points at other depths, within the range of those given first.

        Parameters
        ----------
        depth : array_like, shape (height, width)
            Metres.

        Raises
        ------
        TypeError, ValueError
            If a distance is not a number above 0.
        """
        distances = require_depth(depth)
        self.defocus = self.lens.defocus(distances)
        self.defocus.flags.writeable = False

    @property
    def lost(self) -> float:
        """Largest share of light beyond the windows, of any point and channel."""
        return max(bank.lost for bank in self.banks)

    @property
    def error(self) -> float:
        """Largest error of interpolated windows over their peak; or what the whole K is off, summed over pixels."""
        return max(bank.error for bank in self.banks) if self.beyond is None else self.beyond.error(self)

    def forward(self, image: NDArray[Any], weight: NDArray[Any] | None = None) -> NDArray[Any]:
        """Return the image that the lens makes of linear light, shape (height, width) or (height, width, channels).

        Parameters
        ----------
        image : ndarray of float
            Light; the last axis holds the channels if there are several.
        weight : ndarray of bool, shape (height, width), optional
            Which points take part: the others spread nothing.

        Returns
        -------
        ndarray
            Of the shape of `image`, and of the type of the sums.

        Raises
        ------
        TypeError, ValueError
            If `image` is not finite light of the shape of the depth, or `weight` does not fit.
        """
        out = self.by_channel(
            image,
            lambda channel, plane: self.spread(channel, [(plane, Points(self._positions(channel, weight)))]),
        )
        if self.beyond is not None:
            light = list(self.apart(image if weight is None else (image.T * weight.T).T))
            made = self.beyond.spread(self, range(self.channels), light)
            for onto, more in zip(self.apart(out), made, strict=True):
                onto += more
        return out

    def adjoint(self, image: NDArray[Any], weight: NDArray[Any] | None = None) -> NDArray[Any]:
        """Return the transpose of :meth:`forward` applied to an image: ``<forward(a), b> = <a, adjoint(b)>``.

        Parameters
        ----------
        image : ndarray of float
            Of the shape that :meth:`forward` takes.
        weight : ndarray of bool, shape (height, width), optional
            As of :meth:`forward`: points that take no part receive 0.

        Returns
        -------
        ndarray
            Of the shape of `image`.

        Raises
        ------
        TypeError, ValueError
            As :meth:`forward`.
        """
        taken = self.by_channel(
            image,
            lambda channel, plane: next(self.collect(channel, plane, [Points(self._positions(channel, weight))])),
        )
        if self.beyond is not None:
            made = self.beyond.collect(self, range(self.channels), list(self.apart(image)))
            for onto, more in zip(self.apart(taken), made, strict=True):
                onto += more if weight is None else more * weight
        return taken

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width of the images."""
        height, width = self.defocus.shape
        return height, width

    @property
    def channels(self) -> int:
        """How many channels an image has; one of a single channel may lack their axis."""
        return len(self.banks)

    def spread(
        self,
        channel: int,
        sources: Sequence[tuple[NDArray[Any], Points]],
        seen: NDArray[Any] | None = None,
        *,
        bank: Bank | None = None,
        slopes: bool = False,
    ) -> NDArray[Any]:
        """Return the sum of what light of several sources makes of one channel.

        Parameters
        ----------
        channel : int
            Its place among `banks`.
        sources : sequence of (ndarray, Points)
            A plane of light, shape (height, width), and the points that spread it.
        seen : ndarray, shape (height, width), optional
            How many layers of points each pixel sees, a real number, if not all.
        bank : Bank, optional
            Another than that of the channel, with windows alike.
        slopes : bool, default False
            Of windows, take their derivatives by positions in the bank.

        Returns
        -------
        ndarray, shape (height, width)

        Raises
        ------
        TypeError, ValueError
            If there is no such channel, or a plane is none of the type of the sums.
        """
        rows, columns, around = self._room(channel)
        if not isinstance(sources, Sequence):
            raise TypeError(f"sources must be a sequence of planes and points, got {validation.shown(sources)}")
        for plane, points in sources:
            self._require(plane, points)
        room = np.zeros([side + sum(more) for side, more in zip(self.shape, around, strict=True)], dtype=self.dtype)
        shown = self._shown(seen, around)
        used = bank or self.banks[channel]
        for plane, points in sources:
            for band, rim in self._bands(rows, used.half):
                where = points.positions, rows[band], columns
                limits = points.layers, None if shown is None else shown[rim]
                engine.spread(*_parts(used), *where, plane, self.threads, room[rim], *limits, slopes)
                if self.watch is not None:
                    self.watch(int(np.count_nonzero(points.positions[rows[band]] >= 0.0)))
        if self.border == "reflect":  # The mirrored image sends in what leaves this one.
            return folded(folded(room, around[0][0], self.shape[0]).T, around[1][0], self.shape[1]).T
        (top, _), (left, _) = around
        return room[top:, left:][: self.shape[0], : self.shape[1]]

    def collect(
        self,
        channel: int,
        plane: NDArray[Any],
        sources: Sequence[Points],
        seen: NDArray[Any] | None = None,
        *,
        bank: Bank | None = None,
        slopes: bool = False,
    ) -> Iterator[NDArray[Any]]:
        """Yield for each source what the transpose of :meth:`spread` gives to it.

        Parameters
        ----------
        channel : int
            Its place among `banks`.
        plane : ndarray, shape (height, width)
        sources : sequence of Points
        seen, bank, slopes
            As of :meth:`spread`.

        Yields
        ------
        ndarray, shape (height, width)

        Raises
        ------
        TypeError, ValueError
            As :meth:`spread`.
        """
        rows, columns, around = self._room(channel)
        for points in sources:
            self._require(plane, points)
        room = np.pad(plane, around, mode="symmetric" if self.border == "reflect" else "constant")
        shown = self._shown(seen, around)
        for points in sources:
            taken = np.empty((rows.size, columns.size), dtype=self.dtype)
            where = points.positions, rows, columns
            engine.collect(
                *_parts(bank or self.banks[channel]), *where, room, self.threads, taken, points.layers, shown, slopes
            )
            # What points beyond the edges took goes to those that they are copies of.
            yield gathered(gathered(taken, rows, self.shape[0]).T, columns, self.shape[1]).T

    def _at(self, channel: int) -> int:
        """Return the place of a channel among `banks`; TypeError or ValueError if there is none."""
        return validation.integer("channel", channel, least=0, most=len(self.banks) - 1)

    def _require(self, plane: Any, points: Any) -> None:
        """Refuse a plane and points that are none of this shape, or of another type than the sums."""
        validation.instance("points", points, Points)
        if not isinstance(plane, np.ndarray) or plane.shape != self.shape or plane.dtype != self.dtype:
            raise TypeError(
                f"plane must be an array of {self.dtype} of the shape {self.shape}, got {validation.shown(plane)}"
            )

    def _room(self, channel: int) -> tuple[NDArray[np.int64], NDArray[np.int64], list[tuple[int, int]]]:
        """Return rows and columns of the image with copies of its edges, and what their windows need around it."""
        bank = self.banks[self._at(channel)]
        margin = bank.half if self.border == "extend" else 0
        rows, columns = (np.pad(np.arange(side, dtype=np.int64), margin, mode="edge") for side in self.shape)
        return rows, columns, [(margin + more,) * 2 for more in bank.beyond]

    def _bands(self, rows: NDArray[np.int64], half: int) -> Iterator[tuple[slice, slice]]:
        """Yield rows that are spread together, all unless somebody watches, and the rows that they reach."""
        height = len(rows) if self.watch is None else max(_BAND // self.shape[1], 8 * half, 64)
        for first in range(0, len(rows), height):
            last = min(first + height, len(rows))
            yield slice(first, last), slice(first, last + 2 * half)

    def _shown(self, seen: NDArray[Any] | None, around: list[tuple[int, int]]) -> NDArray[Any] | None:
        """Return what pixels see, with the room around them."""
        return (
            None if seen is None else np.pad(seen, around, mode="symmetric" if self.border == "reflect" else "edge")
        )

    def positions(self, channel: int) -> NDArray[np.float64]:
        """Return where each point is in the bank of a channel.

        Parameters
        ----------
        channel : int
            Its place among `banks`.

        Returns
        -------
        ndarray, shape (height, width)

        Raises
        ------
        TypeError, ValueError
            If there is no such channel.
        """
        channel = self._at(channel)
        placed = self._placed
        if placed is None or placed[0] is not self.defocus or placed[1] is not self.banks:
            known = {(bank.start, bank.spacing): bank.positions(self.defocus) for bank in self.banks}
            for positions in known.values():
                np.maximum(positions, 0.0, out=positions)
            each = tuple(known[bank.start, bank.spacing] for bank in self.banks)
            self._placed = placed = self.defocus, self.banks, each
        return placed[2][channel]

    def _positions(self, channel: int, weight: NDArray[Any] | None) -> NDArray[np.float64]:
        """Return where each point is in the bank of a channel, below 0 for those left out."""
        positions = self.positions(channel)
        if weight is None:
            return positions
        given = validation.array("weight", weight)
        if not isinstance(weight, np.ndarray) or given.dtype != np.bool_ or given.shape != self.shape:
            got = f"{given.dtype} of the shape {given.shape}"
            raise TypeError(f"weight must be an array of bool of the shape {self.shape}, got {got}")
        return np.where(weight, positions, -1.0)


def _parts(bank: Bank) -> tuple[NDArray[Any], NDArray[np.int64], Array]:
    return bank.windows, bank.halves, bank.energies


def require_lens(lens: Any, order: str) -> None:
    """Raise TypeError unless `lens` is one, saying in which `order` arguments are given."""
    if not isinstance(lens, Lens):
        raise TypeError(f"lens must be a Lens, got {type(lens).__name__}; the order is {order}")


def require_depth(depth: ArrayLike) -> NDArray[np.float64]:
    """Return depth as float64; raise TypeError or ValueError unless it is an image of metres above 0."""
    distances = validation.array("depth", depth)
    if distances.dtype.kind not in "iuf":
        raise TypeError(f"depth must hold metres, got {distances.dtype}")
    if distances.ndim != 2 or 0 in distances.shape:
        raise ValueError(f"depth must have the shape (height, width), got {distances.shape}")
    metres = distances.astype(np.float64, copy=False)
    if not np.all(metres > 0.0):
        if (unknown := np.isnan(metres)).any():
            count = int(unknown.sum())
            raise ValueError(f"depth is NaN at {count} of {metres.size} points; say what is there by `missing`")
        raise ValueError(f"depth must be > 0 metres, got {metres[~(metres > 0.0)].flat[0]}")
    return metres
