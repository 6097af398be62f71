// Blur that varies from pixel to pixel: every source pixel spreads its own window, a mixture of four of a bank.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Windows of 2 widest + 1 pixels a side, equally spaced in defocus, alike in their four quadrants. Of window i the
// pixels up to halves[i] from the middle are used, and of the ring at k the share halves[i] + 1 - k, from 0 to 1; between two
// windows the half width is interpolated, so that what is used never jumps. energies[i][half] is the sum of window i up to a
// whole half width: the mixture is divided by what is used of it.
template <class T>
struct WindowBank {
    const T* windows;        // [window and one more][row from the middle one down][column from the middle one on, zeros last]
    const double* halves;    // [window]
    const double* energies;  // [window][widest + 1]
    std::size_t count, widest, stride;

    std::size_t room() const { return (widest + 1) * stride; }
};

// The four windows of a pixel, from `first`, and their weights: cubic Lagrange in the middle interval, divided by the sum. Up
// to `half` pixels from the middle are used, of the last ring the share `rim`.
template <class T>
struct Mixture {
    std::size_t first, half;
    T rim, weights[4];
    bool none;  // nothing is spread
};

template <class T>
LOMMEL_INLINE Mixture<T> mixture_at(const WindowBank<T>& bank, double position, double value) {
    if (position < 0.0 || value == 0.0) {
        return {0, 0, T(0), {}, true};
    }
    const double inside = std::min(position, static_cast<double>(bank.count - 1));
    const std::size_t interval = std::min(static_cast<std::size_t>(inside), bank.count - 2);
    const std::size_t first = std::min(interval > 0 ? interval - 1 : 0, bank.count - 4);
    const double t = inside - static_cast<double>(first), part = inside - static_cast<double>(interval);
    const double wide = (1.0 - part) * bank.halves[interval] + part * bank.halves[interval + 1];
    const std::size_t half = static_cast<std::size_t>(std::ceil(wide));
    const double rim = wide + 1.0 - static_cast<double>(half), inner = t * (t - 3.0), outer = (t - 1.0) * (t - 2.0);
    const double weights[] = {(-1.0 / 6.0) * outer * (t - 3.0), 0.5 * inner * (t - 2.0), -0.5 * inner * (t - 1.0),
                              (1.0 / 6.0) * outer * t};
    double sum = 0.0;
    const double* energy = bank.energies + first * (bank.widest + 1) + half;
    for (std::size_t j = 0; j < 4; ++j, energy += bank.widest + 1) {
        sum += weights[j] * (rim * *energy + (half == 0 ? 0.0 : (1.0 - rim) * energy[-1]));
    }
    Mixture<T> m{first, half, static_cast<T>(rim), {}, false};
    for (std::size_t j = 0; j < 4; ++j) {
        m.weights[j] = static_cast<T>(value / sum * weights[j]);
    }
    return m;
}

template <class T>
class Spreader {
   public:
    // Pixels at `positions` in the bank, [height][width]; those below 0 spread nothing (and take nothing in the adjoint).
    Spreader(const WindowBank<T>& bank, const double* positions, std::size_t height, std::size_t width, int threads)
        : bank_(bank), positions_(positions), height_(height), width_(width), threads_(threads), margin_(margin(bank.widest)) {}

    // Values in the longest vector; columns that vectors reach to on either side of a pixel.
    static constexpr std::size_t reach = 16;
    static std::size_t margin(std::size_t widest) { return (widest / reach + 1) * reach; }

    // out += sum over source pixels of value times window, in an image that is `widest` larger above and below and margin()
    // on either side: [height + 2 widest][width + 2 margin]. Of tiles no smaller than what a pixel writes to, those of one
    // parity do not meet: the threads write side by side, and every sum is in the same sequence however many.
    void forward(const T* image, T* out) const {
        const std::size_t tall = std::max(least_rows, 2 * bank_.widest), broad = std::max(least_columns, 2 * margin_);
        const std::size_t down = (height_ + tall - 1) / tall, across = (width_ + broad - 1) / broad;
        for (std::size_t parity = 0; parity < 4; ++parity) {
            const std::size_t top = parity / 2, left = parity % 2;
            const std::size_t rows = (down + 1 - top) / 2, columns = (across + 1 - left) / 2;
            parallel_for(rows * columns, threads_, [&](std::size_t, std::size_t task) {
                const std::size_t y = (2 * (task / columns) + top) * tall, x = (2 * (task % columns) + left) * broad;
                spread_tile(y, std::min(height_, y + tall), x, std::min(width_, x + broad), image, out);
            });
        }
    }

    // The transpose: each source pixel takes the sum of window times `image`, which has the size of forward's output.
    void adjoint(const T* image, T* out) const {
        std::fill_n(out, height_ * width_, T(0));
        parallel_for((height_ + least_rows - 1) / least_rows, threads_, [&](std::size_t, std::size_t task) {
            const std::size_t top = task * least_rows;
            collect_strip(top, std::min(height_, top + least_rows), image, out);
        });
    }

   private:
    // Small enough for what a tile writes to to stay in the first cache, next to its windows.
    static constexpr std::size_t least_rows = 16, least_columns = 64;

    std::size_t wide() const { return width_ + 2 * margin_; }

    void spread_tile(std::size_t top, std::size_t bottom, std::size_t left, std::size_t right, const T* image, T* out) const {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            Glance glance;
            for (std::size_t x = left; x < right; ++x) {
                glance((bottom - top) * (1 + bank_.widest * bank_.widest));
                column(isa, top, bottom, x, [&](std::size_t y) { return static_cast<double>(image[y * width_ + x]); },
                       [&](const auto& rows, std::size_t y) LOMMEL_INLINE_LAMBDA {
                           T* middle = out + (y + bank_.widest) * wide() + margin_ + x;
                           rows.each([&](std::ptrdiff_t row, const auto* mixed) LOMMEL_INLINE_LAMBDA {
                               rows.add(middle + row * static_cast<std::ptrdiff_t>(wide()), mixed);
                           });
                       });
            }
        });
    }

    void collect_strip(std::size_t top, std::size_t bottom, const T* image, T* out) const {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            Glance glance;
            for (std::size_t x = 0; x < width_; ++x) {
                glance((bottom - top) * (1 + bank_.widest * bank_.widest));
                column(isa, top, bottom, x, [](std::size_t) { return 1.0; },
                       [&](const auto& rows, std::size_t y) LOMMEL_INLINE_LAMBDA {
                           const T* middle = image + (y + bank_.widest) * wide() + margin_ + x;
                           using Here = std::decay_t<decltype(rows)>;
                           typename Here::V total[Here::points] = {};
                           rows.each([&](std::ptrdiff_t row, const auto* mixed) LOMMEL_INLINE_LAMBDA {
                               rows.take(middle + row * static_cast<std::ptrdiff_t>(wide()), mixed, total);
                           });
                           rows.sum(total, out + y * width_ + x, width_);
                       });
            }
        });
    }

    // Calls visit(rows, y) for all blocks of columns of all pixels of a column of the image, of two that are next to each
    // other at once where their windows are as wide and share three of four or more. Down, not across: a sum that has
    // just been stored is loaded again from the same address, which a processor does at once, whereas it waits for one that
    // was stored across.
    template <class I, class Value, class Visit>
    LOMMEL_INLINE void column(I, std::size_t top, std::size_t bottom, std::size_t x, const Value& value, const Visit& visit) const {
        const auto at = [&](std::size_t y) LOMMEL_INLINE_LAMBDA {
            return y < bottom ? mixture_at(bank_, positions_[y * width_ + x], value(y)) : Mixture<T>{0, 0, T(0), {}, true};
        };
        Mixture<T> pair[2] = {at(top), at(top + 1)};
        for (std::size_t y = top; y < bottom;) {
            const bool both = !pair[0].none && !pair[1].none && pair[0].half == pair[1].half &&
                              pair[0].first <= pair[1].first + 1 && pair[1].first <= pair[0].first + 1;
            if (both) {
                blocks<I, 2>(pair, [&](const auto& rows) LOMMEL_INLINE_LAMBDA { visit(rows, y); });
                pair[0] = at(y + 2), pair[1] = at(y + 3);
                y += 2;
            } else {
                if (!pair[0].none) {
                    blocks<I, 1>(pair, [&](const auto& rows) LOMMEL_INLINE_LAMBDA { visit(rows, y); });
                }
                pair[0] = pair[1], pair[1] = at(y + 2);
                y += 1;
            }
        }
    }

    template <class I, std::size_t Points, class Visit>
    LOMMEL_INLINE void blocks(const Mixture<T>* points, const Visit& visit) const {
        using V = std::conditional_t<sizeof(T) == 4, typename I::floats, typename I::pack>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        if constexpr (I::lanes > 2) {
            using Half = Vector<I::lanes / 2>;
            if (points->half < lanes / 2) {
                using Narrow = std::conditional_t<sizeof(T) == 4, typename Half::floats, typename Half::pack>;
                return visit(Rows<Narrow, Points, true>(bank_, points, 0));
            }
        }
        visit(Rows<V, Points, true>(bank_, points, 0));
        for (std::size_t from = lanes; from <= points->half; from += lanes) {
            visit(Rows<V, Points, false>(bank_, points, from));
        }
    }

    // Rows of the windows of one pixel, or of two below each other, a vector of columns on either side of the middle: all of
    // what the rows above and below, left and right share is loaded and mixed once. Bound by loads and stores.
    template <class Vec, std::size_t Points, bool Middle>
    struct Rows {
        using V = Vec;
        static constexpr std::size_t points = Points, lanes = sizeof(V) / sizeof(T), windows = Points + 3;
        static_assert(lanes <= reach, "room for a vector");
        const T* windows_at[windows];
        std::size_t stride, half;
        std::ptrdiff_t right, left;  // from the pixel to where the vectors begin
        V weight[Points][windows], last[Points], beside;

        LOMMEL_INLINE Rows(const WindowBank<T>& bank, const Mixture<T>* pixels, std::size_t from)
            : stride(bank.stride), half(pixels->half), right(static_cast<std::ptrdiff_t>(from)),
              left(-right - static_cast<std::ptrdiff_t>(Middle ? lanes : lanes - 1)) {
            const std::size_t inner = std::min(half - from, lanes), used = std::min(half + 1 - from, lanes);
            const V within = load<V>(mask(inner)), rim = load<V>(mask(used)) - within;
            std::size_t first = pixels[0].first;
            if (Points == 2) {
                first = std::min(first, pixels[1].first);
            }
            for (std::size_t j = 0; j < windows; ++j) {
                windows_at[j] = bank.windows + (first + j) * bank.room() + from;
            }
            for (std::size_t p = 0; p < Points; ++p) {
                T weights[5] = {};
                for (std::size_t j = 0; j < 4; ++j) {
                    weights[pixels[p].first - first + j] = pixels[p].weights[j];
                }
                const V share = splat<V>(pixels[p].rim), cut = within + rim * share;
                last[p] = within * share + rim;
                for (std::size_t j = 0; j < windows; ++j) {
                    weight[p][j] = splat<V>(weights[j]) * cut;
                }
            }
            // The column in the middle is not on both sides.
            beside = load<V>(mask(lanes)) - load<V>(mask(Middle ? 1 : 0));
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
            V value[windows];
            for (std::size_t j = 0; j < windows; ++j) {
                value[j] = load<V>(windows_at[j] + row * stride);
            }
            for (std::size_t p = 0; p < Points; ++p) {
                V odd = weight[p][1] * value[1], even = weight[p][0] * value[0];
                for (std::size_t j = 2; j < windows; ++j) {
                    V& sum = j % 2 ? odd : even;
                    sum = sum + weight[p][j] * value[j];
                }
                mixed[p] = even + odd;
                if (row == half) {
                    mixed[p] = mixed[p] * last[p];
                }
            }
        }

        LOMMEL_INLINE void add(T* to, const V* mixed) const {
            V sum = mixed[0];
            if (Points == 2) {
                sum = sum + mixed[Points - 1];
            }
            const V here = load<V>(to + right) + sum, there = load<V>(to + left) + turned<turn, T>(sum) * beside;
            store(to + left, there);
            store(to + right, here);
        }

        LOMMEL_INLINE void take(const T* from, const V* mixed, V* total) const {
            const V both = load<V>(from + right) + turned<turn, T>(load<V>(from + left)) * beside;
            for (std::size_t p = 0; p < Points; ++p) {
                total[p] = total[p] + mixed[p] * both;
            }
        }

        LOMMEL_INLINE void sum(const V* total, T* out, std::size_t width) const {
            for (std::size_t p = 0; p < Points; ++p) {
                for (std::size_t i = 0; i < lanes; ++i) {
                    out[p * width] += total[p][i];
                }
            }
        }

        static constexpr std::size_t turn = Middle ? 0 : lanes - 1;
        // So many ones, then zeros.
        static const T* mask(std::size_t ones) {
            static const T masks[2 * reach] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
            return masks + reach - ones;
        }
    };

    WindowBank<T> bank_;
    const double* positions_;
    std::size_t height_, width_;
    int threads_;
    std::size_t margin_;
};

}  // namespace lommel
