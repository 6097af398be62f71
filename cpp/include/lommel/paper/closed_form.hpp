// Closed form for the field of a circular pupil (docs/paper.md), as printed or refined. J0 is a power series up to a transition,
// and an asymptotic form beyond it. In the latter, phase and amplitude of the integrand are quadratic on intervals of the pupil
// radius, and each interval contributes end-point terms and a Fresnel integral.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstring>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/chirp.hpp"
#include "lommel/special/fresnel.hpp"
#include "lommel/special/legendre.hpp"

namespace lommel {

// Pieces (intervals of the pupil radius R = 0 .. 1) of the phases Phi of a stack of pupils. On edges[i] <= R < edges[i + 1], Phi is
// about alpha R^2 + beta R plus a constant; turns: 2 exp(i constant). alpha, beta, turns: [pupil][piece].
struct PhasePieces {
    const double *edges, *alpha, *beta;
    const std::complex<double>* turns;
    std::size_t count;
};

// Asymptotic form x J0(x) ~ Re[(c0 + c1 x + c2 x^2) e^{i (x - pi/4)}] for x from starts[i] to starts[i + 1], the last piece without
// end. Below starts[0], J0 is the first `terms` terms of its power series.
struct BesselExponentials {
    const double* starts;
    const std::complex<double>* coefficients;  // c0, c1, c2 of each piece
    std::size_t count, terms;
};

// Evaluation of the Fresnel integral: by the table, if it has samples; else by a series of `terms` terms or, if terms = 0, to full
// double precision.
struct FresnelForm {
    std::size_t terms;
    FresnelTable table;
};

template <class V>
LOMMEL_INLINE double largest_lane(V v) {
    double top = v[0];
    for (std::size_t i = 1; i < sizeof(V) / sizeof(double); ++i) {
        top = std::max(top, static_cast<double>(v[i]));
    }
    return top;
}

template <class Auxiliary>
class ClosedFormField {
   public:
    ClosedFormField(const BesselExponentials& bessel, const Auxiliary& auxiliary)
        : bessel_(bessel), auxiliary_(auxiliary), series_(bessel.terms, 1.0) {
        for (std::size_t m = 1; m < series_.size(); ++m) {
            series_[m] = series_[m - 1] / static_cast<double>(m * m);
        }
    }

    template <class I>
    LOMMEL_INLINE void operator()(I isa, const PhasePieces& phase, typename I::pack v, typename I::pack& re,
                                  typename I::pack& im) const {
        using V = typename I::pack;
        const V zero = splat<V>(0.0), turn = splat<V>(1.0) / larger(v, splat<V>(1e-300));
        const V split = smaller(splat<V>(bessel_.starts[0]) * turn, splat<V>(1.0));
        const double inner = largest_lane(split), outer = -largest_lane(zero - split);
        re = im = zero;
        std::size_t piece = 0;
        for (std::size_t i = 0; i < phase.count; ++i) {
            const V low = splat<V>(phase.edges[i]), high = splat<V>(phase.edges[i + 1]);
            const auto within = [&](V x) LOMMEL_INLINE_LAMBDA { return smaller(larger(x, low), high); };
            V a = zero, b = zero;
            if (phase.edges[i] < inner) {
                add_series(isa, phase.alpha[i], phase.beta[i], v, low, within(split), a, b);
            }
            // Lanes (radii v) may need different pieces of the asymptotic form of J0: go back to the first piece that a lane needs.
            // The next loop goes on to the last.
            while (piece > 0 && largest_lane(splat<V>(bessel_.starts[piece]) * turn) > phase.edges[i]) {
                --piece;
            }
            for (V from = within(split); outer < phase.edges[i + 1];) {
                const bool last = piece + 1 == bessel_.count;
                const V to = last ? high : within(splat<V>(bessel_.starts[piece + 1]) * turn);
                if (largest_lane(to - from) > 0.0) {
                    add_waves(isa, phase.alpha[i], phase.beta[i], v, turn, bessel_.coefficients + 3 * piece, from, to, a, b);
                }
                if (largest_lane(high - to) <= 0.0) {
                    break;
                }
                from = to;
                ++piece;
            }
            const V c = splat<V>(phase.turns[i].real()), s = splat<V>(phase.turns[i].imag());
            re = re + (c * a - s * b);
            im = im + (s * a + c * b);
        }
    }

   private:
    template <std::size_t count>
    struct Rule {
        std::array<double, count> nodes, weights;
        Rule() { gauss_legendre(count, nodes.data(), weights.data()); }
    };

    // Add the integral over pupil radii R from `low` to `high`, where v R is below the transition, by Gauss quadrature with the
    // power series of J0 on panels of at most 4 rad; if the phase hardly varies and the series is short, by one short rule.
    template <class I>
    LOMMEL_INLINE void add_series(I isa, double alpha, double beta, typename I::pack v, typename I::pack low,
                                  typename I::pack high, typename I::pack& re, typename I::pack& im) const {
        using V = typename I::pack;
        const V rate = splat<V>(std::abs(alpha)) * (low + high) + splat<V>(std::abs(beta));
        const double turn = largest_lane(rate * (high - low)), span = largest_lane((rate + v) * (high - low));
        if (!(span <= 4.0 * (max_phase + max_reach))) {
            throw LimitExceeded("phases and radii this large take more panels of quadrature than there may be");
        }
        if (turn < 0.1 && series_.size() <= 3) {
            return add_panels(isa, few_, 1, alpha, beta, v, low, high, re, im);
        }
        add_panels(isa, many_, static_cast<std::size_t>(span / 4.0) + 1, alpha, beta, v, low, high, re, im);
    }
    template <class I, std::size_t count>
    LOMMEL_INLINE void add_panels(I isa, const Rule<count>& rule, std::size_t panels, double alpha, double beta,
                                  typename I::pack v, typename I::pack low, typename I::pack high, typename I::pack& re,
                                  typename I::pack& im) const {
        using V = typename I::pack;
        const V half = splat<V>(0.5 / static_cast<double>(panels)) * (high - low), q = splat<V>(-0.25) * v * v;
        Glance glance;
        for (std::size_t p = 0; p < panels; ++p) {
            glance(64 * count);
            const V middle = low + splat<V>(static_cast<double>(2 * p + 1)) * half;
            for (std::size_t k = 0; k < count; ++k) {
                const V r = middle + half * splat<V>(rule.nodes[k]), square = q * r * r;
                V sine, cosine, sum = splat<V>(series_.back());
                sincos(isa, (splat<V>(alpha) * r + splat<V>(beta)) * r, sine, cosine);
                for (std::size_t m = series_.size() - 1; m-- > 0;) {
                    sum = sum * square + splat<V>(series_[m]);
                }
                sum = sum * r * half * splat<V>(rule.weights[k]);
                re = re + sum * cosine;
                im = im + sum * sine;
            }
        }
    }

    // Add the integral over pupil radii R from `low` to `high`, where x = v R is above the transition; turn: 1 / v. The factor
    // R J0(v R) is x J0(x) / v, and x J0(x), with coefficients c, is half the sum of a wave in e^{i (x - pi/4)} and its conjugate.
    template <class I>
    LOMMEL_INLINE void add_waves(I isa, double alpha, double beta, typename I::pack v, typename I::pack turn,
                                 const std::complex<double>* c, typename I::pack low, typename I::pack high,
                                 typename I::pack& re, typename I::pack& im) const {
        using V = typename I::pack;
        const V slopes[2] = {splat<V>(beta) + v, splat<V>(beta) - v}, scale = splat<V>(0.5) * turn;
        ChirpMoments<I> moments[2];
        chirp_moments(isa, auxiliary_, alpha, slopes, low, high, moments);
        const std::complex<double> eighth(0.70710678118654752440, -0.70710678118654752440);
        V power = scale;
        for (int m = 0; m < 3; ++m) {
            const std::complex<double> factor = eighth * c[m];
            const V x = splat<V>(factor.real()) * power, y = splat<V>(factor.imag()) * power;
            re = re + (x * (moments[0].re[m] + moments[1].re[m]) - y * (moments[0].im[m] - moments[1].im[m]));
            im = im + (x * (moments[0].im[m] + moments[1].im[m]) + y * (moments[0].re[m] - moments[1].re[m]));
            power = power * v;
        }
    }

    BesselExponentials bessel_;
    const Auxiliary& auxiliary_;
    std::vector<double> series_;  // [m]: 1 / m!^2, of the power series of J0
    const Rule<6> few_;
    const Rule<12> many_;
};

// Call use(auxiliary) with the auxiliary functions of the Fresnel integral, evaluated as `form` says.
template <class Use>
void with_auxiliary(const FresnelForm& form, const Use& use) {
    if (form.table.samples > 0) {
        use(form.table);
    } else if (form.terms > 0) {
        use(FresnelSeries{form.terms});
    } else {
        use(*FresnelAuxiliary::get());
    }
}

// Load a vector of values from values[first] on; lanes without a value, from values[last] on, repeat values[last - 1].
template <class I>
LOMMEL_INLINE typename I::pack lanes_from(const double* values, std::size_t first, std::size_t last) {
    if (first + I::lanes <= last) {
        return load<typename I::pack>(values + first);
    }
    alignas(64) double lanes[I::lanes];
    for (std::size_t i = 0; i < I::lanes; ++i) {
        lanes[i] = values[std::min(first + i, last - 1)];
    }
    return load<typename I::pack>(lanes);
}
template <class I>
LOMMEL_INLINE void store_lanes(typename I::pack re, typename I::pack im, std::size_t count, std::complex<double>* to) {
    alignas(64) double lanes[2 * I::lanes];
    for (std::size_t i = 0; i < I::lanes; ++i) {
        lanes[2 * i] = re[i];
        lanes[2 * i + 1] = im[i];
    }
    std::memcpy(to, lanes, std::min(count, I::lanes) * sizeof *to);
}

// Moments m = 0, 1, 2 of chirps: out[m * count + i] = integral from low[i] to high[i] of R^m exp(i (a R^2 + b[i] R)) dR.
inline void chirp_moments(const FresnelForm& form, double a, const double* b, const double* low, const double* high,
                          std::size_t count, std::complex<double>* out) {
    // Portable instructions suffice: images do not use this function.
    using I = Portable;
    with_auxiliary(form, [&](const auto& auxiliary) {
        for (std::size_t i = 0; i < count; i += I::lanes) {
            const typename I::pack slope[1] = {lanes_from<I>(b, i, count)};
            ChirpMoments<I> moments[1];
            chirp_moments(I{}, auxiliary, a, slope, lanes_from<I>(low, i, count), lanes_from<I>(high, i, count), moments);
            for (std::size_t m = 0; m < 3; ++m) {
                store_lanes<I>(moments[0].re[m], moments[0].im[m], count - i, out + m * count + i);
            }
        }
    });
}

// Field 2 int_0^1 exp(i Phi) J0(v R) R dR at `count` image radii v, ascending, with the pupil's phase Phi(R): out[pupil][radius].
inline void closed_form_fields(const PhasePieces& phase, std::size_t pupils, const BesselExponentials& bessel,
                               const FresnelForm& form, const double* v, std::size_t count, int threads,
                               std::complex<double>* out) {
    constexpr std::size_t block = 128;
    const std::size_t blocks = (count + block - 1) / block;
    const double work = static_cast<double>(pupils * count * (phase.count + bessel.count - 1));
    with_auxiliary(form, [&](const auto& auxiliary) {
        const ClosedFormField field(bessel, auxiliary);
        // Estimated work: 0.1 microseconds for each radius and piece.
        parallel_for(pupils * blocks, worthwhile_threads(threads, 0.1 * work), [&](std::size_t, std::size_t task) {
            const std::size_t pupil = task / blocks, first = task % blocks * block, last = std::min(count, first + block);
            const PhasePieces own{phase.edges, phase.alpha + pupil * phase.count, phase.beta + pupil * phase.count,
                                  phase.turns + pupil * phase.count, phase.count};
            dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
                using I = decltype(isa);
                for (std::size_t i = first; i < last; i += I::lanes) {
                    look();
                    typename I::pack re, im;
                    field(isa, own, lanes_from<I>(v, i, last), re, im);
                    store_lanes<I>(re, im, last - i, out + pupil * count + i);
                }
            });
        });
    });
}

// Field at n radii v in ascending order, out[pupil][radius], from `count` polynomials of `terms` coefficients each, on intervals of
// length `width` from `start` on. The variable of a polynomial goes from -1 to 1 over its interval.
inline void polynomial_fields(const std::complex<double>* pieces, std::size_t pupils, std::size_t count, std::size_t terms,
                              double start, double width, const double* v, std::size_t n, int threads,
                              std::complex<double>* out) {
    const double work = 3e-3 * static_cast<double>(pupils * n);  // microseconds
    parallel_for(pupils * count, worthwhile_threads(threads, work), [&](std::size_t, std::size_t task) {
        const std::size_t s = task % count;
        const std::complex<double>* const c = pieces + task * terms;
        const auto place = [&](std::size_t piece) {
            const double begin = start + static_cast<double>(piece) * width;
            return static_cast<std::size_t>(std::lower_bound(v, v + n, begin) - v);
        };
        const std::size_t first = s > 0 ? place(s) : 0, last = s + 1 < count ? place(s + 1) : n;
        std::complex<double>* const to = out + task / count * n;
        dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using I = decltype(isa);
            using V = typename I::pack;
            const V middle = splat<V>(start + (static_cast<double>(s) + 0.5) * width), slope = splat<V>(2.0 / width);
            for (std::size_t i = first; i < last; i += I::unroll * I::lanes) {
                // Each vector needs two chains of multiply-adds; several vectors at once hide their latency.
                V x[I::unroll], re[I::unroll], im[I::unroll];
                for (std::size_t j = 0; j < I::unroll; ++j) {
                    x[j] = (lanes_from<I>(v, i + j * I::lanes, last) - middle) * slope;
                    re[j] = splat<V>(c[terms - 1].real());
                    im[j] = splat<V>(c[terms - 1].imag());
                }
                for (std::size_t k = terms - 1; k-- > 0;) {
                    const V a = splat<V>(c[k].real()), b = splat<V>(c[k].imag());
                    for (std::size_t j = 0; j < I::unroll; ++j) {
                        re[j] = re[j] * x[j] + a;
                        im[j] = im[j] * x[j] + b;
                    }
                }
                for (std::size_t j = 0; j < I::unroll && i + j * I::lanes < last; ++j) {
                    store_lanes<I>(re[j], im[j], last - i - j * I::lanes, to + i + j * I::lanes);
                }
            }
        });
    });
}

}  // namespace lommel
