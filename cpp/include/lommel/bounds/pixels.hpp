// What is proven about averages over pixels. All of it is about a function f on the plane that depends on the distance
// from the axis only, is of exponential type 2 along every line, and is within 1 of a constant: I over half its largest
// value, or a derivative of I over its own. docs/certificate.md, section 9.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lommel {

// The Lebesgue constant of Chebyshev's points of the first kind.
inline double lebesgue(std::size_t points) { return 1.0 + 0.63661977236758134 * std::log(static_cast<double>(points)); }

// Interpolation at so many Chebyshev points over a width of 2 `half`: by the derivative |f^(n)| <= 2^n, or by the size of
// f on the ellipse of least bound. Of an even function over [-half, half] half the points are mirror images.
inline double interpolation_error(double half, std::size_t points) {
    if (half <= 0.0) {
        return 0.0;
    }
    const double n = static_cast<double>(points);
    const double by_slope = std::log(2.0) + n * std::log(half) - std::lgamma(n + 1.0);
    double logarithm = by_slope;
    if (n > 2.0 * half) {
        const double eta = std::acosh(n / (2.0 * half));
        const double by_ellipse = std::log(4.0) + 2.0 * half * std::sinh(eta) - n * eta - std::log1p(-std::exp(-eta));
        logarithm = std::min(logarithm, by_ellipse);
    }
    return std::exp(std::min(logarithm, 700.0));
}

// The product of two Gauss rules of so many points for the average over a square of this side.
inline double gauss_error(double side, std::size_t points) {
    if (side <= 0.0) {
        return 0.0;
    }
    const double q = static_cast<double>(points);
    const double logarithm = std::log(4.0) + 2.0 * q * std::log(side) + 4.0 * std::lgamma(q + 1.0) +
                             (2.0 * q - 1.0) * std::log(2.0) - std::log(2.0 * q + 1.0) - 3.0 * std::lgamma(2.0 * q + 1.0);
    return std::exp(std::min(logarithm, 700.0));
}

// Interpolation of the average over a square of this side at so many angles, as a polynomial in the cosine of four times
// the angle.
inline double harmonics_error(double side, std::size_t angles) {
    if (side <= 0.0) {
        return 0.0;
    }
    const double reach = 1.4142135623730951 * side, order = 4.0 * static_cast<double>(angles);
    if (order <= reach) {
        return 1e300;
    }
    const double b = std::acosh(order / reach);
    const double logarithm = std::log(4.0) + reach * std::sinh(b) - order * b - std::log1p(-std::exp(-4.0 * b));
    return std::exp(std::min(logarithm, 700.0));
}

}  // namespace lommel
