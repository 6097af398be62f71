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

// Windows of 2 widest + 1 pixels a side, equally spaced in defocus, whose upper rows mirror the lower ones. Of window i the
// pixels up to halves[i] from the middle are used, and of the ring at k the share halves[i] + 1 - k, from 0 to 1; between two
// windows the half width is interpolated, so that what is used never jumps. energies[i][half] is the sum of window i up to a
// whole half width: the mixture is divided by what is used of it.
template <class T>
struct WindowBank {
    const T* windows;        // [window][row from the middle one down][stride], with room for a vector behind the last
    const double* halves;    // [window]
    const double* energies;  // [window][widest + 1]
    std::size_t count, widest, stride;

    std::size_t room() const { return (widest + 1) * stride; }
};

// The four windows of a pixel, from `first`, and their weights: cubic Lagrange in the middle interval, divided by the sum. Up
// to `half` pixels from the middle are used, of the last ring the share `rim`.
struct Mixture {
    std::size_t first, half;
    double rim, weights[4];
};

template <class T>
Mixture mixture_at(const WindowBank<T>& bank, double position) {
    const double inside = std::min(std::max(position, 0.0), static_cast<double>(bank.count - 1));
    const std::size_t interval = std::min(static_cast<std::size_t>(inside), bank.count - 2);
    const std::size_t first = std::min(interval > 0 ? interval - 1 : 0, bank.count - 4);
    const double t = inside - static_cast<double>(first), part = inside - static_cast<double>(interval);
    const double wide = (1.0 - part) * bank.halves[interval] + part * bank.halves[interval + 1];
    const std::size_t half = static_cast<std::size_t>(std::ceil(wide));
    Mixture m{first,
              half,
              wide + 1.0 - static_cast<double>(half),
              {-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0, -t * (t - 1.0) * (t - 3.0) / 2.0,
               t * (t - 1.0) * (t - 2.0) / 6.0}};
    double sum = 0.0;
    for (std::size_t j = 0; j < 4; ++j) {
        const double* energy = bank.energies + (first + j) * (bank.widest + 1) + half;
        sum += m.weights[j] * (half == 0 ? *energy : (1.0 - m.rim) * energy[-1] + m.rim * *energy);
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

    // Columns of out beyond the image and its windows: the zeros that fill a last vector are added there.
    static constexpr std::size_t beyond = 16;

    // out += sum over source pixels of value times window, in an image that is `widest` larger on every side and has columns
    // that stay as they are: [height + 2 widest][width + 2 widest + beyond]. Of tiles no smaller than what a pixel writes to,
    // those of one parity do not meet: the threads write side by side, and every sum is in the same sequence however many.
    void forward(const T* image, T* out) const {
        const std::size_t tall = std::max(least_rows, 2 * bank_.widest),
                          broad = std::max(least_columns, 2 * bank_.widest + beyond);
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

    // The transpose: each source pixel takes the sum of window times `image`, which has the size of forward's output and
    // room for a vector behind it.
    void adjoint(const T* image, T* out) const {
        parallel_for(height_, threads_, [&](std::size_t, std::size_t y) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                Glance glance;
                for (std::size_t x = 0; x < width_; ++x) {
                    glance(1 + bank_.widest * bank_.widest);
                    const double position = positions_[y * width_ + x];
                    out[y * width_ + x] = position < 0.0 ? T(0) : gather(isa, position, image, y, x);
                }
            });
        });
    }

    static constexpr std::size_t padding = 64;  // values that a vector may reach beyond the end

   private:
    // Small enough for what a tile writes to to stay in the first cache, next to its windows.
    static constexpr std::size_t least_rows = 16, least_columns = 64;

    void spread_tile(std::size_t top, std::size_t bottom, std::size_t left, std::size_t right, const T* image, T* out) const {
        const std::size_t wide = width_ + 2 * bank_.widest + beyond;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using Row = Rows<decltype(isa)>;
            Glance glance;
            for (std::size_t x = left; x < right; ++x) {
                glance((bottom - top) * (1 + bank_.widest * bank_.widest));
                // Down, not across: a sum that has just been stored is loaded again from the same address, which a processor
                // does at once, whereas it waits for one that was stored across.
                for (std::size_t y = top; y < bottom; ++y) {
                    const double position = positions_[y * width_ + x];
                    const T value = image[y * width_ + x];
                    if (position < 0.0 || value == T(0)) {
                        continue;
                    }
                    const Mixture mixture = mixture_at(bank_, position);
                    Row rows(bank_, mixture, static_cast<double>(value));
                    T* below = out + (y + bank_.widest) * wide + x + bank_.widest - mixture.half;
                    T* above = below;
                    rows.each([&](std::size_t i, auto mixed) LOMMEL_INLINE_LAMBDA { add(below + i, mixed); });
                    // Four loads of windows and as many multiply-adds for two vectors of sums: bound by loads and stores.
                    for (std::size_t row = 0; row < mixture.half; ++row) {
                        if (row + 1 == mixture.half) {
                            rows.at_rim();
                        }
                        rows.down(), below += wide, above -= wide;
                        rows.each([&](std::size_t i, auto mixed) LOMMEL_INLINE_LAMBDA {
                            add(below + i, mixed);
                            add(above + i, mixed);
                        });
                    }
                }
            }
        });
    }

    template <class V>
    static LOMMEL_INLINE void add(T* to, V mixed) {
        store(to, load<V>(to) + mixed);
    }

    // Mixed rows of four windows, a vector at a time; the last vector is cut off at the end of the window. The first and the
    // last pixel of a row are of the last ring, of which a share is used, and so are all pixels of the last row.
    template <class I>
    struct Rows {
        using V = std::conditional_t<sizeof(T) == 4, typename I::floats, typename I::pack>;
        static constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        static_assert(lanes <= beyond && 4 * lanes <= padding, "room for a vector");
        std::size_t whole;
        const T* from[4];
        std::size_t stride;
        V head[4], weight[4], cut[4], rim, mask;

        LOMMEL_INLINE Rows(const WindowBank<T>& bank, const Mixture& mixture, double value)
            : whole(2 * mixture.half / lanes * lanes), stride(bank.stride), rim(splat<V>(static_cast<T>(mixture.rim))) {
            const std::size_t last = 2 * mixture.half - whole;
            mask = load<V>(mask_at(last + 1));
            const V one = splat<V>(T(1)), begin = one + (rim - one) * load<V>(mask_at(mixture.half > 0 ? 1 : 0));
            const V end = rim * mask + (one - rim) * load<V>(mask_at(last));
            for (std::size_t j = 0; j < 4; ++j) {
                from[j] = bank.windows + (mixture.first + j) * bank.room() + bank.widest - mixture.half;
                weight[j] = splat<V>(static_cast<T>(value * mixture.weights[j]));
                head[j] = weight[j] * begin;
                cut[j] = (whole > 0 ? weight[j] : head[j]) * end;
            }
        }
        // From here on all pixels are of the last ring.
        LOMMEL_INLINE void at_rim() {
            for (std::size_t j = 0; j < 4; ++j) {
                head[j] = weight[j] = weight[j] * rim;
                cut[j] = weight[j] * mask;
            }
        }
        template <class F>
        LOMMEL_INLINE void each(const F& f) const {
            if (whole > 0) {
                f(0, mixed(head, 0));
            }
            for (std::size_t i = lanes; i < whole; i += lanes) {
                f(i, mixed(weight, i));
            }
            f(whole, mixed(cut, whole));
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

    // A vector of so many ones, then zeros.
    static const T* mask_at(std::size_t ones) {
        static const T masks[2 * beyond] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
        return masks + beyond - ones;
    }

    template <class I>
    LOMMEL_INLINE T gather(I, double position, const T* image, std::size_t y, std::size_t x) const {
        using Row = Rows<I>;
        using V = typename Row::V;
        const std::size_t wide = width_ + 2 * bank_.widest;
        const Mixture mixture = mixture_at(bank_, position);
        Row rows(bank_, mixture, 1.0);
        const T* below = image + (y + bank_.widest) * wide + x + bank_.widest - mixture.half;
        const T* above = below;
        V total = splat<V>(T(0));
        rows.each([&](std::size_t i, V mixed) LOMMEL_INLINE_LAMBDA { total = total + mixed * load<V>(below + i); });
        for (std::size_t row = 0; row < mixture.half; ++row) {
            if (row + 1 == mixture.half) {
                rows.at_rim();
            }
            rows.down(), below += wide, above -= wide;
            rows.each([&](std::size_t i, V mixed)
                          LOMMEL_INLINE_LAMBDA { total = total + mixed * (load<V>(below + i) + load<V>(above + i)); });
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
