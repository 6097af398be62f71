"""What images state of their camera and sampling, by headers, units and coordinates: used, told where it differs."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Json
from lommel.base.quantities import ANGLES, BARE, EVEN, LENGTHS, metres_of, spacings, stated_unit
from lommel.base.units import ARCSEC, format_length
from lommel.fit.findings import Finding, Severity, in_words
from lommel.io import fits_images
from lommel.io.zarr_folders import Missing, missing_chunks
from lommel.recorded.noise import Noise

# Names of FITS header cards in common use.
_GAIN, _READ, _SATURATION = ("EGAIN",), ("RDNOISE", "READNOIS", "RON"), ("SATURATE", "SATLEVEL")
_EM_GAIN = ("EMGAIN", "EMREALGN", "EMREALGAIN")
EXCESS = (
    2.0  # variance of an electron-multiplying register, divided by the variance of a Poisson variable of equal mean
)
_PIXELS = ("XPIXSZ", "PIXSIZE1", "PIXSIZE", "YPIXSZ")  # pitch of the pixels, micrometres, after binning
MODES = {"WideField": "widefield", "LaserScanningConfocalMicroscopy": "confocal", "SlitScanConfocal": "confocal"}
"""Kinds of microscopes by the AcquisitionMode of OME and CZI."""

MODES |= {"SpinningDiskConfocal": "spinning disc", "MultiPhotonMicroscopy": "two-photon", "SPIM": "light sheet"}
_ORDER = (
    "which was not applied: in the other order of rows, sine terms (m < 0: coma y, oblique astigmatism) change sign"
)
_MOSAIC = "a mosaic of colours, whose pixels are of several wavelengths: pass the pixels of one"
_COMBINED = ("NCOMBINE", "STACKCNT", "NSTACK")  # number of images of a mean or a sum
_IGNORED_CARDS = {
    "BAYERPAT": _MOSAIC,
    "COLORTYP": _MOSAIC,
    "PEDESTAL": "which counts only if the offset states it",
    "ROWORDER": _ORDER,
    "FLIPSTAT": _ORDER,
}
_BINNING = ("XBINNING", "YBINNING", "CCDSUM", "CCDXBIN", "CCDYBIN", "BINX", "BINY")
_SCALES = ("PIXSCALE", "SECPIX", "PIXSCAL1", "SECPIX1", "PIXELSCL", "SCALE")  # arcseconds per pixel
_RATIOS, _WAVES = ("FOCRATIO", "FRATIO"), ("WAVELEN", "WAVELNTH")
# Cards that commands compare with a lens, by the metadata that have them.
_COMPARED = {"sensor_pixel": _PIXELS, "scale": (*_SCALES, "WCS"), "plane_pixel": ("WCS",), "f_number": _RATIOS}
_COMPARED |= {"focal_length": ("FOCALLEN",), "aperture": ("APTDIA",), "wavelength": _WAVES}
_UNUSED_CARDS = (*_BINNING, "FILTER", *dict.fromkeys(sum(_COMPARED.values(), ())))
_GIVEN = "not used: pixel, focal length and wavelength are those given."
_COUNT = r"(?:adu|dn|counts?|cts?)\b"  # names of counts, also in units of gain and read noise
_COUNTS = re.compile(rf"(?:{_COUNT}|electrons?|e-?|photons?)s?(?:\W*pix(?:el)?)?", re.IGNORECASE)
_AMBIGUOUS_GAIN = "GAIN"  # card with electrons per count at observatories, but with a setting in amateur cameras


OPTICS = {"sensor_pixel": "pixels of {}", "plane_pixel": "pixels of {} in its coordinates", "f_number": "f/{}"}
OPTICS |= {"focal_length": "a focal length of {}", "aperture": "an aperture of {}", "scale": "{} arcsec per pixel"}
OPTICS |= {"wavelength": "a wavelength of {}", "focus": "a focus distance of {}", "zoom": "a digital zoom of {}"}
"""Metadata of the optics, in words: lengths in metres, the f-number, and radians per pixel on the sky."""


@dataclass(frozen=True)
class Unusable:
    """A metadata value that cannot be used, such as a length without unit.

    Parameters
    ----------
    words : str
        The words of the file.
    """

    words: str


Metadata = Json
"""Metadata of a file by name: numbers, :class:`Unusable`, or None."""


def length(value: str | float | None, unit: object, default: str = "") -> float | Unusable | None:
    """Return a length in metres, Unusable with the words of the file, or None if the file states none."""
    if value is None or value == "":
        return None
    unit_name = str(unit or default).strip()
    text = f"{value:.4g}" if isinstance(value, float) else str(value)
    words = validation.brief(f"{text} {unit_name}".strip(), 60)
    try:
        size = abs(float(value))
    except (TypeError, ValueError):
        return Unusable(words)
    if size == 1.0 and unit_name in ("", "pixel", "pixels"):  # written by programs for an unknown scale
        return None
    try:
        scale = metres_of(unit_name)
    except KeyError:
        scale = 0.0
    if not unit_name:
        words += " without a unit"
    return size * scale if scale and math.isfinite(size) and size > 0.0 else Unusable(words)


def number(value: str | float | None, *, least: float = 0.0) -> float | Unusable | None:
    """Return a number above `least`, Unusable with the words of the file, or None if the file states none."""
    if value is None or value == "":
        return None
    try:
        parsed = float(value)
    except (TypeError, ValueError):
        parsed = math.nan
    return parsed if math.isfinite(parsed) and parsed > least else Unusable(validation.brief(str(value), 60))


def fits_metadata(header: fits_images.Cards, comments: Mapping[str, str] = {}) -> Metadata:
    """Return the metadata of the camera in a FITS header: electrons per count, read noise, saturation, lengths.

    The comments of cards state units: of read noise, saturation, pixels, focal length, and gains, so that a `GAIN` in
    electrons per count is known as such.
    """
    said = {name: text.lower() for name, text in comments.items()}

    def first(names: Sequence[str], least: float = 0.0) -> float | Unusable | None:
        return next((number(header[name], least=least) for name in names if name in header), None)

    # A read noise of 0 is a valid value, unlike a gain of 0.
    direct, inverse = rf"\be(?:lectrons?)?-?\s*(?:/|per)\s*{_COUNT}", rf"{_COUNT}\s*(?:/|per)\s*e"
    units = direct if "EGAIN" in header else f"{direct}|{inverse}"
    is_gain = re.search(units, said.get(_AMBIGUOUS_GAIN, ""))
    gains = [name for name in _GAIN + (_AMBIGUOUS_GAIN,) * bool(is_gain) if name in header]
    metadata: Metadata = {"gain": first(gains), "read": first(_READ, -1e-300), "saturation": first(_SATURATION)}
    if gains and isinstance(metadata["gain"], float) and re.search(inverse, said.get(gains[0], "")):
        metadata["gain"] = 1.0 / metadata["gain"]  # counts per electron
    if len({header[name] for name in gains}) > 1:
        metadata["gain"] = Unusable(" and ".join(f"{header[name]} by {name}" for name in gains))
    if order := header.get("ROWORDER"):
        metadata["rows"] = order
    if isinstance(wave := first(_WAVES), float):
        # Without the unit of WAVEUNIT or of the comment: metres, as of POPPY, or nm.
        stated_unit = re.match(r"\[([a-zµ]+)", next(said.get(name, "") for name in _WAVES if name in header))
        wave_unit = stated_unit[1] if stated_unit else header.get("WAVEUNIT") or ("m" if wave < 1e-4 else "nm")
        if isinstance(size := length(wave, wave_unit), float) and 1e-7 < size < 1e-4:
            metadata["wavelength"] = size
    if header.get("CUNIT3") in LENGTHS and "WAV" not in str(header.get("CTYPE3", "")):
        stated_step = header.get("CDELT3", header.get("CD3_3"))
        metadata |= {"step": length(stated_step, header["CUNIT3"]), "is_step_negative": str(stated_step)[:1] == "-"}
    gain = metadata["gain"]
    lengths = ("sensor_pixel", _PIXELS, 1e-6), ("focal_length", ("FOCALLEN",), 1e-3), ("aperture", ("APTDIA",), 1e-3)
    for key, names, scale in (*lengths, ("scale", _SCALES, ARCSEC), ("f_number", _RATIOS, 1.0)):
        if isinstance(size := first(names), float):
            stated_unit = re.match(r"\[([a-zµ]+)", next(said.get(name, "") for name in names if name in header))
            with suppress(KeyError):  # of a unit that is none of length
                unit_of = ANGLES.__getitem__ if key == "scale" else metres_of
                metadata[key] = size * (unit_of(stated_unit[1]) if stated_unit else scale)
    step, step_unit = _coordinate_step(header)
    if step_unit in LENGTHS:
        metadata["plane_pixel"] = step * LENGTHS[step_unit]
    elif step_unit:
        metadata.setdefault("scale", step * ANGLES[step_unit])
    if isinstance(times := first(_EM_GAIN), float) and times > 1.0:
        metadata |= {"excess": EXCESS, "em_gain": times}
    unit = str(header.get("BUNIT", "")).strip()
    if _are_electrons(header):
        metadata |= {"gain": 1.0, "electrons": unit}
    elif unit and not _COUNTS.fullmatch(unit):
        metadata["gain"] = Unusable(f"values in {validation.brief(unit, 60)}, neither counts nor electrons")
    elif metadata["gain"] is None and unit.lower() in ("adu", "dn"):  # units "ct" are also those of single photons
        metadata["levels"] = unit
    if metadata["gain"] is None and header.get(_AMBIGUOUS_GAIN) not in (None, ""):
        metadata["unsure"] = f"{_AMBIGUOUS_GAIN} = {validation.brief(str(header[_AMBIGUOUS_GAIN]), 60)}"
    full = next((said.get(name, "") for name in _SATURATION if name in header), "")
    in_counts = not unit or re.match(_COUNT, unit.lower())
    if in_counts and isinstance(limit := metadata["saturation"], float) and re.match(r"\[e(?:-|lec)", full):
        words = f"{limit:g} electrons, without a gain"
        metadata["saturation"] = limit / gain if isinstance(gain, float) else Unusable(words)
    comment = next((said.get(name, "") for name in _READ if name in header), "")
    if (
        isinstance(read := metadata["read"], float)
        and re.search(rf"\b{_COUNT}", comment)
        and not re.search(r"\be(-|lec)", comment)
    ):
        metadata["read"] = read * gain if isinstance(gain, float) else Unusable(f"{read:g} counts, without a gain")
    return metadata


def _coordinate_step(header: Mapping[str, object]) -> tuple[float, str]:
    """Return a pixel's width in the world coordinates of a FITS header, and its unit of length or angle or ""."""

    def card(name: str, default: float = 0.0) -> float:
        return value if isinstance(value := number(str(header.get(name, "")), least=-math.inf), float) else default

    kind = str(header.get("CTYPE1", ""))
    unit = str(header.get("CUNIT1") or ("deg" if re.match(r"(RA|DEC|.LON|.LAT)-", kind) else "")).strip()
    step = math.hypot(card("CDELT1") * card("PC1_1", 1.0), card("CDELT2") * card("PC2_1"))
    step = math.hypot(card("CD1_1"), card("CD2_1")) or step
    return step, unit if step and unit in LENGTHS | ANGLES and "WAV" not in kind else ""


def _are_electrons(header: Mapping[str, object]) -> bool:
    return str(header.get("BUNIT", "")).strip().lower().rstrip("s") in ("electron", "e", "e-")


def fits_notes(header: Mapping[str, object], metadata: Metadata) -> list[str]:
    """Return a sentence on each card of a FITS header that matters but is not applied."""
    stated = {
        name: f"{name} = {validation.brief(str(header[name]), 60)}"
        for name in (*_IGNORED_CARDS, *_UNUSED_CARDS, "BUNIT")
        if header.get(name) not in (None, "", 0)
        and (name not in _BINNING or str(header[name]).strip() not in ("1", "1.0", "1 1"))
    }
    step, step_unit = _coordinate_step(header)
    if step_unit:
        stated["WCS"] = f"pixels of {step:.3g} {step_unit} by its world coordinates"
    if _are_electrons(header):
        stated |= {name: f"{name} = {header[name]}" for name in _GAIN if header.get(name) not in (None, "", 1, 1.0)}
    for name, usual in (("ROWORDER", "TOP-DOWN"), ("COLORTYP", "RGB|L|GR[AE]Y|MONO.*")):  # of images here
        if re.fullmatch(usual, str(header.get(name, "")).strip(), re.IGNORECASE):
            stated.pop(name, None)
    endings = [(stated[name], ending) for name, ending in _IGNORED_CARDS.items() if name in stated]
    for across, down in (("XPIXSZ", "YPIXSZ"), ("PIXSIZE1", "PIXSIZE2"), ("XBINNING", "YBINNING")):
        if down in header and header.get(across, header[down]) != header[down]:
            words = f"{across} = {header[across]} and {down} = {header[down]}"
            endings.append((words, "pixels that are not square: pixel= must state their height and width"))
            break
    count = next((number(str(header[name])) for name in _COMBINED if name in header), None)
    if isinstance(count, float) and count > 1.0:
        advice = f"for their mean state {count:g} times the gain of one, for their sum that gain"
        read = f"and for both {math.sqrt(count):.3g} times the read noise"
        endings.append((f"that {count:g} images were combined", f"which was not applied: {advice}, {read}"))
    compared = dict.fromkeys(name for key, names in _COMPARED.items() if key in metadata for name in names)
    others = [text for name, text in stated.items() if name in _UNUSED_CARDS and name not in compared]
    endings += [(", ".join(others), "not used")] * bool(others)
    if unused := [stated[name] for name in compared if name in stated]:
        endings.append((", ".join(unused), _GIVEN.removesuffix(".")))
    endings += [(stated[name], "not used: the values are electrons by BUNIT") for name in _GAIN if name in stated]
    if "BUNIT" in stated and not _COUNTS.fullmatch(str(header["BUNIT"]).strip()):
        endings.append(
            (stated["BUNIT"], "not counts: photon noise is right only if the gain is in electrons per unit")
        )
    return [f"The header of the images states {words}, {ending}." for words, ending in endings]


def is_first_row_on_top(metadata: Metadata) -> bool:
    """Return whether programs show the first row of these images at the top: not in FITS, unless ROWORDER says so."""
    return metadata.get("format") != "FITS" or str(metadata.get("rows", "")).strip().upper() == "TOP-DOWN"


def without_compared(notes: Sequence[str]) -> list[str]:
    """Return the notes of images without those on cards that a command compares with its lens."""
    return [note for note in notes if not note.endswith(_GIVEN)]


def metadata_of(name: str, images: Any) -> Metadata:
    """Return what images state of their recording: frames, headers and units of astropy, coordinates of xarray.

    Chunks that an array of Zarr lacks are told; ValueError if it lacks all.
    """
    if type(images).__module__.partition(".")[0] == "lommel":
        return dict(getattr(images, "metadata", {}))
    if isinstance(images, list | tuple):
        each = [metadata_of(f"{name}[{k}]", image) for k, image in enumerate(images) if type(image) not in BARE]
        return combined_metadata(each) if each else {}
    if type(images) in BARE:
        return {}
    try:
        missing = missing_chunks(images)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    for chunks in missing:
        validation.tell(f"{name}: {chunks.text}.")
    header = getattr(images, "header", getattr(images, "meta", None))
    cards = {str(key).upper(): value for key, value in header.items()} if isinstance(header, Mapping) else {}
    if (unit := stated_unit(images)) is not None:
        cards["BUNIT"] = str(unit)
    comments = {card.keyword: card.comment for card in getattr(header, "cards", ())}
    metadata = fits_metadata(cards, comments) if cards else {}
    sides = spacings(name, images) if isinstance(getattr(images, "dims", None), tuple) else {}
    for letter, key in (("X", "pixel"), ("Y", "down"), ("Z", "step")):
        if letter in sides:
            size, unit = sides[letter]
            metadata |= {key: length(size, unit or ""), "format": "xarray"}
            metadata["is_step_negative"] = key == "step" and isinstance(size, float) and size < 0.0
    for wave in ("emission", "wavelength"):
        if wave in getattr(images, "coords", ()):
            axis = images.coords[wave]
            metadata["emission"] = [length(value, stated_unit(axis) or "") for value in np.ravel(axis).tolist()]
    return metadata | ({"missing": missing} if missing else {})


_HEADER_VALUES = {
    "white": ("gain", "a gain of {:g} electrons per count"),
    "read": ("read", "a read noise of {:g} electrons"),
    "saturation": ("saturation", "saturation at {:g}"),
    "excess": ("excess", "an electron-multiplying camera, excess noise {:g}"),
}
_EXCESS_NOTE = "; gain and read noise must refer to electrons before multiplication, divided by the EM gain"


def take_header(options: Metadata, header: Metadata, camera: Mapping[str, Any] = {}) -> list[str]:
    """Complete gain, read noise, saturation and excess in `options` by the header of images; return notes.

    Options have priority over the values of the camera, and these over the header. Notes state header values that
    differ.
    """
    notes = []
    for name, (key, phrase) in _HEADER_VALUES.items():
        value = header.get(key)
        if isinstance(value, Unusable):
            words = value.words if value.words.startswith("values in ") else f"{key} {value.words}"
            if key != "saturation" and options.get(name) is None and camera.get(name) is None:
                raise ValueError(f"the header of the images states {words}: state {name}=")
            notes.append(f"The header of the images states {words}, which cannot be used.")
        if not isinstance(value, float):
            continue
        used_value = camera.get(name) if options.get(name) is None else options[name]
        if used_value is None:
            options[name] = value
            addition = _EXCESS_NOTE if name == "excess" else ""
            words = "values in electrons" if name == "white" and "electrons" in header else phrase.format(value)
            notes.append(f"Taken from the header of the images: {words}{addition}.")
        elif isinstance(used_value, float | int) and abs(used_value - value) > EVEN * abs(value):
            notes.append(f"The header of the images states {phrase.format(value)}; {used_value:g} was used.")
    return notes


def assumed_gain(header: Metadata, argument: str) -> str:
    """Return the note of a gain that neither `argument`, a camera nor the header of images states."""
    setting = f" The header states {header['unsure']}, not used: it may be a setting." if "unsure" in header else ""
    return f"No gain is known: 1 electron per count was assumed; {argument} states it.{setting}"


def with_header(
    noise: Noise | None, saturation: float | None, header: Metadata, read: float | None = None
) -> tuple[Noise, float | None]:
    """Return noise and saturation completed by the header of images, and by `read`; differences are told."""
    options: Json = {"saturation": saturation, "white": None, "read": None, "excess": None}
    if noise is not None:
        options |= vars(noise) | {"excess": noise.excess if noise.excess > 1.0 else None}
    for note in take_header(options, header):
        if not note.startswith("Taken") or _EXCESS_NOTE in note:
            validation.tell(note)
    if {"levels", "unsure"} & header.keys() and options["white"] is None:
        validation.tell(assumed_gain(header, "white="))
    limit = options.pop("saturation")
    stated = {name: value for name, value in options.items() if value is not None}
    return Noise(**{"read": read} | stated), limit


SIZES = {"pixel": "pixels of {} in the sample", "down": "pixels {} high", "sensor_pixel": "pixels of {}"}
SIZES |= {"emission": "an emission of {}", "step": "planes {} apart", "NA": "an NA of {}", "modality": "{}"}
SIZES |= {"magnification": "a magnification of {}", "immersion": "an immersion of the index {}"}
"""Metadata of the sampling and the microscope, in words."""

NEGATIVE_STEP = "a negative plane spacing, of which the magnitude was used: its sign does not set the direction of z."


def size_notes(header: Metadata, **used: float | str | None) -> dict[str, str]:
    """Return a note on each value that images state, and that differs from the one in use (metres, None: none).

    "modality" is the kind of microscope. Where a `step` is above 0, a negative one that images state is noted.
    """
    notes = dict[str, str]()
    for key, size in used.items():
        stated = header.get(key)
        if key == "modality" and stated is not None and stated[0] != size:
            notes[key] = f"The images state {stated[1]}, but a {size} microscope was used."
        stated = _first(stated)
        if not isinstance(size, float | int) or not isinstance(stated, float | Unusable):
            continue
        unit = (lambda value: f"{value:.4g}") if key in ("NA", "magnification", "immersion") else format_length
        text, used_text = stated.words if isinstance(stated, Unusable) else unit(stated), unit(abs(size))
        if isinstance(stated, Unusable):
            lacking = "is no length in a known unit" if unit is format_length else "cannot be used"
            notes[key] = f"The images state {SIZES[key].format(text)}, which {lacking}: {used_text} was used."
        elif abs(stated - abs(size)) > EVEN * abs(size):
            notes[key] = f"The images state {SIZES[key].format(text)}, but {used_text} was used."
        elif key == "step" and size > 0.0 and header.get("is_step_negative"):
            notes["direction"] = f"The images state {NEGATIVE_STEP}"
    if notes.keys() & {"pixel", "sensor_pixel"}:
        notes.pop("down", None)
    return notes


def _first(stated: Any) -> Any:
    """Return a value that images state, or the first of several."""
    return next(iter(stated), None) if isinstance(stated, list | tuple) else stated


_ACROSS = "lengths{} across are {:.3g} times as long"
_SCALED = {"pixel": _ACROSS, "down": _ACROSS, "sensor_pixel": _ACROSS, "step": _ACROSS.replace("across", "along z")}
_SCALED |= {"emission": "the PSF{} is {:.3g} times as wide"}


def size_findings(header: Metadata, of: str = "", *, most: float = EVEN, **used: float | None) -> list[Finding]:
    """Return a finding on each length that images state and that differs from the one in use: see `size_notes`.

    It is a doubt if they differ by more than `most`, and has the ratio of lengths in the result, or `of` something.
    """
    findings = list[Finding]()
    for key, note in size_notes(header, **used).items():
        stated, size = _first(header.get(key)), used.get(key)
        text, code = f"{note[0].lower()}{note[1:-1]}", "pixel_pitch" if "pixels" in note else "contradiction"
        if size is None:  # the direction of z
            findings.append(Finding("stated", "note", text))
        elif isinstance(stated, float):
            text += f", and {_SCALED[key].format(of, abs(size) / stated)}: correct the one that is wrong"
            is_far = abs(stated - abs(size)) > most * abs(size)
            numbers = {"used": abs(size), "stated": stated}
            findings.append(Finding(code, "doubt" if is_far else "note", text, numbers))
        else:
            findings.append(Finding(code, "note", f"{text}; state it in the images"))
    return findings


def told_early(findings: Sequence[Finding]) -> list[Finding]:
    """Tell the doubts among findings, before a computation that takes long, and return all of them."""
    for sentence in in_words(findings):
        validation.tell(sentence, validation.Early)
    return list(findings)


def missing_findings(metadata: Metadata, noise: Noise | None, effect: str) -> list[Finding]:
    """Return the finding on missing chunks: a doubt, unless the values that they count as may have been recorded."""
    severity: Severity = "note" if noise is not None and np.all(np.asarray(noise.offset) == 0.0) else "doubt"
    missing: Sequence[Missing] = metadata.get("missing", [])
    return [
        Finding("missing_chunks", severity, f"{text}: {effect}", {"missing": number, "chunks": total})
        for text, number, total in missing
    ]


def without_missing(notes: Sequence[str], metadata: Metadata) -> list[str]:
    """Return the notes on recorded images other than those on missing chunks, of which there is a finding."""
    return [note for note in notes if note not in [f"{chunks.text}." for chunks in metadata.get("missing", [])]]


def microscope_facts(objective: Any, wavelength: float | None, modality: str = "widefield") -> dict[str, Any]:
    """Return what :func:`size_notes` compares of a microscope besides its pixel and step."""
    facts = {key: getattr(objective, key) for key in ("NA", "magnification", "immersion")}
    return facts | {"emission": wavelength, "modality": modality}


_MOST_DIFFERENT = 0.05  # relative difference of pixels and steps that fits allow for, or that lens files have


def tell_sizes(header: Metadata, pixel: float | tuple[float, float]) -> None:
    """Tell pixels that images state, and that differ from the `pixel` (height, width) on the camera."""
    height, width = pixel if isinstance(pixel, tuple) else (pixel, pixel)
    header = {"sensor_pixel": header.get("pixel", header.get("sensor_pixel")), "down": header.get("down")}
    if notes := size_notes(header, sensor_pixel=width, down=height):
        validation.tell(" ".join(notes.values()))


def microscope_findings(
    header: Metadata, pixel: float, step: float | None = None, **microscope: Any
) -> tuple[list[Finding], list[str]]:
    """Return (1) findings on pixel and step and (2) notes on other values that images state, and that differ.

    `pixel` is the pitch on the camera; `microscope` is that of :func:`microscope_facts`. Pixels that images state are
    those in the sample.
    """
    side = pixel / microscope["magnification"]
    findings = size_findings(header, most=_MOST_DIFFERENT, sensor_pixel=pixel, pixel=side, down=side, step=step)
    return findings, list(size_notes(header, **microscope).values())


def combined_metadata(files: Sequence[Metadata]) -> Metadata:
    """Return the camera metadata of several files; values that differ between files are :class:`Unusable`.

    Numbers of the optics are tuples of those of all files.
    """
    combined = dict(files[0])
    for key in OPTICS:
        combined[key] = tuple(metadata[key] for metadata in files if key in metadata)
    for key in ("gain", "read", "saturation", "excess"):
        values = [metadata.get(key) for metadata in files]
        if any(value != values[0] for value in values):
            words = [
                value.words if isinstance(value, Unusable) else "none" if value is None else f"{value:g}"
                for value in values
            ]
            combined[key] = Unusable(f"of {', '.join(dict.fromkeys(words))} in different files")
    return combined
