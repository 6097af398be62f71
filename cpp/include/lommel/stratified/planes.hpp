// Planes of a microscope's stack: pupil angles, phases, Hermitian forms for intensities (docs/certificate.md, section 15).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

constexpr std::size_t most_parts = 3;

// Pupil angles, the nodes of a quadrature: pupil radius rho, amplitudes of the parts of the field (azimuthal orders 0, 1, ...),
// and the phase psi = fixed + depth * by_depth + focus * by_focus.
struct Angles {
    const double* rho;
    std::size_t count, parts;
    const std::complex<double>*part, *fixed, *by_depth, *by_focus;  // part: amplitudes [part][angle]; others: phases [angle]
    double error;                                                   // error bound of each part of the field

    // (Rounding error of a sum over angles) / (sum of its terms' moduli). of_bessel: error of Bessel functions, in roundoffs.
    double rounding(double of_bessel) const { return (static_cast<double>(count) + of_bessel + 16.0) * unit_roundoff; }
};

// One azimuthal order of the intensity: the sum over j, l of form[j][l] F_j conj(F_l), F_j being the parts of the field, times
// (cosine * cos(order * phi) + sine * sin(order * phi)), phi being the azimuth.
struct Harmonic {
    std::complex<double> form[most_parts][most_parts];
    std::size_t order;
    double cosine, sine;
    double size() const { return std::hypot(cosine, sine); }
};

// Variables of derivatives: depth of the emitter, stage focus, and radius v in lambda / (2 pi NA).
enum class By { depth, focus, radius };
struct Derivative {
    By by;
    double error;  // error bound of each part of the differentiated field
};

// Planes of a stack: depth of the emitter, stage focus and collected power, each [plane]; azimuthal orders of the intensity.
struct Planes {
    Angles angles;
    const double *depth, *focus, *power;
    std::size_t count;
    std::vector<Harmonic> harmonics;
    std::vector<Derivative> derivatives;

    bool slopes() const {
        return std::any_of(derivatives.begin(), derivatives.end(), [](const Derivative& d) { return d.by == By::radius; });
    }

    bool radial() const { return harmonics.size() == 1; }

    // Write the waves parts[part][angle] * exp(i psi), psi being the phase, to re and im[part * stride + angle], and the sum over
    // angles of |re| + |im| to sizes[part]. Only for evanescent waves, which are few, Im psi is not 0 and exp(-Im psi) is computed.
    template <class I>
    LOMMEL_INLINE void waves(I isa, std::size_t plane, const std::complex<double>* parts, std::size_t stride, double* re,
                             double* im, double* sizes) const {
        using V = typename I::pack;
        const double d = depth[plane], f = focus[plane];
        thread_local Doubles phase, sine, cosine;
        phase.resize(stride);
        sine.resize(stride);
        cosine.resize(stride);
        for (std::size_t q = 0; q < angles.count; ++q) {
            phase[q] = angles.fixed[q].real() + d * angles.by_depth[q].real() + f * angles.by_focus[q].real();
        }
        std::fill(phase.begin() + static_cast<std::ptrdiff_t>(angles.count), phase.end(), 0.0);
        for (std::size_t q = 0; q < stride; q += I::lanes) {
            V s, c;
            sincos(isa, load<V>(phase.data() + q), s, c);
            store(sine.data() + q, s);
            store(cosine.data() + q, c);
        }
        for (std::size_t q = 0; q < angles.count; ++q) {
            const double fades = angles.fixed[q].imag() + d * angles.by_depth[q].imag() + f * angles.by_focus[q].imag();
            if (fades != 0.0) {
                const double left = std::exp(-fades);
                sine[q] *= left;
                cosine[q] *= left;
            }
        }
        for (std::size_t m = 0; m < angles.parts; ++m) {
            const std::complex<double>* part = parts + m * angles.count;
            double size = 0.0;
            for (std::size_t q = 0; q < angles.count; ++q) {
                const double a = part[q].real(), b = part[q].imag(), x = a * cosine[q] - b * sine[q],
                             y = a * sine[q] + b * cosine[q];
                re[m * stride + q] = x;
                im[m * stride + q] = y;
                size += std::abs(x) + std::abs(y);
            }
            sizes[m] = size;
        }
    }

    // Add i d psi / dx times (re, im) to (to_re, to_im), psi being the phase and x the depth or the focus.
    void turn(By by, std::size_t stride, const double* re, const double* im, double* to_re, double* to_im,
              double* sizes) const {
        const std::complex<double>* rate = by == By::depth ? angles.by_depth : angles.by_focus;
        for (std::size_t m = 0; m < angles.parts; ++m) {
            double size = 0.0;
            for (std::size_t q = 0; q < angles.count; ++q) {
                const std::size_t at = m * stride + q;
                const double a = rate[q].real(), b = rate[q].imag();
                to_re[at] -= b * re[at] + a * im[at];
                to_im[at] += a * re[at] - b * im[at];
                size += std::abs(to_re[at]) + std::abs(to_im[at]);
            }
            sizes[m] = size;
        }
    }

    // Sum over the harmonics first .. last - 1 of size() times the sum over j, l of |form[j][l]| f(j, l), divided by the collected
    // power.
    template <class F>
    double bilinear(std::size_t plane, const F& f, std::size_t first, std::size_t last) const {
        double sum = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            for (std::size_t j = 0; j < angles.parts; ++j) {
                for (std::size_t l = 0; l < angles.parts; ++l) {
                    sum += harmonics[k].size() * std::abs(harmonics[k].form[j][l]) * f(j, l);
                }
            }
        }
        return sum / power[plane];
    }
};

}  // namespace lommel
