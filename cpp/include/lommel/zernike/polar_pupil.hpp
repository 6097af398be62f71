// Polar non-uniform FFT, pupil: parameters of the interpolation between circles, and the bound on the error of U.
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

// Circles pi / oversampling apart, so many taps between them and between their angles; whether pixels are summed, and circles
// transformed, in double precision; whether places are found, and degrees summed, in single precision.
struct PolarStyle {
    double oversampling;
    std::size_t between, around;
    bool doubles, exact, rough = false;

    double step() const { return pi / oversampling; }
    // Whether taps are those of PairedTaps.
    bool paired() const { return between == 4; }
    GriddingKernel kernel() const { return GriddingKernel::of(between, oversampling); }
};
// From the most exact one to that which costs least.
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

// What a pupil is made of: its disk and, of the same phase, the one within that is dark.
struct PolarPupil {
    struct Disk {
        const ZernikeSeries* series;
        double shrunk, weight;  // radius; what its field counts in that of the pupil
        Doubles parts;          // as PolarDisk has them
        Aligned<float> singles;
    };
    std::vector<Disk> disks;
    double base;  // the error of U that its expansion has, and what roundings of places make of it

    explicit PolarPupil(const ZernikeField& field)
        // A place between circles is off by less than 12 units, and one around them by less than 24 of a turn's angle; |U'| < 1/2
        // along any line.
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

// The kernels of both disks between circles of one style, and what they do to U.
struct PolarKernels {
    std::vector<std::shared_ptr<const PolarKernel>> disks;
    double aliasing = 0.0;  // aliases
    double growth = 0.0;    // relative, of the error of the expansion

    PolarKernels(const PolarPupil& pupil, const PolarStyle& style) {
        const GriddingKernel kernel = style.kernel();
        for (const PolarPupil::Disk& disk : pupil.disks) {
            disks.push_back(cache<PolarKernel>.get(disk.shrunk * style.step(), kernel.w, kernel.beta()));
            // Of what is expanded the mean square of g is at most 1, but for the error of the expansion.
            aliasing += std::abs(disk.weight) * disks.back()->aliases;
            growth = std::max(growth, disks.back()->aliases);
        }
    }
    const PolarKernel& outer() const { return *disks[0]; }
};

// Roundings of sums over degrees and of tables, in A_m or B_m of all orders together: cosines and sines, both by Cauchy, a chain
// over every other degree, and what the table leaves out and, (n+1) F_n of it, is off by. Single precision rounds both factors.
inline double polar_rounding(const PolarPupil::Disk& disk, const PolarStyle& style, const PolarKernel& kernel, double each) {
    const double degrees = static_cast<double>(disk.series->degrees),
                 chain = (style.rough ? roundoff<float> : unit_roundoff) * (degrees + 8.0) * kernel.largest;
    return 2.0 * std::abs(disk.weight) * (chain + PolarTable::rounding(each, degrees) + PolarTable::left_out);
}

// Their tables, of so many blocks.
struct PolarTables {
    std::vector<std::shared_ptr<const PolarTable>> tables;
    std::vector<PolarDisk> disks;
    std::vector<double> errors;  // of U in each block, before it is transformed, by roundings

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

// Bound on the error of U up to v between circles of so many orders with these errors: `left` is what orders left out can add.
inline double polar_error(const PolarPupil& pupil, const PolarStyle& style, const PolarKernels& kernels,
                          const PolarCircle& circle, std::size_t orders, double left, double v, const PolarRowError& rows) {
    const PolarKernel& kernel = kernels.outer();
    const double weights = kernel.weight * circle.weight,
                 // With two roundings before it.
        transform = style.exact ? roundoff<double> * (circle.exact.rounding() + 2.0)
                                : roundoff<float> * (circle.single.rounding() + 2.0);
    const double pixel = style.doubles ? roundoff<double> : roundoff<float>;
    // Exact circles have exact taps, rounded once.
    const auto off = [&](const GriddingTaps& taps) {
        return style.exact ? taps.doubles.error + pixel * taps.weight : style.paired() ? taps.coarse.error : taps.singles.error;
    };
    const double between = off(kernel), around = off(circle);
    // Storing the circles, a product and a chain of sums for each kernel, and of I four roundings, which are half as much of U.
    const double sums = pixel * (5.0 + kernel.chain / kernel.weight + circle.chain / circle.weight);
    // What roundings of places in single precision make.
    const double base = pupil.base + (style.rough ? 16.0 * roundoff<float> * (std::max(v, 0.0) + 64.0) : 0.0);
    // A complex number is at most sqrt(2) times the larger one of its parts.
    return (base + left) * (1.0 + kernels.growth) + kernels.aliasing + kernel.weight * rows.around +
           weights * (circle.growth(orders) * rows.sums + transform * rows.sum) +
           1.42 * 1.01 * (weights * sums + between * circle.weight + around * kernel.weight) * rows.largest;
}

}  // namespace lommel
