// Polar non-uniform FFT, pupil: settings of the interpolation between circles, and error bound of the field U.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/zernike/field.hpp"
#include "lommel/zernike/polar_circles.hpp"

namespace lommel {

// Settings of the interpolation between circles. oversampling: circles are pi / oversampling apart in v; between, around: number
// of taps between circles and along them; doubles: pixels are summed in double precision; exact: FFTs are in double precision;
// rough: positions and sums over degrees are in single precision.
struct PolarStyle {
    double oversampling;
    std::size_t between, around;
    bool doubles, exact, rough = false;

    double step() const { return pi / oversampling; }
    // Return whether PairedTaps are used: if there are four taps between circles.
    bool paired() const { return between == 4; }
    GriddingKernel kernel() const { return GriddingKernel::of(between, oversampling); }
};
// Settings {oversampling, between, around, doubles, exact, rough = false}, from the most accurate to the fastest.
inline constexpr std::array<PolarStyle, 14> polar_styles = {{{2.0, 14, 14, true, true},
                                                             {2.0, 12, 12, true, true},
                                                             {3.0, 10, 10, true, true},
                                                             {2.0, 10, 10, true, true},
                                                             {2.0, 10, 8, true, true},
                                                             {3.0, 8, 8, false, true},
                                                             {2.0, 8, 8, false, false},
                                                             {2.0, 8, 6, false, false},
                                                             {1.5, 8, 6, false, false},
                                                             {1.5, 8, 4, false, false},
                                                             {1.5, 6, 4, false, false},
                                                             {1.5, 6, 4, false, false, true},
                                                             {1.5, 4, 3, false, false, true},
                                                             {1.5, 4, 2, false, false, true}}};

// Disks of a pupil: the full disk and the obscuration, if there is one.
struct PolarPupil {
    struct Disk {
        const ZernikeSeries* series;
        double shrunk, weight;  // radius relative to the full disk; factor of the field
        Doubles parts;  // coefficients times `weight`, as in PolarDisk::parts
        Aligned<float> singles;
    };
    std::vector<Disk> disks;
    double base;  // error bound of U from the expansion and from rounding of positions

    explicit PolarPupil(const ZernikeField& field)
        // Rounding errors of positions, less than 64 (v + 64) roundoffs in v, change U by at most half as much, as |dU/dv| < 1/2.
        : base(field.base() + 32.0 * unit_roundoff * (field.reach() + 64.0)) {
        add(field.outer(), 1.0, 1.0);
        if (field.obscured()) {
            add(field.inner(), field.obscuration(), -field.obscuration() * field.obscuration());
        }
    }

    std::size_t orders() const {
        std::size_t most = 0;
        for (const Disk& disk : disks) {
            most = std::max(most, disk.series->orders);
        }
        return most;
    }

   private:
    void add(const ZernikeSeries& series, double shrunk, double weight) {
        disks.push_back({&series, shrunk, weight, Doubles(4 * series.parts[0].size()), {}});
        for (std::size_t i = 0; i < disks.back().parts.size(); ++i) {
            disks.back().parts[i] = weight * series.parts[i % 4][i / 4];
        }
        disks.back().singles.assign(disks.back().parts.begin(), disks.back().parts.end());
    }
};

// Kernels of the interpolation between circles, one for the aperture and one for the obscuration, with the settings `style`, and
// their contributions to the error of the field U.
struct PolarKernels {
    std::vector<std::shared_ptr<const PolarKernel>> disks;
    double aliasing = 0.0;  // bound on the error of U from aliases
    double growth = 0.0;  // relative growth of the expansion's error by aliases

    PolarKernels(const PolarPupil& pupil, const PolarStyle& style) {
        const GriddingKernel kernel = style.kernel();
        for (const PolarPupil::Disk& disk : pupil.disks) {
            disks.push_back(cache<PolarKernel>.get(disk.shrunk * style.step(), kernel.w, kernel.beta()));
            // aliases: error bound of U due to aliases, if |pupil function| <= 1. The error e of the Zernike expansion of the pupil
            // function grows by aliases * e.
            aliasing += std::abs(disk.weight) * disks.back()->aliases;
            growth = std::max(growth, disks.back()->aliases);
        }
    }
    const PolarKernel& outer() const { return *disks[0]; }
};

// Error of the field U that arises before the FFT: from the sums over every other degree (chain), from the table, and from omitted
// degrees (left_out); twice each, as Cauchy's inequality bounds cosines and sines separately. each: error of (n + 1) * table value
// of degree n.
inline double polar_rounding(const PolarPupil::Disk& disk, const PolarStyle& style, const PolarKernel& kernel, double each) {
    const double degrees = static_cast<double>(disk.series->degrees),
                 chain = (style.rough ? roundoff<float> : unit_roundoff) * (degrees + 8.0) * kernel.largest;
    return 2.0 * std::abs(disk.weight) * (chain + PolarTable::rounding(each, degrees) + PolarTable::left_out);
}

// Tables of the transforms for both disks, with `blocks` blocks of sixteen circles.
struct PolarTables {
    std::vector<std::shared_ptr<const PolarTable>> tables;
    std::vector<PolarDisk> disks;
    std::vector<double> errors;  // [block]: error of U from rounding before the FFT

    PolarTables(const PolarPupil& pupil, const PolarStyle& style, const PolarKernels& kernels, std::size_t blocks)
        : errors(blocks, 0.0) {
        for (std::size_t i = 0; i < pupil.disks.size(); ++i) {
            const PolarPupil::Disk& disk = pupil.disks[i];
            const PolarKernel& k = *kernels.disks[i];
            tables.push_back(cache<PolarTable>.get(k.step, k.kernel.w, k.kernel.beta(), blocks, disk.series->degrees));
            const PolarTable& table = *tables.back();
            disks.push_back({disk.series, disk.parts.data(), disk.singles.data(), table.values.data(), table.degrees,
                             table.reached.data()});
            for (std::size_t b = 0; b < blocks; ++b) {
                errors[b] += polar_rounding(disk, style, k, table.roundings[b]);
            }
        }
    }
};

// Error bound of U at pixels that are interpolated from the circle of radius v and its neighbours. orders: number of azimuthal
// orders that U has on the circle; left: error bound of U due to the omitted orders; rows: error contributions of the circle
// itself.
inline double polar_error(const PolarPupil& pupil, const PolarStyle& style, const PolarKernels& kernels,
                          const PolarCircle& circle, std::size_t orders, double left, double v, const PolarRowError& rows) {
    const PolarKernel& kernel = kernels.outer();
    const double weights = kernel.weight * circle.weight,
                 // Rounding of the FFT and of two operations before it.
        transform = style.exact ? roundoff<double> * (circle.exact.rounding() + 2.0)
                                : roundoff<float> * (circle.single.rounding() + 2.0);
    const double pixel = style.doubles ? roundoff<double> : roundoff<float>;
    // Error of a kernel's taps. With style.exact, taps are computed in double precision and rounded once.
    const auto off = [&](const GriddingTaps& taps) {
        return style.exact ? taps.doubles.error + pixel * taps.weight : style.paired() ? taps.coarse.error : taps.singles.error;
    };
    const double between = off(kernel), around = off(circle);
    // Rounding of U, in roundoffs: 1 from stored circles, 2 from products, 2 from |U|^2 (its 4 roundings count half in U), and the
    // rounding of the sum over each kernel's taps.
    const double sums = pixel * (5.0 + kernel.chain / kernel.weight + circle.chain / circle.weight);
    // With style.rough, add the error of U due to positions in single precision.
    const double base = pupil.base + (style.rough ? 16.0 * roundoff<float> * (std::max(v, 0.0) + 64.0) : 0.0);
    // A complex number is at most sqrt(2) < 1.42 times the larger of |re|, |im|.
    return (base + left) * (1.0 + kernels.growth) + kernels.aliasing + kernel.weight * rows.around +
           weights * (circle.growth(orders) * rows.sums + transform * rows.sum) +
           1.42 * 1.01 * (weights * sums + between * circle.weight + around * kernel.weight) * rows.largest;
}

}  // namespace lommel
