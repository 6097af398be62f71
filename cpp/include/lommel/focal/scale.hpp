// Magnification of frames about their centre, to correct focus breathing (magnification that changes with focus).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/focal/frames.hpp"

namespace lommel {

// Resampling along one axis by eight taps of a sinc with a Kaiser window, normalized to the sum 1. The frequency response
// deviates from 1 by at most 0.4 % up to 0.3 cycles per pixel, for any subpixel shift.
class FocalAxis {
   public:
    static constexpr std::size_t taps = 8;

    FocalAxis(std::size_t side, double scale) : side_(side), first_(side), weights_(taps * side) {
        const double middle = 0.5 * (static_cast<double>(side) - 1.0);
        for (std::size_t x = 0; x < side; ++x) {
            const double from = middle + scale * (static_cast<double>(x) - middle), whole = std::floor(from);
            first_[x] = static_cast<std::ptrdiff_t>(whole) - 3;
            double value[taps], sum = 0.0;
            for (std::size_t k = 0; k < taps; ++k) {
                const double away = from - whole + 3.0 - static_cast<double>(k);
                value[k] = sinc(away) * bessel(5.0 * std::sqrt(std::max(0.0, 1.0 - away * away / 16.0)));
                sum += value[k];
            }
            for (std::size_t k = 0; k < taps; ++k) {
                weights_[k * side + x] = static_cast<float>(value[k] / sum);
            }
        }
    }

    // The eight source pixels of pixel x: first(x): index of the first; inside(x): all are in the frame; weight(k, x): weight of
    // the k-th. weights(k): weight of the k-th source pixel of each pixel.
    std::ptrdiff_t first(std::size_t x) const { return first_[x]; }
    bool inside(std::size_t x) const { return first_[x] >= 0 && first_[x] + std::ptrdiff_t{taps} <= std::ptrdiff_t(side_); }
    float weight(std::size_t k, std::size_t x) const { return weights_[k * side_ + x]; }
    const float* weights(std::size_t k) const { return weights_.data() + k * side_; }

   private:
    static double sinc(double x) {
        const double y = pi * x;
        return std::abs(y) < 1e-9 ? 1.0 : std::sin(y) / y;
    }
    // Bessel function I_0(x) for x <= 5, by its power series.
    static double bessel(double x) {
        double sum = 1.0, term = 1.0;
        for (int k = 1; k < 24; ++k) {
            term *= 0.25 * x * x / (k * k);
            sum += term;
        }
        return sum;
    }

    std::size_t side_;
    std::vector<std::ptrdiff_t> first_;
    Floats weights_;
};

// Magnification of frames about their centre, computed in parallel strips of rows.
class FocalScale {
   public:
    // An output pixel samples the frame at `scale` times its own distance from the centre.
    FocalScale(std::size_t height, std::size_t width, double scale, std::size_t threads)
        : height_(height), width_(width), down_(height, scale), across_(width, scale), threads_(threads),
          room_(threads * (FocalAxis::taps + 1) * width) {}

    std::size_t height() const { return height_; }
    std::size_t width() const { return width_; }

    // Write the resampled frame, in raw values; NaN where any source pixel is outside the frame, saturated or unknown.
    void operator()(const FocalFrame& frame, float* out) {
        constexpr std::size_t taps = FocalAxis::taps;
        parallel_for(threads_, static_cast<int>(threads_), [&](std::size_t, std::size_t s) {
            float* const values = room_.data() + s * (taps + 1) * width_;
            float* const ring = values + width_;
            std::ptrdiff_t next = 0;  // next frame row to enter the ring buffer
            for (std::size_t y = height_ * s / threads_; y < height_ * (s + 1) / threads_; ++y) {
                float* const to = out + y * width_;
                if (!down_.inside(y)) {
                    std::fill_n(to, width_, unknown);
                    continue;
                }
                for (next = std::max(next, down_.first(y)); next < down_.first(y) + std::ptrdiff_t{taps}; ++next) {
                    row(frame, static_cast<std::size_t>(next), values, ring + static_cast<std::size_t>(next) % taps * width_);
                }
                for (std::size_t k = 0; k < taps; ++k) {
                    const float* const from = ring + (static_cast<std::size_t>(down_.first(y)) + k) % taps * width_;
                    const float weight = down_.weight(k, y);
                    for (std::size_t x = 0; x < width_; ++x) {
                        to[x] = (k == 0 ? 0.0f : to[x]) + weight * from[x];
                    }
                }
            }
        });
    }

   private:
    static constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

    // Resample row y of a frame along x to `out`; `values` is working memory.
    void row(const FocalFrame& frame, std::size_t y, float* values, float* out) const {
        const std::uint8_t* const known = frame.known ? frame.known + y * frame.known_stride : nullptr;
        for (std::size_t x = 0; x < width_; ++x) {
            const float value = frame.value(y * frame.stride + x);
            values[x] = value < frame.full && (!known || known[x] == 1) ? value : unknown;
        }
        for (std::size_t x = 0; x < width_;) {
            // Resample one run of pixels whose source pixels all lie at the same offset from them.
            const std::ptrdiff_t shift = across_.first(x) - static_cast<std::ptrdiff_t>(x);
            std::size_t end = x;
            while (end < width_ && across_.inside(end) && across_.first(end) - static_cast<std::ptrdiff_t>(end) == shift) {
                ++end;
            }
            for (std::size_t k = 0; k < FocalAxis::taps && end > x; ++k) {
                const float *const from = values + shift + static_cast<std::ptrdiff_t>(k), *const weight = across_.weights(k);
                for (std::size_t i = x; i < end; ++i) {
                    out[i] = (k == 0 ? 0.0f : out[i]) + weight[i] * from[i];
                }
            }
            if (end == x) {
                out[end++] = unknown;
            }
            x = end;
        }
    }

    std::size_t height_, width_;
    FocalAxis down_, across_;
    std::size_t threads_;
    Floats room_;
};

}  // namespace lommel
