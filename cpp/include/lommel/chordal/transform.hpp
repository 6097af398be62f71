// Fourier transform of the pupil function on a disk, along y, then along x. Vector lanes are pupils, or chords of one pupil.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/chordal/tables.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// sum[r][c] += table[k][r] * data[k][c] over k; data[k][c]: SIMD vectors. R * C independent sums hide the latency of additions.
template <std::size_t R, std::size_t C, class V, class Real>
LOMMEL_INLINE void multiply(const Real* table, const Real* data, std::size_t count, V (&sum)[R][C]) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
    for (std::size_t k = 0; k < count; ++k, table += R, data += C * lanes) {
        V d[C];
        for (std::size_t c = 0; c < C; ++c) {
            d[c] = load<V>(data + c * lanes);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const V t = splat<V>(table[r]);
            for (std::size_t c = 0; c < C; ++c) {
                sum[r][c] = sum[r][c] + t * d[c];
            }
        }
    }
}

// Two products as in multiply(), with two tables and the same data.
template <std::size_t R, std::size_t C, class V, class Real>
LOMMEL_INLINE void multiply_both(const Real* table, const Real* other, const Real* data, std::size_t count, V (&sum)[R][C],
                                 V (&more)[R][C]) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
    for (std::size_t k = 0; k < count; ++k, table += R, other += R, data += C * lanes) {
        V d[C];
        for (std::size_t c = 0; c < C; ++c) {
            d[c] = load<V>(data + c * lanes);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const V t = splat<V>(table[r]), u = splat<V>(other[r]);
            for (std::size_t c = 0; c < C; ++c) {
                sum[r][c] = sum[r][c] + t * d[c];
                more[r][c] = more[r][c] + u * d[c];
            }
        }
    }
}

template <std::size_t N>
struct Size {
    static constexpr std::size_t value = N;
};

// As for_tiles(), but the size of a tile is a compile-time constant for f.
template <std::size_t Most, class F>
LOMMEL_INLINE void for_fixed_tiles(std::size_t count, const F& f) {
    static_assert(Most <= 6, "sizes up to five are below");
    for_tiles(count, Most, [&](std::size_t first, std::size_t size) LOMMEL_INLINE_LAMBDA {
        if (size == Most) {
            return f(first, Size<Most>{});
        }
        switch (size) {
            case 1:
                return f(first, Size<1>{});
            case 2:
                return f(first, Size<2>{});
            case 3:
                if constexpr (Most > 3)
                    return f(first, Size<3>{});
                break;
            case 4:
                if constexpr (Most > 4)
                    return f(first, Size<4>{});
                break;
            case 5:
                if constexpr (Most > 5)
                    return f(first, Size<5>{});
                break;
            default:
                break;
        }
    });
}

// Waves exp(i phase) for a vector of phases, in double precision.
template <class I, class Real>
struct Waves {
    using V = typename I::pack;
    using Phase = V;
    static constexpr std::size_t vectors = 1, lanes = I::lanes;
    static constexpr double unit = 1.0;  // phases are in radians
    static LOMMEL_INLINE V zero() { return splat<V>(0.0); }
    static LOMMEL_INLINE Phase phase(const V (&sum)[vectors]) { return sum[0]; }
    static LOMMEL_INLINE void wave(Phase x, V& sine, V& cosine) { sincos(I{}, x, sine, cosine); }
};

// Waves exp(i phase) in single precision. A phase is summed in double precision as an integer multiple of 2^-32 turns, held in the
// low bits of the mantissa: its lowest 32 bits are the phase modulo a turn. The phases of two vectors are packed into one.
template <class I>
struct Waves<I, float> {
    using V = typename I::floats;
    using Phase = typename I::turns;
    static constexpr std::size_t vectors = 2, lanes = 2 * I::lanes;
    static constexpr double unit = 683565275.57643158978;  // phases are in 2^-32 turns: 2^32 / (2 pi)

    // Sums of phases start at 1.5 * 2^52, where the spacing of doubles is 1: every sum is rounded to an integer.
    static LOMMEL_INLINE typename I::pack zero() { return splat<typename I::pack>(6755399441055744.0); }
    static LOMMEL_INLINE Phase phase(const typename I::pack (&sum)[vectors]) { return low_halves<Phase>(sum[0], sum[1]); }
    static LOMMEL_INLINE void wave(Phase x, V& sine, V& cosine) { sincos_turns(x, sine, cosine); }
};

// As multiply(), with chords in the vector lanes: table[k][r] is a SIMD vector too.
template <std::size_t R, std::size_t C, class V, class Real>
LOMMEL_INLINE void multiply_lanes(const Real* table, const Real* data, std::size_t count, V (&sum)[R][C]) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
    for (std::size_t k = 0; k < count; ++k, table += R * lanes, data += C * lanes) {
        V d[C];
        for (std::size_t c = 0; c < C; ++c) {
            d[c] = load<V>(data + c * lanes);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const V t = load<V>(table + r * lanes);
            for (std::size_t c = 0; c < C; ++c) {
                sum[r][c] = sum[r][c] + t * d[c];
            }
        }
    }
}

// Phases of chords: sum[r][c] += table[k][r][c] * coefficients[k], summed over the Zernike terms k. sum and table are SIMD vectors.
template <std::size_t R, std::size_t C, class V>
LOMMEL_INLINE void add_phases(const double* table, const double* coefficients, std::size_t count, V (&sum)[R][C]) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(double);
    for (std::size_t k = 0; k < count; ++k) {
        const V t = splat<V>(coefficients[k]);
        for (std::size_t r = 0; r < R; ++r) {
            for (std::size_t c = 0; c < C; ++c, table += lanes) {
                sum[r][c] = sum[r][c] + load<V>(table) * t;
            }
        }
    }
}

template <class I>
LOMMEL_INLINE typename I::pack weights_of(I, const double* from, double) {
    return load<typename I::pack>(from);
}
template <class I>
LOMMEL_INLINE typename I::floats weights_of(I, const double* from, float) {
    float narrow[2 * I::lanes];
    for (std::size_t lane = 0; lane < 2 * I::lanes; ++lane) {
        narrow[lane] = static_cast<float>(from[lane]);
    }
    return load<typename I::floats>(narrow);
}

// Weighted pupil function on a pair of chords at +-x: nodes[parity in y][node][parity in x][re, im], with parity 0 even, 1 odd.
// Vector lanes are pupils or, with `Lone`, pairs of chords of one pupil. `Own`: the weights are complex, TermTable::own.
template <bool Lone, bool Own, class I, class Real>
LOMMEL_INLINE void pair_of_chords(I isa, const TermTable& table, std::size_t chord, const double* coefficients, Real* nodes) {
    using Wave = Waves<I, Real>;
    using V = typename Wave::V;
    using Phase = typename Wave::Phase;
    constexpr std::size_t lanes = Wave::lanes, C = Wave::vectors;
    const std::size_t half = table.count.half_nodes(), terms = table.terms.size();
    Real *even = nodes, *odd = nodes + half * 4 * lanes;
    for_fixed_tiles<node_tile>(half, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        constexpr std::size_t side = Lone ? lanes : 1;
        const double* values = table.values.data() + (chord * half + first) * terms * side;
        Phase parts[4][R];
        for (std::size_t parity = 0, from = 0; parity < 4; from = table.classes.ends[parity], ++parity) {
            typename I::pack sums[R][C];
            for (std::size_t r = 0; r < R; ++r) {
                for (std::size_t c = 0; c < C; ++c) {
                    sums[r][c] = Wave::zero();
                }
            }
            const std::size_t count = table.classes.ends[parity] - from;
            if constexpr (Lone) {
                add_phases(values + from * R * lanes, coefficients + from, count, sums);
            } else {
                multiply<R, C>(values + from * R, coefficients + from * lanes, count, sums);
            }
            for (std::size_t r = 0; r < R; ++r) {
                parts[parity][r] = Wave::phase(sums[r]);
            }
        }
        for (std::size_t r = 0; r < R; ++r) {
            const Phase ee = parts[0][r], eo = parts[1][r], oe = parts[2][r], oo = parts[3][r];
            // The phases at (x, y), (x, -y), (-x, y), (-x, -y) are a + b, a - b, c + d, c - d: a and c are even in y, b and d odd.
            const Phase a = ee + oe, b = eo + oo, c = ee - oe, d = eo - oo;
            V re[4], im[4];
            Wave::wave(a + b, im[0], re[0]);
            Wave::wave(a - b, im[1], re[1]);
            Wave::wave(c + d, im[2], re[2]);
            Wave::wave(c - d, im[3], re[3]);
            const auto weight = [&](const double* from) LOMMEL_INLINE_LAMBDA {
                if constexpr (Lone) {
                    return weights_of(isa, from, Real());
                } else {
                    return splat<V>(static_cast<Real>(*from));
                }
            };
            const std::size_t node = (chord * half + first + r) * side;
            V w = splat<V>(Real(1));
            if constexpr (Own) {
                for (std::size_t q = 0; q < 4; ++q) {
                    const V a = weight(table.own.data() + 8 * node + 2 * q * side),
                            b = weight(table.own.data() + 8 * node + (2 * q + 1) * side), c = re[q], s = im[q];
                    re[q] = a * c - b * s;
                    im[q] = a * s + b * c;
                }
            } else {
                w = weight(table.weights.data() + node);
            }
            // e, o: parts even and odd in y at +x; f, q: parts even and odd in y at -x.
            const auto spread = [&](const V* p, std::size_t part) LOMMEL_INLINE_LAMBDA {
                const V e = (p[0] + p[1]) * w, f = (p[2] + p[3]) * w, o = (p[0] - p[1]) * w, q = (p[2] - p[3]) * w;
                Real *at = even + (first + r) * 4 * lanes + part * lanes, *on = odd + (at - even);
                store(at, e + f);
                store(at + 2 * lanes, e - f);
                store(on, o + q);
                store(on + 2 * lanes, o - q);
            };
            spread(re, 0);
            spread(im, 1);
        }
    });
}

// Call add(from, count, part) for blocks of `sum_block` terms of a sum of `count`, and add their sums `part` up: in single precision,
// long sums then lose fewer digits (ChordBound::sum_rounding).
template <std::size_t R, std::size_t C, class Real, class V, class F>
LOMMEL_INLINE void by_blocks(std::size_t count, V (&sum)[R][C], const F& add) {
    if (sizeof(Real) == sizeof(double) || count < 2 * sum_block) {
        return add(0, count, sum);
    }
    for (std::size_t from = 0; from < count; from += sum_block) {
        V part[R][C] = {};
        add(from, std::min(sum_block, count - from), part);
        for (std::size_t r = 0; r < R; ++r) {
            for (std::size_t c = 0; c < C; ++c) {
                sum[r][c] = sum[r][c] + part[r][c];
            }
        }
    }
}

// As multiply(), or multiply_lanes() if `Lone`, by blocks.
template <bool Lone, std::size_t R, std::size_t C, class V, class Real>
LOMMEL_INLINE void multiply_blocks(const Real* table, const Real* data, std::size_t count, V (&sum)[R][C]) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
    by_blocks<R, C, Real>(count, sum, [&](std::size_t from, std::size_t here, V(&part)[R][C]) LOMMEL_INLINE_LAMBDA {
        if constexpr (Lone) {
            multiply_lanes<R, C>(table + from * R * lanes, data + from * C * lanes, here, part);
        } else {
            multiply<R, C>(table + from * R, data + from * C * lanes, here, part);
        }
    });
}

// As for_fixed_tiles(), over the rows of a table in the tiles of its layout; V: SIMD vector.
template <class V, class Real, class F>
LOMMEL_INLINE void for_row_tiles(const KernelTable<Real>& kernel, const F& f) {
    if constexpr (sizeof(V) == 64) {
        if (kernel.lanes.rows == row_tile + 1) {
            return for_fixed_tiles<row_tile + 1>(kernel.rows.at.size(), f);
        }
    }
    for_fixed_tiles<row_tile>(kernel.rows.at.size(), f);
}

// Fourier transform along y for each row of pixels, from the nodes of a pair of chords (`Lone`: of a vector of pairs) to
// chords[row][parity in x][chord][re, im].
template <bool Lone, class I, class Real>
LOMMEL_INLINE void rows_of_chords(I, const KernelTable<Real>& kernel, std::size_t chord, const Real* nodes, Real* chords) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t rows = kernel.rows.at.size(), within = kernel.count.half_nodes();
    const std::size_t line = kernel.vectors() * 2 * lanes;
    for_row_tiles<V>(kernel, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        const std::size_t at = (chord * rows + first) * within * (Lone ? lanes : 1);
        V a[R][4] = {}, b[R][4] = {};
        multiply_blocks<Lone, R, 4>(kernel.row_cos.data() + at, nodes, within, a);
        multiply_blocks<Lone, R, 4>(kernel.row_sin.data() + at, nodes + within * 4 * lanes, within, b);
        for (std::size_t r = 0; r < R; ++r) {
            Real* to = chords + kernel.rows.plus[first + r] * 2 * line + chord * 2 * lanes;
            for (std::size_t x = 0; x < 2; ++x) {
                store(to + x * line, a[r][2 * x] + b[r][2 * x + 1]);
                store(to + x * line + lanes, a[r][2 * x + 1] - b[r][2 * x]);
            }
            if (kernel.rows.minus[first + r] != WindowAxis::none) {
                to = chords + kernel.rows.minus[first + r] * 2 * line + chord * 2 * lanes;
                for (std::size_t x = 0; x < 2; ++x) {
                    store(to + x * line, a[r][2 * x] - b[r][2 * x + 1]);
                    store(to + x * line + lanes, a[r][2 * x + 1] + b[r][2 * x]);
                }
            }
        }
    });
}

// Fourier transform along x, from chords to the complex amplitude along a row of pixels: row[column][re, im].
template <class I, class Real>
LOMMEL_INLINE void columns_of_row(I, const KernelTable<Real>& kernel, const Real* chords, Real* row) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t half = kernel.count.half_chords(), line = half * 2 * lanes;
    for_fixed_tiles<column_tile>(kernel.columns.at.size(), [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        V a[R][2] = {}, b[R][2] = {};
        multiply_blocks<false, R, 2>(kernel.column_cos.data() + first * half, chords, half, a);
        multiply_blocks<false, R, 2>(kernel.column_sin.data() + first * half, chords + line, half, b);
        for (std::size_t r = 0; r < R; ++r) {
            Real* to = row + kernel.columns.plus[first + r] * 2 * lanes;
            store(to, a[r][0] + b[r][1]);
            store(to + lanes, a[r][1] - b[r][0]);
            if (kernel.columns.minus[first + r] != WindowAxis::none) {
                to = row + kernel.columns.minus[first + r] * 2 * lanes;
                store(to, a[r][0] - b[r][1]);
                store(to + lanes, a[r][1] + b[r][0]);
            }
        }
    });
}

// As columns_of_row() for a single pupil, with chords in the vector lanes: row[vector of columns][re, im], 0 after the last column.
template <class I, class Real>
LOMMEL_INLINE void lone_columns_of_row(I, const KernelTable<Real>& kernel, const Real* chords, Real* row) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t half = kernel.count.half_chords(), line = kernel.vectors() * 2 * lanes, across = kernel.columns.at.size();
    const std::size_t last = (kernel.columns.count - 1) / lanes * 2 * lanes;
    store(row + last, splat<V>(Real(0)));
    store(row + last + lanes, splat<V>(Real(0)));
    for_fixed_tiles<2>(kernel.lanes.vectors(across), [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        V both[R][4] = {};
        by_blocks<R, 4, Real>(half, both, [&](std::size_t from, std::size_t count, V(&part)[R][4]) LOMMEL_INLINE_LAMBDA {
            for (std::size_t i = from; i < from + count; ++i) {
                const Real* const even = chords + (i - i % lanes) * 2 + i % lanes;
                const V e[2] = {splat<V>(even[0]), splat<V>(even[lanes])};
                const V o[2] = {splat<V>(even[line]), splat<V>(even[line + lanes])};
                for (std::size_t r = 0; r < R; ++r) {
                    const std::size_t at = ((first + r) * half + i) * lanes;
                    const V cosine = load<V>(kernel.column_cos.data() + at), sine = load<V>(kernel.column_sin.data() + at);
                    part[r][0] = part[r][0] + cosine * e[0];
                    part[r][1] = part[r][1] + cosine * e[1];
                    part[r][2] = part[r][2] + sine * o[0];
                    part[r][3] = part[r][3] + sine * o[1];
                }
            }
        });
        for (std::size_t r = 0; r < R; ++r) {
            const V *const a = both[r], *const b = both[r] + 2;
            Real here[2][2 * lanes];
            store(here[0], a[0] + b[1]);
            store(here[0] + lanes, a[1] - b[0]);
            store(here[1], a[0] - b[1]);
            store(here[1] + lanes, a[1] + b[0]);
            const std::size_t from = (first + r) * lanes;
            for (std::size_t side = 0; side < 2; ++side) {
                const std::vector<std::size_t>& places = side == 0 ? kernel.columns.plus : kernel.columns.minus;
                for (std::size_t lane = 0; lane < std::min(lanes, across - from); ++lane) {
                    const std::size_t x = places[from + lane];
                    if (x != WindowAxis::none) {
                        Real* const to = row + (x - x % lanes) * 2 + x % lanes;
                        to[0] = here[side][lane];
                        to[lanes] = here[side][lanes + lane];
                    }
                }
            }
        }
    });
}

// Fourier transform along y of a part of the pupil function that is even or odd in y: from nodes[node][re, im] on a pair of chords
// to chords[distance of a row from the axis][chord][re, im]. Odd parts use sines and omit the factor -i.
template <class I, class Real>
LOMMEL_INLINE void rows_of_parity(I, const KernelTable<Real>& kernel, std::size_t chord, bool odd, const Real* nodes,
                                  Real* chords) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t rows = kernel.rows.at.size(), within = kernel.count.half_nodes(), line = kernel.vectors() * 2 * lanes;
    const Real* table = (odd ? kernel.row_sin : kernel.row_cos).data() + chord * rows * within;
    const auto put = [&](std::size_t row, const V(&sum)[2]) LOMMEL_INLINE_LAMBDA {
        Real* to = chords + row * line + chord * 2 * lanes;
        store(to, sum[0]);
        store(to + lanes, sum[1]);
    };
    // Two full tiles of rows at a time give more independent sums, which hide the latency of multiply-adds.
    std::size_t held = WindowAxis::none;
    for_row_tiles<V>(kernel, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        if (held == WindowAxis::none && R == kernel.lanes.rows && rows % R == 0 && first + 2 * R <= rows) {
            held = first;
            return;
        }
        if (held != WindowAxis::none) {
            V a[R][2] = {}, b[R][2] = {};
            multiply_both<R, 2>(table + held * within, table + first * within, nodes, within, a, b);
            for (std::size_t r = 0; r < R; ++r) {
                put(held + r, a[r]);
                put(first + r, b[r]);
            }
            held = WindowAxis::none;
            return;
        }
        V a[R][2] = {};
        multiply<R, 2>(table + first * within, nodes, within, a);
        for (std::size_t r = 0; r < R; ++r) {
            put(first + r, a[r]);
        }
    });
}

// Fourier transform along x of a part of the pupil function that is even or odd in x: from chords[chord][re, im] to row[distance
// of a column from the axis][re, im]. Odd parts use sines and omit the factor -i.
template <class I, class Real>
LOMMEL_INLINE void columns_of_parity(I, const KernelTable<Real>& kernel, bool odd, const Real* chords, Real* row) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t half = kernel.count.half_chords();
    const Real* table = (odd ? kernel.column_sin : kernel.column_cos).data();
    for_fixed_tiles<column_tile>(kernel.columns.at.size(), [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        V a[R][2] = {};
        multiply<R, 2>(table + first * half, chords, half, a);
        for (std::size_t r = 0; r < R; ++r) {
            store(row + (first + r) * 2 * lanes, a[r][0]);
            store(row + ((first + r) * 2 + 1) * lanes, a[r][1]);
        }
    });
}

// Intensity |u|^2 along a row, with u the complex amplitude. top: running maximum of the intensity in each vector lane.
template <class I, class Real>
LOMMEL_INLINE void intensities_of_row(I, const Real* u, std::size_t columns, Real* intensity, Real* top) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    V most = load<V>(top);
    for (std::size_t x = 0; x < columns; ++x) {
        const V re = load<V>(u + 2 * x * lanes), im = load<V>(u + (2 * x + 1) * lanes);
        const V i = re * re + im * im;
        most = larger(most, i);
        store(intensity + x * lanes, i);
    }
    store(top, most);
}

// Subtract the obscuration's field `inner`, times its relative area, from u. count: number of vectors.
template <class I, class Real>
LOMMEL_INLINE void subtract(I, const Real* inner, Real area, std::size_t count, Real* u) {
    using V = typename Waves<I, Real>::V;
    for (std::size_t j = 0; j < count * Waves<I, Real>::lanes; j += Waves<I, Real>::lanes) {
        store(u + j, load<V>(u + j) - load<V>(inner + j) * splat<V>(area));
    }
}

}  // namespace lommel
