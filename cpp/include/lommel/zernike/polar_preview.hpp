// Polar non-uniform FFT, preview: coarse samples of the field, for its brightness and for the moduli of its azimuthal orders.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/zernike/error_check.hpp"
#include "lommel/zernike/polar_pupil.hpp"

namespace lommel {

// Preview of an image: largest intensity at some radii, and moduli of the azimuthal orders at these radii.
class PolarLooks : public Looks {
   public:
    static constexpr std::size_t block = LookTable::block;
    std::size_t orders;

    PolarLooks(const PolarPupil& pupil, double reach, int threads)
        : orders(pupil.orders()), blocks_(LookTable::blocks_to(reach)), sizes_(blocks_ * orders * block) {
        std::vector<std::shared_ptr<const LookTable>> tables;
        std::vector<PolarDisk> disks;
        for (const PolarPupil::Disk& disk : pupil.disks) {
            tables.push_back(cache<LookTable>.get(disk.shrunk, blocks_, disk.series->degrees));
            const LookTable& table = *tables.back();
            disks.push_back({disk.series, disk.parts.data(), disk.singles.data(), table.values.data(), table.degrees,
                             table.reached.data()});
        }
        const RowFft<float> fft(RowFft<float>::length(4 * orders));
        const std::vector<double> gains(orders, 1.0);
        bright.assign(blocks_ * block, 0.0);
        parallel_for(blocks_, threads, [&](std::size_t, std::size_t b) {
            thread_local PolarSpectra<float> spectra;
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                spectra.combine<float>(isa, fft.n, gains.data(), disks, b, orders,
                                       [&](std::size_t m, std::size_t at, auto size)
                                           LOMMEL_INLINE_LAMBDA { store(&sizes_[(b * orders + m) * block + at], size); });
                for (std::size_t half = 0; half < 2; ++half) {
                    last_pass(isa, fft, fft.run(isa, spectra.spectrum[half].data(), spectra.other.data()),
                              &bright[b * block + half * fft_rows]);
                }
            });
        });
        for (std::size_t i = 0; i < bright.size(); ++i) {
            v.push_back(LookTable::at(i));
        }
        // Keep only one radius beyond `reach`: the others just fill up the last block.
        while (v.size() > 2 && v[v.size() - 2] > reach) {
            v.pop_back();
        }
        bright.resize(v.size());
    }

    // out[i]: estimated contributions to the error of U on circle i of block b.
    void rows(std::size_t b, const PolarKernels& kernels, const PolarCircle& circle, PolarRowError* out) const {
        for (std::size_t i = 0; i < block; ++i) {
            out[i] = PolarRowError();
        }
        for (std::size_t m = 0; m < std::min(orders, circle.gains.size()); ++m) {
            const float* sizes = &sizes_[(b * orders + m) * block];
            for (std::size_t i = 0; i < block; ++i) {
                const double size = static_cast<double>(sizes[i]);
                out[i].around += size * circle.aliases[m];
                out[i].sum += size * circle.gains[m];
            }
        }
        for (std::size_t i = 0; i < block; ++i) {
            // Values on circles are divided by the transform of the kernel: their errors grow by a factor of at most `largest`.
            const double i_here = b * block + i < bright.size() ? bright[b * block + i] : 0.0;
            const double largest = kernels.outer().largest;
            out[i] = {0.0, largest * out[i].around, largest * out[i].sum, 1.2 * largest * circle.gains[0] * std::sqrt(i_here)};
        }
    }

   private:
    // Last pass of an FFT over angles: out[circle] = largest |U|^2 on each of eight circles.
    template <class I>
    static LOMMEL_INLINE void last_pass(I, const RowFft<float>& fft, const float* from, double* out) {
        using V = typename RowPack<I, float>::type;
        constexpr std::size_t lanes = sizeof(V) / sizeof(float);
        for (std::size_t part = 0; part < fft_rows; part += lanes) {
            V most = splat<V>(0.0f);
            for (std::size_t q = 0; q < fft.n / 4; ++q) {
                ComplexPack<V> found[4];
                fft.last(from + q * fft_element + part, found);
                for (const ComplexPack<V>& x : found) {
                    most = larger(most, x.re * x.re + x.im * x.im);
                }
            }
            for (std::size_t i = 0; i < lanes; ++i) {
                out[part + i] = most[i];
            }
        }
    }

    std::size_t blocks_;
    Aligned<float> sizes_;  // [block][order][radius]: upper bound on the modulus of the order
};

// Bound on the contribution of an azimuthal order to U. near: valid at all radii v, from |2 (n+1) J_{n+1}(v) / v| <= 1; far: factor
// of a bound that falls as v^(-4/3), from |J_n(v)| < 0.7858 v^(-1/3) (Landau 2000).
struct OrderSize {
    double near = 0.0, far = 0.0;
    static double fall(double v) { return v > 0.0 ? 1.572 / (v * std::cbrt(v)) : 1e200; }
    double fallen(double by) const { return std::min(near, far * by); }
};

// Add bounds on each order m of a disk's field to sizes[2 m] (cosine) and sizes[2 m + 1] (sine). weight: factor of this field;
// shrunk: radius of the disk relative to the full disk, so that its field depends on shrunk * v.
inline void add_sizes(const ZernikeSeries& series, double weight, double shrunk, std::vector<OrderSize>& sizes) {
    const double stretch = 1.0 / (shrunk * std::cbrt(shrunk));
    for (std::size_t m = 0; m < series.orders; ++m) {
        for (std::size_t j = 0; j < 2 * series.used[m]; ++j) {
            const double size = weight * series.size(series.start[m] + j / 2, j % 2);
            sizes[2 * m + j % 2].near += size / static_cast<double>(m + j / 2 * 2 + 1);
            sizes[2 * m + j % 2].far += size * stretch;
        }
    }
}

// Bounds on the contribution to U of all azimuthal orders from m on, for each m.
class PolarOrders {
   public:
    explicit PolarOrders(const PolarPupil& pupil) : tails_(pupil.orders() + 1) {
        std::vector<OrderSize> sizes(2 * pupil.orders());
        for (const PolarPupil::Disk& disk : pupil.disks) {
            add_sizes(*disk.series, std::abs(disk.weight), disk.shrunk, sizes);
        }
        for (std::size_t m = pupil.orders(); m-- > 0;) {
            tails_[m].near = tails_[m + 1].near + sizes[2 * m].near + sizes[2 * m + 1].near;
            tails_[m].far = tails_[m + 1].far + sizes[2 * m].far + sizes[2 * m + 1].far;
        }
    }

    // Bound on the sum of U's orders m >= `orders` at radii >= v, together with its aliases. These are at most `aliases` times the
    // bound on this sum at any radius.
    double left(std::size_t orders, double v, double aliases) const {
        return left_of(tails_[orders], OrderSize::fall(v), aliases);
    }
    // Smallest number of orders to keep, so that left(), the bound on the omitted orders, is at most `error`.
    std::size_t least(double error, double v, double aliases) const {
        const double fall = OrderSize::fall(v);
        std::size_t m = tails_.size() - 1;
        while (m > 1 && left_of(tails_[m - 1], fall, aliases) <= error) {
            --m;
        }
        return m;
    }

   private:
    static double left_of(const OrderSize& tail, double fall, double aliases) {
        return std::min(tail.near, tail.fallen(fall) + aliases * tail.near);
    }

    std::vector<OrderSize> tails_;
};

}  // namespace lommel
