// Parallel loop over the tiles of an image, for work on a tile that also writes to the neighbours of that tile.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "lommel/base/parallel.hpp"

namespace lommel {

// Tiles whose rows and columns have the same parities never write to the same pixel, so threads work on them concurrently. A
// tile of the next parities waits only for its own neighbours, so one slow thread delays few others. A pixel
// receives its contributions in the same order for any number of threads.
class Checkerboard {
   public:
    Checkerboard(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns) {
        for (std::size_t parity = 0; parity < 4; ++parity) {
            for (std::size_t row = parity / 2; row < rows; row += 2) {
                for (std::size_t column = parity % 2; column < columns; column += 2) {
                    tiles_.push_back({row, column});
                }
            }
        }
    }

    // Call work(row, column) for every tile, on at most `threads` threads.
    template <class Work>
    void each(int threads, const Work& work) const {
        std::vector<std::atomic<bool>> done(tiles_.size());
        std::atomic<bool> failed{false};
        parallel_for(tiles_.size(), threads, [&](std::size_t, std::size_t task) {
            const Tile tile = tiles_[task];
            try {
                before(tile, [&](std::size_t at) {
                    while (!done[at].load(std::memory_order_acquire) && !failed) {
                        look();
                        give_way();
                    }
                });
                if (!failed) {
                    work(tile.row, tile.column);
                }
            } catch (...) {
                failed = true;
                throw;
            }
            done[place(tile)].store(true, std::memory_order_release);
        });
    }

   private:
    struct Tile {
        std::size_t row, column;
        std::size_t parity() const { return 2 * (row % 2) + column % 2; }
    };

    std::size_t place(const Tile& tile) const { return tile.row * columns_ + tile.column; }

    // Call wait(place(neighbour)) for each neighbour of a tile that must be finished first: those of a smaller parity().
    template <class Wait>
    void before(const Tile& tile, const Wait& wait) const {
        const std::size_t bottom = std::min(rows_, tile.row + 2), right = std::min(columns_, tile.column + 2);
        for (std::size_t row = std::max<std::size_t>(tile.row, 1) - 1; row < bottom; ++row) {
            for (std::size_t column = std::max<std::size_t>(tile.column, 1) - 1; column < right; ++column) {
                const Tile other{row, column};
                if (other.parity() < tile.parity()) {
                    wait(place(other));
                }
            }
        }
    }

    std::size_t rows_, columns_;
    std::vector<Tile> tiles_;
};

}  // namespace lommel
