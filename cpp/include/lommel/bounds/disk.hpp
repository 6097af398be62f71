// How many degrees and nodes an accuracy takes for any polynomial phase on the disk.
//
// On the line of points cos(phi) xi + eta sin(phi) xi', xi and xi' orthonormal and |eta| <= 1, a Zernike polynomial of
// degree n is a real trigonometric polynomial of degree n in phi, at most 1. At phi = a + ib its imaginary part is
// then at most sinh(n b) (Duffin and Schaeffer 1938, integrated), so |exp(i Phi)| <= M(b) = exp sum_j W_j sinh(n_j b),
// W_j the amplitude of term j. The means of the pupil function over chords are hence analytic on Bernstein ellipses; their
// Chebyshev coefficients (Marr 1974; Logan and Shepp 1975) are the components of degree n, b_n / (n + 1), at most
// M(b) (1 + e^{-2b}) e^{-n b}, for every b > 0. The best b of a fixed set is taken.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "lommel/bounds/ellipse.hpp"

namespace lommel {

class DiskBounds {
   public:
    DiskBounds() {
        for (std::size_t i = 0; i < count; ++i) {
            b_[i] = 2e-3 * std::pow(2000.0, static_cast<double>(i) / (count - 1));
            log_m_[i] = std::log1p(std::exp(-2.0 * b_[i]));
            log_turn_[i] = 0.0;
        }
    }

    // A term of degree n and azimuthal order m whose value is at most `amplitude`: cosine and sine are one term.
    void add(double amplitude, std::size_t n, std::size_t m) {
        for (std::size_t i = 0; i < count; ++i) {
            log_m_[i] += amplitude * std::sinh(std::min(600.0, static_cast<double>(n) * b_[i]));
            log_turn_[i] += amplitude * std::sinh(std::min(600.0, static_cast<double>(m) * b_[i]));
        }
    }

    // The amplitude: on the line rho^2 = cos(phi)^2 + eta^2 sin(phi)^2 stays within the ellipse of cosh 2b around [0, 1].
    void add(const Amplitude& amplitude) {
        for (std::size_t i = 0; i < count && !amplitude.uniform(); ++i) {
            log_m_[i] += amplitude.growth(std::cosh(2.0 * b_[i]));
        }
    }

    // Bound on what the degrees from n on add to U at every v: |2 (n+1) J_{n+1}(v) / v| <= 1.
    double tail(std::size_t n) const {
        double best = 1e300;
        for (std::size_t i = 0; i < count; ++i) {
            best = std::min(best, log_m_[i] - static_cast<double>(n) * b_[i] - std::log(-std::expm1(-b_[i])));
        }
        return std::exp(std::min(best, 690.0));
    }

    // Bound on what the azimuthal orders from m on add to U: on a ring the pupil function is analytic in theta, so its Fourier
    // coefficients fall like exp(-m b), and |2 int J_m(v rho) rho d rho| <= 1.
    double orders_tail(std::size_t m) const {
        double best = 1e300;
        for (std::size_t i = 0; i < count; ++i) {
            best = std::min(best, log_turn_[i] - static_cast<double>(m) * b_[i] - std::log(-std::expm1(-b_[i])));
        }
        return 2.0 * std::exp(std::min(best, 690.0));
    }

    // Bound on the distance of the pupil function from a polynomial of degree d, everywhere on the disk: component n is
    // a mean of U_n(x . xi) b_n, at most (n+1)^(3/2) times its Chebyshev coefficient.
    double distance(std::size_t d) const {
        const double first = static_cast<double>(d) + 2.0;  // n + 1 of the first degree that is missing
        double best = 1e300;
        for (std::size_t i = 0; i < count; ++i) {
            const double ratio = std::exp(-b_[i]) * std::pow((first + 1.0) / first, 1.5);
            if (ratio < 1.0) {
                best = std::min(best, log_m_[i] + 1.5 * std::log(first) - (first - 1.0) * b_[i] - std::log(1.0 - ratio));
            }
        }
        return std::exp(std::min(best, 690.0));
    }

    // Fewest degrees and orders for which their tails are at most `error`, and least degree for which distance() is.
    std::size_t degrees(double error) const {
        return least([&](std::size_t n) { return tail(n) <= error; });
    }
    std::size_t orders(double error) const {
        return least([&](std::size_t m) { return orders_tail(m) <= error; });
    }
    std::size_t degree(double error) const {
        return least([&](std::size_t d) { return distance(d) <= error; });
    }

    static constexpr std::size_t limit = 1 << 20;

   private:
    template <class Enough>
    static std::size_t least(const Enough& enough) {
        std::size_t high = 1;
        while (high < limit && !enough(high)) {
            high *= 2;
        }
        std::size_t low = high / 2;  // not enough, or 0
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (enough(middle) ? high : low) = middle;
        }
        return high;
    }

    static constexpr std::size_t count = 48;
    std::array<double, count> b_, log_m_, log_turn_;
};

// Bound on sum_{n >= degrees} 2 (n+1) |J_{n+1}(v) / v| for all v <= reach: what those degrees can add to U whatever the
// pupil, because high orders vanish near the axis.
inline double disk_window_tail(std::size_t degrees, double reach) {
    const double m = static_cast<double>(degrees) + 1.0;
    if (reach < 1e-100) {
        return degrees > 0 ? 0.0 : 1.0;
    }
    if (m <= reach) {
        return 1e300;
    }
    double rate = 0.0;
    const double top = kapteyn(m, reach, rate);
    const double ratio = std::exp(-rate) * (m + 1.0) / m;
    if (ratio >= 1.0 || rate * m < 1.2) {
        return 1e300;
    }
    return 2.0 * m / reach * std::exp(top) / (1.0 - ratio);
}

// Fewest degrees for which disk_window_tail() is at most `error`.
inline std::size_t disk_window_degrees(double reach, double error) {
    std::size_t n = static_cast<std::size_t>(reach) + 1, step = 1;
    while (disk_window_tail(n + step, reach) > error) {
        step *= 2;
    }
    for (std::size_t half = step; half > 0; half /= 2) {
        if (disk_window_tail(n + half, reach) > error) {
            n += half;
        }
    }
    return n + 1;
}

}  // namespace lommel
