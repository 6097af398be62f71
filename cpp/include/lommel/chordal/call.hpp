// What is asked of the chordal rule in one call: pupils, a window, and for each pupil how many chords and nodes serve its error.
// Images, their derivatives and gradients are made of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/chordal/factors.hpp"
#include "lommel/chordal/lines.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

constexpr double max_table_bytes = 268435456.0;  // of the kernel for one window

// What the error of an image is spent on.
struct ChordalBudget {
    // Of the tolerance times the peak of |U|, on U, which counts twice in I; the rest is a margin, for the peak is a guess.
    static constexpr double field = 0.4;
    static_assert(2.0 * field <= 1.0);
    // Of the error of U, on the disk and the obscured one where there is one.
    static constexpr double outer = 0.6, inner = 0.4;
    static_assert(outer + inner <= 1.0);
    // Of that of a disk, on the sum over chords, the most; those over their nodes have the rest.
    static constexpr double chords = 0.7;
    static_assert(chords < 1.0);
    // Of tolerance and peak, on U and its rounding to single precision, where sums have that: twice as much as of a peak that is
    // likely; and of this the most that may be rounding.
    static constexpr double single = 0.6, rounding = 0.7;
    // What is asked of U where that did not do: what the peak that was found asks for, between these parts of what was asked.
    static constexpr double again = 0.3, least = 1e-3;
};

class ChordalCall {
   public:
    // With derivatives by the coefficients of `factors`, if there are any.
    ChordalCall(const DiskStack& stack, const DiskWindow& window, double tol, int threads, bool single,
                std::vector<ZernikeTerm> factors = {})
        : stack_(stack), factors_(std::move(factors)), rows_(window.height, window.row), columns_(window.width, window.column),
          step_(window.step), tol_(tol), threads_(threads), area_(stack.obscuration * stack.obscuration),
          lines_(stack, {step_ * columns_.low(), step_ * columns_.high(), step_ * rows_.low(), step_ * rows_.high()},
                 static_cast<double>(rows_.at.size()), static_cast<double>(rows_.count * columns_.at.size()), threads),
          states_(stack.count) {
        for (State& s : states_) {
            s.single = single;
        }
    }

   protected:
    struct State {
        double error = 0.0, relative = 1e300, peak = 0.0;
        bool at_rounding = false;  // less than this error cannot be asked for
        bool single = false;  // whether sums are in single precision
        ChordDisk far, near;  // the whole disk and the obscured one
    };

    // The lines of all disks, and the error to ask for first.
    void begin() {
        const double bright = stack_.amplitude.integral(stack_.obscuration);
        const auto first = [&](std::size_t p, const ChordBound& bound) {
            check_phase(bound.size());
            // Most PSFs have sup|U| above this; where one has not, the error is tightened after that was found.
            return states_[p].error = ChordalBudget::field * tol_ * 0.5 * bright / std::sqrt(1.0 + bound.variance());
        };
        lines_.find(stack_.outer.data(), 1.0, first, [&](std::size_t p) -> ChordDisk& { return states_[p].far; });
        if (area_ > 0.0) {
            const auto same = [&](std::size_t p, const ChordBound&) { return states_[p].error; };
            lines_.find(stack_.inner.data(), stack_.obscuration, same,
                        [&](std::size_t p) -> ChordDisk& { return states_[p].near; });
        }
    }

    // What U is off by at most where the rule has so many chords and nodes; or the field of a pupil function times i Z, Z a
    // term of some degree.
    double wrong(const ChordDisk& disk, const ChordCount& n, bool single, const Factor& factor = {}) const {
        return factor.growth(disk.chords.line.curve) * disk.chords.line.bound(Sum::chords, n.chords) +
               factor.growth(disk.nodes.line.curve) * disk.nodes.line.bound(Sum::nodes, n.nodes) + disk.rounding +
               ChordBound::rounding(n.chords, n.nodes) + factor.rounding(single) +
               (single ? ChordBound::single_rounding(static_cast<double>(n.chords), static_cast<double>(n.nodes),
                                                     stack_.terms.size())
                       : 0.0);
    }

    // Chords and nodes of both disks for an error of U, or of the fields of a factor.
    void choose(std::size_t p, double error, const Factor& factor = {}) {
        State& s = states_[p];
        choose(p, 1.0, s.far, area_ > 0.0 ? ChordalBudget::outer * error : error, factor);
        if (area_ > 0.0) {
            choose(p, stack_.obscuration, s.near, ChordalBudget::inner * error / area_, factor);
        }
    }

    // Those that are computed in single precision first, and those that share tables one after the other; returns how many are.
    std::size_t sort(std::vector<std::size_t>& pupils) const {
        std::sort(pupils.begin(), pupils.end(), [&](std::size_t a, std::size_t b) {
            const ChordCount &i = states_[a].far.count, &j = states_[b].far.count;
            if (states_[a].single != states_[b].single) {
                return states_[a].single;
            }
            return i.chords != j.chords ? i.chords < j.chords : i.nodes != j.nodes ? i.nodes < j.nodes : a < b;
        });
        const auto end = std::partition_point(pupils.begin(), pupils.end(), [&](std::size_t p) { return states_[p].single; });
        return static_cast<std::size_t>(end - pupils.begin());
    }

    template <class Real>
    struct Tables {
        std::shared_ptr<const TermTable> terms;
        std::shared_ptr<const KernelTable<Real>> kernel;
        std::shared_ptr<const FactorTable> factors;
    };

    // Calls work(isa, pupils, how many, tables of the disk, of the obscured one) for as many pupils at once as vectors have lanes.
    template <class Real, class Work>
    void for_batches(const std::size_t* pupils, std::size_t count, const Work& work) const {
        const std::size_t lanes = vector_lanes() * sizeof(double) / sizeof(Real), batches = (count + lanes - 1) / lanes;
        // Tables before threads, so that no thread waits for another to make them.
        std::vector<Tables<Real>> outer(batches), inner(batches);
        for (std::size_t b = 0; b < batches; ++b) {
            ChordCount far, near;
            for (std::size_t i = b * lanes; i < std::min(count, (b + 1) * lanes); ++i) {
                far.include(states_[pupils[i]].far.count);
                near.include(states_[pupils[i]].near.count);
            }
            const bool same = b > 0 && outer[b - 1].terms->count == far;
            outer[b] = same ? outer[b - 1] : tables<Real>(far, 1.0);
            if (area_ > 0.0) {
                const bool alike = b > 0 && inner[b - 1].terms->count == near;
                inner[b] = alike ? inner[b - 1] : tables<Real>(near, stack_.obscuration);
            }
        }
        parallel_for(batches, threads_, [&](std::size_t, std::size_t b) {
            const std::size_t first = b * lanes, here = std::min(lanes, count - first);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { work(isa, pupils + first, here, outer[b], inner[b]); });
        });
    }

    // What U is off by at most, or the field of a factor, of which tilts and terms take as much of the phase.
    template <class Real>
    double off(std::size_t p, const Tables<Real>& outer, const Tables<Real>& inner, const Factor& factor = {}) const {
        const State& s = states_[p];
        const bool single = sizeof(Real) == sizeof(float);
        return (factor.degree > 0 ? 2.0 : 1.0) * stack_.lost[p] + wrong(s.far, outer.terms->count, single, factor) +
               (area_ > 0.0 ? area_ * wrong(s.near, inner.terms->count, single, factor) : 0.0);
    }

    template <class I, class Real>
    LOMMEL_INLINE void gather(I, const std::vector<double>& coefficients, const std::size_t* pupils, std::size_t here,
                              const TermTable& table, Doubles& to) const {
        using Wave = Waves<I, Real>;
        const std::size_t terms = stack_.terms.size();
        to.resize(terms * Wave::lanes);
        for (std::size_t lane = 0; lane < Wave::lanes; ++lane) {
            // Lanes without a pupil repeat the last one.
            const double* own = coefficients.data() + pupils[std::min(lane, here - 1)] * terms;
            for (std::size_t j = 0; j < terms; ++j) {
                to[j * Wave::lanes + Wave::place(lane)] = Wave::unit * own[table.classes.order[j]];
            }
        }
    }

    // The field at every pixel as pixel(row, column, re, im), and after each row row(it); far(chord) and near(chord) return the waves
    // of a pair of chords of the disk and of the obscured one.
    template <class I, class Real, class Far, class Near, class Pixel, class Row>
    LOMMEL_INLINE void fields(I isa, const Tables<Real>& outer, const Tables<Real>& inner, ChordalScratch<Real>& scratch,
                              const Far& far, const Near& near, const Pixel& pixel, const Row& row) const {
        using V = typename Waves<I, Real>::V;
        constexpr std::size_t lanes = Waves<I, Real>::lanes;
        const std::size_t width = columns_.count;
        if (area_ > 0.0) {
            scratch.inner.resize(rows_.count * width * 2 * lanes);
            Real* kept = scratch.inner.data();
            const V area = splat<V>(static_cast<Real>(area_));
            chordal_fields(isa, *inner.kernel, scratch, near, [&](std::size_t y, const Real* u) LOMMEL_INLINE_LAMBDA {
                for (std::size_t j = 0; j < 2 * width * lanes; j += lanes) {
                    store(kept + 2 * y * width * lanes + j, load<V>(u + j) * area);
                }
            });
        }
        chordal_fields(isa, *outer.kernel, scratch, far, [&](std::size_t y, const Real* u) LOMMEL_INLINE_LAMBDA {
            const Real* less = area_ > 0.0 ? scratch.inner.data() + 2 * y * width * lanes : nullptr;
            for (std::size_t x = 0; x < width; ++x) {
                V re = load<V>(u + 2 * x * lanes), im = load<V>(u + (2 * x + 1) * lanes);
                if (less != nullptr) {
                    re = re - load<V>(less + 2 * x * lanes);
                    im = im - load<V>(less + (2 * x + 1) * lanes);
                }
                pixel(y, x, re, im);
            }
            row(y);
        });
    }

    const DiskStack& stack_;
    std::vector<ZernikeTerm> factors_;
    WindowAxis rows_, columns_;
    double step_, tol_;
    int threads_;
    double area_;
    ChordLines lines_;
    std::vector<State> states_;

   private:
    void choose(std::size_t p, double scale, ChordDisk& disk, double error, const Factor& factor) const {
        ChordLine chords = disk.chords.line, nodes = disk.nodes.line;
        chords.exponent += std::log(factor.growth(chords.curve));
        nodes.exponent += std::log(factor.growth(nodes.curve));
        const std::size_t needed = chords.enough(Sum::chords, ChordalBudget::chords * error);
        disk.count.chords = std::max(disk.least, needed);
        const double rest = error - chords.bound(Sum::chords, disk.count.chords);
        disk.count.nodes = needed > max_chords ? 0 : nodes.enough(Sum::nodes, rest);
        if (std::max(disk.count.chords, disk.count.nodes) > max_chords) {
            const bool many = disk.count.chords > max_chords;
            ChordBound bound = lines_.bound_of(scale);
            bound.prepare((scale == 1.0 ? stack_.outer : stack_.inner).data() + p * stack_.terms.size());
            bound.refuse(many ? Sum::chords : Sum::nodes, many ? chords : nodes, many ? ChordalBudget::chords * error : rest);
        }
    }

    template <class Real>
    std::shared_ptr<const KernelTable<Real>> kernel(const ChordCount& count, double step) const {
        if (KernelTable<Real>::bytes(count, rows_.at.size()) > max_table_bytes) {
            throw PhaseTooLarge("a window of " + std::to_string(rows_.count) + " rows and these phases take " +
                                std::to_string(count.chords) + " chords of " + std::to_string(count.nodes) +
                                " nodes, whose tables exceed the limit of 256 MiB");
        }
        return cache<KernelTable<Real>>.get(count, rows_, columns_, step);
    }

    template <class Real>
    Tables<Real> tables(const ChordCount& count, double scale) const {
        // The kernel first: it knows when there are too many chords.
        const auto k = kernel<Real>(count, scale * step_);
        return {cache<TermTable>.get(count, stack_.terms, stack_.amplitude.scaled(scale * scale)), k,
                factors_.empty() ? nullptr : cache<FactorTable>.get(count, factors_, scale)};
    }
};

}  // namespace lommel
