// The radial polynomials R_n^m of Zernike terms, and the terms of a function on a smaller disk.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lommel/base/wide.hpp"

namespace lommel {

// R_n^|m|(rho) times cos(m theta), or sin(|m| theta) for m < 0.
struct ZernikeTerm {
    std::int32_t n, m;
    bool operator==(const ZernikeTerm& other) const { return n == other.n && m == other.m; }
};

// R_m^m, R_{m+2}^m, ... follow Jacobi's recurrence for P_k^(0,m)(x), x = 2 rho^2 - 1 (DLMF 18.9.1): the next is
// (slope x + shift) here - back before. These are the coefficients of the step from degree m + 2k.
template <class Real>
void radial_step(std::size_t k, Real m, Real& slope, Real& shift, Real& back) {
    if (k == 0) {
        slope = Real(0.5) * (m + 2);
        shift = Real(-0.5) * m;
        back = 0;
        return;
    }
    const Real i = static_cast<Real>(k), s = 2 * i + m, scale = 2 * (i + 1) * (i + 1 + m) * s;
    slope = (s + 1) * (s + 2) * s / scale;
    shift = -(s + 1) * m * m / scale;
    back = 2 * i * (i + m) * (s + 2) / scale;
}

inline wide radial_polynomial(std::size_t n, std::size_t m, wide rho) {
    const wide x = 2 * rho * rho - 1;
    wide before = 0, here = std::pow(rho, static_cast<wide>(m)), slope, shift, back;
    for (std::size_t k = 0; k < (n - m) / 2; ++k) {
        radial_step(k, static_cast<wide>(m), slope, shift, back);
        const wide next = (slope * x + shift) * here - back * before;
        before = here;
        here = next;
    }
    return here;
}

// What R_n^m(a rho) has of R_k^m(rho), for k = n, n - 2, ..., m; whatever m is (Janssen and Dirksen, J. Microlith. Microfab.
// Microsyst. 5, 030501 (2006)): a function of n and k alone.
inline double shrunk(std::size_t n, std::size_t k, double a) {
    const wide rho = a;
    const wide next = k < n ? radial_polynomial(n, k + 2, rho) : wide(0);
    return static_cast<double>(radial_polynomial(n, k, rho) - next);
}

// Bound on what the recurrences lose in all shares of a term of degree n that is 1 at the edge, but for the last rounding of
// each: n^2 roundings in each of n / 2 + 1 at most.
inline double shrinking(std::size_t n) {
    const double degree = static_cast<double>(n);
    return static_cast<double>(std::numeric_limits<wide>::epsilon()) * degree * degree * (degree + 2.0);
}

}  // namespace lommel
