// Derivatives of pixel averages by the axis position, from averages along opposite edges (docs/certificate.md, section 15).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

#include "lommel/base/cache.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/own_axes.hpp"

namespace lommel {

// Table for the derivative of pixel averages along x, odd in x and even in y: a sum over j < harmonics of cos((2j+1) theta) times
// odd polynomials of the distance from the axis. The derivative along y is the same with x and y exchanged.
struct ShiftTable {
    std::shared_ptr<const AnywhereTable> pixels;  // table of the pixel averages, by which the cache finds this one
    std::size_t harmonics, degree;
    Doubles weights, penalty;  // weights[block of outputs][radius][output]; penalty[output]: rounding error if this output is 1
    double error, of_grid, rounding;

    explicit ShiftTable(const std::shared_ptr<const AnywhereTable>& of) : pixels(of) {
        using Budget = PixelTable::Budget;
        const double side = of->step, reach = of->farthest * side, allowed = std::pow(10.0, -of->level);
        harmonics = fewest(1, [&](std::size_t j) { return shift_harmonics_error(side, j) <= Budget::harmonics * allowed; });
        const double by_angle = lebesgue(2 * harmonics), each = 0.5 * Budget::rings * allowed / by_angle;
        degree = fewest(2, [&](std::size_t n) { return interpolation_error(reach, 2 * n) <= each; });
        of_grid = by_angle * lebesgue(2 * degree);
        const RingNodes nodes = RingNodes(0.0, reach, side * 0.70710678118654752, 1.0).of(of->count);
        weigh(reach, nodes, Points::sides(side, of->gauss));
        // Error bound of the difference of two averages, each with the error of a pixel average.
        error = 2.0 * (of_grid * (interpolation_error(nodes.high, 2 * nodes.count) + gauss_error(side, of->gauss)) +
                       by_angle * interpolation_error(reach, 2 * degree)) +
                shift_harmonics_error(side, harmonics);
        judge();
    }

    double reach() const { return pixels->reach(); }
    double magnification() const { return 2.0 * of_grid * pixels->of_nodes; }
    std::size_t bytes() const { return sizeof(double) * (weights.size() + penalty.size()); }
    bool is(const std::shared_ptr<const AnywhereTable>& of) const { return pixels == of; }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;
    static std::shared_ptr<const ShiftTable> get(const std::shared_ptr<const AnywhereTable>& of) {
        return cache<ShiftTable>.get(of);
    }

    // Compute the derivatives of each pixel average by the axis position in y (`down`) and in x (`across`), per pixel pitch, from
    // the intensity at the radii; both arrays are padded to whole vectors. Returns the polynomials' rounding error in roundoffs.
    double values(const PixelWindow& window, const double* intensity, Doubles& scratch, double* down, double* across) const {
        double size = 0.0;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { size = apply(isa, window, intensity, scratch, down, across); });
        return size;
    }

   private:
    template <class I>
    LOMMEL_INLINE double apply(I isa, const PixelWindow& window, const double* intensity, Doubles& scratch, double* down,
                               double* across) const {
        const std::size_t count = window.height * window.width, room = (count + widest_step) / widest_step * widest_step;
        const std::size_t outputs = weights.size() / pixels->count;
        scratch.resize(outputs + 2 * room);
        double *const sums = scratch.data(), *const x = sums + outputs, *const cosine = x + room;
        for (std::size_t block = 0; block < outputs; block += block_outputs) {
            weighted_sums<1>(isa, weights.data() + block * pixels->count, pixels->count, &intensity, &sums, block);
        }
        const double unit = 1.0 / pixels->farthest, slope = 2.0 * unit * unit;
        const auto each = [&](const auto& take) LOMMEL_INLINE_LAMBDA {
            for (std::size_t row = 0, i = 0; row < window.height; ++row) {
                const double dy = static_cast<double>(row) - window.center_y;
                for (std::int32_t column = 0; column < static_cast<std::int32_t>(window.width); ++column, ++i) {
                    take(i, dy, static_cast<double>(column) - window.center_x);
                }
            }
        };
        each([&](std::size_t i, double dy, double dx) LOMMEL_INLINE_LAMBDA {
            const double square = dx * dx + dy * dy;
            x[i] = slope * square - 1.0;
            cosine[i] = (dx - dy) * (dx + dy) / std::max(square, 1e-300);
        });
        std::fill(x + count, x + room, x[0]);
        std::fill(cosine + count, cosine + room, cosine[0]);
        sum_odd_harmonics(isa, degree, sums, harmonics, x, cosine, room, across, down);
        each([&](std::size_t i, double dy, double dx) LOMMEL_INLINE_LAMBDA {
            down[i] *= unit * dy;
            across[i] *= unit * dx;
        });
        return weighted_size(isa, sums, penalty.data(), penalty.size());
    }

    void weigh(double reach, const RingNodes& nodes, const Points& sides) {
        const std::size_t outputs = degree * harmonics, count = nodes.count;
        Doubles rows(outputs * count);
        const auto place = [](std::size_t i, std::size_t points) {
            return 1.57079632679489662 * (static_cast<double>(i) + 0.5) / static_cast<double>(points);
        };
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            average_rows(
                isa, nodes, sides, outputs, [&](std::size_t o) { return reach * std::cos(place(o % degree, degree)); },
                [&](std::size_t o) { return place(o / degree, harmonics); }, rows.data());
        });
        transform(odd_transform(degree), harmonics, degree, 1, count, rows);
        transform(odd_transform(harmonics), degree, 1, degree, count, rows);
        weights.resize((outputs + block_outputs - 1) / block_outputs * block_outputs * count, 0.0);
        block_rows(rows.data(), outputs, count, weights.data());
    }

    void judge() {
        const double n = static_cast<double>(pixels->count), degrees = static_cast<double>(degree),
                     orders = static_cast<double>(harmonics);
        rounding = 2.0 * (of_grid * pixels->of_nodes * (2.0 * n * n + 6.0 * n + 40.0) +
                          pixels->of_nodes * 4.0 * orders * degrees * (n + orders + degrees + 4.0));
        for (std::size_t o = 0; o < weights.size() / pixels->count; ++o) {
            const double j = static_cast<double>(o / degree), k = static_cast<double>(o % degree);
            // In Clenshaw's recurrences in r and in cos(theta), a rounding error in step m is amplified up to 2m + 1 times. Squared
            // distances are rounded as in AnywhereTable.
            const double each = 0.5 * (k + 1.0) * (k + 2.0) * (2.0 * k + 3.0) + 5.0 * k * (k + 1.0) * (2.0 * k + 1.0) +
                                (2.0 * j + 1.0) * (10.0 * (j + 1.0) * (j + 1.0) + 4.0 * orders);
            penalty.push_back(o < degree * harmonics ? each : 0.0);
        }
    }
};

}  // namespace lommel
