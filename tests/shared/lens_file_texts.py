"""Random lens files as texts, with all ways to write them that the live page reads."""

from __future__ import annotations

import math

import numpy as np

UNITS = (("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9), ("in", 25.4e-3))


def length(rng: np.random.Generator, metres: float) -> str:
    """Return a text of a length in a random unit."""
    unit, size = UNITS[rng.integers(len(UNITS))]
    return f'"{metres / size:.12g}{" " * rng.integers(2)}{unit}"'


def lens_file(rng: np.random.Generator) -> str:
    """Return the text of a random lens file."""
    f = 10 ** rng.uniform(-2.5, 0.0)
    number = rng.uniform(1.2, 20.0)
    aplanatic = rng.random() < 0.2
    lens = [f"focal_length = {length(rng, f)}", f"wavelength = {length(rng, rng.uniform(300e-9, 1500e-9))}"]
    lens.append(f"f_number = {number!r}" if rng.random() < 0.6 else f"aperture_diameter = {length(rng, f / number)}")
    lines = [f'name = "lens {rng.integers(1000)} \\u00b5 \\"x\\""', "source = '''", "two", "lines'''", ""]
    kind = rng.integers(4)
    waves = 2 * 550e-9 * number**2 / f**2 * rng.uniform(-3, 3)  # 1/m: a few waves of defocus
    s = math.inf
    if kind == 1:
        s = f * 10 ** rng.uniform(0.3, 3)
        lens.append(f"focus_distance = {length(rng, s)}")
    elif kind == 2:
        s = f * 10 ** rng.uniform(0.3, 2)
        lens.append(f"sensor_distance = {length(rng, 1 / (1 / f - 1 / s))}")
    elif kind == 3:
        lens.append('focus_distance = "inf"')
    if aplanatic:
        lens.append('model = "aplanatic"')
        if rng.random() < 0.5:
            lens.append(f'corrected_for = "{["object", "focus"][rng.integers(2)]}"')
    if rng.random() < 0.4:
        lens.append(f"obscuration = {rng.uniform(0, 0.8)!r} # of the radius")
    if rng.random() < 0.1:
        lens.append(["apodization = 0.5", "apodization = [0.1, 0.2]"][rng.integers(2)])
    rng.shuffle(lens)
    lines += ["[lens]", *lens, ""]
    if rng.random() < 0.7:
        near = 1 / s + waves
        lines += ["[object]", f"distance = {length(rng, 1 / near)}" if near > 1e-6 else 'distance = "inf"', ""]
    if rng.random() < 0.7:
        keys = ["defocus", "spherical", "W020", "W040", "W060", "W080", "W131", "W222", "W220", "W311"]
        lines.append("[aberrations]")
        lines += [f"{key} = {rng.normal():.6g}" for key in keys if rng.random() < 0.4]
        if rng.random() < 0.3:
            lines.append(f"spherical_rms = {length(rng, rng.uniform(-1, 1) * 0.3e-6)}")
        if rng.random() < 0.5:
            lines.append(f"field = [{rng.uniform(-1, 1):.3f},\n  {rng.uniform(-1, 1):.3f}, # y\n]")
        if rng.random() < 0.6:
            order = ["noll", "ansi", "fringe", "nm"][rng.integers(4)]
            unit = ["waves", "radians", "nm", "um"][rng.integers(4)]
            size = {"waves": 0.1, "radians": 0.6, "nm": 60.0, "um": 0.06}[unit]
            last = 37 if order == "fringe" else 60
            terms = {}
            for _ in range(rng.integers(1, 8)):
                if order == "nm":
                    n = int(rng.integers(0, 13))
                    key = f"{n},{int(rng.integers(0, n + 1)) * 2 - n}"
                else:
                    key = str(int(rng.integers(1, last)))
                terms[key] = rng.normal() * size
            quoted = [f'"{k}"' if order == "nm" or rng.random() < 0.3 else k for k in terms]
            body = [f"{k} = {v!r}" for k, v in zip(quoted, terms.values(), strict=True)]
            head = [f'order = "{order}"', f'unit = "{unit}"', f'normalization = "{["rms", "edge"][rng.integers(2)]}"']
            if rng.random() < 0.4:
                head.append(f"wavelength = {length(rng, 632.8e-9)}")
            if rng.random() < 0.5:
                lines += ["[aberrations.zernike]", *head, "[aberrations.zernike.terms]", *body]
            else:
                lines.append(f"zernike = {{ {', '.join(head)}, terms = {{ {', '.join(body)} }} }}")
        lines.append("")
    if rng.random() < 0.4:
        lines.append("[aperture.spider]")
        lines.append(f"width = {length(rng, f / number * rng.uniform(0.01, 0.2))}")
        if rng.random() < 0.6:
            lines.append(f"vanes = {rng.integers(1, 9)}")
            if rng.random() < 0.5:
                lines.append(f'first = "{rng.uniform(-180, 180):.4f} deg"')
        else:
            count = int(rng.integers(1, 5))
            spread = [k * 360 / count + 20 + (rng.random() < 0.3) * k for k in range(count)]
            rng.shuffle(spread)
            lines.append(f"angles = [{', '.join(f'{chr(34)}{a:.6f} deg{chr(34)}' for a in spread)}]")
        lines.append("")
    if rng.random() < 0.15:
        edges = ["[aperture.ellipse]\na = 0.9\nb = 0.8", "[aperture.cat_eye]\nshift = [0.2, 0.1]"]
        lines += [edges[rng.integers(2)], ""]
    lines += ["[sensor]", f"pixel = {length(rng, rng.uniform(0.5e-6, 12e-6))}", "shape = [65, 1_3]"]
    if rng.random() < 0.3:
        lines.append("integrate = true")
    if rng.random() < 0.2:
        lines += ["", "[report]", 'encircled_energy = ["5 um", "1 arcsec"]']
    return "\n".join(lines) + "\n"
