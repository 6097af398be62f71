// Estimated time of the Zernike series (docs/certificate.md, section 7), for the choice between methods.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/expansion.hpp"
#include "lommel/zernike/polar_image.hpp"

namespace lommel {

// CPU time of an image in nanoseconds with all tables cached, by coefficients fitted with benchmarks/choice.py.
struct SeriesCost {
    static constexpr double least = 27000.0;     // time of the smallest image
    static constexpr double declined = 20000.0;  // time of the chordal rule's estimates, added if this rule declines
    // (Error of interpolation between circles) / (peak intensity) without aberrations. Aberrations that dim the field by an
    // estimated factor `dim` may increase this ratio up to 2 * dim - 1 times.
    static constexpr double least_error = 1.2e-10;
    // Limit of (rounding error of the expansion) / (allowed error), beyond which interpolation between circles may miss the
    // tolerance.
    static constexpr double rounded = 0.17;

    // Estimated time for the image of one pupil of the stack; 1e300 if its tolerance is unlikely to be met.
    static double nanoseconds(const DiskStack& stack, const DiskWindow& window, std::size_t pupil, double tol) {
        const TermPairs terms(stack.terms);
        const std::size_t count = stack.terms.size();
        const auto from = stack.outer.begin() + static_cast<std::ptrdiff_t>(pupil * count);
        std::vector<double> phases(from, from + static_cast<std::ptrdiff_t>(count));
        // Tilt moves the axis, as in DiskStack::move_axes().
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
        const double error = ZernikeBudget::field * tol * stack.amplitude.integral(stack.obscuration) / outer.dimmest();
        cost.expand(outer, reach, ZernikeBudget::outer * error);
        if (area > 1e-18) {
            const ZernikePhase inner{terms, stack.inner.data() + pupil * count, stack.amplitude.scaled(area)};
            cost.expand(inner, stack.obscuration * reach, ZernikeBudget::inner * error / area);
        }
        const double dim = outer.dimness(), rounding = unit_roundoff * (outer.sensitivity() + cost.rounding_) * dim / tol;
        // Number of groups of eight mirrored pixels, if the axis is in the window.
        const double near = std::max(0.0, std::min(rows, columns));
        const double groups = std::min(pixels, (std::max(rows, columns) + 1.0) * (near + 1.0) - 0.5 * near * (near + 1.0));
        const double orders = cost.orders_, wide = widths();
        const bool serve = least_error * (2.0 * dim - 1.0) <= tol && rounding <= rounded;
        if (!circles(reach, cost.degrees_, orders, pixels)) {
            return cost.calls_ + cost.sum_ + directly(reach, cost.degrees_ * orders, pixels);
        }
        if (!serve) {
            return 1e300;
        }
        // Time of interpolation: taps and oversampling grow with the number of digits required.
        const double digits = std::log10(std::max(10.0, dim / tol));
        return cost.calls_ + 24000.0 +
               wide * (cost.sum_ + (0.1 + 0.55 * digits) * reach * orders + (3.15 + 3.04 * digits) * groups);
    }

    // Estimated time of `pixels` computed one by one. coefficients: their number.
    static double directly(double reach, double coefficients, double pixels) { return pixels * (4.0 * reach + coefficients); }
    // Return whether to interpolate between circles: not where their tables take more than a second or 100 MB, and not for so few
    // pixels so far from the axis that pixels one by one take a tenth of the time of the tables.
    static bool circles(double reach, double degrees, double orders, double pixels) {
        const double tables = 0.025 * reach * reach * degrees;
        return tables < 1e9 && tables < 10.0 * directly(reach, degrees * orders, pixels);
    }

   private:
    // Ratio of the time on this processor to the time with vectors of eight doubles.
    static double widths() { return std::pow(0.125 * static_cast<double>(widest_lanes(processor_level())), -0.91); }

    void expand(const ZernikePhase& phase, double reach, double error) {
        const DiskExpansion::Size size = DiskExpansion::likely(phase, reach, error);
        const std::size_t exact = DiskRule::rounded(size.exact);
        const double degrees = static_cast<double>(size.degrees), orders = static_cast<double>(size.orders),
                     rings = static_cast<double>(DiskRule::rings_for(exact)),
                     nodes = rings * static_cast<double>(DiskRule::points_for(exact));
        calls_ += 22800.0;
        sum_ += 0.041 * degrees * degrees * rings + 5.9 * degrees * orders + 0.3 * size.samples +
                (1.65 + 0.014 * static_cast<double>(phase.list.pairs.size())) * nodes;
        rounding_ = std::max(rounding_, 0.71 * degrees * (25.0 + rings + 4.0 * degrees));
        orders_ = std::max(orders_, orders);
        degrees_ = std::max(degrees_, degrees);
    }

    double calls_ = 0.0, sum_ = 0.0, orders_ = 0.0, degrees_ = 0.0, rounding_ = 0.0;
};

}  // namespace lommel
