// Derivatives by the coefficients of Zernike terms: the field of a pupil function times i Z, for terms Z.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <vector>

#include "lommel/base/wide.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

constexpr double single_roundoff = 5.9604644775390625e-08;

// What a factor Z of a degree does to bounds; derived in docs/certificate.md.
struct Factor {
    std::size_t degree = 0;  // 0: there is none

    // A real trigonometric polynomial of degree n that is at most 1 is at most cosh(n b) on a curve.
    double growth(std::size_t curve) const {
        return std::cosh(std::min(600.0, static_cast<double>(degree) * chord_curves.b[curve]));
    }
    // Its own rounding and that of the product, which in single precision the kernel counts twice; and that of the node, where
    // tables are made in double.
    double rounding(bool single) const {
        if (degree == 0) {
            return 0.0;
        }
        const double n = static_cast<double>(degree);
        return unit_roundoff * (6.0 + n + (wider ? 0.0 : 3.0 * n * n)) + (single ? 4.0 * single_roundoff : 0.0);
    }
};

// The highest degree of some terms.
inline Factor steepest(const std::vector<ZernikeTerm>& terms) {
    Factor most;
    for (const ZernikeTerm& term : terms) {
        most.degree = std::max(most.degree, static_cast<std::size_t>(term.n));
    }
    return most;
}

// Some terms at the nodes of a quadrant of the disk of a radius: [term][chord][node].
struct FactorTable {
    ChordCount count;
    std::vector<ZernikeTerm> terms;
    double radius;
    Doubles values;

    FactorTable(const ChordCount& n, const std::vector<ZernikeTerm>& list, double scale)
        : count(n), terms(list), radius(scale), values(list.size() * n.half_chords() * n.half_nodes()) {
        const ChordRule rule(n);
        double* to = values.data();
        for (const ZernikeTerm& term : list) {
            for (std::size_t i = 0; i < n.half_chords(); ++i) {
                look();
                for (std::size_t k = 0; k < n.half_nodes(); ++k) {
                    const wide x = static_cast<wide>(scale) * rule.x[i], y = static_cast<wide>(scale) * rule.s[i] * rule.eta[k];
                    *to++ = static_cast<double>(zernike_value(term, x, y));
                }
            }
        }
    }
    const double* at(std::size_t term, std::size_t chord) const {
        return values.data() + (term * count.half_chords() + chord) * count.half_nodes();
    }
    bool is(const ChordCount& n, const std::vector<ZernikeTerm>& list, double scale) const {
        return count == n && radius == scale && terms == list;
    }
    std::size_t bytes() const { return values.size() * sizeof(double); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
};

// Whether a term is odd in x, in y.
struct Parity {
    std::size_t x, y;
    explicit Parity(const ZernikeTerm& term)
        : x((static_cast<std::size_t>(std::abs(term.m)) + (term.m < 0 ? 1 : 0)) % 2), y(term.m < 0 ? 1 : 0) {}
    // Where in the values of a pair of chords the parts are that make those of (odd in y, node, odd in x) when multiplied.
    std::size_t source(std::size_t odd_y, std::size_t node, std::size_t odd_x, std::size_t within) const {
        return ((odd_y ^ y) * within + node) * 4 + (odd_x ^ x) * 2;
    }
};

}  // namespace lommel
