"""Lens and camera that a lens file describes."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, TypedDict

import numpy as np
from numpy.typing import ArrayLike

from lommel.base import validation
from lommel.base.arrays import Json
from lommel.base.units import format_length
from lommel.optics.lens import Lens
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from lommel.field.maps import FieldMap
    from lommel.optics.colour.spectrum import Channels
    from lommel.optics.pupil import Pupil
    from lommel.psf import PSF


@dataclass(frozen=True)
class Camera:
    """Camera sensor, for example from a file with a section [camera].

    `read`, `full_well`, `gain` and `offset` are None if the file does not state them.

    Attributes
    ----------
    name, source : str
        Name of the camera, and source of its numbers.
    pixel : float or (float, float)
        Pixel pitch, metres: one number for square pixels, else (height, width).
    read : float or None
        Read noise, rms electrons.
    full_well : float or None
        Electrons at which a pixel saturates.
    gain : float or None
        Electrons per count (e-/ADU).
    offset : float or None
        Counts of a pixel without electrons.
    excess : float
        Excess noise factor of electron multiplication, as in :class:`lommel.Noise`; 1 without multiplication.

    Examples
    --------
    >>> import lommel as lm
    >>> camera = lm.Camera("mine", "data sheet", 6.5e-6, read=1.6, full_well=3e4, gain=0.46, offset=100.0, excess=1.0)
    >>> camera.noise.read
    1.6
    """

    name: str
    source: str
    pixel: float | tuple[float, float]
    read: float | None = None
    full_well: float | None = None
    gain: float | None = None
    offset: float | None = None
    excess: float = 1.0

    def __repr__(self) -> str:
        pixel = (
            format_length(self.pixel) if isinstance(self.pixel, float) else " x ".join(map(format_length, self.pixel))
        )
        noise = "" if self.read is None else f", read noise {self.read:g} electrons"
        well = "" if self.full_well is None else f", full well {self.full_well:g} electrons"
        excess = "" if self.excess == 1.0 else f", excess noise {self.excess:g}"
        return f"<Camera {self.name!r}: pixels of {pixel}{noise}{well}{excess}>"

    def to_dict(self) -> Json:
        """Return all attributes except the pixel pitch as plain data.

        Returns
        -------
        dict
            Values by attribute name.
        """
        return {name: value for name, value in vars(self).items() if name != "pixel"}

    @property
    def side(self) -> float:
        """Pitch of square pixels, metres; ValueError for other pixels."""
        if not isinstance(self.pixel, float):
            raise ValueError(f"pixels must be square, got {self.pixel} m for {self.name!r}")
        return self.pixel

    @property
    def noise(self) -> Noise:
        """Noise model of images in counts; by default the gain is 1 electron per count and the offset is 0.

        Returns
        -------
        Noise
            Noise model with gain, read noise, offset and excess noise factor.

        Raises
        ------
        ValueError
            If the file does not state the read noise.
        """
        if self.read is None:
            raise ValueError(f"the file of {self.name!r} must state read, the read noise, for a noise model")
        return Noise(white=self.gain, read=self.read, offset=self.offset or 0.0, excess=self.excess)


@dataclass(frozen=True)
class Calibration:
    """Calibration of a lens by :meth:`lommel.imaging.FocalCalibration.save`.

    Attributes
    ----------
    focus_distances, f_numbers : tuple of float
        Focus distance (metres) and engraved f-number of each photograph.
    f_number_scale : float
        True f-number / engraved f-number.
    f_number_error, focus_error : float
        Relative standard error of f-numbers, and standard error of 1 / focus distance, 1/m.
    """

    focus_distances: tuple[float, ...]
    f_numbers: tuple[float, ...]
    f_number_scale: float
    f_number_error: float
    focus_error: float

    @property
    def errors(self) -> dict[str, float]:
        """The standard errors by name."""
        return {"f_number_error": self.f_number_error, "focus_error": self.focus_error}


_FAR_INFRARED = (1e-4, 2.5e-3)  # wavelengths in metres, which in nanometres are those of visible and infrared light


def tell_wavelength(wavelength: float) -> None:
    """Issue a note on a stated wavelength in the far infrared, which is probably in nanometres."""
    if _FAR_INFRARED[0] <= wavelength <= _FAR_INFRARED[1]:
        text, likely = format_length(wavelength), format_length(1e-3 * wavelength)
        validation.tell(
            f"The wavelength, {text}, is in the far infrared, and all results are for it; was it {likely}?"
        )


_MAX_SHOWN = 129  # largest side in pixels of the PSF shown in notebooks


class PixelOptions(TypedDict):
    """Arguments of :func:`lommel.psf` that describe pixels, without the pitch."""

    integrate: bool | None
    fill: tuple[float, float]


@dataclass(frozen=True)
class Instrument:
    """Lens with object and sensor, for example from a lens file.

    Attributes
    ----------
    name, source : str
        Name of the lens, and source of its numbers.
    lens : Lens
        Lens with its on-axis aberrations.
    object_distance : float
        Object distance in metres.
    pixel : float or (float, float)
        Pixel pitch, metres: one number for square pixels, else (height, width).
    shape : tuple of int, or None
        Height and width of the window in pixels; None if the file does not state them; see :attr:`window`.
    radii : dict of str to float
        Radii on the sensor (metres) for encircled energies; keys are the texts in the file.
    sensor : tuple of float, or None
        Height and width of the whole sensor, metres; None if the file has no section [field].
    aberrations_of_field : FieldMap, or None
        Field-dependent aberrations, which are added to the aberrations of `lens`.
    place : (float, float)
        Position on the sensor, metres from its middle right and down, of :meth:`pupil` and of all measures; by
        default the axis.
    integrate : bool or None
        Pixel-integrated or point-sampled values, as in :func:`lommel.psf`; None if not stated.
    fill : (float, float)
        Active fractions of the height and the width of a pixel.
    channels : Channels or None
        Colour channels of the sensor, if the file states them.
    camera : Camera or None
        Camera, if the file names one.
    calibration : Calibration or None
        Calibration of foci and f-numbers for depth from defocus, if the file has one.

    Examples
    --------
    A lens with its sensor, without a file:

    >>> import dataclasses
    >>> import lommel as lm
    >>> lens = lm.Lens(focal_length=50e-3, f_number=2.8, focus_distance=2.0, wavelength=550e-9)
    >>> corners = lm.FieldMap.from_seidel(22e-3, W131=1.0, aperture=lens.pupil().unaberrated())
    >>> mine = lm.Instrument(
    ...     "mine",
    ...     "",
    ...     lens,
    ...     2.0,
    ...     4e-6,
    ...     (33, 33),
    ...     {},
    ...     sensor=(24e-3, 36e-3),
    ...     integrate=True,
    ...     fill=(0.9, 0.9),
    ...     aberrations_of_field=corners,
    ...     channels=lm.Channels.rgb(),
    ...     camera=None,
    ... )
    >>> lm.psf(mine.field().pupil(18e-3, 12e-3), mine.window, mine.pixel, **mine.sensor_options).shape
    (33, 33)
    >>> corner = dataclasses.replace(mine, place=(18e-3, 12e-3))
    >>> round(lm.strehl(mine.pupil()), 3), round(lm.strehl(corner.pupil()), 3)
    (1.0, 0.1)
    """

    pupil_hint = "an Instrument; instrument.pupil() is its pupil"

    name: str
    source: str
    lens: Lens
    object_distance: float
    pixel: float | tuple[float, float]
    shape: tuple[int, int] | None
    radii: dict[str, float] = field(hash=False)
    sensor: tuple[float, float] | None = None
    aberrations_of_field: FieldMap | None = field(default=None, repr=False)
    place: tuple[float, float] = field(default=(0.0, 0.0), kw_only=True)
    integrate: bool | None = None
    fill: tuple[float, float] = (1.0, 1.0)
    channels: Channels | None = None
    camera: Camera | None = None
    calibration: Calibration | None = None

    def __repr__(self) -> str:
        pixel = " x ".join(format_length(side) for side in dict.fromkeys(self.pitch))
        distance = format_length(self.object_distance)
        over_field = (
            "" if self.aberrations_of_field is None else f", aberrations over the field, {self.place_in_words}"
        )
        return f"<Instrument {self.name!r}: {self.lens!r}, object at {distance}, pixels of {pixel}{over_field}>"

    def _repr_html_(self) -> str:
        # Late: commands print their help without plots and measures.
        from lommel.show import notebook
        from lommel.show.drawing import length_in_words, name_in_words, true_minus

        lens = self.lens
        obscuration = f", obscuration {lens.obscuration:.4g}" if lens.obscuration else ""
        pixel = " × ".join(length_in_words(side) for side in dict.fromkeys(self.pitch))
        sensor = None if self.sensor is None else " × ".join(length_in_words(side) for side in self.sensor)

        def waves() -> str:
            terms = list(self.pupil().wavefront.waves.items())[:4]
            return true_minus(", ".join(f"{name} = {float(value):.4g}" for name, value in terms))

        def strehl_text() -> str:
            from lommel.measures.aperture_means import strehl

            return f"{float(strehl(self.pupil())):.4g} {self.place_in_words}"

        rows: list[notebook.Row] = [
            ("lens", f"f = {length_in_words(lens.focal_length)}, f/{lens.f_number:.4g}{obscuration}"),
            ("wavelength", length_in_words(lens.wavelength)),
            ("focused at", length_in_words(lens.focus_distance)),
            ("object at", length_in_words(self.object_distance)),
            ("pixels", pixel),
            ("sensor", sensor),
            ("aberrations (waves)", waves),
            ("Strehl ratio", strehl_text),
            ("radii of interest", ", ".join(self.radii) or None),
            ("channels", None if self.channels is None else ", ".join(self.channels.names)),
            ("source", self.source or None),
        ]

        def image() -> PSF:
            from lommel.psf import psf

            height, width = self.window
            shape = min(height, _MAX_SHOWN), min(width, _MAX_SHOWN)
            return psf(self.pupil(), shape, self.pixel, **self.sensor_options)

        return notebook.device(f"Instrument: {name_in_words(self.name)}", rows, image)

    @property
    def pitch(self) -> tuple[float, float]:
        """Pixel pitch from row to row and from column to column, metres."""
        return (self.pixel, self.pixel) if isinstance(self.pixel, float) else self.pixel

    @property
    def side(self) -> float:
        """Pitch of square pixels with a fill factor of 1; ValueError for other pixels."""
        if not isinstance(self.pixel, float) or self.fill != (1.0, 1.0):
            raise ValueError(
                f"pixels must be square with a fill factor of 1, got pixel={self.pixel}, fill={self.fill}"
            )
        return self.pixel

    @property
    def sensor_options(self) -> PixelOptions:
        """Arguments of :func:`lommel.psf` that describe pixels, without the pitch."""
        return {"integrate": self.integrate, "fill": self.fill}

    @property
    def window(self) -> tuple[int, int]:
        """Height and width of the window: `shape`, or a square of 33 to 1025 pixels for about 98 % of the light."""
        return self.shape or (max(33, min(wide_enough(self.pupil(), min(self.pitch)), 1025)),) * 2

    @property
    def place_in_words(self) -> str:
        """The position of :meth:`pupil` on the sensor, such as "on the axis"."""
        if self.place == (0.0, 0.0):
            return "on the axis"
        return f"{' and '.join(map(format_length, self.place))} from the middle of the sensor"

    @property
    def lens_at_place(self) -> Lens:
        """The lens, with the field-dependent aberrations at `place` added to its own."""
        if self.aberrations_of_field is None:
            if self.place != (0.0, 0.0):
                self.field()  # raises ValueError
            return self.lens
        try:
            added = self.aberrations_of_field.pupil(*self.place).wavefront
        except ValueError as error:
            raise ValueError(f"place={self.place} must lie in the map of {self.name!r}: {error}") from None
        return replace(self.lens, aberrations=self.lens.aberrations + added) if added.edge.any() else self.lens

    def pupil(self, object_distance: ArrayLike | None = None) -> Pupil:
        """Return the pupil at `place`, by default on the axis, with the aberrations of the lens and of the field.

        :meth:`field` has the pupils at other positions.

        Parameters
        ----------
        object_distance : array_like, optional
            Distance of the object, metres, or an array for a stack; by default that of the instrument.

        Returns
        -------
        Pupil
            Pupil with the aberrations of the lens and of the field at `place`.

        Raises
        ------
        TypeError, ValueError
            On the conditions of :meth:`lommel.Lens.pupil`, or if the section [field] does not contain `place`.
        """
        pupil = self.lens_at_place.pupil(self.object_distance if object_distance is None else object_distance)
        if self.aberrations_of_field is None:
            return pupil
        if pupil.colour is not None:
            pupil = replace(pupil, colour=pupil.colour.at(*(np.broadcast_to(p, pupil.shape) for p in self.place)))
        vignetting = self.aberrations_of_field.vignetting
        return pupil if vignetting is None else vignetting.applied(pupil, *self.place)

    def field(self) -> FieldMap:
        """Return the aberrations over the field, including the aberrations of `lens`, for `object_distance`.

        Returns
        -------
        FieldMap
            Sum of on-axis and field-dependent aberrations.

        Raises
        ------
        ValueError
            If the file has no section [field].
        """
        if self.aberrations_of_field is None:
            raise ValueError(f"the lens file of {self.name!r} must have a section [field] for PSFs over the field")
        pupil = self.lens.pupil(self.object_distance)
        aperture = pupil.carrying(Wavefront(), None)
        return replace(self.aberrations_of_field, pupil_without_wavefront=aperture) + pupil.wavefront


def wide_enough(pupil: Pupil, pixel: float) -> int:
    """Return the side, in pixels (odd), of a square around the axis that contains about 98 % of the light."""
    # Diffraction spreads about the fraction 2 / (pi^2 x (1 - obscuration)) of the light farther than x lambda*N
    # beyond the geometric blur.
    margin = 10.0 * pupil.scale / (1.0 - pupil.obscuration)
    return 2 * min(math.ceil((float(pupil.geometric_radius()) + margin) / pixel), validation.MAX_SIDE // 2 - 1) + 1
