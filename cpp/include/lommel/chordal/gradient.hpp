// The gradient of a sum over pixels of weights times the intensity, by the coefficients of any number of Zernike terms, for the
// price of about two images: the transform of U, its transpose, and one sum over nodes for all terms.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "lommel/chordal/slopes.hpp"

namespace lommel {

// The transpose of the product along x: from pixels[row][column][re, im] to chords, as chordal_fields() lays them out.
template <class I>
LOMMEL_INLINE void transposed_columns(I, const KernelTable<double>& kernel, const double* pixels, double* chords) {
    using V = typename I::pack;
    constexpr std::size_t lanes = I::lanes;
    const std::size_t half = kernel.count.half_chords(), line = half * 2 * lanes;
    for (std::size_t y = 0; y < kernel.rows.count; ++y) {
        look();
        const double* row = pixels + y * kernel.columns.count * 2 * lanes;
        double *even = chords + y * 2 * line, *odd = even + line;
        std::fill_n(even, 2 * line, 0.0);
        for_fixed_tiles<column_tile>(kernel.columns.at.size(), [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t R = decltype(size)::value;
            V a[R][2], b[R][2];
            for (std::size_t r = 0; r < R; ++r) {
                const double* plus = row + kernel.columns.plus[first + r] * 2 * lanes;
                const V re = load<V>(plus), im = load<V>(plus + lanes);
                V re_minus = splat<V>(0.0), im_minus = re_minus;
                if (kernel.columns.minus[first + r] != WindowAxis::none) {
                    const double* minus = row + kernel.columns.minus[first + r] * 2 * lanes;
                    re_minus = load<V>(minus);
                    im_minus = load<V>(minus + lanes);
                }
                a[r][0] = re + re_minus;
                a[r][1] = im + im_minus;
                b[r][0] = im_minus - im;
                b[r][1] = re - re_minus;
            }
            const double *cosines = kernel.column_cos.data() + first * half, *sines = kernel.column_sin.data() + first * half;
            for (std::size_t i = 0; i < half; ++i, cosines += R, sines += R) {
                for (std::size_t part = 0; part < 2; ++part) {
                    double *to = even + (2 * i + part) * lanes, *on = odd + (to - even);
                    V e = load<V>(to), o = load<V>(on);
                    for (std::size_t r = 0; r < R; ++r) {
                        e = e + splat<V>(cosines[r]) * a[r][part];
                        o = o + splat<V>(sines[r]) * b[r][part];
                    }
                    store(to, e);
                    store(on, o);
                }
            }
        });
    }
}

// And of that along y, for one pair of chords: to [even, odd in y][node][even, odd in x][re, im].
template <class I>
LOMMEL_INLINE void transposed_rows(I, const KernelTable<double>& kernel, const double* chords, std::size_t chord,
                                   double* nodes) {
    using V = typename I::pack;
    constexpr std::size_t lanes = I::lanes;
    const std::size_t within = kernel.count.half_nodes(), line = kernel.count.half_chords() * 2 * lanes;
    const std::size_t rows = kernel.rows.at.size();
    std::fill_n(nodes, chord_values(kernel.count, lanes), 0.0);
    for_fixed_tiles<row_tile>(rows, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        V a[R][4], b[R][4];
        for (std::size_t r = 0; r < R; ++r) {
            const double* plus = chords + kernel.rows.plus[first + r] * 2 * line + chord * 2 * lanes;
            const bool paired = kernel.rows.minus[first + r] != WindowAxis::none;
            const double* minus = paired ? chords + kernel.rows.minus[first + r] * 2 * line + chord * 2 * lanes : nullptr;
            for (std::size_t x = 0; x < 2; ++x) {
                const V re = load<V>(plus + x * line), im = load<V>(plus + x * line + lanes);
                const V re_minus = paired ? load<V>(minus + x * line) : splat<V>(0.0);
                const V im_minus = paired ? load<V>(minus + x * line + lanes) : splat<V>(0.0);
                a[r][2 * x] = re + re_minus;
                a[r][2 * x + 1] = im + im_minus;
                b[r][2 * x] = im_minus - im;
                b[r][2 * x + 1] = re - re_minus;
            }
        }
        const std::size_t at = (chord * rows + first) * within;
        const double *cosines = kernel.row_cos.data() + at, *sines = kernel.row_sin.data() + at;
        for (std::size_t k = 0; k < within; ++k, cosines += R, sines += R) {
            for (std::size_t part = 0; part < 4; ++part) {
                double *to = nodes + (4 * k + part) * lanes, *on = to + within * 4 * lanes;
                V e = load<V>(to), o = load<V>(on);
                for (std::size_t r = 0; r < R; ++r) {
                    e = e + splat<V>(cosines[r]) * a[r][part];
                    o = o + splat<V>(sines[r]) * b[r][part];
                }
                store(to, e);
                store(on, o);
            }
        }
    });
}

class ChordalGradient : private ChordalCall {
   public:
    ChordalGradient(const DiskStack& stack, const DiskWindow& window, double tol, int threads,
                    const std::vector<ZernikeTerm>& factors, const double* weights, double* gradient)
        : ChordalCall(stack, window, tol, threads, false, factors), weights_(weights), gradient_(gradient) {}

    // weights[pupil][row][column], gradient[pupil][term].
    void run() {
        begin();
        std::vector<std::size_t> pupils(stack_.count);
        std::iota(pupils.begin(), pupils.end(), std::size_t{0});
        for (const std::size_t p : pupils) {
            const State& s = states_[p];
            choose(p, std::max(s.error, s.far.rounding + stack_.lost[p]), steepest(factors_));
        }
        sort(pupils);
        for_batches<double>(pupils.data(), pupils.size(),
                            [&](auto isa, const std::size_t* some, std::size_t here, const Tables<double>& outer,
                                const Tables<double>& inner) LOMMEL_INLINE_LAMBDA {
                                thread_local Scratch scratch;
                                batch(isa, some, here, outer, inner, scratch);
                            });
    }

   private:
    struct Scratch {
        ChordalScratch<double> transform;
        KeptWaves<double> waves[2];
        Doubles field, sums;  // U at the pixels, then weighted; of each term
    };

    template <class I>
    LOMMEL_INLINE void batch(I isa, const std::size_t* pupils, std::size_t here, const Tables<double>& outer,
                             const Tables<double>& inner, Scratch& scratch) {
        using V = typename I::pack;
        constexpr std::size_t lanes = I::lanes;
        const std::size_t width = columns_.count, pixels = rows_.count * width;
        ChordalScratch<double>& transform = scratch.transform;
        gather<I, double>(isa, stack_.outer, pupils, here, *outer.terms, transform.coefficients[0]);
        scratch.waves[0].fill(isa, *outer.terms, transform.coefficients[0]);
        if (area_ > 0.0) {
            gather<I, double>(isa, stack_.inner, pupils, here, *inner.terms, transform.coefficients[1]);
            scratch.waves[1].fill(isa, *inner.terms, transform.coefficients[1]);
        }
        scratch.field.resize(pixels * 2 * lanes);
        double* field = scratch.field.data();
        const auto waves = [&](const Tables<double>& tables, const KeptWaves<double>& kept) LOMMEL_INLINE_LAMBDA {
            return [&](std::size_t chord)
                       LOMMEL_INLINE_LAMBDA { return kept.values.data() + chord * chord_values(tables.terms->count, lanes); };
        };
        fields(
            isa, outer, inner, transform, waves(outer, scratch.waves[0]), waves(inner, scratch.waves[1]),
            [&](std::size_t y, std::size_t x, V re, V im) LOMMEL_INLINE_LAMBDA {
                double twice[lanes];
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    twice[lane] = 2.0 * weights_[pupils[std::min(lane, here - 1)] * pixels + y * width + x];
                }
                const V by = load<V>(twice);
                double* u = field + 2 * (y * width + x) * lanes;
                store(u, by * re);
                store(u + lanes, by * im);
            },
            [](std::size_t) LOMMEL_INLINE_LAMBDA {});
        scratch.sums.assign(factors_.size() * lanes, 0.0);
        sum_disk(isa, outer, scratch.waves[0], scratch);
        if (area_ > 0.0) {
            const V less = splat<V>(-area_);
            for (std::size_t j = 0; j < pixels * 2 * lanes; j += lanes) {
                store(field + j, less * load<V>(field + j));
            }
            sum_disk(isa, inner, scratch.waves[1], scratch);
        }
        for (std::size_t f = 0; f < factors_.size(); ++f) {
            for (std::size_t lane = 0; lane < here; ++lane) {
                gradient_[pupils[lane] * factors_.size() + f] = scratch.sums[f * lanes + lane];
            }
        }
    }

    // Adds what one disk has to the sums: of all nodes, Z times the part of conj(transposed field) i P that has its parity.
    template <class I>
    LOMMEL_INLINE void sum_disk(I isa, const Tables<double>& tables, const KeptWaves<double>& kept, Scratch& scratch) {
        using V = typename I::pack;
        constexpr std::size_t lanes = I::lanes;
        const ChordCount& count = tables.terms->count;
        const std::size_t within = count.half_nodes(), size = chord_values(count, lanes);
        ChordalScratch<double>& transform = scratch.transform;
        transform.chords.resize(rows_.count * 4 * count.half_chords() * lanes);
        transposed_columns(isa, *tables.kernel, scratch.field.data(), transform.chords.data());
        transform.nodes.resize(size);
        const double* back = transform.nodes.data();
        std::vector<Parity> parities(factors_.begin(), factors_.end());
        for (std::size_t chord = 0; chord < count.half_chords(); ++chord) {
            look();
            transposed_rows(isa, *tables.kernel, transform.chords.data(), chord, transform.nodes.data());
            const double* wave = kept.values.data() + chord * size;
            for (std::size_t k = 0; k < within; ++k) {
                V parts[2][2];  // [odd in y][odd in x]
                for (std::size_t odd_y = 0; odd_y < 2; ++odd_y) {
                    for (std::size_t odd_x = 0; odd_x < 2; ++odd_x) {
                        V sum = splat<V>(0.0);
                        for (std::size_t a = 0; a < 2; ++a) {
                            for (std::size_t b = 0; b < 2; ++b) {
                                const double* from = wave + (((odd_y ^ a) * within + k) * 4 + (odd_x ^ b) * 2) * lanes;
                                const double* to = back + ((a * within + k) * 4 + b * 2) * lanes;
                                sum = sum + load<V>(from) * load<V>(to + lanes) - load<V>(from + lanes) * load<V>(to);
                            }
                        }
                        parts[odd_y][odd_x] = sum;
                    }
                }
                for (std::size_t f = 0; f < factors_.size(); ++f) {
                    double* sum = scratch.sums.data() + f * lanes;
                    const V z = splat<V>(tables.factors->at(f, chord)[k]);
                    store(sum, load<V>(sum) + z * parts[parities[f].y][parities[f].x]);
                }
            }
        }
    }

    const double* weights_;
    double* gradient_;
};

}  // namespace lommel
