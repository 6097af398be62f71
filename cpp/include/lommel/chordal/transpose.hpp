// Reverse-mode derivatives with respect to Zernike coefficients: the transpose of the Fourier transform takes weighted complex
// amplitudes of pixels to the pupil; the result times the pupil function and each Zernike term is summed over the pupil.
#pragma once

#include <algorithm>
#include <cstddef>

#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/chordal/factors.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"

namespace lommel {

// Transpose of multiply(): sum[k][c] += sum over r of table[k][r] * data[r][c] for k < count. data[r][c], sum[k][c]: SIMD vectors;
// pitch: number of values (Real) from sum[k] to sum[k + 1].
template <std::size_t R, std::size_t C, class V, class Real>
LOMMEL_INLINE void spread(const Real* table, const V (&data)[R][C], std::size_t count, std::size_t pitch, Real* sum) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
    for (std::size_t k = 0; k < count; ++k, table += R, sum += pitch) {
        V s[C];
        for (std::size_t c = 0; c < C; ++c) {
            s[c] = load<V>(sum + c * lanes);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const V t = splat<V>(table[r]);
            for (std::size_t c = 0; c < C; ++c) {
                s[c] = s[c] + t * data[r][c];
            }
        }
        for (std::size_t c = 0; c < C; ++c) {
            store(sum + c * lanes, s[c]);
        }
    }
}

// Transpose of the Fourier transform along x: pixels[row][column] -> chords[row][parity in x][chord], without -i for odd parity.
template <class I, class Real>
LOMMEL_INLINE void columns_transposed(I, const KernelTable<Real>& kernel, const Real* pixels, Real* chords) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t half = kernel.count.half_chords(), line = half * 2 * lanes;
    std::fill_n(chords, kernel.rows.count * 2 * line, Real(0));
    for (std::size_t y = 0; y < kernel.rows.count; ++y) {
        look();
        const Real* from = pixels + y * kernel.columns.count * 2 * lanes;
        Real* to = chords + y * 2 * line;
        for_fixed_tiles<column_tile>(kernel.columns.at.size(), [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t R = decltype(size)::value;
            V even[R][2], odd[R][2];
            for (std::size_t r = 0; r < R; ++r) {
                const std::size_t plus = kernel.columns.plus[first + r], minus = kernel.columns.minus[first + r];
                for (std::size_t part = 0; part < 2; ++part) {
                    const V here = load<V>(from + (2 * plus + part) * lanes);
                    const V there = minus == WindowAxis::none ? splat<V>(Real(0)) : load<V>(from + (2 * minus + part) * lanes);
                    even[r][part] = here + there;
                    odd[r][part] = here - there;
                }
            }
            spread<R, 2>(kernel.column_cos.data() + first * half, even, half, 2 * lanes, to);
            spread<R, 2>(kernel.column_sin.data() + first * half, odd, half, 2 * lanes, to + line);
        });
    }
}

// Transpose of the Fourier transform along y: chords[row][parity in x][chord] -> nodes[parity in y][node][parity in x].
template <class I, class Real>
LOMMEL_INLINE void rows_transposed(I, const KernelTable<Real>& kernel, std::size_t chord, const Real* chords, Real* nodes) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t line = kernel.count.half_chords() * 2 * lanes, rows = kernel.rows.at.size();
    const std::size_t within = kernel.count.half_nodes();
    std::fill_n(nodes, within * 8 * lanes, Real(0));
    for_row_tiles<V>(kernel, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        V even[R][4], odd[R][4];
        for (std::size_t r = 0; r < R; ++r) {
            const std::size_t plus = kernel.rows.plus[first + r], minus = kernel.rows.minus[first + r];
            for (std::size_t x = 0; x < 2; ++x) {
                V both[2][2];  // sum and difference of two rows at opposite distances from the axis, [re, im]
                for (std::size_t part = 0; part < 2; ++part) {
                    const std::size_t at = x * line + chord * 2 * lanes + part * lanes;
                    const V here = load<V>(chords + plus * 2 * line + at);
                    const V there = minus == WindowAxis::none ? splat<V>(Real(0)) : load<V>(chords + minus * 2 * line + at);
                    both[0][part] = here + there;
                    both[1][part] = here - there;
                }
                // Values of odd parity in x get the factor -i, values of odd parity in y another factor -i.
                const V nothing = splat<V>(Real(0));
                even[r][2 * x] = x == 0 ? both[0][0] : both[0][1];
                even[r][2 * x + 1] = x == 0 ? both[0][1] : nothing - both[0][0];
                odd[r][2 * x] = x == 0 ? both[1][1] : nothing - both[1][0];
                odd[r][2 * x + 1] = nothing - (x == 0 ? both[1][0] : both[1][1]);
            }
        }
        const std::size_t at = (chord * rows + first) * within;
        spread<R, 4>(kernel.row_cos.data() + at, even, within, 4 * lanes, nodes);
        spread<R, 4>(kernel.row_sin.data() + at, odd, within, 4 * lanes, nodes + within * 4 * lanes);
    });
}

// Add -2 * share * Im(sum of Z P G over the nodes of a pair of chords) to sums[index in table.classes.order]. Z: Zernike term; P
// (`pupil`): pupil function; G (`adjoint`): transposed Fourier transform of weight x conj(complex amplitude); share: 1 for the full
// disk, -(relative area of the obscuration) for the obscuration; room: working memory.
template <class I, class Real>
LOMMEL_INLINE void add_products(I, const FactorTable& table, std::size_t chord, const Real* pupil, const Real* adjoint,
                                Real share, Real* room, Real* sums) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes, together = 4;
    const std::size_t within = table.count.half_nodes(), odd = within * 4 * lanes;
    const auto part = [&](std::size_t k, std::size_t j) { return j / 2 * odd + (4 * k + j % 2 * 2) * lanes; };
    const V by = splat<V>(Real(-2) * share);
    for (std::size_t k = 0; k < within; ++k) {
        V re[4], im[4];
        for (std::size_t j = 0; j < 4; ++j) {
            re[j] = load<V>(adjoint + part(k, j));
            im[j] = load<V>(adjoint + part(k, j) + lanes);
        }
        V sum[4] = {};
        for (std::size_t j = 0; j < 4; ++j) {
            const V p = load<V>(pupil + part(k, j)), q = load<V>(pupil + part(k, j) + lanes);
            for (std::size_t parity = 0; parity < 4; ++parity) {
                const std::size_t other = (j / 2 ^ parity % 2) * 2 + (j % 2 ^ parity / 2);
                sum[parity] = sum[parity] + p * im[other] + q * re[other];
            }
        }
        for (std::size_t parity = 0; parity < 4; ++parity) {
            store(room + (parity * within + k) * lanes, sum[parity] * by);
        }
    }
    for (std::size_t parity = 0, term = 0; parity < 4; ++parity) {
        const Real* from = room + parity * within * lanes;
        // Sums of several terms at a time are independent, which hides the latency of additions.
        for (const std::size_t end = table.classes.ends[parity]; term < end;) {
            const std::size_t here = std::min(together, end - term);
            V sum[together] = {};
            const double* factor[together];
            for (std::size_t j = 0; j < together; ++j) {
                factor[j] = table.at(term + std::min(j, here - 1), chord);
            }
            for (std::size_t k = 0; k < within; ++k) {
                const V s = load<V>(from + k * lanes);
                for (std::size_t j = 0; j < together; ++j) {
                    sum[j] = sum[j] + splat<V>(static_cast<Real>(factor[j][k])) * s;
                }
            }
            for (std::size_t j = 0; j < here; ++j) {
                Real* to = sums + (term + j) * lanes;
                store(to, load<V>(to) + sum[j]);
            }
            term += here;
        }
    }
}

// Replace the complex amplitude u[pixel][re, im][lane] by weights[pixel][lane] x conj(u).
template <class I, class Real>
LOMMEL_INLINE void weigh_pixels(I, const Real* weights, std::size_t pixels, Real* u) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    for (std::size_t q = 0; q < pixels; ++q) {
        const V w = load<V>(weights + q * lanes);
        Real *re = u + 2 * q * lanes, *im = re + lanes;
        store(re, load<V>(re) * w);
        store(im, splat<V>(Real(0)) - load<V>(im) * w);
    }
}

}  // namespace lommel
