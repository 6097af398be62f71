"""The controls of the live page, their names, ranges and defaults, and the PSF of their state."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any, NamedTuple
from urllib.parse import quote

import numpy as np

from lommel.base import validation
from lommel.lensfiles.instrument import Instrument
from lommel.methods.polychromatic import Polychromatic
from lommel.optics.pupil import Pupil
from lommel.optics.wavefront.wavefront import Wavefront
from lommel.psf import PSF, psf


class Row(NamedTuple):
    """A row of the controls: a label, a number box and a slider."""

    group: str
    label: str
    reach: tuple[float, float]
    """Of the slider; a typed value may lie beyond it, anywhere in the range of the field."""
    step: float | None = 0.01
    """Of the slider; None where it is logarithmic."""
    unit: str = ""
    said: str = ""
    """The unit in words."""
    waves: bool = False
    """Whether the number is shown in the unit of the wavefront instead: waves, radians or nanometres."""
    name: str | None = None
    """For screen readers, where the label does not say enough."""
    when: tuple[tuple[str | int, ...], ...] = ()
    """Settings (key, value, value ...) with any of which the row is shown; empty where it always is."""


class Real(NamedTuple):
    """A control of numbers in a range."""

    initial: float
    low: float
    high: float
    row: Row
    about: str
    """One sentence of help: the quantity, its sign and its unit."""

    def accepted(self, name: str, value: object) -> float:
        """Return the number, which is in the range."""
        number = validation.real(name, value)
        if not self.low <= number <= self.high:
            raise ValueError(f"{name} must be from {self.low:g} to {self.high:g}, got {validation.shown(value)}")
        return number

    def told(self) -> dict[str, object]:
        """Return the description for the page."""
        return self._asdict() | {"row": self.row._asdict()}


class Whole(Real):
    """A control of integers in a range."""

    def accepted(self, name: str, value: object) -> int:
        """Return the number, which is in the range."""
        return validation.integer(name, value, least=int(self.low), most=int(self.high))

    def told(self) -> dict[str, object]:
        """Return the description for the page."""
        return super().told() | {"whole": True}


class Word(NamedTuple):
    """A control with choices, the default first."""

    choices: tuple[str, ...]
    about: str

    @property
    def initial(self) -> str:
        """The default."""
        return self.choices[0]

    def told(self) -> dict[str, Any]:
        """Return the description for the page."""
        return {"initial": self.initial, "choices": list(self.choices), "about": self.about}

    def accepted(self, name: str, value: object) -> str:
        """Return the choice, checked."""
        return validation.choice(name, value, self.choices)


class Terms(NamedTuple):
    """A text of Zernike terms, "n,m:waves;n,m:waves", coefficients in waves rms; empty by default."""

    about: str

    @property
    def initial(self) -> str:
        """The default."""
        return ""

    def told(self) -> dict[str, Any]:
        """Return the description for the page."""
        limits: dict[str, Any] = {"terms": MOST_TERMS, "degree": HIGHEST_DEGREE, "waves": MOST_WAVES}
        return {"initial": self.initial, "about": self.about} | limits

    def accepted(self, name: str, value: object) -> str:
        """Return the text, of which every term is in range and occurs once."""
        if not isinstance(value, str):
            raise TypeError(f"{name} must be a text of Zernike terms, got {validation.shown(value)}")
        listed = [part for part in value.split(";") if part]
        found = [term for part in listed if (term := _term(part)) is not None]
        if len(found) < len(listed) or len(listed) > MOST_TERMS or len(dict(found)) < len(listed):
            raise ValueError(
                f"{name} must be up to {MOST_TERMS} different terms 'n,m:waves' separated by ';', with 1 <= n <= "
                f"{HIGHEST_DEGREE}, |m| <= n, n - m even and waves (rms) from -{MOST_WAVES} to {MOST_WAVES}, such as "
                f"'4,2:0.05;6,0:-0.01', got {validation.shown(value)}"
            )
        return value


MOST_TERMS, HIGHEST_DEGREE, MOST_WAVES = 100, 20, 10
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


# Aberrations with a direction, by their Zernike term; each has a slider for its size and one for its direction.
DIRECTED = {"coma": (3, 1), "astigmatism": (2, 2), "trefoil": (3, 3)}
_DIRECTION = {
    "coma": "the tail of the image points, degrees from the right, clockwise",
    "astigmatism": "the image is wide where defocus is positive, degrees from the right, clockwise",
    "trefoil": "the first ring of a little trefoil is brightest, degrees from the right, clockwise",
}


def _aberration(name: str) -> dict[str, Real | Word | Terms]:
    n, m = DIRECTED[name]
    size = Row("Wavefront", name.capitalize(), (0, 3), waves=True)
    half = 180 // m
    angle = Row("Wavefront", "angle", (-half, half), 1, "°", "degrees", name=f"Direction of {name}")
    about = f"Zernike term ({n}, {m}), waves at the edge of the pupil, in the direction of its angle."
    direction = f"Direction in which {_DIRECTION[name]}."
    return {name: Real(0, 0, 10, size, about), f"{name}_angle": Real(0, -half, half, angle, direction)}


_LENS, _SENSOR = "Lens and light", "Sensor"
_VANES, _NOISE = (("vanes", *range(1, 9)),), (("noise", "on"),)
_DISTANCES, _ANGLES = ("focus", "distances"), ("length_unit", "arcsec")

FIELDS: dict[str, Real | Word | Terms] = {
    "focus": Word(
        ("waves", "distances"),
        "How defocus is set: in waves, or by focal length, f-number, focus distance and object distance.",
    ),
    "defocus": Real(
        0.6,
        -50,
        50,
        Row("Wavefront", "Defocus", (-5, 5), waves=True, when=(("focus", "waves"),)),
        "Seidel defocus W020, waves at the edge of the pupil; positive: the sensor lies between lens and focus.",
    ),
    "focus_distance": Real(
        2,
        1e-3,
        1e12,
        Row("Wavefront", "Focused at", (0.1, 1000), None, "m", "metres", name="Focus distance", when=(_DISTANCES,)),
        "Distance from the lens to objects in focus, metres, above the focal length; 1e12 stands for infinity.",
    ),
    "object_distance": Real(
        1.99,
        1e-3,
        1e12,
        Row("Wavefront", "Object at", (0.1, 1000), None, "m", "metres", name="Object distance", when=(_DISTANCES,)),
        "Distance from the lens to the point object, metres; nearer than the focus distance is positive defocus.",
    ),
    "spherical": Real(
        0,
        -25,
        25,
        Row("Wavefront", "Spherical", (-5, 5), waves=True),
        "Seidel spherical aberration W040, waves at the edge of the pupil; positive: marginal rays focus beyond "
        "paraxial ones.",
    ),
    **{key: field for name in DIRECTED for key, field in _aberration(name).items()},
    "zernike": Terms(
        "Further Zernike terms added to the wavefront, written n,m:waves and separated by semicolons; waves rms."
    ),
    "focal_length": Real(
        50,
        0.1,
        1e6,
        Row(_LENS, "Focal length", (1, 10000), None, "mm", "millimetres", when=(_ANGLES, _DISTANCES)),
        "Focal length of the lens, millimetres; converts lengths on the sensor to angles.",
    ),
    "f_number": Real(
        4,
        0.7,
        100,
        Row(_LENS, "f-number", (1, 32), None),
        "Sensor distance over the diameter of the aperture; with distances, focal length over the diameter.",
    ),
    "obscuration": Real(
        0,
        0,
        0.9,
        Row(_LENS, "Obscuration", (0, 0.9), 0.01, "of the radius", "of the radius"),
        "Radius of the central obscuration over the radius of the aperture.",
    ),
    "vanes": Whole(
        0,
        0,
        8,
        Row(_LENS, "Vanes", (0, 8), 1, name="Number of vanes"),
        "Number of straight vanes from the axis to the edge of the aperture, at equal angles.",
    ),
    "vane_width": Real(
        0.03,
        0.001,
        0.5,
        Row(_LENS, "width", (0.005, 0.2), 0.005, "of the radius", "of the radius", name="Vane width", when=_VANES),
        "Width of each vane over the radius of the aperture.",
    ),
    "vane_angle": Real(
        0,
        -180,
        180,
        Row(_LENS, "angle", (-180, 180), 1, "°", "degrees", name="Direction of the first vane", when=_VANES),
        "Direction of the first vane, degrees from the right, clockwise.",
    ),
    "wavelength": Real(
        550,
        200,
        2000,
        Row(_LENS, "Wavelength", (380, 780), 1, "nm", "nanometres"),
        "Wavelength of the light, nanometres; in white light, the one at which the wavefront is given in waves.",
    ),
    "light": Word(
        ("mono", "white"),
        "One wavelength, or seven lines of equal energy, 450 to 650 nm, with the same optical paths.",
    ),
    "pixel": Real(
        2,
        0.05,
        50,
        Row(_SENSOR, "Pixel of the sensor", (0.5, 20), None, "µm", "micrometres"),
        "Pitch of the square pixels of the sensor, micrometres.",
    ),
    "view": Word(
        ("fine", "sampled", "averaged"),
        "A fine grid over the whole image, or the sensor's pixels: samples at their centres, or averages.",
    ),
    "side": Whole(
        512,
        16,
        1024,
        Row(_SENSOR, "Window", (64, 1024), 16, "pixels wide", "pixels wide"),
        "Height and width of the computed image, pixels.",
    ),
    "noise": Word(("off", "on"), "Photon noise and read noise of the sensor in the displayed images."),
    "photons": Real(
        10000,
        1,
        1e9,
        Row(_SENSOR, "Photons", (10, 1e6), None, "", "electrons", when=_NOISE),
        "Expected number of detected photons: of the whole PSF, and at a white pixel of the picture.",
    ),
    "read_noise": Real(
        2,
        0,
        1000,
        Row(_SENSOR, "Read noise", (0, 20), 0.1, "e⁻ rms", "electrons rms", when=_NOISE),
        "Standard deviation of the read noise of each pixel, electrons.",
    ),
    "rays": Word(("off", "on"), "Points where rays through the pupil meet the sensor, without diffraction."),
    "stretch": Word(("sqrt", "linear", "log"), "Brightness scale of the PSF: square root, linear or logarithmic."),
    "map": Word(("inferno", "viridis", "cividis", "gray"), "Colours of the PSF."),
    "waves_unit": Word(("waves", "rad", "nm"), "Unit of the wavefront: waves, radians, or nanometres of path."),
    "length_unit": Word(
        ("um", "arcsec", "lambdaN"),
        "Unit of lengths on the sensor: micrometres, arcseconds, wavelength times f-number.",
    ),
    "picture": Word(("star", "bars", "text", "points", "own"), "Picture that the sensor records through the lens."),
}
"""In waves at the edge (W020 and Seidel's W040; the others Zernike terms that are 1 there), degrees, nanometres,
micrometres, pixels, metres for distances and millimetres for the focal length."""

# White light on the page: lines of equal energy, nanometres.
WHITE = np.linspace(450.0, 650.0, 7)


def powers(n: int, m: int) -> list[tuple[int, int]]:
    """Return the powers of rho in the radial polynomial of a Zernike term, each with its factor."""
    f = math.factorial
    return [
        (n - 2 * k, (-1) ** k * f(n - k) // (f(k) * f((n + m) // 2 - k) * f((n - m) // 2 - k)))
        for k in range((n - m) // 2 + 1)
    ]


def complete(given: Mapping[str, object]) -> dict[str, Any]:
    """Return a complete state from given values and the defaults."""
    for name in given:
        validation.choice("a name of the state", name, tuple(FIELDS))
    return {name: field.accepted(name, given.get(name, field.initial)) for name, field in FIELDS.items()}


def link(state: Mapping[str, object]) -> str:
    """Return the fragment of an address that opens the page in a state."""
    whole = complete(state)
    return "&".join(
        f"{name}={quote(str(value).removesuffix('.0'), safe=',:;')}"
        for name, field in FIELDS.items()
        if (value := whole[name]) != field.initial
    )


def state_of(instrument: Instrument) -> tuple[dict[str, float], str]:
    """Return the state that shows an instrument, and a list of its features that the page cannot show."""
    pupil = instrument.pupil()
    if pupil.wavelength is None or pupil.f_number is None or pupil.shape:
        raise ValueError("the live page takes one pupil with a wavelength and an f-number")
    waves = {term: float(c) / math.tau for term, c in pupil.wavefront.edge_terms().items()}
    waves.pop((0, 0), 0.0)
    # W020 and W040 of the Zernike terms of these powers, 2 rho^2 - 1 and 6 rho^4 - 6 rho^2 + 1.
    spherical = 6.0 * waves.pop((4, 0), 0.0)
    state = {"defocus": 2.0 * waves.pop((2, 0), 0.0) - spherical, "spherical": spherical}
    for name, (n, m) in DIRECTED.items():
        along, across = waves.pop((n, m), 0.0), waves.pop((n, -m), 0.0)
        state[name] = math.hypot(along, across)
        state[f"{name}_angle"] = math.degrees(math.atan2(across, along)) / m
    state |= {
        "f_number": float(pupil.f_number),
        "obscuration": pupil.obscuration,
        "wavelength": pupil.wavelength * 1e9,
        "pixel": instrument.side * 1e6,
        "focal_length": instrument.lens.focal_length * 1e3,
    }
    for name, value in state.items():
        field = FIELDS[name]
        if isinstance(field, Real) and not field.low <= value <= field.high:
            raise ValueError(
                f"{name} must be from {field.low:g} to {field.high:g} on the live page, got {value:.4g} of "
                f"{instrument.name or 'the lens file'!r}"
            )
    state = {name: float(f"{value:.9g}") for name, value in state.items()}
    tilts = [waves.pop(term, 0.0) for term in ((1, 1), (1, -1))]
    higher = math.sqrt(sum(c * c for c in waves.values()))
    left_out = {
        "tilt, which moves the image": any(tilts),
        f"terms of higher order, {higher:.1g} waves": higher > 0.0,
        "the spider, vignetting or mask": not pupil.circular,
        "the apodization": not pupil.illumination.uniform,
        "aberrations of the field": instrument.aberrations_of_field is not None,
    }
    changed = {name: value for name, value in state.items() if value != FIELDS[name].initial}
    return changed, "; ".join(text for text, there in left_out.items() if there)


def pupil_of(state: Mapping[str, object]) -> Pupil:
    """Return the pupil of a state."""
    whole = complete(state)
    wavefront = Wavefront.from_seidel(W020=whole["defocus"], W040=whole["spherical"])
    for name, (n, m) in DIRECTED.items():
        if size := whole[name]:
            turned = Wavefront.zernike({(n, m): size}, unit="waves", normalization="edge")
            wavefront += turned.rotated(math.radians(whole[f"{name}_angle"]))
    return Pupil(
        wavefront,
        obscuration=whole["obscuration"],
        wavelength=whole["wavelength"] * 1e-9,
        f_number=whole["f_number"],
    )


def psf_of(state: Mapping[str, object], **options: Any) -> PSF:
    """Return the PSF that the page shows in a state, with further options of :func:`lommel.psf`."""
    whole = complete(state)
    pupil = pupil_of(whole)
    if whole["light"] == "white":
        options.setdefault("method", Polychromatic(list(WHITE * 1e-9), [1.0] * len(WHITE)))
    pixel = _fine_pixel(whole) if whole["view"] == "fine" else whole["pixel"] * 1e-6
    return psf(pupil, whole["side"], pixel, integrate=whole["view"] == "averaged", **options)


def _fine_pixel(state: Mapping[str, Any]) -> float:
    """Return the pixel of the page's own window, which holds the geometric blur and some rings."""
    # The same samples and steps of sqrt(2) as in fineReach() of the page.
    rho = state["obscuration"] + (1.0 - state["obscuration"]) * np.arange(25)[:, None] / 24.0
    theta = math.tau * np.arange(48) / 48.0
    outward = (2.0 * state["defocus"] + 4.0 * state["spherical"] * rho * rho) * rho + 0.0 * theta
    around = np.zeros_like(outward)
    for name, (n, m) in DIRECTED.items():
        over, slope = np.zeros_like(rho), np.zeros_like(rho)  # the radial part over rho, and its derivative
        for power, factor in powers(n, m):
            over, slope = over + factor * rho ** (power - 1), slope + factor * power * rho ** (power - 1)
        turned = m * (theta - math.radians(state[f"{name}_angle"]))
        outward += state[name] * slope * np.cos(turned)
        around -= state[name] * over * m * np.sin(turned)
    v = 1.15 * math.tau * float(np.hypot(outward, around).max()) + 14.0
    reach = v * state["wavelength"] * 1e-3 * state["f_number"] / math.pi
    return float(2e-6 * 2.0 ** (math.ceil(2.0 * math.log2(reach)) / 2.0) / state["side"])
