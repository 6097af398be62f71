// Pixel averages of a radially symmetric PSF around an arbitrary axis, for windows too large for one polynomial. Rings of equal
// width divide the window. On each ring, averages are sums of angular harmonics times polynomials of the distance from the axis.
// The matrices from intensities to these sums depend only on pixel pitch and largest distance (docs/certificate.md, section 9).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/pixels/window.hpp"

namespace lommel {

struct AverageRings : PixelRings {
    // Largest distance of a pixel from the axis, in optical units; beyond it, other methods are faster.
    static constexpr double most_reach = 2000.0;
    // Approximate number of products to compute the weights. Its factors: number of rings, 16 distances on each, angles, quadrature
    // points in a pixel (places^2), radii per ring.
    static double work(double pitch, double reach) {
        const double places = 0.8 * pitch + 8.0;
        return (reach / 12.0 + 1.0) * 16.0 * (1.2 * pitch + 3.0) * places * places * (1.5 * pitch + 27.0);
    }
    // Limit of work(); beyond it, computing the weights takes longer than rendering many images by other methods.
    static constexpr double most_work = 2e7;

    double step;  // pixel pitch in optical units
    double farthest;  // largest distance of a pixel centre from the axis, in pixels
    int level;  // requested accuracy in decimal digits; the error bound is `error`
    double width;  // width of a ring in optical units

    AverageRings(double pitch, double pixels, int digits, int threads) : step(pitch), farthest(pixels), level(digits) {
        const double allowed = std::pow(10.0, -level), half = plan(step, allowed), slack = step * 0.70710678118654752;
        width = 2.0 * half;
        const std::size_t outputs = radial_degree * harmonics;  // number of coefficients per ring, a multiple of block_outputs
        static_assert(radial_degree % block_outputs == 0);
        std::vector<double> radius;
        std::size_t entries = 0;
        for (double begin = 0.0; begin <= farthest * step * (1.0 + 1e-12); begin += width) {
            const RingNodes nodes(begin, begin + width, slack, of_nodes_within(allowed));
            rings.push_back({nodes, begin + half, half, radius.size(), 0, 0, 0, entries, outputs, false});
            entries += nodes.count * outputs;
            for (std::size_t i = 0; i < nodes.count; ++i) {
                radius.push_back(nodes.radius(i));
            }
        }
        places = sort_radii(radius);
        weigh(step, half, threads);
    }

    // Largest distance from the axis that the table covers, corners of pixels included, in optical units.
    double outermost() const { return rings.back().nodes.high; }
    std::size_t bytes() const {
        return sizeof(double) * (weights.size() + radii.size()) + sizeof(std::int32_t) * places.size();
    }
    bool is(double pitch, double pixels, int digits, int) const {
        return step == pitch && farthest == pixels && level == digits;
    }
    static constexpr std::size_t most_bytes = std::size_t{64} << 20;
    static std::shared_ptr<const AverageRings> get(double pitch, double pixels, int digits, int threads) {
        return cache<AverageRings>.get(pitch, pixels, digits, threads);
    }

    // Compute out[pixel], the averages over the pixels of `window`, from intensity[radius]; returns the rounding error of the
    // polynomials, in units of roundoff. The speed is limited by the latency of multiply-adds, of which four chains overlap.
    double values(const PixelWindow& window, const double* intensity, int threads, Doubles& scratch, double* out) const {
        std::vector<std::int32_t> ring_of, place_of;
        std::vector<std::size_t> starts, next;
        constexpr std::size_t whole =
            2 * row_lanes;  // values of a ring are padded to multiples of this, two of the widest vectors
        const std::size_t pixels = window.height * window.width, room = pixels + whole * rings.size();
        const std::size_t outputs = radial_degree * harmonics;
        scratch.resize(2 * pixels + 3 * room);
        double *const v = scratch.data(), *const angle = v + pixels, *const x = angle + pixels, *const cosine = x + room,
                      *const made = cosine + room;
        ring_of.resize(pixels);
        place_of.resize(pixels);
        next.assign(rings.size(), 0);
        const double per_ring = 1.0 / width;
        const std::int32_t last = static_cast<std::int32_t>(rings.size()) - 1;
        window.each([&](std::size_t i, double dx, double dy, double square) LOMMEL_INLINE_LAMBDA {
            v[i] = step * std::sqrt(square);
            angle[i] = cosine_of_four(dx, dy, square);
            ring_of[i] = std::min(static_cast<std::int32_t>(v[i] * per_ring), last);
        });
        for (std::size_t i = 0; i < pixels; ++i) {
            ++next[static_cast<std::size_t>(ring_of[i])];
        }
        // Store the pixels of each ring contiguously, padded to whole vectors with points at the middle of the ring.
        starts.assign(rings.size() + 1, 0);
        for (std::size_t r = 0; r < rings.size(); ++r) {
            const std::size_t end = starts[r] + next[r];
            starts[r + 1] = starts[r] + (next[r] + whole - 1) / whole * whole;
            next[r] = starts[r];
            std::fill(x + end, x + starts[r + 1], 0.0);
            std::fill(cosine + end, cosine + starts[r + 1], 0.0);
        }
        for (std::size_t i = 0; i < pixels; ++i) {
            const Ring& ring = rings[static_cast<std::size_t>(ring_of[i])];
            const std::size_t place = next[static_cast<std::size_t>(ring_of[i])]++;
            x[place] = (v[i] - ring.middle) / ring.half;
            cosine[place] = angle[i];
            place_of[i] = static_cast<std::int32_t>(place);
        }
        constexpr std::size_t block = 4;  // number of rings per parallel task
        std::vector<double> penalties((rings.size() + block - 1) / block, 0.0);
        parallel_for(penalties.size(), threads, [&](std::size_t, std::size_t task) {
            thread_local Doubles own;
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t r = task * block; r < std::min(rings.size(), (task + 1) * block); ++r) {
                    const Ring& ring = rings[r];
                    const std::size_t nodes = ring.nodes.count, here = starts[r + 1] - starts[r];
                    if (here == 0) {
                        continue;
                    }
                    own.resize(outputs + nodes);
                    double *sums = own.data(), *const at = sums + outputs;
                    for (std::size_t i = 0; i < nodes; ++i) {
                        at[i] = intensity[places[ring.first_node + i]];
                    }
                    const double* const from = at;
                    for (std::size_t first = 0; first < outputs; first += block_outputs) {
                        weighted_sums<1>(isa, weights.data() + ring.first_weight + first * nodes, nodes, &from, &sums, first);
                    }
                    penalties[task] = std::max(penalties[task], weighted_size(isa, sums, penalty.data(), outputs));
                    sum_ring(sums, x + starts[r], cosine + starts[r], here, made + starts[r]);
                }
            });
        });
        for (std::size_t i = 0; i < pixels; ++i) {
            out[i] = made[place_of[i]];
        }
        return *std::max_element(penalties.begin(), penalties.end());
    }
};

}  // namespace lommel
