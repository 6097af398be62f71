// The spectral engine: the field of one pupil, and what is proven about its error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "lommel/special/bessel.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/radial_polynomials.hpp"
#include "lommel/radial/series.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

constexpr double unit_roundoff = 1.1102230246251565e-16;
constexpr std::size_t max_terms = 6000;  // of a series; its Legendre rule takes about 4 n^2 bytes
constexpr double max_phase = 1e6;        // radians; beyond, the reduction of arguments loses digits

struct PhaseTooLarge : std::domain_error {
    using std::domain_error::domain_error;
};

inline void check_reach(double reach) {
    if (!(reach <= max_reach)) {
        char message[96];
        std::snprintf(message, sizeof message, "v up to %.3g from the axis is more than the limit of %.3g", reach, max_reach);
        throw PhaseTooLarge(message);
    }
}

// Where a field is wanted: at radii[0 .. count), rising, `step` in v each; or anywhere up to a reach in v.
struct Places {
    const double* radii;
    std::size_t count;
    double step;

    Places(const double* at, std::size_t n, double scale) : radii(at), count(n), step(scale) {}
    Places(double reach) : radii(nullptr), count(0), step(reach) {}
    double reach() const { return count > 0 ? radii[count - 1] * step : radii == nullptr ? step : 0.0; }
};

// The pupil function A exp(i Phi): coefficients of R_2^0 = P_1(2t - 1), R_4^0, ... of the phase, in radians, and the amplitude,
// which is not copied.
struct Phase {
    const double* coefficients;
    std::size_t terms;
    const Amplitude* amplitude = &even_light;

    double size() const { return weighted(0.0, 0.0, 1.0); }
    // What roundings do to the phase, its mean over t: of each coefficient two, of P_j(x) one, of the products and the sum at
    // most K + 1, K of the coefficients not being 0, and that of the node x, half a one at most, as much as the mean of |P_j'|:
    // by Cauchy at most sqrt(j (j + 1) / 2).
    double sensitivity() const {
        const double used = static_cast<double>(terms) - static_cast<double>(std::count(coefficients, coefficients + terms, 0.0));
        return weighted(0.0, 1.0, used + 5.0) + amplitude->sensitivity();
    }
    // How far from the axis rays arrive, in v, at most: |dR_2j/drho| <= 2 j (j + 1).
    double blur() const { return weighted(2.0, 2.0, 0.0); }

   private:
    double weighted(double square, double slope, double start) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < terms; ++k) {
            const double j = static_cast<double>(k + 1);
            sum += ((square * j + slope) * j + start) * std::abs(coefficients[k]);
        }
        return sum;
    }
};

// How a disk is expanded: enough terms and quadrature nodes for an error in U at every v up to a reach.
struct Expansion {
    std::size_t terms = 0;
    std::shared_ptr<const LegendreRule> rule;
    double truncation = 0.0, quadrature = 0.0;

    Expansion() = default;
    Expansion(const Ellipses& ellipses, double reach, double error) {
        check_reach(reach);
        const std::size_t by_phase = ellipses.terms(0.5 * error), by_window = window_terms(reach, 0.5 * error);
        terms = std::min(by_phase, by_window);
        truncation = by_phase <= by_window ? ellipses.tail(terms) : window_tail(terms, reach);
        const std::size_t nodes = ellipses.nodes(terms, 0.1 * error);
        if (nodes > max_terms) {
            throw PhaseTooLarge("aberrations this large take a series of " + std::to_string(nodes) +
                                " nodes, more than the limit of " + std::to_string(max_terms) +
                                "; Geometric, which leaves diffraction out, has none");
        }
        rule = LegendreRule::get(nodes, terms);
        quadrature = ellipses.quadrature(2 * rule->half, terms);
    }

    std::size_t room() const { return rule->blocks * 2 * row_lanes; }

    // Roundings of exp(i Phi) at the nodes reach U undiminished at most (Parseval, twice); those of the sums over half
    // the nodes, in two chains, come with the square root of the number of terms.
    double error(const Phase& phase) const {
        const double rounding = phase.sensitivity() + 8.0 +
                                std::sqrt(static_cast<double>(terms)) * (0.5 * static_cast<double>(rule->half) + 16.0 + rule_rounding(2 * rule->half));
        return truncation + quadrature + unit_roundoff * rounding;
    }
};

inline void check_size(const Phase& phase) {
    const double size = phase.size();
    if (!(size <= max_phase)) {
        char message[96];
        std::snprintf(message, sizeof message, "phases of %.3g rad exceed the limit of %.0f rad", size, max_phase);
        throw PhaseTooLarge(message);
    }
}

// What the rounding of radii does to U up to v: in units of a piece they are off by three roundings, the step in v by three,
// and |U'| <= int sqrt(t) |J_1(v sqrt t)| dt is at most 1/2 and, |J_1(x)| being at most 0.826 / sqrt(x), 0.661 / sqrt(v).
inline double radius_rounding(double v) { return 6.0 * unit_roundoff * std::min(0.5 * v, 0.661 * std::sqrt(v)); }

// The Legendre series of t^power exp(i Phi) on a full disk.
struct Disk {
    Doubles re, im;
    std::size_t terms = 0;

    // Expands to `error` in U at every v up to `reach`; returns the bound that was reached, rounding included.
    double expand(const Phase& phase, std::size_t power, double reach, double error, SeriesScratch& scratch) {
        check_size(phase);
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

    // Adds a constant to the phase.
    void turn(double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        for (std::size_t n = 0; n < terms; ++n) {
            const double a = re[n], b = im[n];
            re[n] = c * a - s * b;
            im[n] = s * a + c * b;
        }
    }
};

// U of a pupil, obscured or not, as a function of v. Holds the scratch of one thread; nothing is allocated once it has
// grown.
class Field {
   public:
    // Makes ready for some places, with t^power before exp(i Phi); returns the bound on the error of U.
    double prepare(const Phase& phase, std::size_t power, double obscuration, const Places& places, double error) {
        const double reach = places.reach();
        // An obscuration that takes less light than the rounding is none.
        obscuration_ = obscuration < 1e-9 ? 0.0 : obscuration;
        const double area = obscuration_ * obscuration_;
        double bound = outer_.expand(phase, power, reach, 0.5 * error, scratch_);
        bound += radius_rounding(reach);
        weight_ = 0.0;
        if (area > 0.0) {
            // The inner disk carries the phase of rho < eps.
            weight_ = area;
            const double lost = shrink(phase);
            for (std::size_t k = 0; k < power; ++k) {
                weight_ *= area;
            }
            inner_amplitude_ = phase.amplitude->scaled(area);
            const Phase inner{inner_phase_.data() + 1, phase.terms, &inner_amplitude_};
            bound += weight_ * (inner_.expand(inner, power, obscuration_ * reach, 0.5 * error, scratch_) + lost +
                                radius_rounding(obscuration_ * reach) + 4.0 * unit_roundoff);
            inner_.turn(inner_phase_[0]);
        }
        const std::size_t terms = std::max(outer_.terms, area > 0.0 ? inner_.terms : 0);
        std::size_t width = 0;
        while (width < widths.size() && piece_error(widths[width]) * (1.0 + weight_) > 0.4 * error) {
            ++width;
        }
        // By Cauchy and Parseval, the magnitudes of what is added sum to at most 1.
        const double by_series = static_cast<double>(terms) + 16.0;
        table_ = nullptr;
        if (width < widths.size()) {
            const WantedPieces wanted = pieces_for(places, reach, widths[width], terms);
            table_ = wanted.end() > 0 ? even_pieces.get(width, wanted, terms) : nullptr;
        }
        if (table_ == nullptr) {
            return bound + unit_roundoff * (1.0 + weight_) * by_series;
        }
        const double by_table = table_->magnitude * (0.5 * static_cast<double>(terms) + 40.0);
        return bound + (1.0 + weight_) * (piece_error(table_->width) + unit_roundoff * std::max(by_table, few_ ? by_series : 0.0));
    }

    // Hands U at radii[first .. last), rising, `step` in v each, to sink(i - first, re, im), a vector at a time. The
    // arrays behind it must have room for widest_step values past the last, and so must the radii.
    template <class I, class Sink>
    LOMMEL_INLINE void evaluate(I isa, const double* radii, std::size_t first, std::size_t last, double step,
                                const Sink& sink) {
        using V = typename I::pack;
        if (weight_ == 0.0) {
            return evaluate_disk(isa, outer_, radii, first, last, step, sink);
        }
        re_.resize(last - first + widest_step);
        im_.resize(re_.size());
        double *re = re_.data(), *im = im_.data();
        evaluate_disk(isa, inner_, radii, first, last, obscuration_ * step,
                      [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA {
                          store(re + i, a * splat<V>(weight_));
                          store(im + i, b * splat<V>(weight_));
                      });
        evaluate_disk(isa, outer_, radii, first, last, step, [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA {
            sink(i, a - load<V>(re + i), b - load<V>(im + i));
        });
    }

   private:
    // Near the axis every piece that holds a radius is worth its table, which all calls share. Farther out only those are that
    // hold as many radii as the table takes points; the other radii are summed by the series, one by one.
    static constexpr double near = 4096.0;
    static constexpr std::size_t crowd = degree_count;
    static constexpr std::size_t most_bytes = std::size_t{256} << 20;  // of the pieces for one call

    // Fills the phase of the inner disk over its own radius, the constant first; returns the bound on what that loses.
    double shrink(const Phase& phase) {
        const std::size_t n = phase.terms;
        if (shares_.size() != (n + 1) * n || shrunk_by_ != obscuration_) {
            shares_.assign((n + 1) * n, 0.0);
            shrunk_by_ = obscuration_;
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k <= j + 1; ++k) {
                    shares_[k * n + j] = shrunk(2 * j + 2, 2 * k, obscuration_);
                }
            }
        }
        inner_phase_.assign(n + 1, 0.0);
        double lost = 0.0;
        for (std::size_t j = 0; j < n; ++j) {
            const double size = std::abs(phase.coefficients[j]);
            lost += shrinking(2 * j + 2) * size;
            for (std::size_t k = 0; k <= j + 1; ++k) {
                inner_phase_[k] += shares_[k * n + j] * phase.coefficients[j];
                lost += unit_roundoff * static_cast<double>(n + 1) * std::abs(shares_[k * n + j]) * size;
            }
        }
        return lost;
    }

    std::size_t piece_at(double radius, double per_pixel) const {
        return std::min(static_cast<std::size_t>(radius * per_pixel), all_ - 1);
    }
    // The end of the radii in piece s from `first` on.
    std::size_t end_of(std::size_t s, const double* radii, std::size_t first, std::size_t last, double per_pixel) const {
        if (s + 1 == all_) {
            return last;
        }
        const double end = static_cast<double>(s + 1) / per_pixel;
        return static_cast<std::size_t>(std::lower_bound(radii + first + 1, radii + last, end) - radii);
    }
    bool by_table(std::size_t s, std::size_t radii) const { return s < leading_ || (radii >= crowd && s < end_); }

    WantedPieces pieces_for(const Places& places, double reach, double width, std::size_t terms) {
        all_ = leading_ = end_ = static_cast<std::size_t>(reach / width) + 1;
        few_ = false;
        WantedPieces wanted;
        if (places.count == 0 || (places.count >= all_ && reach <= near)) {
            wanted.leading = all_;
            return wanted;
        }
        leading_ = std::min(all_, static_cast<std::size_t>(near / width));
        for (const double scale : {1.0, obscuration_}) {
            const double per_pixel = scale * places.step / width;
            for (std::size_t i = 0; scale > 0.0 && i < places.count;) {
                const std::size_t s = piece_at(places.radii[i], per_pixel);
                const std::size_t stop = end_of(s, places.radii, i, places.count, per_pixel);
                if (by_table(s, stop - i)) {
                    wanted.others.push_back(s);
                } else {
                    few_ = true;
                }
                i = stop;
            }
        }
        std::sort(wanted.others.begin(), wanted.others.end());
        wanted.others.erase(std::unique(wanted.others.begin(), wanted.others.end()), wanted.others.end());
        const std::size_t room = most_bytes / (sizeof(double) * degree_count * (terms + 32));
        if (wanted.others.size() > room) {
            wanted.others.resize(room);
            few_ = true;
        }
        end_ = wanted.end();
        leading_ = std::min(leading_, end_);
        return wanted;
    }

    template <class I, class Sink>
    LOMMEL_INLINE void evaluate_disk(I isa, const Disk& disk, const double* radii, std::size_t first, std::size_t last,
                                     double step, const Sink& sink) {
        using V = typename I::pack;
        constexpr std::size_t unroll = I::unroll;
        const double per_pixel = table_ == nullptr ? 0.0 : step / table_->width;
        for (std::size_t i = first; i < last;) {
            std::size_t s = 0, stop = last;
            if (table_ != nullptr) {
                s = piece_at(radii[i], per_pixel);
                stop = end_of(s, radii, i, last, per_pixel);
            }
            if (table_ == nullptr || !by_table(s, stop - i)) {
                for (; i < stop; i += I::lanes) {
                    look();
                    alignas(64) double re[I::lanes], im[I::lanes];
                    for (std::size_t j = 0; j < I::lanes; ++j) {
                        sum(disk, radii[std::min(i + j, stop - 1)] * step, re[j], im[j]);
                    }
                    sink(i - first, load<V>(re), load<V>(im));
                }
                i = stop;
                continue;
            }
            alignas(64) double re[degree_count], im[degree_count];
            combine(isa, *table_->pieces[s], disk.terms, disk.re.data(), disk.im.data(), re, im);
            const V slope = splat<V>(2.0 * per_pixel), offset = splat<V>(-(2.0 * static_cast<double>(s) + 1.0));
            for (; i < stop; i += unroll * I::lanes) {
                // Two chains of multiply-adds a vector: enough vectors at once hide their latency.
                V x[unroll], a[unroll], b[unroll];
                for (std::size_t j = 0; j < unroll; ++j) {
                    x[j] = load<V>(radii + i + j * I::lanes) * slope + offset;
                    a[j] = splat<V>(re[degree_count - 1]);
                    b[j] = splat<V>(im[degree_count - 1]);
                }
                for (std::size_t k = degree_count - 1; k-- > 0;) {
                    const V r = splat<V>(re[k]), m = splat<V>(im[k]);
                    for (std::size_t j = 0; j < unroll; ++j) {
                        a[j] = a[j] * x[j] + r;
                        b[j] = b[j] * x[j] + m;
                    }
                }
                // What lies past the end of the piece is overwritten by the next.
                for (std::size_t j = 0; j < unroll; ++j) {
                    sink(i - first + j * I::lanes, a[j], b[j]);
                }
            }
            i = stop;
        }
    }

    // Without pieces, by the Bessel functions themselves: slower, for tolerances that no piece meets.
    void sum(const Disk& disk, double v, double& re, double& im) {
        transforms_.resize(disk.terms);
        legendre_transforms(v, disk.terms, transforms_.data(), bessel_);
        re = im = 0.0;
        for (std::size_t n = 0; n < disk.terms; ++n) {
            re += disk.re[n] * transforms_[n];
            im += disk.im[n] * transforms_[n];
        }
    }

    Disk outer_, inner_;
    double obscuration_ = 0.0, weight_ = 0.0;
    std::shared_ptr<const PieceTable> table_;
    // Pieces up to the reach; those that one radius is enough for; those for which there may be tables.
    std::size_t all_ = 1, leading_ = 0, end_ = 0;
    bool few_ = false;  // whether the series serves some radii
    SeriesScratch scratch_;
    double shrunk_by_ = 0.0;
    std::vector<double> shares_, inner_phase_, transforms_, bessel_;
    Amplitude inner_amplitude_;
    Doubles re_, im_;
};

struct ToleranceNotMet : std::runtime_error {
    double bound;
    explicit ToleranceNotMet(double reached) : std::runtime_error("tolerance not met"), bound(reached) {}
};

// (2 M e + e^2) / (M - e)^2: the error of I over its exact peak, from the error e of U and the computed peak M^2.
inline double relative_error(double peak, double field_error) {
    const double root = std::sqrt(peak), exact = root - field_error;
    return exact > 1e-150 ? field_error * (2.0 * root + field_error) / (exact * exact) : 1e300;
}

// The error of values divided by their own largest one, itself in error by `relative`.
inline double normalized_error(double relative) { return relative < 1.0 ? 2.0 * relative / (1.0 - relative) : 1e300; }

// What storing values of type T adds to their error over the peak. The sum of two squares, the scale and the product with it
// are six roundings to double at most; to float, if it is that, values are rounded once, or twice if they are divided by their
// largest one after they have been stored.
template <class T>
constexpr double storing(bool twice) {
    return 6.0 * unit_roundoff + (sizeof(T) == 4 ? (twice ? 2.0 : 1.0) * 5.9604644775390625e-08 : 0.0);
}
inline double stored(double relative, double storing) { return relative + (1.0 + relative) * storing; }

// Most PSFs have sup|U| above this; where one has not, the error is tightened after that was found.
inline double likely_peak(const Phase& phase, double obscuration) {
    return phase.amplitude->integral(obscuration) / (4.0 * phase.size() + 1.0);
}

inline double first_error(const Phase& phase, double obscuration, double tol) {
    return 0.4 * tol * likely_peak(phase, obscuration);
}

// The largest I on a scan of the radii that rays reach: a window may miss the peak, which for a defocused lens need not
// be on the axis.
inline double scanned_peak(const Phase& phase, double obscuration, double error) {
    const double blur = 4.0 + phase.blur();
    constexpr std::size_t samples = 512;
    Doubles radii(samples + widest_step), values(samples + widest_step);
    for (std::size_t i = 0; i < radii.size(); ++i) {
        radii[i] = static_cast<double>(i);
    }
    Field field;
    const double step = blur / samples;
    field.prepare(phase, 0, obscuration, {radii.data(), samples, step}, error);
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        field.evaluate(isa, radii.data(), 0, samples, step, [&](std::size_t i, auto re, auto im) LOMMEL_INLINE_LAMBDA {
            store(values.data() + i, re * re + im * im);
        });
    });
    return *std::max_element(values.begin(), values.begin() + samples);
}

struct Settled {
    double error, bound;  // asked of U, proven of U
    double relative;      // proven of I over the peak of the PSF
    double top, peak;     // largest I in the window; the peak, where that was looked for elsewhere
};

// Prepares `field` for some places, tightening the error until max|I - I_exact| / max I <= tol is proven, what storing
// adds included. `evaluate` computes the intensities of the window from the field and returns the largest, by which they will
// be divided if `normalize`.
template <class Evaluate>
Settled settle(Field& field, const Phase& phase, double obscuration, const Places& places, double tol, bool normalize,
               const Evaluate& evaluate, double storing = lommel::storing<double>(false)) {
    Settled s{first_error(phase, obscuration, tol), 0.0, 1e300, 0.0, 0.0};
    for (;; s.error *= 0.1) {
        look();
        s.bound = field.prepare(phase, 0, obscuration, places, s.error);
        s.top = s.peak = evaluate();
        s.relative = relative_error(s.peak, s.bound);
        s.relative = stored(normalize ? normalized_error(s.relative) : s.relative, storing);
        if (!normalize && s.relative > tol) {
            s.peak = std::max(s.peak, scanned_peak(phase, obscuration, s.error));
            s.relative = stored(relative_error(s.peak, s.bound), storing);
        }
        if (s.relative <= tol) {
            return s;
        }
        if (s.error < 8.0 * unit_roundoff) {
            throw ToleranceNotMet(s.relative);
        }
    }
}

}  // namespace lommel
