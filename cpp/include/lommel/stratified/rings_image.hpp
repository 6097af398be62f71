// Images interpolated between circles; a pixel's interpolation weights serve all planes (docs/certificate.md, section 16).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/stratified/rings.hpp"

namespace lommel {

// Window of pixels; step: pixel pitch / distance between circles. centers[axis][row, column]: one axis per plane, or one for all.
struct RingWindow {
    std::size_t height, width;
    const double* centers;
    std::size_t axes;
    double step;

    // Largest distance of a pixel from its axis, in pixels.
    double farthest() const {
        double most = 0.0;
        for (std::size_t i = 0; i < axes; ++i) {
            const double row = centers[2 * i], column = centers[2 * i + 1];
            most = std::max(most, std::hypot(std::max(row, static_cast<double>(height - 1) - row),
                                             std::max(column, static_cast<double>(width - 1) - column)));
        }
        return most;
    }
};

// Quantities for the error bounds, at[quantity][plane]: largest squared modulus of each field; maxima over circles of the
// intensity, of the sum of aliasing errors, and of the sum of the moduli of azimuthal orders; largest pixel.
struct RingNumbers {
    double* at;
    std::size_t planes, fields;

    static std::size_t count(std::size_t fields) { return fields + 4; }
    double& operator()(std::size_t which, std::size_t plane) const { return at[which * planes + plane]; }
};

template <class T>
class RingImages {
   public:
    static constexpr std::size_t side = 16;  // side of a tile in pixels; the circles it needs fit in a processor's cache
    static constexpr std::size_t most_bytes = std::size_t{256} << 20;  // limit of the memory for the circles of all planes

    RingImages(const RingLight& light, const RingSteps& steps, const RingWindow& window, int threads)
        : light_(light), steps_(steps), window_(window), threads_(threads) {}

    // Write intensities times scales[plane], clipped to values >= 0.
    void run(const double* scales, T* images, const RingNumbers& numbers) const;

   private:
    using Blocks = std::vector<std::unique_ptr<const Rings>>;
    // Planes [from, to) with a common axis, counted from the first plane of the blocks.
    struct Group {
        std::size_t from, to;
    };

    void paint(const Blocks& rings, std::size_t first, const double* scales, T* images, const RingNumbers& numbers) const {
        const std::size_t planes = std::min(rings.size() * ring_planes, light_.planes - first);
        const std::size_t groups = window_.axes > 1 ? planes : 1, each = planes / groups;
        const std::size_t down = (window_.height + side - 1) / side;
        std::vector<double> tops(groups * down * each, 0.0);
        const double microseconds = 2e-3 * static_cast<double>(window_.height * window_.width * planes);
        parallel_for(groups * down, worthwhile_threads(threads_, microseconds), [&](std::size_t, std::size_t task) {
            const std::size_t from = task / down * each;
            for (std::size_t left = 0; left < window_.width; left += side) {
                look();
                dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                    paint_tile(isa, task % down * side, left, rings, {from, from + each}, first, scales + first, images,
                               tops.data() + task * each);
                });
            }
        });
        for (std::size_t p = 0; p < planes; ++p) {
            double top = 0.0;
            for (std::size_t tile = 0; tile < down; ++tile) {
                top = std::max(top, tops[(p / each * down + tile) * each + p % each]);
            }
            numbers(light_.fields + 3, first + p) = top;
        }
    }

    struct Weights {
        alignas(64) double along[RingTaps::most], around[RingTaps::most];
        std::size_t row, angle;  // indices of the circle and of the angle of the first tap
    };

    // Write the interpolation weights out[tap]: the polynomials of RingTaps at x, which runs from -1 to 1 between two adjacent
    // circles or angles.
    template <class I>
    static LOMMEL_INLINE void weigh(I, const RingTaps& taps, double x, double* out) {
        using V = typename I::pack;
        const V at = splat<V>(x);
        for (std::size_t i = 0; i < RingTaps::most; i += I::lanes) {
            store(out + i, horner(taps.terms, at, [&](std::size_t k) LOMMEL_INLINE_LAMBDA {
                      return taps.polynomials + k * RingTaps::most + i;
                  }));
        }
    }

    template <class I>
    LOMMEL_INLINE void paint_tile(I isa, std::size_t top, std::size_t left, const Blocks& rings, Group group, std::size_t first,
                                  const double* scales, T* images, double* tops) const {
        using V = typename I::pack;
        constexpr std::size_t packs = ring_planes / I::lanes;
        const std::size_t height = std::min(side, window_.height - top), width = std::min(side, window_.width - left);
        // finer: number of angles of a circle (2 pi); turn: number of angles in one radian.
        const double finer = static_cast<double>(steps_.finer()), turn = finer / 6.283185307179586477;
        const double* const center = window_.centers + (window_.axes > 1 ? 2 * (first + group.from) : 0);
        Weights weights[side * side];
        for (std::size_t i = 0; i < height * width; ++i) {
            const double y = static_cast<double>(top + i / width) - center[0];
            const double x = static_cast<double>(left + i % width) - center[1];
            const double r = std::hypot(x, y) * window_.step, azimuth = std::atan2(y, x) * turn;
            const double angle = azimuth < 0.0 ? azimuth + finer : azimuth;
            weights[i].row = static_cast<std::size_t>(r) + 1;
            weights[i].angle = static_cast<std::size_t>(angle) + 1;
            weigh(isa, steps_.along, 2.0 * (r - std::floor(r)) - 1.0, weights[i].along);
            weigh(isa, steps_.around, 2.0 * (angle - std::floor(angle)) - 1.0, weights[i].around);
        }
        const V zero = splat<V>(0.0);
        for (std::size_t b = group.from / ring_planes; b * ring_planes < group.to; ++b) {
            alignas(64) double values[side * side][ring_planes];
            V most[packs];
            for (std::size_t p = 0; p < packs; ++p) {
                most[p] = zero;
            }
            for (std::size_t i = 0; i < height * width; ++i) {
                V total[packs];
                pixel<V>(*rings[b], weights[i], total);
                for (std::size_t p = 0; p < packs; ++p) {
                    const V light = larger(total[p], zero);
                    most[p] = larger(most[p], light);
                    store(values[i] + p * I::lanes, light);
                }
            }
            for (std::size_t p = std::max(group.from, b * ring_planes); p < std::min(group.to, (b + 1) * ring_planes); ++p) {
                const std::size_t lane = p % ring_planes;
                tops[p - group.from] = std::max(tops[p - group.from], double(most[lane / I::lanes][lane % I::lanes]));
                T* out = images + ((first + p) * window_.height + top) * window_.width + left;
                for (std::size_t line = 0; line < height; ++line, out += window_.width) {
                    for (std::size_t i = 0; i < width; ++i) {
                        out[i] = static_cast<T>(scales[p] * values[line * width + i][lane]);
                    }
                }
            }
        }
    }

    template <class V>
    LOMMEL_INLINE void pixel(const Rings& rings, const Weights& weights, V* total) const {
        const std::size_t circle_stride = steps_.row() * ring_planes;
        const double *start = rings.row(weights.row) + weights.angle * ring_planes, *along = weights.along;
        for (std::size_t p = 0; p < ring_planes * sizeof(double) / sizeof(V); ++p) {
            total[p] = splat<V>(0.0);
        }
        std::size_t j = 0;
        for (; j + 4 <= steps_.along.count; j += 4, start += 4 * circle_stride) {
            circles<4>(start, circle_stride, weights.around, along + j, total);
        }
        for (; j < steps_.along.count; j += 2, start += 2 * circle_stride) {
            circles<2>(start, circle_stride, weights.around, along + j, total);
        }
    }

    // Add the contributions of `Together` adjacent circles to the value at a pixel, for all planes of a block. start: first tap on
    // the first of these circles; around, along: weights of the taps on a circle, and of the circles. The sums over the circles are
    // independent, which hides the latency of multiply-adds; loads limit the speed.
    template <std::size_t Together, class V>
    LOMMEL_INLINE void circles(const double* start, std::size_t circle_stride, const double* around, const double* along,
                               V* total) const {
        constexpr std::size_t lanes = sizeof(V) / sizeof(double), packs = ring_planes / lanes;
        V sum[Together][packs] = {};
        for (std::size_t l = 0; l < steps_.around.count; ++l) {
            const V weight = splat<V>(around[l]);
            for (std::size_t k = 0; k < Together; ++k) {
                for (std::size_t p = 0; p < packs; ++p) {
                    sum[k][p] = sum[k][p] + weight * load<V>(start + k * circle_stride + l * ring_planes + p * lanes);
                }
            }
        }
        for (std::size_t k = 0; k < Together; ++k) {
            for (std::size_t p = 0; p < packs; ++p) {
                total[p] = total[p] + splat<V>(along[k]) * sum[k][p];
            }
        }
    }

    const RingLight& light_;
    const RingSteps& steps_;
    RingWindow window_;
    int threads_;
};

template <class T>
void RingImages<T>::run(const double* scales, T* images, const RingNumbers& numbers) const {
    const std::size_t blocks = (light_.planes + ring_planes - 1) / ring_planes;
    const std::size_t bytes = sizeof(double) * light_.circles * steps_.row() * ring_planes;
    const std::size_t together = std::max<std::size_t>(1, std::min(blocks, most_bytes / bytes));
    const double each = 1e-4 * static_cast<double>(light_.circles * light_.nodes * light_.orders * light_.fields * ring_planes);
    for (std::size_t from = 0; from < blocks; from += together) {
        const std::size_t here = std::min(together, blocks - from);
        std::vector<std::unique_ptr<const Rings>> rings(here);
        parallel_for(here, worthwhile_threads(threads_, each * static_cast<double>(here)), [&](std::size_t, std::size_t b) {
            auto made = std::make_unique<Rings>(light_, steps_);
            RingSizes sizes(light_.fields);
            const std::size_t first = (from + b) * ring_planes, planes = std::min(ring_planes, light_.planes - first);
            made->fill(first, sizes);
            for (std::size_t p = 0; p < planes; ++p) {
                for (std::size_t f = 0; f < light_.fields; ++f) {
                    numbers(f, first + p) = sizes.squares[f * ring_planes + p];
                }
                numbers(light_.fields, first + p) = sizes.top[p];
                numbers(light_.fields + 1, first + p) = sizes.aliases[p];
                numbers(light_.fields + 2, first + p) = sizes.numbers[p];
            }
            rings[b] = std::move(made);
        });
        paint(rings, from * ring_planes, scales, images, numbers);
    }
}

#if defined(LOMMEL_COMPILED)
extern template class RingImages<float>;
extern template class RingImages<double>;
#endif

}  // namespace lommel
