// Quantization of intensities to 8-bit levels, by comparison with the edges between levels.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "lommel/base/parallel.hpp"

namespace lommel {

// Lookup table over the leading bits (exponent and part of the fraction) of a positive float. Floats with equal leading bits form
// an interval; enough bits are used that it contains at most one edge. Tabulated: this edge, and how many are below the interval.
class Levels {
   public:
    // `edges` between levels: increasing, positive, at most 255 of them.
    Levels(const float* edges, std::size_t count) : least_(0.0f), most_(edges[count - 1]) {
        while (!separated(edges, count)) {
            --shift_;
        }
        first_ = (bits(edges[0]) - 1) >> shift_;  // an edge may coincide with the start of an interval
        const std::uint32_t start = first_ << shift_;
        std::memcpy(&least_, &start, sizeof least_);
        const std::size_t size = (bits(most_) >> shift_) - first_ + 1;
        edge_.assign(size, std::numeric_limits<float>::infinity());
        below_.resize(size);
        for (std::size_t i = 0; i < count; ++i) {
            edge_[(bits(edges[i]) >> shift_) - first_] = edges[i];
        }
        std::uint8_t reached = 0;
        for (std::size_t i = 0; i < size; ++i) {
            below_[i] = reached;
            reached = static_cast<std::uint8_t>(reached + (edge_[i] <= most_ ? 1 : 0));
        }
    }

    // Copy of the table's addresses that stays in registers: output bytes may alias any object, and would force reloads.
    struct Reader {
        const float* edge;
        const std::uint8_t* below;
        float least, most;
        std::uint32_t first;
        int shift;

        std::uint8_t operator()(float light) const {
            const float inside = light > least ? std::min(light, most) : least;  // NaN gives the lowest level
            const std::uint32_t at = (bits(inside) >> shift) - first;
            return static_cast<std::uint8_t>(below[at] + (inside >= edge[at] ? 1 : 0));
        }
    };
    Reader reader() const { return {edge_.data(), below_.data(), least_, most_, first_, shift_}; }

   private:
    static std::uint32_t bits(float x) {
        std::uint32_t b;
        std::memcpy(&b, &x, sizeof b);
        return b;
    }
    bool separated(const float* edges, std::size_t count) const {
        for (std::size_t i = 1; i < count; ++i) {
            if (bits(edges[i - 1]) >> shift_ == bits(edges[i]) >> shift_) {
                return false;
            }
        }
        return true;
    }

    int shift_ = 23;
    std::uint32_t first_;
    float least_, most_;
    std::vector<float> edge_;  // [interval]: the edge in it, or infinity
    std::vector<std::uint8_t> below_;
};

// Write the level of each intensity; returns the number of intensities below `low` or above `high`.
inline std::size_t levels(const float* light, std::size_t size, const float* edges, std::size_t count, float low, float high,
                          int threads, std::uint8_t* out) {
    constexpr std::size_t part = 1 << 16;
    const Levels known(edges, count);
    std::atomic<std::size_t> beyond{0};
    parallel_for((size + part - 1) / part, threads, [&](std::size_t, std::size_t task) {
        const std::size_t last = std::min(size, (task + 1) * part);
        const Levels::Reader level = known.reader();
        for (std::size_t i = task * part; i < last; ++i) {
            out[i] = level(light[i]);
        }
        std::uint32_t here = 0;  // 32 bits like the floats, so that the loop vectorizes
        for (std::size_t i = task * part; i < last; ++i) {
            here += static_cast<std::uint32_t>(light[i] < low) + static_cast<std::uint32_t>(light[i] > high);
        }
        beyond += here;
    });
    return beyond;
}

}  // namespace lommel
