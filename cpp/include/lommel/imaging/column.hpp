// Blur of the points of one image column by PSF windows, and the transposed operator, with or without occlusion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/mixture.hpp"

namespace lommel {

template <class I, class T>
using Packed = std::conditional_t<sizeof(T) == 4, typename I::floats, typename I::pack>;

// Instruction set with vectors half as long as those of I, at least two lanes.
template <class I>
using Half = Isa<std::max<std::size_t>(2, I::lanes / 2), I::unroll>;

// PSF windows of one point or of two vertically adjacent points. Each is a mixture of four windows of a bank; all are read row by
// row for one vector of columns, the first of which is `from`. If `Alike`, both points mix the same four windows, which are loaded
// once. Windows are zero beyond their half width, so the larger half width serves both points.
template <class Vec, class T, std::size_t Points, bool Alike>
struct Rows {
    using V = Vec;
    static constexpr std::size_t points = Points, lanes = sizeof(V) / sizeof(T);
    const T* windows[Points];
    std::size_t stride, room, half, from;
    V weight[Points][4];

    LOMMEL_INLINE Rows(const WindowBank<T>& bank, const Mixture<T>* pixels, std::size_t widest, std::size_t column)
        : stride(bank.stride), room(bank.room()), half(widest), from(column) {
        for (std::size_t p = 0; p < Points; ++p) {
            windows[p] = bank.windows + pixels[p].first * room + from;
            for (std::size_t j = 0; j < 4; ++j) {
                weight[p][j] = splat<V>(pixels[p].weights[j]);
            }
        }
    }

    // Load a row of window j, one of the four (0 .. 3) that a point mixes, into values[point].
    LOMMEL_INLINE void window(std::size_t j, std::size_t row, V* values) const {
        for (std::size_t p = 0; p < Points; ++p) {
            if (p > 0 && Alike) {
                values[p] = values[0] = loaded(values[0]);
            } else {
                values[p] = load<V>(windows[p] + j * room + row * stride);
            }
        }
    }

    LOMMEL_INLINE void mix(std::size_t row, V* mixed) const {
        V values[Points];
        for (std::size_t j = 0; j < 4; ++j) {
            window(j, row, values);
            for (std::size_t p = 0; p < Points; ++p) {
                const V part = weight[p][j] * values[p];
                mixed[p] = j > 0 ? mixed[p] + part : part;
            }
        }
    }
};

// For the windows of one or two points, call visit(Rows) for each vector of columns from 0, the middle, outwards to `half`.
template <class I, std::size_t Points, bool Alike, class T, class Visit>
LOMMEL_INLINE void each_block(const WindowBank<T>& bank, const Mixture<T>* points, std::size_t half, const Visit& visit) {
    using Whole = Rows<Packed<I, T>, T, Points, Alike>;
    using Narrow = Rows<Packed<Half<I>, T>, T, Points, Alike>;
    for (std::size_t from = 0; from <= half; from += Whole::lanes) {
        if (half < from + Narrow::lanes) {
            visit(Narrow(bank, points, half, from));
        } else {
            visit(Whole(bank, points, half, from));
        }
    }
}

// Points first .. last - 1 of a column of a tile. at: index of the column's point 0 in the image; point: index of point 0 among
// all points; half: largest half width of the points' windows (pixels); hidden: some points are partly occluded.
struct Column {
    std::ptrdiff_t at;
    std::size_t point, first, last, half;
    bool hidden;
};

// Accumulators ("sheets") for the windows of one column of points, [row][column]. Row `widest` (largest half width) is that of the
// first point; columns count outwards from the points. Windows are symmetric, so without occlusion one sheet serves both sides of
// the points. Sums at the same cache-aligned addresses for every column take half the time of sums in the image. One spare row
// serves the last of an odd number of points, which is paired with an empty point.
template <class I, class T>
class Sheets {
   public:
    using V = Packed<I, T>;
    Sheets(const WindowBank<T>& bank, std::size_t height, std::size_t across, bool screened)
        : widest_(bank.widest), stride_(bank.stride), across_(static_cast<std::ptrdiff_t>(across)),
          size_((height + 1 + 2 * widest_) * stride_), values_(size_ * (screened ? 3 : 1)), sums_((height + 1) * lanes) {}

    static constexpr std::size_t lanes = sizeof(V) / sizeof(T);
    T* both() { return values_.data(); }
    T* right() { return values_.data() + size_; }
    T* left() { return values_.data() + 2 * size_; }
    T* sums(std::size_t point) { return sums_.data() + point * lanes; }  // partial sums [lane] of a point; 0 after each column

    // Offset in a sheet. row: counted downwards from the column's first point; from: column, counted outwards from the points.
    LOMMEL_INLINE std::size_t place(std::ptrdiff_t row, std::size_t from) const {
        return (widest_ + static_cast<std::size_t>(row)) * stride_ + from;
    }

    // Mask of a vector of columns: loaded from index 0, it excludes the middle column; loaded from index 1, it excludes none.
    static constexpr T first_apart[] = {0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    static_assert(lanes < std::size(first_apart), "one more for vectors of ones");

    // Call f(place, right, left, middle_mask) for all vectors of pixels that the points reach. place: offset in a sheet; right,
    // left: offsets in the image on either side; middle_mask: 0 at the middle column, which would otherwise count twice. Narrow
    // vectors are used where they suffice, as vectors across two cache lines are slow.
    template <class F>
    LOMMEL_INLINE void each(const Column& column, const F& f) const {
        using Narrow = Packed<Half<I>, T>;
        if (column.half < sizeof(Narrow) / sizeof(T)) {
            down<Narrow>(column, 0, f);
            return;
        }
        for (std::size_t from = 0; from <= column.half; from += lanes) {
            down<V>(column, from, f);
        }
    }

    template <class W, class F>
    LOMMEL_INLINE void down(const Column& column, std::size_t from, const F& f) const {
        const W middle_mask = load<W>(first_apart + (from > 0 ? 1 : 0));
        const std::ptrdiff_t away = static_cast<std::ptrdiff_t>(from);
        const std::ptrdiff_t last = away + static_cast<std::ptrdiff_t>(sizeof(W) / sizeof(T)) - 1;
        const std::ptrdiff_t beyond = static_cast<std::ptrdiff_t>(column.half);
        const std::ptrdiff_t end = static_cast<std::ptrdiff_t>(column.last) + beyond;
        for (std::ptrdiff_t row = static_cast<std::ptrdiff_t>(column.first) - beyond; row < end; ++row) {
            const std::ptrdiff_t middle = column.at + row * across_;
            f(place(row, from), middle + away, middle - last, middle_mask);
        }
    }

    // Permutation that reverses lanes: pixels left of the points then run outwards, like those on the right.
    struct Mirror {
        static constexpr std::size_t at(std::size_t i, std::size_t lanes) { return lanes - 1 - i; }
    };

    // Call f(place, right, left) for all vectors of pixels that the windows of the points reach. place: offset in a sheet; right,
    // left: fraction of the layer that each pixel right or left of the points sees, (seen - layer) limited to 0 .. 1.
    template <class F>
    LOMMEL_INLINE void shares(const Column& column, const T* seen, T layer, const F& f) const {
        each(column, [&](std::size_t place, std::ptrdiff_t right, std::ptrdiff_t left, auto middle_mask) LOMMEL_INLINE_LAMBDA {
            using W = decltype(middle_mask);
            const W behind = splat<W>(layer), all = splat<W>(T(1));
            f(place, smaller(larger(load<W>(seen + right) - behind, W{}), all),
              permuted<Mirror, T>(smaller(larger(load<W>(seen + left) - behind, W{}), all)));
        });
    }

   private:
    std::size_t widest_, stride_;
    std::ptrdiff_t across_;
    std::size_t size_;
    Aligned<T> values_, sums_;
};

// Forward operator: points add their windows to the image `out`. In a partly occluded layer the windows are summed first; each
// pixel then receives the fraction of the sum that it sees (`seen`, see Sheets::shares()).
template <class I, class T>
struct Giving {
    using V = Packed<I, T>;
    T* out;
    const T* seen;

    LOMMEL_INLINE void open(Sheets<I, T>&, const Column&) const {}
    LOMMEL_INLINE void before(Sheets<I, T>&, const Column&, T) const {}
    LOMMEL_INLINE void after(Sheets<I, T>& sheets, const Column& column, T layer) const {
        sheets.shares(column, seen, layer, [&](std::size_t at, auto right, auto left) LOMMEL_INLINE_LAMBDA {
            using W = decltype(right);
            const W both = taken<W>(sheets.both() + at);
            store(sheets.right() + at, load<W>(sheets.right() + at) + both * right);
            store(sheets.left() + at, load<W>(sheets.left() + at) + both * left);
        });
    }
    LOMMEL_INLINE void rest(Sheets<I, T>&, const Column&) const {}

    template <class R>
    LOMMEL_INLINE void add(Sheets<I, T>& sheets, std::size_t point, const R& rows) const {
        using W = typename R::V;
        const auto to = [&](std::ptrdiff_t row, W sum) LOMMEL_INLINE_LAMBDA {
            T* const at = sheets.both() + sheets.place(static_cast<std::ptrdiff_t>(point) + row, rows.from);
            store(at, load<W>(at) + sum);
        };
        W above[R::points], below[R::points];
        rows.mix(0, above);
        if constexpr (R::points == 1) {
            to(0, above[0]);
            for (std::size_t row = 1; row <= rows.half; ++row) {
                rows.mix(row, above);
                to(static_cast<std::ptrdiff_t>(row), above[0]), to(-static_cast<std::ptrdiff_t>(row), above[0]);
            }
        } else {
            // Row r below the first point is row r - 1 below the next one; row r above the first is row r + 1 above the next.
            for (std::size_t row = 0; row < rows.half; ++row) {
                rows.mix(row + 1, below);
                to(static_cast<std::ptrdiff_t>(row) + 1, below[0] + above[1]);
                to(-static_cast<std::ptrdiff_t>(row), above[0] + below[1]);
                above[0] = below[0], above[1] = below[1];
            }
            to(static_cast<std::ptrdiff_t>(rows.half) + 1, above[1]), to(-static_cast<std::ptrdiff_t>(rows.half), above[0]);
        }
    }

    LOMMEL_INLINE void close(Sheets<I, T>& sheets, const Column& column) const {
        sheets.each(
            column, [&](std::size_t at, std::ptrdiff_t right, std::ptrdiff_t left, auto middle_mask) LOMMEL_INLINE_LAMBDA {
                using W = decltype(middle_mask);
                const W both = taken<W>(sheets.both() + at);
                W here = both, there = both;
                if (column.hidden) {
                    here = here + taken<W>(sheets.right() + at), there = there + taken<W>(sheets.left() + at);
                }
                // Load both sides before storing either: a load that partly overlaps a recent store stalls the processor. The
                // vectors of both sides contain the middle column; its sum is in the right one, which is stored last.
                here = load<W>(out + right) + here;
                store(out + left, load<W>(out + left) + permuted<typename Sheets<I, T>::Mirror, T>(there * middle_mask));
                store(out + right, here);
            });
    }

   private:
    template <class W>
    static LOMMEL_INLINE W taken(T* sum) {
        const W value = load<W>(sum);
        store(sum, W{});
        return value;
    }
};

// Transposed operator: each point receives the inner product of its window with the image.
template <class I, class T>
struct Taking {
    using V = Packed<I, T>;
    T* out;
    const T *seen, *image;
    std::size_t width;  // row length of `out`

    LOMMEL_INLINE void open(Sheets<I, T>& sheets, const Column& column) const {
        sheets.each(column,
                    [&](std::size_t at, std::ptrdiff_t right, std::ptrdiff_t left, auto middle_mask) LOMMEL_INLINE_LAMBDA {
                        using W = decltype(middle_mask);
                        const W here = load<W>(image + right);
                        const W there = permuted<typename Sheets<I, T>::Mirror, T>(load<W>(image + left)) * middle_mask;
                        if (column.hidden) {
                            store(sheets.right() + at, here), store(sheets.left() + at, there);
                        } else {
                            store(sheets.both() + at, here + there);
                        }
                    });
    }
    LOMMEL_INLINE void before(Sheets<I, T>& sheets, const Column& column, T layer) const {
        sheets.shares(column, seen, layer, [&](std::size_t at, auto right, auto left) LOMMEL_INLINE_LAMBDA {
            using W = decltype(right);
            store(sheets.both() + at, load<W>(sheets.right() + at) * right + load<W>(sheets.left() + at) * left);
        });
    }
    LOMMEL_INLINE void after(Sheets<I, T>&, const Column&, T) const {}
    LOMMEL_INLINE void rest(Sheets<I, T>& sheets, const Column& column) const {
        if (column.hidden) {
            sheets.each(column, [&](std::size_t at, std::ptrdiff_t, std::ptrdiff_t, auto middle_mask) LOMMEL_INLINE_LAMBDA {
                using W = decltype(middle_mask);
                store(sheets.both() + at, load<W>(sheets.right() + at) + load<W>(sheets.left() + at));
            });
        }
    }

    template <class R>
    LOMMEL_INLINE void add(Sheets<I, T>& sheets, std::size_t point, const R& rows) const {
        using W = typename R::V;
        const auto light = [&](std::ptrdiff_t row) LOMMEL_INLINE_LAMBDA {
            return load<W>(sheets.both() + sheets.place(static_cast<std::ptrdiff_t>(point) + row, rows.from));
        };
        // Inner products with each of the four windows, mixed at the end. Window rows r above and below a point are equal, so
        // the two image rows are added first. Row r of one point is row r + 1 or r - 1 of the other point.
        constexpr std::size_t last = R::points - 1;
        W sums[R::points][4], folded[R::points], over = light(0), under = light(static_cast<std::ptrdiff_t>(last));
        folded[0] = over, folded[last] = under;
        W values[R::points];
        for (std::size_t j = 0; j < 4; ++j) {
            rows.window(j, 0, values);
            for (std::size_t p = 0; p < R::points; ++p) {
                sums[p][j] = values[p] * folded[p];
            }
        }
        for (std::size_t row = 1; row <= rows.half; ++row) {
            const std::ptrdiff_t away = static_cast<std::ptrdiff_t>(row);
            const W above = light(-away), below = light(away + static_cast<std::ptrdiff_t>(last));
            if constexpr (R::points == 1) {
                folded[0] = above + below;
            } else {
                folded[0] = above + under, folded[last] = over + below;
                over = above, under = below;
            }
            for (std::size_t j = 0; j < 4; ++j) {
                rows.window(j, row, values);
                for (std::size_t p = 0; p < R::points; ++p) {
                    sums[p][j] = sums[p][j] + values[p] * folded[p];
                }
            }
        }
        for (std::size_t p = 0; p < R::points; ++p) {
            const W total = (rows.weight[p][0] * sums[p][0] + rows.weight[p][1] * sums[p][1]) +
                            (rows.weight[p][2] * sums[p][2] + rows.weight[p][3] * sums[p][3]);
            T* const sum = sheets.sums(point + p);
            store(sum, load<W>(sum) + total);
        }
    }

    // Sum the lanes of each point's accumulator with the shortest vectors, which every processor has.
    LOMMEL_INLINE void close(Sheets<I, T>& sheets, const Column& column) const {
        using Short = Packed<Portable, T>;
        constexpr std::size_t short_lanes = sizeof(Short) / sizeof(T);
        for (std::size_t i = column.first; i < column.last; ++i) {
            T* const sums = sheets.sums(i);
            Short total{};
            for (std::size_t j = 0; j < Sheets<I, T>::lanes; j += short_lanes) {
                total = total + load<Short>(sums + j);
                store(sums + j, Short{});
            }
            T sum = total[0];
            for (std::size_t j = 1; j < short_lanes; ++j) {
                sum += total[j];
            }
            out[column.point + i * width] += sum;
        }
    }
};

}  // namespace lommel
