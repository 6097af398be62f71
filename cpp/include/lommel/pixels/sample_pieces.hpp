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

    // The pixels of a window times a number, none below `least`, from I at the radii; returns the largest, not multiplied.
    // Bound by loads.
    template <class T>
    double paint(const PixelWindow& window, const double* intensity, double by, T least, T* image) const {
        thread_local Doubles scratch;
        scratch.resize((last - first) * apart);
        double* const all = scratch.data();
        double top = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            fit(intensity, all);
            top = evaluate(window, all, by, least, image);
        });
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

    template <class T>
    LOMMEL_INLINE double evaluate(const PixelWindow& window, const double* coefficients, double by, T least, T* image) const {
        constexpr std::size_t tile = 64;
        alignas(64) std::int32_t at[tile];
        alignas(64) double x[tile], made[tile], tops[tile] = {};
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
                    x[i] = 2.0 * (place - static_cast<double>(at[i])) - 1.0;
                }
                for (std::size_t i = 0; i < here; ++i) {
                    const double *const c = coefficients + static_cast<std::size_t>(at[i]) * apart, t = x[i], s = t * t;
                    made[i] = ((c[5] * t + c[4]) * s + (c[3] * t + c[2])) * s + (c[1] * t + c[0]);
                }
                T* const out = image + row * window.width + start;
                for (std::size_t i = 0; i < here; ++i) {
                    tops[i] = made[i] > tops[i] ? made[i] : tops[i];
                    out[i] = std::max(static_cast<T>(by * made[i]), least);
                }
            }
        }
        return *std::max_element(tops, tops + tile);
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
