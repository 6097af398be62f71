// Where the pixels are: the distinct radii of a centred grid, and which one each pixel has.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "lommel/render.hpp"

namespace lommel {

struct Layout {
    std::size_t height, width;
    std::vector<std::int32_t> index;  // quadrant, (height / 2 + 1) x (width / 2 + 1): rank of each pixel's radius
    Doubles radii;        // distinct radii in pixels, rising; padded so that eight can be read anywhere
    std::size_t count;                // radii that are not padding

    Layout(std::size_t h, std::size_t w) : height(h), width(w), index((h / 2 + 1) * (w / 2 + 1)) {
        const std::vector<std::int64_t> squares = distinct_radii(h / 2, w / 2, index.data());
        count = squares.size();
        for (const std::int64_t s : squares) {
            radii.push_back(std::sqrt(static_cast<double>(s)));
        }
        radii.resize(count + padding, radii.back());
    }

    static constexpr std::size_t padding = widest_step;
    std::size_t bytes() const { return sizeof(double) * radii.size() + sizeof(std::int32_t) * index.size(); }
    double reach() const { return radii.back(); }

    // Layouts shared by all calls: the most recent ones, up to 96 MiB.
    static std::shared_ptr<const Layout> get(std::size_t h, std::size_t w) {
        static std::mutex mutex;
        static std::list<std::shared_ptr<const Layout>> recent;
        const std::lock_guard<std::mutex> lock(mutex);
        for (auto at = recent.begin(); at != recent.end(); ++at) {
            if ((*at)->height == h && (*at)->width == w) {
                recent.splice(recent.begin(), recent, at);
                return recent.front();
            }
        }
        recent.push_front(std::make_shared<const Layout>(h, w));
        const std::shared_ptr<const Layout> found = recent.front();
        std::size_t bytes = 0;
        for (auto at = recent.begin(); at != recent.end();) {
            bytes += (*at)->bytes();
            at = bytes > (std::size_t{96} << 20) ? recent.erase(at) : std::next(at);
        }
        return found;
    }
};

}  // namespace lommel
