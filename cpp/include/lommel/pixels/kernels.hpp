// Inner loops of pixel averages: weights, weighted sums, and azimuthal harmonics.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "lommel/base/simd.hpp"

namespace lommel {

using RadialDegree = std::integral_constant<std::size_t, 16>;
constexpr std::size_t radial_degree = RadialDegree::value;  // number of Chebyshev coefficients in the distance, for one ring
constexpr std::size_t block_outputs = 16;  // number of output values in one block of weights

// The number of quadrature points in a pixel is padded to a multiple of this, the lanes of two of the widest vectors.
constexpr std::size_t position_step = 2 * row_lanes;

// Compute row[k] such that sum_i share[i] f(z[i]) = sum_k row[k] f(nodes[k]) for every polynomial f of degree below `count`.
// The Lagrange polynomial of node k is scale[k] times the product of 2 (z - nodes[j]) over j != k, a form without cancellation;
// scale[k] = 1 / product of 2 (nodes[k] - nodes[j]). positions: number of points z, including padding points, whose share is 0.
// scratch: room for 3 * count vectors. Four chains of products overlap to hide their latency.
template <class I>
LOMMEL_INLINE void lagrange_row(I, const double* z, const double* share, std::size_t positions, const double* nodes,
                                const double* scale, std::size_t count, double* scratch, double* row) {
    using V = typename I::pack;
    constexpr std::size_t lanes = I::lanes;
    double* sums = scratch + 2 * count * lanes;
    std::fill_n(sums, count * lanes, 0.0);
    const std::size_t half = count / 2;
    for (std::size_t i = 0; i < positions; i += 2 * lanes) {
        V twice[2], below[2], above[2];  // twice: 2 z; below: share * product of 2 (z - nodes[j]), j < n; above: j >= count - n
        for (std::size_t u = 0; u < 2; ++u) {
            twice[u] = load<V>(z + i + u * lanes) * splat<V>(2.0);
            below[u] = load<V>(share + i + u * lanes);
            above[u] = splat<V>(1.0);
        }
        const auto advance = [&](std::size_t low, std::size_t high) LOMMEL_INLINE_LAMBDA {
            const V a = splat<V>(2.0 * nodes[low]), b = splat<V>(2.0 * nodes[high]);
            for (std::size_t u = 0; u < 2; ++u) {
                below[u] = below[u] * (twice[u] - a);
                above[u] = above[u] * (twice[u] - b);
            }
        };
        const auto add = [&](std::size_t n, V value)
                             LOMMEL_INLINE_LAMBDA { store(sums + n * lanes, load<V>(sums + n * lanes) + value); };
        for (std::size_t n = 0; n < half; ++n) {
            const std::size_t other = count - 1 - n;
            for (std::size_t u = 0; u < 2; ++u) {
                store(scratch + (2 * n + u) * lanes, below[u]);
                store(scratch + (2 * other + u) * lanes, above[u]);
            }
            advance(n, other);
        }
        if (count % 2 == 1) {
            add(half, below[0] * above[0] + below[1] * above[1]);
            advance(half, half);
        }
        for (std::size_t n = count - half; n < count; ++n) {
            const std::size_t other = count - 1 - n;
            const double *stored = scratch + 2 * n * lanes, *mirrored = scratch + 2 * other * lanes;
            add(n, below[0] * load<V>(stored) + below[1] * load<V>(stored + lanes));
            add(other, above[0] * load<V>(mirrored) + above[1] * load<V>(mirrored + lanes));
            advance(n, other);
        }
    }
    for (std::size_t n = 0; n < count; ++n) {
        row[n] = scale[n] * lane_sum(load<V>(sums + n * lanes));
    }
}

// Compute sums[p][offset + output] for `Together` pupils p and one block of outputs: the sum over nodes of intensity[p][node] times
// weights[node][output]. Speed is limited by reading the weights, once for all pupils.
template <std::size_t Together, class I>
LOMMEL_INLINE void weighted_sums(I, const double* weights, std::size_t nodes, const double* const* intensity,
                                 double* const* sums, std::size_t offset) {
    using V = typename I::pack;
    constexpr std::size_t packs = Together == 1 && 4 * I::lanes <= block_outputs ? 4 : 2;
    constexpr std::size_t chains = Together == 1 ? 2 : 1;  // number of independent sums, whose multiply-adds overlap
    for (std::size_t j = 0; j < block_outputs; j += packs * I::lanes) {
        V sum[Together][chains][packs] = {};
        const auto add = [&](std::size_t chain, std::size_t n) LOMMEL_INLINE_LAMBDA {
            V row[packs];
            for (std::size_t k = 0; k < packs; ++k) {
                row[k] = load<V>(weights + n * block_outputs + j + k * I::lanes);
            }
            for (std::size_t p = 0; p < Together; ++p) {
                const V value = splat<V>(intensity[p][n]);
                for (std::size_t k = 0; k < packs; ++k) {
                    sum[p][chain][k] = sum[p][chain][k] + value * row[k];
                }
            }
        };
        std::size_t n = 0;
        for (; n + chains <= nodes; n += chains) {
            for (std::size_t c = 0; c < chains; ++c) {
                add(c, n + c);
            }
        }
        for (; n < nodes; ++n) {
            add(0, n);
        }
        for (std::size_t p = 0; p < Together; ++p) {
            for (std::size_t k = 0; k < packs; ++k) {
                V total = sum[p][0][k];
                for (std::size_t c = 1; c < chains; ++c) {
                    total = total + sum[p][c][k];
                }
                store(sums[p] + offset + j + k * I::lanes, total);
            }
        }
    }
}

// Rounding error of a series, in roundoffs: sum of |coefficients[k]| * penalty[k]; penalty[k]: the error if coefficient k is 1.
template <class I>
LOMMEL_INLINE double weighted_size(I, const double* coefficients, const double* penalty, std::size_t count) {
    using V = typename I::pack;
    V sum = splat<V>(0.0);
    for (std::size_t k = 0; k < count; k += I::lanes) {
        const V c = load<V>(coefficients + k);
        sum = sum + larger(c, splat<V>(0.0) - c) * load<V>(penalty + k);
    }
    return lane_sum(sum);
}

// Evaluate the radial polynomials of `Orders` harmonics at `Vectors` vectors of pixels, by Clenshaw's recurrence. A polynomial
// has `degree` coefficients: of the Chebyshev polynomials T_k(x) or, if `Odd`, of T_(2k+1)(r) / r with x = 2 r^2 - 1.
template <std::size_t Orders, std::size_t Vectors, bool Odd = false, class Degree, class V>
LOMMEL_INLINE void along_radius(Degree degree, const double* coefficients, const V (&x)[Vectors], V (&out)[Orders][Vectors]) {
    V now[Orders][Vectors], before[Orders][Vectors] = {}, twice[Vectors];
    for (std::size_t u = 0; u < Vectors; ++u) {
        twice[u] = x[u] + x[u];
    }
    for (std::size_t j = 0; j < Orders; ++j) {
        for (std::size_t u = 0; u < Vectors; ++u) {
            now[j][u] = splat<V>(coefficients[j * degree + degree - 1]);
        }
    }
    const auto step = [&](std::size_t k, const V(&last)[Orders][Vectors], V(&next)[Orders][Vectors]) LOMMEL_INLINE_LAMBDA {
        for (std::size_t j = 0; j < Orders; ++j) {
            const V c = splat<V>(coefficients[j * degree + k]);
            for (std::size_t u = 0; u < Vectors; ++u) {
                next[j][u] = twice[u] * last[j][u] + (c - next[j][u]);
            }
        }
    };
    // Two steps of the recurrence per iteration, so that `now` need not be copied to `before`.
    std::size_t k = degree - 2;
    for (; k > 1; k -= 2) {
        step(k, now, before);
        step(k - 1, before, now);
    }
    if (k == 1) {
        step(1, now, before);
        std::swap(now, before);
    }
    for (std::size_t j = 0; j < Orders; ++j) {
        const V c = splat<V>(coefficients[j * degree]);
        for (std::size_t u = 0; u < Vectors; ++u) {
            out[j][u] = (Odd ? twice[u] - splat<V>(1.0) : x[u]) * now[j][u] + (c - before[j][u]);
        }
    }
}

// Sum a Chebyshev series at `count` pixels, in whole groups of four vectors: out[i] = sum over k of coefficients[k] T_k(x[i]).
template <class I>
LOMMEL_INLINE void sum_profile(I, std::size_t degree, const double* coefficients, const double* x, std::size_t count,
                               double* out) {
    using V = typename I::pack;
    for (std::size_t i = 0; i < count; i += 4 * I::lanes) {
        V at[4], values[1][4];
        for (std::size_t u = 0; u < 4; ++u) {
            at[u] = load<V>(x + i + u * I::lanes);
        }
        along_radius<1>(degree, coefficients, at, values);
        for (std::size_t u = 0; u < 4; ++u) {
            store(out + i + u * I::lanes, values[0][u]);
        }
    }
}

// Call take(values) for each harmonic, lowest first, with the values of its radial polynomial at two vectors of pixels.
template <bool Odd, class I, class Degree, class V, class Take>
LOMMEL_INLINE void each_harmonic(I, Degree degree, const double* coefficients, std::size_t harmonics, const V (&at)[2],
                                 const Take& take) {
    std::size_t j = 0;
    const auto add_orders = [&](auto orders) LOMMEL_INLINE_LAMBDA {
        V values[orders][2];
        along_radius<orders, 2, Odd>(degree, coefficients + j * degree, at, values);
        for (const auto& value : values) {
            take(value);
        }
        j += orders;
    };
    // `add_orders` advances j, which clang-tidy does not see. NOLINTBEGIN(bugprone-infinite-loop)
    // Two to four harmonics at a time: one alone is a chain of dependent operations; four only with 32 registers (8 lanes).
    if constexpr (I::lanes == 8) {
        while (harmonics - j == 4 || harmonics - j > 6) {
            add_orders(std::integral_constant<std::size_t, 4>{});
        }
    }
    while (harmonics - j == 3 || harmonics - j > 4) {
        add_orders(std::integral_constant<std::size_t, 3>{});
    }
    while (j + 1 < harmonics) {
        add_orders(std::integral_constant<std::size_t, 2>{});
    }
    // NOLINTEND(bugprone-infinite-loop)
    if (j < harmonics) {
        add_orders(std::integral_constant<std::size_t, 1>{});
    }
}

// Sum angular harmonics at `count` pixels of a ring. coefficients[harmonic][degree]; x: radial position in the ring, -1 to 1;
// cosine: cos(4 theta) with the polar angle theta. Speed is limited by arithmetic.
template <class I, class Degree>
LOMMEL_INLINE void sum_harmonics(I isa, Degree degree, const double* coefficients, std::size_t harmonics, const double* x,
                                 const double* cosine, std::size_t count, double* out) {
    using V = typename I::pack;
    for (std::size_t i = 0; i < count; i += 2 * I::lanes) {
        const V at[2] = {load<V>(x + i), load<V>(x + i + I::lanes)};
        const V angle[2] = {load<V>(cosine + i), load<V>(cosine + i + I::lanes)};
        // now, before: Chebyshev polynomials T_j and T_(j-1) of cos(4 theta) for harmonic j; T_(-1) = T_1.
        V now[2], before[2], sum[2];
        for (std::size_t u = 0; u < 2; ++u) {
            now[u] = splat<V>(1.0);
            before[u] = angle[u];
            sum[u] = splat<V>(0.0);
        }
        each_harmonic<false>(isa, degree, coefficients, harmonics, at, [&](const V(&value)[2]) LOMMEL_INLINE_LAMBDA {
            for (std::size_t u = 0; u < 2; ++u) {
                sum[u] = sum[u] + value[u] * now[u];
                const V next = (angle[u] + angle[u]) * now[u] - before[u];
                before[u] = now[u];
                now[u] = next;
            }
        });
        store(out + i, sum[0]);
        store(out + i + I::lanes, sum[1]);
    }
}

// Sum harmonics of odd order. across: sum over j, k of coefficients[j][k] T_(2k+1)(r) / r cos((2j+1) theta) / cos(theta), with
// Chebyshev polynomials T, r^2 = (1 + x[i]) / 2 and theta the polar angle from the direction of the rows; down: the same, with
// theta from the direction of the columns. cosine: cos(2 theta), theta as for `across`. Speed is limited by arithmetic.
template <class I, class Degree>
LOMMEL_INLINE void sum_odd_harmonics(I isa, Degree degree, const double* coefficients, std::size_t harmonics, const double* x,
                                     const double* cosine, std::size_t count, double* across, double* down) {
    using V = typename I::pack;
    for (std::size_t i = 0; i < count; i += 2 * I::lanes) {
        const V at[2] = {load<V>(x + i), load<V>(x + i + I::lanes)};
        V twice[2], now[2][2], before[2][2], sum[2][2];
        for (std::size_t u = 0; u < 2; ++u) {
            const V angle = load<V>(cosine + i + u * I::lanes);
            twice[u] = angle + angle;
            for (std::size_t way = 0; way < 2; ++way) {
                now[way][u] = before[way][u] = splat<V>(1.0);
                sum[way][u] = splat<V>(0.0);
            }
        }
        each_harmonic<true>(isa, degree, coefficients, harmonics, at, [&](const V(&value)[2]) LOMMEL_INLINE_LAMBDA {
            for (std::size_t u = 0; u < 2; ++u) {
                for (std::size_t way = 0; way < 2; ++way) {
                    sum[way][u] = sum[way][u] + value[u] * now[way][u];
                    const V turned = twice[u] * now[way][u];
                    const V next = (way == 0 ? turned : splat<V>(0.0) - turned) - before[way][u];
                    before[way][u] = now[way][u];
                    now[way][u] = next;
                }
            }
        });
        for (std::size_t u = 0; u < 2; ++u) {
            store(across + i + u * I::lanes, sum[0][u]);
            store(down + i + u * I::lanes, sum[1][u]);
        }
    }
}

}  // namespace lommel
