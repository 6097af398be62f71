// Interpolation of the intensity from Chebyshev radii to all radii of a centred window, by piecewise polynomials.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

struct Between : Radii {  // radii: Chebyshev points of each piece, in lambda / (2 pi NA)
    static constexpr double widest = 16.0;
    static constexpr std::size_t tile = 16;

    std::shared_ptr<const Layout> layout;  // kept alive, as the cache compares its address
    double step;
    std::size_t nodes, pieces;
    double half, error;                // half width of a piece; interpolation error of a function bounded by 1
    std::vector<std::size_t> first;    // [piece]: index of its first radius
    std::vector<std::size_t> weight;   // [piece]: index of its first weight
    Doubles weights;                   // [piece][tile of radii][node][radius in the tile]

    static std::size_t pieces_of(double reach) { return static_cast<std::size_t>(std::ceil(reach / widest)); }

    Between(const std::shared_ptr<const Layout>& of, double pitch, std::size_t points)
        : layout(of), step(pitch), nodes(points), pieces(pieces_of(of->reach() * pitch)),
          half(0.5 * of->reach() * pitch / static_cast<double>(pieces)), error(interpolation_error(half, points)) {
        count = pieces * nodes;
        for (std::size_t s = 0; s < pieces; ++s) {
            for (std::size_t j = 0; j < nodes; ++j) {
                radii.push_back(middle(s) + half * point(j));
            }
        }
        radii.resize(count + widest_step, radii.back());
        weights.reserve((layout->count / tile + pieces + 1) * nodes * tile);
        std::size_t i = 0;
        for (std::size_t s = 0; s < pieces; ++s) {
            first.push_back(i);
            while (i < layout->count && (s + 1 == pieces || layout->radii[i] * step <= middle(s) + half)) {
                ++i;
            }
            weight.push_back(weights.size());
            for (std::size_t at = first.back(); at < i; at += tile) {
                look();
                const std::size_t block = weights.size();
                weights.resize(block + nodes * tile, 0.0);
                for (std::size_t k = 0; k < std::min(tile, i - at); ++k) {
                    weigh((layout->radii[at + k] * step - middle(s)) / half, weights.data() + block + k);
                }
            }
        }
        first.push_back(i);
    }

    double magnification() const { return lebesgue(nodes); }
    // Rounding of interpolated values, in roundoffs of the largest value: 4 * nodes + 8 for the second barycentric formula (N. J.
    // Higham, IMA J. Numer. Anal. 24, 547, 2004), magnified by the interpolation.
    double rounding() const { return (4.0 * static_cast<double>(nodes) + 8.0) * (magnification() + 1.0); }

    // Interpolate `Together` rows, from values[row * stride + node] to out[row * out_stride + radius]. Whole tiles are written
    // in order; the next piece overwrites the excess of the last tile.
    template <std::size_t Together, class I>
    LOMMEL_INLINE void apply(I, const double* values, std::size_t stride, double* out, std::size_t out_stride) const {
        using V = typename I::pack;
        for (std::size_t s = 0; s < pieces; ++s) {
            const double *table = weights.data() + weight[s], *from = values + s * nodes;
            for (std::size_t at = first[s]; at < first[s + 1]; at += tile, table += nodes * tile) {
                for (std::size_t i = 0; i < tile; i += 2 * I::lanes) {
                    V sum[Together][2] = {};
                    for (std::size_t j = 0; j < nodes; ++j) {
                        const V w[2] = {load<V>(table + j * tile + i), load<V>(table + j * tile + i + I::lanes)};
                        for (std::size_t p = 0; p < Together; ++p) {
                            const V value = splat<V>(from[p * stride + j]);
                            sum[p][0] = sum[p][0] + value * w[0];
                            sum[p][1] = sum[p][1] + value * w[1];
                        }
                    }
                    for (std::size_t p = 0; p < Together; ++p) {
                        store(out + p * out_stride + at + i, sum[p][0]);
                        store(out + p * out_stride + at + i + I::lanes, sum[p][1]);
                    }
                }
            }
        }
    }

    bool is(const std::shared_ptr<const Layout>& of, double pitch, std::size_t points) const {
        return layout == of && step == pitch && nodes == points;
    }
    std::size_t bytes() const { return sizeof(double) * (weights.size() + radii.size()); }
    static constexpr std::size_t most_bytes = std::size_t{64} << 20;
    static std::shared_ptr<const Between> get(const std::shared_ptr<const Layout>& of, double pitch, std::size_t points) {
        return cache<Between>.get(of, pitch, points);
    }

   private:
    double middle(std::size_t s) const { return half * (2.0 * static_cast<double>(s) + 1.0); }
    double point(std::size_t j) const { return chebyshev_point(nodes - 1 - j, nodes); }

    // Write to to[j * tile] the Lagrange polynomial of each node j, evaluated at x by the barycentric formula. Its weights for
    // Chebyshev points are sines with alternating signs.
    void weigh(double x, double* to) const {
        double sum = 0.0;
        for (std::size_t j = 0; j < nodes; ++j) {
            const double away = x - points_[j];
            if (away == 0.0) {
                for (std::size_t k = 0; k < nodes; ++k) {
                    to[k * tile] = k == j ? 1.0 : 0.0;
                }
                return;
            }
            to[j * tile] = signs_[j] / away;
            sum += to[j * tile];
        }
        for (std::size_t j = 0; j < nodes; ++j) {
            to[j * tile] /= sum;
        }
    }

    std::vector<double> points_ = [this] {
        std::vector<double> made(nodes);
        for (std::size_t j = 0; j < nodes; ++j) {
            made[j] = point(j);
        }
        return made;
    }();
    std::vector<double> signs_ = [this] {
        std::vector<double> made(nodes);
        for (std::size_t j = 0; j < nodes; ++j) {
            const double angle = pi * (static_cast<double>(nodes - 1 - j) + 0.5) / static_cast<double>(nodes);
            made[j] = (j % 2 == 0 ? 1.0 : -1.0) * std::sin(angle);
        }
        return made;
    }();
};

}  // namespace lommel
