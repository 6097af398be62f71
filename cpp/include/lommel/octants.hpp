// Where the pixels are around an axis on a pixel: groups of up to eight that differ in signs and order of |x|, |y| only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

namespace lommel {

struct Octants {
    std::int64_t height, width, row, column;  // of the image, and of the axis (which may be outside)
    struct Group {
        std::int32_t a, b;  // a >= b >= 0, in pixels
        std::int64_t square() const { return std::int64_t{a} * a + std::int64_t{b} * b; }
    };
    std::vector<Group> groups;  // by rising distance

    Octants(std::int64_t h, std::int64_t w, std::int64_t r, std::int64_t c) : height(h), width(w), row(r), column(c) {
        const std::int64_t far_y = std::max(std::abs(r), std::abs(h - 1 - r));
        const std::int64_t far_x = std::max(std::abs(c), std::abs(w - 1 - c));
        const std::int64_t near_y = r < 0 ? -r : std::max<std::int64_t>(0, r - h + 1);
        const std::int64_t near_x = c < 0 ? -c : std::max<std::int64_t>(0, c - w + 1);
        const auto within = [](std::int64_t x, std::int64_t low, std::int64_t high) { return x >= low && x <= high; };
        for (std::int64_t a = 0; a <= std::max(far_x, far_y); ++a) {
            for (std::int64_t b = 0; b <= a; ++b) {
                if ((within(a, near_x, far_x) && within(b, near_y, far_y)) ||
                    (within(b, near_x, far_x) && within(a, near_y, far_y))) {
                    groups.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
                }
            }
        }
        std::stable_sort(groups.begin(), groups.end(),
                         [](const Group& p, const Group& q) { return p.square() < q.square(); });
    }

    // The first group at a distance of at least `radius` pixels.
    std::size_t first_at(double radius) const {
        const auto found = std::lower_bound(groups.begin(), groups.end(), radius * radius, [](const Group& g, double s) {
            return static_cast<double>(g.square()) < s;
        });
        return static_cast<std::size_t>(found - groups.begin());
    }

    std::size_t bytes() const { return sizeof(Group) * groups.size(); }

    // The most recent ones, up to 48 MiB.
    static std::shared_ptr<const Octants> get(std::int64_t h, std::int64_t w, std::int64_t r, std::int64_t c) {
        static std::mutex mutex;
        static std::list<std::shared_ptr<const Octants>> recent;
        const std::lock_guard<std::mutex> lock(mutex);
        for (auto at = recent.begin(); at != recent.end(); ++at) {
            if ((*at)->height == h && (*at)->width == w && (*at)->row == r && (*at)->column == c) {
                recent.splice(recent.begin(), recent, at);
                return recent.front();
            }
        }
        recent.push_front(std::make_shared<const Octants>(h, w, r, c));
        const std::shared_ptr<const Octants> made = recent.front();
        std::size_t bytes = 0;
        for (auto at = recent.begin(); at != recent.end();) {
            bytes += (*at)->bytes();
            at = bytes > (std::size_t{48} << 20) ? recent.erase(at) : std::next(at);
        }
        return made;
    }
};

}  // namespace lommel
