// Error bound of the chordal Gauss rule, and the numbers of chords and of nodes for a tolerance (docs/certificate.md, section 8).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "lommel/base/wide.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/limits.hpp"

namespace lommel {

constexpr double single_roundoff = 5.9604644775390625e-08;
constexpr std::size_t sum_block = 16;  // number of terms that long sums in single precision add up at a time
constexpr std::size_t max_chords = 1024;  // maximum number of chords, and of nodes on each chord

// The two sums of the chordal rule: over chords, and over the nodes of a chord.
enum class Sum { chords, nodes };

// Smallest permitted size of a sum, at least `wanted`. Permitted sizes are few, to share tables, and even, for nodes at (+-x, +-y).
inline std::size_t rounded_size(Sum sum, double wanted) {
    const std::size_t n = static_cast<std::size_t>(std::max(8.0, std::ceil(wanted)));
    const std::size_t step = n <= (sum == Sum::chords ? 64 : 24) ? 2 : n <= 128 ? 4 : n <= 256 ? 8 : n <= 512 ? 16 : 32;
    return (n + step - 1) / step * step;
}

// Sides of the window in optical units v = pi distance / (lambda N), with N the f-number.
struct VBox {
    double left, right, top, bottom;
    VBox scaled(double by) const { return {by * left, by * right, by * top, by * bottom}; }
    // Largest distance from (x, y) to a point of the window.
    double reach(double x, double y) const { return std::hypot(std::max(std::abs(left - x), std::abs(right - x)), rise(y)); }
    // Largest distance in y alone from (x, y) to a point of the window.
    double rise(double y) const { return std::max(std::abs(top - y), std::abs(bottom - y)); }
    bool operator==(const VBox& other) const {
        return left == other.left && right == other.right && top == other.top && bottom == other.bottom;
    }
};

// Error bound of the field, from the integrand on one complex curve, b its height above the real axis: e^{exponent - 2 n b} for a
// sum over n nodes; e^{exponent - 2 n b} / (1 - e^{-2 (n + 1) b}) for a sum over n chords (docs/certificate.md, section 8).
struct ChordLine {
    std::size_t curve = 0;
    double exponent = 690.0;

    // Bound on the error of the field without rounding, for a sum of size n.
    double bound(Sum sum, std::size_t n) const {
        const double twice = 2.0 * static_cast<double>(n), b = chord_curves.b[curve];
        const double least = std::exp(std::min(exponent - twice * b, 690.0));
        return sum == Sum::nodes ? least : least / -std::expm1(-(twice + 2.0) * b);
    }
    // Error bound of the field if the integrand is multiplied by a Zernike term of degree n.
    ChordLine times(std::size_t n) const {
        const double x = static_cast<double>(n) * chord_curves.b[curve];
        return {curve, n == 0 ? exponent : exponent + x + std::log1p(std::exp(-2.0 * x)) - std::log(2.0)};
    }
    // Number of chords or nodes for bound() <= error. needed(): approximate; enough(): smallest permitted, or more than max_chords.
    double needed(double error) const { return 0.5 * (exponent - std::log(error)) * chord_curves.inverse[curve]; }
    std::size_t enough(Sum sum, double error) const {
        std::size_t n = rounded_size(sum, std::min(needed(error), 2.0 * max_chords));
        while (n <= max_chords && bound(sum, n) > error) {
            n = rounded_size(sum, static_cast<double>(n + 1));
        }
        return n;
    }
};

// Error bounds of the chordal rule on one disk, for the phase given to prepare() and a window.
class ChordBound {
   public:
    ChordBound(const TermPairs& terms, const Amplitude& light, const VBox& window)
        : terms_(terms), window_(window), amplitudes_(terms.degree + 1) {
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            const double b = chord_curves.b[k], grown = light.uniform() ? 0.0 : light.growth(chord_curves.cosh[k]);
            still_[0][k] = std::log1p(std::exp(-4.0 * b)) + grown;
            still_[1][k] = std::log(32.0 / 15.0) - std::log(-std::expm1(-2.0 * b)) + grown;
        }
    }

    void prepare(const double* coefficients) {
        double tilt_x = 0.0, tilt_y = 0.0;
        size_ = bent_ = variance_ = 0.0;
        for (std::size_t j = 0; j < terms_.terms.size(); ++j) {
            const ZernikeTerm& term = terms_.terms[j];
            size_ += std::abs(coefficients[j]);
            bent_ += std::abs(coefficients[j]) * static_cast<double>(term.n * term.n);
            // A tilt (n = 1) moves the image: distances in the window are measured from the moved centre.
            (term.m > 0 ? tilt_x : tilt_y) += term.n == 1 ? coefficients[j] : 0.0;
        }
        std::fill(amplitudes_.begin(), amplitudes_.end(), 0.0);
        for (std::size_t k = terms_.curved; k < terms_.pairs.size(); ++k) {
            const TermPairs::Pair& pair = terms_.pairs[k];
            const double square = pair.square(coefficients);
            amplitudes_[pair.n] += std::sqrt(square);
            variance_ += square / static_cast<double>((pair.n + 1) * (pair.m == 0 ? 1 : 2));
        }
        // Largest distance of a window point from the moved centre: reach_[0] (sums over chords) in x and y, reach_[1] in y alone.
        reach_[0] = window_.reach(tilt_x, tilt_y);
        reach_[1] = window_.rise(tilt_y);
    }

    // Bounds for f = Im(Phi + v . rho) along a curve, for phase Phi and all v in the window. size(): on |f|; bend(): on |f''|.
    double size(Sum sum, std::size_t curve) const {
        double total = reach_[at(sum)] * chord_curves.growth[1][curve];
        for (std::size_t n = 2; n < amplitudes_.size(); ++n) {
            total += amplitudes_[n] * chord_curves.growth[n][curve];
        }
        return total;
    }
    double bend(Sum sum, std::size_t curve) const {
        double total = reach_[at(sum)] * chord_curves.growth[1][curve];
        for (std::size_t n = 2; n < amplitudes_.size(); ++n) {
            total += amplitudes_[n] * static_cast<double>(n * n) * chord_curves.growth[n][curve];
        }
        return total;
    }

    // Error bound of the field from a curve on which the integrand is at most e^logarithm.
    ChordLine line(Sum sum, std::size_t curve, double logarithm) const { return {curve, still_[at(sum)][curve] + logarithm}; }

    // Error bound of the field from the curve with the smallest needed(error), if log(integrand) on each curve is `share` times its
    // bound size(). As needed(error) is convex in the height of the curve, descent finds its minimum.
    ChordLine best(Sum sum, double error, double share) {
        const auto on = [&](std::size_t curve) { return line(sum, curve, share * size(sum, curve)); };
        std::size_t& k = start_[at(sum)];
        k = std::min(k, highest_start);
        ChordLine here = on(k);
        double least = here.needed(error);
        for (const std::size_t step : {std::size_t{1}, ~std::size_t{0}}) {
            while (k + step < ChordCurves::count) {
                const ChordLine next = on(k + step);
                const double found = next.needed(error);
                if (!(found < least)) {
                    break;
                }
                here = next;
                least = found;
                k += step;
            }
        }
        return here;
    }

    double size() const { return size_; }
    double variance() const { return variance_; }

    // Rounding error of phase, kernel and sums in double precision; without extended precision, of nodes and tabulated terms too.
    double rounding() const {
        const double terms = static_cast<double>(terms_.terms.size() + terms_.degree);
        return unit_roundoff * (36.0 + (terms + 7.0) * size_ + 3.0 * reach_[0] + (wider ? 0.0 : 3.0 * bent_ + 6.0 * reach_[0]));
    }
    static double rounding(std::size_t chords, std::size_t nodes) {
        return unit_roundoff * static_cast<double>(2 * chords + (wider ? 1 : 2) * nodes);
    }

    // Rounding error of the field from sums in single precision. A phase is a sum of `terms` terms, in multiples of 2^-32 turns.
    static double single_rounding(double chords, double nodes, std::size_t terms) {
        return single_roundoff * (30.0 + 1.5 * sum_rounding(0.5 * chords) + 2.0 * sum_rounding(0.5 * nodes)) +
               7.4e-10 * static_cast<double>(terms + 4);
    }
    // Rounding error of a sum of `count` terms in single precision, by_blocks(), less one half, over the sum of moduli.
    static double sum_rounding(double count) {
        constexpr double block = static_cast<double>(sum_block);
        return count < 2.0 * block ? 0.5 * count : 0.5 * block + std::ceil(count / block) - 1.0;
    }

    // Additional rounding error of the field if the integrand is multiplied by a Zernike term of degree n.
    static double factor_rounding(std::size_t n, bool single) {
        const double square = static_cast<double>(n * n);
        return n == 0 ? 0.0 : unit_roundoff * (6.0 + (wider ? 0.0 : 6.0 * square)) + (single ? 4.0 * single_roundoff : 0.0);
    }

    // Throw LimitExceeded; the message says which windows and phases would fit. most_nodes: maximum number of nodes in all tables.
    [[noreturn]] void refuse(Sum sum, const ChordLine& line, double error, double most_nodes) {
        const double needed = line.needed(error), more = needed - best(sum, error, 1.0).needed(error);
        std::string message = "phases and windows this large (" + shortened(size_) + " rad, v up to " + shortened(reach_[0]) +
                              ") take " + shortened(std::ceil(needed)) +
                              (sum == Sum::chords ? " chords" : " nodes on each chord") + ", more than the limit of " +
                              std::to_string(max_chords) + "; at most ";
        const double whole[2] = {reach_[0], reach_[1]};
        // Largest factor below 1, in percent, by which the window or, if `phases`, both window and phase may be scaled so that
        // max_chords and most_nodes suffice with a margin; 0 if there is none.
        const auto largest = [&](bool phases) {
            int hundredths = 99;
            for (; hundredths > 0; --hundredths) {
                const double share = 0.01 * hundredths;
                double numbers[2];
                for (const Sum each : {Sum::chords, Sum::nodes}) {
                    reach_[at(each)] = whole[at(each)] * (phases ? 1.0 : share);
                }
                for (const Sum each : {Sum::chords, Sum::nodes}) {
                    numbers[at(each)] = best(each, error, phases ? share : 1.0).needed(error) + more;
                }
                if (std::max(numbers[0], numbers[1]) <= 0.95 * max_chords &&
                    numbers[0] * numbers[1] * share <= 0.8 * most_nodes) {
                    break;
                }
            }
            return hundredths;
        };
        if (const int window = largest(false)) {
            message += "windows of " + shortened(0.01 * window) + " times the size, or ";
        }
        throw LimitExceeded(message + "phases and windows of " + shortened(0.01 * largest(true)) + " times the size fit");
    }

   private:
    // Highest curve at which best() may start: on higher curves ChordCurves limits sinh(n b) of the highest degrees n to sinh(600),
    // so there size() is not a bound.
    static constexpr std::size_t highest_start = 56;

    static std::size_t at(Sum sum) { return sum == Sum::chords ? 0 : 1; }

    const TermPairs& terms_;
    VBox window_;
    ChordCurves::Values still_[2];  // [sum][curve]: logarithm of the error bound for phase 0 and v = 0
    std::vector<double> amplitudes_;  // [degree]: sum of the amplitudes of its Zernike pairs
    double size_ = 0.0, bent_ = 0.0, variance_ = 0.0, reach_[2] = {0.0, 0.0};
    std::size_t start_[2] = {ChordCurves::count / 2, ChordCurves::count / 2};
};

}  // namespace lommel
