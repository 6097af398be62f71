"""The controls of the live page, their names, ranges and defaults, and the PSF of their state."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any, NamedTuple
from urllib.parse import quote

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array, Json
from lommel.lensfiles.instrument import Instrument
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.aperture.shapes import Spider
from lommel.optics.lens import Lens
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf


class Row(NamedTuple):
    """A row of the controls: a label, a number box and a slider."""

    group: str
    label: str
    reach: tuple[float, float]
    """Range of the slider; a typed value may be anywhere in the range of the control."""
    step: float | None = 0.01
    """Step of the slider; None for a logarithmic slider."""
    unit: str = ""
    said: str = ""
    """Unit in words."""
    waves: bool = False
    """True if the number is shown in the unit of the wavefront: waves, radians or nanometres."""
    name: str | None = None
    """Text for screen readers, if the label alone is not enough."""
    when: tuple[tuple[str | int, ...], ...] = ()
    """Settings (key, value, value ...): the row is shown if one of them applies; empty if it is always shown."""


class Real(NamedTuple):
    """A control of numbers in a range."""

    initial: float
    low: float
    high: float
    row: Row
    about: str = ""
    """One sentence of help: the quantity, its sign and its unit."""

    def accepted(self, name: str, value: object) -> float:
        """Return the value as a number; ValueError if it is out of range."""
        number = validation.real(name, value)
        if not self.low <= number <= self.high:
            unit = f" {'waves' if self.row.waves else self.row.said}".rstrip()
            raise ValueError(
                f"{name} must be from {self.low:g} to {self.high:g}{unit}, got {validation.shown(value)}"
            )
        return number

    def description(self) -> dict[str, object]:
        """Return the description for the page."""
        return self._asdict() | {"row": self.row._asdict()}


class Whole(Real):
    """A control of integers in a range."""

    def accepted(self, name: str, value: object) -> int:
        """Return the value as an integer; ValueError if it is out of range."""
        return validation.integer(name, value, least=int(self.low), most=int(self.high))

    def description(self) -> dict[str, object]:
        """Return the description for the page."""
        return super().description() | {"whole": True}


class Distance(Real):
    """A control of distances, whose largest value represents infinity."""

    def accepted(self, name: str, value: object) -> float:
        """Return the value as a number, the largest value for infinity; ValueError if it is out of range."""
        return self.high if value == math.inf else super().accepted(name, value)

    def description(self) -> dict[str, object]:
        """Return the description for the page."""
        return super().description() | {"infinite": True}


class Word(NamedTuple):
    """A control with choices, the default first."""

    choices: tuple[str, ...]
    about: str = ""

    @property
    def initial(self) -> str:
        """Default value."""
        return self.choices[0]

    def description(self) -> Json:
        """Return the description for the page."""
        return {"initial": self.initial, "choices": list(self.choices), "about": self.about}

    def accepted(self, name: str, value: object) -> str:
        """Return the value; ValueError if it is not one of the choices."""
        return validation.choice(name, value, self.choices)


class Terms(NamedTuple):
    """A text of Zernike terms, "n,m:waves;n,m:waves", coefficients in waves rms; empty by default."""

    about: str = ""

    @property
    def initial(self) -> str:
        """Default value."""
        return ""

    def description(self) -> Json:
        """Return the description for the page."""
        limits: Json = {"terms": MOST_TERMS, "degree": HIGHEST_DEGREE, "waves": MOST_WAVES}
        return {"initial": self.initial, "about": self.about} | limits

    def accepted(self, name: str, value: object) -> str:
        """Return the text; TypeError or ValueError unless every term is in range and occurs once."""
        if not isinstance(value, str):
            raise TypeError(f"{name} must be a text of Zernike terms, got {validation.shown(value)}")
        parts = [part for part in value.split(";") if part]
        terms = [term for part in parts if (term := _term(part)) is not None]
        if len(terms) < len(parts) or len(parts) > MOST_TERMS or len(dict(terms)) < len(parts):
            raise ValueError(
                f"{name} must be up to {MOST_TERMS} different terms 'n,m:waves' separated by ';', with 1 <= n <= "
                f"{HIGHEST_DEGREE}, |m| <= n, n - m even and waves (rms) from -{MOST_WAVES} to {MOST_WAVES}, such as "
                f"'4,2:0.05;6,0:-0.01', got {validation.shown(value)}"
            )
        return value


MOST_TERMS, HIGHEST_DEGREE, MOST_WAVES = 90, 12, 10
_TERM = re.compile(r"(\d{1,2}),(-?\d{1,2}):([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d{1,3})?)", re.ASCII)


def _term(part: str) -> tuple[tuple[int, int], float] | None:
    match = _TERM.fullmatch(part)
    if match is None:
        return None
    (n, m), waves = map(int, match.groups()[:2]), float(match[3])
    valid = 1 <= n <= HIGHEST_DEGREE and abs(m) <= n and (n - m) % 2 == 0 and abs(waves) <= MOST_WAVES
    return ((n, m), waves) if valid else None


def further_terms(text: str) -> dict[tuple[int, int], float]:
    """Return the Zernike terms (n, m) of a checked text, waves rms."""
    return dict(term for part in text.split(";") if part and (term := _term(part)) is not None)


# Aberrations with a direction, by their Zernike term; one slider sets the size and a second slider the direction.
DIRECTED = {"coma": (3, 1), "astigmatism": (2, 2), "trefoil": (3, 3)}
_POLYNOMIAL = {"coma": "(3ρ³ − 2ρ) cos θ", "astigmatism": "ρ² cos 2θ", "trefoil": "ρ³ cos 3θ"}
_SEIDEL = {
    "coma": ": a third of Seidel's W131, so that W131 = 0.75 is 0.25 here",
    "astigmatism": ": half of Seidel's W222, whose other half is defocus",
}
_DIRECTION = {
    "coma": "the tail of the image points, degrees from the right, clockwise",
    "astigmatism": "the image is wide where defocus is positive, degrees from the right, clockwise",
    "trefoil": "the first ring of a little trefoil is brightest, degrees from the right, clockwise",
}


def _aberration(name: str) -> dict[str, Real | Word | Terms]:
    n, m = DIRECTED[name]
    size = Row("Wavefront", name.capitalize(), (0, 3), waves=True)
    half_turn = 180 // m
    angle = Row("Wavefront", "angle", (-half_turn, half_turn), 1, "°", "degrees", name=f"Direction of {name}")
    about = f"Zernike term ({n}, {m}), {_POLYNOMIAL[name]}, waves at the edge of the pupil{_SEIDEL.get(name, '')}."
    angle_help = f"Direction in which {_DIRECTION[name]}."
    return {name: Real(0, 0, 10, size, about), f"{name}_angle": Real(0, -half_turn, half_turn, angle, angle_help)}


_LENS, _SENSOR = "Lens and light", "Sensor"
MOST_VANES = 8
_VANES, _NOISE = (("vanes", *range(1, MOST_VANES + 1)),), (("noise", "on"),)
_WAVES, _DISTANCES, _ANGLES = (("focus", "waves"),), (("focus", "distances"),), (("length_unit", "arcsec"),)

_ABOUT = {
    "focus": "Input of defocus: in waves, or by focal length, f-number, focus distance and object distance.",
    "defocus": (
        "Seidel term W020 ρ², waves at the edge of the pupil; positive: the sensor lies between lens and focus."
    ),
    "focus_distance": "Distance from the lens to objects in focus, metres, above the focal length; inf for infinity.",
    "object_distance": (
        "Distance from the lens to the point object, metres, inf for infinity; nearer than the focus distance is "
        "positive defocus."
    ),
    "spherical": (
        "Seidel term W040 ρ⁴, waves at the edge of the pupil, unlike the Zernike term (4, 0) without defocus; "
        "positive: marginal rays focus beyond paraxial ones."
    ),
    "zernike": (
        "Zernike terms without a slider, of an opened file or of the address (zernike=4,2:0.05;6,0:-0.01): "
        "n,m:waves rms."
    ),
    "focal_length": "Focal length of the lens, millimetres; converts lengths on the sensor to angles.",
    "f_number": "Sensor distance divided by aperture diameter; with distances, focal length divided by it.",
    "obscuration": "Radius of the central obscuration divided by the radius of the aperture.",
    "vanes": (
        "Number of straight vanes from the axis to the edge of the aperture, at equal angles; a logarithmic scale "
        "shows their spikes."
    ),
    "vane_width": "Width of each vane divided by the radius of the aperture.",
    "vane_angle": "Direction of the first vane, degrees from the right, clockwise.",
    "wavelength": (
        "Wavelength of the light, nanometres; in white light, the one at which the wavefront is given in waves."
    ),
    "light": "One wavelength, or seven lines of equal energy, 450 to 650 nm, with the same optical paths.",
    "pixel": "Pitch of the square pixels of the sensor, micrometres.",
    "view": "A fine grid over the whole image, or the sensor's pixels: samples at their centres, or averages.",
    "side": "Height and width of the computed image, pixels.",
    "noise": "Photon noise and read noise of the sensor in the displayed images.",
    "photons": "Expected number of detected photons: of the whole PSF, and at a white pixel of the picture.",
    "read_noise": "Standard deviation of the read noise of each pixel, electrons.",
    "rays": "Points where rays through the pupil meet the sensor, without diffraction.",
    "stretch": "Brightness scale of the PSF: square root, linear or logarithmic.",
    "map": "Colours of the PSF; automatic: true colour in white light, inferno in light of one wavelength.",
    "waves_unit": "Unit of the wavefront: waves, radians, or nanometres of path.",
    "length_unit": "Unit of lengths on the sensor: micrometres, arcseconds, wavelength times f-number.",
    "picture": "Picture that the sensor records through the lens.",
}

_CONTROLS: dict[str, Real | Word | Terms] = {
    "focus": Word(("waves", "distances")),
    "defocus": Real(0.6, -50, 50, Row("Wavefront", "Defocus", (-5, 5), waves=True, when=_WAVES)),
    "focus_distance": Distance(
        2,
        1e-3,
        1e12,
        Row("Wavefront", "Focused at", (0.1, 1000), None, "m", "metres", name="Focus distance", when=_DISTANCES),
    ),
    "object_distance": Distance(
        1.9,
        1e-3,
        1e12,
        Row("Wavefront", "Object at", (0.1, 1000), None, "m", "metres", name="Object distance", when=_DISTANCES),
    ),
    "spherical": Real(0, -25, 25, Row("Wavefront", "Spherical", (-5, 5), waves=True)),
    **{key: field for name in DIRECTED for key, field in _aberration(name).items()},
    "zernike": Terms(),
    "focal_length": Real(
        50, 0.1, 1e6, Row(_LENS, "Focal length", (1, 10000), None, "mm", "millimetres", when=(*_ANGLES, *_DISTANCES))
    ),
    "f_number": Real(4, 0.7, 300, Row(_LENS, "f-number", (1, 32), None)),
    "obscuration": Real(0, 0, 0.9, Row(_LENS, "Obscuration", (0, 0.9), 0.01, "of the radius", "of the radius")),
    "vanes": Whole(0, 0, MOST_VANES, Row(_LENS, "Vanes", (0, MOST_VANES), 1, name="Number of vanes")),
    "vane_width": Real(
        0.03,
        0.001,
        0.5,
        Row(_LENS, "width", (0.005, 0.2), 0.005, "of the radius", "of the radius", name="Vane width", when=_VANES),
    ),
    "vane_angle": Real(
        0,
        -180,
        180,
        Row(_LENS, "angle", (-180, 180), 1, "°", "degrees", name="Direction of the first vane", when=_VANES),
    ),
    "wavelength": Real(550, 100, 30000, Row(_LENS, "Wavelength", (380, 780), 1, "nm", "nanometres")),
    "light": Word(("mono", "white")),
    "pixel": Real(2, 0.05, 200, Row(_SENSOR, "Pixel of the sensor", (0.5, 20), None, "µm", "micrometres")),
    "view": Word(("fine", "sampled", "averaged")),
    "side": Whole(512, 16, 1024, Row(_SENSOR, "Window", (64, 1024), 16, "pixels wide", "pixels wide")),
    "noise": Word(("off", "on")),
    "photons": Real(10000, 1, 1e9, Row(_SENSOR, "Photons", (10, 1e6), None, "", "electrons", when=_NOISE)),
    "read_noise": Real(2, 0, 1000, Row(_SENSOR, "Read noise", (0, 20), 0.1, "e⁻ rms", "electrons rms", when=_NOISE)),
    "rays": Word(("off", "on")),
    "stretch": Word(("sqrt", "linear", "log")),
    "map": Word(("auto", "inferno", "viridis", "cividis", "gray")),
    "waves_unit": Word(("waves", "rad", "nm")),
    "length_unit": Word(("um", "arcsec", "lambdaN")),
    "picture": Word(("star", "bars", "text", "points", "own")),
}

FIELDS: dict[str, Real | Word | Terms] = {
    name: one._replace(about=_ABOUT[name]) if name in _ABOUT else one for name, one in _CONTROLS.items()
}
"""Controls by name. Units: waves at the edge of the pupil (W020, W040, and Zernike terms that are 1 at the
edge), degrees, nanometres, micrometres, pixels; metres for distances, millimetres for the focal length."""

# White light on the page: lines of equal energy, nanometres.
WHITE = np.linspace(450.0, 650.0, 7)


def colour_weights() -> Array:
    """Return the weights of the lines of white light in linear sRGB, shape (lines, 3); each colour has the sum 1.

    The colour-matching functions are those of the CIE 1931 standard observer, as fitted by Wyman, Sloan and Shirley,
    Simple analytic approximations to the CIE XYZ color matching functions, J. Comput. Graph. Tech. 2(2), 2013. The
    sums of 1 make the spectrum itself white.
    """

    def lobe(height: float, peak: float, width_below: float, width_above: float) -> Array:
        width = np.where(peak > WHITE, width_below, width_above)
        return height * np.exp(-0.5 * ((WHITE - peak) / width) ** 2)

    x = lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) + lobe(-0.065, 501.1, 20.4, 26.2)
    y = lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1)
    z = lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8)
    # Conversion from XYZ to linear sRGB of IEC 61966-2-1.
    to_srgb = np.array([[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]])
    weights: Array = np.stack([x, y, z], axis=1) @ to_srgb.T
    weights /= weights.sum(axis=0)
    return weights


def powers(n: int, m: int) -> list[tuple[int, int]]:
    """Return the pairs (power of rho, factor) of the radial polynomial of a Zernike term."""
    f = math.factorial
    return [
        (n - 2 * k, (-1) ** k * f(n - k) // (f(k) * f((n + m) // 2 - k) * f((n - m) // 2 - k)))
        for k in range((n - m) // 2 + 1)
    ]


def complete(values: Mapping[str, object]) -> Json:
    """Return a complete state from given values and the defaults."""
    for name in values:
        validation.choice("a name of the state", name, tuple(FIELDS))
    return {name: field.accepted(name, values.get(name, field.initial)) for name, field in FIELDS.items()}


def link(state: Mapping[str, object]) -> str:
    """Return the fragment of an address that opens the page in a state."""
    full_state = complete(state)
    return "&".join(
        f"{name}={quote(str(value).removesuffix('.0'), safe=',:;')}"
        for name, field in FIELDS.items()
        if (value := full_state[name]) != field.initial
    )


def state_of(instrument: Instrument) -> tuple[Json, str]:
    """Return (1) the state that shows an instrument and (2) a text that lists features the page cannot show.

    A paraxial lens with an object or a focus nearer than infinity is shown by its distances, other lenses by defocus.
    """
    pupil, lens = instrument.pupil(), instrument.lens_at_place
    if pupil.wavelength is None or pupil.f_number is None or pupil.shape:
        raise ValueError("the live page requires one pupil with a wavelength and an f-number")
    is_near = min(lens.focus_distance, instrument.object_distance) < _FAR and lens.focus_distance > 0.0
    distances = is_near and lens.model == "paraxial"
    wavefront = lens.aberrations if distances else pupil.wavefront
    waves = {term: float(c) / math.tau for term, c in wavefront.edge_terms().items()}
    state = _sliders(waves, distances=distances)
    if distances:
        state["focus"] = "distances"
        state["focus_distance"] = min(lens.focus_distance, _FAR)
        state["object_distance"] = min(instrument.object_distance, _FAR)
    state |= {
        "f_number": lens.f_number if distances else float(pupil.f_number),
        "obscuration": pupil.obscuration,
        "wavelength": pupil.wavelength * 1e9,
        "pixel": instrument.side * 1e6,
        "focal_length": lens.focal_length * 1e3,
    }
    vanes = _vanes(lens.spider)
    _require_range(state | vanes, instrument.name)
    state = {name: float(f"{value:.9g}") if isinstance(value, float) else value for name, value in state.items()}
    state["zernike"], remaining_rms = _without_slider(waves)
    left_out = {
        f"further Zernike terms, {remaining_rms:.1g} waves rms": remaining_rms > 1e-9,
        "the spider": not vanes and lens.spider is not None,
        "the vignetting": pupil.vignetting is not None,
        "the stop": pupil.stop is not None,
        "the mask": pupil.mask is not None,
        "the apodization": not pupil.illumination.uniform,
        "colour aberrations": lens.colour is not None,
        f"aberrations of the field but those {instrument.place_in_words}": instrument.aberrations_of_field
        is not None,
    }
    changed = {name: value for name, value in (state | vanes).items() if value != FIELDS[name].initial}
    return changed, "; ".join(text for text, is_left_out in left_out.items() if is_left_out)


def _sliders(waves: dict[tuple[int, int], float], *, distances: bool) -> Json:
    """Return the values of the sliders, and remove their Zernike terms (waves at the edge) from `waves`."""
    waves.pop((0, 0), 0.0)
    # W020 and W040 follow from the Zernike terms 2 rho^2 - 1 and 6 rho^4 - 6 rho^2 + 1.
    spherical = 6.0 * waves.pop((4, 0), 0.0)
    state: Json = {"spherical": spherical}
    if distances:
        waves[2, 0] = waves.get((2, 0), 0.0) - 0.5 * spherical
    else:
        state["defocus"] = 2.0 * waves.pop((2, 0), 0.0) - spherical
    for name, (n, m) in DIRECTED.items():
        cosine, sine = waves.pop((n, m), 0.0), waves.pop((n, -m), 0.0)
        state[name] = math.hypot(cosine, sine)
        state[f"{name}_angle"] = math.degrees(math.atan2(sine, cosine)) / m
    return state


def _require_range(state: Json, lens: str) -> None:
    """Raise ValueError if a number of a lens is out of the range of its control."""
    for name, value in state.items():
        field = FIELDS[name]
        if isinstance(field, Real) and not field.low <= value <= field.high:
            unit = " waves" if field.row.waves else f" {field.row.said}".rstrip()
            raise ValueError(
                f"{name} must be from {field.low:g} to {field.high:g}{unit} on the live page, got {value:.4g} of "
                f"{lens or 'the lens file'!r}"
            )


def _without_slider(waves: dict[tuple[int, int], float]) -> tuple[str, float]:
    """Return (1) the text of Zernike terms without a slider and (2) the rms (waves) of terms beyond its limits."""
    rms = {(n, m): c / edge_factor(n, m) for (n, m), c in waves.items()}
    # Largest first, as the number of terms is limited.
    terms = sorted((term for term in rms if 1e-10 < abs(rms[term]) <= MOST_WAVES), key=lambda term: -abs(rms[term]))
    terms = [term for term in terms if term[0] <= HIGHEST_DEGREE][:MOST_TERMS]
    text = ";".join(f"{n},{m}:{rms.pop((n, m)):.9g}" for n, m in sorted(terms))
    return text, math.sqrt(sum(c * c for c in rms.values()))


_FAR = 1e12  # distance that represents infinity, metres


def edge_factor(n: int, m: int) -> float:
    """Return the value at the edge of the pupil of a Zernike term with an rms of 1 over the full pupil."""
    return math.sqrt((1 if m == 0 else 2) * (n + 1))


def _vanes(spider: Spider | None) -> Json:
    """Return the part of a state with the vanes of a spider; empty without vanes at equal angles."""
    if spider is None or len(spider.angles) > MOST_VANES:
        return {}
    count, first_angle = len(spider.angles), min(spider.angles, key=abs)
    steps = sorted(((angle - first_angle) * count / math.tau) % count for angle in spider.angles)
    if any(abs(step - round(step)) > 1e-9 for step in steps) or len({round(s) % count for s in steps}) < count:
        return {}
    degrees = math.degrees(math.remainder(first_angle, math.tau))
    return {"vanes": count, "vane_width": float(f"{spider.width:.9g}"), "vane_angle": float(f"{degrees:.9g}")}


def pupil_of(state: Mapping[str, object]) -> Pupil:
    """Return the pupil of a state."""
    full_state = complete(state)
    distances = full_state["focus"] == "distances"
    wavefront = Wavefront.from_seidel(W020=0.0 if distances else full_state["defocus"], W040=full_state["spherical"])
    for name, (n, m) in DIRECTED.items():
        if size := full_state[name]:
            term = Wavefront.zernike({(n, m): size}, unit="waves", normalization="edge")
            wavefront += term.rotated(math.radians(full_state[f"{name}_angle"]))
    if terms := further_terms(full_state["zernike"]):
        wavefront += Wavefront.zernike(terms, unit="waves")
    common: Json = {"obscuration": full_state["obscuration"], "wavelength": full_state["wavelength"] * 1e-9}
    if full_state["vanes"]:
        first = math.radians(full_state["vane_angle"])
        common["spider"] = Spider.equal(full_state["vanes"], full_state["vane_width"], first)
    if not distances:
        return Pupil(wavefront, f_number=full_state["f_number"], **common)
    focal = full_state["focal_length"] * 1e-3
    # The diameter is passed, because Lens may reject an f-number with a focal length above 1 m as a wrong unit.
    lens = Lens(
        focal_length=focal,
        aperture_diameter=focal / full_state["f_number"],
        focus_distance=full_state["focus_distance"],
        aberrations=wavefront,
        **common,
    )
    return lens.pupil(full_state["object_distance"])


def psf_of(state: Mapping[str, object], **options: Any) -> PSF:
    """Return the PSF that the page shows in a state, with further options of :func:`lommel.psf`."""
    full_state = complete(state)
    pupil = pupil_of(full_state)
    if full_state["light"] == "white":
        options.setdefault("method", Polychromatic(list(WHITE * 1e-9), [1.0] * len(WHITE)))
    reach, side, pixel = _fine_reach(pupil), full_state["side"], full_state["pixel"] * 1e-6
    if full_state["view"] == "fine":
        pixel = 2.0 * reach / side
    elif full_state["vanes"]:
        # The page limits the window, too, since the computing time with vanes increases with its size.
        side = min(side, max(64, 2 * math.ceil(reach / pixel)))
    return psf(pupil, side, pixel, integrate=full_state["view"] == "averaged", **options)


def _fine_reach(pupil: Pupil) -> float:
    """Return half the side (metres) of the default window: it has the geometric blur and some diffraction rings."""
    # The same samples and steps of sqrt(2) as in fineReach() of the page.
    rho = pupil.obscuration + (1.0 - pupil.obscuration) * np.arange(25)[:, None] / 24.0
    theta = math.tau * np.arange(48) / 48.0
    radial_slope = np.zeros((25, 48))
    angular_slope = np.zeros_like(radial_slope)
    for (n, m), edge in pupil.wavefront.edge_terms().items():
        quotient, slope = np.zeros_like(rho), np.zeros_like(rho)  # radial part divided by rho, derivative of the part
        for power, factor in powers(n, abs(m)):
            if power:
                quotient, slope = quotient + factor * rho ** (power - 1), slope + factor * power * rho ** (power - 1)
        angle = abs(m) * theta - (math.pi / 2 if m < 0 else 0.0)
        radial_slope += float(edge) * slope * np.cos(angle)
        angular_slope -= float(edge) * quotient * abs(m) * np.sin(angle)
    v = 1.15 * float(np.hypot(radial_slope, angular_slope).max()) + 14.0
    assert pupil.wavelength is not None
    assert pupil.f_number is not None
    reach = v * pupil.wavelength * 1e6 * pupil.f_number / math.pi
    return float(1e-6 * 2.0 ** (math.ceil(2.0 * math.log2(reach)) / 2.0))
