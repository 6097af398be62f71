// Samples of the intensity around an arbitrary axis: polynomials of the distance from the axis, or of its square, on intervals
// of the distance (pieces) that do not depend on the axis (docs/certificate.md, section 9, "Samples around one axis").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/parts.hpp"
#include "lommel/pixels/sample_rows.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

struct SamplePieces : Radii {  // radii at which the intensity is computed, in optical units
    static constexpr std::size_t points = Halves::points;  // number of Chebyshev points per piece (interval of the distance)
    static constexpr std::size_t terms = 8;  // number of coefficients per part of a piece, in double precision
    static constexpr std::size_t together = 2;  // `first` and `last` are multiples of this, so that windows share tables
    static constexpr double slack = 1e-4;  // margin for rounding errors of positions, in widths of a piece
    static constexpr double evenly = 32.0;  // up to this distance, in optical units, all pieces have the same width

    int level;  // requested accuracy in decimal digits; the error bound is `error`
    std::size_t first, last;  // the table has the pieces (intervals) first to last - 1
    double width, error, of_nodes = lebesgue(points), of_grid = 1.0, rounding = 0.0;
    std::shared_ptr<const Parts<terms>> parts;

    SamplePieces(int digits, std::size_t from, std::size_t to)
        : level(digits), first(from), last(to), width(width_for(digits)), parts(Parts<terms>::get(parts_for(digits))) {
        const double equal = equal_pieces(width), half = 0.5 * width;
        error = lebesgue(terms) * interpolation_by_slope(half, points) * of_squares(equal * width, points) +
                interpolation_by_slope(half / static_cast<double>(parts->parts), terms) * of_squares(equal * width, terms);
        // Rounding of the matrices for the parts, of products and sums, and of evaluation (24 S in docs/certificate.md, section 9).
        rounding = 24.0 * parts->sizes;
        of_grid = std::min(lebesgue(terms), 1.0 + parts->bent());
        count = (last - first) * points;
        for (std::size_t piece = first; piece < last; ++piece) {
            for (std::size_t i = 0; i < points; ++i) {
                const double at = static_cast<double>(piece) + 0.5 * (1.0 + chebyshev_point(points - 1 - i, points));
                radii.push_back(width * distance_of(at, equal));
            }
        }
        radii.resize((count + widest_step + 15) / 16 * 16, radii.back());
    }

    double magnification() const { return of_nodes * of_grid; }
    std::size_t bytes() const { return sizeof(double) * radii.size(); }
    bool is(int digits, std::size_t from, std::size_t to) const { return level == digits && first == from && last == to; }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;

    // Width of a piece (interval of the distance), in optical units, for `digits` decimal digits. 10/11 of the allowed error is for
    // lebesgue(terms) * (error of interpolation on a piece), and 1/11 for the error of interpolation on the parts of a piece.
    static double width_for(int digits) {
        const double error = PixelTable::Budget::window * std::pow(10.0, -digits) / 1.1;
        const double of_slopes = interpolation_by_slope(1.0, points) * of_squares(evenly, points) * lebesgue(terms);
        return 2.0 * std::pow(error / of_slopes, 1.0 / static_cast<double>(points));
    }
    static std::size_t parts_for(int digits) {
        const double error = 0.1 / 1.1 * PixelTable::Budget::window * std::pow(10.0, -digits);
        const double of_slopes = interpolation_by_slope(1.0, terms) * of_squares(evenly, terms);
        return 2 * static_cast<std::size_t>(
                       std::ceil(0.25 * width_for(digits) / std::pow(error / of_slopes, 1.0 / static_cast<double>(terms))));
    }
    // Even number R of the innermost pieces, of width `width` in the distance r, which end at r = R widths. Pieces from R to 2 R
    // widths have equal width in r^2, which saves square roots; so have those from 2 R to 4 R widths, and so on.
    static double equal_pieces(double width) { return 2.0 * std::ceil(0.5 * evenly / width); }

    // Return the first piece that a window needs, and the piece after the last one.
    static std::array<std::size_t, 2> of(const PixelWindow& window, int digits) {
        double ends[2];
        window.reach(ends);
        const double w = width_for(digits), equal = equal_pieces(w);
        const auto table = [&](double pixels, double further) {
            const double piece = piece_of(pixels * window.step / w, equal) + further;
            return static_cast<std::size_t>(std::max(0.0, piece) / double(together));
        };
        return {table(ends[0], -slack) * together, (table(ends[1], slack) + 1) * together};
    }
    // Return whether pieces are efficient: they need at most 1024 more radii than the window has pixels.
    static bool pays(const PixelWindow& window, int digits) {
        const auto ends = of(window, digits);
        return (ends[1] - ends[0]) * points <= window.height * window.width + 1024;
    }
    static std::shared_ptr<const SamplePieces> get(const PixelWindow& window, int digits) {
        const auto ends = of(window, digits);
        return cache<SamplePieces>.get(digits, ends[0], ends[1]);
    }

    // From the intensity at the radii, write max(by * intensity, least) at the window's pixels; returns the largest intensity.
    template <class T>
    double paint(const PixelWindow& window, const double* intensity, double by, T least, int threads, T* image) const;

    // Like paint() with `least` 0, in single precision, by cubics on parts of the pieces and, far from the axis, straight lines.
    // room: allowed error of the intensity due to cubics and lines; places: allowed error of positions, in optical units; off: set
    // to the error bound of the intensity due to cubics and lines, positions, and rounding. The speed is limited by loads.
    double paint_single(const PixelWindow& window, const double* intensity, double by, double room, double places, int threads,
                        float* image, double& off) const {
        thread_local Doubles curves;
        thread_local Floats singles;
        curves.resize(last - first);
        double bent = 0.0;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { bent = measure(isa, intensity, curves.data()); });
        const std::size_t count = parts_for_cubics(bent, room);
        const double square = static_cast<double>(count * count);
        std::size_t straight = last;
        double curved = 0.0;
        while (straight > first && curves[straight - 1 - first] <= 4.0 * square * room) {
            --straight;
            curved = std::max(curved, curves[straight - first]);
        }
        const auto cubics = Parts<4>::get(count);
        const auto lines = Parts<2>::get(count);
        const FoldedWindow folded(window);
        SampleRows rows(folded.part, width, zones(static_cast<double>(count)));
        const double astray = rows.by_integers(places), equal = equal_pieces(width);
        const double end = rows.straight_from(distance_of(static_cast<double>(straight) + slack, equal));
        const std::size_t bends = std::min(last, static_cast<std::size_t>(piece_of(end, equal) + slack) + 1);
        singles.resize(count * (4 * (bends - first) + 2 * (last - straight)));
        float *const scaled = singles.data(), *const beyond = scaled + 4 * count * (bends - first);
        const float* const straights = beyond - 2 * count * (straight - first);
        double sizes[4] = {}, others[4] = {};
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            cut(isa, *cubics, intensity, by, first, bends, scaled, sizes);
            cut(isa, *lines, intensity + (straight - first) * points, by, straight, last, beyond, others);
        });
        off = std::max(bent / (192.0 * square * square) + rough(sizes, astray) / by,
                       curved / (4.0 * square) + rough(others, astray) / by);
        const double top = largest_of(folded, threads, image, [&](std::size_t begin, std::size_t end, float* to) {
            alignas(64) float tops[SampleRows::most_lanes] = {};
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                rows.each<float, 4>(begin, end, [&](const SampleRows::Run<float>& run) LOMMEL_INLINE_LAMBDA {
                    alignas(64) float made[SampleRows::longest];
                    float* const there = to + (run.row - begin) * folded.part.width + run.start;
                    const bool whole = run.count % SampleRows::most_lanes == 0;
                    if (run.straight) {
                        values_at<2>(isa, straights + run.base, run.at, run.x, run.count, whole ? there : made, tops);
                    } else {
                        values_at<4>(isa, scaled + run.base, run.at, run.x, run.count, whole ? there : made, tops);
                    }
                    if (!whole) {
                        std::copy_n(made, run.count, there);
                    }
                });
            });
            return static_cast<double>(*std::max_element(tops, tops + SampleRows::most_lanes)) / by;
        });
        off += single_roundoff * top;  // rounding error of the maximum, by which errors are divided
        return top;
    }

   private:
    // Call made(row, start, count, values) for runs of pixels in rows [begin, end), with values = max(by * intensity, least).
    // all: coefficients of all parts. Returns the largest intensity. Speed is limited by loads of doubles.
    using Made = Reference<void(std::size_t row, std::size_t start, std::size_t count, const double* values)>;
    double evaluate(const SampleRows& rows, const double* all, double by, double least, std::size_t begin, std::size_t end,
                    const Made& made) const {
        double tops[SampleRows::longest] = {};
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            rows.each<double, terms>(begin, end, [&](const SampleRows::Run<double>& run) LOMMEL_INLINE_LAMBDA {
                double values[SampleRows::longest];
                for (std::size_t i = 0; i < run.count; ++i) {
                    const double *const c = all + run.at[i], t = run.x[i], s = t * t;
                    const double value =
                        ((c[7] * t + c[6]) * s + (c[5] * t + c[4])) * (s * s) + ((c[3] * t + c[2]) * s + (c[1] * t + c[0]));
                    tops[i] = value > tops[i] ? value : tops[i];
                    values[i] = by * value > least ? by * value : least;
                }
                made(run.row, run.start, run.count, values);
            });
        });
        return *std::max_element(tops, tops + SampleRows::longest);
    }

    // Call paint(begin, end, to), which returns its largest pixel, for blocks of rows in parallel; returns the maximum of all.
    // Blocks are so tall that most rows find their coefficients in the cache, loaded by the row before.
    template <class T, class Paint>
    static double largest_of(const FoldedWindow& window, int threads, T* image, const Paint& paint) {
        const std::size_t height = window.part.height, width = window.part.width;
        const std::size_t block = std::max<std::size_t>(32, (std::size_t{1} << 15) / width);
        std::vector<double> tops((height + block - 1) / block);
        parallel_for(tops.size(), threads, [&](std::size_t, std::size_t task) {
            const std::size_t begin = task * block, end = std::min(height, begin + block);
            if (!window.folds()) {
                tops[task] = paint(begin, end, image + begin * width);
                return;
            }
            thread_local std::vector<T> quarter;
            quarter.resize((end - begin) * width);
            tops[task] = paint(begin, end, quarter.data());
            for (std::size_t row = begin; row < end; ++row) {
                window.unfold(row, quarter.data() + (row - begin) * width, image);
            }
        });
        return *std::max_element(tops.begin(), tops.end());
    }

    // piece_of(): position, counted in pieces, of the distance r in widths of the innermost piece: r for r < equal, and
    // R + (r^2 / R - equal) / 2 for R <= r < 2 R, with R = equal * (1, 2, 4, 8, ...). distance_of(): inverse function.
    static double piece_of(double distance, double equal) {
        if (distance < equal) {
            return distance;
        }
        const double from = equal * std::exp2(std::floor(std::log2(distance / equal)));
        return 0.5 * (distance * distance / from - equal) + from;
    }
    static double distance_of(double piece, double equal) {
        double from = equal;
        for (; piece >= 3.0 * from - 0.5 * equal; from *= 2.0) {
        }
        return piece < equal ? piece : std::sqrt(from * (2.0 * (piece - from) + equal));
    }

    // Number of parts per piece, at most Parts<4>::most, for which cubics through four points of each part have an error of at
    // most `room`. bent: bound on the intensity's fourth derivative by the position in a piece, which runs from -1 to 1.
    static std::size_t parts_for_cubics(double bent, double room) {
        const double wanted = std::ceil(0.5 * std::sqrt(std::sqrt(bent / (192.0 * room))));
        return 2 *
               static_cast<std::size_t>(std::max(1.0, std::min(0.5 * Parts<4>::most, wanted)));  // NaN gives the largest number
    }

    // Write a bound on |d^2 I/dx^2| for each piece to `curves`; return the largest bound on |d^4 I/dx^4|. I: intensity; x: position
    // in the piece, from -1 to 1.
    template <class I>
    LOMMEL_INLINE double measure(I isa, const double* intensity, double* curves) const {
        const Bends& bends = Bends::get();
        double largest = 0.0;
        for (std::size_t piece = first; piece < last; ++piece, intensity += points) {
            const Bends::Sizes sizes = bends(isa, Halves::Values(intensity, 1.0));
            *curves++ = sizes.second;
            largest = sizes.fourth > largest ? sizes.fourth : largest;
        }
        return largest;
    }

    // For pieces begin to end - 1 compute to[piece][part][power], the coefficients of each part's polynomial times `by`;
    // largest[power] becomes the maximum of itself and their moduli.
    template <class I, std::size_t Terms, class To>
    static LOMMEL_INLINE void cut(I isa, const Parts<Terms>& parts, const double* intensity, double by, std::size_t begin,
                                  std::size_t end, To* to, double* largest) {
        for (std::size_t piece = begin; piece < end; ++piece, intensity += points, to += parts.parts * Terms) {
            parts.cut(isa, Halves::Values(intensity, by), to, largest);
        }
    }
    // Error of cubics or lines from rounding to single precision, and from positions that are off by up to `astray` widths of a
    // part. largest[k]: largest modulus of a coefficient of power k (docs/certificate.md, section 9).
    static double rough(const double (&largest)[4], double astray) {
        const double rounded = largest[0] + 3.0 * largest[1] + 2.25 * largest[2] + 1.5 * largest[3];
        return 1.01 * (single_roundoff * rounded + astray * (largest[1] + largest[2] + 0.75 * largest[3]));
    }

    SampleRows::Zones zones(double parts) const {
        const double equal = equal_pieces(width), begin = static_cast<double>(first);
        SampleRows::Zones all;
        all.fill({HUGE_VAL, 0.0, HUGE_VAL});
        all[0] = {0.0, parts, -parts * begin - 0.5};
        std::size_t made = 1;
        for (double from = equal; from * width <= reach() && made + 1 < all.size(); from *= 2.0) {
            all[made++] = {from * from, 0.5 * parts / from, parts * (from - 0.5 * equal - begin) - 0.5};
        }
        return all;
    }
    // Compute to[i] = max(0, p(x[i])); c[at[i]] is the first of the `Terms` coefficients of the polynomial p. Coefficients are
    // loaded pixel by pixel and transposed. Each lane of `tops` is raised to the largest to[i] of that lane.
    template <std::size_t Terms, class I>
    static LOMMEL_INLINE void values_at(I, const float* c, const std::int32_t* at, const float* x, std::size_t count, float* to,
                                        float* tops) {
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
        using V = typename Vector<I::lanes>::floats;
        constexpr std::size_t lanes = sizeof(V) / sizeof(float);
        V top = load<V>(tops);
        for (std::size_t i = 0; i < count; i += lanes) {
            V from[Terms];
            if constexpr (Terms == 2) {
                turned_pairs(pairs<V>(c, at + i), pairs<V>(c, at + i + 2), from[0], from[1]);
            } else {
                const V a = fours<V>(c, at + i), b = fours<V>(c, at + i + 1), d = fours<V>(c, at + i + 2),
                        e = fours<V>(c, at + i + 3);
                turned_fours(a, b, d, e, from);
            }
            V made = from[Terms - 1];
            for (std::size_t k = Terms - 1; k-- > 0;) {
                made = made * load<V>(x + i) + from[k];
            }
            const V positive = larger(V{}, made);
            top = larger(top, positive);
            store(to + i, positive);
        }
        store(tops, top);
#else
        for (std::size_t i = 0; i < count; ++i) {
            const float* const from = c + at[i];
            float made = from[Terms - 1];
            for (std::size_t k = Terms - 1; k-- > 0;) {
                made = made * x[i] + from[k];
            }
            to[i] = std::max(0.0f, made);
            tops[i % SampleRows::most_lanes] = std::max(tops[i % SampleRows::most_lanes], to[i]);
        }
#endif
    }
};

template <class T>
double SamplePieces::paint(const PixelWindow& window, const double* intensity, double by, T least, int threads,
                           T* image) const {
    thread_local Doubles scratch;
    scratch.resize((last - first) * parts->parts * terms);
    double* const all = scratch.data();  // buffer of the calling thread, read by all threads
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        double sizes[terms] = {};
        cut(isa, *parts, intensity, 1.0, first, last, all, sizes);
    });
    const FoldedWindow folded(window);
    const SampleRows rows(folded.part, width, zones(static_cast<double>(parts->parts)));
    return largest_of(folded, threads, image, [&](std::size_t begin, std::size_t end, T* to) {
        return evaluate(rows, all, by, static_cast<double>(least), begin, end,
                        [&](std::size_t row, std::size_t start, std::size_t count, const double* values) {
                            T* const made = to + (row - begin) * folded.part.width + start;
                            for (std::size_t i = 0; i < count; ++i) {
                                made[i] = static_cast<T>(values[i]);
                            }
                        });
    });
}
#if defined(LOMMEL_COMPILED)
extern template double SamplePieces::paint<float>(const PixelWindow&, const double*, double, float, int, float*) const;
extern template double SamplePieces::paint<double>(const PixelWindow&, const double*, double, double, int, double*) const;
#endif

}  // namespace lommel
