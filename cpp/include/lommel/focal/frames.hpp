// Reader of camera frames: binned rows in electrons / exposure, with marks for unknown pixels.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// Camera frame: raw values, their calibration, and a mask of known pixels.
struct FocalFrame {
    enum class Kind { bytes, words, floats };

    const void* data;
    Kind kind;
    std::size_t stride;         // row stride in values
    float full;                 // values >= full are saturated, hence unknown
    float offset;               // dark level
    float gain[6];              // electrons per value: coefficients of 1, x, x^2, y, x y, y^2; x, y = -1 .. 1 over the frame
    const std::uint8_t* known;  // mask: 1 known, 0 unknown, 2 illuminated but not to be trusted; null: all pixels are known
    std::size_t known_stride;

    float value(std::size_t at) const {
        return kind == Kind::bytes   ? static_cast<float>(static_cast<const std::uint8_t*>(data)[at])
               : kind == Kind::words ? static_cast<float>(static_cast<const std::uint16_t*>(data)[at])
                                     : static_cast<const float*>(data)[at];
    }
    // Return work(values of row y), for values of their type.
    template <class Work>
    LOMMEL_INLINE auto row(std::size_t y, const Work& work) const {
        switch (kind) {
            case Kind::bytes:
                return work(static_cast<const std::uint8_t*>(data) + y * stride);
            case Kind::words:
                return work(static_cast<const std::uint16_t*>(data) + y * stride);
            default:
                return work(static_cast<const float*>(data) + y * stride);
        }
    }
    bool even() const { return gain[1] == 0.0f && gain[2] == 0.0f && gain[3] == 0.0f && gain[4] == 0.0f && gain[5] == 0.0f; }
};

// Reader of frame rows, in which squares of `binning` x `binning` pixels are summed; height and width count these squares.
class FocalReader {
   public:
    FocalReader(std::size_t height, std::size_t width, std::size_t binning)
        : height_(height), width_(width), binning_(binning) {}

    // Write row y of binned pixels to `out`, and set marks in `unknown`: 2 unknown, 1 not trusted. Returns whether any is set.
    template <class I>
    LOMMEL_INLINE bool operator()(I isa, const FocalFrame& frame, std::size_t y, float* out, float* unknown) const {
        return frame.row(y * binning_,
                         [&](const auto* from) LOMMEL_INLINE_LAMBDA { return rows(isa, frame, from, y, out, unknown); });
    }

   private:
    template <class I, class T>
    LOMMEL_INLINE bool rows(I isa, const FocalFrame& frame, const T* first, std::size_t y, float* out, float* unknown) const {
        binning_ == 1   ? copy<1>(first, frame.stride, out)
        : binning_ == 2 ? copy<2>(first, frame.stride, out)
                        : copy<4>(first, frame.stride, out);
        bool any = false;
        // Quick test before the search by pixel: if raw values are not negative, the sum of a square with a saturated pixel is at
        // least frame.full. The sum of a square with a non-finite pixel is not finite.
        constexpr std::size_t lanes = 2 * I::lanes;
        float most[lanes], all[lanes] = {};
        std::fill_n(most, lanes, -std::numeric_limits<float>::infinity());
        const auto judge = [&](std::size_t x, std::size_t l) LOMMEL_INLINE_LAMBDA {
            most[l] = out[x] > most[l] ? out[x] : most[l];
            all[l] += out[x] * 0.0f;
        };
        std::size_t x = 0;
        for (; x + lanes <= width_; x += lanes) {
            for (std::size_t l = 0; l < lanes; ++l) {
                judge(x + l, l);
            }
        }
        for (; x < width_; ++x) {
            judge(x, 0);
        }
        const float largest = *std::max_element(most, most + lanes), finite = std::accumulate(all, all + lanes, 0.0f);
        if (frame.known != nullptr || largest >= frame.full || !(finite == 0.0f)) {
            any = look_for(frame, y, unknown);
        }
        scale(isa, frame, y, out);
        if (any) {
            fill(out, unknown);
        }
        return any;
    }

    template <std::size_t B, class T>
    LOMMEL_INLINE void copy(const T* from, std::size_t stride, float* out) const {
        for (std::size_t x = 0; x < width_; ++x) {
            if constexpr (B == 1) {
                out[x] = static_cast<float>(from[x]);
            } else {
                using Sum = std::conditional_t<std::is_same_v<T, float>, float, std::int32_t>;
                Sum sum = 0;
                for (std::size_t i = 0; i < B; ++i) {
                    for (std::size_t j = 0; j < B; ++j) {
                        sum += static_cast<Sum>(from[i * stride + B * x + j]);
                    }
                }
                out[x] = static_cast<float>(sum);
            }
        }
    }

    // Mark unknown and untrusted pixels. Compiled once, as vectors do not accelerate a branch per pixel.
    LOMMEL_NOINLINE bool look_for(const FocalFrame& frame, std::size_t y, float* unknown) const {
        bool any = false;
        for (std::size_t i = 0; i < binning_; ++i) {
            const std::uint8_t* const known = frame.known ? frame.known + (y * binning_ + i) * frame.known_stride : nullptr;
            for (std::size_t x = 0; x < width_ * binning_; ++x) {
                const float value = frame.value((y * binning_ + i) * frame.stride + x);
                const bool lost = !(value < frame.full) || (known && known[x] == 0) || !(value * 0.0f == 0.0f);
                if (lost || (known && known[x] != 1)) {
                    float& square = unknown[x / binning_];
                    square = lost ? lost_square : square == 0.0f ? 1.0f : square;
                    any = true;
                }
            }
        }
        return any;
    }

    template <class I>
    LOMMEL_INLINE void scale(I, const FocalFrame& frame, std::size_t y, float* out) const {
        const float offset = frame.offset * static_cast<float>(binning_ * binning_);
        if (frame.even()) {
            const float gain = frame.gain[0];
            for (std::size_t x = 0; x < width_; ++x) {
                out[x] = gain * (out[x] - offset);
            }
            return;
        }
        const float* const g = frame.gain;
        const float down = place(y, height_), step = 2.0f / static_cast<float>(width_);
        const float a = g[0] + down * (g[3] + down * g[5]), b = g[1] + down * g[4];
        for (std::size_t x = 0; x < width_; ++x) {
            const float across = (static_cast<float>(static_cast<std::int32_t>(x)) + 0.5f) * step - 1.0f;
            out[x] = (a + across * (b + across * g[2])) * (out[x] - offset);
        }
    }
    static float place(std::size_t i, std::size_t side) {
        return (static_cast<float>(i) + 0.5f) * 2.0f / static_cast<float>(side) - 1.0f;
    }

    // Interpolate unknown pixels linearly between known neighbours in the row; a row without known pixels becomes 0.
    LOMMEL_NOINLINE void fill(float* out, const float* unknown) const {
        std::size_t x = 0;
        while (x < width_) {
            if (unknown[x] != lost_square) {
                ++x;
                continue;
            }
            std::size_t end = x;
            while (end < width_ && unknown[end] == lost_square) {
                ++end;
            }
            const float before = x > 0 ? out[x - 1] : end < width_ ? out[end] : 0.0f;
            const float after = end < width_ ? out[end] : before;
            const float slope = (after - before) / static_cast<float>(end - x + 1);
            for (std::size_t i = x; i < end; ++i) {
                out[i] = before + slope * static_cast<float>(i - x + 1);
            }
            x = end;
        }
    }

    static constexpr float lost_square = 2.0f;

    std::size_t height_, width_, binning_;
};

// Sums of raw values over the pixels known in all frames, for each of cells x cells parts of the frame:
// out[frame][row][column]. After the last frame, out[count] is the number of these pixels in each part.
class FocalSums {
   public:
    static constexpr std::size_t cells = 8;

    FocalSums(std::size_t height, std::size_t width) : height_(height), width_(width), good_(width) {}

    template <class I>
    LOMMEL_INLINE void operator()(I, const FocalFrame* frames, std::size_t count, double* out) {
        std::fill_n(out, (count + 1) * cells * cells, 0.0);
        for (std::size_t y = 0; y < height_; ++y) {
            std::fill(good_.begin(), good_.end(), std::int32_t{1});
            for (std::size_t i = 0; i < count; ++i) {
                frames[i].row(y, [&](const auto* from) LOMMEL_INLINE_LAMBDA { judge(from, frames[i], y); });
            }
            double* const at = out + y * cells / height_ * cells;
            for (std::size_t i = 0; i < count; ++i) {
                frames[i].row(y, [&](const auto* from) LOMMEL_INLINE_LAMBDA { add(from, at + i * cells * cells); });
            }
            add(good_.data(), at + count * cells * cells);
        }
    }

   private:
    template <class T>
    LOMMEL_INLINE void judge(const T* from, const FocalFrame& frame, std::size_t y) {
        const float full = frame.full;
        for (std::size_t x = 0; x < width_; ++x) {
            const float value = static_cast<float>(from[x]);
            good_[x] &= static_cast<std::int32_t>(value < full) & static_cast<std::int32_t>(value * 0.0f == 0.0f);
        }
        if (frame.known) {
            const std::uint8_t* const known = frame.known + y * frame.known_stride;
            for (std::size_t x = 0; x < width_; ++x) {
                good_[x] &= static_cast<std::int32_t>(known[x] == 1);
            }
        }
    }
    template <class T>
    LOMMEL_INLINE void add(const T* from, double* out) const {
        using Sum = std::conditional_t<std::is_same_v<T, float>, float, std::int32_t>;
        for (std::size_t c = 0; c < cells; ++c) {
            Sum sum = 0;
            for (std::size_t x = c * width_ / cells; x < (c + 1) * width_ / cells; ++x) {
                sum += good_[x] != 0 ? static_cast<Sum>(from[x]) : Sum{0};
            }
            out[c] += static_cast<double>(sum);
        }
    }

    std::size_t height_, width_;
    std::vector<std::int32_t> good_;
};

}  // namespace lommel
