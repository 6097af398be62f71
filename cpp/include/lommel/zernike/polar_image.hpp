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
};

class PolarImage {
   public:
    PolarImage(const Tiles& tiles, double step, int threads) : tiles_(tiles), all_tiles_(tiles.all()), step_(step), threads_(threads) {}

    void prepare(const ZernikePhase& phase, const ZernikePhase& inner, double obscuration, double error, double tol,
                 double lost = 0.0) {
        const double reach = step_ * std::sqrt(static_cast<double>(tiles_.farthest()));
        {
            POLAR_TIMER(expand);
            field_.expand(phase, inner, obscuration, reach, error, lost);
        }
        {
            POLAR_TIMER(looks);
            for (std::size_t i = 0; i < looks; ++i) {
                const double x = (static_cast<double>(i) + 0.5) / looks;
                v_[i] = reach * x * std::sqrt(x);
                bright_[i] = field_.look(v_[i]);
            }
        }
        all_ = 0.5 * tol * *std::max_element(bright_.begin(), bright_.end());
        interleave(field_.outer(), outer_parts_);
        interleave(field_.inner(), inner_parts_);
        plan(reach);
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

   private:
    static constexpr std::size_t looks = 32, w = 8;

    double allowed(double v) const {
        double seen = 0.0;
        for (std::size_t i = 0; i < looks; ++i) {
            if ((i + 1 == looks || v_[i + 1] >= v) && (i == 0 || v_[i - 1] <= v)) {
                seen = std::max(seen, bright_[i]);
            }
        }
        const double u = 2.0 * std::sqrt(seen);
        return all_ / (u + std::sqrt(u * u + all_));
    }

    void plan(double reach) {
        static const PolarStyle styles[] = {{4.0, true, true, 8}, {4.0, false, false, 8}, {2.0, false, false, 8}, {1.5, false, false, 6}, {1.5, false, false, 4}};
        zone_count_ = 0;
        zones_.resize(5);
        constexpr double pi = 3.14159265358979323846;
        const double starts[] = {0.0, limits[0], limits[1], limits[2], limits[3]};
        double from = 0.0;
        for (std::size_t i = 0; i < 5; ++i) {
            const double h = pi / styles[i].oversampling, ring = h * PolarTable::block;
            const std::size_t first = static_cast<std::size_t>(std::ceil(from / ring - 1e-9));
            double until = i + 1 < 5 ? std::min(starts[i + 1], reach) : reach;
            // The next zone begins at a circle of its own.
            if (i + 1 < 5 && until < reach) {
                const double next = pi / styles[i + 1].oversampling * PolarTable::block;
                until = std::ceil(until / next) * next;
            }
            const std::size_t last = static_cast<std::size_t>(std::ceil(until / ring - 1e-9)) + (until >= reach ? 1 : 0);
            if (last > first && from <= reach) {
                PolarZone& zone = zones_[zone_count_++];
                zone.style = styles[i];
                zone.step = h;
                zone.first = first;
                zone.last = last + 2;
                zone.low = square(from);
                zone.high = until >= reach ? tiles_.farthest() + 1 : square(until);
                from = until;
            }
        }
    }

    // The least square of a distance in pixels that is v at least.
    std::int64_t square(double v) const { return static_cast<std::int64_t>(std::ceil(v * v / (step_ * step_))); }

    static void interleave(const ZernikeSeries& series, Doubles& parts) {
        const std::size_t count = series.orders == 0 ? 0 : series.cos_re.size();
        parts.resize(4 * count);
        for (std::size_t i = 0; i < count; ++i) {
            parts[4 * i] = series.cos_re[i];
            parts[4 * i + 1] = series.cos_im[i];
            parts[4 * i + 2] = series.sin_re[i];
            parts[4 * i + 3] = series.sin_im[i];
        }
    }

    const Part& brightest() const {
        return *std::max_element(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.top < b.top; });
    }

    void fill(PolarZone& zone) {
        const double h = zone.step;
        const GriddingKernel kernel = GriddingKernel::of(w, zone.style.oversampling);
        PolarDisk disks[2];
        std::size_t count = 1;
        zone.tables[0] = cache<PolarTable>.get(h, w, kernel.beta(), zone.last, field_.outer().degrees);
        disks[0] = {zone.tables[0], &field_.outer(), outer_parts_.data(), 1.0};
        if (field_.obscured()) {
            zone.tables[1] = cache<PolarTable>.get(field_.obscuration() * h, w, kernel.beta(), zone.last, field_.inner().degrees);
            disks[1] = {zone.tables[1], &field_.inner(), inner_parts_.data(), 1.0};
            count = 2;
        }
        zone.exact = cache<PolarCircle<double>>.get(points, zone.style.taps);
        zone.single = cache<PolarCircle<float>>.get(points, zone.style.taps);
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
                    thread_local PolarRows<double>::Scratch<double> scratch;
                    e = zone.doubles.fill(isa, *zone.exact, disks, count, zone.first + i, orders_, i * PolarTable::block, scratch);
                    zone.errors[i] = error(zone, zone.exact->taps, zone.tables[0]->doubles, *zone.exact, unit_roundoff, unit_roundoff, e);
                } else if (zone.style.exact) {
                    thread_local PolarRows<float>::Scratch<double> scratch;
                    e = zone.floats.fill(isa, *zone.exact, disks, count, zone.first + i, orders_, i * PolarTable::block, scratch);
                    zone.errors[i] = error(zone, zone.single->taps, zone.tables[0]->singles, *zone.exact, unit_roundoff, single_unit, e);
                } else {
                    thread_local PolarRows<float>::Scratch<float> scratch;
                    e = zone.floats.fill(isa, *zone.single, disks, count, zone.first + i, orders_, i * PolarTable::block, scratch);
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
        return field_.base() * (1.0 + alias) + alias + table.weight * e.around + weights * transforms * (circle.fft.rounding() + 2.0) * e.sum +
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

   public:
    double limits[4] = {80.0, 130.0, 200.0, 300.0};
    std::size_t points = 384, orders_ = 98;

   private:
    Tiles tiles_;
    std::vector<Tiles::Tile> all_tiles_;
    double step_ = 1.0, all_ = 0.0;
    int threads_ = 1;
    ZernikeField field_;
    Doubles outer_parts_, inner_parts_;
    std::array<double, looks> v_, bright_;
    std::vector<PolarZone> zones_;
    std::size_t zone_count_ = 0;
    std::vector<Part> parts_;
};

}  // namespace lommel
