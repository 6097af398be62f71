// Stacks of small windows of any wavefront by two matrix products: the chordal Gauss rule on the disk, along y, then
// along x. Pupils lie side by side in the lanes of vectors, so that tables are read once for all of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "lommel/chordal_tables.hpp"
#include "lommel/parallel.hpp"
#include "lommel/sincos.hpp"

namespace lommel {

constexpr double max_table_bytes = 268435456.0;  // of the kernel for one window

struct ChordalStack {
    std::vector<ZernikeTerm> terms;
    const double* outer;  // [pupil][term], radians at the edge
    const double* inner;  // the same for the obscured disk, its edge being the obscuration's; not read if there is none
    std::size_t count;
    double obscuration, gaussian;
};

struct ChordalWindow {
    std::size_t height, width;
    double center_row, center_column, step;  // pixels, pixels, v a pixel
};

// For each pupil: the image, what the intensity was multiplied by (0 on entry: divide by the largest value instead),
// and the bound on the error over the largest value of the window.
template <class T>
struct ChordalAnswer {
    T* images;
    double* scales;
    double* bounds;
};

// sum += table[k][r] * data[k][c] for every vector c of `data`: R * C chains of multiply-adds.
template <std::size_t R, std::size_t C, class I>
LOMMEL_INLINE void multiply(I, const double* table, const double* data, std::size_t count,
                            typename I::pack (&sum)[R][C]) {
    using V = typename I::pack;
    for (std::size_t r = 0; r < R; ++r) {
        for (std::size_t c = 0; c < C; ++c) {
            sum[r][c] = splat<V>(0.0);
        }
    }
    for (std::size_t k = 0; k < count; ++k, table += R, data += C * I::lanes) {
        V d[C];
        for (std::size_t c = 0; c < C; ++c) {
            d[c] = load<V>(data + c * I::lanes);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const V t = splat<V>(table[r]);
            for (std::size_t c = 0; c < C; ++c) {
                sum[r][c] = sum[r][c] + t * d[c];
            }
        }
    }
}

template <std::size_t N>
struct Size {
    static constexpr std::size_t value = N;
};

// for_tiles with the size known when compiling.
template <std::size_t Most, class F>
LOMMEL_INLINE void for_fixed_tiles(std::size_t count, const F& f) {
    for_tiles(count, Most, [&](std::size_t first, std::size_t size) LOMMEL_INLINE_LAMBDA {
        if (size == Most) {
            return f(first, Size<Most>{});
        }
        switch (size) {
            case 1: return f(first, Size<1>{});
            case 2: return f(first, Size<2>{});
            case 3: if constexpr (Most > 3) return f(first, Size<3>{}); break;
            case 4: if constexpr (Most > 4) return f(first, Size<4>{}); break;
            case 5: if constexpr (Most > 5) return f(first, Size<5>{}); break;
            default: break;
        }
    });
}

// One disk for as many pupils as a vector has lanes.
struct ChordalScratch {
    Doubles coefficients, nodes, chords, row, inner, intensity;
};

// The pupil function of a pair of chords at +-x: nodes[even, odd in y][node][even, odd in x][re, im], weighted. Bound
// by the sines.
template <class I>
LOMMEL_INLINE void pair_of_chords(I isa, const TermTable& table, std::size_t chord, const double* coefficients,
                                  double* nodes) {
    using V = typename I::pack;
    constexpr std::size_t lanes = I::lanes;
    const std::size_t half = table.half, terms = table.order.size();
    double *even = nodes, *odd = nodes + half * 4 * lanes;
    for_fixed_tiles<node_tile>(half, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        const double* values = table.values.data() + (chord * half + first) * terms;
        V parts[4][R][1];
        for (std::size_t parity = 0, from = 0; parity < 4; from = table.ends[parity], ++parity) {
            multiply<R, 1>(isa, values + from * R, coefficients + from * lanes, table.ends[parity] - from, parts[parity]);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const V ee = parts[0][r][0], eo = parts[1][r][0], oe = parts[2][r][0], oo = parts[3][r][0];
            const V a = ee + oe, b = eo + oo, c = ee - oe, d = eo - oo;  // at +x: even, odd in y; at -x
            V re[4], im[4];
            sincos(isa, a + b, im[0], re[0]);
            sincos(isa, a - b, im[1], re[1]);
            sincos(isa, c + d, im[2], re[2]);
            sincos(isa, c - d, im[3], re[3]);
            const V w = splat<V>(table.weights[chord * half + first + r]);
            const auto spread = [&](const V* p, std::size_t part) LOMMEL_INLINE_LAMBDA {
                const V e = (p[0] + p[1]) * w, f = (p[2] + p[3]) * w, o = (p[0] - p[1]) * w, q = (p[2] - p[3]) * w;
                double *at = even + (first + r) * 4 * lanes + part * lanes, *on = odd + (at - even);
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

// U at every pixel, row by row, as sink(row, values[column][re, im]).
template <class I, class Sink>
LOMMEL_INLINE void chordal_fields(I isa, const TermTable& terms, const KernelTable& kernel, ChordalScratch& scratch,
                                  const Sink& sink) {
    using V = typename I::pack;
    constexpr std::size_t lanes = I::lanes;
    const std::size_t half = kernel.half, rows = kernel.rows.at.size(), columns = kernel.columns.at.size();
    const std::size_t line = half * 2 * lanes;  // of chords[row][even, odd in x][chord][re, im]
    scratch.nodes.resize(2 * half * 4 * lanes);
    scratch.chords.resize(kernel.rows.count * 2 * line);
    scratch.row.resize(kernel.columns.count * 2 * lanes);
    double *nodes = scratch.nodes.data(), *chords = scratch.chords.data(), *row = scratch.row.data();
    for (std::size_t i = 0; i < half; ++i) {
        pair_of_chords(isa, terms, i, scratch.coefficients.data(), nodes);
        for_fixed_tiles<row_tile>(rows, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t R = decltype(size)::value;
            const std::size_t at = (i * rows + first) * half;
            V a[R][4], b[R][4];
            multiply<R, 4>(isa, kernel.row_cos.data() + at, nodes, half, a);
            multiply<R, 4>(isa, kernel.row_sin.data() + at, nodes + half * 4 * lanes, half, b);
            for (std::size_t r = 0; r < R; ++r) {
                double* to = chords + kernel.rows.plus[first + r] * 2 * line + i * 2 * lanes;
                for (std::size_t x = 0; x < 2; ++x) {
                    store(to + x * line, a[r][2 * x] + b[r][2 * x + 1]);
                    store(to + x * line + lanes, a[r][2 * x + 1] - b[r][2 * x]);
                }
                if (kernel.rows.minus[first + r] != WindowAxis::none) {
                    to = chords + kernel.rows.minus[first + r] * 2 * line + i * 2 * lanes;
                    for (std::size_t x = 0; x < 2; ++x) {
                        store(to + x * line, a[r][2 * x] - b[r][2 * x + 1]);
                        store(to + x * line + lanes, a[r][2 * x + 1] + b[r][2 * x]);
                    }
                }
            }
        });
    }
    for (std::size_t y = 0; y < kernel.rows.count; ++y) {
        const double* from = chords + y * 2 * line;
        for_fixed_tiles<column_tile>(columns, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t R = decltype(size)::value;
            V a[R][2], b[R][2];
            multiply<R, 2>(isa, kernel.column_cos.data() + first * half, from, half, a);
            multiply<R, 2>(isa, kernel.column_sin.data() + first * half, from + line, half, b);
            for (std::size_t r = 0; r < R; ++r) {
                double* to = row + kernel.columns.plus[first + r] * 2 * lanes;
                store(to, a[r][0] + b[r][1]);
                store(to + lanes, a[r][1] - b[r][0]);
                if (kernel.columns.minus[first + r] != WindowAxis::none) {
                    to = row + kernel.columns.minus[first + r] * 2 * lanes;
                    store(to, a[r][0] - b[r][1]);
                    store(to + lanes, a[r][1] + b[r][0]);
                }
            }
        });
        sink(y, row);
    }
}

template <class T>
class ChordalRenderer {
   public:
    ChordalRenderer(const ChordalStack& stack, const ChordalWindow& window, double tol, int threads,
                    const ChordalAnswer<T>& answer)
        : stack_(stack), rows_(window.height, window.center_row), columns_(window.width, window.center_column),
          step_(window.step), tol_(tol), threads_(threads), answer_(answer), curves_(stack.terms),
          box_{step_ * columns_.low(), step_ * columns_.high(), step_ * rows_.low(), step_ * rows_.high()},
          area_(stack.obscuration * stack.obscuration), states_(stack.count) {}

    void run() {
        const double g = stack_.gaussian, clear = 1.0 - area_;
        const double bright = g > 1e-6 ? std::exp(-g * area_) * -std::expm1(-g * clear) / g : clear;
        ChordBound outer, inner;
        std::vector<std::size_t> pending(stack_.count);
        std::iota(pending.begin(), pending.end(), std::size_t{0});
        for (const std::size_t p : pending) {
            prepare(p, outer, inner);
            check(outer);
            // Most PSFs have sup|U| above this; where one has not, the error is tightened after that was found.
            states_[p].error = 0.4 * tol_ * 0.5 * bright / std::sqrt(1.0 + outer.variance());
        }
        while (!pending.empty()) {
            for (const std::size_t p : pending) {
                State& s = states_[p];
                prepare(p, outer, inner);
                const double rounding = outer.rounding(0);
                if (s.error < rounding) {
                    if (s.relative < 1e300) {
                        throw ToleranceNotMet(s.relative);
                    }
                    s.error = rounding;
                }
                s.chords = outer.chords(area_ > 0.0 ? 0.6 * s.error : s.error);
                s.inner = area_ > 0.0 ? inner.chords(0.4 * s.error / area_) : 0;
            }
            std::sort(pending.begin(), pending.end(), [&](std::size_t a, std::size_t b) {
                return states_[a].chords != states_[b].chords ? states_[a].chords < states_[b].chords : a < b;
            });
            dispatch_batches(pending);
            std::vector<std::size_t> again;
            for (const std::size_t p : pending) {
                if (!(states_[p].relative <= tol_)) {
                    // What the peak that was found asks for, or simply much less.
                    const double wanted = 0.4 * tol_ * std::sqrt(states_[p].peak);
                    states_[p].error = std::min(0.3 * states_[p].error, std::max(wanted, 1e-3 * states_[p].error));
                    again.push_back(p);
                }
            }
            pending.swap(again);
        }
    }

   private:
    struct State {
        double error = 0.0, relative = 1e300, peak = 0.0;
        std::size_t chords = 0, inner = 0;
    };

    static void check(const ChordBound& bound) {
        if (!(bound.size() <= max_phase)) {
            throw PhaseTooLarge("phases must be at most 1e6 radians");
        }
    }

    void prepare(std::size_t p, ChordBound& outer, ChordBound& inner) const {
        outer.prepare(curves_, stack_.outer + p * stack_.terms.size(), stack_.gaussian, box_);
        if (area_ > 0.0) {
            inner.prepare(curves_, stack_.inner + p * stack_.terms.size(), area_ * stack_.gaussian,
                          box_.scaled(stack_.obscuration));
        }
    }

    std::shared_ptr<const KernelTable> kernel(std::size_t chords, double step) const {
        if (KernelTable::bytes(chords, rows_.at.size()) > max_table_bytes) {
            throw PhaseTooLarge("a window of " + std::to_string(rows_.count) + " rows and these phases take " +
                                std::to_string(chords) + " chords, whose tables exceed the limit of 256 MiB");
        }
        return shared_table<KernelTable>(chords, rows_, columns_, step);
    }

    struct Tables {
        std::shared_ptr<const TermTable> terms;
        std::shared_ptr<const KernelTable> kernel;
    };

    Tables tables(std::size_t chords, double scale) const {
        // The kernel first: it knows when there are too many chords.
        const auto k = kernel(chords, scale * step_);
        return {shared_table<TermTable>(chords, stack_.terms, scale * scale * stack_.gaussian), k};
    }

    void dispatch_batches(const std::vector<std::size_t>& pending) {
        std::size_t lanes = Portable::lanes;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { lanes = decltype(isa)::lanes; });
        const std::size_t batches = (pending.size() + lanes - 1) / lanes;
        // Tables before threads, so that no thread waits for another to make them.
        std::vector<Tables> outer(batches), inner(batches);
        for (std::size_t b = 0; b < batches; ++b) {
            std::size_t chords = 0, within = 0;
            for (std::size_t i = b * lanes; i < std::min(pending.size(), (b + 1) * lanes); ++i) {
                chords = std::max(chords, states_[pending[i]].chords);
                within = std::max(within, states_[pending[i]].inner);
            }
            const bool same = b > 0 && outer[b - 1].terms->chords == chords;
            outer[b] = same ? outer[b - 1] : tables(chords, 1.0);
            if (area_ > 0.0) {
                const bool alike = b > 0 && inner[b - 1].terms->chords == within;
                inner[b] = alike ? inner[b - 1] : tables(within, stack_.obscuration);
            }
        }
        parallel_for(batches, threads_, [&](std::size_t, std::size_t b) {
            thread_local ChordalScratch scratch;
            const std::size_t first = b * lanes, here = std::min(lanes, pending.size() - first);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                batch(isa, pending.data() + first, here, outer[b], inner[b], scratch);
            });
        });
    }

    template <class I>
    LOMMEL_INLINE void gather(I, const double* coefficients, const std::size_t* pupils, std::size_t here,
                              const TermTable& table, ChordalScratch& scratch) const {
        const std::size_t terms = stack_.terms.size();
        scratch.coefficients.resize(terms * I::lanes);
        for (std::size_t j = 0; j < terms; ++j) {
            for (std::size_t lane = 0; lane < I::lanes; ++lane) {
                // Lanes without a pupil repeat the last one.
                const std::size_t p = pupils[std::min(lane, here - 1)];
                scratch.coefficients[j * I::lanes + lane] = coefficients[p * terms + table.order[j]];
            }
        }
    }

    template <class I>
    LOMMEL_INLINE void batch(I isa, const std::size_t* pupils, std::size_t here, const Tables& outer, const Tables& inner,
                             ChordalScratch& scratch) {
        using V = typename I::pack;
        constexpr std::size_t lanes = I::lanes;
        const std::size_t width = columns_.count, pixels = rows_.count * width;
        if (area_ > 0.0) {
            scratch.inner.resize(pixels * 2 * lanes);
            double* kept = scratch.inner.data();
            gather(isa, stack_.inner, pupils, here, *inner.terms, scratch);
            chordal_fields(isa, *inner.terms, *inner.kernel, scratch, [&](std::size_t y, const double* u)
                                                                          LOMMEL_INLINE_LAMBDA {
                for (std::size_t j = 0; j < 2 * width * lanes; j += lanes) {
                    store(kept + 2 * y * width * lanes + j, load<V>(u + j) * splat<V>(area_));
                }
            });
        }
        double scale[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double given = answer_.scales[pupils[std::min(lane, here - 1)]];
            scale[lane] = given == 0.0 ? 1.0 : given;
        }
        scratch.intensity.resize(width * lanes);
        double* intensity = scratch.intensity.data();
        V top = splat<V>(0.0);
        gather(isa, stack_.outer, pupils, here, *outer.terms, scratch);
        chordal_fields(isa, *outer.terms, *outer.kernel, scratch, [&](std::size_t y, const double* u)
                                                                      LOMMEL_INLINE_LAMBDA {
            const double* less = area_ > 0.0 ? scratch.inner.data() + 2 * y * width * lanes : nullptr;
            for (std::size_t x = 0; x < width; ++x) {
                V re = load<V>(u + 2 * x * lanes), im = load<V>(u + (2 * x + 1) * lanes);
                if (less != nullptr) {
                    re = re - load<V>(less + 2 * x * lanes);
                    im = im - load<V>(less + (2 * x + 1) * lanes);
                }
                const V i = re * re + im * im;
                top = larger(top, i);
                store(intensity + x * lanes, i);
            }
            for (std::size_t lane = 0; lane < here; ++lane) {
                T* to = answer_.images + pupils[lane] * pixels + y * width;
                const double by = scale[lane];
                for (std::size_t x = 0; x < width; ++x) {
                    to[x] = static_cast<T>(by * intensity[x * lanes + lane]);
                }
            }
        });
        double peaks[lanes];
        store(peaks, top);
        thread_local ChordBound far, near;
        for (std::size_t lane = 0; lane < here; ++lane) {
            settle_one(pupils[lane], peaks[lane], outer, inner, far, near);
        }
    }

    void settle_one(std::size_t p, double peak, const Tables& outer, const Tables& inner, ChordBound& far, ChordBound& near) {
        State& s = states_[p];
        prepare(p, far, near);
        double error = far.bound(outer.terms->chords) + far.rounding(outer.terms->chords);
        if (area_ > 0.0) {
            error += area_ * (near.bound(inner.terms->chords) + near.rounding(inner.terms->chords));
        }
        s.peak = peak;
        const bool normalize = answer_.scales[p] == 0.0;
        s.relative = relative_error(peak, error);
        s.relative = normalize ? normalized_error(s.relative) : s.relative;
        if (!(s.relative <= tol_)) {
            return;
        }
        answer_.bounds[p] = s.relative;
        if (normalize) {
            const double scale = answer_.scales[p] = 1.0 / peak;
            const std::size_t pixels = rows_.count * columns_.count;
            T* image = answer_.images + p * pixels;
            for (std::size_t i = 0; i < pixels; ++i) {
                image[i] = static_cast<T>(scale * static_cast<double>(image[i]));
            }
        }
    }

    const ChordalStack& stack_;
    WindowAxis rows_, columns_;
    double step_, tol_;
    int threads_;
    ChordalAnswer<T> answer_;
    ChordCurves curves_;
    VBox box_;
    double area_;
    std::vector<State> states_;
};

}  // namespace lommel
