// Quadrature over the frequencies w along one axis, for the error of averages from the error e(w) of a filter's response
// (certificate, section 10, "The mean error of a response").
//
// The transfer function of a pupil function of modulus at most 1 on the disk is at most the autocorrelation of the disk.
// Integrated along the other axis this is the autocorrelation of the disk's chords, of integral 1, and at most 16 / (3 pi^2)
// y^2, y = 1 - w^2 / 4, with equality at w = 0. By Schwarz's inequality, as the integral of sqrt(y) is pi, the weighted mean of
// |e| is at most the root of (16 / (3 pi^2))^2 pi times the integral of sqrt(y) y^3 e^2. The bound is close for filters, whose
// errors are largest at the end of the band. Gauss quadrature with Chebyshev polynomials of the second kind is exact for
// polynomials e.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/pi.hpp"

namespace lommel {

// Chebyshev points of the band [-2, 2] for the error of the response of samples up to a distance T = `reach`.
//
// The error is even or odd, and entire of type T; all but 1e-17 of it is a polynomial in w of degree M = 2.36 T + 48 (its
// Chebyshev series falls below e^-48 there). As a trigonometric polynomial of the angle, the error falls from its maximum no
// faster than cos(M s) (Duffin and Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938), and one of 2 M Chebyshev points is within
// pi / (4 M) of the maximum, which is hence at most sqrt(2) times the largest value at these points. By symmetry M of them
// suffice.
inline std::vector<double> band_points(double reach) {
    constexpr double half_pi = 1.5707963267948966;
    std::vector<double> w(static_cast<std::size_t>(std::ceil(2.36 * reach)) + 48);
    for (std::size_t i = 0; i < w.size(); ++i) {
        w[i] = 2.0 * std::cos((static_cast<double>(i) + 0.5) * (half_pi / static_cast<double>(w.size())));
    }
    return w;
}

// Nodes `at` in (0, 2) and weights for the bound sqrt(sum of weights e^2) on the mean of |e| under the transfer function, for e
// an even or odd polynomial in w of at most the given degree.
struct TransferRule {
    std::vector<double> at, weights;

    explicit TransferRule(std::size_t degree) {
        const std::size_t half = (degree + 5) / 2;
        const double count = static_cast<double>(2 * half + 1), most = 16.0 / (3.0 * pi * pi);
        for (std::size_t i = 1; i <= half; ++i) {
            const double angle = static_cast<double>(i) * pi / count;
            at.push_back(2.0 * std::cos(angle));
            // Both w = 2 cos(angle) and -w count; dw = 2 d cos(angle).
            weights.push_back(most * most * pi * 4.0 * pi / count * std::pow(std::sin(angle), 8));
        }
    }
};

}  // namespace lommel
