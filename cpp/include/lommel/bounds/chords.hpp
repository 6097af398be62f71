// How many nodes the chordal Gauss rule takes, and what is proven about its error; derived in docs/certificate.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lommel/radial/field.hpp"

namespace lommel {

constexpr std::size_t max_chords = 1024;  // chords of the disk, and nodes on each

// A Zernike term: R_n^m(rho) cos(m theta), or R_n^|m|(rho) sin(|m| theta) where m < 0; R(1) = 1.
// Numbers of chords in use: few, so that tables are shared, and even, so that all nodes come in quadruples.
inline std::size_t rounded_chords(double wanted) {
    const std::size_t n = static_cast<std::size_t>(std::max(8.0, std::ceil(wanted)));
    const std::size_t step = n <= 64 ? 2 : n <= 128 ? 4 : n <= 256 ? 8 : n <= 512 ? 16 : 32;
    return (n + step - 1) / step * step;
}

// What does not depend on the pupil: on the curves phi = a + ib through the chords, for a range of b, by how much the
// logarithm of the integrand grows for each radian of each degree.
class ChordCurves {
   public:
    static constexpr std::size_t count = 32;

    explicit ChordCurves(const std::vector<ZernikeTerm>& terms) : terms_(terms) {
        std::size_t top = 1;
        for (const ZernikeTerm& t : terms) {
            top = std::max(top, static_cast<std::size_t>(t.n));
        }
        degrees_ = top + 1;
        growth_.resize(count * degrees_);
        double at = 0.05;
        for (std::size_t k = 0; k < count; ++k, at *= 1.14) {
            b[k] = at;
            decay[k] = std::exp(-at);
            cosh[k] = std::cosh(2.0 * at);
            constant[k] = std::log1p(std::exp(-2.0 * at));
            for (std::size_t n = 0; n < degrees_; ++n) {
                growth_[k * degrees_ + n] = std::sinh(static_cast<double>(n) * at);
            }
        }
        // Cosine and sine of the same n and |m| turn together: their amplitude is the hypotenuse.
        partner_.assign(terms.size(), terms.size());
        for (std::size_t j = 0; j < terms.size(); ++j) {
            for (std::size_t i = 0; i < terms.size(); ++i) {
                if (i != j && terms[i].n == terms[j].n && terms[i].m == -terms[j].m) {
                    partner_[j] = i;
                }
            }
        }
    }

    std::size_t degrees() const { return degrees_; }
    const double* growth(std::size_t k) const { return growth_.data() + k * degrees_; }
    const std::vector<ZernikeTerm>& terms() const { return terms_; }
    std::size_t partner(std::size_t j) const { return partner_[j]; }

    double b[count], decay[count], cosh[count], constant[count];

   private:
    std::vector<ZernikeTerm> terms_;
    std::vector<std::size_t> partner_;
    std::vector<double> growth_;
    std::size_t degrees_;
};

// The window in v: its corners.
struct VBox {
    double left, right, top, bottom;
    VBox scaled(double by) const { return {by * left, by * right, by * top, by * bottom}; }
    // Largest distance from (x, y).
    double reach(double x, double y) const {
        return std::hypot(std::max(std::abs(left - x), std::abs(right - x)),
                          std::max(std::abs(top - y), std::abs(bottom - y)));
    }
};

// One disk with its phase and its window: log_size[k] bounds the logarithm of the integrand on the curve of b_k.
class ChordBound {
   public:
    void prepare(const ChordCurves& curves, const double* coefficients, const Amplitude& light, const VBox& window) {
        curves_ = &curves;
        const std::vector<ZernikeTerm>& terms = curves.terms();
        amplitude_.assign(curves.degrees(), 0.0);
        double tilt_x = 0.0, tilt_y = 0.0;
        size_ = 0.0;
        bent_ = 0.0;
        variance_ = 0.0;
        for (std::size_t j = 0; j < terms.size(); ++j) {
            const double c = coefficients[j];
            size_ += std::abs(c);
            bent_ += std::abs(c) * static_cast<double>(terms[j].n * terms[j].n);
            if (terms[j].n == 1) {
                // A tilt moves the image: it is taken together with v.
                (terms[j].m > 0 ? tilt_x : tilt_y) += c;
                continue;
            }
            if (terms[j].n == 0) {
                continue;
            }
            variance_ += c * c / static_cast<double>((terms[j].n + 1) * (terms[j].m == 0 ? 1 : 2));
            const std::size_t partner = curves.partner(j);
            double& amplitude = amplitude_[static_cast<std::size_t>(terms[j].n)];
            if (terms[j].m == 0 || partner == terms.size()) {
                amplitude += std::abs(c);
            } else if (terms[j].m > 0) {
                amplitude += std::sqrt(c * c + coefficients[partner] * coefficients[partner]);
            }
        }
        reach_ = window.reach(tilt_x, tilt_y);
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            const double* growth = curves.growth(k);
            base_[k] = light.growth(curves.cosh[k]) + curves.constant[k] + reach_ * growth[1];
            double sum = 0.0;
            for (std::size_t n = 2; n < amplitude_.size(); ++n) {
                sum += amplitude_[n] * growth[n];
            }
            log_size_[k] = base_[k] + sum;
        }
    }

    // The curve on which a better bound on the phase would serve best, if it were `share` of the sum over terms.
    std::size_t best_curve(double error, double share) const {
        const double target = std::log(error);
        std::size_t best = 0;
        double least = 1e300;
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            const double chords = (base_[k] + share * (log_size_[k] - base_[k]) - target + 6.0) / curves_->b[k];
            if (chords < least) {
                least = chords;
                best = k;
            }
        }
        return best;
    }

    // Chords that such a bound would lead to, roughly, at most the limit.
    std::size_t estimate(std::size_t curve, double error, double share) const {
        const double sum = base_[curve] + share * (log_size_[curve] - base_[curve]) - std::log(error) + 6.0;
        return static_cast<std::size_t>(std::min(static_cast<double>(max_chords), 0.5 * sum / curves_->b[curve]));
    }

    // Takes a bound on the phase on one curve in place of the sum over terms.
    void sharpen(std::size_t curve, double phase) { log_size_[curve] = std::min(log_size_[curve], base_[curve] + phase); }

    double size() const { return size_; }
    double reach() const { return reach_; }
    double variance() const { return variance_; }

    // Chords for an error in U; throws PhaseTooLarge beyond the limit.
    std::size_t chords(double error) const {
        const double target = std::log(error);
        double least = 1e300;
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            const double b = curves_->b[k];
            // Without (2N+1)^1.5 and the sum: below what it takes.
            least = std::min(least, (log_size_[k] - target) / b);
        }
        double n = 0.5 * least;
        if (n <= static_cast<double>(max_chords)) {
            std::size_t chords = rounded_chords(n);
            while (chords <= max_chords && bound(chords) > error) {
                chords = rounded_chords(static_cast<double>(chords + 1));
            }
            n = static_cast<double>(chords);
            if (chords <= max_chords) {
                return chords;
            }
        }
        throw PhaseTooLarge("phases and windows this large (" + shortened(size_) + " rad, v up to " + shortened(reach_) +
                            ") take " + shortened(n) + " chords, more than the limit of " + std::to_string(max_chords));
    }

    // The error in U of the rule with that many chords, without rounding.
    double bound(std::size_t chords) const {
        const double first = 2.0 * static_cast<double>(chords) + 1.0, ratio = std::pow((first + 1.0) / first, 1.5);
        double least = 1e300, sum = 1.0;
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            const double q = curves_->decay[k] * ratio, exponent = log_size_[k] - (first - 1.0) * curves_->b[k];
            if (q < 1.0 && exponent < least) {
                least = exponent;
                sum = first * std::sqrt(first) / (1.0 - q);
            }
        }
        return sum * std::exp(std::min(least, 600.0));
    }

    // The rounding of the phase, of the kernel and of two sums; and of nodes and terms, where their tables are made in double.
    double rounding(std::size_t chords) const {
        const double terms = static_cast<double>(curves_->terms().size() + curves_->degrees());
        return unit_roundoff * (3.0 * (static_cast<double>(chords) + 12.0) + (terms + 6.0) * size_ + 3.0 * reach_ +
                                (wider ? 0.0 : 3.0 * bent_ + 6.0 * reach_));
    }

   private:
    static std::string shortened(double x) {
        char text[32];
        std::snprintf(text, sizeof text, "%.3g", x);
        return text;
    }

    const ChordCurves* curves_ = nullptr;
    std::vector<double> amplitude_;
    double base_[ChordCurves::count] = {}, log_size_[ChordCurves::count] = {};  // without and with the phase
    double size_ = 0.0, bent_ = 0.0, reach_ = 0.0, variance_ = 0.0;
};

}  // namespace lommel
