// Tiles of 16 x 16 pixels around the axis, with their images under reflections and rotations by 90 degrees.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// A pixel `right` columns and `down` rows from the axis has the coordinates a = max(|right|, |down|) and b = min(|right|,
// |down|). The up to eight pixels with the same (a, b) are evaluated together. With psi = atan(b / a), their polar angles are
// psi + k pi/2 for direction k = 0..3, and (k + 1) pi/2 - psi for direction k + 4.
class Tiles {
   public:
    static constexpr std::int64_t side = 16;
    static constexpr std::size_t directions = 8;
    struct Tile {
        std::int64_t a, b;  // smallest coordinates a and b of the tile's pixels
    };
    // Line of pixels: coordinate a, and the `count` coordinates b, b + 1, ...
    struct Line {
        std::int64_t a, b, count;
    };

    Tiles(std::int64_t h, std::int64_t w, std::int64_t r, std::int64_t c) : height(h), width(w), row(r), column(c) {
        far_y_ = std::max(std::abs(r), std::abs(h - 1 - r));
        far_x_ = std::max(std::abs(c), std::abs(w - 1 - c));
        near_y_ = r < 0 ? -r : std::max<std::int64_t>(0, r - h + 1);
        near_x_ = c < 0 ? -c : std::max<std::int64_t>(0, c - w + 1);
    }

    const std::int64_t height, width, row, column;  // image size; pixel whose centre is on the axis, possibly outside the image

    // Squared distances of the nearest and the farthest pixel from the axis, in pixels^2.
    std::int64_t nearest() const { return near_x_ * near_x_ + near_y_ * near_y_; }
    std::int64_t farthest() const { return far_x_ * far_x_ + far_y_ * far_y_; }

    // Return all tiles that have pixels in the image.
    std::vector<Tile> all() const {
        std::vector<Tile> made;
        const std::int64_t low = std::min(near_x_, near_y_) / side * side, high = std::max(far_x_, far_y_);
        for (std::int64_t a = std::max(near_x_, near_y_) / side * side; a <= high; a += side) {
            for (std::int64_t b = low; b <= std::min(a, std::min(far_x_, far_y_)); b += side) {
                const bool tall = a <= far_x_ && a + side > near_x_ && b <= far_y_ && b + side > near_y_;
                const bool wide = a <= far_y_ && a + side > near_y_ && b <= far_x_ && b + side > near_x_;
                if (tall || wide) {
                    made.push_back({a, b});
                }
            }
        }
        return made;
    }

    // whole(): whether a tile is inside the image in all eight directions; visible(): whether pixel (a, b) is inside the image in
    // the given direction.
    bool whole(const Tile& tile) const {
        const std::int64_t most = tile.a + side - 1;
        return most <= std::min(std::min(row, column), std::min(height - 1 - row, width - 1 - column));
    }
    bool visible(std::int64_t a, std::int64_t b, std::size_t direction) const {
        const std::int64_t right[directions] = {a, -b, -a, b, b, -a, -b, a}, down[directions] = {b, a, -b, -a, a, b, -a, -b};
        const std::int64_t x = column + right[direction], y = row + down[direction];
        return x >= 0 && x < width && y >= 0 && y < height;
    }

    // Call f(line) for those pixels of a tile which are in the image in any direction, at squared distances in [low, high).
    template <class F>
    void lines(const Tile& tile, std::int64_t low, std::int64_t high, const F& f) const {
        const std::int64_t end_a = tile.a + side - 1, end_b = tile.b + side - 1;
        if (end_a * end_a + end_b * end_b < low) {
            return;
        }
        for (std::int64_t a = tile.a; a < tile.a + side; ++a) {
            const std::int64_t square = a * a;
            if (square >= high) {
                return;
            }
            // Two ranges of b, possibly overlapping: |y| of pixels with |x| = a, and |x| of pixels with |y| = a.
            std::int64_t first[2] = {near_y_, near_x_}, last[2] = {far_y_, far_x_};
            const bool here[2] = {a >= near_x_ && a <= far_x_, a >= near_y_ && a <= far_y_};
            const std::int64_t least = std::max(tile.b, root(low - square - 1) + 1);
            const std::int64_t most = std::min(std::min(a, tile.b + side - 1), root(high - 1 - square));
            for (std::size_t i = 0; i < 2; ++i) {
                first[i] = std::max(first[i], least);
                last[i] = here[i] ? std::min(last[i], most) : -1;
            }
            if (first[1] <= last[1] && first[0] <= last[0]) {
                // Merge the two ranges of b; pixels in a gap between them are computed too, but not used.
                first[0] = std::min(first[0], first[1]);
                last[0] = std::max(last[0], last[1]);
                last[1] = -1;
            }
            for (std::size_t i = 0; i < 2; ++i) {
                if (first[i] <= last[i]) {
                    f(Line{a, first[i], last[i] - first[i] + 1});
                }
            }
        }
    }

    // Values of one tile: squares[direction][a - tile.a][b - tile.b], the last two indices as one.
    template <class T>
    struct Buffer {
        alignas(64) T squares[directions][side * side];

        // Store values[pixel][direction] of a line of pixels.
        template <class Real>
        void put(const Tile& tile, const Line& line, const Real (*values)[directions]) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { put(isa, tile, line, values); });
        }

       private:
        template <class I, class Real>
        LOMMEL_INLINE void put(I, const Tile& tile, const Line& line, const Real (*values)[directions]) {
            const std::size_t at = static_cast<std::size_t>(side * (line.a - tile.a) + line.b - tile.b),
                              count = static_cast<std::size_t>(line.count);
            std::size_t i = 0;
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
            if constexpr (std::is_same_v<T, float> && std::is_same_v<Real, float>) {
                using V = typename I::floats;
                for (; i + 4 <= count; i += 4) {
                    for (std::size_t first = 0; first < directions; first += sizeof(V) / sizeof(float)) {
                        V turned[4];
                        turned_fours(load<V>(values[i] + first), load<V>(values[i + 1] + first), load<V>(values[i + 2] + first),
                                     load<V>(values[i + 3] + first), turned);
                        for (std::size_t d = 0; d < 4; ++d) {
                            std::memcpy(&squares[first + d][at + i], &turned[d], 4 * sizeof(float));
                            if constexpr (sizeof(V) == 32) {
                                std::memcpy(&squares[4 + d][at + i], reinterpret_cast<const char*>(&turned[d]) + 16,
                                            4 * sizeof(float));
                            }
                        }
                    }
                }
            }
#endif
            for (; i < count; ++i) {
                for (std::size_t d = 0; d < directions; ++d) {
                    squares[d][at + i] = static_cast<T>(values[i][d]);
                }
            }
        }
    };

    // Prefetch the memory that copy() writes.
    template <class T>
    LOMMEL_INLINE void prefetch(const Tile& tile, const T* image) const {
        for (std::size_t d = 0; d < squares(tile); ++d) {
            prefetch(tile, d, image);
        }
    }

    // Copy the values of a tile to its squares in the image, in all eight directions.
    template <class T>
    void copy(const Tile& tile, Buffer<T>& buffer, T* image) const {
        // Orientation of the tile in the image, for each direction. turned: transposed, so that a varies along image rows; up:
        // order of rows reversed; left: order of columns reversed.
        constexpr bool turned[directions] = {true, false, true, false, false, true, false, true},
                       up[directions] = {false, false, true, true, false, false, true, true},
                       left[directions] = {false, true, true, false, false, true, true, false};
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            for (std::size_t d = 0; d < squares(tile); ++d) {
                if (d + 1 < squares(tile)) {
                    prefetch(tile, d + 1, image);
                }
                T* const values = buffer.squares[d];
                if (tile.a == tile.b) {
                    for (std::int64_t i = 0; i < side; ++i) {
                        for (std::int64_t j = i + 1; j < side; ++j) {
                            values[side * i + j] = buffer.squares[d + directions / 2][side * j + i];
                        }
                    }
                }
                alignas(64) T arranged[side * side];
                const T* const square = turned[d] || left[d] ? arranged : values;
                if (turned[d]) {
                    turn(values, left[d], arranged);
                } else if (left[d]) {
                    mirror(values, arranged);
                }
                on_lines(tile, d, [&](std::int64_t line, std::int64_t at, std::int64_t first, std::int64_t end) {
                    const T* from = square + side * (up[d] ? side - 1 - line : line);
                    if (end - first == side) {
                        std::memcpy(image + at, from, side * sizeof(T));
                    } else {
                        std::copy(from + first, from + end, image + at + first);
                    }
                });
            }
        });
    }

   private:
    // Number of squares in the image that a tile fills: on the diagonal a = b, two directions share one.
    static std::size_t squares(const Tile& tile) { return tile.a == tile.b ? directions / 2 : directions; }

    // A tile stands for a square of pixels in each direction d = 0 .. 7. Call f(line, at, first, end) for each row `line` of square
    // d: its columns [first, end) lie in the image. at: image index of its column 0, which may be outside the image.
    template <class F>
    LOMMEL_INLINE void on_lines(const Tile& tile, std::size_t d, const F& f) const {
        const std::int64_t a = tile.a, b = tile.b, far_a = 1 - side - a, far_b = 1 - side - b;
        const std::int64_t right[directions] = {a, far_b, far_a, b, b, far_a, far_b, a};
        const std::int64_t down[directions] = {b, a, far_b, far_a, a, b, far_a, far_b};
        const std::int64_t x = column + right[d], y = row + down[d];
        const std::int64_t first = std::max<std::int64_t>(0, -x), end = std::min(side, width - x);
        for (std::int64_t line = std::max<std::int64_t>(0, -y); line < std::min(side, height - y) && first < end; ++line) {
            f(line, (y + line) * width + x, first, end);
        }
    }

    // Inlined, as GCC drops calls to functions that only prefetch.
    template <class T>
    LOMMEL_INLINE void prefetch(const Tile& tile, std::size_t d, const T* image) const {
        on_lines(tile, d, [&](std::int64_t, std::int64_t at, std::int64_t first, std::int64_t end) LOMMEL_INLINE_LAMBDA {
            lommel::prefetch(image + at + first);
            lommel::prefetch(image + at + end - 1);
        });
    }

    // Transpose a square of values and, if `left`, reverse each row of the result.
    template <class T>
    static void turn(const T* from, bool left, T* to) {
        constexpr std::size_t n = side;
        for (std::size_t i = 0; i < n; i += 4) {
            for (std::size_t j = 0; j < n; j += 4) {
                const T* rows[4];
                for (std::size_t k = 0; k < 4; ++k) {
                    rows[k] = from + n * (left ? n - 1 - i - k : i + k) + j;
                }
                Fours<T> columns[4];
                turn_fours(rows, columns);
                for (std::size_t k = 0; k < 4; ++k) {
                    std::memcpy(to + n * (j + k) + i, &columns[k], sizeof columns[k]);
                }
            }
        }
    }
    // Reverse each row of a square of values.
    template <class T>
    static void mirror(const T* from, T* to) {
        constexpr std::size_t n = side;
        for (std::size_t i = 0; i < n * n; i += n) {
            for (std::size_t j = 0; j < n; ++j) {
                to[i + j] = from[i + n - 1 - j];
            }
        }
    }

    template <class T>
    struct Fours {
        T at[4];
    };
    template <class T>
    static void turn_fours(const T* const* rows, Fours<T>* columns) {
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                columns[i].at[k] = rows[k][i];
            }
        }
    }
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
    static void turn_fours(const float* const* rows, Fours<float>* columns) {
        typedef float Quad __attribute__((vector_size(16)));
        Quad turned[4];
        turned_fours(load<Quad>(rows[0]), load<Quad>(rows[1]), load<Quad>(rows[2]), load<Quad>(rows[3]), turned);
        std::memcpy(columns, turned, sizeof turned);
    }
#endif

    // Largest integer whose square is at most x; -1 for negative x.
    static std::int64_t root(std::int64_t x) {
        if (x < 0) {
            return -1;
        }
        std::int64_t r = static_cast<std::int64_t>(std::sqrt(static_cast<double>(x)));
        r -= r * r > x ? 1 : 0;
        return r + ((r + 1) * (r + 1) <= x ? 1 : 0);
    }

    std::int64_t far_y_, far_x_, near_y_, near_x_;
};

}  // namespace lommel
