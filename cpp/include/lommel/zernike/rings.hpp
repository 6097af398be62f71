// Rings: parts of a radial piece that are so narrow that 8 of its 16 polynomial coefficients suffice.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

constexpr std::size_t ring_degree = 8;  // number of polynomial coefficients on a ring

// Error bound of interpolation at 8 Chebyshev points of a ring of this width in v, relative to sup |U|; see piece_error().
inline double ring_error(double width) { return 2.0 * std::pow(0.25 * width, ring_degree) / 40320.0; }
// Largest width of a ring, in v, for which ring_error() is at most `error`.
inline double ring_width(double error) { return 4.0 * std::pow(20160.0 * error, 1.0 / ring_degree); }

// Matrix from values at the 8 Chebyshev points to monomial coefficients, in double precision.
struct RingMatrix {
    double at[ring_degree][ring_degree];  // [power][Chebyshev point]

    RingMatrix() {
        const ChebyshevToMonomials<ring_degree> convert;
        for (std::size_t j = 0; j < ring_degree; ++j) {
            double one[ring_degree] = {}, column[ring_degree];
            one[j] = 1.0;
            convert(one, 1, column);
            for (std::size_t k = 0; k < ring_degree; ++k) {
                at[k][j] = column[k];
            }
        }
    }
};
inline const RingMatrix ring_matrix;

inline void fill_powers(double x, double* powers) {
    double power = 1.0;
    for (std::size_t l = 0; l < degree_count; ++l) {
        powers[l] = power;
        power *= x;
    }
}

// Matrix onto[power in the piece][power in the ring, highest first]: maps the 16 coefficients of a piece's polynomial to the 8 of
// the polynomial equal to it at 8 points of a ring. powers_at(x, powers): writes powers of the piece's coordinate at x in the ring.
template <class Powers>
void resample(double* onto, const Powers& powers_at) {
    std::fill(onto, onto + degree_count * ring_degree, 0.0);
    double powers[degree_count];
    for (std::size_t j = 0; j < ring_degree; ++j) {
        powers_at(chebyshev_point(j, ring_degree), powers);
        for (std::size_t k = 0; k < ring_degree; ++k) {
            const double share = ring_matrix.at[k][j];
            for (std::size_t l = 0; l < degree_count; ++l) {
                onto[l * ring_degree + ring_degree - 1 - k] += powers[l] * share;
            }
        }
    }
}

// Map polynomial coefficients from a piece to a ring by the matrix `onto` (resample()), for a field U = sum over m of
// A_m(v) cos(m psi) + B_m(v) sin(m psi) and the rows (azimuthal orders m) `which`. Write the result to `out`, or add `weight` times
// the result if Add: out[row][re A_m, im A_m and, if `parts` is 4, re B_m, im B_m][power]. rows: coefficients on the piece.
template <bool Add, class I>
LOMMEL_INLINE void resample_rows(I, const double* onto, const double* rows, const std::vector<std::size_t>& which,
                                 std::size_t parts, double weight, double* out) {
    using V = typename I::pack;
    constexpr std::size_t packs = ring_degree / I::lanes;
    for (const std::size_t row : which) {
        const double* from = rows + row * 4 * degree_count;
        for (std::size_t part = 0; part < parts; ++part, from += degree_count, out += ring_degree) {
            V sums[2][packs] = {};
            for (std::size_t l = 0; l < degree_count; l += 2) {
                for (std::size_t j = 0; j < 2; ++j) {
                    const V c = splat<V>(from[l + j]);
                    for (std::size_t p = 0; p < packs; ++p) {
                        sums[j][p] = sums[j][p] + c * load<V>(onto + (l + j) * ring_degree + p * I::lanes);
                    }
                }
            }
            for (std::size_t p = 0; p < packs; ++p) {
                V total = sums[0][p] + sums[1][p];
                if constexpr (Add) {
                    total = load<V>(out + p * I::lanes) + splat<V>(weight) * total;
                }
                store(out + p * I::lanes, total);
            }
        }
    }
}

}  // namespace lommel
