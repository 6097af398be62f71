// Distinct radii of a grid around the middle of a pixel or of an edge or a corner, and the index of the radius of each pixel.
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
    FoldedSide rows, columns;
    std::vector<std::int32_t> index;  // [distance along y][distance along x]: rank of each pixel's radius

    Layout(const FoldedSide& down, const FoldedSide& across)
        : rows(down), columns(across), index(rows.distances() * columns.distances()) {
        const SquaredRadii squares(rows, columns);
        squares.ranks(index.data());
        count = squares.count();
        radii.resize(count + padding);
        squares.each([&](std::size_t rank, std::size_t s) { radii[rank] = squares.square(s); });
        std::transform(radii.begin(), radii.begin() + count, radii.begin(), [](double s) { return std::sqrt(s); });
        std::fill(radii.begin() + count, radii.end(), radii[count - 1]);
    }

    static constexpr std::size_t padding = widest_step;
    std::size_t height() const { return rows.count; }
    std::size_t width() const { return columns.count; }
    std::size_t bytes() const { return sizeof(double) * radii.size() + sizeof(std::int32_t) * index.size(); }

    bool is(const FoldedSide& down, const FoldedSide& across) const { return rows == down && columns == across; }

    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
    static std::shared_ptr<const Layout> get(const FoldedSide& down, const FoldedSide& across) {
        return cache<Layout>.get(down, across);
    }
    // Around the middle of pixel (height / 2, width / 2).
    static std::shared_ptr<const Layout> get(std::size_t height, std::size_t width) {
        return get(FoldedSide(height), FoldedSide(width));
    }
};

}  // namespace lommel
