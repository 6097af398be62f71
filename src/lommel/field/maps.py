"""The field of a lens: wavefronts that change over the sensor."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import options, validation
from lommel.base.arrays import Array
from lommel.base.options import shares
from lommel.channel_psf import ColourPSF, colour_psf
from lommel.field import wavefronts
from lommel.field.depths import at_depths
from lommel.field.psf_grid import PSFGrid
from lommel.field.vignetting import Shaded, Shading, Vignetting, places
from lommel.measures.answer_grid import sides
from lommel.methods import Method
from lommel.optics.colour.channels import Channels
from lommel.optics.field_pupil import FieldPupil
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf


def stacked(pupils: list[Pupil], shape: tuple[int, ...], compute: Callable[[Pupil], PSF]) -> PSF:
    """Return the PSFs of single pupils as a stack of a shape.

    Parameters
    ----------
    pupils : list of Pupil
    shape : tuple of int
    compute : callable
        From a pupil to its PSF, without derivatives.

    Returns
    -------
    PSF
        Of the method of the place that is narrowed most; its bound is the largest, None where one has none.
    """
    found = [compute(pupil) for pupil in pupils]
    first = found[0]
    if any(one.derivatives for one in found):
        raise ValueError("derivatives are those of one aperture: ask place by place where vignetting changes it")
    bounds = [one.error_bound for one in found]
    narrow = next((one for one in found if not one.pupil.circular), first)
    return replace(
        narrow,
        values=np.stack([one.values for one in found]).reshape(shape + first.values.shape),
        pupil=FieldPupil(tuple(pupils), shape),
        error_bound=None if None in bounds else max(bound for bound in bounds if bound is not None),
        scale=np.reshape([float(one.scale) for one in found], shape),
    )


def weighted(psf: PSF, light: Array) -> PSF:
    """Return a stack whose values are multiplied by the light of each place, and its scale with them."""
    factor = np.asarray(light)[..., None, None].astype(psf.values.dtype)
    slopes = {name: slope * factor for name, slope in psf.derivatives.items()}
    assert math.prod(light.shape) == math.prod(psf.pupil.shape)
    return replace(psf, values=psf.values * factor, scale=psf.scale * light, derivatives=slopes)


class ApertureKeywords(TypedDict, total=False):
    """What says which aperture it is."""

    aperture: Pupil | None
    wavelength: float | None
    f_number: float | None
    obscuration: float | None


@dataclass(frozen=True)
class ApertureOptions:
    """What says which aperture it is, together.

    Parameters
    ----------
    aperture : Pupil, optional
        With a flat wavefront; such as ``lens.pupil(2.0).unaberrated()``. Its obscuration, spider, vignetting, mask,
        apodization and scale are those of the whole field; its geometry, which is known on the axis only, is not.
    wavelength, f_number, obscuration : float, optional
        As of :class:`lommel.Pupil`, for what `aperture` does not state.
    """

    aperture: Pupil | None = None
    wavelength: float | None = None
    f_number: float | None = None
    obscuration: float | None = None

    def bare(self) -> Pupil:
        """Return the pupil without wavefront.

        Raises
        ------
        TypeError, ValueError
            If the aperture is no pupil, has a wavefront, or contradicts what is stated beside it, or if that is out
            of range.
        """
        stated = {name: v for name, v in vars(self).items() if name != "aperture" and v is not None}
        if self.aperture is None:
            return Pupil(**stated)
        given: Pupil = validation.instance("aperture", self.aperture, Pupil)
        if not given.wavefront.flat:
            raise ValueError(
                "aperture must have a flat wavefront, for the map has those of all positions: give "
                "aperture.unaberrated(), and add its wavefront to the map where it is meant (field + wavefront)"
            )
        for name, value in stated.items():
            if (known := getattr(given, name)) not in (None, value):
                raise ValueError(f"{name} must be that of the aperture, {known:g}, or be left out, got {value!r}")
        return replace(given, geometry=None, **stated)


def bare_pupil(door: Callable[..., Any], given: Mapping[str, Any]) -> Pupil:
    """Return the pupil without wavefront of what `door` was given; TypeError for what it does not take."""
    options.require_known(door, given, ApertureKeywords)
    return ApertureOptions(**given).bare()


@dataclass(frozen=True, eq=False)
class FieldMap(Shaded):
    """Wavefronts known at some positions on the sensor, and smoothly in between.

    Made by :meth:`on_grid`, :meth:`scattered`, :meth:`radial` or :meth:`from_seidel`. Positions (x, y) are measured
    from the optical axis, x along rising columns and y along rising rows (downwards in a picture), in metres if the
    map has a wavelength, else in units of lambda*N. What is interpolated are the coefficients of the wavefronts,
    and at the given positions they come back but for rounding. A position beyond the map is refused.

    A map plus a wavefront is the map with that wavefront added everywhere, such as the defocus of an object.

    Attributes
    ----------
    pupil_without_wavefront : Pupil
        The aperture on the axis, and where there is no vignetting the same over the whole field.
    vignetting : Vignetting or None
        What narrows it off the axis; see :meth:`seen_through`.
    shading : Shading or None

    Notes
    -----
    A wavefront refers to the point of the sensor whose position it is given for: terms of tilt move the light in
    the window.

    Examples
    --------
    >>> field = FieldMap.from_seidel(20e-3, W131=2.0, W222=1.0, wavelength=550e-9, f_number=2.8)
    >>> field.pupil(10e-3, 0.0).wavefront == Wavefront.from_seidel(W131=2.0, W222=1.0, field=(0.5, 0.0))
    True
    """

    pupil_without_wavefront: Pupil
    _wavefronts: wavefronts.WavefrontsOnSensor
    _added: Wavefront
    vignetting: Vignetting | None = None
    shading: Shading | None = None

    @classmethod
    @shares(ApertureKeywords, ApertureOptions)
    def on_grid(
        cls,
        x: ArrayLike,
        y: ArrayLike,
        wavefront: Wavefront,
        **options: Unpack[ApertureKeywords],
    ) -> FieldMap:
        """Build a map from wavefronts on a rectangular grid, by bicubic splines.

        Parameters
        ----------
        x, y : array_like, shapes (columns,) and (rows,)
            Rising, at least two each. Along an axis of two or three positions the spline is linear or quadratic.
        wavefront : Wavefront of shape (rows, columns)
        {options}

        Returns
        -------
        FieldMap

        Raises
        ------
        TypeError, ValueError
            If positions are not finite or do not rise, or if the wavefronts are not one for each.
        """
        known = wavefronts.OnGrid(x, y, wavefront)
        return cls(bare_pupil(cls.on_grid, options), known, Wavefront())

    @classmethod
    @shares(ApertureKeywords, ApertureOptions)
    def scattered(
        cls,
        x: ArrayLike,
        y: ArrayLike,
        wavefront: Wavefront,
        **options: Unpack[ApertureKeywords],
    ) -> FieldMap:
        """Build a map from wavefronts at any positions, by radial basis functions (cubic, with a polynomial).

        The polynomial is quadratic where the positions determine one (six or more), so that field curvature,
        astigmatism and coma of third order are exact, else linear. The map ends at the convex hull.

        Parameters
        ----------
        x, y : array_like, shape (n,)
            3 to 4000 positions, all different, not all on one line.
        wavefront : Wavefront of shape (n,)
        {options}

        Returns
        -------
        FieldMap

        Raises
        ------
        TypeError, ValueError
            If positions are not finite, come twice or lie on a line, or if the wavefronts are not one for each.
        """
        known = wavefronts.Scattered(x, y, wavefront)
        return cls(bare_pupil(cls.scattered, options), known, Wavefront())

    @classmethod
    @shares(ApertureKeywords, ApertureOptions)
    def radial(
        cls,
        height: ArrayLike,
        wavefront: Wavefront,
        *,
        azimuth: float = 0.0,
        **options: Unpack[ApertureKeywords],
    ) -> FieldMap:
        """Build a map of a rotationally symmetric lens from wavefronts along one direction of the field.

        Along the height, coefficients are cubic splines with the parity that rotation by half a turn demands
        (even in the height for even m, odd for odd m); for other azimuths the wavefront is rotated exactly.
        Aberrations of third order are exact from three heights on.

        Parameters
        ----------
        height : array_like, shape (n,)
            Distances from the axis, rising from 0, at least two.
        wavefront : Wavefront of shape (n,)
            The first, on the axis, must be radially symmetric (to 1e-6 rad).
        azimuth : float, default 0
            Direction of these positions in radians, from x (0) to y (pi / 2, downwards in a picture).
        {options}

        Returns
        -------
        FieldMap

        Raises
        ------
        TypeError, ValueError
            If heights are not finite, do not rise or do not begin with 0, if the wavefronts are not one for each,
            or if that on the axis depends on the direction.
        """
        known = wavefronts.Radial(height, wavefront, azimuth)
        return cls(bare_pupil(cls.radial, options), known, Wavefront())

    @classmethod
    @shares(ApertureKeywords, ApertureOptions)
    def from_seidel(
        cls,
        edge: float,
        *,
        W020: float = 0.0,
        W040: float = 0.0,
        W060: float = 0.0,
        W080: float = 0.0,
        W131: float = 0.0,
        W222: float = 0.0,
        W220: float = 0.0,
        W311: float = 0.0,
        **options: Unpack[ApertureKeywords],
    ) -> FieldMap:
        """Build a map from Seidel coefficients in waves at the edge of the field.

        Parameters
        ----------
        edge : float
            Distance from the axis at which the coefficients hold (H = 1), and where the map ends.
        W020, W040, W060, W080, W131, W222, W220, W311 : float
            As of :meth:`lommel.Wavefront.from_seidel`, which is evaluated at each position.
        {options}

        Returns
        -------
        FieldMap

        Raises
        ------
        TypeError, ValueError
            If a coefficient is no number, `edge` is not above 0, or an option of the aperture is out of range.
        """
        waves = {"W020": W020, "W040": W040, "W060": W060, "W080": W080}
        waves |= {"W131": W131, "W222": W222, "W220": W220, "W311": W311}
        known = wavefronts.Seidel(edge, waves)
        return cls(bare_pupil(cls.from_seidel, options), known, Wavefront())

    @property
    def unit(self) -> str:
        """Unit of positions: ``"m"`` or ``"lambda*N"``."""
        return self.pupil_without_wavefront.unit

    @property
    def seidel(self) -> dict[str, float]:
        """Seidel coefficients in waves at :attr:`reach` of a map made of them, else none; without what was added."""
        return dict(self._wavefronts.waves) if isinstance(self._wavefronts, wavefronts.Seidel) else {}

    @property
    def reach(self) -> float:
        """Distance from the axis of the farthest position in the map."""
        return self._wavefronts.reach

    def __repr__(self) -> str:
        return f"<FieldMap, {self._wavefronts.limits(self.unit)}>"

    def __add__(self, other: object) -> FieldMap:
        """Return the map with one wavefront added everywhere."""
        if not isinstance(other, Wavefront):
            return NotImplemented
        if other.shape != ():
            raise ValueError(f"a single wavefront can be added to a map, got a stack of shape {other.shape}")
        return replace(self, _added=self._added + other)

    def pupil(self, x: ArrayLike, y: ArrayLike) -> Pupil:
        """Return the pupil that the position (x, y) of the sensor sees; arrays give a stack.

        Parameters
        ----------
        x, y : array_like
            Positions, in :attr:`unit`; they broadcast.

        Returns
        -------
        Pupil
            A stack of their shape.

        Raises
        ------
        TypeError, ValueError
            If a position is not finite or lies beyond the map; the message names it and the limits.
        """
        across, down = places(x, y)
        if across.size == 0:
            raise ValueError(f"x and y must not be empty, got shape {across.shape}")
        outside = ~self._wavefronts.contains(across, down)
        if outside.any():
            at = f"({across[outside].flat[0]:.6g}, {down[outside].flat[0]:.6g}) {self.unit}"
            limits = self._wavefronts.limits(self.unit)
            raise ValueError(f"position (x, y) = {at} lies outside of the map, {limits}")
        wavefront = self._wavefronts.wavefront(across, down) + self._added
        bare = self.pupil_without_wavefront
        pupil = replace(bare, wavefront=wavefront, colour=bare.colour and bare.colour.at(across, down))
        if self.vignetting is None:
            return pupil
        if across.shape != ():
            raise ValueError("x and y must be one place where vignetting changes the aperture; psf takes arrays")
        return replace(pupil, vignetting=self.vignetting.at(float(across), float(down)))

    def psf(
        self,
        x: ArrayLike,
        y: ArrayLike,
        shape: int | tuple[int, int],
        pixel: float | tuple[float, float],
        *,
        method: Method | None = None,
        **options: Any,
    ) -> PSF:
        """Compute the PSF at a position of the sensor; arrays of positions give a stack.

        Parameters
        ----------
        x, y : array_like
        shape, pixel, options
            As of :func:`lommel.psf`; the middle of the window is at the position.
        method : Method, optional
            By default what :func:`lommel.psf` takes by default.

        Returns
        -------
        PSF

        Raises
        ------
        TypeError, ValueError
            As :meth:`pupil` and :func:`lommel.psf`.
        """
        across, down = places(x, y)
        if self.vignetting is None or across.shape == ():
            return psf(self.pupil(x, y), shape, pixel, method=method, **options)
        pupils = [self.pupil(float(a), float(b)) for a, b in zip(across.flat, down.flat, strict=True)]
        return stacked(pupils, across.shape, lambda one: psf(one, shape, pixel, method=method, **options))

    def grid(
        self,
        rows: int,
        columns: int,
        *,
        sensor: tuple[float, float],
        shape: int | tuple[int, int],
        pixel: float | tuple[float, float],
        illuminated: bool = False,
        channels: Channels | Sequence[float] | None = None,
        depths: ArrayLike | None = None,
        lens: Lens | None = None,
        **options: Any,
    ) -> PSFGrid:
        """Compute PSFs over the sensor in one call: one for the centre of each of rows times columns equal cells.

        And, where they are asked for, at several distances of the object and in several channels.

        Parameters
        ----------
        rows, columns : int
            1 to 1000 each.
        sensor : (float, float)
            Height and width, centred on the axis, in the unit of positions.
        shape, pixel, options
            As of :meth:`psf`.
        illuminated : bool, default False
            Multiply the values of each PSF by the :meth:`illumination` of its place.
        channels : Channels or sequence of float, optional
            As of :func:`lommel.colour_psf`, with the lateral and axial colour of the lens that the aperture is of.
        depths : array_like, shape (k,), optional
            Distances of the object from the lens, metres; may be infinite.
        lens : Lens, optional
            With the focus of these distances, and without aberrations: the map has them.

        Returns
        -------
        PSFGrid

        Raises
        ------
        TypeError, ValueError
            As :meth:`psf` and :func:`lommel.colour_psf`; also if a centre lies outside of the map, or if one of
            `depths` and `lens` is missing, or the lens has other light than the map.
        """
        if (depths is None) != (lens is None):
            missing = "lens" if lens is None else "depths"
            raise ValueError(f"{missing} is missing: they go together, for the lens has the defocus of each distance")
        counts = [validation.integer(n, v, least=1, most=1000) for n, v in (("rows", rows), ("columns", columns))]
        height_width = sides(sensor, self.unit)
        # Exactly symmetric, so that the middle one of an odd number is on the axis.
        y, x = (np.asarray(s / n * (np.arange(n) - 0.5 * (n - 1))) for s, n in zip(height_width, counts, strict=True))
        lit = validation.truth("illuminated", illuminated)
        if named := [name for name, value in (("channels", channels), ("depths", depths)) if value is not None]:
            if self.vignetting is not None or lit:
                raise ValueError(
                    f"{' and '.join(named)} must be left out where vignetting changes the aperture or values are "
                    "weighted by the illumination; ask channel by channel, or multiply by illumination(x, y)"
                )
            pupil, distances = self.pupil(x, y[:, None]), None
            if depths is not None and lens is not None:
                pupil = at_depths(pupil, lens, depths)
                distances = np.atleast_1d(np.asarray(depths, dtype=np.float64))
            made: PSF | ColourPSF
            if channels is None:
                made = psf(pupil, shape, pixel, **options)
            else:
                made = colour_psf(pupil, shape, pixel, channels, **options)
            return PSFGrid(made, x, y, height_width, distances)
        alone = self.psf(x, y[:, None], shape, pixel, **options)
        if lit:
            alone = weighted(alone, np.asarray(self.illumination(x, y[:, None])))
        return PSFGrid(alone, x, y, height_width)
