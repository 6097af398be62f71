// Blur that varies over the field and with depth, and its adjoint: each pixel spreads a PSF window interpolated by splines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "lommel/base/aligned.hpp"
#include "lommel/base/checkerboard.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/column.hpp"

namespace lommel {

// Spline coefficients of PSF windows, [node down the field][node across][node over defocus][pixel, by rows, zero padded]. down,
// across, depth: numbers of nodes; side: width of a window (pixels); size: number of values of a window, padding included.
template <class T>
struct FieldWindows {
    const T* coefficients;
    std::size_t down, across, depth, side, size;

    std::size_t row() const { return depth * size; }  // stride between adjacent nodes across the field
};

// Splines give PSF windows only at some columns, the "places", an odd number of them. The window of column c is interpolated by
// a parabola: the sum of the windows at the places 2 tiles[c] .. 2 tiles[c] + 2, each times one of the weights shares[c][3].
template <class T>
struct FieldScene {
    const T *down, *places, *shares;  // spline weights: down[row][node], places[place][node]; shares[column][3]
    const std::int64_t* tiles;
    std::size_t count, height, width;  // number of places, rows, columns
    const double *defocus, *breaks;    // defocus[row][column]; breaks: ends of the defocus intervals
    const T* powers;                   // [interval][power][node]: spline weights as polynomials of t = 0 .. 1 in an interval
    std::size_t intervals, order;
};

// Blur by interpolated PSF windows: each source pixel adds its window to the image (forward) or takes the inner product of its
// window with the image (adjoint).
template <class T>
class FieldSpreader {
   public:
    FieldSpreader(const FieldWindows<T>& bank, const FieldScene<T>& scene, int threads)
        : bank_(bank), scene_(scene), threads_(threads), wide_(scene.width + bank.side - 1 + step),
          tall_(std::max(least_rows, bank.side)) {}

    static constexpr std::size_t step = 16;  // divides window sizes; number of values that may be loaded beyond a row

    // Add values[height][width], each times its window (side x side), to out[height + side - 1][width + side - 1 + step (padding)].
    void forward(const T* values, T* out) const;

    // Transpose of forward(): out[height][width] = inner product of each pixel's window with `image` (size: forward()'s out).
    void adjoint(const T* image, T* out) const;

   private:
    static constexpr std::size_t least_rows = 32;

    void run(std::size_t strip, const T* values, const T* image, T* out) const {
        const std::size_t top = strip * tall_, bottom = std::min(scene_.height, top + tall_);
        Aligned<T> across(bank_.across * bank_.row()), nodes(scene_.count * bank_.row()), windows(2 * (bank_.size + step));
        dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using I = decltype(isa);
            for (std::size_t y = top; y < bottom; ++y) {
                look();
                mix_row(isa, y, across.data(), nodes.data());
                switch (scene_.order) {
                    case 1:
                        one_row<I, 1>(y, nodes.data(), values, image, out, windows.data());
                        break;
                    case 4:
                        one_row<I, 4>(y, nodes.data(), values, image, out, windows.data());
                        break;
                    default:
                        one_row<I, 6>(y, nodes.data(), values, image, out, windows.data());
                }
            }
        });
    }

    // Interpolate the windows of scene row y at the places (FieldScene): `nodes`[place][node over defocus][pixel]. across:
    // workspace.
    template <class I>
    LOMMEL_INLINE void mix_row(I, std::size_t y, T* across, T* nodes) const {
        combine<I>(scene_.down + y * bank_.down, bank_.down, bank_.coefficients, bank_.across * bank_.row(), across);
        for (std::size_t place = 0; place < scene_.count; ++place) {
            combine<I>(scene_.places + place * bank_.across, bank_.across, across, bank_.row(), nodes + place * bank_.row());
        }
    }

    // Write the weighted sum of `count` consecutive arrays of `size` values; most spline weights are 0 and are skipped.
    template <class I>
    LOMMEL_INLINE static void combine(const T* weights, std::size_t count, const T* arrays, std::size_t size, T* out) {
        using V = Packed<I, T>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        const T* used[most_used];
        V weight[most_used] = {};
        bool more = false;
        for (std::size_t k = 0; k < count;) {
            std::size_t used_count = 0;
            for (; k < count && used_count < most_used; ++k) {
                if (weights[k] != T(0)) {
                    used[used_count] = arrays + k * size, weight[used_count] = splat<V>(weights[k]), ++used_count;
                }
            }
            for (std::size_t i = 0; i < size; i += lanes) {
                V sum = more ? load<V>(out + i) : V{};
                for (std::size_t j = 0; j < used_count; ++j) {
                    sum = sum + weight[j] * load<V>(used[j] + i);
                }
                store(out + i, sum);
            }
            more = true;
        }
    }

    // Process row y of the scene. The next window is computed before the previous one is added to the image: a load that partly
    // overlaps a recent store stalls the processor.
    template <class I, std::size_t Order>
    LOMMEL_INLINE void one_row(std::size_t y, const T* nodes, const T* values, const T* image, T* out, T* windows) const {
        T* const at[2] = {windows, windows + bank_.size + step};
        std::size_t interval = 0, turn = 0, last = scene_.width;
        for (std::size_t x = 0; x < scene_.width; ++x) {
            const T value = values ? values[y * scene_.width + x] : T(1);
            if (value == T(0)) {
                continue;
            }
            T weight[3 * Order];
            const T* const first = weigh<Order>(y, x, value, nodes, interval, weight);
            if (image) {
                if (last == scene_.width) {
                    take<I>(image + y * wide_ + x, at[turn]);
                }
                if (x + 1 < scene_.width) {
                    take<I>(image + y * wide_ + x + 1, at[1 - turn]);
                }
                out[y * scene_.width + x] = mix<I, Order, true>(weight, first, at[turn]);
            } else {
                mix<I, Order, false>(weight, first, at[turn]);
                if (last < scene_.width) {
                    give<I>(at[1 - turn], out + y * wide_ + last);
                }
            }
            last = x, turn = 1 - turn;
        }
        if (!image && last < scene_.width) {
            give<I>(at[1 - turn], out + y * wide_ + last);
        }
    }

    // Compute weight[place][defocus node] of 3 x Order windows in `nodes`: their weighted sum is `value` times the window of pixel
    // (y, x). Return the first of these windows. interval: index of the defocus interval at which the search begins; on return,
    // index of the interval that contains the pixel's defocus, clipped to the range of the splines.
    template <std::size_t Order>
    LOMMEL_INLINE const T* weigh(std::size_t y, std::size_t x, T value, const T* nodes, std::size_t& interval,
                                 T* weight) const {
        T focus[Order] = {T(1)};
        if (Order > 1) {
            const double* const breaks = scene_.breaks;
            const double given = scene_.defocus[y * scene_.width + x];
            const double c = std::min(std::max(given, breaks[0]), breaks[scene_.intervals]);
            for (; interval + 1 < scene_.intervals && c >= breaks[interval + 1]; ++interval) {
            }
            for (; interval > 0 && c < breaks[interval]; --interval) {
            }
            const T t = static_cast<T>((c - breaks[interval]) / (breaks[interval + 1] - breaks[interval]));
            const T* const powers = scene_.powers + interval * Order * Order;
            for (std::size_t i = 0; i < Order; ++i) {
                focus[i] = powers[(Order - 1) * Order + i];
            }
            for (std::size_t power = Order - 1; power-- > 0;) {
                for (std::size_t i = 0; i < Order; ++i) {
                    focus[i] = focus[i] * t + powers[power * Order + i];
                }
            }
        }
        for (std::size_t j = 0; j < 3; ++j) {
            const T share = value * scene_.shares[3 * x + j];
            for (std::size_t i = 0; i < Order; ++i) {
                weight[j * Order + i] = share * focus[i];
            }
        }
        return nodes + 2 * static_cast<std::size_t>(scene_.tiles[x]) * bank_.row() + interval * bank_.size;
    }

    // Sum 3 x Order windows, from `first` on, times `weights`. Write the sum to `at` or, if `Product`, return its inner product
    // with the image pixels at `at`.
    template <class I, std::size_t Order, bool Product>
    LOMMEL_INLINE T mix(const T* weights, const T* first, T* at) const {
        using V = Packed<I, T>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        const std::size_t size = bank_.size, room = bank_.row();
        V weight[3 * Order], total{};
        for (std::size_t j = 0; j < 3 * Order; ++j) {
            weight[j] = splat<V>(weights[j]);
        }
        for (std::size_t i = 0; i < size; i += lanes) {
            const T* const window = first + i;
            V mixed = weight[0] * load<V>(window);
            for (std::size_t j = 1; j < 3 * Order; ++j) {
                mixed = mixed + weight[j] * load<V>(window + j / Order * room + j % Order * size);
            }
            if (Product) {
                total = total + mixed * load<V>(at + i);
            } else {
                store(at + i, mixed);
            }
        }
        T sum = T(0);
        for (std::size_t lane = 0; Product && lane < lanes; ++lane) {
            sum += total[lane];
        }
        return sum;
    }

    // Add a window to an image. The last columns use the shortest sufficient vector, with excess lanes multiplied by 0.
    template <class I>
    LOMMEL_INLINE void give(const T* window, T* out) const {
        constexpr std::size_t lanes = sizeof(Packed<I, T>) / sizeof(T);
        const std::size_t whole = bank_.side / lanes * lanes, rest = bank_.side - whole;
        for (std::size_t from = 0; from < whole; from += lanes) {
            give_columns<Packed<I, T>>(window + from, out + from, lanes);
        }
        if (rest > lanes / 2) {
            give_columns<Packed<I, T>>(window + whole, out + whole, rest);
        } else if (rest > sizeof(Packed<Portable, T>) / sizeof(T)) {
            give_columns<Packed<Half<I>, T>>(window + whole, out + whole, rest);
        } else if (rest > 0) {
            give_columns<Packed<Portable, T>>(window + whole, out + whole, rest);
        }
    }

    template <class V>
    LOMMEL_INLINE void give_columns(const T* window, T* out, std::size_t count) const {
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        T inside[lanes];
        for (std::size_t i = 0; i < lanes; ++i) {
            inside[i] = i < count ? T(1) : T(0);
        }
        const V used = load<V>(inside);
        for (std::size_t row = 0; row < bank_.side; ++row) {
            T* const to = out + row * wide_;
            store(to, load<V>(to) + used * load<V>(window + row * bank_.side));
        }
    }

    // Copy the image pixels that a window covers. Vectors extend beyond the end of a row; the next row overwrites the excess.
    template <class I>
    LOMMEL_INLINE void take(const T* image, T* window) const {
        using V = Packed<I, T>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        for (std::size_t row = 0; row < bank_.side; ++row) {
            for (std::size_t from = 0; from < bank_.side; from += lanes) {
                store(window + row * bank_.side + from, load<V>(image + row * wide_ + from));
            }
        }
    }

    static constexpr std::size_t most_used = 8;  // number of arrays that combine() sums at once

    FieldWindows<T> bank_;
    FieldScene<T> scene_;
    int threads_;
    std::size_t wide_, tall_;
};

// Defined outside the class so that it is not inline and is compiled once, by explicit instantiation.
template <class T>
void FieldSpreader<T>::forward(const T* values, T* out) const {
    const Checkerboard strips((scene_.height + tall_ - 1) / tall_, 1);
    strips.each(threads_, [&](std::size_t strip, std::size_t) { run(strip, values, static_cast<const T*>(nullptr), out); });
}

template <class T>
void FieldSpreader<T>::adjoint(const T* image, T* out) const {
    parallel_for((scene_.height + tall_ - 1) / tall_, threads_,
                 [&](std::size_t, std::size_t strip) { run(strip, static_cast<const T*>(nullptr), image, out); });
}

#if defined(LOMMEL_COMPILED)
extern template class FieldSpreader<float>;
extern template class FieldSpreader<double>;
#endif

}  // namespace lommel
