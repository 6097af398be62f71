// Intensities in single precision for given numbers of chords and nodes, no error bound (docs/certificate.md, "By the core").
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/derivatives.hpp"

namespace lommel {

// Images of pupils by quadrature with a given number of chords and nodes. `More`: NoDerivatives, or ChordalGradient for a gradient.
template <class More = NoDerivatives>
class ChordalSums {
   public:
    ChordalSums(const DiskStack& stack, const DiskWindow& window, const ChordCount& count, const More& more = {})
        : stack_(stack), more_(more), level_(processor_level()),
          lone_(!More::wanted && ChordKernels<float>::lone(level_, stack.count)), area_(stack.obscuration * stack.obscuration) {
        const WindowAxis rows(window.height, window.row), columns(window.width, window.column);
        for (std::size_t disk = 0; disk < (area_ > 0.0 ? 2 : 1); ++disk) {
            const double radius = disk == 0 ? 1.0 : stack.obscuration;
            disks_[disk] = ChordalTables<float>::of(stack, count, rows, columns, window.step, radius, more,
                                                    ChordKernels<float>::chord_lanes(level_, lone_));
        }
    }

    // Compute the intensities images[pupil][column][row]; if `images` is null, compute derivatives only.
    void run(float* images, int threads) const {
        const std::size_t lanes = lone_ ? 1 : ChordKernels<float>::lanes(level_), batches = (stack_.count + lanes - 1) / lanes;
        std::vector<std::size_t> pupils(stack_.count);
        std::iota(pupils.begin(), pupils.end(), std::size_t{0});
        parallel_for(batches, threads, [&](std::size_t, std::size_t b) {
            thread_local ChordalScratch<float> scratch;
            const std::size_t first = b * lanes, here = std::min(lanes, stack_.count - first);
            run_batch({level_, stack_, pupils.data() + first, here, area_, disks_, scratch}, images);
        });
    }

   private:
    void run_batch(const ChordalBatch<float>& batch, float* images) const {
        const std::size_t lanes = batch.lanes(), width = batch.columns(), height = batch.rows();
        const std::size_t vectors = batch.vectors(), stride = lone_ ? 1 : lanes;
        ChordalScratch<float>& scratch = batch.scratch;
        scratch.intensity.resize(vectors * lanes);
        alignas(64) float peaks[most_pupils] = {};
        scratch.fields.resize(More::wanted ? 2 * height * width * lanes : 0);
        batch.pupil_fields(More::keeps_nodes, [&](std::size_t y, const float* u) {
            if (images != nullptr) {
                ChordKernels<float>::intensities(batch.level, u, vectors, scratch.intensity.data(), peaks);
            }
            for (std::size_t x = 0; x < width && images != nullptr; ++x) {
                for (std::size_t lane = 0; lane < batch.here; ++lane) {
                    images[(batch.pupils[lane] * width + x) * height + y] = scratch.intensity[x * stride + lane];
                }
            }
            if constexpr (More::wanted) {
                std::copy_n(u, 2 * width * lanes, scratch.fields.data() + y * 2 * width * lanes);
            }
        });
        if constexpr (More::wanted) {
            const NodeWeights<float>* const none = nullptr;
            more_.follow(batch, nullptr, [](std::size_t, std::size_t) { return std::array<double, 3>{}; }, none);
        }
    }

    const DiskStack& stack_;
    More more_;
    Level level_;
    bool lone_;  // true if pupils are computed one by one, with chords in the vector lanes
    double area_;
    std::array<ChordalTables<float>, 2> disks_;
};

}  // namespace lommel
