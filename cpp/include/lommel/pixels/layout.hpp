// Distinct radii of a centred grid, and the index of the radius of each pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/pixels/render.hpp"

namespace lommel {

// Radii, rising; padded so that the widest kernel can read anywhere. In units of their own.
struct Radii {
    Doubles radii;
    std::size_t count = 0;  // radii that are not padding
    double reach() const { return radii.back(); }
};

struct Layout : Radii {  // distinct radii in pixels
    std::size_t height, width;
    std::vector<std::int32_t> index;  // quadrant, (height / 2 + 1) x (width / 2 + 1): rank of each pixel's radius

    Layout(std::size_t h, std::size_t w) : height(h), width(w), index((h / 2 + 1) * (w / 2 + 1)) {
        const SquaredRadii squares(h / 2, w / 2);
        squares.ranks(index.data());
        count = squares.count();
        radii.resize(count + padding);
        squares.each([&](std::size_t rank, std::size_t s) { radii[rank] = static_cast<double>(s); });
        std::transform(radii.begin(), radii.begin() + count, radii.begin(), [](double s) { return std::sqrt(s); });
        std::fill(radii.begin() + count, radii.end(), radii[count - 1]);
    }

    static constexpr std::size_t padding = widest_step;
    std::size_t bytes() const { return sizeof(double) * radii.size() + sizeof(std::int32_t) * index.size(); }

    bool is(std::size_t h, std::size_t w) const { return height == h && width == w; }

    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
    static std::shared_ptr<const Layout> get(std::size_t h, std::size_t w) { return cache<Layout>.get(h, w); }
};

}  // namespace lommel
