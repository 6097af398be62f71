// Quadrature over the frequencies along one axis, that bounds what an error of the response costs averages: certificate 10.
//
// The transfer function of a pupil function of modulus at most 1 on the disk is at most the autocorrelation of the disk. Summed along
// the other axis this is the autocorrelation of its chords, of integral 1, and at most 16 / (3 pi^2) y^2, y = 1 - w^2 / 4, with
// equality at w = 0. By Schwarz's inequality, as the integral of the root of y is pi, the mean modulus of an error e is at most the
// root of (16 / (3 pi^2))^2 pi times the integral of sqrt(y) y^3 e^2; nearly without loss for filters, whose errors are largest at the
// end of the band. Of polynomials Gauss's rule of Chebyshev polynomials of the second kind has that integral exactly.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/pi.hpp"

namespace lommel {

// Chebyshev points of the band, at which the error of the response of samples up to a distance T = `reach` is found.
//
// It is even or odd, and entire, of type T; all but 1e-17 of it is a polynomial in w of degree M = 2.36 T + 48 (its Chebyshev series
// falls below e^-48 there), M being the number of points. As a trigonometric polynomial of the angle it falls from its largest value
// no faster than cos(M s) (Duffin and Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938), and one of 2 M Chebyshev points is within
// pi / (4 M) of it: it is at most sqrt(2) times as large as at these.
inline std::vector<double> band_points(double reach) {
    constexpr double half_pi = 1.5707963267948966;
    std::vector<double> w(static_cast<std::size_t>(std::ceil(2.36 * reach)) + 48);
    for (std::size_t i = 0; i < w.size(); ++i) {
        w[i] = 2.0 * std::cos((static_cast<double>(i) + 0.5) * (half_pi / static_cast<double>(w.size())));
    }
    return w;
}

// Frequencies from 0 to 2 and weights, by which the root of the sum of squares bounds the mean modulus of polynomials up to a degree
// in w, even or odd.
struct TransferRule {
    std::vector<double> at, weights;

    explicit TransferRule(std::size_t degree) {
        const std::size_t half = (degree + 5) / 2;
        const double count = static_cast<double>(2 * half + 1), most = 16.0 / (3.0 * pi * pi);
        for (std::size_t i = 1; i <= half; ++i) {
            const double angle = static_cast<double>(i) * pi / count;
            at.push_back(2.0 * std::cos(angle));
            // Of w = 2 cos(angle) on either side, dw being 2 dcos.
            weights.push_back(most * most * pi * 4.0 * pi / count * std::pow(std::sin(angle), 8));
        }
    }
};

}  // namespace lommel
