// Chebyshev polynomials of one small filter, applied to the rows of several images as these are read: the row of each order is
// computed `reach` rows behind that of the previous order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Index of row y with mirrored borders, for y at most one image height (`side`) outside the image.
LOMMEL_INLINE std::size_t mirrored_row(std::ptrdiff_t y, std::size_t side) {
    const auto rows = static_cast<std::ptrdiff_t>(side);
    return static_cast<std::size_t>(y < 0 ? -1 - y : y >= rows ? 2 * rows - 1 - y : y);
}

// Filters T_m(2 B - 1), with T_m the Chebyshev polynomials of order m = 0 .. degree and B a small smoothing filter: the product of
// two equal symmetric filters along rows and columns, with values[k] at distance k = 0 .. reach (1 or 2). All images have mirrored
// borders.
struct FocalTaps {
    std::size_t degree, reach;
    float values[3];
};

// Buffers of the most recent rows of several images, filtered by T_m(2 B - 1) with the filter B of FocalTaps; each buffer is reused
// cyclically. margin: number of floats beyond each end of a row.
class FocalRows {
   public:
    static constexpr std::size_t margin = 32;
    static std::size_t padded(std::size_t width) { return (width + 31) / 32 * 32 + 2 * margin; }

    // Row y of the filtered images of every order m remains available until row y + `ahead` has been read.
    FocalRows(const FocalTaps& taps, std::size_t images, std::size_t height, std::size_t width, std::size_t ahead)
        : taps_(taps), height_(height), width_(width), pitch_(padded(width)), images_(images), column_(pitch_) {
        for (std::size_t m = 0; m <= taps.degree; ++m) {
            lengths_.push_back(std::max(ahead + 2 - m * taps.reach, std::size_t{0}) + 2 * taps.reach + 1);
            starts_.push_back(total_);
            total_ += lengths_[m] * pitch_;
        }
        rows_.resize(images * total_);
    }

    std::size_t images() const { return images_; }
    const FocalTaps& taps() const { return taps_; }
    std::size_t width() const { return width_; }
    float* row(std::size_t image, std::size_t m, std::size_t y) {
        return rows_.data() + image * total_ + starts_[m] + y % lengths_[m] * pitch_ + margin;
    }

    // Compute row y of all images filtered by T_m(2 B - 1), m > 0, with the filter B of FocalTaps, by the recurrence of Chebyshev
    // polynomials.
    template <class I>
    LOMMEL_INLINE void step(I isa, std::size_t m, std::size_t y) {
        for (std::size_t image = 0; image < images_; ++image) {
            taps_.reach == 1 ? order<1>(isa, image, m, y) : order<2>(isa, image, m, y);
        }
    }

   private:
    template <std::size_t Reach, class I>
    LOMMEL_INLINE void order(I, std::size_t image, std::size_t m, std::size_t y) {
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const auto at = static_cast<std::ptrdiff_t>(y);
        const float* const here = row(image, m - 1, y);
        const float *above[Reach], *below[Reach];
        for (std::size_t k = 0; k < Reach; ++k) {
            const auto away = static_cast<std::ptrdiff_t>(k + 1);
            above[k] = row(image, m - 1, mirrored_row(at - away, height_));
            below[k] = row(image, m - 1, mirrored_row(at + away, height_));
        }
        V taps[Reach + 1];
        for (std::size_t k = 0; k <= Reach; ++k) {
            taps[k] = splat<V>(taps_.values[k]);
        }
        float* const column = column_.data() + margin;
        for (std::size_t x = 0; x < width_; x += lanes) {
            V sum = taps[0] * load<V>(here + x);
            for (std::size_t k = 0; k < Reach; ++k) {
                sum = sum + taps[k + 1] * (load<V>(above[k] + x) + load<V>(below[k] + x));
            }
            store(column + x, sum);
        }
        for (std::size_t k = 0; k < Reach; ++k) {
            column[-1 - static_cast<std::ptrdiff_t>(k)] = column[std::min(k, width_ - 1)];
            column[width_ + k] = column[width_ - 1 - std::min(k, width_ - 1)];
        }
        const bool first = m == 1;
        const float* const before = first ? here : row(image, m - 2, y);
        float* const out = row(image, m, y);
        const V factor = splat<V>(first ? 2.0f : 4.0f), once = splat<V>(first ? 0.0f : 2.0f);
        for (std::size_t x = 0; x < width_; x += lanes) {
            V sum = taps[0] * load<V>(column + x);
            for (std::size_t k = 1; k <= Reach; ++k) {
                sum = sum + taps[k] * (load<V>(column + x - k) + load<V>(column + x + k));
            }
            store(out + x, factor * sum - (once * load<V>(here + x) + load<V>(before + x)));
        }
    }

    FocalTaps taps_;
    std::size_t height_, width_, pitch_, images_, total_ = 0;
    std::vector<std::size_t> lengths_, starts_;
    Floats rows_, column_;
};

}  // namespace lommel
