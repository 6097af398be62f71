// Samples around an axis anywhere: polynomials of the distance from it, on pieces that do not depend on the axis.
// docs/certificate.md, section 9.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "lommel/base/cache.hpp"
#include "lommel/base/once.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

struct SamplePieces : Radii {  // where I is wanted, in v
    static constexpr std::size_t points = 6, apart = 8;  // of a piece, and what its coefficients are padded to
    static constexpr std::size_t together = 16;          // as many pieces more or less are one table

    int level;  // errors are about 10^-level; `error` says what they are
    std::size_t first, last;  // pieces
    double width, error, of_nodes = lebesgue(points), of_grid = 1.0, rounding = 0.0;
    std::array<double, points * apart> powers{};  // [point][power]

    SamplePieces(int digits, std::size_t from, std::size_t to);

    double magnification() const { return of_nodes; }
    std::size_t bytes() const { return sizeof(double) * radii.size(); }
    bool is(int digits, std::size_t from, std::size_t to) const { return level == digits && first == from && last == to; }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;

    // Of 2^-6 w^6 / 6! |f^(6)|, w the width: see interpolation_error().
    static double width_for(int digits) {
        return 2.0 * std::pow(360.0 * PixelTable::Budget::window * std::pow(10.0, -digits), 1.0 / 6.0);
    }
    // The pieces of a window: the first one, and the one after the last.
    static std::array<std::size_t, 2> of(const PixelWindow& window, int digits) {
        double ends[2];
        window.reach(ends);
        const double per_pixel = window.step / width_for(digits);
        const auto whole = [&](double pixels) { return static_cast<std::size_t>(pixels * per_pixel / double(together)); };
        return {whole(ends[0] * (1.0 - 1e-12)) * together, (whole(ends[1] * (1.0 + 1e-12)) + 1) * together};
    }
    // Whether fewer radii do than there are pixels.
    static bool pays(const PixelWindow& window, int digits) {
        const auto ends = of(window, digits);
        return (ends[1] - ends[0]) * points <= window.height * window.width + 64 * together;
    }
    static std::shared_ptr<const SamplePieces> get(const PixelWindow& window, int digits) {
        const auto ends = of(window, digits);
        return cache<SamplePieces>.get(digits, ends[0], ends[1]);
    }

    // The pixels of a window times a number, none below `least`, from I at the radii; returns the largest, not multiplied. Bound by
    // loads, of doubles; in single precision by square roots.
    template <class T>
    double paint(const PixelWindow& window, const double* intensity, double by, T least, T* image) const {
        thread_local Doubles scratch;
        scratch.resize((last - first) * apart);
        double* const all = scratch.data();
        double top = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            fit(intensity, all);
            top = evaluate(window, all, double(), [&](std::size_t i, double made, double& most) LOMMEL_INLINE_LAMBDA {
                most = made > most ? made : most;
                image[i] = std::max(static_cast<T>(by * made), least);
            });
        });
        return top;
    }

    // The same, none below 0, by polynomials in single precision, whose roundings add `rounding_of_singles` to the error of I.
    double paint_singly(const PixelWindow& window, const double* intensity, double by, float* image,
                        double& rounding_of_singles) const {
        thread_local Doubles scratch;
        thread_local Floats singles;
        scratch.resize((last - first) * apart);
        singles.resize((last - first) * apart);
        double* const all = scratch.data();
        float* const scaled = singles.data();
        double top = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            fit(intensity, all);
            rounding_of_singles = narrow(all, by, scaled);
            top = evaluate(window, scaled, float(), [&](std::size_t i, float made, float& most) LOMMEL_INLINE_LAMBDA {
                most = made > most ? made : most;
                image[i] = made > 0.0f ? made : 0.0f;
            });
        });
        top /= by;
        rounding_of_singles += single_roundoff * top;  // of the largest value itself
        return top;
    }

   private:
    // Of each piece the coefficients of the polynomial through I.
    LOMMEL_INLINE void fit(const double* intensity, double* coefficients) const {
        for (std::size_t piece = first; piece < last; ++piece, intensity += points, coefficients += apart) {
            double sums[apart] = {};
            for (std::size_t i = 0; i < points; ++i) {
                for (std::size_t power = 0; power < apart; ++power) {
                    sums[power] += powers[i * apart + power] * intensity[i];
                }
            }
            std::copy_n(sums, apart, coefficients);
        }
    }

    // Coefficients times a number in single precision; returns what evaluate() makes of their roundings and its own at most.
    LOMMEL_INLINE double narrow(const double* coefficients, double by, float* scaled) const {
        double largest = 0.0;
        for (std::size_t piece = first; piece < last; ++piece, coefficients += apart, scaled += apart) {
            double sum = std::abs(coefficients[0]);
            for (std::size_t power = 0; power < apart; ++power) {
                scaled[power] = static_cast<float>(by * coefficients[power]);
                // Each is rounded once, its power of x, which is rounded, too, as often as that says, and it takes part in no more
                // than 3 + 2 k products and sums; c_0 in the last sum alone, whose rounding is that of storing.
                sum += power > 0 ? (3.0 + 3.0 * static_cast<double>(power)) * std::abs(coefficients[power]) : 0.0;
            }
            largest = sum > largest ? sum : largest;
        }
        return 1.01 * single_roundoff * largest;
    }

    // Hands over each pixel, with what is the largest so far of some of them; returns the largest of all.
    template <class Real, class Take>
    LOMMEL_INLINE double evaluate(const PixelWindow& window, const Real* coefficients, Real, const Take& take) const {
        constexpr std::size_t tile = 64;
        alignas(64) std::int32_t at[tile];
        alignas(64) Real x[tile], made[tile], tops[tile] = {};
        const double per_pixel = window.step / width, begin = static_cast<double>(first);
        for (std::size_t row = 0; row < window.height; ++row) {
            look();
            const double dy = static_cast<double>(row) - window.center_y, square = dy * dy;
            for (std::size_t start = 0; start < window.width; start += tile) {
                const std::size_t here = std::min(tile, window.width - start);
                const double left = static_cast<double>(start) - window.center_x;
                for (std::int32_t i = 0; i < static_cast<std::int32_t>(tile); ++i) {
                    const double dx = left + static_cast<double>(i), place = std::sqrt(dx * dx + square) * per_pixel - begin;
                    at[i] = static_cast<std::int32_t>(place);
                    x[i] = static_cast<Real>(2.0 * (place - static_cast<double>(at[i])) - 1.0);
                }
                for (std::size_t i = here; i < tile; ++i) {  // beyond the edge there may be no piece
                    at[i] = at[0];
                }
                polynomials(coefficients, at, x, here, made);
                for (std::size_t i = 0; i < here; ++i) {
                    take(row * window.width + start + i, made[i], tops[i]);
                }
            }
        }
        return static_cast<double>(*std::max_element(tops, tops + tile));
    }
    static LOMMEL_INLINE void polynomials(const double* coefficients, const std::int32_t* at, const double* x,
                                          std::size_t count, double* made) {
        for (std::size_t i = 0; i < count; ++i) {
            const double *const c = coefficients + static_cast<std::size_t>(at[i]) * apart, t = x[i], s = t * t;
            made[i] = ((c[5] * t + c[4]) * s + (c[3] * t + c[2])) * s + (c[1] * t + c[0]);
        }
    }
    // Of four pixels at once, whose coefficients are loaded side by side and turned; of whole fours, so that some follow the last.
    static LOMMEL_INLINE void polynomials(const float* coefficients, const std::int32_t* at, const float* x, std::size_t count,
                                          float* made) {
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
        typedef float Quad __attribute__((vector_size(16)));
        typedef std::int32_t Order __attribute__((vector_size(16)));
        const Order low = {0, 4, 1, 5}, high = {2, 6, 3, 7}, first_half = {0, 1, 4, 5}, second_half = {2, 3, 6, 7};
        for (std::size_t i = 0; i < count; i += 4) {
            const float* from[4];
            for (std::size_t k = 0; k < 4; ++k) {
                from[k] = coefficients + static_cast<std::size_t>(at[i + k]) * apart;
            }
            Quad c[8];
            for (std::size_t part = 0; part < 8; part += 4) {
                const Quad a = load<Quad>(from[0] + part), b = load<Quad>(from[1] + part), d = load<Quad>(from[2] + part),
                           e = load<Quad>(from[3] + part);
                const Quad ab = __builtin_shuffle(a, b, low), de = __builtin_shuffle(d, e, low),
                           ab2 = __builtin_shuffle(a, b, high), de2 = __builtin_shuffle(d, e, high);
                c[part] = __builtin_shuffle(ab, de, first_half);
                c[part + 1] = __builtin_shuffle(ab, de, second_half);
                c[part + 2] = __builtin_shuffle(ab2, de2, first_half);
                c[part + 3] = __builtin_shuffle(ab2, de2, second_half);
            }
            const Quad t = load<Quad>(x + i), s = t * t;
            store(made + i, (((c[5] * t + c[4]) * s + (c[3] * t + c[2])) * s + c[1] * t) + c[0]);
        }
#else
        for (std::size_t i = 0; i < count; ++i) {
            const float *const c = coefficients + static_cast<std::size_t>(at[i]) * apart, t = x[i], s = t * t;
            made[i] = (((c[5] * t + c[4]) * s + (c[3] * t + c[2])) * s + c[1] * t) + c[0];
        }
#endif
    }
};

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE SamplePieces::SamplePieces(int digits, std::size_t from, std::size_t to)
    : level(digits), first(from), last(to), width(width_for(digits)), error(interpolation_error(0.5 * width, points)) {
    // T_k in powers of x, and with these the polynomial through values at the points.
    double chebyshev[points][points] = {{1.0}, {0.0, 1.0}}, sizes = 0.0;
    for (std::size_t k = 2; k < points; ++k) {
        for (std::size_t power = 0; power < points; ++power) {
            chebyshev[k][power] = (power > 0 ? 2.0 * chebyshev[k - 1][power - 1] : 0.0) - chebyshev[k - 2][power];
        }
    }
    const Doubles matrix = cosine_transform(points);  // of points that fall
    for (std::size_t i = 0; i < points; ++i) {
        for (std::size_t power = 0; power < points; ++power) {
            double& sum = powers[i * apart + power];
            for (std::size_t k = 0; k < points; ++k) {
                sum += matrix[k * points + points - 1 - i] * chebyshev[k][power];
            }
            sizes += std::abs(sum);
        }
    }
    // Of factors, of sums of six products, and of Horner's scheme.
    rounding = 64.0 * sizes;
    count = (last - first) * points;
    for (std::size_t piece = first; piece < last; ++piece) {
        for (std::size_t i = 0; i < points; ++i) {
            radii.push_back(0.5 * width * (2.0 * static_cast<double>(piece) + 1.0 + chebyshev_point(points - 1 - i, points)));
        }
    }
    radii.resize((count + widest_step + 15) / 16 * 16, radii.back());
}
#endif

}  // namespace lommel
