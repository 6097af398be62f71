// Sums over waves a exp(-i k s) at integers k, by a non-uniform fast Fourier transform.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/special/gridding.hpp"

namespace lommel {

// Gridding kernel and FFT for sums over waves a exp(-i k s) at `side` integers k; gain[|k|]: 1 / (transform of the kernel).
struct WaveKernel {
    static constexpr std::size_t most_taps = 16;

    WaveKernel(std::size_t length, std::size_t kernel_taps = 12)
        : side(length), taps(kernel_taps), terms(taps < 10   ? 9
                                                 : taps < 14 ? 11
                                                             : 14),
          fft(RowFft<double>::length(std::max<std::size_t>(2 * side, 64))), kernel(GriddingKernel::of(taps, 2.0)),
          gain(side / 2 + 1) {
        std::vector<double> made;
        off_ = kernel.polynomials(terms, most_taps, made);
        polynomials.assign(made.begin(), made.end());
        for (std::size_t i = 0; i < polynomials.size(); ++i) {
            const double k = static_cast<double>(terms - 1 - i / most_taps);
            off_ += (3.0 * k + 3.0) * std::abs(polynomials[i]) * unit_roundoff;  // rounding, as in TapPolynomials
        }
        for (std::size_t k = 0; k < gain.size(); ++k) {
            gain[k] = 1.0 / kernel.transform(omega(k));
        }
    }

    // Error bound of any sum, relative to the sum of the moduli of the amplitudes, if at most `waves` waves contribute to a
    // grid point: aliases (Poisson's formula), kernel taps, rounding of the sums and of the FFT, and one rounding of each
    // wave's position (in turns). Rounding of the phase steps s themselves is not included.
    double error(double waves) const {
        const double weight = kernel.weight(), rounded = fft.rounding() + waves + 4.0;
        const double places = 1.1 * 6.3 * static_cast<double>(side / 2 + 1);
        return kernel.aliases(omega(side / 2)) + gain.back() * (off_ + unit_roundoff * rounded * weight) +
               unit_roundoff * places;
    }

    // Largest number of waves that contribute to one grid point, for waves of phase steps at(i) (rad), i < count.
    template <class At>
    std::size_t most_waves(std::size_t count, std::vector<std::uint32_t>& reached, const At& at) const {
        reached.assign(fft.n, 0);
        for (std::size_t i = 0; i < count; ++i) {
            ++reached[static_cast<std::size_t>(place(at(i)))];
        }
        std::size_t sum = 0, most = 0;
        for (std::size_t i = 0; i < fft.n + taps; ++i) {
            // Count one more grid point on either side, as rounding may move a wave to the next point.
            sum += reached[i % fft.n];
            sum -= i >= taps + 2 ? reached[(i - taps - 2) % fft.n] : 0;
            most = std::max(most, sum);
        }
        return most;
    }
    // Grid position of a wave of phase step s (rad): the fractional part of -s / (2 pi), times the FFT length.
    double place(double s) const {
        const double n = static_cast<double>(fft.n), turns = -s / 6.283185307179586;
        return std::min((turns - std::floor(turns)) * n, n - 1e-9);
    }

    std::size_t side, taps, terms;
    RowFft<double> fft;
    GriddingKernel kernel;
    Doubles polynomials;  // [power, highest first][tap], `most_taps` taps
    std::vector<double> gain;

   private:
    double off_;
    double omega(std::size_t k) const { return 6.283185307179586 * static_cast<double>(k) / static_cast<double>(fft.n); }
};

// Eight sums over waves a exp(-i k s) of amplitudes a and phase steps s (rad), at the `side` integers k from -side / 2 on.
class WaveSums {
   public:
    explicit WaveSums(const WaveKernel& kernel)
        : kernel_(kernel), grid_((kernel.fft.n + WaveKernel::most_taps) * element), other_(kernel.fft.n * element) {}

    void start() { std::fill(grid_.begin(), grid_.end(), 0.0); }

    // Add a wave of amplitude re + i im and phase step s to sum `r` of the eight.
    template <class I>
    LOMMEL_INLINE void add(I isa, std::size_t r, double re, double im, double s) {
        double weights[WaveKernel::most_taps];
        double* to = taps_at(isa, s, weights) + r;
        for (std::size_t i = 0; i < kernel_.taps; ++i, to += element) {
            to[0] += weights[i] * re;
            to[wide] += weights[i] * im;
        }
    }
    // Add a wave of phase step s to all eight sums; `amplitudes`: eight real parts, then eight imaginary parts.
    template <class I, class T>
    LOMMEL_INLINE void add(I isa, const T* amplitudes, double s) {
        double weights[WaveKernel::most_taps];
        double* to = taps_at(isa, s, weights);
        for (std::size_t i = 0; i < kernel_.taps; ++i, to += element) {
            for (std::size_t j = 0; j < element; ++j) {
                to[j] += weights[i] * static_cast<double>(amplitudes[j]);
            }
        }
    }

    // Call at(j, sums, gain) for each integer k, j = k + side / 2; sums: eight real, eight imaginary parts, not yet times gain.
    template <class I, class F>
    LOMMEL_INLINE void finish(I isa, const F& at) {
        const std::size_t n = kernel_.fft.n, half = kernel_.side / 2;
        for (std::size_t i = 0; i < kernel_.taps * element; ++i) {
            grid_[i] += grid_[n * element + i];
        }
        const double* const sums = kernel_.fft.whole(isa, grid_.data(), other_.data());
        for (std::size_t j = 0; j < kernel_.side; ++j) {
            at(j, sums + (j < half ? n + j - half : j - half) * element, kernel_.gain[j < half ? half - j : j - half]);
        }
    }

   private:
    static constexpr std::size_t wide = fft_rows, element = fft_element;

    // Return the first grid element to which a wave of phase step s is added; write the kernel's weight at each such element.
    template <class I>
    LOMMEL_INLINE double* taps_at(I, double s, double* weights) {
        using V = typename I::pack;
        const double n = static_cast<double>(kernel_.fft.n), turns = -s / 6.283185307179586;
        const double place = (turns - std::floor(turns)) * n, whole = std::floor(place);
        const V x = splat<V>(2.0 * (place - whole) - 1.0);
        for (std::size_t i = 0; i < kernel_.taps; i += I::lanes) {
            store(weights + i, horner(kernel_.terms, x, [&](std::size_t p) LOMMEL_INLINE_LAMBDA {
                      return &kernel_.polynomials[p * WaveKernel::most_taps + i];
                  }));
        }
        const std::size_t first = static_cast<std::size_t>(whole) + kernel_.fft.n - kernel_.taps / 2 + 1;
        return &grid_[first % kernel_.fft.n * element];
    }

    const WaveKernel& kernel_;
    Doubles grid_, other_;
};

}  // namespace lommel
