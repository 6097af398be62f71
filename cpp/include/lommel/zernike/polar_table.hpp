// Polar non-uniform FFT, table: transforms 2 J_{n+1}(v) / v of Zernike polynomials at equal steps of v (docs/certificate.md,
// section 11). It depends only on the step and the kernel, so all pupils, wavelengths and pixel sizes share it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// Kernel of the interpolation between circles `step` apart in v: weights of taps, and error bounds.
struct PolarKernel : GriddingTaps {
    double step;
    double aliases;  // bound on the contribution of aliases to U
    double largest;  // largest 1 / (transform of the kernel)
    double shares;   // mean over 0 <= a <= pi/2 of 2 sin(a) / transform(step cos(a))

    PolarKernel(double circle_step, std::size_t taps, double beta)
        : GriddingTaps({taps, beta}), step(circle_step), aliases(kernel.aliasing(step)), largest(1.0 / kernel.transform(step)),
          shares(0.0) {
        constexpr std::size_t nodes = 32;
        for (std::size_t k = 0; k < nodes; ++k) {
            const double a = 1.5707963267948966 * (static_cast<double>(k) + 0.5) / nodes;
            shares += 2.0 * std::sin(a) / kernel.transform(step * std::cos(a)) / nodes;
        }
    }

    bool is(double circle_step, std::size_t taps, double beta) const {
        return step == circle_step && kernel.w == taps && kernel.beta() == beta;
    }
    std::size_t bytes() const { return sizeof(PolarKernel); }
    static constexpr std::size_t most_bytes = std::size_t{1} << 20;
};

// Table of F_n(j) = 2 / (pi (n+1)) int_0^pi sin(a) sin((n+1) a) C(j h cos a) / t(h cos a) da, with h the step in v, t the transform
// of the kernel phi, C = cos for even n, sin for odd n. Except for aliases, sum_j phi(v/h - j) F_n(j) is 2 J_{n+1}(v) / v up to a
// sign.
//
// Layout [block][n][j], sixteen j per block from j = -16 on. A block depends only on its index and on grade(degrees), so images do
// not depend on the contents of the cache.
struct PolarTable {
    static constexpr std::size_t block = 16, before = 16;

    double step;
    GriddingKernel kernel;
    std::size_t blocks, degrees;
    Doubles values;
    std::vector<std::size_t> reached;  // [block]: number of degrees in use; the others change U by less than left_out
    std::vector<double> roundings;     // [block]: bound on the rounding of (n + 1) times the values of degree n

    // Bound on the contribution to U of the degrees that a block omits, for any pupil.
    static constexpr double left_out = 1e-13;

    PolarTable(double circle_step, std::size_t taps, double beta, std::size_t block_count, std::size_t degree_count)
        : step(circle_step), kernel(taps, beta), blocks((block_count + 3) / 4 * 4), degrees(grade(degree_count)),
          values(blocks * degrees * block), reached(blocks), roundings(blocks) {
        for (std::size_t b = 0; b < blocks; ++b) {
            look();
            const Rule rule(*this, b);
            reached[b] = rule.degrees;
            double shares = 0.0;
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { shares = fill(isa, b, rule); });
            roundings[b] = rounding(shares, static_cast<double>(rule.half), farthest(b));
        }
    }

    // Number of degrees rounded up to a power of two, or to 3/2 times a power of two; at least 32.
    static std::size_t grade(std::size_t degrees) {
        std::size_t made = 32;
        while (made < degrees) {
            made = made % 3 == 0 ? made / 3 * 4 : made / 2 * 3;
        }
        return made;
    }

    // Bound on the rounding of (n + 1) times the table's values of degree n at radii up to v; shares: sum of the weights of the
    // nodes. In units of roundoff: one per node; 3 v from the sines of the nodes' angles; 2 v from v and the argument v cos(a); 170
    // from the kernel's transform, the sines of arguments and the products.
    static double rounding(double shares, double nodes, double v) { return unit_roundoff * shares * (nodes + 5.0 * v + 170.0); }

    // Bound on that part of the error of U which comes from the cosine terms, or from the sine terms (callers count it twice), if
    // the table's values for `count` degrees n have errors of `each` / (n + 1): `each` times the sum over these terms of
    // |beta| / (n + 1), with Zernike coefficients beta. By Cauchy's inequality this sum is <= sqrt(count): the sum of
    // e |beta|^2 / (n + 1) is <= 1, with e = 1 for m = 0, else 1/2, and 1 / e sums to at most n + 1 over the orders m of a degree.
    static double rounding(double each, double count) { return each * std::sqrt(count); }

    bool is(double circle_step, std::size_t taps, double beta, std::size_t block_count, std::size_t degree_count) const {
        return step == circle_step && kernel.w == taps && kernel.beta() == beta && blocks >= block_count &&
               degrees == grade(degree_count);
    }
    std::size_t bytes() const { return sizeof(double) * values.size(); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;

   private:
    double farthest(std::size_t b) const { return step * static_cast<double>(std::max<std::size_t>(1, b) * block); }

    // degrees: number needed in a block; half: N / 2 for the midpoint rule of N points over the angle a in F_n. For |Im a| <= w the
    // integrand without 2 / (pi (n+1)) is at most M = cosh(w) cosh((n+1) w) exp(v sinh w) / t(h cosh w), with h the step and t the
    // kernel's transform, which has only real zeros and so is smallest on the real line. Hence (n+1) |F_n| is at most
    // 2 cosh(w) exp(v sinh w - (n+1) w) / t(h cosh w), and the rule's error is at most 2 M / (exp(2 N w) - 1).
    struct Rule {
        std::size_t degrees, half;

        Rule(const PolarTable& table, std::size_t b) {
            const double v = table.farthest(b);
            const auto least = [&](const auto& needed) {
                double best = 1e300;
                for (double width = 0.05; width < 1.5 && table.step * std::cosh(width) < 3.1; width *= 1.1) {
                    best = std::min(best, needed(width, v * std::sinh(width) -
                                                            std::log(table.kernel.transform(table.step * std::cosh(width)))));
                }
                return best;
            };
            const double enough = least([](double width, double size) {
                return (size + std::log(2.0 * std::cosh(width) / ((1.0 - std::exp(-width)) * left_out))) / width;
            });
            degrees = std::min(table.degrees, (static_cast<std::size_t>(enough) + 4) / 4 * 4);
            const double n = static_cast<double>(degrees);
            half = static_cast<std::size_t>(0.5 * least([&](double width, double size) {
                                                return (size + (n + 1.0) * width + 38.0) / (2.0 * width);
                                            })) +
                   1;
        }
    };

    // Sine of 2 pi i / turn, `turn` a multiple of 8. Reduction to an eighth of a turn keeps the error below 3 units of roundoff.
    static double sine(std::size_t i, std::size_t turn) {
        const std::size_t quarter = turn / 4, part = i % quarter, least = std::min(part, quarter - part);
        const double angle = 6.283185307179586477 * static_cast<double>(least) / static_cast<double>(turn);
        const double size = (i / quarter % 2 == 1) == (least == part) ? std::cos(angle) : std::sin(angle);
        return i / quarter < 2 ? size : -size;
    }

    // Compute block b of the table; return the sum of the weights of the quadrature nodes, by which rounding is bounded.
    template <class I>
    LOMMEL_INLINE double fill(I isa, std::size_t b, const Rule& rule) {
        using V = typename I::pack;
        constexpr std::size_t packs = block / I::lanes, together = 2;
        const std::size_t nodes = rule.half, count = rule.degrees;
        const std::size_t turn = 8 * nodes;  // unit of angles: half the distance between nodes, a_k = (2k + 1) units
        std::vector<double> sines(turn);
        for (std::size_t i = 0; i < turn; ++i) {
            sines[i] = sine(i, turn);
        }
        Doubles weights(nodes * count), waves(2 * nodes * block), places(nodes), shares(nodes);
        double all = 0.0;
        for (std::size_t k = 0; k < nodes; ++k) {
            places[k] = sines[2 * nodes + 2 * k + 1];
            shares[k] = 2.0 * sines[2 * k + 1] / (static_cast<double>(nodes) * kernel.transform(step * places[k]));
            all += shares[k];
            for (std::size_t n = 0, at = 2 * k + 1; n < count; ++n) {
                weights[k * count + n] = sines[at] / static_cast<double>(n + 1);
                at = at + 2 * k + 1 < turn ? at + 2 * k + 1 : at + 2 * k + 1 - turn;
            }
        }
        alignas(64) double v[block];
        for (std::size_t i = 0; i < block; ++i) {
            v[i] = step * (static_cast<double>(b * block + i) - static_cast<double>(before));
        }
        for (std::size_t k = 0; k < nodes; ++k) {
            for (std::size_t i = 0; i < block; i += I::lanes) {
                V sine, cosine;
                sincos(isa, splat<V>(places[k]) * load<V>(v + i), sine, cosine);
                store(&waves[k * block + i], cosine * splat<V>(shares[k]));
                store(&waves[(nodes + k) * block + i], sine * splat<V>(shares[k]));
            }
        }
        double* to = &values[b * degrees * block];
        for (std::size_t n = 0; n < count; n += 2 * together) {
            for (std::size_t parity = 0; parity < 2; ++parity) {
                V sums[together][packs];
                for (std::size_t i = 0; i < together; ++i) {
                    for (std::size_t p = 0; p < packs; ++p) {
                        sums[i][p] = splat<V>(0.0);
                    }
                }
                for (std::size_t k = 0; k < nodes; ++k) {
                    const double* wave = &waves[(parity * nodes + k) * block];
                    const double* weight = &weights[k * count + n + parity];
                    for (std::size_t i = 0; i < together; ++i) {
                        const V here = splat<V>(weight[2 * i]);
                        for (std::size_t p = 0; p < packs; ++p) {
                            sums[i][p] = sums[i][p] + here * load<V>(wave + p * I::lanes);
                        }
                    }
                }
                for (std::size_t i = 0; i < together; ++i) {
                    for (std::size_t p = 0; p < packs; ++p) {
                        store(to + (n + parity + 2 * i) * block + p * I::lanes, sums[i][p]);
                    }
                }
            }
        }
        return all;
    }
};

// Table for previews: +-2 J_{n+1}(v) / v at v = shrunk * 40 sinh(k/18). shrunk: radius of a disk, divided by that of the aperture.
struct LookTable {
    static constexpr std::size_t block = PolarTable::block;

    double shrunk;
    std::size_t blocks, degrees;
    Doubles values;
    std::vector<std::size_t> reached;

    LookTable(double part, std::size_t block_count, std::size_t degree_count)
        : shrunk(part), blocks(block_count), degrees((degree_count + 31) / 32 * 32), values(blocks * degrees * block),
          reached(blocks) {
        std::vector<double> one, scratch;
        for (std::size_t i = 0; i < blocks * block; ++i) {
            look();
            const double v = shrunk * at(i);
            // Compute only the degrees that are not negligible at this v. How many these are depends only on v, so that images do
            // not depend on the contents of the cache.
            const std::size_t count = static_cast<std::size_t>(v + 6.0 * std::cbrt(v) + 15.0) / 2;
            one.resize(count);
            for (std::size_t parity = 0; parity < 2; ++parity) {
                zernike_transforms(parity, v, count, one.data(), scratch);
                for (std::size_t k = 0; k < std::min(count, degrees / 2); ++k) {
                    values[((i / block) * degrees + 2 * k + parity) * block + i % block] = one[k];
                }
            }
            reached[i / block] = std::min(degrees, 2 * count);
        }
    }

    static double at(std::size_t i) { return 40.0 * std::sinh(static_cast<double>(i) / 18.0); }
    // Number of blocks up to the first with a radius of at least v.
    static std::size_t blocks_to(double v) { return static_cast<std::size_t>(18.0 * std::asinh(v / 40.0) + 1.0) / block + 1; }

    bool is(double part, std::size_t block_count, std::size_t degree_count) const {
        return shrunk == part && blocks >= block_count && degrees >= degree_count;
    }
    std::size_t bytes() const { return sizeof(double) * values.size(); }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;
};

}  // namespace lommel
