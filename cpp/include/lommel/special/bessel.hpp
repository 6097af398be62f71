// Bessel functions of the first kind, all integer orders at once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// J_0(v) and J_1(v) by Hankel's expansion (DLMF 10.17.3), from the cosine, sine and square root of v. All lanes must have v >= 100,
// where the omitted terms are below 1e-17.
template <class V>
LOMMEL_INLINE void first_bessel(V v, V cosine, V sine, V root, V& zeroth, V& first) {
    V parts[2][2];  // [order][sum of the even terms, of the odd terms]
    const V turn = splat<V>(0.125) / v;
    for (int order = 0; order < 2; ++order) {
        const double mu = 4.0 * order;
        V term = splat<V>(1.0);
        parts[order][0] = term;
        parts[order][1] = splat<V>(0.0);
        for (int k = 1; k < 12; ++k) {
            const double odd = 2.0 * k - 1.0;
            term = term * (splat<V>((mu - odd * odd) / k) * turn);
            V& sum = parts[order][k % 2];
            sum = k % 4 < 2 ? sum + term : sum - term;
        }
    }
    const V scale = splat<V>(0.56418958354775628695) / root;  // 1 / sqrt(pi)
    zeroth = scale * (parts[0][0] * (cosine + sine) - parts[0][1] * (sine - cosine));
    first = scale * (parts[1][0] * (sine - cosine) + parts[1][1] * (sine + cosine));
}

// Number of orders, from J_0 on, that the upward recurrence from J_0 and J_1 may compute: it is stable for orders well below v.
inline std::size_t rising(double v) { return v >= 100.0 ? static_cast<std::size_t>(0.5 * v) : 0; }

// Starting order of Miller's backward recurrence. Beyond order v + O(v^(1/3)), J_n(v) falls faster than any power of n, so the
// arbitrary initial values do not affect the result.
inline std::size_t bessel_start(double v, std::size_t count) {
    const double reach = std::max(v, static_cast<double>(count));
    const std::size_t start = static_cast<std::size_t>(reach + 12.0 * std::cbrt(reach + 1.0) + 40.0);
    return start + start % 2;
}

// J_0(v) .. J_{count-1}(v) for v >= 0, with an absolute error of a few units of 2^-53. If count <= rising(v): upward recurrence
// from J_0 and J_1. Otherwise, for small v: power series; for larger v: Miller's backward recurrence (DLMF 3.6(vi)) from the order
// bessel_start(v, count), normalised by J_0 + 2 (J_2 + J_4 + ...) = 1 (DLMF 10.12.4).
inline void bessel_sequence(double v, std::size_t count, double* out) {
    if (count == 0) {
        return;
    }
    if (count <= rising(v)) {
        using V = Portable::pack;
        V first, second;
        first_bessel(splat<V>(v), splat<V>(std::cos(v)), splat<V>(std::sin(v)), splat<V>(std::sqrt(v)), first, second);
        double before = first[0], here = second[0];
        out[0] = before;
        const double turn = 2.0 / v;
        for (std::size_t k = 1; k < count; ++k) {
            out[k] = here;
            const double next = turn * static_cast<double>(k) * here - before;
            before = here;
            here = next;
        }
        return;
    }
    if (v < 1e-3) {
        // Three terms of the power series, for v below 1e-3: relative error below (v/2)^6 < 2e-20.
        const double q = 0.25 * v * v;
        double scale = 1.0;
        for (std::size_t n = 0; n < count; ++n) {
            const double m = static_cast<double>(n);
            out[n] = scale * (1.0 - q / (m + 1.0) * (1.0 - 0.5 * q / (m + 2.0)));
            scale *= 0.5 * v / (m + 1.0);
        }
        return;
    }
    const std::size_t start = bessel_start(v, count);
    constexpr double tiny = 1e-280, huge = 1e250;
    double above = 0.0, here = tiny, sum = 0.0;
    for (std::size_t k = start; k > 0; --k) {
        if (k < count) {
            out[k] = here;
        }
        if (k % 2 == 0) {
            sum += 2.0 * here;
        }
        const double below = 2.0 * static_cast<double>(k) / v * here - above;
        above = here;
        here = below;
        if (std::abs(here) > huge) {
            here /= huge;
            above /= huge;
            sum /= huge;
            for (std::size_t j = k; j < count; ++j) {
                out[j] /= huge;
            }
        }
    }
    out[0] = here;
    sum += here;
    for (std::size_t n = 0; n < count; ++n) {
        out[n] /= sum;
    }
}

// 2 (-1)^k J_{2k+1+parity}(v) / v for k = 0 .. terms-1: twice the Hankel transforms, up to the sign, of the Zernike radial
// polynomials of degree 2k + parity; for parity 0 also of the Legendre polynomials P_k(2t - 1), t = (pupil radius)^2.
inline void zernike_transforms(std::size_t parity, double v, std::size_t terms, double* out, std::vector<double>& scratch) {
    if (v < 1e-150) {
        std::fill(out, out + terms, 0.0);
        if (terms > 0 && parity == 0) {
            out[0] = 1.0;
        }
        return;
    }
    scratch.resize(2 * terms + parity);
    bessel_sequence(v, scratch.size(), scratch.data());
    for (std::size_t k = 0; k < terms; ++k) {
        out[k] = (k % 2 == 0 ? 2.0 : -2.0) * (scratch[2 * k + 1 + parity] / v);
    }
}

inline void legendre_transforms(double v, std::size_t terms, double* out, std::vector<double>& scratch) {
    zernike_transforms(0, v, terms, out, scratch);
}

}  // namespace lommel
