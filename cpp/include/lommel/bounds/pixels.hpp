// Error bounds of pixel averages (docs/certificate.md, section 9), for a function f of the distance from the axis that is of
// exponential type 2 along every line and differs from a constant by at most 1: 2 * intensity / (its maximum), or (a derivative of
// the intensity) / (its bound). Lengths are in units of lambda / (2 pi NA).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lommel {

// Bound on the Lebesgue constant of Chebyshev points of the first kind.
inline double lebesgue(std::size_t points) { return 1.0 + 0.63661977236758134 * std::log(static_cast<double>(points)); }

// log n! to rounding; from n = 16 on by Stirling's series, with the first omitted term below 1 / (1188 n^9). std::lgamma is not
// used: it sets a global sign, a data race between threads.
inline double log_factorial(double n) {
    if (n < 16.0) {
        double product = 1.0;
        for (double k = 2.0; k <= n; ++k) {
            product *= k;
        }
        return std::log(product);
    }
    const double x = 1.0 / (n * n), sum = 1.0 / 12.0 - x * (1.0 / 360.0 - x * (1.0 / 1260.0 - x / 1680.0));
    return (n + 0.5) * std::log(n) - n + 0.91893853320467274 + sum / n;
}

// Error of interpolating a function f at n = `points` Chebyshev points on a length of 2 `half`, if |n-th derivative of f| <= 2^n.
inline double interpolation_by_slope(double half, std::size_t points) {
    const double n = static_cast<double>(points);
    return std::exp(std::min(std::log(2.0) + n * std::log(half) - log_factorial(n), 700.0));
}

// Factor by which interpolation_by_slope() grows if a function of the radius r >= `radius` is interpolated in r^2 instead of r.
inline double of_squares(double radius, std::size_t points) {
    double sum = 1.0, term = 1.0;
    for (std::size_t j = 1; j < points; ++j) {
        term *= static_cast<double>((points - 1 + j) * (points - j)) / (4.0 * radius * static_cast<double>(j));
        sum += term;
    }
    return sum;
}

// Error of interpolating f (exponential type 2, within 1 of a constant) at `points` Chebyshev points on an interval of length 2
// `half`: the smaller of two bounds, from its derivatives and from its maximum on the best Bernstein ellipse.
inline double interpolation_error(double half, std::size_t points) {
    if (half <= 0.0) {
        return 0.0;
    }
    const double n = static_cast<double>(points);
    double logarithm = std::log(interpolation_by_slope(half, points));
    if (n > 2.0 * half) {
        const double eta = std::acosh(n / (2.0 * half));
        const double by_ellipse = std::log(4.0) + 2.0 * half * std::sinh(eta) - n * eta - std::log1p(-std::exp(-eta));
        logarithm = std::min(logarithm, by_ellipse);
    }
    return std::exp(std::min(logarithm, 700.0));
}

// Error of the average of f over a square of this side by a Gauss-Legendre rule of `points` nodes in each direction.
inline double gauss_error(double side, std::size_t points) {
    if (side <= 0.0) {
        return 0.0;
    }
    const double q = static_cast<double>(points);
    const double logarithm = std::log(4.0) + 2.0 * q * std::log(side) + 4.0 * log_factorial(q) +
                             (2.0 * q - 1.0) * std::log(2.0) - std::log(2.0 * q + 1.0) - 3.0 * log_factorial(2.0 * q);
    return std::exp(std::min(logarithm, 700.0));
}

// Error of trigonometric interpolation by all orders below `order`, for a function of the angle that contains only every
// `spacing`-th order and is at most e^(reach sinh b) at angles of imaginary part b.
inline double turning_error(double reach, double order, double spacing) {
    if (order <= reach) {
        return 1e300;
    }
    const double b = std::acosh(order / reach);
    const double logarithm = std::log(4.0) + reach * std::sinh(b) - order * b - std::log1p(-std::exp(-spacing * b));
    return std::exp(std::min(logarithm, 700.0));
}

// Average of f (top of file) over a square: error of interpolating it in cos(4 azimuth of the square's centre), from `angles`
// azimuths.
inline double harmonics_error(double side, std::size_t angles) {
    return side <= 0.0 ? 0.0 : turning_error(1.4142135623730951 * side, 4.0 * static_cast<double>(angles), 4.0);
}

// D = (average of f over one side of a square) - (average over the opposite side), as a function of the azimuth of the square's
// centre; f: as at the top of the file. Error of interpolating D by its `angles` lowest odd orders, from `angles` azimuths
// (docs/certificate.md, section 15).
inline double shift_harmonics_error(double side, std::size_t angles) {
    return 2.0 * turning_error(1.4142135623730951 * side, 2.0 * static_cast<double>(angles) + 1.0, 2.0);
}

}  // namespace lommel
