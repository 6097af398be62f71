// Legendre series of the pupil function on a disk: numbers of terms and nodes, coefficients, and error bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <tuple>

#include "lommel/bounds/ellipse.hpp"
#include "lommel/radial/series.hpp"
#include "lommel/radial/stack.hpp"

namespace lommel {

// Numbers of terms and quadrature nodes of a Legendre series, for a given error of the field U up to the distance `reach`.
struct Expansion {
    std::size_t terms = 0;
    std::shared_ptr<const LegendreRule> rule;
    double truncation = 0.0, quadrature = 0.0;

    Expansion() = default;
    Expansion(const Ellipses& ellipses, double reach, double error) {
        check_reach(reach);
        const double left = RadialBudget::truncation * error;
        std::tie(terms, truncation) = ellipses.terms(left);
        // Use the number of terms that suffices up to the largest distance, `reach`, if it is less than the number for the phase.
        if (terms > 1 && window_tail(terms - 1, reach) <= left) {
            terms = window_terms(reach, left);
            truncation = window_tail(terms, reach);
        }
        const std::size_t nodes = ellipses.nodes(terms, RadialBudget::quadrature * error);
        if (nodes > max_terms) {
            throw LimitExceeded("aberrations this large take a series of " + std::to_string(nodes) +
                                " nodes, more than the limit of " + std::to_string(max_terms) +
                                "; Geometric, which leaves diffraction out, has none");
        }
        rule = LegendreRule::get(nodes, terms);
        quadrature = ellipses.quadrature(2 * rule->half, terms);
    }

    std::size_t room() const { return rule->blocks * 2 * row_lanes; }

    // Error bound of the field U. Rounding of the pupil function at the nodes is not amplified (Parseval, twice). Rounding of
    // sums over half the nodes, in two chains, is multiplied by sqrt(terms) (docs/certificate.md, section 4).
    double error(const Phase& phase) const {
        const double rounding = phase.sensitivity() + 8.0 +
                                std::sqrt(static_cast<double>(terms)) *
                                    (0.5 * static_cast<double>(rule->half) + 16.0 + rule_rounding(2 * rule->half));
        return truncation + quadrature + unit_roundoff * rounding;
    }
};

// Error of the field U(v) from six roundings of v: |U'| <= 1/2 and, as |J_1(x)| <= 0.826 / sqrt(x), |U'| <= 0.661 / sqrt(v).
inline double radius_rounding(double v) { return 6.0 * unit_roundoff * std::min(0.5 * v, 0.661 * std::sqrt(v)); }

// Rounding error of a Legendre series at one radius: the moduli of its terms sum to at most 1 (Cauchy and Parseval).
inline double series_rounding(std::size_t terms) { return unit_roundoff * (static_cast<double>(terms) + 16.0); }

// Legendre coefficients (re, im) of t^power times the pupil function on a full disk, t the squared radius.
struct Disk {
    Doubles re, im;
    std::size_t terms = 0;

    // Compute the coefficients for a requested error of the field U up to the distance `reach`; returns its bound, with rounding.
    double expand(const Phase& phase, std::size_t power, double reach, double error, SeriesScratch& scratch) {
        check_phase(phase.size());
        const Expansion plan(Ellipses(phase.coefficients, phase.terms, *phase.amplitude, power), reach, error);
        terms = plan.terms;
        if (re.size() < plan.room()) {
            re.resize(plan.room());
            im.resize(plan.room());
        }
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            legendre_coefficients(isa, *plan.rule, phase.coefficients, phase.terms, *phase.amplitude, power, terms, re.data(),
                                  im.data(), scratch);
        });
        return plan.error(phase);
    }

    // Add the constant `angle` to the phase.
    void turn(double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t n = 0; n < terms; ++n) {
            const double a = re[n], b = im[n];
            re[n] = c * a - s * b;
            im[n] = s * a + c * b;
        }
    }
};

}  // namespace lommel
