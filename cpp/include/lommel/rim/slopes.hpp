// Derivatives of the phase and of the pupil function on circles (certificate, section 10, "From the rim").
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/amplitude.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

constexpr std::size_t rim_orders = 8;        // K: number of integrations by parts (Gauss's theorem)
constexpr std::size_t rim_most_degree = 16;  // largest degree of the phase and of the exponent of the amplitude
constexpr double rim_unit = 32.0;            // factor of rim_scale() for each order, so that derivatives do not overflow

// k! rim_unit^k, by which derivatives of order k of the pupil function are divided when they are stored, to avoid overflow.
inline double rim_scale(std::size_t k) {
    double scale = 1.0;
    for (std::size_t i = 1; i <= k; ++i) {
        scale *= rim_unit * static_cast<double>(i);
    }
    return scale;
}

// Derivatives dbar^j ln P of the pupil function P = A exp(i Phi) on circles, dbar = d/dx + i d/dy. They determine dbar^k P = Q_k P.
// On a circle, dbar^j ln P / ((j - 1)! rim_unit^j) is a sum over mu of E_j,mu exp(i mu theta). A Zernike term of the phase Phi
// contributes to the real or the imaginary part of two coefficients E for each j.
struct RimSlopes {
    struct Part {
        std::size_t at, term;  // at: index of the real or imaginary part of a Fourier coefficient; term: of the Zernike term
    };

    std::vector<ZernikeTerm> terms;
    Amplitude amplitude;
    std::vector<double> radii;
    std::size_t degree = 1;            // largest order of derivatives
    std::vector<std::int32_t> orders;  // azimuthal order of each Fourier coefficient E
    std::vector<std::size_t> ends;     // [j - 1]: end of the Fourier coefficients of the derivative of order j
    std::vector<Part> parts;
    Floats weights;  // [circle][part]: contribution to a Fourier coefficient per unit of a Zernike coefficient
    Floats fixed;    // [circle][Fourier coefficient][re, im]: contribution of the pupil's amplitude

    RimSlopes(const std::vector<ZernikeTerm>& list, const Amplitude& light, const std::vector<double>& circles)
        : terms(list), amplitude(light), radii(circles) {
        degree = degree_of(list, light);
        std::vector<std::size_t> first;  // [j - 1]: index of the first Fourier coefficient of the derivative of order j
        for (std::size_t j = 1; j <= degree; ++j) {
            first.push_back(orders.size());
            const std::int32_t most = static_cast<std::int32_t>(degree - j);
            for (std::int32_t mu = -most; mu <= most; ++mu) {
                orders.push_back(mu);
            }
            ends.push_back(orders.size());
        }
        const auto at = [&](std::size_t j, std::int32_t mu) {
            return first[j - 1] + static_cast<std::size_t>(mu + static_cast<std::int32_t>(degree - j));
        };
        for (std::size_t circle = 0; circle < radii.size(); ++circle) {
            for (std::size_t t = 0; t < terms.size(); ++t) {
                const std::int32_t n = terms[t].n, m = std::abs(terms[t].m);
                const bool sine = terms[t].m < 0;
                for (std::int32_t j = 1; j <= n; ++j) {
                    double up = 0.0, down = 0.0;
                    each_power(n, m, [&](std::int32_t a, std::int32_t b, double c) {
                        up += c * slope(a, b, j, radii[circle]);
                        down += c * slope(b, a, j, radii[circle]);
                    });
                    const double half = (m == 0 ? 1.0 : 0.5) * factor(static_cast<std::size_t>(j));
                    const std::size_t jth = static_cast<std::size_t>(j);
                    add(circle, at, jth, m + j, t, sine, half * up);
                    if (m > 0) {
                        add(circle, at, jth, j - m, t, sine, sine ? -half * down : half * down);
                    }
                }
            }
            fixed.resize((circle + 1) * 2 * orders.size(), 0.0f);
            for (std::size_t k = 1; k <= amplitude.powers(); ++k) {
                for (std::size_t j = 1; j <= k; ++j) {
                    const std::int32_t power = static_cast<std::int32_t>(k), down = static_cast<std::int32_t>(j);
                    fixed[circle * 2 * orders.size() + 2 * at(j, down)] -=
                        static_cast<float>(amplitude.power(k) * slope(power, power, down, radii[circle]) * factor(j));
                }
            }
        }
    }
    bool is(const std::vector<ZernikeTerm>& list, const Amplitude& light, const std::vector<double>& circles) const {
        return terms == list && amplitude == light && radii == circles;
    }
    std::size_t bytes() const { return (weights.size() + fixed.size()) * sizeof(float) + parts.size() * sizeof(Part); }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;

    static std::size_t degree_of(const std::vector<ZernikeTerm>& list, const Amplitude& light) {
        std::size_t degree = std::max<std::size_t>(1, 2 * light.powers());
        for (const ZernikeTerm& term : list) {
            degree = std::max(degree, static_cast<std::size_t>(term.n));
        }
        return degree;
    }

    // Rounding error, in units of roundoff, of one step of rim_powers(), from the derivatives of the pupil function up to order k
    // to that of order k + 1, including the sums over Zernike terms.
    double units() const { return static_cast<double>(terms.size() + 4 * degree + 16); }

   private:
    // Call f(a, b, c) for each term c z^a conj(z)^b of the polynomial R_n^m(r) exp(i m theta), z = r exp(i theta).
    template <class F>
    static void each_power(std::int32_t n, std::int32_t m, const F& f) {
        double c = 1.0;  // binomial(n, (n - m) / 2)
        for (std::int32_t i = 1; i <= (n - m) / 2; ++i) {
            c *= static_cast<double>(n - i + 1) / static_cast<double>(i);
        }
        for (std::int32_t s = 0; 2 * s <= n - m; ++s) {
            f((n + m) / 2 - s, (n - m) / 2 - s, c);
            c *= -static_cast<double>(((n + m) / 2 - s) * ((n - m) / 2 - s)) / static_cast<double>((s + 1) * (n - s));
        }
    }
    // (d/dx + i d/dy)^j z^a conj(z)^b = 2^j b! / (b - j)! z^a conj(z)^(b - j), at z = radius.
    static double slope(std::int32_t a, std::int32_t b, std::int32_t j, double radius) {
        double product = 1.0;
        for (std::int32_t i = 0; i < j; ++i) {
            product *= 2.0 * static_cast<double>(b - i);
        }
        return b < j ? 0.0 : product * std::pow(radius, a + b - j);
    }
    static double factor(std::size_t j) { return static_cast<double>(j) / rim_scale(j); }
    template <class At>
    void add(std::size_t circle, const At& at, std::size_t j, std::int32_t mu, std::size_t term, bool sine, double by) {
        if (mu > static_cast<std::int32_t>(degree - j)) {  // the derivative vanishes
            return;
        }
        if (circle == 0) {
            parts.push_back({2 * at(j, mu) + (sine ? 0 : 1), term});
        }
        weights.push_back(static_cast<float>(by));
    }
};

// Derivatives of ln P on one circle as Fourier coefficients (E in RimSlopes): e[E][re, im][lane], from the pupil's amplitude and
// the Zernike coefficients[term][lane]. `Moduli`: sums of the moduli of the summands instead.
template <bool Moduli = false, class I>
LOMMEL_INLINE void slopes_of_circle(I, const RimSlopes& table, std::size_t circle, const float* coefficients, float* e) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    const std::size_t count = 2 * table.orders.size();
    const float* weights = table.weights.data() + circle * table.parts.size();
    const auto part = [](V v) LOMMEL_INLINE_LAMBDA { return Moduli ? larger(v, splat<V>(0.0f) - v) : v; };
    for (std::size_t i = 0; i < count; ++i) {
        store(e + i * lanes, part(splat<V>(table.fixed[circle * count + i])));
    }
    for (std::size_t i = 0; i < table.parts.size(); ++i) {
        float* const to = e + table.parts[i].at * lanes;
        store(to, load<V>(to) + part(splat<V>(weights[i]) * load<V>(coefficients + table.parts[i].term * lanes)));
    }
}

constexpr std::size_t rim_side = 8;  // angles per block of RimTurns

// Cosines and sines of mu theta, mu = 0, 1, .., degree, at the angles theta = (l + 1/2) 2 pi / count of the first half circle.
struct RimTurns {
    std::size_t count, orders;
    Floats turns;   // [angle][order mu][cos, sin] of mu times the angle
    Floats beside;  // [block of angles][order mu][cos, sin][angle in the block], 0 beyond the last angle

    RimTurns(std::size_t angles, std::size_t degree)
        : count(angles), orders(degree + 1), turns(angles * (degree + 1)), beside(blocks() * 2 * orders * rim_side, 0.0f) {
        for (std::size_t l = 0; l < count / 2; ++l) {
            for (std::size_t mu = 0; mu < orders; ++mu) {
                const double angle =
                    2.0 * pi * static_cast<double>(mu) * (static_cast<double>(l) + 0.5) / static_cast<double>(count);
                for (std::size_t part = 0; part < 2; ++part) {
                    const float value = static_cast<float>(part == 0 ? std::cos(angle) : std::sin(angle));
                    turns[2 * (l * orders + mu) + part] = value;
                    beside[(l / rim_side * 2 * orders + 2 * mu + part) * rim_side + l % rim_side] = value;
                }
            }
        }
    }
    const float* at(std::size_t angle) const { return turns.data() + 2 * angle * orders; }
    std::size_t blocks() const { return (count / 2 + rim_side - 1) / rim_side; }
    // Pointer into `beside` for the vector of angles that begins with `angle`.
    const float* from(std::size_t angle) const {
        return beside.data() + angle / rim_side * 2 * orders * rim_side + angle % rim_side;
    }
};

// Derivatives q[point][k][re, im] = dbar^k P / rim_scale(k), k = 1 .. Last, dbar = d/dx + i d/dy, of the pupil function P. Points:
// an angle (0) and half a turn further (1). q[point][0]: P, given. turns: cosines and sines from RimTurns; e: Fourier coefficients
// from slopes_of_circle(). Degree: at least table.degree, or rim_orders; a constant, so that loops are unrolled. Lanes are pupils
// or, if `Lone`, angles of one pupil, with equal e in all lanes.
template <std::size_t Degree, std::size_t Last, bool Lone, class I, class V>
LOMMEL_INLINE void rim_powers(I, const RimSlopes& table, const float* turns, const float* e, V (&q)[2][rim_orders + 1][2]) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    V d[2][Degree][2];
    for (std::size_t j = 0; j < Degree; ++j) {
        // Orders mu run from -most to most; even and odd orders are summed separately.
        const std::size_t most = table.degree - 1 - j, from = j == 0 || j >= table.degree ? 0 : table.ends[j - 1];
        V re[2], im[2];
        for (std::size_t parity = 0; parity < 2; ++parity) {
            V rc = splat<V>(0.0f), ic = rc, rs = rc, is = rc;
            const auto add = [&](std::size_t i, std::size_t order, bool down) LOMMEL_INLINE_LAMBDA {
                const float* const turn = turns + 2 * order * (Lone ? rim_side : 1);
                const V c = Lone ? load<V>(turn) : splat<V>(turn[0]), s = Lone ? load<V>(turn + rim_side) : splat<V>(turn[1]);
                const V a = load<V>(e + 2 * (from + i) * lanes), b = load<V>(e + (2 * (from + i) + 1) * lanes);
                rc = rc + a * c;
                ic = ic + b * c;
                rs = down ? rs - a * s : rs + a * s;
                is = down ? is - b * s : is + b * s;
            };
            for (std::size_t i = parity; j < table.degree && i < most; i += 2) {
                add(i, most - i, true);
            }
            for (std::size_t i = most + (most + parity) % 2; j < table.degree && i <= 2 * most; i += 2) {
                add(i, i - most, false);
            }
            re[parity] = rc - is;
            im[parity] = ic + rs;
        }
        const bool flip = most % 2 != 0;  // odd orders change sign half a turn further; which parity is odd depends on `most`
        d[0][j][0] = re[0] + re[1];
        d[0][j][1] = im[0] + im[1];
        d[1][j][0] = flip ? re[1] - re[0] : re[0] - re[1];
        d[1][j][1] = flip ? im[1] - im[0] : im[0] - im[1];
    }
    static constexpr float shares[] = {1.0f, 1.0f / 2, 1.0f / 3, 1.0f / 4, 1.0f / 5, 1.0f / 6, 1.0f / 7, 1.0f / 8};
    static_assert(Last <= std::size(shares), "one for each k");
    // Both points and four partial sums are interleaved: independent chains of additions hide their latency.
    for (std::size_t k = 0; k < Last; ++k) {
        V sum[2][4] = {};
        for (std::size_t j = 0; j < std::min(k + 1, Degree); ++j) {
            for (std::size_t point = 0; point < 2; ++point) {
                const V *const a = d[point][j], *const b = q[point][k - j];
                V* const to = sum[point];
                to[0] = to[0] + a[0] * b[0];
                to[1] = to[1] + a[1] * b[1];
                to[2] = to[2] + a[0] * b[1];
                to[3] = to[3] + a[1] * b[0];
            }
        }
        const V by = splat<V>(shares[k]);
        for (std::size_t point = 0; point < 2; ++point) {
            q[point][k + 1][0] = (sum[point][0] - sum[point][1]) * by;
            q[point][k + 1][1] = (sum[point][2] + sum[point][3]) * by;
        }
    }
}

// Quadrature over the disk with nodes on circles, exact for the squared modulus of Q_K = dbar^K P / P (RimSlopes).
struct RimDisk {
    RimSlopes slopes;
    RimTurns turns;
    std::vector<double> weights;  // weight of each circle

    RimDisk(const std::vector<ZernikeTerm>& terms, const Amplitude& light)
        : slopes(terms, light, circles(RimSlopes::degree_of(terms, light), false)),
          turns(2 * rim_orders * (slopes.degree - 1) + 2, slopes.degree), weights(circles(slopes.degree, true)) {}
    bool is(const std::vector<ZernikeTerm>& terms, const Amplitude& light) const {
        return slopes.is(terms, light, slopes.radii);
    }
    std::size_t bytes() const { return slopes.bytes() + (turns.turns.size() + turns.beside.size()) * sizeof(float); }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;

   private:
    static std::vector<double> circles(std::size_t degree, bool weights) {
        const std::size_t count = (rim_orders * (degree - 1) + 2) / 2;
        std::vector<double> x(count), w(count);
        gauss_legendre(count, x.data(), w.data());
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = std::sqrt(0.5 + 0.5 * x[i]);
            w[i] *= 0.5;
        }
        return weights ? w : x;
    }
};

// mean[lane]: mean over the disk of |q|^2, with q = dbar^K P / (P rim_scale(K)), dbar = d/dx + i d/dy, K = rim_orders, and P the
// pupil function. moduli[lane]: the same mean if each sum in q is replaced by the sum of the moduli of its summands; rounding
// errors are relative to it. e: working memory for slopes_of_circle(). Lanes: see rim_powers().
template <std::size_t Degree, bool Lone, class I>
LOMMEL_INLINE void mean_of_disk(I isa, const RimDisk& disk, const float* coefficients, float* e, float* mean, float* moduli) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    static_assert(!Lone || rim_side % lanes == 0, "blocks are vectors");
    const V zero = splat<V>(0.0f);
    V all = zero, most = zero;
    for (std::size_t circle = 0; circle < disk.weights.size(); ++circle) {
        slopes_of_circle(isa, disk.slopes, circle, coefficients, e);
        V sum = zero;
        for (std::size_t l = 0; l < disk.turns.count / 2; l += Lone ? lanes : 1) {
            V q[2][rim_orders + 1][2];
            for (auto& point : q) {
                point[0][0] = splat<V>(1.0f);
                point[0][1] = zero;
            }
            rim_powers<Degree, rim_orders, Lone>(isa, disk.slopes, Lone ? disk.turns.from(l) : disk.turns.at(l), e, q);
            for (const auto& point : q) {
                const V re = point[rim_orders][0], im = point[rim_orders][1];
                sum = sum + (re * re + im * im);
            }
        }
        V size[Degree], power[rim_orders + 1];
        slopes_of_circle<true>(isa, disk.slopes, circle, coefficients, e);
        for (std::size_t j = 0, i = 0; j < Degree; ++j) {
            size[j] = zero;
            for (; j < disk.slopes.degree && i < 2 * disk.slopes.ends[j]; ++i) {
                size[j] = size[j] + load<V>(e + i * lanes);
            }
        }
        power[0] = splat<V>(1.0f);
        for (std::size_t k = 0; k < rim_orders; ++k) {
            V next = zero;
            for (std::size_t j = 0; j < std::min(k + 1, Degree); ++j) {
                next = next + size[j] * power[k - j];
            }
            power[k + 1] = next * splat<V>(1.0f / static_cast<float>(k + 1));
        }
        const V weight = splat<V>(static_cast<float>(disk.weights[circle]));
        all = all + sum * weight * splat<V>(1.0f / static_cast<float>(disk.turns.count));
        most = most + power[rim_orders] * power[rim_orders] * weight;
    }
    store(mean, all);
    store(moduli, most);
    if constexpr (Lone) {  // lanes are angles, to be summed
        mean[0] = std::accumulate(mean, mean + lanes, 0.0f);
    }
}

}  // namespace lommel
