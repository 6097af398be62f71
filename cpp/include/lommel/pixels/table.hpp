// Pixel averages of a window, or samples with the axis off the pixel centres: each value is a weighted sum of intensities at
// few radii. The weights depend only on the window, so one table serves all pupils (docs/certificate.md, section 9).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/kernels.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/nodes.hpp"
#include "lommel/pixels/weights.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

// Pixels of a window, sorted into rings by their distance from the axis. A ring's pixel values are expanded in distance and angle
// or, if they are few, each is computed directly as a weighted sum of intensities at the ring's radii.
struct PixelRings : Radii {  // radii at which the intensity is computed, in optical units
    // Error budget of a table: shares of the requested error.
    struct Budget {
        static constexpr double gauss = 0.1;      // share for quadrature over a pixel
        static constexpr double harmonics = 0.2;  // share for interpolation in the angle
        static constexpr double rings = 0.3;      // share for interpolation in the distance, on a ring
        static constexpr double nodes = 0.2;  // interpolation between radii, amplified by interpolation in distance and angle
        static constexpr double window = 0.5;  // share for interpolation between radii if the window is one ring
        static_assert(gauss + harmonics + rings + nodes <= 1.0 && gauss + window <= 1.0);
    };
    static constexpr std::size_t most_nodes = 900;  // largest number of radii per ring: Lagrange products of more may overflow
    static constexpr std::size_t most_weights = std::size_t{1} << 27;
    static constexpr double near_weights = 32768.0;  // number of weights that fit into a cache of 256 KiB

    struct Ring {
        RingNodes nodes;
        double middle, half;  // middle and half width of the ring, as range of pixel centres, in optical units
        std::size_t first_node;  // index in `places` of the ring's first radius
        std::size_t first_value, values, padding;  // index of the first value; padded number of values; how many are padding
        std::size_t first_weight, outputs;
        bool direct;  // true: outputs are pixel values; false: coefficients [harmonic][degree in the distance]
    };

    std::vector<Ring> rings;  // empty if the intensity is computed at the radius of every pixel
    std::vector<std::int32_t> places;  // for each radius of each ring: its index in the ascending `radii`
    Doubles weights;  // for each ring: [block of outputs][radius][output]
    Doubles x, cosine;  // for each value: radial position in the ring, -1 to 1; cosine of four times the angle
    Doubles penalty;  // for each coefficient: rounding error of its term, in units of roundoff, if the coefficient is 1
    std::size_t harmonics = 1, gauss = 1;
    double error = 0.0;  // error bound of values / half the largest intensity, if the intensities at the radii are exact
    double of_nodes = 1.0, of_grid = 1.0;  // Lebesgue constants: interpolation between radii; in distance and angle
    double rounding = 0.0;  // rounding of weights and sums, in units of roundoff times the largest intensity

    // Largest factor from an error of the intensity at the radii to an error of a pixel value.
    double magnification() const { return of_grid * of_nodes; }

   protected:
    // Evaluate a ring's expansion at `values` pixels. at: radial position in the ring, -1 to 1; angle: cos of four times the angle.
    void sum_ring(const double* coefficients, const double* at, const double* angle, std::size_t values, double* out) const {
        dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
            sum_harmonics(isa, RadialDegree{}, coefficients, harmonics, at, angle, values, out);
        });
    }

    // Compute the weights of all rings, and the error bounds, for pixels of width `side` and rings of half width `half`.
    void weigh(double side, double half, int threads) {
        weights.resize(rings.back().first_weight + rings.back().nodes.count * rings.back().outputs);
        const Points square = Points::square(side, gauss);
        const Doubles radial = cosine_transform(radial_degree), angular = cosine_transform(harmonics);
        parallel_for(rings.size(), threads, [&](std::size_t, std::size_t r) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { weigh(isa, rings[r], square, radial, angular); });
        });
        judge(side, half);
    }

    // Choose numbers of Gauss nodes and harmonics for pixels of width `side` and an error `allowed`; return half a ring's width.
    double plan(double side, double allowed) {
        gauss = fewest(1, [&](std::size_t q) { return gauss_error(side, q) <= Budget::gauss * allowed; });
        harmonics = fewest(1, [&](std::size_t j) { return harmonics_error(side, j) <= Budget::harmonics * allowed; });
        double half = 6.0;
        while (lebesgue(harmonics) * interpolation_error(half, radial_degree) > Budget::rings * allowed) {
            half *= 0.98;
        }
        return half;
    }
    // Allowed error of interpolating the intensity between the radii of a ring that is expanded in distance and angle.
    double of_nodes_within(double allowed) const {
        return Budget::nodes * allowed / (lebesgue(harmonics) * lebesgue(radial_degree));
    }

    // Append the values of `v` to `radii` in ascending order; returns the index of each among them.
    std::vector<std::int32_t> sort_radii(const std::vector<double>& v) {
        std::vector<std::size_t> order(v.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return v[i] < v[k]; });
        std::vector<std::int32_t> place(v.size());
        for (const std::size_t i : order) {
            place[i] = static_cast<std::int32_t>(radii.size());
            radii.push_back(v[i]);
        }
        count = v.size();
        radii.resize(count + widest_step, radii.back());
        return place;
    }

    template <class I>
    LOMMEL_INLINE void weigh(I isa, const Ring& ring, const Points& square, const Doubles& radial, const Doubles& angular) {
        Doubles rows(ring.outputs * ring.nodes.count);
        average_rows(
            isa, ring.nodes, square, ring.outputs,
            // Output o: value at a pixel if `direct`, else at a pair of Chebyshev points, one in distance, one in cos(4 theta).
            [&](std::size_t o) {
                const double at = ring.direct ? x[ring.first_value + o] : chebyshev_point(o % radial_degree, radial_degree);
                return ring.middle + ring.half * at;
            },
            [&](std::size_t o) {
                return quarter_angle(ring.direct ? cosine[ring.first_value + o]
                                                 : chebyshev_point(o / radial_degree, harmonics));
            },
            rows.data());
        if (!ring.direct) {
            transform(radial, harmonics, radial_degree, 1, ring.nodes.count, rows);
            transform(angular, radial_degree, 1, radial_degree, ring.nodes.count, rows);
        }
        block_rows(rows.data(), ring.outputs, ring.nodes.count, weights.data() + ring.first_weight);
    }

    // Set `error`, `rounding` (certificate, section 9, "Together", "Rounding") for pixel width `side` and ring half width `half`.
    void judge(double side, double half) {
        double worst = 0.0;
        std::size_t most = 0;
        bool expanded = false;
        for (const Ring& ring : rings) {
            worst = std::max(worst, ring.nodes.error);
            most = std::max(most, ring.nodes.count);
            expanded = expanded || !ring.direct;
        }
        const double n = static_cast<double>(most);
        of_nodes = lebesgue(most);
        of_grid = expanded ? lebesgue(harmonics) * lebesgue(radial_degree) : 1.0;
        error = of_grid * (worst + gauss_error(side, gauss));
        rounding = of_grid * of_nodes * (6.0 * n + 40.0);
        if (!expanded) {
            harmonics = 0;
            return;
        }
        error += lebesgue(harmonics) * interpolation_error(half, radial_degree) + harmonics_error(side, harmonics);
        const double orders = static_cast<double>(harmonics), degrees = static_cast<double>(radial_degree);
        rounding += of_nodes * 4.0 * orders * degrees * (n + orders + degrees + 4.0);
        for (std::size_t j = 0; j < harmonics; ++j) {
            for (std::size_t k = 0; k < radial_degree; ++k) {
                const double order = static_cast<double>(j), power = static_cast<double>(k);
                penalty.push_back(1.5 * (power + 1.0) * (power + 2.0) + 10.0 * order * order + 4.0 * orders);
            }
        }
    }
};

struct PixelTable : PixelRings {
    PixelWindow window;
    int level;  // requested accuracy in decimal digits; the error bound is `error`
    bool shared;  // true: for many images at a time, which load weights once; without weights unless one ring suffices
    PixelGroups groups;
    std::size_t value_count = 0;

    PixelTable(const PixelWindow& w, int digits, int threads, bool many) : window(w), level(digits), shared(many), groups(w) {
        const auto ends = std::minmax_element(groups.v.begin(), groups.v.end());
        const double least = *ends.first, most = *ends.second, slack = w.side() * 0.70710678118654752;
        const double allowed = std::pow(10.0, -level), values = static_cast<double>(groups.v.size());
        const double half = plan(w.side(), allowed);

        // Estimated multiply-adds per image; those for the table count 1/100, as it serves many images. Alternatives: rings so narrow
        // that `radial_degree` points in distance suffice (by_rings); one ring (by_one); the intensity at the radius of every pixel.
        const double within = of_nodes_within(allowed);
        const RingNodes narrow(std::max(least, 0.5 * most), std::max(least, 0.5 * most) + 2.0 * half, slack, within);
        const RingNodes whole(least, most, slack, Budget::window * allowed);
        const double ring_count = std::ceil((most - least) / (2.0 * half)) + 1.0;
        const double coefficients = static_cast<double>(radial_degree * harmonics), of_ring = values / ring_count;
        const double sum = 1.0 + 0.01 * static_cast<double>(gauss * gauss);
        const double by_rings =
            ring_count * static_cast<double>(narrow.count) * (64.0 + std::min(of_ring, coefficients) * sum) +
            (of_ring > coefficients ? 2.0 * values * coefficients : 0.0);
        // A weight beyond the `near_weights` that stay in the cache takes as long to load as four others.
        const double of_one = static_cast<double>(whole.count) * values,
                     far = many ? 0.0 : std::max(0.0, of_one - near_weights);
        const double by_one = 64.0 * static_cast<double>(whole.count) + of_one * sum + 3.0 * far;
        if (w.side() == 0.0 && 64.0 * values <= std::min(by_rings, by_one)) {
            at_pixels();
            return;
        }
        const bool one = by_one <= by_rings && whole.count <= most_nodes;
        if (many && !one) {
            groups.v = groups.cosine = {};
            return;
        }
        make_rings(least, one ? 0.5 * (most - least) : half, slack, one, one ? Budget::window * allowed : within);
        const std::size_t entries = rings.back().first_weight + rings.back().nodes.count * rings.back().outputs;
        const std::size_t nodes = std::max(narrow.count, rings.front().nodes.count);
        if (entries > most_weights || nodes > most_nodes) {
            throw std::invalid_argument(
                "averages over pixels of " + std::to_string(w.step / pi) + " lambda*N take " +
                (nodes > most_nodes
                     ? std::to_string(nodes) + " radii a pixel, more than the limit of " + std::to_string(most_nodes)
                     : std::to_string(entries) + " weights, more than the limit of " + std::to_string(most_weights)) +
                "; take smaller pixels, and average blocks of them");
        }
        weigh(w.side(), half, threads);
    }

    bool serves_together() const { return rings.size() <= 1 && count > 0; }

    // outermost(): largest distance from the axis that the table covers, in optical units; growth(): factor from an error of
    // the intensity I(v) to an error of v dI/dv (docs/certificate.md, section 15).
    double outermost() const { return rings.empty() ? reach() : rings.back().nodes.high; }
    double growth() const {
        std::size_t most = std::max({radial_degree, gauss, 4 * harmonics});
        for (const Ring& ring : rings) {
            most = std::max(most, ring.nodes.count);
        }
        return 2.0 * (outermost() + static_cast<double>(most));
    }

    std::size_t bytes() const {
        return sizeof(double) * (weights.size() + x.size() + cosine.size() + radii.size()) +
               sizeof(std::int32_t) * (groups.index.size() + places.size());
    }

    bool is(const PixelWindow& w, int digits, int, bool many) const { return window == w && level == digits && shared == many; }
    static constexpr std::size_t most_bytes = std::size_t{192} << 20;
    static std::shared_ptr<const PixelTable> get(const PixelWindow& window, int level, int threads, bool many = false) {
        return cache<PixelTable>.get(window, level, threads, many);
    }

    // Compute the values out[p] of rings first .. last - 1 for `Together` pupils p, from their intensities at the radii. If the
    // rounding error of a ring's sum over angular harmonics, in units of roundoff, exceeds penalties[p], it is stored there.
    template <std::size_t Together, class I>
    LOMMEL_INLINE void apply(I isa, std::size_t first, std::size_t last, const double* const* intensity, double* const* out,
                             double* penalties, Doubles& scratch) const {
        for (std::size_t r = first; r < last; ++r) {
            const Ring& ring = rings[r];
            const std::size_t nodes = ring.nodes.count, room = ring.direct ? 0 : ring.outputs;
            scratch.resize(Together * (nodes + room));
            double *at[Together], *sums[Together];
            for (std::size_t p = 0; p < Together; ++p) {
                at[p] = scratch.data() + Together * room + p * nodes;
                sums[p] = ring.direct ? out[p] + ring.first_value : scratch.data() + p * room;
                for (std::size_t i = 0; i < nodes; ++i) {
                    at[p][i] = intensity[p][places[ring.first_node + i]];
                }
            }
            for (std::size_t block = 0; block < ring.outputs; block += block_outputs) {
                weighted_sums<Together>(isa, weights.data() + ring.first_weight + block * nodes, nodes, at, sums, block);
            }
            for (std::size_t p = 0; p < Together && !ring.direct; ++p) {
                penalties[p] = std::max(penalties[p], weighted_size(isa, sums[p], penalty.data(), ring.outputs));
                sum_ring(sums[p], x.data() + ring.first_value, cosine.data() + ring.first_value, ring.values,
                         out[p] + ring.first_value);
            }
        }
    }

   private:
    void at_pixels() {
        groups.renumber(sort_radii(groups.v));
        value_count = count;
        harmonics = 0;
    }

    // Sort the pixels, the nearest at the distance `least`, into rings of half width `half` (a single ring if `one`). A ring's
    // radii extend by `slack` beyond its pixels on both sides, and are enough for an interpolation error of at most `allowed`.
    void make_rings(double least, double half, double slack, bool one, double allowed) {
        std::vector<std::size_t> ring_of(groups.v.size()), sizes(1, 0);
        Glance glance;
        for (std::size_t i = 0; i < ring_of.size(); ++i) {
            glance(4);
            ring_of[i] = one ? 0 : static_cast<std::size_t>((groups.v[i] - least) / (2.0 * half));
            sizes.resize(std::max(sizes.size(), ring_of[i] + 1), 0);
            ++sizes[ring_of[i]];
        }
        std::vector<std::size_t> next(sizes.size());
        std::vector<double> middle(sizes.size()), radius;
        std::size_t entries = 0;
        for (std::size_t s = 0; s < sizes.size(); ++s) {
            next[s] = value_count;
            middle[s] = least + half * (2.0 * static_cast<double>(s) + 1.0);
            if (sizes[s] > 0) {
                glance(1000);
                const RingNodes nodes(middle[s] - half, middle[s] + half, slack, allowed);
                const std::size_t padded = (sizes[s] + block_outputs - 1) / block_outputs * block_outputs;
                const bool direct = one || sizes[s] <= radial_degree * harmonics;
                rings.push_back({nodes, middle[s], half, radius.size(), value_count, padded, padded - sizes[s], entries,
                                 direct ? padded : radial_degree * harmonics, direct});
                value_count += padded;
                entries += nodes.count * rings.back().outputs;
                for (std::size_t i = 0; i < nodes.count; ++i) {
                    radius.push_back(nodes.radius(i));
                }
            }
        }
        places = sort_radii(radius);
        x.resize(value_count);
        cosine.resize(value_count);
        std::vector<std::int32_t> place(groups.v.size());
        for (std::size_t i = 0; i < place.size(); ++i) {
            glance(4);
            const std::size_t at = next[ring_of[i]]++;
            place[i] = static_cast<std::int32_t>(at);
            x[at] = half > 0.0 ? (groups.v[i] - middle[ring_of[i]]) / half : 0.0;
            cosine[at] = groups.cosine[i];
        }
        // Pad each ring with copies of its first pixel, so that the padding does not change the maximum.
        for (const Ring& ring : rings) {
            const std::size_t end = ring.first_value + ring.values, used = end - ring.padding;
            std::fill(x.begin() + used, x.begin() + end, x[ring.first_value]);
            std::fill(cosine.begin() + used, cosine.begin() + end, cosine[ring.first_value]);
        }
        groups.renumber(place);
        // Free the distances and cosines of the pixel groups, which are no longer needed.
        groups.v = groups.cosine = {};
    }
};

}  // namespace lommel
