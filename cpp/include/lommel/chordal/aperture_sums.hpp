// Images and pixel averages of PSFs for apertures of any shape: quadrature on the unit disk whose complex weights reproduce the
// moments of the aperture (docs/certificate.md, section 18, "Moments"). The error bound of the field is given by the caller.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/derivatives.hpp"
#include "lommel/chordal/node_sums.hpp"

namespace lommel {

// Quadrature nodes on `size` chords of the unit disk, `size` (even) on each. Only nodes at x, y > 0 are indexed:
// weights[chord][node][signs of x, y: ++, +-, -+, --][re, im] contains the weights of a node and of its mirror images.
struct ApertureRule {
    std::size_t size;
    const double* weights;
};

// Zernike terms at the nodes of an ApertureRule. given: copy of the rule's weights, by which the cache finds the table.
struct ApertureTable : TermTable {
    std::vector<double> given;

    ApertureTable(const ApertureRule& rule, const std::vector<ZernikeTerm>& list, const ChordLanes& in)
        : TermTable({rule.size, rule.size}, list, Amplitude(), in),
          given(rule.weights, rule.weights + 2 * rule.size * rule.size) {
        weigh(rule.weights);
    }
    bool is(const ApertureRule& rule, const std::vector<ZernikeTerm>& list, const ChordLanes& in) const {
        return count.chords == rule.size && lanes == in && terms == list &&
               std::equal(given.begin(), given.end(), rule.weights, rule.weights + 2 * rule.size * rule.size);
    }
    std::size_t bytes() const { return TermTable::bytes() + given.size() * sizeof(double); }
};

// Images of a stack, or averages over the pixels of a window, by an ApertureRule.
template <class Real>
class ApertureSums {
   public:
    using More = ChordalDerivatives<Real>;

    // rows, columns: pixels of pitch `step`, or sampling nodes (step 1); images: receives the intensities, [pupil][row][column];
    // nodes: if not null, averages over pixels are computed instead; brightest[pupil]: receives the largest sampled intensity; more:
    // Zernike terms, possibly none, to differentiate with respect to; off: error bound of the complex amplitude.
    ApertureSums(const DiskStack& stack, const ApertureRule& rule, const WindowAxis& rows, const WindowAxis& columns,
                 double step, Real* images, const PixelNodes* nodes, double* brightest, const More& more, double off)
        : stack_(stack), nodes_(nodes), more_(more), off_(off), level_(processor_level()),
          lone_(more.terms.empty() && Kernels::lone(level_, stack.count)), images_(images), brightest_(brightest) {
        const ChordLanes in = Kernels::chord_lanes(level_, lone_);
        const ChordCount count{rule.size, rule.size};
        disks_[0] = {cache<ApertureTable>.get(rule, stack.terms, in),
                     cache<KernelTable<Real>>.get(count, rows, columns, step, in),
                     more.terms.empty() ? nullptr : cache<FactorTable>.get(count, more.terms, 1.0)};
        weights_ = nodes == nullptr ? nullptr : std::make_shared<const NodeWeights<Real>>(*nodes, in);
    }

    void run(int threads) const {
        const std::size_t side = lone_ ? 1 : Kernels::lanes(level_), batches = (stack_.count + side - 1) / side;
        std::vector<std::size_t> pupils(stack_.count);
        std::iota(pupils.begin(), pupils.end(), std::size_t{0});
        const double size = static_cast<double>(disks_[0].terms->count.chords);
        const double work = 2e-4 * size * size * size * static_cast<double>(stack_.count);
        parallel_for(batches, worthwhile_threads(threads, work), [&](std::size_t, std::size_t b) {
            thread_local ChordalScratch<Real> scratch;
            const std::size_t first = b * side, here = std::min(side, stack_.count - first);
            run_batch({level_, stack_, pupils.data() + first, here, 0.0, disks_, scratch});
        });
    }

   private:
    using Kernels = ChordKernels<Real>;

    void run_batch(const ChordalBatch<Real>& batch) const {
        const std::size_t lanes = batch.lanes(), vectors = batch.vectors();
        batch.scratch.intensity.resize(vectors * lanes);
        alignas(64) Real peaks[most_pupils] = {};
        double ones[most_pupils];
        std::fill_n(ones, most_pupils, 1.0);
        if (nodes_ != nullptr) {
            begin_averages(batch, *weights_);
        }
        const bool follow = !more_.terms.empty();
        const std::size_t line = 2 * batch.columns() * lanes;
        batch.scratch.fields.resize(follow ? batch.rows() * line : 0);
        batch.pupil_fields(follow, [&](std::size_t y, const Real* u) {
            if (follow) {
                std::copy_n(u, line, batch.scratch.fields.data() + y * line);
            }
            const Real* const row = batch.scratch.intensity.data();
            Kernels::intensities(batch.level, u, vectors, batch.scratch.intensity.data(), peaks);
            if (nodes_ != nullptr) {
                return add_averages(batch, *weights_, y, row);
            }
            Real* to[most_pupils];
            for (std::size_t lane = 0; lane < batch.here; ++lane) {
                to[lane] = images_ + (batch.pupils[lane] * batch.rows() + y) * batch.columns();
            }
            batch.lone() ? Kernels::store_row(batch.level, row, 1.0, batch.columns(), to[0])
                         : Kernels::store_lanes(batch.level, row, batch.here, ones, batch.columns(), to);
        });
        if (nodes_ != nullptr) {
            store_averages(batch, *weights_, *nodes_);
        }
        for (std::size_t lane = 0; lane < batch.here; ++lane) {
            const Real* const own = batch.lone() ? std::max_element(peaks, peaks + lanes) : peaks + lane;
            brightest_[batch.pupils[lane]] = static_cast<double>(*own);
        }
        if (follow) {
            const auto found = [&](std::size_t p, std::size_t degree) {
                const double more = ChordBound::factor_rounding(degree, sizeof(Real) == sizeof(float));
                return std::array<double, 3>{std::sqrt(brightest_[p]), off_, off_ + more};
            };
            more_.follow(batch, ones, found, weights_.get());
        }
    }

    const DiskStack& stack_;
    const PixelNodes* nodes_;
    More more_;
    double off_;
    Level level_;
    bool lone_;
    Real* images_;
    double* brightest_;
    std::array<ChordalTables<Real>, 2> disks_;
    std::shared_ptr<const NodeWeights<Real>> weights_;
};

}  // namespace lommel
