// Position of each pixel of a row: the part that contains its distance from the axis, and the position in this part. Parts divide
// the pieces (intervals of the distance) of sample_pieces.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/pixels/window.hpp"

namespace lommel {

// The pixels of a window to compute: all or, if the axis is at a pixel centre or midway between two pixels, one quadrant, with
// a row and a column for each distinct distance from the axis.
class FoldedWindow {
   public:
    explicit FoldedWindow(const PixelWindow& w) : part(w), folds_(w.folds()) {
        if (folds_) {
            rows_ = w.rows();
            columns_ = w.columns();
            part.height = rows_.distances();
            part.width = columns_.distances();
            part.center_y = -0.5 * static_cast<double>(rows_.between());
            part.center_x = -0.5 * static_cast<double>(columns_.between());
        }
    }

    PixelWindow part;

    bool folds() const { return folds_; }

    // Copy a row of the quadrant to all its mirror images in the image.
    template <class T>
    LOMMEL_NOINLINE void unfold(std::size_t row, const T* values, T* image) const {
        T* const line = image + rows_.first(row) * columns_.count;
        std::memcpy(line + columns_.high, values, (columns_.count - columns_.high) * sizeof(T));
        for (std::size_t i = columns_.high - columns_.low == 0 ? 1 : 0; i <= columns_.low; ++i) {
            *(line + columns_.low - i) = values[i];
        }
        if (rows_.twice(row)) {
            std::memcpy(image + (rows_.high + row) * columns_.count, line, columns_.count * sizeof(T));
        }
    }

   private:
    bool folds_;
    FoldedSide rows_{1}, columns_{1};
};

// Positions of a window's pixels. Distances from the axis are divided into intervals (pieces), and these into parts; a pixel's
// position is its distance, counted in parts from the middle of the innermost part. Zones are ranges of the distance. In zone 0 the
// position is linear in the distance; in each zone farther out, to avoid square roots, it is linear in the squared distance, and
// the zone ends at twice the distance at which it begins.
class SampleRows {
   public:
    // begin: squared distance at which the zone begins, in (piece width)^2. Position = slope * d + shift, with d the squared
    // distance or, in zone 0, the distance.
    struct Zone {
        double begin, slope, shift;
    };
    using Zones = std::array<Zone, 40>;  // enough zones for the largest distance allowed; unused ones begin at infinity

    static constexpr std::size_t longest = 128;  // largest number of pixels in a run
    static constexpr std::size_t most_lanes = 16;

    // Run: `count` adjacent pixels of a row, from column `start` on. base + at[i]: index of the part that contains pixel i, times
    // the number of coefficients per part; x[i]: position in this part, from -1/2 to 1/2. Both arrays are padded to whole
    // vectors, with valid entries. straight: parts have two coefficients, those of a line.
    template <class Real>
    struct Run {
        std::size_t row, start, count;
        bool straight;
        std::ptrdiff_t base;
        const std::int32_t* at;
        const Real* x;
    };

    SampleRows(const PixelWindow& window, double width, const Zones& zones)
        : window_(window), pieces_(window.step / width), zones_(zones) {}

    // Compute single-precision positions by integer arithmetic, if the error of the distance is then below about `room` optical
    // units; returns the largest error of a position, which is in parts (0: integers are not used).
    double by_integers(double room) {
        const double most = room * pieces_ * zones_[0].slope / window_.step;
        for (tile_ = longest; tile_ >= 32; tile_ /= 2) {
            const double error = place_error();
            if (error < most) {
                integers_ = true;
                return error;
            }
        }
        tile_ = longest;
        return 0.0;
    }
    // Mark single-precision runs as straight if all their pixels are at least `pieces` piece widths from the axis; returns an upper
    // bound on the distance of the pixels in all other runs, in piece widths.
    double straight_from(double pieces) {
        straight_ = pieces * pieces;
        return pieces + static_cast<double>(tile_) * pieces_;
    }

    // Call take(run) for all runs of rows [begin, end). Apart: number of coefficients per part; in straight runs there are 2.
    template <class Real, std::uint32_t Apart, class Take>
    LOMMEL_INLINE void each(std::size_t begin, std::size_t end, const Take& take) const {
        constexpr std::size_t block = most_lanes;
        alignas(64) std::int32_t at[longest];
        alignas(64) double squares[longest], place[longest];
        alignas(64) Real x[longest];
        Lines lines;
        Glance glance;
        // Compute all rows of a block of columns before the next block: each row then finds most coefficients in the cache.
        for (std::size_t start = 0; start < window_.width; start += tile_) {
            const std::size_t here = std::min(tile_, window_.width - start), padded = (here + block - 1) / block * block;
            for (std::size_t i = 0; i < padded; ++i) {
                squares[i] = squared(static_cast<double>(start + std::min(i, here - 1)) - window_.center_x);
            }
            const double least = *std::min_element(squares, squares + here), most = *std::max_element(squares, squares + here);
            std::size_t prepared = 0;
            Row ahead = seen(begin, least, most, {});
            for (std::size_t row = begin; row < end; ++row) {
                glance(4 * padded);
                // Compute the scalars of the next row here, so that this overlaps with computing the pixels of this row.
                const Row seen_here = ahead;
                ahead = seen(std::min(row + 1, end - 1), least, most, ahead);
                const auto [square, low, high, first, other, straight] = seen_here;
                const Zone &zone = zones_[low], &next = zones_[low + 1];
                const std::uint32_t stride = straight ? 2 : Apart;
                const auto split = [&, stride = stride](std::size_t i, double where) LOMMEL_INLINE_LAMBDA {
                    const double whole = (where + 0x1.8p52) - 0x1.8p52;  // rounds to the nearest integer
                    at[i] = static_cast<std::int32_t>(stride) * static_cast<std::int32_t>(whole);
                    x[i] = static_cast<Real>(where - whole);
                };
                Run<Real> run{row, start, here, straight, 0, at, x};
                if constexpr (std::is_same_v<Real, float>) {
                    if (integers_ && low > 0 && high <= low + 1) {
                        if (prepared != low) {
                            lines.prepare(squares, padded, least, most, zone.slope, next.slope);
                            prepared = low;
                        }
                        run.base = high == low ? lines.template split<false>(padded, first, other, stride, at, x)
                                               : lines.template split<true>(padded, first, other, stride, at, x);
                        take(run);
                        continue;
                    }
                }
                const double shift = square * zone.slope + zone.shift, other_shift = square * next.slope + next.shift;
                if (std::is_same_v<Real, double> && low > 0 && high <= low + 1) {
                    for (std::size_t i = 0; i < padded; ++i) {
                        const double here = squares[i] * zone.slope + shift, there = squares[i] * next.slope + other_shift;
                        split(i, there < here ? there : here);
                    }
                } else {
                    for (std::size_t i = 0; low > 0 && i < padded; ++i) {
                        place[i] = squares[i] * zone.slope + shift;
                    }
                    for (std::size_t i = 0; low == 0 && i < padded; ++i) {
                        const double s = squares[i] + square, inner = s < next.begin ? s : next.begin;
                        place[i] = std::sqrt(inner) * zone.slope + (s - inner) * next.slope + zone.shift;
                    }
                    for (std::size_t further = std::max<std::size_t>(low + 1, 2); further <= high; ++further) {
                        const Zone one = zones_[further];
                        for (std::size_t i = 0; i < padded; ++i) {
                            const double other = (squares[i] + square) * one.slope + one.shift;
                            place[i] = other < place[i] ? other : place[i];
                        }
                    }
                    for (std::size_t i = 0; i < padded; ++i) {
                        split(i, place[i]);
                    }
                }
                take(run);
            }
        }
    }

   private:
    // square: squared distance of a row from the axis; low, high: zones (ranges of the distance) of the row's nearest and farthest
    // pixels; straight: see Run. first, other: positions of the nearest pixel by the formulas of zone `low` and of the next zone.
    // The smaller one is right, because the formulas of all zones together are a concave function of the squared distance.
    struct Row {
        double square = 0.0;
        std::size_t low = 0, high = 0;
        double first = 0.0, other = 0.0;
        bool straight = false;
    };
    LOMMEL_INLINE Row seen(std::size_t row, double least, double most, Row before) const {
        Row r = before;
        r.square = squared(static_cast<double>(row) - window_.center_y);
        zone_of(least + r.square, r.low);
        zone_of(most + r.square, r.high);
        const Zone &zone = zones_[r.low], &next = zones_[r.low + 1];
        r.first = zone.slope * (least + r.square) + zone.shift;
        r.other = next.slope * (least + r.square) + next.shift;
        r.straight = least + r.square >= straight_;
        return r;
    }

    // Contributions of a block of columns to the pixels' positions (see SampleRows), in fixed point: here[i] = d * (slope of the
    // row's zone), next[i] = d * (slope of the next zone). d: squared distance of column i from the axis less the smallest one in
    // the block.
    struct Lines {
        alignas(64) std::uint32_t here[longest], next[longest];
        double span = 0.0, unit = 1.0;
        float scale = 1.0f;
        int bits = 0;  // number of fraction bits of fixed-point positions

        LOMMEL_INLINE void prepare(const double* squares, std::size_t padded, double least, double most, double slope,
                                   double other_slope) {
            span = (most - least) * slope;
            bits = fraction_bits(span);
            unit = std::ldexp(1.0, bits);
            scale = static_cast<float>(1.0 / unit);
            for (std::size_t i = 0; i < padded; ++i) {
                here[i] = whole((squares[i] - least) * slope * unit);
                next[i] = whole((squares[i] - least) * other_slope * unit);
            }
        }

        // Split the position of each pixel, counted in parts of pieces, into the index of its part, times `stride`, and the
        // position in this part; return Run::base. first, other: position of the nearest pixel by the formula of the row's zone
        // and, used if `Both`, by that of the next zone.
        template <bool Both>
        LOMMEL_INLINE std::ptrdiff_t split(std::size_t padded, double first, double other, std::uint32_t stride,
                                           std::int32_t* at, float* x) const {
            const double base = std::floor(first) - 1.0;
            const std::uint32_t from = whole((first - base + 0.5) * unit);
            const std::uint32_t or_from = whole((std::min(other, first + span) - base + 0.5) * unit);
            const std::uint32_t part = ~(stride - 1), behind = (std::uint32_t{1} << bits) - 1;
            const int down = stride == 2 ? bits - 1 : bits - 2;
            for (std::size_t i = 0; i < padded; ++i) {
                const std::uint32_t one = here[i] + from, two = Both ? next[i] + or_from : one, where = two < one ? two : one;
                at[i] = static_cast<std::int32_t>((where >> down) & part);
                x[i] = static_cast<float>(static_cast<std::int32_t>(where & behind)) * scale - 0.5f;
            }
            return static_cast<std::ptrdiff_t>(stride) * static_cast<std::ptrdiff_t>(base);
        }
        static LOMMEL_INLINE std::uint32_t whole(double x) { return static_cast<std::uint32_t>(x + 0.5); }
    };
    // Number of fraction bits for which positions up to 1.5 span + 4 fit into 32 bits, and fractions into single precision.
    static int fraction_bits(double span) { return 31 - std::max(7, std::ilogb(1.5 * span + 4.0)); }

    LOMMEL_INLINE double squared(double pixels) const { return pieces_ * pixels * (pieces_ * pixels); }
    LOMMEL_INLINE void zone_of(double square, std::size_t& zone) const {
        while (square < zones_[zone].begin) {
            --zone;
        }
        while (square >= zones_[zone + 1].begin) {
            ++zone;
        }
    }
    double place_error() const {
        double ends[2];
        PixelWindow line = window_;
        line.width = 1;
        line.center_x = 0.0;
        line.reach(ends);
        const double near = squared(ends[0]), far = squared(ends[1]);
        double error = 0.0;
        for (std::size_t start = 0; start < window_.width; start += tile_) {
            PixelWindow columns = window_;
            columns.height = 1;
            columns.center_y = 0.0;
            columns.width = std::min(tile_, window_.width - start);
            columns.center_x -= static_cast<double>(start);
            columns.reach(ends);
            const double least = squared(ends[0]), most = squared(ends[1]);
            for (std::size_t z = 1; zones_[z].begin <= far + most; ++z) {
                const double end = z + 2 < zones_.size() ? zones_[z + 2].begin : HUGE_VAL;
                if (most + near < end && most - least <= end - zones_[z].begin) {
                    error = std::max(error, std::ldexp(1.0, -fraction_bits((most - least) * zones_[z].slope)));
                }
            }
        }
        return error;
    }

    PixelWindow window_;
    double pieces_;  // pixel pitch / width of a piece of the distance
    Zones zones_;
    std::size_t tile_ = longest;
    bool integers_ = false;
    double straight_ = HUGE_VAL;  // smallest squared distance of straight runs from the axis, in (piece width)^2
};

}  // namespace lommel
