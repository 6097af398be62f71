// Sums of waves at whole numbers, by a non-uniform fast Fourier transform.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/special/gridding.hpp"

namespace live {

// Eight sums of a exp(-i k s) over waves of any amplitudes a and steps s (radians), at the whole numbers k from -side / 2 on. Each
// wave is put on a grid by the taps of a kernel, by whose transform the sums are divided; errors are some 1e-12 of sum |a|.
class WaveSums {
   public:
    explicit WaveSums(std::size_t side)
        : fft_(lommel::RowFft<double>::length(std::max<std::size_t>(2 * side, 64))), half_(side / 2),
          kernel_(lommel::GriddingKernel::of(taps, 2.0)), polynomials_(kernel_), gain_(half_ + 1),
          grid_((fft_.n + taps) * element), other_(fft_.n * element) {
        for (std::size_t k = 0; k <= half_; ++k) {
            gain_[k] = 1.0 / kernel_.transform(two_pi * static_cast<double>(k) / static_cast<double>(fft_.n));
        }
    }

    void start() { std::fill(grid_.begin(), grid_.end(), 0.0); }

    // A wave of sum `r`.
    template <class I>
    LOMMEL_INLINE void add(I isa, std::size_t r, double re, double im, double s) {
        double weights[most];
        double* to = taps_at(isa, s, weights) + r;
        for (std::size_t i = 0; i < taps; ++i, to += element) {
            to[0] += weights[i] * re;
            to[wide] += weights[i] * im;
        }
    }
    // Of all eight, one wave of the same step: amplitudes as eight real parts, eight imaginary ones.
    template <class I, class T>
    LOMMEL_INLINE void add(I isa, const T* amplitudes, double s) {
        double weights[most];
        double* to = taps_at(isa, s, weights);
        for (std::size_t i = 0; i < taps; ++i, to += element) {
            for (std::size_t j = 0; j < element; ++j) {
                to[j] += weights[i] * static_cast<double>(amplitudes[j]);
            }
        }
    }

    // Call at(j, sum) for j = k + side / 2: eight real parts, eight imaginary ones, which are to be multiplied by `gain`.
    template <class I, class F>
    LOMMEL_INLINE void finish(I isa, std::size_t side, const F& at) {
        for (std::size_t i = 0; i < taps * element; ++i) {
            grid_[i] += grid_[fft_.n * element + i];
        }
        const double* const sums = fft_.whole(isa, grid_.data(), other_.data());
        for (std::size_t j = 0; j < side; ++j) {
            at(j, sums + (j < half_ ? fft_.n + j - half_ : j - half_) * element, gain_[j < half_ ? half_ - j : j - half_]);
        }
    }

   private:
    static constexpr double two_pi = 6.283185307179586;
    static constexpr std::size_t taps = 12, most = lommel::DoubleTaps::taps, wide = lommel::fft_rows,
                                 element = lommel::fft_element;

    // The first element of the grid that a wave is put on, and how much of it on each.
    template <class I>
    LOMMEL_INLINE double* taps_at(I, double s, double* weights) {
        using V = typename I::pack;
        const double n = static_cast<double>(fft_.n), turns = -s / two_pi, place = (turns - std::floor(turns)) * n;
        const double whole = std::floor(place);
        const V x = lommel::splat<V>(2.0 * (place - whole) - 1.0);
        for (std::size_t i = 0; i < taps; i += I::lanes) {
            V sum = lommel::load<V>(polynomials_.at[0] + i);
            for (std::size_t p = 1; p < lommel::DoubleTaps::terms; ++p) {
                sum = sum * x + lommel::load<V>(polynomials_.at[p] + i);
            }
            lommel::store(weights + i, sum);
        }
        const std::size_t first = static_cast<std::size_t>(whole) + fft_.n - taps / 2 + 1;
        return &grid_[first % fft_.n * element];
    }

    lommel::RowFft<double> fft_;
    std::size_t half_;
    lommel::GriddingKernel kernel_;
    lommel::DoubleTaps polynomials_;
    std::vector<double> gain_;
    lommel::Doubles grid_, other_;
};

}  // namespace live
