// Non-oscillating factor of the Fresnel integral, G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau for s >= 0, by three methods.
// Each method handles `count` vectors at once, so that their chains of multiply-adds overlap.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/wide.hpp"
#include "lommel/special/chebyshev.hpp"
#include "lommel/special/exponential.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// Real and imaginary part of int_0^inf exp(i tau^2) d tau: sqrt(pi / 8).
constexpr double half_fresnel = 0.62665706865775012560;

// G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau to rounding: (s + 2) G(s) as a polynomial in (s - a) / (s + a), a = `center`,
// or for large s the asymptotic series (DLMF 7.12). The polynomial takes 2 divisions and 86 multiply-adds, the series 1 and 14.
class FresnelAuxiliary {
   public:
    static constexpr std::size_t terms = 44;

    // Shared instance from the cache, as construction takes milliseconds.
    static std::shared_ptr<const FresnelAuxiliary> get() { return cache<FresnelAuxiliary>.get(); }
    static bool is() { return true; }
    static std::size_t bytes() { return sizeof(FresnelAuxiliary); }
    static constexpr std::size_t most_bytes = 1024;

    template <class I, std::size_t count>
    LOMMEL_INLINE void operator()(I, const typename I::pack (&s)[count], typename I::pack (&re)[count],
                                  typename I::pack (&im)[count]) const {
        using V = typename I::pack;
        V least = s[0], y[count];
        for (std::size_t n = 1; n < count; ++n) {
            least = smaller(least, s[n]);
        }
        bool far = true;
        for (std::size_t i = 0; i < I::lanes; ++i) {
            far = far && least[i] >= large;
        }
        if (far) {
            for (std::size_t n = 0; n < count; ++n) {
                asymptotic(s[n], re[n], im[n]);
            }
            return;
        }
        for (std::size_t n = 0; n < count; ++n) {
            y[n] = (s[n] - splat<V>(center)) / (s[n] + splat<V>(center));
            re[n] = splat<V>(re_[terms - 1]);
            im[n] = splat<V>(im_[terms - 1]);
        }
        for (std::size_t k = terms - 1; k-- > 0;) {
            const V a = splat<V>(re_[k]), b = splat<V>(im_[k]);
            for (std::size_t n = 0; n < count; ++n) {
                re[n] = re[n] * y[n] + a;
                im[n] = im[n] * y[n] + b;
            }
        }
        for (std::size_t n = 0; n < count; ++n) {
            const V scale = splat<V>(1.0) / (s[n] + splat<V>(2.0));
            re[n] = re[n] * scale;
            im[n] = im[n] * scale;
        }
    }

    // Interpolate (s + 2) G(s), with G the Fresnel factor, at Chebyshev points of y, in extended precision if available.
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
    static constexpr double center = 2.6, large = 8.0;

    // Fresnel factor G(s) by its asymptotic series, sum over k = 0 .. 15 of (i / 2s) (2k-1)!! (-i u)^k, u = 1 / (2 s^2).
    template <class V>
    static LOMMEL_INLINE void asymptotic(V s, V& re, V& im) {
        const V scale = splat<V>(0.5) / s, u = splat<V>(2.0) * scale * scale, square = u * u;
        V even = splat<V>(213458046676875.0), odd = splat<V>(6190283353629375.0);
        for (int j = 6; j >= 0; --j) {
            double a = 1.0, b = 1.0;
            for (int k = 1; k <= 2 * j; ++k) {
                a *= 2 * k - 1;
                b *= 2 * k + 1;
            }
            even = splat<V>(a) - square * even;
            odd = splat<V>(b) - square * odd;
        }
        re = scale * u * odd;
        im = scale * even;
    }

    // Fresnel factor G(s) by quadrature. On the rotated path tau = s + e^{i pi/4} x, the integrand of G(s) is proportional to
    // exp(-x^2 - (1 - i) sqrt(2) s x). With x = exp(w - e^{-w}) (double exponential rule) the trapezoidal rule in w converges to
    // the last digit.
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

// G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau by linear interpolation of (s + 2) G(s), tabulated in `values` at equal steps
// of s / (s + 2) from 0 to 1.
struct FresnelTable {
    const std::complex<double>* values;
    std::size_t samples;

    template <class I, std::size_t count>
    LOMMEL_INLINE void operator()(I, const typename I::pack (&s)[count], typename I::pack (&re)[count],
                                  typename I::pack (&im)[count]) const {
        for (std::size_t n = 0; n < count; ++n) {
            alignas(64) double parts[2][I::lanes];
            for (std::size_t i = 0; i < I::lanes; ++i) {
                const double scale = 1.0 / (s[n][i] + 2.0), place = static_cast<double>(samples - 1) * s[n][i] * scale;
                const std::size_t at = std::min(static_cast<std::size_t>(place), samples - 2);
                const std::complex<double> value =
                    values[at] + (place - static_cast<double>(at)) * (values[at + 1] - values[at]);
                parts[0][i] = scale * value.real();
                parts[1][i] = scale * value.imag();
            }
            re[n] = load<typename I::pack>(parts[0]);
            im[n] = load<typename I::pack>(parts[1]);
        }
    }
};

// G(s) = exp(-i s^2) int_s^inf exp(i tau^2) d tau from erf(e^{-i pi/4} s), by the first `terms` terms of Abramowitz and Stegun
// 7.1.29. Cost per term: one exponential and one division.
class FresnelSeries {
   public:
    explicit FresnelSeries(std::size_t terms) {
        for (std::size_t k = 1; k <= terms; ++k) {
            weights_.push_back(std::exp(-0.25 * static_cast<double>(k) * static_cast<double>(k)));
        }
    }

    template <class I, std::size_t count>
    LOMMEL_INLINE void operator()(I isa, const typename I::pack (&s)[count], typename I::pack (&re)[count],
                                  typename I::pack (&im)[count]) const {
        for (std::size_t n = 0; n < count; ++n) {
            one(isa, s[n], re[n], im[n]);
        }
    }

   private:
    template <class I>
    LOMMEL_INLINE void one(I isa, typename I::pack s, typename I::pack& re, typename I::pack& im) const {
        using V = typename I::pack;
        // Argument of the error function: e^{-i pi/4} s = x - i x.
        const V x = s * splat<V>(0.70710678118654752440), twice = x + x, zero = splat<V>(0.0), half = splat<V>(0.5);
        V sine, cosine;
        sincos(isa, s * s, sine, cosine);
        const V fall = exponential(isa, zero - x * x), step = exponential(isa, zero - x);
        alignas(64) double real[I::lanes];
        for (std::size_t i = 0; i < I::lanes; ++i) {
            real[i] = std::erf(x[i]);
        }
        const V one = splat<V>(1.0), share = fall / larger(splat<V>(6.28318530717958647693) * x, splat<V>(1e-150));
        const V versine = below(cosine, zero, one - cosine, sine * sine / (one + cosine));
        V a = load<V>(real) + share * versine, b = zero - share * sine, sink = fall;
        double n = 0.0;
        for (const double weight : weights_) {
            n += 1.0;
            sink = sink * step;
            const V away = x - splat<V>(0.5 * n), rise = exponential(isa, zero - away * away), fade = splat<V>(weight) * sink;
            const V even = half * (rise + fade), odd = splat<V>(0.5 * n) * (rise - fade);
            const V scale = splat<V>(0.63661977236758134308) / (splat<V>(n * n) + twice * twice);
            a = a + scale * (twice * (splat<V>(weight) * fall - even * cosine) + odd * sine);
            b = b - scale * (twice * even * sine + odd * cosine);
        }
        // Fresnel factor sqrt(pi / 8) (1 + i) (1 - erf) exp(-i s^2), with the error function erf = a + i b.
        const V c = splat<V>(half_fresnel) * (one - a + b), d = splat<V>(half_fresnel) * (one - a - b);
        re = c * cosine + d * sine;
        im = d * cosine - c * sine;
    }

    std::vector<double> weights_;  // exp(-n^2 / 4) for n = 1, 2, ...
};

}  // namespace lommel
