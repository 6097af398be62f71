// Polar non-uniform FFT, field on circles: sums over degrees, then FFTs over azimuthal orders (docs/certificate.md, section 11).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/zernike/disk.hpp"
#include "lommel/zernike/polar_table.hpp"

namespace lommel {

// Equally spaced angles around a circle, with the kernel that interpolates between them.
struct PolarCircle : GriddingTaps {
    RowFft<float> single;
    RowFft<double> exact;
    std::vector<double> gains, aliases;  // [order]: 1 / transform of the kernel; bound on (aliases / modulus of the order)

    PolarCircle(std::size_t points, std::size_t taps)
        : GriddingTaps(GriddingKernel::of(taps, taps < 8 ? 3.0 : 2.0)), single(points), exact(points) {
        for (std::size_t m = 0; m < points / 4; ++m) {
            const double omega = 6.283185307179586477 * static_cast<double>(m) / static_cast<double>(points);
            gains.push_back(1.0 / kernel.transform(omega));
            aliases.push_back(kernel.aliases(omega));
        }
    }

    // Smallest number of angles, at least 48, for which an eighth of a turn is longer than half the kernel of `taps` taps.
    static constexpr std::size_t least_points(std::size_t taps) { return std::max<std::size_t>(48, 4 * taps + 8); }
    std::size_t points() const { return single.n; }
    // Bound on the factor by which the gains of the orders m < `orders` magnify rounding in the sums over degrees: by Cauchy, the
    // rms of the gains of the orders m = highest, highest - 2, .. >= 0 of one degree. A gain with m > 1 counts twice, for m and -m.
    // The gain of m = 1, the smallest one, counts only once, which enlarges the bound.
    double growth(std::size_t orders) const {
        const std::size_t highest = std::min(std::max<std::size_t>(orders, 1), gains.size()) - 1, lowest = highest % 2;
        double count = 1.0, squares = gains[lowest] * gains[lowest];
        for (std::size_t m = lowest + 2; m <= highest; m += 2) {
            count += 2.0;
            squares += 2.0 * gains[m] * gains[m];
        }
        return std::sqrt(squares / count);
    }
    const RowFft<float>& fft(float) const { return single; }
    const RowFft<double>& fft(double) const { return exact; }

    bool is(std::size_t points, std::size_t taps) const { return single.n == points && kernel.w == taps; }
    std::size_t bytes() const { return 64 * single.n; }
    static constexpr std::size_t most_bytes = std::size_t{4} << 20;
};

// One disk (aperture or obscuration). parts: Zernike coefficients times the weight of the disk,
// [order][degree][re cos, im cos, re sin, im sin]; table: Hankel transforms [block][degree < degrees][16 radii], of which the
// degrees from reached[block] on are negligible.
struct PolarDisk {
    const ZernikeSeries* series;
    const double* parts;
    const float* singles;  // `parts` in single precision
    const double* table;
    std::size_t degrees;
    const std::size_t* reached;
};

// Store a vector at `to`, converted to the precision of `to`.
template <std::size_t Lanes, class V, class To>
LOMMEL_INLINE void convert(V from, To* to) {
    if constexpr (sizeof(V) == Lanes * sizeof(To)) {
        store(to, from);
    } else {
        for (std::size_t i = 0; i < Lanes; ++i) {
            to[i] = static_cast<To>(from[i]);
        }
    }
}

// Spectra over azimuthal orders of sixteen circles, in two groups of eight; `other` is the workspace of the FFT.
template <class Fft>
struct PolarSpectra {
    Aligned<Fft> spectrum[2], other;

    // Compute A_m and B_m of U = sum over m of A_m cos(m psi) + B_m sin(m psi), by sums over degrees in the precision `Sum`. Write
    // gains[m] c_m and gains[m] c_{-m}, c_{+-m} = (A_m -+ i B_m) / 2 but c_0 = A_0, for FFTs of length n. For each vector of
    // circles, the first of which is `at`, call seen(m, at, size) with size >= |c_m| + |c_{-m}|, without the gain.
    template <class Sum, class I, class Seen>
    LOMMEL_INLINE void combine(I, std::size_t n, const double* gains, const std::vector<PolarDisk>& disks, std::size_t block,
                               std::size_t orders, const Seen& seen) {
        using V = typename RowPack<I, Sum>::type;
        constexpr std::size_t lanes = sizeof(V) / sizeof(Sum), together = 2;  // together: vectors whose sums fit in registers
        for (auto& numbers : spectrum) {
            numbers.resize(n * fft_element);
            const auto clear = [&](std::size_t from, std::size_t to) {
                std::fill_n(numbers.data() + from * fft_element, (to - from) * fft_element, Fft(0));
            };
            clear(std::min(orders, n / 4), n / 4);
            clear(3 * n / 4, std::max(3 * n / 4, n - orders + 1));
        }
        other.resize(n * fft_element);
        if constexpr (sizeof(Sum) == 4) {
            rounded_.resize(disks.size());
            for (std::size_t d = 0; d < disks.size(); ++d) {
                const double* from = disks[d].table + block * disks[d].degrees * PolarTable::block;
                rounded_[d].resize(disks[d].reached[block] * PolarTable::block);
                std::copy_n(from, rounded_[d].size(), rounded_[d].data());
            }
        }
        for (std::size_t m = 0; m < orders; ++m) {
            for (std::size_t at = 0; at < PolarTable::block; at += together * lanes) {
                V parts[4][together];
                for (auto& part : parts) {
                    for (V& sum : part) {
                        sum = splat<V>(Sum(0));
                    }
                }
                for (std::size_t d = 0; d < disks.size(); ++d) {
                    const PolarDisk& disk = disks[d];
                    if (m >= disk.series->orders || m >= disk.reached[block]) {
                        continue;
                    }
                    const std::size_t count = std::min(disk.series->used[m], (disk.reached[block] - m + 1) / 2);
                    const Sum *from, *beta;
                    if constexpr (sizeof(Sum) == 4) {
                        from = rounded_[d].data() + m * PolarTable::block + at;
                        beta = disk.singles + 4 * disk.series->start[m];
                    } else {
                        from = disk.table + (block * disk.degrees + m) * PolarTable::block + at;
                        beta = disk.parts + 4 * disk.series->start[m];
                    }
                    for (std::size_t i = 0; i < count; ++i, from += 2 * PolarTable::block, beta += 4) {
                        V f[together];
                        for (std::size_t p = 0; p < together; ++p) {
                            f[p] = load<V>(from + p * lanes);
                        }
                        for (std::size_t c = 0; c < 4; ++c) {
                            const V b = splat<V>(beta[c]);
                            for (std::size_t p = 0; p < together; ++p) {
                                parts[c][p] = parts[c][p] + b * f[p];
                            }
                        }
                    }
                }
                const V gain = splat<V>(static_cast<Sum>(m == 0 ? gains[m] : 0.5 * gains[m]));
                for (std::size_t p = 0; p < together; ++p) {
                    const V ar = parts[0][p], ai = parts[1][p], br = parts[2][p], bi = parts[3][p];
                    seen(m, at + p * lanes, (magnitude(ar) + magnitude(ai)) + (magnitude(br) + magnitude(bi)));
                    put<lanes>(m, at + p * lanes, gain * (ar + bi), gain * (ai - br));
                    if (m > 0) {
                        put<lanes>(n - m, at + p * lanes, gain * (ar - bi), gain * (ai + br));
                    }
                }
            }
        }
    }

   private:
    template <class V>
    static LOMMEL_INLINE V magnitude(V x) {
        return larger(x, V{} - x);
    }

    template <std::size_t lanes, class V>
    LOMMEL_INLINE void put(std::size_t at, std::size_t row, V re, V im) {
        Fft* to = &spectrum[row / fft_rows][at * fft_element + row % fft_rows];
        convert<lanes>(re, to);
        convert<lanes>(im, to + fft_rows);
    }

    std::vector<Aligned<float>> rounded_;  // [disk]: table of one block in single precision
};

// Quad: four numbers stored as a block; turn(): 4 x 4 transpose, out[i].at[k] = from[k][first + i].
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
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
LOMMEL_INLINE void turn(const float (*from)[fft_rows], std::size_t first, Quad<float>* out) {
    typedef float Pack __attribute__((vector_size(16)));
    Pack turned[4];
    turned_fours(load<Pack>(from[0] + first), load<Pack>(from[1] + first), load<Pack>(from[2] + first),
                 load<Pack>(from[3] + first), turned);
    for (std::size_t i = 0; i < 4; ++i) {
        store(out[i].at, turned[i]);
    }
}
#endif

// Error contributions of one circle to U, and moduli of its values.
struct PolarRowError {
    double sums = 0.0;  // rounding of the sums over degrees
    double around = 0.0;  // aliases of the orders, from interpolation around the circle
    double sum = 0.0;  // sum, over all orders, of the moduli of the input of the FFT
    double largest = 0.0;  // largest |re U| or |im U| on the circle
};

// Field on circles, [circle][angle][re, im][direction]. Angles psi run from -w/2 steps to an eighth of a turn plus w/2 steps, w the
// number of taps of the kernel. Each angle has eight mirrored directions: psi + k pi/2, k = 0..3, then (k+1) pi/2 - psi.
template <class Real>
class PolarRows {
   public:
    static constexpr std::size_t directions = 16;  // numbers per angle: re and im of eight directions

    void resize(const PolarCircle& circle, std::size_t count) {
        margin_ = circle.kernel.w / 2;
        angles_ = circle.points() / 8 + 2 * margin_ + 1;
        values_.resize(count * angles_ * directions);
    }

    std::size_t stride() const { return angles_ * directions; }
    // margin(): number of steps from the start of row(i), the values of circle i, to the angle 0.
    std::size_t margin() const { return margin_; }
    const Real* row(std::size_t i) const { return &values_[i * stride()]; }

    // Compute circles 16 block .. 16 block + 15 of the tables into rows from `first` on, with the orders below `orders` (at most a
    // quarter of the number of angles). errors: error contributions of each circle.
    template <class Sum, class I, class Fft>
    LOMMEL_INLINE void fill(I isa, const PolarCircle& circle, const std::vector<PolarDisk>& disks, std::size_t block,
                            std::size_t orders, std::size_t first, PolarSpectra<Fft>& spectra, PolarRowError* errors) {
        // Factor that covers the rounding of the sums of moduli over the orders.
        const double more = 1.0 + 2.0 * roundoff<Sum> * static_cast<double>(orders + 8);
        alignas(64) Sum around[PolarTable::block] = {}, sum[PolarTable::block] = {};
        spectra.template combine<Sum>(isa, circle.points(), circle.gains.data(), disks, block, orders,
                                      [&](std::size_t m, std::size_t at, auto size) LOMMEL_INLINE_LAMBDA {
                                          using V = decltype(size);
                                          const V alias = splat<V>(static_cast<Sum>(circle.aliases[m])),
                                                  gain = splat<V>(static_cast<Sum>(circle.gains[m]));
                                          store(around + at, load<V>(around + at) + alias * size);
                                          store(sum + at, load<V>(sum + at) + gain * size);
                                      });
        for (std::size_t i = 0; i < PolarTable::block; ++i) {
            errors[i].around = more * static_cast<double>(around[i]);
            errors[i].sum = more * static_cast<double>(sum[i]);
        }
        for (std::size_t half = 0; half < PolarTable::block; half += fft_rows) {
            const RowFft<Fft>& fft = circle.fft(Fft());
            const Fft* from = fft.run(isa, spectra.spectrum[half / fft_rows].data(), spectra.other.data());
            scatter(isa, fft, from, &values_[(first + half) * stride()], errors + half);
        }
    }

   private:
    // Last pass of the FFT: store the values in the layout [angle][re, im][direction], and set errors[circle].largest.
    template <class I, class Fft>
    LOMMEL_INLINE void scatter(I, const RowFft<Fft>& fft, const Fft* from, Real* to, PolarRowError* errors) const {
        using V = typename RowPack<I, Fft>::type;
        constexpr std::size_t lanes = sizeof(V) / sizeof(Fft);
        const std::size_t quarter = fft.n / 4, eighth = fft.n / 8;
        V largest[fft_rows / lanes];
        for (V& most : largest) {
            most = splat<V>(Fft(0));
        }
        // The last pass gives U at psi_q + k pi/2, psi_q = 2 pi q / n. `low`: store it at angle q, as directions psi_q + k pi/2.
        // `high`: store it at angle n/4 - q, as the directions (k+1) pi/2 - psi of this angle psi = pi/2 - psi_q.
        const auto place = [&](std::size_t q, bool low, bool high) LOMMEL_INLINE_LAMBDA {
            alignas(64) Real turned[8][fft_rows];
            for (std::size_t part = 0; part < fft_rows; part += lanes) {
                ComplexPack<V> x[4];
                fft.last(from + q * fft_element + part, x);
                V& most = largest[part / lanes];
                for (std::size_t k = 0; k < 4; ++k) {
                    convert<lanes>(x[k].re, turned[k] + part);
                    convert<lanes>(x[k].im, turned[4 + k] + part);
                    most = larger(most, larger(x[k].re, splat<V>(Fft(0)) - x[k].re));
                    most = larger(most, larger(x[k].im, splat<V>(Fft(0)) - x[k].im));
                }
            }
            Real *lower = to + (margin_ + q) * directions, *upper = to + (margin_ + quarter - q) * directions + 4;
            for (std::size_t row = 0; row < fft_rows; row += 4) {
                Quad<Real> re[4], im[4];
                turn(turned, row, re);
                turn(turned + 4, row, im);
                for (std::size_t i = 0; i < 4; ++i, lower += stride(), upper += stride()) {
                    if (low) {
                        store(lower, re[i]);
                        store(lower + 8, im[i]);
                    }
                    if (high) {
                        store(upper, re[i]);
                        store(upper + 8, im[i]);
                    }
                }
            }
        };
        for (std::size_t q = 0; q < eighth - margin_; ++q) {
            place(q, true, false);
        }
        for (std::size_t q = eighth - margin_; q <= eighth + margin_; ++q) {
            place(q, true, true);
        }
        for (std::size_t q = eighth + margin_ + 1; q < quarter; ++q) {
            place(q, false, true);
        }
        // At the angles psi_{-i} before 0 the directions are permuted: psi_{-i} + k pi/2 = k pi/2 - psi_i.
        for (std::size_t row = 0; row < fft_rows; ++row) {
            Real* start = to + row * stride() + margin_ * directions;
            for (std::size_t i = 0; i <= margin_; ++i) {
                Real *out = start - i * directions, *in = start + i * directions;
                for (std::size_t k = 0; k < 4; ++k) {
                    for (std::size_t part = 0; part < directions; part += 8) {
                        out[part + 4 + k] = in[part + (k + 1) % 4];
                        if (i > 0) {
                            out[part + k] = in[part + 4 + (k + 3) % 4];
                        }
                    }
                }
            }
        }
        for (std::size_t i = 0; i < fft_rows; ++i) {
            errors[i].largest = static_cast<double>(largest[i / lanes][i % lanes]);
        }
    }

    std::size_t margin_ = 0, angles_ = 0;
    Aligned<Real> values_;
};

}  // namespace lommel
