// Images whose pixels do not fall on few radii: an optical axis off the pixel centres, or averages over pixels.
#pragma once

#include <cmath>
#include <cstddef>

#include "lommel/simd.hpp"
#include "lommel/watch.hpp"

namespace lommel {

// Cubic Lagrange interpolation in a profile given at (i - 1) / per_step, i = 0, 1, ...: the error is at most 3/128 of the
// fourth derivative times the fourth power of the step.
LOMMEL_INLINE double interpolated(const double* samples, double s) {
    const std::size_t i = static_cast<std::size_t>(s);
    const double t = s - static_cast<double>(i), u = 1.0 - t, a = 1.0 + t, b = 1.0 + u;
    const double* p = samples + i;
    return 0.5 * (u * a * b * p[1] + t * a * b * p[2]) - t * u / 6.0 * (b * p[0] + a * p[3]);
}

// out[y][x] = sum over the nodes of weight * I(distance of (y + node_j, x + node_i) from the centre), lengths in pixels.
// Bound by the four loads of each interpolation.
template <class T>
LOMMEL_INLINE void paint_subpixel(const double* samples, double per_step, double scale, double center_y, double center_x,
                                  const double* nodes, const double* weights, std::size_t node_count,
                                  std::size_t height, std::size_t width, T* out) {
    Glance glance;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            glance(node_count * node_count);
            double sum = 0.0;
            for (std::size_t j = 0; j < node_count; ++j) {
                const double dy = static_cast<double>(y) - center_y + nodes[j];
                double row = 0.0;
                for (std::size_t i = 0; i < node_count; ++i) {
                    const double dx = static_cast<double>(x) - center_x + nodes[i];
                    row += weights[i] * interpolated(samples, per_step * std::sqrt(dx * dx + dy * dy));
                }
                sum += weights[j] * row;
            }
            out[y * width + x] = static_cast<T>(scale * sum);
        }
    }
}

}  // namespace lommel
