// Error bounds of quadrature along chords of the pupil, for a stack of pupils. They need a bound on the integrand on a complex
// curve. The curve is chosen here; samples of the integrand on it give a smaller bound, and are taken if that saves time
// (docs/certificate.md, section 8).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/chordal/error_samples.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Error bound of one of the two sums of the quadrature, over chords or over the nodes of a chord. line: best bound found so far;
// curve: index of the complex curve on which the integrand may be sampled for a better one; bend: bound on the second derivatives
// of log(integrand) on this curve.
struct ChordSide {
    ChordLine line;
    std::size_t curve = 0;
    double bend = 0.0;
};

// Error bounds of the quadrature on one disk (aperture or obscuration) of one pupil.
struct ChordDisk {
    ChordSide chords, nodes;
    double rounding = 0.0;
    std::size_t least = 0;  // minimum number of chords for the bounds to hold
    ChordCount count;

    ChordSide& of(Sum sum) { return sum == Sum::chords ? chords : nodes; }
};

class ChordLines {
   public:
    // step: pixel pitch in units of lambda/(2 pi NA).
    ChordLines(const DiskStack& stack, const WindowAxis& rows, const WindowAxis& columns, double step, int threads)
        : stack_(stack), terms_(stack.terms),
          box_{step * columns.low(), step * columns.high(), step * rows.low(), step * rows.high()},
          around_{step * std::floor(columns.low()), step * std::ceil(columns.high()), step * std::floor(rows.low()),
                  step * std::ceil(rows.high())},
          rows_(static_cast<double>(rows.at.size())), pixels_(static_cast<double>(rows.count * columns.at.size())),
          threads_(threads) {}

    // Error bound, without samples of the integrand, of the field of a disk (aperture or obscuration) of `radius` aperture radii.
    ChordBound bound_of(double radius) const { return {terms_, stack_.amplitude.scaled(radius * radius), box_.scaled(radius)}; }

    using Error = Reference<double(std::size_t pupil, const ChordBound& bound)>;
    using Disk = Reference<ChordDisk&(std::size_t pupil)>;

    // For each pupil p, set disk(p) to those error bounds by which the fewest chords and nodes suffice. error(p, bound): requested
    // error of its field, given its bound without samples; radius: radius of the disk, in aperture radii.
    void find(const double* coefficients, double radius, const Error& error, const Disk& disk) const {
        std::vector<char> pays(stack_.count);
        std::vector<double> errors(stack_.count);
        const double samples = 2.0 * SharpTable::work(terms_);
        const ChordBound of_all = bound_of(radius);
        for_blocks(stack_.count, threads_, 0.5, [&](std::size_t from, std::size_t to) {
            ChordBound bound = of_all;
            for (std::size_t p = from; p < to; ++p) {
                bound.prepare(coefficients + p * stack_.terms.size());
                ChordDisk& here = disk(p);
                here.rounding = bound.rounding();
                errors[p] = error(p, bound);
                double plain[2], better[2];
                for (const Sum sum : {Sum::chords, Sum::nodes}) {
                    const std::size_t at = sum == Sum::chords ? 0 : 1;
                    const ChordLine likely = bound.best(sum, errors[p], usual_share[at]);
                    here.of(sum) = {bound.best(sum, errors[p], 1.0), likely.curve, bound.bend(sum, likely.curve)};
                    plain[at] = here.of(sum).line.needed(errors[p]);
                    better[at] = likely.needed(errors[p]);
                }
                pays[p] = work(plain[0], plain[1]) - work(better[0], better[1]) > 1.5 * samples &&
                          SharpTable::serves(terms_.degree, std::max(here.chords.curve, here.nodes.curve));
            }
        });
        std::vector<std::size_t> worth;
        for (std::size_t p = 0; p < stack_.count; ++p) {
            if (pays[p]) {
                worth.push_back(p);
            }
        }
        for (const Sum sum : {Sum::chords, Sum::nodes}) {
            sample(coefficients, of_all, around_.scaled(radius), sum, worth, errors, disk);
        }
    }

    // Choose the complex curves of the bounds again, for a smaller requested error. A new curve is kept if by its bound fewer
    // chords or nodes suffice.
    static void renew(ChordBound& bound, const double* coefficients, double error, ChordDisk& disk) {
        bound.prepare(coefficients);
        for (const Sum sum : {Sum::chords, Sum::nodes}) {
            const ChordLine found = bound.best(sum, error, 1.0);
            if (found.needed(error) < disk.of(sum).line.needed(error)) {
                disk.of(sum).line = found;
            }
        }
    }

    // Estimated cost of the images of one vector of pupils, in vector operations.
    double work(double chords, double nodes) const {
        return chords * nodes * (45.0 + static_cast<double>(stack_.terms.size()) + 2.0 * rows_) + 2.0 * chords * pixels_;
    }

   private:
    // Typical log(mean of |integrand| from samples) / log(bound on max |integrand|) for the sums over chords, over nodes.
    static constexpr double usual_share[2] = {0.4, 0.25};

    void sample(const double* coefficients, const ChordBound& bound, const VBox& box, Sum sum, std::vector<std::size_t>& worth,
                const std::vector<double>& errors, const Disk& disk) const {
        std::vector<std::pair<std::size_t, std::size_t>> order(worth.size());
        std::transform(worth.begin(), worth.end(), order.begin(),
                       [&](std::size_t p) { return std::make_pair(disk(p).of(sum).curve, p); });
        std::sort(order.begin(), order.end());
        std::transform(order.begin(), order.end(), worth.begin(), [](const auto& each) { return each.second; });
        const Level level = processor_level();
        const std::size_t lanes = 2 * widest_lanes(level), batches = (worth.size() + lanes - 1) / lanes;
        const std::size_t terms = stack_.terms.size();
        std::vector<std::shared_ptr<const SharpTable>> tables(batches);
        for (std::size_t b = 0; b < batches; ++b) {
            const std::size_t curve = disk(worth[b * lanes]).of(sum).curve;
            const bool same = b > 0 && tables[b - 1]->curve == curve;
            tables[b] = same ? tables[b - 1] : cache<SharpTable>.get(stack_.terms, sum, curve, box);
        }
        const double work = 2.0 * static_cast<double>(batches) * SharpTable::work(terms_);
        parallel_for(batches, worthwhile_threads(threads_, 3e-4 * work), [&](std::size_t, std::size_t b) {
            thread_local Floats given, room;
            const std::size_t* pupils = worth.data() + b * lanes;
            const std::size_t here = std::min(lanes, worth.size() - b * lanes);
            const SharpTable& table = *tables[b];
            const auto laid = [&](std::size_t from, std::size_t count, std::size_t stride) {
                given.assign(terms * stride, 0.0f);
                for (std::size_t lane = 0; lane < count; ++lane) {
                    const double* const own = coefficients + pupils[from + lane] * terms;
                    for (std::size_t j = 0; j < terms; ++j) {
                        given[j * stride + lane] = static_cast<float>(own[table.classes.order[j]]);
                    }
                }
            };
            room.resize(table.room() * lanes);
            float tops[2 * row_lanes], means[2 * row_lanes];
            // Pupils that fill at most half of a vector are computed one by one, with samples in the vector lanes.
            const bool lone = 2 * here <= lanes;
            for (std::size_t from = 0; from < here; from += lone ? 1 : here) {
                laid(from, lone ? 1 : here, lone ? 1 : lanes);
                dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                    float top[2 * row_lanes], mean[2 * row_lanes];
                    if (lone) {
                        sharp_means<true>(isa, table, given.data(), room.data(), top, mean);
                    } else {
                        sharp_means<false>(isa, table, given.data(), room.data(), top, mean);
                    }
                    std::copy_n(top, lone ? 1 : lanes, tops + from);
                    std::copy_n(mean, lone ? 1 : lanes, means + from);
                });
            }
            for (std::size_t lane = 0; lane < here; ++lane) {
                const std::size_t p = pupils[lane];
                ChordSide& side = disk(p).of(sum);
                // The table is for the curve of the batch's first pupil. Of all curves in the batch it is the nearest to the real
                // axis. side.bend bounds the second derivatives of log(integrand) on the pupil's own curve; this bound also holds
                // closer to the real axis.
                const double mean =
                    table.logarithm(tops[lane], means[lane]) + table.margin(side.bend, coefficients + p * terms);
                const ChordLine found = bound.line(sum, table.curve, mean);
                if (found.needed(errors[p]) < side.line.needed(errors[p])) {
                    side.line = found;
                    disk(p).least = sum == Sum::nodes ? SharpTable::least_chords : 0;
                }
            }
        });
    }

    const DiskStack& stack_;
    TermPairs terms_;
    VBox box_, around_;  // window; window rounded outwards to whole pixels, the same for small shifts of the axis
    double rows_, pixels_;
    int threads_;
};

}  // namespace lommel
