"""Images of files and arrays, read on demand, also by several threads at the same time, with their metadata.

Files are TIFF (plain, ImageJ, OME-TIFF, also of several files), folders of OME-Zarr, FITS, NPY, PNG, and those of
:mod:`lommel.recorded.instrument_files`.

Metadata describe the recording: voxel sizes, channels, objective, camera. Each entry is absent (None), a value, or
:class:`Unusable`.
"""

from __future__ import annotations

import math
import mmap
import re
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from functools import lru_cache, partial
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, Self, SupportsIndex, cast

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from lommel.base import executors, optional, reading, validation
from lommel.base.arrays import Index, Values
from lommel.base.encoding import named
from lommel.base.quantities import EVEN, LETTERS, in_order, in_unit
from lommel.base.units import format_length
from lommel.base.validation import line, shown
from lommel.io import fits_images, icc, photos, registry, zarr_folders
from lommel.io.registry import Format
from lommel.recorded import instrument_files
from lommel.recorded.counts import Counts, OnDemand
from lommel.recorded.headers import (
    EXCESS,
    MODES,
    NEGATIVE_STEP,
    Metadata,
    Unusable,
    combined_metadata,
    fits_metadata,
    fits_notes,
    length,
    metadata_of,
    number,
)
from lommel.recorded.instrument_files import MAX_CHANNELS
from lommel.recorded.noise import Noise

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from tifffile import TiffFile, TiffPageSeries

_RESOLUTION_UNITS = {2: 25.4e-3, 3: 1e-2}  # metres of values of the tag ResolutionUnit of TIFF: inch, centimetre
_FINEST_PRINT = 1e-5  # metres: pixels of prints are larger (2540 per inch)
_IRREGULAR = 0.1  # deviation of steps between planes, relative to their mean, above which they are not regular


def ome_metadata(file: TiffFile, place: int) -> Metadata:
    """Return the metadata of an image in the OME-XML of a TIFF file."""
    try:
        root = reading.xml(file.ome_metadata or "")
    except ValueError:
        return {}
    images = [(node, pixels) for node in root.findall("{*}Image") if (pixels := node.find("{*}Pixels")) is not None]
    if len(images) != len(file.series):  # tifffile leaves out images without pixels: find the image by its name
        images = [entry for entry in images if entry[0].get("Name") == file.series[place].name][:1] * (place + 1)
    if not images:
        return {}
    image, pixels = images[place]

    def side(letter: str) -> float | Unusable | None:
        name = f"PhysicalSize{letter}"
        return length(pixels.get(name), pixels.get(f"{name}Unit"), "µm")

    metadata: Metadata = {"pixel": side("X"), "down": side("Y"), "step": side("Z"), "notes": []}
    metadata["is_step_negative"] = pixels.get("PhysicalSizeZ", "").startswith("-")
    with suppress(ValueError):  # positions that are no numbers
        _read_positions(pixels, metadata)
    channels = pixels.findall("{*}Channel")
    metadata["names"] = [channel.get("Name") for channel in channels]
    for key, name in (("emission", "EmissionWavelength"), ("excitation", "ExcitationWavelength")):
        metadata[key] = [length(channel.get(name), channel.get(f"{name}Unit"), "nm") for channel in channels]
    for channel in channels[::-1]:  # the first one counts
        if pinhole := channel.get("PinholeSize"):
            metadata["modality"] = "confocal", f"PinholeSize {pinhole}"
        if (mode := channel.get("AcquisitionMode")) in MODES:
            metadata["modality"] = MODES[mode], f"AcquisitionMode {mode}"
    items = [*image.findall(".//{*}DetectorSettings"), *root.findall(".//{*}Instrument/{*}Detector")]
    unused = [f"{key} {item.get(key)}" for item in items for key in ("Binning", "Gain", "Offset") if item.get(key)]
    if (bits := pixels.get("SignificantBits")) not in (None, re.sub("[a-z]*", "", pixels.get("Type", ""))):
        unused.append(f"SignificantBits {bits}")
    if unused := [text for text in dict.fromkeys(unused) if text not in ("Binning 1x1", "Gain 0", "Offset 0")]:
        metadata["notes"].append(f"The OME metadata state {', '.join(unused)} of the detector, not used.")
    detectors = {item.get("ID"): item.get("Type") for item in root.findall(".//{*}Instrument/{*}Detector")}
    detector_ids = [settings.get("ID") for settings in image.findall(".//{*}DetectorSettings")]
    if any(
        detectors.get(name) == "EMCCD" for name in detector_ids or (list(detectors) if len(detectors) == 1 else [])
    ):
        metadata["excess"] = EXCESS
    lenses = root.findall(".//{*}Instrument/{*}Objective")
    if (objective := image.find("{*}ObjectiveSettings")) is not None:
        metadata["immersion"] = number(objective.get("RefractiveIndex"))
        lenses = [lens for lens in lenses if lens.get("ID") == objective.get("ID")]
    if len(lenses) == 1:
        metadata["NA"] = number(lenses[0].get("LensNA"))
        metadata["magnification"] = number(
            lenses[0].get("CalibratedMagnification") or lenses[0].get("NominalMagnification")
        )
    return metadata


def _read_positions(pixels: Element, metadata: Metadata) -> None:
    """Replace the step of an OME image by that of the positions of its planes; note a contradiction."""
    planes = [plane for plane in pixels.findall("{*}Plane") if plane.get("PositionZ")]
    # The planes of one channel and time point.
    planes = [p for p in planes if all(p.get(f"The{axis}") == planes[0].get(f"The{axis}") for axis in "CT")]
    positions = {int(plane.get("TheZ", "0")): float(plane.get("PositionZ", "")) for plane in planes}
    steps = np.diff([positions[k] for k in sorted(positions)])
    if len(positions) < 2 or len(positions) != int(pixels.get("SizeZ", "1")) or not np.isfinite(steps).all():
        return
    mean, unit = float(steps.mean()), planes[0].get("PositionZUnit", "reference frame")
    size, stated = length(mean, unit), metadata["step"]
    least, most = np.abs(steps).min(), np.abs(steps).max()
    if not steps.any():  # one position for all planes, such as that of the other stage
        return
    metadata["is_step_negative"] |= mean < 0.0
    if np.abs(steps - mean).max() > _IRREGULAR * abs(mean):
        metadata["notes"].append(
            f"The positions of the planes (PositionZ) are not regular, {least:g} to {most:g} {unit} apart."
        )
    elif not isinstance(size, float):
        if abs(float(pixels.get("PhysicalSizeZ", "0")) - abs(mean)) > EVEN * abs(mean):
            metadata["notes"].append(
                f"The planes are {abs(mean):g} {unit} apart by their positions (PositionZ), which cannot be used."
            )
    elif not isinstance(stated, float) or abs(stated - size) > EVEN * size:
        metadata["step"] = size
        if stated is not None:
            words = stated.words if isinstance(stated, Unusable) else format_length(stated)
            metadata["notes"].append(
                f"The planes are {format_length(size)} apart by their positions (PositionZ), which was used; "
                f"PhysicalSizeZ is {words}."
            )


def described_metadata(entries: Mapping[str, Any], page: Any) -> Metadata:
    """Return the metadata in the description of a TIFF file by ImageJ, or by tifffile with the same words."""
    unit = entries.get("unit")  # unit of x, and of y and z unless these have their own
    spacing, step_unit = entries.get("spacing"), entries.get("zunit", unit)
    if spacing is None:
        spacing, step_unit = entries.get("PhysicalSizeZ"), entries.get("PhysicalSizeZUnit")
    metadata: Metadata = {"step": length(spacing, step_unit)}
    metadata["is_step_negative"] = str(entries.get("spacing", "")).startswith("-")
    for key, tag, axis_unit in (("pixel", "XResolution", unit), ("down", "YResolution", entries.get("yunit", unit))):
        name = f"PhysicalSize{tag[0]}"  # as of OME, in other files
        if name in entries:
            metadata[key] = length(entries[name], entries.get(f"{name}Unit"))
        elif axis_unit and (side := _side_of(page, tag)) is not None and (side != 1.0 or "ImageJ" in entries):
            # Others than ImageJ write 1 for an unknown scale.
            metadata[key] = length(side, axis_unit)
    return metadata


def _side_of(page: Any, tag: str) -> float | None:
    """Return the side of a pixel that a resolution states, in its unit, 0 if it is 0; None without the tag."""
    if (value := page.tags.get(tag)) is None:
        return None
    pixels, units = value.value  # pixels per unit of length as a fraction
    return float(units / pixels) if pixels else 0.0


def _with_resolution(metadata: Metadata, page: Any) -> None:
    """Add the pixel of the tags XResolution and ResolutionUnit to metadata without a pixel; note a contradiction."""
    unit = page.tags.get("ResolutionUnit")
    metres, form = _RESOLUTION_UNITS.get(0 if unit is None else int(unit.value), 0.0), metadata.get("format", "TIFF")
    for key, tag in (("pixel", "XResolution"), ("down", "YResolution")):
        side, stated = metres * (_side_of(page, tag) or 0.0), metadata.get(key)
        # Coarse ones are those of a print, but the numbers of ImageJ have the unit of its description.
        is_print = side >= _FINEST_PRINT
        if not side or (is_print and (stated is None or form == "OME")):
            continue
        if isinstance(stated, float) and abs(stated - side) <= EVEN * side:
            continue
        # ImageJ converts centimetres to the unit of its description.
        if stated is None or (form != "OME" and isinstance(stated, float) and not is_print):
            metadata |= {key: side, "format": form}
        if stated is not None and key == "pixel":
            words = stated.words if isinstance(stated, Unusable) else format_length(stated)
            used = " and were used" * (metadata[key] == side)
            metadata.setdefault("notes", []).append(
                f"XResolution and ResolutionUnit state pixels of {format_length(side)}{used}; the {form} metadata "
                f"state {words}."
            )


def zarr_metadata(attributes: Mapping[str, Any], sides: Metadata) -> Metadata:
    """Return the metadata of an OME-Zarr from its `attributes`, and the lengths of a voxel by axis letter."""
    metadata: Metadata = {"pixel": sides.get("X"), "down": sides.get("Y"), "step": sides.get("Z")}
    listed = attributes.get("omero") or {}
    channels = listed.get("channels", []) if isinstance(listed, dict) else []
    channels = [channel for channel in channels if isinstance(channel, dict)]
    metadata["names"] = [channel.get("label") for channel in channels]
    metadata["emission"] = [length(channel.get("emission_wavelength"), "nm") for channel in channels]
    return metadata


__all__ = ["Counts", "Frames", "RecordingError", "Unusable", "open_frames"]

_NUMPY = b"\x93NUMPY"
_MAX_BLOCK = 2**28  # largest block of images of an OME-Zarr that are read together, bytes
_TOLERANCE = 1e-4  # relative difference up to which lengths count as equal
# Lengths in files, in the words of messages; "down" is the height of a pixel.
_LENGTHS = {"pixel": "a pixel size of", "down": "a pixel height of", "step": "a plane spacing of"}
_CAMERA = "gain", "read", "saturation", "excess", "unsure", "levels"
_SIDES = 1e-12, 1e-4  # metres, range of voxel sides in the sample
_WAVES = 1e-7, 1e-4  # metres, range of wavelengths: 0.52 nm is a wavelength in micrometres with a wrong unit
BLOCK = 2**22
"""Default number of pixels of a block of frames: 32 MB in float64."""
UNKNOWN = "Q"
"""Letter of an axis whose meaning the file does not state."""


class RecordingError(ValueError):
    """Error for a file that cannot be read as images; the message names the file."""


class Planes:
    """Images of equal size, read one by one."""

    sides: tuple[int, int]
    dtype: np.dtype[np.generic]
    chunk_sizes: tuple[tuple[int, ...], ...] = ()  # along each axis of the array; () without chunks
    path: Path | None = None
    names: tuple[str, ...] = ()  # of each image, if they are of several files
    source: Source | None = None  # file from which another process can read the images
    together: int = 1  # number of images that are read together
    is_copy: bool = False  # made by copying or pickling: nobody else closes its file

    def __reduce_ex__(self, protocol: SupportsIndex) -> Any:
        """Return the images of a file as its name, for a copy, pickle or another process that opens it again."""
        return super().__reduce_ex__(protocol) if self.source is None else (_planes_of, (self.source,))

    def plane(self, number: int) -> Values:
        """Return one image, of type `dtype` and shape `sides`."""
        raise NotImplementedError

    def block(self, part: tuple[slice, ...]) -> Values:
        """Return a part of the array, by a slice along each of its axes."""
        raise NotImplementedError

    def release(self) -> None:
        """Let the system drop the pages of a mapped file from the memory of this process."""

    def close(self) -> None:
        """Close the file."""

    def __del__(self) -> None:
        if self.is_copy:
            self.close()


@dataclass(frozen=True, eq=False, repr=False)
class Frames(OnDemand):
    """Images along named axes, read on demand by indices and slices along all axes, or by NumPy and dask.

    :func:`open_frames` returns them; ``with`` or `close` closes their file.

    Attributes
    ----------
    axes : str
        A letter for each axis: T, C, Z, or Q if unknown, and YX at the end.
    shape : tuple of int
    dtype : dtype
        Type of the stored values, in the byte order of this machine.
    metadata : dict
        Metadata by name: "pixel", "step", "emission", "gain" and others, in metres and electrons; "format" is their
        source: "OME", "ImageJ", "OME-Zarr", "FITS", "ND2" and others.
    notes : tuple of str
        Sentences on the image that was chosen and on data that were left out.
    path : Path or None
        File of the images; None for an array, or for several files.
    names : tuple of str
        Name of each image: its file, and its number in a stack.
    planes : Planes
        Reader of single images.
    numbers : ndarray of int
        Numbers of the images in `planes`, along the axes before YX.
    """

    planes: Planes
    numbers: NDArray[np.intp]
    axes: str
    metadata: Metadata = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:  # noqa: D102
        return self.numbers.shape + self.planes.sides

    @property
    def dtype(self) -> np.dtype[np.generic]:  # noqa: D102
        return self.planes.dtype

    @property
    def ndim(self) -> int:
        """Number of axes."""
        return self.numbers.ndim + 2

    @property
    def path(self) -> Path | None:  # noqa: D102
        return self.planes.path

    @property
    def names(self) -> tuple[str, ...]:  # noqa: D102
        if self.planes.names:
            return tuple(self.planes.names[number] for number in self.numbers.ravel())
        file_name = "array" if self.path is None else self.path.name
        return names_of(file_name, self.numbers.size)

    def __repr__(self) -> str:
        name = "array" if self.path is None else self.path.name
        texts = [f"{' x '.join(map(str, self.shape))} along {self.axes}", str(self.dtype)]
        for key, text in (("pixel", "pixels of {}"), ("step", "planes {} apart")):
            if isinstance(side := self.metadata.get(key), float):
                texts.append(text.format(format_length(side)))
        return f"<Frames {name!r}: {', '.join(texts)}>"

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, key: Index) -> Values:
        index = key if isinstance(key, tuple) else (key,)
        if any(entry is Ellipsis for entry in index):
            k = next(k for k, entry in enumerate(index) if entry is Ellipsis)
            index = index[:k] + (slice(None),) * (self.ndim - len(index) + 1) + index[k + 1 :]
        stack_ndim = self.numbers.ndim
        numbers, part = self.numbers[index[:stack_ndim]], index[stack_ndim:]
        if not all(isinstance(entry, slice | int | np.integer) for entry in part):
            raise TypeError(f"rows and columns must be integers or slices, got {shown(part)}")
        if np.ndim(numbers) == 0:
            plane = self.planes.plane(int(numbers))
            return plane[part] if part else plane
        sides = np.broadcast_to(np.int8(0), self.planes.sides)[part].shape
        values = np.empty((*numbers.shape, *sides), self.dtype)
        for position, place in np.ndenumerate(numbers):
            values[position] = self.planes.plane(int(place))[part]
        return values

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Values:
        values = self[...]
        return values if dtype is None else values.astype(dtype)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the file."""
        self.planes.close()

    def counts(self, *, noise: Noise, mask: ArrayLike | None = None, saturation: float | None = None) -> Counts:
        """Return the images, read on demand, with the noise of their camera.

        Parameters
        ----------
        noise, mask, saturation
            See :meth:`~lommel.Counts.of`.

        Returns
        -------
        Counts

        Raises
        ------
        TypeError, ValueError
            See :meth:`~lommel.Counts.of`.

        Examples
        --------
        A camera with a column that does not work, which saturates below the largest value of its 12 bits:

        >>> import lommel as lm
        >>> frames, dead = open_frames(np.full((3, 4, 5), 200, np.uint16)), np.zeros((4, 5), bool)
        >>> dead[:, 2] = True
        >>> counts = frames.counts(noise=lm.Noise(white=0.46, read=1.6, offset=100), mask=dead, saturation=4000)
        >>> counts[0].marked()[0].tolist()
        [200.0, 200.0, nan, 200.0, 200.0]
        """
        return Counts.of(self, noise=noise, mask=mask, saturation=saturation)

    def blocks(self, size: int | None = None) -> Iterator[Values]:
        """Yield all images in blocks of consecutive ones along the first axis.

        Parameters
        ----------
        size : int, optional
            Number of images per block; the last block may have fewer. By default 4194304 pixels per block.

        Yields
        ------
        ndarray

        Raises
        ------
        TypeError, ValueError
            If `size` is out of range; RecordingError if an image is damaged or missing.

        Examples
        --------
        >>> frames = open_frames(np.zeros((250, 64, 64), np.uint16))
        >>> [len(block) for block in frames.blocks(100)]
        [100, 100, 50]
        """
        length = block_size(self.shape, size)
        return (self[first : first + length] for first in range(0, len(self), length))

    def one_of(self, letter: str, place: int) -> Frames:
        """Return the images at one index of an axis.

        Parameters
        ----------
        letter : str
            Letter of the axis.
        place : int
            Index along the axis.

        Returns
        -------
        Frames
        """
        axis = self.axes.index(letter)
        number = validation.integer(letter, place, least=0, most=self.shape[axis] - 1)
        return replace(self, numbers=np.take(self.numbers, number, axis=axis), axes=self.axes.replace(letter, ""))

    def as_stack(self) -> Frames:
        """Return the images as a stack along one axis.

        Returns
        -------
        Frames

        Raises
        ------
        RecordingError
            If several axes before YX are longer than 1, or the file has more pages than its description counts.
        """
        if uncounted := self.metadata.get("left_out"):
            raise RecordingError(f"{self.name}: it holds {uncounted}; save it again")
        if sum(side > 1 for side in self.numbers.shape) > 1:
            sizes = " x ".join(map(str, self.shape))
            raise RecordingError(
                f"{self.name}: it holds {sizes} values along {self.axes}: save one stack of images, of one channel "
                "and time point"
            )
        long_axes = [letter for letter, side in zip(self.axes, self.numbers.shape, strict=False) if side > 1]
        return replace(self, numbers=self.numbers.reshape(-1), axes=f"{long_axes[0] if long_axes else UNKNOWN}YX")

    def as_channels(self, *, time: int | None = None, axes: str | None = None, series: bool = False) -> Frames:
        """Return the images of a microscope along C, Z, Y and X, with metadata that can be used.

        Parameters
        ----------
        time : int, optional
            Number of the time point, from 0; required if the file holds several time points, unless `series`.
        axes : str, optional
            Letters of the axes, such as "ZYX" or "CZYX", if the file does not state them or states wrong letters.
        series : bool, default False
            Keep the axis T of several time points, before C, where `time` is not given.

        Returns
        -------
        Frames
            The metadata have "pixel" and "step", metres in the sample, "NA", "magnification" and "immersion" (None
            where the file states none), and for each channel "names", "emission" and "excitation". Values that cannot
            be used, such as 0, are in "unusable", in the words of the file, by these names, for a channel "emission
            0". Notes state what was taken from the file.

        Raises
        ------
        RecordingError
            If there are several time points without `time`, axes that are unknown, or pixels that are not square.
        TypeError, ValueError
            If an argument is out of range.

        Examples
        --------
        An array does not state its axes; of an embryo, the last of six time points is restored:

        >>> frames = open_frames(np.zeros((6, 2, 9, 8, 8), np.uint16))
        >>> frames.as_channels(time=5, axes="TCZYX")
        <Frames 'array': 2 x 9 x 8 x 8 along CZYX, uint16>
        """
        if "unusable" in self.metadata:
            return self
        return _with_used_metadata(_along_channels(self, time, axes, series))

    def only_channel(self, name: str) -> Frames:
        """Return the only channel as a stack; ValueError about the argument `name` if there are several."""
        frames = self.as_channels()
        if frames.shape[0] > 1:
            raise ValueError(
                f"{name} must be one channel, got {frames.shape[0]}: {', '.join(frames.metadata['names'])}; "
                'use frames.one_of("C", 0) for the first'
            )
        return frames.one_of("C", 0)

    @property
    def files(self) -> set[str]:
        """Paths of the files of a multi-file OME-TIFF; empty otherwise."""
        return self.planes.files if isinstance(self.planes, _TiffPlanes) else set()

    @property
    def name(self) -> str:
        """Name of the images in messages."""
        return "the array" if self.path is None else line(self.path)


def block_size(shape: tuple[int, ...], size: int | None) -> int:
    """Return the number of images of a block, `size` or by default that of 4194304 pixels."""
    length = max(1, BLOCK // math.prod(shape[1:])) if size is None else size
    return validation.integer("size", length, least=1, most=validation.MAX_VALUES)


def names_of(file: str, count: int) -> tuple[str, ...]:
    """Return a name for each image of a file."""
    return (file,) if count == 1 else tuple(f"{file} [{k}]" for k in range(count))


class Source(NamedTuple):
    """Path of an image file with its size and time of change, None for a folder."""

    path: Path
    state: tuple[int, int] | None

    @classmethod
    def of(cls, path: Path) -> Self:
        """Return the source of a path, with the name of an image after it."""
        file, _ = reading.part_of(path)
        status = file.stat()
        return cls(path.absolute(), None if file.is_dir() else (status.st_size, status.st_mtime_ns))

    def opened(self, *, anew: bool = False) -> Frames:
        """Return the images, of a file that a process keeps open unless `anew`.

        RecordingError if this process does not see the file, or sees another one.
        """
        try:
            if Source.of(self.path) == self:
                return _opened.__wrapped__(self) if anew else _opened(self)
        except FileNotFoundError:
            raise RecordingError(executors.unseen(self.path)) from None
        raise RecordingError(
            f"{line(self.path)} has changed since it was opened, or a worker sees another file there: repeat the call"
        )


def _planes_of(source: Source) -> Planes:
    planes = source.opened(anew=True).planes
    planes.is_copy = True
    return planes


@lru_cache(maxsize=2)
def _opened(source: Source) -> Frames:
    frames = _file_frames(source.path)
    frames.planes.source = source
    return frames


class ArrayLikeImages(Protocol):
    """Array of any package from which NumPy can read parts."""

    @property
    def shape(self) -> tuple[int, ...]:
        """Lengths of the axes."""

    @property
    def dtype(self) -> DTypeLike:
        """Type of the values."""

    def __getitem__(self, index: Any, /) -> ArrayLike:
        """Return a part."""


class _ArrayPlanes(Planes):
    """Images in an array of any package from which NumPy can read parts."""

    def __init__(
        self, values: ArrayLikeImages, name: str, path: Path | None = None, names: tuple[str, ...] = ()
    ) -> None:
        self._values, self._name, self.path, self.names = values, name, path, names
        self._stack_shape = tuple(values.shape[:-2])
        self.sides: tuple[int, int] = (int(values.shape[-2]), int(values.shape[-1]))
        self.dtype = np.dtype(values.dtype).newbyteorder("=")
        chunks = None if isinstance(values, np.ndarray) else getattr(values, "chunks", None)
        self.chunk_sizes = sizes_of_chunks(values.shape, chunks) if isinstance(chunks, tuple) else ()

    def plane(self, number: int) -> Values:
        """Return one image."""
        index = tuple(int(k) for k in np.unravel_index(number, self._stack_shape)) if self._stack_shape else ...
        return self.block(index).astype(self.dtype, copy=not isinstance(self._values, np.ndarray))

    def block(self, part: Any) -> Values:
        """Return a part of the array."""
        try:
            # Refuses masks, which dask shows only here.
            return validation.array(self._name, zarr_folders.values_of(self._values, part), "counts").astype(
                self.dtype, copy=False
            )
        except RuntimeError as error:  # of damaged chunks, which codecs do not name
            ranges = (f"{k.start}:{k.stop}" if isinstance(k, slice) else str(k) for k in np.atleast_1d(part))
            message = f"[{', '.join(ranges)}] of {validation.line(self._values)}: {error}"
            raise RecordingError(message) from None

    def release(self) -> None:
        """Let the system drop the pages of a mapped file, which otherwise count as memory of a worker."""
        mapping = getattr(self._values, "_mmap", None)
        if mapping is not None and hasattr(mmap, "MADV_DONTNEED"):
            mapping.madvise(mmap.MADV_DONTNEED)


class _LibraryPlanes(_ArrayPlanes):
    """Images that the library of a format reads, one at a time."""

    path: Path

    def __init__(self, opened: instrument_files.Opened, path: Path) -> None:
        super().__init__(opened.values, "it", path)
        self._close, self._lock, self.chunk_sizes = opened.close, threading.Lock(), ()

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._close()

    def plane(self, number: int) -> Values:
        """Return one image."""
        with errors_of(self.path, f"image {number}: "), self._lock:
            values = super().plane(number)
            if values.shape != self.sides:
                raise ValueError(f"it has the shape {values.shape}, not {self.sides}: it is damaged")
            return values


def sizes_of_chunks(shape: tuple[int, ...], chunks: tuple[int | tuple[int, ...], ...]) -> tuple[tuple[int, ...], ...]:
    """Return the sizes of chunks along each axis, from these sizes (dask) or from the size of all chunks (Zarr)."""
    return tuple(
        size if isinstance(size, tuple) else (size,) * (side // size) + ((side % size,) if side % size else ())
        for side, size in zip(shape, chunks, strict=True)
    )


class _TiffPlanes(Planes):
    """Images in the pages of a TIFF file."""

    path: Path

    def __init__(self, path: Path, file: TiffFile, series: TiffPageSeries) -> None:
        self.path, self._file, self._pages, self._is_multifile = path, file, series.pages, series.is_multifile
        self.sides: tuple[int, int] = (series.shape[-2], series.shape[-1])
        is_compressed = series.keyframe.compression != 1
        self.chunk_sizes = ((1,) * len(series.pages), *((side,) for side in self.sides)) if is_compressed else ()
        self.dtype = np.dtype(series.dtype).newbyteorder("=")
        self._lock = threading.Lock()  # pages share one file handle

    @property
    def files(self) -> set[str]:
        """Paths of the files if there are several, else empty."""
        pages = self._pages if self._is_multifile else ()
        paths = {str(page.parent.filehandle.path) for page in pages if page is not None}
        return paths if len(paths) > 1 else set()

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def block(self, part: tuple[slice, ...]) -> Values:
        """Return some pages, or a part of their rows and columns."""
        images, rows, columns = part
        return np.stack([self.plane(number)[rows, columns] for number in range(images.start, images.stop)])

    def plane(self, number: int) -> Values:
        """Return one image."""
        with errors_of(self.path, f"page {number}: "), self._lock:
            page = self._pages[number]
            if page is None:
                raise ValueError(
                    "it is missing: the file is cut off, or other files of its OME-TIFF are not beside it"
                )
            return reading.tiff_values(page, self.sides, self.dtype)


class _ZarrPlanes(Planes):
    """Images in a Zarr array; a chunk of several images is read once and kept for the following images."""

    path: Path

    def __init__(self, path: Path, array: Any, order: tuple[int, ...]) -> None:
        """Store an array whose axes are read in another `order`, rows and columns at the end."""
        self.path, self._array, self._order = path, array, order
        *stack_shape, height, width = (int(array.shape[axis]) for axis in order)
        self._stack_shape, self.sides = tuple(stack_shape), (height, width)
        self.dtype = np.dtype(array.dtype).newbyteorder("=")
        reading.pixels(*self.sides[::-1])
        self.chunks = zarr_folders.Chunks(path, array)
        sizes = sizes_of_chunks(array.shape, array.chunks)
        self.chunk_sizes = tuple(sizes[axis] for axis in order)
        # Number of images that are read together: those of a chunk, or one, and its chunks again for each, if they
        # would take too much memory.
        images = array.chunks[order[-3]] if self._stack_shape else 1
        is_small = images * math.prod(self.sides) * self.dtype.itemsize <= _MAX_BLOCK
        self.together = images if is_small else 1
        self._block: tuple[int, Values] | None = None
        self._lock = threading.Lock()

    def plane(self, number: int) -> Values:
        """Return one image."""
        with errors_of(self.path, f"plane {number}: "), self._lock:  # each chunk is read once
            return self._read(number)

    def block(self, part: tuple[slice, ...]) -> Values:
        """Return a part of the array."""
        with errors_of(self.path), self._lock:
            return self._part(part)

    def _part(self, part: tuple[slice, ...]) -> Values:
        """Return a part of the array; the caller holds the lock."""
        stored = tuple(part[self._order.index(axis)] for axis in range(len(part)))
        self.chunks.check([range(one.start, one.stop) for one in stored])
        return np.asarray(zarr_folders.values_of(self._array, stored), self.dtype).transpose(self._order)

    def _read(self, number: int) -> Values:
        *leading_indices, last_index = np.unravel_index(number, self._stack_shape) if self._stack_shape else (0,)
        first = int(last_index) - int(last_index) % self.together
        key = number - int(last_index) + first
        block = self._block
        if block is None or block[0] != key:
            self._block = None
            slices = [slice(int(k), int(k) + 1) for k in leading_indices]
            if self._stack_shape:
                slices.append(slice(first, min(first + self.together, self._stack_shape[-1])))
            part = self._part((*slices, *(slice(0, side) for side in self.sides)))
            self._block = block = key, part.reshape(-1, *self.sides)
        return np.array(block[1][number - key])


def open_frames(*paths: str | PathLike[str] | ArrayLike) -> Frames:
    """Open the images of files, or of an array.

    Parameters
    ----------
    *paths : path, array_like or Frames
        A TIFF, FITS, NPY or PNG file or a folder of OME-Zarr (0.4 or 0.5), recognized by its content; with the
        libraries of the extras "microscopes", "czi" and "raw" an ND2, LIF or CZI file or a raw photograph, with bioio
        what its plugins read; a .dax with its .inf, or a .raw with its .yaml. ``file.fits[SCI]``, ``file.tif[1]``,
        ``file.lif[bead]`` or ``photo.nef[G]`` selects one of several images; by default, in OME-TIFF, the one of
        which the others are at most half as large. Or an array of NumPy, dask, Zarr or xarray,
        whose coordinates z, y and x, with units, state step and pixel, and "emission" the wavelength. Several files,
        of images of one size and type, are one stack, and are read at once.

    Returns
    -------
    Frames

    Raises
    ------
    RecordingError
        If a file is damaged, too large when decompressed, holds colours (RGB), or holds several images and none is
        selected.
    TypeError, ValueError
        If an argument is out of range.
    OSError, ImportError
        If a file cannot be read, or a library for it is not installed.

    Examples
    --------
    >>> with open_frames("movie.tif") as movie:  # doctest: +SKIP
    ...     print(movie.axes, movie.shape, movie.metadata)
    ...     first = movie[:100]
    """
    return frames_of("images", paths[0]) if len(paths) == 1 else read_images([*paths])  # type: ignore[list-item]


def frames_of(name: str, images: str | PathLike[str] | ArrayLike) -> Frames:
    """Return the images of a file or of an array, the argument `name` in messages."""
    if isinstance(images, Frames):
        return images
    if not isinstance(images, str | PathLike):
        letters, described = _letters_of(name, images), metadata_of(name, images)
        given = in_unit(name, images, "counts")
        is_array = hasattr(given, "shape") and hasattr(given, "dtype")
        values = cast(ArrayLikeImages, given) if is_array else validation.array(name, given, "counts")
        validation.refuse_masked(name, values)
        frames = _array_frames(values, name, metadata=described)
        return replace(frames, axes=f"{letters}YX") if len(letters) == frames.numbers.ndim else frames
    place = validation.path("path", images)
    frames = _file_frames(place)
    frames.planes.source = Source.of(place)
    return frames


def _file_frames(path: Path) -> Frames:
    source, part = reading.part_of(path)
    if source.is_dir():
        with errors_of(source):
            return _zarr_frames(source, part)
    start = reading.start(source, 16)
    if open_file := instrument_files.opener(source, start):
        with errors_of(source):
            return _library_frames(source, open_file(source, part))
    if part is not None and start.startswith((_NUMPY, *photos.PNG)):
        raise RecordingError(f"{line(source)} holds one image: omit [{part}]")
    if start.startswith(_NUMPY):
        with errors_of(source):
            return _array_frames(_grey(_npy(source)), "it", source)
    if start.startswith(photos.TIFF):
        return _open_tiff(source, part)
    with errors_of(source):
        return _fits_or_png_frames(source, part)


def _npy(path: Path) -> Values:
    try:
        values: Values = np.load(path, mmap_mode="r", allow_pickle=False)
    except ValueError as error:
        if "mmap length" not in str(error):
            raise
        raise ValueError(f"its header states more than its {reading.size(path)} bytes: it is cut off") from None
    return values


def _letters_of(name: str, images: object) -> str:
    """Return the letters of the axes before rows and columns by the names of an array's dimensions (xarray, Zarr)."""
    stated = getattr(images, "dims", None) or getattr(getattr(images, "metadata", None), "dimension_names", None)
    if type(images).__module__.startswith("h5py"):
        stated = [dim.label for dim in stated or ()]
    dims = [str(dim).lower() for dim in stated] if isinstance(stated, tuple | list) else []
    if not any(LETTERS.get(dim, "") in ("Y", "X") for dim in dims):
        return ""
    if hasattr(images, "transpose"):  # those of xarray are put in order
        dims = in_order(dims)
    letters = "".join(LETTERS.get(dim, UNKNOWN) for dim in dims)
    if not letters.endswith("YX"):
        raise ValueError(f"{name} must have rows and columns as its last axes, got the axes {', '.join(dims)}")
    return "".join(letter for letter in letters[:-2] if letter not in "YX")


@contextmanager
def errors_of(path: Path, part: str = "") -> Iterator[None]:
    """Convert errors of libraries, of any type, to a RecordingError that names the file and the part."""
    try:
        with reading.quietly():
            yield
    except (RecordingError, ImportError):
        raise
    except Exception as error:
        if isinstance(error, OSError) and error.filename is not None:
            raise
        raise RecordingError(f"{line(path)}: {part}{reading.reason(error)}") from None


def _array_frames(values: ArrayLikeImages, name: str, path: Path | None = None, **described: Any) -> Frames:
    """Return the images of an array, whose axes are unknown."""
    sides = tuple(int(side) for side in values.shape)
    require_numbers(name, values.dtype)
    if len(sides) < 2 or 0 in sides:
        raise ValueError(f"{name} must have images of one pixel or more, (..., height, width), got the shape {sides}")
    stack_shape = sides[:-2]
    numbers = np.arange(math.prod(stack_shape)).reshape(stack_shape)
    return Frames(_ArrayPlanes(values, name, path), numbers, f"{UNKNOWN * len(stack_shape)}YX", **described)


def require_numbers(name: str, dtype: DTypeLike) -> None:
    """Raise TypeError if `dtype` is not one of real numbers."""
    if np.dtype(dtype).kind not in "iufb":
        raise TypeError(f"{name} must hold real numbers, got {np.dtype(dtype)}")


def _library_frames(path: Path, opened: instrument_files.Opened) -> Frames:
    """Return the images that a library reads, without axes of one image."""
    shape = opened.values.shape[:-2]
    kept = tuple(side for side in shape if side != 1)
    letters = "".join(letter for letter, side in zip(opened.axes, shape, strict=True) if side != 1)
    metadata = dict(opened.metadata)
    notes = tuple(metadata.pop("notes", ()))
    frames = replace(_array_frames(opened.values, "it", path), axes=f"{letters}YX", metadata=metadata, notes=notes)
    numbers = frames.numbers.reshape(kept)
    return replace(frames, planes=_LibraryPlanes(opened, path), numbers=numbers)


def _fits_or_png_frames(path: Path, part: str | None) -> Frames:
    """Return the images of a FITS or PNG file, which is read as a whole."""
    data = reading.contents(path)
    try:
        file_format = registry.identify("images", data)
    except ValueError:
        if data and (name := instrument_files.EXPORTED.get(path.suffix.lower())):
            raise RecordingError(f"{line(path)}: {name} is not read; export FITS or TIFF of 16 bits") from None
        problem = (
            "is not a TIFF, FITS, NPY, PNG, ND2, CZI or LIF file, nor a folder of OME-Zarr; save it as one of these"
            if data
            else "is empty"
        )
        raise RecordingError(f"{line(path)} {problem}") from None
    values, metadata, notes = file_format.read(data, part)
    return _array_frames(_grey(values), "it", path, metadata=metadata, notes=tuple(notes))


def _open_tiff(path: Path, part: str | None) -> Frames:
    optional.require("tifffile", "reading TIFF files needs", "images")
    with errors_of(path):
        file, errors = reading.tiff_on_disk(path)
        try:
            if errors:
                raise ValueError(f"it is cut off or damaged: {validation.brief(re.sub('^<.*?> ', '', errors[0]))}")
            return _tiff_frames(path, file, part)
        except BaseException:
            file.close()
            raise


def _tiff_frames(path: Path, file: TiffFile, part: str | None) -> Frames:
    notes: list[str] = []
    series, place = _series_of(path, file, part, notes)
    letters: str = series.axes
    page = series.keyframe
    if "S" in letters and letters != "SYX":  # SYX: some programs write three grey images as the colours of one
        raise ValueError(
            f"it holds colours (RGB), {' x '.join(map(str, series.shape))} along {letters}; save each channel in grey"
        )
    sizes = [
        (letter if letter in "TCZ" else UNKNOWN, side)
        for letter, side in zip(letters[:-2], series.shape[:-2], strict=True)
        if side != 1
    ]
    require_numbers("it", series.dtype)
    stack_shape = tuple(side for _, side in sizes)
    count = math.prod(stack_shape)
    mapped = (
        reading.tiff_values(page, tuple(series.shape), np.dtype(series.dtype))
        if "S" in letters
        else reading.tiff_mapped(file, series, path, count)
    )
    metadata: Metadata = {}
    if file.is_ome:
        metadata = ome_metadata(file, place) | {"format": "OME"}
    elif file.is_imagej:
        metadata = described_metadata(file.imagej_metadata or {}, page) | {"format": "ImageJ"}
    elif described := (file.shaped_metadata or ())[place : place + 1]:
        metadata = described_metadata(described[0], page) | {"format": "TIFF"}
    elif series.kind not in ("generic", "uniform", "shaped"):  # LSM, STK and others, as tifffile names them
        notes.append(f"The metadata of the format {series.kind} are not read: state pixel and step.")
    _with_resolution(metadata, page)
    if (exposure := page.tags.get(photos.EXPOSURE_TAG)) is not None and isinstance(exposure.value, dict):
        metadata |= photos.optics_of(photos.parsed(exposure.value, None, series.shape[-2:]))
    notes += metadata.pop("notes", [])
    planes = _TiffPlanes(path, file, series) if mapped is None else _ArrayPlanes(mapped, "it", path)
    notes += _encoding_notes(page.iccprofile)
    orientation = page.tags.get("Orientation")
    if orientation is not None and orientation.value != 1:
        notes.append(f"The file states the orientation {orientation.value}, which was not applied.")
    uncounted = reading.tiff_left_out(file)
    values = file.imagej_metadata or {} if file.is_imagej else {}
    slope, constant = values.get("c1", 1.0), values.get("c0", 0.0)
    if values.get("cf") == 0 and (slope, constant) == (1.0, -32768.0) and planes.dtype == np.uint16:
        stored = series.asarray() if mapped is None else mapped  # signed integers, by their order
        planes = _ArrayPlanes((stored.astype(np.uint16) ^ np.uint16(32768)).view(np.int16), "it", path)
    elif "cf" in values and (values["cf"], slope, constant) != (0, 1.0, 0.0):
        words = f"{constant:g} + {slope:g} * value" if values["cf"] == 0 else f"function {values['cf']}"
        notes.append(f"The file states the calibration {words} ({values.get('vunit')}), which was not applied.")
    if uncounted:
        notes.append(f"The file holds {uncounted}; the others were left out.")
        metadata["left_out"] = uncounted
    axes = "".join(letter for letter, _ in sizes) + "YX"
    numbers = np.arange(count).reshape(stack_shape)
    if mapped is not None:  # the mapping remains valid after the file is closed
        file.close()
    return Frames(planes, numbers, axes, metadata, tuple(notes))


def _series_of(path: Path, file: TiffFile, part: str | None, notes: list[str]) -> tuple[Any, int]:
    """Return the series of a file to read, and its number.

    In OME-TIFF this is by default the full-size image, if labels and thumbnails are at most half as large.
    """
    # A smaller image is the level of a pyramid only where it is marked as one.
    every = [
        level
        for series in file.series
        for level in series.levels
        if level is series or not (series.kind == "ome" or level.keyframe.is_reduced or level.keyframe.is_subifd)
    ]
    names = [[str(item.name), str(k)] if file.is_ome else [str(k)] for k, item in enumerate(every)]
    sizes = [" x ".join(map(str, item.shape)) for item in every]
    *others, full = sorted((item.shape for item in every), key=math.prod)
    smaller = (2 * math.prod(other[k:]) <= math.prod(full[k:]) for other in others for k in (0, -2))
    if len(every) > 1 and part is None and file.is_ome and all(smaller):
        place = max(range(len(every)), key=lambda k: math.prod(every[k].shape))
        notes.append(
            f"The file holds {len(every)} images, {reading.listing(names, sizes)[0]}; image {place}, counted from 0, "
            f"was used; {path.name}[{0 if place else 1}] selects another."
        )
    else:
        place = reading.only(range(len(every)), names, sizes, part, path.name)
    return every[place], place


def _zarr_frames(path: Path, part: str | None) -> Frames:
    zarr = optional.library("zarr", "reading OME-Zarr needs", "zarr")
    try:
        files = zarr_folders.files_of(path)
        group = zarr.open(str(path), mode="r")
    except Exception as error:  # zarr raises many types
        raise ValueError(f"no OME-Zarr: {reading.reason(error)}") from None
    if not hasattr(group, "attrs") or hasattr(group, "dtype"):
        raise ValueError("it is an array without OME metadata; pass zarr.open(...) and pixel=")
    try:
        image = zarr_folders.ome_image(path, group, part)
    except ValueError:
        raise
    except Exception as error:  # malformed metadata raise many types
        raise ValueError(f"its multiscales metadata are invalid ({reading.reason(error)})") from None
    array, letters, notes = image.array, image.axes, image.notes
    order = "".join(letter for letter in letters if letter not in "YX") + "YX"
    require_numbers("it", array.dtype)
    if "C" in order and (count := array.shape[letters.index("C")]) > MAX_CHANNELS:
        raise ValueError(f"it has {count} channels; the limit is {MAX_CHANNELS}")
    sides: Metadata = {}
    if isinstance(image.scale, str):
        sides = dict.fromkeys(letters, Unusable(image.scale))
    elif image.scale is not None:
        stated = zip(letters, image.scale.tolist(), image.units, strict=True)
        sides = {letter: length(size, unit) for letter, size, unit in stated}
    metadata = zarr_metadata(image.attributes, sides)
    planes = _ZarrPlanes(path, array, tuple(letters.index(letter) for letter in order))
    if missing := planes.chunks.missing(files):
        metadata["missing"] = missing
        notes += [f"{chunks.text}." for chunks in missing]
    stack_shape = tuple(array.shape[letters.index(letter)] for letter in order[:-2])
    numbers = np.arange(math.prod(stack_shape)).reshape(stack_shape)
    return Frames(planes, numbers, order, metadata | {"format": "OME-Zarr"}, tuple(notes))


def _grey(values: Values) -> Values:
    """Return the values of a file; ValueError unless they are a grey image or a stack of them."""
    if values.ndim > 3:
        values = values.reshape([side for side in values.shape[:-2] if side != 1] + list(values.shape[-2:]))
    if values.ndim > 3 or values.dtype.kind not in "iufb":
        raise ValueError(f"it holds {values.dtype} of the shape {values.shape}; save one stack of grey images")
    return values


def _png(data: bytes, _part: str | None) -> tuple[Values, Metadata, list[str]]:
    values, tags, profile, _ = photos.read_png(data)
    if values.ndim != 2:
        raise ValueError(f"it has {values.shape[2]} channels: save the counts of the sensor in grey, of 16 bits")
    stated = photos.optics_of(photos.parsed(tags.get_ifd(photos.EXPOSURE_TAG), None, values.shape))
    return values, stated, _encoding_notes(profile, is_srgb=photos.COLOUR_SPACE_TAG in tags)


def _encoding_notes(profile: bytes | None, *, is_srgb: bool = False) -> list[str]:
    """Return a sentence on the encoding that a file states, unless it is linear, as a list."""
    try:
        encoding = named(icc.encoding_of(profile, grey=True) if profile else "srgb" if is_srgb else "linear")
    except ValueError as error:
        encoding = f"of an ICC profile that {error}"
    return [] if encoding == "linear" else [f"The file states values {encoding}; they were taken as linear counts."]


def _fits(data: bytes, part: str | None) -> tuple[Values, Metadata, list[str]]:
    image = fits_images.only(fits_images.read(data, reading.MAX_PIXELS), part)
    header = {**image.primary, **image.header}
    colours = [name for name in ("CTYPE3", "COLORTYP") if str(header.get(name, "")).strip().upper() == "RGB"]
    if colours and image.values.ndim > 2:
        raise ValueError(f"it holds colours ({colours[0]} = RGB), not planes: save each channel in grey")
    # An extension inherits the cards of the primary header.
    metadata = fits_metadata(header, image.comments) | {"format": "FITS"}
    return image.values, metadata, fits_notes(header, metadata)


_images = partial(Format, "images")
registry.register(
    _images((".png",), read=_png, starts=photos.PNG, library="PIL.Image"),
    _images(fits_images.SUFFIXES, read=_fits, starts=(b"SIMPLE  =",), library="astropy"),
    _images(fits_images.PACKED, read=_fits, starts=fits_images.PACKED_STARTS, library="astropy"),
)


def read_each(paths: Sequence[str | PathLike[str]], *, channels: bool = False) -> Iterator[Frames]:
    """Yield the grey images of each file in memory, one image or a stack in the order of the file.

    For a multi-file OME-TIFF, its first file yields all images, and its other files none. With `channels`, stacks of
    several channels are yielded one by one: "channel" of the metadata is the index, and "names" those of all. Raises
    RecordingError, OSError or ImportError as :func:`open_frames`.
    """
    read_files: set[str] = set()
    for path in paths:
        with frames_of("path", validation.path("path", path)) as frames:
            files = frames.files
            if files and files <= read_files:
                continue
            read_files |= files
            parts = _channels_of(frames) if channels else [frames]
            stacks = [part.as_stack() for part in parts]
            read = [stack[...] for stack in stacks]
        for stack, values in zip(stacks, read, strict=True):
            if values.dtype == bool:  # a mask
                values = values.astype(np.uint8)
            names = names_of(Path(path).name, len(values))
            planes = _ArrayPlanes(values, "it", stack.path, names)
            yield replace(stack, planes=planes, numbers=np.arange(len(values)))


def _channels_of(frames: Frames) -> list[Frames]:
    """Return the images of each channel with its emission; those of one channel, or of one plane, as they are."""
    sizes = dict(zip(frames.axes, frames.numbers.shape, strict=False))
    count = sizes.pop("C", 1)
    if count == 1 or max(sizes.values(), default=1) == 1:
        return [frames]
    stated, waves = ([*frames.metadata.get(key, []), *[None] * count] for key in ("names", "emission"))
    names = [name or f"channel {k}" for k, name in enumerate(stated[:count])]
    return [
        replace(
            frames.one_of("C", k), metadata=frames.metadata | {"channel": k, "names": names, "emission": [waves[k]]}
        )
        for k in range(count)
    ]


def read_images(paths: Sequence[str | PathLike[str]]) -> Frames:
    """Return the images of all files, as by :func:`read_each`; ValueError unless all have one size and type."""
    files = list(read_each(paths))
    if not files:
        raise ValueError("paths must name a file or several, got none")
    kinds = [(file.planes.sides, file.dtype) for file in files]
    for file, ((height, width), dtype) in zip(files, kinds, strict=True):
        if ((height, width), dtype) != kinds[0]:
            (first_height, first_width), first_dtype = kinds[0]
            raise RecordingError(
                f"{file.names[0]}: images of {height} x {width} {dtype}, but the first images are of "
                f"{first_height} x {first_width} {first_dtype}"
            )
    if len(files) == 1:
        return files[0]
    orders = {str(file.metadata["rows"]): file for file in files if file.metadata.get("rows")}
    if len(orders) > 1:
        texts = [f"{file.names[0]} states ROWORDER = {order}" for order, file in orders.items()]
        raise RecordingError(f"images must have one order of rows: {', but '.join(texts[:2])}; flip the rows of one")
    names = tuple(name for file in files for name in file.names)
    planes = _ArrayPlanes(np.concatenate([file[...] for file in files]), "images", None, names)
    notes = tuple(dict.fromkeys(note for file in files for note in file.notes))
    metadata = combined_metadata([file.metadata for file in files])
    return Frames(planes, np.arange(len(names)), f"{UNKNOWN}YX", metadata, notes)


def _along_channels(frames: Frames, time: int | None, axes: str | None, series: bool) -> Frames:
    """Return images along C, Z, Y and X, at a single time; or of a `series` along T, C, Z, Y and X."""
    if axes is not None and (not isinstance(axes, str) or not re.fullmatch(r"[TCZ]*YX", axes)):
        raise ValueError(f'axes must be letters of TCZYX that end in YX, such as "ZYX", got {shown(axes)}')
    if time is not None:
        validation.integer("time", time, least=0, most=validation.MAX_VALUES)
    name, lengths = frames.name, frames.numbers.shape  # sizes of all axes before rows and columns
    if axes is None and frames.path is None and set(frames.axes[:-2]) <= {UNKNOWN}:
        if len(lengths) not in (1, 2):
            raise ValueError(
                "stack must have the shape (planes, height, width) or (channels, planes, height, width), got "
                f"{frames.shape}"
            )
        axes = "CZYX"[-frames.ndim :]
    if axes is not None:
        sizes = lengths if len(lengths) == len(axes) - 2 else tuple(side for side in lengths if side != 1)
        if len(sizes) != len(axes) - 2:
            raise RecordingError(f"{name}: axes={axes!r} does not match its shape {frames.shape}")
        frames = replace(frames, numbers=frames.numbers.reshape(sizes), axes=axes)
    long_axes = [letter for letter, side in zip(frames.axes, frames.numbers.shape, strict=False) if side != 1]
    if UNKNOWN in long_axes:
        count = frames.numbers.shape[frames.axes.index(UNKNOWN)]
        raise RecordingError(
            f"{name}: the file does not state the meaning of its axis of {count} images; state it, such as "
            'axes="ZYX" for planes along z'
        )
    wanted = "CZ"
    if "T" in frames.axes:
        count = frames.numbers.shape[frames.axes.index("T")]
        if "T" in long_axes and "Z" not in long_axes and time is None:
            raise RecordingError(
                f"{name}: it is a time series of {count} images without planes along z; if these are planes, "
                'state axes="ZYX"'
            )
        if count > 1 and time is None and series:
            wanted = "TCZ"
        elif count > 1 and time is None:
            raise RecordingError(
                f"{name}: it holds {count} time points; select one with time=, from 0 to {count - 1}, or restore "
                "each in turn"
            )
        else:
            frames = frames.one_of("T", validation.integer("time", time or 0, least=0, most=count - 1))
    numbers, order = frames.numbers, frames.axes[:-2]
    for letter in "CZ":
        if letter not in order:
            numbers, order = numbers[..., None], order + letter
    return replace(frames, numbers=numbers.transpose([order.index(letter) for letter in wanted]), axes=f"{wanted}YX")


def _with_used_metadata(frames: Frames) -> Frames:
    """Return images along C, Z, Y and X with the metadata of their file, without values that cannot be used."""
    count, metadata, notes = frames.numbers.shape[-2], frames.metadata, list(frames.notes)
    unusable: dict[str, str] = {}

    def usable_value(
        key: str, subject: str, value: float | Unusable | None, limits: tuple[float, float] | None
    ) -> float | None:
        if isinstance(value, float) and limits is not None and not limits[0] < value < limits[1]:
            value = Unusable(f"{value:g} m")
        if not isinstance(value, Unusable):
            return None if value is None else float(value)
        unusable[key] = value.words
        notes.append(f"The file states {subject} {value.words}, which cannot be used.")
        return None

    sides = {
        key: usable_value("pixel" if key == "down" else key, subject, metadata.get(key), _SIDES)
        for key, subject in _LENGTHS.items()
    }
    width, height = sides["pixel"], sides["down"]
    if width and height and abs(width - height) > _TOLERANCE * width:
        raise RecordingError(
            f"{frames.name}: its pixels are {format_length(height)} high and {format_length(width)} wide; resample "
            "it to square pixels"
        )
    lengths: Metadata = {"pixel": None if "pixel" in unusable else width, "step": sides["step"]}
    parts = (("pixel", "pixels"), ("step", "planes apart"))
    used_values = [f"{format_length(length)} {noun}" for key, noun in parts if (length := lengths[key]) is not None]
    if used_values:
        source = "array" if frames.path is None else "file"
        notes.append(f"From the {metadata['format']} metadata of the {source}: {', '.join(used_values)}.")
    if metadata.get("is_step_negative"):
        notes.append(f"The file states {NEGATIVE_STEP}")
    waves: Metadata = {}
    for key in ("emission", "excitation"):
        wavelengths = (list(metadata.get(key, [])) + [None] * count)[:count]
        waves[key] = tuple(
            usable_value(f"{key} {k}", f"that the {key} of channel {k} is", wave, _WAVES)
            for k, wave in enumerate(wavelengths)
        )
    lens = {key: usable_value(key, key, metadata.get(key), None) for key in ("NA", "magnification", "immersion")}
    stated_names = metadata.get("names", [])
    names = tuple((stated_names[k] if k < len(stated_names) else None) or f"channel {k}" for k in range(count))
    camera = {key: metadata[key] for key in (*_CAMERA, "missing") if key in metadata}
    camera |= {"modality": metadata.get("modality")}
    used = camera | lengths | {"names": names, "unusable": unusable} | waves | lens
    return replace(frames, metadata=used, notes=tuple(notes))
