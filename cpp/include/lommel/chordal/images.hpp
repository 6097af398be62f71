// From any wavefronts to finished small images, each with its proven error, by the chordal Gauss rule on the disk.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "lommel/bounds/settle.hpp"
#include "lommel/chordal/call.hpp"
#include "lommel/pixels/render.hpp"

namespace lommel {

template <class T>
class ChordalRenderer : protected ChordalCall {
   public:
    ChordalRenderer(const DiskStack& stack, const DiskWindow& window, double tol, int threads, const DiskAnswer<T>& answer,
                    std::vector<ZernikeTerm> factors = {})
        : ChordalCall(stack, window, tol, threads, sizeof(T) == sizeof(float), std::move(factors)), answer_(answer) {}

    void run() {
        begin();
        std::vector<std::size_t> pending(stack_.count);
        std::iota(pending.begin(), pending.end(), std::size_t{0});
        const auto attempt = [&] {
            for (const std::size_t p : pending) {
                look();
                State& s = states_[p];
                const double rounding = s.far.rounding + stack_.lost[p];
                s.at_rounding = s.error < rounding;
                s.error = std::max(s.error, rounding);
                const double error = s.single ? singly(p) : s.error;
                choose(p, error);
            }
            const std::size_t singles = sort(pending);
            render<float>(pending.data(), singles);
            render<double>(pending.data() + singles, pending.size() - singles);
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
                const double wanted = ChordalBudget::field * tol_ * std::sqrt(s.peak);
                // Double precision alone may do.
                s.error = std::min((s.single ? 1.0 : ChordalBudget::again) * s.error,
                                   std::max(wanted, ChordalBudget::least * s.error));
                s.single = false;
                const std::size_t from = p * stack_.terms.size();
                ChordLines::renew(outer, stack_.outer.data() + from, s.error, s.far);
                if (area_ > 0.0) {
                    ChordLines::renew(inner, stack_.inner.data() + from, s.error, s.near);
                }
            }
            return more;
        });
    }

   protected:
    DiskAnswer<T> answer_;

   private:
    // The error to ask for where sums are in single precision; or in double precision, if that leaves too little.
    double singly(std::size_t p) {
        State& s = states_[p];
        const double chords = s.far.chords.line.needed(s.error), nodes = s.far.nodes.line.needed(s.error);
        const double rounding = (1.0 + area_) * ChordBound::single_rounding(chords, nodes, stack_.terms.size());
        const double all = s.error * (ChordalBudget::single / ChordalBudget::field) * (answer_.scales[p] == 0.0 ? 0.5 : 1.0);
        s.single = rounding <= ChordalBudget::rounding * all;
        return s.single ? std::min(s.error, all - rounding) : s.error;
    }

    template <class Real>
    void render(const std::size_t* pupils, std::size_t count) {
        for_batches<Real>(pupils, count,
                          [&](auto isa, const std::size_t* some, std::size_t here, const Tables<Real>& outer,
                              const Tables<Real>& inner) LOMMEL_INLINE_LAMBDA {
                              thread_local ChordalScratch<Real> scratch;
                              batch(isa, some, here, outer, inner, scratch);
                          });
    }

    template <class I, class Real>
    LOMMEL_INLINE void batch(I isa, const std::size_t* pupils, std::size_t here, const Tables<Real>& outer,
                             const Tables<Real>& inner, ChordalScratch<Real>& scratch) {
        using V = typename Waves<I, Real>::V;
        constexpr std::size_t lanes = Waves<I, Real>::lanes;
        const std::size_t width = columns_.count, pixels = rows_.count * width;
        double scale[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double given = answer_.scales[pupils[std::min(lane, here - 1)]];
            scale[lane] = given == 0.0 ? 1.0 : given;
        }
        gather<I, Real>(isa, stack_.outer, pupils, here, *outer.terms, scratch.coefficients[0]);
        if (area_ > 0.0) {
            gather<I, Real>(isa, stack_.inner, pupils, here, *inner.terms, scratch.coefficients[1]);
        }
        const auto waves = [&](const TermTable* table, const Doubles& coefficients) LOMMEL_INLINE_LAMBDA {
            return [&, table](std::size_t chord) LOMMEL_INLINE_LAMBDA {
                scratch.nodes.resize(chord_values(table->count, lanes));
                pair_of_chords(isa, *table, chord, coefficients.data(), scratch.nodes.data());
                return static_cast<const Real*>(scratch.nodes.data());
            };
        };
        scratch.intensity.resize(width * lanes);
        Real* intensity = scratch.intensity.data();
        V top = splat<V>(Real(0));
        fields(
            isa, outer, inner, scratch, waves(outer.terms.get(), scratch.coefficients[0]),
            waves(inner.terms.get(), scratch.coefficients[1]),
            [&](std::size_t, std::size_t x, V re, V im) LOMMEL_INLINE_LAMBDA {
                const V i = re * re + im * im;
                top = larger(top, i);
                store(intensity + x * lanes, i);
            },
            [&](std::size_t y) LOMMEL_INLINE_LAMBDA {
                for (std::size_t lane = 0; lane < here; ++lane) {
                    T* to = answer_.images + pupils[lane] * pixels + y * width;
                    const double by = scale[lane];
                    for (std::size_t x = 0; x < width; ++x) {
                        to[x] = static_cast<T>(by * static_cast<double>(intensity[x * lanes + lane]));
                    }
                }
            });
        Real peaks[lanes];
        store(peaks, top);
        for (std::size_t lane = 0; lane < here; ++lane) {
            finish<Real>(pupils[lane], static_cast<double>(peaks[lane]), outer, inner);
        }
    }

    template <class Real>
    void finish(std::size_t p, double peak, const Tables<Real>& outer, const Tables<Real>& inner) {
        State& s = states_[p];
        const double error = off(p, outer, inner);
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
};

}  // namespace lommel
