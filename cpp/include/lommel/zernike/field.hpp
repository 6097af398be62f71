// Field of a pupil without radial symmetry: its Zernike series, with an error bound (docs/certificate.md, section 7).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/zernike/disk.hpp"
#include "lommel/zernike/expansion.hpp"

namespace lommel {

// Field U of one pupil: the Zernike series of its full disk and of the obscuration, with an error bound.
class ZernikeField {
   public:
    // Expand the pupil for an error of U of about `error` at v <= reach. outer: phase on the full disk; inner: phase within the
    // obscuration, a function of (radius / its radius); lost: error of U from rounding in the coefficients of both phases.
    void expand(const ZernikePhase& outer, const ZernikePhase& inner, double obscuration, double reach, double error,
                double lost = 0.0, int threads = 1) {
        // An obscuration is neglected if its area is below rounding.
        obscuration_ = obscuration < 1e-9 ? 0.0 : obscuration;
        const double area = obscuration_ * obscuration_;
        reach_ = reach;
        // The rounding error of v is at most 6 v u, u being the unit roundoff; as |dU/dv| < 1/2, that of U is at most 3 v u.
        base_ = lost + expand(outer, reach, ZernikeBudget::outer * error, threads, outer_) + 3.0 * unit_roundoff * reach;
        inner_.degrees = inner_.orders = 0;
        if (area > 0.0) {
            base_ += area * expand(inner, obscuration_ * reach, ZernikeBudget::inner * error, threads, inner_);
        }
        base_ += trim(outer_, 1.0, ZernikeBudget::small * error) + trim(inner_, area, ZernikeBudget::small * error);
    }

    // Mean of I over all azimuths at the radius v; different orders are orthogonal.
    double mean(double v) const {
        const std::vector<double>& orders = all_orders(v);
        double sum = 0.0;
        for (std::size_t i = 0; i < orders.size(); ++i) {
            sum += (i < 4 ? 1.0 : 0.5) * orders[i] * orders[i];
        }
        return sum;
    }

    // Field at the radius v in the direction (cosine, sine), from Bessel functions without interpolation; its error is at most
    // base() + rounding().
    std::complex<double> at(double v, double cosine, double sine) const {
        const std::vector<double>& orders = all_orders(v);
        double c = 1.0, s = 0.0, re = 0.0, im = 0.0;
        for (std::size_t i = 0; i < orders.size(); i += 4) {
            re += c * orders[i] + s * orders[i + 2];
            im += c * orders[i + 1] + s * orders[i + 3];
            const double next = c * cosine - s * sine;
            s = s * cosine + c * sine;
            c = next;
        }
        return {re, im};
    }
    // The moduli of all terms sum to at most 2 for either disk (Cauchy), and Bessel functions are accurate to 8 roundings.
    double rounding() const {
        const double terms = static_cast<double>(std::max(outer_.degrees, inner_.degrees));
        return 2.0 * (1.0 + obscuration_ * obscuration_) * unit_roundoff * (12.0 * terms + 60.0);
    }

    double base() const { return base_; }  // error bound of U at radii v up to reach()
    bool obscured() const { return obscuration_ > 0.0; }
    double obscuration() const { return obscuration_; }
    double reach() const { return reach_; }
    const ZernikeSeries& outer() const { return outer_; }
    const ZernikeSeries& inner() const { return inner_; }

   private:
    double expand(const ZernikePhase& phase, double reach, double error, int threads, ZernikeSeries& series) {
        check_phase(phase.size());
        const DiskExpansion plan(phase, reach, error);
        analysis_.run(*plan.rule, phase, plan.degrees, plan.orders, threads, series);
        return plan.error(phase);
    }

    // Factors A_m, B_m of cos(m psi), sin(m psi) in U at the radius v: [order m][re A, im A, re B, im B].
    const std::vector<double>& all_orders(double v) const {
        thread_local std::vector<double> orders;
        orders.assign(4 * std::max(outer_.orders, inner_.orders), 0.0);
        add_orders(outer_, v, 1.0, orders.data());
        if (obscured()) {
            add_orders(inner_, obscuration_ * v, -obscuration_ * obscuration_, orders.data());
        }
        return orders;
    }

    // Add A_m(v), B_m(v) of one disk, times `weight`, to the four numbers of each order m in `orders`.
    static void add_orders(const ZernikeSeries& series, double v, double weight, double* orders) {
        thread_local std::vector<double> bessel, transforms[2];
        // J_{n+1}(v) is negligible for degrees n far above v.
        const std::size_t reached = std::min(series.degrees, static_cast<std::size_t>(v + 6.0 * std::cbrt(v) + 12.0));
        for (std::size_t parity = 0; parity < 2; ++parity) {
            transforms[parity].assign((series.degrees + 2) / 2, 0.0);
            zernike_transforms(parity, v, (reached + 2) / 2, transforms[parity].data(), bessel);
        }
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using I = decltype(isa);
            using V = typename I::pack;
            for (std::size_t m = 0; m < std::min(reached, series.orders); ++m) {
                const double* row = transforms[m % 2].data() + m / 2;
                const std::size_t count = std::min(series.used[m], (reached - m) / 2 + 1), at = series.start[m];
                V sums[4] = {};
                std::size_t j = 0;
                for (; j + I::lanes <= count; j += I::lanes) {
                    const V t = load<V>(row + j);
                    for (std::size_t p = 0; p < 4; ++p) {
                        sums[p] = sums[p] + t * load<V>(&series.parts[p][at + j]);
                    }
                }
                for (std::size_t p = 0; p < 4; ++p) {
                    double total = lane_sum(sums[p]);
                    for (std::size_t i = j; i < count; ++i) {
                        total += row[i] * series.parts[p][at + i];
                    }
                    orders[4 * m + p] += weight * total;
                }
            }
        });
    }

    ZernikeSeries outer_, inner_;
    ZernikeAnalysis analysis_;
    double obscuration_ = 0.0, reach_ = 0.0, base_ = 0.0;
};

}  // namespace lommel
