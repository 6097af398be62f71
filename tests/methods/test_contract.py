"""The contract of the default method: the true error never exceeds the bound, nor the bound the tolerance."""

from __future__ import annotations

import signal
import threading

import numpy as np
import pytest
from scipy.special import j0

import lommel as lm
from lommel import _core

CASES = 1000


@pytest.fixture
def every_instruction_set():
    yield ("avx512", "avx2", "portable")
    _core.limit_instructions("avx512")


def random_case(rng: np.random.Generator) -> tuple[lm.Pupil, tuple[int, int], float, float]:
    higher = (rng.uniform(-40, 40),) if rng.random() < 0.15 else ()
    wavefront = lm.Wavefront(rng.uniform(-250, 250), rng.uniform(-250, 250), higher)
    if rng.random() < 0.25:
        wavefront = lm.Wavefront(rng.uniform(-250, 250) * (rng.random() < 0.8))
    obscuration = 0.0 if rng.random() < 0.5 else rng.uniform(0.0, 0.9)
    shape = (int(rng.integers(1, 40)), int(rng.integers(1, 40)))
    if rng.random() < 0.03:
        shape = (int(rng.integers(150, 200)), int(rng.integers(150, 200)))
    pixel = float(np.exp(rng.uniform(np.log(0.05), np.log(2.0))))
    return lm.Pupil(wavefront, obscuration=obscuration), shape, pixel, float(10.0 ** rng.uniform(-8, -3))


def true_error(answer: lm.PSF, reference: lm.PSF, pupil: lm.Pupil) -> float:
    """Return the largest error over the peak of the PSF, wherever that lies."""
    blur = float(pupil.v(pupil.geometric_radius()).max())
    scan = np.abs(lm.Hankel().field(pupil, np.linspace(0.0, blur + 4.0, 400))) ** 2
    peak = max(float(reference.values.max()), float(scan.max() * reference.scale))
    return float(np.abs(answer.values - reference.values).max()) / peak


@pytest.mark.parametrize("seed", range(10))
def test_in_a_thousand_random_cases_the_error_stays_below_the_bound_and_the_bound_below_the_tolerance(seed):
    rng = np.random.default_rng(seed)
    for _ in range(CASES // 10):
        pupil, shape, pixel, tol = random_case(rng)
        answer = lm.psf(pupil, shape, pixel, method=lm.NijboerZernike(tol), dtype=np.float64, threads=1)
        reference = lm.psf(pupil, shape, pixel, method=lm.Hankel())
        # The rounding of the quadrature is far below the smallest tolerance here.
        assert true_error(answer, reference, pupil) <= answer.error_bound, (pupil, shape, pixel, tol)
        assert answer.error_bound <= tol + 2.0**-53, (pupil, shape, pixel, tol)


def test_stacks_of_small_windows_keep_the_contract():
    rng = np.random.default_rng(7)
    for side, pixel in ((33, 0.5), (32, 1.7), (9, 0.1)):
        pupil = lm.Pupil(lm.Wavefront(rng.uniform(-200, 200, 50), rng.uniform(-200, 200, 50)))
        answer = lm.psf(pupil, side, pixel, method=lm.NijboerZernike(1e-7), dtype=np.float64)
        for i in range(0, 50, 7):
            reference = lm.psf(pupil[i], side, pixel, method=lm.Hankel())
            assert true_error(answer[i], reference, pupil[i]) <= answer.error_bound <= 1e-7 + 2.0**-53


def test_a_stack_equals_its_members_one_by_one_to_within_the_bounds():
    defocus = np.linspace(-20, 20, 41)
    stack = lm.psf(lm.Pupil(lm.Wavefront(defocus)), 33, 0.5, normalize="peak", dtype=np.float64)
    for i, c in enumerate(defocus):
        single = lm.psf(lm.Pupil(lm.Wavefront(c)), 33, 0.5, normalize="peak", dtype=np.float64)
        # Normalising by the peak adds the error of the peak itself.
        assert np.abs(stack.values[i] - single.values).max() <= 2 * (stack.error_bound + single.error_bound)


def test_every_instruction_set_gives_the_same_answer_within_the_bound(every_instruction_set):
    pupil, stack = lm.Pupil(lm.Wavefront(40.0, -25.0), obscuration=0.2), lm.Pupil(lm.Wavefront(np.full(6, 4.0)))
    reference = lm.psf(pupil, 150, 0.5, method=lm.Hankel())
    small = lm.psf(stack[5], 21, 0.5, method=lm.Hankel())
    for level in every_instruction_set:
        _core.limit_instructions(level)
        answer = lm.psf(pupil, 150, 0.5, method=lm.NijboerZernike(1e-9))
        assert lm.peak_error(answer, reference) <= answer.error_bound <= 1e-9 + 2.0**-53
        batch = lm.psf(stack, 21, 0.5, dtype=np.float64)
        assert lm.peak_error(batch[5], small) <= batch.error_bound


def test_many_threads_at_once_give_what_one_gives():
    pupils = [lm.Pupil(lm.Wavefront(float(c), 3.0), obscuration=o) for c in (1, 17, 60) for o in (0.0, 0.4)]
    stack = lm.Pupil(lm.Wavefront(np.linspace(-9, 9, 40)))
    shapes = (31, 64, 200)
    expected = {(i, s): lm.psf(p, s, 0.6, threads=1).values for i, p in enumerate(pupils) for s in shapes}
    expected_stack = lm.psf(stack, 25, 0.3, threads=1).values
    wrong: list[str] = []

    def work(number: int) -> None:
        for turn in range(6):
            for (i, s), values in expected.items():
                found = lm.psf(pupils[i], s, 0.6, threads=1 + (number + turn) % 3).values
                if not np.array_equal(found, values):
                    wrong.append(f"pupil {i}, shape {s}")
            if not np.array_equal(lm.psf(stack, 25, 0.3, threads=2).values, expected_stack):
                wrong.append("stack")

    workers = [threading.Thread(target=work, args=(n,)) for n in range(8)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert not wrong


@pytest.mark.parametrize("obscuration", [0.0, 0.33])
@pytest.mark.parametrize(("defocus", "spherical"), [(0.0, 0.0), (3.0, 2.0), (-40.0, 30.0), (150.0, -100.0)])
def test_derivatives_are_the_limits_of_differences(defocus, spherical, obscuration):
    method, h = lm.NijboerZernike(1e-9), 1e-3

    def at(dc: float, ds: float, **more: object) -> lm.PSF:
        pupil = lm.Pupil(lm.Wavefront(defocus + dc, spherical + ds), obscuration=obscuration)
        return lm.psf(pupil, 65, 0.6, method=method, normalize="strehl", **more)

    answer = at(0, 0, derivatives=("defocus", "spherical"))
    for name, (dc, ds) in {"defocus": (h, 0.0), "spherical": (0.0, h)}.items():
        # Fourth-order central differences.
        one = at(dc, ds).values - at(-dc, -ds).values
        two = at(2 * dc, 2 * ds).values - at(-2 * dc, -2 * ds).values
        difference = (8 * one - two) / (12 * h)
        assert np.abs(answer.derivatives[name] - difference).max() < 2e-6 * answer.values.max()
        assert answer.derivative_bounds[name] < 1e-6


def test_the_edge_identity_holds_between_the_derivatives():
    # 2 U + v U_v + 2 C_d U_Cd + 4 C_s U_Cs = 2 exp(i (2 C_d + C_s)) J0(v); times 2 conj(U), the real part is
    # 4 I + v I_v + 2 C_d I_Cd + 4 C_s I_Cs = 4 Re(conj(U) exp(i (2 C_d + C_s))) J0(v).
    c, s = 6.0, -4.0
    pupil, method = lm.Pupil(lm.Wavefront(c, s)), lm.NijboerZernike(1e-10)
    answer = lm.psf(pupil, (1, 129), 0.25, method=method, normalize="strehl", derivatives=("defocus", "spherical"))
    v = np.pi * 0.25 * np.arange(65)
    row = slice(64, None)
    intensity, by_defocus, by_spherical = (
        a[0, row] for a in (answer.values, answer.derivatives["defocus"], answer.derivatives["spherical"])
    )
    h = 1e-3
    around = [np.abs(lm.Hankel().field(pupil, np.abs(v + k * h))) ** 2 for k in (-2, -1, 1, 2)]
    slope = (around[0] - 8 * around[1] + 8 * around[2] - around[3]) / (12 * h)
    field = lm.Hankel().field(pupil, v)
    left = 4 * intensity + v * slope + 2 * c * by_defocus + 4 * s * by_spherical
    right = 4 * np.real(np.conj(field) * np.exp(1j * (2 * c + s))) * j0(v)
    assert np.abs(left - right).max() < 1e-9


def test_a_long_stack_can_be_interrupted_and_leaves_nothing_broken():
    """As the keyboard would, by a signal: its handler runs between the blocks of the stack."""

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    pupil = lm.Pupil(lm.Wavefront(np.linspace(10.0, 30.0, 40_000)))
    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.1)
    try:
        with pytest.raises(KeyboardInterrupt):
            lm.psf(pupil, (1, 1001), 3.0, threads=1)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    after = lm.psf(pupil[3], 33, 0.5, dtype=np.float64)
    assert lm.peak_error(after, lm.psf(pupil[3], 33, 0.5, method=lm.Hankel())) <= after.error_bound


def test_phases_beyond_all_measure_are_refused_with_the_limit():
    with pytest.raises(ValueError, match="nodes, more than the limit of 6000"):
        lm.psf(lm.Pupil(lm.Wavefront(1e5)), 33, 0.5)
    with pytest.raises(ValueError, match="limit of 1000000 rad"):
        lm.psf(lm.Pupil(lm.Wavefront(np.linspace(0, 1e7, 9))), 33, 0.5)


def test_a_tolerance_below_rounding_is_refused_and_says_what_is_reached():
    with pytest.raises(lm.ToleranceError, match="tol=1e-12 cannot be met"):
        lm.psf(lm.Pupil(lm.Wavefront(200.0, 200.0)), 64, 0.5, method=lm.NijboerZernike(1e-12))
