// Derivatives of images by the coefficients of Zernike terms: of |U|^2 by that of Z it is -2 Im(conj(U) D), D the field of Z P.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/bounds/chords.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/question.hpp"

namespace lommel {

// Terms and pupils in the lanes of a vector: as many terms, in the order of their classes, as a batch leaves room for.
struct FactorLanes {
    const FactorTable& table;
    std::size_t here, lanes, first, count;

    FactorLanes(const FactorTable& factors, std::size_t pupils, std::size_t all, std::size_t from)
        : table(factors), here(pupils), lanes(all), first(from), count(std::min(all / pupils, factors.terms.size() - from)) {}

    std::size_t used() const { return count * here; }
    std::size_t term(std::size_t lane) const { return first + lane / here; }  // in the order of classes
    std::size_t parity(std::size_t at) const {
        std::size_t parity = 0;
        while (at >= table.classes.ends[parity]) {
            ++parity;
        }
        return parity;
    }
};

// Nodes of a pair of chords times a term in each lane: to which of the parts even and odd in x and y a term takes another is told
// by its class.
template <class I, class Real>
LOMMEL_INLINE void times_factors(I, const FactorLanes& given, std::size_t chord, const Real* nodes, Real* room, Real* to) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t within = given.table.count.half_nodes(), odd = within * 4 * lanes;
    const auto part = [&](std::size_t k, std::size_t y, std::size_t x) { return y * odd + (4 * k + 2 * x) * lanes; };
    if (given.count == 1) {
        const double* factor = given.table.at(given.first, chord);
        const std::size_t parity = given.parity(given.first), odd_x = parity / 2, odd_y = parity % 2;
        for (std::size_t k = 0; k < within; ++k) {
            const V z = splat<V>(static_cast<Real>(factor[k]));
            for (std::size_t y = 0; y < 2; ++y) {
                for (std::size_t x = 0; x < 2; ++x) {
                    const Real* from = nodes + part(k, y ^ odd_y, x ^ odd_x);
                    Real* at = to + part(k, y, x);
                    store(at, load<V>(from) * z);
                    store(at + lanes, load<V>(from + lanes) * z);
                }
            }
        }
        return;
    }
    // Lanes of other classes have the factor 0, set once for all chords.
    bool used[4] = {};
    for (std::size_t lane = 0; lane < given.used(); ++lane) {
        const std::size_t term = given.term(lane), parity = given.parity(term);
        const double* factor = given.table.at(term, chord);
        used[parity] = true;
        for (std::size_t k = 0; k < within; ++k) {
            room[(parity * within + k) * lanes + lane] = static_cast<Real>(factor[k]);
        }
    }
    for (std::size_t k = 0; k < within; ++k) {
        V sums[4][2] = {};
        for (std::size_t parity = 0; parity < 4; ++parity) {
            if (used[parity]) {
                const V z = load<V>(room + (parity * within + k) * lanes);
                for (std::size_t j = 0; j < 4; ++j) {
                    const Real* from = nodes + part(k, j / 2 ^ parity % 2, j % 2 ^ parity / 2);
                    sums[j][0] = sums[j][0] + z * load<V>(from);
                    sums[j][1] = sums[j][1] + z * load<V>(from + lanes);
                }
            }
        }
        for (std::size_t j = 0; j < 4; ++j) {
            Real* at = to + part(k, j / 2, j % 2);
            store(at, sums[j][0]);
            store(at + lanes, sums[j][1]);
        }
    }
}

// What images alone are followed by.
struct NoDerivatives {
    static constexpr bool wanted = false, keeps_nodes = false;
    std::vector<ZernikeTerm> terms;
};

inline std::size_t highest_degree(const std::vector<ZernikeTerm>& terms) {
    std::size_t degree = 0;
    for (const ZernikeTerm& term : terms) {
        degree = std::max(degree, static_cast<std::size_t>(term.n));
    }
    return degree;
}

// [term][pupil]: derivatives of the intensity, scaled as images are, and bounds on their error over the peak.
template <class T>
struct ChordalDerivatives {
    static constexpr bool wanted = true, keeps_nodes = true;
    std::vector<ZernikeTerm> terms;
    T* images;
    double* bounds;

    // Of a batch whose U at each pixel and nodes are kept. scales[lane]; found(pupil, degree) is the root of the peak that was
    // found, with bounds on the errors of U and of D for terms of that degree.
    template <class I, class Real, class Found>
    LOMMEL_INLINE void follow(I isa, const ChordalBatch<Real>& batch, const double* scales, const Found& found) const {
        using V = typename Waves<I, Real>::V;
        constexpr std::size_t lanes = Waves<I, Real>::lanes;
        const std::size_t width = batch.columns(), pixels = batch.rows() * width;
        ChordalScratch<Real>& scratch = batch.scratch;
        for (std::size_t first = 0; first < terms.size();) {
            const auto given = [&](std::size_t disk) LOMMEL_INLINE_LAMBDA {
                return FactorLanes(*batch.disks[disk].factors, batch.here, lanes, first);
            };
            const auto prepare = [&](std::size_t disk) LOMMEL_INLINE_LAMBDA {
                const std::size_t room = batch.disks[disk].kernel->count.half_nodes() * lanes;
                scratch.factors.assign(4 * room, Real(0));
                scratch.factored.resize(8 * room);
            };
            const auto nodes = [&](std::size_t disk, std::size_t i) LOMMEL_INLINE_LAMBDA {
                const Real* from = scratch.kept[disk].data() + i * batch.disks[disk].kernel->count.half_nodes() * 8 * lanes;
                times_factors(isa, given(disk), i, from, scratch.factors.data(), scratch.factored.data());
                return scratch.factored.data();
            };
            const FactorLanes outer = given(0);
            Real* values = scratch.intensity.data();
            V top = splat<V>(Real(0));
            aperture_fields(isa, batch, prepare, nodes, [&](std::size_t y, const Real* d) LOMMEL_INLINE_LAMBDA {
                const Real* u = scratch.fields.data() + y * width * 2 * lanes;
                for (std::size_t x = 0; x < width; ++x, u += 2 * lanes, d += 2 * lanes) {
                    const V re = load<V>(d), im = load<V>(d + lanes);
                    const V half = load<V>(u + lanes) * re - load<V>(u) * im;
                    top = larger(top, re * re + im * im);
                    store(values + x * lanes, half + half);
                }
                for (std::size_t lane = 0; lane < outer.used(); ++lane) {
                    const std::size_t p = lane % batch.here, k = outer.table.classes.order[outer.term(lane)];
                    T* to = images + (k * batch.stack.count + batch.pupils[p]) * pixels + y * width;
                    for (std::size_t x = 0; x < width; ++x) {
                        to[x] = static_cast<T>(scales[p] * static_cast<double>(values[x * lanes + lane]));
                    }
                }
            });
            Real tops[lanes];
            store(tops, top);
            for (std::size_t lane = 0; lane < outer.used(); ++lane) {
                const std::size_t p = batch.pupils[lane % batch.here], k = outer.table.classes.order[outer.term(lane)];
                const auto [u, error, wrong] = found(p, static_cast<std::size_t>(terms[k].n));
                const double d = std::sqrt(static_cast<double>(tops[lane]));
                // Two products and their difference, doubled; and storing.
                const double rounding = storing<T>(false) + (sizeof(Real) == 4 ? 2.0 * single_roundoff : 0.0);
                bounds[k * batch.stack.count + p] =
                    2.0 * over_peak(u * wrong + d * error + wrong * error + u * d * rounding, u * u, error);
            }
            first += outer.count;
        }
    }
};

}  // namespace lommel
