// Bounds on a pupil function exp(i Phi) on complex chords of the disk, and on tails of its series (docs/certificate.md, section 7).
//
// On the line of points cos(phi) xi + eta sin(phi) xi', with orthonormal vectors xi and xi' and |eta| <= 1, a Zernike polynomial of
// degree n is a real trigonometric polynomial of degree n in the angle phi, at most 1. At phi = a + ib its imaginary part is at
// most sinh(n b) (Duffin and Schaeffer 1938, integrated). Hence |exp(i Phi)| <= M(b) = exp sum_j W_j sinh(n_j b), with W_j the
// amplitude of Zernike term j.
//
// The means of the pupil function over chords are therefore analytic in Bernstein ellipses. Their Chebyshev coefficients (Marr
// 1974; Logan and Shepp 1975) are at most M(b) (1 + e^{-2b}) e^{-n b} for every b > 0; the best b of a fixed set is used.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/bounds/amplitude.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/limits.hpp"

namespace lommel {

// Zernike terms in pairs, cosine and sine of the same degree n and order m. Amplitude of a pair: sqrt(cosine^2 + sine^2).
struct TermPairs {
    static constexpr std::size_t none = ~std::size_t{0};
    struct Pair {
        std::size_t n, m, cosine, sine;  // cosine, sine: indices of terms, or none
        double square(const double* c) const {  // squared amplitude
            return (cosine == none ? 0.0 : c[cosine] * c[cosine]) + (sine == none ? 0.0 : c[sine] * c[sine]);
        }
    };

    std::vector<ZernikeTerm> terms;
    std::vector<Pair> pairs;  // in ascending order of degree
    std::size_t curved;  // index of the first pair that is neither constant nor tilt
    std::size_t degree = 1;  // highest degree

    explicit TermPairs(const std::vector<ZernikeTerm>& list) : terms(list) {
        for (std::size_t j = 0; j < terms.size(); ++j) {
            const std::size_t n = static_cast<std::size_t>(terms[j].n), m = static_cast<std::size_t>(std::abs(terms[j].m));
            degree = std::max(degree, n);
            const auto at = std::find_if(pairs.begin(), pairs.end(), [&](const Pair& p) { return p.n == n && p.m == m; });
            Pair& pair = at == pairs.end() ? (pairs.push_back({n, m, none, none}), pairs.back()) : *at;
            (terms[j].m < 0 ? pair.sine : pair.cosine) = j;
        }
        std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.n < b.n; });
        curved = static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [](const Pair& p) { return p.n < 2; }));
    }
};

// Functions of b for 64 complex curves; on a curve, the angle phi = a + ib (top of this file) has the fixed imaginary part b. Each
// curve gives bounds, for example on the tail of a series; the smallest one is used.
struct ChordCurves {
    static constexpr std::size_t count = 64;
    using Values = std::array<double, count>;
    Values b, inverse, decay, cosh, constant, closed;  // b, 1 / b, e^-b, cosh 2b, log(1 + e^-2b), -log(1 - e^-b)
    std::vector<Values> growth;  // [n]: sinh(n b)

    ChordCurves() : growth(max_degree + 1) {
        for (std::size_t k = 0; k < count; ++k) {
            b[k] = 2e-3 * std::pow(2000.0, static_cast<double>(k) / (count - 1));
            inverse[k] = 1.0 / b[k];
            decay[k] = std::exp(-b[k]);
            cosh[k] = std::cosh(2.0 * b[k]);
            constant[k] = std::log1p(std::exp(-2.0 * b[k]));
            closed[k] = -std::log(-std::expm1(-b[k]));
            const double most = std::sinh(600.0), grown = std::exp(b[k]);
            double up = 1.0, down = 1.0;  // e^(n b), e^(-n b)
            for (std::size_t n = 0; n <= max_degree; ++n, up *= grown, down *= decay[k]) {
                growth[n][k] = std::min(most, 0.5 * (up - down));
            }
        }
    }
};

// A global object, constructed at load time: a static inside a function could be half built when the process forks.
inline const ChordCurves chord_curves;

// Index of the minimum. The minimum is taken in eight chains, which compilers vectorise; then its index is searched.
LOMMEL_INLINE std::size_t least_at(const ChordCurves::Values& values) {
    std::array<double, 8> low;
    std::copy_n(values.begin(), 8, low.begin());
    for (std::size_t k = 8; k < ChordCurves::count; k += 8) {
        for (std::size_t j = 0; j < 8; ++j) {
            low[j] = values[k + j] < low[j] ? values[k + j] : low[j];
        }
    }
    const double least = *std::min_element(low.begin(), low.end());
    return static_cast<std::size_t>(std::find(values.begin(), values.end() - 1, least) - values.begin());
}

// size[k]: bound on log |pupil function| on the complex curve on which the angle has the imaginary part b[k].
struct ChordGrowth {
    ChordCurves::Values size{};

    LOMMEL_INLINE void add(double amplitude, std::size_t n) {
        const ChordCurves::Values& growth = chord_curves.growth.at(n);
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            size[k] += amplitude * growth[k];
        }
    }
    // Add the bound on the amplitude: where the angle has the imaginary part b, rho^2 stays in the ellipse of Amplitude::growth()
    // with c = cosh 2b.
    void add(const Amplitude& light) {
        for (std::size_t k = 0; k < ChordCurves::count && !light.uniform(); ++k) {
            size[k] += light.growth(chord_curves.cosh[k]);
        }
    }

    // Bound on the sum over m >= n of the coefficients of a series, if coefficient m is at most e^(size[k] - m b[k]) for all k.
    double tail(std::size_t n) const {
        double best = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            ChordCurves::Values sums;
            for (std::size_t k = 0; k < ChordCurves::count; ++k) {
                sums[k] = size[k] - static_cast<double>(n) * chord_curves.b[k] + chord_curves.closed[k];
            }
            best = sums[least_at(sums)];
        });
        return std::exp(std::min(best, 690.0));
    }

    // Approximate smallest degree n with log tail(n) <= `logarithm`.
    double fewest(double logarithm) const {
        double least = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            ChordCurves::Values degrees;
            for (std::size_t k = 0; k < ChordCurves::count; ++k) {
                degrees[k] = (size[k] + chord_curves.closed[k] - logarithm) * chord_curves.inverse[k];
            }
            least = degrees[least_at(degrees)];
        });
        return std::max(1.0, std::ceil(least));
    }

    // Bound on |pupil function - polynomial| on the disk, for the best polynomial of degree d. The pupil function's Zernike terms
    // of degree n sum to at most (n+1)^(3/2) times the bound on the n-th Chebyshev coefficients at the top of this file.
    double distance(std::size_t d) const {
        const double first = static_cast<double>(d) + 2.0;  // n + 1 for the first omitted degree n
        const double next = (first + 1.0) / first, widening = next * std::sqrt(next);
        ChordCurves::Values exponents;
        std::size_t least = 0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            for (std::size_t k = 0; k < ChordCurves::count; ++k) {
                const double exponent = size[k] - (first - 1.0) * chord_curves.b[k];
                exponents[k] = chord_curves.decay[k] * widening < 1.0 ? exponent : 1e300;
            }
            least = least_at(exponents);
        });
        // As add() computes a logarithm, it is called for the smallest exponent first, then only for exponents below `best` so far.
        double best = 1e300;
        const auto add = [&](std::size_t k) {
            best = std::min(best, exponents[k] - std::log(1.0 - chord_curves.decay[k] * widening));
        };
        add(least);
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            if (exponents[k] < best) {
                add(k);
            }
        }
        return first * std::sqrt(first) * std::exp(std::min(best, 690.0));
    }
};

class DiskBounds {
   public:
    DiskBounds() { chords_.size = chord_curves.constant; }

    // Add a Zernike pair of degree n, azimuthal order m and amplitude sqrt(cosine^2 + sine^2).
    void add(double amplitude, std::size_t n, std::size_t m) {
        chords_.add(amplitude, n);
        turns_.add(amplitude, m);
    }
    void add(const Amplitude& light) { chords_.add(light); }

    // Bound on the contribution of all degrees >= n to the field at any image radius v, since |2 (n+1) J_{n+1}(v) / v| <= 1.
    double tail(std::size_t n) const { return chords_.tail(n); }
    // Bound on the contribution of all azimuthal orders >= m to the field at any image radius v. On a circle of radius rho in the
    // pupil, the pupil function is analytic in the azimuth, so its Fourier coefficients fall like exp(-m b); and
    // |2 int J_m(v rho) rho d rho| <= 1.
    double orders_tail(std::size_t m) const { return 2.0 * turns_.tail(m); }
    double distance(std::size_t d) const { return chords_.distance(d); }

    // Index of the curve with the fewest degrees for an error of the field, if log |pupil function| is `share` times its bound.
    std::size_t likely(double error, double share) const {
        ChordCurves::Values degrees;
        for (std::size_t k = 0; k < ChordCurves::count; ++k) {
            degrees[k] = (share * chords_.size[k] + chord_curves.closed[k] - std::log(error)) * chord_curves.inverse[k];
        }
        return least_at(degrees);
    }
    // Estimates of degrees(), orders() and degree() without a search.
    double likely_degrees(double error) const { return chords_.fewest(std::log(error)); }
    double likely_orders(double error) const { return turns_.fewest(std::log(0.5 * error)); }
    double likely_degree(double error) const {
        double n = chords_.fewest(std::log(error));
        for (std::size_t i = 0; i < 2; ++i) {
            n = chords_.fewest(std::log(error) - 1.5 * std::log(n + 2.0));
        }
        return n;
    }
    // Bound on log |pupil function| on a curve. size(): return it; lower(): reduce it by `by`, if the caller has a smaller bound.
    void lower(std::size_t curve, double by) { chords_.size[curve] -= by; }
    double size(std::size_t curve) const { return chords_.size[curve]; }

    // Smallest n with tail(n) <= error (degrees()), orders_tail(n) <= error (orders()), distance(n) <= error (degree()).
    std::size_t degrees(double error) const { return fewest_for(&DiskBounds::tail, error); }
    std::size_t orders(double error) const { return fewest_for(&DiskBounds::orders_tail, error); }
    std::size_t degree(double error) const { return fewest_for(&DiskBounds::distance, error); }

   private:
    std::size_t fewest_for(double (DiskBounds::*bound)(std::size_t) const, double error) const {
        return fewest(1, [&](std::size_t n) { return (this->*bound)(n) <= error; }, std::size_t{1} << 20);
    }

    ChordGrowth chords_, turns_;
};

}  // namespace lommel
