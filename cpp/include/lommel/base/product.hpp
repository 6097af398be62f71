// Matrix product. Unlike BLAS libraries it starts no threads of its own, and its sums do not depend on the number of threads.
#pragma once

#include <algorithm>
#include <cstddef>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"

namespace lommel {

// out[row * sums + j] = sum over i of given[row * count + i] * matrix[i * sums + j].
inline void product(const double* given, std::size_t rows, std::size_t count, const double* matrix, std::size_t sums,
                    int threads, double* out) {
    constexpr std::size_t together = 8, step = 16;
    // For many rows, a panel of `step` columns of the matrix is first copied to contiguous memory: read in place, each row of
    // the panel would lie in another memory page.
    const bool copied = rows > 2 * together;
    const std::size_t tall = copied ? 8 * together : together, panels = (sums + step - 1) / step;
    const std::size_t parts = copied ? panels : 1, each = panels / parts;
    const double microseconds = 1e-4 * static_cast<double>(rows) * static_cast<double>(count) * static_cast<double>(sums);
    const int worth = worthwhile_threads(threads, microseconds);
    parallel_for((rows + tall - 1) / tall * parts, worth, [&](std::size_t, std::size_t task) {
        const std::size_t first = task / parts * tall, row_count = std::min(tall, rows - first);
        // At the edges of the matrices, blocks are filled up with zeros to multiples of `together` rows and to `step` columns.
        const std::size_t held = (row_count + together - 1) / together * together;
        const bool full = held == row_count;
        Doubles packed(copied || sums < panels * step ? count * step : 0), values(full ? 0 : held * count),
            results(held * step);
        std::copy_n(given + first * count, full ? 0 : row_count * count, values.data());
        const double* const from = full ? given + first * count : values.data();
        for (std::size_t panel = task % parts * each; panel < (task % parts + 1) * each; ++panel) {
            const std::size_t column = panel * step, columns = std::min(step, sums - column);
            const bool direct = columns == step && !copied, here = columns == step && full;
            for (std::size_t i = 0; i < count && !direct; ++i) {
                std::copy_n(matrix + i * sums + column, columns, packed.data() + i * step);
            }
            const double* const table = direct ? matrix + column : packed.data();
            double* const to = here ? out + first * sums + column : results.data();
            const std::size_t stride = direct ? sums : step, pitch = here ? sums : step;
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                using V = typename decltype(isa)::pack;
                constexpr std::size_t lanes = decltype(isa)::lanes;
                // Each value of the panel is read once for `chains` rows, whose running sums fill all registers.
                constexpr std::size_t chains = lanes == 8 ? together : together / 2;
                for (std::size_t row = 0; row < row_count; row += chains) {
                    for (std::size_t j = 0; j < step; j += 2 * lanes) {
                        V sum[chains][2] = {};
                        for (std::size_t i = 0; i < count; ++i) {
                            const V a = load<V>(table + i * stride + j), b = load<V>(table + i * stride + j + lanes);
                            for (std::size_t p = 0; p < chains; ++p) {
                                const V value = splat<V>(from[(row + p) * count + i]);
                                sum[p][0] = sum[p][0] + value * a;
                                sum[p][1] = sum[p][1] + value * b;
                            }
                        }
                        for (std::size_t p = 0; p < chains; ++p) {
                            store(to + (row + p) * pitch + j, sum[p][0]);
                            store(to + (row + p) * pitch + j + lanes, sum[p][1]);
                        }
                    }
                }
            });
            for (std::size_t row = 0; row < row_count && !here; ++row) {
                std::copy_n(results.data() + row * step, columns, out + (first + row) * sums + column);
            }
        }
    });
}

}  // namespace lommel
