// Blur that varies from pixel to pixel: every source pixel spreads its own window, a mixture of four of a bank.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Windows of 2 widest + 1 pixels a side, equally spaced in defocus, alike in their four quadrants. Of window i the
// pixels up to halves[i] from the middle are used, and of the ring at k the share halves[i] + 1 - k, from 0 to 1; between two
// windows the half width is interpolated, so that what is used never jumps. energies[i][half] is the sum of window i up to a
// whole half width: the mixture is divided by what is used of it.
template <class T>
struct WindowBank {
    const T* windows;  // [window and one more][row from the middle one down][column from the middle one on, zeros last]
    const double* halves;  // [window]
    const double* energies;  // [window][widest + 1]
    std::size_t count, widest, stride;

    std::size_t room() const { return (widest + 1) * stride; }
};

// The four windows of a pixel, from `first`, and their weights: cubic Lagrange in the middle interval, divided by the sum. Up
// to `half` pixels from the middle are used, of the last ring the share `rim`.
template <class T>
struct Mixture {
    std::uint32_t first, half;
    T rim, weights[4];
    bool any;  // else nothing is spread
};

// Makes mixtures of a bank, whose energies it keeps in such a sequence that those of four windows are a vector.
template <class T>
class Mixer {
   public:
    explicit Mixer(const WindowBank<T>& bank)
        : halves_(bank.halves), last_(static_cast<std::ptrdiff_t>(bank.count) - 1), energies_((bank.widest + 2) * bank.count) {
        for (std::size_t half = 0; half <= bank.widest; ++half) {
            for (std::size_t i = 0; i < bank.count; ++i) {
                energies_[(half + 1) * bank.count + i] = static_cast<T>(bank.energies[i * (bank.widest + 1) + half]);
            }
        }
    }

    LOMMEL_INLINE void operator()(double position, T value, Mixture<T>& m) const {
        m.any = !(position < 0.0) && value != T(0);
        if (!m.any) {
            return;
        }
        // Of whole numbers with a sign, which processors make of others faster.
        const double inside = std::min(position, static_cast<double>(last_));
        const std::ptrdiff_t interval = std::min(static_cast<std::ptrdiff_t>(inside), last_ - 1);
        const std::ptrdiff_t first = std::min(std::max<std::ptrdiff_t>(interval - 1, 0), last_ - 3);
        const double part = inside - static_cast<double>(interval);
        const double wide = (1.0 - part) * halves_[interval] + part * halves_[interval + 1];
        const std::ptrdiff_t half = static_cast<std::ptrdiff_t>(std::ceil(wide));
        m.first = static_cast<std::uint32_t>(first), m.half = static_cast<std::uint32_t>(half);
        m.rim = static_cast<T>(wide + 1.0 - static_cast<double>(half));
        const V t = splat<V>(static_cast<T>(inside - static_cast<double>(first)));
        const V weights = load<V>(powers[0]) + t * (load<V>(powers[1]) + t * (load<V>(powers[2]) + t * load<V>(powers[3])));
        const T* energy = energies_.data() + half * (last_ + 1) + first;
        const V held = weights * (splat<V>(m.rim) * load<V>(energy + last_ + 1) + splat<V>(T(1) - m.rim) * load<V>(energy));
        store(m.weights, weights * splat<V>(value / ((held[0] + held[1]) + (held[2] + held[3]))));
    }

   private:
    using V = std::conditional_t<sizeof(T) == 4, typename Vector<2>::floats, typename Vector<4>::pack>;
    static constexpr T powers[4][4] = {{T(1), T(0), T(0), T(0)},
                                       {T(-11.0 / 6.0), T(3), T(-1.5), T(1.0 / 3.0)},
                                       {T(1), T(-2.5), T(2), T(-0.5)},
                                       {T(-1.0 / 6.0), T(0.5), T(-0.5), T(1.0 / 6.0)}};
    const double* halves_;
    std::ptrdiff_t last_;
    std::vector<T, AlignedAllocator<T>> energies_;  // [half width, before the first one zeros][window]
};

// The pixels that spread their windows, [height][width]: where each is in the bank, row and column of `positions` being
// rows[y] and columns[x], so that what lies beyond the edges of an image need not be copied. Those below 0 take no part.
struct Scene {
    const double* positions;
    std::size_t across;
    const std::int64_t *rows, *columns;
    std::size_t height, width;
};

template <class T>
class Spreader {
   public:
    Spreader(const WindowBank<T>& bank, const Scene& scene, int threads)
        : bank_(bank), scene_(scene), height_(scene.height), width_(scene.width), threads_(threads),
          margin_(margin(bank.widest)), mixture_(bank) {}

    // Values in the longest vector; columns that vectors reach to on either side of a pixel.
    static constexpr std::size_t reach = 16;
    static std::size_t margin(std::size_t widest) { return (widest / reach + 1) * reach; }

    // out += sum over source pixels of value times window, in an image that is `widest` larger above and below and margin()
    // on either side: [height + 2 widest][width + 2 margin]. Of tiles no smaller than what a pixel writes to, those of one
    // parity do not meet: the threads write side by side, and every sum is in the same sequence however many. The image is
    // as large as `positions`, its values `down` and `right` apart.
    void forward(const T* image, std::ptrdiff_t down, std::ptrdiff_t right, T* out) const {
        const std::size_t tall = std::max(least_rows, 2 * bank_.widest), broad = std::max(least_columns, 2 * margin_);
        const std::size_t tiles = (height_ + tall - 1) / tall, across = (width_ + broad - 1) / broad;
        const auto value = [&](std::size_t y, std::size_t x) {
            return image[scene_.rows[y] * down + scene_.columns[x] * right];
        };
        for (std::size_t parity = 0; parity < 4; ++parity) {
            const std::size_t top = parity / 2, left = parity % 2;
            const std::size_t rows = (tiles + 1 - top) / 2, columns = (across + 1 - left) / 2;
            parallel_for(rows * columns, threads_, [&](std::size_t, std::size_t task) {
                const std::size_t y = (2 * (task / columns) + top) * tall, x = (2 * (task % columns) + left) * broad;
                spread_tile(y, std::min(height_, y + tall), x, std::min(width_, x + broad), value, out);
            });
        }
    }

    // The transpose: each source pixel takes the sum of window times `image`, which has the size of forward's output; `out` is
    // [height][width].
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

    template <class Value>
    void spread_tile(std::size_t top, std::size_t bottom, std::size_t left, std::size_t right, const Value& value,
                     T* out) const {
        const std::size_t wide = width_ + 2 * margin_;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            pixels(isa, top, bottom, left, right, value,
                   [&](const auto& rows, std::size_t y, std::size_t x) LOMMEL_INLINE_LAMBDA {
                       T* const middle = out + (y + bank_.widest) * wide + margin_ + x;
                       rows.each([&, step = static_cast<std::ptrdiff_t>(wide)](std::ptrdiff_t row, const auto* mixed)
                                     LOMMEL_INLINE_LAMBDA { rows.add(middle + row * step, mixed); });
                   });
        });
    }

    void collect_strip(std::size_t top, std::size_t bottom, const T* image, T* out) const {
        const std::size_t wide = width_ + 2 * margin_;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            pixels(
                isa, top, bottom, 0, width_, [](std::size_t, std::size_t) { return T(1); },
                [&](const auto& rows, std::size_t y, std::size_t x) LOMMEL_INLINE_LAMBDA {
                    using Here = std::decay_t<decltype(rows)>;
                    typename Here::V total[Here::points] = {};
                    const T* const middle = image + (y + bank_.widest) * wide + margin_ + x;
                    rows.each([&, step = static_cast<std::ptrdiff_t>(wide)](std::ptrdiff_t row, const auto* mixed)
                                  LOMMEL_INLINE_LAMBDA { rows.take(middle + row * step, mixed, total); });
                    rows.sum(total, out + y * width_ + x, width_);
                });
        });
    }

    // Calls visit(rows, y, x) for all blocks of columns of all pixels of a part of the image, of two below each other at once
    // where their windows are as wide and share three of four or more. Down, not across: a sum that has just been stored is
    // loaded again from the same address, which a processor does at once, whereas it waits for one that was stored across.
    // Mixtures are made across, some beforehand: so their loads and divisions need not wait for one another.
    template <class I, class Value, class Visit>
    LOMMEL_INLINE void pixels(I, std::size_t top, std::size_t bottom, std::size_t left, std::size_t right, const Value& value,
                              const Visit& visit) const {
        constexpr std::size_t tall = 32, broad = 64;
        std::vector<Mixture<T>> mixtures(broad * (tall + 1));  // more than the stack of a thread need hold
        Glance glance;
        for (std::size_t y = top; y < bottom; y += tall) {
            for (std::size_t x = left; x < right; x += broad) {
                const std::size_t height = std::min(tall, bottom - y), width = std::min(broad, right - x);
                glance(height * width * (1 + bank_.widest * bank_.widest));
                for (std::size_t i = 0; i < height; ++i) {
                    const double* positions = scene_.positions + static_cast<std::size_t>(scene_.rows[y + i]) * scene_.across;
                    for (std::size_t j = 0; j < width; ++j) {
                        mixture_(positions[scene_.columns[x + j]], value(y + i, x + j), mixtures[j * (tall + 1) + i]);
                    }
                }
                for (std::size_t j = 0; j < width; ++j) {
                    Mixture<T>* const column = mixtures.data() + j * (tall + 1);
                    column[height].any = false;
                    for (std::size_t i = 0; i < height; ++i) {
                        const Mixture<T>*const one = column + i, *const next = one + 1;
                        if (one->any && next->any && one->half == next->half && one->first <= next->first + 1 &&
                            next->first <= one->first + 1) {
                            blocks<I, 2>(one, [&](const auto& rows) LOMMEL_INLINE_LAMBDA { visit(rows, y + i, x + j); });
                            ++i;
                        } else if (one->any) {
                            blocks<I, 1>(one, [&](const auto& rows) LOMMEL_INLINE_LAMBDA { visit(rows, y + i, x + j); });
                        }
                    }
                }
            }
        }
    }

    template <class I, std::size_t Points, class Visit>
    LOMMEL_INLINE void blocks(const Mixture<T>* points, const Visit& visit) const {
        using V = std::conditional_t<sizeof(T) == 4, typename I::floats, typename I::pack>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        if (points->half < lanes / 2) {
            return visit(Rows<V, Points, Whole>(bank_, points, 0));
        }
        visit(Rows<V, Points, Beside>(bank_, points, 0));
        for (std::size_t from = lanes; from <= points->half; from += lanes) {
            visit(Rows<V, Points, Beyond>(bank_, points, from));
        }
    }

    // Which column of a window, counted from the middle one on, is where in a vector: in one across the middle, in the one to
    // the left of it, and farther to the left.
    struct Whole {
        static constexpr std::size_t at(std::size_t i, std::size_t lanes) {
            return i < lanes / 2 ? lanes / 2 - i : i - lanes / 2;
        }
    };
    struct Beside {
        static constexpr std::size_t at(std::size_t i, std::size_t lanes) { return (lanes - i) % lanes; }
    };
    struct Beyond {
        static constexpr std::size_t at(std::size_t i, std::size_t lanes) { return lanes - 1 - i; }
    };

    // Rows of the windows of one pixel, or of two below each other, a vector of columns on either side of the middle: all of
    // what the rows above and below, left and right share is loaded and mixed once. Bound by loads and stores.
    template <class Vec, std::size_t Points, class Left>
    struct Rows {
        using V = Vec;
        static constexpr bool whole = std::is_same_v<Left, Whole>;
        static constexpr std::size_t points = Points, lanes = sizeof(V) / sizeof(T), windows = Points + 3;
        static_assert(lanes <= reach, "room for a vector");
        const T* windows_at[windows];
        std::size_t stride, half;
        std::ptrdiff_t right, left;  // from the pixel to where the vectors begin
        V weight[Points][windows], last[Points], beside;

        LOMMEL_INLINE Rows(const WindowBank<T>& bank, const Mixture<T>* pixels, std::size_t from)
            : stride(bank.stride), half(pixels->half), right(static_cast<std::ptrdiff_t>(from)),
              left(-right - static_cast<std::ptrdiff_t>(whole ? lanes / 2 : lanes - (from > 0 ? 1 : 0))) {
            const std::size_t inner = std::min(half - from, lanes), used = std::min(half + 1 - from, lanes);
            const V within = load<V>(mask(inner)), rim = load<V>(mask(used)) - within;
            const std::size_t first = std::min(pixels[0].first, pixels[Points - 1].first);
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
            beside = load<V>(mask(lanes)) - load<V>(mask(from > 0 ? 0 : 1));
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
                if (row == half) {
                    mixed[p] = mixed[p] * last[p];
                }
                if (whole) {
                    mixed[p] = permuted<Left, T>(mixed[p]);
                }
            }
        }

        LOMMEL_INLINE void add(T* to, const V* mixed) const {
            V sum = mixed[0];
            if (Points == 2) {
                sum = sum + mixed[Points - 1];
            }
            if (whole) {
                return store(to + left, load<V>(to + left) + sum);
            }
            const V here = load<V>(to + right) + sum, there = load<V>(to + left) + permuted<Left, T>(sum) * beside;
            store(to + left, there);
            store(to + right, here);
        }

        LOMMEL_INLINE void take(const T* from, const V* mixed, V* total) const {
            V both = load<V>(from + left);
            if (!whole) {
                both = load<V>(from + right) + permuted<Left, T>(both) * beside;
            }
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

        // So many ones, then zeros.
        static const T* mask(std::size_t ones) {
            static const T masks[2 * reach] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
            return masks + reach - ones;
        }
    };

    WindowBank<T> bank_;
    Scene scene_;
    std::size_t height_, width_;
    int threads_;
    std::size_t margin_;
    Mixer<T> mixture_;
};

}  // namespace lommel
