// Smooth part of the Fresnel integral, as the closed form needs it.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>

#include "lommel/base/cache.hpp"
#include "lommel/base/wide.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

// G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau for s >= 0: (s + 2) G(s) as one polynomial in (s - a) / (s + a). It does
// not oscillate, so that degree 25 holds to 1e-10 for every s. Cost: a division and 26 complex multiply-adds.
class FresnelAuxiliary {
   public:
    static constexpr std::size_t terms = 26;

    // Made when it is first asked for, which takes milliseconds.
    static std::shared_ptr<const FresnelAuxiliary> get() { return cache<FresnelAuxiliary>.get(); }
    static bool is() { return true; }
    static std::size_t bytes() { return sizeof(FresnelAuxiliary); }
    static constexpr std::size_t most_bytes = 1024;

    std::complex<double> at(double s) const {
        const double y = (s - center) / (s + center);
        double re = re_[terms - 1], im = im_[terms - 1];
        for (std::size_t k = terms - 1; k-- > 0;) {
            re = re * y + re_[k];
            im = im * y + im_[k];
        }
        const double scale = 1.0 / (s + 2.0);
        return {re * scale, im * scale};
    }

    // int_0^inf exp(i tau^2) d tau
    static std::complex<double> half() {
        constexpr double root = 0.62665706865775012560;  // sqrt(pi / 8)
        return {root, root};
    }

    // Interpolates at Chebyshev points; the conversion to monomials is done where possible in wider numbers.
    FresnelAuxiliary() {
        std::array<wide, terms> re, im;
        for (std::size_t j = 0; j < terms; ++j) {
            const wide y = chebyshev_point<wide>(j, terms), s = center * (1 + y) / (1 - y);
            const std::complex<wide> value = (s + 2) * by_quadrature(s);
            re[j] = value.real();
            im[j] = value.imag();
        }
        const ChebyshevToMonomials<terms> convert;
        convert(re.data(), 1, re_.data());
        convert(im.data(), 1, im_.data());
    }

   private:
    static constexpr double center = 2.1;

    // On the turned path tau = s + e^{i pi/4} x the integrand is exp(-x^2 - (1 - i) sqrt(2) s x): the trapezoidal rule in
    // x = e^{w - e^{-w}} (double exponential, for a half line) converges to the last digit.
    static std::complex<wide> by_quadrature(wide s) {
        using real = wide;
        const real root2 = std::sqrt(real(2)), h = real(1) / 64;
        std::complex<real> sum = 0;
        for (int k = -64 * 5; k <= 64 * 3; ++k) {
            const real w = h * static_cast<real>(k), x = std::exp(w - std::exp(-w));
            const std::complex<real> exponent(-x * x - root2 * s * x, root2 * s * x);
            if (exponent.real() > -60) {
                sum += std::exp(exponent) * x * (1 + std::exp(-w));
            }
        }
        return sum * h * std::complex<real>(1, 1) / root2;
    }

    std::array<double, terms> re_{}, im_{};
};

}  // namespace lommel
