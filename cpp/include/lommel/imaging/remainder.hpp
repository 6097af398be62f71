// Defocus-dependent factors of the separable products that make up a PSF beyond its window (docs/certificate.md, section 13).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "lommel/base/aligned.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/imaging/column.hpp"

namespace lommel {

// Factors of separable products as cubic polynomials of t, values[interval][power][product]; t: distance in the window bank, in
// steps, from the second of the four windows interpolated. Each power has `stride` values, a multiple of 16, padded with zeros.
template <class T>
struct RemainderCubics {
    const T* values;
    std::size_t intervals, products, stride;
};

// Write the factors of the separable products, out[product][point], at positions in a window bank, clipped to the bank's range.
template <class T>
void remainder_factors(const RemainderCubics<T>& cubics, const double* positions, std::size_t size, int threads, T* out) {
    // together: number of points that fill one cache line of the output.
    constexpr std::size_t part = std::size_t{1} << 14, together = 64 / sizeof(T);
    const std::size_t stride = cubics.stride;
    const auto last = static_cast<double>(cubics.intervals + 2);
    parallel_for((size + part - 1) / part, threads, [&](std::size_t, std::size_t task) {
        Aligned<T> made(together * stride);
        const std::size_t end = std::min(size, (task + 1) * part);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using V = Packed<decltype(isa), T>;
            constexpr std::size_t lanes = sizeof(V) / sizeof(T);
            for (std::size_t from = task * part; from < end; from += together) {
                const std::size_t count = std::min(together, end - from);
                for (std::size_t i = 0; i < count; ++i) {
                    const double at = std::min(std::max(positions[from + i], 0.0), last);
                    const std::int64_t before = std::max<std::int64_t>(static_cast<std::int64_t>(at) - 1, 0);
                    const std::size_t interval = std::min(static_cast<std::size_t>(before), cubics.intervals - 1);
                    const V t = splat<V>(static_cast<T>(at - static_cast<double>(interval + 1)));
                    const T* const power = cubics.values + 4 * interval * stride;
                    for (std::size_t k = 0; k < stride; k += lanes) {
                        const V a = load<V>(power + k), b = load<V>(power + stride + k);
                        const V c = load<V>(power + 2 * stride + k), d = load<V>(power + 3 * stride + k);
                        store(&made[i * stride + k], a + t * (b + t * (c + t * d)));
                    }
                }
                for (std::size_t r = 0; r < cubics.products; ++r) {
                    for (std::size_t i = 0; i < count; ++i) {
                        out[r * size + from + i] = made[i * stride + r];
                    }
                }
            }
        });
    });
}

#if defined(LOMMEL_COMPILED)
extern template void remainder_factors<float>(const RemainderCubics<float>&, const double*, std::size_t, int, float*);
extern template void remainder_factors<double>(const RemainderCubics<double>&, const double*, std::size_t, int, double*);
#endif

}  // namespace lommel
