// How many nodes the chordal Gauss rule takes, and what is proven about its error; derived in docs/certificate.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "lommel/base/wide.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/question.hpp"

namespace lommel {

constexpr std::size_t max_chords = 1024;  // chords of the disk, and nodes on each

// Numbers of chords in use: few, so that tables are shared, and even, so that all nodes come in quadruples.
inline std::size_t rounded_chords(double wanted) {
    const std::size_t n = static_cast<std::size_t>(std::max(8.0, std::ceil(wanted)));
    const std::size_t step = n <= 64 ? 2 : n <= 128 ? 4 : n <= 256 ? 8 : n <= 512 ? 16 : 32;
    return (n + step - 1) / step * step;
}

// The window in v: its corners.
struct VBox {
    double left, right, top, bottom;
    VBox scaled(double by) const { return {by * left, by * right, by * top, by * bottom}; }
    // Largest distance from (x, y).
    double reach(double x, double y) const {
        return std::hypot(std::max(std::abs(left - x), std::abs(right - x)), std::max(std::abs(top - y), std::abs(bottom - y)));
    }
};

// One disk with its phase and its window: a bound on the logarithm of the integrand on each curve.
class ChordBound {
   public:
    void prepare(const TermPairs& terms, const double* coefficients, const Amplitude& light, const VBox& window) {
        terms_ = &terms;
        double tilt_x = 0.0, tilt_y = 0.0;
        size_ = bent_ = variance_ = 0.0;
        for (std::size_t j = 0; j < terms.terms.size(); ++j) {
            size_ += std::abs(coefficients[j]);
            bent_ += std::abs(coefficients[j]) * static_cast<double>(terms.terms[j].n * terms.terms[j].n);
            // A tilt moves the image: it is taken together with v.
            (terms.terms[j].m > 0 ? tilt_x : tilt_y) += terms.terms[j].n == 1 ? coefficients[j] : 0.0;
        }
        reach_ = window.reach(tilt_x, tilt_y);
        base_.size = chord_curves.constant;
        base_.add(light);
        amplitudes_.assign(terms.degree + 1, 0.0);
        for (std::size_t k = terms.curved; k < terms.pairs.size(); ++k) {
            const TermPairs::Pair& pair = terms.pairs[k];
            const double square = pair.square(coefficients);
            amplitudes_[pair.n] += std::sqrt(square);
            variance_ += square / static_cast<double>((pair.n + 1) * (pair.m == 0 ? 1 : 2));
        }
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            base_.add(reach_, 1);
            growth_ = base_;
            for (std::size_t n = 2; n <= terms.degree; ++n) {
                growth_.add(amplitudes_[n], n);
            }
        });
    }

    // The curve on which a better bound on the phase would serve best, if it were `share` of the sum over terms.
    std::size_t best_curve(double error, double share) const { return best(std::log(error) - usual, share); }

    // Chords that such a bound would lead to, roughly, at most the limit.
    std::size_t estimate(std::size_t curve, double error, double share) const {
        return static_cast<std::size_t>(
            std::min(static_cast<double>(max_chords), chords_on(curve, std::log(error) - usual, share)));
    }

    // Takes a bound on the phase on one curve in place of the sum over terms.
    void sharpen(std::size_t curve, double phase) {
        growth_.size[curve] = std::min(growth_.size[curve], base_.size[curve] + phase);
    }

    double size() const { return size_; }
    double variance() const { return variance_; }

    // Chords for an error in U; throws PhaseTooLarge beyond the limit.
    std::size_t chords(double error) const {
        // From below: without (2N+1)^1.5, then with that of as many chords as this takes, and without the sum.
        const auto from = [&](double target) { return chords_on(best(target, 1.0), target, 1.0); };
        double least = from(std::log(error));
        least = from(std::log(error) - 1.5 * std::log1p(2.0 * std::max(0.0, least)));
        if (least <= static_cast<double>(max_chords)) {
            std::size_t chords = rounded_chords(least);
            while (chords <= max_chords && bound(chords) > error) {
                chords = rounded_chords(static_cast<double>(chords + 1));
            }
            if (chords <= max_chords) {
                return chords;
            }
            least = static_cast<double>(chords);
        }
        throw PhaseTooLarge("phases and windows this large (" + shortened(size_) + " rad, v up to " + shortened(reach_) +
                            ") take " + shortened(least) + " chords, more than the limit of " + std::to_string(max_chords));
    }

    // The error in U of the rule with that many chords, exact for polynomials of degree 2N - 1, without rounding.
    double bound(std::size_t chords) const { return growth_.distance(2 * chords - 1); }

    // The rounding of the phase, of the kernel and of two sums; and of nodes and terms, where their tables are made in double.
    double rounding(std::size_t chords) const {
        const double terms = static_cast<double>(terms_->terms.size() + terms_->degree);
        return unit_roundoff * (3.0 * (static_cast<double>(chords) + 12.0) + (terms + 7.0) * size_ + 3.0 * reach_ +
                                (wider ? 0.0 : 3.0 * bent_ + 6.0 * reach_));
    }

   private:
    static constexpr double usual = 6.0;  // what (2N+1)^1.5 and the sum add to a logarithm

    // Chords for bounds of e^target by one curve, if the phase counts as `share` of the sum over terms, and no more than the
    // size on the curve; and where these are fewest.
    double chords_on(std::size_t k, double target, double share) const {
        return 0.5 * (base_.size[k] + share * (growth_.size[k] - base_.size[k]) - target) * chord_curves.inverse[k];
    }
    std::size_t best(double target, double share) const {
        std::size_t at = 0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            ChordCurves::Values chords;
            for (std::size_t k = 0; k < ChordCurves::count; ++k) {
                chords[k] = chords_on(k, target, share);
            }
            at = least_at(chords);
        });
        return at;
    }

    const TermPairs* terms_ = nullptr;
    ChordGrowth base_, growth_;  // without and with the phase
    std::vector<double> amplitudes_;  // of each degree
    double size_ = 0.0, bent_ = 0.0, reach_ = 0.0, variance_ = 0.0;
};

}  // namespace lommel
