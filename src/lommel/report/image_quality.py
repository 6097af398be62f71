"""Image quality of a lens at its sensor: sharpness, wavefront, and what its field of science measures by."""

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
from lommel.methods import HuygensFresnel, Method, Polychromatic
from lommel.methods.choice import of_profiles, reference
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

    # x and y on the sensor, metres, None where the file has no field; and the pupil there.
    Place = tuple[float | None, float | None, Pupil]

Value = TypeVar("Value")

IN_FOCUS = 2.0
"""Largest circle of confusion of what counts as in focus, in pixels."""

_OF_LENS = ("focal_length", "aperture_diameter", "f_number", "working_f_number", "obscuration", "wavelength",
            "model", "corrected_for")  # fmt: skip
_ARCSEC = math.pi / 648000.0
_SHARE = 0.8
# Pixels change diameters of more pixels than this by less than their last digit, at the cost of seconds.
_WIDE = 60.0
# Mirrors of more segments have an MTF50 that takes longer than all the rest.
_MANY = 24


class PointQuality:
    """Quality of the image of a point through a pupil: each attribute is computed when it is read.

    Attributes raise ValueError or ArithmeticError where they cannot be computed.

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
            # Where the image is brightest is the axis of a wavefront with another tilt.
            x, y = spot.brightest_place(optics(pupil))
            return float(aperture_means.strehl(_tilted(pupil, -math.pi * x, -math.pi * y)))
        method, far = of_profiles(), float(pupil.v(pupil.geometric_radius())) + 4.0
        v = np.linspace(0.0, far, 64 + math.ceil(10.0 * far))
        # The brightest place along a radius: coarse samples first, then fine ones around the best.
        best = v[np.argmax(method.profile(pupil, v).values[0])]
        near = np.abs(best + np.linspace(-v[1], v[1], 101))
        top = method.profile(pupil, np.append(0.0, near)).values.max()
        return float(top / method.unaberrated_peak(pupil))

    @property
    def rms_waves(self) -> float:
        """Rms wavefront error, waves."""
        return float(aperture_means.rms(self.pupil, unit="waves"))

    @property
    def rms_waves_without_tilt(self) -> float:
        """Rms wavefront error less the tilt without which it is least, which only shifts the image, waves."""
        tilt = -aperture_means.least_squares(self.pupil, [_across, _down])
        return float(aperture_means.rms(_tilted(self.pupil, *tilt), unit="waves"))


class ImageQuality(PointQuality):
    """Quality of the images of a lens at its sensor, as ``lommel info`` prints it.

    Lengths in metres, phases in radians, frequencies in cycles per metre. Each attribute is computed when it is read,
    and raises ValueError or ArithmeticError where it cannot be.

    Parameters
    ----------
    instrument : Instrument
        Lens, object and sensor, as of :func:`lommel.load_instrument`.

    Examples
    --------
    >>> import lommel as lm
    >>> lens = lm.Lens(focal_length=20e-3, f_number=4.0, focus_distance=2.0, wavelength=550e-9)
    >>> quality = lm.ImageQuality(lm.Instrument("lens", "", lens, 2.0, 2e-6, None, {}))
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
        """Nearest and farthest distance whose circle of confusion is up to 2 pixels wide.

        Geometric, of a lens without aberration: ``blur = D d abs(1/s - 1/s0)`` at the distance s, D being the
        aperture diameter, d the distance of the sensor and s0 the distance in focus. None for telescopes and
        microscopes.
        """
        if not self._photographs:
            return None
        lens = self.lens
        # blur = D d |1/s - 1/s0| at the limit, solved for 1/s - 1/s0.
        reach = IN_FOCUS * max(self.instrument.pitch) / (lens.aperture_diameter * lens.sensor_distance)
        near, far = 1.0 / lens.focus_distance + reach, 1.0 / lens.focus_distance - reach
        return 1.0 / near, 1.0 / far if far > 0.0 else math.inf

    @property
    def hyperfocal_distance(self) -> float | None:
        """Focus distance beyond which all is in focus up to infinity, as `depth_of_field`."""
        blur = IN_FOCUS * max(self.instrument.pitch)
        return self.lens.focal_length * (1.0 + self.lens.aperture_diameter / blur) if self._photographs else None

    @property
    def _photographs(self) -> bool:
        lens = self.lens
        return not (lens.focus_distance < 0.0 or magnifies(lens) or lens.obscuration or lens.focal_length > 1.0)

    @property
    def marechal(self) -> float:
        """Marechal's estimate of the Strehl ratio."""
        return float(aperture_means.marechal(self.pupil))

    @property
    def balancing_defocus(self) -> float | None:
        """W020 (waves) that leaves the least rms beside the other terms; None where there are none."""
        wavefront = self.pupil.wavefront
        if not (wavefront.spherical or any(wavefront.higher)):
            return None
        # Tilts are fitted along: they shift the image only.
        excess = aperture_means.least_squares(self.pupil, [lambda rho, _: rho**2, _across, _down])[0]
        return float(wavefront.waves["W020"] - excess / (2.0 * math.pi))

    @property
    def dark_ring_radius(self) -> float | None:
        """Radius of the first dark ring without aberrations; None where the aperture is no annulus.

        The field of an annulus is the difference of those of two discs: ``J1(v) = eps J1(eps v)``.
        """
        from scipy.optimize import brentq
        from scipy.special import j1, jn_zeros

        pupil = self.pupil
        shapes = (pupil.spider, pupil.vignetting, pupil.stop, pupil.mask)
        if not pupil.illumination.uniform or any(shape is not None for shape in shapes):
            return None
        last, inner = float(jn_zeros(1, 1)[0]), pupil.obscuration
        ring = float(brentq(lambda v: j1(v) - inner * j1(inner * v), 0.5, last)) if inner else last
        return pupil.airy_radius * ring / last

    @property
    def circle_of_confusion(self) -> float:
        """Diameter of the blur by defocus alone."""
        lens = self.lens
        plain = lens if lens.aberrations.flat else replace(lens, aberrations=Wavefront())
        return 2.0 * float(plain.pupil(self.instrument.object_distance).geometric_radius())

    @cached_property
    def image(self) -> PSF:
        """One pixel of the image, integrated: measures of it are of the continuous image."""
        instrument = self.instrument
        return psf(self.pupil, 1, instrument.pixel, integrate=True, fill=instrument.fill)

    def fwhm(self, *, pixel: bool = False) -> float:
        """Return the full width at half maximum.

        Parameters
        ----------
        pixel : bool, default False
            Of the image that pixels average, rather than of the optics alone.

        Returns
        -------
        float
            Metres.
        """
        return float(spot.fwhm(self.image, of="image" if pixel else "optics"))

    def diameter_80(self, *, pixel: bool = False) -> float:
        """Return the diameter of 80 % of the light about the centroid.

        Parameters
        ----------
        pixel : bool, default False
            Of the image that pixels average, rather than of the optics alone.

        Returns
        -------
        float
            Metres.
        """
        of: Literal["image", "optics"] = "image" if pixel else "optics"
        return float(spot.energy_diameter(self.image, _SHARE, about="centroid", of=of))

    def mtf(self, frequency: float, angle: float = 0.0, *, pixel: bool = False) -> float:
        """Return the MTF at a frequency in a direction.

        Parameters
        ----------
        frequency : float
            Cycles per metre.
        angle : float, default 0.0
            Direction, radians from x towards y.
        pixel : bool, default False
            With the average over a pixel.

        Returns
        -------
        float
        """
        sensor: Any = {"pixel": self.instrument.pixel, "fill": self.instrument.fill} if pixel else {}
        x, y = frequency * math.cos(angle), frequency * math.sin(angle)
        return float(transfer.mtf(self.pupil, x, y, **sensor))

    def focus_tolerance(self, least: float = 0.3) -> tuple[float, float]:
        """Return how far the sensor may move for an MTF at half the Nyquist frequency, pixel included.

        Parameters
        ----------
        least : float, default 0.3
            Smallest MTF that suffices.

        Returns
        -------
        (float, float)
            Metres, towards the lens and away from it, as of :func:`lommel.focus_tolerance`.

        Raises
        ------
        ValueError
            If the MTF does not suffice where the sensor is, or for the segments of a mirror, which take minutes.
        """
        if isinstance(self.pupil.stop, Segments) and len(self.pupil.stop.shapes) > _MANY:
            raise ValueError("a tolerance of focus takes minutes for so many segments: lommel.focus_tolerance has it")
        sensor: Any = {"pixel": self.instrument.pixel, "fill": self.instrument.fill}
        frequency = 0.25 / max(self.instrument.pitch)
        here = min(self.mtf(frequency, angle, pixel=True) for angle in (0.0, 0.5 * math.pi))
        if here < least:
            raise ValueError(
                f"the sensor has no focus tolerance, as the MTF at half the Nyquist frequency is {here:.3g}, "
                f"below {least:g}"
            )
        return transfer.focus_tolerance(self.pupil, frequency, least=least, **sensor)

    def mtf50(self, angle: float = 0.0) -> float:
        """Return the frequency at which the MTF of the optics alone falls to 50 %.

        Parameters
        ----------
        angle : float, default 0.0
            Direction, radians from x towards y.

        Returns
        -------
        float
            Cycles per metre.

        Raises
        ------
        ValueError
            If the aperture has more than 24 segments, for which it takes minutes.
        """
        segments = len(self.pupil.opening.regions)
        if segments > _MANY:
            raise ValueError(
                f"MTF50, which takes minutes for {segments} segments: lommel.mtf_frequency(pupil) has it"
            )
        return float(transfer.mtf_frequency(self.pupil, angle=angle))

    @property
    def radii(self) -> dict[str, float]:
        """Radii of interest: of the file, of the Airy disc, of all rays."""
        found, blur = dict(self.instrument.radii), float(self.pupil.geometric_radius())
        found.setdefault("Airy radius", self.pupil.airy_radius)
        if blur > 0:
            found.setdefault("edge of the geometric blur", blur)
        return found

    def encircled_energy(self, *, unaberrated: bool = False) -> tuple[list[float | None], float | None]:
        """Return shares of the light within the `radii` about the axis.

        Parameters
        ----------
        unaberrated : bool, default False
            Without aberrations.

        Returns
        -------
        list of float or None
            None for circles that are too wide.
        float or None
            Bound on their error, None where none is proven.
        """
        pupil, radii = self.pupil.unaberrated() if unaberrated else self.pupil, self.radii.values()
        most = math.inf if pupil.radial else MAX_RADIUS * pupil.scale
        found = encircled(pupil, [r for r in radii if r <= most])
        within = iter(found.fraction.tolist())
        return [next(within) if r <= most else None for r in radii], found.error

    def setup(self) -> Json:
        """Return what is known of the lens, its object and its sensor as plain data, without measures of images.

        Returns
        -------
        dict
        """
        lens, instrument, field = self.lens, self.instrument, self.depth_of_field
        height, width = instrument.pitch
        telescope = math.isinf(lens.focus_distance) and math.isinf(instrument.object_distance)
        sharp = field and {"near": field[0], "far": field[1], "blur": IN_FOCUS * max(height, width)}
        found = {
            "name": instrument.name,
            "source": instrument.source,
            **{name: getattr(lens, name) for name in _OF_LENS},
            "apodization": lens.apodization,
            "focus_distance": lens.focus_distance,
            "sensor_distance": lens.sensor_distance,
            "object_distance": instrument.object_distance,
            "pixel": instrument.pixel,
            "arcsec_per_pixel": width / lens.focal_length / _ARCSEC if telescope else None,
            "pixel_in_object": width * lens.focus_distance / lens.sensor_distance if magnifies(lens) else None,
            "in_focus": sharp,
            "hyperfocal_distance": self.hyperfocal_distance,
            "aperture": {
                "spider": lens.spider,
                "vignetting": lens.vignetting,
                "mask": None if lens.mask is None else {"side": lens.mask.side},
                "stop": None if lens.stop is None else _stop(lens.stop),
            },
            "clear_area": self.pupil.area,
        }
        return dict(plain(found))

    def to_dict(self) -> Json:
        """Return all measures as plain data, None for infinity and what cannot be computed.

        Those along x have plain names, those along y end in "_y"; "refused" has the reasons of what is missing.

        Returns
        -------
        dict
        """
        pupil, pitch, radii = self.pupil, self.instrument.pitch, self.radii
        reasons: dict[str, None] = {}

        def tried(work: Callable[[], Value]) -> Value | None:
            try:
                return work()
            except (ValueError, ArithmeticError) as reason:
                reasons[str(reason)] = None
                return None

        def read(of: PointQuality, *names: str) -> Json:
            return {name: tried(partial(getattr, of, name)) for name in names}

        nothing: tuple[list[float | None], None] = [None] * len(radii), None
        seen, ideal = (tried(partial(self.encircled_energy, unaberrated=flat)) or nothing for flat in (False, True))
        transfers: Json = {}
        for end, angle, side in (("", 0.0, pitch[1]), ("_y", 0.5 * math.pi, pitch[0])):
            nyquist = 0.5 / side
            transfers |= {
                f"mtf50{end}": tried(partial(self.mtf50, angle)),
                f"nyquist{end}": nyquist,
                f"mtf_at_nyquist{end}": tried(partial(self.mtf, nyquist, angle)),
                f"mtf_at_nyquist_with_pixel{end}": tried(partial(self.mtf, nyquist, angle, pixel=True)),
            }
        found = self.setup() | {
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
            "balancing_W020": tried(partial(getattr, self, "balancing_defocus")),
            **read(self, "strehl", "strehl_at_peak", "marechal", "rms_waves", "rms_waves_without_tilt"),
            **self._widths(tried),
            "cutoff": pupil.cutoff,
            **transfers,
            "focus_tolerance": tried(self.focus_tolerance),
        }
        places = None if self.instrument.aberrations_of_field is None else self._places()
        found["field"] = places and {
            **places,
            "places": [
                place | read(one, "strehl", "rms_waves", "strehl_at_peak", "rms_waves_without_tilt")
                for place, one in places["places"]
            ],
        }
        found["encircled_energy"] = [
            {"within": name, "radius": radius, "fraction": a, "unaberrated": b}
            for (name, radius), a, b in zip(radii.items(), seen[0], ideal[0], strict=True)
        ]
        found["encircled_energy_error"] = max((e for e in (seen[1], ideal[1]) if e is not None), default=None)
        return found | {"refused": list(reasons)}

    def _widths(self, tried: Callable[[Callable[[], float]], float | None]) -> dict[str, float | None]:
        """Return FWHM and diameter of 80 % of the light, also with the pixel where that may differ."""
        measures: dict[str, Callable[..., float]] = {"fwhm": self.fwhm, "diameter_80": self.diameter_80}
        found = {name: tried(measure) for name, measure in measures.items()}
        wide = (found["diameter_80"] or math.inf) > _WIDE * min(self.instrument.pitch)
        for name, measure in measures.items():
            hidden = found[name] is None or wide
            found[f"{name}_with_pixel"] = None if hidden else tried(partial(measure, pixel=True))
        return found

    def _places(self) -> Json:
        """Return the description of the field, with places from the axis to a corner of the sensor."""
        assert self.instrument.sensor is not None  # as long as there is a map
        field, (height, width) = self.instrument.field(), self.instrument.sensor
        places = []
        for part in (0.0, 0.5, 0.7, 1.0):
            x, y = 0.5 * part * width, 0.5 * part * height
            try:
                one = PointQuality(field.pupil(x, y))
            except ValueError:  # beyond the map
                continue
            terms = one.pupil.wavefront.to_zernike(unit="waves")
            listed = listed_terms({term: c for term, c in terms.items() if term[0] > 1})
            places.append(({"part": part, "distance": math.hypot(x, y), "zernike": listed}, one))
        seidel = {name: waves for name, waves in field.seidel.items() if waves}
        return {"sensor": [height, width], "reach": field.reach, "seidel": seidel, "places": places}


def magnifies(lens: Lens) -> bool:
    """Return whether the image of the object in focus is larger than it, as with a microscope objective."""
    return 0.0 < lens.focus_distance < lens.sensor_distance


def other_model(instrument: Instrument) -> Json:
    """Return how the PSF changes with the other model of the lens, paraxial or aplanatic; or the "reason" why not.

    "peak_error" is the largest difference of the two PSFs in the window over the peak of the aplanatic one.
    """
    lens = instrument.lens
    model = "aplanatic" if lens.model == "paraxial" else "paraxial"
    # Where the lens magnifies, as an objective does, the sensor is in its design position and the object is not.
    side = "focus" if model == "aplanatic" and magnifies(lens) else lens.corrected_for
    found = {"model": model, "corrected_for": side, "geometric_radius": None, "peak_error": None, "reason": None}
    try:
        # The amplitude stays, also where it is made of angles that a paraxial lens does not have.
        changed = replace(lens, model=model, corrected_for=side, apodization=lens.illumination)
        other = changed.pupil(instrument.object_distance)
        pupils = {lens.model: instrument.pupil(), model: other}
        seen = {
            name: psf(p, instrument.window, instrument.pixel, dtype="float64", **instrument.sensor_options)
            for name, p in pupils.items()
        }
    except ToleranceError:
        return found | {"reason": "cannot be computed to the tolerance"}
    except (ValueError, ArithmeticError, ImportError) as error:
        return found | {"reason": str(error)}
    blur, difference = other.geometric_radius(), errors.peak_error(seen["paraxial"], seen["aplanatic"])
    return found | {"geometric_radius": float(blur), "peak_error": difference}


def sensor_mtf(instrument: Instrument, places: Sequence[Place], channels: Channels | None = None) -> Json:
    """Return the MTF, pixel included, at the Nyquist frequency and at half of it as plain data.

    "frequency" has the Nyquist frequencies along x and y, cycles per metre; "rows" one row for each of the `places`
    and of the `channels`, or for the wavelength of the file, along x and y. Rows of places off the axis also have
    "sagittal" (of radial lines, whose frequency is across the radius) and "tangential", at the smaller Nyquist
    frequency.
    """
    nyquist = [0.5 / side for side in instrument.pitch[::-1]]
    lights: list[tuple[str | None, Polychromatic | None]] = [(None, None)]
    if channels is not None:
        lights = [(name, Polychromatic([w for w, _ in pairs], [s for _, s in pairs])) for name, pairs in channels]
    sensor: Any = {"pixel": instrument.pixel, "fill": instrument.fill, "tol": 1e-6}
    rows = []
    for x, y, pupil in places:
        directions = {"nyquist": np.diag(nyquist)}  # frequency along x, along y
        if x is not None and y is not None and (x or y):
            radial = np.array([x, y]) / math.hypot(x, y)
            directions["radial"] = min(nyquist) * np.array([[-radial[1], radial[0]], radial])
        for name, light in lights:
            found = {
                key: [transfer.mtf(pupil, *(share * f.T), spectrum=light, **sensor).tolist() for share in (1.0, 0.5)]
                for key, f in directions.items()
            }
            row = {
                "x": x,
                "y": y,
                "channel": name,
                "nyquist": found["nyquist"][0],
                "half_nyquist": found["nyquist"][1],
            }
            if "radial" in found:
                row["sagittal"], row["tangential"] = map(list, zip(*found["radial"], strict=True))
            rows.append(row)
    return {"frequency": nyquist, "rows": rows}


def listed_terms(terms: Mapping[tuple[int, int], Numbers]) -> list[Json]:
    """Return Zernike terms in waves rms, in Noll's order."""
    return [
        {"n": n, "m": m, "name": zernike.name(n, m), "waves_rms": float(c)}
        for (n, m), c in sorted(terms.items(), key=lambda item: int(zernike.index_of(item[0][0], item[0][1], "noll")))
    ]


def _stop(stop: Shape | Segments) -> Json:
    """Return the parts of a stop, and the spread of the phases of its segments."""
    shapes = stop.shapes if isinstance(stop, Segments) else (stop,)
    parts = [part for one in shapes for part in one.parts if part != Disc()]  # but the rim itself
    kinds = {"discs": (Disc, CatEye), "ellipses": (Ellipse,), "polygons": (Polygon,)}
    return {
        "segments": len(stop.shapes) if isinstance(stop, Segments) else 0,
        "piston_rms_waves": float(np.std(stop.piston)) / (2.0 * math.pi) if isinstance(stop, Segments) else 0.0,
        "parts": {name: sum(isinstance(part, kind) for part in parts) for name, kind in kinds.items()},
    }


def _across(rho: Array, theta: Array) -> Array:
    return rho * np.cos(theta)


def _down(rho: Array, theta: Array) -> Array:
    return rho * np.sin(theta)


def _tilted(pupil: Pupil, x: float, y: float) -> Pupil:
    """Return a pupil with further tilt, radians at the edge of the pupil along x and y."""
    # A Zernike tilt is normalised to an rms of 1 over the disc: 2 at its edge.
    tilt = Wavefront.zernike({(1, 1): 0.5 * x, (1, -1): 0.5 * y})
    return replace(pupil, wavefront=pupil.wavefront + tilt, geometry=None)


DEPTHS = (0.0, 1e-6, 5e-6, 20e-6, 50e-6)
"""Depths that are listed besides that of the file, metres."""

_OF_OBJECTIVE = ("NA", "magnification", "working_distance", "immersion")
_OF_FOCUS = ("paraxial", "brightest", "axial_fwhm", "lateral_fwhm", "peak")


def microscope_quality(microscope: Microscope, *, foci: bool = True) -> Json:
    """Return what is known of a microscope as plain data; with `foci`, also of a dipole at several depths.

    Lengths in metres: x and y in the sample, z of the stage, "pixel" on the camera. Angles in radians. "refused" has
    the reasons why depths are missing in "focus", where dipoles rotate freely.
    """
    objective, wavelength = microscope.objective, microscope.wavelength
    light, nyquist = illumination(objective.apodization), objective.nyquist(wavelength=wavelength)
    step = abs(microscope.step) if microscope.planes > 1 else None
    design, measured = objective.design, microscope.aberrations
    terms = [] if measured is None else listed_terms(measured.to_zernike(unit="waves"))
    as_designed = design.immersion == objective.immersion and design.coverslip == objective.coverslip
    coarse = {"pixel": microscope.pixel > nyquist.pixel, "step": step is not None and step > nyquist.axial}
    rows, refused = _foci(microscope) if foci else ([], [])
    return {
        "name": microscope.name,
        "source": microscope.source,
        **{name: getattr(objective, name) for name in _OF_OBJECTIVE},
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
        "too_coarse": [name for name, exceeds in coarse.items() if exceeds],
        "focus": rows,
        "refused": refused,
    }


def _foci(microscope: Microscope) -> tuple[list[dict[str, float | None]], list[str]]:
    """Return the foci at several depths, and the reasons why other depths have none."""
    objective, wavelength = microscope.objective, microscope.wavelength
    rows: list[dict[str, float | None]] = []
    refused: dict[str, None] = {}
    surface = float(objective.focus(0.0, wavelength=wavelength).peak)
    for depth in sorted({*DEPTHS, microscope.depth}):
        try:
            found = objective.focus(depth, wavelength=wavelength)
        except ValueError as reason:
            refused[f"{1e6 * depth:.4g} um deep: {reason}"] = None
            continue
        row: dict[str, float | None] = {"depth": depth, "ratio": float(found.ratio) if depth > 0.0 else None}
        row |= {name: float(getattr(found, name)) for name in _OF_FOCUS}
        row["peak_of_surface"] = float(found.peak) / surface
        row["collected"] = float(objective.collected(depth, wavelength=wavelength))
        rows.append(row)
    return rows, list(refused)


def compare_methods(
    instrument: Instrument, methods: Iterable[Method], started: Callable[[str], object] = str
) -> tuple[list[Json], dict[str, PSF]]:
    """Return the errors and times of several methods against the `reference`, and the PSFs of those that apply.

    The PSF of the reference comes first, called "Hankel" or by name and tolerance. Those on other samples than it has
    are left out.
    """
    pupil = instrument.pupil()
    judge = reference(pupil)
    judge_name = type(judge).__name__ if pupil.radial else repr(judge)

    def answer(method: Method, integrate: bool | None) -> PSF:
        window, pixel = instrument.window, instrument.pixel
        fill = 1.0 if integrate is False else instrument.fill
        return psf(pupil, window, pixel, method=method, dtype="float64", integrate=integrate, fill=fill)

    def timed(method: Method, integrate: bool | None) -> tuple[PSF, float]:
        """Return the PSF and the seconds of the second of two runs, or of a first that takes more than a second."""
        for _ in range(2):  # the first one loads libraries and fills caches
            start = time.perf_counter()
            found = answer(method, integrate)
            seconds = time.perf_counter() - start
            if seconds > 1.0:
                break
        return found, seconds

    started(judge_name)
    truth, seconds = timed(judge, instrument.integrate)
    answers, rows = {judge_name: truth}, []
    for method in methods:
        name = type(method).__name__
        row: Json = {"method": name, "options": method.to_dict(), "reason": None}
        row |= dict.fromkeys(("seconds", "mse", "peak_error", "error_bound", "sampling"))
        rows.append(row)
        if isinstance(method, HuygensFresnel) and instrument.lens.model == "paraxial" and magnifies(instrument.lens):
            row["reason"] = 'needs model = "aplanatic": its paraxial model is a flat lens, unlike any objective'
            continue
        if method != judge:
            started(name)
        # Its sums over the area of every pixel would take minutes.
        integrate = False if isinstance(method, HuygensFresnel) else instrument.integrate
        try:
            found, row["seconds"] = (truth, seconds) if method == judge else timed(method, integrate)
        except (ValueError, ArithmeticError, ImportError) as error:
            row["reason"] = str(error)
            continue
        row["sampling"], row["error_bound"] = found.sampling, found.error_bound
        against = truth
        if found.sampling == truth.sampling:
            answers[name] = found
        elif found.sampling == "center":
            against = answer(judge, False)
        row["mse"], row["peak_error"] = errors.mse(found, against), errors.peak_error(found, against)
    return rows, answers
