"""Stacks that microscopes recorded: OME-TIFF, TIFF of ImageJ and OME-Zarr, read lazily with their metadata."""

from __future__ import annotations

import errno
import re
from contextlib import suppress
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from lommel.base import atomic, optional, reading, validation
from lommel.base.arrays import Json, Values
from lommel.base.units import format_length
from lommel.base.validation import line, shown
from lommel.recorded.frames import UNKNOWN, Frames, RecordingError, Unusable, open_frames

_JSON = 2**24  # largest size of a parsed description, bytes
_CHUNK = (32, 256, 256)  # chunks of written OME-Zarr: planes, rows, columns
_TOLERANCE = 1e-4  # relative difference up to which lengths count as equal
# Lengths in files, in the words of messages; "down" is the height of a pixel.
_LENGTHS = {"pixel": "a pixel size of", "down": "a pixel height of", "step": "a plane spacing of"}
_SIDES = 1e-12, 1e-4  # metres, range of voxel sides in the sample
_WAVES = 1e-7, 1e-4  # metres, range of wavelengths: 0.52 nm is a wavelength in micrometres with a wrong unit


@dataclass(frozen=True, eq=False, repr=False)
class Recording:
    """Stack that a microscope recorded, with the metadata of its file; values are read from the disk on demand.

    Returned by :func:`lommel.microscopy.open_recording`.

    Attributes
    ----------
    shape : tuple of int
        Channels, planes, height, width.
    dtype : dtype
        Type of the stored values.
    pixel : float or None
        Side of a pixel in the sample, metres; None if the file states none.
    step : float or None
        Stage displacement between planes, metres, not negative; None if the file states none.
    names : tuple of str
        Names of the channels.
    emission, excitation : tuple of float or None
        Wavelength of each channel, metres.
    NA, magnification, immersion : float or None
        Numerical aperture and magnification of the objective, and index of the immersion, if the file states them.
    path : Path or None
    frames : Frames
        Reader of the planes.
    notes : tuple of str
        Sentences on the values taken from the file, and on values that it lacks.
    unusable : dict
        Values in the file that cannot be used, such as 0, in the words of the file; the keys are "pixel", "step",
        "NA", "magnification", "immersion", or "emission" and "excitation" with the number of the channel, such as
        "emission 0".
    """

    frames: Frames
    pixel: float | None = None
    step: float | None = None
    names: tuple[str, ...] = ()
    emission: tuple[float | None, ...] = ()
    excitation: tuple[float | None, ...] = ()
    NA: float | None = None
    magnification: float | None = None
    immersion: float | None = None
    path: Path | None = None
    notes: tuple[str, ...] = ()
    unusable: dict[str, str] = field(default_factory=dict)

    @property
    def shape(self) -> tuple[int, int, int, int]:  # noqa: D102
        channels, planes = self.frames.numbers.shape
        return (channels, planes, *self.frames.planes.sides)

    @property
    def dtype(self) -> np.dtype[np.generic]:  # noqa: D102
        return self.frames.dtype

    def __repr__(self) -> str:
        channels, planes, height, width = self.shape
        name = "array" if self.path is None else self.path.name
        known = [] if self.pixel is None else [f"pixels of {format_length(self.pixel)}"]
        known += [] if self.step is None else [f"planes {format_length(self.step)} apart"]
        sides = ", ".join(known) or "without voxel sizes"
        channel_text = f"{channels} channels of " if channels > 1 else ""
        return f"<Recording {name!r}: {channel_text}{planes} planes of {height} x {width}, {self.dtype}, {sides}>"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Close the file."""
        self.frames.close()

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> Values:
        return np.asarray(self.only("stack"), dtype)

    def stack(self, channel: int = 0) -> Frames:
        """Return a channel as a stack of shape (planes, height, width), read by indices and slices.

        Parameters
        ----------
        channel : int, default 0

        Raises
        ------
        TypeError, ValueError
            If `channel` is out of range; RecordingError, when it is read, if the file is damaged.
        """
        number = validation.integer("channel", channel, least=0, most=self.shape[0] - 1)
        return self.frames.one_of("C", number)

    def only(self, name: str) -> Frames:
        """Return the only channel as a stack; ValueError about the argument `name` if there are several."""
        if self.shape[0] > 1:
            raise ValueError(
                f"{name} must be one channel, got a recording of {self.shape[0]}: {', '.join(self.names)}; "
                "use recording.stack(0) for the first"
            )
        return self.stack()


def open_recording(
    path: str | PathLike[str] | ArrayLike | Recording,
    *,
    time: int | None = None,
    axes: str | None = None,
    image: int | None = None,
) -> Recording:
    """Open a stack that a microscope recorded, with its voxel sizes, channels and wavelengths.

    Parameters
    ----------
    path : path or array_like
        An OME-TIFF file, another TIFF file (ImageJ's voxel sizes are read), a folder of OME-Zarr (OME-NGFF 0.4 or
        0.5); or an array of NumPy, dask or Zarr, of shape (planes, height, width) or (channels, planes, height,
        width).
    time : int, optional
        Number of the time point, from 0; required if the file holds several time points.
    axes : str, optional
        Letters of the axes, such as "ZYX" or "CZYX", if the file does not state them or states wrong letters.
    image : int, optional
        Number, from 0, of the image in a TIFF file with several images; by default the one with the most values.

    Returns
    -------
    Recording

    Raises
    ------
    RecordingError
        If the file is damaged, holds colours (RGB), several time points without `time`, or axes that are unknown.
    TypeError, ValueError
        If an argument is out of range.
    OSError, ImportError
        If the file cannot be read, or tifffile or zarr is not installed.

    See Also
    --------
    lommel.microscopy.restore
    """
    if isinstance(path, Recording):
        return path
    if axes is not None and (not isinstance(axes, str) or not re.fullmatch(r"[TCZ]*YX", axes)):
        raise ValueError(f'axes must be letters of TCZYX that end in YX, such as "ZYX", got {shown(axes)}')
    for name, place in (("time", time), ("image", image)):
        if place is not None:
            validation.integer(name, place, least=0, most=validation.MAX_VALUES)
    frames = open_frames(path, image=image, name="stack")
    try:
        return _recording(_with_axes(frames, axes, time))
    except BaseException:
        frames.close()
        raise


def _with_axes(frames: Frames, axes: str | None, time: int | None) -> Frames:
    """Return images along C and Z, at a single time."""
    name, lengths = frames.name, frames.numbers.shape  # sizes of all axes before rows and columns
    if axes is None and frames.path is None and not frames.metadata_format:
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
    if "T" in frames.axes:
        count = frames.numbers.shape[frames.axes.index("T")]
        if "T" in long_axes and "Z" not in long_axes and time is None:
            raise RecordingError(
                f"{name}: it is a time series of {count} images without planes along z; if these are planes, "
                'state axes="ZYX"'
            )
        if count > 1 and time is None:
            raise RecordingError(
                f"{name}: it holds {count} time points; select one with time=, from 0 to {count - 1}, or restore "
                "each in turn"
            )
        frames = frames.one_of("T", validation.integer("time", time or 0, least=0, most=count - 1))
    return frames.along("CZYX")


def _recording(frames: Frames) -> Recording:
    """Return a recording with the metadata of its file, without values that cannot be used."""
    count, metadata, notes = frames.numbers.shape[0], frames.metadata, list(frames.notes)
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
    lengths = {"pixel": None if "pixel" in unusable else width, "step": sides["step"]}
    parts = (("pixel", "pixels"), ("step", "planes apart"))
    used_values = [f"{format_length(length)} {noun}" for key, noun in parts if (length := lengths[key]) is not None]
    if used_values:
        notes.append(f"From the {frames.metadata_format} metadata of the file: {', '.join(used_values)}.")
    if metadata.get("is_step_negative"):
        notes.append(
            "The file states a negative plane spacing, of which the magnitude was used: its sign does not set the "
            "direction of z."
        )
    waves: dict[str, tuple[float | None, ...]] = {}
    for key in ("emission", "excitation"):
        wavelengths = (list(metadata.get(key, [])) + [None] * count)[:count]
        waves[key] = tuple(
            usable_value(f"{key} {k}", f"that the {key} of channel {k} is", wave, _WAVES)
            for k, wave in enumerate(wavelengths)
        )
    lens = {key: usable_value(key, key, metadata.get(key), None) for key in ("NA", "magnification", "immersion")}
    stated_names = metadata.get("names", [])
    names = tuple((stated_names[k] if k < len(stated_names) else None) or f"channel {k}" for k in range(count))
    return Recording(
        frames, lengths["pixel"], lengths["step"], names, waves["emission"], waves["excitation"],
        lens["NA"], lens["magnification"], lens["immersion"], frames.path, tuple(notes), unusable,
    )  # fmt: skip


def save_stack(path: Path, values: Values, recording: Recording, description: str = "") -> None:
    """Write a stack, of shape (channels, planes, height, width), with the metadata of its recording, atomically.

    The format is OME-TIFF if the name ends in .tif or .tiff, OME-Zarr (0.4) if it ends in .zarr.
    """
    if kind_of(path) == "zarr":
        atomic.write_folder(path, lambda folder: _fill_zarr(folder, values, recording, path.stem, description))
    else:
        atomic.write_by(path, lambda target: _fill_tiff(target, values, recording, description))


def kind_of(path: Path, recording: str | Path | None = None) -> str:
    """Return "zarr" or "tiff", by the ending of a path.

    Raise ValueError for other endings, or if the path is the `recording` from which the stack was restored;
    FileExistsError for a folder that holds no restored stack; ImportError if the library is not installed.
    """
    if recording is not None and path.resolve() == Path(recording).resolve():
        raise ValueError(f"the restored stack must not replace the recording, got {line(path)} for both")
    file_name = path.name.lower()
    if file_name.endswith(".zarr"):
        optional.require("zarr", "writing OME-Zarr needs", "zarr")
        require_own(path)
        return "zarr"
    if file_name.endswith((".tif", ".tiff")):
        optional.require("tifffile", "writing OME-TIFF needs", "images")
        return "tiff"
    raise ValueError(f"a stack must end in .ome.tif or .ome.zarr, got {shown(path.name)}")


def require_own(path: Path) -> None:
    """Raise FileExistsError unless a path is free or holds a stack written by this package, which may be replaced."""
    replaceable = not (path.exists() or path.is_symlink())
    if not replaceable:
        with suppress(OSError, ValueError):
            replaceable = "lommel" in reading.json(reading.contents(path / ".zattrs", _JSON))
    if not replaceable:
        raise FileExistsError(errno.EEXIST, "holds no restored stack, and is not replaced", str(path))


def _fill_tiff(target: Path, values: Values, recording: Recording, description: str) -> None:
    import tifffile

    fields: Json = {"axes": "CZYX", "Description": description}
    for key, letters in (("pixel", "XY"), ("step", "Z")):
        if (value := getattr(recording, key)) is not None:
            for letter in letters:
                # Rounded to twelve digits, so that 6.5e-08 m is written as 0.065 micrometres.
                fields[f"PhysicalSize{letter}"] = float(f"{1e6 * value:.12g}")
                fields[f"PhysicalSize{letter}Unit"] = "µm"
    channel: Json = {"Name": list(recording.names)}
    for key, name in (("emission", "EmissionWavelength"), ("excitation", "ExcitationWavelength")):
        waves = getattr(recording, key)
        if waves and all(wave is not None for wave in waves):
            channel |= {name: [float(f"{1e9 * wave:.12g}") for wave in waves], f"{name}Unit": ["nm"] * len(waves)}
    fields["Channel"] = channel
    # Offsets in a TIFF file have 32 bits: 32 MB are left for the metadata.
    is_big = values.nbytes > 2**32 - 2**25
    tifffile.imwrite(target, values, ome=True, metadata=fields, photometric="minisblack", bigtiff=is_big)


def new_zarr(folder: Path, shape: tuple[int, ...], recording: Recording, name: str, description: str = "") -> Any:
    """Return the array of a new OME-Zarr (0.4) of float32, of shape (channels, planes, height, width)."""
    import zarr

    group = zarr.create_group(str(folder), zarr_format=2)
    sides = [1.0]
    known_sides = (recording.step, recording.pixel, recording.pixel)
    sides += [1.0 if value is None else float(f"{1e6 * value:.12g}") for value in known_sides]
    has_sizes = recording.pixel is not None and recording.step is not None
    space = [{"name": name, "type": "space"} | ({"unit": "micrometer"} if has_sizes else {}) for name in "zyx"]
    group.attrs["multiscales"] = [
        {
            "version": "0.4",
            "name": name,
            "axes": [{"name": "c", "type": "channel"}, *space],
            "datasets": [{"path": "0", "coordinateTransformations": [{"type": "scale", "scale": sides}]}],
        }
    ]
    channels: list[Json] = [{"label": name, "active": True, "color": "FFFFFF"} for name in recording.names]
    for channel, wave in zip(channels, recording.emission, strict=False):
        if wave is not None:
            channel["emission_wavelength"] = float(f"{1e9 * wave:.12g}")
    group.attrs["omero"] = {"channels": channels}
    group.attrs["lommel"] = {"description": description}
    chunks = (1, *(min(limit, side) for limit, side in zip(_CHUNK, shape[1:], strict=True)))
    return group.create_array(
        "0", shape=shape, dtype="float32", chunks=chunks, chunk_key_encoding={"name": "v2", "separator": "/"}
    )


def _fill_zarr(folder: Path, values: Values, recording: Recording, name: str, description: str) -> None:
    array = new_zarr(folder, values.shape, recording, name, description)
    for channel in range(values.shape[0]):
        for plane in range(0, values.shape[1], _CHUNK[0]):
            array[channel, plane : plane + _CHUNK[0]] = values[channel, plane : plane + _CHUNK[0]]
