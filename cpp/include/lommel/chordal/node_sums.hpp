// Pixel averages of the intensity, accumulated row by row from samples at the nodes of a window.
#pragma once

#include <algorithm>
#include <cstddef>

#include "lommel/chordal/averages.hpp"
#include "lommel/chordal/batch.hpp"

namespace lommel {

template <class Real>
void begin_averages(const ChordalBatch<Real>& batch, const NodeWeights<Real>& weights) {
    batch.scratch.lines.resize(weights.vectors * node_block * batch.lanes());
    batch.scratch.sums.assign((1 + weights.height) * weights.vectors * batch.lanes(), 0.0);
}

// Add row y of samples, intensity[node][lane], to pixel averages. scratch.sums: averages along the row, then pixel averages.
template <class Real>
void add_averages(const ChordalBatch<Real>& batch, const NodeWeights<Real>& weights, std::size_t y, const Real* intensity) {
    using Kernels = ChordKernels<Real>;
    const std::size_t lanes = batch.lanes(), at = y % node_block, line = weights.vectors * lanes;
    double* const sums = batch.scratch.sums.data();
    std::fill_n(sums, line, 0.0);
    Kernels::average_along(batch.level, weights, intensity, sums);
    for (std::size_t v = 0; v < weights.vectors; ++v) {
        std::transform(sums + v * lanes, sums + (v + 1) * lanes, batch.scratch.lines.data() + (v * node_block + at) * lanes,
                       [](double sum) { return static_cast<Real>(sum); });
    }
    if (at == node_block - 1 || y + 1 == weights.rows) {
        Kernels::average_down(batch.level, weights, y - at, batch.scratch.lines.data(), sums + line);
    }
}

// Copy the pixel averages of one vector lane. Negative values are kept, unlike in store_averages(): derivatives have both signs.
template <class Real>
void copy_averages(const ChordalBatch<Real>& batch, const NodeWeights<Real>& weights, std::size_t lane, double* to) {
    const std::size_t lanes = batch.lanes();
    for (std::size_t y = 0; y < weights.height; ++y) {
        const double* const from = batch.scratch.sums.data() + (1 + y) * weights.vectors * lanes + lane;
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
            const double* const from = batch.scratch.sums.data() + (1 + y) * weights.vectors * lanes;
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
