// An image of any wavefront by interpolation between circles, certified ring by ring.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/pixels/tiles.hpp"
#include "lommel/zernike/field.hpp"
#include "lommel/zernike/polar_rows.hpp"

#ifndef POLAR_TIMER
#define POLAR_TIMER(name)
#define POLAR_ZONE(a, b, c)
#endif

namespace lommel {

// How a range of distances is interpolated: circles pi / oversampling apart, `points` angles on each.
struct PolarStyle {
    double oversampling;
    bool doubles;      // the pixels, in double precision
    bool exact;        // the circles
    std::size_t taps;  // between angles
};

// The circles of a range of distances.
struct PolarZone {
    PolarStyle style;
    double step;              // between circles
    std::int64_t low, high;   // squares of the distances of its pixels, in pixels
    std::size_t first, last;  // blocks of circles of the table
    std::shared_ptr<const PolarTable> tables[2];
    std::shared_ptr<const PolarCircle<double>> exact;
    std::shared_ptr<const PolarCircle<float>> single;
    PolarRows<double> doubles;
    PolarRows<float> floats;
    std::vector<double> errors;  // of U, for each block
    std::size_t orders, points;  // azimuthal, and angles of a circle
    double left;                 // what orders beyond can add to U
};

class PolarImage {
   public:
    PolarImage(const Tiles& tiles, double step, int threads) : tiles_(tiles), all_tiles_(tiles.all()), step_(step), threads_(threads) {}

    void prepare(const ZernikePhase& phase, const ZernikePhase& inner, double obscuration, double error, double tol,
                 double lost = 0.0) {
        const double reach = step_ * std::sqrt(static_cast<double>(tiles_.farthest()));
        reach_ = reach;
        {
            POLAR_TIMER(expand);
            field_.expand(phase, inner, obscuration, reach, error, lost);
        }
        {
            POLAR_TIMER(looks);
            interleave(field_.outer(), 1.0, outer_parts_);
            interleave(field_.inner(), -field_.obscuration() * field_.obscuration(), inner_parts_);
            look_around(reach);
        }
        measure_orders();
        all_ = 0.8 * tol * *std::max_element(bright_.begin(), bright_.end());
        { POLAR_TIMER(plan); plan(reach); }
        POLAR_TIMER(rows);
        for (std::size_t z = 0; z < zone_count_; ++z) {
            fill(zones_[z]);
        }
    }

    double peak() const { return brightest().top; }
    double error_at_peak() const { return brightest().error; }
    double wrong() const {
        double sum = 0.0;
        for (const Part& part : parts_) {
            sum = std::max(sum, part.wrong());
        }
        return sum;
    }

    template <class T>
    void paint(double scale, T* image) {
        POLAR_TIMER(paint);
        parts_.assign(all_tiles_.size() * zone_count_, Part());
        parallel_for(all_tiles_.size(), threads_, [&](std::size_t, std::size_t i) {
            thread_local Tiles::Buffer<T> buffer;
            thread_local std::vector<Tiles::Line> lines;
            const Tiles::Tile tile = all_tiles_[i];
            for (std::size_t z = 0; z < zone_count_; ++z) {
                const PolarZone& zone = zones_[z];
                lines.clear();
                tiles_.lines(tile, zone.low, zone.high, [&](const Tiles::Line& line) { lines.push_back(line); });
                if (lines.empty()) {
                    continue;
                }
                Part& part = parts_[i * zone_count_ + z];
                dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                    using I = decltype(isa);
                    if (zone.style.doubles) {
                        pixels<8, typename I::pack>(isa, zone, zone.doubles, *zone.exact, zone.tables[0]->doubles, tile, lines, scale, buffer, part);
                    } else if (zone.style.taps == 8) {
                        pixels<8, typename I::floats>(isa, zone, zone.floats, *zone.single, zone.tables[0]->singles, tile, lines, scale, buffer, part);
                    } else if (zone.style.taps == 6) {
                        pixels<6, typename I::floats>(isa, zone, zone.floats, *zone.single, zone.tables[0]->singles, tile, lines, scale, buffer, part);
                    } else {
                        pixels<4, typename I::floats>(isa, zone, zone.floats, *zone.single, zone.tables[0]->singles, tile, lines, scale, buffer, part);
                    }
                });
            }
            tiles_.copy(tile, buffer, image);
        });
    }

    struct Part {
        double error = 0.0, top = 0.0;
        double wrong() const { return error * (2.0 * std::sqrt(top) + error); }
    };
    const std::vector<Part>& parts() const { return parts_; }
    void describe() const { for (std::size_t z = 0; z < zone_count_; ++z) { const PolarZone& q = zones_[z]; double e=0; for(double x:q.errors) e=std::max(e,x); std::printf("   zone s%g d%d x%d w%zu v %.1f..%.1f orders %zu points %zu worst %.2e\n", q.style.oversampling, q.style.doubles, q.style.exact, q.style.taps, step_*std::sqrt(double(q.low)), step_*std::sqrt(double(q.high)), q.orders, q.points, e);} }

   private:
    static constexpr std::size_t w = 8, styles_count = 7;
    std::size_t looks = 0, orders_seen_ = 0;

    // How bright it is at some distances, and how large the orders are there.
    void look_around(double reach) {
        const std::size_t blocks = LookTable::blocks_to(reach), n = RowFft<float>::length(4 * std::max(field_.outer().orders, field_.inner().orders));
        std::shared_ptr<const LookTable> tables[2];
        PolarDisk disks[2];
        const std::size_t count = field_.obscured() ? 2 : 1;
        for (std::size_t d = 0; d < count; ++d) {
            const ZernikeSeries& series = d == 0 ? field_.outer() : field_.inner();
            tables[d] = cache<LookTable>.get(d == 0 ? 1.0 : field_.obscuration(), blocks, series.degrees);
            disks[d] = {&series, (d == 0 ? outer_parts_ : inner_parts_).data(), tables[d]->values.data(), tables[d]->degrees, tables[d]->reached.data()};
        }
        const std::size_t orders = std::min(n / 4, std::max(field_.outer().orders, field_.inner().orders));
        looks = blocks * LookTable::block;
        v_.resize(looks);
        bright_.assign(looks, 0.0);
        sizes_.resize(looks * orders);
        orders_seen_ = orders;
        const std::vector<double> gains(orders, 1.0);
        const RowFft<float> fft(n);
        thread_local PolarScratch<float> scratch;
        for (std::size_t b = 0; b < blocks; ++b) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                using I = decltype(isa);
                using V = typename I::pack;
                scratch.combine(isa, n, gains.data(), disks, count, b, orders, [&](std::size_t m, std::size_t p, V size) LOMMEL_INLINE_LAMBDA {
                    store(&sizes_[(b * orders + m) * LookTable::block + p * I::lanes], size);
                });
                for (std::size_t half = 0; half < 2; ++half) {
                    const float* from = fft.run(isa, scratch.spectrum[half].data(), scratch.other.data());
                    double* bright = &bright_[b * LookTable::block + half * fft_rows];
                    for (std::size_t q = 0; q < n / 4; ++q) {
                        const float *a = from + q * fft_element, *c = a + n / 4 * fft_element, *e = c + n / 4 * fft_element, *g = e + n / 4 * fft_element;
                        for (std::size_t i = 0; i < fft_rows; ++i) {
                            const float re = (a[i] + c[i]) + (e[i] + g[i]), im = (a[8 + i] + c[8 + i]) + (e[8 + i] + g[8 + i]);
                            const float re2 = (a[i] - c[i]) + (e[i] - g[i]), im2 = (a[8 + i] - c[8 + i]) + (e[8 + i] - g[8 + i]);
                            const double top = std::max(re * re + im * im, re2 * re2 + im2 * im2);
                            bright[i] = std::max(bright[i], top);
                        }
                    }
                }
            });
        }
        for (std::size_t i = 0; i < looks; ++i) {
            v_[i] = LookTable::at(i);
        }
        // Those beyond the window are only there to fill a block.
        while (looks > 2 && v_[looks - 2] > reach) {
            --looks;
        }
        bright_.resize(looks);
    }

    double allowed(double v) const {
        double seen = 0.0;
        for (std::size_t i = 0; i < looks; ++i) {
            if ((i + 1 == looks || v_[i + 1] >= v) && (i == 0 || v_[i - 1] <= v)) {
                seen = std::max(seen, bright_[i]);
            }
        }
        const double u = 1.2 * std::sqrt(seen);
        return all_ / (u + std::sqrt(u * u + all_));
    }

    // What a style promises at the looks of a block: its error of U, if the circles there have the orders that were seen.
    template <class Fft>
    void promise(const PolarStyle& style, const PolarTable& table, const PolarCircle<Fft>& circle, std::size_t block, double* out) const {
        constexpr std::size_t n = LookTable::block;
        double around[n] = {}, sum[n] = {};
        for (std::size_t m = 0; m < std::min(orders_seen_, circle.gains.size()); ++m) {
            const double* sizes = &sizes_[(block * orders_seen_ + m) * n];
            for (std::size_t i = 0; i < n; ++i) {
                around[i] += sizes[i] * circle.aliases[m];
                sum[i] += sizes[i] * circle.gains[m];
            }
        }
        const double transforms = sizeof(Fft) == 8 ? unit_roundoff : single_unit, pixels = style.doubles ? unit_roundoff : single_unit;
        for (std::size_t i = 0; i < n; ++i) {
            // What the table has divided by makes numbers larger, the most at the edge of the spectrum.
            const double bright = block * n + i < looks ? bright_[block * n + i] : 0.0;
            out[i] = field_.base() + table.aliasing + table.weight * table.largest * (around[i] + circle.weight * transforms * (circle.fft.rounding() + 2.0) * sum[i] +
                     2.0 * circle.weight * circle.gains[0] * std::sqrt(bright) * (34.0 * pixels + (style.doubles ? 1e-9 : 5e-7)));
        }
    }

    static const std::array<PolarStyle, 7>& all_styles() {
        static const std::array<PolarStyle, 7> styles = {{{4.0, true, true, 8},   {4.0, false, true, 8},  {2.0, false, true, 8}, {2.0, false, false, 8},
                                            {2.0, false, false, 6}, {1.5, false, false, 6}, {1.5, false, false, 4}}};
        return styles;
    }
    void plan(double reach) {
        const auto& styles = all_styles();
        constexpr double pi = 3.14159265358979323846;
        zone_count_ = 0;
        zones_.resize(styles_count);
        // Where each style begins to do.
        std::array<double, styles_count + 1> starts;
        for (std::size_t s = styles_count; s-- > 0;) {
            const PolarStyle& style = styles[s];
            const auto table = table_for(style, 1.0, reach);
            std::size_t i = looks, seen = 1 << 30;
            std::array<double, LookTable::block> errors;
            while (i > 0) {
                const double most = allowed(v_[i - 1]);
                if (const std::size_t block = (i - 1) / LookTable::block; block != seen) {
                    seen = block;
                    const std::size_t points = RowFft<double>::length(4 * orders_for(0.05 * most, v_[i - 1], table->aliasing));
                    if (style.exact) {
                        promise(style, *table, *cache<PolarCircle<double>>.get(points, style.taps), block, errors.data());
                    } else {
                        promise(style, *table, *cache<PolarCircle<float>>.get(points, style.taps), block, errors.data());
                    }
                }
                if (errors[(i - 1) % LookTable::block] > 0.9 * most) {
                    break;
                }
                --i;
            }
            starts[s] = s == 0 || i == 0 ? 0.0 : i == looks ? 1e300 : v_[i];
        }
        starts[styles_count] = 1e300;
        double from = 0.0;
        for (std::size_t s = 0; s < styles_count && from < reach; ++s) {
            const double ring = pi / styles[s].oversampling * PolarTable::block;
            double until = *std::min_element(starts.begin() + static_cast<std::ptrdiff_t>(s) + 1, starts.end());
            if (until <= from) {
                continue;
            }
            PolarZone& zone = zones_[zone_count_++];
            until = std::min(until, reach);
            zone.style = styles[s];
            zone.step = pi / styles[s].oversampling;
            zone.first = static_cast<std::size_t>(from / ring);
            zone.last = static_cast<std::size_t>(until / ring) + 3;
            zone.low = square(from);
            zone.high = until >= reach ? tiles_.farthest() + 1 : square(until);
            double most = 1e300;
            for (std::size_t i = 0; i < looks; ++i) {
                if ((i + 1 == looks || v_[i + 1] >= from) && (i == 0 || v_[i - 1] <= until)) {
                    most = std::min(most, allowed(v_[i]));
                }
            }
            const double aliasing = table_for(zone.style, 1.0, reach)->aliasing;
            zone.orders = orders_for(0.05 * most, from, aliasing);
            zone.points = RowFft<double>::length(4 * zone.orders);
            zone.left = order_tails_[zone.orders].at(from, aliasing);
            from = until;
        }
    }

    // How many orders there must be for the others to add no more than `error` to U.
    std::size_t orders_for(double error, double v, double aliasing) const {
        std::size_t m = order_tails_.size() - 1;
        while (m > 1 && order_tails_[m - 1].at(v, aliasing) <= error) {
            --m;
        }
        return m;
    }

    void measure_orders() {
        const std::size_t count = std::max(field_.outer().orders, field_.inner().orders);
        order_tails_.assign(count + 1, Tail());
        const auto add = [&](const ZernikeSeries& series, double weight, double stretch) {
            for (std::size_t m = 0; m < series.orders; ++m) {
                for (std::size_t j = 0; j < series.used[m]; ++j) {
                    const std::size_t at = series.start[m] + j;
                    const double size = std::hypot(series.cos_re[at], series.cos_im[at]) + std::hypot(series.sin_re[at], series.sin_im[at]);
                    order_tails_[m].near += weight * size / static_cast<double>(m + 2 * j + 1);
                    order_tails_[m].far += size * stretch;
                }
            }
        };
        const double eps = field_.obscuration();
        add(field_.outer(), 1.0, 1.0);
        add(field_.inner(), eps * eps, eps > 0.0 ? std::pow(eps, 2.0 / 3.0) : 0.0);
        for (std::size_t m = count; m-- > 0;) {
            order_tails_[m].near += order_tails_[m + 1].near;
            order_tails_[m].far += order_tails_[m + 1].far;
        }
    }

    std::shared_ptr<const PolarTable> table_for(const PolarStyle& style, double shrunk, double reach) const {
        constexpr double pi = 3.14159265358979323846;
        const double h = pi / style.oversampling;
        const std::size_t blocks = static_cast<std::size_t>(reach / (h * PolarTable::block)) + 3;
        return cache<PolarTable>.get(shrunk * h, w, GriddingKernel::of(w, style.oversampling).beta(), blocks,
                                     shrunk < 1.0 ? field_.inner().degrees : field_.outer().degrees);
    }

    // The least square of a distance in pixels that is v at least.
    std::int64_t square(double v) const { return static_cast<std::int64_t>(std::ceil(v * v / (step_ * step_))); }

    static void interleave(const ZernikeSeries& series, double weight, Doubles& parts) {
        const std::size_t count = series.orders == 0 ? 0 : series.cos_re.size();
        parts.resize(4 * count);
        for (std::size_t i = 0; i < count; ++i) {
            parts[4 * i] = weight * series.cos_re[i];
            parts[4 * i + 1] = weight * series.cos_im[i];
            parts[4 * i + 2] = weight * series.sin_re[i];
            parts[4 * i + 3] = weight * series.sin_im[i];
        }
    }

    const Part& brightest() const {
        return *std::max_element(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.top < b.top; });
    }

    void fill(PolarZone& zone) {
        PolarDisk disks[2];
        std::size_t count = 1;
        zone.tables[0] = table_for(zone.style, 1.0, reach_);
        disks[0] = {&field_.outer(), outer_parts_.data(), zone.tables[0]->values.data(), zone.tables[0]->degrees, zone.tables[0]->reached.data()};
        if (field_.obscured()) {
            zone.tables[1] = table_for(zone.style, field_.obscuration(), reach_);
            disks[1] = {&field_.inner(), inner_parts_.data(), zone.tables[1]->values.data(), zone.tables[1]->degrees, zone.tables[1]->reached.data()};
            count = 2;
        }
        zone.exact = cache<PolarCircle<double>>.get(zone.points, zone.style.taps);
        zone.single = cache<PolarCircle<float>>.get(zone.points, zone.style.taps);
        const std::size_t blocks = zone.last - zone.first;
        zone.errors.resize(blocks);
        if (zone.style.doubles) {
            zone.doubles.resize(*zone.exact, blocks * PolarTable::block);
        } else {
            zone.floats.resize(*zone.single, blocks * PolarTable::block);
        }
        parallel_for(blocks, threads_, [&](std::size_t, std::size_t i) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                PolarRowError e;
                if (zone.style.doubles) {
                    thread_local PolarScratch<double> scratch;
                    e = zone.doubles.fill(isa, *zone.exact, disks, count, zone.first + i, zone.orders, i * PolarTable::block, scratch);
                    zone.errors[i] = error(zone, zone.exact->taps, zone.tables[0]->doubles, *zone.exact, unit_roundoff, unit_roundoff, e);
                } else if (zone.style.exact) {
                    thread_local PolarScratch<double> scratch;
                    e = zone.floats.fill(isa, *zone.exact, disks, count, zone.first + i, zone.orders, i * PolarTable::block, scratch);
                    zone.errors[i] = error(zone, zone.single->taps, zone.tables[0]->singles, *zone.exact, unit_roundoff, single_unit, e);
                } else {
                    thread_local PolarScratch<float> scratch;
                    e = zone.floats.fill(isa, *zone.single, disks, count, zone.first + i, zone.orders, i * PolarTable::block, scratch);
                    zone.errors[i] = error(zone, zone.single->taps, zone.tables[0]->singles, *zone.single, single_unit, single_unit, e);
                }
            });
        });
    }

    static constexpr double single_unit = 5.97e-8;

    template <class Polynomials, class Circle>
    double error(const PolarZone& zone, const Polynomials& angular, const Polynomials& radial, const Circle& circle, double transforms,
                 double pixels, const PolarRowError& e) const {
        const PolarTable& table = *zone.tables[0];
        const double alias = table.aliasing, weights = table.weight * circle.weight;
        return field_.base() * (1.0 + alias) + alias + 1.01 * zone.left + table.weight * e.around + weights * transforms * (circle.fft.rounding() + 2.0) * e.sum +
               1.42 * (weights * pixels * 24.0 + 8.0 * (radial.error * circle.weight + angular.error * table.weight)) * e.largest;
    }

    // The taps of both kernels at eight at once.
    template <class V, class Real>
    static LOMMEL_INLINE void taps(const Taps<Real>& polynomials, Real x, Real* out) {
        constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
        const V at = splat<V>(x);
        for (std::size_t part = 0; part < 8; part += lanes) {
            V sum = load<V>(polynomials.at[0] + part);
            for (std::size_t k = 1; k < Taps<Real>::terms; ++k) {
                sum = sum * at + load<V>(polynomials.at[k] + part);
            }
            store(out + part, sum);
        }
    }

    template <std::size_t Across, class V, class I, class Real, class Circle, class T>
    LOMMEL_INLINE void pixels(I, const PolarZone& zone, const PolarRows<Real>& rows, const Circle& circle, const Taps<Real>& radial,
                              const Tiles::Tile& tile, const std::vector<Tiles::Line>& lines, double scale, Tiles::Buffer<T>& buffer,
                              Part& part) const {
        using Narrow = typename RowPack<I, Real>::type;
        using D = typename I::pack;
        constexpr std::size_t at_once = Tiles::side, numbers = PolarRows<Real>::directions, lanes = sizeof(V) / sizeof(Real),
                              packs = numbers / lanes;
        const double per_row = step_ / zone.step, per_angle = static_cast<double>(circle.fft.n) / 6.283185307179586477;
        // Places are those of the first taps.
        const double row_shift = static_cast<double>(PolarTable::before) - static_cast<double>(zone.first * PolarTable::block) - 0.5 * w;
        const double angle_shift = static_cast<double>(rows.margin()) - 0.5 * Across;
        const std::size_t stride = rows.stride();
        const V scales = splat<V>(static_cast<Real>(scale));
        Real tops[8] = {};
        std::int64_t nearest = 1 << 30, farthest = 0;
        for (const Tiles::Line& line : lines) {
            look();
            const std::size_t here = static_cast<std::size_t>(line.count);
            alignas(64) double x[2][at_once];
            alignas(64) std::int64_t place[2][at_once];
            alignas(64) Real weights[at_once][16], squares[at_once][numbers];
            for (std::size_t i = 0; i < here; i += I::lanes) {
                alignas(64) double b[I::lanes];
                for (std::size_t k = 0; k < I::lanes; ++k) {
                    b[k] = static_cast<double>(line.b + static_cast<std::int64_t>(std::min(i + k, here - 1)));
                }
                const D across = splat<D>(static_cast<double>(line.a)), along = load<D>(b), square = across * across + along * along;
                alignas(64) double root[I::lanes];
                store(root, square);
                for (double& r : root) {
                    r = std::sqrt(r);
                }
                split<I>(load<D>(root) * splat<D>(per_row) + splat<D>(row_shift), x[0] + i, place[0] + i);
                split<I>(angle(across, along) * splat<D>(per_angle) + splat<D>(angle_shift), x[1] + i, place[1] + i);
            }
            nearest = std::min(nearest, place[0][0]);
            farthest = std::max(farthest, place[0][here - 1]);
            for (std::size_t i = 0; i < here; ++i) {
                taps<Narrow>(radial, static_cast<Real>(x[0][i]), weights[i]);
                taps<Narrow>(circle.taps, static_cast<Real>(x[1][i]), weights[i] + 8);
            }
            for (std::size_t i = 0; i < here; ++i) {
                const Real* start = rows.row(static_cast<std::size_t>(place[0][i])) + static_cast<std::size_t>(place[1][i]) * numbers;
                constexpr std::size_t together = packs == 1 ? 8 : packs == 2 ? 4 : 2;
                V total[packs] = {};
                for (std::size_t j = 0; j < w; j += together) {
                    V sum[together][packs];
                    for (std::size_t l = 0; l < Across; ++l) {
                        const V weight = splat<V>(weights[i][8 + l]);
                        for (std::size_t k = 0; k < together; ++k) {
                            const Real* at = start + (j + k) * stride + l * numbers;
                            for (std::size_t p = 0; p < packs; ++p) {
                                const V value = weight * load<V>(at + p * lanes);
                                sum[k][p] = l == 0 ? value : sum[k][p] + value;
                            }
                        }
                    }
                    for (std::size_t k = 0; k < together; ++k) {
                        const V weight = splat<V>(weights[i][j + k]);
                        for (std::size_t p = 0; p < packs; ++p) {
                            total[p] = j + k == 0 ? weight * sum[k][p] : total[p] + weight * sum[k][p];
                        }
                    }
                }
                for (std::size_t p = 0; p < packs; ++p) {
                    store(&squares[i][p * lanes], scales * (total[p] * total[p]));
                }
            }
            for (std::size_t i = 0; i < here; ++i) {
                alignas(32) Real values[8];
                for (std::size_t k = 0; k < 4; ++k) {
                    values[k] = squares[i][k] + squares[i][4 + k];
                    values[4 + k] = squares[i][8 + k] + squares[i][12 + k];
                }
                for (std::size_t k = 0; k < 8; ++k) {
                    tops[k] = values[k] > tops[k] ? values[k] : tops[k];
                }
                buffer.put(tile, line.a, line.b + static_cast<std::int64_t>(i), values);
            }
        }
        for (const Real top : tops) {
            part.top = std::max(part.top, static_cast<double>(top) / scale);
        }
        for (std::size_t block = static_cast<std::size_t>(nearest) / PolarTable::block; block <= (static_cast<std::size_t>(farthest) + w - 1) / PolarTable::block; ++block) {
            part.error = std::max(part.error, zone.errors[block]);
        }
    }

    // Whole steps below x, and 2 t - 1 of the rest t, 0 to 1; the next whole step is the place.
    template <class I>
    static LOMMEL_INLINE void split(typename I::pack x, double* rest, std::int64_t* place) {
        using D = typename I::pack;
        // As in sincos(): the nearest integer to x - 1/2 stands in the lowest bits.
        const D magic = splat<D>(6755399441055744.0), shifted = (x + splat<D>(0.5)) + magic, next = shifted - magic;
        store(rest, (x - next) * splat<D>(2.0) + splat<D>(1.0));
        typename I::bits bits;
        std::memcpy(&bits, &shifted, sizeof bits);
        // Less those of the magic number.
        std::memcpy(place, &bits, sizeof bits);
        for (std::size_t i = 0; i < I::lanes; ++i) {
            place[i] -= 0x4338000000000000;
        }
    }

    // atan(b/a) for 0 <= b <= a: pi/8 and that of x = (b - t_0 a) / (a + t_0 b), |x| <= t_0 = tan(pi/8).
    template <class D>
    static LOMMEL_INLINE D angle(D a, D b) {
        constexpr double middle = 0.41421356237309504880, eighth = 0.39269908169872415481;
        const D tiny = splat<D>(1e-150), x = (b - splat<D>(middle) * a) / (a + splat<D>(middle) * b + tiny), z = x * x;
        D sum = splat<D>(1.0 / 37.0);
        for (int k = 17; k >= 0; --k) {
            sum = splat<D>(1.0 / (2 * k + 1)) - sum * z;
        }
        return splat<D>(eighth) + x * sum;
    }

   private:
    Tiles tiles_;
    std::vector<Tiles::Tile> all_tiles_;
    double step_ = 1.0, all_ = 0.0, reach_ = 0.0;
    int threads_ = 1;
    ZernikeField field_;
    Doubles outer_parts_, inner_parts_;
    std::vector<double> v_, bright_;
    Doubles sizes_;  // of orders, at each look
    struct Tail {
        double near = 0.0, far = 0.0;
        double at(double v, double aliasing) const { return v > 0.0 ? std::min(near, far * 1.572 / (v * std::cbrt(v)) + aliasing * near) : near; }
    };
    std::vector<Tail> order_tails_;
    std::vector<PolarZone> zones_;
    std::size_t zone_count_ = 0;
    std::vector<Part> parts_;
};

}  // namespace lommel
