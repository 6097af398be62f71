// Legendre polynomials and Gauss-Legendre quadrature on [-1, 1].
#pragma once

#include <cmath>
#include <cstddef>

#include "lommel/base/watch.hpp"
#include "lommel/base/wide.hpp"

namespace lommel {

// Call f(n, P_n(1 - y)) for n < terms, 0 <= y <= 1, by the three-term recurrence (DLMF 18.9.1). For small y the errors of this
// recurrence grow as n^2, so differences of successive polynomials are summed instead, which have only a few roundings.
template <class Real, class F>
void each_legendre(Real y, std::size_t terms, const F& f) {
    const Real x = 1 - y;
    Real before = 0, here = 1;
    for (std::size_t n = 0; n < terms; ++n) {
        f(n, here);
        const Real m = static_cast<Real>(n);
        if (y < Real(0.5)) {
            before = (m * before - (2 * m + 1) * y * here) / (m + 1);  // the difference P_{n+1} - P_n
            here += before;
        } else {
            const Real next = ((2 * m + 1) * x * here - m * before) / (m + 1);
            before = here;
            here = next;
        }
    }
}

// Nodes (ascending) and weights of the n-point rule by Newton's method from Tricomi's initial guess. The unknown y is a node's
// distance from the end of the interval: near that end, weights from rounded nodes or from eigenvalues lose up to eight digits.
template <class Number, class Real = wide>
void gauss_legendre(std::size_t n, Number* nodes, Number* weights) {
    const Real pi = std::acos(Real(-1));
    const Real order = static_cast<Real>(n);
    for (std::size_t i = 0; i < (n + 1) / 2; ++i) {
        look();
        const Real theta = pi * (static_cast<Real>(i) + Real(0.75)) / (order + Real(0.5)), sine = std::sin(theta / 2);
        Real y = 2 * sine * sine + std::cos(theta) * (order - 1) / (8 * order * order * order);
        Real weight = 2, move = y;
        for (int step = 0; step < 20 && !(std::abs(move) < Real(1e-10) * y); ++step) {
            Real before = 0, value = 0;
            each_legendre(y, n + 1, [&](std::size_t, Real p) {
                before = value;
                value = p;
            });
            const Real round = y * (2 - y), slope = order * (before - (1 - y) * value) / round;
            move = value / slope;
            // Weight 2 / ((1 - x^2) P_n'(x)^2) at the next x = 1 - (y + move), to first order in `move`, from values at 1 - y.
            weight = 2 / (round * slope * slope) * (1 + 2 * (1 - y) * move / round);
            y += move;
        }
        nodes[i] = static_cast<Number>(y - 1);
        nodes[n - 1 - i] = static_cast<Number>(1 - y);
        weights[i] = weights[n - 1 - i] = static_cast<Number>(weight);
    }
    if (n % 2 == 1) {
        nodes[n / 2] = 0;
    }
}

// Legendre polynomials P_0(x) .. P_{terms-1}(x) for 0 <= x <= 1, accurate to the rounding of a double if Real is wider.
template <class Real = wide>
void legendre_sequence(double x, std::size_t terms, double* out) {
    each_legendre(1 - static_cast<Real>(x), terms, [&](std::size_t n, Real p) { out[n] = static_cast<double>(p); });
}

// Rounding of a Gauss-Legendre rule computed in double: maximum over n of sqrt(2n+1) times the sum over nodes of the errors of
// weight x P_n(node), in units of roundoff. Measured by cpp/tests/tables.cpp, not proven.
inline double rule_rounding(std::size_t nodes) { return wider ? 0.0 : 1.5 * std::sqrt(static_cast<double>(nodes)); }

}  // namespace lommel
