// Pixel values of a window from the intensity at the radii of its table, with an error bound.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/pixels/average_rings.hpp"
#include "lommel/pixels/own_axes.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/limits.hpp"

namespace lommel {

// Pixel values of a window: the intensity, or a derivative of it.
struct WindowValues {
    Doubles values;
    std::size_t count = 0;
    double penalty = 0.0;  // rounding error of the azimuthal harmonics, in units of roundoff

    // Compute the values by a table that does not depend on the position of the axis, from the intensities `at_radii`.
    template <class Table>
    void make(const Table& table, const PixelWindow& window, const double* at_radii, int threads) {
        thread_local Doubles scratch;
        count = window.height * window.width;
        values.resize(count + widest_step);
        penalty = table.values(window, at_radii, threads, scratch, values.data());
    }
    void make(const PixelTable& table, const PixelWindow&, const double* at_radii, int threads) {
        count = table.value_count;
        values.resize(count + widest_step);
        penalty = 0.0;
        if (table.rings.empty()) {
            std::copy_n(at_radii, table.value_count, values.data());
            return;
        }
        constexpr std::size_t block = 16;  // number of rings per parallel task
        const std::size_t tasks = (table.rings.size() + block - 1) / block;
        const auto work = [&](std::size_t task) {
            thread_local Doubles scratch;
            double worst = 0.0;
            const double* from = at_radii;
            double* to = values.data();
            const std::size_t last = std::min(table.rings.size(), (task + 1) * block);
            dispatch([&](auto isa)
                         LOMMEL_INLINE_LAMBDA { table.apply<1>(isa, task * block, last, &from, &to, &worst, scratch); });
            return worst;
        };
        if (threads == 1) {
            for (std::size_t task = 0; task < tasks; ++task) {
                look();
                penalty = std::max(penalty, work(task));
            }
            return;
        }
        std::vector<double> penalties(tasks, 0.0);
        parallel_for(tasks, threads, [&](std::size_t, std::size_t task) { penalties[task] = work(task); });
        penalty = *std::max_element(penalties.begin(), penalties.end());
    }
};

// Compute the pixel values made[pupil * value_stride + value] of `pupils` pupils from their intensities at_radii[pupil * stride +
// radius]; returns the largest rounding error of the azimuthal harmonics, in units of roundoff.
inline double make_together(const PixelTable& table, const PixelWindows&, std::size_t, std::size_t pupils,
                            const double* at_radii, std::size_t stride, double* made, std::size_t value_stride) {
    constexpr std::size_t at_once = 4;
    thread_local Doubles sums;
    double penalties[at_once] = {};
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        for (std::size_t p = 0; p < pupils; p += at_once) {
            // The buffers have room for a multiple of `at_once` pupils; results beyond the last pupil are not used.
            const double* from[at_once];
            double* to[at_once];
            for (std::size_t k = 0; k < at_once; ++k) {
                from[k] = at_radii + (p + k) * stride;
                to[k] = made + (p + k) * value_stride;
            }
            table.apply<at_once>(isa, 0, table.rings.size(), from, to, penalties, sums);
        }
    });
    return *std::max_element(penalties, penalties + at_once);
}
inline double make_together(const AnywhereTable& table, const PixelWindows& windows, std::size_t first, std::size_t pupils,
                            const double* at_radii, std::size_t stride, double* made, std::size_t value_stride) {
    thread_local Doubles scratch;
    double penalty = 0.0;
    for (std::size_t p = 0; p < pupils; ++p) {
        penalty =
            std::max(penalty, table.values(windows[first + p], at_radii + p * stride, 1, scratch, made + p * value_stride));
    }
    return penalty;
}

// Error bound of a table's values (docs/certificate.md, section 9, "Together"). penalty: see WindowValues. Bounds: on the intensity
// I at the table's radii (size) and on its error there (given), on the derivative of I along any straight line (slope), and on
// |I - c| for some constant c (swing).
template <class Table>
double window_error(const Table& table, double penalty, double size, double given, double slope, double swing) {
    // Error due to rounded distances: 3 roundings of each radius, 6 of each position in a pixel, 4 of each pixel position.
    const double places = table.reach() * slope * (3.0 * table.magnification() + 6.0 * table.of_grid + 4.0);
    return table.magnification() * given + table.error * swing + unit_roundoff * (table.rounding * size + penalty + places);
}

}  // namespace lommel
