"""Pages of long TIFF files: memory that they take to open, and how many tags they may have."""

from __future__ import annotations

import re
import struct
import sys
from pathlib import Path

import pytest

from lommel.recorded.frames import RecordingError, open_frames


def sparse(path: Path, count: int, apart: int) -> None:
    """Write pages that lie far apart, and nothing between them."""
    tags = [(256, 4, 1, 16), (257, 4, 1, 16), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 0)]
    tags += [(277, 3, 1, 1), (278, 4, 1, 16), (279, 4, 1, 256)]
    with path.open("wb") as file:
        file.write(b"II*\0" + struct.pack("<I", apart))
        for k in range(1, count + 1):
            file.seek(k * apart)
            own = [(*tag[:3], k * apart + 512) if tag[0] == 273 else tag for tag in tags]
            file.write(struct.pack("<H", len(own)) + b"".join(struct.pack("<HHII", *tag) for tag in own))
            file.write(struct.pack("<I", (k + 1) * apart if k < count else 0))
        file.truncate((count + 1) * apart)


@pytest.mark.skipif(sys.platform != "linux", reason="Linux tells the most memory since it was asked to forget")
def test_a_long_file_takes_little_memory_to_open(tmp_path):
    def bytes_of(name):
        return 1024 * int(re.search(rf"{name}:\s*(\d+)", Path("/proc/self/status").read_text())[1])

    sparse(tmp_path / "a.tif", 1500, 2**16)
    open_frames(tmp_path / "a.tif").close()  # libraries are there
    Path("/proc/self/clear_refs").write_text("5")
    before = bytes_of("VmRSS")
    with open_frames(tmp_path / "a.tif") as found:
        assert found.shape == (1500, 16, 16)
        assert not found[700].any()
    assert bytes_of("VmHWM") - before < 2**24  # 94 MB lie around its pages


def test_a_page_of_too_many_tags_is_refused(tmp_path):
    sparse(tmp_path / "a.tif", 3, 2**16)
    with (tmp_path / "a.tif").open("r+b") as file:
        file.seek(2 * 2**16)
        file.write(struct.pack("<H", 5000))
    with pytest.raises(RecordingError, match=r"a\.tif: it has a page of 5000 tags; the limit is 4096"):
        open_frames(tmp_path / "a.tif")
