// Averages over pixels from finer samples, by a filter along rows and along columns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Taps about the middle of a pixel that is `stride` samples wide.
struct PixelFilter {
    const double* weights;
    std::size_t taps, stride;

    // Of pixels side by side, whose first takes the first sample.
    std::size_t samples(std::size_t pixels) const { return (pixels - 1) * stride + taps; }

    // Images of height x width pixels, `pitch` values apart, from samples(height) x samples(width) each; no average of an intensity
    // is negative, and none less exact for being raised to 0. Sums are of doubles, for single precision would cost them the
    // tolerance.
    template <class T>
    void average(const T* from, std::size_t count, std::size_t height, std::size_t width, double* to, std::size_t pitch,
                 int threads) const {
        const std::size_t tall = samples(height), wide = samples(width);
        parallel_for(count * height, threads, [&](std::size_t, std::size_t i) {
            thread_local Doubles line, strands;
            thread_local std::vector<std::size_t> lines;
            const std::size_t row = i % height;
            const T* rows = from + (i / height * tall + row * stride) * wide;
            double* pixels = to + i / height * pitch + row * width;
            look();
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                line.resize(wide);
                lines.resize(taps);
                for (std::size_t k = 0; k < taps; ++k) {
                    lines[k] = k * wide;
                }
                sums(isa, rows, lines.data(), wide, line.data());
                along(isa, wide, width, line, strands, lines, pixels);
            });
        });
    }

   private:
    // A row of pixels from a line of samples.
    template <class I>
    LOMMEL_INLINE void along(I isa, std::size_t wide, std::size_t width, Doubles& line, Doubles& strands,
                             std::vector<std::size_t>& lines, double* to) const {
        // Samples a pixel apart stand side by side in a strand.
        const std::size_t each = (wide + stride - 1) / stride;
        strands.resize(stride * each);
        for (std::size_t s = 0; s < stride; ++s) {
            double* strand = &strands[s * each];
            for (std::size_t x = s; x < wide; x += stride) {
                *strand++ = line[x];
            }
        }
        for (std::size_t k = 0; k < taps; ++k) {
            lines[k] = k % stride * each + k / stride;
        }
        sums(isa, strands.data(), lines.data(), width, to);
        for (std::size_t x = 0; x < width; ++x) {
            to[x] = std::max(to[x], 0.0);
        }
    }

    // out[x] = sum_k weights[k] from[lines[k] + x]; bound by loading samples, as many as there are products.
    template <class I, class T>
    LOMMEL_INLINE void sums(I, const T* from, const std::size_t* lines, std::size_t count, double* out) const {
        using V = typename I::pack;
        constexpr std::size_t packs = 4, step = packs * I::lanes;
        for (std::size_t x = 0; x < (count < step ? count : 0); ++x) {
            double sum = 0.0;
            for (std::size_t k = 0; k < taps; ++k) {
                sum += weights[k] * static_cast<double>(from[lines[k] + x]);
            }
            out[x] = sum;
        }
        for (std::size_t x = 0; x < count && count >= step; x += step) {
            V sum[packs] = {};
            const std::size_t at = std::min(x, count - step);
            for (std::size_t k = 0; k < taps; ++k) {
                const V weight = splat<V>(weights[k]);
                const T* line = from + lines[k] + at;
                for (std::size_t p = 0; p < packs; ++p) {
                    sum[p] = sum[p] + weight * widened<I>(line + p * I::lanes);
                }
            }
            for (std::size_t p = 0; p < packs; ++p) {
                store(out + at + p * I::lanes, sum[p]);
            }
        }
    }
};

}  // namespace lommel
