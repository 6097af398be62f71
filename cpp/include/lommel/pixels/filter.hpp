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
    double lowest = 0.0;             // what averages are raised to
    const double* across = nullptr;  // those along rows, if others

    // Of pixels side by side, whose first takes the first sample.
    std::size_t samples(std::size_t pixels) const { return (pixels - 1) * stride + taps; }

    // Images of height x width pixels, `pitch` values apart, from samples(height) x samples(width) each; no average of an intensity
    // is negative, and none less exact for being raised to 0, but those of its derivatives are. Sums are of doubles, for single
    // precision would cost them the tolerance.
    template <class T>
    void average(const T* from, std::size_t count, std::size_t height, std::size_t width, double* to, std::size_t pitch,
                 int threads) const {
        // Rows that share most of their samples are summed together: these need not be loaded again.
        if (2 * (rows_together - 1) * stride < taps) {
            average<rows_together>(from, count, height, width, to, pitch, threads);
        } else {
            average<1>(from, count, height, width, to, pitch, threads);
        }
    }

   private:
    static constexpr std::size_t rows_together = 4;

    template <std::size_t Rows, class T>
    void average(const T* from, std::size_t count, std::size_t height, std::size_t width, double* to, std::size_t pitch,
                 int threads) const {
        const std::size_t tall = samples(height), wide = samples(width), groups = (height + Rows - 1) / Rows;
        // Without weight for samples that are other rows'.
        const std::size_t beside = (Rows - 1) * stride;
        std::vector<double> padded(taps + 2 * beside);
        std::copy_n(weights, taps, padded.data() + beside);
        parallel_for(count * groups, threads, [&](std::size_t, std::size_t i) {
            thread_local Doubles line, strands;
            thread_local std::vector<std::size_t> lines;
            const std::size_t row = i % groups * Rows, rows = std::min(Rows, height - row);
            const T* samples = from + (i / groups * tall + row * stride) * wide;
            double* pixels = to + i / groups * pitch + row * width;
            look();
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                line.resize(Rows * wide);
                lines.resize(taps + (rows - 1) * stride);
                for (std::size_t k = 0; k < lines.size(); ++k) {
                    lines[k] = k * wide;
                }
                sums<Rows>(isa, samples, lines, padded.data() + beside, wide, line.data());
                for (std::size_t r = 0; r < rows; ++r) {
                    along(isa, wide, width, line.data() + r * wide, strands, lines, pixels + r * width);
                }
            });
        });
    }

    // A row of pixels from a line of samples.
    template <class I>
    LOMMEL_INLINE void along(I isa, std::size_t wide, std::size_t width, const double* line, Doubles& strands,
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
        lines.resize(taps);
        for (std::size_t k = 0; k < taps; ++k) {
            lines[k] = k % stride * each + k / stride;
        }
        sums<1>(isa, strands.data(), lines, across == nullptr ? weights : across, width, to);
        for (std::size_t x = 0; x < width; ++x) {
            to[x] = std::max(to[x], lowest);
        }
    }

    // out[r][x] = sum_k of[k - r stride] from[lines[k] + x]; bound by loading samples or, of four rows, by products.
    template <std::size_t Rows, class I, class T>
    LOMMEL_INLINE void sums(I, const T* from, const std::vector<std::size_t>& lines, const double* of, std::size_t count,
                            double* out) const {
        using V = typename I::pack;
        constexpr std::size_t packs = Rows == 1 ? 4 : 2, step = packs * I::lanes;
        const auto weight = [&](std::size_t k, std::size_t r) LOMMEL_INLINE_LAMBDA {
            return of[static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(r * stride)];
        };
        for (std::size_t x = 0; x < (count < step ? count : 0); ++x) {
            for (std::size_t r = 0; r < Rows; ++r) {
                double sum = 0.0;
                for (std::size_t k = 0; k < lines.size(); ++k) {
                    sum += weight(k, r) * static_cast<double>(from[lines[k] + x]);
                }
                out[r * count + x] = sum;
            }
        }
        for (std::size_t x = 0; x < count && count >= step; x += step) {
            V sum[Rows][packs] = {};
            const std::size_t at = std::min(x, count - step);
            for (std::size_t k = 0; k < lines.size(); ++k) {
                const T* line = from + lines[k] + at;
                V samples[packs];
                for (std::size_t p = 0; p < packs; ++p) {
                    samples[p] = widened<I>(line + p * I::lanes);
                }
                for (std::size_t r = 0; r < Rows; ++r) {
                    const V each = splat<V>(weight(k, r));
                    for (std::size_t p = 0; p < packs; ++p) {
                        sum[r][p] = sum[r][p] + each * samples[p];
                    }
                }
            }
            for (std::size_t r = 0; r < Rows; ++r) {
                for (std::size_t p = 0; p < packs; ++p) {
                    store(out + r * count + at + p * I::lanes, sum[r][p]);
                }
            }
        }
    }
};

}  // namespace lommel
