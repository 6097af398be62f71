// From a radial profile to a pixel grid, and from intensities to values that are stored.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"

namespace lommel {

// The centred grid has few distinct radii: all pixels (dy, dx) with the same dy^2 + dx^2 share one value.
// `index` (quadrant, (rows+1) x (cols+1)) receives the rank of each squared radius; returns the squared
// radii in rising order. Marks and ranks instead of sorting: linear in the largest squared radius.
inline std::vector<std::int64_t> distinct_radii(std::size_t rows, std::size_t cols, std::int32_t* index) {
    const std::size_t largest = rows * rows + cols * cols;
    std::vector<std::int32_t> rank(largest + 1, 0);
    for (std::size_t y = 0; y <= rows; ++y) {
        look();
        for (std::size_t x = 0; x <= cols; ++x) {
            rank[y * y + x * x] = 1;
        }
    }
    std::vector<std::int64_t> squares;
    for (std::size_t s = 0; s <= largest; ++s) {
        if (rank[s] != 0) {
            rank[s] = static_cast<std::int32_t>(squares.size());
            squares.push_back(static_cast<std::int64_t>(s));
        }
    }
    for (std::size_t y = 0; y <= rows; ++y) {
        look();
        for (std::size_t x = 0; x <= cols; ++x) {
            index[y * (cols + 1) + x] = rank[y * y + x * x];
        }
    }
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
        for (std::size_t dx = 0; dx < right; ++dx) {
            const T value = profile[from[dx]];
            center[dx] = value;
            *(center - dx) = value;
        }
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
