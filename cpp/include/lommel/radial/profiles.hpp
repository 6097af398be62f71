// Fields and intensities at radii given by the caller.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#include "lommel/base/parallel.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/radial/intensity.hpp"
#include "lommel/radial/stack.hpp"

namespace lommel {

// Copy of the ascending radii v, padded for loads of whole vectors.
inline Doubles padded(const double* v, std::size_t count) {
    Doubles radii(v, v + count);
    radii.resize(count + widest_step, count > 0 ? v[count - 1] : 0.0);
    return radii;
}

// Compute the complex fields out[pupil * count + i] at the ascending radii v[i], in optical units, with their error bounds. The
// error of the intensity is to be at most tol * (estimated peak). The phase of the pupil function is 0 at the pupil's centre.
inline void fields(const Stack& stack, const double* v, std::size_t count, double tol, std::complex<double>* out,
                   double* bounds) {
    const Doubles radii = padded(v, count);
    Doubles re(count + widest_step), im(re.size());
    Field field;
    for (std::size_t pupil = 0; pupil < stack.count; ++pupil) {
        const Phase phase = stack[pupil];
        bounds[pupil] =
            field.prepare(phase, 0, stack.obscuration, {radii.data(), count, 1.0}, first_error(phase, stack.obscuration, tol));
        for (std::size_t first = 0; first < count; first += chunk_radii) {
            look();
            field.values(radii.data(), first, std::min(count, first + chunk_radii), 1.0, re.data() + first, im.data() + first);
        }
        // Phase at the centre of the pupil, where the Zernike polynomial R_2j^0 is (-1)^j.
        double middle = 0.0;
        for (std::size_t k = 0; k < phase.terms; ++k) {
            middle += k % 2 == 0 ? -phase.coefficients[k] : phase.coefficients[k];
        }
        const std::complex<double> turn(std::cos(middle), -std::sin(middle));
        bounds[pupil] += unit_roundoff * (static_cast<double>(phase.terms) * phase.size() + 8.0);
        for (std::size_t i = 0; i < count; ++i) {
            out[pupil * count + i] = turn * std::complex<double>(re[i], im[i]);
        }
    }
}

// Compute the intensities out[pupil * count + i] at the ascending radii v[i], in optical units, the peaks, and error bounds
// relative to the peaks (negative if `tol` is not met).
inline void profiles(const Stack& stack, const double* v, std::size_t count, double tol, double* out, double* bounds,
                     double* peaks, int threads = 1) {
    const Doubles radii = padded(v, count);
    const Places places(radii.data(), count, 1.0);
    double microseconds = 0.0;
    for (std::size_t pupil = 0; pupil < stack.count; ++pupil) {
        microseconds += 2.0 + 1e-3 * static_cast<double>(count) * (20.0 + stack[pupil].size());
    }
    parallel_for(stack.count, worthwhile_threads(threads, microseconds), [&](std::size_t, std::size_t pupil) {
        thread_local Field field;
        const auto take = [&](std::size_t first, std::size_t here, const double* values) {
            std::copy_n(values, here, out + pupil * count + first);
        };
        try {
            const Settled s = settle_field<double>(field, stack[pupil], stack.obscuration, places, tol, false,
                                                   [&] { return intensities(field, places, 1, take); });
            bounds[pupil] = s.relative;
            peaks[pupil] = s.peak;
        } catch (const ToleranceNotMet& failure) {
            bounds[pupil] = -failure.bound;
        }
    });
}

}  // namespace lommel
