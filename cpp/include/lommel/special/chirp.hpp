// Moments of chirps, int_low^high R^m exp(i (a R^2 + b R)) dR for m = 0, 1, 2, in closed form.
#pragma once

#include <cmath>
#include <cstddef>

#include "lommel/base/simd.hpp"
#include "lommel/special/fresnel.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

template <class I>
struct ChirpMoments {
    typename I::pack re[3], im[3];
};

// Threshold of the curvature a (high - low)^2 / 4 (rad) of a chirp exp(i (a R^2 + b R)) on [low, high]. Below it the difference
// of two Fresnel integrals loses digits, and the moments are expanded in powers of a.
constexpr double nearly_linear = 0.025;

// moments[k] = int_{-1}^1 x^k exp(i q x) dx, k = 0 .. 16, for several q at once, divided by i for odd k, so that all are real. By
// the recurrence from integration by parts: upwards in k if |q| >= 2, where it is stable, otherwise downwards from 0 at k = 24.
template <class I, std::size_t count>
LOMMEL_INLINE void wave_moments(I isa, const typename I::pack (&q)[count], typename I::pack (&moments)[17][count]) {
    using V = typename I::pack;
    const V zero = splat<V>(0.0), two = splat<V>(2.0);
    V size[count], sine[count], cosine[count];
    bool slow = false, fast = false;
    for (std::size_t n = 0; n < count; ++n) {
        size[n] = larger(q[n], zero - q[n]);
        sincos(isa, size[n], sine[n], cosine[n]);
        sine[n] = sine[n] + sine[n];
        cosine[n] = cosine[n] + cosine[n];
        for (std::size_t i = 0; i < I::lanes; ++i) {
            (size[n][i] < 2.0 ? slow : fast) = true;
        }
    }
    // The recurrences of all q advance together, because within one recurrence each step waits for the previous result.
    if (fast) {
        V turn[count], s[count], c[count];
        for (std::size_t n = 0; n < count; ++n) {
            turn[n] = splat<V>(1.0) / larger(size[n], two);
            s[n] = sine[n] * turn[n];
            c[n] = cosine[n] * turn[n];
            moments[0][n] = s[n];
        }
        for (int k = 1; k < 17; k += 2) {
            for (std::size_t n = 0; n < count; ++n) {
                const V first = splat<V>(static_cast<double>(k)) * turn[n], second = first + turn[n];
                moments[k][n] = first * moments[k - 1][n] - c[n];
                moments[k + 1][n] = s[n] - second * moments[k][n];
            }
        }
    }
    if (slow) {
        V turn[count], at[count];
        for (std::size_t n = 0; n < count; ++n) {
            at[n] = zero;
            turn[n] = smaller(size[n], two);
        }
        for (int k = 24; k > 0; k -= 2) {
            const V first = splat<V>(1.0 / k), second = splat<V>(1.0 / (k - 1));
            for (std::size_t n = 0; n < count; ++n) {
                const V odd = sine[n] * first - turn[n] * first * at[n];
                at[n] = cosine[n] * second + turn[n] * second * odd;
                if (k <= 16) {
                    moments[k - 1][n] = fast ? below(size[n], two, odd, moments[k - 1][n]) : odd;
                }
                if (k <= 18) {
                    moments[k - 2][n] = fast ? below(size[n], two, at[n], moments[k - 2][n]) : at[n];
                }
            }
        }
    }
    for (int k = 1; k < 17; k += 2) {
        for (std::size_t n = 0; n < count; ++n) {
            moments[k][n] = below(q[n], zero, zero - moments[k][n], moments[k][n]);
        }
    }
}

// Moments of chirps exp(i (a R^2 + b R)) on [middle - half, middle + half], for several slopes b: expansion in small a.
template <class I, std::size_t count>
LOMMEL_INLINE void flat_moments(I isa, double a, const typename I::pack (&b)[count], typename I::pack middle,
                                typename I::pack half, ChirpMoments<I> (&out)[count]) {
    using V = typename I::pack;
    const V rate = splat<V>(a) * middle, p = splat<V>(a) * half * half, share = half * (middle + middle), square = half * half;
    V q[count], waves[17][count];
    for (std::size_t n = 0; n < count; ++n) {
        q[n] = (rate + rate + b[n]) * half;
    }
    wave_moments(isa, q, waves);
    for (std::size_t n = 0; n < count; ++n) {
        // re + i im = int_{-1}^1 x^m exp(i (p x^2 + q x)) dx, expanded up to p^7 for |p| <= nearly_linear. The moment m = 1 is
        // divided by i, as the odd moments of wave_moments() are.
        V sine, cosine, re[3], im[3], power = splat<V>(1.0);
        for (int m = 0; m < 3; ++m) {
            re[m] = im[m] = splat<V>(0.0);
        }
        for (int j = 0; j < 8; ++j) {
            for (int m = 0; m < 3; ++m) {
                const V term = power * waves[2 * j + m][n];
                V& sum = j % 2 == 0 ? re[m] : im[m];
                sum = j % 4 < 2 ? sum + term : sum - term;
            }
            power = power * p * splat<V>(1.0 / (j + 1));
        }
        // Change of variable from x to R = middle + half x.
        sincos(isa, (rate + b[n]) * middle, sine, cosine);
        const V c = half * cosine, s = half * sine;
        const V parts[3][2] = {{re[0], im[0]},
                               {middle * re[0] - half * im[1], middle * im[0] + half * re[1]},
                               {middle * middle * re[0] - share * im[1] + square * re[2],
                                middle * middle * im[0] + share * re[1] + square * im[2]}};
        for (int m = 0; m < 3; ++m) {
            out[n].re[m] = c * parts[m][0] - s * parts[m][1];
            out[n].im[m] = s * parts[m][0] + c * parts[m][1];
        }
    }
}

// Moments of chirps exp(i (a R^2 + b R)), a > 0, on [low, high], for several slopes b, by Fresnel integrals at both ends. Only
// the integrals' non-oscillating factor is used, so the large phase b^2 / 4a of a distant stationary point does not appear.
template <class I, std::size_t count, class Auxiliary>
LOMMEL_INLINE void bent_moments(I isa, const Auxiliary& auxiliary, double a, const typename I::pack (&b)[count],
                                typename I::pack low, typename I::pack high, ChirpMoments<I> (&out)[count]) {
    using V = typename I::pack;
    const V zero = splat<V>(0.0), root = splat<V>(std::sqrt(a)), by = splat<V>(-0.5 / a), ends[2] = {low, high};
    V place[2 * count], size[2 * count], re[2 * count], im[2 * count];
    for (std::size_t n = 0; n < 2 * count; ++n) {
        place[n] = root * (ends[n % 2] - by * b[n / 2]);
        size[n] = larger(place[n], zero - place[n]);
    }
    auxiliary(isa, size, re, im);
    for (std::size_t n = 0; n < count; ++n) {
        const V shift = zero - by * b[n];
        V c[2], s[2], zeroth[2] = {zero, zero};
        for (int j = 0; j < 2; ++j) {
            sincos(isa, (splat<V>(a) * ends[j] + b[n]) * ends[j], s[j], c[j]);
            const V x = re[2 * n + j], y = im[2 * n + j], u = c[j] * x - s[j] * y, w = s[j] * x + c[j] * y;
            const V from = place[2 * n + j], side = splat<V>(j == 0 ? 1.0 : -1.0);
            zeroth[0] = zeroth[0] + side * below(from, zero, zero - u, u);
            zeroth[1] = zeroth[1] + side * below(from, zero, zero - w, w);
        }
        bool inside = false;
        for (std::size_t i = 0; i < I::lanes; ++i) {
            inside = inside || (place[2 * n][i] < 0.0 && place[2 * n + 1][i] >= 0.0);
        }
        if (inside) {  // the phase is stationary within [low, high]
            V sine, cosine;
            sincos(isa, splat<V>(0.5) * b[n] * shift, sine, cosine);
            const V whole = below(place[2 * n], zero, below(place[2 * n + 1], zero, zero, splat<V>(2.0 * half_fresnel)), zero);
            zeroth[0] = zeroth[0] + whole * (cosine + sine);
            zeroth[1] = zeroth[1] + whole * (cosine - sine);
        }
        const V turn = splat<V>(1.0) / root;
        V x = zeroth[0] * turn, y = zeroth[1] * turn;
        ChirpMoments<I>& m = out[n];
        m.re[0] = x;
        m.im[0] = y;
        // Moments 1 and 2 follow from moment 0 by integration by parts; by = -1 / (2 a), shift = b / (2 a).
        m.re[1] = zero - by * (s[1] - s[0]) - shift * x;
        m.im[1] = by * (c[1] - c[0]) - shift * y;
        m.re[2] = zero - by * (high * s[1] - low * s[0] - y) - shift * m.re[1];
        m.im[2] = by * (high * c[1] - low * c[0] - x) - shift * m.im[1];
    }
}

// Moments int_low^high R^m exp(i (a R^2 + b R)) dR of chirps of one curvature a and several slopes b. In bent_moments(),
// the rounding error of the moment m = 2 grows in proportion to (b / 2a)^2.
template <class I, std::size_t count, class Auxiliary>
LOMMEL_INLINE void chirp_moments(I isa, const Auxiliary& auxiliary, double curvature, const typename I::pack (&slope)[count],
                                 typename I::pack low, typename I::pack high, ChirpMoments<I> (&out)[count]) {
    using V = typename I::pack;
    // Negative curvature: moments are complex conjugates of those of the chirp with the opposite phase, -a R^2 - b R.
    const double sign = curvature < 0.0 ? -1.0 : 1.0, a = sign * curvature;
    const V half = splat<V>(0.5) * (high - low), middle = splat<V>(0.5) * (high + low), bend = splat<V>(a) * half * half;
    V b[count];
    for (std::size_t n = 0; n < count; ++n) {
        b[n] = splat<V>(sign) * slope[n];
    }
    bool flat = false, bent = false;
    for (std::size_t i = 0; i < I::lanes; ++i) {
        (bend[i] < nearly_linear ? flat : bent) = true;
    }
    if (bent) {
        bent_moments(isa, auxiliary, a, b, low, high, out);
    }
    if (flat) {
        ChirpMoments<I> made[count];
        flat_moments(isa, a, b, middle, half, made);
        for (std::size_t n = 0; n < count; ++n) {
            for (int m = 0; m < 3; ++m) {
                const V limit = splat<V>(nearly_linear);
                out[n].re[m] = bent ? below(bend, limit, made[n].re[m], out[n].re[m]) : made[n].re[m];
                out[n].im[m] = bent ? below(bend, limit, made[n].im[m], out[n].im[m]) : made[n].im[m];
            }
        }
    }
    for (std::size_t n = 0; n < count; ++n) {
        for (int m = 0; m < 3; ++m) {
            out[n].im[m] = splat<V>(sign) * out[n].im[m];
        }
    }
}

}  // namespace lommel
