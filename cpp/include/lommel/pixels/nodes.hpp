// Where averages over pixels take I: at some radii of a ring, and at some places within a pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/bounds/settle.hpp"
#include "lommel/pixels/kernels.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/chebyshev.hpp"
#include "lommel/special/legendre.hpp"

namespace lommel {

// Chebyshev points for I at all distances within `slack` of [least, most]. Near the axis I is taken as a polynomial in the
// square of the distance, which is to interpolate it as an even function on both sides.
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

    // At least so many.
    RingNodes of(std::size_t least) const {
        RingNodes more = *this;
        more.count = std::max(count, least);
        return more;
    }
    double point(std::size_t i) const { return chebyshev_point(count - 1 - i, count); }
    double radius(std::size_t i) const {
        return even ? high * std::sqrt(0.5 * (1.0 + point(i))) : 0.5 * (low + high + (high - low) * point(i));
    }
    // Where distances, given by their squares, lie between -1 and 1.
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

// Gauss's nodes in a square, and their weights, which sum to 1; padded to vectors.
struct Square {
    std::size_t padded;
    Doubles across, down, share;

    Square(double side, std::size_t q)
        : padded((q * q + position_step - 1) / position_step * position_step), across(padded), down(padded), share(padded) {
        std::vector<double> nodes(q), weight(q);
        gauss_legendre(q, nodes.data(), weight.data());
        for (std::size_t i = 0; i < q * q; ++i) {
            down[i] = 0.5 * side * nodes[i / q];
            across[i] = 0.5 * side * nodes[i % q];
            share[i] = 0.25 * weight[i / q] * weight[i % q];
        }
    }
};

}  // namespace lommel
