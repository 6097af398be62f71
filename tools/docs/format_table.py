"""The table of file formats for the page of formats, from the registry."""

from __future__ import annotations

from pathlib import Path

from lommel.io import field_files, opd_files, photos, registry, videos, zernike_tables  # noqa: F401 (formats)

# What a file holds, and what writes and reads it.
CONTENTS = (
    ("psf", "a PSF or a stack", "`psf.save`", "`PSF.load`"),
    ("colours", "[a PSF in colour channels](colour.md)", "`psf.save`", "`ColourPSF.load`"),
    ("field", "[a grid of PSFs over the field](field.md)", "`grid.save`", "`PSFGrid.load`"),
    ("opd", "an OPD map", "`lm.save_opd`", "`lm.load_opd`"),
    ("zernike", "Zernike coefficients", "`wavefront.save`", "`lm.load_zernike`, lens files"),
    ("photo", "a photograph", "`lm.imaging.write_photo`", "`lm.imaging.read_photo`, `lommel blur`"),
    ("depth map", "a depth map", "`lm.imaging.write_depth`", "`lm.imaging.read_depth`"),
    ("video", "video", "`lommel watch`, `lommel sharpen`", ""),
)  # fmt: skip


def rows() -> list[str]:
    """Return the rows of the table."""
    found = []
    for kind, holds, writer, reader in CONTENTS:
        for form in registry.formats(kind):
            files = ", ".join(f"`{suffix}`" for suffix in (*form.suffixes, *filter(None, [form.beside])))
            what = f"{holds}: {form.what}" if form.what else holds
            read = "; ".join(filter(None, [reader if form.read else "", form.readers]))
            found.append(f"| {files} | {what} | {writer if form.write else ''} | {read} |")
    return found


def write(folder: Path) -> None:
    """Write `formats.inc`, which the page of formats includes, into a folder."""
    folder.mkdir(exist_ok=True)
    head = ["| file | holds | written by | read by |", "|---|---|---|---|"]
    (folder / "formats.inc").write_text("\n".join([*head, *rows(), ""]), encoding="utf-8")
