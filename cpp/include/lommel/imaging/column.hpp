// What the points of one column of an image spread or take: rows of their windows, put together beside the column.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/mixture.hpp"

namespace lommel {

template <class I, class T>
using Packed = std::conditional_t<sizeof(T) == 4, typename I::floats, typename I::pack>;

// Rows of the windows of one pixel, or of two below each other, a vector of columns from `from` on: all of what the rows above
// and below share is loaded and mixed once.
template <class Vec, class T, std::size_t Points>
struct Rows {
    using V = Vec;
    static constexpr std::size_t points = Points, lanes = sizeof(V) / sizeof(T), windows = Points + 3, reach = 16;
    static_assert(lanes <= reach, "room for a vector");
    const T* windows_at[windows];
    std::size_t stride, half, from;
    V weight[Points][windows], layer[Points];
    bool apart;  // in two layers

    LOMMEL_INLINE Rows(const WindowBank<T>& bank, const Mixture<T>* pixels, std::size_t column)
        : stride(bank.stride), half(pixels->half), from(column), apart(pixels[0].layer != pixels[Points - 1].layer) {
        const std::size_t first = std::min(pixels[0].first, pixels[Points - 1].first);
        for (std::size_t j = 0; j < windows; ++j) {
            windows_at[j] = bank.windows + (first + j) * bank.room() + from;
        }
        for (std::size_t p = 0; p < Points; ++p) {
            const T* const weights = pixels[p].weights + 1 - (pixels[p].first - first);
            layer[p] = splat<V>(pixels[p].layer);
            for (std::size_t j = 0; j < windows; ++j) {
                weight[p][j] = splat<V>(weights[j]);
            }
        }
    }

    // Calls f(row, mixed) with what the pixels give to each row, from the first pixel's on.
    template <class F>
    LOMMEL_INLINE void each(const F& f) const {
        V above[Points], below[Points], both[Points];
        mix(0, above);
        if (Points == 1) {
            f(0, above);
            for (std::size_t row = 1; row <= half; ++row) {
                mix(row, above);
                const std::ptrdiff_t away = static_cast<std::ptrdiff_t>(row);
                f(away, above), f(-away, above);
            }
            return;
        }
        // Row r of the first is r - 1 below the second, r + 1 above it.
        constexpr std::size_t second = Points - 1;
        for (std::size_t row = 0; row <= half; ++row) {
            const std::ptrdiff_t away = static_cast<std::ptrdiff_t>(row);
            if (row < half) {
                mix(row + 1, below);
            } else {
                for (V& v : below) {
                    v = splat<V>(T(0));
                }
            }
            both[0] = below[0], both[second] = above[second];
            f(away + 1, both);
            both[0] = above[0], both[second] = below[second];
            f(-away, both);
            for (std::size_t p = 0; p < Points; ++p) {
                above[p] = below[p];
            }
        }
    }

    LOMMEL_INLINE void mix(std::size_t row, V* mixed) const {
        V odd[Points];
        for (std::size_t j = 0; j < windows; ++j) {
            const V value = load<V>(windows_at[j] + row * stride);
            for (std::size_t p = 0; p < Points; ++p) {
                V& sum = j % 2 ? odd[p] : mixed[p];
                sum = j < 2 ? weight[p][j] * value : sum + weight[p][j] * value;
            }
        }
        for (std::size_t p = 0; p < Points; ++p) {
            mixed[p] = mixed[p] + odd[p];
        }
    }

    // What pixels see of light, of which they see so many layers.
    LOMMEL_INLINE V shown(V light, V seen, std::size_t p) const {
        return light * smaller(larger(seen - layer[p], V{}), splat<V>(T(1)));
    }

    // So many ones, then zeros.
    static const T* mask(std::size_t ones) {
        static const T masks[2 * reach] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
        return masks + reach - ones;
    }
};

// Calls visit(rows) for the blocks of columns of one pixel or two; the narrow ones are half as dear.
template <class I, std::size_t Points, class T, class Visit>
LOMMEL_INLINE void each_block(const WindowBank<T>& bank, const Mixture<T>* points, const Visit& visit) {
    using Whole = Rows<Packed<I, T>, T, Points>;
    using Narrow = Rows<Packed<Isa<std::max<std::size_t>(2, I::lanes / 2), I::unroll>, T>, T, Points>;
    for (std::size_t from = 0; from <= points->half; from += Whole::lanes) {
        if (points->half < from + Narrow::lanes) {
            visit(Narrow(bank, points, from));
        } else {
            visit(Whole(bank, points, from));
        }
    }
}

// The points of a column: where the first of them is in an image, how many, how far the widest of their windows goes, and
// whether anything hides some of them in part.
struct Column {
    std::ptrdiff_t at;
    std::size_t height, half;
    bool hidden;
};

// What lies beside a column, [row from `widest` above its first point on][column from it on, rightwards or leftwards]. Windows
// are alike on both sides: where nothing is hidden one sheet serves both. Of the same address for all points of a
// column, in vectors that begin at cache lines, sums are loaded and stored in half the time that an image takes.
template <class I, class T>
class Sheets {
   public:
    using V = Packed<I, T>;
    Sheets(const WindowBank<T>& bank, std::size_t height, std::size_t across, bool screened)
        : widest_(bank.widest), stride_(bank.stride), across_(static_cast<std::ptrdiff_t>(across)),
          size_((height + 2 * widest_) * stride_), values_(size_ * (screened ? 5 : 1)) {}

    T* both() { return values_.data(); }
    T* right() { return values_.data() + size_; }
    T* left() { return values_.data() + 2 * size_; }
    T* seen_right() { return values_.data() + 3 * size_; }
    T* seen_left() { return values_.data() + 4 * size_; }

    // Where a row of what a point spreads begins, that of the column's first point being 0.
    LOMMEL_INLINE std::size_t place(std::ptrdiff_t row, std::size_t from) const {
        return (widest_ + static_cast<std::size_t>(row)) * stride_ + from;
    }

    // Calls f(place, right, left, beside) for all vectors that the points reach: where it is in a sheet, and in an image on
    // either side; `beside` leaves out the column in the middle, which is not on both.
    template <class F>
    LOMMEL_INLINE void each(const Column& column, const F& f) const {
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        for (std::size_t from = 0; from <= column.half; from += lanes) {
            const auto* ones = Rows<V, T, 1>::mask(lanes);
            const V beside = load<V>(ones) - load<V>(Rows<V, T, 1>::mask(from > 0 ? 0 : 1));
            const std::ptrdiff_t away = static_cast<std::ptrdiff_t>(from), last = away + static_cast<std::ptrdiff_t>(lanes) - 1;
            const std::ptrdiff_t beyond = static_cast<std::ptrdiff_t>(column.half);
            for (std::ptrdiff_t row = -beyond; row < static_cast<std::ptrdiff_t>(column.height) + beyond; ++row) {
                const std::ptrdiff_t middle = column.at + row * across_;
                f(place(row, from), middle + away, middle - last, beside);
            }
        }
    }

    // Columns to the left in the sequence of those to the right.
    struct Mirror {
        static constexpr std::size_t at(std::size_t i, std::size_t lanes) { return lanes - 1 - i; }
    };

    LOMMEL_INLINE void see(const Column& column, const T* seen) {
        each(column, [&](std::size_t place, std::ptrdiff_t right, std::ptrdiff_t left, V) LOMMEL_INLINE_LAMBDA {
            store(seen_right() + place, load<V>(seen + right));
            store(seen_left() + place, permuted<Mirror, T>(load<V>(seen + left)));
        });
    }

   private:
    std::size_t widest_, stride_;
    std::ptrdiff_t across_;
    std::size_t size_;
    Aligned<T> values_;
};

// Points add what they spread to an image.
template <class I, class T>
struct Giving {
    using V = Packed<I, T>;
    T* out;
    const T* seen;

    LOMMEL_INLINE void open(Sheets<I, T>& sheets, const Column& column) const {
        if (column.hidden) {
            sheets.see(column, seen);
        }
    }

    template <bool Hiding, class R>
    LOMMEL_INLINE void add(Sheets<I, T>& sheets, std::size_t point, const R& rows, std::size_t) const {
        using W = typename R::V;
        rows.each([&](std::ptrdiff_t row, const W* mixed) LOMMEL_INLINE_LAMBDA {
            const std::size_t at = sheets.place(static_cast<std::ptrdiff_t>(point) + row, rows.from);
            const bool sum = R::points == 2 && !(Hiding && rows.apart);
            const W first = sum ? mixed[0] + mixed[R::points - 1] : mixed[0];
            if constexpr (Hiding) {
                W right = load<W>(sheets.right() + at), left = load<W>(sheets.left() + at);
                const W on_right = load<W>(sheets.seen_right() + at), on_left = load<W>(sheets.seen_left() + at);
                right = right + rows.shown(first, on_right, 0), left = left + rows.shown(first, on_left, 0);
                if (rows.apart) {
                    right = right + rows.shown(mixed[R::points - 1], on_right, R::points - 1);
                    left = left + rows.shown(mixed[R::points - 1], on_left, R::points - 1);
                }
                store(sheets.right() + at, right), store(sheets.left() + at, left);
            } else {
                store(sheets.both() + at, load<W>(sheets.both() + at) + first);
            }
        });
    }

    LOMMEL_INLINE void close(Sheets<I, T>& sheets, const Column& column) const {
        const auto take = [](T* sum) LOMMEL_INLINE_LAMBDA {
            const V value = load<V>(sum);
            store(sum, V{});
            return value;
        };
        sheets.each(column, [&](std::size_t at, std::ptrdiff_t right, std::ptrdiff_t left, V beside) LOMMEL_INLINE_LAMBDA {
            const V both = take(sheets.both() + at);
            V here = both, there = both;
            if (column.hidden) {
                here = here + take(sheets.right() + at), there = there + take(sheets.left() + at);
            }
            // Both are loaded first: a processor waits for what is loaded where a part of it has just been stored. The column in
            // the middle is in both, and right in the second.
            here = load<V>(out + right) + here;
            store(out + left, load<V>(out + left) + permuted<typename Sheets<I, T>::Mirror, T>(there * beside));
            store(out + right, here);
        });
    }
};

// The transpose: they take the sums of their windows times an image.
template <class I, class T>
struct Taking {
    using V = Packed<I, T>;
    T* out;
    const T *seen, *image;
    std::size_t width;  // of `out`

    LOMMEL_INLINE void open(Sheets<I, T>& sheets, const Column& column) const {
        if (column.hidden) {
            sheets.see(column, seen);
        }
        sheets.each(column, [&](std::size_t at, std::ptrdiff_t right, std::ptrdiff_t left, V beside) LOMMEL_INLINE_LAMBDA {
            const V here = load<V>(image + right);
            const V there = permuted<typename Sheets<I, T>::Mirror, T>(load<V>(image + left)) * beside;
            store(sheets.both() + at, here + there);
            if (column.hidden) {
                store(sheets.right() + at, here), store(sheets.left() + at, there);
            }
        });
    }

    template <bool Hiding, class R>
    LOMMEL_INLINE void add(Sheets<I, T>& sheets, std::size_t point, const R& rows, std::size_t to) const {
        using W = typename R::V;
        W total[R::points] = {};
        rows.each([&](std::ptrdiff_t row, const W* mixed) LOMMEL_INLINE_LAMBDA {
            const std::size_t at = sheets.place(static_cast<std::ptrdiff_t>(point) + row, rows.from);
            W light = load<W>((Hiding ? sheets.right() : sheets.both()) + at);
            for (std::size_t p = 0; p < R::points; ++p) {
                if (Hiding && (p == 0 || rows.apart)) {
                    light = rows.shown(load<W>(sheets.right() + at), load<W>(sheets.seen_right() + at), p) +
                            rows.shown(load<W>(sheets.left() + at), load<W>(sheets.seen_left() + at), p);
                }
                total[p] = total[p] + mixed[p] * light;
            }
        });
        for (std::size_t p = 0; p < R::points; ++p) {
            for (std::size_t i = 0; i < R::lanes; ++i) {
                out[to + p * width] += total[p][i];
            }
        }
    }

    LOMMEL_INLINE void close(Sheets<I, T>&, const Column&) const {}
};

}  // namespace lommel
