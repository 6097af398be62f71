"""Files of focus pulls: numbered photographs, an animation or a stack."""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterable
from functools import partial
from os import PathLike
from pathlib import Path

import numpy as np

from lommel.base import atomic, validation
from lommel.io import registry
from lommel.io.photos import encoded, find
from lommel.io.registry import Description, Format, Values

_NUMBER = re.compile(r"%0?\d?d")


def check_pattern(path: str | PathLike[str], name: str = "path") -> Path:
    """Return a path that frames can be written to, with one number such as ``%03d`` or none."""
    target = validation.path("path", path)
    numbers = _NUMBER.findall(target.name)
    if len(numbers) != target.name.count("%") or len(numbers) > 1 or "%" in str(target.parent):
        raise ValueError(
            f"{name} may have one number such as %03d in its last part and no other %, "
            f"got {validation.shown(str(path))}"
        )
    if numbers:
        find(target, name)
        return target
    try:
        registry.find("frames", target, name)
    except ValueError as error:
        raise ValueError(f"{error}; a number such as %03d makes a photograph of each") from None
    return target


def is_animation(path: str | PathLike[str]) -> bool:
    """Return whether frames are written to one animation, which has 8 bits."""
    target = validation.path("path", path)
    return not _NUMBER.search(target.name) and registry.find("frames", target).holds == (_8,)


def write_frames(
    path: str | PathLike[str],
    frames: Iterable[Values],
    *,
    fps: float = 12.0,
    quality: int = 95,
) -> list[Path]:
    """Write frames and return the files written; a failure leaves no file.

    Parameters
    ----------
    path : path
        With a number such as ``%03d``: one photograph per frame, counted from 1. Without: an 8-bit animation, .gif
        (256 colours per frame), .png or .apng (lossless) or .webp; or a TIFF stack.
    frames : iterable of ndarray
        Stored values, all of one shape and type, taken one after another.
    fps : float, default 12
        Frames per second of an animation, which repeats forever.
    quality : int, default 95
        Quality of JPEG and WebP, 1 to 100.

    Returns
    -------
    list of path

    Raises
    ------
    TypeError, ValueError
        If an argument is out of range, there are no frames, or they differ in shape or type.
    OSError
        If a file cannot be written.
    """
    target = check_pattern(path)
    duration = 1000.0 / validation.real("fps", fps, least=1e-3, below=1000.0)
    validation.integer("quality", quality, least=1, most=100)
    if _NUMBER.search(target.name):
        return _numbered(target, _alike(frames), quality)
    kept = list(_alike(frames))
    form = registry.find("frames", target, holding=f"of {kept[0].dtype.name}")
    atomic.write(target, form.write(kept, duration, quality))
    return [target]


def _alike(frames: Iterable[Values]) -> Iterable[Values]:
    first = None
    if not isinstance(frames, Iterable) or getattr(frames, "ndim", 1) == 0 or np.ma.is_masked(frames):
        raise TypeError(f"frames must be arrays, got {validation.shown(frames)}")
    for frame in frames:
        if not isinstance(frame, np.ndarray) or frame.ndim not in (2, 3):
            raise TypeError(
                f"frames must be arrays of shape (height, width) or with 3 channels, got {validation.shown(frame)}"
            )
        first = frame if first is None else first
        if (frame.shape, frame.dtype) != (first.shape, first.dtype):
            raise ValueError(f"frames must be alike, got {first.shape} {first.dtype} and {frame.shape} {frame.dtype}")
        yield frame
    if first is None:
        raise ValueError("there must be at least one frame")


def _numbered(target: Path, frames: Iterable[Values], quality: int) -> list[Path]:
    """Write all frames, then move them into place."""
    if not target.parent.is_dir():  # before the first frame is made
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target))
    made = []
    with atomic.together() as put:
        for number, frame in enumerate(frames, 1):
            made.append(target.with_name(target.name % number))
            put(made[-1], encoded(target, frame, quality))
    return made


def _stack(frames: list[Values], _duration: float, _quality: int) -> bytes:
    import tifffile

    photometric = "rgb" if frames[0].ndim == 3 else "minisblack"
    return atomic.contents(tifffile.imwrite, np.stack(frames), photometric=photometric, metadata=None)


def _animation(form: str, frames: list[Values], duration: float, quality: int) -> bytes:
    from PIL import Image, features

    if form == "webp" and not features.check("webp"):
        raise ImportError("this Pillow has no WebP; write .png, .gif or .tif")
    first, *others = map(Image.fromarray, frames)
    options: Description = {"quality": quality} if form == "webp" else {}
    options["duration"] = duration if form == "png" else round(duration)
    return atomic.contents(first.save, form, save_all=True, append_images=others, loop=0, **options)


_8, _DEEP = "of uint8", ("of uint16", "of float32", "of float64")
_animated = partial(Format, "frames", library="PIL.Image", holds=(_8,))
registry.register(
    _animated((".gif",), partial(_animation, "gif"), what="256 colours per frame"),
    _animated((".png", ".apng"), partial(_animation, "png")),
    _animated((".webp",), partial(_animation, "webp")),
    Format("frames", (".tif", ".tiff"), _stack, library="tifffile", holds=(_8, *_DEEP)),
)
