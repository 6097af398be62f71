// Blur that varies from pixel to pixel: every source pixel spreads its own window, a mixture of four of a bank.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/column.hpp"
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

// Whether all are finite: what is not stays so times 0.
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
    // With `slopes` windows are the derivatives by positions in the bank.
    Spreader(const WindowBank<T>& bank, const Scene& scene, int threads, const Screen<T>& screen = {}, bool slopes = false)
        : bank_(bank), scene_(scene), screen_(screen), height_(scene.height), width_(scene.width), threads_(threads),
          margin_(margin(bank.widest)), mixture_(bank, slopes) {}

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
    // High enough for what the points of a column spread to be put together before it goes to where it belongs.
    static constexpr std::size_t least_rows = 64, least_columns = 64, most_rows = 128;
    // Points that are looked at together: few beside the pixels that they reach.
    static constexpr std::size_t near = 8;

    template <class Value>
    void spread_tile(std::size_t top, std::size_t bottom, std::size_t left, std::size_t right, const Value& value,
                     T* out) const {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            pixels(isa, top, bottom, left, right, value, Giving<decltype(isa), T>{out, screen_.seen});
        });
    }

    void collect_strip(std::size_t top, std::size_t bottom, const T* image, T* out) const {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            const auto one = [](std::size_t, std::size_t) { return T(1); };
            pixels(isa, top, bottom, 0, width_, one, Taking<decltype(isa), T>{out, screen_.seen, image, width_});
        });
    }

    // Values of a row of an image that windows reach beyond.
    std::size_t across() const { return width_ + 2 * margin_; }

    // Gives or takes for all pixels of a part of the image, of two below each other at once where their windows are as wide
    // and share three of four or more. Mixtures are made across, some beforehand: so their loads and divisions need not wait
    // for one another.
    template <class I, class Value, class Side>
    LOMMEL_INLINE void pixels(I isa, std::size_t top, std::size_t bottom, std::size_t left, std::size_t right,
                              const Value& value, const Side& side) const {
        constexpr std::size_t broad = 64;
        const std::size_t tall = std::min(most_rows, bottom - top), below = tall + 1;
        std::vector<Mixture<T>> mixtures(broad * below);  // more than the stack of a thread need hold
        Sheets<I, T> sheets(bank_, tall, across(), screen_.layers != nullptr);
        Glance glance;
        for (std::size_t y = top; y < bottom; y += tall) {
            for (std::size_t x = left; x < right; x += broad) {
                const std::size_t height = std::min(tall, bottom - y), width = std::min(broad, right - x);
                glance(height * width * (1 + bank_.widest * bank_.widest));
                for (std::size_t i = 0; i < height; ++i) {
                    const std::size_t row = static_cast<std::size_t>(scene_.rows[y + i]) * scene_.across;
                    for (std::size_t j = 0; j < width; ++j) {
                        const std::size_t from = row + static_cast<std::size_t>(scene_.columns[x + j]);
                        Mixture<T>& made = mixtures[j * below + i];
                        mixture_(scene_.positions[from], value(y + i, x + j), made);
                        made.layer = screen_.layers ? screen_.layers[from] : T(0);
                        made.hidden = false;
                    }
                }
                for (std::size_t j = 0; screen_.layers && j < width; j += near) {
                    for (std::size_t i = 0; i < height; i += near) {
                        look(isa, mixtures.data() + j * below + i, below, y + i, std::min(near, height - i), x + j,
                             std::min(near, width - j));
                    }
                }
                for (std::size_t j = 0; j < width; ++j) {
                    mixtures[j * below + height].any = false;
                    one_column(isa, mixtures.data() + j * below, height, y, x + j, sheets, side);
                }
            }
        }
    }

    template <class I, class Side>
    LOMMEL_INLINE void one_column(I, const Mixture<T>* points, std::size_t height, std::size_t y, std::size_t x,
                                  Sheets<I, T>& sheets, const Side& side) const {
        Column column{static_cast<std::ptrdiff_t>((y + bank_.widest) * across() + margin_ + x), height, 0, false};
        bool any = false;
        for (std::size_t i = 0; i < height; ++i) {
            any = any || points[i].any;
            column.hidden = column.hidden || (points[i].any && points[i].hidden);
            column.half = std::max<std::size_t>(column.half, points[i].any ? points[i].half : 0);
        }
        if (!any) {
            return;
        }
        side.open(sheets, column);
        const auto add = [&](auto count, std::size_t i) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t together = decltype(count)::value;
            const std::size_t to = (y + i) * width_ + x;
            each_block<I, together>(bank_, points + i, [&](const auto& rows) LOMMEL_INLINE_LAMBDA {
                if (points[i].hidden || points[i + together - 1].hidden) {
                    side.template add<true>(sheets, i, rows, to);
                } else {
                    side.template add<false>(sheets, i, rows, to);
                }
            });
        };
        for (std::size_t i = 0; i < height; ++i) {
            const Mixture<T>*const one = points + i, *const next = one + 1;
            if (one->any && next->any && one->half == next->half && one->first <= next->first + 1 &&
                next->first <= one->first + 1) {
                add(std::integral_constant<std::size_t, 2>{}, i);
                ++i;
            } else if (one->any) {
                add(std::integral_constant<std::size_t, 1>{}, i);
            }
        }
        side.close(sheets, column);
    }

    // Of points next to each other, [column][row], leaves out those that no pixel sees which one of them reaches, and finds
    // those that not all pixels see: most of a scene is neither, and costs no more than where nothing is hidden.
    template <class I>
    LOMMEL_INLINE void look(I, Mixture<T>* points, std::size_t stride, std::size_t y, std::size_t height, std::size_t x,
                            std::size_t width) const {
        using V = Packed<I, T>;
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

    WindowBank<T> bank_;
    Scene scene_;
    Screen<T> screen_;
    std::size_t height_, width_;
    int threads_;
    std::size_t margin_;
    Mixer<T> mixture_;
};

}  // namespace lommel
