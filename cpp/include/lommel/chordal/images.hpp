// Small images for any Zernike terms, with error bounds, by Gauss quadrature along chords (docs/certificate.md, section 8).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/derivatives.hpp"
#include "lommel/chordal/error_curves.hpp"
#include "lommel/chordal/node_sums.hpp"
#include "lommel/chordal/strip_choice.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/series_cost.hpp"

namespace lommel {

constexpr double max_table_bytes = 402653184.0;  // limit for the Fourier kernel of one window

// Error budget of the complex amplitude U in the image; tol: tolerance of the intensity |U|^2 relative to its peak.
struct ChordalBudget {
    // (Allowed error of U) / (tol x estimated max |U|). The relative error of |U|^2 is twice that of U: it stays below tol if
    // max |U| is at least 2 * field times its estimate.
    static constexpr double field = 0.4;
    static_assert(2.0 * field <= 1.0);
    // Shares of the error of U for the full disk (outer), and for the obscuration of an annular aperture (inner).
    static constexpr double outer = 0.6, inner = 0.4;
    static_assert(outer + inner <= 1.0);
    static constexpr double strips = 0.25;  // share of the error of U for strips
    // Largest part of a disk's allowed error that the sum over chords may take; what it leaves is for the sums over nodes.
    static constexpr double chords = 0.7;
    static_assert(chords < 1.0);
    // In single precision. single: (allowed error of U) / (tol x estimated max |U|); rounding: largest fraction of this error for
    // rounding.
    static constexpr double single = 0.6, rounding = 0.85;
    // Variances of the phase (rad^2) above which max |U| may be below its estimate. The allowed error of U is then reduced, as a
    // second attempt would double the work: by moderate_factor above moderate_variance; above large_variance instead by
    // large_factor or, in single precision, by large_factor_single.
    static constexpr double moderate_variance = 4.0, moderate_factor = 0.75, large_variance = 100.0, large_factor = 0.25,
                            large_factor_single = 0.7;
    // Second attempt: the allowed error of U is multiplied by a factor of at least retry_least and, if the first attempt was in
    // double precision, at most retry_most. retry_single: as `single`, but relative to tol x computed max |U|.
    static constexpr double retry_most = 0.3, retry_least = 1e-3, retry_single = 0.47;
    // For pixel averages: (allowed error of U) / tolerance. The rest of the tolerance is for rounding, which grows with the number
    // of nodes: tables shared by batches have more nodes than a batch needs.
    static constexpr double of_nodes = 0.9;
};

// Renders images of a stack of pupils. `More`: NoDerivatives, or ChordalDerivatives for derivatives of the images.
template <class T, class More = NoDerivatives>
class ChordalRenderer {
   public:
    ChordalRenderer(const DiskStack& stack, const DiskWindow& window, double tol, int threads, const Answer<T>& answer,
                    const More& more = {})
        : stack_(stack), rows_(window.height, window.row), columns_(window.width, window.column), step_(window.step), tol_(tol),
          threads_(threads), answer_(answer), more_(more), degree_(highest_degree(more.terms)),
          area_(stack.obscuration * stack.obscuration), lines_(stack, rows_, columns_, step_, threads), states_(stack.count) {
        cut();
    }

    // Render pixel averages; the samples at `nodes` are not stored. tol: tolerance of the complex amplitude at the nodes, absolute.
    ChordalRenderer(const DiskStack& stack, const PixelNodes& nodes, double tol, int threads, const Answer<T>& answer,
                    const More& more = {})
        : stack_(stack), rows_(nodes.rows), columns_(nodes.columns), step_(1.0), tol_(tol), threads_(threads), answer_(answer),
          more_(more), degree_(highest_degree(more.terms)), area_(stack.obscuration * stack.obscuration),
          lines_(stack, rows_, columns_, step_, threads), states_(stack.count), nodes_(&nodes) {
        cut();
    }

    void run();

    // Render if the estimated time is less than a Zernike series takes (docs/certificate.md, section 7); else throw LimitExceeded.
    // Behind strips there is no series.
    void run_if_cheaper() {
        weighed_ = !has_strips();
        run();
    }
    // Estimated times in ns of this method and of a Zernike series; no images are computed.
    std::pair<double, double> costs() {
        only_costs_ = true;
        run();
        return costs_;
    }

   private:
    // State of a pupil. error: requested error of the complex amplitude U; relative: error bound of the image, relative to its
    // peak, but for pixel averages the error bound of U; peak: peak intensity.
    struct State {
        double error = 0.0, relative = 1e300, peak = 0.0;
        bool at_rounding = false;                  // the requested error is as small as rounding permits
        bool retried = false;                        // in a second attempt, as the first missed the tolerance
        bool single = sizeof(T) == sizeof(float);  // sums are in single precision
        double in_single = 0.0;  // allowed error of U in single precision, rounding included
        ChordDisk outer, inner;  // error bounds of the full disk, of the obscuration
    };

    // Requested error of U: share * tol_ * peak, with peak = max |U|; for pixel averages, of_nodes * tol_, as tol_ is absolute.
    double requested_error(double share, double peak) const {
        return nodes_ != nullptr ? ChordalBudget::of_nodes * tol_ : share * tol_ * peak;
    }

    // Error bound of one disk's complex amplitude; degree > 0: of the amplitude for pupil function x Zernike term of this degree.
    double error_bound(const ChordDisk& disk, const ChordCount& n, bool single, std::size_t degree = 0) const {
        const ChordLine chords = disk.chords.line.times(degree), nodes = disk.nodes.line.times(degree);
        return chords.bound(Sum::chords, n.chords) + nodes.bound(Sum::nodes, n.nodes) + disk.rounding +
               ChordBound::rounding(n.chords, n.nodes) + ChordBound::factor_rounding(degree, single) +
               (single ? ChordBound::single_rounding(static_cast<double>(n.chords), static_cast<double>(n.nodes),
                                                     stack_.terms.size())
                       : 0.0);
    }

    // Keep single precision for pupil p only if its rounding error is at most the fraction ChordalBudget::rounding of the allowed
    // error. Return the error of U that is allowed for quadrature.
    double single_request(std::size_t p) {
        State& s = states_[p];
        const double chords = s.outer.chords.line.times(degree_).needed(s.error);
        const double nodes = s.outer.nodes.line.times(degree_).needed(s.error);
        const double rounding =
            (1.0 + area_) * ChordBound::single_rounding(chords, nodes, stack_.terms.size()) + strip_rounding(p, true);
        const double all = s.in_single * (answer_.scales[p] == 0.0 ? 0.5 : 1.0);
        s.single = rounding <= ChordalBudget::rounding * all;
        return s.single ? std::min(s.error, all - rounding) : s.error;
    }

    void choose(std::size_t p, double scale, ChordDisk& disk, double error) const {
        const ChordLine across = disk.chords.line.times(degree_), along = disk.nodes.line.times(degree_);
        const std::size_t chords = across.enough(Sum::chords, ChordalBudget::chords * error);
        disk.count.chords = std::max(disk.least, chords);
        const double rest = error - across.bound(Sum::chords, disk.count.chords);
        disk.count.nodes = chords > max_chords ? 0 : along.enough(Sum::nodes, rest);
        if (std::max(disk.count.chords, disk.count.nodes) > max_chords) {
            const bool many = disk.count.chords > max_chords;
            ChordBound bound = lines_.bound_of(scale);
            bound.prepare((scale == 1.0 ? stack_.outer : stack_.inner).data() + p * stack_.terms.size());
            bound.refuse(many ? Sum::chords : Sum::nodes, many ? across : along, many ? ChordalBudget::chords * error : rest,
                         max_table_bytes / KernelTable<double>::bytes(1.0, rows_.at.size()));
        }
    }

    // Add up the area of the strips.
    void cut() {
        for (const Strip& strip : stack_.strips) {
            cut_ += strip.area();
        }
    }
    bool has_strips() const { return !stack_.strips.empty(); }

    // Bound on the rounding error of the strips' field: that of a disk, and that of sums over the nodes of a line and over taps.
    double strip_rounding(std::size_t p, bool single) const {
        const double own = states_[p].outer.rounding + strips_.rounding(stack_.terms.size(), single);
        return 2.0 * cut_ * own;
    }

    template <class Real>
    ChordalTables<Real> tables(const ChordCount& count, double radius, const ChordLanes& lanes) const {
        const double bytes = KernelTable<Real>::bytes(count.size(), rows_.at.size());
        if (bytes > max_table_bytes) {
            throw LimitExceeded("a window of " + std::to_string(rows_.count) + " rows and these phases take " +
                                std::to_string(count.chords) + " chords of " + std::to_string(count.nodes) +
                                " nodes, whose tables exceed the limit of 384 MiB; at most phases and windows of " +
                                shortened(0.01 * std::floor(95.0 * std::cbrt(max_table_bytes / bytes))) +
                                " times the size fit");
        }
        return ChordalTables<Real>::of(stack_, count, rows_, columns_, step_, radius, more_, lanes);
    }

    // Pupils computed together. lone: just one, with chords in the vector lanes. outer, inner: quadrature of the full disk, of the
    // obscuration.
    struct Group {
        std::size_t first, here;
        bool lone;
        ChordCount outer, inner;

        double size() const { return outer.size() + inner.size(); }
        void include(const Group& other) {
            outer.include(other.outer);
            inner.include(other.inner);
        }
    };
    // Largest factor on the number of nodes for tables that are shared; bytes of tables that single images share.
    static constexpr double most_more = 1.12, large_table = 4e6;
    // Give neighbouring groups the same quadrature and tables, unless a group would then get more than `more` times as many nodes
    // as it needs.
    static void share(std::vector<Group>& groups, double more) {
        for (std::size_t first = 0, end = 0; first < groups.size(); first = end) {
            Group all = groups[first];
            double least = all.size();
            for (; end < groups.size() && groups[end].lone == all.lone; ++end) {
                Group next = all;
                next.include(groups[end]);
                least = std::min(least, groups[end].size());
                if (next.size() > more * least) {
                    break;
                }
                all = next;
            }
            for (std::size_t i = first; i < end; ++i) {
                groups[i].include(all);
            }
        }
    }
    // Return whether these pupils are computed one by one. Places of pixels behind strips must then be equally spaced.
    template <class Real>
    bool one_by_one(std::size_t pupils) const {
        return !More::wanted && !(has_strips() && nodes_ != nullptr) && ChordKernels<Real>::lone(processor_level(), pupils);
    }
    template <class Real>
    std::vector<Group> grouped(const std::size_t* pending, std::size_t pupils, bool alike = false) const {
        const Level level = processor_level();
        std::vector<Group> groups;
        for (std::size_t first = 0; first < pupils; first += groups.back().here) {
            const bool lone = one_by_one<Real>(alike || has_strips() ? pupils : pupils - first);
            Group next{first, lone ? 1 : std::min(ChordKernels<Real>::lanes(level), pupils - first), lone, {}, {}};
            for (std::size_t i = first; i < first + next.here; ++i) {
                next.outer.include(states_[pending[i]].outer.count);
                next.inner.include(states_[pending[i]].inner.count);
            }
            // Single images of similar phases share large tables, which take longer than their sums.
            if (lone && KernelTable<Real>::bytes(next.outer.size(), rows_.at.size()) > large_table) {
                next.outer = next.outer.rounded(most_more);
                next.inner = next.inner.rounded(most_more);
            }
            groups.push_back(next);
        }
        share(groups, most_more);
        // If `alike`, or if the tables exceed the caches, all groups share one table: then all or none of them must be `lone`.
        if (alike || !kept<Real>(groups)) {
            if (groups.front().lone != groups.back().lone) {
                return grouped<Real>(pending, pupils, true);
            }
            share(groups, std::numeric_limits<double>::infinity());
        }
        return groups;
    }

    // Total number of nodes in the tables of these groups; a table that groups share counts once.
    static double nodes_of(const std::vector<Group>& groups) {
        double nodes = 0.0;
        ChordCount last[2];
        bool lone = !groups.empty() && groups.front().lone;
        for (const Group& group : groups) {
            const ChordCount counts[2] = {group.outer, group.inner};
            const bool same = group.lone == lone;
            lone = group.lone;
            for (std::size_t disk = 0; disk < 2; ++disk) {
                if (!same || !(counts[disk] == last[disk])) {
                    nodes += counts[disk].size();
                    last[disk] = counts[disk];
                }
            }
        }
        return nodes;
    }

    // Return whether the tables of these groups, and those of a second attempt, fit into the caches.
    template <class Real>
    bool kept(const std::vector<Group>& groups) const {
        const double nodes = 2.5 * nodes_of(groups);
        return nodes * 2.0 * static_cast<double>(stack_.terms.size()) < static_cast<double>(TermTable::most_bytes) &&
               KernelTable<Real>::bytes(nodes, rows_.at.size()) < static_cast<double>(KernelTable<Real>::of_stack);
    }

    // Batch of pupils pending[first] .. pending[first + here - 1]. disks: tables of the full disk, tables of the obscuration.
    template <class Real>
    struct Batch {
        std::size_t first, here;
        std::array<ChordalTables<Real>, 2> disks;
        std::shared_ptr<const NodeWeights<Real>> weights;  // for pixel averages, else null
    };

    template <class Real>
    void dispatch_batches(const std::size_t* pending, std::size_t pupils) {
        const Level level = processor_level();
        // Compute all tables before threads start: then no thread waits for a table.
        std::vector<Batch<Real>> batches;
        StripTables<Real> strips;
        if (has_strips() && pupils > 0) {
            if (one_by_one<Real>(pupils)) {
                strips.lone = cache<LoneStripTable<Real>>.get(stack_.strips, strips_.count, stack_.amplitude, rows_, columns_,
                                                              step_, ChordKernels<Real>::lanes(level));
            } else {
                strips.window =
                    cache<StripTable<Real>>.get(stack_.strips, strips_.count, stack_.amplitude, rows_, columns_, step_);
            }
            strips.terms = cache<StripTerms>.get(stack_.strips, strips_.count, stack_.terms);
            strips.factors = More::keeps_nodes ? cache<StripTerms>.get(stack_.strips, strips_.count, more_.terms) : nullptr;
        }
        double work = 0.0;
        for (const Group& group : grouped<Real>(pending, pupils)) {
            const Batch<Real>* last = batches.empty() ? nullptr : &batches.back();
            const ChordLanes in = ChordKernels<Real>::chord_lanes(level, group.lone);
            const auto made = [&](std::size_t disk, const ChordCount& count, double radius) {
                const bool same = last != nullptr && last->disks[disk].terms->is(count, in);
                return same ? last->disks[disk] : tables<Real>(count, radius, in);
            };
            Batch<Real> next{group.first, group.here, {made(0, group.outer, 1.0), {}}, nullptr};
            if (nodes_ != nullptr) {
                const bool same = last != nullptr && last->weights->side == in.side;
                next.weights = same ? last->weights : std::make_shared<const NodeWeights<Real>>(*nodes_, in);
            }
            if (area_ > 0.0) {
                next.disks[1] = made(1, group.inner, stack_.obscuration);
            }
            batches.push_back(std::move(next));
            work += lines_.work(static_cast<double>(group.outer.chords), static_cast<double>(group.outer.nodes)) *
                    (group.lone ? 2.0 / static_cast<double>(ChordKernels<Real>::lanes(level)) : 1.0);
        }
        parallel_for(batches.size(), worthwhile_threads(threads_, 3e-4 * work), [&](std::size_t, std::size_t b) {
            thread_local ChordalScratch<Real> scratch;
            const Batch<Real>& batch = batches[b];
            run_batch<Real>({level, stack_, pending + batch.first, batch.here, area_, batch.disks, scratch, strips},
                            batch.weights.get());
        });
    }

    template <class Real>
    void run_batch(const ChordalBatch<Real>& batch, const NodeWeights<Real>* weights) {
        using Kernels = ChordKernels<Real>;
        const std::size_t lanes = batch.lanes(), width = columns_.count, pixels = rows_.count * width, here = batch.here;
        const std::size_t vectors = batch.vectors();
        double scale[most_pupils];
        for (std::size_t lane = 0; lane < here; ++lane) {
            const double given = answer_.scales[batch.pupils[lane]];
            scale[lane] = given == 0.0 ? 1.0 : given;
        }
        ChordalScratch<Real>& scratch = batch.scratch;
        scratch.intensity.resize(vectors * lanes);
        scratch.fields.resize(More::wanted ? 2 * pixels * lanes : 0);
        Real* intensity = scratch.intensity.data();
        alignas(64) Real peaks[most_pupils] = {};
        if (weights != nullptr) {
            begin_averages(batch, *weights);
        }
        batch.pupil_fields(More::keeps_nodes, [&](std::size_t y, const Real* u) {
            Kernels::intensities(batch.level, u, vectors, intensity, peaks);
            if constexpr (More::wanted) {
                std::copy_n(u, 2 * width * lanes, scratch.fields.data() + y * 2 * width * lanes);
            }
            if (weights != nullptr) {
                add_averages(batch, *weights, y, intensity);
            } else if (answer_.images != nullptr && batch.lone()) {
                Kernels::store_row(batch.level, intensity, scale[0], width,
                                   answer_.images + batch.pupils[0] * pixels + y * width);
            } else if (answer_.images != nullptr) {
                T* to[most_pupils];
                for (std::size_t lane = 0; lane < here; ++lane) {
                    to[lane] = answer_.images + batch.pupils[lane] * pixels + y * width;
                }
                Kernels::store_lanes(batch.level, intensity, here, scale, width, to);
            }
        });
        if (batch.lone()) {
            peaks[0] = *std::max_element(peaks, peaks + lanes);
        }
        if (weights != nullptr) {
            store_averages(batch, *weights, *nodes_);
        }
        bool any = false;
        for (std::size_t lane = 0; lane < here; ++lane) {
            any = finish(batch, batch.pupils[lane], static_cast<double>(peaks[lane])) || any;
        }
        if constexpr (More::wanted) {
            if (any) {
                more_.follow(
                    batch, scale,
                    [&](std::size_t p, std::size_t degree) {
                        return std::array<double, 3>{std::sqrt(states_[p].peak), error_of(batch, p, 0),
                                                     error_of(batch, p, degree)};
                    },
                    weights);
            }
        }
    }

    // Estimated CPU time in ns if all tables are cached. Coefficients: from benchmarks/choice.py, for vectors of any width.
    template <class Real>
    double nanoseconds(const std::size_t* pending, std::size_t pupils) const {
        const double lanes = static_cast<double>(ChordKernels<Real>::lanes(processor_level()));
        const double terms = static_cast<double>(stack_.terms.size()), rows = static_cast<double>(rows_.at.size());
        const double height = static_cast<double>(rows_.count), columns = static_cast<double>(columns_.at.size());
        const std::vector<Group> groups = grouped<Real>(pending, pupils);
        // byte: time in ns to read a byte of the kernel table, from shared cache or, if the table exceeds it, from memory.
        const double tables = KernelTable<Real>::bytes(nodes_of(groups), rows_.at.size());
        const double byte = 0.0061 + 0.028 * std::clamp((tables - 8e6) / 4e6, 0.0, 1.0);
        double sum = 0.0;
        for (const Group& group : groups) {
            for (const ChordCount& count : {group.outer, group.inner}) {
                const double chords = static_cast<double>(count.chords);
                if (chords > 0.0 && group.lone) {
                    const double nodes = std::ceil(0.5 * chords / lanes) * static_cast<double>(count.nodes);
                    const double table = KernelTable<Real>::bytes(2.0 * nodes * lanes, rows_.at.size());
                    sum += 660.0 + (10.3 + 0.98 * terms + 0.134 * rows) * nodes + byte * table +
                           (0.54 * chords * std::ceil(columns / lanes) + 2.0 * columns) * height;
                } else if (chords > 0.0) {
                    sum += 1940.0 + (2.2 + 0.165 * terms + 0.57 * rows) * count.size() +
                           (0.17 * chords + 1.15 * static_cast<double>(group.here)) * columns * height;
                }
            }
        }
        return sum;
    }

    // Estimate times of this method (costs_.first; the first `singles` pupils in float) and of a Zernike series (costs_.second).
    // In run_if_cheaper(), throw LimitExceeded if the series is likely to take less time.
    void weigh(const std::vector<std::size_t>& pending, std::size_t singles) {
        const double count = static_cast<double>(stack_.count);
        costs_.first = 8800.0 + 49.0 * count * static_cast<double>(stack_.terms.size()) +
                       nanoseconds<double>(pending.data() + singles, pending.size() - singles);
        if constexpr (sizeof(T) == sizeof(float)) {
            costs_.first += nanoseconds<float>(pending.data(), singles);
        }
        if (nodes_ != nullptr) {
            const double down = static_cast<double>(nodes_->height), across = static_cast<double>(nodes_->width);
            costs_.first +=
                0.035 * count * across * static_cast<double>(rows_.count) * (static_cast<double>(columns_.count) + down);
        }
        const bool weighed = weighed_;
        weighed_ = false;
        costs_.second = SeriesCost::declined + SeriesCost::least * count;
        if (weighed && costs_.first <= costs_.second) {
            return;
        }
        DiskWindow window{rows_.count, columns_.count, rows_.center, columns_.center, step_};
        if (nodes_ != nullptr) {  // a Zernike series takes finer samples for pixel averages
            constexpr double more = 1.3;
            const double width = rows_.high() - rows_.low();
            window.height = static_cast<std::size_t>(more * static_cast<double>(rows_.count));
            window.width = static_cast<std::size_t>(more * static_cast<double>(columns_.count));
            window.step = width / static_cast<double>(window.height);
            window.row = -rows_.low() / window.step;
            window.column = -columns_.low() / window.step;
        }
        // The time of the series is extrapolated from at most eight pupils of the stack.
        const std::size_t looks = std::min<std::size_t>(stack_.count, 8);
        costs_.second = SeriesCost::declined;
        for (std::size_t i = 0; i < looks; ++i) {
            costs_.second +=
                SeriesCost::nanoseconds(stack_, window, i * stack_.count / looks, tol_) * count / static_cast<double>(looks);
        }
        if (weighed && costs_.first > costs_.second) {
            throw LimitExceeded("a series is likely to take less time than chords");
        }
    }

    // Error bound of a pupil's complex amplitude; degree > 0: of the amplitude for pupil function x Zernike term of this degree.
    template <class Real>
    double error_of(const ChordalBatch<Real>& batch, std::size_t p, std::size_t degree) const {
        const State& s = states_[p];
        const bool single = sizeof(Real) == sizeof(float);
        const double strips =
            has_strips() ? strips_.error + strips_.misfits * batch.strips.misfit() + strip_rounding(p, single) : 0.0;
        return stack_.lost[p] + strips + error_bound(s.outer, batch.disks[0].terms->count, single, degree) +
               (area_ > 0.0 ? area_ * error_bound(s.inner, batch.disks[1].terms->count, single, degree) : 0.0);
    }

    // Store the error bound of the image of pupil p; return whether the bound meets the tolerance.
    template <class Real>
    bool finish(const ChordalBatch<Real>& batch, std::size_t p, double peak) {
        State& s = states_[p];
        s.peak = peak;
        const bool divide = answer_.scales[p] == 0.0;
        const double error = error_of(batch, p, 0);
        s.relative = nodes_ != nullptr ? error : finished_error<T>(relative_error(peak, error), divide, true);
        if (!(s.relative <= tol_)) {
            return false;
        }
        answer_.bounds[p] = s.relative;
        answer_.peaks[p] = peak;
        if (divide) {
            const std::size_t pixels = rows_.count * columns_.count;
            T* image = answer_.images + p * pixels;
            store_scaled(image, answer_.scales[p] = 1.0 / peak, pixels, image);
        }
        return true;
    }

    const DiskStack& stack_;
    WindowAxis rows_, columns_;
    double step_, tol_;
    int threads_;
    Answer<T> answer_;
    More more_;
    std::size_t degree_;  // highest degree of the Zernike terms to differentiate with respect to
    double area_;
    ChordLines lines_;
    std::vector<State> states_;
    const PixelNodes* nodes_ = nullptr;  // sampling nodes for pixel averages, null for images
    bool weighed_ = false, only_costs_ = false;  // true in run_if_cheaper(); true in costs()
    std::pair<double, double> costs_;
    double cut_ = 0.0;  // area of the strips / pi
    StripChoice strips_;  // quadrature of the strips
};

template <class T, class More>
void ChordalRenderer<T, More>::run() {
    const double open = stack_.amplitude.integral(stack_.obscuration), bright = std::max(open - cut_, 0.3 * open);
    const auto first = [&](std::size_t p, const ChordBound& bound) {
        check_phase(bound.size());
        // Estimate of max |U|, U the complex amplitude. For the few PSFs with a smaller max |U|, there is a second attempt.
        const double peak = 0.5 * bright / std::sqrt(1.0 + bound.variance());
        State& s = states_[p];
        const bool large = bound.variance() > ChordalBudget::large_variance;
        const double factor = bound.variance() > ChordalBudget::moderate_variance ? ChordalBudget::moderate_factor : 1.0;
        s.in_single = requested_error((large ? ChordalBudget::large_factor_single : factor) * ChordalBudget::single, peak);
        return s.error = requested_error((large ? ChordalBudget::large_factor : factor) * ChordalBudget::field, peak);
    };
    lines_.find(stack_.outer.data(), 1.0, first, [&](std::size_t p) -> ChordDisk& { return states_[p].outer; });
    if (area_ > 0.0) {
        const auto same = [&](std::size_t p, const ChordBound&) { return states_[p].error; };
        lines_.find(stack_.inner.data(), stack_.obscuration, same,
                    [&](std::size_t p) -> ChordDisk& { return states_[p].inner; });
    }
    std::vector<std::size_t> pending(stack_.count);
    std::iota(pending.begin(), pending.end(), std::size_t{0});
    const auto attempt = [&] {
        const double left = has_strips() ? 1.0 - ChordalBudget::strips : 1.0;
        if (has_strips()) {
            double least = std::numeric_limits<double>::infinity();
            for (const std::size_t p : pending) {
                least = std::min(least, states_[p].error);
            }
            const VBox window{step_ * columns_.low(), step_ * columns_.high(), step_ * rows_.low(), step_ * rows_.high()};
            strips_ = StripChoice(stack_, pending, degree_, window, static_cast<double>(rows_.count * columns_.count),
                                  ChordalBudget::strips * least);
        }
        for_blocks(pending.size(), threads_, 0.3, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                const std::size_t p = pending[i];
                State& s = states_[p];
                const double rounding = s.outer.rounding + stack_.lost[p];
                s.at_rounding = s.error < rounding;
                s.error = std::max(s.error, rounding);
                const double error = left * (s.single ? single_request(p) : s.error);
                choose(p, 1.0, s.outer, area_ > 0.0 ? ChordalBudget::outer * error : error);
                if (area_ > 0.0) {
                    choose(p, stack_.obscuration, s.inner, ChordalBudget::inner * error / area_);
                }
            }
        });
        std::vector<std::tuple<bool, std::size_t, std::size_t, std::size_t>> order;
        order.reserve(pending.size());
        for (const std::size_t p : pending) {
            const State& s = states_[p];
            order.emplace_back(!s.single, s.outer.count.chords, s.outer.count.nodes, p);
        }
        std::sort(order.begin(), order.end());
        std::transform(order.begin(), order.end(), pending.begin(), [](const auto& each) { return std::get<3>(each); });
        const auto end = std::partition_point(pending.begin(), pending.end(), [&](std::size_t p) { return states_[p].single; });
        const std::size_t singles = static_cast<std::size_t>(end - pending.begin());
        if (only_costs_ || weighed_) {
            weigh(pending, singles);
        }
        if (only_costs_) {
            return 0.0;
        }
        if constexpr (sizeof(T) == sizeof(float)) {
            dispatch_batches<float>(pending.data(), singles);
        }
        dispatch_batches<double>(pending.data() + singles, pending.size() - singles);
        double worst = 0.0;
        for (const std::size_t p : pending) {
            worst = std::max(worst, states_[p].relative);
        }
        return worst;
    };
    settle(tol_, attempt, [&](double) {
        const auto done = [&](std::size_t p) { return states_[p].relative <= tol_; };
        pending.erase(std::remove_if(pending.begin(), pending.end(), done), pending.end());
        bool more = true;
        ChordBound outer = lines_.bound_of(1.0), inner = lines_.bound_of(stack_.obscuration);
        for (const std::size_t p : pending) {
            State& s = states_[p];
            more = more && !s.at_rounding;
            const double wanted =
                (nodes_ != nullptr ? ChordalBudget::retry_most : ChordalBudget::field * std::sqrt(s.peak)) * tol_;
            // A pupil in single precision is tried once more in single precision, with the computed peak, then in double precision.
            s.error = std::min((s.single ? 1.0 : ChordalBudget::retry_most) * s.error,
                               std::max(wanted, ChordalBudget::retry_least * s.error));
            s.in_single = requested_error(ChordalBudget::retry_single, std::sqrt(s.peak));
            s.single = s.single && !s.retried;
            s.retried = true;
            const std::size_t from = p * stack_.terms.size();
            ChordLines::renew(outer, stack_.outer.data() + from, s.error, s.outer);
            if (area_ > 0.0) {
                ChordLines::renew(inner, stack_.inner.data() + from, s.error, s.inner);
            }
        }
        return more;
    });
}

#if defined(LOMMEL_COMPILED)
extern template class ChordalRenderer<float>;
extern template class ChordalRenderer<double>;
extern template class ChordalRenderer<float, ChordalDerivatives<float>>;
extern template class ChordalRenderer<double, ChordalDerivatives<double>>;
#endif

}  // namespace lommel
