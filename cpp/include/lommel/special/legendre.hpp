// Legendre polynomials and Gauss-Legendre quadrature on [-1, 1].
#pragma once

#include <cmath>
#include <cstddef>

#include "lommel/base/watch.hpp"

namespace lommel {

// Nodes (ascending) and weights of the n-point rule: Newton's method from Tricomi's initial guess, in
// extended precision, because weights from double-precision eigenvalues lose up to eight digits at the ends.
template <class Number>
void gauss_legendre(std::size_t n, Number* nodes, Number* weights) {
    using real = long double;
    const real pi = std::acos(real(-1));
    const real order = static_cast<real>(n);
    for (std::size_t i = 0; i < (n + 1) / 2; ++i) {
        look();
        const real theta = pi * (static_cast<real>(i) + real(0.75)) / (order + real(0.5));
        real x = std::cos(theta) * (1 - (order - 1) / (8 * order * order * order));
        real slope = 1;
        for (int step = 0; step < 20; ++step) {
            real before = 1, value = x;
            for (std::size_t k = 2; k <= n; ++k) {
                const real m = static_cast<real>(k);
                const real next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
                before = value;
                value = next;
            }
            slope = order * (x * value - before) / (x * x - 1);
            const real move = value / slope;
            x -= move;
            if (std::abs(move) < real(1e-18)) {
                break;
            }
        }
        const real weight = 2 / ((1 - x * x) * slope * slope);
        nodes[i] = static_cast<Number>(-x);
        nodes[n - 1 - i] = static_cast<Number>(x);
        weights[i] = weights[n - 1 - i] = static_cast<Number>(weight);
    }
    if (n % 2 == 1) {
        nodes[n / 2] = 0;
    }
}

// P_0(x) .. P_{terms-1}(x) by the three-term recurrence (DLMF 18.9.1), stable on [-1, 1]; in extended precision, so
// that the results are correct to double rounding.
inline void legendre_sequence(double x, std::size_t terms, double* out) {
    long double before = 0, here = 1;
    for (std::size_t n = 0; n < terms; ++n) {
        out[n] = static_cast<double>(here);
        const long double m = static_cast<long double>(n);
        const long double next = ((2 * m + 1) * x * here - m * before) / (m + 1);
        before = here;
        here = next;
    }
}

}  // namespace lommel
