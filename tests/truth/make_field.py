r"""Recompute ``field.csv``, the high-precision truth for the aberrated pupil integral.

Every row of the table holds one value of

.. math::

    U(v) = 2 \int_\epsilon^1 \exp[i (2 C_d \rho^2 + C_s \rho^4 + c_6 \rho^6 + c_8 \rho^8)]
           J_0(v \rho) \, \rho \, d\rho ,

which is *not* divided by the open area :math:`1 - \epsilon^2`. The columns are ``defocus``
(:math:`C_d`), ``spherical`` (:math:`C_s`), ``sixth`` (:math:`c_6`), ``eighth`` (:math:`c_8`),
``obscuration`` (:math:`\epsilon`), ``v``, ``real`` and ``imag``. The parameters are written with ``repr``,
so that they parse back to exactly the doubles that were used here; the two parts of the value carry
20 significant digits.

How a value is verified before it is written:

1. It is integrated in :math:`\rho` with 64-point Gauss-Legendre panels at 50 digits, the number of panels
   growing with the span of the phase.
2. It is integrated again in :math:`t = \rho^2`, where the integrand is
   :math:`\exp[i (2 C_d t + C_s t^2 + c_6 t^3 + c_8 t^4)] J_0(v \sqrt t)`, with 80-point panels of another
   number at 60 digits.
3. Where only defocus is present it is also summed without any quadrature, from the Lommel-type series
   :math:`2 e^{iu/2} \sum_n (-iu)^n J_{n+1}(v) / v^{n+1}` with :math:`u = 4 C_d`, whose Bessel functions come
   from Miller's recurrence instead of from mpmath. This includes the Airy rows, where the series
   reduces to :math:`2 J_1(v) / v`.

All of these must agree to ``AGREEMENT`` (absolute), or the run stops and the table is left as it was.

Usage::

    python tests/truth/make_field.py              # rewrite field.csv next to this file
    python tests/truth/make_field.py --check 10   # recompute 10 of its rows and compare

It needs mpmath besides the standard library.
"""

import argparse
import csv
import io
import math
import multiprocessing
import os
import random
import sys
from functools import lru_cache
from pathlib import Path

from mpmath import mp, mpc, mpf, nstr

TABLE = Path(__file__).with_name("field.csv")
HEADER = ["defocus", "spherical", "sixth", "eighth", "obscuration", "v", "real", "imag"]
SEED = 20240607
SIGNIFICANT = 20

# Far below the printed digits: a part as small as 1e-17 must still be right in its 20th significant digit.
AGREEMENT = mpf("1e-38")

RHO_RULE = {"digits": 50, "order": 64, "span": 40}
T_RULE = {"digits": 60, "order": 80, "span": 32}
# Aberrations of high degree need more than one panel even when their phase span is small.
FEWEST_PANELS = 8


def points():
    """
    List the parameters of the table.

    Returns
    -------
    list of tuple of float
        Distinct tuples ``(defocus, spherical, sixth, eighth, obscuration, v)``, always the same and in the
        same order.
    """
    rows = [
        *_airy_points(),
        *_defocus_points(),
        *_spherical_points(),
        *_obscured_points(),
        *_high_order_points(),
        *_random_points(),
    ]
    return list(dict.fromkeys(tuple(float(x) for x in row) for row in rows))


def _airy_points():
    for v in (0, 1e-9, 1e-3, 0.5, 1, 1.0000001, 3.8317059702075125, 10, 50.3, 200, 800):
        yield 0, 0, 0, 0, 0, v
    for obscuration, v in ((0.1, 1e-3), (0.33, 0), (0.33, 25), (0.5, 10), (0.5, 800), (0.9, 1), (0.9, 800)):
        yield 0, 0, 0, 0, obscuration, v


def _defocus_points():
    for defocus in (1e-9, 1e-3, 0.1, -0.1, 1, 7.3, -31.7, 50, 99.9, -123.456):
        edge = 4 * abs(defocus)
        for ratio in (0.5, 1, 1.5):
            yield defocus, 0, 0, 0, 0, ratio * edge
    for defocus in (1e-9, 0.1, 0.25, -200, 200):
        for v in (0, 1, 1.0000001, 800):
            yield defocus, 0, 0, 0, 0, v
    for defocus in (math.pi / 2, -50, 123.456):
        for v in (0, 1e-9, 1e-3, 0.5):
            yield defocus, 0, 0, 0, 0, v
    for ratio in (0.01, 0.5, 0.99, 0.9999999, 1 - 2**-53):
        yield 200, 0, 0, 0, 0, ratio * 800
    for ratio in (0.99, 0.9999999, 1.0000001, 1.01, 3.9):
        yield -50, 0, 0, 0, 0, ratio * 200


def _spherical_points():
    for defocus in (-200, 200):
        for spherical in (-200, 200):
            for v in (0, 1.0000001, 333.3, 800):
                yield defocus, spherical, 0, 0, 0, v
    for spherical in (1e-9, 1e-3, 0.1, -0.1, 20, -77.7, 200, -200):
        for v in (0, 0.5, 4 * abs(spherical)):
            yield 0, spherical, 0, 0, 0, v
    small_and_mixed = ((1e-9, 1e-9), (1e-3, -1e-3), (0.1, 0.1), (1e-9, 200), (200, 1e-9), (-200, 1e-3))
    for defocus, spherical in small_and_mixed:
        yield defocus, spherical, 0, 0, 0, 1
    # The on-axis stationary point 2 Cd + 2 Cs t = 0 at the rim (t = 1), at half the area, and at t = 0.01.
    for defocus, spherical in ((-100, 100), (-50, 100), (50, -100), (-2, 200)):
        for v in (0, 1e-3, 30, 4 * abs(defocus)):
            yield defocus, spherical, 0, 0, 0, v


def _obscured_points():
    for obscuration in (0.1, 0.33, 0.5, 0.9):
        yield 200, 0, 0, 0, obscuration, 800
        yield -37.5, 0, 0, 0, obscuration, 4 * 37.5 * obscuration
        yield 1e-3, 0.1, 0, 0, obscuration, 0.5
        yield -200, 200, 0, 0, obscuration, 0
        yield 200, 200, 0, 0, obscuration, 1600 / 3
        yield -60, 90, 0, 0, obscuration, 17.25


def _high_order_points():
    yield 0, 0, 1e-9, 0, 0, 1
    yield 0, 0, 0, 1e-3, 0, 0.5
    yield 0, 0, 30, 0, 0, 0
    yield 0, 0, 0, -30, 0, 0
    yield 0, 0, 30, -30, 0, 1e-9
    yield 0, 0, -30, 30, 0.5, 800
    yield 5, -3, 2, -1, 0, 4
    yield -20, 30, -20, 5, 0.33, 20
    yield 12.5, 0, 7.25, 0, 0, 50
    yield 12.5, 0, 0, 7.25, 0.1, 50
    for sign in (-1, 1):
        yield 200, 200, sign * 30, sign * 30, 0, 800
        yield -200, 200, sign * 30, -sign * 30, 0.9, 100
        yield 0.1, -200, sign * 30, 0.1, 0, 1e-3


def _random_points():
    source = random.Random(SEED)
    for index in range(24):
        defocus, spherical = source.uniform(-200, 200), source.uniform(-200, 200)
        sixth, eighth = source.uniform(-30, 30), source.uniform(-30, 30)
        obscuration = source.choice((0, 0.1, 0.33, 0.5, 0.9))
        v = source.uniform(0, 800)
        if index % 3:
            sixth = eighth = 0
        yield defocus, spherical, sixth, eighth, obscuration, v


@lru_cache(maxsize=4)
def gauss_legendre(order, digits):
    """
    Compute the nodes and weights of a Gauss-Legendre rule on [-1, 1].

    Parameters
    ----------
    order : int
        Number of nodes, even.
    digits : int
        Decimal digits to which the rule is right.

    Returns
    -------
    list of tuple of mpf
        The pairs ``(node, weight)``.
    """
    with mp.workdps(digits + 15):
        tolerance = mpf(10) ** -(digits + 8)
        rule = []
        for k in range(order // 2):
            x = mp.cos(mp.pi * (k + mpf(3) / 4) / (order + mpf(1) / 2))
            step = mpf(1)
            while abs(step) > tolerance:
                step = mp.fdiv(*_legendre(order, x))
                x -= step
            _, slope = _legendre(order, x)
            weight = 2 / ((1 - x * x) * slope * slope)
            rule += [(x, weight), (-x, weight)]
        return rule


def _legendre(order, x):
    """Return the Legendre polynomial of the given order and its derivative at ``x``."""
    before, value = mpf(1), x
    for k in range(2, order + 1):
        before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
    return value, order * (x * value - before) / (x * x - 1)


def _panel_sum(integrand, lower, upper, panels, rule):
    """Integrate over ``panels`` equal panels, each with the Gauss-Legendre ``rule``."""
    half = (upper - lower) / (2 * panels)
    total = mpc(0)
    for panel in range(panels):
        centre = lower + (2 * panel + 1) * half
        total += mp.fsum(weight * integrand(centre + half * node) for node, weight in rule)
    return half * total


def by_radius(row):
    """
    Integrate over the radius.

    Parameters
    ----------
    row : tuple of float
        ``(defocus, spherical, sixth, eighth, obscuration, v)``.

    Returns
    -------
    mpc
        The value of the integral.
    """
    with mp.workdps(RHO_RULE["digits"]):
        defocus, spherical, sixth, eighth, obscuration, v = map(mpf, row)

        def integrand(rho):
            t = rho * rho
            phase = t * (2 * defocus + t * (spherical + t * (sixth + t * eighth)))
            return mp.expj(phase) * (2 * rho * mp.j0(v * rho))

        rate = 4 * abs(defocus) + 4 * abs(spherical) + 6 * abs(sixth) + 8 * abs(eighth) + v
        panels = FEWEST_PANELS + int(mp.ceil(rate * (1 - obscuration) / RHO_RULE["span"]))
        rule = gauss_legendre(RHO_RULE["order"], RHO_RULE["digits"])
        return _panel_sum(integrand, obscuration, mpf(1), panels, rule)


def by_area(row):
    """
    Integrate over the squared radius.

    Parameters
    ----------
    row : tuple of float
        ``(defocus, spherical, sixth, eighth, obscuration, v)``.

    Returns
    -------
    mpc
        The value of the integral.
    """
    with mp.workdps(T_RULE["digits"]):
        defocus, spherical, sixth, eighth, obscuration, v = map(mpf, row)

        def integrand(t):
            phase = t * (2 * defocus + t * (spherical + t * (sixth + t * eighth)))
            return mp.expj(phase) * mp.j0(v * mp.sqrt(t))

        lower = obscuration * obscuration
        # J0(v sqrt(t)) is entire in t, so its fast start at t = 0 takes no more panels than v itself does.
        rate = 2 * abs(defocus) + 2 * abs(spherical) + 3 * abs(sixth) + 4 * abs(eighth) + v
        panels = FEWEST_PANELS + 3 + int(mp.ceil(rate * (1 - lower) / T_RULE["span"]))
        rule = gauss_legendre(T_RULE["order"], T_RULE["digits"])
        return _panel_sum(integrand, lower, mpf(1), panels, rule)


def by_series(row):
    """
    Sum the series of the purely defocused integral.

    Parameters
    ----------
    row : tuple of float
        ``(defocus, 0, 0, 0, obscuration, v)``.

    Returns
    -------
    mpc
        The value of the integral.
    """
    defocus, *_, obscuration, v = row
    # For v below u the terms grow to about exp(u / 2) before they cancel.
    with mp.workdps(70 + math.ceil(2 * abs(defocus) / math.log(10))):
        defocus, obscuration, v = mpf(defocus), mpf(obscuration), mpf(v)
        area = obscuration * obscuration
        whole = _unobscured_series(4 * defocus, v)
        hole = _unobscured_series(4 * defocus * area, v * obscuration)
        return whole - area * hole


def _unobscured_series(u, v):
    """Return ``2 exp(iu/2) sum_n (-iu)^n J_{n+1}(v) / v^{n+1}`` at the working precision."""
    terms = 150 + int(2 * max(abs(u), v))
    # Miller's recurrence on J_n(v) / v^n, which stays finite at v = 0.
    scaled = [mpf(0)] * (terms + 2)
    scaled[terms] = mpf(1)
    square = v * v
    for n in range(terms, 0, -1):
        scaled[n - 1] = 2 * n * scaled[n] - square * scaled[n + 1]
    # J_0 + 2 (J_2 + J_4 + ...) = 1
    norm = scaled[0] + 2 * mp.fsum(scaled[n] * v**n for n in range(2, terms, 2))
    total = mpc(0)
    for n in range(terms - 1, -1, -1):
        total = scaled[n + 1] / norm + mpc(0, -u) * total
    return 2 * mp.expj(u / 2) * total


def reference(row):
    """
    Compute one value in all the ways that apply to it.

    Parameters
    ----------
    row : tuple of float
        ``(defocus, spherical, sixth, eighth, obscuration, v)``.

    Returns
    -------
    value : mpc
        The value of the integral.
    deviation : mpf
        The largest absolute difference between two of the ways.

    Raises
    ------
    ArithmeticError
        If the deviation exceeds ``AGREEMENT``.
    """
    value = by_area(row)
    others = [by_radius(row)]
    if not any(row[1:4]):
        others.append(by_series(row))
    with mp.workdps(T_RULE["digits"]):
        deviation = max(abs(other - value) for other in others)
    if not deviation <= AGREEMENT:
        raise ArithmeticError(f"the ways of computing {row} differ by {nstr(deviation, 3)}")
    return value, deviation


def write_table(jobs):
    """
    Recompute the table and move it into place.

    Parameters
    ----------
    jobs : int
        Number of processes.

    Returns
    -------
    str
        A line that says what was done.
    """
    rows = points()
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    largest = mpf(0)
    with multiprocessing.Pool(jobs) as pool:
        for row, (printed, deviation) in zip(rows, pool.imap(_printed, rows), strict=True):
            writer.writerow([*map(repr, row), *printed])
            largest = max(largest, deviation)
    temporary = TABLE.with_name(f".{TABLE.name}.{os.getpid()}")
    try:
        temporary.write_text(text.getvalue(), encoding="ascii", newline="\n")
        temporary.replace(TABLE)
    finally:
        temporary.unlink(missing_ok=True)
    return f"{len(rows)} rows written; the largest deviation between two ways is {nstr(largest, 3)}"


def _printed(row):
    """Return the two parts of the reference value as they stand in the table, and its deviation."""
    # A value must be printed where it was computed: an mpf that is unpickled is rounded to the precision set
    # in the receiving process.
    value, deviation = reference(row)
    return [_digits(value.real), _digits(value.imag)], deviation


def _digits(x):
    """Write ``x`` in scientific notation with the significant digits of the table."""
    return nstr(x, SIGNIFICANT, strip_zeros=False, min_fixed=0, max_fixed=0) if x else "0.0"


def check_table(count, jobs):
    """
    Recompute some rows of the table and compare them with what it holds.

    Parameters
    ----------
    count : int
        Number of rows, taken evenly over the table.
    jobs : int
        Number of processes.

    Returns
    -------
    str
        A line that says what was done.

    Raises
    ------
    ArithmeticError
        If the table does not hold the parameters of `points`, or a value differs in a printed digit.
    """
    with TABLE.open(encoding="ascii", newline="") as file:
        header, *table = csv.reader(file)
    if header != HEADER or [tuple(map(float, line[:6])) for line in table] != points():
        raise ArithmeticError("the table does not hold the parameters that this script chooses")
    count = min(count, len(table))
    chosen = [table[(2 * k + 1) * len(table) // (2 * count)] for k in range(count)]
    with multiprocessing.Pool(jobs) as pool:
        computed = pool.imap(_printed, [tuple(map(float, line[:6])) for line in chosen])
        for line, (printed, _) in zip(chosen, computed, strict=True):
            if line[6:] != printed:
                raise ArithmeticError(f"the row {','.join(line)} should end in {','.join(printed)}")
    return f"{count} of {len(table)} rows agree in every printed digit"


def main():
    """
    Run the command line.

    Returns
    -------
    int or str
        The exit status, or the message that goes with a failing one.
    """
    parser = argparse.ArgumentParser(description="Recompute field.csv, or check some of its rows.")
    parser.add_argument("--check", type=int, metavar="N", help="only recompute N rows and compare")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="number of processes")
    arguments = parser.parse_args()
    if arguments.check is not None and arguments.check < 1:
        parser.error("N must be at least 1")
    try:
        if arguments.check is None:
            print(write_table(arguments.jobs))
        else:
            print(check_table(arguments.check, arguments.jobs))
    except ArithmeticError as error:
        return str(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
