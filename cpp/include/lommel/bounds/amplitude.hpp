// Amplitude of the pupil function: exponential of a polynomial in t = rho^2, rho the pupil radius; with bounds for complex t.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace lommel {

// Amplitude A(t) = exp(-(g_0 + g_1 t + ... + g_K t^K)) <= 1, t = rho^2, rho: pupil radius. Gaussian: only g_1; uniform: all g = 0.
class Amplitude {
   public:
    static constexpr std::size_t most = 10;  // highest power of t

    Amplitude() = default;
    // powers: coefficients g_0, g_1, ... of the exponent; `count` is at most 1 + most.
    Amplitude(const double* powers, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) {
            g_[k] = powers[k];
            terms_ = powers[k] != 0.0 ? k : terms_;
        }
        expand();
    }
    static Amplitude gaussian(double g) {
        const double powers[2] = {0.0, g};
        return {powers, 2};
    }

    bool uniform() const { return terms_ == 0 && g_[0] == 0.0; }
    bool operator==(const Amplitude& other) const { return g_ == other.g_; }
    // powers(): highest power K of t with g_K != 0; power(k): coefficient g_k of t^k.
    std::size_t powers() const { return terms_; }
    double power(std::size_t k) const { return g_[k]; }

    // Amplitude at t = rho^2, in the precision of t.
    template <class Real>
    Real at(Real t) const {
        Real sum = static_cast<Real>(g_[terms_]);
        for (std::size_t k = terms_; k-- > 0;) {
            sum = sum * t + static_cast<Real>(g_[k]);
        }
        return std::exp(-sum);
    }

    // Amplitude on a concentric disk of this relative area, as a function of its own t, which is 1 at the edge of that disk.
    Amplitude scaled(double area) const { return changed(1.0, area); }
    Amplitude raised(double power) const { return changed(power, 1.0); }

    // Bound on log A in the ellipse around the interval 0 <= t <= 1 with semi-axes c / 2 and sqrt(c^2 - 1) / 2. There the Chebyshev
    // polynomials satisfy |T_k(2t - 1)| <= T_k(c), and log A = -(sum of a_k T_k(2t - 1)).
    double growth(double c) const {
        double sum = std::abs(a_[1]) * c - a_[0], before = 1.0, here = c;
        for (std::size_t k = 2; k <= terms_; ++k) {
            const double next = 2.0 * c * here - before;
            before = here;
            here = next;
            sum += std::abs(a_[k]) * here;
        }
        return sum;
    }

    // Bound on the rounding error of the exponent, in units of roundoff, from rounding of t and of each step of Horner's rule.
    double sensitivity() const {
        double sum = 0.0;
        for (std::size_t k = 0; k <= terms_; ++k) {
            sum += (3.0 * static_cast<double>(k) + 1.0) * std::abs(g_[k]);
        }
        return sum;
    }

    // Add to slopes[k], 1 <= k < count, a bound on |k-th derivative of the exponent| / k! for t in [0, 1].
    void add_slopes(double* slopes, std::size_t count) const {
        for (std::size_t j = 1; j <= terms_; ++j) {
            double binomial = std::abs(g_[j]);
            for (std::size_t k = 1; k <= j && k < count; ++k) {
                binomial *= static_cast<double>(j - k + 1) / static_cast<double>(k);
                slopes[k] += binomial;
            }
        }
    }

    // Add to series[k], k < count, the k-th Taylor coefficient of the exponent -(g_0 + g_1 t + ...) at t.
    template <class Number>
    void add_series(double t, Number* series, std::size_t count) const {
        for (std::size_t j = 0; j <= terms_; ++j) {
            double binomial = g_[j];
            for (std::size_t k = 0; k <= j && k < count; ++k) {
                series[k] -= binomial * std::pow(t, static_cast<double>(j - k));
                binomial *= static_cast<double>(j - k) / static_cast<double>(k + 1);
            }
        }
    }

    // Bound on the modulus of the exponent, |g_0 + g_1 t + ... + g_K t^K|, for t in [0, 1].
    double size() const { return growth(1.0) + a_[0] + std::abs(a_[0]); }

    // Check that the amplitude is at most 1, up to rounding: at 17 samples of t in [0, 1], unless all coefficients are >= 0.
    bool passive() const {
        const bool falls = std::all_of(g_.begin(), g_.end(), [](double g) { return g >= 0.0; });
        for (std::size_t j = 0; j <= 16 && !falls; ++j) {
            if (!(at(static_cast<double>(j) / 16.0) <= 1.0 + 1e-15 * sensitivity())) {
                return false;
            }
        }
        return true;
    }

    bool closed() const { return terms_ <= 1; }
    // Peak of |field| without aberrations: integral of the amplitude over t from obscuration^2 to 1, exact if K <= 1 (closed()),
    // else by 16 Gauss nodes.
    double integral(double obscuration) const {
        const double low = obscuration * obscuration, open = 1.0 - low, g = g_[1];
        if (closed()) {
            // For |g| <= 1e-300 the quotient would lose digits to subnormal numbers; the value for g = 0 agrees to rounding.
            const double falling = std::abs(g) > 1e-300 ? std::exp(-g * low) * -std::expm1(-g * open) / g : open;
            return g_[0] == 0.0 ? falling : falling * std::exp(-g_[0]);
        }
        static constexpr double nodes[8] = {0.09501250983763744, 0.2816035507792589, 0.45801677765722739, 0.61787624440264375,
                                            0.755404408355003,   0.8656312023878318, 0.94457502307323258, 0.98940093499164993};
        static constexpr double weights[8] = {0.18945061045506850, 0.18260341504492359, 0.16915651939500254,
                                              0.14959598881657673, 0.12462897125553387, 0.09515851168249278,
                                              0.06225352393864789, 0.02715245941175409};
        double sum = 0.0;
        for (std::size_t i = 0; i < 8; ++i) {
            sum += weights[i] * (at(low + 0.5 * open * (1.0 - nodes[i])) + at(low + 0.5 * open * (1.0 + nodes[i])));
        }
        return 0.5 * open * sum;
    }

   private:
    Amplitude changed(double factor, double area) const {
        Amplitude made;
        made.terms_ = terms_;
        for (std::size_t k = 0; k <= terms_; ++k, factor *= area) {
            made.g_[k] = factor * g_[k];
        }
        made.expand();
        return made;
    }

    // Chebyshev coefficients a_k of g_0 + g_1 t + ..., by t^k = 4^-k (C(2k, k) + 2 sum_j C(2k, k - j) T_j(2t - 1)), C: binomial.
    void expand() {
        a_[0] = g_[0];
        double middle = 1.0;  // C(2k, k) / 4^k
        for (std::size_t k = 1; k <= terms_; ++k) {
            middle *= (2.0 * static_cast<double>(k) - 1.0) / (2.0 * static_cast<double>(k));
            a_[0] += middle * g_[k];
            double share = 2.0 * middle;
            for (std::size_t j = 1; j <= k; ++j) {
                share *= static_cast<double>(k - j + 1) / static_cast<double>(k + j);
                a_[j] += share * g_[k];
            }
        }
    }

    std::size_t terms_ = 0;  // highest power of t
    std::array<double, most + 1> g_{}, a_{};
};

inline constexpr Amplitude even_light{};

}  // namespace lommel
