// Spatially varying blur and its adjoint: each pixel spreads a PSF window interpolated between four windows of a bank.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/base/checkerboard.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/column.hpp"
#include "lommel/imaging/mixture.hpp"

namespace lommel {

// Positions of source pixels [height][width] in the window bank. Negative positions: no light is spread.
struct Scene {
    const double* positions;
    std::size_t height, width;
};

// Return whether all values are finite, by a sum of values times 0: inf or NaN times 0 is NaN.
inline bool all_finite(const double* values, std::size_t size) {
    double total = 0.0;
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using V = typename decltype(isa)::pack;
        constexpr std::size_t lanes = decltype(isa)::lanes;
        V sum[4] = {};
        std::size_t i = 0;
        for (; i + 4 * lanes <= size; i += 4 * lanes) {
            for (std::size_t j = 0; j < 4; ++j) {
                sum[j] = sum[j] + load<V>(values + i + j * lanes) * V{};
            }
        }
        total = lane_sum((sum[0] + sum[1]) + (sum[2] + sum[3]));
        for (; i < size; ++i) {
            total += values[i] * 0.0;
        }
    });
    return total == 0.0;
}

// Occlusion: a pixel sees the fraction clamp(seen - l, 0, 1) of a point in layer l: all of the point if l <= seen - 1, nothing
// if l >= seen, a fraction in between. Nearer layers have smaller l.
template <class T>
struct Screen {
    const T* layers = nullptr;  // indexed like Scene::positions; null: no occlusion
    const T* seen = nullptr;    // indexed like the output of forward()
};

// Blur by interpolated PSF windows: each source pixel adds its window to the image (forward) or takes the inner product of its
// window with the image (adjoint).
template <class T>
class Spreader {
   public:
    Spreader(const WindowBank<T>& bank, const Scene& scene, int threads, const Screen<T>& screen = {})
        : bank_(bank), scene_(scene), screen_(screen), height_(scene.height), width_(scene.width), threads_(threads),
          margin_(margin(bank.widest)), mixture_(bank) {}

    // `reach`: number of values in the longest vector. margin(): columns that vectors may access on either side of a pixel.
    static constexpr std::size_t reach = 16;
    static std::size_t margin(std::size_t widest) { return (widest / reach + 1) * reach; }

    // out[height + 2 widest][width + 2 margin()] += sum over source pixels of value x window; the image lies in the middle of
    // `out`. `image`: values, at the same pixels as Scene::positions, with row stride `down` and column stride `right`.
    void forward(const T* image, std::ptrdiff_t down, std::ptrdiff_t right, T* out) const;

    // Transpose of forward(): out[height][width] = inner product of the pixel's window and `image`. `image` has the layout of `out`
    // in forward().
    void adjoint(const T* image, T* out) const;

   private:
    // least_rows, least_columns: smallest tile (pixels); most_rows: tallest column of points whose sums stay in the cache.
    static constexpr std::size_t least_rows = 64, least_columns = 64, most_rows = 128;
    // Side of the squares of points tested for occlusion together: much smaller than a window, so that few tests are wasted.
    static constexpr std::size_t near = 8;
    static constexpr std::size_t line = 64;  // bytes of a cache line

    template <class Value>
    void spread_tile(std::size_t top, std::size_t bottom, std::size_t left, std::size_t right, const Value& value,
                     T* out) const {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            pixels(isa, top, bottom, left, right, value, Giving<decltype(isa), T>{out, screen_.seen});
        });
    }

    void collect_strip(std::size_t top, std::size_t bottom, const T* image, T* out) const {
        dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
            static constexpr T whole = T(1);
            const auto one = [](std::size_t, std::size_t) -> const T& { return whole; };
            pixels(isa, top, bottom, 0, width_, one, Taking<decltype(isa), T>{out, screen_.seen, image, width_});
        });
    }

    // Row stride of the image with margins.
    std::size_t across() const { return width_ + 2 * margin_; }

    // Points of a part of the image, copied row by row so that cache misses of many points overlap.
    struct Tile {
        static constexpr std::size_t broad = 64;
        explicit Tile(std::size_t tall, bool screened)
            : places((tall + 1) * broad), values(places.size()), layers(screened ? places.size() : 0), hidden(places.size()) {}

        std::size_t top, left, height, width;
        std::vector<BankPlace<T>> places;
        std::vector<T> values, layers;
        std::vector<unsigned char> hidden;  // [point]: some pixel sees only a fraction of the point
    };

    // Run the forward (`side`: Giving) or transposed (Taking) operator for all source pixels of a part of the image.
    template <class I, class Value, class Side>
    LOMMEL_INLINE void pixels(I isa, std::size_t top, std::size_t bottom, std::size_t left, std::size_t right,
                              const Value& value, const Side& side) const {
        constexpr std::size_t broad = Tile::broad;
        const std::size_t tall = std::min(most_rows, bottom - top);
        Tile tile(tall, screen_.layers != nullptr);
        std::vector<Mixture<T>> mixtures(tall + 1);
        Sheets<I, T> sheets(bank_, tall, across(), screen_.layers != nullptr);
        Glance glance;
        for (tile.top = top; tile.top < bottom; tile.top += tall) {
            for (tile.left = left; tile.left < right; tile.left += broad) {
                tile.height = std::min(tall, bottom - tile.top), tile.width = std::min(broad, right - tile.left);
                glance(tile.height * tile.width * (1 + bank_.widest * bank_.widest));
                place(value, tile);
                for (std::size_t j = 0; screen_.layers && j < tile.width; j += near) {
                    for (std::size_t i = 0; i < tile.height; i += near) {
                        look(isa, tile, i, std::min(near, tile.height - i), j, std::min(near, tile.width - j));
                    }
                }
                for (std::size_t j = 0; j < tile.width; ++j) {
                    one_column(isa, tile, j, mixtures.data(), sheets, side);
                }
            }
        }
    }

    template <class Value>
    LOMMEL_INLINE void place(const Value& value, Tile& tile) const {
        std::fill_n(tile.places.data() + tile.height * Tile::broad, Tile::broad, BankPlace<T>{-1, T(0)});
        for (std::size_t i = 0; i < tile.height; ++i) {
            const std::size_t at = (tile.top + i) * width_ + tile.left, next = std::min(tile.top + i + 2, height_ - 1);
            for (std::size_t j = 0; j < tile.width; j += line / sizeof(double)) {
                prefetch(scene_.positions + next * width_ + tile.left + j), prefetch(&value(next, tile.left + j));
            }
            T* const values = tile.values.data() + i * Tile::broad;
            for (std::size_t j = 0; j < tile.width; ++j) {
                values[j] = value(tile.top + i, tile.left + j);
            }
            for (std::size_t j = 0; j < tile.width; ++j) {
                tile.places[i * Tile::broad + j] = mixture_.place(scene_.positions[at + j], values[j]);
            }
            if (screen_.layers) {
                std::copy_n(screen_.layers + at, tile.width, tile.layers.data() + i * Tile::broad);
            }
        }
    }

    // Spread one column of points, two vertically adjacent points at a time unless occlusion separates them. Partly occluded
    // points come first, then pairs that use the same four windows of the bank, then others: fewer branches are mispredicted.
    template <class I, class Side>
    LOMMEL_INLINE void one_column(I, const Tile& tile, std::size_t x, Mixture<T>* points, Sheets<I, T>& sheets,
                                  const Side& side) const {
        enum Kind { alike, other, none };
        Column column{static_cast<std::ptrdiff_t>((tile.top + bank_.widest) * across() + margin_ + tile.left + x),
                      tile.top * width_ + tile.left + x,
                      0,
                      tile.height,
                      0,
                      false};
        std::size_t pairs[none + 1][(most_rows + 1) / 2], counts[none + 1] = {};
        Column hidden[most_rows + 1];  // runs of partly occluded points of one layer
        std::size_t layers = 0;
        const auto hide = [&](std::size_t first, std::size_t last) LOMMEL_INLINE_LAMBDA {
            const std::size_t half = std::max(points[first].half, points[last - 1].half);
            Column* const before = layers > 0 ? hidden + layers - 1 : nullptr;
            if (before && before->last == first && points[before->first].layer == points[first].layer) {
                before->last = last, before->half = std::max(before->half, half);
            } else {
                hidden[layers++] = {column.at, column.point, first, last, half, true};
            }
        };
        for (std::size_t i = 0; i < tile.height; i += 2) {
            for (std::size_t k = i; k < i + 2; ++k) {
                const std::size_t at = k * Tile::broad + x;
                mixture_(tile.places[at], tile.values[at], points[k]);
                points[k].layer = screen_.layers ? tile.layers[at] : T(0);
                points[k].hidden = points[k].any && tile.hidden[at];
            }
            const Mixture<T>&one = points[i], &next = points[i + 1];
            const bool any = one.any || next.any;
            column.half = std::max<std::size_t>(column.half, std::max(one.half, next.half));
            if (!one.hidden && !next.hidden) {
                const Kind kind = !any ? none : one.first == next.first ? alike : other;
                pairs[kind][counts[kind]++] = i;
            } else if (one.layer == next.layer) {
                hide(i, std::min(i + 2, tile.height));
            } else {
                for (std::size_t k = i; k < i + 2; ++k) {
                    if (points[k].any) {
                        hide(k, k + 1);
                    }
                }
            }
        }
        if (2 * counts[none] >= tile.height) {
            return;
        }
        column.hidden = layers > 0;
        side.open(sheets, column);
        const auto add = [&](auto count, auto same, std::size_t i) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t together = decltype(count)::value;
            const std::size_t half = std::max(points[i].half, points[i + together - 1].half);
            each_block<I, together, decltype(same)::value>(
                bank_, points + i, half, [&](const auto& rows) LOMMEL_INLINE_LAMBDA { side.add(sheets, i, rows); });
        };
        constexpr std::integral_constant<std::size_t, 1> one{};
        constexpr std::integral_constant<std::size_t, 2> two{};
        constexpr std::true_type yes{};
        constexpr std::false_type no{};
        for (std::size_t k = 0; k < layers; ++k) {
            const Column& run = hidden[k];
            const T layer = points[run.first].layer;
            side.before(sheets, run, layer);
            std::size_t i = run.first;
            for (; i + 1 < run.last; i += 2) {
                if (points[i].first == points[i + 1].first) {
                    add(two, yes, i);
                } else {
                    add(two, no, i);
                }
            }
            if (i < run.last) {
                add(one, yes, i);
            }
            side.after(sheets, run, layer);
        }
        if (counts[alike] + counts[other] > 0) {
            side.rest(sheets, column);
        }
        for (std::size_t k = 0; k < counts[alike]; ++k) {
            add(two, yes, pairs[alike][k]);
        }
        for (std::size_t k = 0; k < counts[other]; ++k) {
            add(two, no, pairs[other][k]);
        }
        side.close(sheets, column);
    }

    // Test a square of neighbouring points against the extremes of `seen` over all pixels that their windows reach: drop points
    // that no pixel sees, and mark those that some pixel sees only in part. Most points are neither dropped nor marked, and
    // cost the same as without occlusion.
    template <class I>
    LOMMEL_INLINE void look(I, Tile& tile, std::size_t down, std::size_t height, std::size_t along, std::size_t width) const {
        using V = Packed<I, T>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(T);
        std::size_t half = 0;
        bool any = false;
        const auto each = [&](const auto& visit) LOMMEL_INLINE_LAMBDA {
            for (std::size_t i = down; i < down + height; ++i) {
                for (std::size_t j = along; j < along + width; ++j) {
                    visit(i * Tile::broad + j);
                }
            }
        };
        each([&](std::size_t at) LOMMEL_INLINE_LAMBDA {
            const std::int32_t first = tile.places[at].first;
            half = first < 0 ? half : std::max<std::size_t>(half, mixture_.half(first));
            any = any || first >= 0;
        });
        if (!any) {
            return;
        }
        const std::size_t y = tile.top + down, x = tile.left + along;
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
        each([&](std::size_t at) LOMMEL_INLINE_LAMBDA {
            tile.places[at].first = tile.layers[at] < high ? tile.places[at].first : -1;
            tile.hidden[at] = tile.layers[at] + T(1) > low;
        });
    }

    WindowBank<T> bank_;
    Scene scene_;
    Screen<T> screen_;
    std::size_t height_, width_;
    int threads_;
    std::size_t margin_;
    Mixer<T> mixture_;
};

template <class T>
void Spreader<T>::forward(const T* image, std::ptrdiff_t down, std::ptrdiff_t right, T* out) const {
    const std::size_t tall = std::max(least_rows, 2 * bank_.widest), broad = std::max(least_columns, 2 * margin_);
    const auto value = [&](std::size_t y, std::size_t x) -> const T& {
        return image[static_cast<std::ptrdiff_t>(y) * down + static_cast<std::ptrdiff_t>(x) * right];
    };
    // Tiles are at least as large as the area that a pixel spreads to, so that the light of alternate tiles does not overlap.
    const Checkerboard tiles((height_ + tall - 1) / tall, (width_ + broad - 1) / broad);
    tiles.each(threads_, [&](std::size_t row, std::size_t column) {
        const std::size_t y = row * tall, x = column * broad;
        spread_tile(y, std::min(height_, y + tall), x, std::min(width_, x + broad), value, out);
    });
}

template <class T>
void Spreader<T>::adjoint(const T* image, T* out) const {
    std::fill_n(out, height_ * width_, T(0));
    parallel_for((height_ + least_rows - 1) / least_rows, threads_, [&](std::size_t, std::size_t task) {
        const std::size_t top = task * least_rows;
        collect_strip(top, std::min(height_, top + least_rows), image, out);
    });
}

#if defined(LOMMEL_COMPILED)
extern template class Spreader<float>;
extern template class Spreader<double>;
#endif

}  // namespace lommel
