"""Write docs/paper.md and its pictures: ``.venv/bin/python tools/docs/make_paper.py``."""

from __future__ import annotations

import io
import json
import tempfile
import textwrap
from pathlib import Path

from PIL import Image

from lommel.base import atomic
from lommel.base.units import percent
from lommel.paper import ClosedForm
from lommel.paper import figures as paper
from lommel.paper.figures import FIGURES, reproduce

DOCS = Path(__file__).resolve().parents[2] / "docs"

INTRODUCTION = """\
# The paper, regenerated

*Bridging ray tracing and wave optics: a computationally efficient model for defocus and spherical aberration* gives a
closed-form integral solution (CFIS) for the PSF of a defocused lens. This page reproduces its figures and numbers and
compares them with the exact PSF.

**In short.** The phase across the pupil is 2 C_d rho^2 + C_s rho^4, with rho = 1 at the edge: defocus of C_d = 10 is
20 rad, or 3.2 waves, from centre to edge. There the closed form errs by {closed_error} of the peak, with spherical
aberration of C_s = 3 by {spherical_error}. The error comes from its approximation of J0, however exactly erf is
computed.

The paper claims that the closed form is faster than ray tracing and than an FFT of the window's size. Faster than
ray tracing: confirmed for 33 x 33 pixels (512 x 512 take minutes). Faster than that FFT: confirmed for defocus in
512 x 512 pixels if erf is computed by Fresnel integrals ({fresnel_512} times as fast) or looked up in a table
({table_512} times). With the 30 terms of Eq. (14) it takes {series_512} times as long as that FFT. For 33 x 33
pixels it is slower than that FFT in every variant: {table_33} to {series_33} times as long.

An exact series, the default method (error {default_error}), is faster than all of them. Time of one PSF over its
time, and error over the peak, for C_d = 10:

| method | time, 512 x 512 | time, 33 x 33 | error, 512 x 512 | error, 33 x 33 |
|---|---:|---:|---:|---:|
{rows}

Compiled code, one thread, float32, point samples 0.5 lambda F apart (F: f-number), measured on
{machine}.
[More methods, and the spread of the times](benchmarks.md#the-question-of-the-paper).

A successor (Ganino and Guo 2026, *Fast PSF synthesis with defocused and spherical aberration*,
[arXiv:2605.21608](https://arxiv.org/abs/2605.21608)) follows the same approach. It states up to twice the speed of a
Hankel transform and four times that of an FFT.

`lommel paper OUTDIR` writes all figures and their data in about half a minute; this page and its pictures are
written by `.venv/bin/python tools/docs/make_paper.py`.

**Settings.** 512 x 512 pixels, C_d = 10, tangent-line centre TLC = 100, N = 30 terms of Eq. (14), unless a figure
varies them. Lengths on the sensor are `v = pi r / (lambda F)` with the working f-number F; this is `2 pi k R_max` of
the paper. The paper does not give the size of the window. Here v is 145 at the middle of its sides, with which the
first MSE of the paper is reproduced (185 in Fig. 7). MSE is the mean over the image of the squared error, over the
squared peak of the exact PSF.

**Reference.** Errors are differences from the exact PSF: `NijboerZernike(tol=1e-9)`, whose error bound is proven. The
FFT beside it is what the paper most likely compares with: one transform as large as the image, without more padding.
It samples the pupil with a radius of 145 / pi = 46 samples.

**Variants.** "Printed" is Eq. (12) as printed, without the factor sqrt(2/pi) of Eq. (7); the paper's figures and
numbers come from it. "Corrected" has the factor. All other misprints are corrected in both; see
[Errata](#errata).

## Details

### Numbers

"""

NOTES = {
    "1": "The paper shows the formation of a PSF and the cost of ray tracing, O(n^2), and of the FFT, O(n log n), "
    "in one dimension. Here every method makes an image of n x n pixels of the same pitch, on one thread; "
    "times are ratios to one complex FFT of n x n. The FFT of the pupil is more than that one transform: the "
    "pupil has to be sampled, and |U|^2 taken. The CFIS is compiled; it evaluates the error function four times at "
    "a radius. By Fresnel integrals, where values at some radii serve all others to rounding, it costs less than "
    "one FFT from 256 pixels on; by the 30 terms of Eq. (14), whose error is not smooth, at every distinct radius, "
    "it costs more up to 1024. The ratio falls as n grows, as the paper says. So does that of an exact series, "
    "NijboerZernike, which costs less than either.",
    "2": "Eq. (6) with three terms, Eq. (7), the two joined at a = 1 as in Eq. (8), and what Eq. (12) makes of "
    "them with the tangent line (9). As printed, the form is close up to a = 20, where the tangent line, too "
    "low there, makes up for the missing sqrt(2/pi). Corrected, it is close where the tangent line is, near a "
    "= 100.",
    "3": "As printed, error is largest near the axis, as in the paper, and the PSF is too bright; corrected, it is "
    "too dark at the rings, which lie where the tangent line is too low.",
    "4": "As the paper says, the outer rings fade with N: Eq. (14) holds for |Im z| < N/2 - 3 or so, hence up to a "
    "radius that grows with N.",
    "5": "Red is too bright, blue too dark; the scale is linear up to 0.01 and logarithmic beyond. At N = 40 no "
    "rings are left in this window, and what remains is the error of Eq. (8) and (9).",
    "6": "As printed, error grows with defocus from C_d = 10 on, as the paper says. Corrected, it hardly does, for "
    "a wider PSF has more of its light where the tangent line is good.",
    "7": "C_d = 22 and a window of 185, where the two errors of the table come closest. As printed, error falls as "
    "the centre grows, up to about 200, and the inner rings get worse, as the paper says; corrected, it "
    "rises.",
    "eq17": "Five pieces of exp(i C_s rho^4), without a constant as Eq. (17) is printed, and with one on optimal "
    "segments, on which errors are equal. MSE is the mean of the squared error over the radius.",
}


IMPLEMENTATION = """\
### Implementation

| equation | contents | file under `src/lommel` |
|---|---|---|
| 1-3 | lens, defocus coefficient C_d, finite object distances | `optics/lens.py` |
| 2, 15, 16 | phase across the pupil, C_d and C_s | `optics/wavefront/wavefront.py` |
| 4 | Fourier transform of the pupil, by FFT | `methods/paper/fraunhofer.py` |
| 5 | Hankel transform, by quadrature and by series | `methods/hankel.py`, `methods/nijboer_zernike.py` |
| section 1, Fig. 1 | Huygens' superposition ("ray tracing") | `methods/paper/huygens.py` |
| 6, 7 | the two approximations of J0 | `special/bessel.py` |
| 8, 12 | their piecewise combination, the six integrals | `methods/paper/closed_form.py` |
| 9-11 | tangent line to 1/sqrt(a) | `special/bessel.py` (`tangent_line`) |
| 13, 21-23 | integrals 4 to 6, by the moments of a chirp | `special/chirp.hpp` of the compiled core |
| 14 | error function, three ways | `special/erf.py`, `special/fresnel.hpp` of the compiled core |
| 17 | piecewise quadratic phases | `special/piecewise.py` |
| 18-20 | integrals 1 to 3 | `paper/closed_form.hpp` of the compiled core |
| section 5 | "further optimizing parameters" | `methods/paper/closed_form.py` |
"""


def small(picture: bytes, figure: str) -> bytes:
    """Return a PNG of fewer bytes; few colours suffice where there are no curves."""
    buffer = io.BytesIO()
    with Image.open(io.BytesIO(picture)) as image:
        plain = image.convert("RGB")
        if figure in ("4", "5", "6", "7"):
            plain = plain.quantize(256, dither=Image.Dither.NONE)
        plain.save(buffer, format="png", optimize=True)
    return buffer.getvalue()


def measured() -> dict[str, str]:
    """Return the numbers of "In short" from the table of the paper's question in `benchmarks/second.json`."""
    results = json.loads((DOCS.parent / "benchmarks" / "second.json").read_text(encoding="utf-8"))
    (table,) = (each for each in results["tables"] if each["key"] == "paper")
    rows = {(row["image"], row["way"]): row for row in table["rows"]}
    large, small = "512², C_d = 10, C_s = 0", "33², C_d = 10, C_s = 0"
    forms = [f"closed form, {erf}" for erf in ("Fresnel integrals", "table of 4096", "Abramowitz 30")]
    fresnel, lookup, series = forms

    def times(ratio: float) -> str:
        return f"{ratio:.0f}" if ratio >= 100.0 else f"{ratio:.1f}"

    def over_lommel(image: str, way: str) -> str:
        return times(rows[image, way]["over lommel"]["median"]) if (image, way) in rows else "-"

    def over_fft(image: str, way: str) -> float:
        return 1.0 / float(rows[image, way]["FFT over it"]["median"])

    def error(image: str, way: str) -> str:
        share = rows[image, way]["true error"] if (image, way) in rows else None
        return percent(share, 1 if share is not None and share < 0.1 else 0)

    if not over_fft(large, fresnel) < over_fft(large, lookup) < 1.0 < over_fft(large, series):
        raise ValueError("the page says that the closed form is faster than an FFT of 512² but for the series")
    slower = sorted(over_fft(small, form) for form in forms)
    if slower[0] < 1.0 or [slower[0], slower[-1]] != [over_fft(small, lookup), over_fft(small, series)]:
        raise ValueError("the page says that the closed form is slower than an FFT of 33²")
    huygens = "Huygens, distinct radii"
    if max(over_fft(small, form) for form in forms) > over_fft(small, huygens):
        raise ValueError("the page says that the closed form is faster than ray tracing")
    ways = [
        ("closed form, erf by Fresnel integrals", fresnel, fresnel),
        ("closed form, 30 terms of Eq. (14)", series, series),
        ("FFT of the window's size", "FFT of 512², SciPy", "FFT of 33², SciPy"),
        ("ray tracing (Huygens' superposition)", huygens, huygens),
    ]
    lines = []
    for name, wide, narrow in ways:
        cells = (over_lommel(large, wide), over_lommel(small, narrow), error(large, wide), error(small, narrow))
        lines.append("| " + " | ".join((name, *cells)) + " |")
    return {
        "rows": "\n".join(lines),
        "machine": results["description"],
        "closed_error": error(large, fresnel),
        "spherical_error": error("512², C_d = 10, C_s = 3", fresnel),
        "default_error": f"{max(rows[image, 'lommel']['true error'] for image in (large, small)):.0e}",
        "fresnel_512": times(1.0 / over_fft(large, fresnel)),
        "table_512": times(1.0 / over_fft(large, lookup)),
        "series_512": times(over_fft(large, series)),
        "table_33": times(slower[0]),
        "series_33": times(slower[-1]),
    }


def errata() -> str:
    """Return the table of misprints from the documentation of `ClosedForm`, as Markdown."""
    rows: list[list[str]] = []
    lines = (ClosedForm.__doc__ or "").splitlines()
    rules = [k for k, line in enumerate(lines) if line.strip().startswith("===")]
    starts = [k for k, c in enumerate(lines[rules[0]]) if c == "=" and (k == 0 or lines[rules[0]][k - 1] == " ")]
    for k in range(rules[0] + 1, rules[-1]):
        if k in rules:
            rows.append(["---"] * len(starts))
            continue
        cells = [lines[k][a:b].strip() for a, b in zip(starts, [*starts[1:], None], strict=True)]
        if cells[0]:
            rows.append(cells)
        else:
            rows[-1] = [f"{old} {more}".strip() for old, more in zip(rows[-1], cells, strict=True)]
    return "\n".join("| " + " | ".join(row) + " |" for row in rows) + "\n"


def main() -> None:
    """Compute everything and write the page."""
    (DOCS / "paper").mkdir(exist_ok=True)
    parts = [INTRODUCTION.format(**measured())]
    with tempfile.TemporaryDirectory() as folder:
        made = reproduce(Path(folder), on_start=print, dpi=85)
        for figure in FIGURES:
            picture = (Path(folder) / f"figure-{figure}.png").read_bytes()
            atomic.write(DOCS / "paper" / f"figure-{figure}.png", small(picture, figure))
    parts.append(paper.markdown(made["table"]))
    for figure, plan in FIGURES.items():
        name = "Eq. 17" if figure == "eq17" else f"Fig. {figure}"
        shown = f"![{plan.caption}](paper/figure-{figure}.png)"
        parts.append(f"\n### {name}. {plan.caption}\n\n{shown}\n\n{textwrap.fill(NOTES[figure], 118)}\n")
    parts.append(
        "\n### Errata\n\nFound by integrating what stands under each integral of the appendix by quadrature; "
        "equations\n(18) to (20) are correct as printed.\n\n" + errata() + "\n" + IMPLEMENTATION
    )
    atomic.write(DOCS / "paper.md", "".join(parts).encode())


if __name__ == "__main__":
    main()
