// One piece (interval of v) of the Bessel table: polynomial interpolation of Bessel functions at Chebyshev points, for as many
// orders at once as a vector has lanes. A sum is kept as two doubles, a leading part without rounding error and a small rest, so
// results are as accurate as in a wider type (certificate, section 4).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

constexpr std::size_t degree_count = 16;  // coefficients of each polynomial

// Piece of the Bessel table (bessel_table.hpp). Row n: 2 (-1)^n J_{2n+1}(v) / v as 16 coefficients of powers of x = -1 .. 1 on the
// piece; negligible functions have no row. magnitude: bound on the sum of the moduli of all terms of the field U on the piece (see
// PieceTable).
struct Piece {
    Doubles rows;
    double magnitude = 0.0;
    std::size_t terms() const { return rows.size() / degree_count; }

    // left_out: bound on the contribution of the omitted rows to the field U, for any pupil; most(): number of rows that piece s
    // needs.
    static constexpr double left_out = 1e-19;
    static std::size_t most(double width, std::size_t s) { return window_terms(width * static_cast<double>(s + 1), left_out); }
};

// cos(k pi / 32) for k = 0 .. 16, as the sum of a multiple of 2^-24 and a remainder.
constexpr double cosines[17][2] = {{0x1p+0, 0.0},
                                   {0x1.fd88dap-1, 0x1.e89292cf04139p-28},
                                   {0x1.f6297cp-1, 0x1.feeb96055885dp-26},
                                   {0x1.e9f416p-1, -0x1.273a44b44fa71p-26},
                                   {0x1.d906bcp-1, 0x1.e651a8c515f98p-26},
                                   {0x1.c38b3p-1, -0x1.cfe849e5b82c6p-26},
                                   {0x1.a9b662p-1, 0x1.21d4346067d8cp-26},
                                   {0x1.8bc806p-1, 0x1.62a2e8169d0f7p-26},
                                   {0x1.6a09e6p-1, 0x1.9fcef32422cbfp-27},
                                   {0x1.44cf32p-1, 0x1.4247758601da9p-27},
                                   {0x1.1c73b4p-1, -0x1.9465cde4da22ep-27},
                                   {0x1.e2b5d4p-2, -0x1.fe4271387c9dcp-28},
                                   {0x1.87de2cp-2, -0x1.951569d2e59dcp-26},
                                   {0x1.294064p-2, -0x1.12a60fa574a37p-26},
                                   {0x1.8f8b8p-3, 0x1.e34d3055b25cdp-26},
                                   {0x1.917a7p-4, -0x1.0f592f50789c6p-26},
                                   {0.0, 0.0}};

// Conversion in two steps: values at 16 Chebyshev points to 8 times the coefficients of the Chebyshev polynomials, by sums and
// differences of mirrored points; then, by integer factors and a division by 8, to coefficients of 1, x, x^2, ...
class PieceRule {
   public:
    constexpr PieceRule() {
        monomials_[0][0] = monomials_[1][1] = 1.0;
        for (std::size_t i = 2; i < degree_count; ++i) {
            for (std::size_t k = 0; k < degree_count; ++k) {
                monomials_[i][k] = (k > 0 ? 2.0 * monomials_[i - 1][k - 1] : 0.0) - monomials_[i - 2][k];
            }
        }
        for (std::size_t i = 0; i < degree_count; ++i) {
            for (std::size_t j = 0; j < half; ++j) {
                const std::size_t turn = i * (2 * j + 1) % 64, k = std::min(turn, 64 - turn);
                for (std::size_t word = 0; word < 2; ++word) {
                    const double cosine = k <= 16 ? cosines[k][word] : -cosines[32 - k][word];
                    words_[word][i][j] = i == 0 ? 0.5 * cosine : cosine;
                }
            }
        }
    }

    // Chebyshev point j, in descending order, rounded to double.
    static constexpr double point(std::size_t j) {
        const std::size_t k = 2 * j + 1;
        return k <= 16 ? cosines[k][0] + cosines[k][1] : -(cosines[32 - k][0] + cosines[32 - k][1]);
    }

    // Convert `values` at the 16 points, each a vector over orders, to coefficients. For |values| <= 1 each coefficient is
    // rounded once, and the polynomial has a further error below 2^-66. The sums `exact` have no rounding error: they are
    // integers below 2^53 times a power of two, as values, cosines and coefficients are split at fixed powers of two.
    template <class V>
    LOMMEL_INLINE void operator()(const V* values, V* out) const {
        V high[2][half], low[2][half], both[2][half];
        for (std::size_t j = 0; j < half; ++j) {
            const V a = values[j], b = values[degree_count - 1 - j], ah = on_grid(a, 0x1.8p27), bh = on_grid(b, 0x1.8p27);
            high[0][j] = ah + bh;
            high[1][j] = ah - bh;
            low[0][j] = (a - ah) + (b - bh);
            low[1][j] = (a - ah) - (b - bh);
            both[0][j] = a + b;
            both[1][j] = a - b;
        }
        V first[degree_count], second[degree_count];
        for (std::size_t i = 0; i < degree_count; ++i) {
            V exact = splat<V>(0.0), rest = splat<V>(0.0);
            for (std::size_t j = 0; j < half; ++j) {
                const V c = splat<V>(words_[0][i][j]);
                exact = exact + c * high[i % 2][j];
                rest = rest + c * low[i % 2][j];
                rest = rest + splat<V>(words_[1][i][j]) * both[i % 2][j];
            }
            first[i] = on_grid(exact + rest, 0x1.8p20);
            second[i] = (exact - first[i]) + rest;
        }
        for (std::size_t k = 0; k < degree_count; ++k) {
            V exact = splat<V>(0.0), rest = splat<V>(0.0);
            for (std::size_t i = k; i < degree_count; i += 2) {
                const V m = splat<V>(monomials_[i][k]);
                exact = exact + m * first[i];
                rest = rest + m * second[i];
            }
            out[k] = splat<V>(0.125) * (exact + rest);
        }
    }

   private:
    static constexpr std::size_t half = degree_count / 2;

    template <class V>
    static LOMMEL_INLINE V on_grid(V x, double magic) {
        return (x + splat<V>(magic)) - splat<V>(magic);
    }

    double words_[2][degree_count][half] = {}, monomials_[degree_count][degree_count] = {};
};
inline constexpr PieceRule piece_rule;

// Compute values[16 n + point] = 2 (-1)^n J_{2n+1}(v) / v, as zernike_transforms() does, at the 16 points v of a piece, in
// descending order, for n < `terms`. The last point must be at least half the first, or else the backward recurrence overflows for
// orders that matter. `most`: number of terms that the piece needs; the recurrence starts beyond it whatever `terms` is, so that
// a value does not depend on `terms`.
template <class I>
LOMMEL_INLINE void piece_values(I isa, const double* points, std::size_t terms, std::size_t most, double* values) {
    using V = typename I::pack;
    constexpr std::size_t packs = degree_count / I::lanes;  // enough vectors at once to hide the latency of the recurrence
    const std::size_t count = 2 * terms, upwards = rising(points[degree_count - 1]);
    V at[packs], turn[packs], before[packs], here[packs];
    for (std::size_t p = 0; p < packs; ++p) {
        at[p] = load<V>(points + p * I::lanes);
        turn[p] = splat<V>(2.0) / at[p];
    }
    const auto step = [&](std::size_t order) LOMMEL_INLINE_LAMBDA {
        const V twice = splat<V>(2.0 * static_cast<double>(order));
        for (std::size_t p = 0; p < packs; ++p) {
            // Divide in every step: products with a rounded 1 / v would be accurate for a slightly different v.
            const V next = twice / at[p] * here[p] - before[p];
            before[p] = here[p];
            here[p] = next;
        }
    };
    // Store every second order, 2n + 1, as row n.
    const auto keep = [&](std::size_t order) LOMMEL_INLINE_LAMBDA {
        if (order % 2 != 0) {
            const std::size_t n = (order - 1) / 2;
            for (std::size_t p = 0; p < packs; ++p) {
                store(values + n * degree_count + p * I::lanes, (n % 2 == 0 ? turn[p] : splat<V>(0.0) - turn[p]) * here[p]);
            }
        }
    };
    if (upwards > 0) {
        for (std::size_t p = 0; p < packs; ++p) {
            const V v = load<V>(points + p * I::lanes);
            V sine, cosine;
            sincos(isa, v, sine, cosine);
            double roots[I::lanes];
            for (std::size_t i = 0; i < I::lanes; ++i) {
                roots[i] = std::sqrt(points[p * I::lanes + i]);
            }
            first_bessel(v, cosine, sine, load<V>(roots), before[p], here[p]);
        }
        for (std::size_t k = 1; k < std::min(count, upwards); ++k) {
            keep(k);
            step(k);
        }
        if (count <= upwards) {
            return;
        }
    }
    V sum[packs];
    for (std::size_t p = 0; p < packs; ++p) {
        before[p] = sum[p] = splat<V>(0.0);
        here[p] = splat<V>(1e-280);
    }
    for (std::size_t k = bessel_start(points[0], 2 * most); k > 0; --k) {
        if (upwards <= k && k < count) {
            keep(k);
        }
        for (std::size_t p = 0; p < packs; ++p) {
            sum[p] = k % 2 == 0 ? sum[p] + here[p] : sum[p];
        }
        step(k);
    }
    for (std::size_t p = 0; p < packs; ++p) {
        const V unit = splat<V>(1.0) / (here[p] + splat<V>(2.0) * sum[p]);
        for (std::size_t n = upwards / 2; n < terms; ++n) {
            double* value = values + n * degree_count + p * I::lanes;
            store(value, load<V>(value) * unit);
        }
    }
}

// Compute piece s of the Bessel table, width * s <= v <= width * (s + 1), with rows for the first `terms` functions.
inline Piece made_piece(double width, std::size_t s, std::size_t terms) {
    constexpr std::size_t m = degree_count;
    thread_local Doubles values;
    thread_local std::vector<double> scratch;
    Piece piece;
    piece.rows.resize(terms * m);
    values.assign((terms + row_lanes) * m, 0.0);  // padding orders of the last vector are zero
    const std::size_t most = Piece::most(width, s);
    double points[m];
    for (std::size_t j = 0; j < m; ++j) {
        points[j] = width * (static_cast<double>(s) + 0.5 * (1.0 + piece_rule.point(j)));
    }
    for (std::size_t j = 0; s == 0 && j < m; ++j) {  // near v = 0 the recurrence of piece_values() overflows
        std::vector<double> one(most);
        zernike_transforms(0, points[j], most, one.data(), scratch);
        for (std::size_t n = 0; n < terms; ++n) {
            values[n * m + j] = one[n];
        }
    }
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        using V = typename I::pack;
        if (s > 0) {
            piece_values(isa, points, terms, most, values.data());
        }
        V sums[m];
        for (std::size_t k = 0; k < m; ++k) {
            sums[k] = splat<V>(0.0);
        }
        for (std::size_t n = 0; n < terms; n += I::lanes) {
            alignas(64) double block[m][I::lanes];
            alignas(64) double weights[I::lanes];
            V in[m], out[m];
            for (std::size_t i = 0; i < I::lanes; ++i) {
                weights[i] = 2.0 * static_cast<double>(n + i) + 1.0;
                for (std::size_t j = 0; j < m; ++j) {
                    block[j][i] = values[(n + i) * m + j];
                }
            }
            for (std::size_t j = 0; j < m; ++j) {
                in[j] = load<V>(block[j]);
            }
            piece_rule(in, out);
            for (std::size_t k = 0; k < m; ++k) {
                sums[k] = sums[k] + load<V>(weights) * (out[k] * out[k]);
                store(block[k], out[k]);
            }
            for (std::size_t i = 0; i < std::min(I::lanes, terms - n); ++i) {
                for (std::size_t k = 0; k < m; ++k) {
                    piece.rows[(n + i) * m + k] = block[k][i];
                }
            }
        }
        for (std::size_t k = 0; k < m; ++k) {
            piece.magnitude += std::sqrt(lane_sum(sums[k]));
        }
    });
    return piece;
}

}  // namespace lommel
