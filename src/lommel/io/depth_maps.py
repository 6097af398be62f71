"""Read and write depth maps: metres, or levels, inverse depth or disparity with their conversion to metres."""

from __future__ import annotations

import math
from dataclasses import dataclass
from os import PathLike
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
import scipy
from numpy.typing import ArrayLike

from lommel.base import atomic, reading, validation
from lommel.base.arrays import Array, Values
from lommel.base.options import In, Options, Shown, listed
from lommel.core.answers import DType
from lommel.io.photos import JPEG, PhotoError, find_depth, recognized


def _inverse(name: str, value: object) -> tuple[float, float]:
    near, far = _pair(name, value)
    near = validation.real(name, near, above=0.0, unit="metres")
    return near, validation.real(name, far, above=near, infinite=True, unit="metres")


def _disparity(name: str, value: object) -> tuple[float, float]:
    product, offset = _pair(name, value)
    return validation.real(name, product, above=0.0, unit="metres times pixels"), validation.real(name, offset)


def _pair(name: str, value: object) -> tuple[object, object]:
    if not isinstance(value, tuple | list) or len(value) != 2:
        raise TypeError(f"{name} must be two numbers, got {validation.shown(value)}")
    return value[0], value[1]


def _numbers(name: str, value: ArrayLike) -> tuple[float, ...]:
    return tuple(np.atleast_1d(validation.number_array(name, value)).astype(float).tolist())


@dataclass(frozen=True, kw_only=True)
class DepthMapOptions(Options):
    """Conversion of the stored values of a depth map to metres; at most one of the first three options is given.

    Parameters
    ----------
    scale : float, optional
        Metres per level of integers, such as 0.001. Floats are metres without a scale. A PFM file whose header states
        a scale other than 1 is refused without it, since programs disagree on the meaning of that number.
    inverse : (float, float), optional
        For a map that is linear in 1 / distance, such as the maps of phones and MiDaS: distances (metres) at the
        highest level (255, 65535 or 1.0) and at level 0; the second distance may be infinite.
    disparity : (float, float), optional
        (product, offset) for a stereo disparity map: product of focal length (pixels) and baseline (metres), and an
        offset in pixels. The distance is product / (stored value + offset).
    unknown : float or sequence of float, optional
        Stored values to be treated as unknown, such as 0, or (-1, 255).
    resample : {"nearest"}, optional
        Resample a map of another size and the same aspect ratio. Each pixel of the photograph gets the value of the
        map pixel that contains its centre, so that distances are not averaged across edges.
    missing : {"nearest", "infinity"}, optional
        Replace unknown depth by that of the nearest pixel with a known depth, or by infinity.

    Raises
    ------
    TypeError, ValueError
        If an argument is of another type or out of range, or if two of `scale`, `inverse` and `disparity` are given.
    """

    heading: ClassVar[str] = "Depth map"
    scale: Annotated[
        float | None, In(least=1e-12, most=1e12, unit="metres per level"), Shown(flags=("--depth-scale",))
    ] = None
    inverse: Annotated[
        tuple[float, float] | None, _inverse, Shown(("--inverse-depth",), length="m", metavar="NEAR FAR")
    ] = None
    disparity: Annotated[tuple[float, float] | None, _disparity, Shown(metavar="FB OFFSET")] = None
    unknown: Annotated[tuple[float, ...], _numbers] = ()
    resample: Literal["nearest"] | None = None
    missing: Literal["nearest", "infinity"] | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if sum(option is not None for option in (self.scale, self.inverse, self.disparity)) > 1:
            raise ValueError("give only one of `scale`, `inverse` and `disparity`, which state how metres are stored")

    @property
    def states_metres(self) -> bool:
        """True if `scale`, `inverse` or `disparity` is given."""
        return (self.scale, self.inverse, self.disparity) != (None, None, None)

    def metres(self, values: Values, name: str) -> Array:
        """Convert the values of a map to metres, NaN if unknown; `name` is the name of the map in messages."""
        if values.dtype.kind != "f" and not self.states_metres:
            raise PhotoError(
                f"{name} is an integer image; give the scale, e.g. scale=0.001 for millimetres, or `inverse` or "
                "`disparity`"
            )
        # Warnings are suppressed, since a signalling NaN in the file would cause them.
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            distances: Array = values.astype(np.float64)  # stored values, converted in place
            distances[np.isin(values, self.unknown)] = np.nan
            lowest, highest = (float(extremum.reduce(distances, axis=None)) for extremum in (np.fmin, np.fmax))
            if self.inverse is not None:
                self._from_inverse(distances, values.dtype, (lowest, highest), name)
            elif self.disparity is not None:
                self._from_disparity(distances, (lowest, highest), name)
            else:
                distances *= self.scale or 1.0
                if zeros := distances.size - np.count_nonzero(distances):
                    raise ValueError(
                        f"{name} is 0 at {zeros} of {distances.size} points; if that means unknown, state it "
                        "as `unknown`"
                    )
                if lowest < 0.0:
                    raise ValueError(
                        f"{name} must hold distances > 0 metres, got {lowest * (self.scale or 1.0):g}; if the value "
                        f"{lowest:g} means unknown, state it as `unknown`"
                    )
        if highest == 1.0 and not self.states_metres:
            validation.tell(
                f"the farthest depth of {name} is exactly 1: maps of 0 to 1, such as inverse depth, are not in "
                "metres; `inverse` states the distances at 1 and at 0"
            )
        return distances

    def _from_inverse(self, levels: Array, kind: DType, ends: tuple[float, float], name: str) -> None:
        """Convert levels that are linear in 1 / distance to metres, in place.

        `kind` is the type of the stored levels, `ends` are the smallest and the largest level.
        """
        assert self.inverse is not None
        if kind.kind != "f" and (kind.kind != "u" or kind.itemsize > 2):
            raise ValueError(f"{name} holds {kind}; `inverse` is for uint8, uint16 and floats of 0 to 1")
        top = 1.0 if kind.kind == "f" else float(np.iinfo(kind.str).max)
        if ends[0] < 0.0 or ends[1] > top:
            raise ValueError(
                f"{name} must hold 0 to {top:g} for `inverse`, got {ends[0]:g} to {ends[1]:g}; divide by the largest "
                "value, or list the values that mean unknown in `unknown`"
            )
        if 0.0 < ends[1] < top / 8.0:
            validation.tell(
                f"the highest level of {name} is {ends[1]:g}, but `inverse` assumes {top:g} at the nearest "
                f"distance: if the levels have fewer bits, scale them to 0 to {top:g}"
            )
        near_vergence, far_vergence = (1.0 / distance for distance in self.inverse)
        levels *= (near_vergence - far_vergence) / top
        levels += far_vergence
        np.reciprocal(levels, out=levels)

    def _from_disparity(self, disparities: Array, ends: tuple[float, float], name: str) -> None:
        """Convert disparities to metres, in place; `ends` are the smallest and the largest disparity."""
        assert self.disparity is not None
        product, offset = self.disparity
        for value in (ends[0], ends[1] if ends[1] == math.inf else ends[0]):
            if not 0.0 < value + offset < math.inf and not math.isnan(value):
                raise ValueError(
                    f"{name} must hold finite disparities > {0.0 - offset:g} (the offset is {offset:g}), "
                    f"got {value:g}; if that means unknown, state it as `unknown`"
                )
        disparities += offset
        np.divide(product, disparities, out=disparities)

    def fitted(self, values: Values, shape: tuple[int, int], name: str) -> Values:
        """Return the values of a map at the pixels of a photograph of a `shape`.

        ValueError if the map has another shape, unless `resample` is given and the aspect ratio is the same.
        """
        if values.shape == shape:
            return values
        (height, width), (rows, columns) = shape, values.shape
        text = f"{name} must have the size of the upright photo, {width} x {height}, got {columns} x {rows}"
        # Aspect ratios count as equal if one side is within a pixel of the side that follows from the other side.
        if abs(rows - height * columns / width) >= 1.0 and abs(columns - width * rows / height) >= 1.0:
            raise ValueError(text)
        if self.resample is None:
            raise ValueError(f'{text}, of the same aspect ratio; resample="nearest" resamples it')
        row_index, column_index = (
            (2 * np.arange(side) + 1) * map_side // (2 * side)
            for side, map_side in zip(shape, values.shape, strict=True)
        )
        return values[np.ix_(row_index, column_index)]


def fill_missing(depth: Values, missing: str | None) -> Values:
    """Return a depth map with NaN replaced by the nearest depth or infinity; unchanged for None."""
    unknown = np.isnan(depth)
    if missing is None or not unknown.any():
        return depth
    if missing == "infinity":
        return np.where(unknown, np.inf, depth)
    if unknown.all():
        raise ValueError('depth is unknown everywhere; pass a map with depths, or missing="infinity"')
    indices = scipy.ndimage.distance_transform_edt(unknown, return_distances=False, return_indices=True)
    return np.asarray(depth[tuple(indices)])


@listed(DepthMapOptions)
def read_depth(
    path: str | PathLike[str],
    *,
    shape: tuple[int, ...] | None = None,
    options: DepthMapOptions | None = None,
    **given: Any,
) -> Array:
    """Read a depth map: the distance of every point from the lens, NaN where it is unknown.

    Parameters
    ----------
    path : path
        NPY, PFM, or grey TIFF, PNG or EXR file (channel Z, or the only channel), recognized by its content. Three
        equal channels count as grey, and an alpha channel that is opaque everywhere is ignored. ``file.tif[1]``
        selects one of several pages, from 0, ``file.exr[left.Z]`` a channel.
    shape : tuple of int, optional
        Shape of the photograph, height and width first, which the map must have or to which it is resampled.
    options : DepthMapOptions, optional
        Options as an object, which keywords change.
    {options}

    Returns
    -------
    ndarray, shape (height, width)
        Metres; may hold infinity, and NaN without `missing`.

    Raises
    ------
    PhotoError
        If the file is damaged, of another format, has several channels, or contains integers without an option on
        their conversion to metres.
    TypeError, ValueError
        If the map contains a distance that is not positive, or values that `inverse` or `disparity` does not convert
        to a distance, and that are not `unknown`; if its shape is not `shape`; or if an argument is out of range.
    OSError
        If the file cannot be read.

    Warns
    -----
    UserWarning
        If the largest value of floats without a conversion is 1, or the highest level for `inverse` is very low.

    Examples
    --------
    Millimetres in 16 bits, 0 where the sensor saw nothing, as depth cameras store them:

    >>> import tempfile, pathlib
    >>> from PIL import Image
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "depth.png"
    >>> Image.fromarray(np.array([[1500, 0]], np.uint16)).save(file)
    >>> lm.imaging.read_depth(file, scale=0.001, unknown=0)
    array([[1.5, nan]])

    A disparity map of Middlebury, and unknown depth filled:

    >>> lm.imaging.read_depth(file, disparity=(771.6, 131.1), unknown=0, missing="nearest").round(2)
    array([[0.47, 0.47]])
    """
    source, part = reading.part_of(validation.path("path", path))
    conversion = DepthMapOptions.of("read_depth", options, given)
    size = None if shape is None else validation.image_shape(tuple(shape[:2]))
    if size is None and conversion.resample is not None:
        raise ValueError("resample needs the shape to resample to")
    data = reading.contents(source)
    name = validation.line(source)
    if data.startswith(JPEG):
        raise PhotoError(f"{name} is a JPEG, which does not preserve depth; save it as TIFF or 16-bit PNG")
    with recognized(source, "depth map", data, part) as form:
        # `inverse` and `disparity` ignore the scale in a PFM header, so that `scale` is not required with them.
        values = form.read(data, 1.0 if conversion.scale is None and conversion.states_metres else conversion.scale)
    del data  # frees memory
    if values.ndim != 2 or 0 in values.shape:
        raise PhotoError(f"{name} has the shape {values.shape}; a depth map has (height, width)")
    if values.dtype.kind not in "iuf":
        raise PhotoError(f"{name} holds {values.dtype}; a depth map holds numbers")
    metres = conversion.metres(values if size is None else conversion.fitted(values, size, name), name)
    return fill_missing(metres, conversion.missing)


def write_depth(path: str | PathLike[str], depth: ArrayLike) -> None:
    """Write a depth map, or its standard error, in single precision, for :func:`lommel.imaging.read_depth`.

    The file is written under a temporary name and moved into place.

    Parameters
    ----------
    path : path
        .tif, .npy, .pfm or .exr.
    depth : array_like, shape (height, width)
        Metres; NaN where unknown, may be infinite.

    Raises
    ------
    TypeError, ValueError
        If `depth` does not have the shape (height, width), holds negative values, or the suffix is unknown.
    OSError
        If the file cannot be written.
    """
    target = validation.path("path", path)
    write = find_depth(target).write
    metres = validation.array("depth", depth, "metres")
    if metres.dtype.kind not in "iuf" or metres.ndim != 2 or 0 in metres.shape:
        raise ValueError(f"depth must be numbers of the shape (height, width), got {metres.dtype} {metres.shape}")
    if np.any(metres < 0.0):
        raise ValueError(f"depth must be >= 0 metres, got {metres[metres < 0.0].flat[0]:g}")
    with np.errstate(over="ignore"):
        data: bytes = write(np.asarray(metres, dtype=np.float32))
    atomic.write(target, data)
