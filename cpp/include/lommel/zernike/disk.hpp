// Zernike coefficients c, s of the pupil function: P = sum over n, m of R_n^m(rho) (c cos(m theta) + s sin(m theta)).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/radial_polynomials.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// Phase of one pupil as coefficients of Zernike terms (radians at the edge), and the pupil's amplitude.
struct ZernikePhase {
    const TermPairs& list;
    const double* coefficients;
    Amplitude amplitude;

    // Call f(amplitude, n, |m|) for each pair of a cosine and a sine term, amplitude = sqrt(cosine^2 + sine^2).
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

    // Ratio (max |U| without aberrations) / (max |U| with them), estimated from the variance of the phase; U: field in the image.
    double dimness() const {
        double variance = 0.0;
        amplitudes([&](double a, std::size_t n, std::size_t m) {
            variance += a * a / (static_cast<double>(n + 1) * (m > 0 ? 2.0 : 1.0));
        });
        return std::sqrt(1.0 + variance);
    }
    // Cautious value of this ratio: dimness() may be too small by a factor of 2; the factor 2.5 leaves a margin. For weak
    // aberrations, size() + 1 is smaller.
    double dimmest() const { return std::min(size() + 1.0, 2.5 * dimness()); }

    // Rounding error of the pupil function, in units of roundoff, due to rounding of rho and to the recurrence for R_n^m.
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

// Product quadrature on the unit disk: Gauss nodes in t = rho^2 (rings) times equally spaced angles. No angle lies on an axis, so
// that the sums over Zernike terms in one quadrant give all four quadrants. Rules are cached.
struct DiskRule {
    std::size_t degree;  // degree of the polynomials up to which the rule is exact
    std::size_t rings;   // number of rings, a multiple of 8
    RowFft<double> fft;  // transform over the n angles (j + 1/2) 2 pi / n
    Doubles t, rho, weights;
    std::vector<double> cosines, sines;  // cosines and sines of k pi / n, k < 2 n

    explicit DiskRule(std::size_t exact)
        : degree(exact), rings(rings_for(exact)), fft(points_for(exact)), t(rings), rho(rings), weights(rings) {
        std::vector<double> x(rings), w(rings);
        gauss_legendre(rings, x.data(), w.data());
        for (std::size_t k = 0; k < rings; ++k) {
            t[k] = 0.5 * (1.0 + x[k]);
            rho[k] = std::sqrt(t[k]);
            weights[k] = 0.5 * w[k];
        }
        for (std::size_t i = 0; i < 2 * fft.n; ++i) {
            const double angle = pi / static_cast<double>(fft.n) * static_cast<double>(i);
            cosines.push_back(std::cos(angle));
            sines.push_back(std::sin(angle));
        }
    }

    // rounded(): `exact` raised to the highest degree with as many rings, so that slightly stronger aberrations need no new rule.
    static std::size_t rounded(std::size_t exact) { return (exact + 32) / 32 * 32 - 1; }
    static std::size_t rings_for(std::size_t degree) { return (degree / 4 + 1 + 7) / 8 * 8; }
    static std::size_t points_for(std::size_t degree) { return RowFft<double>::length(degree + 1); }

    // Index into `cosines` and `sines` of the angle m theta_j, theta_j = (2 j + 1) pi / n.
    std::size_t turned(std::size_t m, std::size_t j) const { return m * (2 * j + 1) % (2 * fft.n); }

    // Bound on the rounding error of a Fourier coefficient, in units of roundoff times the mean modulus of the samples. 25 covers
    // the phase factor for angles that begin at half a step, and the sum of the orders m and -m.
    double rounding() const { return fft.rounding() + 25.0; }

    bool is(std::size_t exact) const { return degree == exact; }
    std::size_t bytes() const { return sizeof(double) * (8 * fft.n + 3 * rings); }

    static constexpr std::size_t most_bytes = std::size_t{64} << 20;
    static std::shared_ptr<const DiskRule> get(std::size_t exact) { return cache<DiskRule>.get(rounded(exact)); }
};

// Zernike coefficients of degrees n < degrees and azimuthal orders m < orders, grouped by order m: n = m, m + 2, ...
struct ZernikeSeries {
    std::size_t degrees = 0, orders = 0;
    std::vector<std::size_t> start;  // [order]: index of its first coefficient
    std::vector<std::size_t> used;   // [order]: number of coefficients in use
    std::array<Doubles, 4> parts;    // [re cosine, im cosine, re sine, im sine][coefficient]

    std::size_t count(std::size_t m) const { return (degrees - 1 - m) / 2 + 1; }
    // Modulus of coefficient `at`: of the cosine (sine = 0) or of the sine (sine = 1).
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

// Compute the Zernike coefficients of a pupil function: FFTs over the angles of each ring, then projections onto the radial
// polynomials.
class ZernikeAnalysis {
   public:
    // Fill `series` with the Zernike coefficients of degrees n < degrees, orders m < orders; those of odd n are multiplied by -i.
    void run(const DiskRule& rule, const ZernikePhase& phase, std::size_t degrees, std::size_t orders, int threads,
             ZernikeSeries& series) {
        series.resize(degrees, orders);
        dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA { prepare(isa, rule, phase); });
        rings_.resize(orders * 4 * rule.rings);
        const double nodes = static_cast<double>(rule.rings) * static_cast<double>(rule.fft.n + degrees * orders);
        const int worth = worthwhile_threads(threads, 1e-3 * nodes);
        parallel_for(rule.rings / fft_rows, worth, [&](std::size_t, std::size_t group) {
            dispatch_widest([&](auto isa)
                                LOMMEL_INLINE_LAMBDA { transform(isa, rule, phase.amplitude, orders, group * fft_rows); });
        });
        parallel_for(orders, worth, [&](std::size_t, std::size_t m) {
            dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA { project(isa, rule, m, series); });
        });
    }

   private:
    // For each azimuthal order m of the phase, sum over n of coefficient * R_n^m: radial_[index of m][cosine, sine][ring].
    template <class I>
    LOMMEL_INLINE void prepare(I isa, const DiskRule& rule, const ZernikePhase& phase) {
        using V = typename I::pack;
        const std::size_t rings = rule.rings;
        orders_.clear();
        for (const TermPairs::Pair& pair : phase.list.pairs) {
            if (std::find(orders_.begin(), orders_.end(), pair.m) == orders_.end()) {
                orders_.push_back(pair.m);
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
    }

    // Azimuthal Fourier coefficients of pupil function * ring weight, on 8 rings: rings_[m][cos re, cos im, sin re, sin im][ring].
    template <class I>
    LOMMEL_INLINE void transform(I isa, const DiskRule& rule, const Amplitude& amplitude, std::size_t orders,
                                 std::size_t first) {
        using V = typename I::pack;
        const std::size_t n = rule.fft.n, rings = rule.rings;
        thread_local Doubles spectrum[2];
        for (Doubles& numbers : spectrum) {
            numbers.resize(n * fft_element);
        }
        for (std::size_t k = 0; k < fft_rows; k += I::lanes) {
            evaluate(isa, rule, amplitude, first + k, spectrum[0].data() + k);
        }
        double* y = rule.fft.run<false>(isa, spectrum[0].data(), spectrum[1].data());
        double* x = spectrum[y == spectrum[0].data() ? 1 : 0].data();
        for (std::size_t k = 0; k < fft_rows; k += I::lanes) {
            for (std::size_t q = 0; q < n / 4; ++q) {
                ComplexPack<V> found[4];
                rule.fft.last(y + q * fft_element + k, found);
                for (std::size_t j = 0; j < 4; ++j) {
                    double* to = x + (q + j * (n / 4)) * fft_element + k;
                    store(to, found[j].re);
                    store(to + fft_rows, found[j].im);
                }
            }
            for (std::size_t m = 0; m < orders; ++m) {
                // Fourier coefficient l times exp(turn i m pi / n), as the first angle is half a step from 0: turn = 1 for l = m,
                // -1 for l = n - m.
                const auto at = [&](std::size_t l, double turn) LOMMEL_INLINE_LAMBDA {
                    const double* here = x + l * fft_element + k;
                    const ComplexPack<V> found = {load<V>(here), load<V>(here + fft_rows)};
                    return found.times(splat<V>(rule.cosines[m]), splat<V>(turn * rule.sines[m]));
                };
                const ComplexPack<V> there = at(m, 1.0), back = at(m == 0 ? 0 : n - m, -1.0);
                const V share = splat<V>(m == 0 ? 0.5 : 1.0);
                const ComplexPack<V> cosine = there + back, sine = (back - there).times_i();
                double* to = &rings_[m * 4 * rings + first + k];
                store(to, share * cosine.re);
                store(to + rings, share * cosine.im);
                store(to + 2 * rings, share * sine.re);
                store(to + 3 * rings, share * sine.im);
            }
        }
    }

    // Write to `out`, for one vector of rings from ring k on, (pupil function * quadrature weight of the ring / number of angles).
    template <class I>
    LOMMEL_INLINE void evaluate(I isa, const DiskRule& rule, const Amplitude& amplitude, std::size_t k, double* out) const {
        using V = typename I::pack;
        const std::size_t n = rule.fft.n, rings = rule.rings;
        alignas(64) double sizes[I::lanes];
        for (std::size_t i = 0; i < I::lanes; ++i) {
            sizes[i] = amplitude.at(rule.t[k + i]) * rule.weights[k + i] / static_cast<double>(n);
        }
        const V size = load<V>(sizes);
        for (std::size_t i = 0; i < n / 4; ++i) {
            V even_cos = splat<V>(0.0), odd_cos = even_cos, even_sin = even_cos, odd_sin = even_cos;
            for (std::size_t g = 0; g < orders_.size(); ++g) {
                const std::size_t turned = rule.turned(orders_[g], i);
                const V c = splat<V>(rule.cosines[turned]) * load<V>(&radial_[2 * g * rings + k]);
                const V s = splat<V>(rule.sines[turned]) * load<V>(&radial_[(2 * g + 1) * rings + k]);
                if (orders_[g] % 2 == 0) {
                    even_cos = even_cos + c;
                    even_sin = even_sin + s;
                } else {
                    odd_cos = odd_cos + c;
                    odd_sin = odd_sin + s;
                }
            }
            // Phase at the angles theta, -theta, pi - theta, pi + theta.
            const V angle[4] = {even_cos + odd_cos + even_sin + odd_sin, even_cos + odd_cos - even_sin - odd_sin,
                                even_cos - odd_cos - even_sin + odd_sin, even_cos - odd_cos + even_sin - odd_sin};
            const std::size_t places[4] = {i, n - 1 - i, n / 2 - 1 - i, n / 2 + i};
            for (std::size_t j = 0; j < 4; ++j) {
                V sine, cosine;
                sincos(isa, angle[j], sine, cosine);
                store(out + places[j] * fft_element, size * cosine);
                store(out + places[j] * fft_element + fft_rows, size * sine);
            }
        }
    }

    // Quadrature over the rings: coefficients of R_n^m for one order m and n = m, m + 2, ...
    template <class I>
    LOMMEL_INLINE void project(I isa, const DiskRule& rule, std::size_t m, ZernikeSeries& series) {
        using V = typename I::pack;
        const std::size_t rings = rule.rings;
        constexpr std::size_t most = 64;  // ring vectors per block, and so the size of the arrays below
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
                // Coefficients of odd degree are multiplied by -i, as run() states: (re, im) becomes (im, -re).
                const double norm = static_cast<double>(m + 2 * j + 1), turned = m % 2 == 0 ? norm : -norm;
                for (std::size_t c = 0; c < 4; ++c) {
                    series.parts[c][to + j] += (c % 2 == 0 ? norm : turned) * lane_sum(sums[c ^ m % 2]);
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

    // rho^m on a vector of rings, by repeated squaring.
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

    Doubles radial_, rings_;
    std::vector<std::size_t> orders_;
};

}  // namespace lommel
