"""A physical lens: focal length, stop and focus (paper, Eq. 1-3)."""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lommel.base import display, validation
from lommel.base.cached import cached_property, changed
from lommel.base.units import format_length
from lommel.optics.aperture.apodization import Apodization, illumination
from lommel.optics.aperture.mask import Mask
from lommel.optics.aperture.shapes import CatEye, Ellipse, Segments, Shape, Spider
from lommel.optics.base_pupil import Geometry, object_distances
from lommel.optics.colour.dispersion import Colour, PupilColour
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront import wavefront
from lommel.optics.wavefront.wavefront import Wavefront, same_path
from lommel.special import zernike


def aperture(focal_length: float, f_number: float | None, aperture_diameter: float | None) -> float:
    """Return the aperture diameter, metres, from exactly one of the f-number and the diameter."""
    if (f_number is None) == (aperture_diameter is None):
        raise ValueError(
            "give exactly one of f_number and aperture_diameter, "
            f"got f_number={f_number!r}, aperture_diameter={aperture_diameter!r}"
        )
    if f_number is not None:
        diameter = focal_length / validation.real("f_number", f_number, above=0.0)
    else:
        diameter = validation.real("aperture_diameter", aperture_diameter, above=0.0, unit="metres")
    name = "aperture_diameter, focal_length / f_number,"
    return validation.real(name, diameter, least=1e-12, below=1e6, unit="metres")


def sensor(focal_length: float, focus_distance: float | None, sensor_distance: float | None) -> float:
    """Return the sensor distance, metres, from `focus_distance` (by default infinity) or `sensor_distance`."""
    if focus_distance is not None and sensor_distance is not None:
        raise ValueError(
            "give at most one of focus_distance and sensor_distance, "
            f"got focus_distance={focus_distance!r}, sensor_distance={sensor_distance!r}"
        )
    if sensor_distance is not None:
        return validation.real("sensor_distance", sensor_distance, above=0.0, unit="metres")
    s = math.inf if focus_distance is None else focus_distance
    s = validation.real("focus_distance", s, above=0.0, infinite=True, unit="metres")
    if s <= focal_length:
        hint = f"; for {focal_length:g} mm give {focal_length:g}e-3" if focal_length > _MAX_FOCAL_LENGTH else ""
        raise ValueError(
            f"focus_distance must exceed the focal length {focal_length:g} m (no real image otherwise), "
            f"got {s:g}{hint}"
        )
    return 1.0 / (1.0 / focal_length - 1.0 / s)


MODELS = ("paraxial", "aplanatic")
CORRECTED_FOR = ("object", "focus")
_MAX_FOCAL_LENGTH = 1.0  # metres, without a warning; longer photographic lenses are mirrors with an obscuration
_VISIBLE = (380e-9, 780e-9)  # metres
_PUPIL_FIELDS = ("obscuration", "wavelength", "spider", "vignetting", "mask", "stop")
_Numbers = float | NDArray[np.float64]


@dataclass(frozen=True, init=False, repr=False)
class Lens(display.Shown):
    """A thin lens with its stop at the lens; all lengths in metres, distances measured from the lens.

    Parameters
    ----------
    focal_length : float
        Focal length, metres; positive.
    f_number, aperture_diameter : float
        Exactly one of the two: focal length divided by aperture diameter, or the aperture diameter in metres.
    focus_distance, sensor_distance : float
        At most one: the object distance in focus (default infinity; must exceed the focal length), or the
        distance of the sensor behind the lens.
    wavelength : float
        Wavelength, metres.
    obscuration : float, default 0
        Radius of the central obscuration divided by the radius of the aperture.
    aberrations : Wavefront, default none
        Wavefront that is added to the defocus of every object distance.
    spider, vignetting, mask, stop : optional
        Aperture, as for :class:`lommel.Pupil`; phases of segments at the wavelength of the lens.
    model : {"paraxial", "aplanatic"}, default "paraxial"
        "paraxial": spheres are approximated by parabolas (the paper's Eq. 1-3). "aplanatic": the exact path
        difference between reference spheres of a lens that obeys Abbe's sine condition. Rays reach the axial point of
        the sensor at an angle theta whose sine is rho times ``aperture radius / sensor distance`` (1 / 2N, N the
        working f-number).
    corrected_for : {"object", "focus"}, default "object"
        Conjugate at which an aplanatic lens is free of aberration; the conditions of Abbe and Herschel cannot both
        hold. "object": images of objects at all distances are free of aberration; the reference spheres are centred
        on the image and on the axial point of the sensor. "focus": the image of the point in focus is free of
        aberration, as in microscopes; the reference spheres are centred on the object and on the point in focus, from
        which rays leave at an angle whose sine is rho times ``aperture radius / focus distance``.
    apodization : float, Apodization or "aplanatic", default 0
        Amplitude across the pupil, as for :class:`lommel.Pupil`. "aplanatic", for an aplanatic lens only, is
        ``cos(theta)^(-1/2)``: the amplitude ``cos(theta)^(1/2)`` of a uniformly illuminated entrance pupil on the
        reference sphere, divided by the factor ``cos(theta)`` of the solid angle (Richards and Wolf 1959,
        scalar part, doi:10.1098/rspa.1959.0200). Light of an isotropic emitter has the same amplitude.
    colour : Colour, optional
        Axial and lateral colour: how focal length and size of the image change with the wavelength.

    Raises
    ------
    TypeError, ValueError
        If an argument is missing, contradictory, not finite or out of range.

    Notes
    -----
    ``dataclasses.replace(lens, aberrations=wavefront)`` is the same lens with another wavefront. Other arguments are
    replaced likewise, except `f_number` and `focus_distance`: replace ``aperture_diameter`` and ``sensor_distance``
    instead, or use :meth:`stopped` and :meth:`focused`.

    Warns
    -----
    UserWarning
        If the focal length is above 1 metre, with an f-number, visible light and no obscuration: it may have been
        given in millimetres.

    Examples
    --------
    >>> lens = Lens(focal_length=50e-3, f_number=1.8, focus_distance=2.0, wavelength=550e-9)
    >>> lens
    <Lens 50 mm f/1.8, focused at 2 m, 550 nm>
    >>> round(float(lens.defocus(1.5)), 2)
    91.82
    """

    pupil_hint = "a Lens; lens.pupil(object_distance) is its pupil"  # in errors where a Pupil is expected

    focal_length: float
    aperture_diameter: float
    sensor_distance: float
    wavelength: float
    obscuration: float
    aberrations: Wavefront = field(repr=False)
    spider: Spider | None
    vignetting: Ellipse | CatEye | None
    mask: Mask | None
    stop: Shape | Segments | None
    model: str
    corrected_for: str
    apodization: float | Apodization | str
    colour: Colour | None

    def __init__(
        self,
        *,
        focal_length: float,
        wavelength: float,
        f_number: float | None = None,
        aperture_diameter: float | None = None,
        focus_distance: float | None = None,
        sensor_distance: float | None = None,
        obscuration: float = 0.0,
        aberrations: Wavefront | None = None,
        spider: Spider | None = None,
        vignetting: Ellipse | CatEye | None = None,
        mask: Mask | None = None,
        stop: Shape | Segments | None = None,
        model: str = "paraxial",
        corrected_for: str = "object",
        apodization: float | Apodization | str = 0.0,
        colour: Colour | None = None,
    ) -> None:
        f = validation.real("focal_length", focal_length, above=0.0, unit="metres")
        diameter = aperture(f, f_number, aperture_diameter)
        d = sensor(f, focus_distance, sensor_distance)
        if diameter > (2.0 + 1e-9) * max(f, d):
            raise ValueError(
                "f_number, focal_length / aperture_diameter, must be >= 0.5, the limit in air (the sine of the "
                f"marginal ray, 1 / 2N, is at most 1), got f/{f / diameter:.4g}, an aperture of "
                f"{format_length(diameter)}; perhaps 1 / N was given, or millimetres instead of metres"
            )
        if aberrations is None:
            aberrations = Wavefront()
        if isinstance(apodization, str) and apodization != "aplanatic":
            got = validation.shown(apodization)
            raise ValueError(f"apodization must be a number, an Apodization or 'aplanatic', got {got}")
        if isinstance(apodization, str) and model != "aplanatic":
            raise ValueError("apodization 'aplanatic' needs model='aplanatic': a paraxial lens has no angles")
        if not isinstance(apodization, str | Apodization):
            apodization = illumination(apodization).slope
        vars(self).update(
            focal_length=f,
            aperture_diameter=diameter,
            sensor_distance=d,
            wavelength=validation.wavelength(wavelength),
            obscuration=validation.real("obscuration", obscuration, least=0.0, below=1.0),
            aberrations=validation.instance("aberrations", aberrations, Wavefront),
            spider=spider,
            vignetting=vignetting,
            mask=mask,
            stop=stop,
            model=validation.choice("model", model, MODELS),
            corrected_for=validation.choice("corrected_for", corrected_for, CORRECTED_FOR),
            apodization=apodization,
            colour=colour,
        )
        validation.optional("colour", colour, Colour)
        # Shapes that leave nothing clear raise ValueError here, not at the first pupil.
        Pupil(obscuration=self.obscuration, spider=spider, vignetting=vignetting, mask=mask, stop=stop)
        in_visible = _VISIBLE[0] <= self.wavelength <= _VISIBLE[1]
        if f > _MAX_FOCAL_LENGTH and f_number is not None and in_visible and not self.obscuration:
            warnings.warn(
                f"focal_length={f:g} is {f:g} metres; for {f:g} mm give focal_length={f:g}e-3. For a telescope give "
                "aperture_diameter instead of f_number",
                stacklevel=2,
            )
        if model == "aplanatic":
            self.phase(0.0)  # ValueError if the sine condition excludes the rim
        self.pupil_colour  # noqa: B018 (ValueError now for a wavelength beyond the table)

    def __repr__(self) -> str:
        focus = self.focus_distance
        sensor_text = f"sensor at {format_length(self.sensor_distance)}"
        parts = [f"focused at {format_length(focus)}" if focus > 0.0 else sensor_text, format_length(self.wavelength)]
        parts += [f"obscuration {self.obscuration:.4g}"] if self.obscuration else []
        parts += [f"aplanatic, corrected for the {self.corrected_for}"] if self.model == "aplanatic" else []
        parts += ["apodized"] if not self.illumination.uniform else []
        parts += [] if self.aberrations.flat else ["aberrated"]
        parts += [
            name for name in ("spider", "vignetting", "mask", "stop", "colour") if getattr(self, name) is not None
        ]
        return f"<Lens {format_length(self.focal_length)} f/{self.f_number:.4g}, {', '.join(parts)}>"

    @property
    def f_number(self) -> float:
        """Focal length divided by aperture diameter, as engraved on the lens."""
        return self.focal_length / self.aperture_diameter

    @property
    def working_f_number(self) -> float:
        """Sensor distance divided by aperture diameter: the N of lambda*N."""
        return self.sensor_distance / self.aperture_diameter

    @property
    def focus_distance(self) -> float:
        """Object distance in focus, metres; infinite or negative if the sensor is at or inside the focal plane."""
        # A sensor in the focal plane, up to rounding errors, has infinity in focus, not 1e16 metres.
        vergence = 1.0 / self.focal_length - 1.0 / self.sensor_distance
        return math.inf if abs(vergence) < 1e-15 / self.focal_length else 1.0 / vergence

    def focused(self, focus_distance: float) -> Lens:
        """Return the lens focused at `focus_distance`, metres, by moving the sensor; infinity is allowed.

        TypeError or ValueError unless the distance is a number above the focal length.
        """
        s = validation.real("focus_distance", focus_distance, above=0.0, infinite=True, unit="metres")
        changes: dict[str, Any] = {"focus_distance": s, "sensor_distance": None}
        return replace(self, **changes)

    def stopped(self, f_number: float) -> Lens:
        """Return the lens stopped down to another f-number, as engraved, with the sensor in place.

        The wavefront and the amplitude are restricted to the central part of the aperture. Obscuration and vanes keep
        their size, which is larger relative to the smaller radius.

        Parameters
        ----------
        f_number : float
            Focal length divided by aperture diameter.

        Raises
        ------
        TypeError, ValueError
            If the f-number is not a positive number, if the obscuration covers the aperture, if a lens with
            aberrations or an Apodization would be opened wider, or if the lens has vignetting, a mask or a stop of
            another shape.
        """
        new_f_number = validation.real("f_number", f_number, least=1e-6, below=1e12)
        ratio = new_f_number / self.f_number
        if self.vignetting or self.mask or self.stop:
            raise ValueError(
                "f_number of a lens with vignetting, a mask or a stop of another shape cannot change, since these "
                "are relative to the radius of the aperture; make a lens with the parts for the other f-number"
            )
        apodization, unaberrated = self.apodization, not self.aberrations.edge.any()
        has_profile = isinstance(apodization, Apodization) and not apodization.uniform
        for has_data, part in ((not unaberrated, "aberrations are"), (has_profile, "apodization is")):
            if has_data and ratio < 1.0 - 1e-9:
                raise ValueError(
                    f"f_number must be at least that of the lens, f/{self.f_number:g}, up to which its {part} known, "
                    f"got f/{new_f_number:g}"
                )
        if isinstance(apodization, Apodization):
            apodization = apodization.scaled(min(1.0, 1.0 / ratio)) if has_profile else apodization
        elif isinstance(apodization, float):
            # exp(-g rho^2) stays the same in metres: if the radius is divided by `ratio`, g is divided by its square.
            apodization = apodization / ratio**2
        return replace(
            self,
            aperture_diameter=aperture(self.focal_length, new_f_number, None),
            apodization=apodization,
            # The same size in metres, relative to a smaller radius.
            obscuration=self.obscuration * ratio,
            aberrations=self.aberrations if unaberrated else self.aberrations.scaled(min(1.0, 1.0 / ratio)),
            spider=self.spider and replace(self.spider, width=self.spider.width * ratio),
        )

    def in_light(self, wavelength: float) -> Lens:
        """Return the lens at another `wavelength`, metres, with the focal length that its colour defines.

        Sensor, stop and the path differences of the aberrations do not change. TypeError or ValueError if the
        wavelength is out of range or beyond the table of the colour.
        """
        wave, colour = validation.wavelength(wavelength), self.pupil_colour
        stop = self.stop
        return replace(
            self,
            wavelength=wave,
            # Phases of segments are path differences, in radians inversely proportional to the wavelength.
            stop=stop.scaled(self.wavelength / wave) if isinstance(stop, Segments) else stop,
            focal_length=self.focal_length if colour is None else colour.focal_length + colour.table.shift(wave),
            aberrations=same_path(self.aberrations, self.wavelength, wave),
            # The cosine depends on angles only, which are the same at all wavelengths.
            apodization=self.illumination if isinstance(self.apodization, str) else self.apodization,
        )

    def defocus(self, object_distance: ArrayLike | None = None) -> NDArray[np.float64]:
        """Return the defocus coefficient C_d of objects, radians, by default of an object in focus.

        ``2 C_d = (pi / lambda) (1/d - 1/f + 1/s) R_max^2`` (paper, Eq. 3, for an object at the distance s). Positive
        if the sensor, at d, lies between the lens and the image. Paraxial, without the aberrations of the lens.

        Parameters
        ----------
        object_distance : array_like, optional
            Object distances, metres from the lens; may be infinite.

        Returns
        -------
        ndarray
            C_d, with the shape of `object_distance`.

        Raises
        ------
        TypeError, ValueError
            If a distance is not above 0, or if none is given and no object is in focus.
        """
        return np.asarray(self._defocus(self._object_distance(object_distance)))

    # Python floats for a single object: half the time of NumPy scalars.
    def _defocus(self, s: _Numbers) -> _Numbers:
        vergence, waves, area = self._defocus_parts
        return waves * (vergence + 1.0 / s) * area

    @cached_property
    def _defocus_parts(self) -> tuple[float, float, float]:
        """Terms of C_d without the object distance: vergence, pi / (2 lambda) and the squared radius."""
        # Eq. 3 of the paper.
        vergence = 1.0 / self.sensor_distance - 1.0 / self.focal_length
        return vergence, math.pi / (2.0 * self.wavelength), (0.5 * self.aperture_diameter) ** 2

    def phase(self, defocus: ArrayLike) -> Wavefront:
        """Return the wavefront of a `defocus` C_d (radians, of any shape), without the aberrations of the lens.

        For an aplanatic lens the wavefront consists of the Zernike terms of the exact path difference, with an error
        bound; see :func:`lommel.optics.wavefront.wavefront.expansion`. TypeError or ValueError if C_d is not finite
        or beyond the range of the expansion.
        """
        return self._phase(validation.real_array("defocus", defocus, unit="radians"))

    def _phase(self, c: _Numbers) -> Wavefront:
        if self.model == "paraxial":
            return Wavefront.of_defocus(c)
        c = np.asarray(c)
        radius = 0.5 * self.aperture_diameter
        # C_d = pi R_max^2 delta / (2 lambda), solved for the vergence delta.
        vergence = 2.0 * self.wavelength / (math.pi * radius**2) * c
        return wavefront.wavefront(radius, self._geometry.sphere, vergence, self.wavelength)

    def phase_rate(self, reach: float) -> float:
        """Return a bound on (range of Im(phase) across the pupil) / Im(C_d), for abs(C_d) up to `reach` radians.

        The bound is 2 for a paraxial lens, slightly more for an aplanatic lens, infinite if none is known.
        """
        if self.model == "paraxial":
            return 2.0
        radius = 0.5 * self.aperture_diameter
        vergence = 2.0 * self.wavelength / (math.pi * radius**2)
        return 4.0 / radius**2 * wavefront.growth(radius, self._geometry.sphere, vergence * reach)

    @property
    def illumination(self) -> Apodization:
        """Amplitude across the pupil."""
        if not isinstance(self.apodization, str):
            return illumination(self.apodization)
        # (cos theta)^(-1/2) with the sine condition sin theta = rho R_max / d on the reference sphere.
        return Apodization.cosine(0.5 * self.aperture_diameter * abs(self._geometry.sphere), -0.5)

    @cached_property
    def _geometry(self) -> Geometry:
        radius = 0.5 * self.aperture_diameter
        return Geometry(radius, self.focal_length, self.sensor_distance, (), self.model, self.corrected_for)

    def pupil(self, object_distance: ArrayLike | None = None) -> Pupil:
        """Return the pupil for an object at `object_distance`; an array gives a stack of pupils.

        Parameters
        ----------
        object_distance : array_like, optional
            Object distances, metres from the lens; may be infinite. By default the distance in focus.

        Raises
        ------
        TypeError, ValueError
            If a distance is not above 0 or does not broadcast with the aberrations, or if no distance is given and no
            object is in focus.
        """
        s = self._object_distance(object_distance)
        wavefront = self._phase(self._defocus(s))
        if not self.aberrations.flat:
            try:
                wavefront = wavefront + self.aberrations
            except ValueError:
                shapes = f"{np.shape(s)} and {self.aberrations.shape}"
                raise ValueError(
                    f"object_distance must broadcast with the aberrations, got shapes {shapes}"
                ) from None
        # A single pupil, the most frequent case, needs no arrays.
        single = isinstance(s, float) and not wavefront.shape
        distances = (s,) if single else tuple(np.broadcast_to(s, wavefront.shape).ravel().tolist())
        return self._in_focus.carrying(wavefront, changed(self._geometry, object_distance=distances))

    @cached_property
    def _in_focus(self) -> Pupil:
        """Unaberrated pupil, copied with another wavefront for each object."""
        settings = {name: getattr(self, name) for name in _PUPIL_FIELDS}
        return Pupil(
            f_number=self.working_f_number,
            apodization=self.illumination if isinstance(self.apodization, str) else self.apodization,
            geometry=self._geometry,
            colour=self.pupil_colour,
            **settings,
        )

    @cached_property
    def pupil_colour(self) -> PupilColour | None:
        """Change of the pupils with the wavelength."""
        if self.colour is None:
            return None
        focal = self.focal_length - self.colour.shift(self.wavelength)
        return PupilColour(self.colour, focal, 0.5 * self.aperture_diameter, self.model)

    def _object_distance(self, value: ArrayLike | None) -> _Numbers:
        if value is None:
            value = focus = self.focus_distance
            if focus < 0.0:
                raise ValueError(
                    "object_distance must be given: no object is in focus, since the sensor at "
                    f"{self.sensor_distance:g} m lies inside the focal plane at {self.focal_length:g} m"
                )
        return object_distances(value)


def require_round(name: str, lens: Lens) -> None:
    """Raise ValueError unless a lens, called `name`, has one set of radially symmetric PSFs."""
    if lens.aberrations.shape != ():
        raise ValueError(f"{name} must have one set of aberrations, got a stack of shape {lens.aberrations.shape}")
    if not lens.aberrations.radial:
        terms = lens.aberrations.to_zernike()
        kinds = list(dict.fromkeys(zernike.name(n, m) for (n, m), c in terms.items() if m and c))
        more = f" and {len(kinds) - 4} more" if len(kinds) > 4 else ""
        raise ValueError(
            f"{name} must have radially symmetric aberrations, got {', '.join(kinds[:4])}{more}: leave these terms "
            "out of the lens (its section [aberrations]), or blur by lommel.imaging.FieldBlur, which supports any PSF"
        )
    if lens.spider or lens.vignetting or lens.mask or lens.stop:
        raise ValueError(
            f"{name} must have a round aperture, without spider, vignetting, mask and stop: leave these out, or blur "
            "by lommel.imaging.FieldBlur, which supports any aperture"
        )


def pixel_of(lenses: Sequence[Lens], pixel: float) -> float:
    """Return a pixel pitch in metres; TypeError or ValueError unless the PSFs of all lenses are circular."""
    if not isinstance(lenses, Sequence) or not lenses or not all(isinstance(lens, Lens) for lens in lenses):
        raise TypeError(f"lenses must be a sequence of Lens, one for each photograph, got {validation.shown(lenses)}")
    pitch = validation.pixel(pixel, metric=True)
    for k, lens in enumerate(lenses):
        require_round(f"lenses[{k}]", lens)
        validation.pixel_on(pitch, lens.wavelength * lens.working_f_number, metric=True)
    return pitch
