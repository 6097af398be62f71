// Legendre coefficients of a pupil function: beta_n = (2n+1) int_0^1 exp(i Phi(t)) P_n(2t - 1) dt, t the squared radius.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/bounds/amplitude.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// Gauss quadrature of Legendre coefficients: nodes t in [0, 1] and weighted Legendre polynomials P_n(2t - 1). By their
// symmetry about t = 1/2 half the nodes suffice: even n use sums of the pupil function at mirrored nodes, odd n differences.
struct LegendreRule {
    std::size_t half;    // number of nodes above 1/2, a multiple of 8
    std::size_t blocks;  // number of groups of 16 Legendre polynomials, 8 even and 8 odd ones
    Doubles upper, lower;  // nodes above 1/2, and their mirror images below
    Doubles even, odd;     // [block][node][lane]: (2n+1) P_n times the quadrature weight
    Doubles polynomials;   // [n - 1][node]: Legendre polynomials P_n at the upper nodes, for the phase
    static constexpr std::size_t most_terms = EllipsePolynomials::most;

    LegendreRule(std::size_t nodes, std::size_t terms)
        : half(nodes / 2), blocks((terms + 2 * row_lanes - 1) / (2 * row_lanes)), upper(half), lower(half),
          even(blocks * half * row_lanes), odd(even.size()), polynomials(most_terms * half) {
        std::vector<double> x(nodes), w(nodes), p(std::max(blocks * 2 * row_lanes, most_terms + 1));
        gauss_legendre(nodes, x.data(), w.data());
        for (std::size_t q = 0; q < half; ++q) {
            look();
            upper[q] = 0.5 * (1.0 + x[half + q]);
            lower[q] = 0.5 * (1.0 - x[half + q]);
            legendre_sequence(x[half + q], p.size(), p.data());
            for (std::size_t n = 1; n <= most_terms; ++n) {
                polynomials[(n - 1) * half + q] = p[n];
            }
            for (std::size_t n = 0; n < blocks * 2 * row_lanes; ++n) {
                const double value = (static_cast<double>(n) + 0.5) * w[half + q] * p[n];
                Doubles& side = n % 2 == 0 ? even : odd;
                side[((n / (2 * row_lanes)) * half + q) * row_lanes + n % (2 * row_lanes) / 2] = value;
            }
        }
    }

    bool is(std::size_t nodes, std::size_t terms) const {
        return 2 * half == nodes && blocks == (terms + 2 * row_lanes - 1) / (2 * row_lanes);
    }
    std::size_t bytes() const { return sizeof(double) * (even.size() + odd.size() + polynomials.size() + 2 * half); }

    static constexpr std::size_t most_bytes = std::size_t{32} << 20;
    // Get a rule from the cache, with its numbers of nodes and terms rounded up so that few rules are computed.
    static std::shared_ptr<const LegendreRule> get(std::size_t nodes, std::size_t terms) {
        const std::size_t n = round_up(nodes, nodes < 256 ? 16 : 64), k = round_up(terms, n <= 256 ? 16 : 64);
        return cache<LegendreRule>.get(n, k);
    }

   private:
    static std::size_t round_up(std::size_t n, std::size_t step) { return (n + step - 1) / step * step; }
};

// Buffers of one thread, which grow and are reused.
struct SeriesScratch {
    Doubles sum_re, sum_im, difference_re, difference_im;
};

// Compute beta_re and beta_im, the first `terms` Legendre coefficients of t^power A exp(i Phi), up to whole blocks of 16. t:
// squared pupil radius; A: amplitude; Phi: phase, the sum over n of phase[n - 1] P_n(2t - 1).
template <class I>
LOMMEL_INLINE void legendre_coefficients(I isa, const LegendreRule& rule, const double* phase, std::size_t phase_terms,
                                         const Amplitude& amplitude, std::size_t power, std::size_t terms, double* beta_re,
                                         double* beta_im, SeriesScratch& s) {
    using V = typename I::pack;
    const std::size_t half = rule.half;
    for (Doubles* v : {&s.sum_re, &s.sum_im, &s.difference_re, &s.difference_im}) {
        v->resize(std::max(v->size(), half));
    }
    for (std::size_t q = 0; q < half; q += I::lanes) {
        // parts: phase from Legendre polynomials of odd and of even order; the odd ones change sign at the mirrored nodes.
        V parts[2] = {splat<V>(0.0), splat<V>(0.0)};
        for (std::size_t k = 0; k < phase_terms; ++k) {
            parts[k % 2] = parts[k % 2] + splat<V>(phase[k]) * load<V>(&rule.polynomials[k * half + q]);
        }
        V up_re, up_im, down_re, down_im;
        sincos(isa, parts[1] + parts[0], up_im, up_re);
        sincos(isa, parts[1] - parts[0], down_im, down_re);
        if (!amplitude.uniform()) {
            double up[I::lanes], down[I::lanes];
            for (std::size_t i = 0; i < I::lanes; ++i) {
                up[i] = amplitude.at(rule.upper[q + i]);
                down[i] = amplitude.at(rule.lower[q + i]);
            }
            up_re = up_re * load<V>(up);
            up_im = up_im * load<V>(up);
            down_re = down_re * load<V>(down);
            down_im = down_im * load<V>(down);
        }
        for (std::size_t k = 0; k < power; ++k) {
            up_re = up_re * load<V>(&rule.upper[q]);
            up_im = up_im * load<V>(&rule.upper[q]);
            down_re = down_re * load<V>(&rule.lower[q]);
            down_im = down_im * load<V>(&rule.lower[q]);
        }
        store(&s.sum_re[q], up_re + down_re);
        store(&s.sum_im[q], up_im + down_im);
        store(&s.difference_re[q], up_re - down_re);
        store(&s.difference_im[q], up_im - down_im);
    }
    const std::size_t blocks = std::min(rule.blocks, (terms + 2 * row_lanes - 1) / (2 * row_lanes));
    for (std::size_t b = 0; b < blocks; ++b) {
        for (std::size_t lane = 0; lane < row_lanes; lane += I::lanes) {
            const double* even = &rule.even[b * half * row_lanes + lane];
            const double* odd = &rule.odd[b * half * row_lanes + lane];
            // Two nodes at a time, so that eight independent sums hide the latency of multiply-adds.
            V sums[2][4] = {};
            for (std::size_t q = 0; q < half; q += 2) {
                for (std::size_t j = 0; j < 2; ++j) {
                    const V e = load<V>(even + (q + j) * row_lanes), o = load<V>(odd + (q + j) * row_lanes);
                    sums[j][0] = sums[j][0] + e * splat<V>(s.sum_re[q + j]);
                    sums[j][1] = sums[j][1] + e * splat<V>(s.sum_im[q + j]);
                    sums[j][2] = sums[j][2] + o * splat<V>(s.difference_re[q + j]);
                    sums[j][3] = sums[j][3] + o * splat<V>(s.difference_im[q + j]);
                }
            }
            for (std::size_t c = 0; c < 4; ++c) {
                const V total = sums[0][c] + sums[1][c];
                double* to = (c % 2 == 0 ? beta_re : beta_im) + 2 * (b * row_lanes + lane) + c / 2;
                for (std::size_t i = 0; i < I::lanes; ++i) {
                    to[2 * i] = total[i];
                }
            }
        }
    }
}

}  // namespace lommel
