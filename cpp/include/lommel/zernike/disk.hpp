// Zernike coefficients of the pupil function: P = sum over n, m of R_n^m(rho) (c cos(m theta) + s sin(m theta)).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/radial_polynomials.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// Phase of one pupil: coefficients, radians at the edge, of terms; and its amplitude.
struct ZernikePhase {
    const TermPairs& list;
    const double* coefficients;
    Amplitude amplitude;

    // Calls f(amplitude, n, |m|) for every pair of cosine and sine.
    template <class F>
    void amplitudes(const F& f) const {
        for (const TermPairs::Pair& pair : list.pairs) {
            f(std::sqrt(pair.square(coefficients)), pair.n, pair.m);
        }
    }

    double size() const {
        double sum = 0.0;
        amplitudes([&](double amplitude, std::size_t, std::size_t) { sum += amplitude; });
        return sum;
    }

    // What roundings of rho and of the recurrences do to the phase, in units of roundoff.
    double sensitivity() const {
        double sum = 0.0;
        amplitudes([&](double a, std::size_t degree, std::size_t) { sum += a * (3.0 * static_cast<double>(degree) + 6.0); });
        return sum + amplitude.sensitivity();
    }

    DiskBounds bounds() const {
        DiskBounds bounds;
        amplitudes([&](double amplitude, std::size_t degree, std::size_t order) { bounds.add(amplitude, degree, order); });
        bounds.add(amplitude);
        return bounds;
    }
};

// A product rule on the disk, exact for polynomials up to a degree: Gauss nodes in t = rho^2, equal angles off the axes, so that
// one quadrant of angles serves all four. Shared by all calls.
struct DiskRule {
    std::size_t degree;   // up to which it is exact
    std::size_t rings;    // a multiple of 8
    std::size_t quarter;  // angles in a quadrant, a multiple of 8
    std::size_t orders;   // azimuthal orders there are tables for
    Doubles t, rho, weights;
    // cos and sin of m theta, of even m and of odd m: [angle][m / 2], as the transform reads them.
    Doubles cosines[2], sines[2];

    DiskRule(std::size_t exact, std::size_t order_count)
        : degree(exact), rings((exact / 4 + 1 + 7) / 8 * 8), quarter((exact / 4 + 1 + 7) / 8 * 8),
          orders((order_count + 31) / 32 * 32), t(rings), rho(rings), weights(rings) {
        std::vector<double> x(rings), w(rings);
        gauss_legendre(rings, x.data(), w.data());
        for (std::size_t k = 0; k < rings; ++k) {
            t[k] = 0.5 * (1.0 + x[k]);
            rho[k] = std::sqrt(t[k]);
            weights[k] = 0.5 * w[k];
        }
        for (std::size_t parity = 0; parity < 2; ++parity) {
            cosines[parity].resize(orders / 2 * quarter);
            sines[parity].resize(orders / 2 * quarter);
        }
        for (std::size_t m = 0; m < orders; ++m) {
            look();
            for (std::size_t i = 0; i < quarter; ++i) {
                cosines[m % 2][i * (orders / 2) + m / 2] = std::cos(angle(m, i));
                sines[m % 2][i * (orders / 2) + m / 2] = std::sin(angle(m, i));
            }
        }
    }

    // m theta at angle i, modulo a turn, exactly.
    double angle(std::size_t m, std::size_t i) const {
        return 3.14159265358979323846 / static_cast<double>(4 * quarter) * static_cast<double>(m * (2 * i + 1) % (8 * quarter));
    }

    bool is(std::size_t exact, std::size_t order_count) const { return degree == exact && orders >= order_count; }
    std::size_t bytes() const { return sizeof(double) * (2 * orders * quarter + 3 * rings); }

    static constexpr std::size_t most_bytes = std::size_t{64} << 20;
    // With the degree rounded up to what eight more rings allow, so that a little more aberration does not mean new tables.
    static std::shared_ptr<const DiskRule> get(std::size_t exact, std::size_t order_count) {
        return cache<DiskRule>.get((exact + 35) / 32 * 32 - 4, order_count);
    }
};

// Coefficients of all degrees n < degrees of the azimuthal orders m < orders, those of one order together: n = m, m + 2, ...
struct ZernikeSeries {
    std::size_t degrees = 0, orders = 0;
    std::vector<std::size_t> start;  // of each order
    std::vector<std::size_t> used;   // how many of its coefficients matter
    std::array<Doubles, 4> parts;    // of cosines re and im, of sines re and im

    std::size_t count(std::size_t m) const { return (degrees - 1 - m) / 2 + 1; }
    // The magnitude of a coefficient, of the cosine or the sine.
    double size(std::size_t at, std::size_t sine) const {
        const double re = parts[2 * sine][at], im = parts[2 * sine + 1][at];
        return std::sqrt(re * re + im * im);
    }

    void resize(std::size_t n, std::size_t order_count) {
        degrees = n;
        orders = order_count;
        start.resize(orders);
        used.resize(orders);
        std::size_t total = 0;
        for (std::size_t m = 0; m < orders; ++m) {
            start[m] = total;
            used[m] = count(m);
            total += count(m);
        }
        for (Doubles& part : parts) {
            part.resize(total);
        }
    }
};

class ZernikeAnalysis {
   public:
    // Fills `series` with the coefficients times (-1)^(n/2) (-i)^n, what zernike_transforms() leaves to them.
    template <class I>
    LOMMEL_INLINE void run(I isa, const DiskRule& rule, const ZernikePhase& phase, std::size_t degrees, std::size_t orders,
                           ZernikeSeries& series) {
        series.resize(degrees, orders);
        evaluate(isa, rule, phase);
        transform(isa, rule, orders);
        project(isa, rule, series);
    }

   private:
    // The pupil function folded over the four quadrants: [ring][cos even, sin even, cos odd, sin odd][re, im][angle], times
    // the ring's weight.
    template <class I>
    LOMMEL_INLINE void evaluate(I isa, const DiskRule& rule, const ZernikePhase& phase) {
        using V = typename I::pack;
        const std::size_t q = rule.quarter, rings = rule.rings;
        folded_.resize(rings * 8 * q);
        orders_.clear();
        for (const TermPairs::Pair& pair : phase.list.pairs) {
            if (std::find(orders_.begin(), orders_.end(), pair.m) == orders_.end()) {
                orders_.push_back(pair.m);
            }
        }
        turns_.resize(2 * orders_.size() * q);
        for (std::size_t g = 0; g < orders_.size(); ++g) {
            for (std::size_t i = 0; i < q; ++i) {
                turns_[2 * g * q + i] = std::cos(rule.angle(orders_[g], i));
                turns_[(2 * g + 1) * q + i] = std::sin(rule.angle(orders_[g], i));
            }
        }
        radial_.assign(2 * orders_.size() * rings, 0.0);
        for (std::size_t j = 0; j < phase.list.terms.size(); ++j) {
            const ZernikeTerm& term = phase.list.terms[j];
            const std::size_t m = static_cast<std::size_t>(std::abs(term.m));
            const std::size_t at = static_cast<std::size_t>(std::find(orders_.begin(), orders_.end(), m) - orders_.begin());
            double* to = &radial_[(2 * at + (term.m < 0 ? 1 : 0)) * rings];
            const V c = splat<V>(phase.coefficients[j]);
            for (std::size_t k = 0; k < rings; k += I::lanes) {
                const V t = load<V>(&rule.t[k]), x = t + t - splat<V>(1.0);
                V here = power(isa, rule, k, m), before = here;
                for (std::size_t i = 0; i < (static_cast<std::size_t>(term.n) - m) / 2; ++i) {
                    advance(RadialStep<double>(i, static_cast<double>(m)), x, before, here);
                }
                store(to + k, load<V>(to + k) + c * here);
            }
        }
        for (std::size_t k = 0; k < rings; ++k) {
            look();
            double* out = &folded_[k * 8 * q];
            // Each angle stands for four, and the mean over all is wanted.
            const double size = phase.amplitude.at(rule.t[k]) * rule.weights[k] * 0.25 / static_cast<double>(q);
            for (std::size_t i = 0; i < q; i += I::lanes) {
                V even_cos = splat<V>(0.0), odd_cos = even_cos, even_sin = even_cos, odd_sin = even_cos;
                for (std::size_t g = 0; g < orders_.size(); ++g) {
                    const V c = load<V>(&turns_[2 * g * q + i]) * splat<V>(radial_[2 * g * rings + k]);
                    const V s = load<V>(&turns_[(2 * g + 1) * q + i]) * splat<V>(radial_[(2 * g + 1) * rings + k]);
                    if (orders_[g] % 2 == 0) {
                        even_cos = even_cos + c;
                        even_sin = even_sin + s;
                    } else {
                        odd_cos = odd_cos + c;
                        odd_sin = odd_sin + s;
                    }
                }
                // theta, -theta, pi - theta, pi + theta
                const V angle[4] = {even_cos + odd_cos + even_sin + odd_sin, even_cos + odd_cos - even_sin - odd_sin,
                                    even_cos - odd_cos - even_sin + odd_sin, even_cos - odd_cos + even_sin - odd_sin};
                V part[2][4];
                for (std::size_t j = 0; j < 4; ++j) {
                    sincos(isa, angle[j], part[1][j], part[0][j]);
                }
                for (std::size_t c = 0; c < 2; ++c) {
                    const V *p = part[c], s = splat<V>(size);
                    const V near = p[0] + p[1], far = p[2] + p[3], near_odd = p[0] - p[1], far_odd = p[3] - p[2];
                    store(out + (0 + c) * q + i, (near + far) * s);
                    store(out + (2 + c) * q + i, (near_odd + far_odd) * s);
                    store(out + (4 + c) * q + i, (near - far) * s);
                    store(out + (6 + c) * q + i, (near_odd - far_odd) * s);
                }
            }
        }
    }

    // Azimuthal Fourier coefficients of every ring, [m][cos re, cos im, sin re, sin im][ring]. Four rings and a vector of orders
    // at a time: sixteen chains of multiply-adds, bound by these.
    template <class I>
    LOMMEL_INLINE void transform(I, const DiskRule& rule, std::size_t orders) {
        using V = typename I::pack;
        constexpr std::size_t together = 4;
        const std::size_t q = rule.quarter, rings = rule.rings, stride = rule.orders / 2;
        rings_.resize((orders + 2 * I::lanes) * 4 * rings);
        for (std::size_t parity = 0; parity < 2; ++parity) {
            for (std::size_t k = 0; k < rings; k += together) {
                look();
                const double* in = &folded_[k * 8 * q + parity * 4 * q];
                for (std::size_t first = 0; 2 * first + parity < orders; first += I::lanes) {
                    const double *c = &rule.cosines[parity][first], *s = &rule.sines[parity][first];
                    V sums[together][4] = {};
                    for (std::size_t i = 0; i < q; ++i) {
                        const V a = load<V>(c + i * stride), b = load<V>(s + i * stride);
                        for (std::size_t r = 0; r < together; ++r) {
                            const double* from = in + r * 8 * q + i;
                            sums[r][0] = sums[r][0] + a * splat<V>(from[0]);
                            sums[r][1] = sums[r][1] + a * splat<V>(from[q]);
                            sums[r][2] = sums[r][2] + b * splat<V>(from[2 * q]);
                            sums[r][3] = sums[r][3] + b * splat<V>(from[3 * q]);
                        }
                    }
                    for (std::size_t lane = 0; lane < I::lanes; ++lane) {
                        const std::size_t m = 2 * (first + lane) + parity;
                        const double twice = m == 0 ? 1.0 : 2.0;
                        for (std::size_t r = 0; r < together; ++r) {
                            for (std::size_t j = 0; j < 4; ++j) {
                                rings_[(m * 4 + j) * rings + k + r] = twice * sums[r][j][lane];
                            }
                        }
                    }
                }
            }
        }
    }

    template <class I>
    LOMMEL_INLINE void project(I isa, const DiskRule& rule, ZernikeSeries& series) {
        using V = typename I::pack;
        const std::size_t rings = rule.rings;
        constexpr std::size_t most = 64;  // vectors of rings whose recurrences are kept
        for (std::size_t m = 0; m < series.orders; ++m) {
            look();
            const double* in = &rings_[m * 4 * rings];
            const std::size_t count = series.count(m), to = series.start[m];
            for (Doubles& part : series.parts) {
                std::fill_n(&part[to], count, 0.0);
            }
            for (std::size_t first = 0; first < rings; first += most * I::lanes) {
                const std::size_t packs = std::min(most, (rings - first) / I::lanes);
                V x[most], before[most], here[most];
                for (std::size_t p = 0; p < packs; ++p) {
                    const V t = load<V>(&rule.t[first + p * I::lanes]);
                    x[p] = t + t - splat<V>(1.0);
                    before[p] = here[p] = power(isa, rule, first + p * I::lanes, m);
                }
                for (std::size_t j = 0; j < count; ++j) {
                    V sums[4] = {};
                    const RadialStep<double> step(j, static_cast<double>(m));
                    for (std::size_t p = 0; p < packs; ++p) {
                        for (std::size_t c = 0; c < 4; ++c) {
                            sums[c] = sums[c] + here[p] * load<V>(in + c * rings + first + p * I::lanes);
                        }
                        advance(step, x[p], before[p], here[p]);
                    }
                    // Of odd orders times -i.
                    const double norm = static_cast<double>(m + 2 * j + 1), turned = m % 2 == 0 ? norm : -norm;
                    for (std::size_t c = 0; c < 4; ++c) {
                        series.parts[c][to + j] += (c % 2 == 0 ? norm : turned) * lane_sum(sums[c ^ m % 2]);
                    }
                }
            }
        }
    }

    template <class V>
    static LOMMEL_INLINE void advance(const RadialStep<double>& step, V x, V& before, V& here) {
        const V after = (splat<V>(step.slope) * x + splat<V>(step.shift)) * here - splat<V>(step.back) * before;
        before = here;
        here = after;
    }

    // rho^m at a vector of rings.
    template <class I>
    static LOMMEL_INLINE typename I::pack power(I, const DiskRule& rule, std::size_t k, std::size_t m) {
        using V = typename I::pack;
        V result = splat<V>(1.0), square = load<V>(&rule.rho[k]);
        for (; m > 0; m /= 2) {
            if (m % 2 == 1) {
                result = result * square;
            }
            square = square * square;
        }
        return result;
    }

    Doubles folded_, radial_, turns_, rings_;
    std::vector<std::size_t> orders_;
};

}  // namespace lommel
