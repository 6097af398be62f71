// Pixel averages computed from finer samples of the intensity by a separable filter.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Filter for one or two adjacent pixels, which together span `stride` samples. weights[pixel][tap]: `taps` weights for each of
// these pixels; tap 0 of both is on the same sample.
struct PixelFilter {
    const double* weights;
    std::size_t taps, stride;
    double lowest = 0.0;             // lower limit to which averages are clamped
    const double* across = nullptr;  // weights along x, if they differ from those along y; otherwise null
    std::size_t pixels = 1;          // number of pixels that `stride` samples span, 1 or 2
    double dark = 0.0;               // float samples are summed in single precision where none exceeds this

    // Number of samples, along one axis, that `count` adjacent pixels use.
    std::size_t samples(std::size_t count) const { return (count - 1) / pixels * stride + taps; }

    // Average `count` images of samples(height) x samples(width) samples to images of height x width pixels, which begin `pitch`
    // values apart. Averages below `lowest`, a lower bound on the exact averages (0 for intensities), are set to it; this
    // does not increase their error.
    template <class T>
    void average(const T* from, std::size_t count, std::size_t height, std::size_t width, double* to, std::size_t pitch,
                 int threads) const;

   private:
    static constexpr std::size_t rows_together = 4;

    // Rows of fewer pixels (or pairs, if pixels = 2) than this number, the floats in two vectors, are summed in double precision.
    template <class I>
    static constexpr std::size_t least(I) {
        return 2 * sizeof(typename I::floats) / sizeof(float);
    }

    template <std::size_t Rows, class T>
    void average(const T* samples_of, std::size_t count, std::size_t height, std::size_t width, double* to, std::size_t pitch,
                 int threads) const {
        const std::size_t tall = samples(height), wide = samples(width), groups = (height + Rows - 1) / Rows;
        // `Rows` adjacent pixel rows are computed from the same samples; a row's weight is 0 for samples that only other rows use.
        const std::size_t padding = (Rows - 1) * stride, length = taps + 2 * padding;
        std::vector<double> padded(pixels * length);
        for (std::size_t k = 0; k < pixels; ++k) {
            std::copy_n(weights + k * taps, taps, padded.data() + k * length + padding);
        }
        const double* const weights_along = across == nullptr ? weights : across;
        const std::vector<float> rounded(padded.begin(), padded.end()),
            rounded_along(weights_along, weights_along + pixels * taps);
        parallel_for(count * groups, threads, [&](std::size_t, std::size_t i) {
            thread_local Doubles line;
            thread_local Floats single;
            thread_local std::vector<std::size_t> lines;
            const std::size_t row = i % groups * Rows, rows = std::min(Rows, height - row), first = row / pixels * stride;
            const T* from = samples_of + (i / groups * tall + first) * wide;
            double* averages = to + i / groups * pitch + row * width;
            const double* of[Rows];
            const float* in_single[Rows];
            std::size_t last = 0;
            for (std::size_t r = 0; r < Rows; ++r) {
                const std::size_t behind = (row + r) / pixels * stride - first;
                of[r] = padded.data() + (row + r) % pixels * length + padding - behind;
                in_single[r] = rounded.data() + (of[r] - padded.data());
                last = r < rows ? behind : last;
            }
            look();
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                lines.resize(taps + last);
                for (std::size_t k = 0; k < lines.size(); ++k) {
                    lines[k] = k * wide;
                }
                const auto finish = [&](const auto& lines_of, const auto* of_pixels) LOMMEL_INLINE_LAMBDA {
                    for (std::size_t r = 0; r < rows; ++r) {
                        along(isa, wide, width, lines_of.data() + r * wide, of_pixels, averages + r * width);
                    }
                };
                if constexpr (std::is_same_v<T, float>) {
                    single.resize(Rows * wide);
                    if (dark > 0.0 && (width - 1) / pixels + 1 >= least(isa) &&
                        sums<Rows, 2>(isa, from, lines, in_single, wide, single.data()) <= dark) {
                        return finish(single, rounded_along.data());
                    }
                }
                line.resize(Rows * wide);
                sums<Rows, Rows == 1 ? 4 : 2>(isa, from, lines, of, wide, line.data());
                finish(line, weights_along);
            });
        });
    }

    // Average along x: write `width` pixels to `to` from a line of `wide` samples, with weights of[pixel][tap].
    template <class I, class Sum>
    LOMMEL_INLINE void along(I isa, std::size_t wide, std::size_t width, const Sum* line, const Sum* of, double* to) const {
        // A strand consists of every stride-th sample, stored contiguously: one vector load has samples for adjacent pixels.
        const std::size_t each = (wide + stride - 1) / stride, count = (width - 1) / pixels + 1;
        thread_local Aligned<Sum> strands, sets;
        thread_local std::vector<std::size_t> lines;
        strands.resize(stride * each);
        sets.resize(pixels * count);
        for (std::size_t s = 0; s < stride; ++s) {
            Sum* strand = &strands[s * each];
            for (std::size_t x = s; x < wide; x += stride) {
                *strand++ = line[x];
            }
        }
        lines.resize(taps);
        for (std::size_t k = 0; k < taps; ++k) {
            lines[k] = k % stride * each + k / stride;
        }
        const Sum* const both[2] = {of, of + (pixels - 1) * taps};
        if (pixels == 2) {
            sums<2, 2>(isa, strands.data(), lines, both, count, sets.data());
        } else if (count < 2 * least(isa)) {
            sums<1, 2>(isa, strands.data(), lines, both, count, sets.data());
        } else {
            sums<1, 4>(isa, strands.data(), lines, both, count, sets.data());
        }
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            for (std::size_t x = 0; pixel + x * pixels < width; ++x) {
                to[pixel + x * pixels] = std::max(static_cast<double>(sets[pixel * count + x]), lowest);
            }
        }
    }

    // Compute out[r * count + x] = sum_k of[r][k] * from[lines[k] + x], in the precision of `out`. In single precision, return
    // the largest sample, or 1e300 if `count` is too small for vectors and nothing was computed; in double precision the returned
    // value has no meaning. The speed is limited by the loads of samples or, for four rows, by the multiplications.
    template <std::size_t Rows, std::size_t packs, class I, class T, class Sum>
    LOMMEL_INLINE double sums(I, const T* from, const std::vector<std::size_t>& lines, const Sum* const* of, std::size_t count,
                              Sum* out) const {
        constexpr bool in_single = sizeof(Sum) == 4;
        using V = std::conditional_t<in_single, typename I::floats, typename I::pack>;
        constexpr std::size_t lanes = sizeof(V) / sizeof(Sum), step = packs * lanes;
        if (count < step) {
            for (std::size_t x = 0; x < count && !in_single; ++x) {
                for (std::size_t r = 0; r < Rows; ++r) {
                    Sum sum = 0;
                    for (std::size_t k = 0; k < lines.size(); ++k) {
                        sum += of[r][k] * static_cast<Sum>(from[lines[k] + x]);
                    }
                    out[r * count + x] = sum;
                }
            }
            return 1e300;
        }
        V most = {};
        for (std::size_t x = 0; x < count; x += step) {
            V sum[Rows][packs] = {};
            const std::size_t at = std::min(x, count - step);
            for (std::size_t k = 0; k < lines.size(); ++k) {
                const T* line = from + lines[k] + at;
                V samples[packs];
                for (std::size_t p = 0; p < packs; ++p) {
                    if constexpr (in_single) {
                        samples[p] = load<V>(line + p * lanes);
                        most = larger(most, samples[p]);
                    } else {
                        samples[p] = widened<I>(line + p * lanes);
                    }
                }
                for (std::size_t r = 0; r < Rows; ++r) {
                    const V each = splat<V>(of[r][k]);
                    for (std::size_t p = 0; p < packs; ++p) {
                        sum[r][p] = sum[r][p] + each * samples[p];
                    }
                }
            }
            for (std::size_t r = 0; r < Rows; ++r) {
                for (std::size_t p = 0; p < packs; ++p) {
                    store(out + r * count + at + p * lanes, sum[r][p]);
                }
            }
        }
        double largest = 0.0;
        for (std::size_t i = 0; i < lanes; ++i) {
            largest = std::max(largest, static_cast<double>(most[i]));
        }
        return largest;
    }
};

template <class T>
void PixelFilter::average(const T* from, std::size_t count, std::size_t height, std::size_t width, double* to,
                          std::size_t pitch, int threads) const {
    // Pixel rows that share most of their samples are computed together, so that each sample is loaded once.
    if (2 * (rows_together - 1) * stride < pixels * taps) {
        average<rows_together>(from, count, height, width, to, pitch, threads);
    } else {
        average<1>(from, count, height, width, to, pitch, threads);
    }
}
#if defined(LOMMEL_COMPILED)
extern template void PixelFilter::average<float>(const float*, std::size_t, std::size_t, std::size_t, double*, std::size_t,
                                                 int) const;
extern template void PixelFilter::average<double>(const double*, std::size_t, std::size_t, std::size_t, double*, std::size_t,
                                                  int) const;
#endif

}  // namespace lommel
