// Radial profiles as images, and intensities as stored values.
#pragma once

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"

namespace lommel {

// The distinct radii of a centred quadrant of (rows + 1) x (cols + 1) pixels, squared: all pixels (dy, dx) with the same
// dy^2 + dx^2 share one value. A bit for each number up to the largest square, and how many are set before: linear in that, without
// sorting, and small enough for the first cache, where a rank for each number is not.
class SquaredRadii {
   public:
    SquaredRadii(std::size_t rows, std::size_t cols) : rows_(rows), cols_(cols), words_((rows * rows + cols * cols) / 64 + 1) {
        for (std::size_t y = 0; y <= rows; ++y) {
            look();
            for (std::size_t x = y <= std::min(rows, cols) ? y : 0; x <= cols; ++x) {  // (x, y) for (y, x) where both are there
                const std::size_t s = y * y + x * x;
                words_[s / 64].bits |= std::uint64_t{1} << s % 64;
            }
        }
        for (Word& word : words_) {
            word.before = static_cast<std::uint64_t>(count_);
            count_ += set(word.bits);
        }
    }

    std::size_t count() const { return count_; }

    // The squares, rising, to take(rank, square).
    template <class Take>
    void each(const Take& take) const {
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            std::size_t rank = 0;
            for (std::size_t word = 0; word < words_.size(); ++word) {
                for (std::uint64_t bits = words_[word].bits; bits != 0; bits &= bits - 1) {
                    take(rank++, 64 * word + set(~bits & (bits - 1)));  // zeros below the last bit
                }
            }
        });
    }

    // The rank of each pixel's radius.
    void ranks(std::int32_t* index) const {
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {  // counting bits is one instruction where there are vectors
            for (std::size_t y = 0; y <= rows_; ++y) {
                look();
                for (std::size_t x = 0; x <= cols_; ++x) {
                    const std::size_t s = y * y + x * x;
                    const Word word = words_[s / 64];
                    *index++ = static_cast<std::int32_t>(word.before + set(word.bits & ((std::uint64_t{1} << s % 64) - 1)));
                }
            }
        });
    }

   private:
    struct Word {
        std::uint64_t bits = 0, before = 0;
    };
    static LOMMEL_INLINE std::size_t set(std::uint64_t bits) { return std::bitset<64>(bits).count(); }

    std::size_t rows_, cols_, count_ = 0;
    std::vector<Word> words_;
};

// The squared radii in rising order; `index` receives the rank of each pixel's.
inline std::vector<std::int64_t> distinct_radii(std::size_t rows, std::size_t cols, std::int32_t* index) {
    const SquaredRadii found(rows, cols);
    found.ranks(index);
    std::vector<std::int64_t> squares(found.count());
    found.each([&](std::size_t rank, std::size_t s) { squares[rank] = static_cast<std::int64_t>(s); });
    return squares;
}

// The largest of values >= 0, in eight chains that compilers vectorise.
LOMMEL_INLINE double largest(const double* values, std::size_t count) {
    double top[8] = {};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        for (std::size_t j = 0; j < 8; ++j) {
            top[j] = values[i + j] > top[j] ? values[i + j] : top[j];
        }
    }
    for (; i < count; ++i) {
        top[0] = values[i] > top[0] ? values[i] : top[0];
    }
    return *std::max_element(top, top + 8);
}

// Values times a scale, as the answer stores them; they may be replaced.
template <class From, class T>
LOMMEL_INLINE void store_scaled(const From* values, double scale, std::size_t count, T* out) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = static_cast<T>(scale * static_cast<double>(values[i]));
    }
}

// A row to both sides of its middle. Not inlined: where its callers have other things in registers, it loads its end from memory
// for each pixel.
template <class T>
LOMMEL_NOINLINE void mirrored_row(const T* profile, const std::int32_t* from, std::size_t count, T* center) {
    for (std::size_t dx = 0; dx < count; ++dx) {
        const T value = profile[from[dx]];
        center[dx] = value;
        *(center - dx) = value;
    }
}

// Rows [first, last) of the quadrant, and their mirror images, of one image of height x width from the values at the
// distinct radii. The centre is the middle of pixel (height / 2, width / 2). Each row is gathered once and its mirror
// images copied: bound by the loads of the gather and by memory writes.
template <class T>
LOMMEL_INLINE void scatter_rows(const T* profile, const std::int32_t* index, std::size_t height, std::size_t width,
                                std::size_t first, std::size_t last, T* out) {
    const std::size_t cy = height / 2, cx = width / 2, right = width - cx;
    for (std::size_t dy = first; dy < last; ++dy) {
        const std::int32_t* from = index + dy * (cx + 1);
        T* row = out + (cy - dy) * width;
        T* center = row + cx;
        mirrored_row(profile, from, right, center);
        if (cx >= right) {
            row[0] = profile[from[cx]];
        }
        if (dy > 0 && cy + dy < height) {
            T* below = out + (cy + dy) * width;
            if (width >= 128) {
                std::memcpy(below, row, width * sizeof(T));
            } else {
                for (std::size_t x = 0; x < width; ++x) {
                    below[x] = row[x];
                }
            }
        }
    }
}

}  // namespace lommel
