// Polar non-uniform FFT, zones: ranges of radii, each with the interpolation that the tolerance requires at these radii
// (docs/certificate.md, section 11).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/zernike/polar_preview.hpp"

namespace lommel {

// Error budget of an image by interpolation between circles. U: complex amplitude; I: intensity |U|^2.
struct PolarBudget {
    // image: (allowed error of I) / (tolerance of I); brighter: factor by which |U| may exceed its value in the preview PolarLooks.
    static constexpr double image = 0.9, brighter = 1.15;
    // As fractions of the allowed error of U: `promise`, the largest estimated error with which a PolarStyle (settings of the
    // interpolation) is chosen; `orders`, the allowed error due to omitted azimuthal orders.
    static constexpr double promise = 0.95, orders = 0.05;
    // The second attempt, if any, aims at retry * tolerance * (tolerance / error bound of the first attempt).
    static constexpr double retry = 0.7;
};

// Zone of an image: range of radii, the settings of the interpolation there, and the circles for it.
struct PolarZone {
    const PolarStyle* style;
    std::int64_t low, high;   // range of the squared distances of its pixels from the axis, in pixels^2
    std::size_t first, last;  // range of blocks of circles in the table
    std::size_t orders;
    std::shared_ptr<const PolarKernels> kernels;
    std::shared_ptr<const PolarCircle> circle;
    PairedTaps both;            // taps of both kernels in one vector, if style->paired()
    PolarRows<double> doubles;  // field on the circles, in one of two precisions
    PolarRows<float> floats;
    std::vector<double> errors;  // [circle]: error bound of U
    double left;                 // bound on the contribution of omitted orders to U

    const PolarRows<double>& rows(double) const { return doubles; }
    const PolarRows<float>& rows(float) const { return floats; }
};

// Division of an image into zones, with the field on their circles.
class PolarZones {
   public:
    // Plan zones for pixels at a pitch of `step` in v whose squared distances from the axis, in pixels^2, are `nearest` to
    // `farthest`, for an error of I of at most `tol` times its maximum there, or times `outside` if that is larger. Returns false if
    // the most accurate PolarStyle is unlikely to suffice; it is used nevertheless.
    bool plan(const PolarPupil& pupil, double step, std::int64_t nearest, std::int64_t farthest, double tol, double outside,
              int threads) {
        const double near = step * std::sqrt(static_cast<double>(nearest));
        // Pixels at one radius have a zone, too.
        const double reach = std::max(step * std::sqrt(static_cast<double>(farthest)), near + 1e-9 * (1.0 + near));
        const PolarOrders orders(pupil);
        const PolarLooks looks(pupil, reach, threads);
        const double all = PolarBudget::image * tol * std::max(outside, looks.brightest(near, reach));
        // Allowed error of U at this intensity.
        const auto allowed = [&](double intensity) { return allowed_error(all, intensity, PolarBudget::brighter); };
        std::array<double, polar_styles.size() + 1> starts;
        std::array<std::shared_ptr<const PolarKernels>, polar_styles.size()> kernels;
        starts.back() = 1e300;
        // Try the settings in order, from the fastest to the first that is accurate enough at all radii.
        std::size_t most_exact = polar_styles.size(), first = looks.v.size();
        do {
            const std::size_t s = --most_exact;
            kernels[s] = std::make_shared<const PolarKernels>(pupil, polar_styles[s]);
            first = start(pupil, polar_styles[s], *kernels[s], looks, orders, first, allowed);
            starts[s] = first == looks.v.size() ? starts.back() : looks.v[first];
        } while (starts[most_exact] > near && most_exact > 0);
        const bool likely = starts[most_exact] <= near;
        starts[most_exact] = std::min(starts[most_exact], near);
        const auto end = [&](std::size_t s) {
            return std::min(reach, *std::min_element(starts.begin() + static_cast<std::ptrdiff_t>(s) + 1, starts.end()));
        };
        // Drop narrow zones: their own circles would take more time than their faster interpolation saves.
        for (std::size_t s = polar_styles.size(); --s > most_exact;) {
            if (end(s) - starts[s] < 2.0 * static_cast<double>(PolarTable::block) * polar_styles[s].step()) {
                starts[s] = starts.back();
            }
        }
        count_ = 0;
        zones_.resize(polar_styles.size());
        double from = near;
        for (std::size_t s = most_exact; s < polar_styles.size() && from < reach; ++s) {
            const double to = end(s);
            if (to <= from) {
                continue;
            }
            PolarZone& zone = zones_[count_++];
            const double most = allowed(looks.brightest(from, to));
            zone.style = &polar_styles[s];
            zone.kernels = kernels[s];
            zone.first = block_at(polar_styles[s], from, -1.0);
            zone.last = block_at(polar_styles[s], to, 1.0) + 1;
            zone.low = count_ == 1 ? nearest : zones_[count_ - 2].high;
            zone.high = to < reach ? static_cast<std::int64_t>(std::ceil(to * to / (step * step))) : farthest + 1;
            zone.orders = orders.least(PolarBudget::orders * most, from, zone.kernels->growth);
            zone.circle = circle(zone.orders, zone.style->around);
            if (zone.style->paired()) {
                zone.both = PairedTaps(zone.kernels->outer().coarse, zone.circle->coarse);
            }
            zone.left = orders.left(zone.orders, from, zone.kernels->growth);
            zone.errors.resize((zone.last - zone.first) * PolarTable::block);
            from = to;
        }
        return likely;
    }

    // Compute the field on the circles of all zones.
    void fill(const PolarPupil& pupil, int threads) {
        std::vector<PolarTables> tables;
        std::vector<std::array<std::size_t, 2>> tasks;  // [task]: zone, block in this zone
        tables.reserve(count_);
        for (std::size_t z = 0; z < count_; ++z) {
            PolarZone& zone = zones_[z];
            tables.emplace_back(pupil, *zone.style, *zone.kernels, zone.last);
            if (zone.style->doubles) {
                zone.doubles.resize(*zone.circle, zone.errors.size());
            } else {
                zone.floats.resize(*zone.circle, zone.errors.size());
            }
            for (std::size_t i = 0; i < zone.last - zone.first; ++i) {
                tasks.push_back({z, i});
            }
        }
        parallel_for(tasks.size(), threads, [&](std::size_t, std::size_t task) {
            const auto [z, i] = tasks[task];
            PolarZone& zone = zones_[z];
            if (zone.style->doubles) {
                fill<double, double>(pupil, tables[z], zone, zone.doubles, i);
            } else if (zone.style->exact) {
                fill<double, double>(pupil, tables[z], zone, zone.floats, i);
            } else if (zone.style->rough) {
                fill<float, float>(pupil, tables[z], zone, zone.floats, i);
            } else {
                fill<double, float>(pupil, tables[z], zone, zone.floats, i);
            }
        });
    }

    std::size_t size() const { return count_; }
    const PolarZone& operator[](std::size_t i) const { return zones_[i]; }

   private:
    // Index of the block with the first (side < 0) or last (side > 0) circle that pixels at radius v use; 1.0: margin for rounding.
    static std::size_t block_at(const PolarStyle& style, double v, double side) {
        const double taken = side * (0.5 * static_cast<double>(style.between) + 1.0);
        return static_cast<std::size_t>(v / style.step() + static_cast<double>(PolarTable::before) + taken) / PolarTable::block;
    }

    static std::shared_ptr<const PolarCircle> circle(std::size_t orders, std::size_t taps) {
        return cache<PolarCircle>.get(RowFft<float>::length(std::max(PolarCircle::least_points(taps), 4 * orders)), taps);
    }

    // Smallest index i for which `style` meets the allowed error of U at all radii looks.v[i .. end - 1]. If i is not 0, it is
    // increased by 1 as a margin, to at most `end`.
    template <class Allowed>
    static std::size_t start(const PolarPupil& pupil, const PolarStyle& style, const PolarKernels& kernels,
                             const PolarLooks& looks, const PolarOrders& orders, std::size_t end, const Allowed& allowed) {
        constexpr std::size_t block = PolarLooks::block;
        std::array<PolarRowError, block> rows;
        std::shared_ptr<const PolarCircle> here;
        std::size_t needed = 0;
        for (std::size_t i = end; i-- > 0;) {
            const double most = allowed(looks.brightest(looks.v[i], looks.v[i]));
            if (!here || i % block == block - 1) {
                needed = orders.least(PolarBudget::orders * most, looks.v[i], kernels.growth);
                here = circle(needed, style.around);
                looks.rows(i / block, kernels, *here, rows.data());
            }
            PolarRowError& row = rows[i % block];
            for (std::size_t d = 0; d < pupil.disks.size(); ++d) {
                const PolarKernel& kernel = *kernels.disks[d];
                // v: radius for this disk; nodes: estimated number of nodes of the quadrature that computes its table.
                const double v = pupil.disks[d].shrunk * looks.v[i],
                             nodes = v + static_cast<double>(pupil.disks[d].series->degrees) + 40.0;
                row.sums += polar_rounding(pupil.disks[d], style, kernel, PolarTable::rounding(kernel.shares, nodes, v));
            }
            if (polar_error(pupil, style, kernels, *here, needed, PolarBudget::orders * most, looks.v[i], row) >
                PolarBudget::promise * most) {
                return std::min(i + 2, end);
            }
        }
        return 0;
    }

    // Compute block i of the circles of a zone, and the error bounds of these circles.
    template <class Sum, class Fft, class Real>
    static void fill(const PolarPupil& pupil, const PolarTables& tables, PolarZone& zone, PolarRows<Real>& rows,
                     std::size_t i) {
        thread_local PolarSpectra<Fft> spectra;
        std::array<PolarRowError, PolarTable::block> errors;
        const std::size_t first = i * PolarTable::block;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            rows.template fill<Sum>(isa, *zone.circle, tables.disks, zone.first + i, zone.orders, first, spectra,
                                    errors.data());
        });
        const double row = static_cast<double>((zone.first + i) * PolarTable::block) - static_cast<double>(PolarTable::before);
        for (std::size_t k = 0; k < PolarTable::block; ++k) {
            errors[k].sums = tables.errors[zone.first + i];
            zone.errors[first + k] = polar_error(pupil, *zone.style, *zone.kernels, *zone.circle, zone.orders, zone.left,
                                                 zone.style->step() * (row + static_cast<double>(k)), errors[k]);
        }
    }

    std::vector<PolarZone> zones_;  // memory reused from image to image
    std::size_t count_ = 0;
};

}  // namespace lommel
