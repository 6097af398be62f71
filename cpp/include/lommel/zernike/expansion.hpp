// Truncation of the Zernike series of a disk: degrees, orders and quadrature for a tolerance.
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

constexpr std::size_t max_degrees = 1600;  // of a Zernike series; it takes about 30 n^2 bytes

// What the error of an image is spent on.
struct ZernikeBudget {
    // Of the error of U that a pupil is expanded to, on the disk and the obscured one, and on coefficients of each that turn
    // out to be small.
    static constexpr double outer = 0.5, inner = 0.5, small = 0.02;
    // Of that of a disk, on degrees left out, which leaving out orders, too, magnifies by the Lebesgue constant of Fourier sums,
    // below 5; on orders left out; and on the distance from polynomials, which counts twice in quadrature.
    static constexpr double degrees = 0.16, fourier = 5.0, orders = 0.05, quadrature = 0.05;
    static_assert((outer + inner) * (fourier * degrees + orders + 2.0 * quadrature) + 2.0 * small <= 1.0);
    // Of the error of U where the image is brightest, on what all pieces leave out: coefficients of each disk, orders, and
    // interpolation across pieces.
    static constexpr double trimmed = 0.1, dropped = 0.1, pieces = 0.1;
    static_assert(2.0 * trimmed + dropped + pieces <= 1.0);
    // Of what that leaves of the error of U in a piece, on orders of its own, all sines among them where these take only a
    // part of it, and on interpolation across rings; the rest serves single precision.
    static constexpr double own_orders = 0.3, sines = 0.3, rings = 0.3;
    static_assert(own_orders + rings <= 1.0 && sines <= 1.0);
    // Of the error that all pieces have, on interpolation across rings at least.
    static constexpr double beside = 0.05;
    // Of the tolerance, on U, which counts twice in I, to begin with; on every piece; and what has more is done again. The rest
    // is a margin, for brightness is a guess.
    static constexpr double field = 0.1, image = 0.5, most = 0.7;
    static_assert(2.0 * field <= image && image <= most && most <= 1.0);
    // Of the tolerance where values are divided by their largest one, itself in error: 2 r / (1 - r) of values off by r.
    static constexpr double divided = 0.4;
    static_assert(2.0 * divided <= 1.0);
    // What is asked where that did not do: parts of what was asked before, of the expansion and of a piece. Of pieces it is not
    // the expansion that is to blame as long as this many times its error is less than theirs.
    static constexpr double again = 0.1, piece_again = 0.2, blame = 3.0;
};

// How a disk is expanded: enough degrees, orders and quadrature for an error in U at every v up to a reach.
struct DiskExpansion {
    std::size_t degrees, orders;
    std::shared_ptr<const DiskRule> rule;
    double truncation, quadrature;
    std::size_t curve;
    double saved = 0.0;  // by samples, of the logarithm that bounds the pupil function on that curve

    DiskExpansion(const ZernikePhase& phase, double reach, double error);

    // About how large it will be, without its samples and tables; and the work of the samples, as GrowthTable has it.
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
            // Terms add up as if they were independent.
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

    // Roundings of exp(i Phi) at the nodes reach U undiminished at most; those of the sums and of the recurrences are
    // those of each coefficient, and Cauchy over all of them gives sqrt(degrees^2 / 2).
    double error(const ZernikePhase& phase) const {
        const double sums = rule->rounding() + static_cast<double>(rule->rings + 4 * degrees);
        const double rounding = phase.sensitivity() + 8.0 + 0.71 * static_cast<double>(degrees) * sums;
        return truncation + quadrature + unit_roundoff * rounding;
    }

   private:
    DiskExpansion() = default;

    // What the mean of a pupil function on a curve usually is of the most that its terms may be, as logarithms.
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

    // Degrees, orders and what leaving out the others does; returns the degree that the quadrature must be exact for.
    std::size_t count(const DiskBounds& bounds, double reach, double error) {
        const std::size_t by_phase = bounds.degrees(ZernikeBudget::degrees * error);
        const std::size_t by_window = disk_window_degrees(reach, ZernikeBudget::degrees * error);
        degrees = std::max<std::size_t>(2, std::min(by_phase, by_window));
        orders = std::min(degrees, bounds.orders(ZernikeBudget::orders * error));
        const double tail = by_phase <= by_window ? bounds.tail(degrees) : disk_window_tail(degrees, reach);
        truncation = orders < degrees ? ZernikeBudget::fourier * tail + bounds.orders_tail(orders) : tail;
        return std::max(bounds.degree(ZernikeBudget::quadrature * error), degrees) + degrees;
    }

    // Vector operations of the expansion, roughly.
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
    // Samples cost little beside what they save of large expansions.
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

// Shortens the series of each order by what adds no more than `error` to U in all; returns what it does add.
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
