// Truncation of the Zernike series of a disk: degrees, azimuthal orders and quadrature (docs/certificate.md, section 7).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

#include "lommel/base/once.hpp"
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
    // Shares of a disk's allowed error. degrees: omitted degrees (if orders are omitted too, times `fourier`, a bound on Lebesgue's
    // constant of Fourier sums); orders: omitted orders; quadrature: distance of the pupil function from polynomials, counts twice.
    static constexpr double degrees = 0.16, fourier = 5.0, orders = 0.05, quadrature = 0.05;
    static_assert((outer + inner) * (fourier * degrees + orders + 2.0 * quadrature) + 2.0 * small <= 1.0);
    // Shares of the allowed error of U at the brightest point, for errors that all radial pieces have in common. trimmed: omitted
    // coefficients of each disk; dropped: omitted orders; pieces: interpolation across a piece.
    static constexpr double trimmed = 0.1, dropped = 0.1, pieces = 0.1;
    static_assert(2.0 * trimmed + dropped + pieces <= 1.0);
    // Shares of the error of U that is left for one radial piece. own_orders: orders omitted in this piece; sines: all sines
    // are omitted if they are below this share of own_orders; rings: interpolation across rings. The rest is for single precision.
    static constexpr double own_orders = 0.3, sines = 0.3, rings = 0.3;
    static_assert(own_orders + rings <= 1.0 && sines <= 1.0);
    // Minimum error of interpolation across rings, as a share of the error of U that all pieces have in common.
    static constexpr double rings_least = 0.05;
    // Shares of the tolerance. field: error of U of the first expansion, which counts twice in I; image: error of a piece; most:
    // error above which a piece is repeated. The difference from 1 is a margin for the estimated brightness.
    static constexpr double field = 0.1, image = 0.5, most = 0.7;
    static_assert(2.0 * field <= image && image <= most && most <= 1.0);
    // Share of the tolerance if values are divided by their maximum: with a relative error r of both, the quotient has an error of
    // up to 2 r / (1 - r).
    static constexpr double divided = 0.4;
    static_assert(2.0 * divided <= 1.0);
    // Factors on the allowed error when a computation is repeated. retry: expansion; piece_retry: piece. The expansion is repeated
    // if `blame` times the expansion's error exceeds the error of the piece.
    static constexpr double retry = 0.1, piece_retry = 0.2, blame = 3.0;
};

// Expansion of a disk: degrees, orders, quadrature and error bounds for an allowed error of U at all radii v up to `reach`.
struct DiskExpansion {
    std::size_t degrees, orders;
    std::shared_ptr<const DiskRule> rule;
    double truncation, quadrature;
    std::size_t curve;
    double saved = 0.0;  // by how much samples lower log M(b), with M(b) the bound on the pupil function in bounds/disk.hpp

    DiskExpansion(const ZernikePhase& phase, double reach, double error);

    // Size of an expansion, estimated without samples. exact: degree for which quadrature is exact; samples: time of sampling.
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
            // Estimated result of sampling: the exponents of the terms add in quadrature, as if the terms were independent.
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

    // Error bound of U. Rounding of exp(i Phi) at the nodes is not amplified in U. Rounding of sums and recurrences is relative to
    // each of degrees^2 / 2 coefficients; by Cauchy's inequality, all together add at most degrees / sqrt(2) times as much as one.
    double error(const ZernikePhase& phase) const {
        const double sums = rule->rounding() + static_cast<double>(rule->rings + 4 * degrees);
        const double rounding = phase.sensitivity() + 8.0 + 0.71 * static_cast<double>(degrees) * sums;
        return truncation + quadrature + unit_roundoff * rounding;
    }

   private:
    DiskExpansion() = default;

    // Typical (bound from samples) / (bound from the maxima of all terms), both on the logarithm of a pupil function's growth.
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

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE DiskExpansion::DiskExpansion(const ZernikePhase& phase, double reach, double error) {
    check_reach(reach);
    DiskBounds bounds = phase.bounds();
    std::size_t exact = count(bounds, reach, error);
    // Sampling saves time in large expansions only.
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
#endif

// Omit the highest coefficients of each order, so that U changes by at most `error`, and return a bound on the change. weight:
// factor of the disk's field.
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
