// Derivatives of the intensity |U|^2 with respect to a Zernike coefficient c: d|U|^2/dc = -2 Im(conj(U) D). U is the Fourier
// transform of the pupil function P, D that of Z P, with Z the Zernike polynomial (docs/certificate.md, section 8).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/bounds/chords.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/node_sums.hpp"
#include "lommel/limits.hpp"

namespace lommel {

struct NoDerivatives {
    static constexpr bool wanted = false, keeps_nodes = false;
    std::vector<ZernikeTerm> terms;
};

inline std::size_t highest_degree(const std::vector<ZernikeTerm>& terms) {
    std::size_t degree = 0;
    for (const ZernikeTerm& term : terms) {
        degree = std::max(degree, static_cast<std::size_t>(term.n));
    }
    return degree;
}

// Function that returns three numbers of a pupil: sqrt(peak intensity); error bound of the complex amplitude U; error bound of the
// Fourier transform of the pupil function times a Zernike term of degree `degree`.
using PupilErrors = Reference<std::array<double, 3>(std::size_t pupil, std::size_t degree)>;

// Derivatives of images, [term][pupil]. images: derivatives, in the scale of the images; bounds: their error bounds / peak.
template <class T>
struct ChordalDerivatives {
    static constexpr bool wanted = true, keeps_nodes = true;
    std::vector<ZernikeTerm> terms;
    T* images;
    double* bounds;
    double* averages = nullptr;  // if not null: receives derivatives of pixel averages; `bounds` are then absolute
    double* sizes = nullptr;  // with `averages`: bounds on |derivative of the intensity| at the samples, [term][pupil]

    // Compute the derivatives for a batch from the complex amplitudes U (scratch.fields) and the pupil functions (scratch.kept).
    // scales[lane]: image / |U|^2; found: see PupilErrors; weights: those of the samples in pixel averages, or null.
    template <class Real>
    void follow(const ChordalBatch<Real>& batch, const double* scales, const PupilErrors& found,
                const NodeWeights<Real>* weights) const {
        using Kernels = ChordKernels<Real>;
        const std::size_t lanes = batch.lanes(), width = batch.columns(), pixels = batch.rows() * width;
        ChordalScratch<Real>& scratch = batch.scratch;
        for (std::size_t first = 0; first < terms.size();) {
            const auto given = [&](std::size_t disk) {
                return FactorLanes(*batch.disks[disk].factors, batch.here, lanes, first);
            };
            const auto prepare = [&](std::size_t disk) {
                scratch.factors.assign(batch.room(disk) / 2, Real(0));
                scratch.factored.resize(batch.room(disk));
            };
            const auto nodes = [&](std::size_t disk, std::size_t i) {
                const Real* from = scratch.kept[disk].data() + i * batch.room(disk);
                Kernels::times_factors(batch.level, given(disk), i, from, scratch.factors.data(), scratch.factored.data());
                return scratch.factored.data();
            };
            const FactorLanes outer = given(0);
            const auto cut = [&] {
                const StripTerms& factors = *batch.strips.factors;
                scratch.strip_factors.assign(factors.points.x.size() * lanes, Real(0));
                for (std::size_t lane = 0; lane < outer.used(); ++lane) {
                    factors.column(outer.term(lane), [&](std::size_t point, double value) {
                        scratch.strip_factors[point * lanes + lane] = static_cast<Real>(value);
                    });
                }
                batch.strip_fields([&](std::size_t i, Real* sums) {
                    const StripLine& line = factors.points.lines[i];
                    Kernels::strip_products(batch.level, line, scratch.strip_kept.data() + 2 * line.first * lanes,
                                            scratch.strip_factors.data() + line.first * lanes, sums);
                });
            };
            alignas(64) Real tops[most_pupils] = {};
            if (weights != nullptr) {
                begin_averages(batch, *weights);
            }
            batch.fields(prepare, nodes, cut, [&](std::size_t y, const Real* d) {
                const Real* u = scratch.fields.data() + y * width * 2 * lanes;
                Kernels::slopes(batch.level, u, d, width, scratch.intensity.data(), tops);
                if (weights != nullptr) {
                    return add_averages(batch, *weights, y, scratch.intensity.data());
                }
                T* to[most_pupils];
                double by[most_pupils];
                for (std::size_t lane = 0; lane < outer.used(); ++lane) {
                    const std::size_t p = lane % batch.here, k = outer.table.classes.order[outer.term(lane)];
                    to[lane] = images + (k * batch.stack.count + batch.pupils[p]) * pixels + y * width;
                    by[lane] = scales[p];
                }
                Kernels::store_lanes(batch.level, scratch.intensity.data(), outer.used(), by, width, to);
            });
            for (std::size_t lane = 0; lane < outer.used(); ++lane) {
                const std::size_t p = batch.pupils[lane % batch.here], k = outer.table.classes.order[outer.term(lane)];
                const auto [u, error, factor_error] = found(p, static_cast<std::size_t>(terms[k].n));
                const double d = std::sqrt(static_cast<double>(tops[lane]));
                // Relative rounding error of a derivative: two products and their difference in Im(conj(U) D); conversion to T.
                const double rounding = storing<T>(false) + (sizeof(Real) == 4 ? 2.0 * single_roundoff : 0.0);
                const double off = 2.0 * (u * factor_error + d * error + factor_error * error + u * d * rounding);
                const std::size_t at = k * batch.stack.count + p;
                if (weights == nullptr) {
                    bounds[at] = over_peak(off, u * u, error);
                    continue;
                }
                bounds[at] = off;
                sizes[at] = 2.0 * u * d;
                copy_averages(batch, *weights, lane, averages + at * weights->height * weights->width);
            }
            first += outer.count;
        }
    }
};

}  // namespace lommel
