// The field of any pupil on circles, ready for interpolation: sums over degrees, and Fourier transforms over azimuthal orders.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/zernike/disk.hpp"
#include "lommel/zernike/polar_table.hpp"

#ifndef POLAR_TIMER
#define POLAR_TIMER(name)
#endif
namespace lommel {

// Equal angles around a circle, and the kernel that interpolates between them.
template <class Real>
struct PolarCircle {
    RowFft<Real> fft;
    GriddingKernel kernel;
    std::vector<double> gains, aliases;  // of each order: 1 / transform, and the bound on the aliases
    double weight;                       // the largest sum of taps
    Taps<Real> taps;

    PolarCircle(std::size_t points, std::size_t w)
        : fft(points), kernel(GriddingKernel::of(w, w < 8 ? 3.0 : 2.0)),
          weight(kernel.transform(0.0) * (1.0 + kernel.aliases(0.0))), taps(kernel) {
        for (std::size_t m = 0; m < points / 4; ++m) {
            const double omega = 6.283185307179586477 * static_cast<double>(m) / static_cast<double>(points);
            gains.push_back(1.0 / kernel.transform(omega));
            aliases.push_back(kernel.aliases(omega));
        }
    }

    bool is(std::size_t points, std::size_t w) const { return fft.n == points && kernel.w == w; }
    std::size_t bytes() const { return 64 * fft.n; }
    static constexpr std::size_t most_bytes = std::size_t{4} << 20;
};

// Of one disk: coefficients of its series, for each order [n][re cos, im cos, re sin, im sin], with what it is multiplied by.
struct PolarDisk {
    std::shared_ptr<const PolarTable> table;
    const ZernikeSeries* series;
    const double* parts;
    double weight;
};

// Four numbers, and four columns of four as rows.
template <class Real>
struct Quad {
    Real at[4];
};
template <class Real>
LOMMEL_INLINE void turn(const Real (*from)[fft_rows], std::size_t first, Quad<Real>* out) {
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            out[i].at[k] = from[k][first + i];
        }
    }
}
#if defined(__GNUC__) && !defined(__clang__)
LOMMEL_INLINE void turn(const float (*from)[fft_rows], std::size_t first, Quad<float>* out) {
    typedef float quad __attribute__((vector_size(16)));
    typedef std::int32_t places __attribute__((vector_size(16)));
    const quad a = load<quad>(from[0] + first), b = load<quad>(from[1] + first), c = load<quad>(from[2] + first), d = load<quad>(from[3] + first);
    const places low = {0, 4, 1, 5}, high = {2, 6, 3, 7}, first_half = {0, 1, 4, 5}, second_half = {2, 3, 6, 7};
    const quad ab = __builtin_shuffle(a, b, low), cd = __builtin_shuffle(c, d, low), ab2 = __builtin_shuffle(a, b, high),
               cd2 = __builtin_shuffle(c, d, high);
    const quad rows[4] = {__builtin_shuffle(ab, cd, first_half), __builtin_shuffle(ab, cd, second_half),
                          __builtin_shuffle(ab2, cd2, first_half), __builtin_shuffle(ab2, cd2, second_half)};
    for (std::size_t i = 0; i < 4; ++i) {
        store(out[i].at, rows[i]);
    }
}
#endif

// What a block of circles is off by: of U interpolated around the circles, and how large its numbers are.
struct PolarRowError {
    double around = 0.0;     // aliases of the orders
    double sum = 0.0;        // sum over orders of the magnitudes that are transformed
    double largest = 0.0;    // number among the rows
};

// Numbers [circle][angle][eight directions], the angles from -w/2 steps to one eighth of a turn and w/2 steps more. Directions are
// those that differ in signs and order of |x|, |y|: psi + k pi/2 (re for k = 0..3, im), then (k+1) pi/2 - psi likewise.
template <class Real>
class PolarRows {
   public:
    static constexpr std::size_t directions = 16;  // numbers

    template <class Circle>
    void resize(const Circle& circle, std::size_t count) {
        margin_ = circle.kernel.w / 2;
        angles_ = circle.fft.n / 8 + 2 * margin_ + 1;
        values_.resize(count * angles_ * directions);
    }

    std::size_t stride() const { return angles_ * directions; }
    // Of a circle, at the angle of so many steps, -margin() the least.
    std::size_t margin() const { return margin_; }
    const Real* row(std::size_t i) const { return &values_[i * stride()]; }

    template <class T>
    using Aligned = std::vector<T, AlignedAllocator<T>>;

    template <class Fft>
    struct Scratch {
        Aligned<Fft> spectrum[2], other;
    };

    // Circles [16 block, 16 block + 16) of the tables' to rows from `first` on; orders below `orders`.
    template <class I, class Fft>
    LOMMEL_INLINE PolarRowError fill(I isa, const PolarCircle<Fft>& circle, const PolarDisk* disks, std::size_t disk_count,
                                     std::size_t block, std::size_t orders, std::size_t first, Scratch<Fft>& scratch) {
        using V = typename I::pack;
        constexpr std::size_t packs = PolarTable::block / I::lanes;
        const std::size_t n = circle.fft.n;
        orders = std::min(orders, n / 4);
        for (auto& spectrum : scratch.spectrum) {
            spectrum.resize(n * fft_element);
            std::fill(spectrum.begin() + static_cast<std::ptrdiff_t>(orders * fft_element),
                      spectrum.begin() + static_cast<std::ptrdiff_t>(n / 4 * fft_element), Fft(0));
            std::fill(spectrum.begin() + static_cast<std::ptrdiff_t>(3 * n / 4 * fft_element),
                      spectrum.begin() + static_cast<std::ptrdiff_t>((n - orders + 1) * fft_element), Fft(0));
        }
        scratch.other.resize(n * fft_element);
        V around[packs], sum[packs];
        for (std::size_t p = 0; p < packs; ++p) {
            around[p] = sum[p] = splat<V>(0.0);
        }
        {POLAR_TIMER(combine);
        for (std::size_t m = 0; m < orders; ++m) {
            V parts[4][packs];
            for (std::size_t c = 0; c < 4; ++c) {
                for (std::size_t p = 0; p < packs; ++p) {
                    parts[c][p] = splat<V>(0.0);
                }
            }
            for (std::size_t d = 0; d < disk_count; ++d) {
                const PolarDisk& disk = disks[d];
                const std::size_t end = std::min(disk.table->reached[block], disk.table->degrees);
                if (m >= disk.series->orders || m >= end) {
                    continue;
                }
                const std::size_t count = std::min(disk.series->used[m], (end - m + 1) / 2);
                const double* from = disk.table->at(block) + m * PolarTable::block;
                const double* beta = disk.parts + 4 * disk.series->start[m];
                for (std::size_t i = 0; i < count; ++i, from += 2 * PolarTable::block, beta += 4) {
                    V f[packs];
                    for (std::size_t p = 0; p < packs; ++p) {
                        f[p] = load<V>(from + p * I::lanes);
                    }
                    for (std::size_t c = 0; c < 4; ++c) {
                        const V b = splat<V>(beta[c]);
                        for (std::size_t p = 0; p < packs; ++p) {
                            parts[c][p] = parts[c][p] + b * f[p];
                        }
                    }
                }
            }
            const V gain = splat<V>(m == 0 ? circle.gains[m] : 0.5 * circle.gains[m]), alias = splat<V>(circle.aliases[m]);
            const V whole = splat<V>(circle.gains[m]);
            for (std::size_t p = 0; p < packs; ++p) {
                const V ar = parts[0][p], ai = parts[1][p], br = parts[2][p], bi = parts[3][p];
                const V size = (magnitude(ar) + magnitude(ai)) + (magnitude(br) + magnitude(bi));
                around[p] = around[p] + alias * size;
                sum[p] = sum[p] + whole * size;
                put<V>(scratch, m, p * I::lanes, gain * (ar + bi), gain * (ai - br));
                if (m > 0) {
                    put<V>(scratch, n - m, p * I::lanes, gain * (ar - bi), gain * (ai + br));
                }
            }
        }
        }
        PolarRowError error;
        for (std::size_t p = 0; p < packs; ++p) {
            for (std::size_t i = 0; i < I::lanes; ++i) {
                error.around = std::max(error.around, around[p][i]);
                error.sum = std::max(error.sum, sum[p][i]);
            }
        }
        for (std::size_t half = 0; half < 2; ++half) {
            Fft* from; {POLAR_TIMER(fft);
            from = circle.fft.run(isa, scratch.spectrum[half].data(), scratch.other.data());} POLAR_TIMER(scatter);
            error.largest = std::max(error.largest, scatter(isa, from, n, &values_[(first + half * fft_rows) * stride()]));
        }
        return error;
    }

   private:
    template <class V>
    static LOMMEL_INLINE V magnitude(V x) {
        return larger(x, splat<V>(0.0) - x);
    }

    template <class V, class Fft>
    static LOMMEL_INLINE void put(Scratch<Fft>& scratch, std::size_t at, std::size_t row, V re, V im) {
        constexpr std::size_t lanes = sizeof(V) / sizeof(double);
        Fft* to = &scratch.spectrum[row / fft_rows][at * fft_element + row % fft_rows];
        convert<lanes>(re, to);
        convert<lanes>(im, to + fft_rows);
    }

    // Stores numbers of one precision as those of another.
    template <std::size_t Lanes, class V, class To>
    static LOMMEL_INLINE void convert(V from, To* to) {
        if constexpr (sizeof(V) == Lanes * sizeof(To)) {
            store(to, from);
        } else {
            for (std::size_t i = 0; i < Lanes; ++i) {
                to[i] = static_cast<To>(from[i]);
            }
        }
    }

    // The last pass of the transform, and its numbers to where the directions want them.
    template <class I, class Fft>
    LOMMEL_INLINE double scatter(I, const Fft* from, std::size_t n, Real* to) const {
        using V = typename RowPack<I, Fft>::type;
        constexpr std::size_t lanes = sizeof(V) / sizeof(Fft);
        const std::size_t quarter = n / 4, eighth = n / 8, far = eighth + margin_;
        alignas(64) Real turned[8][fft_rows];
        V largest = splat<V>(Fft(0));
        for (std::size_t q = 0; q < quarter; ++q) {
            for (std::size_t part = 0; part < fft_rows; part += lanes) {
                const auto at = [&](std::size_t k) LOMMEL_INLINE_LAMBDA {
                    const Fft* here = from + (q + quarter * k) * fft_element + part;
                    return ComplexPack<V>{load<V>(here), load<V>(here + fft_rows)};
                };
                const auto a = at(0), b = at(1), d = at(2), e = at(3);
                const auto even = a + d, odd = b + e, other = a - d, third = (b - e).times_i();
                const ComplexPack<V> x[4] = {even + odd, other + third, even - odd, other - third};
                for (std::size_t k = 0; k < 4; ++k) {
                    convert<lanes>(x[k].re, turned[k] + part);
                    convert<lanes>(x[k].im, turned[4 + k] + part);
                    largest = larger(largest, larger(x[k].re, splat<V>(Fft(0)) - x[k].re));
                    largest = larger(largest, larger(x[k].im, splat<V>(Fft(0)) - x[k].im));
                }
            }
            // X at psi_q + k pi/2 is that at psi_{q - quarter} + (k+1) pi/2, and that at (k+1) pi/2 - psi_{quarter - q}.
            const std::ptrdiff_t l = static_cast<std::ptrdiff_t>(q), whole = static_cast<std::ptrdiff_t>(quarter);
            for (std::size_t row = 0; row < fft_rows; row += 4) {
                Quad<Real> re[4], im[4];
                turn(turned, row, re);
                turn(turned + 4, row, im);
                for (std::size_t i = 0; i < 4; ++i) {
                    Real* start = to + (row + i) * stride() + margin_ * directions;
                    const auto place = [&](std::ptrdiff_t angle, std::size_t half) LOMMEL_INLINE_LAMBDA {
                        Real* out = start + angle * static_cast<std::ptrdiff_t>(directions) + 8 * half;
                        store(out, re[i]);
                        store(out + 4, im[i]);
                        return out;
                    };
                    if (q <= far) {
                        place(l, 0);
                    }
                    if (quarter - q <= far) {
                        place(whole - l, 1);
                    }
                    if (q + margin_ >= quarter) {
                        Real* out = place(l - whole, 0);
                        std::rotate(out, out + 3, out + 4);
                        std::rotate(out + 4, out + 7, out + 8);
                    }
                    if (q <= margin_) {
                        Real* out = place(-l, 1);
                        std::rotate(out, out + 1, out + 4);
                        std::rotate(out + 4, out + 5, out + 8);
                    }
                }
            }
        }
        double top = 0.0;
        alignas(64) Fft all[lanes];
        store(all, largest);
        for (const Fft x : all) {
            top = std::max(top, static_cast<double>(x));
        }
        return top;
    }

    std::size_t margin_ = 0, angles_ = 0;
    Aligned<Real> values_;
};

}  // namespace lommel
