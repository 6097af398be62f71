// Design of the filters for pixel averages, for a given pixel pitch; filter.hpp applies them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/limits.hpp"
#include "lommel/special/least_squares.hpp"

namespace lommel {

// Symmetric filter with taps c_k on samples at spacing h, whose frequency response C(w) = sum_k c_k cos(k h w) approximates
// that of a pixel of width a, sinc(a w / 2), in the band |w| <= 2 of an intensity. All lengths are in optical units.
//
// The taps are a least-squares fit at Chebyshev points of the band. The error of the response is even and entire, of
// exponential type k h for the largest k; up to 1e-17 it is a polynomial in w of degree M = 2.36 k h + 48, as its Chebyshev
// series falls below e^-48 there. As a trigonometric polynomial of an angle it falls, at an angle s from its maximum, no
// faster than cos(M s) (Duffin and Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938). One of 2 M Chebyshev points is within
// pi / (4 M) of the maximum, so the maximum is at most sqrt(2) times the largest value at these points.
struct PixelTaps {
    std::size_t stride;           // number of samples per pixel pitch
    std::vector<double> weights;  // filter taps, an odd number, centred on the pixel
    double error;                 // bound on the error of the frequency response in the band of an intensity
    double gain;                  // sum of the moduli of the weights: largest amplification of errors of samples

    std::size_t margin() const { return weights.size() / 2; }

    // Shortest filter for pixels of pitch `step` and samples at most `widest` apart (optical units); response error <= `allowed`.
    PixelTaps(double step, double allowed, double widest) : stride(across(step, widest)), error(0.0), gain(0.0) {
        const double h = step / static_cast<double>(stride);
        const std::size_t most = stride + 62;
        const std::size_t degree = static_cast<std::size_t>(std::ceil(2.36 * static_cast<double>(most) * h)) + 48;
        std::vector<double> w(degree), wanted(degree), factors(degree);
        for (std::size_t i = 0; i < degree; ++i) {
            w[i] = 2.0 * std::cos((static_cast<double>(i) + 0.5) * (1.5707963267948966 / static_cast<double>(degree)));
            const double turn = 0.5 * step * w[i];
            wanted[i] = turn == 0.0 ? 1.0 : std::sin(turn) / turn;
        }
        LeastSquares fit({wanted}, most, 1e-12);
        std::vector<std::vector<double>> basis;
        for (std::size_t half = 0; half < most; ++half) {
            for (std::size_t i = 0; i < degree; ++i) {
                factors[i] = half == 0 ? 1.0 : 2.0 * std::cos(w[i] * (h * static_cast<double>(half)));
            }
            basis.push_back(factors);
            fit.add(factors);
            if (half >= stride / 2 + 2) {
                judge(fit.solution(), basis, wanted);
                // A filter that ends close to the edge of a large pixel has large weights, which would amplify errors of samples.
                if (error <= allowed && gain <= 1.5) {
                    break;
                }
            }
        }
    }

    static std::size_t across(double step, double widest) {
        return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(step / widest)));
    }

   private:
    void judge(const std::vector<double>& c, const std::vector<std::vector<double>>& basis, const std::vector<double>& wanted) {
        const std::size_t half = c.size() - 1;
        std::vector<double> off(wanted);
        gain = std::abs(c[0]);
        for (std::size_t k = 0; k < c.size(); ++k) {
            gain += k == 0 ? 0.0 : 2.0 * std::abs(c[k]);
            for (std::size_t i = 0; i < off.size(); ++i) {
                off[i] -= basis[k][i] * c[k];
            }
        }
        double worst = 0.0;
        for (const double x : off) {
            worst = std::max(worst, std::abs(x));
        }
        const double rounding = 2.0 * unit_roundoff * static_cast<double>(half + 4) * gain;
        error = 1.4142135623730951 * (worst + rounding) + 1e-17;
        weights.assign(2 * half + 1, 0.0);
        for (std::size_t k = 0; k <= half; ++k) {
            weights[half + k] = weights[half - k] = c[k];
        }
    }
};

// Lower bound on the largest average over a pixel of pitch `step` (optical units) at any position, divided by the peak intensity.
//
// Let M be the peak of the intensity I. Along a line through the peak, f = 2 I - M is of exponential type 2 and at most M in
// modulus, so f'^2 + 4 f^2 <= 4 M^2 (Duffin and Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938): at a distance s <= pi/2 from
// the peak, I >= M cos(s)^2. In a pixel centred on the peak, this bound is integrated over the disk around the peak with the radius
// min(step / 2, pi / 2), and divided by the pixel's area step^2.
inline double least_average(double step) {
    constexpr double half_pi = 1.5707963267948966;
    const double r = std::min(0.5 * step, half_pi), sine = std::sin(r);
    return half_pi * (r * r + r * std::sin(2.0 * r) - sine * sine) / (step * step);
}

}  // namespace lommel
