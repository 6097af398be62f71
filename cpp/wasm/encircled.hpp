// Encircled energy about the optical axis and mean intensity on circles, for a circular or annular aperture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

// Mean intensity on circles about the axis, as Chebyshev series on intervals (panels) of the radius v.
//
// Along any line the intensity is of exponential type 2 and between 0 and its peak; so is its mean over all directions, an even
// function of v. Interpolation of this mean at Chebyshev points has an error of at most e = interpolation_error() * peak / 2, so
// that of energy(v) is at most e * v^2 / 2. Errors of the given means at these points are multiplied by at most lebesgue().
class MeanProfile {
   public:
    // at(v): mean intensity on the circle of radius v <= reach; allowed: its allowed interpolation error, divided by peak / 2.
    template <class At>
    MeanProfile(double reach, double allowed, const At& at) {
        const std::size_t panels = static_cast<std::size_t>(std::ceil(reach / widest)) + 1;
        half_ = 0.5 * reach / static_cast<double>(panels);
        points_ = fewest(2, [&](std::size_t n) { return interpolation_error(half_, n) <= allowed; });
        const double turn = pi / static_cast<double>(2 * points_);
        std::vector<double> cosines(4 * points_), values(points_), moment(points_ + 3);
        for (std::size_t i = 0; i < cosines.size(); ++i) {
            cosines[i] = std::cos(turn * static_cast<double>(i));
        }
        means_.assign(panels * points_, 0.0);
        energies_.assign(panels * (points_ + 2), 0.0);
        double inside = 0.0;
        for (std::size_t s = 0; s < panels; ++s) {
            for (std::size_t j = 0; j < points_; ++j) {
                values[j] = at(middle(s) + half_ * cosines[2 * j + 1]);
            }
            double* const mean = &means_[s * points_];
            for (std::size_t k = 0; k < points_; ++k) {
                double sum = 0.0;
                for (std::size_t j = 0; j < points_; ++j) {
                    sum += cosines[k * (2 * j + 1) % (4 * points_)] * values[j];
                }
                mean[k] = (k == 0 ? 1.0 : 2.0) * sum / static_cast<double>(points_);
            }
            inside = integrate_moment(half_, middle(s), mean, points_, inside, moment.data(), &energies_[s * (points_ + 2)]);
        }
    }

    // Mean intensity on the circle of radius v around the axis.
    double mean(double v) const {
        const std::size_t s = panel(v);
        return series(&means_[s * points_], points_, place(v, s));
    }
    // (Encircled energy) / (2 pi): integral of mean(s) s ds from 0 to v.
    double energy(double v) const {
        const std::size_t s = panel(v);
        return series(&energies_[s * (points_ + 2)], points_ + 2, place(v, s));
    }

    // Bound on (error of mean() due to errors of the given values at(v)) / (largest of these errors).
    double magnification() const { return lebesgue(points_); }

   private:
    static constexpr double widest = 20.0;  // largest width of a panel in v

    double middle(std::size_t s) const { return half_ * static_cast<double>(2 * s + 1); }
    std::size_t panel(double v) const {
        return std::min(means_.size() / points_ - 1, static_cast<std::size_t>(std::max(0.0, 0.5 * v / half_)));
    }
    double place(double v, std::size_t s) const { return std::min(1.0, (v - middle(s)) / half_); }

    // Sum over k < count of c[k] T_k(x), with Chebyshev polynomials T_k, by Clenshaw's recurrence.
    static double series(const double* c, std::size_t count, double x) {
        double after = 0.0, here = 0.0;
        for (std::size_t k = count; --k > 0;) {
            const double before = 2.0 * x * here - after + c[k];
            after = here;
            here = before;
        }
        return x * here - after + c[0];
    }

    double half_ = 1.0;
    std::size_t points_ = 1;
    std::vector<double> means_, energies_;  // coefficients of Chebyshev polynomials, [panel][index]
};

}  // namespace lommel
