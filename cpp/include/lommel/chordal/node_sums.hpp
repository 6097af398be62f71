// Pixel averages of the intensity, accumulated row by row from samples at the nodes of a window.
#pragma once

#include <algorithm>
#include <cstddef>

#include "lommel/chordal/averages.hpp"
#include "lommel/chordal/batch.hpp"

namespace lommel {

template <class Real>
void begin_averages(const ChordalBatch<Real>& batch, const NodeWeights<Real>& weights) {
    batch.scratch.lines.resize(weights.vectors * weights.rows * batch.lanes());
    batch.scratch.sums.resize(weights.height * weights.vectors * batch.lanes());
}

// Average row y of samples, intensity[node][lane], along x; after the last row, scratch.sums are the pixel averages.
template <class Real>
void add_averages(const ChordalBatch<Real>& batch, const NodeWeights<Real>& weights, std::size_t y, const Real* intensity) {
    using Kernels = ChordKernels<Real>;
    Real* const lines = batch.scratch.lines.data();
    Kernels::average_along(batch.level, weights, y, intensity, lines);
    if (y + 1 == weights.rows) {
        Kernels::average_down(batch.level, weights, lines, batch.scratch.sums.data());
    }
}

// Copy the pixel averages of one vector lane. Negative values are kept, unlike in store_averages(): derivatives have both signs.
template <class Real>
void copy_averages(const ChordalBatch<Real>& batch, const NodeWeights<Real>& weights, std::size_t lane, double* to) {
    const std::size_t lanes = batch.lanes();
    for (std::size_t y = 0; y < weights.height; ++y) {
        const double* const from = batch.scratch.sums.data() + y * weights.vectors * lanes + lane;
        for (std::size_t x = 0; x < weights.width; ++x) {
            *to++ = from[x * lanes];
        }
    }
}

template <class Real>
void store_averages(const ChordalBatch<Real>& batch, const NodeWeights<Real>& weights, const PixelNodes& nodes) {
    const std::size_t lanes = batch.lanes(), size = weights.height * weights.width;
    for (std::size_t lane = 0; lane < (batch.lone() ? 1 : batch.here); ++lane) {
        const std::size_t pupil = batch.pupils[lane];
        double* to = nodes.averages + pupil * size;
        double top = 0.0, all = 0.0;
        for (std::size_t y = 0; y < weights.height; ++y) {
            const double* const from = batch.scratch.sums.data() + y * weights.vectors * lanes;
            double sum = 0.0;
            for (std::size_t x = 0; x < weights.width; ++x) {
                const double value = std::max(0.0, batch.lone() ? from[x] : from[x * lanes + lane]);
                *to++ = value;
                top = std::max(top, value);
                sum += value;
            }
            all += sum;
        }
        nodes.largest[pupil] = top;
        nodes.together[pupil] = all;
    }
}

}  // namespace lommel
