// Complex field of one pupil at given radii, from tabulated polynomials or by its Legendre series, with an error bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/radial/disk.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Radii at which a field is needed, in optical units: step * radii[i], i < count, ascending. Null `radii`: all radii up to `step`.
struct Places {
    const double* radii;
    std::size_t count;
    double step;

    Places(const double* at, std::size_t n, double scale) : radii(at), count(n), step(scale) {}
    Places(double reach) : radii(nullptr), count(0), step(reach) {}
    double reach() const { return count > 0 ? radii[count - 1] * step : radii == nullptr ? step : 0.0; }
};

// Complex field U(v) of a pupil, with or without obscuration. Contains the buffers of one thread, which grow and are reused.
class Field {
   public:
    // Prepare the field of t^power * pupil function, t: squared pupil radius, for an error of about `error`; returns its bound.
    double prepare(const Phase& phase, std::size_t power, double obscuration, const Places& places, double error) {
        const double reach = places.reach();
        // Neglect an obscuration below 1e-18 of the aperture's area: it changes the field by less than the field's rounding error.
        obscuration_ = obscuration < 1e-9 ? 0.0 : obscuration;
        const double area = obscuration_ * obscuration_;
        double bound = outer_.expand(phase, power, reach, RadialBudget::outer * error, scratch_) + radius_rounding(reach);
        weight_ = 0.0;
        if (area > 0.0) {
            // Expand the phase within the obscuration in Zernike polynomials of this smaller disk.
            weight_ = std::pow(area, static_cast<double>(power + 1));
            inner_phase_.assign(phase.terms + 1, 0.0);
            double lost = 0.0;
            for (std::size_t j = 0; j < phase.terms; ++j) {
                lost += smaller_.shrink(2 * j + 2, 0, obscuration_, phase.coefficients[j], phase.terms,
                                        [&](std::size_t k, double c) { inner_phase_[k / 2] += c; });
            }
            inner_amplitude_ = phase.amplitude->scaled(area);
            const Phase inner{inner_phase_.data() + 1, phase.terms, &inner_amplitude_};
            bound += weight_ * (inner_.expand(inner, power, obscuration_ * reach, RadialBudget::inner * error, scratch_) +
                                lost + radius_rounding(obscuration_ * reach) + 4.0 * unit_roundoff);
            inner_.turn(inner_phase_[0]);
        }
        const std::size_t terms = std::max(outer_.terms, area > 0.0 ? inner_.terms : 0);
        std::size_t width = 0;
        while (width < widths.size() && piece_error(widths[width]) * (1.0 + weight_) > RadialBudget::pieces * error) {
            ++width;
        }
        const double by_series = series_rounding(terms);
        table_ = nullptr;
        if (width < widths.size()) {
            const WantedPieces wanted = pieces_for(places, reach, widths[width], terms);
            table_ = wanted.end() > 0 ? piece_tables.get(width, wanted, terms) : nullptr;
        }
        if (table_ == nullptr) {
            return bound + (1.0 + weight_) * by_series;
        }
        const double by_table = unit_roundoff * table_->magnitude * (0.5 * static_cast<double>(terms) + 40.0);
        // Interpolation errors are relative to the truncated series, which is at most 1 + bound, as the field is at most 1.
        return bound +
               (1.0 + weight_) * ((1.0 + bound) * piece_error(table_->width) + std::max(by_table, few_ ? by_series : 0.0));
    }

    // Evaluate the field at the ascending radii step * radii[i], first <= i < last: call sink(i - first, re, im), with ascending
    // i, for each vector of values, which begins with radius i. Sink and radii need room for widest_step values past the last.
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
        evaluate_disk(isa, inner_, radii, first, last, obscuration_ * step, [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA {
            store(re + i, a * splat<V>(weight_));
            store(im + i, b * splat<V>(weight_));
        });
        evaluate_disk(isa, outer_, radii, first, last, step,
                      [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA { sink(i, a - load<V>(re + i), b - load<V>(im + i)); });
    }

    // Write the field at the radii radii[i] * step, first <= i < last, to re[i - first] and im[i - first].
    void values(const double* radii, std::size_t first, std::size_t last, double step, double* re, double* im) {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            evaluate(isa, radii, first, last, step, [&](std::size_t i, auto a, auto b) LOMMEL_INLINE_LAMBDA {
                store(re + i, a);
                store(im + i, b);
            });
        });
    }

   private:
    // Up to a radius of `near`, in optical units, each piece (interval) that contains a radius has a table, shared by all
    // calls. Farther out, only pieces with at least `crowd` radii have a table; at other radii the series is summed directly.
    static constexpr double near = 4096.0;
    static constexpr std::size_t crowd = degree_count;
    static constexpr std::size_t most_bytes = std::size_t{256} << 20;  // memory limit, in bytes, of the tables of one call

    std::size_t piece_at(double radius, double per_pixel) const {
        return std::min(static_cast<std::size_t>(radius * per_pixel), all_ - 1);
    }
    // Index of the first radius, after `first`, that is beyond interval (piece) s; per_pixel: pieces per unit of `radii`.
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
                // Each vector has two chains of multiply-adds; the chains of several vectors together hide their latency.
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
                // Vectors may extend past the end of a piece; the next piece overwrites the values beyond this end.
                for (std::size_t j = 0; j < unroll; ++j) {
                    sink(i - first + j * I::lanes, a[j], b[j]);
                }
            }
            i = stop;
        }
    }

    // Sum the Legendre series at a radius v by Bessel functions: slower than pieces, for few radii or very small tolerances.
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
    std::size_t all_ = 1;      // number of intervals (pieces) up to the largest radius
    std::size_t leading_ = 0;  // number of innermost pieces, which have tables even for a single radius
    std::size_t end_ = 0;      // end of the range of pieces that may have a table
    bool few_ = false;  // the series is summed directly at some radii
    SeriesScratch scratch_;
    SmallerDisk smaller_;
    std::vector<double> inner_phase_, transforms_, bessel_;
    Amplitude inner_amplitude_;
    Doubles re_, im_;
};

}  // namespace lommel
