// Straight strips cut out of a disk, as by vanes, and error bounds of sums over their nodes (docs/certificate-chords.md, section 8,
// "Strips").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/bounds/amplitude.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/limits.hpp"

namespace lommel {

// Strip of points t (cosine, sine) + s (-sine, cosine), with s from `low` to `high`, and t from its beginning to the rim of the
// disk. It begins at the circle of radius `start`, at the line t = start |s|, or, if whole, at the opposite rim.
struct Strip {
    enum class Begins { circle, line, whole };

    double cosine, sine, low, high;
    bool mirrored, turned;  // the strip with s from -high to -low belongs to it too; that at -t, if turned
    bool ahead, behind;  // where t > 0; where t < 0
    Begins begins;
    double start;

    bool operator==(const Strip& other) const {
        return cosine == other.cosine && sine == other.sine && low == other.low && high == other.high &&
               mirrored == other.mirrored && turned == other.turned && ahead == other.ahead && behind == other.behind &&
               begins == other.begins && start == other.start;
    }
    bool symmetric() const { return mirrored || low == -high; }
    bool both() const { return ahead && behind; }
    bool whole() const { return begins == Begins::whole; }
    double half() const { return 0.5 * (high - low); }
    double middle() const { return 0.5 * (high + low); }
    double farthest() const { return std::max(std::abs(low), std::abs(high)); }
    double nearest() const { return low * high <= 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high)); }
    // Number of intervals of t at each s, counting those of a mirrored strip.
    double intervals() const { return (mirrored ? 2.0 : 1.0) * (both() && !whole() ? 2.0 : 1.0); }
    // Beginning of the interval of t at s; its end is sqrt(1 - s^2).
    template <class Real>
    Real beginning(Real s) const {
        const Real from = static_cast<Real>(start);
        return begins == Begins::circle ? std::sqrt((from - s) * (from + s))
               : begins == Begins::line ? from * std::abs(s)
                                        : -std::sqrt((1 - s) * (1 + s));
    }
    // Largest length of an interval of t, and largest ratio of it to the chord at the same s.
    double longest() const {
        const double s = begins == Begins::circle ? farthest() : nearest();
        return std::sqrt((1.0 - s) * (1.0 + s)) - beginning(s);
    }
    double share() const {
        return whole() ? 1.0 : begins == Begins::line ? 0.5 : 0.5 * longest() / std::sqrt(1.0 - farthest() * farthest());
    }
    // Bound on its area / pi.
    double area() const { return (high - low) * intervals() * longest() / pi; }
};

// Size of the quadrature on strips: lines across a strip, nodes on an interval of a line; and of the interpolation of the fields
// of lines: number of taps, and spacing of the table in units of lambda / (2 pi NA).
struct StripCount {
    std::size_t lines = 0, nodes = 0, taps = 0;
    double spacing = 0.0;
    bool operator==(const StripCount& other) const {
        return lines == other.lines && nodes == other.nodes && taps == other.taps && spacing == other.spacing;
    }
};
constexpr std::size_t most_lines = 12, most_taps = 12;

// Phases of a stack that bounds of its strips depend on.
struct StripPhases {
    std::vector<double> amplitudes;  // [degree]: largest sum of the amplitudes of its Zernike pairs, degrees of 2 and more
    double tilts[2][2] = {{0.0, 0.0}, {0.0, 0.0}};  // smallest and largest tilt along x, along y
    bool any = false;

    void include(const TermPairs& terms, const double* coefficients) {
        std::vector<double> here(terms.degree + 1, 0.0);
        double tilt[2] = {0.0, 0.0};
        for (const TermPairs::Pair& pair : terms.pairs) {
            if (pair.n == 1) {
                tilt[0] = pair.cosine == TermPairs::none ? 0.0 : coefficients[pair.cosine];
                tilt[1] = pair.sine == TermPairs::none ? 0.0 : coefficients[pair.sine];
            } else if (pair.n > 1) {
                here[pair.n] += std::sqrt(pair.square(coefficients));
            }
        }
        amplitudes.resize(here.size(), 0.0);
        for (std::size_t n = 0; n < here.size(); ++n) {
            amplitudes[n] = std::max(amplitudes[n], here[n]);
        }
        for (std::size_t axis = 0; axis < 2; ++axis) {
            tilts[axis][0] = any ? std::min(tilts[axis][0], tilt[axis]) : tilt[axis];
            tilts[axis][1] = any ? std::max(tilts[axis][1], tilt[axis]) : tilt[axis];
        }
        any = true;
    }

    // Bounds on log |integrand| on all curves, without the waves of the window; factor: it is multiplied by a Zernike term of this
    // degree.
    std::vector<double> growth(const Amplitude& light, std::size_t factor) const {
        std::vector<double> grown(ChordCurves::count, 0.0);
        for (std::size_t k = 0; k < grown.size(); ++k) {
            const double b = static_cast<double>(factor) * chord_curves.b[k];
            grown[k] = (light.uniform() ? 0.0 : light.growth(chord_curves.cosh[k])) +
                       (factor > 0 ? b + std::log1p(std::exp(-2.0 * b)) - std::log(2.0) : 0.0);
            for (std::size_t n = 2; n < amplitudes.size(); ++n) {
                grown[k] += amplitudes[n] * chord_curves.growth[n][k];
            }
        }
        return grown;
    }
};

// What bounds for a strip take from its shape alone, at the heights b of every other curve. The integral along t is a function of
// s on the ellipse of height b about the strip: its points are within the curve `across`, |Im t| <= aside, and e^log_length bounds
// the length of its path. The integrand is a function of t on the ellipse of height b about an interval: its points are within the
// curve `along`. Curves are indices, ChordCurves::count if none is high enough.
class StripShape {
   public:
    struct Heights {
        double b, aside, log_length, sinh, rest;
        std::size_t across, along;
    };
    std::vector<Heights> heights;

    explicit StripShape(const Strip& strip) : strip_(strip) {
        constexpr std::size_t stride = 2;
        const double half = 0.5 * strip.longest(), part = strip.share();
        for (std::size_t k = 0; k < ChordCurves::count; k += stride) {
            const double b = chord_curves.b[k], grown = 1.0 + part * 2.0 * std::sinh(0.5 * b) * std::sinh(0.5 * b);
            Heights made{b,
                         0.0,
                         0.0,
                         half * std::sinh(b),
                         -std::log(-std::expm1(-2.0 * b)),
                         ChordCurves::count,
                         above(std::acosh(grown))};
            widen(made);
            heights.push_back(made);
        }
    }
    bool is(const Strip& other) const {
        Strip turned = other;
        turned.cosine = strip_.cosine;
        turned.sine = strip_.sine;
        return turned == strip_;
    }
    std::size_t bytes() const { return heights.size() * sizeof(Heights); }
    static constexpr std::size_t most_bytes = std::size_t{1} << 20;

   private:
    // Index of the first curve of at least the height b.
    static std::size_t above(double b) {
        return static_cast<std::size_t>(std::lower_bound(chord_curves.b.begin(), chord_curves.b.end(), b) -
                                        chord_curves.b.begin());
    }

    // Find what concerns s on the ellipse of height b about the strip.
    void widen(Heights& at) const {
        constexpr std::size_t corners = 6;  // of a polygon about half of the ellipse
        constexpr double farther = 1.0352761804100831;  // 1 / cos(pi / 12)
        const double half = strip_.half(), middle = std::abs(strip_.middle());
        const double wide = farther * half * std::cosh(at.b), tall = farther * half * std::sinh(at.b);
        const double most = middle + wide, rim = strip_.begins == Strip::Begins::circle ? strip_.start : 1.0;
        if (!(most < 0.999 * rim) || tall > 0.7) {
            return;
        }
        const double slope = strip_.begins == Strip::Begins::line ? strip_.start : 0.0, more = 1.0 + slope * slope;
        double grown = 1.0;
        for (std::size_t i = 0; i < corners; ++i) {
            const double angle = pi * (static_cast<double>(i) + 0.5) / static_cast<double>(corners);
            const double x = middle + wide * std::cos(angle), y = tall * std::sin(angle), square = x * x + y * y;
            const double circle = rim * rim;
            const auto far = [&](double r, double by) { return std::hypot(r - by * (x * x - y * y), by * 2.0 * x * y); };
            grown = std::max(grown, 1.0 - circle + square + far(circle, 1.0));
            grown = std::max(grown, more * square + far(1.0, more));
        }
        const double edge = std::sqrt(rim * rim - most * most), end = std::sqrt(1.0 - most * most);
        at.aside = std::max(slope * tall, most * tall / edge);
        at.log_length = std::log(strip_.begins == Strip::Begins::circle ? (1.0 - rim * rim) / (edge + end)
                                 : strip_.whole() ? 2.0 * std::sqrt(1.0 + tall * tall)
                                                  : std::sqrt(1.0 + tall * tall) + slope * std::hypot(most, tall));
        at.across = above(0.5 * std::acosh(grown));
    }

    Strip strip_;
};

// Error bounds of the field of one strip, for all phases of a stack and all points of a window.
class StripBound {
   public:
    // growth: of the integrand, StripPhases::growth(); shape: that of the strip.
    StripBound(const Strip& strip, const StripShape& shape, const StripPhases& phases, const std::vector<double>& growth,
               const VBox& window)
        : strip_(strip) {
        double along = 0.0;  // largest distances of a point of the window from the tilted axis
        const double x[2] = {window.left - phases.tilts[0][1], window.right - phases.tilts[0][0]};
        const double y[2] = {window.top - phases.tilts[1][1], window.bottom - phases.tilts[1][0]};
        for (const double across : x) {
            for (const double down : y) {
                along = std::max(along, std::abs(strip.cosine * across + strip.sine * down));
                across_ = std::max(across_, std::abs(strip.cosine * down - strip.sine * across));
            }
        }
        // Bounds on the Chebyshev coefficients of the integral along t, a function of s in the strip.
        coefficients_.fill(2.0 * strip.longest());
        coefficients_[0] = strip.longest();
        for (const StripShape::Heights& at : shape.heights) {
            along_.push_back({at.along < growth.size() ? growth[at.along] + along * at.sinh + at.rest : 1e300, at.b});
            const double size = at.across < growth.size() ? at.log_length + growth[at.across] + along * at.aside : 1e300;
            if (!(size < 600.0)) {
                continue;
            }
            const double smaller = std::exp(-at.b);
            double bound = 2.0 * std::exp(size);
            for (std::size_t n = 1; n < kept; ++n) {
                coefficients_[n] = std::min(coefficients_[n], bound *= smaller);
            }
            rest_ = std::min(rest_, bound * smaller / (1.0 - smaller));
        }
    }

    // Bound on the error of the sum over `lines` lines, of integrals along them.
    double across(std::size_t lines) const {
        const double half = strip_.half(), z = across_ * half;
        std::array<double, waves> wave;  // bound on the coefficients of exp(-i z x) in Chebyshev polynomials
        wave[0] = 1.0;
        for (std::size_t k = 1; k < waves; ++k) {
            wave[k] = 0.5 * z / static_cast<double>(k) * wave[k - 1];
        }
        // The Gauss rule with n nodes is off by at most this for the Chebyshev polynomial of an even degree m >= 2 n, over [-1, 1].
        std::array<double, kept + waves> missed{};
        for (std::size_t m = 2 * lines; m < missed.size(); m += 2) {
            missed[m] = 2.0 + 2.0 / static_cast<double>(m * m - 1);
        }
        double sum = 4.0 * rest_;
        for (std::size_t n = 0; n < kept; ++n) {
            double off = missed[n] * wave[0];
            for (std::size_t k = n % 2 == 0 ? 2 : 1; k < waves; k += 2) {
                off += wave[k] * (missed[n + k] + missed[n > k ? n - k : k - n]);
            }
            sum += coefficients_[n] * off;
        }
        // The series of exp(-i z x) is cut after `waves` terms, where z / 2 < waves / 2 leaves less than twice the last one.
        const double cut = 0.5 * z < 0.5 * static_cast<double>(waves) ? 8.0 * wave[waves - 1] : 4.0;
        return strip_.intervals() * half / pi * (sum + cut * (strip_.longest() + rest_));
    }

    // Bound on the error of the sums over `nodes` nodes of each interval.
    double along(std::size_t nodes) const {
        double best = 690.0;
        for (const auto& [size, b] : along_) {
            best = std::min(best, size - 2.0 * static_cast<double>(nodes) * b);
        }
        return (strip_.high - strip_.low) * strip_.intervals() * 0.5 * strip_.longest() / pi * 64.0 / 15.0 * std::exp(best);
    }

    // Bound on the error by interpolation whose weights have the root mean square error `misfit` over |t| <= 1.
    double between(double misfit) const {
        const double each = strip_.whole() ? 2.0 : std::sqrt(strip_.longest());
        return (strip_.high - strip_.low) * strip_.intervals() / pi * each * misfit;
    }

   private:
    static constexpr std::size_t kept = 28, waves = 24;

    Strip strip_;
    double across_ = 0.0;
    std::vector<std::pair<double, double>> along_;  // log of the bound on the integrand on a curve of height b; b
    std::array<double, kept> coefficients_;
    double rest_ = 1e300;  // bound on the sum of all further coefficients
};

}  // namespace lommel
