"""PSFs in the colour channels of a sensor: a wavelength that several channels share is computed only once."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from os import PathLike
from typing import TYPE_CHECKING, Any, Self, cast

import numpy as np
from numpy.typing import NDArray

from lommel.base import display, validation
from lommel.base.arrays import Array, Index, Values, largest
from lommel.core.answers import Wanted
from lommel.measures.psf_like import ColourPSFLike
from lommel.methods import question
from lommel.methods.method import storing, to_images, with_model_error
from lommel.methods.polychromatic import Polychromatic, sum_spectra
from lommel.methods.question import prepare
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.colour.spectrum import Channels, checked
from lommel.optics.grid import Grid
from lommel.psf import PSF, Found, Measured, Plan

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_BLOCK_VALUES = 2**22  # number of values per channel that are computed in one block of pupils


@dataclass(frozen=True, eq=False, repr=False)
class ColourPSF(Measured, ColourPSFLike):
    """PSFs of a pupil, or of a stack of pupils, in colour channels; ``answer["red"]`` is a :class:`lommel.PSF`.

    Attributes
    ----------
    channels : Channels
        Names, wavelengths and weights of the channels.
    psfs : tuple of PSF
        One PSF for each channel, computed by :class:`lommel.methods.Polychromatic`. If a channel has a single
        wavelength, its pupil is at this wavelength; otherwise it is the pupil passed to :func:`colour_psf`, and
        measures use all wavelengths of the channel.
    values : ndarray, shape ``pupil.shape + (channels, height, width)``
        Values of all channels; each channel is normalised separately.
    pupil : Pupil or ObjectivePupil
        Pupil of the first channel.
    grid : Grid
        Grid of pixels.
    normalize : str
        Normalisation of the values.

    Raises
    ------
    TypeError, ValueError
        If there is not one PSF for each channel, or if the PSFs differ in shape, type, pixel, normalisation or unit.
    """

    channels: Channels
    psfs: tuple[PSF, ...]
    values: Values = field(init=False)
    pupil: BasePupil = field(init=False)
    grid: Grid = field(init=False)
    normalize: str = field(init=False)

    def __post_init__(self) -> None:
        validation.instance("channels", self.channels, Channels)
        psfs: tuple[PSF, ...] = tuple(self.psfs) if isinstance(self.psfs, Iterable) else ()
        if len(psfs) != len(self.channels) or not all(isinstance(psf, PSF) for psf in psfs):
            raise TypeError(
                f"psfs must be a PSF for each of the {len(self.channels)} channels, got {validation.shown(self.psfs)}"
            )
        # All channels share one array, which needs one shape and type. Plots and files need one pixel and unit.
        properties = {(p.values.shape, p.values.dtype.str, p.pixel, p.normalize, p.unit) for p in psfs}
        if len(properties) > 1:
            raise ValueError(
                "psfs must have the same shape, type, pixel, normalisation and unit, "
                f"got {validation.shown(sorted(properties))}"
            )
        # `base` is the array of all channels; the values of each PSF are a view of it.
        base = np.stack([p.values for p in psfs])
        psfs = tuple(replace(p, values=base[k]) for k, p in enumerate(psfs))
        vars(self).update(psfs=psfs, values=np.moveaxis(base, 0, -3))
        vars(self).update({name: getattr(psfs[0], name) for name in ("pupil", "grid", "normalize")})

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the channels."""
        return self.channels.names

    def __len__(self) -> int:
        """Return the number of channels."""
        return len(self.psfs)

    def __iter__(self) -> Iterator[PSF]:
        """Iterate over the PSFs of the channels."""
        return iter(self.psfs)

    def __getitem__(self, channel: str | int) -> PSF:
        """Return the PSF, or the stack of PSFs, of a channel, which is given by name or number."""
        if isinstance(channel, str):
            if channel not in self.names:
                raise KeyError(f"there is no channel {channel!r}; choose from {', '.join(self.names)}")
            return self.psfs[self.names.index(channel)]
        if isinstance(channel, bool) or not isinstance(channel, int | np.integer):
            raise TypeError(
                f"a channel must be a name or a number, got {validation.shown(channel)}; use part(index) to select "
                "pupils of a stack"
            )
        return self.psfs[channel]

    def part(self, index: Index) -> Self:
        """Return part of a stack in all channels; `index` indexes the stack of pupils as a NumPy array."""
        return type(self)(self.channels, tuple(psf[index] for psf in self.psfs))

    def __repr__(self) -> str:
        bound = "none" if self.error_bound is None else f"{self.error_bound:.2g}"
        return (
            f"<{type(self).__name__} {'x'.join(map(str, self.shape))} {self.values.dtype}, channels "
            f"{', '.join(self.names)}, pixel {self.pixel:g} {self.unit}, normalize {self.normalize!r}, "
            f"error bound {bound}>"
        )

    def apply(self, measure: Callable[[PSF], Found]) -> Found:
        """Return the result of `measure` for each channel, along an axis after the axes of the stack."""
        return cast(Found, np.stack([np.asarray(measure(psf)) for psf in self.psfs], axis=len(self.pupil.shape)))

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes | NDArray[np.object_]:
        """Draw the PSF in colour if there are three channels, else each channel separately; a stack side by side.

        See :func:`lommel.show.plot.colour`.
        """
        validation.axes("ax", ax)
        axes: Axes | NDArray[np.object_] = display.plot(self, ax, stretch=stretch)
        return axes

    def save(self, path: str | PathLike[str]) -> None:
        """Write a file in a format of :meth:`lommel.PSF.save`, or a colour picture ``.png``.

        See :func:`lommel.io.psf_files.save_colours`.
        """
        display.save(self, path)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> ColourPSF:
        """Read the file at `path`, written by :meth:`save` but not ``.png``; ValueError for any other file."""
        return cls(*display.named("load channels", "file")(path, PSF))


def colour_psf(
    pupil: BasePupil,
    shape: int | tuple[int, int],
    pixel: float | tuple[float, float],
    channels: Channels | Sequence[float] | None = None,
    **options: Any,
) -> ColourPSF:
    """Compute the PSF of a pupil in each colour channel of a sensor, or at each of several wavelengths.

    Parameters
    ----------
    pupil : Pupil or ObjectivePupil
        Pupil at a reference wavelength, which is required. For other wavelengths the pupil is changed as by
        :meth:`lommel.Lens.in_light`.
    shape, pixel
        As for :func:`lommel.psf`.
    channels : Channels or sequence of float, optional
        Wavelengths and spectral weights of each channel, or one wavelength in metres for each channel; by default
        ``Channels.rgb()``.
    **options
        ``method`` (monochromatic), ``tol``, ``normalize``, ``dtype``, ``center``, ``integrate``, ``fill``, ``blur``,
        ``derivatives`` and ``threads`` as for :func:`lommel.psf`. The tolerance of a channel is relative to its peak,
        and each channel is normalised separately. Derivatives are with respect to the parameters of `pupil` at its
        reference wavelength.

    Returns
    -------
    ColourPSF
        With ``values`` of shape ``pupil.shape + (channels, height, width)``.

    Raises
    ------
    TypeError, ValueError
        As for :func:`lommel.psf`; also if the pupil has no wavelength, or `channels` is invalid.
    ToleranceError
        If the tolerance cannot be met.

    Examples
    --------
    >>> import lommel as lm
    >>> lens = lm.Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    >>> answer = lm.colour_psf(lens.pupil(1.5), 33, 3.45e-6, lm.Channels.rgb())
    >>> answer.values.shape, answer["red"].values.shape
    ((3, 33, 33), (33, 33))
    """
    light = Channels.rgb() if channels is None else checked(channels)
    if imaged(pupil).wavelength is None:
        raise ValueError(
            "pupil must have a reference wavelength for colour, got none; use the pupil of a Lens, or a Pupil with "
            "wavelength and f_number"
        )
    derivatives = options.pop("derivatives", ())
    plan = Plan(shape, pixel, **options)
    # A channel is an incoherent sum over its wavelengths.
    sums = [Polychromatic([w for w, _ in pairs], [s for _, s in pairs], plan.method, plan.tol) for _, pairs in light]
    # Derivatives, blur, fill factors and pixels that are not square are computed channel by channel.
    if derivatives or not plan.plain:
        psfs = [
            Plan(shape, pixel, **options | {"method": method, "tol": None})(pupil, derivatives=derivatives)
            for method in sums
        ]
        return ColourPSF(light, tuple(_at_single_wavelength(psf) for psf in psfs))
    if center_shape := plan.grid(pupil).stack:
        pupil = question.for_axes(pupil, center_shape)
    return ColourPSF(light, tuple(_at_single_wavelength(psf) for psf in _compute_channels(pupil, sums, plan)))


def _at_single_wavelength(psf: PSF) -> PSF:
    """Return the PSF of a channel; if the channel has one wavelength, the pupil is changed to this wavelength."""
    method, wavelength = psf.method, psf.pupil.wavelength
    if not isinstance(method, Polychromatic) or wavelength is None or len(method.wavelengths) > 1:
        return psf
    # Measures of the PSF are then computed at this wavelength.
    (single,) = method.wavelengths
    # `scale` refers to the unaberrated peak at the wavelength of the pupil, which is proportional to lambda^-2.
    return replace(psf, pupil=psf.pupil.in_light(single), scale=psf.scale * (wavelength / single) ** 2)


def _compute_channels(pupil: BasePupil, sums: list[Polychromatic], plan: Plan) -> tuple[PSF, ...]:
    """Compute the PSFs of all channels in blocks of pupils; each wavelength is computed only once."""
    prepared = prepare(pupil, (), plan.grid(pupil), sums[0], plan.tol, plan.normalize, plan.dtype, plan.threads)
    count, sides = math.prod(pupil.shape), prepared.grid.shape
    if len(sums) * count * math.prod(sides) > validation.MAX_VALUES:
        raise ValueError(
            f"shape {sides} for {count} pupils in {len(sums)} channels exceeds the limit of "
            f"{validation.MAX_VALUES} values; compute part of the pupils or a smaller window"
        )
    values = np.empty((len(sums), *pupil.shape, *sides), plan.dtype)
    scales = np.empty((len(sums), count))
    errors: list[list[NDArray[np.float64] | None]] = [[] for _ in sums]
    # Blocks limit memory, since intensities of all channels are in double precision before they are stored.
    step = max(1, _BLOCK_VALUES // math.prod(sides))
    for start in range(0, count, step):
        block = slice(start, min(start + step, count))
        part, grid = pupil, prepared.grid
        if step < count:
            index = np.unravel_index(np.arange(block.start, block.stop), pupil.shape)
            part, grid = pupil[index], grid[index] if grid.stack else grid
        normalized = prepared.wanted.scale is None
        # The largest value has an error, too: division by it about doubles the error divided by the peak.
        aim = (0.48 if normalized else 1.0) * (plan.tol - 1.1 * storing(plan.dtype))
        channel_intensities = sum_spectra(sums, part, grid, plan.threads, aim, window=normalized)
        for c, (method, intensities) in enumerate(zip(sums, channel_intensities, strict=True)):
            target = values[c].reshape(count, *sides)[block]
            request = Wanted(
                _channel_scale(method, part, plan, prepared.wanted.scale, block),
                plan.dtype,
                target,
                threads=plan.threads,
            )
            images = with_model_error(to_images(intensities, grid, request), part, method, normalized=normalized)
            scales[c, block] = images.scale
            errors[c].append(images.error)
    return tuple(
        PSF(
            values=values[c],
            grid=prepared.grid,
            pupil=pupil,
            method=method,
            normalize=plan.normalize,
            error_bound=None
            if any(e is None for e in errors[c])
            else max(largest(e) for e in errors[c] if e is not None),
            scale=scales[c].reshape(pupil.shape),
        )
        for c, method in enumerate(sums)
    )


def _channel_scale(
    method: Polychromatic, pupil: BasePupil, plan: Plan, scale: float | Array | None, block: slice
) -> float | Array | None:
    """Return the scale factor of a block of pupils; for "strehl" it is 1 / (unaberrated peak of the channel)."""
    if plan.normalize == "strehl":
        return 1.0 / method.unaberrated_peak(pupil)
    return scale[block] if isinstance(scale, np.ndarray) and scale.ndim else scale
