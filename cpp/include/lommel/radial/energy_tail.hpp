// Encircled energy of a radially symmetric pupil far from the axis: from the mean intensity, which falls as r^-3, with a bound on
// the contribution of interference rings.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "lommel/base/pi.hpp"
#include "lommel/radial/stack.hpp"

namespace lommel {

// Beyond the geometric rays, only the edges of the aperture contribute to the field U(v): integration by parts gives U as a sum of
// exp(+- i v) and exp(+- i eps v), eps the relative radius of the obscuration, times powers of 1 / v. The intensity is a smooth
// mean, mean() / v^3 to leading order, plus interference rings (docs/certificate.md, section 9).
class EnergyTail {
   public:
    EnergyTail(const Phase& phase, double obscuration) {
        add_waves(phase, 1.0);
        if (obscuration >= 1e-9) {  // class Field ignores smaller obscurations
            add_waves(phase, obscuration);
        }
        for (std::size_t i = 0; i < wave_count_; ++i) {
            for (std::size_t j = i; j < wave_count_; ++j) {
                std::array<std::complex<double>, 2 * powers> product{};
                for (std::size_t n = 0; n < powers; ++n) {
                    for (std::size_t k = 0; k < powers; ++k) {
                        product[n + k] += waves_[i].parts[n] * std::conj(waves_[j].parts[k]);
                    }
                }
                const double difference = i == j ? 1.0 : std::abs(waves_[i].frequency - waves_[j].frequency);
                for (std::size_t n = 0; n < 2 * powers; ++n) {
                    if (i == j) {
                        means_[n] += product[n].real();
                    } else {
                        rings_[n] += 2.0 * std::abs(product[n]) / difference;
                    }
                }
            }
        }
        bound_derivatives(phase, obscuration);
    }

    double mean() const { return means_[0]; }
    // Bound on the contribution of interference rings to the energy beyond r, int_r^inf I(s) s ds (docs/certificate.md, section 9).
    double rings(double r) const {
        double sum = 0.0, size = 0.0, power = 1.0;
        for (std::size_t n = 0; n < 2 * powers; ++n, power /= r) {
            sum += rings_[n] * power / (r * r);
            for (std::size_t i = 0; i < wave_count_ && n < powers; ++i) {
                size += std::abs(waves_[i].parts[n]) * power;
            }
        }
        const double rest = remainder(r), order = static_cast<double>(terms);
        return sum + r * r * rest * (2.0 * size / (r * std::sqrt(r)) / (order + 1.0) + rest / (2.0 * order + 1.0));
    }
    // Bound on the smooth part of the intensity at r, without its leading term mean() / r^3.
    double curved(double r) const {
        double sum = 0.0, power = 1.0 / (r * r * r);
        for (std::size_t n = 1; n < 2 * powers; ++n) {
            power /= r;
            sum += std::abs(means_[n]) * power;
        }
        return sum;
    }

   private:
    // terms: number of terms of the integration by parts that are expanded in waves; powers: number of coefficients of a wave, one
    // for each power of 1 / v; orders: remainder() uses bounds on derivatives of the pupil function of orders below this number.
    static constexpr std::size_t terms = 6, powers = 14, orders = 33;

    struct Wave {
        double frequency = 0.0;
        std::array<std::complex<double>, powers> parts{};  // [n]: coefficient of v^(-3/2 - n)
    };
    // Bound factor * v^-power on the remainder of a Hankel expansion at v.
    struct Left {
        double factor = 0.0, power = 0.0;
    };

    // Olenko's bound on sup sqrt(x) |J_n(x)|, n >= 1 (J. Math. Anal. Appl. 2006).
    static double envelope(std::size_t n) {
        const double third = std::cbrt(static_cast<double>(n));
        return 0.674886 * std::sqrt(third + 1.855757 / third + 1.0331501 / static_cast<double>(n));
    }

    // Derivatives [k] of the pupil function with respect to t = rho^2, at the pupil radius rho = edge.
    static std::array<std::complex<double>, terms> derivatives(const Phase& phase, double edge) {
        // below, before: derivatives [k], with respect to x = 2t - 1, of the Legendre polynomials P_(j-1) and P_(j-2) in the loop.
        std::array<double, terms> below{}, before{};
        std::array<std::complex<double>, terms> exponent{}, made{};
        const double x = 2.0 * edge * edge - 1.0;
        below[0] = 1.0;
        for (std::size_t j = 1; j <= phase.terms; ++j) {
            const double n = static_cast<double>(j);
            std::array<double, terms> here{};
            here[0] = ((2.0 * n - 1.0) * x * below[0] - (n - 1.0) * before[0]) / n;
            for (std::size_t k = 1; k < terms; ++k) {
                here[k] = before[k] + (2.0 * n - 1.0) * below[k - 1];
            }
            double scale = 1.0;
            for (std::size_t k = 0; k < terms; ++k) {
                exponent[k] += std::complex<double>(0.0, phase.coefficients[j - 1] * here[k] * scale);
                scale *= 2.0 / static_cast<double>(k + 1);
            }
            before = below;
            below = here;
        }
        phase.amplitude->add_series(edge * edge, exponent.data(), terms);
        made[0] = std::exp(exponent[0]);
        double factorial = 1.0;
        for (std::size_t k = 1; k < terms; ++k) {
            for (std::size_t j = 1; j <= k; ++j) {
                made[k] += static_cast<double>(j) / static_cast<double>(k) * exponent[j] * made[k - j];
            }
        }
        for (std::size_t k = 1; k < terms; ++k) {
            factorial *= static_cast<double>(k);
            made[k] *= factorial;
        }
        return made;
    }

    // Add the waves of one edge to the field U(v): sum_k (-1)^k (2 edge / v)^(k+1) E_k J_(k+1)(edge v), with E_k the k-th
    // derivative of the pupil function with respect to t = rho^2, at the edge. The sign of the inner edge is omitted: neither means
    // nor bounds depend on it.
    void add_waves(const Phase& phase, double edge) {
        const auto slopes = derivatives(phase, edge);
        Wave forth{edge, {}}, back{-edge, {}};
        for (std::size_t k = 0; k < terms; ++k) {
            const double order = static_cast<double>(k + 1);
            const std::complex<double> factor =
                (k % 2 == 0 ? 1.0 : -1.0) * std::pow(2.0 * edge, order) / std::sqrt(2.0 * pi * edge) * slopes[k];
            // Hankel's expansion, cut off after `count` terms (even), has a remainder below the next two terms (DLMF 10.17(iii)).
            const std::size_t least = std::max(k + 1, terms - k + 1), count = least + least % 2;
            double hankel = 1.0;
            const auto advance = [&](std::size_t l) {
                const double odd = static_cast<double>(2 * l + 1);
                hankel *= (4.0 * order * order - odd * odd) / (8.0 * static_cast<double>(l + 1) * edge);
            };
            const std::complex<double> turn = std::polar(1.0, -0.5 * pi * (order + 0.5));
            std::complex<double> quarter = 1.0;
            for (std::size_t l = 0; l < count; ++l) {
                forth.parts[k + l] += factor * hankel * turn * quarter;
                back.parts[k + l] += factor * hankel * std::conj(turn * quarter);
                quarter *= std::complex<double>(0.0, 1.0);
                advance(l);
            }
            for (std::size_t l = count; l < count + 2; ++l) {
                left_[left_count_++] = {2.0 * std::abs(factor * hankel), static_cast<double>(k + l) + 1.5};
                advance(l);
            }
        }
        waves_[wave_count_++] = forth;
        waves_[wave_count_++] = back;
    }

    // Bound the derivatives of the pupil function with respect to t = rho^2, over the whole aperture.
    void bound_derivatives(const Phase& phase, double obscuration) {
        std::array<double, orders> slopes{}, series{};
        for (std::size_t j = 1; j <= phase.terms; ++j) {
            double binomials = std::abs(phase.coefficients[j - 1]);  // later times binomial(j + k, k) binomial(j, k)
            for (std::size_t k = 1; k <= std::min(j, orders - 1); ++k) {
                binomials *= static_cast<double>((j + k) * (j - k + 1)) / static_cast<double>(k * k);
                slopes[k] += binomials;
            }
        }
        phase.amplitude->add_slopes(slopes.data(), orders);
        series[0] = 1.0;
        double factorial = 1.0;
        for (std::size_t k = 1; k < orders; ++k) {
            const double order = static_cast<double>(k);
            for (std::size_t j = 1; j <= k; ++j) {
                series[k] += static_cast<double>(j) / order * slopes[j] * series[k - j];
            }
            factorial *= order;
            const double derivative = std::ldexp(std::min(1e270, factorial * series[k]), static_cast<int>(k));
            at_edges_[k] = 2.0 * envelope(k + 1) * derivative * (1.0 + std::pow(obscuration, order + 0.5));
            inside_[k] = envelope(k) * derivative / (0.5 * order + 0.75);
        }
    }

    // Bound on the part of the field U at v = r that the waves omit. It falls as r^(-terms - 3/2) or faster, as rings() requires:
    // at least terms + 1 steps of integration by parts are taken.
    double remainder(double r) const {
        double sum = 0.0, least = 1e150;
        for (std::size_t i = 0; i < left_count_; ++i) {
            sum += left_[i].factor * std::pow(r, -left_[i].power);
        }
        for (std::size_t k = terms; k < orders; ++k) {
            const double power = std::pow(r, -static_cast<double>(k) - 0.5);
            if (k > terms) {
                least = std::min(least, sum + inside_[k] * power);
            }
            sum += at_edges_[k] * power / r;
        }
        return least;
    }

    // Two waves, of opposite frequencies, for each edge: that of the aperture and that of its obscuration.
    std::array<Wave, 4> waves_{};
    std::array<Left, 4 * terms> left_{};
    std::size_t wave_count_ = 0, left_count_ = 0;
    std::array<double, 2 * powers> means_{}, rings_{};
    // After k steps of integration by parts, at_edges_[k] bounds edge term * v^(k + 3/2), inside_[k] bounds integral * v^(k + 1/2).
    std::array<double, orders> at_edges_{}, inside_{};
};

}  // namespace lommel
