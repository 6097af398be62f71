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
    // Zernike terms, possibly none, to differentiate with respect to; off: error bound of the complex amplitude; pupils: those of the
    // stack to compute; moduli[pupil]: receives a bound on the sum of |weight| |U| in a pixel, of averages.
    ApertureSums(const DiskStack& stack, const ApertureRule& rule, const WindowAxis& rows, const WindowAxis& columns,
                 double step, Real* images, const PixelNodes* nodes, double* brightest, const More& more, double off,
                 const std::vector<std::size_t>& pupils, double* moduli)
        : stack_(stack), nodes_(nodes), more_(more), off_(off), level_(processor_level()),
          lone_(more.terms.empty() && Kernels::lone(level_, pupils.size())), images_(images), brightest_(brightest),
          pupils_(pupils), moduli_(moduli) {
        const ChordLanes in = Kernels::chord_lanes(level_, lone_);
        const ChordCount count{rule.size, rule.size};
        disks_[0] = {cache<ApertureTable>.get(rule, stack.terms, in),
                     cache<KernelTable<Real>>.get(count, rows, columns, step, in),
                     more.terms.empty() ? nullptr : cache<FactorTable>.get(count, more.terms, 1.0)};
        if (nodes != nullptr) {
            weights_ = std::make_shared<const NodeWeights<Real>>(*nodes, in);
            const std::vector<double> down = blocks(nodes->down, nodes->height, nodes->rows.count),
                                      across = blocks(nodes->across, nodes->width, nodes->columns.count);
            const WindowAxis block_rows(down.size() / nodes->height, 0.0), block_columns(across.size() / nodes->width, 0.0);
            const PixelNodes of_blocks{block_rows,    block_columns, nodes->height, nodes->width, down.data(),
                                       across.data(), nullptr,       nullptr,       nullptr};
            block_weights_ = std::make_shared<const NodeWeights<Real>>(of_blocks, in);
        }
    }

    void run(int threads) const {
        const std::size_t side = lone_ ? 1 : Kernels::lanes(level_), batches = (pupils_.size() + side - 1) / side;
        const double size = static_cast<double>(disks_[0].terms->count.chords);
        const double work = 2e-4 * size * size * size * static_cast<double>(pupils_.size());
        parallel_for(batches, worthwhile_threads(threads, work), [&](std::size_t, std::size_t b) {
            thread_local ChordalScratch<Real> scratch;
            thread_local typename ChordalScratch<Real>::Values brightest;
            const std::size_t first = b * side, here = std::min(side, pupils_.size() - first);
            run_batch({level_, stack_, pupils_.data() + first, here, 0.0, disks_, scratch}, brightest);
        });
    }

   private:
    using Kernels = ChordKernels<Real>;

    // Samples of a block are bounded by the brightest of them.
    static constexpr std::size_t block = 2;

    // Sums of the moduli of the weights [pixel][node] over the nodes of each block.
    static std::vector<double> blocks(const double* weights, std::size_t pixels, std::size_t nodes) {
        const std::size_t count = (nodes + block - 1) / block;
        std::vector<double> sums(pixels * count, 0.0);
        for (std::size_t i = 0; i < pixels * nodes; ++i) {
            sums[i / nodes * count + i % nodes / block] += std::abs(weights[i]);
        }
        return sums;
    }

    // brightest[block of rows][block of columns][lane]: include the samples of row y.
    void include_row(const ChordalBatch<Real>& batch, std::size_t y, const Real* row,
                     typename ChordalScratch<Real>::Values& brightest) const {
        const std::size_t stride = batch.lone() ? 1 : batch.lanes();
        Kernels::include_largest(batch.level, row, batch.columns(), block, stride,
                                 brightest.data() + y / block * block_weights_->columns * stride);
    }

    // Bound the sums of |weight| |U| in pixels, from the brightest samples of all blocks, whose roots are taken in place.
    void find_moduli(const ChordalBatch<Real>& batch, typename ChordalScratch<Real>::Values& brightest) const {
        constexpr double rounding = 1.001;  // of roots, weights and sums
        const std::size_t lanes = batch.lanes(), line = brightest.size() / block_weights_->rows;
        for (Real& each : brightest) {
            each = std::sqrt(each);
        }
        begin_averages(batch, *block_weights_);
        for (std::size_t y = 0; y < block_weights_->rows; ++y) {
            add_averages(batch, *block_weights_, y, brightest.data() + y * line);
        }
        double most[most_pupils] = {};
        for (std::size_t i = 0; i < batch.scratch.sums.size(); i += lanes) {
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                most[lane] = std::max(most[lane], batch.scratch.sums[i + lane]);
            }
        }
        for (std::size_t lane = 0; lane < batch.here; ++lane) {
            moduli_[batch.pupils[lane]] = rounding * (batch.lone() ? *std::max_element(most, most + lanes) : most[lane]);
        }
    }

    void run_batch(const ChordalBatch<Real>& batch, typename ChordalScratch<Real>::Values& brightest) const {
        const std::size_t lanes = batch.lanes(), vectors = batch.vectors();
        batch.scratch.intensity.resize(vectors * lanes);
        alignas(64) Real peaks[most_pupils] = {};
        double ones[most_pupils];
        std::fill_n(ones, most_pupils, 1.0);
        if (nodes_ != nullptr) {
            begin_averages(batch, *weights_);
            brightest.assign(block_weights_->rows * block_weights_->columns * (lone_ ? 1 : lanes), Real(0));
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
                include_row(batch, y, row, brightest);
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
            find_moduli(batch, brightest);
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
    const std::vector<std::size_t>& pupils_;
    double* moduli_;
    std::shared_ptr<const NodeWeights<Real>> weights_, block_weights_;
};

}  // namespace lommel
