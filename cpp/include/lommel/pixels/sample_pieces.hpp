// Samples around an axis anywhere: polynomials of the distance from it, or of its square, on pieces that do not depend on the axis.
// docs/certificate.md, section 9.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/once.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/sample_rows.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

// From monomials on [-1, 1] to those of the cubics through four Chebyshev points of each of so many equal parts.
struct Cubics {
    static constexpr std::size_t terms = 4, from = 8, least = 2, most = 64;  // parts: an even number
    std::size_t parts;
    Doubles matrix;  // [power][part, power]
    std::array<double, from> rounded{}, slope{};  // of the coefficients of a piece: roundings, and the steepest that a cubic is

    explicit Cubics(std::size_t count);

    bool is(std::size_t count) const { return parts == count; }
    std::size_t bytes() const { return sizeof(double) * matrix.size(); }
    static constexpr std::size_t most_bytes = std::size_t{1} << 20;
    static std::shared_ptr<const Cubics> get(std::size_t count) { return cache<Cubics>.get(count); }

    // p^(4) / 4! of a polynomial p is no more, and p no farther than that over 8 parts^4 from its cubics.
    static double bent(const double* c) {
        return std::abs(c[4]) + 5.0 * std::abs(c[5]) + 15.0 * std::abs(c[6]) + 35.0 * std::abs(c[7]);
    }
    static std::size_t for_error(double bent, double room) {
        const double wanted = std::ceil(0.5 * std::sqrt(std::sqrt(bent / (8.0 * room))));
        return 2 * static_cast<std::size_t>(std::max(1.0, std::min(0.5 * most, wanted)));  // also where that is no number
    }
    double error(double bent) const { return bent / (8.0 * std::pow(static_cast<double>(parts), 4.0)); }
};

struct SamplePieces : Radii {  // where I is wanted, in v
    static constexpr std::size_t points = 8;  // of a piece, and coefficients
    static constexpr std::size_t together = 8;  // as many pieces more or less are one table
    static constexpr double slack = 1e-4;  // of places, in pieces
    static constexpr double evenly = 32.0;  // up to here in v at least pieces are equal
    static_assert(Cubics::from == points);

    int level;  // errors are about 10^-level; `error` says what they are
    std::size_t first, last;  // pieces
    double width, error, of_nodes = lebesgue(points), of_grid = 1.0, rounding = 0.0;
    std::array<double, points * points> powers{};  // [point][power]

    SamplePieces(int digits, std::size_t from, std::size_t to);

    double magnification() const { return of_nodes; }
    std::size_t bytes() const { return sizeof(double) * radii.size(); }
    bool is(int digits, std::size_t from, std::size_t to) const { return level == digits && first == from && last == to; }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;

    // Of 2^-14 w^8 / 8! |f^(8)|, w the width: see interpolation_error().
    static double width_for(int digits) {
        return 2.0 * std::pow(20160.0 * PixelTable::Budget::window * std::pow(10.0, -digits), 1.0 / 8.0);
    }
    // As many pieces from the axis on are equal in r, a power of two; beyond, between R and 2 R pieces of the axis, those are equal
    // whose squares are, so that no roots are taken.
    static double equal_pieces(double width) { return std::exp2(std::max(3.0, std::ceil(std::log2(evenly / width)))); }

    // The pieces of a window: the first one, and the one after the last.
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
    // Whether fewer radii do than there are pixels.
    static bool pays(const PixelWindow& window, int digits) {
        const auto ends = of(window, digits);
        return (ends[1] - ends[0]) * points <= window.height * window.width + 128 * together;
    }
    static std::shared_ptr<const SamplePieces> get(const PixelWindow& window, int digits) {
        const auto ends = of(window, digits);
        return cache<SamplePieces>.get(digits, ends[0], ends[1]);
    }

    // The pixels of a window times a number, none below `least`, from I at the radii; returns the largest, not multiplied.
    template <class T>
    double paint(const PixelWindow& window, const double* intensity, double by, T least, int threads, T* image) const {
        thread_local Doubles scratch;
        scratch.resize((last - first) * points);
        double* const all = scratch.data();  // of this thread, whoever paints
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { fit(isa, intensity, all); });
        const FoldedWindow folded(window);
        const SampleRows rows(folded.part, width, zones(1.0));
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

    // The same, none below 0, by cubics in single precision on parts of the pieces, off by about `room`, at places that are by
    // about `places` in v; what they add to the error of I, with all roundings, is `off`. Bound by loads.
    double paint_singly(const PixelWindow& window, const double* intensity, double by, double room, double places, int threads,
                        float* image, double& off) const {
        thread_local Doubles scratch;
        thread_local Floats singles;
        scratch.resize((last - first) * points);
        const FoldedWindow folded(window);
        double bent = 0.0;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { bent = fit(isa, intensity, scratch.data()); });
        const auto cubics = Cubics::get(Cubics::for_error(bent, room));
        SampleRows rows(folded.part, width, zones(static_cast<double>(cubics->parts)));
        const double astray = rows.by_integers(places);
        singles.resize((last - first) * cubics->parts * Cubics::terms);
        float* const scaled = singles.data();
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            off = cubics->error(bent) + narrow(isa, *cubics, astray, scratch.data(), by, scaled);
        });
        const double top = largest_of(folded, threads, image, [&](std::size_t begin, std::size_t end, float* to) {
            alignas(64) float tops[SampleRows::most_lanes] = {};
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                rows.each<float, Cubics::terms>(begin, end, [&](const SampleRows::Run<float>& run) LOMMEL_INLINE_LAMBDA {
                    alignas(64) float made[SampleRows::longest];
                    float* const there = to + (run.row - begin) * folded.part.width + run.start;
                    const bool whole = run.count % SampleRows::most_lanes == 0;
                    cubics_at(isa, scaled + run.base, run.at, run.x, run.count, whole ? there : made, tops);
                    if (!whole) {
                        std::copy_n(made, run.count, there);
                    }
                });
            });
            return static_cast<double>(*std::max_element(tops, tops + SampleRows::most_lanes)) / by;
        });
        off += single_roundoff * top;  // of the largest value itself
        return top;
    }

   private:
    // Hands over the pixels of rows [begin, end) times a number, none below `least`; returns the largest, not multiplied. Bound by loads,
    // of doubles.
    using Made = Reference<void(std::size_t row, std::size_t start, std::size_t count, const double* values)>;
    double evaluate(const SampleRows& rows, const double* all, double by, double least, std::size_t begin, std::size_t end,
                    const Made& made) const;

    // Has rows [begin, end) painted by paint(begin, end, to), in blocks that are worth a task, and so many that most of the pieces of a
    // row are those of the one before; returns the largest that it does.
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

    // In which piece a distance is, in pieces: r up to R = `equal`, and (r^2 / R + 2 R - equal) / 2 for R <= r < 2 R = 2 equal, ...
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

    // Sums over i of factors[i] rows[i * pitch + k], as To.
    template <class I, class To>
    static LOMMEL_INLINE void eight_sums(I, const double* factors, double by, const double* rows, std::size_t pitch, To* sums) {
        using V = typename I::pack;
        using Out = std::conditional_t<sizeof(To) == sizeof(double), V, typename Vector<I::lanes>::narrow>;
        constexpr std::size_t packs = points / I::lanes;
        V sum[packs] = {};
        for (std::size_t i = 0; i < points; ++i) {
            const V factor = splat<V>(by * factors[i]);
            for (std::size_t p = 0; p < packs; ++p) {
                sum[p] = sum[p] + factor * load<V>(rows + i * pitch + p * I::lanes);
            }
        }
        for (std::size_t p = 0; p < packs; ++p) {
            store(sums + p * I::lanes, converted<Out>(sum[p]));
        }
    }

    // Of each piece the coefficients of the polynomial through I; returns the largest that Cubics::bent() is.
    template <class I>
    LOMMEL_INLINE double fit(I isa, const double* intensity, double* coefficients) const {
        double largest = 0.0;
        for (std::size_t piece = first; piece < last; ++piece, intensity += points, coefficients += points) {
            eight_sums(isa, intensity, 1.0, powers.data(), points, coefficients);
            const double bent = Cubics::bent(coefficients);
            largest = bent > largest ? bent : largest;
        }
        return largest;
    }

    // Coefficients of the cubics times a number; returns what their values are off by at most, through roundings and where places are
    // `astray`, in parts.
    template <class I>
    LOMMEL_INLINE double narrow(I isa, const Cubics& cubics, double astray, const double* coefficients, double by,
                                float* scaled) const {
        const std::size_t outputs = cubics.parts * Cubics::terms;
        double size[points];
        for (std::size_t i = 0; i < points; ++i) {
            size[i] = 1.01 * (single_roundoff * cubics.rounded[i] + 2.0 * astray * cubics.slope[i]);
        }
        double largest = 0.0;
        for (std::size_t piece = first; piece < last; ++piece, coefficients += points) {
            for (std::size_t start = 0; start < outputs; start += points, scaled += points) {
                eight_sums(isa, coefficients, by, cubics.matrix.data() + start, outputs, scaled);
            }
            double sum = 0.0;
            for (std::size_t i = 0; i < points; ++i) {
                sum += size[i] * std::abs(coefficients[i]);
            }
            largest = sum > largest ? sum : largest;
        }
        return largest;
    }

    SampleRows::Zones zones(double parts) const;
    // Of a vector of pixels at once, whose coefficients are loaded side by side and turned; those behind the last of them are as the
    // last. Raises what is the largest so far in each lane.
    template <class I>
    static LOMMEL_INLINE void cubics_at(I, const float* c, const std::int32_t* at, const float* x, std::size_t count, float* to,
                                        float* tops) {
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
        using V = typename Vector<I::lanes>::floats;
        constexpr std::size_t lanes = sizeof(V) / sizeof(float);
        V top = load<V>(tops);
        for (std::size_t i = 0; i < count; i += lanes) {
            const V a = fours<V>(c, at + i), b = fours<V>(c, at + i + 1), d = fours<V>(c, at + i + 2),
                    e = fours<V>(c, at + i + 3);
            V from[4];
            turned_fours(a, b, d, e, from);
            const V t = load<V>(x + i), made = ((from[3] * t + from[2]) * t + from[1]) * t + from[0];
            const V positive = larger(V{}, made);
            top = larger(top, positive);
            store(to + i, positive);
        }
        store(tops, top);
#else
        for (std::size_t i = 0; i < count; ++i) {
            const float *const from = c + at[i], t = x[i];
            to[i] = std::max(0.0f, ((from[3] * t + from[2]) * t + from[1]) * t + from[0]);
            tops[i % SampleRows::most_lanes] = std::max(tops[i % SampleRows::most_lanes], to[i]);
        }
#endif
    }
};

#if defined(LOMMEL_DEFINES)
// With what values at n Chebyshev points, which rise, are taken to coefficients of 1, x, x^2, ...: [point][power].
template <std::size_t Count>
std::array<double, Count * Count> through_points() {
    double chebyshev[Count][Count] = {{1.0}, {0.0, 1.0}};
    for (std::size_t k = 2; k < Count; ++k) {
        for (std::size_t power = 0; power < Count; ++power) {
            chebyshev[k][power] = (power > 0 ? 2.0 * chebyshev[k - 1][power - 1] : 0.0) - chebyshev[k - 2][power];
        }
    }
    const Doubles matrix = cosine_transform(Count);  // of points that fall
    std::array<double, Count * Count> made{};
    for (std::size_t i = 0; i < Count; ++i) {
        for (std::size_t power = 0; power < Count; ++power) {
            for (std::size_t k = 0; k < Count; ++k) {
                made[i * Count + power] += matrix[k * Count + Count - 1 - i] * chebyshev[k][power];
            }
        }
    }
    return made;
}

LOMMEL_ONCE Cubics::Cubics(std::size_t count) : parts(count), matrix(from * parts * terms) {
    const auto powers = through_points<terms>();
    for (std::size_t part = 0; part < parts; ++part) {
        for (std::size_t i = 0; i < terms; ++i) {
            const double y = chebyshev_point(terms - 1 - i, terms);
            const double x = (static_cast<double>(2 * part) + 1.0 + y) / static_cast<double>(parts) - 1.0;
            double raised = 1.0;
            for (std::size_t k = 0; k < from; ++k, raised *= x) {
                for (std::size_t power = 0; power < terms; ++power) {
                    matrix[(k * parts + part) * terms + power] +=
                        raised * powers[i * terms + power] * std::exp2(static_cast<double>(power));
                }
            }
        }
    }
    // Each coefficient of a cubic is rounded once, and its power of x, which is rounded, too, as often as that says, and it takes part in
    // no more than 2 k + 1 products and sums; the first in the last sum alone, whose rounding is that of storing. That is 1, 6, 9 and
    // 12 roundings of what the Taylor coefficients of a part are at most, and those beyond the third go to lower ones of the same parity.
    for (std::size_t k = 0; k < from; ++k) {
        double choose = 1.0, shrink = 1.0;
        for (std::size_t j = 0; j <= k; ++j) {
            constexpr double roundings[from] = {1.0, 6.0, 9.0, 12.0, 10.0, 13.0, 10.0, 13.0};
            rounded[k] += roundings[j] * choose * shrink;
            slope[k] += static_cast<double>(j) * choose * shrink;
            choose *= static_cast<double>(k - j) / static_cast<double>(j + 1);
            shrink /= static_cast<double>(parts);
        }
    }
}

LOMMEL_ONCE SamplePieces::SamplePieces(int digits, std::size_t from, std::size_t to)
    : level(digits), first(from), last(to), width(width_for(digits)), powers(through_points<points>()) {
    const double equal = equal_pieces(width);
    error = interpolation_by_slope(0.5 * width, points) * of_squares(equal * width, points);
    double sizes = 0.0;
    for (const double power : powers) {
        sizes += std::abs(power);
    }
    // Of factors, of sums of eight products, and of evaluation.
    rounding = 64.0 * sizes;
    count = (last - first) * points;
    for (std::size_t piece = first; piece < last; ++piece) {
        for (std::size_t i = 0; i < points; ++i) {
            const double at = static_cast<double>(piece) + 0.5 * (1.0 + chebyshev_point(points - 1 - i, points));
            radii.push_back(width * distance_of(at, equal));
        }
    }
    radii.resize((count + widest_step + 15) / 16 * 16, radii.back());
}

LOMMEL_ONCE double SamplePieces::evaluate(const SampleRows& rows, const double* all, double by, double least, std::size_t begin,
                                          std::size_t end, const Made& made) const {
    double tops[SampleRows::longest] = {};
    dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
        rows.each<double, points>(begin, end, [&](const SampleRows::Run<double>& run) LOMMEL_INLINE_LAMBDA {
            double values[SampleRows::longest];
            for (std::size_t i = 0; i < run.count; ++i) {
                const double *const c = all + run.at[i], t = 2.0 * run.x[i], s = t * t;
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

LOMMEL_ONCE SampleRows::Zones SamplePieces::zones(double parts) const {
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
#endif

}  // namespace lommel
