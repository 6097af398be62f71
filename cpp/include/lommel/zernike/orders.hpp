// Selection of the azimuthal orders of the field to evaluate, for the whole image and for each radial piece (interval of v).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "lommel/zernike/azimuth.hpp"
#include "lommel/zernike/disk.hpp"
#include "lommel/zernike/expansion.hpp"

namespace lommel {

// Plan for a radial piece: orders in use, and number of rings (narrower intervals of v) that divide the piece (0: not divided).
struct PiecePlan {
    ActiveOrders orders;
    std::vector<std::size_t> rows;  // [order in use]: index of its coefficients in the piece
    std::size_t rings = 1;
    double error = 0.0;  // bound on the error of U
};

// Bound on the contribution of an azimuthal order to U. near: valid at all radii v, from |2 (n+1) J_{n+1}(v) / v| <= 1; far: factor
// of a bound that falls as v^(-4/3), from |J_n(v)| < 0.7858 v^(-1/3) (Landau 2000).
struct OrderSize {
    double near = 0.0, far = 0.0;
    static double fall(double v) { return v > 0.0 ? 1.572 / (v * std::cbrt(v)) : 1e200; }
    double fallen(double by) const { return std::min(near, far * by); }
    double at(double v) const { return fallen(fall(v)); }
};

// Add bounds on each order m of a disk's field to sizes[2 m] (cosine) and sizes[2 m + 1] (sine). weight: factor of this field;
// shrunk: radius of the disk relative to the full disk, so that its field depends on shrunk * v.
inline void add_sizes(const ZernikeSeries& series, double weight, double shrunk, std::vector<OrderSize>& sizes) {
    const double stretch = 1.0 / (shrunk * std::cbrt(shrunk));
    for (std::size_t m = 0; m < series.orders; ++m) {
        for (std::size_t j = 0; j < 2 * series.used[m]; ++j) {
            const double size = weight * series.size(series.start[m] + j / 2, j % 2);
            sizes[2 * m + j % 2].near += size / static_cast<double>(m + j / 2 * 2 + 1);
            sizes[2 * m + j % 2].far += size * stretch;
        }
    }
}

// Bounds on the azimuthal orders of a pupil, and the orders that are kept for an image.
class PupilOrders {
   public:
    // Compute the bounds on all orders of a pupil, as sums over full disk and obscuration.
    void measure(const ZernikeSeries& outer, const ZernikeSeries& inner, double obscuration) {
        sizes_.assign(2 * std::max(outer.orders, inner.orders), OrderSize());
        add_sizes(outer, 1.0, 1.0, sizes_);
        if (obscuration > 0.0) {
            add_sizes(inner, obscuration * obscuration, obscuration, sizes_);
        }
    }

    // Keep all azimuthal orders except those with the smallest bounds, which sum to at most `error`; return that sum.
    double keep(double error) {
        std::vector<std::size_t> rising(sizes_.size() / 2);
        const auto size = [&](std::size_t m) { return sizes_[2 * m].near + sizes_[2 * m + 1].near; };
        std::iota(rising.begin(), rising.end(), std::size_t{0});
        std::sort(rising.begin(), rising.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
        double left = 0.0;
        std::size_t out = 0;
        for (; out < rising.size() && left + size(rising[out]) <= error; ++out) {
            left += size(rising[out]);
        }
        kept_.assign(rising.begin() + static_cast<std::ptrdiff_t>(out), rising.end());
        std::sort(kept_.begin(), kept_.end(),
                  [](std::size_t a, std::size_t b) { return a % 4 != b % 4 ? a % 4 < b % 4 : a < b; });
        return left;
    }

    // Write to `plan` the kept orders that U needs at radii of at least v: all up to a highest one, and the sines of all of them or
    // of none. Return a bound, at most `error`, on the sum of the kept orders and sines that are missing from `plan`.
    double select(double v, double error, PiecePlan& plan) const {
        double left = 0.0;
        for (const std::size_t m : kept_) {
            left += sizes_[2 * m + 1].at(v);
        }
        plan.orders.sines = left > ZernikeBudget::sines * error;
        left = plan.orders.sines ? 0.0 : left;
        const auto size = [&](std::size_t m) {
            return sizes_[2 * m].at(v) + (plan.orders.sines ? sizes_[2 * m + 1].at(v) : 0.0);
        };
        thread_local std::vector<double> by_order;
        by_order.assign(sizes_.size() / 2, 0.0);
        for (const std::size_t m : kept_) {
            by_order[m] = size(m);
        }
        std::size_t end = by_order.size();
        while (end > 0 && left + by_order[end - 1] <= error) {
            left += by_order[--end];
        }
        for (std::size_t i = 0; i < kept_.size(); ++i) {
            if (kept_[i] < end) {
                plan.orders.add(kept_[i]);
                plan.rows.push_back(i);
            }
        }
        return left;
    }

    // Orders kept, sorted by m modulo 4, then by m.
    const std::vector<std::size_t>& kept() const { return kept_; }

   private:
    std::vector<OrderSize> sizes_;  // [2 m]: cosine of order m; [2 m + 1]: sine
    std::vector<std::size_t> kept_;
};

}  // namespace lommel
