// The radial polynomials R_n^m of Zernike terms, and the terms of a function on a smaller disk.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <vector>

#include "lommel/limits.hpp"

#include "lommel/base/wide.hpp"

namespace lommel {

// R_m^m, R_{m+2}^m, ... follow Jacobi's recurrence for P_k^(0,m)(x), x = 2 rho^2 - 1 (DLMF 18.9.1): the next is
// (slope x + shift) here - back before. These are the coefficients of the step from degree m + 2k.
template <class Real>
struct RadialStep {
    Real slope, shift, back = 0;

    RadialStep(std::size_t k, Real m) : slope(Real(0.5) * (m + 2)), shift(Real(-0.5) * m) {
        if (k > 0) {
            const Real i = static_cast<Real>(k), s = 2 * i + m, scale = 2 * (i + 1) * (i + 1 + m) * s;
            slope = (s + 1) * (s + 2) * s / scale;
            shift = -(s + 1) * m * m / scale;
            back = 2 * i * (i + m) * (s + 2) / scale;
        }
    }
};

// R_n^m from R_m^m, at real or complex points.
template <class Number>
Number radial_polynomial(std::size_t n, std::size_t m, Number x, Number here) {
    Number before = 0;
    for (std::size_t k = 0; k < (n - m) / 2; ++k) {
        const RadialStep<wide> step(k, static_cast<wide>(m));
        const Number next = (step.slope * x + step.shift) * here - step.back * before;
        before = here;
        here = next;
    }
    return here;
}

// A Zernike term as a polynomial in x and y.
template <class Number>
Number zernike_value(const ZernikeTerm& term, Number x, Number y) {
    const std::int32_t m = std::abs(term.m);
    Number re = 1, im = 0;  // the parts of (x + i y)^m
    for (std::int32_t j = 0; j < m; ++j) {
        const Number next = re * x - im * y;
        im = re * y + im * x;
        re = next;
    }
    const Number two = 2, one = 1;
    return radial_polynomial(static_cast<std::size_t>(term.n), static_cast<std::size_t>(m), two * (x * x + y * y) - one,
                             term.m < 0 ? im : re);
}

// The terms of a function over a smaller disk of radius a: R_n^m(a rho) has R_n^k(a) - R_n^{k+2}(a) of R_k^m(rho), for
// k = n, n - 2, ..., m (Janssen and Dirksen, J. Microlith. Microfab. Microsyst. 5, 030501 (2006)). These shares are kept for the
// next function.
class SmallerDisk {
   public:
    // Calls add(k, what c R_n^m has of R_k^m), and returns a bound on what that loses, sums of so many terms included: n^2
    // roundings by the recurrence, in each of n / 2 + 1 shares at most; one of each share, of its product and of sums.
    template <class Add>
    double shrink(std::size_t n, std::size_t m, double a, double c, std::size_t terms, const Add& add) {
        if (a != radius_) {
            radius_ = a;
            shares_.clear();
        }
        shares_.resize(std::max(shares_.size(), n + 1));
        std::vector<double>& shares = shares_[n];
        for (std::size_t k = n - 2 * shares.size(); shares.size() <= (n - m) / 2; k -= 2) {
            const wide next = k < n ? polynomial(n, k + 2) : wide(0);
            shares.push_back(static_cast<double>(polynomial(n, k) - next));
        }
        double sum = 0.0;
        for (std::size_t i = 0; i <= (n - m) / 2; ++i) {
            add(n - 2 * i, shares[i] * c);
            sum += std::abs(shares[i] * c);
        }
        const double degree = static_cast<double>(n), extended = static_cast<double>(std::numeric_limits<wide>::epsilon());
        return extended * degree * degree * (degree + 2.0) * std::abs(c) + unit_roundoff * static_cast<double>(terms + 1) * sum;
    }

   private:
    wide polynomial(std::size_t n, std::size_t m) const {
        const wide rho = radius_;
        return radial_polynomial(n, m, 2 * rho * rho - 1, std::pow(rho, static_cast<wide>(m)));
    }

    double radius_ = -1.0;
    std::vector<std::vector<double>> shares_;  // [n][(n - k) / 2]
};

}  // namespace lommel
