"""Video files that tests read, written by PyAV alone."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import numpy as np


def write_video(
    path: Path,
    frames: Sequence[np.ndarray],
    times: Sequence[float] | None = None,
    *,
    rate: int = 25,
    codec: str = "ffv1",
    stored: str | None = None,
    form: str | None = None,
    **options: str,
) -> Path:
    """Write frames of uint8 (grey or RGB) or uint16 (grey, in the bits of the stored format) at their times."""
    import av

    own = "gray" if frames[0].dtype == np.uint8 else "gray16le"
    kind = "rgb24" if frames[0].ndim == 3 else own
    with av.open(str(path), "w", format=form) as container:
        stream = container.add_stream(codec, rate=rate, options=options)
        stream.height, stream.width = frames[0].shape[:2]
        stream.pix_fmt = stored or kind
        stream.codec_context.time_base = Fraction(1, 1000)
        for k, values in enumerate(frames):
            if kind == "gray16le":
                frame = planar(values, stream.pix_fmt)
            else:
                frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(values), format=kind)
            frame.pts = round(1000 * (k / rate if times is None else times[k]))
            frame.time_base = Fraction(1, 1000)
            container.mux(stream.encode(frame))
        container.mux(stream.encode(None))
    return path


def planar(values: np.ndarray, stored: str):
    """A grey frame with the values as they are, in 16-bit words."""
    import av

    frame = av.VideoFrame(values.shape[1], values.shape[0], stored)
    (plane,) = frame.planes
    words = np.zeros((values.shape[0], plane.line_size // 2), np.uint16)
    words[:, : values.shape[1]] = values
    plane.update(words.tobytes())
    return frame


def frames_of(path: Path, form: str | None = None) -> tuple[np.ndarray, list[float]]:
    """All frames of a file, as PyAV decodes them, and their times."""
    import av

    with av.open(str(path)) as container:
        frames = list(container.decode(video=0))
        return np.array([frame.to_ndarray(format=form) for frame in frames]), [float(frame.time) for frame in frames]
