// Zernike polynomials Z at pupil nodes, for derivatives dP/dc = i Z P of the pupil function P by the Zernike coefficient c.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Table of Zernike terms at the nodes of the quadrant x, y > 0.
struct FactorTable {
    ChordCount count;
    std::vector<ZernikeTerm> terms;
    double radius;  // radius of the disk (aperture or obscuration) / radius of the aperture
    TermClasses classes;
    Doubles values;  // Zernike terms, [index in classes.order][chord][node]

    FactorTable(const ChordCount& n, const std::vector<ZernikeTerm>& list, double over)
        : count(n), terms(list), radius(over), classes(list), values(n.half_chords() * n.half_nodes() * list.size()) {
        const ChordRule rule(n);
        const ZernikeValues polynomials(list, classes.order);
        for (std::size_t i = 0, node = 0; i < rule.x.size(); ++i) {
            look();
            for (const wide eta : rule.eta) {
                polynomials.at(radius * rule.x[i], radius * rule.s[i] * eta, [&](std::size_t j, wide value) {
                    values[j * n.half_chords() * n.half_nodes() + node] = static_cast<double>(value);
                });
                ++node;
            }
        }
    }
    bool is(const ChordCount& n, const std::vector<ZernikeTerm>& list, double over) const {
        return count == n && radius == over && terms == list;
    }
    // Values of one Zernike term at the nodes of chord number `chord`. term: index in classes.order.
    const double* at(std::size_t term, std::size_t chord) const {
        return values.data() + (term * count.half_chords() + chord) * count.half_nodes();
    }
    std::size_t bytes() const { return values.size() * sizeof(double); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
};

// Products (pupil function) x (Zernike term), each in a lane of its own, for `here` pupils and `count` terms (of
// table.classes.order, from index `first` on). lanes: number of lanes of a vector.
struct FactorLanes {
    const FactorTable& table;
    std::size_t here, lanes, first, count;

    FactorLanes(const FactorTable& factors, std::size_t pupils, std::size_t all, std::size_t from)
        : table(factors), here(pupils), lanes(all), first(from), count(std::min(all / pupils, factors.terms.size() - from)) {}

    std::size_t used() const { return count * here; }
    std::size_t term(std::size_t lane) const { return first + lane / here; }  // index in table.classes.order
    std::size_t parity(std::size_t at) const {
        std::size_t parity = 0;
        while (at >= table.classes.ends[parity]) {
            ++parity;
        }
        return parity;
    }
};

// Multiply the pupil function at a pair of chords (`nodes`) by the Zernike term of each lane; write the product to `to`. In x and
// in y, the parity of the product is the sum of the factors' parities modulo 2. room: working memory for the Zernike terms,
// [parity][node][lane], set to 0 by the caller before the first chord.
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
    // For each of the four parities, `room` has one factor per lane: 0 (set by the caller) if the lane's term has another parity.
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

// Derivatives -2 Im(conj(u) d) of the intensity along a row, written to `values`. u: complex amplitude; d: Fourier transform of
// pupil function times Zernike term; top: running maximum of |d|^2 in each vector lane.
template <class I, class Real>
LOMMEL_INLINE void slopes_of_row(I, const Real* u, const Real* d, std::size_t columns, Real* values, Real* top) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    V most = load<V>(top);
    for (std::size_t x = 0; x < columns; ++x, u += 2 * lanes, d += 2 * lanes) {
        const V re = load<V>(d), im = load<V>(d + lanes);
        const V half = load<V>(u + lanes) * re - load<V>(u) * im;
        most = larger(most, re * re + im * im);
        store(values + x * lanes, half + half);
    }
    store(top, most);
}

}  // namespace lommel
