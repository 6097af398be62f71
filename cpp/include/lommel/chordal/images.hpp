// From any wavefronts to finished small images, each with its proven error, by the chordal Gauss rule on the disk.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/bounds/settle.hpp"
#include "lommel/chordal/sharp.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/pixels/render.hpp"
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
    // What is asked of U where that did not do: what the peak that was found asks for, between these parts of what was asked.
    static constexpr double again = 0.3, least = 1e-3;
};

template <class T>
class ChordalRenderer {
   public:
    ChordalRenderer(const DiskStack& stack, const DiskWindow& window, double tol, int threads, const DiskAnswer<T>& answer)
        : stack_(stack), rows_(window.height, window.row), columns_(window.width, window.column), step_(window.step), tol_(tol),
          threads_(threads), answer_(answer), terms_(stack.terms),
          box_{step_ * columns_.low(), step_ * columns_.high(), step_ * rows_.low(), step_ * rows_.high()},
          area_(stack.obscuration * stack.obscuration), inner_amplitude_(stack.amplitude.scaled(area_)), states_(stack.count) {}

    void run() {
        sharpen(stack_.outer.data(), 1.0, &State::far);
        if (area_ > 0.0) {
            sharpen(stack_.inner.data(), stack_.obscuration, &State::near);
        }
        ChordBound outer, inner;
        std::vector<std::size_t> pending(stack_.count);
        std::iota(pending.begin(), pending.end(), std::size_t{0});
        const auto attempt = [&] {
            for (const std::size_t p : pending) {
                look();
                State& s = states_[p];
                prepare(p, outer, inner);
                const double rounding = outer.rounding(0) + stack_.lost[p];
                s.at_rounding = s.error < rounding;
                s.error = std::max(s.error, rounding);
                s.chords = outer.chords(area_ > 0.0 ? ChordalBudget::outer * s.error : s.error);
                s.inner = area_ > 0.0 ? inner.chords(ChordalBudget::inner * s.error / area_) : 0;
            }
            std::sort(pending.begin(), pending.end(), [&](std::size_t a, std::size_t b) {
                return states_[a].chords != states_[b].chords ? states_[a].chords < states_[b].chords : a < b;
            });
            dispatch_batches(pending);
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
            for (const std::size_t p : pending) {
                State& s = states_[p];
                more = more && !s.at_rounding;
                const double wanted = ChordalBudget::field * tol_ * std::sqrt(s.peak);
                s.error = std::min(ChordalBudget::again * s.error, std::max(wanted, ChordalBudget::least * s.error));
            }
            return more;
        });
    }

   private:
    static constexpr double expected_share = 0.6;  // of the sampled bound in the sum over terms, usually

    struct Sharp {
        std::size_t curve = 0;
        double phase = 1e300;
    };
    struct State {
        double error = 0.0, relative = 1e300, peak = 0.0;
        std::size_t chords = 0, inner = 0;
        bool at_rounding = false;  // less than this error cannot be asked for
        Sharp far, near;  // of the whole disk and of the obscured one
    };

    void prepare(std::size_t p, ChordBound& outer, ChordBound& inner) const {
        outer.prepare(terms_, stack_.outer.data() + p * stack_.terms.size(), stack_.amplitude, box_);
        if (area_ > 0.0) {
            inner.prepare(terms_, stack_.inner.data() + p * stack_.terms.size(), inner_amplitude_,
                          box_.scaled(stack_.obscuration));
            inner.sharpen(states_[p].near.curve, states_[p].near.phase);
        }
        outer.sharpen(states_[p].far.curve, states_[p].far.phase);
    }

    // Roughly the vector operations for a vector of pupils, counted, not measured, as those of samples are.
    double work(std::size_t chords) const {
        const double n = static_cast<double>(chords), rows = static_cast<double>(rows_.at.size());
        return n * n * (45.0 + static_cast<double>(stack_.terms.size()) + 2.0 * rows) +
               2.0 * n * static_cast<double>(rows_.count * columns_.at.size());
    }

    // Bounds the phases of one disk by samples, on the curve that suits each, where that is worth its work; before that, of the
    // whole disk, the first error.
    void sharpen(const double* coefficients, double scale, Sharp State::* which) {
        std::vector<std::size_t> worth;
        const double samples = SharpTable::work(terms_), bright = stack_.amplitude.integral(stack_.obscuration);
        const Amplitude light = stack_.amplitude.scaled(scale * scale);
        const VBox box = box_.scaled(scale);
        ChordBound bound;
        const std::size_t terms = stack_.terms.size();
        for (std::size_t p = 0; p < stack_.count; ++p) {
            look();
            bound.prepare(terms_, coefficients + p * terms, light, box);
            double& error = states_[p].error;
            if (scale == 1.0) {
                check_phase(bound.size());
                // Most PSFs have sup|U| above this; where one has not, the error is tightened after that was found.
                error = ChordalBudget::field * tol_ * 0.5 * bright / std::sqrt(1.0 + bound.variance());
            }
            const std::size_t curve = bound.best_curve(error, expected_share), plain = bound.estimate(curve, error, 1.0);
            const double gain = work(plain) - work(bound.estimate(curve, error, expected_share));
            if (gain > 1.5 * samples) {
                (states_[p].*which).curve = curve;
                worth.push_back(p);
            }
        }
        std::sort(worth.begin(), worth.end(), [&](std::size_t a, std::size_t b) {
            const std::size_t i = (states_[a].*which).curve, j = (states_[b].*which).curve;
            return i != j ? i < j : a < b;
        });
        const std::size_t lanes = vector_lanes(), batches = (worth.size() + lanes - 1) / lanes;
        std::vector<std::shared_ptr<const SharpTable>> tables(batches);
        for (std::size_t b = 0; b < batches; ++b) {
            const std::size_t curve = (states_[worth[b * lanes]].*which).curve;
            const bool same = b > 0 && tables[b - 1]->b == chord_curves.b[curve];
            tables[b] = same ? tables[b - 1] : cache<SharpTable>.get(stack_.terms, chord_curves.b[curve]);
        }
        parallel_for(batches, threads_, [&](std::size_t, std::size_t b) {
            thread_local Doubles given, room;
            const std::size_t* pupils = worth.data() + b * lanes;
            const std::size_t here = std::min(lanes, worth.size() - b * lanes);
            const SharpTable& table = *tables[b];
            given.assign(2 * table.pairs.size() * lanes, 0.0);
            room.resize(2 * table.harmonics * lanes);
            for (std::size_t lane = 0; lane < here; ++lane) {
                sharp_lane(table, coefficients + pupils[lane] * terms, lane, lanes, given.data());
            }
            double found[row_lanes];
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { store(found, sharp_size(isa, table, given.data(), room.data())); });
            for (std::size_t lane = 0; lane < here; ++lane) {
                (states_[pupils[lane]].*which) = {(states_[pupils[0]].*which).curve, found[lane]};
            }
        });
    }

    static std::size_t vector_lanes() {
        std::size_t lanes = Portable::lanes;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { lanes = decltype(isa)::lanes; });
        return lanes;
    }

    std::shared_ptr<const KernelTable> kernel(std::size_t chords, double step) const {
        if (KernelTable::bytes(chords, rows_.at.size()) > max_table_bytes) {
            throw PhaseTooLarge("a window of " + std::to_string(rows_.count) + " rows and these phases take " +
                                std::to_string(chords) + " chords, whose tables exceed the limit of 256 MiB");
        }
        return cache<KernelTable>.get(chords, rows_, columns_, step);
    }

    struct Tables {
        std::shared_ptr<const TermTable> terms;
        std::shared_ptr<const KernelTable> kernel;
    };

    Tables tables(std::size_t chords, double scale) const {
        // The kernel first: it knows when there are too many chords.
        const auto k = kernel(chords, scale * step_);
        return {cache<TermTable>.get(chords, stack_.terms, stack_.amplitude.scaled(scale * scale)), k};
    }

    void dispatch_batches(const std::vector<std::size_t>& pending) {
        const std::size_t lanes = vector_lanes(), batches = (pending.size() + lanes - 1) / lanes;
        // Tables before threads, so that no thread waits for another to make them.
        std::vector<Tables> outer(batches), inner(batches);
        for (std::size_t b = 0; b < batches; ++b) {
            std::size_t chords = 0, within = 0;
            for (std::size_t i = b * lanes; i < std::min(pending.size(), (b + 1) * lanes); ++i) {
                chords = std::max(chords, states_[pending[i]].chords);
                within = std::max(within, states_[pending[i]].inner);
            }
            const bool same = b > 0 && outer[b - 1].terms->chords == chords;
            outer[b] = same ? outer[b - 1] : tables(chords, 1.0);
            if (area_ > 0.0) {
                const bool alike = b > 0 && inner[b - 1].terms->chords == within;
                inner[b] = alike ? inner[b - 1] : tables(within, stack_.obscuration);
            }
        }
        parallel_for(batches, threads_, [&](std::size_t, std::size_t b) {
            thread_local ChordalScratch scratch;
            const std::size_t first = b * lanes, here = std::min(lanes, pending.size() - first);
            dispatch([&](auto isa)
                         LOMMEL_INLINE_LAMBDA { batch(isa, pending.data() + first, here, outer[b], inner[b], scratch); });
        });
    }

    template <class I>
    LOMMEL_INLINE void gather(I, const double* coefficients, const std::size_t* pupils, std::size_t here,
                              const TermTable& table, ChordalScratch& scratch) const {
        const std::size_t terms = stack_.terms.size();
        scratch.coefficients.resize(terms * I::lanes);
        for (std::size_t j = 0; j < terms; ++j) {
            for (std::size_t lane = 0; lane < I::lanes; ++lane) {
                // Lanes without a pupil repeat the last one.
                const std::size_t p = pupils[std::min(lane, here - 1)];
                scratch.coefficients[j * I::lanes + lane] = coefficients[p * terms + table.order[j]];
            }
        }
    }

    template <class I>
    LOMMEL_INLINE void batch(I isa, const std::size_t* pupils, std::size_t here, const Tables& outer, const Tables& inner,
                             ChordalScratch& scratch) {
        using V = typename I::pack;
        constexpr std::size_t lanes = I::lanes;
        const std::size_t width = columns_.count, pixels = rows_.count * width;
        if (area_ > 0.0) {
            scratch.inner.resize(pixels * 2 * lanes);
            double* kept = scratch.inner.data();
            gather(isa, stack_.inner.data(), pupils, here, *inner.terms, scratch);
            chordal_fields(isa, *inner.terms, *inner.kernel, scratch, [&](std::size_t y, const double* u) LOMMEL_INLINE_LAMBDA {
                for (std::size_t j = 0; j < 2 * width * lanes; j += lanes) {
                    store(kept + 2 * y * width * lanes + j, load<V>(u + j) * splat<V>(area_));
                }
            });
        }
        double scale[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double given = answer_.scales[pupils[std::min(lane, here - 1)]];
            scale[lane] = given == 0.0 ? 1.0 : given;
        }
        scratch.intensity.resize(width * lanes);
        double* intensity = scratch.intensity.data();
        V top = splat<V>(0.0);
        gather(isa, stack_.outer.data(), pupils, here, *outer.terms, scratch);
        chordal_fields(isa, *outer.terms, *outer.kernel, scratch, [&](std::size_t y, const double* u) LOMMEL_INLINE_LAMBDA {
            const double* less = area_ > 0.0 ? scratch.inner.data() + 2 * y * width * lanes : nullptr;
            for (std::size_t x = 0; x < width; ++x) {
                V re = load<V>(u + 2 * x * lanes), im = load<V>(u + (2 * x + 1) * lanes);
                if (less != nullptr) {
                    re = re - load<V>(less + 2 * x * lanes);
                    im = im - load<V>(less + (2 * x + 1) * lanes);
                }
                const V i = re * re + im * im;
                top = larger(top, i);
                store(intensity + x * lanes, i);
            }
            for (std::size_t lane = 0; lane < here; ++lane) {
                T* to = answer_.images + pupils[lane] * pixels + y * width;
                const double by = scale[lane];
                for (std::size_t x = 0; x < width; ++x) {
                    to[x] = static_cast<T>(by * intensity[x * lanes + lane]);
                }
            }
        });
        double peaks[lanes];
        store(peaks, top);
        thread_local ChordBound far, near;
        for (std::size_t lane = 0; lane < here; ++lane) {
            finish(pupils[lane], peaks[lane], outer, inner, far, near);
        }
    }

    void finish(std::size_t p, double peak, const Tables& outer, const Tables& inner, ChordBound& far, ChordBound& near) {
        State& s = states_[p];
        prepare(p, far, near);
        double error = stack_.lost[p] + far.bound(outer.terms->chords) + far.rounding(outer.terms->chords);
        if (area_ > 0.0) {
            error += area_ * (near.bound(inner.terms->chords) + near.rounding(inner.terms->chords));
        }
        s.peak = peak;
        const bool divide = answer_.scales[p] == 0.0;
        s.relative = finished_error<T>(relative_error(peak, error), divide, true);
        if (!(s.relative <= tol_)) {
            return;
        }
        answer_.bounds[p] = s.relative;
        answer_.peaks[p] = peak;
        if (divide) {
            const std::size_t pixels = rows_.count * columns_.count;
            T* image = answer_.images + p * pixels;
            store_scaled(image, answer_.scales[p] = 1.0 / peak, pixels, image);
        }
    }

    const DiskStack& stack_;
    WindowAxis rows_, columns_;
    double step_, tol_;
    int threads_;
    DiskAnswer<T> answer_;
    TermPairs terms_;
    VBox box_;
    double area_;
    Amplitude inner_amplitude_;
    std::vector<State> states_;
};

}  // namespace lommel
