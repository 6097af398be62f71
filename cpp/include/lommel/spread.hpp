// Blur that varies from pixel to pixel: every source pixel spreads its own window, a mixture of four of a bank.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/parallel.hpp"
#include "lommel/simd.hpp"

namespace lommel {

// Windows of 2 widest + 1 pixels a side, equally spaced in defocus. Between windows i and i + 1 only 2 halves[i] + 1 pixels
// a side are used; energies[i][half] is the sum of that much of window i, which the mixture is divided by.
template <class T>
struct WindowBank {
    const T* windows;            // [window][row][stride], with room for a vector behind the last
    const std::int32_t* halves;  // [window - 1]
    const double* energies;      // [window][widest + 1]
    std::size_t count, widest, stride;

    std::size_t room() const { return (2 * widest + 1) * stride; }
};

// The four windows of a pixel, from `first`, and their weights: cubic Lagrange in the middle interval, divided by the sum.
struct Mixture {
    std::size_t first, half;
    double weights[4];
};

template <class T>
Mixture mixture_at(const WindowBank<T>& bank, double position) {
    const double inside = std::min(std::max(position, 0.0), static_cast<double>(bank.count - 1));
    const std::size_t interval = std::min(static_cast<std::size_t>(inside), bank.count - 2);
    const std::size_t first = std::min(interval > 0 ? interval - 1 : 0, bank.count - 4);
    const double t = inside - static_cast<double>(first);
    Mixture m{first,
              static_cast<std::size_t>(bank.halves[interval]),
              {-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0, -t * (t - 1.0) * (t - 3.0) / 2.0,
               t * (t - 1.0) * (t - 2.0) / 6.0}};
    double sum = 0.0;
    for (std::size_t j = 0; j < 4; ++j) {
        sum += m.weights[j] * bank.energies[(first + j) * (bank.widest + 1) + m.half];
    }
    for (double& w : m.weights) {
        w /= sum;
    }
    return m;
}

template <class T>
class Spreader {
   public:
    // Pixels at `positions` in the bank, [height][width]; those below 0 spread nothing (and take nothing in the adjoint).
    Spreader(const WindowBank<T>& bank, const double* positions, std::size_t height, std::size_t width, int threads)
        : bank_(bank), positions_(positions), height_(height), width_(width), threads_(threads) {}

    // out += sum over source pixels of value times window, in an image that is `widest` larger on every side:
    // [height + 2 widest][width + 2 widest]. Bands of source rows are summed one after the other, whatever the threads.
    void forward(const T* image, T* out) const {
        const std::size_t bands = (height_ + band - 1) / band, wide = width_ + 2 * bank_.widest;
        const std::size_t rows = band + 2 * bank_.widest;
        const std::size_t together = static_cast<std::size_t>(threads_ > 0 ? threads_ : processors()) * 2;
        std::vector<std::vector<T>> sums(std::min(together, bands));
        for (std::size_t start = 0; start < bands; start += sums.size()) {
            const std::size_t here = std::min(sums.size(), bands - start);
            parallel_for(here, threads_, [&](std::size_t, std::size_t i) {
                sums[i].assign(rows * wide + padding, T(0));
                spread_band(start + i, image, sums[i].data());
            });
            for (std::size_t i = 0; i < here; ++i) {
                const std::size_t first = (start + i) * band;
                const std::size_t last = std::min(first + rows, height_ + 2 * bank_.widest);
                for (std::size_t at = 0; at < (last - first) * wide; ++at) {
                    out[first * wide + at] += sums[i][at];
                }
            }
        }
    }

    // The transpose: each source pixel takes the sum of window times `image`, which has the size of forward's output and
    // room for a vector behind it.
    void adjoint(const T* image, T* out) const {
        parallel_for(height_, threads_, [&](std::size_t, std::size_t y) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t x = 0; x < width_; ++x) {
                    const double position = positions_[y * width_ + x];
                    out[y * width_ + x] = position < 0.0 ? T(0) : gather(isa, position, image, y, x);
                }
            });
        });
    }

    static constexpr std::size_t padding = 64;  // values that a vector may reach beyond the end

   private:
    static constexpr std::size_t band = 32;

    void spread_band(std::size_t index, const T* image, T* sums) const {
        const std::size_t wide = width_ + 2 * bank_.widest, first = index * band;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using Row = Rows<decltype(isa)>;
            for (std::size_t y = first; y < std::min(height_, first + band); ++y) {
                for (std::size_t x = 0; x < width_; ++x) {
                    const double position = positions_[y * width_ + x];
                    const T value = image[y * width_ + x];
                    if (position < 0.0 || value == T(0)) {
                        continue;
                    }
                    const Mixture mixture = mixture_at(bank_, position);
                    Row rows(bank_, mixture, static_cast<double>(value));
                    T* to = sums + (y - first + bank_.widest - mixture.half) * wide + x + bank_.widest - mixture.half;
                    // Four loads of windows, four multiply-adds, a load and a store of the sum, a vector: bound by loads.
                    for (std::size_t row = 0; row < rows.side; ++row, to += wide, rows.down()) {
                        for (std::size_t i = 0; i < rows.whole; i += Row::lanes) {
                            store(to + i, load<typename Row::V>(to + i) + rows.mixed(rows.weight, i));
                        }
                        T* last = to + rows.whole;
                        store(last, load<typename Row::V>(last) + rows.mixed(rows.cut, rows.whole));
                    }
                }
            }
        });
    }

    // Mixed rows of four windows, a vector at a time; the last vector is cut off at the end of the window.
    template <class I>
    struct Rows {
        using V = std::conditional_t<sizeof(T) == 4, typename I::floats, typename I::pack>;
        static constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        std::size_t side, whole, stride;
        const T* from[4];
        V weight[4], cut[4];

        LOMMEL_INLINE Rows(const WindowBank<T>& bank, const Mixture& mixture, double value)
            : side(2 * mixture.half + 1), whole((side - 1) / lanes * lanes), stride(bank.stride) {
            alignas(64) T mask[lanes];
            for (std::size_t i = 0; i < lanes; ++i) {
                mask[i] = whole + i < side ? T(1) : T(0);
            }
            for (std::size_t j = 0; j < 4; ++j) {
                from[j] = bank.windows + (mixture.first + j) * bank.room() + (bank.widest - mixture.half) * (stride + 1);
                weight[j] = splat<V>(static_cast<T>(value * mixture.weights[j]));
                cut[j] = weight[j] * load<V>(mask);
            }
        }
        LOMMEL_INLINE V mixed(const V* weights, std::size_t i) const {
            return (weights[0] * load<V>(from[0] + i) + weights[1] * load<V>(from[1] + i)) +
                   (weights[2] * load<V>(from[2] + i) + weights[3] * load<V>(from[3] + i));
        }
        LOMMEL_INLINE void down() {
            for (const T*& f : from) {
                f += stride;
            }
        }
    };

    template <class I>
    LOMMEL_INLINE T gather(I, double position, const T* image, std::size_t y, std::size_t x) const {
        using Row = Rows<I>;
        using V = typename Row::V;
        const std::size_t wide = width_ + 2 * bank_.widest;
        const Mixture mixture = mixture_at(bank_, position);
        Row rows(bank_, mixture, 1.0);
        const T* at = image + (y + bank_.widest - mixture.half) * wide + x + bank_.widest - mixture.half;
        V total = splat<V>(T(0));
        for (std::size_t row = 0; row < rows.side; ++row, at += wide, rows.down()) {
            for (std::size_t i = 0; i < rows.whole; i += Row::lanes) {
                total = total + rows.mixed(rows.weight, i) * load<V>(at + i);
            }
            total = total + rows.mixed(rows.cut, rows.whole) * load<V>(at + rows.whole);
        }
        T sum = 0;
        for (std::size_t i = 0; i < Row::lanes; ++i) {
            sum += total[i];
        }
        return sum;
    }

    WindowBank<T> bank_;
    const double* positions_;
    std::size_t height_, width_;
    int threads_;
};

}  // namespace lommel
