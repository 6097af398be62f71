// Numbers of series terms and of quadrature nodes for a tolerance, by bounds on Bernstein ellipses (certificate, sections 1 and 2).
//
// In t = rho^2 the pupil function exp(i Phi(t)) is entire. On the ellipse t = (1 + cos(theta + i eta)) / 2 around [0, 1] it is at
// most exp g(eta), g = max_theta |Im Phi|. Hence Legendre coefficients fall like exp(-n eta) and errors of n-point Gauss quadrature
// like exp(-2 n eta), for every eta > 0; the best eta of a fixed set is used.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/amplitude.hpp"
#include "lommel/bounds/refine.hpp"

namespace lommel {

// Quantities of 40 ellipses (top of the file), each given by its eta. Every ellipse gives a bound, and the smallest bound is used.
// decay: e^-eta. Logarithms: closed, of 1 / (1 - e^-eta); perimeter, of a bound on (perimeter / pi) / (1 - e^{-2 eta}) for
// semi-axes cosh eta, sinh eta; quadrature, of the factor that depends on eta alone in the bound on the error of Gauss quadrature.
// sin, cos: of sampled angles theta.
struct EllipseGrid {
    static constexpr std::size_t count = 40, steps = 96;
    std::array<double, count> eta, sinh, cosh, decay, closed, perimeter, quadrature;
    std::array<double, steps + 1> sin, cos;

    EllipseGrid() {
        for (std::size_t i = 0; i < count; ++i) {
            eta[i] = 2e-3 * std::pow(2000.0, static_cast<double>(i) / (count - 1));
            sinh[i] = std::sinh(eta[i]);
            cosh[i] = std::cosh(eta[i]);
            decay[i] = std::exp(-eta[i]);
            closed[i] = -std::log(1.0 - decay[i]);
            const double both = std::log(-std::expm1(-2.0 * eta[i]));
            // Bound on the perimeter l of an ellipse: log(l / pi) <= log sqrt(2 cosh 2 eta).
            perimeter[i] = 0.5 * std::log(2.0 * std::cosh(2.0 * eta[i])) - both;
            quadrature[i] = std::log(32.0 / 15.0) - both - std::log(std::expm1(eta[i]));
        }
        for (std::size_t j = 0; j <= steps; ++j) {
            sin[j] = std::sin(pi * static_cast<double>(j) / steps);
            cos[j] = std::cos(pi * static_cast<double>(j) / steps);
        }
    }
};

// A global object, constructed at load time: a static inside a function could be half built when the process forks.
inline const EllipseGrid ellipse_grid;

// Imaginary parts of the Legendre polynomials P_1, P_2, ... at the samples of each ellipse, for phases of more than two terms.
struct EllipsePolynomials {
    static constexpr std::size_t most = 30;
    std::vector<std::array<std::array<double, EllipseGrid::steps + 1>, EllipseGrid::count>> imaginary;

    EllipsePolynomials() : imaginary(most) {
        const EllipseGrid& grid = ellipse_grid;
        for (std::size_t i = 0; i < EllipseGrid::count; ++i) {
            for (std::size_t j = 0; j <= EllipseGrid::steps; ++j) {
                const std::complex<double> x(grid.cos[j] * grid.cosh[i], -grid.sin[j] * grid.sinh[i]);
                std::complex<double> before = 0.0, here = 1.0;
                for (std::size_t k = 0; k < most; ++k) {
                    // (n + 1) P_{n+1} = (2n + 1) x P_n - n P_{n-1}
                    const double n = static_cast<double>(k);
                    const std::complex<double> next = ((2.0 * n + 1.0) * x * here - n * before) / (n + 1.0);
                    before = here;
                    here = next;
                    imaginary[k][i][j] = here.imag();
                }
            }
        }
    }

    std::size_t bytes() const { return sizeof(imaginary[0]) * imaginary.size(); }
    bool is() const { return true; }
    static constexpr std::size_t most_bytes = std::size_t{1} << 21;
    static std::shared_ptr<const EllipsePolynomials> get() { return cache<EllipsePolynomials>.get(); }
};

class Ellipses {
   public:
    static constexpr std::size_t count = EllipseGrid::count;

    // Bounds for t^power A exp(i Phi), with A the amplitude. phase: coefficients in rad of P_1(2t - 1), P_2, ... in the phase Phi.
    Ellipses(const double* phase, std::size_t terms, const Amplitude& amplitude, std::size_t power) {
        measure(phase, terms);
        for (std::size_t i = 0; i < count && !amplitude.uniform(); ++i) {
            g_[i] += amplitude.growth(grid.cosh[i]);
        }
        for (std::size_t i = 0; i < count && power > 0; ++i) {
            g_[i] += static_cast<double>(power) * std::log(0.5 * (1.0 + grid.cosh[i]));
        }
    }

    // Bounds for all pupils with coefficients from `least` to `most`: max |Im Phi| is convex, so the corners of this box suffice.
    Ellipses(const std::vector<double>& least, const std::vector<double>& most, const Amplitude& amplitude) {
        const std::size_t terms = least.size();
        std::vector<double> corner(terms);
        g_.fill(0.0);
        for (std::size_t which = 0; which < (std::size_t{1} << terms); ++which) {
            for (std::size_t k = 0; k < terms; ++k) {
                corner[k] = (which >> k) % 2 == 0 ? least[k] : most[k];
            }
            const Ellipses one(corner.data(), terms, amplitude, 0);
            for (std::size_t i = 0; i < count; ++i) {
                g_[i] = std::max(g_[i], one.g_[i]);
            }
        }
    }

    // Bound on the tail of the Legendre series at any image radius: the sum over n >= terms of |beta_n| / sqrt(2n+1), with Legendre
    // coefficients beta_n. If |pupil function| <= M on an ellipse of size eta and perimeter l, then
    // |beta_n| <= (2n+1) l M e^{-(n+1) eta} / (pi (1 - e^{-2 eta})) (Wang and Xiang, Math. Comp. 81, 861 (2012)).
    double tail(std::size_t terms) const {
        const double order = 2.0 * static_cast<double>(terms) + 1.0;
        std::array<double, count> exponent;
        for (std::size_t i = 0; i < count; ++i) {
            exponent[i] = g_[i] + grid.perimeter[i] - (static_cast<double>(terms) + 1.0) * grid.eta[i];
        }
        const auto whole = [&](std::size_t i) {
            const double q = grid.decay[i];
            return exponent[i] + std::log(1.0 / (1.0 - q) + q / (order * (1.0 - q) * (1.0 - q)));
        };
        // whole() adds the logarithm of a sum >= 1 to an exponent: it is called only if the exponent is below the minimum so far.
        const double rest = least([&](std::size_t i) { return exponent[i]; });
        const auto first = static_cast<std::size_t>(std::find(exponent.begin(), exponent.end() - 1, rest) - exponent.begin());
        double best = whole(first);
        for (std::size_t i = 0; i < count; ++i) {
            if (exponent[i] < best && i != first) {
                best = std::min(best, whole(i));
            }
        }
        return std::sqrt(order) * std::exp(std::min(best, 700.0));
    }

    // Number of Legendre terms with tail() <= error, close to the smallest, and the tail beyond them.
    std::pair<std::size_t, double> terms(double error) const {
        const double target = std::log(error);
        // First number of terms to try, a lower bound: without the factors sqrt(2n+1), the sum in tail() is a geometric series.
        const double needed =
            least([&](std::size_t i) { return (g_[i] + grid.perimeter[i] + grid.closed[i] - target) / grid.eta[i] - 1.0; });
        std::size_t n = static_cast<std::size_t>(std::max(1.0, std::min(needed, 1e9)));
        double left = tail(n);
        while (left > error && n < 1000000) {
            n += 1 + n / 64;
            left = tail(n);
        }
        return {n, left};
    }

    // Bound on the error of the field if the first `terms` coefficients are computed by Gauss quadrature with `nodes` nodes
    // (Trefethen, Approximation Theory and Approximation Practice, Theorem 19.3, with |P_n| <= e^{n eta}).
    double quadrature(std::size_t nodes, std::size_t terms) const {
        const double best = least([&](std::size_t i) {
            return g_[i] + grid.quadrature[i] + (static_cast<double>(terms) - 2.0 * static_cast<double>(nodes)) * grid.eta[i];
        });
        return std::sqrt(2.0 * static_cast<double>(terms) + 1.0) * std::exp(std::min(best, 700.0));
    }

    // Number of Gauss nodes for which quadrature() <= error.
    std::size_t nodes(std::size_t terms, double error) const {
        const double log_error = std::log(error) - 0.5 * std::log(2.0 * static_cast<double>(terms) + 1.0);
        const double needed = least([&](std::size_t i) {
            return 0.5 * (static_cast<double>(terms) + (g_[i] + grid.quadrature[i] - log_error) / grid.eta[i]);
        });
        return static_cast<std::size_t>(std::ceil(std::max(1.0, std::min(needed, 1e9))));
    }

   private:
    // Minimum of of(index) over all ellipses, in eight independent chains.
    template <class F>
    static double least(const F& of) {
        static_assert(count % 8 == 0);
        double low[8];
        std::fill_n(low, 8, 1e300);
        for (std::size_t i = 0; i < count; i += 8) {
            for (std::size_t j = 0; j < 8; ++j) {
                const double here = of(i + j);
                low[j] = here < low[j] ? here : low[j];
            }
        }
        return *std::min_element(low, low + 8);
    }

    void measure(const double* phase, std::size_t terms) {
        if (terms <= 2) {
            // Two terms: max over theta of |Im Phi| = |sin theta| sinh eta |a1 + 3 a2 cos theta cosh eta| in closed form.
            const double a1 = terms > 0 ? phase[0] : 0.0, a2 = terms > 1 ? phase[1] : 0.0;
            dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
                for (std::size_t i = 0; i < count; ++i) {
                    g_[i] = largest(grid.sinh[i] * std::abs(a1), 3.0 * grid.sinh[i] * grid.cosh[i] * std::abs(a2));
                }
            });
            return;
        }
        const auto polynomials = EllipsePolynomials::get();
        for (std::size_t i = 0; i < count; ++i) {
            std::array<double, EllipseGrid::steps + 1> sums{};
            for (std::size_t k = 0; k < terms; ++k) {
                const auto& imaginary = polynomials->imaginary[k][i];
                for (std::size_t j = 0; j <= EllipseGrid::steps; ++j) {
                    sums[j] += phase[k] * imaginary[j];
                }
            }
            double top = 0.0;
            for (const double sum : sums) {
                top = std::max(top, std::abs(sum));
            }
            // From the largest sample follows a bound on the maximum over all angles (Ehlich and Zeller, 1964).
            g_[i] = top / std::cos(0.5 * static_cast<double>(terms) * pi / static_cast<double>(EllipseGrid::steps));
        }
    }

    // Maximum over c in [0, 1] of sqrt(1 - c^2) (a + b c), a, b >= 0: at 2 b c^2 + a c - b = 0.
    static LOMMEL_INLINE double largest(double a, double b) {
        const double ratio = a / std::max(b, 1e-300), c = 2.0 / (ratio + std::sqrt(ratio * ratio + 8.0));
        return std::sqrt(1.0 - c * c) * (a + b * c);
    }

    static inline const EllipseGrid& grid = ellipse_grid;

    std::array<double, count> g_;  // [ellipse]: bound on log |function on it|
};

// Bound for all image radii v <= reach on the sum over k = m, m + step, m + 2 step, ... of k^power |2 J_k(v) / v|. Such a sum
// bounds the terms that a series omits, whatever the phase (docs/certificate.md, section 1, "By the window").
inline double beyond_window(double m, double step, double power, double reach) {
    if (reach < 1e-100) {
        return m > 1.0 ? 0.0 : 1.0;
    }
    if (m <= reach) {
        return 1e300;
    }
    // Logarithm of Kapteyn's bound on |J_m(v)| for m >= v > 0 (DLMF 10.14.8), and its rate of decrease with m.
    const double x = reach / m, root = std::sqrt(std::max(0.0, 1.0 - x * x)), rate = std::log((1.0 + root) / x);
    const double top = m * (root - rate);
    const double ratio = std::exp(-step * rate) * std::pow((m + step) / m, power);
    // If m is close to v, (Kapteyn's bound) / v may decrease with v: its maximum need not be at v = reach.
    if (ratio >= 1.0 || rate * m < 1.2) {
        return 1e300;
    }
    // Else, if m >= 2, (Kapteyn's bound) / v increases with v: it is largest at v = reach. If m = 1, |2 J_1(v) / v| <= 1 < result.
    return 2.0 / reach * std::pow(m, power) * std::exp(top) / (1.0 - ratio);
}

// Legendre term n of any pupil's field is at most sqrt(2n+1) |2 J_{2n+1}(v) / v| (Parseval). window_tail(): bound on the sum of the
// terms n >= `terms` at radii v <= reach; window_terms(): smallest number of terms with window_tail() <= error.
inline double window_tail(std::size_t terms, double reach) {
    return beyond_window(2.0 * static_cast<double>(terms) + 1.0, 2.0, 0.5, reach);
}
inline std::size_t window_terms(double reach, double error) {
    return fewest(static_cast<std::size_t>(0.5 * reach) + 2, [&](std::size_t n) { return window_tail(n, reach) <= error; });
}

// Zernike terms of degree n of any pupil's field add up to at most (n+1) |2 J_{n+1}(v) / v|. disk_window_tail(): bound on the sum
// of degrees n >= `degrees` at radii v <= reach; disk_window_degrees(): smallest number with disk_window_tail() <= error.
inline double disk_window_tail(std::size_t degrees, double reach) {
    return beyond_window(static_cast<double>(degrees) + 1.0, 1.0, 1.0, reach);
}
inline std::size_t disk_window_degrees(double reach, double error) {
    return fewest(static_cast<std::size_t>(reach) + 2, [&](std::size_t n) { return disk_window_tail(n, reach) <= error; });
}

}  // namespace lommel
