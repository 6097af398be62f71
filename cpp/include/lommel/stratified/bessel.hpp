// Bessel functions J_0 to J_3 by piecewise polynomials.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

// Bessel functions J_0 to J_3 as polynomials of degree 15 on pieces of width 2. J_m is of exponential type 1 and at most 1, so the
// interpolation error is at most 2^-15 / 16! < 2e-18 (docs/certificate.md, section 15). The rounding of sampled values, times the
// Lebesgue constant 1 + (2 / pi) log 16, and of Horner's rule is below 96 units of roundoff in all.
struct BesselPieces {
    static constexpr std::size_t orders = 4, coefficients = 16;
    static constexpr double half = 1.0, error = 96.0;  // half width of a piece; error in units of roundoff

    double reach;
    Doubles rows;  // polynomials: [piece][coefficient][Bessel order]

    explicit BesselPieces(double most)
        : reach(std::max(64.0, std::exp2(std::ceil(std::log2(most + 1.0))))),
          rows((static_cast<std::size_t>(0.5 * reach / half) + 1) * orders * coefficients) {
        const ChebyshevToMonomials<coefficients> polynomial;
        std::array<double, orders * coefficients> values{};
        std::array<double, coefficients> series{};
        for (std::size_t first = 0; first < rows.size(); first += values.size()) {
            look();
            const double middle = half * (2.0 * static_cast<double>(first / values.size()) + 1.0);
            for (std::size_t j = 0; j < coefficients; ++j) {
                bessel_sequence(middle + half * chebyshev_point(j, coefficients), orders, values.data() + j * orders);
            }
            for (std::size_t m = 0; m < orders; ++m) {
                polynomial(values.data() + m, orders, series.data());
                for (std::size_t k = 0; k < coefficients; ++k) {
                    rows[first + k * orders + m] = series[k];
                }
            }
        }
    }

    // Compute J_0(v), ..., J_3(v) for v <= reach. Multiply-adds limit the speed.
    template <class I>
    LOMMEL_INLINE void operator()(I, double v, double (&out)[orders]) const {
        constexpr std::size_t lanes = I::lanes < orders ? I::lanes : orders;
        using V = typename Vector<lanes>::pack;
        const std::size_t piece = static_cast<std::size_t>(0.5 * v / half);
        const double x = (v - half * (2.0 * static_cast<double>(piece) + 1.0)) / half;
        const V at = splat<V>(x), square = splat<V>(x * x);
        const double* row = rows.data() + piece * orders * coefficients;
        for (std::size_t m = 0; m < orders; m += lanes, row += lanes) {
            V even = load<V>(row + (coefficients - 2) * orders), odd = load<V>(row + (coefficients - 1) * orders);
            for (std::size_t k = coefficients - 2; k > 0; k -= 2) {
                even = even * square + load<V>(row + (k - 2) * orders);
                odd = odd * square + load<V>(row + (k - 1) * orders);
            }
            store(out + m, even + at * odd);
        }
    }

    std::size_t bytes() const { return sizeof(double) * rows.size(); }
    bool is(double most) const { return most <= reach; }
    static constexpr std::size_t most_bytes = std::size_t{32} << 20;
    static std::shared_ptr<const BesselPieces> get(double most) { return cache<BesselPieces>.get(most); }
};

}  // namespace lommel
