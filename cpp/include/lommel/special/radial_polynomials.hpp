// Radial polynomials R_n^m of Zernike terms, and the Zernike expansion of a term on a smaller disk.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <vector>

#include "lommel/limits.hpp"

#include "lommel/base/wide.hpp"

namespace lommel {

// One step, from R_{m+2k}^m to R_{m+2k+2}^m, of the recurrence of the Jacobi polynomials P_k^(0,m)(x), x = 2 rho^2 - 1 (DLMF
// 18.9.1): next = (slope x + shift) here - back before.
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

// Radial polynomial R_n^m(rho), x = 2 rho^2 - 1 real or complex, from `here` = R_m^m = rho^m.
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

// Values of Zernike terms at a point, by one recurrence for each azimuthal order m and each of cosine and sine.
class ZernikeValues {
   public:
    // `order`: indices of the Zernike terms to evaluate. at() identifies a term by its place j in `order`.
    ZernikeValues(const std::vector<ZernikeTerm>& terms, const std::vector<std::size_t>& order) {
        for (const std::size_t place : order) {
            const ZernikeTerm& term = terms[place];
            const std::size_t m = static_cast<std::size_t>(std::abs(term.m)), k = (static_cast<std::size_t>(term.n) - m) / 2;
            order_.push_back({m, term.m < 0, k, order_.size()});
            steps_.resize(std::max(steps_.size(), m + 1));
            while (steps_[m].size() < k) {
                steps_[m].emplace_back(steps_[m].size(), static_cast<wide>(m));
            }
        }
        std::sort(order_.begin(), order_.end(),
                  [](const Term& a, const Term& b) { return std::tie(a.m, a.sine, a.k) < std::tie(b.m, b.sine, b.k); });
    }

    // Call put(j, value) for each Zernike term at the point (x, y); x and y may be complex. j: index in the constructor's `order`.
    template <class Number, class Put>
    void at(Number x, Number y, const Put& put) const {
        const Number two = 2, one = 1, square = two * (x * x + y * y) - one;
        Number re = 1, im = 0;  // real and imaginary part of (x + i y)^m
        std::size_t m = 0;
        for (std::size_t i = 0; i < order_.size();) {
            const Term& first = order_[i];
            for (; m < first.m; ++m) {
                const Number next = re * x - im * y;
                im = re * y + im * x;
                re = next;
            }
            Number before = 0, here = first.sine ? im : re;
            for (std::size_t k = 0; i < order_.size() && order_[i].m == m && order_[i].sine == first.sine; ++i) {
                for (; k < order_[i].k; ++k) {
                    const RadialStep<wide>& step = steps_[m][k];
                    const Number next = (step.slope * square + step.shift) * here - step.back * before;
                    before = here;
                    here = next;
                }
                put(order_[i].j, here);
            }
        }
    }

   private:
    struct Term {
        std::size_t m;
        bool sine;
        std::size_t k, j;  // k = (n - m) / 2; j: place of the term in the given order
    };
    std::vector<Term> order_;
    std::vector<std::vector<RadialStep<wide>>> steps_;  // [azimuthal order m][k]: step from degree m + 2k
};

// Zernike terms of a function on a smaller disk of radius a: R_n^m(a rho) contains R_k^m(rho) with the factor
// R_n^k(a) - R_n^{k+2}(a), k = n, n - 2, ..., m (Janssen and Dirksen, J. Microlith. Microfab. Microsyst. 5, 030501 (2006)).
// These factors are cached.
class SmallerDisk {
   public:
    // Expand c R_n^m(a rho): call add(k, c * (factor of R_k^m)) for each k. Returns a bound on the rounding error of sums of
    // `terms` such products. Each of the at most n / 2 + 1 factors is a difference of two polynomials, which have errors of n^2
    // epsilons of `wide` each. In double precision, each factor, product and sum has an error of one roundoff.
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
    std::vector<std::vector<double>> shares_;  // factors of R_k^m: [n][(n - k) / 2]
};

}  // namespace lommel
