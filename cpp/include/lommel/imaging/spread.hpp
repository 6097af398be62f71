// Blur that varies from pixel to pixel: every source pixel spreads its own window, a mixture of four of a bank.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/mixture.hpp"

namespace lommel {

// The pixels that spread their windows, [height][width]: where each is in the bank, row and column of `positions` being
// rows[y] and columns[x], so that what lies beyond the edges of an image need not be copied. Those below 0 take no part.
struct Scene {
    const double* positions;
    std::size_t across;
    const std::int64_t *rows, *columns;
    std::size_t height, width;
};

// Points that hide others: of what one of layer l spreads, a pixel sees the share `seen - l`, from 0 to 1. That is all of the
// layers before `seen`, a part of the one that it lies in, and nothing of those behind.
template <class T>
struct Screen {
    const T* layers = nullptr;  // as positions; without them nothing is hidden
    const T* seen = nullptr;    // as what is written to
};

template <class T>
class Spreader {
   public:
    Spreader(const WindowBank<T>& bank, const Scene& scene, int threads, const Screen<T>& screen = {})
        : bank_(bank), scene_(scene), screen_(screen), height_(scene.height), width_(scene.width), threads_(threads),
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
    // Points that are looked at together: few beside the pixels that they reach.
    static constexpr std::size_t near = 8;

    template <class Value>
    void spread_tile(std::size_t top, std::size_t bottom, std::size_t left, std::size_t right, const Value& value,
                     T* out) const {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            pixels(isa, top, bottom, left, right, value,
                   [&](const auto& rows, std::size_t y, std::size_t x) LOMMEL_INLINE_LAMBDA {
                       const std::ptrdiff_t step = width_ + 2 * margin_, middle = at(y, x);
                       rows.each([&](std::ptrdiff_t row, const auto* mixed)
                                     LOMMEL_INLINE_LAMBDA { rows.add(out, screen_.seen, middle + row * step, mixed); });
                   });
        });
    }

    void collect_strip(std::size_t top, std::size_t bottom, const T* image, T* out) const {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            pixels(
                isa, top, bottom, 0, width_, [](std::size_t, std::size_t) { return T(1); },
                [&](const auto& rows, std::size_t y, std::size_t x) LOMMEL_INLINE_LAMBDA {
                    using Here = std::decay_t<decltype(rows)>;
                    typename Here::V total[Here::points] = {};
                    const std::ptrdiff_t step = width_ + 2 * margin_, middle = at(y, x);
                    rows.each([&](std::ptrdiff_t row, const auto* mixed)
                                  LOMMEL_INLINE_LAMBDA { rows.take(image, screen_.seen, middle + row * step, mixed, total); });
                    rows.sum(total, out + y * width_ + x, width_);
                });
        });
    }

    // Where a pixel of the scene is in an image that windows reach beyond.
    std::ptrdiff_t at(std::size_t y, std::size_t x) const {
        return static_cast<std::ptrdiff_t>((y + bank_.widest) * (width_ + 2 * margin_) + margin_ + x);
    }

    // Calls visit(rows, y, x) for all blocks of columns of all pixels of a part of the image, of two below each other at once
    // where their windows are as wide and share three of four or more. Down, not across: a sum that has just been stored is
    // loaded again from the same address, which a processor does at once, whereas it waits for one that was stored across.
    // Mixtures are made across, some beforehand: so their loads and divisions need not wait for one another.
    template <class I, class Value, class Visit>
    LOMMEL_INLINE void pixels(I isa, std::size_t top, std::size_t bottom, std::size_t left, std::size_t right,
                              const Value& value, const Visit& visit) const {
        constexpr std::size_t tall = 32, broad = 64;
        std::vector<Mixture<T>> mixtures(broad * (tall + 1));  // more than the stack of a thread need hold
        Glance glance;
        for (std::size_t y = top; y < bottom; y += tall) {
            for (std::size_t x = left; x < right; x += broad) {
                const std::size_t height = std::min(tall, bottom - y), width = std::min(broad, right - x);
                glance(height * width * (1 + bank_.widest * bank_.widest));
                for (std::size_t i = 0; i < height; ++i) {
                    const std::size_t row = static_cast<std::size_t>(scene_.rows[y + i]) * scene_.across;
                    for (std::size_t j = 0; j < width; ++j) {
                        const std::size_t from = row + static_cast<std::size_t>(scene_.columns[x + j]);
                        Mixture<T>& made = mixtures[j * (tall + 1) + i];
                        mixture_(scene_.positions[from], value(y + i, x + j), made);
                        made.layer = screen_.layers ? screen_.layers[from] : T(0);
                        made.hidden = false;
                    }
                }
                for (std::size_t j = 0; screen_.layers && j < width; j += near) {
                    for (std::size_t i = 0; i < height; i += near) {
                        look(isa, mixtures.data() + j * (tall + 1) + i, tall + 1, y + i, std::min(near, height - i), x + j,
                             std::min(near, width - j));
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

    template <class I>
    using Packed = std::conditional_t<sizeof(T) == 4, typename I::floats, typename I::pack>;

    // Of points next to each other, [column][row], leaves out those that no pixel sees which one of them reaches, and finds
    // those that not all pixels see: most of a scene is neither, and costs no more than where nothing is hidden.
    template <class I>
    LOMMEL_INLINE void look(I, Mixture<T>* points, std::size_t stride, std::size_t y, std::size_t height, std::size_t x,
                            std::size_t width) const {
        using V = Packed<I>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        std::size_t half = 0;
        bool any = false;
        for (std::size_t j = 0; j < width; ++j) {
            for (std::size_t i = 0; i < height; ++i) {
                const Mixture<T>& point = points[j * stride + i];
                half = point.any ? std::max<std::size_t>(half, point.half) : half;
                any = any || point.any;
            }
        }
        if (!any) {
            return;
        }
        const std::size_t wide = width_ + 2 * margin_, left = margin_ + x - half, right = margin_ + x + width + half;
        const std::size_t top = bank_.widest + y - half, bottom = bank_.widest + y + height + half;
        V least = splat<V>(screen_.seen[top * wide + left]), most = least;
        for (std::size_t row = top; row < bottom; ++row) {
            for (std::size_t column = left; column < right; column += lanes) {
                const V seen = load<V>(screen_.seen + row * wide + std::min(column, wide - lanes));
                least = smaller(least, seen), most = larger(most, seen);
            }
        }
        T low = least[0], high = most[0];
        for (std::size_t i = 1; i < lanes; ++i) {
            low = std::min(low, least[i]), high = std::max(high, most[i]);
        }
        for (std::size_t j = 0; j < width; ++j) {
            for (std::size_t i = 0; i < height; ++i) {
                Mixture<T>& point = points[j * stride + i];
                point.any = point.any && point.layer < high;
                point.hidden = point.layer + T(1) > low;
            }
        }
    }

    template <class I, std::size_t Points, class Visit>
    LOMMEL_INLINE void blocks(const Mixture<T>* points, const Visit& visit) const {
        using V = Packed<I>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        const auto visited = [&](auto hiding) LOMMEL_INLINE_LAMBDA {
            constexpr bool Hiding = decltype(hiding)::value;
            if (points->half < lanes / 2) {
                return visit(Rows<V, Points, Whole, Hiding>(bank_, points, 0));
            }
            visit(Rows<V, Points, Beside, Hiding>(bank_, points, 0));
            for (std::size_t from = lanes; from <= points->half; from += lanes) {
                visit(Rows<V, Points, Beyond, Hiding>(bank_, points, from));
            }
        };
        points[0].hidden || points[Points - 1].hidden ? visited(std::true_type{}) : visited(std::false_type{});
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
    template <class Vec, std::size_t Points, class Left, bool Hiding>
    struct Rows {
        using V = Vec;
        static constexpr bool whole = std::is_same_v<Left, Whole>;
        static constexpr std::size_t points = Points, lanes = sizeof(V) / sizeof(T), windows = Points + 3;
        static_assert(lanes <= reach, "room for a vector");
        const T* windows_at[windows];
        std::size_t stride, half;
        std::ptrdiff_t right, left;  // from the pixel to where the vectors begin
        V weight[Points][windows], last[Points], beside, layer[Points], all;
        bool apart;  // in two layers

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
                layer[p] = splat<V>(pixels[p].layer);
                const V share = splat<V>(pixels[p].rim), cut = within + rim * share;
                last[p] = within * share + rim;
                for (std::size_t j = 0; j < windows; ++j) {
                    weight[p][j] = splat<V>(weights[j]) * cut;
                }
            }
            apart = Hiding && pixels[0].layer != pixels[Points - 1].layer;
            all = splat<V>(T(1));
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

        LOMMEL_INLINE void add(T* out, const T* seen, std::ptrdiff_t at, const V* mixed) const {
            const V both = Points == 2 && !apart ? mixed[0] + mixed[Points - 1] : mixed[0];
            V there = hidden(whole ? both : permuted<Left, T>(both) * beside, seen, at + left, 0);
            V here = whole ? both : hidden(both, seen, at + right, 0);
            if (apart) {
                const V other = mixed[Points - 1];
                there = there + hidden(whole ? other : permuted<Left, T>(other) * beside, seen, at + left, Points - 1);
                here = whole ? other : here + hidden(other, seen, at + right, Points - 1);
            }
            store(out + (at + left), load<V>(out + (at + left)) + there);
            if (!whole) {
                store(out + (at + right), load<V>(out + (at + right)) + here);
            }
        }

        LOMMEL_INLINE void take(const T* image, const T* seen, std::ptrdiff_t at, const V* mixed, V* total) const {
            V both;
            for (std::size_t p = 0; p < Points; ++p) {
                if (p == 0 || apart) {
                    both = hidden(load<V>(image + (at + left)), seen, at + left, p);
                    if (!whole) {
                        both = hidden(load<V>(image + (at + right)), seen, at + right, p) + permuted<Left, T>(both) * beside;
                    }
                }
                total[p] = total[p] + mixed[p] * both;
            }
        }

        // What pixels see of what a point spreads.
        LOMMEL_INLINE V hidden(V light, const T* seen, std::ptrdiff_t at, std::size_t p) const {
            if constexpr (Hiding) {
                return light * smaller(larger(load<V>(seen + at) - layer[p], V{}), all);
            }
            return light;
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
    Screen<T> screen_;
    std::size_t height_, width_;
    int threads_;
    std::size_t margin_;
    Mixer<T> mixture_;
};

}  // namespace lommel
