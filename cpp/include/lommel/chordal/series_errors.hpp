// Error bounds of quadrature along chords for amplitude series, from bounds on complex curves (docs/certificate.md, section 16).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// Bounds on parts (ranges of terms) of amplitude series. series: number of series times planes; parts: number of parts of each
// series; curves: number of complex curves.
struct SeriesSizes {
    std::size_t series, parts, curves;
    double *on_curves, *moduli;  // bounds on a complex curve, [series][part][curve]; on the real disk, [series][part]

    // Compute on_curves and moduli, and half the number of chords (i = 0) or of nodes per chord (i = 1) that make the error small
    // enough: needed[i] = min over curves of (log(largest on_curves) * rate[curve] + chosen[i][curve]). The error bound with n
    // chords or nodes is on_curves * C * exp(-2 n b) on a curve: rate = 1 / (4 b), chosen = log(C / requested error) / (4 b).
    // ends[part]: index after the last term of a part; powers[term][curve]: bound on a term of coefficient 1.
    void sum(Level level, const std::complex<double>* coefficients, const std::vector<std::size_t>& ends, const double* powers,
             const double* rate, const double* chosen, double (&needed)[2]) const {
        const std::size_t total = ends.back();
        std::vector<double> top(curves, 0.0);
        dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
            for (std::size_t s = 0; s < series; ++s) {
                for (std::size_t part = 0, term = 0; part < parts; ++part) {
                    double *const to = on_curves + (s * parts + part) * curves, *const largest = top.data();
                    double all = 0.0;
                    std::fill_n(to, curves, 0.0);
                    for (; term < ends[part]; ++term) {
                        const std::complex<double> c = coefficients[s * total + term];
                        const double size = std::sqrt(c.real() * c.real() + c.imag() * c.imag());
                        const double* power = powers + term * curves;
                        all += size;
                        for (std::size_t b = 0; b < curves; ++b) {
                            to[b] += size * power[b];
                        }
                    }
                    moduli[s * parts + part] = all;
                    for (std::size_t b = 0; b < curves; ++b) {
                        largest[b] = to[b] > largest[b] ? to[b] : largest[b];
                    }
                }
            }
        });
        needed[0] = needed[1] = std::numeric_limits<double>::infinity();
        for (std::size_t b = 0; b < curves; ++b) {
            const double grown = std::log(top[b] + 1e-300) * rate[b];
            needed[0] = std::min(needed[0], grown + chosen[b]);
            needed[1] = std::min(needed[1], grown + chosen[curves + b]);
        }
    }

    // Compute error bounds field_errors[set][plane][field]: sums over parts of shares[field][part] * e, with e the error of a part:
    // e = (min over curves of on_curves * chords[set][curve]) + (min over curves of on_curves * nodes[set][curve])
    //     + left[set] + rounding[set] * moduli + error.
    // chords, nodes: error bounds of the sums over chords and over nodes if on_curves = 1; left: truncation error; rounding: error
    // if moduli = 1; error: that of the amplitude series. of[set]: index of the set's series, whose on_curves and moduli in the
    // plane are taken.
    void errors(const std::int32_t* of, std::size_t sets, std::size_t planes, const double* chords, const double* nodes,
                const double* left, const double* rounding, const double* shares, std::size_t fields, double error,
                double* field_errors) const {
        std::fill_n(field_errors, sets * planes * fields, 0.0);
        for (std::size_t set = 0; set < sets; ++set) {
            for (std::size_t plane = 0; plane < planes; ++plane) {
                const std::size_t from = (static_cast<std::size_t>(of[set]) * planes + plane) * parts;
                for (std::size_t part = 0; part < parts; ++part) {
                    const double* size = on_curves + (from + part) * curves;
                    double by[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
                    for (std::size_t b = 0; b < curves; ++b) {
                        by[0] = std::min(by[0], size[b] * chords[set * curves + b]);
                        by[1] = std::min(by[1], size[b] * nodes[set * curves + b]);
                    }
                    const double off = by[0] + by[1] + left[set] + rounding[set] * moduli[from + part] + error;
                    for (std::size_t field = 0; field < fields; ++field) {
                        field_errors[(set * planes + plane) * fields + field] += shares[field * parts + part] * off;
                    }
                }
            }
        }
    }
};

// Error bounds errors[set][plane] of the intensity sum |E|^2 (first set) and of its derivatives (other sets), from the error bounds
// field_errors[set][plane][field] and largest moduli largest[set][plane][field] of the fields.
inline void light_errors(const double* field_errors, const double* largest, std::size_t sets, std::size_t planes,
                         std::size_t fields, double* errors) {
    constexpr double unit = 0x1p-53;
    for (std::size_t i = 0; i < sets * planes; ++i) {
        const double *const off = field_errors + i * fields, *const top = largest + i * fields;
        const double *const own = field_errors + i % planes * fields, *const own_top = largest + i % planes * fields;
        double sum = 0.0;
        for (std::size_t c = 0; c < fields; ++c) {
            sum += i < planes
                       ? off[c] * (2.0 * top[c] + off[c]) + 32.0 * unit * top[c] * top[c]
                       : 2.0 * (own[c] * top[c] + off[c] * own_top[c] + own[c] * off[c]) + 32.0 * unit * own_top[c] * top[c];
        }
        errors[i] = sum;
    }
}

// Divide `count` values by `by`, in place; return the largest modulus of a quotient.
inline double divide(Level level, double by, std::size_t count, double* values) {
    double top = 0.0;
    dispatch(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        using V = typename decltype(isa)::pack;
        constexpr std::size_t lanes = decltype(isa)::lanes;
        const V divisor = splat<V>(by);
        V low = splat<V>(0.0), high = low;
        std::size_t k = 0;
        for (; k + lanes <= count; k += lanes) {
            const V value = load<V>(values + k) / divisor;
            store(values + k, value);
            low = larger(low, splat<V>(0.0) - value), high = larger(high, value);
        }
        for (; k < count; ++k) {
            values[k] /= by;
            top = std::max(top, std::abs(values[k]));
        }
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            top = std::max({top, low[lane], high[lane]});
        }
    });
    return top;
}

}  // namespace lommel
