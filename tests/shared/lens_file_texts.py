"""Random lens files as texts, with all ways to write them that the live page reads."""

from __future__ import annotations

import math

import numpy as np

UNITS = (("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9), ("in", 25.4e-3))
ABERRATIONS = ("defocus", "spherical", "W020", "W040", "W060", "W080", "W131", "W222", "W220", "W311")
SIZES = {"waves": 0.1, "radians": 0.6, "nm": 60.0, "um": 0.06}  # of a Zernike coefficient


def lens_file(rng: np.random.Generator) -> str:
    """Return the text of a random lens file."""

    def length(metres: float) -> str:
        unit, size = UNITS[rng.integers(len(UNITS))]
        return f'"{metres / size:.12g}{" " * rng.integers(2)}{unit}"'

    def some(chance: float, *texts: str) -> list[str]:
        """One of these texts, or none."""
        return [texts[rng.integers(len(texts))]] if rng.random() < chance else []

    f, number = 10 ** rng.uniform(-2.5, 0.0), rng.uniform(1.2, 20.0)
    distance = f * 10 ** rng.uniform(0.3, 2)
    at_distance = f"focus_distance = {length(distance)}", f"sensor_distance = {length(1 / (1 / f - 1 / distance))}"
    focus = some(0.75, *at_distance, 'focus_distance = "inf"')
    near = 1 / (distance if focus and focus[0] in at_distance else math.inf)
    near += 2 * 550e-9 * number**2 / f**2 * rng.uniform(-3, 3)  # 1/m: a few waves of defocus
    corrected = (f'model = "aplanatic"\ncorrected_for = "{one}"' for one in ("object", "focus"))
    lens = [
        f"focal_length = {length(f)}",
        f"wavelength = {length(rng.uniform(300e-9, 1500e-9))}",
        *some(1.0, f"f_number = {number!r}", f"aperture_diameter = {length(f / number)}"),
        *focus,
        *some(0.2, 'model = "aplanatic"', *corrected),
        *some(0.4, f"obscuration = {rng.uniform(0, 0.8)!r} # of the radius"),
        *some(0.1, "apodization = 0.5", "apodization = [0.1, 0.2]"),
    ]
    rng.shuffle(lens)
    spread = [k * 120 + rng.uniform(10, 30) for k in range(rng.integers(1, 4))]
    angles = ", ".join(f'"{angle:.6f} deg"' for angle in spread[::-1])
    vanes = f"vanes = {rng.integers(1, 9)}"
    spider = some(1.0, vanes, f'{vanes}\nfirst = "{rng.uniform(-180, 180):.4f} deg"', f"angles = [{angles}]")
    width = f"width = {length(f / number * rng.uniform(0.01, 0.2))}"
    lines = [
        f'name = "lens {rng.integers(1000)} \\u00b5 \\"x\\""\nsource = \'\'\'\ntwo\nlines\'\'\'\n',
        "[lens]", *lens, "",
        *some(0.7, f"[object]\ndistance = {length(1 / near)}\n" if near > 1e-6 else '[object]\ndistance = "inf"\n'),
    ]  # fmt: skip
    if rng.random() < 0.7:
        lines += ["[aberrations]", *(f"{key} = {rng.normal():.6g}" for key in ABERRATIONS if rng.random() < 0.4)]
        lines += some(0.3, f"spherical_rms = {length(rng.uniform(-1, 1) * 0.3e-6)}")
        lines += some(0.5, f"field = [{rng.uniform(-1, 1):.3f},\n  {rng.uniform(-1, 1):.3f}, # y\n]")
        lines += [*some(0.6, *zernike(rng, length(632.8e-9))), ""]
    lines += some(0.4, "\n".join(["[aperture.spider]", width, *spider, ""]))
    lines += some(0.15, "[aperture.ellipse]\na = 0.9\nb = 0.8\n", "[aperture.cat_eye]\nshift = [0.2, 0.1]\n")
    lines += ["[sensor]", f"pixel = {length(rng.uniform(0.5e-6, 12e-6))}", "shape = [65, 1_3]"]
    lines += some(0.3, "integrate = true")
    lines += some(0.2, '\n[report]\nencircled_energy = ["5 um", "1 arcsec"]')
    return "\n".join(lines) + "\n"


def zernike(rng: np.random.Generator, wavelength: str) -> tuple[str, str]:
    """Return the same Zernike terms as tables and in a line."""
    order = ["noll", "ansi", "fringe", "nm"][rng.integers(4)]
    unit = list(SIZES)[rng.integers(len(SIZES))]
    keys = {str(int(rng.integers(1, 37 if order == "fringe" else 60))) for _ in range(rng.integers(1, 8))}
    if order == "nm":
        keys = {f"{n},{2 * int(rng.integers(0, n + 1)) - n}" for n in rng.integers(0, 13, len(keys)).tolist()}
    quoted = [f'"{key}"' if order == "nm" or rng.random() < 0.3 else key for key in sorted(keys)]
    body = [f"{key} = {rng.normal() * SIZES[unit]!r}" for key in quoted]
    head = [f'order = "{order}"', f'unit = "{unit}"', f'normalization = "{["rms", "edge"][rng.integers(2)]}"']
    head += [f"wavelength = {wavelength}"] if rng.random() < 0.4 else []
    tables = "\n".join(["[aberrations.zernike]", *head, "[aberrations.zernike.terms]", *body])
    return tables, f"zernike = {{ {', '.join(head)}, terms = {{ {', '.join(body)} }} }}"
