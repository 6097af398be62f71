"""Thumbnails of the gallery that show one panel of a figure, where the whole figure is too small to be read."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from PIL import Image, ImageOps

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "_generated" / "thumbnails"
SIZE = (480, 300)
# Of each script the number of the figure and that of its axes.
PANELS = {
    "aperture_mask": (1, 1),
    "apertures": (1, 7),
    "beads": (1, 2),
    "camera_field": (1, 0),
    "camera_through_focus": (1, 7),
    "caustic": (1, 1),
    "checkerboard": (1, 0),
    "colour_fringes": (1, 0),
    "deconvolution": (1, 2),
    "depth": (1, 2),
    "depth_from_defocus": (1, 1),
    "depth_precision": (1, 0),
    "diffraction_spikes": (1, 1),
    "dipoles": (1, 8),
    "field_blur": (1, 1),
    "fit_defocus": (1, 0),
    "hubble": (1, 0),
    "large_telescopes": (1, 1),
    "molecules": (1, 1),
    "motorcycle": (1, 1),
    "pixel_averages": (1, 6),
    "polarised": (1, 3),
    "restoration": (1, 3),
    "scanning": (1, 0),
    "seeing": (1, 2),
    "star_field": (2, 0),
    "three_stars": (1, 0),
    "webb": (1, 2),
    "white_light": (1, 3),
    "wrong_stack": (1, 0),
    "zernike_pyramid": (1, 11),
    "zernike_terms": (1, 8),
}


def keep(script: str, number: int, figure: Any) -> None:
    """Write the panel of a figure of a script, filling the thumbnail, if it is the one listed."""
    wanted, panel = PANELS.get(script, (0, 0))
    if number != wanted:
        return
    if figure.stale:
        figure.canvas.draw()
    inside = figure.axes[panel].get_window_extent().transformed(figure.dpi_scale_trans.inverted())
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / f"{script}.png"
    layout = figure.get_layout_engine()
    figure.set_layout_engine("none")  # which moves the panel where the resolution is another
    figure.savefig(path, dpi=max(SIZE[0] / inside.width, SIZE[1] / inside.height), bbox_inches=inside)
    figure.set_layout_engine(layout)
    with Image.open(path) as picture:
        ImageOps.fit(picture.convert("RGB"), SIZE).save(path)


def place(gallery: Path) -> None:
    """Copy the thumbnails over those that Sphinx-Gallery made of whole figures."""
    for path in gallery.rglob("sphx_glr_*_thumb.png"):
        panel = FOLDER / f"{path.name.removeprefix('sphx_glr_').removesuffix('_thumb.png')}.png"
        if panel.exists():
            shutil.copy(panel, path)
