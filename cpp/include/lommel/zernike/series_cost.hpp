// Time that the series is likely to take, from its degrees, orders and pixels: what other methods are weighed against.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/expansion.hpp"
#include "lommel/zernike/polar_image.hpp"

namespace lommel {

// Nanoseconds of one processor, all tables at hand; benchmarks/choice.py fits them.
struct SeriesCost {
    static constexpr double least = 38700.0;   // of any image
    static constexpr double circles = 4e-9;  // errors of interpolation between circles in double precision, of no dim image

    // Of one image.
    static double nanoseconds(const DiskStack& stack, const DiskWindow& window, std::size_t pupil, double tol) {
        const TermPairs terms(stack.terms);
        const std::size_t count = stack.terms.size();
        const auto from = stack.outer.begin() + static_cast<std::ptrdiff_t>(pupil * count);
        std::vector<double> phases(from, from + static_cast<std::ptrdiff_t>(count));
        // Tilt is taken as a place of the axis: see move_axes().
        double at[2] = {window.row, window.column};
        for (std::size_t j = 0; j < count; ++j) {
            if (stack.terms[j].n == 1) {
                at[stack.terms[j].m < 0 ? 0 : 1] += phases[j] / window.step;
                phases[j] = 0.0;
            }
        }
        const double height = static_cast<double>(window.height), width = static_cast<double>(window.width);
        const double rows = std::max(at[0], height - 1.0 - at[0]), columns = std::max(at[1], width - 1.0 - at[1]);
        const double reach = window.step * std::hypot(rows, columns), pixels = height * width;

        SeriesCost cost;
        const ZernikePhase outer{terms, phases.data(), stack.amplitude};
        const double area = stack.obscuration * stack.obscuration;
        const double error = ZernikeBudget::field * tol * stack.amplitude.integral(stack.obscuration) / (outer.size() + 1.0);
        cost.expand(outer, reach, ZernikeBudget::outer * error);
        if (area > 1e-18) {
            const ZernikePhase inner{terms, stack.inner.data() + pupil * count, stack.amplitude.scaled(area)};
            cost.expand(inner, stack.obscuration * reach, ZernikeBudget::inner * error / area);
        }
        const bool single = tol >= 1e-6;
        if (PolarImage::pays(reach, cost.orders_, cost.degrees_, pixels) && circles * dimness(outer) <= tol) {
            return cost.again(outer, tol) * (cost.sum_ + (single ? 4.5 : 14.4) * pixels + 5.9 * reach * cost.orders_);
        }
        // Eight pixels at once where the axis is in the window.
        const double near = std::max(0.0, std::min(rows, columns));
        const double groups = std::min(pixels, (std::max(rows, columns) + 1.0) * (near + 1.0) - 0.5 * near * (near + 1.0));
        return cost.again(outer, tol) *
               (cost.sum_ + (157.0 + 4.7 * cost.orders_) * reach + (1.4 + (single ? 0.94 : 1.8) * cost.orders_) * groups);
    }

   private:
    // How much larger U is at the peak of an image without aberration, likely.
    static double dimness(const ZernikePhase& phase) {
        double variance = 0.0;
        phase.amplitudes([&](double amplitude, std::size_t n, std::size_t m) {
            variance += amplitude * amplitude / (static_cast<double>(n + 1) * (m > 0 ? 2.0 : 1.0));
        });
        return std::sqrt(1.0 + variance);
    }

    // How often it is done, for roundings may be beyond the tolerance or near to it, of dim images above all.
    double again(const ZernikePhase& phase, double tol) const {
        const double share = unit_roundoff * (phase.sensitivity() + rounding_) * dimness(phase) / tol;
        return share > 0.25 ? 20.0 : 1.0 + 12.0 * share;
    }

    void expand(const ZernikePhase& phase, double reach, double error) {
        const DiskExpansion::Size size = DiskExpansion::likely(phase, reach, error);
        const double degrees = static_cast<double>(size.degrees), orders = static_cast<double>(size.orders),
                     exact = static_cast<double>(size.exact), rings = 0.25 * exact;
        sum_ += least + 0.0091 * degrees * degrees * rings +
                (3.2 + 0.016 * static_cast<double>(phase.list.pairs.size())) * rings * exact + 38.0 * degrees * orders;
        rounding_ = std::max(rounding_, 0.71 * degrees * (25.0 + rings + 4.0 * degrees));
        orders_ = std::max(orders_, orders);
        degrees_ = std::max(degrees_, degrees);
    }

    double sum_ = 0.0, orders_ = 0.0, degrees_ = 0.0, rounding_ = 0.0;
};

}  // namespace lommel
