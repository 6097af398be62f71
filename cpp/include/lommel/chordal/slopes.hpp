// Images and their derivatives by the coefficients of Zernike terms: dI/dc = 2 Re(conj(U) D), D the field of i Z times the pupil
// function. Its waves are computed once; each term takes one more transform.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "lommel/chordal/images.hpp"

namespace lommel {

// Where derivatives go.
template <class T>
struct SlopeAnswer {
    T* images;  // [term][pupil][height][width], times what the intensity was multiplied by
    double* bounds;  // [term][pupil], over the peak of the intensity
};

// The waves of all chords, of the disk and the obscured one, in memory.
template <class Real>
struct KeptWaves {
    typename ChordalScratch<Real>::Values values;

    template <class I>
    LOMMEL_INLINE void fill(I isa, const TermTable& table, const Doubles& coefficients) {
        const std::size_t size = chord_values(table.count, Waves<I, Real>::lanes);
        values.resize(table.count.half_chords() * size);
        for (std::size_t chord = 0; chord < table.count.half_chords(); ++chord) {
            look();
            pair_of_chords(isa, table, chord, coefficients.data(), values.data() + chord * size);
        }
    }
};

// i Z times the waves of a pair of chords.
template <class I, class Real>
LOMMEL_INLINE void multiply_waves(I, const Parity& parity, const double* z, std::size_t within, const Real* waves, Real* out) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    for (std::size_t odd_y = 0; odd_y < 2; ++odd_y) {
        for (std::size_t k = 0; k < within; ++k) {
            const V by = splat<V>(static_cast<Real>(z[k])), less = splat<V>(static_cast<Real>(-z[k]));
            for (std::size_t odd_x = 0; odd_x < 2; ++odd_x, out += 2 * lanes) {
                const Real* from = waves + parity.source(odd_y, k, odd_x, within) * lanes;
                store(out, less * load<V>(from + lanes));
                store(out + lanes, by * load<V>(from));
            }
        }
    }
}

template <class T>
class ChordalSlopes : private ChordalRenderer<T> {
    using Base = ChordalRenderer<T>;
    template <class Real>
    using Tables = ChordalCall::Tables<Real>;

   public:
    ChordalSlopes(const DiskStack& stack, const DiskWindow& window, double tol, int threads, const DiskAnswer<T>& answer,
                  const std::vector<ZernikeTerm>& factors, const SlopeAnswer<T>& slopes)
        : Base(stack, window, tol, threads, answer, factors), slopes_(slopes) {}

    void run() {
        Base::run();
        std::vector<std::size_t> pupils(this->stack_.count);
        std::iota(pupils.begin(), pupils.end(), std::size_t{0});
        for (const std::size_t p : pupils) {
            this->choose(p, this->states_[p].error, steepest(this->factors_));
        }
        const std::size_t singles = this->sort(pupils);
        render<float>(pupils.data(), singles);
        render<double>(pupils.data() + singles, pupils.size() - singles);
    }

   private:
    template <class Real>
    struct Scratch {
        ChordalScratch<Real> transform;
        KeptWaves<Real> waves[2];
        typename ChordalScratch<Real>::Values field;  // U at the pixels
    };

    template <class Real>
    void render(const std::size_t* pupils, std::size_t count) {
        this->template for_batches<Real>(pupils, count,
                                         [&](auto isa, const std::size_t* some, std::size_t here, const Tables<Real>& outer,
                                             const Tables<Real>& inner) LOMMEL_INLINE_LAMBDA {
                                             thread_local Scratch<Real> scratch;
                                             batch(isa, some, here, outer, inner, scratch);
                                         });
    }

    // First U, then the field of each factor.
    template <class I, class Real>
    LOMMEL_INLINE void batch(I isa, const std::size_t* pupils, std::size_t here, const Tables<Real>& outer,
                             const Tables<Real>& inner, Scratch<Real>& scratch) {
        using V = typename Waves<I, Real>::V;
        constexpr std::size_t lanes = Waves<I, Real>::lanes;
        const std::size_t width = this->columns_.count, pixels = this->rows_.count * width;
        ChordalScratch<Real>& transform = scratch.transform;
        this->template gather<I, Real>(isa, this->stack_.outer, pupils, here, *outer.terms, transform.coefficients[0]);
        scratch.waves[0].fill(isa, *outer.terms, transform.coefficients[0]);
        if (this->area_ > 0.0) {
            this->template gather<I, Real>(isa, this->stack_.inner, pupils, here, *inner.terms, transform.coefficients[1]);
            scratch.waves[1].fill(isa, *inner.terms, transform.coefficients[1]);
        }
        scratch.field.resize(pixels * 2 * lanes);
        transform.intensity.resize(width * lanes);
        Real *field = scratch.field.data(), *slopes = transform.intensity.data();
        for (std::size_t f = 0; f <= this->factors_.size(); ++f) {
            const auto waves = [&](const Tables<Real>& tables, const KeptWaves<Real>& kept) LOMMEL_INLINE_LAMBDA {
                return [&](std::size_t chord) LOMMEL_INLINE_LAMBDA {
                    const ChordCount& count = tables.terms->count;
                    const std::size_t size = chord_values(count, lanes);
                    const Real* own = kept.values.data() + chord * size;
                    if (f == 0) {
                        return own;
                    }
                    transform.nodes.resize(size);
                    multiply_waves(isa, Parity(this->factors_[f - 1]), tables.factors->at(f - 1, chord), count.half_nodes(),
                                   own, transform.nodes.data());
                    return static_cast<const Real*>(transform.nodes.data());
                };
            };
            V top = splat<V>(Real(0));
            this->fields(
                isa, outer, inner, transform, waves(outer, scratch.waves[0]), waves(inner, scratch.waves[1]),
                [&](std::size_t y, std::size_t x, V re, V im) LOMMEL_INLINE_LAMBDA {
                    Real* u = field + 2 * (y * width + x) * lanes;
                    if (f == 0) {
                        store(u, re);
                        store(u + lanes, im);
                        return;
                    }
                    top = larger(top, re * re + im * im);
                    const V half = load<V>(u) * re + load<V>(u + lanes) * im;
                    store(slopes + x * lanes, half + half);
                },
                [&](std::size_t y) LOMMEL_INLINE_LAMBDA {
                    for (std::size_t lane = 0; f > 0 && lane < here; ++lane) {
                        const std::size_t place = (f - 1) * this->stack_.count + pupils[lane];
                        T* to = slopes_.images + place * pixels + y * width;
                        const double by = this->answer_.scales[pupils[lane]];
                        for (std::size_t x = 0; x < width; ++x) {
                            to[x] = static_cast<T>(by * static_cast<double>(slopes[x * lanes + lane]));
                        }
                    }
                });
            Real tops[lanes];
            store(tops, top);
            for (std::size_t lane = 0; f > 0 && lane < here; ++lane) {
                finish(pupils[lane], f - 1, std::sqrt(static_cast<double>(tops[lane])), outer, inner);
            }
        }
    }

    // |dI/dc| <= 2 |U| |D|, over the exact peak.
    template <class Real>
    void finish(std::size_t p, std::size_t f, double size, const Tables<Real>& outer, const Tables<Real>& inner) {
        const double peak = this->states_[p].peak, off = this->off(p, outer, inner),
                     wrong = this->off(p, outer, inner, Factor{static_cast<std::size_t>(this->factors_[f].n)}),
                     bright = std::sqrt(peak) + off, most = size + wrong,
                     products = 4.0 * (sizeof(Real) == sizeof(float) ? single_roundoff : unit_roundoff);
        slopes_.bounds[f * this->stack_.count + p] =
            2.0 * over_peak(bright * wrong + most * off + bright * most * (storing<T>(false) + products), peak, off);
    }

    SlopeAnswer<T> slopes_;
};

}  // namespace lommel
