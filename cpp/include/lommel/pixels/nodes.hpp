// Nodes for pixel averages: radii for interpolating the intensity on a ring around the axis, and quadrature points of a pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/kernels.hpp"
#include "lommel/special/chebyshev.hpp"
#include "lommel/special/legendre.hpp"

namespace lommel {

// Chebyshev points for interpolating the intensity at distances from `low` to `high`. If `even` (close to the axis), the
// interpolant is a polynomial of the squared distance, as the intensity is an even function of the distance.
struct RingNodes {
    double low, high;
    bool even;
    std::size_t count;
    double error;

    RingNodes(double least, double most, double slack, double allowed) : low(least - slack), high(most + slack) {
        even = low < 0.25 * high;
        low = even ? 0.0 : low;
        const double half = even ? high : 0.5 * (high - low);
        const std::size_t share = even ? 2 : 1;
        const auto off = [&](std::size_t n) { return interpolation_error(half, share * n); };
        count = fewest(static_cast<std::size_t>(2.0 * half) / share + 1, [&](std::size_t n) { return off(n) <= allowed; });
        error = off(count);
    }

    // Return a copy with at least `least` points.
    RingNodes of(std::size_t least) const {
        RingNodes more = *this;
        more.count = std::max(count, least);
        return more;
    }
    double point(std::size_t i) const { return chebyshev_point(count - 1 - i, count); }
    double radius(std::size_t i) const {
        return even ? high * std::sqrt(0.5 * (1.0 + point(i))) : 0.5 * (low + high + (high - low) * point(i));
    }
    // Map squared distances from the axis to the interval [-1, 1] of point(), in place.
    LOMMEL_INLINE void squeeze(double* squares, std::size_t length) const {
        if (even) {
            const double slope = high > 0.0 ? 2.0 / (high * high) : 0.0;
            for (std::size_t i = 0; i < length; ++i) {
                squares[i] = slope * squares[i] - 1.0;
            }
        } else {
            const double slope = high > low ? 2.0 / (high - low) : 0.0, middle = 0.5 * (low + high);
            for (std::size_t i = 0; i < length; ++i) {
                squares[i] = slope * (std::sqrt(squares[i]) - middle);
            }
        }
    }
};

// Gauss nodes at (across, down) in a pixel with weights `share`, padded to `padded` nodes by weights 0. square(): for the average
// over the pixel; sides(): for the average along its left edge minus that along its right edge.
struct Points {
    std::size_t padded;
    Doubles across, down, share;

    static Points square(double side, std::size_t q) {
        const Rule rule(side, q);
        Points made(q * q);
        for (std::size_t i = 0; i < q * q; ++i) {
            made.down[i] = rule.nodes[i / q];
            made.across[i] = rule.nodes[i % q];
            made.share[i] = rule.weights[i / q] * rule.weights[i % q];
        }
        return made;
    }

    static Points sides(double side, std::size_t q) {
        const Rule rule(side, q);
        Points made(2 * q);
        for (std::size_t i = 0; i < 2 * q; ++i) {
            const double sign = i < q ? 1.0 : -1.0;
            made.down[i] = rule.nodes[i % q];
            made.across[i] = -0.5 * sign * side;
            made.share[i] = sign * rule.weights[i % q];
        }
        return made;
    }

   private:
    struct Rule {
        std::vector<double> nodes, weights;
        Rule(double side, std::size_t q) : nodes(q), weights(q) {
            gauss_legendre(q, nodes.data(), weights.data());
            for (std::size_t i = 0; i < q; ++i) {
                nodes[i] *= 0.5 * side;
                weights[i] *= 0.5;
            }
        }
    };

    explicit Points(std::size_t count)
        : padded((count + position_step - 1) / position_step * position_step), across(padded), down(padded), share(padded) {}
};

}  // namespace lommel
