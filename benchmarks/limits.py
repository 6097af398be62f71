"""The table of targets, and the second chance of a row on a noisy machine."""

from __future__ import annotations

import math
from functools import partial
from itertools import takewhile

from benchmarks import averages, axes, chordal, depth, localization, nonradial, starting
from benchmarks import targets as t
from benchmarks.baselines import faster_ffts, fft
from benchmarks.report import Table
from benchmarks.settings import Settings
from benchmarks.targets import Target
from benchmarks.timing import race

_SAME = "np.copyto of the same array"

_PLAIN = "NumPy: quadrature, cached J0, "

# What must be reached holds for processors of 2017 (AVX2 in halves of 128 bits) and of 2024 alike: a row that
# another library is the measure of leaves room for what an FFT, a copy or a product gains more or less there.
TARGETS = [
    Target(
        "512², float32, tol 1e-6, abs(C_d), abs(C_s) ≤ 50",
        "scipy.fft of 1024² complex128",
        *(40, 120, "x", True),
        t.against_fft,
    ),
    Target("the same", "np.copyto of a float64 512²", 7, 2.5, "", False, t.against_copy),
    Target("the same", _PLAIN + "CubicSpline onto the grid", 20, 50, "x", True, t.against_spline),
    Target("the same", _PLAIN + "the distinct radii only, gathered", None, None, "x", True, t.against_folded),
    Target("4096², float32, 2 threads, into `out`", _SAME, 3, 1.5, "", False, partial(t.large, out=True)),
    Target("the same, its output allocated", _SAME, None, None, "", False, partial(t.large, out=False)),
    Target(
        "4096 of 33², float64, abs(C_d) ≤ 20, into `out`",
        "np.copyto of the stack",
        *(3, 2, "", False),
        partial(t.stack_copy, out=True),
    ),
    Target(
        "the same, its output allocated",
        "np.copyto of the stack",
        *(None, None, "", False),
        partial(t.stack_copy, out=False),
    ),
    Target(
        "1000 of 33², float64, abs(C_d) ≤ 10, 2 threads",
        "NumPy: GEMM, 30 nodes, 135 distinct radii, gathered",
        *(1, 4, "x", True),
        t.stack_gemm,
    ),
    Target(
        "64 planes of 256², float32, through focus",
        _PLAIN + "CubicSpline onto the grid",
        *(5, 15, "x", True),
        partial(t.focus, ways=("pixels",)),
    ),
    Target(
        "the same",
        _PLAIN + "the distinct radii only, gathered",
        *(None, None, "x", True),
        partial(t.focus, ways=("spline", "direct")),
    ),
    *(
        Target(
            f"512², float32, pixels of {pixel:g} λN averaged, into `out`",
            "the same window sampled",
            *(must, aim, "", False),
            partial(averages.over_samples, pixel=pixel),
        )
        for pixel, must, aim in ((0.25, 5, 2.5), (0.5, 10, 5), (1.0, 30, 18))
    ),
    *(
        Target(
            f"512², float32, coma, astigmatism, trefoil and defocus of 10 rad each, pixels of {pixel:g} λN averaged",
            "the same window sampled",
            *(must, 2, "", False),
            partial(averages.general_over_samples, pixel=pixel),
        )
        # Pixels of 1 λN take four samples each.
        for pixel, must in ((0.25, 4), (0.5, 4), (1.0, 7))
    ),
    Target(
        "1000 of 33², float32, pixels of 3.45 µm at f/1.8 averaged, into `out`",
        "the same stack sampled",
        *(8, 3, "", False),
        averages.stack_over_samples,
    ),
    *(
        Target(
            f"1000 of 25², float32, 0.5 λN, {'averaged' if integrate else 'sampled'}, each around an axis of its own",
            "the same stack around the middle pixel",
            *(18, 5, "", False),
            partial(axes.over_centred, pixel=0.5, integrate=integrate),
        )
        for integrate in (False, True)
    ),
    *(
        Target(
            f"1000 of 33², 15 Zernike terms of 1 rad rms {'each' if each else 'together'}, float32, tol 1e-4"
            + (", 2 threads" if threads == 2 else ""),
            "scipy.fft of 1000 × 128² complex128, one thread",
            *(5, 20, "x", True),
            partial(chordal.against_fft, each=each, threads=threads),
            chordal.TOL,
        )
        for each in (False, True)
        for threads in (1, 2)
    ),
    *(
        Target(
            f"the same of 1 rad rms each, tol {tol:g}, with 15 derivatives by coefficients, over 16",
            "the images alone",
            *(1.5, 1.1, "", False),
            partial(chordal.derivatives_over_images, tol=tol),
            tol,
        )
        for tol in (chordal.TOL, 1e-6)
    ),
    *(
        Target(
            f"the gradient of a weighted sum of these by {terms} coefficients, tol 1e-6",
            "the images alone, float64",
            *(4, 2.5, "", False),
            partial(chordal.gradient_over_images, terms=terms),
        )
        for terms in (15, 60)
    ),
    *(
        Target(
            f"512², float32, tol 1e-6, pixels of {pixel:g} λN, coma, astigmatism, trefoil and defocus of up to "
            "10 rad each, into `out`",
            "scipy.fft of 1024² complex128, one thread",
            *(3, aim, "x", True),
            partial(nonradial.against_fft, pixels=(pixel,), threads=1),
        )
        for pixel, aim in ((0.25, 10), (0.5, 8), (1.0, 8))
    ),
    *(
        Target(
            f"the same, pixels of {pixel:g} λN, 10 rad",
            "ducc0's non-uniform FFT in single precision, one thread",
            *(must, aim, "x", True),
            partial(nonradial.against_ducc0, pixel=pixel),
        )
        for pixel, must, aim in ((0.25, 1, 3), (0.5, 2, 4), (1.0, 4, 8))
    ),
    Target(
        "the same, all pixels, 2 threads",
        "scipy.fft of 1024² complex128, one thread",
        *(1.5, 5, "x", True),
        partial(nonradial.against_fft, pixels=nonradial.PIXELS, threads=2),
    ),
    Target(
        "the same of 30 rad each, pixels of 0.5 λN",
        "scipy.fft of 1024² complex128, one thread",
        *(None, None, "x", True),
        partial(nonradial.against_fft, pixels=(0.5,), threads=1, reaches=(30.0,)),
    ),
    *(
        Target(
            f"the same 512², by `{name}`{how}",
            "scipy.fft of 1024² complex128, one thread",
            *(None, None, "x", True),
            partial(nonradial.method_against_fft, name=name),
            math.inf,
        )
        for name, how in (
            ("NonuniformFFT", ""),
            ("MatrixFourier", " of 512 samples"),
            ("Fraunhofer", ", an FFT of 1024²"),
        )
    ),
    Target(
        "500 × 741 RGB blurred by depth, windows up to 33², tol 1e-4, 2 threads",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(2, 1.5, "", False),
        partial(depth.against_fixed, bank=False),
        depth.TOL,
    ),
    Target(
        "the same, and making its windows",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(None, None, "", False),
        partial(depth.against_fixed, bank=True),
        depth.TOL,
    ),
    Target(
        "the same, its windows made",
        "the PSF of every point by an FFT of 64², added",
        *(200, 400, "x", True),
        depth.against_points,
        depth.TOL,
    ),
    Target(
        "the same, its windows made, without truncating the PSF (energy=1)",
        "energy=0.98",
        *(2, 1.3, "", False),
        depth.whole,
        1e-5,
    ),
    Target(
        "the same through focus, a frame of 30",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(4, 2, "", False),
        depth.focus_pull,
    ),
    Target(
        "a photograph with occlusion at a new depth map, the worst of five scenes",
        "depth_of_field without occlusion",
        *(4, 2.5, "", False),
        depth.occluded_once,
    ),
    Target(
        "occlusion, forward again at one depth map, the worst of five scenes",
        "scipy.signal.oaconvolve with one fixed 33²",
        *(8, 4, "", False),
        depth.occluded,
    ),
    Target(
        "1000 images of a molecule, 15², with slopes by row, column and z, by a table of tol 1e-4",
        "np.abs of as many float32",
        *(60, 30, "", False),
        localization.image_over_abs,
        localization.TOL,
    ),
    *(
        Target(
            "1000 molecules of 1000 photons, 15², fitted with their starts",
            f"Picasso's cubic splines from {starts} start{'s' if starts > 1 else ''}, one thread",
            *(must, aim, "x", True),
            partial(localization.fit_over_splines, starts=starts),
        )
        for starts, must, aim in ((1, 2.5, 4), (5, 20, 30))
    ),
    *(
        Target(
            f"the gradient of 15² averages of an aberrated objective by {terms} Zernike terms, tol 1e-4",
            "the image",
            *(must, aim, "", False),
            partial(localization.gradient_over_image, terms=terms),
            localization.TOL,
        )
        for terms, must, aim in ((21, 3, 1.5), (231, 4, 2))
    ),
    Target("one 33² by a plan", "np.abs of a complex 33²", 4, 2.5, "", False, partial(t.plan, pupils=False)),
    Target(
        "the same, and making its pupil",
        "np.abs of a complex 33²",
        *(None, None, "", False),
        partial(t.plan, pupils=True),
    ),
    Target(
        "one 33² of coma, astigmatism, trefoil and defocus of up to 1 rad each by a plan",
        "np.abs of a complex 33²",
        *(40, 18, "", False),
        nonradial.by_plan,
    ),
    Target("the pupil of a lens", "np.abs of a complex 33²", 3.5, 1.5, "", False, t.pupil_of_lens),
    Target("import lommel", "import numpy", 1.25, 1.15, "", False, starting.importing),
    Target("the first 512² of a process", "np.copyto to a new array there", None, None, "", False, starting.first),
    Target("512² between others that empty the caches", "np.copyto there", 3, 2, "", False, starting.between),
    Target("memory above the output, 512²", "nothing", 20, 8, " MiB", False, t.peak_memory),
]


def run(settings: Settings) -> Table:
    """Measure and judge every row; one that fails gets a second chance, and both results are noted."""
    table = Table(
        "targets",
        "Overview",
        "Through the public Python call, warm, one thread unless the row says otherwise; the least favourable "
        "case of each row, with the largest true error of all its cases. "
        f"{_unit(settings)}",
        {
            "work": "text",
            "against": "text",
            "must": "text",
            "aim": "text",
            "measured": "spread",
            "unit": "text",
            "verdict": "text",
            "true error": "error",
        },
    )
    for number, target in enumerate(TARGETS, 1):
        settings.tick(f"{target.work} against {target.against}")
        try:
            found = target.measure(settings)
        except NotImplementedError as reason:
            table.add(*_words(target), None, target.counted_in, "skipped", None)
            table.notes.append(f"row {number}: {reason}")
            continue
        again = ""
        if target.verdict(found.value.median) == "MISSED":
            settings.tick(f"again: {target.work} against {target.against}")
            again = f"; second try, the first came to {found.value.median:.3g}"
            found = target.measure(settings)
        verdict = target.verdict(found.value.median)
        if found.error is not None and found.error > target.tol:
            verdict = "MISSED"
            again += f"; the error exceeds {target.tol:g}"
        table.add(*_words(target), found.value, target.counted_in, verdict, found.error)
        table.notes.append(f"row {number}: {found.note}{again}")
    return table


def _unit(settings: Settings) -> str:
    """Say what the FFT that rows are measured against is worth beside the fastest one at hand."""
    known, others = fft(), faster_ffts()
    said = "SciPy's FFT is the unit because everybody has it; it is not the fastest"
    if not others:
        return f"{said}: ducc0's, not installed for this run, takes about half its time."
    result = race([known, *others], settings.rounds)
    ratios = " and ".join(f"{result.ratio(o.name, known.name).median:.2f} ({o.name})" for o in others)
    return f"{said}: in this run ducc0's took {ratios} of its time, and ratios to it are that much smaller."


def _words(target: Target) -> tuple[str | None, ...]:
    return target.work, target.against, target.limit(target.must), target.limit(target.aim)


def missed(table: Table) -> list[str]:
    """Return the rows that did not reach what they must, by what they say before that."""
    named = list(takewhile(lambda name: name != "must", table.columns))
    return [" against ".join(row[name] for name in named) for row in table.rows if row.get("verdict") == "MISSED"]
