// Quadrature over the spatial frequency w along one axis (cutoff |w| = 2), for the error of averages due to the error e(w) of a
// filter's response (certificate, section 10, "The mean error of a response").
//
// The transfer function of a pupil with amplitudes of at most 1 is at most the autocorrelation of the unit disk. Integrated over
// the other axis, this is at most c y^2, c = 16 / (3 pi^2), y = 1 - w^2 / 4, and has the integral 1. By Schwarz's inequality the
// mean of |e| with this weight is at most sqrt(c^2 pi (integral of y^(7/2) e^2)). This bound is close for filters, whose errors are
// largest near the cutoff. Gauss quadrature with Chebyshev polynomials of the second kind is exact for polynomials e.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/pi.hpp"

namespace lommel {

// Chebyshev points of the frequency band |w| <= 2, for the largest error of a filter's response, which is at most sqrt(2) times
// the largest error at these points. T = `reach` is the distance up to which the filter has samples.
//
// The error is even or odd in w and entire of type T; all but 1e-17 of it is a polynomial of degree M = 2.36 T + 48. As a
// function of the angle a, w = 2 cos(a), it falls from its maximum no faster than cos(M s) with the distance s (Duffin and
// Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938). One of 2 M Chebyshev points has s <= pi / (4 M); by symmetry M are enough.
inline std::vector<double> band_points(double reach) {
    constexpr double half_pi = 1.5707963267948966;
    std::vector<double> w(static_cast<std::size_t>(std::ceil(2.36 * reach)) + 48);
    for (std::size_t i = 0; i < w.size(); ++i) {
        w[i] = 2.0 * std::cos((static_cast<double>(i) + 0.5) * (half_pi / static_cast<double>(w.size())));
    }
    return w;
}

// Nodes at[i], frequencies w in (0, 2), and weights: sqrt(sum of weights e(w)^2) is a bound on the mean of |e| with the
// transfer function as weight, for even or odd polynomials e(w) of at most the given degree.
struct TransferRule {
    std::vector<double> at, weights;

    explicit TransferRule(std::size_t degree) {
        const std::size_t half = (degree + 5) / 2;
        const double count = static_cast<double>(2 * half + 1), most = 16.0 / (3.0 * pi * pi);
        for (std::size_t i = 1; i <= half; ++i) {
            const double angle = static_cast<double>(i) * pi / count;
            at.push_back(2.0 * std::cos(angle));
            // The weight counts for both w = 2 cos(angle) and -w; dw = 2 d cos(angle).
            weights.push_back(most * most * pi * 4.0 * pi / count * std::pow(std::sin(angle), 8));
        }
    }
};

}  // namespace lommel
