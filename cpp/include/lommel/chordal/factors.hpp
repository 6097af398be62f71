// Zernike terms at the nodes, by whose coefficients derivatives are taken: the derivative of P by the coefficient of Z is i Z P.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

struct FactorTable {
    ChordCount count;
    std::vector<ZernikeTerm> terms;
    double radius;  // of the disk, over that on which terms are 1 at the edge
    TermClasses classes;
    Doubles values;  // [term, in the order of classes][chord][node]

    FactorTable(const ChordCount& n, const std::vector<ZernikeTerm>& list, double over)
        : count(n), terms(list), radius(over), classes(list), values(n.half_chords() * n.half_nodes() * list.size()) {
        const ChordRule rule(n);
        double* to = values.data();
        for (const std::size_t j : classes.order) {
            for (std::size_t i = 0; i < rule.x.size(); ++i) {
                look();
                for (const wide eta : rule.eta) {
                    *to++ = static_cast<double>(zernike_value(list[j], radius * rule.x[i], radius * rule.s[i] * eta));
                }
            }
        }
    }
    bool is(const ChordCount& n, const std::vector<ZernikeTerm>& list, double over) const {
        return count == n && radius == over && terms == list;
    }
    // Of a term, in the order of classes, on a pair of chords.
    const double* at(std::size_t term, std::size_t chord) const {
        return values.data() + (term * count.half_chords() + chord) * count.half_nodes();
    }
    std::size_t bytes() const { return values.size() * sizeof(double); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
};

}  // namespace lommel
