"""Blur that varies with depth, as a linear operator: every point spreads the PSF of its own distance."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import validation
from lommel.base.options import shares
from lommel.core import engine
from lommel.imaging.bank import Bank, build_bank
from lommel.imaging.settings import BlurKeywords, Settings, Spectrum, spectra
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil

_BEYOND = 16  # columns that the compiled core asks for beyond the image


@shares(BlurKeywords, Settings)
class DepthBlur:
    r"""What a lens makes of a scene, for one focus: ``out[q] = sum_p image[p] K(q - p; C_d(depth[p]))``.

    K is the PSF averaged over the pixels, at the defocus of each source point, cut to a window that holds `energy` of
    its light and divided by what the window holds, so that light is conserved. Between the windows of a bank it is
    interpolated by cubics. Points do not hide one another: for that see :func:`lommel.imaging.depth_of_field`.

    Parameters
    ----------
    lens : Lens
        Its aberrations must be radially symmetric.
    depth : array_like, shape (height, width)
        Distance of each point from the lens, metres, positive; may be infinite.
    pixel : float
        Pixel pitch, metres.
    channels : sequence, default (lens.wavelength,)
        For each channel a wavelength (metres), or its spectrum, pairs of wavelength and weight.
    {options}

    Attributes
    ----------
    banks : tuple of Bank
        One a channel.
    lost : float
        Largest share of light beyond the windows, of any point and channel.

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range; if the blur exceeds `largest`.
    """

    def __init__(
        self,
        lens: Lens,
        depth: ArrayLike,
        pixel: float,
        *,
        channels: Sequence[Spectrum] | None = None,
        **options: Unpack[BlurKeywords],
    ) -> None:
        require_lens(lens, "lens, depth, pixel")
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
        self.border, self.dtype, self.threads = settings.border, np.dtype(settings.dtype), settings.threads or 0
        self.place(depth)
        pupil = Pupil(
            lens.aberrations,
            obscuration=lens.obscuration,
            wavelength=lens.wavelength,
            f_number=lens.working_f_number,
            apodization=lens.illumination,
        )
        reach = (float(self.defocus.min()), float(self.defocus.max()))
        colours = spectra("channels", [lens.wavelength] if channels is None else channels)
        known: dict[tuple[tuple[float, float], ...], Bank] = {}
        for spectrum in colours:
            if spectrum not in known:
                known[spectrum] = build_bank(
                    pupil,
                    lens.phase,
                    spectrum,
                    self.pixel,
                    reach,
                    tol=settings.tol,
                    energy=settings.energy,
                    largest=settings.largest or max(1, min(self.shape) // 2),
                    dtype=self.dtype,
                    threads=self.threads,
                )
        self.banks = tuple(known[spectrum] for spectrum in colours)

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
        distances = _depth(depth)
        self.shape = distances.shape
        self.defocus = self.lens.defocus(distances)
        self.defocus.flags.writeable = False

    @property
    def lost(self) -> float:
        """Largest share of light beyond the windows, of any point and channel."""
        return max(bank.lost for bank in self.banks)

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
        planes = self._planes(image)
        out = np.empty((len(planes), *self.shape), dtype=self.dtype)
        for plane, bank, to in zip(planes, self.banks, out, strict=True):
            margin, positions = self._positions(bank, weight)
            source = np.ascontiguousarray(self._padded(plane, margin))
            height, width = (side + 2 * bank.half for side in source.shape)
            room = np.zeros((height, width + _BEYOND), dtype=self.dtype)
            engine.spread(bank.windows, bank.halves, bank.energies, positions, source, self.threads, room)
            cut = margin + bank.half
            to[:] = room[cut : cut + self.shape[0], cut : cut + self.shape[1]]
        return self._shaped(out, image)

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
        planes = self._planes(image)
        out = np.empty((len(planes), *self.shape), dtype=self.dtype)
        for plane, bank, to in zip(planes, self.banks, out, strict=True):
            margin, positions = self._positions(bank, weight)
            room = np.pad(plane, margin + bank.half)
            taken = np.empty(positions.shape, dtype=self.dtype)
            engine.collect(bank.windows, bank.halves, bank.energies, positions, room, self.threads, taken)
            to[:] = self._folded(taken, margin)
        return self._shaped(out, image)

    def require(self, image: NDArray[Any]) -> None:
        """Refuse what is no finite light of the shape of the depth.

        Parameters
        ----------
        image : ndarray

        Raises
        ------
        TypeError, ValueError
            If it has another shape, or holds anything but finite floats.
        """
        array = validation.array("image", image)
        count = len(self.banks)
        wanted = (*self.shape, count) if array.ndim == 3 or count > 1 else self.shape
        if array.shape != wanted:
            raise ValueError(f"image must have the shape {wanted}, got {array.shape}")
        if array.dtype.kind != "f":
            raise TypeError(f"image must hold floats in proportion to light, got {array.dtype}")
        if not np.all(np.isfinite(array)):
            raise ValueError(f"image must be finite, got {array[~np.isfinite(array)].flat[0]}")

    def _planes(self, image: NDArray[Any]) -> NDArray[Any]:
        self.require(image)
        array = np.asarray(image)  # without a mask, as require has seen
        planes = array[None] if array.ndim == 2 else np.moveaxis(array, 2, 0)
        return np.ascontiguousarray(planes, dtype=self.dtype)

    def _shaped(self, planes: NDArray[Any], image: NDArray[Any]) -> NDArray[Any]:
        return planes[0] if np.ndim(image) == 2 else np.ascontiguousarray(np.moveaxis(planes, 0, 2))

    def _positions(self, bank: Bank, weight: NDArray[Any] | None) -> tuple[int, NDArray[np.float64]]:
        """Return the margin of the border, and where each point is in the bank, below 0 for those left out."""
        positions = np.maximum(bank.positions(self.defocus), 0.0)
        if weight is not None:
            given = validation.array("weight", weight)
            if not isinstance(weight, np.ndarray) or given.dtype != np.bool_ or given.shape != self.shape:
                got = f"{given.dtype} of the shape {given.shape}"
                raise TypeError(f"weight must be an array of bool of the shape {self.shape}, got {got}")
            positions = np.where(weight, positions, -1.0)
        margin = 0 if self.border == "zero" else bank.half
        return margin, np.ascontiguousarray(self._padded(positions, margin))

    def _padded(self, plane: NDArray[Any], margin: int) -> NDArray[Any]:
        if margin == 0:
            return plane
        return np.pad(plane, margin, mode="symmetric" if self.border == "reflect" else "edge")

    def _folded(self, taken: NDArray[Any], margin: int) -> NDArray[Any]:
        """Return the transpose of padding: what copies took goes to where they came from."""
        if margin == 0:
            return taken
        rows, columns = (self._padded(np.arange(side), margin) for side in self.shape)
        folded = np.zeros((self.shape[0], taken.shape[1]), dtype=taken.dtype)
        np.add.at(folded, rows, taken)
        out = np.zeros((self.shape[1], self.shape[0]), dtype=taken.dtype)
        np.add.at(out, columns, folded.T)
        return out.T


def require_lens(lens: Any, order: str) -> None:
    """Raise TypeError unless `lens` is one, saying in which `order` arguments are given."""
    if not isinstance(lens, Lens):
        raise TypeError(f"lens must be a Lens, got {type(lens).__name__}; the order is {order}")


def _depth(depth: ArrayLike) -> NDArray[np.float64]:
    distances = validation.array("depth", depth)
    if distances.dtype.kind not in "iuf":
        raise TypeError(f"depth must hold metres, got {distances.dtype}")
    if distances.ndim != 2 or 0 in distances.shape:
        raise ValueError(f"depth must have the shape (height, width), got {distances.shape}")
    metres = distances.astype(np.float64)
    if np.isnan(metres).any():
        count = int(np.isnan(metres).sum())
        raise ValueError(f"depth is NaN at {count} of {metres.size} points; say what is there by `missing`")
    if not np.all(metres > 0.0):
        raise ValueError(f"depth must be > 0 metres, got {metres[~(metres > 0.0)].flat[0]}")
    return metres
