// Tiles of sixteen by sixteen pixels around the axis, with their images under reflections and rotations by 90 degrees.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace lommel {

// A pixel is (right, down) from the axis; a >= b >= 0 are |right| and |down| or the other way round. Pixels that differ in that
// only are evaluated together, in eight directions: of the angle psi = atan(b / a) those at psi + k pi/2, k = 0..3, and those
// at (k+1) pi/2 - psi.
class Tiles {
   public:
    static constexpr std::int64_t side = 16;
    static constexpr std::size_t directions = 8;
    struct Tile {
        std::int64_t a, b;  // the least
    };
    // Pixels of one a, b from so many on.
    struct Line {
        std::int64_t a, b, count;
    };

    Tiles(std::int64_t h, std::int64_t w, std::int64_t r, std::int64_t c) : height(h), width(w), row(r), column(c) {
        far_y_ = std::max(std::abs(r), std::abs(h - 1 - r));
        far_x_ = std::max(std::abs(c), std::abs(w - 1 - c));
        near_y_ = r < 0 ? -r : std::max<std::int64_t>(0, r - h + 1);
        near_x_ = c < 0 ? -c : std::max<std::int64_t>(0, c - w + 1);
    }

    const std::int64_t height, width, row, column;  // of the image, and of the axis (which may be outside)

    // Squares of the distances of the nearest and of the farthest pixel.
    std::int64_t nearest() const { return near_x_ * near_x_ + near_y_ * near_y_; }
    std::int64_t farthest() const { return far_x_ * far_x_ + far_y_ * far_y_; }

    // Those with pixels in the image.
    std::vector<Tile> all() const {
        std::vector<Tile> made;
        const std::int64_t low = std::min(near_x_, near_y_) / side * side, high = std::max(far_x_, far_y_);
        for (std::int64_t a = low; a <= high; a += side) {
            for (std::int64_t b = low; b <= a; b += side) {
                const bool tall = a <= far_x_ && a + side > near_x_ && b <= far_y_ && b + side > near_y_;
                const bool wide = a <= far_y_ && a + side > near_y_ && b <= far_x_ && b + side > near_x_;
                if (tall || wide) {
                    made.push_back({a, b});
                }
            }
        }
        return made;
    }

    // Whether all pixels of a tile are in the image in all directions, and whether one is in one of them.
    bool whole(const Tile& tile) const {
        const std::int64_t most = tile.a + side - 1;
        return most <= std::min(std::min(row, column), std::min(height - 1 - row, width - 1 - column));
    }
    bool visible(std::int64_t a, std::int64_t b, std::size_t direction) const {
        const std::int64_t right[directions] = {a, -b, -a, b, b, -a, -b, a}, down[directions] = {b, a, -b, -a, a, b, -a, -b};
        const std::int64_t x = column + right[direction], y = row + down[direction];
        return x >= 0 && x < width && y >= 0 && y < height;
    }

    // Calls f(line) for the lines of a tile whose distances have squares in [low, high).
    template <class F>
    void lines(const Tile& tile, std::int64_t low, std::int64_t high, const F& f) const {
        for (std::int64_t a = tile.a; a < tile.a + side; ++a) {
            const std::int64_t square = a * a;
            if (square >= high) {
                return;
            }
            // |x| = a and |y| = b, or the other way round: two ranges of b, which may overlap.
            std::int64_t first[2] = {near_y_, near_x_}, last[2] = {far_y_, far_x_};
            const bool here[2] = {a >= near_x_ && a <= far_x_, a >= near_y_ && a <= far_y_};
            const std::int64_t least = std::max(tile.b, root(low - square - 1) + 1);
            const std::int64_t most = std::min(std::min(a, tile.b + side - 1), root(high - 1 - square));
            for (std::size_t i = 0; i < 2; ++i) {
                first[i] = std::max(first[i], least);
                last[i] = here[i] ? std::min(last[i], most) : -1;
            }
            if (first[1] <= last[1] && first[0] <= last[0]) {
                // Pixels between them are computed in vain.
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

    // Values of one tile, square by square as they stand in the image.
    template <class T>
    struct Buffer {
        alignas(64) T squares[directions][side * side];

        // Of the pixel (a, b) of a tile, in the eight directions.
        template <class Real>
        void put(const Tile& tile, std::int64_t a, std::int64_t b, const Real* values) {
            const std::int64_t i = a - tile.a, j = b - tile.b, last = side - 1, end = side * side - 1;
            const std::int64_t wide = side * j + i, tall = side * i + j, turned = side * i + last - j,
                               other = side * j + last - i;
            const std::int64_t at[directions] = {wide, turned, end - wide, end - turned, tall, other, end - tall, end - other};
            // On the diagonal both halves make one square.
            const std::size_t twin = tile.a == tile.b ? directions / 2 : 0;
            for (std::size_t d = 0; d < directions; ++d) {
                squares[d < directions / 2 ? d : d - twin][at[d]] = static_cast<T>(values[d]);
            }
        }
    };

    template <class T>
    void copy(const Tile& tile, const Buffer<T>& buffer, T* image) const {
        const std::int64_t a = tile.a, b = tile.b, far_a = 1 - side - a, far_b = 1 - side - b;
        const std::int64_t right[directions] = {a, far_b, far_a, b, b, far_a, far_b, a};
        const std::int64_t down[directions] = {b, a, far_b, far_a, a, b, far_a, far_b};
        for (std::size_t d = 0; d < (a == b ? directions / 2 : directions); ++d) {
            const std::int64_t x = column + right[d], y = row + down[d];
            const std::int64_t first = std::max<std::int64_t>(0, -x), end = std::min(side, width - x);
            for (std::int64_t line = std::max<std::int64_t>(0, -y); line < std::min(side, height - y) && first < end; ++line) {
                const T* from = &buffer.squares[d][line * side];
                T* to = image + (y + line) * width + x;
                if (end - first == side) {
                    std::memcpy(to, from, side * sizeof(T));
                } else {
                    std::copy(from + first, from + end, to + first);
                }
            }
        }
    }

   private:
    // The largest integer whose square is at most x; -1 for negative x.
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
