// Blur with occlusion: layers are composed front to back, each weighted by the fraction of the aperture that nearer layers do
// not cover.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/checkerboard.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/column.hpp"
#include "lommel/imaging/mixture.hpp"
#include "lommel/imaging/spread.hpp"

namespace lommel {

// Points of a scene in layers. layers[p]: layer of pixel p, 0 the nearest; behind[p]: index of the pixel whose light stands for the light that p occludes, negative if none.
struct LayeredScene {
    Scene scene;
    const std::uint8_t* layers;
    const std::int32_t* behind;  // null: no point has a representative for occluded light
    std::size_t count;  // number of layers, at most 64
};

// Images [height][width]. seen: visibility; a pixel sees the fraction clamp(seen - l, 0, 1) of the
// layer of level l (Compositor::level()); total: fraction of the aperture covered so far; out: blurred light.
template <class T>
struct Composite {
    T *seen, *total;
    T* out;  // null: no image is computed
};

// Add the light of points to `light` and, if `Cover`, their coverage (the light of a white scene) to `white`. Products are
// rounded before they are added, so that both values of `Cover` give identical bits: otherwise a compiler might fuse product
// and sum for only one of them.
template <class I, class T, bool Cover>
struct GivingLight {
    T *white, *light;
    const T* values;  // light of each point of the column

    template <class R>
    LOMMEL_INLINE void add(Sheets<I, T>& sheets, std::size_t point, const R& rows) const {
        using W = typename R::V;
        W value[R::points], above[R::points], below[R::points];
        for (std::size_t p = 0; p < R::points; ++p) {
            value[p] = splat<W>(values[point + p]);
        }
        const auto to = [&](std::ptrdiff_t row, W cover, W sum) LOMMEL_INLINE_LAMBDA {
            const std::size_t at = sheets.place(static_cast<std::ptrdiff_t>(point) + row, rows.from);
            if constexpr (Cover) {
                store(sheets.both() + at, load<W>(sheets.both() + at) + cover);
            }
            store(sheets.right() + at, load<W>(sheets.right() + at) + sum);
        };
        rows.mix(0, above);
        if constexpr (R::points == 1) {
            to(0, above[0], loaded(above[0] * value[0]));
            for (std::size_t row = 1; row <= rows.half; ++row) {
                rows.mix(row, above);
                const W middle = loaded(above[0] * value[0]);
                to(static_cast<std::ptrdiff_t>(row), above[0], middle), to(-static_cast<std::ptrdiff_t>(row), above[0], middle);
            }
        } else {
            // Row r below the first point is row r - 1 below the next one; row r above the first is row r + 1 above the next.
            W first = loaded(above[0] * value[0]), second = loaded(above[1] * value[1]);
            for (std::size_t row = 0; row < rows.half; ++row) {
                rows.mix(row + 1, below);
                const W next = loaded(below[0] * value[0]), other = loaded(below[1] * value[1]);
                to(static_cast<std::ptrdiff_t>(row) + 1, below[0] + above[1], next + second);
                to(-static_cast<std::ptrdiff_t>(row), above[0] + below[1], first + other);
                above[0] = below[0], above[1] = below[1], first = next, second = other;
            }
            to(static_cast<std::ptrdiff_t>(rows.half) + 1, above[1], second);
            to(-static_cast<std::ptrdiff_t>(rows.half), above[0], first);
        }
    }

    LOMMEL_INLINE void close(Sheets<I, T>& sheets, const Column& column) const {
        sheets.each(column,
                    [&](std::size_t at, std::ptrdiff_t right, std::ptrdiff_t left, auto middle_mask) LOMMEL_INLINE_LAMBDA {
                        using W = decltype(middle_mask);
                        if constexpr (Cover) {
                            onto<W>(white, sheets.both() + at, right, left, middle_mask);
                        }
                        onto<W>(light, sheets.right() + at, right, left, middle_mask);
                    });
    }

   private:
    // Add `sum` to `out` at `right` and, mirrored, at `left`. Both vectors of `out` contain the middle column, to which it must be
    // added once: at `right`, which is stored last.
    template <class W>
    static LOMMEL_INLINE void onto(T* out, T* sum, std::ptrdiff_t right, std::ptrdiff_t left, W middle_mask) {
        const W value = load<W>(sum), here = load<W>(out + right) + value;
        store(sum, W{});
        store(out + left, load<W>(out + left) + permuted<typename Sheets<I, T>::Mirror, T>(value * middle_mask));
        store(out + right, here);
    }
};

// Composition of the layers of a scene front to back: visibility of each layer at each pixel, and sum of the blurred light.
template <class T>
class Compositor {
   public:
    // `image`: light of the points, with row stride `down` and column stride `right`; null: compute only the visibility.
    Compositor(const WindowBank<T>& bank, const LayeredScene& layered, int threads, const T* image, std::ptrdiff_t down,
               std::ptrdiff_t right);

    // Add layers from .. to - 1 to `made`. If `known`, the visibility made.seen is an input. Otherwise it is computed: before
    // the first layer, made.seen must be beyond() and made.total must be 0.
    void operator()(std::size_t from, std::size_t to, bool known, const Composite<T>& made);

    // level(): layer number relative to the middle layer. Small levels leave more bits of the visibility (Composite::seen) for
    // the fraction of a layer that a pixel sees. beyond(): visibility at a pixel that sees all layers.
    T level(std::size_t layer) const { return static_cast<T>(static_cast<std::ptrdiff_t>(layer) - middle()); }
    T beyond() const { return level(layered_.count); }

   private:
    static constexpr std::size_t least_rows = 64, least_columns = 64, most_rows = 128, part_width = 64;

    std::ptrdiff_t middle() const { return static_cast<std::ptrdiff_t>(layered_.count / 2); }
    std::size_t across() const { return scene_.width + 2 * margin_; }
    std::size_t part_columns() const { return (broad_ + part_width - 1) / part_width; }

    // Part of a tile, in pixels of the scene; a tile is a rectangle of the scene that one thread processes at a time. Parts are so
    // small that the sums of a column of points stay in the cache.
    struct Part {
        std::size_t top, left, height, width;
    };

    // Half-open range of rows and columns of the scene, which may extend beyond it; empty if bottom <= top or right <= left.
    struct Box {
        std::ptrdiff_t top, left, bottom, right;

        void include(const Box& other) {
            top = std::min(top, other.top), left = std::min(left, other.left);
            bottom = std::max(bottom, other.bottom), right = std::max(right, other.right);
        }
        Box within(const Box& other) const {
            return {std::max(top, other.top), std::max(left, other.left), std::min(bottom, other.bottom),
                    std::min(right, other.right)};
        }
        static constexpr Box empty() {
            constexpr std::ptrdiff_t far = std::numeric_limits<std::ptrdiff_t>::max();
            return {far, far, -far, -far};
        }
    };

    // Bounding box, in rows and columns of a part of a tile, of the points of one layer; bottom and right are exclusive.
    struct Extent {
        std::uint8_t top, left, bottom, right;

        void include(std::size_t y, std::size_t x) {
            const auto row = static_cast<std::uint8_t>(y), column = static_cast<std::uint8_t>(x);
            top = std::min(top, row), bottom = std::max(bottom, static_cast<std::uint8_t>(row + 1));
            left = std::min(left, column), right = std::max(right, static_cast<std::uint8_t>(column + 1));
        }
    };
    static_assert(most_rows < 256 && part_width < 256, "extents are bytes");

    template <class F>
    LOMMEL_INLINE void each_part(std::size_t row, std::size_t column, const F& f) const {
        const std::size_t bottom = std::min(scene_.height, (row + 1) * tall_);
        const std::size_t end = std::min(scene_.width, (column + 1) * broad_);
        std::size_t at = (row * columns_ + column) * parts_ * part_columns();
        for (std::size_t top = row * tall_; top < (row + 1) * tall_; top += most_rows) {
            for (std::size_t left = column * broad_; left < (column + 1) * broad_; left += part_width, ++at) {
                if (top < bottom && left < end) {
                    f(at, Part{top, left, std::min(most_rows, bottom - top), std::min(part_width, end - left)});
                }
            }
        }
    }

    std::size_t point(std::size_t y, std::size_t x) const { return y * scene_.width + x; }

    // For each part of a tile, find the layers of its points, as a bit mask, and the bounding box of each layer.
    void mark() {
        parallel_for(rows_ * columns_, threads_, [&](std::size_t, std::size_t tile) {
            each_part(tile / columns_, tile % columns_, [&](std::size_t at, const Part& part) {
                std::uint64_t mask = 0;
                Extent* const extents = extents_.data() + at * layered_.count;
                std::fill_n(extents, layered_.count, Extent{255, 255, 0, 0});
                const auto note = [&](std::uint8_t layer, std::size_t y, std::size_t x) {
                    mask |= std::uint64_t{1} << layer;
                    extents[layer].include(y, x);
                };
                for (std::size_t y = 0; y < part.height; ++y) {
                    // In a run of points of the same layer, only the two ends change the bounding box.
                    std::uint8_t last = layered_.layers[point(part.top + y, part.left)];
                    note(last, y, 0);
                    for (std::size_t x = 0; x < part.width; ++x) {
                        const std::size_t p = point(part.top + y, part.left + x);
                        if (layered_.layers[p] != last) {
                            note(last, y, x - 1);
                            last = layered_.layers[p];
                            note(last, y, x);
                        }
                        if (layered_.behind && layered_.behind[p] >= 0) {
                            note(layered_.layers[layered_.behind[p]], y, x);
                        }
                    }
                    note(last, y, part.width - 1);
                }
                masks_[at] = mask;
            });
        });
    }

    // Pixels of a tile, as rows and columns of the scene.
    Box inside(std::size_t row, std::size_t column) const {
        const auto at = [](std::size_t place) { return static_cast<std::ptrdiff_t>(place); };
        return Box{at(row * tall_), at(column * broad_), at((row + 1) * tall_), at((column + 1) * broad_)}.within(
            {0, 0, at(scene_.height), at(scene_.width)});
    }

    // Shortest vectors, available on every processor of an architecture, so that results do not depend on the processor.
    using Short = Packed<Portable, T>;

    template <class F>
    static void each_row(const Box& box, const F& f) {
        for (std::ptrdiff_t y = box.top; y < box.bottom && box.left < box.right; ++y) {
            f(static_cast<std::size_t>(y), static_cast<std::size_t>(box.left), static_cast<std::size_t>(box.right));
        }
    }

    // For each tile, find the largest visibility `seen` of its pixels, and the number of pixels not completely covered yet.
    void look_at(const Composite<T>& made) {
        parallel_for(rows_ * columns_, threads_, [&](std::size_t, std::size_t tile) {
            T most = level(0) - T(1);
            std::size_t open = 0;
            each_row(inside(tile / columns_, tile % columns_), [&](std::size_t y, std::size_t left, std::size_t right) {
                const T* const seen = made.seen + y * scene_.width;
                most = std::max(most, *std::max_element(seen + left, seen + right));
                open += static_cast<std::size_t>(std::count(seen + left, seen + right, beyond()));
            });
            most_[tile] = most, open_[tile] = open;
        });
    }

    template <class F>
    bool any_around(std::size_t row, std::size_t column, const F& f) const {
        for (std::size_t y = std::max<std::size_t>(row, 1) - 1; y < std::min(rows_, row + 2); ++y) {
            for (std::size_t x = std::max<std::size_t>(column, 1) - 1; x < std::min(columns_, column + 2); ++x) {
                if (f(y * columns_ + x)) {
                    return true;
                }
            }
        }
        return false;
    }

    // Select the tiles that have points of `layer`, if this layer is visible from a pixel of the tile or of an adjacent tile.
    // Returns whether any tile is selected.
    bool choose(std::size_t layer) {
        chosen_.assign(rows_ * columns_, 0);
        bool any = false;
        const std::size_t parts = parts_ * part_columns();
        for (std::size_t row = 0; row < rows_; ++row) {
            for (std::size_t column = 0; column < columns_; ++column) {
                const std::uint64_t* const mask = masks_.data() + (row * columns_ + column) * parts;
                const bool here = std::any_of(mask, mask + parts, [&](std::uint64_t each) { return each >> layer & 1; });
                if (here && any_around(row, column, [&](std::size_t tile) { return most_[tile] > level(layer); })) {
                    chosen_[row * columns_ + column] = 1;
                    any = true;
                }
            }
        }
        return any;
    }

    // Points of one layer in a part of a tile; column x of the part has points in rows first[x] .. last[x] - 1.
    struct Points {
        explicit Points(std::size_t tall)
            : places(new BankPlace<T>[(tall + 1) * part_width]), values(new T[(tall + 1) * part_width]) {}
        std::unique_ptr<BankPlace<T>[]> places;  // bank positions [row, one spare][column], set in the layer's bounding box
        std::unique_ptr<T[]> values;  // light [column][row, one spare], set at points of the layer
        std::size_t first[part_width], last[part_width];
    };

    // Add the light of a layer's points in a tile, spread by their windows, to `light` (if there is an image) and, unless the
    // visibility is `known`, their coverage (the light of a white scene) to `white`. Returns the box of pixels reached.
    Box spread(std::size_t row, std::size_t column, std::size_t layer, bool known, T* white, T* light) const {
        Box reached = Box::empty();
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using I = decltype(isa);
            const std::size_t tall = std::min(most_rows, tall_);
            Points points(tall);
            std::vector<Mixture<T>> mixtures(tall + 1);
            Sheets<I, T> sheets(bank_, tall, across(), image_ != nullptr);
            each_part(row, column, [&](std::size_t at, const Part& part) LOMMEL_INLINE_LAMBDA {
                if (masks_[at] >> layer & 1) {
                    look();
                    const Extent extent = extents_[at * layered_.count + layer];
                    place(part, extent, tall, static_cast<std::uint8_t>(layer), points);
                    std::size_t half = 0;
                    for (std::size_t x = extent.left; x < extent.right; ++x) {
                        const T* const values = points.values.get() + x * (tall + 1);
                        const auto spread_by = [&](const auto& side) LOMMEL_INLINE_LAMBDA {
                            half = std::max(half, one_column(isa, part, x, points, mixtures.data(), sheets, side));
                        };
                        if (points.first[x] >= points.last[x]) {
                            continue;
                        }
                        if (known) {
                            spread_by(GivingLight<I, T, false>{nullptr, light, values});
                        } else if (image_) {
                            spread_by(GivingLight<I, T, true>{white, light, values});
                        } else {
                            spread_by(Giving<I, T>{white, nullptr});
                        }
                    }
                    const auto top = static_cast<std::ptrdiff_t>(part.top), left = static_cast<std::ptrdiff_t>(part.left);
                    const auto away = static_cast<std::ptrdiff_t>(half);
                    reached.include({top + extent.top - away, left + extent.left - away, top + extent.bottom + away,
                                     left + extent.right + away});
                }
            });
        });
        return reached;
    }

    // For the points of `layer` in a part of a tile, set their positions in the bank of windows and their light, and the range of
    // rows that contains the points of each column.
    void place(const Part& part, const Extent& extent, std::size_t tall, std::uint8_t layer, Points& points) const {
        std::fill_n(points.first, part_width, tall), std::fill_n(points.last, part_width, std::size_t{0});
        for (std::size_t i = extent.top; i < extent.bottom; ++i) {
            std::fill_n(points.places.get() + i * part_width + extent.left, extent.right - extent.left, BankPlace<T>{-1, T(0)});
            for (std::size_t j = extent.left; j < extent.right; ++j) {
                const std::size_t y = part.top + i, x = part.left + j, at = point(y, x);
                std::size_t from = at;
                if (layered_.layers[at] != layer) {
                    if (!layered_.behind || layered_.behind[at] < 0) {
                        continue;
                    }
                    from = static_cast<std::size_t>(layered_.behind[at]);
                    if (layered_.layers[from] != layer) {
                        continue;
                    }
                }
                const BankPlace<T> place = mixture_.place(scene_.positions[from], T(1));
                if (place.first < 0) {
                    continue;
                }
                points.places[i * part_width + j] = place;
                points.values[j * (tall + 1) + i] = value(from);
                points.first[j] = std::min(points.first[j], i), points.last[j] = i + 1;
            }
        }
    }

    T value(std::size_t at) const {
        return image_ ? image_[static_cast<std::ptrdiff_t>(at / scene_.width) * down_ +
                               static_cast<std::ptrdiff_t>(at % scene_.width) * right_]
                      : T(0);
    }

    // Spread one column of points, two vertically adjacent points at a time. Returns the largest half width of their windows.
    template <class I, class Side>
    LOMMEL_INLINE std::size_t one_column(I, const Part& part, std::size_t x, const Points& points, Mixture<T>* mixtures,
                                         Sheets<I, T>& sheets, const Side& side) const {
        Column column{static_cast<std::ptrdiff_t>((part.top + bank_.widest) * across() + margin_ + part.left + x),
                      0,
                      points.first[x],
                      points.last[x],
                      0,
                      false};
        const auto add = [&](auto count, auto same, std::size_t i) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t together = decltype(count)::value;
            const std::size_t half = std::max(mixtures[i].half, mixtures[i + together - 1].half);
            each_block<I, together, decltype(same)::value>(
                bank_, mixtures + i, half, [&](const auto& rows) LOMMEL_INLINE_LAMBDA { side.add(sheets, i, rows); });
        };
        constexpr std::integral_constant<std::size_t, 1> one{};
        constexpr std::integral_constant<std::size_t, 2> two{};
        std::size_t pairs[3][(most_rows + 1) / 2 + 1], counts[3] = {};
        for (std::size_t i = column.first; i < column.last; i += 2) {
            for (std::size_t k = i; k < i + 2; ++k) {
                mixture_(k < column.last ? points.places[k * part_width + x] : BankPlace<T>{-1, T(0)}, T(1), mixtures[k]);
                column.half = std::max<std::size_t>(column.half, mixtures[k].half);
            }
            const Mixture<T>&a = mixtures[i], &b = mixtures[i + 1];
            if (a.any && b.any) {
                const std::size_t kind = a.first == b.first ? 0 : 1;
                pairs[kind][counts[kind]++] = i;
            } else if (a.any || b.any) {
                pairs[2][counts[2]++] = a.any ? i : i + 1;
            }
        }
        for (std::size_t k = 0; k < counts[0]; ++k) {
            add(two, std::true_type{}, pairs[0][k]);
        }
        for (std::size_t k = 0; k < counts[1]; ++k) {
            add(two, std::false_type{}, pairs[1][k]);
        }
        for (std::size_t k = 0; k < counts[2]; ++k) {
            add(one, std::true_type{}, pairs[2][k]);
        }
        side.close(sheets, column);
        return column.half;
    }

    // Fold light outside the scene back into it, mirrored at the outer edges of its first and last pixels.
    void fold(T* room, const Box& reached) const {
        const auto height = static_cast<std::ptrdiff_t>(scene_.height), width = static_cast<std::ptrdiff_t>(scene_.width);
        const auto wide = static_cast<std::ptrdiff_t>(bank_.widest), row = static_cast<std::ptrdiff_t>(across());
        T* const image = room + wide * row + static_cast<std::ptrdiff_t>(margin_);
        const auto mirrored = [](std::ptrdiff_t at, std::ptrdiff_t count) {
            const std::ptrdiff_t turn = ((at % (2 * count)) + 2 * count) % (2 * count);
            return turn < count ? turn : 2 * count - 1 - turn;
        };
        const auto outside = [](std::ptrdiff_t from, std::ptrdiff_t to, std::ptrdiff_t count, const auto& f) {
            for (std::ptrdiff_t at = from; at < std::min<std::ptrdiff_t>(to, 0); ++at) {
                f(at);
            }
            for (std::ptrdiff_t at = std::max(from, count); at < to; ++at) {
                f(at);
            }
        };
        outside(reached.top, reached.bottom, height, [&](std::ptrdiff_t y) {
            T *const from = image + y * row, *const onto = image + mirrored(y, height) * row;
            for (std::ptrdiff_t x = reached.left; x < reached.right; ++x) {
                onto[x] += from[x];
                from[x] = T(0);
            }
        });
        for (std::ptrdiff_t y = std::max<std::ptrdiff_t>(reached.top, 0); y < std::min(reached.bottom, height); ++y) {
            outside(reached.left, reached.right, width, [&](std::ptrdiff_t x) {
                image[y * row + mirrored(x, width)] += image[y * row + x];
                image[y * row + x] = T(0);
            });
        }
    }

    // Add a layer of level `layer` to a vector of pixels. cover: fraction of the aperture that the layer alone covers, as seen
    // from each pixel, reset to 0 here; total: fraction that all layers so far cover; seen: visibility, set at pixels where this
    // layer completes the cover. Returns 1 for these pixels, 0 for others.
    Short cover_pixels(T* total, T* seen, T* cover, T layer) const {
        constexpr T tiny = std::numeric_limits<T>::min(), never = std::numeric_limits<T>::infinity();
        const Short one = splat<Short>(T(1)), rounding = splat<Short>(T(16) * std::numeric_limits<T>::epsilon());
        const Short covered = load<Short>(cover), before = load<Short>(total), last = load<Short>(seen), open = one - before;
        const Short none = splat<Short>(beyond());
        const Short part = below(open + rounding, covered, open / larger(covered, splat<Short>(tiny)), one);
        const Short least = below(last, none, splat<Short>(never), open - rounding);
        store(total, below(last, none, before, before + part * covered));
        store(seen, below(least, covered, splat<Short>(layer) + part, last));
        store(cover, Short{});
        return below(least, covered, one, Short{});
    }

    // Add the visible part of a layer to a tile's pixels, from its sums `light` by spread(). Unless `known`, first compute the
    // visibility from its coverage `white`. The sums that were read are reset to 0.
    void compose(std::size_t row, std::size_t column, T layer, bool known, T* white, T* light, const Composite<T>& made) {
        constexpr std::size_t lanes = sizeof(Short) / sizeof(T);
        const std::size_t tile = row * columns_ + column;
        Short filled{};
        Box reached = Box::empty();
        any_around(row, column, [&](std::size_t other) {
            if (chosen_[other]) {
                reached.include(reached_[other]);
            }
            return false;
        });
        each_row(inside(row, column).within(reached), [&](std::size_t y, std::size_t left, std::size_t right) {
            const std::size_t at = point(y, left), count = right - left;
            const std::size_t from = (y + bank_.widest) * across() + margin_ + left;
            T* const seen = made.seen + at;
            if (!known) {
                T *const total = made.total + at, *const cover = white + from;
                for (std::size_t x = 0; x < count; x += lanes) {
                    if (count - x >= lanes) {
                        filled = filled + cover_pixels(total + x, seen + x, cover + x, layer);
                        continue;
                    }
                    T last[3][lanes] = {};  // zero padded beyond the end of the row
                    T* const rest[] = {total + x, seen + x, cover + x};
                    for (std::size_t k = 0; k < 3; ++k) {
                        std::copy_n(rest[k], count - x, last[k]);
                    }
                    filled = filled + cover_pixels(last[0], last[1], last[2], layer);
                    for (std::size_t k = 0; k < 3; ++k) {
                        std::copy_n(last[k], count - x, rest[k]);
                    }
                }
            }
            if (image_) {
                T *const out = made.out + at, *const sum = light + from;
                for (std::size_t x = 0; x < count; ++x) {
                    out[x] += std::min(std::max(seen[x] - layer, T(0)), T(1)) * sum[x];
                    sum[x] = T(0);
                }
            }
        });
        for (std::size_t k = 0; k < lanes; ++k) {
            open_[tile] -= static_cast<std::size_t>(filled[k]);
        }
        if (!known && open_[tile] == 0) {
            most_[tile] = level(0) - T(1);
        }
    }

    WindowBank<T> bank_;
    LayeredScene layered_;
    Scene scene_;
    int threads_;
    const T* image_;
    std::ptrdiff_t down_, right_;
    std::size_t margin_;
    Mixer<T> mixture_;
    std::size_t tall_, broad_, rows_, columns_, parts_;
    std::vector<std::uint64_t> masks_;  // [tile][part]: bit l is set if layer l has points in the part
    std::vector<Extent> extents_;  // [tile][part][layer]: bounding box of the layer's points
    std::vector<T> most_;  // [tile]: largest visibility `seen` of its pixels
    std::vector<std::size_t> open_;  // [tile]: number of its pixels that are not completely covered
    std::vector<unsigned char> chosen_;
    std::vector<Box> reached_;  // [tile]: bounding box of the pixels that the current layer's points reach
};

// Defined outside the class so that it is not inline and is compiled once, by explicit instantiation.
template <class T>
Compositor<T>::Compositor(const WindowBank<T>& bank, const LayeredScene& layered, int threads, const T* image,
                          std::ptrdiff_t down, std::ptrdiff_t right)
    : bank_(bank), layered_(layered), scene_(layered.scene), threads_(threads), image_(image), down_(down), right_(right),
      margin_(Spreader<T>::margin(bank.widest)), mixture_(bank), tall_(std::max(least_rows, 2 * bank.widest)),
      broad_(std::max(least_columns, 2 * margin_)), rows_((scene_.height + tall_ - 1) / tall_),
      columns_((scene_.width + broad_ - 1) / broad_), parts_((tall_ + most_rows - 1) / most_rows),
      masks_(rows_ * columns_ * parts_ * part_columns()), extents_(masks_.size() * layered.count), most_(rows_ * columns_),
      open_(rows_ * columns_), reached_(rows_ * columns_) {
    mark();
}

template <class T>
void Compositor<T>::operator()(std::size_t from, std::size_t to, bool known, const Composite<T>& made) {
    const std::size_t size = (scene_.height + 2 * bank_.widest) * across();
    Aligned<T> white(known ? 0 : size, T(0)), light(image_ ? size : 0, T(0));
    const Checkerboard tiles(rows_, columns_);
    look_at(made);
    for (std::size_t layer = from; layer < to; ++layer) {
        if (!choose(layer)) {
            continue;
        }
        tiles.each(threads_, [&](std::size_t row, std::size_t column) {
            if (chosen_[row * columns_ + column]) {
                reached_[row * columns_ + column] = spread(row, column, layer, known, white.data(), light.data());
            }
        });
        Box reached = Box::empty();
        for (std::size_t tile = 0; tile < chosen_.size(); ++tile) {
            if (chosen_[tile]) {
                reached.include(reached_[tile]);
            }
        }
        for (Aligned<T>* const room : {&white, &light}) {
            if (!room->empty()) {
                fold(room->data(), reached);
            }
        }
        parallel_for(rows_ * columns_, threads_, [&](std::size_t, std::size_t tile) {
            compose(tile / columns_, tile % columns_, level(layer), known, white.data(), light.data(), made);
        });
    }
}

#if defined(LOMMEL_COMPILED)
extern template class Compositor<float>;
extern template class Compositor<double>;
#endif

}  // namespace lommel
