// Layers of similar defocus, and for each occluding point a representative point for the light behind it, which a photograph
// does not show.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Signed radius of the circle of confusion in pixels, sampled at `count` equal steps of defocus from `low` to `high`; a larger
// radius means a nearer point. Layers of `thickness` in radius are counted from the largest; the last of `layers` has all the rest.
struct BlurRadii {
    const double* radii;
    std::size_t count;
    double low, high, thickness;
    std::size_t layers;
};

// Write the layer and the signed blur radius (pixels) of each point.
LOMMEL_KERNEL inline void sort_into_layers(const double* defocus, std::size_t size, const BlurRadii& known, int threads,
                                           std::uint8_t* layers, float* radius) {
    const double largest = *std::max_element(known.radii, known.radii + known.count);
    const double last = static_cast<double>(known.count - 1), most = static_cast<double>(known.layers - 1);
    const double scale = known.high > known.low ? last / (known.high - known.low) : 0.0;
    constexpr std::size_t part = std::size_t{1} << 16;
    parallel_for((size + part - 1) / part, threads, [&](std::size_t, std::size_t task) {
        for (std::size_t i = task * part; i < std::min(size, (task + 1) * part); ++i) {
            const double at = std::min(std::max((defocus[i] - known.low) * scale, 0.0), last);
            const std::size_t before = std::min(static_cast<std::size_t>(at), std::max<std::size_t>(known.count, 2) - 2);
            const double within = at - static_cast<double>(before);
            const double* const pair = known.radii + before;
            const double here = within > 0.0 ? pair[0] + within * (pair[1] - pair[0]) : pair[0];
            layers[i] = static_cast<std::uint8_t>(std::min(std::max((largest - here) / known.thickness, 0.0), most));
            radius[i] = static_cast<float>(here);
        }
    });
}

// Renumber the layers without gaps. Returns the number of layers.
inline std::size_t renumber(std::uint8_t* layers, std::size_t size) {
    bool there[256] = {};
    for (std::size_t i = 0; i < size; ++i) {
        there[layers[i]] = true;
    }
    std::uint8_t number[256] = {};
    std::size_t count = 0;
    for (std::size_t layer = 0; layer < 256; ++layer) {
        number[layer] = static_cast<std::uint8_t>(count);
        count += there[layer] ? 1 : 0;
    }
    for (std::size_t i = 0; i < size; ++i) {
        layers[i] = number[layers[i]];
    }
    return count;
}

// For each occluding point p, find a representative point for the light behind p.
// A point p occludes a farther point q if their distance is less than radius(p) - radius(q), the difference of their signed blur
// radii: p then blocks a ray from q to the aperture. Points q are visited in order of distance from p. L is a layer, at first that
// of p. Points q in layers not farther than L are skipped. If p does not occlude the next q, L becomes the layer of q. Otherwise
// the search ends: the representative is the mirror image of p at q (the point 2 q - p) if that is in a layer farther than L,
// else q.
class HiddenPoints {
   public:
    HiddenPoints(const std::uint8_t* layers, const float* radius, std::size_t height, std::size_t width, int threads)
        : layers_(layers), radius_(radius), height_(height), width_(width), threads_(threads) {}

    // Write behind[point]: index of the representative point, or -1. Returns the number of points that have one.
    std::size_t find(std::int32_t* behind) const {
        const std::size_t size = height_ * width_;
        std::fill_n(behind, size, -1);
        const auto [least, most] = std::minmax_element(radius_, radius_ + size);
        const float range = *most - *least;
        std::vector<float> reached = lowest();
        if (reached.empty()) {
            return 0;
        }
        const std::size_t reach = std::min(static_cast<std::size_t>(std::ceil(range)), std::max(height_, width_));
        const std::vector<Step> steps = by_distance(reach);
        const std::size_t across = (width_ + block - 1) / block;
        const std::vector<float> around = least_around(reach);
        // The radii of alone() save time only if many points may occlude others.
        std::size_t candidates = 0;
        for (std::size_t i = 0; i < size; ++i) {
            candidates += reached[i] < radius_[i] ? 1 : 0;
        }
        const std::size_t rings = candidates * reach > 4 * size ? std::min(reach, most_rings) : 0;
        const std::vector<std::uint8_t> isolated = rings > 0 ? alone(rings) : std::vector<std::uint8_t>();
        std::vector<std::size_t> begin(rings + 1, 0);  // [ring]: index of the first offset longer than `ring` pixels
        for (std::size_t ring = 1; ring <= rings; ++ring) {
            begin[ring] = begin[ring - 1];
            while (begin[ring] < steps.size() && steps[begin[ring]].distance <= static_cast<float>(ring)) {
                ++begin[ring];
            }
        }
        std::vector<std::size_t> found(height_, 0);
        parallel_for(height_, threads_, [&](std::size_t, std::size_t y) {
            for (std::size_t x = 0; x < width_; ++x) {
                const std::size_t at = y * width_ + x;
                if (reached[at] < radius_[at]) {
                    const float far = radius_[at] - around[y / block * across + x / block];
                    const std::size_t from = begin[isolated.empty() ? 0 : isolated[at]];
                    behind[at] =
                        inner(y, x, reach) ? visit<true>(y, x, steps, from, far) : visit<false>(y, x, steps, from, far);
                    found[y] += behind[at] >= 0 ? 1 : 0;
                }
            }
        });
        std::size_t total = 0;
        for (const std::size_t each : found) {
            total += each;
        }
        return total;
    }

   private:
    static constexpr std::size_t block = 32, most_rings = 255;

    // Offset to another point. distance: length (pixels); down, right: rows, columns; along: difference of the points' indices.
    struct Step {
        float distance;
        std::int32_t down, right, along;
    };

    bool inner(std::size_t y, std::size_t x, std::size_t reach) const {
        return y >= reach && x >= reach && y + reach < height_ && x + reach < width_;
    }

    // Lower bound, at each point p, on the minimum over points q of blur radius(q) + distance(q, p), from two sweeps over
    // pixels. Step lengths are multiplied by cos(pi / 8), the smallest ratio of a straight line to a path over 8 neighbours. If
    // the bound is not below radius(p), p occludes nothing. Returns an empty vector if no point occludes any.
    LOMMEL_KERNEL std::vector<float> lowest() const {
        constexpr float straight = 0.92387f, slanted = 1.30655f;  // cos(pi / 8), and sqrt(2) times that, rounded down
        std::vector<float> least(radius_, radius_ + height_ * width_);
        std::vector<float> row(width_);
        bool any = false;
        const auto sweep = [&](bool up) {
            for (std::size_t k = 0; k < height_; ++k) {
                if (k % 256 == 0) {
                    look();
                }
                const std::size_t y = up ? height_ - 1 - k : k;
                float* const here = least.data() + y * width_;
                if (k > 0) {
                    const float* const other = up ? here + width_ : here - width_;
                    for (std::size_t x = 0; x < width_; ++x) {
                        row[x] = std::min(here[x], other[x] + straight);
                    }
                    for (std::size_t x = 1; x < width_; ++x) {
                        row[x] = std::min(row[x], other[x - 1] + slanted);
                    }
                    for (std::size_t x = 0; x + 1 < width_; ++x) {
                        row[x] = std::min(row[x], other[x + 1] + slanted);
                    }
                    std::copy(row.begin(), row.end(), here);
                }
                for (std::size_t x = 1; x < width_; ++x) {
                    here[x] = std::min(here[x], here[x - 1] + straight);
                }
                for (std::size_t x = width_; x-- > 1;) {
                    here[x - 1] = std::min(here[x - 1], here[x] + straight);
                }
            }
        };
        sweep(false), sweep(true);
        for (std::size_t i = 0; i < least.size() && !any; ++i) {
            any = least[i] < radius_[i];
        }
        return any ? least : std::vector<float>();
    }

    // For each block of pixels, the minimum blur radius over this block and over all blocks with pixels up to `reach` around it.
    LOMMEL_KERNEL std::vector<float> least_around(std::size_t reach) const {
        const std::size_t rows = (height_ + block - 1) / block, columns = (width_ + block - 1) / block;
        const std::size_t more = (reach + block - 1) / block;
        std::vector<float> least(rows * columns, std::numeric_limits<float>::infinity()), wide(least), both(least);
        for (std::size_t y = 0; y < height_; ++y) {
            for (std::size_t x = 0; x < width_; ++x) {
                float& value = least[y / block * columns + x / block];
                value = std::min(value, radius_[y * width_ + x]);
            }
        }
        for (std::size_t y = 0; y < rows; ++y) {
            for (std::size_t x = 0; x < columns; ++x) {
                const float* const row = least.data() + y * columns;
                wide[y * columns + x] = *std::min_element(row + x - std::min(x, more), row + std::min(columns, x + more + 1));
            }
        }
        for (std::size_t y = 0; y < rows; ++y) {
            for (std::size_t other = y - std::min(y, more); other < std::min(rows, y + more + 1); ++other) {
                for (std::size_t x = 0; x < columns; ++x) {
                    both[y * columns + x] = std::min(both[y * columns + x], wide[other * columns + x]);
                }
            }
        }
        return both;
    }

    // Offsets to all points up to `reach` pixels away in order of distance, those of equal distance in row order.
    std::vector<Step> by_distance(std::size_t reach) const {
        const auto most = static_cast<std::int32_t>(reach);
        std::vector<Step> steps;
        for (std::int32_t down = -most; down <= most; ++down) {
            for (std::int32_t right = -most; right <= most; ++right) {
                const double squared = static_cast<double>(down) * down + static_cast<double>(right) * right;
                if (squared > 0.0 && squared <= static_cast<double>(most) * most) {
                    steps.push_back({static_cast<float>(std::sqrt(squared)), down, right,
                                     down * static_cast<std::int32_t>(width_) + right});
                }
            }
        }
        std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.distance < b.distance; });
        return steps;
    }

    // For each point, a radius (at most `most` pixels) within which no point's layer is farther than its own. Found by dilation by
    // octagons (squares and diamonds alternately), which contain the circles of these radii.
    LOMMEL_KERNEL std::vector<std::uint8_t> alone(std::size_t most) const {
        const std::size_t height = height_, width = width_;
        std::vector<std::uint8_t> farthest(layers_, layers_ + height * width), wide(farthest), result(farthest.size(), 0);
        for (std::size_t ring = 1; ring <= most; ++ring) {
            look();
            for (std::size_t y = 0; y < height; ++y) {
                const std::uint8_t* const here = farthest.data() + y * width;
                std::uint8_t* const row = wide.data() + y * width;
                row[0] = std::max(here[0], here[std::min<std::size_t>(1, width - 1)]);
                for (std::size_t x = 1; x + 1 < width; ++x) {
                    row[x] = std::max(std::max(here[x - 1], here[x]), here[x + 1]);
                }
                row[width - 1] = std::max(here[width - 1], here[width - std::min<std::size_t>(2, width)]);
            }
            // Odd rings (squares) include the diagonal neighbours, even rings (diamonds) do not.
            const std::vector<std::uint8_t> previous = ring % 2 == 1 ? wide : farthest;
            for (std::size_t y = 0; y < height; ++y) {
                const std::uint8_t *const row = wide.data() + y * width, *const own = layers_ + y * width;
                const std::uint8_t* const above = previous.data() + (y > 0 ? y - 1 : y) * width;
                const std::uint8_t* const below = previous.data() + (y + 1 < height ? y + 1 : y) * width;
                std::uint8_t *const to = farthest.data() + y * width, *const count = result.data() + y * width;
                for (std::size_t x = 0; x < width; ++x) {
                    to[x] = std::max(std::max(above[x], below[x]), row[x]);
                    count[x] = static_cast<std::uint8_t>(count[x] + (to[x] <= own[x] ? 1 : 0));
                }
            }
        }
        return result;
    }

    bool holds(std::ptrdiff_t y, std::ptrdiff_t x) const {
        return y >= 0 && x >= 0 && y < static_cast<std::ptrdiff_t>(height_) && x < static_cast<std::ptrdiff_t>(width_);
    }

    // Index of the representative point for the light behind point (y, x), or -1. Steps before index `from` lead to no farther
    // layer; points at distances of `far` or more cannot be occluded. `Inner`: no step leaves the image.
    template <bool Inner>
    LOMMEL_KERNEL std::int32_t visit(std::size_t y, std::size_t x, const std::vector<Step>& steps, std::size_t from,
                                     float far) const {
        const auto row = static_cast<std::ptrdiff_t>(y), column = static_cast<std::ptrdiff_t>(x);
        const std::ptrdiff_t at = row * static_cast<std::ptrdiff_t>(width_) + column;
        std::uint8_t passed = layers_[at];
        for (std::size_t k = from; k < steps.size(); ++k) {
            const Step& step = steps[k];
            if (step.distance >= far) {
                break;
            }
            if (!Inner && !holds(row + step.down, column + step.right)) {
                continue;
            }
            const std::ptrdiff_t other = at + step.along;
            if (layers_[other] > passed) {
                if (step.distance < radius_[at] - radius_[other]) {
                    const std::ptrdiff_t beyond = at + 2 * static_cast<std::ptrdiff_t>(step.along);
                    const bool there = holds(row + 2 * step.down, column + 2 * step.right) && layers_[beyond] > passed;
                    return static_cast<std::int32_t>(there ? beyond : other);
                }
                passed = layers_[other];
            }
        }
        return -1;
    }

    const std::uint8_t* layers_;
    const float* radius_;
    std::size_t height_, width_;
    int threads_;
};

}  // namespace lommel
