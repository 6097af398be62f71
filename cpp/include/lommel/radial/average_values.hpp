// Windows from profiles at the radii of their tables, and what is proven about their error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/pixels/anywhere.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/question.hpp"

namespace lommel {

// Values of a window from I, or a derivative of it, at the radii of its table.
struct WindowValues {
    Doubles values;
    std::size_t count = 0;
    double penalty = 0.0;  // of the harmonics, in units of roundoff

    void make(const AnywhereTable& table, const PixelWindow& window, const double* at_radii, int) {
        thread_local Doubles scratch;
        count = window.height * window.width;
        values.resize(count + widest_step);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { penalty = table.apply(isa, window, at_radii, scratch, values.data()); });
    }

    void make(const PixelTable& table, const PixelWindow&, const double* at_radii, int threads) {
        count = table.value_count;
        values.resize(count + widest_step);
        penalty = 0.0;
        if (table.rings.empty()) {
            std::copy_n(at_radii, table.value_count, values.data());
            return;
        }
        constexpr std::size_t block = 16;  // rings a task
        const std::size_t tasks = (table.rings.size() + block - 1) / block;
        std::vector<double> penalties(tasks, 0.0);
        parallel_for(tasks, threads, [&](std::size_t, std::size_t task) {
            thread_local Doubles scratch;
            const double* from = at_radii;
            double* to = values.data();
            const std::size_t last = std::min(table.rings.size(), (task + 1) * block);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                table.apply<1>(isa, task * block, last, &from, &to, &penalties[task], scratch);
            });
        });
        penalty = *std::max_element(penalties.begin(), penalties.end());
    }
};

// The bound on the error of values of a table: I at the radii is at most `size` there and off by `given`, its derivative
// along a line is at most `slope` and itself within `swing` of a constant.
template <class Table>
double window_error(const Table& table, double penalty, double size, double given, double slope, double swing) {
    // Radii, places in a pixel, and pixels are off by a few roundings each.
    const double places = table.reach() * slope * (3.0 * table.magnification() + 6.0 * table.of_grid + 4.0);
    return table.magnification() * given + table.error * swing + unit_roundoff * (table.rounding * size + penalty + places);
}

}  // namespace lommel
