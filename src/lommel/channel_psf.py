"""PSFs in the colour channels of a sensor; each wavelength is computed once for all channels."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from os import PathLike
from typing import TYPE_CHECKING, Any, Self, TypedDict, Unpack, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import display, validation
from lommel.base.arrays import Array, Index, Values, largest
from lommel.base.options import near
from lommel.blur.blurs import Blur
from lommel.core.answers import Wanted
from lommel.measures.psf_like import ColourPSFLike
from lommel.methods import question
from lommel.methods.method import Method, storing, to_images, with_model_error
from lommel.methods.polychromatic import Polychromatic, together
from lommel.methods.question import prepare
from lommel.optics.base_pupil import BasePupil, imaged
from lommel.optics.colour.spectrum import Channels, checked
from lommel.optics.grid import Grid
from lommel.psf import PSF, Found, Measured, Plan

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from lommel.methods.derivative_names import Name

_AT_ONCE = 2**22  # values of a channel that are computed at once


class SamplingKeywords(TypedDict, total=False):
    """Options of :func:`lommel.psf` on method, tolerance and pixels."""

    method: Method | None
    tol: float | None
    center: tuple[ArrayLike, ArrayLike] | None
    integrate: bool | None
    threads: int | None


class PSFKeywords(SamplingKeywords, total=False):
    """Options of :func:`lommel.psf` that do not depend on the pupil."""

    normalize: str
    dtype: DTypeLike | None
    fill: float | tuple[float, float]
    blur: Blur | Sequence[Blur]


class Keywords(PSFKeywords, total=False):
    """Options of :func:`colour_psf`."""

    derivatives: Sequence[Name]


@dataclass(frozen=True, eq=False, repr=False)
class ColourPSF(Measured, ColourPSFLike):
    """PSFs of a pupil, or of a stack of pupils, in colour channels; ``answer["red"]`` is a :class:`lommel.PSF`.

    Attributes
    ----------
    channels : Channels
        Names, wavelengths and weights.
    psfs : tuple of PSF
        One for each channel, computed by :class:`lommel.Polychromatic`. The pupil of a channel of one wavelength is
        at that wavelength; of a channel of several it is the one that was given, and measures use all wavelengths.
    values : ndarray, shape ``pupil.shape + (channels, height, width)``
        Values of all channels, each normalised separately.
    pupil : Pupil or ObjectivePupil
        Pupil of the first channel.
    grid : Grid
        The pixels.
    normalize : str
        Normalisation of the values.

    Raises
    ------
    TypeError, ValueError
        If there is not one PSF for each channel, or they differ in more than their wavelengths.
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
        # One array of all channels needs one shape and type; plots and files one pixel and unit.
        alike = {(p.values.shape, p.values.dtype.str, p.pixel, p.normalize, p.unit) for p in psfs}
        if len(alike) > 1:
            raise ValueError(f"psfs must be alike but for their light, got {validation.shown(sorted(alike))}")
        # One array, of which those of the channels are parts.
        base = psfs[0].values.base
        if base is None or base.shape != (len(psfs), *psfs[0].values.shape) or not _parts(base, psfs):
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
        """Yield the PSF of each channel."""
        return iter(self.psfs)

    def __getitem__(self, channel: str | int) -> PSF:
        """Return the PSF, or the stack of PSFs, of a channel by its name or its number."""
        if isinstance(channel, str):
            if channel not in self.names:
                raise KeyError(f"there is no channel {channel!r}; there are {', '.join(self.names)}")
            return self.psfs[self.names.index(channel)]
        if isinstance(channel, bool) or not isinstance(channel, int | np.integer):
            raise TypeError(
                f"a channel is named by a text or a number, got {validation.shown(channel)}; part(index) is a part "
                "of a stack"
            )
        return self.psfs[channel]

    def part(self, index: Index) -> Self:
        """Return part of a stack in all channels; `index` is that of a NumPy array of the pupils."""
        return type(self)(self.channels, tuple(psf[index] for psf in self.psfs))

    def __repr__(self) -> str:
        bound = "none" if self.error_bound is None else f"{self.error_bound:.2g}"
        return (
            f"<{type(self).__name__} {'x'.join(map(str, self.shape))} {self.values.dtype}, channels "
            f"{', '.join(self.names)}, pixel {self.pixel:g} {self.unit}, normalize {self.normalize!r}, "
            f"error bound {bound}>"
        )

    def measured(self, measure: Callable[[PSF], Found]) -> Found:
        """Return a `measure` of each channel, along an axis after those of the stack."""
        return cast(Found, np.stack([np.asarray(measure(psf)) for psf in self.psfs], axis=len(self.pupil.shape)))

    def plot(self, ax: Axes | None = None, *, stretch: str = "sqrt") -> Axes | NDArray[np.object_]:
        """Draw the PSF in colour, a stack side by side; unless there are three channels, draw each separately.

        See :func:`lommel.show.plot.colour`.
        """
        validation.axes("ax", ax)
        axes: Axes | NDArray[np.object_] = display.plot(self, ax, stretch=stretch)
        return axes

    def save(self, path: str | PathLike[str]) -> None:
        """Write a file of a `path` as :meth:`lommel.PSF.save`, ``.png`` in colour.

        See :func:`lommel.io.psf_files.save_colours`.
        """
        display.save(self, path)

    @classmethod
    def load(cls, path: str | PathLike[str]) -> ColourPSF:
        """Read a file, `path`, that :meth:`save` wrote, but for ``.png``; ValueError for any other file."""
        return cls(*display.named("load channels", "file")(path, PSF))


def _parts(whole: Values, psfs: Sequence[PSF]) -> bool:
    """Return whether the values of each PSF are its part of an array of all."""
    return all(
        psf.values.base is whole and psf.values.ctypes.data == part.ctypes.data
        for psf, part in zip(psfs, whole, strict=True)
    )


def colour_psf(
    pupil: BasePupil,
    shape: int | tuple[int, int],
    pixel: float | tuple[float, float],
    channels: Channels | Sequence[float] | None = None,
    **options: Unpack[Keywords],
) -> ColourPSF:
    """Compute the PSF of a pupil in each colour channel of a sensor, or at each of several wavelengths.

    Parameters
    ----------
    pupil : Pupil or ObjectivePupil
        With a wavelength, the reference; at others the pupil is that of :meth:`lommel.Lens.in_light`.
    shape : int or (int, int)
    pixel : float or (float, float)
        As of :func:`lommel.psf`.
    channels : Channels or sequence of float, optional
        Spectral weights of each channel, or wavelengths in metres; by default ``Channels.rgb()``.
    **options
        ``method`` (of one wavelength), ``tol``, ``normalize``, ``dtype``, ``center``, ``integrate``, ``fill``,
        ``blur``, ``derivatives`` and ``threads`` as of :func:`lommel.psf`. The tolerance is relative to the peak of
        each channel, and each channel is normalised separately. Derivatives are with respect to the parameters of
        `pupil`, at its own wavelength.

    Returns
    -------
    ColourPSF
        With ``values`` of shape ``pupil.shape + (channels, height, width)``.

    Raises
    ------
    TypeError, ValueError
        As :func:`lommel.psf`; also if the pupil has no wavelength, or `channels` is invalid.
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
    if stray := [name for name in options if name not in Keywords.__annotations__]:
        raise TypeError(f"colour_psf() has no option {stray[0]!r}; {near(stray[0], Keywords.__annotations__)}")
    light = Channels.rgb() if channels is None else checked(channels)
    if imaged(pupil).wavelength is None:
        raise ValueError(
            "pupil must have a wavelength, to which those of the channels are related; colour needs a pupil with a "
            "wavelength and an f_number, such as that of a Lens"
        )
    rest: dict[str, Any] = {**options}
    derivatives = rest.pop("derivatives", ())
    plan = Plan(shape, pixel, **rest)
    # A channel is an incoherent sum; all channels share the wavelengths, and so the fields at each.
    sums = [Polychromatic([w for w, _ in each], [s for _, s in each], plan.method, plan.tol) for _, each in light]
    # Derivatives, blur and pixels that are not square are computed channel by channel.
    if derivatives or not plan.plain:
        rest |= {"tol": None}
        made = [Plan(shape, pixel, **rest | {"method": each})(pupil, derivatives=derivatives) for each in sums]
        return ColourPSF(light, tuple(_in_own_light(one) for one in made))
    if places := plan.grid(pupil).stack:
        pupil = question.for_axes(pupil, places)
    return ColourPSF(light, tuple(_in_own_light(one) for one in _psfs(pupil, sums, plan)))


def _in_own_light(psf: PSF) -> PSF:
    """Return a PSF with the pupil in its own light, where that is of one wavelength."""
    method, wavelength = psf.method, psf.pupil.wavelength
    if not isinstance(method, Polychromatic) or wavelength is None or len(method.wavelengths) > 1:
        return psf
    # A channel of one wavelength is a plain PSF, with measures at that wavelength.
    (own,) = method.wavelengths
    # Intensities relate to the peak at the wavelength of the pupil, which is brighter in shorter light.
    return replace(psf, pupil=psf.pupil.in_light(own), scale=psf.scale * (wavelength / own) ** 2)


def _psfs(pupil: BasePupil, sums: list[Polychromatic], plan: Plan) -> tuple[PSF, ...]:
    asked = prepare(pupil, (), plan.grid(pupil), sums[0], plan.tol, plan.normalize, plan.dtype, plan.threads)
    count, sides = math.prod(pupil.shape), asked.grid.shape
    if len(sums) * count * math.prod(sides) > validation.MAX_VALUES:
        raise ValueError(
            f"shape {sides} for {count} pupils in {len(sums)} channels makes more than the limit of "
            f"{validation.MAX_VALUES} values"
        )
    values = np.empty((len(sums), *pupil.shape, *sides), plan.dtype)
    scales = np.empty((len(sums), count))
    errors: list[list[NDArray[np.float64] | None]] = [[] for _ in sums]
    # Intensities of all channels are held in double precision before they are stored.
    step = max(1, _AT_ONCE // math.prod(sides))
    for first in range(0, count, step):
        block = slice(first, min(first + step, count))
        part, grid = pupil, asked.grid
        if step < count:
            index = np.unravel_index(np.arange(block.start, block.stop), pupil.shape)
            part, grid = pupil[index], grid[index] if grid.stack else grid
        normalized = asked.wanted.scale is None
        # Values divided by their own largest one are off by twice as much.
        aim = (0.48 if normalized else 1.0) * (plan.tol - 1.1 * storing(plan.dtype))
        found = together(sums, part, grid, plan.threads, aim, window=normalized)
        for c, (each, intensities) in enumerate(zip(sums, found, strict=True)):
            out = values[c].reshape(count, *sides)[block]
            question = Wanted(
                _scale(each, part, plan, asked.wanted.scale, block), plan.dtype, out, threads=plan.threads
            )
            images = with_model_error(to_images(intensities, grid, question), part, each, normalized=normalized)
            scales[c, block] = images.scale
            errors[c].append(images.error)
    return tuple(
        PSF(
            values=values[c],
            grid=asked.grid,
            pupil=pupil,
            method=each,
            normalize=plan.normalize,
            error_bound=None
            if any(e is None for e in errors[c])
            else max(largest(e) for e in errors[c] if e is not None),
            scale=scales[c].reshape(pupil.shape),
        )
        for c, each in enumerate(sums)
    )


def _scale(
    each: Polychromatic, pupil: BasePupil, plan: Plan, scale: float | Array | None, block: slice
) -> float | Array | None:
    """Return what intensities of a block are multiplied by: the light of a channel decides where it is the peak."""
    if plan.normalize == "strehl":
        return 1.0 / each.unaberrated_peak(pupil)
    return scale[block] if isinstance(scale, np.ndarray) and scale.ndim else scale
