// Images of pupils with apertures of any shape, their derivatives by Zernike coefficients, and error bounds of the field.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/aperture/row_field.hpp"

namespace lommel {

// For each pupil with the coefficients edge[pupil][term], write |U|^2 at the pixels to images[pupil], and its derivatives with
// respect to the coefficients of `factors` to slopes[factor][pupil]. losses[pupil]: error bound of the sums for U and dU/dc.
inline void row_images(const std::vector<PhasedRule>& regions, const std::vector<ZernikeTerm>& terms, const double* edge,
                       std::size_t pupils, const Amplitude& light, const DiskWindow& window, double precision, int threads,
                       double* images, const std::vector<ZernikeTerm>& factors, double* slopes, double* losses) {
    const RowField field(regions, window, precision);
    const std::size_t pixels = window.height * window.width;
    Doubles u(2 * pixels), g(factors.empty() ? 0 : 2 * pixels);
    for (std::size_t p = 0; p < pupils; ++p) {
        const ZernikeSum phase(terms, edge + p * terms.size());
        losses[p] = field.sum(phase, light, nullptr, threads, u);
        double* const image = images + p * pixels;
        for (std::size_t i = 0; i < pixels; ++i) {
            image[i] = u[2 * i] * u[2 * i] + u[2 * i + 1] * u[2 * i + 1];
        }
        for (std::size_t j = 0; j < factors.size(); ++j) {
            const double one = 1.0;
            const ZernikeSum factor({factors[j]}, &one);
            losses[p] = std::max(losses[p], field.sum(phase, light, &factor, threads, g));
            // For the coefficient c of `factor`: dU/dc = i G, G: field of pupil function x `factor`; dI/dc = 2 Re(conj(U) dU/dc).
            double* const slope = slopes + (j * pupils + p) * pixels;
            for (std::size_t i = 0; i < pixels; ++i) {
                slope[i] = 2.0 * (u[2 * i + 1] * g[2 * i] - u[2 * i] * g[2 * i + 1]);
            }
        }
    }
}

}  // namespace lommel
