"""Write the motorcycle of the Middlebury benchmark, a photograph whose depth is known, for `lommel blur`.

`make photo` runs this and `motorcycle.sh`. The scene comes with scikit-image: the left view at quarter
size, 741 x 500, and its disparity. Source: D. Scharstein, H. Hirschmueller, Y. Kitajima, G. Krathwohl, N. Nesic,
X. Wang, P. Westling, "High-resolution stereo datasets with subpixel-accurate ground truth", GCPR 2014,
doi:10.1007/978-3-319-11752-2_3.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import tifffile
from skimage.data import stereo_motorcycle

from lommel.base.encoding import to_light
from lommel.imaging import write_photo

# Of this size, from the calibration that comes with the data set: pixels, metres, pixels.
FOCAL_LENGTH, BASELINE, OFFSET = 994.978, 0.193001, 31.086


def write(folder: Path) -> None:
    left, _, disparity = stereo_motorcycle()
    known = np.isfinite(disparity)
    depth = np.where(known, FOCAL_LENGTH * BASELINE / (np.where(known, disparity, 1.0) + OFFSET), np.nan)
    folder.mkdir(parents=True, exist_ok=True)
    write_photo(folder / "motorcycle.png", to_light("image", left, "srgb", np.float32))
    tifffile.imwrite(folder / "motorcycle-depth.tif", depth.astype(np.float32), photometric="minisblack")
    print(
        f"{folder / 'motorcycle.png'} and motorcycle-depth.tif: {np.nanmin(depth):.2f} to {np.nanmax(depth):.2f} m, "
        f"unknown at {100 * np.mean(~known):.1f} % of the points"
    )


if __name__ == "__main__":
    write(Path(sys.argv[1] if len(sys.argv) > 1 else "out"))
