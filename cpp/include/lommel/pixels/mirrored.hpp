// Groups of up to eight pixels at (+-a, +-b) and (+-b, +-a) from the axis, hence at equal distances from it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"

namespace lommel {

struct MirroredPixels {
    std::int64_t height, width, row, column;  // image size; pixel whose centre is on the axis, possibly outside the image
    struct Group {
        std::int32_t a, b;  // larger and smaller of |x| and |y|, distances from the axis in pixels
        std::int64_t square() const { return std::int64_t{a} * a + std::int64_t{b} * b; }
    };
    std::vector<Group> groups;  // in ascending order of distance from the axis

    MirroredPixels(std::int64_t h, std::int64_t w, std::int64_t r, std::int64_t c) : height(h), width(w), row(r), column(c) {
        const std::int64_t far_y = std::max(std::abs(r), std::abs(h - 1 - r));
        const std::int64_t far_x = std::max(std::abs(c), std::abs(w - 1 - c));
        const std::int64_t near_y = r < 0 ? -r : std::max<std::int64_t>(0, r - h + 1);
        const std::int64_t near_x = c < 0 ? -c : std::max<std::int64_t>(0, c - w + 1);
        // List the groups of pixels at (+-a, +-b) and (+-b, +-a), b <= a. Columns with |x| = a, if the image has any, contain
        // pixels with b = |y| from near_y to far_y; rows with |y| = a contain pixels with b = |x| from near_x to far_x.
        Glance glance;
        for (std::int64_t a = std::min(near_x, near_y); a <= std::max(far_x, far_y); ++a) {
            const bool along_x = a >= near_x && a <= far_x, along_y = a >= near_y && a <= far_y;
            std::int64_t from = 0;
            const auto add = [&](bool here, std::int64_t low, std::int64_t high) {
                high = std::min(a, high);
                for (std::int64_t b = std::max(from, low); here && b <= high; ++b) {
                    groups.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
                    from = b + 1;
                    glance();
                }
            };
            const bool y_first = near_y <= near_x;
            add(y_first ? along_x : along_y, std::min(near_x, near_y), y_first ? far_y : far_x);
            add(y_first ? along_y : along_x, std::max(near_x, near_y), y_first ? far_x : far_y);
        }
        std::stable_sort(groups.begin(), groups.end(), [&](const Group& p, const Group& q) {
            glance();
            return p.square() < q.square();
        });
    }

    // Index of the first group at least `radius` pixels from the axis.
    std::size_t first_at(double radius) const {
        const auto found = std::lower_bound(groups.begin(), groups.end(), radius * radius,
                                            [](const Group& g, double s) { return static_cast<double>(g.square()) < s; });
        return static_cast<std::size_t>(found - groups.begin());
    }

    std::size_t bytes() const { return sizeof(Group) * groups.size(); }

    bool is(std::int64_t h, std::int64_t w, std::int64_t r, std::int64_t c) const {
        return height == h && width == w && row == r && column == c;
    }

    static constexpr std::size_t most_bytes = std::size_t{48} << 20;
};

}  // namespace lommel
