"""The largest jumps of cost where one number of a random question changes by a fifth.

    python -m benchmarks.jumps [--first 0] [--count 300] [--camera]

Questions are those of benchmarks/choice.py, or, with ``--camera``, averages over pixels of 0.7 to 8 lambda N. Of each
one number is made a fifth larger: the side of the window, the pixel, the phase, the tolerance or the number of
pupils. Prints quantiles of the ratio of processor times, over what the pixels and pupils themselves are more, and the
largest.
"""

from __future__ import annotations

import argparse
import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.choice import prepared, seconds
from lommel.optics.grid import Grid

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "shared"))

from disk_questions import DiskQuestion, camera_question, disk_question

_MORE = 1.2


def changed(question: DiskQuestion, what: str) -> tuple[DiskQuestion, float] | None:
    """Return the question with one number larger, and by how much work grows at least; None where it has none."""
    pupil, grid, tol = question
    if what == "side":
        side = math.ceil(_MORE * grid.height)
        row, column = (part + (side - grid.height) // 2 for part in grid.center)
        more = Grid(side, grid.side, center=(row, column), integrate=grid.integrate)
        return DiskQuestion(pupil, more, tol), (side / grid.height) ** 2
    if what == "pixel":
        more = Grid(grid.shape, _MORE * grid.side, center=grid.center, integrate=grid.integrate)
        return DiskQuestion(pupil, more, tol), 1.0
    if what == "phase":
        stronger = replace(pupil, wavefront=_MORE * pupil.wavefront)
        return DiskQuestion(stronger, grid, tol), 1.0
    if what == "tol":
        return DiskQuestion(pupil, grid, tol / _MORE), 1.0
    count = math.prod(pupil.shape)
    if pupil.shape == () or count < 2:
        return None
    which = np.arange(math.ceil(_MORE * count)) % count
    return DiskQuestion(pupil[which], grid[which] if grid.stack else grid, tol), which.size / count


def main() -> None:
    """Ask, and print."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--camera", action="store_true")
    options = parser.parse_args()
    questions, found = camera_question if options.camera else disk_question, []
    for index in range(options.first, options.first + options.count):
        question = questions(index)
        what = ("side", "pixel", "phase", "tol", "pupils")[index % 5]
        other = changed(question, what)
        if other is None:
            continue
        before, after = seconds([prepared(question, None), prepared(other[0], None)])
        if max(before, after) < math.inf:
            ratio = after / before / other[1]
            found.append((max(ratio, 1.0 / (ratio * other[1])), what, before, after, index, question))
    ratios = np.array([each[0] for each in found])
    print(f"{len(found)} questions; jumps of at most 2.5: {np.mean(ratios <= 2.5):.1%}")
    print("quantiles 50, 90, 95, 99 %, largest:", *np.round(np.quantile(ratios, [0.5, 0.9, 0.95, 0.99, 1.0]), 2))
    for ratio, what, before, after, index, question in sorted(found, key=lambda each: -each[0])[:12]:
        print(f"{ratio:6.2f}  {index}, {what}: {1e3 * before:.3g} ms, then {1e3 * after:.3g} ms: {question}")


if __name__ == "__main__":
    main()
