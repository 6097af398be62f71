"""The command ``lommel sharpen``: deblurring of videos and photos of known depth."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import numpy as np

from lommel.base import validation
from lommel.base.arrays import Array, Values
from lommel.base.encoding import from_light, warn_if_bright
from lommel.base.options import Shown
from lommel.cli.command import OUTPUT, command, filled
from lommel.cli.instruments import FrameNoise, PhotoCamera, radial_instrument
from lommel.cli.output import Steps, progress, require_folder, written
from lommel.cli.photo_commands import DepthMap, Encoding, depth_facts, output_type
from lommel.cli.video_input import Coding, Stop, coding_of
from lommel.imaging import DepthMapOptions, LiveSharpen, read_depth, read_photo, write_photo
from lommel.imaging.blur import warn_of_depths
from lommel.imaging.focal_engine import BLOCK
from lommel.io import photos, videos
from lommel.io.depth_maps import fill_missing
from lommel.io.registry import formats, suffixes
from lommel.report import Report, Wrapped, finite
from lommel.report.table import told

if TYPE_CHECKING:
    from lommel.optics.lens import Lens

_RANGE_MARGIN = 1e-3  # relative margin of the range of the filters beyond the distances
_MAX_NEAREST = 1e9  # metres: largest nearest distance of filters, practically infinity


class Clip(NamedTuple):
    """Frames to sharpen, and the function that writes the light of a frame (1 is white) at its time."""

    shape: tuple[int, ...]
    coding: Coding
    frames: Iterator[videos.VideoFrame]
    write: Callable[[Values, float], object]
    video: videos.VideoFrames | None


@command
@filled(video=suffixes("video"), photo=suffixes("photo"))
def sharpen(
    clip: Path,
    lens: Path,
    /,
    *,
    output: Annotated[Path, OUTPUT],
    at: Annotated[float | None, Shown(length="m")] = None,
    map_: Annotated[Path | None, Shown(("--depth",), metavar="FILE")] = None,
    encoding: Encoding | None = None,
    clip_camera: PhotoCamera = PhotoCamera(),
    video_noise: FrameNoise = FrameNoise(),
    depth_map: DepthMap = DepthMap(missing="nearest"),
) -> Report:
    """Sharpen video or a photo of known depth.

    Wiener filters in one pass, at video rate. CLIP is a video file, numbered images (a folder or frames/%04d.tif)
    or a photo, in grey or colour. LENS is a lens file. Blur wider than about 40 pixels is removed only in part;
    `lommel restore` takes longer and removes more. Ctrl-C, SIGTERM or a closed terminal ends the command and leaves a
    complete file.

    Parameters
    ----------
    output
        Sharp video: {video}; of a photo: {photo}.
    at
        Distance of the whole scene, such as 1.5m.
    map_
        Depth map instead, of the size of the frames or of their blocks of 4 x 4 pixels.
    encoding
        Encoding of the values; by default grey of more than 8 bits and floats are linear, all else is sRGB.
    f_number
        F-number; overrides the lens file.

    Examples
    --------
      lommel sharpen clip.mp4 phone.toml --focus 2m --at 1.5m -o sharp.mp4
      lommel sharpen photo.png phone.toml --focus 1.5m --depth depth.tif --white 5000 --read 3 -o sharp.png
    """
    if (at is None) == (map_ is None):
        raise ValueError(f"give one of --at and --depth, got {'neither' if at is None else 'both'}")
    require_folder(output)
    instrument = radial_instrument(lens, **vars(clip_camera))
    lens_in_use = instrument.lens
    count = 0
    with Stop().signals() as stop, progress("reading", endless=True) as status, ExitStack() as stack:
        coder = partial(coding_of, video_noise=video_noise, camera=instrument.camera, encoding=encoding)
        shape, coding, frames, write, video = _clip(clip, output, coder, encoding, status, stack)
        metres = np.array([[at]]) if map_ is None else _map(map_, depth_map, shape[:2])
        distance: float | Array = fill_missing(metres, depth_map.missing or "nearest") if at is None else at
        if map_ is not None:
            warn_of_depths(lens_in_use, instrument.side, distance)
        if coding.guess:
            status.tell(coding.guess)
        status("computing the filters")
        live: LiveSharpen | None = None
        start = time.perf_counter()
        while (frame := stop.next(frames)) is not None:
            light = coding.light(frame.values)
            if live is None:
                live = _filters(lens_in_use, instrument.side, distance, coding, light)
                start, first_time = time.perf_counter(), frame.time
                mean = float(coding.noise.electrons(float(np.nanmean(light))))
            write(live(light, distance) / np.float32(coding.white), frame.time - first_time)
            count += 1
            status(f"{count} frames, {count / (time.perf_counter() - start):.3g}/s")
        seconds = time.perf_counter() - start
        failure = None if video is None else video.lost
        end_reason = "interrupted" if stop.requested else failure or "the end"
        if not count:
            if stop.requested:
                raise KeyboardInterrupt
            raise ValueError(f"no frame was read: {end_reason}")
    ends = [float(np.min(distance)), float(np.max(distance))]
    blur = float(np.max(2.0 * lens_in_use.pupil(np.array(ends)).geometric_radius())) / instrument.side
    facts = {
        **coding.facts,
        "shape": list(shape),
        "pixel": instrument.side,
        "focus_distance": finite(lens_in_use.focus_distance),
        "f_number": lens_in_use.f_number,
        "focal_length": lens_in_use.focal_length,
        "between": [finite(end) for end in ends],
        "unknown": depth_facts(metres)["depth_unknown"],
        "blur": blur,
        "frames": count,
        "seconds": seconds,
        "ended": end_reason,
    }
    notes = [coding.guess]
    if video is not None:
        bits, lossy = coding.check_compression(video.bits, mean)
        notes.append(lossy)
        facts |= bits | {"frames_dropped": video.dropped, "frames_of_another_size": video.refused}
    lines = Report({}, [Wrapped(note) for note in notes if note])
    return told(facts, succeeded=failure is None) + lines + written([output])


def _map(path: Path, values: DepthMapOptions, shape: tuple[int, ...]) -> Array:
    """Return a depth map of the size of frames or, unless it is to be resampled, of their blocks."""
    depth_map = read_depth(
        path, shape=None if values.resample is None else shape, options=replace(values, missing=None)
    )
    sizes = shape, (shape[0] // BLOCK, shape[1] // BLOCK)
    if depth_map.shape not in sizes:
        raise ValueError(
            f"{validation.line(path)} must have the shape {sizes[0]} or {sizes[1]}, got {depth_map.shape}; "
            '`resample` "nearest" uses the nearest pixels of a map of the same aspect ratio'
        )
    return depth_map


def _filters(lens: Lens, pixel: float, distance: float | Array, coding: Coding, first_frame: Values) -> LiveSharpen:
    """Return the filters for a range of distances, and for the mean light of the first frame."""
    nearest, farthest = float(np.min(distance)), float(np.max(distance))
    return LiveSharpen(
        lens,
        pixel,
        between=(min(nearest, _MAX_NEAREST) * (1.0 - _RANGE_MARGIN), farthest * (1.0 + _RANGE_MARGIN)),
        noise=coding.noise,
        shape=first_frame.shape,
        light=max(1.0, float(coding.noise.electrons(float(np.nanmean(first_frame))))),
        saturation=coding.saturation,
    )


def _clip(
    clip: Path, output: Path, coder: Callable[..., Coding], encoding: str | None, status: Steps, stack: ExitStack
) -> Clip:
    """Open a photo or a video, and its output."""
    if (
        clip.suffix.lower() in {suffix for form in formats("photo") for suffix in form.suffixes}
        and "%" not in clip.name
    ):
        photos.find(output, "--output")
        picture = read_photo(clip, encoding)
        values = picture.values
        if values.dtype.kind == "f":
            warn_if_bright(values)
        levels = 0 if values.dtype.kind == "f" else 2 ** (8 * values.dtype.itemsize)
        coding = coder(levels, values.dtype, picture.encoding)
        dtype, stored_as = output_type(picture, output)

        def save(light: Values, _: float) -> None:
            write_photo(output, light, encoding=stored_as, dtype=dtype, like=picture)

        return Clip(values.shape, coding, iter([videos.VideoFrame(values, 0.0)]), save, None)
    form = videos.find(output, "--output")
    video = stack.enter_context(videos.video_frames(str(clip), tell=status.tell))
    coding = coder(video.levels, video.dtype, video.encoding)
    # Grey of more than 8 bits keeps its bits and its encoding, if the format can store them.
    is_16_bit = video.dtype != np.uint8 and len(video.shape) == 2 and "of uint16" in form.holds
    write = stack.enter_context(form.write(output, video.interval))

    def store(light: Values, seconds: float) -> None:
        stored = from_light(light, coding.encoding, np.uint16) if is_16_bit else from_light(light, "srgb", np.uint8)
        write(stored, seconds)

    return Clip(video.shape, coding, video, store, video)
