// Huygens' superposition: a spherical wave from every point of the aperture to every point of the sensor.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>

#include "lommel/base/watch.hpp"

namespace lommel {

// field = sum over sources of a (d / rho)^2 exp(i k (rho - rho_0)), with a the amplitude, k the wavenumber, rho the exact distance
// from the source (x, y, 0) to the sensor point (sx, sy, d), and rho_0 that to the axis point (0, 0, d); a includes exp(i k rho_0).
// One factor d / rho is the spherical wave, the other the obliquity (Rayleigh-Sommerfeld, first kind). rho - rho_0 is computed from
// the difference of squares, which keeps all digits although k rho is 10^5 to 10^7 radians.
inline void huygens_sum(const double* x, const double* y, const std::complex<double>* amplitude, std::size_t sources,
                        const double* sx, const double* sy, std::size_t points, double distance, double wavenumber,
                        std::complex<double>* out) {
    const double d2 = distance * distance;
    Glance glance;
    for (std::size_t p = 0; p < points; ++p) {
        glance(8 * sources);
        const double r2 = sx[p] * sx[p] + sy[p] * sy[p];
        double re = 0.0, im = 0.0;
        for (std::size_t s = 0; s < sources; ++s) {
            const double axis2 = d2 + x[s] * x[s] + y[s] * y[s];
            const double change = r2 - 2.0 * (sx[p] * x[s] + sy[p] * y[s]);
            const double rho2 = axis2 + change;
            const double phase = wavenumber * change / (std::sqrt(rho2) + std::sqrt(axis2));
            const double fall = d2 / rho2;
            const double c = fall * std::cos(phase), q = fall * std::sin(phase);
            re += amplitude[s].real() * c - amplitude[s].imag() * q;
            im += amplitude[s].real() * q + amplitude[s].imag() * c;
        }
        out[p] = {re, im};
    }
}

}  // namespace lommel
