// Polynomial interpolation at Chebyshev points.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "lommel/base/wide.hpp"

namespace lommel {

template <class Real = double>
Real chebyshev_point(std::size_t j, std::size_t count) {
    return std::cos(std::acos(Real(-1)) * (static_cast<Real>(j) + Real(0.5)) / static_cast<Real>(count));
}

// Integral of r f(r) dr, r = middle + half x, for a Chebyshev series f of `count` terms in x. `out`: count + 2 Chebyshev
// coefficients of the integral, which is `before` at x = -1. `moment`: scratch, count + 3 numbers. Returns the integral at x = 1.
inline double integrate_moment(double half, double middle, const double* series, std::size_t count, double before,
                               double* moment, double* out) {
    std::fill_n(moment, count + 3, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
        moment[k] += middle * series[k];
        moment[k + 1] += (k == 0 ? 1.0 : 0.5) * half * series[k];
        if (k > 0) {
            moment[k - 1] += 0.5 * half * series[k];
        }
    }
    double start = 0.0, end = 0.0;
    for (std::size_t k = 1; k < count + 2; ++k) {
        const double behind = (k == 1 ? 2.0 : 1.0) * moment[k - 1];
        out[k] = half * (behind - moment[k + 1]) / static_cast<double>(2 * k);
        start += k % 2 == 0 ? out[k] : -out[k];
        end += out[k];
    }
    out[0] = before - start;
    return out[0] + end;
}

// Conversion of values at `Count` Chebyshev points to Chebyshev coefficients, then, by an integer matrix that adds no error, to
// coefficients of 1, x, x^2, .... One matrix for both steps would lose five digits in double.
template <std::size_t Count, class Real = wide>
class ChebyshevToMonomials {
   public:
    ChebyshevToMonomials() {
        monomials_[0][0] = monomials_[1][1] = 1;
        for (std::size_t i = 2; i < Count; ++i) {
            for (std::size_t k = 0; k < Count; ++k) {
                monomials_[i][k] = (k > 0 ? 2 * monomials_[i - 1][k - 1] : 0) - monomials_[i - 2][k];
            }
        }
        const Real unit = std::acos(Real(-1)) / (2 * Count);
        for (std::size_t i = 0; i < Count; ++i) {
            for (std::size_t j = 0; j < Count; ++j) {
                cosines_[i][j] = std::cos(unit * static_cast<Real>(i * (2 * j + 1) % (4 * Count))) * (i == 0 ? 1 : 2) / Count;
            }
        }
    }
    // Write to `out` the first `kept` Chebyshev terms as coefficients of 1, x, x^2, ...; return the sum of the others' moduli.
    template <class In, class Out>
    Real operator()(const In* values, std::size_t stride, Out* out, std::size_t kept = Count) const {
        std::array<Real, Count> sums{};
        Real left = 0;
        for (std::size_t i = 0; i < Count; ++i) {
            Real c = 0;
            for (std::size_t j = 0; j < Count; ++j) {
                c += cosines_[i][j] * static_cast<Real>(values[j * stride]);
            }
            left += i < kept ? 0 : std::abs(c);
            for (std::size_t k = i % 2; k <= i && i < kept; k += 2) {
                sums[k] += c * monomials_[i][k];
            }
        }
        std::transform(sums.begin(), sums.begin() + kept, out, [](Real sum) { return static_cast<Out>(sum); });
        return left;
    }

   private:
    std::array<std::array<Real, Count>, Count> cosines_{}, monomials_{};
};

}  // namespace lommel
