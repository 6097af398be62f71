// Pixel values in windows whose axis differs from pupil to pupil: polynomials of the distance from the axis, times angular
// harmonics, with weights for any axis (docs/certificate.md, section 9, "An axis for each pupil").
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>

#include "lommel/base/cache.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/pixels/weights.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

struct AnywhereTable : Radii {  // radii at which the intensity is computed, in optical units
    // Largest distance of a pixel from the axis, in optical units; beyond it, a table for each window is faster.
    static constexpr double most_reach = 110.0;

    double step;     // pixel pitch in optical units
    bool integrate;  // true: averages over pixels; false: samples at pixel centres
    double farthest;  // largest distance of a pixel centre from the axis, in pixels
    int level;        // requested accuracy in decimal digits; the error bound is `error`
    std::size_t harmonics = 1, gauss, degree, outputs;
    Doubles weights, penalty;  // weights[block of outputs][radius][output]; penalty[output]: rounding error if this output is 1
    double error, of_nodes = 1.0, of_grid, rounding;  // error bound; Lebesgue constants (radii; polynomials); rounding error

    AnywhereTable(double pitch, bool averages, double pixels, int digits)
        : step(pitch), integrate(averages), farthest(pixels), level(digits) {
        using Budget = PixelTable::Budget;
        const double side = integrate ? step : 0.0, allowed = std::pow(10.0, -level), reach = farthest * step;
        gauss = fewest(1, [&](std::size_t q) { return gauss_error(side, q) <= Budget::gauss * allowed; });
        harmonics = fewest(1, [&](std::size_t j) { return harmonics_error(side, j) <= Budget::harmonics * allowed; });
        const double by_angle = lebesgue(harmonics);
        const RingNodes places(0.0, reach, 0.0, (integrate ? Budget::rings : Budget::window) * allowed / by_angle);
        degree = std::max<std::size_t>(2, places.count);
        of_grid = by_angle * lebesgue(degree);
        // Averages, unlike samples, use the intensity between the interpolation points too, so they have nodes of their own.
        const RingNodes nodes = integrate ? RingNodes(0.0, reach, side * 0.70710678118654752, Budget::nodes * allowed / of_grid)
                                          : places.of(degree);
        for (std::size_t i = 0; i < nodes.count; ++i) {
            radii.push_back(nodes.radius(i));
        }
        count = nodes.count;
        radii.resize((count + widest_step + 15) / 16 * 16, radii.back());
        outputs = degree * harmonics;
        weigh(places.of(degree), nodes, Points::square(side, gauss));
        judge(reach, side, nodes.error);
    }

    double magnification() const { return of_grid * of_nodes; }
    // Largest distance of any point of a pixel from the axis, in optical units.
    double outermost() const { return step * (farthest + (integrate ? 0.70710678118654752 : 0.0)); }
    // Factor from an error of the intensity I(v) to an error of v dI/dv, the derivative with respect to the logarithm of the
    // image's scale (docs/certificate.md, section 15).
    double growth() const { return 2.0 * (outermost() + static_cast<double>(std::max({count, degree, gauss, 4 * harmonics}))); }
    std::size_t bytes() const { return sizeof(double) * (weights.size() + penalty.size() + radii.size()); }
    bool is(double pitch, bool averages, double pixels, int digits) const {
        return step == pitch && integrate == averages && farthest == pixels && level == digits;
    }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;
    static std::shared_ptr<const AnywhereTable> get(double pitch, bool averages, double pixels, int digits) {
        return cache<AnywhereTable>.get(pitch, averages, pixels, digits);
    }

    // Compute out[pixel], samples or averages, in whole vectors, from the intensity at each radius; returns the rounding error of
    // the polynomials in units of roundoff. Speed is limited by the latency of multiply-adds; four chains overlap.
    double values(const PixelWindow& window, const double* intensity, int, Doubles& scratch, double* out) const {
        double size = 0.0;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { size = apply(isa, window, intensity, scratch, out); });
        return size;
    }

   private:
    template <class I>
    LOMMEL_INLINE double apply(I isa, const PixelWindow& window, const double* intensity, Doubles& scratch, double* out) const {
        const std::size_t pixels = window.height * window.width, room = (pixels + widest_step) / widest_step * widest_step;
        scratch.resize(weights.size() / count + 2 * room);
        double *const sums = scratch.data(), *const x = sums + weights.size() / count, *const cosine = x + room;
        for (std::size_t block = 0; block < outputs; block += block_outputs) {
            weighted_sums<1>(isa, weights.data() + block * count, count, &intensity, &sums, block);
        }
        const double slope = 2.0 / (farthest * farthest);
        window.each([&](std::size_t i, double dx, double dy, double square) LOMMEL_INLINE_LAMBDA {
            x[i] = slope * square - 1.0;
            if (harmonics > 1) {
                cosine[i] = cosine_of_four(dx, dy, square);
            }
        });
        // Sums run over whole vectors: padding must hold valid positions.
        std::fill(x + pixels, x + room, x[0]);
        std::fill(cosine + pixels, cosine + room, cosine[0]);
        if (harmonics > 1) {
            sum_harmonics(isa, degree, sums, harmonics, x, cosine, room, out);
        } else {
            sum_profile(isa, degree, sums, x, room, out);
        }
        return weighted_size(isa, sums, penalty.data(), penalty.size());
    }

    void weigh(const RingNodes& places, const RingNodes& nodes, const Points& square) {
        Doubles rows(outputs * count, 0.0);
        if (integrate) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                average_rows(
                    isa, nodes, square, outputs, [&](std::size_t o) { return places.radius(degree - 1 - o % degree); },
                    [&](std::size_t o) { return quarter_angle(chebyshev_point(o / degree, harmonics)); }, rows.data());
            });
        } else {
            for (std::size_t o = 0; o < degree; ++o) {
                rows[o * count + degree - 1 - o] = 1.0;
            }
        }
        transform(cosine_transform(degree), harmonics, degree, 1, count, rows);
        transform(cosine_transform(harmonics), degree, 1, degree, count, rows);
        weights.resize((outputs + block_outputs - 1) / block_outputs * block_outputs * count, 0.0);
        block_rows(rows.data(), outputs, count, weights.data());
    }

    void judge(double reach, double side, double of_interpolation) {
        const double n = static_cast<double>(count), degrees = static_cast<double>(degree),
                     orders = static_cast<double>(harmonics);
        error = of_interpolation;
        if (integrate) {
            of_nodes = lebesgue(count);
            error = of_grid * (error + gauss_error(side, gauss)) +
                    lebesgue(harmonics) * interpolation_error(reach, 2 * degree) + harmonics_error(side, harmonics);
        }
        rounding = of_grid * of_nodes * (2.0 * n * n + 6.0 * n + 40.0) +
                   of_nodes * 4.0 * orders * degrees * (n + orders + degrees + 4.0);
        for (std::size_t o = 0; o < weights.size() / count; ++o) {
            const double order = static_cast<double>(o / degree), power = static_cast<double>(o % degree);
            // 15 * power^2: squared distances, scaled to [-1, 1], have errors of up to 15 roundoffs, and power^2 is the largest
            // slope of the Chebyshev polynomial T_power.
            const double each =
                1.5 * (power + 1.0) * (power + 2.0) + 15.0 * power * power + 10.0 * order * order + 4.0 * orders;
            penalty.push_back(o < outputs ? each : 0.0);
        }
    }
};

}  // namespace lommel
