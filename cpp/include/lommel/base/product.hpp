// Matrix products. BLAS libraries start threads of their own, and their sums may depend on the number of threads; these do
// neither.
#pragma once

#include <algorithm>
#include <cstddef>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"

namespace lommel {

// out[row * sums + j] = sum over i of given[row * count + i] matrix[i * sums + j].
inline void product(const double* given, std::size_t rows, std::size_t count, const double* matrix, std::size_t sums,
                    int threads, double* out) {
    constexpr std::size_t together = 8, step = 16;
    const std::size_t stride = (sums + step - 1) / step * step;
    // Columns that are not there are zero.
    const bool whole = sums == stride;
    Doubles padded(whole ? 0 : count * stride);
    for (std::size_t i = 0; i < count && !whole; ++i) {
        std::copy_n(matrix + i * sums, sums, padded.data() + i * stride);
    }
    const double* const table = whole ? matrix : padded.data();
    const double microseconds = 1e-4 * static_cast<double>(rows) * static_cast<double>(count) * static_cast<double>(sums);
    const int worth = worthwhile_threads(threads, microseconds);
    parallel_for((rows + together - 1) / together, worth, [&](std::size_t, std::size_t task) {
        const std::size_t first = task * together, some = std::min(together, rows - first);
        // Nor are there all rows.
        const bool here = whole && some == together;
        Doubles values(here ? 0 : together * count), results(here ? 0 : together * stride);
        std::copy_n(given + first * count, here ? 0 : some * count, values.data());
        const double* const from = here ? given + first * count : values.data();
        double* const to = here ? out + first * stride : results.data();
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using V = typename decltype(isa)::pack;
            constexpr std::size_t lanes = decltype(isa)::lanes;
            // Chains of multiply-adds, as many as registers hold, so that the matrix is read as seldom as may be.
            constexpr std::size_t chains = lanes == 8 ? together : together / 2;
            for (std::size_t row = 0; row < together; row += chains) {
                for (std::size_t j = 0; j < stride; j += 2 * lanes) {
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
                        store(to + (row + p) * stride + j, sum[p][0]);
                        store(to + (row + p) * stride + j + lanes, sum[p][1]);
                    }
                }
            }
        });
        for (std::size_t p = 0; p < some && !here; ++p) {
            std::copy_n(results.data() + p * stride, sums, out + (first + p) * sums);
        }
    });
}

}  // namespace lommel
