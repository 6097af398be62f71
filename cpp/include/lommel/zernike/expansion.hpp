// Truncation of the Zernike series of a disk: degrees, azimuthal orders and quadrature (docs/certificate.md, section 7).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "lommel/bounds/disk.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/zernike/disk.hpp"
#include "lommel/zernike/pupil_growth.hpp"

namespace lommel {

constexpr std::size_t max_degrees = 1600;  // maximum number of degrees of a Zernike series; n degrees take about 30 n^2 bytes

// Error budget of the Zernike series: shares of allowed errors and of the tolerance.
struct ZernikeBudget {
    // Shares of the allowed error of U. outer, inner: expansions of the full disk and of the obscuration; small: small coefficients
    // omitted from either expansion.
    static constexpr double outer = 0.5, inner = 0.5, small = 0.02;
    // Shares of a disk's allowed error. degrees: omitted degrees; this error counts `fourier` times (Lebesgue constant) if orders
    // are omitted, too. orders: omitted orders. quadrature: distance of the pupil function from polynomials, which counts twice.
    static constexpr double degrees = 0.16, fourier = 5.0, orders = 0.05, quadrature = 0.05;
    static_assert((outer + inner) * (fourier * degrees + orders + 2.0 * quadrature) + 2.0 * small <= 1.0);
    // Share of the tolerance for the error of U in the first expansion; it counts twice in I.
    static constexpr double field = 0.1;
    // Share of the tolerance for values that are divided by their maximum: if value and maximum each have a relative error r, the
    // quotient has an error of up to 2 r / (1 - r).
    static constexpr double divided = 0.4;
    static_assert(2.0 * divided <= 1.0);
    // Factor on the allowed error if the expansion is repeated.
    static constexpr double retry = 0.1;
};

// Expansion of a disk: degrees, orders, quadrature and error bounds for an allowed error of U at all radii v up to `reach`.
struct DiskExpansion {
    std::size_t degrees, orders;
    std::shared_ptr<const DiskRule> rule;
    double truncation, quadrature;
    std::size_t curve;  // index of the complex curve, of those in bounds/disk.hpp, on which the pupil function may be sampled
    double saved = 0.0;  // by how much samples lower log M(b), with M(b) the bound on the pupil function in bounds/disk.hpp

    DiskExpansion(const ZernikePhase& phase, double reach, double error) {
        check_reach(reach);
        DiskBounds bounds = phase.bounds();
        std::size_t exact = count(bounds, reach, error);
        // Samples of the pupil function at complex points lower the bound on it and hence `degrees`: faster for large expansions only.
        curve = bounds.likely(error, usual_share);
        if (work(exact) > 2.0 * GrowthTable::work(phase.list) && GrowthTable::serves(phase.list, curve)) {
            saved = less_by_samples(phase);
            bounds.lower(curve, saved);
            exact = count(bounds, reach, error);
        }
        if (degrees > max_degrees || exact > 4 * max_degrees) {
            const bool series = degrees > max_degrees;
            throw LimitExceeded(std::string("these aberrations take a ") + (series ? "Zernike series" : "quadrature") +
                                " of degree " + std::to_string(series ? degrees : exact) + ", more than the limit of " +
                                std::to_string(series ? max_degrees : 4 * max_degrees) +
                                ": less aberration or a smaller window takes fewer");
        }
        rule = DiskRule::get(exact);
        quadrature = 2.0 * bounds.distance(rule->degree - degrees);
    }

    // Estimated size of an expansion: numbers of degrees and orders; degree of exact quadrature; time to sample the pupil function.
    struct Size {
        std::size_t degrees, orders, exact;
        double samples;
    };
    static Size likely(const ZernikePhase& phase, double reach, double error) {
        DiskExpansion plan;
        DiskBounds bounds = phase.bounds();
        const std::size_t by_window = disk_window_degrees(reach, ZernikeBudget::degrees * error);
        const auto count = [&] {
            const double by_phase = bounds.likely_degrees(ZernikeBudget::degrees * error);
            plan.degrees = std::max<std::size_t>(2, std::min(static_cast<std::size_t>(std::min(by_phase, 1e9)), by_window));
            plan.orders = static_cast<std::size_t>(
                std::min(static_cast<double>(plan.degrees), bounds.likely_orders(ZernikeBudget::orders * error)));
            const double degree = bounds.likely_degree(ZernikeBudget::quadrature * error);
            return std::max(static_cast<std::size_t>(std::min(degree, 1e9)), plan.degrees) + plan.degrees;
        };
        std::size_t exact = count();
        const std::size_t at = bounds.likely(error, usual_share);
        double samples = GrowthTable::work(phase.list);
        if (plan.work(exact) > 2.0 * samples && GrowthTable::serves(phase.list, at)) {
            // Estimate: samples lower the bound on ln |pupil function| from the sum of `most` over terms to sqrt(sum of most^2).
            double squares = 0.0, sum = 0.0;
            phase.amplitudes([&](double amplitude, std::size_t n, std::size_t) {
                const double most = amplitude * chord_curves.growth[n][at];
                sum += most;
                squares += most * most;
            });
            bounds.lower(at, sum - std::sqrt(squares));
            exact = count();
        } else {
            samples = 0.0;
        }
        return {plan.degrees, plan.orders, exact, samples};
    }

    // Error bound of U. Rounding of exp(i Phi) at the nodes is not amplified in U. Sums and recurrences round each of degrees^2 / 2
    // coefficients by at most `sums` roundoffs; by Cauchy's inequality, U changes by at most `sums` * degrees / sqrt(2) roundoffs.
    double error(const ZernikePhase& phase) const {
        const double sums = rule->rounding() + static_cast<double>(rule->rings + 4 * degrees);
        const double rounding = phase.sensitivity() + 8.0 + 0.71 * static_cast<double>(degrees) * sums;
        return truncation + quadrature + unit_roundoff * rounding;
    }

   private:
    DiskExpansion() = default;

    // Typical ratio of two bounds on ln |pupil function| at complex points: (from samples) / (from the maxima of all terms).
    static constexpr double usual_share = 0.6;

    double less_by_samples(const ZernikePhase& phase) const {
        const auto table = cache<GrowthTable>.get(phase.list, curve);
        double most = 0.0;
        phase.amplitudes(
            [&](double amplitude, std::size_t n, std::size_t) { most += amplitude * chord_curves.growth[n][curve]; });
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            const SampledGrowth found = sampled_growth(isa, *table, phase.list, phase.coefficients);
            most -= found.mean + found.margin;
        });
        return std::max(0.0, most);
    }

    // Set `degrees`, `orders` and the error bound `truncation`; return the degree for which the quadrature must be exact.
    std::size_t count(const DiskBounds& bounds, double reach, double error) {
        const std::size_t by_phase = bounds.degrees(ZernikeBudget::degrees * error);
        const std::size_t by_window = disk_window_degrees(reach, ZernikeBudget::degrees * error);
        degrees = std::max<std::size_t>(2, std::min(by_phase, by_window));
        orders = std::min(degrees, bounds.orders(ZernikeBudget::orders * error));
        const double tail = by_phase <= by_window ? bounds.tail(degrees) : disk_window_tail(degrees, reach);
        truncation = orders < degrees ? ZernikeBudget::fourier * tail + bounds.orders_tail(orders) : tail;
        return std::max(bounds.degree(ZernikeBudget::quadrature * error), degrees) + degrees;
    }

    // Estimated time of the expansion in vector operations. exact: degree for which the quadrature is exact.
    double work(std::size_t exact) const {
        const double rings = 0.25 * static_cast<double>(exact), n = static_cast<double>(degrees);
        return 0.5 * rings * rings * static_cast<double>(orders) + 0.2 * n * n * rings;
    }
};

// Omit the coefficients of highest degree of each azimuthal order, so that the field U changes by at most `error`; return a bound
// on the change. weight: factor of this disk's field in U.
inline double trim(ZernikeSeries& series, double weight, double error) {
    double left = 0.0;
    const double share = error / static_cast<double>(series.orders + 1);
    for (std::size_t m = 0; m < series.orders; ++m) {
        double sum = 0.0;
        std::size_t& count = series.used[m];
        for (; count > 0; --count) {
            const std::size_t at = series.start[m] + count - 1;
            const double size = series.size(at, 0) + series.size(at, 1);
            const double next = sum + weight * size / static_cast<double>(m + 2 * count - 1);
            if (next > share) {
                break;
            }
            sum = next;
        }
        left += sum;
    }
    return left;
}

}  // namespace lommel
