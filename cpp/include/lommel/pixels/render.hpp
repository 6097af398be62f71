// Expansion of radial profiles to images, and conversion of intensities to the type of the image.
#pragma once

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"

namespace lommel {

// One side of a window whose axis is at a pixel centre or midway between two pixels. count: number of pixels; low, high: the two
// pixels that the axis is between, both the same if it is at a pixel centre.
struct FoldedSide {
    std::size_t count, low, high;

    static bool fits(std::size_t pixels, double center) {
        return center >= 0.0 && center <= static_cast<double>(pixels - 1) && 2.0 * center == std::floor(2.0 * center);
    }
    FoldedSide(std::size_t pixels, double center)
        : count(pixels), low(static_cast<std::size_t>(center)), high(low + (center > static_cast<double>(low) ? 1 : 0)) {}
    explicit FoldedSide(std::size_t pixels) : count(pixels), low(pixels / 2), high(low) {}

    bool operator==(const FoldedSide& o) const { return count == o.count && low == o.low && high == o.high; }
    std::size_t between() const { return high - low; }  // 1 if the axis is between two pixels, otherwise 0
    // Number of distinct distances from the axis. The distance of index d is that of pixels low - d and high + d.
    std::size_t distances() const { return std::max(low + 1, count - high); }
    // first(): pixel whose distance has the index `distance`, the lower one if there are two; twice(): true if there are two.
    std::size_t first(std::size_t distance) const { return distance <= low ? low - distance : high + distance; }
    bool twice(std::size_t distance) const {
        return distance <= low && high + distance < count && high + distance > low - distance;
    }
};

// Distinct squared radii dy^2 + dx^2 of the pixels of a quadrant, each with an integer number: dy^2 + dx^2 if the axis is at a
// pixel centre, dy^2 + dx^2 - 1/4 if it is between two rows or two columns, (dy^2 + dx^2 - 1/2) / 2 if between both. One bit per
// number tells whether it occurs. The rank of a radius is the number of bits set before its own: those before its word, stored
// with each word of 64 bits, and those in the word. For 512 x 512 pixels, the table takes 32 KiB.
class SquaredRadii {
   public:
    SquaredRadii(const FoldedSide& rows, const FoldedSide& columns)
        : rows_(rows.distances()), cols_(columns.distances()), odd_y_(rows.between()), odd_x_(columns.between()),
          words_(number(rows_ - 1, cols_ - 1) / 64 + 1) {
        for (std::size_t y = 0; y < rows_; ++y) {
            look();
            // If the axis is at the same offset from rows and columns, pixels (y, x) and (x, y) have one radius: mark it once.
            for (std::size_t x = odd_y_ == odd_x_ && y < std::min(rows_, cols_) ? y : 0; x < cols_; ++x) {
                const std::size_t s = number(y, x);
                words_[s / 64].bits |= std::uint64_t{1} << s % 64;
            }
        }
        for (Word& word : words_) {
            word.before = static_cast<std::uint64_t>(count_);
            count_ += set(word.bits);
        }
    }

    std::size_t count() const { return count_; }

    double square(std::size_t number) const {
        const double s = static_cast<double>(number);
        return odd_y_ + odd_x_ == 2 ? 2.0 * s + 0.5 : s + 0.25 * static_cast<double>(odd_y_ + odd_x_);
    }

    // Call take(rank, number) for the distinct radii in ascending order; square() converts the number to a squared radius.
    template <class Take>
    void each(const Take& take) const {
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            std::size_t rank = 0;
            for (std::size_t word = 0; word < words_.size(); ++word) {
                for (std::uint64_t bits = words_[word].bits; bits != 0; bits &= bits - 1) {
                    take(rank++, 64 * word + set(~bits & (bits - 1)));  // counts the zeros below the lowest set bit
                }
            }
        });
    }

    // Write index[y][x], the rank of each pixel's radius among the distinct radii.
    template <class Rank>
    void ranks(Rank* index) const {
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {  // dispatched, as newer processors count bits by one instruction
            for (std::size_t y = 0; y < rows_; ++y) {
                look();
                for (std::size_t x = 0; x < cols_; ++x) {
                    const std::size_t s = number(y, x);
                    const Word word = words_[s / 64];
                    *index++ = static_cast<Rank>(word.before + set(word.bits & ((std::uint64_t{1} << s % 64) - 1)));
                }
            }
        });
    }

   private:
    struct Word {
        std::uint64_t bits = 0, before = 0;
    };
    static LOMMEL_INLINE std::size_t set(std::uint64_t bits) { return std::bitset<64>(bits).count(); }
    LOMMEL_INLINE std::size_t number(std::size_t y, std::size_t x) const {
        return (y * (y + odd_y_) + x * (x + odd_x_)) >> (odd_y_ & odd_x_);
    }

    std::size_t rows_, cols_, odd_y_, odd_x_, count_ = 0;
    std::vector<Word> words_;
};

// Return the distinct squared radii, ascending, of (rows + 1) x (cols + 1) pixels whose first one is centred on the axis;
// index[y][x] becomes the rank of each pixel's radius.
inline std::vector<std::int64_t> distinct_radii(std::size_t rows, std::size_t cols, std::int32_t* index) {
    const SquaredRadii found(FoldedSide(2 * rows + 1), FoldedSide(2 * cols + 1));
    found.ranks(index);
    std::vector<std::int64_t> squares(found.count());
    found.each([&](std::size_t rank, std::size_t s) { squares[rank] = static_cast<std::int64_t>(s); });
    return squares;
}

// Maximum of nonnegative values, in eight independent chains that compilers vectorise.
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

inline double largest_value(const double* values, std::size_t count) {
    double top = 0.0;
    dispatch([&](auto) LOMMEL_INLINE_LAMBDA { top = largest(values, count); });
    return top;
}

// Write scale * values[i], converted to type T; `out` may be `values`.
template <class From, class T>
void store_scaled(const From* values, double scale, std::size_t count, T* out) {
    dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = static_cast<T>(scale * static_cast<double>(values[i]));
        }
    });
}
// Like store_scaled(), with results below `least` replaced by it. For an intensity, 0 as `least` does not increase the error.
template <class T>
void store_least(const double* values, double scale, std::size_t count, T least, T* out) {
    dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = std::max(static_cast<T>(scale * values[i]), least);
        }
    });
}
#if defined(LOMMEL_COMPILED)
extern template void store_scaled<double, float>(const double*, double, std::size_t, float*);
extern template void store_scaled<double, double>(const double*, double, std::size_t, double*);
extern template void store_scaled<float, float>(const float*, double, std::size_t, float*);
extern template void store_least<float>(const double*, double, std::size_t, float, float*);
extern template void store_least<double>(const double*, double, std::size_t, double, double*);
#endif

// Write profile[from[dx]] to the pixels dx to the right and dx to the left of the axis. Not inlined: callers with few free
// registers would reload the end of the loop for each pixel.
template <class T, class Rank>
LOMMEL_NOINLINE void mirrored_row(const T* profile, const Rank* from, std::size_t count, T* right, T* left) {
    for (std::size_t dx = 0; dx < count; ++dx) {
        const T value = profile[from[dx]];
        right[dx] = value;
        *(left - dx) = value;
    }
}

// Write the image rows whose distances from the axis have indices [first, last), on both sides of the axis. Each pixel is
// profile[index of its radius]. Mirrored rows are copied. The speed is limited by loads of profile values and by memory writes.
template <class T, class Rank>
LOMMEL_INLINE void scatter_rows(const T* profile, const Rank* index, const FoldedSide& rows, const FoldedSide& columns,
                                std::size_t first, std::size_t last, T* out) {
    const std::size_t width = columns.count, right = width - columns.high, left = columns.low + 1, both = std::min(left, right);
    constexpr std::size_t ahead = 6;  // number of rows between prefetch and use; rows of large images are not in a cache
    for (std::size_t dy = first; dy < last; ++dy) {
        const Rank* from = index + dy * columns.distances();
        T* row = out + rows.first(dy) * width;
        if (dy + ahead < last && width * sizeof(T) >= 1024) {
            for (std::size_t x = 0; x < width; x += 64 / sizeof(T)) {
                if (dy + ahead <= rows.low) {
                    prefetch(out + (rows.low - dy - ahead) * width + x);
                }
                if (rows.high + dy + ahead < rows.count) {
                    prefetch(out + (rows.high + dy + ahead) * width + x);
                }
            }
        }
        mirrored_row(profile, from, both, row + columns.high, row + columns.low);
        for (std::size_t dx = both; dx < right; ++dx) {
            row[columns.high + dx] = profile[from[dx]];
        }
        for (std::size_t dx = both; dx < left; ++dx) {
            row[columns.low - dx] = profile[from[dx]];
        }
        if (rows.twice(dy)) {
            T* const other = out + (rows.high + dy) * width;
            if (width >= 128) {
                std::memcpy(other, row, width * sizeof(T));
            } else {
                for (std::size_t x = 0; x < width; ++x) {
                    other[x] = row[x];
                }
            }
        }
    }
}

}  // namespace lommel
