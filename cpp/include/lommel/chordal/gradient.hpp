// Reverse-mode derivatives: gradient of a weighted sum of pixels by all Zernike coefficients c (docs/certificate.md, section 8,
// "Derivatives"). The adjoint at a pupil node r is G(r) = sum over pixels v of weight x conj(U) x exp(-i v r), with U the complex
// amplitude; d/dc = -2 Im(sum of Z P G over the nodes), with Z the Zernike polynomial and P the pupil function.
#pragma once

#include <cstddef>
#include <vector>

#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/derivatives.hpp"

namespace lommel {

// Template argument `More` of ChordalSums: values[pupil][term] receives the derivative, with respect to a Zernike coefficient, of
// the sum over pixels of weights[pupil][pixel] x intensity.
struct ChordalGradient {
    static constexpr bool wanted = true, keeps_nodes = false;
    std::vector<ZernikeTerm> terms;
    const double* weights;
    double* values;

    template <class Real>
    void follow(const ChordalBatch<Real>& batch, const double*, const PupilErrors&, const NodeWeights<Real>*) const {
        using Kernels = ChordKernels<Real>;
        const std::size_t lanes = batch.lanes(), pixels = batch.rows() * batch.columns();
        ChordalScratch<Real>& scratch = batch.scratch;
        scratch.intensity.resize(pixels * lanes);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double* own = weights + batch.pupils[lane % batch.here] * pixels;
            for (std::size_t q = 0; q < pixels; ++q) {
                scratch.intensity[q * lanes + lane] = static_cast<Real>(own[q]);
            }
        }
        Kernels::weigh(batch.level, scratch.intensity.data(), pixels, scratch.fields.data());
        scratch.factors.assign(terms.size() * lanes, Real(0));
        for (std::size_t disk = batch.area > 0.0 ? 2 : 1; disk-- > 0;) {
            const KernelTable<Real>& kernel = *batch.disks[disk].kernel;
            scratch.chords[disk].resize(kernel.rows.count * kernel.count.half_chords() * 4 * lanes);
            scratch.kept[disk].resize(batch.room(disk));
            scratch.factored.resize(batch.room(disk));
            scratch.inner.resize(batch.room(disk) / 2);
            Kernels::columns_transposed(batch.level, kernel, scratch.fields.data(), scratch.chords[disk].data());
            batch.gather(disk);
            for (std::size_t i = 0; i < kernel.count.half_chords(); ++i) {
                look();
                Real *const nodes = scratch.kept[disk].data(), *const adjoint = scratch.factored.data();
                Kernels::nodes(batch.level, *batch.disks[disk].terms, i, scratch.coefficients.data(), nodes);
                Kernels::rows_transposed(batch.level, kernel, i, scratch.chords[disk].data(), adjoint);
                Kernels::add_products(batch.level, *batch.disks[disk].factors, i, nodes, adjoint,
                                      static_cast<Real>(disk == 0 ? 1.0 : -batch.area), scratch.inner.data(),
                                      scratch.factors.data());
            }
        }
        for (std::size_t j = 0; j < terms.size(); ++j) {
            const std::size_t k = batch.disks[0].factors->classes.order[j];
            for (std::size_t lane = 0; lane < batch.here; ++lane) {
                values[batch.pupils[lane] * terms.size() + k] = static_cast<double>(scratch.factors[j * lanes + lane]);
            }
        }
    }
};

}  // namespace lommel
