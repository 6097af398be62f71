"""Files as microscopes and cameras write them, opened by libraries that extras install: ND2, CZI, LIF, bioio, raw."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from lommel.base import reading, validation
from lommel.base.arrays import Values
from lommel.base.optional import library
from lommel.io import photos
from lommel.recorded.headers import MODES, Metadata, length, number

MAX_CHANNELS = 4096
"""Largest number of channels of a file."""

_MAX_IMAGES = 2**24  # largest number of images of a file
_MISSING = "it is missing: the recording was stopped, or the file is cut off"
_SETTINGS = 2**20  # largest size of the description of a movie, bytes
_NIKON = {"laserScanConfocal": "confocal", "dsdConfocal": "spinning disc", "spinningDiskConfocal": "spinning disc"}
_NIKON |= {"sweptFieldConfocalSlit": "confocal", "multiphoton": "two-photon"}  # modality flags of ND2
_GREY_CZI = {"Gray8": np.uint8, "Gray16": np.uint16, "Gray32Float": np.float32}
# Packages by which bioio reads other formats, by suffix; those of Bio-Formats start Java.
_PLUGINS = {".dv": "bioio-dv", ".r3d": "bioio-dv", ".sldy": "bioio-sldy", ".vsi": "bioio-vsi", ".emd": "bioio-emd"}
_PLUGINS |= dict.fromkeys(
    (".ims", ".ipl", ".liff", ".mvd2", ".oib", ".oif", ".oir", ".sld", ".zvi"), "bioio-bioformats"
)
EXPORTED = {".sif": "SIF (Andor)", ".spe": "SPE (Princeton Instruments)", ".ser": "SER (planetary video)"}
"""Formats that no library here reads, by suffix: their programs export FITS or TIFF."""


class Opened(NamedTuple):
    """Images that a library reads on demand.

    Parameters
    ----------
    values : array_like
        Array of any package, (..., height, width).
    axes : str
        Letters of the axes before rows and columns: T, C, Z, or Q if unknown.
    metadata : dict
        As of :class:`~lommel.recorded.Frames`, with "format" and, as "notes", sentences.
    close : callable
    """

    values: Any
    axes: str
    metadata: Metadata
    close: Callable[[], object] = lambda: None


Opener = Callable[[Path, str | None], Opened]


@dataclass
class _Images:
    """Images of equal size, which a function reads by their indices."""

    shape: tuple[int, ...]
    dtype: np.dtype[Any]
    read: Callable[..., Values] = field(repr=False)

    def __getitem__(self, index: Any) -> Values:
        return self.read(*(() if index is ... else index))


def opener(path: Path, start: bytes) -> Opener | None:
    """Return the function that opens a file with these 16 first bytes; None for other formats."""
    for signature, open_file in _SIGNATURES.items():
        if re.match(signature, start, re.DOTALL):
            return open_file
    if photos.is_raw(path, start):
        return _raw
    if path.suffix.lower() in (".dax", ".raw") and path.with_suffix(_SIDECARS[path.suffix.lower()]).is_file():
        return _described
    return _bioio if path.suffix.lower() in _PLUGINS else None


def _nd2(path: Path, part: str | None) -> Opened:
    file = library("nd2", "reading ND2 files needs", "microscopes").ND2File(path)
    try:
        sizes = dict(file.sizes)
        if "S" in sizes:
            raise ValueError("it holds colours (RGB): save each channel in grey")
        loops = {letter: side for letter, side in sizes.items() if letter not in "CYX"}
        loop = {one.type: one.parameters for one in file.experiment}
        points = [str(point.name or "") for point in loop["XYPosLoop"].points] if "XYPosLoop" in loop else []
        sides = " x ".join(f"{side} {letter}" for letter, side in sizes.items() if letter != "P")
        names = [[name, str(k)] for k, name in enumerate((points + [""] * sizes.get("P", 1))[: sizes.get("P", 1)])]
        place = reading.only(range(len(names)), names, [sides] * len(names), part, path.name)
        letters = [letter for letter in loops if letter != "P"] + ["C"] * ("C" in sizes)
        metadata = _nd2_metadata(file.metadata.channels or [], sizes, loop.get("ZStackLoop"))

        def read(*index: int) -> Values:
            at = dict(zip(letters, index, strict=True)) | {"P": place}
            place_in_file = 0
            for letter, side in loops.items():
                place_in_file = place_in_file * side + at[letter]
            frame = np.asarray(file.read_frame(place_in_file))
            if not (frame.any() or _is_stored(frame)):
                raise ValueError(_MISSING)
            return np.array(frame[at["C"]] if "C" in at else frame)

        shape = tuple(sizes[letter] for letter in (*letters, "Y", "X"))
        return _opened(shape, file.dtype, read, letters, metadata, file.close)
    except BaseException:
        file.close()
        raise


def _is_stored(frame: Values) -> bool:
    """Return False for an array of zeros that the library made in place of a frame."""
    while isinstance(frame.base, np.ndarray):
        frame = frame.base
    return frame.base is not None


def _nd2_metadata(channels: Sequence[Any], sizes: dict[str, int], stack: Any) -> Metadata:
    """Return the metadata of ND2; lengths that the file marks as not calibrated are left out."""
    metadata: Metadata = {"format": "ND2"}
    if not channels:
        return metadata
    volume, lens = channels[0].volume, channels[0].microscope
    stated = zip(("pixel", "down", "step"), volume.axesCalibration, volume.axesCalibrated, strict=True)
    metadata |= {key: length(float(side), "µm") if is_known else None for key, side, is_known in stated}
    if "Z" not in sizes:
        metadata["step"] = None
    elif stack is not None:
        metadata["is_step_negative"] = stack.bottomToTop is False
    metadata["names"] = [one.channel.name for one in channels]
    for key, name in (("emission", "emissionLambdaNm"), ("excitation", "excitationLambdaNm")):
        metadata[key] = [length(getattr(one.channel, name), "nm") for one in channels]
    metadata["NA"] = number(lens.objectiveNumericalAperture)
    metadata["magnification"] = number(lens.objectiveMagnification)
    metadata["immersion"] = number(lens.immersionRefractiveIndex)
    if flag := next((flag for flag in lens.modalityFlags if flag in _NIKON), None):
        metadata["modality"] = _NIKON[flag], f"the modality {flag}"
    return metadata


def _czi(path: Path, part: str | None) -> Opened:
    file = library("pylibCZIrw.czi", "reading CZI files needs", "czi").CziReader(str(path))
    try:
        sides = {letter: end - first for letter, (first, end) in file.total_bounding_box_no_pyramid.items()}
        others = [f"{side} along {letter}" for letter, side in sides.items() if letter not in "TZCXY" and side > 1]
        if others:
            raise ValueError(f"it holds {', '.join(others)}, which cannot be read: process it and save the result")
        if (count := sides.get("C", 1)) > MAX_CHANNELS:
            raise ValueError(f"it has {count} channels; the limit is {MAX_CHANNELS}")
        kinds = set(file.pixel_types.values())
        if len(kinds) != 1 or not kinds <= _GREY_CZI.keys():
            raise ValueError(f"its channels are {', '.join(sorted(kinds))}: save channels in grey, of one type")
        rectangles = file.scenes_bounding_rectangle_no_pyramid or {None: file.total_bounding_rectangle_no_pyramid}
        size_texts = [f"{one.h} x {one.w}" for one in rectangles.values()]
        keys = list(rectangles)
        place = reading.only(range(len(keys)), [[str(k)] for k in range(len(keys))], size_texts, part, path.name)
        area, first = rectangles[keys[place]], {k: box[0] for k, box in file.total_bounding_box_no_pyramid.items()}
        letters = [letter for letter in "TCZ" if letter in sides]

        def read(*index: int) -> Values:
            plane = {letter: first[letter] + k for letter, k in zip(letters, index, strict=True)}
            parts = list[int]()

            def stop_at_first(k: int, _: object) -> bool:
                parts.append(k)
                return False

            at = {letter: k for letter, k in plane.items() if sides[letter] > 1} or None
            file.enumerate_subblocks_subset(stop_at_first, at, tuple(area), only_layer0=True)
            if not parts:  # the library would return zeros
                raise ValueError(_MISSING)
            return np.array(file.read(roi=tuple(area), plane=plane, scene=keys[place])[..., 0])

        shape = (*(sides[letter] for letter in letters), area.h, area.w)
        metadata = _czi_metadata(file.raw_metadata)
        return _opened(shape, np.dtype(_GREY_CZI[kinds.pop()]), read, letters, metadata, file.close)
    except BaseException:
        file.close()
        raise


def _czi_metadata(text: str) -> Metadata:
    root = reading.xml(text)
    information, metadata = "./Metadata/Information/", Metadata(format="CZI")
    sides = {item.get("Id"): item.findtext("Value") for item in root.findall("./Metadata/Scaling/Items/Distance")}
    metadata |= {key: length(sides.get(axis), "m") for key, axis in (("pixel", "X"), ("down", "Y"), ("step", "Z"))}
    channels = root.findall(f"{information}Image/Dimensions/Channels/Channel")
    metadata["names"] = [channel.get("Name") for channel in channels]
    for key, name in (("emission", "EmissionWavelength"), ("excitation", "ExcitationWavelength")):
        metadata[key] = [length(channel.findtext(name), "nm") for channel in channels]
    if modes := [mode for channel in channels if (mode := channel.findtext("AcquisitionMode")) in MODES]:
        metadata["modality"] = MODES[modes[0]], f"AcquisitionMode {modes[0]}"
    lenses = root.findall(f"{information}Instrument/Objectives/Objective")
    if (settings := root.find(f"{information}Image/ObjectiveSettings")) is not None:
        metadata["immersion"] = number(settings.findtext("RefractiveIndex"))
        used = settings.find("ObjectiveRef")
        lenses = [lens for lens in lenses if used is not None and lens.get("Id") == used.get("Id")] or lenses
    if len(lenses) == 1:
        metadata["NA"] = number(lenses[0].findtext("LensNA"))
        metadata["magnification"] = number(lenses[0].findtext("NominalMagnification"))
    return metadata


def _lif(path: Path, part: str | None) -> Opened:
    file = library("liffile", "reading LIF files needs", "microscopes").LifFile(path)
    try:
        images = list(file.images)
        names = [[str(image.name), str(image.path), str(k)] for k, image in enumerate(images)]
        size_texts = [" x ".join(f"{side} {letter}" for letter, side in image.sizes.items()) for image in images]
        image = reading.only(images, names, size_texts, part, path.name)
        dims = list(image.dims)
        if not {"X", "Y"} <= set(dims) or "S" in dims:
            raise ValueError(f"its axes are {''.join(dims)}: images of rows (Y) and columns (X) in grey are read")
        if image.nbytes > image.memory_block.size:
            raise ValueError(f"{image.nbytes} bytes of its images are more than the file holds")
        order = [k for k, dim in enumerate(dims) if dim not in "YX"] + [dims.index("Y"), dims.index("X")]
        values = image.asarray(out="memmap").transpose(order)
        steps = {dim: np.diff(axis) for dim, axis in image.coords.items() if len(axis) > 1}
        metadata: Metadata = {"format": "LIF", "is_step_negative": bool((steps.get("Z", np.ones(1)) < 0.0).any())}
        for key, dim in (("pixel", "X"), ("down", "Y"), ("step", "Z")):
            metadata[key] = length(float(np.mean(steps[dim])), "m") if dim in steps else None
        channels = image.xml_element.findall(".//ImageDescription/Channels/ChannelDescription")
        metadata["names"] = [channel.get("LUTName") for channel in channels]
        # A wavelength sweep counts as channels: of emission (small lambda) or of excitation (capital).
        letters = "".join(dims[k] for k in order[:-2])
        for dim, key in (("λ", "emission"), ("Λ", "excitation")):
            if dim in dims and "C" not in dims:
                waves = image.coords[dim].tolist()
                metadata |= {
                    key: [length(wave, "m") for wave in waves],
                    "names": [f"{1e9 * w:.4g} nm" for w in waves],
                }
                letters = letters.replace(dim, "C")
        lens = next((one for one in image.xml_element.iter() if one.get("NumericalAperture")), None)
        if lens is not None:
            stated = {"NA": "NumericalAperture", "magnification": "Magnification", "immersion": "RefractionIndex"}
            metadata |= {key: number(lens.get(name)) for key, name in stated.items()}
            if lens.get("PinholeAiry"):
                metadata["modality"] = "confocal", f"PinholeAiry {lens.get('PinholeAiry')}"
        return Opened(values, re.sub("[^TCZ]", "Q", letters), metadata, file.close)
    except BaseException:
        file.close()
        raise


def _bioio(path: Path, part: str | None) -> Opened:
    """Open a file of a format that a plugin of bioio reads; ImportError if it is not installed."""
    plugin = _PLUGINS[path.suffix.lower()]
    if not (find_spec("bioio") and find_spec(plugin.replace("-", "_"))):
        raise ImportError(f"reading {path.suffix} files needs two packages: pip install bioio {plugin}")
    bioio = library("bioio", f"reading {path.suffix} files needs", "")
    image = bioio.BioImage(path)
    scenes = [str(scene) for scene in image.scenes]
    names = [[name, str(k)] for k, name in enumerate(scenes)]
    place = reading.only(range(len(scenes)), names, [""] * len(scenes), part, path.name)
    image.set_scene(image.scenes[place])
    if "S" in image.dims.order:
        raise ValueError("it holds colours (RGB): save each channel in grey")
    sides = image.physical_pixel_sizes
    metadata: Metadata = {"format": plugin, "names": [str(name) for name in image.channel_names or ()]}
    for key, side in (("pixel", sides.X), ("down", sides.Y), ("step", sides.Z)):
        metadata[key] = length(None if side is None else float(side), "µm")
    metadata["notes"] = [f"Of the metadata, {plugin} returns voxels and names of channels alone."]
    return Opened(image.get_image_dask_data("TCZYX"), "TCZ", metadata)


def _raw(path: Path, part: str | None) -> Opened:
    """Open the pixels of one colour of a raw photograph, less their black level; the others are NaN."""
    data = reading.contents(path)
    with photos.open_raw(data) as file:
        if file.raw_type.name != "Flat" or file.raw_pattern is None:
            raise ValueError("it is no mosaic of colours: develop it, by lm.imaging.read_photo")
        mosaic, indices, colours = file.raw_image_visible, file.raw_colors_visible, file.color_desc.decode()
        names = list(dict.fromkeys(colours[: max(1, int(indices.max()) + 1)]))
        size = " x ".join(map(str, mosaic.shape))
        colour = reading.only(
            names, [[name, str(k)] for k, name in enumerate(names)], [size] * len(names), part, path.name
        )
        values = np.full(mosaic.shape, np.nan, np.float32)
        levels, whites = file.black_level_per_channel, file.camera_white_level_per_channel or [file.white_level] * 4
        used = [k for k, name in enumerate(colours) if name == colour]
        for k in used:
            values[indices == k] = mosaic[indices == k] - float(levels[k])
        black, white = int(levels[used[0]]), int(whites[used[0]]) or int(file.white_level)
    metadata: Metadata = {"format": "raw", "saturation": float(white - black), "levels": "raw"}
    tags = photos.raw_tags(data).get_ifd(photos.EXPOSURE_TAG)
    metadata |= photos.optics_of(photos.parsed(tags, None, values.shape))
    metadata["notes"] = [
        f"Pixels of the colour {colour} of the mosaic; others are NaN. The black level {black} was subtracted; the "
        f"white level is {white}."
    ]
    return Opened(values, "", metadata)


_SIDECARS = {".dax": ".inf", ".raw": ".yaml"}


def _described(path: Path, part: str | None) -> Opened:
    """Open a movie of localization microscopy that a text beside it describes: .dax and .inf, or .raw and .yaml."""
    beside = path.with_suffix(_SIDECARS[path.suffix.lower()])
    if part is not None:
        raise ValueError(f"it holds one movie: omit [{part}]")
    text = reading.decoded(reading.contents(beside, _SETTINGS))
    pairs = re.findall(r"^([^:=\n]+?)[ \t]*[:=][ \t]*(.*)$", text.partition("\n---")[0], re.MULTILINE)
    stated = {name.strip().lower(): value.strip() for name, value in reversed(pairs)}
    metadata: Metadata = {"format": beside.suffix, "notes": []}
    try:
        if beside.suffix == ".inf":
            width, height = map(int, stated["frame dimensions"].split(" x "))
            count, order = int(stated["number of frames"]), "<" if "little endian" in stated["data type"] else ">"
            if not stated["data type"].startswith("16 bit integers"):
                raise ValueError(f"its data type is {validation.shown(stated['data type'])}, not 16 bit integers")
            dtype = np.dtype(f"{order}u2")
            if (binning := stated.get("binning", "1 x 1")) != "1 x 1":
                metadata["notes"].append(f"The file states the binning {binning} of the detector, not used.")
        else:
            width, height, count = (int(stated[name]) for name in ("width", "height", "frames"))
            dtype = np.dtype(stated["data type"]).newbyteorder(stated.get("byte order", "<").strip("'\""))
            side = stated.get("pixelsize", stated.get("camera.pixelsize"))
            metadata |= {"pixel": length(side, "nm"), "down": length(side, "nm")}
    except KeyError as error:
        raise ValueError(f"{beside.name} does not state {error}") from None
    if min(width, height, count) < 1 or dtype.kind not in "iuf":
        raise ValueError(f"{beside.name} states {count} frames of {height} x {width} {dtype}")
    reading.pixels(width, height)
    size, needed = reading.size(path), count * height * width * dtype.itemsize
    if size != needed:
        raise ValueError(f"{beside.name} states {count} frames of {needed} bytes, the file has {size}")
    return Opened(np.memmap(path, dtype, "r", shape=(count, height, width)), "T", metadata)


def _opened(
    shape: tuple[int, ...],
    dtype: Any,
    read: Callable[..., Values],
    letters: Sequence[str],
    metadata: Metadata,
    close: Callable[[], object],
) -> Opened:
    """Return images that `read` returns by their indices; ValueError if they are too large or too many."""
    reading.pixels(shape[-1], shape[-2])
    if math.prod(shape[:-2]) > _MAX_IMAGES:
        raise ValueError(f"it states {math.prod(shape[:-2])} images; the limit is {_MAX_IMAGES}")
    axes = re.sub("[^TCZ]", "Q", "".join(letters))
    return Opened(_Images(shape, np.dtype(dtype), read), axes, metadata, close)


_SIGNATURES: dict[bytes, Opener] = {rb"\xda\xce\xbe\n": _nd2, b"ZISRAWFILE": _czi, rb"p\0{3}.{4}\*": _lif}
