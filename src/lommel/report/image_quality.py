"""Image quality of a lens or a microscope: Strehl ratio, widths, MTF, depth of field and encircled energy."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Literal, TypeVar

import numpy as np

from lommel.base.arrays import Array, Json, Numbers, plain
from lommel.core.answers import ToleranceError
from lommel.measures import aperture_means, errors, spot, transfer
from lommel.measures.energy import MAX_RADIUS, encircled, optics
from lommel.methods import Method, Polychromatic
from lommel.methods.choice import first_within_tolerance, of_profiles, references
from lommel.methods.paper.huygens import HuygensFresnel
from lommel.optics.aperture.apodization import illumination
from lommel.optics.aperture.shapes import CatEye, Disc, Ellipse, Polygon, Segments, Shape
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf
from lommel.show.drawing import of_emitter
from lommel.special import zernike

if TYPE_CHECKING:
    from lommel.lensfiles.instrument import Instrument
    from lommel.lensfiles.microscope_files import Microscope
    from lommel.optics.colour.spectrum import Channels
    from lommel.optics.lens import Lens
    from lommel.optics.pupil import Pupil

    # x and y on the sensor, metres, or None if the file has no field aberrations; and the pupil at this position.
    Place = tuple[float | None, float | None, Pupil]

Value = TypeVar("Value")

IN_FOCUS = 2.0
"""Largest diameter, in pixels, of the circle of confusion of objects that count as in focus."""

_LENS_ATTRIBUTES = ("focal_length", "aperture_diameter", "f_number", "working_f_number", "obscuration", "wavelength",
            "model", "corrected_for")  # fmt: skip
_ARCSEC = math.pi / 648000.0
_DIAMETER_FRACTION = 0.8  # fraction of the light within `diameter_80`
# Diameter, in pixels, above which pixel integration changes a width by less than the last printed digit.
_MAX_WIDTH = 60.0
# Largest number of mirror segments for which MTF50 and focus tolerance are computed; more segments take minutes.
_MAX_SEGMENTS = 24


class PointQuality:
    """Quality of the image of a point through a pupil, with attributes that are computed at access.

    An attribute raises ValueError or ArithmeticError if it cannot be computed.

    Parameters
    ----------
    pupil : Pupil
    """

    def __init__(self, pupil: Pupil) -> None:
        self.pupil = pupil

    @property
    def strehl(self) -> float:
        """Strehl ratio on the axis."""
        return float(aperture_means.strehl(self.pupil))

    @property
    def strehl_at_peak(self) -> float:
        """Strehl ratio at the brightest point of the image."""
        pupil = self.pupil
        if not pupil.radial:
            # An additional tilt moves the brightest point to the axis.
            x, y = spot.brightest_position(optics(pupil))
            return float(aperture_means.strehl(_with_tilt(pupil, -math.pi * x, -math.pi * y)))
        method, max_v = of_profiles(), float(pupil.v(pupil.geometric_radius())) + 4.0
        v = np.linspace(0.0, max_v, 64 + math.ceil(10.0 * max_v))
        # Find the brightest radius by coarse samples, then by fine samples around the brightest coarse sample.
        coarse_peak = v[np.argmax(method.profile(pupil, v).values[0])]
        fine_v = np.abs(coarse_peak + np.linspace(-v[1], v[1], 101))
        top = method.profile(pupil, np.append(0.0, fine_v)).values.max()
        return float(top / method.unaberrated_peak(pupil))

    @property
    def rms_waves(self) -> float:
        """Rms wavefront error, waves."""
        return float(aperture_means.rms(self.pupil, unit="waves"))

    @property
    def rms_waves_without_tilt(self) -> float:
        """Rms wavefront error after subtraction of the best-fit tilt, which only shifts the image, waves."""
        tilt = -aperture_means.least_squares(self.pupil, [_tilt_x, _tilt_y])
        return float(aperture_means.rms(_with_tilt(self.pupil, *tilt), unit="waves"))


class ImageQuality(PointQuality):
    """Quality of the images of a lens at its sensor, as ``lommel info`` prints it.

    Lengths are in metres, phases in radians, frequencies in cycles per metre. Attributes are computed at access. An
    attribute raises ValueError or ArithmeticError if it cannot be computed.

    Parameters
    ----------
    instrument : Instrument
        Lens, object and sensor, for example from :func:`lommel.load_instrument`.

    Examples
    --------
    >>> import lommel as lm
    >>> from lommel.report.image_quality import ImageQuality
    >>> lens = lm.Lens(focal_length=20e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> quality = ImageQuality(lm.Instrument("lens", "", lens, 2.0, 2e-6, None, {}))
    >>> [round(end, 3) for end in quality.depth_of_field]
    [1.853, 2.172]
    >>> round(quality.mtf50() / 1e3)  # cycles per millimetre
    182
    """

    def __init__(self, instrument: Instrument) -> None:
        super().__init__(instrument.pupil())
        self.instrument, self.lens = instrument, instrument.lens

    @property
    def depth_of_field(self) -> tuple[float, float] | None:
        """Nearest and farthest object distance with a circle of confusion of at most 2 pixels.

        The diameter of the circle of confusion of a lens without aberrations is ``D d abs(1/s - 1/s0)`` for an object
        at the distance s, where D is the aperture diameter, d the sensor distance and s0 the focus distance. None for
        telescopes and microscopes.
        """
        if not self._is_camera:
            return None
        lens = self.lens
        # Largest difference of 1/s and 1/s0.
        difference = IN_FOCUS * max(self.instrument.pitch) / (lens.aperture_diameter * lens.sensor_distance)
        middle = 1.0 / lens.focus_distance
        return 1.0 / (middle + difference), 1.0 / (middle - difference) if middle > difference else math.inf

    @property
    def hyperfocal_distance(self) -> float | None:
        """Smallest focus distance whose depth of field extends to infinity; None if `depth_of_field` is None."""
        blur = IN_FOCUS * max(self.instrument.pitch)
        return self.lens.focal_length * (1.0 + self.lens.aperture_diameter / blur) if self._is_camera else None

    @property
    def _is_camera(self) -> bool:
        """False for telescopes and microscopes, whose depth of field is not reported."""
        lens = self.lens
        return not (lens.focus_distance < 0.0 or magnifies(lens) or lens.obscuration or lens.focal_length > 1.0)

    @property
    def marechal(self) -> float:
        """Marechal estimate of the Strehl ratio, exp(-sigma^2) with the rms phase sigma."""
        return float(aperture_means.marechal(self.pupil))

    @property
    def balancing_defocus(self) -> float | None:
        """W020 (waves) that minimises the rms wavefront error; None without spherical or higher radial terms."""
        wavefront = self.pupil.wavefront
        if not (wavefront.spherical or any(wavefront.higher)):
            return None
        # Tilt, which only shifts the image, is fitted too.
        excess = aperture_means.least_squares(self.pupil, [lambda rho, _: rho**2, _tilt_x, _tilt_y])[0]
        return float(wavefront.waves["W020"] - excess / (2.0 * math.pi))

    @property
    def dark_ring_radius(self) -> float | None:
        """Radius of the first dark ring of the unaberrated aperture; None unless it is a uniform disc or annulus."""
        # The field of an annulus is the field of the disc minus the field of the obscuration, and is 0 at
        # J1(v) = eps J1(eps v).
        from scipy.optimize import brentq
        from scipy.special import j1, jn_zeros

        pupil = self.pupil
        shapes = (pupil.spider, pupil.vignetting, pupil.stop, pupil.mask)
        if not pupil.illumination.uniform or any(shape is not None for shape in shapes):
            return None
        airy, eps = float(jn_zeros(1, 1)[0]), pupil.obscuration
        ring = float(brentq(lambda v: j1(v) - eps * j1(eps * v), 0.5, airy)) if eps else airy
        return pupil.airy_radius * ring / airy

    @property
    def circle_of_confusion(self) -> float:
        """Diameter of the geometric blur due to defocus alone."""
        lens = self.lens
        unaberrated = lens if lens.aberrations.flat else replace(lens, aberrations=Wavefront())
        return 2.0 * float(unaberrated.pupil(self.instrument.object_distance).geometric_radius())

    @cached_property
    def image(self) -> PSF:
        """Pixel-integrated PSF in a window of one pixel: its measures refer to the continuous image."""
        instrument = self.instrument
        return psf(self.pupil, 1, instrument.pixel, integrate=True, fill=instrument.fill)

    def fwhm(self, *, pixel: bool = False) -> float:
        """Return the full width at half maximum.

        Parameters
        ----------
        pixel : bool, default False
            Include the average over a pixel.

        Returns
        -------
        float
            Full width at half maximum, metres.
        """
        return float(spot.fwhm(self.image, of="image" if pixel else "optics"))

    def diameter_80(self, *, pixel: bool = False) -> float:
        """Return the diameter of the circle about the centroid that contains 80 % of the light.

        Parameters
        ----------
        pixel : bool, default False
            Include the average over a pixel.

        Returns
        -------
        float
            Diameter, metres.
        """
        of: Literal["image", "optics"] = "image" if pixel else "optics"
        return float(spot.energy_diameter(self.image, _DIAMETER_FRACTION, about="centroid", of=of))

    def mtf(self, frequency: float, angle: float = 0.0, *, pixel: bool = False) -> float:
        """Return the MTF at a frequency in a direction.

        Parameters
        ----------
        frequency : float
            Spatial frequency, cycles per metre.
        angle : float, default 0.0
            Direction, radians from x towards y.
        pixel : bool, default False
            Include the average over a pixel.

        Returns
        -------
        float
            MTF, 0 to 1.
        """
        sensor: Any = {"pixel": self.instrument.pixel, "fill": self.instrument.fill} if pixel else {}
        x, y = frequency * math.cos(angle), frequency * math.sin(angle)
        return float(transfer.mtf(self.pupil, x, y, **sensor))

    def focus_tolerance(self, least: float = 0.3) -> tuple[float, float]:
        """Return the sensor displacements at which the MTF at half the Nyquist frequency falls to `least`.

        Parameters
        ----------
        least : float, default 0.3
            Smallest acceptable MTF.

        Returns
        -------
        (float, float)
            Displacements, metres, towards the lens (negative) and away from it; see :func:`lommel.focus_tolerance`.

        Raises
        ------
        ValueError
            If the MTF without displacement is below `least`, or if the aperture has more than 24 segments, for which
            the computation takes minutes.
        """
        if isinstance(self.pupil.stop, Segments) and len(self.pupil.stop.shapes) > _MAX_SEGMENTS:
            raise ValueError(
                f"focus tolerance takes minutes for more than {_MAX_SEGMENTS} segments: use lommel.focus_tolerance"
            )
        sensor: Any = {"pixel": self.instrument.pixel, "fill": self.instrument.fill}
        frequency = 0.25 / max(self.instrument.pitch)
        mtf = min(self.mtf(frequency, angle, pixel=True) for angle in (0.0, 0.5 * math.pi))
        if mtf < least:
            raise ValueError(
                f"the focus tolerance needs an MTF of {least:g} or more at half the Nyquist frequency, got {mtf:.3g}"
            )
        return transfer.displacements(self.pupil, frequency, least, sensor)

    def mtf50(self, angle: float = 0.0) -> float:
        """Return the frequency at which the MTF of the optics alone falls to 50 %.

        Parameters
        ----------
        angle : float, default 0.0
            Direction, radians from x towards y.

        Returns
        -------
        float
            Frequency, cycles per metre.

        Raises
        ------
        ValueError
            If the aperture has more than 24 segments, for which the computation takes minutes.
        """
        segments = len(self.pupil.opening.regions)
        if segments > _MAX_SEGMENTS:
            raise ValueError(f"MTF50, which takes minutes for {segments} segments: use lommel.mtf_frequency(pupil)")
        return float(transfer.mtf_frequency(self.pupil, angle=angle))

    @property
    def radii(self) -> dict[str, float]:
        """Radii for the encircled energy by name: from the file, the Airy radius, the geometric blur."""
        radii, blur = dict(self.instrument.radii), float(self.pupil.geometric_radius())
        radii.setdefault("Airy radius", self.pupil.airy_radius)
        if blur > 0:
            radii.setdefault("edge of the geometric blur", blur)
        return radii

    def encircled_energy(self, *, unaberrated: bool = False) -> tuple[list[float | None], float | None]:
        """Return the fractions of the light within the `radii` about the axis.

        Parameters
        ----------
        unaberrated : bool, default False
            Ignore all aberrations.

        Returns
        -------
        list of float or None
            Fraction for each radius; None if the radius is above 250 lambda*N and the pupil not radially symmetric.
        float or None
            Bound on the error of the fractions; None if it is not available.
        """
        pupil, radii = self.pupil.unaberrated() if unaberrated else self.pupil, self.radii.values()
        max_radius = math.inf if pupil.radial else MAX_RADIUS * pupil.scale
        result = encircled(pupil, [r for r in radii if r <= max_radius])
        fractions = iter(result.fraction.tolist())
        return [next(fractions) if r <= max_radius else None for r in radii], result.error

    def setup(self) -> Json:
        """Return the parameters of lens, object and sensor as plain data, without measures of image quality.

        Returns
        -------
        dict
            Plain data for JSON.
        """
        lens, instrument, field = self.lens, self.instrument, self.depth_of_field
        height, width = instrument.pitch
        is_telescope = math.isinf(lens.focus_distance) and math.isinf(instrument.object_distance)
        in_focus = field and {"near": field[0], "far": field[1], "blur": IN_FOCUS * max(height, width)}
        result = {
            "name": instrument.name,
            "source": instrument.source,
            **{name: getattr(lens, name) for name in _LENS_ATTRIBUTES},
            "apodization": lens.apodization,
            "focus_distance": lens.focus_distance,
            "sensor_distance": lens.sensor_distance,
            "object_distance": instrument.object_distance,
            "pixel": instrument.pixel,
            "arcsec_per_pixel": width / lens.focal_length / _ARCSEC if is_telescope else None,
            "pixel_in_object": width * lens.focus_distance / lens.sensor_distance if magnifies(lens) else None,
            "in_focus": in_focus,
            "hyperfocal_distance": self.hyperfocal_distance,
            "aperture": {
                "spider": lens.spider,
                "vignetting": lens.vignetting,
                "mask": None if lens.mask is None else {"side": lens.mask.side},
                "stop": None if lens.stop is None else _stop(lens.stop),
            },
            "clear_area": self.pupil.area,
        }
        return dict(plain(result))

    def to_dict(self) -> Json:
        """Return all measures as plain data; infinite values and failed computations are None.

        Names of measures along y end in "_y"; names of measures along x have no ending. "refused" lists the reasons
        of failed computations.

        Returns
        -------
        dict
            Plain data for JSON.
        """
        pupil, pitch, radii = self.pupil, self.instrument.pitch, self.radii
        reasons: dict[str, None] = {}

        def attempt(compute: Callable[[], Value]) -> Value | None:
            try:
                return compute()
            except (ValueError, ArithmeticError) as reason:
                reasons[str(reason)] = None
                return None

        def attributes(quality: PointQuality, *names: str) -> Json:
            return {name: attempt(partial(getattr, quality, name)) for name in names}

        no_fractions: tuple[list[float | None], None] = [None] * len(radii), None
        actual, ideal = (
            attempt(partial(self.encircled_energy, unaberrated=is_ideal)) or no_fractions
            for is_ideal in (False, True)
        )
        transfers: Json = {}
        for end, angle, side in (("", 0.0, pitch[1]), ("_y", 0.5 * math.pi, pitch[0])):
            nyquist = 0.5 / side
            transfers |= {
                f"mtf50{end}": attempt(partial(self.mtf50, angle)),
                f"nyquist{end}": nyquist,
                f"mtf_at_nyquist{end}": attempt(partial(self.mtf, nyquist, angle)),
                f"mtf_at_nyquist_with_pixel{end}": attempt(partial(self.mtf, nyquist, angle, pixel=True)),
            }
        result = self.setup() | {
            "rim_amplitude": float(np.divide(*self.lens.illumination.value([1.0, 0.0]))),
            "other_model": other_model(self.instrument),
            "defocus": float(pupil.wavefront.defocus),
            "defocus_of_distances": float(self.lens.defocus(self.instrument.object_distance)),
            "spherical": float(pupil.wavefront.spherical),
            "higher": [float(c) for c in pupil.wavefront.higher],
            "waves": {name: float(value) for name, value in pupil.wavefront.waves.items()},
            "zernike": listed_terms(pupil.wavefront.to_zernike(unit="waves")),
            "airy_radius": pupil.airy_radius,
            "dark_ring_radius": self.dark_ring_radius,
            "geometric_radius": float(pupil.geometric_radius()),
            "circle_of_confusion": self.circle_of_confusion,
            "balancing_W020": attempt(partial(getattr, self, "balancing_defocus")),
            **attributes(self, "strehl", "strehl_at_peak", "marechal", "rms_waves", "rms_waves_without_tilt"),
            **self._widths(attempt),
            "cutoff": pupil.cutoff,
            **transfers,
            "focus_tolerance": attempt(self.focus_tolerance),
        }
        places = None if self.instrument.aberrations_of_field is None else self._places()
        result["field"] = places and {
            **places,
            "places": [
                place | attributes(quality, "strehl", "rms_waves", "strehl_at_peak", "rms_waves_without_tilt")
                for place, quality in places["places"]
            ],
        }
        result["encircled_energy"] = [
            {"within": name, "radius": radius, "fraction": a, "unaberrated": b}
            for (name, radius), a, b in zip(radii.items(), actual[0], ideal[0], strict=True)
        ]
        result["encircled_energy_error"] = max((e for e in (actual[1], ideal[1]) if e is not None), default=None)
        return result | {"refused": list(reasons)}

    def _widths(self, attempt: Callable[[Callable[[], float]], float | None]) -> dict[str, float | None]:
        """Return FWHM and diameter of 80 % of the light, without the pixel and with it (None for a wide blur).

        `attempt` returns the result of a function, None if the function raises an error.
        """
        measures: dict[str, Callable[..., float]] = {"fwhm": self.fwhm, "diameter_80": self.diameter_80}
        result = {name: attempt(measure) for name, measure in measures.items()}
        is_wide = (result["diameter_80"] or math.inf) > _MAX_WIDTH * min(self.instrument.pitch)
        for name, measure in measures.items():
            omitted = result[name] is None or is_wide
            result[f"{name}_with_pixel"] = None if omitted else attempt(partial(measure, pixel=True))
        return result

    def _places(self) -> Json:
        """Return the field aberrations as plain data, with positions from the axis to a corner of the sensor."""
        assert self.instrument.sensor is not None  # instruments with field aberrations have a sensor size
        field, (height, width) = self.instrument.field(), self.instrument.sensor
        places = []
        for part in (0.0, 0.5, 0.7, 1.0):
            x, y = 0.5 * part * width, 0.5 * part * height
            try:
                quality = PointQuality(field.pupil(x, y))
            except ValueError:  # the position is outside the field map
                continue
            terms = quality.pupil.wavefront.to_zernike(unit="waves")
            listed = listed_terms({term: c for term, c in terms.items() if term[0] > 1})
            places.append(({"part": part, "distance": math.hypot(x, y), "zernike": listed}, quality))
        seidel = {name: waves for name, waves in field.seidel.items() if waves}
        return {"sensor": [height, width], "reach": field.reach, "seidel": seidel, "places": places}


def magnifies(lens: Lens) -> bool:
    """Return True if the image of an object in focus is larger than the object, as with a microscope objective."""
    return 0.0 < lens.focus_distance < lens.sensor_distance


def other_model(instrument: Instrument) -> Json:
    """Compare the PSFs of the lens by its own and the other model (paraxial, aplanatic); return plain data.

    "peak_error" is the largest difference of the two PSFs in the window divided by the peak of the aplanatic PSF. If
    the comparison fails, "peak_error" is None, and "reason" states why.
    """
    lens = instrument.lens
    model = "aplanatic" if lens.model == "paraxial" else "paraxial"
    # In a magnifying lens, such as an objective, the sensor is at its design position, but the object need not be.
    side = "focus" if model == "aplanatic" and magnifies(lens) else lens.corrected_for
    result = {"model": model, "corrected_for": side, "geometric_radius": None, "peak_error": None, "reason": None}
    try:
        # Keep the amplitude also where it is a function of ray angles, which a paraxial lens lacks.
        changed = replace(lens, model=model, corrected_for=side, apodization=lens.illumination)
        other = changed.pupil(instrument.object_distance)
        pupils = {lens.model: instrument.pupil(), model: other}
        psfs = {
            name: psf(p, instrument.window, instrument.pixel, dtype="float64", **instrument.sensor_options)
            for name, p in pupils.items()
        }
    except ToleranceError:
        return result | {"reason": "cannot be computed to the tolerance"}
    except (ValueError, ArithmeticError, ImportError) as error:
        return result | {"reason": str(error).removeprefix(f"model {model!r} is ")}
    blur, difference = other.geometric_radius(), errors.peak_error(psfs["paraxial"], psfs["aplanatic"])
    return result | {"geometric_radius": float(blur), "peak_error": difference}


def sensor_mtf(instrument: Instrument, places: Sequence[Place], channels: Channels | None = None) -> Json:
    """Return the MTF, pixel included, at the Nyquist frequency and at half the Nyquist frequency as plain data.

    "frequency" has the Nyquist frequencies along x and y, cycles per metre. "rows" has one row for each combination
    of `places` and `channels` (without channels, the wavelength of the file), with the MTF along x and y. Rows of
    places off the axis also have the "sagittal" MTF (frequency perpendicular to the radius) and the "tangential" MTF,
    at the smaller Nyquist frequency and at half this frequency.
    """
    nyquist = [0.5 / side for side in instrument.pitch[::-1]]
    spectra: list[tuple[str | None, Polychromatic | None]] = [(None, None)]
    if channels is not None:
        spectra = [(name, Polychromatic([w for w, _ in pairs], [s for _, s in pairs])) for name, pairs in channels]
    sensor: Any = {"pixel": instrument.pixel, "fill": instrument.fill, "tol": 1e-6}
    rows = []
    for x, y, pupil in places:
        directions = {"nyquist": np.diag(nyquist)}  # frequency along x, along y
        if x is not None and y is not None and (x or y):
            radial = np.array([x, y]) / math.hypot(x, y)
            directions["radial"] = min(nyquist) * np.array([[-radial[1], radial[0]], radial])
        for name, light in spectra:
            result = {
                key: [
                    transfer.mtf(pupil, *(factor * f.T), spectrum=light, **sensor).tolist() for factor in (1.0, 0.5)
                ]
                for key, f in directions.items()
            }
            row = {
                "x": x,
                "y": y,
                "channel": name,
                "nyquist": result["nyquist"][0],
                "half_nyquist": result["nyquist"][1],
            }
            if "radial" in result:
                row["sagittal"], row["tangential"] = map(list, zip(*result["radial"], strict=True))
            rows.append(row)
    return {"frequency": nyquist, "rows": rows}


def listed_terms(terms: Mapping[tuple[int, int], Numbers]) -> list[Json]:
    """Return Zernike coefficients (waves rms) as plain data, sorted by Noll index."""
    return [
        {"n": n, "m": m, "name": zernike.name(n, m), "waves_rms": float(c)}
        for (n, m), c in sorted(terms.items(), key=lambda item: int(zernike.index_of(item[0][0], item[0][1], "noll")))
    ]


def _stop(stop: Shape | Segments) -> Json:
    """Return the numbers of segments and shapes of a stop, and the rms piston of its segments."""
    shapes = stop.shapes if isinstance(stop, Segments) else (stop,)
    parts = [part for shape in shapes for part in shape.parts if part != Disc()]  # without the rim itself
    kinds = {"discs": (Disc, CatEye), "ellipses": (Ellipse,), "polygons": (Polygon,)}
    return {
        "segments": len(stop.shapes) if isinstance(stop, Segments) else 0,
        "piston_rms_waves": float(np.std(stop.piston)) / (2.0 * math.pi) if isinstance(stop, Segments) else 0.0,
        "parts": {name: sum(isinstance(part, kind) for part in parts) for name, kind in kinds.items()},
    }


def _tilt_x(rho: Array, theta: Array) -> Array:
    return rho * np.cos(theta)


def _tilt_y(rho: Array, theta: Array) -> Array:
    return rho * np.sin(theta)


def _with_tilt(pupil: Pupil, x: float, y: float) -> Pupil:
    """Return a pupil with additional tilts along x and y, radians at the edge of the pupil."""
    # A Zernike tilt with an rms of 1 over the disc has the value 2 at the edge.
    tilt = Wavefront.zernike({(1, 1): 0.5 * x, (1, -1): 0.5 * y})
    return replace(pupil, wavefront=pupil.wavefront + tilt, geometry=None)


DEPTHS = (0.0, 1e-6, 5e-6, 20e-6, 50e-6)
"""Depths at which foci are reported in addition to the depth of the file, metres."""

_OBJECTIVE_ATTRIBUTES = ("NA", "magnification", "working_distance", "immersion")
_MAX_FOCUSED_RMS = 0.5  # largest wavefront error, waves rms, whose focus is searched within 4 axial widths
_FOCUS_ATTRIBUTES = ("paraxial", "brightest", "ratio", "axial_fwhm", "lateral_fwhm", "peak")


def microscope_quality(microscope: Microscope, *, foci: bool = True) -> Json:
    """Return the parameters of a microscope as plain data, and with `foci` the focus of dipoles at several depths.

    Lengths are in metres: x and y in the sample, z of the stage, "pixel" on the camera. Angles are in radians. The
    list "focus" has one row for each depth of a freely rotating dipole, and "refused" the reasons why depths are
    missing.
    """
    objective, wavelength = microscope.objective, microscope.wavelength
    light, nyquist = illumination(objective.apodization), objective.nyquist(wavelength=wavelength)
    step = abs(microscope.step) if microscope.planes > 1 else None
    design, measured = objective.design, microscope.aberrations
    terms = [] if measured is None else listed_terms(measured.to_zernike(unit="waves"))
    as_designed = design.immersion == objective.immersion and design.coverslip == objective.coverslip
    is_coarse = {"pixel": microscope.pixel > nyquist.pixel, "step": step is not None and step > nyquist.axial}
    rows, refused = _foci(microscope) if foci else ([], [])
    return {
        "name": microscope.name,
        "source": microscope.source,
        **{name: getattr(objective, name) for name in _OBJECTIVE_ATTRIBUTES},
        "apodization": list(light.powers),
        "rim_amplitude": float(light.value(1.0)),
        "coverslip": plain(objective.coverslip),
        "films": plain(objective.films),
        "design": None if as_designed else plain(design),
        "sample": objective.sample,
        "critical_angle": objective.critical_angle,
        "rim_angle": math.asin(objective.NA / objective.immersion),
        "wavelength": wavelength,
        "emitter": of_emitter(microscope.emitter),
        "rms_waves": math.hypot(*(term["waves_rms"] for term in terms)),
        "zernike": terms,
        "depth": microscope.depth,
        "planes": microscope.planes,
        "step": step,
        "origin": microscope.origin,
        "pixel": microscope.pixel,
        "camera": plain(microscope.camera),
        "pixel_in_sample": microscope.pixel / objective.magnification,
        "nyquist": plain(nyquist),
        "too_coarse": [name for name, coarse in is_coarse.items() if coarse],
        "focus": rows,
        "refused": refused,
    }


def _foci(microscope: Microscope) -> tuple[list[dict[str, float | None]], list[str]]:
    """Return one row of data for the focus at each depth, and the reasons why depths are missing."""
    objective, wavelength = microscope.objective, microscope.wavelength
    rows: list[dict[str, float | None]] = []
    reasons: dict[str, None] = {}
    surface_peak = None  # the first depth is 0
    for depth in sorted({*DEPTHS, microscope.depth}):
        try:
            focus = focus_at(microscope, depth)
        except ValueError as reason:
            reasons[f"{1e6 * depth:.4g} um deep: {reason}"] = None
            continue
        row: dict[str, float | None] = {"depth": depth, **focus}
        if depth == 0.0:
            row["ratio"], surface_peak = None, focus["peak"]
        row["peak_of_surface"] = surface_peak and focus["peak"] / surface_peak
        row["collected"] = float(objective.collected(depth, wavelength=wavelength))
        rows.append(row)
    return rows, list(reasons)


def focus_at(microscope: Microscope, depth: float) -> dict[str, float]:
    """Return the attributes of the focus at a depth, with the aberrations; ValueError without a single focus."""
    objective, wavelength = microscope.objective, microscope.wavelength
    result = objective.focus(depth, wavelength=wavelength)
    focus = {name: float(getattr(result, name)) for name in _FOCUS_ATTRIBUTES}
    if microscope.aberrations is None:
        return focus
    if (waves := float(aperture_means.rms(microscope.aberrations, unit="waves"))) > _MAX_FOCUSED_RMS:
        raise ValueError(f"aberrations of {waves:.2g} waves rms, above {_MAX_FOCUSED_RMS:g}, have no single focus")
    # Aberrations shift the focus: the brightest voxel of a stack of 8 axial widths, in steps of 1 / 20.
    z = np.linspace(-4.0, 4.0, 161) * focus["axial_fwhm"]
    pixel = 0.25 * objective.nyquist(wavelength=wavelength).pixel
    stacks = [
        psf(
            objective.pupil(depth=depth, z=z, wavelength=wavelength, origin="brightest", aberrations=aberrations),
            33, pixel, integrate=False,
        )
        for aberrations in (None, microscope.aberrations)
    ]  # fmt: skip
    ideal, aberrated = (stack.values.astype(np.float64) for stack in stacks)
    plane, row, column = np.unravel_index(int(aberrated.argmax()), aberrated.shape)
    sides = aberrated[plane, row], aberrated[plane, :, column]
    return focus | {
        "brightest": focus["brightest"] + float(z[plane]),
        "axial_fwhm": spot.profile_width(aberrated[:, row, column]) * float(z[1] - z[0]),
        "lateral_fwhm": 0.5 * sum(spot.profile_width(side) for side in sides) * pixel / objective.magnification,
        "peak": focus["peak"] * float(aberrated.max() / ideal.max()),
    }


def compare_methods(
    instrument: Instrument, methods: Iterable[Method], on_start: Callable[[str], object] = str
) -> tuple[list[Json], dict[str, PSF]]:
    """Return errors and times of several methods, one row each, and the PSFs of the methods that apply.

    Errors are relative to :func:`lommel.methods.choice.references`, whose PSF is first, under the name of its class
    or its ``repr``. PSFs whose :attr:`lommel.PSF.sampling` differs from the reference are omitted. `on_start` is
    called with the name of each method before it runs.
    """
    pupil = instrument.pupil()

    def compute(method: Method, integrate: bool | None) -> PSF:
        window, pixel = instrument.window, instrument.pixel
        fill = 1.0 if integrate is False else instrument.fill
        return psf(pupil, window, pixel, method=method, dtype="float64", integrate=integrate, fill=fill)

    def run_timed(method: Method, integrate: bool | None) -> tuple[PSF, float]:
        """Return the PSF and the time (s) of the second run, or of the first run if it takes more than a second."""
        for _ in range(2):  # the first run loads libraries and fills caches
            start = time.perf_counter()
            result = compute(method, integrate)
            seconds = time.perf_counter() - start
            if seconds > 1.0:
                break
        return result, seconds

    def name_of(method: Method) -> str:
        return type(method).__name__ if pupil.radial else repr(method)

    def as_reference(method: Method) -> tuple[PSF, float]:
        on_start(name_of(method))
        return run_timed(method, instrument.integrate)

    exact_method, (exact, seconds) = first_within_tolerance(references(pupil), as_reference)
    answers, rows = {name_of(exact_method): exact}, []
    for method in methods:
        name = type(method).__name__
        row: Json = {"method": name, "options": method.to_dict(), "reason": None}
        row |= dict.fromkeys(("seconds", "mse", "peak_error", "error_bound", "sampling"))
        rows.append(row)
        if isinstance(method, HuygensFresnel) and instrument.lens.model == "paraxial" and magnifies(instrument.lens):
            row["reason"] = 'needs model = "aplanatic": its paraxial model is a flat lens, unlike an objective'
            continue
        if method != exact_method:
            on_start(name)
        # Pixel integration by Huygens-Fresnel sums would take minutes.
        integrate = False if isinstance(method, HuygensFresnel) else instrument.integrate
        try:
            result, row["seconds"] = (exact, seconds) if method == exact_method else run_timed(method, integrate)
        except (ValueError, ArithmeticError, ImportError) as error:
            row["reason"] = str(error)
            continue
        row["sampling"], row["error_bound"] = result.sampling, result.error_bound
        target = exact
        if result.sampling == exact.sampling:
            answers[name] = result
        elif result.sampling == "center":
            target = compute(exact_method, False)
        row["mse"], row["peak_error"] = errors.mse(result, target), errors.peak_error(result, target)
    return rows, answers
