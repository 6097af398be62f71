// Weights that give pixel averages from intensities at the radii of a ring.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/pixels/kernels.hpp"
#include "lommel/pixels/nodes.hpp"

namespace lommel {

// Compute rows[output][node], the weight of the intensity at each radius of a ring in an average over the quadrature points
// `around` the position with polar coordinates radius(output) and angle(output).
template <class I, class Radius, class Angle>
LOMMEL_INLINE void average_rows(I isa, const RingNodes& nodes, const Points& around, std::size_t outputs, const Radius& radius,
                                const Angle& angle, double* rows) {
    Doubles points(nodes.count), scale(nodes.count), scratch(around.padded + 3 * nodes.count * I::lanes);
    for (std::size_t i = 0; i < nodes.count; ++i) {
        points[i] = nodes.point(i);
    }
    for (std::size_t i = 0; i < nodes.count; ++i) {
        double product = 1.0;
        for (std::size_t k = 0; k < nodes.count; ++k) {
            product *= k == i ? 1.0 : 2.0 * (points[i] - points[k]);
        }
        scale[i] = 1.0 / product;
    }
    for (std::size_t o = 0; o < outputs; ++o) {
        look();
        const double turn = angle(o), at_x = radius(o) * std::cos(turn), at_y = radius(o) * std::sin(turn);
        for (std::size_t i = 0; i < around.padded; ++i) {
            const double dx = at_x + around.across[i], dy = at_y + around.down[i];
            scratch[i] = dx * dx + dy * dy;
        }
        nodes.squeeze(scratch.data(), around.padded);
        lagrange_row(isa, scratch.data(), around.share.data(), around.padded, points.data(), scale.data(), nodes.count,
                     scratch.data() + around.padded, rows + o * nodes.count);
    }
}

// Angle theta in [0, pi/4] with cos(4 theta) = cosine.
inline double quarter_angle(double cosine) { return 0.25 * std::acos(std::max(-1.0, std::min(1.0, cosine))); }

// Matrix [degree][point] that maps values at descending Chebyshev points to Chebyshev coefficients.
inline Doubles cosine_transform(std::size_t points) {
    Doubles matrix(points * points);
    for (std::size_t k = 0; k < points; ++k) {
        for (std::size_t i = 0; i < points; ++i) {
            const double angle = pi * static_cast<double>(k) * (static_cast<double>(i) + 0.5);
            matrix[k * points + i] =
                (k == 0 ? 1.0 : 2.0) / static_cast<double>(points) * std::cos(angle / static_cast<double>(points));
        }
    }
    return matrix;
}

// Matrix [k][point] that maps values of an odd function at the positive half of 2 `points` Chebyshev points, in descending
// order, to its coefficients of the Chebyshev polynomials of degree 2k + 1.
inline Doubles odd_transform(std::size_t points) {
    Doubles matrix(points * points);
    for (std::size_t k = 0; k < points; ++k) {
        for (std::size_t i = 0; i < points; ++i) {
            const double angle = pi * (static_cast<double>(k) + 0.5) * (static_cast<double>(i) + 0.5);
            matrix[k * points + i] = 2.0 / static_cast<double>(points) * std::cos(angle / static_cast<double>(points));
        }
    }
    return matrix;
}

// Multiply `sets` sets of rows of `length` values by a square matrix, in place. Row i of set s is row s * set_stride + i * stride.
LOMMEL_INLINE void transform(const Doubles& matrix, std::size_t sets, std::size_t set_stride, std::size_t stride,
                             std::size_t length, Doubles& rows) {
    const std::size_t points = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
    Doubles made(points * length);
    for (std::size_t s = 0; s < sets; ++s) {
        double* first = rows.data() + s * set_stride * length;
        std::fill(made.begin(), made.end(), 0.0);
        for (std::size_t k = 0; k < points; ++k) {
            for (std::size_t i = 0; i < points; ++i) {
                const double factor = matrix[k * points + i];
                const double* from = first + i * stride * length;
                for (std::size_t n = 0; n < length; ++n) {
                    made[k * length + n] += factor * from[n];
                }
            }
        }
        for (std::size_t k = 0; k < points; ++k) {
            std::copy_n(made.data() + k * length, length, first + k * stride * length);
        }
    }
}

// Reorder rows[output][node] to out[block of outputs][node][output], the order in which weighted_sums() reads them.
inline void block_rows(const double* rows, std::size_t outputs, std::size_t length, double* out) {
    for (std::size_t o = 0; o < outputs; ++o) {
        double* block = out + o / block_outputs * block_outputs * length + o % block_outputs;
        for (std::size_t i = 0; i < length; ++i) {
            block[i * block_outputs] = rows[o * length + i];
        }
    }
}

}  // namespace lommel
