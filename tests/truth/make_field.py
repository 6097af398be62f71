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

The parameters are those of the table: Airy patterns, defocus and spherical aberration up to 200 rad, within, at and
beyond the geometric edge, stationary points on the axis, obscurations, higher powers, and 24 rows drawn at random. A
row of parameters that is appended gets its value in the next run.

Usage::

    python tests/truth/make_field.py              # compute the values of field.csv next to this file anew
    python tests/truth/make_field.py --check 10   # compute 10 of them anew and compare

It needs mpmath besides the standard library.
"""

import argparse
import csv
import math
import multiprocessing
import os
import sys
from functools import lru_cache
from pathlib import Path

from mpmath import mp, mpc, mpf, nstr

TABLE = Path(__file__).with_name("field.csv")
SIGNIFICANT = 20

# Far below the printed digits: a part as small as 1e-17 must still be right in its 20th significant digit.
AGREEMENT = mpf("1e-38")

RHO_RULE = {"digits": 50, "order": 64, "span": 40}
T_RULE = {"digits": 60, "order": 80, "span": 32}
# Aberrations of high degree need more than one panel even when their phase span is small.
FEWEST_PANELS = 8


@lru_cache(maxsize=4)
def gauss_legendre(order, digits):
    """Return pairs of node and weight of a Gauss-Legendre rule on [-1, 1] of even order, right to so many digits."""
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
    """Return the integral over the radius; a row is ``(defocus, spherical, sixth, eighth, obscuration, v)``."""
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
    """Return the integral over the squared radius."""
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
    """Return the sum of the series of the purely defocused integral."""
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
    """Return a value and the largest difference of two ways to compute it; ArithmeticError if they do not agree."""
    value = by_area(row)
    others = [by_radius(row)]
    if not any(row[1:4]):
        others.append(by_series(row))
    with mp.workdps(T_RULE["digits"]):
        deviation = max(abs(other - value) for other in others)
    if not deviation <= AGREEMENT:
        raise ArithmeticError(f"the ways of computing {row} differ by {nstr(deviation, 3)}")
    return value, deviation


def printed(row):
    """Return the two parts of the reference value as they stand in the table, and its deviation."""
    # A value must be printed where it was computed: an mpf that is unpickled is rounded to the precision set
    # in the receiving process.
    value, deviation = reference(row)
    parts = value.real, value.imag
    return [
        nstr(x, SIGNIFICANT, strip_zeros=False, min_fixed=0, max_fixed=0) if x else "0.0" for x in parts
    ], deviation


def main():
    """Run the command line."""
    parser = argparse.ArgumentParser(description="Compute the values of field.csv anew, or check some of its rows.")
    parser.add_argument("--check", type=int, metavar="N", help="only compute N rows anew, evenly over the table")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="number of processes")
    given = parser.parse_args()
    with TABLE.open(encoding="ascii", newline="") as file:
        header, *table = csv.reader(file)
    count = len(table) if given.check is None else min(given.check, len(table))
    chosen = [table[(2 * k + 1) * len(table) // (2 * count)] for k in range(count)]
    largest, differing = mpf(0), 0
    with multiprocessing.Pool(given.jobs) as pool:
        for line, (parts, deviation) in zip(
            chosen, pool.imap(printed, [tuple(map(float, line[:6])) for line in chosen]), strict=True
        ):
            if line[6:] != parts:
                print(f"the row {','.join(line)} should end in {','.join(parts)}")
                differing += 1
            line[6:] = parts
            largest = max(largest, deviation)
    print(f"{count} rows; {differing} differ; the largest deviation between two ways is {nstr(largest, 3)}")
    if given.check is not None:
        return differing > 0
    with TABLE.open("w", encoding="ascii", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *table])
    return 0


if __name__ == "__main__":
    sys.exit(main())
